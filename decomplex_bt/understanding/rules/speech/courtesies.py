"""Courtesies: cases that only ask politely ("if it's not too much trouble", "provided it isn't a bother"); an
instruction is read without them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.understanding.document import ENDS
from decomplex_bt.understanding.rules.speech.edits import MARKS, Said

_OPENERS = (
    ("if",), ("as", "long", "as"), ("so", "long", "as"), ("provided",), ("provided", "that"), ("providing",),
    ("providing", "that"), ("assuming",), ("assuming", "that"),
)  # fmt: skip
_SUBJECTS = frozenset(("it", "that", "this"))
_BEING = frozenset("is 's s be would wo was will".split())
_HEDGING = frozenset("too much very any a an no not n't nt of such terrible great big really just".split())
_DENYING = frozenset("no not n't nt".split())
_BURDENS = frozenset("trouble bother hassle imposition inconvenience nuisance fuss".split())
_FOR_WHOM = (("for", "you"), ("to", "you"), ("at", "all"))


def courtesies(said: Said) -> Iterator[range]:
    """Every courtesy with a comma ahead of it, or with the one behind it at the beginning of a sentence; where a real
    case is joined to one ("provided that *it's no trouble and that* there is a clean one"), what it takes to leave
    that."""
    words = said.words
    if _BURDENS.isdisjoint(words):
        return
    for i in range(len(words)):
        opener = max((o for o in _OPENERS if tuple(words[i : i + len(o)]) == o), key=len, default=())
        stop = _end(words, i + len(opener)) if opener else -1
        if stop < 0:
            continue
        if words[stop : stop + 1] == ["and"] and words[stop + 1 : stop + 2] == list(opener[-1:]):
            yield range(i + len(opener), stop + 2)
        elif stop == len(words) or words[stop] in MARKS | ENDS:
            is_first = i == 0 or words[i - 1] in ENDS
            is_parted = stop < len(words) and words[stop] in MARKS
            yield range(i - (i > 0 and words[i - 1] in MARKS), stop + (is_first and is_parted))
        elif i > 0:
            yield range(i - (words[i - 1] in MARKS), stop)


def _end(words: Sequence[str], start: int) -> int:
    """Where a clause ends that begins at a word and says of "it" that it is no burden; -1 where it says anything else
    ("if it's a nuisance")."""
    i = start + 1
    while i < len(words) and words[i] in _BEING | _HEDGING:
        i += 1
    inner = words[start:i]
    is_denied = not _DENYING.isdisjoint(inner[1:]) or "too" in inner
    if not (inner[:1] and inner[0] in _SUBJECTS and is_denied and words[i : i + 1] and words[i] in _BURDENS):
        return -1
    i += 1
    return i + 2 if tuple(words[i : i + 2]) in _FOR_WHOM else i
