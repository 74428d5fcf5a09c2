"""The symbols of planning as frozen values whose text is their PDDL."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class Atom:
    """A ground atom: predicate and objects, as in `(lies pen_1 desk)`."""

    predicate: str
    objects: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"({' '.join((self.predicate, *self.objects))})"


@dataclass(frozen=True, slots=True, order=True)
class GroundAction:
    """One step of a plan: a PDDL action's name and its objects, as in `(pick pen_1 desk)`."""

    name: str
    objects: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"({' '.join((self.name, *self.objects))})"
