"""What the robot does besides driving: one function for each interaction, its outcome a `Result`, never an exception.

An interaction that is not possible changes nothing. Targets are rows of the entity table (`interface`). A result tells
nothing that the robot could not find out by being there: what is not within reach, for whatever reason (elsewhere,
behind a closed door, not in the house), is out of reach.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import cos, hypot, pi, sin

from decomplex_bt.envs.chance import APERTURE, POWER, TEMPERATURE
from decomplex_bt.envs.interface import STATE_PAIRS, Interaction, Result
from decomplex_bt.envs.spots import ROBOT_RADIUS
from decomplex_bt.envs.walking import Lead, ask_to_lead, is_near_person
from decomplex_bt.envs.world import NOTHING, Event, World

CLEANLINESS, FILL = STATE_PAIRS.index("cleanliness"), STATE_PAIRS.index("fill")
DROP_GAP = 0.06  # [m] between the robot and what it puts on the floor
DROP_TURNS = tuple(sign * step * pi / 8 for step in range(9) for sign in (1, -1))
"""Directions, relative to the heading, in which the robot tries to put a thing on the floor."""

Point = tuple[float, float]
# asking an enum takes ten times as long
_NONE, _FINISH, _PICKING, _SAYING = Interaction.NONE, Interaction.FINISH, Interaction.PICK, Interaction.SAY
_NO_RESULT = Result.NONE
_NOBODY = Lead()


def interact(world: World, interaction: Interaction, target: int) -> Result:
    """Carries out one interaction with the row `target` and keeps what happened as the world's event."""
    world.event = None
    if interaction is _NONE:
        return _NO_RESULT
    if interaction is _FINISH:
        return Result.OK
    if target > world.geometry.robot_row:  # a row that stands for nothing in this house
        return Result.NOT_THERE
    people, hand, version = world.geometry.people_rows, world.held, world.version
    is_addressed, is_picking = target in people, interaction is _PICKING
    holder = int(world.place[target]) if is_picking else NOTHING
    led = _NOBODY
    if interaction is _SAYING and not is_addressed:
        led = ask_to_lead(world, target)
        result = led.result
    else:
        act = _ACT_OF[interaction]
        assert act is not None
        result = act(world, target)
    if world.version != version:
        world.deeds += 1
    names = world.geometry.names
    thing = target if is_picking else hand
    person = target if is_addressed else holder if is_picking else led.person
    world.event = Event(
        interaction,
        names[target],
        result,
        names[thing] if thing != NOTHING else None,
        names[person] if person in people else None,
        names[led.goal] if led.goal != NOTHING else None,
    )
    return result


def is_person(world: World, row: int) -> bool:
    return row in world.geometry.people_rows


def reaches_place(world: World, place: int) -> bool:
    """Whether the robot's hand gets to a place: to its nearest point, past no wall; to a floor, from anywhere on it."""
    geometry = world.geometry
    x, y = world.robot
    room = geometry.room_at(x, y)
    if world.is_floor(place):
        return room == geometry.place_room[place]
    if geometry.distance(x, y, place) > world.config.reach:
        return False
    if room == geometry.place_room[place]:
        return True
    others = [leaf for leaf in world.closed_leaves if geometry.row[leaf] != place]
    return geometry.is_free_line((x, y), geometry.nearest_point(x, y, place), others)


def reaches_thing(world: World, thing: int) -> bool:
    """Whether the robot's hand gets to a thing that lies somewhere: itself, or the open place it lies at."""
    place = int(world.place[thing])
    if place < 0 or place >= world.geometry.place_count or is_shut(world, place):
        return False
    if not world.is_floor(place) and reaches_place(world, place):
        return True
    x, y = world.position[thing].tolist()
    away = hypot(x - world.robot[0], y - world.robot[1]) - world.prior.radius[thing]
    return away <= world.config.reach and world.geometry.is_free_line(world.robot, (x, y), world.closed_leaves)


def is_shut(world: World, place: int) -> bool:
    """Whether a place is a container with its door closed."""
    return bool(world.prior.has_door[place]) and world.states[place, APERTURE] == 0


