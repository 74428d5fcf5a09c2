"""Repairs: what a speaker begins and then puts otherwise in the same breath ("if it's, uh, if it's not hot", "on the
table, no, on the shelf", "tell him, no, switch it off"); an instruction is read without it.

As in the literature on disfluency (E. Shriberg, Preliminaries to a theory of speech disfluencies, 1994), a repair has a
*reparandum*, which goes, an *interregnum* ("uh", "no, sorry", "I mean"), which goes as well, and what takes its place.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from decomplex_bt.understanding.document import ENDS, Document

LONGEST = 6
"""The most words that are said over again."""
FARTHEST = 16
"""The most tokens between words and their being said over again where something is taken back between."""
_DOTS = frozenset(("...", "…"))
_MARKS = frozenset((",", "-", "–", "—", *_DOTS))
_HESITATING = frozenset("um uh er erm".split())
_FILLERS = _MARKS | _HESITATING | frozenset("ah hmm like well sorry wait no please".split())
"""What may stand between something and its being said over again."""
_DENYING = frozenset(("no", "nope", "nah"))
_EDITING = _MARKS | _HESITATING | _DENYING | frozenset("ah hmm oh well sorry wait actually okay ok or just".split())
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
_STRONG = _DENYING | {"sorry"}
_STRONG_PHRASES = frozenset(
    (
        ("i", "mean"), ("i", "meant"), ("or", "rather"), ("or", "better"), ("better", "still"), ("better", "yet"),
        ("second", "thoughts"), ("second", "thought"), ("your", "pardon"), ("am", "i"),
    )
)  # fmt: skip
_SET_OFF = frozenset(("actually", "better"))
"""What puts something right behind a mark: "on the table, *better* on the shelf"."""
_TURNING = frozenset(("wait", "hang", "hold"))
"""What takes something back where words are said over again."""
_NO_EDITS_BEFORE = frozenset(
    "is are am 's s 'm m was be feel so very there got have has had with find see say says said if when or but and "
    "still by want yes a in answer answers".split()
)
"""Before a "no" that no comma sets off, or a "sorry": what makes it part of what is said."""
_ON_TOP = frozenset("too also well another again back".split())
_PLACEHOLDERS = frozenset("whatsit wotsit thingy thingummy thingamajig whatchamacallit".split())
_AFTER_NO = frozenset(
    "one more longer matter doubt wonder thank thanks problem worries need rush hurry luck use idea way chance".split()
)
_AFTER_SORRY = frozenset("about for if that to but i it he she they".split())
_TELLING = frozenset("tell tells told say says said answer answers".split())
_YES = frozenset(("yes", "yeah", "yep"))
_UNFINISHED = frozenset("the a an my your our their".split())
"""Words after which nothing ends."""
_DETERMINERS = _UNFINISHED | frozenset("his her its this that these those some any".split())
_OPENERS = frozenset("if when unless whether once after before while is are has does can could would will".split())
_OPENING_ORDERS = frozenset("if when unless can could would please just go let".split())
_BREAKS = _MARKS | ENDS | frozenset((":", "and", "but", "or", "then", "so"))
_CLAUSE_OPENERS = _BREAKS | _FILLERS | frozenset("if unless when oh ok okay just to".split())
_AHEAD = frozenset("first before ahead until till".split())
_COORDINATING = frozenset(("and", "or", "then", "but"))
_WISHERS = frozenset(("i", "we"))
_WOULD = frozenset("'ll will 'd would".split())
_WISHING = frozenset("have take like love prefer".split())
_POINTING = frozenset("that this those these".split())
_PLACING = frozenset(("behind", "inside", "under", "underneath", "beneath"))
"""Prepositions that are adverbs to the tagger where nothing follows."""
_NAMED = frozenset(("nsubj", "dobj", "pobj"))
_OPENING = frozenset(("if", "whether", "unless", "when"))
_CHECKING = frozenset(("see", "check", "ask", "find", "tell"))
_ASKING_FOR = frozenset(("could", "can", "would", "will"))
_STATING = frozenset("he she it they we i that".split())
_FINITE = frozenset("'s s is are 're re 'm m has have 've ve was were had will 'll wo ca can does do did".split())
_INTERJECTIONS = frozenset("oh ok okay right now and but so erm".split())
_ASKING = frozenset("if whether unless when is are has does did 's".split())
_WITHDRAWING = frozenset("forget skip scratch scrap strike cancel ignore disregard make need".split())
"""Verbs that take an order back and order nothing themselves: "no, forget the stairs", "no, make that five"."""
_TAKING_UP = frozenset("it them that those this these one ones there him her".split())
_SUBORDINATING = frozenset("before after once when if while until till unless as".split())
_SUBJECTS = frozenset(("nsubj", "nsubjpass", "expl"))
_WITHIN = frozenset(("relcl", "acl", "xcomp"))
_UNENDING = frozenset(("AUX", "ADP", "SCONJ", "PART", "PRON", "DET", "CCONJ"))
"""Parts of speech that end no phrase."""
_NAMING = frozenset(("NOUN", "PROPN", "ADJ", "NUM", "DET", "PART"))


def repaired(document: Document) -> frozenset[int]:
    """The tokens that are put otherwise in the same sentence, with what stands between.

    Words that are said over again; phrases, clauses and orders that others stand in place of behind a "no, sorry" or
    the like; what breaks off at an article; a "tell you what". An order that is to be done *first* or *before* stands
    in place of none.
    """
    said = _Said.of(document)
    cut = {i for stretch in _said_over(said) for i in stretch}
    cut.update(i for opener in _openers(said) for i in opener)
    for run in said.runs:
        cut.update(_put_otherwise(said, run))
        cut.update(_dropped(said, run))
    return frozenset(cut)


def _openers(said: _Said) -> Iterator[range]:
    """Every "(I'll) tell you what" that only opens what is then ordered: not "tell you what happened"."""
    words, tokens = said.words, said.document.tokens
    for i in range(len(words) - 3):
        if words[i : i + 3] != ["tell", "you", "what"]:
            continue
        start, stop = i, i + 3
        while start and words[start - 1] in ("i", "'ll", "will"):
            start -= 1
        is_marked = words[stop] in _MARKS | {":", "."}
        while stop < len(words) and words[stop] in _MARKS | {":", "."}:
            stop += 1
        if stop == len(words) or not said.may_begin(start):
            continue
        is_order = tokens[stop].pos == "VERB" and words[stop] == tokens[stop].lemma
        if is_marked or is_order or words[stop] in _OPENING_ORDERS:
            yield range(start, stop)


def replaced_orders(document: Document) -> Iterator[range]:
    """The orders that another one behind a "no" stands in place of, with all that stands between, though that speaks of
    what they name: "close the window, no, leave it open"."""
    said = _Said.of(document)
    for run in said.runs:
        order = _order_before(said, run) if _puts_right(said, run) else range(0)
        if order and _takes_up(said, order, run):
            yield order


@dataclass(frozen=True, slots=True)
class _Said:
    """A document's words, lower-cased, with the `runs` of editing words and marks in them, and for every word the
    number of its sentence, which does not end at an ellipsis before a small letter ("open it... no, close it")."""

    document: Document
    words: Sequence[str]
    runs: Sequence[range]
    sentences: Sequence[int]

    @classmethod
    def of(cls, document: Document) -> _Said:
        words = [token.lower.replace("\u2019", "'") for token in document.tokens]
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
        return run.stop == stop and self.words[run.start] in _MARKS and self.has(run, _TURNING)

    def has(self, run: range, words: Collection[str]) -> bool:
        return not set(words).isdisjoint(self.words[run.start : run.stop])

    def states(self, i: int) -> bool:
        """Whether a statement about somebody or something named before begins there: "he's out", "it has gone"."""
        return self.words[i] in _STATING and self.words[i + 1 : i + 2] != [] and self.words[i + 1] in _FINITE

    def begins_clause(self, i: int) -> bool:
        return i == 0 or self.words[i - 1] in _CLAUSE_OPENERS or not self.are_together(i - 1, i)

    def may_begin(self, i: int) -> bool:
        """Whether something may be begun there: a sentence, or what stands behind a mark, a filler or an address."""
        opening = _BREAKS | _FILLERS | _INTERJECTIONS | {"you"}
        return i == 0 or self.words[i - 1] in opening or not self.are_together(i - 1, i)

    def is_strong(self, run: range) -> bool:
        """Whether a run of editing words takes something back: it has a "no", "sorry" or "I mean" that says nothing
        else ("no milk", "tell him no", "sorry for the trouble")."""
        words = self.words[run.start : run.stop]
        if any(pair in _STRONG_PHRASES for pair in pairwise(words)):
            return True
        if words[0] in _MARKS and words[-1] in _SET_OFF | _MARKS and not _SET_OFF.isdisjoint(words):
            return True
        after = self.document.tokens[run.stop] if run.stop < len(self.words) else None
        said = {word for word in words if word in _STRONG}
        is_named = after is not None and after.pos in ("NOUN", "PROPN", "ADJ", "PRON")
        if is_named and words[-1] in _DENYING and not self.states(run.stop):
            said -= _DENYING  # "no milk"
        if after is not None and after.pos == "NUM" and words[-1] in _DENYING:
            is_number = run.start > 0 and self.document.tokens[run.start - 1].pos != "NUM"
            said -= _DENYING if is_number else set()  # "room no 7"
        if after is not None and words[-1] == "sorry" and after.lower in _AFTER_SORRY:
            said.discard("sorry")
        if after is not None and after.lower in _AFTER_NO:
            said -= _DENYING
        before = self.words[max(0, run.start - 2) : run.start]
        is_part = not before or before[-1] in _NO_EDITS_BEFORE or not _TELLING.isdisjoint(before)
        if words[0] in _STRONG and is_part:
            return False
        if not _YES.isdisjoint(self.words[: run.start]) and said <= _DENYING:
            return False  # "yes, bring it, no, ..." answers
        return bool(said)


def _is_broken_by_dots(document: Document, i: int) -> bool:
    """Whether a sentence goes on at `i`, behind an ellipsis."""
    return document.tokens[i - 1].text in _DOTS and document.tokens[i].text[0].islower()


def _run(document: Document, words: Sequence[str], start: int) -> int:
    """Where the editing words and marks that begin at `start` end; a lone "or" or "just" edits nothing, nor does a well
    with water."""
    i = start
    while i < len(words):
        phrase = None
        if words[i] in _BEGINNINGS:
            phrase = next((p for p in _PHRASES if tuple(words[i : i + len(p)]) == p), None)
        is_noun = words[i] == "well" and document.tokens[i].pos == "NOUN"
        is_editing = words[i] in _EDITING or (words[i] == "better" and i > start)
        if phrase is None and (not is_editing or is_noun):
            break
        i += 1 if phrase is None else len(phrase)
    is_editing = any(word not in ("or", "just") for word in words[start:i])
    return i if is_editing else start


def _said_over(said: _Said) -> Iterator[range]:
    """Words that are said over again, up to the second time: nothing but fillers between, or, where they begin a
    clause, something that is taken back. A single word is so only behind an "um", as an article, or where it is a verb
    that begins a clause and a mark stands between (in "if it is open, open it" and "please please" nothing is)."""
    words, last = said.words, dict[str, int]()
    over = 0
    for again, word in enumerate(words):
        first, last[word] = last.get(word), again
        if first is None or first < over or word in _FILLERS or not said.are_together(first, again):
            continue
        stop = again
        while words[stop - 1] in _FILLERS:
            stop -= 1
        count = stop - first
        if count <= LONGEST and words[first:stop] == words[again : again + count]:
            is_hesitant = not _HESITATING.isdisjoint(words[stop:again])
            is_verb = said.document.tokens[first].pos in ("VERB", "AUX") and said.begins_clause(first)
            is_article = word in _UNFINISHED and said.document.tokens[first].pos in ("DET", "PRON")
            is_alone = is_article or (stop < again and is_verb)
            is_named = said.document.tokens[first].pos in ("NOUN", "PROPN") and not said.begins_clause(first)
            is_named = is_named and stop == again and first != over  # "from room to room to see"
            if not _MARKS.isdisjoint(words[first:stop]) or words[again + count : again + count + 1] == ["again"]:
                continue  # "turn left, go on, turn left, go on", "turn left, turn left again"
            if (count > 1 and not is_named) or is_hesitant or is_alone:
                over = again
                yield range(first, again)
            continue
        begun = _begun_over(said, first, again)
        if begun:
            over = again
            yield begun


def _begun_over(said: _Said, first: int, again: int) -> range:
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
    if count > 2 and inner and inner[0].start == first + count and _is_moved(said, inner[0], again):
        return range(first, inner[0].stop)
    is_opening = words[first] in _OPENERS
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


def _takes_back(said: _Said, run: range, again: int) -> bool:
    """Whether a run takes back what stands ahead of it, and what is said again at `again` is not to come first or on
    top of that."""
    is_near = said.is_strong(run) and again - run.stop <= LONGEST
    return (is_near or said.turns(run, again)) and not _is_ahead(said, again)


def _is_ahead(said: _Said, again: int) -> bool:
    """Whether what is said again is to be done first, before something, or on top of what was said."""
    words = said.words
    end = next((i for i in range(again, len(words)) if not said.are_together(i, again)), len(words))
    return not _AHEAD.isdisjoint(words[again:end]) or _is_added(words, again)


def _is_moved(said: _Said, run: range, again: int) -> bool:
    """Whether an order is taken back right behind its words, or is told again under an "if"."""
    is_moved = not {"if", "when"}.isdisjoint(said.words[run.stop : again]) and not _is_ahead(said, again)
    is_turned = said.has(run, _TURNING) and _is_exclaimed(said, run)
    return _takes_back(said, run, again) or (is_moved and (said.is_strong(run) or is_turned))


def _is_ordered_anew(said: _Said, first: int, again: int, inner: Sequence[range]) -> bool:
    """Whether an order is given over again behind something that takes it back or turns the speaker round."""
    if not _is_order_again(said, first, again) or _is_ahead(said, again):
        return False
    is_turned = any(said.has(run, _TURNING) and _is_exclaimed(said, run) for run in inner)
    is_taken_back = any(_takes_back(said, run, again) for run in inner)
    return is_turned or is_taken_back or _is_contradicted(said.words[first:again])


def _is_resumed(said: _Said, again: int, inner: Sequence[range]) -> bool:
    """Whether words are taken up again behind something that takes them back, or that filled a search for words."""
    words, seeking = said.words, inner[-1]
    is_stuck = said.document.tokens[seeking.start - 1].pos in _UNENDING
    is_sought = (said.has(seeking, _HESITATING) and is_stuck) or _seeks(words[seeking.start : seeking.stop])
    is_adjacent = seeking.stop == again and words[seeking.start - 1] not in ("and", "or", "but", "then")
    return (is_sought and is_adjacent) or any(_takes_back(said, run, again) for run in inner)


def _is_meant(said: _Said, first: int, again: int, count: int) -> bool:
    """Whether an "I mean" or "that is" behind a clause that is begun over says that its words are right, and nothing
    was ordered before: "if she's up, if she's dressed I mean, ..."."""
    words, tokens = said.words, said.document.tokens
    is_added = words[again - 1] in ("and", "or", "but")
    if is_added or any(_is_order(said.document, i) for i in range(first, again)):
        return False
    behind = range(again + count, min(again + count + LONGEST, len(words) - 2))
    marks = [i for i in behind if words[i : i + 2] in (["i", "mean"], ["i", "meant"], ["that", "is"])]
    ends = [i + 2 for i in marks if words[i - 1] not in ("what", "that", "as", "which", "who")]
    return any(words[i] in _MARKS or (tokens[i].pos == "VERB" and words[i] == tokens[i].lemma) for i in ends)


def _is_order_again(said: _Said, first: int, again: int) -> bool:
    """Whether the same verb orders something twice, and the second order is not added to the first."""
    if said.words[again - 1] in ("and", "then", "or", "but", "to", "not", "n't"):
        return False
    return _is_order(said.document, first) and _is_order(said.document, again)


def _is_asked_again(said: _Said, first: int, again: int) -> bool:
    """As `_is_order_again`, also behind a "could you" and the like."""
    is_polite = said.words[first] in _ASKING_FOR and said.words[first + 1 : first + 2] == ["you"]
    return _is_order_again(said, first + 2 * is_polite, again + 2 * is_polite)


def _is_added(words: Sequence[str], start: int) -> bool:
    """Whether the clause that begins there is said to come on top of what was said: "could you also ...", "... too"."""
    end = next((i for i in range(start, len(words)) if words[i] in _BREAKS), len(words))
    return not _ON_TOP.isdisjoint(words[start:end])


def _is_exclaimed(said: _Said, run: range) -> bool:
    """Whether a "wait" is said to oneself: not "wait for Anna", "wait thirty seconds", "ask him to wait"."""
    after = said.document.tokens[run.stop] if run.stop < len(said.words) else None
    is_order = (
        after is not None and said.words[run.stop - 1] in _TURNING and after.pos in ("ADP", "NUM", "DET", "SCONJ")
    )
    is_place = after is not None and after.lower in ("there", "here", "outside", "inside", "until", "till")
    return not is_order and not is_place and said.words[run.start - 1] != "to"


def _is_contradicted(words: Sequence[str]) -> bool:
    """Whether words are denied right behind them: "the baby not the baby"."""
    return any(word == "not" and words[i - 2 : i] == words[i + 1 : i + 3] for i, word in enumerate(words) if i > 1)


def _seeks(run: Sequence[str]) -> bool:
    """Whether somebody looks for words: "what's it called"."""
    return "what" in run or "whats" in run


def _is_broken_off(said: _Said, first: int, run: range) -> bool:
    """Whether a clause stops where none ends: at an article without its noun behind the run, or at the contraction of
    its verb ("if the baby's, ...")."""
    tokens, last = said.document.tokens, said.words[run.start - 1]
    if last in _UNFINISHED:
        return tokens[run.stop].pos not in ("NOUN", "PROPN", "ADJ")
    if last not in ("'s", "'re", "'ll") or said.words[run.start] not in _MARKS:
        return False
    return not any(token.pos in ("VERB", "AUX") for token in tokens[first : run.start - 1])


def _is_cut_short(said: _Said, run: range) -> bool:
    """Whether an order stops behind a preposition ("check under... check the table")."""
    last = said.document.tokens[run.start - 1]
    is_preposition = (last.tag == "IN" or last.dep == "prep" or last.lower in _PLACING) and not said.document.children[
        last.i
    ]
    return is_preposition and said.words[run.start] in _MARKS - {","}


def _stub(said: _Said, run: range) -> range:
    """The verb, with a particle or preposition at most, at which an order is broken off before a run: ", heat... well",
    "and turn on - no"; empty where none is."""
    words, tokens = said.words, said.document.tokens
    if words[run.start] not in _MARKS - {","}:
        return range(0)
    for first in range(run.start - 1, max(-1, run.start - 3), -1):
        if said.begins_clause(first) or words[first - 1] in ("and", "then", "or", "but"):
            is_verb = tokens[first].tag in ("VB", "VBP", "NN", "JJ") and words[first] == tokens[first].lemma
            is_led = all(token.pos in ("ADP", "PART", "DET") for token in tokens[first + 1 : run.start])
            return range(first, run.start) if is_verb and is_led else range(0)
    return range(0)


def _puts_right(said: _Said, run: range) -> bool:
    """Whether an order behind a run stands in place of the one before: that is taken back, or breaks off and the
    speaker thinks again."""
    is_instead = said.has(run, _TURNING) and "instead" in _clause_behind(said, run.stop)
    return said.is_strong(run) or is_instead or (bool(_stub(said, run)) and said.has(run, ("well", "just", "actually")))


def _clause_behind(said: _Said, start: int) -> Sequence[str]:
    """The words from there to the next mark."""
    stop = next((i for i in range(start, len(said.words)) if said.words[i] in _MARKS | ENDS), len(said.words))
    return said.words[start:stop]


def _put_otherwise(said: _Said, run: range) -> Collection[int]:
    """What stands before a run of editing words and is put otherwise behind it, with the run; empty for nothing."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, run.stop
    if left < 0 or right >= len(words):
        return range(0)
    order = _order_before(said, run) if _puts_right(said, run) else range(0)
    if order and not _takes_up(said, order, run):
        return order
    if not said.are_together(left, right):
        return range(0)
    is_strong = said.is_strong(run)
    is_broken = words[left] in _UNFINISHED and tokens[left].tag in ("DT", "PRP$") and tokens[left].text != "A"
    if is_broken and words[right] in _DETERMINERS:
        return range(left, right)  # "the, um, that one"
    if said.has(run, _PLACEHOLDERS):
        return range(0)  # "put the thingy on the table"
    if is_broken and words[right] == "not":
        return _contrasted(said, left, right)
    if is_broken and tokens[right].pos == "ADP" and left and tokens[left - 1].pos == "ADP":
        return range(left - 1, right)  # "in the, in that box"
    if is_broken and not is_strong:
        order = _order_before(said, run)
        if order and _has_object(said, order.stop):  # not "the, um, plug"
            return order
    if not is_strong:
        return range(0)
    if words[right] == "not":
        return _denied(said, run)
    if words[right] in _OPENERS:
        same = (i for i in range(left, -1, -1) if words[i] == words[right] and said.are_together(i, right))
        first = next(same, None)
        is_added = not {"also", "too"}.isdisjoint(words[right : right + 4])
        is_again = first is not None and said.begins_clause(first) and not is_added
        return range(first, right) if first is not None and is_again else range(0)
    return _phrase_before(said, run)


