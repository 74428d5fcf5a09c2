"""Hesitation: the "um" of speech, and phrases without it."""

from __future__ import annotations

import re

from decomplex_bt.phrases import PREPOSITIONS

HESITATING = frozenset("um umm uhm uh uhh er erm ehm hmm".split())
"""Lower case: "Umm Khalid" and "the ER" are names."""
_SOUND = rf"(?:{'|'.join(sorted(HESITATING))})"
_HESITATION = re.compile(
    rf"(?P<mark>,\s*)?(?<![\w'’-]){_SOUND}(?:[,\s]+{_SOUND})*(?![\w'’-])(?P<behind>,?\s*)(?P<word>\w*)"
)


def without_hesitation(words: str) -> str:
    """A phrase without the "um" in it and the commas that set it off: "on his way uh, home". Of two commas one stays
    ("the mug, uh, plate and fork"), but ahead of a preposition ("the pan, um, on the stove")."""
    return _HESITATION.sub(_what_stays, words).strip() or words


def _what_stays(found: re.Match[str]) -> str:
    word = found["word"]
    if not word:
        return found["behind"].strip(", ")
    mark = "" if found["mark"] is None else " " if word.lower() in PREPOSITIONS else ", "
    return mark + word
