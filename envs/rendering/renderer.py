"""The renderer: scenes of one house as pictures of one size, quick because all that stays is drawn once.

From the bottom up: the interior and the things in it (redrawn when one of them changes), the path driven, the view
cone, people, the robot, what is pointed out, speech, and the caption.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import pygame
from numpy.typing import NDArray
from pygame import gfxdraw

from decomplex_bt.envs.geometry import WALL_RADIUS, Geometry, Rect
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.canvas import Canvas
from decomplex_bt.envs.rendering.caption import draw_caption, draw_speech
from decomplex_bt.envs.rendering.figures import draw_person, draw_robot, draw_thing, tray_slots
from decomplex_bt.envs.rendering.interior import Interior
from decomplex_bt.envs.rendering.layout import Layout
from decomplex_bt.envs.rendering.lettering import printable, spoken
from decomplex_bt.envs.rendering.scene import Pose, Scene
from decomplex_bt.envs.rendering.sight import view_polygon
from decomplex_bt.envs.rendering.sprites import SpriteBook, corner_around, dot, put, put_around, text

TURNS = 72
"""Headings for which a person or the robot is drawn; a picture is off by at most 2.5 degrees."""
MAX_DOTS = 240
"""Dots of the path driven that are shown; the oldest fade away."""
PERSON_RADIUS = 0.25
ROBOT_RADIUS = 0.22
HIDDEN_ALPHA = 80
"""Opacity, 0 to 255, of a thing in a closed container: the picture shows the truth, the robot does not see it."""
LEAST_SIDE = 64
"""[px] Below this there is nothing to be seen."""

Frame = NDArray[np.uint8]


class Renderer:
    """Pictures of one house, `width` x `height` pixels. Raises `ValueError` for a side under 64."""

    def __init__(self, geometry: Geometry, width: int, height: int) -> None:
        if min(width, height) < LEAST_SIDE:
            raise ValueError(f"a picture has at least {LEAST_SIDE} x {LEAST_SIDE} pixels, got {width} x {height}")
        self.geometry = geometry
        self.layout = Layout(geometry, width, height)
        self.sprites = SpriteBook(self.layout.scale)
        self.interior = Interior(self.layout, self.sprites)
        self._surface = pygame.Surface((width, height), 0, 32)
        self._still = pygame.Surface((width, height), 0, 32)
        self._still_key: object = None
        self._house_area = pygame.Rect(0, 0, width, self.layout.house_height)
        self._walls = _lengthened(geometry.wall_lines, WALL_RADIUS)
        self._radii = {name: self._icon_radius(name) for name in geometry.house.things}
        self._sealable = frozenset(
            name
            for name in geometry.house.furniture
            if (kind := geometry.house.kind(name, geometry.kinds)).is_container and kind.has_door
        )

    def frame(self, scene: Scene) -> Frame:
        """The scene as `(height, width, 3)` uint8."""
        surface = self.draw(scene)
        pixels = np.frombuffer(pygame.image.tobytes(surface, "RGB"), np.uint8)
        return pixels.reshape(self.layout.height, self.layout.width, 3).copy()

    def draw(self, scene: Scene) -> pygame.Surface:
        """The scene on the renderer's own surface, which the next call draws over."""
        surface = self._surface
        surface.blit(self._still_life(scene), (0, 0))
        surface.set_clip(self._house_area)
        self._draw_path(surface, scene.path)
        self._draw_view(surface, scene)
        self._draw_people(surface, scene)
        self._draw_robot(surface, scene)
        self._point_out(surface, scene)
        surface.set_clip(None)
        draw_speech(surface, self.layout, scene)
        draw_caption(surface, self.layout, scene)
        return surface

    def _still_life(self, scene: Scene) -> pygame.Surface:
        """The interior with all that lies in it; drawn anew when something there has changed."""
        key = scene.states, scene.things, scene.places
        if key != self._still_key:
            self._still.blit(self.interior.surface(scene.states), (0, 0))
            self._draw_things(self._still, scene)
            self._still_key = key
        return self._still

    def _draw_path(self, surface: pygame.Surface, path: tuple[tuple[float, float], ...]) -> None:
        radius = max(1.2, 0.024 * self.layout.scale)
        dots = list(_spaced(path, style.TRAIL_STEP))[-MAX_DOTS:]
        oldest = MAX_DOTS - len(dots)
        sprites = [dot(radius, 40 + 140 * (oldest + number) // MAX_DOTS // 20 * 20) for number in range(len(dots))]
        centres = [self.layout.pixel(*point) for point in dots]
        places = [(sprite, corner_around(sprite, at)) for sprite, at in zip(sprites, centres, strict=True)]
        surface.fblits(places, pygame.BLEND_PREMULTIPLIED)

    def _draw_view(self, surface: pygame.Surface, scene: Scene) -> None:
        if scene.sight is None:
            return
        leaves = self.geometry.leaves.items()
        closed = [line for name, line in leaves if scene.states.get((name, "aperture")) == "closed"]
        lines = np.vstack([self._walls, np.array(closed)]) if closed else self._walls
        pixels = [self.layout.pixel(x, y) for x, y in view_polygon(*scene.robot, *scene.sight, lines).tolist()]
        gfxdraw.filled_polygon(surface, pixels, style.VIEW)
        gfxdraw.aapolygon(surface, pixels, style.VIEW_EDGE)

    def _draw_things(self, surface: pygame.Surface, scene: Scene) -> None:
        """The largest first, so that none hides another."""
        places = []
        for name, pose in sorted(scene.things.items(), key=lambda item: (-self._radii[item[0]], item[0])):
            place = scene.places.get(name)
            is_hidden = place in self._sealable and scene.states.get((str(place), "aperture")) == "closed"
            sprite = self._thing(name, scene, is_hidden=is_hidden)
            places.append((sprite, corner_around(sprite, self.layout.pixel(pose.x, pose.y))))
        surface.fblits(places, pygame.BLEND_PREMULTIPLIED)

    def _draw_people(self, surface: pygame.Surface, scene: Scene) -> None:
        numbers = {name: number for number, name in enumerate(self.geometry.house.people)}
        for name, pose in scene.people.items():
            x, y = self.layout.pixel(pose.x, pose.y)
            put_around(surface, self._person(numbers[name], pose.heading), (x, y))
            label = text(self._person_name(name), self.layout.letters(0.165), halo=True)
            put(surface, label, x - label.get_width() // 2, y + PERSON_RADIUS * self.layout.scale)
            for thing in sorted(thing for thing, owner in scene.with_person.items() if owner == name):
                put_around(surface, self._thing(thing, scene), self.layout.pixel(*_beside(pose, 0.24, 0.0)))

    def _draw_robot(self, surface: pygame.Surface, scene: Scene) -> None:
        pose = scene.robot
        robot = self._robot(pose.heading, is_holding=scene.held is not None)
        put_around(surface, robot, self.layout.pixel(pose.x, pose.y))
        for thing, slot in zip(scene.tray, tray_slots(len(scene.tray), ROBOT_RADIUS), strict=True):
            if thing is not None:
                put_around(surface, self._thing(thing, scene, share=0.52), self.layout.pixel(*_beside(pose, *slot)))
        if scene.held is not None:
            at = _beside(pose, ROBOT_RADIUS * 1.5, 0.0)
            put_around(surface, self._thing(scene.held, scene), self.layout.pixel(*at))

    def _point_out(self, surface: pygame.Surface, scene: Scene) -> None:
        """A ring around each entity that is pointed out; a thing also gets its name."""
        for name in scene.pointed_out:
            pose = scene.things.get(name) or scene.people.get(name)
            if pose is None:
                continue
            is_thing = name in scene.things
            radius = self._radii[name] * 1.35 if is_thing else PERSON_RADIUS * 1.25
            x, y = self.layout.pixel(pose.x, pose.y)
            put_around(surface, self._ring(radius), (x, y))
            if is_thing:
                label = text(spoken(name), self.layout.letters(0.155), style.POINTER, halo=True)
                top = y - radius * self.layout.scale - label.get_height()
                put(surface, label, x - label.get_width() // 2, top)

    # -- sprites ------------------------------------------------------------------------------------------------------

    def _thing(self, name: str, scene: Scene, *, is_hidden: bool = False, share: float = 1.0) -> pygame.Surface:
        """A thing's icon at a share of its size, pale where it is hidden."""
        item = self.geometry.house.things[name]
        kind = self.geometry.kinds.kinds[item.kind]
        states = {pair: scene.states.get((name, pair), "") for pair in kind.states}
        radius = self._radii[name] * share

        def draw(canvas: Canvas) -> None:
            draw_thing(canvas.pen(), kind.shape, radius, style.thing_colour(item.kind, item.colour), states)

        key = ("thing", item.kind, item.colour, *states.values(), share)
        sprite = self.sprites.get(key, _square(radius * 1.75), draw)
        return self.sprites.faded(key, sprite, HIDDEN_ALPHA) if is_hidden else sprite

    def _person(self, number: int, heading: float) -> pygame.Surface:
        turn = _turn(heading)

        def draw(canvas: Canvas) -> None:
            clothes, hair = style.PEOPLE[number % len(style.PEOPLE)], style.HAIR[number % len(style.HAIR)]
            draw_person(canvas.pen(heading=turn * 2 * math.pi / TURNS), PERSON_RADIUS, clothes, hair)

        return self.sprites.get(("person", number, turn), _square(PERSON_RADIUS * 1.3), draw)

    def _robot(self, heading: float, *, is_holding: bool) -> pygame.Surface:
        turn = _turn(heading)

        def draw(canvas: Canvas) -> None:
            draw_robot(canvas.pen(heading=turn * 2 * math.pi / TURNS), ROBOT_RADIUS, is_holding=is_holding)

        return self.sprites.get(("robot", turn, is_holding), _square(ROBOT_RADIUS * 1.6), draw)

    def _ring(self, radius: float) -> pygame.Surface:
        def draw(canvas: Canvas) -> None:
            canvas.pen().disc(0, 0, radius, None, style.POINTER, 1.8)

        return self.sprites.get(("ring", round(radius, 3)), _square(radius * 1.2), draw)

    def _icon_radius(self, name: str) -> float:
        kind = self.geometry.kinds.kinds[self.geometry.house.things[name].kind]
        return max(kind.radius * 1.05, style.ICON_RADIUS, 5.0 / self.layout.scale)

    def _person_name(self, name: str) -> str:
        words = self.geometry.house.people[name].words
        return printable(words[0].capitalize() if words else "you" if name == self.geometry.house.user else name)


def _lengthened(lines: NDArray[np.float64], by: float) -> NDArray[np.float64]:
    """Segments `(n, 4)` with both ends moved outwards: the centre lines of walls end before their round ends do."""
    along = lines[:, 2:] - lines[:, :2]
    step = along / np.linalg.norm(along, axis=1, keepdims=True) * by
    return np.hstack([lines[:, :2] - step, lines[:, 2:] + step])


def _spaced(path: tuple[tuple[float, float], ...], step: float) -> Iterator[tuple[float, float]]:
    """Points along a path at least `step` metres apart."""
    last: tuple[float, float] | None = None
    for point in path:
        if last is None or math.hypot(point[0] - last[0], point[1] - last[1]) >= step:
            last = point
            yield point


def _beside(pose: Pose, ahead: float, left: float) -> tuple[float, float]:
    """The point so far ahead and to the left of a pose, metres."""
    cos, sin = math.cos(pose.heading), math.sin(pose.heading)
    return pose.x + ahead * cos - left * sin, pose.y + ahead * sin + left * cos


def _turn(heading: float) -> int:
    return round(heading / (2 * math.pi / TURNS)) % TURNS


def _square(half: float) -> Rect:
    return -half, -half, half, half
