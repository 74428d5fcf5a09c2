"""Checks of several words as one task: "has *been* *put* away", "the tap*'s* on, isn't it?"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.rules.cases.perfects import is_denied_of_others, passive_participle, perfect_participle
from decomplex_bt.understanding.rules.speech.asides import tagged
from decomplex_bt.understanding.tasks import FoundTask


def as_one(document: Document, tasks: Sequence[FoundTask]) -> Sequence[FoundTask]:
    """The tasks, those next to each other that are one check ("has *been* *put* away", "*has* *put* it", "*did* *eat*
    it") as one."""
    kept = list(tasks)
    for task, following in pairwise(tasks):
        is_denied = following.token == task.token + 2 and is_denied_of_others(document, following.token)
        is_next = following.token == task.token + 1 and following.type == "check_state"
        if task.type == "check_state" and is_next and _is_over(document, task.token):
            kept.remove(following)
            continue
        is_did = following.token == task.token + 1 and document.tokens[task.token].lower in ("do", "does", "did")
        if task.type == "check_state" and (is_denied or (is_did and following.type == "check_state")):
            kept.remove(task)
        if task.type == "check_state" and following.token in (
            passive_participle(document, task.token),
            perfect_participle(document, task.token),
        ):
            kept[kept.index(following)] = replace(following, type="check_state")
            kept.remove(task)
    return kept


def at_statements(document: Document, tasks: Sequence[FoundTask]) -> Sequence[FoundTask]:
    """The tasks, those carried by a tag question without a comma by the "is" of its statement: "the tap*'s* on isn't
    it?"."""
    taken = {task.token for task in tasks}
    moved = {task.token: tagged(document, task.token) for task in tasks if task.type == "check_state"}
    return [
        task if (be := moved.get(task.token)) is None or taken & {*range(be, task.token)} else replace(task, token=be)
        for task in tasks
    ]


def _is_over(document: Document, at: int) -> bool:
    """Whether a verb says that what the next one does is over, or begun: "has it *finished* proving?"."""
    tokens = document.tokens
    is_told = tokens[at].lemma in ("finish", "stop", "start", "begin", "quit", "keep")
    return is_told and at + 1 < len(tokens) and tokens[at + 1].tag == "VBG"