def _denied(said: _Said, run: range) -> range:
    """A phrase that is denied with its own words and another one named: "to the shed, no, not the shed, the garage";
    where it is only pointed at, no more than the denial ("the red pan, no, *not that one,* the flat one")."""
    words, tokens, again = said.words, said.document.tokens, run.stop + 1
    if words[again : again + 1] != [] and words[again] in _POINTING:
        stop = again + 1 + (words[again + 1 : again + 2] in (["one"], ["ones"]))
        is_other = stop + 1 < len(words) and words[stop] in _MARKS and words[stop + 1] in _DETERMINERS
        return range(run.stop, stop + 1) if is_other else range(0)
    for count in range(min(LONGEST, run.start), 0, -1):
        stop = again + count
        if words[again:stop] != words[run.start - count : run.start]:
            continue
        is_led = tokens[again].pos == "ADP"
        is_marked = words[stop : stop + 1] != [] and words[stop] in _MARKS
        while stop < len(words) and words[stop] in _MARKS:
            stop += 1
        kinds = {"DET", "NUM", *(("ADP",) if is_led else ()), *(("PROPN",) if is_marked else ())}
        is_other = stop < len(words) and (tokens[stop].pos in kinds or tokens[stop].tag == "PRP$")
        is_other = is_other and (is_marked or tokens[again + count - 1].pos != "PROPN")
        is_other = is_other and said.are_together(run.start, stop) and not said.states(stop)
        return range(run.start - count, stop) if is_other else range(0)
    return range(0)


