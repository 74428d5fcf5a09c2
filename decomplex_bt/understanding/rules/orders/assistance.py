"""Assistance: to give somebody a hand is nothing that is carried ("give Pia *a hand* with the crates"), and who is
helped somewhere is gone with ("*help* Pia down the ladder", "*help* her up")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_GIVING = frozenset(("give", "lend", "gimme"))
_NAMING = frozenset(("DET", "PRON", "ADJ", "NOUN", "PROPN"))
_WHOM = frozenset("me us him her them".split())
_AHEAD = MARKS | frozenset(("and", "then", "please", "just"))
_WAYS = frozenset("up down along across over through off".split())
_GOALS = frozenset("to into onto inside outside upstairs downstairs".split())
_ENDS = MARKS | frozenset("and or but then if unless when before after please".split())
_HAND = (("a", "hand"), ("a", "helping", "hand"))


def helping_hands(document: Document) -> Iterator[range]:
    """The words of every order to give somebody a hand, the verb first, with what that is for: not "give her a hand
    towel"."""
    if "hand" not in document.words:
        return
    words = [token.lower for token in document.tokens]
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    for verb in (i for i, word in enumerate(words) if word in _GIVING):
        start = verb + 1 if words[verb] == "gimme" else stops.get(verb + 1, verb + 1)
        start = verb + 2 if words[verb + 1 : verb + 2] and words[verb + 1] in _WHOM else start
        for hand in _HAND:
            stop = start + len(hand)
            if tuple(words[start:stop]) == hand and not _goes_on(document, stop):
                yield range(verb, stops.get(stop + 1, stop) if words[stop : stop + 1] == ["with"] else stop)


def _goes_on(document: Document, i: int) -> bool:
    """Whether a hand is but part of what is given: "a hand *towel*", "a hand *of* bananas"."""
    token = document.tokens[i] if i < len(document) else None
    return token is not None and (token.tag in ("NN", "NNS") or token.lower == "of")


def helps_somewhere(document: Document) -> Iterator[int]:
    """The verb of every order to help somebody somewhere: not "help Pia with the crates", "help her to fold them"."""
    return (token.i for token in document.tokens if token.lower == "help" and _helped(document, token.i))


def with_helped(document: Document, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments with who is helped somewhere as who is gone with, and the way or the goal behind that."""
    found = _helped(document, verb)
    if not found:
        return list(arguments)
    words = {i for told in found.values() for i in told}
    kept = [a for a in arguments if words.isdisjoint(a.tokens)]
    return [*kept, *(FoundArgument(name, verb, told, CERTAIN) for name, told in found.items())]


def _helped(document: Document, verb: int) -> dict[str, range]:
    """Who is helped somewhere at a verb, and where, as arguments; empty for any other verb."""
    tokens, first = document.tokens, verb + 1
    is_order = tokens[verb].lower == "help" and (verb == 0 or tokens[verb - 1].lower in _AHEAD)
    if not is_order or first + 1 >= len(tokens):
        return {}
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    is_named = tokens[first].lower in _WHOM | PERSON_NOUNS or tokens[first].text[0].isupper()
    stop = first + 1 if is_named else next((i for i in range(first, len(tokens)) if tokens[i].pos not in _NAMING), 0)
    is_somebody = is_named or tokens[stop - 1].lemma in PERSON_NOUNS
    if not is_somebody or not first < stop < len(tokens) or tokens[stop].lower not in _WAYS | _GOALS:
        return {}
    whom, end = {"object": range(first, stop)}, stops.get(stop + 1, 0)
    kind = "path" if tokens[stop].lower in _WAYS else "goal"
    if end:
        return {**whom, kind: range(stop, end)}
    is_end = stop + 1 == len(tokens) or tokens[stop + 1].lower in _ENDS
    return (whom if kind == "path" else {**whom, kind: range(stop, stop + 1)}) if is_end else {}
