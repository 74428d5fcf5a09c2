"""Observation features of single tokens: pure functions from a document to dictionaries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cue_phrases import GOVERNING
from decomplex_bt.understanding.cues import Cue, find_cues
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
    def verbs_around(self) -> tuple[tuple[int | None, int | None], ...]:
        """For every token the nearest verbs of a known task to its left and right, in its sentence and at most 7
        tokens away."""
        sentences, tokens = self.document.sentences, self.document.tokens
        verbs = [i for i, t in enumerate(tokens) if self.senses[i] and t.pos in ("VERB", "AUX", "NOUN")]
        result: list[tuple[int | None, int | None]] = []
        passed = 0  # of the verbs, those before the token
        for i in range(len(tokens)):
            at = passed < len(verbs) and verbs[passed] == i
            before = verbs[passed - 1] if passed else None
            after = verbs[passed + at] if passed + at < len(verbs) else None
            result.append(
                (
                    before if before is not None and i - before < 8 and sentences[before] == sentences[i] else None,
                    after if after is not None and after - i < 8 and sentences[after] == sentences[i] else None,
                )
            )
            passed += at
        return tuple(result)

    @cached_property
    def words(self) -> tuple[Features, ...]:
        """For every token the features of its form and of its neighbours', which all token models share."""
        return tuple({**word_features(self, i), **window_features(self, i)} for i in range(len(self.document)))

    @cached_property
    def phrases(self) -> tuple[Features, ...]:
        """For every token the features of the argument model that hold whatever the tasks are."""
        return tuple({**word, **noun_features(self, i), **cue_features(self, i)} for i, word in enumerate(self.words))

    @cached_property
    def marks(self) -> tuple[int, ...]:
        """For every token what it separates its neighbours by, as bits; see `_separator`."""
        return tuple(
            sum({_CUE_BITS.get(name, 0) for name in names}) | _WORD_BITS.get(token.lower, 0)
            for token, names in zip(self.document.tokens, self.cue_names, strict=True)
        )

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
    "before_all",
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


def window_features(observed: Observed, i: int) -> Features:
    """The words and tags around the token; "^" and "$" stand for the instruction's ends."""
    tokens = observed.document.tokens
    features: Features = {}
    for offset, lower, tag in _WINDOW:
        j = i + offset
        if 0 <= j < len(tokens):
            features[lower] = tokens[j].lower
            features[tag] = tokens[j].tag
        else:
            features[lower] = "^" if j < 0 else "$"
    return features


_WINDOW = tuple((offset, f"{offset}:lower", f"{offset}:tag") for offset in (-2, -1, 1, 2))


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
    token = document.tokens[i]
    features: Features = {}
    for child in document.children[i]:
        kid = document.tokens[child]
        features[f"child.{kid.dep}"] = 1.0
        if kid.dep in ("nsubj", "nsubjpass", "expl"):
            features["subject"] = kid.lower if kid.tag in ("PRP", "EX", "DT", "WP", "WDT", "NN") else kid.tag
        elif kid.dep in ("aux", "mark", "neg", "prt", "dative", "prep", "cc"):
            features[kid.dep] = kid.lower
        elif kid.dep in ("dobj", "attr", "acomp", "pobj"):
            features[f"{kid.dep}.noun"] = observed.gazetteer.category(kid.lemma) or kid.tag
    for name, above in zip(("above.0", "above.1"), document.ancestors(i), strict=False):
        features[name] = document.tokens[above].lemma
    cue, gap = observed.nearest_cue[i]
    since, reported, senses = observed.verbs_since_cue[i], observed.reported[i], observed.senses[i]
    features["cue"] = cue
    features["cue.gap"] = f"{cue}.{gap}"
    features["cue.tag"] = f"{cue}.{token.tag}"
    features["since"] = since
    features["since.tag"] = f"{since}.{token.tag}"
    features["since.lemma"] = f"{since}.{token.lemma}"
    features["since.sense"] = f"{since}.{senses[0] if senses else ''}"
    features["since.subject"] = f"{since}.{features.get('subject', 'none')}.{token.tag}"
    features["reported"] = reported
    features["reported.tag"] = f"{reported}.{token.tag}"
    features["first_word"] = observed.first_words[i]
    if i and document.sentences[i] == document.sentences[i - 1]:
        features["question"] = observed.question[i]
    else:
        features["sentence_start"] = 1.0
        features["start.question"] = str(observed.question[i])
    return features


def cue_features(observed: Observed, i: int) -> Features:
    """The cues the token and its neighbours are part of."""
    names = observed.cue_names
    features: Features = {}
    for offset in (-1, 0, 1):
        if 0 <= i + offset < len(names):
            for name in names[i + offset]:
                features[f"cue{offset:+d}.{name}"] = 1.0
    return features


