"""The manifest beside trained models: what they are, what they were made from, and whether they may be loaded."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path

from decomplex_bt.domain.document import Record, check_record
from decomplex_bt.domain.loader import Domain
from decomplex_bt.understanding.crf import Crf
from decomplex_bt.understanding.damage import ModelError

MANIFEST_FILE = "manifest.json"
FEATURES_VERSION = 3
"""Raised with every change of features or labels: models of another version do not fit the code."""
MODEL_NAMES = ("tasks", "arguments", "roles", "attachments", "orders")
FILES = ("references.json", "readings.json", "calibration.json", "words.json")
"""What lies in a folder of models besides the CRFs."""
LIBRARIES = ("spacy", "python-crfsuite", "sklearn-crfsuite", "numpy")


class ModelEntry(Record):
    """One model file: its SHA-256 and its labels, sorted."""

    sha256: str
    labels: tuple[str, ...]


class Manifest(Record):
    """`manifest.json`. `files`: SHA-256 of what is no CRF; `corpus`: SHA-256 over the training voices' files;
    `base`: SHA-256 of the manifest of the models that training went on from, or of the first of those whose mean it is;
    `libraries`: versions the models were made with; `language_model`: the spaCy model whose tags the features came
    from; `references`: the voices that references and known words were learnt from, where that was done by itself, and
    all else is said of the others."""

    format: int
    features_version: int
    domain: str
    corpus: str
    voices: tuple[str, ...]
    examples: int
    base: str | None = None
    language_model: str
    libraries: dict[str, str]
    models: dict[str, ModelEntry]
    files: dict[str, str]
    references: tuple[str, ...] = ()


def write_manifest(
    folder: Path,
    domain: Domain,
    *,
    corpus: str,
    voices: Sequence[str],
    examples: int,
    base: str | None = None,
    language_model: str,
    libraries: Sequence[str] = LIBRARIES,
) -> None:
    """Writes the manifest for all models and other files that lie in `folder`."""
    manifest = Manifest(
        format=2,
        features_version=FEATURES_VERSION,
        domain=domain.name,
        corpus=corpus,
        voices=tuple(voices),
        examples=examples,
        base=base,
        language_model=language_model,
        libraries={name: version(name) for name in libraries},
        models={path.stem: _entry(path) for path in sorted(folder.glob("*.crf"))},
        files={name: file_hash(folder / name) for name in _others(folder)},
    )
    _write(folder, manifest)


def write_manifest_of_references(folder: Path, before: Manifest, voices: Sequence[str]) -> None:
    """Writes the manifest for models of which only the files that lie in `folder`, references and known words, are
    others than before."""
    renewed = {name: file_hash(folder / name) for name in _others(folder)}
    _write(folder, before.model_copy(update={"files": before.files | renewed, "references": tuple(voices)}))


def _write(folder: Path, manifest: Manifest) -> None:
    (folder / MANIFEST_FILE).write_text(manifest.model_dump_json(indent=1) + "\n", encoding="utf-8")


def _others(folder: Path) -> list[str]:
    """The names of what lies in a folder of models besides the CRFs and the manifest."""
    return sorted(p.name for p in folder.iterdir() if p.is_file() and p.suffix != ".crf" and p.name != MANIFEST_FILE)


def read_manifest(folder: Path) -> Manifest:
    """The manifest of a folder of models. Raises `DataFileError` where there is none or it is broken."""
    path = folder / MANIFEST_FILE
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise ModelError(path, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise ModelError(path, f"not valid UTF-8 at byte {error.start}") from None
    try:
        import json

        value = json.loads(text)
    except ValueError as error:
        raise ModelError(path, f"not valid JSON ({error})") from None
    return check_record(value, Manifest, path)


def check_models(
    folder: Path, domain: Domain, *, models: Sequence[str] = MODEL_NAMES, files: Sequence[str] = FILES
) -> Manifest:
    """The manifest, once it is sure that these models are whole and fit this code and this domain's labels.

    Raises `DataFileError` that names what does not fit.
    """
    manifest = read_manifest(folder)
    path = folder / MANIFEST_FILE
    if manifest.features_version != FEATURES_VERSION:
        raise ModelError(path, f"features_version {manifest.features_version}, expected {FEATURES_VERSION}")
    _check_files(folder, manifest, models, files)
    unknown = set(manifest.models["tasks"].labels if "tasks" in models else ()) - {"O", *domain.ontology.task_types}
    if unknown:
        raise ModelError(path, f"the task model knows {sorted(unknown)}, the ontology does not")
    return manifest


def check_encoder(models: Path, encoder: Path) -> None:
    """Makes sure that the encoder goes with the CRFs beside it: one has learnt from all the voices of the other.

    Either may have learnt from more, trained when their corpus had grown; what both have voices of their own of is two
    corpora. Raises `DataFileError`.
    """
    known, learnt = set(read_manifest(models).voices), read_manifest(encoder).voices
    strange = [voice for voice in learnt if voice not in known]
    if strange and not known <= set(learnt):
        named = ", ".join(strange[:3]) + (f" and {len(strange) - 3} more" if len(strange) > 3 else "")
        raise ModelError(
            encoder / MANIFEST_FILE,
            f"the encoder was not trained together with the models beside it: it has learnt from {named}, and they "
            "have not; train both on one corpus, or read without the encoder",
        )


def check_language(folder: Path, language_model: str) -> None:
    """Makes sure that the models fit spaCy's. Raises `DataFileError` where they were made with another version."""
    made_with = read_manifest(folder).language_model
    if language_model.rpartition("-")[2].split(".")[:2] != made_with.rpartition("-")[2].split(".")[:2]:
        raise ModelError(folder / MANIFEST_FILE, f"made with {made_with}, found {language_model}")


def _check_files(folder: Path, manifest: Manifest, models: Sequence[str], files: Sequence[str]) -> None:
    known = {f"{name}.crf": entry.sha256 for name, entry in manifest.models.items()} | manifest.files
    for name in (*(f"{model}.crf" for model in models), *files):
        path = folder / name
        if name not in known or not path.is_file():
            raise ModelError(path, "the model is missing")
        if file_hash(path) != known[name]:
            raise ModelError(path, "the model is not the one in the manifest (damaged?)")


def corpus_hash(files: Mapping[str, bytes]) -> str:
    """SHA-256 over names and contents, in the order of the names."""
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(name.encode() + b"\0" + hashlib.sha256(files[name]).digest())
    return digest.hexdigest()


def _entry(path: Path) -> ModelEntry:
    return ModelEntry(sha256=file_hash(path), labels=Crf(path).labels)


def file_hash(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
