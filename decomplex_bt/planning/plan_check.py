"""The check of what a planner gives, before a robot goes by it: planners are anybody's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.pddl import Types, pddl_types
from decomplex_bt.errors import quoted
from decomplex_bt.planning.pddl import GroundAction
from decomplex_bt.planning.planner import PlanResult, PlanStatus
from decomplex_bt.planning.problem import Problem
from decomplex_bt.planning.schemas import read_schemas


def checked(result: Any, problem: Problem, domain: Domain) -> PlanResult:
    """What a planner gave for the problem, its plan a tuple of steps; UNSUPPORTED, with the reason, where it gave
    something else, or a plan that has a step no robot in this house could carry out.

    Whether the plan leads to the goal is seen when it is carried out, but for one without a step.
    """
    if not isinstance(result, PlanResult):
        return _refused(f"the planner gave {quoted(result)}, no PlanResult")
    if not isinstance(result.status, PlanStatus):
        return _refused(f"the status is {quoted(result.status)}; expected a PlanStatus, as {PlanStatus.SOLVED}")
    if not result.is_solved:
        return replace(result, steps=())
    if isinstance(result.steps, str) or not isinstance(result.steps, Iterable):
        return _refused(f"the steps are {quoted(result.steps)}; expected GroundActions, in their order")
    types, steps = dict(problem.objects), []
    for given in result.steps:  # once: what makes them as they are asked for has them no second time
        step = _read(given)
        if step is None:
            return _refused(f"a step is {quoted(given)}; expected a GroundAction of a name and the names of objects")
        if (fault := _fault_of(step, types, problem, domain)) is not None:
            return _refused(f"{step} {fault}")
        steps.append(step)
    if not steps and not set(problem.goal) <= set(problem.init):
        return _refused(f"the plan has no steps, and {' '.join(map(str, problem.goal))} does not hold yet")
    return replace(result, steps=tuple(steps))


def _refused(reason: str) -> PlanResult:
    return PlanResult(PlanStatus.UNSUPPORTED, reason=reason)


def _read(step: Any) -> GroundAction | None:
    """The step, its objects a tuple, so that it can be remembered; None where it is none."""
    if not isinstance(step, GroundAction) or not isinstance(step.name, str):
        return None
    if not isinstance(step.objects, list | tuple) or not all(isinstance(name, str) for name in step.objects):
        return None
    return GroundAction(step.name, tuple(step.objects))


def _fault_of(step: GroundAction, types: Mapping[str, str], problem: Problem, domain: Domain) -> str | None:
    """Why a step cannot be one of this problem's plan, nor of another one's in this house; None where it can. `types`:
    those of the problem's objects."""
    schemas = read_schemas(problem.domain_pddl)
    if step.name not in schemas:
        return f"is no action of this domain; one is {min(schemas)!r}"
    wanted = schemas[step.name].types
    if len(step.objects) != len(wanted):
        return f"has {len(step.objects)} objects; {step.name} takes {len(wanted)}"
    for name, of in zip(step.objects, wanted, strict=True):
        if (fault := _fault_of_object(name, of, types, problem, domain)) is not None:
            return fault
    return "must not be in the plan: it is one of problem.forbidden" if step in problem.forbidden else None


def _fault_of_object(name: str, of: str, types: Mapping[str, str], problem: Problem, domain: Domain) -> str | None:
    special = types.get(name) or _type_in_house(name, domain)
    if special is None:
        return None if name in problem.names else f"is about {name!r}, which is no object of this problem"
    is_fitting = _types_of(problem.domain_pddl).is_a(special, of)
    return None if is_fitting else f"has {name!r}, of the type {special!r}, in place of a {of!r}"


def _type_in_house(name: str, domain: Domain) -> str | None:
    try:
        return domain.pddl_type(name)
    except KeyError:
        return None


@lru_cache(maxsize=8)
def _types_of(domain_pddl: str) -> Types:
    return pddl_types(domain_pddl)
