import pytest
from py_trees.behaviours import StatusQueue
from py_trees.common import Status
from py_trees.composites import Selector
from py_trees.decorators import FailureIsSuccess, Inverter, PassThrough, Retry

from decomplex_bt.behaviour.conditional import IfThenElse

R, S, F, INVALID = Status.RUNNING, Status.SUCCESS, Status.FAILURE, Status.INVALID


class Recorder(StatusQueue):
    """A leaf that plays a queue of statuses and counts how it is used."""

    def __init__(self, name, *queue, is_undecided=False):
        super().__init__(name, list(queue), eventually=queue[-1])
        self.is_undecided = is_undecided
        self.ticks = 0
        self.ended = []

    def update(self):
        self.ticks += 1
        return super().update()

    def terminate(self, new_status):
        self.ended.append(new_status)
        super().terminate(new_status)


def make(condition, then=None, orelse=None):
    return IfThenElse("if", condition=condition, then=then, orelse=orelse)


def tick(node, times=1):
    for _ in range(times):
        list(node.tick())
    return node.status


@pytest.mark.parametrize("outcome", [R, S, F])
@pytest.mark.parametrize("truth", [True, False])
def test_status_is_that_of_the_branch_and_the_other_is_not_ticked(truth, outcome):
    then, orelse = Recorder("then", outcome), Recorder("else", outcome)
    node = make(Recorder("condition", S if truth else F), then, orelse)
    assert tick(node) == outcome
    taken, left = (then, orelse) if truth else (orelse, then)
    assert (taken.ticks, left.ticks) == (1, 0)
    assert node.truth is truth
    assert node.taken == ("then" if truth else "else")


def test_else_is_not_run_when_then_fails():
    orelse = Recorder("else", S)
    node = make(Recorder("condition", S), Recorder("then", R, R, F), orelse)
    assert [tick(node) for _ in range(3)] == [R, R, F]
    assert orelse.ticks == 0


@pytest.mark.parametrize(("truth", "branches"), [(F, ["then"]), (S, ["orelse"])])
def test_a_missing_branch_is_success(truth, branches):
    children = {branch: Recorder(branch, F) for branch in branches}
    node = make(Recorder("condition", truth), **children)
    assert tick(node) == S
    assert node.taken is None
    assert all(child.ticks == 0 for child in children.values())


def test_condition_is_judged_once():
    condition = Recorder("condition", R, S, F)
    node = make(condition, Recorder("then", R, R, S), Recorder("else", F))
    assert [tick(node) for _ in range(4)] == [R, R, R, S]
    assert condition.ticks == 2


def test_undecided_condition_is_failure_with_its_reason():
    condition = Recorder("condition", F, is_undecided=True)
    condition.feedback_message = "the fridge cannot be reached"
    orelse = Recorder("else", S)
    node = make(condition, Recorder("then", S), orelse)
    assert tick(node) == F
    assert node.truth is None
    assert orelse.ticks == 0
    assert "cannot be decided" in node.feedback_message


@pytest.mark.parametrize(
    "decorate",
    [
        lambda child: Inverter("not", child),
        lambda child: PassThrough("same", child),
        lambda child: Inverter("not", Inverter("not", child)),
        lambda child: Retry("once", child, 1),
    ],
)
def test_what_cannot_be_decided_is_not_decided_by_turning_it_round(decorate):
    condition = Recorder("condition", F, is_undecided=True)
    condition.feedback_message = "the fridge cannot be reached"
    node = make(decorate(condition), Recorder("then", S), Recorder("else", S))
    assert (tick(node), node.truth, node.then.ticks, node.orelse.ticks) == (F, None, 0, 0)
    assert node.feedback_message == "cannot be decided: the fridge cannot be reached"


def test_a_decorator_that_makes_something_else_of_it_decides():
    node = make(FailureIsSuccess("yes", Recorder("condition", F, is_undecided=True)), Recorder("then", S))
    assert (tick(node), node.taken) == (S, "then")


def test_entered_anew_it_judges_anew():
    node = make(Recorder("condition", S, F), Recorder("then", S), Recorder("else", F))
    assert [tick(node), tick(node)] == [S, F]
    assert node.then.status == INVALID


@pytest.mark.parametrize(("condition", "running"), [(R, "condition"), (S, "then"), (F, "else")])
def test_interruption_stops_the_running_child(condition, running):
    urgent = Recorder("urgent", F, S)
    children = Recorder("condition", condition), Recorder("then", R), Recorder("else", R)
    node = make(*children)
    root = Selector("root", memory=False, children=[urgent, node])
    assert tick(root) == R
    assert tick(root) == S
    assert node.status == INVALID
    child = next(child for child in children if child.name == running)
    assert child.status == INVALID
    assert child.ended[-1] == INVALID
    assert node.current_child is None


def test_after_an_interruption_it_starts_at_the_condition():
    condition, then = Recorder("condition", S), Recorder("then", R)
    node = make(condition, then)
    tick(node, 2)
    node.stop(INVALID)
    assert tick(node) == R
    assert (condition.ticks, then.ticks) == (2, 3)


def test_tip_is_the_running_leaf():
    node = make(Recorder("condition", S), Recorder("then", R))
    tick(node)
    assert node.tip() is node.then


def test_what_was_stopped_has_judged_nothing():
    node = make(Recorder("condition", S), Recorder("then", R))
    assert tick(node) == R
    assert (node.truth, node.taken) == (True, "then")
    node.stop(INVALID)
    assert (node.truth, node.taken) == (None, None)


@pytest.mark.parametrize("role", ["condition", "then", "orelse"])
def test_a_child_that_is_replaced_is_ticked_no_more(role):
    truth = S if role != "orelse" else F
    node = make(Recorder("condition", truth), Recorder("then", S), Recorder("else", S))
    old, new = getattr(node, role), Recorder("new", S)
    node.replace_child(old, new)
    assert tick(node) == S
    assert (old.ticks, new.ticks) == (0, 1)
    assert [child.name for child in node.children].count("new") == 1
    assert new.parent is node


def test_a_running_branch_that_is_replaced_goes_on_with_the_new_one():
    node = make(Recorder("condition", S), Recorder("then", R))
    assert tick(node) == R
    new = Recorder("new", S)
    node.replace_child(node.then, new)
    assert tick(node) == S
    assert (node.condition.ticks, new.ticks) == (1, 1)


def test_a_branch_that_is_removed_is_missing():
    node = make(Recorder("condition", S), Recorder("then", F))
    node.remove_child(node.then)
    assert tick(node) == S
    assert node.taken is None


def test_a_branch_that_is_removed_while_it_runs_asks_for_nothing_more():
    node = make(Recorder("condition", S), Recorder("then", R))
    tick(node)
    node.remove_child(node.then)
    assert tick(node) == S


def test_children_without_a_role_are_refused():
    node = make(Recorder("condition", S), Recorder("then", S))
    for change in (
        lambda: node.add_child(Recorder("more", S)),
        lambda: node.insert_child(Recorder("more", S), 0),
        lambda: node.prepend_child(Recorder("more", S)),
        lambda: node.remove_child(node.condition),
        node.remove_all_children,
    ):
        with pytest.raises(TypeError):
            change()
    assert [child.name for child in node.children] == ["condition", "then"]
