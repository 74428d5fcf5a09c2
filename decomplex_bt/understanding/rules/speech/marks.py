"""Marks that a text lacks or has otherwise, as recognisers and hurried people write it: it is read with plain ones."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import FINITE, MARKS, Document
from decomplex_bt.understanding.remainder import COMMA, QUESTION, STOP, Remainder, Told, told
from decomplex_bt.understanding.rules.ellipses.opened_cases import attended, denied, states_told
from decomplex_bt.understanding.rules.speech.second_thoughts import second_thoughts

_CASES = frozenset("if when unless once".split())
_IS = frozenset("'s is are s".split())
_SUBJECTS = frozenset(("PRP", "WDT", "WP", "EX"))
_NEGATIONS = frozenset(("n't", "nt", "not"))


def marked(document: Document) -> Remainder | None:
    """The text with a comma around a "no" that puts an order in place of another ("turn it on *no* turn it off") and
    ahead of what a case forbids ("if it's wet *don't* iron it"), and with a question mark behind what opens a case
    without an "if" ("*red*, call Ann; *green*, come back", "*with nobody in there*, sweep it"); None where it has all
    of them."""
    told_instead: dict[int, tuple[int, ...]] = {}
    for run in second_thoughts(document):
        told_instead |= {place: (COMMA, place) for place in (run.start, run.stop) if place < len(document)}
    told_instead |= {place: (COMMA, place) for place in _prohibitions(document)}
    told_instead |= dict.fromkeys(states_told(document), (QUESTION,))
    for case in attended(document):
        told_instead |= dict.fromkeys(case.dropped, ()) | {case.mark: (QUESTION,)}
    for case in denied(document):
        told_instead |= dict.fromkeys(case.dropped, (STOP,)) | {case.mark: (QUESTION, case.mark)}
    if not told_instead:
        return None
    sequence = [Told(one) for i in range(len(document)) for one in told_instead.get(i, (i,))]
    return told(document, sequence)


def _prohibitions(document: Document) -> Iterator[int]:
    """Where a "don't" begins to say what is not to be done in the case right ahead; not what somebody does not do ("if
    the cups that are left *don't* fit")."""
    tokens = document.tokens
    for i in range(3, len(tokens) - 2):
        if tokens[i].lower not in ("do", "dont") or (tokens[i].lower == "do" and tokens[i + 1].lower not in _NEGATIONS):
            continue
        clause = next((j + 1 for j in range(i - 1, -1, -1) if tokens[j].text in MARKS), 0)
        opener = next((j for j in range(i - 1, clause - 1, -1) if tokens[j].lower in _CASES), None)
        if opener is None or tokens[i - 1].tag in _SUBJECTS or tokens[i - 1].tag in FINITE:
            continue
        asked = [t for t in tokens[opener + 2 : i] if t.tag in FINITE or t.lower in _IS]
        if len(asked) == 1 and not any(t.tag in ("WDT", "WP") or t.lower == "that" for t in tokens[opener + 2 : i]):
            yield i
