"""Tasks as English settles them: `corrected` applies what the modules beside it and the folders know."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import zip_longest

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.additions import with_further
from decomplex_bt.understanding.rules.findings import Findings
from decomplex_bt.understanding.rules.non_tasks import is_no_task
from decomplex_bt.understanding.rules.single_checks import as_one, at_statements
from decomplex_bt.understanding.rules.types import retyped
from decomplex_bt.understanding.tasks import FoundTask

_IS_OR_HAS = frozenset(("'s",))


def corrected(observed: Observed, tasks: Sequence[FoundTask], types: Collection[str]) -> tuple[FoundTask, ...]:
    """The tasks, in text order, brought in line with the facts; `types`: those that there are."""
    document = observed.document
    findings = Findings.of(observed, {task.token: task.type for task in tasks})
    whole = [
        task
        for task in as_one(document, at_statements(document, tasks))
        if not _is_genitive(document, findings.looks.values(), task.token)
    ]
    found: list[FoundTask] = []
    for task, following in zip_longest(whole, whole[1:]):
        told = retyped(observed, findings, task, found, following, types)
        if not is_no_task(observed, findings, found[-1] if found else None, told, following):
            found.append(told)
    return with_further(observed, found, types)


def _is_genitive(document: Document, looked: Collection[range], at: int) -> bool:
    """Whether a "'s" is none of a check: "have a butcher's"."""
    return document.tokens[at].lower in _IS_OR_HAS and any(at in words for words in looked)
