"""What is certain of arguments stands whatever the models find."""

from __future__ import annotations

import pytest
from documents import document

from decomplex_bt.understanding.arguments import FoundArgument, FoundArguments
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.amendments import amended
from decomplex_bt.understanding.rules.cases.checks import naming
from decomplex_bt.understanding.rules.spans.completion import answered, completed, reported, retracted
from decomplex_bt.understanding.rules.speech.withdrawals import withdrawals_of

GAZETTEER = Gazetteer({}, {}, frozenset())


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


def arguments(parser: Parser, text: str, tasks: dict[str, str], *found: tuple[str, str, str]) -> set[tuple[str, str]]:
    """The arguments after amendment, as types with words; `found`: a type, its words and the word of its task."""
    read = parser.parse(text)
    observed = Observed(read, GAZETTEER)
    place = {word: next(t.i for t in read.tokens if t.text == word) for word in tasks}

    def tokens(words: str) -> range:
        first = next(t.i for t in read.tokens if text[t.start :].startswith(words))
        return range(first, first + len(parser.parse(words)))

    before = tuple(FoundArgument(kind, place[task], tokens(words), 0.8) for kind, words, task in found)
    types = {place[word]: kind for word, kind in tasks.items()}
    after = amended(observed, types, withdrawals_of(observed), FoundArguments(before, 0.5))
    assert after.probability == 0.5
    return {(a.type, read.span(a.tokens.start, a.tokens.stop - 1).of(text)) for a in after.arguments}


def test_what_is_said_aside_is_no_argument_but_for_places(parser: Parser) -> None:
    text = "Since the cup is in the sink, rinse it."
    found = ("object", "the cup", "rinse"), ("source", "in the sink", "rinse"), ("object", "it", "rinse")
    assert arguments(parser, text, {"rinse": "change_state"}, *found) == {("source", "in the sink"), ("object", "it")}


def test_a_correction_replaces_the_last_argument_that_begins_alike(parser: Parser) -> None:
    text = "Put the milk in the fridge, no, scratch that, in the freezer."
    found = ("object", "the milk", "Put"), ("goal", "in the fridge", "Put"), ("location", "in the freezer", "Put")
    assert arguments(parser, text, {"Put": "placing"}, *found) == {("object", "the milk"), ("goal", "in the freezer")}


@pytest.mark.parametrize(("tasks", "states"), [({}, {("state", "full")}), ({"'s": "check_state"}, set())])
def test_how_much_something_is_so_is_asked_of_it(
    parser: Parser, tasks: dict[str, str], states: set[tuple[str, str]]
) -> None:
    text = "See how full the jug is and if it's dry say so."
    found = ("state", "full", "See"), ("object", "the jug is", "See")
    after = arguments(parser, text, {"See": "check_state", **tasks}, *found)
    assert after == {("object", "the jug"), *states}


def test_no_one_is_no_object(parser: Parser) -> None:
    text = "If no one is in, lock it."
    found = ("object", "one", "is"), ("object", "it", "lock")
    tasks = {"is": "check_state", "lock": "change_state"}
    assert arguments(parser, text, tasks, *found) == {("object", "it"), ("state", "in")}


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


def test_a_phrase_does_not_end_in_an_article() -> None:
    said = document(*(f"{word}/dep/0" for word in "in/IN the/DT old/JJ car/NN and/CC go/VB her/PRP$ bell/NN".split()))
    assert completed(said, range(0, 2), ()) == range(0, 4)
    assert completed(said, range(0, 2), {3}) == range(0, 3)
    assert completed(said, range(0, 4), ()) == range(0, 4)
    assert completed(said, range(6, 7), ()) == range(6, 7)


def test_rid_belongs_to_its_verb() -> None:
    said = document(*(f"{word}/dep/0" for word in "get/VB rid/JJ of/IN it/PRP".split()))
    assert completed(said, range(1, 4), ()) == range(3, 4)
    assert completed(said, range(2, 4), ()) == range(3, 4)


@pytest.mark.parametrize(("thing", "kept"), [("water", ("bring",)), ("some", ("there", "bring"))])
def test_what_a_question_asks_for_is_not_what_the_answer_brings(thing: str, kept: tuple[str, ...]) -> None:
    said = document(*(f"{word}/dep/{i}" for i, word in enumerate(f"milk/NN there/RB ?/. bring/VB {thing}/NN".split())))
    asked, brought = FoundArgument("object", 3, range(0, 1), 0.9), FoundArgument("object", 3, range(4, 5), 0.9)
    there = FoundArgument("source", 3, range(1, 2), 0.9)
    expected = [found for name, found in (("there", there), ("bring", brought)) if name in kept]
    assert answered(said, 3, [asked, there, brought]) == expected
    assert answered(said, 3, [asked, there]) == [asked, there]


