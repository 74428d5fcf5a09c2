"""A small sample of `benchmarks/fuzz.py`, and that it would notice."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.interpreter import Interpreter

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "fuzz.py"


@pytest.fixture(scope="module")
def fuzz():
    spec = importlib.util.spec_from_file_location("fuzz", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    sys.modules["fuzz"] = module
    spec.loader.exec_module(module)
    yield module
    del sys.modules["fuzz"]


def test_hostile_input_is_read_or_refused(fuzz):
    report = fuzz.fuzz(Interpreter.load("household", encoder=False), 40, seed=7)  # `parse` has the default one
    assert report.crashes == []
    assert report.inputs == 40
    assert len(report.kinds) >= 7


@pytest.mark.parametrize(
    "text",
    [
        "give me the no just let",
        "Please deal \x85with the chick\x0ce\x8dns a\ts I explained. Go to the c\x8foop along the fence, open the\x86 "
        "little hatch and take the egg\ts out \u2029o\x8ef the nest boxe\x8fs. Lay the\u200dm in the straw basket. If "
        "the drinker is frozen, carry i\x1ft into the scullery and fill the spare one instead. I'd like the basket in "
        "here, so bring it t\x05o the kitchen\x0e, and tell \x8amy\x8f \x0fmother how many there \u2029were.",
    ],
)
def test_what_once_crashed_is_read(text):
    assert Interpreter.load("household", encoder=False).interpret(text).text == text


def test_a_crash_is_reported_with_its_input(fuzz, monkeypatch):
    class Fragile:
        domain = load_domain("household")

        def interpret(self, text):
            if '"' in text:
                raise RecursionError("too deep")
            return Instruction(text.replace("\t", " "))

        def interpret_batch(self, texts):
            return map(self.interpret, texts)

    monkeypatch.setattr(fuzz, "_parse", lambda *arguments: None)
    report = fuzz.fuzz(Fragile(), 200, seed=7)
    assert {error.split(":")[0] for _, error in report.crashes} == {"RecursionError", "AssertionError"}
    assert all('"' in text or "\t" in text for text, _ in report.crashes)


def test_draws_are_those_of_the_seed(fuzz):
    def drawn(seed):
        rng = fuzz.np.random.default_rng(seed)
        return [draw(rng, ["Bring me the cup.", "If it is on, turn it off."]) for draw, _ in fuzz.KINDS * 3]

    assert drawn(1) == drawn(1) != drawn(2)


@pytest.mark.parametrize(
    "text",
    [
        "Check whether",
        "Check how",
        "In the event of",
        "The carpet should be given",
        "The flour on the shelf, is it open? If so, put it in",
        "Open the box. Is the key in it",
        "Hang the hammer up if you've finished",
        "If Kim is hungry, bring her an apple. If we're out of",
    ],
)
def test_what_breaks_off_is_read(text: str) -> None:
    assert Interpreter.load("household").interpret(text).text == text
