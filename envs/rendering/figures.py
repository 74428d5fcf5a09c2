"""Small figures that move: things by their shape, people, the robot; each drawn around its pen, facing +x."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from decomplex_bt.domain.kinds import Shape
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.canvas import Pen
from decomplex_bt.envs.rendering.style import Colour, darker, lighter

Icon = Callable[[Pen, float, Colour], None]


def draw_thing(pen: Pen, shape: Shape, radius: float, colour: Colour, states: Mapping[str, str]) -> None:
    """A thing's icon of this radius (m), with specks where it is dirty, steam where hot, contents where full."""
    if shape == "cup":
        _cup(pen, radius, colour, is_full=states.get("fill") == "full")
    else:
        ICONS[shape](pen, radius, colour)
    if states.get("cleanliness") == "dirty":
        for x, y in ((-0.35, 0.1), (0.15, -0.35), (0.3, 0.3)):
            pen.disc(x * radius, y * radius, radius * 0.14, (120, 92, 58))
    if states.get("temperature") == "hot":
        for x in (-0.35, 0.35):
            steam = [(radius * (x + 0.16 * math.sin(step * 1.6)), radius * (0.85 + 0.2 * step)) for step in range(5)]
            pen.line(steam, (232, 96, 70), 1.3)


def draw_person(pen: Pen, radius: float, clothes: Colour, hair: Colour) -> None:
    """A person of this radius (m) from above: shoulders, arms and head, looking along +x."""
    line = darker(clothes, 0.35)
    for side in (-1, 1):
        pen.ellipse(
            radius * 0.42, side * radius * 0.72, radius * 0.34, radius * 0.2, style.SKIN, darker(style.SKIN, 0.3), 1.0
        )
    pen.ellipse(0, 0, radius * 0.52, radius, clothes, line, 1.3)
    pen.disc(radius * 0.1, 0, radius * 0.46, style.SKIN, darker(style.SKIN, 0.35), 1.0)
    cap = [
        (radius * (0.06 + 0.46 * math.cos(a)), radius * 0.46 * math.sin(a)) for a in _angles(1.15, 2 * math.pi - 1.15)
    ]
    pen.polygon(cap, hair, darker(hair, 0.3), 1.0)


def draw_robot(pen: Pen, radius: float, *, is_holding: bool) -> None:
    """The robot of this radius (m): a round body, two eyes to the front, a gripper, and a tray at the back."""
    accent = style.ROBOT_ACCENT
    spread = 0.2 if is_holding else 0.12
    for side in (-1, 1):
        arm = [
            (radius * 0.8, side * radius * 0.3),
            (radius * 1.22, side * radius * (spread + 0.24)),
            (radius * 1.42, side * radius * spread),
        ]
        pen.line(arm, darker(accent, 0.35), 3.4)
        pen.line(arm, accent, 2.0)
    for side in (-1, 1):
        pen.box(
            -radius * 0.45, side * radius * 0.86, radius * 0.45, side * radius * 1.08, style.DARK, None, radius=0.03
        )
    pen.disc(0, 0, radius, style.ROBOT_BODY, darker(accent, 0.25), 1.8)
    pen.arc(0, 0, radius * 0.84, -0.95, 0.95, accent, 2.6)
    pen.box(-radius * 0.72, -radius * 0.5, radius * 0.16, radius * 0.5, lighter(accent, 0.78), accent, 1.0, radius=0.06)
    for side in (-1, 1):
        pen.disc(radius * 0.5, side * radius * 0.26, radius * 0.13, style.ROBOT_EYE)
        pen.disc(radius * 0.54, side * radius * 0.23, radius * 0.045, (255, 255, 255))


