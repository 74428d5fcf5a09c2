import json
import xml.etree.ElementTree as ElementTree

import py_trees
import pytest
from py_trees.behaviours import StatusQueue
from py_trees.common import Status

from decomplex_bt.behaviour.compiler import compile_flow
from decomplex_bt.behaviour.export import TraceRecorder, to_behaviortree_cpp, to_dot, to_json, to_mermaid, to_text
from decomplex_bt.errors import InputError
from decomplex_bt.flow import Flow
from decomplex_bt.planning.ground_task import GroundTask, Referent

NAMES = {1: "look for a pen", 2: 'say "<pen> & {co}"', 3: "go home", 4: "wait"}


def compiled(flow=({"if": 1, "else": [2, 3]}, 4), queues=None):
    class Leaf(StatusQueue):
        def __init__(self, name, number, is_condition):
            queue = (queues or {}).get(number, [Status.SUCCESS])
            super().__init__(name, queue, eventually=queue[-1])
            pen = Referent("a pen", ("pen_1", "pen_2"), where=(("cleanliness", "clean"),))
            self.task = GroundTask(number, "searching", name, objects=(pen, Referent("a mug", ("mug",))), state="here")
            self.is_condition = is_condition

    return compile_flow(Flow.from_json(list(flow)), NAMES, Leaf, title="what was said")


def test_text_reads_as_the_instruction_does():
    assert to_text(compiled().root, is_ascii=True).splitlines() == [
        "-> what was said",
        "  ? if I can find a pen",
        "    - if: look for a pen",
        "    -> else: otherwise",
        '      - say "<pen> & {co}"',
        "      - go home",
        "  - wait",
    ]


def test_xml_writes_the_missing_branch_out_and_keeps_the_text():
    root = ElementTree.fromstring(to_behaviortree_cpp(compiled().root))
    condition = root.find("./BehaviorTree/Sequence/IfThenElse")
    assert [child.tag for child in condition] == ["Action", "AlwaysSuccess", "Sequence"]
    assert condition[2][0].get("name") == NAMES[2]
    assert dict(condition[0].items()) == {
        "ID": "PlannedTask", "name": "look for a pen", "task": "1", "type": "searching", "condition": "true",
        "object": "pen_1 | pen_2 (clean);mug", "state": "here",
    }  # fmt: skip
    assert condition[2][0].get("condition") == "false"
    ports = {port.get("name") for port in root.findall("./TreeNodesModel/Action/input_port")}
    assert set(condition[0].keys()) - {"ID", "name"} <= ports
    assert root.get("BTCPP_format") == "4"


def test_xml_stands_characters_that_xml_cannot_hold():
    tree = compiled([1])
    tree.root.children[0].name = "a\x00b\ud800c"
    assert 'name="a?b?c"' in to_behaviortree_cpp(tree.root)


def test_control_characters_are_written_out():
    tree = compiled([1])
    tree.root.name = tree.root.children[0].name = "a\nb\x1b[31m \u2028\\"
    assert to_text(tree.root, is_ascii=True).splitlines() == [
        r"-> a\nb\x1b[31m \u2028\\"[:-1], r"  - a\nb\x1b[31m \u2028\\"[:-1],
    ]  # fmt: skip
    assert r'[label="a\\nb\\x1b[31m \\u2028\\"' in to_dot(tree.root)


def test_dot_has_every_node_and_labels_the_branches():
    dot = to_dot(compiled().root)
    assert dot.count("shape=") == 7
    assert '[label="else"]' in dot
    assert '[label="then"]' not in dot
    assert r"say \"<pen> & {co}\"" in dot


def test_mermaid_has_every_node_and_keeps_the_text_in_its_quotes():
    drawn = to_mermaid(compiled(queues={1: [Status.FAILURE]}).root).splitlines()
    assert drawn[0] == "flowchart TD"
    assert drawn[1:4] == ['  n0["what was said"]', '  n1{"if I can find a pen"}', '  n2(["look for a pen"])']
    assert '  n4(["say #quot;<pen> & {co}#quot;"])' in drawn
    assert "  n1 -->|else| n3" in drawn
    assert "  n0 --> n6" in drawn
    assert len([line for line in drawn if "-->" in line]) == 6
    assert len([line for line in drawn if line.startswith("  style ")]) == 7


def test_json_snapshot_says_how_things_stand():
    tree = compiled(queues={1: [Status.FAILURE], 2: [Status.RUNNING]})
    tree.root.tick_once()
    value = json.loads(json.dumps(to_json(tree.root)))
    condition, last = value["children"]
    assert condition["truth"] is False
    assert [child["role"] for child in condition["children"]] == ["if", "else"]
    assert condition["children"][1]["children"][0]["status"] == "running"
    assert (last["status"], last["task"], last["task_type"], last["condition"]) == ("invalid", 4, "searching", False)
    assert condition["children"][0]["condition"] is True
    assert last["arguments"]["state"] == "here"
    assert last["arguments"]["object"][0] == {
        "phrase": "a pen", "candidates": ["pen_1", "pen_2"], "all": False, "count": 1,
        "where": {"cleanliness": "clean"},
    }  # fmt: skip


