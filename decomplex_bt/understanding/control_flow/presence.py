"""Presence: which clauses ask whether somebody is in or something is there, and what waits for an event."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import MarkedTask
from decomplex_bt.understanding.control_flow.wording import BEING
from decomplex_bt.understanding.cues import ASKING_LEMMAS, Cue
from decomplex_bt.understanding.document import ENDS, Document

_BE = BEING | {"be", "is", "are", "was", "were", "isnt", "arent", "its", "theres"}
_LEAVING = frozenset("leave go vanish disappear".split())
_AROUND = frozenset(
    "in out there here home away around about available gone missing left absent present inside upstairs downstairs "
    "back nearby".split()
)
"""What says that somebody or something is at hand, or is not."""
_ANY = frozenset("any one some none enough".split())
_MISSING = frozenset("missing gone absent".split())
_NO_THINGS = frozenset("answer reply response luck sign joy success use help room space".split())
"""What there may be none of without anything being missing."""
_EVENTS = frozenset(("when", "once", "as soon as", "soon as", "so soon as", "the moment", "the minute", "the instant"))
_OWN = frozenset(("you", "u", "ya", "ye"))


def asks_presence(document: Document, task: MarkedTask, *, is_negated: bool) -> bool:
    """Whether a check asks no more than if somebody or something is there, at home or left: "if she isn't in", "if
    there are none left", "should it be gone"; without a verb only what denies it ("not there?", "no pens?")."""
    if task.type != "check_state":
        return False
    token = document.tokens[task.token]
    said = {kind: [document.tokens[j] for j in indices] for kind, indices in task.arguments if len(indices)}
    if any(word.lemma in _NO_THINGS for word in said.get("object", ())):
        return False
    state = [word.lower for word in said.get("state", ())]
    if state and _AROUND.isdisjoint(state):
        return False
    if token.lower in _BE or token.lemma in _BE:
        is_existing = token.lower == "theres" or (task.token > 0 and document.tokens[task.token - 1].lower == "there")
        is_bare = is_negated and set(said) <= {"object"}  # "they should be in the hall; if they *aren't*, ..."
        return bool(state) or "location" in said or is_existing or is_bare
    if token.lemma == "have":  # "if we don't have *any*"
        return is_negated and any(word.lower in _ANY for word in said.get("object", ())[:1])
    if token.lemma in _LEAVING and token.tag in ("VBN", "VBD"):
        return True  # "if he has left", "none left"
    if token.lower in _MISSING:
        return True
    is_named = token.tag.startswith("NN") or token.lower in _AROUND
    return is_negated and is_named and not state


def is_event(document: Document, cues: Sequence[Cue], task: MarkedTask) -> bool:
    """Whether a check tells of what comes about of itself or by others and is waited for: "once *it's dry*", "as soon
    as *Ann is here*"; not what the listener is to have done ("once you're back"), nor until or after when."""
    tokens = document.tokens
    if task.type != "check_state" or (tokens[task.token].tag == "VB" and tokens[task.token].lemma in ASKING_LEMMAS):
        return False
    for cue in cues:
        between = tokens[cue.last + 1 : task.token]
        if not between or " ".join(t.lower for t in tokens[cue.first : cue.last + 1]) not in _EVENTS:
            continue
        is_own = any(token.lower in _OWN or token.text in ENDS for token in between)
        return not is_own and between[0].tag != "CC" and any(token.tag[0] in "NPDEC" for token in between)
    return False