def _pick(world: World, thing: int) -> Result:
    if thing not in world.geometry.thing_rows:
        return Result.NOT_POSSIBLE
    if world.held != NOTHING:
        return Result.HAND_FULL
    holder = int(world.place[thing])
    if holder == world.geometry.robot_row:
        world.tray[world.tray.index(thing)] = NOTHING
        world.held = thing
        world.version += 1
        return Result.OK
    can_reach = is_near_person(world, holder) if is_person(world, holder) else reaches_thing(world, thing)
    if not can_reach:
        return Result.OUT_OF_REACH
    if world.grasp_slip > 0 and world.noise.random() < world.grasp_slip:
        return Result.SLIPPED
    world.held = thing
    world.lift(thing, world.geometry.robot_row)
    return Result.OK


def _place(world: World, place: int) -> Result:
    if place == world.geometry.robot_row:
        return _stow(world)
    if place >= world.geometry.place_count or not world.prior.holds[place]:
        return Result.NOT_POSSIBLE
    if world.held == NOTHING:
        return Result.HAND_EMPTY
    if not reaches_place(world, place):
        return Result.OUT_OF_REACH
    if is_shut(world, place):
        return Result.CLOSED
    spot = _floor_spot(world, place) if world.is_floor(place) else _nearest_spot(world, place)
    if spot is None:
        return Result.NO_ROOM
    thing, world.held = world.held, NOTHING
    world.lay(thing, place, spot)
    return Result.OK


def _stow(world: World) -> Result:
    if world.held == NOTHING:
        return Result.HAND_EMPTY
    if NOTHING not in world.tray:
        return Result.NO_ROOM
    world.tray[world.tray.index(NOTHING)] = world.held
    world.held = NOTHING
    world.version += 1
    return Result.OK


def _nearest_spot(world: World, place: int) -> Point | None:
    """The free spot nearest to the robot; where all are taken, the nearest of all: things are piled up."""
    radius = world.prior.radius[world.held]
    spots = world.spots.lying(place, radius, world.discs_at(place))
    if not len(spots):
        spots = world.spots.lying(place, radius)
    if not len(spots):
        spots = world.spots.lying(place, 0.0)
    if not len(spots):
        return None
    x, y = world.robot
    best = spots[((spots[:, 0] - x) ** 2 + (spots[:, 1] - y) ** 2).argmin()]
    return float(best[0]), float(best[1])


def _floor_spot(world: World, floor: int) -> Point | None:
    """A free spot on the floor beside the robot, in front of it if possible."""
    radius = world.prior.radius[world.held]
    away = ROBOT_RADIUS + radius + DROP_GAP
    heading = float(world.heading[world.geometry.robot_row])
    x, y = world.robot
    taken = tuple(world.discs_at(floor))
    for turn in DROP_TURNS:
        spot = x + away * cos(heading + turn), y + away * sin(heading + turn)
        in_room = world.geometry.room_at(*spot) == world.geometry.place_room[floor]
        if in_room and world.spots.is_free(*spot, radius, taken):
            return spot
    return None


def _open(world: World, place: int) -> Result:
    return _turn(world, place, APERTURE, 1)


def _close(world: World, place: int) -> Result:
    return _turn(world, place, APERTURE, 0)


def _switch_on(world: World, place: int) -> Result:
    return _turn(world, place, POWER, 1)


def _switch_off(world: World, place: int) -> Result:
    return _turn(world, place, POWER, 0)


def _turn(world: World, place: int, pair: int, value: int) -> Result:
    """Opens, closes or switches a place; what has a door runs only behind it."""
    if place >= world.geometry.place_count or not world.prior.has_state[place, pair]:
        return Result.NOT_POSSIBLE
    if not reaches_place(world, place):
        return Result.OUT_OF_REACH
    if world.states[place, pair] == value:
        return Result.ALREADY
    if pair == POWER and value == 1 and world.broken[place]:
        return Result.BROKEN
    if pair == POWER and value == 1 and world.prior.has_door[place] and not is_shut(world, place):
        return Result.OPEN
    name = world.geometry.names[place]
    if pair == APERTURE and value == 0 and name in world.geometry.leaves and not world.is_leaf_clear(name):
        return Result.NO_ROOM
    world.set_state(place, pair, value)
    _work(world, place)
    return Result.OK


