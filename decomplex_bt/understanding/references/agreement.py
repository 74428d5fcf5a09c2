"""Agreement: what gender, number and contrast settle of what a word refers to."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import is_child
from decomplex_bt.understanding.references.context import ANIMATE, GROUPS, Context, kind_of
from decomplex_bt.understanding.references.first_names import MEN, WOMEN
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import (
    ANIMALS,
    ANYBODY,
    ONES,
    PERSON_NOUNS,
    PLACE_ADVERBS,
    PREPOSITIONS,
    WHOLE,
)

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
PLACES = frozenset(("goal", "location", "source"))
_SEVERAL = frozenset("and or every each any some all both no these those".split()) | WHOLE
_GROUPS = frozenset(
    "laundry washing furniture luggage cutlery crockery china family couple pair set team crew group staff stuff "
    "delegation recycling rubbish trash shopping post mail cattle police".split()
)
"""Nouns in the singular for several."""
PUTTING = frozenset(("bringing", "placing"))
_HANDLING_THINGS = PUTTING | {"change_state", "taking"}
_NOBODY = frozenset("unsaid one some there here".split())
"""What stands for no person."""
_PERSONAL = frozenset(("he", "she", "they"))
_OWNING = {"his": "he", "her": "she", "their": "they"}
_SINGLING = frozenset("either neither one any each every whichever".split())
"""What tells one of several: "either of the lamps"."""
_SINGULARS = ("NN", "NNP")
_NO_ONE = ANYBODY | {"nobody", "everybody", "everyone"}
"""Words for people that "it" never stands for."""
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
_LIFELESS = frozenset(
    "garden yard courtyard lawn allotment orchard porch patio terrace balcony veranda drive driveway shed barn "
    "greenhouse workshop garage attic loft cellar basement conservatory summerhouse treehouse landing corridor "
    "passage stairs stairwell gate door doorstep street road market shop store supermarket library school office "
    "station church".split()
)
"""Places, of the domain or not, which are never "she"."""
OWN = frozenset("mine his hers yours ours theirs".split())
"""What stands for a thing by whose it is."""
_NEAR = 3
"""Within so many words before a participle stands who has done it."""
_WITHIN = frozenset("in into inside on onto under behind off out".split())


def is_of_other_gender(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether "her" cannot mean a candidate because that is a man, or several people: "find *Alice and her brother*;
    bring *him* the cap"."""
    group = GROUPS.get(gap.word, "")
    if group not in ("he", "she"):
        return False
    is_named = not candidate.mention
    if is_named and any(document.tokens[i].lower == "and" for i in candidate.tokens):
        return True
    return gender(document, candidate) not in ("", group)


