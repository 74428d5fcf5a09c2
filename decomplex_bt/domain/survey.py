"""The survey of a house: whether all that it names is known, and everything stands where it can."""

from __future__ import annotations

from collections.abc import Collection
from itertools import combinations
from math import prod

from decomplex_bt.domain.house import USER, House, Rect
from decomplex_bt.domain.kinds import Category, Kinds
from decomplex_bt.errors import among

TOLERANCE = 0.02
"""[m] By which what is measured may lie over what it touches."""
MOST_GROUND = 4000.0
"""[m²] What a house takes up at most, with all that lies between its rooms: the robot's map is a grid over it."""
FARTHEST = 10_000.0
"""[m] How far from the origin a room may lie: what is observed are single-precision numbers, there right to 1 mm."""


_CATEGORIES: dict[str, tuple[Category, ...]] = {
    "rooms": ("room",),
    "doorways": ("fixture",),
    "furniture": ("furniture", "fixture"),
    "things": ("thing",),
    "people": ("person",),
}
"""What kinds the entries of a section may be of."""


def check_house(house: House, kinds: Kinds, colours: Collection[str]) -> None:
    """Raises `ValueError` naming the key where a kind, place or room is unknown, two things are in one place, or the
    house is too large. `colours`: those that there are words for."""
    _check_extent(house)
    _check_kinds(house, kinds)
    _check_user(house)
    _check_things(house, kinds)
    _check_colours(house, colours)
    _check_starts(house)
    _check_rooms(house)
    _check_furniture(house, kinds)
    _check_parts(house)


def _check_extent(house: House) -> None:
    """That a map of the house is of a size that can be worked with."""
    rects = {name: room.rect for name, room in house.rooms.items()}
    for name, rect in rects.items():
        if (far := max(rect, key=abs)) and abs(far) > FARTHEST:
            raise ValueError(
                f"rooms.{name}.rect: {far:g} m is too far from the origin, which may be {FARTHEST:g} m; "
                "lengths are in metres: divide centimetres by 100, or move the house nearer"
            )
    width, depth = _extent(rects.values())
    if width * depth <= MOST_GROUND:
        return
    without = {name: _extent([rect for room, rect in rects.items() if room != name]) for name in rects}
    farthest = min(without, key=lambda name: prod(without[name]))
    raise ValueError(
        f"rooms.{farthest}: with it the rooms stretch over {width:g} x {depth:g} m, {width * depth:.0f} m² of ground; "
        f"a house may take up {MOST_GROUND:.0f} m². Lengths are in metres: divide centimetres by 100, "
        "make the rooms smaller, or move them together"
    )


def _extent(rects: Collection[Rect]) -> tuple[float, float]:
    """Width and depth of the rectangle around all of these; (0, 0) around none."""
    if not rects:
        return 0.0, 0.0
    left, bottom, right, top = zip(*rects, strict=True)
    return max(right) - min(left), max(top) - min(bottom)


def _check_kinds(house: House, kinds: Kinds) -> None:
    for section in ("rooms", "doorways", "furniture", "things", "people"):
        for name, entry in getattr(house, section).items():
            if section == "doorways" and entry.kind is None:
                continue
            fitting = [kind for kind, what in kinds.kinds.items() if what.category in _CATEGORIES[section]]
            if entry.kind not in fitting:
                is_known = entry.kind in kinds.kinds
                found = f"a {kinds.kinds[entry.kind].category}" if is_known else "unknown"
                other = "" if is_known else " (for kinds of another domain, give it as the `domain`)"
                raise ValueError(
                    f"{section}.{name}: the kind {entry.kind!r} is {found}; expected the kind of a "
                    f"{' or '.join(_CATEGORIES[section])}, as kinds.yaml has it{other}{among(entry.kind, fitting)}"
                )


def _check_user(house: House) -> None:
    """That the one who gives the instructions is the first of the people, the only user, and at home."""
    if house.people[house.user].home < 1:
        raise ValueError(
            f"people.{house.user}.home: the first of the people is the user, who is always at home; leave it out"
        )
    for name, person in house.people.items():
        if person.kind == USER and name != house.user:
            raise ValueError(
                f"people.{name}: a second user; the first of the people, {house.user}, is the user. "
                f"Give {name} another kind, or put them first and give {house.user} another kind"
            )


