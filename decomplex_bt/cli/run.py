"""`decomplex-bt run`: one instruction carried out in one world."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from decomplex_bt.cli.options import (
    DomainOption,
    Format,
    FormatOption,
    JsonOption,
    SeedOption,
    TextArgument,
    ThresholdOption,
    chosen,
    domain_of,
)
from decomplex_bt.cli.output import print_json, remark, use_utf8

if TYPE_CHECKING:
    from decomplex_bt.cli.display import Display

ENVIRONMENT = "decomplex_bt/Household-v0"


def run(
    text: TextArgument,
    seed: SeedOption = 0,
    record: Annotated[Path | None, typer.Option(metavar="FILE.gif|.mp4", help="Write a film of the episode.")] = None,
    window: Annotated[bool, typer.Option("--window", help="Show the house in a window.")] = False,
    speed: Annotated[
        float, typer.Option(min=0.0, help="Of the live display, times real time; 0: as fast as it goes.")
    ] = 10.0,
    format: FormatOption = None,
    json: JsonOption = False,
    threshold: ThresholdOption = None,
    domain: DomainOption = "household",
) -> int:
    """Carry out one instruction in one world: its control flow, its tree at work, what was observed, the verdict.

    Exit status 0: success, by the robot's own reading of the text; 1: failure, or infeasible in this world.
    """
    use_utf8()
    import gymnasium as gym

    from decomplex_bt.cli.episode import Episode
    from decomplex_bt.cli.film import Film
    from decomplex_bt.cli.reading import read

    if window:
        from decomplex_bt.envs.rendering.window import check_screen

        check_screen()
    is_json = chosen(format, json, Format.text) is Format.json
    film = Film(record) if record is not None else None
    reading = read(text, domain_of(domain), may_ask=not is_json, threshold=threshold)
    render_mode = "human" if window else "rgb_array" if film else None
    env = gym.make(ENVIRONMENT, domain=reading.domain, render_mode=render_mode, disable_env_checker=True)
    display = _display(is_json, speed)
    try:
        episode = Episode(env, reading, seed, has_pictures=render_mode is not None)
        display.begin(episode)
        for moment in episode.play():
            display.show(episode, moment)
            if film is not None and film.is_due(episode.steps - 1):
                film.add(episode.picture())
        display.end(episode)
        if film is not None:
            film.close(episode.picture())
            remark(f"film: {record}")
        if is_json:
            print_json(episode.to_json())
        return 0 if episode.outcome == "success" else 1
    finally:
        if film is not None:
            film.discard()
        display.close()
        env.close()


def _display(is_json: bool, speed: float) -> Display:
    from decomplex_bt.cli.display import LiveDisplay, PlainLines, Silence

    if is_json:
        return Silence()
    if not sys.stdout.isatty():
        return PlainLines()
    from rich.console import Console

    return LiveDisplay(Console(), speed)
