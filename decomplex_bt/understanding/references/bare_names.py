"""Bare names: who is fetched or found by a name without a capital, which the tagger takes for a thing: "go and get
*jess* from the garden and tell *her* ..."."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.agreement import is_of_other_gender
from decomplex_bt.understanding.references.context import ANIMATE, GROUPS, Context, kind_of
from decomplex_bt.understanding.references.first_names import MEN, WOMEN
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import PLACE_ADVERBS, POINTING, PRONOUNS, QUANTIFIERS

_GETTING = frozenset("get fetch find call ask tell wake help follow collect grab join meet see".split())
"""What is done to somebody by name."""
_NOUNS = frozenset(("NN", "NNP", "FW"))
_NO_NAMES = POINTING | PRONOUNS | QUANTIFIERS | PLACE_ADVERBS | {"home"}


def is_bare_name(observed: Observed, token: Token) -> bool:
    """Whether a word without a capital is a first name, or none that the dictionary or the domain knows."""
    if not token.text.islower() or token.lower in MEN | WOMEN or token.tag not in _NOUNS:
        return token.text.islower() and token.lower in MEN | WOMEN
    is_known = token.is_noun or bool(observed.gazetteer.category(token.lemma)) or token.lower in _NO_NAMES
    return token.lower.isalpha() and not is_known


def called_by_name(context: Context, gap: Gap) -> range:
    """The name of whom an order right before gets, finds or speaks to, where "him" or "her" can be nobody named behind
    it; empty where it names nobody so."""
    if GROUPS.get(gap.word) not in ("he", "she") or len(gap.tokens) != 1:
        return range(0)
    document = context.observed.document
    before = [c for c in context.pool if c.tokens.stop <= gap.position and not is_of_other_gender(document, gap, c)]
    people = [c for c in before if kind_of(context, c) in ANIMATE or _is_called(context, c)]
    last = max(people, key=lambda c: c.tokens.start, default=None)
    is_near = last is not None and gap.task.id - 1 <= last.owner <= gap.task.id
    return last.tokens if last is not None and is_near and _is_called(context, last) else range(0)


def _is_called(context: Context, candidate: Candidate) -> bool:
    """Whether a candidate is a name alone right behind a verb that is of people."""
    tokens, at = context.observed.document.tokens, candidate.tokens.start
    if candidate.mention or len(candidate.tokens) != 1 or at == 0 or not candidate.owner:
        return False
    is_got = tokens[at - 1].lemma in _GETTING and at - 1 in context.verbs
    return is_got and is_bare_name(context.observed, tokens[at]) and not _is_followed(context.observed.document, at)


def _is_followed(document: Document, at: int) -> bool:
    """Whether a word only tells of what sort the noun behind it is."""
    behind = document.tokens[at + 1 : at + 2]
    return any(token.pos in ("NOUN", "PROPN", "ADJ") or token.tag == "POS" for token in behind)
