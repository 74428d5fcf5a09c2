"""Antecedents: the one phrase that a word must refer to, by what is contrasted, owned, taken out or lacked."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.agreement import PLACES, PUTTING, gender, is_of_other_gender
from decomplex_bt.understanding.references.bare_names import called_by_name
from decomplex_bt.understanding.references.context import ANIMATE, GROUPS, Context, kind_of
from decomplex_bt.understanding.references.dismissals import reminded
from decomplex_bt.understanding.references.gaps import Gap, asks_there_is, is_beside
from decomplex_bt.understanding.references.offers import filled_meant, offered
from decomplex_bt.understanding.references.ordinals import one_of_two
from decomplex_bt.understanding.references.owners import asked_of, by_owner, kind_of_it
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.references.places import place_meant
from decomplex_bt.understanding.references.repetition import done_before
from decomplex_bt.understanding.references.told import number_of, subject_of
from decomplex_bt.understanding.references.undoing import done_contrariwise, undone
from decomplex_bt.understanding.references.unsaid_goals import goal_instead
from decomplex_bt.understanding.references.unsaid_recipients import asked
from decomplex_bt.understanding.references.wholes import own_subject, whole_meant
from decomplex_bt.understanding.vocabulary import ONES

_ANY = frozenset(("a", "an", "one"))
_OUT_OF = frozenset((("out", "of"), ("empty", "of"), ("short", "of"), ("low", "on"), ("short", "on")))
"""What stands before the thing of which there is too little."""
_MAKING = PUTTING | {"change_state"}
"""The types of orders that make or bring something."""
_CHANGING = tuple([verb] for verb in "change replace swap renew".split())
_WORN = frozenset("old broken dead dirty used empty worn spent".split())
"""How a thing is that was changed for another."""
_BEING_WITHOUT = frozenset("be 's 're run go".split())
"""What is said with `_OUT_OF`, of which "take the milk out of the fridge" is none."""


def meant(context: Context, gap: Gap) -> range:
    """The words of the one phrase that a gap must refer to; empty where English leaves it open."""
    return (
        _own(context, gap)
        or one_of_two(context, gap)
        or place_meant(context, gap)
        or _neighbour(context, gap)
        or other_place(context, gap)
        or _removed(context, gap)
        or _lacked(context, gap)
        or _vessel(context, gap)
        or _like_it(context, gap)
        or _any_of_it(context, gap)
        or _renewed(context, gap)
        or by_owner(context, gap)
        or kind_of_it(context, gap)
        or asked_of(context, gap)
        or _told(context, gap)
        or whole_meant(context, gap)
        or own_subject(context, gap)
        or offered(context, gap)
        or filled_meant(context, gap)
        or _somebody(context, gap)
        or _instead(context, gap)
        or undone(context, gap)
        or done_contrariwise(context, gap)
        or goal_instead(context, gap)
        or asked(context, gap)
        or _shared(context, gap)
        or reminded(context, gap)
        or called_by_name(context, gap)
        or done_before(context, gap)
    )


def _somebody(context: Context, gap: Gap) -> range:
    """Of whom the condition is, or who was asked after, where somebody else was told or asked in between: "if *the
    girl* is sad, ask Paul why and give *her* a tissue", "ask Jenny where *my brother* is and take *him* the cap"."""
    group = GROUPS.get(gap.word, "")
    if group not in ("he", "she") or gap.task.type not in PUTTING:
        return range(0)
    before = context.by_number.get(gap.task.id - 1)
    if before is None or before.type != "informing":
        return range(0)
    document = context.observed.document
    path = context.paths.get(gap.task.id, ())
    checks = {path[-1][0]} if path and context.paths.get(before.id) == path else set()
    messages = [document.indices(a.span) for a in before.arguments if a.type == "message" and a.span]
    asked = [m for m in messages if document.tokens[m.start].lower == "where"]
    is_helped = bool(messages) or gap.type == "object"
    named = [
        c
        for c in context.pool
        if not c.mention
        and not c.shape.endswith("cut")
        and gender(document, c) == group
        and not is_of_other_gender(document, gap, c)
        and c.tokens.stop <= gap.position
    ]
    topics = [
        c for c in named if (is_helped and c.owner in checks and c.type == "object") or _lies_within(c.tokens, asked)
    ]
    told = [c for c in named if c.owner == before.id and c.type == "recipient"]
    return topics[0].tokens if topics and not told else range(0)


