"""`lex_induct`, the rule baseline (Misra et al. 2015, as the DeComplex paper uses it in section IV-C).

Misra et al. turn an instruction into a control flow graph by rules on its parse. The paper predicts with them "the
conditional and the dependent tasks. If none of the rules apply, the lex_induct model predicts the label as sequential",
and says that they fail on out-of-order tasks and implicit dependencies. The rules themselves are not printed, so these
are ours, over spaCy's dependency parse, in that spirit and as good as they get without looking across sentences:

1. "if", "unless", "when": the verb that the word marks, or the first task after it, is conditional (not in "check if
   ...": there the clause is what is checked).
2. What follows in the same sentence is dependent, positive; negative where the condition is negated.
3. What follows "else" or "otherwise" in a sentence, with a condition before it, is dependent on the other side.
4. All else is sequential.
"""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.document import Document

MARKERS = frozenset(("if", "unless", "when"))
NEGATIONS = frozenset(("not", "n't", "n’t", "cannot", "no", "never", "unless"))
TURNS = frozenset(("else", "otherwise"))
POSITIVE, NEGATIVE = "dependent_positive", "dependent_negative"
_EMBEDDED = frozenset(("ccomp", "xcomp"))
_CLAUSE_ENDS = frozenset((",", ".", ";", ":", "?", "!"))


def lex_induct(document: Document, tasks: Sequence[int]) -> tuple[str, ...]:
    """One of the four labels for every task; `tasks` are token indices in text order."""
    conditions = _conditions(document, tasks)
    labels: list[str] = []
    side: str | None = None
    seen_condition = False
    previous = -1
    for task in tasks:
        if previous >= 0 and document.sentences[task] != document.sentences[previous]:
            side = None
        between = range(previous + 1, task)
        sentence = document.sentences[task]
        turns = [i for i in between if document.sentences[i] == sentence and document.tokens[i].lower in TURNS]
        if task in conditions:
            labels.append("conditional")
            side = NEGATIVE if _is_negated(document, conditions[task], task, tasks) else POSITIVE
            seen_condition = True
        else:
            if turns and seen_condition:
                side = POSITIVE if side == NEGATIVE else NEGATIVE
            labels.append(side or "sequential")
        previous = task
    return tuple(labels)


def _conditions(document: Document, tasks: Sequence[int]) -> dict[int, int]:
    """Conditional tasks with the marker of each."""
    found: dict[int, int] = {}
    for token in document.tokens:
        if token.lower not in MARKERS:
            continue
        marked = document.tokens[token.head]
        is_embedded = marked.dep in _EMBEDDED and marked.head in tasks and marked.head < token.i
        if is_embedded or token.i - 1 in tasks:
            continue
        following = [t for t in tasks if t > token.i and document.sentences[t] == document.sentences[token.i]]
        task = marked.i if marked.i in following else following[0] if following else None
        if task is not None:
            found.setdefault(task, token.i)
    return found


def _is_negated(document: Document, marker: int, task: int, tasks: Sequence[int]) -> bool:
    """Whether an odd number of negations stands in the condition: from its marker to a comma or the next task."""
    end = min((other for other in tasks if other > task), default=len(document))
    clause = range(marker, end)
    stop = next((i for i in range(task, end) if document.tokens[i].text in _CLAUSE_ENDS), end)
    return sum(document.tokens[i].lower in NEGATIONS for i in clause if i < stop) % 2 == 1
