"""Wholes: what is handled where a condition asks of a part of it, or of a flaw or something else on or in it."""

from __future__ import annotations

from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import Gap, says_there_is
from decomplex_bt.understanding.references.phrases import Candidate

_PARTS = frozenset(
    "lid leg zip zipper handle spout tyre tire wheel strap clasp hinge sleeve hem seam rim brake pedal saddle".split()
)
"""What comes along with the thing that it is part of."""
_APART = frozenset("off missing gone lost dirty".split())
"""States of parts that are, or may be, handled by themselves."""
_CARRYING = frozenset(("bringing", "placing"))
_CHARGING = frozenset(("charge", "recharge", "plug", "plug in"))
_CHARGED = frozenset(
    "phone mobile smartphone iphone tablet ipad laptop notebook watch headphones headset earbuds monitor scooter "
    "toothbrush shaver speaker kindle reader".split()
)
"""What is charged itself, where the battery of a camera is."""
_FLAWS = frozenset(
    "stain hole tear crack dent scratch mark spot rip mould mold rust dust dirt mud crumb grease limescale fluff "
    "hair".split()
)
_WORDS = frozenset("name initial address price date logo barcode signature monogram".split())
"""What is written on things."""
_WRITTEN_ON = frozenset("it them there list label tag card board".split())
_SOMETHING = frozenset(("something", "anything"))
_BARE = 2
"""Words of "the battery", which is no spare one."""
_OF_FLAWS = frozenset("wipe mop sweep clean scrub brush pick take get rub wash cut pull".split())
"""What is done to a flaw where it is done "up", "off" or "out"."""
_TO_FLAWS = frozenset("remove fix repair mend seal plug patch report fill darn tape glue".split())
_CLEANING = frozenset("wipe rinse clean wash mop sweep polish empty scrub dust".split())
_WIPING = frozenset("wipe mop sweep scrub".split())
_AWAY = frozenset(("up", "off", "out", "away"))
_ON = frozenset(("on", "in", "inside"))
_HAVING = frozenset(("have", "get", "contain"))
_BESIDE = frozenset("under underneath beneath below above beside by near to behind".split())
"""What leads to where something stands by a thing, "next to" and "close to" among it."""
_HANDLING = _CARRYING | {"taking", "change_state"}


def is_part(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is no part that a condition asked of, since that is put nowhere without the thing that was handled
    before: "move the chair, and if *a leg* is loose, leave it here". A part that is off, or goes back on, can be."""
    noun = context.observed.document.tokens[candidate.head].lemma
    is_charged = noun == "battery" and len(candidate.tokens) <= _BARE and context.lemmas[gap.task.id] in _CHARGING
    is_carried = gap.type == "object" and gap.word == "it" and (gap.task.type in _CARRYING or is_charged)
    document, path = context.observed.document, context.paths.get(gap.task.id, ())
    is_of_whole = noun in _PARTS or noun == "battery"
    if not is_carried or not path or not is_of_whole or candidate.mention or _is_fitted(document, gap):
        return False
    check = context.by_number.get(candidate.owner, gap.task)
    is_asked = candidate.type == "object" and context.first.get(check.id) == path[-1][0]
    states = {word for a in check.arguments if a.type == "state" for word in a.value.lower().split()}
    if not is_asked or check.type != "check_state" or not states.isdisjoint(_APART):
        return False
    before = [c for c in context.pool if 0 < c.owner < check.id and not c.mention]
    wholes = [c.text.lower() for c in before if _is_whole(document, c)]
    if is_charged and not any(document.tokens[c.head].lemma in _CHARGED for c in before):
        return False
    goals = [a.value.lower() for a in gap.task.arguments if a.type == "goal"]
    is_of_its_own = any(document.tokens[c.head].lemma == noun for c in before)
    return bool(wholes) and not is_of_its_own and not any(whole in goal for whole in wholes for goal in goals)


def is_on_whole(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is no flaw that is on or in something, but that ("if there's *a stain* on the shirt, wash it"), nor
    something that is on what is cleaned ("if there's *something* on the table, wipe it"). A flaw may be wiped off."""
    document = context.observed.document
    is_taken_up = gap.type == "object" and gap.word in ("it", "them", "one", "ones") and candidate.type == "object"
    check = context.by_number.get(candidate.owner)
    if not is_taken_up or check is None or check.type != "check_state" or not says_there_is(document, check):
        return False
    if not any(a.type == "location" for a in check.arguments):
        return False
    verb = context.lemmas[gap.task.id].split()[0]
    if candidate.text.lower() in _SOMETHING:
        return verb in _CLEANING
    behind = {token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 1]}
    is_undone = verb in _TO_FLAWS or (verb in _OF_FLAWS - {"take"} and not behind.isdisjoint(_AWAY))
    return document.tokens[candidate.head].lemma in _FLAWS and not is_undone


