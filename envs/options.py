"""Reset options: what a caller may want of an episode, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from decomplex_bt.corpus import Example
from decomplex_bt.domain.kinds import STATE_VALUES
from decomplex_bt.domain.nouns import Nouns
from decomplex_bt.envs.chance import POWER, Draw
from decomplex_bt.envs.config import REWARDS
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.envs.values import choice, flag, known, number, several, whole
from decomplex_bt.errors import InputError, among
from decomplex_bt.instruction import Instruction, check_instruction

MAX_CHARACTERS = 2000
"""The longest instruction, in code points."""


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be done: `text`, with the gold reading that the judge goes by, where there is one."""

    text: str
    gold: Instruction | None = None


@dataclass(frozen=True, slots=True)
class Options:
    """The checked options of one reset; None: as the environment has it.

    `placement`: thing to place, None for nowhere in the house. `states`: entity to the values it is to have. `broken`:
    exactly these devices are broken. `people`: person to room, None for out. `noise`: False switches slips and misses
    off. `grasp_slip`, `missed_detection` in [0, 1]: how likely a grasp slips, a look misses a thing; they hold whatever
    `noise` says. `meddling`: how often in a minute of simulated time somebody else moves a thing, on average, from 0 to
    60. `chance`: False switches all chance off, noise included: everything is as it is most often, or as the other
    options have it, at the same spots for every seed, and whoever may lead wherever they like goes to the first other
    room. Only a `grasp_slip`, `missed_detection` or `meddling` that is given leaves something to chance, and what is
    drawn where it is not given: the instruction, and which house is generated.
    """

    balance: float | None = None
    placement: Mapping[str, str | None] | None = None
    states: Mapping[str, tuple[str, ...]] | None = None
    broken: tuple[str, ...] | None = None
    people: Mapping[str, str | None] | None = None
    noise: bool = True
    grasp_slip: float | None = None
    missed_detection: float | None = None
    meddling: float = 0.0
    chance: bool = True
    max_seconds: float | None = None
    reward: str | None = None

    def given(self) -> dict[str, Any]:
        """What is given, as plain values that `read_options` reads as the same."""
        plain: dict[str, Any] = {}
        for key in (item.name for item in fields(self)):
            value = getattr(self, key)
            if isinstance(value, Mapping):
                plain[key] = {name: list(of) if isinstance(of, tuple) else of for name, of in value.items()}
            elif value is not None:
                plain[key] = list(value) if isinstance(value, tuple) else value
        return plain


@dataclass(frozen=True, slots=True)
class _Named:
    """Names of the house that an option may hold, and what they are of."""

    names: tuple[str, ...]
    expected: str


THING = "thing of this house"
PLACE = "place of this house (furniture, a door, a floor as 'kitchen_floor')"
PERSON = "person of this house"
ROOM = "room of this house"
DEVICE = "device of this house (what is switched on and off)"
_AS_THEY_ARE = Options()
HOUSE_KEYS = ("house", "house_seed")
"""The keys that are about which house it is; they are read first, since the others name what is in it."""
KEYS = (
    *HOUSE_KEYS,
    "instruction",
    "gold",
    "balance",
    "placement",
    "states",
    "broken",
    "people",
    "noise",
    "grasp_slip",
    "missed_detection",
    "meddling",
    "chance",
    "max_seconds",
    "reward",
)


def read_options(options: Mapping[str, Any] | None, geometry: Geometry) -> Options:
    """The options as a value. Raises `InputError` for an unknown name or value, naming the nearest known."""
    if not options:
        return _AS_THEY_ARE
    given = {key: value for key, value in options.items() if value is not None}
    house = geometry.house
    places = geometry.names[: geometry.place_count]
    read = Options(
        balance=_number(given, "balance", 0.5),
        placement=_names(given, "placement", _Named(tuple(house.things), THING), _Named(places, PLACE), geometry),
        states=_states(given.get("states"), geometry),
        broken=_devices(given.get("broken"), geometry),
        people=_names(given, "people", _Named(tuple(house.people), PERSON), _Named(tuple(house.rooms), ROOM), geometry),
        noise=flag("noise", given.get("noise", True)),
        grasp_slip=_number(given, "grasp_slip", 1.0),
        missed_detection=_number(given, "missed_detection", 1.0),
        meddling=number("meddling", given.get("meddling", 0.0), high=60.0),
        chance=flag("chance", given.get("chance", True)),
        max_seconds=_number(given, "max_seconds", float("inf")),
        reward=choice("reward", given["reward"], REWARDS) if "reward" in given else None,
    )
    _check_switched(read, geometry)
    return read


