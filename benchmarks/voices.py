"""How well the control flow of each voice is read by a model that never saw it, given its tasks and arguments.

    python benchmarks/voices.py [--folds 4]

The voices that are not for testing are split into folds, whole; each fold is read by a model trained on the others,
texts as they are. Prints the share of complex instructions with exactly the annotated flow, by voice, worst first. Two
minutes.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from decomplex_bt.corpus import read_corpus, read_voices
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.understanding.dependencies import FlowModel, marked_tasks, train_flow
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.training import observe


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--folds", type=int, default=4)
    folds = options.parse_args().folds
    domain, parser = load_domain("household"), Parser()
    gazetteer = Gazetteer.of(domain.lexicon, domain.kinds)
    corpus = domain.folder / "corpus"
    voices = sorted(name for name, voice in read_voices(corpus).items() if voice.split != "test")
    data = {
        name: observe([e.instruction for e in read_corpus(corpus / f"{name}.yaml", domain.ontology)], parser, gazetteer)
        for name in voices
    }
    found: dict[str, Proportion] = {}
    for fold in range(folds):
        left_out = voices[fold::folds]
        with tempfile.TemporaryDirectory() as folder:
            train_flow(Path(folder), [pair for name in voices if name not in left_out for pair in data[name]])
            model = FlowModel(Path(folder))
            for name in left_out:
                complex_ones = [(o, i) for o, i in data[name] if len(i.tasks) > 1]
                right = sum(model.find(o, marked_tasks(o, i)).flow == i.flow for o, i in complex_ones)
                found[name] = Proportion(right, len(complex_ones))
    for name in sorted(voices, key=lambda name: found[name].value or 0.0):
        print(f"{name:10} {found[name]}")
    print(f"{'all':10} {Proportion(sum(p.count for p in found.values()), sum(p.total for p in found.values()))}")


if __name__ == "__main__":
    main()
