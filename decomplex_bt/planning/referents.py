"""Referents: what the noun phrases of an instruction may mean in a house, one after the other.

Conservative: nothing is guessed from words that merely look alike.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument
from decomplex_bt.planning.abilities import holds_things, states_of
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.modifiers import DEFINITE
from decomplex_bt.planning.noun_phrase import NounPhrase
from decomplex_bt.planning.others import Others
from decomplex_bt.planning.phrases import nothing_there, read_argument, rooms_of
from decomplex_bt.planning.prepositions import split_preposition
from decomplex_bt.planning.suggestions import as_expected

TO = frozenset(("", "to", "at", "towards", "toward", "up to", "over to", "down to"))
PLACES = frozenset(("goal", "location", "source", "path"))
"""Types of arguments that say where."""
Key = tuple[tuple[str, ...], tuple[tuple[str, str], ...], tuple[Referent, ...]]


class Referents:
    """The referents of a text's phrases in their order: rooms named on the way tell ambiguous places apart, and a
    definite phrase takes up an earlier one.

    Raises `UnknownWordError` for what names nothing here, `ImpossibleGoalError` for what cannot be what it has to be.
    """

    def __init__(self, text: str, flow: Flow, domain: Domain) -> None:
        self._text, self._domain, self._house = text, domain, domain.house
        self._rooms_meant: tuple[str, ...] = ()  # of the place named last, where its words leave no doubt
        self._mentioned: dict[Key, Referent] = {}
        self._named: dict[str, Referent] = {}  # by its words, the last one
        self.others = Others(text, flow, domain)
        self._container: str | None = None  # with a door of its own, where it was named last of all places

    def phrases(self, argument: Argument) -> tuple[NounPhrase, ...]:
        start = argument.span.start if argument.span is not None else None
        try:
            read = read_argument(argument, self._text, self._domain)
        except UnknownWordError as error:
            raise self._expecting(error, argument.type) from None
        return tuple(replace(phrase, start=start) for phrase in read)

    def _expecting(self, error: UnknownWordError, role: str) -> UnknownWordError:
        """The error of an argument that names nothing, with what its type asks for."""
        if role == "recipient":
            return as_expected(error, "a person", self._house.people, self._domain)
        if role in PLACES:
            known = (*self._house.rooms, *self._house.places(), *self._house.people)
            return as_expected(error, "a room, a place or a person", known, self._domain)
        return error

    def where(self, phrase: NounPhrase) -> Referent:
        """Where something is looked for: on or in a place, beside a thing or with a person."""
        referent = self.referent(phrase, lambda name: True, "be a place", is_place=True)
        if phrase.preposition in self._domain.lexicon.beside:
            near = [place for name in referent.candidates for place in (name, *self._beside(name))]
            return replace(referent, candidates=tuple(dict.fromkeys(place for place in near if self.can_hold(place))))
        if not all(self.is_thing(name) for name in referent.candidates) or phrase.preposition not in (
            "in",
            "inside",
            "into",
        ):
            return referent
        raise ImpossibleGoalError(f"nothing can lie in {phrase.text!r} here")

    def goal_place(self, argument: Argument) -> Referent:
        """Where a thing is put: on or in a place, in a room, beside a thing, or to a person."""
        words = argument.value
        phrase, *others = self.phrases(argument)
        referent = self.referent(phrase, lambda name: True, "be a place", is_place=True)
        if others or (phrase.is_all and len(referent.candidates) > 1):
            raise ImpossibleGoalError(f"a thing ends up in one place, not {words!r}; say which, or which thing where")
        fit = self.narrowed(referent, self.can_hold)
        is_near = fit is None and phrase.preposition in TO  # "to the front door": nothing can be put on it
        if is_near or phrase.preposition in self._domain.lexicon.beside:
            ends = tuple(dict.fromkeys(place for name in referent.candidates for place in self._beside(name)))
            is_on_floor = {self._house.floor_of(room) for room in self._house.rooms}.issuperset(ends)
            return replace(referent, candidates=ends, near=referent.candidates if is_on_floor else ())
        if fit is None or all(self.is_thing(name) for name in fit.candidates):
            raise ImpossibleGoalError(
                f"nothing can be put there: {words!r} names neither a surface nor a container of this house"
            )
        return fit

    def place(self, argument: Argument, *, people: bool = False) -> Referent:
        """Where the robot goes: a room, a place, a door, a person or what lies there; to several places one by one."""

        def fits(name: str) -> bool:
            return people or not self.is_person(name)

        words, phrases = argument.value, self.phrases(argument)
        first, *others = [self.referent(phrase, fits, "be gone to", is_place=True) for phrase in phrases]
        if not others:
            return first
        names = tuple(dict.fromkeys(name for referent in (first, *others) for name in referent.candidates))
        if len(names) > len(phrases) or not all(map(self.is_fixed, names)):
            raise ImpossibleGoalError(f"{words!r} leaves open where to go; say one place after the other")
        return Referent(split_preposition(words, self._domain)[1], names, is_all=True)

    def elsewhere(self, argument: Argument) -> Referent:
        """Anywhere but the room that is left, the rooms next to it first.

        What there is one of in every room ("the rug") is the likeliest of them.
        """
        places = self.place(argument).candidates
        left = {self.room(name) for name in places}
        if left.issuperset(self._house.rooms):
            left = {self.room(places[0])}
        next_to = [room for d in self._house.doorways.values() if left & set(d.rooms) for room in d.rooms]
        rooms = tuple(room for room in dict.fromkeys([*next_to, *self._house.rooms]) if room not in left)
        return Referent(f"out of {split_preposition(argument.value, self._domain)[1]}", rooms)

    def person(self, phrase: NounPhrase) -> Referent | None:
        """Who a phrase means, where it is of people."""
        is_of_people = bool(phrase.entities) and all(map(self.is_person, phrase.entities))
        return self.referent(phrase, self.is_person, "be anybody", is_place=False) if is_of_people else None

    def people(self, argument: Argument, ability: str) -> tuple[Referent, ...]:
        phrases = self.phrases(argument)
        return tuple(self.referent(phrase, self.is_person, ability, is_place=False) for phrase in phrases)

    def referent(
        self,
        phrase: NounPhrase,
        fits: Callable[[str], bool],
        ability: str,
        *,
        rooms: frozenset[str] = frozenset(),
        is_place: bool,
    ) -> Referent:
        """The referent of a noun phrase: of what it names, what fits; of a pronoun what the same words meant before,
        wherever the robot has been sent meanwhile. Raises `ImpossibleGoalError` if nothing fits: it "cannot" `ability`,
        with the kind of what is named in place of "{}".
        """
        words = split_preposition(phrase.text, self._domain)[1]
        is_pronoun = phrase.is_pronoun and not rooms
        before = self._named.get(words) if is_pronoun or (phrase.is_other and phrase.is_definite) else None
        is_new = before is not None and not phrase.is_other and self.others.are_excluded(phrase, before.candidates)
        if before is not None and not is_new and all(map(fits, before.candidates)):
            return before
        if before is not None and phrase.noun in self._domain.lexicon.anything_words:
            raise ImpossibleGoalError(f"{phrase.text!r} may be what cannot {ability.format('it')}; say what")
        if self._container is not None and self._is_bare_part(phrase, words):
            phrase = replace(phrase, entities=(self._container,))  # "the door", after the fridge
        is_plural = not any(map(fits, phrase.entities))
        names = tuple(dict.fromkeys(n for choice in phrase.choices or (phrase,) for n in _named(choice, fits)))
        if not names and phrase.is_all and phrase.plurals == tuple(self._house.things):
            names = tuple(name for name in self._house.places() if fits(name))  # "turn everything off"
        if not names:
            first = (*phrase.entities, *phrase.plurals)[0]
            kind = self._domain.kind(first).words[0] if self.is_thing(first) else first.replace("_", " ")
            why = ability.format(kind) if "{}" in ability else f"{ability} ({kind} is what it names here)"
            raise ImpossibleGoalError(f"{phrase.text!r} cannot {why}")
        names, where = self._told_by_state(phrase, names)
        is_all = phrase.is_all or (is_plural and phrase.is_definite)
        named, others = self.others.than(phrase, names)
        if rooms:
            names = self._in_rooms(named, rooms, words)
        else:
            names = named if is_all or phrase.is_other else self._in_context(named)
        if phrase.count > len(names):
            raise ImpossibleGoalError(f"{phrase.text!r}: there are only {len(names)} of them in this house")
        if is_place or all(self.is_fixed(name) for name in names):
            self._remember(names)
        if is_place and len(names) == 1 and words.split()[0] in DEFINITE:
            where = ()  # "in the open drawer" is in the drawer, open or not
        is_any = not (is_all or phrase.is_definite)
        is_all = is_all and (len(names) > 1 or bool(where))
        referent = Referent(words, names, is_all, phrase.count, where, is_any, others)
        referent = self._same(referent) if phrase.is_definite else self._first(referent)
        self._named[words] = referent
        self.others.name(referent)
        return referent

    def _told_by_state(
        self, phrase: NounPhrase, names: tuple[str, ...]
    ) -> tuple[tuple[str, ...], tuple[tuple[str, str], ...]]:
        """Of what a phrase names, what can be in the states by which it tells one from another, and these states; a
        state that none of them can be in tells nothing ("the warm blanket")."""
        where = tuple(
            (pair, v) for pair, v in phrase.wanted if any(pair in states_of(name, self._domain) for name in names)
        )
        if phrase.choices:
            return names, where  # "a clean cup or a pen"
        return tuple(n for n in names if all(pair in states_of(n, self._domain) for pair, _ in where)) or names, where

    def _is_bare_part(self, phrase: NounPhrase, words: str) -> bool:
        """Whether it is of a door or lid and does not say of which ("the door", but not "the kitchen door")."""
        lexicon = self._domain.lexicon
        return phrase.noun in lexicon.parts and all(w in lexicon.determiners for w in words.split() if w != phrase.noun)

    def _first(self, referent: Referent) -> Referent:
        self._mentioned.setdefault(_key(referent), referent)
        return referent

    def _same(self, referent: Referent) -> Referent:
        """The referent that a definite phrase takes up again ("a pen ... the pen"), or itself."""
        first = self._mentioned.setdefault(_key(referent), referent)
        return first if (first.is_all, first.count) == (referent.is_all, referent.count) else referent

    def may_be_in(self, phrase: NounPhrase, rooms: frozenset[str]) -> bool:
        """Whether something that a phrase names may be in one of some rooms."""
        names = (*phrase.entities, *phrase.plurals)
        return any(not self.is_fixed(name) or rooms & {*self._rooms(name)} for name in names)

    def _in_rooms(self, names: tuple[str, ...], rooms: frozenset[str], words: str) -> tuple[str, ...]:
        """Of fixed candidates those in the rooms that are said."""
        there = tuple(name for name in names if not self.is_fixed(name) or rooms & {*self._rooms(name)})
        if not there:
            raise nothing_there(words, names, rooms, self._domain)
        return there

    def _in_context(self, names: tuple[str, ...]) -> tuple[str, ...]:
        """Of fixed candidates those in the room in question, if there are any."""
        if not all(map(self.is_fixed, names)):
            return names
        return tuple(name for name in names if set(self._rooms_meant) & set(self._rooms(name))) or names

    def _remember(self, names: tuple[str, ...]) -> None:
        rooms = tuple(sorted({room for name in names for room in self._rooms(name)}))
        if len(rooms) == 1:
            self._rooms_meant = rooms
        only = names[0] if len(names) == 1 and names[0] in self._house.furniture else None
        self._container = only if only is not None and self._domain.kind(only).has_door else None

    def _rooms(self, name: str) -> tuple[str, ...]:
        return rooms_of(name, self._domain)

    def room(self, name: str) -> str | None:
        return self._domain.room_of(name)

    def _beside(self, name: str) -> tuple[str, ...]:
        """Where something lies that is beside, under or behind this: on what it is part of, else on the floor there."""
        if self.is_thing(name) or self.is_person(name) or name in self._house.rooms:
            return (name,)
        piece = self._house.furniture.get(name)
        if piece is not None and piece.part_of is not None and holds_things(piece.part_of, self._domain):
            return (piece.part_of,)
        return tuple(self._house.floor_of(room) for room in self._rooms(name))

    def settle(self, referent: Referent, meant: Referent) -> None:
        """What takes up a referent again from now on takes up what has become of it."""
        self._mentioned.update({key: meant for key, value in self._mentioned.items() if value == referent})
        self._named.update({words: meant for words, value in self._named.items() if value == referent})

    def narrowed(self, referent: Referent, fits: Callable[[str], bool]) -> Referent | None:
        names = tuple(name for name in referent.candidates if fits(name))
        return replace(referent, candidates=names) if names else None

    def can_hold(self, name: str) -> bool:
        return (
            name in self._house.rooms or self.is_person(name) or self.is_thing(name) or holds_things(name, self._domain)
        )

    def is_thing(self, name: str) -> bool:
        return name in self._house.things

    def is_person(self, name: str) -> bool:
        return name in self._house.people

    def is_fixed(self, name: str) -> bool:
        return not self.is_thing(name) and not self.is_person(name)

    def may_move(self, referents: Sequence[Referent]) -> bool:
        """Whether any of what they may mean is a thing or a person, which need not be where it was."""
        return any(not self.is_fixed(name) for referent in referents for name in referent.candidates)


def _named(phrase: NounPhrase, fits: Callable[[str], bool]) -> list[str]:
    """Of what a phrase names, what fits; of what it is a plural of, where it names nothing else."""
    return list(filter(fits, phrase.entities)) or list(filter(fits, phrase.plurals))


def _key(referent: Referent) -> Key:
    return referent.candidates, referent.where, referent.others
