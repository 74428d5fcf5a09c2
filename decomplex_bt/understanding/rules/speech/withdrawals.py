"""Withdrawals: the orders that are taken back ("put it in the oven, no, scratch that"), which are no tasks whatever a
model says of them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.cue_phrases import normal_form
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.speech.repairs import replaced_orders
from decomplex_bt.understanding.vocabulary import ONES

_MARKS = tuple(
    tuple(phrase.split())
    for phrase in (
        "scratch that", "scrap that", "strike that", "cancel that", "ignore that", "disregard that", "forget that",
        "forget it", "forget about that", "forget about it", "forget i said that", "forget i said anything",
        "never mind", "never mind that", "nevermind", "nevermind that", "scratch that last one", "forget that last one",
        "scratch that last bit", "forget that last bit", "scratch the last one", "forget the last one",
    )
)  # fmt: skip
"""What takes back the order before it, in the normal form of cues, where it is all that its clause says."""
_DENIALS = tuple(
    tuple(phrase.split())
    for phrase in (
        "do not", "do not bother", "do not do that", "do not do it", "leave that", "leave it", "leave them",
        "leave that where it is", "leave it where it is", "leave them where they is", "leave it there",
        "leave that there", "leave them there", "leave it be", "leave it alone", "leave that alone", "leave them alone",
        "leave it for now", "leave that for now", "leave it as it is",
    )
)  # fmt: skip
"""What does so behind a "no" or the like alone."""
_ADVICE = product(("", "maybe", "perhaps"), ("", "i had", "i 'd", "you had", "you 'd"), ("better not", "best not"))
_SECOND_THOUGHTS = (
    *(tuple(" ".join(words).split()) for words in _ADVICE),
    *((word, "not") for word in ("maybe", "perhaps", "rather")),
)
"""What does so only where an order stands ahead that asks nothing, for a question is answered so as well."""
_LONGEST_FIRST = tuple(sorted((*_MARKS, *_DENIALS), key=len, reverse=True))
_ORDERS = frozenset(("cancel", "ignore", "disregard", "scratch", "scrap", "strike"))
"""Marks that may be orders, of what a statement before them names."""
_ARGUING = frozenset(("scratch", "scrap", "strike", "cancel", "forget"))
"""Marks that may take back an argument alone, before a "that"."""
_LEAVING = frozenset(("it", "that", "them"))
_OF_THINGS = (("never", "mind"), ("nevermind",), ("forget",), ("forget", "about"))
"""What takes back the orders before it that are about the thing named next."""
_OF_DOINGS = (*_OF_THINGS, ("skip",))
"""What takes back the order before it whose verb is named next: "skip *the ironing*"."""
_REVERSING = frozenset("actually no nah nope wait sorry oh hang hold".split())
"""What turns a speaker round: it opens a clause, with or without a mark ahead of it."""
_CORRECTING = frozenset("no nope wait sorry actually".split())
_RUN_ON = frozenset(("no", "nope", "sorry"))
_LEADING = frozenset(("DT", "PRP$"))
"""What opens a phrase behind one of these where no mark stands between: "no *the green one*"."""
_YES = frozenset("yes yeah yep yup".split())
_DENYING = frozenset(("no", "nope", "nah"))
_TELLING = _REVERSING | {phrase[0] for phrase in (*_MARKS, *_OF_DOINGS)} | {"mean", "meant", "rather", "not"}
"""Words of which every withdrawal has one."""
_OPENERS = _REVERSING | frozenset(
    "well ok okay on um uh er erm ah hm hmm but and so you know what or then just second thoughts thought".split()
)
"""What says nothing ahead of a mark."""
_GOING_ON = frozenset("and but just please instead".split())
_LAST = frozenset(("one", "bit"))
_POINTING = frozenset("the that this those these".split())
_CONDITIONAL = frozenset("if only_if unless when fail so until depending".split())
_ELSE = frozenset(("otherwise", "else", "alternatively"))
_BREAKS = MARKS | {"...", "…"}
_CLAUSE_BREAKS = _BREAKS | frozenset(("and", "but", "then", "or"))
_OF_VERBS = frozenset(("for", "at", "after"))
"""Prepositions whose noun is what a verb is about: "look for the keys"."""
_AGAIN = frozenset(("it", "them", "those", "these"))
_NO_ARGUMENTS = frozenset("no thanks thank sorry please next one my our".split())
_NOMINAL = frozenset(("NOUN", "PROPN", "ADJ", "NUM"))
_SUBJECT_WORDS = frozenset(("i", "we", "you", "he", "she", "they", "it", "there"))
_SUBJECTS = frozenset(("nsubj", "nsubjpass", "expl"))


class Withdrawals(NamedTuple):
    """What is taken back: `tokens` of orders, with the words that take them back; `corrections`: the phrases that come
    in place of an argument before them ("scratch that, the red one")."""

    tokens: frozenset[int]
    corrections: tuple[range, ...]


def withdrawals_of(observed: Observed) -> Withdrawals:
    """What an instruction takes back.

    "Scratch that" and the like, a clause of their own said to the robot, take back the order before them in their
    sentence or, where they begin it, the sentence before; "no, leave it on the table" does so and is an order itself;
    "never mind the shirt" takes back the earlier orders about the shirt, "skip the ironing" the last one to iron.
    Behind a condition in their sentence they are said of one case alone, which is for the flow to say. Before a bare
    phrase they take back an argument. An order that another one stands in place of is taken back, too, where it is not
    passed over as a repair.
    """
    if _TELLING.isdisjoint(token.lower for token in observed.document.tokens):
        return _NOTHING  # as with most instructions
    words = _Words.of(observed)
    tokens = {i for order in replaced_orders(observed.document) for i in order}
    corrections: list[range] = []
    for at in range(len(words.tokens)):
        if (words.opens(at) or words.corrects(at)) and not words.is_conditional_before(at):
            found = _taken_back(words, at)
            tokens |= found.tokens
            corrections += [phrase for phrase in found.corrections if phrase not in corrections]
    return Withdrawals(frozenset(tokens), tuple(corrections))


_NOTHING = Withdrawals(frozenset(), ())


@dataclass(frozen=True, slots=True)
class _Words:
    """A document's words in normal form. `openings`: tokens that open conditions; `conditional`: their sentences."""

    document: Document
    tokens: Sequence[Token]
    said: Sequence[str]
    openings: Collection[int]
    conditional: Collection[int]

    @classmethod
    def of(cls, observed: Observed) -> _Words:
        document = observed.document
        said = [normal_form(token.lower) for token in document.tokens]
        openings = [cue.first for cue in observed.cues if cue.name in _CONDITIONAL]
        openings += [i for i, word in enumerate(said) if word in _ELSE]
        return cls(document, document.tokens, said, openings, {document.sentences[i] for i in openings})

    def opens(self, at: int) -> bool:
        """Whether a clause begins here, or behind words that say nothing."""
        lead = self._lead(at)
        is_start = lead == 0 or self._begins_sentence(lead)
        return is_start or any(word in _BREAKS or word in _REVERSING for word in self.said[lead:at])

    def is_reversed(self, at: int) -> bool:
        """Whether the speaker turns round right before here: "no, ...", "actually ..."."""
        return any(word in _REVERSING for word in self.said[self._lead(at) : at])

    def corrects(self, at: int) -> bool:
        """Whether a speaker turns round right before here to put something right: "no wait, ...", "I mean ..."."""
        lead = self.said[self._lead(at) : at]
        if not {"and", "also", "or", "just", "so"}.isdisjoint(lead):
            return False
        is_meant = tuple(self.said[max(0, at - 2) : at]) in (("i", "mean"), ("i", "meant"), ("or", "rather"))
        is_next = bool(lead) and lead[-1] in _RUN_ON and self.tokens[at].tag in _LEADING
        is_set_off = len(lead) > 1 and lead[-1] == "actually" and lead[-2] in _BREAKS
        return (
            is_meant
            or is_set_off
            or is_next
            or self.denies_one(at)
            or (not _CORRECTING.isdisjoint(lead) and bool(lead) and lead[-1] in _BREAKS)
        )

    def denies_one(self, at: int) -> bool:
        """Whether one of several is denied right before here, and another one named: "*not that one*, the long one"."""
        return self.denial(at) < at and any(word in ONES for word in self.said[_clause(self.said, at)])

    def is_denied(self, at: int) -> bool:
        """Whether a "no" stands right before here, or an "actually" that goes on with nothing else."""
        lead = self.said[self._lead(at) : at]
        return not _DENYING.isdisjoint(lead) or ("actually" in lead and {"and", "just", "so"}.isdisjoint(lead))

    def closes(self, stop: int, is_reversed: bool) -> bool:
        """Whether a clause ends before `stop`; behind a "no" also where another verb follows without a mark."""
        if stop >= len(self.said) or self.said[stop] in _BREAKS or self._begins_sentence(stop):
            return True
        is_reason = is_reversed and self.said[stop] in _SUBJECT_WORDS and stop + 1 < len(self.said)
        is_reason = is_reason and self.tokens[stop + 1].pos == "AUX"  # "no, scratch that it's too late"
        return self.said[stop] in _GOING_ON or is_reason or (is_reversed and self.tokens[stop].tag in ("VB", "VBP"))

    def is_conditional_before(self, at: int) -> bool:
        sentences = self.document.sentences
        is_in_case = any(i < at and sentences[i] == sentences[at] for i in self.openings)
        return is_in_case or self._is_answered(at)

    def _is_answered(self, at: int) -> bool:
        """Whether a "no" ahead of a clause is one of two answers: "tap dripping? Yes: ... *No*: forget it"."""
        lead = self._lead(at)
        is_denied = self.said[lead] in _DENYING and self._begins_sentence(lead)
        return is_denied and any(self.said[i] in _YES and self._begins_sentence(i) for i in range(1, lead))

    def is_conditional_behind(self, at: int) -> bool:
        sentences = self.document.sentences
        return any(i > at and sentences[i] == sentences[at] for i in self.openings)

    def is_verbless_before(self, at: int) -> bool:
        """Whether something stands ahead in the sentence, and no verb."""
        sentences = self.document.sentences
        said = [i for i in range(self._lead(at)) if sentences[i] == sentences[at]]
        return bool(said) and not any(self.tokens[i].pos in ("VERB", "AUX") or _is_bare(self.document, i) for i in said)

    def _begins_sentence(self, at: int) -> bool:
        return at > 0 and self.document.sentences[at] != self.document.sentences[at - 1]

    def denial(self, at: int) -> int:
        """Where the "not the short one," begins that stands right before here, at the beginning of its clause; `at`
        itself where none does."""
        if at < 4 or self.said[at - 1] not in MARKS - ENDS or self.said[at - 2] not in ONES:
            return at
        start = next((i for i in range(at - 4, max(-1, at - 7), -1) if self.said[i] == "not"), at)
        is_pointed = start < at and self.said[start + 1] in _POINTING
        is_clause = start == 0 or self.said[start - 1] in _BREAKS or self._begins_sentence(start)
        return start if is_pointed and is_clause else at

    def _lead(self, at: int) -> int:
        """Where the words and marks begin that say nothing ahead of a clause, in its sentence."""
        at = self.denial(at)
        while at and not self._begins_sentence(at) and (self.said[at - 1] in _OPENERS or self.said[at - 1] in _BREAKS):
            if self.said[at - 1] in _DENYING and at > 1 and self.said[at - 2] == "if":
                break  # "if no, leave it"
            at -= 1
        return at


