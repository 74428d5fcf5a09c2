"""Observation features of single tokens: pure functions from a document to dictionaries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cues import GOVERNING, Cue, find_cues
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.gazetteer import Gazetteer


@dataclass(frozen=True)
class Observed:
    """A document with what every feature function needs of it, computed once."""

    document: Document
    gazetteer: Gazetteer

    @cached_property
    def cues(self) -> tuple[Cue, ...]:
        return find_cues(self.document)

    @cached_property
    def cue_names(self) -> tuple[tuple[str, ...], ...]:
        """For every token the classes of the cues it is part of."""
        names: list[list[str]] = [[] for _ in self.document.tokens]
        for cue in self.cues:
            for i in range(cue.first, cue.last + 1):
                names[i].append(cue.name)
        return tuple(map(tuple, names))

    @cached_property
    def senses(self) -> tuple[tuple[str, ...], ...]:
        return tuple(self.gazetteer.senses(self.document, i) for i in range(len(self.document)))

    @cached_property
    def nearest_cue(self) -> tuple[tuple[str, int], ...]:
        """For every token the last cue that is no part of it to its left within the sentence, with the distance
        capped at 6."""
        result: list[tuple[str, int]] = []
        last: Cue | None = None
        starting = {cue.first: cue for cue in self.cues if cue.name in _MARKING}
        for i in range(len(self.document)):
            if i and self.document.sentences[i] != self.document.sentences[i - 1]:
                last = None
            result.append(("", 0) if last is None else (last.name, min(6, i - last.last)))
            last = starting.get(i, last)
        return tuple(result)

    @cached_property
    def verbs_since_cue(self) -> tuple[str, ...]:
        """For every token the last governing cue before it in the sentence, with how many verbs stand between (at
        most 3)."""
        governing = {cue.last: cue.name for cue in self.cues if cue.name in _CLAUSE_OPENING}
        result: list[str] = []
        cue, verbs = "none", 0
        for token in self.document.tokens:
            if token.i and self.document.sentences[token.i] != self.document.sentences[token.i - 1]:
                cue, verbs = "none", 0
            result.append(f"{cue}.{min(3, verbs)}")
            if token.i in governing:
                cue, verbs = governing[token.i], 0
            elif token.pos in ("VERB", "AUX") and token.tag != "MD" and token.dep not in ("aux", "auxpass"):
                verbs += 1
        return tuple(result)

    @cached_property
    def reported(self) -> tuple[str, ...]:
        """For every token how it lies to the last verb of telling in its sentence: the word that opens what is told
        ("that", "to", "if", ...), how many verbs came since, and whether a comma or "and" stands between; "none" where
        there is no such verb."""
        result: list[str] = []
        state, opening, verbs, broken = "none", "", 0, ""
        for token in self.document.tokens:
            if token.i and self.document.sentences[token.i] != self.document.sentences[token.i - 1]:
                state = "none"
            result.append("none" if state == "none" else f"{opening}.{min(2, verbs)}.{broken}")
            is_verb = token.pos in ("VERB", "AUX")
            if is_verb and self.senses[token.i][:1] == ("informing",):
                state, opening, verbs, broken = "told", "", 0, ""
            elif state != "none":
                opening = opening or (token.lower if token.lower in _OPENING else "")
                verbs += is_verb and token.dep not in ("aux", "auxpass")
                broken = broken or ("," if token.text in (",", ":") else "and" if token.lower == "and" else "")
        return tuple(result)

    @cached_property
    def first_words(self) -> tuple[str, ...]:
        """For every token the first word of its sentence."""
        result: list[str] = []
        for token in self.document.tokens:
            is_first = not token.i or self.document.sentences[token.i] != self.document.sentences[token.i - 1]
            result.append(token.lower if is_first else result[-1])
        return tuple(result)

    @cached_property
    def question(self) -> tuple[bool, ...]:
        """For every token whether its sentence ends in a question mark."""
        asking = {
            number
            for number, token in zip(self.document.sentences, self.document.tokens, strict=True)
            if "?" in token.text
        }
        return tuple(number in asking for number in self.document.sentences)


_MARKING = GOVERNING | {
    "so",
    "else",
    "fail",
    "before",
    "after",
    "until",
    "then",
    "after_that",
    "before_that",
    "either_way",
    "while",
}
_CLAUSE_OPENING = GOVERNING | {"so", "else", "fail", "before", "after", "until", "even_if"}
_OPENING = frozenset("that to if whether what where when how why who which about i he she they it we there".split())
_COPULA = frozenset(("be", "'s", "is", "are", "'re", "was", "were", "s", "isnt", "arent"))


def word_features(observed: Observed, i: int) -> Features:
    """What the token is: its forms, tags and place in the parse (the paper's linguistic features, section III-B)."""
    token = observed.document.tokens[i]
    head = observed.document.tokens[token.head]
    return {
        "bias": 1.0,
        "lower": token.lower,
        "lemma": token.lemma,
        "tag": token.tag,
        "pos": token.pos,
        "dep": token.dep,
        "suffix": token.lower[-3:],
        "head": head.lemma,
        "head.pos": head.pos,
        "dep.head": f"{token.dep}.{head.pos}",
    }


def window_features(observed: Observed, i: int, reach: int = 2) -> Features:
    """The words and tags around the token; "^" and "$" stand for the instruction's ends."""
    tokens = observed.document.tokens
    features: Features = {}
    for offset in range(-reach, reach + 1):
        if offset == 0:
            continue
        j = i + offset
        if 0 <= j < len(tokens):
            features[f"{offset}:lower"] = tokens[j].lower
            features[f"{offset}:tag"] = tokens[j].tag
        else:
            features[f"{offset}:lower"] = "^" if j < 0 else "$"
    return features


def verb_features(observed: Observed, i: int) -> Features:
    """What the domain's words say of the token as a verb, alone and with what the parse hangs on it."""
    document = observed.document
    token = document.tokens[i]
    features: Features = {}
    for rank, sense in enumerate(observed.senses[i][:3]):
        features[f"sense.{sense}"] = 1.0
        if rank == 0:
            features["sense"] = sense
    if observed.senses[i]:
        features["sense.tag"] = f"{observed.senses[i][0]}.{token.tag}"
        particle = observed.gazetteer.particle(document, i)
        if particle:
            features["particle"] = particle
            features["lemma.particle"] = f"{token.lemma}.{particle}"
    if token.lower in observed.gazetteer.states:
        features["state"] = 1.0
    if token.lower in _COPULA or token.lemma == "be":
        features["copula"] = 1.0
    category = observed.gazetteer.category(token.lemma)
    if category:
        features["noun"] = category
    return features


def clause_features(observed: Observed, i: int) -> Features:
    """Where the token stands in its clause: dependents, subject, auxiliaries, cues before it, sentence and its mood."""
    document = observed.document
    features: Features = {}
    for child in document.children[i]:
        kid = document.tokens[child]
        features[f"child.{kid.dep}"] = 1.0
        if kid.dep in ("nsubj", "nsubjpass", "expl"):
            features["subject"] = kid.lower if kid.tag in ("PRP", "EX", "DT", "WP", "WDT", "NN") else kid.tag
        elif kid.dep in ("aux", "mark", "neg", "prt", "dative", "prep", "cc"):
            features[f"{kid.dep}"] = kid.lower
        elif kid.dep in ("dobj", "attr", "acomp", "pobj"):
            features[f"{kid.dep}.noun"] = observed.gazetteer.category(kid.lemma) or kid.tag
    for distance, above in enumerate(document.ancestors(i)):
        features[f"above.{distance}"] = document.tokens[above].lemma
        if distance == 1:
            break
    cue, gap = observed.nearest_cue[i]
    features["cue"] = cue
    features["cue.gap"] = f"{cue}.{gap}"
    features["cue.tag"] = f"{cue}.{document.tokens[i].tag}"
    since = observed.verbs_since_cue[i]
    features["since"] = since
    features["since.tag"] = f"{since}.{document.tokens[i].tag}"
    features["since.lemma"] = f"{since}.{document.tokens[i].lemma}"
    features["since.sense"] = f"{since}.{observed.senses[i][0] if observed.senses[i] else ''}"
    features["since.subject"] = f"{since}.{features.get('subject', 'none')}.{document.tokens[i].tag}"
    features["reported"] = observed.reported[i]
    features["reported.tag"] = f"{observed.reported[i]}.{document.tokens[i].tag}"
    features["first_word"] = observed.first_words[i]
    if i and document.sentences[i] == document.sentences[i - 1]:
        features["question"] = observed.question[i]
    else:
        features["sentence_start"] = 1.0
        features["start.question"] = str(observed.question[i])
    return features


def cue_features(observed: Observed, i: int) -> Features:
    """The cues the token and its neighbours are part of."""
    features: Features = {}
    for offset in (-1, 0, 1):
        if 0 <= i + offset < len(observed.document):
            for name in observed.cue_names[i + offset]:
                features[f"cue{offset:+d}.{name}"] = 1.0
    return features


def verb_context_features(observed: Observed, i: int) -> Features:
    """The verbs to either side: whether the token introduces another verb or is introduced by one ("go and get")."""
    features: Features = {}
    for name, steps in (
        ("verb_before", range(i - 1, max(-1, i - 8), -1)),
        ("verb_after", range(i + 1, min(len(observed.document), i + 8))),
    ):
        for distance, j in enumerate(steps, start=1):
            if observed.document.sentences[j] != observed.document.sentences[i]:
                break
            if observed.senses[j] and observed.document.tokens[j].pos in ("VERB", "AUX", "NOUN"):
                features[name] = observed.senses[j][0]
                features[f"{name}.gap"] = min(distance, 4)
                features[f"{name}.lemma"] = observed.document.tokens[j].lemma
                break
    return features


def task_features(observed: Observed) -> list[Features]:
    """The features of the task CRF, one dictionary a token."""
    return [
        {
            **word_features(observed, i),
            **window_features(observed, i),
            **verb_features(observed, i),
            **clause_features(observed, i),
            **cue_features(observed, i),
            **verb_context_features(observed, i),
        }
        for i in range(len(observed.document))
    ]


def argument_features(observed: Observed, tasks: Mapping[int, str]) -> list[Features]:
    """The features of the argument CRF; `tasks` maps token indices to task types."""
    places = sorted(tasks)
    return [
        {
            **word_features(observed, i),
            **window_features(observed, i),
            **noun_features(observed, i),
            **cue_features(observed, i),
            **owner_features(observed, i, places, tasks),
        }
        for i in range(len(observed.document))
    ]


def plain_argument_features(observed: Observed) -> list[Features]:
    """The argument features without anything of the tasks (the paper's first baseline, section IV-B)."""
    return [
        {**word_features(observed, i), **window_features(observed, i), **noun_features(observed, i)}
        for i in range(len(observed.document))
    ]


def noun_features(observed: Observed, i: int) -> Features:
    """What kind of thing the token names, and the preposition it hangs on."""
    document = observed.document
    token = document.tokens[i]
    features: Features = {}
    category = observed.gazetteer.category(token.lemma)
    if category:
        features["noun"] = category
    if token.lower in observed.gazetteer.states:
        features["state"] = 1.0
    for distance, above in enumerate(document.ancestors(i)):
        if document.tokens[above].pos == "ADP":
            features["preposition"] = document.tokens[above].lower
            break
        if document.tokens[above].pos in ("VERB", "AUX") or distance == 3:
            break
    for offset in (1, 2, 3):
        if i + offset < len(document):
            ahead = observed.gazetteer.category(document.tokens[i + offset].lemma)
            if ahead:
                features["noun.ahead"] = ahead
                break
    return features


def owner_features(observed: Observed, i: int, places: Sequence[int], tasks: Mapping[int, str]) -> Features:
    """How the token lies to the tasks around it: types, distances, what separates them, which one governs it."""
    document = observed.document
    features: Features = {}
    if i in tasks:
        features["task"] = tasks[i]
    before = next((p for p in reversed(places) if p < i), None)
    after = next((p for p in places if p > i), None)
    separators = {}
    for name, place in (("before", before), ("after", after)):
        if place is None:
            features[name] = "none"
            separators[name] = "none"
            continue
        features[name] = tasks[place]
        features[f"{name}.lemma"] = document.tokens[place].lemma
        features[f"{name}.gap"] = min(8, abs(i - place))
        separators[name] = _separator(observed, min(i, place), max(i, place))
        features[f"{name}.separator"] = separators[name]
        features[f"{name}.type.tag"] = f"{tasks[place]}.{document.tokens[i].tag}"
    features["separators"] = f"{separators['before']}|{separators['after']}"
    features["types"] = f"{features['before']}|{features['after']}"
    path = [document.tokens[i].dep]
    for above in document.ancestors(i):
        if above in tasks:
            side = "before" if above == before else "after" if above == after else "other"
            features["governor"] = side
            features["governor.type"] = f"{side}.{tasks[above]}"
            features["path"] = f"{side}." + ".".join(path[-3:])
            features["path.type"] = f"{tasks[above]}." + ".".join(path[-3:])
            break
        path.append(document.tokens[above].dep)
        if len(path) > 6:
            break
    return features


def _separator(observed: Observed, left: int, right: int) -> str:
    """What stands between two tokens: a sentence end, a governing cue, a comma with "and", ..., in that order."""
    document = observed.document
    if document.sentences[left] != document.sentences[right]:
        return "sentence"
    between = range(left + 1, right)
    names = {name for j in between for name in observed.cue_names[j]}
    for name in (
        "if",
        "only_if",
        "unless",
        "when",
        "whether",
        "before",
        "after",
        "until",
        "else",
        "fail",
        "so",
        "then",
    ):
        if name in names:
            return name
    words = {document.tokens[j].lower for j in between}
    comma = "," if words & {",", "-", "–", "—", ":"} else ""
    for word in ("and", "but", "or", "that", "to"):
        if word in words:
            return comma + word
    return comma or "none"
