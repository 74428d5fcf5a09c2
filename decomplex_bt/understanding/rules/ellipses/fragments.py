"""Fragments: what is said without a verb: questions whether something is somewhere ("any letters in the mailbox?"),
orders of a state ("lamp off, heater on"), lists of where things go ("sort the shopping: milk in the fridge, ...")."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.states import OPPOSITES
from decomplex_bt.understanding.vocabulary import LEVELS

STOPS = frozenset((".", "?", "!", ";", ":", "...", "…"))
_FILLERS = frozenset("and oh so hey ok okay well but , - then also still".split())
_SOME = frozenset("any some anyone anybody someone somebody anything something more another".split())
_NONE = frozenset("no nobody nothing".split())
_ALONE = frozenset("anyone anybody someone somebody anything something nobody nothing".split())
_WHERE = frozenset("in on at under behind inside by near beside outside".split())
_NOUNS = ("NN", "VBZ", "VBG")
"""Tags of nouns, and those that a tagger gives some of them in a list: "*forks* in the drawer"."""
_PUT = frozenset("in on into onto under behind inside by".split())
_BEHIND = frozenset(
    "then still yet today now already or not please robot , all again anymore there underneath below".split()
)
_IDLE = frozenset(
    "chance idea luck problem need time reason point doubt sign trace news way hope thoughts plan".split()
)
"""Nouns of which no place is asked: "any chance of a drink in the garden?"."""


_SIGNS = frozenset(("sign",))
"""Nouns among these that name a thing unless it is a sign *of* something."""

_PERCEIVING = frozenset("see spot notice find".split())
_ALL = frozenset("all every each both".split())
_DEGREES = frozenset("less more fewer colder hotter warmer higher lower".split())
_LONGEST_AMOUNT = 3
"""The most words of an amount: "four degrees Celsius"."""
_SHORTEST = 2
"""The words at least of what is asked for: "a coin"."""
STATES = frozenset("on off open closed shut".split())
_COVERING = frozenset("blind shade shutter curtain".split())
_LEVELLED = frozenset("music volume sound heating radio telly tv".split())
_REFUSE = frozenset("bin rubbish trash garbage recycling".split())
"""What is taken out."""
_STATES_OF = {
    "out": frozenset("light lamp lantern candle torch fire cat dog".split()) | _REFUSE,
    "up": _COVERING | _LEVELLED, "down": _COVERING | _LEVELLED,
    "locked": frozenset("door gate window safe shed garage".split()), "drawn": _COVERING,
}  # fmt: skip
"""States that are ordered of some things only: "lights *out*", "blinds *down*", "music *up*"."""
_THINGS = frozenset().union(*_STATES_OF.values())
NO_THINGS = frozenset(
    "hand eye finger paw foot day time game back shoe boot sock coat jacket hat cap glove scarf shirt belt seatbelt "
    "glass mask helmet apron slipper".split()
)
"""Nouns of which "hands off", "shoes on" and the like order no state."""
_LEADING = frozenset("please now then so ok okay right and just also otherwise".split())
_FLOORS = frozenset("upstairs downstairs".split())
_TRAILING = frozenset("please now again too everywhere".split())
_NAMING = frozenset(("DET", "ADJ", "NOUN", "PROPN", "NUM"))
_SORTING = frozenset(
    "tidy sort clear arrange organise organize unpack stow straighten declutter empty unload be".split()
)
"""Verbs that a list of what goes where may follow behind a colon; what one brings or looks for is there now."""
_OPENING = frozenset(("if", "when", "once", "unless", "otherwise", "whenever"))


@dataclass(frozen=True, slots=True)
class Fragment:
    """A question or an order without a verb, or a question without a subject. The preposition of the one carries the
    check, the state of the other the change, its verb the search."""

    tokens: range
    carrier: int
    object: range
    """What is asked for, changed or put; empty where it is nobody or nothing."""
    place: range
    """Where, without the preposition that carries a check or a placing."""
    type: str = "check_state"
    state: range = range(0)
    """What day or weather is asked for."""
    recipient: range = range(0)
    """Who is to have it."""

    @property
    def told(self) -> dict[str, range]:
        """The tokens of its arguments, by type."""
        place = "goal" if self.type in ("placing", "bringing", "motion") else "location"
        told = {"object": self.object, "state": self.state, place: self.place, "recipient": self.recipient}
        return {name: tokens for name, tokens in told.items() if tokens}


def fragments(document: Document, names: Collection[str] = frozenset()) -> Iterator[Fragment]:
    """The fragments of a document, in text order; `names`: words that are no verbs but name things, however they are
    tagged ("*telly* off")."""
    tokens = document.tokens
    start = 0
    for i, token in enumerate(tokens):
        if token.text in STOPS:
            if token.text == "?":
                fragment = _fragment(document, start, i)
                if fragment is not None:
                    yield fragment
            else:
                yield from _orders(document, start, i, names)
                yield from _placings(document, start, i)
            start = i + 1
    yield from _orders(document, start, len(tokens), names)
    yield from _placings(document, start, len(tokens))


def _fragment(document: Document, start: int, stop: int) -> Fragment | None:
    """The fragment between two marks."""
    tokens = document.tokens
    first = start
    while first < stop and tokens[first].lower in _FILLERS:
        first += 1
    if first < stop and tokens[first].lower in _PERCEIVING:
        return _glimpse(document, range(start, stop), first)
    is_denied = first < stop and tokens[first].lower == "not"
    first += is_denied
    if (threshold := _threshold(document, range(start, stop), first)) is not None:
        return threshold
    if (of_several := _state_asked(document, range(start, stop), first)) is not None:
        return of_several
    if first >= stop or any(token.pos in ("AUX", "VERB") for token in tokens[first:stop]):
        return None
    carrier = next((j for j in range(first + 1, stop) if tokens[j].lower in _WHERE), stop)
    if tokens[first].lower not in _SOME | _NONE and not _is_telegram(document, range(first, carrier), stop):
        return None
    last = stop
    while last > carrier and tokens[last - 1].lower in _BEHIND:
        last -= 1
    is_named = tokens[first].lower in _ALONE or tokens[carrier - 1].pos in ("NOUN", "PROPN")
    is_pointed_at = carrier + 1 < stop and tokens[carrier + 1].lower in ("there", "here")  # "somebody in there?"
    last = carrier + 2 if is_pointed_at else last
    is_place = is_pointed_at or (last - carrier > 1 and tokens[last - 1].pos in ("NOUN", "PROPN", "PRON"))
    asked = {token.lemma for token in tokens[first:carrier]}
    if not is_named or not is_place or not _IDLE.isdisjoint(asked if "of" in asked else asked - _SIGNS):
        return None
    begin = first + (tokens[first].lower in _NONE)
    return Fragment(range(start, stop), carrier, range(begin, carrier), range(carrier + 1, last))


def _threshold(document: Document, words: range, first: int) -> Fragment | None:
    """The question whether what was looked at is above or below so much: "*below four degrees*?"."""
    tokens = document.tokens
    amount = first + 1 + (first + 1 < words.stop and tokens[first + 1].lower == "than")
    is_compared = tokens[first].lower in LEVELS if amount == first + 1 else tokens[first].lower in _DEGREES
    is_amount = amount < words.stop <= amount + _LONGEST_AMOUNT and tokens[amount].pos == "NUM"
    if first >= words.stop or not (is_compared and is_amount) or words.stop + 1 >= len(document):
        return None
    return Fragment(words, first, range(0), range(0), state=range(amount, words.stop))


def _state_asked(document: Document, words: range, first: int) -> Fragment | None:
    """The question whether several things, or all of a kind, are so: "all doors and windows *closed*?"."""
    tokens = document.tokens
    carrier = words.stop - 1
    while carrier > first and tokens[carrier].lower in _BEHIND - {"please", "robot", ",", "not"}:
        carrier -= 1
    named = tokens[first:carrier]
    is_state = carrier > first and (tokens[carrier].lower in OPPOSITES or tokens[carrier].tag in ("VBN", "VBD"))
    if not is_state or named[-1].pos not in ("NOUN", "PROPN"):
        return None
    if not all(t.pos in _NAMING or t.tag == "PRP$" or t.lower in ("and", "of") for t in named):
        return None
    is_of_several = named[0].lower in _ALL or any(token.lower == "and" for token in named[1:])
    return Fragment(words, carrier, range(first, carrier), range(0)) if is_of_several else None


def _glimpse(document: Document, words: range, verb: int) -> Fragment | None:
    """The question for something that may be there, behind which it is told what to do then: "*see* a coin on the mat?
    Keep it"; "see the coin on the mat?" only points at it."""
    tokens = document.tokens
    behind = tokens[verb + 1 : words.stop]
    if len(behind) < _SHORTEST or words.stop + 1 >= len(document) or behind[0].lower not in _SOME | {"a", "an"}:
        return None
    where = next((token.i for token in behind if token.lower in _WHERE), words.stop)
    is_named = tokens[where - 1].pos in ("NOUN", "PROPN")
    is_place = where == words.stop or tokens[words.stop - 1].pos in ("NOUN", "PROPN")
    if not (is_named and is_place) or any(token.pos in ("AUX", "VERB", "PRON") for token in behind):
        return None
    return Fragment(words, verb, range(verb + 1, where), range(where, words.stop), "searching")


