"""Verbs in running text: the lemma a form may belong to, and the particle that makes it another verb."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from decomplex_bt.domain.lexicon import Lexicon, VerbSense

_IRREGULAR = {
    **dict.fromkeys(("is", "are", "'s", "\u2019s", "'re", "was", "were", "been", "am"), "be"),
    **dict.fromkeys(("has", "had"), "have"),
    "lit": "light", "shut": "shut", "shutting": "shut", "put": "put", "putting": "put", "set": "set", "setting": "set",
    "cut": "cut", "cutting": "cut", "froze": "freeze", "frozen": "freeze", "drew": "draw", "drawn": "draw",
    "swept": "sweep", "does": "do", "went": "go", "gone": "go", "took": "take", "gave": "give", "brought": "bring",
    "left": "leave", "found": "find", "told": "tell", "said": "say", "made": "make", "blew": "blow",
}  # fmt: skip


def lemmas(form: str) -> Iterator[str]:
    """What a verb form (lower case) may be a form of, the form itself first."""
    yield form
    if form in _IRREGULAR:
        yield _IRREGULAR[form]
    for ending in ("ing", "ed", "es", "s"):
        if form.endswith(ending) and len(form) > len(ending) + 1:
            stem = form[: -len(ending)]
            yield stem
            yield stem + "e"
            if len(stem) > 2 and stem[-1] == stem[-2]:
                yield stem[:-1]
            if stem.endswith("i"):
                yield stem[:-1] + "y"


def sense_of(form: str, particles: Iterable[str], lexicon: Lexicon) -> VerbSense | None:
    """The sense of a verb form; with one of the particles if they make a verb, the first that does. None if unknown."""
    form = re.sub(r"[^\w'-]", "", form.lower())
    found: VerbSense | None = None
    for lemma in lemmas(form):
        for particle in particles:
            sense = lexicon.verbs.get(f"{lemma} {particle}")
            if sense is not None:
                return sense
        found = found or lexicon.verbs.get(lemma)
    return found
