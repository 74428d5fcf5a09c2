"""What is said has an "um" in it, a value has none."""

import pytest

from decomplex_bt.hesitation import without_hesitation


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("on his way uh, home", "on his way home"),
        ("the pantry, um, behind the pasta", "the pantry behind the pasta"),
        ("a bib, uhm two muslins", "a bib, two muslins"),
        ("the mug, uh, plate and fork", "the mug, plate and fork"),
        ("the um uh, box", "the box"),
        ("the box, um", "the box"),
        ("er the umbrella", "the umbrella"),
    ],
)
def test_it_goes_with_its_commas_and_lists_keep_theirs(words, expected):
    assert without_hesitation(words) == expected


@pytest.mark.parametrize("words", ["to Umm Khalid", "the ER bag", "'er coat", "the mm-hmm button", "error 7", "um"])
def test_what_only_looks_like_it_stays(words):
    assert without_hesitation(words) == words
