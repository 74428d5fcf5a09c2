"""On which side of its condition a task stands where English settles it, and where it is left to the models."""

from __future__ import annotations

import pytest
from annotated import clauses

from decomplex_bt.understanding.control_flow.roles import stated_roles
from decomplex_bt.understanding.control_flow.sides import stated_sides


@pytest.mark.parametrize(
    ("markup", "attachment", "expected"),
    [
        # "if it does not work" right behind what it mentions
        (
            "[Switch](1:change_state) [the fan](1:object) [on](1:state), and if [it](2:object) doesn't "
            "[work](2:check_state), [open](3:change_state) [the window](3:object).",
            "<1+",
            "<1-",
        ),
        # denied by its own words
        (
            "[See](1:check_state) whether [it](1:object) is [dry](1:state). If [it](2:object) doesn't "
            "[feel](2:check_state) [dry](2:state), [open](3:change_state) [the window](3:object).",
            "<1-",
            "<1+",
        ),
        # turned round by an "otherwise"
        (
            "[See](1:check_state) whether [it](1:object) is [dry](1:state). If [it](2:object) doesn't "
            "[feel](2:check_state) [dry](2:state), fine, otherwise [open](3:change_state) [the window](3:object).",
            "<1-",
            "<1-",
        ),
    ],
)
def test_what_follows_an_if_it_does_not_is_done_where_it_does_not(markup: str, attachment: str, expected: str) -> None:
    found = clauses(markup)
    roles = ("condition", "mention", "task")
    assert stated_sides(found, roles, ("top", "<1", attachment)) == ("top", "<1", expected)


@pytest.mark.parametrize("attachment", ["<1+", "<1-"])
@pytest.mark.parametrize("negation", ["", "n't"])
def test_what_is_forbidden_in_a_case_is_done_in_the_other(negation: str, attachment: str) -> None:
    found = clauses(
        f"If [the bin](1:object) [is](1:check_state){negation} [full](1:state), don't [empty](2:change_state) it."
    )
    assert found[1].is_forbidden
    assert stated_sides(found, ("condition", "task"), ("top", attachment)) == ("top", "<1-")


def test_what_is_done_instead_of_what_is_forbidden_is_done_in_its_case() -> None:
    found = clauses(
        "If [the rug](1:object) [is](1:check_state) [wet](1:state), don't [roll](2:change_state) it, "
        "[hang](3:placing) it up."
    )
    sides = stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1-"))
    assert sides == ("top", "<1-", "<1+")


def test_what_an_otherwise_opens_is_never_done_where_the_condition_holds() -> None:
    found = clauses(
        "If [it](1:object)['s](1:check_state) [hot](1:state), fine, otherwise [put](2:placing) [it](2:object) away."
    )
    assert stated_sides(found, ("condition", "task"), ("top", "<1+")) == ("top", "<1-")


@pytest.mark.parametrize(
    ("order", "joined", "side"),
    [
        ("[Go](1:motion)", False, ">1+"),
        ("Don't [go](1:motion)", False, ">1-"),
        ("[Go](1:motion)", True, ">1+"),
        ("Don't [go](1:motion)", True, ">1-"),
    ],
)
@pytest.mark.parametrize("found", [">1+", ">1-"])
def test_what_stands_before_an_unless_is_done_as_it_is_stated_but_what_is_forbidden(
    order: str, joined: bool, side: str, found: str
) -> None:
    more = " or [the lamp](3:object) [is](3:check_state) [off](3:state)" if joined else ""
    read = clauses(f"{order} unless [it](2:object)['s](2:check_state) [wet](2:state){more}.")
    roles = ("task", "condition", "and")[: len(read)]
    assert stated_sides(read, roles, (found, "top", "<1+")[: len(read)])[0] == side


@pytest.mark.parametrize(
    ("opening", "side"), [("otherwise", "<1-"), ("if not,", "<1-"), ("then", "<1+"), ("and also", "<1+")]
)
def test_what_restricts_what_an_otherwise_opens_is_asked_there(opening: str, side: str) -> None:
    found = clauses(
        "If [it](1:object)['s](1:check_state) [dry](1:state), [fold](2:change_state) [it](2:object); "
        f"{opening} [hang](3:placing) [it](3:object) up, unless [the line](4:object) [is](4:check_state) "
        "[full](4:state)."
    )
    roles = ("condition", "task", "task", "condition")
    assert stated_sides(found, roles, ("top", "<1+", ">1+", "<1+"))[3] == side


def test_what_an_unless_of_two_parts_opens_is_done_as_it_is_stated_till_something_turns_it() -> None:
    read = clauses(
        "Unless [it](1:object)['s](1:check_state) [wet](1:state) or [the lamp](2:object) [is](2:check_state) "
        "[off](2:state), [go](3:motion) [out](3:goal) and [wait](4:motion), otherwise [sit](5:motion) down."
    )
    roles = ("condition", "and", "task", "task", "task")
    assert stated_sides(read, roles, ("top", "<1+", "<1-", "<1-", "<1-")) == ("top", "<1+", "<1+", "<1+", "<1-")


