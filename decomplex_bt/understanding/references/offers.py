"""Offers: the thing that a clause right ahead of an order says will do, which the order then takes up ("otherwise *the
fleece* is fine, just put *it* on the chair"), and what is filled where there is nothing in it."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_NUMBERS = {"it": frozenset(("NN", "NNP")), "that": frozenset(("NN", "NNP")), "them": frozenset(("NNS", "NNPS"))}
_AHEAD = frozenset("and so then just please simply".split())
"""What may stand between the clause and the verb of the order, beside a mark."""
_SUFFICING = frozenset("fine ok okay enough good alright right nice great better do does works".split())
_LINKING = frozenset(
    "is are 's 're s re be will would should 'll might could may do does works just also "
    "quite all as very perfectly well then".split()
)
"""What stands between what is offered and the word that says it will do, that word itself where it is a verb."""
FILLING = frozenset(("fill", "fill up", "refill"))
_PARTLY = frozenset("some any more enough no".split())
"""What stands before what there is an amount of."""
_SAID = frozenset(("whole", "long"))


def offered(context: Context, gap: Gap) -> range:
    """The words of the thing that is said to do right ahead of an order of what to do with it; empty where none is."""
    document = context.observed.document
    if gap.type != "object" or gap.word not in _NUMBERS or len(gap.tokens) != 1:
        return range(0)
    stop = document.indices(gap.task.span).start
    while stop and (document.tokens[stop - 1].text in MARKS or document.tokens[stop - 1].lower in _AHEAD):
        stop -= 1
    subject = _subject_end(document, stop)
    if not subject or not context.verbs.isdisjoint(range(subject, stop)):
        return range(0)  # "if the pedal works, use it"
    found = (c for c in context.pool if c.tokens.stop == subject and not c.mention)
    return max((c.tokens for c in found if _is_meant(context, gap, c)), key=len, default=range(0))


def is_filled_for(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what was filled for what "it" is given: "fill *the can* and give *it* a drink"."""
    is_given = gap.type == "recipient" and gap.word in ("it", "them")
    return is_given and candidate.type == "object" and context.lemmas.get(candidate.owner) in FILLING


def _subject_end(document: Document, stop: int) -> int:
    """Where the subject of a clause that ends before a token is over, if that says that something will do; else 0."""
    tokens = document.tokens
    if not stop or tokens[stop - 1].lower not in _SUFFICING:
        return 0
    start = stop - 1 if tokens[stop - 1].lower not in _LINKING else stop
    while start and tokens[start - 1].lower in _LINKING:
        start -= 1
    return start if start < stop - 1 or tokens[stop - 1].lower in _LINKING else 0


def _is_meant(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a phrase is a thing, or things, of the number that a pronoun tells, and no more than that."""
    tokens = context.observed.document.tokens
    is_whole = not candidate.shape.endswith(("list", "cut"))
    return is_whole and tokens[candidate.head].tag in _NUMBERS[gap.word] and kind_of(context, candidate) not in ANIMATE


def filled_meant(context: Context, gap: Gap) -> range:
    """The words of what is filled where a condition asked whether there is anything in it: "is there oil in *the lamp*?
    If not, fill *it* up"; empty where it is none such."""
    path = context.paths.get(gap.task.id, ())
    is_filled = context.lemmas[gap.task.id] in FILLING and gap.word == "it" and gap.type == "object"
    if not is_filled or not path or path[-1][1] != "else":
        return range(0)
    check = path[-1][0]
    asked = {c.type: c for c in context.pool if c.owner == check and not c.mention and c.shape in _SAID}
    is_asked = {"object", "location"} <= asked.keys() and is_measured(context.observed.document, asked["object"])
    is_handled = any(c.type == "object" and check < c.owner < gap.task.id and not c.mention for c in context.pool)
    if not is_asked or is_handled:
        return range(0)
    place = asked["location"]
    is_further = any(
        context.observed.document.tokens[i].pos == "ADP" for i in place.tokens[1:]
    )  # "the jug on the shelf"
    return range(place.tokens.start, place.head + 1) if is_further else place.tokens


def is_measured(document: Document, candidate: Candidate) -> bool:
    """Whether a phrase is of an amount of something: "any tea", "water"."""
    head, first = document.tokens[candidate.head], document.tokens[candidate.tokens.start]
    return first.lower in _PARTLY or (first.i == candidate.head and head.tag == "NN")