@pytest.mark.parametrize(
    ("words", "is_taken_back"),
    [
        ("bring the knife , no , wait , the fork", True),
        ("bring the knife no sorry the fork", True),
        ("bring the knife , I mean the fork", True),
        ("bring the knife or rather the fork", True),
        ("bring the knife and the fork", False),
        ("bring the knife , the fork", False),
        ("bring the knife but no the fork", False),
    ],
)
def test_what_is_taken_back_is_not_meant(words: str, is_taken_back: bool) -> None:
    said = document(*(f"{word}/NN/dep/0" for word in words.split()))
    last = len(said)
    knife, fork = (FoundArgument("object", 0, tokens, 0.9) for tokens in (range(1, 3), range(last - 2, last)))
    assert retracted(said, [knife, fork]) == ([fork] if is_taken_back else [knife, fork])
    elsewhere = FoundArgument("goal", 0, knife.tokens, 0.9)
    assert retracted(said, [elsewhere, fork]) == [elsewhere, fork]


def test_a_place_behind_a_message_is_part_of_it() -> None:
    message, place = FoundArgument("message", 0, range(2, 5), 0.9), FoundArgument("location", 0, range(5, 8), 0.8)
    (whole,) = reported([place, message])
    assert (whole.type, whole.tokens) == ("message", range(2, 8))
    apart = FoundArgument("location", 0, range(6, 8), 0.8)
    assert reported([message, apart]) == [message, apart]
    whom = FoundArgument("recipient", 0, range(5, 7), 0.8)
    assert reported([message, whom]) == [message, whom]


def test_the_it_of_weather_names_nothing() -> None:
    it = [FoundArgument("object", 2, range(1, 2), 0.9)]
    assert naming(document("if", "it", "'s", "still", "raining"), 2, it) == []
    assert naming(document("if", "it", "'s", "still", "wet"), 2, it) == it
    assert naming(document("if", "it", "is", "due", "Monday"), 2, it) == it
    assert naming(document("if", "it", "'s", "a", "Tuesday"), 2, it) == []


def test_the_it_of_cold_weather_names_nothing() -> None:
    it = [FoundArgument("object", 2, range(1, 2), 0.9)]
    assert naming(document("if", "it", "'s", "too", "cold", "outside"), 2, it) == []
    assert naming(document("if", "it", "'s", "cold"), 2, it) == it
    assert naming(document("if", "it", "'s", "dark"), 2, it) == []


@pytest.mark.parametrize(
    ("clause", "names_nothing"),
    [
        ("if it 's stuffy in here", True),
        ("if it is warm enough in the attic", True),
        ("if it gets too loud upstairs", True),
        ("see if it is draughty in there", True),
        ("if it is cold in the middle", False),
        ("if it is hot enough", False),
        ("if it is empty in there", False),
    ],
)
def test_the_it_of_what_it_is_like_somewhere_names_nothing(clause: str, names_nothing: bool) -> None:
    words = clause.split()
    verb = 0 if words[0] == "see" else 2
    it = [FoundArgument("object", verb, range(words.index("it"), words.index("it") + 1), 0.9)]
    assert naming(document(*words), verb, it) == ([] if names_nothing else it)


@pytest.mark.parametrize(("joint", "is_denied"), [("but", True), ("and", False)])
def test_what_is_not_meant_gives_way_to_what_is(joint: str, is_denied: bool) -> None:
    said = document(*(f"{word}/NN/dep/0" for word in f"bring it not to me {joint} to the hall".split()))
    whom, where = FoundArgument("recipient", 0, range(3, 5), 0.9), FoundArgument("goal", 0, range(6, 9), 0.9)
    assert retracted(said, [whom, where]) == ([where] if is_denied else [whom, where])


def test_what_comes_on_top_corrects_nothing() -> None:
    said = document(*(f"{word}/NN/dep/0" for word in "bring the salt sorry the pepper too".split()))
    salt, pepper = (FoundArgument("object", 0, tokens, 0.9) for tokens in (range(1, 3), range(4, 6)))
    assert retracted(said, [salt, pepper]) == [salt, pepper]


