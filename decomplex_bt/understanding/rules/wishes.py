"""Wishes: what somebody would like to have, where the request right behind asks for the same."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, takewhile

from decomplex_bt.understanding.document import ENDS, Document, Token

_WISHING = frozenset("like want need love fancy".split())
_BEFORE_WISHES = frozenset("'d \u2019d would do really just rather could so".split())
_CASES = frozenset("if unless otherwise or else when once whether then also after before".split())
_SPEAKERS = frozenset(("me", "us"))
_MORE = frozenset(("too", "also", "well", "another"))
_PRONOUNS = frozenset("some one it them that those any".split())
_PHRASE = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN"))
_CLAUSE_ENDS = ENDS | frozenset((",", ":", "and", "or", "but"))


def is_served(document: Document, wish: int, request: int) -> bool:
    """Whether the verb at token `wish` only tells what the one at token `request`, the next task, is to bring: "I'd
    like some tea, can you get me some?". Not what somebody else is to have, another thing, or a case."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[wish].lemma not in _WISHING or sentences[request] > sentences[wish] + 1 or not _is_own(document, wish):
        return False
    wished = tokens[wish + 1 : request]
    goes_on = any(one.lower == "and" and two.pos not in _PHRASE for one, two in pairwise(wished))
    if goes_on or any(token.lower in _CASES for token in wished):
        return False
    asked = list(takewhile(lambda token: token.lower not in _CLAUSE_ENDS, tokens[request + 1 :]))
    is_for_another = any(one.lower in ("to", "for") and two.lower not in _SPEAKERS for one, two in pairwise(asked))
    return not is_for_another and _MORE.isdisjoint(token.lower for token in asked) and _is_same(wished, asked)


def _is_own(document: Document, wish: int) -> bool:
    """Whether it is the speaker who wishes: not "my son would like"."""
    i = wish - 1
    while i > 0 and document.tokens[i].lower in _BEFORE_WISHES:
        i -= 1
    is_near = i >= 0 and document.sentences[i] == document.sentences[wish]
    return is_near and document.tokens[i].lower in ("i", "we")


def _is_same(wished: Sequence[Token], asked: Sequence[Token]) -> bool:
    """Whether what is asked for is a pronoun, or names the same thing with no other adjective."""
    asked = [token for token in asked if token.lower not in _SPEAKERS and token.tag != "RP"]
    if asked and asked[0].lower in _PRONOUNS and (len(asked) == 1 or asked[1].pos not in _PHRASE):
        return len(asked) == 1 or asked[1].lower != "of"
    first, second = _phrase(wished), _phrase(asked)
    nouns = [[token.lemma for token in phrase if token.pos in ("NOUN", "PROPN")][-1:] for phrase in (first, second)]
    adjectives = [{token.lemma for token in phrase if token.pos == "ADJ"} for phrase in (first, second)]
    return bool(nouns[0]) and nouns[0] == nouns[1] and adjectives[1] <= adjectives[0]


def _phrase(tokens: Sequence[Token]) -> list[Token]:
    """The noun phrase that words begin with."""
    return list(takewhile(lambda token: token.pos in _PHRASE or token.lower in _PRONOUNS, tokens))
