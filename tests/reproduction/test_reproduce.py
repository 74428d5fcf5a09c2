"""The whole way on a small corpus: every table, the same numbers for the same seed, clear errors."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from decomplex_bt.cli import main
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.reproduction.paper import read_paper

VOICES = ("walt", "leo", "kaye")


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The first instructions of three voices."""
    folder = tmp_path_factory.mktemp("corpus")
    for voice in VOICES:
        items = (load_domain("household").folder / "corpus" / f"{voice}.yaml").read_text(encoding="utf-8")
        (folder / f"{voice}.yaml").write_text("\n- id".join(items.split("\n- id")[:13]) + "\n", encoding="utf-8")
    lines = [f"  {voice}: {{description: x, split: train}}" for voice in VOICES]
    (folder / "voices.yaml").write_text("\n".join(["voices:", *lines]), encoding="utf-8")
    return folder


def reproduce(corpus: Path, *options: str) -> list[str]:
    return ["reproduce", "--corpus", str(corpus), "--jobs", "1", *options]


@pytest.fixture(scope="module")
def report(corpus: Path) -> dict:
    from decomplex_bt.reproduction import experiment
    from decomplex_bt.reproduction.report import report_json

    settings = experiment.Settings(corpus=corpus, repeats=2, interpreter_repeats=0)
    return report_json(experiment.run(settings))


def test_every_table_is_measured(report: dict) -> None:
    paper = read_paper()
    assert [table["name"] for table in report["tables"]] == [table.name for table in paper.tables]
    for table in report["tables"]:
        for cell in table["cells"]:
            if "interpreter" not in cell["row"]:
                assert {cell["ours"][name]["splits"] for name in ("random", "voice")} <= {1, 2}, cell["key"]
    assert len(report["verdicts"]) == len(paper.verdicts)
    assert all(set(claim["ours"]) == {"random", "voice"} for claim in report["claims"])


def test_shares_are_shares(report: dict) -> None:
    for protocol in report["protocols"].values():
        for key, found in protocol["measures"].items():
            if not key.startswith(("transitions/", "features/")) and not key.endswith("/oer"):
                assert 0 <= found["mean"] <= 1, key
                assert found["interval"][0] <= found["mean"] <= found["interval"][1]


def test_gold_labels_are_the_ceiling_of_the_tree(report: dict) -> None:
    for protocol in report["protocols"].values():
        measures = {key: found["mean"] for key, found in protocol["measures"].items()}
        assert measures["flow/gold labels (m)/exact"] >= measures["flow/crf (m), gold tasks/exact"]
        assert measures["flow/crf (m), gold tasks/exact"] >= measures["flow/crf (m)/exact"]


def test_text_json_and_pictures_from_the_command_line(
    corpus: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("matplotlib")
    options = ("--repeats", "1", "--interpreter-repeats", "0", "--protocol", "random")
    assert main(reproduce(corpus, *options, "--plots", str(tmp_path / "plots"))) == 0
    text = capsys.readouterr().out
    for part in ("Table I)", "Table II)", "Table III)", "Table IV)", "Table V)", "Fig. 1)", "Fig. 3(a)", "Fig. 3(b)"):
        assert part in text
    assert "Does ours beat the paper?" in text
    assert "nan" not in text
    assert len(list((tmp_path / "plots").glob("*.png"))) == len(read_paper().tables)
    assert main(reproduce(corpus, *options, "--json")) == 0
    assert json.loads(capsys.readouterr().out)["settings"]["repeats"] == 1


@pytest.mark.slow
def test_any_number_of_jobs_gives_the_same_and_the_interpreter_is_measured(corpus: Path, capsys) -> None:
    options = ("--repeats", "1", "--json", "--protocol", "voice")
    found = []
    for jobs in ("1", "2"):
        assert main(["reproduce", "--corpus", str(corpus), "--jobs", jobs, *options]) == 0
        found.append(json.loads(capsys.readouterr().out))
    assert found[0] == found[1]
    assert found[0]["protocols"]["voice"]["measures"]["flow/interpreter/exact"]["splits"] == 1


BAD = {
    "no repeats": (["--repeats", "0"], "1 or more"),
    "more for the interpreter": (["--repeats", "1", "--interpreter-repeats", "2"], "0 to 1"),
    "no such protocol": (["--protocol", "lots"], "random, voice, both"),
    "no jobs": (["--jobs", "0"], "--jobs is 0"),
    "no HuRIC": (["--huric", "/nowhere/at/all"], "/nowhere/at/all"),
    "no corpus": (["--corpus", "/nowhere/at/all"], "/nowhere/at/all"),
    "plots in a file": (["--plots", "/dev/null/x"], "/dev/null/x"),
}


@pytest.mark.parametrize(("options", "problem"), BAD.values(), ids=BAD.keys())
def test_bad_input_is_one_line(options: list[str], problem: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", *options]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert problem in err


def test_plots_need_their_extra(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("decomplex_bt.reproduction.plots.find_spec", lambda name: None)
    assert main(["reproduce", "--plots", "plots"]) == 2
    assert "decomplex-bt[plots]" in capsys.readouterr().err
