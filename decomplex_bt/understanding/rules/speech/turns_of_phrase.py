"""Turns of phrase that are read as plainer ones, word for word: "the minute she arrives" as "just when she arrives"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from decomplex_bt.understanding.document import ENDS, MARKS
from decomplex_bt.understanding.vocabulary import LEVELS

_INSTANTS = frozenset("minute moment instant second".split())
_TIMES = frozenset(("each", "every", "any"))
_WITHIN = frozenset("in at for of by until till on from within to".split())
"""What makes an instant a while or a date: "*at* the moment the oven is off"."""
_SUBJECTS = frozenset(
    "i you he she it we they there this that the a an my your his her its our their someone somebody anyone anybody "
    "everyone everybody nobody".split()
)
_REASONS = frozenset("because cause cos since as for".split())
_JOINING = frozenset("and but or so then otherwise".split())
_INVERTED = 6
"""The most words between a "were" and its "to"."""
_POINTING = frozenset(("that", "this"))
_SOMEBODY = frozenset("he she they it".split())
_BEING = frozenset("'s s is are 're isn't isnt".split())
_DENYING = frozenset(("not", "n't"))
_TRUE = frozenset("true right correct so".split())
_FALSE = frozenset("false wrong untrue incorrect mistaken".split())
_SAYING = frozenset(
    "think thinks thought reckon reckons say says said believe believes guess suspect fear hear heard told claims "
    "claim insists swear swears might may sure imagine rumour rumor apparently supposedly probably maybe "
    "perhaps".split()
)
Change = tuple[int, str]


def plain_phrases(words: Sequence[str]) -> list[str] | None:
    """The words with plainer ones in the place of such phrases, one for one; None where there is no such phrase."""
    lower = [word.lower() for word in words]
    changes = [change for find in _PHRASES for change in find(words, lower)]
    if not changes:
        return None
    found = list(words)
    for i, word in changes:
        found[i] = word.capitalize() if words[i][0].isupper() else word
    return found


def _instants(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "The moment it rains", "every time the bell rings"; not "the second drawer", "at the moment it is on", nor what
    a "because" tells of ("because it cries the moment I leave")."""
    for i in range(len(words) - 2):
        ahead = lower[i - 1] if i else ""
        is_first = not ahead or ahead in MARKS or ahead in _JOINING
        is_instant = lower[i] == "the" and words[i + 1] in _INSTANTS and ahead not in _WITHIN
        is_instant = is_instant and (is_first or _REASONS.isdisjoint(_sentence_ahead(lower, i)))
        is_time = is_first and lower[i] in _TIMES and lower[i + 1] == "time"
        is_clause = lower[i + 2] in _SUBJECTS or (words[i + 2][0].isupper() and words[i + 2].isalpha())
        if (is_instant or is_time) and is_clause:
            yield from ((i, "just"), (i + 1, "when"))


def _sentence_ahead(lower: Sequence[str], i: int) -> Sequence[str]:
    start = next((j + 1 for j in range(i - 1, -1, -1) if lower[j] in ENDS), 0)
    return lower[start:i]


def _inversions(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "Were she to refuse, ..."; not "were you able to find it?"."""
    for i, word in enumerate(lower):
        if word != "were" or not (i == 0 or lower[i - 1] in MARKS or lower[i - 1] in _JOINING):
            continue
        stop = next((j for j in range(i + 1, len(lower)) if lower[j] in MARKS), len(lower))
        to = next((j for j in range(i + 2, min(stop, i + _INVERTED + 2)) if lower[j] == "to"), stop)
        is_name = to == i + 2 and (lower[i + 1] in _SUBJECTS or words[i + 1][0].isupper())
        is_named = is_name or (to > i + 2 and lower[i + 1] in _SUBJECTS - _SOMEBODY - {"you", "i", "we"})
        if to + 1 < stop < len(lower) and is_named and lower[stop] == ",":
            yield from ((i, "should"), (to, "ever"))


def _verdicts(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "If that's true", "if he's right" of what was said or thought before."""
    is_said = False
    for i, word in enumerate(lower):
        is_said = is_said or word in _SAYING
        if word != "if" or not is_said or i + 3 >= len(lower) or lower[i + 2] not in _BEING:
            continue
        j = i + 3 + (lower[i + 3] in _DENYING)
        end = j + 2 if lower[j : j + 2] == ["the", "case"] else j + 1
        is_closed = end == len(lower) or (end < len(lower) and (lower[end] in MARKS or lower[end] == "then"))
        if not (lower[i + 1] in _POINTING | _SOMEBODY and is_closed):
            continue
        if end == j + 2 and lower[i + 1] in _POINTING:
            yield from ((i + 1, "it"), (j, "so"), (j + 1, "then"))
        elif end == j + 1 and lower[j] in _TRUE | _FALSE:
            yield from ((i + 1, "it"), (j, "then" if lower[j] in _TRUE else "not"))


def _levels(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "Anything under ten, turn it on; anything in between, leave it"."""
    for i in range(len(words) - 3):
        is_first = i == 0 or lower[i - 1] in MARKS or lower[i - 1] in _JOINING
        stop = next((j for j in range(i + 2, min(i + _INVERTED, len(words))) if lower[j] in MARKS - {"-"}), i)
        if is_first and lower[i] == "anything" and lower[i + 1] in LEVELS and stop > i + 2 and lower[stop] == ",":
            yield (i, "if")
        if is_first and lower[i : i + 4] == ["anything", "in", "between", ","]:
            yield from ((i, "and"), (i + 1, "if"), (i + 2, "neither"))


def _answers(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "For tea, ... For coffee, ..." behind "tea or coffee"."""
    for i in range(len(words) - 2):
        is_first = i == 0 or lower[i - 1] in ENDS
        if is_first and lower[i] == "for" and lower[i + 2] == "," and _is_offered(lower[:i], lower[i + 1]):
            yield (i, "if")


def _is_offered(before: Sequence[str], word: str) -> bool:
    """Whether a word is one of two that an "or" joined before."""
    return any(before[i] == "or" and word in (before[i - 1], *before[i + 1 : i + 3]) for i in range(1, len(before)))


def _events(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "In the event he's out", which lacks a "that"."""
    for i in range(len(words) - 3):
        is_clause = lower[i + 3] in _SUBJECTS - {"that"} or words[i + 3][0].isupper()
        if lower[i : i + 3] == ["in", "the", "event"] and is_clause:
            yield from ((i, "on"), (i + 1, "condition"), (i + 2, "that"))


def _absences(words: Sequence[str], lower: Sequence[str]) -> Iterator[Change]:
    """ "In the absence of milk", "not unless it's dry"."""
    for i in range(len(words)):
        if lower[i : i + 4] == ["in", "the", "absence", "of"]:
            yield from ((i + 1, "case"), (i + 2, "of"), (i + 3, "no"))
        if lower[i : i + 2] == ["not", "unless"]:
            yield from ((i, "only"), (i + 1, "if"))


_PHRASES: tuple[Callable[[Sequence[str], Sequence[str]], Iterator[Change]], ...] = (
    _instants, _inversions, _verdicts, _levels, _answers, _events, _absences,
)  # fmt: skip
