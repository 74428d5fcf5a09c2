"""`decomplex-bt evaluate`: instructions times worlds, and how often the robot succeeds."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from decomplex_bt.cli.options import DomainOption, Format, FormatOption, JsonOption, SeedOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, remark, use_utf8
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.evaluation.monte_carlo import Progress
    from decomplex_bt.evaluation.summary import Summary

READINGS = ("own", "gold")


def evaluate(
    corpus: Annotated[Path, typer.Argument(metavar="CORPUS", help="A corpus file, or a folder of them.")],
    episodes: Annotated[int, typer.Option("--episodes", "-n", help="Worlds for each instruction.")] = 20,
    seed: SeedOption = 0,
    jobs: Annotated[int, typer.Option("--jobs", "-j", help="Processes; -1: one a core.")] = 1,
    agent: Annotated[str, typer.Option(help="tree, oracle (knows the world), random or idle.")] = "tree",
    reading: Annotated[str, typer.Option(help="Whose reading the tree goes by: own or gold.")] = "own",
    limit: Annotated[int | None, typer.Option(min=1, help="Only the first so many instructions.")] = None,
    output: Annotated[Path | None, typer.Option(help="A folder for rows.jsonl and summary.json.")] = None,
    format: FormatOption = Format.text,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Run every instruction of a corpus in many worlds, judged by the corpus' own reading: the success rate.

    World k of an instruction has the seed SEED + k; the numbers are the same for any number of jobs.
    """
    use_utf8()
    from decomplex_bt.corpus import read_corpus
    from decomplex_bt.domain.loader import load_domain
    from decomplex_bt.evaluation import monte_carlo, report
    from decomplex_bt.evaluation.summary import summarise

    if reading not in READINGS:
        raise InputError(f"--reading {reading}: expected one of {', '.join(READINGS)}")
    if output is not None:
        report.prepare_output(output)
    examples = read_corpus(corpus, load_domain(domain_of(domain)).ontology)[:limit]
    with _progress() as progress:
        rows = monte_carlo.evaluate(
            examples,
            episodes=episodes,
            seed=seed,
            jobs=jobs,
            agent=agent,
            reading="own" if reading == "own" else "gold",
            setup=monte_carlo.Setup(domain=domain_of(domain)),
            progress=progress,
        )
    settings = {"corpus": str(corpus), "episodes": episodes, "seed": seed, "agent": agent, "reading": reading}
    if output is not None:
        for path in report.write_results(output, rows, settings):
            remark(f"written: {path}")
    if chosen(format, json) is Format.json:
        print_json(report.summary_json(rows, settings))
    else:
        _print(summarise(rows))
    return 0


def _print(summaries: Sequence[Summary]) -> None:
    from decomplex_bt.evaluation.summary import tabulate

    print(tabulate(summaries))
    for summary in summaries:
        if count := dict(summary.outcomes)["ungroundable"]:
            print(f"{count} of {summary.episodes} episodes ask for what this house does not have: outside the rate")
        for warning in summary.warnings:
            remark(f"warning: {warning}")


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
