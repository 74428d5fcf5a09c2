"""Switching: what is switched on or off, or shut, is what can be, and not what is in, on or beside it: "lift *the wok*
off the stove and turn *it* off", "get *the butter* out of the fridge and close *it*"."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.instruction import Argument, Span, Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import stripped
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.fitness import VESSELS
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.insides import has_inside, is_said_open
from decomplex_bt.understanding.references.phrases import Candidate

_SWITCHES = frozenset(
    "adapter aircon alarm amplifier blanket blender boiler breadmaker breaker burner camera car charger clock "
    "compressor console cooler dehumidifier dehydrator diffuser drier drill dryer engine extractor fireplace "
    "flashlight fountain freezer fridge fryer furnace generator geyser grill grinder hairdryer headphones headset "
    "hoover hose hosepipe humidifier immersion iron kettle kiln knob laminator lantern laptop mixer mobile modem "
    "monitor motor mower phone player plotter printer processor projector propagator pump purifier remote ring "
    "robot router samovar sauna scanner scooter screen shaver shower speaker sprinkler steamer steriliser "
    "sterilizer switch tablet tap telephone thermostat timer toaster toothbrush torch tractor truck vacuum valve "
    "van warmer watch wireless".split()
)
"""What has a switch, a plug, a tap or an ignition, beside what the domain knows."""
_TURNING = frozenset("turn switch flick flip knock".split())
_LEAVING = frozenset(("leave", "keep"))
_STARTING = frozenset("start stop restart".split())
_ON_OR_OFF = frozenset(("on", "off"))
_SHUTTING = frozenset(("close", "shut"))
_FOLDING = frozenset("book umbrella parasol laptop piano lid pen notebook diary album".split())
"""What is shut itself, and no opening of anything."""
_LOCKING = frozenset("lock unlock bolt".split())
_LOCKED = frozenset(
    "bicycle bike box briefcase case cash chest cabinet car caravan cupboard desk drawer locker moped motorbike phone "
    "safe scooter suitcase tablet trunk van wheelchair".split()
)
"""What has a lock, and is no room or building."""
_ROOFED = frozenset("shed garage barn cabin hut greenhouse summerhouse workshop stable cellar attic house".split())
"""Where things are kept and what is locked, of which no room is known to the domain."""
_HANDLING = frozenset(("placing", "taking", "bringing"))
_TOLD = frozenset(("location", "source", "goal"))


def is_unswitched(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is switched on or off, or started, and a candidate cannot be, beside a thing that can."""
    if gap.word != "it" or gap.type != "object" or _has_switch(context, candidate):
        return False
    verb = context.lemmas[gap.task.id].split()[0]
    is_set = any(a.type == "state" and a.value.lower().split()[-1] in _ON_OR_OFF for a in gap.task.arguments)
    if not (verb in _STARTING or (is_set and verb in _TURNING | _LEAVING)):
        return False
    devices = [c for c in context.pool if c.tokens.stop <= gap.position and _has_switch(context, c)]
    if verb in _LEAVING:
        return any(c.owner and c.type == "object" and _is_switched_by(context, c.owner) for c in devices)
    return any(_is_beside(context, gap, candidate, device) for device in devices)


