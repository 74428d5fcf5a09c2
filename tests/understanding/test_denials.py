"""What a negation denies."""

from __future__ import annotations

from typing import Any

import pytest
from annotated import clauses
from readings import flow

from decomplex_bt.understanding.interpreter import Interpreter


def test_a_polite_question_denies_nothing() -> None:
    asked = clauses("Why don't you [see](1:check_state) if [the bin](1:object) is [full](1:state)?")
    assert not asked[0].wording.is_negated
    asked = clauses("Wouldn't you [look](1:searching) for [the bin](1:object)?")
    assert not asked[0].wording.is_negated
    denied = clauses("If you don't [see](1:searching) [the bin](1:object), [tell](2:informing) me.")
    assert denied[0].wording.is_negated
    lacking = clauses("Can't you [find](1:searching) [the cup](1:object)? [Bring](2:bringing) [a glass](2:object).")
    assert lacking[0].wording.is_negated


def test_a_statement_with_a_tag_asks_whether_it_is_so() -> None:
    asked = clauses("[The lamp](1:object) [is](1:check_state)n't [on](1:state), is it? [Dust](2:change_state) it.")
    assert not asked[0].wording.is_negated


@pytest.mark.parametrize(
    ("markup", "is_negated"),
    [
        ("If [the door](1:object) [is](1:check_state)n't [locked](1:state), [lock](2:change_state) it.", True),
        ("If there [is](1:check_state) no [milk](1:object), [bring](2:bringing) [tea](2:object).", True),
        ("If [she](1:object) [says](1:check_state) [no](1:state), [take](2:taking) [it](2:object) away.", False),
        ("If [she](1:object) [says](1:check_state) no [milk](1:state) is left, [buy](2:taking) some.", True),
        ("If nothing [is](1:check_state) [in the oven](1:location), [clean](2:change_state) [it](2:object).", True),
        ("If no [cup](1:object) [is](1:check_state) [clean](1:state), [wash](2:change_state) one.", True),
        ("[Ring](1:informing) Ann. If there['s](2:check_state) no [answer](2:object), [ring](3:informing) Tom.", True),
        ("if theres none [there](1:check_state) [bring](2:bringing) [tea](2:object)", True),
        ("If there [is](1:check_state)n't no [milk](1:object), [bring](2:bringing) [tea](2:object).", True),
        ("If [it](1:object) [is](1:check_state)n't [there](1:location) neither, [call](2:informing) me.", True),
        ("Unless there [is](1:check_state)n't no [milk](1:object), [bring](2:bringing) it.", False),
        ("If there['s](1:check_state) [tea](1:object) but no milk, [bring](2:bringing) [it](2:object).", False),
        ("If [it](1:object)['s](1:check_state) [hot](1:state) but not too hot, [bring](2:bringing) it.", False),
        ("If [it](1:object) [is](1:check_state) [on](1:state) for no reason, [dust](2:change_state) it.", False),
        ("If there [is](1:check_state) [a chair](1:object) that nobody uses, [bring](2:bringing) it.", False),
        ("If [it](1:object)['s](1:check_state) [on](1:state) and nobody [is](2:check_state) [in](2:state), go.", False),
        ("If [it](1:object) [is](1:check_state) [wet](1:state) don't [iron](2:change_state) [it](2:object).", False),
    ],
)
def test_a_negation_denies_what_it_belongs_to(markup: str, is_negated: bool) -> None:
    found = clauses(markup)
    check = next(k for k, clause in enumerate(found) if clause.task.type == "check_state")
    assert found[check].wording.is_negated == is_negated


@pytest.mark.parametrize(
    ("markup", "is_negated"),
    [
        (
            "If [it](1:object) [is](1:check_state) [hot](1:state) don't touch it just [tell](2:informing) me",
            (False, False),
        ),
        ("If [it](1:object) [is](1:check_state) [hot](1:state) don't [touch](2:taking) it", (False, True)),
        ("If [it](1:object) [is](1:check_state)n't [hot](1:state), [tell](2:informing) me", (True, False)),
        ("[Check](1:check_state) [the taps](1:object) don't drip, then [tell](2:informing) me", (True, False)),
        ("[Check](1:check_state) [the tap](1:object), no forget it, just [tell](2:informing) me", (False, False)),
    ],
)
def test_what_is_forbidden_beside_denies_nothing(markup: str, is_negated: tuple[bool, bool]) -> None:
    assert tuple(clause.wording.is_negated for clause in clauses(markup)) == is_negated