def _clause(said: Sequence[str], at: int) -> slice:
    """The words from there to the next mark or joint."""
    return slice(at, next((i for i in range(at, len(said)) if said[i] in _CLAUSE_BREAKS), len(said)))


def _taken_back(words: _Words, at: int) -> Withdrawals:
    """What the clause that begins at `at` takes back, with its own words; nothing where it takes nothing back."""
    is_reversed = words.is_reversed(at)
    for mark in _LONGEST_FIRST:
        if mark in _DENIALS and not is_reversed:
            continue
        stop = at + len(mark)
        if tuple(words.said[at:stop]) == mark and words.closes(stop, is_reversed):
            before = _before(words, at, is_last=mark[-1] in _LAST)
            if mark[0] in _ORDERS and not is_reversed and _is_statement(words, before):
                return _NOTHING  # "The timer is on. Cancel that."
            if words.is_verbless_before(at):
                return _NOTHING  # "Full, forget it. Empty, throw it away."
            own = frozenset(range(at, stop))
            phrase = _phrase(words, stop) if mark[0] in _ARGUING and mark[-1] == "that" else range(0)
            return Withdrawals(own, (phrase,)) if phrase else Withdrawals(own | before, ())
    if any(tuple(words.said[at : at + len(each)]) == each for each in _SECOND_THOUGHTS):
        stop = words.said.index("not", at) + 1
        before = _before(words, at, is_last=True) if words.closes(stop, is_reversed=False) else frozenset()
        is_question = any(words.said[i] in ("if", "whether") for i in before)
        if not is_question and any(_is_bare(words.document, i) for i in before):
            return Withdrawals(before.union(range(at, stop)), ())
    if words.is_denied(at) and words.said[at] == "leave" and set(words.said[at + 1 : at + 2]) & _LEAVING:
        return Withdrawals(_before(words, at, is_last=True), ())  # "no, leave it on the table"
    phrase = _phrase(words, at) if words.corrects(at) else range(0)
    if (
        phrase
        and _is_complete(words, phrase)
        and any(_is_bare(words.document, i) for i in _before(words, at, is_last=True))
    ):
        return Withdrawals(frozenset(), (phrase,))  # "the green mug. No wait, the white one."
    for mark in _OF_DOINGS:
        stop = at + len(mark)
        if tuple(words.said[at:stop]) == mark:
            about = _done(words, at, stop) or (_about(words, at, stop) if mark in _OF_THINGS else set())
            if about:
                return Withdrawals(frozenset(about.union(range(at, stop))), ())
    return _NOTHING


