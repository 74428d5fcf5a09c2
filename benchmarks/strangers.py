"""How whole instructions of strangers are understood: every voice read by an interpreter that never saw it.

    python benchmarks/strangers.py FOLDER [--folds 3] [--only K ...] [--no-encoder] [--jobs N]

Splits the voices that are not for testing into folds. For each it trains on the others as `decomplex-bt train` does,
into FOLDER, and scores the voices left out: hours for each fold, the longer part for the encoder. What FOLDER has is
not done again, so that folds may be run one at a time (`--only`) and side by side. Prints every voice that has been
read, the worst first. The test voices are never read.
"""

from __future__ import annotations

import argparse
import json
import shutil
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from decomplex_bt.corpus import VOICES_FILE, read_corpus, read_voices
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.evaluation.metrics import LanguageScores, score
from decomplex_bt.evaluation.proportion import Proportion
from decomplex_bt.understanding.damage import ENCODER_FOLDER
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.training import train

Rows = dict[str, dict[str, Any]]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--folds", type=int, default=3)
    parser.add_argument("--only", type=int, nargs="*", metavar="K", help="folds from 0; default: all")
    parser.add_argument("--no-encoder", dest="encoder", action="store_false")
    parser.add_argument("--jobs", type=int, default=1, help="processes that train side by side; -1 for one a core")
    options = parser.parse_args()
    domain = load_domain("household")
    rows: Rows = {}
    for fold, left_out in folds_of(domain, options.folds).items():
        path = options.folder / f"fold-{fold}-of-{options.folds}"
        if options.only is None or fold in options.only:
            run(path, domain, left_out, encoder=options.encoder, jobs=options.jobs)
        rows |= read_rows(path, encoder=options.encoder)
    for line in table(rows):
        print(line)


def folds_of(domain: Domain, count: int) -> dict[int, tuple[str, ...]]:
    """Which voices each fold leaves out, as `decomplex-bt train` has them."""
    names = sorted(name for name, voice in read_voices(domain.folder / "corpus").items() if voice.split != "test")
    return {fold: tuple(names[fold::count]) for fold in range(count)}


def run(path: Path, domain: Domain, left_out: Collection[str], *, encoder: bool, jobs: int = 1) -> None:
    """Trains without the voices left out, and scores them, as far as that has not been done."""
    corpus, models = path / "corpus", path / "models"
    if not corpus.is_dir():
        copy_without(domain.folder / "corpus", corpus, left_out)
    for with_encoder in (False, True)[: 1 + encoder]:
        if scores_file(path, encoder=with_encoder).is_file():
            continue
        if not ((models / ENCODER_FOLDER if with_encoder else models) / "manifest.json").is_file():
            train(
                corpus,
                models,
                domain=domain,
                encoder=with_encoder,
                jobs=jobs,
                progress=lambda stage: print(f"{path}: {stage}"),
            )
        rows = dict(scored(Interpreter.load(domain, models=models, encoder=with_encoder), left_out))
        scores_file(path, encoder=with_encoder).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def copy_without(corpus: Path, to: Path, left_out: Collection[str]) -> None:
    """A copy of a corpus in which some more voices are for testing, so that nothing is learnt from them."""
    shutil.copytree(corpus, to)
    voices = yaml.safe_load((corpus / VOICES_FILE).read_text(encoding="utf-8"))
    for name in left_out:
        voices["voices"][name]["split"] = "test"
    (to / VOICES_FILE).write_text(yaml.safe_dump(voices, sort_keys=False, allow_unicode=True), encoding="utf-8")


def scored(interpreter: Interpreter, voices: Collection[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Each voice with its scores."""
    for name in voices:
        examples = read_corpus(interpreter.domain.folder / "corpus" / f"{name}.yaml", interpreter.domain.ontology)
        gold = [example.instruction for example in examples]
        found: LanguageScores = score(list(interpreter.interpret_batch([one.text for one in gold])), gold)
        yield name, found.to_json()


def scores_file(path: Path, *, encoder: bool) -> Path:
    return path / ("scores.json" if encoder else "scores_crfs.json")


def read_rows(path: Path, *, encoder: bool) -> Rows:
    file = scores_file(path, encoder=encoder)
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def table(rows: Mapping[str, Mapping[str, Any]]) -> Iterator[str]:
    """A line a voice, the worst flows first, then all together."""
    yield f"{'voice':<10} {'tasks':>6} {'arguments':>10} {'dependencies':>13} {'OER':>6}  flow exact; strict"
    for name, row in sorted(rows.items(), key=lambda item: item[1]["flow_exact"]["value"]):
        f1 = [row[part]["f1"] for part in ("tasks", "arguments", "dependencies")]
        shares = "; ".join(str(proportion([row], part)) for part in ("flow_exact", "strict"))
        yield f"{name:<10} {f1[0]:>6.3f} {f1[1]:>10.3f} {f1[2]:>13.3f} {row['oer']:>6.3f}  {shares}"
    for part in ("flow_exact", "strict"):
        yield f"{part} of {len(rows)} voices: {proportion(rows.values(), part)}"


def proportion(rows: Collection[Mapping[str, Any]], part: str) -> Proportion:
    return Proportion(sum(row[part]["count"] for row in rows), sum(row[part]["total"] for row in rows))


if __name__ == "__main__":
    main()
