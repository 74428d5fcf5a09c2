"""How long understanding takes, as ratios to the bare spaCy pipeline it uses, interleaved in one run.

    python benchmarks/understanding.py [--rounds 5]

Prints: one instruction, text to flow, against `nlp(text)` without ner; a batch against one by one; a cold process that
parses one instruction against one that only imports spaCy and loads the model; the peak memory of the former.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

from decomplex_bt.corpus import read_split
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter

COLD = "from decomplex_bt.understanding.interpreter import Interpreter; Interpreter.load().interpret('Close the door.')"
COLD_BARE = "from decomplex_bt.understanding.document import Parser; Parser()._nlp('Close the door.')"


def seconds(action: Callable[[], object]) -> float:
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def median_ratio(first: Callable[[], object], second: Callable[[], object], rounds: int) -> tuple[float, float]:
    """The median of first/second over interleaved rounds, and the median seconds of `first`."""
    pairs = [(seconds(first), seconds(second)) for _ in range(rounds)]
    return statistics.median(a / b for a, b in pairs), statistics.median(a for a, _ in pairs)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--rounds", type=int, default=5)
    rounds = arguments.parse_args().rounds
    domain = load_domain("household")
    texts = [e.instruction.text for e in read_split(domain.folder / "corpus", domain.ontology, "test")][:100]
    interpreter, nlp = Interpreter.load(domain), Parser()._nlp

    ratio, took = median_ratio(
        lambda: [interpreter.interpret(t) for t in texts], lambda: [nlp(t) for t in texts], rounds
    )
    print(f"one instruction: {1000 * took / len(texts):.2f} ms, {ratio:.2f} times bare spaCy")
    ratio, took = median_ratio(
        lambda: [interpreter.interpret(t) for t in texts], lambda: list(interpreter.interpret_batch(texts)), rounds
    )
    print(f"a batch is {ratio:.2f} times as fast as one by one")

    def run(program: str) -> None:
        subprocess.run([sys.executable, "-c", program], check=True)

    ratio, took = median_ratio(lambda: run(COLD), lambda: run(COLD_BARE), rounds)
    print(f"a cold parse: {took:.2f} s, {ratio:.2f} times a process that only loads spaCy and the model")
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"peak memory of a cold parse: {memory:.0f} MB")


if __name__ == "__main__":
    main()
