"""Conditions that ask who or what something is."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.references.identity import identities, order_behind


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("if it is the postman open for him", [("it", "the postman", "open")]),
        ("If it's only our cousin, let her in.", [("it", "our cousin", None)]),
        ("Drink it, and unless that was the last one, bring another.", [("that", "the last one", None)]),
        ("If that awful noise is the dryer, stop it.", [("that awful noise", "the dryer", None)]),
        ("If it is the postman open, go.", [("it", "the postman", None)]),
        ("If it is open, go.", []),
        ("If it's a postman, let them in.", [("it", "a postman", None)]),
        ("If it's a bit cold, go.", []),
        ("If it's a parcel, go.", []),
        ("If it is the lid of the pot, wash it.", []),
        ("If that is the case, go.", []),
        ("If it's the weekend, go.", []),
        ("It is the postman.", []),
    ],
)
def test_a_definite_phrase_or_somebody_behind_a_condition_tells_who_or_what_it_is(
    parser: Parser, text: str, found: list[tuple[str, str, str | None]]
) -> None:
    read = parser.parse(text)

    def words(tokens: range) -> str:
        return " ".join(read.tokens[i].text for i in tokens)

    orders = [(identity, order_behind(read, identity)) for identity in identities(read)]
    assert [
        (words(i.subject), words(i.name), None if order is None else read.tokens[order].text) for i, order in orders
    ] == found


@pytest.mark.parametrize(
    ("text", "check"),
    [
        ("Take a filter, and if that was the last one, tell me.", {"object": "a filter", "state": "the last one"}),
        ("Eat the plum, and if it was the only one, tell me.", {"object": "the plum", "state": "the only one"}),
        ("go to the gate and if it is my cousin let her in", {"object": "my cousin"}),
        ("If it was only the wind, shut the door.", {"object": "the wind"}),
        ("if that hum is the fridge tell me", {"object": "that hum", "state": "the fridge"}),
        ("Somebody rang. If it is the nurse, let her in.", {"object": "Somebody", "state": "the nurse"}),
        ("If it is Sunday, tell me.", {"object": "it", "state": "Sunday"}),
        ("Taste the soup, and if it is hot, tell me.", {"object": "the soup", "state": "hot"}),
    ],
)
def test_what_something_is_is_asked(text: str, check: dict[str, str]) -> None:
    tasks = Interpreter.load().interpret(text).tasks
    found = next(task for task in tasks if task.type == "check_state")
    assert {argument.type: argument.value for argument in found.arguments} == check


@pytest.mark.parametrize(
    "text", ["Tell me if that was the last one.", "Check if this is the last one.", "That was the last one, thanks."]
)
def test_what_is_told_or_found_out_is_no_condition(text: str) -> None:
    tasks = Interpreter.load().interpret(text).tasks
    assert [task.span.of(text) for task in tasks if task.span.of(text) in ("is", "was")] == []


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("go to the gate and if it is my cousin let her in", "my cousin"),
        ("if that smell is the bin empty it", "the bin"),
        ("If that parcel is the last one, bring it here.", "that parcel"),
    ],
)
def test_a_pronoun_in_the_branch_of_what_something_is_means_that(text: str, meant: str) -> None:
    assert Interpreter.load().interpret(text).tasks[-1].value("object") == meant


def test_what_somebody_may_be_and_is_ordered_is_ordered() -> None:
    instruction = Interpreter.load().interpret("if it is the postman open for him and tell him to wait")
    assert instruction.flow.to_json() == [{"if": 1, "then": [2, 3]}]
    assert [task.type for task in instruction.tasks] == ["check_state", "change_state", "informing"]
    assert instruction.tasks[1].value("object") is None
