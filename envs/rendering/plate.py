"""The plate: a scene as a drawing of vectors, for print; it shows what the renderer's picture of that size shows."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry, Rect
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.backdrop import draw_door, draw_floor, draw_piece, draw_walls, names_of
from decomplex_bt.envs.rendering.canvas import Canvas, Point
from decomplex_bt.envs.rendering.figures import draw_person, draw_robot, draw_thing, tray_slots
from decomplex_bt.envs.rendering.furniture import CEILING_REACH, glow_of
from decomplex_bt.envs.rendering.layout import CAPTION_LINES, Layout
from decomplex_bt.envs.rendering.lettering import doing_of, printable, shorten, spoken, text_size, wrap
from decomplex_bt.envs.rendering.scene import Pose, Scene
from decomplex_bt.envs.rendering.sight import view_polygon
from decomplex_bt.envs.rendering.vector import Drawing, VectorCanvas
from decomplex_bt.envs.spots import PERSON_RADIUS, ROBOT_RADIUS

PALE = 80 / 255
"""Opacity of a thing in a closed container."""
RINGS = 12
"""A glow is made of so many discs."""


def draw_plate(geometry: Geometry, scene: Scene, size: tuple[int, int]) -> Drawing:
    """The scene as vectors, `size`: width and height of the picture."""
    return _Plate(geometry, scene, size).draw()


class _Plate:
    def __init__(self, geometry: Geometry, scene: Scene, size: tuple[int, int]) -> None:
        self.geometry, self.scene = geometry, scene
        self.layout = layout = Layout(geometry, *size)
        self.canvas = VectorCanvas(layout.origin, layout.scale)
        self.pen = self.canvas.pen()

    def draw(self) -> Drawing:
        canvas, layout = self.canvas, self.layout
        canvas.polygon(_corners((0, 0, layout.width, layout.height)), style.PAPER)
        self._house()
        self._things()
        self._path_and_view()
        self._people()
        self._robot()
        self._pointed_out()
        self._speech()
        self._caption()
        return Drawing(layout.width, layout.height, tuple(canvas.marks))

    # -- the house ----------------------------------------------------------------------------------------------------

    def _house(self) -> None:
        geometry, scene, pen = self.geometry, self.scene, self.pen
        x0, y0, x1, y1 = geometry.bounds
        canvas: Canvas = self.canvas  # type: ignore[assignment]  # what is drawn with needs no more of it
        pen.polygon(_corners((x0 + 0.07, y0 - 0.07, x1 + 0.07, y1 - 0.07)), (*style.SHADOW, 50))
        for number, room in enumerate(geometry.house.rooms.values()):
            draw_floor(pen, room, number)
        for block in geometry.blocks:
            pen.at(0.035, -0.035).polygon(_corners(block), (*style.SHADOW, 50))
        draw_walls(pen, geometry)
        for name, piece in geometry.house.furniture.items():
            if piece.part_of is None:
                self._piece(canvas, name)
        for name, piece in geometry.house.furniture.items():
            if piece.part_of is not None:
                self._piece(canvas, name)
        for name in geometry.leaves:
            draw_door(canvas, geometry, name, is_open=scene.states.get((name, "aperture")) == "open")
        for name in geometry.house.furniture:
            if scene.states.get((name, "power")) == "on":
                self._glow(name)
        for placed in names_of(geometry, self.layout.scale, self.layout.boxes()):
            self._lettering(placed.lines, placed.box, placed.size, placed.ink, is_turned=placed.is_turned)

    def _piece(self, canvas: Canvas, name: str) -> None:
        kind = self.geometry.house.kind(name, self.geometry.kinds)
        states = {pair: self.scene.states.get((name, pair), "") for pair in kind.states if pair != "cleanliness"}
        draw_piece(canvas, self.geometry, name, states)

    def _glow(self, name: str) -> None:
        piece = self.geometry.house.furniture[name]
        light = glow_of(piece.kind)
        if light is None:
            return
        colour, reach = light
        room = self.geometry.house.rooms[piece.room].rect
        x, y = ((room[0] + room[2]) / 2, (room[1] + room[3]) / 2) if reach == CEILING_REACH else piece.centre
        for ring in range(RINGS):
            radius = reach * (1 - ring / RINGS)
            disc = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 49)[:-1]]
            inside = _clipped(disc, room)
            if len(inside) > 2:
                self.pen.polygon(inside, (*colour, 150 // RINGS))

    def _lettering(
        self, lines: tuple[str, ...], box: Rect, size: int, ink: style.Colour, *, is_turned: bool = False
    ) -> None:
        """Centred lines in a box of the picture, as `lettering` has them."""
        left, top, right, bottom = box
        for number, line in enumerate(lines):
            width, height = text_size(line, size)
            if is_turned:
                self.canvas.text(line, left + number * height, (top + bottom + width) / 2, size, ink, is_turned=True)
            else:
                self.canvas.text(line, (left + right - width) / 2, top + number * height, size, ink)

    # -- what is in it ------------------------------------------------------------------------------------------------

    def _things(self) -> None:
        scene, house = self.scene, self.geometry.house
        for name, pose in sorted(scene.things.items(), key=lambda item: (-self._radius(item[0]), item[0])):
            place = scene.places.get(name)
            kind = house.kind(place, self.geometry.kinds) if place in house.furniture else None
            is_shut = scene.states.get((str(place), "aperture")) == "closed"
            self.canvas.opacity = PALE if kind is not None and kind.inside and kind.has_door and is_shut else 1.0
            self._thing(name, pose)
        self.canvas.opacity = 1.0

    def _thing(self, name: str, pose: Pose, share: float = 1.0) -> None:
        item = self.geometry.house.things[name]
        kind = self.geometry.kinds.kinds[item.kind]
        states = {pair: self.scene.states.get((name, pair), "") for pair in kind.states}
        colour = style.thing_colour(item.kind, item.colour)
        draw_thing(self.canvas.pen(pose.x, pose.y), kind.shape, self._radius(name) * share, colour, states)

    def _radius(self, name: str) -> float:
        kind = self.geometry.kinds.kinds[self.geometry.house.things[name].kind]
        return max(kind.radius * 1.05, style.ICON_RADIUS, 5.0 / self.layout.scale)

    def _path_and_view(self) -> None:
        scene, geometry = self.scene, self.geometry
        if len(scene.path) > 1:
            self.pen.line(list(scene.path), (*style.TRAIL, 130), 2.0)
        if scene.sight is None:
            return
        closed = [line for door, line in geometry.leaves.items() if scene.states.get((door, "aperture")) == "closed"]
        lines = np.array([*(_lengthened(wall) for wall in geometry.walls), *closed])
        self.pen.polygon(view_polygon(*scene.robot, *scene.sight, lines).tolist(), style.VIEW, style.VIEW_EDGE, 1.0)

    def _people(self) -> None:
        numbers = {name: number for number, name in enumerate(self.geometry.house.people)}
        for name, pose in self.scene.people.items():
            number = numbers[name]
            clothes, hair = style.PEOPLE[number % len(style.PEOPLE)], style.HAIR[number % len(style.HAIR)]
            draw_person(self.canvas.pen(*pose), PERSON_RADIUS, clothes, hair)
            self._caption_below(self._name(name), pose)
            for thing in sorted(thing for thing, owner in self.scene.with_person.items() if owner == name):
                self._thing(thing, _beside(pose, 0.24, 0.0))

    def _name(self, person: str) -> str:
        words = self.geometry.house.people[person].words
        return printable(words[0].capitalize() if words else "you" if person == self.geometry.house.user else person)

    def _caption_below(self, words: str, pose: Pose) -> None:
        size = self.layout.letters(0.165)
        ((x, y),) = self.canvas.pixels([(pose.x, pose.y - PERSON_RADIUS)])
        self.canvas.text(words, x - text_size(words, size)[0] / 2, y, size, style.INK)

    def _robot(self) -> None:
        scene, pose = self.scene, self.scene.robot
        draw_robot(self.canvas.pen(*pose), ROBOT_RADIUS, is_holding=scene.held is not None)
        for thing, slot in zip(scene.tray, tray_slots(len(scene.tray), ROBOT_RADIUS), strict=True):
            if thing is not None:
                self._thing(thing, _beside(pose, *slot), share=0.52)
        if scene.held is not None:
            self._thing(scene.held, _beside(pose, ROBOT_RADIUS * 1.5, 0.0))

    def _pointed_out(self) -> None:
        for name in self.scene.pointed_out:
            pose = self.scene.things.get(name) or self.scene.people.get(name)
            if pose is None:
                continue
            is_thing = name in self.scene.things
            radius = self._radius(name) * 1.35 if is_thing else PERSON_RADIUS * 1.25
            self.pen.disc(pose.x, pose.y, radius, None, style.POINTER, 1.8)
            if is_thing:
                size = self.layout.letters(0.155)
                ((x, y),) = self.canvas.pixels([(pose.x, pose.y + radius)])
                words = spoken(name)
                self.canvas.text(words, x - text_size(words, size)[0] / 2, y - size * 1.2, size, style.POINTER)

    # -- what is written over and under it ----------------------------------------------------------------------------

    def _speech(self) -> None:
        scene, layout = self.scene, self.layout
        if not scene.said or not layout.caption_height:
            return
        size = max(9, layout.caption_size - 2)
        lines = wrap(printable(scene.said), size, round(layout.width * 0.34), 3)
        width = max(text_size(line, size)[0] for line in lines) + 1.2 * size
        height = text_size(lines[0], size)[1] * len(lines) + 0.6 * size
        ((x, y),) = self.canvas.pixels([(scene.robot.x, scene.robot.y + 0.32)])
        left = min(max(4.0, x - width / 2), layout.width - width - 4)
        top = max(4.0, y - height - 0.7 * size)
        bottom = top + height
        tip = (x, bottom + 0.7 * size)
        outline = [(left, top), (left + width, top), (left + width, bottom), (x + size / 2, bottom), tip]
        outline += [(x - size / 2, bottom), (left, bottom)]
        self.canvas.polygon(outline, (255, 255, 255))
        self.canvas.line([*outline, outline[0]], style.WALL, 1.4)
        self._lettering(tuple(lines), (left, top + 0.2 * size, left + width, bottom), size, style.INK)

    def _caption(self) -> None:
        layout, scene, canvas = self.layout, self.scene, self.canvas
        if not layout.caption_height:
            return
        size, pad = layout.caption_size, round(layout.caption_size * 0.8)
        colour = style.VERDICTS.get(scene.verdict, style.ROBOT_ACCENT)
        top, width = layout.house_height, layout.width - 3 * pad
        canvas.polygon(_corners((0, top, layout.width, layout.height)), (255, 255, 255))
        canvas.line([(0, top), (layout.width, top)], (222, 220, 214), 1.0)
        canvas.polygon(_corners((0, top, max(4, size // 3), layout.height)), colour)
        for number, line in enumerate(wrap(printable(scene.instruction), size, width, CAPTION_LINES)):
            canvas.text(line, 2 * pad, top + size * (0.5 + 1.28 * number), size, style.INK)
        bottom = layout.height - size * 1.75
        clock = f"{scene.seconds:.0f} s"
        clock_width = text_size(clock, size)[0]
        canvas.text(clock, layout.width - pad - clock_width, bottom, size, style.FADED_INK)
        canvas.text(shorten(doing_of(scene), size, width - clock_width - pad), 2 * pad, bottom, size, colour)


def _beside(pose: Pose, ahead: float, left: float) -> Pose:
    cos, sin = math.cos(pose.heading), math.sin(pose.heading)
    return Pose(pose.x + ahead * cos - left * sin, pose.y + ahead * sin + left * cos)


def _corners(rect: Rect) -> list[Point]:
    x0, y0, x1, y1 = rect
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _lengthened(line: Rect) -> Rect:
    """A wall's centre line out to its round ends."""
    ax, ay, bx, by = line
    length = math.hypot(bx - ax, by - ay)
    dx, dy = (bx - ax) / length * WALL_RADIUS, (by - ay) / length * WALL_RADIUS
    return ax - dx, ay - dy, bx + dx, by + dy


def _clipped(polygon: list[Point], rect: Rect) -> list[Point]:
    """The part of a convex polygon that lies in a rectangle."""
    for axis, bound, sign in ((0, rect[0], 1), (0, rect[2], -1), (1, rect[1], 1), (1, rect[3], -1)):
        polygon = list(_cut(polygon, axis, bound, sign))
    return polygon


def _cut(polygon: list[Point], axis: int, bound: float, sign: int) -> Iterator[Point]:
    for before, after in zip([polygon[-1], *polygon[:-1]] if polygon else [], polygon, strict=True):
        was_in, is_in = ((point[axis] - bound) * sign >= 0 for point in (before, after))
        if was_in != is_in:
            share = (bound - before[axis]) / (after[axis] - before[axis])
            yield before[0] + share * (after[0] - before[0]), before[1] + share * (after[1] - before[1])
        if is_in:
            yield after
