from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.metrics import flow_forest, has_same_flow, is_same, ordering_errors, score
from decomplex_bt.evaluation.tree_distance import Tree, edit_distance, forest_size

ONTOLOGY = load_domain("household").ontology
TEXT = (
    "[Check](1:check_state) [the tea](1:object), [heat](2:change_state) [it](2:object=the tea), "
    "[bring](3:bringing) [it](3:object=the tea)."
)


def read(text=TEXT, flow=(1, 2, 3)):
    return read_markup(text, ONTOLOGY, flow=list(flow))


GOLD = read(flow=[{"if": 1, "then": [3], "else": [2]}])


def leaf(label):
    return Tree(label)


@pytest.mark.parametrize(
    ("first", "second", "distance"),
    [
        ((), (), 0),
        ((leaf("a"),), (), 1),
        ((leaf("a"), leaf("b")), (leaf("b"),), 1),
        ((leaf("a"), leaf("b")), (leaf("b"), leaf("a")), 2),
        ((Tree("a", (leaf("b"), leaf("c"))),), (leaf("b"), leaf("c")), 1),
        ((Tree("a", (leaf("b"),)),), (Tree("x", (leaf("b"),)),), 1),
        # the example of Zhang and Shasha's paper: f(d(a c(b)) e) and f(c(d(a b)) e)
        (
            (Tree("f", (Tree("d", (leaf("a"), Tree("c", (leaf("b"),)))), leaf("e"))),),
            (Tree("f", (Tree("c", (Tree("d", (leaf("a"), leaf("b"))),)), leaf("e"))),),
            2,
        ),
    ],
)
def test_edit_distance(first, second, distance):
    assert edit_distance(first, second) == edit_distance(second, first) == distance


def test_edit_distance_of_long_sequences_is_quick():
    forest = tuple(leaf(number) for number in range(60))
    assert edit_distance(forest, forest[1:]) == 1


def test_a_right_reading_scores_full_marks():
    scores = score([GOLD], [GOLD])
    assert (scores.tasks.overall.value, scores.arguments.weighted, scores.dependencies.overall.value) == (1, 1, 1)
    assert (scores.flow.count, scores.strict.count, scores.oer) == (1, 1, 0)


def test_a_task_on_the_wrong_side_is_one_substitution():
    swapped = read(flow=[{"if": 1, "then": [2, 3]}])
    assert ordering_errors(swapped, GOLD) == 2
    assert (
        ordering_errors(read(flow=[{"if": 1, "else": [2, 3]}]), read(flow=[{"if": 1, "else": [2], "then": [3]}])) == 2
    )
    assert ordering_errors(read(flow=[{"if": 1, "then": [2]}, 3]), read(flow=[{"if": 1, "else": [2]}, 3])) == 1
    assert forest_size(flow_forest(GOLD)) == 3


def test_merged_mentions_are_one_node():
    merged = read(flow=[{"if": [1, 2], "then": [3]}])
    assert forest_size(flow_forest(merged)) == 2


def test_labels_are_scored_at_their_token():
    text = TEXT.replace("2:change_state", "2:taking")
    scores = score([read(text, flow=[{"if": 1, "then": [3], "else": [2]}])], [GOLD])
    assert scores.tasks.of("change_state").recall == 0
    assert scores.tasks.of("taking").precision == 0
    assert scores.tasks.overall.value == pytest.approx(2 / 3)
    assert scores.dependencies.of("dependent_negative").value == 1
    assert (scores.flow.count, scores.ordering_errors) == (0, 1)


def test_an_argument_with_the_wrong_owner_is_wrong():
    text = TEXT.replace("[it](2:object=the tea)", "[it](1:object=the tea)")
    scores = score([read(text, flow=[{"if": 1, "then": [3], "else": [2]}])], [GOLD])
    assert (scores.arguments.overall.right, scores.arguments.overall.found) == (2, 3)


def test_strict_minds_values_but_not_their_case():
    other = read(TEXT.replace("3:object=the tea", "3:object=the coffee"), flow=[{"if": 1, "then": [3], "else": [2]}])
    upper = read(TEXT.replace("3:object=the tea", "3:object=The Tea"), flow=[{"if": 1, "then": [3], "else": [2]}])
    assert has_same_flow(other, GOLD)
    assert not is_same(other, GOLD)
    assert is_same(upper, GOLD)


def test_nothing_to_find_and_nothing_found_is_right():
    empty = read("Good morning.", flow=[])
    assert score([empty], [empty]).tasks.overall.value == 1
    assert score([GOLD], [GOLD]).nodes == 3


def test_readings_of_different_texts_are_refused():
    with pytest.raises(ValueError, match="different texts"):
        score([read("Good morning.", flow=[])], [GOLD])
