"""Fixtures shared by all tests: the household's ontology, and documents built by hand, without a language model."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import decomplex_bt.domains.household as household
from decomplex_bt.domain.document import read_record
from decomplex_bt.domain.ontology import Ontology

HOUSEHOLD = Path(next(iter(household.__path__))) if hasattr(household, "__path__") else Path(household.__file__).parent


@pytest.fixture(scope="session")
def household_folder() -> Path:
    return HOUSEHOLD


@pytest.fixture(scope="session")
def ontology() -> Ontology:
    return read_record(HOUSEHOLD / "ontology.yaml", Ontology)


@pytest.fixture(scope="session")
def printed_under_hash_seeds() -> Callable[[str], set[str]]:
    """What a program prints in processes with different hash seeds; one output if none of it depends on them."""

    def run(program: str) -> set[str]:
        return {
            subprocess.run(
                [sys.executable, "-c", program],
                env={**os.environ, "PYTHONHASHSEED": seed},
                capture_output=True,
                text=True,
                check=True,
            ).stdout
            for seed in ("0", "1")
        }

    return run


MOST_WORKERS = 4
"""How many processes `-n auto` starts at most; each loads the language model and the networks (half a gigabyte)."""


def pytest_xdist_auto_num_workers() -> int:
    return min(os.cpu_count() or 1, MOST_WORKERS)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the tests marked slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--slow"):
        return
    skip = pytest.mark.skip(reason="slow; run with --slow")
    for item in items:
        if "slow" in item.keywords:
            item.add_marker(skip)
