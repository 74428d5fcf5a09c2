"""What an understood instruction says of itself."""

from __future__ import annotations

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Alternative, Instruction

DOMAIN = load_domain()


@pytest.mark.parametrize(
    ("text", "number", "phrase"),
    [
        ("[Find](1:searching) [a pen](1:object) [on the table](1:location)", 1, "Find a pen on the table"),
        (
            "[Look](1:searching) [for my keys](1:object) [on the desk](1:location). "
            "If [they](2:object=my keys)['re](2:check_state) [there](2:location=the desk)",
            2,
            "are my keys on the desk",
        ),
        ("If there['s](1:check_state) [a newspaper](1:object)", 1, "there is a newspaper"),
        ("If nobody [is](1:check_state) [in the hall](1:location)", 1, "anybody is in the hall"),
        ("[Look](1:searching) [for it](1:object=my wallet)", 1, "Look for my wallet"),
        (
            "[Open](1:change_state) [the box](1:object) and [put](2:placing) [it](2:object=the toy) "
            "[there](2:goal=the box)",
            2,
            "put the toy in the box",
        ),
        ("[I](1:recipient) [need](1:bringing) [my phone](1:object)", 1, "I need my phone"),
        (
            "[Let](1:informing) [me](1:recipient) know [if the tv is on](1:message)",
            1,
            "Let me know if the tv is on",
        ),
        ("[Hang](1:placing) [the towels](1:object) up", 1, "Hang the towels up"),
        ("[Put](1:placing) away [the cup](1:object), Anna", 1, "Put away the cup"),
        ("If [it](1:object) [starts](1:check_state) [raining](1:state)", 1, "it starts raining"),
        ("If [Tom](1:object=the guest) [answers](1:check_state)", 1, "the guest answers"),
        (
            "If [it](1:object=my phone) [is](1:check_state) neither [on the desk nor on the bed](1:location)",
            1,
            "is my phone on the desk or on the bed",
        ),
    ],
)
def test_a_task_is_told_in_proper_words(text: str, number: int, phrase: str) -> None:
    instruction = read_markup(text, DOMAIN.ontology, flow=list(range(1, number + 1)))
    assert instruction.phrase(number) == phrase


def test_what_is_only_implied_is_sought_at_the_place() -> None:
    text = "[Find](1:searching) [my keys](1:object) or [try](2:searching) [the drawer](2:location)"
    implied = {2: {"object": "my keys"}}
    instruction = read_markup(text, DOMAIN.ontology, flow=[1, 2], implied=implied)
    assert instruction.phrase(2) == "try the drawer for my keys"


@pytest.mark.parametrize("alternatives", [-1, 1.5, True, "2"])
def test_other_flows_are_counted_from_none(alternatives) -> None:
    two = Alternative(Flow(), 0.2)
    instruction = Instruction("Go.", alternatives=(two, two))
    assert [len(instruction.to_json(alternatives=n)["alternatives"]) for n in range(4)] == [0, 1, 2, 2]
    with pytest.raises(ValueError, match=f"alternatives is {alternatives!r}; expected a whole number from 0, or None"):
        instruction.to_json(alternatives=alternatives)
