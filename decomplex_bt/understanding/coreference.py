"""Coreference: what pronouns, "one", "there" and unsaid arguments stand for (DeComplex, section III-B, goes beyond it).

The paper takes the noun of a preceding task. Here a small ranking model chooses among all noun phrases of the
instruction, earlier and later ones, by their kind, number, role and distance; ours because no light library resolves
"one", "there" and ellipsis.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.understanding.crf import Crf, CrfParameters, Features, train_crf
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed

PARAMETERS = CrfParameters(c1=0.05, c2=0.2, max_iterations=80, all_transitions=False)
LIKELY = 0.5
"""An unsaid argument that is not required is filled in only above this probability."""

PLURAL_PRONOUNS = frozenset("them they 'em em these those ones both".split())
PERSON_PRONOUNS = frozenset("him her he she".split())
PLACE_PRONOUNS = frozenset(("there",))
REFERRING = frozenset("it that this one another some any".split()) | PLURAL_PRONOUNS | PERSON_PRONOUNS | PLACE_PRONOUNS
_LEADING = frozenset("the that this these those other another a an each both either of".split())
_POINTING = frozenset(
    "me us you i my mine we here something anything everything somebody someone anyone anybody everyone everybody nobody nothing none here case".split()
)
_NOT_REFERENTS = frozenset(("message", "manner", "state", "direction"))
_PERSON_NOUNS = frozenset(
    "wife husband mother father mom mum dad son daughter brother sister guest visitor neighbour neighbor colleague boss friend nurse doctor kid kids child children baby man woman guy girl boy "
    "grandma grandpa granny nan aunt uncle cousin roommate flatmate plumber cleaner electrician driver postman courier teacher student professor people everyone family partner girlfriend boyfriend".split()
)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A noun phrase something may refer to. `tokens`: where it stands; `head`: its head noun's index; `owner`: the
    number of the task whose argument it is, 0 for none; `type`: the argument's type or "outside"."""

    text: str
    tokens: range
    head: int
    owner: int = 0
    type: str = "outside"
    task_type: str = ""
    is_resolved: bool = False


@dataclass(frozen=True, slots=True)
class Gap:
    """Something to be resolved: an argument's words, or an argument that was not said (`tokens` empty at the task)."""

    task: Task
    type: str
    position: int
    word: str


class ReferenceModel:
    """The trained ranking model for referents and ellipses."""

    def __init__(self, path: Path, ontology: Ontology) -> None:
        self._crf = Crf(path)
        self._ontology = ontology

    def resolve(self, observed: Observed, tasks: Sequence[Task], flow: Flow) -> tuple[Task, ...]:
        """The tasks with every referring argument's value resolved and unsaid arguments added, in text order."""
        pool = list(candidates_of(observed, tasks))
        first_mentions = _first_mentions(flow)
        resolved: dict[int, Task] = {}
        for task in tasks:
            complete = self._resolve_said(observed, task, pool)
            first = resolved.get(first_mentions.get(task.id, 0))
            implied = [*self._from_first_mention(complete, first), *self._unsaid(observed, complete, pool, first)]
            resolved[task.id] = replace(complete, arguments=(*implied, *complete.arguments))
        return tuple(resolved.values())

    def _resolve_said(self, observed: Observed, task: Task, pool: list[Candidate]) -> Task:
        arguments: list[Argument] = []
        for argument in task.arguments:
            gap = gap_of(observed.document, task, argument)
            if gap is None:
                arguments.append(argument)
                continue
            best, probability = self._best(observed, gap, pool)
            if best is None:
                arguments.append(argument)
                continue
            value = _combined(observed.document, argument, best)
            arguments.append(replace(argument, value=value, confidence=argument.confidence * probability))
            pool.append(_as_candidate(observed.document, task, argument, best, value))
        return replace(task, arguments=tuple(arguments))

    def _from_first_mention(self, task: Task, first: Task | None) -> Iterator[Argument]:
        """What a later mention of a condition leaves out, it has from the first ("check if the tap is on; if it is")."""
        if first is None or task.type != "check_state":
            return
        said = {argument.type for argument in task.arguments}
        if "object" not in said and first.value("object") is not None:
            yield Argument("object", first.value("object") or "", None, first.confidence)
        if not said & {"state", "location"}:
            for kind in ("state", "location"):
                value = first.value(kind)
                if value is not None:
                    yield Argument(
                        kind, _without_preposition(value) if kind == "location" else value, None, first.confidence
                    )

    def _unsaid(
        self, observed: Observed, task: Task, pool: Sequence[Candidate], first: Task | None
    ) -> Iterator[Argument]:
        for kind, is_required in unsaid_arguments(task, self._ontology):
            if first is not None and task.type == "check_state":
                continue
            gap = Gap(task, kind, _place(observed.document, task), "")
            best, probability = self._best(observed, gap, pool)
            if best is not None and (is_required or probability > LIKELY):
                yield Argument(kind, best.text, None, probability)

    def _best(self, observed: Observed, gap: Gap, pool: Sequence[Candidate]) -> tuple[Candidate | None, float]:
        best, highest = None, 0.0
        for candidate, features in ranked_features(observed, gap, pool):
            self._crf.label([features])
            probability = self._crf.marginal("yes", 0)
            if probability > highest:
                best, highest = candidate, probability
        return best, highest


