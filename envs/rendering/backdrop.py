"""The backdrop: all of a house that never changes, drawn once for a size: floors, walls, furniture, names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from PIL import Image

from decomplex_bt.domain.house import Furniture, Room
from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry, Rect
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.canvas import SUPERSAMPLE, Canvas, Pen, cast_shadow
from decomplex_bt.envs.rendering.furniture import States, draw_furniture, draw_leaf
from decomplex_bt.envs.rendering.lettering import (
    Box,
    Label,
    Placed,
    lettering,
    place_labels,
    printable,
    shared_area,
    text_size,
)
from decomplex_bt.envs.rendering.style import darker

HEADING = {"east": 0.0, "north": math.pi / 2, "west": math.pi, "south": -math.pi / 2}
_FRONT = {"east": (1, 0), "north": (0, -1), "west": (-1, 0), "south": (0, 1)}
SWING = 0.62
"""[m] How far an open leaf or drawer reaches out of its furniture at most."""
_LARGE = 1_600
"""Pixels along a side from which on less supersampling is smooth enough."""


def supersample_for(pixels: int) -> int:
    return SUPERSAMPLE if pixels < _LARGE else 2


def draw_backdrop(geometry: Geometry, scale: float) -> Image.Image:
    """Everything fixed and stateless, without names; the house's bounds with `style.MARGIN` around, y up."""
    x0, y0, x1, y1 = geometry.bounds
    margin = style.MARGIN
    bounds = (x0 - margin, y0 - margin, x1 + margin, y1 + margin)
    canvas = Canvas(bounds, scale, style.PAPER, supersample_for(round((x1 - x0) * scale)))
    house_shape = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    cast_shadow(canvas, [house_shape], offset=0.07, blur=0.09, strength=110)
    pen = canvas.pen()
    for number, room in enumerate(geometry.house.rooms.values()):
        draw_floor(pen, room, number)
    cast_shadow(canvas, [_corners(rect) for rect in geometry.blocks], offset=0.035, blur=0.04, strength=95)
    for name, piece in geometry.house.furniture.items():
        if not geometry.house.kind(name, geometry.kinds).states:
            draw_piece(canvas, geometry, name, {})
        elif piece.part_of is None and geometry.house.kind(name, geometry.kinds).category == "furniture":
            draw_piece(canvas, geometry, name, {})  # a base for what is built into it, until its state is drawn over it
    draw_walls(pen, geometry)
    return canvas.finish()


def draw_piece(canvas: Canvas, geometry: Geometry, name: str, states: States) -> None:
    """One piece of furniture with the states it shows."""
    piece = geometry.house.furniture[name]
    pen, depth, width = _piece_frame(canvas, piece)
    draw_furniture(pen, piece.kind, geometry.kinds.kinds[piece.kind], depth, width, states)


def piece_bounds(geometry: Geometry, name: str) -> Rect:
    """Metres that a piece can take up in a picture, its open leaves included."""
    x0, y0, x1, y1 = (float(value) for value in geometry.footprints[geometry.row[name]])
    kind = geometry.house.kind(name, geometry.kinds)
    reach = 1.05 if kind.category == "fixture" else SWING if kind.has_door else 0.14
    return x0 - reach, y0 - reach, x1 + reach, y1 + reach


def draw_door(canvas: Canvas, geometry: Geometry, name: str, *, is_open: bool) -> None:
    """The leaf in a doorway, swung into the second of its rooms when it is open."""
    ax, ay, bx, by = geometry.openings[name]
    into = geometry.house.rooms[geometry.house.doorways[name].rooms[1]].rect
    heading = math.atan2(by - ay, bx - ax)
    side = (bx - ax) * ((into[1] + into[3]) / 2 - ay) - (by - ay) * ((into[0] + into[2]) / 2 - ax)
    draw_leaf(canvas.pen(ax, ay, heading), math.hypot(bx - ax, by - ay), is_open=is_open, turn=1 if side > 0 else -1)


def door_bounds(geometry: Geometry, name: str) -> Rect:
    ax, ay, bx, by = geometry.openings[name]
    reach = math.hypot(bx - ax, by - ay) + 0.1
    return ax - reach, ay - reach, ax + reach, ay + reach


def names_of(geometry: Geometry, scale: float, to_pixels: Mapping[str, Box]) -> list[Placed]:
    """The lettering of rooms and furniture; `to_pixels`: each room's and piece's rectangle in pixels."""
    size = max(8, round(0.152 * scale))
    obstacles = [to_pixels[name] for name in geometry.house.furniture]
    doors = [_grown(to_pixels[name], 2) for name in geometry.openings]
    labels = [
        _label(geometry, name, to_pixels, round(WALL_RADIUS * scale))
        for name, piece in geometry.house.furniture.items()
        if piece.kind not in ("window", "curtains")
    ]
    pieces = place_labels(labels, [*obstacles, *doors], size, doors)
    taken = [*obstacles, *(label.box for label in pieces)]
    return [*pieces, *(_room_name(geometry, room, to_pixels[room], taken, scale) for room in geometry.house.rooms)]