def _check_things(house: House, kinds: Kinds) -> None:
    """That every thing may lie somewhere: at the places that the house gives it, which are all to be there, or at one
    at least of those of its kind."""
    named = house.places_by_name()
    for name, item in house.things.items():
        kind = kinds.kinds[item.kind]
        for where in item.places:
            if where not in named:
                raise ValueError(
                    f"things.{name}.places: {where!r} is no place of the house, by name or kind{among(where, named)}; "
                    "add it under furniture, or leave it out"
                )
        places = item.places or kind.places
        for place in (place for where in places for place in named.get(where, ())):
            if not (house.kind(place, kinds).surface or house.kind(place, kinds).inside):
                raise ValueError(f"things.{name}: nothing can lie on or in {place!r}")
        absent = kind.absent if item.absent is None else item.absent
        if absent < 1 and not any(weight and where in named for where, weight in places.items()):
            floor = house.floor_of(next(iter(house.rooms)))
            raise ValueError(
                f"things.{name}: the house has none of the places of its kind ({', '.join(kind.places)}); "
                f"add one of them under furniture, or give the thing its own, as in places: {{{floor}: 1}}"
            )


def _check_colours(house: House, colours: Collection[str]) -> None:
    """That the colours that tell things apart can be said."""
    for name, item in house.things.items():
        if item.colour is not None and item.colour not in colours:
            known = among(item.colour, colours)
            raise ValueError(f"things.{name}.colour: {item.colour!r} is none of the colours of words.yaml{known}")


def _check_starts(house: House) -> None:
    """That people and the robot begin in rooms that there are."""
    starts = {f"people.{name}.rooms": person.rooms for name, person in house.people.items()}
    for key, rooms in (*starts.items(), ("robot_start", house.robot_start)):
        for room in rooms:
            if room not in house.rooms:
                raise ValueError(f"{key}: unknown room {room!r}{among(room, house.rooms)}")


def _check_rooms(house: House) -> None:
    for (one, first), (other, second) in combinations(house.rooms.items(), 2):
        if _overlap(first.rect, second.rect) > TOLERANCE:
            raise ValueError(f"rooms.{other}: it overlaps {one}; rooms share no more than walls")


def _check_furniture(house: House, kinds: Kinds) -> None:
    """That every piece is in its room, with all of its body, and no body is where another of the room is."""
    bodies: dict[str, dict[str, Rect]] = {room: {} for room in house.rooms}
    for name, piece in house.furniture.items():
        room, (x, y) = house.rooms[piece.room].rect, piece.centre
        has_body = piece.part_of is None and kinds.kinds[piece.kind].category == "furniture"
        if not _holds(room, piece.footprint if has_body else (x, y, x, y)):
            raise ValueError(f"furniture.{name}: it is not within its room, {piece.room}, which is {room}")
        if not has_body:
            continue
        for other, rect in bodies[piece.room].items():
            if _overlap(rect, piece.footprint) > TOLERANCE:
                raise ValueError(
                    f"furniture.{name}: it overlaps {other}; move it, or make it a part of that (part_of: {other})"
                )
        bodies[piece.room][name] = piece.footprint


def _check_parts(house: House) -> None:
    """That what is part of another piece is where that is, and not in turn what that is part of."""
    for name, piece in house.furniture.items():
        if piece.part_of is None:
            continue
        whole = house.furniture[piece.part_of]
        if whole.room != piece.room:
            raise ValueError(f"furniture.{name}: it is part of {piece.part_of}, which is in {whole.room}, another room")
        if _overlap(piece.footprint, whole.footprint) < -TOLERANCE:
            raise ValueError(f"furniture.{name}: it is part of {piece.part_of} and does not touch it; move it there")
        wholes = [name]
        while (above := house.furniture[wholes[-1]].part_of) is not None:
            if above in wholes:
                raise ValueError(f"furniture.{name}: it is part of itself, by way of {', '.join([*wholes[1:], above])}")
            wholes.append(above)


def _overlap(one: Rect, other: Rect) -> float:
    """By how many metres two rectangles overlap in the direction in which they do so less; 0 or less: they do not."""
    return min(min(one[axis + 2], other[axis + 2]) - max(one[axis], other[axis]) for axis in (0, 1))


def _holds(room: Rect, rect: Rect) -> bool:
    return all(room[axis] - TOLERANCE <= rect[axis] and rect[axis + 2] <= room[axis + 2] + TOLERANCE for axis in (0, 1))