@pytest.mark.parametrize(
    ("check", "then", "expected"),
    [
        ("[the box](2:object) [is](2:check_state) [full](2:state)", "[put](3:placing) [it](3:object)", (">1-", "top")),
        (
            "[the box](2:object) [is](2:check_state) [in use](2:state)",
            "[put](3:placing) [it](3:object)",
            (">1-", "top"),
        ),
        ("[the box](2:object) [is](2:check_state) [dirty](2:state)", "[put](3:placing) [it](3:object)", ("top", "top")),
        ("[the hall](2:object) [is](2:check_state) [full](2:state)", "[put](3:placing) [it](3:object)", ("top", "top")),
        (
            "[the box](2:object) [is](2:check_state) [full](2:state)",
            "[put](3:placing) [a lid](3:object)",
            ("top", "top"),
        ),
    ],
)
def test_what_finds_its_place_full_is_put_elsewhere_instead(check: str, then: str, expected: tuple[str, str]) -> None:
    found = clauses(
        f"[Put](1:placing) [the ball](1:object) [in the box](1:goal). If {check}, {then} [on the shelf](3:goal)."
    )
    assert stated_sides(found, ("task", "condition", "task"), ("top", "top", "<1+"))[:2] == expected


def test_what_is_done_with_a_thing_depends_on_its_being_found() -> None:
    found = clauses(
        "[Get](1:taking) [the tongs](1:object) [from the shed](1:source) and [hang](2:placing) [them](2:object) up. "
        "If [they](3:object)['re](3:check_state) not [there](3:location), [call](4:informing) me."
    )
    roles = ("condition", "task", "mention", "task")
    assert stated_sides(found, roles, ("top", "top", "<1", "<1+"))[1] == "<1+"


@pytest.mark.parametrize(
    ("opening", "attachment", "expected"),
    [("or else", "<1-", "<1+"), ("if not,", "<1-", "<1+"), ("otherwise", "<1+", "<1+"), ("and", "<1-", "<1-")],
)
def test_an_otherwise_behind_what_takes_up_the_find_opens_the_other_side(
    opening: str, attachment: str, expected: str
) -> None:
    found = clauses(
        "[Look](1:searching) [for the map](1:object) [in the car](1:location) and [bring](2:bringing) [it](2:object) "
        f"if you [see](3:searching) [it](3:object), {opening} [call](4:informing) [Tom](4:recipient) and "
        "[wait](5:motion)."
    )
    sides = ("top", "<1+", "<1", attachment, attachment)
    read = stated_sides(found, ("condition", "task", "mention", "task", "task"), sides)
    assert read == ("top", "<1+", "<1", expected, expected)


