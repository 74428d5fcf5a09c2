"""The abilities of kinds: whether what is to heat, wash or wipe has what the simulated world needs for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from decomplex_bt.domain.kinds import Category, Kind, Kinds
from decomplex_bt.errors import among

_PLACES: tuple[Category, ...] = ("furniture", "fixture", "floor")
_THINGS: tuple[Category, ...] = ("thing",)


@dataclass(frozen=True, slots=True)
class Ability:
    """What an ability is about. `changes`: the state pair that it changes of what has one of its tags, and `brings` the
    value that this has then; `action`: the action of `domain.pddl` by which it does so; `of`, `on`: the categories of
    kinds that have it, and of those with the tags; `states`: the state pairs that a kind with it needs; `inside`:
    whether things must lie inside for it."""

    action: str
    changes: str
    brings: str
    of: tuple[Category, ...] = _PLACES
    on: tuple[Category, ...] = _THINGS
    states: tuple[str, ...] = ()
    inside: bool = False


ABILITIES: Mapping[str, Ability] = {
    "heats": Ability("heat", "temperature", "hot", states=("aperture", "power"), inside=True),
    "cools": Ability("chill", "temperature", "cold", states=("aperture",), inside=True),
    "washes": Ability("wash", "cleanliness", "clean", states=("aperture", "power"), inside=True),
    "rinses": Ability("rinse", "cleanliness", "clean"),
    "fills": Ability("fill", "fill", "full"),
    "drains": Ability("drain", "fill", "empty"),
    "wipes": Ability("wipe", "cleanliness", "clean", of=_THINGS, on=_PLACES),
}
"""By the key of `kinds.yaml`, which is also the fluent that says so, of what has it and what it works on in this order.

What heats, cools and washes does so behind its closed door: `envs/hands.py` has it so, and so have the actions."""


def check_abilities(kinds: Kinds) -> None:
    """Raises `ValueError` that names kind and ability where nothing could ever come of it."""
    for name, kind in kinds.kinds.items():
        for key, ability in ABILITIES.items():
            if getattr(kind, key):
                _check_kind(f"kinds.{name}.{key}", kind, ability)
            for tag in getattr(kind, key):
                _check_tag(f"kinds.{name}.{key}", tag, ability, kinds)


def _check_kind(where: str, kind: Kind, ability: Ability) -> None:
    if kind.category not in ability.of:
        raise ValueError(
            f"{where}: expected at {' or '.join(ability.of)} alone, and this is a {kind.category}; leave it out"
        )
    states = [pair for pair in ability.states if pair not in kind.states]
    if states or (ability.inside and not kind.inside):
        lacking = ["`inside: true`"] * (not kind.inside) + [f"{', '.join(states)} among its `states`"] * bool(states)
        how = "closed and switched on" if "power" in ability.states else "closed"
        raise ValueError(
            f"{where}: what does so has the things inside and is {how}; give the kind {' and '.join(lacking)}"
        )


def _check_tag(where: str, tag: str, ability: Ability, kinds: Kinds) -> None:
    tags = {tag for kind in kinds.kinds.values() for tag in kind.tags}
    if tag not in tags:
        raise ValueError(f"{where}: no kind has the tag {tag!r}{among(tag, sorted(tags))}")
    of_tag = [kind for kind in kinds.kinds.values() if tag in kind.tags and kind.category in ability.on]
    if not any(ability.changes in kind.states for kind in of_tag):
        raise ValueError(
            f"{where}: no {' or '.join(ability.on)} with the tag {tag!r} has {ability.changes!r} among its states; "
            "add it to those kinds, or name another tag"
        )
