"""Further cases: refused, lacking, found nowhere, opposite; and what is told whatever they are."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        # not to be forgotten is ordered
        ("Don't forget to switch off the fan if you leave the flat.", [{"if": 2, "then": [1]}]),
        ("Don't forget to bolt the gate unless Dad is still out.", [{"if": 2, "else": [1]}]),
        ("Don't switch off the fan if you leave the flat.", [{"if": 2, "else": [1]}]),
        # served before it is refused
        ("Take Joe this pie, and if he doesn't want it, put it in the fridge.", [1, {"if": 2, "else": [3]}]),
        ("Put the tuna in the dish. If the cat doesn't eat it, put the dish away.", [1, {"if": 2, "else": [3]}]),
        ("Bring Ann the pie if she wants it.", [{"if": 2, "then": [1]}]),
        # two things to check, and a report
        ("Check whether the hatch is shut and the hob is off, and tell me.", [1, 2, 3]),
        # in neither place
        (
            "If my bag is in the hall bring it here, if it's in the car leave it, and if you can't find it, tell me.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "else": [{"if": 4, "else": [5]}]}]}],
        ),
        # none left where it is fetched from
        (
            "If the soap is running low, put one in the bathroom, and if there are none left in the shed, tell Kim.",
            [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}],
        ),
        ("Look for eggs and milk, and if there's no milk, tell Ann.", [1, {"if": 2, "else": [3]}]),
        ("Look for milk, and if there's no milk, tell Ann.", [{"if": [1, 2], "else": [3]}]),
        # the other of two cases, where nothing comes of the first
        ("Check the stove. If it's hot leave it, but if it's cooled down give it a wipe.", None),
        ("Check the grill. If it's hot leave it, but if it's cold wipe it.", None),
    ],
)
def test_what_a_further_case_says(interpreter: Interpreter, text: str, wanted: Any) -> None:
    found = flow(interpreter, text)
    if wanted is None:  # the check may be the condition or come before it
        assert [node["else"] for node in found if isinstance(node, dict) and "then" not in node] == [[4]]
    else:
        assert found == wanted


@pytest.mark.parametrize(
    ("text", "verb", "kind", "value"),
    [
        ("Check the letterbox. Anything from the bank goes on my desk.", "goes", "goal", "on my desk"),
        ("Check the stove. If it's cold, give it a wipe.", "give", "object", "the stove"),
        ("Give the shelf a rinse if it's sticky.", "Give", "object", "the shelf"),
    ],
)
def test_what_is_said_of_it(interpreter: Interpreter, text: str, verb: str, kind: str, value: str) -> None:
    task = next(task for task in interpreter.interpret(text).tasks if task.span.of(text) == verb)
    assert task.values(kind) == (value,)


def test_what_serves_stands_ahead_of_a_further_case(interpreter: Interpreter) -> None:
    text = "Bring me the red pen; if it's not there, a blue one will do, and if there are no pens, bring me a pencil."
    assert [task.value("object") for task in interpreter.interpret(text).tasks][2] == "a blue pen"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the soup is cold, heat it. If there's no soup, fry an egg.",
            [{"if": 1, "then": [2]}, {"if": 3, "else": [4]}],
        ),
        (
            "If the jar is full, bring it to me. If there's no jar, bring me a bowl.",
            [{"if": 1, "then": [2]}, {"if": 3, "else": [4]}],
        ),
        (
            "If the bath is too hot, turn it down. If it's too cold, turn it up.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        (
            "If the sauce is too thick, add water. If it's too thin, let it simmer.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        (
            "Check whether the bath is warm enough. If it's too cold, run some more water.",
            [{"if": 1, "else": [{"if": 2, "then": [3]}]}],
        ),
        (
            "See if the ladder is long enough. If it's too short, fetch Tom.",
            [{"if": 1, "else": [{"if": 2, "then": [3]}]}],
        ),
        (
            "Is the soup hot enough? If it's too hot, leave it on the sill.",
            [{"if": 1, "then": [{"if": 2, "then": [3]}]}],
        ),
        (
            "If the broth is too salty, bring me water. If it's not salty enough, bring me the salt.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "else": [4]}]}],
        ),
        (
            "If the sign is on, turn it off. If it's flickering, tell me.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        (
            "If the jug has fallen over, pick it up, and if it's cracked, bring me a cloth.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
    ],
)
def test_what_may_both_be_so_or_neither_is_asked_twice(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "If the stove is on, turn it off. If it's smoking, open the hatch.",
        "If the dryer is running, stop it. If it's leaking, call me.",
        "If the kettle is empty, fill it. If it's dirty, wash it.",
    ],
)
def test_what_else_is_the_matter_is_asked_in_any_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("If the tea is hot, bring it. If it's cold, heat it.", [{"if": [1, 3], "then": [2], "else": [4]}]),
        ("If the paint is thick, stir it. If it's thin, fetch a pot.", [{"if": [1, 3], "then": [2], "else": [4]}]),
        ("If there's cocoa, heat it. If there's no cocoa, bring me tea.", [{"if": [1, 3], "then": [2], "else": [4]}]),
        (
            "If the tea is too hot, add milk. If it isn't too hot, bring it.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        (
            "If the stove is warm, unplug it. If it's smoking on top of that, call me.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
    ],
)
def test_the_other_side_of_a_case_is_asked_once(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Start the dryer if Kim is home. When it's done, empty it.",
        "Start the dishwasher if it's full. When it's done, empty it.",
        "Turn on the stove if Tom is home. When it's hot, put the beans in.",
    ],
)
def test_what_an_order_in_a_case_comes_to_is_waited_for_there(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1, {"if": 3, "then": [4]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Take the rubbish out, then, if it isn't raining, the papers too.", [1, {"if": 2, "else": [3]}]),
        ("Water the ferns, then, if it's hot, the roses too.", [1, {"if": 2, "then": [3]}]),
        ("Sweep the yard, then, if it's dry, paint it.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_what_comes_on_top_in_a_case_keeps_from_no_order_before(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Take the tray to Gran. If she doesn't want it, give it to Dad, and if he doesn't either, put it in the oven.",
        "Ask Sid. If he doesn't know, ask Lea, and if she doesn't either, come back.",
        "Give Kim the pie. If she doesn't eat it, give it to Tom, and if he doesn't either, throw it away.",
    ],
)
def test_what_a_second_one_does_not_do_either_is_asked_of_that_one(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 2, "else": [3, {"if": 4, "else": [5]}]}]


def test_what_is_said_again_of_the_first_one_is_the_same_case(interpreter: Interpreter) -> None:
    text = "Take the tray to Gran. If she doesn't want it, give it to Dad, and if she does, tell me."
    assert flow(interpreter, text) == [1, {"if": [2, 4], "then": [5], "else": [3]}]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            "Is the crate empty? If so, close it. If not, empty it and put the lid in the shed or, should the shed be "
            "locked, give it to Tom.",
            [{"if": 1, "then": [2], "else": [3, {"if": 5, "then": [6], "else": [4]}]}],
        ),
        (
            "If Kim is home, take the cello to her room and, unless the bow is in the case, call me.",
            [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}],
        ),
        # what stands in place of the order ahead is no addition
        (
            "Take the form to Kim and, if she's asleep, leave it on her desk.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Wipe the slate and, if the fan is on, switch it off.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_a_case_set_off_behind_an_or_or_an_and(interpreter: Interpreter, text: str, wanted: list[Any]) -> None:
    assert flow(interpreter, text) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            "If Tessa wants cocoa, heat the pan, and when it steams, take it off the hob.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "If the nurse is here, open the tap, and if it drips, tell her.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        ("If Tessa is home, ring the bell, and if she isn't, come back.", [{"if": [1, 3], "then": [2], "else": [4]}]),
    ],
)
def test_what_a_thing_does_is_no_mention_of_where_somebody_is(
    interpreter: Interpreter, text: str, wanted: list[Any]
) -> None:
    assert flow(interpreter, text) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("If the fan is on, switch it off, otherwise leave it, and close the hatch.", [{"if": 1, "then": [2]}, 3]),
        ("If the pup is hungry, feed it, if not just let it sleep, and shut the hatch.", [{"if": 1, "then": [2]}, 3]),
        # an order goes on
        (
            "If the shirt is clean, iron it. If not, soak it, and iron the blue one.",
            [{"if": 1, "then": [2], "else": [3, 4]}],
        ),
    ],
)
def test_what_is_added_to_an_otherwise_that_orders_nothing(
    interpreter: Interpreter, text: str, wanted: list[Any]
) -> None:
    assert flow(interpreter, text) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        # an exception to the order ahead
        (
            "Walk Grandad to the hall, except that if he's tired, walk him to the lounge.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Rinse the vases, except that if one is chipped, throw it out.", [1, {"if": 2, "then": [3]}]),
        # both wait for it
        ("Turn off the telly and shut the hatch, but not until Kim has left.", [3, 1, 2]),
        ("Dry it, and put it away, but not until Kim is back.", [1, 3, 2]),
        # who was asked may know or not
        (
            "Look for the whisk in the hall. If it isn't there, ask Kim where it is, and if she doesn't know, tell me.",
            [{"if": [1, 2], "else": [3, {"if": 4, "else": [5]}]}],
        ),
        # empty is what has nothing in it
        ("See if there's any seed in the tray. If it's empty, fill it.", [{"if": [1, 2], "else": [3]}]),
        (
            "If there's any jam, bring it, and if the jug is empty, fill it.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        # for instance
        ("If you find anything, a scarf, say, or a glove, put it in the crate.", [{"if": 1, "then": [2]}]),
        # what went is not back
        (
            "If the power goes off, light a candle. If it's not back in an hour, call Kim.",
            [{"if": 1, "then": [2, {"if": 3, "else": [4]}]}],
        ),
        (
            "If the power is off, light a candle, and if it's on, call Kim.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
    ],
)
def test_cases_of_written_requests(interpreter: Interpreter, text: str, wanted: list[Any]) -> None:
    assert flow(interpreter, text) == wanted


def test_a_case_in_a_list_stands_for_the_order_of_the_same_verb(interpreter: Interpreter) -> None:
    text = (
        "If the rug is wet, wring it out, shake it and put it on the line, or, if there's no room, put it on the rack."
    )
    assert flow(interpreter, text) == [{"if": 1, "then": [2, 3, {"if": 5, "then": [4], "else": [6]}]}]


def test_what_may_turn_up_is_put_elsewhere_besides(interpreter: Interpreter) -> None:
    text = "Carry the rugs down to the cellar. If you find a sock, put it in the drawer."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Light the stove. If the fire smokes, put it out and call me.", "change_state"),
        ("If the candles are still burning, put them out.", "change_state"),
        ("Take the crate and put it out.", "placing"),
        ("The lamp is broken, put it out on the porch.", "placing"),
    ],
)
def test_what_burns_is_put_out(interpreter: Interpreter, text: str, kind: str) -> None:
    assert next(t.type for t in interpreter.interpret(text).tasks if t.span.of(text) == "put") == kind


@pytest.mark.parametrize(
    "text",
    [
        "If the pan is full, bring it to me. If there's no pan, bring me a bowl.",
        "If the milk is warm, give it to the cat. If there's no milk, call Kim.",
    ],
)
def test_that_there_is_none_is_asked_besides_its_state(interpreter: Interpreter, text: str) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == [{"if": 1, "then": [2]}, {"if": 3, "else": [4]}]
