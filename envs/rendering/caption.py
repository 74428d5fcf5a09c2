"""What is written over and under the house: speech, the instruction, the task at work, the clock."""

from __future__ import annotations

import pygame

from decomplex_bt.envs.rendering import style
from decomplex_bt.envs.rendering.layout import CAPTION_LINES, Layout
from decomplex_bt.envs.rendering.lettering import doing_of, printable, shorten, text_size, wrap
from decomplex_bt.envs.rendering.scene import Scene
from decomplex_bt.envs.rendering.sprites import bubble, put, text


def draw_caption(surface: pygame.Surface, layout: Layout, scene: Scene) -> None:
    """The band below the house; its colour tells the verdict."""
    if not layout.caption_height:
        return
    size, pad = layout.caption_size, round(layout.caption_size * 0.8)
    colour = style.VERDICTS.get(scene.verdict, style.ROBOT_ACCENT)
    top, width = layout.house_height, layout.width - 3 * pad
    pygame.draw.rect(surface, (255, 255, 255), (0, top, layout.width, layout.caption_height))
    pygame.draw.line(surface, (222, 220, 214), (0, top), (layout.width, top))
    pygame.draw.rect(surface, colour, (0, top, max(4, size // 3), layout.caption_height))
    for number, line in enumerate(wrap(printable(scene.instruction), size, width, CAPTION_LINES)):
        put(surface, text(line, size), 2 * pad, top + size * (0.5 + 1.28 * number))
    bottom = layout.height - size * 1.75
    clock = f"{scene.seconds:.0f} s"
    clock_width = text_size(clock, size)[0]
    put(surface, text(clock, size, style.FADED_INK), layout.width - pad - clock_width, bottom)
    put(surface, text(shorten(doing_of(scene), size, width - clock_width - pad), size, colour), 2 * pad, bottom)


def draw_speech(surface: pygame.Surface, layout: Layout, scene: Scene) -> None:
    """A bubble above the robot while it speaks."""
    if not scene.said or not layout.caption_height:
        return
    size = max(9, layout.caption_size - 2)
    lines = tuple(wrap(printable(scene.said), size, round(layout.width * 0.34), 3))
    picture = bubble(lines, size)
    x, y = layout.pixel(scene.robot.x, scene.robot.y)
    left = min(max(4, x - picture.get_width() // 2), layout.width - picture.get_width() - 4)
    put(surface, picture, left, max(4, y - 0.32 * layout.scale - picture.get_height()))
