"""The list of sentences that are read otherwise names nothing but tests: a line that names none hides nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

LIST = Path(__file__).parent / "misread.txt"


def test_every_line_of_the_list_is_a_test(request: pytest.FixtureRequest) -> None:
    chosen = request.config.option
    choices = (getattr(chosen, name, None) for name in ("keyword", "markexpr", "deselect", "lf"))
    if any(choices) or any("::" in argument for argument in request.config.args):
        pytest.skip("only a part of the tests was asked for")
    lines = LIST.read_text(encoding="utf-8").splitlines()
    tests = {item.nodeid for item in request.session.items}
    assert [line for line in lines if not (request.config.rootpath / _file(line)).exists()] == []
    asked = set(map(_file, tests))
    assert [line for line in lines if _file(line) in asked and line not in tests] == []
    assert lines == sorted(set(lines))


def _file(test: str) -> str:
    return test.partition("::")[0]
