"""What is brought along with a thing ("my coffee with two biscuits"): both are brought."""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.instruction import Argument, Span, Task
from decomplex_bt.planning.phrases import named_by

_ALONG = re.compile(
    r"^(?P<thing>\S.*?) with (?P<along>(?:an?|some|another|two|three|four|my|his|her) .+)$", re.IGNORECASE
)


def with_served(task: Task, domain: Domain) -> Task:
    """The task of bringing with what is brought along as another thing, where both can be carried: not "the shelf with
    two drawers"."""
    if task.type != "bringing":
        return task
    return replace(task, arguments=tuple(one for argument in task.arguments for one in _apart(argument, domain)))


def _apart(argument: Argument, domain: Domain) -> tuple[Argument, ...]:
    """An object and what is brought along with it, each as an argument; any other argument as it is."""
    found = _ALONG.match(argument.value) if argument.type == "object" else None
    if found is None or not all(_is_carried(found[name], domain) for name in ("thing", "along")):
        return (argument,)
    return tuple(replace(argument, value=found[name], span=_part(argument, found, name)) for name in ("thing", "along"))


def _part(argument: Argument, found: re.Match[str], name: str) -> Span | None:
    """Where a part of an argument's words stands, which are its value; None where other words stand for it."""
    span = argument.span
    if span is None or span.end - span.start != len(argument.value):
        return None
    return Span(span.start + found.start(name), span.start + found.end(name))


def _is_carried(words: str, domain: Domain) -> bool:
    names = named_by(words, domain)
    return bool(names) and domain.house.things.keys() >= {*names}
