"""`decomplex-bt evaluate`: instructions times worlds, and how often the robot succeeds."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Annotated

import typer

from decomplex_bt.cli.options import (
    DomainOption,
    Format,
    FormatOption,
    JobsOption,
    JsonOption,
    SeedOption,
    chosen,
    domain_of,
    number_up_to,
)
from decomplex_bt.cli.output import print_json, remark, use_utf8
from decomplex_bt.errors import DataFileError, InputError

if TYPE_CHECKING:
    from decomplex_bt.evaluation.monte_carlo import Progress
    from decomplex_bt.evaluation.row import Row
    from decomplex_bt.evaluation.summary import Summary

READINGS = ("own", "gold")
FAILURES_SHOWN = 30
"""Failures that are printed, each with its cause."""


def evaluate(
    corpus: Annotated[Path, typer.Argument(metavar="CORPUS", help="A corpus file, or a folder of them.")],
    episodes: Annotated[int, typer.Option("--episodes", "-n", help="Worlds for each instruction.")] = 20,
    seed: SeedOption = 0,
    jobs: JobsOption = 1,
    agent: Annotated[
        list[str], typer.Option(help="tree, oracle (knows the world), random or idle; several in the same worlds.")
    ] = ["tree"],  # noqa: B006 - typer reads the default, and nobody changes it
    reading: Annotated[str, typer.Option(help="Whose reading the tree goes by: own or gold.")] = "own",
    limit: Annotated[int | None, typer.Option(min=1, help="Only the first so many instructions.")] = None,
    grounded: Annotated[bool, typer.Option("--grounded", help="Leave out what asks for what the house lacks.")] = False,
    noise: Annotated[bool, typer.Option("--noise/--no-noise", help="Slips and misses, as the house has them.")] = True,
    slips: Annotated[
        float | None, typer.Option(callback=number_up_to(1.0), help="How likely a grasp slips, in [0, 1].")
    ] = None,
    misses: Annotated[
        float | None, typer.Option(callback=number_up_to(1.0), help="How likely a look misses a thing, in [0, 1].")
    ] = None,
    meddling: Annotated[
        float, typer.Option(callback=number_up_to(60.0), help="Things somebody else moves in a minute, on average.")
    ] = 0.0,
    output: Annotated[Path | None, typer.Option(help="A folder for rows.jsonl and summary.json.")] = None,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Run every instruction of a corpus in many worlds, judged by the corpus' own reading: the success rate.

    World k of an instruction has the seed SEED + k; the numbers are the same for any number of jobs.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.corpus import read_corpus
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.evaluation import monte_carlo, report
    from decomplex_bt.evaluation.summary import summarise

    if reading not in READINGS:
        raise InputError(f"--reading {reading}: expected one of {', '.join(READINGS)}")
    setup = monte_carlo.Setup(
        domain=domain_of(domain), noise=noise, grasp_slip=slips, missed_detection=misses, meddling=meddling
    )
    if output is not None:
        report.prepare_output(output)
    try:
        examples = read_corpus(corpus, load_domain(domain_of(domain)).ontology)
    except DataFileError as error:
        raise InputError(f"{error}{_way_to_a_corpus(corpus)}") from None
    if grounded:
        read, examples = len(examples), monte_carlo.those_that_ground(examples, load_domain(domain_of(domain)))
        remark(f"{len(examples)} of {read} instructions ground in the house; the others are left out")
    examples = examples[:limit]
    with _progress() as progress:
        rows = monte_carlo.evaluate_agents(
            examples,
            agent,
            episodes=episodes,
            seed=seed,
            jobs=jobs,
            reading="own" if reading == "own" else "gold",
            setup=setup,
            progress=progress,
        )
    settings = {
        "corpus": str(corpus),
        "episodes": episodes,
        "seed": seed,
        "agent": agent[0] if len(agent) == 1 else agent,
        "reading": reading,
        **setup.options(),
    }
    if output is not None:
        for path in report.write_results(output, rows, settings):
            remark(f"written: {path}")
    if is_json:
        print_json(report.summary_json(rows, settings))
    else:
        _print(summarise(rows))
        _print_failures(rows)
    return 0


def _way_to_a_corpus(path: Path) -> str:
    """The commands that make a corpus of a file that is none: of instructions, one a line, or of what `parse` prints of
    them; "" where there is no such file, or where it is meant to be a corpus."""
    if path.suffix in (".yaml", ".yml") or not path.is_file():
        return ""
    with path.open("rb") as stream:
        is_parsed = stream.read(1) == b"{"
    parsed, made = (path if is_parsed else path.with_suffix(".jsonl")), path.with_suffix(".yaml")
    commands = [] if is_parsed else [f"decomplex-bt parse --json {quote(str(path))} > {quote(str(parsed))}"]
    commands.append(f"decomplex-bt corpus convert --from jsonl --to yaml {quote(str(parsed))} {quote(str(made))}")
    return f"; a corpus is annotated; to make one of this, by our own reading: {'; '.join(commands)}"


def _print(summaries: Sequence[Summary]) -> None:
    from decomplex_bt.evaluation.summary import tabulate, tabulate_conditions

    print(tabulate(summaries))
    if conditions := tabulate_conditions(summaries):
        print(f"\n{conditions}\n")
    for summary in summaries:
        if count := dict(summary.outcomes)["ungroundable"]:
            asking = f"{summary.agent}: {count} of {summary.episodes} episodes ask"
            print(f"{asking} for what this house does not have: outside the rate")
        for warning in summary.warnings:
            remark(f"warning: {summary.agent}: {warning}")


def _print_failures(rows: Sequence[Row]) -> None:
    from decomplex_bt.evaluation.report import failure_lines

    lines = list(failure_lines(rows))
    for line in lines[:FAILURES_SHOWN]:
        print(line)
    if len(lines) > FAILURES_SHOWN:
        print(f"and {len(lines) - FAILURES_SHOWN} failures more; --output DIR lists them all")


@contextmanager
def _progress() -> Iterator[Progress | None]:
    """A progress bar on standard error where that is a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("episodes"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("episodes", total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)
