"""The agents of an evaluation: policies that the environment offers by name, and those that one makes of it oneself."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any

from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Instruction
from decomplex_bt.planning.planner import Planner

AGENTS = ("tree", "oracle", "random", "idle")
"""The policies an environment offers; only "tree" understands text, the others are given the gold flow."""
READERS = ("tree", "oracle")
"""Those that go by a reading of the instruction."""
Maker = Callable[..., Any]
"""Makes, of an environment, a policy of one's own: `reset(observation, info)` and `act(observation)`, and `failures`,
`plans`, `replans` and `instruction`, what it goes by, where it has them, as a `TreeAgent` does.

One that takes a `flow`, by this name, is handed the reading of the instruction that the agent is to go by, unless it
has a default other than None, a flow of its own; one that takes a `planner` that of the evaluation. With several
processes it must be a function that can be pickled.
"""
Agents = Sequence[str | Maker] | Mapping[str, str | Maker]
"""Policies by what they are called themselves, or by the names that the rows are to have."""


def by_name(agents: Any) -> Mapping[str, Any]:
    """The agents by the names that the rows have. Raises `InputError`."""
    if isinstance(agents, Mapping):
        return agents
    if isinstance(agents, str) or not isinstance(agents, Iterable):
        raise InputError(f"agents is {agents!r}; expected a sequence of names, as in ({agents!r},)")
    named: dict[str, Any] = {}
    for agent in agents:
        name = name_of(agent)
        if name in named:
            raise InputError(
                f"the agent {name!r} is named twice; name each once, in a mapping if need be, as in {{'mine': ...}}"
            )
        named[name] = agent
    return named


def name_of(agent: Any) -> str:
    """What an agent is called itself."""
    return agent if isinstance(agent, str) else getattr(agent, "__name__", type(agent).__name__)


def check_agent(name: Any, agent: Any) -> None:
    """Raises `InputError` for what is no agent, or has a name that it may not have."""
    if not callable(agent) and agent not in AGENTS:
        raise InputError(
            f"there is no agent {agent!r}; known: {', '.join(AGENTS)}; or a function that makes one of an environment"
        )
    if not isinstance(name, str) or not name:
        raise InputError(f"an agent is named {name!r}; expected a text")
    if name != agent and (name in AGENTS or isinstance(agent, str)):
        raise InputError(
            f"{name!r} names an agent that is {agent!r}; the names {', '.join(AGENTS)} are those of the environment's "
            "own policies, which have no others; give yours another, as in {'mine': ...}"
        )


def is_given_flow(agent: str | Maker | None) -> bool:
    """Whether an agent is handed the reading that it is to go by: a maker that takes a `flow` and has none of its own,
    as in `lambda env, flow=mine: ...`, which binds one."""
    return callable(agent) and _is_open(_parameter(agent, "flow"))


def needs_flow(maker: Maker) -> bool:
    """Whether a maker can make nothing without a reading; one with `flow=None` makes what may read the text itself."""
    parameter = _parameter(maker, "flow")
    return parameter is not None and parameter.default is inspect.Parameter.empty


def make_policy(maker: Maker, env: Any, *, flow: Instruction | None, planner: Planner, is_chosen: bool) -> Any:
    """The policy that a maker makes, of what it takes.

    `flow`: None where there is no reading that it could be handed. `is_chosen`: somebody wants this very planner; else
    a maker that has one of its own keeps it.
    """
    handed: dict[str, Any] = {"flow": flow} if flow is not None and is_given_flow(maker) else {}
    parameter = _parameter(maker, "planner")
    if _is_open(parameter) or (is_chosen and parameter is not None):
        handed["planner"] = planner
    return maker(env, **handed)


def _parameter(maker: Maker, name: str) -> inspect.Parameter | None:
    """The parameter of this name that a maker takes besides the environment, if nobody has filled it in.

    A decorator takes what it says itself, whatever is said by the maker that it wraps; that is asked only where the
    decorator takes anything by name, and so may pass it on.
    """
    if isinstance(maker, partial) and name in maker.keywords:
        return None
    try:
        own, wrapped = (
            list(inspect.signature(maker, follow_wrapped=follow).parameters.values()) for follow in (False, True)
        )
    except (TypeError, ValueError):  # some that are written in C do not tell
        return None
    passes_on = any(p.kind is inspect.Parameter.VAR_KEYWORD for p in own)
    taken = [*own[1:], *(wrapped[1:] if passes_on else ())]
    return next((p for p in taken if p.name == name and p.kind in _BY_NAME), None)


def _is_open(parameter: inspect.Parameter | None) -> bool:
    """Whether there is such a parameter and its maker has nothing of its own for it."""
    return parameter is not None and (parameter.default is None or parameter.default is inspect.Parameter.empty)


_BY_NAME = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
"""Kinds of parameters that can be filled in by their names."""
