"""Training is reproducible, leaves the test voices alone and writes all or nothing."""

import math
import shutil
from dataclasses import replace

import pytest

from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.understanding import manifest, training
from decomplex_bt.understanding.encoder.stages import FOLDER_FILES
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.manifest import file_hash, read_manifest, write_manifest
from decomplex_bt.understanding.training import train


@pytest.fixture
def small_corpus(tmp_path, household_folder):
    folder = tmp_path / "corpus"
    folder.mkdir()
    examples = (household_folder / "corpus" / "walt.yaml").read_text(encoding="utf-8").split("\n- id: ")
    (folder / "learn.yaml").write_text("\n- id: ".join(examples[:25]) + "\n", encoding="utf-8")
    (folder / "keep.yaml").write_text("this is no corpus", encoding="utf-8")
    (folder / "voices.yaml").write_text(
        "voices:\n  learn: {description: a, split: train}\n  keep: {description: b, split: test}\n", encoding="utf-8"
    )
    return folder


def test_the_same_corpus_gives_the_same_bytes_and_never_reads_test_voices(small_corpus, tmp_path):
    reports = [train(small_corpus, tmp_path / name, jobs=jobs) for name, jobs in (("first", 1), ("second", 2))]
    assert reports[0].held_out == reports[1].held_out
    ((voice, (right, count)),) = reports[0].held_out.items()
    assert (voice, count) == ("learn", 13), "every other one"
    assert 0 < right < count, "25 instructions teach something, and not all"
    files = sorted(file.name for file in (tmp_path / "first").iterdir())
    assert files == sorted(file.name for file in (tmp_path / "second").iterdir())
    for file in files:
        assert (tmp_path / "first" / file).read_bytes() == (tmp_path / "second" / file).read_bytes(), file
    manifest = read_manifest(tmp_path / "first")
    assert manifest.voices == ("learn",)
    assert manifest.examples == 25
    assert Interpreter.load("household", models=tmp_path / "first").interpret("Close the door.").text


def test_nothing_is_written_where_the_corpus_is_broken(small_corpus, tmp_path):
    (small_corpus / "learn.yaml").write_text("- id: a\n  text: '[go](1:fly)'\n  flow: [1]\n", encoding="utf-8")
    with pytest.raises(DataFileError, match="unknown label"):
        train(small_corpus, tmp_path / "models")
    assert not (tmp_path / "models").exists()


@pytest.fixture
def untaught(monkeypatch):
    """Training that comes to a file named for the number of examples; gives how often it was asked for."""
    calls = []

    def trained(folder, examples, *others, **options):
        calls.append(examples)
        (folder / "words.json").write_text(f"{len(examples)}", encoding="utf-8")
        return 0, {}

    monkeypatch.setattr(training, "train_models", trained)
    monkeypatch.setattr(training, "train_with_encoder", trained)
    monkeypatch.setattr(manifest, "version", lambda library: "1.0")  # of what the extra brings, too
    return calls


@pytest.mark.parametrize("encoder", [False, True])
def test_models_are_replaced_by_those_of_another_corpus_only_by_force(
    encoder, small_corpus, household_folder, tmp_path, untaught
):
    (tmp_path / "own").mkdir()
    for name in ("ontology.yaml", "kinds.yaml", "house.yaml", "words.yaml", "goals.yaml", "domain.pddl"):
        shutil.copyfile(household_folder / name, tmp_path / "own" / name)
    shutil.copytree(small_corpus, tmp_path / "own" / "corpus")
    for _ in range(2):  # its own are made anew
        train(domain=tmp_path / "own", encoder=encoder)
    models = tmp_path / "own" / "models" / ("encoder" if encoder else "")
    before = (models / "manifest.json").read_bytes()
    with pytest.raises(InputError, match=r"holds models already; name another folder with --output, .* --force"):
        train(small_corpus, domain=tmp_path / "own", encoder=encoder)
    assert len(untaught) == 2
    assert (models / "manifest.json").read_bytes() == before
    assert train(small_corpus, domain=tmp_path / "own", encoder=encoder, force=True).folder == models