def _dropped(said: _Said, run: range) -> range:
    """A condition that is dropped with a reason before anything hangs on it, where another one follows: "If Dan's in,
    no, he's at work. If Eva's in, ..."."""
    words, document = said.words, said.document
    if run.stop >= len(words) or not said.states(run.stop) or not said.is_strong(run):
        return range(0)
    first = next((i for i in range(run.start, -1, -1) if i == 0 or not said.are_together(i - 1, run.start)), 0)
    end = next((i for i in range(run.stop, len(words)) if not said.are_together(i, run.start)), len(words))
    opening = next((i for i in range(first, run.start) if words[i] not in _EDITING | _INTERJECTIONS), run.start)
    is_condition = words[opening] in ("if", "when") and not any(_is_order(document, i) for i in range(opening, end))
    is_again = words[end : end + 1] == [words[opening]] and not _STATING.intersection(words[end + 1 : end + 2])
    return range(first, end) if is_condition and is_again else range(0)


def _contrasted(said: _Said, left: int, right: int) -> range:
    """ "Get the, *not the green one,* the red one": up to the phrase that is meant."""
    words = said.words
    mark = next((i for i in range(right, min(right + LONGEST, len(words))) if words[i] in _MARKS), None)
    if mark is None or mark + 1 >= len(words) or words[mark + 1] not in _DETERMINERS:
        return range(0)
    return range(left, mark + 1)


