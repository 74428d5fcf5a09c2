"""The context of references: what is known of an instruction's phrases, mentions and flow while its gaps are filled."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from decomplex_bt.flow import Flow, FlowPath, If
from decomplex_bt.instruction import Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import is_child
from decomplex_bt.understanding.references.gaps import PREDICATE, Gap
from decomplex_bt.understanding.references.identity import identities
from decomplex_bt.understanding.references.looks import looks, shouts
from decomplex_bt.understanding.references.phrases import Candidate, candidates_of, predicates_of
from decomplex_bt.understanding.references.subjects import Subject, subjects
from decomplex_bt.understanding.references.told import told_things
from decomplex_bt.understanding.vocabulary import ONES, PERSON_NOUNS, PETS

GROUPS = {
    "him": "he", "he": "he", "his": "he", "her": "she", "she": "she", "hers": "she", "it": "it", "them": "they",
    "they": "they", "'em": "they", "em": "they", "those": "they", "these": "they", "there": "there",
}  # fmt: skip
"""Pronouns to the one that stands for all of their kind."""
ANIMATE = frozenset(("person", "animal", "name"))
"""The kinds of who is, or may be, somebody; see `kind_of`."""


@dataclass
class Context:
    """What is known while an instruction's gaps are filled from left to right: phrases, mentions and the flow."""

    observed: Observed
    tasks: Sequence[Task]
    flow: Flow
    pool: list[Candidate] = field(init=False)
    mentions: dict[str, list[str]] = field(init=False, default_factory=dict)
    fillings: dict[int, set[str]] = field(init=False, default_factory=dict)
    paths: Mapping[int, FlowPath] = field(init=False)
    first: dict[int, int] = field(init=False, default_factory=dict)
    lemmas: dict[int, str] = field(init=False)
    topic: str = field(init=False)
    types: dict[int, str] = field(init=False)
    by_number: dict[int, Task] = field(init=False)

    def __post_init__(self) -> None:
        document = self.observed.document
        told_by = {i for look in (*looks(document), *shouts(document)) for i in look.words}
        self.pool = [c for c in candidates_of(self.observed, self.tasks) if c.tokens.start not in told_by]
        self.pool += _identified(document, self.pool)
        self.pool += told_things(self.observed, self.tasks, self.pool)
        for candidate in self.pool:
            if candidate.owner:
                self.fillings.setdefault(candidate.owner, set()).add(candidate.text.lower())
        self.paths = paths_of(self.flow)
        for node, _ in self.flow.walk():
            if isinstance(node, If):
                self.first.update(dict.fromkeys(node.tasks, node.task))
        self.topic = next((c.text.lower() for c in self.pool if c.type == "object"), "")
        self.lemmas = {task.id: self._lemma(task) for task in self.tasks}
        self.types = {task.id: task.type for task in self.tasks}
        self.by_number = {task.id: task for task in self.tasks}

    @cached_property
    def verbs(self) -> frozenset[int]:
        """The tokens of the tasks, which name nothing whatever the tagger takes them for ("*Lay* the table")."""
        return frozenset(self.observed.document.indices(task.span).start for task in self.tasks)

    @cached_property
    def subjects(self) -> tuple[Subject, ...]:
        return tuple(subjects(self.observed.document))

    @cached_property
    def predicates(self) -> list[Candidate]:
        return predicates_of(self.observed, self.tasks)

    def arguments(self, number: int, kind: str) -> list[Candidate]:
        """What is known of a task's arguments of a type: phrases in text order, then what its gaps are filled with."""
        return [c for c in self.pool if (c.owner, c.type) == (number, kind)]

    def _lemma(self, task: Task) -> str:
        document = self.observed.document
        i = document.indices(task.span).start
        particle = self.observed.gazetteer.particle(document, i)
        return f"{document.tokens[i].lemma} {particle}" if particle else document.tokens[i].lemma

    def mention(self, gap: Gap, candidate: Candidate, text: str) -> None:
        """Takes down that a gap is filled: later words may refer to the mention of the candidate in turn."""
        self.fillings.setdefault(gap.task.id, set()).add(text.lower())
        if gap.type == PREDICATE:
            return
        self.mentions.setdefault(text.lower(), []).append(GROUPS.get(gap.word, gap.word))
        tokens = gap.tokens or range(gap.position, gap.position + 1)
        if gap.form == "kind":  # else "it" might be "white", and not white wine
            self.pool = [c for c in self.pool if c.tokens != tokens]
        self.pool.append(
            replace(
                candidate,
                text=text,
                tokens=tokens,
                owner=gap.task.id,
                type=gap.type,
                task_type=gap.task.type,
                mention=gap.word or "unsaid",
            )
        )

    def relation(self, owner: int, number: int) -> str:
        """How a task lies to another in the flow: in the same branch, in the other one, its condition, ..."""
        if owner == number:
            return "self"
        if not owner:
            return "outside"
        path, other = self.paths.get(number, ()), self.paths.get(owner, ())
        head, far = self.first.get(number), self.first.get(owner)
        if far is not None and far == head:
            return "mention" if owner != head else "first"
        for depth, (condition, side) in enumerate(reversed(path)):
            if condition == far:
                return f"condition.{side}.{min(depth, 1)}"
        if head is not None and any(condition == head for condition, _ in other):
            return "governed"
        sides = dict(path)
        if any(sides.get(condition, side) != side for condition, side in other):
            return "exclusive"
        if path == other:
            return "same"
        return "inner" if len(other) > len(path) else "outer"


def _identified(document: Document, known: Sequence[Candidate]) -> Iterator[Candidate]:
    """What conditions say something is, where the tagger takes it for no noun: "if it's *the oven* turn it off"."""
    places = {candidate.tokens for candidate in known}
    for identity in identities(document):
        if identity.name not in places and document.tokens[identity.name[-1]].lower not in ONES:
            text = document.span(identity.name.start, identity.name.stop - 1).of(document.text)
            yield Candidate(text, identity.name, identity.name.stop - 1)


def paths_of(flow: Flow) -> Mapping[int, FlowPath]:
    """By the number of a task the conditions under which it stands, each with its side, outermost first."""
    paths: dict[int, FlowPath] = {}
    for node, path in flow.paths():
        for number in node.tasks:
            paths.setdefault(number, path)
    return paths


def kind_of(context: Context, candidate: Candidate) -> str:
    """person, animal, name, place, or the category of thing that the words tell."""
    token = context.observed.document.tokens[candidate.head]
    category = context.observed.gazetteer.category(token.lemma)
    if category == "person" or token.lemma in PERSON_NOUNS or is_child(context.observed.document, candidate.tokens):
        return "person"
    if token.lemma in PETS:
        return "animal"
    is_person = candidate.type == "recipient" or (candidate.task_type == "following" and candidate.type == "object")
    if is_person and (candidate.shape in ("whole", "short", "long") or candidate.mention):
        return "person"
    if candidate.mention in ("him", "he", "she", "her"):
        return "person"
    if token.tag in ("NNP", "NNPS") and category == "" and token.text[:1].isupper():
        return "name"
    if candidate.type in ("goal", "location", "source", "path"):
        return f"place.{category}"
    return category or "thing"