def check_keys(options: Mapping[str, Any] | None) -> None:
    """Raises `InputError` for what is no mapping and for an unknown key, naming the nearest known."""
    if options is not None and not isinstance(options, Mapping):
        raise InputError(f"options is {options!r}; expected a mapping of {', '.join(KEYS)}")
    for key in options or {}:
        if key not in KEYS:
            raise InputError(f"unknown reset option {key!r}{among(key, KEYS)}; `Options` says what each is")


def with_instruction(options: dict[str, Any] | None, instruction: Any) -> dict[str, Any] | None:
    """The options with an instruction that was given beside them. Raises `InputError` where they have another one."""
    if instruction is None:
        return options
    told = read_request((options or {}).get("instruction"))
    if told is not None and told != read_request(instruction):
        raise InputError(f"two instructions are given, one of them as an option: {told.text!r}; give one")
    return {**(options or {}), "instruction": instruction}


def read_house(options: Mapping[str, Any] | None) -> tuple[str | None, int | None]:
    """The file (which stays that one, whatever the working directory) and the seed of the house that is asked for, None
    for what is not. Raises `InputError`."""
    given = options or {}
    path, seed = given.get("house"), given.get("house_seed")
    if path is not None and not isinstance(path, str | Path):
        raise InputError(f"house is {path!r}; expected the path of a house file")
    if seed is not None:
        seed = whole("house_seed", seed)
    if path is not None and seed is not None:
        raise InputError("house and house_seed exclude each other; give one of them")
    return None if path is None else str(Path(path).absolute()), seed


def read_request(instruction: Any, gold: Any = None) -> Request | None:
    """What is to be done: a text, an annotated `Instruction` or a corpus `Example`; `gold` gives a text its reading.

    None for no instruction. Raises `InputError`.
    """
    if isinstance(instruction, Request):
        return instruction
    reading = _reading("gold", gold)
    if instruction is None:
        return None if reading is None else Request(check_text(reading.text), reading)
    if not isinstance(instruction, str):
        annotated = _reading("instruction", instruction)
        assert annotated is not None
        return Request(check_text(annotated.text), reading or annotated)
    return Request(check_text(instruction), reading)


def asked_by(options: Mapping[str, Any] | None, before: Request | None) -> tuple[Request | None, Request | None]:
    """What is to be done from a reset with these options on, where it was `before` until then, and what in its episode;
    None: what is drawn.

    An instruction stays, with the gold reading that is given beside it; one of None is no missing one: it undoes the
    one there was. A gold reading alone is of the episode, as of what is to be done, or of its own text where nothing
    is. Raises `InputError`.
    """
    given = options or {}
    instruction, gold = given.get("instruction"), given.get("gold")
    if instruction is not None:
        before = read_request(instruction, gold)
        return before, before
    if "instruction" in given:
        before = None
    return before, before if gold is None else read_request(None if before is None else before.text, gold)


def check_text(text: str) -> str:
    """The text, if it is one to be understood. Raises `InputError`."""
    if not text.strip():
        raise InputError("the instruction is empty; say what is to be done")
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"the instruction has {len(text)} characters; at most {MAX_CHARACTERS} are understood")
    return str(text)  # numpy's texts are not taken by all who read them


def apply_options(options: Options, draw: Draw, rng: Any) -> None:
    """Makes the start as the options want it; what they do not name stays as drawn. Raises `InputError`."""
    row = draw.geometry.row
    for name, values in (options.states or {}).items():
        for value in values:
            _set_state(draw, row[name], value)
    if options.broken is not None:
        draw.start.broken[:] = False
        for name in options.broken:
            draw.start.broken[row[name]] = True
            draw.start.states[row[name], POWER] = 0
    for name, room in (options.people or {}).items():
        if name == draw.geometry.house.user and room is None:
            raise InputError(f"people: {name} is the user, who is always at home; name a room")
        draw.stand(row[name], None if room is None else draw.geometry.room_index[room], rng)
    for name, place in (options.placement or {}).items():
        at = ABSENT if place is None else row[place]
        if at != ABSENT and not draw.prior.holds[at]:
            raise InputError(
                f"placement.{name}: nothing can lie on or in {place}; name a surface, a container or a floor"
            )
        if not draw.lay(row[name], at, rng):
            raise InputError(
                f"placement.{name}: there is no room left at {place}; name another place, or put less there"
            )


