"""Wordings: how a candidate may be said for a gap, as far as the gap's own words leave it open."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.gaps import Gap, is_told_one
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.references.spellings import numbered_of, spellings
from decomplex_bt.understanding.references.traits import modifier, named
from decomplex_bt.understanding.vocabulary import ONES, QUANTIFIERS

_PLACES = frozenset(("goal", "location", "source", "path"))
_EACH = frozenset(("all", "every", "each"))
_OPEN_SHARES = frozenset(("any", "some", "enough", "much"))
_LACKING = frozenset(("no", "few"))
_OTHER = frozenset(("other", "others", "another"))
_SAME_KIND = frozenset("another other new old spare fresh second third first next last".split())
"""What tells a thing from others of its kind."""
_CERTAIN = frozenset("the this that these those".split())


def wordings(observed: Observed, gap: Gap, candidate: Candidate, is_contrasted: bool) -> Iterator[tuple[str, str]]:
    """The spellings of a candidate for a gap, none of which says what the gap's words rule out: "another" is not the
    thing itself, and "the black one" no grey hoodie."""
    tokens = observed.document.tokens
    worded = list(spellings(observed.document, gap, candidate))
    words = {tokens[i].lower for i in gap.tokens}
    if not words.isdisjoint(_OTHER):
        # "the other one" is none of those named, and in contrast with "the red mug" it is not red
        is_told = "another" not in words and modifier(observed, named(candidate)) == "colour"
        red = tokens[candidate.head - 1].text if is_told else ""
        worded = [(" ".join(word for word in text.split(" ") if word != red), way) for text, way in worded]
        worded = [(text, way) for text, way in worded if text.split()[-1] not in ONES]
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if gap.word == "it" and gap.form == "pronoun":
        worded = [(_without_open_share(text), way) for text, way in worded]
    if kind := _kind_behind_colour(observed, gap, candidate):
        told = " ".join(tokens[i].text for i in gap.tokens[:-1])
        worded = [(f"{told} {kind}", "modified")]
    if _is_of_same_kind(observed, gap, candidate):
        worded = [(text, way) for text, way in worded if way != "modified.head"]
    if is_of_somebody(observed.document, gap):  # "Anna's" is none of those named
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if words == {"mine"}:  # none of those named, but the speaker's of that kind
        worded = [(text, way) for text, way in worded if way == "own"] or worded
    if words == {"some"} and tokens[candidate.tokens.start].lower == "enough":
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if _is_one_of_several(observed.document, gap, candidate):  # "any pears? Bring me *one*" brings a pear
        worded = [(text, way) for text, way in worded if way in ("a", "one")] or worded
    if _is_one_of_known(observed.document, gap, candidate):
        worded = [(f"one of {text}", way) for text, way in worded if way == "same"] or worded
    if is_bare_one(observed.document, gap) and is_halved(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way == "one"] or worded
    if gap.form == "part" and _is_counted_out(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if _is_counted(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way.startswith("counted")] or worded
    if numbered_of(observed.document, gap):
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if is_told_one(observed.document, gap.tokens):
        worded = [(text, way) for text, way in worded if way == "a"] or worded
    if tokens[candidate.tokens.start].lower in _LACKING:  # what there is none of: "no paper? Bring some"
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    certain = tokens[candidate.tokens.start].tag == "PRP$" or tokens[candidate.tokens.start].lower in _CERTAIN
    is_measure = (  # "a glass of it" is no bottle
        gap.form == "part"
        and tokens[gap.tokens.start].pos in ("DET", "NUM")
        and tokens[gap.tokens.stop - 3].pos == "NOUN"
    )
    if is_measure or (gap.word == "another" and certain):
        yield from ((worded[0][0] if way == "same" else text, way) for text, way in worded)
        return
    colour = tokens[candidate.head - 1] if is_contrasted else None
    if colour is None or colour.lower == tokens[gap.tokens.stop - 2].lower:
        yield from worded
        return
    noun = next((text for text, way in worded if way == "modified.head"), worded[0][0])
    yield from ((noun if colour.text in text.split() else text, way) for text, way in worded)


def _without_open_share(text: str) -> str:
    """What is handled as "it" where it was asked if there is any of it: "*that soup*" of "any of that soup"."""
    share, joint, whole = text.partition(" of ")
    return whole if joint and share.lower() in _OPEN_SHARES else text


def is_coloured(observed: Observed, candidate: Candidate) -> bool:
    before = observed.document.tokens[candidate.head - 1] if candidate.head else None
    return before is not None and before.lower in observed.gazetteer.colours


def _kind_behind_colour(observed: Observed, gap: Gap, candidate: Candidate) -> str:
    """What a thing is called behind its colour where "one" has another colour: the "sippy cup" of "the blue sippy cup
    ... *the pink one*"; empty where that is its noun alone."""
    tokens, colours = observed.document.tokens, observed.gazetteer.colours
    if gap.form != "one" or gap.word != "one" or modifier(observed, gap.tokens) != "colour":
        return ""
    colour = next((i for i in named(candidate) if tokens[i].lower in colours), candidate.head)
    is_single = tokens[candidate.head].tag in ("NN", "NNP")
    kind = " ".join(tokens[i].text for i in range(colour + 1, candidate.head + 1))
    return kind if " " in kind and is_single else ""


