"""Cues are found by phrase, the longest first, and told apart by what stands around them."""

import pytest
from documents import document

from decomplex_bt.understanding.cues import find_cues
from decomplex_bt.understanding.document import Parser


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("if it is hot", ["if"]),
        ("take the bin out if it is full", ["if"]),
        ("see if it is hot", ["whether"]),
        ("let me know if it is hot", ["whether"]),
        ("only if it is hot", ["only_if"]),
        ("if not , tell me", ["else"]),
        ("if you ca n't , tell me", ["fail"]),
        ("if you ca n't find it", ["if", "not"]),
        ("if any , bring them", ["so"]),
        ("if any bring them", ["so"]),
        ("if any kill them", ["so"]),
        ("if any are wet , bring them", ["if"]),
        ("if any of it is wet , bring it", ["if"]),
        ("if any cups are wet , bring them", ["if"]),
        ("no luck ? tell me", ["fail"]),
        ("and no luck ? tell me", ["fail"]),
        ("it is no good , tell me", ["not"]),
        ("get the fallback key", []),
        ("check if something goes wrong", ["whether"]),
        ("either way close it", ["either_way"]),
        ("before that close it", ["before_that"]),
        ("before the window", ["before"]),
        ("but before you go", ["but", "before"]),
        ("b4 that close it", ["before_that"]),
        ("but before any of that close it", ["but", "before_all"]),
        ("but not before you go", ["but", "until"]),
        ("ahead of everything close it", ["before_all"]),
        ("earlier still close it", ["before_that"]),
        ("close it at the end", ["last"]),
        ("close it last", ["last"]),
        ("do this last", ["last"]),
        ("close the last one", []),
        ("next close it", ["then"]),
        ("put it next to the door", []),
        ("put it at the end of the shelf", []),
    ],
)
def test_a_phrase_is_its_class(text, expected):
    found = [cue.name for cue in find_cues(document(*text.split()))]
    assert [name for name in found if name not in ("can", "and")] == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Sweep the floor before any of that.", ["before_all"]),
        ("Before that, close it.", ["before_that"]),
        ("Clean the table before both guests arrive.", ["before"]),
        ("Before any of this gets cold, cover it.", ["before"]),
        ("Before that meeting starts, bring me a coffee.", ["before"]),
        ("If it is not before noon, close the door.", ["not", "before"]),
        ("Turn off the light, but not before you have closed the door.", ["until"]),
        ("Before it is dry, don't touch the wall.", ["until", "not"]),
        ("Before you go, don't wake the baby.", ["before", "not"]),
        ("Before you go, don't forget the milk.", ["before"]),
        ("Put the box on shelf B4 and close the door.", []),
    ],
)
def test_what_goes_on_after_before_is_a_clause_and_no_pro_form(text, expected):
    names = {"before", "before_that", "before_all", "until", "not"}
    assert [cue.name for cue in find_cues(Parser().parse(text)) if cue.name in names] == expected


@pytest.mark.parametrize(
    ("text", "is_cue"),
    [
        ("If there are five cups instead of four, fetch a tray.", False),
        ("If it's hot, fetch the pot instead of the pan.", True),
        ("If it's hot, fetch the pot instead.", True),
    ],
)
def test_an_instead_that_only_counts_turns_nothing(text: str, is_cue: bool) -> None:
    assert any(cue.name == "instead" for cue in find_cues(Parser().parse(text))) == is_cue


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Empty the pan if none of the lamps is on.", ["if", "not"]),
        ("Empty the pan if neither lamp is on.", ["if", "not"]),
        ("Empty the pan, and if nothing is in the crate, fold it.", ["if", "not"]),
        ("Fetch the pan, and if neither is there, fold it.", ["if", "not"]),
        # this names nothing, and says that the order before failed
        ("Empty the pan, and if none of that works, fold it.", ["else"]),
    ],
)
def test_a_denial_that_names_its_things_opens_a_condition(text: str, expected: list[str]) -> None:
    names = {"if", "not", "else"}
    assert [cue.name for cue in find_cues(Parser().parse(text)) if cue.name in names] == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Fetch the torch. If it doesn't work, tell me.", "if"),
        ("Get the lamp from the den and put it here. If it doesn't work, tell me.", "if"),
        ("Turn on the torch. If it doesn't work, tell me.", "fail"),
        ("Take the lid off. If it doesn't work, tell me.", "fail"),
        ("Try to get the jar open. If it doesn't work, tell me.", "fail"),
        ("Fetch the torch. If that doesn't work, tell me.", "fail"),
    ],
)
def test_it_does_not_work_is_of_what_was_fetched_or_a_failure_of_what_was_tried(text: str, expected: str) -> None:
    names = {cue.name for cue in find_cues(Parser().parse(text))}
    assert names & {"if", "fail"} == {expected}
