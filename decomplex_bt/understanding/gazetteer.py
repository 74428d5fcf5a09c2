"""The domain's words as hints for the language models: what a verb tends to mean, what kind of thing a noun names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.domain.lexicon import Lexicon
from decomplex_bt.understanding.document import Document


@dataclass(frozen=True)
class Gazetteer:
    """`verbs`: lemma or "lemma particle" to task types, likeliest first; `nouns`: head word to category ("thing",
    "furniture", "room", ...); `states`: words of state; `changeable`: head word to the state pairs its things have;
    `pairs`: word of state to its state pair; `ending`: verbs as in `verbs` to the task type that ends where the verb
    itself says ("throw away", "come back"); `colours`: words of colour; `containers`: words for what has an inside."""

    verbs: Mapping[str, tuple[str, ...]]
    nouns: Mapping[str, str]
    states: frozenset[str]
    changeable: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    pairs: Mapping[str, str] = field(default_factory=dict)
    ending: Mapping[str, str] = field(default_factory=dict)
    colours: frozenset[str] = frozenset()
    containers: frozenset[str] = frozenset()

    @cached_property
    def names(self) -> frozenset[str]:
        """The nouns that are no verbs."""
        return frozenset(self.nouns.keys() - self.verbs.keys())

    @classmethod
    def of(cls, lexicon: Lexicon, kinds: Kinds) -> Gazetteer:
        nouns: dict[str, str] = {}
        for kind in kinds.kinds.values():
            for phrase in kind.words:
                nouns.setdefault(phrase.split()[-1].lower(), kind.category)
        states = {value for pair in kinds.state_pairs.values() for value in pair.values}
        states |= {word for pair in kinds.state_pairs.values() for words in pair.words.values() for word in words}
        changeable: dict[str, set[str]] = {}
        for kind in kinds.kinds.values():
            for phrase in kind.words:
                changeable.setdefault(phrase.split()[-1].lower(), set()).update(kind.states)
        pairs: dict[str, str] = {}
        for name, pair in kinds.state_pairs.items():
            for value in pair.values:
                for word in (value, *pair.words.get(value, ())):
                    pairs.setdefault(word, name)
        return cls(
            {verb: sense.tasks for verb, sense in lexicon.verbs.items()},
            nouns,
            frozenset(states),
            {word: tuple(sorted(names)) for word, names in changeable.items()},
            pairs,
            {verb: sense.tasks[0] for verb, sense in lexicon.verbs.items() if sense.goal is not None},
            frozenset(lexicon.colours),
            frozenset(word.lower() for kind in kinds.kinds.values() if kind.is_container for word in kind.words),
        )

    def senses(self, document: Document, i: int) -> tuple[str, ...]:
        """The task types of a token as a verb, with its particle, where that makes a verb of its own."""
        token = document.tokens[i]
        for lemma in dict.fromkeys((token.lemma, token.lower)):
            particle = self.particle(document, i)
            if particle is not None and f"{lemma} {particle}" in self.verbs:
                return self.verbs[f"{lemma} {particle}"]
            if lemma in self.verbs:
                return self.verbs[lemma]
        return ()

    def ending_type(self, document: Document, i: int) -> str | None:
        """The task type of a verb that itself says where it ends ("throw away", "come back"), else None."""
        token, after = document.tokens[i], document.tokens[i + 1 : i + 2]
        endings = (self.particle(document, i), after[0].lower if after else None, None)
        verbs = (lemma if end is None else f"{lemma} {end}" for lemma in (token.lemma, token.lower) for end in endings)
        return next((self.ending[verb] for verb in verbs if verb in self.ending), None)

    def particle(self, document: Document, i: int) -> str | None:
        """The particle of a phrasal verb: by the parse, else a particle word among the next four tokens."""
        for child in document.children[i]:
            if document.tokens[child].dep == "prt":
                return document.tokens[child].lower
        for token in document.tokens[i + 1 : i + 5]:
            if token.lower in PARTICLES:
                return token.lower
            if token.pos in ("VERB", "PUNCT", "CCONJ"):
                break
        return None

    def category(self, word: str) -> str:
        """The category of a noun by its lemma, "" where unknown."""
        return self.nouns.get(word, "")


PARTICLES = frozenset("up down on off out in away back over open shut round around together along".split())
