"""The heads in numpy are the network's in torch."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from decomplex_bt.understanding.encoder.heads import Heads

torch = pytest.importorskip("torch", reason="the extra train is not installed")


def test_the_heads_score_as_the_network_they_come_from(tmp_path: Path) -> None:
    from decomplex_bt.understanding.encoder.network import Network, Sizes

    torch.manual_seed(0)
    network = Network(torch.nn.Identity(), Sizes(encoder=12, task_labels=4, argument_labels=5))
    network.eval()
    weights = {name: value.numpy() for name, value in network.heads().items()}
    np.savez(tmp_path / "heads.npz", **weights)
    heads = Heads(tmp_path / "heads.npz")
    vectors, types, places = torch.randn(7, 12), [0, 2, 0, 1, 0, 3, 0], [1, 3, 5]
    typed = network.typed(vectors, torch.tensor(types))
    own = heads.typed(vectors.numpy(), types)
    anchors, gap = [0, 2, 6], 4
    offsets = torch.tensor([[2 - sum(p < anchor for p in places) for anchor in anchors]])
    with torch.no_grad():
        expected = network.refer(typed[[gap]], typed[anchors], offsets)[0, :, 0]
        assert np.allclose(heads.tasks(vectors.numpy()), network.task(vectors), atol=1e-5)
        assert np.allclose(heads.arguments(own), network.bio(typed), atol=1e-5)
        assert np.allclose(heads.references(own, gap, anchors, places), expected, atol=1e-5)
