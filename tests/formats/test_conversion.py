"""Every format says the whole corpus exactly; bad input is one clear error and nothing is written."""

from __future__ import annotations

import json
from pathlib import Path
from shutil import copyfile

import pytest

from decomplex_bt.cli import main
from decomplex_bt.corpus import parse_corpus, read_voices
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.formats.conversion import FORMATS, convert, read_examples

WRITTEN = tuple(name for name, form in FORMATS.items() if form.write)
ODD = r"""
- id: odd
  text: "\
    [Double-check](1:check_state) that\n\n\\[all\\] [lights](1:object) \
    [aren't](1:state=off)  \u2028 #1, then \
    [go](2:motion) [there\u2019s](2:goal=\"the\tden\")"
  implied: {2: {source: 'a "quoted" one'}}
  flow: [{if: 1, else: [2]}]
  source: "here: there"
  note: "# no comment"
- {id: empty of tasks, text: "Hello, \U0001f916!", flow: []}
"""
BREAKS = r"""
- id: "line\x85breaks"
  text: "\
    \x85\u2028[Turn](1:change_state) \
    [the\x85tv](1:object=a\x85b) on\x0b.\x85"
  implied: {1: {state: "o\x85n"}}
  flow: [1]
  note: "so\x85far"
"""


@pytest.fixture(scope="module")
def domain() -> Domain:
    return load_domain("household")


@pytest.fixture(scope="module", params=[pytest.param(1, marks=pytest.mark.slow), 8])
def shipped(domain: Domain, tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest) -> Path:
    """A copy of the voices that are in use, of one in so many."""
    folder = tmp_path_factory.mktemp("corpus")
    for voice in [*read_voices(domain.folder / "corpus")][:: request.param]:
        copyfile(domain.folder / "corpus" / f"{voice}.yaml", folder / f"{voice}.yaml")
    return folder


@pytest.mark.parametrize("form", WRITTEN)
def test_the_shipped_corpus_survives_a_round_trip(form: str, domain: Domain, shipped: Path, tmp_path: Path) -> None:
    convert(shipped, tmp_path / "out", domain, to=form)
    assert read_examples(tmp_path / "out", domain) == read_examples(shipped, domain)


@pytest.mark.parametrize("form", WRITTEN)
def test_odd_texts_survive_a_round_trip(form: str, domain: Domain, tmp_path: Path) -> None:
    (tmp_path / "odd.yaml").write_text(ODD + BREAKS, encoding="utf-8")
    examples = parse_corpus(ODD + BREAKS, domain.ontology, path="odd.yaml")
    assert "\n" in examples[0].instruction.text
    assert "\x85" in examples[-1].instruction.text
    target = tmp_path / f"out/odd{FORMATS[form].suffixes[0]}"
    convert(tmp_path / "odd.yaml", target, domain, to=form)
    assert read_examples(target, domain) == examples


@pytest.mark.parametrize("end", ["\r", "\n", "\ufeff"])
def test_what_brat_would_lose_is_refused(end: str, domain: Domain, tmp_path: Path) -> None:
    for number, text in enumerate((f"Hello{end}", f"{end}Hello")):
        said = json.dumps({"text": text, "tasks": [], "flow": []})
        (tmp_path / f"{number}.jsonl").write_text(said, encoding="utf-8")
        with pytest.raises(InputError, match="begins or ends with a line break or a byte order mark; not so in BRAT"):
            convert(tmp_path / f"{number}.jsonl", tmp_path / "out.ann", domain, to="brat")


def test_jsonl_is_what_parse_prints_without_confidences(domain: Domain, tmp_path: Path) -> None:
    (tmp_path / "odd.yaml").write_text(ODD, encoding="utf-8")
    convert(tmp_path / "odd.yaml", tmp_path / "odd.jsonl", domain, to="jsonl")
    first = json.loads((tmp_path / "odd.jsonl").read_text(encoding="utf-8").split("\n")[0])
    printed = parse_corpus(ODD, domain.ontology)[0].instruction.to_json()
    assert [key for key in first if key not in ("id", "source", "note")] == list(printed)
    assert list(first["tasks"][0]) == [key for key in printed["tasks"][0] if key != "confidence"]


def test_what_parse_prints_reads(domain: Domain, tmp_path: Path) -> None:
    examples = parse_corpus(ODD, domain.ontology, path="odd.yaml")
    lines = [json.dumps(example.instruction.to_json()) for example in examples]
    (tmp_path / "odd.jsonl").write_text("\n".join(lines), encoding="utf-8")
    read = read_examples(tmp_path / "odd.jsonl", domain)
    assert [example.instruction for example in read] == [example.instruction for example in examples]
    assert [example.id for example in read] == ["line-1", "line-2"]


