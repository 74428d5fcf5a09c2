"""Agreement: what gender, number and contrast settle of what a word refers to."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.context import ANIMATE, GROUPS, Context, kind_of
from decomplex_bt.understanding.references.first_names import MEN, WOMEN
from decomplex_bt.understanding.references.gaps import Gap, asks_there_is, is_beside
from decomplex_bt.understanding.references.offers import filled_meant, offered
from decomplex_bt.understanding.references.ordinals import one_of_two
from decomplex_bt.understanding.references.phrases import (
    ANIMALS,
    ONES,
    PERSON_NOUNS,
    PLACE_ADVERBS,
    PREPOSITIONS,
    WHOLE,
    Candidate,
    is_child,
)
from decomplex_bt.understanding.references.places import place_meant
from decomplex_bt.understanding.references.undoing import done_contrariwise, undone
from decomplex_bt.understanding.references.unsaid_goals import goal_instead
from decomplex_bt.understanding.references.unsaid_recipients import asked
from decomplex_bt.understanding.references.wholes import whole_meant

_FEMALE = frozenset(
    "wife mother mom mum mama mummy mommy daughter sister woman lady girl grandma granny gran nan grandmother aunt "
    "auntie niece girlfriend granddaughter mrs ms miss mrs. ms.".split()
)
_MALE = frozenset(
    "husband father dad papa daddy son brother man guy boy grandpa grandad granddad grandfather uncle nephew boyfriend "
    "grandson gentleman waiter mr mr.".split()
)
_FEMALE_OR_NAMED, _MALE_OR_NAMED = _FEMALE | WOMEN, _MALE | MEN
_TITLES = frozenset("mrs mrs. ms ms. miss mr mr.".split())
_PLACES = frozenset(("goal", "location", "source"))
_ANY = frozenset(("a", "an", "one"))
_SEVERAL = frozenset("and or every each any some all both no these those".split()) | WHOLE
_GROUPS = frozenset(
    "laundry washing furniture luggage cutlery crockery china family couple pair set team crew group staff stuff "
    "delegation recycling rubbish trash shopping post mail cattle police".split()
)
"""Nouns in the singular for several."""
_HANDLING = frozenset(("bringing", "placing"))
_HANDLING_THINGS = _HANDLING | {"change_state", "taking"}
_NOBODY = frozenset("unsaid one some there here".split())
"""What stands for no person."""
_PERSONAL = frozenset(("he", "she", "they"))
_OWNING = {"his": "he", "her": "she", "their": "they"}
_SINGLING = frozenset("either neither one any each every whichever".split())
"""What tells one of several: "either of the lamps"."""
_SINGULAR = frozenset("thermos atlas canvas gas lens news iris pancreas compass series".split())
_CALLED_IT = frozenset(
    "baby child kid toddler patient family cleaner driver butcher baker grocer florist chemist pharmacist hairdresser "
    "barber dentist".split()
)
"""Who may be "it" for all that, some as their shop."""
_HUMAN = frozenset("ask want say call complain cry like knock arrive".split())
"""What only somebody does."""
_TIMES = frozenset("morning afternoon evening night noon midnight day week weekend".split())
_CALLED_SHE = frozenset(
    "doll teddy bear bunny boat ship dinghy skiff yacht canoe car van tractor mower stove boiler".split()
)
_NEAR = 3
"""Within so many words before a participle stands who has done it."""
_WITHIN = frozenset("in into inside on onto under behind off out".split())
_OUT_OF = frozenset((("out", "of"), ("empty", "of"), ("short", "of"), ("low", "on"), ("short", "on")))
"""What stands before the thing of which there is too little."""
_BEING_WITHOUT = frozenset("be 's \u2019s 're \u2019re run go".split())
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
        or whole_meant(context, gap)
        or offered(context, gap)
        or filled_meant(context, gap)
        or _somebody(context, gap)
        or _instead(context, gap)
        or undone(context, gap)
        or done_contrariwise(context, gap)
        or goal_instead(context, gap)
        or asked(context, gap)
    )


def is_of_other_gender(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether "her" cannot mean a candidate because that is a man, or several people: "find *Alice and her brother*;
    bring *him* the cap"."""
    group = GROUPS.get(gap.word, "")
    if group not in ("he", "she"):
        return False
    is_named = not candidate.mention
    if is_named and any(document.tokens[i].lower == "and" for i in candidate.tokens):
        return True
    return _gender(document, candidate) not in ("", group)


