"""Suggestions: what a word that names nothing may have been meant for."""

from __future__ import annotations

from collections.abc import Iterable

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import UnknownWordError
from decomplex_bt.planning.noun_phrase import unique


def unknown(words: str, domain: Domain) -> UnknownWordError:
    """The error for words that name nothing: the nearest are what the noun alone names, else words that look alike;
    where nothing does, it says what there is."""
    noun, known = _noun_of(words, domain)
    if known:
        return UnknownWordError(words, unique(tuple(_describe(name, domain) for name in known))[:4])
    alike = domain.nouns.nearest(noun) or domain.nouns.nearest(noun.rpartition(" ")[2])
    return UnknownWordError(words, alike, known=_nouns_of(domain.house.things, domain))


def as_expected(error: UnknownWordError, expected: str, among: Iterable[str], domain: Domain) -> UnknownWordError:
    """The error with what was expected in place of a thing, and where the noun names nothing, the nearest of that."""
    noun, known = _noun_of(error.phrase, domain)
    entities = tuple(among)
    choices = error.choices if known else domain.nouns.nearest(noun, entities)
    return UnknownWordError(error.phrase, choices, known=_nouns_of(entities, domain), expected=expected)


def _noun_of(words: str, domain: Domain) -> tuple[str, tuple[str, ...]]:
    """Words without those that do not say which one, and what the last of them name."""
    tokens = [token for token in words.split() if token not in domain.lexicon.determiners]
    found = (domain.nouns.lookup(" ".join(tokens[i:])) for i in range(len(tokens)))
    return " ".join(tokens) or words, next(((*names, *plurals) for names, plurals in found if names or plurals), ())


def _nouns_of(entities: Iterable[str], domain: Domain) -> tuple[str, ...]:
    """What entities are called, each word once: things by their nouns, all else by name."""
    things = domain.house.things
    return unique(tuple(domain.kind(e).words[0] if e in things else e.replace("_", " ") for e in entities))


def _describe(name: str, domain: Domain) -> str:
    """An entity as a person would say it, with its colour where it has one."""
    item = domain.house.things.get(name)
    noun = domain.kind(name).words[0] if item is not None else name.replace("_", " ")
    return f"{item.colour} {noun}" if item is not None and item.colour else noun
