"""Conversion between the formats of annotated instructions: what there is, which one a file is, all or nothing."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from decomplex_bt.corpus import VOICES_FILE, Example, read_corpus
from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.formats.brat import configuration, read_brat, write_brat
from decomplex_bt.formats.conll import read_conll, write_conll
from decomplex_bt.formats.huric import SUFFIX, read_huric
from decomplex_bt.formats.inline import write_inline
from decomplex_bt.formats.jsonlines import read_jsonlines, write_jsonlines

Reader = Callable[[Path, Domain], tuple[Example, ...]]
Writer = Callable[[Sequence[Example]], Mapping[str, str]]


@dataclass(frozen=True, slots=True)
class Format:
    """A format by name. `suffixes`: of its files, the first one is what a folder is searched for. `write` gives the
    texts of a voice's files by suffix; without it the format can only be read."""

    name: str
    suffixes: tuple[str, ...]
    read: Reader
    write: Writer | None = None


FORMATS: Mapping[str, Format] = {
    form.name: form
    for form in (
        Format("yaml", (".yaml", ".yml"), lambda path, domain: read_corpus(path, domain.ontology),
               lambda examples: {".yaml": write_inline(examples)}),
        Format("jsonl", (".jsonl",), lambda path, domain: read_jsonlines(path, domain.ontology),
               lambda examples: {".jsonl": write_jsonlines(examples)}),
        Format("conll", (".conll",), lambda path, domain: read_conll(path, domain.ontology),
               lambda examples: {".conll": write_conll(examples)}),
        Format("brat", (".ann", ".txt"), lambda path, domain: read_brat(path, domain.ontology), write_brat),
        Format("huric", (SUFFIX,), read_huric),
    )
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Conversion:
    """What was converted: the number of instructions and the files written."""

    instructions: int
    files: tuple[Path, ...]


def read_examples(path: Path, domain: Domain, form: str | None = None) -> tuple[Example, ...]:
    """The examples of a file, or of a folder's files, in the named format or the one that the names show.

    Raises `InputError`, `DataFileError` at the first fault.
    """
    chosen = _format(form) if form else _format_of(path)
    if not path.exists():
        raise DataFileError(path, "there is no such file or folder")
    if not path.is_dir() or chosen.name == "huric":
        return chosen.read(path, domain)
    examples: list[Example] = []
    for file in _files(path, chosen):
        examples += chosen.read(file, domain)
    if not examples:
        raise DataFileError(path, f"the folder holds no {chosen.name} file (*{chosen.suffixes[0]})")
    return tuple(examples)


def convert(
    source: Path, target: Path, domain: Domain, *, to: str, form: str | None = None, force: bool = False
) -> Conversion:
    """Reads `source` (a file, or a folder with a file a voice) and writes it to `target` in the format `to`.

    A folder becomes a folder, a file a file; for BRAT two files of one name. Files of the same names are replaced only
    with `force`, others are left alone. Nothing is written unless all could be read and said. Raises `InputError`.
    """
    wanted = _format(to)
    if wanted.write is None:
        writable = ", ".join(name for name, known in FORMATS.items() if known.write)
        raise InputError(f"--to {to}: this format is only read; expected one of {writable}")
    examples = read_examples(source, domain, form)
    if not examples:
        raise DataFileError(source, "there is no instruction in it")
    texts: dict[Path, str] = {}
    if source.is_dir():
        if target.exists() and not target.is_dir():
            raise InputError(f"{target} is a file; a folder is converted to a folder")
        for voice in sorted({example.voice for example in examples}):
            for suffix, text in wanted.write([e for e in examples if e.voice == voice]).items():
                texts[target / f"{voice}{suffix}"] = text
        if to == "brat":
            texts[target / "annotation.conf"] = configuration(domain.ontology)
    else:
        if target.is_dir():
            raise InputError(f"{target} is a folder; name the file to write, as in {target / source.stem}")
        written = wanted.write(examples)
        texts = {target.with_suffix(suffix) if len(written) > 1 else target: text for suffix, text in written.items()}
    if not force and (there := next((path for path in texts if path.exists()), None)):
        raise InputError(f"{there} exists already; name another place, or replace it with --force")
    _write(texts, target if source.is_dir() else target.parent)
    return Conversion(len(examples), tuple(texts))


def _format(name: str) -> Format:
    if name not in FORMATS:
        raise InputError(f"unknown format {name!r}; expected one of {', '.join(FORMATS)}")
    return FORMATS[name]


def _format_of(path: Path) -> Format:
    if not path.is_dir():
        for form in FORMATS.values():
            if path.suffix.lower() in form.suffixes:
                return form
        raise InputError(f"{path}: the name does not show the format; say --from {'|'.join(FORMATS)}")
    found = [form for form in FORMATS.values() if _files(path, form)]
    if len(found) != 1:
        names = ", ".join(form.name for form in found)
        what = f"files of several formats ({names})" if found else "no file of a known format"
        raise InputError(f"{path} holds {what}; say --from {'|'.join(FORMATS)}")
    return found[0]


def _files(folder: Path, form: Format) -> list[Path]:
    pattern = f"*{form.suffixes[0]}"
    files = folder.rglob(pattern) if form.name == "huric" else folder.glob(pattern)
    return sorted(file for file in files if file.name != VOICES_FILE)


def _write(texts: Mapping[Path, str], folder: Path) -> None:
    """Writes all files or none: each to a temporary name first, then all are moved."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder, prefix=".converting-") as scratch:
            for number, text in enumerate(texts.values()):
                (Path(scratch) / str(number)).write_bytes(text.encode("utf-8"))
            for number, path in enumerate(texts):
                os.replace(Path(scratch) / str(number), path)
    except OSError as error:
        raise InputError(f"{error.filename or folder} cannot be written: {error.strerror}") from None
