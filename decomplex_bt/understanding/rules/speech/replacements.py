"""Replacements: phrases, clauses and orders that others stand in place of ("on the table, no, on the shelf")."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from decomplex_bt.understanding.document import ENDS
from decomplex_bt.understanding.references.first_names import MEN, WOMEN
from decomplex_bt.understanding.rules.speech.edits import (
    AHEAD,
    ASKING_FOR,
    BREAKS,
    DENYING,
    DOTS,
    EDITING,
    LONGEST,
    MARKS,
    OPENERS,
    TURNING,
    UNFINISHED,
    Said,
    is_order_at,
)

_PLACEHOLDERS = frozenset("whatsit wotsit thingy thingummy thingamajig whatchamacallit".split())
_ADDING = frozenset("too also well another more as".split())
_DETERMINERS = UNFINISHED | frozenset("his her its this that these those some any".split())
_COORDINATING = frozenset(("and", "or", "then", "but"))
_WISHERS = frozenset(("i", "we"))
_WOULD = frozenset("'ll will 'd would".split())
_WISHING = frozenset("have take like love prefer".split())
_POINTING = frozenset("that this those these".split())
_NAMED = frozenset(("nsubj", "dobj", "pobj"))
_OPENING = frozenset(("if", "whether", "unless", "when"))
_CHECKING = frozenset(("see", "check", "ask", "find", "tell"))
_ASKING = frozenset("if whether unless when is are has does did 's".split())
_WITHDRAWING = frozenset("forget skip scratch scrap strike cancel ignore disregard make need".split())
"""Verbs that take an order back and order nothing themselves: "no, forget the stairs", "no, make that five"."""
_TAKING_UP = frozenset("it them that those this these one ones there him her".split())
_THEM = dict.fromkeys(("em", "'em"), "them")
_SUBORDINATING = frozenset("before after once when if while until till unless as".split())
_WITHIN = frozenset(("relcl", "acl", "xcomp"))
_PARTICLES = frozenset("on off up down in out".split())
_NAMING = frozenset(("NOUN", "PROPN", "ADJ", "NUM", "DET", "PART"))
_TO_WHOM = frozenset(("to", "for"))


def _stub(said: Said, run: range) -> range:
    """The verb, with a particle or preposition at most, at which an order is broken off before a run: ", heat... well",
    "and turn on - no"; empty where none is."""
    words, tokens = said.words, said.document.tokens
    if words[run.start] not in MARKS - {","}:
        return range(0)
    for first in range(run.start - 1, max(-1, run.start - 3), -1):
        if said.begins_clause(first) or words[first - 1] in ("and", "then", "or", "but"):
            is_verb = tokens[first].tag in ("VB", "VBP", "NN", "JJ") and words[first] == tokens[first].lemma
            is_led = all(token.pos in ("ADP", "PART", "DET") for token in tokens[first + 1 : run.start])
            return range(first, run.start) if is_verb and is_led else range(0)
    return range(0)


def puts_right(said: Said, run: range) -> bool:
    """Whether an order behind a run stands in place of the one before: that is taken back, or breaks off and the
    speaker thinks again."""
    is_other = said.has(run, TURNING) or (said.has(run, ("actually",)) and run.start > 0)
    is_instead = is_other and "instead" in _clause_behind(said, run.stop)
    is_broken_off = bool(_stub(said, run)) and said.has(run, ("well", "just", "actually"))
    return said.is_strong(run) or is_instead or is_broken_off or (is_other and _says_verb_again(said, run))


def _says_verb_again(said: Said, run: range) -> bool:
    """Whether an "actually" begins a sentence that gives the last order of the one before with other words: "put it
    in the hall. *Actually, put it in the shed*", not "actually, open the shed, too"."""
    words, tokens = said.words, said.document.tokens
    if run.start == 0 or words[run.start - 1] not in ENDS or words[run.start] != "actually":
        return False
    order, right = order_before(said, run), _order_behind(said, run)
    is_same = bool(order) and tokens[order.start].lemma == tokens[right].lemma
    end = next((i for i in range(right, len(words)) if not said.are_together(i, right)), len(words))
    return is_same and _ADDING.isdisjoint(words[right:end])


