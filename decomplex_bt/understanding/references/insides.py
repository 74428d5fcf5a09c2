"""Insides: what "inside" and "in there" are the inside of."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap, last_word
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import PASSAGES

_PERSONAL = frozenset("he him she her they you somebody someone anybody anyone everybody everyone nobody".split())
_UNCLOSING = frozenset(("open", "unlock", "unzip"))
_OPEN = frozenset(("open", "unlocked", "ajar"))
_COVERS = PASSAGES | {"curtain", "blind", "lid", "skylight", "tap"}
"""What is opened and has no inside of its own."""


def containers_of(context: Context, gap: Gap) -> list[Candidate]:
    """What "inside" or "in there" is the inside of: what has one and is named in the same task, the one before or,
    where "there" can be nothing before, the one after.

    Empty where that is nothing, and where it is somebody who is inside: they are in the house.
    """
    is_inside = gap.word == "inside" or (gap.word == "there" and gap.preposition == "in")
    if gap.type == "goal":
        is_put_in = not gap.word and _is_put_in(context, gap)
        return _opened(context, gap) or _found_open(context, gap) if is_inside or is_put_in else []
    if not is_inside or gap.type not in ("location", "source"):
        return []
    tokens = context.observed.document.tokens
    said = [context.observed.document.indices(a.span) for a in gap.task.arguments if a.type == "object" and a.span]
    if any(tokens[i].lower in _PERSONAL for words in said for i in words):
        return []
    own = [c for c in context.pool if c.owner == gap.task.id and c.type == "object"]
    if any(kind_of(context, candidate) in ANIMATE for candidate in own):
        return []
    able = [c for c in context.pool if c.owner and has_inside(context, c) and c.tokens != gap.tokens]
    if gap.task.type == "searching" and (opened := _unclosed(context, gap.task.id - 1)):
        return opened
    near = [range(gap.task.id - 1, gap.task.id + 1), range(gap.task.id + 1, gap.task.id + 2)]
    return next(
        (
            found
            for tasks in near[: 1 + (gap.word == "inside" or gap.task.id == 1)]
            if (found := [c for c in able if c.owner in tasks])
        ),
        [],
    )


def _is_put_in(context: Context, gap: Gap) -> bool:
    """Whether something is put in without a word of where: "put the pears *in*", "lay *in* the new ones"."""
    document = context.observed.document
    behind = document.tokens[gap.position + 1 :][:1]
    return last_word(document, gap.position) == "in" or any(token.lower == "in" for token in behind)


def _opened(context: Context, gap: Gap) -> list[Candidate]:
    """What the order before opens, where something is put in, be it after other things were taken out: "open *the
    trunk* and put the bags *inside*", "open *the case*, take out the old cards and put in the new ones"."""
    before = gap.task.id - 1
    while context.types.get(before) == "taking" and _is_taken_out(context, before):
        before -= 1
    return _unclosed(context, before) if gap.task.type == "placing" else []


def _unclosed(context: Context, number: int) -> list[Candidate]:
    """What an order opens that has an inside: "open *the tin* and look *inside*"."""
    is_opened = context.types.get(number) == "change_state" and context.lemmas[number].split()[0] in _UNCLOSING
    return _with_an_inside(context, number) if is_opened else []


def _is_taken_out(context: Context, number: int) -> bool:
    """Whether something is taken out without a word of what it is in."""
    is_told = bool(context.arguments(number, "source"))
    task = context.by_number[number]
    document = context.observed.document
    verb = document.indices(task.span).start
    is_out = "out" in context.lemmas[number].split()[1:] or last_word(document, verb) == "out"
    return is_out and not is_told


def _found_open(context: Context, gap: Gap) -> list[Candidate]:
    """What is open in the case in which something is put in: "is *the trunk* open? If yes, put the bags *inside*"."""
    path = context.paths.get(gap.task.id, ())
    is_found = bool(path) and path[-1] == (gap.task.id - 1, "then") and is_said_open(context, gap.task.id - 1)
    return _with_an_inside(context, gap.task.id - 1) if gap.task.type == "placing" and is_found else []


def is_said_open(context: Context, number: int) -> bool:
    """Whether a check asks if something is open."""
    check = context.by_number.get(number)
    if check is None or check.type != "check_state":
        return False
    return any(a.type == "state" and a.value.lower().split()[-1] in _OPEN for a in check.arguments)


def _with_an_inside(context: Context, number: int) -> list[Candidate]:
    """What a task is about, as far as it is no door or window."""
    tokens = context.observed.document.tokens
    return [
        c
        for c in context.arguments(number, "object")
        if not c.shape.startswith("in.")
        and tokens[c.head].lemma not in _COVERS
        and not (c.shape == "short" and tokens[c.tokens.stop].lower == "of")  # "the boot of the car"
    ]


def has_inside(context: Context, candidate: Candidate) -> bool:
    """Whether a phrase names what the domain knows as a container."""
    words = candidate.text.lower().split()
    return any(" ".join(words[i:]) in context.observed.gazetteer.containers for i in range(len(words)))