def _phrase_before(said: _Said, run: range) -> Collection[int]:
    """The phrase before a run, and the run, where one of the same kind stands behind it: with a preposition, or with an
    article or number; "the red mug, no, the blue one" needs the noun of the first. A particle behind the phrase stays
    ("switch *the oven* on, no, the grill")."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, run.stop
    is_led = tokens[right].pos == "ADP" or tokens[right].tag == "RP"
    is_named = words[right] in _DETERMINERS or tokens[right].pos == "NUM"
    end = next((i for i in range(right + 1, len(words)) if tokens[i].pos not in _NAMING), len(words))
    is_clause = end < len(words) and tokens[end].pos in ("AUX", "VERB") and words[end] not in _BREAKS
    if is_named and (is_clause or tokens[end - 1].pos not in ("NOUN", "PROPN", "NUM")):
        return range(0)
    if not (is_led or is_named):
        return range(0)
    if not said.are_together(right, end - 1) or "one" in words[right : end + 1] or "ones" in words[right : end + 1]:
        return range(0)
    is_particle = tokens[left].tag == "RP" or tokens[left].dep == "prt"
    is_parted = is_named and not is_led and is_particle and words[right] in _DETERMINERS
    left -= is_parted
    first = left
    while first >= 0 and said.are_together(first, left) and left - first < LONGEST:
        token = tokens[first]
        if is_led and (token.pos == "ADP" or token.tag == "RP"):
            return range(first, right)
        if is_named and (words[first] in _DETERMINERS or token.pos == "NUM"):
            return [*range(first, left + 1), *range(run.start, right)] if is_parted else range(first, right)
        if token.pos not in _NAMING and token.tag != "PRP$":
            break
        first -= 1
    return range(0)


def _order_before(said: _Said, run: range) -> range:
    """The order before a run, and the run, where another order stands behind it, in its sentence or, where the run
    begins that, in the sentence before. What breaks off behind an "and" stands in place of nothing, unless it is said
    to be all: "wash it and... no, just dry it"."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, _order_behind(said, run)
    if left < 0 or right >= len(words) or not (said.are_together(left, right) or _is_second_thought(said, run, right)):
        return range(0)
    end = next((i for i in range(right, len(words)) if not said.are_together(i, right)), len(words))
    is_order = _is_order(said.document, right) or _is_wish(said, right + 2)
    is_other = is_order and words[right] not in _WITHDRAWING and right + 1 < end
    is_other = is_other and words[right + 1] not in _EDITING
    if not is_other or not _AHEAD.isdisjoint(words[right:end]) or {"and", "also"} & set(words[run.start : run.stop]):
        return range(0)
    stub = _stub(said, run)
    if stub:
        return range(stub.start, right)
    if words[left] in _COORDINATING:
        if "just" not in words[run.start : right]:
            return range(run.start, right)
        left -= 1
    for i in range(left - (words[left] in ENDS), -1, -1):
        if not said.are_together(i, left):
            break
        if _is_wish(said, i):
            return range(i - 2, right)
        if _is_order(said.document, i) and tokens[i].dep not in _WITHIN:
            is_subordinate = not _SUBORDINATING.isdisjoint(words[max(0, i - 2) : i])
            is_forbidden = i > 0 and words[i - 1] in ("not", "n't", "never")
            return range(0) if is_subordinate or is_forbidden else range(i, right)
        is_asked = words[i] in ("if", "whether") and any(t.lemma in _CHECKING for t in tokens[max(0, i - 3) : i])
        is_joined = words[i] in ("and", "or") and tokens[i + 1].pos in _NAMING
        is_asking = words[i] in _ASKING and (words[i] in _OPENING or said.begins_clause(i))
        if (words[i] in _BREAKS and not is_joined) or (is_asking and not is_asked):
            break
    return range(0)