def _clause_behind(said: Said, start: int) -> Sequence[str]:
    """The words from there to the next mark."""
    stop = next((i for i in range(start, len(said.words)) if said.words[i] in MARKS | ENDS), len(said.words))
    return said.words[start:stop]


def put_otherwise(said: Said, run: range) -> Collection[int]:
    """What stands before a run of editing words and is put otherwise behind it, with the run; empty for nothing."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, run.stop
    if left < 0 or right >= len(words):
        return range(0)
    order = order_before(said, run) if puts_right(said, run) else range(0)
    if order and not takes_up(said, order, run):
        return order
    if not said.are_together(left, right):
        return range(0)
    is_strong = said.is_strong(run)
    is_broken = words[left] in UNFINISHED and tokens[left].tag in ("DT", "PRP$") and tokens[left].text != "A"
    if is_broken and words[right] in _DETERMINERS:
        return range(left, right)  # "the, um, that one"
    if said.has(run, _PLACEHOLDERS):
        return range(0)  # "put the thingy on the table"
    if is_broken and words[right] == "not":
        return _contrasted(said, left, right)
    if is_broken and tokens[right].pos == "ADP" and left and tokens[left - 1].pos == "ADP":
        return range(left - 1, right)  # "in the, in that box"
    if is_broken and not is_strong:
        order = order_before(said, run)
        if order and _has_object(said, order.stop):  # not "the, um, plug"
            return order
    if not is_strong:
        return range(0)
    if words[right] == "not":
        return _denied(said, run)
    if words[right] in ("if", "when") and _is_case_of_order(said, run):
        return range(run.start + (words[run.start] in MARKS), right)
    if words[right] in OPENERS:
        same = (i for i in range(left, -1, -1) if words[i] == words[right] and said.are_together(i, right))
        first = next(same, None)
        is_added = not {"also", "too"}.isdisjoint(words[right : right + 4])
        is_again = first is not None and said.begins_clause(first) and not is_added
        return range(first, right) if first is not None and is_again else range(0)
    return _phrase_before(said, run)


def _is_case_of_order(said: Said, run: range) -> bool:
    """Whether an order before a run stands but in the case told behind it, where another is given of what that names:
    "put the cup on the table, no, if it's dirty put it in the sink"."""
    words, right = said.words, run.stop
    again = next((i for i in range(right + 2, len(words)) if is_order_at(said.document, i)), len(words))
    if again == len(words) or not said.are_together(run.start, again):
        return False
    first = next((i for i in range(run.start - 1, -1, -1) if is_order_at(said.document, i)), -1)
    is_plain = first >= 0 and said.may_begin(first) and _ASKING.isdisjoint(words[first : run.start])
    return is_plain and takes_up(said, range(first, again), run)


def _denied(said: Said, run: range) -> range:
    """A phrase that is denied with its own words and another one named: "to the shed, no, not the shed, the garage";
    where it is only pointed at, no more than the denial ("the red pan, no, *not that one,* the flat one"), and so where
    an order goes on behind a place ("rinse it and - *no, not back to him,* put it here")."""
    words, tokens, again = said.words, said.document.tokens, run.stop + 1
    if words[again : again + 1] != [] and words[again] in _POINTING:
        stop = again + 1 + (words[again + 1 : again + 2] in (["one"], ["ones"]))
        is_other = stop + 1 < len(words) and words[stop] in MARKS and words[stop + 1] in _DETERMINERS
        return range(run.stop, stop + 1) if is_other else range(0)
    for count in range(min(LONGEST, run.start), 0, -1):
        stop = again + count
        if words[again:stop] != words[run.start - count : run.start]:
            continue
        is_led = tokens[again].pos == "ADP"
        is_marked = words[stop : stop + 1] != [] and words[stop] in MARKS
        while stop < len(words) and words[stop] in MARKS:
            stop += 1
        kinds = {"DET", "NUM", *(("ADP",) if is_led else ()), *(("PROPN",) if is_marked else ())}
        is_other = stop < len(words) and (tokens[stop].pos in kinds or tokens[stop].tag == "PRP$")
        is_other = is_other and (is_marked or tokens[again + count - 1].pos != "PROPN")
        is_other = is_other and said.are_together(run.start, stop) and not said.states(stop)
        return range(run.start - count, stop) if is_other else range(0)
    mark = next((i for i in range(again, min(again + LONGEST, len(words) - 1)) if words[i] in MARKS), None)
    is_place = mark is not None and tokens[again].pos in ("ADP", "ADV") and said.are_together(run.start, mark + 1)
    if mark is not None and is_place and is_order_at(said.document, mark + 1):
        return range(run.start, mark + 1)
    return range(0)


def _contrasted(said: Said, left: int, right: int) -> range:
    """ "Get the, *not the green one,* the red one": up to the phrase that is meant."""
    words = said.words
    mark = next((i for i in range(right, min(right + LONGEST, len(words))) if words[i] in MARKS), None)
    if mark is None or mark + 1 >= len(words) or words[mark + 1] not in _DETERMINERS:
        return range(0)
    return range(left, mark + 1)


def _phrase_before(said: Said, run: range) -> Collection[int]:
    """The phrase before a run, and the run, where one of the same kind stands behind it: with a preposition, or with an
    article or number; "the red mug, no, the blue one" needs the noun of the first. A particle behind the phrase stays
    ("switch *the oven* on, no, the grill")."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, run.stop
    is_led = tokens[right].pos == "ADP" or tokens[right].tag == "RP"
    is_named = words[right] in _DETERMINERS or tokens[right].pos == "NUM"
    end = next((i for i in range(right + 1, len(words)) if tokens[i].pos not in _NAMING), len(words))
    if _is_other_word(said, left, right):
        return range(left, right)
    if kind := _other_kind(said, left, right, end):
        return kind
    is_clause = end < len(words) and tokens[end].pos in ("AUX", "VERB") and words[end] not in BREAKS
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


