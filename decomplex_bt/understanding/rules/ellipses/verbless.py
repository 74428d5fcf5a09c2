"""Verbless cases: checks that say only a noun ("if *no bread*, ...", "unless *Sunday*, ...", "in case
of *frost*, ...", "*any bread*?") or how something is ("when *dark*, ...", "*too dark*?")."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.bare_states import bare_state
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import head_of
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment
from decomplex_bt.understanding.vocabulary import LEVELS

_OPENING = frozenset(("if", "unless"))
_IN_CASE = (("in", "case", "of"), ("in", "the", "event", "of"))
_TAKING_UP = frozenset("if otherwise else then yes no not when".split())
"""First words behind a question that say what comes of it."""
_UNHEEDED = frozenset("still only just ever then".split())
_DEGREES = frozenset("too still not very quite fast sound all nearly almost slightly completely totally".split())
_SHARES = frozenset("half quarter third zero freezing".split())
_COLOURS = frozenset("red green amber yellow orange blue white".split())
_DENYING, _ASKING = "no", "any"
_PARTS = frozenset(("DET", "ADJ", "NOUN", "PROPN", "NUM", "ADV", "ADP"))
_NOUNS = frozenset(("NOUN", "PROPN"))
_CORRECTING = frozenset("no sorry wait i oh er um uh".split())
_LONGEST = 6
_TOLD = frozenset("me us him her them know".split())
_NO_CASES = frozenset(
    "possible necessary necessity need needed required applicable available sure unsure true false positive negative "
    "able unable done finished through "
    "successful unsuccessful lucky unlucky ok okay fine home luck joy good anything nothing doubt emergency course "
    "thing time yes no aye yeah yep nope nay neither either answer reply response sign show dice failure "
    "success need".split()
)
"""What stands behind an "if" and takes up what was said, or asks nothing."""


def verbless_cases(observed: Observed, tasks: Collection[int]) -> Iterator[Fragment]:
    """The checks of nouns that stand alone between an "if" and a comma or the end of a sentence, or are asked after by
    "any", with none of the `tasks`, which are tokens, among them but the head."""
    document, tokens = observed.document, observed.document.tokens
    yield from _bare_states(observed)
    yield from _asked_states(observed)
    for first in _openings(document):
        stop = _mark(document, first)
        if (stop < len(tokens) and not _is_end(document, stop)) or bare_state(observed, first - 1) is not None:
            continue
        if first < stop and tokens[first].lower == _ASKING and not _is_asked(document, first, stop):
            continue
        while first < stop and tokens[first].lower in _UNHEEDED:
            first += 1
        if first == stop:
            continue
        phrase = range(first + (tokens[first].lower == _DENYING), stop)
        if _is_comparison(document, phrase):
            yield Fragment(range(first, stop), first, range(0), range(0), state=phrase)
            continue
        head = _head(document, phrase)
        if head is not None and not any(i in tasks for i in phrase if i != head):
            is_of_day = tokens[head].lower in WEATHER
            thing, state = (range(0), phrase) if is_of_day else (phrase, range(0))
            if tokens[first - 1].lower == "of":  # "in case of rain" names no state beside the word that carries it
                state = range(0)
            yield Fragment(range(first, stop), head, thing, range(0), state=state)


def _bare_states(observed: Observed) -> Iterator[Fragment]:
    """The states that stand alone between a word that opens a case and a mark: "*when full*, empty it", "lock it
    *unless wet*"; not "tell me *when ready*"."""
    tokens = observed.document.tokens
    for opening in (token.i for token in tokens if token.lower in (*_OPENING, "when")):
        at = bare_state(observed, opening)
        before = tokens[opening - 1] if opening else None
        is_asked = before is not None and (before.lemma in ASKING_LEMMAS or before.lower in _TOLD)
        if at is not None and not is_asked and _NO_CASES.isdisjoint((tokens[at].lemma, tokens[at].lower)):
            yield Fragment(range(opening + 1, at + 1), at, range(0), range(0))


def _asked_states(observed: Observed) -> Iterator[Fragment]:
    """The states that are all that a sentence asks, behind another one: "*too cold*? Add hot water", "*too cold for a
    child*?", "*crying*?", "*amber*?"; other single words are left to the models."""
    document, tokens, sentences = observed.document, observed.document.tokens, observed.document.sentences
    for first in (i for i in range(1, len(tokens)) if sentences[i] != sentences[i - 1]):
        stop = next((j for j in range(first, len(tokens)) if tokens[j].text in MARKS), len(tokens))
        phrase = range(first, stop)
        if stop + 1 >= len(tokens) or tokens[stop].text != "?" or not 0 < len(phrase) <= _LONGEST:
            continue
        if _is_comparison(document, phrase):
            yield Fragment(phrase, first, range(0), range(0), state=phrase)
        elif len(phrase) == 1 and (tokens[first].tag == "VBG" or tokens[first].lower in _COLOURS):
            yield Fragment(phrase, first, range(0), range(0))
        elif (at := _state_in(observed, phrase)) is not None:
            state = range(first, at + 1) if tokens[first].lower == "too" else range(0)
            yield Fragment(phrase, at, range(0), range(0), state=state)


