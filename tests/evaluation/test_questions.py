"""What questions pay: the annotation answers, and only where it can."""

from __future__ import annotations

from dataclasses import replace

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.evaluation.questions import score_asking
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Alternative

MARKED = "If [it](1:object=the tv) [is](1:check_state) [on](1:state), [go](2:motion) and [sit](3:motion)."
RIGHT, WRONG, THIRD = [{"if": 1, "then": [2, 3]}], [{"if": 1, "then": [2]}, 3], [{"if": 1, "then": [2], "else": [3]}]


@pytest.fixture
def gold(ontology):
    return read_markup(MARKED, ontology, flow=RIGHT)


def unsure(gold, *, best, other, confidence, tasks=None):
    alternatives = (Alternative(Flow.from_json(other), 0.3),)
    flow = Flow.from_json(best)
    return replace(gold, flow=flow, confidence=confidence, alternatives=alternatives, tasks=tasks or gold.tasks)


def test_an_answer_mends_what_a_choice_can_mend(gold, ontology):
    misread = (*gold.tasks[:2], replace(gold.tasks[2], type="taking"))
    readings = [
        unsure(gold, best=WRONG, other=RIGHT, confidence=0.35),  # mended below 0.4
        unsure(gold, best=RIGHT, other=WRONG, confidence=0.45),  # stays right
        unsure(gold, best=WRONG, other=THIRD, confidence=0.55),  # none of these
        unsure(gold, best=WRONG, other=RIGHT, confidence=0.65, tasks=misread),  # no answer mends tasks
        replace(gold, confidence=0.1),  # no other flow, nothing to ask
    ]
    rows = {row.threshold: row for row in score_asking(readings, [gold] * 5, ontology)}
    assert [row.asked.count for row in rows.values()] == [0, 0, 1, 2, 3, 4, 4, 4, 4]
    assert [row.answered.count for row in rows.values()] == [0, 0, 1, 2, 2, 2, 2, 2, 2]
    assert [row.flow.count for row in rows.values()] == [2, 2, 3, 3, 3, 3, 3, 3, 3]
    assert rows[1.0].to_json()["answered"]["total"] == 4