@pytest.fixture
def base(tmp_path):
    """A folder that passes for an encoder that knows a training and a development voice of the domain's own corpus, and
    one of another."""
    folder = tmp_path / "base"
    folder.mkdir()
    for name in FOLDER_FILES:
        (folder / name).write_text(name, encoding="utf-8")
    known = {
        "corpus": "",
        "voices": ("bex", "elsewhere", "walt"),
        "examples": 2,
        "language_model": "none",
        "libraries": (),
    }
    write_manifest(folder, load_domain("household"), **known)
    return folder


def test_training_goes_on_with_the_known_voices_of_the_domain_beside_new_ones(small_corpus, base, tmp_path, untaught):
    report = train(small_corpus, tmp_path / "models", encoder=True, base=base)
    assert report.voices == ("learn", "bex", "walt")
    assert {example.voice for example in untaught[0]} == {"learn", "walt", "bex"}
    written = read_manifest(report.folder)
    assert written.base == file_hash(base / "manifest.json")
    assert written.voices == ("learn", "bex", "walt", "elsewhere"), "what it has ever learnt from"


def test_training_does_not_go_on_where_nothing_is_new_or_names_clash(small_corpus, base, tmp_path, untaught):
    def go_on(**options):
        train(small_corpus, tmp_path / "models", **{"encoder": True, "base": base, **options})

    with pytest.raises(InputError, match=r"nothing but the encoder goes on .*; leave .*base out, or add --encoder"):
        go_on(encoder=False)
    with pytest.raises(
        InputError, match=r"^--from \S*: holds no encoder .*manifest\.json: .*; give the folder of one, as"
    ):
        go_on(base=tmp_path)
    (base / FOLDER_FILES[0]).write_text("damaged", encoding="utf-8")
    with pytest.raises(InputError, match=r"holds no encoder .*: the model is not the one in the manifest") as refused:
        go_on()
    assert "decomplex-bt train" not in str(refused.value), "it would be made anew from other voices, if at all"
    (base / FOLDER_FILES[0]).write_text(FOLDER_FILES[0], encoding="utf-8")
    voices = small_corpus / "voices.yaml"
    voices.write_text("voices:\n  keep: {description: b, split: test}\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"base knows every training voice of .*corpus; add one"):
        go_on()
    with pytest.raises(InputError, match=r"trained already can be rehearsed; .* --from"):
        train(small_corpus, tmp_path / "models", encoder=True, rehearse=True)
    with pytest.raises(InputError, match=r"references are trained by themselves"):
        train(small_corpus, tmp_path / "models", references=True, rehearse=True)
    shutil.copyfile(small_corpus / "learn.yaml", small_corpus / "walt.yaml")
    voices.write_text("voices:\n  walt: {description: b, split: train}\n", encoding="utf-8")
    with pytest.raises(InputError, match="'walt' is a voice of the domain's own corpus, too; give yours another name"):
        go_on()
    assert not untaught


def test_what_the_base_knows_is_rehearsed(small_corpus, base, tmp_path, untaught, monkeypatch):
    told = []
    taught = training.train_with_encoder

    def heard(*arguments, **options):
        told.append(options["rehearse"])
        return taught(*arguments, **options)

    monkeypatch.setattr(training, "train_with_encoder", heard)
    shutil.copyfile(small_corpus / "learn.yaml", small_corpus / "elsewhere.yaml")
    voices = small_corpus / "voices.yaml"
    voices.write_text("voices:\n  elsewhere: {description: a, split: train}\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"knows every training voice .* --rehearse"):
        train(small_corpus, tmp_path / "models", encoder=True, base=base)
    train(small_corpus, tmp_path / "models", encoder=True, base=base, rehearse=True)
    assert told == [True]
    assert {example.voice for example in untaught[0]} == {"elsewhere", "walt", "bex"}


def test_what_is_rehearsed_is_all_and_a_fifth_of_it_is_copied(small_corpus):
    ontology = load_domain("household").ontology
    examples = [replace(e, id=str(i)) for i, e in enumerate(read_corpus(small_corpus / "learn.yaml", ontology) * 5)]
    copied, others = training._rehearsed(examples)
    assert len(copied) == math.ceil(len(examples) / 5)
    assert sorted([e.instruction.text for e in copied] + [i.text for i in others]) == sorted(
        e.instruction.text for e in examples
    )
    assert training._rehearsed(examples)[0] == copied, "the same ones each time"


def test_references_are_learnt_by_themselves_beside_models_that_stay(small_corpus, tmp_path, household_folder):
    models = tmp_path / "models"
    shutil.copytree(household_folder / "models", models, ignore=shutil.ignore_patterns("encoder"))
    before = {file.name: file.read_bytes() for file in models.iterdir()}
    with pytest.raises(InputError, match="holds models already"):
        train(small_corpus, models, references=True)
    with pytest.raises(InputError, match="leave out --encoder"):
        train(small_corpus, models, references=True, encoder=True)
    with pytest.raises(InputError, match="empty holds no models"):
        train(small_corpus, tmp_path / "empty", references=True)
    own = tmp_path / "own"  # a domain whose corpus is small
    shutil.copytree(household_folder, own, ignore=shutil.ignore_patterns("corpus", "encoder"))
    shutil.copytree(small_corpus, own / "corpus")
    (own / "models" / "references.json").write_text("damaged", encoding="utf-8")  # which is mended so
    report = train(domain=own, references=True)
    after = {file.name: file.read_bytes() for file in (own / "models").iterdir()}
    changed = {name for name in after if after[name] != before[name]}
    assert changed == {"references.json", "words.json", "manifest.json"}
    assert (report.voices, report.examples) == (("learn",), 25)
    written = read_manifest(own / "models")
    assert written.references == ("learn",)
    assert written.voices == read_manifest(models).voices
    assert Interpreter.load(own, encoder=False).interpret("Close the door.").tasks


@pytest.mark.parametrize("place", ["a file", "a file/within", "/proc/models", "n" * 300])
def test_an_output_that_cannot_be_written_is_refused_before_anything_is_trained(
    place, small_corpus, tmp_path, untaught
):
    (tmp_path / "a file").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match=r"cannot write there: .*; give another folder"):
        train(small_corpus, tmp_path / place)
    assert not untaught


def test_models_that_are_only_half_in_place_have_no_manifest(small_corpus, tmp_path, untaught, monkeypatch):
    def interrupted(*paths):
        raise KeyboardInterrupt

    train(small_corpus, tmp_path / "models")
    monkeypatch.setattr(training.os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        train(small_corpus, tmp_path / "models", force=True)
    assert [file.name for file in (tmp_path / "models").iterdir()] == ["words.json"]


def test_the_shipped_models_are_small_and_know_what_they_were_made_from():
    folder = load_domain("household").folder
    manifest = read_manifest(folder / "models")
    assert sum(file.stat().st_size for file in (folder / "models").iterdir()) < 20_000_000
    assert manifest.domain == "household"
    assert set(manifest.libraries) >= {"spacy", "python-crfsuite"}


def test_the_flow_models_do_not_depend_on_the_hash_seed(printed_under_hash_seeds):
    program = """
import hashlib, tempfile
from pathlib import Path
from decomplex_bt.corpus import read_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.dependencies import train_flow
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.training import observe

domain = load_domain("household")
examples = read_corpus(domain.folder / "corpus" / "walt.yaml", domain.ontology)[:40]
data = observe([e.instruction for e in examples], Parser(), Gazetteer.of(domain.lexicon, domain.kinds))
with tempfile.TemporaryDirectory() as folder:
    train_flow(Path(folder), data)
    for file in sorted(Path(folder).iterdir()):
        print(file.name, hashlib.sha256(file.read_bytes()).hexdigest())
"""
    (printed,) = printed_under_hash_seeds(program)
    assert printed.count(".crf") == 3
