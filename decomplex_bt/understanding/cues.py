"""Cues: where a document has the phrases that say how its tasks hang together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS, LONGEST, PRO_FORMS, TABLE, normal_form
from decomplex_bt.understanding.document import ENDS, FINITE, MARKS, Document, Token
from decomplex_bt.understanding.rules.cases.certain_cases import certain_cases
from decomplex_bt.understanding.rules.cases.concessions import concessions
from decomplex_bt.understanding.rules.cases.expectations import expectations
from decomplex_bt.understanding.rules.speech.repairs import replaced_orders


@dataclass(frozen=True, slots=True)
class Cue:
    """An occurrence of a cue phrase: its class and the tokens from `first` to `last`, inclusive."""

    name: str
    first: int
    last: int


def find_cues(document: Document) -> tuple[Cue, ...]:
    """All cues of a document from left to right but those of orders that others stand in place of; an "if" or "whether"
    after a verb of asking is `whether`."""
    words = [normal_form(token.lower) for token in document.tokens]
    for i in range(len(words) - 1):
        if words[i] == "b4" and words[i + 1] in _AFTER_BEFORE:  # "b4 u go"; "shelf B4" is none
            words[i] = "before"
    cues: list[Cue] = []
    position = 0
    while position < len(words):
        length, names = _longest(words, position)
        if _PRO_BEFORE.intersection(names) and _opens_clause(document, position, position + length - 1):
            length, names = 1, ("before",)
        if PRO_FORMS.intersection(names) and _goes_on(document, words, position, position + length):
            length, names = 1, TABLE.get((words[position],), ())  # "if no cup is clean"
        if {"fail", "so"}.intersection(names) and _is_of_thing(document, words, position, position + length):
            length, names = 1, TABLE.get((words[position],), ())  # "bring me the torch. If it doesn't work, ..."
        is_asked = _disambiguated(words[position], document, position) == "whether"  # "check if something goes wrong"
        is_asked = is_asked and not _is_of_told(document, words, position)
        if "fail" in names and (is_asked or _is_named(words, position)):
            length, names = 1, tuple(name for name in TABLE.get((words[position],), ()) if name != "fail")
        if words[position : position + length] == _IN_CASE and not _opens_case(document, position):
            length, names = 1, ()  # "put it in the case that is open"
        if length == 1 and _is_adjective(document, words, position):
            names = ()
        if length == 1 and "if" in names and _is_request(words, position):
            names = ("please",)
        if names == ("instead",) and _counts(document, position):
            names = ()
        if "not" in names and words[position + 1 : position + 2] == ["forget"]:
            names = ()  # "don't forget to lock up if you leave"
        is_before = names == ("before",)
        if is_before and (_is_forbidden_before(document, words, position) or _forbids_first(words, position)):
            names = ("until",)
        for name in names:
            cues.append(Cue(_disambiguated(name, document, position), position, position + length - 1))
        position += max(1, length)
    said = {i for cue in cues if cue.name in PRO_FORMS for i in range(cue.first, cue.last + 1)}
    cues += [cue for cue in _answers(document, words) if cue.first not in said and cue.last not in said]
    cues += [Cue("if", i, i) for i in range(len(words)) if _inverts(document, i)]
    cues += [Cue("until", one.opening, one.opening) for one in expectations(document)]  # "wait *for* it to boil"
    for conceded in concessions(document):  # "whether it is or not, ..." opens no condition
        cues = [cue for cue in cues if cue.first not in conceded]
        cues.append(Cue("either_way", conceded.start, conceded.stop - 1))
    if not _NO.isdisjoint(words):
        replaced = {i for order in replaced_orders(document) for i in order}
        cues = [cue for cue in cues if cue.first not in replaced]
    return tuple(sorted(cues, key=lambda cue: cue.first))


def _opens_case(document: Document, position: int) -> bool:
    return any(case.words.start == position for case in certain_cases(document))


def _is_request(words: Sequence[str], position: int) -> bool:
    """Whether an "if" only asks for something: "I should be most obliged *if* you would find it"; not "I'd be glad if
    you would wait if he's out"."""
    start = next((i + 1 for i in range(position - 1, -1, -1) if words[i] in ENDS), 0)
    ahead = words[start:position]
    is_thanked = not _THANKING.isdisjoint(ahead) and not _WOULD.isdisjoint(ahead) and "if" not in ahead
    you, verb = [*words[position + 1 : position + 3], "", ""][:2]
    return is_thanked and you == "you" and verb in _ASKED


