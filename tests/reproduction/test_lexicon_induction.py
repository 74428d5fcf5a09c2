"""The rule baseline: what it labels, and what the paper says it cannot."""

from __future__ import annotations

import pytest

from decomplex_bt.reproduction.lexicon_induction import lex_induct
from decomplex_bt.understanding.document import Parser

C, P, N, S = "conditional", "dependent_positive", "dependent_negative", "sequential"
CASES = {
    "no rule": ("Go to the kitchen and bring me a cup.", "go bring", (S, S)),
    "if": ("If the coffee is hot, bring it to me.", "is bring", (C, P)),
    "all that follows": ("If the door is open, go in and take the cup.", "is go take", (C, P, P)),
    "negated": ("If you cannot find it on the table, look in the cupboard.", "find look", (C, N)),
    "negated behind": ("If the tv isn't on, turn it on.", "is turn", (C, N)),
    "no": ("If there is no milk, tell me.", "is tell", (C, N)),
    "unless": ("Unless the lamp is off, switch it off.", "is switch", (C, N)),
    "else": ("If the cup is clean, bring it, else wash it.", "is bring wash", (C, P, N)),
    "otherwise, in a sentence of its own": ("If it is hot, bring it. Otherwise heat it.", "is bring heat", (C, P, N)),
    "otherwise after a negation": ("If it is not hot, heat it, otherwise bring it.", "is heat bring", (C, N, P)),
    "a check of a clause": ("Check if the door is open and tell me.", "check tell", (S, S)),
    "a new sentence": ("If the tv is on, turn it off. Go to the kitchen.", "is turn go", (C, P, S)),
    # what the paper says lex_induct cannot do (section IV-C)
    "out of order": ("Bring me a pen if you find one on the table.", "bring find", (S, C)),
    "implicit": ("Turn on the tv. If you cannot, bring me the remote.", "turn bring", (S, C)),
}


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.mark.parametrize(("text", "verbs", "labels"), CASES.values(), ids=CASES.keys())
def test_rules(text: str, verbs: str, labels: tuple[str, ...], parser: Parser) -> None:
    document = parser.parse(text)
    words = [token.lower for token in document.tokens]
    tasks: list[int] = []
    for verb in verbs.split():
        tasks.append(words.index(verb, tasks[-1] + 1 if tasks else 0))
    assert lex_induct(document, tasks) == labels
