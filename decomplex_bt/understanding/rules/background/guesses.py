"""Guesses: where something is thought to be if it is not where it was looked for, which orders nothing and is no case
of what is ordered in the next sentence ("if it's not on the hook, *it must be in the hall*. Bring it to me.")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document

_SUBJECTS = frozenset("it they he she".split())
_THINKING = frozenset("must will 'll might may should could 's 're is are".split())
_BETWEEN = frozenset("be then probably likely surely maybe perhaps still just".split())
_DENYING = frozenset("not n't nt isn't aren't".split())
_ENDS = frozenset((".", "!"))
_LEADING_ON = frozenset("then so otherwise there that else if in either anyway not no".split())
_SAME = frozenset("it them him her".split())
_TAKING_UP = frozenset("there that otherwise instead then".split())


def guesses(document: Document) -> Iterator[range]:
    """The words of a guess that ends a sentence behind the only "if" of a text, a negated one, where the next sentence
    takes the thing up and is no matter of that place: it neither begins with a "then" or the like nor says "there"."""
    tokens, sentences = document.tokens, document.sentences
    if "if" not in document.words or sum(token.lower == "if" for token in tokens) != 1:
        return
    for i, token in enumerate(tokens):
        if token.lower not in _SUBJECTS or i == 0 or i + 3 >= len(tokens):
            continue
        start = sentences.index(sentences[i])
        ahead = [t.lower for t in tokens[start:i]]
        stop = next((j for j in range(i, len(tokens)) if tokens[j].text in MARKS), len(tokens))
        is_case = ahead[:1] == ["if"] and not _DENYING.isdisjoint(ahead) and not {"and", "or"} & {*ahead}
        if not is_case or not _is_thought(document, range(i, stop)):
            continue
        behind = [t.lower for t in tokens[stop + 1 :] if sentences[t.i] == sentences[min(stop + 1, len(tokens) - 1)]]
        is_end = stop + 1 < len(tokens) and tokens[stop].text in _ENDS and sentences[stop + 1] != sentences[i]
        if is_end and not _SAME.isdisjoint(behind) and behind[0] not in _LEADING_ON and _TAKING_UP.isdisjoint(behind):
            yield range(i, stop)


def _is_thought(document: Document, clause: range) -> bool:
    """Whether a clause says no more than where something must or may be: "it must be on the bed", "they're out"."""
    words = document.tokens[clause.start : clause.stop]
    if len(words) < 3 or words[1].lower not in _THINKING:
        return False
    rest = list(words[2:])
    while rest and rest[0].lower in _BETWEEN:
        rest = rest[1:]
    is_place = bool(rest) and (rest[0].tag in ("IN", "RP") or (len(rest) == 1 and rest[0].pos == "ADV"))
    return is_place and not any(t.pos in ("VERB", "AUX", "CCONJ") for t in rest)


def without_guessed(document: Document, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments without those that an order behind a guess has in it, for it is done wherever the thing is."""
    guessed = {i for words in guesses(document) for i in words}
    return [a for a in arguments if a.tokens.start not in guessed or a.owner in guessed]
