"""Recall: how the judge begins, remembered by what it asked of the true world.

An instruction asks about few things, so that many episodes begin alike for its judge, whatever else is in the house.
What it makes of a start depends on the answers to its questions alone, and the next question on the answers so far:
the questions are asked again, one by one, and where all of the answers are as they once were, the judge is as it was.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import Any

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.monitor import Monitor
from decomplex_bt.envs.truth import Truth
from decomplex_bt.planning.ground_task import GroundInstruction

MOST_STARTS = 512
"""Starts remembered at once, of one instruction."""
Question = tuple[str, tuple[str, ...]]
"""A method of `Truth` with what it is asked about; a property with nothing."""


@dataclass(slots=True)
class _Known:
    """What is known after some answers: the next question and what follows from each answer, or, at last, the judge."""

    question: Question | None = None
    following: dict[Hashable, _Known] = field(default_factory=dict)
    monitor: Monitor | None = None


class Recall:
    """The beginnings of one instruction's episodes in one house."""

    def __init__(self, instruction: GroundInstruction, domain: Domain) -> None:
        self.instruction, self.domain = instruction, domain
        self._first = _Known()
        self._count = 0

    def begin(self, truth: Truth) -> Monitor:
        """The judge of an episode, which has taken in the first look."""
        known = self._first
        while known.question is not None:
            method, about = known.question
            answer = getattr(truth, method)
            following = known.following.get(answer(*about) if about else answer)
            if following is None:
                break
            known = following
        if known.monitor is None:
            known = self._find_out(truth)
        assert known.monitor is not None
        return known.monitor.again(truth)

    def _find_out(self, truth: Truth) -> _Known:
        inquiry = _Inquiry(truth)
        monitor = Monitor(self.instruction, self.domain, inquiry)
        monitor.start()
        inquiry.end()
        if self._count == MOST_STARTS:
            self._first, self._count = _Known(), 0
        self._count += 1
        known = self._first
        for question, answer in inquiry.answers.items():
            known.question = question
            known = known.following.setdefault(answer, _Known())
        known.monitor = monitor
        inquiry.answers.clear()  # they are in the tree now
        return known


class _Inquiry:
    """The truth, with a note of all that is asked. Implements `Truth`, whose answers stay as they are meanwhile."""

    def __init__(self, truth: Truth) -> None:
        self._truth: Any = truth
        self.answers: dict[Question, Hashable] = {}

    def end(self) -> None:
        """Lets go of the truth, for what is remembered outlives it."""
        self._truth = None

    @property
    def room(self) -> str:
        return self._ask("room")

    def view(self, names: tuple[str, ...]) -> Hashable:
        return None  # only ever compared with a later one

    def is_near(self, name: str) -> bool:
        return self._ask("is_near", name)

    def place(self, name: str) -> str | None:
        return self._ask("place", name)

    def state(self, name: str, pair: str) -> str | None:
        return self._ask("state", name, pair)

    def is_broken(self, name: str) -> bool:
        return self._ask("is_broken", name)

    def is_seen(self, name: str) -> bool:
        return self._ask("is_seen", name)

    def is_inspected(self, place: str) -> bool:
        return self._ask("is_inspected", place)

    def _ask(self, method: str, *about: str) -> Any:
        question = method, about
        if question not in self.answers:
            answer = getattr(self._truth, method)
            self.answers[question] = answer(*about) if about else answer
        return self.answers[question]
