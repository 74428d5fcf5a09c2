"""Instructions are drawn from the corpus without reading a voice, or grounding what does not suit a house, twice."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from decomplex_bt.corpus import Example, read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs import opening, setting
from decomplex_bt.envs.household import HouseholdEnv

DOMAIN = load_domain("household")


def test_a_voice_is_read_once(monkeypatch: pytest.MonkeyPatch):
    go = read_markup("[Go](1:motion) [to the kitchen](1:goal).", DOMAIN.ontology, flow=[1])
    read = Counter()

    def read_corpus(path, ontology):
        read[path] += 1
        return (Example("1", go),)

    monkeypatch.setattr(setting, "read_corpus", read_corpus)
    domain, rng = replace(DOMAIN), np.random.default_rng(0)
    for _ in range(1000):
        setting.draw_request(domain, rng)
    assert len(read) > 100
    assert set(read.values()) == {1}


def test_what_does_not_suit_the_house_is_tried_once(monkeypatch: pytest.MonkeyPatch):
    env, judged = HouseholdEnv(), []
    drawn = env.reset(seed=3)[1]["instruction"]
    judge_for = opening.judge_for
    monkeypatch.setattr(opening, "judge_for", lambda *given: judged.append(given) or judge_for(*given))
    assert env.reset(seed=3)[1]["instruction"] == drawn
    assert len(judged) == 1
