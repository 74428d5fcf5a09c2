"""Marks that a text lacks or has otherwise, as recognisers and hurried people write it: it is read with plain ones."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import ENDS, FINITE, MARKS, Document
from decomplex_bt.understanding.remainder import COMMA, QUESTION, Remainder, Told, told
from decomplex_bt.understanding.rules.speech.edits import is_order_at
from decomplex_bt.understanding.rules.speech.second_thoughts import second_thoughts
from decomplex_bt.understanding.states import OPPOSITES, SCALES

_CASES = frozenset("if when unless once".split())
_IS = frozenset("'s \u2019s is are s".split())
_SUBJECTS = frozenset(("PRP", "WDT", "WP", "EX"))
_NEGATIONS = frozenset(("n't", "n\u2019t", "nt", "not"))
_LEVELS = frozenset("below above under over".split())
_SHARES = frozenset("half quarter third zero".split())
_NUMBERS = frozenset(
    "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen twenty thirty forty fifty sixty seventy eighty ninety hundred".split()
)
_LONGEST = 5
"""The most words of a state or level that opens a case."""
_STATES = frozenset(OPPOSITES).union(*SCALES)
_VERBS = frozenset("clean dry open empty warm cool free light close wet lock lit quiet".split())
"""States that may as well be orders: "*Clean*, dry and fold"."""
_DEGREES = frozenset("too still not very quite fast sound all nearly almost half just only completely".split())
_NO_ORDERS = frozenset("DT PRP PRP$ IN WDT WP CD CC EX MD".split())
"""Tags of what begins no order."""
_PARTING = ENDS | {":"}
_TURNING = frozenset("otherwise else neither".split())


def marked(document: Document) -> Remainder | None:
    """The text with a comma around a "no" that puts an order in place of another ("turn it on *no* turn it off") and
    ahead of what a case forbids ("if it's wet *don't* iron it"), and a question mark behind states that open a case
    each ("*red*, call Ann; *green*, come back"); None where it has all of them."""
    commas = {place for run in second_thoughts(document) for place in (run.start, run.stop)}
    commas.update(_prohibitions(document))
    questions = frozenset(_bare_cases(document))
    if not commas and not questions:
        return None
    sequence: list[Told] = []
    for i in range(len(document)):
        if i in commas:
            sequence.append(Told(COMMA))
        sequence.append(Told(QUESTION if i in questions else i))
    return told(document, sequence)


def _prohibitions(document: Document) -> Iterator[int]:
    """Where a "don't" begins to say what is not to be done in the case right ahead; not what somebody does not do ("if
    the cups that are left *don't* fit")."""
    tokens = document.tokens
    for i in range(3, len(tokens) - 2):
        if tokens[i].lower not in ("do", "dont") or (tokens[i].lower == "do" and tokens[i + 1].lower not in _NEGATIONS):
            continue
        clause = next((j + 1 for j in range(i - 1, -1, -1) if tokens[j].text in MARKS), 0)
        opener = next((j for j in range(i - 1, clause - 1, -1) if tokens[j].lower in _CASES), None)
        if opener is None or tokens[i - 1].tag in _SUBJECTS or tokens[i - 1].tag in FINITE:
            continue
        asked = [t for t in tokens[opener + 2 : i] if t.tag in FINITE or t.lower in _IS]
        if len(asked) == 1 and not any(t.tag in ("WDT", "WP") or t.lower == "that" for t in tokens[opener + 2 : i]):
            yield i


def _bare_cases(document: Document) -> list[int]:
    """The commas behind states or levels, two at least, or one and an "otherwise", that begin a clause each and are all
    that it says, ahead of an order."""
    tokens = document.tokens
    found: list[int] = []
    last: set[str] = set()
    for mark in (i for i in range(1, len(tokens) - 2) if tokens[i].text == "," and tokens[i + 1].tag not in _NO_ORDERS):
        first = next((j + 1 for j in range(mark - 1, -1, -1) if tokens[j].text in _PARTING), 0)
        words = [token.lower for token in tokens[first:mark]]
        is_short = first > 0 and 0 < len(words) <= _LONGEST and "," not in words
        if is_short and (_is_level(words) or _is_state(words)):
            found.append(mark)
            last.add(words[-1])
    # the tagger takes "ring" for a noun, but hardly all
    is_certain = not last <= _VERBS and any(is_order_at(document, mark + 1) for mark in found)
    is_told = len(found) > 1 or (len(found) == 1 and not _TURNING.isdisjoint(t.lower for t in tokens[found[0] :]))
    return found if is_told and is_certain else []


def _is_level(words: list[str]) -> bool:
    is_amount = any(word.isdigit() or word in _SHARES or word in _NUMBERS for word in words[1:])
    return words[0] in _LEVELS and is_amount


def _is_state(words: list[str]) -> bool:
    while words[:1] and words[0] in _DEGREES:
        words = words[1:]
    return len(words) == 1 and words[0] in _STATES
