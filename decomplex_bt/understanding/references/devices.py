"""Devices: what is heated, chilled or washed is what was put into something for it, not that ("put the pie in the oven
and heat *it*"), and what is brought wrapped is not what it is wrapped in."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_DOING = frozenset(
    "heat warm reheat microwave cook bake fry grill roast toast boil steam poach simmer thaw defrost melt chill cool "
    "freeze refrigerate wash launder rinse spin dry soak bleach charge recharge".split()
)
"""What a device, a stove or a basin does to what is put there."""
_OF_ITSELF = frozenset("defrost dry rinse wash".split())
"""What is done to a device, too, once it is empty."""
_FUEL = frozenset("wood log coal firewood kindling briquette pellet charcoal peat gas oil petrol water match".split())
"""What is put somewhere to heat that."""
_WITHIN = frozenset("in into inside on onto over under".split())
_WRAPPING = frozenset("wrap roll bundle swaddle tuck".split())
_WHERE = frozenset(("goal", "location"))
_MOVING = frozenset(("bringing", "taking", "placing"))
_PRONOUNS = {"it": frozenset(("NN", "NNP")), "that": frozenset(("NN", "NNP")), "them": frozenset(("NNS", "NNPS"))}


def is_device(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is where something was put that is then heated, chilled, washed or the like, or what the
    thing was wrapped in that is then brought. An oven that is to be heated "to 200 degrees" may be meant, and so may a
    stove in which wood was put."""
    if gap.word not in _PRONOUNS or gap.type != "object" or len(gap.tokens) != 1 or candidate.mention:
        return False
    if candidate.type not in _WHERE or candidate.owner >= gap.task.id:
        return False
    put = context.by_number.get(candidate.owner)
    if put is None or put.type != "placing" or not _has_thing(context, gap, candidate):
        return False
    if context.lemmas[put.id].split()[0] in _WRAPPING:
        return gap.task.type in _MOVING and gap.task.id == put.id + 1
    verb, *particles = context.lemmas[gap.task.id].split()
    if gap.task.type != "change_state" or verb not in _DOING or "out" in particles:
        return False
    tokens, behind = context.observed.document.tokens, gap.tokens.stop
    is_set = any(token.lower == "to" for token in tokens[behind : behind + 1])
    between = (context.types[number] for number in range(put.id + 1, gap.task.id))
    is_emptied = verb in _OF_ITSELF and not {"taking", "bringing"}.isdisjoint(between)
    return not is_set and not is_emptied and tokens[candidate.tokens.start - 1].lower in _WITHIN


def _has_thing(context: Context, gap: Gap, place: Candidate) -> bool:
    """Whether a thing of the number that a pronoun tells is put at a place, and no fuel."""
    tokens = context.observed.document.tokens
    things = [c for c in context.arguments(place.owner, "object") if c.shape in ("whole", "long") or c.mention]
    return any(
        (tokens[c.head].tag in _PRONOUNS[gap.word] or c.mention == gap.word)
        and tokens[c.head].lemma not in _FUEL
        and kind_of(context, c) not in ANIMATE
        for c in things
    )