def _label(geometry: Geometry, name: str, to_pixels: Mapping[str, Box], wall: int) -> Label:
    """The label of one piece; what is built into another stands as if it reached to that one's front edge."""
    piece = geometry.house.furniture[name]
    kind = geometry.kinds.kinds[piece.kind]
    front = _FRONT[piece.sides[0]]
    left, top, right, bottom = to_pixels[name]
    if piece.part_of is not None:
        base = to_pixels[piece.part_of]
        left, right = (base[0] if front[0] < 0 else left), (base[2] if front[0] > 0 else right)
        top, bottom = (base[1] if front[1] < 0 else top), (base[3] if front[1] > 0 else bottom)
    return Label(
        printable(kind.words[0]),
        (left, top, right, bottom),
        _grown(to_pixels[piece.room], -wall),
        front,
        is_beside=kind.surface or kind.inside or piece.part_of is not None,
        is_first=piece.part_of is not None,
    )


def _room_name(geometry: Geometry, room: str, box: Box, taken: Sequence[Box], scale: float) -> Placed:
    """A room's name, near the middle of its rectangle `box` where nothing stands."""
    text = printable(geometry.kinds.kinds[geometry.house.rooms[room].kind].words[0]).upper()
    size = max(9, round(0.215 * scale))
    colour = darker(_floor_colour(geometry.house.rooms[room].kind, 0), 0.48)
    lines = (" ".join(text.replace(" ", "  ")) if len(text) < 9 else text,)
    picture = lettering(lines, size, colour)
    left, top, right, bottom = box

    def crowding(spot: tuple[float, float]) -> float:
        x, y = spot
        half_width, half_height = picture.width / 2 + 4, picture.height / 2 + 4
        around = (x - half_width, y - half_height, x + half_width, y + half_height)
        hidden = sum(shared_area(around, other) for other in taken)
        return hidden * 100 + math.hypot(x - (left + right) / 2, (y - (top + bottom) / 2) * 1.5)

    spots = [
        (left + (right - left) * column / 24, top + (bottom - top) * row / 16)
        for row in range(2, 15)
        for column in range(3, 22)
        if left + picture.width / 2 < left + (right - left) * column / 24 < right - picture.width / 2
    ]
    x, y = min(spots, key=crowding) if spots else ((left + right) / 2, (top + bottom) / 2)
    left, top = round(x - picture.width / 2), round(y - text_size(text, size)[1] / 2)
    return Placed(picture, left, top, lines, size, colour)


def _piece_frame(canvas: Canvas, piece: Furniture) -> tuple[Pen, float, float]:
    """A pen at the piece's centre turned to its front, with its depth and width in that frame."""
    along_x = piece.sides[0] in ("east", "west")
    depth, width = piece.size if along_x else piece.size[::-1]
    return canvas.pen(*piece.centre, HEADING[piece.sides[0]]), depth, width


def draw_floor(pen: Pen, room: Room, number: int) -> None:
    """One room's floor; `number`: of the room in the house."""
    colour = _floor_colour(room.kind, number)
    x0, y0, x1, y1 = room.rect
    pen.box(x0, y0, x1, y1, colour, None)
    for line in _floor_lines(room):
        pen.line(line, darker(colour, 0.045), 1.0, is_round=False)


def _floor_lines(room: Room) -> Iterator[list[tuple[float, float]]]:
    """Tiles where it is wet, boards elsewhere: faint, so that a floor looks like one."""
    x0, y0, x1, y1 = room.rect
    is_tiled = room.kind in ("kitchen", "bathroom")
    step = 0.5 if is_tiled else 0.3
    for row in range(1, math.ceil((y1 - y0) / step)):
        yield [(x0, y0 + row * step), (x1, y0 + row * step)]
    if is_tiled:
        for column in range(1, math.ceil((x1 - x0) / step)):
            yield [(x0 + column * step, y0), (x0 + column * step, y1)]
        return
    for row in range(math.ceil((y1 - y0) / step)):
        low, high = y0 + row * step, min(y1, y0 + (row + 1) * step)
        for joint in range(1, math.ceil((x1 - x0) / 1.8) + 1):
            x = x0 + joint * 1.8 - (row * 0.7) % 1.8
            if x0 < x < x1:
                yield [(x, low), (x, high)]


def _floor_colour(kind: str, number: int) -> style.Colour:
    return style.ROOMS.get(kind, style.OTHER_ROOMS[number % len(style.OTHER_ROOMS)])


def draw_walls(pen: Pen, geometry: Geometry) -> None:
    """All walls, their ends squared."""
    half = WALL_RADIUS
    for ax, ay, bx, by in geometry.walls:
        pen.box(min(ax, bx) - half, min(ay, by) - half, max(ax, bx) + half, max(ay, by) + half, style.WALL, None)


def _corners(rect: Rect) -> list[tuple[float, float]]:
    x0, y0, x1, y1 = rect
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _grown(box: Box, by: float) -> Box:
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by
