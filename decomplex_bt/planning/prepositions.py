"""Prepositions: what leads a phrase ("on top of"), told from the rest of it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from decomplex_bt.domain.dialects import plain_words
from decomplex_bt.domain.loader import Domain


def split_preposition(text: str, domain: Domain) -> tuple[str, str]:
    """The preposition that leads a phrase ("" if none does) and the rest, in lower case."""
    words = normal_words(text)
    found = ""
    while (preposition := leading_preposition(words, domain)) and words != preposition:
        words = words[len(preposition) :].strip()
        found = found or preposition
        if preposition in domain.lexicon.beside:
            found = preposition
    return found, words


@lru_cache(maxsize=32)
def _prepositions(domain: Domain) -> Mapping[str, Sequence[str]]:
    """By the first word, the longest first."""
    found: dict[str, list[str]] = {}
    for preposition in sorted(domain.lexicon.prepositions, key=lambda words: (-len(words.split()), words)):
        found.setdefault(preposition.partition(" ")[0], []).append(preposition)
    return found


def leading_preposition(words: str, domain: Domain) -> str:
    """The longest preposition that words in lower case begin with; "" where they begin with none."""
    alike = _prepositions(domain).get(words.partition(" ")[0], ())
    return next((word for word in alike if words == word or words.startswith(word + " ")), "")


def normal_words(text: str) -> str:
    """The words in lower case, with plain apostrophes and single blanks, without marks but commas, "&" and hyphens; the
    plain words for those of dialects."""
    plain = text.lower().replace("\u2019", "'").replace("\u2018", "'")
    words = re.sub(r"[^\w\s',&-]", " ", plain).split()
    return " ".join(plain_words(words) or words).strip(" ,'-")
