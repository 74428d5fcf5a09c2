"""Structures of instructions: each is found where it is, and not in what only looks like it."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.corpus_structures import STRUCTURES

PEN = (
    "[Bring](1:bringing) [me](1:recipient) [a pen](1:object) if you [find](2:searching) [it](2:object=a pen). "
    "Otherwise, [tell](3:informing) [me](3:recipient)."
)
TV = "[Turn](1:change_state) [on](1:state) [the tv](1:object). If you cannot, [bring](2:bringing) [a fan](2:object)."
OVEN = "[Oven](1:object) [on](1:check_state)? [Close](2:change_state) [it](2:object=the oven). It was dear to me."
ASKED = (
    "[Is](1:check_state) [it](1:object=x) [hot](1:state) or [is](2:check_state) [it](2:object=x) [full](2:state)? "
    "[Go](3:motion) [there](3:goal=x)."
)
EITHER = [{"if": 1, "then": [3], "else": [{"if": 2, "then": [{"same": [3]}]}]}]
BOTH = (
    "If [it](1:object=x) [is](1:check_state) [hot](1:state), [go](2:motion) [home](2:goal) and [sing](3:informing), "
    "then [call](4:informing)."
)
NOTHING = "I have a headache today."

HAS = [
    (PEN, [{"if": 2, "then": [1], "else": [3]}], "task before its condition", "out of order"),
    (PEN, [{"if": 2, "then": [1], "else": [3]}], "implicit, over sentences", "question as condition"),
    (PEN, [{"if": 2, "then": [1], "else": [3]}], "with an unmarked dependency", "failed action"),
    (TV, [{"if": 1, "else": [2]}], "failed action", "failed search"),
    (TV, [{"if": 1, "else": [2]}], "with a marked dependency", "with then and else"),
    (TV, [2, 1], "out of order", "with a condition"),
    (OVEN, [{"if": 1, "then": [2]}], "verbless condition", "with a marked dependency"),
    (OVEN, [{"if": 1, "then": [2]}], "with a plain statement", "with a negation"),
    (ASKED, EITHER, "A and B, or A or B", "independent conditions"),
    (ASKED, EITHER, "question as condition", "verbless condition"),
    (ASKED, EITHER, "there, here", "one, another, the other"),
    (BOTH, [{"if": 1, "then": [2, 3]}, 4], "several, then for both", "nested in then"),
    (BOTH, [{"if": 1, "then": [2]}, {"if": 3, "then": [4]}], "independent conditions", "several, then for both"),
    (NOTHING, [], "without a task", "with a plain statement"),
]


@pytest.mark.parametrize(("text", "flow", "structure", "other"), HAS, ids=[f"{h[2]}, {h[0][:12]}" for h in HAS])
def test_a_structure_is_told_from_its_like(ontology, text, flow, structure, other) -> None:
    instruction = read_markup(text, ontology, flow=flow)
    found = {name for name, has in STRUCTURES.items() if has(instruction)}
    assert structure in found
    assert other not in found
