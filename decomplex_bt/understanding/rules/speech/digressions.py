"""Digressions: clauses within an instruction whose verbs order nothing and ask nothing, and that are read past: what is
feared, what is to be seemed, what makes no difference, what something comes from, what is sworn, where something may
not be after all."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import ENDS, FINITE
from decomplex_bt.understanding.rules.speech.edits import MARKS, Said, is_order_at

_BECAUSE = frozenset("because cause cos cuz since".split())
_LEADING_ON = frozenset("so please then".split())
_JOINING = frozenset(("and", "but"))
_SEEMING = frozenset("looks look seems seem sounds sound appears feels".split())
_CONCEDING = frozenset("if though when".split())
_SUBJECTS = frozenset("i it he she they we you that".split())
_OBJECTS = frozenset("me him her us them you".split())
_CAUSES = (("from",), ("because", "of"), ("on", "account", "of"), ("due", "to"), ("thanks", "to"), ("owing", "to"))
_HEAVENS = frozenset("heaven god goodness pete christ crying".split())
_THINGS = frozenset("it they he she".split())
_BEING = frozenset("is are 's 're be should must will 'll ought to probably usually".split())
_GOING_BY = frozenset("if in otherwise then else".split())
_ANYHOW = frozenset(("however", "whichever"))
_DETERMINERS = frozenset("the my our your his her their that this".split())


def digressions(said: Said) -> Iterator[range]:
    """Every digression; the mark behind it stays, the comma ahead of it goes with it."""
    words = said.words
    if not _BECAUSE.isdisjoint(words):
        yield from _feared(said)
    if "as" in words or "like" in words:
        yield from _seemed(said)
    if "even" in words:
        yield from _indifferent(said)
    if not {cause[0] for cause in _CAUSES}.isdisjoint(words):
        yield from _caused(said)
    if not _ANYHOW.isdisjoint(words):
        yield from _anyhow(said)
    if "sake" in words:
        yield from _sworn(said)
    if "unless" in words:
        yield from _doubted(said)


def _feared(said: Said) -> Iterator[range]:
    """ "Because if those goats get in, I'll cry": to the end of the sentence, or up to what follows from it; not
    "because if it isn't, you'd better plug it in", "..., plug it in"."""
    words = said.words
    for i in range(1, len(words) - 2):
        if words[i] in _BECAUSE and words[i + 1] == "otherwise" and words[i + 2] in _SUBJECTS:
            yield range(_from_mark(said, i), _end(said, i))  # "because otherwise I can't see"
        if words[i] not in _BECAUSE or words[i + 1] != "if" or words[i + 2] in _SUBJECTS | {"not", "so"}:
            continue
        stop = i + 1
        while stop < len(words) and words[stop] not in ENDS:
            if words[stop] in MARKS and stop + 1 < len(words) and words[stop + 1] in _LEADING_ON | _JOINING:
                break
            stop += 1
        if "you" not in words[i:stop] and not any(_is_order(said, j) for j in range(i, stop)):
            yield range(_from_mark(said, i), stop)


def _is_order(said: Said, at: int) -> bool:
    """Whether a verb stands bare at the beginning of a clause."""
    token = said.document.tokens[at]
    is_bare = token.tag in ("VB", "VBP") and token.pos == "VERB" and said.words[at - 1] in MARKS | {"please", "then"}
    return is_bare and said.document.tokens[at].dep != "conj"


def _seemed(said: Said) -> Iterator[range]:
    """ "So that it looks as if somebody is in", "so it looks like we're home"."""
    words = said.words
    for i in range(1, len(words) - 4):
        start = i + 1 + (words[i + 1] == "that")
        if words[i] != "so" or words[start] not in ("it", "that", "everything"):
            continue
        seeming = next((j for j in range(start + 1, min(start + 4, len(words) - 2)) if words[j] in _SEEMING), 0)
        likened = words[seeming + 1 : seeming + 3]
        if seeming and (likened[0] == "like" or likened in (["as", "if"], ["as", "though"])):
            yield range(_from_mark(said, i), _end(said, i))


def _indifferent(said: Said) -> Iterator[range]:
    """ "Even if I'm out in the yard", between marks, said of what a pronoun means, behind an order."""
    words, tokens = said.words, said.document.tokens
    for i in range(1, len(words) - 3):
        is_led = words[i - 1] in MARKS and words[i] == "even" and words[i + 1] in _CONCEDING
        stop = _end(said, i)
        is_behind = any(token.pos == "VERB" and token.tag in ("VB", "VBP") for token in tokens[:i])
        goes_on = stop < len(words) and words[stop] == ","
        if is_led and is_behind and goes_on and words[i + 2] in _SUBJECTS and tokens[stop - 1].pos != "AUX":
            yield range(i - 1, stop)


def _anyhow(said: Said) -> Iterator[range]:
    """ "However hot it is", "whichever way you find it", with the marks that set it off."""
    words, tokens = said.words, said.document.tokens
    for i in range(len(words) - 2):
        is_degree = words[i] == "however" and tokens[i + 1].pos in ("ADJ", "ADV") and words[i + 1] not in MARKS
        if not (is_degree or words[i : i + 2] == ["whichever", "way"]):
            continue
        stop = _end(said, i)
        is_last = i > 0 and (stop == len(words) or words[stop] in ENDS)  # "whichever way it goes, ..." is a cue
        is_led = is_last if not is_degree else i == 0 or words[i - 1] in MARKS | ENDS | {"and", "but", "then"}
        if is_led and any(token.tag in FINITE or token.lower in _BEING for token in tokens[i:stop]):
            is_first = i == 0 or words[i - 1] in ENDS
            is_parted = is_first and stop < len(words) and words[stop] in MARKS
            yield range(i - (i > 0 and words[i - 1] in MARKS), stop + is_parted)


def _caused(said: Said) -> Iterator[range]:
    """ "From me mopping it", "because of the kids spilling juice", "on account of that breaker acting up"."""
    words, tokens = said.words, said.document.tokens
    for i in range(1, len(words) - 3):
        start = next((i + len(c) for c in _CAUSES if tuple(words[i : i + len(c)]) == c), 0)
        if not start or start + 1 >= len(words):
            continue
        verb = start + 1 + (words[start] in _DETERMINERS)
        is_cause = words[i] != "from" and verb == start + 2  # not "from the man sitting there"
        is_somebody = words[start] in _OBJECTS or is_cause
        stop = _end(said, i)
        is_doing = is_somebody and verb < stop and tokens[verb].tag == "VBG"
        if is_doing and all(token.tag not in FINITE for token in tokens[i:stop]):
            yield range(i, stop)


def _sworn(said: Said) -> Iterator[range]:
    """ "For heaven's sake"."""
    words = said.words
    for i in range(len(words) - 3):
        before, whose, _, sake = words[i : i + 4]
        if (before, sake) == ("for", "sake") and whose in _HEAVENS:
            yield range(i, i + 4)


def _doubted(said: Said) -> Iterator[range]:
    """ "Unless Tom has moved it" at the end of a sentence, behind where something that was ordered "is" or "should be";
    not where the next sentence tells what to do then."""
    words, tokens = said.words, said.document.tokens
    for i in (i for i, word in enumerate(words) if word == "unless"):
        behind = i - 1 if words[i - 1] in MARKS else i
        start = next((j + 1 for j in range(behind - 1, -1, -1) if words[j] in MARKS | ENDS), 0)
        told = words[start + 1 : behind]
        place = next((n for n, token in enumerate(tokens[start + 1 : behind]) if token.tag == "IN"), 0)
        is_told = 0 < start < i and words[start] in _THINGS and _BEING.issuperset(told[:place]) and place > 0
        stop = next((j for j in range(i, len(words)) if words[j] in MARKS | ENDS), len(words))
        is_ordered = any(token.tag in ("VB", "VBP") for token in tokens[:start])
        is_last = stop == len(words) or words[stop] in ENDS
        goes_by = words[stop + 1 : stop + 2] and words[stop + 1] in _GOING_BY
        is_moved = any(token.tag in ("VBD", "VBN") for token in tokens[i:stop])
        if is_told and is_ordered and is_last and is_moved and not goes_by:
            yield range(behind, stop)


def _end(said: Said, start: int) -> int:
    """The mark behind a clause, or the "and" behind which an order follows."""
    words = said.words
    for j in range(start + 1, len(words)):
        is_joint = words[j] in _JOINING | _LEADING_ON and j + 1 < len(words) and is_order_at(said.document, j + 1)
        if words[j] in MARKS | ENDS or is_joint:
            return j
    return len(words)


def _from_mark(said: Said, start: int) -> int:
    return start - 1 if said.words[start - 1] in MARKS else start
