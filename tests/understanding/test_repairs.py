"""What is put otherwise in the same breath does not count; what only sounds so does."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.remainder import without
from decomplex_bt.understanding.rules.speech.repairs import repaired

WORDS = "if it is no , um open the door - sorry . close get I mean and then".split()


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.load("household", encoder=False)


def left(parser: Parser, text: str) -> str:
    document = parser.parse(text)
    return without(document, repaired(document)).text


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("If it's, uh, if it's not hot, heat it.", "if it's not hot, heat it."),
        ("Turn on the, turn on the lamp.", "turn on the lamp."),
        ("It's raining, isn't it? Shut it.", "It's raining? Shut it."),
        ("You fed her, didn't you? If not, do.", "You fed her? If not, do."),
        ("I said, didn't I, that it's on.", "I said, didn't I, that it's on."),
        ("Is it on, or isn't it? Tell me.", "Is it on, or isn't it? Tell me."),
        ("Is - is there any tea?", "is there any tea?"),
        ("get the get the get the ball and throw it", "get the ball and throw it"),
        ("Put it on the, on the shelf.", "Put it on the shelf."),
        ("Close it, then, um, then lock it.", "Close it, then lock it."),
        ("Bring me the, the red mug.", "Bring me the red mug."),
        ("turn on the the lamp", "turn on the lamp"),
        ("If the tank's, actually forget the tank, if the tray's full, empty it.", "if the tray's full, empty it."),
        ("When Tom, if he's, um, when Tom gets in, call me.", "when Tom gets in, call me."),
        ("if he's up um if he's dressed I mean follow him", "if he's dressed I mean follow him"),
        ("ask Colin no he's at bowls ask Meg", "ask Meg"),
        ("get the green bin oh no it's Monday get the brown bin", "get the brown bin"),
        ("if he's up if Theo's up that is bring me the milk", "if Theo's up that is bring me the milk"),
        (
            "put the fan on no hang on if it's really rather warm in here put the fan on",
            "if it's really rather warm in here put the fan on",
        ),
        ("If Dan's in, no, he's at work. If Eva's in, tell her.", "If Eva's in, tell her."),
        ("tell you what go to the shed", "go to the shed"),
        ("I'll tell you what, if it's wet, dry it.", "if it's wet, dry it."),
        ("The trouble is that the hatch is open, so close it.", "the hatch is open, so close it."),
        ("the thing is the stove's too hot so turn it down", "the stove's too hot so turn it down"),
        ("All I want is the ladle, and turn the stove off.", "I want the ladle, and turn the stove off."),
        ("What we'd really like is a jug of water.", "we'd really like a jug of water."),
        ("The problem is, Lea is asleep. Close the door.", "Lea is asleep. Close the door."),
        ("if any are ripe put them put two of them in a jar", "if any are ripe put two of them in a jar"),
        ("put the forks put the spoons in the drawer", "put the spoons in the drawer"),
        ("if it's loud um if it is tell bea", "if it's loud if it is tell bea"),
        ("lay the er cloth on the uh bench", "lay the cloth on the bench"),
        ("hand me the you know round tray", "hand me the round tray"),
        ("see if it's wide uh you know tell leo", "see if it's wide tell leo"),
        (
            "Put the vase here, no, if it's cracked put it outside.",
            "Put the vase here, if it's cracked put it outside.",
        ),
    ],
)
def test_what_is_said_over_again_counts_once(parser: Parser, text: str, meant: str) -> None:
    assert left(parser, text) == meant


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("If he's in the den, tell him, no, switch the radio off.", "If he's in the den, switch the radio off."),
        ("Scrape the toast, or no, actually, throw the toast away.", "throw the toast away."),
        ("Bring Ann the post, wait, bring Tom the paper instead.", "bring Tom the paper instead."),
        ("Bring me a juice, no wait, I'll have milk.", "I'll have milk."),
        ("I'd like a roll, sorry, I'll have toast.", "I'll have toast."),
        ("Close the gate, actually close the shed.", "close the shed."),
        ("Switch the oven on, actually the grill.", "Switch on the grill."),
        ("Put it on the desk, hmm, better on the shelf.", "Put it on the shelf."),
        ("Bring me the ladder, on second thoughts, the stool.", "Bring me the stool."),
        ("Get the red pan, no, not that one, the flat one.", "Get the red pan, no, the flat one."),
        ("Wash the cups and shout, I mean, call Anna.", "Wash the cups and call Anna."),
        ("Bring me the, no, take the blue mug.", "take the blue mug."),
        ("Put it in the box, no, sorry, on the shelf.", "Put it on the shelf."),
        ("go to the shed uh no not the shed the garage and wait", "go to the garage and wait"),
        ("Put it in the oven, no, not in the oven, in the fridge.", "Put it in the fridge."),
        ("look in the drawer no wait look under the bed for the cat", "look under the bed for the cat"),
        ("Find the, what's it called, the stud finder.", "Find the stud finder."),
        ("if the tank's full i mean if the tray's full empty it", "if the tray's full empty it"),
        ("If it's hot, turn it down, no, turn the heater off.", "If it's hot, turn the heater off."),
        ("Fetch the, not the green one, the red can.", "Fetch the red can."),
        ("Light the lamp. Actually, switch the torch on instead.", "switch the torch on instead."),
        ("Bring Ann the mail. Actually, bring Joe the mail.", "bring Joe the mail."),
        ("Get the mop. No wait, get the broom. Sweep it.", "get the broom. Sweep it."),
        ("Could you get the mop? No, sorry, could you get the broom?", "Could you get the broom?"),
        ("Open the door and turn on... no, just close it.", "Open the door and close it."),
        ("If it's broken, heat... well, just bring me the soup.", "If it's broken, bring me the soup."),
        ("Water the plants and… no, just shut the blinds.", "shut the blinds."),
        ("Water the plants and… no, shut the blinds.", "Water the plants and shut the blinds."),
        ("Go and see if Tom wants... no wait, just take the tea.", "Go and take the tea."),
        ("Look behind... look under the sofa.", "look under the sofa."),
    ],
)
def test_an_order_in_place_of_another_is_the_only_one(parser: Parser, text: str, meant: str) -> None:
    assert left(parser, text) == meant


@pytest.mark.parametrize(
    "text",
    [
        "If the oven is open, open it further.",
        "put them away put the kettle on",
        "put that there put this here",
        "do you know if the gate is open",
        "tell leo you know the way",
        "Switch the heater up, no, switch it off.",
        "Please, please close the door.",
        "Bring me the mug, actually it's dirty, so wash it first.",
        "Put the vase where it looks better, then wipe the shelf.",
        "Switch the fan on, wait a minute, switch it off.",
        "Check the lamp, check the heater and tell me.",
        "Knock, then knock again.",
        "Turn it off. Turn it off in the hall as well.",
        "Close the gate. Actually, close the shed too.",
        "Sweep the hall. Actually, the lamp is on, so turn it off.",
        "Go to the kitchen, no wait, go to the bathroom first.",
        "If yes, serve the soup, if no, heat the soup.",
        "Say no, thanks, and close the door.",
        "Hoover the stairs, no, forget the stairs.",
        "Switch it off, wait, and switch it on again.",
        "Close the window, no, leave it open.",
        "See if she is in, no, he is out.",
        "Before you lay the table, I mean, lock the hutch.",
        "Carry the keg to the well, fill it and come back.",
        "If there's no cup, bring a mug, and if there's no mug, bring a glass.",
        "If she is in, say I'm sorry, and if she is out, come back.",
        "In the event that he rings ask him to wait, in the meantime get him tea.",
        "If the bins are full, and, uh, if the gate is open, take them out.",
        "Is there milk? If yes, bring it to me, if no, bring it to Dad.",
        "If he's awake, um, if he's dressed, follow him.",
        "Get a loaf, oh, but before that get some change.",
        "Turn the lamp off, oh, turn the fan off.",
        "Put the kettle on, oh how lovely, put some biscuits on a plate.",
        "Feed the cat oh she'll be so happy feed the dog.",
        "Shake the bottle, wait until it settles, shake the bottle once more.",
        "If the oven is on turn it off and if the pan is hot I mean, leave it.",
        "If Anna calls, if she asks what I mean tell her the recipe.",
        "Take it to Anna, no, not Anna the cat, Anna the neighbour.",
        "Put it on the table, sorry, not the table in the hall, the table in the den.",
        "Bring the red cup, no, not the red cup, he likes that one.",
        "If Dan's in, no, he's at work. If he's at work, call him.",
        "If there's no one in, no, he's at work. Close the door.",
        "tell him no he can't and tell her yes",
        "Put the red one away, no, not today.",
        "Turn on the tv. No luck? Bring me the remote.",
        "If the tea is hot, bring it. No, heat it.",
        "Bring me the mug. No, wait, wash it first.",
        "Look in the drawer. No, then look on the shelf.",
    ],
)
def test_what_is_no_repair(parser: Parser, text: str) -> None:
    assert left(parser, text) == text


def test_spans_are_those_of_the_whole_text(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If it's, uh, if it's not hot, heat the soup in the, uh, in the pan.")
    assert found.text.startswith("If it's, uh, if")
    assert [(task.span.of(found.text), task.span.start) for task in found.tasks] == [("'s", 18), ("heat", 30)]
    assert {a.type: a.value for a in found.tasks[1].arguments}["object"] == "the soup"
    assert found.flow.to_json() == [{"if": 1, "else": [2]}]


def test_of_a_phrase_put_otherwise_behind_its_preposition_the_last_saying_is_meant(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring the lamp to the kitchen, no, the snug.")
    assert [(a.span.of(found.text), a.value) for a in found.tasks[0].arguments if a.type == "goal" and a.span] == [
        ("the snug", "the snug")
    ]


def test_a_pronoun_in_the_order_that_counts_finds_what_the_other_named(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Close the window, no, leave it open.")
    (task,) = found.tasks
    assert [a.value for a in task.arguments if a.type == "object"] == ["the window"]


def test_an_order_in_place_of_the_one_before_is_no_answer(interpreter: Interpreter) -> None:
    read = interpreter.interpret("Close the front door. Actually no, open it.")
    assert [read.text[task.span.start : task.span.end] for task in read.tasks] == ["open"]
    assert read.flow.to_json() == [1]


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=14))
def test_something_is_left_of_everything_and_stands_where_it_did(words: list[str]) -> None:
    text = " ".join(words)
    document = _PARSER.parse(text)
    rest = without(document, repaired(document))
    assert bool(rest.text) == bool(document.tokens)
    assert len(rest.text) == len(rest.places)
    assert all(text[place] == c for c, place in zip(rest.text, rest.places, strict=True) if not c.isspace())
    assert list(rest.places) == sorted(rest.places)


_PARSER = Parser()


@pytest.mark.parametrize(
    "text",
    [
        "Turn the router off, wait thirty seconds, turn it back on.",
        "Go to the front door, wait for Anna, go with her to the car.",
        "If you can find my glasses bring them up, no problem if you can't.",
        "If it's hot, bring me juice, no ice, if it's cold, bring me tea.",
        "Put the red box on the shelf, um, put the blue box on the floor.",
        "Put the toys in the box, sorry about the mess, and vacuum the carpet.",
        "Could you put the kettle on, sorry, could you also let the dog out?",
        "If the salesman rings again, tell him no, close the door.",
        "Go to room A, then fetch the box.",
        "Go from room to room to see if the windows are shut.",
        "Turn left, turn left again, and go in.",
        "Take the key from the locker no 7.",
        "Put the spoons in the thingy by the stove.",
        "Anna will tell you what to do.",
        "What I need is for you to close the hatch.",
        "What I want you to do is close the hatch.",
        "The trouble is the hatch. Close it.",
        "The thing on the bench is a lamp. Bring it to me.",
        "Let me tell you what happened.",
    ],
)
def test_words_that_also_mend_are_often_meant(parser: Parser, text: str) -> None:
    assert left(parser, text) == text


def test_an_um_behind_a_preposition_leaves_it_with_its_place() -> None:
    text = "put the um blue cup on uh the table"
    (put,) = Interpreter.load(encoder=False).interpret(text).tasks
    told = {a.type: (a.value, a.span.of(text)) for a in put.arguments if a.span is not None}
    assert told == {"object": ("the blue cup", "the um blue cup"), "goal": ("on the table", "on uh the table")}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bring me my passport - sorry, notebook.", ["my notebook"]),
        ("Bring me my passport, no, notebook, from the desk.", ["my notebook"]),
        ("Bring me the coffee, no milk.", ["the coffee"]),
        ("Close the hatch, sorry, please, and the gate.", ["the hatch", "the gate"]),
        ("Turn off whichever of the lamp and the heater is on.", ["whichever of the lamp and the heater is on"]),
    ],
)
def test_a_bare_noun_stands_in_place_of_the_last_one(interpreter: Interpreter, text: str, expected: list[str]) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert [argument.value for argument in task.arguments if argument.type == "object"] == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Turn the fryer on, no, off!", "off"),
        ("Switch the fan off - sorry, on.", "on"),
        ("Turn the fan on, please.", "on"),
    ],
)
def test_the_other_particle_stands_in_place_of_the_first(interpreter: Interpreter, text: str, expected: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.value("state") == expected


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Throw them in the hamper, no wait just put em on the bench.", "put em on the bench."),
        ("Set it on the sill, no wait, set it on the stool.", "set it on the stool."),
        (
            "Take the jar off the lower rack, correction, upper rack, and open it.",
            "Take the jar off the upper rack, and open it.",
        ),
        ("Bring me the green scarf, sorry, grey scarf.", "Bring me the grey scarf."),
        ("Peel it and - no, not on the rug, set it on the bench.", "Peel it and set it on the bench."),
    ],
)
def test_what_is_put_right_in_a_few_words(parser: Parser, text: str, meant: str) -> None:
    document = parser.parse(text)
    assert without(document, repaired(document)).text == meant


@pytest.mark.parametrize(
    "text", ["Close the hatch, no wait, leave it open.", "Make the correction, then bring me the sheet."]
)
def test_what_takes_up_the_order_before_or_is_a_thing_is_no_repair(parser: Parser, text: str) -> None:
    assert not repaired(parser.parse(text))


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Bring me the mug (the blue one) and the plate.", "Bring me the mug and the plate."),
        ("Bring me the mug (and the plate).", "Bring me the mug and the plate."),
    ],
)
def test_what_brackets_only_name_again_or_add(parser: Parser, text: str, meant: str) -> None:
    document = parser.parse(text)
    assert without(document, repaired(document)).text == meant


@pytest.mark.parametrize("text", ["Water the ferns (not the cactus!).", "Get the rope (ask Lea first) and tie it up."])
def test_what_brackets_except_or_order_stays(parser: Parser, text: str) -> None:
    assert not repaired(parser.parse(text))


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Open the hatch, no, close it.", "close it"),
        ("Fill the crate, sorry, empty it.", "empty it"),
        ("Rinse the forks, no, dry them.", "dry them"),
    ],
)
def test_an_order_that_looks_like_a_state_stands_in_place_of_another(
    interpreter: Interpreter, text: str, meant: str
) -> None:
    found = interpreter.interpret(text)
    assert found.to_json()["flow"] == [1]
    assert found.tasks[0].span.of(text) == meant.split()[0]


@pytest.mark.parametrize("text", ["Is the hatch open? No, close it.", "If the forks are wet, no matter, dry them."])
def test_an_answer_or_a_remark_takes_no_order_back(interpreter: Interpreter, text: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == ["check_state", "change_state"]


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("Bring me the, um, ladle.", "the ladle"),
        ("Take this, er, box to the shed.", "this box"),
        ("Fetch my, uh, slippers.", "my slippers"),
        ("Get the, um, plug out of the basin.", "the plug"),
        ("Dust the uhm, bookcase.", "the bookcase"),
        ("Fetch my big er, cardigan.", "my big cardigan"),
        ("Bring me the knives, er, forks and spoons.", "the knives, forks and spoons"),
        ("Wash the baby's uh, bib.", "the baby's bib"),
    ],
)
def test_a_hesitation_between_marks_parts_no_phrase(text: str, thing: str) -> None:
    (task,) = Interpreter.load().interpret(text).tasks
    assert task.value("object") == thing


@pytest.mark.parametrize(
    ("text", "left_over"),
    [
        ("Look in, um, the shed.", "Look in the shed."),
        ("Put it on erm, his desk.", "Put it on his desk."),
        ("Ask her to uhm, water it.", "Ask her to water it."),
        ("Fill the jug, um, then bring it.", "Fill the jug, um, then bring it."),
        ("Go to the kitchen, er, if it is empty.", "Go to the kitchen, er, if it is empty."),
        ("If the light's on, um, switch it off.", "If the light's on, um, switch it off."),
        ("Put it in, um, close the door.", "Put it in, um, close the door."),
        ("Turn it on, um, dinner goes in at six.", "Turn it on, um, dinner goes in at six."),
        ("Put it on um... The lamp is hot.", "Put it on um... The lamp is hot."),
        ("If it is his, uh, put it back.", "If it is his, uh, put it back."),
        ("If the, uh, mug is dirty, wash it.", "If the mug is dirty, wash it."),
        ("Give it to Umm Khalid or take it to the ER.", "Give it to Umm Khalid or take it to the ER."),
    ],
)
def test_a_hesitation_goes_with_its_marks_where_words_belong_to_what_is_ahead(
    parser: Parser, text: str, left_over: str
) -> None:
    assert left(parser, text) == left_over


@pytest.mark.parametrize(
    ("text", "type", "expected"),
    [
        ("carry the tray to grandma, i mean grandpa", "recipient", "grandpa"),
        ("lend it to ben, no, kate", "recipient", "kate"),
        ("Fetch the scarf for Eva, sorry, Max.", "recipient", "Max"),
        ("fetch me two plates, wait no five", "object", "five"),
        ("Carry the tray to Eva, no rush.", "recipient", "to Eva"),
        ("Carry the tray to Eva, Max is out.", "recipient", "to Eva"),
    ],
)
def test_who_is_named_bare_and_a_number_stand_in_place(
    interpreter: Interpreter, text: str, type: str, expected: str
) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.value(type) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Fetch me the green towel, not the green one, the white one.", "the white towel"),
        ("Lend Tom the torch. No, not that one, the small one.", "the small torch"),
        ("Get the jacket. Not that one, the brown one.", "the brown jacket"),
        ("Lend me the fan, no, the small one.", "the small fan"),
        ("Get the jacket. Not that one.", "the jacket"),
    ],
)
def test_one_of_several_is_denied_and_another_named(interpreter: Interpreter, text: str, expected: str) -> None:
    (task,) = interpreter.interpret(text).tasks
    assert task.value("object") == expected
