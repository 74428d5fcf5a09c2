"""What is brought along with a thing ("my coffee with two biscuits"): both are brought."""

from __future__ import annotations

import re
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import InputError
from decomplex_bt.instruction import Task
from decomplex_bt.planning.phrases import read_phrases

_ALONG = re.compile(
    r"^(?P<thing>\S.*?) with (?P<along>(?:an?|some|another|two|three|four|my|his|her) .+)$", re.IGNORECASE
)


def with_served(task: Task, domain: Domain) -> Task:
    """The task of bringing with what is brought along as another thing, where both can be carried: not "the shelf with
    two drawers"."""
    if task.type != "bringing":
        return task
    return replace(
        task,
        arguments=tuple(
            replace(a, value=f"{found['thing']} along with {found['along']}")
            if a.type == "object"
            and (found := _ALONG.match(a.value)) is not None
            and all(_is_carried(words, domain) for words in (found["thing"], found["along"]))
            else a
            for a in task.arguments
        ),
    )


def _is_carried(words: str, domain: Domain) -> bool:
    try:
        phrases = read_phrases(words, domain)
    except InputError:
        return False
    names = {name for phrase in phrases for name in (*phrase.entities, *phrase.plurals)}
    return bool(names) and names <= domain.house.things.keys()
