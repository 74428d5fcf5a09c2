"""The list of sentences that are read otherwise names nothing but tests: a line that names none hides nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

LIST = Path(__file__).parent / "misread.txt"


def test_every_line_of_the_list_is_a_test(request: pytest.FixtureRequest) -> None:
    config = request.config
    if config.option.keyword or config.option.markexpr or any("::" in argument for argument in config.args):
        pytest.skip("only a part of the tests was asked for")
    lines = LIST.read_text(encoding="utf-8").splitlines()
    tests = {item.nodeid for item in request.session.items}
    files = {test.partition("::")[0] for test in tests}
    exist = {line: (config.rootpath / line.partition("::")[0]).exists() for line in lines}
    assert [line for line in lines if not exist[line] or (line.partition("::")[0] in files and line not in tests)] == []
    assert lines == sorted(set(lines))
