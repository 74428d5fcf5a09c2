"""Pointing: a "this" that nobody named points at what the speaker shows, and so does the "it" of a first order; neither
is what only the next order names ("put *this* away and bring me the jar", "close *it* and open the blinds")."""

from __future__ import annotations

from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.gaps import Gap, says_there_is
from decomplex_bt.understanding.references.phrases import Candidate

_SHOWN = frozenset(("this", "these"))
_PRONOUNS = _SHOWN | {"it", "them"}
_HANDLING = frozenset(("bringing", "placing", "taking"))
_FINDING = frozenset(("check_state", "searching"))
_TIMING = frozenset("before after once when while until till if unless without".split())
"""What opens a clause in which a pronoun may be of what the next one names: "before you wash *it*, empty the pot"."""
_NEAR = 4
"""Within so many words ahead of a verb such a word stands."""


def is_named_later(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is first named in a later order than that of the pronoun, or behind a "this"."""
    if gap.word not in _PRONOUNS or len(gap.tokens) != 1 or candidate.tokens.start <= gap.position:
        return False
    document = context.observed.document
    if gap.word in _SHOWN:  # not in "take these, take *these bags* out"
        return document.tokens[candidate.tokens.start].lower != gap.word
    if gap.type != "object" or gap.task.type == "check_state" or candidate.owner <= gap.task.id:
        return False
    verb = document.indices(gap.task.span).start
    ahead = {token.lower for token in document.tokens[max(0, verb - _NEAR) : verb]}
    return context.types[candidate.owner] not in _FINDING and ahead.isdisjoint(_TIMING)


def is_not_shown(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether "this" is handled, and a candidate is somebody, or only what a condition asks of: "if *the kettle* is
    hot, put *this* in the sink"."""
    if gap.word not in _SHOWN or gap.type != "object" or gap.task.type not in _HANDLING or len(gap.tokens) != 1:
        return False
    check = context.by_number.get(candidate.owner)
    is_asked = check is not None and check.type == "check_state"
    is_found = is_asked and check is not None and says_there_is(context.observed.document, check)
    return kind_of(context, candidate) in ANIMATE or (is_asked and not is_found)


def shown(context: Context, gap: Gap) -> Candidate | None:
    """What a "this" that nothing named can fill stands for: itself, which a later "it" may take up; None for any other
    word."""
    if gap.word not in _SHOWN or gap.type != "object" or len(gap.tokens) != 1:
        return None
    text = context.observed.document.tokens[gap.tokens.start].text
    return Candidate(text, gap.tokens, gap.tokens.start, gap.task.id, gap.type, gap.task.type)
