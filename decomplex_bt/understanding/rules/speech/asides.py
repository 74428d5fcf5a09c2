"""Asides: words between the orders that ask nothing and order nothing: tag questions, musings, reasons, concessions,
means, whereabouts."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from decomplex_bt.understanding.cue_phrases import normal_form
from decomplex_bt.understanding.document import ENDS, FINITE, MARKS, Document
from decomplex_bt.understanding.rules.cases.concessions import either_way
from decomplex_bt.understanding.states import OPPOSITES

_TAGS = frozenset("is has have does do did can will would".split())
_TAGGED = frozenset("he she it they you there we".split())
_MUSING = frozenset("think see remember recall guess".split())
_REASONS = frozenset(("since", "because", "cause", "cos", "cuz"))
_CONCEDING = tuple(
    tuple(phrase.split())
    for phrase in (
        "even if", "even when", "even though", "whether or not", "no matter if", "no matter whether", "no matter how",
        "regardless of whether", "irrespective of whether",
    )
)  # fmt: skip
_FIRST_CONCEDING = frozenset(first for first, *_ in _CONCEDING)
_LONGEST_CONCEDING = max(map(len, _CONCEDING))
_PERSONS = frozenset(("he", "she", "i", "we"))
_CONDITIONS = frozenset(("if", "unless", "when", "whether", "once"))
_GOING = frozenset("cross go walk pass take use follow climb drive cut skirt circle squeeze".split())
LONGEST_CASES = 7
"""The most words in which both of two cases are told."""
_CLAUSE_ENDS = MARKS | {"and", "or", "but", "so"}


def asides(document: Document, tasks: Collection[int]) -> frozenset[int]:
    """The tokens of all tag questions and musings in which no token is among the `tasks`: they say nothing of any."""
    return _all_of(document, tasks, (tag_question, musing))


def reasons(document: Document, tasks: Collection[int]) -> frozenset[int]:
    """The tokens of all reasons and concessions in which no token is among the `tasks`: at most they tell where things
    are."""
    return _all_of(document, tasks, (reason, concession))


def means_of(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The tokens of all means in which no token is among the `tasks`: they tell a way, no thing."""
    found = (means(document, token.i + 1, tasks) for token in document.tokens[:-1] if token.lower == "by")
    return frozenset(i for words in found if words is not None and tasks.keys().isdisjoint(words) for i in words)


def _all_of(
    document: Document, tasks: Collection[int], kinds: Sequence[Callable[[Document, int], range | None]]
) -> frozenset[int]:
    found: set[int] = set()
    asked = [kind for kind in kinds if not document.words.isdisjoint(_TELLING[kind])]  # most instructions have no aside
    for words in (kind(document, i) for kind in asked for i in range(len(document))):
        if words is not None and not any(i in tasks for i in words):
            found.update(words)
    return frozenset(found)


def tag_question(document: Document, at: int) -> range | None:
    """The words of the tag question in which token `at` is the verb ("he's asleep, is he?", "it's on, isn't it?"), or
    None; without a comma, where one of both denies ("it's on isn't it?", "he isn't in is he?")."""
    said = [normal_form(token.lower) for token in document.tokens[max(0, at - 1) : at + 4]]
    words = [word for word in said if word != "not"]
    if at == 0 or len(words) < 4 or words[1] not in _TAGS or words[2] not in _TAGGED or words[3] != "?":
        return None
    is_tag = words[0] == "," or (words[0] not in MARKS and _is_tagged(document, at, is_denied="not" in said))
    return range(at, at + said.index("?") - 1) if is_tag else None


def tagged(document: Document, at: int) -> int | None:
    """The "is" of the statement that the tag question with its verb at token `at` stands behind without a comma: "the
    tap*'s* on isn't it?"; None where it has none."""
    if tag_question(document, at) is None or document.tokens[at - 1].text in MARKS:
        return None
    start = next((i + 1 for i in range(at - 1, -1, -1) if document.tokens[i].text in MARKS), 0)
    return next((i for i in range(start + 1, at) if normal_form(document.tokens[i].lower) == "is"), None)


