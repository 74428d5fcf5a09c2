"""Precautions: what something is done against hangs on nothing: "bring me a torch *in case it's dark*"."""

from __future__ import annotations

from collections.abc import Mapping

from decomplex_bt.domain.clauses import AIR, WEATHER
from decomplex_bt.understanding.document import MARKS, Document

_TAKING_CARE = frozenset(
    "bring take put get fetch leave keep pack grab close shut lock have light turn switch set hang stay prepare".split()
)
"""What is done against something that may come."""
_BEING = frozenset("be 's 're have".split())
_SPEAKERS = frozenset(("i", "we"))
_BEFORE_CASES = MARKS | {"only", "but", "and", "or"}
_ENDS = MARKS | {"and", "but", "then"}


def precautions(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens of every "in case ..." right behind the words of an order that says what may happen, not how the thing
    is that is ordered about ("take them in in case they're dry"); `tasks`: tokens with types."""
    words = [token.lower for token in document.tokens]
    found: set[int] = set()
    for i, word in enumerate(words[:-2]):
        if word != "in" or words[i + 1] != "case" or words[i + 2] in ("of", "not"):
            continue
        start = i - (i > 0 and words[i - 1] == "just")
        sentence = document.sentences[i]
        ahead = [j for j in tasks if j < start and document.sentences[j] == sentence]
        stop = next((j for j in range(i + 2, len(words)) if words[j] in _ENDS), len(words))
        is_behind = start > 0 and bool(ahead) and (words[start - 1] not in _BEFORE_CASES or start < i)
        is_care = is_behind and document.tokens[max(ahead)].lemma in _TAKING_CARE
        if is_care and tasks[max(ahead)] != "check_state" and _may_happen(document, range(i + 2, stop)):
            found.update(range(start, stop))
    return frozenset(found)


def _may_happen(document: Document, clause: range) -> bool:
    """Whether a clause says what may come: not how somebody or something is, unless that is the weather."""
    tokens = document.tokens[clause.start : clause.stop]
    verb = next((t for t in tokens[1:] if t.tag in ("VBZ", "VBP", "MD") or t.lower in _BEING), None)
    if verb is None:
        return False
    is_state = verb.lemma in _BEING and tokens[0].lower not in _SPEAKERS
    return not is_state or not (WEATHER | AIR).isdisjoint(token.lower for token in tokens)
