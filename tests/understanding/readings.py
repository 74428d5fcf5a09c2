"""What tests compare of a reading."""

from __future__ import annotations

from typing import Any

from decomplex_bt.understanding.interpreter import Interpreter


def flow(interpreter: Interpreter, text: str) -> Any:
    """The control flow of an instruction as `parse` prints it (docs/formats.md)."""
    return interpreter.interpret(text).to_json()["flow"]
