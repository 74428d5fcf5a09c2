"""What README and docs show runs: Python blocks as they stand, commands through the command line's own entry."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(language: str) -> list[tuple[str, str]]:
    """Page and text of every block in this language."""
    return [
        (page.stem, body)
        for page in PAGES
        for found, body in BLOCK.findall(page.read_text(encoding="utf-8"))
        if found == language
    ]


def commands() -> list[str]:
    """Every command of ours in README and docs, once."""
    lines = (line for _, body in blocks("bash") for line in body.splitlines())
    return list(dict.fromkeys(line for line in lines if "decomplex-bt " in line))


@pytest.mark.parametrize(("page", "code"), blocks("python"), ids=lambda value: value.splitlines()[0][:30])
def test_python_block_runs(page: str, code: str, tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("command", commands())
def test_command_runs(command: str) -> None:
    said = ""
    if " | " in command:
        before, command = command.split(" | ", 1)
        said = " ".join(shlex.split(before)[1:]) + "\n"
    program, *arguments = shlex.split(command)
    assert program == "decomplex-bt"
    if "--episodes" in arguments:
        arguments[arguments.index("--episodes") + 1] = "1"  # one world will do
    whole = [sys.executable, "-m", "decomplex_bt.cli", *arguments]
    done = subprocess.run(whole, input=said, capture_output=True, text=True, encoding="utf-8", cwd=ROOT, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()


def test_links_lead_somewhere() -> None:
    for page in (*PAGES, ROOT / "CONTRIBUTING.md"):
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name} links to {target}, which is not there"


def test_readme_has_the_two_commands() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert "\ndecomplex-bt run " in text
    assert "\npython -m pytest -n auto\n" in text
