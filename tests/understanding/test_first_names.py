"""A name tells who "her" and "him" are."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.references.first_names import MEN, WOMEN


def test_no_name_is_of_both() -> None:
    assert not WOMEN & MEN


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("Ask Peter where Linda is and then go to her.", "goal", "Linda"),
        ("Ask Linda where Peter is and then bring him the map.", "recipient", "Peter"),
        ("Tell Linda that Peter has the map and then bring him a torch.", "recipient", "Peter"),
        ("Tell Peter that Linda is looking for him, and then follow her.", "object", "Linda"),
        ("Ask Peter if Linda is up, and if so, bring her the soup.", "recipient", "Linda"),
    ],
)
def test_who_is_told_is_not_who_is_meant(interpreter: Interpreter, text: str, kind: str, value: str) -> None:
    assert interpreter.interpret(text).tasks[-1].value(kind) == value