GO = {"id": 1, "type": "motion", "start": 0, "end": 2}
BROKEN = {
    "no JSON": ("a.jsonl", "{", "a.jsonl:1: the line is not valid JSON"),
    "no object": ("a.jsonl", "[]", "expected an object"),
    "no text": ("a.jsonl", "{}", "'text' is missing"),
    "wrong surface": ("a.jsonl", {"tasks": [{**GO, "surface": "xx"}]}, "not 'xx'"),
    "wrong type": ("a.jsonl", {"tasks": [{**GO, "type": "fly"}]}, "unknown task type 'fly'"),
    "wrong flow": ("a.jsonl", {"tasks": [GO], "flow": [2]}, "there is no task 2"),
    "wrong label": ("a.jsonl", {"tasks": [{**GO, "dependency": "conditional"}]}, "by the flow it is 'sequential'"),
    "out of the text": ("a.jsonl", {"tasks": [{**GO, "end": 99}]}, "not in the text"),
    "overlap": (
        "a.jsonl",
        {"tasks": [{**GO, "arguments": [{"type": "goal", "start": 0, "end": 4, "value": "x"}]}]},
        "overlap",
    ),
    "half a character": ("a.jsonl", {"text": "go \ud800"}, r"a.jsonl:1: the line holds '\ud800', half of a character"),
    "half in a note": (
        "a.ann",
        'T1\tinstruction 0 2\tgo\n#1\tAnnotatorNotes T1\t{"id": "\\udc00", "flow": []}\n',
        r"holds '\udc00', half of a character",
    ),
    "unknown key": ("a.jsonl", {"flows": []}, "unknown key 'flows'"),
    "two of one id": ("a.jsonl", '{"id": "a", "text": "x", "tasks": [], "flow": []}\n' * 2, "stands twice"),
    "columns": ("a.conll", '# id = "a"\n# text = "go"\ngo\tmotion\n', "expected 5 columns"),
    "no id": ("a.conll", "go\tO\tO\t_\t_\n", "is missing"),
    "other words": ("a.conll", '# id = "a"\n# text = "go"\nrun\tO\tO\t_\t_\n', "does not follow"),
    "words left": ("a.conll", '# id = "a"\n# text = "go on"\ngo\tO\tO\t_\t_\n', "no token covers 'on'"),
    "no owner": ("a.conll", '# id = "a"\n# text = "go"\ngo\tO\tB-goal\t1\t_\n', "is no task"),
    "I after O": ("a.conll", '# id = "a"\n# text = "go"\ngo\tO\tI-goal\t1\t_\n', "begins with B"),
    "no note": ("a.ann", "T1\tinstruction 0 2\tgo\n", "id and flow"),
    "offsets": ("a.ann", "T1\tinstruction 0-2\tgo\n", "START END"),
    "unowned": ("a.ann", 'T1\tinstruction 0 2\tgo\n#1\tAnnotatorNotes T1\t{"id": "a"}\nT2\tgoal 0 2\tgo\n', "no task"),
    "stray": ("a.ann", "T1\tgoal 0 2\tgo\n", "lies in no instruction"),
    "not UTF-8": ("a.jsonl", b"\xff", "not valid UTF-8"),
    "no XML": ("a.hrc", "<huricExample>", "not valid XML"),
    "other XML": ("a.hrc", "<html/>", "expected a huricExample"),
    "unknown name": ("a.csv", "x", "--from"),
    "nothing in it": ("a.jsonl", "", "no instruction"),
}


@pytest.mark.parametrize(("name", "content", "problem"), BROKEN.values(), ids=BROKEN.keys())
def test_a_broken_file_is_one_line_and_nothing_is_written(
    name: str, content: object, problem: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if isinstance(content, dict):
        content = json.dumps({"text": "go home", "tasks": [], "flow": [1] * len(content.get("tasks", [])), **content})
    (tmp_path / name).write_bytes(content if isinstance(content, bytes) else str(content).encode())
    (tmp_path / "a.txt").write_text("go\n", encoding="utf-8")
    assert main(["corpus", "convert", str(tmp_path / name), str(tmp_path / "out" / "x.yaml"), "--to", "yaml"]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert problem in err
    assert not (tmp_path / "out").exists()


def test_a_format_must_be_known_and_one_that_is_written(domain: Domain, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="jsonl, conll"):
        convert(tmp_path, tmp_path, domain, to="xml")
    with pytest.raises(InputError, match="only read"):
        convert(tmp_path, tmp_path, domain, to="huric")


def test_a_folder_with_files_of_several_formats_needs_from(domain: Domain, tmp_path: Path) -> None:
    for name in ("a.jsonl", "a.conll"):
        (tmp_path / name).write_text("", encoding="utf-8")
    with pytest.raises(InputError, match="--from"):
        read_examples(tmp_path, domain)


@pytest.mark.parametrize("out", ["in.yaml", "other.yaml", "x.ann"])
def test_convert_replaces_nothing_unasked(out: str, tmp_path: Path, capsys) -> None:
    kept = {"in.yaml": ODD, "other.yaml": "mine", "x.txt": "mine"}
    for name, text in kept.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    form = "brat" if out == "x.ann" else "yaml"
    arguments = ["corpus", "convert", str(tmp_path / "in.yaml"), str(tmp_path / out), "--to", form]
    assert main(arguments) == 2
    assert "exists already; name another place, or replace it with --force" in capsys.readouterr().err
    assert {path.name: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()} == kept
    assert main([*arguments, "--force"]) == 0


def test_convert_replaces_only_what_it_writes(domain: Domain, tmp_path: Path, capsys) -> None:
    (tmp_path / "in.yaml").write_text(ODD, encoding="utf-8")
    (tmp_path / "keep.txt").write_text("mine", encoding="utf-8")
    assert main(["corpus", "convert", str(tmp_path / "in.yaml"), str(tmp_path / "x.ann"), "--to=brat", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["instructions"] == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.yaml", "keep.txt", "x.ann", "x.txt"]
