"""What every body and its skills must keep to, as tests: subclass `EmbodimentContract` in a test file of your own.

```python
class TestMyRobot(EmbodimentContract):
    def make(self):
        env = MyEnv()
        return env, env.embodiment()

    def steps(self, body):
        return [GroundAction("move", ("hallway_floor", "desk", "study"))]

    def pose(self, observation):
        return observation["robot"][:3]
```
"""

from __future__ import annotations

import gc
from collections.abc import Sequence
from typing import Any
from unittest import SkipTest

from decomplex_bt.behaviour.embodiment import Embodiment, SkillStatus, SkillTick
from decomplex_bt.domain.pddl import pddl_actions
from decomplex_bt.planning.pddl import GroundAction

MAX_TICKS = 1500
"""Control steps within which every skill has to end, well or not."""
STOPPED_AFTER = 3, 15
"""Control steps after which skills are stopped: while a body sets out, and when it has got up speed."""
WATCHED = 3
"""Control steps for which a body that is to be at rest is watched."""


class EmbodimentContract:
    """Tests that a body passes whatever it is. Methods to give: `make`, `steps` and `pose`."""

    STIRS = 1e-3
    """By how much the numbers of a pose may change while the body is at rest."""

    def make(self) -> tuple[Any, Embodiment]:
        """A fresh Gymnasium environment and a fresh body for it."""
        raise NotImplementedError

    def steps(self, body: Embodiment) -> list[GroundAction]:
        """Some steps to be tried right after a reset, of any outcome; together they should use every skill."""
        raise NotImplementedError

    def pose(self, observation: Any) -> Sequence[float] | None:
        """Where the body is by an observation, as numbers that stay the same while it is at rest; None: it cannot be
        told, and whether a stopped skill leaves the body at rest is not tested."""
        return None

    # -- the tests ----------------------------------------------------------------------------------------------------

    def test_there_is_a_skill_for_every_action_of_the_domain(self) -> None:
        _, body = self.make()
        names = pddl_actions(body.domain.domain_pddl)
        assert set(names) <= {step.name for step in self.steps(body)}, "steps() leaves actions out"
        for step in self.steps(body):
            body.skill(step)

    def test_an_unknown_action_is_a_key_error(self) -> None:
        _, body = self.make()
        try:
            body.skill(GroundAction("levitate", ("robot",)))
        except KeyError:
            return
        raise AssertionError("an action without a skill must raise KeyError")

    def test_every_skill_ends_and_sends_valid_actions_only(self) -> None:
        env, body = self.make()
        for step in self.steps(body):
            observation, _ = env.reset(seed=1)
            body.reset(observation)
            tick = _run(env, body, step, observation)
            assert tick.status is not SkillStatus.RUNNING, f"{step} did not end within {MAX_TICKS} ticks"
            assert (tick.status is SkillStatus.FAILURE) == bool(tick.reason), f"{step}: a failure has a reason"

    def test_a_stopped_skill_lets_go_at_once(self) -> None:
        env, body = self.make()
        for step in self.steps(body):
            observation, _ = env.reset(seed=1)
            body.reset(observation)
            skill = body.skill(step)
            for _ in range(5):
                tick = skill.tick(observation)
                if tick.status is not SkillStatus.RUNNING:
                    break
                observation, _, terminated, truncated, _ = env.step(tick.action)
                if terminated or truncated:
                    break
            action = skill.stop()
            assert env.action_space.contains(action)
            assert _is_equal(action, body.rest()), f"{step}: what ends a skill is rest"

    def test_a_stopped_skill_brings_the_body_to_rest_within_one_step(self) -> None:
        env, body = self.make()
        if self.pose(env.reset(seed=1)[0]) is None:
            raise SkipTest("pose() does not tell where the body is")
        has_moved = False
        for step in self.steps(body):
            for ticks in STOPPED_AFTER:
                observation, _ = env.reset(seed=1)
                body.reset(observation)
                skill, before, is_over = body.skill(step), observation, False
                for _ in range(ticks):
                    tick = skill.tick(observation)
                    if tick.status is not SkillStatus.RUNNING:
                        break
                    before = observation
                    observation, _, terminated, truncated, _ = env.step(tick.action)
                    if is_over := terminated or truncated:
                        break
                if is_over:
                    continue
                has_moved |= self._stirs(before, observation)
                at_rest, *_ = env.step(skill.stop())
                for _ in range(WATCHED):
                    later, *_ = env.step(body.rest())
                    assert not self._stirs(at_rest, later), f"{step}: stopped after {ticks} steps, the body rolls on"
        assert has_moved, "steps() has none that moves the body, or each episode is over before it does"

    def _stirs(self, before: Any, after: Any) -> bool:
        there, here = self.pose(before), self.pose(after)
        assert there is not None
        assert here is not None
        return any(abs(one - other) > self.STIRS for one, other in zip(there, here, strict=True))

    def test_perceiving_is_repeatable(self) -> None:
        env, body = self.make()
        observation, _ = env.reset(seed=2)
        body.reset(observation)
        assert body.perceive(observation) == body.perceive(observation)

    def test_rest_and_finish_are_actions(self) -> None:
        env, body = self.make()
        assert env.action_space.contains(body.rest())
        assert env.action_space.contains(body.finish())

    def test_the_body_holds_no_reference_to_the_world(self) -> None:
        env, body = self.make()
        observation, _ = env.reset(seed=3)
        body.reset(observation)
        world = {id(env), id(env.unwrapped)}
        assert not world & _reachable(body), "the environment can be reached from the body"


def _run(env: Any, body: Embodiment, step: GroundAction, observation: Any) -> SkillTick:
    skill = body.skill(step)
    for _ in range(MAX_TICKS):
        tick = skill.tick(observation)
        if tick.status is not SkillStatus.RUNNING:
            return tick
        assert env.action_space.contains(tick.action), f"{step}: {tick.action} is no action"
        observation, _, terminated, truncated, _ = env.step(tick.action)
        if terminated or truncated:
            return SkillTick(SkillStatus.FAILURE, tick.action, "the episode ended")
    return tick


def _is_equal(first: Any, second: Any) -> bool:
    if isinstance(first, dict):
        return first.keys() == second.keys() and all(_is_equal(first[key], second[key]) for key in first)
    return bool(getattr(first == second, "all", lambda: first == second)())


def _reachable(root: Any) -> set[int]:
    """The identities of all objects that can be reached from one, modules, classes and functions left out."""
    seen: set[int] = set()
    stack = [root]
    while stack:
        item = stack.pop()
        if id(item) in seen or isinstance(item, type) or type(item).__name__ in ("module", "function", "frame"):
            continue
        seen.add(id(item))
        stack.extend(gc.get_referents(item))
    return seen