def _instead(context: Context, gap: Gap) -> range:
    """Who would have been given or told something in the other case, where nothing else is said of who it is: "my
    brother left it to me. If it's worth a lot, give it to *the dealer*; otherwise ask *him* for a price"."""
    group = GROUPS.get(gap.word, "")
    if group not in ("he", "she") or gap.type != "recipient":
        return range(0)
    document = context.observed.document
    own = [
        c
        for c in context.pool
        if not c.mention and c.type == "recipient" and c.shape in ("whole", "long") and c.tokens.stop <= gap.position
    ]
    told = [c for c in own if context.relation(c.owner, gap.task.id) == "exclusive"]
    others = {
        c.owner
        for c in context.pool
        if c.owner and kind_of(context, c) in ANIMATE and c not in told and not is_of_other_gender(document, gap, c)
    }
    if len(told) != 1 or others or is_of_other_gender(document, gap, told[0]):
        return range(0)
    is_near = document.sentences[told[0].tokens.start] >= document.sentences[gap.position] - 1
    return told[0].tokens if is_near else range(0)


def _own(context: Context, gap: Gap) -> range:
    """What a word refers to in its own order: "take *Dana*'s phone from *her*", "take *my sister*'s coat to *her*",
    where nobody else was named before, "*the box* and the pens in *it*"."""
    document = context.observed.document
    own = [c for c in context.pool if c.owner == gap.task.id and c.type == "object" and c.tokens.stop < gap.position]
    is_from_owner = gap.type == "source" and gap.preposition == "from"
    is_to_owner = gap.type == "recipient" and not _is_called(context, gap)
    if (is_from_owner or is_to_owner) and GROUPS.get(gap.word) in ("he", "she", "they"):
        behind = (c for c in own if document.tokens[c.tokens.stop].tag == "POS" and not c.mention)
        return next((c.tokens for c in behind if not is_of_other_gender(document, gap, c)), range(0))
    whole = next((c.tokens for c in own if c.tokens.stop == gap.position - 1), range(0))
    if gap.task.type != "taking" or gap.word != "it" or not gap.preposition or not whole:
        return range(0)
    first = range(whole.start, next((i for i in whole if document.tokens[i].lower == "and"), whole.start))
    return first if any(c.tokens == first for c in own) else range(0)


def _is_called(context: Context, gap: Gap) -> bool:
    """Whether somebody whom "her" may be of was named before the order that it stands in."""
    document = context.observed.document
    verb = document.indices(gap.task.span).start
    named = (c for c in context.pool if c.tokens.stop <= verb and kind_of(context, c) in ANIMATE)
    return any(not is_of_other_gender(document, gap, c) for c in named)


def other_place(context: Context, gap: Gap) -> range:
    """The place with which another is in contrast: "take the pens from *the left drawer* and put them in *the right
    one*", "move the chairs from *one room* to *the other*". Open where a thing might be what it is in contrast with."""
    if gap.type not in PLACES or not gap.preposition or not gap.tokens:
        return range(0)
    places = [
        c
        for c in context.pool
        if c.type in PLACES
        and not c.mention
        and c.shape in ("whole", "long", "short")
        and c.tokens.stop <= gap.position
        and c.owner in (gap.task.id, gap.task.id - 1)
    ]
    if not places:
        return range(0)
    last = places[-1]
    others = (c for c in context.pool if c.type not in PLACES and not c.mention and c.tokens.stop <= gap.position)
    is_alone = not any(_is_in_contrast(context, gap, c) for c in others)
    return last.tokens if is_alone and _is_in_contrast(context, gap, last) else range(0)


def _neighbour(context: Context, gap: Gap) -> range:
    """What is put by another of its kind, or, where nothing else was named, on one: "put *the red mug* next to *the
    blue one*", "stack *the red crate* on *the blue one*"."""
    if gap.form != "one" or not gap.tokens:
        return range(0)
    is_first = all(c.owner == gap.task.id for c in context.pool if c.tokens.stop <= gap.position)
    is_on = is_first and gap.preposition in ("on", "onto")
    if not is_on and not is_beside(context.observed.document, gap.tokens.start):
        return range(0)
    moved = (c for c in context.pool if c.owner == gap.task.id and c.type == "object" and not c.mention)
    return next((c.tokens for c in moved if _is_in_contrast(context, gap, c)), range(0))