def _is_wish(said: _Said, i: int) -> bool:
    """Whether a verb says what the speaker would like to have: "I'll *have* tea", "I'd *like* some"."""
    words = said.words
    return 1 < i < len(words) and words[i] in _WISHING and words[i - 1] in _WOULD and words[i - 2] in _WISHERS


def _order_behind(said: _Said, run: range) -> int:
    """Where the verb of an order behind a run would stand: "no, just *put* it here", "no, could you *put* it here"."""
    words, right = said.words, run.stop
    if right < len(words) and words[right] in _ASKING_FOR and words[right + 1 : right + 2] == ["you"]:
        right += 2
    while right < len(words) and words[right] in ("just", "please", "then"):
        right += 1
    return right


def _is_second_thought(said: _Said, run: range, right: int) -> bool:
    """Whether a run begins a sentence that puts an order of the sentence before right. "No, then turn it on" answers,
    and behind an "if" or a "yes" a lone "no" does so."""
    words, left = said.words, run.start - 1
    if words[left] not in ENDS and words[run.start] not in _DOTS:
        return False
    before = [words[i] for i in range(run.start) if said.are_together(i, left)]
    is_alone = {word for word in words[run.start : run.stop] if word not in _MARKS} <= _DENYING
    is_conditional = not {"if", "when", "unless", "whether"}.isdisjoint(before)
    return "then" not in words[run.stop : right] and not (is_alone and is_conditional)


