"""Grounding: phrases to entities, verbs to states; what is not known is refused with the task's number."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import ImpossibleGoalError, InputError, MissingArgumentError, UnknownWordError
from decomplex_bt.instruction import Argument
from decomplex_bt.planning.ground_task import HERE
from decomplex_bt.planning.grounding import GroundInstruction, GroundTask, ground

DOMAIN = load_domain()
PENS, MUGS, TABLES = ("pen_1", "pen_2"), ("mug_1", "mug_2"), ("kitchen_table", "coffee_table", "hallway_table")
WINDOWS = ("kitchen_window", "living_room_window", "bedroom_window")


def grounded(text: str, count: int = 1, **kwargs: Any) -> GroundInstruction:
    return ground(read_markup(text, DOMAIN.ontology, flow=list(range(1, count + 1))), DOMAIN, **kwargs)


def first(text: str) -> GroundTask:
    return grounded(text).tasks[0]


@pytest.mark.parametrize(
    ("phrase", "expected"),
    [
        ("a pen", [(PENS, False, 1)]),
        ("the red mug", [(("mug_1",), False, 1)]),
        ("the cup and the plate", [(("cup_1", "cup_2"), False, 1), (("plate_1", "plate_2"), False, 1)]),
        ("the cup together with the plate", [(("cup_1", "cup_2"), False, 1), (("plate_1", "plate_2"), False, 1)]),
        ("the pen, the book and my keys", [(PENS, False, 1), (("book_1", "book_2"), False, 1), (("keys",), False, 1)]),
        ("all the mugs", [(MUGS, True, 1)]),
        ("the mugs", [(MUGS, True, 1)]),
        ("any mugs", [(MUGS, True, 1)]),
        ("two mugs", [(MUGS, False, 2)]),
        ("both of the mugs", [(MUGS, True, 1)]),
        ("every one of the mugs", [(MUGS, True, 1)]),
        ("any of the mugs", [(MUGS, False, 1)]),
        ("some of the mugs", [(MUGS, False, 1)]),
        ("one of the mugs", [(MUGS, False, 1)]),
        ("either of the mugs", [(MUGS, False, 1)]),
        ("a couple of the mugs", [(MUGS, False, 2)]),
        ("a cup or a mug", [(("cup_1", "cup_2", *MUGS), False, 1)]),
        ("my wife's phone", [(("phone",), False, 1)]),
        ("a slice of bread", [(("bread",), False, 1)]),
        ("the glasses", [(("glasses",), False, 1)]),
        ("the red and the green mug", [(("mug_1",), False, 1), (("mug_2",), False, 1)]),
        ("the keys that are lying around", [(("keys",), False, 1)]),
        ("the cup and that plate", [(("cup_1", "cup_2"), False, 1), (("plate_1", "plate_2"), False, 1)]),
        ("the red mug or that pen", [(("mug_1", *PENS), False, 1)]),
        ("the book, that is lying around", [(("book_1", "book_2"), False, 1)]),
        ("the book that I bought", [(("book_1", "book_2"), False, 1)]),
    ],
)
def test_a_phrase_names_entities(phrase: str, expected: list[tuple[tuple[str, ...], bool, int]]) -> None:
    task = first(f"[Take](1:taking) [{phrase}](1:object)")
    assert [(r.candidates, r.is_all, r.count) for r in task.objects] == expected


@pytest.mark.parametrize(
    ("phrase", "expected"),
    [
        ("the glasses", ("glasses",)),
        ("my glasses", ("glasses",)),
        ("two glasses", ("glass_1", "glass_2")),
        ("both glasses", ("glass_1", "glass_2")),
        ("all the glasses", ("glass_1", "glass_2")),
        ("two of the glasses", ("glass_1", "glass_2")),
        ("clean glasses", ("glass_1", "glass_2")),
        ("both shoes", ("shoes",)),
    ],
)
def test_a_name_that_is_a_plural_too_is_one_where_number_or_state_ask_for_it(
    phrase: str, expected: tuple[str, ...]
) -> None:
    (task,) = grounded(f"[Find](1:searching) [{phrase}](1:object)").tasks
    assert task.objects[0].candidates == expected


@pytest.mark.parametrize(
    ("phrase", "is_any"),
    [
        ("a window", True),
        ("one window", True),
        ("any of the windows", True),
        ("the tv or the radio", True),
        ("either the tv or the radio", True),
        ("the tv nor the radio", True),
        ("the window", False),
        ("all the windows", False),
    ],
)
def test_a_phrase_asks_for_any_or_for_a_certain_one(phrase: str, is_any: bool) -> None:
    task = first(f"[Look](1:searching) [at {phrase}](1:location)")
    assert task.places[0].is_any is is_any


@pytest.mark.parametrize(
    ("said", "meant", "candidates", "count"),
    [
        ("one", "all the windows", WINDOWS, 1),
        ("two of them", "the windows", WINDOWS, 2),
        ("either of them", "both mugs", MUGS, 1),
        ("one of them", "the tv and the radio", ("tv", "radio"), 1),
        ("two", "two pens", PENS, 2),
        ("one", "a pen", PENS, 1),
    ],
)
def test_a_pronoun_may_pick_some_of_what_it_stands_for(
    said: str, meant: str, candidates: tuple[str, ...], count: int
) -> None:
    task = first(f"[Look](1:searching) [at {said}](1:location={meant})")
    assert [(r.candidates, r.is_all, r.count) for r in task.places] == [(candidates, False, count)]


def test_a_pronoun_keeps_its_own_preposition() -> None:
    task = first("[Put](1:placing) [the ball](1:object) [under it](1:goal=the couch)")
    assert task.goal is not None
    assert task.goal.candidates == ("living_room_floor",)


def test_a_pronoun_means_the_place_meant_before_wherever_the_robot_is_sent() -> None:
    close = "[Close](1:change_state) [the drawer](1:object) [in the kitchen](1:location), "
    text = close + "[go](2:motion) [to the study](2:goal), [look](3:searching) [into it](3:location=the drawer)"
    assert grounded(text, 3).tasks[2].places[0].candidates == ("drawer",)


@pytest.mark.parametrize(
    "text",
    [
        "[Close](1:change_state) [the window](1:object) [in the study](1:location)",
        "[Close](1:change_state) [the window in the study](1:object)",
        "[Switch](1:change_state) on [the tv](1:object) [in the kitchen](1:location)",
        "[Bring](1:bringing) [me](1:recipient) [the cup](1:object) [from the table in the bedroom](1:source)",
    ],
)
def test_what_is_fixed_elsewhere_is_refused(text: str) -> None:
    with pytest.raises(ImpossibleGoalError, match=r"names nothing in the .*, only in"):
        first(text)


def test_what_tells_one_from_another_is_no_place_it_must_be_in() -> None:
    task = first("[Open](1:change_state) [the cupboard with the bathroom door](1:object)")
    assert "cupboard" in task.objects[0].candidates


@pytest.mark.parametrize(
    ("phrase", "count"),
    [("at least one pen", 1), ("at least two pens", 2), ("more than one pen", 2), ("either pen", 1)],
)
def test_a_quantity_is_read(phrase: str, count: int) -> None:
    (pens,) = first(f"[Bring](1:bringing) [me](1:recipient) [{phrase}](1:object)").objects
    assert (pens.candidates, pens.count, pens.is_all) == (PENS, count, False)


@pytest.mark.parametrize(
    "text", ["[Drop](1:placing) [the ball](1:object)", "[Let](1:placing) go [of it](1:object=the ball)"]
)
def test_what_is_dropped_lands_on_the_floor(text: str) -> None:
    task = first(text)
    assert task.goal is not None
    assert set(task.goal.candidates) == {DOMAIN.house.floor_of(room) for room in DOMAIN.house.rooms}


@pytest.mark.parametrize(
    "text", ["[Iron](1:change_state) [the {}](1:object)", "[Mend](1:change_state) [all {}s](1:object)"]
)
@pytest.mark.parametrize("what", ["shirt", "window"])
def test_what_has_a_state_is_asked_for_it_where_the_verb_says_none(text: str, what: str) -> None:
    with pytest.raises(MissingArgumentError, match="What state"):
        first(text.format(what))


def test_nothing_is_put_onto_itself() -> None:
    instruction = read_markup("[Put](1:placing) [the pen](1:object) down", DOMAIN.ontology, flow=[1])
    circle = replace(instruction.tasks[0], arguments=(*instruction.tasks[0].arguments, Argument("goal", "the pen")))
    with pytest.raises(MissingArgumentError):
        ground(replace(instruction, tasks=(circle,)), DOMAIN)


@pytest.mark.parametrize(
    "said", ["[any of them](2:object=the windows)", "[one](2:object=one of the windows)", "[one](2:object=the windows)"]
)
def test_a_bare_check_asks_what_its_mention_says(said: str) -> None:
    text = (
        f"[Check](1:check_state) [the windows](1:object). If {said} "
        "[is](2:check_state) [open](2:state), [tell](3:informing) [me](3:recipient)."
    )
    instruction = read_markup(text, DOMAIN.ontology, flow=[{"if": [1, 2], "then": [3]}])
    check = ground(instruction, DOMAIN).tasks[0]
    assert (check.state, check.objects[0].is_any) == ("open", True)


def test_who_has_a_thing_cannot_be_asked() -> None:
    with pytest.raises(ImpossibleGoalError, match="who has a thing cannot be asked"):
        first("if [Tom](1:object) [has](1:check_state) [the keys](1:state)")


def test_alternatives_may_be_one_or_several_of_a_kind() -> None:
    task = first("[Open](1:change_state) [the windows or the front door](1:object)")
    assert set(task.objects[0].candidates) == {*WINDOWS, "front_door"}


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("[Throw](1:placing) [the pen](1:object) away.", "trash_can"),
        ("[Get](1:placing) rid [of the pen](1:object).", "trash_can"),
        ("[Throw](1:placing) [the pen](1:object) away [in the box](1:goal).", "box"),
    ],
)
def test_a_verb_says_where_it_puts_a_thing_unless_words_do(text: str, goal: str) -> None:
    task = first(text)
    assert task.goal is not None
    assert (task.objects[0].candidates, task.goal.candidates) == (PENS, (goal,))


@pytest.mark.parametrize(
    "text", ["[Take](1:taking) out [the trash](1:object).", "[Take](1:bringing) [the rubbish](1:object) [out](1:goal)."]
)
def test_what_cannot_be_taken_out_is_emptied(text: str) -> None:
    task = first(text)
    assert (task.type, task.objects[0].candidates, task.state) == ("change_state", ("trash_can",), "empty")


def test_what_stays_is_not_taken_up_nor_out() -> None:
    for text in ("[Take](1:taking) [the trash](1:object).", "[Take](1:taking) out [the oven](1:object)."):
        with pytest.raises(ImpossibleGoalError, match="cannot be carried"):
            first(text)


def test_state_words_tell_one_from_another() -> None:
    task = first("[Bring](1:bringing) [me](1:recipient) [the clean mug](1:object)")
    assert task.objects[0].where == (("cleanliness", "clean"),)
    assert task.objects[0].candidates == MUGS
    assert [person.candidates for person in task.recipients] == [("user",)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("[Switch](1:change_state) [the lamp in the bedroom](1:object) on", (("bedroom_lamp",), "on")),
        ("[Turn](1:change_state) [it](1:object=the tv) back off", (("tv",), "off")),
        ("[The tv](1:object) [off](1:change_state), please", (("tv",), "off")),
        (
            "[Turn](1:change_state) off [the light](1:object) [in the bathroom](1:location)",
            (("bathroom_light",), "off"),
        ),
        ("[Open](1:change_state) [the fridge door](1:object)", (("fridge",), "open")),
        ("[Wash](1:change_state) [the glasses](1:object)", (("glass_1", "glass_2"), "clean")),
        ("[Make](1:change_state) [the soup](1:object) [nice and hot](1:state)", (("soup",), "hot")),
        ("[Wipe](1:change_state) down [the kitchen counter](1:object)", (("counter",), "clean")),
        ("[Close](1:change_state) [the door of the bathroom](1:object)", (("bathroom_door",), "closed")),
    ],
)
def test_a_change_of_state_has_objects_and_a_value(text: str, expected: tuple[tuple[str, ...], str]) -> None:
    task = first(text)
    assert (task.objects[0].candidates, task.state) == expected


@pytest.mark.parametrize(
    ("text", "objects", "places", "state"),
    [
        ("If [the coffee](1:object) [is](1:check_state) still [hot](1:state)", ("coffee",), (), "hot"),
        ("If there [is](1:check_state) [milk](1:object) [in the fridge](1:location)", ("milk",), ("fridge",), "here"),
        ("[Is](1:check_state) [Anna](1:object) [at home](1:location)?", ("anna",), (), "here"),
        (
            "[Any soap](1:object) [left](1:check_state) [on the shelf](1:location)?",
            ("soap",),
            ("bathroom_shelf", "bookshelf"),
            "here",
        ),
        ("if there [is](1:check_state) [any juice](1:object) [going](1:state)", ("juice",), (), "here"),
        ("if [the tv](1:object) [is](1:check_state) [going](1:state)", ("tv",), (), "on"),
        ("[Oven](1:object) [on](1:check_state)?", ("oven",), (), "on"),
        ("[Heater](1:object) still [on](1:check_state) [in the study](1:location)?", ("heater",), (), "on"),
        ("[heater](1:object) [on](1:check_state) [in here](1:location)", ("heater",), (), "on"),
        (
            "[Check](1:check_state) whether [the window](1:object) [in the kitchen](1:location) is [shut](1:state)",
            ("kitchen_window",),
            (),
            "closed",
        ),
        ("if [the washing machine](1:object) [is](1:check_state) [finished](1:state)", ("washing_machine",), (), "off"),
        (
            "if [my mother](1:object) [is](1:check_state) [in the kitchen](1:location)",
            ("relative",),
            ("kitchen",),
            "here",
        ),
    ],
)
def test_a_check_asks_for_a_state_or_for_presence(
    text: str, objects: tuple[str, ...], places: tuple[str, ...], state: str
) -> None:
    task = first(text)
    assert task.objects[0].candidates == objects
    assert tuple(name for referent in task.places for name in referent.candidates) == places
    assert task.state == state


@pytest.mark.parametrize(
    ("goal", "candidates"),
    [
        ("on the kitchen counter", ("counter",)),
        ("in the bedroom", ("bedroom",)),
        ("on the table in the kitchen", ("kitchen_table",)),
        ("under the bed", ("bedroom_floor",)),
        ("next to the microwave", ("counter",)),
        ("in the drawer of the desk", ("desk_drawer",)),
        ("next to the laptop", ("laptop",)),
    ],
)
def test_a_thing_is_put_where_things_can_lie(goal: str, candidates: tuple[str, ...]) -> None:
    task = first(f"[Put](1:placing) [the book](1:object) [{goal}](1:goal)")
    assert task.goal is not None
    assert task.goal.candidates == candidates


def test_the_room_in_question_tells_ambiguous_places_apart() -> None:
    text = "[Go](1:motion) [to the living room](1:goal) and [put](2:placing) [the cup](2:object) [on the table](2:goal)"
    goal = grounded(text, 2).tasks[1].goal
    assert goal is not None
    assert goal.candidates == ("coffee_table",)
    alone = first("[Put](1:placing) [the cup](1:object) [on the table](1:goal)").goal
    assert alone is not None
    assert alone.candidates == TABLES


def test_a_definite_phrase_takes_up_the_thing_that_was_spoken_of() -> None:
    text = "[Find](1:searching) [a pen](1:object) and [bring](2:bringing) [me](2:recipient) [the pen](2:object)"
    tasks = grounded(text, 2).tasks
    assert tasks[0].objects == tasks[1].objects


def test_leaving_a_room_is_going_anywhere_else() -> None:
    goal = first("[Leave](1:motion) [the kitchen](1:source)").goal
    assert goal is not None
    assert goal.candidates[0] == "hallway"
    assert "kitchen" not in goal.candidates


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ("[Bring](1:bringing) [me](1:recipient) [the hairdryer](1:object)", UnknownWordError, "hairdryer"),
        ("[Take](1:taking) [my library book](1:object)", UnknownWordError, "red book"),
        ("[Take](1:taking) [the purple mug](1:object)", UnknownWordError, "green mug"),
        ("[Go](1:motion) [to the garage](1:goal)", UnknownWordError, "expected a room, a place or a person"),
        ("[Go](1:motion) [to the dining room](1:goal)", UnknownWordError, "known: living room"),
        ("[Bring](1:bringing) [Ottokar](1:recipient) [the book](1:object)", UnknownWordError, "expected a person"),
        (
            "[Bring](1:bringing) [John](1:recipient) [the book](1:object)",
            UnknownWordError,
            "known: user, anna, tom, guest",
        ),
        (
            "[Bring](1:bringing) [me](1:recipient) [the eggs](1:object)",
            UnknownWordError,
            r"; known: pen, .*\(\d+ in all\)",
        ),
        (
            "[Cut](1:change_state) [the bread](1:object)",
            ImpossibleGoalError,
            r"'the bread' cannot be off \(so 'cut' is read\): being on or off is not modelled for bread",
        ),
        ("[Open](1:change_state) [the bread](1:object)", ImpossibleGoalError, "cannot be open: being"),
        ("[Charge](1:change_state) [my phone](1:object)", ImpossibleGoalError, "'charge' says nothing .* no state"),
        ("[Swap](1:change_state) [the books](1:object)", ImpossibleGoalError, "no state to change"),
        ("[Take](1:taking) [the bok](1:object)", UnknownWordError, "book"),
        ("[Open](1:change_state) [the pen](1:object)", ImpossibleGoalError, "open"),
        ("[Is](1:check_state) [the box](1:object) [open and empty](1:state)?", ImpossibleGoalError, "say each"),
        ("[Heat](1:change_state) [the sofa](1:object)", ImpossibleGoalError, "hot"),
        ("[Soil](1:change_state) [the plate](1:object)", ImpossibleGoalError, "dirty"),
        ("If it['s](1:check_state) [raining](1:state)", ImpossibleGoalError, "weather"),
        (
            "If it['s](1:check_state) [cold](1:state) [in the study](1:location)",
            ImpossibleGoalError,
            "what it is like somewhere",
        ),
        (
            "If [the fan](1:object) [is](1:check_state) [broken](1:state)",
            ImpossibleGoalError,
            "turn on the fan",
        ),
        ("If [the fan](1:object) [is](1:check_state) [out of order](1:state)", ImpossibleGoalError, "by trying alone"),
        ("If [the coffee machine](1:object) [works](1:check_state)", ImpossibleGoalError, "by trying alone"),
        ("If [the mug](1:object) [is](1:check_state) [broken](1:state)", ImpossibleGoalError, "'broken' is no state"),
        (
            "[Fill](1:change_state) [the bowl](1:object) [with soup](1:manner)",
            ImpossibleGoalError,
            "nothing here fills 'the bowl' 'with soup'; what there is here to fill things with: coffee, water",
        ),
        (
            "[Fill](1:change_state) [the bottle](1:object) [with coffee](1:manner)",
            ImpossibleGoalError,
            "nothing here fills 'the bottle' 'with coffee'",
        ),
        (
            "[Fill](1:change_state) [the bottle](1:object) [with it](1:manner=the coffee)",
            ImpossibleGoalError,
            "nothing here fills 'the bottle' 'the coffee'",
        ),
        ("[Empty](1:change_state) [the box](1:object)", ImpossibleGoalError, "full or empty is not modelled for box"),
        (
            "[Turn](1:change_state) [the radio](1:object) [up](1:state)",
            ImpossibleGoalError,
            "how far something is turned, raised or lowered is not modelled for radio",
        ),
        (
            "[Put](1:placing) [the pen](1:object) [in the bowl](1:goal)",
            ImpossibleGoalError,
            "'in the bowl' names neither a surface nor a container",
        ),
        ("[Bring](1:bringing) [me](1:recipient) [the fridge](1:object)", ImpossibleGoalError, "cannot be carried"),
        ("[Walk](1:following) [me](1:object) [to the pen](1:goal)", ImpossibleGoalError, "lead the way"),
        ("[Let](1:placing) [Anna](1:object) in", ImpossibleGoalError, "'Anna' neither"),
        ("[Put](1:placing) [the pen](1:object) [on the tv](1:goal)", ImpossibleGoalError, "on the tv"),
        ("[Take](1:taking) [five mugs](1:object)", ImpossibleGoalError, "only 2"),
        ("[Turn](1:motion) [left](1:direction)", ImpossibleGoalError, "where to go"),
        ("[Bring](1:bringing) [me](1:recipient) [everything](1:object)", UnknownWordError, "everything at a place"),
        ("if [the soup](1:object) [is](1:check_state) [ready](1:state)", ImpossibleGoalError, "ready"),
    ],
)
def test_what_cannot_be_is_refused_with_the_task(text: str, error: type[InputError], words: str) -> None:
    with pytest.raises(error, match=words) as caught:
        first(text)
    assert caught.value.task == 1  # type: ignore[attr-defined]


def test_a_missing_argument_is_asked_for() -> None:
    asked = []

    def ask(missing: Any) -> str:
        asked.append((missing.task, missing.argument, missing.question))
        return "on the desk"

    goal = grounded("[Put](1:placing) [the book](1:object) down", ask=ask).tasks[0].goal
    assert goal is not None
    assert goal.candidates == ("desk",)
    assert asked == [(1, "goal", "Where should I put it?")]
    with pytest.raises(MissingArgumentError, match="Where should I put it"):
        first("[Put](1:placing) [the book](1:object) down")


@pytest.mark.parametrize("who", ["Anna and Tom", "everyone"])
def test_one_thing_for_several_people_is_refused(who: str) -> None:
    for kind in ("recipient", "goal"):
        with pytest.raises(ImpossibleGoalError, match=r"only one person can have a thing|ends up in one place"):
            first(f"[Give](1:bringing) [the apple](1:object) [to {who}](1:{kind})")


@pytest.mark.parametrize(
    "text",
    [
        "[Give](1:bringing) [Anna and Tom](1:recipient) [a pen](1:object) each.",
        "[Give](1:bringing) [Anna and Tom](1:recipient) [each a pen](1:object)",
        "[Hand](1:bringing) [a pen each](1:object) [to Anna and Tom](1:recipient)",
        "[Give](1:bringing) [each of Anna and Tom](1:recipient) [a pen](1:object)",
        "[Give](1:bringing) [both Anna and Tom](1:recipient) [a pen](1:object)",
    ],
)
def test_what_several_people_get_each_is_a_task_for_each(text: str) -> None:
    anna, tom = grounded(text).tasks
    assert [task.recipients[0].candidates for task in (anna, tom)] == [("anna",), ("tom",)]
    assert {task.objects[0].phrase for task in (anna, tom)} == {"a pen"}
    assert anna.objects[0] in tom.objects[0].others


@pytest.mark.parametrize(
    "text",
    [
        "[Give](1:bringing) [Anna and Tom](1:recipient) [a pen and the book](1:object) each",
        "[Give](1:bringing) [Anna and Tom](1:recipient) [a pen](1:object) each time",
        "[Bring](1:bringing) [each of us](1:recipient) [a cup](1:object)",
        "[Bring](1:bringing) [us](1:recipient) [a cup](1:object) each",
    ],
)
def test_what_each_gets_is_refused_where_it_or_they_are_left_open(text: str) -> None:
    with pytest.raises(ImpossibleGoalError, match="only one person can have a thing"):
        first(text)
    assert first("[Bring](1:bringing) [us](1:recipient) [a cup](1:object)").recipients[0].candidates == ("user",)


@pytest.mark.parametrize("where", ["on every table", "on both tables", "in each room"])
def test_a_thing_for_every_place_of_a_kind_is_refused(where: str) -> None:
    with pytest.raises(ImpossibleGoalError, match=f"ends up in one place, not '{where}'"):
        first(f"[Put](1:placing) [a pen](1:object) [{where}](1:goal)")
    assert first("[Put](1:placing) [a pen](1:object) [on any table](1:goal)").goal is not None
    assert first("[Put](1:placing) [a pen](1:object) [in every fridge](1:goal)").goal is not None


def test_a_thing_for_several_places_and_a_way_to_several_of_many_are_refused() -> None:
    with pytest.raises(ImpossibleGoalError, match="ends up in one place"):
        first("[Put](1:placing) [the pen](1:object) [on the desk and the couch](1:goal)")
    with pytest.raises(ImpossibleGoalError, match="leaves open where to go"):
        first("[Go](1:motion) [to a window and the kitchen](1:goal)")


def test_recipient_and_message_have_defaults() -> None:
    task = first("[Fetch](1:bringing) [a pen](1:object)")
    assert [person.candidates for person in task.recipients] == [("user",)]
    task = first("[Report](1:informing) back")
    assert [person.candidates for person in task.recipients] == [("user",)]
    assert task.message is None


def test_a_later_mention_need_not_be_a_task_of_its_own() -> None:
    turn, work = "[Turn](1:change_state) on [the tv](1:object)", "[it](2:object=the tv) doesn't [work](2:check_state)"
    text = f"{turn}. If {work}, [go](3:motion) [to the kitchen](3:goal)."
    said = read_markup(text, DOMAIN.ontology, flow=[{"if": [1, 2], "else": [3]}])
    assert [task.state for task in ground(said, DOMAIN).tasks] == ["on", None, None]
    alone = read_markup(text, DOMAIN.ontology, flow=[1, {"if": 2, "else": [3]}])
    with pytest.raises(ImpossibleGoalError, match="by trying alone"):
        ground(alone, DOMAIN)


def _check_of_whom(nobody: str, where: str) -> GroundTask:
    text = f"If {nobody} [is](1:check_state) {where}, [go](2:motion) [to the bedroom](2:goal)."
    return ground(read_markup(text, DOMAIN.ontology, flow=[{"if": 1, "then": [2]}]), DOMAIN).tasks[0]


@pytest.mark.parametrize("nobody", ["nobody", "no [one](1:object)"])
@pytest.mark.parametrize("where", ["[home](1:location)", "[with me](1:location)", "[around](1:state)"])
def test_a_check_of_nobody_is_one_of_anybody(nobody: str, where: str) -> None:
    checks = [_check_of_whom(who, where) for who in (nobody, "[somebody](1:object)")]
    assert checks[0].objects == checks[1].objects
    assert checks[0].state == checks[1].state == HERE


@pytest.mark.parametrize(
    ("nobody", "where", "has_user"),
    [
        ("nobody", "[in the kitchen](1:location)", True),
        ("no [one](1:object)", "[at the desk](1:location)", True),
        ("but if nobody", "[in the kitchen](1:location)", True),
        ("nobody else", "[in the kitchen](1:location)", False),
        ("nobody but me", "[in the kitchen](1:location)", False),
        ("nobody", "[in the kitchen](1:location) except me", False),
    ],
)
def test_where_nobody_is_the_one_who_speaks_is_not_either(nobody: str, where: str, has_user: bool) -> None:
    check = _check_of_whom(nobody, where)
    assert ("user" in check.objects[0].candidates) is has_user
    assert check.objects[0].is_any
    assert check.state == HERE


def test_to_see_if_there_is_something_is_to_ask_whether_it_is_there() -> None:
    assert first("[See](1:check_state) if there's [any bread](1:object).").state == HERE
    with pytest.raises(MissingArgumentError):
        first("[Check](1:check_state) [the bread](1:object).")


def test_everything_that_is_switched_is_every_device() -> None:
    task = first("[Turn](1:change_state) [everything](1:object) [off](1:state).")
    assert task.objects[0].is_all
    assert {"tv", "oven"} < set(task.objects[0].candidates)
    assert all("power" in DOMAIN.kind(name).states for name in task.objects[0].candidates)


@pytest.mark.parametrize(("text", "goal"), [("back", "user"), ("", "user"), ("[to the kitchen](1:goal)", "kitchen")])
def test_to_come_is_to_come_here_unless_words_say_where(text: str, goal: str) -> None:
    task = first(f"[Come](1:motion) {text}.")
    assert task.goal is not None
    assert task.goal.candidates == (goal,)


@pytest.mark.parametrize(
    ("text", "is_denied"),
    [
        ("if [Anna](1:object) [is](1:check_state) [out](1:state)", True),
        ("if [the guest](1:object) has already [left](1:check_state)", True),
        ("if [my mother](1:object)['s](1:check_state) [away](1:state)", True),
        ("if [the milk](1:object) [is](1:check_state) [gone](1:state)", True),
        ("if [Anna](1:object) [is](1:check_state) [in](1:state)", False),
        ("if there is [any milk](1:object) [left](1:check_state)", False),
        ("if [Anna](1:object) has [gone](1:check_state) out", True),
        ("if [Tom](1:object) [went](1:check_state) away", True),
        ("if [Tom](1:object) has [popped](1:check_state) out", True),
        ("if [the guest](1:object) has [left](1:check_state) [the house](1:location)", True),
        ("if [the milk](1:object) has [gone](1:check_state)", True),
        ("if [Tom](1:object) [is](1:check_state) [back](1:state)", False),
    ],
)
def test_a_check_may_ask_for_absence(text: str, is_denied: bool) -> None:
    task = first(text)
    assert (task.state, task.is_denied) == ("here", is_denied)


@pytest.mark.parametrize(
    ("text", "place", "is_denied"),
    [
        ("if [Anna](1:object) has [left](1:check_state) [the kitchen](1:location)", "kitchen", True),
        ("if [the mug](1:object) has [gone](1:check_state) [from the desk](1:location)", "desk", True),
        ("if [Anna](1:object) has [gone](1:check_state) [to the kitchen](1:location)", "kitchen", False),
        ("if [Anna](1:object) [went](1:check_state) [into the kitchen](1:location)", "kitchen", False),
    ],
)
def test_who_has_gone_is_not_where_they_went_from(text: str, place: str, is_denied: bool) -> None:
    task = first(text)
    assert (task.state, task.places[0].candidates, task.is_denied) == (HERE, (place,), is_denied)


def test_a_light_that_is_out_is_off() -> None:
    task = first("if [the kitchen light](1:object) [is](1:check_state) [out](1:state)")
    assert (task.state, task.is_denied) == ("off", False)
    task = first("if [the light](1:object) has [gone](1:check_state) out")
    assert (task.state, task.is_denied) == ("off", False)


def test_all_are_out_where_not_one_is_here() -> None:
    task = first("if [everybody](1:object) [is](1:check_state) [out](1:state)")
    assert task.is_denied
    assert not task.objects[0].is_all
    with pytest.raises(ImpossibleGoalError, match="say who"):
        first("if [anybody](1:object) [is](1:check_state) [out](1:state)")


WINDOW = (
    "[Open](1:change_state) [the window](1:object) [in the kitchen](1:location), "
    "[go](2:motion) [to the bedroom](2:goal) and "
)


def test_a_pronoun_means_what_it_meant_wherever_the_robot_has_been_since() -> None:
    text = WINDOW + "then [close](3:change_state) [it](3:object=the window)."
    assert grounded(text, 3).tasks[2].objects[0].candidates == ("kitchen_window",)
    text = WINDOW + "[close](3:change_state) [the window](3:object)."
    assert grounded(text, 3).tasks[2].objects[0].candidates == ("bedroom_window",)


def test_the_door_is_that_of_the_container_named_last() -> None:
    fridge = "[Open](1:change_state) [the fridge](1:object), "
    text = fridge + "[take](2:taking) out [the milk](2:object) and [close](3:change_state) [the door](3:object)."
    assert grounded(text, 3).tasks[2].objects[0].candidates == ("fridge",)
    text = "[Open](1:change_state) [the fridge](1:object) and [close](2:change_state) [bathroom door](2:object)."
    assert grounded(text, 2).tasks[1].objects[0].candidates == ("bathroom_door",)
    text = fridge + "[go](2:motion) [to the bedroom](2:goal) and [close](3:change_state) [the door](3:object)."
    assert grounded(text, 3).tasks[2].objects[0].candidates == ("bedroom_door",)


@pytest.mark.parametrize("place", ["to the front door", "by the front door"])
def test_what_is_brought_to_what_holds_nothing_is_laid_beside_it(place: str) -> None:
    task = first(f"[Take](1:bringing) [the bag](1:object) [{place}](1:goal)")
    assert task.goal is not None
    assert task.goal.candidates == ("hallway_floor",)
    assert task.goal.near == ("front_door",)
    assert task.goal.to_json()["near"] == ["front_door"]
    for goal in ("on the floor in the hallway", "next to the microwave", "next to the laptop"):
        other = first(f"[Put](1:placing) [the book](1:object) [{goal}](1:goal)").goal
        assert other is not None
        assert other.near == ()


def test_neither_nor_names_both() -> None:
    task = first("[Is](1:check_state) [the phone](1:object) [neither on the desk nor on the couch](1:location)?")
    assert [place.candidates for place in task.places] == [("desk", "couch")]


def test_what_is_suggested_is_named_once() -> None:
    with pytest.raises(UnknownWordError) as caught:
        first("[Open](1:change_state) [the red curtains](1:object)")
    assert str(caught.value).count("bedroom curtains") == 1


@pytest.mark.parametrize(
    "text",
    [
        "[Put](1:placing) [everything](1:object) [on the couch in the box](1:goal)",
        "[Move](1:bringing) [everything](1:object) [on the couch](1:path) [to the box](1:goal)",
    ],
)
def test_everything_is_taken_from_where_a_goal_says_first(text: str) -> None:
    task = first(text)
    assert [place.candidates for place in task.places] == [("couch",)]
    assert task.goal is not None
    assert task.goal.candidates == ("box",)


@pytest.mark.parametrize(
    ("goal", "source", "end"),
    [
        ("on the counter in the sink", "counter", "sink"),
        ("from the kitchen table into the dishwasher", "kitchen_table", "dishwasher"),
        ("on the couch in the living room", None, "couch"),
        ("in the box on the desk", None, "box"),
        ("on the kitchen table by the window", None, "kitchen_table"),
    ],
)
def test_things_on_one_place_go_to_the_next(goal: str, source: str | None, end: str) -> None:
    task = first(f"[Put](1:placing) [the cups](1:object) [{goal}](1:goal)")
    assert [place.candidates for place in task.places] == ([(source,)] if source is not None else [])
    assert task.goal is not None
    assert task.goal.candidates == (end,)


@pytest.mark.parametrize("goal", ["in the box", "in the cupboard in the kitchen"])
def test_everything_of_nowhere_is_refused(goal: str) -> None:
    with pytest.raises(UnknownWordError):
        first(f"[Put](1:placing) [everything](1:object) [{goal}](1:goal)")


@pytest.mark.parametrize(
    ("text", "state"),
    [
        ("If [the radio](1:object) [is](1:check_state) [working](1:state)", "on"),
        ("If [the radio](1:object) [is](1:check_state) [out](1:state)", "off"),
        ("[Is](1:check_state) [the radio](1:object) [still working](1:state)?", "on"),
    ],
)
def test_what_is_working_is_on(text: str, state: str) -> None:
    (task,) = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks
    assert task.state == state


def test_who_is_in_a_room_is_seen_from_its_floor() -> None:
    task = first("[See](1:searching) [who](1:object) is [in the kitchen](1:location).")

    assert (task.objects, [place.candidates for place in task.places]) == ((), [("kitchen_floor",)])


def test_a_search_for_nobody_and_nowhere_is_refused() -> None:
    with pytest.raises(ImpossibleGoalError, match="neither what to look for nor where"):
        first("[Find](1:searching) out [who](1:object) is there.")
