"""Nouns: how the noun of a phrase is said in the singular and in the plural, with its compound."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.phrases import SO_MANY, Candidate
from decomplex_bt.understanding.vocabulary import QUANTIFIERS


def noun_of(document: Document, candidate: Candidate, *, is_plural: bool | None) -> str:
    """The head noun of a candidate with its compound ("baking tray"), in the plural or singular; None: as it is."""
    head = document.tokens[candidate.head]
    said = candidate.text.split()
    start = candidate.head
    while start and _is_in_compound(document, start - 1, candidate.head) and document.tokens[start - 1].text in said:
        start -= 1
    compound = [token.text for token in document.tokens[start : candidate.head]]
    return " ".join([*compound, _inflected(head.text, head.lemma, head.tag, is_plural)])


def _is_in_compound(document: Document, i: int, head: int) -> bool:
    """Whether a word ahead of a noun is part of what it is called: "*oven* glove", which the tagger may take for an
    adjective."""
    token = document.tokens[i]
    is_noun = token.is_noun and token.pos in ("NOUN", "PROPN", "ADJ")
    return is_noun or (token.dep == "compound" and token.head == head)


def whole_noun_of(document: Document, candidate: Candidate) -> str:
    """As `noun_of`, with its compound also where the candidate is taken up by a pronoun."""
    start = candidate.head
    while start and document.tokens[start - 1].dep == "compound" and document.tokens[start - 1].head == candidate.head:
        start -= 1
    return document.span(start, candidate.head).of(document.text)


def bare_of(document: Document, candidate: Candidate, *, is_plural: bool | None) -> str:
    """The candidate up to its head without determiner, quantity and possessor."""
    if candidate.mention or not candidate.tokens.start <= candidate.head < candidate.tokens.stop:
        return noun_of(document, candidate, is_plural=is_plural)
    start = candidate.tokens.start
    if [document.tokens[i].lower for i in candidate.tokens[:3]] in SO_MANY:
        start += 3
    for i in range(start, candidate.head):
        token = document.tokens[i]
        if token.pos in ("DET", "NUM") or token.tag in ("PRP$", "POS") or token.lower in QUANTIFIERS:
            start = i + 1
    head = document.tokens[candidate.head]
    words = [document.tokens[i].text for i in range(start, candidate.head)]
    return " ".join([*words, _inflected(head.text, head.lemma, head.tag, is_plural)])


_IN_VES = ("elf", "alf", "olf", "eaf", "oaf", "arf", "nife", "wife", "life")
"""Ends of nouns that have "ves" in the plural: "shelf", "loaf", "scarf"."""
_IN_IES = frozenset("cookies brownies smoothies hoodies movies pies ties selfies".split())
"""Plurals of nouns in "ie", which the lemmatizer takes for nouns in "y"."""


def _inflected(text: str, lemma: str, tag: str, is_plural: bool | None) -> str:
    if is_plural is False and tag in ("NNS", "NNPS") and len(text) > 1:  # "s", torn off a word, is no plural
        if text.lower() in _IN_IES:
            return text[:-1]
        if text.endswith("xes"):  # "lunchboxes", which the lemmatizer does not know
            return text[:-2]
        if lemma == text.lower() and text.endswith("s") and not text.endswith("ss"):
            return text[:-1]
        return lemma if text.islower() else text[: len(lemma)]
    if is_plural and tag == "NN" and (not text.endswith("s") or text.endswith(("ss", "us", "is"))):
        if text.endswith("y") and text[-2:-1] not in "aeiou":
            return f"{text[:-1]}ies"
        if text.endswith(_IN_VES):
            return f"{text[: text.rindex('f')]}ves"
        return text + ("es" if text.endswith(("s", "x", "ch", "sh")) else "s")
    return text
