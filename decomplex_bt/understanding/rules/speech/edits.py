"""Edits: the words by which speakers interrupt themselves ("uh", "no, sorry", "I mean"), in runs."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from decomplex_bt.hesitation import HESITATING
from decomplex_bt.understanding.document import ENDS, Document

LONGEST = 6
"""The most words that are said over again."""
DOTS = frozenset(("...", "…"))
MARKS = frozenset((",", "-", "–", "—", *DOTS))
FILLERS = MARKS | HESITATING | frozenset("ah like well sorry wait no please".split())
"""What may stand between something and its being said over again."""
DENYING = frozenset(("no", "nope", "nah"))
EDITING = MARKS | HESITATING | DENYING | frozenset("ah oh well sorry wait actually okay ok or just".split())
_PHRASES = tuple(
    tuple(phrase.split())
    for phrase in (
        "i mean", "i meant", "or rather", "or better", "better still", "better yet", "on second thoughts",
        "on second thought", "hang on", "hold on", "i beg your pardon", "what am i saying",
        "what 's it called", "what s it called", "whats it called", "what is it called", "what are they called",
        "what do you call it", "what do you call them", "what do you call that", "what 's his name",
        "what 's her name", "whatsit", "wotsit", "thingy", "thingummy", "thingamajig", "whatchamacallit",
    )
)  # fmt: skip
"""What is said while looking for words, beside single words."""
_BEGINNINGS = frozenset(phrase[0] for phrase in _PHRASES)
_STRONG = DENYING | {"sorry", "correction"}
_STRONG_PHRASES = frozenset(
    (
        ("i", "mean"), ("i", "meant"), ("or", "rather"), ("or", "better"), ("better", "still"), ("better", "yet"),
        ("second", "thoughts"), ("second", "thought"), ("your", "pardon"), ("am", "i"),
    )
)  # fmt: skip
_SET_OFF = frozenset(("actually", "better"))
"""What puts something right behind a mark: "on the table, *better* on the shelf"."""
TURNING = frozenset(("wait", "hang", "hold"))
"""What takes something back where words are said over again."""
NO_EDITS_BEFORE = frozenset(
    "is are am 's s 'm m was be feel so very there got have has had with find see say says said if when or but and "
    "still by want yes a in answer answers".split()
)
"""Before a "no" that no comma sets off, or a "sorry": what makes it part of what is said."""
AFTER_NO = frozenset(
    "one more longer matter doubt wonder thank thanks problem worries need rush hurry luck use idea way chance".split()
)
_AFTER_SORRY = frozenset("about for if that to but i it he she they".split())
TELLING = frozenset("tell tells told say says said answer answers".split())
_YES = frozenset(("yes", "yeah", "yep"))
UNFINISHED = frozenset("the a an my our your their".split())
"""Words after which nothing ends."""
OPENERS = frozenset("if when unless whether once after before while is are has does can could would will".split())
BREAKS = MARKS | ENDS | frozenset((":", "and", "but", "or", "then", "so"))
_CLAUSE_OPENERS = BREAKS | FILLERS | frozenset("if unless when oh ok okay just to".split())
AHEAD = frozenset("first before ahead until till".split())
ASKING_FOR = frozenset(("could", "can", "would", "will"))
STATING = frozenset("he she it they we i that".split())
_FINITE = frozenset("'s s is are 're re 'm m has have 've ve was were had will 'll wo ca can does do did".split())
INTERJECTIONS = frozenset("oh ok okay right now and but so erm".split())
_SUBJECTS = frozenset(("nsubj", "nsubjpass", "expl"))
_OBJECTS = frozenset(("it", "them"))
_IDLE_SUBJECTS = TURNING | {"sorry"}
"""What is taken for the subject of an order behind it: "no *wait* put it here"."""


@dataclass(frozen=True, slots=True)
class Said:
    """A document's words, lower-cased, with the `runs` of editing words and marks in them, and for every word the
    number of its sentence, which does not end at an ellipsis before a small letter ("open it... no, close it")."""

    document: Document
    words: Sequence[str]
    runs: Sequence[range]
    sentences: Sequence[int]

    @classmethod
    def of(cls, document: Document) -> Said:
        words = [token.lower for token in document.tokens]
        runs: list[range] = []
        i = 0
        while i < len(words):
            stop = _run(document, words, i)
            if stop > i:
                runs.append(range(i, stop))
            i = max(stop, i + 1)
        ends = [
            j > 0 and document.sentences[j] != document.sentences[j - 1] and not _is_broken_by_dots(document, j)
            for j in range(len(words))
        ]
        return cls(document, words, runs, tuple(accumulate(ends)))

    def are_together(self, one: int, other: int) -> bool:
        return self.sentences[one] == self.sentences[other]

    def turns(self, run: range, stop: int) -> bool:
        """Whether a run that ends there turns the speaker round: ", wait, ...", but not "ask him to wait, ..."."""
        return run.stop == stop and self.words[run.start] in MARKS and self.has(run, TURNING)

    def has(self, run: range, words: Collection[str]) -> bool:
        return not set(words).isdisjoint(self.words[run.start : run.stop])

    def states(self, i: int) -> bool:
        """Whether a statement about somebody or something named before begins there: "he's out", "it has gone"."""
        return self.words[i] in STATING and self.words[i + 1 : i + 2] != [] and self.words[i + 1] in _FINITE

    def begins_clause(self, i: int) -> bool:
        return i == 0 or self.words[i - 1] in _CLAUSE_OPENERS or not self.are_together(i - 1, i)

    def may_begin(self, i: int) -> bool:
        """Whether something may be begun there: a sentence, or what stands behind a mark, a filler or an address."""
        opening = BREAKS | FILLERS | INTERJECTIONS | {"you"}
        return i == 0 or self.words[i - 1] in opening or not self.are_together(i - 1, i)

    def is_strong(self, run: range) -> bool:
        """Whether a run of editing words takes something back: it has a "no", "sorry" or "I mean" that says nothing
        else ("no milk", "tell him no", "sorry for the trouble")."""
        words = self.words[run.start : run.stop]
        if any(pair in _STRONG_PHRASES for pair in pairwise(words)):
            return True
        if words[0] in MARKS and words[-1] in _SET_OFF | MARKS and not _SET_OFF.isdisjoint(words):
            return True
        after = self.document.tokens[run.stop] if run.stop < len(self.words) else None
        said = {word for word in words if word in _STRONG}
        is_named = after is not None and after.pos in ("NOUN", "PROPN", "ADJ", "PRON")
        if is_named and words[-1] in DENYING and not self.states(run.stop):
            said -= DENYING  # "no milk"
        if after is not None and after.pos == "NUM" and words[-1] in DENYING:
            is_number = run.start > 0 and self.document.tokens[run.start - 1].pos != "NUM"
            said -= DENYING if is_number and TURNING.isdisjoint(words) else set()  # "room no 7", not "wait no seven"
        if after is not None and words[-1] == "sorry" and after.lower in _AFTER_SORRY:
            said.discard("sorry")
        if after is not None and after.lower in AFTER_NO:
            said -= DENYING
        before = self.words[max(0, run.start - 2) : run.start]
        is_part = not before or before[-1] in NO_EDITS_BEFORE or not TELLING.isdisjoint(before)
        if words[0] in _STRONG and is_part:
            return False
        if not _YES.isdisjoint(self.words[: run.start]) and said <= DENYING:
            return False  # "yes, bring it, no, ..." answers
        return bool(said)


def _is_broken_by_dots(document: Document, i: int) -> bool:
    """Whether a sentence goes on at `i`, behind an ellipsis."""
    return document.tokens[i - 1].text in DOTS and document.tokens[i].text[0].islower()


def _run(document: Document, words: Sequence[str], start: int) -> int:
    """Where the editing words and marks that begin at `start` end; a lone "or" or "just" edits nothing, nor does a well
    with water."""
    i = start
    while i < len(words):
        phrase = None
        if words[i] in _BEGINNINGS:
            phrase = next((p for p in _PHRASES if tuple(words[i : i + len(p)]) == p), None)
        is_noun = words[i] == "well" and document.tokens[i].pos == "NOUN"
        is_editing = words[i] in EDITING or (words[i] == "better" and i > start) or _is_correction(words, i)
        if phrase is None and (not is_editing or is_noun):
            break
        i += 1 if phrase is None else len(phrase)
    is_editing = any(word not in ("or", "just") for word in words[start:i])
    return i if is_editing else start


def _is_correction(words: Sequence[str], i: int) -> bool:
    """Whether a "correction" between marks puts something right: "on the lower shelf, *correction*, the upper"."""
    around = [*words[i - 1 : i], *words[i + 1 : i + 2]]
    return words[i] == "correction" and len(around) == 2 and MARKS | ENDS | {":"} >= {*around}


def is_order_at(document: Document, i: int) -> bool:
    """Whether a token is a verb in its bare form whose subject is none but "you"; the tagger takes that of "hoover the
    stairs" for a noun, and that of "Empty the bin" and "no, dry them" for an adjective."""
    token, following = document.tokens[i], document.tokens[i + 1 : i + 2]
    clause = next((j + 1 for j in range(i - 1, -1, -1) if document.tokens[j].text in MARKS), 0)
    near = (document.tokens[j] for j in document.children[i] if j >= clause)
    subjects = {token.lower for token in near if token.dep in _SUBJECTS} - _IDLE_SUBJECTS
    is_first = i == 0 or document.tokens[i - 1].text in ENDS
    kinds = ("NN", "NNP", "JJ") if is_first else ("NN",)
    is_named = bool(following) and following[0].tag in ("DT", "PRP$") and following[0].lower not in DENYING
    is_done_to = bool(following) and following[0].lower in _OBJECTS and i == clause
    is_verb = token.pos == "VERB" or (token.tag in kinds and is_named) or (token.tag == "JJ" and is_done_to)
    return is_verb and token.lower == token.lemma and subjects <= {"you"}
