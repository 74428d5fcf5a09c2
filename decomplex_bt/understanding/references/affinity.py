"""How well a phrase fills a gap: the options that are not ruled out, each with the features that a model weighs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.agreement import OWN, pair_meant
from decomplex_bt.understanding.references.antecedents import meant, other_place
from decomplex_bt.understanding.references.asked_again import asked_before
from decomplex_bt.understanding.references.certainty import is_pointing_back, referable
from decomplex_bt.understanding.references.context import GROUPS, Context, kind_of
from decomplex_bt.understanding.references.gapped import gapped_pair
from decomplex_bt.understanding.references.gaps import (
    DENYING,
    PREDICATE,
    Gap,
    asks_there_is,
    is_bare_being,
    is_told_one,
    numbered_of,
    says_there_is,
    spellings,
)
from decomplex_bt.understanding.references.insides import containers_of
from decomplex_bt.understanding.references.ordinals import one_of_two
from decomplex_bt.understanding.references.phrases import Candidate, degree_asked, nobody
from decomplex_bt.understanding.vocabulary import ONES, QUANTIFIERS, SHARES


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


def options_of(context: Context, gap: Gap) -> list[Option]:
    """All ways to fill a gap, leaving it last."""
    if gap.type == PREDICATE:
        return [*_predicates(context, gap), Option(None, "", "", tuple(_none_features(context, gap)))]
    options: list[Option] = []
    document = context.observed.document
    own = _modifier(context.observed, gap.tokens)
    other, ordered = other_place(context, gap), one_of_two(context, gap)
    of_side: dict[str, list[Candidate]] = {"before": [], "after": []}
    for candidate in referable(context, gap):
        if candidate.tokens.stop <= gap.position:
            of_side["before"].append(candidate)
        elif candidate.tokens.start > max(gap.position, gap.tokens.stop - 1):
            of_side["after"].append(candidate)
    pair = gapped_pair(context, gap)
    if pair or gap.word in _TOGETHER:
        pairs = list(_together(of_side["before"]))
        pair = pair or pair_meant(context, gap, pairs)
        of_side = {"before": [pair], "after": []} if pair else {**of_side, "before": [*of_side["before"], *pairs]}
    halved = [c for c in of_side["before"] if _is_halved(document, gap, c)] if _is_bare_one(document, gap) else []
    of_side = {"before": halved, "after": []} if halved else of_side
    of_side["before"].sort(key=lambda candidate: -candidate.tokens.stop)
    for side, candidates in of_side.items():
        heads: dict[int, int] = {}
        of_kind: dict[str, dict[int, int]] = {}
        for candidate in candidates:
            kind = kind_of(context, candidate)
            place = candidate.tokens.stop
            rank = heads.setdefault(place, len(heads))
            ranks = of_kind.setdefault(kind, {})
            kind_rank = ranks.setdefault(place, len(ranks))
            features = tuple(_features(context, gap, candidate, side, rank, kind, kind_rank))
            word = gap.word or f"unsaid.{gap.type}"
            determiner = _determiner(document, candidate)
            contrast = f"{own}.{_modifier(context.observed, _named(candidate))}" if gap.tokens else ""
            is_of_colour = own == "colour" and _is_coloured(context.observed, candidate)
            is_contrasted = is_of_colour or (candidate.tokens == other and gap.form == "one")
            for text, way in _worded(context.observed, gap, candidate, is_contrasted):
                if ordered and way != "same":  # "the first one" is the red car, no "first red car"
                    continue
                more = (
                    f"way:{way}.{gap.form}",
                    f"way:{way}.{word}.{determiner}",
                    f"way:{way}.{gap.form}.{determiner}.{candidate.shape}",
                    f"way:{way}.{gap.form}.{contrast}",
                    f"way:{way}.{word}.{contrast}.{determiner}",
                )
                options.append(Option(candidate, gap.type, text, features, more))
    if (_is_of_somebody(document, gap) or (gap.word in OWN and gap.type == "object")) and options:
        return options  # "bring me Mum's" and "bring me mine" leave their noun to those before
    if not options or not (
        pair
        or halved
        or meant(context, gap)
        or is_pointing_back(document, gap)
        or containers_of(context, gap)
        or asked_before(context, gap)
    ):
        options.append(Option(None, "", "", tuple(_none_features(context, gap))))
    return options


def _worded(observed: Observed, gap: Gap, candidate: Candidate, is_contrasted: bool) -> Iterator[tuple[str, str]]:
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
        worded = [(text, way) for text, way in worded if text.split()[-1] not in ONES]
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if gap.word == "it" and gap.form == "pronoun":
        worded = [(_without_open_share(text), way) for text, way in worded]
    if kind := _kind_behind_colour(observed, gap, candidate):
        told = " ".join(tokens[i].text for i in gap.tokens[:-1])
        worded = [(f"{told} {kind}", "modified")]
    if _is_of_same_kind(observed, gap, candidate):
        worded = [(text, way) for text, way in worded if way != "modified.head"]
    if _is_of_somebody(observed.document, gap):  # "Anna's" is none of those named
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if words == {"mine"}:  # none of those named, but the speaker's of that kind
        worded = [(text, way) for text, way in worded if way == "own"] or worded
    if words == {"some"} and tokens[candidate.tokens.start].lower == "enough":
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if _is_one_of_several(observed.document, gap, candidate):  # "any pears? Bring me *one*" brings a pear
        worded = [(text, way) for text, way in worded if way in ("a", "one")] or worded
    if _is_bare_one(observed.document, gap) and _is_halved(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way == "one"] or worded
    if gap.form == "part" and _is_counted_out(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if _is_counted(observed.document, gap, candidate):
        worded = [(text, way) for text, way in worded if way.startswith("counted")] or worded
    if numbered_of(observed.document, gap):
        worded = [(text, way) for text, way in worded if way != "same"] or worded
    if is_told_one(observed.document, gap.tokens):
        worded = [(text, way) for text, way in worded if way == "a"] or worded
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
    colour = tokens[candidate.head - 1] if is_contrasted else None
    if colour is None or colour.lower == tokens[gap.tokens.stop - 2].lower:
        yield from worded
        return
    noun = next((text for text, way in worded if way == "modified.head"), worded[0][0])
    yield from ((noun if colour.text in text.split() else text, way) for text, way in worded)


def _without_open_share(text: str) -> str:
    """What is handled as "it" where it was asked if there is any of it: "*that soup*" of "any of that soup"."""
    share, joint, whole = text.partition(" of ")
    return whole if joint and share.lower() in _OPEN_SHARES else text


def _is_coloured(observed: Observed, candidate: Candidate) -> bool:
    before = observed.document.tokens[candidate.head - 1] if candidate.head else None
    return before is not None and before.lower in observed.gazetteer.colours


def _kind_behind_colour(observed: Observed, gap: Gap, candidate: Candidate) -> str:
    """What a thing is called behind its colour where "one" has another colour: the "sippy cup" of "the blue sippy cup
    ... *the pink one*"; empty where that is its noun alone."""
    tokens, colours = observed.document.tokens, observed.gazetteer.colours
    if gap.form != "one" or gap.word != "one" or _modifier(observed, gap.tokens) != "colour":
        return ""
    colour = next((i for i in _named(candidate) if tokens[i].lower in colours), candidate.head)
    is_single = tokens[candidate.head].tag in ("NN", "NNP")
    kind = " ".join(tokens[i].text for i in range(colour + 1, candidate.head + 1))
    return kind if " " in kind and is_single else ""


