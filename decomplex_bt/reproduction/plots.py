"""The figures as pictures: the paper's bars beside ours; needs matplotlib, the extra `plots`."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from decomplex_bt.errors import InputError
from decomplex_bt.reproduction.experiment import ProtocolResult, Results
from decomplex_bt.reproduction.paper import PaperTable

COLOURS = ("#9a9a9a", "#3f74b5", "#e08a2c")
"""Of the paper's bars, then of each protocol's."""
BAR = 0.27
"""Width of a bar, where a row is 1 apart from the next."""


def check_plots(folder: Path) -> None:
    """Raises `InputError` where pictures cannot be drawn or `folder` cannot be written to; before hours of training."""
    if find_spec("matplotlib") is None:
        raise InputError("--plots needs matplotlib; install it with: pip install 'decomplex-bt[plots]'")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"--plots {folder}: the folder cannot be made: {error.strerror}") from None


def write_plots(results: Results, folder: Path) -> list[Path]:
    """A PNG for every table and figure that has numbers, named after it."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    written = []
    for table in results.paper.tables:
        if table.name == "transitions":
            figure = _heat_maps(plt, table, results.protocols)
        else:
            figure = _bars(plt, table, results)
        path = folder / f"{table.name}.png"
        figure.savefig(path, dpi=120, bbox_inches="tight")
        plt.close(figure)
        written.append(path)
    return written


def _bars(plt: Any, table: PaperTable, results: Results) -> Any:
    column = table.columns[-1]
    cells = [(row, key, value) for row, name, key, value in table.cells() if name == column]
    cells = [cell for cell in cells if any(cell[1] in p.estimates for p in results.protocols)]
    figure, axes = plt.subplots(figsize=(max(4.0, 1.1 * len(cells)), 3.6))
    papers = [(k, value) for k, (_, _, value) in enumerate(cells) if value is not None]
    if papers:
        axes.bar([k - BAR for k, _ in papers], [v for _, v in papers], BAR, color=COLOURS[0], label="paper")
    for n, protocol in enumerate(results.protocols):
        found = [(k, protocol.estimates[key]) for k, (_, key, _) in enumerate(cells) if key in protocol.estimates]
        places = [k + n * BAR for k, _ in found]
        errors = [_error(estimate.mean, estimate.interval) for _, estimate in found]
        axes.bar(
            places,
            [estimate.mean for _, estimate in found],
            BAR,
            yerr=[list(ends) for ends in zip(*errors, strict=True)],
            color=COLOURS[n + 1],
            label=f"ours, {protocol.name}",
            capsize=2,
        )
    axes.set_xticks(range(len(cells)), [row for row, _, _ in cells], rotation=35, ha="right", fontsize=8)
    axes.set_ylabel(column)
    axes.set_title(f"{table.title} ({table.where})", fontsize=9)
    axes.legend(fontsize=8)
    return figure


def _error(mean: float, interval: tuple[float, float] | None) -> tuple[float, float]:
    low, high = interval or (mean, mean)
    return max(0.0, mean - low), max(0.0, high - mean)


def _heat_maps(plt: Any, table: PaperTable, protocols: Sequence[ProtocolResult]) -> Any:
    rows = list(table.values)
    grids = [("paper", [list(table.values[row]) for row in rows])]
    for protocol in protocols:
        keys = [[f"{table.key}/{row}/{column}" for column in table.columns] for row in rows]
        grids.append((f"ours, {protocol.name}", [[_mean(protocol, key) for key in line] for line in keys]))
    figure, all_axes = plt.subplots(1, len(grids), figsize=(4.2 * len(grids), 3.4), squeeze=False)
    for axes, (name, grid) in zip(all_axes[0], grids, strict=True):
        axes.imshow(grid, cmap="RdBu", vmin=-6.5, vmax=6.5)
        axes.set_xticks(range(len(table.columns)), table.columns, rotation=35, ha="right", fontsize=7)
        axes.set_yticks(range(len(rows)), rows, fontsize=7)
        axes.set_title(f"{table.where}: {name}", fontsize=9)
        for y, line in enumerate(grid):
            for x, value in enumerate(line):
                axes.text(x, y, f"{value:.1f}", ha="center", va="center", fontsize=7)
    return figure


def _mean(protocol: ProtocolResult, key: str) -> float:
    return protocol.estimates[key].mean if key in protocol.estimates else 0.0