def is_told_of_otherwise(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "her" cannot mean a candidate because the text goes on with "he" when nobody else had been named, be that
    in no task: "*the plumber* is here and *he*'s allergic to dogs, so if the terrier is in, take *her* out". What was
    settled of a pronoun before is for `persons`."""
    group = GROUPS.get(gap.word, "")
    is_open = not candidate.mention and not _gender(context.observed.document, candidate)
    if group not in ("he", "she") or not is_open or kind_of(context, candidate) not in ANIMATE:
        return False
    named = [c for c in context.pool if not c.mention and kind_of(context, c) in ANIMATE]
    tokens = context.observed.document.tokens
    for token in tokens[candidate.tokens.stop : gap.position]:
        if token.lower not in ("he", "she"):
            continue
        is_only = all(c.head == candidate.head for c in named if c.tokens.start < token.i)
        return is_only and token.lower != group
    return False


def is_possessed(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "her" is not a candidate since that is a thing or a limb of somebody's ("*my aunt*'s knee hurts, help
    *her*"), or since it only tells whose son or little one somebody is, be it who is meant."""
    if GROUPS.get(gap.word, "") not in ("he", "she") or candidate.mention:
        return False
    document = context.observed.document
    tokens = document.tokens
    if tokens[candidate.tokens.stop : candidate.tokens.stop + 1] and tokens[candidate.tokens.stop].tag == "POS":
        return any(
            c.tokens.start == candidate.tokens.start
            and c.tokens.stop > candidate.tokens.stop + 1
            and kind_of(context, c) == "person"
            and not is_of_other_gender(document, gap, c)
            for c in context.pool
            if not c.mention and _is_whole_person(document, c)
        )
    owner = next((i for i in candidate.tokens if tokens[i].tag == "POS"), None)
    if owner is None or owner == candidate.tokens.stop - 1 or kind_of(context, candidate) in ANIMATE:
        return False
    return any(c.tokens == range(candidate.tokens.start, owner) for c in context.pool)


def _is_whole_person(document: Document, candidate: Candidate) -> bool:
    """Whether a phrase is of whom something is said or done, or of somebody's little one."""
    is_of_task = candidate.shape in ("whole", "short") and candidate.type == "object"
    return is_of_task or is_child(document, candidate.tokens)


def is_no_person(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "he" or "she" cannot mean a candidate because that is a thing or a place ("turn the *music* on, and if
    she's still awake, ..."), or are several ("if *the matches* are wet, get him a lighter"), or "they" because it is
    one thing ("clear the *table* once they have finished"), or whose it is ("if they call, bring *their coats*"). A
    boat or a doll may be "she"."""
    document, group = context.observed.document, GROUPS.get(gap.word, "")
    head = document.tokens[candidate.head]
    if group in ("he", "she") and _are_several(context, candidate):
        return True
    if group not in _PERSONAL or kind_of(context, candidate) in ANIMATE:
        return False
    if candidate.mention:
        return candidate.mention in _NOBODY or GROUPS.get(candidate.mention) == "it"
    behind = document.tokens[candidate.tokens.stop :][:1]
    words = document.tokens[candidate.tokens.start : candidate.tokens.stop]
    owning = [token.tag == "PRP$" and _OWNING.get(token.lower) == group for token in words]
    if (any(owning) and group != "they") or (owning[0] and candidate.tokens.start > gap.position):
        return True
    if head.pos == "ADP":
        return True
    if any(token.tag == "POS" for token in behind):
        return False  # "in *Ann*'s room"
    category = context.observed.gazetteer.category(head.lemma)
    is_whole = candidate.type == "object" or "across" in candidate.shape  # "put *the cake on the table*"
    said = [token.lower for token in document.tokens[max(0, candidate.tokens.start - 2) : candidate.tokens.start]]
    is_handled = is_whole and candidate.task_type in _HANDLING_THINGS and said != ["hold", "of"]
    if group == "they":
        is_thing = category not in ("", "person") or (is_handled and context.lemmas[gap.task.id] in _HUMAN)
        is_later = candidate.tokens.start > gap.position
        is_one = head.tag == "NN" and not _is_of_several(document, candidate)
        return gap.word == "they" and (is_thing or is_later) and is_one  # "them" may be two things named one by one
    if head.lemma in _CALLED_SHE | ANIMALS or (head.lower in MEN | WOMEN and len(candidate.tokens) == 1):
        return False
    is_person = document.tokens[candidate.tokens.stop - 1].lower in PERSON_NOUNS  # a "window cleaner" is no window
    if category not in ("", "person") and head.text.islower() and not is_person:
        return True
    is_adverb = len(candidate.tokens) == 1 and head.lower in PLACE_ADVERBS | WEATHER | {"home"}
    if is_adverb or head.lemma in _TIMES:
        return True
    before = document.tokens[candidate.tokens.start - 1].lower if candidate.tokens.start else ""
    is_place = candidate.type in _PLACES and (bool(category) or before in _WITHIN)
    is_whereabouts = candidate.type == "state" and before in PREPOSITIONS  # "if he's on *the phone*"
    return is_handled or is_place or is_whereabouts or _is_had(context, gap, candidate)


def is_no_single_thing(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" cannot mean a candidate because that is somebody ("warm the soup if *Max* is in. When *it*'s hot,
    ...") or several things, where one thing is named ("shake *the crumbs* off the cloth and fold *it*"), or "them"
    because it is the one thing of a task that names several. A baby may be "it", but is given to nobody it is itself,
    and so may be whoever is at the door ("if *it*'s Max"); who is told something is none."""
    tokens, head = context.observed.document.tokens, context.observed.document.tokens[candidate.head]
    if len(gap.tokens) != 1 or gap.word not in ("it", "them"):
        return False
    if gap.word == "them":
        return _is_the_one_of(context, gap, candidate)
    if _asks_who(context, gap):
        return False
    is_told = (candidate.task_type, candidate.type) == ("informing", "recipient")
    if GROUPS.get(candidate.mention) == "he" or is_told or _is_person(context, candidate):
        return True
    if kind_of(context, candidate) in ANIMATE:
        return _is_given_to(context, gap, candidate)
    is_several = _is_plural(context, candidate) and (not candidate.mention or GROUPS.get(candidate.mention) == "they")
    return is_several and any(
        c.tokens.stop <= gap.position
        and c.owner != gap.task.id
        and tokens[c.head].tag == "NN"
        and c.shape in ("whole", "long", "short")
        and c.head != head.i
        and kind_of(context, c) not in ANIMATE
        for c in context.pool
    )


def _is_plural(context: Context, candidate: Candidate) -> bool:
    """Whether a phrase names several things by its last noun: no "clothes horse", no "either of the lamps"."""
    tokens = context.observed.document.tokens
    head, first, behind = tokens[candidate.head], tokens[candidate.tokens.start], tokens[candidate.head + 1 :][:1]
    if first.lower in _SINGLING | WHOLE or head.lower in _SINGULAR:
        return False
    is_last = all(token.pos not in ("NOUN", "PROPN", "VERB") for token in behind) or head.i == candidate.tokens.stop - 1
    is_compound = any(token.pos in ("NOUN", "PROPN") for token in behind)
    return is_last and not is_compound and head.tag == "NNS" and head.lower.endswith("s")


def _are_several(context: Context, candidate: Candidate) -> bool:
    """Whether a phrase names several, and is none of one person whom they only tell about: "the man about *the
    gutters*"."""
    tokens = context.observed.document.tokens
    named = [i for i in candidate.tokens if i != candidate.head and tokens[i].lower in PERSON_NOUNS]
    is_of_one = any(tokens[i + 1 : i + 2] == () or tokens[i + 1].tag != "POS" for i in named)
    return tokens[candidate.head].text.islower() and _is_plural(context, candidate) and not is_of_one


def _is_the_one_of(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is one thing that was got off or out of several, right ahead of what is done to "them"."""
    document, order = context.observed.document, gap.task.id - 1
    is_one = document.tokens[candidate.head].tag == "NN" and not _is_of_several(document, candidate)
    if candidate.mention or (candidate.owner, candidate.type) != (order, "object") or not is_one:
        return False
    sources = (c for c in context.arguments(order, "source") if not c.mention)
    return any(c.shape in ("whole", "long") and _is_plural(context, c) for c in sources)


def _asks_who(context: Context, gap: Gap) -> bool:
    """Whether it is asked who or what somebody is: "if *it*'s Max", "if *it* is the neighbours", not "... the red
    one"."""
    tokens = context.observed.document.tokens
    states = [context.observed.document.indices(a.span) for a in gap.task.arguments if a.type == "state" and a.span]
    last = [tokens[state[-1]] for state in states]
    is_named = any(token.pos in ("NOUN", "PROPN", "PRON") and token.lower not in ONES for token in last)
    return gap.task.type == "check_state" and (is_named or not states)


def _is_person(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is somebody whom only "he", "she" or "they" means."""
    tokens = context.observed.document.tokens
    head, first = tokens[candidate.head], tokens[candidate.tokens.start]
    if head.lemma in PERSON_NOUNS:
        return head.lemma not in _CALLED_IT and first.lower not in WHOLE  # "anything the guests have left"
    is_first_name = head.lower in MEN | WOMEN and head.pos == "PROPN"
    is_alone = candidate.head == candidate.tokens.start or first.lower in _TITLES
    return is_first_name and (is_alone or bool(candidate.mention))


def _is_given_to(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is the only one whom "her" means in "bring it to *her*"."""
    said = {a.value.lower().split()[-1] for a in gap.task.arguments if a.type == "recipient"}
    if said.isdisjoint(("him", "her")):
        return False
    living = {c.head for c in context.pool if c.tokens.stop <= gap.position and kind_of(context, c) in ANIMATE}
    return living == {candidate.head}


def _is_had(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is a thing that somebody has done something with, be it who is meant: "if he's eaten *the
    apple*, bring him a pear"."""
    tokens, verb = context.observed.document.tokens, candidate.tokens.start - 1
    if verb not in context.verbs or tokens[verb].tag not in ("VBN", "VBD") or tokens[candidate.head].pos != "NOUN":
        return False
    category = context.observed.gazetteer.category(tokens[candidate.head].lemma)
    doers = {GROUPS.get(token.lower) for token in tokens[max(0, verb - _NEAR) : verb]}
    return category not in ("", "person") or GROUPS[gap.word] in doers


def _gender(document: Document, candidate: Candidate) -> str:
    """The pronoun of a person as far as the noun, a name, a title or "John and *his* wife" tells it."""
    tokens = document.tokens
    head = tokens[candidate.head]
    words = {head.lemma.lower()} | ({head.lower} if head.pos == "PROPN" else frozenset())
    if not candidate.mention:
        words |= {tokens[candidate.tokens.start].lower} & _TITLES
        behind = [token.lower for token in tokens[candidate.tokens.stop : candidate.tokens.stop + 2]]
        if tokens[candidate.head].pos == "PROPN" and behind[:1] == ["and"] and behind[1:] in (["his"], ["her"]):
            return GROUPS[behind[1]]
    return "she" if words & _FEMALE_OR_NAMED else "he" if words & _MALE_OR_NAMED else ""


def _somebody(context: Context, gap: Gap) -> range:
    """Of whom the condition is, or who was asked after, where somebody else was told or asked in between: "if *the
    girl* is sad, ask Paul why and give *her* a tissue", "ask Jenny where *my brother* is and take *him* the cap"."""
    group = GROUPS.get(gap.word, "")
    if group not in ("he", "she") or gap.task.type not in _HANDLING:
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
        and _gender(document, c) == group
        and not is_of_other_gender(document, gap, c)
        and c.tokens.stop <= gap.position
    ]
    topics = [
        c for c in named if (is_helped and c.owner in checks and c.type == "object") or _is_within(c.tokens, asked)
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


def _is_within(tokens: range, spans: Sequence[range]) -> bool:
    return any(tokens.start in span and tokens[-1] in span for span in spans)


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
    if gap.type not in _PLACES or not gap.preposition or not gap.tokens:
        return range(0)
    places = [
        c
        for c in context.pool
        if c.type in _PLACES
        and not c.mention
        and c.shape in ("whole", "long", "short")
        and c.tokens.stop <= gap.position
        and c.owner in (gap.task.id, gap.task.id - 1)
    ]
    if not places:
        return range(0)
    last = places[-1]
    others = (c for c in context.pool if c.type not in _PLACES and not c.mention and c.tokens.stop <= gap.position)
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
    if (
        not is_asked
        or context.types.get(order) not in _HANDLING
        or tokens[gap.tokens.start].lower in ("the", "another")
    ):
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


def pair_meant(context: Context, gap: Gap, pairs: Sequence[Candidate]) -> Candidate | None:
    """The two single things that "them" must mean together, where nothing in the plural was named: "get the flour. Get
    the sugar too. Bring *them* here"; None where English leaves it open."""
    document = context.observed.document
    if gap.word not in ("them", "both") or gap.type != "object" or len(gap.tokens) != 1 or len(pairs) != 1:
        return None
    named = [c for c in context.pool if not c.mention and c.tokens.stop <= gap.position]
    objects = {c.tokens.start for c in named if c.type == "object"}
    is_open = any(_is_of_several(document, c) for c in named)
    return pairs[0] if len(objects) == 2 and not is_open else None


def _is_of_several(document: Document, candidate: Candidate) -> bool:
    """Whether a phrase may be "them" by itself: a plural, a list, "everyone", "every lamp", "some milk", a group."""
    tokens = document.tokens
    words = {tokens[i].lower for i in candidate.tokens}
    # by the letter, too: tags may take a plural for a verb ("the cereal bowls")
    is_plural = any(word.endswith("s") and not word.endswith(("ss", "us")) for word in words)
    return is_plural or not words.isdisjoint(_SEVERAL) or tokens[candidate.head].lemma in _GROUPS | PERSON_NOUNS
