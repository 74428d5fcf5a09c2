"""`decomplex-bt train`: the models, from a corpus."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from decomplex_bt.cli.options import DomainOption, Format, FormatOption, JobsOption, JsonOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, remark, use_utf8

CorpusOption = Annotated[Path | None, typer.Option(help="A corpus folder.", show_default="the domain's own")]
OutputOption = Annotated[Path | None, typer.Option(help="A folder for models.", show_default="the domain's own")]


def train(
    corpus: CorpusOption = None,
    output: OutputOption = None,
    encoder: Annotated[bool, typer.Option("--encoder", help="The encoder instead; needs the extra `train`.")] = False,
    references: Annotated[
        bool, typer.Option("--references", help="Only what words refer to, beside the models that are there.")
    ] = False,
    base: Annotated[
        Path | None,
        typer.Option(
            "--from", help="A folder with a trained encoder to go on from.", show_default="the pretrained one"
        ),
    ] = None,
    rehearse: Annotated[
        bool, typer.Option("--rehearse", help="With --from: once over every training voice, known or not.")
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="Replace models that exist already.")] = False,
    jobs: JobsOption = 1,
    format: FormatOption = None,
    json: JsonOption = False,
    domain: DomainOption = "household",
) -> int:
    """Train all models on a corpus folder; the voices kept for testing are never read.

    No model is written unless all were trained; the same corpus gives the same models. Without --force none is
    replaced, but for the domain's own when they are made anew from its own corpus.
    """
    use_utf8()
    is_json = chosen(format, json, Format.text) is Format.json
    from decomplex_bt.evaluation.proportion import Proportion
    from decomplex_bt.understanding import training

    report = training.train(
        corpus,
        output,
        domain=domain_of(domain),
        encoder=encoder,
        references=references,
        base=base,
        rehearse=rehearse,
        force=force,
        jobs=jobs,
        progress=lambda stage: remark(f"{stage} ..."),
    )
    if is_json:
        print_json(
            {
                "voices": list(report.voices),
                "examples": report.examples,
                "flows_left_out": report.flows_left_out,
                "folder": str(report.folder),
                "held_out": {voice: Proportion(*counts).to_json() for voice, counts in report.held_out.items()},
            }
        )
        return 0
    print(f"trained on {report.examples} instructions of {', '.join(report.voices)}")
    if report.flows_left_out:
        print(f"{report.flows_left_out} flows that the labels cannot say were left out of the flow model")
    if report.held_out:
        print("tasks and control flow exactly right, read by models that never saw the voice (the worst first):")
    for voice, (right, count) in sorted(report.held_out.items(), key=lambda item: item[1][0] / item[1][1]):
        print(f"  {voice:12} {Proportion(right, count)}")
    if len(report.held_out) > 1:
        rights, counts = zip(*report.held_out.values(), strict=True)
        print(f"  {'all':12} {Proportion(sum(rights), sum(counts))}")
    print(f"models are in {report.folder}")
    return 0