@pytest.mark.parametrize(
    ("check", "is_negated"),
    [("refuses to [open](2:check_state)", True), ("[opens](2:check_state)", False), ("[fails](2:check_state)", False)],
)
def test_what_refuses_to_do_something_does_not_do_it(check: str, is_negated: bool) -> None:
    found = clauses(
        f"[Unlock](1:change_state) [the door](1:object). If [it](2:object) {check}, [call](3:informing) me."
    )
    assert found[1].wording.is_negated == is_negated
    assert found[1].wording.is_contrary == ("fails" in check)


@pytest.mark.parametrize(
    ("markup", "is_negated"),
    [
        (
            "i can't find my keys [have](1:searching) a look [in the hall](1:location) then [call](2:informing) me",
            False,
        ),
        ("the cup isn't here can you [look](1:searching) [under it](1:location)", False),
        ("i don't know where it is go and [look](1:searching) [in the shed](1:location)", False),
        ("there's no milk in the fridge please [try](1:searching) [the cellar](1:location)", False),
        ("don't you dare [look](1:searching) [in the shed](1:location)", True),
        ("i can't [find](1:searching) [my keys](1:object)", True),
        ("if you don't [see](1:searching) [my keys](1:object), [tell](2:informing) me", True),
        ("if the dog doesn't want to [follow](1:following) [you](1:object), [call](2:informing) me", True),
        ("if they won't let you [look](1:searching) [in the shed](1:location), [tell](2:informing) me", True),
    ],
)
def test_an_order_behind_a_statement_is_not_denied_with_it(markup: str, is_negated: bool) -> None:
    assert clauses(markup)[0].wording.is_negated == is_negated


@pytest.mark.parametrize(
    ("markup", "is_negated"),
    [
        ("[See](1:check_state) whether [the heater](1:object) isn't [on](1:state).", True),
        ("[Find](1:check_state) out if there's no [milk](1:object) left.", True),
        (
            "[See](1:check_state) whether [the heater](1:object) is [on](1:state), and if not, [tell](2:informing) me.",
            False,
        ),
        ("[See](1:check_state) whether [the heater](1:object) is [on](1:state) but don't touch it.", False),
    ],
)
def test_what_is_found_out_may_be_denied(markup: str, is_negated: bool) -> None:
    assert clauses(markup)[0].wording.is_negated == is_negated


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "If the tea is ready, bring me a cup, if not see whether there is coffee and if so bring me that.",
            [{"if": 1, "then": [2], "else": [{"if": 3, "then": [4]}]}],
        ),
        ("Is the radio on? If not turn it on.", [{"if": 1, "else": [2]}]),
        ("If the pear does not look ripe, throw it away.", [{"if": 1, "else": [2]}]),
        ("Look in the study, and if Max is not to be found there, look in the yard.", [{"if": [1, 2], "else": [3]}]),
    ],
)
def test_a_not_is_of_the_if_it_stands_by_or_of_the_verb(interpreter: Interpreter, text: str, expected: Any) -> None:
    assert flow(interpreter, text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "If the plug doesn't quite fit, bring me the adapter.",
        "If the hatch won't fully open, call Kim.",
        "If the crates don't all fit, put one in the cellar.",
        "If you can't really reach the lamp, get the steps.",
    ],
)
def test_a_word_between_takes_nothing_from_a_denial(interpreter: Interpreter, text: str) -> None:
    assert flow(interpreter, text) == [{"if": 1, "else": [2]}]


def test_an_order_behind_a_denial_without_a_mark_is_none_of_its_words(interpreter: Interpreter) -> None:
    assert flow(interpreter, "I can't find my gloves have a look in the hall") == [1]
    assert flow(interpreter, "If she doesn't then wake her.") == [{"if": 1, "else": [2]}]


@pytest.mark.parametrize("text", ["Check whether", "Check if", "See whether the lamp", "is"])
def test_a_question_that_breaks_off_denies_nothing(interpreter: Interpreter, text: str) -> None:
    assert not interpreter.interpret(text).flow.mentions()
