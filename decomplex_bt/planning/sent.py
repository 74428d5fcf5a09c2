"""Places that somebody was sent to: where they are to see whether there is something ("go to the kitchen and check if
there's any milk")."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.flow import If, Node
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.planning.phrases import read_phrases

_THERE_IS = re.compile(r"\b(?:if|whether|that)\s+there(?:['\u2019]?s|['\u2019]re|\s+is|\s+are)\b", re.IGNORECASE)
_SENTENCE_END = re.compile(r"[.!?;]\s")
_WHERE = ("location", "source", "state")


def with_place_sent(instruction: Instruction, task: Task, domain: Domain) -> Task:
    """The task with the room to which the task right before it goes, where it asks whether there is something and says
    nothing of where or how that is."""
    before = next((t for t in instruction.tasks if t.id == task.id - 1), None)
    if task.type != "check_state" or task.argument(*_WHERE) is not None or before is None or before.type != "motion":
        return task
    goal, said = before.argument("goal"), [a.span.end for a in task.arguments if a.type == "object" and a.span]
    if goal is None or not said or (before.id, task.id) not in _neighbours(instruction.flow.nodes):
        return task
    asked = instruction.text[before.span.end : max(said)]
    is_asked = _THERE_IS.search(asked) is not None and _SENTENCE_END.search(asked) is None
    if not is_asked or not _is_room(goal.value, domain):
        return task
    return replace(task, arguments=(*task.arguments, Argument("location", f"in {_bare(goal.value)}")))


def _neighbours(nodes: Sequence[Node]) -> Iterator[tuple[int, int]]:
    """The numbers of every two tasks of which the second is always done right behind the first."""
    yield from ((one.task, other.task) for one, other in pairwise(nodes) if not isinstance(one, If))
    for node in nodes:
        if isinstance(node, If):
            yield from _neighbours(node.then)
            yield from _neighbours(node.orelse)


def _is_room(words: str, domain: Domain) -> bool:
    try:
        phrases = read_phrases(words, domain)
    except InputError:
        return False
    return all(p.entities and domain.house.rooms.keys() >= set(p.entities) for p in phrases)


def _bare(words: str) -> str:
    """A place without what leads it: "to", "over to", "into"."""
    return re.sub(r"^(?:(?:on|in|out|over|up|down|to|into|inside|back)\s+)+", "", words, flags=re.IGNORECASE)
