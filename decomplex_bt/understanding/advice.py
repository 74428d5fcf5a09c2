"""What the reader of an instruction should know besides its flow: arguments still missing, words taken lightly."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.domain.loader import Domain
from decomplex_bt.instruction import Missing, Task
from decomplex_bt.understanding.features import Observed

NO_TASK = "no task that this robot knows was found in the text"

_REPEATING = {
    "while": "while", "whilst": "while", "until": "until", "till": "until", "whenever": "whenever", "twice": "twice", "repeatedly": "repeatedly",
    "every": "every time", "times": "several times", "keep": "keep on",
}  # fmt: skip


def missing_arguments(observed: Observed, tasks: Sequence[Task], domain: Domain) -> Iterator[Missing]:
    """The required arguments that are neither said, implied, given by the verb nor by default (contracts: defaults)."""
    for task in tasks:
        task_type = domain.ontology.task_types[task.type]
        given = {argument.type for argument in task.arguments}
        if task.type == "bringing":
            given.add("recipient")
        if task.type in ("change_state", "check_state") and _says_state(observed, task):
            given.add("state")
        for group in task_type.required:
            if not given & set(group):
                yield Missing(task.id, group[0], task_type.questions[group[0]])


def warnings_of(observed: Observed, tasks: Sequence[Task]) -> Iterator[str]:
    """One line each: no task found, a prohibition that is not watched, repetition that is read as once."""
    document = observed.document
    if not tasks:
        yield NO_TASK
        return
    starts = {task.span.start for task in tasks}
    said: set[str] = set()
    for i, token in enumerate(document.tokens):
        word = _REPEATING.get(token.lower)
        if word == "every time" and not (i + 1 < len(document) and document.tokens[i + 1].lower == "time"):
            word = None
        if word is not None and word not in said and token.start not in starts:
            said.add(word)
            yield f"{word!r} is read as if once: repetition and waiting are not part of the flow"
        if _forbids(observed, i) and not any(
            document.tokens[j].start in starts for j in range(i + 1, min(i + 5, len(document)))
        ):
            yield f"{document.span(i, min(i + 3, len(document) - 1)).of(document.text)!r}: a prohibition is not watched"


def _forbids(observed: Observed, i: int) -> bool:
    """Whether a prohibition ("don't", "do not", "never" with a bare verb) starts at token `i`, at the start of a
    clause."""
    tokens = observed.document.tokens
    at_start = (
        i == 0
        or tokens[i - 1].text in (",", ".", ";", "!", "?", "-", "—")
        or tokens[i - 1].lower in ("and", "but", "please", "just", "so")
    )
    if not at_start:
        return False
    if tokens[i].lower == "never":
        return True
    return tokens[i].lower == "do" and i + 1 < len(tokens) and tokens[i + 1].lower in ("n't", "not", "nt", "n’t")


def _says_state(observed: Observed, task: Task) -> bool:
    """Whether the verb itself says the state ("open", "heat"); unknown verbs are taken to ("iron the shirt")."""
    i = observed.document.indices(task.span).start
    token = observed.document.tokens[i]
    if task.type == "check_state":
        return token.lemma not in _CHECKING
    particle = observed.gazetteer.particle(observed.document, i)
    return particle is not None or token.lemma not in _GENERIC


_CHECKING = frozenset("check see be look verify make find confirm inspect".split())
_GENERIC = frozenset("turn switch set make put change get have leave keep adjust flip".split())
