"""Second thoughts without a mark, as a recogniser writes them: an order behind a "no" that no comma sets off ("turn the
radio on no turn it off"), which the tagger takes for the noun that "no" denies."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.rules.speech.edits import AFTER_NO, DENYING, NO_EDITS_BEFORE, TELLING, is_order_at

_TURNING = frozenset("wait sorry actually just please uh um er".split())
"""What may stand between a "no" and what is said in place of something."""
_ASKING = frozenset("if unless when whether whenever once is are has have does do did 's".split())
_OBJECTS = frozenset("it them him her me us that this these those".split())
_OF_SOMEBODY = frozenset(("DT", "PRP$"))
_WORDLIKE = frozenset("VB VBP VBD VBN NN JJ RB".split())
"""Tags of a verb in its bare form behind a "no"."""


def second_thoughts(document: Document) -> Iterator[range]:
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
