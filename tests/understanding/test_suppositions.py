"""What may or should be so is a check where the next words take it up."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Document, Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.cases.suppositions import supposed


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def found(parser: Parser, text: str, *tasks: str) -> list[str]:
    """The words that are checks; `tasks`: the words that are orders."""
    read: Document = parser.parse(text)
    taken = {token.i: "placing" for token in read.tokens if token.text in tasks}
    return [read.tokens[i].text for i in sorted(supposed(read, taken))]


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("The attic might be locked. In that case, fetch the key.", "be"),
        ("My neighbour may have gone out. If so, leave the parcel on the step.", "gone"),
        ("The tank could be empty; in which case fill it.", "be"),
        ("The tank might not have been filled. If so, fill it.", "filled"),
        ("We might be out of milk. If that\u2019s the case, tell Ann.", "be"),
    ],
)
def test_what_may_be_is_a_check_where_it_is_taken_up(parser: Parser, text: str, word: str) -> None:
    assert found(parser, text) == [word]


@pytest.mark.parametrize(
    "text",
    [
        "The attic might be locked. Bring me the key.",
        "You might want to close the door. In that case, tell me.",
        "If the tank is empty, fill it. In that case it may overflow.",
        "Could you close the door? If so, tell me.",
        "It may be that the attic is locked. In that case, fetch the key.",
        "I might go out. If so, close the door.",
    ],
)
def test_what_may_be_is_none_where_nothing_hangs_on_it(parser: Parser, text: str) -> None:
    assert found(parser, text) == []


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("My gloves should be on the shelf. If not, try the car.", "be"),
        ("There ought to be a mop in the cellar, if not try the car.", "be"),
        ("The stove must be warm by now; otherwise try it again.", "be"),
        ("The scissors are probably in the drawer. If not, try the desk.", "are"),
        ("i think the drill is in the van if not try the shed", "is"),
    ],
)
def test_what_should_be_is_a_check_where_it_may_not_hold(parser: Parser, text: str, word: str) -> None:
    assert found(parser, text, "try") == [word]


@pytest.mark.parametrize(
    "text",
    [
        "You should be in the hall. If not, try the car.",
        "The gloves are on the shelf. If not, try the car.",
        "If the stove should be cold, try it. If not, try the car.",
        "The stove should be hot. Try the soup. If not, try the car.",
        "Should the stove be hot, try it. If not, try the car.",
    ],
)
def test_what_is_so_or_was_acted_on_is_none(parser: Parser, text: str) -> None:
    assert found(parser, text, "try", "Try") == []


def test_where_what_is_looked_for_should_be_is_no_check_of_its_own(parser: Parser) -> None:
    read = parser.parse("Find the pump. It should be in the cellar; if not, try the attic.")
    assert not supposed(read, {0: "searching", 12: "searching"})


def test_what_should_be_there_and_is_not_is_looked_for_elsewhere() -> None:
    instruction = Interpreter.load().interpret("My gloves should be on the shelf. If not, look in the car.")
    (node,) = instruction.flow.nodes
    assert (len(node.then), len(node.orelse)) == (0, 1)
    assert [task.value("object") for task in instruction.tasks] == ["My gloves", "My gloves"]
    assert instruction.task(1).value("location") == "on the shelf"
