"""A canvas in metres: smooth shapes by drawing large and shrinking, with a pen that stands anywhere and turns."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache

from PIL import Image, ImageDraw, ImageFilter, ImageFont

from decomplex_bt.envs.rendering.style import SHADOW, Colour, darker

Point = tuple[float, float]
Ink = Colour | tuple[int, int, int, int]

SUPERSAMPLE = 4
"""Pixels drawn for each pixel kept, along each axis."""


class Canvas:
    """A picture of the rectangle `bounds` (x0, y0, x1, y1 in metres, y up) at `scale` pixels a metre.

    `background` None leaves it transparent. `finish` gives the picture, `ceil(side * scale)` pixels a side.
    """

    def __init__(
        self,
        bounds: tuple[float, float, float, float],
        scale: float,
        background: Colour | None = None,
        supersample: int = SUPERSAMPLE,
    ) -> None:
        self.x0, self.y0, self.x1, self.y1 = bounds
        self.scale = scale
        self.fine = scale * supersample
        self.width = max(1, math.ceil((self.x1 - self.x0) * scale))
        self.height = max(1, math.ceil((self.y1 - self.y0) * scale))
        size = (self.width * supersample, self.height * supersample)
        fill = (*background, 255) if background is not None else (0, 0, 0, 0)
        self.image = Image.new("RGBA", size, fill)
        self.draw = ImageDraw.Draw(self.image)

    def pen(self, x: float = 0.0, y: float = 0.0, heading: float = 0.0) -> Pen:
        """A pen whose own frame has its origin here and its x axis along `heading`."""
        return Pen(self, x, y, heading)

    def pixels(self, points: Iterable[Point]) -> list[Point]:
        """World metres to the fine pixels that are drawn on."""
        return [((x - self.x0) * self.fine, (self.y1 - y) * self.fine) for x, y in points]

    def soften(self, radius: float) -> None:
        """Blurs all that is there, by a radius in metres."""
        self.image = self.image.filter(ImageFilter.GaussianBlur(radius * self.fine))
        self.draw = ImageDraw.Draw(self.image)

    def lay(self, other: Canvas) -> None:
        """Puts another canvas of the same bounds and scale on top."""
        self.image.alpha_composite(other.image)

    def finish(self) -> Image.Image:
        return self.image.resize((self.width, self.height), Image.Resampling.BOX)


class Pen:
    """Draws shapes given in metres in its own frame; line widths are in pixels of the finished picture."""

    def __init__(self, canvas: Canvas, x: float, y: float, heading: float) -> None:
        self.canvas = canvas
        self.x, self.y = x, y
        self._cos, self._sin = math.cos(heading), math.sin(heading)
        self._heading = heading

    def at(self, x: float, y: float, heading: float = 0.0) -> Pen:
        """A pen placed relative to this one."""
        ((world_x, world_y),) = self._world([(x, y)])
        return Pen(self.canvas, world_x, world_y, self._heading + heading)

    def polygon(
        self, points: Sequence[Point], fill: Ink | None, outline: Ink | None = None, width: float = 1.0
    ) -> None:
        pixels = self.canvas.pixels(self._world(points))
        if fill is not None:
            self.canvas.draw.polygon(pixels, fill=fill)
        if outline is not None:
            self._stroke([*pixels, pixels[0], pixels[1]], outline, width)

    def line(self, points: Sequence[Point], ink: Ink, width: float = 1.0, *, is_round: bool = True) -> None:
        pixels = self.canvas.pixels(self._world(points))
        self._stroke(pixels, ink, width)
        if is_round and width > 1.5:
            radius = width * self.canvas.fine / self.canvas.scale / 2
            for x, y in (pixels[0], pixels[-1]):
                self.canvas.draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=ink)

    def disc(
        self, x: float, y: float, radius: float, fill: Ink | None, outline: Ink | None = None, width: float = 1.0
    ) -> None:
        self.ellipse(x, y, radius, radius, fill, outline, width)

    def ellipse(
        self, x: float, y: float, rx: float, ry: float, fill: Ink | None, outline: Ink | None = None, width: float = 1.0
    ) -> None:
        """An ellipse with half axes `rx` and `ry` along the pen's own axes."""
        self.polygon(_ellipse(x, y, rx, ry), fill, outline, width)

    def box(
        self,
        x0: float,
        y0: float,
        x1: float,
        y1: float,
        fill: Ink | None,
        outline: Ink | None = None,
        width: float = 1.0,
        *,
        radius: float = 0.0,
    ) -> None:
        """A rectangle with corners rounded by `radius`."""
        self.polygon(_rounded(x0, y0, x1, y1, radius), fill, outline, width)

    def arc(self, x: float, y: float, radius: float, start: float, end: float, ink: Ink, width: float = 1.0) -> None:
        """An arc from angle `start` to `end`, radians in the pen's frame."""
        count = max(3, math.ceil(abs(end - start) / 0.15))
        angles = [start + (end - start) * step / count for step in range(count + 1)]
        self.line([(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles], ink, width)

    def _world(self, points: Iterable[Point]) -> list[Point]:
        return [(self.x + x * self._cos - y * self._sin, self.y + x * self._sin + y * self._cos) for x, y in points]

    def _stroke(self, pixels: Sequence[Point], ink: Ink, width: float) -> None:
        thick = max(1, round(width * self.canvas.fine / self.canvas.scale))
        self.canvas.draw.line(list(pixels), fill=ink, width=thick, joint="curve")


def cast_shadow(
    canvas: Canvas, shapes: Sequence[Sequence[Point]], *, offset: float, blur: float, strength: int
) -> None:
    """A soft shadow of polygons (world metres) towards the lower right; `strength` is its opacity, 0 to 255."""
    shadow = Canvas((canvas.x0, canvas.y0, canvas.x1, canvas.y1), canvas.scale, supersample=1)
    pen = shadow.pen(offset, -offset)
    for shape in shapes:
        pen.polygon(shape, (*SHADOW, strength))
    shadow.soften(blur)
    large = shadow.image.resize(canvas.image.size, Image.Resampling.BILINEAR)
    canvas.image.alpha_composite(large)


def outline_of(fill: Colour) -> Colour:
    """The line around something filled with this colour."""
    return darker(fill, 0.38)


@lru_cache(maxsize=64)
def font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """The one typeface of the pictures (it comes with Pillow), at a size in pixels."""
    return ImageFont.load_default(max(5, size))


def _ellipse(x: float, y: float, rx: float, ry: float) -> list[Point]:
    count = 40
    angles = (2 * math.pi * step / count for step in range(count))
    return [(x + rx * math.cos(a), y + ry * math.sin(a)) for a in angles]


def _rounded(x0: float, y0: float, x1: float, y1: float, radius: float) -> list[Point]:
    radius = min(radius, abs(x1 - x0) / 2, abs(y1 - y0) / 2)
    if radius <= 0:
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    corners = (
        (x1 - radius, y1 - radius, 0.0),
        (x0 + radius, y1 - radius, 0.5),
        (x0 + radius, y0 + radius, 1.0),
        (x1 - radius, y0 + radius, 1.5),
    )
    return [
        (x + radius * math.cos((turn + step / 10) * math.pi), y + radius * math.sin((turn + step / 10) * math.pi))
        for x, y, turn in corners
        for step in range(6)
    ]
