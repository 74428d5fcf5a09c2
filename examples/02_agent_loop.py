"""The Gymnasium loop: a sentence in, a robot that does it, and the judge's verdict.

Output:

    world 0: success True, branches [{'task': 1, 'truth': False, 'taken': 'else'}]
    world 1: success True, branches [{'task': 1, 'truth': True, 'taken': None}]
    world 2: success True, branches [{'task': 1, 'truth': False, 'taken': 'else'}]
    world 3: success True, branches [{'task': 1, 'truth': True, 'taken': None}]
"""

import gymnasium as gym

import decomplex_bt

env = gym.make("decomplex_bt/Household-v0")
agent = decomplex_bt.TreeAgent(env)  # knows the house's map, nothing of the episode

for seed in range(4):
    observation, info = env.reset(seed=seed, instruction="Turn on the tv. If you cannot, bring me the remote.")
    agent.reset(observation, info)  # understands the instruction, compiles the tree
    while True:
        action = agent.act(observation)  # ticks the tree once
        observation, reward, terminated, truncated, info = env.step(action)
        if terminated or truncated or agent.done:
            break
    print(f"world {seed}: success {info['is_success']}, branches {info['branches']}")
env.close()
