"""A tiny Monte-Carlo experiment: one annotated instruction in twenty drawn worlds, ours beside an oracle.

The judge goes by the annotation; the tree agent reads the text itself, the oracle knows annotation and world.

Output:

    tree: 100.0% [83.9%, 100.0%] (20/20); found open 8 times, closed 12 times
    oracle: 100.0% [83.9%, 100.0%] (20/20); found open 8 times, closed 12 times
"""

from decomplex_bt.corpus import parse_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.monte_carlo import evaluate
from decomplex_bt.evaluation.summary import summarise

CORPUS = """
- id: front-door
  text: >-
    If [the front door](1:object) [is](1:check_state) [open](1:state), [close](2:change_state)
    [it](2:object=the front door) and [tell](3:informing) [me](3:recipient).
  flow: [{if: 1, then: [2, 3]}]
"""

examples = parse_corpus(CORPUS, load_domain("household").ontology)
for agent in ("tree", "oracle"):
    rows = evaluate(examples, episodes=20, seed=0, agent=agent)
    (summary,) = summarise(rows)
    truths = [branch["truth"] for row in rows for branch in row.branches]
    print(f"{agent}: {summary.success}; found open {truths.count(True)} times, closed {truths.count(False)} times")