@pytest.mark.parametrize("attachment", ["<1+", "<1-"])
def test_an_otherwise_behind_an_echo_opens_the_other_side(attachment: str) -> None:
    """The echo means the other side once the one it affirms has a task (`arcs.flip_of`)."""
    found = clauses(
        "[See](1:check_state) if [it](1:object) is [dry](1:state), [fold](2:change_state) [it](2:object) if "
        "[it](3:object) [is](3:check_state), otherwise [hang](4:placing) [it](4:object) up."
    )
    roles = ("condition", "task", "mention", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1", attachment))[3] == "<1+"


def test_failing_that_behind_an_echo_opens_the_other_side() -> None:
    found = clauses(
        "[See](1:check_state) if [it](1:object) is [dry](1:state). [Fold](2:change_state) [it](2:object) only if "
        "[it](3:object) [is](3:check_state); failing that, [hang](4:placing) [it](4:object) up."
    )
    roles = ("condition", "task", "mention", "task")
    for attachment in ("<1+", "<1-"):
        assert stated_sides(found, roles, ("top", "<1+", "<1", attachment))[3] == "<1+"


@pytest.mark.parametrize(("denial", "side"), [("", "<1+"), ("n't", "<1-")])
def test_what_is_done_if_that_proves_true_is_done_there(denial: str, side: str) -> None:
    found = clauses(
        f"[Is](1:check_state){denial} [the pump](1:object) [in the shed](1:location)? [Ask](2:informing) "
        "[Tom](2:recipient). [Bring](3:bringing) [it](3:object) [to me](3:recipient) if you [find](4:searching) "
        "[it](4:object)."
    )
    roles = ("condition", "task", "task", "mention")
    for attachment in ("<1+", "<1-"):
        assert stated_sides(found, roles, ("top", "<1-", attachment, "<1"))[2] == side


def test_what_is_done_before_that_is_done_in_the_same_case() -> None:
    markup = (
        "If [it](1:object) [is](1:check_state) [wet](1:state), [tell](2:informing) me. Otherwise "
        "[switch](3:change_state) [the pump](3:object) on, {}[connect](4:change_state) [it](4:object) and "
        "[plug](5:change_state) [it](5:object) in."
    )
    roles = ("condition", "task", "task", "task", "task")
    sides = ("top", "<1+", "<1-", "top", "top")
    assert stated_sides(clauses(markup.format("but before that ")), roles, sides) == ("top", "<1+", "<1-", "<1-", "<1-")
    assert stated_sides(clauses(markup.format("and finally ")), roles, sides) == sides


def test_all_that_was_ordered_hangs_on_what_all_this_is_said_of() -> None:
    found = clauses(
        "[Take](1:taking) [the bag](1:object). [Close](2:change_state) [the door](2:object). None of that if [Tom]"
        "(3:object) [is](3:check_state) [in](3:state)."
    )
    assert stated_sides(found, ("task", "task", "condition"), ("top", ">1+", "top")) == (">1-", ">1-", "top")


@pytest.mark.parametrize(
    ("thing", "mention"),
    [("the stove", "<2"), ("the old stove", "<2"), ("the new stove", "<1"), ("the kindling", "<1"), ("the cat", "<1")],
)
def test_a_mention_is_of_what_it_names(thing: str, mention: str) -> None:
    found = clauses(
        "If [the old stove](1:object) [is](1:check_state) [cold](1:state), [see](2:check_state) if [the kindling]"
        f"(2:object) is [dry](2:state). If [{thing}](3:object) [is](3:check_state) [warm](3:state), "
        "[tell](4:informing) me."
    )
    assert stated_sides(found, ("condition", "condition", "mention", "task"), ("top", "<1+", "<1", "<1+"))[2] == mention


@pytest.mark.parametrize(
    ("markup", "attachments", "expected"),
    [
        # within a list
        (
            "[Go](1:motion) [out](1:goal), [feed](2:change_state) [the cat](2:object) if [she](3:object) "
            "[is](3:check_state) [there](3:location), and [lock](4:change_state) [the door](4:object).",
            (">1+", ">1+", "top", "<1+"),
            ("top", ">1+", "top", "top"),
        ),
        # what follows may as well hang on it
        (
            "[Feed](1:change_state) [the cat](1:object) if [she](2:object) [is](2:check_state) [there](2:location), "
            "and [lock](3:change_state) [the door](3:object).",
            (">1+", "top", "<1+"),
            (">1+", "top", "<1+"),
        ),
        # asks whether it is needed
        (
            "[Wash](1:change_state) [the mug](1:object) if [it](2:object)['s](2:check_state) [dirty](2:state) and "
            "[bring](3:bringing) [it](3:object) here.",
            (">1+", "top", "<1+"),
            (">1+", "top", "top"),
        ),
        (
            "[Fill](1:change_state) [the jug](1:object), unless [it](2:object) [is](2:check_state) [full](2:state), "
            "and [bring](3:bringing) [it](3:object) here.",
            (">1+", "top", "<1+"),
            (">1+", "top", "top"),
        ),
        # in the case of another condition
        (
            "If [Tom](1:object) [is](1:check_state) [in](1:state), [wash](2:change_state) [the mug](2:object) if "
            "[it](3:object)['s](3:check_state) [dirty](3:state), and [take](4:bringing) [it](4:object) "
            "[to him](4:recipient).",
            ("top", "<1+", "<1-", "<1+"),
            ("top", ">1+", "<1+", "<2+"),
        ),
    ],
)
def test_a_condition_within_a_list_or_of_need_is_of_one_order(
    markup: str, attachments: tuple[str, ...], expected: tuple[str, ...]
) -> None:
    found = clauses(markup)
    roles = ["condition" if clause.task.type == "check_state" else "task" for clause in found]
    assert stated_sides(found, roles, attachments) == expected


@pytest.mark.parametrize(
    ("first", "second", "check", "expected"),
    [
        # the second takes back the first
        (
            "[Light](1:change_state) [the lamp](1:object)",
            "[blow](2:change_state) [it](2:object) out",
            "if [Ann](3:object) [sneezes](3:check_state)",
            "top",
        ),
        (
            "[Lock](1:change_state) [the shed](1:object)",
            "[unlock](2:change_state) [it](2:object)",
            "when [Ann](3:object) [arrives](3:check_state)",
            "top",
        ),
        (
            "[Hang](1:placing) [the rug](1:object) [on the line](1:goal)",
            "[take](2:taking) [it](2:object) down",
            "if [Ann](3:object) [sneezes](3:check_state)",
            "top",
        ),
        (
            "[Go](1:motion) [to the pond](1:goal)",
            "[come](2:motion) [back](2:direction)",
            "if [Ann](3:object) [sneezes](3:check_state)",
            "top",
        ),
        (
            "[Lock](1:change_state) [the shed](1:object)",
            "[close](2:change_state) [the gate](2:object)",
            "when [Ann](3:object) [arrives](3:check_state)",
            ">1+",
        ),
        (
            "[Take](1:taking) [the rug](1:object)",
            "[put](2:placing) [it](2:object) [back in the hall](2:goal)",
            "if [Ann](3:object) [sneezes](3:check_state)",
            ">1+",
        ),
        # done at a stretch
        (
            "[Lock](1:change_state) [the shed](1:object)",
            "[unlock](2:change_state) [it](2:object) again",
            "if [Ann](3:object) [sneezes](3:check_state)",
            ">1+",
        ),
        (
            "[Empty](1:change_state) [the vase](1:object)",
            "[fill](2:change_state) [it](2:object)",
            "if [Ann](3:object) [sneezes](3:check_state)",
            ">1+",
        ),
        # what is asked comes through the first
        (
            "[Fill](1:change_state) [the pool](1:object)",
            "[call](2:informing) Ann",
            "when [it](3:object)'[s](3:check_state) [full](3:state)",
            "top",
        ),
        (
            "[Start](1:change_state) [the mixer](1:object)",
            "[call](2:informing) Ann",
            "when [it](3:object)'[s](3:check_state) [done](3:state)",
            "top",
        ),
        (
            "[Turn](1:change_state) [the hob](1:object) [on](1:state)",
            "[call](2:informing) Ann",
            "when [it](3:object)'[s](3:check_state) [hot](3:state)",
            "top",
        ),
        (
            "[Turn](1:change_state) [the radio](1:object) [on](1:state)",
            "[call](2:informing) Ann",
            "when [it](3:object)'[s](3:check_state) [hot](3:state)",
            ">1+",
        ),
        (
            "[Send](1:change_state) [the pup](1:object) out",
            "[call](2:informing) Ann",
            "when [he](3:object) [comes](3:check_state) back",
            "top",
        ),
        (
            "[Put](1:placing) [the eggs](1:object) [in the pan](1:goal)",
            "[call](2:informing) Ann",
            "when [they](3:object) [are](3:check_state) [firm](3:state)",
            "top",
        ),
        (
            "[Put](1:placing) [the eggs](1:object) [in the bag](1:goal)",
            "[call](2:informing) Ann",
            "when [they](3:object) [are](3:check_state) [firm](3:state)",
            ">1+",
        ),
        (
            "[Fill](1:change_state) [the pool](1:object)",
            "[call](2:informing) Ann",
            "when [it](3:object)'[s](3:check_state) [sunny](3:state)",
            ">1+",
        ),
        # what is asked is of the thing of the second alone
        (
            "[Shut](1:change_state) [the gate](1:object)",
            "[rinse](2:change_state) [the bowl](2:object)",
            "if [it](3:object)'[s](3:check_state) [dirty](3:state)",
            "top",
        ),
        (
            "[Fold](1:change_state) [the rugs](1:object)",
            "[hang](2:placing) [the towels](2:object) [on the line](2:goal)",
            "if [they](3:object)'re [ripped](3:check_state)",
            "top",
        ),
        (
            "[Bring](1:bringing) [me](1:recipient) [the tea](1:object)",
            "[rinse](2:change_state) [the bowl](2:object)",
            "if [it](3:object)'[s](3:check_state) [dirty](3:state)",
            "top",
        ),
        (
            "[Fold](1:change_state) [the rugs](1:object)",
            "[hang](2:placing) [the towel](2:object) [on the line](2:goal)",
            "if [they](3:object)'re [ripped](3:check_state)",
            ">1+",
        ),
        (
            "[Fold](1:change_state) [the rugs](1:object)",
            "[hang](2:placing) [them](2:object) [on the line](2:goal)",
            "if [they](3:object)'re [ripped](3:check_state)",
            ">1+",
        ),
        (
            "[Get](1:taking) [the sponge](1:object)",
            "[rinse](2:change_state) [the bowl](2:object)",
            "if [it](3:object)'[s](3:check_state) [dirty](3:state)",
            ">1+",
        ),
        (
            "[Shut](1:change_state) [the gate](1:object)",
            "[rinse](2:change_state) [the bowl](2:object)",
            "if [it](3:object)'[s](3:check_state) [windy](3:state)",
            ">1+",
        ),
    ],
)
def test_a_condition_behind_an_order_is_of_that_alone_where_the_one_before_cannot_hang_on_it(
    first: str, second: str, check: str, expected: str
) -> None:
    found = clauses(f"{first} and {second} {check}.")
    assert stated_sides(found, ("task", "task", "condition"), (">1+", ">1+", "top")) == (expected, ">1+", "top")


@pytest.mark.parametrize(
    ("order", "joint", "expected"),
    [
        ("[Wash](1:change_state) [the van](1:object)", "then [shut](3:change_state) [the gate](3:object)", "top"),
        ("[Wash](1:change_state) [the van](1:object)", "then [park](3:change_state) [it](3:object)", "<1-"),
        (
            "[Wash](1:change_state) [the van](1:object)",
            "in that case [shut](3:change_state) [the gate](3:object)",
            "<1-",
        ),
        ("Don't [wash](1:change_state) [the van](1:object)", "and [shut](3:change_state) [the gate](3:object)", "<1-"),
    ],
)
@pytest.mark.parametrize("state", ["isn't", "is"])
def test_what_an_and_adds_behind_an_unless_is_not_done_instead(
    order: str, joint: str, expected: str, state: str
) -> None:
    check = "[is](2:check_state)" + "n't" * (state != "is")
    found = clauses(f"{order}, unless [Tom](2:object) {check} [asleep](2:state), {joint}.")
    roles = ("task", "condition", "task")
    assert stated_sides(found, roles, (">1+", "top", "<1-"))[2] == expected


@pytest.mark.parametrize(
    ("check", "before", "expected"),
    [
        ("nobody [is](3:check_state) [in](3:location)", "<1+", "top"),
        ("nobody [is](3:check_state) [in](3:location)", "<1-", "<1-"),
        ("it['s](3:check_state) [sunny](3:state)", "<1+", "top"),
        ("[it](3:object) [is](3:check_state) [hot](3:state)", "<1+", "<1-"),
    ],
)
def test_what_is_of_another_matter_is_not_asked_in_the_other_case(check: str, before: str, expected: str) -> None:
    found = clauses(
        f"If [the stove](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object) off and, "
        f"if {check}, [open](4:change_state) [the window](4:object)."
    )
    sides = stated_sides(found, ("condition", "task", "condition", "task"), ("top", before, "<1-", "<1+"))
    assert sides == ("top", before, expected, "<1+")


def test_what_is_said_again_is_of_one_type() -> None:
    found = clauses(
        "[Mop](1:change_state) [the hall](1:object), [go](2:motion) [out](2:goal), and [mop](3:change_state) it."
    )
    assert stated_sides(found, ("task", "task", "again"), ("top", "top", "<1")) == ("top", "top", "<2")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("but if [the soil](3:object) [is](3:check_state) [wet](3:state), leave it", (">1-", ">1-", "top")),
        ("and if [the soil](3:object) [is](3:check_state) [wet](3:state) dont bother", (">1-", ">1-", "top")),
        ("but if [Tom](3:object) [is](3:check_state) [asleep](3:state), let him sleep", (">1-", ">1-", "top")),
        ("if [the soil](3:object) [is](3:check_state) [wet](3:state), otherwise leave it", (">1+", ">1+", "top")),
        ("and if [it](3:object) wo n't [start](3:check_state), leave it", (">1+", ">1+", "top")),
        ("and if [Tom](3:object) [is](3:check_state) [asleep](3:state), good", (">1+", ">1+", "top")),
    ],
)
def test_what_is_called_off_in_a_case_is_done_in_the_other(words: str, expected: tuple[str, ...]) -> None:
    found = clauses(
        f"[Rake](1:change_state) [the path](1:object) and [dig](2:change_state) [the bed](2:object), {words}."
    )
    assert stated_sides(found, ("task", "task", "condition"), (">1+", ">1+", "top")) == expected


