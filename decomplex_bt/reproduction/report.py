"""The report: every table and figure of the paper with ours beside it, what holds of its claims, and why not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from decomplex_bt.corpus_statistics import STRUCTURES
from decomplex_bt.reproduction.experiment import ProtocolResult, Results
from decomplex_bt.reproduction.paper import PaperTable, VerdictLine
from decomplex_bt.reproduction.systems import MERGED

YES, NO = "yes", "no"


def report_json(results: Results) -> dict[str, Any]:
    """All of it as one JSON object: settings, data, the measures of each protocol, tables, claims and verdicts."""
    return {
        "settings": results.settings.to_json(),
        "dataset": {"paper": results.paper.dataset.model_dump(), "ours": _dataset(results)},
        "protocols": {protocol.name: protocol.to_json() for protocol in results.protocols},
        "tables": [_table_json(table, results) for table in results.paper.tables],
        "example": {
            "text": results.paper.example,
            **{who: text.splitlines() for who, text in results.examples.items()},
        },
        "claims": [
            {
                "says": claim.says,
                "paper": claim.paper,
                "ours": {p.name: _json(p.difference(claim.more, claim.less)) for p in results.protocols},
            }
            for claim in results.paper.claims
        ],
        "verdicts": [verdict_json(line, results) for line in results.paper.verdicts],
    }


def verdict_json(line: VerdictLine, results: Results) -> dict[str, Any]:
    """Whether a measure is at least the paper's: of the paper's system on our data, and of our default interpreter."""
    paper, table = results.paper.value(line.key)
    beats: dict[str, dict[str, bool]] = {}
    for protocol in results.protocols:
        keys = {"systems": line.key, **({"interpreter": line.ours} if line.ours else {})}
        measured = {who: protocol.estimates.get(key) for who, key in keys.items()}
        beats[protocol.name] = {
            who: (found.mean <= paper if table.better == "lower" else found.mean >= paper)
            for who, found in measured.items()
            if found is not None
        }
    lost = any(not won for sides in beats.values() for won in sides.values())
    why_not = " ".join(_reasons(line, results)) if lost else ""
    return {"says": line.says, "paper": paper, "beats": beats, "why_not": why_not}


def report_text(results: Results) -> str:
    """All of it as plain text."""
    parts = [
        _heading(results),
        _dataset_text(results),
        _labels_text(results),
        _features_text(results),
        *(_table_text(table, results) for table in results.paper.tables),
        _example_text(results),
        _claims_text(results),
        _verdicts_text(results),
    ]
    return "\n\n".join(parts)


def _heading(results: Results) -> str:
    lines = ["The DeComplex paper's figures, and ours beside them. In brackets: 95 % intervals over the splits."]
    for protocol in results.protocols:
        shown = "; ".join(split.left_out for split in protocol.splits) if protocol.name == "voice" else ""
        lines.append(
            f"{protocol.name}: {protocol.description}, {len(protocol.splits)} splits, {protocol.tested} instructions "
            f"tested, {protocol.tested_complex} of them complex" + (f" ({shown})" if shown else "")
        )
    interpreter = results.settings.interpreter_repeats
    lines.append(f"our default interpreter: trained anew for the first {interpreter} of the splits of each protocol")
    return "\n".join(lines)


def _dataset(results: Results) -> dict[str, Any]:
    complex_ones = [sample.example.instruction for sample in results.dataset.complex]
    structures = {name: sum(map(has, complex_ones)) for name, has in STRUCTURES.items()}
    tasks = {task.type for s in results.dataset.samples for task in s.example.instruction.tasks}
    arguments = {a.type for s in results.dataset.samples for t in s.example.instruction.tasks for a in t.arguments}
    return {
        **results.dataset.to_json(),
        "task_labels": len(tasks),
        "argument_labels": 2 * len(arguments) + 1,
        "structures": structures,
        "dependents": _dependents(results),
    }


def _dependents(results: Results) -> dict[str, float]:
    """Of the tasks in branches the shares that the paper calls implicit and out of order (section III-C)."""
    pairs = results.dataset.dependents()
    places = []
    for sample, task, condition in pairs:
        document, instruction = sample.observed.document, sample.example.instruction
        tokens = [document.indices(instruction.task(number).span).start for number in (task, condition)]
        places.append([(document.sentences[token], token) for token in tokens])
    count = max(len(places), 1)
    return {
        "in another sentence": round(sum(task[0] != condition[0] for task, condition in places) / count, 4),
        "ahead": round(sum(task[1] < condition[1] for task, condition in places) / count, 4),
    }


def _dataset_text(results: Results) -> str:
    ours, paper = _dataset(results), results.paper.dataset
    rows = [
        ("instructions", paper.instructions, ours["instructions"]),
        ("complex", paper.complex, ours["complex"]),
        ("tasks in a complex one", f"{paper.tasks_mean} (sd {paper.tasks_sd})",
         f"{ours['tasks_mean']:.2f} (sd {ours['tasks_sd']:.2f})"),
        ("task labels besides O", paper.task_labels, f"{ours['task_labels']} (the paper's 8 are not listed there)"),
        ("argument labels in BIO", paper.argument_labels, ours["argument_labels"]),
    ]  # fmt: skip
    lines = [_line("", "paper", "ours"), *(_line(name, str(a), str(b)) for name, a, b in rows)]
    for name, count in ours["structures"].items():
        if name != "complex":
            lines.append(_line(f"  {name}", "", f"{count / ours['complex']:.0%} of the complex ones"))
    for name, share in ours["dependents"].items():
        what = "in another sentence than their condition" if name != "ahead" else "ahead of their condition"
        lines.append(_line("  dependent tasks", "", f"{share:.0%} {what}"))
    source = f"single-task instructions: {ours['singles']} from {ours['singles_from']}"
    if results.settings.huric is None:
        source += " (the paper's are from HuRIC; --huric PATH takes those)"
    return _titled("Data set", "section IV-A", [*lines, source])


def _labels_text(results: Results) -> str:
    counts = results.dataset.to_json()["labels"]
    total = sum(counts.values())
    lines = [
        f"  {label:<20}{counts.get(label, 0):>6} ({counts.get(label, 0) / total:.0%})  {definition}"
        for label, definition in results.paper.labels.items()
    ]
    return _titled("Task dependency labels, with their number in our complex instructions", "Table I", lines)


def _features_text(results: Results) -> str:
    estimates = results.protocols[0].estimates
    lines = [f"  {'':<18}{'weights':>8}{'sum':>8}"]
    for name, description in results.paper.features.items():
        count, size = estimates[f"features/{name}/weights"].mean, estimates[f"features/{name}/size"].mean
        lines.append(f"  {name:<18}{count:>8.0f}{size:>8.1f}  {description}")
    title = "Features of the dependency CRF, with the weights learnt from them and the sum of their sizes"
    return _titled(title, "Table II", lines)


def _table_json(table: PaperTable, results: Results) -> dict[str, Any]:
    cells = []
    for row, column, key, value in table.cells():
        ours = {p.name: _json(p.estimates.get(key)) for p in results.protocols}
        cells.append({"row": row, "column": column, "key": key, "paper": value, "ours": ours})
    return {"name": table.name, "title": table.title, "where": table.where, "cells": cells}


def _table_text(table: PaperTable, results: Results) -> str:
    lines = [_line("", "paper", *(protocol.name for protocol in results.protocols))]
    for row, column, key, value in table.cells():
        ours = [str(p.estimates.get(key) or "-") for p in results.protocols]
        if set(ours) != {"-"}:
            title = _row_title(table, row, results)
            lines.append(_line(f"{title}, {column}" if len(table.columns) > 1 else title,
                               "-" if value is None else f"{value:.3f}", *ours))  # fmt: skip
    notes = [f"  {_row_title(table, row, results)}: {what}" for row, what in table.ours.items() if "/" not in row]
    return _titled(table.title, table.where, [*lines, *notes])


def _row_title(table: PaperTable, row: str, results: Results) -> str:
    if row in table.titles:
        return table.titles[row]
    label, _, system = row.rpartition("/")
    base = system.removesuffix(MERGED)
    shown = results.paper.titles.get(base, base) + (MERGED if base != system else "")
    return f"{label}, {shown}" if label else shown


def _example_text(results: Results) -> str:
    lines = [f"  {results.paper.example}"]
    names = {"paper": "the paper's full system", "interpreter": "our default interpreter"}
    for who, name in names.items():
        if who in results.examples:
            lines += [f"  {name}:", *(f"    {line}" for line in results.examples[who].splitlines())]
    lines.append("Fig. 2, the system overview, holds nothing that is measured.")
    return _titled("The paper's example, understood by models trained on the first split", "Fig. 1", lines)


def _claims_text(results: Results) -> str:
    lines = [_line("", "paper", *(protocol.name for protocol in results.protocols))]
    for claim in results.paper.claims:
        found = [protocol.difference(claim.more, claim.less) for protocol in results.protocols]
        lines.append(_line(claim.says, f"{claim.paper:+.3f}", *(_signed(difference) for difference in found)))
    return _titled("What the paper concludes, as differences", "sections IV-B to IV-D", lines)


def _verdicts_text(results: Results) -> str:
    names = [protocol.name for protocol in results.protocols]
    lines = [_line("", "paper", *names, *(f"interpreter, {name}" for name in names), width=30)]
    notes = []
    for line in results.paper.verdicts:
        found = verdict_json(line, results)
        cells = [
            _cell(protocol, key, found["beats"][protocol.name].get(who), found["paper"])
            for who, key in (("systems", line.key), ("interpreter", line.ours))
            for protocol in results.protocols
        ]
        lines.append(_line(line.says, f"{found['paper']:.3f}", *cells, width=30))
        if found["why_not"]:
            notes.append(f"  {line.says}: {found['why_not']}")
    where = "first the paper's own system on our data, then our default interpreter"
    notes_on_signs = "  yes: at least as good as the paper's figure; ?: that figure lies within our interval"
    return _titled(
        "Does ours beat the paper?", where, [*lines, notes_on_signs, *(["why not:", *notes] if notes else [])]
    )


def _cell(protocol: ProtocolResult, key: str | None, won: bool | None, paper: float) -> str:
    if key is None or won is None:
        return "-"
    found = protocol.estimates[key]
    is_open = found.interval is not None and found.interval[0] <= paper <= found.interval[1]
    return f"{found.mean:.3f} {YES if won else NO}{'?' if is_open else ''}"


def _reasons(line: VerdictLine, results: Results) -> Iterator[str]:
    """What was measured that accounts for a lower figure."""
    ours = _dataset(results)
    voices = ours["voices"]
    if line.key.startswith(("tasks/", "arguments/")):
        size = sum(len(s.example.instruction.tasks) for s in results.dataset.samples) / ours["instructions"]
        yield (
            f"{voices} voices with words of their own, {size:.1f} tasks an instruction, "
            f"{ours['complex'] / ours['instructions']:.0%} complex where the paper has "
            f"{results.paper.dataset.complex / results.paper.dataset.instructions:.0%}."
        )
    if line.key.startswith("arguments/") and line.key.endswith("exact"):
        count = sum(len(t.arguments) for s in results.dataset.samples for t in s.example.instruction.tasks)
        yield f"An exact match asks for every word of {count / ours['instructions']:.1f} arguments an instruction."
    if line.key.startswith("dependencies/"):
        hard = [f"{name} {ours['structures'][name] / ours['complex']:.0%}" for name in _HARD]
        yield f"Of our complex instructions are {', '.join(hard)}."
        implicit, ahead = ours["dependents"]["in another sentence"], ours["dependents"]["ahead"]
        yield f"Of the dependent tasks {implicit:.0%} are in another sentence than their condition, {ahead:.0%} ahead."
    if line.key.startswith("flow/"):
        yield " ".join(_flow_reasons(results.protocols))


_HARD = ("with a nested condition", "with several conditions", "out of order")


def _flow_reasons(protocols: Sequence[ProtocolResult]) -> Iterator[str]:
    for protocol in protocols:
        found = protocol.estimates
        yield (
            f"{protocol.name}: four gold labels say {found[f'flow/gold labels{MERGED}/exact'].mean:.0%} of our flows; "
            f"with gold tasks the full system has {found[f'flow/crf{MERGED}, gold tasks/exact'].mean:.0%}; all tasks "
            f"are found in {found['tasks all right/crf'].mean:.0%} of the complex instructions."
        )


def _titled(title: str, where: str, lines: Sequence[str]) -> str:
    return "\n".join([f"{title} ({where})", *lines])


def _line(name: str, *cells: str, width: int = 46) -> str:
    return f"  {name:<{width}}" + "".join(f"{cell:<24}" for cell in cells).rstrip()


def _signed(difference: Any) -> str:
    if difference is None:
        return "-"
    if difference.interval is None:
        return f"{difference.mean:+.3f}"
    low, high = difference.interval
    return f"{difference.mean:+.3f} [{low:+.3f}, {high:+.3f}]"


def _json(value: Any) -> Any:
    return None if value is None else value.to_json()
