"""The type of a task as its words settle it: "set the tray *down*" is placing, "*meet* me" is searching."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from decomplex_bt.understanding.document import Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import degree_asked
from decomplex_bt.understanding.rules.cases.leftovers import asks_got
from decomplex_bt.understanding.rules.cases.perfects import (
    are_gone,
    is_asked_done,
    is_denied_of_others,
    is_done_by_others,
    told_by,
)
from decomplex_bt.understanding.rules.cases.preferences import is_wished
from decomplex_bt.understanding.rules.findings import HANDLING, Findings
from decomplex_bt.understanding.rules.orders.assurances import is_assured, is_assured_too
from decomplex_bt.understanding.rules.orders.calls import is_sent_for
from decomplex_bt.understanding.rules.orders.deeds import forms
from decomplex_bt.understanding.rules.orders.doors import admitted, is_answered
from decomplex_bt.understanding.rules.orders.handing import payee
from decomplex_bt.understanding.rules.orders.idioms import encountered, for_somebody, is_heard, is_light, prospect_of
from decomplex_bt.understanding.rules.orders.loading import is_stuffed, loading
from decomplex_bt.understanding.rules.orders.puttings import LAYING, is_put_on, is_put_somewhere, is_the_table
from decomplex_bt.understanding.rules.orders.resuming import resumed
from decomplex_bt.understanding.tasks import FoundTask

_CARRYING = HANDLING - {"change_state"}
_NEAR_DOWN = 4
"""Within so many words behind "set" stands the "down" by which something is put down [tokens]."""
_TIDYING = frozenset(("clear", "tidy", "clean", "wash"))
_DRAWING = frozenset("drop lower raise pull let draw".split())
_COVERINGS = frozenset("blind shade shutter curtain drape".split())


def retyped(
    observed: Observed,
    findings: Findings,
    task: FoundTask,
    found: Sequence[FoundTask],
    following: FoundTask | None,
    types: Collection[str],
) -> FoundTask:
    """A task with the type, and at the word, that the words around it settle.

    `found`: the tasks kept ahead of it, in text order; `following`: the next one; `types`: those that there are.
    """
    document = observed.document
    before = found[-1] if found else None
    end = len(document) if following is None else following.token
    if (question := findings.questions.get(task.token)) is not None:
        is_of_somebody = document.tokens[question.tokens.start].lower == "who"
        is_told = not is_of_somebody and (question.place or question.state) and task.type != "searching"
        task = replace(task, type="check_state" if is_told else "searching")
    is_check = task.type == "check_state"
    is_too = is_check and before is not None and is_assured_too(document, task.token, before.token)
    fact = "change_state" if is_too else _settled_type(observed, task, end)
    token = told_by(document, task.token) if is_check else task.token
    if fact in types and token < end and (before is None or before.token < token):
        task = replace(task, type=fact, token=token)
    lemma = document.tokens[task.token].lemma
    if task.type in HANDLING and (task.token in findings.looks or task.token in findings.shouts):
        task = replace(task, type="searching" if task.token in findings.looks else "informing")
    if task.type == "motion" and lemma == "use" and any(one.type == "placing" for one in found):
        task = replace(task, type="placing")
    if task.type == "informing" and lemma == "feed":
        task = replace(task, type="change_state")
    going_on = resumed(observed, task.token) if task.type != "check_state" else None
    if going_on is not None and going_on[0] <= end:
        task = replace(task, token=going_on[0], type=going_on[1])
    if asks_got(document, task.token) or task.token in findings.deeds:
        task = replace(task, type="check_state")
    if (be := prospect_of(document, task.token)) is not None:
        task = replace(task, token=be, type="check_state")
    if following is not None and is_light(document, task.token, following.token):
        task = replace(task, type=following.type)
    return task


def _settled_type(observed: Observed, task: FoundTask, following: int) -> str:
    """The type that a task has by the words up to the `following` one; its own where they settle nothing."""
    document = observed.document
    said = document.tokens[task.token + 1 : following]
    lemma = document.tokens[task.token].lemma
    if task.type != "check_state" and is_done_by_others(document, task.token):
        return "check_state"
    if task.type in HANDLING and lemma in _DRAWING and _is_covering(said):
        return "change_state"
    if task.type in _CARRYING and observed.gazetteer.ending_type(document, task.token) == "placing":
        return "placing"
    if task.type == "change_state" and lemma == "put":
        return "placing" if is_put_somewhere(said) else task.type
    if task.type == "placing" and (
        is_put_on(observed, said)
        if lemma == "put"
        else not LAYING.isdisjoint(forms(document, task.token)) and is_the_table(said)
    ):
        return "change_state"
    if task.type == "change_state" and lemma == "set" and any(t.lower == "down" for t in said[:_NEAR_DOWN]):
        return "placing"
    if task.type in ("searching", "informing") and is_heard(document, task.token):
        return "check_state"
    if task.type in HANDLING | {"change_state"} and is_sent_for(document, task.token):
        return "informing"
    if task.type in ("following", "informing") and lemma == "meet":
        return "searching"
    if task.type != "check_state" and payee(document, task.token):
        return "bringing"
    if task.type == "taking" and for_somebody(document, task.token):
        return "bringing"
    if task.type in HANDLING and loading(observed, task.token) is not None:
        return "placing"
    if task.type == "placing" and is_stuffed(observed, task.token):
        return "change_state"
    if task.type == "searching" and degree_asked(document, task.token):
        return "check_state"
    if task.type == "check_state" and is_assured(document, task.token):
        return "change_state"
    if task.type in HANDLING and (is_asked_done(document, task.token) or is_denied_of_others(document, task.token)):
        return "check_state"
    if task.type == "motion" and lemma in _TIDYING and observed.gazetteer.particle(document, task.token) == "up":
        return "change_state"  # "hoover the stairs and clear up"
    if task.type == "bringing" and is_wished(document, task.token):
        return "check_state"
    if task.type == "motion" and are_gone(document, task.token):
        return "check_state"
    if task.type != "check_state" and admitted(document, task.token):
        return "placing"
    if task.type != "check_state" and is_answered(document, task.token):
        return "change_state"
    if task.type == "informing" and lemma == "enter":
        return "motion"  # "only enter if Tom says so"
    if task.type == "motion" and encountered(document, task.token):
        return "searching"
    return task.type


def _is_covering(said: Sequence[Token]) -> bool:
    """Whether the first thing named is what covers a window, and no place for it: "drop *the blinds*"."""
    noun = next((i for i, token in enumerate(said) if token.pos in ("NOUN", "PROPN")), len(said))
    behind = said[noun + 1].lower if noun + 1 < len(said) else ""
    return noun < len(said) and said[noun].lemma in _COVERINGS and behind not in ("on", "onto", "into", "off")
