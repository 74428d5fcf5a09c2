"""What tests compare of a reading."""

from __future__ import annotations

from typing import Any

from decomplex_bt.understanding.interpreter import Interpreter


def flow(interpreter: Interpreter, text: str) -> Any:
    """The control flow of an instruction as `parse` prints it (docs/formats.md)."""
    return interpreter.interpret(text).to_json()["flow"]


def unordered(found: Any) -> Any:
    """A flow in which it does not matter which of two places of a task is its first."""
    if isinstance(found, dict):
        return found["same"][0] if "same" in found else {key: unordered(value) for key, value in found.items()}
    return [unordered(one) for one in found] if isinstance(found, list) else found
