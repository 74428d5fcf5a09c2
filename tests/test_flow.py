"""The control flow tree: reading, refusing, normal form, labels."""

import pytest

from decomplex_bt.errors import InputError
from decomplex_bt.flow import Do, Flow, If

NESTED = [{"if": [1, 2], "else": [{"if": [3, 4], "else": [5]}]}]
EITHER = [{"if": 1, "then": [3], "else": [{"if": 2, "then": [{"same": [3]}]}]}]


@pytest.mark.parametrize("value", [[], [1], [2, 1], NESTED, EITHER, [{"same": [1, 3]}, 2]])
def test_json_survives_a_round_trip(value):
    assert Flow.from_json(value).to_json() == value


def test_normal_form_drops_empty_branches_and_single_lists():
    assert Flow.from_json([{"if": [1], "then": [2], "else": []}]).to_json() == [{"if": 1, "then": [2]}]


def test_equal_flows_are_equal_whatever_their_spelling():
    assert Flow.from_json([{"if": [1], "then": [2]}]) == Flow((If((1,), (Do((2,)),)),))


@pytest.mark.parametrize(
    ("value", "problem"),
    [
        ([1, 1], "occurs twice"),
        ([{"if": 1}], "neither then nor else"),
        ([{"if": 1, "then": [2], "other": []}], "expected the keys"),
        ([{"if": [2, 1], "then": [3]}], "in text order"),
        ([True], "an entry is a task number"),
        ([0], "expected a task number"),
        ("1", "expected a list"),
        ([{"same": [1]}], "stands nowhere before it"),
        ([1, {"same": [1]}], "would run task 1 twice"),
        ([1, 3], "there is no task 3"),
        ([1], "task 2 is marked in the text"),
    ],
)
def test_a_broken_flow_is_refused_with_its_fault(value, problem):
    with pytest.raises(InputError, match=problem):
        Flow.from_json(value, task_count=2)


def test_labels_follow_from_the_place_in_the_tree():
    assert Flow.from_json([{"if": [2, 3], "then": [1], "else": [4]}, 5]).dependencies() == {
        1: "dependent_positive",
        2: "conditional",
        3: "conditional",
        4: "dependent_negative",
        5: "sequential",
    }


def test_a_repeated_task_keeps_the_label_of_its_first_place():
    flow = Flow.from_json([{"if": 1, "then": [{"if": 2, "then": [3], "else": [4]}], "else": [{"same": [4]}]}])
    assert flow.dependencies()[4] == "dependent_negative"
    assert flow.numbers() == (1, 2, 3, 4)


def test_a_flow_says_itself():
    assert Flow.from_json([{"if": 1, "then": [2]}]).describe({1: "find it", 2: "bring it"}) == (
        "if [1] find it\nthen\n  [2] bring it"
    )


def test_mentions_are_numbers_that_are_executed_nowhere() -> None:
    flow = Flow.from_json([{"if": [1, 2], "then": [3], "else": [{"same": [4, 5]}, {"same": [3]}]}])
    assert flow.mentions() == {2, 5}
    assert Flow.from_json([1, 2]).mentions() == frozenset()


def test_a_path_names_the_conditions_above_a_node_outermost_first():
    flow = Flow.from_json([1, {"if": 2, "then": [{"if": [3, 4], "else": [5]}], "else": [{"same": [5]}, 6]}, 7])
    assert [(node.task, path) for node, path in flow.paths()] == [
        (1, ()),
        (2, ()),
        (3, ((2, "then"),)),
        (5, ((2, "then"), (3, "else"))),
        (5, ((2, "else"),)),
        (6, ((2, "else"),)),
        (7, ()),
    ]
    assert [place for _, place in flow.walk()] == ["top", "top", "then", "else", "else", "else", "top"]


def test_neighbours_are_done_one_right_after_the_other():
    flow = Flow.from_json([1, {"if": [2, 3], "then": [4, 5], "else": [6]}, 7, 8])
    assert list(flow.neighbours()) == [(1, 2), (2, 4), (4, 5), (7, 8)]


def test_what_is_nested_too_deep_is_refused() -> None:
    flow: list[object] = [1]
    for _ in range(5000):
        flow = [{"if": 1, "then": flow}]
    with pytest.raises(InputError, match="too deep"):
        Flow.from_json(flow)
