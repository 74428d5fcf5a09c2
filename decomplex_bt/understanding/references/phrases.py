"""Phrases: what of an instruction something may refer to, and what the words of a phrase tell of it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.amounts import is_amount
from decomplex_bt.understanding.references.chunks import (
    between_verbs,
    coordinations,
    head_of,
    head_of_kin,
    is_child,
    noun_chunks,
    stripped,
    whole_words,
    with_complements,
    without_last_word,
)
from decomplex_bt.understanding.references.compounds import AT
from decomplex_bt.understanding.references.relatives import exclusions, free_places, free_relatives
from decomplex_bt.understanding.vocabulary import (
    PERSON_NOUNS,
    POINTING,
    PREPOSITIONS,
    PRONOUNS,
    SHARES,
    TIME_UNITS,
    WHOLE,
)

_NOBODY = frozenset(("nobody", "noone"))
_BEHIND_NOBODY = frozenset("else is 's s has was will would still currently there at all".split())
_BEFORE_HOW = frozenset("a look peek glance out at me us just exactly".split())
_AMOUNTS = frozenset(("many", "much"))
_ARE = frozenset("is are was were 's 're feels looks".split())
_WHERE = AT | {"outside"}
SO_MANY = (["a", "couple", "of"], ["a", "pair", "of"])
_LONGEST_MEASURE = 3
_DEFINITE = frozenset("the my your his her our their this that".split())
_SOMEBODY = frozenset("him her them 'em em".split())
_LEADING_AWAY = frozenset("to from into onto for of off out with toward towards".split())
_NOT_REFERENTS = frozenset(("message", "manner", "state", "direction"))
_EITHER = frozenset(("either", "each"))
_NO_NOUNS = frozenset("one ones other others case cases luck joy half".split())
"""Last words of phrases that name nothing themselves ("the spare one", "in that case", "no luck")."""
_CALLS = frozenset("hey hi hello ok okay oh dear please listen right".split())
_CLAUSE_ENDS = frozenset(".?!;,:-–—") | {"and", "but", "or", "so", "if", "then", "because", "unless", "when"}


def nobody(document: Document, verb: int) -> range:
    """The "nobody" or "no one" of whom the verb at a token tells: "if *nobody* is in", "there's *no one* there"; empty
    where there is none."""
    words = [token.lower for token in document.tokens]
    before = verb - 1
    while before > 0 and words[before] in _BEHIND_NOBODY:
        before -= 1
    is_there = verb > 0 and words[verb - 1] == "there"
    for last in (before, *((verb + 1, verb + 2) if is_there else ())):
        if 0 <= last < len(words) and words[last] in _NOBODY:
            return range(last, last + 1)
        if 0 < last < len(words) and words[last - 1 : last + 1] == ["no", "one"]:
            return range(last - 1, last + 1)
    return range(0)


def degree_asked(document: Document, check: int) -> range:
    """What a check is about that asks how much something is so: "see how full *the jug* is"; empty for any other verb.
    It states nothing: that the jug be empty, only what follows can say."""
    tokens = document.tokens
    how = next((token.i for token in tokens[check + 1 :] if token.lower not in _BEFORE_HOW), None)
    if how is None or tokens[how].lower != "how" or how + 2 >= len(tokens):
        return range(0)
    adjective = how + 1
    if tokens[adjective].pos not in ("ADJ", "ADV", "VERB") or tokens[adjective].lower in _AMOUNTS:
        return range(0)
    behind = (token for token in tokens[adjective + 1 :] if token.tag != "POS")
    stop = next((token.i for token in behind if token.lower in MARKS | _ARE), len(tokens))
    is_named = tokens[adjective + 1].pos in ("DET", "PRON", "NOUN", "PROPN") and tokens[adjective + 1].lower != "to"
    is_whole = stop < len(tokens) and tokens[stop].lower in _ARE and stop > adjective + 1
    return range(adjective + 1, stop) if is_named and is_whole else range(0)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A phrase something may refer to. `tokens`: where it stands; `head`: its head word's index; `owner`: the number of
    the task whose argument it is, 0 for none; `type`: the argument's type or "outside"; `shape`: how it was cut out;
    `mention`: the word that already refers to it here, "" where it is named itself."""

    text: str
    tokens: range
    head: int
    owner: int = 0
    type: str = "outside"
    task_type: str = ""
    shape: str = "whole"
    mention: str = ""

    @property
    def anchor(self) -> int:
        """The token that stands for the phrase: its head, or the word that refers to it here."""
        return self.tokens.start if self.mention else self.head


