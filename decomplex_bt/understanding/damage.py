"""Damage: a trained model that cannot be used, and the command that makes it anew."""

from __future__ import annotations

import shlex
from importlib.resources import files
from pathlib import Path

from decomplex_bt.errors import DataFileError

ENCODER_FOLDER = "encoder"
"""In a folder of models, that of the encoder."""


class ModelError(DataFileError):
    """A trained model is missing, damaged or made for other code; the message says how to make it anew where it is,
    `problem` does not."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(path, f"{problem}; run `{_training(path)}`")
        self.problem = problem


def _training(path: Path) -> str:
    """The command that makes the models of this file: of a domain where they lie in one, else into their folder."""
    path = path.resolve()
    is_encoder = path.parent.name == ENCODER_FOLDER
    models = path.parent.parent if is_encoder else path.parent
    domain, shipped = models.parent, Path(str(files("decomplex_bt.domains"))).resolve()
    target = ["--output", str(models), "--force"]
    if models.name == "models" and (domain / "ontology.yaml").is_file():
        target = ["--domain", domain.name if domain.parent == shipped else str(domain)]
    return shlex.join(["decomplex-bt", "train", *target, *(["--encoder"] if is_encoder else [])])
