"""Recombined copies mean what their words say, and their annotation fits their text."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pytest

from decomplex_bt.corpus import read_corpus, read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.recombination.conditions import condition_of, joined, rephrased
from decomplex_bt.understanding.recombination.copies import recombined
from decomplex_bt.understanding.recombination.steps import reordered
from decomplex_bt.understanding.recombination.stretches import Telling, composed

DOMAIN = load_domain("household")
TWO = "[Wash](1:change_state) [the cup](1:object). Then [put](2:placing) [it](2:object=the cup) [on the shelf](2:goal)."
THREE = TWO + " [Close](3:change_state) [the window](3:object)."
HOT = (
    "If [the tea](1:object) [is](1:check_state) [hot](1:state), "
    "[bring](2:bringing) [it](2:object=the tea) [to Anna](2:recipient)"
)
ELSE = HOT + "; otherwise [heat](3:change_state) [it](3:object=the tea)."
LATE = "If [Tom](1:object) [is](1:check_state) [home](1:state), [tell](2:informing) [him](2:recipient=Tom)."


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def observed(parser: Parser, instruction: Instruction) -> Observed:
    return Observed(parser.parse(instruction.text), Gazetteer.of(DOMAIN.lexicon, DOMAIN.kinds))


def read(text: str, flow: list) -> Instruction:
    return read_markup(text, DOMAIN.ontology, flow=flow)


def texts(tellings: Iterable[tuple[str, Telling]]) -> dict[str, list]:
    """The texts that come of tellings, with their flows as JSON."""
    copies = [copy for _, telling in tellings if (copy := composed(telling)) is not None]
    for copy in copies:
        check(copy)
    return {copy.text: copy.flow.to_json() for copy in copies}


def check(copy: Instruction) -> None:
    """Spans are whole words in the order of the tasks, and each argument's words are where they were."""
    assert [task.span for task in copy.tasks] == sorted(task.span for task in copy.tasks)
    for task in copy.tasks:
        for span in (task.span, *(a.span for a in task.arguments if a.span is not None)):
            assert span.of(copy.text).strip() == span.of(copy.text) != ""
            assert not (copy.text[span.start - 1 : span.start] + copy.text[span.start]).isalnum() or span.start == 0


def test_two_steps_in_another_order(parser: Parser) -> None:
    instruction = read(TWO, [1, 2])
    told = texts(reordered(observed(parser, instruction), instruction, 0))
    assert told["Put it on the shelf. But before that, wash the cup."] == [2, 1]
    assert told["Before you put it on the shelf, wash the cup."] == [2, 1]
    assert told["Wash the cup before putting it on the shelf."] == [1, 2]
    assert told["Put it on the shelf after washing the cup."] == [2, 1]
    assert told["Put it on the shelf, but wash the cup first."] == [2, 1]


def test_three_steps_in_another_order(parser: Parser) -> None:
    instruction = read(THREE, [1, 2, 3])
    told = texts(reordered(observed(parser, instruction), instruction, 0))
    assert told["Put it on the shelf. Close the window. Before any of that, wash the cup."] == [3, 1, 2]
    assert told["Close the window last of all. Wash the cup. Put it on the shelf."] == [2, 3, 1]
    assert told["Before you put it on the shelf, wash the cup. Then close the window."] == [2, 1, 3]
    assert told["Wash the cup. Then close the window, but not before you put it on the shelf."] == [1, 3, 2]


def test_words_of_order_are_left_alone(parser: Parser) -> None:
    text = "Before you [wash](1:change_state) [the cup](1:object), [close](2:change_state) [the window](2:object)."
    instruction = read(text, [2, 1])
    assert not list(reordered(observed(parser, instruction), instruction, 0))


def test_a_condition_in_other_words(parser: Parser) -> None:
    instruction = read(HOT + ".", [{"if": 1, "then": [2]}])
    condition = condition_of(observed(parser, instruction), instruction, 0)
    assert condition is not None
    told = texts(rephrased(condition))
    assert told["Bring it to Anna, but only if the tea is hot."] == [{"if": 2, "then": [1]}]
    assert told["Bring it to Anna unless the tea is hot."] == [{"if": 2, "else": [1]}]
    assert told["Don't bring it to Anna unless the tea is hot."] == [{"if": 2, "then": [1]}]
    assert told["Don't bring it to Anna if the tea is hot."] == [{"if": 2, "else": [1]}]


def test_a_condition_with_both_branches_in_other_words(parser: Parser) -> None:
    instruction = read(ELSE, [{"if": 1, "then": [2], "else": [3]}])
    condition = condition_of(observed(parser, instruction), instruction, 0)
    assert condition is not None
    told = texts(rephrased(condition))
    assert told["Heat it. If the tea is hot, bring it to Anna instead."] == [{"if": 2, "then": [3], "else": [1]}]
    assert told["Heat it, unless the tea is hot, in which case bring it to Anna."] == [
        {"if": 2, "then": [3], "else": [1]}
    ]


def test_a_negated_condition_keeps_its_side(parser: Parser) -> None:
    text = (
        "If [the tea](1:object) [is](1:check_state)n't [hot](1:state), [heat](2:change_state) [it](2:object=the tea)."
    )
    instruction = read(text, [{"if": 1, "else": [2]}])
    condition = condition_of(observed(parser, instruction), instruction, 0)
    assert condition is not None
    told = texts(rephrased(condition))
    assert told["Heat it, but only if the tea isn't hot."] == [{"if": 2, "else": [1]}]
    assert not any("unless the tea isn't" in text for text in told if not text.startswith("Don't"))


def test_two_conditions_in_one_instruction(parser: Parser) -> None:
    pairs = []
    for text, flow in ((LATE, [{"if": 1, "then": [2]}]), (ELSE, [{"if": 1, "then": [2], "else": [3]}])):
        instruction = read(text, flow)
        pairs.append((observed(parser, instruction), instruction))
    one, two = (condition_of(*pair, source=k) for k, pair in enumerate(pairs))
    assert one is not None
    assert two is not None
    told = texts(joined(one, two))
    both = {"if": 3, "then": [4], "else": [5]}
    text = "If Tom is home, tell him. Otherwise, if the tea is hot, bring it to Anna. Otherwise, heat it."
    assert told[text] == [{"if": 1, "then": [2], "else": [both]}]
    text = "If Tom is home, tell him. If the tea is hot, bring it to Anna. Otherwise, heat it."
    assert told[text] == [{"if": 1, "then": [2]}, both]
    assert told["If Tom is home and the tea is hot, bring it to Anna; otherwise heat it."] == [
        {"if": 1, "then": [{"if": 2, "then": [3], "else": [4]}], "else": [{"same": [4]}]}
    ]


def test_copies_of_the_corpus_fit_their_texts(parser: Parser) -> None:
    examples = read_corpus(DOMAIN.folder / "corpus" / "abe.yaml", DOMAIN.ontology)
    pairs = [(observed(parser, e.instruction), e.instruction) for e in examples]
    copies = recombined(pairs, np.random.default_rng(0))
    assert len(copies) > len(pairs) / 3
    for copy in copies:
        check(copy)
    assert len({copy.text for copy in copies}) == len(copies)
    assert copies == recombined(pairs, np.random.default_rng(0))
