"""The retelling: an instruction with its alternatives told in full and behind their conditions, as models know them.

"Bring me a pen, or a pencil if there is none" is told as "bring me a pen, or if there is none, bring me a pencil": its
words are the instruction's own, some of them twice and some in another place.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.phrases import PERSON_NOUNS, PREPOSITIONS, head_of, is_pronoun
from decomplex_bt.understanding.remainder import COMMA, STOP, Remainder, Told, told
from decomplex_bt.understanding.rules.alternatives import Alternative, alternatives

_OPENING = frozenset(("if", "only_if", "unless"))
_TURNING = frozenset(("else", "fail"))
_GOVERNING = _OPENING | _TURNING | {"when", "so"}
_JOINING = frozenset(("and", "but", "or", ","))
_ENDING = frozenset(("source", "goal", "location", "recipient"))
"""Types of arguments that tell from where, where to or to whom."""
_FROM = frozenset(("from", "off", "out"))


@dataclass(frozen=True, slots=True)
class Retelling:
    """`told`: the whole; `verbs`: of the orders that the text leaves unsaid, where the word stands that carries each,
    with the place of the verb that it has."""

    told: Remainder
    verbs: Mapping[int, int]


def retold(observed: Observed, instruction: Instruction) -> Retelling | None:
    """The text of an instruction that has alternatives without a verb or ahead of their condition, told in full; None
    where it has none. `instruction`: how the text was read as it stands."""
    document = observed.document
    tasks = {document.indices(task.span).start: task for task in instruction.tasks}
    insertions: dict[int, list[Told]] = defaultdict(list)
    moved: set[int] = set()
    verbs: dict[int, int] = {}
    for found in alternatives(observed, {i: task.type for i, task in tasks.items()}):
        place, end = found.tokens.start, found.tokens.stop
        order = None if found.is_verbal else _antecedent(observed, tasks, found)
        words = None if order is None else _repeated(observed, tasks[order], found)
        if words is None and not found.is_verbal:
            continue
        condition = [*found.condition, COMMA] if found.condition else []
        moved.update(found.condition)
        insertions[place] += map(Told, condition)
        if order is None or words is None:
            continue
        carrier = _carrier(document, found.tokens)
        verbs[document.tokens[carrier].start] = document.tokens[order].start
        insertions[place] += [Told(i, place, carrier if i == order else None) for i in words[0]]
        insertions[end] += [Told(i, place) for i in words[1]]
        stop = max(end, found.condition.stop)
        if _is_whole(observed, stop, order):
            moved.add(stop)
            insertions[stop].append(Told(STOP))
    if not insertions:
        return None
    sequence = [
        word
        for i in range(len(document) + 1)
        for word in (*insertions.get(i, ()), *([Told(i)] if i < len(document) and i not in moved else ()))
    ]
    return Retelling(told(document, sequence), verbs)


def _carrier(document: Document, words: range) -> int:
    """The word of a phrase that carries an unsaid verb: its preposition, else its head."""
    return words.start if document.tokens[words.start].lower in PREPOSITIONS else head_of(document, words)


def _antecedent(observed: Observed, tasks: Mapping[int, Task], found: Alternative) -> int | None:
    """The order that an alternative without a verb repeats: the last one before it that is no condition, in its
    sentence or, where that begins with its condition or an "otherwise", in one before.

    A search of one place, otherwise another, is one search.
    """
    sentences, place = observed.document.sentences, found.tokens.start
    openings = [cue.last for cue in observed.cues if cue.name in _OPENING]
    conditions = {min((i for i in tasks if i > last), default=-1) for last in openings}
    orders = [i for i, task in tasks.items() if i < place and task.type != "check_state" and i not in conditions]
    if not orders or any(token.pos == "ADV" for token in observed.document.tokens[place : found.tokens.stop]):
        return None  # "the charger's somewhere in here" names nothing to be plugged in
    last = orders[-1]
    leading = [cue.first for cue in observed.cues if cue.name in _OPENING | _TURNING]
    begins = (i for i in leading if sentences[i] == sentences[place] and _is_beginning(observed.document, i))
    if sentences[last] != sentences[place] and next(begins, None) is None:
        return None
    is_conditional = bool(found.condition) or any(last < i < place for i in openings)
    return last if is_conditional or tasks[last].type != "searching" else None


def _is_whole(observed: Observed, stop: int, order: int) -> bool:
    """Whether what follows a comma after an alternative without a verb goes with the order that has it ("tea, or coffee
    if there is none, *and close the door*"): where that hangs on nothing, it is a sentence of its own."""
    tokens, sentences = observed.document.tokens, observed.document.sentences
    if stop + 1 >= len(tokens) or tokens[stop].text != "," or tokens[stop + 1].lower not in ("and", "then"):
        return False
    return not any(
        c.name in _GOVERNING and c.first < order and sentences[c.first] == sentences[order] for c in observed.cues
    )


def _is_beginning(document: Document, i: int) -> bool:
    """Whether a sentence begins here, but for words that join it to the last one."""
    while i > 0 and document.tokens[i - 1].lower in _JOINING and document.sentences[i - 1] == document.sentences[i]:
        i -= 1
    return i == 0 or document.sentences[i - 1] != document.sentences[i]


def _repeated(observed: Observed, task: Task, found: Alternative) -> tuple[Sequence[int], Sequence[int]] | None:
    """The tokens of an order to be said again ahead of an alternative and behind it; None where it has nothing of its
    kind."""
    document = observed.document
    verb = document.indices(task.span).start
    until = min(
        (cue.first for cue in observed.cues if cue.name in _OPENING and cue.first > verb), default=len(document)
    )
    until = min(until, found.tokens.start)
    own = [
        (argument, tokens)
        for argument in task.arguments
        if argument.span is not None and argument.type != "manner"
        for tokens in [_up_to(document, document.indices(argument.span), until)]
        if verb < tokens.start < until
    ]
    replaced = _replaced(observed, own, found.tokens)
    if replaced is None:
        return None
    behind_verb = (document.tokens[i] for i in document.children[verb] if i < until)
    said = {verb, *(t.i for t in behind_verb if t.dep == "prt" or (t.dep == "advmod" and t.lower in PARTICLES))}
    said.update(i for _, tokens in own if tokens != replaced for i in tokens)
    said.update(range(verb + 1, replaced.start))  # what stands between, be it found or not: "bring *me* the orange"
    ahead, behind = sorted(i for i in said if i < replaced.start), sorted(i for i in said if i >= replaced.stop)
    is_led = document.tokens[found.tokens.start].lower in PREPOSITIONS
    if document.tokens[replaced.start].lower in PREPOSITIONS | {"for"} and len(replaced) > 1 and not is_led:
        ahead.append(replaced.start)
    return ahead, behind


def _up_to(document: Document, tokens: range, stop: int) -> range:
    """The tokens before another one, without what joins them to it: "the orange*, or* the apple"."""
    last = min(tokens.stop, stop)
    while last > tokens.start + 1 and document.tokens[last - 1].lower in _JOINING:
        last -= 1
    return range(tokens.start, last)


def _replaced(observed: Observed, own: Sequence[tuple[Argument, range]], words: range) -> range | None:
    """The argument in whose place the words of an alternative stand."""
    document = observed.document
    first, last = document.tokens[words.start], document.tokens[words.stop - 1]
    if first.lower in PREPOSITIONS and len(words) > 1:
        alike = [tokens for _, tokens in own if document.tokens[tokens.start].lower == first.lower]
        ending = [
            tokens
            for argument, tokens in own
            if argument.type in _ENDING and (argument.type == "source") == (first.lower in _FROM)
        ]
        return next(reversed(alike or ending), None)
    by_type = {argument.type: tokens for argument, tokens in own}
    is_person = last.lemma in PERSON_NOUNS or (last.pos == "PROPN" and last.text[:1].isupper() and len(words) == 1)
    thing = by_type.get("object")
    if is_person and "recipient" in by_type:
        return by_type["recipient"]
    ending = [tokens for argument, tokens in own if argument.type in _ENDING]
    category = observed.gazetteer.category(last.lemma)
    is_place = category in ("room", "furniture") or (
        not category and thing is not None and is_pronoun(document, thing) and "recipient" not in by_type
    )
    return ending[-1] if ending and (is_place or thing is None) else thing
