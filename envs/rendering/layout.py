"""The layout of a picture: where the house and the caption stand, and metres as pixels."""

from __future__ import annotations

from decomplex_bt.envs.geometry import Geometry, Rect
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.lettering import Box

CAPTION_LINES = 2
"""Lines for the instruction; one more says what is being done."""
LEAST_CAPTIONED = 160
"""[px] Pictures lower than this have no caption."""


class Layout:
    """How a house fits a picture of `width` x `height` pixels, above the caption.

    `scale`: pixels a metre. `left`, `top`: where the backdrop's corner stands. `caption_size`: of its letters, pixels.
    `origin`: the picture's point, y down, that is the world's (0, 0).
    `origin`: the picture's point, y down, that is the world's (0, 0).
    """

    def __init__(self, geometry: Geometry, width: int, height: int) -> None:
        self.geometry = geometry
        self.width, self.height = width, height
        x0, y0, x1, y1 = geometry.bounds
        wide, high = x1 - x0 + 2 * style.MARGIN, y1 - y0 + 2 * style.MARGIN
        self.caption_size = max(9, min(20, round(width / 46)))
        has_caption = height >= LEAST_CAPTIONED
        self.caption_height = round(self.caption_size * (1.28 * CAPTION_LINES + 2.5)) if has_caption else 0
        self.house_height = height - self.caption_height
        self.scale = min(width / wide, self.house_height / high)
        self.left = round((width - wide * self.scale) / 2)
        self.top = round(max(0.0, (self.house_height - high * self.scale) / 2))
        self.origin = (self.left + (style.MARGIN - x0) * self.scale, self.top + (y1 + style.MARGIN) * self.scale)

    def pixel(self, x: float, y: float) -> tuple[int, int]:
        """World metres to a pixel, y down."""
        return round(self.origin[0] + x * self.scale), round(self.origin[1] - y * self.scale)

    def box(self, rect: Rect) -> Box:
        """A rectangle in metres to one in pixels."""
        (left, bottom), (right, top) = self.pixel(rect[0], rect[1]), self.pixel(rect[2], rect[3])
        return left, top, right, bottom

    def boxes(self) -> dict[str, Box]:
        """The pixel rectangles of rooms, furniture and doorways."""
        geometry = self.geometry
        boxes = {name: self.box(room.rect) for name, room in geometry.house.rooms.items()}
        for name in geometry.house.furniture:
            x0, y0, x1, y1 = geometry.footprints[geometry.row[name]].tolist()
            boxes[name] = self.box((x0, y0, x1, y1))
        for name, (ax, ay, bx, by) in geometry.openings.items():
            boxes[name] = self.box((min(ax, bx) - 0.1, min(ay, by) - 0.1, max(ax, bx) + 0.1, max(ay, by) + 0.1))
        return boxes

    def letters(self, metres: float) -> int:
        """Size in pixels of letters so high in the house, but readable."""
        return max(8, round(metres * self.scale))
