"""The control flow read by the network and the CRFs together."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import prod
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import DataFileError
from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.dependencies import MAX_FLOWS, FlowModel, marked_tasks
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.encoder.flows import LABELS_FILE, EncoderFlows, FlowNetworkModel, Label
from decomplex_bt.understanding.encoder.model import PIECES_FILE
from decomplex_bt.understanding.encoder.pieces import Pieces
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import has_encoder

TEXT = (
    "[Check](1:check_state) [the fridge](1:object). If there [is](2:check_state) [milk](2:object), [bring](3:bringing) "
    "[me](3:recipient) [a glass](3:object), otherwise [tell](4:informing) [Anna](4:recipient) and "
    "[close](5:change_state) [the fridge](5:object)."
)
Marked = tuple[Observed, tuple[MarkedTask, ...]]


@pytest.fixture(scope="module")
def domain() -> Domain:
    loaded = load_domain("household")
    if not has_encoder(loaded.folder / "models"):
        pytest.skip("no encoder is installed")
    return loaded


@pytest.fixture(scope="module")
def network(domain: Domain) -> FlowNetworkModel:
    folder = domain.folder / "models" / "encoder"
    return FlowNetworkModel(folder, Pieces(folder / PIECES_FILE), domain.ontology)


@pytest.fixture(scope="module")
def flows(domain: Domain, network: FlowNetworkModel) -> EncoderFlows:
    return EncoderFlows(FlowModel(domain.folder / "models"), network)


@pytest.fixture(scope="module")
def marked(domain: Domain) -> Marked:
    instruction = read_markup(TEXT, domain.ontology, flow=[1, {"if": 2, "then": [3], "else": [4]}, 5])
    return _marked(domain, instruction)


def _marked(domain: Domain, instruction) -> Marked:
    observed = Observed(Parser().parse(instruction.text), Gazetteer.of(domain.lexicon, domain.kinds))
    return observed, marked_tasks(observed, instruction)


def test_alternatives_differ_and_the_likeliest_comes_first(flows: EncoderFlows, marked: Marked) -> None:
    found = flows.alternatives(*marked)
    assert 1 < len(found) <= MAX_FLOWS
    assert len({alternative.flow for alternative in found}) == len(found)
    chances = [prod(alternative.probabilities) for alternative in found]
    assert all(first >= second for first, second in pairwise(chances))
    assert all(0 < chance <= 1 for alternative in found for chance in alternative.probabilities)
    assert {len(alternative.arcs) for alternative in found} == {5}


def test_judgements_are_probabilities_and_do_not_depend_on_their_neighbours(
    network: FlowNetworkModel, marked: Marked
) -> None:
    settled = network.read(marked[0].document, marked[1])
    assert settled is not None
    assert settled.shape[:2] == (1, 5)
    ways = [["task"] * 5, ["task", "condition", "task", "task", "task"]]
    places = [["top"] * 5, ["top", "top", "<1+", "<1-", "top"]]
    for label in get_args(Label):
        together, alone = (
            network.judge(label, settled, ways, places),
            network.judge(label, settled, ways[1:], places[1:]),
        )
        assert np.allclose(np.exp(together).sum(axis=-1), 1, atol=1e-4)
        # weights of 8 bits: the scale is found anew in each run
        assert np.allclose(np.exp(together[1]), np.exp(alone[0]), atol=0.05)
    first, second = network.judge("attachment", settled, ways, places)
    assert not np.allclose(first, second, atol=0.1), "attachments do not depend on the roles"


def test_the_type_of_a_task_is_read(network: FlowNetworkModel, marked: Marked) -> None:
    observed, tasks = marked
    others = (*tasks[:3], MarkedTask(tasks[3].token, "check_state"), tasks[4])
    first, second = network.read(observed.document, tasks), network.read(observed.document, others)
    assert first is not None and second is not None  # noqa: PT018 - for the types
    assert not np.allclose(first, second, atol=0.1)


def test_a_single_task_needs_no_network(domain: Domain, flows: EncoderFlows) -> None:
    alone = _marked(domain, read_markup("[Close](1:change_state) [the door](1:object).", domain.ontology, flow=[1]))
    (found,) = flows.alternatives(*alone)
    assert found.flow.to_json() == [1]
    assert flows.alternatives(alone[0], ()) != ()


def test_what_is_too_long_for_the_network_is_read_by_the_crfs(
    domain: Domain, network: FlowNetworkModel, flows: EncoderFlows
) -> None:
    text = (
        "[Close](1:change_state) [the door](1:object) "
        + "and so on " * 180
        + "[open](2:change_state) [it](2:object=the door)."
    )
    long = _marked(domain, read_markup(text, domain.ontology, flow=[1, 2]))
    assert network.read(long[0].document, long[1]) is None
    assert flows.alternatives(*long) == FlowModel(domain.folder / "models").alternatives(*long)


def test_broken_labels_are_named(domain: Domain, tmp_path: Path) -> None:
    folder = domain.folder / "models" / "encoder"
    for file in folder.iterdir():
        (tmp_path / file.name).symlink_to(file)
    (tmp_path / LABELS_FILE).unlink()
    (tmp_path / LABELS_FILE).write_text('{"roles": []}', encoding="utf-8")
    with pytest.raises(DataFileError, match="decomplex-bt train"):
        FlowNetworkModel(tmp_path, Pieces(folder / PIECES_FILE), domain.ontology)


def test_the_same_in_every_process(domain: Domain, printed_under_hash_seeds: Callable[[str], set[str]]) -> None:
    program = (
        "from decomplex_bt.understanding.interpreter import Interpreter;"
        "i = Interpreter.load(encoder=True).interpret('If the tv is on, turn it off, but first close the window.');"
        "print(i.flow.to_json(), i.confidence, [(a.flow.to_json(), a.probability) for a in i.alternatives])"
    )
    assert len(printed_under_hash_seeds(program)) == 1


def test_a_layer_is_what_torch_calls_one_and_looks_at_tasks_alone() -> None:
    torch = pytest.importorskip("torch", reason="the extra train is not installed")
    from decomplex_bt.understanding.encoder.flow_network import Layer

    torch.manual_seed(0)
    own = Layer(12, 3, 20).eval()
    theirs = torch.nn.TransformerEncoderLayer(12, 3, 20, batch_first=True, activation="gelu", norm_first=True).eval()
    theirs.self_attn.in_proj_weight.data, theirs.self_attn.in_proj_bias.data = (
        own.asked.weight.data,
        own.asked.bias.data,
    )
    theirs.self_attn.out_proj.load_state_dict(own.told.state_dict())
    for mine, other in ((own.up, theirs.linear1), (own.down, theirs.linear2)):
        other.load_state_dict(mine.state_dict())
    for mine, other in zip(own.norms, (theirs.norm1, theirs.norm2), strict=True):
        other.load_state_dict(mine.state_dict())
    x, absent = torch.randn(2, 4, 12), torch.tensor([[False] * 4, [False, False, True, True]])
    with torch.no_grad():
        assert torch.allclose(own(x, None), theirs(x), atol=1e-5)
        padded = own(x, absent)
        assert torch.allclose(padded[1, :2], own(x[1:, :2], None)[0], atol=1e-5)
