"""The network of the control flow in torch, for training only: an encoder that reads an instruction whose tasks are
marked, and heads that say role, attachment and order of each task."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import torch
from torch import Tensor, nn

MOST_TASKS = 40
"""Tasks beyond this place count as standing there."""


@dataclass(frozen=True, slots=True)
class FlowSizes:
    """Of the network's layers. `encoder`: of the pretrained encoder's vectors; the rest: how many labels there are."""

    encoder: int
    roles: int
    attachments: int
    orders: int
    heads: int = 6
    hidden: int = 768


class Layer(nn.Module):
    """A layer of a transformer, norms first; torch's own is exported for one number of tasks only."""

    def __init__(self, size: int, heads: int, hidden: int, *, dropout: float = 0.1) -> None:
        super().__init__()
        self.heads = heads
        self.norms = nn.ModuleList(nn.LayerNorm(size) for _ in range(2))
        self.asked, self.told = nn.Linear(size, 3 * size), nn.Linear(size, size)
        self.up, self.down = nn.Linear(size, hidden), nn.Linear(hidden, size)
        self.drop = nn.Dropout(dropout)

    def forward(self, x: Tensor, absent: Tensor | None) -> Tensor:
        """As `x` (batch, tasks, size); `absent` (batch, tasks): which are no tasks and are not looked at."""
        asked = self.asked(self.norms[0](x))
        query, key, value = (part.unflatten(-1, (self.heads, -1)).transpose(1, 2) for part in asked.chunk(3, dim=-1))
        scores = query @ key.transpose(-1, -2) / sqrt(x.shape[-1] / self.heads)
        if absent is not None:
            scores = scores.masked_fill(absent[:, None, None, :], float("-inf"))
        seen = self.drop(scores.softmax(-1)) @ value
        x = x + self.drop(self.told(seen.transpose(1, 2).flatten(2)))
        changed: Tensor = x + self.drop(self.down(self.drop(nn.functional.gelu(self.up(self.norms[1](x))))))
        return changed


class FlowNetwork(nn.Module):
    """Encoder, then for each of the three labels a layer in which the tasks look at one another. Attachments are told
    with the roles known, orders with the attachments known as well."""

    def __init__(self, encoder: nn.Module, sizes: FlowSizes, *, dropout: float = 0.2) -> None:
        super().__init__()
        size = sizes.encoder
        self.encoder = encoder
        self.drop = nn.Dropout(dropout)
        self.role = nn.Embedding(sizes.roles, size)
        self.attachment = nn.Embedding(sizes.attachments, size)
        self.place = nn.Embedding(MOST_TASKS, size)
        for embedding in (self.role, self.attachment, self.place):
            nn.init.normal_(embedding.weight, std=0.02)
        self.layers = nn.ModuleList(Layer(size, sizes.heads, sizes.hidden) for _ in range(3))
        self.labels = nn.ModuleList(nn.Linear(size, n) for n in (sizes.roles, sizes.attachments, sizes.orders))

    def read(self, ids: Tensor, mask: Tensor, places: Tensor) -> Tensor:
        """Task vectors (batch, tasks, size); `places` (batch, tasks): the pieces at which the tasks are marked."""
        states = self.encoder(input_ids=ids, attention_mask=mask).last_hidden_state
        return self.drop(states.gather(1, places.unsqueeze(-1).expand(-1, -1, states.shape[-1])))

    def settle(self, vectors: Tensor, absent: Tensor | None = None) -> Tensor:
        """The task vectors (batch, tasks, size), each knowing of the others; `absent`: which of them are no tasks."""
        count = torch.arange(vectors.shape[1]).clamp(max=MOST_TASKS - 1)
        settled: Tensor = self.layers[0](vectors + self.place(count), absent)
        return settled

    def judge(
        self, settled: Tensor, roles: Tensor, attachments: Tensor, absent: Tensor | None = None
    ) -> tuple[Tensor, Tensor, Tensor]:
        """The scores of all labels (batch, tasks, labels), of attachments given `roles`, of orders given both."""
        known = self.layers[1](settled + self.role(roles), absent)
        placed = self.layers[2](known + self.attachment(attachments), absent)
        return self.labels[0](settled), self.labels[1](known), self.labels[2](placed)