def _state_in(observed: Observed, phrase: range) -> int | None:
    """The state that a phrase is of, behind words for how much so, if it says no more: "fast *asleep*", "too *cold*
    for a child"."""
    tokens = observed.document.tokens
    at = next((i for i in phrase if tokens[i].lower not in _DEGREES), None)
    if at is None or at == phrase.start:
        return None
    is_state = tokens[at].pos == "ADJ" or tokens[at].lower in observed.gazetteer.states
    is_whole = at + 1 == phrase.stop or tokens[at + 1].lower == "for"
    return at if is_state and is_whole and _NO_CASES.isdisjoint((tokens[at].lemma, tokens[at].lower)) else None


def _is_comparison(document: Document, phrase: range) -> bool:
    """Whether words say no more than that there is more or less than so much: "fewer than six", "below ten degrees"."""
    words = [document.tokens[i] for i in phrase]
    is_led = len(words) > 2 and words[0].lower in ("fewer", "less", "more") and words[1].lower == "than"
    is_level = len(words) > 1 and words[0].lower in LEVELS
    is_led = is_led or (is_level and any(word.pos == "NUM" or word.lower in _SHARES for word in words))
    return is_led and len(words) <= _LONGEST and not any(word.pos in ("VERB", "AUX") for word in words)


def _mark(document: Document, first: int) -> int:
    """The next mark from a token on that is no hyphen of a word, else the number of tokens."""
    tokens = document.tokens
    marks = (i for i in range(first, len(tokens)) if tokens[i].text in MARKS)
    hyphens = {i for i, token in enumerate(tokens) if token.text == "-" and i and tokens[i - 1].end == token.start}
    return next((i for i in marks if i not in hyphens), len(tokens))


def _openings(document: Document) -> Iterator[int]:
    """Where a case may begin: behind an "if" or "in case of", or with an "any" at the beginning of a sentence."""
    for i, token in enumerate(document.tokens):
        if token.lower == "in" and (first := _in_case(document, i)) is not None:
            yield first
        is_conceded = i > 0 and document.tokens[i - 1].lower == "even"
        is_asked = i > 0 and document.tokens[i - 1].lemma in ASKING_LEMMAS  # "see if the lamp in the corridor works"
        if token.lower in _OPENING and i + 1 < len(document) and not (is_conceded or is_asked):
            yield i + 1
        elif token.lower == _ASKING and (i == 0 or document.tokens[i - 1].text in ENDS):
            yield i


def _in_case(document: Document, i: int) -> int | None:
    """Where the case begins that "in case of" or "in the event of" opens; the former tells at the end of a sentence
    what something is done against: "take a coat *in case of rain*"."""
    tokens = document.tokens
    for phrase in _IN_CASE:
        first = i + len(phrase)
        stop = next((j for j in range(first, len(tokens)) if tokens[j].text in MARKS), len(tokens))
        is_said = tuple(t.lower for t in tokens[i:first]) == phrase and (i == 0 or tokens[i - 1].lower != "just")
        if is_said and (len(phrase) > len(_IN_CASE[0]) or (stop < len(tokens) and tokens[stop].text == ",")):
            return first
    return None


def _is_asked(document: Document, first: int, stop: int) -> bool:
    """Whether words behind an "any" are asked, name no place and are taken up behind: "any bread? If so, ..."."""
    tokens = document.tokens
    is_question = stop + 1 < len(tokens) and tokens[stop].text == "?" and tokens[stop + 1].lower in _TAKING_UP
    return is_question and not any(token.pos == "ADP" for token in tokens[first:stop])


def _head(document: Document, phrase: range) -> int | None:
    """The noun that a phrase is about, if it is one and no more."""
    words = document.tokens[phrase.start : phrase.stop]
    if not 0 < len(words) <= _LONGEST or any(word.pos not in _PARTS for word in words):
        return None
    if words[0].pos == "ADP" or words[-1].pos not in _NOUNS:
        return None
    head = document.tokens[head_of(document, phrase)]
    return head.i if head.pos in _NOUNS and head.lemma not in _NO_CASES else None


def _is_end(document: Document, i: int) -> bool:
    """Whether a mark ends a case: a comma behind which nothing is put right, or the end of a sentence."""
    tokens = document.tokens
    if tokens[i].text != ",":
        return tokens[i].text in ENDS
    return i + 1 < len(tokens) and tokens[i + 1].lower not in _CORRECTING
