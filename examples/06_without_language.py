"""Without language: a control flow written by hand, planned and carried out, and a picture of the end.

Output:

    judged by: gold, success: True, picture: (700, 800, 3)
"""

import tempfile
from pathlib import Path

import gymnasium as gym
from PIL import Image

import decomplex_bt
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain

instruction = read_markup(
    "[Close](1:change_state) [the front door](1:object) and [tell](2:informing) [me](2:recipient).",
    load_domain("household").ontology,
    flow=[1, 2],
)
env = gym.make("decomplex_bt/Household-v0", render_mode="rgb_array")
observation, info = env.reset(seed=5, options={"instruction": instruction, "states": {"front_door": "open"}})
agent = decomplex_bt.TreeAgent(env, flow=instruction)  # no text is parsed, no model loaded
agent.reset(observation, info)
terminated = truncated = False
while not (terminated or truncated or agent.done):
    observation, _, terminated, truncated, info = env.step(agent.act(observation))

frame = env.render()
with tempfile.TemporaryDirectory() as folder:
    Image.fromarray(frame).save(Path(folder) / "house.png")  # keep it where you like
print(f"judged by: {info['judged_by']}, success: {info['is_success']}, picture: {frame.shape}")
env.close()
