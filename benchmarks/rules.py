"""What the rules of English gain: every row leaves one kind out and scores annotated instructions.

    python benchmarks/rules.py PATH [--no-encoder] [--only KIND ...]

PATH: a file or folder of annotated instructions that no rule was made with (domains/household/corpus/outsiders).
Nothing is trained: the models are the shipped ones, which read beside all the rules. A row has the flows that are
right, and how many come out right only with the rules of that kind, and only without them, of flows and of flows with
all values; the last kind is all the others. Two minutes for each row and a thousand instructions.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.metrics import has_same_flow, is_same
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding import dependencies, interpreter, readings
from decomplex_bt.understanding.encoder import flows
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules import facts
from decomplex_bt.understanding.rules.speech.withdrawals import Withdrawals

Patches = Sequence[tuple[Any, str, Callable[..., Any]]]
"""Where a rule is looked up, its name, and what stands in for it and settles nothing."""


def _of_flow(name: str, given: int) -> Patches:
    """The argument at `given` as it is, for rules that both flow models apply."""
    return tuple((module, name, lambda *labels: tuple(labels[given])) for module in (dependencies, flows))


ROLES, SIDES, ORDERS = _of_flow("stated_roles", 1), _of_flow("stated_sides", 2), _of_flow("stated_orders", 3)
_PARTS = ("what is no task", "types of tasks", "tasks no model saw", "roles", "sides", "orders")
"""Kinds that others are made of."""
KINDS: dict[str, Patches] = {
    "what is no task": ((facts, "is_no_task", lambda *_: False),),
    "types of tasks": ((facts, "retyped", lambda observed, findings, task, *_: task),),
    "tasks no model saw": (
        (facts, "with_further", lambda observed, tasks, types: tuple(sorted(tasks, key=lambda task: task.token))),
    ),
    "all of tasks": ((readings, "corrected", lambda observed, tasks, types: tuple(tasks)),),
    "what is forbidden": ((readings, "forbidden", lambda observed: frozenset()),),
    "what is taken back": ((readings, "withdrawals_of", lambda observed: Withdrawals(frozenset(), ())),),
    "what is put otherwise": ((interpreter, "repaired", lambda document: frozenset()),),
    "what is told in full": ((interpreter, "retold", lambda observed, instruction: None),),
    "arguments": ((readings, "amended", lambda observed, types, withdrawals, found: found),),
    "values once all is known": ((Interpreter, "_settled", lambda self, document, tasks, flow: tuple(tasks)),),
    "roles": ROLES,
    "sides": SIDES,
    "orders": ORDERS,
    "all of the flow": (*ROLES, *SIDES, *ORDERS),
    "settling the flow": ((dependencies, "settle", lambda drawn, clauses: drawn),),
}


KINDS["all of these"] = tuple(patch for name in tuple(KINDS) if name not in _PARTS for patch in KINDS[name])


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("path", type=Path)
    options.add_argument("--no-encoder", action="store_true")
    options.add_argument("--only", nargs="+", choices=tuple(KINDS), default=list(KINDS), metavar="KIND")
    chosen = options.parse_args()
    domain = load_domain("household")
    wanted = [example.instruction for example in read_corpus(chosen.path, domain.ontology)]
    reader = Interpreter.load(domain, encoder=not chosen.no_encoder)
    whole = list(_judged(reader, wanted))
    print(f"{'left out':<26} {'flow exact':<28} flow +  -   with all values +  -")
    print(f"{'nothing':<26} {Proportion(sum(flow for flow, _ in whole), len(whole))}")
    for kind in chosen.only:
        with _without(KINDS[kind]):
            rest = list(_judged(reader, wanted))
        gains = [
            sum(with_it[i] and not left[i] for with_it, left in zip(one, other, strict=True))
            for i in range(2)
            for one, other in ((whole, rest), (rest, whole))
        ]
        print(f"{kind:<26} {Proportion(sum(flow for flow, _ in rest), len(rest))!s:<28}", *gains, flush=True)


def _judged(reader: Interpreter, wanted: Sequence[Instruction]) -> Iterator[tuple[bool, bool]]:
    """Of each instruction whether its flow is right, and whether all values are as well."""
    for found, gold in zip(reader.interpret_batch([gold.text for gold in wanted]), wanted, strict=True):
        yield has_same_flow(found, gold), is_same(found, gold)


@contextmanager
def _without(patches: Patches) -> Iterator[None]:
    with ExitStack() as stack:
        for where, name, idle in patches:
            stack.enter_context(patch.object(where, name, idle))
        yield


if __name__ == "__main__":
    main()
