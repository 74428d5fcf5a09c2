"""The command line: what it prints, to which stream, and with which exit status; never a traceback."""

from __future__ import annotations

import errno
import io
import json
import os
import shlex
import shutil
import subprocess
import sys
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest

import decomplex_bt
from decomplex_bt.cli import main

INSTRUCTIONS = Path(__file__).parent / "behaviour" / "instructions.yaml"
PEN = "Bring me a pen if you can find it on the table, if you cannot find one then search in the drawer."


@pytest.fixture
def parse_lines(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Runs `parse --json` on bytes; gives the exit status, the objects and the lines on standard error."""

    def run(data: bytes) -> tuple[int, list[dict], list[str]]:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data), encoding="utf-8"))
        status = main(["parse", "-", "--json"])
        out, err = capsys.readouterr()
        return status, [json.loads(line) for line in out.splitlines()], err.splitlines()

    return run


def test_parse_prints_the_object_of_annotation_md(parse_lines) -> None:
    status, (parsed,), errors = parse_lines(PEN.encode() + b"\n")
    assert status == 0
    assert errors == []
    assert list(parsed) == ["text", "tasks", "flow", "missing", "warnings"]
    assert parsed["text"] == PEN
    for task in parsed["tasks"]:
        assert list(task) == ["id", "type", "start", "end", "surface", "dependency", "confidence", "arguments"]
        assert PEN[task["start"] : task["end"]] == task["surface"]
        for argument in task["arguments"]:
            assert list(argument) == ["type", "start", "end", "surface", "value", "confidence"]
            if argument["start"] is not None:
                assert PEN[argument["start"] : argument["end"]] == argument["surface"]


def test_parse_names_bad_lines_and_goes_on(parse_lines) -> None:
    lines = [b"Turn on the tv.", b"", b"   ", b"\xff\xfe", b"a" * 2001, b"b" * 100_000, "Öffne 🙂 das Fenster".encode()]
    status, parsed, errors = parse_lines(b"\n".join(lines))
    assert status == 2
    assert [p["text"] for p in parsed] == ["Turn on the tv.", "Öffne 🙂 das Fenster"]
    assert [error.split(":")[0] for error in errors] == ["line 2", "line 3", "line 4", "line 5", "line 6"]


def test_parse_keeps_the_line_as_given_without_its_end(parse_lines) -> None:
    _, parsed, _ = parse_lines("\ufeff  Turn on the tv.\u2028 \r\n".encode())
    assert parsed[0]["text"] == "  Turn on the tv.\u2028 "


def test_parse_of_nothing_prints_nothing_and_says_so(parse_lines) -> None:
    status, parsed, (remark,) = parse_lines(b"")
    assert (status, parsed) == (0, [])
    assert "no instruction" in remark


def test_text_without_a_task_is_no_error_of_parse(parse_lines) -> None:
    status, (parsed,), _ = parse_lines(b"?!...\n")
    assert status == 0
    assert parsed["tasks"] == parsed["flow"] == []
    assert parsed["warnings"]


def test_parse_reads_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "lines.txt").write_text("Turn on the tv.\nGo to the kitchen.\n", encoding="utf-8")
    assert main(["parse", str(tmp_path / "lines.txt"), "--format", "text"]) == 0
    assert capsys.readouterr().out.count("[1]") == 2


def test_a_corpus_is_scored_with_intervals(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    corpus = "- id: a\n  text: '[Close](1:change_state) [the door](1:object).'\n  flow: [1]\n"
    (tmp_path / "a.yaml").write_text(corpus, encoding="utf-8")
    assert main(["corpus", "score", str(tmp_path / "a.yaml"), "--json"]) == 0
    scores = json.loads(capsys.readouterr().out)
    assert scores["all"]["instructions"] == 1
    assert scores["all"]["flow_exact"] == {"count": 1, "total": 1, "value": 1.0, "interval": [0.2065, 1.0]}
    assert "complex" not in scores


def test_tree_and_plan_in_every_form(capsys: pytest.CaptureFixture[str]) -> None:
    text = "If the tv is on, turn it off."
    starts = {
        "text": "→ If",
        "ascii": "-> If",
        "json": '{"type"',
        "dot": "digraph",
        "mermaid": "flowchart TD",
        "xml": "<?xml",
    }
    for form, start in starts.items():
        assert main(["tree", text, "--format", form]) == 0
        assert capsys.readouterr().out.startswith(start)
    assert main(["plan", text]) == 0
    assert "(switch-off tv)" in capsys.readouterr().out
    assert main(["plan", text, "--json"]) == 0
    assert "(switch-off tv)" in json.dumps(json.loads(capsys.readouterr().out))


@pytest.mark.parametrize(
    ("command", "form"), [("tree", "dot"), ("tree", "text"), ("plan", "text"), ("parse", "text"), ("run", "text")]
)
def test_json_beside_another_format_is_refused(command: str, form: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "Go to the kitchen.", "--json", "--format", form]) == 2
    out, err = capsys.readouterr()
    assert not out
    assert f"--json and --format {form} contradict each other" in err


def test_json_may_be_asked_for_twice(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tree", "Go to the kitchen.", "--json", "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["name"]


@pytest.mark.parametrize("command", ["plan", "tree", "run"])
def test_no_control_character_is_printed(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "Tell me that \x1b[31m\x07\nthe tea is ready."]) == 0
    out, _ = capsys.readouterr()
    assert all(line.isprintable() for line in out.split("\n"))
    assert command == "plan" or r"Tell me that \x1b[31m\x07\nthe tea is ready." in out


@pytest.mark.parametrize("command", ["plan", "tree", "run"])
@pytest.mark.parametrize("options", [[], ["--json"]], ids=["text", "json"])
def test_what_the_reading_warns_of_reaches_the_user(
    command: str, options: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from decomplex_bt.understanding.interpreter import Interpreter

    interpret = Interpreter.interpret
    monkeypatch.setattr(
        Interpreter, "interpret", lambda self, text: replace(interpret(self, text), warnings=("not so sure",))
    )
    main([command, "Go to the kitchen.", *options])
    out, err = capsys.readouterr()
    assert err == "warning: not so sure\n"
    assert "warning: " not in out
    if options and command != "run":
        assert json.loads(out)["warnings"] == ["not so sure"]


def test_run_prints_one_object(capsys: pytest.CaptureFixture[str]) -> None:
    status = main(["run", "If the tv is on, turn it off.", "--seed", "3", "--json"])
    result = json.loads(capsys.readouterr().out)
    assert list(result) == [
        "instruction", "seed", "flow", "outcome", "judged_by", "branches", "steps", "sim_seconds", "failures", "trace",
    ]  # fmt: skip
    assert status == (0 if result["outcome"] == "success" else 1)
    assert result["seed"] == 3
    assert result["judged_by"] == "interpreted"
    assert result["flow"] == [{"if": 1, "then": [2]}]
    assert [list(branch) for branch in result["branches"]] == [["task", "truth", "taken"]]
    keys = ["tick", "sim_seconds", "node", "status", "feedback", "event"]
    assert all(list(entry) == keys for entry in result["trace"])


def test_run_tells_the_story_and_films_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from PIL import Image

    film = tmp_path / "film.gif"
    main(["run", "Go to the kitchen, then go to the bedroom.", "--record", str(film)])
    out = capsys.readouterr().out
    for part in ("control flow:", "behaviour tree:", "world 0:", "judged by the robot's own reading"):
        assert part in out
    with Image.open(film) as picture:
        assert picture.n_frames > 2


def test_run_says_where_nothing_was_left_to_do(capsys: pytest.CaptureFixture[str]) -> None:
    said = {}
    for seed in (0, 1):
        assert main(["run", "Turn on the tv.", "--seed", str(seed)]) == 0
        last = capsys.readouterr().out.splitlines()[-1]
        said[" 1 steps" in last] = last
    assert said[True].startswith("success: nothing was left to do from the first (0.1 s")
    assert said[False].startswith("success (")


@pytest.mark.parametrize(
    ("is_out_of_time", "said"), [(True, "time ran out"), (False, "task 1 (Bring me the apple) was not settled")]
)
def test_a_failure_that_nothing_explains_is_not_put_down_to_the_time(is_out_of_time: bool, said: str) -> None:
    import gymnasium as gym

    from decomplex_bt.cli.episode import Episode
    from decomplex_bt.cli.reading import read

    reading = read("Bring me the apple.", "household", may_ask=False)
    episode = Episode(gym.make("decomplex_bt/Household-v0"), reading, 0)
    episode._is_out_of_time = is_out_of_time
    assert said in episode.verdict


def test_a_film_that_is_not_finished_leaves_nothing(tmp_path: Path) -> None:
    import numpy as np

    from decomplex_bt.cli.film import Film

    for ending in (".gif", ".mp4") if find_spec("imageio_ffmpeg") else (".gif",):
        path = tmp_path / f"film{ending}"
        path.write_text("what was there before")
        film = Film(path)
        film.add(np.zeros((64, 64, 3), dtype=np.uint8))
        film.discard()
        assert path.read_text() == "what was there before"
        assert [file.name for file in tmp_path.iterdir()] == [path.name]
        film = Film(path)
        film.close(np.zeros((64, 64, 3), dtype=np.uint8))
        film.discard()
        assert path.stat().st_size > 50
        assert [file.name for file in tmp_path.iterdir()] == [path.name]
        path.unlink()


@pytest.mark.parametrize("ending", [".gif", ".mp4"])
def test_a_folder_is_no_film(ending: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / f"film{ending}"
    folder.mkdir()
    assert main(["run", "Go to the kitchen.", "--record", str(folder)]) == 2
    assert "this is a folder" in capsys.readouterr().err


class Terminal(io.StringIO):
    """Somebody types."""

    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("typed", "asked", "status"),
    [
        ("on the moon\nthe pen\nOn The Bed\n", 3, 0),
        ("on the moon\n\n", 2, 2),
        ("on the moon\n", 2, 2),
        ("\n", 1, 2),
    ],
)
def test_an_answer_that_cannot_be_used_is_asked_for_again(typed, asked, status, monkeypatch, capsys) -> None:
    monkeypatch.setattr(sys, "stdin", Terminal(typed))
    assert main(["plan", "Put the cup."]) == status
    err = capsys.readouterr().err
    assert err.splitlines()[0].startswith("Where should I put it? ")
    assert err.count("Where should I put it? ") - err.count("lacks its goal") == asked
    assert err.count("answer otherwise, or just press Enter") == asked - 1


def test_what_the_text_itself_gets_wrong_is_not_asked_for_again(monkeypatch, capsys) -> None:
    monkeypatch.setattr(sys, "stdin", Terminal("on the bed\n" * 3))
    assert main(["plan", "Put the dragon."]) == 2
    assert "'the dragon' names nothing" in capsys.readouterr().err


def test_long_texts_are_not_quoted_as_a_whole(capsys: pytest.CaptureFixture[str]) -> None:
    said = "Good morning. " * 140
    assert main(["plan", said]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    quoted, _, rest = line.partition(" holds no task")
    assert rest
    assert quoted.startswith("decomplex-bt: 'Good morning.")
    assert quoted.endswith("'")
    assert "..." in quoted
    assert said.strip() not in line
    assert len(line) < 400


def test_no_input_and_no_room_for_output_are_no_program_errors(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", None)
    assert main(["parse"]) == 2
    assert "standard input is closed; give a file, or an instruction: echo TEXT | " in capsys.readouterr().err
    assert main(["plan", "Go to the kitchen."]) == 0

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("decomplex_bt.cli.plan.print_json", full)
    assert main(["plan", "Go to the kitchen.", "--json"]) == 2
    assert "cannot be written: No space left" in capsys.readouterr().err


def test_who_interrupts_is_told_so(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("decomplex_bt.cli.plan.print_json", interrupted)
    assert main(["plan", "Go to the kitchen.", "--json"]) == 130
    assert capsys.readouterr().err.strip().endswith("interrupted")


def test_video_needs_its_extra(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("decomplex_bt.cli.film.find_spec", lambda name: None)
    assert main(["run", "Go to the kitchen.", "--record", "film.mp4"]) == 2
    assert "decomplex-bt[video]" in capsys.readouterr().err


def test_video_is_written(tmp_path: Path) -> None:
    pytest.importorskip("imageio_ffmpeg")
    main(["run", "Go to the kitchen, then go to the bedroom.", "--record", str(tmp_path / "film.mp4")])
    assert (tmp_path / "film.mp4").stat().st_size > 1000


BAD = {
    "empty": ["run", ""],
    "only spaces": ["run", "   "],
    "punctuation": ["run", "?!?!"],
    "emoji": ["run", "🤖🤖"],
    "ten thousand words": ["run", "bring " * 10_000],
    "unknown thing": ["run", "Bring me the samovar."],
    "impossible goal": ["run", "Open the pen."],
    "nothing to do": ["tree", "Hello."],
    "surrogate": ["plan", "turn on \ud800"],
    "unknown command": ["fly"],
    "unknown option": ["run", "x", "--wings"],
    "seed no number": ["run", "Go to the kitchen.", "--seed", "x"],
    "negative seed": ["run", "Go to the kitchen.", "--seed", "-1"],
    "film of unknown kind": ["run", "Go to the kitchen.", "--record", "film.avi"],
    "film in no folder": ["run", "Go to the kitchen.", "--record", "/nowhere/at/all/film.gif"],
    "an agent twice": ["evaluate", str(INSTRUCTIONS), "--limit", "1", "-n", "1", "--agent", "idle", "--agent", "idle"],
    "no such file": ["parse", "/nowhere/at/all"],
    "no such corpus": ["corpus", "check", "/nowhere/at/all"],
    "unknown domain": ["parse", "-", "--domain", "spaceship"],
    "no domain": ["plan", "Go to the kitchen.", "--domain", ""],
    "no argument": ["run"],
    "slips above one": ["evaluate", "x.yaml", "--slips", "3"],
    "slips no number": ["evaluate", "x.yaml", "--slips", "nan"],
    "misses above one": ["evaluate", "x.yaml", "--misses", "2"],
    "meddling below zero": ["evaluate", "x.yaml", "--meddling", "-1"],
    "no jobs": ["evaluate", "x.yaml", "--jobs", "0"],
    "no jobs to reproduce": ["reproduce", "--jobs", "0"],
    "jobs below -1": ["reproduce", "--jobs", "-2"],
}


@pytest.mark.parametrize("arguments", BAD.values(), ids=BAD.keys())
def test_bad_input_is_one_line_and_status_2(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("decomplex-bt: ")
    assert err.count("\n") == 1
    assert "internal error" not in err


@pytest.mark.parametrize("option", [("--slips", "3"), ("--misses", "2"), ("--meddling", "-1"), ("--jobs", "0")])
def test_number_out_of_range_is_refused_before_the_corpus_is_read(
    option: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["evaluate", "/nowhere/at/all", *option]) == 2
    error = capsys.readouterr().err
    assert option[0] in error
    assert option[1] in error
    assert "/nowhere" not in error


def test_unknown_thing_names_the_nearest_known(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "Bring me the mugg."]) == 2
    assert "mug" in capsys.readouterr().err.replace("mugg", "")


def test_unanswered_question_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "Bring me."]) == 2
    assert "?" in capsys.readouterr().err


WORDED = {
    "question": (["plan", "Place the cup."], "or answer on a terminal"),
    "domain": (["plan", "Go to the kitchen.", "--domain", "ship"], "a folder, written with a slash as in ./ship"),
    "format": (["tree", "Go to the kitchen.", "--format", "svg"], "'--format' / '-f': 'svg' is not one of 'text'"),
}


@pytest.mark.parametrize(("arguments", "words"), WORDED.values(), ids=WORDED.keys())
def test_errors_speak_of_the_command_line(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    error = capsys.readouterr().err
    assert words in error
    assert "Value error" not in error


def test_corpus_check_names_file_line_and_example(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = '- {id: one, text: "[Go](1:motion) [home](1:goal).", flow: [1]}\n'
    broken = '- {id: two, text: "[Go](2:motion).", flow: [1]}\n'
    path = tmp_path / "voice.yaml"
    path.write_text(good, encoding="utf-8")
    assert main(["corpus", "check", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["instructions"] == 1
    path.write_text(good + broken, encoding="utf-8")
    assert main(["corpus", "check", str(path)]) == 2
    assert f"{path}:2: example 'two'" in capsys.readouterr().err


def test_corpus_stats_count_structures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (
        "[Bring](1:bringing) [me](1:recipient) [the samovar](1:object) if you [find](2:searching) "
        "[it](2:object=the samovar) [on the desk](2:location), else [tell](3:informing) [me](3:recipient)."
    )
    path = tmp_path / "voice.yaml"
    path.write_text(f'- {{id: one, text: "{text}", flow: [{{if: 2, then: [1], else: [3]}}]}}\n', encoding="utf-8")
    assert main(["corpus", "stats", str(path), "--json"]) == 0
    counts = json.loads(capsys.readouterr().out)["all"]
    assert counts["tasks"] == 3
    assert counts["task_types"]["searching"] == 1
    assert counts["structures"]["with an else"] == 1
    assert counts["structures"]["out of order"] == 0
    assert counts["structures"]["task before its condition"] == 1
    assert counts["out_of_house"] == pytest.approx(2 / 5)
    assert counts["unknown_nouns"] == pytest.approx(2 / 3, abs=1e-4)  # samovar twice, desk; "me" is no noun
    assert main(["corpus", "stats", str(path)]) == 0
    assert "with a condition" in capsys.readouterr().out


def test_corpus_stats_fit_a_terminal_and_tell_voices_when_asked(
    household_folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    splits = {"walt": "train", "petronella": "train", "bex": "development", "hana": "test"}
    for name in splits:
        shutil.copyfile(household_folder / "corpus" / f"{name}.yaml", tmp_path / f"{name}.yaml")
    rows = "".join(f"  {name}: {{description: someone, split: {split}}}\n" for name, split in splits.items())
    (tmp_path / "voices.yaml").write_text(f"voices:\n{rows}", encoding="utf-8")
    corpus = str(tmp_path)
    assert main(["corpus", "stats", corpus]) == 0
    splits = capsys.readouterr().out.splitlines()
    assert splits[0].split() == ["all", "train", "development", "test"]
    assert main(["corpus", "stats", corpus, "--voices"]) == 0
    voices = capsys.readouterr().out.splitlines()
    assert [line.split()[:2] for line in voices if line.startswith("hana ")] == [["hana", "110"]]
    assert max(map(len, splits + voices)) <= 80


def test_evaluate_writes_rows_and_summary(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    corpus = tmp_path / "voice.yaml"
    text = "[Turn](1:change_state) on [the tv](1:object)."
    corpus.write_text(f'- {{id: one, text: "{text}", flow: [1]}}\n', encoding="utf-8")
    assert main(["evaluate", str(corpus), "--episodes", "2", "--output", str(tmp_path / "out"), "--json"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8")) == summary
    rows = [json.loads(line) for line in (tmp_path / "out" / "rows.jsonl").read_text(encoding="utf-8").splitlines()]
    assert [row["seed"] for row in rows] == [0, 1]
    assert main(["evaluate", str(corpus), "--agent", "wizard"]) == 2
    assert "oracle" in capsys.readouterr().err


@pytest.mark.skipif(os.name == "nt" or sys.platform == "darwin", reason="names of files are Unicode there")
def test_results_of_a_corpus_whose_name_is_not_utf8_are_written(tmp_path: Path, capsys) -> None:
    corpus, out = (tmp_path / os.fsdecode(name) for name in (b"voice\xff.yaml", b"out\xff"))
    corpus.write_text('- {id: one, text: "[Go](1:motion) [home](1:goal=the kitchen).", flow: [1]}\n', encoding="utf-8")
    assert main(["evaluate", str(corpus), "-n", "1", "--agent", "idle", "--output", str(out), "--json"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert summary["settings"]["corpus"] == str(corpus)
    assert json.loads((out / "summary.json").read_text(encoding="utf-8")) == summary
    assert (out / "failures.txt").read_text(encoding="utf-8").startswith("idle, one, seed 0: ")


def test_evaluate_tells_the_way_from_a_text_to_a_corpus(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text, parsed, made = (tmp_path / f"x.{suffix}" for suffix in ("txt", "jsonl", "yaml"))
    convert = f"decomplex-bt corpus convert --from jsonl --to yaml {parsed} {made}"
    text.write_text("Turn on the tv.\nGo to the kitchen.\n", encoding="utf-8")
    assert main(["evaluate", str(text)]) == 2
    assert capsys.readouterr().err.endswith(f": decomplex-bt parse --json {text} > {parsed}; {convert}\n")
    assert main(["parse", "--json", str(text)]) == 0
    parsed.write_text(capsys.readouterr().out, encoding="utf-8")
    assert main(["evaluate", str(parsed)]) == 2
    assert capsys.readouterr().err.endswith(f": {convert}\n")
    assert main(convert.split()[1:]) == 0
    assert main(["evaluate", str(made), "--episodes", "1", "--agent", "idle"]) == 0


def test_parse_tells_how_an_instruction_is_given(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["parse", "Open the window; don't close it."]) == 2
    assert """echo 'Open the window; don'"'"'t close it.' | decomplex-bt parse""" in capsys.readouterr().err


@pytest.mark.parametrize("source", ["", " "])
def test_a_blank_is_no_file(source: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["parse", source]) == 2
    assert f"{source!r} names no file; give one, or - for standard input" in capsys.readouterr().err


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from decomplex_bt.cli import main; main(['--help']); "
        "heavy = ('spacy', 'scipy', 'pymunk', 'pygame', 'pydantic', 'rich'); "
        "print([m for m in heavy if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"
    for command in ("run", "parse", "plan", "tree", "train", "corpus", "evaluate"):
        assert f"\n  {command} " in done.stdout


@pytest.mark.parametrize("module", ["decomplex_bt", "decomplex_bt.cli"])
def test_the_package_runs_without_its_console_script(module: str) -> None:
    done = subprocess.run([sys.executable, "-m", module, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == decomplex_bt.__version__


@pytest.mark.parametrize("command", ['tree "Turn on the tv."', 'run "Turn on the tv." --seed 1', "corpus --help"])
def test_output_that_was_closed_from_the_start_is_no_error(command: str) -> None:
    shell = f"{shlex.quote(sys.executable)} -m decomplex_bt.cli {command} >&-"
    done = subprocess.run(["sh", "-c", shell], stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_reader_that_stops_is_no_error() -> None:
    lines = b"Turn on the tv.\n" * 400
    command = [sys.executable, "-m", "decomplex_bt.cli", "parse", "--json"]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdin is not None
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdin.write(lines)
    process.stdin.close()
    assert json.loads(process.stdout.readline())["text"] == "Turn on the tv."
    process.stdout.close()
    assert process.stderr.read() == b""
    assert process.wait(timeout=60) == 0


def test_reader_of_a_parsed_file_that_stops_is_no_error(tmp_path: Path) -> None:
    source = tmp_path / "lines.txt"
    source.write_text("Turn on the tv.\n" * 400, encoding="utf-8")
    command = [sys.executable, "-m", "decomplex_bt.cli", "parse", "--json", str(source)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    assert json.loads(process.stdout.readline())["text"] == "Turn on the tv."
    process.stdout.close()
    assert process.stderr.read() == b""
    assert process.wait(timeout=60) == 0


def test_standard_input_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "decomplex_bt.cli", "parse", "--json"]
    with (tmp_path / "lines.txt").open("w") as written_only:
        done = subprocess.run(command, stdin=written_only, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "<stdin>: cannot be read" in done.stderr


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        ('run "xyzzy" --json 2>&-', 2),
        ("parse --json 2>&- <&-", 2),
        ("corpus check /nowhere.yaml >&- 2>&-", 2),
    ],
)
def test_streams_that_are_closed_from_the_start_are_no_error(command: str, expected: int) -> None:
    shell = f"{shlex.quote(sys.executable)} -m decomplex_bt.cli {command}"
    done = subprocess.run(shell, shell=True, capture_output=True, text=True, check=False)
    assert done.returncode == expected
    assert "internal error" not in done.stderr
    assert all(line.startswith("{") for line in done.stdout.splitlines()), "data alone goes to standard output"


@pytest.fixture
def unread():
    """The writing end of a pipe that nobody reads."""
    reading, writing = os.pipe()
    os.close(reading)
    yield writing
    os.close(writing)


def test_remarks_that_nobody_reads_cost_no_output(unread: int, monkeypatch, capsys: pytest.CaptureFixture[str]) -> None:
    lines = b"Turn on the tv.\n\nGo to the kitchen.\n\n"
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(lines), encoding="utf-8"))
    monkeypatch.setattr(sys, "stderr", open(os.dup(unread), "w", encoding="utf-8"))  # noqa: SIM115 - until it is undone
    assert main(["parse", "--json"]) == 2
    parsed = [json.loads(line)["text"] for line in capsys.readouterr().out.splitlines()]
    assert parsed == ["Turn on the tv.", "Go to the kitchen."]
    sys.stderr.close()


def buffered(arguments: list[str], **streams) -> subprocess.CompletedProcess[str]:
    """The command line in a process of its own, which writes when it has much to write or ends."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    command = [sys.executable, "-m", "decomplex_bt.cli", *arguments]
    return subprocess.run(command, env=environment, text=True, check=False, **streams)


def test_errors_that_nobody_reads_have_their_exit_status(unread: int) -> None:
    done = buffered(["corpus", "check", "/nowhere.yaml"], stdout=subprocess.PIPE, stderr=unread)
    assert (done.returncode, done.stdout) == (2, "")


@pytest.mark.parametrize("arguments", [["--version"], ["corpus", "check", str(INSTRUCTIONS)]])
def test_short_output_that_nobody_reads_is_no_error(arguments: list[str], unread: int) -> None:
    done = buffered(arguments, stdout=unread, stderr=subprocess.PIPE)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize("arguments", [["--version"], ["corpus", "check", str(INSTRUCTIONS)]])
def test_short_output_that_finds_no_room_is_told_in_one_line(arguments: list[str]) -> None:
    with Path("/dev/full").open("w") as full:
        done = buffered(arguments, stdout=full, stderr=subprocess.PIPE)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert "the output cannot be written: No space left" in done.stderr


def test_reader_that_stops_hears_nothing_of_processes_that_were_at_work(tmp_path: Path) -> None:
    source = tmp_path / "lines.txt"
    source.write_text("Turn on the tv.\n" * 800, encoding="utf-8")
    command = [sys.executable, "-m", "decomplex_bt.cli", "parse", "--json", "--jobs", "2", str(source)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    assert process.stdout.readline()
    process.stdout.close()
    assert process.stderr.read() == b""
    assert process.wait(timeout=60) == 0


@pytest.mark.parametrize(
    "arguments",
    [
        ["evaluate", "{}.yaml"],
        ["evaluate", str(INSTRUCTIONS), "--output", "{}"],
        ["corpus", "check", "{}"],
        ["corpus", "convert", "{}.yaml", "out.jsonl", "--to", "jsonl"],
        ["corpus", "convert", str(INSTRUCTIONS), "{}.jsonl", "--to", "jsonl"],
        ["corpus", "score", str(INSTRUCTIONS), "--models", "{}"],
        ["run", "Go to the kitchen.", "--json", "--record", "{}.gif"],
        ["parse", "{}"],
        ["plan", "Go to the kitchen.", "--domain", "./{}"],
        ["train", "--corpus", "{}"],
    ],
)
def test_path_that_no_disk_takes_is_named_in_one_line(
    arguments: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([argument.format("n" * 300) for argument in arguments]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "n" * 300 in line
    assert "File name too long" in line
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("held_out", [{}, {"ann": (3, 4), "bob": (1, 5)}])
def test_train_tells_how_well_each_voice_was_read_the_worst_first(held_out, monkeypatch, capsys) -> None:
    from decomplex_bt.understanding import training

    report = training.TrainingReport(("ann", "bob"), 9, 0, Path("models"), held_out)
    monkeypatch.setattr(training, "train", lambda *arguments, **options: report)
    assert main(["train"]) == 0
    told = [line.split()[0] for line in capsys.readouterr().out.splitlines() if "%" in line]
    assert told == (["bob", "ann", "all"] if held_out else [])
    assert main(["train", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)["held_out"]
    assert {voice: (p["count"], p["total"]) for voice, p in printed.items()} == held_out