def candidates_of(observed: Observed, tasks: Sequence[Task]) -> list[Candidate]:
    """All noun phrases of the instruction that something may refer to, from left to right; pronouns are none.

    A phrase counts whole, without what follows its head ("the mug" of "the mug next to the keyboard"), and by whose it
    is ("Ruby" of "Ruby's bag").
    """
    document = observed.document
    found: dict[tuple[int, int], Candidate] = {}
    inside: dict[int, tuple[Task, str]] = {}
    for task in tasks:
        for argument in task.arguments:
            if argument.span is None:
                continue
            tokens = document.indices(argument.span)
            inside.update(dict.fromkeys(tokens, (task, argument.type)))
            if argument.type in _NOT_REFERENTS:
                continue
            inner = stripped(document, tokens)
            if not inner or is_pointing(document, inner) or is_pronoun(document, inner) or is_placed(document, inner):
                continue
            if document.tokens[inner.start].lower == "who":  # "see *who it is*"
                continue
            if argument.type == "object" and is_amount(document, tokens):
                continue
            head = head_of(document, inner)
            short = range(inner.start, head + 1)
            shape = "whole" if len(short) == len(inner) else "long"
            if [document.tokens[i].lower for i in inner] == ["out"]:
                continue
            if document.tokens[head].lower in _NO_NOUNS and not is_child(document, inner):
                shape = "unnamed"
            found[inner.start, inner.stop] = _owned(document, inner, task, argument.type, shape)
            if shape == "long":
                found.setdefault((short.start, short.stop), _owned(document, short, task, argument.type, "short"))
    verbs = frozenset(document.indices(task.span).start for task in tasks)
    left_out = {i for excluded in exclusions(document, verbs) if excluded.is_part for i in excluded.tokens}
    chunks = [chunk for whole in noun_chunks(document) for chunk in between_verbs(document, whole, verbs)]
    for shape, phrases in (
        ("chunk", chunks),
        ("list", coordinations(document, chunks)),
        ("name", (words for name in _names(document) for words in between_verbs(document, name, verbs))),
        ("possessor", _possessors(document, chunks)),
        ("word", whole_words(document)),
        ("of", with_complements(document, chunks)),
        ("cut", without_last_word(document, chunks)),
        ("free", free_relatives(document, verbs)),
        ("free", (words for words, _ in free_places(document))),
    ):
        for named in phrases:
            phrase = _measured(document, named) if inside.keys().isdisjoint(named) else named
            if (phrase.start, phrase.stop) in found or is_pronoun(document, phrase):
                continue
            is_unnamed = document.tokens[phrase.stop - 1].lower in _NO_NOUNS and not is_child(document, phrase)
            if is_unnamed or _is_of_time(document, phrase):
                continue
            if [token.lower for token in document.tokens[phrase.start : phrase.stop + 1]] in SO_MANY:
                continue  # "*a couple* of towels"
            if is_deed(document, phrase, _DEEDS | _TRIES) or _is_grip(document, phrase):
                continue
            owner = inside.get(phrase.stop - 1)
            if (owner is None and _is_addressed(document, phrase)) or phrase.start in left_out:
                continue
            held = {inside.get(i) for i in phrase}
            if len(held) > 1:
                shape = f"across.{shape}"
            if shape.endswith("of") and _are_of_one(held):
                continue  # "put *the jam on the shelf*"
            if shape == "of" and owner is None and _is_there_somewhere(document, phrase):
                continue
            if owner is None:
                found[phrase.start, phrase.stop] = _outside(document, phrase, shape)
            else:
                found[phrase.start, phrase.stop] = _owned(document, phrase, *owner, f"in.{shape}")
    return [found[place] for place in sorted(found)]


def _measured(document: Document, phrase: range) -> range:
    """A phrase with the words ahead of it for how much or many of it there is: "*half* a loaf", "*a couple of* towels",
    "*all* the plates"."""
    before = [token.lower for token in document.tokens[max(0, phrase.start - _LONGEST_MEASURE) : phrase.start]]
    if before[-3:] in SO_MANY:
        return range(phrase.start - 3, phrase.stop)
    first = document.tokens[phrase.start]
    is_open = first.pos == "DET" or first.tag == "PRP$" or first.lower == "dozen"
    return range(phrase.start - 1, phrase.stop) if is_open and not SHARES.isdisjoint(before[-1:]) else phrase


def _are_of_one(held: set[tuple[Task, str] | None]) -> bool:
    """Whether what a phrase holds are two arguments of one task, and no other words."""
    tasks = {entry[0].id for entry in held if entry is not None}
    return None not in held and len(held) > 1 and len(tasks) == 1


def _is_there_somewhere(document: Document, phrase: range) -> bool:
    """Whether a phrase is of a thing with the place where a statement says that there is one: "there's *a bat in the
    attic*"."""
    before = [token.lower for token in document.tokens[max(0, phrase.start - 2) : phrase.start]]
    is_said = len(before) > 1 and before[0] == "there" and before[1] in _ARE
    return is_said and any(document.tokens[i].lower in _WHERE for i in phrase)


