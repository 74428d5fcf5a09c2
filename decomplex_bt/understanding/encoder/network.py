"""The network in torch, for training only: a pretrained encoder with heads for tasks, arguments and references."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import torch
from torch import Tensor, nn
from torch.nn import functional

from decomplex_bt.understanding.encoder.heads import FARTHEST

IGNORED = -100


@dataclass(frozen=True, slots=True)
class Sizes:
    """Of the network's layers. `encoder`: of the pretrained encoder's vectors."""

    encoder: int
    task_labels: int
    argument_labels: int
    type_embedding: int = 32
    hidden: int = 192
    biaffine: int = 96


class Biaffine(nn.Module):
    """Scores of every pair of two sets of vectors, with one score per distance."""

    def __init__(self, size: int, hidden: int, outputs: int) -> None:
        super().__init__()
        self.a, self.b = nn.Linear(size, hidden), nn.Linear(size, hidden)
        self.u = nn.Parameter(torch.empty(outputs, hidden + 1, hidden + 1))
        self.dist = nn.Embedding(2 * FARTHEST + 1, outputs)
        nn.init.normal_(self.u, std=0.02)
        nn.init.zeros_(self.dist.weight)

    def forward(self, x: Tensor, y: Tensor, offsets: Tensor) -> Tensor:
        a, b = _with_one(_gelu(self.a(x))), _with_one(_gelu(self.b(y)))
        scores = torch.einsum("ih,ohk,jk->ijo", a, self.u, b)
        return scores + self.dist(offsets.clamp(-FARTHEST, FARTHEST) + FARTHEST)


class Network(nn.Module):
    """Encoder and heads. The heads' parameters have the names that `heads.Heads` reads."""

    def __init__(self, encoder: nn.Module, sizes: Sizes, *, dropout: float = 0.2) -> None:
        super().__init__()
        self.encoder = encoder
        s = sizes
        typed = s.encoder + s.type_embedding
        self.drop = nn.Dropout(dropout)
        self.task = nn.Linear(s.encoder, s.task_labels)
        self.ttype = nn.Embedding(s.task_labels, s.type_embedding)
        self.bio = nn.Sequential(nn.Linear(typed, s.hidden), _Gelu(), nn.Linear(s.hidden, s.argument_labels))
        self.owner = Biaffine(typed, s.biaffine, 1)
        self.refer = Biaffine(typed, s.biaffine, 1)

    def encode(self, ids: Tensor, mask: Tensor, firsts: Tensor) -> Tensor:
        """Token vectors (batch, tokens, size): of each token its first piece's. `firsts` (batch, tokens)."""
        states = self.encoder(input_ids=ids, attention_mask=mask).last_hidden_state
        return self.drop(states.gather(1, firsts.unsqueeze(-1).expand(-1, -1, states.shape[-1])))

    def typed(self, vectors: Tensor, types: Tensor) -> Tensor:
        return torch.cat([vectors, self.ttype(types)], -1)

    def heads(self) -> Mapping[str, Tensor]:
        """The parameters of all but the encoder."""
        return {name: value for name, value in self.state_dict().items() if not name.startswith("encoder.")}


class _Gelu(nn.Module):
    def forward(self, x: Tensor) -> Tensor:
        return _gelu(x)


def _gelu(x: Tensor) -> Tensor:
    return functional.gelu(x, approximate="tanh")


def _with_one(x: Tensor) -> Tensor:
    return torch.cat([x, x.new_ones(len(x), 1)], -1)
