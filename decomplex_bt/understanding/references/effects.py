"""Effects: the state that an order ends in, which a bare "if it isn't already" behind it asks, and which is tried on
another thing where it fails ("turn the tv on; if it won't, try the radio"), and in which nothing is before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.domain.lexicon import Lexicon
from decomplex_bt.domain.verbs import sense_of
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.gaps import DENYING, is_bare_being

_OPENING = frozenset(("if", "unless"))
_ANY_ONE = frozenset("one ones some".split())
_TAKEN_UP = frozenset("it that this them those".split())
_ANSWERED = frozenset(("state", "location"))


def with_effects(document: Document, tasks: Sequence[Task], lexicon: Lexicon) -> tuple[Task, ...]:
    """The tasks; a check that says no more than whether it is so, right behind the order that it is the condition of
    ("close the window *if it isn't already*"), has the state that the order ends in; not where a check before it may be
    what it takes up ("check if it's on, turn it off if it is")."""
    found: list[Task] = []
    for task in tasks:
        order = found[-1] if found and all(one.type != "check_state" for one in found) else None
        state = None
        if order is not None and order.type == "change_state" and _asks_whether_done(document, task, order):
            state = _end(document, order, lexicon)
        if state is not None:
            own = tuple(a for a in task.arguments if a.type not in _ANSWERED)
            task = replace(task, arguments=(*own, Argument("state", state, None, task.confidence)))
        found.append(task)
    return tuple(found)


def with_tries(document: Document, tasks: Sequence[Task], flow: Flow, lexicon: Lexicon) -> tuple[Task, ...]:
    """The tasks; a thing that is to be tried where a change failed is to be changed likewise: "turn the tv on. If that
    fails, *try the radio*"."""
    found = {task.id: task for task in tasks}
    for node, _ in flow.walk():
        if not isinstance(node, If) or found[node.task].type != "change_state":
            continue
        for other in node.orelse:
            task = found[other.task]
            named = _tried(document, task)
            state = _end(document, found[node.task], lexicon)
            if named is not None and state is not None:
                told = (Argument("state", state, None, task.confidence), replace(named, type="object"))
                found[task.id] = replace(task, type="change_state", arguments=told)
    return tuple(found[task.id] for task in tasks)


def without_outcomes(document: Document, tasks: Sequence[Task], lexicon: Lexicon) -> tuple[Task, ...]:
    """The tasks; what "one" is brought into a state is none that is in it: where there is no clean cup, "wash *one*" is
    of a cup, as is the "it" that is then brought."""
    meant: dict[str, str] = {}
    found: list[Task] = []
    for task in tasks:
        arguments = []
        for argument in task.arguments:
            said = "" if argument.span is None else argument.span.of(document.text).lower()
            value = argument.value.lower()
            if task.type == "change_state" and said in _ANY_ONE and argument.type == "object":
                state = _end(document, task, lexicon)
                words = argument.value.split()
                rest = [word for word in words if word.lower() != state]
                if rest and state is not None and state in value.split()[:-1]:
                    is_bare = said == "one" and len(rest) == 1  # of "no clean spoon"
                    meant[value] = f"{'an' if rest[0][0] in 'aeiou' else 'a'} {rest[0]}" if is_bare else " ".join(rest)
                    argument = replace(argument, value=meant[value])
            elif value in meant and (not said or said in _TAKEN_UP):
                argument = replace(argument, value=meant[value])
            arguments.append(argument)
        found.append(replace(task, arguments=tuple(arguments)))
    return tuple(found)


def _tried(document: Document, task: Task) -> Argument | None:
    """What stands right behind a "try"; None for any other verb."""
    verb = document.indices(task.span).start
    behind = (a for a in task.arguments if a.span and document.indices(a.span).start == verb + 1)
    named = next(behind, None) if document.tokens[verb].lemma == "try" else None
    is_led = named is not None and document.tokens[verb + 1].pos in ("ADP", "PART", "VERB")
    return None if is_led else named


def _end(document: Document, order: Task, lexicon: Lexicon) -> str | None:
    """The state that an order ends in, as it says or by its verb."""
    sense = sense_of(order.span.of(document.text), (), lexicon)
    return order.value("state") or (None if sense is None else sense.state)


def _asks_whether_done(document: Document, task: Task, order: Task) -> bool:
    """Whether it is a bare "if it isn't" or "unless they are" behind an order, in one sentence: the case in which that
    has not been carried out yet."""
    verb, before = document.indices(task.span).start, document.indices(order.span).start
    is_said = any(a.type in _ANSWERED and a.span is not None for a in task.arguments)
    is_near = document.sentences[verb] == document.sentences[before]
    words = {token.lower for token in document.tokens[max(before, verb - 4) : verb]}
    is_bare = task.type == "check_state" and not is_said and is_bare_being(document, verb)
    is_denied = any(token.lower in DENYING for token in document.tokens[verb + 1 : verb + 2])
    is_undone = ("if" in words and is_denied) or ("unless" in words and not is_denied)
    return is_bare and is_near and is_undone and _is_trailing(document, before, verb)


def _is_trailing(document: Document, before: int, verb: int) -> bool:
    """Whether nothing but the order and its own words stands ahead of the condition: no "and if it isn't"."""
    opening = next(i for i in range(verb, before, -1) if document.tokens[i - 1].lower in _OPENING) - 1
    return document.tokens[opening - 1].lower not in (",", "and", "but", ";")
