"""The camera: looks at a world, remembers the path driven, and gives what a render mode asks for."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np

from decomplex_bt.envs.interface import STATE_PAIRS, Interaction, Result
from decomplex_bt.envs.rendering.scene import Pose, Scene
from decomplex_bt.envs.rendering.text_map import text_map
from decomplex_bt.envs.values import choice, whole
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.envs.geometry import Geometry
    from decomplex_bt.envs.rendering.renderer import Frame, Renderer
    from decomplex_bt.envs.rendering.vector import Drawing
    from decomplex_bt.envs.rendering.window import Window
    from decomplex_bt.envs.world import World

Mode = Literal["rgb_array", "human", "ansi"]

PATH_STEP = 0.06
"""[m] The path is noted this finely."""
SPEECH_SECONDS = 2.5
"""[s] How long a speech bubble stays."""
SIZE = (800, 700)
"""Pixels: width and height of a picture where nothing else is asked for."""


class Camera:
    """Pictures of one episode after another in one house. `size`: width and height in pixels.

    `doing`, `pointed_out`, `message`: what a caller wants shown besides the world: the task at work, entities to mark,
    the words of the next speech. `sight`: range (m) and field of view (rad) of the view cone, None for none.
    """

    def __init__(
        self, geometry: Geometry, *, size: tuple[int, int] = SIZE, sight: tuple[float, float] | None = None
    ) -> None:
        if not isinstance(size, tuple | list | np.ndarray) or len(size) != 2:
            raise InputError(f"size is {size!r}; expected width and height in pixels")
        self.geometry = geometry
        self.size = whole("width", size[0], 1), whole("height", size[1], 1)
        self.sight = sight
        self._renderer: Renderer | None = None
        self._window: Window | None = None
        self.reset()

    def reset(self) -> None:
        """Forgets the last episode."""
        self.doing = ""
        self.message = ""
        self.pointed_out: tuple[str, ...] = ()
        self._path: list[tuple[float, float]] = []
        self._said, self._said_until = "", -1.0

    def note(self, world: World) -> None:
        """Takes down where the robot is and what it says; call it after every step."""
        x, y = world.robot
        if not self._path or math.hypot(x - self._path[-1][0], y - self._path[-1][1]) >= PATH_STEP:
            self._path.append((x, y))
        event = world.event
        if event is not None and event.interaction == Interaction.SAY and event.result == Result.OK:
            self._said = self.message or _words(event.goal, event.target)
            self._said_until = world.seconds + SPEECH_SECONDS

    def scene(self, world: World, *, instruction: str = "", verdict: str = "", due: str = "") -> Scene:
        """What there is to see now, hidden things included; `due` stands in where no caller said what is being done."""
        geometry = self.geometry
        names, position, place = geometry.names, world.position.tolist(), world.place.tolist()
        robot_row, first_person = geometry.robot_row, geometry.people_rows[0]
        lying = [row for row in geometry.thing_rows if 0 <= place[row] < first_person]
        carried = [row for row in geometry.thing_rows if first_person <= place[row] < robot_row]
        return Scene(
            robot=Pose(*world.robot, float(world.heading[robot_row])),
            things={names[row]: Pose(position[row][0], position[row][1]) for row in lying},
            places={names[row]: names[place[row]] for row in lying},
            people={
                names[row]: Pose(position[row][0], position[row][1], float(world.heading[row]))
                for row in geometry.people_rows
                if world.home[row]
            },
            states=_states(world),
            held=names[world.held] if world.held >= 0 else None,
            tray=tuple(names[row] if row >= 0 else None for row in world.tray),
            with_person={names[row]: names[place[row]] for row in carried},
            path=tuple(self._path),
            sight=self.sight,
            pointed_out=self.pointed_out,
            instruction=instruction,
            doing=self.doing or due,
            verdict=verdict,
            said=self._said if world.seconds <= self._said_until else "",
            seconds=world.seconds,
        )

    def show(self, scene: Scene, mode: Mode) -> Frame | str | None:
        """`(height, width, 3)` uint8 for "rgb_array", text for "ansi"; "human" puts it on the screen and gives None.

        Raises `InputError` for another mode.
        """
        choice("mode", mode, get_args(Mode))
        if mode == "ansi":
            return text_map(self.geometry, scene)
        if mode == "rgb_array":
            return self.renderer.frame(scene)
        if self._window is None:
            from decomplex_bt.envs.rendering.window import Window

            self._window = Window(self.size)
        self._window.show(self.renderer.draw(scene))
        return None

    def svg(self, scene: Scene) -> str:
        """The scene as vectors: an SVG document, its texts escaped."""
        return self._plate(scene).to_svg()

    def pdf(self, scene: Scene) -> bytes:
        """The scene as vectors: a PDF document of one page."""
        return self._plate(scene).to_pdf()

    def _plate(self, scene: Scene) -> Drawing:
        from decomplex_bt.envs.rendering.plate import draw_plate

        return draw_plate(self.geometry, scene, self.size)

    @property
    def renderer(self) -> Renderer:
        """Made when the first picture is asked for: it draws the house once."""
        if self._renderer is None:
            from decomplex_bt.envs.rendering.renderer import Renderer

            self._renderer = Renderer(self.geometry, *self.size)
        return self._renderer

    def close(self) -> None:
        """Closes the window, if there is one."""
        if self._window is not None:
            self._window.close()
            self._window = None


def _states(world: World) -> dict[tuple[str, str], str]:
    names, pairs = world.geometry.names, world.geometry.kinds.state_pairs
    return {
        (names[row], pair): pairs[pair].values[0 if value == 1 else 1]
        for row, values in enumerate(world.states.tolist())
        for pair, value in zip(STATE_PAIRS, values, strict=True)
        if value >= 0 and pair in pairs
    }


def _words(goal: str | None, target: str) -> str:
    if goal is not None:
        return f"Please lead the way to the {goal.removesuffix('_floor').replace('_', ' ')}."
    return "Please lead the way." if target == "robot" else "..."
