"""Traits: what a model weighs of a candidate for a gap, and of leaving the gap unfilled."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.context import GROUPS, Context
from decomplex_bt.understanding.references.gaps import Gap
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import SHARES


def traits_of(
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
    determiner = determiner_of(document, candidate)
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


def traits_of_none(context: Context, gap: Gap) -> Iterator[str]:
    document = context.observed.document
    task = gap.task
    verb = document.tokens[document.indices(task.span).start].lemma
    ahead = goes_on(document, document.indices(task.span).start)
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


def goes_on(document: Document, i: int) -> str:
    """How a clause goes on after its verb: "end" where nothing is left of it."""
    words = [token.lower for token in document.tokens[i + 1 : i + 4]]
    while words and words[0] in ("n't", "not", "it", "he", "she", "they", "there", "any", "one", "you", "i"):
        words = words[1:]
    return "end" if not words or words[0] in (".", ",", "?", ";", ":", "!", "and", "then", "so") else "more"


def determiner_of(document: Document, candidate: Candidate) -> str:
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


def named(candidate: Candidate) -> range:
    """The tokens of a candidate up to its head; none where it stands for one that is named elsewhere."""
    return range(candidate.tokens.start, candidate.head + 1) if not candidate.mention else range(0)


def modifier(observed: Observed, tokens: range) -> str:
    """What stands before the last word of a phrase: a colour, another adjective, a number, a noun, or none of these."""
    if len(tokens) < 2:
        return "none"
    token = observed.document.tokens[tokens.stop - 2]
    if token.lower in observed.gazetteer.colours:
        return "colour"
    return {"ADJ": "adjective", "NUM": "number", "NOUN": "noun", "PROPN": "noun"}.get(token.pos, "none")
