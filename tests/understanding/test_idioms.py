"""Turns of phrase that are tasks, and their neighbours that are none."""

from __future__ import annotations

import pytest
from documents import document

from decomplex_bt.understanding.document import Document, Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.references.phrases import degree_asked
from decomplex_bt.understanding.rules.orders.idioms import encountered, for_somebody, idiomatic, predicated


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def found(parser: Parser, text: str, *tasks: str) -> list[tuple[str, str]]:
    """The words that are idioms, with their types; `tasks`: the words that are tasks already."""
    read: Document = parser.parse(text)
    taken = {token.i: "check_state" for token in read.tokens if token.text in tasks}
    return [(read.tokens[i].text, kind) for i, kind in sorted(idiomatic(read, taken).items())]


@pytest.mark.parametrize(
    ("text", "found_in"),
    [
        ("Carry the pots in if it's going to freeze tonight.", ["'s"]),
        ("If the ferry isn't about to leave, wait.", ["is"]),
        ("Unless we're supposed to be quiet, sing.", ["'re"]),
        ("Tell Lea it's going to freeze.", []),
        ("If Tom is in the car, go to the garage.", []),
        ("It's going to freeze, so carry the pots in.", []),
    ],
)
def test_what_is_to_come_is_a_check_in_a_case(parser: Parser, text: str, found_in: list[str]) -> None:
    assert [word for word, kind in found(parser, text) if kind == "check_state"] == found_in


def test_what_is_to_come_is_the_state_that_is_asked_for() -> None:
    instruction = Interpreter.load().interpret("Carry the pots in if it's going to freeze tonight.")
    assert [(t.type, t.value("state")) for t in instruction.tasks] == [
        ("bringing", None),
        ("check_state", "going to freeze"),
    ]


def test_the_weather_of_should_it_is_a_check(parser: Parser) -> None:
    assert found(parser, "Should it rain, bring in the cushions.") == [("rain", "check_state")]
    assert found(parser, "Bring in the cushions should it rain.") == [("rain", "check_state")]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Turn the tv off when nobody's in the living room.", {"location": "in the living room"}),
        ("Switch off the computer whenever no one else is there.", {"location": "there"}),
        ("Mop the hall when no-one is using it.", {"state": "using it"}),
    ],
)
def test_that_nobody_is_somewhere_is_a_check(parser: Parser, text: str, told: dict[str, str]) -> None:
    ((verb, kind),) = idiomatic(parser.parse(text), {0: "change_state"}).items()
    read = parser.parse(text)
    words = {name: read.span(said.start, said.stop - 1).of(text) for name, said in predicated(read, verb).items()}
    assert (kind, words) == ("check_state", told)
    assert idiomatic(read, {0: "change_state", verb + 1: "check_state"}) == {}


def test_what_somebody_is_told_is_no_task(parser: Parser) -> None:
    told = parser.parse("Tell Ann should it rain she can take the car.")
    assert idiomatic(told, {0: "informing"}) == {}
    nobody = parser.parse("Tell Ann when nobody is in the study.")
    assert idiomatic(nobody, {0: "informing"}) == {}
    look = parser.parse("Remind Ann you have a look in the oven.")
    assert idiomatic(look, {0: "informing"}) == {}


def test_what_is_asked_in_between_is_what_is_taken_up(parser: Parser) -> None:
    assert found(parser, "Nan might be asleep. Is she in the armchair? If so, close the blinds.") == []
    assert found(parser, "Nan might be asleep is she in bed if so tell me", "is") == []


def test_what_may_be_of_it_only_comments_on_the_check_before(parser: Parser) -> None:
    assert found(parser, "See if the heater is on. It may be warm. If so, turn it off.", "See") == []
    assert found(parser, "Sweep the step. It may be wet. If so, wipe it.") == [("be", "check_state")]


def test_to_have_a_look_is_to_search() -> None:
    said = document("have/VB/ROOT/0", "a/DT/det/2", "look/NN/dobj/0", "in/IN/prep/0", "the/DT/det/5", "shed/NN/pobj/3")
    assert idiomatic(said, {}) == {0: "searching"}
    assert idiomatic(said, {2: "searching"}) == {}