def verb_context_features(observed: Observed, i: int) -> Features:
    """The verbs to either side: whether the token introduces another verb or is introduced by one ("go and get")."""
    features: Features = {}
    before, after = observed.verbs_around[i]
    if before is not None:
        features["verb_before"] = observed.senses[before][0]
        features["verb_before.gap"] = min(i - before, 4)
        features["verb_before.lemma"] = observed.document.tokens[before].lemma
    if after is not None:
        features["verb_after"] = observed.senses[after][0]
        features["verb_after.gap"] = min(after - i, 4)
        features["verb_after.lemma"] = observed.document.tokens[after].lemma
    return features


def task_features(observed: Observed) -> list[Features]:
    """The features of the task CRF, one dictionary a token."""
    return [
        {
            **word,
            **verb_features(observed, i),
            **clause_features(observed, i),
            **cue_features(observed, i),
            **verb_context_features(observed, i),
        }
        for i, word in enumerate(observed.words)
    ]


def argument_features(observed: Observed, tasks: Mapping[int, str]) -> list[Features]:
    """The features of the argument CRF; `tasks` maps token indices to task types."""
    return [
        {**phrase, **owner} for phrase, owner in zip(observed.phrases, owner_features(observed, tasks), strict=True)
    ]


def plain_argument_features(observed: Observed) -> list[Features]:
    """The argument features without anything of the tasks (the paper's first baseline, section IV-B)."""
    return [{**word, **noun_features(observed, i)} for i, word in enumerate(observed.words)]


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


def owner_features(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Features]:
    """How each token lies to the tasks around it: types, distances, what separates them, which one governs it."""
    document = observed.document
    tokens = document.tokens
    befores, afters = _nearest(range(len(tokens)), tasks), _nearest(range(len(tokens) - 1, -1, -1), tasks)[::-1]
    separators = (
        _separators(observed, range(len(tokens)), tasks),
        _separators(observed, range(len(tokens) - 1, -1, -1), tasks)[::-1],
    )
    for i, token in enumerate(tokens):
        features: Features = {}
        if i in tasks:
            features["task"] = tasks[i]
        before, after = befores[i], afters[i]
        if before is None:
            features["before"] = "none"
        else:
            features["before"] = tasks[before]
            features["before.lemma"] = tokens[before].lemma
            features["before.gap"] = min(8, i - before)
            features["before.separator"] = separators[0][i]
            features["before.type.tag"] = f"{tasks[before]}.{token.tag}"
        if after is None:
            features["after"] = "none"
        else:
            features["after"] = tasks[after]
            features["after.lemma"] = tokens[after].lemma
            features["after.gap"] = min(8, after - i)
            features["after.separator"] = separators[1][i]
            features["after.type.tag"] = f"{tasks[after]}.{token.tag}"
        features["separators"] = f"{separators[0][i]}|{separators[1][i]}"
        features["types"] = f"{features['before']}|{features['after']}"
        path = [token.dep]
        for above in document.ancestors(i):
            if above in tasks:
                side = "before" if above == before else "after" if above == after else "other"
                last = ".".join(path[-3:])
                features["governor"] = side
                features["governor.type"] = f"{side}.{tasks[above]}"
                features["path"] = f"{side}.{last}"
                features["path.type"] = f"{tasks[above]}.{last}"
                break
            path.append(tokens[above].dep)
            if len(path) > 6:
                break
        yield features


def _nearest(places: range, tasks: Mapping[int, str]) -> list[int | None]:
    """Of each token, in the order of `places`, the nearest task passed so far."""
    result: list[int | None] = []
    last: int | None = None
    for i in places:
        result.append(last)
        if i in tasks:
            last = i
    return result


def _separators(observed: Observed, places: range, tasks: Mapping[int, str]) -> list[str]:
    """Of each token, in the order of `places`, what stands between it and the task passed last: a sentence end, a
    governing cue, a comma with "and", ..., in that order; "none" where no task was passed."""
    sentences, marks = observed.document.sentences, observed.marks
    result: list[str] = []
    last, passed = -1, 0
    for i in places:
        result.append("none" if last < 0 else "sentence" if sentences[i] != sentences[last] else _separator(passed))
        if i in tasks:
            last, passed = i, 0
        else:
            passed |= marks[i]
    return result


_CUES = ("if", "only_if", "unless", "when", "whether", "before", "after", "until", "else", "fail", "so", "then")
_WORDS = ("and", "but", "or", "that", "to")
_CUE_BITS = {name: 1 << rank for rank, name in enumerate(_CUES)}
_WORD_BITS = {word: 1 << rank for rank, word in enumerate(_WORDS, start=len(_CUES))}
_COMMA = 1 << len(_CUES) + len(_WORDS)
_WORD_BITS |= dict.fromkeys((",", "-", "–", "—", ":"), _COMMA)


def _separator(passed: int) -> str:
    """What separates most of all that was passed, given as bits."""
    cue = next((name for name in _CUES if passed & _CUE_BITS[name]), None)
    if cue is not None:
        return cue
    comma = "," if passed & _COMMA else ""
    word = next((word for word in _WORDS if passed & _WORD_BITS[word]), None)
    return comma or "none" if word is None else comma + word
