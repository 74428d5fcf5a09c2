"""Phrases: what an argument names in the house, coordination, choices and a place inside included."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.nouns import singulars
from decomplex_bt.errors import ImpossibleGoalError, InputError
from decomplex_bt.hesitation import without_hesitation
from decomplex_bt.instruction import Argument
from decomplex_bt.planning.modifiers import (
    PICKS,
    has_colour,
    is_bare_other,
    modified,
    of_kind,
    one_more,
    read_number,
    says_other,
)
from decomplex_bt.planning.noun_phrase import NounPhrase
from decomplex_bt.planning.prepositions import leading_preposition, normal_words, split_preposition
from decomplex_bt.planning.state_words import read_state
from decomplex_bt.planning.suggestions import unknown

_CLAUSE = re.compile(r"\s(?:that|which|who|whose|where|so that|because|if)(?:'s|'re)?(?=\s)")
_BEFORE_POINTING = re.compile(
    r"(?:,|\b(?:and|or|nor|plus|but|as well as|with|of|on|in|at|to|from|into|onto|off|under|behind|beside|by|for))$"
)
"""What stands ahead of a "that" which points at something and opens no clause ("the cup and *that* plate")."""
_OF_CLAUSE = frozenset("is are was were has i you we he she it they".split())
_STILL = r"(?:\s+(?:still|already|currently))?"
_BEING = re.compile(rf"\s(?:that|which)(?:'s|'re|\s+is|\s+are){_STILL}\s+((?:switched |turned |plugged )?\w+)$")
_WHICHEVER = re.compile(rf"^(?:whichever|whatever)\s+(.+?)(?:'s|'re|\s+is|\s+are){_STILL}\s+((?:\w+ )?\w+)$")
_USE = re.compile(r"(?<!\bsomething)(?<!\banything)\s+to\s+\w+\s.*?\b(?:with|from|into|onto|in|on|under|over)$")
"""What a thing is for ("a cloth *to wipe the table with*"); what "something" is for tells which it is."""
_JOINT = re.compile(r"\s*(?:,\s*(?:and|or|plus)?|\b(?:and|plus|as well as|(?:along|together) with|&)\b)\s+")
_CHOICE = re.compile(r"^n?either\s+(?=.*\sn?or\s)|\s+n?or\s+")
_ONE = re.compile(r"^((?:the|an?|that|this|those|these)\s+(?:[\w-]+\s+){0,2})(ones?)\b(?!\s+of\b)")
"""A phrase whose noun stood before ("the white plate and the blue one")."""
_DESCRIBING = frozenset(("with", "for"))
"""Prepositions that tell one from another by what it has or is for, and not by where it is."""
_POSSESSIVE = re.compile(r"\w+(?:'s|s')$")
_AT_LEAST = re.compile(r"\b(?:at least|no fewer than|no less than)\s+")
_MORE_THAN = re.compile(r"\bmore than (\w+)\b")
_OF_THEM = re.compile(r"\s+of (?:them|these|those)$")
_EACH_OF_THEM = frozenset(("them", "both", "all", "each", "them both", "them all"))


def read_phrases(text: str, domain: Domain) -> tuple[NounPhrase, ...]:
    """The noun phrases of an argument: one for each part of a coordination.

    Raises `UnknownWordError`, naming the part and the nearest known words, and `ImpossibleGoalError` for what is fixed
    and is not at the place inside its phrase ("the window in the study").
    """
    return _read_phrases(normal_words(text), domain, text)


def named_by(words: str, domain: Domain) -> tuple[str, ...]:
    """What words name; nothing where they are not understood."""
    try:
        phrases = read_phrases(words, domain)
    except InputError:
        return ()
    return tuple(name for phrase in phrases for name in (phrase.entities or phrase.plurals))


def read_argument(argument: Argument, text: str, domain: Domain) -> tuple[NounPhrase, ...]:
    """The noun phrases of an argument in a text; a pronoun has its own preposition ("under it") and may pick some of
    what it stands for ("both mugs ... one").

    Raises what `read_phrases` does.
    """
    phrases = read_phrases(argument.value, domain)
    words = without_hesitation(argument.span.of(text)) if argument.span is not None else ""
    preposition, said = split_preposition(words, domain)
    if said == split_preposition(argument.value, domain)[1]:
        return phrases
    if len(phrases) == 1 and _OF_THEM.sub("", said) in _EACH_OF_THEM:
        phrases = phrases[0].choices or phrases  # "if the tv or the radio is on, turn both off"
    picked = picked_words(argument, text, domain)
    is_other = says_other(said.split(), domain)
    phrases = tuple(
        replace(
            p,
            preposition=p.preposition or preposition,
            is_pronoun=not is_other,
            is_picked=bool(picked) or said.startswith(("a ", "an ")),
            is_other=p.is_other or is_other,
            wanted=() if is_bare_other(said, domain) else p.wanted,
        )
        for p in phrases
    )
    if not picked:
        return phrases
    number = read_number(picked, domain)
    if len(phrases) == 1 and (not phrases[0].is_of_several or phrases[0].count == number):
        return phrases
    words = f"{' '.join(picked)} of {argument.value}"
    choices = phrases if len(phrases) > 1 else ()
    return (replace(phrases[0], text=words, is_all=False, is_definite=False, count=number or 1, choices=choices),)


def picked_words(argument: Argument, text: str, domain: Domain) -> list[str]:
    """The words by which a pronoun of a text picks some of what it stands for ("one", "any of them"); else none."""
    said = split_preposition(argument.span.of(text) if argument.span is not None else "", domain)[1]
    words = _OF_THEM.sub("", said).split()
    return words if read_number(words, domain) is not None or PICKS.issuperset(words) else []


def rooms_of(name: str, domain: Domain) -> tuple[str, ...]:
    """The rooms of something fixed (a door has two); empty for what can be anywhere."""
    doorway = domain.house.doorways.get(name)
    if doorway is not None:
        return doorway.rooms
    room = domain.room_of(name)
    return () if room is None else (room,)


def nothing_there(words: str, names: Iterable[str], rooms: Iterable[str], domain: Domain) -> ImpossibleGoalError:
    """The error for something fixed that is not where it is said to be."""
    said, known = (
        " or ".join(sorted(f"the {room.replace('_', ' ')}" for room in group))
        for group in (rooms, {room for name in names for room in rooms_of(name, domain)})
    )
    return ImpossibleGoalError(f"{words!r} names nothing in {said}, only in {known}")


def _read_phrases(words: str, domain: Domain, text: str) -> tuple[NounPhrase, ...]:
    words = _MORE_THAN.sub(lambda match: one_more(match[1], domain), _AT_LEAST.sub("", words))
    preposition, rest = split_preposition(words, domain)
    rest = _WHICHEVER.sub(r"any \1 that is \2", rest)
    rest, clause = _without_clause(_USE.sub("", rest)), _BEING.search(rest)
    parts = [part.strip() for part in _JOINT.split(_spelt_out(rest, domain)) if part and part.strip()]
    phrases: list[NounPhrase] = []
    later: NounPhrase | None = None
    for part in reversed(parts or [""]):
        read = _read_choice(part, preposition, domain, later, text)
        later = (later and _of_room(read, part, later, domain)) or read
        phrases.append(later)
    if clause is not None:
        phrases = [_described(phrase, clause[1], domain) for phrase in phrases]
    return tuple(reversed(phrases))


def _without_clause(words: str) -> str:
    """The words without a clause about the thing ("the cup *that I bought*"), which a "that" behind an "and" or a
    preposition does not open ("the cup and *that plate*", "the cup next to *that plate*")."""
    for found in _CLAUSE.finditer(words):
        before, behind = words[: found.start()], words[found.end() :].split()
        is_pointing = found[0].strip() == "that" and _BEFORE_POINTING.search(before) and behind[0] not in _OF_CLAUSE
        if not is_pointing:
            return before
    return words


def _of_room(phrase: NounPhrase, words: str, later: NounPhrase, domain: Domain) -> NounPhrase | None:
    """What is named by its room alone ("*the kitchen* and the bedroom light"), where the next phrase has the noun
    behind the name of another; else None."""
    rooms = set(domain.house.rooms)
    before, _, noun = later.noun.rpartition(" ")
    other = _read_part(before, "", domain, None) if before else None
    if other is None or not all(named.entities and rooms.issuperset(named.entities) for named in (phrase, other)):
        return None
    return _read_part(f"{words} {noun}", phrase.preposition, domain, None)


def _spelt_out(words: str, domain: Domain) -> str:
    """The words with the noun in place of each "one" for which it stands: that of the part before it."""
    noun, spelt = "", []
    for part in re.split(r"(\s*,\s*|\s+(?:and|or|nor|plus)\s+)", words):
        one = _ONE.search(part) if noun else None
        said = part if one is None else f"{one[1]}{_numbered(noun, one[2], domain)}{part[one.end() :]}"
        named = _read_part(said, "", domain, None) if said.strip(" ,") else None
        noun = named.noun or noun if named is not None else noun
        spelt.append(said)
    return "".join(spelt)


def _numbered(noun: str, one: str, domain: Domain) -> str:
    """A noun for "one" or "ones": in the singular for the first, where it is a plural."""
    if one == "ones" or domain.nouns.entities.get(noun):
        return noun
    return next((stem for stem in singulars(noun) if domain.nouns.entities.get(stem)), noun)


def _described(phrase: NounPhrase, words: str, domain: Domain) -> NounPhrase:
    """The phrase with the colour or the state that a clause gives ("that is red"); what else it says tells nothing."""
    state = read_state(words, domain.kinds.state_pairs, domain)
    colours = {words} & set(domain.lexicon.colours)
    return replace(
        phrase,
        entities=tuple(name for name in phrase.entities if has_colour(name, colours, domain)),
        plurals=tuple(name for name in phrase.plurals if has_colour(name, colours, domain)),
        wanted=tuple(dict.fromkeys((*phrase.wanted, *((state,) if state is not None else ())))),
    )


def _read_choice(part: str, preposition: str, domain: Domain, later: NounPhrase | None, text: str) -> NounPhrase:
    """One part of a coordination; with "or" whatever any of its alternatives names."""
    said = [choice for choice in _CHOICE.split(part) if choice]
    choices = tuple(_read_part(choice, preposition, domain, later) for choice in said or [""])
    found = tuple(choice for choice in choices if choice is not None)
    if len(found) < len(choices):
        raise unknown(part or text, domain)
    return found[0] if len(found) == 1 else replace(found[0], text=part, is_all=False, is_definite=False, choices=found)


def _read_part(words: str, preposition: str, domain: Domain, later: NounPhrase | None) -> NounPhrase | None:
    """A noun phrase without coordination, with a place inside it; None if it names nothing."""
    inner, words = split_preposition(words, domain)
    preposition = inner or preposition
    whole = _read_simple(words, preposition, domain, later)
    if whole is not None:
        return whole
    tokens = words.split()
    for i in range(1, len(tokens)):
        rest = " ".join(tokens[i:])
        if tokens[i] == "of":
            found = _read_of(tokens[:i], " ".join(tokens[i + 1 :]), preposition, domain)
            if found is not None:
                return found
        elif leading_preposition(rest, domain):
            head = _read_simple(" ".join(tokens[:i]), preposition, domain, later)
            place = _read_part(rest, "", domain, None) if rest != leading_preposition(rest, domain) else head
            if head is not None and place is not None:
                return head if place is head else replace(_inside(head, place, domain), text=words)
    return None


def _read_of(head: list[str], rest: str, preposition: str, domain: Domain) -> NounPhrase | None:
    """ "X of Y": a measure of Y, a part of Y, or the X that belongs to the place Y."""
    whole = _read_part(rest, preposition, domain, None)
    noun = head[-1]
    measures = {**dict.fromkeys(("both", *PICKS, *domain.lexicon.all_words), 1), **domain.lexicon.measures}
    measure = noun if noun in measures else next((word for word in (noun[:-1], noun[:-2]) if word in measures), None)
    is_part = noun in domain.lexicon.parts and whole is not None and _opens(whole, domain)
    if whole is not None and (measure is not None or is_part):
        number = read_number(head, domain)
        count = number or (measures[measure] if measure else 1)
        is_all = any(word in domain.lexicon.all_words or word == "both" for word in head)
        is_one = noun == "piece" or not PICKS.isdisjoint(head)
        is_definite = whole.is_definite and number is None and not is_one
        text = " ".join([*head, "of", rest])
        return of_kind(replace(whole, text=text, count=count, is_all=is_all, is_definite=is_definite), domain)
    own = _read_simple(" ".join(head), preposition, domain, None)
    return _inside(own, whole, domain) if own is not None and whole is not None else own


def _read_simple(words: str, preposition: str, domain: Domain, later: NounPhrase | None) -> NounPhrase | None:
    """A noun with what stands before it; None if the noun, or a word before it, is not known."""
    words = _strip_end(words, domain)
    special = _special(words, preposition, domain)
    if special is not None:
        return special
    tokens = words.split()
    last_owner = max((i for i, token in enumerate(tokens[:-1]) if _POSSESSIVE.match(token)), default=-1)
    tokens = ["the", *tokens[last_owner + 1 :]] if last_owner >= 0 else tokens
    for i in range(len(tokens)):
        entities, plurals = domain.nouns.lookup(" ".join(tokens[i:]))
        if entities or plurals:
            plurals = tuple(name for name in plurals if name not in entities)
            phrase = NounPhrase(words, preposition, entities, plurals, noun=" ".join(tokens[i:]))
            found = modified(phrase, tokens[:i], domain)
            if found is not None:
                return found
    if len(tokens) > 1 and tokens[-1] in domain.lexicon.parts:
        whole = _read_simple(" ".join(tokens[:-1]), preposition, domain, later)
        return whole if whole is not None and _opens(whole, domain) else None
    if tokens and later is not None and later.noun and tokens[-1] not in later.noun.split():
        # "the red and the blue mug": the noun stands only once
        return _read_simple(f"{words} {later.noun}", preposition, domain, None)
    return None


def _special(words: str, preposition: str, domain: Domain) -> NounPhrase | None:
    """Phrases of words that are no nouns: me, here, everything, somebody."""
    lexicon, house = domain.lexicon, domain.house
    others = tuple(name for name in house.people if name != house.user)
    if words in lexicon.user_words or words in lexicon.here_words:
        return NounPhrase(words, preposition, (house.user,))
    if words in lexicon.all_words:
        return NounPhrase(words, preposition, (), tuple(house.things), is_all=True)
    if anything := next((said for said in lexicon.anything_words if f"{words} ".startswith(f"{said} ")), None):
        phrase = NounPhrase(words, preposition, tuple(house.things), noun=anything)
        before = words.removeprefix(anything).split()
        is_told = all(read_state(word, domain.kinds.state_pairs, domain) for word in before)
        return modified(phrase, ["any", *before], domain) if is_told else None
    people = _people(words, domain)
    is_other = words == f"{people} else"
    if people in lexicon.anybody_words:
        return NounPhrase(words, preposition, others, is_other=is_other)
    if people in lexicon.everybody_words:
        return NounPhrase(words, preposition, (), others, is_all=True, is_other=is_other)
    return None


def _people(words: str, domain: Domain) -> str:
    """Words for somebody or everybody without what is said of them: "else", or the house that they are in."""
    lexicon = domain.lexicon
    for people in (*lexicon.anybody_words, *lexicon.everybody_words):
        said = words.removeprefix(f"{people} ")
        if said == words:
            continue
        preposition, place = split_preposition(said, domain)
        is_house = said in lexicon.presence_words and bool(preposition) and place not in ("", "there")
        if said == "else" or is_house:
            return people
    return words


def _strip_end(words: str, domain: Domain) -> str:
    """The words without trailing ones that name nothing ("the cup again", "the light here")."""
    tokens = words.split()
    while len(tokens) > 1 and tokens[-1] in domain.lexicon.determiners and not any(domain.nouns.lookup(tokens[-1])):
        tokens.pop()
    return " ".join(tokens)


def _opens(phrase: NounPhrase, domain: Domain) -> bool:
    """Whether what a phrase names has a door of its own."""
    return any(name not in domain.house.rooms and domain.kind(name).has_door for name in phrase.entities)


def _inside(head: NounPhrase, place: NounPhrase, domain: Domain) -> NounPhrase:
    """A noun phrase at a place: what is fixed must be there, what can be carried is looked for there."""
    named = frozenset((*place.entities, *place.plurals))
    if (
        head.entities
        and all(name in domain.house.rooms for name in head.entities)
        and not named <= set(domain.house.rooms)
    ):
        # "in the bathroom on the shelf": the place says more than the room
        return _inside(place, head, domain)
    rooms = {room for name in named if (room := domain.room_of(name)) is not None}
    names = (*head.entities, *head.plurals)
    there = frozenset(
        name for name in names if _part_of(name, domain) in named or name in {_part_of(n, domain) for n in named}
    )
    if not there:
        there = frozenset(n for n in names if not rooms or not rooms_of(n, domain) or rooms & {*rooms_of(n, domain)})
    is_next_door = place.preposition in domain.lexicon.beside and named <= set(domain.house.rooms)
    if not there and (is_next_door or place.preposition in _DESCRIBING):
        return head  # "the room next to the kitchen", "the cupboard with the glass door"
    if not there:
        raise nothing_there(head.text, names, rooms, domain)
    return replace(
        head,
        entities=tuple(name for name in head.entities if name in there),
        plurals=tuple(name for name in head.plurals if name in there),
        place=place,
    )


def _part_of(name: str, domain: Domain) -> str | None:
    piece = domain.house.furniture.get(name)
    return piece.part_of if piece is not None else None