@pytest.mark.parametrize(
    ("joint", "place", "expected"),
    [
        (", but", "at lunch", ("top", "<1+", "<1-", "<1+")),
        (", and", "at lunch", ("top", ">1-", "<1+", "<1+")),
        (", but", "in the office", ("top", ">1-", "<1+", "<1+")),
    ],
)
def test_who_is_elsewhere_is_not_where_they_were_looked_for(joint: str, place: str, expected: tuple[str, ...]) -> None:
    found = clauses(
        f"If [Ann](1:object) [is](1:check_state) [in the office](1:location), [ring](2:informing) [her](2:recipient)"
        f"{joint} if [she](3:object)['s](3:check_state) [{place}](3:location), [write](4:informing) [her](4:recipient)."
    )
    roles = ("condition", "task", "condition", "task")
    assert stated_sides(found, roles, ("top", ">1-", "<1+", "<1+")) == expected


@pytest.mark.parametrize(
    ("check", "side"),
    [
        ("[is](3:check_state) [awake](3:state)", "<1-"),
        ("[is](3:check_state)n't", "<1-"),
        ("[is](3:check_state)", "<1+"),
    ],
)
@pytest.mark.parametrize("is_ahead", [True, False])
def test_what_is_done_in_the_opposite_of_a_forbidden_case_is_done_where_that_is_not(
    check: str, side: str, is_ahead: bool
) -> None:
    number, case = ("1", "2") if is_ahead else ("2", "1")
    forbidden = f"do n't [wake]({number}:change_state) [him]({number}:object)"
    condition = f"if [Tom]({case}:object) [is]({case}:check_state) [asleep]({case}:state)"
    told = f"{forbidden} {condition}" if is_ahead else f"{condition}, {forbidden}"
    found = clauses(f"{told}; if [he](3:object) {check}, [bring](4:bringing) [him](4:recipient) [tea](4:object).")
    roles = ("task", "condition", "mention", "task") if is_ahead else ("condition", "task", "mention", "task")
    sides = (">1-", "top", "<1", "<1+") if is_ahead else ("top", "<1-", "<1", "<1+")
    assert stated_sides(found, roles, sides)[-1] == side


