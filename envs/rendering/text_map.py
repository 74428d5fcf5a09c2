"""The house as a text map for a terminal: rooms, furniture by its first letters, things, people and the robot."""

from __future__ import annotations

import math
from collections.abc import Callable

from decomplex_bt.envs.geometry import Geometry, Segment
from decomplex_bt.envs.rendering.scene import Scene

CELL = (0.25, 0.5)
"""[m] Width and height of a character's cell; letters are twice as high as wide."""
ARROWS = "→↗↑↖←↙↓↘"


def text_map(geometry: Geometry, scene: Scene, *, has_caption: bool = True) -> str:
    """The scene as lines of text, north up: the robot an arrow, people "@", things "*", walls "█", closed doors "▒"."""
    x0, y0, x1, y1 = geometry.bounds
    columns, rows = math.ceil((x1 - x0) / CELL[0]) + 1, math.ceil((y1 - y0) / CELL[1]) + 1
    grid = [[" "] * columns for _ in range(rows)]

    def put(x: float, y: float, sign: str) -> None:
        column, row = round((x - x0) / CELL[0]), round((y1 - y) / CELL[1])
        for offset, letter in enumerate(sign):
            if 0 <= row < rows and 0 <= column + offset < columns:
                grid[row][column + offset] = letter

    for name, room in geometry.house.rooms.items():
        left, bottom, right, top = room.rect
        put((left + right) / 2 - len(name) * CELL[0] / 2, (bottom + top) / 2, name.replace("_", " ").upper())
    for name, piece in geometry.house.furniture.items():
        if piece.part_of is None and geometry.house.kind(name, geometry.kinds).category == "furniture":
            width = max(2, round(piece.size[0] / CELL[0]))
            put(piece.centre[0] - width * CELL[0] / 2, piece.centre[1], piece.kind[:width])
    for pose in scene.things.values():
        put(pose.x, pose.y, "*")
    for wall in geometry.walls:
        _draw_line(put, wall, "█")
    for name, leaf in geometry.leaves.items():
        _draw_line(put, leaf, "▒" if scene.states.get((name, "aperture")) == "closed" else "·")
    for name, pose in scene.people.items():
        put(pose.x, pose.y, "@" + name[:1])
    robot = scene.robot
    put(robot.x, robot.y, ARROWS[round(robot.heading / (math.pi / 4)) % 8])
    lines = ["".join(row).rstrip() for row in grid]
    return "\n".join([*lines, *_caption(scene)] if has_caption else lines)


def _caption(scene: Scene) -> list[str]:
    carried = [thing for thing in (scene.held, *scene.tray) if thing is not None]
    parts = [
        f"{scene.seconds:.1f} s",
        scene.verdict or scene.doing,
        f"carrying {', '.join(carried)}" if carried else "",
    ]
    return [line for line in (scene.instruction, " · ".join(part for part in parts if part)) if line]


def _draw_line(put: Callable[[float, float, str], None], line: Segment, sign: str) -> None:
    ax, ay, bx, by = line
    count = max(1, math.ceil(max(abs(bx - ax) / CELL[0], abs(by - ay) / CELL[1]) * 2))
    for step in range(count + 1):
        put(ax + (bx - ax) * step / count, ay + (by - ay) * step / count, sign)
