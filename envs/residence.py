"""The residence: which houses an environment may be in, and how large its spaces must be to hold any of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.envs.geometry import Geometry, Rect


SECONDS = 600.0
"""The time limit in a house that was not generated [s]."""


class Residence:
    """The house of the domain, one from a file (`path`), or any that is generated in a `size`.

    The file is read once, when the residence is made. Raises `InputError` for an unknown size, or for both a path and a
    size, `DataFileError` for a broken file.
    """

    def __init__(self, base: Domain, *, path: str | None = None, size: str | None = None) -> None:
        if path is not None and size is not None:
            raise InputError("house and size exclude each other; give one of them")
        if size is not None:
            from decomplex_bt.envs.houses import SIZES

            if size not in SIZES:
                raise InputError(f"size is {size!r}; expected one of {', '.join(SIZES)}")
        self._base, self._size = base, size
        self._own = base if path is None else self._from_file(path)

    @property
    def is_generated(self) -> bool:
        return self._size is not None

    def domain(self, seed: int | None, *, path: str | None = None) -> Domain:
        """The domain with the house of a seed (None: 0), or the one from a file, in it.

        Raises `InputError` for a seed where houses are not generated.
        """
        if seed is not None and self._size is None:
            raise InputError("house_seed is given, and this environment generates no houses; make it with a size")
        if path is not None:
            return self._from_file(path)
        if self._size is not None:
            from decomplex_bt.envs.houses import generated_domain

            return generated_domain(self._base, self._size, seed or 0)
        return self._own

    def _from_file(self, path: str) -> Domain:
        from decomplex_bt.envs.houses import domain_with_file

        return domain_with_file(self._base, path)

    def extent(self, geometry: Geometry) -> tuple[int, Rect]:
        """Rows of the entity table and bounds [m] that hold every house of this residence."""
        if self._size is None:
            return len(geometry.names), geometry.bounds
        from decomplex_bt.envs.houses import SIZES

        size = SIZES[self._size]
        return size.rows, (0.0, 0.0, size.bounds, size.bounds)

    @property
    def seconds(self) -> float:
        """The simulated time that an episode in such a house takes at most, if nothing else is said [s]."""
        if self._size is None:
            return SECONDS
        from decomplex_bt.envs.houses import SIZES

        return SIZES[self._size].seconds

    def check(self, geometry: Geometry, rows: int, bounds: Rect) -> None:
        """Raises `InputError` where a house does not fit into spaces made for others."""
        x0, y0, x1, y1 = geometry.bounds
        if len(geometry.names) > rows or x0 < bounds[0] or y0 < bounds[1] or x1 > bounds[2] or y1 > bounds[3]:
            raise InputError(
                f"the house has {len(geometry.names)} entities within ({x0:g}, {y0:g}, {x1:g}, {y1:g}), and this "
                f"environment's spaces are made for {rows} within {bounds}; make an environment with this house"
            )
