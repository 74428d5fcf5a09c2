"""Skips: the verbs of the orders that are not to be done in a case ("if it's clean already, *skip the washing*")."""

from __future__ import annotations

from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.control_flow.stretch import PUNCTUATION
from decomplex_bt.understanding.cue_phrases import normal_form
from decomplex_bt.understanding.document import Document

_SKIPPING = tuple(
    tuple(phrase.split())
    for phrase in (
        "skip", "skipping", "skip out", "leave out", "leaving out", "omit", "omitting", "forgo", "no need for",
        "no need to", "there is no need to", "there is no need for", "do not", "dont", "do not bother",
        "do not bother to", "do not bother with", "dont bother", "dont bother to", "dont bother with", "need not",
        "need not bother", "do not need to", "do not have to", "forget", "forget about",
    )
)  # fmt: skip
"""What calls off the order whose verb is named next, in the normal form of cues, the longest that fits."""
_OPENERS = frozenset(("if", "when"))
_AHEAD = frozenset("then just please you can may could so still".split())
_NAMING = frozenset("the that this all your my our".split())
_LONGEST = 4
"""The most words from the verb on to the end: "washing *it again then*"."""


def skipped(document: Document, previous: int, token: int, following: int) -> frozenset[str]:
    """The lemmas of the verb of which the words around a case say that it is not to be done in that: those behind its
    mark ("if it's damp *don't iron it*" needs none), up to the next task, or those between the task before and an "if"
    ("*Skip the ironing* if it's damp"); empty where there are none or they say more."""
    tokens, sentences = document.tokens, document.sentences
    words = [normal_form(t.lower) for t in tokens]
    opener = next((i for i in range(token - 1, previous, -1) if words[i] in _OPENERS), None)
    if opener is None or sentences[opener] != sentences[token]:
        return frozenset()
    stop = next((i for i in range(token, following) if sentences[i] != sentences[token]), following)
    marks = (i for i in range(token, stop) if words[i] in PUNCTUATION)
    unmarked = (i - 1 for i in range(token + 1, stop) if words[i : i + 2] == ["do", "not"] or words[i] == "dont")
    behind = words[min(next(marks, stop), next(unmarked, stop)) + 1 : stop]
    behind = behind[: next((n for n, word in enumerate(behind) if word in PUNCTUATION), len(behind))]
    start = next((i + 1 for i in range(opener - 1, previous, -1) if words[i] in PUNCTUATION | {"but", "and"}), None)
    return _named(behind) or (frozenset() if start is None else _named(words[start:opener]))


def _named(said: list[str]) -> frozenset[str]:
    while said[:1] and said[0] in _AHEAD:
        said = said[1:]
    phrase = max((p for p in _SKIPPING if tuple(said[: len(p)]) == p), key=len, default=())
    rest = said[len(phrase) :]
    if rest[:1] and rest[0] in _NAMING:
        rest = rest[1:]
    return frozenset(lemmas(rest[0])) if phrase and 0 < len(rest) <= _LONGEST else frozenset()