@pytest.mark.parametrize(
    ("markup", "roles", "sides", "expected"),
    [
        (
            "Either [rinse](1:change_state) [the jug](1:object) or [fill](2:change_state) [the vase](2:object), and "
            "[go](3:motion) [out](3:goal).",
            ("task", "task", "task"),
            ("top", "top", "top"),
            (("condition", "task", "task"), ("top", "<1-", "top")),
        ),
        (
            "If [Ann](1:object) [is](1:check_state) [in](1:state), [ring](2:informing) [her](2:recipient) or "
            "[fill](3:change_state) [the vase](3:object), and [go](4:motion) [out](4:goal).",
            ("condition", "task", "task", "task"),
            ("top", "<1+", "<1+", "<1+"),
            (("condition", "condition", "task", "task"), ("top", "<1+", "<1-", "<2+")),
        ),
        (
            "Depending on whether [Ann](1:object) [is](1:check_state) [in](1:state), [ring](2:informing) "
            "[her](2:recipient) or [fill](3:change_state) [the vase](3:object).",
            ("condition", "task", "task"),
            ("top", "<1+", "<1-"),
            (("condition", "task", "task"), ("top", "<1+", "<1-")),
        ),
        (
            "[Rinse](1:change_state) [the jug](1:object) or [fill](2:change_state) [the vase](2:object) if "
            "[it](3:object)'s [empty](3:check_state).",
            ("task", "task", "condition"),
            (">1-", ">1+", "top"),
            (("task", "task", "condition"), (">1-", ">1+", "top")),
        ),
        (
            "Do n't [rinse](1:change_state) [the jug](1:object) or [fill](2:change_state) [the vase](2:object).",
            ("task", "task"),
            ("top", "top"),
            (("task", "task"), ("top", "top")),
        ),
    ],
)
def test_of_two_orders_that_an_or_joins_the_second_is_for_where_the_first_fails(
    markup: str,
    roles: tuple[str, ...],
    sides: tuple[str, ...],
    expected: tuple[tuple[str, ...], tuple[str, ...]],
) -> None:
    found = clauses(markup)
    settled = stated_roles(found, roles)
    assert (settled, stated_sides(found, settled, sides)) == expected


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("do", (">1+", "top")),
        ("go ahead", (">1+", "top")),
        ("tell me", (">1-", "top")),
    ],
)
def test_what_is_forbidden_but_allowed_in_a_case_is_done_in_that(words: str, expected: tuple[str, ...]) -> None:
    found = clauses(
        "Do n't [open](1:change_state) [it](1:object), but if [it](2:object)'[s](2:check_state) [hot](2:state), "
        f"{words}."
    )
    assert stated_sides(found, ("task", "condition"), (">1-", "top")) == expected