def _is_in_contrast(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "the right one" or "another" may be of the kind of a phrase that itself says which one it is."""
    tokens, colours = context.observed.document.tokens, context.observed.gazetteer.colours
    words = [tokens[i].lower for i in gap.tokens]
    first, inner = tokens[candidate.tokens.start], range(candidate.tokens.start + 1, candidate.head)
    if tokens[candidate.head].tag in ("NNS", "NNPS"):
        return False
    if words == ["another"]:
        return first.lower in _ANY
    if words in (["the", "other"], ["the", "other", "one"]):
        return first.lower in _ANY or first.lower == "this"
    if len(words) != 3 or words[0] != "the" or words[2] != "one" or not inner:
        return False
    word = tokens[inner[-1]].lower
    return word != words[1] and (word in colours) == (words[1] in colours)


def _removed(context: Context, gap: Gap) -> range:
    """What was taken off or out where it is put back, or back on or in: "remove *the lid* from the jar, take a biscuit
    and put *it* back on"."""
    document = context.observed.document
    behind = [token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 2]]
    if gap.type != "object" or gap.word not in ("it", "them") or behind[:1] != ["back"]:
        return range(0)
    ways = {"on": ("off", "from"), "in": ("out", "from")}.get(behind[-1], ())
    end = gap.tokens.stop + 1 + bool(ways)
    is_whole = end >= len(document) or document.tokens[end].text in MARKS or document.tokens[end].lower == "and"
    if not is_whole or gap.task.type != "placing":
        return range(0)
    taken = [
        c
        for c in context.pool
        if c.type == "object"
        and c.task_type == "taking"
        and c.owner < gap.task.id
        and c.shape == "whole"
        and not c.mention
        and document.tokens[c.tokens.start].lower not in _ANY | {"some"}
        and (not ways or _is_taken(document, c, ways))
    ]
    if not ways and any(
        c.task_type == "change_state" and c.type == "object" and taken and taken[-1].owner < c.owner < gap.task.id
        for c in context.pool
    ):
        return range(0)  # "lift the chair off the mat, shake the mat out and put it back"
    is_plural = gap.word == "them"
    taken = [c for c in taken if (document.tokens[c.head].tag == "NNS") == is_plural]
    return taken[0].tokens if len(taken) == 1 else range(0)


def _is_taken(document: Document, candidate: Candidate, ways: Sequence[str]) -> bool:
    """Whether a thing was taken "off" or "out": the word stands behind it, or right ahead of it."""
    tokens = document.tokens
    stop = candidate.tokens.stop
    return (stop < len(document) and tokens[stop].lower in ways) or tokens[candidate.tokens.start - 1].lower == ways[0]


def _lacked(context: Context, gap: Gap) -> range:
    """What there is too little of where some is asked for: "the printer is out of *toner*; get *some*"."""
    tokens = context.observed.document.tokens
    if gap.type != "object" or [tokens[i].lower for i in gap.tokens] != ["some"]:
        return range(0)
    pairs = [(one.lower, other.lower) for one, other in pairwise(tokens[: gap.position])]
    at = next((i for i in range(len(pairs) - 1, -1, -1) if pairs[i] in _OUT_OF), None)
    if at is None or tokens[at].head >= at or tokens[tokens[at].head].lemma not in _BEING_WITHOUT:
        return range(0)
    named = [c for c in context.pool if c.tokens.start == at + 2 and c.tokens.stop <= gap.position]
    return min((c.tokens for c in named if "cut" not in c.shape), key=len, default=range(0))


def _vessel(context: Context, gap: Gap) -> range:
    """Some place that serves, right behind which it is asked if there is one: "put the soup in *a bowl* if there's a
    clean *one*", where another soup would do nothing for it."""
    tokens, order = context.observed.document.tokens, gap.task.id - 1
    is_asked = gap.form == "one" and gap.type == "object" and asks_there_is(context.observed.document, gap.task)
    if not is_asked or context.types.get(order) not in PUTTING or tokens[gap.tokens.start].lower in ("the", "another"):
        return range(0)
    named = [c for c in context.pool if c.owner == order and not c.mention and c.tokens.stop <= gap.position]
    places = [c for c in named if c.type == "goal" and c.shape in ("whole", "short", "long")]
    is_known = all(tokens[c.tokens.start].lower not in _ANY | {"some"} for c in named if c.type == "object")
    is_some = bool(places) and is_known and tokens[places[0].tokens.start].lower in _ANY
    return min((c.tokens for c in places), key=len) if is_some else range(0)