def test_trace_holds_changes_only():
    tree = compiled([1, 2], queues={1: [Status.RUNNING, Status.RUNNING, Status.SUCCESS], 2: [Status.SUCCESS]})
    behaviour_tree = py_trees.trees.BehaviourTree(tree.root)
    recorder = TraceRecorder(tree, clock=lambda: behaviour_tree.count * 0.1, tick=lambda: behaviour_tree.count)
    behaviour_tree.add_visitor(recorder)
    for _ in range(3):
        behaviour_tree.tick()
    assert [(e["tick"], e["node"], e["status"], e["event"]) for e in recorder.entries] == [
        (0, "0", "running", "started"),
        (0, "", "running", "started"),
        (2, "0", "success", "finished"),
        (2, "1", "success", "finished"),
        (2, "", "success", "finished"),
    ]
    assert recorder.entries[2]["sim_seconds"] == 0.2


def test_trace_tells_what_was_interrupted_and_by_what():
    tree = compiled([1, 2], queues={1: [Status.RUNNING]})
    guard = StatusQueue("guard", [Status.FAILURE, Status.FAILURE, Status.RUNNING], eventually=Status.FAILURE)
    behaviour_tree = py_trees.trees.BehaviourTree(
        py_trees.composites.Selector("safe", memory=False, children=[guard, tree.root])
    )
    recorder = TraceRecorder(tree, clock=lambda: 0.0, tick=lambda: behaviour_tree.count)
    behaviour_tree.add_visitor(recorder)
    for _ in range(4):
        behaviour_tree.tick()
    assert [(e["tick"], e["node"], e["name"], e["status"], e["event"]) for e in recorder.entries] == [
        (0, None, "guard", "failure", "finished"),
        (0, "0", NAMES[1], "running", "started"),
        (0, "", "what was said", "running", "started"),
        (0, None, "safe", "running", "started"),
        (2, None, "guard", "running", "started"),
        (2, "0", NAMES[1], "invalid", "interrupted"),
        (2, "", "what was said", "invalid", "interrupted"),
        (3, None, "guard", "failure", "finished"),
        (3, "0", NAMES[1], "running", "started"),
        (3, "", "what was said", "running", "started"),
    ]


def test_trace_tells_what_was_stopped_from_outside_between_two_ticks():
    tree = compiled([1], queues={1: [Status.RUNNING]})
    behaviour_tree = py_trees.trees.BehaviourTree(tree.root)
    recorder = TraceRecorder(tree, clock=lambda: 0.0, tick=lambda: behaviour_tree.count)
    behaviour_tree.add_visitor(recorder)
    behaviour_tree.tick()
    tree.root.stop(Status.INVALID)
    behaviour_tree.tick()
    assert [(e["node"], e["event"]) for e in recorder.entries] == [
        ("0", "started"), ("", "started"), ("0", "interrupted"), ("", "interrupted"), ("0", "started"), ("", "started"),
    ]  # fmt: skip


class Backwards(py_trees.composites.Sequence):
    """A sequence of one's own, which may do anything with its children."""


OTHERS = {
    "Selector": lambda root: py_trees.composites.Selector("odd", memory=True, children=[root]),
    "Sequence without memory": lambda root: py_trees.composites.Sequence("odd", memory=False, children=[root]),
    "Backwards": lambda root: Backwards("odd", memory=True, children=[root]),
    "Inverter": lambda root: py_trees.decorators.Inverter("odd", root),
    "Failure": lambda root: py_trees.composites.Sequence(
        "all", memory=True, children=[root, py_trees.behaviours.Failure("odd")]
    ),
}


@pytest.mark.parametrize("kind", OTHERS)
def test_xml_has_no_node_for_what_no_instruction_is_compiled_to(kind):
    with pytest.raises(InputError, match=rf"'odd' is a {kind}, for which the XML has no node; expected"):
        to_behaviortree_cpp(OTHERS[kind](compiled().root))


@pytest.mark.parametrize("kind", ["Selector", "Sequence without memory", "Backwards", "Inverter"])
def test_what_is_no_sequence_is_not_drawn_as_one(kind):
    root = OTHERS[kind](compiled([1]).root)
    label = f"{kind.split()[0]}: odd"
    assert to_text(root, is_ascii=True).splitlines()[:2] == [f"+ {label}", "  -> what was said"]
    assert f'n0 [label="{label}", shape=hexagon' in to_dot(root)
    assert f'  n0{{{{"{label}"}}}}' in to_mermaid(root)
