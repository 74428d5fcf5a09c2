"""The judge's place in an environment: from an instruction to a monitor of one episode, and to what its flow tests."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from decomplex_bt.envs.balance import Test
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Instruction

if TYPE_CHECKING:
    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.envs.bindings import Bindings
    from decomplex_bt.envs.monitor import Monitor
    from decomplex_bt.envs.recall import Recall
    from decomplex_bt.envs.sensing import Sensor
    from decomplex_bt.envs.verdict import Verdict
    from decomplex_bt.envs.world import Event, World
    from decomplex_bt.planning.ground_task import GroundTask


class Judge:
    """Judges the episodes of one instruction, by one reading of it: the gold one or, where there is none, ours.

    Raises `InputError` (a `ValueError`) for a reading that holds no task or does not ground in the house.
    """

    def __init__(self, reading: Instruction, domain: Domain, *, judged_by: str) -> None:
        from decomplex_bt.envs.tested import tests_of
        from decomplex_bt.planning.distribution import distributed
        from decomplex_bt.planning.grounding import ground

        self.reading = distributed(reading)
        self.domain = domain
        self.judged_by = judged_by
        if not reading.tasks:
            raise InputError(f"{reading.text!r} asks for nothing that a robot of this household can do")
        self.grounded = ground(reading, domain)
        self.tests: tuple[Test, ...] = tests_of(self.grounded, domain)
        self._monitor: Monitor | None = None
        self._reported: Verdict | None = None
        self._report: dict[str, Any] = {}
        self._branches: list[dict[str, Any]] = []

    def begin(self, world: World, sensor: Sensor) -> Verdict:
        """Takes in the start of an episode, the first look included."""
        from decomplex_bt.envs.world_truth import WorldTruth

        self._reported = None
        self._monitor = monitor = self._recall.begin(WorldTruth(world, sensor))
        return monitor.verdict

    def update(self, event: Event | None) -> Verdict:
        """Takes in one control step; call it after the look that belongs to it."""
        assert self._monitor is not None
        return self._monitor.update(event)

    def finish(self) -> Verdict:
        """Takes in that the robot has finished, after the control step in which it said so."""
        assert self._monitor is not None
        return self._monitor.finish()

    @cached_property
    def _recall(self) -> Recall:
        from decomplex_bt.envs.recall import Recall

        return Recall(self.grounded, self.domain)

    @property
    def mentioned(self) -> tuple[str, ...]:
        """The things that the instruction may mean, in order of mention."""
        things = self.domain.house.things
        referents = (referent for task in self.grounded.tasks for referent in task.referents())
        return tuple(dict.fromkeys(name for referent in referents for name in referent.candidates if name in things))

    @property
    def settled(self) -> frozenset[str]:
        """The things that are meant by where they lie ("everything on the table")."""
        counted = (r for task in self.grounded.tasks if task.places for r in task.objects if r.is_all)
        return frozenset(name for referent in counted for name in referent.candidates)

    def allows(self, thing: str, place: str) -> bool:
        """Whether somebody else may put a thing to a place: the instruction stays possible, and means what it did."""
        assert self._monitor is not None
        return thing not in self.settled and self._monitor.can_lie(thing, place)

    def take_in(self, name: str) -> None:
        """Takes in that somebody else has moved a thing or opened a door."""
        assert self._monitor is not None
        self._monitor.take_in(name)

    def brace(self) -> None:
        """Takes in how things are before the robot does something; call it when they may have changed meanwhile."""
        assert self._monitor is not None
        self._monitor.brace()

    def note_deed(self) -> None:
        """Takes in how things are right after the robot's deed; call it where others go on in the same step."""
        assert self._monitor is not None
        self._monitor.note_deed()

    @property
    def minds_position(self) -> bool:
        """Whether the task due is done by being somewhere, so that every step counts, looked or not."""
        assert self._monitor is not None
        return self._monitor.minds_position

    def report(self, constant: Mapping[str, Any], others: Iterable[str]) -> dict[str, Any]:
        """The verdict so far, for an episode's info, beside what is constant in it: a fresh mapping of plain values.

        It has a place for the `others`, its last keys, which the caller fills in: a mapping that grows takes longer.
        """
        assert self._monitor is not None
        verdict = self._monitor.verdict
        if verdict is not self._reported:
            self._reported = verdict
            self._branches = [branch.to_json() for branch in verdict.branches]
            self._report = {
                **constant,
                "judged_by": self.judged_by,
                "is_success": verdict.is_success,
                "goal_conditions_met": verdict.met,
                "goal_conditions_total": verdict.total,
                "unsettled": verdict.unsettled or 0,  # one type for each key, or a vector cannot hold them
                **dict.fromkeys(("branches", "violations", *others)),
            }
        report = self._report.copy()
        report["branches"] = [branch.copy() for branch in self._branches] if self._branches else []
        report["violations"] = [violation.reason for violation in verdict.violations] if verdict.violations else []
        return report

    def carried_out(self) -> tuple[list[tuple[GroundTask, bool]], Bindings, dict[str, str]]:
        """As `Monitor.carried_out`."""
        assert self._monitor is not None
        return self._monitor.carried_out()

    def feasibility(self) -> dict[str, Any]:
        """Whether the instruction can be carried out in this world by one who knows everything, and if not, why."""
        assert self._monitor is not None
        cause = self._monitor.course.cause
        return {"feasible": cause is None, "infeasible_cause": None if cause is None else str(cause)}
