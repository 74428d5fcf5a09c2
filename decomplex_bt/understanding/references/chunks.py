"""Noun chunks: the phrases of a document that name something, by its tags, mended where those go wrong."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from decomplex_bt.understanding.document import FINITE, MARKS, Document
from decomplex_bt.understanding.references.compounds import ends_compound
from decomplex_bt.understanding.vocabulary import PREPOSITIONS, PRONOUNS, WHOLE


def noun_chunks(document: Document) -> Sequence[range]:
    """Base noun phrases by tags: determiners, possessives and modifiers up to the last noun of a run; without times
    ("pete" of "pete yesterday")."""
    return document.once(_noun_chunks)


def _noun_chunks(document: Document) -> tuple[range, ...]:
    return tuple(_chunked(document))


def _chunked(document: Document) -> Iterator[range]:
    start: int | None = None
    for i in range(len(document) + 1):
        if i < len(document) and document.tokens[i].lower not in _TIMES and _is_nominal(document, i, start is not None):
            token = document.tokens[i]
            opens = token.pos == "DET" or token.tag == "PRP$" or (token.lower in _UNNAMED and _owns(document, i))
            if opens and start is not None:
                yield from _trimmed(document, range(start, i))
                start = i
            start = i if start is None else start
            continue
        if start is not None:
            yield from _trimmed(document, range(start, i))
        start = None


_CAUSING = frozenset(("get", "have", "let"))
_BEHIND_LET = frozenset("and but then for before after while until till if unless".split())
_UNNAMED = frozenset(body + person for body in ("some", "any", "every", "no") for person in ("one", "body"))
_TIMES = frozenset("yesterday today tonight tomorrow now later".split())


def _is_nominal(document: Document, i: int, is_inside: bool) -> bool:
    token = document.tokens[i]
    if token.tag == "POS" and not is_inside:
        return False  # "where's grandpa"
    if token.pos in ("DET", "ADJ", "NOUN", "PROPN", "NUM") or token.tag in ("PRP$", "POS") or _owns(document, i):
        return True
    is_first = i == 0 or document.sentences[i - 1] != document.sentences[i]
    is_told = token.tag in ("VBN", "VBG") or (token.tag == "RB" and is_first)  # not "bring me *back* milk"
    if token.dep == "amod" and is_told and i < token.head <= i + 2:
        return document.tokens[token.head].pos in ("NOUN", "PROPN")  # "back tyre", "dried beans"
    if not is_inside or i + 1 >= len(document):
        return False
    following = document.tokens[i + 1]
    if token.text == "-":  # of a compound: no space to either side
        return document.tokens[i - 1].end == token.start and token.end == following.start
    if _is_within_compound(document, i) or ends_compound(document, i):
        return True
    return token.tag in ("VBG", "VBN") and following.pos in ("NOUN", "PROPN")


def _owns(document: Document, i: int) -> bool:
    """Whether a word is somebody unnamed, or the "else" behind one, whose thing follows ("someone else's socks");
    not one who is home ("somebody's home")."""
    tokens = document.tokens
    is_else = i > 0 and tokens[i].lower == "else" and _is_unnamed(document, i - 1)
    end = i + 1
    if _is_unnamed(document, i) and end < len(tokens) and tokens[end].lower == "else":
        end += 1
    owning = tokens[end : end + 2]
    return (
        (is_else or _is_unnamed(document, i))
        and len(owning) == 2
        and (owning[0].tag, owning[0].dep) == ("POS", "case")
        and owning[1].pos in ("NOUN", "PROPN", "ADJ", "NUM")
        and owning[1].lower != "home"
    )


def _is_unnamed(document: Document, i: int) -> bool:
    token = document.tokens[i]
    return token.lower in _UNNAMED or (token.lower == "one" and i > 0 and document.tokens[i - 1].lower == "no")


def stripped(document: Document, tokens: range) -> range:
    """The span without leading prepositions and particles ("in the drawer": "the drawer")."""
    start = tokens.start
    while start < tokens.stop - 1 and (
        document.tokens[start].pos in ("ADP", "PART", "SCONJ", "ADV") or document.tokens[start].lower in PREPOSITIONS
    ):
        if document.tokens[start].lower in PRONOUNS:
            break
        if document.tokens[start].lower == "next" and document.tokens[start + 1].lower != "to":
            break  # "next door's bin"
        start += 1
    return range(start, tokens.stop)


def head_of(document: Document, tokens: range) -> int:
    """The head of a phrase: its last noun before a preposition or clause, else its last token."""
    head = None
    for i in tokens:
        token = document.tokens[i]
        if (token.pos in ("NOUN", "PROPN", "PRON") and token.tag not in ("PRP$", "WDT")) or token.lower in _HEADS:
            head = i
        elif head is None or _is_within_compound(document, i):
            continue
        elif token.pos in ("ADP", "VERB", "AUX", "SCONJ") or token.lower in _EXCEPTING:
            break
    return tokens.stop - 1 if head is None else head_of_kin(document, head)


def _is_within_compound(document: Document, i: int) -> bool:
    """Whether hyphens tie a word to those on both its sides: the "in" of "mother-in-law"."""
    tokens = document.tokens
    return (
        0 < i < len(tokens) - 1
        and tokens[i - 1].text == tokens[i + 1].text == "-"
        and tokens[i - 1].end == tokens[i].start
        and tokens[i].end == tokens[i + 1].start
    )


def head_of_kin(document: Document, head: int) -> int:
    """The head of a phrase; of "mother-in-law" the mother."""
    is_in_law = head > 3 and document.tokens[head].lemma == "law" and _is_within_compound(document, head - 2)
    return head - 4 if is_in_law else head


def is_child(document: Document, tokens: range) -> bool:
    """Whether a phrase is of somebody's "little one", which names a child."""
    words = document.tokens[max(tokens.start, tokens.stop - 3) : tokens.stop]
    is_little = [word.lower for word in words][1:] in (["little", "one"], ["little", "ones"], ["wee", "one"])
    return is_little and words[0].tag in ("POS", "PRP$")


