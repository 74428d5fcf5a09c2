"""How furniture looks from above, by kind: drawn in its own frame with +x to the front, from where it is used.

Every drawing takes half the depth `d` (along x) and half the width `w` (along y), metres, and the states it shows
(state pair to value). A kind without a drawing of its own is drawn by what it can do, so any house can be shown.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from decomplex_bt.domain.kinds import Kind
from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.canvas import Pen, outline_of
from decomplex_bt.envs.rendering.style import Colour, darker, lighter

States = Mapping[str, str]
Drawing = Callable[[Pen, float, float, States], None]


def draw_furniture(pen: Pen, kind_name: str, kind: Kind, depth: float, width: float, states: States) -> None:
    """One piece, `pen` at its centre and turned to its front; `depth` and `width` in metres."""
    drawing = DRAWINGS.get(kind_name) or _by_ability(kind)
    drawing(pen, depth / 2, width / 2, states)


def glow_of(kind_name: str) -> tuple[Colour, float] | None:
    """Colour and radius (m) of the light that a device of this kind sheds when it is on; None for none."""
    if kind_name.split()[-1] == "light":
        return style.WARM, CEILING_REACH
    return GLOWS.get(kind_name)


CEILING_REACH = 2.1
"""[m] How far a ceiling light shines, from the middle of its room."""
GLOWS: dict[str, tuple[Colour, float]] = {
    "lamp": (style.WARM, 1.3),
    "tv": (style.SCREEN, 1.1),
    "computer": (style.SCREEN, 0.6),
    "oven": (style.EMBER, 0.45),
    "stove": (style.EMBER, 0.45),
    "heater": (style.EMBER, 0.7),
    "microwave": (style.WARM, 0.45),
}


def _by_ability(kind: Kind) -> Drawing:
    if kind.inside:
        return _cabinet if kind.has_door else _bin
    if kind.is_device:
        return _device
    return _table


def _slab(pen: Pen, d: float, w: float, fill: Colour, radius: float = 0.05) -> None:
    pen.box(-d, -w, d, w, fill, outline_of(fill), 1.2, radius=radius)


def _table(pen: Pen, d: float, w: float, states: States, fill: Colour = style.WOOD) -> None:
    _slab(pen, d, w, fill, 0.07)
    inset = min(0.06, d / 3, w / 3)
    pen.box(-d + inset, -w + inset, d - inset, w - inset, None, (*darker(fill, 0.12), 255), 1.0, radius=0.05)


def _counter(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.STONE, 0.03)
    pen.line([(d - 0.05, -w), (d - 0.05, w)], darker(style.STONE, 0.14), 1.0)


def _desk(pen: Pen, d: float, w: float, states: States) -> None:
    _table(pen, d, w, states, style.DARK_WOOD)


def _shelf(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.DARK_WOOD, 0.02)
    rest = lighter(style.DARK_WOOD, 0.35)
    pen.box(-d + 0.03, -w + 0.03, d - 0.03, w - 0.03, rest, None)
    count = max(1, round(w / 0.25))
    for step in range(1, count):
        y = -w + 2 * w * step / count
        pen.line([(-d + 0.03, y), (d - 0.03, y)], darker(rest, 0.2), 1.0)


def _couch(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.CLOTH, 0.12)
    back, arm = min(0.24, d * 0.55), min(0.2, w * 0.3)
    seats = max(1, round((w - arm) / 0.42))
    step = 2 * (w - arm) / seats
    for seat in range(seats):
        y = -w + arm + seat * step
        pen.box(
            -d + back, y + 0.015, d - 0.05, y + step - 0.015, style.CUSHION, darker(style.CLOTH, 0.2), 1.0, radius=0.07
        )


def _bed(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.WOOD, 0.06)
    pen.box(-d + 0.08, -w + 0.05, d - 0.05, w - 0.05, style.LINEN, darker(style.LINEN, 0.15), 1.0, radius=0.08)
    for side in (-1, 1):
        y = side * w / 2
        pen.box(-d + 0.16, y - w * 0.36, -d + 0.52, y + w * 0.36, (236, 240, 247), (178, 186, 200), 1.0, radius=0.1)
    blanket = style.CLOTH
    pen.box(-d + 0.72, -w + 0.03, d - 0.03, w - 0.03, blanket, outline_of(blanket), 1.0, radius=0.08)
    pen.box(-d + 0.72, -w + 0.03, -d + 0.92, w - 0.03, lighter(blanket, 0.35), outline_of(blanket), 1.0, radius=0.05)


def _sink(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.STEEL, 0.06)
    basin = (226, 236, 241)
    pen.box(-d * 0.55, -w * 0.78, d * 0.78, w * 0.78, basin, darker(style.STEEL, 0.25), 1.0, radius=0.09)
    pen.disc(d * 0.1, 0, 0.022, darker(style.STEEL, 0.4))
    pen.line([(-d * 0.85, 0), (-d * 0.2, 0)], darker(style.STEEL, 0.45), 2.4)


def _cabinet(pen: Pen, d: float, w: float, states: States, fill: Colour = style.DARK_WOOD) -> None:
    """Two leaves at the front, swung out when open."""
    _slab(pen, d, w, fill, 0.03)
    inner = lighter(fill, 0.3)
    pen.box(
        -d + 0.04,
        -w + 0.04,
        d - 0.04,
        w - 0.04,
        inner if states.get("aperture") == "open" else lighter(fill, 0.12),
        None,
        radius=0.02,
    )
    line = outline_of(fill)
    if states.get("aperture") == "open":
        reach = min(w * 0.95, 0.42)
        for side in (-1, 1):
            pen.line([(d, side * w), (d + reach * 0.9, side * (w + reach * 0.3))], line, 2.4)
        return
    pen.line([(d, -w), (d, w)], line, 2.2)
    pen.line([(-d + 0.04, 0), (d, 0)], line, 1.0)
    for side in (-1, 1):
        pen.disc(d - 0.05, side * 0.05, 0.02, line)


def _drawer(pen: Pen, d: float, w: float, states: States) -> None:
    """A drawer front, pulled out when open."""
    fill, line = style.DARK_WOOD, outline_of(style.DARK_WOOD)
    pull = 0.24 if states.get("aperture") == "open" else 0.0
    if pull:
        pen.box(-d + pull, -w, d + pull, w, fill, line, 1.2, radius=0.02)
        pen.box(-d + pull + 0.04, -w + 0.04, d + pull - 0.05, w - 0.04, lighter(fill, 0.45), None, radius=0.02)
    else:
        pen.box(-d, -w, d, w, fill, line, 1.2, radius=0.02)
    pen.line([(d + pull - 0.02, -w * 0.4), (d + pull - 0.02, w * 0.4)], line, 2.2)


def _appliance(pen: Pen, d: float, w: float, states: States) -> None:
    """A white box whose front flap hangs open, or is closed, with a small lamp when it runs."""
    _slab(pen, d, w, style.WHITE_GOODS, 0.05)
    line = darker(style.STEEL, 0.2)
    if states.get("aperture") == "open":
        flap = min(0.34, 2 * d)
        pen.box(d, -w * 0.92, d + flap, w * 0.92, darker(style.WHITE_GOODS, 0.07), line, 1.0, radius=0.03)
        pen.box(-d + 0.05, -w + 0.05, d - 0.03, w - 0.05, darker(style.STEEL, 0.12), line, 1.0, radius=0.03)
    else:
        pen.line([(d - 0.06, -w * 0.75), (d - 0.06, w * 0.75)], line, 2.0)
    _running_lamp(pen, -d + 0.07, w - 0.08, states)


def _fridge(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.WHITE_GOODS, 0.06)
    line = darker(style.STEEL, 0.25)
    if states.get("aperture") == "open":
        pen.box(-d + 0.06, -w + 0.06, d - 0.04, w - 0.06, (214, 236, 246), line, 1.0, radius=0.03)
        pen.line([(d, w - 0.02), (d + 1.5 * w, w - 0.02 + 0.25 * w)], line, 4.0)
        return
    pen.line([(d - 0.09, -w), (d - 0.09, w)], line, 1.2)
    pen.line([(d - 0.04, -w * 0.75), (d - 0.04, -w * 0.2)], line, 2.4)


def _washing_machine(pen: Pen, d: float, w: float, states: States) -> None:
    _appliance(pen, d, w, states)
    ring = style.SCREEN if states.get("power") == "on" else style.STEEL
    pen.disc(-d * 0.05, 0, min(d, w) * 0.5, lighter(style.GLASS_PANE, 0.4), ring, 2.2)


def _microwave(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.STEEL, 0.04)
    pane = style.WARM if states.get("power") == "on" else style.DARK
    if states.get("aperture") == "open":
        pen.box(-d + 0.04, -w + 0.04, d - 0.03, w * 0.5, lighter(style.STEEL, 0.5), None, radius=0.02)
        pen.line([(d, w), (d + 0.26, w + 0.12)], outline_of(style.STEEL), 2.6)
    else:
        pen.box(-d * 0.55, -w * 0.45, d * 0.7, w * 0.85, pane, None, radius=0.03)
    for step in (-0.4, 0.1, 0.6):
        pen.disc(d * step, -w * 0.74, 0.02, outline_of(style.STEEL))


def _oven(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.STEEL, 0.04)
    hot = states.get("power") == "on"
    if states.get("aperture") == "open":
        pen.box(
            d,
            -w * 0.85,
            d + 0.3,
            w * 0.85,
            style.EMBER if hot else style.DARK,
            outline_of(style.STEEL),
            1.2,
            radius=0.03,
        )
    else:
        pen.box(d - 0.1, -w * 0.8, d - 0.02, w * 0.8, style.EMBER if hot else style.DARK, None, radius=0.02)


def _stove(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.DARK, 0.04)
    for x in (-d * 0.48, d * 0.48):
        for y in (-w * 0.5, w * 0.5):
            ring = style.EMBER if states.get("power") == "on" else lighter(style.DARK, 0.45)
            pen.disc(x, y, min(d * 0.4, w * 0.36), None, ring, 1.6)


def _coffee_machine(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.DARK, 0.05)
    pen.disc(-d * 0.25, 0, w * 0.5, lighter(style.DARK, 0.25), lighter(style.DARK, 0.5), 1.0)
    pen.disc(d * 0.5, 0, w * 0.34, (238, 238, 236), (120, 120, 126), 1.0)
    _running_lamp(pen, -d * 0.7, w * 0.7, states)


def _bin(pen: Pen, d: float, w: float, states: States, fill: Colour = style.STEEL) -> None:
    _slab(pen, d, w, fill, 0.3)
    depth = 0.3 if states.get("fill") == "full" else 0.12
    pen.box(-d * 0.74, -w * 0.74, d * 0.74, w * 0.74, darker(fill, depth), outline_of(fill), 1.0, radius=0.25)
    if states.get("fill") == "full":
        for x, y, colour in (
            (-0.3, 0.2, (236, 234, 226)),
            (0.25, -0.25, (196, 160, 110)),
            (0.2, 0.35, (160, 190, 150)),
        ):
            pen.disc(x * d, y * w, min(d, w) * 0.3, colour, darker(colour, 0.3), 1.0)


def _basket(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.WICKER, 0.16)
    pen.box(
        -d * 0.72, -w * 0.72, d * 0.72, w * 0.72, darker(style.WICKER, 0.2), outline_of(style.WICKER), 1.0, radius=0.12
    )
    for step in range(12):
        angle = step * math.pi / 6
        x, y = math.cos(angle), math.sin(angle)
        reach = 1 / max(abs(x), abs(y))
        pen.line(
            [(x * d * 0.74 * reach, y * w * 0.74 * reach), (x * d * 0.95 * reach, y * w * 0.95 * reach)],
            outline_of(style.WICKER),
            1.0,
        )


def _crate(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.WOOD, 0.02)
    pen.box(-d + 0.06, -w + 0.06, d - 0.06, w - 0.06, darker(style.WOOD, 0.22), outline_of(style.WOOD), 1.0)


def _tv(pen: Pen, d: float, w: float, states: States) -> None:
    pen.box(-d, -w * 0.8, d * 0.35, w * 0.8, style.DARK_WOOD, outline_of(style.DARK_WOOD), 1.2, radius=0.03)
    screen = style.SCREEN if states.get("power") == "on" else style.DARK
    pen.box(-d * 0.1, -w, d * 0.4, w, style.DARK, darker(style.DARK, 0.3), 1.2, radius=0.03)
    pen.line([(d * 0.42, -w * 0.95), (d * 0.42, w * 0.95)], screen, 2.6)


def _lamp(pen: Pen, d: float, w: float, states: States) -> None:
    shade = style.WARM if states.get("power") == "on" else (236, 230, 216)
    radius = min(d, w) * 0.95
    pen.disc(0, 0, radius, shade, darker(shade, 0.35), 1.2)
    pen.disc(0, 0, radius * 0.4, lighter(shade, 0.6), darker(shade, 0.2), 1.0)


def _wall_switch(pen: Pen, d: float, w: float, states: States) -> None:
    is_on = states.get("power") == "on"
    fill = style.WARM if is_on else (238, 238, 240)
    pen.box(-0.05, -0.085, 0.05, 0.085, fill, style.DARK, 1.2, radius=0.03)
    pen.disc(0, 0.035 if is_on else -0.035, 0.028, style.DARK)


def _radio(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, (206, 120, 96), 0.04)
    for side in (-1, 1):
        pen.disc(d * 0.05, side * w * 0.52, min(d * 0.6, w * 0.36), (92, 74, 70), None)
    _running_lamp(pen, -d * 0.6, 0, states)


def _computer(pen: Pen, d: float, w: float, states: States) -> None:
    is_on = states.get("power") == "on"
    pen.box(-d, -w * 0.85, -d * 0.55, w * 0.85, style.DARK, darker(style.DARK, 0.3), 1.0, radius=0.02)
    pen.line([(-d * 0.5, -w * 0.78), (-d * 0.5, w * 0.78)], style.SCREEN if is_on else lighter(style.DARK, 0.3), 2.2)
    pen.box(d * 0.05, -w * 0.7, d * 0.75, w * 0.5, (222, 226, 232), (150, 156, 166), 1.0, radius=0.02)
    pen.ellipse(d * 0.4, w * 0.72, d * 0.22, w * 0.11, (222, 226, 232), (150, 156, 166), 1.0)


def _fan(pen: Pen, d: float, w: float, states: States) -> None:
    radius = min(d, w)
    fill = (226, 232, 238)
    pen.disc(0, 0, radius, fill, outline_of(style.STEEL), 1.2)
    blade = style.SCREEN if states.get("power") == "on" else style.STEEL
    for step in range(3):
        pen.at(0, 0, step * 2 * math.pi / 3).ellipse(radius * 0.45, 0, radius * 0.42, radius * 0.2, blade, None)
    pen.disc(0, 0, radius * 0.16, style.DARK)


def _heater(pen: Pen, d: float, w: float, states: States) -> None:
    fill = (250, 214, 196) if states.get("power") == "on" else style.WHITE_GOODS
    _slab(pen, d, w, fill, 0.04)
    rib = style.EMBER if states.get("power") == "on" else style.STEEL
    count = max(3, round(w / 0.06))
    for step in range(1, count):
        y = -w + 2 * w * step / count
        pen.line([(-d * 0.6, y), (d * 0.6, y)], rib, 1.6)


def _device(pen: Pen, d: float, w: float, states: States) -> None:
    _slab(pen, d, w, style.STEEL, 0.05)
    _running_lamp(pen, 0, 0, states, radius=min(d, w, 0.12) * 0.5)


def _window(pen: Pen, d: float, w: float, states: States) -> None:
    """A pane in the wall; two casements stand into the room when it is open."""
    frame = (236, 240, 244)
    pen.box(-0.09, -w, 0.03, w, frame, style.WALL, 1.0)
    if states.get("aperture") == "open":
        for side in (-1, 1):
            pen.line([(0.02, side * w), (0.02 + w * 0.5, side * w * 0.62)], style.GLASS_PANE, 3.0)
            pen.line([(0.02, side * w), (0.02 + w * 0.5, side * w * 0.62)], darker(style.GLASS_PANE, 0.35), 1.0)
        return
    pen.box(-0.055, -w + 0.04, -0.005, w - 0.04, style.GLASS_PANE, darker(style.GLASS_PANE, 0.3), 1.0)
    pen.line([(-0.06, 0), (0.0, 0)], style.WALL, 1.4)


def _curtains(pen: Pen, d: float, w: float, states: States) -> None:
    """A wavy band: across when closed, gathered at both ends when open."""
    spans = ((-w, -w * 0.66), (w * 0.66, w)) if states.get("aperture") == "open" else ((-w, w),)
    for low, high in spans:
        count = max(6, round((high - low) / 0.025))
        wave = [(0.02 + 0.025 * math.sin(step * 1.9), low + (high - low) * step / count) for step in range(count + 1)]
        pen.line(wave, darker(style.CURTAIN, 0.25), 4.2)
        pen.line(wave, style.CURTAIN, 2.8)


def _front_door(pen: Pen, d: float, w: float, states: States) -> None:
    pen.box(-0.11, -w, 0.01, w, style.PAPER, None)
    draw_leaf(pen.at(-0.05, -w, math.pi / 2), 2 * w, is_open=states.get("aperture") == "open", turn=-1)


def draw_leaf(pen: Pen, length: float, *, is_open: bool, turn: int) -> None:
    """A door leaf hinged at the pen, closed along its x axis, open swung by 80 degrees towards `turn` (+1 or -1)."""
    angle = turn * math.radians(80) if is_open else 0.0
    if is_open:
        pen.arc(0, 0, length, 0.0, angle, (*style.WALL, 90), 1.0)
    leaf = pen.at(0, 0, angle)
    leaf.box(0, -0.035, length, 0.035, (196, 150, 104), outline_of(style.DARK_WOOD), 1.2, radius=0.02)
    leaf.disc(length - 0.09, -0.055 * turn, 0.024, style.DARK)


def _running_lamp(pen: Pen, x: float, y: float, states: States, radius: float = 0.032) -> None:
    if "power" in states:
        is_on = states["power"] == "on"
        pen.disc(x, y, radius, style.RUNNING if is_on else (206, 208, 212), darker(style.STEEL, 0.3), 1.0)


DRAWINGS: dict[str, Drawing] = {
    "kitchen table": _table,
    "coffee table": _table,
    "hallway table": _table,
    "nightstand": _table,
    "counter": _counter,
    "desk": _desk,
    "bookshelf": _shelf,
    "bathroom shelf": _shelf,
    "couch": _couch,
    "armchair": _couch,
    "bed": _bed,
    "sink": _sink,
    "fridge": _fridge,
    "cupboard": _cabinet,
    "wardrobe": _cabinet,
    "medicine cabinet": _cabinet,
    "drawer": _drawer,
    "desk drawer": _drawer,
    "dishwasher": _appliance,
    "washing machine": _washing_machine,
    "microwave": _microwave,
    "oven": _oven,
    "stove": _stove,
    "coffee machine": _coffee_machine,
    "trash can": _bin,
    "laundry basket": _basket,
    "basket": _basket,
    "box": _crate,
    "tv": _tv,
    "lamp": _lamp,
    "kitchen light": _wall_switch,
    "bedroom light": _wall_switch,
    "bathroom light": _wall_switch,
    "radio": _radio,
    "computer": _computer,
    "fan": _fan,
    "heater": _heater,
    "window": _window,
    "curtains": _curtains,
    "front door": _front_door,
}
"""Kinds with a drawing of their own."""
