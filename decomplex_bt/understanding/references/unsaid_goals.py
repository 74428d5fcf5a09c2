"""Unsaid goals: where something is not put "in" or "on", be it the place that was named last (nothing goes into what it
was just taken out of, into what was taken out itself, or into its like), and where it is put "instead"."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import Context, kind_of
from decomplex_bt.understanding.references.fitness import VESSELS
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.insides import has_inside
from decomplex_bt.understanding.references.phrases import Candidate

_STIRRED = frozenset("stir drain taste whisk serve eat drink".split())
"""What is done with food, which nothing is put on or in for good."""
_LAYING = frozenset("set lay spread".split())
"""What is done with things in no vessel."""
_GETTING = frozenset(("searching", "taking", "bringing"))
_RENEWED = frozenset(("ones", "one", "some", "another"))
_INTO = frozenset(("in", "inside"))
_JOINING = frozenset("and but or then if unless when before after until".split())


def is_no_goal(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether an unsaid goal cannot be a candidate: "take *the tart* out of the oven and put the loaf in", "get the
    bulbs out of *the drawer* and put them in", "pull the plug out of *the sink* and hang the towels up"."""
    if gap.type != "goal" or gap.word or gap.task.type != "placing" or not candidate.owner:
        return False
    verb, said = context.lemmas[gap.task.id].split()[0], _said(context.observed.document, gap.position)
    is_in = not said.isdisjoint(_INTO)
    things = context.arguments(gap.task.id, "object")
    if candidate.type == "object" and any(_is_alike(c, candidate) for c in things):
        return True
    if verb in _LAYING and not is_in and (has_inside(context, candidate) or candidate.task_type == "placing"):
        return has_inside(context, candidate) or candidate.type == "object"
    if candidate.head in context.verbs and candidate.head == candidate.tokens.start:  # "if its bulb's *gone*"
        return True
    is_renewed = any(c.mention in _RENEWED for c in things)  # in what it is a part of
    if candidate.type == "object" and not is_renewed and not _holds(context, candidate):
        is_from = bool(context.arguments(candidate.owner, "source"))
        is_out = is_from or "out" in context.lemmas[candidate.owner].split()[1:]
        is_taken = candidate.task_type in ("taking", "bringing") and is_out and "on" not in said
        is_stirred = not _STIRRED.isdisjoint(context.lemmas.get(candidate.owner, "").split()[:1])
        is_somebody = kind_of(context, candidate) in ("person", "name") and candidate.head == candidate.tokens.stop - 1
        return is_taken or is_stirred or is_somebody
    if is_in and _is_where_it_lay(context, things, candidate):
        return True
    if candidate.type != "source" or candidate.mention or "back" in said or verb == "leave":
        return False
    tokens = context.observed.document.tokens
    before = [token.lower for token in tokens[max(0, candidate.tokens.start - 2) : candidate.tokens.start]]
    taken = {c.head for c in context.arguments(candidate.owner, "object")}
    is_same = any(c.head in taken for c in things)
    return before == ["out", "of"] and (is_same or (verb in _LAYING | {"hang"} and not is_in))


def _is_where_it_lay(context: Context, things: Sequence[Candidate], candidate: Candidate) -> bool:
    """Whether a candidate is where a thing was looked for or got, some of whose own are to be renewed: "look for the
    torch in *the drawer*; if the batteries are dead, put new ones in"."""
    is_renewed = any(c.mention in _RENEWED for c in things)
    is_place = candidate.type in ("location", "source") and candidate.task_type in _GETTING
    holding = context.arguments(candidate.owner, "object") if is_renewed and is_place else []
    tokens = context.observed.document.tokens
    heads = {tokens[c.head].lemma for c in things}
    return any(not c.mention and tokens[c.head].lemma not in heads for c in holding)


def goal_instead(context: Context, gap: Gap) -> range:
    """Where something else would have been put in the other case, where it is said how but not where: "put the pears in
    *the bowl*; if they are soft, put the figs *in instead*"; empty where there is no such place."""
    said = _said(context.observed.document, gap.position)
    ways = _INTO | {"into"} if "in" in said else {"on", "onto"} if "on" in said else frozenset()
    if gap.type != "goal" or gap.word or gap.task.type != "placing" or "instead" not in said or not ways:
        return range(0)
    tokens = context.observed.document.tokens
    goals = [
        c
        for c in context.pool
        if (c.task_type, c.type) == ("placing", "goal")
        and c.shape in ("whole", "long")
        and not c.mention
        and context.relation(c.owner, gap.task.id) == "exclusive"
        and c.tokens.start
        and (tokens[c.tokens.start - 1].lower in ways or (tokens[c.tokens.start - 1].pos == "VERB" and "in" in said))
    ]
    return goals[-1].tokens if goals else range(0)


def _said(document: Document, verb: int) -> set[str]:
    """The words of a clause behind its verb."""
    words = [token.lower for token in document.tokens[verb + 1 :]]
    return set(words[: next((i for i, word in enumerate(words) if word in MARKS | _JOINING), len(words))])


def _is_alike(thing: Candidate, candidate: Candidate) -> bool:
    """Whether two phrases name different things of one kind: a bag goes into no bag."""
    one, other = thing.text.lower(), candidate.text.lower()
    return one != other and one.split()[-1] == other.split()[-1]


def _holds(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    gazetteer = context.observed.gazetteer
    return (
        noun in VESSELS
        or has_inside(context, candidate)
        or "fill" in gazetteer.changeable.get(noun, ())
        or "power" in gazetteer.changeable.get(noun, ())
    )
