"""`decomplex-bt corpus`: annotated instructions, checked, counted and held against what is understood of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from decomplex_bt.cli.options import (
    DomainOption,
    EncoderOption,
    Format,
    FormatOption,
    JobsOption,
    JsonOption,
    SeedOption,
    chosen,
    domain_of,
)
from decomplex_bt.cli.output import print_json, track, use_utf8

if TYPE_CHECKING:
    from decomplex_bt.instruction import Instruction

app = typer.Typer(
    help="Check, count and convert annotated instructions; score how they are understood.",
    no_args_is_help=True,
    rich_markup_mode=None,
)
PathArgument = Annotated[Path, typer.Argument(metavar="PATH", help="A corpus file, or a folder of them.")]


@app.command()
def check(
    path: PathArgument, format: FormatOption = None, json: JsonOption = False, domain: DomainOption = "household"
) -> int:
    """Read a corpus and say what is wrong with it, or deserves a second look.

    A file that breaks the format ends with exit status 2 and one line that names file, line and example; remarks leave
    the exit status at 0.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.corpus import VOICES_FILE, lint, read_corpus, read_voices
    from decomplex_bt.domain.loader import load_domain

    ontology = load_domain(domain_of(domain)).ontology
    examples = read_corpus(path, ontology)
    if path.is_dir() and (path / VOICES_FILE).exists():
        read_voices(path)
    remarks = [(example, message) for example, message in lint(examples, ontology)]
    if is_json:
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
    path: PathArgument,
    voices: Annotated[bool, typer.Option("--voices", help="A line for each voice instead of the splits.")] = False,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Count a corpus: instructions, tasks, types, structures; for all and by split. JSON has the voices, too."""
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.corpus_statistics import corpus_statistics
    from decomplex_bt.domain.loader import load_domain

    statistics = corpus_statistics(path, load_domain(domain_of(domain)))
    if is_json:
        print_json(statistics.to_json())
    else:
        print(statistics.voice_table() if voices else statistics)
    return 0


@app.command()
def score(
    path: PathArgument,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
    models: Annotated[
        Path | None, typer.Option("--models", help="A folder of trained models; default: the domain's own.")
    ] = None,
    split: Annotated[
        str | None, typer.Option("--split", help="Of a folder, only the voices of train, development or test.")
    ] = None,
    noise: Annotated[bool, typer.Option("--noise", help="Also score the same instructions under noise.")] = False,
    calibration: Annotated[
        bool, typer.Option("--calibration", help="Also hold confidence against what is right.")
    ] = False,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE.png|.svg|.pdf", help="Draw the calibration; needs the extra plots.")
    ] = None,
    ask: Annotated[bool, typer.Option("--ask", help="Also ask back in doubt, and let the annotation answer.")] = False,
    encoder: EncoderOption = None,
    seed: SeedOption = 0,
    jobs: JobsOption = 1,
) -> int:
    """Understand every instruction of a corpus and score it against the annotation, simple and complex ones apart.

    Only voices that the models were not trained on say how strangers are understood; `corpus stats` shows the splits.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.cli import scoring
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.evaluation import metrics, questions, reliability, robustness
    from decomplex_bt.understanding.interpreter import Interpreter

    if plot is not None:
        reliability.check_plot(plot)
    loaded = load_domain(domain_of(domain))
    gold = [example.instruction for example in scoring.examples_of(path, split, loaded.ontology)]
    interpreter = Interpreter.load(loaded, models=models, encoder=encoder)
    texts = [instruction.text for instruction in gold]
    readings = list(track(interpreter.interpret_batch(texts, jobs=jobs), total=len(texts), label="understanding"))
    parts: list[scoring.Part] = [scoring.Scores(metrics.score_by_complexity(readings, gold))]
    if noise:
        follow = partial(_follow, total=len(gold))
        parts.append(scoring.Noise(robustness.score_noise(interpreter, gold, seed=seed, jobs=jobs, track=follow)))
    if calibration or plot is not None:
        measured = reliability.reliability(readings, gold)
        parts.append(scoring.Calibration(measured))
        if plot is not None:
            reliability.write_plot(measured, plot)
    if ask:
        parts.append(scoring.Asking(questions.score_asking(readings, gold, loaded.ontology)))
    if is_json:
        print_json({key: value for part in parts for key, value in part.to_json().items()})
    else:
        print("\n\n".join(map(str, parts)))
    return 0