def is_written(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what is written on or in something, which nobody moves or asks the state of: "whose is
    this bag? If *Ann's name* is in it, put *it* on her hook". It may be peeled off, or put where it is not yet."""
    check = context.by_number.get(candidate.owner)
    is_taken_up = gap.type == "object" and gap.word in ("it", "them") and candidate.type == "object"
    if not is_taken_up or check is None or check.type != "check_state" or check.id >= gap.task.id:
        return False
    document = context.observed.document
    behind = document.tokens[gap.tokens.stop : gap.tokens.stop + 1]
    is_off = any(token.lower in _AWAY - {"up"} for token in behind) and gap.task.type == "taking"
    goals = {a.value.lower().split()[-1] for a in gap.task.arguments if a.type == "goal"}
    is_missing = (check.id, "else") in context.paths.get(gap.task.id, ())
    if is_off or (is_missing and (not goals or not goals.isdisjoint(_WRITTEN_ON))):
        return False
    is_moved = gap.task.type in _CARRYING | {"taking"}
    is_asked = gap.task.type == "check_state" and any(a.type == "state" for a in gap.task.arguments)
    is_whole = candidate.head == candidate.tokens.stop - 1 or bool(candidate.mention)
    is_word = is_whole and document.tokens[candidate.head].lemma in _WORDS
    return is_word and (is_moved or is_asked) and any(a.type == "location" for a in check.arguments)


def own_subject(context: Context, gap: Gap) -> range:
    """What has something on or in it where that is asked: "if *the shirt* has stains on *it*"; empty elsewhere."""
    is_on = gap.type == "location" and gap.word in ("it", "them") and gap.preposition in _ON
    if not is_on or gap.task.type != "check_state":
        return range(0)
    tokens = context.observed.document.tokens
    own = [c for c in context.arguments(gap.task.id, "object") if c.mention or c.shape in ("whole", "long")]
    own = [c for c in own if tokens[c.tokens.stop : c.tokens.stop + 1] and c.tokens.stop < gap.position]
    for subject in own:
        having = next((i for i in range(subject.tokens.stop, gap.position) if tokens[i].lemma in _HAVING), None)
        is_near = having is not None and having <= subject.tokens.stop + 2
        if is_near and any(t.pos in ("NOUN", "PROPN") for t in tokens[subject.tokens.stop : gap.position]):
            return subject.tokens
    return range(0)


def is_beside_part(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether something would be put under or beside what is only a part, with an "its", of the thing that was spoken
    of: "press its button and stand the stool under *it*"."""
    tokens = context.observed.document.tokens
    is_beside = gap.type in ("goal", "location") and gap.word == "it" and gap.preposition in _BESIDE
    is_own = not candidate.mention and tokens[candidate.tokens.start].lower == "its"
    return is_beside and is_own and gap.task.type in ("placing", "bringing", "motion")


def whole_meant(context: Context, gap: Gap) -> range:
    """What has the flaw that is asked after, of which "the grey one" is another: "if there's a hole in *the blue
    blanket*, bring me *the grey one*"; empty where there is none such."""
    document, path = context.observed.document, context.paths.get(gap.task.id, ())
    check = context.by_number.get(path[-1][0]) if path else None
    is_another = gap.form == "one" and gap.type == "object" and len(gap.tokens) > 1
    if not is_another or check is None or check.type != "check_state" or not says_there_is(document, check):
        return range(0)
    own = [c for c in context.pool if c.owner == check.id and not c.mention and c.shape in ("whole", "short", "long")]
    has_flaw = any(c.type == "object" and document.tokens[c.head].lemma in _FLAWS for c in own)
    places = [c.tokens for c in own if c.type == "location"]
    return min(places, key=len) if has_flaw and places else range(0)


def is_not_on_it(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether what is wiped is neither what a condition right ahead found nor where that is: "shut *the freezer*, and
    if there's water on the floor mop *it* up"."""
    path = context.paths.get(gap.task.id, ())
    is_wiped = gap.type == "object" and gap.word == "it" and context.lemmas[gap.task.id].split()[0] in _WIPING
    if not is_wiped or not path or path[-1] != (gap.task.id - 1, "then") or candidate.owner == gap.task.id - 1:
        return False
    check = context.by_number[gap.task.id - 1]
    is_found = says_there_is(context.observed.document, check) and any(a.type == "location" for a in check.arguments)
    return is_found and check.type == "check_state"


def _is_fitted(document: Document, gap: Gap) -> bool:
    """Whether something is put "back", "off" or "on": "put it back on", "leave it on"."""
    behind = [token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 2]]
    return behind[:1] in (["back"], ["off"]) or (behind[:1] == ["on"] and {*behind[1:]} <= MARKS | {"and"})


def _is_whole(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate is a single thing that was handled or looked at."""
    is_handled = candidate.task_type in _HANDLING and candidate.type == "object"
    is_looked_at = candidate.task_type == "searching" and candidate.type in ("object", "location")
    return (is_handled or is_looked_at) and document.tokens[candidate.head].tag in ("NN", "NNP")
