"""`decomplex-bt reproduce`: the paper's tables and figures, ours beside them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

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
)
from decomplex_bt.cli.output import print_json, remark, use_utf8
from decomplex_bt.errors import InputError

BOTH = "both"


def reproduce(
    huric: Annotated[
        Path | None, typer.Option(help="A folder of HuRIC 2.1: its single-task instructions in place of ours.")
    ] = None,
    repeats: Annotated[int, typer.Option("--repeats", "-n", help="Splits of each protocol.")] = 5,
    interpreter_repeats: Annotated[
        int | None, typer.Option(help="Splits for our default interpreter, slow to train; 0: none.", show_default="1")
    ] = None,
    protocol: Annotated[
        str, typer.Option(help="random (80/20, the paper's), voice (whole voices out) or both.")
    ] = BOTH,
    seed: SeedOption = 0,
    jobs: JobsOption = -1,
    plots: Annotated[Path | None, typer.Option(help="A folder for pictures; needs the extra `plots`.")] = None,
    corpus: Annotated[Path | None, typer.Option(help="A corpus folder. Default: the domain's own.")] = None,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Train the paper's systems anew, measure them as the paper does, and print its tables and figures beside ours.

    The numbers are the same for any number of jobs.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.reproduction import experiment, report
    from decomplex_bt.reproduction import plots as pictures
    from decomplex_bt.reproduction.dataset import PROTOCOLS

    if protocol not in (*PROTOCOLS, BOTH):
        raise InputError(f"--protocol {protocol}: expected one of {', '.join((*PROTOCOLS, BOTH))}")
    if plots is not None:
        pictures.check_plots(plots)
    settings = experiment.Settings(
        domain=domain_of(domain),
        corpus=corpus,
        huric=huric,
        repeats=repeats,
        interpreter_repeats=min(1, repeats) if interpreter_repeats is None else interpreter_repeats,
        seed=seed,
        jobs=jobs,
        protocols=tuple(PROTOCOLS) if protocol == BOTH else (protocol,),
    )
    results = experiment.run(settings, progress=lambda stage: remark(f"{stage} ..."))
    if plots is not None:
        for path in pictures.write_plots(results, plots):
            remark(f"written: {path}")
    if is_json:
        print_json(report.report_json(results))
    else:
        print(report.report_text(results))
    return 0
