"""The nouns of a house: which entities a word may name, with plurals, and which words look like an unknown one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from decomplex_bt.domain.house import House
from decomplex_bt.domain.kinds import Kinds

_IRREGULAR = {
    "knives": "knife", "shelves": "shelf", "bookshelves": "bookshelf", "loaves": "loaf", "children": "child",
    "men": "man", "women": "woman", "people": "person", "scarves": "scarf", "mice": "mouse", "feet": "foot",
    "dishes": "dish", "leaves": "leaf", "wives": "wife", "clothes": "garment", "clothing": "garment",
    "fruit": "piece of fruit", "cutlery": "piece of cutlery", "silverware": "piece of cutlery",
}  # fmt: skip

_ALWAYS_SINGULAR = frozenset(("news", "gas", "lens", "clothing", "fruit", "cutlery", "silverware"))
_ONE = frozenset(("a", "an", "one", "each", "every", "either", "neither", "this", "that"))
_SEVERAL_OF = frozenset(("all", "both", "some", "most", "two", "three", "four", "five", "none"))
_BEHIND_A_NOUN = frozenset(
    ("of", "in", "on", "at", "from", "with", "that", "which", "who", "next", "under", "by", "for", "near", "behind")
)


@dataclass(frozen=True)
class Nouns:
    """`entities`: word or phrase (lower case, singular or as it is always used) to what it names, likeliest first.

    The last word of a compound names it too ("machine") where it is no name itself ("towel" is no tea towel).
    """

    entities: Mapping[str, tuple[str, ...]]

    @classmethod
    def of(cls, house: House, kinds: Kinds) -> Nouns:
        """All nouns of a house: the words of its kinds, people's names, and names of entities read as words."""
        own: dict[str, dict[str, int]] = defaultdict(dict)
        for entity in (*house.rooms, *house.places(), *house.things, *house.people):
            kind = kinds.kinds[house.kind_of(entity)]
            person = house.people.get(entity)
            # A person is named by what the house says of them; the kind's words are for those who have no name.
            words = kind.words if person is None or not person.words else person.words
            for rank, word in enumerate((*words, _spoken(entity, person is not None))):
                own[word.lower()].setdefault(entity, rank)
        found = {word: sorted(ranks, key=lambda entity: ranks[entity]) for word, ranks in own.items()}
        heads: dict[str, list[str]] = defaultdict(list)
        for word, entities in found.items():
            head = word.rpartition(" ")[2]
            if head not in found and head not in _IRREGULAR and not head.isdigit():
                heads[head].extend(entities)
        return cls({word: tuple(dict.fromkeys(entities)) for word, entities in {**found, **heads}.items()})

    def lookup(self, phrase: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The entities that a phrase (lower case) names as it stands, and those that it is a plural of.

        "glasses" is the name of one thing and the plural of others.
        """
        plurals = [entity for singular in singulars(phrase) for entity in self.entities.get(singular, ())]
        return self.entities.get(phrase, ()), tuple(dict.fromkeys(plurals))

    def nearest(self, phrase: str, among: Iterable[str] = (), *, limit: int = 3) -> tuple[str, ...]:
        """The known words (only those naming one of `among`, if given) of which the phrase may be a misspelling, best
        first."""
        # Only a word that is not known needs it.
        from rapidfuzz import fuzz, process

        allowed = frozenset(among)
        words = [word for word, entities in self.entities.items() if not allowed or allowed & set(entities)]
        matches = process.extract(phrase, words, scorer=fuzz.ratio, limit=limit, score_cutoff=ALIKE)
        return tuple(word for word, _, _ in matches)


_ANYBODY = frozenset(("somebody", "someone", "anybody", "anyone"))
_EVERY = frozenset(("all", "both", "each", "every"))
"""What is denied of these may still be so of some."""
ALIKE = 72
"""The likeness [0 to 100] from which a word may be a misspelling of another."""


def singulars(phrase: str) -> tuple[str, ...]:
    """What the phrase may be the plural of, likeliest first; empty if it does not look like a plural."""
    start, _, word = phrase.rpartition(" ")
    if word in _IRREGULAR:
        return (f"{start} {_IRREGULAR[word]}".strip(),)  # "clothes" are no cloths
    stems: list[str] = []
    if word.endswith("ies") and len(word) > 4:
        stems.append(word[:-3] + "y")
    if word.endswith("es") and len(word) > 3:
        stems.append(word[:-2])
    if word.endswith("s") and not word.endswith("ss") and len(word) > 2:
        stems.append(word[:-1])
    return tuple(f"{start} {stem}".strip() for stem in stems)


def deny(phrase: str, state: str) -> str:
    """That something is not so: "the cups are not dirty", "not both cups are dirty", "nobody is there"."""
    first, _, rest = phrase.partition(" ")
    if first.lower() in _ANYBODY:
        return f"nobody{' else' * rest.startswith('else')} is {state}"
    if first.lower() in _EVERY:
        return f"not {phrase} {be(phrase)} {state}"
    return f"{phrase} {be(phrase)} not {state}"


def be(phrase: str) -> str:
    """The form of "to be" that goes with a phrase: "my keys" are, "a box of pens" is."""
    words = phrase.split()
    if "and" in words:
        return "are"
    if not words or words[0].lower() in _ONE:
        return "is"
    end = next((i for i, word in enumerate(words) if i and word in _BEHIND_A_NOUN), len(words))
    if words[end : end + 1] == ["of"] and words[0].lower() in _SEVERAL_OF:
        return be(" ".join(words[end + 1 :]))
    head = next((word for word in reversed(words[:end]) if not word.isdigit()), "")
    is_plural = head in _IRREGULAR or (head.islower() and head.endswith("s"))
    is_plural = is_plural and head not in _ALWAYS_SINGULAR
    return "are" if is_plural and not head.endswith(("ss", "us", "is", "'s", "\u2019s")) else "is"


def _spoken(entity: str, is_person: bool) -> str:
    """An entity's name as words: "coffee_table" is "coffee table", "pen_1" is "pen 1"."""
    return entity if is_person else entity.replace("_", " ")
