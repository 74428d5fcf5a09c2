"""Noise keeps every annotated span on its words, whatever becomes of the text around and inside them."""

from __future__ import annotations

import numpy as np
import pytest

from decomplex_bt.corpus import read_corpus, read_markup, write_markup
from decomplex_bt.understanding import disturbances
from decomplex_bt.understanding.disturbances import DISTURBANCES, as_recognised, with_fillers
from decomplex_bt.understanding.noise import Change, changed, edited, without_marks, without_punctuation

MARKED = "[Bring](1:bringing) [the red cup](1:object), then [wash](2:change_state) [it](2:object=the red cup)."


@pytest.fixture
def instruction(ontology):
    return read_markup(MARKED, ontology, flow=[1, 2])


def test_spans_and_the_values_that_quote_them_move_with_the_text(instruction):
    copy = changed(
        instruction,
        [
            Change(0, 0, "Um, "),  # before a span: outside
            Change(6, 6, "me "),
            Change(6, 9, ""),  # the first word of a span goes with its space
            Change(9, 10, ""),
            Change(14, 17, "mugg"),
            Change(18, 18, " uh"),  # behind a comma
        ],
    )
    assert write_markup(copy) == (
        "Um, [Bring](1:bringing) me [red mugg](1:object), uh then [wash](2:change_state) [it](2:object=red mugg)."
    )


def test_a_span_never_ends_with_a_space(instruction):
    copy = changed(instruction, [Change(13, 14, ""), Change(14, 17, "")])
    assert copy.tasks[0].arguments[0].span.of(copy.text) == "the red"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ([Change(3, 8, "x")], "straddles"),
        ([Change(0, 3, "x"), Change(2, 4, "y")], "overlap"),
        ([Change(0, 5, "")], "nothing"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_changes_that_would_lose_a_span_are_refused(instruction, changes, said):
    with pytest.raises(ValueError, match=said):
        changed(instruction, changes)


def test_marks_go_with_or_without_the_case(instruction):
    assert edited(instruction, without_marks).text == "Bring the red cup then wash it"
    assert edited(instruction, without_punctuation).text == "bring the red cup then wash it"


@pytest.mark.parametrize("name", DISTURBANCES)
def test_every_disturbance_carries_a_whole_voice(name, ontology, household_folder):
    def copies():
        rng = np.random.default_rng(5)
        return [DISTURBANCES[name](example.instruction, rng) for example in examples]

    examples = read_corpus(household_folder / "corpus" / "walt.yaml", ontology)
    disturbed = copies()
    assert disturbed == copies()
    assert sum(c.text != e.instruction.text for c, e in zip(disturbed, examples, strict=True)) > len(examples) / 2
    for copy, example in zip(disturbed, examples, strict=True):
        again = read_markup(write_markup(copy), ontology, flow=copy.flow.to_json())
        assert again.text == copy.text
        assert [(t.type, t.span) for t in again.tasks] == [(t.type, t.span) for t in copy.tasks]
        assert copy.flow == example.instruction.flow
        assert not any(c.isspace() for task in copy.tasks for c in task.span.of(copy.text))


def test_a_recogniser_splits_and_joins_mishears_and_spells(ontology, monkeypatch):
    for rate in ("HOMOPHONE_RATE", "DROP_RATE", "CONTRACTION_RATE"):
        monkeypatch.setattr(disturbances, rate, 1.0)
    marked = (
        "At 7:30, if [it](1:object)['s](1:check_state) [wet](1:state) or is not [here](1:location), "
        "[buy](2:taking) [the mail](2:object)."
    )
    heard = as_recognised(read_markup(marked, ontology, flow=[{"if": 1, "then": [2]}]), np.random.default_rng(1))
    assert heard.text.replace("it s", "its") == "seven thirty if its wet or isnt hear by male"
    assert [task.span.of(heard.text) for task in heard.tasks] == ["s", "by"]
    assert heard.tasks[1].arguments[0].value == "male"


def test_only_hesitations_come_between_the_words_of_an_argument(ontology, monkeypatch):
    monkeypatch.setattr(disturbances, "FILLER_RATE", 1.0)
    marked = "[Bring](1:bringing) [the old blue woollen winter coat](1:object)"
    copy = with_fillers(read_markup(marked, ontology, flow=[1]), np.random.default_rng(2))
    (coat,) = copy.tasks[0].arguments
    assert coat.span is not None
    assert coat.value == "the old blue woollen winter coat"
    words = coat.span.of(copy.text).replace(",", "").split()
    assert words[::2] == coat.value.split()
    assert set(words[1::2]) <= set(disturbances.HESITATIONS)


@pytest.mark.parametrize("seed", range(20))
def test_slips_leave_something_of_every_span_however_many_there_are(seed, ontology, monkeypatch):
    monkeypatch.setattr(disturbances, "SLIP_RATE", 1.0)
    instruction = read_markup(
        "[Put](1:change_state) [it](1:object=the fan) [on](1:state) or [off](1:state) by [us](1:location).",
        ontology,
        flow=[1],
    )
    slipped = DISTURBANCES["typing slips"](instruction, np.random.default_rng(seed))
    assert slipped.text != instruction.text
    assert all(span.of(slipped.text).strip() for span in disturbances.spans_of(slipped))
