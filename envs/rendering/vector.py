"""Vectors: shapes and texts as they are drawn, kept as values, and written as SVG or as a page of PDF.

`VectorCanvas` is drawn on by the same pens as a canvas of pixels, so that both kinds of pictures look alike. Units are
those of the picture, y down; colours (red, green, blue, opacity), each 0 to 255.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape

from decomplex_bt.envs.rendering.canvas import Ink, Pen, Point
from decomplex_bt.envs.rendering.lettering import text_size

Rgba = tuple[int, int, int, int]

ASCENT = 0.93
"""Share of a line's size from its top to its baseline."""


@dataclass(frozen=True, slots=True)
class Shape:
    """A polygon that is filled, or a line that is drawn `width` wide with round ends."""

    points: tuple[Point, ...]
    ink: Rgba
    width: float = 0.0


@dataclass(frozen=True, slots=True)
class Text:
    """One line of text, `length` long, from its baseline's left end; `is_turned`: it runs upwards."""

    words: str
    at: Point
    size: float
    length: float
    ink: Rgba
    is_turned: bool = False


@dataclass(frozen=True, slots=True)
class Drawing:
    """All marks of a picture, the lowest first."""

    width: float
    height: float
    marks: tuple[Shape | Text, ...]

    def to_svg(self) -> str:
        """The picture as an SVG document; texts are escaped."""
        body = "\n".join(_svg_shape(mark) if isinstance(mark, Shape) else _svg_text(mark) for mark in self.marks)
        return (
            '<?xml version="1.0" encoding="UTF-8"?>\n'
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(self.width)}" height="{_n(self.height)}" '
            f'viewBox="0 0 {_n(self.width)} {_n(self.height)}" stroke-linecap="round" stroke-linejoin="round" '
            f"font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n{body}\n</svg>\n"
        )

    def to_pdf(self) -> bytes:
        """The picture as a PDF document of one page, a point for each unit."""
        opacities = sorted({mark.ink[3] for mark in self.marks})
        states = {opacity: f"G{opacity}" for opacity in opacities}
        height = self.height
        lines = ["1 J 1 j"]
        for mark in self.marks:
            lines.append(f"/{states[mark.ink[3]]} gs")
            lines.append(_pdf_shape(mark, height) if isinstance(mark, Shape) else _pdf_text(mark, height))
        content = "\n".join(lines).encode("ascii")
        shades = " ".join(f"/{name} << /ca {_n(o / 255)} /CA {_n(o / 255)} >>" for o, name in states.items())
        return _pdf_file(
            [
                b"<< /Type /Catalog /Pages 2 0 R >>",
                b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
                (
                    f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {_n(self.width)} {_n(self.height)}] /Contents 4 0 R "
                    f"/Resources << /Font << /F 5 0 R >> /ExtGState << {shades} >> >> >>"
                ).encode("ascii"),
                b"<< /Length %d >>\nstream\n%s\nendstream" % (len(content), content),
                b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
            ]
        )


class VectorCanvas:
    """A canvas of vectors, `scale` units a metre; the world's (0, 0) lies at `origin`. `opacity`: of all ink."""

    def __init__(self, origin: Point, scale: float) -> None:
        self.origin = origin
        self.scale = self.fine = scale
        self.opacity = 1.0
        self.marks: list[Shape | Text] = []
        self.draw = self

    def pen(self, x: float = 0.0, y: float = 0.0, heading: float = 0.0) -> Pen:
        """A pen whose own frame has its origin here (metres) and its x axis along `heading`."""
        return Pen(self, x, y, heading)  # type: ignore[arg-type]  # the part of a canvas that a pen needs

    def pixels(self, points: Iterable[Point]) -> list[Point]:
        """World metres to units of the picture."""
        x0, y0 = self.origin
        return [(x0 + x * self.scale, y0 - y * self.scale) for x, y in points]

    # -- what pens call, in the words of Pillow -----------------------------------------------------------------------

    def polygon(self, points: Sequence[Point], fill: Ink) -> None:
        self.marks.append(Shape(tuple(points), self._ink(fill)))

    def line(self, points: Sequence[Point], fill: Ink, width: float, joint: str | None = None) -> None:
        self.marks.append(Shape(tuple(points), self._ink(fill), float(width)))

    def ellipse(self, box: tuple[float, float, float, float], fill: Ink) -> None:
        """Round ends of lines: lines of vectors have them anyway."""

    # -- what is written ----------------------------------------------------------------------------------------------

    def text(self, words: str, left: float, top: float, size: float, ink: Ink, *, is_turned: bool = False) -> None:
        """One line with its top left corner there; turned, with its bottom left corner there."""
        length = float(text_size(words, round(size))[0])
        at = (left + ASCENT * size, top) if is_turned else (left, top + ASCENT * size)
        if words.strip():
            self.marks.append(Text(words, at, size, length, self._ink(ink), is_turned))

    def _ink(self, ink: Ink) -> Rgba:
        red, green, blue, *rest = ink
        return red, green, blue, round((rest[0] if rest else 255) * self.opacity)


