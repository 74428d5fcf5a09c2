"""The manifest beside trained models: what they are, what they were made from, and whether they may be loaded."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path

from decomplex_bt.domain.document import Record, check_record
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.crf import Crf

MANIFEST_FILE = "manifest.json"
FEATURES_VERSION = 1
"""Raised with every change of features or labels: models of another version do not fit the code."""
MODEL_NAMES = ("tasks", "arguments", "references", "roles", "attachments", "orders")
WEIGHTS_FILE = "readings.json"
LIBRARIES = ("spacy", "python-crfsuite", "sklearn-crfsuite", "numpy")


class ModelEntry(Record):
    """One model file: its SHA-256 and its labels, sorted."""

    sha256: str
    labels: tuple[str, ...]


class Manifest(Record):
    """`manifest.json`. `weights`: SHA-256 of the weights of readings; `corpus`: SHA-256 over the training voices'
    files; `libraries`: versions the models were made with; `language_model`: the spaCy model whose tags the features
    came from."""

    format: int
    features_version: int
    domain: str
    corpus: str
    voices: tuple[str, ...]
    examples: int
    language_model: str
    libraries: dict[str, str]
    models: dict[str, ModelEntry]
    weights: str


def write_manifest(
    folder: Path, domain: Domain, *, corpus: str, voices: Sequence[str], examples: int, language_model: str
) -> None:
    """Writes the manifest for the models that lie in `folder`."""
    manifest = Manifest(
        format=1,
        features_version=FEATURES_VERSION,
        domain=domain.name,
        corpus=corpus,
        voices=tuple(voices),
        examples=examples,
        language_model=language_model,
        libraries={name: version(name) for name in LIBRARIES},
        models={name: _entry(folder / f"{name}.crf") for name in MODEL_NAMES},
        weights=_sha256(folder / WEIGHTS_FILE),
    )
    (folder / MANIFEST_FILE).write_text(manifest.model_dump_json(indent=1) + "\n", encoding="utf-8")


def read_manifest(folder: Path) -> Manifest:
    """The manifest of a folder of models. Raises `DataFileError` where there is none or it is broken."""
    path = folder / MANIFEST_FILE
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise DataFileError(path, f"cannot be read ({error}); train the models with `decomplex-bt train`") from None
    try:
        import json

        value = json.loads(text)
    except ValueError as error:
        raise DataFileError(path, f"not valid JSON: {error}") from None
    return check_record(value, Manifest, path)


def check_models(folder: Path, domain: Domain, language_model: str) -> Manifest:
    """The manifest, once it is sure that the models fit this code, this domain's labels and spaCy's model.

    Raises `DataFileError` that names what does not fit.
    """
    manifest = read_manifest(folder)
    path = folder / MANIFEST_FILE
    if manifest.features_version != FEATURES_VERSION:
        raise DataFileError(
            path, f"features_version {manifest.features_version}, expected {FEATURES_VERSION}; run `decomplex-bt train`"
        )
    if language_model.rpartition("-")[2].split(".")[:2] != manifest.language_model.rpartition("-")[2].split(".")[:2]:
        raise DataFileError(
            path, f"made with {manifest.language_model}, found {language_model}; run `decomplex-bt train`"
        )
    _check_files(folder, manifest)
    unknown = set(manifest.models["tasks"].labels) - {"O", *domain.ontology.task_types}
    if unknown:
        raise DataFileError(
            path, f"the task model knows {sorted(unknown)}, the ontology does not; run `decomplex-bt train`"
        )
    return manifest


def _check_files(folder: Path, manifest: Manifest) -> None:
    for name in MODEL_NAMES:
        path = folder / f"{name}.crf"
        entry = manifest.models.get(name)
        if entry is None or not path.is_file():
            raise DataFileError(path, "the model is missing; run `decomplex-bt train`")
        if _sha256(path) != entry.sha256:
            raise DataFileError(path, "the model is not the one in the manifest (damaged?); run `decomplex-bt train`")
    path = folder / WEIGHTS_FILE
    if not path.is_file() or _sha256(path) != manifest.weights:
        raise DataFileError(path, "the weights are not those of the manifest (damaged?); run `decomplex-bt train`")


def corpus_hash(files: Mapping[str, bytes]) -> str:
    """SHA-256 over names and contents, in the order of the names."""
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(name.encode() + b"\0" + hashlib.sha256(files[name]).digest())
    return digest.hexdigest()


def _entry(path: Path) -> ModelEntry:
    return ModelEntry(sha256=_sha256(path), labels=Crf(path).labels)


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
