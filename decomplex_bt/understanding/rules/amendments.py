"""Amendments: what is certain of an instruction's arguments, whatever a model finds: those that are taken back,
corrected or said aside, and what an idiom tells of its check."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument, FoundArguments
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.certainty import CLEANING, INSTRUMENTS
from decomplex_bt.understanding.references.looks import looks, shouts, sought_by
from decomplex_bt.understanding.references.phrases import (
    PREPOSITIONS,
    is_deed,
    is_pronoun,
    nobody,
)
from decomplex_bt.understanding.references.relatives import found_places
from decomplex_bt.understanding.rules.alternatives import alternatives, other_places
from decomplex_bt.understanding.rules.asides import asides, means_of, reasons, whereabouts
from decomplex_bt.understanding.rules.assurances import with_assured
from decomplex_bt.understanding.rules.bounds import before_orders, is_of_forbidden, up_to_order
from decomplex_bt.understanding.rules.checks import (
    asked,
    departed,
    doing,
    done_by_nobody,
    identified,
    that_there_is,
    with_named_state,
    with_subject,
    with_told,
    with_whole_state,
    without_air,
    without_left,
)
from decomplex_bt.understanding.rules.conditions import without_cases
from decomplex_bt.understanding.rules.contractions import reports
from decomplex_bt.understanding.rules.doors import admitted
from decomplex_bt.understanding.rules.echoes import echoes
from decomplex_bt.understanding.rules.extents import with_features, with_purposes, with_whole_places, without_questions
from decomplex_bt.understanding.rules.fronting import with_fronted
from decomplex_bt.understanding.rules.gapping import with_added, with_gapped
from decomplex_bt.understanding.rules.goals import gone_to, put_in, put_inside, put_out
from decomplex_bt.understanding.rules.guesses import without_guessed
from decomplex_bt.understanding.rules.handing import accompanied, called, divided, fed, given, served
from decomplex_bt.understanding.rules.hearsay import hearsays
from decomplex_bt.understanding.rules.idioms import encountered, for_somebody, foreseen, predicated, troubled
from decomplex_bt.understanding.rules.loading import with_loaded
from decomplex_bt.understanding.rules.mishaps import mishaps
from decomplex_bt.understanding.rules.needs import due, in_need
from decomplex_bt.understanding.rules.pauses import pauses
from decomplex_bt.understanding.rules.plans import plans
from decomplex_bt.understanding.rules.precautions import precautions
from decomplex_bt.understanding.rules.preferences import preferences
from decomplex_bt.understanding.rules.prohibitions import let_be, prohibitions
from decomplex_bt.understanding.rules.questions import with_questions
from decomplex_bt.understanding.rules.relatives import told_apart, with_relative_places, without_excluded
from decomplex_bt.understanding.rules.reports import with_next_told, with_reports, without_times
from decomplex_bt.understanding.rules.rounds import with_rounds
from decomplex_bt.understanding.rules.second_cases import second_cases
from decomplex_bt.understanding.rules.statements import with_nearer_places, without_places_of_others
from decomplex_bt.understanding.rules.telegraph import named
from decomplex_bt.understanding.rules.unspoken import unspoken
from decomplex_bt.understanding.rules.uses import with_uses
from decomplex_bt.understanding.rules.verbless import verbless_cases
from decomplex_bt.understanding.rules.waits import forgone, kept_from
from decomplex_bt.understanding.rules.wishes import backgrounds, wishers
from decomplex_bt.understanding.rules.withdrawals import Withdrawals

_PLACES = frozenset(("source", "location"))
_WHERE_TO = _PLACES | {"goal"}
_TAKEN_UP = {"object": frozenset("it them one some any that those".split()), "recipient": frozenset(("me", "us"))}
"""By what the argument of a type is taken up that was said before its verb."""
_IT_IS = tuple(
    [pronoun, be] for pronoun, be in (("it", "'s"), ("it", "\u2019s"), ("it", "is"), ("they", "'re"), ("they", "are"))
)
_ORDERED = frozenset(("change_state", "bringing", "taking"))
_MEALS = frozenset("yesterday breakfast lunch dinner supper tea".split())
_TIMES_OF_DAY = frozenset("night week morning month year weekend afternoon christmas".split())
_WAYS = frozenset(("path", "manner"))
_OF_REPORTS = frozenset(("message", "recipient", "manner"))
_WITHOUT_THINGS = frozenset(("check_state", "informing", "motion"))
_MOVING = frozenset(("bringing", "taking", "placing"))
_HANDLED = frozenset(("change_state", "taking", "placing", "following"))
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
    idle |= due(document) | forgone(document) | hearsays(document) | precautions(document, tasks)
    idle |= wishers(document, tasks) | let_be(document)
    idle = idle.union(
        *found_places(document),
        *pauses(document),
        *(found.tokens for found in alternatives(observed, tasks) if not found.is_verbal),
    )
    why = reasons(document, tasks)
    kept = [a for a in found.arguments if a.tokens.start not in idle]
    kept = [a for a in kept if a.tokens.start not in why or a.type in _PLACES]
    meant = plans(document, tasks)
    kept = [a for a in kept if a.tokens.start not in meant or _is_place_of_order(tasks, a)]
    how = means_of(document, tasks)
    kept = [a for a in kept if a.tokens.start not in how or a.type in _WAYS]
    kept = without_cases(document, tasks, kept)
    kept = without_questions(document, tasks, with_whole_places(document, kept))
    kept = with_uses(document, with_features(document, tasks, kept))
    kept = with_relative_places(observed, tasks, kept)
    kept = without_excluded(document, tasks, told_apart(document, tasks, kept))
    kept = with_questions(document, tasks, kept)
    kept = _of_spills(document, tasks, [_meant(document, tasks, a) for a in kept])
    kept = _of_days(document, [_whereabouts(document, tasks, a, kept) for a in kept])
    kept = [_relative(document, tasks, _entire(document, a), kept) for a in kept]
    kept = [a for a in kept if not _is_said_again(document, a, kept) and not _is_of_wish(tasks, a)]
    kept = _of_looks(document, tasks, [a for a in kept if not _is_of_nobody(document, a)])
    for phrase in withdrawals.corrections:
        kept = _corrected(observed, kept, phrase)
    for telling, echo in echoes(document, tasks).items():
        kept = [a for a in kept if (a.owner, a.type) != (telling, "message") or not set(a.tokens) & set(echo.tokens)]
    happening = {mishap.verb: mishap.told for mishap in mishaps(document)}
    wishes = {wish.check: wish for wish in preferences(document, tasks)}
    for token, kind in tasks.items():
        if kind == "placing":
            kept = put_out(document, put_in(observed, with_loaded(observed, kept, token), token), token)
            kept = put_inside(document, gone_to(document, kept, token), token)
        if kind == "bringing":
            kept = divided(document, kept, token)
            kept = given(kept, token, for_somebody(document, token))
            kept = called(document, kept, token)
            kept = served(document, kept, token)
            kept = with_told(kept, token, {"object": said} if (said := troubled(document, token)) else {})
        if kind == "change_state":
            kept = [a for a in kept if a.owner != token or not is_of_forbidden(document, a)]
            kept = _given_once(document, fed(document, kept, token))
            if whom := admitted(document, token):
                kept = [a for a in kept if a.owner != token or not set(a.tokens) & set(range(token, whom.stop + 1))]
                kept.append(FoundArgument("object", token, whom, CERTAIN))
        if kind == "check_state":
            kept = [_undenied(document, a) if a.owner == token else a for a in kept]
            kept = with_whole_state(document, that_there_is(document, kept, token), token)
            kept = without_left(document, kept, token)
            kept = departed(document, kept, token)
            kept = with_told(kept, token, done_by_nobody(document, token))
            kept = with_told(kept, token, doing(document, token))
            kept = with_told(kept, token, happening.get(token, {}))
            kept = _of_now(document, kept, token)
            kept = with_told(kept, token, before_orders(tasks, predicated(document, token)))
            kept = wishes[token].told(kept) if token in wishes else kept
            kept = asked(document, kept, token, tasks)
            kept = with_named_state(document, identified(observed, kept, token), token)
            kept = without_air(document, with_subject(document, kept, token), token)
        if kind == "informing":
            kept = without_times(document, with_reports(document, tasks, kept, token), token)
            kept = with_next_told(document, kept, token)
        if kind == "searching" and (met := encountered(document, token)):
            kept = [a for a in kept if not {met.start - 1, *met} & {*a.tokens}]
            kept.append(FoundArgument("object", token, met, CERTAIN))
        if kind == "searching" and document.tokens[token].lemma == "meet":
            kept = [replace(a, type="location") if (a.owner, a.type) == (token, "goal") else a for a in kept]
        if kind == "searching":
            kept = with_rounds(document, tasks, kept, token)
        if not any(a.owner == token and len(a.tokens) > 1 for a in kept):
            kept = with_told(kept, token, kept_from(document, tasks, token))
        if kind in _HANDLED and not any(a.owner == token and token + 1 in a.tokens for a in kept):
            kept = with_told(kept, token, _taken_up_behind(document, token))
        if kind not in _WITHOUT_THINGS and not any((a.owner, a.type) == (token, "object") for a in kept):
            kept = with_told(kept, token, in_need(observed, token) or _telegraphed(document, token))
    for report in reports(document, tasks):
        if report.message:
            kept = [a for a in kept if a.tokens.start not in report.message]
            kept.append(FoundArgument("message", report.verb, report.message, CERTAIN))
    for fragment in unspoken(observed, tasks):
        if fragment.carrier in tasks:
            kept = [argument for argument in kept if set(argument.tokens).isdisjoint(fragment.tokens)]
            kept += [FoundArgument(name, fragment.carrier, said, CERTAIN) for name, said in fragment.told.items()]
    kept = with_assured(document, tasks, kept)
    for case in second_cases(document):
        if case.carrier in tasks:
            ahead = range(case.tokens.start)
            kept = [
                replace(a, tokens=range(a.tokens.start, min(a.tokens.stop, ahead.stop)))
                if a.tokens.start in ahead
                else a
                for a in kept
            ]
            kept = [a for a in kept if a.tokens.start not in case.tokens]
            kept += [FoundArgument(name, case.carrier, said, CERTAIN) for name, said in case.told.items()]
    for case in verbless_cases(document, tasks):
        within = [argument for argument in kept if not set(argument.tokens).isdisjoint(case.tokens)]
        last = [document.tokens[a.tokens[-1]] for a in within if a.owner == case.carrier]
        is_named = any(token.pos in ("NOUN", "PROPN", "NUM") or token.lower in ("one", "ones") for token in last)
        if case.carrier in tasks and not is_named:
            kept = [argument for argument in kept if argument not in within]
            kept += [FoundArgument(name, case.carrier, said, CERTAIN) for name, said in case.told.items()]
    kept = _at_either(document, tasks, _chosen(document, kept))
    kept = with_gapped(observed, tasks, accompanied(document, tasks, kept))
    kept = with_fronted(observed, tasks, with_added(observed, tasks, kept))
    kept = with_purposes(document, tasks, without_places_of_others(observed, tasks, kept))
    kept = [up_to_order(document, tasks, a) for a in kept]
    kept = without_guessed(document, with_nearer_places(document, tasks, kept))
    kept = [a for a in kept if not _is_bare_preposition(document, a)]
    return FoundArguments(tuple(sorted(kept, key=lambda argument: argument.tokens.start)), found.probability)


def _is_bare_preposition(document: Document, argument: FoundArgument) -> bool:
    """Whether nobody is named by whom somebody is told something: "knock *on* the door"."""
    is_single = argument.type == "recipient" and len(argument.tokens) == 1
    return is_single and document.tokens[argument.tokens.start].lower in PREPOSITIONS - {"to", "for", "with"}


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


def _given_once(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments without the deed that something is given, which is no thing: "give it *a wipe*"."""
    return [a for a in arguments if not is_deed(document, a.tokens)]


