"""Remarks: what is said in passing, of which nothing is to be done: that a choice is left ("I'm not fussy"), that
something is mostly so ("and it usually is", "which it does when it rains"), why ("for it is stiff"), what it is."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import ENDS, FINITE
from decomplex_bt.understanding.rules.speech.edits import MARKS, Said

_CHOICES = frozenset(
    tuple(remark.split())
    for remark in (
        "i 'm not fussy", "i 'm not fussed", "i 'm not bothered", "i 'm not picky", "i 'm not choosy", "i 'm easy",
        "i do n't mind", "i do n't care", "i do n't mind which", "i do n't mind either way", "no rush", "no hurry",
        "there 's no rush", "there 's no hurry", "it 's up to you", "up to you", "your choice", "not fussy",
        "not fussed", "not bothered", "whichever", "whatever",
    )
)  # fmt: skip
"""What is said to leave a choice or time."""
_CASES = frozenset("if when unless once should provided".split())
_BEFORE_CASES = MARKS | {":"} | frozenset("and but so or then now right well".split())
_OPENING = _CASES | {"whether", "is", "are", "that"}
_BEING = frozenset("is are was were 's 're".split())
_MOSTLY = frozenset("usually always generally normally often mostly probably typically sometimes likely".split())
_TAKING_UP = frozenset("it he she they there that".split())
_NAMING_AGAIN = frozenset("the my our his her their that those these this".split())
_NOMINAL = frozenset("DET NOUN PROPN ADJ NUM PRON PART ADV".split())
_LONGEST = 5
"""The most words in brackets that only name a thing again."""
_THINKING = frozenset("suspect think expect bet imagine fear hope guess suppose reckon believe".split())
_SAYING_SO = frozenset(
    "is are was were do does did has have will would may might can could 's 're 'll happens happen".split()
)
_TIMED = frozenset("if when whenever the every on in after before at as".split())
"""What a remark that something mostly is so may go on with."""


def remarks(said: Said) -> Iterator[range]:
    """Every remark, from the comma ahead of it up to the mark behind it."""
    words = said.words
    for i in (i for i in range(1, len(words) - 1) if words[i] == ","):
        stop = next((j for j in range(i + 1, len(words)) if words[j] in MARKS | ENDS), len(words))
        inner = range(i + 1, stop)
        is_choice = tuple(words[i + 1 : stop]) in _CHOICES
        if is_choice or (_is_within_case(said, i, stop) and (_says_mostly(said, inner) or _says_why(said, inner))):
            yield range(i, stop)


def bracketed(said: Said) -> Iterator[int]:
    """The words in brackets that only name a thing again ("the cup *(the blue one)* and the plate"), or the brackets
    around what is added to it ("the cup *(*and the plate*)*"); nothing of what is not meant."""
    words, tokens = said.words, said.document.tokens
    for i in (i for i in range(1, len(words) - 2) if words[i] == "(" and tokens[i - 1].pos in ("NOUN", "PROPN")):
        stop = next((j for j in range(i + 1, len(words)) if words[j] in (")", *ENDS)), len(words))
        inner = tokens[i + 1 : stop]
        is_named = 1 < len(inner) <= _LONGEST and stop < len(words) and words[stop] == ")"
        if not is_named or any(token.pos not in _NOMINAL for token in inner[1:]):
            continue
        if inner[0].lower in _NAMING_AGAIN:
            yield from range(i, stop + 1)
        elif inner[0].lower in ("and", "plus"):
            yield from (i, stop)


def described(said: Said) -> Iterator[int]:
    """The words that set a clause off from what it describes ahead of the verb of a case, of which a place is left and
    nothing else: "if the cup*, which is* on the table*,* is dirty"."""
    words, tokens = said.words, said.document.tokens
    for i in (i for i in range(1, len(words) - 3) if words[i] == "," and words[i + 1] in ("which", "who")):
        stop = next((j for j in range(i + 2, len(words) - 1) if words[j] in MARKS | ENDS), len(words))
        is_inner = stop < len(words) and words[stop] == "," and tokens[stop + 1].tag in FINITE
        if not is_inner or not _begins_case(said, i) or words[i + 2] not in _BEING:
            continue
        is_place = tokens[i + 3].pos == "ADP"
        yield from (*range(i, i + 3), stop) if is_place else range(i, stop + 1)
    for i in (i for i in range(2, len(words) - 4) if words[i] in ("that", "which", "who") and words[i + 1] in _BEING):
        stop = next((j for j in range(i + 2, len(words)) if words[j] in MARKS | ENDS), len(words))
        is_whole = any(token.tag in FINITE for token in tokens[i + 4 : stop])
        if tokens[i + 2].pos == "ADP" and is_whole and _begins_case(said, i):
            yield from (i, i + 1)  # "if the mug *that is* on the shelf is clean"


def _begins_case(said: Said, at: int) -> bool:
    """Whether nothing but the name of a thing stands between the word that opens a case and a mark."""
    tokens = said.document.tokens
    start = at
    while start and tokens[start - 1].pos in ("DET", "ADJ", "NOUN", "PROPN", "PRON", "NUM", "PART"):
        start -= 1
    return start < at and start > 0 and said.words[start - 1] in _OPENING


def _is_within_case(said: Said, start: int, stop: int) -> bool:
    """Whether a case is told ahead of a remark, behind no order, in whose sentence it goes on behind a comma."""
    sentences, words = said.document.sentences, said.words
    opening = next((i for i in range(start - 1, -1, -1) if words[i] in _CASES), start)
    is_ahead = opening < start and sentences[opening] == sentences[start]
    is_leading = opening == 0 or words[opening - 1] in _BEFORE_CASES or words[opening - 1] in ENDS
    return is_ahead and is_leading and stop < len(words) and words[stop] == ","


def _says_mostly(said: Said, inner: range) -> bool:
    """ "And it usually is", "which it does if it rains", "as it will be by then", "as I suspect it is"."""
    words = [said.words[i] for i in inner]
    if len(words) < 3 or words[0] not in ("and", "which", "as"):
        return False
    if words[0] == "which" and (words[1] in ("happens", "happen") or words[2:] in (["doubt"], ["hope"])):
        return True
    rest = [word for word in words[1:] if word not in _MOSTLY]
    if rest[:1] in (["i"], ["we"]) and not _THINKING.isdisjoint(rest[1:2]):
        rest = rest[2:]
    is_so = rest[:1] != [] and rest[0] in _TAKING_UP and len(rest) > 1 and rest[1] in _SAYING_SO
    is_mostly = len(rest) < len(words) - 1
    if words[0] == "and":
        return is_so and is_mostly
    tail = [word for word in rest[2:] if word not in ("be", "do")]
    return is_so and (words[0] == "which" or is_mostly or not tail or tail[0] in _TIMED)


def _says_why(said: Said, inner: range) -> bool:
    """ "For the hinges are stiff", not "for the guests", "for heaven's sake"."""
    tokens = [said.document.tokens[i] for i in inner]
    is_led = len(tokens) > 3 and tokens[0].lower == "for" and tokens[1].pos in ("DET", "PRON", "PROPN")
    is_led = is_led and tokens[3].lower != "sake"
    return is_led and any(token.tag in FINITE for token in tokens[2:])
