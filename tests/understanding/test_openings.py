"""Openings that stand at the very end of what was said, as in what a recogniser cut off."""

from __future__ import annotations

import pytest
from documents import document

from decomplex_bt.understanding.control_flow.openings import of_both, opens_matter


@pytest.mark.parametrize("words", [("third/JJ/ROOT/0",), ("and/CC/cc/1", "third/JJ/ROOT/1")])
def test_a_count_that_ends_the_text_opens_no_matter(words):
    found = document(*words)
    assert not any(opens_matter(found, token) for token in range(len(words)))


def test_a_count_behind_a_mark_opens_a_matter():
    found = document("third/JJ/advmod/2", ",/,/punct/2", "wipe/VB/ROOT/2", "it/PRP/dobj/2")
    assert opens_matter(found, 2)
    assert not opens_matter(found, 3)


@pytest.mark.parametrize("words", [("if/IN/ROOT/0",), ("wipe/VB/ROOT/0", "if/IN/mark/0")])
def test_an_if_that_ends_the_text_is_of_none(words):
    assert of_both(document(*words), len(words) - 2, len(words) - 1, len(words) - 1) == ""


def test_an_if_neither_is_of_none_of_both():
    found = document("check/VB/ROOT/0", "both/DT/dobj/0", "if/IN/mark/4", "neither/DT/nsubj/4", "is/VBZ/advcl/0")
    assert of_both(found, 0, 4, 4) == "neither"
