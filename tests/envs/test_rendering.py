"""Pictures: right size and kind, everything that can be in a house can be drawn, and a change of the world shows."""

from __future__ import annotations

import dataclasses
import math
import os
import time
from typing import get_args

import numpy as np
import pygame
import pytest

from decomplex_bt.domain.kinds import Shape
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.geometry import Geometry
from decomplex_bt.envs.rendering import Camera, Pose, Scene
from decomplex_bt.envs.rendering.figures import ICONS
from decomplex_bt.envs.rendering.lettering import printable, shorten, text_size, wrap
from decomplex_bt.envs.rendering.renderer import Renderer
from decomplex_bt.envs.rendering.sight import view_polygon
from decomplex_bt.envs.rendering.text_map import text_map
from decomplex_bt.envs.rendering.window import Window, check_screen
from decomplex_bt.errors import InputError


@pytest.fixture(scope="module")
def geometry() -> Geometry:
    domain = load_domain("household")
    return Geometry(domain.house, domain.kinds)


@pytest.fixture(scope="module")
def scene(geometry: Geometry) -> Scene:
    """Every thing on its own spot, every state at its first value, everybody at home."""
    house, kinds = geometry.house, geometry.kinds
    things = {name: Pose(0.5 + 0.18 * number, 4.6) for number, name in enumerate(house.things)}
    states = {
        (name, pair): kinds.state_pairs[pair].values[0]
        for name in geometry.names[:-1]
        for pair in house.kind(name, kinds).states
    }
    people = {name: Pose(5.0 + number, 6.5, 1.0) for number, name in enumerate(house.people)}
    return Scene(
        robot=Pose(2.0, 6.3, 0.5),
        things=things,
        people=people,
        states=states,
        sight=(5.0, math.radians(200)),
        path=((1.0, 6.0), (2.0, 6.3)),
        instruction="Bring me the café crème ☕ — please",
        doing="look for the cup",
    )


@pytest.fixture(scope="module")
def renderer(geometry: Geometry) -> Renderer:
    return Renderer(geometry, 400, 360)


@pytest.mark.parametrize(("width", "height"), [(64, 64), (97, 301), (512, 512)])
def test_frame_has_the_size_asked_for(geometry: Geometry, scene: Scene, width: int, height: int) -> None:
    frame = Renderer(geometry, width, height).frame(scene)
    assert frame.shape == (height, width, 3)
    assert frame.dtype == np.uint8
    assert frame.flags.writeable
    assert frame.std() > 10  # something is on it


def test_same_scene_gives_the_same_picture(geometry: Geometry, renderer: Renderer, scene: Scene) -> None:
    assert np.array_equal(renderer.frame(scene), Renderer(geometry, 400, 360).frame(scene))


@pytest.mark.parametrize(
    "change",
    [
        {"robot": Pose(2.0, 6.3, 3.0)},
        {"held": "mug_1"},
        {"tray": (None, "pen_1", None, None)},
        {"sight": None},
        {"path": ()},
        {"people": {}},
        {"things": {}},
        {"doing": "something else"},
        {"verdict": "failure"},
        {"said": "Hello."},
        {"pointed_out": ("cup_1",)},
        {"with_person": {"pen_1": "anna"}},
    ],
    ids=lambda change: next(iter(change)),
)
def test_change_of_scene_shows(renderer: Renderer, scene: Scene, change: dict) -> None:
    assert not np.array_equal(renderer.frame(scene), renderer.frame(dataclasses.replace(scene, **change)))


def test_every_state_of_a_place_shows(renderer: Renderer, geometry: Geometry, scene: Scene) -> None:
    bare = dataclasses.replace(scene, things={}, people={}, sight=None)
    kinds = geometry.kinds
    for name, pair in scene.states:
        if name in geometry.house.things or pair == "cleanliness":
            continue
        other = {**scene.states, (name, pair): kinds.state_pairs[pair].values[1]}
        changed = renderer.frame(dataclasses.replace(bare, states=other))
        assert not np.array_equal(renderer.frame(bare), changed), f"{name} looks the same whatever its {pair}"


def test_every_shape_that_a_kinds_file_can_name_is_drawn() -> None:
    assert set(get_args(Shape)) == set(ICONS)


def test_too_small_a_picture_is_refused(geometry: Geometry) -> None:
    with pytest.raises(ValueError, match="64 x 64"):
        Renderer(geometry, 800, 10)


@pytest.mark.parametrize("size", [None, (100,), (100, 0), (3.5, 100), ("a", 1), 100], ids=str)
def test_a_size_that_is_none_is_refused(geometry: Geometry, size: object) -> None:
    with pytest.raises(InputError, match="expected"):
        Camera(geometry, size=size)


def test_numpys_numbers_are_a_size(geometry: Geometry, scene: Scene) -> None:
    assert Camera(geometry, size=np.array((200, 100))).show(scene, "rgb_array").shape == (100, 200, 3)


