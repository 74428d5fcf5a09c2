"""Deeds that are asked about again: what somebody has or has not done in "if he has", "if she didn't"."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.asked_again import is_pro_verb
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import PREDICATE, Gap

_DOING = frozenset("has have had 've did do does".split())
_NO_DEEDS = frozenset("be have do get check see look find try want need like".split())
"""Verbs that name no deed of their own, or are the check itself ("*see* whether the post has come")."""
_CLAUSE_ENDS = frozenset(
    "and but or so then if unless when before after while because until though since yet already today tonight "
    "tomorrow now still please".split()
)
_TIMES = frozenset("now then half quarter noon midday midnight teatime".split())
_VERBAL = frozenset(("VBN", "VBD", "VB", "VBP", "VBZ"))


def deed_asked_before(context: Context, gap: Gap, before: Sequence[Task]) -> Argument | None:
    """What a check without a verb of its own asks again: "has the plumber *gone*? If he hasn't, ...", "see if Ben has
    *fed the cat*. If he has, ..."; None where it takes up no deed, or a place."""
    first = next((task for task in before if task.id == context.first.get(gap.task.id)), None)
    document = context.observed.document
    if gap.type != PREDICATE or first is None or first.type != "check_state" or not _is_of_deed(document, gap.position):
        return None
    said = [argument for argument in first.arguments if argument.type in ("state", "location", "message")]
    if [argument.type for argument in said] == ["state"]:
        return Argument("state", said[0].value, None, said[0].confidence)
    verb = document.indices(first.span).start
    if said or not _is_deed(document, verb):
        return None
    deed = document.span(verb, _last_of_deed(context, verb))
    return Argument("state", deed.of(document.text), None, first.confidence)


def _is_of_deed(document: Document, verb: int) -> bool:
    return document.tokens[verb].lower in _DOING and is_pro_verb(document, verb)


def _is_deed(document: Document, verb: int) -> bool:
    token = document.tokens[verb]
    is_helped = any(document.tokens[i].dep == "aux" for i in document.children[verb])  # whatever the tagger has
    return (token.tag in _VERBAL or is_helped) and token.lemma not in _NO_DEEDS


def _last_of_deed(context: Context, verb: int) -> int:
    """The last word of what somebody does, without when: "*fed the cat* this morning", "*come* by eleven"."""
    document = context.observed.document
    times = {min((i, *document.children[i])) for i in document.children[verb] if document.tokens[i].dep == "npadvmod"}
    for i in range(verb + 1, len(document)):
        is_end = document.tokens[i].lower in MARKS | _CLAUSE_ENDS or i in times or i in context.verbs
        if is_end or _is_at_time(document, i):
            return i - 1
    return len(document) - 1


def _is_at_time(document: Document, at: int) -> bool:
    """Whether the "by" or "at" of a time stands at a token, not that of "come by"."""
    behind = document.tokens[at + 1 : at + 2]
    is_time = any(token.pos == "NUM" or token.lower in _TIMES for token in behind)
    return document.tokens[at].lower in ("by", "at", "around") and is_time
