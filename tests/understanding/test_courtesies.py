"""Cases that only ask politely are no conditions; burdens that are real are."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.remainder import without
from decomplex_bt.understanding.rules.speech.repairs import repaired


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("Bring me the rug, provided that it isn't too much trouble.", "Bring me the rug."),
        ("If it's no bother, bring me the rug.", "bring me the rug."),
        ("Bring me the rug if it wouldn't be a hassle for you.", "Bring me the rug."),
        (
            "Bring a rug, provided that it's no trouble and that there is a clean one.",
            "Bring a rug, provided that there is a clean one.",
        ),
    ],
)
def test_a_courtesy_is_read_as_if_it_were_not_there(parser: Parser, text: str, left: str) -> None:
    document = parser.parse(text)

    assert " ".join(without(document, repaired(document)).text.split()) == left


@pytest.mark.parametrize(
    "text",
    [
        "If it's a nuisance, switch it off.",
        "Bring me the rug if it isn't too heavy.",
        "If there's no trouble with the lock, open it.",
    ],
)
def test_a_real_case_stays(parser: Parser, text: str) -> None:
    assert not repaired(parser.parse(text))