def _counts(document: Document, instead: int) -> bool:
    """Whether an "instead" only says how many there were to be: "three instead of four"."""
    behind = document.tokens[instead + 1 : instead + 3]
    return len(behind) == 2 and behind[0].lower == "of" and behind[1].pos == "NUM"


def _goes_on(document: Document, words: Sequence[str], position: int, end: int) -> bool:
    """Whether words that may stand for a whole condition only begin one: "if no cup is clean", "if any (of them) are
    dirty"; where nothing was said before, that they could mean, also "if none of the cups is clean" and "if you are
    unable to open it"; and "if none comes" and "if none of them is open" say themselves what does not, or what none
    is."""
    if words[position:end] == _IF_ANY:
        behind = words[end : end + 2]
        is_handled = behind[1:] in (["it"], ["them"]) and behind[0] != "of"  # "if any *kill* them"
        is_order = is_handled or not (_AFTER_PRO_FORM | _ORDERED).isdisjoint(behind[:1])
        return bool(behind) and behind[0].isalpha() and not is_order
    is_first = not any(token.pos == "VERB" for token in document.tokens[:position])
    comes = document.tokens[end] if end < len(words) else None
    is_of_none = words[end - 1] == "none" and comes is not None and comes.pos == "VERB" and comes.tag in ("VBZ", "VBP")
    is_of_none = is_of_none or _denies_some(words, end)
    is_known = words[position] == "if" and (is_first or words[end - 1] == "no" or is_of_none)
    if words[position] != "if" or not (is_known or _denies_named(document, words, end)):
        return False
    rest = document.tokens[end : next((t.i for t in document.tokens[end:] if t.text in MARKS), len(document))]
    if words[end - 1] in ("able", "unable", "possible", "impossible", "to"):
        return any(token.tag == "VB" for token in rest[:2])
    if words[end - 1] not in ("no", "nothing", "none", "neither"):
        return False
    if words[end - 1] == "no" and _names(rest):
        return True  # "if no bread left, ..."
    return any(
        token.tag in FINITE and token.dep in ("ROOT", "advcl", "aux", "auxpass", "ccomp", "conj") for token in rest
    ) or words[end : end + 1] in (["one"], ["body"])


def _denies_some(words: Sequence[str], end: int) -> bool:
    """Whether a "none" or "neither" says of those spoken of how, or where, none is: "if none of them *is open*"."""
    rest = words[end + 2 :] if words[end : end + 1] == ["of"] else words[end:]
    return words[end - 1] in ("none", "neither") and rest[:1] in (["is"], ["are"], ["was"], ["were"])


def _denies_named(document: Document, words: Sequence[str], end: int) -> bool:
    """Whether a "none", "neither" or "nothing" says of which things: "none of the windows", "neither lamp", "nothing is
    in the box"; not "none of that"."""
    rest = document.tokens[end : next((t.i for t in document.tokens[end:] if t.text in MARKS), len(document))]
    denied = words[end - 1]
    if denied == "none" and words[end : end + 1] == ["of"]:
        return len(rest) > 2 and rest[1].tag in ("DT", "PRP$", "CD") and _is_thing(rest[2:])
    if denied == "neither":
        return _is_thing(rest)
    place = next((k for k, token in enumerate(rest) if token.tag == "IN"), len(rest))
    return denied == "nothing" and words[end : end + 1] == ["is"] and any(t.pos == "NOUN" for t in rest[place:])


