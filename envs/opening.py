"""The opening of an episode: what is asked and by which reading it is judged, and how the world is to begin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.random import Generator

from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.balance import mix
from decomplex_bt.envs.chance import Draw, Start, without_chance
from decomplex_bt.envs.judge import Judge
from decomplex_bt.envs.options import Options, Request, apply_options
from decomplex_bt.envs.setting import Setting, draw_request
from decomplex_bt.envs.stream import Stream
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.envs.balance import Test
    from decomplex_bt.envs.randomness import Generators

INSTRUCTION_TRIES = 10_000
"""Corpus examples drawn before none is found that can be asked for in a house; those that do not suit it are known from
then on. In a small house of two rooms one draw in four hundred does, so that one reset in some 10^11 finds none."""


def judge_for(request: Request, domain: Domain) -> Judge:
    """The judge of a request, by its gold reading or else by ours. Raises `InputError` where it suits no such house."""
    if request.gold is not None:
        return Judge(request.gold, domain, judged_by="gold")
    from decomplex_bt.understanding.interpreter import Interpreter

    # The words are those of the domain's folder, whatever house is in it.
    reading = Interpreter.load(domain.folder).interpret(request.text)
    return Judge(reading, domain, judged_by="interpreted")


def refusal(request: Request, domain: Domain) -> InputError | None:
    """Why a request does not suit a house; None where it does."""
    try:
        judge_for(request, domain)
    except InputError as error:
        return error
    return None


def draw_asked(base: Domain, setting: Setting, rng: Generator) -> tuple[Request, Judge]:
    """A request from the corpus of `base` that suits the house of `setting`, with its judge. Raises `InputError`."""
    for _ in range(INSTRUCTION_TRIES):
        request = draw_request(base, rng)
        if request in setting.misfits:
            continue
        try:
            return request, judge_for(request, setting.domain)
        except InputError:
            setting.misfits.add(request)  # most corpora ask for more than one house has
    raise InputError(f"none of {INSTRUCTION_TRIES:,} corpus examples drawn suits this house; give an instruction")


def draw_start(
    setting: Setting, options: Options, tests: tuple[Test, ...], balance: float, generators: Generators
) -> Start:
    """How the world begins: drawn, mixed towards the tests, and as the options want it."""
    draw = Draw(setting.prior, setting.spots)
    chance = Stream(generators.base)
    if options.chance:
        draw.everything(chance)
        balance = balance if options.balance is None else options.balance
        mix(draw, tests, balance, generators.mixing(tests))
    else:
        draw.likeliest()
    apply_options(options, draw, generators.changing if options.chance else without_chance())
    draw.robot(chance if options.chance else None)
    return draw.start
