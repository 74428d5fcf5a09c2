"""Noun phrases: what one names in a house, as far as its words tell."""

from __future__ import annotations

from dataclasses import dataclass


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


def unique(names: tuple[str, ...]) -> tuple[str, ...]:
    """The names, each once, in the order of their first mention."""
    return tuple(dict.fromkeys(names))