def _phrase(words: _Words, at: int) -> range:
    """The bare phrase that follows, in place of an argument: "scratch that, the red one"; empty where none does."""
    while at < len(words.said) and (words.said[at] in _OPENERS or words.said[at] in _BREAKS):
        if words.said[at] in ENDS:
            return range(0)
        at += 1
    stop = _clause(words.said, at).stop
    phrase = words.tokens[at:stop]
    if not phrase or phrase[0].pos not in ("ADP", "DET", "NUM", "ADJ", "NOUN", "PROPN", "PRON"):
        return range(0)
    if phrase[0].lower in _NO_ARGUMENTS:
        return range(0)
    if (
        any(token.pos in ("VERB", "AUX") or _is_being(words, token.i) for token in phrase)
        or phrase[0].lower in _SUBJECT_WORDS
    ):
        return range(0)
    # "water the roses": what is no verb to the tagger may be one
    is_order = phrase[0].pos in ("NOUN", "PROPN", "ADJ") and len(phrase) > 1 and phrase[1].pos in ("DET", "PRON")
    return range(0) if is_order else range(at, stop)


def _is_complete(words: _Words, phrase: range) -> bool:
    """Whether a phrase names something by itself: "the white one", "in the kitchen"; neither "sugar" nor "thanks"."""
    first, last = words.tokens[phrase.start], words.tokens[phrase.stop - 1]
    is_named = last.pos in ("NOUN", "PROPN") or last.lower in ONES
    return first.tag in ("DT", "PRP$", "IN", "CD") and is_named and len(phrase) > 1