def _is_other_word(said: Said, left: int, right: int) -> bool:
    """Whether a bare word stands in place of the last one of what was said: the noun of a phrase with an article ("my
    passport - sorry, *notebook*"), what is named bare behind a "to" or "for" ("to Pia, no,
    *Ned*"), or the other particle ("turn the fryer on,
    no, *off*!")."""
    words, tokens = said.words, said.document.tokens
    is_last = right + 1 == len(words) or words[right + 1] in MARKS | ENDS | _COORDINATING
    if not is_last or not said.are_together(left, right):
        return False
    if words[left] in _PARTICLES and words[right] in _PARTICLES:
        return words[left] != words[right]
    if left and words[left - 1] in _TO_WHOM and all(_is_bare(said, i) for i in (left, right)):
        return words[left] != words[right]
    is_noun = tokens[left].tag in ("NN", "NNS") and tokens[right].tag in ("NN", "NNS")
    is_named = left > 0 and (words[left - 1] in _DETERMINERS or tokens[left - 1].pos == "ADJ")
    return is_noun and is_named and not said.begins_clause(left) and words[left] != words[right]


def _is_bare(said: Said, i: int) -> bool:
    """Whether a word names something or somebody without an article: "Ned", "ned", "mum", "lunch"."""
    token = said.document.tokens[i]
    return token.tag in ("NN", "NNP") or token.lower in WOMEN | MEN


def _other_kind(said: Said, left: int, right: int, end: int) -> range:
    """The words that told the kind of a thing, and the thing, with the run behind them, where another kind of it is
    named bare: "off the *lower shelf, correction,* upper shelf"."""
    words, tokens = said.words, said.document.tokens
    is_last = end == len(words) or words[end] in MARKS | ENDS | _COORDINATING
    is_bare = end - right > 1 and tokens[right].pos in ("ADJ", "NOUN", "PROPN") and words[end - 1] == words[left]
    if not (is_last and is_bare and said.are_together(left, right)):
        return range(0)
    first = left
    while first > 0 and tokens[first - 1].pos in ("ADJ", "NOUN", "PROPN") and left - first < LONGEST:
        first -= 1
    is_named = first > 0 and (words[first - 1] in _DETERMINERS or tokens[first - 1].pos == "ADP")
    return range(first, right) if is_named and first < left else range(0)


