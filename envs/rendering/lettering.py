"""Lettering: texts as small pictures, wrapped and shortened to fit, and where the names of furniture find room."""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from PIL import Image, ImageDraw

from decomplex_bt.envs.rendering.canvas import font
from decomplex_bt.envs.rendering.scene import Scene
from decomplex_bt.envs.rendering.style import INK, Colour

Box = tuple[float, float, float, float]
"""Left, top, right, bottom in pixels, y down."""

TOLERATED = 0.25
"""Share of a label that may lie on a neighbour where there is no free place."""
_TYPOGRAPHIC = str.maketrans({"’": "'", "‘": "'", "“": '"', "”": '"', "–": "-", "—": "-", "…": "...", "→": "->"})


def printable(text: str) -> str:
    """The text in the letters of the typeface (ASCII): accents are dropped, other letters become "?"."""
    plain = unicodedata.normalize("NFKD", " ".join(text.translate(_TYPOGRAPHIC).split()))
    return "".join(letter if " " <= letter <= "~" else "?" for letter in plain if not unicodedata.combining(letter))


def spoken(name: str) -> str:
    """An entity's name as people say it: "mug_1" is a mug."""
    return printable(name.rstrip("_0123456789").replace("_", " "))


def doing_of(scene: Scene) -> str:
    """The caption's last line: the verdict or what is being done, and what is carried."""
    carried = ", ".join(spoken(thing) for thing in (scene.held, *scene.tray) if thing is not None)
    parts = (printable(scene.verdict or scene.doing), f"carrying {carried}" if carried else "")
    return " | ".join(part for part in parts if part)


@lru_cache(maxsize=512)
def text_size(text: str, size: int) -> tuple[int, int]:
    """Width and line height in pixels of one line."""
    face = font(size)
    ascent = round(size * 1.18)
    return round(face.getlength(text)), ascent


@lru_cache(maxsize=512)
def lettering(lines: tuple[str, ...], size: int, ink: Colour = INK, halo: bool = True) -> Image.Image:
    """Centred lines as a transparent picture; `halo`: a pale rim that keeps them readable on anything."""
    width = max(text_size(line, size)[0] for line in lines) + 4
    height = text_size(lines[0], size)[1]
    picture = Image.new("RGBA", (width, height * len(lines) + 3), (255, 255, 255, 0))
    draw = ImageDraw.Draw(picture)
    for number, line in enumerate(lines):
        x = (width - text_size(line, size)[0]) / 2
        if halo:
            draw.text(
                (x, number * height),
                line,
                fill=(255, 255, 255, 120),
                font=font(size),
                stroke_width=1,
                stroke_fill=(255, 255, 255, 120),
            )
        draw.text((x, number * height), line, fill=(*ink, 255), font=font(size))
    return picture


def wrap(text: str, size: int, width: int, max_lines: int) -> list[str]:
    """The text in at most so many lines of at most `width` pixels; what does not fit ends in "..."."""
    lines: list[str] = []
    words = text.split()
    while words and len(lines) < max_lines:
        line = words.pop(0)
        while words and text_size(f"{line} {words[0]}", size)[0] <= width:
            line = f"{line} {words.pop(0)}"
        lines.append(line)
    if words:
        lines[-1] = f"{lines[-1]} ..."
    return [shorten(line, size, width) for line in lines]


def shorten(text: str, size: int, width: int) -> str:
    """The text, cut to `width` pixels with "..." at its end where it is longer."""
    if text_size(text, size)[0] <= width:
        return text
    kept, face = text.removesuffix("...").rstrip(), font(size)
    # measured by halves: a word may be as long as an instruction
    length = bisect_right(range(1, len(kept) + 1), width, key=lambda stop: round(face.getlength(f"{kept[:stop]}...")))
    return f"{kept[:length].rstrip()}..."


@dataclass(frozen=True, slots=True)
class Label:
    """A name that wants a place: on `box` or beside it, inside `room`, away from `obstacles` if that is possible."""

    text: str
    box: Box
    room: Box
    front: tuple[int, int]
    """Direction in pixels (y down) in which the front lies: where a label beside the piece is tried first."""
    is_beside: bool = False
    """Rather beside than on the box, where things are to be seen."""
    is_first: bool = False
    """Chooses its place before the others."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A picture of lettering with its top left corner in pixels, and what is written: `is_turned`, upwards."""

    picture: Image.Image
    left: int
    top: int
    lines: tuple[str, ...] = ()
    size: int = 0
    ink: Colour = INK
    is_turned: bool = False

    @property
    def box(self) -> Box:
        return self.left, self.top, self.left + self.picture.width, self.top + self.picture.height


