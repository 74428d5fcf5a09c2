"""Restarts: words and clauses that are begun over ("if it's, uh, if it's not hot")."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from decomplex_bt.hesitation import HESITATING
from decomplex_bt.understanding.rules.speech.edits import (
    AHEAD,
    ASKING_FOR,
    BREAKS,
    FILLERS,
    LONGEST,
    MARKS,
    OPENERS,
    TELLING,
    TURNING,
    UNFINISHED,
    Said,
    is_order_at,
)
from decomplex_bt.understanding.rules.speech.replacements import takes_up

FARTHEST = 16
"""The most tokens between words and their being said over again where something is taken back between."""
_ON_TOP = frozenset("too also well another again back".split())
_PLACING = frozenset(("behind", "inside", "under", "underneath", "beneath"))
"""Prepositions that are adverbs to the tagger where nothing follows."""
_PLACED = frozenset(("put", "place"))
_THINGS = frozenset("it them that those these this".split())
_UNENDING = frozenset(("AUX", "ADP", "SCONJ", "PART", "PRON", "DET", "CCONJ"))
"""Parts of speech that end no phrase."""


def said_over(said: Said) -> Iterator[range]:
    """Words that are said over again, up to the second time: nothing but fillers between, or, where they begin a
    clause, something that is taken back. A single word is so only behind an "um", as an article, or where it is a verb
    that begins a clause and a mark stands between (in "if it is open, open it" and "please please" nothing is)."""
    words, last = said.words, dict[str, int]()
    over = 0
    for again, word in enumerate(words):
        first, last[word] = last.get(word), again
        if first is None or first < over or word in FILLERS or not said.are_together(first, again):
            continue
        stop = again
        while words[stop - 1] in FILLERS:
            stop -= 1
        count = stop - first
        if count <= LONGEST and words[first:stop] == words[again : again + count]:
            is_hesitant = not HESITATING.isdisjoint(words[stop:again])
            is_verb = said.document.tokens[first].pos in ("VERB", "AUX") and said.begins_clause(first)
            is_article = word in UNFINISHED and said.document.tokens[first].pos in ("DET", "PRON")
            is_alone = is_article or (stop < again and is_verb)
            is_named = said.document.tokens[first].pos in ("NOUN", "PROPN") and not said.begins_clause(first)
            is_named = is_named and stop == again and first != over  # "from room to room to see"
            if not MARKS.isdisjoint(words[first:stop]) or words[again + count : again + count + 1] == ["again"]:
                continue  # "turn left, go on, turn left, go on", "turn left, turn left again"
            if (count > 1 and not is_named) or is_hesitant or is_alone:
                over = again
                yield range(first, again)
            continue
        begun = range(first, again) if _is_unplaced(said, first, again) else _begun_over(said, first, again)
        if begun:
            over = again
            yield begun


def _is_unplaced(said: Said, first: int, again: int) -> bool:
    """Whether nothing but a thing is said between a "put" and its being said over again, and not where to: "put them
    put six of them on the table"; "put them away put the kettle on" are two orders."""
    words, named = said.words, said.document.tokens[first + 1 : again]
    if words[first] not in _PLACED or not named or words[again + 1 : again + 2] == []:
        return False
    is_pronoun = len(named) == 1 and named[0].lower in _THINGS
    is_phrase = named[0].tag in ("DT", "PRP$") and all(token.pos in ("NOUN", "ADJ", "PROPN") for token in named[1:])
    return is_pronoun or (is_phrase and len(named) > 1)


def _begun_over(said: Said, first: int, again: int) -> range:
    """A clause that is begun over with the same words, where it was taken back or broken off between; empty where none
    is. Of "put the fan on, no, wait, if it's hot put the fan on" the first four words are taken back alone."""
    words = said.words
    if not said.may_begin(first):
        return range(0)
    count = 0
    while first + count < again + count < len(words) and words[first + count] == words[again + count]:
        count += 1
    inner = [run for run in said.runs if run.start >= first + count and run.stop <= again]
    is_close = again - (first + count) <= FARTHEST
    is_of_it = words[again + 1 : again + 2] != [] and words[again + 1] in _THINGS and words[again] not in TELLING
    if inner and is_of_it and is_order_at(said.document, again) and takes_up(said, range(first, again), inner[-1]):
        return range(0)  # "turn the heating up, no, turn it off"
    if count > 2 and inner and inner[0].start == first + count and _is_moved(said, inner[0], again):
        return range(first, inner[0].stop)
    is_opening = words[first] in OPENERS
    is_over = (is_opening and _is_meant(said, first, again, count)) or (
        bool(inner)
        and (
            (count > 0 and _is_ordered_anew(said, first, again, inner))
            or ((count > 1 or is_opening) and any(_is_broken_off(said, first, run) for run in inner))
            or (count > 1 and _is_resumed(said, again, inner))
            or (inner[-1].stop == again and _is_cut_short(said, inner[-1]) and _is_asked_again(said, first, again))
        )
    )
    return range(first, again) if is_close and is_over else range(0)


def _takes_back(said: Said, run: range, again: int) -> bool:
    """Whether a run takes back what stands ahead of it, and what is said again at `again` is not to come first or on
    top of that."""
    is_near = said.is_strong(run) and again - run.stop <= LONGEST
    return (is_near or said.turns(run, again)) and not _is_ahead(said, again)


