"""Arcs say every control flow of the guideline, and any arcs give a valid flow."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from decomplex_bt.corpus import read_corpus
from decomplex_bt.flow import Flow
from decomplex_bt.understanding.control_flow.arcs import ORDERS, Arc, Wording, other_orders
from decomplex_bt.understanding.control_flow.construction import flow_of
from decomplex_bt.understanding.control_flow.derivation import arcs_of

PLAIN = Wording()
NEGATED = Wording(is_negated=True)

FLOWS = {
    "sequence": [1, 2, 3],
    "reversed": [2, 1],
    "three reversed": [3, 2, 1],
    "else": [{"if": 1, "else": [2]}],
    "condition last": [{"if": 2, "then": [1]}, 3],
    "mentions": [{"if": [2, 3], "then": [1], "else": [4]}],
    "nested in else": [{"if": [1, 2], "else": [{"if": [3, 4], "else": [5]}]}],
    "nested in then": [{"if": 1, "then": [2, {"if": 3, "then": [4]}], "else": [5]}],
    "and": [{"if": 1, "then": [{"if": 2, "then": [3], "else": [4]}], "else": [{"same": [4]}]}],
    "or": [{"if": 1, "then": [3], "else": [{"if": 2, "then": [{"same": [3]}]}]}],
    "and, three parts": [
        {
            "if": 1,
            "then": [{"if": 2, "then": [{"if": 3, "then": [4], "else": [5]}], "else": [{"same": [5]}]}],
            "else": [{"same": [5]}],
        }
    ],
    "or, three parts": [
        {
            "if": 1,
            "then": [4],
            "else": [{"if": 2, "then": [{"same": [4]}], "else": [{"if": 3, "then": [{"same": [4]}], "else": [5]}]}],
        }
    ],
    "two conditions": [{"if": 1, "then": [2]}, {"if": 3, "else": [4]}, 5],
    "one task twice": [{"same": [1, 3]}, 2],
    "between two mentions": [{"if": [1, 3], "then": [2, 4], "else": [{"same": [2]}]}, 5],
    "in a branch, between two mentions": [
        {"if": 1, "else": [{"if": [2, 5], "then": [3, 4], "else": [{"same": [4]}, 6]}]},
    ],
}


# joint conditions, each stated with a negation ("if it is neither hot nor full")
NEGATED_FLOWS = {name: value for name, value in FLOWS.items() if not name.startswith(("and", "or"))} | {
    "neither": [{"if": 1, "then": [4], "else": [{"if": 2, "then": [{"same": [4]}], "else": [3]}]}],
}


@pytest.mark.parametrize(
    ("value", "wording"),
    [
        *(pytest.param(value, PLAIN, id=f"{name}, plain") for name, value in FLOWS.items()),
        *(pytest.param(value, NEGATED, id=f"{name}, negated") for name, value in NEGATED_FLOWS.items()),
    ],
)
def test_arcs_say_the_flow(value, wording):
    flow = Flow.from_json(value)
    wordings = [wording] * len(flow.numbers())
    arcs = arcs_of(flow, wordings)
    assert arcs is not None
    assert flow_of(arcs, wordings) == flow


def test_as_stated_is_the_plain_case_for_a_negated_condition():
    """ "If it is not hot, heat it": the dependent follows the clause as it is stated, so its label is a plus."""
    arcs = arcs_of(Flow.from_json([{"if": 1, "else": [2]}]), [NEGATED, PLAIN])
    assert arcs is not None
    assert arcs[1].attachment == "<1+"


def test_a_condition_stated_again_means_the_other_side():
    """ "If it is dry, fold it. If it is damp, hang it up": no list of opposites is needed."""
    arcs = [Arc("condition"), Arc("task", "<1+"), Arc("mention", "<1"), Arc("task", "<1+")]
    assert flow_of(arcs, [PLAIN] * 4).to_json() == [{"if": [1, 3], "then": [2], "else": [4]}]


def test_the_echo_of_what_an_unless_denies_affirms_it():
    """ "Don't lock up unless he is in. If he is, tell him": the side that has a task already is meant again."""
    arcs = [Arc("task", ">1-"), Arc("condition"), Arc("mention", "<1"), Arc("task", "<1+")]
    wordings = [PLAIN, NEGATED, Wording(is_echo=True), PLAIN]
    assert flow_of(arcs, wordings).to_json() == [{"if": [2, 3], "then": [1, 4]}]


def test_an_antonym_means_the_other_side():
    on, off = Wording(state="on", opposite="off"), Wording(state="off", opposite="on")
    arcs = [Arc("condition"), Arc("mention", "<1"), Arc("task", "<1+")]
    assert flow_of(arcs, [on, off, PLAIN]).to_json() == [{"if": [1, 2], "else": [3]}]


def test_the_corpus_can_be_said(ontology, household_folder):
    examples = read_corpus(household_folder / "corpus", ontology)
    unsayable = [e.id for e in examples if arcs_of(e.instruction.flow, [PLAIN] * len(e.instruction.tasks)) is None]
    assert len(unsayable) <= len(examples) * 0.01


_ROLES = ("task", "condition", "mention", "and", "or", "again")
_ATTACHMENTS = ("top", "<1+", "<1-", "<2+", ">1+", ">1-", ">2-", "<1")
_ARCS = st.lists(
    st.tuples(
        st.builds(Arc, st.sampled_from(_ROLES), st.sampled_from(_ATTACHMENTS), st.sampled_from(ORDERS)),
        st.sampled_from((PLAIN, NEGATED)),
    ),
    max_size=8,
)


@settings(max_examples=400, deadline=None)
@given(_ARCS)
def test_any_arcs_give_a_valid_flow_with_every_task_once(labelled):
    flow = flow_of([arc for arc, _ in labelled], [wording for _, wording in labelled])
    assert Flow.from_json(flow.to_json(), task_count=len(labelled)) == flow


def test_who_says_first_in_a_branch_moves_its_condition() -> None:
    """Fetch the cup; if it is dirty, wash it first."""
    wordings = [PLAIN, PLAIN, Wording(orders=("first", "before"))]
    assert other_orders(["task", "condition", "task"], ["top", "top", "<1+"], wordings, 1) == ("first", "before")
    assert other_orders(["task", "condition", "task"], ["top", "top", "top"], wordings, 1) == ()
    arcs = arcs_of(Flow.from_json([{"if": 2, "then": [3]}, 1]), wordings)
    assert arcs is not None
    assert [arc.order for arc in arcs] == ["keep", "before", "keep"]


def test_what_comes_first_takes_along_what_is_joined_to_it():
    """ "Lock the car, but before that unload it and check the boot": the label stands where the words are."""
    wordings = [PLAIN, Wording(orders=("before", "first")), PLAIN]
    arcs = arcs_of(Flow.from_json([2, 3, 1]), wordings)
    assert arcs is not None
    assert [arc.order for arc in arcs] == ["keep", "before+", "keep"]


def test_nothing_of_another_sentence_or_with_an_order_of_its_own_is_taken_along():
    arcs = [Arc(), Arc(order="first+"), Arc(), Arc(order="last"), Arc()]
    assert flow_of(arcs, [PLAIN] * 5) == Flow.from_json([2, 3, 1, 5, 4])
    elsewhere = [PLAIN, PLAIN, Wording(sentence=1), PLAIN, PLAIN]
    assert flow_of(arcs, elsewhere) == Flow.from_json([2, 1, 3, 5, 4])


def test_a_further_mention_speaks_for_the_order_of_what_it_mentions():
    """ "Iron the shirt, and before you iron it fill the iron with water"."""
    wordings = [PLAIN, Wording(orders=("after", "last")), PLAIN]
    assert other_orders(["task", "again", "task"], ["top", "<1", "top"], wordings, 0) == ("after", "last")
    assert other_orders(["task", "again", "task"], ["top", "<1", "top"], wordings, 2) == ()


def test_a_first_sibling_has_nothing_to_go_ahead_of():
    arcs = [Arc(order="before+"), Arc(), Arc()]
    assert flow_of(arcs, [PLAIN] * 3) == Flow.from_json([1, 2, 3])
    wordings = [Wording(orders=("before", "first")), Wording(orders=("first", "before"))]
    derived = arcs_of(Flow.from_json([2, 1]), wordings)
    assert derived is not None
    assert [arc.order for arc in derived] == ["keep", "before"]


def test_first_goes_ahead_of_all_and_before_of_one():
    arcs = [Arc(), Arc(), Arc(order="first+"), Arc()]
    assert flow_of(arcs, [PLAIN] * 4) == Flow.from_json([3, 4, 1, 2])
    arcs[2] = Arc(order="before+")
    assert flow_of(arcs, [PLAIN] * 4) == Flow.from_json([1, 3, 4, 2])


@pytest.mark.parametrize("joins", ["and", "or"])
def test_a_joint_that_can_be_told_both_ways_is_told_as_its_words_have_it(joins):
    """Unless A or B, X, else Y: if neither A nor B, X; or if A or B, Y."""
    flow = Flow.from_json([{"if": 2, "then": [4], "else": [{"if": 3, "then": [{"same": [4]}], "else": [1]}]}])
    is_negated = joins == "and"
    wordings = [PLAIN, Wording(is_negated=is_negated), Wording(is_negated=is_negated, joins=joins), PLAIN]
    arcs = arcs_of(flow, wordings)
    assert arcs is not None
    assert arcs[2].role == joins
    assert flow_of(arcs, wordings) == flow


CHECK, BETWEEN, MENTION = Arc("condition"), Arc("task"), Arc("mention", "<1")


@pytest.mark.parametrize(
    ("own", "later", "is_inside"), [((), (), True), (("after",), (), False), ((), ("before",), False)]
)
def test_what_is_done_between_two_mentions_is_done_in_any_case_but_not_where_words_tell_of_order(own, later, is_inside):
    """ "Check whether it is wet, then close the window. If it was wet, dry it"."""
    wordings = (PLAIN, Wording(orders=own), PLAIN, Wording(orders=later))
    flow = flow_of((CHECK, BETWEEN, MENTION, Arc("task", "<1+")), wordings)
    inside, outside = [{"if": [1, 3], "then": [2, 4], "else": [{"same": [2]}]}], [{"if": [1, 3], "then": [4]}, 2]
    assert flow.to_json() == (inside if is_inside else outside)


def test_what_is_done_behind_all_mentions_is_done_after_the_condition():
    flow = flow_of((CHECK, MENTION, Arc("task", "<1+"), BETWEEN), [PLAIN] * 4)
    assert flow.to_json() == [{"if": [1, 2], "then": [3]}, 4]


def test_that_doing_it_fails_is_the_opposite_whatever_state_it_names():
    switched, fails = Wording(state="on"), Wording(state="on", is_contrary=True)
    assert fails.contradicts(switched)
    assert not fails.contradicts(fails)
    assert not switched.contradicts(switched)
    assert Wording(state="off").contradicts(switched)