def _is_thing(rest: Sequence[Token]) -> bool:
    """Whether a noun begins here, be it with adjectives ahead."""
    named = next((token for token in rest if token.pos not in ("ADJ", "NUM")), None)
    return named is not None and named.tag in ("NN", "NNS") and named.lemma not in _NO_THINGS


def _names(rest: Sequence[Token]) -> bool:
    """Whether the words up to a mark name something that is missing, and say no more: "clean cups", "bread left"."""
    place = next((k for k, token in enumerate(rest) if token.tag == "IN"), len(rest))
    named = [token for token in rest[:place] if token.lower not in ("left", "there", "around", "available")]
    are_nouns = 0 < len(named) < 4 and all(token.tag in _NOMINAL for token in named)
    return are_nouns and named[-1].tag.startswith("NN")


def _is_adjective(document: Document, words: Sequence[str], position: int) -> bool:
    """Whether a "next", "first" or "last" says where, when or which: "next to the sink", "the first plate"."""
    behind = words[position + 1 : position + 2]
    if words[position] == "next":
        return not _BEHIND_NEXT.isdisjoint(behind)
    if words[position] not in ("first", "last"):
        return False
    is_noun = position + 1 < len(words) and document.tokens[position + 1].pos == "NOUN"
    is_of_noun = position > 0 and document.tokens[position - 1].tag in ("DT", "PRP$") and is_noun
    is_of_noun = is_of_noun and not _OF_TIME.intersection(behind)  # "the first thing", not the first in a list
    return is_of_noun or (words[position] == "last" and not _BEHIND_LAST.isdisjoint(behind))


def _is_named(words: Sequence[str], position: int) -> bool:
    """Whether a noun that may stand for a failure is part of a clause that goes on: "it is no good", "a fallback"."""
    return words[position] in _NOUNS_OF_FAILURE and position > 0 and words[position - 1] in _AHEAD_OF_NOUNS


def _is_of_told(document: Document, words: Sequence[str], position: int) -> bool:
    """Whether an "if you can't" says when somebody is told something, behind an order: "shut it and tell me if you
    can't"."""
    ahead = document.tokens[max(0, position - 2) : position]
    is_told = any(token.lemma in _TELLING for token in ahead)
    is_behind = any(token.pos == "VERB" for token in document.tokens[: max(0, position - 3)])
    return is_told and is_behind and tuple(words[position + 1 : position + 4]) in _FAILING


def _is_forbidden_before(document: Document, words: Sequence[str], position: int) -> bool:
    """Whether a "before" says until when something is forbidden: "don't start it before it's full"."""
    for i in range(position - 1, 0, -1):
        if document.tokens[i].text in MARKS or document.tokens[i].tag == "CC":
            return False
        if words[i] in ("not", "never") and document.tokens[i + 1].tag == "VB":
            return words[i] == "never" or words[i - 1] in ("do", "must", "should")
    return words[0] == "never" and position > 1


def _is_of_thing(document: Document, words: Sequence[str], position: int, end: int) -> bool:
    """Whether an "if it does not work" or "if it works" is of the thing that was fetched or put somewhere right before,
    and not of what was tried."""
    if tuple(words[position : position + 2]) != ("if", "it") or words[end - 1] not in ("work", "works"):
        return False
    sentence = document.sentences[position]
    before = [t for t in document.tokens[:position] if sentence - 1 <= document.sentences[t.i] <= sentence]
    verbs = [t for t in before if t.pos == "VERB" or (t.i == 0 and t.lemma in _FETCHING | _PUTTING)]
    if not verbs or not _TRYING.isdisjoint(words[max(0, verbs[0].i - 1) : position]):
        return False
    last = verbs[-1]
    object_ = next((t for t in before if t.i > last.i and t.tag in ("NN", "NNS", "PRP", "NNP")), None)
    is_fetched = any(t.lemma in _FETCHING for t in verbs)
    is_put = last.lemma in _PUTTING and object_ is not None and (object_.tag != "PRP" or is_fetched)
    is_handled = last.lemma in _FETCHING or is_put
    particles = (t.lower for t in before if t.i > last.i and (t.tag == "RP" or t.dep == "prt"))
    return is_handled and _LOOSENING.isdisjoint(particles)