def place_labels(
    labels: Sequence[Label], obstacles: Sequence[Box], size: int, taken: Iterable[Box] = ()
) -> list[Placed]:
    """A place for each label that finds one, larger boxes first but for those that go first; no two overlap.

    What finds none is left out.
    """
    kept = list(taken)
    placed: list[Placed] = []
    order = sorted(labels, key=lambda label: (not label.is_first, -_area(label.box), label.text))
    for label in order:
        found = _place(label, obstacles, kept, size)
        if found is not None:
            placed.append(found)
            kept.append(found.box)
    return placed


def _place(label: Label, obstacles: Sequence[Box], taken: Sequence[Box], size: int) -> Placed | None:
    others = [box for box in obstacles if not _contains(box, label.box) and not _contains(label.box, box)]
    for is_strict in (True, False):
        for candidate in _candidates(label, size):
            box = candidate.box
            if not _contains(label.room, box) or any(_overlap(box, other, 1) for other in taken):
                continue
            inner = [other for other in obstacles if other != label.box and _contains(label.box, other)]
            hidden = sum(shared_area(box, other) for other in (*others, *inner)) / _area(box)
            if hidden > (0.0 if is_strict else 1.0 if _contains(label.box, box) else TOLERATED):
                continue
            return candidate
    return None


def _candidates(label: Label, size: int) -> Iterator[Placed]:
    """Places to try, best first: inside (upright, then turned) and beside it (front first), or the other way round."""
    words = label.text.split()
    wrappings = [(label.text,), tuple(words)] if len(words) > 1 else [(label.text,)]
    inside, beside = _inside(label, size, wrappings), _beside(label, size, wrappings)
    yield from beside if label.is_beside else inside
    yield from inside if label.is_beside else beside


def _inside(label: Label, size: int, wrappings: Sequence[tuple[str, ...]]) -> Iterator[Placed]:
    left, top, right, bottom = label.box
    centre = ((left + right) / 2, (top + bottom) / 2)
    for lines in wrappings:
        upright = lettering(lines, size)
        for picture, is_turned in ((upright, False), (upright.transpose(Image.Transpose.ROTATE_90), True)):
            free_x, free_y = right - left + 2 - picture.width, bottom - top + 2 - picture.height
            if free_x < 0 or free_y < 0:
                continue
            for share in (0.0, -0.25, 0.25, -0.48, 0.48):
                x, y = centre[0] + share * free_x, centre[1] + share * free_y * (free_y > free_x)
                yield _centred(picture, x, y, lines, size, is_turned)


def _beside(label: Label, size: int, wrappings: Sequence[tuple[str, ...]]) -> Iterator[Placed]:
    left, top, right, bottom = label.box
    centre = ((left + right) / 2, (top + bottom) / 2)
    for direction in _around(label.front):
        for lines in wrappings:
            picture = lettering(lines, size)
            for gap in (1, 4, 12, 12 + size, 12 + 2 * size):
                x = centre[0] + direction[0] * ((right - left + picture.width) / 2 + gap)
                y = centre[1] + direction[1] * ((bottom - top + picture.height) / 2 + gap)
                for shift in (0.0, -0.3, 0.3):
                    yield _centred(picture, x + shift * picture.width * abs(direction[1]), y, lines, size, False)


def _around(front: tuple[int, int]) -> list[tuple[int, int]]:
    x, y = front
    return [(x, y), (-y, x), (y, -x), (-x, -y)]


def _centred(picture: Image.Image, x: float, y: float, lines: tuple[str, ...], size: int, is_turned: bool) -> Placed:
    left, top = round(x - picture.width / 2), round(y - picture.height / 2)
    return Placed(picture, left, top, lines, size, is_turned=is_turned)


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def shared_area(a: Box, b: Box) -> float:
    return max(0.0, min(a[2], b[2]) - max(a[0], b[0])) * max(0.0, min(a[3], b[3]) - max(a[1], b[1]))


def _overlap(a: Box, b: Box, gap: float) -> bool:
    return a[0] < b[2] + gap and b[0] < a[2] + gap and a[1] < b[3] + gap and b[1] < a[3] + gap


def _contains(outer: Box, inner: Box) -> bool:
    return outer[0] <= inner[0] and outer[1] <= inner[1] and inner[2] <= outer[2] and inner[3] <= outer[3]
