"""Spellings: how what fills a gap is put into words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.instruction import Argument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.references.chunks import stripped
from decomplex_bt.understanding.references.gaps import COUNTS, DETERMINERS, OWN, Gap, head_in
from decomplex_bt.understanding.references.nouns import bare_of, noun_of, whole_noun_of
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import ONES, QUANTIFIERS

_POSSESSIVES = ("'s", "\u2019s")
_NUMBERS = COUNTS - {"one", "few", "couple", "pair"}
_FURTHER = frozenset(("other", "more", "another"))
_DEMONSTRATIVES = frozenset("this that these those".split())
_SHARED = frozenset(("any", "some", "one"))
_OWNING = frozenset("my your his her its our their".split())
_KNOWN = frozenset("the these those all both".split())


def filled(document: Document, argument: Argument, gap: Gap, text: str) -> str:
    """An argument's value where its gap is filled with a text: that, or the argument's words with it in their place."""
    if gap.form != "joined" or argument.span is None:
        return text
    tokens = stripped(document, document.indices(argument.span))
    before, after = range(tokens.start, gap.tokens.start), range(gap.tokens.stop, tokens.stop)
    return " ".join(
        [*([_text(document, before)] if before else ()), text, *([_text(document, after)] if after else ())]
    )


def part_of(document: Document, argument: Argument, gap: Gap, value: str) -> dict[str, str]:
    """What words for a part of what is told by a pronoun ("one of them") say with its value ("one of the plates"), and
    what "the blue one" does ("the blue plate")."""
    if gap.form == "one" and len(gap.tokens) > 1:
        return {_text(document, gap.tokens).lower(): value}
    if gap.form != "part" or argument.span is None:
        return {}
    said = _text(document, stripped(document, document.indices(argument.span)))
    number, joined, _ = said.rpartition(" of ")
    is_whole = not joined or value.lower().startswith(f"{number.lower()} of ")
    return {said.lower(): value if is_whole else f"{number} of {value}"}


def spellings(document: Document, gap: Gap, candidate: Candidate) -> Iterator[tuple[str, str]]:
    """How a candidate may be put into words for a gap, each with the name of the way."""
    if gap.form in ("part", "rest", "measure", "half"):
        return _of_shares(document, gap, candidate)
    if gap.form in ("sort", "told", "kind", "own"):
        return _of_kinds(document, gap, candidate)
    return _of_things(document, gap, candidate)


def _is_open(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate is told as something not known: "any milk", "a cup"."""
    first = document.tokens[candidate.tokens.start].lower
    return first in QUANTIFIERS | {"a", "an"} and len(candidate.tokens) > 1


def _of_shares(document: Document, gap: Gap, candidate: Candidate) -> Iterator[tuple[str, str]]:
    """How a share is worded: "half of it", "the rest", "a slice"."""
    text, is_open, words = candidate.text, _is_open(document, candidate), _text(document, gap.tokens)
    first = text.split()[0].lower()
    bare = bare_of(document, candidate, is_plural=None)
    if gap.form == "rest":
        is_known = first in DETERMINERS - COUNTS or candidate.mention
        whole = f"the {bare}" if is_open else text if is_known else _definite(document, candidate)
        yield f"{words} of {whole}", "of"
    elif gap.form == "measure":
        yield f"{words} of {bare}", "counted.bare"
        if not is_open:
            yield f"{words} of {text}", "of"
    elif gap.form == "half":
        is_told = first in DETERMINERS or text.split()[0].endswith(_POSSESSIVES)
        yield f"half of {text if is_told else f'the {text}'}", "of"
    else:
        whole = bare if is_open else text  # of "any milk", "a cup of milk"
        if is_open and first == "some" and text.split()[1] == "of":
            whole = text.split(" ", 2)[2]  # of "some of the milk"
        yield f"{_text(document, gap.tokens[:-1])} {whole}", "of"
        share = document.tokens[gap.tokens.start]
        is_amount = share.lower in ("some", "any", "few") or (share.pos == "NUM" and share.lower != "one")
        if len(gap.tokens) == 3 and is_amount:
            is_told_bare = candidate.mention and first not in DETERMINERS  # "new ones"
            yield f"{share.text} {text if is_told_bare else bare}", "counted"
        yield text, "same"


def _of_kinds(document: Document, gap: Gap, candidate: Candidate) -> Iterator[tuple[str, str]]:
    """How a thing of a kind is worded whose noun was said before: "any that leak", "the spare", "white", "mine"."""
    noun, words = noun_of(document, candidate, is_plural=None), _text(document, gap.tokens)
    if gap.form == "sort":
        if candidate.shape == "pair":  # "those with lids" of a cup and a plate are of neither kind
            return
        share = "the" if gap.word == "those" else _text(document, gap.tokens[:1])
        bare = bare_of(document, candidate, is_plural=gap.word == "those" or None)
        yield f"{share} {bare} {_text(document, gap.tokens[1:])}", "modified.long"
    elif gap.form == "told":
        yield f"{words} {noun}", "modified"
        yield f"{words} {noun_of(document, candidate, is_plural=False)}", "modified.one"
        yield f"{words} {noun.split()[-1]}", "modified.head"
    elif gap.form == "kind":
        yield f"{gap.word} {noun}", "kind"
    else:
        owned = whole_noun_of(document, candidate) if gap.word == "'s" else noun
        yield f"{OWN.get(gap.word) or words} {owned}", "own"
        yield candidate.text, "same"