def _like_it(context: Context, gap: Gap) -> range:
    """What is put somewhere, right behind which it is asked if there is one there already: "put *the lamp* on the desk
    if there isn't *one* there"."""
    document, order = context.observed.document, gap.task.id - 1
    is_asked = gap.form == "one" and len(gap.tokens) == 1 and asks_there_is(document, gap.task)
    places = [document.indices(a.span) for a in gap.task.arguments if a.type == "location" and a.span]
    is_there = any(document.tokens[i].lower in ("there", "it") for words in places for i in words)
    if not is_asked or not is_there or gap.type != "object" or context.types.get(order) != "placing":
        return range(0)
    things = [c for c in context.arguments(order, "object") if not c.mention]
    things = [c for c in things if c.shape in ("whole", "short") and document.tokens[c.head].tag in ("NN", "NNP")]
    return things[0].tokens if len(things) == 1 else range(0)


def _shared(context: Context, gap: Gap) -> range:
    """What a case is of where so much of "it" is meant right behind: "if *the tea* is cold, pour half of *it* away"."""
    path = context.paths.get(gap.task.id, ())
    is_share = gap.form == "part" and gap.word == "it" and gap.type == "object" and gap.is_certain
    if not is_share or not path or path[-1] != (gap.task.id - 1, "then"):
        return range(0)
    asked = [c for c in context.arguments(gap.task.id - 1, "object") if not c.mention and c.shape in ("whole", "long")]
    return asked[0].tokens if len(asked) == 1 and kind_of(context, asked[0]) not in ANIMATE else range(0)


def _lies_within(tokens: range, spans: Sequence[range]) -> bool:
    return any(tokens.start in span and tokens[-1] in span for span in spans)


def _told(context: Context, gap: Gap) -> range:
    """What a message says is ready or somewhere, where the order right behind it, or behind a case of who is told, goes
    on about a thing and none was named before: "tell Ann *dinner*'s ready; if she doesn't come, take *it* up"."""
    document = context.observed.document
    if gap.type != "object" or gap.task.type == "check_state" or len(gap.tokens) != 1:
        return range(0)
    before = next((task for task in reversed(context.tasks[: gap.task.id - 1]) if task.type != "check_state"), None)
    subject = subject_of(document, before) if before is not None else range(0)
    if not subject or not number_of(document, gap.word, subject):
        return range(0)
    things = (c for c in context.pool if c.type in ("object", *PLACES) and c.tokens.stop <= gap.position)
    is_only = all(kind_of(context, c) in ANIMATE for c in things if c.owner != gap.task.id)
    found = any(c.tokens == subject and not c.mention for c in context.pool)
    return subject if is_only and found else range(0)


def _any_of_it(context: Context, gap: Gap) -> range:
    """What is made or brought by the order on which it hangs whether there is any: "make a pot of *tea* unless there
    isn't *any*"."""
    document, order = context.observed.document, gap.task.id - 1
    is_asked = gap.word == "any" and len(gap.tokens) == 1 and asks_there_is(document, gap.task)
    is_new = context.first.get(gap.task.id) == gap.task.id and context.paths.get(order, ())[-1:] != ()
    if not is_asked or not is_new or context.paths[order][-1][0] != gap.task.id or context.types[order] not in _MAKING:
        return range(0)
    named = [c for c in context.arguments(order, "object") if not c.mention and not c.shape.endswith("list")]
    # "heat the soup and bring me a plate if there's any" is of no plate
    some = [c for c in named if document.tokens[c.tokens.start].lower not in _ANY and c.head == c.tokens.stop - 1]
    return min((c.tokens for c in some), key=lambda words: (-words.stop, len(words)), default=range(0))


def _renewed(context: Context, gap: Gap) -> range:
    """What was changed for another, where it is said what becomes of the old one: "change *the bulb* in the hall and
    bin the old *one*"."""
    words = [context.observed.document.tokens[i].lower for i in gap.tokens]
    is_worn = len(words) == 3 and words[0] == "the" and words[1] in _WORN and words[2] in ONES
    if gap.form != "one" or not is_worn:
        return range(0)
    changed = [
        c
        for c in context.pool
        if c.type == "object"
        and not c.mention
        and c.owner < gap.task.id
        and c.shape in ("whole", "short")
        and context.lemmas.get(c.owner, "").split()[:1] in _CHANGING
    ]
    return changed[-1].tokens if changed else range(0)