_EXCEPTING = frozenset(("but", "except", "excepting", "excluding"))
_HEADS = frozenset("it one ones them they him her he she there mine".split())


def whole_words(document: Document) -> Iterator[range]:
    for token in document.tokens:
        if token.lower in WHOLE:
            yield range(token.i, token.i + 1)


def coordinations(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Noun phrases in a row with nothing but commas and "and" between them ("the mop, the bucket and the cloth"); not
    where a clause of its own begins with the last one ("Tom is in *the garden and Anna* is out")."""
    start = 0
    for k in range(1, len(chunks) + 1):
        if k < len(chunks) and _is_listed(document, range(chunks[k - 1].stop, chunks[k].start)):
            continue
        if k - start > 1 and not _begins_clause(document, chunks[start], chunks[k - 1]):
            yield range(chunks[start].start, chunks[k - 1].stop)
        if k - start > 2:
            yield range(chunks[k - 2].start, chunks[k - 1].stop)
        start = k


def _begins_clause(document: Document, first: range, last: range) -> bool:
    """Whether the last noun phrase of a row is what something is said of, and the first stands behind a preposition."""
    tokens = document.tokens
    is_subject = last.stop < len(tokens) and tokens[last.stop].tag in FINITE
    return is_subject and first.start > 0 and tokens[first.start - 1].pos == "ADP"


def with_complements(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Noun phrases with one that follows after a preposition ("a bottle of stout", "someone from the council")."""
    heads = [*chunks, *whole_words(document)]
    for chunk in heads:
        after = next((c for c in chunks if c.start == chunk.stop + 1), None)
        joining = document.tokens[min(chunk.stop, len(document) - 1)]
        if after is not None and (joining.pos == "ADP" or joining.lower == "to"):
            yield range(chunk.start, after.stop + is_numbered(document, after))


def is_numbered(document: Document, chunk: range) -> bool:
    """Whether a number behind a noun phrase that something is said of tells which one: "the key to room *three* is"."""
    tags = [token.tag for token in document.tokens[chunk.stop - 1 : chunk.stop + 2]]
    return tags[:2] == ["NN", "CD"] and tags[2:] in (["VBZ"], ["VBP"], ["VBD"], ["MD"])


def without_last_word(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Noun phrases without their last word, which may be a verb that was taken for a noun ("the hose reel drips")."""
    for chunk in chunks:
        is_compound = len(chunk) > 2 and document.tokens[chunk.stop - 2].pos in ("NOUN", "PROPN")
        if is_compound and not ends_compound(document, chunk.stop - 1):
            yield range(chunk.start, chunk.stop - 1)


def _is_listed(document: Document, between: range) -> bool:
    words = [document.tokens[i].lower for i in between]
    return bool(words) and all(word in (",", "and", "or", "&") for word in words)


def between_verbs(document: Document, chunk: range, verbs: Container[int]) -> Iterator[range]:
    """The parts of a noun phrase between the verbs of tasks that were taken for nouns ("the timer *rings*")."""
    start = chunk.start
    for i in (*chunk, chunk.stop):
        if i == chunk.stop or i in verbs:
            if i > start:
                yield from _trimmed(document, range(start, i))
            start = i + 1


def _is_complement(document: Document, verb: int, at: int) -> bool:
    """Whether a word that is tagged as a noun is what a verb ahead of the phrase has done, or lets be, without which a
    "let" would say nothing: "get the lawn *mown*", "let the tea *brew*"."""
    tokens = document.tokens
    token, behind = tokens[at], tokens[at + 1].lower if at + 1 < len(tokens) else "."
    if verb < 0 or tokens[verb].lower not in _CAUSING or token.tag not in ("NN", "NNP") or not token.text.islower():
        return False
    is_let = tokens[verb].lower == "let" and (behind in MARKS or behind in _BEHIND_LET)
    return is_let or (token.dep == "ccomp" and token.head == verb)


def _trimmed(document: Document, chunk: range) -> Iterator[range]:
    nouns = [i for i in chunk if document.tokens[i].pos in ("NOUN", "PROPN") or ends_compound(document, i)]
    first, last = document.tokens[chunk.start], document.tokens[chunk.stop - 1]
    if len(nouns) > 1 and document.tokens[nouns[-1]].lower == "open":
        nouns.pop()  # "wants the window open", where the tagger takes it for a noun
    if is_child(document, chunk):
        yield chunk
    elif nouns and nouns[-1] > chunk.start + 1 and _is_complement(document, chunk.start - 1, nouns[-1]):
        yield range(chunk.start, nouns[-1])
    elif nouns:
        yield range(chunk.start, nouns[-1] + 1)
    elif first.tag == "PRP$" and len(chunk) == 2 and last.tag == "JJ" and last.lower != "own":
        yield chunk  # "wants her key back", where the tagger takes the noun for an adjective