def is_told_of_otherwise(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "her" cannot mean a candidate because the text goes on with "he" when nobody else had been named, be that
    in no task: "*the plumber* is here and *he*'s allergic to dogs, so if the terrier is in, take *her* out". What was
    settled of a pronoun before is for `persons`."""
    group = GROUPS.get(gap.word, "")
    is_open = not candidate.mention and not gender(context.observed.document, candidate)
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
        is_told = gap.type == "recipient" and gap.task.type == "informing"  # as no dog is

        def is_living(whole: Candidate) -> bool:
            is_animal = kind_of(context, whole) == "animal" and whole.task_type not in PUTTING  # "bring Ida's rabbit"
            return kind_of(context, whole) == "person" or (is_animal and not is_told)

        return any(
            c.tokens.start == candidate.tokens.start
            and c.tokens.stop > candidate.tokens.stop + 1
            and is_living(c)
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
    is_stated = candidate.type == "outside" and document.tokens[candidate.head].dep == "nsubj"
    return is_of_task or is_stated or is_child(document, candidate.tokens)


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
        return candidate.mention in _NOBODY | OWN or GROUPS.get(candidate.mention) == "it"
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
    named = words[:-2] if [token.lower for token in words[-2:]] == ["next", "door"] else words
    is_person = bool(named) and named[-1].lower in PERSON_NOUNS  # a "window cleaner" is no window
    is_thing = category not in ("", "person") or head.lemma in _LIFELESS
    if is_thing and head.text.islower() and not is_person:
        return True
    is_adverb = len(candidate.tokens) == 1 and head.lower in PLACE_ADVERBS | WEATHER | {"home"}
    if is_adverb or head.lemma in _TIMES:
        return True
    before = document.tokens[candidate.tokens.start - 1].lower if candidate.tokens.start else ""
    is_place = candidate.type in PLACES and (bool(category) or before in _WITHIN)
    is_whereabouts = candidate.type == "state" and before in PREPOSITIONS  # "if he's on *the phone*"
    return is_handled or is_place or is_whereabouts or _is_had(context, gap, candidate)


def is_no_single_thing(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "it" cannot mean a candidate because that is somebody ("warm the soup if *Max* is in. When *it*'s hot,
    ...") or several things, where one thing is named ("shake *the crumbs* off the cloth and fold *it*") or one of them
    is ("if one of *the lamps* is on, ... *it*"), or "them" because it is the one thing of a task that names several. A
    baby may be "it", but is given to nobody it is itself, and so may be whoever is at the door ("if *it*'s Max"); who
    is told something is none."""
    tokens, head = context.observed.document.tokens, context.observed.document.tokens[candidate.head]
    if gap.word == "they" and _are_all(context, gap):
        return not candidate.mention and _is_person(context, candidate) and tokens[candidate.head].tag in _SINGULARS
    if len(gap.tokens) != 1 or gap.word not in ("it", "that", "them"):
        return False
    if gap.word == "that":
        return not candidate.mention and candidate.type in PLACES and _is_plural(context, candidate)
    if gap.word == "them":
        return _is_the_one_of(context, gap, candidate)
    if _asks_who(context, gap):
        return False
    is_told = (candidate.task_type, candidate.type) == ("informing", "recipient")
    if not candidate.mention and candidate.text.lower() in _NO_ONE:
        return True
    is_he = GROUPS.get(candidate.mention) == "he" and candidate.mention not in OWN
    if is_he or is_told or _is_person(context, candidate):
        return True
    if kind_of(context, candidate) in ANIMATE:
        return _is_given_to(context, gap, candidate)
    is_several = _is_plural(context, candidate) and (not candidate.mention or GROUPS.get(candidate.mention) == "they")
    before = [token.lower for token in tokens[max(0, candidate.tokens.start - 2) : candidate.tokens.start]]
    if is_several and before == ["one", "of"]:
        return True
    return is_several and any(
        c.tokens.stop <= gap.position
        and c.owner != gap.task.id
        and tokens[c.head].tag == "NN"
        and c.shape in ("whole", "long", "short")
        and c.head != head.i
        and kind_of(context, c) not in ANIMATE
        for c in context.pool
    )


def _are_all(context: Context, gap: Gap) -> bool:
    """Whether several are spoken of: "if *they*'re *all* damp"."""
    return any(token.lower in ("all", "both") for token in context.observed.document.tokens[gap.tokens.stop :][:2])


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


def gender(document: Document, candidate: Candidate) -> str:
    """The pronoun of a person as far as the noun, a name, a title or "John and *his* wife" tells it."""
    tokens = document.tokens
    head = tokens[candidate.head]
    words = {head.lemma.lower()} | ({head.lower} if head.pos == "PROPN" else frozenset())
    if not candidate.mention:
        is_owner = any(tokens[i].tag == "POS" for i in range(candidate.tokens.start, candidate.head))  # "Mr Hale's dog"
        words |= {tokens[candidate.tokens.start].lower} & _TITLES if not is_owner else frozenset()
        behind = [token.lower for token in tokens[candidate.tokens.stop : candidate.tokens.stop + 2]]
        if tokens[candidate.head].pos == "PROPN" and behind[:1] == ["and"] and behind[1:] in (["his"], ["her"]):
            return GROUPS[behind[1]]
    return "she" if words & _FEMALE_OR_NAMED else "he" if words & _MALE_OR_NAMED else ""


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
