"""Conditions: the case of somebody or something named, or one that more than an "if" opens, is a check, be none of its
words a task by itself ("if *the sun's gone*, ...", "when *Tom's taken the bins out*, ...", "in the event that ...")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.certain_cases import CertainCase, certain_cases

_OPENING = frozenset(("if", "unless", "when"))
_JOINING = frozenset(("and", "but", "or", "so", "only"))
_BE_OR_HAVE = frozenset("is are 's \u2019s 're \u2019re has have was were had".split())
_WAITING = frozenset(("as", "once", "after"))
_HAVE = frozenset("has have had 's \u2019s".split())
_LEFT = frozenset("gone left come arrived returned".split())
_PERSONS = frozenset("he she they we somebody someone anybody anyone nobody".split())
_UNNAMED = frozenset("you i it that this u".split())
_TRIED = frozenset("attempt try search sign".split())
"""What is told of the order before: "if the second attempt is unsuccessful", "if there's no sign of them"."""
_OF_TASKS = frozenset("fail succeed manage".split())
"""What tells how a task went: "in the case that this fails"."""
_LONGEST = 6
"""The most words of a subject."""


def untold(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The "is" or "has" of every case that begins a clause, has a noun, a person or "there" for its subject, and none
    of whose words up to its mark is among the `tasks`, which are tokens with types; not of what somebody is told. Of
    `certain_cases` any verb, wherever they stand."""
    tokens = document.tokens
    certain = frozenset(case.verb for case in certain_cases(document) if _is_untold(document, case, tasks))
    return (
        certain
        | frozenset(_departures(document, tasks))
        | frozenset(
            be
            for i, token in enumerate(tokens)
            if token.lower in _OPENING
            and (i == 0 or tokens[i - 1].text in MARKS or tokens[i - 1].lower in _JOINING)
            and (stop := next((j for j in range(i + 1, len(tokens)) if tokens[j].text in MARKS), len(tokens))) > i + 2
            and tasks.keys().isdisjoint(range(i, stop))
            and (be := _be(document, range(i + 1, stop))) is not None
            and not _is_told(document, tasks, i)
        )
    )


def _departures(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "has" of every clause that waits for somebody to have gone, behind or ahead of what is ordered: "close it as
    soon as *she's* gone to bed"."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower not in _WAITING or (token.lower == "as" and tokens[max(0, i - 1)].lower != "soon"):
            continue
        stop = next(
            (j for j in range(i + 1, len(tokens)) if tokens[j].lower in MARKS | _JOINING | {"then"}), len(tokens)
        )
        be = _be(document, range(i + 1, stop))
        is_gone = be is not None and tokens[be].lower in _HAVE and tokens[be + 1].lower in _LEFT
        if be is not None and is_gone and tasks.keys().isdisjoint(range(i, stop)) and not _is_told(document, tasks, i):
            yield be


def without_cases(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments but for those that tasks ahead of such a case have in it: "inform Tom *in the event that* ..." has
    no message."""
    checks = {i for i, kind in tasks.items() if kind == "check_state"}
    cases = [case for case in certain_cases(document) if not checks.isdisjoint(case.words)]
    return [
        a
        for a in arguments
        if not any(a.owner < case.words.start <= a.tokens.stop - 1 <= case.words[-1] for case in cases)
    ]


def _is_untold(document: Document, case: CertainCase, tasks: Mapping[int, str]) -> bool:
    """Whether no word up to the verb of a case is a task, and no check further on; not of how a task went."""
    if document.tokens[case.verb].lemma in _OF_TASKS:
        return False
    is_told = any(i in tasks for i in range(case.words.start, case.verb + 1))
    return not is_told and all(tasks.get(i) != "check_state" for i in case.words)


def _be(document: Document, clause: range) -> int | None:
    """The "is" or "has" behind the subject of a clause, where something is said behind it."""
    tokens = document.tokens
    subject = range(clause.start, min(clause.stop - 1, clause.start + _LONGEST))
    be = next((i for i in subject if i > clause.start and tokens[i].lower in _BE_OR_HAVE), None)
    if be is None or tokens[clause.start].lower in _UNNAMED:
        return None
    if tokens[clause.start].lower == "there":
        named = tokens[be + 1 : clause.stop]
        is_named = be == clause.start + 1 and all(t.tag != "TO" for t in named)  # "if there's nothing to sort out"
    else:
        named = tokens[clause.start : be]
        is_named = any(t.pos in ("NOUN", "PROPN") for t in named) or named[0].lower in _PERSONS
    return be if is_named and _TRIED.isdisjoint(t.lemma for t in named) else None


def _is_told(document: Document, tasks: Mapping[int, str], opener: int) -> bool:
    """Whether the case is in the message of the order right before: "tell Ann, if the bus is late, to wait"."""
    before = max((i for i in tasks if i < opener), default=None)
    is_same = before is not None and document.sentences[before] == document.sentences[opener]
    return is_same and before is not None and tasks[before] == "informing"
