"""Pro-verbs: a "do so" that orders what somebody was asked about ("ask Tom whether you should close the garage. If yes,
*do so*")."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.rules.cases.waits import type_of

_SO = frozenset(("so", "it", "that", "this"))
_BEFORE = frozenset("yes yeah yep so then please just does is wants case go ahead ok okay".split()) | MARKS
_BEHIND = frozenset("if and then otherwise else but or please now right anyway too unless yourself".split()) | MARKS
_WHETHER = frozenset(("if", "whether"))
_LEADING = frozenset("to should can could may might must shall".split())
_WANTING = frozenset(("want", "need", "like"))
_ASKING = frozenset(("did", "has", "have", "had"))
_PAST = frozenset(("VBD", "VBN"))
_BE = frozenset("is are was were be been got get gets".split())
_SWITCHING = frozenset(("on", "off"))
_STATIVE = frozenset(("JJ", "VBN", "RP", "IN"))


@dataclass(frozen=True, slots=True)
class ProVerb:
    """What a "do so" stands for: the `type` of the task, the tokens of the `thing` that it is done to and of its
    `state`, either of which may be empty."""

    type: str
    thing: range
    state: range


def pro_verbs(observed: Observed, tasks: Mapping[int, str]) -> dict[int, ProVerb]:
    """Every "do" of an order to do what was asked about last; `tasks`: the tokens that are tasks, with types. What was
    ordered before is not ordered again by a "do it"."""
    document, found = observed.document, dict[int, ProVerb]()
    for i, token in enumerate(document.tokens[1:], start=1):
        if token.lower != "do" or not _is_order(document, i):
            continue
        if (done := _done(observed, tasks, i)) is not None:
            found[i] = done
            continue
        last = max((j for j, kind in tasks.items() if j < i and kind != "check_state"), default=None)
        if last is None or tasks[last] != "informing" or document.sentences[i] > document.sentences[last] + 1:
            continue
        whether = next((j for j in range(last + 1, i) if document.tokens[j].lower in _WHETHER | {"to"}), None)
        if whether is not None and (asked := _asked(observed, whether, i)) is not None:
            found[i] = asked
    return found


def with_doings(observed: Observed, tasks: Sequence[Task]) -> tuple[Task, ...]:
    """The tasks, each "do so" with what was asked about."""
    document = observed.document
    known = {document.indices(task.span).start: task.type for task in tasks}
    found = pro_verbs(observed, known)
    return tuple(
        _told(document, task, found[at]) if (at := document.indices(task.span).start) in found else task
        for task in tasks
    )


def _told(document: Document, task: Task, meant: ProVerb) -> Task:
    said = {"object": meant.thing, "state": meant.state}
    told = [
        Argument(name, document.span(tokens.start, tokens.stop - 1).of(document.text), None, task.confidence)
        for name, tokens in said.items()
        if tokens
    ]
    return replace(task, arguments=(*(a for a in task.arguments if a.type not in said and a.span), *told))


def _is_order(document: Document, do: int) -> bool:
    """Whether a "do" is an order by itself ("please *do*", where a mark ends it) or with its "so"."""
    tokens = document.tokens
    if all(token.text in MARKS for token in tokens[do + 1 : do + 2]):
        return tokens[do - 1].lower == "please"
    behind = tokens[do + 2 : do + 3]
    is_whole = tokens[do + 1].lower in _SO and (not behind or behind[0].lower in _BEHIND)
    return is_whole and tokens[do - 1].lower in _BEFORE


def _done(observed: Observed, tasks: Mapping[int, str], do: int) -> ProVerb | None:
    """What a check right before, or one that an echo takes up ("if he hasn't, do it"), asks whether it was done: "has
    anybody *fed the cat*?", "see if *the plants have been watered*"; None where it asks no such thing."""
    document, tokens = observed.document, observed.document.tokens
    near = [j for j, kind in tasks.items() if j < do and document.sentences[j] + 1 >= document.sentences[do]]
    if not near or any(tasks[j] != "check_state" for j in near[-2:]):
        return None
    chunks = list(noun_chunks(document))
    for i in range(near[-2:][0], do):
        is_past = tokens[i].tag in _PAST or _is_asked_past(document, i)
        if not is_past or not observed.senses[i] or type_of(observed, i) in ("check_state", "motion"):
            continue
        behind = i + 1 + (tokens[i + 1].tag == "RP")
        thing = next((chunk for chunk in chunks if chunk.start in (i + 1, behind)), None)
        if thing is None and not _BE.isdisjoint(token.lower for token in tokens[max(0, i - 3) : i]):
            thing = next((chunk for chunk in reversed(chunks) if chunk.stop <= i), None)
        if thing is not None:
            stop = next((j for j in range(i + 1, do) if tokens[j].text in MARKS), do)
            state = next((j for j in range(i + 1, stop) if tokens[j].lower in _SWITCHING), i)
            is_state = state != i or tokens[i].lower in observed.gazetteer.states
            return ProVerb(type_of(observed, i), thing, range(state, state + is_state))
    return None


def _is_asked_past(document: Document, at: int) -> bool:
    """Whether a verb is that of a "did" or "has" ahead of it in its sentence: "*did* I lock the door?"."""
    ahead = (token for token in document.tokens[:at] if document.sentences[token.i] == document.sentences[at])
    return document.tokens[at].tag in ("VB", "VBP") and any(token.lower in _ASKING for token in ahead)


def _asked(observed: Observed, start: int, stop: int) -> ProVerb | None:
    """What is asked about between two tokens: "whether you should *close the garage*", "if she wants *the window
    open*"."""
    document, tokens = observed.document, observed.document.tokens
    chunks = list(noun_chunks(document))
    for i in range(start, stop):
        behind = i + 1 + (i + 1 < stop and tokens[i + 1].tag == "RP")
        thing = next((chunk for chunk in chunks if chunk.start in (i + 1, behind)), range(0))
        is_led = any(token.lower in _LEADING for token in tokens[max(start, i - 3) : i])
        if is_led and tokens[i].tag in ("VB", "VBP") and observed.senses[i]:
            switched = next((j for j in range(i + 1, stop) if tokens[j].text in MARKS), stop)
            state = next((j for j in range(i + 1, switched) if tokens[j].lower in _SWITCHING), None)
            return ProVerb(type_of(observed, i), thing, range(state, state + 1) if state else range(0))
        if tokens[i].lemma in _WANTING and thing:
            return _wanted(observed, thing, stop)
    return None


def _wanted(observed: Observed, thing: range, stop: int) -> ProVerb | None:
    """What somebody wants a thing to be or done to it: "*the window open*", "*his tea warmed* up"."""
    tokens, at = observed.document.tokens, thing.stop
    if len(thing) > 2 and tokens[at - 1].lower in observed.gazetteer.states:
        at -= 1  # "open" may be a noun to the tagger
    if at >= stop:
        return None
    if tokens[at].tag in ("VBN", "VBD") and observed.senses[at]:
        return ProVerb(type_of(observed, at), thing, range(0))
    is_state = tokens[at].tag in _STATIVE or tokens[at].lower in observed.gazetteer.states
    return ProVerb("change_state", range(thing.start, at), range(at, at + 1)) if is_state else None
