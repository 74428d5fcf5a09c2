"""`decomplex-bt plan`: the conditional plan of an instruction."""

from __future__ import annotations

from decomplex_bt.cli.options import (
    DomainOption,
    Format,
    FormatOption,
    JsonOption,
    TextArgument,
    ThresholdOption,
    chosen,
    domain_of,
)
from decomplex_bt.cli.output import print_json, use_utf8


def plan(
    text: TextArgument,
    format: FormatOption = None,
    json: JsonOption = False,
    threshold: ThresholdOption = None,
    domain: DomainOption = "household",
) -> int:
    """Print a plan for every task and branch, in a house where everything is where it is likeliest to be."""
    use_utf8()
    from decomplex_bt.cli.reading import read
    from decomplex_bt.planning.assumed_world import AssumedWorld
    from decomplex_bt.planning.contingent import plan_conditionally
    from decomplex_bt.planning.pyperplan_planner import PyperplanPlanner

    is_json = chosen(format, json, Format.text) is Format.json
    reading = read(text, domain_of(domain), may_ask=not is_json, threshold=threshold)
    conditional = plan_conditionally(reading.grounded, PyperplanPlanner(), world=AssumedWorld.likely(reading.domain))
    if is_json:
        print_json({**conditional.to_json(), "warnings": list(reading.instruction.warnings)})
    else:
        print(conditional)
    return 0