def _is_of_same_kind(observed: Observed, gap: Gap, candidate: Candidate) -> bool:
    """Whether "one" is of the very kind of a thing that is called by a compound: "another one", "the old one" or "the
    red one" behind "the crib sheet" is a crib sheet; "the small one" behind "the dining table" may be any table."""
    tokens, colours = observed.document.tokens, observed.gazetteer.colours
    words = [tokens[i].lower for i in gap.tokens]
    told = words[-2] if len(words) in (2, 3) and words[-1] in ONES else ""
    first = tokens[candidate.head - 1]
    is_compound = candidate.head > 0 and first.dep == "compound" and first.lower not in colours
    return gap.form == "one" and is_compound and (told in _SAME_KIND or told in colours)


def _is_of_somebody(document: Document, gap: Gap) -> bool:
    """Whether somebody's thing is handled whose noun was said before: "bring me *Mum's*"; no "cup of Barry's"."""
    is_handled = gap.type == "object" and gap.task.type in ("bringing", "taking", "placing")
    words = {document.tokens[i].lower for i in gap.tokens}
    return is_handled and gap.word == "'s" and words.isdisjoint(("of", "yesterday", "today"))


def _is_bare_one(document: Document, gap: Gap) -> bool:
    return [document.tokens[i].lower for i in gap.tokens] == ["one"]


