"""Others: which of what a phrase names are not meant, since the instruction has named or given them away before.

"The other mug", "another pen" and "one more" are none of those named before; "a pen" and "one" are none that an earlier
task has given to somebody.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.flow import Flow, If, Node
from decomplex_bt.planning.ground_task import Referent
from decomplex_bt.planning.noun_phrase import NounPhrase
from decomplex_bt.planning.phrases import read_phrases

_MOST_MODIFIERS = 3


@dataclass(frozen=True, slots=True)
class Before:
    """The tasks that are done before one becomes due: `surely`, or `maybe`, by how conditions come out."""

    surely: frozenset[int] = frozenset()
    maybe: frozenset[int] = frozenset()


class Others:
    """What the tasks of a text have named so far, task by task in the order of the text."""

    def __init__(self, text: str, flow: Flow, domain: Domain) -> None:
        self._text, self._domain = text, domain
        self._before = dict(_walk(flow.nodes, Before()))
        self._task = 0
        self._named: list[tuple[int, Referent]] = []
        self._given: list[tuple[int, Referent]] = []

    def begin(self, task: int) -> None:
        """The phrases from here on are those of this task."""
        self._task = task

    def name(self, referent: Referent) -> None:
        self._named.append((self._task, referent))

    def give(self, referents: Sequence[Referent]) -> None:
        """The task gives these to somebody."""
        self._given.extend((self._task, referent) for referent in referents)

    def are_excluded(self, phrase: NounPhrase, names: tuple[str, ...]) -> bool:
        """Whether a phrase for these names may not mean all that the same words meant before."""
        return bool(self._excluded(phrase, names))

    def than(self, phrase: NounPhrase, names: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[Referent, ...]]:
        """Of the names those that a phrase may mean, and the referents none of which it means.

        Raises `ImpossibleGoalError` where the house has too few.
        """
        excluded = self._excluded(phrase, names)
        settled = {r.candidates[0] for _, r in excluded if len(r.candidates) == 1}
        if phrase.is_other and not excluded and phrase.start is not None:
            settled = self._contrasted(phrase, names, phrase.start)
        left = tuple(name for name in names if name not in settled)
        open_ones = {r: task for task, r in excluded if len(r.candidates) > 1 and set(r.candidates) <= set(names)}
        surely = self._before.get(self._task, Before()).surely
        taken = sum(r.count for r, task in open_ones.items() if task in surely and not settled & {*r.candidates})
        if len(left) < taken + phrase.count:
            raise too_few(phrase.text, names, are_named=bool(taken or settled))
        return left, tuple(dict.fromkeys(r for _, r in excluded if len(r.candidates) > 1))

    def _excluded(self, phrase: NounPhrase, names: tuple[str, ...]) -> list[tuple[int, Referent]]:
        if phrase.is_other:
            found = self._named
        elif phrase.is_anew:
            maybe = self._before.get(self._task, Before()).maybe
            found = [(task, referent) for task, referent in self._given if task in maybe]
        else:
            return []
        return [(t, r) for t, r in found if not r.is_all and set(r.candidates) & set(names)]

    def _contrasted(self, phrase: NounPhrase, names: tuple[str, ...], start: int) -> set[str]:
        """What the text before has named outside of all tasks ("not the white cup, the other one")."""
        found: set[str] = set()
        pattern = rf"((?:[\w'-]+\s+){{1,{_MOST_MODIFIERS}}})(?:{re.escape(phrase.noun)}|one)\b"
        for match in re.finditer(pattern, self._text[:start].lower()):
            words = match[1].split()
            for i in range(len(words)):
                try:
                    said = read_phrases(" ".join([*words[i:], phrase.noun]), self._domain)
                except (UnknownWordError, ImpossibleGoalError):
                    continue
                meant = {name for part in said for name in part.entities if name in names}
                found |= meant if len(meant) < len(names) else set()
                break
        return found


def too_few(words: str, names: tuple[str, ...], *, are_named: bool = True) -> ImpossibleGoalError:
    """The error for more than there are; `are_named`: than there are besides those that were named before."""
    there, those = ("is only one", "it") if len(names) == 1 else (f"are only {len(names)}", "all of them")
    why = f", and the instruction has named {those} before" if are_named else "; ask for fewer"
    return ImpossibleGoalError(f"{words!r}: there {there} in this house{why}")


def _walk(nodes: Sequence[Node], before: Before) -> Iterator[tuple[int, Before]]:
    """Every task with those done before it; a condition is done before its `then`, and has failed before its `else`."""
    for node in nodes:
        yield node.task, before
        done = frozenset((node.task,))
        if isinstance(node, If):
            yield from _walk(node.then, Before(before.surely | done, before.maybe | done))
            yield from _walk(node.orelse, before)
            within = {inner.task for inner, _ in Flow((node,)).walk()}
            before = Before(before.surely, before.maybe | within)
        else:
            before = Before(before.surely | done, before.maybe | done)


def without_others(
    referent: Referent, names: tuple[str, ...], bindings: Mapping[Referent, tuple[str, ...]]
) -> tuple[str, ...]:
    """The names without what those referents have turned out to mean that a referent is other than."""
    taken = {name for other in referent.others for name in bindings.get(other, ())}
    return tuple(name for name in names if name not in taken)