def _has_object(said: _Said, verb: int) -> bool:
    """Whether an object that cannot be part of a compound follows a verb: "rinse the cups", "tell her"."""
    return any(token.tag in ("DT", "PRP", "PRP$") for token in said.document.tokens[verb + 1 : verb + 2])


def _takes_up(said: _Said, order: range, run: range) -> bool:
    """Whether the order in place of another, behind a run, speaks of what that names: "close the window, no, leave it
    open"."""
    end = next((i for i in range(order.stop, len(said.words)) if said.words[i] in _BREAKS), len(said.words))
    replaced = said.document.tokens[order.start + 1 : run.start]
    names = any(token.pos in ("NOUN", "PROPN") or token.dep in _NAMED for token in replaced)
    return names and not _TAKING_UP.isdisjoint(said.words[order.stop : end])


def _is_order(document: Document, i: int) -> bool:
    """Whether a token is a verb in its bare form whose subject is none but "you"; the tagger takes that of "hoover the
    stairs" for a noun, and that of "Empty the bin" for an adjective."""
    token, following = document.tokens[i], document.tokens[i + 1 : i + 2]
    clause = next((j + 1 for j in range(i - 1, -1, -1) if document.tokens[j].text in _MARKS), 0)
    near = (document.tokens[j] for j in document.children[i] if j >= clause)
    subjects = {token.lower for token in near if token.dep in _SUBJECTS}
    is_first = i == 0 or document.tokens[i - 1].text in ENDS
    kinds = ("NN", "NNP", "JJ") if is_first else ("NN",)
    is_verb = token.pos == "VERB" or (token.tag in kinds and bool(following) and following[0].tag in ("DT", "PRP$"))
    return is_verb and token.lower == token.lemma and subjects <= {"you"}
