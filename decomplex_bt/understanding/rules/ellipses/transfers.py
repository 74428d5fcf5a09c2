"""Transfers: orders without a verb that say what goes where or to whom ("both pens to Anna, please", "two plates on the
table, please"), or what somebody is to have ("coffee, please, and make it hot", "a biscuit for Ida if she's up")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.ellipses.fragments import STOPS, Fragment
from decomplex_bt.understanding.rules.orders.wants import NOT_BROUGHT
from decomplex_bt.understanding.rules.speech.edits import is_order_at
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_SEQUENCE = frozenset("first then next finally lastly last".split())
_LEADING = _SEQUENCE | frozenset("and please so ok okay right also now robot ,".split())
_TO_WHOM = frozenset(("to", "for"))
_INTO = frozenset(("into", "onto"))
_AT = frozenset("on in under behind by beside".split())
_CARRYING = _TO_WHOM | _INTO | _AT
_NAMING = frozenset(("NOUN", "PROPN"))
_PHRASE = _NAMING | {"DET", "ADJ", "NUM"}
_GIVEN_TO = frozenset("me us him her them".split())
_INDEFINITE = frozenset("a an some another more".split())
_WITHIN = frozenset(("of", "and", "'s", "some"))
_JOINING = frozenset(("and", "but"))
_CASES = frozenset(("if", "unless"))
_HAVING = frozenset("there we you it i".split())
"""First words of a case of what there is, or can be had: "coffee if *there's* any"."""
_ALL = frozenset(("all", "both"))
_CLOSING = frozenset(("please", ",", "now", "thanks", "robot"))
_DIRECTIONS = frozenset("left right front back side top bottom start end".split())
_LEADING_THERE = frozenset(
    "way route road path door gate stair step direction key visit trip walk guide access entrance".split()
)
"""What there is to a place, as the key to a car."""
_SAID_TO = frozenset("answer thank message reply toast cheer introduction".split())
_SAID_AHEAD = frozenset("thing question point word note reminder request".split())
"""What only opens what is said: "one *thing*, if it's on, ..."."""
_BODY = frozenset("hand eye finger foot ear head arm leg knee paw back".split())


def transfers(observed: Observed) -> Iterator[Fragment]:
    """The verbless orders of a document, in text order."""
    document = observed.document
    tokens, start, is_listed = document.tokens, 0, False
    for i in range(len(tokens) + 1):
        if i < len(tokens) and tokens[i].text not in STOPS:
            continue
        mark = tokens[i].text if i < len(tokens) else "."
        is_first = start == 0 or tokens[start - 1].text in ".!" or (tokens[start - 1].text == ";" and is_listed)
        found = [] if mark in ("?", ":") or not is_first else list(_ordered(observed, range(start, i), mark))
        yield from found
        start, is_listed = i + 1, bool(found)


def _ordered(observed: Observed, words: range, mark: str) -> Iterator[Fragment]:
    """The orders that a stretch between two marks is made of."""
    tokens = observed.document.tokens
    said = [tokens[i].lower for i in words]
    if (served := _asked_in_case(observed, words)) is not None:
        yield served
        return
    if "please" in said:
        at = said.index("please")
        behind = said[at + 1 : at + 3]
        is_next = not _JOINING.isdisjoint(behind[:1]) or (behind[:1] == [","] and not _JOINING.isdisjoint(behind[1:]))
        if not (is_next or all(word in _CLOSING for word in said[at:])):
            return  # "the cup, please bring it here"
        words, said = range(words.start, words.start + at + 1), said[: at + 1]
        if (served := _served(observed, words)) is not None:
            yield served
            return
    bounds = [*(i for i in words if tokens[i].lower in (",", "and")), words.stop]
    found: list[Fragment] = []
    first = words.start
    for end in bounds:
        if (one := _transfer(observed, range(first, end))) is not None:
            found.append(one)
        if one is not None or all(tokens[i].lower in _LEADING | _CLOSING for i in range(first, end)):
            first = end + 1
    is_asked = "please" in said or len(found) > 1 or not _SEQUENCE.isdisjoint(said[:3])
    if found and len(said) > 1 and first < words.stop and _is_joined_order(observed, found[-1], first):
        yield from found
        return
    is_called = all(tokens[one.carrier].lower in _INTO or _is_thing(observed, one.object) for one in found)
    is_asked = is_asked or (mark == "!" and is_called)
    is_carried = any(tokens[one.carrier].lower in _TO_WHOM | _INTO for one in found)
    if first >= words.stop and found and is_asked and (is_carried or len(found) == 1):
        yield from found


def _asked_in_case(observed: Observed, words: range) -> Fragment | None:
    """What somebody is to have in a case, which begins a text: "*a biscuit for Ida* if she's up", "*more tea* if there
    is any"."""
    tokens = observed.document.tokens
    case = next((i for i in words if tokens[i].lower in _CASES), None)
    if words.start or case is None or any(_goes_on(observed, i) for i in range(case, words.stop)):
        return None
    asked = range(words.start, case - (tokens[case - 1].text == ","))
    one = _transfer(observed, asked) or _served(observed, asked)
    last = tokens[asked.stop - 1]
    is_idle = last.lemma in _SAID_AHEAD or last.lower in observed.gazetteer.states  # "a window open if it's hot"
    is_given = one is not None and not is_idle and (one.recipient or tokens[one.carrier].lower not in _CARRYING)
    is_bare = one is not None and is_given and not one.recipient and tokens[asked.start].pos in _NAMING
    if is_bare and tokens[case + 1].lower not in _HAVING:
        return None  # "control if the tap is off", as some say for "check"
    return one if is_given and _is_wanted(observed, asked.start) else None


