"""Ticking by hand, with a look inside: the tree, what each leaf is doing, what the robot believes.

Output:

    → If the tv is on, turn it off. Either way tell me.
      ? if the tv is on
        · if: check that the tv is on
        · then: turn the tv off
      · tell me
    check that the tv is on: (move hallway_floor living_room_doorway hallway) (1 of 4): checking the tv
    check that the tv is on: (pass living_room_doorway hallway living_room) (2 of 4): checking the tv
    check that the tv is on: (move living_room_doorway tv living_room) (3 of 4): checking the tv
    turn the tv off: (move living_room_floor tv living_room) (1 of 2): turn the tv off
    turn the tv off: (switch-off tv) (2 of 2): turn the tv off
    tell me: (move living_room_floor living_room_doorway living_room) (1 of 6): tell me
    tell me: (pass living_room_doorway living_room hallway) (2 of 6): tell me
    tell me: (move living_room_doorway kitchen_doorway hallway) (3 of 6): tell me
    tell me: (pass kitchen_doorway hallway kitchen) (4 of 6): tell me
    tell me: (say user) (6 of 6): tell me
    tv: off
    the remote is believed at: couch
    success: True
"""

import gymnasium as gym
from py_trees.common import Status

import decomplex_bt
from decomplex_bt.behaviour.export import to_text

env = gym.make("decomplex_bt/Household-v0")
observation, info = env.reset(seed=8, instruction="If the tv is on, turn it off. Either way tell me.")
agent = decomplex_bt.TreeAgent(env)
agent.reset(observation, info)
print(to_text(agent.tree.root))

tree, session = agent.tree, agent.session
terminated = truncated = False
said = ""
while not (terminated or truncated):
    session.begin_tick(observation)
    tree.tick()  # at most one leaf runs, and leaves in the session what it wants done
    is_running = tree.root.status is Status.RUNNING
    action = session.action if is_running else session.embodiment.finish()
    leaf = tree.tip()  # the node that decided this tick
    if leaf is not None and leaf.feedback_message != said:
        said = leaf.feedback_message
        print(f"{leaf.name}: {said}")
    observation, _, terminated, truncated, info = env.step(action)

belief = session.belief  # what was observed and, of what was not seen yet, where it is likeliest
print(f"tv: {belief.state('tv', 'power')}")
print(f"the remote is believed at: {belief.place_of('remote')}")
print(f"success: {info['is_success']}")
env.close()