_FETCHING = frozenset("bring get fetch grab take hand give pass carry pick collect borrow buy lend".split())
_PUTTING = frozenset("put place set stand".split())
_TRYING = frozenset("try see attempt manage".split())
_LOOSENING = frozenset("off out apart open loose back on".split())


def _forbids_first(words: Sequence[str], position: int) -> bool:
    """Whether a "before" that opens a sentence says until when something is forbidden behind it: "before it is dry,
    don't touch it"; not "before you go, don't wake him", where it says when."""
    if position and words[position - 1] not in MARKS:
        return False
    stop = next((i for i in range(position, len(words)) if words[i] in MARKS - {","}), len(words))
    clause = words[position:stop]
    denied = next((i for i in range(3, len(clause)) if clause[i] == "not" and clause[i - 1] in ("do", "must")), 0)
    denied = denied or next((i for i in range(3, len(clause)) if clause[i] == "never"), 0)
    is_so = not _BEING.isdisjoint(clause[:denied])
    return is_so and denied + 1 < len(clause) and clause[denied + 1] not in ("forget", "hesitate", "fail")


_THANKING = frozenset(
    "obliged grateful appreciate appreciated thankful glad delighted pleased kind lovely wonderful great nice good "
    "helpful help love marvellous brilliant".split()
)
_WOULD = frozenset("would should could 'd will 'll".split())
_ASKED = frozenset("would could can might please kindly just found brought put took gave".split())
_BEING = frozenset(("is", "have", "has", "m", "'m"))
_TELLING = frozenset(("tell", "know", "inform", "text"))
_FAILING = frozenset((("you", "can", "not"), ("you", "do", "not"), ("you", "could", "not")))
_NOUNS_OF_FAILURE = frozenset(("no", "fallback", "plan", "worst"))
_AHEAD_OF_NOUNS = frozenset("a an the my your his her our their is be with of this that any".split())
_BEHIND_NEXT = frozenset(("to", "door", "time", "week", "one", "morning", "day", "room"))
_OF_TIME = frozenset("thing step order task job stop priority place one bit part".split())
_BEHIND_LAST = frozenset(("one", "ones", "night", "time", "week", "year", "piece", "bit", "drop", "few"))
_PRO_BEFORE = frozenset(("before_that", "before_all"))
_NO_THINGS = frozenset("above place option time way case luck thing".split())
_NOMINAL = frozenset("JJ NN NNS NNP NNPS CD VBN".split())
_AFTER_BEFORE = frozenset(
    "you i he she it we they that this the my your ur his her our their any all doing going".split()
)


_SHORT = 2
"""Behind how many more words than the first a "this" or "that" hardly tells of a noun: "before any of this"."""


def _opens_clause(document: Document, first: int, last: int) -> bool:
    """Whether a "before that" or "before both" goes on: "before that meeting", "before all that noise starts"; an
    order that is taken for a noun is no such thing ("before any of this *check the oven*")."""
    for token in document.tokens[first + 1 : last + 1]:
        head = document.tokens[token.head]
        if token.dep == "det" and last - first > _SHORT and head.dep not in ("nsubj", "nsubjpass"):
            continue
        if last < token.head and (
            token.dep in ("det", "predet") or (token.dep in ("nsubj", "nsubjpass") and head.tag in ("VBZ", "VBD", "MD"))
        ):
            return True
    return False


def _inverts(document: Document, i: int) -> bool:
    """Whether token `i` opens a condition by inversion: "should there be any", "were it to rain"."""
    tokens = document.tokens
    if tokens[i].lower not in _INVERTING or i + 1 >= len(tokens):
        return False
    opens = (
        i == 0 or tokens[i - 1].text in MARKS or tokens[i - 1].lower in ("and", "but", "or", "so", "please", "kindly")
    )
    if tokens[i].lower == "should" and tokens[i + 1].tag in _SUBJECT_TAGS and tokens[i].dep == "aux":
        subject = next(
            (t for t in tokens if t.head == tokens[i].head and t.dep in ("nsubj", "nsubjpass", "expl")), None
        )
        opens = opens or (subject is not None and subject.i > i)
    if not opens or tokens[i + 1].tag in ("VB", "VBP", "MD") or tokens[i + 1].lower in ("i", "we"):
        return False
    end = next((t.text for t in tokens[i:] if t.text in (".", "?", "!", ";")), "")
    return end != "?" or any(t.text == "," for t in tokens[i : i + 14])


