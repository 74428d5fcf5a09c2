"""Exclusions: what English settles that a gap does not refer to."""

from __future__ import annotations

from decomplex_bt.domain.clauses import WEATHER, is_air
from decomplex_bt.understanding.cue_phrases import WISHING
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.absences import is_absent, is_blemish, is_of_other_case, is_used_up
from decomplex_bt.understanding.references.agreement import (
    is_no_person,
    is_no_single_thing,
    is_of_other_gender,
    is_possessed,
    is_told_of_otherwise,
)
from decomplex_bt.understanding.references.asked_again import is_of_own_branch, is_other_again
from decomplex_bt.understanding.references.chunks import head_of
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.devices import is_device
from decomplex_bt.understanding.references.dismissals import is_dismissed
from decomplex_bt.understanding.references.fitness import (
    is_content,
    is_emptied,
    is_support,
    is_unfit,
    is_unoccupied,
    is_unwarmed,
)
from decomplex_bt.understanding.references.gapped import is_torn
from decomplex_bt.understanding.references.gaps import Gap, says_there_is
from decomplex_bt.understanding.references.offers import FILLING, is_filled_for, is_measured
from decomplex_bt.understanding.references.ones import is_not_one
from decomplex_bt.understanding.references.persons import is_lifeless, is_no_somebody, is_whence
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.references.pointing import is_named_later, is_not_shown
from decomplex_bt.understanding.references.roles import (
    ELSEWHERE,
    is_called_in,
    is_immovable,
    is_led,
    is_nobody,
    is_sought,
    is_where_else,
    is_where_from,
    is_within,
)
from decomplex_bt.understanding.references.switching import is_stated_place, is_unshut, is_unswitched
from decomplex_bt.understanding.references.undoing import is_means_of_it
from decomplex_bt.understanding.references.unsaid_goals import is_no_goal
from decomplex_bt.understanding.references.wholes import (
    is_beside_part,
    is_not_on_it,
    is_on_whole,
    is_part,
    is_written,
)
from decomplex_bt.understanding.vocabulary import AIRED, ONES, PLACE_ADVERBS, TIMES_OF_DAY, WARMTH

SOMEBODY = frozenset(("he", "him", "she", "her"))
_SAYING = frozenset("say answer reply choose pick".split())
MOVING = frozenset(("bringing", "taking", "placing"))
ACTS = (
    frozenset("turn switch start stop restart flick".split()),
    frozenset(("open", "close", "shut")),
    frozenset(("fill", "empty")),
)
"""Verbs that do the same or undo it."""
_SHUTTING = ACTS[1] | frozenset("pull push lock unlock bolt latch draw".split())
CLEANING = frozenset("clean wipe mop sweep scrub vacuum hoover dust brush dry polish rub soak swab dab".split())
"""What is done with one of the `INSTRUMENTS`, which is seldom done to one."""
_COOKED = frozenset("stir drain serve flip taste pour eat drink strain whisk peel slice".split())
"""What is done with food."""
_COOKING = frozenset("bake cook defrost fry grill reheat roast thaw toast".split())
_COOLING = frozenset("freezer fridge refrigerator icebox".split())
"""Of the machines those that are defrosted."""
_SKY = frozenset("cloud wind sun fog thunder sunshine".split())
"""What nobody takes or puts anywhere."""
_FELT = frozenset("draught draft breeze smell stink odour noise sound".split())
"""What nobody puts anything on, but on what it comes from: "if there's *a draught* from the hatch, lay a rug on it"."""
_SOCKETS = frozenset(("socket", "outlet"))
_MEANS = {"charge": _SOCKETS | {"cable", "dock"}, "plug": _SOCKETS}
"""By a verb, what it is done with."""
_NO_AGENTS = frozenset("shutter drawer locker".split())
"""What is called by what it does, and has it done to it all the same."""
_ABSENT = frozenset(("missing", "gone", "lost"))
_NOT_MEANT = (
    is_absent, is_of_other_case, is_used_up, is_device, is_dismissed, is_beside_part, is_other_again, is_filled_for,
    is_means_of_it,
)  # fmt: skip
"""What says of a pronoun and a phrase that it does not mean that."""


def done_otherwise(context: Context, gap: Gap, verb: str) -> int:
    """The order, by its number, that is to be carried out in another place in the case of another thing: "fill the can.
    If the tap is frozen, *fill it at the sink*" is of the can; 0 where there is none."""
    path = context.paths.get(gap.task.id, ())
    places = {a.type for a in gap.task.arguments} & {"location", "source", "goal"}
    order = gap.task.id - 2
    if not path or path[-1][0] != gap.task.id - 1 or not places or context.types.get(order) != gap.task.type:
        return 0
    is_same = context.lemmas[order].split()[0] == verb and context.types.get(gap.task.id - 1) == "check_state"
    named = any(not c.mention for c in context.arguments(order, "object"))
    return order if is_same and named else 0