def test_a_mode_that_is_none_is_refused(geometry: Geometry, scene: Scene) -> None:
    with pytest.raises(InputError, match="'svg'; expected one of rgb_array, human, ansi"):
        Camera(geometry).show(scene, "svg")


def test_view_stops_at_a_wall() -> None:
    wall = np.array([[2.0, -1.0, 2.0, 1.0]])
    outline = view_polygon(0.0, 0.0, 0.0, 5.0, math.pi, wall)
    ahead = outline[np.abs(np.arctan2(outline[:, 1], outline[:, 0])) < 0.3][1:]
    assert ahead[:, 0] == pytest.approx(2.0)
    assert np.hypot(*outline.T).max() == pytest.approx(5.0)


def test_view_does_not_leak_past_a_closed_door(geometry: Geometry, renderer: Renderer, scene: Scene) -> None:
    """From the hallway, with both doors closed, no picture element of the bathroom changes with the view."""
    looking = dataclasses.replace(
        scene, things={}, people={}, path=(), said="", robot=Pose(5.8, 4.5, -math.pi / 2),
        states={**scene.states, ("bathroom_door", "aperture"): "closed"},
    )  # fmt: skip
    x0, y0, x1, y1 = geometry.house.rooms["bathroom"].rect
    left, top, right, bottom = (round(v) for v in renderer.layout.box((x0 + 0.1, y0 + 0.1, x1 - 0.1, y1 - 0.1)))
    seen, blind = renderer.frame(looking), renderer.frame(dataclasses.replace(looking, sight=None))
    assert not np.array_equal(seen, blind)
    assert np.array_equal(seen[top:bottom, left:right], blind[top:bottom, left:right])


def test_text_map_shows_robot_people_and_caption(geometry: Geometry, scene: Scene) -> None:
    drawn = text_map(geometry, scene)
    assert "→" in drawn or "↗" in drawn
    assert "@u" in drawn
    assert drawn.endswith("0.0 s · look for the cup")


def test_window_works_without_a_screen(geometry: Geometry, scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    camera = Camera(geometry, size=(200, 180))
    assert camera.show(scene, "human") is None
    assert camera.show(scene, "human") is None
    camera.close()
    camera.close()


def test_each_window_is_its_own(geometry: Geometry, scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    cameras = [Camera(geometry, size=size) for size in ((200, 180), (300, 280), (400, 380))]
    for camera in cameras:
        camera.show(scene, "human")
    first, second, third = (camera._window for camera in cameras)
    cameras[0].close()
    pygame.event.post(pygame.Event(pygame.WINDOWCLOSE, window=second._window))
    for camera in cameras[1:] * 2:
        camera.show(scene, "human")
    assert [window._window is None for window in (first, second, third)] == [True, True, False]
    assert third._window.get_surface().get_size() == (400, 380)
    assert np.array_equal(
        pygame.surfarray.array3d(third._window.get_surface()).swapaxes(0, 1), cameras[2].renderer.frame(scene)
    )
    cameras[2].close()
    assert not pygame.display.get_init()


def test_window_without_a_driver_is_a_clear_error(geometry: Geometry, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonesuch")
    with pytest.raises(InputError, match="no window"):
        Window((200, 180))


def test_a_window_nobody_can_see_is_refused_to_who_asks_for_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    check_screen()
    monkeypatch.setattr("decomplex_bt.envs.rendering.window.os.environ", {})
    with pytest.raises(InputError, match="no display"):
        check_screen()


def test_what_the_libraries_behind_a_window_print_stays_unseen(monkeypatch: pytest.MonkeyPatch, capfd) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setattr("pygame.display.init", lambda: os.write(2, b"error: XDG_RUNTIME_DIR"))
    monkeypatch.setattr("pygame.display.get_driver", lambda: "dummy")
    check_screen()
    os.write(2, b"heard again")
    assert capfd.readouterr().err == "heard again"


def test_captions_survive_any_text() -> None:
    assert printable("café ☕ “x”\n…") == 'cafe ? "x" ...'
    assert text_size(shorten("x" * 500, 12, 100), 12)[0] <= 100
    assert len(wrap("word " * 200, 12, 300, 2)) == 2
    assert wrap("", 12, 300, 2) == []


def test_frames_are_quick(geometry: Geometry, scene: Scene) -> None:
    """Catches disasters only: a frame took 2 ms where 50 are allowed."""
    renderer = Renderer(geometry, 512, 512)
    renderer.frame(scene)
    start = time.perf_counter()
    for _ in range(10):
        renderer.frame(scene)
    assert (time.perf_counter() - start) / 10 < 0.05


@pytest.mark.parametrize("text", ["x" * 1900, "Bring me the cup, " * 60, "short"])
def test_what_is_too_long_is_cut_to_the_width(text: str) -> None:
    cut = shorten(text, 14, 300)
    assert text_size(cut, 14)[0] <= 300
    assert cut == text or (cut.endswith("...") and text_size(f"{text[: len(cut)]}...", 14)[0] > 300)
