"""Fitness: what a state or an act cannot be of, be it named ever so near: a plate on which something is put is not what
is too hot, a counter that is wiped is not what gets warm, a pen that is looked for in a drawer is not what is empty."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.insides import has_inside
from decomplex_bt.understanding.references.phrases import Candidate

_PLACES = frozenset(("goal", "location"))
_WASHING = frozenset("wash rinse iron fold peel taste wrap unwrap weigh slice carve".split())
"""What is done to things that are put somewhere, seldom to where they are put."""
_TIMES = frozenset(("before", "after"))
_NEAR = 3
"""So many words ahead of a verb at most tell when that is done ("before you have put")."""
_TEMPERATURES = frozenset("hot warm cold cool lukewarm scalding".split())
_BOILING = frozenset(("boiling", "boiled", "simmering"))
_DONE = frozenset("cooked baked thawed ironed folded peeled ripe stale mouldy sour".split())
_WORN = frozenset("torn ripped creased wrinkled crumpled frayed".split())
"""States of what is made of cloth or paper, which nothing is put on."""
_WARM = frozenset("hot warm boiling boiled heated preheated toasty ready".split())
_WARMED = frozenset("pan pot saucepan wok skillet griddle grill barbecue bath bathtub tub pool".split())
"""What is hot or cold itself, beside what has a switch."""
_COOKERS = frozenset("oven stove hob grill barbecue pan pot saucepan wok skillet griddle".split())
"""What cooks, and is done itself at no time of its own."""
_WHEN = frozenset("if unless when once until till".split())
_HEATING = frozenset("heat warm boil reheat preheat cook bake fry roast toast grill brew make thaw defrost".split())
_IDLE = frozenset("clean wipe mop sweep scrub vacuum hoover dust polish tidy clear rinse open close shut lock".split())
"""What makes nothing warm."""
_ON = frozenset(("on", "up"))
_FILLED = frozenset(("full", "empty"))
_MOVING = frozenset(("placing", "bringing", "taking"))
_WHERE = frozenset(("goal", "source", "location"))
_LOCKED = frozenset(("locked", "unlocked"))
_LOCKABLE = frozenset(
    "door gate shed garage car van boat caravan house flat office cellar attic room cabin barn greenhouse workshop "
    "cabinet cupboard safe locker drawer chest trunk boot box toolbox suitcase case briefcase bike bicycle scooter "
    "phone tablet laptop computer church shop school gym store lift window padlock cage hatch pantry bathroom toilet "
    "basement hut studio library building truck".split()
)
_OPEN = frozenset("open closed shut".split())
WITH_HOURS = frozenset(
    "office library shop church school gym store bank pharmacy clinic museum bakery cafe caf\u00e9 laundrette "
    "restaurant canteen cafeteria reception surgery market kiosk lounge bookshop chapel".split()
)
"""Places that are open at some hours."""
_SURFACES = frozenset("table desk shelf rack bench counter worktop windowsill sideboard sofa couch bed".split())
"""What is full where nothing more fits on it."""
_FLAT = frozenset("plate saucer book towel blanket letter plant lamp cushion".split())
"""What is never full."""
_TAKEN = frozenset(("occupied", "engaged", "vacant"))
_SEATS = frozenset("seat chair bench stool sofa armchair bed cubicle toilet loo lavatory shower cell space".split())
"""What somebody is in or on, beside rooms."""
_EMPTY = frozenset(("empty", "bare", "emptied"))
_READY_TO_COOK = frozenset(("preheated", "heated"))
VESSELS = frozenset(
    "bottle can tin cup mug glass jug jar carton pot pan kettle teapot thermos flask tank bucket pail vase bowl "
    "basket box bag bin case sack purse wallet packet pack tube tray basin tub canister cartridge dispenser feeder "
    "barrel crate chest trunk drawer cupboard cabinet wardrobe closet fridge freezer hamper toolbox letterbox mailbox "
    "lunchbox".split()
)
"""What holds something itself, of the domain or not."""
_HELD = frozenset(
    "milk juice lemonade beer wine water cream ketchup mustard mayonnaise jam honey syrup sauce cereal sugar salt "
    "flour coffee tea oil vinegar butter shampoo soap detergent bleach".split()
)
"""What is called by what it is for what it is in."""


def is_unfit(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is nothing that could be locked, closed, or full, beside a place named with it that could: "put *the
    bucket* in the shed unless *it*'s locked", "put *the cake* in the tin if *it* isn't full". What is put into an oven
    is not what is to be hot *enough* for it."""
    if gap.word != "it" or gap.type != "object" or gap.task.type != "check_state" or candidate.type != "object":
        return False
    if candidate.mention or candidate.task_type not in _MOVING or candidate.owner != gap.task.id - 1:
        return False
    words = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    places = [c for c in context.pool if c.owner == candidate.owner and c.type in _WHERE and not c.mention]
    if not words.isdisjoint(_LOCKED):
        return any(_has_lock(context, place) for place in places) and not _has_lock(context, candidate)
    tokens = context.observed.document.tokens
    noun = tokens[candidate.head].lemma
    if not words.isdisjoint(_OPEN) and any(tokens[place.head].lemma in WITH_HOURS for place in places):
        return noun not in VESSELS and not _has_lock(context, candidate)
    if "full" in words and any(tokens[place.head].lemma in _SURFACES for place in places):
        return noun in _FLAT or not _is_container(context, candidate)
    if not words.isdisjoint(_FILLED):
        able = [place for place in places if not _is_filled_by(context, gap, place, words)]
        return any(_is_container(context, place) for place in able) and not _is_container(context, candidate)
    is_heated_up = "enough" in words and not words.isdisjoint(_TEMPERATURES)
    is_heated_up = is_heated_up or not words.isdisjoint(_READY_TO_COOK)
    return is_heated_up and any(_gets_warm(context, place) for place in places) and not _gets_warm(context, candidate)


