"""Completion: the arguments of one task as they are taken from a reading: without those that are taken back or only
asked about, and whole."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import replace
from itertools import pairwise

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.phrases import is_pronoun

_OF_REPORTS = frozenset(("message", "recipient", "manner"))
_NEEDING_A_NOUN = frozenset("the a an my your our their its".split())
_NOUN_PARTS = frozenset(("ADJ", "NUM", "NOUN", "PROPN"))
_NEEDING_A_PHRASE = frozenset(("for", "to", "with", "from", "into", "of"))
_PHRASE_PARTS = _NOUN_PARTS | {"DET", "PRON"}
_CORRECTING = frozenset("no sorry wait mean meant rather scratch actually".split())
_AROUND_CORRECTIONS = _CORRECTING | frozenset("i or that make hang hold on oh er um uh erm well not".split())
_RECEIVING = frozenset(("recipient", "goal"))
_ADDING = frozenset(("too", "also", "well"))


def answered(document: Document, verb: int, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a verb without those that only a question before it has: of "No milk in the fridge? Bring me
    water", the milk and the fridge; of "Any milk in the fridge? Bring me some", the milk alone."""
    of = document.sentences
    asking = {of[token.i] for token in document.tokens if "?" in token.text and of[token.i] < of[verb]}
    own = {argument.type: argument.tokens for argument in arguments if of[argument.tokens.start] == of[verb]}
    refused = {of[a.tokens.start] for a in arguments if a.type in own and not is_pronoun(document, own[a.type])}
    dropped = asking & refused
    return [a for a in arguments if of[a.tokens.start] not in (asking if a.type in own else dropped)]


def retracted(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a task without those that are taken back ("the knife, no, wait, the fork") or denied ("not to me
    but to Tom")."""
    in_order = sorted(arguments, key=lambda argument: argument.tokens.start)
    taken_back = {
        id(argument)
        for argument, after in pairwise(in_order)
        if argument.type == after.type
        and _is_taken_back(document.tokens[argument.tokens.stop : after.tokens.start])
        and not {token.lower for token in document.tokens[after.tokens.stop : after.tokens.stop + 2]} & _ADDING
    }
    taken_back |= {
        id(argument)
        for argument, after in pairwise(in_order)
        if (argument.type == after.type or {argument.type, after.type} <= _RECEIVING)
        and _is_denied(document, range(argument.tokens.start, after.tokens.start))
    }
    return [argument for argument in arguments if id(argument) not in taken_back]


def _is_denied(document: Document, words: range) -> bool:
    """Whether words behind a "not" have others behind a "but" in their place: "not *to Anna but* to Tom"."""
    before = document.tokens[words.start - 1].lower if words.start else ""
    return before == "not" and document.tokens[words.stop - 1].lower == "but"


def _is_taken_back(between: Sequence[Token]) -> bool:
    words = [token.lower for token in between if token.text[0].isalnum()]
    return not _CORRECTING.isdisjoint(words) and _AROUND_CORRECTIONS.issuperset(words)


def reported(arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a verb of informing: what stands right behind its message is part of it."""
    found: list[FoundArgument] = []
    for argument in sorted(arguments, key=lambda a: a.tokens.start):
        before = found[-1] if found else None
        if argument.type not in _OF_REPORTS and before and before.type == "message" and _adjoin(before, argument):
            found[-1] = replace(before, tokens=range(before.tokens.start, argument.tokens.stop))
        else:
            found.append(argument)
    return found


def _adjoin(one: FoundArgument, other: FoundArgument) -> bool:
    return one.tokens.stop == other.tokens.start


def completed(document: Document, tokens: range, taken: Container[int]) -> range:
    """The tokens of an argument; where they end in an article, a preposition or the like, with the words up to its
    noun as well, as far as those are not `taken`. The "rid of" of "get rid of it" belongs to the verb."""
    start, stop = tokens.start, tokens.stop
    if len(tokens) > 1 and document.tokens[start].lower == "rid":
        start += 1
    if len(tokens) > 1 and document.tokens[start].lower == "of" and start and document.tokens[start - 1].lower == "rid":
        start += 1
    while stop - start > 1 and document.tokens[stop - 1].lower in ("and", "or", "but"):
        stop -= 1
    relative = stop - 1 if document.tokens[stop - 1].pos != "AUX" else stop - 2  # "any lamp *that* is on"
    if start < relative and document.tokens[relative].tag in ("WDT", "WP"):
        stop = relative
    last = document.tokens[stop - 1].lower
    if document.tokens[start].lower == "with" and stop - start > 1:
        stop = _with_noun(document, stop, taken)
    is_owner = document.tokens[stop - 1].tag == "PRP$" and stop - start > 1  # "to her", not "nick his"
    behind = document.tokens[stop : stop + 1]
    is_told_by = "-" in last and any(token.pos in ("NOUN", "PROPN") for token in behind)  # "a *sell-by* date"
    needs_noun = last in _NEEDING_A_NOUN or is_owner or is_told_by
    parts = _NOUN_PARTS if needs_noun else _PHRASE_PARTS if last in _NEEDING_A_PHRASE else frozenset()
    while stop < len(document) and stop not in taken and document.tokens[stop].pos in parts:
        stop += 1
    return range(start, stop)


def _with_noun(document: Document, stop: int, taken: Container[int]) -> int:
    """Where what something is done with ends whose words break off ahead of its noun: "with the old *brush*"."""
    whole = next((chunk.stop for chunk in noun_chunks(document) if chunk.start < stop < chunk.stop), stop)
    is_broken_off = document.tokens[stop - 1].pos in ("DET", "ADJ", "NUM", "VERB")
    return whole if is_broken_off and all(i not in taken for i in range(stop, whole)) else stop
