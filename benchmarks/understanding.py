"""How long understanding takes, as ratios to the bare spaCy pipeline it uses, interleaved in one run.

    python benchmarks/understanding.py [--rounds 5]

Prints, with the CRFs alone and with the encoder where it is installed: one instruction, text to flow, against
`nlp(text)` without ner; a batch in one process and in several against one by one, beside what the pipeline itself gains
by `nlp.pipe`; a cold process that parses one instruction against one that only imports the package and spaCy and
loads the model; the peak memory of the former.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec

from decomplex_bt.corpus import read_split
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.document import MODELS
from decomplex_bt.understanding.interpreter import Interpreter, has_encoder

COLD = (
    "from decomplex_bt.understanding.interpreter import Interpreter;"
    "Interpreter.load(encoder={encoder}).interpret('Close the door.')"
)
COLD_BARE = "from decomplex_bt.understanding.document import Parser; Parser()._nlp('Close the door.')"
WITHOUT_TORCH = "import sys; sys.modules['torch'] = None;"
"""Who does not train has none; where it is installed spaCy imports it, for half a gigabyte."""
PEAK = ";print(next(line.split()[1] for line in open('/proc/self/status') if line.startswith('VmHWM')))"
"""Of the process itself [kB]; `ru_maxrss` would have that of the process which started it."""
MODEL = next(name for name in MODELS.values() if find_spec(name))
BARE = {"exclude": ["ner", "senter"]}


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
    nlp = import_module(MODEL).load(**BARE)
    ratio, _ = median_ratio(lambda: [nlp(t) for t in texts], lambda: list(nlp.pipe(texts, batch_size=128)), rounds)
    print(f"bare spaCy in a batch is {ratio:.2f} times as fast as one by one")
    for encoder in (False, True) if has_encoder(domain.folder / "models") else (False,):
        print("with the encoder:" if encoder else "with the CRFs alone:")
        measure(Interpreter.load(domain, encoder=encoder), nlp, texts, rounds)
        measure_cold(encoder, rounds)


def measure(interpreter: Interpreter, nlp: Callable[[str], object], texts: Sequence[str], rounds: int) -> None:
    """Prints the ratios of an interpreter that is loaded."""
    ratio, took = median_ratio(
        lambda: [interpreter.interpret(t) for t in texts], lambda: [nlp(t) for t in texts], rounds
    )
    print(f"  one instruction: {1000 * took / len(texts):.2f} ms, {ratio:.2f} times bare spaCy")
    ratio, _ = median_ratio(
        lambda: [interpreter.interpret(t) for t in texts], lambda: list(interpreter.interpret_batch(texts)), rounds
    )
    print(f"  a batch is {ratio:.2f} times as fast as one by one")
    many = [*texts] * 5
    list(interpreter.interpret_batch(many, jobs=-1))  # the processes load the models once
    ratio, _ = median_ratio(
        lambda: [interpreter.interpret(t) for t in many],
        lambda: list(interpreter.interpret_batch(many, jobs=-1)),
        rounds,
    )
    print(f"  a batch in a process for each of {os.cpu_count()} cores is {ratio:.2f} times as fast as one by one")


def measure_cold(encoder: bool, rounds: int) -> None:
    """Prints the ratio of a process that parses one instruction, and its peak memory."""
    program = COLD.format(encoder=encoder)
    with tempfile.TemporaryDirectory() as folder:
        # all modules compiled before, as an installer leaves them
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        memory = int(run(WITHOUT_TORCH + program + PEAK, environment)) / 1024
        run(COLD_BARE, environment)
        ratio, took = median_ratio(lambda: run(program, environment), lambda: run(COLD_BARE, environment), rounds)
    print(f"  a cold parse: {took:.2f} s, {ratio:.2f} times a process that only loads spaCy and the model")
    print(f"  peak memory of a cold parse, without torch: {memory:.0f} MB")


def run(program: str, environment: Mapping[str, str]) -> str:
    """What a Python program prints in a process of its own."""
    command = [sys.executable, "-c", program]
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


if __name__ == "__main__":
    main()