def tray_slots(count: int, radius: float) -> list[tuple[float, float]]:
    """Where the things on the tray are drawn, in the robot's own frame, metres; two in a row."""
    rows = max(1, math.ceil(count / 2))
    return [
        (radius * (-0.28 + 0.42 * ((rows - 1) / 2 - slot // 2)), radius * (0.25 if slot % 2 == 0 else -0.25))
        for slot in range(count)
    ]


def _angles(start: float, end: float) -> list[float]:
    return [start + (end - start) * step / 24 for step in range(25)]


def _cup(pen: Pen, r: float, colour: Colour, *, is_full: bool) -> None:
    line = darker(colour, 0.42)
    pen.disc(r * 0.68, 0, r * 0.32, None, line, 2.4)
    pen.disc(-r * 0.1, 0, r * 0.75, colour, line, 1.3)
    pen.disc(-r * 0.1, 0, r * 0.52, (116, 168, 206) if is_full else darker(colour, 0.18), line, 1.0)


def _bottle(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.42)
    pen.box(-r * 0.4, -r, r * 0.4, r * 0.36, colour, line, 1.3, radius=r * 0.22)
    pen.box(-r * 0.18, r * 0.3, r * 0.18, r * 0.8, colour, line, 1.0)
    pen.box(-r * 0.24, r * 0.72, r * 0.24, r, darker(colour, 0.45), None)
    pen.box(-r * 0.4, -r * 0.6, r * 0.4, -r * 0.02, lighter(colour, 0.65), line, 1.0)


def _plate(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.35)
    pen.disc(0, 0, r, colour, line, 1.3)
    pen.disc(0, 0, r * 0.62, lighter(colour, 0.25), darker(colour, 0.18), 1.0)


def _bar(pen: Pen, r: float, colour: Colour) -> None:
    bar = pen.at(0, 0, math.radians(35))
    line = darker(colour, 0.42)
    bar.box(-r, -r * 0.2, r * 0.62, r * 0.2, colour, line, 1.2, radius=r * 0.08)
    bar.polygon([(r * 0.62, -r * 0.2), (r * 1.02, 0), (r * 0.62, r * 0.2)], (238, 214, 172), line, 1.0)
    bar.line([(-r * 0.7, -r * 0.2), (-r * 0.7, r * 0.2)], line, 1.2)


def _book(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.42)
    pen.box(-r * 0.72, -r * 0.92, r * 0.8, r * 0.92, (250, 248, 240), line, 1.0, radius=r * 0.08)
    pen.box(-r * 0.8, -r * 0.92, r * 0.68, r * 0.92, colour, line, 1.3, radius=r * 0.08)
    pen.line([(-r * 0.55, -r * 0.9), (-r * 0.55, r * 0.9)], line, 1.0)
    pen.box(-r * 0.3, r * 0.2, r * 0.42, r * 0.55, lighter(colour, 0.6), None)


def _box(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.4)
    pen.box(-r * 0.85, -r * 0.7, r * 0.85, r * 0.7, colour, line, 1.3, radius=r * 0.18)
    pen.box(-r * 0.6, -r * 0.46, r * 0.6, r * 0.14, lighter(colour, 0.45), None, radius=r * 0.1)


def _paper(pen: Pen, r: float, colour: Colour) -> None:
    pen.box(-r * 0.75, -r * 0.95, r * 0.75, r * 0.95, lighter(colour, 0.55), darker(colour, 0.4), 1.2)
    for step, reach in enumerate((0.5, 0.5, 0.3)):
        y = r * (0.5 - 0.42 * step)
        pen.line([(-r * 0.5, y), (r * reach, y)], (140, 146, 158), 1.1)


def _ball(pen: Pen, r: float, colour: Colour) -> None:
    pen.disc(0, 0, r * 0.82, colour, darker(colour, 0.4), 1.3)
    pen.ellipse(-r * 0.28, r * 0.3, r * 0.24, r * 0.18, lighter(colour, 0.65), None)


def _ring(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.4)
    pen.disc(-r * 0.1, 0, r * 0.82, colour, line, 1.2)
    pen.disc(-r * 0.1, 0, r * 0.42, (255, 255, 255), line, 1.2)


def _cloth(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.35)
    wave = [
        (
            r * (0.92 + 0.09 * math.cos(6 * a)) * _squarish(math.cos(a)),
            r * (0.8 + 0.09 * math.sin(6 * a)) * _squarish(math.sin(a)),
        )
        for a in (2 * math.pi * step / 48 for step in range(48))
    ]
    pen.polygon(wave, colour, line, 1.2)
    pen.line([(-r * 0.5, r * 0.25), (-r * 0.1, r * 0.38), (r * 0.5, r * 0.2)], line, 1.0)
    pen.line([(-r * 0.45, -r * 0.25), (0, -r * 0.12), (r * 0.5, -r * 0.3)], line, 1.0)


def _squarish(value: float) -> float:
    return math.copysign(abs(value) ** 0.55, value)


def _pan(pen: Pen, r: float, colour: Colour) -> None:
    line = darker(colour, 0.4)
    pen.at(0, 0, math.radians(-40)).box(
        r * 0.4, -r * 0.14, r * 1.2, r * 0.14, darker(colour, 0.25), line, 1.0, radius=r * 0.1
    )
    pen.disc(-r * 0.15, r * 0.12, r * 0.74, colour, line, 1.3)
    pen.disc(-r * 0.15, r * 0.12, r * 0.54, lighter(colour, 0.25), None)


def _disc(pen: Pen, r: float, colour: Colour) -> None:
    pen.disc(0, 0, r * 0.85, colour, darker(colour, 0.4), 1.3)
    for side in (-1, 1):
        pen.disc(side * r * 0.52, r * 0.58, r * 0.28, colour, darker(colour, 0.4), 1.1)
        pen.disc(side * r * 0.26, r * 0.12, r * 0.1, style.INK)
    pen.ellipse(0, -r * 0.28, r * 0.3, r * 0.2, lighter(colour, 0.5), None)


ICONS: dict[Shape, Icon] = {
    "cup": lambda pen, r, colour: _cup(pen, r, colour, is_full=False),
    "bottle": _bottle,
    "plate": _plate,
    "bar": _bar,
    "book": _book,
    "box": _box,
    "paper": _paper,
    "ball": _ball,
    "ring": _ring,
    "cloth": _cloth,
    "pan": _pan,
    "disc": _disc,
}
"""How each shape that `kinds.yaml` can name is drawn."""
