"""What a message asks that has to be found out before it can be said."""

from __future__ import annotations

import pytest

from decomplex_bt.planning.questions import question_of


@pytest.mark.parametrize(
    ("message", "kind", "arguments"),
    [
        ("if the oven is on", "check_state", {"object": "the oven", "state": "on"}),
        ("if the oven's still on", "check_state", {"object": "the oven", "state": "on"}),
        ("whether Anna's in the study", "check_state", {"object": "Anna", "location": "in the study"}),
        ("whether Anna's phone is in the study", "check_state", {"object": "Anna's phone", "location": "in the study"}),
        ("whether the plates\u2019re clean or not", "check_state", {"object": "the plates", "state": "clean"}),
        ("if there's milk in the fridge", "check_state", {"object": "milk", "location": "in the fridge"}),
        ("where the keys are", "searching", {"object": "the keys"}),
        ("where's the remote", "searching", {"object": "the remote"}),
        ("who is in the kitchen", "searching", {"location": "in the kitchen"}),
        ("who's in the kitchen", "searching", {"location": "in the kitchen"}),
        ("what is on the desk", "searching", {"location": "on the desk"}),
    ],
)
def test_a_question_that_looking_answers(message: str, kind: str, arguments: dict[str, str]) -> None:
    found = question_of(message)
    assert found is not None
    assert (found[0], {argument.type: argument.value for argument in found[1]}) == (kind, arguments)


@pytest.mark.parametrize(
    "message", ["dinner's ready", "that the oven is on", "who won", "to come down", "if she wants tea"]
)
def test_what_looking_does_not_answer(message: str) -> None:
    assert question_of(message) is None
