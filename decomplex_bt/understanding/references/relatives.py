"""Relatives: the words that only tell which thing is meant ("every lamp *that is on*", "*whichever window is open*")
and which is not ("all the lamps *but the one in the hall*")."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.document import MARKS, Document, Token

_RELATIVES = frozenset(("that", "which", "who"))
_FINDING = frozenset(("find", "take", "get", "leave", "put"))
"""What is told of a place behind "where you"."""
BE = frozenset("is are was were be 's 're s re".split())
_ANTECEDENTS = frozenset("one ones those any all some both everything anything everyone anyone".split())
_NOUNS = frozenset(("NOUN", "PROPN"))
ADVERBS = frozenset("still already now currently all both not n't yet left only just really".split())
_FREE = frozenset(("whichever", "whatever"))
WHATEVER = frozenset(("what", "whatever"))
_WHERE = frozenset("in on at by under behind beside inside near over above below left lying".split())
_PREDICATES = frozenset(("ADJ", "ADV", "VERB", "ADP"))
LONGEST_SUBJECT = 6
"""The most words of which a "whichever" asks before its verb ("whichever of the two mugs is clean")."""
WHOLE = frozenset("every all any each no everything anything everyone everybody everywhere anywhere both".split())
_OF_WHOLE = frozenset((("but",), ("save",)))
"""What leaves something out only behind a phrase of all things."""
_BEFORE_PLACES = frozenset((("but",), ("but", "not"), ("except",)))
_IN = frozenset("in on at".split())
_EXCEPTING = tuple(
    tuple(phrase.split())
    for phrase in (
        "except for", "except", "excepting", "excluding", "apart from", "aside from", "other than", "save for",
        "with the exception of", "but not", "but for", "but", "save",
    )
)  # fmt: skip
_FIRST_EXCEPTING = frozenset(first for first, *_ in _EXCEPTING)
_NOMINAL = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN"))
_JOINTS = frozenset(("and", "or", "but", "then", "so", "please", "if", "unless", "when", "before", "after", "until"))
_POINTING = frozenset(("that", "this", "which", "all"))


def clauses(document: Document) -> Iterator[range]:
    """The tokens of every relative clause that tells a state, from its pronoun to the word of the state: "that is
    still on"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-2]):
        if token.lower not in _RELATIVES or tokens[i + 1].lower not in BE or not _has_antecedent(document, i):
            continue
        state = _predicate(document, i + 2)
        if state is not None:
            yield range(i, state + 1)


def _has_antecedent(document: Document, relative: int) -> bool:
    """Whether a noun stands before a "that": "the lamp that is on", but not "turn on that"."""
    before = relative - 1
    while before > 0 and document.tokens[before].lower in (",", "on", "off"):  # "turn the lamp off that is on"
        before -= 1
    return before >= 0 and (
        document.tokens[before].pos in _NOUNS or document.tokens[before].lower in _ANTECEDENTS - {"all"}
    )


def _predicate(document: Document, start: int) -> int | None:
    """The word of the state that begins at a token, behind adverbs; of "switched on" the last."""
    tokens = document.tokens
    at = start
    while at < len(tokens) and (tokens[at].lower in ADVERBS or (tokens[at].tag == "RB" and _goes_on(tokens, at))):
        at += 1
    if at >= len(tokens) or tokens[at].pos not in _PREDICATES:
        return None
    return at + 1 if tokens[at].tag == "VBN" and tokens[at + 1 : at + 2] and tokens[at + 1].tag == "RP" else at


def _goes_on(tokens: Sequence[Token], at: int) -> bool:
    return at + 1 < len(tokens) and tokens[at + 1].pos in ("ADJ", "VERB")


def free_relatives(document: Document, tasks: Collection[int]) -> Iterator[range]:
    """The tokens of every "whichever cup is full", which names a thing by its state."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower not in _FREE:
            continue
        words = tokens[i + 1 : i + 2 + LONGEST_SUBJECT]
        be = next((word.i for word in words if word.lower in BE or word.pos in ("VERB", "PRON", "PUNCT")), None)
        if be is None or tokens[be].lower not in BE or i in tasks:
            continue
        state = _predicate(document, be + 1)
        if state is None or (tokens[state].pos != "ADJ" and not _ends(document, state + 1, tasks)):
            continue  # "whatever is on the table"
        yield range(i, state + 1)


def free_places(document: Document) -> Iterator[tuple[range, range]]:
    """Of every "whatever's on the table" that a mark ends, the tokens of "whatever's" and those of the whole."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-3]):
        is_free = token.lower in WHATEVER and tokens[i + 1].lower in BE and tokens[i + 2].lower in _WHERE
        if is_free and (i == 0 or tokens[i - 1].text in MARKS or tokens[i - 1].lower in ("and", "then")):
            stop = next((word.i for word in tokens[i:] if word.text in MARKS), None)
            if stop is not None and not any(word.text == "?" for word in tokens[stop : stop + 1]):
                yield range(i, i + 2), range(i, stop)


