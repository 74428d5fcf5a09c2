"""What is certain of arguments stands whatever the models find."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.amendments import amended
from decomplex_bt.understanding.arguments import FoundArgument, FoundArguments
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.withdrawals import withdrawals_of

GAZETTEER = Gazetteer({}, {}, frozenset())


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def arguments(parser: Parser, text: str, tasks: dict[str, str], *found: tuple[str, str, str]) -> set[tuple[str, str]]:
    """The arguments after amendment, as types with words; `found`: a type, its words and the word of its task."""
    document = parser.parse(text)
    observed = Observed(document, GAZETTEER)
    place = {word: next(t.i for t in document.tokens if t.text == word) for word in tasks}

    def tokens(words: str) -> range:
        first = next(t.i for t in document.tokens if text[t.start :].startswith(words))
        return range(first, first + len(parser.parse(words)))

    before = tuple(FoundArgument(kind, place[task], tokens(words), 0.8) for kind, words, task in found)
    types = {place[word]: kind for word, kind in tasks.items()}
    after = amended(observed, types, withdrawals_of(observed), FoundArguments(before, 0.5))
    assert after.probability == 0.5
    return {(a.type, document.span(a.tokens.start, a.tokens.stop - 1).of(text)) for a in after.arguments}


def test_what_is_said_aside_is_no_argument_but_for_places(parser: Parser) -> None:
    text = "Since the cup is in the sink, rinse it."
    found = ("object", "the cup", "rinse"), ("source", "in the sink", "rinse"), ("object", "it", "rinse")
    assert arguments(parser, text, {"rinse": "change_state"}, *found) == {("source", "in the sink"), ("object", "it")}


def test_a_correction_replaces_the_last_argument_that_begins_alike(parser: Parser) -> None:
    text = "Put the milk in the fridge, no, scratch that, in the freezer."
    found = ("object", "the milk", "Put"), ("goal", "in the fridge", "Put"), ("location", "in the freezer", "Put")
    assert arguments(parser, text, {"Put": "placing"}, *found) == {("object", "the milk"), ("goal", "in the freezer")}


def test_an_idiom_tells_of_its_check_what_a_model_gave_to_another(parser: Parser) -> None:
    text = "The milk may be in the fridge. If so, bring it."
    found = ("source", "in the fridge", "bring"), ("object", "it", "bring")
    assert arguments(parser, text, {"be": "check_state", "bring": "bringing"}, *found) == {
        ("object", "The milk"),
        ("location", "in the fridge"),
        ("object", "it"),
    }


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("Somebody is ringing.", {("object", "it"), ("state", "the plumber")}),
        ("The bell rings.", {("object", "the plumber")}),
    ],
)
def test_who_it_is_is_the_state_of_somebody_spoken_of(
    parser: Parser, before: str, expected: set[tuple[str, str]]
) -> None:
    text = f"{before} If it 's the plumber, go."
    found = [("object", "the plumber", "'s")]
    assert arguments(parser, text, {"'s": "check_state", "go": "motion"}, *found) == expected
