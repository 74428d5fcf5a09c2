"""Whatever is typed: many hostile inputs through understanding, and whether it crashes, dawdles or hoards memory.

    python benchmarks/fuzz.py [--inputs 100000] [--seed 0] [--domain DIR] [--no-encoder]

Inputs are drawn from a seed: random Unicode with control characters and halves of surrogate pairs, markup, quotes in
quotes, punctuation alone, very long words, texts up to and over the limit, and sentences of the corpus, mutated or
broken off. Every batch goes through `Interpreter.interpret_batch` and the JSON that `parse` prints, every tenth one
through `parse` itself. Prints crashes, the slowest input, and the resident memory at the start (after the first tenth,
when all caches are warm), in the middle and at the end. Exit status 1 after a crash, and where memory grew from the
middle to the end by more than `MAX_GROWTH`.
"""

from __future__ import annotations

import argparse
import ctypes
import gc
import io
import json
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.interpreter import MAX_CHARACTERS, Interpreter, check_text

BATCH = 200
"""Inputs in a batch."""
MAX_GROWTH = 0.05
"""Of the resident memory, over the second half of the inputs; whoever hoards grows without end."""
PARSED_BATCHES = 10
"""Every how many batches one goes through the command `parse`."""

Draw = Callable[[np.random.Generator, Sequence[str]], str]
"""Draws one input; the sentences are the corpus's."""

_CONTROLS = "".join(map(chr, [*range(32), *range(127, 160), 0x200B, 0x200D, 0x2028, 0x2029, 0x202E, 0x2066, 0xFEFF]))
_PUNCTUATION = "?!.,;:-–—…()[]{}\"'“”‘’«»/\\|@#$%^&*_+=<>~`"
_MARKUP = ("<b>", "</b>", "[it](1:object=a pen)", "](", "{if: 1}", "&amp;", "```", "<!--", "%s", "$(ls)", "{{x}}")
_QUOTES = ('"', "'", "“", "”", "‘", "’", "«", "»", "(", ")", "[", "]")
_SHORT_WORDS = "if it then not is in to me else the and unless before".split()


