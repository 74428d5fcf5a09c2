"""What is left as it is: an order that says only what is not to be touched ("bring the red mug and *leave the green
one*", "*leave the plates where they are*")."""

from __future__ import annotations

from collections.abc import Iterator

from decomplex_bt.understanding.cue_phrases import CONDITIONAL
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks

_OTHERS = frozenset("one ones other others rest remainder".split())
"""What stands for those of several things that nothing is to be done with."""
_OPENING = MARKS | frozenset("and but then just please so or do".split())
_GOING_ON = MARKS | frozenset(("and", "but"))
_THINGS = frozenset(("it", "them", "that", "those", "these", "this"))
_WHERE = frozenset(("where", "as", "how"))
_SUBJECTS = frozenset("it they that those these".split())
_BE = frozenset("is are 's 're".split())
_GOING = frozenset("go walk come head run drive return".split())
"""Behind these what is left is left where one has gone."""
_DEFINITE = frozenset(("DT", "PRP$", "PDT"))


def spared(observed: Observed) -> tuple[int, ...]:
    """The verbs of what is to be left as it is, in a sentence without a case, beside other orders: no word of the
    clause says a state or another place. With no place said it is what "one", "the others" or the like stands
    for, is told behind a "but", or is a thing known to be carried that nothing ahead could have moved."""
    document = observed.document
    if "leave" not in document.words:
        return ()
    return tuple(
        i
        for i in _leavings(document)
        if _is_spared(observed, i) and (_is_besides(document, i) or not _is_conditional(observed, i))
    )


def _leavings(document: Document) -> Iterator[int]:
    tokens = document.tokens
    for i, token in enumerate(tokens):
        is_order = token.lower == "leave" and token.tag in ("VB", "VBP", "NNP", "NN")
        if is_order and (_begins_sentence(document, i) or tokens[i - 1].lower in _OPENING):
            yield i


def _is_besides(document: Document, verb: int) -> bool:
    """Whether a "but" sets something that was not named before against what is done, be that in a case: "if it's hot,
    bring the tea, *but leave the fork where it is*"."""
    tokens = document.tokens
    joint = verb - 1 - (verb > 1 and tokens[verb - 1].lower == "do")
    thing = _thing(document, verb + 1)
    if joint < 0 or tokens[joint].lower != "but" or not thing or not _is_where_it_is(document, thing.stop):
        return False
    head = tokens[thing.stop - 1]
    return head.pos in ("NOUN", "PROPN") and all(token.lemma != head.lemma for token in tokens[:joint])


def _begins_sentence(document: Document, i: int) -> bool:
    return i == 0 or document.sentences[i] != document.sentences[i - 1]


def _is_conditional(observed: Observed, verb: int) -> bool:
    """Whether a case in its sentence, or a question right before that, may say when it is left."""
    sentences = observed.document.sentences
    start = sentences.index(sentences[verb])
    is_answer = start > 0 and observed.document.tokens[start - 1].text == "?"
    cases = (cue.first for cue in observed.cues if cue.name in CONDITIONAL)
    return is_answer or any(sentences[case] == sentences[verb] for case in cases)


def _is_spared(observed: Observed, verb: int) -> bool:
    document, tokens = observed.document, observed.document.tokens
    thing = _thing(document, verb + 1)
    if not thing:
        return False
    if _is_where_it_is(document, thing.stop):
        return True
    if not _ends(document, thing.stop) or tokens[thing.start].tag not in _DEFINITE:
        return False
    head = tokens[thing.stop - 1]
    category = observed.gazetteer.category(head.lemma)
    if category == "room" or head.pos == "PROPN":
        return False
    ahead = [t for t in tokens[:verb] if document.sentences[t.i] == document.sentences[verb]]
    if any(token.lemma in _GOING and token.pos == "VERB" for token in ahead):
        return False
    is_other = any(token.lower in _OTHERS for token in tokens[thing.start : thing.stop])
    is_beside = verb > 0 and tokens[verb - 1].lower == "but"
    is_first = verb == 0 and category == "thing" and thing.stop < len(tokens) - 1
    return (is_other and verb > 0) or is_beside or is_first


def _thing(document: Document, start: int) -> range:
    """The phrase that begins at a token: a pronoun, or a noun with an "of" behind it; empty where none does."""
    tokens = document.tokens
    if start < len(tokens) and tokens[start].lower in _THINGS and tokens[start].pos == "PRON":
        return range(start, start + 1)
    chunks = [chunk for chunk in noun_chunks(document) if chunk.start >= start]
    first = next((chunk for chunk in chunks if chunk.start == start), None)
    if first is None:
        return _one(document, start)
    of = first.stop
    if of < len(tokens) and tokens[of].lower == "of":
        whole = next((chunk for chunk in chunks if chunk.start == of + 1), None)
        return range(start, whole.stop) if whole is not None else range(0)
    if of < len(tokens) and tokens[of].lower in _OTHERS:
        return range(start, of + 1)
    return first


def _one(document: Document, start: int) -> range:
    """A phrase that ends in "one" or "others", which the tagger takes for no noun."""
    tokens = document.tokens
    for i in range(start, min(start + 4, len(tokens))):
        if tokens[i].lower in _OTHERS and (i + 1 == len(tokens) or tokens[i + 1].lower not in _OTHERS):
            return range(start, i + 1) if i > start else range(0)
        if tokens[i].pos not in ("DET", "ADJ", "PRON", "NOUN", "NUM") and tokens[i].tag not in _DEFINITE:
            return range(0)
    return range(0)


def _ends(document: Document, i: int) -> bool:
    return i >= len(document) or document.tokens[i].lower in _GOING_ON or _begins_sentence(document, i)


def _is_where_it_is(document: Document, i: int) -> bool:
    """Whether "where it is" or "as they are" stands at a token and ends the clause."""
    words = [token.lower for token in document.tokens[i : i + 3]]
    is_told = len(words) == 3 and words[0] in _WHERE and words[1] in _SUBJECTS and words[2] in _BE
    return is_told and _ends(document, i + 3)