def _is_being(words: _Words, at: int) -> bool:
    """Whether a "'s" is no genitive: "the cat's out"."""
    return words.said[at] == "is" and words.tokens[at + 1 : at + 2] != () and words.tokens[at + 1].pos not in _NOMINAL


def _before(words: _Words, at: int, *, is_last: bool) -> frozenset[int]:
    """What a mark at `at` takes back: the order before it in its sentence, else the sentence before it (`is_last`: the
    last order of that); nothing where a condition is in its own sentence. With what stands between."""
    sentences = words.document.sentences
    said = [i for i in range(words.denial(at)) if sentences[i] == sentences[at]]
    own = any(words.said[i].isalpha() and words.said[i] not in _OPENERS for i in said)
    if not own:
        said = [i for i in range(at) if sentences[i] == sentences[at] - 1]
    if not said or (own and words.is_conditional_before(at)):
        return frozenset()
    start = _order(words, said) if own or is_last else said[0]
    return frozenset(range(start, at))


def _order(words: _Words, said: Sequence[int]) -> int:
    """Where the last order among some tokens begins."""
    for i in reversed(said):
        begins = i == said[0] or words.said[i - 1] in _CLAUSE_BREAKS or words.said[i - 1] in _OPENERS
        if begins and _is_bare(words.document, i):
            return i
    return said[0]


def _is_bare(document: Document, i: int) -> bool:
    """Whether a token at the beginning of a clause is a verb in its bare form without a subject, as in an order; the
    tagger takes that of "water the roses" for a noun."""
    token, following = document.tokens[i], document.tokens[i + 1 : i + 2]
    is_verb = token.tag in ("VB", "VBP") or (
        token.tag in ("NN", "JJ", "IN") and bool(following) and following[0].tag in ("DT", "PRP$")
    )
    return is_verb and not any(document.tokens[j].dep in _SUBJECTS for j in document.children[i])


