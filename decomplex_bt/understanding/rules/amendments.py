"""Amendments: what is certain of an instruction's arguments, whatever a model finds: those that are taken back,
corrected or said aside, and what an idiom tells of its check."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from itertools import dropwhile, pairwise

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument, FoundArguments
from decomplex_bt.understanding.document import MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.certainty import CLEANING, INSTRUMENTS
from decomplex_bt.understanding.references.identity import identity_of, order_behind
from decomplex_bt.understanding.references.phrases import (
    ANIMALS,
    PERSON_NOUNS,
    degree_asked,
    is_pronoun,
    nobody,
    noun_chunks,
)
from decomplex_bt.understanding.rules.alternatives import alternatives, other_places
from decomplex_bt.understanding.rules.asides import asides, means_of, reasons, whereabouts
from decomplex_bt.understanding.rules.fragments import fragments
from decomplex_bt.understanding.rules.gapping import with_gapped
from decomplex_bt.understanding.rules.idioms import for_somebody, predicated, troubled
from decomplex_bt.understanding.rules.needs import due, in_need
from decomplex_bt.understanding.rules.prohibitions import prohibitions
from decomplex_bt.understanding.rules.questions import with_questions
from decomplex_bt.understanding.rules.relatives import told_apart, without_excluded
from decomplex_bt.understanding.rules.telegraph import named
from decomplex_bt.understanding.rules.wishes import backgrounds
from decomplex_bt.understanding.rules.withdrawals import Withdrawals

_BE = frozenset(("is", "'s", "\u2019s", "was"))
_NOMINAL = frozenset(("DET", "NOUN", "PROPN", "PRON"))
_UNNAMED = frozenset("somebody someone something visitor visitors caller stranger".split())
_PLACES = frozenset(("source", "location"))
_TAKEN_UP = {"object": frozenset("it them one some any that those".split()), "recipient": frozenset(("me", "us"))}
"""By what the argument of a type is taken up that was said before its verb."""
_IT_IS = tuple(
    [pronoun, be] for pronoun, be in (("it", "'s"), ("it", "\u2019s"), ("it", "is"), ("they", "'re"), ("they", "are"))
)
_ORDERED = frozenset(("change_state", "bringing", "taking"))
_STATING = frozenset("be 's \u2019s 're have".split())
_MEALS = frozenset("yesterday breakfast lunch dinner supper tea".split())
_TIMES_OF_DAY = frozenset("night week morning month year weekend afternoon christmas".split())
_WAYS = frozenset(("path", "manner"))
_OF_CHECKS = frozenset(("object", "state", "location"))
_OF_REPORTS = frozenset(("message", "recipient", "manner"))
_BEFORE_WEATHER = frozenset(
    "be been 's is are 're re s just already not n't n\u2019t finally actually really now all still it started starts "
    "starting getting gets turned so too very only outside a an the stopped stops begun begins begin to looks "
    "look looking like".split()
)
"""What may stand between the verb of a check and the word for the weather or the day."""
_HANDING = frozenset("give feed hand serve offer pass".split())
_CARRYING = _HANDING | {"bring", "get", "fetch", "take"}
_HANDLING = frozenset(("bringing", "taking", "placing"))
_HANDLED = frozenset(("change_state", "taking", "placing", "following"))
_ALONG = frozenset(("along", "together"))
_OWNING = frozenset("baby child kid dad mum mom".split())
"""Persons by whom things are called: "bring the baby bottle"."""
_REGARDS = frozenset("compliment regard thanks thank love wish care hand finger apology smile".split())
"""What comes with a thing without being one."""
_TEMPERATURES = frozenset("hot cold warm freezing chilly cool icy wet dry".split())
_OUTSIDE = frozenset("outside out outdoors today tonight tomorrow".split())
_OF_THINGS = frozenset(("foggy", "pours"))
_NEEDING_A_NOUN = frozenset("the a an my your our their its".split())
_NOUN_PARTS = frozenset(("ADJ", "NUM", "NOUN", "PROPN"))
_NEEDING_A_PHRASE = frozenset(("for", "to", "with", "from", "into", "of"))
_PHRASE_PARTS = _NOUN_PARTS | {"DET", "PRON"}
_CORRECTING = frozenset("no sorry wait mean meant rather scratch actually".split())
_AROUND_CORRECTIONS = _CORRECTING | frozenset("i or that make hang hold on oh er um uh erm well not".split())
_RECEIVING = frozenset(("recipient", "goal"))
_ADDING = frozenset(("too", "also", "well"))


def amended(
    observed: Observed, tasks: Mapping[int, str], withdrawals: Withdrawals, found: FoundArguments
) -> FoundArguments:
    """The arguments without those that are taken back, forbidden or said aside, and with what corrections and idioms
    say; where a thing is may be told by a reason ("since it's still in the sink, fish it out")."""
    document = observed.document
    idle = withdrawals.tokens | asides(document, tasks) | prohibitions(observed, tasks) | backgrounds(document, tasks)
    idle |= due(document)
    idle = idle.union(*(found.tokens for found in alternatives(observed, tasks) if not found.is_verbal))
    why = reasons(document, tasks)
    kept = [a for a in found.arguments if a.tokens.start not in idle]
    kept = [a for a in kept if a.tokens.start not in why or a.type in _PLACES]
    how = means_of(document, tasks)
    kept = [a for a in kept if a.tokens.start not in how or a.type in _WAYS]
    kept = without_excluded(document, tasks, told_apart(document, tasks, kept))
    kept = with_questions(document, tasks, kept)
    kept = _of_spills(document, tasks, [_meant(document, tasks, a) for a in kept])
    kept = _of_days(document, [_whereabouts(document, tasks, a, kept) for a in kept])
    kept = [a for a in kept if not _is_said_again(document, a, kept) and not _is_of_wish(tasks, a)]
    kept = [a for a in kept if not _is_of_nobody(document, a)]
    for phrase in withdrawals.corrections:
        kept = _corrected(observed, kept, phrase)
    for token, kind in tasks.items():
        if kind == "bringing":
            kept = _divided(document, kept, token)
            kept = _given(kept, token, for_somebody(document, token))
            kept = _called(document, kept, token)
            kept = _served(document, kept, token)
            kept = _told(kept, token, {"object": said} if (said := troubled(document, token)) else {})
        if kind == "check_state":
            kept = [_undenied(document, a) if a.owner == token else a for a in kept]
            kept = _departed(document, kept, token)
            kept = _told(kept, token, _done_by_nobody(document, token))
            kept = _told(kept, token, predicated(document, token))
            kept = _asked(document, kept, token, tasks)
            kept = _named(document, _identified(observed, kept, token), token)
        if kind in _HANDLED and not any(a.owner == token and token + 1 in a.tokens for a in kept):
            kept = _told(kept, token, _taken_up_behind(document, token))
        if kind != "check_state" and not any((a.owner, a.type) == (token, "object") for a in kept):
            kept = _told(kept, token, in_need(observed, token) or _telegraphed(document, token))
    for fragment in fragments(document):
        if fragment.carrier in tasks:
            told = {"object": fragment.object, "location": fragment.location}
            kept = [argument for argument in kept if set(argument.tokens).isdisjoint(fragment.tokens)]
            kept += [FoundArgument(name, fragment.carrier, said, CERTAIN) for name, said in told.items() if said]
    kept = _at_either(document, tasks, _chosen(document, kept))
    kept = with_gapped(observed, tasks, _accompanied(document, tasks, kept))
    return FoundArguments(tuple(sorted(kept, key=lambda argument: argument.tokens.start)), found.probability)


def _telegraphed(document: Document, verb: int) -> dict[str, range]:
    """What a verb that the tagger takes for a noun is done to: "water *plants*"."""
    is_telegram = not any(token.tag in ("DT", "PRP$") for token in document.tokens)
    thing = named(document, verb) if is_telegram else range(0)
    return {"object": thing} if thing else {}


def _at_either(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the second of two places of which one is meant, as the first is one ("it's in the hall or else
    *under the desk*")."""
    kept = list(arguments)
    for joint, place in other_places(document, tasks):
        ends = (joint, joint - 1) if document.tokens[joint - 1].text == "," else (joint,)
        first = next((a for a in kept if a.type in _PLACES and a.tokens.stop in ends), None)
        if first is not None:
            kept = [a for a in kept if set(a.tokens).isdisjoint(place)]
            kept.append(FoundArgument(first.type, first.owner, place, CERTAIN))
    return kept


