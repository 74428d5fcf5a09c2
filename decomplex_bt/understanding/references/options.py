"""Options: the ways to fill a gap, among which a model chooses."""

from __future__ import annotations

from dataclasses import dataclass

from decomplex_bt.understanding.references.phrases import Candidate


@dataclass(frozen=True, slots=True)
class Option:
    """One way to fill a gap, `candidate` None for leaving it. `type`: that of the argument it makes; `shared`: the
    features of the candidate, one and the same tuple for all its spellings; `own`: those of this spelling."""

    candidate: Candidate | None
    type: str
    text: str
    shared: tuple[str, ...]
    own: tuple[str, ...] = ()

    @property
    def features(self) -> tuple[str, ...]:
        return (*self.shared, *self.own)

    @property
    def key(self) -> tuple[str, str]:
        return self.type, self.text.lower()
