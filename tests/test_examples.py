"""Every example runs, stays short, and prints what its docstring says.

After a change that is meant to change what they print: `UPDATE_EXAMPLES=1 python -m pytest tests/test_examples.py`.
"""

from __future__ import annotations

import ast
import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("[0-9][0-9]_*.py"))
MARK = "Output:\n"


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 5


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_prints_what_it_says(path: Path, tmp_path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    done = subprocess.run(
        [sys.executable, str(path)], capture_output=True, text=True, encoding="utf-8", cwd=tmp_path, check=False
    )
    assert done.returncode == 0, done.stderr
    docstring = ast.get_docstring(ast.parse(source), clean=False) or ""
    before, mark, said = docstring.partition(MARK)
    assert mark, "its docstring ends with what it prints, after a line 'Output:'"
    if os.environ.get("UPDATE_EXAMPLES"):
        path.write_text(source.replace(docstring, f"{before}{mark}\n{_indented(done.stdout)}", 1), encoding="utf-8")
        return
    assert _lines(done.stdout) == _lines(textwrap.dedent(said))
    assert len(source.splitlines()) < 80
    code = source.replace(docstring, "")
    assert len(code.splitlines()) < 60


def _indented(text: str) -> str:
    return "".join(f"    {line}\n" if line.strip() else "\n" for line in text.splitlines())


def _lines(text: str) -> list[str]:
    return [line.rstrip() for line in text.splitlines() if line.strip()]