def _taken_up_behind(document: Document, verb: int) -> dict[str, range]:
    """The pronoun right behind a verb as its object: "wake *him*"."""
    token = document.tokens[verb + 1] if verb + 1 < len(document) else None
    is_object = token is not None and token.lower in ("him", "it", "them", "her") and token.tag == "PRP"
    return {"object": range(verb + 1, verb + 2)} if is_object else {}


def _corrected(observed: Observed, arguments: Sequence[FoundArgument], phrase: range) -> list[FoundArgument]:
    """The arguments with a phrase in place of the last one before it that it may stand for."""
    tokens = observed.document.tokens
    others = [a for a in arguments if not set(a.tokens) & set(phrase)]
    before = [a for a in others if a.tokens.stop <= phrase.start and a.type not in ("state", "manner")]
    known = next((a for a in arguments if a.type == "object" and set(a.tokens) & set(phrase)), None)
    if known is not None and not any((a.owner, a.type) == (known.owner, known.type) for a in before):
        return list(arguments)  # found as it is, and what it corrects was not
    sentences = observed.document.sentences
    before.sort(key=lambda a: a.tokens.stop)
    is_new = bool(before) and sentences[phrase.start] != sentences[before[-1].tokens.start]
    is_led = tokens[phrase.start].pos == "ADP"
    if is_led or is_new or tokens[phrase.stop - 1].lower in ("one", "ones"):
        before = [a for a in before if (tokens[a.tokens.start].pos == "ADP") == is_led] or before
    if not before:
        return list(arguments)
    wrong = before[-1]
    return [*(a for a in others if a is not wrong), replace(wrong, tokens=phrase)]


