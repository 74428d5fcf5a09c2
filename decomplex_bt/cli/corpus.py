"""`decomplex-bt corpus`: annotated instructions, checked and counted."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from decomplex_bt.cli.options import DomainOption, Format, FormatOption, JsonOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, use_utf8

app = typer.Typer(help="Check and count annotated instructions.", no_args_is_help=True, rich_markup_mode=None)
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