def order_before(said: Said, run: range) -> range:
    """The order before a run, and the run, where another order stands behind it, in its sentence or, where the run
    begins that, in the sentence before. What breaks off behind an "and" stands in place of nothing, unless it is said
    to be all: "wash it and... no, just dry it"."""
    words, tokens = said.words, said.document.tokens
    left, right = run.start - 1, _order_behind(said, run)
    if left < 0 or right >= len(words) or not (said.are_together(left, right) or _is_second_thought(said, run, right)):
        return range(0)
    end = next((i for i in range(right, len(words)) if not said.are_together(i, right)), len(words))
    is_order = is_order_at(said.document, right) or _is_wish(said, right + 2)
    is_other = is_order and words[right] not in _WITHDRAWING and right + 1 < end
    is_other = is_other and words[right + 1] not in EDITING
    if not is_other or not AHEAD.isdisjoint(words[right:end]) or {"and", "also"} & set(words[run.start : run.stop]):
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
        if is_order_at(said.document, i) and tokens[i].dep not in _WITHIN:
            is_subordinate = not _SUBORDINATING.isdisjoint(words[max(0, i - 2) : i])
            is_forbidden = i > 0 and words[i - 1] in ("not", "n't", "never")
            return range(0) if is_subordinate or is_forbidden else range(i, right)
        is_asked = words[i] in ("if", "whether") and any(t.lemma in _CHECKING for t in tokens[max(0, i - 3) : i])
        is_joined = words[i] in ("and", "or") and tokens[i + 1].pos in _NAMING
        is_asking = words[i] in _ASKING and (words[i] in _OPENING or said.begins_clause(i))
        if (words[i] in BREAKS and not is_joined) or (is_asking and not is_asked):
            break
    return range(0)


def _is_wish(said: Said, i: int) -> bool:
    """Whether a verb says what the speaker would like to have: "I'll *have* tea", "I'd *like* some"."""
    words = said.words
    return 1 < i < len(words) and words[i] in _WISHING and words[i - 1] in _WOULD and words[i - 2] in _WISHERS


def _order_behind(said: Said, run: range) -> int:
    """Where the verb of an order behind a run would stand: "no, just *put* it here", "no, could you *put* it here"."""
    words, right = said.words, run.stop
    if right < len(words) and words[right] in ASKING_FOR and words[right + 1 : right + 2] == ["you"]:
        right += 2
    while right < len(words) and words[right] in ("just", "only", "please", "then"):
        right += 1
    return right


def _is_second_thought(said: Said, run: range, right: int) -> bool:
    """Whether a run begins a sentence that puts an order of the sentence before right. "No, then turn it on" answers,
    and behind an "if" or a "yes" a lone "no" does so."""
    words, left = said.words, run.start - 1
    if words[left] not in ENDS and words[run.start] not in DOTS:
        return False
    before = [words[i] for i in range(run.start) if said.are_together(i, left)]
    is_alone = {word for word in words[run.start : run.stop] if word not in MARKS} <= DENYING
    is_conditional = not {"if", "when", "unless", "whether"}.isdisjoint(before)
    return "then" not in words[run.stop : right] and not (is_alone and is_conditional)


def _has_object(said: Said, verb: int) -> bool:
    """Whether an object that cannot be part of a compound follows a verb: "rinse the cups", "tell her"."""
    return any(token.tag in ("DT", "PRP", "PRP$") for token in said.document.tokens[verb + 1 : verb + 2])


def takes_up(said: Said, order: range, run: range) -> bool:
    """Whether the order in place of another, behind a run, speaks of what that names: "close the window, no, leave it
    open"."""
    end = next((i for i in range(order.stop, len(said.words)) if said.words[i] in BREAKS), len(said.words))
    replaced = said.document.tokens[order.start + 1 : run.start]
    names = any(token.pos in ("NOUN", "PROPN") or token.dep in _NAMED for token in replaced)
    own = {_THEM.get(token.lower, token.lower) for token in replaced}  # "throw them in, no wait, put them by the door"
    return names and any(_THEM.get(word, word) in _TAKING_UP - own for word in said.words[order.stop : end])