@pytest.mark.parametrize(
    ("opening", "side"),
    [
        ("Now", "top"),
        ("Anyway,", "top"),
        ("And now, please,", "top"),
        ("On another note,", "top"),
        ("Then", "<1+"),
        ("", "<1+"),
        ("And then", "<1+"),
    ],
)
def test_what_a_now_opens_hangs_on_no_condition_before(opening: str, side: str) -> None:
    found = clauses(
        f"If [Ann](1:object) [asks](1:check_state), I am out. {opening} [bring](2:bringing) [tea](2:object) and "
        "[go](3:motion) [home](3:goal)."
    )
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1+")) == ("top", side, side)


FALLBACKS = (
    "[Dust](1:change_state) [the shelf](1:object); {} [mop](2:change_state) [the hall](2:object){} "
    "[call](3:informing) [Ann](3:recipient)."
)


@pytest.mark.parametrize(
    ("first", "second", "role", "side"),
    [
        ("failing that,", "; failing that,", "condition", "<1-"),
        ("otherwise", "; otherwise", "condition", "<1-"),
        ("if you can't,", ", and if that fails,", "condition", "<1-"),
        ("failing that,", "; otherwise", "task", "<1+"),  # where nothing failed
        ("failing that,", " and", "task", "<1+"),
        ("then", "; failing that,", "task", "<1-"),
    ],
)
def test_of_several_fallbacks_each_is_for_where_the_one_before_fails(
    first: str, second: str, role: str, side: str
) -> None:
    found = clauses(FALLBACKS.format(first, second))
    roles = stated_roles(found, ("condition", "task", "task"))
    assert roles[1] == role
    assert stated_sides(found, roles, ("top", "<1-", "<1+"))[2] == side


@pytest.mark.parametrize(
    ("words", "side"),
    [("separately,", "top"), ("on a different note,", "top"), ("and", "<1+"), ("in another room,", "<1+")],
)
def test_what_is_of_another_matter_is_not_asked_in_the_case_before(words: str, side: str) -> None:
    found = clauses(
        f"If [the butter](1:object) [is](1:check_state) [soft](1:state), [wrap](2:change_state) [it](2:object); "
        f"{words} if [the dog](3:object) [is](3:check_state) [hungry](3:state), [tell](4:informing) [Ann](4:recipient)."
    )
    roles = ("condition", "task", "condition", "task")
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1+"))[2] == side