def _work(world: World, place: int) -> None:
    """What a closed container does to the things in it: a fridge cools, an oven that is on heats, a washer washes."""
    kind = world.prior.kinds[place]
    if not kind.inside or is_shut(world, place) != world.prior.has_door[place]:
        return
    is_on = world.states[place, POWER] == 1
    for thing in world.at(place):
        if _suits(world, thing, kind.cools):
            _set(world, thing, TEMPERATURE, 0)
        if is_on and _suits(world, thing, kind.heats):
            _set(world, thing, TEMPERATURE, 1)
        if is_on and _suits(world, thing, kind.washes):
            _set(world, thing, CLEANLINESS, 1)


def _fill(world: World, place: int) -> Result:
    if world.held == NOTHING:
        return Result.HAND_EMPTY
    if place >= world.geometry.place_count or not _suits(world, world.held, world.prior.kinds[place].fills):
        return Result.NOT_POSSIBLE
    if not reaches_place(world, place):
        return Result.OUT_OF_REACH
    return Result.BROKEN if world.broken[place] else _set(world, world.held, FILL, 1)


def _empty(world: World, place: int) -> Result:
    """Empties the thing in the hand into a place; where there is nothing to empty in the hand, the place itself."""
    if place >= world.geometry.place_count:
        return Result.NOT_POSSIBLE
    drains_hand = world.held != NOTHING and _suits(world, world.held, world.prior.kinds[place].drains)
    empties_place = bool(world.prior.has_state[place, FILL])
    if not drains_hand and not empties_place:
        return Result.NOT_POSSIBLE if world.held != NOTHING else Result.HAND_EMPTY
    if not reaches_place(world, place):
        return Result.OUT_OF_REACH
    result = _set(world, world.held, FILL, 0) if drains_hand else Result.ALREADY
    return _set(world, place, FILL, 0) if result is not Result.OK and empties_place else result


def _clean(world: World, place: int) -> Result:
    """Cleans the thing in the hand at a place, or wipes the place with it."""
    if world.held == NOTHING:
        return Result.HAND_EMPTY
    if place >= world.geometry.place_count:
        return Result.NOT_POSSIBLE
    rinses = _suits(world, world.held, world.prior.kinds[place].rinses)
    wipes = _suits(world, place, world.prior.kinds[world.held].wipes)
    if not rinses and not wipes:
        return Result.NOT_POSSIBLE
    if not reaches_place(world, place):
        return Result.OUT_OF_REACH
    return _set(world, world.held if rinses else place, CLEANLINESS, 1)


def _hand_over(world: World, person: int) -> Result:
    if not is_person(world, person):
        return Result.NOT_POSSIBLE
    if world.held == NOTHING:
        return Result.HAND_EMPTY
    if not is_near_person(world, person):
        return Result.OUT_OF_REACH
    thing, world.held = world.held, NOTHING
    world.lift(thing, person)
    return Result.OK


def _say(world: World, person: int) -> Result:
    return Result.OK if is_near_person(world, person) else Result.OUT_OF_REACH


def _suits(world: World, row: int, tags: Iterable[str]) -> bool:
    """Whether an entity has one of these tags."""
    own = world.prior.kinds[row].tags
    return any(tag in own for tag in tags)


def _set(world: World, row: int, pair: int, value: int) -> Result:
    """Brings a state about, where the entity has such a state."""
    if not world.prior.has_state[row, pair]:
        return Result.NOT_POSSIBLE
    if world.states[row, pair] == value:
        return Result.ALREADY
    world.set_state(row, pair, value)
    return Result.OK


_ACTS: dict[Interaction, Callable[[World, int], Result]] = {
    Interaction.PICK: _pick,
    Interaction.PLACE: _place,
    Interaction.OPEN: _open,
    Interaction.CLOSE: _close,
    Interaction.SWITCH_ON: _switch_on,
    Interaction.SWITCH_OFF: _switch_off,
    Interaction.FILL: _fill,
    Interaction.EMPTY: _empty,
    Interaction.CLEAN: _clean,
    Interaction.HAND_OVER: _hand_over,
    Interaction.SAY: _say,
}
_ACT_OF = tuple(_ACTS.get(interaction) for interaction in Interaction)
"""The same by number, for hashing an enum is slow, too; None for what is no act of the hands."""
