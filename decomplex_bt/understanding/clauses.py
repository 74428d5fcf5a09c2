"""The clause around each task: the cues that open it, its negation, the state it tests, where it ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arcs import Polarity
from decomplex_bt.understanding.cues import GOVERNING, OPPOSITES, PRO_FORMS
from decomplex_bt.understanding.features import Observed


@dataclass(frozen=True, slots=True)
class MarkedTask:
    """A task as the flow model sees it: its token, its type and the tokens of its arguments as (type, indices)."""

    token: int
    type: str
    arguments: tuple[tuple[str, range], ...] = ()


@dataclass(frozen=True, slots=True)
class Clause:
    """What surrounds one task, in token indices.

    `far`: the cues between the task before and the last punctuation mark ahead of this one; `near`: those from there to
    the task; `behind`: those after the task up to the next punctuation mark or task. `first`/`last` bound the clause.
    """

    task: MarkedTask
    first: int
    last: int
    far: tuple[str, ...]
    near: tuple[str, ...]
    behind: tuple[str, ...]
    sentence: int
    boundary: str
    polarity: Polarity
    objects: tuple[str, ...]


_PUNCTUATION = frozenset((",", ".", ";", ":", "?", "!", "-", "–", "—", "...", "…", "(", ")"))
_SPEAKING = ("informing",)


def clauses_of(observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[Clause, ...]:
    """The clause of every task, in text order."""
    return tuple(_clause(observed, tasks, k) for k in range(len(tasks)))


def polarities_of(clauses: Sequence[Clause]) -> tuple[Polarity, ...]:
    return tuple(clause.polarity for clause in clauses)


def _clause(observed: Observed, tasks: Sequence[MarkedTask], k: int) -> Clause:
    document = observed.document
    token = tasks[k].token
    previous = tasks[k - 1].token if k else -1
    following = tasks[k + 1].token if k + 1 < len(tasks) else len(document)
    breaks = [j for j in range(previous + 1, token) if document.tokens[j].text in _PUNCTUATION]
    split = breaks[-1] if breaks else previous
    message = {j for kind, indices in tasks[k].arguments if kind == "message" for j in indices}
    end = next(
        (j for j in range(token + 1, following) if document.tokens[j].text in _PUNCTUATION and j not in message),
        following,
    )
    cues = [cue for cue in observed.cues if cue.first not in message]
    far = tuple(cue.name for cue in cues if previous < cue.first <= split)
    near = tuple(cue.name for cue in cues if split < cue.first < token)
    behind = tuple(cue.name for cue in cues if token < cue.first < end)
    opening = [cue.last for cue in cues if split < cue.first <= token and cue.name in GOVERNING]
    first = max(opening, default=split) + 1 if opening else split + 1
    closing = [cue.first for cue in cues if token < cue.first < end and cue.name in GOVERNING | PRO_FORMS]
    last = min([end, *closing]) - 1
    return Clause(
        task=tasks[k],
        first=min(first, token),
        last=max(last, token),
        far=far,
        near=near,
        behind=behind,
        sentence=document.sentences[token],
        boundary="start" if previous < 0 else (document.tokens[split].text if breaks else "none"),
        polarity=_polarity(observed, tasks[k], min(first, token), max(last, token), near),
        objects=tuple(
            document.tokens[j].lemma
            for kind, indices in tasks[k].arguments
            if kind == "object"
            for j in indices
            if document.tokens[j].pos in ("NOUN", "PROPN")
        ),
    )


def _polarity(observed: Observed, task: MarkedTask, first: int, last: int, near: Sequence[str]) -> Polarity:
    names = [cue.name for cue in observed.cues if first <= cue.first <= last]
    negations = names.count("not") + ("unless" in near)
    state = next(
        (
            observed.document.tokens[j].lower
            for j in range(min(task.token, last), last + 1)
            if observed.document.tokens[j].lower in OPPOSITES
        ),
        None,
    )
    return Polarity(negations % 2 == 1, state, OPPOSITES.get(state) if state else None)
