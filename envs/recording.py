"""A recording: how an episode began and what was done since, enough to do all of it again exactly."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import asdict
from functools import lru_cache
from typing import TYPE_CHECKING, Any
from zlib import crc32

import numpy as np
from numpy.random import MT19937, PCG64, PCG64DXSM, SFC64, Generator, Philox
from numpy.typing import NDArray
from pydantic import ValidationError

from decomplex_bt.domain.document import Record
from decomplex_bt.domain.loader import Domain
from decomplex_bt.envs.options import Options, Request, read_request
from decomplex_bt.envs.values import plain
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.envs.chance import Start
    from decomplex_bt.envs.config import HouseholdConfig
    from decomplex_bt.envs.geometry import Floats
    from decomplex_bt.envs.interface import Interaction
    from decomplex_bt.envs.world import World

FORMAT = 3
BIT_GENERATORS = {kind.__name__: kind for kind in (MT19937, PCG64, PCG64DXSM, Philox, SFC64)}
"""Numpy's: Gymnasium seeds a PCG64, and an environment's `np_random` may be set to a generator of any of them."""
CHECK_EVERY = 50
"""Steps between two checksums; the start and the last step have one, too."""


class Recording:
    """One running episode's recording: `begin` it with its world and how that began, `note` every step."""

    def __init__(self, generator: Mapping[str, Any], request: Request, options: Options) -> None:
        self.generator, self.request, self.options = generator, request, options
        self.actions: list[tuple[float, float, Interaction, int]] = []

    def begin(self, world: World, start: Start) -> None:
        self._world, self._start = world, start
        self._checksums: list[int] = []

    def note(self, forward: float, turn: float, interaction: Interaction, target: int) -> None:
        actions = self.actions
        actions.append((forward, turn, interaction, target))
        if not len(actions) % CHECK_EVERY:
            self._checksums.append(checksum(self._world))

    @property
    def checksums(self) -> list[int]:
        """Those of the start, of every fiftieth step and of the last."""
        start = self._start
        checksums = [_checksum(start.place, start.position, start.heading, start.states), *self._checksums]
        return [*checksums, checksum(self._world)] if len(self.actions) % CHECK_EVERY else checksums

    def to_dict(self) -> dict[str, Any]:
        """What was asked and done, as plain values, which JSON keeps."""
        gold = self.request.gold
        return {
            "generator": plain(self.generator),
            "instruction": self.request.text,
            "gold": None if gold is None else asdict(gold),
            "options": self.options.given(),
            "actions": [[forward, turn, int(deed), target] for forward, turn, deed, target in self.actions],
            "checksums": self.checksums,
        }


def circumstances(domain: Domain, house: tuple[str | None, int | None], config: HouseholdConfig) -> dict[str, Any]:
    """In what an episode is recorded, as plain values; only in the same it can be replayed."""
    path, seed = house
    return {
        "config": asdict(config),
        "domain": _domain_checksum(domain),
        "house": {"path": path, "seed": seed, "name": domain.house.name, "checksum": _house_checksum(domain)},
    }


class _House(Record):
    path: str | None
    seed: int | None
    name: str
    checksum: int


