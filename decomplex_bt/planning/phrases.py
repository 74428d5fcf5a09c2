"""Noun phrases: what an argument's words may name in the house, by noun, adjectives, number and a place inside."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.nouns import singulars
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Argument
from decomplex_bt.planning.abilities import states_of

_CLAUSE = re.compile(r"\s(?:that|which|who|whose|where|so that|because|if)(?:'s|'re)?\s.*$")
_STILL = r"(?:\s+(?:still|already|currently))?"
_BEING = re.compile(rf"\s(?:that|which)(?:'s|'re|\s+is|\s+are){_STILL}\s+((?:switched |turned |plugged )?\w+)$")
_WHICHEVER = re.compile(rf"^(?:whichever|whatever)\s+(.+?)(?:'s|'re|\s+is|\s+are){_STILL}\s+((?:\w+ )?\w+)$")
_JOINT = re.compile(r"\s*(?:,\s*(?:and|or|plus)?|\b(?:and|plus|as well as|(?:along|together) with|&)\b)\s+")
_CHOICE = re.compile(r"^n?either\s+(?=.*\sn?or\s)|\s+n?or\s+")
_ONE = re.compile(r"^((?:the|an?|that|this|those|these)\s+(?:[\w-]+\s+){0,2})(ones?)\b(?!\s+of\b)")
"""A phrase whose noun stood before ("the white plate and the blue one")."""
_DESCRIBING = frozenset(("with", "for"))
"""Prepositions that tell one from another by what it has or is for, and not by where it is."""
DEFINITE = frozenset("the my our your his her its their these those".split())
"""First words of a phrase that speaks of a certain one."""
_POSSESSIVE = re.compile(r"\w+(?:'s|s')$")
_AT_LEAST = re.compile(r"\b(?:at least|no fewer than|no less than)\s+")
_MORE_THAN = re.compile(r"\bmore than (\w+)\b")
_PICKS = frozenset("some any no none one either neither another".split())
"""Words that pick from what they stand before ("any of the books"): not all of them, and no certain one."""
_OF_THEM = re.compile(r"\s+of (?:them|these|those)$")
_HEDGES = _PICKS | frozenset(("a", "an", "more", "other"))
_OTHER = frozenset("other others another different remaining".split())
"""Words for those that were not named before ("the other mug")."""


@dataclass(frozen=True, slots=True)
class NounPhrase:
    """What a phrase names.

    `entities`: what its noun names as it stands, likeliest first; `plurals`: what its noun is a plural of. `is_all`,
    `count`: of how many it speaks; `is_definite`: of known ones ("the", "my"). `wanted`: state pairs and values that
    its adjectives ask for. `place`: the place inside it ("the lamp in the bedroom"). `noun`: the words of its noun.
    `choices`: what it chooses among ("the tv or the radio"), any of which will do; it begins with the first.
    `is_pronoun`: whether it stands for a pronoun, which means what the same words meant before; `is_picked`: one that
    picks ("one"), which need not. `is_other`: whether it is of none that was named before `start`, where in the text it
    stands.
    """

    text: str
    preposition: str
    entities: tuple[str, ...]
    plurals: tuple[str, ...] = ()
    is_all: bool = False
    is_definite: bool = False
    count: int = 1
    wanted: tuple[tuple[str, str], ...] = ()
    place: NounPhrase | None = None
    noun: str = ""
    choices: tuple[NounPhrase, ...] = ()
    is_pronoun: bool = False
    is_picked: bool = False
    is_other: bool = False
    start: int | None = None

    @property
    def is_anew(self) -> bool:
        """Whether it may be of another one than the same words before ("a pen", "one", but not "it")."""
        return not (self.is_all or self.is_definite) and (self.is_picked or not self.is_pronoun)

    @property
    def is_of_several(self) -> bool:
        """Whether it speaks of more than one ("both mugs", "the mugs", "two mugs")."""
        return self.is_all or self.count > 1 or (self.is_definite and bool(self.plurals))


def read_phrases(text: str, domain: Domain) -> tuple[NounPhrase, ...]:
    """The noun phrases of an argument: one for each part of a coordination.

    Raises `UnknownWordError`, naming the part and the nearest known words, and `ImpossibleGoalError` for what is fixed
    and is not at the place inside its phrase ("the window in the study").
    """
    return _read_phrases(_normal(text), domain, text)


def read_argument(argument: Argument, text: str, domain: Domain) -> tuple[NounPhrase, ...]:
    """The noun phrases of an argument in a text; a pronoun has its own preposition ("under it") and may pick some of
    what it stands for ("both mugs ... one").

    Raises what `read_phrases` does.
    """
    phrases = read_phrases(argument.value, domain)
    preposition, said = split_preposition(argument.span.of(text) if argument.span is not None else "", domain)
    if said == split_preposition(argument.value, domain)[1]:
        return phrases
    picked = picked_words(argument, text, domain)
    is_other = _is_other(said.split(), domain)
    phrases = tuple(
        replace(
            p,
            preposition=p.preposition or preposition,
            is_pronoun=not is_other,
            is_picked=bool(picked) or said.startswith(("a ", "an ")),
            is_other=p.is_other or is_other,
            wanted=() if _is_bare_other(said, domain) else p.wanted,
        )
        for p in phrases
    )
    if not picked:
        return phrases
    number = _number(picked, domain)
    if len(phrases) == 1 and (not phrases[0].is_of_several or phrases[0].count == number):
        return phrases
    words = f"{' '.join(picked)} of {argument.value}"
    choices = phrases if len(phrases) > 1 else ()
    return (replace(phrases[0], text=words, is_all=False, is_definite=False, count=number or 1, choices=choices),)


def picked_words(argument: Argument, text: str, domain: Domain) -> list[str]:
    """The words by which a pronoun of a text picks some of what it stands for ("one", "any of them"); else none."""
    said = split_preposition(argument.span.of(text) if argument.span is not None else "", domain)[1]
    words = _OF_THEM.sub("", said).split()
    return words if _number(words, domain) is not None or _PICKS.issuperset(words) else []


def read_state(text: str, pairs: Iterable[str], domain: Domain) -> tuple[str, str] | None:
    """State pair and value that words such as "still hot" name, of these pairs; None if they name none."""
    words = _normal(text).split()
    for start in range(len(words)):
        for end in range(len(words), start, -1):
            phrase = " ".join(words[start:end])
            for pair in pairs:
                for value, names in _state_words(domain)[pair].items():
                    if phrase in names:
                        return pair, value
    return None


def split_preposition(text: str, domain: Domain) -> tuple[str, str]:
    """The preposition that leads a phrase ("" if none does) and the rest, in lower case."""
    words = _normal(text)
    found = ""
    while (preposition := _leading(words, domain)) and words != preposition:
        words = words[len(preposition) :].strip()
        found = found or preposition
        if preposition in domain.lexicon.beside:
            found = preposition
    return found, words


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


@lru_cache(maxsize=32)
def _state_words(domain: Domain) -> dict[str, dict[str, frozenset[str]]]:
    return {
        name: {value: frozenset((value, *pair.words.get(value, ()))) for value in pair.values}
        for name, pair in domain.kinds.state_pairs.items()
    }


@lru_cache(maxsize=32)
def _prepositions(domain: Domain) -> tuple[str, ...]:
    return tuple(sorted(domain.lexicon.prepositions, key=lambda word: (-len(word.split()), word)))


def _leading(words: str, domain: Domain) -> str:
    return next((word for word in _prepositions(domain) if words == word or words.startswith(word + " ")), "")


def _normal(text: str) -> str:
    plain = text.lower().replace("\u2019", "'").replace("\u2018", "'")
    plain = re.sub(r"[^\w\s',&-]", " ", plain)
    return re.sub(r"\s+", " ", plain).strip(" ,'-")


def _read_phrases(words: str, domain: Domain, text: str) -> tuple[NounPhrase, ...]:
    words = _MORE_THAN.sub(lambda match: _one_more(match[1], domain), _AT_LEAST.sub("", words))
    preposition, rest = split_preposition(words, domain)
    rest = _WHICHEVER.sub(r"any \1 that is \2", rest)
    rest, clause = _CLAUSE.sub("", rest), _BEING.search(rest)
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
        entities=tuple(name for name in phrase.entities if _has_colour(name, colours, domain)),
        plurals=tuple(name for name in phrase.plurals if _has_colour(name, colours, domain)),
        wanted=tuple(dict.fromkeys((*phrase.wanted, *((state,) if state is not None else ())))),
    )


def _read_choice(part: str, preposition: str, domain: Domain, later: NounPhrase | None, text: str) -> NounPhrase:
    """One part of a coordination; with "or" whatever any of its alternatives names."""
    said = [choice for choice in _CHOICE.split(part) if choice]
    choices = tuple(_read_part(choice, preposition, domain, later) for choice in said or [""])
    found = tuple(choice for choice in choices if choice is not None)
    if len(found) < len(choices):
        raise _unknown(part or text, domain)
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
        elif _leading(rest, domain):
            head = _read_simple(" ".join(tokens[:i]), preposition, domain, later)
            place = _read_part(rest, "", domain, None) if rest != _leading(rest, domain) else head
            if head is not None and place is not None:
                return head if place is head else replace(_inside(head, place, domain), text=words)
    return None


def _read_of(head: list[str], rest: str, preposition: str, domain: Domain) -> NounPhrase | None:
    """ "X of Y": a measure of Y, a part of Y, or the X that belongs to the place Y."""
    whole = _read_part(rest, preposition, domain, None)
    noun = head[-1]
    measures = {**dict.fromkeys(("both", *_PICKS, *domain.lexicon.all_words), 1), **domain.lexicon.measures}
    measure = noun if noun in measures else next((word for word in (noun[:-1], noun[:-2]) if word in measures), None)
    is_part = noun in domain.lexicon.parts and whole is not None and _opens(whole, domain)
    if whole is not None and (measure is not None or is_part):
        number = _number(head, domain)
        count = number or (measures[measure] if measure else 1)
        is_all = any(word in domain.lexicon.all_words or word == "both" for word in head)
        is_one = noun == "piece" or not _PICKS.isdisjoint(head)
        is_definite = whole.is_definite and number is None and not is_one
        text = " ".join([*head, "of", rest])
        return _of_kind(replace(whole, text=text, count=count, is_all=is_all, is_definite=is_definite), domain)
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
            found = _modified(phrase, tokens[:i], domain)
            if found is not None:
                return found
    if len(tokens) > 1 and tokens[-1] in domain.lexicon.parts:
        whole = _read_simple(" ".join(tokens[:-1]), preposition, domain, later)
        return whole if whole is not None and _opens(whole, domain) else None
    if tokens and later is not None and later.noun and tokens[-1] not in later.noun.split():
        # "the red and the blue mug": the noun stands only once
        return _read_simple(f"{words} {later.noun}", preposition, domain, None)
    return None


def _modified(phrase: NounPhrase, before: list[str], domain: Domain) -> NounPhrase | None:
    """The phrase with the words before its noun taken in; None if one of them is not known."""
    lexicon, wanted, colours = domain.lexicon, list(phrase.wanted), set[str]()
    is_all, count, rooms = False, _number(before, domain), set[str]()
    i = 0
    while i < len(before):
        word = before[i]
        room, length = _room_at(before, i, domain)
        state = None if word in lexicon.prepositions else read_state(word, domain.kinds.state_pairs, domain)
        if word in lexicon.all_words or word == "both":
            is_all = True
        elif word in lexicon.colours:
            colours.add(word)
        elif state is not None:
            wanted.append(state)
        elif room:
            rooms.add(room)
        elif not (word in _HEDGES or word in lexicon.determiners or word in lexicon.measures or word.isdigit()):
            return None
        i += length
    is_hedged = any(word in _HEDGES for word in before)
    is_definite = any(word in DEFINITE for word in before) or not is_hedged

    def fits(entity: str) -> bool:
        return _has_colour(entity, colours, domain) and (not rooms or domain.room_of(entity) in rooms)

    phrase = replace(
        phrase,
        entities=tuple(filter(fits, phrase.entities)),
        plurals=tuple(filter(fits, phrase.plurals)),
        is_all=is_all,
        is_definite=is_definite and count is None,
        count=count or 1,
        wanted=tuple(dict.fromkeys(wanted)),
        is_other=_is_other(before, domain),
    )
    return _of_kind(phrase, domain) if phrase.entities or phrase.plurals else None


def _of_kind(phrase: NounPhrase, domain: Domain) -> NounPhrase:
    """The phrase as a plural, where its noun is one and the name of something else as well ("glasses"), and it speaks
    of more than that has, or of a state that nothing of that name can be in."""
    if not phrase.entities or not phrase.plurals:
        return phrase
    pairs = {pair for pair, _ in phrase.wanted}
    is_of_several = phrase.is_all or phrase.count > 1
    is_too_few = is_of_several and len(phrase.entities) < max(2, phrase.count)
    is_stateless = not any(pairs.issubset(states_of(name, domain)) for name in phrase.entities)
    if not is_too_few and not (is_stateless and any(pairs.issubset(states_of(n, domain)) for n in phrase.plurals)):
        return phrase
    also = domain.nouns.lookup(phrase.noun)[1]
    plurals = (*(name for name in phrase.entities if name in also), *phrase.plurals)
    return replace(phrase, entities=(), plurals=plurals)


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
        return _modified(phrase, ["any", *before], domain) if is_told else None
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
        preposition, place = split_preposition(said, domain)
        is_house = said in lexicon.presence_words and bool(preposition) and place not in ("", "there")
        if said != words and (said == "else" or is_house):
            return people
    return words


def _strip_end(words: str, domain: Domain) -> str:
    """The words without trailing ones that name nothing ("the cup again", "the light here")."""
    tokens = words.split()
    while len(tokens) > 1 and tokens[-1] in domain.lexicon.determiners and not any(domain.nouns.lookup(tokens[-1])):
        tokens.pop()
    return " ".join(tokens)


def _number(words: list[str], domain: Domain) -> int | None:
    for word in words:
        if word.isdigit():
            return int(word)
        if domain.lexicon.measures.get(word, 1) > 1:
            return domain.lexicon.measures[word]
    return None


def _is_other(words: list[str], domain: Domain) -> bool:
    """Whether words before a noun speak of others than before: "the other", "one more" (but not "some more")."""
    is_more = any(
        (word == "more" and _counts(before, domain)) or (before, word) == ("a", "second")
        for before, word in pairwise(words)
    )
    return is_more or not _OTHER.isdisjoint(words)


def _is_bare_other(said: str, domain: Domain) -> bool:
    """Whether words speak of the other of some and not of how it is: that of "the clean mug" need not be clean."""
    words = said.split()
    return "other" in words and read_state(said, domain.kinds.state_pairs, domain) is None


def _counts(word: str, domain: Domain) -> bool:
    return word == "one" or _number([word], domain) is not None


def _one_more(number: str, domain: Domain) -> str:
    """What "more than one" is at least; the words as they are where it is no number."""
    count = int(number) if number.isdigit() else domain.lexicon.measures.get(number)
    return f"more than {number}" if count is None else str(count + 1)


def _room_at(words: list[str], start: int, domain: Domain) -> tuple[str | None, int]:
    """The room that one or two words name, and how many words that are."""
    for length in (2, 1):
        phrase = " ".join(words[start : start + length])
        room = next((name for name in domain.nouns.lookup(phrase)[0] if name in domain.house.rooms), None)
        if room is not None and start + length <= len(words):
            return room, length
    return None, 1


def _has_colour(entity: str, colours: set[str], domain: Domain) -> bool:
    """Whether an entity can be called by these colours: a thing whose colour is not given can by any."""
    if not colours:
        return True
    item = domain.house.things.get(entity)
    return item is not None and (item.colour is None or item.colour in colours)


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


def _unique(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(names))


def _unknown(words: str, domain: Domain) -> UnknownWordError:
    """The error for words that name nothing: the nearest are what the noun alone names, else words that look alike."""
    noun, known = _noun_of(words, domain)
    if known:
        return UnknownWordError(words, _unique(tuple(_describe(name, domain) for name in known))[:4])
    return UnknownWordError(words, domain.nouns.nearest(noun) or domain.nouns.nearest(noun.split()[-1]))


def as_expected(error: UnknownWordError, expected: str, among: Iterable[str], domain: Domain) -> UnknownWordError:
    """The error with what was expected in place of a thing, and where the noun names nothing, the nearest of that."""
    noun, known = _noun_of(error.phrase, domain)
    choices = error.choices if known else domain.nouns.nearest(noun, among)
    return UnknownWordError(error.phrase, choices, expected=expected)


def _noun_of(words: str, domain: Domain) -> tuple[str, tuple[str, ...]]:
    """Words without those that do not say which one, and what the last of them name."""
    tokens = [token for token in words.split() if token not in domain.lexicon.determiners]
    found = (domain.nouns.lookup(" ".join(tokens[i:])) for i in range(len(tokens)))
    return " ".join(tokens) or words, next(((*names, *plurals) for names, plurals in found if names or plurals), ())


def _describe(name: str, domain: Domain) -> str:
    """An entity as a person would say it, with its colour where it has one."""
    item = domain.house.things.get(name)
    noun = domain.kind(name).words[0] if item is not None else name.replace("_", " ")
    return f"{item.colour} {noun}" if item is not None and item.colour else noun