def _is_of_wish(tasks: Mapping[int, str], argument: FoundArgument) -> bool:
    """Whether it is who wishes for what is then only picked up: nobody is given what is taken."""
    is_ahead = argument.tokens.start < argument.owner
    return is_ahead and argument.type == "recipient" and tasks.get(argument.owner) == "taking"


def _is_of_nobody(document: Document, argument: FoundArgument) -> bool:
    """Whether it is the "one" of "if no one is in": a negation names nothing."""
    return argument.type == "object" and set(argument.tokens) <= set(nobody(document, argument.owner))


def _called(document: Document, arguments: Sequence[FoundArgument], fetching: int) -> list[FoundArgument]:
    """The arguments with who is fetched as the object where the order names nothing else: "if she cries, get *me*"."""
    whom, end = range(fetching + 1, fetching + 2), fetching + 2
    is_end = end >= len(document) or document.tokens[end].text in MARKS
    own = {a.type for a in arguments if a.owner == fetching and a.tokens != whom}
    if document.tokens[fetching].lemma not in ("get", "fetch") or not is_end or "object" in own:
        return list(arguments)
    return [replace(a, type="object") if (a.owner, a.tokens) == (fetching, whom) else a for a in arguments]


def _served(document: Document, arguments: Sequence[FoundArgument], bringing: int) -> list[FoundArgument]:
    """The arguments with what is brought along as part of the thing right behind which it stands: "bring me *my coffee
    with two biscuits*"; not how or in what it is brought ("with care", "with my regards")."""
    taken = {i for a in arguments for i in a.tokens}
    stops = {phrase.start: phrase.stop for phrase in noun_chunks(document)}
    return [
        replace(a, tokens=range(a.tokens.start, stop))
        if (a.owner, a.type) == (bringing, "object")
        and a.tokens.start > bringing
        and not is_pronoun(document, a.tokens)
        and (stop := _with_behind(document, a.tokens.stop, stops))
        and taken.isdisjoint(range(a.tokens.stop, stop))
        else a
        for a in arguments
    ]


