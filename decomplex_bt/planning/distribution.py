"""Distribution: one verb with several things, each with a place, a state or a person of its own, as a task for each;
and one for each of several people who get a thing each."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from decomplex_bt.flow import Do, Flow, If, Node, in_reading_order
from decomplex_bt.instruction import Argument, Instruction, Span, Task

_THINGS = frozenset(("object", "message"))
_PLACES = frozenset(("source", "location"))
_PAIRED = frozenset(("goal", "recipient", "state", "source", "location"))
_EACH_BEHIND = re.compile(r"\s+each\b(?!\s+(?:of|time)\b)", re.IGNORECASE)
_EACH_OF = re.compile(r"^(to )?(?:each of|both) ", re.IGNORECASE)
_EACH_IN = re.compile(r"^each (?=an? |one |two )| each$", re.IGNORECASE)
_AND = re.compile(r"\s*,\s*(?:and\s+)?|\s+and\s+", re.IGNORECASE)
_TOO = re.compile(r"[\s,]*\b(?:as well|too|also|likewise)\b", re.IGNORECASE)
_AWAY = re.compile(r"\s+(?:away|out|back|in|up|down)(?=\s*(?:,|;|[.!?]|$|\band\b))", re.IGNORECASE)
_ANEW = re.compile(r"(?:a|an|one|some|two|three|four|another)\s", re.IGNORECASE)


def distributed(instruction: Instruction) -> Instruction:
    """The instruction with "put the lid on the pan and the pan in the oven" as two tasks, one behind the other.

    So is "give Anna and Tom a pen each". The further tasks have the verb of the first and numbers after all others.
    What is said once ("bring *me* a pen from the desk and a cup from the shelf") holds for each. A condition is left
    whole.
    """
    conditions = {number for node, _ in instruction.flow.walk() if isinstance(node, If) for number in node.tasks}
    tasks: list[Task] = []
    instruction = replace(instruction, tasks=tuple(_with_choice(task, instruction.text) for task in instruction.tasks))
    further: dict[int, tuple[int, ...]] = {}
    number = len(instruction.tasks)
    for task in instruction.tasks:
        is_condition = task.id in conditions
        rounds = (
            (task.arguments,) if is_condition else _people(task, instruction.text) or _rounds(task, instruction.text)
        )
        tasks.append(replace(task, arguments=rounds[0]))
        for arguments in rounds[1:]:
            number += 1
            tasks.append(replace(task, id=number, arguments=arguments))
            further[task.id] = (*further.get(task.id, ()), number)
    if tuple(tasks) == instruction.tasks:
        return instruction
    ordered = tuple(sorted(tasks, key=lambda task: task.id))
    return replace(instruction, tasks=ordered, flow=Flow(in_reading_order(_with(instruction.flow.nodes, further))))


def _with_choice(task: Task, text: str) -> Task:
    """The task with "the blanket from the couch or the one on the bed" as one blanket, from the couch or the bed."""
    kept: list[Argument] = []
    is_choice = False
    for argument in task.arguments:
        if argument.span is not None and argument.type == "object":
            before = text[: argument.span.start].rstrip().lower()
            words = argument.span.of(text).lower()  # a reading has what the "one" stands for as its value
            is_choice = words in ("one", "the one") and before.endswith(" or") and bool(kept)
        same = next((a for a in kept if a.type == argument.type), None) if is_choice else None
        if same is None:
            kept.append(argument)
        elif argument.type in _PLACES:
            kept[kept.index(same)] = replace(same, value=f"{same.value} or {argument.value}")
    return replace(task, arguments=tuple(kept))


def _rounds(task: Task, text: str) -> tuple[tuple[Argument, ...], ...]:
    """The arguments for each thing, where several things have something of their own; else all in one."""
    said = sorted((a for a in task.arguments if a.span is not None), key=lambda a: a.span.start if a.span else 0)
    rounds: list[list[Argument]] = [[]]
    for argument in said:
        argument = _as_another(argument, rounds[-1], text)
        if argument.type in _THINGS | _PAIRED and any(a.type == argument.type for a in rounds[-1]):
            rounds.append([])
        rounds[-1].append(argument)
    rounds = _whole(rounds, text) if len(rounds) > 1 else rounds
    kinds = [{argument.type for argument in arguments} for arguments in rounds]
    led_away = [_is_led_away(arguments, text) for arguments in rounds]
    paired = _PAIRED.intersection(*(kind for kind, is_away in zip(kinds, led_away, strict=True) if not is_away))
    if len(rounds) < 2 or all(led_away) or not paired or not all(kind & _THINGS for kind in kinds):
        return (task.arguments,)
    silent = [argument for argument in task.arguments if argument.span is None]
    first = rounds[0]
    return tuple(
        (*arguments, *(a for a in first if a.type not in (kind | paired if is_away else kind)), *silent)
        for arguments, kind, is_away in zip(rounds, kinds, led_away, strict=True)
    )


def _is_led_away(arguments: Sequence[Argument], text: str) -> bool:
    """Whether a particle tells where a thing goes, and nothing else does: "the hose *away*"."""
    span = arguments[-1].span if arguments else None
    is_told = any(argument.type in _PAIRED for argument in arguments)
    return span is not None and not is_told and _AWAY.match(text, span.end) is not None


def _whole(rounds: list[list[Argument]], text: str) -> list[list[Argument]]:
    """The rounds with those that have no place or the like of their own taken in by the next that has one, or by the
    one before: "the shoes in the wardrobe, *the jacket as well*, and the umbrella on the table"; as they are where one
    is left over."""
    whole: list[list[Argument]] = []
    waiting: list[Argument] = []
    for arguments in rounds:
        span = arguments[-1].span
        is_complete = any(argument.type in _PAIRED for argument in arguments) or _is_led_away(arguments, text)
        if is_complete:
            whole.append([*waiting, *arguments])
            waiting = []
        elif whole and span is not None and _TOO.match(text, span.end):
            whole[-1].extend(arguments)
        else:
            waiting = [*waiting, *arguments]
    return whole if len(whole) > 1 and not waiting else rounds


def _people(task: Task, text: str) -> tuple[tuple[Argument, ...], ...]:
    """The arguments for each of several people, where each gets things of their own; else none. Of "us ... each" it is
    left open who they are: one task, for "each of us"."""
    recipient, objects = task.argument("recipient"), [a for a in task.arguments if a.type == "object"]
    if task.type != "bringing" or recipient is None or len(task.values("recipient")) > 1:
        return ()
    things = [_named(_EACH_IN.sub("", thing.value), thing, text) for thing in objects]
    is_each = any(_EACH_IN.search(a.value) or (a.span and _EACH_BEHIND.match(text, a.span.end)) for a in objects)
    is_each_of = _EACH_OF.match(recipient.value) is not None
    if not (is_each or is_each_of) or not all(_ANEW.match(one) for a in things for one in _AND.split(a.value)):
        return ()
    others = (*things, *(a for a in task.arguments if a not in (recipient, *objects)))
    names = [name for name in _AND.split(_EACH_OF.sub(r"\1", recipient.value)) if name]
    if len(names) < 2:
        value = recipient.value if is_each_of else f"each of {names[0]}"
        return ((*others, replace(recipient, value=value)),)
    return tuple((*others, _named(name, recipient, text)) for name in names)


def _named(words: str, among: Argument, text: str) -> Argument:
    """The argument with no more than these of its words, and where they stand; no span where that is not known."""
    start = -1 if among.span is None else text.find(words, among.span.start, among.span.end)
    return replace(among, value=words, span=None if start < 0 else Span(start, start + len(words)))


def _as_another(argument: Argument, before: Sequence[Argument], text: str) -> Argument:
    """ "The one" of "the pen from the desk and the one from the drawer" as the other pen, which it is."""
    first = next((a.value for a in before if a.type == argument.type), "")
    if argument.type != "object" or not first or argument.span is None or argument.span.of(text).lower() != "the one":
        return argument
    return replace(argument, value=f"the other {first.partition(' ')[2]}" if " " in first else first)


def _with(nodes: Sequence[Node], further: dict[int, tuple[int, ...]]) -> tuple[Node, ...]:
    """The nodes with the further tasks behind each of theirs."""
    found: list[Node] = []
    for node in nodes:
        if isinstance(node, If):
            found.append(If(node.tasks, _with(node.then, further), _with(node.orelse, further)))
            continue
        found.append(node)
        found += [Do((number,), node.is_repeat) for number in further.get(node.task, ())]
    return tuple(found)
