"""Extents: how far the words of a thing go: what it has on it or in it, what it is for, and where a question begins."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.compounds import ends_compound
from decomplex_bt.understanding.vocabulary import ONES, PASSAGES, PERSON_NOUNS

_NAMED = frozenset("one ones those anything something anyone somebody someone".split())
"""What names a thing besides nouns: "the ones *with the foxes on it*"."""
_MARKING = frozenset(("with", "without", "about"))
_AT_IT = frozenset("on in inside round around under over".split())
_IT = frozenset(("it", "them", "'em", "em"))
_JOINING = frozenset((",", "and", "or"))
_DAYS = frozenset("today tonight tomorrow".split())
_PARTS_OF_DAY = frozenset("morning afternoon evening night".split())
_SPANS_OF_TIME = frozenset("second minute hour day week month year while moment bit time".split())
_EXISTING = frozenset(("there", "have", "got", "has"))
_STILL = frozenset("still already now all both".split())
_CUT_OFF = frozenset("in on at by under within behind".split())
_PLACES = frozenset(("location", "source", "goal"))
_CLAUSE_OPENERS = frozenset(("whether", "if"))
_SHUTTING = frozenset(("open", "close", "shut"))
_LOCKING = frozenset("lock unlock bolt unbolt latch unlatch".split())
_BOLTED = PASSAGES | {"trapdoor", "grille"}
"""What is locked to nothing else, as a bicycle may be."""
_SIDES = frozenset("left right side end stop max maximum minimum".split())
"""What tells which one is meant, or how far it is opened."""
_ASKING = frozenset("can will could would".split())
_OPENING = frozenset("after once when before if as while".split())
_BETWEEN = frozenset("please just also then kindly".split())


def with_features(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with what a thing has on it or in it as part of its words: "a box *with holes in it*". Where
    nothing else says where something is put, that is no feature: "put the vase *with the others on it*"."""
    kept = list(arguments)
    if "with" not in document.words or document.words.isdisjoint(_IT):
        return kept
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    for token in document.tokens:
        stop = _feature_end(document, stops, token.i) if token.lower == "with" else 0
        thing = next((a for a in kept if _has_feature(document, kept, a, token.i)), None) if stop else None
        if thing is None or any(i in tasks for i in range(token.i, stop)):
            continue
        whole = range(thing.tokens.start, max(stop, thing.tokens.stop))
        rest = [_behind(a, whole) for a in kept if a is not thing]
        others = [a for a in rest if a is not None]
        is_put = tasks[thing.owner] == "placing" and thing.type == "object"
        is_put = is_put and document.tokens[thing.owner].lemma != "keep"  # what is kept goes nowhere
        if not is_put or any((a.owner, a.type) == (thing.owner, "goal") for a in others):
            kept = [*others, replace(thing, tokens=whole)]
    return kept


def _feature_end(document: Document, stops: Mapping[int, int], at: int) -> int:
    """Where a "with my name on it" ends that begins at a token; 0 where none does."""
    tokens, stop = document.tokens, stops.get(at + 1, 0)
    while stop and stop < len(tokens) and tokens[stop].lower in _JOINING and stop + 1 in stops:
        stop = stops[stop + 1]
    words = [token.lower for token in tokens[stop : stop + 2]]
    return stop + 2 if stop and len(words) == 2 and words[0] in _AT_IT and words[1] in _IT else 0


def _has_feature(document: Document, arguments: Sequence[FoundArgument], thing: FoundArgument, at: int) -> bool:
    """Whether the "with" at a token tells which thing is meant, not what something is done with."""
    before = document.tokens[at - 1] if at else None
    if before is None or thing.type not in ("object", "goal"):
        return False
    is_named = before.pos in ("NOUN", "PROPN") or before.lower in _NAMED
    is_behind = thing.tokens.start < at and (at in thing.tokens or at == thing.tokens.stop)
    is_means = any(a.type == "manner" and a.tokens.start == at for a in arguments)
    return is_named and is_behind and not is_means


