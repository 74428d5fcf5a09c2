"""`decomplex-bt tree`: the behaviour tree of an instruction, in any of its forms."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from decomplex_bt.cli.options import DomainOption, JsonOption, TextArgument, ThresholdOption, chosen, domain_of
from decomplex_bt.cli.output import print_json, use_utf8


class TreeFormat(StrEnum):
    """The forms of a tree."""

    text = "text"
    ascii = "ascii"
    json = "json"
    dot = "dot"
    mermaid = "mermaid"
    xml = "xml"


def tree(
    text: TextArgument,
    format: Annotated[
        TreeFormat | None,
        typer.Option(
            "--format",
            "-f",
            help="xml: BehaviorTree.CPP 4; dot: Graphviz (dot -Tsvg draws it).",
            show_default="text",
        ),
    ] = None,
    json: JsonOption = False,
    threshold: ThresholdOption = None,
    domain: DomainOption = "household",
) -> int:
    """Print the behaviour tree that an instruction compiles to."""
    use_utf8()
    from decomplex_bt.behaviour import export
    from decomplex_bt.behaviour.agent import compile_instruction
    from decomplex_bt.cli.reading import read

    wanted = chosen(format, json, TreeFormat.text)
    reading = read(text, domain_of(domain), may_ask=wanted is not TreeFormat.json, threshold=threshold)
    root = compile_instruction(reading.instruction, reading.grounded, reading.domain).root
    if wanted is TreeFormat.json:
        print_json({**export.to_json(root), "warnings": list(reading.instruction.warnings)})
    elif wanted is TreeFormat.dot:
        print(export.to_dot(root), end="")
    elif wanted is TreeFormat.mermaid:
        print(export.to_mermaid(root), end="")
    elif wanted is TreeFormat.xml:
        print(export.to_behaviortree_cpp(root), end="")
    else:
        print(export.to_text(root, is_ascii=wanted is TreeFormat.ascii))
    return 0
