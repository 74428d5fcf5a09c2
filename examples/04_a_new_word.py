"""A domain of one's own: the household with a new word and a new place for a thing, without touching code.

Output:

    'the gamp' names nothing in this house (expected a thing); the nearest known: lamp
    1 bringing; object 'the gamp': umbrella; to 'me': user
    it lies on the bed
"""

import shutil
import tempfile
from pathlib import Path

import gymnasium as gym

import decomplex_bt
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import UnknownWordError
from decomplex_bt.planning.grounding import ground

SENTENCE = "Bring me the gamp."


def understand(domain):
    instruction = decomplex_bt.Interpreter.load(domain).interpret(SENTENCE)
    return ground(instruction, domain).tasks[0]


household = load_domain("household")
try:
    understand(household)
except UnknownWordError as error:
    print(error)

with tempfile.TemporaryDirectory() as folder:
    own = Path(folder) / "household"
    shutil.copytree(household.folder, own)
    kinds = (own / "kinds.yaml").read_text(encoding="utf-8")
    (own / "kinds.yaml").write_text(kinds.replace("words: [umbrella, ", "words: [umbrella, gamp, "), encoding="utf-8")
    house = (own / "house.yaml").read_text(encoding="utf-8")
    umbrella = "umbrella: {kind: umbrella, colour: black"
    (own / "house.yaml").write_text(
        house.replace(umbrella, f"{umbrella}, places: {{bed: 1}}, absent: 0"), encoding="utf-8"
    )
    domain = load_domain(own)
    print(understand(domain))

    env = gym.make("decomplex_bt/Household-v0", domain=domain)
    env.reset(seed=0, instruction=SENTENCE)
    world = env.unwrapped.world
    print("it lies on the", env.unwrapped.entities[world.place[env.unwrapped.entities.index("umbrella")]])
    env.close()