def is_unshut(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is closed, and a candidate is only what was in the thing that can be, or no thing that is open."""
    is_shut = gap.word == "it" and gap.type == "object" and context.lemmas[gap.task.id].split()[0] in _SHUTTING
    if is_shut and candidate.task_type in _HANDLING and _is_open_there(context, gap, candidate):
        return True
    noun = context.observed.document.tokens[candidate.head].lemma
    if _is_unlocked(context, gap, candidate, noun):
        return True
    if not is_shut or noun in VESSELS | _FOLDING or "aperture" in context.observed.gazetteer.changeable.get(noun, ()):
        return False
    places = (
        c for c in context.pool if c.tokens.stop <= gap.position and has_inside(context, c) and c.head != candidate.head
    )
    return any(_is_beside(context, gap, candidate, place) and _is_place(place) for place in places)


def _is_unlocked(context: Context, gap: Gap, candidate: Candidate, noun: str) -> bool:
    """Whether "it" is locked, and a candidate is what was put in the place that can be: "take *the ladder* to the shed
    and lock *it*"."""
    is_locked = gap.word == "it" and gap.type == "object" and context.lemmas[gap.task.id].split()[0] in _LOCKING
    gazetteer = context.observed.gazetteer
    is_handled = candidate.task_type in _HANDLING and candidate.type == "object"
    if not is_locked or not is_handled or noun in _LOCKED | _ROOFED or "aperture" in gazetteer.changeable.get(noun, ()):
        return False
    tokens = context.observed.document.tokens
    places = (c for c in context.pool if c.tokens.stop <= gap.position and c.type in _TOLD)
    able = (c for c in places if tokens[c.head].lemma in _ROOFED or gazetteer.category(tokens[c.head].lemma) == "room")
    return any(_is_beside(context, gap, candidate, place) for place in able)


def _is_open_there(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether another thing than the one that was handled is open in the case in which "it" is closed: "if the safe is
    open, put *the ring* inside and close *it*"."""
    checks = [check for check, side in context.paths.get(gap.task.id, ()) if side == "then"]
    return any(
        is_said_open(context, check) and any(c.head != candidate.head for c in context.arguments(check, "object"))
        for check in checks
    )


def is_stated_place(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a place that a statement tells right ahead of an order, which is about that very place:
    "the shirts are in *the dryer*, so start *it*"."""
    tokens, verb = context.observed.document.tokens, context.observed.document.indices(gap.task.span).start
    is_told = candidate.owner == gap.task.id and candidate.type in _TOLD and candidate.tokens.stop <= verb
    return (
        is_told
        and gap.task.type == "change_state"
        and any(tokens[i].text in MARKS or tokens[i].lower in ("so", "and") for i in range(candidate.tokens.stop, verb))
    )


def without_own_place(document: Document, task: Task, arguments: Sequence[Argument]) -> list[Argument]:
    """The arguments of a task; where the place that is stated ahead of an order is what the order is about, it is in no
    such place."""
    meant = {a.value.lower() for a in arguments if a.type == "object" and a.span and len(document.indices(a.span)) == 1}
    return [
        a
        for a in arguments
        if a.type not in _TOLD
        or a.span is None
        or a.span.start > task.span.start
        or task.type != "change_state"
        or _named(document, a.span) not in meant
    ]


def _named(document: Document, span: Span) -> str:
    inner = stripped(document, document.indices(span))
    return document.span(inner.start, inner.stop - 1).of(document.text).lower()


def _is_beside(context: Context, gap: Gap, candidate: Candidate, device: Candidate) -> bool:
    """Whether a device is named with what is in or on it, or in the order before."""
    is_part = device.tokens.start < candidate.tokens.stop and candidate.tokens.start < device.tokens.stop
    if is_part or device.shape.endswith("cut"):
        return False
    named = {c.owner for c in context.pool if c.text == candidate.text}  # "put the pie in the oven. When *it*'s done, "
    if device.owner and device.owner in (named | {gap.task.id, gap.task.id - 1}):
        return True
    of = context.observed.document.sentences
    return not device.owner and of[device.head] == of[candidate.head]


def _is_place(place: Candidate) -> bool:
    return place.type in _TOLD or not place.owner


def _is_switched_by(context: Context, number: int) -> bool:
    """Whether an order switches something on or off."""
    task = context.by_number[number]
    return task.type == "change_state" and any(
        a.type == "state" and a.value.lower() in _ON_OR_OFF for a in task.arguments
    )


def _has_switch(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    return noun in _SWITCHES or "power" in context.observed.gazetteer.changeable.get(noun, ())