def _is_statement(words: _Words, said: Collection[int]) -> bool:
    """Whether something is told and nothing ordered."""
    tokens = words.tokens
    has_subject = any(tokens[i].dep in _SUBJECTS and tokens[i].lower != "you" for i in said)
    return has_subject and not any(_is_bare(words.document, i) for i in said)


def _about(words: _Words, at: int, noun: int) -> set[int]:
    """The tokens of the orders before `at` about the noun phrase that begins at `noun` and ends the clause, and of
    those right behind them that are about "it"."""
    document, tokens = words.document, words.tokens
    stop = noun
    while stop < len(tokens) and tokens[stop].pos in ("DET", "PRON", "NUM", "ADJ", "NOUN", "PROPN"):
        stop += 1
    nouns = [i for i in range(noun, stop) if tokens[i].pos in ("NOUN", "PROPN")]
    if not nouns or tokens[noun].pos not in ("DET", "PRON") or not words.closes(stop, is_reversed=False):
        return set()
    if words.is_conditional_behind(at):
        return set()
    head = tokens[nouns[-1]].lemma
    details = {tokens[i].lemma for i in range(noun, nouns[-1]) if tokens[i].pos in ("ADJ", "NOUN", "PROPN", "NUM")}
    found: set[int] = set()
    was_about = False
    for clause in _clauses(words, at):
        is_about = any(tokens[i].lemma == head and _is_object(document, i, details) for i in clause)
        goes_on = was_about and not any(tokens[i].pos in ("NOUN", "PROPN") for i in clause)
        was_about = is_about or (goes_on and any(words.said[i] in _AGAIN for i in clause))
        if was_about and document.sentences[clause[0]] not in words.conditional:
            found.update(clause)
    return found


def _done(words: _Words, at: int, doing: int) -> set[int]:
    """The tokens of the last order before `at` whose verb is named at `doing`, to the end of the clause: "skip *the
    ironing*", "skip *ironing them*", with that clause; nothing where a case follows."""
    tokens = words.tokens
    is_noun = doing < len(tokens) and tokens[doing].tag in _LEADING
    doing += is_noun
    stop = next((i for i in range(doing, len(tokens)) if words.closes(i, is_reversed=False)), len(tokens))
    if (
        stop == doing
        or words.is_conditional_behind(at)
        or not all(_may_tell(tokens[i]) for i in range(doing + 1, stop))
    ):
        return set()
    if is_noun and doing + 1 < stop and tokens[doing + 1].pos in ("NOUN", "PROPN"):
        return set()  # "skip the ironing board"
    named = tokens[doing].lower
    meant = frozenset(lemmas(named)) - {named} if named.endswith("ing") else frozenset()
    for clause in reversed(list(_clauses(words, at))):
        verb = next((i for i in clause if tokens[i].lower in meant), None)
        if verb is None:
            continue
        # the tagger takes the verb of "Vacuum the hall" for a name
        is_plain = (verb == clause[0] or _is_bare(words.document, verb)) and words.document.sentences[
            verb
        ] not in words.conditional
        return {*clause, *range(doing, stop)} if is_plain else set()
    return set()


def _may_tell(token: Token) -> bool:
    """Whether a word behind a verb may tell what it is done to, or goes with it: "the washing *up*"."""
    return token.pos in ("DET", "PRON", "ADJ", "NOUN", "PROPN", "NUM", "ADP", "PART", "ADV")


def _clauses(words: _Words, stop: int) -> Iterator[list[int]]:
    """The clauses before `stop`, cut at marks and conjunctions."""
    clause: list[int] = []
    for i in range(stop):
        if words.said[i] in _CLAUSE_BREAKS:
            if clause:
                yield clause
            clause = []
        else:
            clause.append(i)
    if clause:
        yield clause


def _is_object(document: Document, noun: int, details: set[str]) -> bool:
    """Whether a noun is what its verb is about, with at least these details ("the red mug" is no blue one)."""
    tokens = document.tokens
    if tokens[noun].dep == "pobj":
        preposition = tokens[tokens[noun].head]
        if preposition.lower not in _OF_VERBS or tokens[preposition.head].pos != "VERB":
            return False
    own = {tokens[i].lemma for i in document.children[noun]}
    is_joined = tokens[noun].dep == "conj" or any(tokens[i].dep == "conj" for i in document.children[noun])
    return details <= own and not is_joined  # of "the shirt and the socks" one is left
