"""Commas that a text lacks, as a recogniser writes it: around a "no" that puts an order in place of another ("turn the
radio on *no* turn it off"), and ahead of what is forbidden in a case ("if it's wet *don't* iron it")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import FINITE, MARKS, Document
from decomplex_bt.understanding.remainder import COMMA, Remainder, Told, told
from decomplex_bt.understanding.rules.speech.edits import AFTER_NO, DENYING, NO_EDITS_BEFORE, TELLING, is_order_at

NEGATIONS = frozenset(("n't", "n\u2019t", "nt", "not"))

_CASES = frozenset("if when unless once".split())
_IS = frozenset("'s ’s is are s".split())
_SUBJECTS = frozenset(("PRP", "WDT", "WP", "EX"))
_TURNING = frozenset("wait sorry actually just please uh um er".split())
"""What may stand between a "no" and what is said in place of something."""
_ASKING = frozenset("if unless when whether whenever once is are has have does do did 's".split())
_OBJECTS = frozenset("it them him her me us that this these those".split())
_OF_SOMEBODY = frozenset(("DT", "PRP$"))
_WORDLIKE = frozenset("VB VBP VBD VBN NN JJ RB".split())
"""Tags of a verb in its bare form behind a "no"."""


def set_off(document: Document) -> Remainder | None:
    """The text with a comma wherever one of these lacks its mark; None where none does."""
    places = {place for run in _second_thoughts(document) for place in (run.start, run.stop)}
    places.update(_prohibitions(document))
    if not places:
        return None
    sequence: list[Told] = []
    for i in range(len(document)):
        if i in places:
            sequence.append(Told(COMMA))
        sequence.append(Told(i))
    return told(document, sequence)


def _prohibitions(document: Document) -> Iterator[int]:
    """Where a "don't" begins to say what is not to be done in the case right ahead; not what somebody does not do ("if
    the cups that are left *don't* fit")."""
    tokens = document.tokens
    for i in range(3, len(tokens) - 2):
        if tokens[i].lower not in ("do", "dont") or (tokens[i].lower == "do" and tokens[i + 1].lower not in NEGATIONS):
            continue
        clause = next((j + 1 for j in range(i - 1, -1, -1) if tokens[j].text in MARKS), 0)
        opener = next((j for j in range(i - 1, clause - 1, -1) if tokens[j].lower in _CASES), None)
        if opener is None or tokens[i - 1].tag in _SUBJECTS or tokens[i - 1].tag in FINITE:
            continue
        asked = [t for t in tokens[opener + 2 : i] if t.tag in FINITE or t.lower in _IS]
        if len(asked) == 1 and not any(t.tag in ("WDT", "WP") or t.lower == "that" for t in tokens[opener + 2 : i]):
            yield i


def _second_thoughts(document: Document) -> Iterator[range]:
    """Every "no" that puts an order in place of another and has no mark, with the words that go with it.

    Where a case or a question stands between the order before and the "no", that answers ("is it open no close it").
    """
    if DENYING.isdisjoint(document.words):
        return
    words = [token.lower for token in document.tokens]
    for i, word in enumerate(words):
        if word not in DENYING or not 0 < i < len(words) - 2 or words[i - 1] in MARKS or words[i + 1] in MARKS:
            continue
        stop = i + 1
        while stop < len(words) - 1 and words[stop] in _TURNING:
            stop += 1
        is_said = words[i - 1] in NO_EDITS_BEFORE or not _is_told(words, i, stop)
        if is_said or words[stop] in AFTER_NO or not _is_ordered_before(document, i):
            continue
        if words[stop] in ("if", "when") or _is_order(document, stop):
            yield range(i, stop)


def _is_told(words: list[str], no: int, stop: int) -> bool:
    """Whether a "no" behind a verb of telling is no answer, since somebody else is told: "tell mum *no* tell dad"."""
    telling = [word for word in words[max(0, no - 2) : no] if word in TELLING]
    return not telling or (words[stop] == telling[-1] and words[no - 1] != telling[-1])


def _is_order(document: Document, i: int) -> bool:
    """Whether a word behind a "no" is a verb: what it denies has no object."""
    token = document.tokens[i]
    if (token.tag in ("VB", "VBP") and token.pos == "VERB") or token.lower in TELLING:
        return True
    if i + 1 == len(document):
        return False  # the text breaks off
    following = document.tokens[i + 1]
    has_object = following.lower in _OBJECTS or (following.tag in _OF_SOMEBODY and following.lower not in DENYING)
    is_name = token.tag in ("NNP", "NNS") or not token.lower.isalpha()
    return token.tag in _WORDLIKE and has_object and not is_name


def _is_ordered_before(document: Document, no: int) -> bool:
    """Whether an order stands ahead of a "no" in its sentence, with no case or question between."""
    for i in range(no - 1, -1, -1):
        if document.sentences[i] != document.sentences[no] or document.tokens[i].lower in _ASKING:
            return False
        if i + 1 < no and is_order_at(document, i):
            return True
    return False