def train_references(path: Path, data: Sequence[tuple[Observed, Instruction]], ontology: Ontology) -> None:
    """Trains the ranking model on annotated instructions and writes it to `path`."""
    items: list[list[Features]] = []
    labels: list[list[str]] = []
    for observed, instruction in data:
        pool = list(candidates_of(observed, instruction.tasks))
        for task in instruction.tasks:
            for gap, argument in _gold_gaps(observed.document, task, ontology):
                value = argument.value if argument else None
                for candidate, features in ranked_features(observed, gap, pool):
                    items.append([features])
                    labels.append(["yes" if value is not None and _is_same(candidate.text, value) else "no"])
                if argument is not None and argument.span is not None:
                    target = next((c for c in pool if value and _is_same(c.text, value)), None)
                    if target is not None:
                        pool.append(_as_candidate(observed.document, task, argument, target, target.text))
    train_crf(path, items, labels, PARAMETERS)


def candidates_of(observed: Observed, tasks: Sequence[Task]) -> Iterator[Candidate]:
    """All noun phrases of the instruction that something may refer to, from left to right; pronouns are none.

    A phrase counts whole, without what follows its head ("the mug" of "the mug next to the keyboard"), and by whose it is
    ("Ruby" of "Ruby's bag").
    """
    document = observed.document
    found: dict[tuple[int, int], Candidate] = {}
    for task in tasks:
        for argument in task.arguments:
            if argument.span is None or argument.type in _NOT_REFERENTS:
                continue
            inner = _stripped(document, document.indices(argument.span))
            if not inner or _is_referring(document, inner) or _is_pointing(document, inner):
                continue
            candidate = _candidate(document, inner, task, argument.type)
            found.setdefault((inner.start, inner.stop), candidate)
            short = range(inner.start, candidate.head + 1)
            if len(short) < len(inner):
                found.setdefault((short.start, short.stop), _candidate(document, short, task, argument.type))
    taken = {i for start, stop in found for i in range(start, stop)}
    chunks = list(noun_chunks(document))
    for chunk in (*chunks, *_coordinations(document, chunks)):
        if not taken & set(chunk):
            found[chunk.start, chunk.stop] = _outside(document, chunk)
    for name in (*_names(document), *_possessors(document, chunks)):
        found.setdefault((name.start, name.stop), _outside(document, name))
    yield from (found[place] for place in sorted(found))


def _outside(document: Document, tokens: range) -> Candidate:
    return Candidate(document.span(tokens.start, tokens.stop - 1).of(document.text), tokens, tokens.stop - 1)