def _is_tagged(document: Document, at: int, *, is_denied: bool) -> bool:
    """Whether the words from the last mark up to the verb of a tag question are a statement that says the other of yes
    and no than that."""
    tokens = document.tokens
    start = next((i + 1 for i in range(at - 1, -1, -1) if tokens[i].text in MARKS), 0)
    words = [normal_form(token.lower) for token in tokens[start:at]]
    is_statement = len(words) > 1 and words[0] not in _TAGS | _CONDITIONS and not tokens[start].tag.startswith("W")
    is_finite = any(token.tag in FINITE or normal_form(token.lower) == "is" for token in tokens[start + 1 : at])
    return is_statement and is_finite and is_denied != ("not" in words)


def musing(document: Document, at: int) -> range | None:
    """The words in which somebody thinks aloud, or says no more than how to be, from token `at` on: "let me think",
    "let me see, ...", "make yourself useful and ...", or what for instance may be meant: "a coat, *say*, or a hat"; or
    None."""
    said = [token.lower for token in document.tokens[at : at + 4]]
    if said[:2] == ["say", ","] and at > 1 and document.tokens[at - 1].text == ",":
        return range(at, at + 1)
    if said[:2] == ["make", "yourself"]:
        return range(at, at + len(said[:3]))
    if len(said) < 3 or said[0] != "let" or said[1] not in ("me", "us") or said[2] not in _MUSING:
        return None
    return range(at, at + 3) if said[3:] == [] or not said[3].isalpha() else None


def is_explained(document: Document, at: int) -> bool:
    """Whether the verb at token `at` is in a clause that only says what something means: "if it's warm, *which means
    that the plots are done*, ..."."""
    tokens, start = document.tokens, at
    while start and tokens[start - 1].lower not in MARKS:
        start -= 1
    said = [token.lemma for token in tokens[start:at] if token.lower not in _HEDGING]
    return start > 0 and said[:1] == ["which"] and said[1:2] == ["mean"]


def concession(document: Document, at: int) -> range | None:
    """The clause that token `at` is in, where it names what makes no difference ("even if it rains", "whether or not it
    is on", "dirty or not, ..."); or None. "Even if it is" takes a condition up."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[at].lower in _CLAUSE_ENDS or document.words.isdisjoint(_TELLING[concession]):
        return None
    either = either_way(document, at) or _either(document, at)
    if either is not None:
        return either
    start = stop = at
    while start and sentences[start - 1] == sentences[at] and tokens[start - 1].lower not in MARKS:
        start -= 1
        if _concedes(document, start):
            break
    while stop < len(tokens) and sentences[stop] == sentences[at] and tokens[stop].lower not in _CLAUSE_ENDS:
        stop += 1
    return range(start, stop) if _concedes(document, start) and tokens[stop - 1].pos != "AUX" else None


def _either(document: Document, at: int) -> range | None:
    """The few words from a mark to the comma behind them that tell both of two cases: "dirty or not, ...", "full or
    empty, ..."; or None."""
    words = [token.lower for token in document.tokens]
    stop = next((i for i in range(at, min(at + LONGEST_CASES, len(words))) if words[i] in MARKS), len(words))
    start = at
    while start and words[start - 1] not in MARKS and document.sentences[start - 1] == document.sentences[at]:
        start -= 1
    if stop >= len(words) or words[stop] != "," or stop - start > LONGEST_CASES or stop - start < 3:
        return None
    *_, one, joint, other = words[start:stop]
    if any(
        token.pos == "AUX" or token.tag in ("VB", "VBP", "VBZ", "MD", "IN")
        for token in document.tokens[start : stop - 2]
    ):
        return None  # "tell me if it's full or not, ..."
    are_opposites = stop - start == 3 and (OPPOSITES.get(one) == other or OPPOSITES.get(other) == one)
    return range(start, stop) if joint == "or" and (other == "not" or are_opposites) else None


