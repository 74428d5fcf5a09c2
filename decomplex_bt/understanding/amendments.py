"""Amendments: what is certain of an instruction's arguments, whatever a model finds: those that are taken back,
corrected or said aside, and what an idiom tells of its check."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import FoundArgument, FoundArguments
from decomplex_bt.understanding.asides import asides, reasons, whereabouts
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.idioms import for_somebody, predicated
from decomplex_bt.understanding.prohibitions import prohibitions
from decomplex_bt.understanding.withdrawals import Withdrawals

CERTAIN = 0.9
"""The confidence of an argument that an idiom tells."""
_BE = frozenset(("is", "'s", "\u2019s", "was"))
_NOMINAL = frozenset(("DET", "NOUN", "PROPN", "PRON"))
_UNNAMED = frozenset("somebody someone something visitor visitors caller stranger".split())
_PLACES = frozenset(("source", "location"))
_OF_CHECKS = frozenset(("object", "state", "location"))


def amended(
    observed: Observed, tasks: Mapping[int, str], withdrawals: Withdrawals, found: FoundArguments
) -> FoundArguments:
    """The arguments without those that are taken back, forbidden or said aside, and with what corrections and idioms
    say; where a thing is may be told by a reason ("since it's still in the sink, fish it out")."""
    document = observed.document
    idle = withdrawals.tokens | asides(document, tasks) | prohibitions(observed, tasks)
    why = reasons(document, tasks)
    kept = [a for a in found.arguments if a.tokens.start not in idle]
    kept = [a for a in kept if a.tokens.start not in why or a.type in _PLACES]
    kept = [_meant(document, tasks, a) for a in kept]
    for phrase in withdrawals.corrections:
        kept = _corrected(observed, kept, phrase)
    for token, kind in tasks.items():
        if kind == "bringing":
            kept = _given(kept, token, for_somebody(document, token))
        if kind == "check_state":
            kept = _told(kept, token, predicated(document, token))
            kept = _identified(observed, kept, token)
    return FoundArguments(tuple(sorted(kept, key=lambda argument: argument.tokens.start)), found.probability)


def _corrected(observed: Observed, arguments: Sequence[FoundArgument], phrase: range) -> list[FoundArgument]:
    """The arguments with a phrase in place of the last one before it that it may stand for."""
    tokens = observed.document.tokens
    others = [a for a in arguments if not set(a.tokens) & set(phrase)]
    before = [a for a in others if a.tokens.stop <= phrase.start and a.type not in ("state", "manner")]
    known = next((a for a in arguments if a.type == "object" and set(a.tokens) & set(phrase)), None)
    if known is not None and not any((a.owner, a.type) == (known.owner, known.type) for a in before):
        return list(arguments)  # found as it is, and what it corrects was not
    sentences = observed.document.sentences
    before.sort(key=lambda a: a.tokens.stop)
    is_new = bool(before) and sentences[phrase.start] != sentences[before[-1].tokens.start]
    is_led = tokens[phrase.start].pos == "ADP"
    if is_led or is_new or tokens[phrase.stop - 1].lower in ("one", "ones"):
        before = [a for a in before if (tokens[a.tokens.start].pos == "ADP") == is_led] or before
    if not before:
        return list(arguments)
    wrong = before[-1]
    return [*(a for a in others if a is not wrong), replace(wrong, tokens=phrase)]


def _meant(document: Document, tasks: Mapping[int, str], argument: FoundArgument) -> FoundArgument:
    """The argument; where somebody is to whom something is brought is no source but the goal ("he's in the garden")."""
    if argument.type != "source" or tasks.get(argument.owner) != "bringing":
        return argument
    first = argument.tokens.start
    starts = range(max(0, first - 4), first)
    is_of_somebody = any(first in (whereabouts(document, at) or ()) for at in starts)
    return replace(argument, type="goal") if is_of_somebody else argument


def _given(arguments: Sequence[FoundArgument], bringing: int, whom: range) -> list[FoundArgument]:
    """The arguments with the recipient that a "for Ella" tells, where nobody else gets it."""
    is_taken = any(
        set(a.tokens) & set(whom) or (a.owner == bringing and a.type in ("recipient", "goal")) for a in arguments
    )
    return [*arguments, FoundArgument("recipient", bringing, whom, CERTAIN)] if whom and not is_taken else [*arguments]


def _identified(observed: Observed, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with who or what it is as the state of "it", where somebody was spoken of before: "Somebody is at
    the door. If it's the plumber, ..."."""
    tokens = observed.document.tokens
    is_identity = check > 0 and tokens[check].lower in _BE and tokens[check - 1].lower == "it"
    if not is_identity or not any(token.lower in _UNNAMED for token in tokens[: check - 1]):
        return list(arguments)
    own = [a for a in arguments if a.owner == check and a.type in ("object", "state")]
    if len(own) != 1 or own[0].tokens.start != check + 1 or tokens[check + 1].pos not in _NOMINAL:
        return list(arguments)
    it = FoundArgument("object", check, range(check - 1, check), CERTAIN)
    others = [a for a in arguments if a is not own[0] and check - 1 not in a.tokens]
    return [*others, it, replace(own[0], type="state")]


def _told(arguments: Sequence[FoundArgument], check: int, told: Mapping[str, range]) -> list[FoundArgument]:
    """The arguments with what an idiom tells of a check: in place of what lies within its words, but for what is of
    the right type already."""
    kept = list(arguments)
    for name, tokens in told.items():
        own = {a.type: a for a in kept if a.owner == check and a.type in _OF_CHECKS}
        if name == "location" and "state" in own:
            continue
        if name in own and not set(own[name].tokens) < set(tokens):
            continue
        kept = [a for a in kept if not set(a.tokens) <= set(tokens)]
        if not any(set(a.tokens) & set(tokens) for a in kept):
            kept.append(FoundArgument(name, check, tokens, CERTAIN))
    return kept
