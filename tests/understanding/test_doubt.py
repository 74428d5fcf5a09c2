"""Doubt: the question that tells the likeliest flows apart, and what its answers change."""

from __future__ import annotations

from dataclasses import replace

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.errors import InputError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Alternative
from decomplex_bt.understanding.doubt import doubt_of, resolved, settled

FLOWS = ([{"if": 1, "then": [2]}, 3], [{"if": 1, "then": [2, 3]}], [{"if": 1, "then": [2], "else": [3]}])


@pytest.fixture
def unsure(ontology):
    """If it is open, close my window and bring me the mail: does the last belong to the condition?"""
    marked = (
        "If [it](1:object=my window) [is](1:check_state) [open](1:state), [close](2:change_state) "
        "[my window](2:object) and [bring](3:bringing) [me](3:recipient) [the mail](3:object)."
    )
    instruction = read_markup(marked, ontology, flow=FLOWS[0])
    others = (Alternative(Flow.from_json(flow), 0.2) for flow in FLOWS[1:])
    return replace(instruction, confidence=0.5, alternatives=tuple(others))


def test_the_question_is_about_the_task_that_moves_in_words_to_the_user(unsure, ontology):
    doubt = doubt_of(unsure, ontology, threshold=0.6)
    assert doubt.task == 3
    assert doubt.question == (
        "Should I bring the mail to you in any case, or only if your window is open, or unless your window is open?"
    )
    assert [choice.flow.to_json() for choice in doubt.choices] == list(FLOWS)


@pytest.mark.parametrize(
    ("answer", "flow"),
    [("2", 1), ("only if it is open", 1), ("If the window is open!", 1), ("unless the window is open", 2),
     ("in any case", 0), ("IN ANY CASE", 0), (1, 0), (2, 1), ("7", None), (0, None), (-1, None), (4, None),
      ("the window", None), ("if not", None), ("²", None), ("bananas", None),
     ("", None)],
)  # fmt: skip
def test_an_answer_chooses_a_flow_and_never_its_opposite(unsure, ontology, answer, flow):
    chosen = resolved(unsure, doubt_of(unsure, ontology, threshold=0.6), answer)
    assert (chosen.flow.to_json() if chosen else None) == (FLOWS[flow] if flow is not None else None)
    assert chosen is None or (chosen.confidence, chosen.alternatives) == (1.0, ())


def test_a_choice_is_an_answer_and_so_are_its_very_words(unsure, ontology):
    doubt = doubt_of(unsure, ontology, threshold=0.6)
    for choice in doubt.choices:
        for answer in (choice, choice.text, f" {choice.text.upper()} "):
            assert resolved(unsure, doubt, answer).flow == choice.flow
    assert resolved(unsure, doubt, replace(doubt.choices[0], text="never")) is None


@pytest.mark.parametrize("answer", ["the second", "7", 0, "if not"])
def test_an_answer_that_fits_no_choice_is_not_taken_for_the_likeliest(unsure, ontology, answer):
    with pytest.raises(InputError) as refused:
        settled(unsure, ontology, lambda doubt: answer, threshold=0.6)
    assert f"is {answer!r}; expected one of its choices" in str(refused.value)
    assert "2: 'only if your window is open'" in str(refused.value)


def test_who_is_sure_does_not_ask(unsure, ontology):
    def ask(doubt):
        raise AssertionError("asked")

    assert settled(unsure, ontology, ask, threshold=0.5) is unsure
    sure = replace(unsure, alternatives=())
    assert settled(sure, ontology, ask, threshold=1.0) is sure
    assert settled(unsure, ontology, lambda doubt: None, threshold=0.6) is unsure