@app.command()
def agreement(
    first: Annotated[
        Path | None, typer.Argument(metavar="FIRST", help="A corpus.", show_default="the domain's own")
    ] = None,
    second: Annotated[
        Path | None,
        typer.Argument(
            metavar="SECOND",
            help="Another annotation of all or some of its instructions, with the same ids.",
            show_default="the second annotation beside it",
        ),
    ] = None,
    is_listed: Annotated[bool, typer.Option("--list", help="Also list what the two do not agree on.")] = False,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Hold two annotations of the same instructions against each other, over all and by voice."""
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.corpus import SECOND_ANNOTATION, read_corpus
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.errors import DataFileError, InputError
    from decomplex_bt.evaluation import agreement as measures

    if first is not None and second is None:
        raise InputError(f"there is nothing to hold {first} against; give FIRST and SECOND, or neither")
    loaded = load_domain(domain_of(domain))
    first = first or loaded.folder / "corpus"
    second = second or loaded.folder / "corpus" / SECOND_ANNOTATION
    both = measures.matched(read_corpus(first, loaded.ontology), read_corpus(second, loaded.ontology))
    if not both:
        raise DataFileError(second, "there is no instruction in it to be held against another annotation")
    groups: dict[str, list[measures.Pair]] = {}
    for one, other in both:
        groups.setdefault(one.voice, []).append((one.instruction, other.instruction))
    whole = measures.agreement([pair for pairs in groups.values() for pair in pairs])
    by_voice = {voice: measures.agreement(pairs) for voice, pairs in sorted(groups.items())}
    listed = list(measures.disagreements(both)) if is_listed else []
    if is_json:
        lists = {"disagreements": [one.to_json() for one in listed]} if is_listed else {}
        voices = {voice: part.to_json() for voice, part in by_voice.items()}
        print_json({"all": whole.to_json(), "voices": voices, **lists})
        return 0
    print(whole)
    print(f"\n{'voice':<12}{'instructions':>14}{'tasks F1':>10}{'arguments F1':>14}{'flow identical':>16}")
    for voice, part in by_voice.items():
        tasks, arguments = part.scores.tasks.overall.value, part.scores.arguments.overall.value
        flows = f"{part.scores.flow.count}/{part.scores.flow.total}"
        print(f"{voice:<12}{part.instructions:>14}{tasks:>10.3f}{arguments:>14.3f}{flows:>16}")
    for disagreement in listed:
        print(f"\n{disagreement}")
    return 0


@app.command()
def convert(
    source: Annotated[Path, typer.Argument(metavar="IN", help="A file of annotated instructions, or a folder.")],
    target: Annotated[Path, typer.Argument(metavar="OUT", help="The file to write; for a folder, a folder.")],
    to: Annotated[str, typer.Option("--to", help="jsonl, conll, brat or yaml.")],
    force: Annotated[bool, typer.Option("--force", help="Replace files that exist already.")] = False,
    form: Annotated[
        str | None,
        typer.Option("--from", help="yaml, jsonl, conll, brat or huric.", show_default="what the names show"),
    ] = None,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Write annotated instructions in another format; nothing is written unless all of them could be, and no file is
    replaced without --force.

    yaml, jsonl, conll and brat read back as they were; huric (2.1) is only read, and brought to our conventions.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.formats import conversion

    done = conversion.convert(source, target, load_domain(domain_of(domain)), to=to, form=form, force=force)
    if is_json:
        print_json({"instructions": done.instructions, "files": [str(path) for path in done.files]})
        return 0
    shown = ", ".join(map(str, done.files[:3])) + (f" and {len(done.files) - 3} more" if len(done.files) > 3 else "")
    print(f"{done.instructions} instructions written to {shown}")
    return 0


def _follow(readings: Iterable[Instruction], label: str, *, total: int) -> Iterator[Instruction]:
    return track(readings, total=total, label=label)