def _is_ahead(said: Said, again: int) -> bool:
    """Whether what is said again is to be done first, before something, or on top of what was said."""
    words = said.words
    end = next((i for i in range(again, len(words)) if not said.are_together(i, again)), len(words))
    return not AHEAD.isdisjoint(words[again:end]) or _is_added(words, again)


def _is_moved(said: Said, run: range, again: int) -> bool:
    """Whether an order is taken back right behind its words, or is told again under an "if"."""
    is_moved = not {"if", "when"}.isdisjoint(said.words[run.stop : again]) and not _is_ahead(said, again)
    is_turned = said.has(run, TURNING) and _is_exclaimed(said, run)
    return _takes_back(said, run, again) or (is_moved and (said.is_strong(run) or is_turned))


def _is_ordered_anew(said: Said, first: int, again: int, inner: Sequence[range]) -> bool:
    """Whether an order is given over again behind something that takes it back or turns the speaker round."""
    if not _is_order_again(said, first, again) or _is_ahead(said, again):
        return False
    is_turned = any(said.has(run, TURNING) and _is_exclaimed(said, run) for run in inner)
    is_taken_back = any(_takes_back(said, run, again) for run in inner)
    return is_turned or is_taken_back or _is_contradicted(said.words[first:again])


def _is_resumed(said: Said, again: int, inner: Sequence[range]) -> bool:
    """Whether words are taken up again behind something that takes them back, or that filled a search for words."""
    words, seeking = said.words, inner[-1]
    is_stuck = said.document.tokens[seeking.start - 1].pos in _UNENDING
    is_sought = (said.has(seeking, HESITATING) and is_stuck) or _seeks(words[seeking.start : seeking.stop])
    is_adjacent = seeking.stop == again and words[seeking.start - 1] not in ("and", "or", "but", "then")
    return (is_sought and is_adjacent) or any(_takes_back(said, run, again) for run in inner)


def _is_meant(said: Said, first: int, again: int, count: int) -> bool:
    """Whether an "I mean" or "that is" behind a clause that is begun over says that its words are right, and nothing
    was ordered before: "if she's up, if she's dressed I mean, ..."."""
    words, tokens = said.words, said.document.tokens
    is_added = words[again - 1] in ("and", "or", "but")
    if is_added or any(is_order_at(said.document, i) for i in range(first, again)):
        return False
    behind = range(again + count, min(again + count + LONGEST, len(words) - 2))
    marks = [i for i in behind if words[i : i + 2] in (["i", "mean"], ["i", "meant"], ["that", "is"])]
    ends = [i + 2 for i in marks if words[i - 1] not in ("what", "that", "as", "which", "who")]
    return any(words[i] in MARKS or (tokens[i].pos == "VERB" and words[i] == tokens[i].lemma) for i in ends)


def _is_order_again(said: Said, first: int, again: int) -> bool:
    """Whether the same verb orders something twice, and the second order is not added to the first."""
    if said.words[again - 1] in ("and", "then", "or", "but", "to", "not", "n't"):
        return False
    return is_order_at(said.document, first) and is_order_at(said.document, again)


def _is_asked_again(said: Said, first: int, again: int) -> bool:
    """As `_is_order_again`, also behind a "could you" and the like."""
    is_polite = said.words[first] in ASKING_FOR and said.words[first + 1 : first + 2] == ["you"]
    return _is_order_again(said, first + 2 * is_polite, again + 2 * is_polite)


def _is_added(words: Sequence[str], start: int) -> bool:
    """Whether the clause that begins there is said to come on top of what was said: "could you also ...", "... too"."""
    end = next((i for i in range(start, len(words)) if words[i] in BREAKS), len(words))
    return not _ON_TOP.isdisjoint(words[start:end])


def _is_exclaimed(said: Said, run: range) -> bool:
    """Whether a "wait" is said to oneself: not "wait for Anna", "wait thirty seconds", "ask him to wait"."""
    after = said.document.tokens[run.stop] if run.stop < len(said.words) else None
    is_order = after is not None and said.words[run.stop - 1] in TURNING and after.pos in ("ADP", "NUM", "DET", "SCONJ")
    is_place = after is not None and after.lower in ("there", "here", "outside", "inside", "until", "till")
    return not is_order and not is_place and said.words[run.start - 1] != "to"


def _is_contradicted(words: Sequence[str]) -> bool:
    """Whether words are denied right behind them: "the baby not the baby"."""
    return any(word == "not" and words[i - 2 : i] == words[i + 1 : i + 3] for i, word in enumerate(words) if i > 1)


def _seeks(run: Sequence[str]) -> bool:
    """Whether somebody looks for words: "what's it called"."""
    return "what" in run or "whats" in run


def _is_broken_off(said: Said, first: int, run: range) -> bool:
    """Whether a clause stops where none ends: at an article without its noun behind the run, or at the contraction of
    its verb ("if the baby's, ...")."""
    tokens, last = said.document.tokens, said.words[run.start - 1]
    if last in UNFINISHED:
        return tokens[run.stop].pos not in ("NOUN", "PROPN", "ADJ")
    if last not in ("'s", "'re", "'ll") or said.words[run.start] not in MARKS:
        return False
    return not any(token.pos in ("VERB", "AUX") for token in tokens[first : run.start - 1])


def _is_cut_short(said: Said, run: range) -> bool:
    """Whether an order stops behind a preposition ("check under... check the table")."""
    last = said.document.tokens[run.start - 1]
    is_preposition = (last.tag == "IN" or last.dep == "prep" or last.lower in _PLACING) and not said.document.children[
        last.i
    ]
    return is_preposition and said.words[run.start] in MARKS - {","}
