"""Fitting a network: the same seed gives the same weights, and who waits is told how far it is."""

import random
from dataclasses import dataclass

import pytest

from decomplex_bt.understanding.encoder.fitting import REPORTS, Lessons, Pace, fit, precision
from decomplex_bt.understanding.encoder.pieces import Pieced

torch = pytest.importorskip("torch")
PACE = Pace(epochs=5, noised=0.5, recombined=0.0, encoder_rate=1e-2, heads_rate=1e-1)


@dataclass(frozen=True)
class Sample:
    """A number to learn, as long as itself."""

    value: int

    @property
    def pieced(self):
        return Pieced((1,) * self.value, (0,))


class Network(torch.nn.Module):
    def __init__(self):
        super().__init__()
        self.encoder, self.head = torch.nn.Linear(1, 2), torch.nn.Linear(2, 1)


def loss(network, batch):
    values = torch.tensor([[float(sample.value)] for sample in batch])
    with precision():
        found = network.encoder(values)
    return (network.head(found.float()) - 2 * values).pow(2).mean()


def fitted(seed=3):
    torch.manual_seed(0)
    network, told = Network(), []
    samples = [Sample(value) for value in range(1, 9)]
    fit(network, Lessons(samples * 12, samples * 9, ()), loss, PACE, random.Random(seed), told.append)
    return {name: value.tolist() for name, value in network.state_dict().items()}, told


def test_the_same_seed_gives_the_same_weights():
    assert fitted()[0] == fitted()[0]
    assert fitted()[0] != fitted(seed=4)[0]


def test_what_is_told_goes_to_the_end_and_the_loss_falls():
    told = fitted()[1]
    assert len(told) == REPORTS
    assert told[0].startswith("encoder 7%, loss "), "three of 45 steps"
    assert told[-1].startswith("encoder 100%, loss ")
    assert told[-1].endswith("about 0 minutes left")
    losses = [float(line.split("loss ")[1].split(",")[0]) for line in told]
    assert losses[-1] < losses[0] / 4


def test_half_precision_is_used_where_the_processor_has_it():
    has_it = torch.ops.mkldnn._is_mkldnn_bf16_supported()
    with precision():
        assert (torch.ones(2, 2) @ torch.ones(2, 2)).dtype == (torch.bfloat16 if has_it else torch.float32)