def test_to_have_a_look_whether_something_is_so_is_left_to_the_models(parser: Parser) -> None:
    assert found(parser, "Have a quick look in the shed.") == [("Have", "searching")]
    assert found(parser, "Have a look, is the gate open?") == []
    assert found(parser, "Bring it here so that I can have a look.") == []


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the mirror, I'd like to have a look.",
        "Ask Tom to have a look at the boiler.",
        "The kids have to have a look at it.",
        "Let him have a look at it.",
    ],
)
def test_a_look_that_others_have_is_none(parser: Parser, text: str) -> None:
    assert found(parser, text) == []


def test_a_look_that_the_robot_is_to_have_is_one(parser: Parser) -> None:
    assert found(parser, "I need you to have a look in the shed.") == [("have", "searching")]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Get a coke for Ella from the fridge.", "for Ella"),
        ("Grab a towel for my husband.", "for my husband"),
        ("Get us a pen for me.", "for me"),
        ("Grab that box for me.", ""),
        ("Get a glass for the milk.", ""),
        ("Get a chair before you open the door for Ella.", ""),
        ("Carry his bag for him.", ""),
    ],
)
def test_who_gets_something_for_somebody(parser: Parser, text: str, expected: str) -> None:
    read = parser.parse(text)
    found = for_somebody(read, 0)
    assert (read.span(found.start, found.stop - 1).of(text) if found else "") == expected


def test_what_may_be_tells_of_what_and_how(parser: Parser) -> None:
    assert told(parser, "The attic door might already be locked. If so, go.") == {
        "object": "The attic door",
        "state": "locked",
    }
    assert told(parser, "Make sure the door can be locked.") == {}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Tom and Anna might be in the kitchen.", {"object": "Tom and Anna", "location": "in the kitchen"}),
        ("The shirts and the socks might be dry.", {"object": "The shirts and the socks", "state": "dry"}),
        ("The red light on the boiler might be blinking.", {"object": "The red light", "state": "blinking"}),
        ("We might be out of milk.", {"object": "We", "state": "out of milk"}),
        ("Gwyneth might be poorly, she says.", {"object": "Gwyneth", "state": "poorly"}),
        ("The kids may be outside.", {"object": "The kids", "location": "outside"}),
        ("The lamp might be out of oil again.", {"object": "The lamp", "state": "out of oil"}),
    ],
)
def test_what_may_be_tells_of_its_subject_and_of_its_place(parser: Parser, text: str, expected: dict[str, str]) -> None:
    assert told(parser, text) == expected


def told(parser: Parser, text: str) -> dict[str, str]:
    """What the first "be" of a text says, in words."""
    read = parser.parse(text)
    be = next(token.i for token in read.tokens if token.lower == "be")
    return {name: read.span(t.start, t.stop - 1).of(text) for name, t in predicated(read, be).items()}


def test_to_let_go_of_something_is_to_place_it(parser: Parser) -> None:
    assert found(parser, "Thanks, you can let go of the ladder now.") == [("let", "placing")]
    assert found(parser, "Let it go on charging.") == []
    assert found(parser, "She wants to let go of the rope.") == []


def test_a_polite_request_to_be_troubled_for_something_is_bringing(parser: Parser) -> None:
    assert found(parser, "Might I trouble you for the pepper?") == [("trouble", "bringing")]
    assert found(parser, "Any chance of some toast?") == [("chance", "bringing")]
    assert found(parser, "Any chance of help with the sofa?") == []
    assert found(parser, "Can I bother you for a hand with the sofa?") == []
    assert found(parser, "The kids may bother you for sweets.") == []