def _behind(argument: FoundArgument, whole: range) -> FoundArgument | None:
    """An argument as far as it stands outside the words of a thing; None where nothing is left of it."""
    if argument.tokens.start not in whole:
        return argument
    rest = range(whole.stop, argument.tokens.stop)
    return replace(argument, tokens=rest) if rest else None


def with_marks(document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with what tells "the one" from all others as part of their words: "the one *without a handle*"."""
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    kept = list(arguments)
    for thing in arguments:
        first, last = document.tokens[thing.tokens.start], document.tokens[thing.tokens.stop - 1]
        behind = thing.tokens.stop
        is_cut_off = behind < len(document) and document.tokens[behind].lower in _MARKING and behind + 1 in stops
        if not (is_cut_off and first.lower == "the" and last.lower in ONES):
            continue
        whole = range(thing.tokens.start, stops[behind + 1])
        taken = {i for a in kept if a is not thing for i in a.tokens}
        if taken.isdisjoint(whole) and tasks.keys().isdisjoint(whole):
            kept[kept.index(thing)] = replace(thing, tokens=whole)
    return kept


def with_purposes(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with what the thing is for that a check asks of as part of its words: "the compartment *for
    Tuesday* is full", "enough milk *for tomorrow*". How long is no purpose ("no answer *for a minute*")."""
    return [
        replace(a, tokens=range(a.tokens.start, stop))
        if a.type == "object" and tasks[a.owner] == "check_state" and (stop := _purpose_end(document, a, arguments))
        else a
        for a in arguments
    ]


def _purpose_end(document: Document, thing: FoundArgument, arguments: Sequence[FoundArgument]) -> int:
    tokens, at, check = document.tokens, thing.tokens.stop, thing.owner
    if at + 1 >= len(tokens) or tokens[at].lower != "for" or tokens[at - 1].pos not in ("NOUN", "PROPN"):
        return 0
    stop = at + 2 if tokens[at + 1].lower in _DAYS else 0
    if stop and tokens[stop : stop + 1] and tokens[stop].lower in _PARTS_OF_DAY:
        stop += 1
    stop = stop or next((chunk.stop for chunk in noun_chunks(document) if chunk.start == at + 1), 0)
    if not stop or tokens[stop - 1].lemma in _SPANS_OF_TIME:
        return 0
    if any(a is not thing and not set(a.tokens).isdisjoint(range(at, stop)) for a in arguments):
        return 0
    verb = stop
    while verb < len(tokens) and tokens[verb].lower in _STILL:
        verb += 1
    start = thing.tokens.start
    around = {token.lower for token in (*tokens[max(0, check - 1) : check + 2], *tokens[max(0, start - 2) : start])}
    is_there = thing.tokens.start > check and not around.isdisjoint(_EXISTING)
    return stop if verb == check or is_there else 0


def with_whole_pairs(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with a "both" that was taken for a person as part of the two things behind it: "bring *both* my
    keys and my wallet"; not of "give both a cup and a saucer", which may be two who get them."""
    kept = list(arguments)
    for word in [a for a in arguments if len(a.tokens) == 1 and document.tokens[a.tokens.start].lower == "both"]:
        pair = next((a for a in kept if a.owner == word.owner and a.tokens.start == word.tokens.stop), None)
        if pair is None or document.tokens[pair.tokens.start].lower in ("a", "an", "some"):
            continue
        if any(document.tokens[i].lower == "and" for i in pair.tokens):
            kept[kept.index(pair)] = replace(pair, tokens=range(word.tokens.start, pair.tokens.stop))
            kept.remove(word)
    return kept


def with_whole_places(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the noun of a place that is cut off behind its preposition: "in *the drawer*"."""
    starts, tokens = {a.tokens.start for a in arguments}, document.tokens
    places = [a for a in arguments if a.type in _PLACES and len(a.tokens) == 1 and a.tokens.stop not in starts]
    if all(tokens[a.tokens.start].lower not in _CUT_OFF for a in places):
        return list(arguments)  # as mostly
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    found = []
    for a in arguments:
        is_cut = a in places and tokens[a.tokens.start].lower in _CUT_OFF
        stop = stops.get(a.tokens.stop, 0) if is_cut else 0
        found.append(replace(a, tokens=range(a.tokens.start, stop)) if stop else a)
    return found


def with_passages(document: Document, tasks: Container[int], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with where a door leads to as part of its words: nothing that is opened or shut goes anywhere
    ("shut *the hatch to the loft*", not "open the drawer to your left" or "open the door to Anna")."""
    kept = list(arguments)
    for thing in arguments:
        leading = range(0) if thing.type != "object" else _leading(document, thing)
        if leading and thing in kept and all(i not in tasks for i in leading):
            kept = [a for a in kept if a is thing or a.owner != thing.owner or a.tokens.start not in leading]
            kept[kept.index(thing)] = replace(thing, tokens=range(thing.tokens.start, leading.stop))
    return kept


def _leading(document: Document, thing: FoundArgument) -> range:
    """The "to the loft" behind what is opened or shut; empty where there is none."""
    tokens, at = document.tokens, thing.tokens.stop
    verb, last = tokens[thing.owner].lemma, tokens[at - 1]
    is_shut = verb in _SHUTTING or (verb in _LOCKING and last.lemma in _BOLTED)
    if thing.owner > thing.tokens.start or not is_shut or last.tag not in ("NN", "NNS"):
        return range(0)
    if at >= len(tokens) or tokens[at].lower != "to":
        return range(0)
    where = next((chunk for chunk in noun_chunks(document) if chunk.start == at + 1), range(0))
    if not where or tokens[where.start].pos != "DET" or tokens[where[-1]].lemma in PERSON_NOUNS | _SIDES:
        return range(0)
    return range(at, where.stop)


def with_whole_compounds(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with the last noun of a compound that was taken for a verb or an adjective: "the dog *lead*"."""
    return [
        replace(a, tokens=range(a.tokens.start, a.tokens.stop + 1))
        if a.tokens.stop not in tasks and ends_compound(document, a.tokens.stop)
        else a
        for a in arguments
    ]


def with_whole_clauses(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the clause of which a message has no more than the first word ("whether *she has it*");
    without what somebody has come for as a place ("has he come *to tune the piano*")."""
    tokens, found = document.tokens, []
    for a in arguments:
        words, stop = [tokens[i].lower for i in a.tokens], a.tokens.stop
        behind = [token.tag for token in tokens[a.tokens.start + 1 : a.tokens.start + 3]]
        if a.type == "location" and words[0] == "to" and behind in (["VB", "DT"], ["VB", "PRP$"]):
            continue
        if a.type == "message" and len(words) == 1 and words[0] in _CLAUSE_OPENERS:
            stop = next((i for i in range(stop, len(tokens)) if tokens[i].text in MARKS), len(tokens))
        found.append(replace(a, tokens=range(a.tokens.start, stop)))
    return found


def without_questions(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without the "can" of a question behind them: "after you take out *the trash* can you sweep up?",
    "take out *the trash* can you"."""
    return [
        replace(a, tokens=a.tokens[:-1]) if len(a.tokens) > 1 and _is_question(document, tasks, a) else a
        for a in arguments
    ]


def _is_question(document: Document, tasks: Container[int], argument: FoundArgument) -> bool:
    tokens, at = document.tokens, argument.tokens.stop
    words = [token.lower for token in tokens[at - 1 : at + 1]]
    if argument.owner >= at or len(words) < 2 or words[0] not in _ASKING or words[1] != "you":
        return False
    at += 1
    while at < len(tokens) and tokens[at].lower in _BETWEEN:
        at += 1
    if at >= len(tokens) or tokens[at].text in ENDS:
        return True
    sentence = document.sentences[argument.owner]
    is_opened = any(
        token.lower in _OPENING and document.sentences[token.i] == sentence for token in tokens[: argument.owner]
    )
    return is_opened and at in tasks and tokens[at].lower == tokens[at].lemma and tokens[at - 1].text not in MARKS