def is_deed(document: Document, phrase: range, deeds: frozenset[str] | None = None) -> bool:
    """Whether a phrase is what is done to something, as it is given that: "give it *a wipe*"; not "give me *a clean*
    cup"."""
    said = [document.tokens[i].lower for i in phrase]
    behind = document.tokens[phrase.stop : phrase.stop + 1]
    if not said or any(token.pos in ("NOUN", "PROPN", "ADJ") or token.lower in _NO_NOUNS for token in behind):
        return False
    before = [token.lower for token in document.tokens[max(0, phrase.start - _NEAR) : phrase.start]]
    giving = next((i for i, word in enumerate(before) if word in _GIVING), None)
    is_ended = giving is not None and MARKS.isdisjoint(before[giving:])
    return said[:1] == ["a"] and said[-1] in (_DEEDS if deeds is None else deeds) and len(said) > 1 and is_ended


def _is_grip(document: Document, phrase: range) -> bool:
    """Whether a phrase is only the "hold" of "get *hold* of the vet"."""
    first, behind = document.tokens[phrase.start], document.tokens[phrase.start + 1 : phrase.start + 2]
    return first.lower == "hold" and bool(behind) and behind[0].lower == "of"


def _is_of_time(document: Document, phrase: range) -> bool:
    """Whether a phrase says how long, or is of "one at *a time*": "an hour", "five more minutes"."""
    tokens = document.tokens
    before = tokens[phrase.start - 1].lower if phrase.start else ""
    if before == "at" and [tokens[i].lower for i in phrase] == ["a", "time"]:
        return True
    return tokens[phrase.stop - 1].lemma in TIME_UNITS and tokens[phrase.start].lower not in _DEFINITE


def predicates_of(observed: Observed, tasks: Sequence[Task]) -> list[Candidate]:
    """What an unsaid state or place of a check may be: those that tasks name, and what is said of things."""
    document = observed.document
    found: dict[tuple[int, int, str], Candidate] = {}
    taken = {document.indices(task.span).start: task for task in tasks}
    for task in tasks:
        for argument in task.arguments:
            if argument.span is None or argument.type not in ("state", "location", "source", "goal"):
                continue
            tokens = document.indices(argument.span)
            if not tokens or is_pronoun(document, tokens):
                continue
            inner = stripped(document, tokens)
            if argument.type != "state" and is_pronoun(document, inner):
                continue
            found[tokens.start, tokens.stop, "whole"] = _owned(document, tokens, task, argument.type, "whole")
            if argument.type != "state" and inner != tokens:
                found[inner.start, inner.stop, "bare"] = _owned(document, inner, task, argument.type, "bare")
    for verb, task in taken.items():
        deed = _deed(document, verb, task, taken)
        if deed:
            found.setdefault((deed.start, deed.stop, "whole"), _owned(document, deed, task, "state", "deed"))
    lacking: set[int] = set()  # the "out" of "out of milk", which is a state by what there is none of
    for chunk in noun_chunks(document):
        before = chunk.start - 1
        if tuple(token.lower for token in document.tokens[max(0, before - 1) : chunk.start]) == _OUT_OF:
            is_lacked = before > 1 and document.tokens[before - 2].lower in _BEING_OR_RUNNING
            if is_lacked:
                lacking.add(before - 1)
                text = document.span(before - 1, chunk.stop - 1).of(document.text)
                candidate = Candidate(text, range(before - 1, chunk.stop), before - 1, type="state", shape="adjective")
                found.setdefault((before - 1, chunk.stop, "whole"), candidate)
            continue
        if before >= 0 and document.tokens[before].pos == "ADP" and (before, chunk.stop, "whole") not in found:
            for start, shape in ((before, "said"), (chunk.start, "said.bare")):
                text = document.span(start, chunk.stop - 1).of(document.text)
                candidate = Candidate(text, range(start, chunk.stop), chunk.stop - 1, type="location", shape=shape)
                found.setdefault((start, chunk.stop, "whole" if start == before else "bare"), candidate)
    for token in document.tokens:
        i = token.i
        owner = taken.get(i)
        if owner is not None and owner.type != "check_state":
            continue
        is_state = token.lower in observed.gazetteer.states or token.pos == "ADJ"
        is_verb = token.pos == "VERB" and token.tag != "MD"
        if not (is_state or is_verb) or token.lower in _LIKELY | _HASTE or token.i in lacking:
            continue
        number, kind = (owner.id, owner.type) if owner else (0, "")
        candidate = Candidate(token.text, range(i, i + 1), i, number, "state", kind, "verb" if is_verb else "adjective")
        found.setdefault((i, i + 1, "whole"), candidate)
        stop = i + 1
        while stop < len(document) and document.tokens[stop].lower not in _CLAUSE_ENDS and stop not in taken:
            stop += 1
        if stop > i + 1 and owner is None:
            text = document.span(i, stop - 1).of(document.text)
            found.setdefault((i, stop, "whole"), Candidate(text, range(i, stop), i, number, "state", kind, "clause"))
    return [found[place] for place in sorted(found)]