def is_support(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is no place where something is put, but that thing: "before placing *the statue* on the stand, rinse
    *it*", "don't put *the fish* on the plate unless *it*'s cold". A stove, a pan or a bath can itself be hot."""
    if gap.word != "it" or gap.type != "object" or candidate.type not in _PLACES or candidate.mention:
        return False
    check = (
        context.types.get(gap.task.id - 1) == "check_state"
    )  # "put the roast in the oven if Ann is in. When it's done"
    if candidate.task_type != "placing" or candidate.owner != gap.task.id - 1 - check:
        return False
    if not _is_one_put(context, candidate):
        return False
    tokens = context.observed.document.tokens
    if gap.task.type != "check_state":
        put = context.by_number[candidate.owner].span
        start = context.observed.document.indices(put).start
        is_timed = any(token.lower in _TIMES for token in tokens[max(0, start - _NEAR) : start])
        verb, *particles = context.lemmas[gap.task.id].split()
        return is_timed and verb in _WASHING and "out" not in particles
    words = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    if tokens[gap.tokens.start - 1].lower not in _WHEN:
        return False
    if not words.isdisjoint(_BOILING):
        return tokens[candidate.head].lemma not in _WARMED
    if not words.isdisjoint(_DONE | _WORN) or _is_filled_by(context, gap, candidate, words):
        return True
    if "done" in words:
        return tokens[candidate.head].lemma in _COOKERS
    return not words.isdisjoint(_TEMPERATURES) and not _gets_warm(context, candidate)


def is_unoccupied(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is nothing that somebody can be in or on, since a place that is "occupied" was named: "clean *the
    loo* and open the window, but if *it*'s occupied, ..."."""
    words = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    is_asked = gap.word == "it" and gap.type == "object" and gap.task.type == "check_state"
    if not is_asked or words.isdisjoint(_TAKEN) or _is_seat(context, candidate):
        return False
    return any(_is_seat(context, c) for c in context.pool if c.tokens.stop <= gap.position)


def is_emptied(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what was said to be empty, which is no reason to look for that: "if *the tin* is empty,
    look in the cupboard"."""
    if gap.task.type != "searching" or gap.type != "object" or gap.word:
        return False
    for check, side in context.paths.get(gap.task.id, ()):
        task = context.by_number[check]
        states = {word for a in task.arguments if a.type == "state" for word in a.value.lower().split()}
        if side == "then" and not states.isdisjoint(_EMPTY):
            heads = {context.observed.document.tokens[c.head].lemma for c in context.arguments(check, "object")}
            return context.observed.document.tokens[candidate.head].lemma in heads
    return False


def _is_seat(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    return noun in _SEATS or context.observed.gazetteer.category(noun) == "room"


def _is_filled_by(context: Context, gap: Gap, place: Candidate, states: set[str]) -> bool:
    """Whether a place that a sentence before puts a vessel or a drink in would be empty: "put the juice in *the
    fridge*. If *it*'s nearly empty, ..."."""
    document, gazetteer = context.observed.document, context.observed.gazetteer
    tokens = document.tokens
    things = [c for c in context.arguments(place.owner, "object") if not c.mention]
    is_held = any(tokens[c.head].lemma in VESSELS | _HELD for c in things)
    is_piece = gazetteer.category(tokens[place.head].lemma) == "furniture" and has_inside(context, place)
    is_apart = document.sentences[place.head] != document.sentences[gap.position]
    return "empty" in states and is_held and is_piece and is_apart


def is_unwarmed(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is nothing that was only cleaned, or only switched on to heat something else, since another thing
    was warmed: "turn *the oven* on and wipe the counter, and once *it*'s hot enough, ..."."""
    words = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    if gap.word != "it" or gap.task.type != "check_state" or words.isdisjoint(_WARM) or "dry" in words:
        return False
    last = max((task.id for task in context.tasks if task.id < gap.task.id and _warms(context, task.id)), default=0)
    owner = candidate.owner
    if not last or not owner or owner == last or candidate.mention or candidate.type not in {"object"} | _PLACES:
        return False
    is_idle = context.lemmas[owner].split()[0] in _IDLE
    if kind_of(context, candidate) in ANIMATE:
        return True  # "warm the milk if *the baby* is hungry, and when *it*'s warm, ..."
    return is_idle or (owner < last and _warms(context, owner) and not _is_heated(context, owner))


def is_content(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is no thing that was looked for somewhere, but where it was: "look for *a pen* in the drawer, and if
    *it*'s empty, ...". What is itself filled can be meant all the same."""
    words = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    if gap.word != "it" or gap.type != "object" or gap.task.type != "check_state" or words.isdisjoint(_FILLED):
        return False
    before = gap.task.id - 1
    if context.types.get(before) not in ("searching", "check_state") or candidate.type not in ("object", "outside"):
        return False
    places = (c for c in context.arguments(before, "location") if not c.mention)
    is_somewhere = any(_is_container(context, place) for place in places)
    return is_somewhere and not _is_container(context, candidate)


def _is_container(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    return (
        noun in VESSELS
        or "fill" in context.observed.gazetteer.changeable.get(noun, ())
        or has_inside(context, candidate)
    )


def _has_lock(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    gazetteer = context.observed.gazetteer
    return noun in _LOCKABLE or gazetteer.category(noun) == "room" or "aperture" in gazetteer.changeable.get(noun, ())


def _is_one_put(context: Context, place: Candidate) -> bool:
    """Whether a single thing is put at a place, which "it" can mean."""
    tokens = context.observed.document.tokens
    things = [c for c in context.arguments(place.owner, "object") if c.shape in ("whole", "long")]
    return len(things) == 1 and tokens[things[0].head].tag in ("NN", "NNP")


def _gets_warm(context: Context, candidate: Candidate) -> bool:
    noun = context.observed.document.tokens[candidate.head].lemma
    return noun in _WARMED or "power" in context.observed.gazetteer.changeable.get(noun, ())


def _warms(context: Context, number: int) -> bool:
    """Whether an order makes something warm: by its verb, or as it switches on what can be hot."""
    if _is_heated(context, number):
        return True
    task = context.by_number[number]
    things = [c for c in context.arguments(number, "object") if not c.mention]
    is_on = any(a.type == "state" and a.value.lower() in _ON for a in task.arguments)
    return task.type == "change_state" and is_on and any(_gets_warm(context, c) for c in things)


def _is_heated(context: Context, number: int) -> bool:
    return context.types[number] != "check_state" and context.lemmas[number].split()[0] in _HEATING
