"""Copies: recombined instructions, drawn from those of a corpus."""

from __future__ import annotations

from collections.abc import Sequence

from numpy.random import Generator

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.recombination.conditions import condition_of, joined, rephrased, stands_alone
from decomplex_bt.understanding.recombination.steps import reordered
from decomplex_bt.understanding.recombination.stretches import Telling, composed

ROUNDS = 4
"""How often each instruction is told otherwise at most, and how often its condition is joined with another one."""
NEAR = 40
"""How far away in the corpus the instruction may stand that a condition is joined with: mostly of the same voice."""


def recombined(pairs: Sequence[tuple[Observed, Instruction]], rng: Generator) -> list[Instruction]:
    """Different copies of annotated instructions: their tasks told in another order, their conditions in other words.

    The flow of a copy is what its words say, not always that of the instruction: "unless" in place of "if" changes
    it. Values of arguments stay as they were.
    """
    conditions = [condition_of(*pair, source=k) for k, pair in enumerate(pairs)]
    movable = [k for k, condition in enumerate(conditions) if condition is not None and stands_alone(condition)]
    copies: dict[str, Instruction] = {}
    for k, (pair, condition) in enumerate(zip(pairs, conditions, strict=True)):
        alone = [*reordered(*pair, source=k), *(rephrased(condition) if condition is not None else ())]
        near = [m for m in movable if 0 < abs(m - k) <= NEAR] if k in movable else []
        for _ in range(ROUNDS):
            drawn = [_drawn(alone, rng)]
            if condition is not None and near:
                other = conditions[near[int(rng.integers(len(near)))]]
                drawn.append(_drawn(list(joined(condition, other)) if other is not None else [], rng))
            for telling in drawn:
                copy = composed(telling) if telling is not None else None
                if copy is not None:
                    copies[copy.text] = copy
    return list(copies.values())


def _drawn(tellings: Sequence[tuple[str, Telling]], rng: Generator) -> Telling | None:
    """One of the tellings, each kind as likely as the others."""
    kinds = sorted({kind for kind, _ in tellings})
    if not kinds:
        return None
    kind = kinds[int(rng.integers(len(kinds)))]
    of_kind = [telling for name, telling in tellings if name == kind]
    return of_kind[int(rng.integers(len(of_kind)))]
