"""What crosses the border of the environment: interactions, their results, and the layout of observations."""

from __future__ import annotations

from enum import IntEnum


class Interaction(IntEnum):
    """The `interact` part of an action; `target` names the row it is about."""

    NONE = 0
    PICK = 1
    PLACE = 2
    OPEN = 3
    CLOSE = 4
    SWITCH_ON = 5
    SWITCH_OFF = 6
    FILL = 7
    EMPTY = 8
    CLEAN = 9
    HAND_OVER = 10
    SAY = 11
    FINISH = 12


class Result(IntEnum):
    """What came of the last interaction; all but OK and NONE changed nothing."""

    NONE = 0
    OK = 1
    OUT_OF_REACH = 2
    NOT_POSSIBLE = 3
    HAND_FULL = 4
    HAND_EMPTY = 5
    CLOSED = 6
    NO_ROOM = 7
    BROKEN = 8
    SLIPPED = 9
    ALREADY = 10
    NOT_THERE = 11


STATE_PAIRS = ("power", "aperture", "temperature", "cleanliness", "fill")
"""State columns of the entity table, in order: 1 the positive value, 0 the negative, -1 not seen or not applicable."""

COLUMNS = ("visible", "x", "y", "heading", "place", "inspected", *STATE_PAIRS)
"""Columns of the entity table.

`visible`: 1 where the entity is seen now. `x`, `y` (m), `heading` (rad): 0 where not known. `place`: the row it lies on
or in, or of who has it, -1 where not known or not applicable. `inspected`: 1 where the whole contents of a place are in
view now. Fixed places and the user always have x and y (the house map and the user's place are known).
"""
