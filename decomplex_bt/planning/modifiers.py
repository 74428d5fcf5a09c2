"""Modifiers: what the words before a noun ask of it, its number, colour, state or room."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.abilities import states_of
from decomplex_bt.planning.noun_phrase import NounPhrase
from decomplex_bt.planning.state_words import read_state

DEFINITE = frozenset("the my our your his her its their these those".split())
"""First words of a phrase that speaks of a certain one."""
PICKS = frozenset("some any no none one either neither another".split())
"""Words that pick from what they stand before ("any of the books"): not all of them, and no certain one."""
_HEDGES = PICKS | frozenset(("a", "an", "more", "other"))
_OTHER = frozenset("other others another different remaining".split())
"""Words for those that were not named before ("the other mug")."""


def modified(phrase: NounPhrase, before: list[str], domain: Domain) -> NounPhrase | None:
    """The phrase with the words before its noun taken in; None if one of them is not known."""
    lexicon, wanted, colours = domain.lexicon, list(phrase.wanted), set[str]()
    is_all, count, rooms = False, read_number(before, domain), set[str]()
    i = 0
    while i < len(before):
        word = before[i]
        room, length = _room_at(before, i, domain)
        state = None if word in lexicon.prepositions else read_state(word, domain.kinds.state_pairs, domain)
        if word in lexicon.all_words or word == "both":
            is_all = True
        elif word in lexicon.colours:
            colours.add(word)
        elif state is not None:
            wanted.append(state)
        elif room:
            rooms.add(room)
        elif not (word in _HEDGES or word in lexicon.determiners or word in lexicon.measures or word.isdigit()):
            return None
        i += length
    is_hedged = any(word in _HEDGES for word in before)
    is_definite = any(word in DEFINITE for word in before) or not is_hedged

    def fits(entity: str) -> bool:
        return has_colour(entity, colours, domain) and (not rooms or domain.room_of(entity) in rooms)

    phrase = replace(
        phrase,
        entities=tuple(filter(fits, phrase.entities)),
        plurals=tuple(filter(fits, phrase.plurals)),
        is_all=is_all,
        is_definite=is_definite and count is None,
        count=count or 1,
        wanted=tuple(dict.fromkeys(wanted)),
        is_other=says_other(before, domain),
    )
    return of_kind(phrase, domain) if phrase.entities or phrase.plurals else None


def of_kind(phrase: NounPhrase, domain: Domain) -> NounPhrase:
    """The phrase as a plural, where its noun is one and the name of something else as well ("glasses"), and it speaks
    of more than that has, or of a state that nothing of that name can be in."""
    if not phrase.entities or not phrase.plurals:
        return phrase
    pairs = {pair for pair, _ in phrase.wanted}
    is_of_several = phrase.is_all or phrase.count > 1
    is_too_few = is_of_several and len(phrase.entities) < max(2, phrase.count)
    is_stateless = not any(pairs.issubset(states_of(name, domain)) for name in phrase.entities)
    if not is_too_few and not (is_stateless and any(pairs.issubset(states_of(n, domain)) for n in phrase.plurals)):
        return phrase
    also = domain.nouns.lookup(phrase.noun)[1]
    plurals = (*(name for name in phrase.entities if name in also), *phrase.plurals)
    return replace(phrase, entities=(), plurals=plurals)


def read_number(words: list[str], domain: Domain) -> int | None:
    """The number that the first of the words that is one tells; None where none is."""
    for word in words:
        if word.isdigit():
            return int(word)
        if domain.lexicon.measures.get(word, 1) > 1:
            return domain.lexicon.measures[word]
    return None


def says_other(words: list[str], domain: Domain) -> bool:
    """Whether words before a noun speak of others than before: "the other", "one more" (but not "some more")."""
    is_more = any(
        (word == "more" and _counts(before, domain)) or (before, word) == ("a", "second")
        for before, word in pairwise(words)
    )
    return is_more or not _OTHER.isdisjoint(words)


def is_bare_other(said: str, domain: Domain) -> bool:
    """Whether words speak of the other of some and not of how it is: that of "the clean mug" need not be clean."""
    words = said.split()
    return "other" in words and read_state(said, domain.kinds.state_pairs, domain) is None


def _counts(word: str, domain: Domain) -> bool:
    return word == "one" or read_number([word], domain) is not None


def one_more(number: str, domain: Domain) -> str:
    """What "more than one" is at least; the words as they are where it is no number."""
    count = int(number) if number.isdigit() else domain.lexicon.measures.get(number)
    return f"more than {number}" if count is None else str(count + 1)


def _room_at(words: list[str], start: int, domain: Domain) -> tuple[str | None, int]:
    """The room that one or two words name, and how many words that are."""
    for length in (2, 1):
        phrase = " ".join(words[start : start + length])
        room = next((name for name in domain.nouns.lookup(phrase)[0] if name in domain.house.rooms), None)
        if room is not None and start + length <= len(words):
            return room, length
    return None, 1


def has_colour(entity: str, colours: set[str], domain: Domain) -> bool:
    """Whether an entity can be called by these colours: a thing whose colour is not given can by any."""
    if not colours:
        return True
    item = domain.house.things.get(entity)
    return item is not None and (item.colour is None or item.colour in colours)
