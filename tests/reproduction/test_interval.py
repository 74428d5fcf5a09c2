"""Intervals over splits."""

from __future__ import annotations

import numpy as np
import pytest

from decomplex_bt.reproduction.interval import bootstrap, estimate, wilson


def test_the_interval_is_nadeau_and_bengios() -> None:
    found = estimate([0.4, 0.5, 0.6], test_share=0.25, bounds=None)
    half = 4.302653 * 0.1 * (1 / 3 + 0.25) ** 0.5
    assert found.mean == pytest.approx(0.5)
    assert found.interval == pytest.approx((0.5 - half, 0.5 + half))
    assert str(found) == "0.500 [0.171, 0.829]"


def test_a_share_stays_between_0_and_1() -> None:
    assert estimate([0.1, 0.9], test_share=0.25, bounds=(0.0, 1.0)).interval == (0.0, 1.0)


def test_one_split_has_only_its_own_interval() -> None:
    assert estimate([0.5], test_share=0.25, bounds=None).interval is None
    assert estimate([0.5], test_share=0.25, bounds=None, within=(0.4, 0.6)).interval == (0.4, 0.6)


def test_wilson_and_bootstrap_agree_on_a_share() -> None:
    outcomes = [True] * 60 + [False] * 40
    drawn = bootstrap(lambda some: sum(outcomes[i] for i in some) / len(some), 100, np.random.default_rng(1))
    assert wilson(outcomes) == pytest.approx(drawn, abs=0.03)
    assert wilson([]) is None