@pytest.mark.parametrize(("mark", "expected"), [("; ", "top"), (" and ", "<1+")])
def test_what_is_done_with_everything_else_hangs_on_nothing_in_a_clause_of_its_own(mark: str, expected: str) -> None:
    found = clauses(
        "If there['s](1:check_state) [a bill](1:object), [bring](2:bringing) [it](2:object) [to me](2:recipient)"
        f"{mark}[leave](3:placing) [everything else](3:object) [on the mat](3:goal)."
    )
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1+"))[2] == expected


@pytest.mark.parametrize("attachment", ["top", ">1-"])
@pytest.mark.parametrize(
    ("left", "expected"),
    [
        ("[it](3:object)", ">1-"),
        ("[them](3:object)", ">1-"),
        ("[one](3:object)", "top"),
        ("[two of them](3:object)", "top"),
    ],
)
def test_what_is_left_somewhere_is_not_moved(left: str, expected: str, attachment: str) -> None:
    found = clauses(
        "[Bring](1:bringing) [the crates](1:object) in. If [they](2:object)'[re](2:check_state) [wet](2:state), "
        f"[leave](3:placing) {left} [by the gate](3:goal)."
    )
    sides = stated_sides(found, ("task", "condition", "task"), (attachment, "top", "<1+"))
    assert sides == (expected, "top", "<1+")


@pytest.mark.parametrize(
    "text",
    [
        # it is the parcel that is left
        "[Fetch](1:bringing) [the post](1:object). If there'[s](2:check_state) [a parcel](2:object), "
        "[leave](3:placing) [it](3:object) [by the gate](3:goal).",
        # only those are left
        "[Bring](1:bringing) [the crates](1:object) in. If [any of them](2:object) [are](2:check_state) "
        "[wet](2:state), [leave](3:placing) [those](3:object) [by the gate](3:goal).",
        # it is taken there first
        "[Take](1:bringing) [the crate](1:object) [to Ann](1:recipient). If [she](2:object)'[s](2:check_state) "
        "[asleep](2:state), [leave](3:placing) [it](3:object) [by her bed](3:goal), otherwise "
        "[hand](4:bringing) [it](4:object) [to her](4:recipient).",
    ],
)
def test_other_things_left_somewhere_leave_the_order_before_alone(text: str) -> None:
    found = clauses(text)
    roles = ("task", "condition", "task", "task")[: len(found)]
    sides = ("top", "top", "<1+", "<1-")[: len(found)]
    assert stated_sides(found, roles, sides) == sides


@pytest.mark.parametrize("attachment", [">1+", "top"])
@pytest.mark.parametrize(("comma", "expected"), [(",", "top"), ("", None)])
def test_a_condition_behind_a_comma_and_an_and_is_of_the_last_order(
    comma: str, expected: str | None, attachment: str
) -> None:
    found = clauses(
        f"[Shut](1:change_state) [the gate](1:object){comma} and [bring](2:bringing) [the chairs](2:object) if "
        "[it](3:object)'[s](3:check_state) [windy](3:state)."
    )
    sides = stated_sides(found, ("task", "task", "condition"), (attachment, ">1+", "top"))
    assert sides == (attachment if expected is None else expected, ">1+", "top")


@pytest.mark.parametrize(
    ("second", "end", "expected"),
    [
        ("condition", ", and failing that, [tell](4:informing) [Ann](4:recipient).", ("top", "<1-", "<2", "<2-")),
        ("task", ", and [tell](4:informing) [Ann](4:recipient).", ("top", "<1-", "<1", "top")),
        ("task", ".", ("top", "<1-", "<1")),
    ],
)
def test_a_search_if_it_is_not_there_is_for_where_the_one_before_fails(
    second: str, end: str, expected: tuple[str, ...]
) -> None:
    found = clauses(
        "[Look](1:searching) [in the bag](1:location) for [the file](1:object), then [look](2:searching) "
        f"[in the tin](2:location) if [it](3:object)'[s](3:check_state) not [there](3:location){end}"
    )
    roles = ("condition", second, "mention", "task")[: len(found)]
    assert stated_sides(found, roles, ("top", "<1+", "<1", "<1-")[: len(found)]) == expected


@pytest.mark.parametrize(("word", "expected"), [("then ", "top"), ("", "<1+")])
def test_an_order_hangs_on_what_is_asked_of_its_own_thing_right_behind_it(word: str, expected: str) -> None:
    found = clauses(
        "If [the radio](1:object) [is](1:check_state) [on](1:state), [dust](2:change_state) [it](2:object), "
        f"{word}[shut](3:change_state) [the hatch](3:object) if [it](4:object)'[s](4:check_state) [open](4:state)."
    )
    roles = stated_roles(found, ("condition", "task", "task", "mention"))
    assert roles[3] == "condition"
    assert stated_sides(found, roles, ("top", "<1+", "<1+", "<1"))[2:] == (">1+", expected)


def test_the_state_that_was_asked_stays_a_mention_behind_an_order() -> None:
    found = clauses(
        "See if [the radio](1:object) [is](1:check_state) [on](1:state) and [shut](2:change_state) "
        "[the hatch](2:object) if [it](3:object)'[s](3:check_state) [off](3:state)."
    )
    assert stated_roles(found, ("condition", "task", "mention"))[2] == "mention"


