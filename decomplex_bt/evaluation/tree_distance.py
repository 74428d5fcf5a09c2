"""Edit distance between ordered trees: the fewest insertions, deletions and substitutions of nodes.

Zhang and Shasha (1989), as the plain recursion over forests with a memory: quick enough for trees of a few dozen nodes.
The packages that offer it have had no release since 2018.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tree:
    """A node with its children in order."""

    label: Hashable
    children: tuple[Tree, ...] = ()

    @property
    def size(self) -> int:
        return 1 + forest_size(self.children)


Forest = tuple[Tree, ...]


def forest_size(forest: Forest) -> int:
    """The number of nodes."""
    return sum(tree.size for tree in forest)


def edit_distance(first: Forest, second: Forest) -> int:
    """The fewest edits of one node each that turn one forest into the other; a deleted node leaves its children."""
    known: dict[tuple[Forest, Forest], int] = {}

    def distance(one: Forest, other: Forest) -> int:
        if not one or not other:
            return forest_size(one) + forest_size(other)
        key = (one, other)
        if key not in known:
            (*rest, last), (*other_rest, other_last) = one, other
            known[key] = min(
                distance((*rest, *last.children), other) + 1,
                distance(one, (*other_rest, *other_last.children)) + 1,
                distance(last.children, other_last.children)
                + distance(tuple(rest), tuple(other_rest))
                + (last.label != other_last.label),
            )
        return known[key]

    return distance(first, second)
