import py_trees
import pytest
from py_trees.behaviours import Dummy

from decomplex_bt.behaviour.agent import compile_instruction
from decomplex_bt.behaviour.compiler import compile_flow
from decomplex_bt.behaviour.conditional import IfThenElse
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.domain.nouns import deny
from decomplex_bt.domain.sentences import say_condition, say_task
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Span, Task
from decomplex_bt.planning.grounding import ground


class Leaf(Dummy):
    def __init__(self, name, number, is_condition):
        super().__init__(name)
        self.number, self.is_condition = number, is_condition


def compile_json(flow, count=9):
    names = {number: f"do {number}" for number in range(1, count + 1)}
    return compile_flow(Flow.from_json(flow), names, Leaf, title="what was said")


def shape(node):
    """The tree as nested tuples of names and leaf numbers."""
    if isinstance(node, Leaf):
        return f"{node.number}?" if node.is_condition else node.number
    return (type(node).__name__, *(shape(child) for child in node.children))


def test_a_sequence_stays_a_sequence():
    assert shape(compile_json([2, 1, 3]).root) == ("Sequence", 2, 1, 3)


def test_a_condition_becomes_an_if_then_else_and_a_branch_of_one_is_that_one():
    tree = compile_json([{"if": 1, "then": [2], "else": [3, 4]}, 5])
    assert shape(tree.root) == ("Sequence", ("IfThenElse", "1?", 2, ("Sequence", 3, 4)), 5)
    node = tree.nodes[0,]
    assert isinstance(node, IfThenElse)
    assert (node.then.number, node.orelse.name) == (2, "otherwise")


def test_missing_branches_nesting_mentions_and_repeats():
    flow = [{"if": [1, 2], "else": [{"if": 3, "then": [4], "else": [{"same": [4]}]}]}, {"same": [5, 6]}]
    # a repeat in the other branch is another leaf of the same task
    tree = compile_json(flow)
    assert shape(tree.root) == ("Sequence", ("IfThenElse", "1?", ("IfThenElse", "3?", 4, 4)), 5)
    assert tree.nodes[0,].then is None
    assert tree.nodes[0, "else", 0, "then", 0] is not tree.nodes[0, "else", 0, "else", 0]


def test_nodes_of_flow_and_tree_correspond_one_to_one():
    tree = compile_json([1, {"if": 2, "then": [3, 4], "else": [{"if": 5, "then": [6]}]}])
    assert set(tree.nodes.values()) == set(tree.root.iterate())
    assert len(set(map(id, tree.nodes.values()))) == len(tree.nodes)
    assert tree.nodes[1, "then", 1].number == 4


def test_trees_share_nothing_and_all_sequences_remember():
    first, second = compile_json([1, 2]), compile_json([1, 2])
    assert not set(first.root.iterate()) & set(second.root.iterate())
    sequences = [node for node in first.root.iterate() if isinstance(node, py_trees.composites.Sequence)]
    assert all(node.memory for node in sequences)


def test_an_empty_flow_is_an_empty_sequence():
    assert shape(compile_json([]).root) == ("Sequence",)


def task(kind, **arguments):
    return Task(1, kind, Span(0, 1), tuple(Argument(name, value) for name, value in arguments.items()))


@pytest.mark.parametrize(
    ("task", "state", "sentence"),
    [
        (task("searching", object="a pen", location="in the drawer"), None, "look for a pen in the drawer"),
        (task("searching", location="the desk"), None, "look in the desk"),
        (task("searching", object="for my wallet"), None, "look for my wallet"),
        (
            task("check_state", object="my glasses", location="on the desk"),
            None,
            "check that my glasses are on the desk",
        ),
        (task("check_state", object="Anna", location="home"), None, "check that Anna is home"),
        (task("check_state", object="Anna", location="to the kitchen"), None, "check that Anna is in the kitchen"),
        (task("bringing", object="my wallet", recipient="I", goal="here"), None, "bring my wallet to me here"),
        (task("bringing", object="it", recipient="me"), None, "bring it to me"),
        (task("informing", recipient="to Anna", message="that I am late"), None, "tell Anna that I am late"),
        (task("change_state", object="the tv"), "off", "turn the tv off"),
        (task("change_state", object="the soup"), "hot", "make the soup hot"),
        (task("check_state", object="the coffee", state="hot"), None, "check that the coffee is hot"),
        (task("check_state", object="milk", location="in the fridge"), None, "check that milk is in the fridge"),
        (task("check_state", object="Anna"), None, "check that Anna is there"),
        (task("taking", object="the juice", source="out of the fridge"), None, "take the juice out of the fridge"),
        (task("motion", recipient="me"), None, "go to me"),
        (task("motion", recipient="to me"), None, "go to me"),
        (task("motion", goal="the kitchen", manner="slowly"), None, "go to the kitchen slowly"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_names_are_sentences(task, state, sentence):
    assert say_task(task, load_domain("household").ontology, state=state) == sentence


@pytest.mark.parametrize(("verb", "sentence"), [("Ask", "ask Tom where it is"), ("tell", "tell Tom where it is")])
def test_what_is_asked_is_not_told(verb, sentence):
    asked = task("informing", recipient="Tom", message="where it is")
    assert say_task(asked, load_domain("household").ontology, verb=verb) == sentence


@pytest.mark.parametrize(
    ("phrase", "state", "said"),
    [
        ("both cups", "dirty", "not both cups are dirty"),
        ("all of the cups", "dirty", "not all of the cups are dirty"),
        ("every cup", "dirty", "not every cup is dirty"),
        ("the cups", "dirty", "the cups are not dirty"),
        ("somebody or me", "there", "nobody is there"),
        ("anyone else", "there", "nobody else is there"),
    ],
)
def test_what_is_not_so_of_all_may_be_so_of_one(phrase, state, said):
    assert deny(phrase, state) == said


def test_several_are_joined():
    arguments = (Argument("object", "the cup"), Argument("object", "the mug"), Argument("recipient", "me"))
    several = Task(1, "bringing", Span(0, 1), arguments)
    assert say_task(several, load_domain("household").ontology) == "bring the cup and the mug to me"


def test_conditions_are_sentences():
    assert say_condition("check that the coffee is hot") == "if the coffee is hot"
    assert say_condition("look for a pen in the drawer") == "if I can find a pen in the drawer"
    assert say_condition("turn the tv on") == "if I can turn the tv on"


def test_the_tree_asks_what_is_asked_and_says_in_which_of_two_places_a_thing_is():
    domain = load_domain("household")
    marked = (
        "If [my phone](1:object) [is](1:check_state) neither [on the desk nor on the bed](1:location), "
        "[ask](2:informing) [Tom](2:recipient) [where it is](2:message)."
    )
    instruction = read_markup(marked, domain.ontology, flow=[{"if": 1, "else": [2]}])
    names = {node.name for node in compile_instruction(instruction, ground(instruction, domain), domain).root.iterate()}
    assert {"if my phone is on the desk or on the bed", "ask Tom where it is"} <= names
