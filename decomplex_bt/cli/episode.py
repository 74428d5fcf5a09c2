"""One episode of `run`: the Gymnasium loop, with everything that is worth telling of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from decomplex_bt.behaviour.conditional import IfThenElse
from decomplex_bt.behaviour.planned_task import PlannedTask
from decomplex_bt.planning.distribution import distributed

if TYPE_CHECKING:
    from decomplex_bt.behaviour.agent import TreeAgent
    from decomplex_bt.cli.reading import Reading

Outcome = Literal["success", "failure", "infeasible"]
TRACE_KEYS = ("tick", "sim_seconds", "node", "status", "feedback", "event")


@dataclass(frozen=True)
class Moment:
    """What changed in one tick: entries of the trace, and conditions judged by then for the first time."""

    seconds: float
    entries: tuple[dict[str, Any], ...]
    judged: tuple[IfThenElse, ...]
    is_last: bool


class Episode:
    """An instruction carried out by the agent in `env` with this seed.

    The judge goes by the agent's own reading, since nobody else has read the text. `play` runs it; then `outcome`,
    `info`, `steps` and `to_json` tell how it went. Raises `InputError` where the instruction cannot be used.
    """

    def __init__(self, env: Any, reading: Reading, seed: int, *, has_pictures: bool = False) -> None:
        from decomplex_bt.behaviour.agent import TreeAgent

        self.reading, self.seed, self._has_pictures = reading, seed, has_pictures
        self._env = env
        instruction = reading.instruction
        options = {"instruction": instruction.text, "gold": instruction}
        self._observation, self.info = env.reset(seed=seed, options=options)
        self._was_met = bool(self.info["is_success"])
        self.agent: TreeAgent = TreeAgent(env, flow=instruction)
        self.agent.reset(self._observation, self.info)
        self._trace = self.agent.record()
        self._nodes = {"/".join(map(str, path)): node for path, node in self.agent.compiled.nodes.items()}
        self.steps = 0
        self.is_over = False
        self._is_out_of_time = False

    def play(self) -> Iterator[Moment]:
        """Runs the episode, one step each time a moment is asked for."""
        told: set[int] = set()
        while True:
            seen = len(self._trace.entries)
            action = self.agent.act(self._observation)
            if self._has_pictures:
                self._show_what_is_done()
            self._observation, _, terminated, truncated, self.info = self._env.step(action)
            self.steps += 1
            self._is_out_of_time = truncated and not terminated
            self.is_over = terminated or truncated or self.agent.done
            if terminated and not self.agent.done:
                self.agent.act(self._observation)  # the judge was first; the tree takes in what its last step did
            judged = tuple(node for node in self._conditions() if id(node) not in told)
            told.update(map(id, judged))
            yield Moment(self.info["seconds"], tuple(self._trace.entries[seen:]), judged, self.is_over)
            if self.is_over:
                return

    @property
    def outcome(self) -> Outcome:
        """How it ended: by the judge, and infeasible only where nobody could have succeeded."""
        if self.info["is_success"]:
            return "success"
        return "infeasible" if self.info.get("feasible") is False else "failure"

    @property
    def verdict(self) -> str:
        """The outcome in a sentence."""
        basis = "judged by the robot's own reading of the text"
        spent = f"{self.info['seconds']:.1f} s, {self.steps} steps"
        if self.outcome == "infeasible":
            return f"infeasible in this world: {self.info['infeasible_cause']} ({spent}; {basis})"
        if self.outcome == "success":
            return f"success{': nothing was left to do from the first' if self._was_met else ''} ({spent}; {basis})"
        reasons = [*self.info.get("violations", ()), *map(str, self.agent.failures)]
        return f"failure: {'; '.join(reasons) or self._end} ({spent}; {basis})"

    @property
    def _end(self) -> str:
        """How an episode ended in which nothing went wrong that the robot or the judge could name."""
        if self._is_out_of_time:
            return "time ran out"
        due = self.info["unsettled"]
        phrase = distributed(self.reading.instruction).phrase(due)
        return f"the robot was content, but task {due} ({phrase}) was not settled"

    @property
    def running(self) -> PlannedTask | None:
        """The leaf at work, None between tasks."""
        tip = self.agent.tree.tip()
        return tip if isinstance(tip, PlannedTask) else None

    def to_json(self) -> dict[str, Any]:
        """The one object that `run --json` prints."""
        return {
            "instruction": self.reading.instruction.text,
            "seed": self.seed,
            "flow": self.reading.instruction.flow.to_json(),
            "outcome": self.outcome,
            "judged_by": "interpreted",
            "branches": self.info.get("branches", []),
            "steps": self.steps,
            "sim_seconds": round(float(self.info["seconds"]), 3),
            "failures": [failure.to_json() for failure in self.agent.failures],
            "trace": [{key: entry[key] for key in TRACE_KEYS} for entry in self._trace.entries],
        }

    def leaf_at(self, node: str) -> PlannedTask | None:
        """The leaf that a trace names by its place in the flow; None for other nodes."""
        found = self._nodes.get(node)
        return found if isinstance(found, PlannedTask) else None

    def picture(self) -> Any:
        """The house as it is now, `(height, width, 3)` uint8, with the verdict once there is one."""
        house = self._env.unwrapped
        verdict = self.outcome if self.is_over else ""
        scene = house.camera.scene(house.world, instruction=self.reading.instruction.text, verdict=verdict)
        return house.camera.show(scene, "rgb_array")

    def findings(self, node: IfThenElse) -> str:
        """What was observed at a condition: where the things it is about are, and in which state, as believed now."""
        assert isinstance(node.condition, PlannedTask)
        task, session = node.condition.task, self.agent.session
        names = [name for referent in task.objects for name in session.bindings.get(referent, ())]
        facts = [fact for name in names if (fact := self._believed(name))]
        said = node.condition.feedback_message
        return "; ".join(facts if facts else [said] if said and said != "done" else [])

    def _believed(self, name: str) -> str:
        belief, domain = self.agent.session.belief, self.reading.domain
        states = [value for pair in domain.kind(name).states if (value := belief.state(name, pair)) is not None]
        place = belief.place_of(name) if name in domain.house.things or name in domain.house.people else None
        where = f" at {_words(place)}" if place else ""
        return f"{_words(name)}{where}{': ' + ', '.join(states) if states else ''}"

    def _conditions(self) -> Iterator[IfThenElse]:
        """The conditions that have been judged so far, and those that turned out undecidable."""
        for node in self.agent.compiled.nodes.values():
            if isinstance(node, IfThenElse) and (
                node.truth is not None or getattr(node.condition, "is_undecided", False)
            ):
                yield node

    def _show_what_is_done(self) -> None:
        """Captions for the pictures."""
        camera, leaf = self._env.unwrapped.camera, self.running
        if leaf is None:
            return
        bindings = self.agent.session.bindings
        camera.doing = f"{leaf.name} | {leaf.step}" if leaf.step is not None else leaf.name
        camera.pointed_out = tuple(name for referent in leaf.task.objects for name in bindings.get(referent, ()))
        camera.message = leaf.task.message or ""


def _words(name: str) -> str:
    return name.replace("_", " ")
