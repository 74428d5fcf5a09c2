"""Opened cases: what opens a case without an "if", ahead of an order and a mark: states and levels ("*red*, call Ann;
*green*, come back"), statements ("*she says no*: ring Tom"), what there is any or none of ("*any crumbs*, sweep them
up", "*no bread* then get a roll"), what is so meanwhile ("*with nobody in there*, sweep it")."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from decomplex_bt.understanding.document import ENDS, FINITE, Document
from decomplex_bt.understanding.rules.speech.edits import is_order_at
from decomplex_bt.understanding.states import OPPOSITES, SCALES
from decomplex_bt.understanding.vocabulary import LEVELS

_DEGREES_OF = frozenset("more less fewer".split())
_SHARES = frozenset("half quarter third zero".split())
_NUMBERS = frozenset(
    "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen twenty thirty forty fifty sixty seventy eighty ninety hundred".split()
)
_LONGEST = 5
"""The most words of a state or level that opens a case."""
_LONGEST_CASE = 8
"""The most words of any other case."""
_STATES = frozenset(OPPOSITES).union(*SCALES) | {"fine", "ok", "okay"}
_VERBS = frozenset("clean dry open empty warm cool free light close wet lock lit quiet".split())
"""States that may as well be orders: "*Clean*, dry and fold"."""
_DEGREES = frozenset("too still not very quite fast sound all nearly almost half just only completely".split())
_NO_ORDERS = frozenset("DT PRP PRP$ IN WDT WP CD CC EX MD".split())
"""Tags of what begins no order."""
_ORDERS = frozenset(("VB", "VBP"))
_PARTING = ENDS | {":"}
_TURNING = frozenset("otherwise else neither".split())
_TELLING = frozenset("he she they it".split())
_SOMEBODY = frozenset("anyone anybody someone somebody nobody no".split())
_SAME = frozenset("it them that those".split())
_ALLOWING = frozenset(("you", "there"))
"""What may lead to what is done, or is not: "with it off, *you* may go", "with it on, *there*'s nothing to do"."""


class Opened(NamedTuple):
    """A case: the `mark` that ends it, or the word before which one should, and the words that are `dropped`."""

    mark: int
    dropped: tuple[int, ...]


def states_told(document: Document) -> list[int]:
    """The marks behind states or levels, two at least, or one and an "otherwise", that begin a clause each and are all
    that it says, ahead of an order; of two statements about somebody ("*he says no*: ...; *he says yes*: ..."), and
    behind what there is "any" of."""
    return [*_bare(document), *_stated(document), *_any(document)]


def _bare(document: Document) -> list[int]:
    tokens = document.tokens
    found: list[int] = []
    last: set[str] = set()
    for mark in (i for i in range(1, len(tokens) - 2) if tokens[i].text == "," and tokens[i + 1].tag not in _NO_ORDERS):
        first = _clause_start(document, mark)
        words = [token.lower for token in tokens[first:mark]]
        is_short = first > 0 and 0 < len(words) <= _LONGEST and "," not in words
        if is_short and (_is_level(words) or _is_state(words)):
            found.append(mark)
            last.add(words[-1])
    # the tagger takes "ring" for a noun, but hardly all
    is_certain = not last <= _VERBS and any(is_order_at(document, mark + 1) for mark in found)
    is_told = len(found) > 1 or (len(found) == 1 and not _TURNING.isdisjoint(t.lower for t in tokens[found[0] :]))
    return found if is_told and is_certain else []


def _stated(document: Document) -> list[int]:
    """The colons behind two or more statements that begin a sentence with a pronoun: "*they're right*: hang it up"."""
    tokens = document.tokens
    found = []
    for mark in (i for i in range(3, len(tokens) - 2) if tokens[i].text == ":" and is_order_at(document, i + 1)):
        said = tokens[_clause_start(document, mark) : mark]
        is_short = 1 < len(said) <= _LONGEST and said[0].i > 0
        if is_short and said[0].lower in _TELLING and any(t.tag in FINITE for t in said[1:3]):
            found.append(mark)
    return found if len(found) > 1 else []


def _any(document: Document) -> Iterator[int]:
    """The commas behind what there may be any of, at the beginning of a sentence, ahead of what is done with it."""
    tokens = document.tokens
    for mark in (i for i in range(3, len(tokens) - 2) if tokens[i].text == "," and is_order_at(document, i + 1)):
        said = tokens[_clause_start(document, mark) : mark]
        is_plain = 1 < len(said) <= _LONGEST_CASE and said[0].i > 0 and all(t.tag not in FINITE for t in said)
        stop = next((t.i for t in tokens[mark + 1 :] if t.text in _PARTING), len(tokens))
        is_plain = is_plain and all(t.lower != "other" for t in said)  # "any other case, call me"
        if is_plain and said[0].lower == "any" and any(t.lower in _SAME for t in tokens[mark + 2 : stop]):
            yield mark


def attended(document: Document) -> Iterator[Opened]:
    """Every case that a "with" opens at the beginning of a clause: who is somewhere, or how a thing is; not with what
    something is done ("*with a cloth*, wipe it")."""
    tokens = document.tokens
    for first in (t.i for t in tokens if t.lower == "with" and _begins_clause(document, t.i)):
        mark = next((i for i in range(first + 1, len(tokens) - 1) if tokens[i].text in (",", *_PARTING)), first)
        said = [token.lower for token in tokens[first + 1 : mark]]
        is_short = mark > first and tokens[mark].text == "," and 1 < len(said) <= _LONGEST_CASE
        is_told = is_short and (is_order_at(document, mark + 1) or tokens[mark + 1].lower in _ALLOWING)
        is_state = is_told and (said[-1] in _STATES or (said[0] in _SOMEBODY and "in" in said))
        if is_state:
            dropped = (first, first + 1) if said[0] in _SAME and len(said) > 1 else (first,)
            yield Opened(mark, dropped)


def denied(document: Document) -> Iterator[Opened]:
    """Every "no" with a noun and a "then" behind a comma: "look for a pear, *no pear* then get a plum"."""
    tokens = document.tokens
    for then in (i for i in range(3, len(tokens) - 1) if tokens[i].lower == "then" and tokens[i + 1].tag in _ORDERS):
        no = next((j for j in range(then - 2, max(0, then - 4), -1) if tokens[j].lower == "no"), None)
        if no is not None and tokens[no - 1].text == "," and tokens[then - 1].pos in ("NOUN", "PROPN"):
            yield Opened(then, (no - 1,))


def _clause_start(document: Document, mark: int) -> int:
    return next((j + 1 for j in range(mark - 1, -1, -1) if document.tokens[j].text in _PARTING), 0)


def _begins_clause(document: Document, i: int) -> bool:
    return i == 0 or document.tokens[i - 1].text in _PARTING


def _is_level(words: list[str]) -> bool:
    is_amount = any(word.isdigit() or word in _SHARES or word in _NUMBERS for word in words[1:])
    is_compared = words[0] in LEVELS or (words[0] in _DEGREES_OF and words[1:2] == ["than"])
    return is_compared and is_amount


def _is_state(words: list[str]) -> bool:
    while words[:1] and words[0] in _DEGREES:
        words = words[1:]
    return len(words) == 1 and words[0] in _STATES
