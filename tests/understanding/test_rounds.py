"""A search that goes on from place to place is of every one of them."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("check under the bench, then behind the piano", ["under the bench", "behind the piano"]),
        ("If she isn't up, look in the attic and then in the shed.", ["in the attic", "in the shed"]),
        (
            "Look in the crate, then in the sack, and finally on the roof.",
            ["in the crate", "in the sack", "on the roof"],
        ),
        ("Look in the crate, then put the sack on the roof.", ["in the crate"]),
        ("Look in the crate and bring me the sack.", ["in the crate"]),
    ],
)
def test_a_search_is_of_every_place_that_it_goes_on_to(text: str, places: list[str], encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    (search,) = (task for task in found.tasks if task.type == "searching")
    assert list(search.values("location")) == places
