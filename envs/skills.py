"""The skills of the household robot: one for every PDDL action, in closed loop on observations alone.

A skill is written as a script (`approach`): a generator of actions. To add one: write the script, name it in `SKILLS`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from decomplex_bt.behaviour.embodiment import Skill, SkillStatus, SkillTick
from decomplex_bt.domain.contract import check_parameters
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.pddl import pddl_actions
from decomplex_bt.envs.approach import Script, SkillError, move, pass_doorway
from decomplex_bt.envs.embodiment import Action, HouseholdEmbodiment
from decomplex_bt.envs.following import follow, tag_along
from decomplex_bt.envs.handling import at_place, close_up, give, pick, place, receive, say, set_running, stow, unstow
from decomplex_bt.envs.interface import Interaction
from decomplex_bt.envs.looking import inspect, sense, sense_carried, sense_given, sense_place
from decomplex_bt.errors import DataFileError
from decomplex_bt.planning.pddl import GroundAction


class ScriptSkill:
    """A skill that follows a script. Implements `decomplex_bt.behaviour.embodiment.Skill`."""

    def __init__(self, body: HouseholdEmbodiment, script: Script) -> None:
        self._body = body
        self._script = script

    def tick(self, observation: Any) -> SkillTick:
        self._body.sense(observation)
        try:
            return SkillTick(SkillStatus.RUNNING, next(self._script))
        except StopIteration:
            return SkillTick(SkillStatus.SUCCESS, self._body.rest())
        except SkillError as error:
            return SkillTick(SkillStatus.FAILURE, self._body.rest(), str(error))

    def stop(self) -> Action:
        self._script.close()
        return self._body.rest()


def make_skill(body: HouseholdEmbodiment, step: GroundAction) -> Skill:
    """The skill for a plan step. Raises `KeyError` for an action that has none."""
    return ScriptSkill(body, SKILLS[step.name](body, *step.objects))


SKILLS: dict[str, Callable[..., Script]] = {
    "move": move,
    "pass": pass_doorway,
    "open-up": at_place(Interaction.OPEN, 0),
    "close-up": close_up,
    "pick": pick,
    "place": place,
    "stow": stow,
    "unstow": unstow,
    "receive": receive,
    "give": give,
    "switch-on": at_place(Interaction.SWITCH_ON, 0),
    "switch-off": at_place(Interaction.SWITCH_OFF, 0),
    "heat": set_running,
    "wash": set_running,
    "chill": at_place(Interaction.CLOSE, 1),
    "rinse": at_place(Interaction.CLEAN, 1),
    "fill": at_place(Interaction.FILL, 1),
    "drain": at_place(Interaction.EMPTY, 1),
    "drain-place": at_place(Interaction.EMPTY, 0),
    "wipe": at_place(Interaction.CLEAN, 0),
    "inspect": inspect,
    "sense": sense,
    "sense-held": sense_carried,
    "sense-given": sense_given,
    "sense-place": sense_place,
    "say": say,
    "follow": follow,
    "tag-along": tag_along,
}
"""By the name of the PDDL action; called with the body and the action's objects in order (`domain/contract.py`)."""


def check_skills(domain: Domain) -> None:
    """Raises `DataFileError` where an action of the domain has no skill, or other parameters than its skill takes."""
    if unknown := [name for name in pddl_actions(domain.domain_pddl) if name not in SKILLS]:
        problem = f"action {unknown[0]}: the robot has no skill for it; it has {', '.join(SKILLS)}"
        raise DataFileError(domain.folder / "domain.pddl", problem)
    try:
        check_parameters(domain.domain_pddl)
    except ValueError as error:
        raise DataFileError(domain.folder / "domain.pddl", str(error)) from None
