"""Which of what a phrase names were named, or given away, before."""

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import ImpossibleGoalError
from decomplex_bt.planning.belief import Belief
from decomplex_bt.planning.ground_task import GroundTask, Referent
from decomplex_bt.planning.grounding import ground
from decomplex_bt.planning.percept import Percept
from decomplex_bt.planning.pursuit import pursue

DOMAIN = load_domain("household")
GIVE_TOM = "[Give](1:bringing) [Tom](1:recipient) "
GIVE_ME = " [give](2:bringing) [me](2:recipient) "


def tasks(text: str, flow: list) -> tuple[GroundTask, ...]:
    return ground(read_markup(text, DOMAIN.ontology, flow=flow), DOMAIN).tasks


def second(text: str, flow: list | None = None) -> Referent:
    return tasks(text, flow or [1, 2])[1].objects[0]


@pytest.mark.parametrize(
    "text",
    [
        GIVE_TOM + "[one mug](1:object)," + GIVE_ME + "[the other one](2:object=the other mug)",
        GIVE_TOM + "[one mug](1:object)," + GIVE_ME + "[the other](2:object=one mug)",
        GIVE_TOM + "[one of the mugs](1:object)," + GIVE_ME + "[the other mug](2:object)",
        GIVE_TOM + "[the mug](1:object)," + GIVE_ME + "[another](2:object=another mug)",
        GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[one more mug](2:object)",
        GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[a different mug](2:object)",
        GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[a mug](2:object)",
        GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[one](2:object=a mug)",
    ],
)
def test_another_one_is_not_that_of_a_task_before(text: str) -> None:
    assert [other.candidates for other in second(text).others] == [("mug_1", "mug_2")]


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        (GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[it](2:object=a mug)", None),
        (GIVE_TOM + "[the mug](1:object)," + GIVE_ME + "[the mug](2:object)", None),
        (GIVE_TOM + "[some milk](1:object)," + GIVE_ME + "[a mug](2:object)", None),
        (GIVE_TOM + "[a mug](1:object) if you can [find](2:searching) [one](2:object=a mug)", [{"if": 2, "then": [1]}]),
        ("[Take](1:taking) [a mug](1:object) and" + GIVE_ME + "[a mug](2:object)", None),
        ("[Take](1:taking) [a mug](1:object) and" + GIVE_ME + "[some more milk](2:object)", None),
    ],
)
def test_the_same_one_stays_the_same(text: str, flow: list | None) -> None:
    assert second(text, flow).others == ()


def test_what_another_branch_gives_away_is_not_gone() -> None:
    text = (
        "If [Tom](1:object) [is](1:check_state) [home](1:state) [give](2:bringing) [him](2:recipient=Tom) "
        "[a mug](2:object), else [give](3:bringing) [me](3:recipient) [a mug](3:object)."
    )
    assert tasks(text, [{"if": 1, "then": [2], "else": [3]}])[2].objects[0].others == ()


@pytest.mark.parametrize(
    "text",
    [
        GIVE_TOM + "[the red mug](1:object)," + GIVE_ME + "[the other mug](2:object)",
        "Not the red mug. [Take](1:taking) [a pen](1:object)," + GIVE_ME + "[the other one](2:object=the other mug)",
    ],
)
def test_the_other_of_two_is_that_which_was_not_named(text: str) -> None:
    assert second(text).candidates == ("mug_2",)


def test_the_other_of_the_clean_one_need_not_be_clean() -> None:
    other = second(GIVE_TOM + "[the clean mug](1:object)," + GIVE_ME + "[the other](2:object=the other clean mug)")
    assert other.where == ()


@pytest.mark.parametrize("more", ["another water", "some water"])
def test_one_more_than_there_are_is_refused(more: str) -> None:
    with pytest.raises(ImpossibleGoalError, match="only one in this house"):
        second(GIVE_TOM + "[a glass of water](1:object)," + GIVE_ME + f"[{more}](2:object)")


def test_more_than_there_are_is_refused_in_words_that_fit() -> None:
    with pytest.raises(ImpossibleGoalError, match="'three mugs': there are only 2 in this house; ask for fewer"):
        tasks("[Take](1:taking) [three mugs](1:object)", [1])
    with pytest.raises(ImpossibleGoalError, match="has named all of them before"):
        second(GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[the other two mugs](2:object)")


def test_a_pen_and_another_are_two() -> None:
    objects = tasks("[Take](1:taking) [a pen and another pen](1:object)", [1])[0].objects
    assert [referent.count for referent in objects] == [2]


def test_the_robot_fetches_the_other_one() -> None:
    one, other = tasks(GIVE_TOM + "[a mug](1:object)," + GIVE_ME + "[another mug](2:object)", [1, 2])
    belief = Belief(DOMAIN)
    places = {"mug_1": "tom", "mug_2": "desk", "user": "study", "tom": "study"}
    belief.update(Percept(room="study", places=places))
    pursuit = pursue(other, belief, {one.objects[0]: ("mug_1",)}, since=1)
    assert "mug_2" in {name for atom in pursuit.goal_atoms for name in atom.objects}


def test_a_long_chain_of_cases_is_grounded() -> None:
    depth = 40  # if each case doubled the work, this would never end
    last = 2 * depth + 1
    text, flow = f"[go]({last}:motion) [to the kitchen]({last}:goal)", [last]
    for i in range(last - 2, 0, -2):
        condition = f"if [the tv]({i}:object) [is]({i}:check_state) [on]({i}:state), "
        text = f"{condition}[close]({i + 1}:change_state) [the window]({i + 1}:object), else {text}"
        flow = [{"if": i, "then": [i + 1], "else": flow}]
    assert len(tasks(text, flow)) == last
