"""How many words that refer, and arguments left unsaid, are resolved rightly where all else is given as annotated.

    python benchmarks/references.py VOICE.yaml ...

Prints, without and with what the encoder adds where it is installed: of the words that refer and of what is left unsaid
how many have their likeliest filling, or none, as annotated. What no phrase of the instruction can fill is left out, so
figures compare only where the same words are taken to refer.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import DecomplexError
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.understanding.coreference import REFERENCES_FILE, Choice, ReferenceModel, choices_of, likeliest
from decomplex_bt.understanding.damage import ENCODER_FOLDER
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import has_encoder

Found = tuple[Observed, dict[int, str], Choice]
"""An instruction, its tasks by their tokens, and one of its choices."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("corpus", nargs="+", type=Path, help="files of annotated instructions")
    parser.add_argument("--domain", default="household")
    arguments = parser.parse_args()
    try:
        domain = load_domain(arguments.domain)
        models = domain.folder / "models"
        references = ReferenceModel(models / REFERENCES_FILE, domain.ontology)
        found = [each for path in arguments.corpus for each in choices_in(path, domain)]
    except DecomplexError as error:
        parser.error(str(error))
    report("without the encoder", found, [references.scores(choice.options) for *_, choice in found])
    if has_encoder(models):
        from decomplex_bt.understanding.encoder.model import EncoderModel
        from decomplex_bt.understanding.encoder.referents import load_references

        folder = models / ENCODER_FOLDER
        hints = load_references(folder, EncoderModel(folder), domain.ontology)
        added = [hints.scores(observed, tasks, c.gap, c.options) for observed, tasks, c in found]
        scores = [
            [one + other for one, other in zip(references.scores(c.options), more, strict=True)]
            for (*_, c), more in zip(found, added, strict=True)
        ]
        report("with the encoder", found, scores)


def choices_in(path: Path, domain: Domain) -> Iterator[Found]:
    """The choices of all instructions in a file."""
    parser, gazetteer = Parser(), Gazetteer.of(domain.lexicon, domain.kinds)
    for example in read_corpus(path, domain.ontology):
        observed = Observed(parser.parse(example.instruction.text), gazetteer)
        tasks = {task.token: task.type for task in marked_tasks(observed, example.instruction)}
        for choice in choices_of(observed, example.instruction, domain.ontology):
            yield observed, tasks, choice


def report(name: str, found: list[Found], scores: list[list[float]]) -> None:
    """Prints how many of the words that refer, and of what is unsaid, have their best option right."""
    print(f"{name}:")
    for label, is_said in (("words that refer", True), ("left unsaid", False)):
        rights = [
            choice.right[likeliest(choice.options, own)[0]]
            for (*_, choice), own in zip(found, scores, strict=True)
            if bool(choice.gap.word) is is_said
        ]
        print(f"  {label:18} {Proportion(sum(rights), len(rights))}")


if __name__ == "__main__":
    main()