def unicode_text(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """Characters from anywhere, halves of surrogate pairs among them."""
    high = int(rng.choice((0x80, 0x300, 0x3000, 0xE000, 0x11_0000)))
    return "".join(map(chr, rng.integers(high, size=int(rng.integers(1, 80)))))


def controls(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence with control characters in it."""
    return _sprinkled(rng, _any(rng, sentences), _CONTROLS)


def surrogates(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence with half of a surrogate pair; to be refused."""
    return _sprinkled(rng, _any(rng, sentences), "\ud800\udbff\udc00\udfff")


def markup(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence with marks of other languages."""
    return _sprinkled(rng, _any(rng, sentences), _MARKUP)


def quotes(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence in quotes in quotes, many of them unpaired."""
    return _sprinkled(rng, _any(rng, sentences), _QUOTES, share=0.2)


def punctuation(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """Nothing but marks, and sometimes spaces."""
    return "".join(rng.choice(list(_PUNCTUATION + "  "), size=int(rng.integers(1, 120))))


def long_words(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """Words without an end."""
    return " ".join(
        _any(rng, sentences).replace(" ", str(rng.choice(("", "-", "_", "'", "/"))))[: int(rng.integers(20, 900))]
        for _ in range(int(rng.integers(1, 4)))
    )


def huge(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """Up to the limit and just over it."""
    parts = []
    while sum(map(len, parts)) <= MAX_CHARACTERS:
        parts.append(_any(rng, sentences) + str(rng.choice((" ", " and ", " if ", "\n", ", "))))
    return "".join(parts)[: MAX_CHARACTERS + int(rng.integers(-20, 3))]


def repeated(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A few short words over and over: conditions within conditions within conditions."""
    words = list(rng.choice(_SHORT_WORDS, size=3)) + _any(rng, sentences).split()[:3]
    return " ".join(rng.choice(words, size=int(rng.integers(1, 120))))


def mutated(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """Sentences with words dropped, doubled, swapped, glued together or from another sentence."""
    words = _any(rng, sentences).split()
    for _ in range(int(rng.integers(1, 6))):
        i = int(rng.integers(len(words)))
        change = int(rng.integers(5))
        if change == 0 and len(words) > 1:
            del words[i]
        elif change == 1:
            words.insert(i, words[i])
        elif change == 2:
            words[i], words[-1] = words[-1], words[i]
        elif change == 3:
            words[i : i + 2] = ["".join(words[i : i + 2])]
        else:
            words[i] = str(rng.choice(_any(rng, sentences).split()))
    return " ".join(words)


def characters(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence with single letters lost, doubled, shifted or upper-cased."""
    text = list(_any(rng, sentences))
    for i in np.unique(rng.integers(len(text), size=int(rng.integers(1, 8)))):
        text[i] = str(rng.choice(("", text[i] * 2, text[i].upper(), " ", chr(ord(text[i]) + 1))))
    return "".join(text)


def broken_off(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    """A sentence that ends, or begins, at some word, without its last mark."""
    words = sentences[rng.integers(len(sentences))].split()
    cut = int(rng.integers(1, len(words) + 1))
    kept = words[:cut] if rng.random() < 0.5 else words[-cut:]
    return " ".join(kept).rstrip(".,;:!?") or kept[0]


KINDS: tuple[tuple[Draw, float], ...] = (
    (mutated, 0.2), (broken_off, 0.1), (characters, 0.2), (unicode_text, 0.1), (controls, 0.08), (markup, 0.08),
    (quotes, 0.08), (punctuation, 0.05), (repeated, 0.05), (long_words, 0.04), (surrogates, 0.01), (huge, 0.01),
)  # fmt: skip
"""What is drawn, and how large a share it has."""


@dataclass
class Report:
    """What came of the inputs. `slowest`: seconds and the input; `memory`: resident bytes at start, middle and end."""

    inputs: int = 0
    refused: int = 0
    kinds: Counter[str] = field(default_factory=Counter)
    crashes: list[tuple[str, str]] = field(default_factory=list)
    slowest: tuple[float, str] = (0.0, "")
    memory: list[int] = field(default_factory=list)

    @property
    def growth(self) -> float:
        """Of the memory over the second half, as a share; 0 where it was not measured."""
        return self.memory[2] / self.memory[1] - 1 if len(self.memory) > 2 else 0.0

    def __str__(self) -> str:
        seconds, text = self.slowest
        lines = [f"{self.inputs} inputs, {self.refused} of them refused as they should be, {len(self.crashes)} crashes"]
        lines += [f"  crash: {error}: {ascii(text)[:300]}" for text, error in self.crashes[:20]]
        lines.append("  " + ", ".join(f"{name} {count}" for name, count in sorted(self.kinds.items())))
        lines.append(f"slowest: {seconds:.2f} s for {len(text)} characters: {ascii(text)[:100]}")
        if len(self.memory) > 2:
            start, middle, end = (size / 2**20 for size in self.memory)
            lines.append(f"memory: {start:.0f} MB at the start, {middle:.0f} MB in the middle, {end:.0f} MB at the end")
        return "\n".join(lines)


def fuzz(
    interpreter: Interpreter, inputs: int, seed: int, *, every: Callable[[Report], None] = lambda report: None
) -> Report:
    """Draws so many inputs and reads them batch by batch; `every` is told after each batch."""
    rng = np.random.default_rng(seed)
    sentences = _sentences(interpreter.domain)
    report = Report()
    slowest: tuple[float, list[str]] = (0.0, [])
    starts = range(0, inputs, BATCH)
    looks = {max(len(starts) // 10, 1), max(len(starts) // 2, 1), len(starts)}
    for number, start in enumerate(starts, start=1):
        batch = list(_drawn(rng, sentences, min(BATCH, inputs - start), report))
        began = time.perf_counter()
        _read(interpreter, batch, report)
        spent = (time.perf_counter() - began) / max(len(batch), 1)
        slowest = max(slowest, (spent, batch))
        if number % PARSED_BATCHES == 1:
            _parse(batch, interpreter, report)
        if number in looks:
            report.memory.append(resident_bytes())
        every(report)
    for text in slowest[1]:
        began = time.perf_counter()
        _crash_of(interpreter, text)
        report.slowest = max(report.slowest, (time.perf_counter() - began, text))
    return report


def resident_bytes() -> int:
    """The memory that this process holds now, once what is free has been given back: one long input makes glibc keep
    tens of megabytes for the next, which is no hoarding."""
    gc.collect()
    give_back = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if give_back is not None:
        give_back(0)
    for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) * 1024
    raise OSError("/proc/self/status tells no VmRSS")


def check(instruction: Instruction, text: str) -> None:
    """Raises `AssertionError` where a reading is none of this text, or cannot be printed and read again."""
    assert instruction.text == text, "another text"
    value = json.loads(json.dumps(instruction.to_json(alternatives=5)))
    count = len(value["tasks"])
    assert Flow.from_json(value["flow"], task_count=count) == instruction.flow, "the flow does not read back"
    for other in value["alternatives"]:
        Flow.from_json(other["flow"], task_count=count)
    for part in (*value["tasks"], *(a for task in value["tasks"] for a in task["arguments"])):
        assert 0 <= part["confidence"] <= 1, "a confidence outside 0 to 1"
        assert part["start"] is None or text[part["start"] : part["end"]] == part["surface"], "a span of other words"


def _drawn(rng: np.random.Generator, sentences: Sequence[str], count: int, report: Report) -> Iterator[str]:
    """Inputs that are to be read; those that are to be refused are tried here."""
    draws, shares = zip(*KINDS, strict=True)
    for which in rng.choice(len(draws), size=count, p=np.array(shares) / sum(shares)):
        text = draws[which](rng, sentences)
        report.inputs += 1
        report.kinds[draws[which].__name__] += 1
        is_bad = not text.strip() or len(text) > MAX_CHARACTERS or any("\ud800" <= c <= "\udfff" for c in text)
        try:
            check_text(text)
        except InputError:
            report.refused += 1
            if not is_bad:
                report.crashes.append((text, "refused without cause"))
        else:
            if is_bad:
                report.crashes.append((text, "taken though it is no instruction"))
            yield text


def _read(interpreter: Interpreter, batch: Sequence[str], report: Report) -> None:
    try:
        for instruction, text in zip(interpreter.interpret_batch(batch), batch, strict=True):
            check(instruction, text)
    except Exception:
        alone = [(text, error) for text in batch if (error := _crash_of(interpreter, text))]
        report.crashes += alone or [(batch[0], "a batch that crashes, though none of its inputs does alone")]


def _crash_of(interpreter: Interpreter, text: str) -> str | None:
    try:
        check(interpreter.interpret(text), text)
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return None


def _parse(batch: Sequence[str], interpreter: Interpreter, report: Report) -> None:
    """Through the command line: a line of output or of complaint for every line of input."""
    from decomplex_bt.cli import main

    lines = [text.replace("\n", " ").replace("\r", " ") for text in batch]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "lines.txt"
        file.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8", newline="")
        out, err = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(err):
            status = main(["parse", str(file), "--json", "--domain", str(interpreter.domain.folder)])
    told = out.getvalue().count("\n") + err.getvalue().count("\n")
    if status not in (0, 2) or told != len(lines):
        said = f"parse: status {status}, {told} lines for {len(lines)}: {err.getvalue()[:200]}"
        report.crashes.append((lines[0], said))


def _sentences(domain: Domain) -> list[str]:
    return [example.instruction.text for example in read_corpus(domain.folder / "corpus", domain.ontology)]


def _any(rng: np.random.Generator, sentences: Sequence[str]) -> str:
    return sentences[int(rng.integers(len(sentences)))]


def _sprinkled(rng: np.random.Generator, text: str, pieces: Sequence[str], *, share: float = 0.05) -> str:
    """The text with one or more of the pieces put between its characters."""
    places = {int(rng.integers(len(text) + 1)), *np.flatnonzero(rng.random(len(text)) < share).tolist()}
    return "".join(
        (pieces[int(rng.integers(len(pieces)))] if i in places else "") + text[i : i + 1] for i in range(len(text) + 1)
    )


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--inputs", type=int, default=100_000)
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--domain", default="household", help="a domain's name, or its folder")
    arguments.add_argument("--encoder", action=argparse.BooleanOptionalAction, help="default: where it is installed")
    options = arguments.parse_args()
    domain = load_domain(Path(options.domain) if "/" in options.domain else options.domain)

    def tell(report: Report) -> None:
        if sys.stderr.isatty():
            print(f"\r{report.inputs} inputs, {len(report.crashes)} crashes ", end="", file=sys.stderr, flush=True)

    report = fuzz(Interpreter.load(domain, encoder=options.encoder), options.inputs, options.seed, every=tell)
    print(report)
    if report.growth > MAX_GROWTH:
        print(f"memory grew by {report.growth:.1%} over the second half; expected at most {MAX_GROWTH:.0%}")
    return 1 if report.crashes or report.growth > MAX_GROWTH else 0


if __name__ == "__main__":
    sys.exit(main())
