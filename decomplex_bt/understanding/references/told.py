"""What a message tells of, where the order right behind it goes on about that: "tell her *dinner*'s ready, and take
*it* to her", "tell him he can watch *telly*, and turn *it* on"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.instruction import Task
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.phrases import Candidate
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_BE = frozenset("is are was were 's 're has have".split())
_SUBJECT = frozenset(("DET", "ADJ", "NOUN", "PROPN", "PRON", "NUM"))
_NUMBERS = {"it": frozenset(("NN", "NNP")), "them": frozenset(("NNS", "NNPS"))}
_NO_THINGS = frozenset("phone bell taxi cab bus train time bedtime".split())
"""What calls or comes for somebody, or is no thing at all."""


def subject_of(document: Document, task: Task) -> range:
    """Of what a message tells how or where it is: "tell Ann *the soup* is on the stove"; empty where it is another
    kind of message, or somebody."""
    message = next((a.span for a in task.arguments if a.type == "message" and a.span is not None), None)
    if task.type != "informing" or message is None:
        return range(0)
    tokens, words = document.tokens, document.indices(message)
    start = words.start + (tokens[words.start].lower == "that")
    stop = start
    while stop in words and tokens[stop].pos in _SUBJECT and tokens[stop].lower not in _BE:
        stop += 1
    if not start < stop < words.stop or tokens[stop].lower not in _BE:
        return range(0)
    last, behind = tokens[stop - 1], tokens[stop + 1 : stop + 2]
    is_owner = tokens[stop].lower == "'s" and bool(behind) and behind[0].pos in ("NOUN", "PROPN")
    is_thing = last.tag in ("NN", "NNS") and last.lemma not in PERSON_NOUNS | _NO_THINGS and not is_owner
    return range(start, stop) if is_thing else range(0)


def told_things(observed: Observed, tasks: Sequence[Task], known: Sequence[Candidate]) -> Iterator[Candidate]:
    """What messages tell of that the parse makes no phrase of: "dinner" behind a name, the "telly" of "watch telly"."""
    document = observed.document
    places = {i for candidate in known for i in candidate.tokens if "across" not in candidate.shape}
    for task in tasks:
        if task.type != "informing":
            continue
        spans = [a.span for a in task.arguments if a.type == "message" and a.span is not None]
        subject = subject_of(document, task)
        nouns = [
            range(i, i + 1)
            for span in spans
            for i in document.indices(span)
            if i not in subject and document.tokens[i].lower in observed.gazetteer.names
        ]
        for words in (*([subject] if subject else ()), *nouns):
            if places.isdisjoint(words):
                text = document.span(words.start, words.stop - 1).of(document.text)
                yield Candidate(text, words, words.stop - 1, task.id, "message", task.type, "in.told")


def number_of(document: Document, word: str, words: range) -> bool:
    """Whether a pronoun has the number of what words name."""
    return document.tokens[words[-1]].tag in _NUMBERS.get(word, ())