def _with_behind(document: Document, at: int, stops: Mapping[int, int]) -> int:
    """Where a "with" and a thing end that stand at a token; 0 where none do."""
    tokens, stop = document.tokens, stops.get(at + 1, 0)
    is_thing = stop and tokens[at].lower == "with" and tokens[at + 1].tag in ("DT", "CD", "PRP$")
    if not is_thing or tokens[stop - 1].lemma in _REGARDS:
        return 0
    return stops.get(stop + 1, stop) if [token.lower for token in tokens[stop : stop + 1]] == ["of"] else stop


def _undenied(document: Document, argument: FoundArgument) -> FoundArgument:
    """The argument of a check without the "no" ahead of its noun, which denies the condition: "if no *lamp* is on". In
    "none of the lamps" the words pick one."""
    words = [document.tokens[i].lower for i in argument.tokens]
    if argument.type != "object" or len(words) < 2 or words[0] != "no" or words[1] == "one":
        return argument
    return replace(argument, tokens=range(argument.tokens.start + 1, argument.tokens.stop))


def _is_said_again(document: Document, argument: FoundArgument, others: Sequence[FoundArgument]) -> bool:
    """Whether what stands before the verb of its task is taken up behind it: "I need *the map*, can you fetch it",
    "*the book*, bring it here"."""
    if argument.tokens.start > argument.owner or argument.type not in _TAKEN_UP:
        return False
    said = [t.lower for t in document.tokens[argument.tokens.start : argument.tokens.stop]]
    if said[-1] in _TAKEN_UP[argument.type]:
        return False
    for other in others:
        if (other.owner, other.type) == (argument.owner, argument.type) and other.tokens.start > other.owner:
            words = [t.lower for t in document.tokens[other.tokens.start : other.tokens.stop]]
            if words == said or (len(words) == 1 and words[0] in _TAKEN_UP[argument.type]):
                return True
    return False


def _meant(document: Document, tasks: Mapping[int, str], argument: FoundArgument) -> FoundArgument:
    """The argument; where somebody is to whom something is brought is no source but the goal ("he's in the garden")."""
    if argument.type != "source" or tasks.get(argument.owner) != "bringing":
        return argument
    first = argument.tokens.start
    starts = range(max(0, first - 4), first)
    is_of_somebody = any(first in (whereabouts(document, at) or ()) for at in starts)
    return replace(argument, type="goal") if is_of_somebody else argument


def _whereabouts(
    document: Document, tasks: Mapping[int, str], argument: FoundArgument, others: Sequence[FoundArgument]
) -> FoundArgument:
    """The argument; the place that is told right behind a thing is of the order that names it: "open the new carton,
    it's *in the fridge*, and pour the old one away"."""
    first = argument.tokens.start
    words = [token.lower for token in document.tokens[max(0, first - 3) : first]]
    if argument.type not in _PLACES or words[:1] != [","] or words[1:] not in _IT_IS:
        return argument
    named = (a for a in others if a.type == "object" and a.tokens.stop == first - 3 and a.owner < a.tokens.start)
    order = next((a.owner for a in named), None)
    kind = tasks.get(argument.owner if order is None else order)
    if order is None or kind not in _ORDERED or argument.owner < order:
        return argument
    return replace(argument, owner=order, type="location" if kind == "change_state" else "source")


def _done_by_nobody(document: Document, verb: int) -> dict[str, range]:
    """What nobody does something to, as the object of the check: "if nobody answers *the phone*"."""
    things = (phrase for phrase in noun_chunks(document) if phrase.start == verb + 1)
    is_act = document.tokens[verb].tag in ("VBZ", "VBP", "VBD") and document.tokens[verb].lemma not in _STATING
    thing = next(things, None) if is_act and nobody(document, verb) else None
    if thing is None or document.tokens[thing.start].tag not in ("DT", "PRP$"):
        return {}
    return {} if document.tokens[thing.stop - 1].dep == "npadvmod" else {"object": thing}  # "nobody comes this morning"


