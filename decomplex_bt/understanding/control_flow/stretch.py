"""Stretches: which words of an instruction belong to the clause of a task, and which cues stand in them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.cue_phrases import GOVERNING, PRO_FORMS
from decomplex_bt.understanding.cues import Cue
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed

PUNCTUATION = frozenset((",", ".", ";", ":", "?", "!", "-", "–", "—", "...", "…", "(", ")"))
_FALLING_BACK = frozenset(("else", "fail"))
_LEADING_ON = frozenset(("then", "just", "please"))
_COORDINATORS = frozenset(("and", "but", "or"))


@dataclass(frozen=True, slots=True)
class Stretch:
    """The words around one task: those up to the task before and the task after, and its own clause among them."""

    previous: int
    """The task before, -1 without one."""
    split: int
    """The last mark between the task before and this one, else the task before."""
    following: int
    """The task after, else the number of tokens."""
    first: int
    last: int
    own_last: int
    """Where the clause ends if what stands behind an "and" is of the next task: "it is hot and the fan is not on"."""
    end: int
    """The next mark behind it outside its message, else the task after."""
    is_open: bool
    """Whether no mark stands between it and the task after."""
    cues: tuple[Cue, ...]
    """All cues of the instruction but those inside arguments that cannot be meant."""

    @classmethod
    def around(cls, observed: Observed, tasks: Sequence[MarkedTask], k: int, said: frozenset[int]) -> Stretch:
        """The words around task `k`; `said`: the tokens of all arguments."""
        document, token = observed.document, tasks[k].token
        previous = tasks[k - 1].token if k else -1
        following = tasks[k + 1].token if k + 1 < len(tasks) else len(document)
        message = {j for kind, indices in tasks[k].arguments if kind == "message" for j in indices}
        between = [document.tokens[j] for j in range(previous + 1, following)]
        marks = [token.i for token in between if token.text in PUNCTUATION and not _is_in_word(document, token.i)]
        split = max((j for j in marks if j < token), default=previous)
        end = min((j for j in marks if j > token and j not in message), default=following)
        is_open = end == following < len(document)
        cues = [cue for cue in observed.cues if cue.first not in (said if cue.name == "either_way" else message)]
        places = {indices.start for kind, indices in tasks[k - 1].arguments if kind == "location"} if k else set()
        # "look on the desk, otherwise in the drawer" is one search, and no order behind it stands in its case
        cues = [cue for cue in cues if cue.name not in _FALLING_BACK or cue.last + 1 not in places]
        opening = [cue.last for cue in cues if split < cue.first <= token and cue.name in GOVERNING]
        joining = [cue.last for cue in cues if split < cue.first < token and cue.name in _COORDINATORS]
        closing = [cue.first for cue in cues if token < cue.first < end and cue.name in GOVERNING | PRO_FORMS]
        first = max(opening or joining, default=split) + 1
        last = min([end, *closing]) - 1
        while is_open and last > token and document.tokens[last].lower in _LEADING_ON:
            last -= 1  # "if it is *then* shut it"
        joints = [j for j in range(token + 1, following) if document.tokens[j].lower in _COORDINATORS]
        own_last = min([last, *joints[-1:]]) if is_open else last
        return cls(
            previous=previous,
            split=split,
            following=following,
            first=min(first, token),
            last=max(last, token),
            own_last=max(own_last, token),
            end=end,
            is_open=is_open,
            cues=tuple(cues),
        )

    def names(self, start: int, stop: int) -> tuple[str, ...]:
        """The names of the cues that begin between two tokens, both excluded."""
        return tuple(cue.name for cue in self.cues if start < cue.first < stop)


def _is_in_word(document: Document, mark: int) -> bool:
    """Whether a mark is the hyphen of a word: "no-one"."""
    around = document.tokens[max(0, mark - 1) : mark + 2]
    if len(around) < 3 or around[1].text != "-":
        return False
    return around[0].end == around[1].start and around[1].end == around[2].start