def _is_of_same_kind(observed: Observed, gap: Gap, candidate: Candidate) -> bool:
    """Whether "one" is of the very kind of a thing that is called by a compound: "another one", "the old one" or "the
    red one" behind "the crib sheet" is a crib sheet; "the small one" behind "the dining table" may be any table."""
    tokens, colours = observed.document.tokens, observed.gazetteer.colours
    words = [tokens[i].lower for i in gap.tokens]
    told = words[-2] if len(words) in (2, 3) and words[-1] in ONES else ""
    first = tokens[candidate.head - 1]
    is_compound = candidate.head > 0 and first.dep == "compound" and first.lower not in colours
    return gap.form == "one" and is_compound and (told in _SAME_KIND or told in colours)


def is_of_somebody(document: Document, gap: Gap) -> bool:
    """Whether somebody's thing is handled whose noun was said before: "bring me *Mum's*"; no "cup of Barry's"."""
    is_handled = gap.type == "object" and gap.task.type in ("bringing", "taking", "placing")
    words = {document.tokens[i].lower for i in gap.tokens}
    return is_handled and gap.word == "'s" and words.isdisjoint(("of", "yesterday", "today"))


def is_bare_one(document: Document, gap: Gap) -> bool:
    return [document.tokens[i].lower for i in gap.tokens] == ["one"]


def is_halved(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether "one" is one of several things of which "the other" is told behind: "get *two* cups, put *one* here and
    *the other* there"."""
    tokens = document.tokens
    if gap.type != "object" or tokens[candidate.head].tag not in ("NNS", "NNPS") or candidate.type in _PLACES:
        return False
    others = (t.i for t in tokens[gap.tokens.stop :] if t.lower == "other" and tokens[t.i - 1].lower == "the")
    return any(i + 1 == len(tokens) or tokens[i + 1].pos not in ("NOUN", "PROPN") for i in others)


def _is_one_of_several(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether a bare "one" is one of several, and not all of them: of all the towels, of "*the plums*" or of "*a
    couple of plums*"."""
    if not is_bare_one(document, gap):
        return False
    first = document.tokens[candidate.tokens.start].lower
    is_plural = document.tokens[candidate.head].tag in ("NNS", "NNPS")
    is_open = first in QUANTIFIERS or candidate.tokens.start == candidate.head
    is_several = is_plural and (is_open or first in _CERTAIN | {"a"}) and not candidate.mention
    return first in _EACH or (is_several and gap.task.type != "check_state")


def _is_one_of_known(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether something is asked of one of several known things: "look at *the tyres*; if *one* is low, ..."."""
    first = document.tokens[candidate.tokens.start]
    is_known = first.lower in _CERTAIN or first.tag == "PRP$"
    is_several = document.tokens[candidate.head].tag in ("NNS", "NNPS")
    is_asked = gap.task.type == "check_state" and gap.is_certain and is_bare_one(document, gap)
    return is_asked and is_known and is_several and not candidate.text.lower().startswith("one of ")


def _is_counted(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether a number alone, with its limit, or one "of those", says how many are meant, and not all: "any buns left?
    Bring me *two*", "if there are *fewer than six*", "bring me *two of those*"; no "six" that is booth six."""
    said = [document.tokens[i] for i in gap.tokens] if gap.form in ("count", "part") else []
    number = next((token for token in said if token.pos == "NUM" or token.lower == "dozen"), None)
    if number is None or number.lower in ("one", *candidate.text.lower().split()):
        return False
    return gap.form == "count" or gap.word in ("those", "these")


def _is_counted_out(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether one or so and so many are taken of known things: "six of them" of "the balloons"."""
    count, first = document.tokens[gap.tokens.start], document.tokens[candidate.tokens.start]
    is_known = first.lower in _CERTAIN or first.tag == "PRP$"
    is_several = document.tokens[candidate.head].tag in ("NNS", "NNPS")
    return (count.pos == "NUM" or count.lower == "one") and is_known and is_several
