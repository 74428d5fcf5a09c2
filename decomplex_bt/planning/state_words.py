"""State words: the state of a thing that words name ("still hot", "switched off")."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.prepositions import normal_words


def read_state(text: str, pairs: Iterable[str], domain: Domain) -> tuple[str, str] | None:
    """State pair and value that words such as "still hot" name, of these pairs; None if they name none."""
    words = normal_words(text).split()
    for start in range(len(words)):
        for end in range(len(words), start, -1):
            phrase = " ".join(words[start:end])
            for pair in pairs:
                for value, names in _state_words(domain)[pair].items():
                    if phrase in names:
                        return pair, value
    return None


@lru_cache(maxsize=32)
def _state_words(domain: Domain) -> dict[str, dict[str, frozenset[str]]]:
    return {
        name: {value: frozenset((value, *pair.words.get(value, ()))) for value in pair.values}
        for name, pair in domain.kinds.state_pairs.items()
    }