def is_ruled_out(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a pronoun cannot mean a candidate: another argument of its own task ("put it on the table"), what there
    is none of, or what is no person where it is named after a "she" ("if she's hungry, bring her the cake") or handled
    before somebody is told or given something ("bring her the cake and tell her ..."); and nobody is opened or shut,
    be it that "*she* opens"."""
    is_shut = gap.type == "object" and context.lemmas[gap.task.id] in ACTS[1] and gap.word not in SOMEBODY | {"they"}
    if is_shut and kind_of(context, candidate) in ANIMATE:
        return True
    if gap.type == "object" and not gap.word and _is_of_the_house(context, gap, candidate):
        return True
    if gap.form == "own" and _is_some_person(context, candidate):
        return True  # "mine" and "Dad's" are things
    if is_not_one(context, gap, candidate) or _is_in_the_verb(context, gap, candidate):
        return True
    if is_emptied(context, gap, candidate):
        return True
    if _is_used_instead(context, gap, candidate) or _is_itself(context, gap, candidate):
        return True
    is_later = candidate.tokens.start > gap.position and candidate.type == "location"
    if gap.type == "goal" and not gap.word and is_later and candidate.task_type == "check_state":
        return True  # "pour some for Ann, and if there's no sugar *on the table*, ..."
    if is_no_goal(context, gap, candidate) or is_of_own_branch(context, gap, candidate):
        return True
    if any(
        is_not(context, gap, candidate)
        for is_not in (is_within, is_where_from, is_where_else, is_sought, is_led, is_nobody, is_blemish)
    ):
        return True
    if is_on_whole(context, gap, candidate) or is_written(context, gap, candidate) or is_torn(context, candidate):
        return True
    if _is_part_of_subject(context, gap, candidate):
        return True
    head = context.observed.document.tokens[candidate.head].lemma
    is_sensed = head in _FELT and (gap.type == "goal" or (gap.task.type == "searching" and not gap.word))
    is_handled = gap.task.type in MOVING
    if is_sensed or (gap.type == "object" and is_handled and head in _SKY | _FELT):
        return True
    if gap.word not in ELSEWHERE:
        return False
    if candidate.type == "outside" and len(candidate.tokens) == 1 and candidate.head in context.verbs:
        return True
    before = context.observed.document.tokens[max(0, candidate.tokens.start - 1)].lower
    is_thing = gap.type == "object" and gap.word not in SOMEBODY
    if candidate.type == "outside" and is_thing and before in ("before", "during"):
        return True  # "bring it to me before *my call*"
    if candidate.owner == gap.task.id and not candidate.mention and not is_stated_place(context, gap, candidate):
        return True
    if is_named_later(context, gap, candidate) or is_not_shown(context, gap, candidate):
        return True
    if is_unswitched(context, gap, candidate) or is_unshut(context, gap, candidate):
        return True
    if gap.type == "object" and not candidate.mention and _is_cut_off(context.observed.document, candidate):
        return True
    if gap.type == "object" and (_is_where(gap, candidate) or _is_beside_same(context, gap, candidate)):
        return True
    if gap.type == "object" and len(candidate.tokens) == 1 and _is_adverb(context.observed.document, candidate):
        return True
    if _is_one_of_a_choice(context, candidate):
        return True
    if is_of_other_gender(context.observed.document, gap, candidate) or is_no_person(context, gap, candidate):
        return True
    if is_told_of_otherwise(context, gap, candidate) or is_possessed(context, gap, candidate):
        return True
    if is_no_somebody(context, gap, candidate) or is_lifeless(context, gap, candidate):
        return True
    if is_whence(context, gap, candidate):
        return True
    if is_no_single_thing(context, gap, candidate):
        return True
    is_ahead = gap.word in SOMEBODY and candidate.tokens.start > gap.position
    if is_ahead and gap.task.type == "check_state" and is_called_in(context, candidate):
        return True
    is_given = gap.type == "recipient" and candidate.type == "object" and candidate.task_type in MOVING
    if (is_ahead or is_given) and kind_of(context, candidate) not in ANIMATE:
        return True
    if any(
        is_not(context, gap, candidate)
        for is_not in (is_support, is_unfit, is_unoccupied, is_unwarmed, is_content, _is_feature)
    ):
        return True
    if is_immovable(context, gap, candidate):
        return True
    if is_not_on_it(context, gap, candidate) or _is_turned(context, gap, candidate):
        return True
    if is_part(context, gap, candidate) or _is_stuff(context, gap, candidate) or _is_wishing(context, gap, candidate):
        return True
    return any(is_not(context, gap, candidate) for is_not in _NOT_MEANT) or _is_beside(context, gap, candidate)


def _is_used_instead(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is the place that another one is used instead of, for what was to go there: "put the toys in
    *the tub*, and if the tub is full use the box", "if *the top drawer* is full, use the bottom one"."""
    if (gap.type, gap.word, gap.task.type) != ("object", "", "placing") or context.lemmas[gap.task.id] != "use":
        return False
    document = context.observed.document
    goals = [c for c in context.pool if c.type == "goal" and c.owner]
    places = [c for c in goals if c.owner != gap.task.id or c.mention in ONES]
    return any(document.tokens[candidate.head].lemma == document.tokens[place.head].lemma for place in places)


def _is_some_person(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is somebody, by a noun or a name without an article, or ends in one ("my mug and Tom's")."""
    kind = kind_of(context, candidate)
    first = context.observed.document.tokens[candidate.tokens.start]
    return kind == "person" or (kind == "name" and first.tag != "DT")


def _is_in_the_verb(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a verb without an object says what it is done with, which is not what it is done to: "take *the hoover*
    up and hoover the landing"."""
    verb = context.lemmas[gap.task.id].split()[0]
    is_unsaid = (gap.type, gap.word, gap.task.type) == ("object", "", "change_state")
    return is_unsaid and context.observed.document.tokens[candidate.head].lemma == verb


def _is_itself(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what is asked for itself, which is not where it is: "if *the pan* isn't there"."""
    if gap.word != "there" or gap.task.type != "check_state":
        return False
    document = context.observed.document
    objects = [document.indices(a.span) for a in gap.task.arguments if a.type == "object" and a.span is not None]
    heads = {document.tokens[head_of(document, words)].lemma for words in objects}
    return document.tokens[candidate.head].lemma in heads - ONES


def _is_part_of_subject(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is but a part of what a clause tells of: the key alone of "*the key to the cabin* is lost".
    Nor is what goes without saying behind that the cabin, nor the "it" that takes the whole up in its own clause."""
    if candidate.type != "outside" or candidate.mention:
        return False
    is_unsaid = gap.type == "object" and not gap.word
    return any(
        subject.has_part(candidate.tokens)
        and (is_unsaid or candidate.tokens == subject.thing or (subject.is_topic and gap.word == "it"))
        for subject in context.subjects
    )


def _is_cut_off(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate lacks the "of ..." that says which thing it is: "*the last slice* of pie"."""
    behind = document.tokens[candidate.tokens.stop : candidate.tokens.stop + 2]
    return len(behind) > 1 and behind[0].lower == "of" and behind[1].tag not in ("PRP", "WDT", "WP")


def _is_where(gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is named again as where the thing is moved to or from: nothing is put into itself."""
    if gap.task.type not in MOVING or not candidate.mention:
        return False
    places = [a.value.lower() for a in gap.task.arguments if a.type in ("goal", "source") and a.span is not None]
    return any(place == candidate.text.lower() or place.endswith(f" {candidate.text.lower()}") for place in places)


def _is_beside_same(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate further on, or in the other branch, is the place that the same pronoun is told to be put to:
    "if *it*'s clean, it goes in the cupboard, otherwise wash *it*"."""
    document, tokens = context.observed.document, context.observed.document.tokens
    owner = context.by_number.get(candidate.owner)
    if owner is None or candidate.mention or candidate.type == "object":
        return False
    paths = ((one, other) for one in context.paths.get(owner.id, ()) for other in context.paths.get(gap.task.id, ()))
    is_elsewhere = any(one[0] == other[0] and one[1] != other[1] for one, other in paths)
    if candidate.tokens.start <= gap.position and not is_elsewhere:
        return False
    objects = [document.indices(a.span) for a in owner.arguments if a.type == "object" and a.span is not None]
    return any(len(o) == 1 and tokens[o.start].lower == gap.word for o in objects) and owner.type in MOVING


def _is_adverb(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate only tells a way or a place, and names none: "carry it *inside*"."""
    token = document.tokens[candidate.head]
    return token.pos in ("ADV", "ADP") and token.lower in PLACE_ADVERBS


def _is_turned(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is what is cooked, and a candidate what was turned down or off for it: "turn down *the heat* and
    stir it"."""
    verb, other = (context.lemmas.get(number, "").split()[:1] for number in (gap.task.id, candidate.owner))
    is_turned = candidate.type == "object" and other in (["turn"], ["switch"])
    return gap.type == "object" and gap.word == "it" and is_turned and not _COOKED.isdisjoint(verb)


def _is_feature(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate only tells which thing a statement is about: "you know that basket, the one with *the broken
    handle*, well, it's in the cellar. Fetch *it*"."""
    document, start = context.observed.document, candidate.tokens.start
    tokens = document.tokens
    if gap.word in SOMEBODY or candidate.owner or candidate.mention or start < 2:
        return False
    is_one = tokens[candidate.head].lower in ONES or (
        tokens[start].lower in ("the", "that")
        and (tokens[start + 1 : start + 2] != () and tokens[start + 1].lower in ONES)
    )
    of = document.sentences
    is_stated = not any(of[i] == of[start] and i < start for i in context.verbs)
    before = tokens[start - 2]
    is_told = tokens[start - 1].lower == "with" and (before.lower in ONES)
    return is_stated and (is_one or is_told)


def is_of(context: Context, order: int, candidate: Candidate) -> bool:
    """Whether a candidate is among what a task names."""
    text = candidate.text.lower()
    return candidate.owner == order or any(c.owner == order and c.text.lower() == text for c in context.pool)


def _is_stuff(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" is filled, and a candidate is what it is filled with: "take my cup, and if there's *any tea* left,
    fill it"."""
    is_filled = context.lemmas[gap.task.id] in FILLING and gap.word == "it"
    return is_filled and is_measured(context.observed.document, candidate) and not candidate.mention


def _is_wishing(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" would be who wishes, or "him" what is wished for: "if *Emma* wants *tea*, bring it to her", "if he
    says *soup*, ..."."""
    verb = context.lemmas.get(candidate.owner)
    if candidate.task_type != "check_state" or verb not in WISHING | _SAYING:
        return False
    kind = kind_of(context, candidate)
    is_who = gap.word == "it" and candidate.type == "object" and kind in ("person", "name") and verb in WISHING
    return is_who or (gap.word in SOMEBODY and candidate.type == "state" and kind not in ANIMATE)


def _is_of_the_house(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether what is done "up" without an object is not done to a candidate: who washes or tidies up does it to no
    table in particular, who locks up locks the house, or a door, no cat, no heater and no lawn that was watered. Who
    recharges without more does so themselves, unless a case asked of something; "the ironing" is done to nothing."""
    said = context.observed.document.tokens[max(0, gap.position - 1) : gap.position + 1]
    if said[0].tag in ("DT", "PRP$") and said[-1].lower.endswith("ing"):
        return True
    verb, head = context.lemmas[gap.task.id], context.observed.document.tokens[candidate.head].lemma
    if verb == "recharge":
        return candidate.task_type != "check_state" or kind_of(context, candidate) in ANIMATE
    if verb != "lock up":
        return verb in ("wash up", "tidy up", "clear up")
    is_adverb = candidate.type == "location" and len(candidate.tokens) == 1
    if is_adverb or context.observed.document.tokens[candidate.head].pos == "ADV":
        return True
    gazetteer = context.observed.gazetteer
    is_known = bool(gazetteer.category(head)) and "aperture" not in gazetteer.changeable.get(head, ())
    verb_before = context.lemmas.get(candidate.owner, "").split()[:1]
    if candidate.task_type == "change_state" and candidate.type == "object" and not gazetteer.category(head):
        return (_SHUTTING | CLEANING).isdisjoint(verb_before)
    return kind_of(context, candidate) in ANIMATE or (is_known and kind_of(context, candidate) != "room")


def is_weather(context: Context, gap: Gap) -> bool:
    """Whether a check without an object is of the weather: nothing named is what "*it* looks like rain" is of."""
    tokens, verb = context.observed.document.tokens, context.observed.document.indices(gap.task.span).start
    first = context.by_number.get(context.first.get(gap.task.id, 0), gap.task)
    own, asked = (
        {word for a in task.arguments if a.type == "state" for word in a.value.lower().split()}
        for task in (gap.task, first)
    )
    if gap.type != "object" or gap.task.type != "check_state":
        return False
    before = [token.lower for token in tokens[max(0, verb - 2) : verb]]
    if tokens[verb].lower in WEATHER and "it" in before:  # "if it's *pouring*"
        return gap.word in ("", "it")
    if before[-1:] != ["it"]:
        return False
    said = [w for kind in ("state", "location") for value in gap.task.values(kind) for w in value.lower().split()]
    if not own.isdisjoint(TIMES_OF_DAY | WEATHER - {"dark"}) or is_air(said):
        return gap.word in ("", "it")
    if not gap.word and ("dark" in own or (not WARMTH.isdisjoint(own) and _is_aired(context, gap))):
        return True
    is_mention = not own and first is not gap.task and all(a.type != "object" for a in first.arguments)
    at = context.observed.document.indices(first.span).start
    is_of_air = at > 0 and tokens[at - 1].lower == "it" and "location" in {a.type for a in first.arguments}
    is_of_air = is_of_air and first.type == "check_state" and bool(asked)
    return is_mention and gap.word in ("", "it") and (is_of_air or not WEATHER.isdisjoint(asked))


def _is_aired(context: Context, gap: Gap) -> bool:
    """Whether all that is handled is seen to for how warm it is around: "bring me *a jumper* if it's cold"."""
    tokens = context.observed.document.tokens
    others = [task.id for task in context.tasks if task.id != gap.task.id]
    handled = {tokens[c.head].lemma for other in others for c in context.arguments(other, "object") if not c.mention}
    return bool(handled) and handled <= AIRED


def _is_one_of_a_choice(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is only one of the things that an "or" joins: if *the radio or the fan* is on, "turn it off"
    is of whichever is."""
    tokens = context.observed.document.tokens
    return not candidate.mention and any(
        c.tokens.start <= candidate.tokens.start
        and candidate.tokens.stop <= c.tokens.stop
        and c.tokens != candidate.tokens
        and not c.mention
        and c.owner
        and any(tokens[i].lower == "or" for i in c.tokens)
        and WEATHER.isdisjoint(tokens[i].lower for i in c.tokens)  # "if it's Thursday or the bin is full"
        for c in context.pool
        if (c.owner, c.type) == (candidate.owner, candidate.type)
    )


def _is_beside(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate only tells if something can be done to what was handled before: "get the soup, and if the
    microwave works, *thaw it*", "bring the pram in, and if its hood is missing, *leave it* in the hall"."""
    if gap.type != "object" or gap.word in SOMEBODY or not _is_other_named(context, gap, candidate):
        return False
    if _is_means(context, gap, candidate):
        return True
    owner = context.by_number.get(candidate.owner, gap.task)
    is_absent = any(a.type == "state" and a.value.lower() in _ABSENT for a in owner.arguments)
    is_missed = is_absent and context.relation(owner.id, gap.task.id).startswith("condition.then")
    return is_missed and gap.task.type == "placing" and not _is_of_list(context, gap)


def _is_other_named(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether another thing, to which the verb may be done, was the object of a task before."""
    tokens = context.observed.document.tokens
    return any(
        c.type == "object"
        and c.owner != gap.task.id
        and c.tokens.stop <= gap.position
        and tokens[c.head].lemma != tokens[candidate.head].lemma
        and kind_of(context, c) not in ANIMATE
        and not _is_means(context, gap, c)
        for c in context.pool
    )


def _is_means(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what the verb is done with or by, not what it is done to: a toaster is not toasted."""
    verb = context.lemmas[gap.task.id].split()[0]
    noun = context.observed.document.tokens[candidate.head].lemma
    if noun in _MEANS.get(verb, ()) or noun in _agents(verb) - _NO_AGENTS:
        return True
    gazetteer = context.observed.gazetteer
    is_cooked = gazetteer.category(noun) != "furniture" or (noun in _COOLING and candidate.type == "object")
    return (verb in _COOKING and not is_cooked) or (verb == "air" and "power" in gazetteer.changeable.get(noun, ()))


def _agents(verb: str) -> frozenset[str]:
    """What a verb's doer may be called: "washer", "dryer", "drier", "charger", "mopper"."""
    stems = (verb, verb.removesuffix("e"), verb + verb[-1], verb.removesuffix("y") + "i")
    return frozenset(stem + "er" for stem in stems)


def _is_of_list(context: Context, gap: Gap) -> bool:
    """Whether something is put on a list."""
    spans = [a.span for a in gap.task.arguments if a.type in ("goal", "message", "location") and a.span]
    document = context.observed.document
    return any(document.tokens[document.indices(span).stop - 1].lemma == "list" for span in spans)


def listed(context: Context, gap: Gap) -> int:
    """The check, by its number, that found out what there is none of, where that is put on a list ("if there are no
    filters left, write it on the list"); 0 where none did."""
    path = context.paths.get(gap.task.id, ())
    if gap.type != "object" or gap.word not in ELSEWHERE - SOMEBODY or not path or path[-1][1] != "else":
        return 0
    check = context.by_number.get(path[-1][0])
    if check is None or check.id >= gap.task.id or not says_there_is(context.observed.document, check):
        return 0
    return check.id if _is_of_list(context, gap) else 0
