"""The second branch of a condition, and a second condition beside the first, however they are told."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    "text",
    [
        "See if the lantern is on. Turn it off if it is, otherwise go to the cellar and close the blinds.",
        "Is the jug full? Empty it if it is, otherwise fill it and bring it to Lea.",
        "See if the hatch is open. Close it if it is, otherwise go to the attic and turn on the lantern.",
    ],
)
def test_what_goes_on_with_an_otherwise_is_on_its_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4, 5]}]


@pytest.mark.parametrize(
    "text",
    [
        "If the jug is full, empty it; if it is empty, fill it; otherwise bring it to me.",
        "If the soup is hot, serve it; if it's cold, heat it; if neither, tell Lea.",
    ],
)
def test_two_opposite_states_and_the_rest_are_three_cases(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4], "else": [5]}]}]


def test_two_opposite_states_are_two_sides(interpreter: Interpreter) -> None:
    text = "If the jug is full, empty it; if it is empty, fill it, and bring it to me in any case."
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2], "else": [4]}, 5]


@pytest.mark.parametrize(
    "text",
    [
        "Open the hatch if it is sunny, or light the stove if it is raining.",
        "Lay the rug on the wall if it is wet, or on the floor if it is torn.",
        "Bring me the jug if it is clean, or if it is broken, bring me the bowl.",
    ],
)
def test_an_or_leads_to_a_case_of_its_own(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    (first,) = found.to_json()["flow"]
    assert first["then"] == [1]
    assert len(first["else"]) == 1
    assert first["else"][0]["then"] in ([3], [4])


def test_a_second_place_may_have_its_own_case(interpreter: Interpreter) -> None:
    found = interpreter.interpret("Bring the jug to Lea if she is awake, or to Kim if she isn't.")
    assert found.to_json()["flow"] == [{"if": [2, 4], "then": [1], "else": [3]}]
    assert found.tasks[2].value("recipient") == "to Kim"
    assert found.tasks[2].value("object") == "the jug"


def test_two_parts_of_one_case_stay_together(interpreter: Interpreter) -> None:
    text = "Call me if it rains, or if it snows."
    assert flow(interpreter, text) == [{"if": 2, "then": [1], "else": [{"if": 3, "then": [{"same": [1]}]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the study is empty, go in and close the hatch; if the hatch is already closed, just light the stove.",
            [{"if": 1, "then": [2, {"if": 4, "then": [5], "else": [3]}]}],
        ),
        (
            "If the stove's out, light it. If it's lit already, just put the kettle on.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
    ],
)
def test_what_is_so_already_is_asked_ahead_of_its_order(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


def test_what_is_done_before_that_is_of_the_same_case(interpreter: Interpreter) -> None:
    text = "If the sack is empty, go to the barn, but before that, put down the jug."
    assert flow(interpreter, text) == [{"if": 1, "then": [3, 2]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If there is no bread, bring me crackers or, failing that, a pear.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
        (
            "If Lea isn't in, give the jug to Kim or, failing that, to Ann.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
    ],
)
def test_a_fallback_may_be_for_the_order_of_a_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Switch on the stove. If it's dirty, wipe it before switching it on.",
            [{"if": 2, "then": [3]}, {"same": [1, 4]}],
        ),
        ("Bring me the jug. If it's dirty, wash it before you bring it.", [{"if": 2, "then": [3]}, {"same": [1, 4]}]),
    ],
)
def test_what_comes_before_an_order_said_again_goes_ahead_of_it(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Bring me a soda. If there is no soda, bring me a tea. If there is no tea either, bring me water.",
            [{"if": 2, "then": [1], "else": [{"if": 4, "then": [3], "else": [5]}]}],
        ),
        (
            "Bring me milk. If there is no milk, bring me oat milk. If there is no oat milk either, bring me cream.",
            [{"if": 2, "then": [1], "else": [{"if": 4, "then": [3], "else": [5]}]}],
        ),
    ],
)
def test_each_lack_is_of_what_was_named_last(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If Lea's awake, ask her whether she wants soup. If she does, bring her a bowl.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        ("Shut the hatch, unless Lea's in there, and then feed the goat.", [{"if": 2, "else": [1]}, 3]),
        (
            "Put the crate in the barn, unless it's full, then put it in the shed.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Close the hatch, if it's open, and bring me a towel.", [{"if": 2, "then": [1]}, 3]),
        ("Sweep the attic, if you haven't already, and empty the sack.", [{"if": 2, "else": [1]}, 3]),
        ("See if it's raining and tell me.", [1, 2]),
        ("See if the hatch is open and close it.", [{"if": 1, "then": [2]}]),
        ("Take the crate out to the road. If the gate is locked, open it.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_what_hangs_on_no_case_or_on_an_answer(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Bring me a pear. Or a plum, if the pears are still green.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Put it on the bench. Or on the shelf, if the bench is full.", [{"if": 3, "then": [2], "else": [1]}]),
        ("Light the lantern. And the stove, if it's cold.", [1, {"if": 3, "then": [2]}]),
        ("Call Kim. And Lea, unless she's asleep.", [1, {"if": 3, "else": [2]}]),
        ("Wash the van. And if it's dark, light the lantern.", [1, {"if": 2, "then": [3]}]),
    ],
)
def test_an_afterthought_has_its_own_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Bring me a ladle, and if they're all dirty, a fork.",
        "Bring me the blue rug, and if it's wet, the white one.",
        "Fetch the jug, and if it's broken, fetch the bowl.",
    ],
)
def test_what_is_fetched_where_the_first_is_of_no_use_stands_in_its_place(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [3], "else": [1]}]


def test_what_is_fetched_besides_stands_in_no_place(interpreter: Interpreter) -> None:
    text = "Bring me the paper and, if it's still hot, bring me the coffee."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Take the capes upstairs. If Lea's asleep, close her door.",
        "Bring the board up. If the hatch is locked, ask my sister for the key.",
    ],
)
def test_what_is_fetched_is_so_whatever_else_is_the_case(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Bring the horn from the cabinet. If the cabinet is locked, the key is in the drawer.",
        "Feed the hens. If the sack's empty, there's another one in the barn.",
    ],
)
def test_where_something_is_in_a_case_keeps_nothing_from_the_order(interpreter: Interpreter, text: str) -> None:
    assert 1 in flow(interpreter, text)


@pytest.mark.parametrize(
    "text",
    [
        "Bring me a ladle. If all the ladles are dirty, bring me a fork.",
        "Bring me a ladle. If the ladles are all in the washer, bring me a fork.",
    ],
)
def test_what_there_is_no_other_of_is_not_fetched(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [3], "else": [1]}]


def test_what_is_put_back_was_taken(interpreter: Interpreter) -> None:
    text = "Take the horn from the shelf, but if it is the wrong one, put it back."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


def test_an_instead_is_for_the_order_of_its_kind(interpreter: Interpreter) -> None:
    text = "Put the pie in the larder and close the hatch. If the larder is full, put the pie on the bench instead."
    assert flow(interpreter, text) == [{"if": 3, "then": [4], "else": [1]}, 2]


@pytest.mark.parametrize(
    "text",
    [
        "I fancy a pear. If there aren't any in the larder, bring me an apple.",
        "I could do with a pie. If there are none in the larder, bring me an apple.",
        "I'd like a pear. Are there any in the larder? If there aren't, bring me an apple instead.",
    ],
)
def test_what_somebody_fancies_is_brought_where_there_is_some(interpreter: Interpreter, text: str) -> None:
    found = interpreter.interpret(text)
    (node,) = found.flow.nodes
    assert [found.tasks[n - 1].value("object") for n in node.orelse[0].tasks] == ["an apple"]
    assert found.tasks[0].type == "bringing"


@pytest.mark.parametrize("text", ["I could do with a blanket.", "I wouldn't mind a pear.", "I'm dying for a coffee."])
def test_a_wish_is_an_order(interpreter: Interpreter, text: str) -> None:
    assert [task.type for task in interpreter.interpret(text).tasks] == ["bringing"]


@pytest.mark.parametrize(
    "text",
    [
        "Bring me a cup if one is clean or a glass if not.",
        "Take the jug to Lea if she's up or to Kim if not.",
        "Put the pie in the larder if there's room or in the attic if not.",
    ],
)
def test_an_or_without_a_comma_leads_to_an_if_not(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [1], "else": [3]}]


def test_what_is_taken_to_a_room_is_there_before_it_is_put_down(interpreter: Interpreter) -> None:
    text = "Take this jug to the kitchen. If the washer is running, put it in the sink."
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


def test_what_cannot_be_taken_to_a_room_is_put_elsewhere(interpreter: Interpreter) -> None:
    text = "Take the parcel to the kitchen. If the kitchen is locked, put it on the mat."
    assert flow(interpreter, text) == [{"if": 2, "then": [3], "else": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Set the table for four, or for five if Joe is coming.",
        "Set the table for six if Joe is here, otherwise for five.",
    ],
)
def test_a_number_of_people_may_be_another(interpreter: Interpreter, text: str) -> None:
    (node,) = flow(interpreter, text)
    assert len(node["then"]) == len(node["else"]) == 1


def test_what_was_picked_up_is_worked_on_otherwise(interpreter: Interpreter) -> None:
    text = "Pick up the cape and iron it if it's wrinkled, otherwise fold it."
    assert flow(interpreter, text) == [1, {"if": 3, "then": [2], "else": [4]}]


def test_an_oh_adds_as_an_and_does(interpreter: Interpreter) -> None:
    text = "Can you bring me the salt? Oh, and the pepper too, if it's on the bench."
    assert flow(interpreter, text) == [1, {"if": 3, "then": [2]}]


@pytest.mark.parametrize(
    "text",
    [
        "If Lea is here, hand me the tall jug if it's full, otherwise hand me the small one.",
        "If it snows, bring me the thick coat if it's dry, otherwise bring me the thin one.",
        "If Lea is here, bring me a jug, the tall one if it's full, otherwise the small one.",
    ],
)
def test_a_choice_within_a_case_is_made_by_the_condition_behind_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [{"if": 3, "then": [2], "else": [4]}]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the rug isn't dry, hang it up or put it on the radiator.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
        (
            "If there's no bread, bring me crackers or call my sister.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
        (
            "If Kim isn't home, either give the key to Lea or drop it in the mailbox.",
            [{"if": 1, "else": [{"if": 2, "else": [3]}]}],
        ),
        (
            "If the rug is dry, roll it up, otherwise hang it up or put it on the radiator.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "else": [4]}]}],
        ),
        (
            "If the rug is dry, fold it. If not, hang it up or put it on the radiator. Then come back.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "else": [4]}]}, 5],
        ),
        ("If the rug isn't dry, hang it up, or else fold it.", [{"if": 1, "then": [3], "else": [2]}]),
        ("If the lamp isn't lit, light it and open the hatch.", [{"if": 1, "else": [2, 3]}]),
    ],
)
def test_a_choice_stands_in_the_branch_of_its_case(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Open the hatch if it's hot, but shut it if it's cold.", [{"if": [2, 4], "then": [1], "else": [3]}]),
        ("Wash the rug if it's dirty, but roll it up if it's clean.", [{"if": [2, 4], "then": [1], "else": [3]}]),
        (
            "Draw the curtains if it's dark, but leave them open if it's light.",
            [{"if": [2, 4], "then": [1], "else": [3]}],
        ),
        (
            "Turn on the radio if Kim is cooking, but turn it off if she's on the phone.",
            [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}],
        ),
        (
            "Open the shutters if it's sunny, but leave them closed if it's windy.",
            [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}],
        ),
        (
            "Shut the shutters when it gets dark. Open them when it gets light.",
            [{"if": 2, "then": [1]}, {"if": 4, "then": [3]}],
        ),
        (
            "Water the ferns if they're dry, but use the small can if it's full.",
            [{"if": 2, "then": [1, {"if": 4, "then": [3]}]}],
        ),
    ],
)
def test_an_order_against_the_first_has_its_own_condition(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Grab the rug, or if it's wet take the mat, and put it by the stove.",
            [{"if": 2, "then": [3], "else": [1]}, 4],
        ),
        (
            "Take the jug, or if it's cracked get the flask, and bring it here.",
            [{"if": 2, "then": [3], "else": [1]}, 4],
        ),
        ("Take the jug, or if it's cracked get the flask and rinse it.", [{"if": 2, "then": [3, 4], "else": [1]}]),
    ],
)
def test_what_is_done_with_a_thing_or_its_substitute_is_done_with_either(
    interpreter: Interpreter, text: str, expected: object
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Put the spoons in the drawer. If the drawer is missing, use the tray.",
        "Put the spoons in the drawer. If the drawer is full, use the tray.",
        "Put the ham in the fridge. If the fridge is broken, put it in the cellar.",
        "Lay the cake on the plate. If the plate is cracked, use a tray.",
    ],
)
def test_nothing_is_put_where_nothing_can_be(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 2, "then": [3], "else": [1]}]


@pytest.mark.parametrize(
    "text",
    [
        "Put the spoons in the drawer. If the drawer is broken, mend it.",
        "Put the spoons in the drawer. If the spoons are missing, use the forks.",
    ],
)
def test_what_is_seen_to_afterwards_keeps_nothing_from_its_place(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [1, {"if": 2, "then": [3]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Put the jug on the rack unless it's full. Put it in the sink then.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Hang the coat up unless the hooks are taken. Lay it on the bed then.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Put the jug on the rack unless it's full. Put it in the sink.", [{"if": 2, "else": [1]}, 3]),
        ("Put the jug on the rack unless it's full. Wash it then.", [{"if": 2, "else": [1]}, 3]),
    ],
)
def test_what_is_put_elsewhere_then_is_put_there_in_the_excepted_case(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "If the tank is under thirty percent, fill it; over that, bring it to me.",
        "If it's above 25 degrees, open the hatch; below that, close it.",
        "If there are under six plums, bring them; above that, cook them.",
    ],
)
def test_what_lies_beyond_a_limit_is_the_other_side(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "then": [2], "else": [3]}]


@pytest.mark.parametrize(
    "text",
    [
        "Get the lamp and follow me to the barn. If the lamp is dead, take a candle instead.",
        "Could you fetch the cart and come with me to the gate? If it's broken, bring the sack instead.",
        "Grab the lead and walk with Kim to the park. If the lead is torn, grab the rope instead.",
    ],
)
def test_who_comes_along_does_so_with_what_is_fetched_instead_too(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 3, "then": [4], "else": [1]}, 2]


@pytest.mark.parametrize(
    "text",
    [
        "Get the ladder and wash the windows. If the ladder is broken, bring the stool instead.",
        "Get the lamp and follow me to the barn. If the barn is locked, take a candle instead.",
        "Get the note and follow me to the study. If the note is wet, leave it in the hall instead.",
    ],
)
def test_what_hangs_on_the_thing_itself_is_done_with_it_alone(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 3, "then": [4], "else": [1, 2]}]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Unless Lea is asleep, start the mixer; if she is, shut her door before you start it.",
         [{"if": [1, 3], "then": [4, 5], "else": [2]}]),
        ("If the pot is hot, bring it here. If it isn't, warm it before you bring it here.",
         [{"if": [1, 3], "then": [2], "else": [4, 5]}]),
        ("Serve the stew if it's warm, and if it's cold, heat it before you serve it.",
         [{"if": [2, 3], "then": [1], "else": [4, 5]}]),
        ("If the tourist has a ticket, take him to the hall. If not, sell him one before you take him.",
         [{"if": 1, "then": [2], "else": [3, 4]}]),
        ("If the ewe is calm, milk her; if she kicks, tie her up before you milk her.",
         [{"if": [1, 3], "then": [2], "else": [4, 5]}]),
        ("Put the forks away. If they're dirty, wash them before you put them away.",
         [{"if": 2, "then": [3]}, {"same": [1, 4]}]),
        ("If the pot is warm, serve it, but before you serve it, lay the table. If it isn't, heat it.",
         [{"if": [1, 5], "then": [4, {"same": [2, 3]}], "else": [6]}]),
    ],
)  # fmt: skip
def test_what_is_done_in_one_case_is_done_in_the_other_behind_a_before(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Hang the blouse on the hook. In case the iron's still hot, stand it on the tile.",
         [1, {"if": 2, "then": [3]}]),
        ("My blouse is on the chair, hang it on the hook. If the pan is still hot, set it on the tile.",
         [1, {"if": 2, "then": [3]}]),
        ("Put the forks in the drawer. If the pan is dirty, put it in the sink.", [1, {"if": 2, "then": [3]}]),
        ("Hang the coat in the hall. If it's wet, put it in the tub.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Hang the coat in the hall. If the rack is full, put it on my bed.", [{"if": 2, "then": [3], "else": [1]}]),
        ("Put the cake in the fridge. If the fridge is full, put it in the cellar.",
         [{"if": 2, "then": [3], "else": [1]}]),
        ("Hang the shirts in the wardrobe. If the wardrobe is locked, hang them on the door.",
         [{"if": 2, "then": [3], "else": [1]}]),
    ],
)  # fmt: skip
def test_where_another_thing_is_put_in_its_case_is_no_other_place_of_the_first(
    interpreter: Interpreter, text: str, expected: Any
) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "If the dog doesn't bark, let Ian sleep, and wake him if it does.",
        "If the bell doesn't ring, fine, but open the hatch if it does.",
    ],
)
def test_an_order_goes_by_the_case_right_behind_it(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": [1, 3], "then": [2]}]


def test_what_is_not_done_so_is_the_other_side(interpreter: Interpreter) -> None:
    (case,) = flow(interpreter, "Check whether Max has swept the yard. Should he not have done so, sweep it.")
    assert case == {"if": [1, 2], "else": [3]}
