"""The encoder at run time (onnxruntime and numpy): the vectors of an instruction's tokens."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from decomplex_bt.errors import DecomplexError
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.encoder.heads import Heads
from decomplex_bt.understanding.encoder.pieces import Pieces

ENCODER_FILE, HEADS_FILE, PIECES_FILE = "encoder.onnx", "heads.npz", "tokenizer.json"


class EncoderMissingError(DecomplexError):
    """The extra `encoder` is not installed."""


class EncoderModel:
    """A trained encoder with its heads, from a folder. Raises `EncoderMissingError` and `DataFileError`."""

    def __init__(self, folder: Path) -> None:
        self._session = open_session(folder / ENCODER_FILE)
        self.heads = Heads(folder / HEADS_FILE)
        self.pieces = Pieces(folder / PIECES_FILE)
        self.vectors = lru_cache(maxsize=4)(self._vectors)

    def _vectors(self, document: Document) -> np.ndarray:
        """(tokens, size): of each token the vector of its first piece."""
        pieced = self.pieces.of([token.text for token in document.tokens])
        ids = np.array([pieced.ids], np.int64)
        states = self._session.run(None, {"ids": ids, "mask": np.ones_like(ids)})[0][0]
        return states[list(pieced.firsts)]


def open_session(path: Path) -> Any:
    """A network from its file, ready to run. Raises `EncoderMissingError` and `DataFileError`."""
    try:
        import onnxruntime
    except ImportError:
        raise EncoderMissingError(
            'the encoder needs onnxruntime and tokenizers; install them with pip install "decomplex-bt[encoder]"'
        ) from None
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1  # the same sums on any machine, and no fight over cores between workers
    options.log_severity_level = 3
    try:
        return onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
    except Exception as error:  # the library raises its own exceptions, one for each kind of damage
        raise ModelError(path, f"no encoder ({error})") from None


def partial_run() -> Any:
    """Options for a run that computes the outputs asked for and nothing else."""
    import onnxruntime

    options = onnxruntime.RunOptions()
    options.only_execute_path_to_fetches = True
    return options