_INVERTING = frozenset(("should", "were", "had"))
_SUBJECT_TAGS = frozenset(("PRP", "PRP$", "DT", "EX", "NN", "NNS", "NNP", "NNPS"))


def _answers(document: Document, words: Sequence[str]) -> list[Cue]:
    """Short negative or positive replies between two marks ("No?", "not there?", "no bread?"): they stand for a whole
    condition as "if not" and "if so" do."""
    found = []
    start = 0
    for i, token in enumerate(document.tokens):
        if token.text not in MARKS:
            continue
        inside = words[start:i]
        if 2 < len(inside) <= _LONGEST_ANSWER + 1 and "or not" in " ".join(inside):  # "wet or not", "dry or not dry"
            found.append(Cue("either_way", start, i - 1))
        elif 0 < len(inside) <= _LONGEST_ANSWER and (token.text == "?" or len(inside) == 1):
            lead = inside[1] if inside[0] in ("still", "and", "also", "or") and len(inside) > 1 else inside[0]
            name = "else" if lead in _NO else "so" if lead in _YES and len(inside) == 1 else None
            if name is not None:
                found.append(Cue(name, start, i - 1))
        start = i + 1
    return found


_NO = frozenset(("no", "not", "nope", "nothing", "none", "nowhere", "neither", "nobody"))
_YES = frozenset(("yes", "yep", "yeah"))
_LONGEST_ANSWER = 4
_IN_CASE = ["in", "the", "case", "that"]
_IF_ANY = ["if", "any"]


def _longest(words: Sequence[str], position: int) -> tuple[int, tuple[str, ...]]:
    for length in range(min(LONGEST, len(words) - position), 0, -1):
        names = TABLE.get(tuple(words[position : position + length]))
        if names is not None and _may_end(names, words, position, position + length):
            return length, names
    return 0, ()


def _may_end(names: tuple[str, ...], words: Sequence[str], position: int, end: int) -> bool:
    """A pro-form whose last word is an auxiliary stands for a whole condition only where no verb follows it; the end
    *of* something is a place or a part of it, no order."""
    if words[end : end + 1] == ["of"] and not _ORDERING.isdisjoint(names):
        return False
    if not set(names) & PRO_FORMS or words[end - 1] not in _AUXILIARIES:
        return True
    if end >= len(words) or not words[end].isalpha():
        return True
    if words[position:end] in (["if", "not"], ["and", "if", "not"], ["or", "if", "not"]) and words[end] in _ORDERED:
        return True  # "if not *see whether ...*", but "if it does not look ripe"
    return "so" not in names and words[end] in _AFTER_PRO_FORM


_ORDERING = frozenset(("first", "last"))
_AUXILIARIES = frozenset(("can", "not", "does", "do", "is", "could", "will"))
_ORDERED = frozenset(
    "see check look find turn switch take fetch grab get make leave wait use fill wash close shut call start".split()
)
"""What is ordered behind an "if not" and cannot be so of anything, as "open" and "clean" can."""
_AFTER_PRO_FORM = frozenset("then just please bring go put come tell let ask give try and or you".split())


def _disambiguated(name: str, document: Document, position: int) -> str:
    if name != "if" or position == 0:
        return name
    before = document.tokens[position - 1]
    if before.lemma in ASKING_LEMMAS or before.lower in ASKING_LEMMAS:
        return "whether"
    if (
        position > 1
        and before.lower in ("me", "out", "us", "sure")
        and document.tokens[position - 2].lemma in ASKING_LEMMAS
    ):
        return "whether"
    return name