def test_an_argument_does_not_end_in_a_preposition() -> None:
    said = document(*(f"{word}/dep/0" for word in "get/VB it/PRP for/IN the/DT old/JJ man/NN now/RB".split()))
    assert completed(said, range(2, 3), ()) == range(2, 6)


def test_the_it_of_what_is_foggy_is_what_was_named() -> None:
    it = [FoundArgument("object", 4, range(3, 4), 0.9)]
    assert naming(document("the", "window", "if", "it", "is", "foggy"), 4, it) == it
    assert naming(document("there/EX/expl/0", "then", "if", "it", "is", "foggy"), 4, it) == it
    nothing = [f"{word}/RB/dep/0" for word in ("so", "then", "if", "it", "is", "foggy")]
    assert naming(document(*nothing), 4, it) == []


@pytest.mark.parametrize(
    ("text", "tasks", "found", "expected"),
    [
        (
            "I need the map, can you bring it to me?",
            {"bring": "bringing"},
            (("object", "the map", "bring"), ("object", "it", "bring"), ("recipient", "to me", "bring")),
            {("object", "it"), ("recipient", "to me")},
        ),
        # who picks something up gives it to nobody
        (
            "I need the map, pick it up.",
            {"pick": "taking"},
            (("recipient", "I", "pick"), ("object", "it", "pick")),
            {("object", "it")},
        ),
        # another thing
        (
            "The map I need, and bring the other one.",
            {"bring": "bringing"},
            (("object", "The map", "bring"), ("object", "the other one", "bring")),
            {("object", "The map"), ("object", "the other one")},
        ),
        (
            "Reach the stage by crossing the hall.",
            {"Reach": "motion"},
            (
                ("goal", "the stage", "Reach"),
                ("object", "the hall", "Reach"),
                ("path", "by crossing the hall", "Reach"),
            ),
            {("goal", "the stage"), ("path", "by crossing the hall")},
        ),
    ],
)
def test_what_is_taken_up_behind_its_verb_and_what_only_tells_the_way_is_no_object(
    parser: Parser,
    text: str,
    tasks: dict[str, str],
    found: tuple[tuple[str, str, str], ...],
    expected: set[tuple[str, str]],
) -> None:
    assert arguments(parser, text, tasks, *found) == expected


def test_where_something_is_spilt_is_where_it_is_cleaned() -> None:
    text = "someone spilled juice on the rug get a cloth and clean it up before it dries"
    get, clean = Interpreter.load().interpret(text).tasks
    assert [(a.type, a.value) for a in get.arguments] == [("object", "a cloth")]
    assert {(a.type, a.value) for a in clean.arguments} == {("location", "on the rug"), ("object", "juice")}


@pytest.mark.parametrize(
    ("text", "objects"),
    [
        ("Fetch the drill along with the long cable.", ["the drill along with the long cable"]),
        ("Carry the stretcher together with a blanket to the gate.", ["the stretcher together with a blanket"]),
        ("Put the candles in the box along with the matches.", ["the candles", "the matches"]),
        ("Take it to him together with his cap and his scarf.", ["it", "his cap and his scarf"]),
        ("Bring the salad with the blue lid.", ["the salad with the blue lid"]),
        ("Put the lids and the pots together.", ["the lids and the pots"]),
        ("Take the photo along to Grandma.", ["the photo"]),
    ],
)
def test_what_comes_along_with_a_thing_is_handled_too(text: str, objects: list[str]) -> None:
    (task,) = Interpreter.load().interpret(text).tasks
    assert [a.span.of(text) for a in task.arguments if a.type == "object" and a.span] == objects


def test_who_somebody_walks_along_with_is_followed() -> None:
    (task,) = Interpreter.load().interpret("Walk along with the nurse to the gate.").tasks
    assert (task.type, task.value("object")) == ("following", "with the nurse")


