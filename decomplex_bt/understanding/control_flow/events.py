"""Events: which checks tell of what comes about and is waited for."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, GOVERNING
from decomplex_bt.understanding.cues import Cue
from decomplex_bt.understanding.document import MARKS, Document

_EVENTS = frozenset(("when", "once", "as soon as", "soon as", "so soon as", "the moment", "the minute", "the instant"))
_OPENING = GOVERNING | {"after", "until", "before", "while"}
_LISTENER = frozenset(("you", "u", "ya", "ye"))


def is_event(document: Document, cues: Sequence[Cue], task: MarkedTask) -> bool:
    """Whether a check tells of what comes about of itself or by others and is waited for: "once *it's dry*", "as soon
    as *Ann is here*"; not what the listener is to have done ("once you're back"), nor until or after when."""
    tokens = document.tokens
    if task.type != "check_state" or (tokens[task.token].tag == "VB" and tokens[task.token].lemma in ASKING_LEMMAS):
        return False
    ahead = [cue for cue in cues if cue.name in _OPENING and cue.last < task.token]
    opening = max(ahead, key=lambda cue: cue.last, default=None)
    if opening is None:
        return False
    words = " ".join(token.lower for token in tokens[opening.first : opening.last + 1])
    between = tokens[opening.last + 1 : task.token]
    is_whole = all(token.text not in MARKS and token.lower not in _LISTENER for token in between)
    return words in _EVENTS and is_whole and (not between or between[0].tag != "CC")
