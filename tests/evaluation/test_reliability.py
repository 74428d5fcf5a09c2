"""Confidence held against truth: bins, expected calibration error, the picture."""

from __future__ import annotations

from dataclasses import replace

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.reliability import check_plot, reliability, write_plot
from decomplex_bt.flow import Flow

MARKED = "[Bring](1:bringing) [the cup](1:object) and [wash](2:change_state) [it](2:object=the cup)."


@pytest.fixture
def gold(ontology):
    return read_markup(MARKED, ontology, flow=[1, 2])


def believed(instruction, confidence, flow=None, value="the cup"):
    """A reading with this confidence in everything."""
    tasks = tuple(
        replace(
            task,
            confidence=confidence,
            dependency_confidence=confidence,
            arguments=tuple(
                replace(a, confidence=confidence, value=value if a.value != a.span.of(instruction.text) else a.value)
                for a in task.arguments
            ),
        )
        for task in instruction.tasks
    )
    return replace(instruction, tasks=tasks, confidence=confidence, flow=flow or instruction.flow)


def test_the_error_is_the_gap_between_belief_and_truth(gold):
    wrong = Flow.from_json([{"if": 1, "then": [2]}])
    found = [believed(gold, 0.9), believed(gold, 0.9, wrong), believed(gold, 1.0)]
    found.append(believed(gold, 0.25, wrong, "the tea"))
    task, argument, dependency, flow = reliability(found, [gold] * 4)
    assert [one.total for one in (task, argument, dependency, flow)] == [8, 8, 8, 4]
    assert (flow.bins[9].right.count, flow.bins[9].right.total) == (2, 3)
    assert flow.bins[9].confidence == pytest.approx(2.8 / 3)
    assert flow.error == pytest.approx((abs(2.8 - 2) + abs(0.25 - 0)) / 4)
    assert task.error == pytest.approx(2 * (abs(2.8 - 3) + abs(0.25 - 1)) / 8)
    assert dependency.bins[2].right.count == 0
    assert argument.bins[2].right.count == 1  # another referent is another argument
    assert flow.to_json()["bins"][0]["confidence"] is None


def test_a_picture_is_refused_before_the_work(tmp_path, monkeypatch):
    with pytest.raises(InputError, match=r"expected one of \.png"):
        check_plot(tmp_path / "a.bmp")
    with pytest.raises(InputError, match="there is no folder"):
        check_plot(tmp_path / "b" / "a.png")
    monkeypatch.setattr("decomplex_bt.evaluation.reliability.find_spec", lambda name: None)
    with pytest.raises(InputError, match=r"decomplex-bt\[plots\]"):
        check_plot(tmp_path / "a.png")


def test_a_picture_is_drawn(gold, tmp_path):
    pytest.importorskip("matplotlib")
    write_plot(reliability([believed(gold, 0.8)], [gold]), tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 1000