@pytest.mark.parametrize(
    ("text", "verb", "thing"),
    [
        ("See how full the jug is, and if it is empty, fill it.", "See", "the jug"),
        ("Find out how warm Anna's room is.", "Find", "Anna's room"),
        ("have a look at how dirty my boots are and clean them", "have", "my boots"),
        ("Check how the soup is.", "Check", ""),
        ("Check how many eggs there are.", "Check", ""),
        ("Check if the jug is full.", "Check", ""),
        ("Show me how to open the jug.", "Show", ""),
    ],
)
def test_what_is_asked_how_much_it_is_so(parser: Parser, text: str, verb: str, thing: str) -> None:
    read = parser.parse(text)
    asked = degree_asked(read, next(token.i for token in read.tokens if token.text == verb))
    assert (read.span(asked.start, asked.stop - 1).of(text) if asked else "") == thing


@pytest.mark.parametrize(
    "text",
    [
        "Hang the coat on the hook and leave.",
        "if the twins are asleep drop the bag and leave",
        "Sweep the floor, then leave without a word.",
        "If the study is dark, leave; otherwise wipe the desk.",
        "Sort the post and leave at once.",
        "Leave and come back later.",
    ],
)
def test_to_leave_and_no_more_is_to_go_away(text: str) -> None:
    tasks = Interpreter.load().interpret(text).tasks
    assert [task.type for task in tasks if task.span.of(text).lower() == "leave"] == ["motion"]


@pytest.mark.parametrize(
    "text",
    [
        "Wash the pans but leave the plates in the sink.",
        "Iron the white shirt. The grey ones, leave.",
        "When I pack up and leave, lock the door.",
        "The guests eat and leave. Wash the plates.",
        "Ask the children to finish and leave.",
        "Cover the dough and leave until it has risen.",
    ],
)
def test_to_leave_something_or_as_others_do_is_not_to_go_away(text: str) -> None:
    tasks = Interpreter.load().interpret(text).tasks
    assert "motion" not in [task.type for task in tasks]


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("Look at the kettle; if cold, switch it on.", "cold"),
        ("look in the sink if still full call me", "full"),
        ("Wipe the shelf unless wet.", "wet"),
    ],
)
def test_a_condition_may_be_no_more_than_a_state(parser: Parser, text: str, state: str) -> None:
    read = parser.parse(text)
    orders = {token.i: "informing" for token in read.tokens if token.lower == "call"}
    assert [read.tokens[i].lower for i, kind in idiomatic(read, orders).items() if kind == "check_state"] == [state]


@pytest.mark.parametrize("text", ["Tell Ann if free.", "Use the dry cloth if wet ones are there.", "Come if possible."])
def test_what_only_looks_like_a_bare_state_is_none(parser: Parser, text: str) -> None:
    read = parser.parse(text)
    orders = {token.i: "informing" for token in read.tokens if token.lower == "tell"}
    assert "check_state" not in idiomatic(read, orders).values()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("If you run into Leo, wave.", "Leo"),
        ("When you bump into the nurse, stop.", "the nurse"),
        ("If you run into the garden, stop.", ""),
    ],
)
def test_whom_one_runs_into_is_found(parser: Parser, text: str, told: str) -> None:
    document = parser.parse(text)
    verb = next(token.i for token in document.tokens if token.lemma in ("run", "bump"))
    met = encountered(document, verb)
    assert (document.span(met.start, met.stop - 1).of(text) if met else "") == told


def test_a_gander_is_a_look_and_no_thing() -> None:
    (task,) = Interpreter.load("household").interpret("Have a gander in the shed for my rake.").tasks
    assert (task.type, task.values("object")) == ("searching", ("for my rake",))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Once you hear the gong, light the candles.", "the gong"),
        ("Lock the shed as soon as you hear the siren.", "the siren"),
        ("Open the gate if you hear a horn.", "a horn"),
    ],
)
def test_what_is_to_be_heard_is_a_check(text: str, said: str) -> None:
    found = [task for task in Interpreter.load().interpret(text).tasks if task.span.of(text) == "hear"]
    assert [(task.type, task.value("object")) for task in found] == [("check_state", said)]


def test_what_is_to_be_heard_may_be_told() -> None:
    (task,) = Interpreter.load().interpret("Tell me when you hear the gong.").tasks
    assert (task.type, task.value("message")) == ("informing", "when you hear the gong")
