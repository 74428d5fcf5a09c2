"""Certainty: what English settles of what a gap refers to, whatever a model finds likelier."""

from __future__ import annotations

from decomplex_bt.domain.clauses import AIR
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.antecedents import meant
from decomplex_bt.understanding.references.asked_again import asked_before
from decomplex_bt.understanding.references.context import ANIMATE, Context, kind_of
from decomplex_bt.understanding.references.exclusions import (
    ACTS,
    CLEANING,
    MOVING,
    SOMEBODY,
    done_otherwise,
    is_of,
    is_ruled_out,
    is_weather,
    listed,
)
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.identity import identity_of
from decomplex_bt.understanding.references.insides import containers_of
from decomplex_bt.understanding.references.persons import asks_who_calls, is_no_somebody
from decomplex_bt.understanding.references.phrases import Candidate, nobody
from decomplex_bt.understanding.references.relatives import free_places, free_relatives
from decomplex_bt.understanding.references.roles import ELSEWHERE
from decomplex_bt.understanding.references.switching import is_unshut, is_unswitched
from decomplex_bt.understanding.vocabulary import ANYBODY, ONES

INSTRUMENTS = frozenset(
    "cloth rag mop broom sponge brush dustpan hoover vacuum duster wipe towel roll squeegee tissue paper ladder "
    "stepladder stool steps".split()
)
"""What things are cleaned with."""
_OF_ANY_NUMBER = frozenset("they them em 'em".split())
"""What may be said of one person whose gender is open: "if it's a neighbour, let *them* in"."""
_TELLING = frozenset(("check_state", "change_state"))
_STATING = frozenset("is are 's looks smells needs has".split())
_GUARDING = frozenset(("if", "unless"))
_JOINING = frozenset(("and", "but", "or", "then"))
_LIMITING = frozenset(("not", "only"))
_HANGING = _LIMITING | {"but", "though", "although", "just"}
"""What hangs a condition on the order ahead: ", but not if ..."."""


def referable(context: Context, gap: Gap) -> list[Candidate]:
    """The candidates that a gap may refer to, as far as English settles it, in the order of the context's pool."""
    document = context.observed.document
    # "that one" always is one that was named, and the last of those that were named as a "one"
    is_pointed = is_pointing_back(document, gap)
    one = _last_one(context, gap) if is_pointed else None
    settled = meant(context, gap)
    if not settled and (is_weather(context, gap) or gap.form == "kind"):
        return []
    again = asked_before(context, gap)
    order = 0 if settled or again else _guarded(context, gap)
    identity = settled or _identity(context, gap) or _fronted(context, gap) or _reasoned(context, gap)
    is_of_nobody = gap.type == "object" and not gap.word and bool(nobody(document, gap.position))
    containers = containers_of(context, gap)
    before = _done_before(context, gap) or listed(context, gap) or again
    instrument = _instrument(context, gap)
    # "mop it up" is not of the floor, but of what is on it
    is_wiped_up = bool(instrument) and context.lemmas[gap.task.id].endswith(" up")

    def may_be(candidate: Candidate) -> bool:
        return not (
            (containers and candidate not in containers)
            or (is_pointed and (candidate.owner == gap.task.id or candidate.tokens.start > gap.position))
            or (one and candidate.tokens != one)
            or (identity and candidate.tokens != identity)
            or (is_of_nobody and not _is_somebody(context, gap, candidate))
            or (before and (candidate.owner, candidate.type) != (before, "object"))
            or candidate.owner == instrument > 0
            or (is_wiped_up and candidate.type in ("location", "source"))
            or (order and not is_of(context, order, candidate))
            or (not settled and is_ruled_out(context, gap, candidate))
        )

    return [candidate for candidate in context.pool if may_be(candidate)]


def _last_one(context: Context, gap: Gap) -> range | None:
    """The words of the last thing before a gap that was named as a "one": "the lower one", "the one in the study"."""
    words = [token.lower for token in context.observed.document.tokens]
    ahead = [c.tokens for c in context.pool if c.tokens.stop <= gap.position and c.owner != gap.task.id]
    ones = [named for named in ahead if words[named.start] == "the" and not ONES.isdisjoint(words[i] for i in named)]
    return max(ones, key=lambda named: named.start, default=None)


def is_pointing_back(document: Document, gap: Gap) -> bool:
    return {document.tokens[i].lower for i in gap.tokens} == {"that", "one"}