@pytest.mark.parametrize(
    ("text", "number", "kind", "value"),
    [
        ("If no lamps are on downstairs, come back up.", 1, "object", "lamps"),
        ("If no one is in the den, turn the fan off.", 1, "object", None),
        ("If none of the chairs is free, bring a stool.", 1, "object", "none of the chairs"),
        ("Get the cushions, and if it looks like snow, close the shed.", 2, "object", "it"),
        ("Check the milk, and if it looks sour, tell me.", 2, "object", "the milk"),
        ("Light the lamp, and if the baby wakes up, come and get me.", 3, "object", "me"),
        ("Bring me.", 1, "recipient", "me"),
        ("If the door's open, hand us.", 2, "recipient", "us"),
        ("Get me the paper.", 1, "recipient", "me"),
        ("Bring me my cocoa with two biscuits, please.", 1, "object", "my cocoa with two biscuits"),
        ("Give Dad the blue pills with a glass of water.", 1, "object", "the blue pills with a glass of water"),
        ("Bring me the broth with a ladle.", 1, "object", "the broth with a ladle"),
        ("Give Tom the letter with my regards.", 1, "object", "the letter"),
        ("Throw out the tulips from last week and wash the vase.", 1, "object", "the tulips from last week"),
        ("Take the pies from yesterday out of the fridge.", 1, "source", "out of the fridge"),
        ("Bring the bread from the bakery.", 1, "object", "the bread"),
        (
            "If the jam is off, open the new jar, it's in the larder, and bin the old one.",
            2,
            "location",
            "in the larder",
        ),
        ("If the jam is off, open the new jar, it's in the larder, and bin the old one.", 3, "source", None),
        ("My cup is on the desk. Wash it and bring it here.", 2, "source", "on the desk"),
        ("After we've gone to bed, lock the gate.", 1, "state", "to bed"),
        ("After we've gone to bed, lock the gate.", 1, "object", "we"),
        ("If no one reads the paper, throw it away.", 1, "object", "the paper"),
        ("If nobody comes this morning, lock the gate.", 1, "object", None),
        ("When you've gone to the kitchen, bring me a cup.", 1, "goal", "to the kitchen"),
        ("Shut the gate unless Ann can't come.", 2, "object", "Ann"),
        ("Lay the mugs upside down in the rack.", 1, "manner", "upside down"),
        ("Ask the guest what she'd like and bring her what she asks for.", 2, "object", "what she asks for"),
        ("If we're going to be late, tell Mum.", 2, "recipient", "Mum"),
        ("If we're going to be late, tell Mum.", 2, "object", None),
        ("Tell Tom what Ann wants.", 1, "message", "what Ann wants"),
    ],
)
def test_what_a_phrase_ends_and_begins_with(text: str, number: int, kind: str, value: str | None) -> None:
    assert Interpreter.load().interpret(text).task(number).value(kind) == value


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("If the vase is clean and dry, put it on the shelf.", "clean and dry"),
        ("If the gate is open but not locked, shut it.", "open but not locked"),
        ("If the tin is empty or rusty throw it away.", "empty or rusty"),
        ("If the oven is hot and the pan is clean, call me.", "hot"),
        ("If the vase is clean, and dry leaves are in it, wash it.", "clean"),
    ],
)
def test_a_state_has_the_states_that_are_joined_to_it(text: str, state: str) -> None:
    instruction = Interpreter.load().interpret(text)
    assert instruction.task(1).value("state") == state


def test_what_there_is_is_no_state() -> None:
    task = Interpreter.load().interpret("If there's less than half a jug left, fill it.").task(1)
    assert task.value("object") == "less than half a jug"
    assert "jug" not in (task.value("state") or "")


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("Go to the icebox and see if there is any tea left. If there is, bring me a glass.", "left"),
        ("If there's any rice left over, put it in the fridge.", "left over"),
        ("is there any juice left? if so bring me a glass", "left"),
        ("if there arent any pizzas left get me the noodles", "left"),
        ("If there's any cake left in the tin, bring me a slice.", None),  # it is said where
        ("If you left the lamp on, turn it off.", "on"),
    ],
)
def test_that_something_is_left_is_a_state_of_it_and_nothing_is_missing(text: str, state: str | None) -> None:
    instruction = Interpreter.load().interpret(text)
    checks = [task for task in instruction.tasks if task.type == "check_state"]
    assert checks[0].value("state") == state
    assert not instruction.missing


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("When the broth is hot, bring it with a ladle.", ["the broth", "with a ladle"]),
        ("When the toast is done, bring it to me with some butter.", ["the toast", "with some butter"]),
        ("When the broth is hot, bring it with a trolley.", ["the broth"]),
        ("When the broth is hot, bring it with great care.", ["the broth"]),
    ],
)
def test_what_comes_along_with_what_is_taken_up_is_brought_too(text: str, things: list[str]) -> None:
    assert [a.value for a in Interpreter.load().interpret(text).tasks[-1].arguments if a.type == "object"] == things


@pytest.mark.parametrize("text", ["Bring", "Fill the thermos and bring", "pass"])
def test_a_text_that_ends_in_what_brings_is_read(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).text == text