def _is_of_wish(tasks: Mapping[int, str], argument: FoundArgument) -> bool:
    """Whether it is who wishes for what is then only picked up: nobody is given what is taken."""
    is_ahead = argument.tokens.start < argument.owner
    return is_ahead and argument.type == "recipient" and tasks.get(argument.owner) == "taking"


def _is_place_of_order(tasks: Mapping[int, str], argument: FoundArgument) -> bool:
    """Whether it tells where something is done that is ordered."""
    return argument.type in _WHERE_TO and tasks.get(argument.owner) != "check_state"


def _of_now(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments, none of which goes on from what is spoken of to what is to come: "*Tom*'s gonna be late"."""
    coming = foreseen(document, check)
    if not coming:
        return list(arguments)
    kept = [a for a in arguments if a.type == "state" or a.tokens.start not in coming]
    return [
        replace(a, tokens=range(a.tokens.start, check)) if a.tokens.start < check < a.tokens.stop else a for a in kept
    ]


def _of_looks(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments without looks, which are no things, and with what is given one as its place: "give *the shed* a
    quick scan"."""
    kept = list(arguments)
    for look in (*looks(document), *shouts(document)):
        kept = [a for a in kept if a.tokens.start not in look.words]
        is_whole = tasks.get(look.verb) != "searching" or any(a.owner == look.verb and a.type == "object" for a in kept)
        if not is_whole and (sought := sought_by(document, look)):
            kept = [a for a in kept if set(a.tokens).isdisjoint(sought)]
            kept.append(FoundArgument("object", look.verb, sought, CERTAIN))
        if look.place and tasks.get(look.verb) == "searching":
            kept = [a for a in kept if set(a.tokens).isdisjoint(look.place)]
            kept.append(FoundArgument("location", look.verb, look.place, CERTAIN))
    return kept


def _is_of_nobody(document: Document, argument: FoundArgument) -> bool:
    """Whether it is the "one" of "if no one is in": a negation names nothing."""
    return argument.type == "object" and set(argument.tokens) <= set(nobody(document, argument.owner))


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


def _entire(document: Document, argument: FoundArgument) -> FoundArgument:
    """An "upside" with the "down" behind it, who is spoken of without the verb ("if *Ann* can't"), and a back with
    whose it is ("if *my father's back* is aching")."""
    start, end = argument.tokens.start, argument.tokens.stop
    last, behind = document.tokens[end - 1], document.tokens[end : end + 1]
    if last.lower == "upside" and behind and behind[0].lower == "down":
        return replace(argument, tokens=range(start, end + 1))
    after = document.tokens[end + 1 : end + 2]
    is_back = last.tag == "POS" and behind and behind[0].lower == "back" and after and after[0].pos in ("AUX", "VERB")
    if is_back and argument.owner > end:
        return replace(argument, tokens=range(start, end + 1))
    is_verb = last.lower in ("ca", "wo") and len(argument.tokens) > 1 and argument.type != "message"
    return replace(argument, tokens=range(start, end - 1)) if is_verb else argument


def _relative(
    document: Document, tasks: Mapping[int, str], argument: FoundArgument, arguments: Sequence[FoundArgument]
) -> FoundArgument:
    """What is brought or put somewhere is no message: "bring him *what he asks for*"."""
    first = document.tokens[argument.tokens.start].lower
    is_moved = argument.type == "message" and tasks[argument.owner] in _MOVING and first in ("what", "whatever")
    is_said = any((a.owner, a.type) == (argument.owner, "object") for a in arguments)
    return replace(argument, type="object") if is_moved and not is_said else argument


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
