"""Who "he" and "she" are where a phrase names more than one: whose dog, from where, with what title."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "word", "value"),
    [
        ("Ask the lady from Hull if she wants tea, and if she does, bring her a cup.", "her", "the lady from Hull"),
        ("If the verger is in the hall, give him the key.", "him", "the verger"),
        ("If Mrs Kerr's terrier has come in from the rain, dry him.", "him", "Mrs Kerr's terrier"),
        ("My sister's hound is in the yard. If he's barking, open the gate.", "he", "My sister's hound"),
        # whose brother that is
        ("Tell Ida's brother lunch is ready. If she's asleep, close the door.", "she", "Ida"),
        ("Bring Ida's rabbit to her bed. If you can't find it, give her the doll.", "her", "Ida"),
        ("Go and feed Tom's cat, and ask him if he wants soup.", "him", "Tom"),
        ("Brush the pony and tell her she is lovely.", "her", "the pony"),
    ],
)
def test_somebody_is_meant_who_can_be(text: str, word: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    said = [a.value for t in found.tasks for a in t.arguments if a.span is not None and a.span.of(text) == word]
    assert said[-1:] == [value]