def _identity(context: Context, gap: Gap) -> range:
    """The words that say who or what is meant where a pronoun stands in the branch of "if it's the plumber" or "if that
    noise is the dryer"; else empty."""
    path = context.paths.get(gap.task.id, ())
    document = context.observed.document
    check = next((task for task in context.tasks if path and path[-1] == (task.id, "then")), None)
    if check is None or gap.word not in ELSEWHERE:
        return range(0)
    said = {a.type: document.indices(a.span) for a in check.arguments if a.span}
    is_asked = "state" in said and [document.tokens[i].lower for i in said.get("object", ())] == ["it"]
    named, identity = range(0), identity_of(document, document.indices(check.span).start)
    if is_asked and gap.word in SOMEBODY:
        named = said["state"] if document.tokens[said["state"][-1]].pos in ("NOUN", "PROPN") else named
    elif identity is not None and not identity.is_of_order(document):
        is_who = identity.is_of_person(document) or (identity.is_pronoun(document) and asks_who_calls(context, check))
        is_one = gap.word in _OF_ANY_NUMBER and document.tokens[identity.name[-1]].tag in ("NN", "NNP")
        is_meant = is_who if gap.word in SOMEBODY or (is_who and is_one) else not identity.is_pronoun(document)
        named = identity.name if is_meant else named
    found = [c for c in context.pool if c.tokens == named]
    return named if found and not any(is_no_somebody(context, gap, c) for c in found) else range(0)


def _is_somebody(context: Context, gap: Gap, candidate: Candidate) -> bool:
    """Whether a candidate may be who nobody is: somebody in general, or whom the same condition is about."""
    is_same = context.relation(candidate.owner, gap.task.id) in ("mention", "first")
    return candidate.text.split()[0].lower() in ANYBODY or (is_same and kind_of(context, candidate) in ANIMATE)


def _fronted(context: Context, gap: Gap) -> range:
    """The words of a "whichever window is open" or the "whatever's" of "whatever's in the sink" right ahead of an order
    that takes them up ("..., close it"); else empty."""
    document = context.observed.document
    tokens, verb = document.tokens, document.indices(gap.task.span).start
    if gap.word not in ELSEWHERE - SOMEBODY or gap.type != "object":
        return range(0)
    start = verb
    while start and (tokens[start - 1].text in MARKS or tokens[start - 1].lower in ("please", "just", "then")):
        start -= 1
    named = [(words, words) for words in free_relatives(document, ())]
    return next((words for words, whole in (*named, *free_places(document)) if whole.stop == start), range(0))


def _reasoned(context: Context, gap: Gap) -> range:
    """The words of what a statement says that is the reason for an order: "*the mug* is dirty, so wash it"; else
    empty."""
    document = context.observed.document
    tokens, at = document.tokens, document.indices(gap.task.span).start - 1
    if gap.type != "object" or gap.word not in ("it", "them"):
        return range(0)
    while at > 0 and tokens[at].lower in ("please", "just"):
        at -= 1
    if at < 1 or tokens[at].lower != "so":
        return range(0)
    first = next(i for i in range(at + 1) if document.sentences[i] == document.sentences[at])
    if tokens[at - 1].text == ",":  # "if the safe is locked, *the code* is with Ann, so get it"
        first = next((i + 1 for i in range(at - 2, first, -1) if tokens[i].text == ","), first)
    tag = ("NN", "NNP") if gap.word == "it" else ("NNS",)
    if sum(token.tag in ("VBZ", "VBP", "VBD") for token in tokens[first:at]) != 1:
        return range(0)
    named = (c for c in context.pool if c.tokens.start == first and c.tokens.stop < at and not c.mention)
    named = (c for c in named if kind_of(context, c) not in ANIMATE)
    said = max(named, key=lambda c: c.tokens.stop, default=None)
    if said is not None and (is_unswitched(context, gap, said) or is_unshut(context, gap, said)):
        return range(0)
    is_said = said is not None and tokens[said.tokens.stop].lower in _STATING and tokens[said.head].tag in tag
    if said is None or not is_said:
        return range(0)
    # "*the vase* on the landing is cracked, so move it", where the place is another argument
    thing = range(said.tokens.start, said.head + 1)
    is_apart = "across" in said.shape and any(c.tokens == thing for c in context.pool)
    return thing if is_apart else said.tokens


