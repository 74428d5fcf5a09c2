"""Fixtures shared by the tests of understanding: the interpreter of the household, with all its models."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.fixture(scope="session")
def interpreter() -> Interpreter:
    return Interpreter.load("household")