@pytest.mark.parametrize(
    ("denial", "step", "expected"), [("n't", "", "top"), ("", "", "<1+"), ("n't", " first", "<1+")]
)
def test_what_is_done_then_behind_what_makes_up_for_a_lack_is_done_in_any_case(
    denial: str, step: str, expected: str
) -> None:
    found = clauses(
        f"If [the jug](1:object) [is](1:check_state){denial} [clean](1:state), [rinse](2:change_state) [it](2:object)"
        f"{step}, then [fill](3:change_state) [it](3:object)."
    )
    assert stated_sides(found, ("condition", "task", "task"), ("top", "<1+", "<1+"))[2] == expected


@pytest.mark.parametrize(
    ("opening", "attachments", "expected"),
    [
        ("in that case ", ("top", "top", "<1-", "<1+"), (">1+", "top", "<1-", "<1-")),
        ("in which case ", ("top", "top", "<1+", "<1+"), (">1+", "top", "<1-", "<1-")),
        ("", ("top", "top", "<1-", "<1-"), ("top", "top", "<1-", "<1-")),
    ],
)
def test_an_exception_that_is_a_sentence_of_its_own_is_one_of_the_order_before(
    opening: str, attachments: tuple[str, ...], expected: tuple[str, ...]
) -> None:
    found = clauses(
        "[Switch](1:change_state) [the fan](1:object) [off](1:state). Unless [Lea](2:object) [is](2:check_state) "
        f"[in](2:location), {opening}[tell](3:informing) [her](3:recipient) and [shut](4:change_state) "
        "[the door](4:object)."
    )
    assert stated_sides(found, ("task", "condition", "task", "task"), attachments) == expected


@pytest.mark.parametrize(
    ("waiting", "expected"),
    [
        ("and when [it](4:object)'[s](4:check_state) [full](4:state), ", "top"),
        ("and if [it](4:object)'[s](4:check_state) [full](4:state), ", "<1+"),
    ],
)
def test_what_is_done_when_something_is_so_stands_where_that_is_waited_for(waiting: str, expected: str) -> None:
    found = clauses(
        "If [the lamp](1:object) [is](1:check_state) [off](1:state), [switch](2:change_state) [it](2:object) "
        f"[on](2:state), then [run](3:change_state) [a bath](3:object), {waiting}[call](5:informing) Ann."
    )
    roles = ("condition", "task", "task", "task", "task")
    assert stated_sides(found, roles, ("top", "<1+", "top", "top", "<1+"))[-1] == expected


@pytest.mark.parametrize(
    ("thing", "order", "expected"),
    [
        ("[the cans](1:object)", "[put](3:placing)", (">1-", "top", "<1+")),
        ("[the cans](1:object)", "[take](3:bringing)", (">1-", "top", "<1+")),
        ("[the can](1:object)", "[put](3:placing)", ("top", "top", "<1+")),  # which may be what is full
    ],
)
def test_where_many_things_do_not_fit_they_are_not_put(thing: str, order: str, expected: tuple[str, ...]) -> None:
    them = "them" if "cans" in thing else "it"
    found = clauses(
        f"[Put](1:placing) {thing} [in the crate](1:goal), and if [it](2:object)'[s](2:check_state) [full](2:state), "
        f"{order} [{them}](3:object) [to the shed](3:goal)."
    )
    assert stated_sides(found, ("task", "condition", "task"), ("top", "top", "<1+")) == expected


@pytest.mark.parametrize(
    ("case", "expected"),
    [
        ("don't [ring](3:informing) [the bell](3:object)", ("top", "top", "<1-")),  # another deed is forbidden
        ("don't", (">1-", "top")),
        ("leave it", (">1-", "top")),
    ],
)
def test_what_is_called_off_in_a_case_is_the_order_before_it(case: str, expected: tuple[str, ...]) -> None:
    found = clauses(
        "[Mow](1:change_state) [the lawn](1:object). If [the cat](2:object) [is](2:check_state) [asleep](2:state), "
        f"{case}."
    )
    roles = ("task", "condition", "task")[: len(expected)]
    assert stated_sides(found, roles, ("top", "top", "<1-")[: len(expected)]) == expected


@pytest.mark.parametrize(
    ("first", "sides"),
    [
        ("[Open](1:change_state) [the gate](1:object)", ("<2", "<1")),
        ("If [the gate](1:object) [is](1:check_state) [open](1:state)", (">1+", "<2")),  # a check stays in its case
    ],
)
def test_an_order_whose_outcome_is_asked_stands_where_that_was_asked(first: str, sides: tuple[str, str]) -> None:
    found = clauses(f"{first}. If [it](2:object) [opens](2:check_state), [call](3:informing) [me](3:recipient).")
    assert stated_sides(found, ("condition", "mention", "task"), (">1+", "<2", "top"))[:2] == sides
