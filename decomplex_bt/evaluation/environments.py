"""The environment of an episode, by the Gymnasium id that the setup names: every episode has one of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import closing
from typing import Any

import gymnasium as gym

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import DecomplexError, InputError
from decomplex_bt.evaluation.setup import HOUSEHOLD, Setup
from decomplex_bt.instruction import Instruction


def make_env(setup: Setup) -> gym.Env[Any, Any]:
    """An environment for one episode: those that run at once, as in threads, must not meet in one.

    Raises `InputError` where none can be made by this id, naming it.
    """
    try:
        return gym.make(setup.env_id, domain=setup.domain)
    except DecomplexError:
        raise
    except Exception as error:  # whatever the import and the making of somebody's environment may raise
        why = " ".join(str(error).split()) or type(error).__name__
        raise InputError(
            f"env_id is {setup.env_id!r}, by which no environment can be made: {why}; expected an id like "
            f"{HOUSEHOLD!r}; one that a module of yours registers is written 'module:id', so that every process "
            "finds it"
        ) from error


def domain_in(env: gym.Env[Any, Any], setup: Setup) -> Domain:
    """The domain with the house of the episode, which need not be its own; as it is read where the environment does not
    tell."""
    told: Domain = env.get_wrapper_attr("domain") if env.has_wrapper_attr("domain") else load_domain(setup.domain)
    return told


def offered(env: gym.Env[Any, Any], setup: Setup) -> Callable[..., Any]:
    """What makes the environment's own policies, by name. Raises `InputError` where it offers none."""
    try:
        policy: Callable[..., Any] = env.get_wrapper_attr("policy")
    except AttributeError:
        raise InputError(
            f"env_id is {setup.env_id!r}, whose environment offers no policies; expected one with a method "
            f"`policy(name, ...)`, like {HOUSEHOLD!r}, or agents that are functions"
        ) from None
    return policy


def check_env(setup: Setup, agents: Mapping[str, Instruction]) -> None:
    """Raises `InputError` where the setup's environment cannot be made, or does not offer these agents of its own:
    before the first episode, or it would be all of them that fail. `agents`: each with an instruction to go by."""
    with closing(make_env(setup)) as env:
        for agent, instruction in agents.items():
            policy = offered(env, setup)
            try:
                policy(agent, flow=instruction, planner=None, seed=0)
            except InputError as error:
                raise InputError(f"env_id is {setup.env_id!r}, whose agent {agent!r} cannot be had: {error}") from None