def _names(document: Document) -> Iterator[range]:
    """Runs of proper nouns, titles included."""
    start: int | None = None
    for i, token in enumerate((*document.tokens, None)):
        is_name = token is not None and token.pos == "PROPN" and token.text[:1].isupper()
        if is_name and start is None:
            start = i
        elif not is_name and start is not None:
            yield range(start, i)
            start = None


def _possessors(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Whose something is: what stands before "'s" in a noun phrase ("mrs okafor" in "mrs okafor's hearing aid")."""
    for chunk in chunks:
        for i in chunk:
            if document.tokens[i].tag == "POS" and i > chunk.start:
                yield range(chunk.start, i)
                break


def _coordinations(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Noun phrases in a row with nothing but commas and "and" between them ("the mop, the bucket and the cloth")."""
    start = 0
    for k in range(1, len(chunks) + 1):
        if k < len(chunks) and _is_listed(document, range(chunks[k - 1].stop, chunks[k].start)):
            continue
        if k - start > 1:
            yield range(chunks[start].start, chunks[k - 1].stop)
        start = k


def _is_listed(document: Document, between: range) -> bool:
    words = [document.tokens[i].lower for i in between]
    return bool(words) and all(word in (",", "and", "or", "&") for word in words)


def _is_pointing(document: Document, tokens: range) -> bool:
    return len(tokens) == 1 and document.tokens[tokens.start].lower in _POINTING


def noun_chunks(document: Document) -> Iterator[range]:
    """Base noun phrases by tags: determiners, possessives and modifiers up to the last noun of a run."""
    start: int | None = None
    for i, token in enumerate((*document.tokens, None)):
        if token is not None and (token.pos in ("DET", "ADJ", "NOUN", "PROPN", "NUM") or token.tag in ("PRP$", "POS")):
            if token.pos == "DET" and start is not None:
                yield from _trimmed(document, range(start, i))
                start = i
            start = i if start is None else start
            continue
        if start is not None:
            yield from _trimmed(document, range(start, i))
        start = None


def _trimmed(document: Document, chunk: range) -> Iterator[range]:
    nouns = [i for i in chunk if document.tokens[i].pos in ("NOUN", "PROPN")]
    if nouns:
        yield range(chunk.start, nouns[-1] + 1)


def gap_of(document: Document, task: Task, argument: Argument) -> Gap | None:
    """The gap that an argument's words leave to be resolved, or None where they name what they mean."""
    if argument.span is None or argument.type in _NOT_REFERENTS:
        return None
    inner = _stripped(document, document.indices(argument.span))
    if not inner or not _is_referring(document, inner):
        return None
    return Gap(task, argument.type, inner.start, document.tokens[_head(document, inner)].lower)


def unsaid_arguments(task: Task, ontology: Ontology) -> Iterator[tuple[str, bool]]:
    """The arguments that a task may have by ellipsis, each with whether it is required."""
    said = {argument.type for argument in task.arguments}
    if task.type == "searching" and "object" not in said:
        yield "object", "location" not in said
        return
    if task.type in ("motion", "informing"):
        return
    for group in ontology.task_types[task.type].required:
        if group[0] in ("object", "goal") and not said & set(group):
            yield group[0], group[0] == "object"


def ranked_features(observed: Observed, gap: Gap, pool: Sequence[Candidate]) -> Iterator[tuple[Candidate, Features]]:
    """Every candidate with its features for a gap; candidates of the gap's own words are left out."""
    pool = _plausible(observed, gap, pool)
    earlier = [c for c in pool if c.tokens.stop <= gap.position]
    later = [c for c in pool if c.tokens.start > gap.position]
    earlier.sort(key=lambda candidate: -candidate.tokens.stop)
    for direction, candidates in (("before", earlier), ("after", later)):
        of_kind: dict[str, int] = {}
        for rank, candidate in enumerate(candidates):
            kind = _kind(observed, candidate)
            of_kind[kind] = of_kind.get(kind, 0) + 1
            yield candidate, _features(observed, gap, candidate, f"{direction}{min(rank, 4)}", kind, of_kind[kind])


def _plausible(observed: Observed, gap: Gap, pool: Sequence[Candidate]) -> Sequence[Candidate]:
    """Persons alone for "him" and "her", no persons for "it" and "there", where that leaves any candidate."""
    if gap.word in PERSON_PRONOUNS:
        kept = [c for c in pool if _kind(observed, c) in ("person", "name")]
    elif gap.word in ("it", "there"):
        kept = [c for c in pool if _kind(observed, c) != "person"]
    else:
        return pool
    return kept or pool


def _features(observed: Observed, gap: Gap, candidate: Candidate, rank: str, kind: str, kind_rank: int) -> Features:
    document = observed.document
    word = gap.word or f"unsaid.{gap.type}"
    is_same_task = candidate.owner == gap.task.id
    sentences = document.sentences[gap.position] - document.sentences[candidate.head]
    role = document.tokens[candidate.head].dep
    number = "plural" if document.tokens[candidate.head].tag in ("NNS", "NNPS") else "singular"
    first = document.tokens[candidate.tokens.start].lower
    determiner = (
        "indefinite"
        if first in ("a", "an", "some", "any")
        else "definite"
        if first in ("the", "my", "your", "his", "her")
        else "bare"
    )
    return {
        "bias": 1.0,
        "rank": rank,
        "word.rank": f"{word}.{rank}",
        "word.kind": f"{word}.{kind}",
        "word.kind.rank": f"{word}.{kind}.{min(kind_rank, 3)}.{rank.rstrip('01234')}",
        "word.number": f"{word}.{number}",
        "word.type": f"{word}.{candidate.type}",
        "types": f"{gap.type}.{candidate.type}",
        "gap.kind": f"{gap.type}.{kind}",
        "task.kind": f"{gap.task.type}.{gap.type}.{kind}",
        "tasks": f"{gap.task.type}.{gap.type}.{candidate.task_type}.{candidate.type}",
        "same_task": is_same_task,
        "same_task.type": f"{is_same_task}.{candidate.type}",
        "owner.gap": str(max(-2, min(3, gap.task.id - candidate.owner))) if candidate.owner else "none",
        "sentences": max(-1, min(3, sentences)),
        "word.sentences": f"{word}.{max(-1, min(3, sentences))}",
        "role": role,
        "word.role": f"{word}.{role}",
        "determiner": f"{word}.{determiner}",
        "resolved": candidate.is_resolved,
        "word.resolved": f"{word}.{candidate.is_resolved}.{rank}",
        "object.rank": f"{gap.type == candidate.type}.{rank}",
    }


def _kind(observed: Observed, candidate: Candidate) -> str:
    """person, place, thing or "" where the words do not tell."""
    token = observed.document.tokens[candidate.head]
    category = observed.gazetteer.category(token.lemma)
    if category == "person" or token.lemma in _PERSON_NOUNS or candidate.type == "recipient":
        return "person"
    if candidate.task_type == "following" and candidate.type == "object":
        return "person"
    if token.tag in ("NNP", "NNPS") and candidate.type in ("object", "outside") and category == "":
        return "name"
    if candidate.type in ("goal", "location", "source", "path"):
        return "place"
    if category in ("room", "floor"):
        return "place"
    return category or "thing"


def _candidate(document: Document, tokens: range, task: Task, argument_type: str) -> Candidate:
    text = document.span(tokens.start, tokens.stop - 1).of(document.text)
    return Candidate(text, tokens, _head(document, tokens), task.id, argument_type, task.type)


def _as_candidate(document: Document, task: Task, argument: Argument, target: Candidate, value: str) -> Candidate:
    """A resolved mention, which later words may refer to in turn: it keeps its target's head and text."""
    assert argument.span is not None
    tokens = document.indices(argument.span)
    return replace(
        target, text=value, tokens=tokens, owner=task.id, type=argument.type, task_type=task.type, is_resolved=True
    )


def _stripped(document: Document, tokens: range) -> range:
    """The span without leading prepositions and particles ("in the drawer": "the drawer")."""
    start = tokens.start
    while start < tokens.stop - 1 and (
        document.tokens[start].pos in ("ADP", "PART", "SCONJ", "ADV") or document.tokens[start].lower in _PREPOSITIONS
    ):
        if document.tokens[start].lower in REFERRING:
            break
        start += 1
    return range(start, tokens.stop)


_PREPOSITIONS = frozenset(
    "in on at to from into onto inside under underneath behind beside near by with off out of for over next up down through along across around between after towards toward above below upon w".split()
)


def _without_preposition(value: str) -> str:
    words = value.split()
    while len(words) > 1 and words[0].lower() in _PREPOSITIONS:
        words = words[1:]
    return " ".join(words)


def _head(document: Document, tokens: range) -> int:
    """The head of a phrase: its last noun before a preposition or clause, else its last token."""
    head = None
    for i in tokens:
        token = document.tokens[i]
        if token.pos in ("NOUN", "PROPN", "PRON") or token.lower in REFERRING - {
            "that",
            "this",
            "these",
            "those",
            "some",
            "any",
            "both",
            "another",
        }:
            head = i
        elif token.pos in ("ADP", "VERB", "AUX", "SCONJ") and head is not None:
            break
    return tokens.stop - 1 if head is None else head


def _is_referring(document: Document, tokens: range) -> bool:
    words = [document.tokens[i].lower for i in tokens]
    if any(word in _POINTING for word in words) and len(words) == 1:
        return False
    head = document.tokens[_head(document, tokens)].lower
    if len(words) == 1:
        return words[0] in REFERRING
    if head in ("one", "ones"):
        return True
    return all(word in _LEADING | REFERRING for word in words)


def _combined(document: Document, argument: Argument, best: Candidate) -> str:
    """The referent's words; with "a clean one" the modifiers stay and only the noun is filled in."""
    assert argument.span is not None
    inner = _stripped(document, document.indices(argument.span))
    head = document.tokens[_head(document, inner)]
    modifiers = [document.tokens[i].text for i in inner if i < head.i]
    if head.lower in ("one", "ones") and any(word.lower() not in _LEADING for word in modifiers):
        return " ".join([*modifiers, _noun(document, best, is_plural=head.lower == "ones")])
    if (
        head.lower in ("one", "other")
        and modifiers
        and modifiers[0].lower() in ("the", "another")
        and ("other" in (m.lower() for m in modifiers) or head.lower == "other")
    ):
        return f"the other {_noun(document, best, is_plural=False)}"
    return best.text


def _noun(document: Document, candidate: Candidate, *, is_plural: bool) -> str:
    """The head noun of a candidate with its compound ("baking tray"), in the singular unless `is_plural`."""
    head = document.tokens[candidate.head]
    compound = [
        document.tokens[i].text
        for i in range(candidate.tokens.start, candidate.head)
        if document.tokens[i].dep == "compound" and document.tokens[i].head == candidate.head
    ]
    return " ".join([*compound, head.text if is_plural or head.tag not in ("NNS", "NNPS") else head.lemma])


def _first_mentions(flow: Flow) -> dict[int, int]:
    return {number: node.task for node, _ in flow.walk() if isinstance(node, If) for number in node.tasks[1:]}


def _place(document: Document, task: Task) -> int:
    return document.indices(task.span).start


def _gold_gaps(document: Document, task: Task, ontology: Ontology) -> Iterator[tuple[Gap, Argument | None]]:
    for argument in task.arguments:
        gap = gap_of(document, task, argument)
        if gap is not None:
            yield gap, argument
    said = replace(task, arguments=tuple(a for a in task.arguments if a.span is not None))
    implied: Mapping[str, Argument] = {a.type: a for a in task.arguments if a.span is None}
    for kind, _ in unsaid_arguments(said, ontology):
        yield Gap(said, kind, _place(document, task), ""), implied.get(kind)


def _is_same(text: str, value: str) -> bool:
    return text.lower() == value.lower()
