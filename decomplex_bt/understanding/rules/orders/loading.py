"""Loading: what is loaded "with" things is where those are put ("load the dryer *with the sheets*"); what is filled
with water changes its state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

_LOADING = frozenset("load stuff pack stock cram feed fill".split())
_FEEDING = frozenset(("feed",))
_FILLING = frozenset(("fill",))
_STUFFING = frozenset(("stuff", "cram"))
_INTO = frozenset("in into under behind inside on onto".split())
_PRONOUNS = frozenset(("it", "them"))
_DEFINITE = frozenset("the my our your his her their its all both these those every each".split())
_PLURAL = frozenset(("NNS", "NNPS"))
_WASHING = frozenset("laundry washing wash shopping cutlery crockery".split())
"""What is many things though it is no plural."""
_SOME_OF = frozenset("all most some both half".split())
_ENDS = MARKS | frozenset("and or but then if unless when before after until".split())


@dataclass(frozen=True, slots=True)
class Loading:
    """Where a verb puts things, which things, and from where: each with its preposition, empty where it is not said."""

    goal: range
    things: range
    source: range


def loading(observed: Observed, verb: int) -> Loading | None:
    """What is loaded at a verb: "*load* the dishwasher with the plates from the sink"; None for any other verb, for who
    is fed, and for what no more than a stuff fills ("fill the jug with water")."""
    document, lemma = observed.document, observed.document.tokens[verb].lemma
    if lemma not in _LOADING:
        return None
    tokens = document.tokens
    stop = next((token.i for token in tokens[verb + 1 :] if token.lower in _ENDS), len(tokens))
    led = next((i for i in range(verb + 2, stop - 1) if tokens[i].lower == "with"), None)
    if led is None:
        return None
    stops = {chunk.start: chunk.stop for chunk in noun_chunks(document)}
    goal = _goal(document, stops, range(verb + 1, led))
    things = _things(document, stops, led)
    if not goal or not things or not _is_vessel(observed, goal, lemma) or not _are_things(observed, things, lemma):
        return None
    is_from = things.stop + 1 < len(tokens) and tokens[things.stop].lower == "from"
    end = stops.get(things.stop + 1, 0) if is_from else 0
    return Loading(goal, things, range(things.stop, end) if end else range(0))


def is_stuffed(observed: Observed, verb: int) -> bool:
    """Whether something gets a stuff into it, and goes nowhere itself: "*stuff* the boots with newspaper"."""
    tokens = observed.document.tokens
    stop = next((token.i for token in tokens[verb + 1 :] if token.lower in _ENDS), len(tokens))
    words = [token.lower for token in tokens[verb + 2 : stop]]
    is_led = "with" in words[:-1] and _INTO.isdisjoint(words)
    return tokens[verb].lemma in _STUFFING and is_led and loading(observed, verb) is None


def with_loaded(observed: Observed, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments with what a verb loads as what it puts, and with what it is put into as its goal."""
    found = loading(observed, verb)
    if found is None:
        return list(arguments)
    told = {"goal": found.goal, "object": found.things, "source": found.source}
    words = {i for said in told.values() for i in said}
    kept = [a for a in arguments if words.isdisjoint(a.tokens)]
    return kept + [FoundArgument(name, verb, said, CERTAIN) for name, said in told.items() if said]


def _goal(document: Document, stops: Mapping[int, int], words: range) -> range:
    """What is loaded, without the "up" of "load it up" and "load up the van"; empty where the words name none."""
    said = [i for i in words if document.tokens[i].lower != "up"]
    if not said or said != list(range(said[0], said[-1] + 1)):
        return range(0)
    if len(said) == 1 and document.tokens[said[0]].lower in _PRONOUNS:
        return range(said[0], said[0] + 1)
    is_led = (stop := stops.get(said[0], 0)) > said[-1] or (stop and document.tokens[stop].pos == "ADP")
    return range(said[0], said[-1] + 1) if is_led else range(0)


def _things(document: Document, stops: Mapping[int, int], led: int) -> range:
    """The phrase behind a "with", with that, and what an "and" adds to it ("with all of the plates and the cups");
    empty where none begins there."""
    tokens, start = document.tokens, led + 1
    if tokens[start].lower in _SOME_OF and tokens[start + 1 : start + 2] and tokens[start + 1].lower == "of":
        start += 2
    stop = stops.get(start, 0)
    if not stop or [token.lower for token in tokens[stop : stop + 1]] == ["of"]:
        return range(0)
    while stop + 1 < len(tokens) and tokens[stop].lower in ("and", ",") and tokens[stop + 1].lower in _DEFINITE:
        further = stops.get(stop + 1, 0)
        if not further or (further < len(tokens) and tokens[further].lower not in _ENDS | {"from"}):
            break
        stop = further
    return range(led, stop)


def _is_vessel(observed: Observed, goal: range, lemma: str) -> bool:
    """Whether things may be put into what is named: nobody, and where it is fed only a machine."""
    noun = observed.document.tokens[goal[-1]].lemma
    if noun in ANIMALS | PERSON_NOUNS:
        return False
    return lemma not in _FEEDING or observed.gazetteer.category(noun) == "furniture"


def _are_things(observed: Observed, things: range, lemma: str) -> bool:
    """Whether known things are named, or several; what something is *filled* with has to be both told and several."""
    tokens = observed.document.tokens
    last = tokens[things.stop - 1]
    is_definite = any(token.lower in _DEFINITE for token in tokens[things.start + 1 : things.stop - 1])
    if last.tag in _PLURAL or last.lemma in _WASHING:
        return is_definite or lemma not in _FILLING
    is_known = lemma in _FEEDING or observed.gazetteer.category(last.lemma) == "thing"
    return is_definite and is_known and lemma not in _FILLING
