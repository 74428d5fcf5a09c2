"""Statements: where something is said to be, which tells nothing of another thing ("Mum is *in the kitchen*. Bring me
my jacket.")."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import ANIMALS, PERSON_NOUNS, is_pronoun

_BEING = frozenset(("be", "'s", "\u2019s"))
_NOUNS = frozenset(("NOUN", "PROPN"))
_NAMING = frozenset(("NN", "NNS", "NNP", "NNPS"))
_OWNED = frozenset("his her its their 's \u2019s '".split())
"""What may make a thing that of somebody who was spoken of, and is then with them: "take *its* leash off"."""
_PESTS = frozenset("spider wasp bee fly ant beetle bug moth mosquito snail slug frog snake squirrel fox".split())


@dataclass(frozen=True, slots=True)
class _Stated:
    """A source with the noun of which a statement tells it, and all nouns of that phrase."""

    source: FoundArgument
    subject: int
    nouns: frozenset[str]


def without_places_of_others(
    observed: Observed, tasks: Container[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without a source that a statement tells of something else: of somebody or an animal where a thing
    is fetched, or of one thing where another statement tells it of what is fetched ("the forks are *in the drawer* and
    the plates are on the rack, bring me a plate"). "The tools are in the shed, get the hammer" stays open."""
    document = observed.document
    stated = [found for a in arguments if a.type == "source" and (found := _stated(document, tasks, a)) is not None]
    strange = {id(found.source) for found in stated if _is_strange(observed, found, stated, arguments)}
    return [a for a in arguments if id(a) not in strange]


def _stated(document: Document, tasks: Container[int], source: FoundArgument) -> _Stated | None:
    """A source that a clause with "be" of its own tells, which is no task and no relative clause; else None."""
    tokens = document.tokens
    verb = tokens[source.tokens.start].head
    if tokens[verb].dep == "attr":  # "there's *a wasp on the window*"
        verb = tokens[verb].head
    if verb in tasks or tokens[verb].lemma not in _BEING:
        return None
    parts = {tokens[i].dep: i for i in document.children[verb]}
    is_there = "expl" in parts
    subject = parts.get("attr" if is_there else "nsubj")
    if subject is None or tokens[subject].tag not in _NAMING:
        return None
    words = range(min((subject, *document.children[subject])), subject + 1)
    return _Stated(source, subject, _nouns(document, words))


def _is_strange(
    observed: Observed, found: _Stated, stated: Sequence[_Stated], arguments: Sequence[FoundArgument]
) -> bool:
    """Whether what is fetched is not what a statement tells of."""
    document, owner = observed.document, found.source.owner
    things = [a.tokens for a in arguments if (a.owner, a.type) == (owner, "object")]
    if not things or any(is_pronoun(document, thing) for thing in things):
        return False
    fetched = frozenset[str]().union(*(_nouns(document, thing) for thing in things))
    if not fetched or fetched & found.nouns:
        return False
    others = [other for other in stated if other.source.owner == owner and other is not found]
    if any(other.nouns & fetched for other in others):
        # "the key is in the box and the box is *in the hall*"
        return not any(found.nouns & _nouns(document, other.source.tokens) for other in others)
    is_owned = any(document.tokens[i].lower in _OWNED for thing in things for i in thing)
    is_of_being = _is_animate(observed, found.subject)
    return is_of_being and not is_owned and not any(_is_animate(observed, i) for thing in things for i in thing)


def _nouns(document: Document, words: Sequence[int]) -> frozenset[str]:
    return frozenset(document.tokens[i].lemma.lower() for i in words if document.tokens[i].pos in _NOUNS)


def _is_animate(observed: Observed, i: int) -> bool:
    """Whether a noun names somebody or an animal."""
    token = observed.document.tokens[i]
    category = observed.gazetteer.category(token.lemma)
    is_name = token.tag in ("NNP", "NNPS") and not category and token.text[:1].isupper()
    return category == "person" or is_name or token.lemma.lower() in PERSON_NOUNS | ANIMALS | _PESTS
