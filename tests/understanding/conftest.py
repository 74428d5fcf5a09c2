"""Fixtures shared by the tests of understanding: the interpreter of the household, with all its models.

The sentences in `misread.txt` are read otherwise than they should be by the models as they are. They are expected to
fail, and fail when they do not. After new models the list is made anew:

    python -m pytest -n0 tests/understanding --runxfail -vv --tb=no \\
        | sed -n 's/ FAILED .*//p' | LC_ALL=C sort > new.txt
    mv new.txt tests/understanding/misread.txt
"""

from __future__ import annotations

from pathlib import Path

import pytest

from decomplex_bt.understanding.interpreter import Interpreter

MISREAD = frozenset((Path(__file__).parent / "misread.txt").read_text(encoding="utf-8").splitlines())

MISSES = (AssertionError, ValueError, LookupError, StopIteration, TypeError)
"""What tests raise of a reading that is another one: with other tasks than those that they take apart."""


@pytest.fixture(scope="session")
def interpreter() -> Interpreter:
    return Interpreter.load("household")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.nodeid in MISREAD:
            item.add_marker(pytest.mark.xfail(strict=True, raises=MISSES, reason="read otherwise by the models"))
