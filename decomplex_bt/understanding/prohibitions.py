"""Prohibitions: the verbs that an instruction forbids ("don't open the window"), which are no tasks whatever a model
says of them."""

from __future__ import annotations

from decomplex_bt.understanding.features import Observed

_NEGATIONS = frozenset(("n't", "n’t", "nt", "not", "never"))
_AUXILIARIES = frozenset("do must should shall need dare".split())
_BETWEEN = frozenset("please ever even just".split())
_CONDITIONAL = frozenset(
    (
        "if only_if unless when until before before_that before_all after so else fail instead depending even_if "
        "either_way"
    ).split()
)
"""With one of these in its sentence a prohibition may be a condition's or an order's ("don't go until …"): that is for
the flow to say."""


def forbidden(observed: Observed) -> tuple[int, ...]:
    """The tokens of the verbs that are forbidden whatever happens, in text order.

    A rule of grammar: "do not", "must not", "never" and the like ahead of a bare verb, with no subject but "you", in a
    sentence without a condition, an order or a question.
    """
    document = observed.document
    tokens = document.tokens
    negations = [i for i, token in enumerate(tokens) if token.lower in _NEGATIONS]
    if not negations:
        return ()
    conditional = {document.sentences[cue.first] for cue in observed.cues if cue.name in _CONDITIONAL}
    found = []
    for i in negations:
        if document.sentences[i] in conditional or observed.question[i]:
            continue
        if tokens[i].lower != "never" and (i == 0 or tokens[i - 1].lower not in _AUXILIARIES):
            continue
        verb = i + 1
        while verb < len(tokens) and (tokens[verb].tag == "RB" or tokens[verb].lower in _BETWEEN):
            verb += 1
        if verb < len(tokens) and tokens[verb].tag in ("VB", "VBP") and not _has_subject(observed, verb):
            found.append(verb)
    return tuple(found)


def _has_subject(observed: Observed, verb: int) -> bool:
    """Whether somebody but the one spoken to is said not to do it: "they don't open on Sundays"."""
    tokens = observed.document.tokens
    return any(
        tokens[child].dep in ("nsubj", "nsubjpass", "expl") and tokens[child].lower != "you" and child < verb
        for child in observed.document.children[verb]
    )
