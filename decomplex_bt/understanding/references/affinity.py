"""How well a phrase fills a gap: the options that are not ruled out, each with the features that a model weighs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

from decomplex_bt.flow import Flow, If, Node
from decomplex_bt.instruction import Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.gaps import PREDICATE, Gap, says_there_is, spellings
from decomplex_bt.understanding.references.phrases import (
    ANYBODY,
    PERSON_NOUNS,
    Candidate,
    candidates_of,
    degree_asked,
    nobody,
    predicates_of,
)
from decomplex_bt.understanding.references.relatives import free_relatives

_ANIMALS = frozenset("dog cat puppy kitten hamster parrot rabbit pup bird hen horse pony".split())
_GROUPS = {
    "him": "he", "he": "he", "his": "he", "her": "she", "she": "she", "hers": "she", "it": "it", "them": "they",
    "they": "they", "'em": "they", "em": "they", "those": "they", "these": "they", "there": "there",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Option:
    """One way to fill a gap, `candidate` None for leaving it. `type`: that of the argument it makes; `shared`: the
    features of the candidate, one and the same tuple for all its spellings; `own`: those of this spelling."""

    candidate: Candidate | None
    type: str
    text: str
    shared: tuple[str, ...]
    own: tuple[str, ...] = ()

    @property
    def features(self) -> tuple[str, ...]:
        return (*self.shared, *self.own)

    @property
    def key(self) -> tuple[str, str]:
        return self.type, self.text.lower()


@dataclass
class Context:
    """What is known while an instruction's gaps are filled from left to right: phrases, mentions and the flow."""

    observed: Observed
    tasks: Sequence[Task]
    flow: Flow
    pool: list[Candidate] = field(init=False)
    mentions: dict[str, list[str]] = field(init=False, default_factory=dict)
    fillings: dict[int, set[str]] = field(init=False, default_factory=dict)
    paths: dict[int, tuple[tuple[int, str], ...]] = field(init=False, default_factory=dict)
    first: dict[int, int] = field(init=False, default_factory=dict)
    lemmas: dict[int, str] = field(init=False)
    topic: str = field(init=False)
    types: dict[int, str] = field(init=False)

    def __post_init__(self) -> None:
        self.pool = candidates_of(self.observed, self.tasks)
        for candidate in self.pool:
            if candidate.owner:
                self.fillings.setdefault(candidate.owner, set()).add(candidate.text.lower())
        for node, path in _walk(self.flow.nodes, ()):
            for number in node.tasks:
                self.paths.setdefault(number, path)
                if isinstance(node, If):
                    self.first[number] = node.task
        self.topic = next((c.text.lower() for c in self.pool if c.type == "object"), "")
        self.lemmas = {task.id: self._lemma(task) for task in self.tasks}
        self.types = {task.id: task.type for task in self.tasks}

    @cached_property
    def predicates(self) -> list[Candidate]:
        return predicates_of(self.observed, self.tasks)

    def _lemma(self, task: Task) -> str:
        document = self.observed.document
        i = document.indices(task.span).start
        particle = self.observed.gazetteer.particle(document, i)
        return f"{document.tokens[i].lemma} {particle}" if particle else document.tokens[i].lemma

    def mention(self, gap: Gap, option: Option) -> None:
        """Takes down that a gap is filled: later words may refer to the mention in turn."""
        if option.candidate is None:
            return
        text = option.text.lower()
        self.fillings.setdefault(gap.task.id, set()).add(text)
        if gap.type == PREDICATE:
            return
        self.mentions.setdefault(text, []).append(_GROUPS.get(gap.word, gap.word))
        tokens = gap.tokens or range(gap.position, gap.position + 1)
        self.pool.append(
            replace(
                option.candidate,
                text=option.text,
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


def _walk(
    nodes: Sequence[Node], path: tuple[tuple[int, str], ...]
) -> Iterator[tuple[Node, tuple[tuple[int, str], ...]]]:
    for node in nodes:
        yield node, path
        if isinstance(node, If):
            yield from _walk(node.then, (*path, (node.task, "then")))
            yield from _walk(node.orelse, (*path, (node.task, "else")))


def options_of(context: Context, gap: Gap) -> list[Option]:
    """All ways to fill a gap, leaving it last."""
    if gap.type == PREDICATE:
        return [*_predicates(context, gap), Option(None, "", "", tuple(_none_features(context, gap)))]
    options: list[Option] = []
    document = context.observed.document
    own = _modifier(context.observed, gap.tokens)
    # "that one" always is one that was named
    is_pointed = {document.tokens[i].lower for i in gap.tokens} == {"that", "one"}
    of_side: dict[str, list[Candidate]] = {"before": [], "after": []}
    identity = _identity(context, gap) or _fronted(context, gap)
    is_of_nobody = gap.type == "object" and not gap.word and bool(nobody(document, gap.position))
    containers = _containers(context, gap)
    before, instrument = _done_before(context, gap), _instrument(context, gap)
    for candidate in context.pool:
        if containers and candidate not in containers:
            continue
        if is_pointed and (candidate.owner == gap.task.id or candidate.tokens.start > gap.position):
            continue
        if _is_ruled_out(context, gap, candidate) or (identity and candidate.tokens != identity):
            continue
        if is_of_nobody and not _is_somebody(context, gap, candidate):
            continue
        if before and (candidate.owner, candidate.type) != (before, "object"):
            continue
        # "mop it up" is not of the floor, but of what is on it
        is_wiped_up = bool(instrument) and context.lemmas[gap.task.id].endswith(" up")
        if candidate.owner == instrument > 0 or (is_wiped_up and candidate.type in ("location", "source")):
            continue
        if candidate.tokens.stop <= gap.position:
            of_side["before"].append(candidate)
        elif candidate.tokens.start > max(gap.position, gap.tokens.stop - 1):
            of_side["after"].append(candidate)
    if gap.word in _TOGETHER:
        of_side["before"].extend(_together(document, of_side["before"]))
    of_side["before"].sort(key=lambda candidate: -candidate.tokens.stop)
    for side, candidates in of_side.items():
        heads: dict[int, int] = {}
        of_kind: dict[str, dict[int, int]] = {}
        for candidate in candidates:
            kind = _kind(context, candidate)
            place = candidate.tokens.stop
            rank = heads.setdefault(place, len(heads))
            ranks = of_kind.setdefault(kind, {})
            kind_rank = ranks.setdefault(place, len(ranks))
            features = tuple(_features(context, gap, candidate, side, rank, kind, kind_rank))
            word = gap.word or f"unsaid.{gap.type}"
            determiner = _determiner(document, candidate)
            contrast = f"{own}.{_modifier(context.observed, _named(candidate))}" if gap.tokens else ""
            for text, way in _worded(context.observed, gap, candidate, contrast):
                more = (
                    f"way:{way}.{gap.form}",
                    f"way:{way}.{word}.{determiner}",
                    f"way:{way}.{gap.form}.{determiner}.{candidate.shape}",
                    f"way:{way}.{gap.form}.{contrast}",
                    f"way:{way}.{word}.{contrast}.{determiner}",
                )
                options.append(Option(candidate, gap.type, text, features, more))
    if not ((is_pointed or containers) and options):
        options.append(Option(None, "", "", tuple(_none_features(context, gap))))
    return options


def _identity(context: Context, gap: Gap) -> range:
    """The words that say who is meant where a pronoun stands in the branch of "if it's the plumber"; else empty."""
    path = context.paths.get(gap.task.id, ())
    if gap.word not in _SOMEBODY or not path or path[-1][1] != "then":
        return range(0)
    document = context.observed.document
    check = next((task for task in context.tasks if task.id == path[-1][0]), None)
    said = {a.type: document.indices(a.span) for a in check.arguments if a.span} if check else {}
    is_asked = "state" in said and [document.tokens[i].lower for i in said.get("object", ())] == ["it"]
    if not is_asked or document.tokens[said["state"][-1]].pos not in ("NOUN", "PROPN"):
        return range(0)
    return next((c.tokens for c in context.pool if c.tokens == said["state"]), range(0))


def _is_somebody(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate may be who nobody is: somebody in general, or whom the same condition is about."""
    is_same = context.relation(candidate.owner, gap.task.id) in ("mention", "first")
    return candidate.text.split()[0].lower() in ANYBODY or (is_same and _kind(context, candidate) in _ANIMATE)


def _containers(context: Context, gap: Gap) -> list[Candidate]:
    """What "inside" or "in there" is the inside of: what has one and is named in the same task, the one before or,
    where "there" can be nothing before, the one after.

    Empty where that is nothing, and where it is somebody who is inside: they are in the house.
    """
    is_inside = gap.word == "inside" or (gap.word == "there" and gap.preposition == "in")
    if not is_inside or gap.type not in ("location", "source"):
        return []
    tokens = context.observed.document.tokens
    said = [context.observed.document.indices(a.span) for a in gap.task.arguments if a.type == "object" and a.span]
    if any(tokens[i].lower in _PERSONAL for words in said for i in words):
        return []
    own = [c for c in context.pool if c.owner == gap.task.id and c.type == "object"]
    if any(_kind(context, candidate) in _ANIMATE for candidate in own):
        return []
    able = [c for c in context.pool if c.owner and _has_inside(context, c) and c.tokens != gap.tokens]
    near = [range(gap.task.id - 1, gap.task.id + 1), range(gap.task.id + 1, gap.task.id + 2)]
    return next(
        (
            found
            for tasks in near[: 1 + (gap.word == "inside" or gap.task.id == 1)]
            if (found := [c for c in able if c.owner in tasks])
        ),
        [],
    )


def _has_inside(context: Context, candidate: Candidate) -> bool:
    words = candidate.text.lower().split()
    return any(" ".join(words[i:]) in context.observed.gazetteer.containers for i in range(len(words)))


def _fronted(context: Context, gap: Gap) -> range:
    """The words of a "whichever window is open" right ahead of an order that takes them up ("..., close it"); else
    empty."""
    tokens, verb = context.observed.document.tokens, context.observed.document.indices(gap.task.span).start
    if gap.word not in _ELSEWHERE - _SOMEBODY or gap.type != "object":
        return range(0)
    start = verb
    while start and (tokens[start - 1].text in MARKS or tokens[start - 1].lower in ("please", "just", "then")):
        start -= 1
    return next((words for words in free_relatives(context.observed.document, ()) if words.stop == start), range(0))


def _done_before(context: Context, gap: Gap) -> int:
    """The task, by its number, that did before what a verb now does again, or undid it: "start the mower. ... clean the
    filter and *start it again*" is of the mower; 0 where none did."""
    document, verb = context.observed.document, context.lemmas[gap.task.id].split()[0]
    if gap.type != "object" or gap.word not in _ELSEWHERE - _SOMEBODY or gap.task.type in _HANDLING:
        return 0
    behind = [token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 3]]
    end = next((i for i, word in enumerate(behind) if word in MARKS or word == "and"), len(behind))
    if "again" not in behind[:end] and not (behind[:1] == ["back"] and gap.task.type == "change_state"):
        return 0
    earlier = (task.id for task in reversed(context.tasks) if task.id < gap.task.id)
    last = next((n for n in earlier if _is_of_one_act(context.lemmas[n].split()[0], verb)), 0)
    return last if any((c.owner, c.type) == (last, "object") for c in context.pool) else 0


def _is_of_one_act(one: str, other: str) -> bool:
    """Whether two verbs do the same, or one undoes what the other does ("plug", "unplug")."""
    is_undone = one.removeprefix("un") == other.removeprefix("un")
    return is_undone or any(one in verbs and other in verbs for verbs in _ACTS)


def _instrument(context: Context, gap: Gap) -> int:
    """The task, by its number, that fetched what is cleaned with: "The floor's wet, get the mop and clean it" is of the
    floor; 0 where nothing else was spoken of before, or what was fetched itself ("the mop is dirty")."""
    document = context.observed.document
    if gap.type != "object" or gap.word not in ("it", "that", "them") or gap.task.type in _HANDLING - {"taking"}:
        return 0
    fetching = next((task for task in context.tasks if task.id == gap.task.id - 1), None)
    verb = context.lemmas[gap.task.id].split()[0]
    if fetching is None or fetching.type not in _HANDLING or verb not in CLEANING:
        return 0
    fetched = {document.tokens[c.head].lemma for c in context.pool if (c.owner, c.type) == (fetching.id, "object")}
    place = document.indices(fetching.span).start
    others = [
        c for c in context.pool if c.tokens.stop <= place and context.types.get(c.owner) in (None, *_TELLING, "taking")
    ]
    others = [c for c in others if c.type not in ("recipient", "goal") or not c.owner]
    is_fetched = any(document.tokens[c.head].lemma in fetched for c in others)
    return fetching.id if fetched & INSTRUMENTS and others and not is_fetched else 0


def _is_ruled_out(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a pronoun cannot mean a candidate: another argument of its own task ("put it on the table"), what there
    is none of, or what is no person where it is named after a "she" ("if she's hungry, bring her the cake") or handled
    before somebody is told or given something ("bring her the cake and tell her ...")."""
    if gap.word not in _ELSEWHERE:
        return False
    if candidate.owner == gap.task.id and not candidate.mention:
        return True
    is_ahead = gap.word in _SOMEBODY and candidate.tokens.start > gap.position
    is_given = gap.type == "recipient" and candidate.type == "object" and candidate.task_type in _HANDLING
    if (is_ahead or is_given) and _kind(context, candidate) not in _ANIMATE:
        return True
    return _is_absent(context, gap, candidate)


def _is_absent(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate is what there is none of where something is switched off or shut: "if there is no steam, turn
    it off". It may well be fetched, made or put on a list."""
    if not any(a.type == "state" and a.value.lower() in _ENDED for a in gap.task.arguments):
        return False
    start = candidate.tokens.start
    words = {token.lower for token in context.observed.document.tokens[max(0, start - 1) : start + 1]}
    if "no" not in words:
        return False
    return context.relation(candidate.owner, gap.task.id).startswith("condition.else")


def _worded(observed: Observed, gap: Gap, candidate: Candidate, contrast: str) -> Iterator[tuple[str, str]]:
    """The spellings of a candidate for a gap, none of which says what the gap's words rule out: "another" is not the
    thing itself, and "the black one" no grey hoodie."""
    tokens = observed.document.tokens
    worded = list(spellings(observed.document, gap, candidate))
    words = {tokens[i].lower for i in gap.tokens}
    if not words.isdisjoint(_OTHER):
        # "the other one" is none of those named, and in contrast with "the red mug" it is not red
        is_told = "another" not in words and _modifier(observed, _named(candidate)) == "colour"
        red = tokens[candidate.head - 1].text if is_told else ""
        worded = [(" ".join(word for word in text.split(" ") if word != red), way) for text, way in worded]
        worded = [(text, way) for text, way in worded if text.split()[-1] not in _ONES]
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if tokens[candidate.tokens.start].lower in _LACKING:  # what there is none of: "no paper? Bring some"
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    certain = tokens[candidate.tokens.start].tag == "PRP$" or tokens[candidate.tokens.start].lower in _CERTAIN
    is_measure = (  # "a glass of it" is no bottle
        gap.form == "part"
        and tokens[gap.tokens.start].pos in ("DET", "NUM")
        and tokens[gap.tokens.stop - 3].pos == "NOUN"
    )
    if is_measure or (gap.word == "another" and certain):
        yield from ((worded[0][0] if way == "same" else text, way) for text, way in worded)
        return
    colour = tokens[candidate.head - 1] if contrast == "colour.colour" else None
    if colour is None or colour.lower == tokens[gap.tokens.stop - 2].lower:
        yield from worded
        return
    noun = next((text for text, way in worded if way == "modified.head"), worded[0][0])
    yield from ((noun if colour.text in text.split() else text, way) for text, way in worded)


_LACKING = frozenset(("no", "few"))
_OTHER = frozenset(("other", "others", "another"))
_ONES = frozenset(("one", "ones"))
_ENDED = frozenset(("off", "down", "shut", "closed"))
_CERTAIN = frozenset("the this that these those".split())
_ELSEWHERE = frozenset("it them 'em em they that those this these him he she her".split())
"""Words that never mean another argument of their own task: in "put it on the table" it is not the table."""
_SOMEBODY = frozenset(("he", "him", "she", "her"))
_PERSONAL = _SOMEBODY | frozenset("they you somebody someone anybody anyone everybody everyone nobody".split())
_HANDLING = frozenset(("bringing", "taking", "placing"))
_ANIMATE = frozenset(("person", "animal", "name"))
_ACTS = (
    frozenset("turn switch start stop restart flick".split()),
    frozenset(("open", "close", "shut")),
    frozenset(("fill", "empty")),
)
"""Verbs that do the same or undo it."""
CLEANING = frozenset("clean wipe mop sweep scrub vacuum hoover dust brush dry polish rub soak swab dab".split())
"""What is done with one of the `INSTRUMENTS`, which is seldom done to one."""
INSTRUMENTS = frozenset(
    "cloth rag mop broom sponge brush dustpan hoover vacuum duster wipe towel roll squeegee tissue paper".split()
)
"""What things are cleaned with."""
_TELLING = frozenset(("check_state", "change_state"))
_TOGETHER = frozenset("both them they those these either".split())


def _together(document: Document, candidates: Sequence[Candidate]) -> Iterator[Candidate]:
    """Two things that tasks name one after the other, which a plural may mean together."""
    objects = [c for c in candidates if c.type == "object" and not c.mention and c.shape in ("whole", "long")]
    for first, second in pairwise(objects):
        if first.owner != second.owner or first.tokens.stop < second.tokens.start:
            yield replace(second, text=f"{first.text} and {second.text}", shape="pair")


def _features(
    context: Context, gap: Gap, candidate: Candidate, side: str, rank: int, kind: str, kind_rank: int
) -> Iterator[str]:
    document = context.observed.document
    head = document.tokens[candidate.head]
    word = gap.word or f"unsaid.{gap.type}.{gap.task.type}"
    group = _GROUPS.get(gap.word, word)
    place = f"{side}{min(rank, 4)}"
    sentences = max(-1, min(3, document.sentences[gap.position] - document.sentences[candidate.anchor]))
    number = "plural" if head.tag in ("NNS", "NNPS") else "list" if candidate.shape in ("list", "pair") else "one"
    if number == "one" and any(document.tokens[i].lower == "and" for i in candidate.tokens):
        number = "list"
    determiner = _determiner(document, candidate)
    relation = context.relation(candidate.owner, gap.task.id)
    delta = str(max(-2, min(3, gap.task.id - candidate.owner))) if candidate.owner else "none"
    mention = _GROUPS.get(candidate.mention, candidate.mention)
    role = document.tokens[candidate.anchor].dep
    gap_role = document.tokens[gap.tokens.stop - 1].dep if gap.tokens else "unsaid"
    verb = context.lemmas[gap.task.id]
    text = candidate.text.lower()
    taken = text in context.fillings.get(gap.task.id, ()) and relation != "self"
    earlier = context.mentions.get(text, ())
    groups = "+".join(sorted(set(earlier)))
    yield f"rank:{place}"
    yield f"rank:{word}.{place}"
    yield f"kind:{word}.{kind}"
    yield f"kind.rank:{group}.{kind}.{side}{min(kind_rank, 3)}"
    yield f"kind.gap:{gap.type}.{kind}"
    yield f"kind.task:{gap.task.type}.{gap.type}.{kind}"
    yield f"kind.det:{group}.{kind}.{determiner}"
    yield f"number:{word}.{number}"
    yield f"number.type:{group}.{number}.{candidate.type}.{candidate.shape}"
    yield f"type:{word}.{candidate.type}"
    yield f"type.gap:{gap.type}.{candidate.type}"
    yield f"tasks:{gap.task.type}.{gap.type}.{candidate.task_type}.{candidate.type}"
    yield f"type.delta:{group}.{candidate.type}.{delta}"
    yield f"delta:{delta}"
    yield f"sentences:{group}.{sentences}"
    yield f"role:{word}.{role}"
    yield f"roles:{gap_role}.{role}.{sentences}"
    yield f"det:{word}.{determiner}"
    yield f"mention:{group}.{mention}.{side}{min(rank, 1)}"
    yield f"mention.kind:{group}.{mention}.{kind}"
    yield f"groups:{group}.{groups}"
    yield f"count:{group}.{min(3, len(earlier))}"
    yield f"relation:{relation}.{side}"
    yield f"relation.type:{group}.{relation}.{candidate.type}"
    yield f"relation.gap:{gap.type}.{relation}.{candidate.type}.{candidate.task_type}"
    yield f"relation.rank:{relation}.{place}"
    yield f"shape:{candidate.shape}"
    yield f"shape.word:{group}.{candidate.shape}.{candidate.type}"
    yield f"prep.kind:{gap.preposition}.{kind}"
    yield f"prep.lemma:{gap.preposition}.{head.lemma}"
    yield f"lemma.task:{gap.task.type}.{gap.type}.{head.lemma}"
    yield f"lemma.verb:{verb}.{gap.type}.{head.lemma}"
    yield f"lemma.word:{group}.{head.lemma}"
    yield f"verb.type:{verb}.{gap.type}.{candidate.type}.{side}"
    yield f"verbs:{verb}.{gap.type}.{context.lemmas.get(candidate.owner, '')}.{candidate.type}"
    yield f"object.rank:{gap.type == candidate.type}.{place}"
    yield f"topic:{group}.{text == context.topic}.{kind}"
    yield f"verb.kind:{verb}.{gap.type}.{kind}"
    gazetteer = context.observed.gazetteer
    state = next((a.value.lower() for a in gap.task.arguments if a.type == "state"), verb)
    pair = gazetteer.pairs.get(state, state)
    pairs = gazetteer.changeable.get(head.lemma, ())
    yield f"pairs:{gap.type}.{pair}.{'+'.join(pairs)}"
    yield f"pair:{gap.type}.{gap.task.type}.{pair}.{pair in pairs}.{not pairs}"
    yield f"state.lemma:{gap.type}.{state}.{head.lemma}"
    if taken:
        yield f"taken:{gap.type}"
    if not gap.word:
        said = "+".join(sorted(argument.type for argument in gap.task.arguments))
        yield f"said:{gap.task.type}.{gap.type}.{said}.{relation}.{candidate.type}"
        yield "filled"
        yield f"filled:{word}.{verb}"


def _predicates(context: Context, gap: Gap) -> list[Option]:
    """The options of a gap that a state or a place fills. What asks how full something is asks for what the first
    mention of it says; what says that there is a thing says no state of it, and nobody is as another thing is."""
    options = list(_predicate_options(context, gap))
    if degree_asked(context.observed.document, gap.position):
        owners = [c.candidate.owner for c in options if c.candidate and c.type == "state"]
        mentions = [owner for owner in owners if context.relation(owner, gap.task.id) == "mention"]
        return [
            o for o in options if o.candidate and o.type == "state" and o.candidate.owner == min(mentions, default=0)
        ]
    if says_there_is(context.observed.document, gap.task):
        return [option for option in options if option.type != "state"]
    if nobody(context.observed.document, gap.position):
        return [option for option in options if not _is_of_other_check(context, gap, option)]
    return options


def _is_of_other_check(context: Context, gap: Gap, option: Option) -> bool:
    """Whether a state is what another condition tests."""
    owner = option.candidate.owner if option.candidate is not None else 0
    is_check = option.type == "state" and context.types.get(owner) == "check_state"
    return is_check and context.relation(owner, gap.task.id) not in ("mention", "first")


def _predicate_options(context: Context, gap: Gap) -> Iterator[Option]:
    document = context.observed.document
    verb = document.tokens[gap.position].lemma
    before = [c for c in context.predicates if c.tokens.start < gap.position]
    before.sort(key=lambda candidate: -candidate.tokens.start)
    after = [c for c in context.predicates if c.tokens.start > gap.position]
    ahead = _next(document, gap.position)
    for side, candidates in (("before", before), ("after", after)):
        ranks: dict[str, int] = {}
        for candidate in candidates:
            if candidate.owner == gap.task.id:
                continue
            kind = "state" if candidate.type == "state" else "location"
            rank = ranks[kind] = ranks.get(kind, -1) + 1
            relation = context.relation(candidate.owner, gap.task.id)
            sentences = max(-1, min(3, document.sentences[gap.position] - document.sentences[candidate.tokens.start]))
            what = f"{candidate.type}.{candidate.shape}"
            place = f"{side}{min(rank, 3)}"
            last = document.tokens[candidate.tokens.start]
            known = candidate.text.lower() in context.observed.gazetteer.states
            features = (
                "p.filled",
                f"p:{what}.{place}",
                f"p:{what}.{relation}",
                f"p:{what}.{relation}.{candidate.task_type}",
                f"p:{what}.{relation}.{verb}.{ahead}",
                f"p:{what}.{verb}.{ahead}",
                f"p:{verb}.{ahead}.{relation}",
                f"p:{what}.{verb}.{last.tag}",
                f"p:{what}.{sentences}",
                f"p:{what}.{place}.{relation}",
                f"p:{what}.{known}.{verb}.{relation}",
                f"p:{what}.{last.dep}.{last.tag}",
                f"p:{context.lemmas.get(candidate.owner, '')}.{what}",
            )
            yield Option(candidate, kind, candidate.text, features)


def _next(document: Document, i: int) -> str:
    """How a clause goes on after its verb: "end" where nothing is left of it."""
    words = [token.lower for token in document.tokens[i + 1 : i + 4]]
    while words and words[0] in ("n't", "not", "it", "he", "she", "they", "there", "any", "one", "you", "i"):
        words = words[1:]
    return "end" if not words or words[0] in (".", ",", "?", ";", ":", "!", "and", "then", "so") else "more"


def _none_features(context: Context, gap: Gap) -> Iterator[str]:
    document = context.observed.document
    task = gap.task
    verb = document.tokens[document.indices(task.span).start].lemma
    ahead = _next(document, document.indices(task.span).start)
    said = "+".join(sorted(argument.type for argument in task.arguments))
    first = context.first.get(task.id)
    rank = "none" if first is None else "first" if first == task.id else context.types.get(first, "")
    path = context.paths.get(task.id, ())
    name = gap.word or f"unsaid.{gap.type}.{task.type}"
    yield "none"
    yield f"none:{name}.{gap.form}"
    yield f"none:{gap.type}.{gap.form}"
    yield f"none:{name}.{verb}.{ahead}"
    yield f"none:{name}.{gap.is_required}"
    yield f"none:{name}.{said}.{ahead}"
    yield f"none:{name}.{rank}"
    yield f"none:{name}.{rank}.{verb}.{ahead}"
    yield f"none:{name}.{path[-1][1] if path else 'top'}"
    yield f"none:{name}.first.{task.id == 1}"
    yield f"none:{name}.{context.types.get(task.id - 1, '')}"
    yield f"none:{name}.{context.lemmas[task.id]}.{said}"
    if gap.tokens:
        words = "_".join(document.tokens[i].lower for i in gap.tokens)
        yield f"none:words.{words}"
    nouns = any(c.type != "outside" for c in context.pool if c.tokens.stop <= gap.position)
    yield f"none:{name}.nouns.{nouns}"


def _determiner(document: Document, candidate: Candidate) -> str:
    """How a phrase begins: definite, indefinite, counted, quantified, possessive or bare."""
    first = document.tokens[min(candidate.tokens.start, candidate.head) if not candidate.mention else candidate.head]
    word = candidate.text.split(" ", 1)[0].lower()
    if word in ("a", "an"):
        return "a"
    if word in ("any", "some", "enough", "more", "no", "another"):
        return word
    if word in ("the", "this", "that", "these", "those"):
        return "the"
    if word in ("my", "your", "his", "her", "our", "their", "its") or "'s " in candidate.text:
        return "my"
    if first.pos == "NUM" or word == "both":
        return "number"
    return "name" if first.pos == "PROPN" and candidate.text[:1].isupper() else "bare"


def _named(candidate: Candidate) -> range:
    """The tokens of a candidate up to its head; none where it stands for one that is named elsewhere."""
    return range(candidate.tokens.start, candidate.head + 1) if not candidate.mention else range(0)


def _modifier(observed: Observed, tokens: range) -> str:
    """What stands before the last word of a phrase: a colour, another adjective, a number, a noun, or none of these."""
    if len(tokens) < 2:
        return "none"
    token = observed.document.tokens[tokens.stop - 2]
    if token.lower in observed.gazetteer.colours:
        return "colour"
    return {"ADJ": "adjective", "NUM": "number", "NOUN": "noun", "PROPN": "noun"}.get(token.pos, "none")


def _kind(context: Context, candidate: Candidate) -> str:
    """person, animal, name, place, or the category of thing that the words tell."""
    token = context.observed.document.tokens[candidate.head]
    category = context.observed.gazetteer.category(token.lemma)
    if category == "person" or token.lemma in PERSON_NOUNS:
        return "person"
    if token.lemma in _ANIMALS:
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
