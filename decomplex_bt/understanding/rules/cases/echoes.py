"""Echoes: cases behind a verb of telling that only take up the one before, and are no message ("bring it in if it has
come and tell me *if it hasn't*", "if he isn't up, wake him and text me *when he is*", "close it if you can and let me
know *if you can't*"), that the listener fails in what was ordered before ("look for my ring and ask Tom *if you don't
find it*"), and that something happens for which somebody is called ("shout *if the pan boils over*")."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks

_SUBJECTS = frozenset("it he she they we there you i that those these".split())
_TYPED = frozenset("isnt arent wasnt hasnt havent doesnt dont didnt cant couldnt".split())
_DENYING = frozenset("not n't nt".split())
_ABLE = frozenset("ca can cannot could cant couldnt".split())
_UNDOING = _ABLE | frozenset("do did have dont didnt havent".split())
_BETWEEN = frozenset("me us him her them know".split())
_NAMING = frozenset(("DET", "NOUN", "PROPN"))
_ENDS = MARKS | {"and", "but", "then", "or"}
_OPENING = frozenset("if unless when whether".split())
_SUMMONING = frozenset("call ring phone buzz page shout holler yell".split())
"""Verbs of telling by which somebody is made to come, or told something else than that a case is so."""
_CALLING = _SUMMONING | frozenset(("text", "message", "ping"))
"""Verbs of telling by which somebody is told, with a "when" behind, that it is so then, and not asked when it is."""
_ASKING = frozenset(("check_state", "searching"))


class Echo(NamedTuple):
    """Its words behind the "if", and its verb; `asks`: whether that is a check, not whether the listener is able, or
    does something."""

    tokens: range
    verb: int
    asks: bool


def echoes(document: Document, tasks: Mapping[int, str]) -> dict[int, Echo]:
    """By the verb of telling the case behind it that takes up an earlier one, or that somebody is to be called for when
    it comes ("shout if *the pan boils over*"); `tasks`: tokens with types."""
    tokens = document.tokens
    found: dict[int, Echo] = {}
    if document.words.isdisjoint(_OPENING | {"when"}):
        return found
    for i, token in enumerate(tokens[:-2]):
        telling = _telling(document, tasks, i) if token.lower in ("if", "when") else None
        if telling is None or (token.lower == "when" and tokens[telling].lemma not in _CALLING):
            continue
        event = _event(document, i) if tokens[telling].lemma in _SUMMONING else None
        if event is not None:
            found[telling] = event
            continue
        failure = _failure(document, i)
        if failure is not None and any(j < telling for j in tasks):
            found[telling] = failure
            continue
        echo = _echo(document, i)
        if echo is None:
            continue
        first = next((t.i for t in tokens[:telling] if t.lower in _OPENING and _is_near(document, t.i, i)), telling)
        is_asked = any(tasks.get(j) in _ASKING for j in range(telling)) or not echo.asks
        if first < telling and is_asked:
            found[telling] = echo
    return found


def _is_near(document: Document, one: int, other: int) -> bool:
    return document.sentences[other] - document.sentences[one] in (0, 1)


def _echo(document: Document, opening: int) -> Echo | None:
    """The case that an "if" or "when" opens, where it is no more than a pronoun and "isn't", "has", "can't" or the
    like."""
    tokens, end = document.tokens, opening + 1
    while end < len(tokens) and tokens[end].lower not in _ENDS and end - opening < 5:
        end += 1
    words = [token.lower for token in tokens[opening + 1 : end]]
    if len(words) not in (2, 3) or words[0] not in _SUBJECTS or (len(words) == 3 and words[2] not in _DENYING):
        return None
    verb = tokens[opening + 2]
    is_auxiliary = verb.lemma in ("be", "have", "do", "'s", "can", "could") or verb.lower in _ABLE | _TYPED
    if not is_auxiliary or (words[0] in ("you", "i") and verb.lower not in _ABLE | {"do", "dont"}):
        return None
    return Echo(range(opening, end), opening + 2, verb.lower not in _ABLE and words[0] != "you")


def _event(document: Document, opening: int) -> Echo | None:
    """The case that an "if" opens, where it is that somebody or something does something."""
    tokens = document.tokens
    end = next((t.i for t in tokens[opening:] if t.lower in _ENDS), len(tokens))
    named = next((chunk for chunk in noun_chunks(document) if chunk.start == opening + 1), range(0))
    verb = named.stop if named else opening + 2
    is_known = bool(named) or (verb < end and tokens[opening + 1].lower in _SUBJECTS - {"you", "i", "we", "there"})
    is_event = is_known and verb < end and tokens[verb].tag == "VBZ" and tokens[verb].pos == "VERB"
    return Echo(range(opening, end), verb, asks=True) if is_event and tokens[opening].lower == "if" else None


def _failure(document: Document, opening: int) -> Echo | None:
    """The case that an "if" opens, where it is that the listener does not do, or cannot do, something: "if you don't
    find it", "if you can't manage"."""
    tokens = document.tokens
    end = next((t.i for t in tokens[opening:] if t.lower in _ENDS), len(tokens))
    words = [token.lower for token in tokens[opening + 1 : end]]
    is_denied = words[2:3] != [] and (words[2] in _DENYING or words[1] in _TYPED | {"cannot"})
    is_failing = words[:3] == ["you", "fail", "to"] or (is_denied and tokens[opening + 2].lower in _UNDOING)
    verb = next((t.i for t in tokens[opening + 3 : end] if t.tag in ("VB", "VBN")), opening + 2)
    return Echo(range(opening, end), verb, asks=False) if words[:1] == ["you"] and is_failing else None


def _telling(document: Document, tasks: Mapping[int, str], opening: int) -> int | None:
    """The verb of telling right ahead of an "if", with nobody but the one who is told in between."""
    i = opening - 1
    while i >= 0 and i not in tasks and (document.tokens[i].lower in _BETWEEN or document.tokens[i].pos in _NAMING):
        i -= 1
    return i if i >= 0 and tasks.get(i) == "informing" else None
