"""Dismissals: what somebody says to forget or to skip is not what they go on about ("if it's icy, forget *the hook* and
bring *it* in"), and what they say not to forget is."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate

_DISMISSING = tuple(
    tuple(phrase.split())
    for phrase in (
        "forget", "forget about", "skip", "never mind", "nevermind", "ignore", "do n't bother with",
        "not bother with",
    )
)  # fmt: skip
_LONGEST = max(map(len, _DISMISSING))
_NEGATIONS = frozenset("not n't never".split())
_TURNING = frozenset("but if unless otherwise else or when though".split())
"""What takes up what was dismissed, or asks of it."""
_JOINING = frozenset(", and then please - ;".split())
_PRONOUNS = frozenset(("it", "that", "them"))


def is_dismissed(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether an order is about something else than a candidate, which the words right ahead of it say to leave out,
    where another thing was named."""
    if gap.word not in _PRONOUNS or len(gap.tokens) != 1 or gap.task.type == "check_state":
        return False
    document = context.observed.document
    left_out = _dismissed(document, gap.position)
    if not left_out or not _is_same(document, candidate, left_out):
        return False
    return any(
        c.type == "object"
        and c.owner
        and c.tokens.stop <= gap.position
        and not _is_same(document, c, left_out)
        and kind_of(context, c) not in ANIMATE
        for c in context.pool
    )


def reminded(context: Context, gap: Gap) -> range:
    """What somebody says not to forget, right behind which it is said what to do with it: "don't forget *the umbrella*,
    and put *it* in the car"; empty elsewhere."""
    document = context.observed.document
    if gap.word not in _PRONOUNS or gap.type != "object" or len(gap.tokens) != 1:
        return range(0)
    verb = document.indices(gap.task.span).start
    named = [chunk for chunk in noun_chunks(document) if chunk.stop <= verb]
    last = named[-1] if named else range(0)
    before = [token.lower for token in document.tokens[max(0, last.start - 3) : last.start]] if last else []
    is_said = before[-1:] == ["forget"] and not _NEGATIONS.isdisjoint(before)
    is_plural = bool(last) and document.tokens[last[-1]].tag in ("NNS", "NNPS")
    is_near = all(token.lower in _JOINING for token in document.tokens[last.stop : verb])
    return last if is_said and is_near and is_plural == (gap.word == "them") else range(0)


def _is_same(document: Document, candidate: Candidate, phrase: range) -> bool:
    return document.tokens[candidate.head].lemma == document.tokens[phrase[-1]].lemma


def _dismissed(document: Document, stop: int) -> range:
    """The words of what the sentence of a token says to leave out, with no case between; empty where there is none."""
    tokens, of = document.tokens, document.sentences
    for phrase in noun_chunks(document):
        if phrase.stop > stop or of[phrase.start] != of[stop]:
            continue
        before = [token.lower for token in tokens[max(0, phrase.start - _LONGEST) : phrase.start]]
        said = [words for words in _DISMISSING if tuple(before[-len(words) :]) == words]
        if not said:
            continue
        first = phrase.start - max(map(len, said))
        is_denied = any(token.lower in _NEGATIONS for token in tokens[max(0, first - 2) : first])
        between = {token.lower for token in tokens[phrase.stop : stop]}
        if not is_denied and between.isdisjoint(_TURNING):
            return phrase
    return range(0)
