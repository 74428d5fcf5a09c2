"""Spelling: which word was meant where a finger slipped ("brign me teh mug").

Only words that nobody knows, neither the training corpus nor the lemmatiser's dictionary, and only into frequent ones
that are one slip away (a letter swapped with the next, left out, doubled or mistaken). What is meant is read; spans and
values keep what was typed.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Sequence
from functools import cached_property
from pathlib import Path

from decomplex_bt.domain.dialects import plain_words
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.document import ENDS, Document
from decomplex_bt.understanding.rules.speech.turns_of_phrase import plain_phrases

WORDS_FILE = "words.json"
FREQUENT = 20
"""How often a word must stand in the training corpus that a slip is taken for."""
KNOWN = 3
"""How often a word must stand there to be one, since typing slips are part of the corpus."""
SHORTEST = 3
"""Shorter words are left alone: too many others are a slip away."""
_SWAPPED = 5
"""In words shorter than that only swapped letters are a slip."""
_SAFE_START = 6
"""From this length on a slip may be in the first letter."""
_SOUNDS = frozenset("umm ummm uhm uhh hmm hmmm mmm erm ahh ohh aww shh".split())
_ENDINGS = (("s", ""), ("es", ""), ("d", ""), ("ed", ""), ("ing", ""), ("ing", "e"), ("r", ""), ("er", ""), ("ly", ""))

Lemmas = Callable[[], Collection[str]]
"""Gives the words of a dictionary, when they are needed."""


class Speller:
    """What was meant by mistyped words, from the words of the training corpus with their counts in `words.json`.

    Raises `DataFileError` where the file cannot be read.
    """

    def __init__(self, path: Path) -> None:
        try:
            self._counts: dict[str, int] = {
                str(w): int(n) for w, n in json.loads(path.read_text(encoding="utf-8")).items()
            }
        except (OSError, ValueError, AttributeError, TypeError) as error:
            raise ModelError(path, f"no counts of words ({type(error).__name__})") from None

    def meant(self, words: Sequence[str], lemmas: Lemmas) -> list[str] | None:
        """The words as they were meant, one for one; None where all are plain words, none mistyped. A name is a word
        with a capital that begins no sentence."""
        found = plain_words(words)
        found = plain_phrases(found or words) or found
        words = found or words
        for i, word in enumerate(words):
            lower = word.lower()
            if (
                lower in self._counts
                or len(word) < SHORTEST
                or not word.isalpha()
                or not word.isascii()
                or lower in _SOUNDS
            ):
                continue
            is_first = i == 0 or words[i - 1] in ENDS or words[i - 1].isspace()
            if (word[0].isupper() and not word.isupper() and not is_first) or self._is_form(lower, lemmas()):
                continue
            other = self._nearest(lower)
            if other is not None:
                found = found or list(words)
                found[i] = other.capitalize() if word[0].isupper() else other
        return found

    def _is_form(self, word: str, lemmas: Collection[str]) -> bool:
        """Whether a word is a lemma, or a regular form of one or of a word of the corpus."""
        stems = [word]
        for ending, other in _ENDINGS:
            if word.endswith(ending):
                stem = word[: -len(ending)]
                stems += [stem + other, stem[:-1] if stem[-1:] == stem[-2:-1] else f"{stem[:-1]}y"]
        return any(stem in lemmas or stem in self._counts for stem in stems)

    def _nearest(self, word: str) -> str | None:
        from rapidfuzz.distance import OSA

        lengths = (len(word),) if len(word) < _SWAPPED else range(len(word) - 1, len(word) + 2)
        slips = [
            other
            for length in lengths
            for other in self._frequent.get(length, ())
            if (other[0] == word[0] or other[:2] == word[1::-1] or len(word) >= _SAFE_START)
            and OSA.distance(word, other, score_cutoff=1) <= 1
            and (len(word) >= _SWAPPED or sorted(word) == sorted(other))
        ]
        return max(slips, key=lambda other: (self._counts[other], other), default=None)

    @cached_property
    def _frequent(self) -> dict[int, list[str]]:
        """The frequent words by their length."""
        by_length: dict[int, list[str]] = {}
        for word, count in self._counts.items():
            if count >= FREQUENT and len(word) > 1:
                by_length.setdefault(len(word), []).append(word)
        return by_length


def write_words(path: Path, documents: Iterable[Document]) -> None:
    """Counts the words of documents, and writes those that stand there often enough to `path`."""
    counts = Counter(token.lower for document in documents for token in document.tokens if token.lower.isalpha())
    known = {word: count for word, count in sorted(counts.items()) if count >= KNOWN}
    path.write_text(json.dumps(known, indent=0, ensure_ascii=False) + "\n", encoding="utf-8")
