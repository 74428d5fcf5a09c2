"""Pictures of vectors are well-formed documents that show what the pictures of pixels show; and the window works."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import gymnasium as gym
import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.envs.household import HouseholdEnv
from decomplex_bt.envs.registration import HOUSEHOLD
from decomplex_bt.envs.rendering.vector import Drawing, Shape, Text, VectorCanvas

GO = read_markup(
    "[Go](1:motion) [to the kitchen](1:goal) <now> & say (so) \\o/", load_domain("household").ontology, flow=[1]
)
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def env():
    env = HouseholdEnv(GO)
    env.reset(seed=3, options={"chance": False})
    return env


def test_an_svg_is_xml_with_its_texts_escaped(env):
    root = ElementTree.fromstring(env.render_svg().encode())
    words = [text.text for text in root.iter(f"{SVG}text")]
    assert GO.text in words
    assert {"fridge", "couch", "you", "0 s"} <= set(words)
    assert (root.get("width"), root.get("height")) == ("800", "700")
    assert "&lt;now&gt; &amp;" in env.render_svg()
    assert len(list(root.iter(f"{SVG}polygon"))) > 200


def test_a_change_of_the_world_shows(env):
    before = env.render_svg()
    assert env.render_svg() == before
    env.step({"drive": (1.0, 1.0), "interact": 0, "target": 0})
    assert env.render_svg() != before


def test_a_pdf_has_one_page_and_its_objects_where_it_says(env):
    document = env.render_pdf()
    assert document.startswith(b"%PDF-1.4")
    assert document.endswith(b"%%EOF\n")
    start = int(re.search(rb"startxref\n(\d+)", document)[1])
    assert document[start : start + 4] == b"xref"
    offsets = [int(offset) for offset in re.findall(rb"^(\d{10}) 00000 n", document[start:], re.MULTILINE)]
    assert [document[offset:].split(b" ", 1)[0] for offset in offsets] == [b"1", b"2", b"3", b"4", b"5"]
    length = int(re.search(rb"/Length (\d+)", document)[1])
    stream = document.split(b"stream\n", 1)[1]
    assert stream[length : length + 10] == b"\nendstream"
    assert rb"(Go to the kitchen <now> & say \(so\) \\o/) Tj" in stream


def test_any_house_can_be_drawn():
    env = HouseholdEnv(GO, size="medium", house_seed=1)
    env.reset(seed=0)
    ElementTree.fromstring(env.render_svg().encode())


def test_shapes_and_words_come_out_as_they_are():
    canvas = VectorCanvas((10.0, 20.0), 10.0)
    canvas.opacity = 0.5
    canvas.pen(1.0, 0.5).line([(0, 0), (1, 0)], (1, 2, 3), 2.0)
    canvas.opacity = 1.0
    canvas.text("a<b", 0, 0, 10, (255, 0, 0))
    shape, text = canvas.marks
    assert shape == Shape(((20.0, 15.0), (30.0, 15.0)), (1, 2, 3, 128), 2.0)
    assert isinstance(text, Text)
    svg = Drawing(50, 40, (shape, text)).to_svg()
    assert '<polyline points="20,15 30,15" fill="none" stroke="#010203" stroke-width="2" stroke-opacity="0.5"/>' in svg
    assert ">a&lt;b</text>" in svg


def test_on_the_screen_a_step_shows_at_once(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    env = gym.make(HOUSEHOLD, render_mode="human", instruction=GO)
    env.reset(seed=0)
    assert env.step({"drive": (1.0, 0.0), "interact": 0, "target": 0})[0] in env.observation_space
    assert env.render() is None
    assert env.unwrapped.camera._window is not None
    env.close()
    assert env.unwrapped.camera._window is None
    env.close()