def _is_joined_order(observed: Observed, one: Fragment, at: int) -> bool:
    """Whether an order is joined to what goes somewhere: "a coffee to the garden, *and take* the tray away"."""
    tokens = observed.document.tokens
    is_joined = tokens[at - 1].lower in ("and", "then") and is_order_at(observed.document, at)
    is_led = tokens[one.carrier].lower in _TO_WHOM | _INTO
    return is_joined and is_led and _is_wanted(observed, one.object.start)


def _goes_on(observed: Observed, i: int) -> bool:
    """Whether a sentence goes on at a token behind a case put into it: "a lamp, if there is one, *would* do"."""
    tokens = observed.document.tokens
    return tokens[i].tag in ("MD", "VBZ") and tokens[i - 1].text == ","


def _is_wanted(observed: Observed, first: int) -> bool:
    """Whether words begin as what somebody wants does: with "some" or the like, a number, or a noun for a thing that is
    no verb of going ("*water* to the cat", not "*roll* to the door")."""
    tokens = observed.document.tokens
    is_thing = _is_thing(observed, range(first, first + 1)) and "motion" not in observed.senses[first]
    is_bare = tokens[first].pos in _NAMING and is_thing
    return tokens[first].lower in _INDEFINITE or tokens[first].pos == "NUM" or is_bare


def _transfer(observed: Observed, words: range) -> Fragment | None:
    """What goes where, or to whom: "First *the tea, to Tom*"."""
    document, tokens = observed.document, observed.document.tokens
    start, stop = _without_ends(document, words)
    carrier = next((i for i in range(stop - 1, start, -1) if tokens[i].lower in _CARRYING), None)
    if carrier is None:
        return None
    is_parted = tokens[carrier - 1].text == ","
    thing, place = range(start, carrier - is_parted), range(carrier + 1, stop)
    if not _is_named(observed, thing, is_parted=is_parted) or not place:
        return None
    to, first, last = tokens[carrier].lower, tokens[thing.start].lower, tokens[place.stop - 1]
    is_person = last.lemma in PERSON_NOUNS or last.text[:1].isupper() or last.lower in _GIVEN_TO
    is_indefinite = first in _INDEFINITE or tokens[thing.start].pos in _NAMING | {"NUM"}
    if not (is_person and to in _TO_WHOM):
        is_place = last.pos in _NAMING and last.lower not in _DIRECTIONS and not is_person
        is_place = is_place and tokens[thing.stop - 1].lemma not in _LEADING_THERE
        if not is_place or to == "for" or not _is_phrase(document, place):
            return None
        if to in _AT and not (is_indefinite and _is_thing(observed, thing)):
            return None  # "the mug on the table, please" tells which one
        kind = "bringing" if to == "to" else "placing"
        return Fragment(words, carrier, thing, place, kind)
    return Fragment(words, carrier, thing, range(0), "bringing", recipient=place)


def _without_ends(document: Document, words: range) -> tuple[int, int]:
    """Where words begin and end without what only leads on ("and then") or closes ("please")."""
    start, stop = words.start, words.stop
    while start < stop and document.tokens[start].lower in _LEADING:
        start += 1
    while stop > start and document.tokens[stop - 1].lower in _CLOSING:
        stop -= 1
    return start, stop


def _is_named(observed: Observed, thing: range, *, is_parted: bool) -> bool:
    """Whether words name what can go somewhere: not a robot that is called ("Robot, to the kitchen")."""
    document = observed.document
    if not thing or not _is_phrase(document, thing):
        return False
    first, last = document.tokens[thing.start], document.tokens[thing.stop - 1]
    is_led = first.pos in ("DET", "NUM") or first.tag == "PRP$" or first.lower in _ALL | _INDEFINITE
    is_common = first.tag in ("NNS", "NN", "JJ") or _is_thing(observed, thing)  # "Juice" is a name to the tagger
    is_bare = is_common and not is_parted
    heads = {document.tokens[i].lemma for i in thing if document.tokens[i].pos in _NAMING}
    is_idle = not heads.isdisjoint(_SAID_TO | NOT_BROUGHT | _BODY) or last.lemma in PERSON_NOUNS
    return (is_led or is_bare) and last.pos in _NAMING and not is_idle


def _is_phrase(document: Document, words: range) -> bool:
    tokens = [document.tokens[i] for i in words]
    return all(t.pos in _PHRASE or t.tag == "PRP$" or t.lower in _WITHIN for t in tokens)


def _is_thing(observed: Observed, words: range) -> bool:
    """Whether the last noun is known to be carried about."""
    return observed.gazetteer.category(observed.document.tokens[words.stop - 1].lemma) == "thing"


def _served(observed: Observed, words: range) -> Fragment | None:
    """What is asked for by no more than its name and a "please", carried by its noun: "*Coffee*, please"."""
    tokens = observed.document.tokens
    start, stop = _without_ends(observed.document, words)
    thing = range(start, stop)
    if not thing or not _is_named(observed, thing, is_parted=False):
        return None
    is_known = bool(observed.gazetteer.category(tokens[stop - 1].lemma))
    is_indefinite = tokens[start].lower in _INDEFINITE or tokens[start].pos == "NUM"
    if not _is_thing(observed, thing) and (is_known or not is_indefinite):
        return None
    return Fragment(words, stop - 1, thing, range(0), "bringing")
