"""The interior: the backdrop with doors and furniture in their present states, and all names."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import pygame
from PIL import Image

from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.backdrop import (
    door_bounds,
    draw_backdrop,
    draw_door,
    draw_piece,
    names_of,
    piece_bounds,
)
from decomplex_bt.envs.rendering.furniture import CEILING_REACH, glow_of
from decomplex_bt.envs.rendering.layout import Layout
from decomplex_bt.envs.rendering.sprites import SpriteBook, glow, opaque_surface, put, put_around, to_surface

Shown = tuple[tuple[str, str], ...]
"""State pairs of one piece with the values to show, in the kind's order."""


class Interior:
    """Drawn anew only when a state has changed, which is rare; the surface it gives is not to be drawn on."""

    def __init__(self, layout: Layout, sprites: SpriteBook) -> None:
        self.layout, self.geometry, self.sprites = layout, layout.geometry, sprites
        self._empty = pygame.Surface((layout.width, layout.height), 0, 32)
        self._empty.fill(style.PAPER)
        self._empty.blit(opaque_surface(_backdrop(self.geometry, layout.scale)), (layout.left, layout.top))
        names = names_of(self.geometry, layout.scale, layout.boxes())
        self._names = [(to_surface(name.picture), (name.left, name.top)) for name in names]
        self._surface, self._shown = self._empty, dict[str, Shown]()

    def surface(self, states: Mapping[tuple[str, str], str]) -> pygame.Surface:
        """The house with every place in its state; `states` as in a scene."""
        places = self.geometry.names[: self.geometry.place_count]
        shown = {name: self._shown_of(name, states) for name in places}
        if shown != self._shown:
            self._surface, self._shown = self._draw(shown), shown
        return self._surface

    def _shown_of(self, name: str, states: Mapping[tuple[str, str], str]) -> Shown:
        kind = self.geometry.house.kind(name, self.geometry.kinds)
        return tuple((pair, states.get((name, pair), "")) for pair in kind.states if pair != "cleanliness")

    def _draw(self, shown: Mapping[str, Shown]) -> pygame.Surface:
        surface = self._empty.copy()
        for name, states in shown.items():
            if states and name in self.geometry.house.furniture:
                self._put_piece(surface, name, states)
            elif states and name in self.geometry.leaves:
                self._put_door(surface, name, is_open=("aperture", "open") in states)
        for name, states in shown.items():
            if ("power", "on") in states:
                self._put_glow(surface, name)
        surface.fblits(self._names, pygame.BLEND_PREMULTIPLIED)
        return surface

    def _put_piece(self, surface: pygame.Surface, name: str, states: Shown) -> None:
        bounds = piece_bounds(self.geometry, name)
        sprite = self.sprites.get(
            ("piece", name, states), bounds, lambda canvas: draw_piece(canvas, self.geometry, name, dict(states))
        )
        put(surface, sprite, *self.layout.pixel(bounds[0], bounds[3]))

    def _put_door(self, surface: pygame.Surface, name: str, *, is_open: bool) -> None:
        bounds = door_bounds(self.geometry, name)
        sprite = self.sprites.get(
            ("door", name, is_open), bounds, lambda canvas: draw_door(canvas, self.geometry, name, is_open=is_open)
        )
        put(surface, sprite, *self.layout.pixel(bounds[0], bounds[3]))

    def _put_glow(self, surface: pygame.Surface, name: str) -> None:
        piece = self.geometry.house.furniture[name]
        light = glow_of(piece.kind)
        if light is None:
            return
        colour, reach = light
        x0, y0, x1, y1 = self.geometry.house.rooms[piece.room].rect
        # a ceiling light hangs in the middle of the room, its switch is at the wall
        centre = ((x0 + x1) / 2, (y0 + y1) / 2) if reach == CEILING_REACH else piece.centre
        left, top, right, bottom = self.layout.box((x0, y0, x1, y1))
        surface.set_clip(pygame.Rect(round(left), round(top), round(right - left), round(bottom - top)))
        put_around(surface, glow(colour, round(reach * self.layout.scale)), self.layout.pixel(*centre))
        surface.set_clip(None)


@lru_cache(maxsize=4)
def _backdrop(geometry: Geometry, scale: float) -> Image.Image:
    return draw_backdrop(geometry, scale)