class Recorded(Record):
    """A recording that is read back from its plain values."""

    config: dict[str, Any]
    domain: int
    house: _House
    generator: dict[str, Any]
    instruction: str
    gold: dict[str, Any] | None
    options: dict[str, Any]
    actions: list[tuple[float, float, int, int]]
    checksums: list[int]

    @classmethod
    def read(cls, state: Any) -> Recorded:
        """Raises `InputError` for what is no recording, naming the key."""
        if not isinstance(state, Mapping) or "format" not in state:
            raise InputError(f"no recording: {_short(state)}; expected what state_dict() gives")
        if state["format"] != FORMAT:
            raise InputError(f"the recording has format {state['format']!r}; this version reads format {FORMAT}")
        try:
            recorded = cls.model_validate({key: value for key, value in state.items() if key != "format"})
        except ValidationError as error:
            first = error.errors()[0]
            key = ".".join(str(part) for part in first["loc"])
            got = "" if first["type"] == "missing" else f" (got {_short(first['input'])})"
            raise InputError(f"no recording: {key}: {first['msg']}{got}") from None
        expected = len(list(recorded.checked_steps()))
        if len(recorded.checksums) != expected:
            raise InputError(
                f"no recording: it has {len(recorded.checksums)} checksums; expected {expected} for "
                f"{len(recorded.actions)} actions"
            )
        return recorded

    @property
    def request(self) -> Request:
        request = read_request(self.instruction, self.gold)
        assert request is not None
        return request

    def checked_steps(self) -> Iterator[int]:
        """The steps whose checksums there are; 0 is the start."""
        yield from range(0, len(self.actions) + 1, CHECK_EVERY)
        if len(self.actions) % CHECK_EVERY:
            yield len(self.actions)

    def begin_random(self) -> Generator:
        """The environment's generator as it was before the episode. Raises `InputError`."""
        try:
            numbers: Any = BIT_GENERATORS[self.generator["bit_generator"]]()
            numbers.state = self.generator
        except (LookupError, TypeError, ValueError, OverflowError) as error:
            kinds = ", ".join(BIT_GENERATORS)
            raise InputError(f"no recording: generator: {error!r}; expected the state of one of {kinds}") from None
        return Generator(numbers)

    def check_circumstances(self, domain: Domain, config: HouseholdConfig) -> None:
        """Raises `InputError` naming what is another configuration, domain or house than that of the recording."""
        mine, theirs = _flat(asdict(config)), _flat(self.config)
        for key in mine.keys() | theirs.keys():
            if mine.get(key) != theirs.get(key):
                raise InputError(
                    f"the recording was made with config.{key} {theirs.get(key)!r}, and this environment has "
                    f"{mine.get(key)!r}"
                )
        if self.domain != _domain_checksum(domain):
            raise InputError(f"the recording was made in a domain that differs from {domain.folder} of now")
        if self.house.checksum != _house_checksum(domain):
            raise InputError(
                f"the recording was made in another house, {self.house.name!r}, than {domain.house.name!r} of now"
            )

    def check(self, replay: Recording) -> None:
        """Raises `InputError` naming the step by which a replay departs from the recording."""
        for step, mine, theirs in zip(self.checked_steps(), replay.checksums, self.checksums, strict=False):
            if mine != theirs:
                raise InputError(
                    f"the replay departs from the recording by step {step}; it was recorded with another version"
                )
        if len(replay.actions) != len(self.actions):
            raise InputError(f"the replay is over at step {len(replay.actions)}; the recording goes on")


def checksum(world: World) -> int:
    """A number that stands for all positions and states; equal worlds have equal ones."""
    return _checksum(world.place, world.position, world.robot_heading, world.states)


def _checksum(place: NDArray[np.int64], position: Floats, heading: float, states: NDArray[np.int8]) -> int:
    numbers = np.append(position, heading)
    numbers[np.isnan(numbers)] = 0.0
    return crc32(place.tobytes(), crc32(states.tobytes(), crc32(numbers.tobytes())))


@lru_cache(maxsize=16)
def _domain_checksum(domain: Domain) -> int:
    records = (domain.ontology, domain.kinds, domain.lexicon, domain.goals)
    return crc32("\n".join([*(record.model_dump_json() for record in records), domain.domain_pddl]).encode())


@lru_cache(maxsize=16)
def _house_checksum(domain: Domain) -> int:
    return crc32(domain.house.model_dump_json().encode())


def _flat(config: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """A nested mapping by dotted keys."""
    flat: dict[str, Any] = {}
    for key, value in config.items():
        flat |= _flat(value, f"{prefix}{key}.") if isinstance(value, Mapping) else {f"{prefix}{key}": value}
    return flat


def _short(value: Any) -> str:
    words = repr(value)
    return words if len(words) <= 60 else words[:57] + "..."
