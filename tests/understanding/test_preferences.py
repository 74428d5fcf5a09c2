"""What somebody would rather have is a check where a case asks it, and what they would have is one of their wishes."""

from __future__ import annotations

import pytest

from decomplex_bt.instruction import Instruction
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.cases.preferences import is_wished, preferences


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("If Nan would prefer cocoa, heat the milk.", ("prefer", "Nan", "cocoa")),
        ("If the lodger prefers the attic, air it.", ("prefers", "the lodger", "the attic")),
        ("Pour the juice unless my son would rather have water.", ("have", "my son", "water")),
        ("Ring the bell, but if Leo would rather sleep, don't.", ("sleep", "Leo", "")),
        ("If he'd rather not, tell me.", ("'d", "he", "")),
    ],
)
def test_a_wish_in_a_case_is_found(parser: Parser, text: str, told: tuple[str, str, str]) -> None:
    document = parser.parse(text)
    (wish,) = preferences(document, {})
    said = (
        document.span(words.start, words.stop - 1).of(text) if words else "" for words in (wish.subject, wish.wished)
    )
    assert (document.tokens[wish.check].text, *said) == told


@pytest.mark.parametrize(
    "text",
    [
        "I'd rather have the blue one.",
        "If you'd rather do it later, tell me.",
        "If Ann says she'd prefer cocoa, heat the milk.",
        "It is rather cold, so close the window if it's open.",
        "If it's wet, I would prefer the mat outside.",
    ],
)
def test_no_wish_in_a_case(parser: Parser, text: str) -> None:
    assert list(preferences(parser.parse(text), {})) == []


def shape(instruction: Instruction, number: int) -> tuple[str, dict[str, str]]:
    task = instruction.task(number)
    return task.type, {argument.type: argument.value for argument in task.arguments}


@pytest.mark.parametrize("second", ["but if she'd prefer cocoa", "and if she would rather have cocoa"])
def test_a_second_wish_is_asked_where_there_is_none_of_the_first(interpreter: Interpreter, second: str) -> None:
    instruction = interpreter.interpret(f"If Nan wants milk, pour it into a cup, {second}, bring her the tin.")
    assert shape(instruction, 3) == ("check_state", {"object": "Nan", "state": "cocoa"})
    assert [node.tasks for node, _ in instruction.flow.walk()] == [(1,), (2,), (3,), (4,)]
    (first,) = instruction.flow.nodes
    assert [n.tasks for n in first.then] == [(2,)]
    assert [n.tasks for n in first.orelse] == [(3,)]


def test_it_is_what_is_wished_for_and_him_who_wishes(interpreter: Interpreter) -> None:
    instruction = interpreter.interpret(
        "If Bertie fancies a biscuit, bring it to him. If he'd prefer jam, bring him the pot."
    )
    bringings = [shape(instruction, task.id)[1] for task in instruction.tasks if task.type == "bringing"]
    assert bringings[0]["object"] == "a biscuit"
    assert {said["recipient"].removeprefix("to ") for said in bringings} == {"Bertie"}


@pytest.mark.parametrize(
    ("text", "is_case"),
    [
        ("If he doesn't want one, call me.", True),
        ("When Nan wants her tea, boil the milk.", True),
        ("If I want one, I'll say so.", False),
        ("I want the blue cup if it's clean.", False),
    ],
)
def test_what_somebody_else_wants_is_asked_in_a_case(parser: Parser, text: str, is_case: bool) -> None:
    document = parser.parse(text)
    assert is_wished(document, next(t.i for t in document.tokens if t.lemma == "want")) == is_case
