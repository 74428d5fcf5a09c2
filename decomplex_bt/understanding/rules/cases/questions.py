"""Questions inside an order to find something out: "see *who is in the pool*", "look *what it is*"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.relatives import BE

_FINDING = frozenset("check see look find".split())
_ASKED = frozenset(("who", "what", "which", "how", "whose"))
_AMOUNTS = frozenset(("much", "many"))
_ENDS = MARKS | frozenset("and or but then so if unless when before after because please".split())
_DELIBERATING = frozenset(("should", "shall"))
_ANSWERS = frozenset("so not yes no".split())
_DECIDING = frozenset("if only when unless".split())
_NOUNS = frozenset(("ADJ", "NOUN", "PROPN"))
_OF_CLAUSE = frozenset("object state location source goal message recipient manner".split())
_STATES = frozenset(("on", "off", "open", "shut"))
_NO_STATES = frozenset(("there", "here", "home", "in", "inside", "outside", "upstairs", "downstairs"))


@dataclass(frozen=True, slots=True)
class Question:
    """The verb that finds out and the tokens of what it finds out; what is `asked` of ("who", "how many eggs"), and the
    `place` or the `state` that is said of it, empty where none is."""

    verb: int
    tokens: range
    asked: range
    place: range = range(0)
    state: range = range(0)


def questions(document: Document, tasks: Collection[int]) -> Iterator[Question]:
    """All questions behind a verb of finding out that is among the `tasks`, in text order."""
    tokens = document.tokens
    for verb in sorted(tasks):
        if tokens[verb].lemma not in _FINDING:
            continue
        start = verb + 1 + (verb + 1 < len(tokens) and tokens[verb + 1].lower == "out")
        if start + 1 >= len(tokens) or tokens[start].lower not in _ASKED:
            continue
        stop = start + 1
        while stop < len(tokens) and tokens[stop].lower not in _ENDS:
            if stop in tasks and tokens[stop].tag == "VB":
                break
            stop += 1
        yield from _question(document, verb, range(start, stop))


def asks_openly(document: Document, verb: int) -> bool:
    """Whether a verb finds out what no yes or no answers: "see *what* the noise is", "find out *whose* turn it is"."""
    words = [token.lower for token in document.tokens[verb + 1 : verb + 3]]
    return document.tokens[verb].lemma in _FINDING and not _ASKED.isdisjoint(
        words[:1] if words[:1] != ["out"] else words[1:]
    )


def is_deliberated(document: Document, at: int) -> bool:
    """Whether a verb only asks what the sentence behind it decides: "should I *wash* it? If it's stained, ...";
    not "... If so, ..."."""
    tokens, sentences = document.tokens, document.sentences
    first = sentences.index(sentences[at])
    stop = next((i for i in range(at, len(tokens)) if sentences[i] != sentences[at]), len(tokens) - 1)
    words = [token.lower for token in tokens[first : first + 2]]
    is_question = words[0] in _DELIBERATING and words[1:] in (["i"], ["we"]) and tokens[stop - 1].text == "?"
    is_own = stop + 1 < len(tokens) and tokens[stop + 1].lower not in _ANSWERS
    return is_question and tokens[stop].lower in _DECIDING and is_own


def _question(document: Document, verb: int, words: range) -> Iterator[Question]:
    tokens, start = document.tokens, words.start
    noun = start + 1
    if tokens[start].lower == "how" and tokens[noun].lower not in _AMOUNTS:
        return  # "how hot the soup is"
    if tokens[start].lower == "what" and tokens[noun].pos == "PROPN":
        return  # "what Max is doing"
    if tokens[start].lower != "who":
        noun += tokens[noun].lower in _AMOUNTS
        parts = _NOUNS if noun == words.stop or tokens[noun].lower != "of" else _NOUNS | {"ADP", "DET", "NUM"}
        while noun < words.stop and tokens[noun].pos in parts:
            noun += 1
    be = next((i for i in words if tokens[i].lower in BE), None)
    behind = range((be or 0) + 1, words.stop)
    is_there = tokens[noun].lower == "there" if noun < words.stop else False
    is_alone = be is not None and be == noun + is_there and bool(behind)
    is_of_somebody = tokens[start].lower == "who"
    if is_of_somebody and (not is_alone or tokens[behind.start].pos == "VERB"):
        yield Question(verb, words, words)  # "who it is", "who left the gate open"
    elif not is_alone:
        return  # "what the thermometer says"
    elif len(behind) == 1 and tokens[behind.start].lower in _STATES:
        yield Question(verb, words, range(start, noun), state=behind)
    elif tokens[behind.start].pos in ("ADP", "ADV") or tokens[behind.start].lower in _NO_STATES:
        yield Question(verb, words, range(start, noun), place=behind)
    elif tokens[behind.start].pos in ("ADJ", "VERB", "PART") and len(behind) == 1:
        yield Question(verb, words, range(start, noun), state=behind)


def with_questions(
    document: Document, tasks: Collection[int], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with what is asked for as the object of the verb that finds it out, and with its place or state."""
    kept = list(arguments)
    for question in questions(document, tasks):
        said = {"object": question.asked, "location": question.place, "state": question.state}
        kept = [a for a in kept if a.tokens.start not in question.tokens or a.type not in _OF_CLAUSE]
        kept += [FoundArgument(kind, question.verb, words, CERTAIN) for kind, words in said.items() if words]
    return kept
