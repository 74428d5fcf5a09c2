"""Networks as files: what is written comes back, as near as 8 bits allow."""

import pytest

from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.encoder.export import export, weights_of

torch = pytest.importorskip("torch")
pytest.importorskip("onnx")


class Network(torch.nn.Module):
    """An embedding, and two layers of the same size with a norm between them."""

    def __init__(self):
        super().__init__()
        self.words = torch.nn.Embedding(50, 8)
        self.first, self.norm, self.second = torch.nn.Linear(8, 8), torch.nn.LayerNorm(8), torch.nn.Linear(8, 8)

    def forward(self, ids):
        return self.second(self.norm(torch.relu(self.first(self.words(ids)))))


def test_the_weights_of_an_exported_network_come_back_by_their_names(tmp_path):
    torch.manual_seed(0)
    network, path = Network(), tmp_path / "network.onnx"
    export(network, (torch.ones(1, 3, dtype=torch.long),), path, inputs={"ids": {1: "pieces"}}, outputs=("states",))
    found = weights_of(path)
    assert set(found) == set(network.state_dict())
    for name, value in network.state_dict().items():
        assert found[name].shape == tuple(value.shape)
        step = float(value.max() - value.min()) / 255
        assert abs(found[name] - value.numpy()).max() <= step, name


def test_what_is_no_network_is_refused(tmp_path):
    (tmp_path / "network.onnx").write_text("no network", encoding="utf-8")
    with pytest.raises(DataFileError, match="no network of ours"):
        weights_of(tmp_path / "network.onnx")


def test_a_matrix_without_a_bias_has_no_name_to_be_found_by(tmp_path):
    network, path = torch.nn.Linear(8, 8, bias=False), tmp_path / "network.onnx"
    export(network, (torch.ones(1, 3, 8),), path, inputs={"vectors": {1: "pieces"}}, outputs=("states",))
    with pytest.raises(DataFileError, match="no network of ours"):
        weights_of(path)
