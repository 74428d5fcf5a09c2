"""The home: the house that an environment is in now, with all that is made once for it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.random import Generator

from decomplex_bt.domain.loader import Domain, is_folder, load_domain
from decomplex_bt.envs.opening import refusal
from decomplex_bt.envs.options import read_house
from decomplex_bt.envs.reach import check_access
from decomplex_bt.envs.residence import Residence
from decomplex_bt.envs.setting import setting_of
from decomplex_bt.envs.skills import check_skills
from decomplex_bt.envs.stage import Stage
from decomplex_bt.errors import InputError, MissingArgumentError

if TYPE_CHECKING:
    from decomplex_bt.envs.options import Request

HOUSE_TRIES = 50
"""Houses drawn before none is found in which the instruction can be asked for."""


class Home:
    """A house of those that the arguments of an environment allow.

    `domain`, `setting` and `stage` are those of the house of now; `rows` (of the entity table) and `bounds` [m] hold
    every house there may be, `seconds` is the time limit that one takes. `seed`: of the houses to come, None where each
    is drawn. `house`: path or seed of the house of now, as it was chosen last. Raises `InputError` for arguments that
    name no house, `DataFileError` where a file of the domain or the house is broken.
    """

    def __init__(
        self, domain: str | Path | Domain, *, house: str | Path | None, size: str | None, house_seed: int | None
    ) -> None:
        path, self.seed = read_house({"house": house, "house_seed": house_seed})
        self._own_seed = self.seed
        self.base = domain if isinstance(domain, Domain) else load_domain(domain)
        check_skills(self.base)
        self.house: tuple[str | None, int | None] = path, self.seed
        if not isinstance(domain, Domain) and is_folder(
            domain
        ):  # a shipped one is in order, as a test knows: no first episode waits for this
            check_access(self.base, self.base.folder / "house.yaml")
        self._residence = Residence(self.base, path=path, size=size)
        self._settle(self._residence.domain(self.seed))
        self.rows, self.bounds = self._residence.extent(self.setting.geometry)
        self.seconds = self._residence.seconds

    def choose(self, options: Mapping[str, Any] | None, request: Request | None, rng: Generator) -> None:
        """Moves into the house that the options name, or that is due, or that is drawn.

        With a `house_seed` of None it is as the environment was made. A house is drawn until the request, where there
        is one, can be asked for in it. Raises `InputError`.
        """
        path, seed = read_house(options)
        if options and "house_seed" in options and seed is None:
            self.seed = self._own_seed
        seed = self.seed if seed is None else seed
        if path is not None or seed is not None or not self._residence.is_generated:
            self.move((path, seed if path is None else None))
            self.seed = seed
            return
        for _ in range(HOUSE_TRIES):
            self.move((None, int(rng.integers(2**31))))
            error = None if request is None else refusal(request, self.domain)
            if error is None:
                return
            if isinstance(error, MissingArgumentError):
                raise error
        assert request is not None
        none = f"none of {HOUSE_TRIES} houses drawn is one in which {request.text!r} can be asked for"
        raise InputError(f"{none}; in the last one: {error}") from error

    def move(self, house: tuple[str | None, int | None]) -> None:
        """Moves into the house of a path or a seed. Raises `InputError` where it does not fit into `rows`, `bounds`."""
        domain = self._residence.domain(house[1], path=house[0])
        if domain is not self.domain:
            self._residence.check(setting_of(domain).geometry, self.rows, self.bounds)
            self._settle(domain)
        self.house = house

    @property
    def address(self) -> tuple[Any, ...]:
        """Which house it is now and which are to come; given back, all is as it was when it was read."""
        return self.seed, self.house, self.domain, self.setting, self.stage

    @address.setter
    def address(self, address: tuple[Any, ...]) -> None:
        self.seed, self.house, self.domain, self.setting, self.stage = address

    def renew_stage(self) -> None:
        """Makes the next world's stage anew, so that it takes nothing from the world that there is."""
        self.stage = Stage(self.setting.geometry)

    def _settle(self, domain: Domain) -> None:
        self.domain, self.setting = domain, setting_of(domain)
        self.renew_stage()
