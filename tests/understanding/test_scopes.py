"""How far a case reaches: replies, questions in a row, what replaces an order, what goes on in any case."""

from __future__ import annotations

from typing import Any

import pytest
from annotated import clauses
from readings import flow

from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides
from decomplex_bt.understanding.interpreter import Interpreter

ASK_LEA = (
    "If [Lea](1:object) [is](1:check_state) [in the attic](1:location), [ask](2:informing) [her](2:recipient) "
    "[to sing](2:message). "
)
TELL_ANN = ", [tell](4:informing) [Ann](4:recipient)."


@pytest.mark.parametrize(
    ("reply", "role", "side"),
    [
        ("If [she](3:object) [refuses](3:check_state)", "condition", "<1+"),
        ("Should [she](3:object) [decline](3:check_state)", "condition", "<1+"),
        ("If [she](3:object) [agrees](3:check_state)", "condition", "<1+"),
        ("If [she](3:object) won't [sing](3:check_state)", "condition", "<1+"),
        ("If [she](3:object) [is](3:check_state)n't", "mention", "<1"),
        ("If [Lea](3:object) [is](3:check_state) [out](3:state)", "mention", "<1"),
    ],
)
def test_how_somebody_replies_is_asked_where_they_are_asked(reply: str, role: str, side: str) -> None:
    found = clauses(ASK_LEA + reply + TELL_ANN)
    roles = stated_roles(found, ("condition", "task", "mention", "task"))
    assert roles == ("condition", "task", role, "task")
    predicted = "top" if role == "condition" else "<1"
    assert stated_sides(found, roles, ("top", "<1+", predicted, "<1+"))[2] == side


