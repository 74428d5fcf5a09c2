"""Sprites: small smooth pictures as pygame surfaces, drawn once and put where they are wanted."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pygame
from PIL import Image

from decomplex_bt.envs.geometry import Rect
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.canvas import Canvas
from decomplex_bt.envs.rendering.lettering import lettering
from decomplex_bt.envs.rendering.style import Colour

Key = tuple[object, ...]


class SpriteBook:
    """The sprites of one scale (pixels a metre), each drawn when it is first asked for."""

    def __init__(self, scale: float) -> None:
        self.scale = scale
        self._sprites: dict[Key, pygame.Surface] = {}

    def get(self, key: Key, bounds: Rect, draw: Callable[[Canvas], None]) -> pygame.Surface:
        """What `draw` makes of a canvas of these bounds (metres); `key` says all that it depends on."""
        sprite = self._sprites.get(key)
        if sprite is None:
            canvas = Canvas(bounds, self.scale)
            draw(canvas)
            sprite = self._sprites[key] = to_surface(canvas.finish())
        return sprite

    def faded(self, key: Key, sprite: pygame.Surface, alpha: int) -> pygame.Surface:
        """The sprite at an opacity from 0 to 255."""
        key = (*key, "faded", alpha)
        pale = self._sprites.get(key)
        if pale is None:
            pale = self._sprites[key] = sprite.copy()
            pale.fill((alpha,) * 4, special_flags=pygame.BLEND_RGBA_MULT)
        return pale


def put(surface: pygame.Surface, sprite: pygame.Surface, left: float, top: float) -> None:
    """Puts a sprite with its top left corner there, pixels."""
    surface.blit(sprite, (round(left), round(top)), special_flags=pygame.BLEND_PREMULTIPLIED)


def put_around(surface: pygame.Surface, sprite: pygame.Surface, centre: tuple[int, int]) -> None:
    """Puts a sprite with its middle there, pixels."""
    put(surface, sprite, *corner_around(sprite, centre))


def corner_around(sprite: pygame.Surface, centre: tuple[int, int]) -> tuple[int, int]:
    """Where a sprite's top left corner comes when its middle is put there."""
    return centre[0] - sprite.get_width() // 2, centre[1] - sprite.get_height() // 2


def to_surface(picture: Image.Image) -> pygame.Surface:
    """A Pillow picture as a surface with premultiplied alpha."""
    return pygame.image.frombytes(picture.convert("RGBA").tobytes(), picture.size, "RGBA").premul_alpha()


def opaque_surface(picture: Image.Image) -> pygame.Surface:
    return pygame.image.frombytes(picture.convert("RGB").tobytes(), picture.size, "RGB")


@lru_cache(maxsize=512)
def text(line: str, size: int, ink: Colour = style.INK, *, halo: bool = False) -> pygame.Surface:
    """One line of lettering."""
    return to_surface(lettering((line or " ",), size, ink, halo))


@lru_cache(maxsize=64)
def glow(colour: Colour, radius: int) -> pygame.Surface:
    """A soft round light, `radius` pixels."""
    axis = np.linspace(-1, 1, 2 * radius)
    distance = np.hypot(axis[:, None], axis[None, :])
    alpha = (np.clip(1 - distance, 0, 1) ** 1.3 * 150).astype(np.uint8)
    pixels = np.dstack([np.full_like(alpha, value) for value in colour] + [alpha])
    return to_surface(Image.fromarray(pixels))


@lru_cache(maxsize=64)
def dot(radius: float, alpha: int) -> pygame.Surface:
    """A dot of the path driven, `radius` pixels, opacity from 0 to 255."""
    side = 2 * (radius + 1)
    canvas = Canvas((0, 0, side, side), 1.0)
    canvas.pen().disc(side / 2, side / 2, radius, (*style.TRAIL, alpha))
    return to_surface(canvas.finish())


@lru_cache(maxsize=64)
def bubble(lines: tuple[str, ...], size: int) -> pygame.Surface:
    """A speech bubble with a tip at the middle of its lower edge."""
    words = lettering(lines, size, style.INK, False)
    pad, tip = size * 0.6, size * 0.7
    width, height = words.width + 2 * pad, words.height + pad + tip
    canvas = Canvas((0, 0, width, height), 1.0)
    pen = canvas.pen()
    pen.box(1, tip, width - 1, height - 1, (255, 255, 255), style.WALL, 1.4, radius=size * 0.6)
    pen.polygon([(width / 2 - tip * 0.6, tip + 1), (width / 2 + tip * 0.6, tip + 1), (width / 2, 1)], (255, 255, 255))
    pen.line([(width / 2 - tip * 0.6, tip), (width / 2, 1), (width / 2 + tip * 0.6, tip)], style.WALL, 1.4)
    picture = canvas.finish()
    picture.alpha_composite(words, (round(pad), round(pad * 0.55)))
    return to_surface(picture)
