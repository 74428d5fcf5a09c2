"""What crosses the border of the environment: interactions, their results, and the layout of observations."""

from __future__ import annotations

from enum import IntEnum

from decomplex_bt.domain.kinds import STATE_VALUES


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
    OPEN = 12


STATE_PAIRS = tuple(STATE_VALUES)
"""State columns of the entity table, in order: 1 the positive value, 0 the negative, -1 not seen or not applicable."""

COLUMNS = ("visible", "x", "y", "heading", "place", "inspected", *STATE_PAIRS)
"""Columns of the entity table.

`visible`: 1 where the entity is seen now. `x`, `y` (m), `heading` (rad): 0 where not known. `place`: the row it lies on
or in, or of who has it, -1 where not known or not applicable. `inspected`: 1 where the whole contents of a place are in
view now. Fixed places and the user always have x and y (the house map and the user's place are known).
"""

ROBOT_FIELDS = ("x", "y", "heading", "speed", "turn_rate")
"""Entries of the observation's "robot": metres, radians in [-pi, pi], m/s forward, rad/s counter-clockwise."""

OBSERVATION_KEYS = ("instruction", "instruction_codes", "robot", "held", "entities", "result", "seconds")
"""Keys of an observation.

`instruction`: str, printable ASCII and Latin-1, anything else as "?". `instruction_codes`: `(2000,)` uint8, its code
points, 0 after its end. `robot`: `(5,)` float32, see `ROBOT_FIELDS`. `held`: `(1 + tray slots,)` int16, the rows of
the things in the gripper (first) and in the tray's slots, -1 where free. `entities`: `(rows, columns)` float32, see
`COLUMNS`. `result`: int, the `Result` of the last action's interaction. `seconds`: `(1,)` float32, simulated time.

Targets of an interaction: PICK, a thing (on a place, on the floor, on the tray, or with a person); PLACE, a place, or
the row of "robot": onto the tray; OPEN, CLOSE, SWITCH_ON (one with a door while that is closed), SWITCH_OFF, a place;
FILL, EMPTY, CLEAN, the place at which it is done with the thing in the hand (EMPTY at a trash can with an empty hand
empties the can; CLEAN at a place that can be wiped, with a rag in the hand, wipes that place); HAND_OVER, a person;
SAY, a person: speaks to them; SAY, a place (the floor of a room stands for the room): asks the nearest person within
1.5 m to lead the way there; SAY, "robot": asks them to lead the way wherever they like. NONE and FINISH have no target
(any row will do).
"""
