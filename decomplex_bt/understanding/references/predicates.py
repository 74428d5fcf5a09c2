"""Predicates: the options of a gap that a state or a place fills, as in "if it is"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import DENYING, Gap, asks_there_is, is_bare_being, says_there_is
from decomplex_bt.understanding.references.options import Option
from decomplex_bt.understanding.references.phrases import Candidate, degree_asked, nobody
from decomplex_bt.understanding.references.traits import goes_on


def predicate_options(context: Context, gap: Gap) -> list[Option]:
    """The options of a gap that a state or a place fills. What asks how full something is asks for what the first
    mention of it says; what says that there is a thing says no state of it, and nobody is as another thing is."""
    options = [o for o in _open_options(context, gap) if not _is_of_later_mention(context, gap, o)]
    if is_bare_being(context.observed.document, gap.position):
        options = [option for option in options if not _is_had(context, option) and not _is_order(option)]
        options = _of_case_before(context, gap, options) or options
    if degree_asked(context.observed.document, gap.position):
        owners = [c.candidate.owner for c in options if c.candidate and c.type == "state"]
        mentions = [owner for owner in owners if context.relation(owner, gap.task.id) == "mention"]
        return [
            o for o in options if o.candidate and o.type == "state" and o.candidate.owner == min(mentions, default=0)
        ]
    if says_there_is(context.observed.document, gap.task):
        return [option for option in options if option.type != "state"]
    if asks_there_is(context.observed.document, gap.task):  # "boil the kettle if there isn't any" is of no boiling
        options = [o for o in options if o.type != "state" or o.candidate is None or not _is_ordered(o.candidate)]
    if answers := _answers(context, gap, options):
        return answers
    if nobody(context.observed.document, gap.position):
        return [option for option in options if not _is_of_other_check(context, gap, option)]
    return options


def _is_ordered(candidate: Candidate) -> bool:
    """Whether a state is what an order brings about."""
    return candidate.task_type not in ("", "check_state")


def _is_order(option: Option) -> bool:
    """Whether an option is what an order says to do, which nothing is: "*wash the mug*, and if it is, ..."."""
    candidate = option.candidate
    return candidate is not None and candidate.shape == "deed" and _is_ordered(candidate)


def _is_had(context: Context, option: Option) -> bool:
    """Whether an option is what somebody has, which nobody is: "has she *a cold*? If she's hot, ...; if she isn't"."""
    candidate = option.candidate
    if candidate is None or option.type != "state" or candidate.task_type != "check_state":
        return False
    is_thing = context.observed.document.tokens[candidate.head].pos == "NOUN"
    return is_thing and context.lemmas.get(candidate.owner, "").split()[:1] == ["have"]


def _of_case_before(context: Context, gap: Gap, options: Sequence[Option]) -> list[Option]:
    """The options of the case that a sentence tells ahead of its "if he isn't", of the same thing: "is he tired? If
    he's *hot*, bring him the syrup, and if he isn't, ..."; empty where there is none."""
    document = context.observed.document
    case = next((t for t in reversed(context.tasks) if t.id < gap.task.id and t.type == "check_state"), None)
    verb = document.indices(case.span).start if case is not None else 0
    if case is None or document.sentences[verb] != document.sentences[gap.position]:
        return []
    one, other = ({c.text.lower() for c in context.arguments(n, "object")} for n in (gap.task.id, case.id))
    said = [(o, o.candidate) for o in options if o.candidate is not None]
    own = [o for o, candidate in said if candidate.owner == case.id and candidate.shape in ("whole", "bare")]
    return own if one & other and _is_denied(document, gap.position) != _is_denied(document, verb) else []


def _is_denied(document: Document, verb: int) -> bool:
    return any(token.lower in DENYING for token in document.tokens[verb + 1 : verb + 3])


def _is_of_later_mention(context: Context, gap: Gap, option: Option) -> bool:
    """Whether another state is told first of what a check asks: "check the soup; if it's *boiling*, ..., if it's
    *cold*, ..." asks if it is boiling."""
    if option.candidate is None or context.relation(option.candidate.owner, gap.task.id) != "mention":
        return False
    told = (c.owner for c in context.predicates if c.owner and context.relation(c.owner, gap.task.id) == "mention")
    return any(gap.task.id < owner < option.candidate.owner for owner in told)


def _answers(context: Context, gap: Gap, options: Sequence[Option]) -> list[Option]:
    """Of what a new condition may ask, what the task before asks somebody: "ask him if he's *hungry*, and if he is"."""
    # the question may stand ahead of what hangs on the answer: "ask him if he's *cold*, and bring a shawl if he is"
    path = context.paths.get(gap.task.id - 1, ())
    asked = gap.task.id - (2 if path and path[-1][0] == gap.task.id else 1)
    before = context.by_number.get(asked)
    if before is None or before.type != "informing" or context.first.get(gap.task.id) != gap.task.id:
        return []
    document = context.observed.document
    said = {i for a in before.arguments if a.type == "message" and a.span for i in document.indices(a.span)}
    return [o for o in options if o.candidate is not None and o.type == "state" and {*o.candidate.tokens} <= said]


def _is_of_other_check(context: Context, gap: Gap, option: Option) -> bool:
    """Whether a state is what another condition tests."""
    owner = option.candidate.owner if option.candidate is not None else 0
    is_check = option.type == "state" and context.types.get(owner) == "check_state"
    return is_check and context.relation(owner, gap.task.id) not in ("mention", "first")


def _open_options(context: Context, gap: Gap) -> Iterator[Option]:
    document = context.observed.document
    verb = document.tokens[gap.position].lemma
    before = [c for c in context.predicates if c.tokens.start < gap.position]
    before.sort(key=lambda candidate: -candidate.tokens.start)
    after = [c for c in context.predicates if c.tokens.start > gap.position]
    ahead = goes_on(document, gap.position)
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
