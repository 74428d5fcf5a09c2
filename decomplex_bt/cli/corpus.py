"""`decomplex-bt corpus`: annotated instructions, checked, counted and held against what is understood of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from decomplex_bt.cli.options import DomainOption, Format, FormatOption, JsonOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, track, use_utf8

if TYPE_CHECKING:
    from decomplex_bt.corpus import Example
    from decomplex_bt.evaluation.metrics import LanguageScores
    from decomplex_bt.instruction import Instruction

app = typer.Typer(
    help="Check, count and convert annotated instructions; score how they are understood.",
    no_args_is_help=True,
    rich_markup_mode=None,
)
PathArgument = Annotated[Path, typer.Argument(metavar="PATH", help="A corpus file, or a folder of them.")]


@app.command()
def check(
    path: PathArgument, format: FormatOption = Format.text, json: JsonOption = False, domain: DomainOption = "household"
) -> int:
    """Read a corpus and say what is wrong with it, or deserves a second look.

    A file that breaks the format ends with exit status 2 and one line that names file, line and example; remarks leave
    the exit status at 0.
    """
    use_utf8()
    from decomplex_bt.corpus import VOICES_FILE, lint, read_corpus, read_voices
    from decomplex_bt.domain.loader import load_domain

    ontology = load_domain(domain_of(domain)).ontology
    examples = read_corpus(path, ontology)
    if path.is_dir() and (path / VOICES_FILE).exists():
        read_voices(path)
    remarks = [(example, message) for example, message in lint(examples, ontology)]
    if chosen(format, json) is Format.json:
        print_json(
            {
                "path": str(path),
                "instructions": len(examples),
                "remarks": [{"voice": e.voice, "id": e.id, "remark": message} for e, message in remarks],
            }
        )
        return 0
    for example, message in remarks:
        print(f"{example.voice}: {example.id}: {message}")
    print(f"{path}: {len(examples)} instructions, no errors, {len(remarks)} remarks")
    return 0


@app.command()
def stats(
    path: PathArgument, format: FormatOption = Format.text, json: JsonOption = False, domain: DomainOption = "household"
) -> int:
    """Count a corpus: instructions, tasks, types, structures; for all, by split and by voice."""
    use_utf8()
    from decomplex_bt.corpus_statistics import corpus_statistics
    from decomplex_bt.domain.loader import load_domain

    statistics = corpus_statistics(path, load_domain(domain_of(domain)))
    if chosen(format, json) is Format.json:
        print_json(statistics.to_json())
    else:
        print(statistics)
    return 0


@app.command()
def score(
    path: PathArgument,
    format: FormatOption = Format.text,
    json: JsonOption = False,
    domain: DomainOption = "household",
    models: Annotated[
        Path | None, typer.Option("--models", help="A folder of trained models; default: the domain's own.")
    ] = None,
) -> int:
    """Understand every instruction of a corpus and score it against the annotation, simple and complex ones apart.

    Only voices that the models were not trained on say how strangers are understood; `corpus stats` shows the splits.
    """
    use_utf8()
    from decomplex_bt.corpus import read_corpus
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.understanding.interpreter import Interpreter

    loaded = load_domain(domain_of(domain))
    examples = read_corpus(path, loaded.ontology)
    interpreter = Interpreter.load(loaded, models=models)
    texts = [example.instruction.text for example in examples]
    readings = list(track(interpreter.interpret_batch(texts), total=len(texts), label="understanding"))
    scores = _scores_by_complexity(examples, readings)
    if chosen(format, json) is Format.json:
        print_json({name: {"instructions": n, **part.to_json()} for name, (n, part) in scores.items()})
        return 0
    for name, (n, part) in scores.items():
        print(f"{name}: {n} instructions")
        print(f"  F1: tasks {part.tasks.overall.value:.3f}, arguments {part.arguments.overall.value:.3f}, "
              f"dependencies {part.dependencies.overall.value:.3f}")  # fmt: skip
        print(f"  control flow exactly right: {part.flow}; and all argument values: {part.strict}")
        print(f"  ordering error rate: {part.oer:.3f}")
    return 0


@app.command()
def convert(
    source: Annotated[Path, typer.Argument(metavar="IN", help="A file of annotated instructions, or a folder.")],
    target: Annotated[Path, typer.Argument(metavar="OUT", help="The file to write; for a folder, a folder.")],
    to: Annotated[str, typer.Option("--to", help="jsonl, conll, brat or yaml.")],
    form: Annotated[
        str | None,
        typer.Option("--from", help="yaml, jsonl, conll, brat or huric.", show_default="what the names show"),
    ] = None,
    format: FormatOption = Format.text,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Write annotated instructions in another format; nothing is written unless all of them could be.

    yaml, jsonl, conll and brat read back as they were; huric (2.1) is only read, and brought to our conventions.
    """
    use_utf8()
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.formats import conversion

    done = conversion.convert(source, target, load_domain(domain_of(domain)), to=to, form=form)
    if chosen(format, json) is Format.json:
        print_json({"instructions": done.instructions, "files": [str(path) for path in done.files]})
        return 0
    shown = ", ".join(map(str, done.files[:3])) + (f" and {len(done.files) - 3} more" if len(done.files) > 3 else "")
    print(f"{done.instructions} instructions written to {shown}")
    return 0


def _scores_by_complexity(
    examples: Sequence[Example], readings: Sequence[Instruction]
) -> dict[str, tuple[int, LanguageScores]]:
    """Number and scores of all instructions, of simple, complex and long ones; empty groups are left out."""
    from decomplex_bt.evaluation import metrics

    pairs = [(reading, example.instruction) for example, reading in zip(examples, readings, strict=True)]
    groups = {
        "all": pairs,
        "one task or none": [pair for pair in pairs if len(pair[1].tasks) < 2],
        "complex": [pair for pair in pairs if len(pair[1].tasks) >= 2],
        "above five tasks": [pair for pair in pairs if len(pair[1].tasks) > 5],
    }
    return {
        name: (len(group), metrics.score([found for found, _ in group], [wanted for _, wanted in group]))
        for name, group in groups.items()
        if group
    }