def _concedes(document: Document, start: int) -> bool:
    words = [token.lower for token in document.tokens[start : start + _LONGEST_CONCEDING]]
    return words[0] in _FIRST_CONCEDING and any(tuple(words[: len(phrase)]) == phrase for phrase in _CONCEDING)


def means(document: Document, at: int, tasks: Mapping[int, str]) -> range | None:
    """The words in which the verb at token `at` only tells which way somebody goes: "leave by crossing the hall"; or
    None. `tasks`: the types of tasks by their tokens. Of other tasks the means may be an order itself ("help me by
    carrying the bags", "dry the shirts by hanging them on the line")."""
    tokens, sentences = document.tokens, document.sentences
    if at < 2 or tokens[at - 1].lower != "by" or tokens[at].tag != "VBG" or tokens[at].lemma not in _GOING:
        return None
    governing = next((i for i in range(at - 2, -1, -1) if tokens[i].pos == "VERB" or tokens[i].lower in ENDS), None)
    if governing is None or tasks.get(governing) != "motion":
        return None
    stop = at
    while stop < len(tokens) and sentences[stop] == sentences[at] and tokens[stop].lower not in _CLAUSE_ENDS:
        stop += 1
    return range(at - 1, stop)


def whereabouts(document: Document, at: int) -> range | None:
    """The clause from token `at` on that tells where somebody is ("he's in the garden"); or None."""
    tokens, sentences = document.tokens, document.sentences
    before = tokens[at - 1].lower if at and sentences[at - 1] == sentences[at] else "."
    said = [normal_form(token.lower) for token in tokens[at : at + 2]]
    if before not in _CLAUSE_ENDS or tokens[at].lower not in _PERSONS or said[1:] not in (["is"], ["'m"], ["am"]):
        return None
    stop = at + 2
    while stop < len(tokens) and sentences[stop] == sentences[at] and tokens[stop].lower not in _CLAUSE_ENDS:
        stop += 1
    behind = next((token for token in tokens[at + 2 : stop] if token.pos != "ADV"), None)
    return range(at, stop) if behind is not None and behind.pos == "ADP" else None


def reason(document: Document, at: int) -> range | None:
    """The clause that token `at` is in, where it only tells why ("since the fan is broken"); or None."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[at].lower in _CLAUSE_ENDS:
        return None
    start = at
    while start and sentences[start - 1] == sentences[at] and tokens[start - 1].lower not in _CLAUSE_ENDS:
        if tokens[start].lower in _REASONS:
            break
        start -= 1
    stop = start
    while stop < len(tokens) and sentences[stop] == sentences[at] and tokens[stop].lower not in _CLAUSE_ENDS:
        if stop > start + 2 and _is_order(document, stop):
            break  # "since you're in the kitchen check the oven"
        stop += 1
    if not start <= at < stop:
        return None
    said = [token.lower for token in tokens[start:stop]]
    if sum(token.tag in FINITE for token in tokens[start:stop]) > 1:
        return None  # "because it's late check that the kids are asleep": where it ends nothing tells
    return range(start, stop) if said[0] in _REASONS and _CONDITIONS.isdisjoint(said) else None


def _is_order(document: Document, at: int) -> bool:
    """Whether a verb in its bare form begins an order within a clause."""
    tokens = document.tokens
    before = tokens[at - 1]
    is_led = before.tag in ("TO", "MD") or before.lower in ("do", "does", "n't", "not", "to")
    has_subject = any(tokens[i].dep in ("nsubj", "nsubjpass") and i < at for i in document.children[at])
    return tokens[at].tag in ("VB", "VBP") and tokens[at].pos == "VERB" and not is_led and not has_subject


_HEDGING = frozenset("would will might may could should probably usually of course".split())
_TELLING: Mapping[Callable[[Document, int], range | None], frozenset[str]] = {
    tag_question: frozenset("?"),
    musing: frozenset(("let", "make", "say")),
    reason: _REASONS,
    concession: _FIRST_CONCEDING | {"or", "whether"},
}
"""For each kind of aside words of which it has one."""
