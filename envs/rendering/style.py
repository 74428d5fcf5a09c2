"""Colours and sizes of the pictures, in one place. Colours are (red, green, blue), 0 to 255; lengths in metres."""

from __future__ import annotations

Colour = tuple[int, int, int]

PAPER: Colour = (250, 249, 246)
INK: Colour = (58, 63, 74)
FADED_INK: Colour = (122, 127, 138)
WALL: Colour = (78, 84, 98)
SHADOW: Colour = (70, 70, 90)

ROOMS: dict[str, Colour] = {
    "kitchen": (252, 241, 219),
    "living room": (232, 241, 226),
    "bedroom": (229, 233, 247),
    "bathroom": (219, 239, 243),
    "study": (246, 230, 232),
    "hallway": (240, 236, 229),
}
OTHER_ROOMS: tuple[Colour, ...] = ((238, 232, 245), (245, 238, 221), (226, 240, 236), (240, 234, 228))

WOOD: Colour = (219, 190, 150)
DARK_WOOD: Colour = (182, 145, 104)
STONE: Colour = (214, 212, 206)
WHITE_GOODS: Colour = (244, 246, 248)
STEEL: Colour = (186, 193, 202)
DARK: Colour = (72, 78, 92)
CLOTH: Colour = (155, 176, 196)
CUSHION: Colour = (183, 200, 215)
LINEN: Colour = (250, 250, 252)
WICKER: Colour = (214, 178, 128)
GLASS_PANE: Colour = (150, 205, 232)
CURTAIN: Colour = (214, 150, 140)
WARM: Colour = (255, 196, 84)
SCREEN: Colour = (112, 190, 255)
EMBER: Colour = (240, 96, 56)
RUNNING: Colour = (70, 184, 120)

ROBOT_BODY: Colour = (247, 250, 252)
ROBOT_ACCENT: Colour = (22, 138, 148)
ROBOT_EYE: Colour = (30, 52, 64)
VIEW: tuple[int, int, int, int] = (36, 150, 170, 34)
VIEW_EDGE: tuple[int, int, int, int] = (36, 150, 170, 90)
TRAIL: Colour = (22, 138, 148)
POINTER: Colour = (230, 80, 60)

VERDICTS: dict[str, Colour] = {"success": (46, 150, 90), "failure": (204, 70, 58), "infeasible": (150, 120, 60)}

COLOURS: dict[str, Colour] = {
    "red": (216, 72, 66),
    "blue": (72, 122, 204),
    "green": (86, 164, 100),
    "yellow": (244, 204, 72),
    "white": (250, 250, 248),
    "black": (62, 64, 72),
    "grey": (158, 164, 172),
    "gray": (158, 164, 172),
    "brown": (150, 104, 66),
    "orange": (240, 150, 60),
    "pink": (236, 150, 176),
    "purple": (146, 104, 186),
    "silver": (200, 206, 214),
    "gold": (218, 178, 72),
    "clear": (206, 232, 240),
}
"""What the colour words of a house file look like."""

OF_KIND: dict[str, Colour] = {
    "newspaper": (236, 234, 226),
    "magazine": (236, 160, 176),
    "letter": (252, 250, 240),
    "keys": (218, 178, 72),
    "glasses": (84, 88, 100),
    "fork": (190, 196, 206),
    "spoon": (190, 196, 206),
    "knife": (176, 184, 196),
    "coffee": (112, 72, 46),
    "tea": (190, 132, 60),
    "milk": (246, 248, 252),
    "water": (126, 190, 228),
    "juice": (246, 166, 52),
    "soup": (226, 138, 70),
    "orange": (244, 148, 44),
    "bread": (214, 160, 92),
    "sandwich": (232, 202, 140),
    "medicine": (236, 120, 96),
    "toy": (196, 142, 92),
    "soap": (190, 226, 200),
    "toilet paper": (250, 250, 250),
}
"""Colours of things whose house entry names none."""
PLAIN_THING: Colour = (190, 176, 200)

PEOPLE: tuple[Colour, ...] = ((94, 118, 190), (206, 104, 128), (104, 158, 96), (206, 150, 70), (140, 120, 170))
"""Clothes of people, in the order of the house file; the user comes first."""
HAIR: tuple[Colour, ...] = ((74, 56, 46), (150, 92, 50), (50, 50, 56), (120, 112, 108), (200, 170, 110))
SKIN: Colour = (244, 212, 184)

MARGIN = 0.28
"""Paper around the house."""
ICON_RADIUS = 0.125
"""Things are drawn at least this large: true to scale a pen would be two pixels."""
TRAIL_STEP = 0.16
"""Distance between the dots of the path driven."""


def thing_colour(kind: str, colour: str | None) -> Colour:
    """The colour a thing is drawn in, by the word in the house file or else by its kind."""
    if colour is not None and colour in COLOURS:
        return COLOURS[colour]
    return OF_KIND.get(kind, PLAIN_THING)


def darker(colour: Colour, share: float = 0.3) -> Colour:
    """`colour` with this share of black mixed in, from 0 to 1."""
    return mix(colour, (0, 0, 0), share)


def lighter(colour: Colour, share: float = 0.4) -> Colour:
    """`colour` with this share of white mixed in, from 0 to 1."""
    return mix(colour, (255, 255, 255), share)


def mix(first: Colour, second: Colour, share: float) -> Colour:
    """`first` with this share of `second`, from 0 to 1."""
    red, green, blue = (round(a + (b - a) * share) for a, b in zip(first, second, strict=True))
    return red, green, blue
