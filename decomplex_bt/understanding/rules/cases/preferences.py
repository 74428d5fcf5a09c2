"""Preferences: what somebody would rather have, asked as a case ("if she'd *prefer* coffee, ...")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.cue_phrases import WISHING
from decomplex_bt.understanding.document import ENDS, Document

_OPENING = frozenset(("if", "when", "unless", "case"))
_WOULD = frozenset("would 'd d".split())
_VERBS = frozenset(("VB", "VBP"))
_MARKS = frozenset((",", ";", ":", "-", "–", "—")) | ENDS
_NOT = frozenset(("not", "n't"))
_HELPING = _WOULD | _NOT | frozenset("does do did still really actually ever".split())
_SPEAKERS = frozenset(("i", "we"))
_NAMING = frozenset("DET ADJ NOUN PROPN PRON ADP NUM".split())
_LONGEST = 6
"""The most words between what opens a case and the verb of a wish."""


@dataclass(frozen=True, slots=True)
class Preference:
    """A wish in a case: the token that is its check, who wishes, what, and the words that are no tasks of their own."""

    check: int
    subject: range
    wished: range
    words: range

    def told(self, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
        """The arguments with who wishes as the object of the check, and what as its state, where no state of a thing is
        wished for ("if he'd prefer the window open")."""
        own = {a.type for a in arguments if a.owner == self.check and a.tokens.start in self.wished}
        if own >= {"object", "state"}:
            return list(arguments)
        said = {"object": self.subject, "state": self.wished}
        kept = [a for a in arguments if a.owner != self.check and not set(a.tokens) & {*self.subject, *self.words}]
        return [*kept, *(FoundArgument(name, self.check, words, CERTAIN) for name, words in said.items() if words)]


def preferences(document: Document, tasks: Mapping[int, str]) -> Iterator[Preference]:
    """Every wish of "prefer" or "rather" in a case, up to a mark or the next order among the `tasks`, which are tokens
    with types; "if he'd rather not" and the like, where what is wished is not said, have a `wished` of length 0. No
    wish of the listener, nor what somebody says that they wish."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        is_rather = token.lower == "rather" and i > 0 and tokens[i - 1].lower in _WOULD
        if not is_rather and (token.lemma != "prefer" or token.tag in ("VBN", "VBG")):
            continue
        first = i - 1 if tokens[i - 1].lower in _WOULD else i
        subject = _subject(document, first)
        if not subject:
            continue
        is_verb = is_rather and i + 1 < len(tokens) and tokens[i + 1].tag in _VERBS
        start = i + 1 + is_verb
        stop = next(
            (j for j in range(start, len(tokens)) if tokens[j].lower in _MARKS or _is_over(tasks, start, j)), start
        )
        check = i + 1 if is_verb else (first if is_rather else i)
        if stop > start and tokens[start].lower in _NOT:
            start = stop
        yield Preference(check, subject, range(start, stop), range(first, stop))


def is_wished(document: Document, verb: int) -> bool:
    """Whether a case asks with a verb what somebody else than the one who speaks wants: "if she doesn't *want* any"."""
    tokens, first = document.tokens, verb
    while first and tokens[first - 1].lower in _HELPING:
        first -= 1
    who = _subject(document, first) if tokens[verb].lemma in WISHING else range(0)
    return bool(who) and tokens[who.start].lower not in _SPEAKERS


def _is_over(tasks: Mapping[int, str], start: int, i: int) -> bool:
    """Whether a wish that is told from `start` on ends before token `i`, an order."""
    return i > start and tasks.get(i, "check_state") != "check_state"


def _subject(document: Document, verb: int) -> range:
    """Who wishes what a verb says, between that and what opens its case; empty where it is no case, or the listener."""
    tokens = document.tokens
    for j in range(verb - 1, max(-1, verb - 1 - _LONGEST), -1):
        if tokens[j].lower in _MARKS or tokens[j].tag.startswith("V") or tokens[j].lower == "you":
            return range(0)
        if tokens[j].lower in _OPENING:
            return range(0) if _is_asked(document, j) else range(j + 1, verb)
    return range(0)


def _is_asked(document: Document, opening: int) -> bool:
    """Whether an "if" opens what somebody is to be asked: "ask Ann *if* she'd prefer tea"."""
    tokens, first = document.tokens, opening - 1
    while first > max(0, opening - _LONGEST) and tokens[first].pos in _NAMING:
        first -= 1
    return first >= 0 and tokens[first].lemma == "ask" and tokens[first].tag in ("VB", "VBP") and first < opening