def _is_telegram(document: Document, named: range, stop: int) -> bool:
    """Whether a thing without an article is asked of, and what follows says what to do about it: "*letter* on mat?
    Bring it up"; "breakfast in the garden?" at the end proposes it."""
    words = document.tokens[named.start : named.stop]
    return stop + 1 < len(document) and all(word.pos in ("ADJ", "NOUN", "PROPN") for word in words)


def _orders(document: Document, start: int, stop: int, names: Collection[str]) -> Iterator[Fragment]:
    """The orders of states among the clauses from `start` to `stop`, from the first one on or behind a condition. What
    an "and" joins to a verb has that verb ("turn the tv on and the radio off")."""
    tokens = document.tokens
    if not any(_is_state(document, i) for i in range(start + 1, stop)):
        return
    is_open = True
    for first in range(start, stop):
        before = tokens[first - 1].lower if first > start else ","
        if before not in (",", "and", "then", ":"):
            continue
        end = next((j for j in range(first, stop) if tokens[j].lower in (",", "and", "then", ":")), stop)
        order = _order(document, first, end, names) if is_open else None
        if order is not None:
            yield order
        is_condition = end < stop and tokens[end].text == "," and tokens[first].lower in _OPENING
        is_idle = all(token.lower in _LEADING for token in tokens[first:end])
        is_open = order is not None or is_condition or (is_open and is_idle)


