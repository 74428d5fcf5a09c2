"""Purposes: what something is done for is no order ("open the window *to get the smell out*"), nor is what is to be
avoided by it ("wipe it, *taking care not to scratch it*")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.document import MARKS, Document

_SERVING = frozenset(("placing", "change_state"))
"""Types of orders that serve a purpose by themselves; one goes, takes or brings something to do more with it."""
_ENDS = MARKS | frozenset("and but or then if unless when before after".split())
_ORDERS = frozenset(("VB", "VBP"))
_CARING = tuple(
    tuple(phrase.split())
    for phrase in ("care not to", "careful not to", "so as to", "so as not to", "in order to", "trying not to")
)
_LOOKING = frozenset("look see check".split())
"""What is found out by the way, which is ordered: "switch the lamp on *to look* at it"."""
_OBJECTS = frozenset("DT PRP PRP$ NN NNS".split())
_OBLIGING = frozenset("you me him her us have has had need needs want wants ask got".split())
"""What a "to" behind them belongs to: "I need you *to* wash it"."""


def purposes(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens of every purpose, from its "to" to the end of its clause; `tasks`: tokens with types."""
    tokens = document.tokens
    if "to" not in document.words:
        return frozenset()
    found: set[int] = set()
    for to in (i for i in range(1, len(tokens) - 1) if tokens[i].lower == "to"):
        verb = to + 1 + (tokens[to + 1].tag == "RB" and to + 2 < len(tokens))
        if _is_deed(document, verb) and (_is_care(document, to) or _is_of_order(document, to, tasks)):
            found.update(_clause(document, to))
    return frozenset(found)


def _is_deed(document: Document, verb: int) -> bool:
    """Whether a word behind a "to" is done to something; not "set it to *low*", "go to *room* 12"."""
    token, behind = document.tokens[verb], document.tokens[verb + 1 : verb + 2]
    is_deed = token.tag in _ORDERS and token.lemma not in _LOOKING and behind != ()
    return is_deed and behind[0].tag in _OBJECTS and behind[0].lower != "number"


def _is_care(document: Document, to: int) -> bool:
    words = [token.lower for token in document.tokens[max(0, to - 3) : to + 1]]
    return any(tuple(words[-len(phrase) :]) == phrase for phrase in _CARING)


def _is_of_order(document: Document, to: int, tasks: Mapping[int, str]) -> bool:
    """Whether an order to put or change something stands ahead in the same clause, and what it is done to right
    before."""
    tokens = document.tokens
    order = max((i for i in tasks if i < to), default=None)
    if order is None or tasks[order] not in _SERVING or tokens[order].tag not in _ORDERS or order == to - 1:
        return False
    if tokens[order].lemma == "use":
        return False  # "use the mop to clean the floor"
    between = tokens[order + 1 : to]
    is_clause = all(token.lower not in _ENDS and token.tag[:2] != "VB" for token in between)
    is_behind_thing = between[-1].pos in ("NOUN", "PROPN", "PRON", "ADV", "ADP")
    return is_clause and is_behind_thing and between[-1].lower not in _OBLIGING


def _clause(document: Document, start: int) -> Iterator[int]:
    for i in range(start, len(document)):
        if document.tokens[i].lower in _ENDS:
            return
        yield i
