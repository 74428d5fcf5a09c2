"""The kinds of entities a domain knows: their words, what they can do and where they tend to be."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from pydantic import Field, model_validator

from decomplex_bt.domain.document import Format, Probability, Record, Weights, Word
from decomplex_bt.errors import among

Category = Literal["room", "floor", "furniture", "fixture", "thing", "person"]
"""`furniture`: fixed, with devices and containers; `fixture`: doors, windows, curtains, opened and closed, fixed."""
Shape = Literal["disc", "cup", "bottle", "plate", "bar", "book", "box", "paper", "ball", "ring", "cloth", "pan"]
LARGEST = 0.25
"""[m] The radius of the largest thing that the gripper carries; the robot's own is 0.22."""
STATE_VALUES: Mapping[str, tuple[str, str]] = {
    "power": ("on", "off"),
    "aperture": ("open", "closed"),
    "temperature": ("hot", "cold"),
    "cleanliness": ("clean", "dirty"),
    "fill": ("full", "empty"),
}
"""The state pairs that the simulated world has, each with its (positive, negative) value.

Observations have a column for each, in this order (`envs/interface.py`), so a domain may leave one out, but neither
rename nor turn it round nor add to them.
"""
_OF_WHAT_IS_FIXED = frozenset(("power", "aperture"))
"""State pairs that only furniture and fixtures have: nothing in a hand is switched on or opened."""


class StatePair(Record):
    """A state with its opposite, as on/off: two fluents of which exactly one holds. `values`: (positive, negative)."""

    values: tuple[str, str]
    words: dict[str, tuple[Word, ...]] = {}
    """Other words for a value, by value ("on": switched on, running)."""


class Kind(Record):
    """One kind of entity. Lengths in metres, masses in kilograms, probabilities in [0, 1].

    `words`: the names people use, the first is the one we print. `states`: state pairs an entity of this kind has.
    `surface` / `inside`: things lie on / in it. `heats`, `cools`, `washes`: tags of things it heats when closed and
    switched on, cools when closed, washes when closed and switched on; `rinses`, `fills`, `drains`: tags of things
    cleaned, filled, emptied at it by hand; `wipes`: tags of surfaces a thing of this kind wipes clean when it is in the
    hand (the interaction `clean` with the surface as target). `pours`: kinds of what it fills things with. `tags` are
    what these name, but for `pours`.
    `places`: kind of place to relative weight, for where an entity of this kind lies at the start of an episode;
    `absent`: probability that it is nowhere in the house.
    `chance`: state pair to the probability of its positive value. `broken`: probability that a device is broken.
    """

    category: Category
    words: tuple[Word, ...] = Field(min_length=1)
    states: tuple[str, ...] = ()
    surface: bool = False
    inside: bool = False
    tags: tuple[str, ...] = ()
    heats: tuple[str, ...] = ()
    cools: tuple[str, ...] = ()
    washes: tuple[str, ...] = ()
    rinses: tuple[str, ...] = ()
    fills: tuple[str, ...] = ()
    pours: tuple[str, ...] = ()
    drains: tuple[str, ...] = ()
    wipes: tuple[str, ...] = ()
    radius: float = Field(0.05, gt=0)
    mass: float = Field(0.3, gt=0)
    shape: Shape = "disc"
    """How a thing is drawn."""
    places: Weights = {}
    absent: Probability = 0.0
    chance: dict[str, Probability] = {}
    broken: Probability = 0.0

    @property
    def is_container(self) -> bool:
        return self.inside

    @property
    def is_device(self) -> bool:
        return "power" in self.states

    @property
    def has_door(self) -> bool:
        return "aperture" in self.states


class Kinds(Record):
    """`kinds.yaml`: the state pairs and the kinds of a domain, by name."""

    format: Format
    state_pairs: dict[str, StatePair]
    kinds: dict[str, Kind]

    @model_validator(mode="after")
    def _check(self) -> Kinds:
        for name, both in self.state_pairs.items():
            _check_pair(name, both)
        for name, kind in self.kinds.items():
            if kind.category not in ("furniture", "fixture") and (pairs := _OF_WHAT_IS_FIXED & set(kind.states)):
                raise ValueError(
                    f"kinds.{name}.states: only furniture and fixtures have {min(pairs)!r}, and this is a "
                    f"{kind.category}; leave it out, or make the kind one of furniture"
                )
            if kind.category == "thing" and kind.radius > LARGEST:
                raise ValueError(
                    f"kinds.{name}.radius: {kind.radius:g} m is too large for a thing that a gripper carries; expected "
                    f"more than 0, up to {LARGEST:g} m"
                )
            for pair in (*kind.states, *kind.chance):
                if pair not in self.state_pairs:
                    raise ValueError(
                        f"kind {name!r} has the unknown state pair {pair!r}{among(pair, self.state_pairs)}"
                    )
            for poured in kind.pours:
                if poured not in self.kinds:
                    raise ValueError(f"kind {name!r} pours the unknown kind {poured!r}{among(poured, self.kinds)}")
            if kind.pours and not kind.fills:
                raise ValueError(
                    f"kinds.{name}.pours: it says what things are filled with, and this kind fills none; give it "
                    "`fills` with the tags of what it fills, or leave it out"
                )
            for place in kind.places:
                if place not in self.kinds:
                    raise ValueError(
                        f"kind {name!r} lies at the unknown kind of place {place!r}{among(place, self.kinds)}"
                    )
                if not (self.kinds[place].surface or self.kinds[place].inside):
                    raise ValueError(f"kind {name!r} cannot lie at {place!r}: it is neither surface nor container")
        return self

    def pair_of(self, value: str) -> str:
        """The state pair that a value belongs to. Raises `KeyError`."""
        for name, pair in self.state_pairs.items():
            if value in pair.values:
                return name
        raise KeyError(value)

    def opposite(self, value: str) -> str:
        """The other value of its pair. Raises `KeyError`."""
        positive, negative = self.state_pairs[self.pair_of(value)].values
        return negative if value == positive else positive


def _check_pair(name: str, pair: StatePair) -> None:
    """Raises `ValueError` for a state that the world does not have, and for words that do not tell its values apart."""
    key = f"state_pairs.{name}"
    if name not in STATE_VALUES:
        raise ValueError(f"{key}: the simulated world has no such state{among(name, STATE_VALUES)}; leave it out")
    if pair.values != STATE_VALUES[name]:
        expected, found = (f"[{', '.join(values)}]" for values in (STATE_VALUES[name], pair.values))
        raise ValueError(
            f"{key}.values: expected {expected} in this order, as observations have it; what people call them goes "
            f"under words (got {found})"
        )
    meant: dict[str, str] = {value: value for value in pair.values}
    for value, words in pair.words.items():
        if value not in pair.values:
            raise ValueError(f"{key}.words: {value!r} is none of its values, {' and '.join(pair.values)}")
        for word in map(str.casefold, words):
            if meant.setdefault(word, value) != value:
                raise ValueError(
                    f"{key}.words.{value}: {word!r} means {meant[word]!r}, too; leave it out at one of them"
                )