def _deed(document: Document, verb: int, task: Task, verbs: Collection[int]) -> range:
    """A task's verb with all that is said behind it, which an "if he hasn't" takes up: "*finished their cognac*"; empty
    for a verb alone, but "been", and for what only is."""
    token = document.tokens[verb]
    if token.pos not in ("VERB", "AUX") or (token.lemma in ("be", "'s") and token.lower != "been"):
        return range(0)
    ends = [document.indices(a.span).stop for a in task.arguments if a.span and a.span.start > task.span.start]
    stop = max(ends, default=verb + 1)
    stop = min((other for other in verbs if verb < other < stop), default=stop)
    return range(verb, stop) if stop > verb + 1 or token.lower == "been" else range(0)


_OUT_OF = ("out", "of")
_BEING_OR_RUNNING = frozenset("is are 's 're be been run running was were".split())
_NEAR = 4
"""Within so many words ahead of a deed stands the "give" that it is given by [tokens]."""
_GIVING = frozenset(("give", "given", "giving"))
_DEEDS = frozenset(
    "wipe rinse clean polish stir shake wash scrub dust sweep mop hoover brush iron tidy bath bathe vacuum".split()
)
_TRIES = frozenset("check look go try sniff test feel tug once-over inspection".split())
"""What is given to something, too, and names no thing: "give the monitor a quick *check*"."""
_LIKELY = frozenset("likely unlikely supposed meant bound supposedly".split())
"""How sure it is that something is so, which is no state: "it's most *likely* in the shed"."""

_HASTE = frozenset("quick quickly fast soon sharpish pronto".split())
"""How something is to be done, which is no state: "I need the kit, *quick* as you can"."""


def is_placed(document: Document, tokens: range) -> bool:
    """Whether a phrase is of somebody by a pronoun, with where they are: "*her* on the porch"."""
    person, *behind = document.tokens[tokens.start : tokens.stop]
    is_person = person.tag == "PRP" and person.lower in _SOMEBODY
    return is_person and len(behind) > 1 and behind[0].lower in PREPOSITIONS - _LEADING_AWAY


def is_pronoun(document: Document, tokens: range) -> bool:
    return len(tokens) == 1 and document.tokens[tokens.start].lower in PRONOUNS | _EITHER


def is_pointing(document: Document, tokens: range) -> bool:
    word = document.tokens[tokens.start].lower
    return len(tokens) == 1 and word in POINTING - WHOLE


def _outside(document: Document, tokens: range, shape: str) -> Candidate:
    text = document.span(tokens.start, tokens.stop - 1).of(document.text)
    head = head_of(document, tokens) if shape == "of" else head_of_kin(document, tokens.stop - 1)
    return Candidate(text, tokens, head, shape=shape)


def _owned(document: Document, tokens: range, task: Task, argument_type: str, shape: str) -> Candidate:
    text = document.span(tokens.start, tokens.stop - 1).of(document.text)
    return Candidate(text, tokens, head_of(document, tokens), task.id, argument_type, task.type, shape)


def _is_addressed(document: Document, tokens: range) -> bool:
    """Whether a phrase is "robot" without an article, maybe with a call before it ("hey robot"): who is spoken to."""
    *before, last = (document.tokens[i].lower for i in tokens)
    return last == "robot" and _CALLS.issuperset(before)


def _names(document: Document) -> Iterator[range]:
    """Runs of proper nouns, titles included."""
    start: int | None = None
    for i, token in enumerate((*document.tokens, None)):
        is_name = token is not None and token.pos == "PROPN" and token.text[:1].isupper()
        if is_name and start is None:
            start = i
        elif not is_name and start is not None:
            yield range(start, i)
            start = None


def _possessors(document: Document, chunks: Sequence[range]) -> Iterator[range]:
    """Whose something is: what stands before "'s" in a noun phrase ("mrs okafor" in "mrs okafor's hearing aid"), and
    people without it ("the kids" in "the kids room")."""
    for chunk in chunks:
        for i in chunk:
            token = document.tokens[i]
            is_people = token.tag == "NNS" and token.lemma in PERSON_NOUNS and i + 1 in chunk
            if i > chunk.start and (token.tag == "POS" or (is_people and document.tokens[i + 1].tag in ("NN", "NNS"))):
                yield range(chunk.start, i + is_people)