def _set_state(draw: Draw, row: int, value: str) -> None:
    kinds = draw.geometry.kinds
    pair = kinds.pair_of(value)
    column = STATE_PAIRS.index(pair)
    name = draw.geometry.names[row]
    if not draw.prior.has_state[row, column]:
        can = [state for p in draw.prior.kinds[row].states for state in kinds.state_pairs[p].values]
        raise InputError(f"states: {name} cannot be {value}; it can be {', '.join(can) if can else 'in no state'}")
    draw.start.states[row, column] = int(kinds.state_pairs[pair].values[0] == value)
    if column == POWER and draw.start.states[row, POWER]:
        draw.start.broken[row] = False


def _reading(key: str, value: Any) -> Instruction | None:
    if value is None:
        return None
    if isinstance(value, Instruction):
        return check_instruction(value)
    if isinstance(value, Example):
        return check_instruction(value.instruction)
    if isinstance(value, Mapping):
        return check_instruction(_from_mapping(key, value))
    text = "a text, " if key == "instruction" else ""
    raise InputError(f"{key} is a {type(value).__name__}; expected {text}an Instruction or a corpus Example")


def _from_mapping(key: str, value: Mapping[str, Any]) -> Instruction:
    """An instruction of what `dataclasses.asdict` makes of one (or of an example), as specs and recordings keep it."""
    try:
        return TypeAdapter(Instruction).validate_python(value.get("instruction", value))
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join([key, *(str(part) for part in first["loc"])])
        raise InputError(f"{where}: {first['msg']}; expected the fields of an Instruction") from None


def _names(
    given: Mapping[str, Any], key: str, names: _Named, values: _Named, geometry: Geometry
) -> dict[str, str | None] | None:
    if key not in given:
        return None
    if not isinstance(given[key], Mapping):
        raise InputError(f"{key} is {given[key]!r}; expected a mapping of names")
    return {
        _known(key, name, names, geometry): None if value is None else _known(f"{key}.{name}", value, values, geometry)
        for name, value in given[key].items()
    }


def _known(key: str, value: Any, named: _Named, geometry: Geometry) -> str:
    def aliases(word: str) -> tuple[str, ...]:
        one, several = Nouns.of(geometry.house, geometry.kinds).lookup(word.lower())
        return (*one, *several)

    listed_by = "" if named.expected == ROOM else "`env.unwrapped.entities`"  # of rooms it has the floors
    return known(key, value, named.names, named.expected, aliases, listed_by=listed_by)


def _states(wanted: Any, geometry: Geometry) -> dict[str, tuple[str, ...]] | None:
    if wanted is None:
        return None
    if not isinstance(wanted, Mapping):
        raise InputError(f"states is {wanted!r}; expected a mapping of an entity to a state or several")
    pairs = geometry.kinds.state_pairs.values()
    all_states = tuple(value for pair in pairs for value in pair.values)
    names = _Named(geometry.names[: geometry.thing_rows.stop], "place or thing of this house")
    states: dict[str, tuple[str, ...]] = {}
    for name, value in wanted.items():
        key = f"states.{name}"
        values = (value,) if isinstance(value, str) else several(key, value, "a state or a list of them")
        chosen = tuple(known(key, state, all_states, "state") for state in values)
        states[_known("states", name, names, geometry)] = chosen
        for pair in pairs:
            if set(pair.values) <= set(chosen):
                raise InputError(f"states: {name} cannot be both {' and '.join(pair.values)}; give one of them")
    return states


def _devices(wanted: Any, geometry: Geometry) -> tuple[str, ...] | None:
    if wanted is None:
        return None
    devices = tuple(
        name for name in geometry.names[: geometry.place_count] if geometry.house.kind(name, geometry.kinds).is_device
    )
    named = _Named(devices, DEVICE)
    return tuple(_known("broken", name, named, geometry) for name in several("broken", wanted, "a list of devices"))


def _check_switched(options: Options, geometry: Geometry) -> None:
    """Raises `InputError` for a device that is to be broken and on."""
    on, _ = STATE_VALUES["power"]
    for name in options.broken or ():
        if on in (options.states or {}).get(name, ()):
            raise InputError(f"{name} cannot be broken and {on}: what is broken stays off; give one of them")


def _number(given: Mapping[str, Any], key: str, high: float) -> float | None:
    return number(key, given[key], high=high) if key in given else None
