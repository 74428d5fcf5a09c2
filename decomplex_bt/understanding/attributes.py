"""What spaCy's attribute ruler matches, looked up instead of tried again: its 180 patterns on every token are a fifth
of what parsing costs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

READ = ("LOWER", "TAG", "DEP", "IS_SPACE")
"""What is known of a token; its word only where some pattern has it."""


class KnownMatches:
    """Stands in for the matcher of an attribute ruler and finds the same: at tokens that are alike in all of `READ`
    whatever it found before. Only patterns that look at more, or at several tokens, are tried each time."""

    def __init__(self, ruler: Any) -> None:
        from spacy.matcher import Matcher

        self._matcher = ruler.matcher
        self._others: Any = Matcher(ruler.vocab)
        self._words: set[int] = set()
        self._found: dict[tuple[int, ...], tuple[int, ...]] = {}
        for number, rule in enumerate(ruler.patterns):
            if not all(len(pattern) == 1 and _is_known_by_words(pattern[0]) for pattern in rule["patterns"]):
                self._others.add(str(number), rule["patterns"])
                continue
            for words in (pattern[0].get("LOWER", {"IN": ()}) for pattern in rule["patterns"]):
                self._words.update(map(ruler.vocab.strings.add, [words] if isinstance(words, str) else words["IN"]))

    def __call__(self, doc: Any, **options: Any) -> list[tuple[int, int, int]]:
        """All matches in a document: pattern, first token, token behind the last."""
        keys = [(word if word in self._words else 0, *rest) for word, *rest in doc.to_array(READ).tolist()]
        if all(key in self._found for key in keys):
            found = [(pattern, i, i + 1) for i, key in enumerate(keys) for pattern in self._found[key]]
            return [*found, *self._others(doc, **options)]
        matches: list[tuple[int, int, int]] = self._matcher(doc, **options)
        at: list[list[int]] = [[] for _ in keys]
        for pattern, start, _ in matches:
            if pattern not in self._others:
                at[start].append(pattern)
        self._found.update(zip(keys, map(tuple, at), strict=True))
        return matches


def _is_known_by_words(token: Mapping[str, Any]) -> bool:
    """Whether a pattern's token looks at nothing but what is known, and names its words one by one."""
    words = token.get("LOWER", "")
    return token.keys() <= set(READ) and (isinstance(words, str) or words.keys() == {"IN"})
