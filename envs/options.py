"""Reset options: what a caller may want of an episode, checked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter, ValidationError

from decomplex_bt.corpus import Example
from decomplex_bt.envs.chance import APERTURE, POWER, Draw
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.interface import STATE_PAIRS
from decomplex_bt.envs.prior import ABSENT
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Instruction

MAX_CHARACTERS = 2000
"""The longest instruction, in code points."""
REWARDS = ("success", "progress")


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
    60. `chance`: False switches all chance off that is not noise: everything is as it is most often.
    """

    request: Request | None = None
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
        """All but the request, as plain values that `read_options` reads as the same."""
        plain: dict[str, Any] = {}
        for key in (item.name for item in fields(self) if item.name != "request"):
            value = getattr(self, key)
            if isinstance(value, Mapping):
                plain[key] = {name: list(of) if isinstance(of, tuple) else of for name, of in value.items()}
            elif value is not None:
                plain[key] = list(value) if isinstance(value, tuple) else value
        return plain


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
        return Options()
    given = dict(options)
    house = geometry.house
    places = geometry.names[: geometry.place_count]
    return Options(
        request=read_request(given.get("instruction"), given.get("gold")),
        balance=_number(given, "balance", 0.0, 0.5),
        placement=_names(given, "placement", tuple(house.things), places),
        states=_states(given.get("states"), geometry),
        broken=_devices(given.get("broken"), geometry),
        people=_names(given, "people", tuple(house.people), tuple(house.rooms)),
        noise=_flag(given, "noise"),
        grasp_slip=_number(given, "grasp_slip", 0.0, 1.0),
        missed_detection=_number(given, "missed_detection", 0.0, 1.0),
        meddling=_number(given, "meddling", 0.0, 60.0) or 0.0,
        chance=_flag(given, "chance"),
        max_seconds=_number(given, "max_seconds", 0.0, float("inf")),
        reward=_one_of(given, "reward", REWARDS),
    )


def check_keys(options: Mapping[str, Any] | None) -> None:
    """Raises `InputError` for an unknown key, naming the nearest known."""
    for key in options or {}:
        if key not in KEYS:
            raise InputError(f"unknown reset option {key!r}{_nearest(str(key), KEYS)}; known: {', '.join(KEYS)}")


def read_house(options: Mapping[str, Any] | None) -> tuple[str | None, int | None]:
    """The file and the seed of the house that is asked for, None for what is not. Raises `InputError`."""
    given = options or {}
    path, seed = given.get("house"), given.get("house_seed")
    if path is not None and not isinstance(path, str | Path):
        raise InputError(f"house is {path!r}; expected the path of a house file")
    if seed is not None and (isinstance(seed, bool) or not isinstance(seed, int | np.integer) or seed < 0):
        raise InputError(f"house_seed is {seed!r}; expected a whole number from 0")
    if path is not None and seed is not None:
        raise InputError("house and house_seed exclude each other; give one of them")
    return None if path is None else str(path), None if seed is None else int(seed)


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


def check_text(text: str) -> str:
    """The text, if it is one to be understood. Raises `InputError`."""
    if not text.strip():
        raise InputError("the instruction is empty; say what is to be done")
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"the instruction has {len(text)} characters; at most {MAX_CHARACTERS} are understood")
    return text


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
            raise InputError(f"placement: nothing can lie on or in {place}")
        if not draw.lay(row[name], at, rng):
            raise InputError(f"placement: there is no room left for {name} at {place}")


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
    assert column != APERTURE or row < draw.geometry.place_count


def _reading(key: str, value: Any) -> Instruction | None:
    if value is None or isinstance(value, Instruction):
        return value
    if isinstance(value, Example):
        return value.instruction
    if isinstance(value, Mapping):
        return _from_mapping(key, value)
    raise InputError(f"{key} is a {type(value).__name__}; expected an Instruction or a corpus Example")


def _from_mapping(key: str, value: Mapping[str, Any]) -> Instruction:
    """An instruction of what `dataclasses.asdict` makes of one (or of an example), as specs and recordings keep it."""
    try:
        return TypeAdapter(Instruction).validate_python(value.get("instruction", value))
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join([key, *(str(part) for part in first["loc"])])
        raise InputError(f"{where}: {first['msg']}; expected the fields of an Instruction") from None


def _names(
    given: Mapping[str, Any], key: str, names: tuple[str, ...], values: tuple[str, ...]
) -> dict[str, str | None] | None:
    wanted = given.get(key)
    if wanted is None:
        return None
    if not isinstance(wanted, Mapping):
        raise InputError(f"{key} is {wanted!r}; expected a mapping of names")
    for name, value in wanted.items():
        _known(key, name, names)
        if value is not None:
            _known(f"{key}.{name}", value, values)
    return dict(wanted)


def _states(wanted: Any, geometry: Geometry) -> dict[str, tuple[str, ...]] | None:
    if wanted is None:
        return None
    if not isinstance(wanted, Mapping):
        raise InputError(f"states is {wanted!r}; expected a mapping of an entity to a state or several")
    known = tuple(value for pair in geometry.kinds.state_pairs.values() for value in pair.values)
    states: dict[str, tuple[str, ...]] = {}
    for name, value in wanted.items():
        _known("states", name, geometry.names)
        if not isinstance(value, Iterable):
            raise InputError(f"states.{name} is {value!r}; expected a state or a list of them")
        states[name] = (value,) if isinstance(value, str) else tuple(value)
        for state in states[name]:
            _known(f"states.{name}", state, known)
    return states


def _devices(wanted: Any, geometry: Geometry) -> tuple[str, ...] | None:
    if wanted is None:
        return None
    if isinstance(wanted, str) or not isinstance(wanted, Iterable):
        raise InputError(f"broken is {wanted!r}; expected a list of devices")
    wanted = tuple(wanted)
    devices = tuple(
        name for name in geometry.names[: geometry.place_count] if geometry.house.kind(name, geometry.kinds).is_device
    )
    for name in wanted:
        _known("broken", name, devices)
    return wanted


def _number(given: Mapping[str, Any], key: str, low: float, high: float) -> float | None:
    value = given.get(key)
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise InputError(f"{key} is {value!r}; expected a number from {low:g} to {high:g}")
    return float(value)


def _flag(given: Mapping[str, Any], key: str) -> bool:
    value = given.get(key, True)
    if not isinstance(value, bool):
        raise InputError(f"{key} is {value!r}; expected True or False")
    return value


def _one_of(given: Mapping[str, Any], key: str, choices: tuple[str, ...]) -> str | None:
    value = given.get(key)
    if value is not None and value not in choices:
        raise InputError(f"{key} is {value!r}; expected one of {', '.join(choices)}")
    return value


def _known(key: str, value: Any, choices: tuple[str, ...]) -> None:
    if value not in choices:
        raise InputError(f"{key}: unknown {value!r}{_nearest(str(value), choices)}")


def _nearest(value: str, choices: tuple[str, ...]) -> str:
    near = get_close_matches(value, choices, n=3, cutoff=0.5)
    return f" (the nearest known: {', '.join(near)})" if near else ""
