"""A mistyped word is read as what was meant, and stands where and as it was typed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.document import Document, Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.spelling import FREQUENT, KNOWN, Speller, write_words

WORDS = "bring the otherwise window unplug worktop else mum door and".split()
LEMMAS = frozenset(("doctor", "carry", "stop", "bake"))


@pytest.fixture
def speller(tmp_path: Path) -> Speller:
    path = tmp_path / "words.json"
    path.write_text(json.dumps(dict.fromkeys(WORDS, FREQUENT) | {"windlow": KNOWN}), encoding="utf-8")
    return Speller(path)


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("brign teh", "bring the"),  # swapped
        ("othrwise", "otherwise"),  # left out
        ("winndow", "window"),  # doubled
        ("unplig", "unplug"),  # the key beside
        ("nuplug", "unplug"),  # the first letters
        ("Brign", "Bring"),
        ("BRIGN", "Bring"),
    ],
)
def test_a_slip_is_mended(speller: Speller, typed: str, meant: str) -> None:
    assert speller.meant(typed.split(), lambda: LEMMAS) == meant.split()


@pytest.mark.parametrize(
    "typed",
    [
        "bring the window",
        "windlow",  # stands often enough in the corpus
        "doctors carries stopped baking",  # forms of what the dictionary has
        "worktops",  # of what the corpus has
        "tha thd",  # short: a slip away from too much
        "umm",
        "the Briing",  # a name
        "wnidwo",  # two slips
        "br1gn brïgn",
        "x" * 2000,
    ],
)
def test_what_is_no_slip_stays(speller: Speller, typed: str) -> None:
    assert speller.meant(typed.split(), lambda: LEMMAS) is None


def test_a_broken_file_is_named(tmp_path: Path) -> None:
    path = tmp_path / "words.json"
    path.write_text("[1]", encoding="utf-8")
    with pytest.raises(DataFileError, match=r"words\.json"):
        Speller(path)


def test_rare_words_are_not_written(tmp_path: Path) -> None:
    document = Parser().parse("lamp lamp lamp door")
    write_words(tmp_path / "words.json", [document])
    assert json.loads((tmp_path / "words.json").read_text(encoding="utf-8")) == {"lamp": 3}


def test_tokens_stand_where_they_were_typed() -> None:
    def spelling(words: object, lemmas: object) -> list[str]:
        return ["Bring", "me", "the", "window", "!"]

    parser, text = Parser(), "Brinng me teh windw!"
    for document in (parser.parse(text, spelling), next(parser.parse_batch([text], spelling=spelling))):
        assert isinstance(document, Document)
        assert document.text == text
        assert [token.text for token in document.tokens] == ["Bring", "me", "the", "window", "!"]
        assert [text[token.start : token.end] for token in document.tokens] == ["Brinng", "me", "teh", "windw", "!"]


def test_a_mistyped_instruction_means_what_was_meant_in_its_own_words(interpreter: Interpreter) -> None:
    right = interpreter.interpret("If the window is open, close it, otherwise bring me the kettle.")
    typed = "If teh wndow is opne, close it, otehrwise brign me the kettel."
    found = interpreter.interpret(typed)
    assert found.flow == right.flow
    assert [task.type for task in found.tasks] == [task.type for task in right.tasks]
    assert [task.span.of(typed) for task in found.tasks] == ["is", "close", "brign"]
    assert [argument.value for argument in found.tasks[1].arguments] == ["teh wndow"]
    assert next(interpreter.interpret_batch([typed])) == found


def test_a_slip_in_what_is_mended_in_the_same_breath_stays_in_its_place(interpreter: Interpreter) -> None:
    typed = "Brign me the, um, the kettel, no, sorry, close the wndow."
    found = interpreter.interpret(typed)
    assert [task.span.of(typed) for task in found.tasks] == ["close"]
    assert [a.span.of(typed) for a in found.tasks[0].arguments if a.span] == ["the wndow"]