def _svg_shape(shape: Shape) -> str:
    points = " ".join(f"{_n(x)},{_n(y)}" for x, y in shape.points)
    colour, opacity = _svg_ink(shape.ink)
    if shape.width:
        faded = f' stroke-opacity="{opacity}"' if opacity else ""
        return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{_n(shape.width)}"{faded}/>'
    faded = f' fill-opacity="{opacity}"' if opacity else ""
    return f'<polygon points="{points}" fill="{colour}"{faded}/>'


def _svg_text(text: Text) -> str:
    colour, _ = _svg_ink(text.ink)
    x, y = _n(text.at[0]), _n(text.at[1])
    turn = f' transform="rotate(-90 {x} {y})"' if text.is_turned else ""
    return (
        f'<text x="{x}" y="{y}" font-size="{_n(text.size)}" textLength="{_n(text.length)}" '
        f'lengthAdjust="spacingAndGlyphs" fill="{colour}" xml:space="preserve"{turn}>{escape(text.words)}</text>'
    )


def _svg_ink(ink: Rgba) -> tuple[str, str]:
    return "#{:02x}{:02x}{:02x}".format(*ink[:3]), "" if ink[3] == 255 else _n(ink[3] / 255)


def _pdf_shape(shape: Shape, height: float) -> str:
    (first, *others), (red, green, blue) = shape.points, (_n(value / 255) for value in shape.ink[:3])
    path = [f"{_n(first[0])} {_n(height - first[1])} m", *(f"{_n(x)} {_n(height - y)} l" for x, y in others)]
    if shape.width:
        return f"{red} {green} {blue} RG {_n(shape.width)} w {' '.join(path)} S"
    return f"{red} {green} {blue} rg {' '.join(path)} h f"


def _pdf_text(text: Text, height: float) -> str:
    red, green, blue = (_n(value / 255) for value in text.ink[:3])
    words = text.words.encode("cp1252", "replace").decode("latin-1")
    escaped = "".join(
        f"\\{letter}" if letter in "()\\" else letter if " " <= letter <= "~" else f"\\{ord(letter):03o}"
        for letter in words
    )
    turn = "0 1 -1 0" if text.is_turned else "1 0 0 1"
    stretch = 100 * text.length / max(1e-6, _helvetica(words) * text.size)
    return (
        f"BT {red} {green} {blue} rg /F {_n(text.size)} Tf {_n(stretch)} Tz "
        f"{turn} {_n(text.at[0])} {_n(height - text.at[1])} Tm ({escaped}) Tj ET"
    )


def _helvetica(words: str) -> float:
    """The width of words in Helvetica, in sizes of its letters."""
    return sum(_WIDTHS.get(letter, 556) for letter in words) / 1000


_WIDTHS = {
    letter: width
    for width, letters in (
        (222, "ijl'`"), (278, " !,./:;I[\\]ft|"), (333, "()-r"), (355, '"'), (389, "*"), (334, "{}"),
        (500, "Jcksvxyz"), (584, "+<=>~"), (611, "FTZ"), (667, "&ABEKPSVXY"), (722, "CDHNRUw"), (778, "GOQ"),
        (833, "Mm"), (889, "%"), (944, "W"), (1015, "@"), (469, "^"),
    )
    for letter in letters
}  # fmt: skip


def _pdf_file(objects: Sequence[bytes]) -> bytes:
    """A PDF document of these objects, numbered from 1; the first is its catalogue."""
    parts = [b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n"]
    offsets = []
    for number, body in enumerate(objects, start=1):
        offsets.append(sum(map(len, parts)))
        parts.append(b"%d 0 obj\n%s\nendobj\n" % (number, body))
    start = sum(map(len, parts))
    parts.append(b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1))
    parts.extend(b"%010d 00000 n \n" % offset for offset in offsets)
    parts.append(b"trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (len(objects) + 1, start))
    return b"".join(parts)


def _n(value: float) -> str:
    """A number, short."""
    return f"{value:.2f}".rstrip("0").rstrip(".") or "0"
