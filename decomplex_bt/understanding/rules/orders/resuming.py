"""Resuming: what somebody goes on with is the order, and no thing ("carry on *ironing*", "go on with the
*dusting*")."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed

_GOING = frozenset("carry go keep press get crack".split())
_BETWEEN = frozenset("with the my your doing".split())


def resumed(observed: Observed, verb: int) -> tuple[int, str] | None:
    """What is gone on with at a verb, and its type; None where no doing is named: "carry on upstairs"."""
    tokens = observed.document.tokens
    if tokens[verb].lemma not in _GOING or [token.lower for token in tokens[verb + 1 : verb + 2]] != ["on"]:
        return None
    doing = next((token for token in tokens[verb + 2 :] if token.lower not in _BETWEEN), None)
    if doing is None or not doing.lower.endswith("ing"):
        return None
    verbs = observed.gazetteer.verbs
    sense = next((verbs[lemma] for lemma in lemmas(doing.lower) if lemma in verbs), None)
    return None if sense is None else (doing.i, sense[0])


def without_lead(document: Document, arguments: Sequence[FoundArgument], doing: int) -> list[FoundArgument]:
    """The arguments without what only leads to a doing that is gone on with ("carry on *with the* ironing"), and
    without what stands in a later clause than that."""
    tokens = document.tokens
    is_led = doing > 1 and tokens[doing - 1].lower in _BETWEEN and tokens[doing].lower.endswith("ing")
    if not is_led:
        return list(arguments)
    end = next((i for i in range(doing, len(tokens)) if tokens[i].text in MARKS), len(tokens))
    return [
        a
        for a in arguments
        if a.owner != doing or (a.tokens.start < end and any(tokens[i].lower not in _BETWEEN for i in a.tokens))
    ]
