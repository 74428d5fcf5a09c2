"""From text to an understood instruction; `interpreter` is the chain, the other modules are its stages and tools.

`rules`: what English settles of tasks and arguments. `control_flow`: clauses, labels, the tree. `references`: what
words refer to. `encoder`: the networks. `recombination`: copies to learn from.
"""
