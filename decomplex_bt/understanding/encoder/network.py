"""The network in torch, for training only: a pretrained encoder with heads for tasks, arguments and control flow."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor, nn
from torch.nn import functional

from decomplex_bt.understanding.encoder.heads import FARTHEST, IMPOSSIBLE
from decomplex_bt.understanding.encoder.labels import ORDER_LABELS, ROLES, may_point

IGNORED = -100


@dataclass(frozen=True, slots=True)
class Sizes:
    """Of the network's layers. `encoder`: of the pretrained encoder's vectors."""

    encoder: int
    task_labels: int
    argument_labels: int
    task_features: int
    pair_features: int
    type_embedding: int = 32
    role_embedding: int = 32
    hidden: int = 192
    context: int = 256
    biaffine: int = 96
    task_bag: int = 96
    pair_bag: int = 48
    pair_hidden: int = 64


@dataclass(frozen=True, slots=True)
class FlowTarget:
    """The gold flow of one instruction as indices. `attachments`: 2j for the side of condition j as stated, 2j + 1 for
    the other, 2n for the top, `IGNORED` for mentions; `mentions`: the task mentioned, else `IGNORED`."""

    roles: tuple[int, ...]
    orders: tuple[int, ...]
    attachments: tuple[int, ...]
    mentions: tuple[int, ...]


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
        typed, with_role = s.encoder + s.type_embedding, s.context + s.role_embedding
        self.drop = nn.Dropout(dropout)
        self.task = nn.Linear(s.encoder, s.task_labels)
        self.ttype = nn.Embedding(s.task_labels, s.type_embedding)
        self.bio = nn.Sequential(nn.Linear(typed, s.hidden), _Gelu(), nn.Linear(s.hidden, s.argument_labels))
        self.owner = Biaffine(typed, s.biaffine, 1)
        self.tf = nn.EmbeddingBag(s.task_features + 1, s.task_bag, mode="sum", padding_idx=0)
        self.pf = nn.EmbeddingBag(s.pair_features + 1, s.pair_bag, mode="sum", padding_idx=0)
        for table in (self.tf, self.pf):
            nn.init.normal_(table.weight, std=0.1)
            with torch.no_grad():
                table.weight[0].zero_()
        self.mix = nn.Sequential(nn.Linear(3 * typed + s.task_bag, s.context), _Gelu(), nn.Dropout(dropout))
        self.role = nn.Linear(s.context + s.task_bag, len(ROLES))
        self.order = nn.Linear(s.context + s.task_bag, len(ORDER_LABELS))
        self.remb = nn.Embedding(len(ROLES), s.role_embedding)
        self.att = Biaffine(with_role, s.biaffine, 2)
        self.men = Biaffine(with_role, s.biaffine, 1)
        self.top = nn.Linear(with_role, 1)
        self.patt = nn.Sequential(
            nn.Linear(s.pair_bag + 2 * s.role_embedding, s.pair_hidden), _Gelu(), nn.Linear(s.pair_hidden, 3)
        )

    def encode(self, ids: Tensor, mask: Tensor, firsts: Tensor) -> Tensor:
        """Token vectors (batch, tokens, size): of each token its first piece's. `firsts` (batch, tokens)."""
        states = self.encoder(input_ids=ids, attention_mask=mask).last_hidden_state
        return self.drop(states.gather(1, firsts.unsqueeze(-1).expand(-1, -1, states.shape[-1])))

    def typed(self, vectors: Tensor, types: Tensor) -> Tensor:
        return torch.cat([vectors, self.ttype(types)], -1)

    def flow_loss(
        self,
        tasks: Tensor,
        names: Sequence[Sequence[int]],
        pairs: Sequence[Sequence[Sequence[int]]],
        target: FlowTarget,
    ) -> Tensor:
        """The loss of one instruction's flow given its tasks' typed vectors and the gold roles."""
        n = len(tasks)
        features = self.drop(self._bag(self.tf, names))
        nothing = tasks.new_zeros(1, tasks.shape[1])
        around = torch.cat([torch.cat([nothing, tasks[:-1]]), tasks, torch.cat([tasks[1:], nothing])], -1)
        context = self.mix(torch.cat([around, features], -1))
        described = torch.cat([context, features], -1)
        loss = functional.cross_entropy(self.role(described), torch.tensor(target.roles), reduction="sum")
        loss = loss + functional.cross_entropy(self.order(described), torch.tensor(target.orders), reduction="sum")
        role_vectors = self.remb(torch.tensor(target.roles))
        with_roles = torch.cat([context, role_vectors], -1)
        offsets = torch.arange(n)[None, :] - torch.arange(n)[:, None]
        bags = self.drop(self._bag(self.pf, [ids for row in pairs for ids in row])).view(n, n, -1)
        left, right = role_vectors[:, None].expand(n, n, -1), role_vectors[None].expand(n, n, -1)
        pair = self.patt(torch.cat([bags, left, right], -1))
        roles = [ROLES[i] for i in target.roles]
        possible = torch.tensor([[may_point(roles, k, j) for j in range(n)] for k in range(n)]).view(n, n)
        sides = self.att(with_roles, with_roles, offsets) + pair[..., :2]
        sides = sides.masked_fill(~possible[..., None], IMPOSSIBLE)
        scores = torch.cat([sides.flatten(1), self.top(with_roles)], -1)
        mentions = self.men(with_roles, with_roles, offsets)[..., 0] + pair[..., 2]
        mentions = mentions.masked_fill(~(possible & (offsets < 0)), IMPOSSIBLE)
        for logits, wanted in ((scores, target.attachments), (mentions, target.mentions)):
            if any(w != IGNORED for w in wanted):
                loss = loss + functional.cross_entropy(
                    logits, torch.tensor(wanted), ignore_index=IGNORED, reduction="sum"
                )
        return loss

    @staticmethod
    def _bag(table: nn.EmbeddingBag, bags: Sequence[Sequence[int]]) -> Tensor:
        rows, offsets = [], []
        for ids in bags:
            offsets.append(len(rows))
            rows += [i + 1 for i in ids] or [0]
        return table(torch.tensor(rows), torch.tensor(offsets))

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