def _is_halved(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether "one" is one of several things of which "the other" is told behind: "get *two* cups, put *one* here and
    *the other* there"."""
    tokens = document.tokens
    if gap.type != "object" or tokens[candidate.head].tag not in ("NNS", "NNPS") or candidate.type in _PLACES:
        return False
    others = (t.i for t in tokens[gap.tokens.stop :] if t.lower == "other" and tokens[t.i - 1].lower == "the")
    return any(i + 1 == len(tokens) or tokens[i + 1].pos not in ("NOUN", "PROPN") for i in others)


def _is_one_of_several(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether a bare "one" is one of several, and not all of them: of all the towels, of "*the plums*" or of "*a
    couple of plums*"."""
    if not _is_bare_one(document, gap):
        return False
    first = document.tokens[candidate.tokens.start].lower
    is_plural = document.tokens[candidate.head].tag in ("NNS", "NNPS")
    is_open = first in QUANTIFIERS or candidate.tokens.start == candidate.head
    is_several = is_plural and (is_open or first in _CERTAIN | {"a"}) and not candidate.mention
    return first in _EACH or (is_several and gap.task.type != "check_state")


def _is_counted(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether a number alone, or one "of those", says how many are meant, and not all: "any buns left? Bring me *two*",
    "if there are fresh buns, bring me *two of those*"; no "six" that is booth six."""
    number = document.tokens[gap.tokens.start] if gap.form in ("count", "part") else None
    if number is None or number.pos != "NUM" or number.lower in ("one", *candidate.text.lower().split()):
        return False
    return gap.form == "count" or gap.word in ("those", "these")


def _is_counted_out(document: Document, gap: Gap, candidate: Candidate) -> bool:
    """Whether one or so and so many are taken of known things: "six of them" of "the balloons"."""
    count, first = document.tokens[gap.tokens.start], document.tokens[candidate.tokens.start]
    is_known = first.lower in _CERTAIN or first.tag == "PRP$"
    is_several = document.tokens[candidate.head].tag in ("NNS", "NNPS")
    return (count.pos == "NUM" or count.lower == "one") and is_known and is_several


_PLACES = frozenset(("goal", "location", "source", "path"))
_EACH = frozenset(("all", "every", "each"))
_OPEN_SHARES = frozenset(("any", "some", "enough", "much"))
_LACKING = frozenset(("no", "few"))
_OTHER = frozenset(("other", "others", "another"))
_SAME_KIND = frozenset("another other new old spare fresh second third first next last".split())
"""What tells a thing from others of its kind."""
_CERTAIN = frozenset("the this that these those".split())
_TOGETHER = frozenset("both them they those these either".split())


def _together(candidates: Sequence[Candidate]) -> Iterator[Candidate]:
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
    group = GROUPS.get(gap.word, word)
    place = f"{side}{min(rank, 4)}"
    sentences = max(-1, min(3, document.sentences[gap.position] - document.sentences[candidate.anchor]))
    number = "plural" if head.tag in ("NNS", "NNPS") else "list" if candidate.shape in ("list", "pair") else "one"
    if number == "one" and any(document.tokens[i].lower == "and" for i in candidate.tokens):
        number = "list"
    determiner = _determiner(document, candidate)
    relation = context.relation(candidate.owner, gap.task.id)
    delta = str(max(-2, min(3, gap.task.id - candidate.owner))) if candidate.owner else "none"
    mention = GROUPS.get(candidate.mention, candidate.mention)
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
    options = [o for o in _predicate_options(context, gap) if not _is_of_later_mention(context, gap, o)]
    if is_bare_being(context.observed.document, gap.position):
        options = [option for option in options if not _is_had(context, option)]
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
    """How a phrase begins, behind a "half" or "all": definite, indefinite, counted, quantified, possessive or bare."""
    first = document.tokens[min(candidate.tokens.start, candidate.head) if not candidate.mention else candidate.head]
    words = candidate.text.lower().split(" ")
    word = words[1] if candidate.type == "outside" and words[0] in SHARES and len(words) > 1 else words[0]
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
