"""How far a case reaches among the orders around it, and what only looks like one of its branches."""

from __future__ import annotations

from typing import Any

import pytest
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        # room is asked of the last order alone
        (
            "Carry the jars to the cellar and put them on the rack if there's room, otherwise stack them by the door.",
            [1, {"if": 3, "then": [2], "else": [4]}],
        ),
        # both cases say what is done then
        (
            "Bring the sheets to the attic. If the line is free, hang them on it; if not, lay them over the chair.",
            [1, {"if": 2, "then": [3], "else": [4]}],
        ),
        (
            "Put the pie in a box, and if there's no room in the fridge, store it in the shed.",
            [1, {"if": 2, "else": [3]}],
        ),
        (
            "Put the pie in the fridge, and if there's no room, put it in the shed.",
            [{"if": 2, "then": [1], "else": [3]}],
        ),
        # the way there
        (
            "Carry the crate upstairs. If the stairs are blocked, put it by the lift.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
        ("Carry the crate upstairs. If the lamp is broken, put it by the lift.", None),
        # what is urged all the same, and what is listed on
        ("Don't open the hatch if it's raining, but do shut the door.", [{"if": 2, "else": [1]}, 3]),
        ("Is the fan still on? Switch it off if it is and then shut the hatch.", [{"if": [1, 3], "then": [2]}, 4]),
        # what was looked for is looked at
        ("Look in the oven for the pie, and if it looks done, take it out.", [1, {"if": 2, "then": [3]}]),
        ("Look in the oven for the pie, and if it's there, take it out.", [{"if": [1, 2], "then": [3]}]),
        # no verb
        ("Count the cups. If fewer than six, tell Dad.", [1, {"if": 2, "then": [3]}]),
        ("Look in the chest for the tape, otherwise on the shelf.", [{"if": 1, "else": [2]}]),
        ("Set the pot on a mat if you can find one, otherwise on the bricks.", [{"if": 2, "then": [1], "else": [3]}]),
        ("Bring me a cola, and if there is no cola a lemonade will do.", [{"if": 2, "then": [1], "else": [3]}]),
        # it is left where it is in a case
        (
            "Take the rugs out and put them on the fence, but leave them inside if it's raining.",
            [{"if": 4, "then": [3], "else": [1, 2]}],
        ),
        (
            "If it's raining, bring the rugs in, and if it's dry leave them out.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        # what cannot be done
        (
            "If you can lift the crate, carry it up to the attic, and if it's too heavy ask Marek to help.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        # a request in the form of a question
        (
            "Can you find the tape? Try the box first, and if it isn't in there look in the drawer.",
            [1, {"if": [2, 3], "else": [4]}],
        ),
        ("Can you find the tape? If not, call Tom.", [{"if": 1, "else": [2]}]),
        # what a need is kept from by, and a bare plural
        ("The tub needs scrubbing, but if there is somebody in it leave it alone.", [{"if": 2, "else": [1]}]),
        ("Give Ann a pear, but if there are no pears left, biscuits.", [{"if": 2, "then": [1], "else": [3]}]),
        # what tells where something was found
        ("Put the pliers back in the box where you found them, and turn the lamp off.", [1, 2]),
    ],
)
def test_how_far_a_case_reaches(interpreter: Interpreter, text: str, wanted: Any) -> None:
    found = flow(interpreter, text)
    if wanted is None:  # the lamp is not on the way
        assert found[0] == 1
    else:
        assert found == wanted


@pytest.mark.parametrize(
    ("text", "verb", "kind", "values"),
    [
        ("Carry the vase to the table and set it down.", "set", "placing", {"goal": "the table"}),
        ("Meet James at the gate, and follow him to the exit.", "Meet", "searching", {"location": "at the gate"}),
        ("Open the washer and put in the sheets.", "put", "placing", {"goal": "the washer"}),
        (
            "If it isn't in the hall, it's probably in the van, so look there.",
            "look",
            "searching",
            {"location": "the van"},
        ),
    ],
)
def test_what_is_told_of_it(interpreter: Interpreter, text: str, verb: str, kind: str, values: dict[str, str]) -> None:
    task = next(task for task in interpreter.interpret(text).tasks if task.span.of(text) == verb)
    assert (task.type, {name: task.value(name) for name in values}) == (kind, values)


def test_the_particle_of_what_is_forbidden_goes_with_it(interpreter: Interpreter) -> None:
    found = interpreter.interpret("If Dad is asleep, don't turn on the radio, just close the door instead.")
    assert [task.value("state") for task in found.tasks] == ["asleep", None]


def test_what_is_put_out_or_away_goes_nowhere_that_was_named(interpreter: Interpreter) -> None:
    for text in ("Turn up the boiler and put out a fresh towel.", "Wash the hob and put the frying pan away."):
        assert interpreter.interpret(text).tasks[1].value("goal") is None


def test_what_is_seen_to_work_is_one_check(interpreter: Interpreter) -> None:
    (check,) = interpreter.interpret("See if the lamp in the corridor works.").tasks
    assert (check.type, check.value("object")) == ("check_state", "the lamp")
