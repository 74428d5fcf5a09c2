"""Compounds: last nouns of two that the tagger takes for an adjective or a verb ("the towel *warmer* is on")."""

from __future__ import annotations

from decomplex_bt.understanding.document import FINITE, MARKS, Document

AT = frozenset("in on at under underneath behind beside near above below inside".split())
"""What stands before the place where something is."""
_FINDING = frozenset(("find", "locate"))
_SEEING = frozenset(("see", "spot", "notice", "spy"))
_ANYWHERE = frozenset(("anywhere", "somewhere"))
_PLACED = frozenset("hanging lying sitting standing leaning".split())
_COMING = frozenset("'ll will".split())
_OPENING = frozenset("if unless when once after before until".split())
_NEAR = 5
"""Within so many words ahead of its verb a case is opened [tokens]."""
_AT_OR_BY = AT | {"by", "between"}


def ends_compound(document: Document, at: int) -> bool:
    """Whether a word right behind a noun can be but a noun itself, whatever its tag."""
    tokens = document.tokens
    if not 0 < at < len(tokens) or tokens[at - 1].tag not in ("NN", "NNP"):
        return False
    return _is_spoken_of(document, at) or _is_found(document, at)


def _is_spoken_of(document: Document, at: int) -> bool:
    """Whether a comparative is what a verb tells of, which only a noun can be: "the towel *warmer* is on"."""
    behind = document.tokens[at + 1 : at + 2]
    return document.tokens[at].tag == "JJR" and any(token.tag in FINITE for token in behind)


def _is_found(document: Document, at: int) -> bool:
    """Whether a bare verb is no deed of what somebody finds or sees: nothing is found to do anything ("can't find the
    dog *lead*"), and who is seen to do something does it neither "anywhere" nor lying somewhere ("you'll see the cheese
    *press* standing on the shelf")."""
    tokens = document.tokens
    token, lemma = tokens[at], tokens[tokens[at].head].lemma
    if token.tag not in ("VB", "VBP") or token.dep != "ccomp" or token.head > at:
        return False
    behind = [following.lower for following in tokens[at + 1 : at + 3]] or ["."]
    if lemma in _FINDING:
        is_to_come = token.head > 0 and tokens[token.head - 1].lower in _COMING and behind[0] in _AT_OR_BY
        return is_to_come or behind[0] in _ANYWHERE or (behind[0] in MARKS and not _is_in_case(document, token.head))
    is_placed = behind[0] in _PLACED and behind[-1] in _AT_OR_BY
    return lemma in _SEEING and (is_placed or behind[0] in _ANYWHERE)


def _is_in_case(document: Document, verb: int) -> bool:
    """Whether a verb is said of a case, behind which comes an order: "if you can't find the mop *wait*"."""
    return any(token.lower in _OPENING for token in document.tokens[max(0, verb - _NEAR) : verb])
