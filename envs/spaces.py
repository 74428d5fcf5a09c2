"""The spaces of the household: what observations and actions are made of, and reading an action."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from math import isfinite, pi
from operator import index
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from decomplex_bt.envs.config import MAX_SPEED, MAX_TURN_RATE
from decomplex_bt.envs.geometry import Rect
from decomplex_bt.envs.interface import COLUMNS, STATE_PAIRS, Interaction, Result
from decomplex_bt.envs.options import MAX_CHARACTERS
from decomplex_bt.envs.sensing import HEADING, INSPECTED, PLACE, VISIBLE, X, Y
from decomplex_bt.errors import InputError

CHARSET = "".join(chr(code) for code in (*range(32, 127), *range(160, 256)))
"""What the observed instruction is made of: printable ASCII and Latin-1."""
MAX_SECONDS = 1e6  # [s]
_CHARACTERS = frozenset(CHARSET)
_INTERACTIONS = tuple(Interaction)
_REAL = "iuf"
"""The kinds of numpy's types that are numbers to drive by."""


def action_space(rows: int) -> spaces.Dict:
    """`drive`, `interact` and `target`: see `HouseholdEnv`. `rows`: of the entity table."""
    return spaces.Dict(
        {
            "drive": spaces.Box(-1.0, 1.0, (2,), np.float32),
            "interact": spaces.Discrete(len(Interaction)),
            "target": spaces.Discrete(rows),
        }
    )


def observation_space(rows: int, bounds: Rect, tray_slots: int) -> spaces.Dict:
    """All that is observed, within finite bounds: see `HouseholdEnv`. `bounds` [m]: of where the robot may be."""
    x0, y0, x1, y1 = bounds
    fastest = (MAX_SPEED, MAX_TURN_RATE)
    low, high = np.array((x0, y0, -pi, -fastest[0], -fastest[1])), np.array((x1, y1, pi, *fastest))
    least, most = np.full((rows, len(COLUMNS)), -1.0), np.ones((rows, len(COLUMNS)))
    least[:, [VISIBLE, INSPECTED]] = 0
    least[:, X], least[:, Y], least[:, HEADING] = min(x0, 0), min(y0, 0), -pi
    most[:, X], most[:, Y], most[:, HEADING], most[:, PLACE] = max(x1, 0), max(y1, 0), pi, rows - 1
    assert len(STATE_PAIRS) == len(COLUMNS) - 6
    return spaces.Dict(
        {
            "instruction": spaces.Text(MAX_CHARACTERS, min_length=0, charset=CHARSET),
            "instruction_codes": spaces.Box(0, 255, (MAX_CHARACTERS,), np.uint8),
            "robot": spaces.Box(low.astype(np.float32), high.astype(np.float32)),
            "held": spaces.Box(-1, rows - 1, (1 + tray_slots,), np.int16),
            "entities": spaces.Box(least.astype(np.float32), most.astype(np.float32)),
            "result": spaces.Discrete(len(Result)),
            "seconds": spaces.Box(0.0, MAX_SECONDS, (1,), np.float32),
        }
    )


def read_action(action: Mapping[str, Any], rows: int) -> tuple[float, float, Interaction, int]:
    """Forward and turning speed in [-1, 1] (clipped), interaction and target. Raises `InputError` for no action."""
    try:
        drive = action["drive"]
        interact, target = index(action["interact"]), index(action["target"])
        if type(drive) is not np.ndarray:
            drive = np.asarray(drive)
        if drive.dtype.kind in _REAL and interact >= 0 and 0 <= target < rows:
            forward, turn = drive.tolist()  # of another shape than (2,) these are no two numbers
            interaction = _INTERACTIONS[interact]
            if -1.0 <= forward <= 1.0 and -1.0 <= turn <= 1.0:
                return forward, turn, interaction, target
            if isfinite(forward) and isfinite(turn):
                return min(max(forward, -1.0), 1.0), min(max(turn, -1.0), 1.0), interaction, target
    except (KeyError, IndexError, TypeError, ValueError):
        pass  # it is none, whatever it is instead
    raise InputError(
        f"no action: {action!r}; expected a mapping of drive (two finite numbers), interact (a whole number from 0 "
        f"to {len(_INTERACTIONS) - 1}) and target (a whole number from 0 to {rows - 1})"
    )


@lru_cache(maxsize=64)
def shown(text: str) -> str:
    """The text as it is observed: what is neither printable ASCII nor Latin-1 as "?"."""
    return "".join(character if character in _CHARACTERS else "?" for character in text)


@lru_cache(maxsize=64)
def encode(text: str) -> NDArray[np.uint8]:
    """The observed text's code points, `(2000,)`, 0 after its end; not to be changed, for it is kept."""
    codes = np.zeros(MAX_CHARACTERS, dtype=np.uint8)
    codes[: len(text)] = [ord(character) for character in shown(text)]
    codes.flags.writeable = False
    return codes
