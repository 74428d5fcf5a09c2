"""Idioms: turns of phrase that are tasks whatever a model says of their words."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from decomplex_bt.understanding.document import Document

_MAY = frozenset(("may", "might", "could"))
_TAKEN_UP = (
    ("in", "that", "case"), ("in", "which", "case"), ("in", "that", "event"), ("in", "which", "event"), ("if", "so"),
    ("if", "that", "is", "the", "case"), ("if", "that", "'s", "the", "case"), ("if", "that", "is", "so"),
)  # fmt: skip
"""What takes a statement up as a condition."""
_LOOKING = frozenset("look peek glance gander peep rummage".split())
_ASKED = frozenset("is are 's has have do does did if whether see to what who where".split())
_ASKING = frozenset(("check_state", "searching"))
_NOMINAL = frozenset("NOUN PROPN PRON DET ADJ NUM PART".split())
_WEATHER = frozenset("rain snow hail drizzle pour".split())


def idiomatic(document: Document, tasks: Mapping[int, str]) -> dict[int, str]:
    """The tokens that are tasks besides the `tasks` found, which are tokens with types; with their types.

    Checks are what may be so, where the next words take it up ("The door might be locked. In that case, ..."), and the
    weather of "should it rain". "Have" in "have a look" is searching.
    """
    checks = _stated(document, tasks) | _weather(document)
    return {**dict.fromkeys(_looks(document, tasks), "searching"), **dict.fromkeys(checks, "check_state")}


def _weather(document: Document) -> frozenset[int]:
    """The verbs of "should it rain"."""
    tokens = document.tokens
    return frozenset(
        i + 2
        for i, token in enumerate(tokens[:-2])
        if token.lower == "should" and tokens[i + 1].lower == "it" and tokens[i + 2].lemma in _WEATHER
    )


def _looks(document: Document, tasks: Collection[int]) -> list[int]:
    """Every "have" of an order to have a look at which no word is a task yet."""
    tokens = document.tokens
    found = []
    for i, token in enumerate(tokens[:-2]):
        end = i + 3 + (tokens[i + 2].pos == "ADJ")
        is_look = token.lemma == "have" and tokens[i + 1].lower in ("a", "another") and end <= len(tokens)
        if not is_look or tokens[end - 1].lower not in _LOOKING or set(range(i, end)) & set(tasks):
            continue
        subjects = [tokens[j] for j in document.children[i] if tokens[j].dep == "nsubj"]
        if any(subject.lower != "you" for subject in subjects):  # "so that I can have a look"
            continue
        after = next((t.lower for t in tokens[end:] if t.lower not in (",", ":", "-")), "")
        if after not in _ASKED:  # "have a look, is the gate open?" asks
            found.append(i)
    return found


def _stated(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of what may be so and is taken up in its own sentence or the next; not where another check that stands
    in between is what is taken up."""
    tokens, sentences = document.tokens, document.sentences
    words = [token.lower for token in tokens]
    starts = {
        sentences[i]: i
        for i in range(len(tokens))
        if any(tuple(words[i : i + len(phrase)]) == phrase for phrase in _TAKEN_UP)
    }
    found = set()
    for i, word in enumerate(words):
        if word not in _MAY or tokens[i].tag != "MD" or i == 0 or words[i - 1] in ("i", "you", "we"):
            continue
        taken_up = next((starts[n] for n in (sentences[i], sentences[i] + 1) if starts.get(n, -1) > i), None)
        verb = next((j for j in range(i + 1, min(i + 5, len(tokens))) if tokens[j].tag == "VB"), None)
        if taken_up is None or verb is None or words[verb + 1 : verb + 2] == ["that"]:  # "it may be that it is locked"
            continue
        if words[verb] == "have":
            verb = next((j for j in range(verb + 1, min(verb + 4, len(tokens))) if tokens[j].tag == "VBN"), verb)
        if not any(verb + 1 < j < taken_up and kind in _ASKING for j, kind in tasks.items()):
            found.add(verb)
    return frozenset(found)


def predicated(document: Document, check: int) -> dict[str, range]:
    """What the words of a check that may be so say of it: the `object`, the words before its verb, and the `state`
    behind a "be" ("the attic door might be locked"); nothing for any other check."""
    tokens, sentences = document.tokens, document.sentences
    may = next((j for j in range(check - 1, max(-1, check - 4), -1) if tokens[j].lower in _MAY), None)
    if may is None or tokens[check].lower != "be":
        return {}
    found = {}
    state = next((t for t in tokens[check + 1 : check + 4] if t.tag != "RB"), None)
    if state is not None and state.tag in ("JJ", "VBN", "VBG"):
        after = tokens[state.i + 1] if state.i + 1 < len(tokens) else None
        found["state"] = range(state.i, state.i + 1 + (after is not None and after.dep == "prt"))
    start = may
    while start and tokens[start - 1].pos in _NOMINAL and sentences[start - 1] == sentences[may]:
        start -= 1
    if start < may:
        found["object"] = range(start, may)
    return found
