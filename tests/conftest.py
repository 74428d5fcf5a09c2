"""Fixtures shared by all tests: the household's ontology, and documents built by hand, without a language model."""

from __future__ import annotations

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


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the tests marked slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--slow"):
        return
    skip = pytest.mark.skip(reason="slow; run with --slow")
    for item in items:
        if "slow" in item.keywords:
            item.add_marker(skip)