def _done_before(context: Context, gap: Gap) -> int:
    """The task, by its number, that did before what a verb now does again, or undid it: "start the mower. ... clean the
    filter and *start it again*" is of the mower; 0 where none did."""
    document, verb = context.observed.document, context.lemmas[gap.task.id].split()[0]
    if gap.type != "object" or gap.word not in ELSEWHERE - SOMEBODY or gap.task.type in MOVING:
        return 0
    behind = [token.lower for token in document.tokens[gap.tokens.stop : gap.tokens.stop + 3]]
    end = next((i for i, word in enumerate(behind) if word in MARKS or word == "and"), len(behind))
    if otherwise := done_otherwise(context, gap, verb):
        return otherwise
    if "again" not in behind[:end] and not (behind[:1] == ["back"] and gap.task.type == "change_state"):
        return 0
    earlier = (task.id for task in reversed(context.tasks) if task.id < gap.task.id)
    last = next((n for n in earlier if _is_of_one_act(context.lemmas[n].split()[0], verb)), 0)
    return last if context.arguments(last, "object") else 0


def _is_of_one_act(one: str, other: str) -> bool:
    """Whether two verbs do the same, or one undoes what the other does ("plug", "unplug")."""
    is_undone = one.removeprefix("un") == other.removeprefix("un")
    return is_undone or any(one in verbs and other in verbs for verbs in ACTS)


def _instrument(context: Context, gap: Gap) -> int:
    """The task, by its number, that fetched what is cleaned with: "The floor's wet, get the mop and clean it" is of the
    floor; 0 where nothing else was spoken of before, or what was fetched itself ("the mop is dirty")."""
    document = context.observed.document
    if gap.type != "object" or gap.word not in ("it", "that", "them") or gap.task.type in MOVING - {"taking"}:
        return 0
    fetching = context.by_number.get(gap.task.id - 1)
    verb = context.lemmas[gap.task.id].split()[0]
    if fetching is None or fetching.type not in MOVING or verb not in CLEANING:
        return 0
    fetched = {document.tokens[c.head].lemma for c in context.arguments(fetching.id, "object")}
    place = document.indices(fetching.span).start
    others = [
        c for c in context.pool if c.tokens.stop <= place and context.types.get(c.owner) in (None, *_TELLING, "taking")
    ]
    others = [c for c in others if c.type not in ("recipient", "goal") or not c.owner]
    is_fetched = any(document.tokens[c.head].lemma in fetched for c in others)
    return fetching.id if fetched & INSTRUMENTS and others and not is_fetched else 0


def _guarded(context: Context, gap: Gap) -> int:
    """The order right behind which, with no mark between, an "if it ..." asks of what that names: "take the tray away
    and hang the towel up *unless it* is wet"; or which it is hung on: "..., *but not if it* is wet". 0 where there is
    none."""
    tokens, before = context.observed.document.tokens, gap.task.id - 1
    opener = gap.tokens.start - 1
    if gap.word != "it" or gap.task.type != "check_state" or opener < 1 or tokens[opener].lower not in _GUARDING:
        return 0
    check = context.observed.document.indices(gap.task.span).start
    start = _hung(context, gap, opener)
    if (
        check < opener
        or (tokens[opener - 1].lower in _JOINING and start == opener)
        or identity_of(context.observed.document, check) is not None
    ):
        return 0  # "see if it is", "... and if it is", "only if it's the plumber"
    order = context.by_number.get(before)
    if order is None or order.type in ("check_state", "searching", "informing", "motion"):
        return 0
    verb = context.observed.document.indices(order.span).start
    is_apart = any(token.text in MARKS for token in tokens[verb:start]) or verb > opener
    return 0 if is_apart or not any(c.owner == before and c.type == "object" for c in context.pool) else before


def _hung(context: Context, gap: Gap, opener: int) -> int:
    """Where the words begin that hang a condition on the order ahead: the mark of ", *though not* if it is full"; the
    "if" where there are none, or where it may be the day or the room that is so ("..., but only if it's warm")."""
    tokens, start = context.observed.document.tokens, opener
    while start and tokens[start - 1].lower in _HANGING:
        start -= 1
    states = {word for a in gap.task.arguments if a.type == "state" for word in a.value.lower().split()}
    if _LIMITING.isdisjoint(token.lower for token in tokens[start:opener]) or not states.isdisjoint(AIR):
        return opener
    is_marked = start > 0 and tokens[start - 1].text in MARKS and tokens[start - 1].text not in ".?!"
    return start - 1 if is_marked else start
