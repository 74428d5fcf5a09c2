"""Fitting a network on a pretrained encoder: what it learns from, the pace, batches of samples of like length."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain
from statistics import fmean
from typing import Any, Generic, Protocol, TypeVar

from decomplex_bt.understanding.encoder.pieces import Pieced

BATCH = 16
WARM_UP = 0.1
MEAN_OF = 0.15
"""The last part of the steps, of whose weights the mean is taken."""
REPORTS = 20
"""How often in all who waits is told how far it is."""


class HasPieces(Protocol):
    """A sample of any kind."""

    @property
    def pieced(self) -> Pieced:
        """Its text as pieces."""


S = TypeVar("S", bound=HasPieces)


T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Lessons(Generic[T]):
    """What a network learns from: examples as they are, noised copies of them, and recombined ones; `known`: examples
    it has learnt from before, lest it forget them."""

    plain: Sequence[T]
    noised: Sequence[T]
    recombined: Sequence[T]
    known: Sequence[T] = ()


@dataclass(frozen=True, slots=True)
class Pace:
    """How a network learns. `noised`, `recombined`, `known`: how many of these an epoch sees for each plain example,
    drawn anew each time; the rates are the highest ones, of the pretrained encoder and of all else; `kept`: how much of
    each weight stays as it was before."""

    epochs: int
    noised: float
    recombined: float
    encoder_rate: float
    heads_rate: float
    known: float = 0.0
    kept: float = 0.0


REHEARSAL = Pace(epochs=1, noised=0.15, recombined=0.1, encoder_rate=1e-4, heads_rate=5e-4)
"""For a network that goes once over all that it has learnt, and what is new."""


def fit(
    network: Any,
    lessons: Lessons[S],
    loss_of: Callable[[Any, Sequence[S]], Any],
    pace: Pace,
    rng: random.Random,
    progress: Callable[[str], None],
) -> None:
    """Fits a torch network, whose pretrained part is its `encoder`, by AdamW; its weights become the mean of the last
    ones, the chance of single batches evened out, and, as far as they are `kept`, of those before (Wortsman et al.,
    "Robust fine-tuning of zero-shot models", 2022): what is new is learnt nearly as well, and less is forgotten."""
    import torch
    from torch.optim.swa_utils import AveragedModel

    encoder = [p for name, p in network.named_parameters() if name.startswith("encoder.")]
    heads = [p for name, p in network.named_parameters() if not name.startswith("encoder.")]
    optimizer = torch.optim.AdamW(
        [{"params": encoder, "lr": pace.encoder_rate}, {"params": heads, "lr": pace.heads_rate}],
        weight_decay=0.01,
        fused=True,
    )
    copies = [
        (found, min(len(found), int(share * len(lessons.plain))))
        for found, share in (
            (lessons.noised, pace.noised),
            (lessons.recombined, pace.recombined),
            (lessons.known, pace.known),
        )
    ]
    steps = pace.epochs * math.ceil((len(lessons.plain) + sum(count for _, count in copies)) / BATCH)
    schedule = torch.optim.lr_scheduler.LambdaLR(
        optimizer, lambda t: min(t / (WARM_UP * steps), max(0.0, (steps - t) / steps))
    )
    before = {name: value.clone() for name, value in network.state_dict().items()}
    mean, step = AveragedModel(network), 0
    began, losses = time.monotonic(), list[float]()
    network.train()
    for _ in range(pace.epochs):
        drawn = chain.from_iterable(rng.sample(list(found), count) for found, count in copies)
        for batch in _batches([*lessons.plain, *drawn], rng):
            loss = loss_of(network, batch)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_([*encoder, *heads], 1.0)
            optimizer.step()
            schedule.step()
            step += 1
            if step > (1 - MEAN_OF) * steps:
                mean.update_parameters(network)
            losses.append(float(loss.detach()))
            if step * REPORTS // steps > (step - 1) * REPORTS // steps:
                left = (time.monotonic() - began) * (steps / step - 1) / 60
                progress(f"encoder {step / steps:.0%}, loss {fmean(losses):.2f}, about {left:.0f} minutes left")
                losses.clear()
    network.load_state_dict(
        {name: before[name].lerp(value, 1 - pace.kept) for name, value in mean.module.state_dict().items()}
    )
    network.eval()


def precision() -> Any:
    """The context in which a network reads: bfloat16 where the processor has it, else single precision, since torch
    then only imitates bfloat16, ten times slower."""
    import torch

    return torch.autocast("cpu", dtype=torch.bfloat16, enabled=torch.ops.mkldnn._is_mkldnn_bf16_supported())


def _batches(samples: list[S], rng: random.Random) -> list[list[S]]:
    """Batches of samples of like length, in random order."""
    rng.shuffle(samples)
    stretch = 20 * BATCH
    batches = []
    for first in range(0, len(samples), stretch):
        alike = sorted(samples[first : first + stretch], key=lambda sample: len(sample.pieced.ids))
        batches += [alike[i : i + BATCH] for i in range(0, len(alike), BATCH)]
    rng.shuffle(batches)
    return batches


def padded(values: Sequence[int], length: int, filler: int) -> list[int]:
    return [*values, *[filler] * (length - len(values))]
