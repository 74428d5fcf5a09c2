"""What is left out of all that a phrase names."""

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import ImpossibleGoalError, InputError
from decomplex_bt.planning.grounding import ground

DOMAIN = load_domain("household")
WINDOWS = {"kitchen_window", "living_room_window", "bedroom_window"}
CLOSE = "[Close](1:change_state) "


def candidates(text: str, count: int = 1) -> set[str]:
    flow = list(range(1, count + 1))
    return set(ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN).tasks[0].objects[0].candidates)


@pytest.mark.parametrize(
    ("text", "left_out"),
    [
        (CLOSE + "[all the windows](1:object) except the bedroom one.", {"bedroom_window"}),
        (CLOSE + "[all the windows](1:object), apart from the one in the bedroom.", {"bedroom_window"}),
        (CLOSE + "[all the windows except the one](1:object) [in the bedroom](1:location).", {"bedroom_window"}),
        (CLOSE + "[every window](1:object) but not the kitchen window.", {"kitchen_window"}),
        (CLOSE + "[every window but the one in the kitchen](1:object).", {"kitchen_window"}),
        (CLOSE + "[all the windows](1:object), but leave the kitchen window.", {"kitchen_window"}),
        (CLOSE + "[all the windows](1:object) but leave the kitchen window as it is.", {"kitchen_window"}),
        (CLOSE + "[every window](1:object), but skip the bedroom.", {"bedroom_window"}),
        (CLOSE + "[all the windows](1:object) and leave out the kitchen one.", {"kitchen_window"}),
        (CLOSE + "[every window](1:object), but skip the bedroom if Anna is asleep.", set()),
        (CLOSE + "[the windows](1:object) everywhere but in the kitchen.", {"kitchen_window"}),
        (CLOSE + "[the windows](1:object), all but the bedroom window.", {"bedroom_window"}),
        (CLOSE + "[every window](1:object) except [in the kitchen](1:location).", {"kitchen_window"}),
        (CLOSE + "[every window](1:object) except for the kitchen.", {"kitchen_window"}),
        (CLOSE + "[every window except the kitchen's](1:object).", {"kitchen_window"}),
        ("Except for the bedroom window, " + CLOSE + "[all the windows](1:object).", {"bedroom_window"}),
        ("Apart from the bedroom, please " + CLOSE + "[all the windows](1:object).", {"bedroom_window"}),
        ("Hurry! Save for the bedroom one " + CLOSE + "[the windows](1:object).", {"bedroom_window"}),
        (
            CLOSE + "[the windows](1:object) except the kitchen one and the bedroom one",
            {"kitchen_window", "bedroom_window"},
        ),
    ],
)
def test_what_is_left_out_is_not_meant(text: str, left_out: set[str]) -> None:
    assert candidates(text) == WINDOWS - left_out


def test_a_clause_that_tells_which_one_is_left_out_is_not_lost() -> None:
    order = "[Turn](1:change_state) [off](1:state) [all the lights](1:object) "
    with pytest.raises(ImpossibleGoalError, match="'the one where the bed is'"):
        candidates(f"{order}except the one where the bed is.")


def test_what_comes_after_an_exclusion_is_still_said() -> None:
    text = (
        "[Bring](1:bringing) [all the pens except the red one](1:object) [to Anna](1:recipient) and "
        "[close](2:change_state) [the front door](2:object)."
    )
    grounded = ground(read_markup(text, DOMAIN.ontology, flow=[1, 2]), DOMAIN).tasks[0]
    assert grounded.objects[0].candidates == ("pen_1",)
    assert not grounded.objects[0].is_all
    assert [person.candidates for person in grounded.recipients] == [("anna",)]


@pytest.mark.parametrize("which", ["the dirty ones", "the one on the couch"])
def test_what_nobody_can_know_beforehand_is_refused(which: str) -> None:
    with pytest.raises(ImpossibleGoalError, match="cannot be known beforehand"):
        candidates(f"[Bring](1:bringing) [me](1:recipient) [all the mugs](1:object) except {which}.")


MUG = "[Bring](1:bringing) [me](1:recipient) [a mug](1:object)"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (MUG + " that is not red.", {"mug_2"}),
        (MUG + " which isn't the green one.", {"mug_1"}),
        (MUG + ", not the red one.", {"mug_2"}),
        (MUG + " that's red.", {"mug_1"}),
        (CLOSE + "[the window](1:object) that is not [in the kitchen](1:location).", WINDOWS - {"kitchen_window"}),
        ("[Bring](1:bringing) [me](1:recipient) [the cup](1:object), not the mug.", {"cup_1", "cup_2"}),
    ],
)
def test_what_a_clause_says_about_colours_and_places_is_heeded(text: str, meant: set[str]) -> None:
    assert candidates(text) == meant


def test_what_a_clause_says_about_states_is_heeded() -> None:
    for clause, value in (("is not dirty", "clean"), ("is still dirty", "dirty"), ("is already dirty", "dirty")):
        text = f"{MUG} that {clause}."
        assert ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0].objects[0].where == (
            ("cleanliness", value),
        )
    text = CLOSE + "[the windows](1:object) that are [open](1:state)."
    task = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0]
    assert (task.state, task.objects[0].where) == ("closed", (("aperture", "open"),))


def test_a_whichever_is_any_that_is_so() -> None:
    text = CLOSE + "[whichever of the windows is still open](1:object)."
    window = ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0].objects[0]
    assert (window.is_any, window.where) == (True, (("aperture", "open"),))


def test_what_is_left_out_stays_so_for_a_pronoun() -> None:
    text = "[Take](1:taking) [a pen](1:object) that is not red, and [give](2:bringing) [it](2:object=a pen) to Anna."
    first, second = ground(read_markup(text, DOMAIN.ontology, flow=[1, 2]), DOMAIN).tasks
    assert first.objects == second.objects


def test_what_is_said_after_an_aside_counts() -> None:
    text = "[Bring](1:bringing) [me](1:recipient) [the cup](1:object), not the mug, and [the pen](1:object)."
    assert len(ground(read_markup(text, DOMAIN.ontology, flow=[1]), DOMAIN).tasks[0].objects) == 2


@pytest.mark.parametrize("clause", ["that is not on the desk", "that isn't Tom's"])
def test_a_clause_that_nobody_can_heed_is_refused(clause: str) -> None:
    with pytest.raises(InputError):
        candidates(f"{MUG} {clause}.")


def test_leaving_out_everything_is_refused() -> None:
    with pytest.raises(ImpossibleGoalError, match="leaves nothing"):
        candidates(CLOSE + "[the front door](1:object) except the front door.")


def test_a_condition_is_no_exclusion() -> None:
    text = CLOSE + "[the windows](1:object), but not if [the heater](2:object) [is](2:check_state) [on](2:state)."
    assert candidates(text, 2) == WINDOWS


def test_what_is_left_out_ahead_of_an_order_is_of_that_order() -> None:
    text = "[Close](1:change_state) [all the windows](1:object) and, except for the kitchen, [turn](2:change_state) "
    both = ground(
        read_markup(text + "[off](2:state) [all the lights](2:object).", DOMAIN.ontology, flow=[1, 2]), DOMAIN
    ).tasks
    assert set(both[0].objects[0].candidates) == WINDOWS
    assert "kitchen_light" not in both[1].objects[0].candidates
    assert "bedroom_light" in both[1].objects[0].candidates