def _order(document: Document, start: int, stop: int, names: Collection[str]) -> Fragment | None:
    """The clause as an order of a state."""
    tokens = document.tokens
    first = start
    while first < stop and tokens[first].lower in _LEADING:
        first += 1
    carrier = next((j for j in range(first + 1, stop) if _is_state(document, j)), stop)
    named = tokens[first:carrier]
    if carrier == stop or not all(token.pos in _NAMING or token.tag == "PRP$" for token in named[:-1]):
        return None
    is_led = [token.pos == "DET" or token.tag == "PRP$" for token in named]
    if sorted(is_led, reverse=True) != is_led:
        return None  # "dude turn that fan off"
    thing = named[-1]
    if not _is_thing(thing, names) or thing.lemma in NO_THINGS or named[0].lower in _SOME | _NONE:
        return None
    behind = [token for token in tokens[carrier + 1 : stop] if token.lower not in _TRAILING]
    is_place = len(behind) > 1 and behind[0].lower in ("in", "at") and behind[-1].pos in ("NOUN", "PROPN")
    is_floor = len(behind) == 1 and behind[0].lower in _FLOORS
    if behind and not is_floor and not (is_place and all(t.pos in _NAMING or t.tag == "PRP$" for t in behind[1:])):
        return None
    location = range(behind[0].i, behind[-1].i + 1) if behind else range(0)
    is_taken = thing.lemma in _REFUSE and tokens[carrier].lower == "out"
    kind = "taking" if is_taken else "change_state"
    return Fragment(range(start, stop), carrier, range(first, carrier), location, kind)


def _is_thing(word: Token, names: Collection[str]) -> bool:
    """Whether a word names a thing, be it tagged as a verb: "*blinds* down", "*oven* off"."""
    is_known = word.lower in names or word.lower.removesuffix("s") in names
    return word.pos in ("NOUN", "PROPN") or word.lemma in _THINGS or is_known


def _is_state(document: Document, i: int) -> bool:
    """Whether a word behind a noun is a state that may be ordered of it."""
    word, thing = document.tokens[i].lower, document.tokens[i - 1]
    return word in STATES or thing.lemma in _STATES_OF.get(word, ())


def _placings(document: Document, start: int, stop: int) -> Iterator[Fragment]:
    """A list of what goes where, be it a sentence by itself or behind a colon and an order to sort things."""
    tokens = document.tokens
    if not (start == 0 or tokens[start - 1].text in ".!" or _is_sorted(document, start)):
        return
    bounds = [start - 1, *(i for i in range(start, stop) if tokens[i].lower in (",", "and")), stop]
    items: list[Fragment] = []
    first = start
    for end in bounds[1:]:
        if item := _placing(document, range(first, end)):
            items.append(item)
        if item or all(token.lower in _LEADING for token in tokens[first:end]):
            first = end + 1
    if first >= stop and len(items) > 1:
        yield from items


def _is_sorted(document: Document, start: int) -> bool:
    """Whether what stands ahead of a colon is an order to sort things, or says that they are here."""
    tokens = document.tokens
    if tokens[start - 1].text != ":":
        return False
    begin = next((i + 1 for i in range(start - 2, -1, -1) if tokens[i].text in STOPS), 0)
    verbs = {token.lemma for token in tokens[begin : start - 1] if token.pos in ("VERB", "AUX") or token.i == begin}
    return not verbs.isdisjoint(_SORTING)


def _placing(document: Document, words: range) -> Fragment | None:
    """What goes where: "any toys in the box"."""
    said = [token for token in document.tokens[words.start : words.stop] if token.lower not in _LEADING]
    carrier = next((token.i for token in reversed(said[1:]) if token.lower in _PUT), None)
    is_told = any(t.pos == "AUX" or (t.pos in ("VERB", "PRON") and t.tag not in _NOUNS) for t in said)
    if carrier is None or is_told:
        return None
    thing, place = (range(said[0].i, carrier), range(carrier + 1, said[-1].i + 1))
    are_named = all(phrase and document.tokens[phrase[-1]].tag.startswith(_NOUNS) for phrase in (thing, place))
    is_known = document.tokens[said[0].i].lower in _SOME - {"any", "some"} | _NONE | _ALONE
    return Fragment(words, carrier, thing, place, "placing") if are_named and not is_known else None