def test_a_reply_is_no_failure_of_the_question() -> None:
    found = clauses(
        "[Ask](1:informing) [Lea](1:recipient) [to sing](1:message). If [she](2:object) [refuses](2:check_state), "
        "[tell](3:informing) [Ann](3:recipient)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == ("task", "condition", "task")


def test_who_refuses_what_is_offered_does_not_get_it() -> None:
    found = clauses(
        "[Offer](1:bringing) [Lea](1:recipient) [the pear](1:object), and if [she](2:object) [refuses](2:check_state), "
        "[tell](3:informing) [Ann](3:recipient)."
    )
    assert stated_roles(found, ("condition", "mention", "task")) == ("condition", "mention", "task")


def test_the_other_reply_is_of_the_same_condition() -> None:
    found = clauses(
        "[Ask](1:informing) [Lea](1:recipient) [to sing](1:message). If [she](2:object) [agrees](2:check_state), "
        "[bring](3:bringing) [her](3:recipient) [the harp](3:object); if [she](4:object) [refuses](4:check_state), "
        "[tell](5:informing) [Ann](5:recipient)."
    )
    assert stated_roles(found, ("task", "condition", "task", "condition", "task"))[3] == "mention"


@pytest.mark.parametrize(("subject", "side"), [("it", "<2"), ("she", "<1")])
def test_an_echo_of_a_thing_passes_a_reply(subject: str, side: str) -> None:
    found = clauses(
        "If [the attic](1:object) [is](1:check_state) [locked](1:state), [ask](2:informing) [Lea](2:recipient) "
        f"[for the key](2:message); if [she](3:object) [refuses](3:check_state), [call](4:informing) "
        f"[Ann](4:recipient). If [{subject}](5:object) [is](5:check_state)n't, [go](6:motion) [in](6:goal)."
    )
    roles = ("condition", "task", "condition", "task", "mention", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1+", "<1", "<1+"))[4] == side


@pytest.mark.parametrize(
    ("case", "predicted", "expected"),
    [
        ("then [give](4:bringing) [it](4:object) [to Ann](4:recipient)", "<1+", ("top", ">1+", "<1-")),
        (
            "in which case [give](4:bringing) [it](4:object) [to Ann](4:recipient)",
            "<1-",
            ("top", ">1+", "<1-"),
        ),
        # another order in its place: what the "unless" keeps from is left open
        (
            ", in which case [close](4:change_state) [the hatch](4:object)",
            "<1+",
            (">1+", ">1+", "<1-"),
        ),
        # a further step
        (", then [close](4:change_state) [the hatch](4:object)", "top", (">1+", ">1+", "top")),
        ("or [close](4:change_state) [the hatch](4:object)", "<1+", (">1+", ">1+", "<1+")),
    ],
)
def test_what_an_unless_is_followed_by_is_done_instead(case: str, predicted: str, expected: tuple[str, ...]) -> None:
    found = clauses(
        "[sweep](1:change_state) [the loft](1:object) and [give](2:bringing) [Leo](2:recipient) [the bill](2:object) "
        f"unless [Tim](3:object)['s](3:check_state) [asleep](3:state) {case}"
    )
    roles = ("task", "task", "condition", "task")
    sides = stated_sides(found, roles, (">1+", ">1+", "top", predicted))
    assert (*sides[:2], sides[3]) == expected


@pytest.mark.parametrize(
    ("order", "role"),
    [
        ("you've [waxed](2:change_state) [it](2:object)", "again"),
        ("you've [waxed](2:change_state) [the hall](2:object)", "task"),
        ("you've [dried](2:change_state) [it](2:object)", "task"),
    ],
)
def test_an_order_that_is_said_to_be_done_by_then_is_said_again(order: str, role: str) -> None:
    found = clauses(
        f"[Wax](1:change_state) [the floor](1:object). When {order}, [open](3:change_state) [the hatch](3:object)."
    )
    assert stated_roles(found, ("task", "task", "task"))[1] == role


@pytest.mark.parametrize("predicted", ["<1+", "<1-"])
@pytest.mark.parametrize(
    ("question", "is_apart"),
    [
        ("[Bulb](3:object) [out](3:check_state)?", True),
        ("[Is](3:check_state) [the dog](3:object) [in](3:state)?", True),
        ("[Is](3:check_state) [it](3:object) [torn](3:state)?", False),
        ("[Hatch](3:object) [stuck](3:check_state)?", False),
        ("If [the dog](3:object) [is](3:check_state) [in](3:state),", False),
    ],
)
def test_a_question_about_another_thing_is_asked_in_any_case(question: str, is_apart: bool, predicted: str) -> None:
    found = clauses(
        f"[Hatch](1:object) [open](1:check_state)? [Close](2:change_state) [it](2:object). {question} "
        "[call](4:informing) [Ann](4:recipient)."
    )
    sides = stated_sides(found, ("condition", "task", "condition", "task"), ("top", "<1+", predicted, "<1+"))
    assert sides[2] == ("top" if is_apart else predicted)


@pytest.mark.parametrize(
    ("state", "expected"), [("locked or unlocked", "locked"), ("locked or stuck", "stuck"), ("locked", "locked")]
)
def test_of_two_opposites_the_first_is_asked(state: str, expected: str) -> None:
    (check,) = clauses(f"[Is](1:check_state) [the loft](1:object) [{state}](1:state)?")
    assert check.wording.state == expected


@pytest.mark.parametrize(
    ("order", "expected"),
    [
        ("then [bring](3:bringing) [me](3:recipient) [the basket](3:object)", "top"),
        ("and then [go](3:motion) [to the attic](3:goal)", "top"),
        ("then [fold](3:change_state) [it](3:object)", "<1+"),  # whatever it is done to may need it
        ("and only then [go](3:motion) [to the attic](3:goal)", "<1+"),
        ("and then [tell](3:informing) [Ann](3:recipient)", "<1+"),
        ("and [bring](3:bringing) [me](3:recipient) [the basket](3:object)", "<1+"),
    ],
)
@pytest.mark.parametrize(("state", "switch"), [("on", "off"), ("off", "on")])
def test_a_then_leads_on_from_what_undoes_what_was_found(state: str, switch: str, order: str, expected: str) -> None:
    found = clauses(
        f"If [the iron](1:object) [is](1:check_state) [{state}](1:state), [turn](2:change_state) [it](2:object) "
        f"[{switch}](2:state), {order}."
    )
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1+"))[2] == expected


def test_a_then_stays_in_the_case_behind_what_undoes_nothing() -> None:
    found = clauses(
        "If [the iron](1:object) [is](1:check_state) [on](1:state), [bring](2:bringing) [me](2:recipient) "
        "[it](2:object), then [close](3:change_state) [the hatch](3:object)."
    )
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1+"))[2] == "<1+"


@pytest.mark.parametrize(
    ("mention", "expected"),
    [
        ("if you can't [see](3:searching) [it](3:object)", "<1+"),
        ("if you can't [find](3:searching) [the harp](3:object)", "<1+"),
        ("if you can't [find](3:searching) [Lea](3:object)", "top"),
    ],
)
def test_what_is_done_with_what_is_sought_depends_on_its_being_found(mention: str, expected: str) -> None:
    found = clauses(
        "[Find](1:searching) [the harp](1:object). [Bring](2:bringing) [it](2:object) [here](2:goal), and "
        f"{mention}, [tell](4:informing) [Ann](4:recipient)."
    )
    sides = stated_sides(found, ("condition", "task", "mention", "task"), ("top", "top", "<1", "<1+"))
    assert sides[1] == expected


@pytest.mark.parametrize(
    ("ahead", "behind", "side"),
    [
        (
            "[Dust](1:change_state) [the shelf](1:object)",
            "[put](4:placing) [them](4:object) [there](4:goal) instead",
            "top",
        ),
        (
            "[Dust](1:change_state) [the toys](1:object)",
            "[put](4:placing) [them](4:object) [there](4:goal) instead",
            ">1-",
        ),
        ("[Dust](1:change_state) [the shelf](1:object)", "[wash](4:change_state) [them](4:object) instead", ">1-"),
        ("[Dust](1:change_state) [the shelf](1:object)", "[put](4:placing) [them](4:object) [there](4:goal)", ">1-"),
    ],
)
def test_what_is_done_instead_stands_in_place_of_the_last_order_of_its_kind(ahead: str, behind: str, side: str) -> None:
    found = clauses(
        f"{ahead} and [put](2:placing) [the toys](2:object) [in the box](2:goal). If [the box](3:object) "
        f"[is](3:check_state) [full](3:state), {behind}."
    )
    roles = ("task", "condition")
    sides = stated_sides(found, ("task", *roles, "task"), (">1-", ">1-", "top", "<1+"))
    assert sides[0] == side


@pytest.mark.parametrize(
    ("first", "second", "side"),
    [
        ("[it](1:object)['s](1:check_state) [the phone](1:object)",
         "it['s](3:check_state) [the bell](3:object)", "<1-"),
        ("[Lea](1:object) [is](1:check_state) [in](1:state)",
         "[a dog](3:object) [is](3:check_state) [there](3:location) instead", "<1-"),
        ("[Lea](1:object) [is](1:check_state) [in](1:state)", "it['s](3:check_state) [the bell](3:object)", "<1+"),
        ("[it](1:object)['s](1:check_state) [the phone](1:object)",
         "[it](3:object)['s](3:check_state) [loud](3:state)", "<1+"),
    ],
)  # fmt: skip
def test_a_rival_is_not_asked_where_the_first_holds(first: str, second: str, side: str) -> None:
    found = clauses(f"If {first}, [answer](2:informing); if {second}, [go](4:motion) [out](4:goal).")
    roles = ("condition", "task", "condition", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1+"))[2] == side


@pytest.mark.parametrize(
    ("orders", "sides", "settled"),
    [
        ("if [it](4:object)['s](4:check_state) [full](4:state)", ("top", "top"), (">1+", "top")),
        ("if [it](4:object)['s](4:check_state) [full](4:state)", (">1+", "<1+"), (">1+", "top")),
        ("unless [it](4:object)['s](4:check_state) [clean](4:state)", ("top", "<1-"), (">1+", "top")),
        ("if [Ann](4:object)['s](4:check_state) [here](4:location)", ("top", "top"), ("top", "top")),
        (", and if [it](4:object)['s](4:check_state) [full](4:state)", ("top", "top"), ("top", "top")),
    ],
)
def test_orders_in_a_row_hang_on_the_condition_behind_each(
    orders: str, sides: tuple[str, str], settled: tuple[str, str]
) -> None:
    found = clauses(
        "[Water](1:change_state) [the fern](1:object) if [it](2:object)['s](2:check_state) [dry](2:state), "
        f"[empty](3:change_state) [the bin](3:object) {orders}, and then [lock](5:change_state) [the door](5:object)."
    )
    roles = ("task", "condition", "task", "condition", "task")
    assert stated_sides(found, roles, (">1+", "top", *sides, "top"))[2:4] == settled


@pytest.mark.parametrize(
    ("first", "second", "side"),
    [
        ("clean", "if [it](4:object)['s](4:check_state) [dirty](4:state)", "<1-"),
        ("clean", "if [it](4:object) [is](4:check_state)n't", "<1-"),
        ("clean", "unless [it](4:object)['s](4:check_state) [clean](4:state)", "<1-"),
        ("clean", "if [it](4:object)['s](4:check_state) [clean](4:state)", "<1+"),
    ],
)
def test_an_order_may_hang_on_the_other_side_told_behind_it(first: str, second: str, side: str) -> None:
    found = clauses(
        f"[Bring](1:bringing) [the cup](1:object) if [it](2:object)['s](2:check_state) [{first}](2:state) and "
        f"[move](3:placing) [it](3:object) {second}."
    )
    roles = ("task", "condition", "task", "mention")
    assert stated_sides(found, roles, (">1+", "top", "<1+", "<1"))[2] == side


@pytest.mark.parametrize(
    ("listed", "sides"),
    [
        (", and then [feed](4:change_state) [the cat](4:object)", ("<1-", "top")),
        (", otherwise [feed](4:change_state) [the cat](4:object)", ("<1-", "<1+")),
        (" and [feed](4:change_state) [the cat](4:object)", ("<1+", "<1+")),
    ],
)
def test_what_is_listed_on_behind_an_if_it_isnt_is_done_anyway(listed: str, sides: tuple[str, str]) -> None:
    found = clauses(
        "See if [the gate](1:object) [is](1:check_state) [shut](1:state), [shut](2:change_state) [it](2:object) if "
        f"[it](3:object) [is](3:check_state)n't{listed}."
    )
    settled = stated_sides(found, ("condition", "task", "mention", "task"), ("top", "<1+", "<1", "<1+"))
    assert (settled[1], settled[3]) == sides


@pytest.mark.parametrize(("then", "side"), [("and then", "top"), ("and", "<1+")])
def test_what_a_then_lists_on_behind_an_if_it_is_is_done_anyway(then: str, side: str) -> None:
    found = clauses(
        "Check if [the gate](1:object) [is](1:check_state) [open](1:state), [shut](2:change_state) [it](2:object) if "
        f"[it](3:object) [is](3:check_state), {then} [feed](4:change_state) [the cat](4:object)."
    )
    settled = stated_sides(found, ("condition", "task", "mention", "task"), ("top", "<1+", "<1", "<1+"))
    assert (settled[1], settled[3]) == ("<1+", side)


@pytest.mark.parametrize("ask", ["Could you", "Please"])
def test_a_case_in_a_polite_question_is_a_case(ask: str) -> None:
    end = "?" if ask == "Could you" else "."
    found = clauses(
        f"{ask} [shut](1:change_state) [the gate](1:object) if [it](2:object) [is](2:check_state) [open](2:state){end}"
    )
    assert found[1].is_check
    assert not found[1].is_question


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the vet calls, bring me the phone, and if the salesman calls, lock the hatch.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        (
            "If there is a parcel, bring it in; should there be letters, put them on the desk.",
            [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}],
        ),
        (  # what may be in that very thing
            "If there's a parcel, bring it in, and if there's money in it, give it to Tom.",
            [{"if": 1, "then": [2, {"if": 3, "then": [4]}]}],
        ),
        (
            "Is the radio on? If it is, turn it off, and if nobody's in the kitchen turn the light off too.",
            [{"if": [1, 2], "then": [3]}, {"if": 4, "else": [5]}],
        ),
        (
            "Is the radio on? If it is, turn it off, and if it's hot unplug it too.",
            [{"if": [1, 2], "then": [3, {"if": 4, "then": [5]}]}],
        ),
    ],
)
def test_what_is_asked_alike_of_another_is_asked_beside(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Put the book on the shelf. If you see the pencil, put it in the drawer.", [1, {"if": 2, "then": [3]}]),
        (
            "Put the book on the shelf. If it's dusty, put it in the drawer instead.",
            [{"if": 2, "then": [3], "else": [1]}],
        ),
    ],
)
def test_another_thing_that_turns_up_is_put_away_besides(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "Find Lea. Should she be sitting, bring her tea, and should she be on her feet, follow her.",
            [1, {"if": 2, "then": [3], "else": [{"if": 4, "then": [5]}]}],
        ),
        (
            "Go to the shed and put the sack on the bench, if there's room on it.",
            [1, {"if": 3, "then": [2]}],
        ),
        (
            "If the Do Not Disturb sign's on the door leave it and come back, if not strip the bed.",
            [{"if": 1, "then": [2], "else": [3]}],
        ),
        (
            "Don't light the stove unless it's cold, if it is then shut the hatch and light it.",
            [{"if": [2, 3], "then": [{"same": [1, 5]}, 4]}],
        ),
    ],
)
def test_postures_room_signs_and_echoes(interpreter: Interpreter, text: str, expected: object) -> None:
    assert interpreter.interpret(text).to_json()["flow"] == expected
