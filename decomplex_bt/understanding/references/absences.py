"""Absences: what a word cannot refer to since it is not there where something is done."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap, asks_there_is
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import ONES, ROOM

_ENDED = frozenset(("off", "down", "shut", "closed"))
_SOME = frozenset("a an any some another".split())
_PRONOUNS = frozenset("it them they 'em em him her".split())
_SPENT = frozenset("dead flat blown used gone missing broken faulty worn".split())
_WITHIN = frozenset("battery bulb fuse bait seed cartridge filter refill toner ink candle bag lightbulb".split())
"""What is put into something else, where it is used up."""
_BLEMISHES = frozenset("stain mark spot smudge scratch crack hole tear leak dent chip smell stink mould rust".split())
_SOAKING = frozenset("soak wash rinse iron fold".split())
"""What is done to the stained."""
_WRITTEN = frozenset(("list", "note"))


def is_absent(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what there is none of where something is switched off or shut: "if there is no steam, turn
    it off". It may well be fetched, made or put on a list."""
    if not any(a.type == "state" and a.value.lower() in _ENDED for a in gap.task.arguments):
        return False
    start = candidate.tokens.start
    words = {token.lower for token in context.observed.document.tokens[max(0, start - 1) : start + 1]}
    if "no" not in words:
        return False
    return context.relation(candidate.owner, gap.task.id).startswith("condition.else")


def is_of_other_case(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what is asked to be there at all, where it is not: "look in the mailbox. If there's *a
    parcel*, bring it in; if not, lock *it*"."""
    document = context.observed.document
    missing = {check for check, side in context.paths.get(gap.task.id, ()) if side == "else"}
    if not missing or gap.word not in _PRONOUNS or gap.task.type == "informing":
        return False
    if any(
        document.tokens[i].lower in _WRITTEN for a in gap.task.arguments if a.span for i in document.indices(a.span)
    ):
        return False
    if candidate.mention in ONES or (
        candidate.mention and context.relation(candidate.owner, gap.task.id) != "exclusive"
    ):
        return False  # "if there's no clean towel, take *one* from the dryer and hand *it* to him"
    checks = [task for task in context.tasks if task.id in missing and asks_there_is(document, task)]
    is_place = candidate.type == "location" and gap.type == "object" and not candidate.mention
    if is_place and gap.task.type in ("placing", "bringing"):
        asked = {c.owner for c in context.pool if c.type == "object" and document.tokens[c.head].lemma in ROOM}
        return candidate.owner in asked & {check.id for check in checks}  # "if there's no room *in the fridge*, eat it"
    return any(
        c.text.lower() == candidate.text.lower() and c.type == "object" and c.owner == check.id and _is_some(context, c)
        for check in checks
        for c in context.pool
    )


def is_used_up(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what is gone, dead or used up where another is put in: "if *the bait*'s gone, put some
    cheese in it", "if the battery is dead, put a new one in it"."""
    check = candidate.owner
    if gap.type != "goal" or gap.word not in ("it", "them") or gap.preposition not in ("in", "into", "on", "inside"):
        return False
    if candidate.type != "object" or not context.relation(check, gap.task.id).startswith("condition.then"):
        return False
    task = context.by_number[check]
    words = {word for a in task.arguments if a.type == "state" for word in a.value.lower().split()}
    is_over = context.lemmas[check].split() in (["run", "out"], ["go"], ["die"]) or "gone" in words
    noun = context.observed.document.tokens[candidate.head].lemma
    return is_over or (noun in _WITHIN and not words.isdisjoint(_SPENT))


def is_blemish(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what nobody asks for another of, or puts anywhere: "if *the stain* doesn't come off, bring
    me another one", "... soak *it* in the tub"."""
    tokens = context.observed.document.tokens
    is_another = any(tokens[i].lower == "another" for i in gap.tokens[:1])
    is_treated = gap.task.type in ("placing", "bringing") or context.lemmas[gap.task.id] in _SOAKING
    is_whole = candidate.head == candidate.tokens.stop - 1 or bool(candidate.mention)  # no "hole puncher"
    is_put = gap.word in _PRONOUNS and is_treated and is_whole
    is_place = gap.type == "goal" and not gap.word
    return (is_place or (gap.type == "object" and (is_another or is_put))) and tokens[
        candidate.head
    ].lemma in _BLEMISHES


def _is_some(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is one that need not be there: "a parcel", "a clean one"."""
    tokens, start = context.observed.document.tokens, candidate.tokens.start
    is_room = tokens[candidate.head].lemma in ROOM and start > 0 and tokens[start - 1].lower == "no"
    return candidate.mention in ONES or (not candidate.mention and (tokens[start].lower in _SOME or is_room))
