"""Orders whose object stands ahead of the verb."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "value"),
    [
        ("Polish the spoons; the candlestick, however, only wash if it's dull.", "wash", "the candlestick"),
        ("Wash the plates. The board in the sink, though, just wipe.", "wipe", "The board"),
        ("Iron the shirts, but the skirt only fold if it's dry.", "fold", "the skirt"),
        # the verb has its own object, or the phrase is its subject
        ("The soup is cold, just heat it.", "heat", "The soup"),
        ("Polish the spoons; the tray only has dust on it, so wipe it.", "Polish", "the spoons"),
        ("Polish the spoons; the tray, however, is clean, so leave the tray there.", "leave", "the tray"),
    ],
)
def test_a_fronted_object_is_of_the_verb_behind(text: str, verb: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == verb] == [value]
