"""How far three annotators agree on instructions that no voice of the corpus wrote, and how far our readings do.

    python benchmarks/annotators.py [--no-encoder] [SET ...]

Each set of `corpus/three_annotations` has its author's annotation and two blind ones by others, who had the guideline
and the bare texts. Prints, for each set and for all: of pairs of annotators the share that have the same tasks and
flow, and the same values as well; of pairs of our reading and an annotator the same; and the share of our readings
that are as most annotators have it (two of three at least), where most agree. The three pairs of an instruction hang
together, so their interval is the one that as many draws as there are instructions leave open. Half a minute a set.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Sequence
from itertools import combinations

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.evaluation.metrics import has_same_flow, is_same
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.interpreter import Interpreter

FOLDER = "three_annotations"
OTHERS = ("second", "third")
Likeness = Callable[[Instruction, Instruction], bool]
ROWS: tuple[tuple[str, Likeness], ...] = (("flow", has_same_flow), ("and all values", is_same))


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--no-encoder", action="store_true")
    options.add_argument("sets", nargs="*")
    chosen = options.parse_args()
    domain = load_domain("household")
    interpreter = Interpreter.load(domain, encoder=not chosen.no_encoder)
    files = sorted((domain.folder / "corpus" / FOLDER).glob("*.yaml"))
    known = [file.stem for file in files if "." not in file.stem]
    if strange := [name for name in chosen.sets if name not in known]:
        options.error(f"no set {', '.join(strange)}; there are {', '.join(known)}")
    names = chosen.sets or known
    total: Counter[str] = Counter()
    for name in names:
        annotated = _annotations(domain, name)
        readings = list(interpreter.interpret_batch([found[0].text for found in annotated]))
        counts = _counts(readings, annotated)
        total.update(counts)
        _show(name, counts)
    if len(names) > 1:
        _show("all", total)


def _annotations(domain: Domain, name: str) -> list[list[Instruction]]:
    """The annotations of each instruction of a set, its author's first."""
    folder = domain.folder / "corpus" / FOLDER
    files = [folder / f"{name}.yaml", *(folder / f"{name}.{other}.yaml" for other in OTHERS)]
    first, *others = ({e.id: e.instruction for e in read_corpus(file, domain.ontology)} for file in files)
    return [[annotation, *(other[key] for other in others)] for key, annotation in first.items()]


def _counts(readings: Sequence[Instruction], annotated: Sequence[Sequence[Instruction]]) -> Counter[str]:
    """Of each row how many pairs there are and how many are alike, and of majorities, and how many readings are so."""
    counts: Counter[str] = Counter(instructions=len(annotated))
    for reading, found in zip(readings, annotated, strict=True):
        for row, are_alike in ROWS:
            pairs = [are_alike(one, other) for one, other in combinations(found, 2)]
            ours = [are_alike(reading, one) for one in found]
            counts.update({f"{row}: pairs": len(pairs), f"{row}: alike": sum(pairs)})
            counts.update({f"{row}: to us": len(ours), f"{row}: as ours": sum(ours)})
            if most := next((one for one in found if sum(are_alike(one, other) for other in found) > 1), None):
                counts.update({f"{row}: majorities": 1, f"{row}: as most": are_alike(reading, most)})
    return counts


def _show(name: str, counts: Counter[str]) -> None:
    print(f"{name} ({counts['instructions']})")
    for row, _ in ROWS:
        for what, count, of in (("two annotators", "alike", "pairs"), ("we and one annotator", "as ours", "to us")):
            alike, pairs = counts[f"{row}: {count}"], counts[f"{row}: {of}"]
            print(f"  {row:14} {what:21} {_of_pairs(alike, pairs, counts['instructions'])}")
        print(f"  {row:14} {'we and most':21} {Proportion(counts[f'{row}: as most'], counts[f'{row}: majorities'])}")


def _of_pairs(alike: int, pairs: int, instructions: int) -> str:
    low, high = Proportion(round(alike / pairs * instructions), instructions).interval or (0.0, 1.0)
    return f"{alike / pairs:.1%} [{low:.1%}, {high:.1%}] ({alike}/{pairs})"


if __name__ == "__main__":
    main()