def _of_things(document: Document, gap: Gap, candidate: Candidate) -> Iterator[tuple[str, str]]:
    """How a thing is worded that a pronoun, a number or "one" takes up."""
    text = candidate.text
    is_further = any(document.tokens[i].lower == "another" for i in gap.tokens[:1])
    is_named = document.tokens[candidate.head].lower not in QUANTIFIERS  # no "six any" of "any of the plums"
    is_quantity = gap.word in ("ones", "some", "any") or (gap.word in ("more", "enough") and len(gap.tokens) == 1)
    if is_named and (gap.form == "count" or is_quantity or is_further):
        words = _text(document, range(gap.tokens.start, _last_modifier(gap) + 1))
        if gap.form == "count" and document.tokens[gap.tokens.start].lower == "a":
            words += " of" if gap.word in ("couple", "pair") else ""
        is_plural = False if is_further else True if gap.form == "count" else None
        yield f"{words} {noun_of(document, candidate, is_plural=is_plural)}", "counted"
        yield f"{words} {bare_of(document, candidate, is_plural=is_plural)}", "counted.bare"
        if (complement := _complement(document, candidate)) and gap.form == "count":
            yield f"{words} {bare_of(document, candidate, is_plural=is_plural)} {complement}", "counted.long"
    if is_named and len(gap.tokens) == 1 and gap.word in _SHARED and _is_known_several(document, candidate):
        yield f"{_text(document, gap.tokens)} of {text}", "shared"
    if number := numbered_of(document, gap):
        yield f"{number} {noun_of(document, candidate, is_plural=True)}", "counted"
    modifiers = range(gap.tokens.start, head_in(document, gap.tokens)) if gap.tokens else range(0)
    if gap.form == "one" and any(document.tokens[i].lower not in _DEMONSTRATIVES for i in modifiers):
        words = _text(document, modifiers)
        is_plural = gap.word == "ones"
        after = range(head_in(document, gap.tokens) + 1, gap.tokens.stop)
        if after:
            yield (
                f"{words} {noun_of(document, candidate, is_plural=is_plural)} {_text(document, after)}",
                "modified.long",
            )
        if after and len(modifiers) == 1:  # nothing else tells "the one with the handle" from any other
            return
        yield f"{words} {noun_of(document, candidate, is_plural=is_plural)}", "modified"
        bare = bare_of(document, candidate, is_plural=is_plural)
        yield f"{words} {bare}", "modified.bare"
        yield f"{words} {noun_of(document, candidate, is_plural=is_plural).split()[-1]}", "modified.head"
    elif gap.word == "other" or gap.word == "others":
        yield f"the other {noun_of(document, candidate, is_plural=gap.word == 'others')}", "other"
    if gap.word in ("one", "another", "that", "it") and gap.form in ("one", "pronoun"):
        bare = bare_of(document, candidate, is_plural=False)
        article = "an" if bare[:1].lower() in "aeiou" else "a"
        if gap.word == "one" or text.lower().startswith("one "):
            yield f"{article} {bare}", "a"
        if gap.word == "one":
            yield f"one {bare}", "one"
    yield text, "same"
    if _is_open(document, candidate):
        yield bare_of(document, candidate, is_plural=None), "bare"


def _definite(document: Document, candidate: Candidate) -> str:
    """A candidate with an article where it is told without one: "the tomatoes" of "tomatoes", but a name."""
    first = document.tokens[candidate.tokens.start]
    is_owned = any(mark in candidate.text for mark in _POSSESSIVES)  # "mum's cake"
    is_bare = first.pos not in ("DET", "PROPN") and first.tag != "PRP$" and not is_owned
    return f"the {candidate.text}" if is_bare else candidate.text


def _is_known_several(document: Document, candidate: Candidate) -> bool:
    """Whether a candidate is several known things: "the mugs", "all her plants"."""
    first = candidate.text.split()[0].lower()
    is_known = first in _KNOWN | _OWNING or any(f"{mark} " in candidate.text for mark in _POSSESSIVES)
    return is_known and document.tokens[candidate.head].tag in ("NNS", "NNPS")


def _complement(document: Document, candidate: Candidate) -> str:
    """What a candidate has behind its head: "of toilet paper"."""
    if candidate.mention or candidate.head + 1 >= candidate.tokens.stop:
        return ""
    return _text(document, range(candidate.head + 1, candidate.tokens.stop))


def numbered_of(document: Document, gap: Gap) -> str:
    """So many further things of a kind: the "two" of "*the other two*" or "*two more*"; else ""."""
    words = [document.tokens[i].lower for i in gap.tokens]
    numbers = [word for word in words if word in _NUMBERS]
    return numbers[0] if gap.form == "pronoun" and len(numbers) == 1 and not _FURTHER.isdisjoint(words) else ""


def _last_modifier(gap: Gap) -> int:
    """The last word of the gap that stays before the noun that is filled in: "two", "a few", "new" of "new ones"."""
    return gap.tokens.stop - 1 - (gap.word in ONES and len(gap.tokens) > 1)


def _text(document: Document, tokens: Sequence[int]) -> str:
    return document.text[document.tokens[tokens[0]].start : document.tokens[tokens[-1]].end]
