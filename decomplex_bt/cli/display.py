"""How an episode is shown: a live display on a terminal, plain lines anywhere else."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Protocol

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from decomplex_bt.behaviour.conditional import IfThenElse
from decomplex_bt.behaviour.export import to_text
from decomplex_bt.instruction import escaped

if TYPE_CHECKING:
    from rich.console import Console, Group, RenderableType
    from rich.tree import Tree

    from decomplex_bt.cli.episode import Episode, Moment

SIGNS = {Status.SUCCESS: "✓", Status.FAILURE: "✗", Status.RUNNING: "●", Status.INVALID: "○"}
COLOURS = {Status.SUCCESS: "green", Status.FAILURE: "red", Status.RUNNING: "cyan", Status.INVALID: "dim"}
OUTCOME_COLOURS = {"success": "bold green", "failure": "bold red", "infeasible": "bold yellow"}
EVENTS_SHOWN = 8
STEP_SECONDS = 0.1
"""Simulated time of one step."""


class Display(Protocol):
    """What follows an episode."""

    def begin(self, episode: Episode) -> None:
        """Shows the instruction with its control flow and its tree."""

    def show(self, episode: Episode, moment: Moment) -> None:
        """Shows what changed."""

    def end(self, episode: Episode) -> None:
        """Shows the verdict."""

    def close(self) -> None:
        """Gives the terminal back, however the episode ended."""


class Silence:
    """Shows nothing (`--json`)."""

    def begin(self, episode: Episode) -> None:
        """Nothing."""

    def show(self, episode: Episode, moment: Moment) -> None:
        """Nothing."""

    def end(self, episode: Episode) -> None:
        """Nothing."""

    def close(self) -> None:
        """Nothing."""


class PlainLines:
    """Lines for a file or a pipe: one for each change worth reading."""

    def begin(self, episode: Episode) -> None:
        instruction = episode.reading.instruction
        print(f"instruction: {escaped(instruction.text)}\n\ncontrol flow:")
        print(_indented(str(instruction).splitlines()))
        print("\nbehaviour tree:")
        print(_indented(to_text(episode.agent.tree.root).splitlines()))
        print(f"\nworld {episode.seed}:", flush=True)

    def show(self, episode: Episode, moment: Moment) -> None:
        for line in happenings(episode, moment):
            print(line, flush=True)

    def end(self, episode: Episode) -> None:
        print("\nbehaviour tree at the end:")
        print(_indented(to_text(episode.agent.tree.root, show_status=True).splitlines()))
        print(f"\n{escaped(episode.verdict)}", flush=True)

    def close(self) -> None:
        """Nothing to give back."""


class LiveDisplay:
    """A display that changes in place; `speed`: times real time, 0 for as fast as it goes."""

    def __init__(self, console: Console, speed: float) -> None:
        from rich.live import Live

        self._console, self._speed = console, speed
        self._events: deque[str] = deque(maxlen=EVENTS_SHOWN)
        self._live = Live(console=console, refresh_per_second=12, transient=True)
        self._started = 0.0

    def begin(self, episode: Episode) -> None:
        from rich.panel import Panel
        from rich.text import Text

        instruction = episode.reading.instruction
        self._console.print(
            Panel(Text(escaped(instruction.text), style="bold"), title="instruction", title_align="left")
        )
        self._console.print(Panel(Text(str(instruction)), title="control flow", title_align="left"))
        self._live.start()
        self._started = time.monotonic()

    def show(self, episode: Episode, moment: Moment) -> None:
        self._events.extend(happenings(episode, moment))
        self._live.update(self._picture(episode))
        if self._speed > 0 and not moment.is_last:
            ahead = moment.seconds / self._speed - (time.monotonic() - self._started)
            time.sleep(min(max(ahead, 0.0), STEP_SECONDS / self._speed))

    def end(self, episode: Episode) -> None:
        from rich.text import Text

        self._live.stop()
        self._console.print(self._picture(episode))
        self._console.print(Text(escaped(episode.verdict), style=OUTCOME_COLOURS[episode.outcome]))

    def close(self) -> None:
        self._live.stop()

    def _picture(self, episode: Episode) -> Group:
        from rich.console import Group
        from rich.panel import Panel
        from rich.text import Text

        clock = f"world {episode.seed} · {episode.info['seconds']:.1f} s · {episode.steps} steps"
        tree: RenderableType = _rich_tree(episode.agent.tree.root, "")
        return Group(
            Panel(tree, title="behaviour tree", title_align="left", subtitle=clock, subtitle_align="right"),
            Text("\n".join(self._events), no_wrap=True, overflow="ellipsis"),
        )


def happenings(episode: Episode, moment: Moment) -> Iterator[str]:
    """A line for each task that begins or ends, each step of a plan, each condition with what was observed there."""
    return map(escaped, _happenings(episode, moment))


def _happenings(episode: Episode, moment: Moment) -> Iterator[str]:
    judged = {id(node.condition): node for node in moment.judged}
    for entry in moment.entries:
        leaf = episode.leaf_at(entry["node"])
        if leaf is None:
            continue
        clock = f"{entry['sim_seconds']:7.1f} s"
        if entry["event"] in ("finished", "interrupted"):
            yield f"{clock} {SIGNS[Status(entry['status'].upper())]} {leaf.name}: {entry['feedback'] or entry['event']}"
            if id(leaf) in judged:
                yield f"{clock} ? {_judgement(episode, judged[id(leaf)])}"
            continue
        if entry["event"] == "started":
            yield f"{clock} {SIGNS[Status.RUNNING]} {leaf.name}"
        if entry["feedback"]:
            yield f"{clock}     {entry['feedback'].removesuffix(f': {leaf.task.phrase}')}"


def _judgement(episode: Episode, node: IfThenElse) -> str:
    """A condition's outcome, the branch it leads to, and what was observed."""
    seen = episode.findings(node)
    truth = {True: "yes", False: "no", None: "cannot be decided"}[node.truth]
    branch = f", so {node.taken}" if node.taken else ", nothing to do" if node.truth is not None else ""
    return f"{node.name}: {truth}{branch}{f' ({seen})' if seen else ''}"


def _rich_tree(node: Behaviour, role: str) -> Tree:
    from rich.text import Text
    from rich.tree import Tree

    colour = COLOURS[node.status]
    label = Text.assemble(
        (f"{SIGNS[node.status]} ", colour), (f"{role}: " if role else "", "italic"), (escaped(node.name), colour)
    )
    if node.feedback_message and not node.children:
        label.append(f"  {escaped(node.feedback_message)}", style="dim")
    tree = Tree(label, guide_style="dim")
    roles = {}
    if isinstance(node, IfThenElse):
        roles = {id(node.condition): "if", id(node.then): "then", id(node.orelse): "else"}
    for child in node.children:
        tree.add(_rich_tree(child, roles.get(id(child), "")))
    return tree


def _indented(lines: Iterable[str]) -> str:
    return "\n".join(f"  {line}" for line in lines)
