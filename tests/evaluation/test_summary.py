from __future__ import annotations

import json
from pathlib import Path

import pytest

from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.evaluation.report import summary_json, write_results
from decomplex_bt.evaluation.row import Row
from decomplex_bt.evaluation.summary import summarise, tabulate, tabulate_conditions

COMMANDS = Path(__file__).parents[2] / "docs" / "commands.md"


def row(outcome="success", *, example="one", agent="tree", seed=0, **fields):
    return Row(example, seed, agent, "own", "gold", ({"if": 1, "then": [2]},), outcome, **fields)


def branch(truth, task=1):
    return {"task": task, "truth": truth, "taken": None}


def test_wilson_interval_of_the_textbook():
    low, high = Proportion(8, 10).interval
    assert (round(low, 4), round(high, 4)) == (0.4902, 0.9433)
    assert Proportion(0, 0).interval is None
    assert str(Proportion(0, 0)) == "no data"


def test_the_rate_is_over_feasible_episodes():
    rows = [row(), row("failure", stage="planning"), row("infeasible", stage="infeasible"), row("ungroundable")]
    (summary,) = summarise(rows)
    assert (summary.success.count, summary.success.total) == (1, 2)
    assert (summary.infeasible.count, summary.infeasible.total) == (1, 3)
    assert dict(summary.stages)["planning"] == 1
    assert dict(summary.outcomes)["ungroundable"] == 1


def test_both_sides_of_each_condition_are_counted_in_feasible_episodes():
    rows = [
        row(branches=(branch(True), branch(None, task=3))),
        row("failure", branches=(branch(False),)),
        row("infeasible", branches=(branch(False),)),
    ]
    (instruction,) = summarise(rows)[0].instructions
    assert [count.to_json() for count in instruction.branches] == [
        {"task": 1, "true": 1, "false": 1, "undecided": 0},
        {"task": 3, "true": 0, "false": 0, "undecided": 1},
    ]


def test_conditions_are_tabulated_for_each_agent():
    rows = [
        row(branches=(branch(True),)),
        row(branches=(branch(False),)),
        row(agent="oracle", branches=(branch(False), branch(True, task=3))),
        row(agent="idle"),
    ]
    lines = tabulate_conditions(summarise(rows)).splitlines()
    assert [line.split()[:6] for line in lines[1:4]] == [
        ["tree", "one,", "task", "1", "1", "1"],
        ["oracle", "one,", "task", "1", "0", "1"],
        ["oracle", "one,", "task", "3", "1", "0"],
    ]
    assert lines[4:] == [
        "tree: both branches occurred for 1 of 1 conditions",
        "oracle: both branches occurred for 0 of 2 conditions",
    ]
    assert tabulate_conditions(summarise([row()])) == ""


def test_what_was_met_at_the_start_is_counted_over_feasible_episodes():
    rows = [row(met_at_start=True), row(), row("failure"), row("infeasible"), row(met_at_start=True, example="two")]
    (summary,) = summarise(rows)
    assert summary.met_at_start == Proportion(2, 4)
    assert "50%" in tabulate(summarise(rows)).splitlines()[1]


def test_the_spl_is_the_mean_over_feasible_episodes():
    rows = [row(spl=1.0), row(spl=0.5), row("failure", spl=0.0), row("infeasible"), row("ungroundable")]
    (summary,) = summarise(rows)
    assert summary.to_json()["spl"] == 0.5
    assert summarise([row("infeasible")])[0].spl is None


def test_warnings_name_the_instruction():
    rows = [row(branches=(branch(True),))] + [row("infeasible") for _ in range(2)] + [row(example="two")]
    assert summarise(rows)[0].warnings == (
        "one: 67% of the episodes are infeasible",
        "one: the condition of task 1 was never false",
    )


def test_agents_stand_beside_each_other():
    rows = [row(), row(agent="oracle"), row("failure", agent="random", stage="execution")]
    table = tabulate(summarise(rows))
    assert [line.split()[0] for line in table.splitlines()[1:4]] == ["tree", "oracle", "random"]
    assert "execution 1" in table


def test_rows_and_summary_are_written_whole(tmp_path):
    rows = [row(branches=(branch(True),), steps=12), row("failure", stage="execution", cause="Ümlaut")]
    folder = tmp_path / "new" / "results"
    rows_path, summary_path, failures_path = write_results(folder, rows, {"seed": 3})
    lines = rows_path.read_text(encoding="utf-8").splitlines()
    assert [json.loads(line) for line in lines] == [json.loads(json.dumps(one.to_json())) for one in rows]
    assert json.loads(summary_path.read_text(encoding="utf-8")) == summary_json(rows, {"seed": 3})
    assert sorted(path.name for path in folder.iterdir()) == ["failures.txt", "rows.jsonl", "summary.json"]
    assert failures_path.read_text(encoding="utf-8") == "tree, one, seed 0: execution: Ümlaut\n"


def test_a_file_in_place_of_the_folder_is_bad_input(tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(InputError, match="taken: cannot write there"):
        write_results(tmp_path / "taken", [row()])


@pytest.mark.skipif(not COMMANDS.exists(), reason="not the source tree")
def test_the_manual_has_every_key_of_a_row():
    manual = COMMANDS.read_text(encoding="utf-8")
    assert all(f"`{key}`" in manual for key in row().to_json())
