"""Scores under noise: rows side by side, differences over pairs, spans that end inside a token."""

from __future__ import annotations

import re

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.evaluation.robustness import on_tokens, score_noise
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Instruction, Span, Task
from decomplex_bt.understanding.disturbances import DISTURBANCES
from decomplex_bt.understanding.noise import spans_of


class Pedant:
    """Finds the word "close", spelt so and with a full stop at the end, and nothing else."""

    def interpret_batch(self, texts, *, jobs=1):
        for text in texts:
            found = re.match(r"close\b.*\.$", text, re.IGNORECASE)
            tasks = (Task(1, "change_state", Span(0, 5)),) if found else ()
            yield Instruction(text, tasks, Flow.from_json([1] if found else []))

    def tokens(self, text):
        return tuple(Span(*match.span()) for match in re.finditer(r"\w+|[^\w\s]", text))


def test_every_row_is_held_against_the_plain_text(ontology):
    gold = [read_markup("[Close](1:change_state) it.", ontology, flow=[1])] * 8
    rows = {row.name: row for row in score_noise(Pedant(), gold, seed=3)}
    assert list(rows) == ["as they are", *DISTURBANCES]
    assert rows["as they are"].flow.count == rows["lower case"].flow.count == 8
    assert rows["no punctuation"].flow.count == 0
    assert rows["no punctuation"].difference.value == -1
    assert rows["as they are"].difference.to_json() == {"value": 0.0, "interval": [0.0, 0.0]}
    assert (rows["lower case"].tasks.low, rows["lower case"].tasks.high) == (1.0, 1.0)
    assert rows["typing slips"].tasks.low <= rows["typing slips"].tasks.value <= rows["typing slips"].tasks.high
    assert list(rows.values()) == list(score_noise(Pedant(), gold, seed=3))


def test_a_span_inside_a_token_becomes_the_token(ontology):
    marked = "if [it](1:object)[s](1:check_state) [on](1:state), [go](2:motion)"
    instruction = on_tokens(read_markup(marked, ontology, flow=[{"if": 1, "then": [2]}]), Pedant())
    assert [span.of(instruction.text) for span in spans_of(instruction)] == ["its", "its", "on", "go"]
    assert instruction.tasks[1].span == Span(11, 13)


def test_nothing_to_read_is_no_row_without_data(ontology):
    with pytest.raises(ValueError, match="at least one"):
        score_noise(Pedant(), [])
