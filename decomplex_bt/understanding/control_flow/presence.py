"""Presence: which checks ask whether somebody is in or something is there."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import AROUND, MarkedTask, Presence
from decomplex_bt.understanding.control_flow.wording import BEING
from decomplex_bt.understanding.document import Document, Token

_BE = BEING | {"be", "is", "are", "was", "were", "isnt", "arent", "its", "theres"}
_AWAY = frozenset("out away gone missing absent".split())
_THERE = AROUND | frozenset("available present left inside upstairs downstairs nearby".split())
_BESIDES = frozenset("yet already still all at it now even any over".split())
"""What may stand beside these and tells nothing else: "already gone", "at home", "in it"."""
_LEAVING = frozenset("leave go vanish disappear".split())
_OUT_OF = frozenset("order bed reach date time action tune shape".split())
"""What somebody or something that is "out of" it may be at hand all the same."""
SOME = frozenset("any one some none enough".split())
"""What stands for things that are not named again: "if there are *none*"."""
_NO_ABSENCE = frozenset("answer reply response luck sign joy success use help room space".split())
"""What there may be none of without anything being missing."""


def presence_asked(document: Document, task: MarkedTask, *, is_negated: bool) -> Presence:
    """What a check asks that asks no more than if somebody or something is at hand ("if she isn't in", "if there are
    none left") or is not ("should it be gone"); somewhere else is away ("if she's in the garden"). Without a verb only
    what denies it ("not there?", "no pens?")."""
    if task.type != "check_state":
        return ""
    token = document.tokens[task.token]
    said = {kind: [document.tokens[j] for j in indices] for kind, indices in task.arguments if len(indices)}
    if any(word.lemma in _NO_ABSENCE for word in said.get("object", ())):
        return ""
    is_existing = token.lower == "theres" or (task.token > 0 and document.tokens[task.token - 1].lower == "there")
    if token.lower in _BE or token.lemma in _BE:
        if "state" in said:
            return _told(said["state"])
        if is_existing:
            return "there"
        if "location" in said:
            is_of_way = any(word.lower in _AWAY for word in said["location"])  # "out of bed"
            elsewhere: Presence = "" if is_of_way else "there" if is_negated else "away"
            return _told(said["location"]) or elsewhere
        return "there" if is_negated and set(said) <= {"object"} else ""  # "they should be there; if they *aren't*"
    if "state" in said:
        return _told(said["state"]) if token.lemma in _LEAVING else ""  # "if he's gone *out*"
    if token.lemma == "have":  # "if we don't have *any*"
        return "there" if is_negated and any(word.lower in SOME for word in said.get("object", ())[:1]) else ""
    if token.lower == "left" and (is_negated or is_existing):
        return "there"  # "none left", not "if he has left"
    if token.lower in _AWAY or (token.lemma in _LEAVING and token.tag in ("VBN", "VBD")):
        return "away"
    return "there" if is_negated and (token.tag in ("NN", "NNS", "NNP") or token.lower in _THERE) else ""


def _told(words: Sequence[Token]) -> Presence:
    """What a state or a place of one of these words tells, with nothing else in it: "gone out", "at home"."""
    first, *behind = [word.lower for word in words]
    if first == "out" and behind[:1] == ["of"] and behind[-1] not in _OUT_OF:
        return "away"  # "if we're out of pens"
    lower = {first, *behind} - _BESIDES
    if not lower & (_AWAY | _THERE) or not lower <= _AWAY | _THERE:
        return ""
    return "away" if lower & _AWAY else "there"