def _ends(document: Document, at: int, tasks: Collection[int]) -> bool:
    """Whether a clause ends right before a token."""
    tokens = document.tokens
    return at >= len(tokens) or tokens[at].text in MARKS or tokens[at].lower in _JOINTS or at in tasks


@dataclass(frozen=True, slots=True)
class Exclusion:
    """The tokens of what is left out, with the words that lead it; `is_part`: whether it is part of the phrase before
    it ("everything but the tv")."""

    tokens: range
    is_part: bool


def exclusions(document: Document, tasks: Collection[int]) -> Iterator[Exclusion]:
    """All that orders leave out, in text order: "except the red one", "but not the radio", "all but the small one"."""
    tokens = document.tokens
    for i in range(1, len(tokens)):
        if tokens[i].lower not in _FIRST_EXCEPTING:
            continue
        phrase = next((p for p in _EXCEPTING if tuple(t.lower for t in tokens[i : i + len(p)]) == p), None)
        if phrase is None or i in tasks or not any(_is_before(document, task, i) for task in tasks):
            continue
        is_led = _is_whole(document, i) if phrase in _OF_WHOLE else tokens[i - 1].lower not in ("quite", "and", "not")
        start = i + len(phrase)
        is_place = phrase in _BEFORE_PLACES and start < len(tokens) and tokens[start].lower in _IN
        stop = _end(document, start + is_place, tasks)
        if not is_led or stop is None:
            continue
        is_all = tokens[i - 1].lower == "all" and tokens[i - 2].text in MARKS
        is_named = tokens[i - 1].pos in _NOUNS | {"PRON", "DET"} or tokens[i - 1].lower in WHOLE
        is_part = phrase != ("but", "not") and not is_all and is_named
        yield Exclusion(range(i - is_all, stop), is_part)


def _is_before(document: Document, task: int, at: int) -> bool:
    return task < at and document.sentences[task] == document.sentences[at]


def _is_whole(document: Document, at: int) -> bool:
    """Whether a phrase of all things ends right before a token: "every lamp" but ..."""
    tokens = document.tokens
    for i in range(at - 1, max(-1, at - 6), -1):
        if tokens[i].lower in WHOLE:
            return True
        if tokens[i].pos not in _NOMINAL | {"PRON"} and tokens[i].lower not in ("of", "'s"):
            return False
    return False


def _end(document: Document, start: int, tasks: Collection[int]) -> int | None:
    """Where the phrase that begins at a token ends; None where it is none, but a clause or a pronoun alone."""
    tokens = document.tokens
    if start >= len(tokens) or tokens[start].pos not in _NOMINAL or tokens[start].lower in _POINTING:
        return None
    stop = start
    while stop < len(tokens) and tokens[stop].text not in MARKS and tokens[stop].lower not in _JOINTS:
        is_of_clause = any(token.lower in _RELATIVES for token in tokens[start + 1 : stop])
        is_attribute = tokens[stop].tag in ("VBN", "VBG") and stop + 1 < len(tokens) and _is_nominal(tokens[stop + 1])
        if stop in tasks or (tokens[stop].pos in ("VERB", "AUX") and not (is_of_clause or is_attribute)):
            return None
        stop += 1
    return stop if any(map(_is_nominal, tokens[start:stop])) else None


def _is_nominal(token: Token) -> bool:
    """Whether a word may end a phrase: "the chipped *one*", "the frying *pan*"."""
    return token.pos in _NOUNS or token.lower in ("one", "ones")


def found_places(document: Document) -> Iterator[range]:
    """The words of every clause that tells of a place that something was found or taken there: "put it back on the desk
    *where you found it*"."""
    tokens = document.tokens
    if "where" not in document.words:
        return
    for i, token in enumerate(tokens[:-2]):
        is_led = token.lower == "where" and tokens[i + 1].lower in ("you", "i", "we")
        if not is_led or tokens[i + 2].lemma not in _FINDING or tokens[i + 2].tag not in ("VBD", "VBN"):
            continue
        is_place = i > 0 and tokens[i - 1].pos in ("NOUN", "PROPN")
        stop = next((t.i for t in tokens[i + 3 :] if t.text in MARKS or t.tag == "CC"), len(tokens))
        if is_place:
            yield range(i, stop)
