"""Suppositions: what may or should be so is asked where the next words take it up ("the attic might be locked. *In that
case* ...", "my keys should be on the hook. *If not*, ...")."""

from __future__ import annotations

from collections.abc import Mapping

from decomplex_bt.understanding.cue_phrases import normal_form
from decomplex_bt.understanding.document import Document

MAY = frozenset(("may", "might", "could"))
_SHOULD = MAY | {"should", "ought", "must", "will"}
_HEDGES = frozenset("probably perhaps maybe likely supposedly presumably hopefully think believe guess reckon".split())
_BEING = frozenset("is are was 's".split())
_DENIED = (("if", "not"), ("otherwise",), ("failing", "that"))
"""What turns to the case that a statement right before does not hold."""
_TAKEN_UP = tuple(
    tuple(phrase.split())
    for phrase in (
        "in that case", "in which case", "in that event", "in which event", "if so", "if yes", "if that is the case",
        "if that is so", "if it is so", "should that be the case", "should that be so",
    )
)  # fmt: skip
"""What takes a statement up as a condition, in the normal form of cues."""
_ASKING = frozenset(("check_state", "searching"))
_FINDING = _ASKING | {"bringing", "taking"}
_SPEAKERS = frozenset(("i", "we"))
_PRONOUNS = frozenset("it they he she that this these those".split())
_OPENING = frozenset("if unless when whether once until".split())


def supposed(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of suppositions that are taken up, none of which is one of the `tasks`."""
    return _stated(document, tasks) | _denied(document, tasks)


def _stated(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of what may be so and is taken up in its own sentence or the next; not where another check that stands
    in between is what is taken up, or the statement only comments on a check before it ("it may be warm")."""
    tokens, sentences = document.tokens, document.sentences
    if MAY.isdisjoint(token.lower for token in tokens):
        return frozenset()
    words = [normal_form(token.lower) for token in tokens]
    starts = {
        sentences[i]: i
        for i in range(len(tokens))
        if any(tuple(words[i : i + len(phrase)]) == phrase for phrase in _TAKEN_UP)
    }
    found = set()
    for i, word in enumerate(words):
        if word not in MAY or tokens[i].tag != "MD" or i == 0 or words[i - 1] == "you":
            continue
        taken_up = next((starts[n] for n in (sentences[i], sentences[i] + 1) if starts.get(n, -1) > i), None)
        verb = next((j for j in range(i + 1, min(i + 5, len(tokens))) if tokens[j].tag == "VB"), None)
        if taken_up is None or verb is None or words[verb + 1 : verb + 2] == ["that"]:  # "it may be that it is locked"
            continue
        if words[i - 1] in _SPEAKERS and words[verb] != "be":
            continue
        if words[verb] == "have":
            verb = participle(document, verb)
        checks = [j for j, kind in tasks.items() if kind in _ASKING]
        is_comment = words[i - 1] in _PRONOUNS and any(j < i and sentences[i] - sentences[j] <= 1 for j in checks)
        if not is_comment and not any(verb + 1 < j < taken_up for j in checks):
            found.add(verb)
    return frozenset(found)


def _denied(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of what should be so, or is by a speaker's guess, right before an "if not" or the like."""
    words = [normal_form(token.lower) for token in document.tokens]
    found = set()
    for i in range(1, len(words)):
        length = next((len(phrase) for phrase in _DENIED if tuple(words[i : i + len(phrase)]) == phrase), 0)
        behind = [j for j in tasks if j >= i + length and document.sentences[j] == document.sentences[i]]
        verb = _guess(document, tasks, i) if length and behind else None
        if verb is not None:
            found.add(verb)
    return frozenset(found)


def _guess(document: Document, tasks: Mapping[int, str], stop: int) -> int | None:
    """The verb of the supposition whose sentence, or the first part of it, ends at `stop`; None where a task or a
    condition stands there."""
    tokens = document.tokens
    sentence = next((document.sentences[j] for j in range(stop - 1, -1, -1) if tokens[j].pos != "PUNCT"), -1)
    said = [j for j in range(stop) if document.sentences[j] == sentence]
    last = max((j for j in said if j in tasks), default=-1)
    clause = [j for j in said if j > last]
    words = {j: tokens[j].lower for j in clause}
    is_found_out = any(tasks[j] in _FINDING for j in tasks if j < stop and document.sentences[j] >= sentence - 1)
    if is_found_out and not _PRONOUNS.isdisjoint(words.values()):
        return None  # "find the pump. It ought to be in the cellar; failing that, ..."
    if not _OPENING.isdisjoint(words.values()) or "you" in words.values() or "?" in words.values():
        return None
    for j in clause[1:]:
        if words[j] in _SHOULD and tokens[j].tag == "MD":
            verb = next((n for n in clause if j < n <= j + 3 and tokens[n].tag == "VB"), None)
            if verb is not None and last < 0:
                return participle(document, verb) if tokens[verb].lower == "have" else verb
    is_guess = not _HEDGES.isdisjoint(words.values()) and last < 0
    return next((j for j in clause[1:] if words[j] in _BEING), None) if is_guess else None


def participle(document: Document, have: int) -> int:
    """The participle that tells of a perfect: the last one of "have been switched off"."""
    tokens = document.tokens
    found = have
    for j in range(have + 1, min(have + 5, len(tokens))):
        if tokens[j].tag in ("VBN", "VBD"):
            found = j
        elif tokens[j].tag not in ("RB", "RP"):
            break
    return found