def _departed(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments of a check with where somebody has gone as how they are, and who: "after *we*'ve gone *to bed*"."""
    own = {a.type for a in arguments if a.owner == check}
    tokens = document.tokens
    if "goal" not in own or "state" in own or tokens[check].lemma != "go":
        return list(arguments)
    kept = [replace(a, type="state") if (a.owner, a.type) == (check, "goal") else a for a in arguments]
    subject = next((i for i in document.children[check] if tokens[i].dep == "nsubj" and tokens[i].tag == "PRP"), None)
    if subject is None or "object" in own:
        return kept
    return [*kept, FoundArgument("object", check, range(subject, subject + 1), CERTAIN)]


def _of_days(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the day or the meal that a thing is from as part of it: "*the soup from yesterday*"."""
    days = {first: stop for first in range(len(document)) if (stop := _day_behind(document, first)) > 0}
    ends = {a.tokens.stop for a in arguments if a.type == "object" and not is_pronoun(document, a.tokens)}
    dated = {first: days[first] for first in days.keys() & ends}
    rest = [replace(a, tokens=range(dated.get(a.tokens.start, a.tokens.start), a.tokens.stop)) for a in arguments]
    return [
        replace(a, tokens=range(a.tokens.start, dated[a.tokens.stop]))
        if a.type == "object" and a.tokens.stop in dated
        else a
        for a in rest
        if a.tokens
    ]


def _day_behind(document: Document, first: int) -> int:
    """Where a "from yesterday" or "from last night" ends; 0 where none begins."""
    words = [token.lower for token in document.tokens[first : first + 3]]
    if words[:1] != ["from"] or len(words) < 2:
        return 0
    if words[1] in _MEALS:
        return first + 2
    return first + 3 if words[1:] and words[1] in ("last", "this") and words[2:] and words[2] in _TIMES_OF_DAY else 0


def _of_spills(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments; where something is spilt is where it is cleaned up, not where what it is cleaned with is fetched
    from ("juice is *on the rug*, get a cloth and wipe it up")."""
    tokens, kept = document.tokens, list(arguments)
    for fetching, cleaning in pairwise(sorted(tasks)):
        if tasks[fetching] not in ("taking", "bringing") or tokens[cleaning].lemma not in CLEANING:
            continue
        said = {
            tokens[a.tokens.stop - 1].lemma for a in kept if a.owner == fetching < a.tokens.start and a.type == "object"
        }
        is_taken_up = any(a.owner == cleaning and a.type == "object" and is_pronoun(document, a.tokens) for a in kept)
        if not said & INSTRUMENTS or not is_taken_up or said & {token.lemma for token in tokens[:fetching]}:
            continue
        for i, a in enumerate(kept):
            if a.owner in (fetching, cleaning) and a.type in _PLACES and a.tokens.stop <= fetching:
                kept[i] = replace(a, type="location", owner=cleaning)
    return kept


def _divided(document: Document, arguments: Sequence[FoundArgument], bringing: int) -> list[FoundArgument]:
    """The arguments, with what stands right behind a verb of giving as who gets it, then what: "give the dog water",
    "bring the guests towels"; where nothing else says who gets it."""
    own = {a.type: a for a in arguments if a.owner == bringing}
    both = own.get("object")
    if both is None or both.tokens.start != bringing + 1 or {"recipient", "goal"} & own.keys():
        return list(arguments)
    nouns = [document.tokens[j] for j in both.tokens if document.tokens[j].pos in ("NOUN", "PROPN")]
    if len(nouns) < 2 or nouns[-1].i != both.tokens.stop - 1 or nouns[0].i + len(nouns) != both.tokens.stop:
        return list(arguments)
    whom, verb = nouns[-2], document.tokens[bringing].lemma
    is_name = nouns[0].i == both.tokens.start and all(noun.tag == "NNP" for noun in nouns[:-1])
    is_living = is_name or whom.lemma in PERSON_NOUNS | ANIMALS
    is_whom = (verb in _HANDING and is_living) or is_name or whom.tag == "NNS" or whom.lemma in PERSON_NOUNS - _OWNING
    if (len(nouns) > 2 and not is_name) or verb not in _CARRYING or not is_whom:
        return list(arguments)
    others = [a for a in arguments if a is not both]
    recipient = replace(both, type="recipient", tokens=range(both.tokens.start, nouns[-1].i))
    return [*others, recipient, replace(both, tokens=range(nouns[-1].i, both.tokens.stop))]


def _accompanied(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with what is handled along with a thing: part of its words where it stands right behind them
    ("fetch *the drill along with the cable*"), else another object ("carry it out together with *the flowers*")."""
    tokens, kept = document.tokens, list(arguments)
    phrases = {phrase.start: phrase for phrase in noun_chunks(document)}
    for i in range(1, len(tokens) - 2):
        phrase = phrases.get(i + 2)
        if tokens[i].lower not in _ALONG or tokens[i + 1].lower != "with" or phrase is None:
            continue
        verb = max((token for token in tasks if token < i), default=None)
        if verb is None or tasks[verb] not in _HANDLING or not _is_of_clause(document, verb, i):
            continue
        if any(not set(a.tokens).isdisjoint(phrase) for a in kept if a.owner != verb or a.tokens.start < i):
            continue
        things = [a for a in kept if (a.owner, a.type) == (verb, "object") and a.tokens.start < i]
        if not things:
            continue
        known = (a.tokens.stop for a in kept if a.type == "object" and a.tokens.start in (i + 1, phrase.start))
        phrase = range(phrase.start, max(phrase.stop, *known, 0))
        kept = [a for a in kept if set(a.tokens).isdisjoint(range(i, phrase.stop))]
        last = things[-1]
        if last.tokens.stop == i and not is_pronoun(document, last.tokens):
            kept = [replace(a, tokens=range(a.tokens.start, phrase.stop)) if a is last else a for a in kept]
        else:
            kept.append(FoundArgument("object", verb, phrase, CERTAIN))
    return kept


def _chosen(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments, with two of one kind and task that no more than an "or" parts as one: "if *the radio or the fan*
    is on"."""
    kept: list[FoundArgument] = []
    for argument in sorted(arguments, key=lambda a: a.tokens.start):
        before = next((a for a in reversed(kept) if a.tokens.stop + 1 == argument.tokens.start), None)
        behind = document.tokens[argument.tokens.stop :][:1]
        is_clause = argument.tokens.stop > argument.owner and any(token.pos in ("AUX", "VERB") for token in behind)
        is_choice = document.tokens[argument.tokens.start - 1].lower == "or" and not is_clause
        if before is not None and is_choice and (before.type, before.owner) == (argument.type, argument.owner):
            whole = replace(before, tokens=range(before.tokens.start, argument.tokens.stop))
            kept[kept.index(before)] = whole
        else:
            kept.append(argument)
    return kept


def _is_of_clause(document: Document, verb: int, at: int) -> bool:
    """Whether a word stands in the clause of a verb before it."""
    return not any(token.lower in MARKS - {"-"} for token in document.tokens[verb:at])


def _given(arguments: Sequence[FoundArgument], bringing: int, whom: range) -> list[FoundArgument]:
    """The arguments with the recipient that a "for Ella" tells, where nobody else gets it."""
    is_taken = any(
        set(a.tokens) & set(whom) or (a.owner == bringing and a.type in ("recipient", "goal")) for a in arguments
    )
    return [*arguments, FoundArgument("recipient", bringing, whom, CERTAIN)] if whom and not is_taken else [*arguments]


def _identified(observed: Observed, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with who or what it is as the state of "it", where somebody was spoken of before: "Somebody is at
    the door. If it's the plumber, ..."; where only "who" was asked for, "it" names nothing."""
    tokens = observed.document.tokens
    is_it = check > 0 and tokens[check].lower in _BE and tokens[check - 1].lower == "it"
    said = {token.lower for token in tokens[: max(0, check - 1)]}
    is_asked = said.isdisjoint(_UNNAMED)  # "ask who it is. If it's the plumber, ..."
    is_typed = is_asked and tokens[check].lower == "its"  # for "it's"
    if not (is_it or is_typed) or said.isdisjoint(_UNNAMED | {"who"}):
        return list(arguments)
    it = FoundArgument("object", check, range(check - is_it, check), CERTAIN)
    own = [a for a in arguments if a.owner == check and a.type in ("object", "state") and a.tokens != it.tokens]
    if is_asked and not own:
        names = (chunk for chunk in noun_chunks(observed.document) if chunk.start == check + 1)
        own = [FoundArgument("object", check, name, CERTAIN) for name in names]
    if len(own) != 1 or own[0].tokens.start != check + 1 or tokens[check + 1].pos not in _NOMINAL:
        return list(arguments)
    others = [a for a in arguments if a is not own[0] and set(a.tokens).isdisjoint(it.tokens)]
    if is_asked:
        return [*others, replace(own[0], type="object")]
    return [*others, it, replace(own[0], type="state")]


def _named(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with what a condition says something is: the object where "it" names nothing ("if it's *my
    cousin*"), else the state of what is spoken of ("if that noise is *the dryer*", "if that was *the last one*")."""
    identity = identity_of(document, check)
    if identity is None:
        return list(arguments)
    order = order_behind(document, identity)
    said = {*identity.subject, *identity.name, order}
    kept = [a for a in arguments if a.owner != order or document.tokens[a.tokens.start - 1].lower != "for"]
    others = [a for a in kept if a.owner != check or said.isdisjoint(a.tokens) or a.type not in _OF_CHECKS]
    own = {a.type: a for a in kept if a not in others}
    is_it = document.tokens[identity.subject.start].lower in ("it", "they")
    is_of_it = "object" in own and own["object"].tokens == identity.subject
    is_first = not any(a.tokens.stop <= identity.subject.start for a in kept)
    is_told = is_it and "state" in own and own["state"].tokens.start in identity.name and (is_of_it or not is_first)
    is_new = is_it and not is_told and not is_of_it and (is_first or not identity.is_of_order(document))
    is_new = is_new and not any(a.owner == check and a.type == "object" for a in others)
    if is_new or (is_it and identity.is_of_person(document) and not (is_told and is_of_it)):
        return [*others, FoundArgument("object", check, identity.name, CERTAIN)]
    if is_told or (not is_it and identity.is_pronoun(document) and not identity.is_of_order(document)):
        return kept
    subject = FoundArgument("object", check, identity.subject, CERTAIN)
    return [*others, subject, FoundArgument("state", check, identity.name, CERTAIN)]


def _told(arguments: Sequence[FoundArgument], check: int, told: Mapping[str, range]) -> list[FoundArgument]:
    """The arguments with what an idiom tells of a check: in place of what lies within its words, but for what is of
    the right type already."""
    kept = list(arguments)
    for name, tokens in told.items():
        own = {a.type: a for a in kept if a.owner == check and a.type in _OF_CHECKS}
        if name == "location" and "state" in own:
            continue
        if name in own and not set(own[name].tokens) < set(tokens):
            continue
        kept = [a for a in kept if not set(a.tokens) <= set(tokens)]
        if not any(set(a.tokens) & set(tokens) for a in kept):
            kept.append(FoundArgument(name, check, tokens, CERTAIN))
    return kept


def _asked(
    document: Document, arguments: Sequence[FoundArgument], check: int, tasks: Mapping[int, str]
) -> list[FoundArgument]:
    """The arguments, with what a "how full the jug is" is about as the object of its check, and without a state of that
    where a later check may say one."""
    thing = degree_asked(document, check)
    if not thing:
        return list(arguments)
    is_said_later = any(token > check and kind == "check_state" for token, kind in tasks.items())
    kept = [a for a in arguments if a.owner != check or a.type not in ("object", "state")]
    kept = [a for a in kept if set(a.tokens).isdisjoint(thing)]
    states = [a for a in arguments if (a.owner, a.type) == (check, "state")]
    return [*kept, FoundArgument("object", check, thing, CERTAIN), *([] if is_said_later else states)]


def answered(document: Document, verb: int, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a verb without those that only a question before it has: of "No milk in the fridge? Bring me
    water", the milk and the fridge; of "Any milk in the fridge? Bring me some", the milk alone."""
    of = document.sentences
    asking = {of[token.i] for token in document.tokens if "?" in token.text and of[token.i] < of[verb]}
    own = {argument.type: argument.tokens for argument in arguments if of[argument.tokens.start] == of[verb]}
    refused = {of[a.tokens.start] for a in arguments if a.type in own and not is_pronoun(document, own[a.type])}
    dropped = asking & refused
    return [a for a in arguments if of[a.tokens.start] not in (asking if a.type in own else dropped)]


def retracted(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a task without those that are taken back ("the knife, no, wait, the fork") or denied ("not to me
    but to Tom")."""
    in_order = sorted(arguments, key=lambda argument: argument.tokens.start)
    taken_back = {
        id(argument)
        for argument, after in pairwise(in_order)
        if argument.type == after.type
        and _is_taken_back(document.tokens[argument.tokens.stop : after.tokens.start])
        and not {token.lower for token in document.tokens[after.tokens.stop : after.tokens.stop + 2]} & _ADDING
    }
    taken_back |= {
        id(argument)
        for argument, after in pairwise(in_order)
        if (argument.type == after.type or {argument.type, after.type} <= _RECEIVING)
        and _is_denied(document, range(argument.tokens.start, after.tokens.start))
    }
    return [argument for argument in arguments if id(argument) not in taken_back]


def _is_denied(document: Document, words: range) -> bool:
    """Whether words behind a "not" have others behind a "but" in their place: "not *to Anna but* to Tom"."""
    before = document.tokens[words.start - 1].lower if words.start else ""
    return before == "not" and document.tokens[words.stop - 1].lower == "but"


def _is_taken_back(between: Sequence[Token]) -> bool:
    words = [token.lower for token in between if token.text[0].isalnum()]
    return not _CORRECTING.isdisjoint(words) and _AROUND_CORRECTIONS.issuperset(words)


def naming(document: Document, verb: int, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a check without the "it" of weather and time, which names nothing ("if it's raining"); of a word
    that tells of things as well ("if it is foggy") only where nothing is named before."""
    words = [token.lower for token in document.tokens[verb : verb + 7]]
    said = list(dropwhile(_BEFORE_WEATHER.__contains__, words))
    is_outside = said[:1] != [] and said[0] in _TEMPERATURES and said[1:2] != [] and said[1] in _OUTSIDE
    if not said or not (is_outside or said[0] in WEATHER):
        return list(arguments)
    if said[0] in _OF_THINGS and any(token.pos in ("NOUN", "PROPN") for token in document.tokens[:verb]):
        return list(arguments)
    return [a for a in arguments if len(a.tokens) > 1 or document.tokens[a.tokens.start].lower != "it"]


def reported(arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a verb of informing: what stands right behind its message is part of it."""
    found: list[FoundArgument] = []
    for argument in sorted(arguments, key=lambda a: a.tokens.start):
        before = found[-1] if found else None
        if argument.type not in _OF_REPORTS and before and before.type == "message" and _adjoin(before, argument):
            found[-1] = replace(before, tokens=range(before.tokens.start, argument.tokens.stop))
        else:
            found.append(argument)
    return found


def _adjoin(one: FoundArgument, other: FoundArgument) -> bool:
    return one.tokens.stop == other.tokens.start


def completed(document: Document, tokens: range, taken: Container[int]) -> range:
    """The tokens of an argument; where they end in an article, a preposition or the like, with the words up to its
    noun as well, as far as those are not `taken`. The "rid of" of "get rid of it" belongs to the verb."""
    start, stop = tokens.start, tokens.stop
    if len(tokens) > 1 and document.tokens[start].lower == "rid":
        start += 1
    if len(tokens) > 1 and document.tokens[start].lower == "of" and start and document.tokens[start - 1].lower == "rid":
        start += 1
    while stop - start > 1 and document.tokens[stop - 1].lower in ("and", "or", "but"):
        stop -= 1
    relative = stop - 1 if document.tokens[stop - 1].pos != "AUX" else stop - 2  # "any lamp *that* is on"
    if start < relative and document.tokens[relative].tag in ("WDT", "WP"):
        stop = relative
    last = document.tokens[stop - 1].lower
    parts = _NOUN_PARTS if last in _NEEDING_A_NOUN else _PHRASE_PARTS if last in _NEEDING_A_PHRASE else frozenset()
    while stop < len(document) and stop not in taken and document.tokens[stop].pos in parts:
        stop += 1
    return range(start, stop)
