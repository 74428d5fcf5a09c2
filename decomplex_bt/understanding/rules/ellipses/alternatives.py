"""Alternatives: what is to be taken or done instead, told without its verb ("otherwise *an apple*") or ahead of its
condition ("bring a pen, or *a pencil* if there is none", "close it if it's dark, *open it* if not")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.rules.ellipses.second_places import other_places
from decomplex_bt.understanding.rules.ellipses.sentence_parts import (
    ADDING,
    DENYING,
    FORGET,
    JOINING,
    NAMING,
    OPENING,
    POINTING,
    TAKING_UP,
    TURNING,
    Part,
    bare,
    is_phrase,
    is_praise,
    parts_of,
)
from decomplex_bt.understanding.rules.speech.asides import tag_question
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

_SUBJECTS = frozenset("it he she they there that this i you we".split())
_SOME = frozenset(("any", "some", "one"))
_WHICHEVER = frozenset(("any", "another"))
_TELLING = frozenset(("NOUN", "PROPN", "ADJ", "NUM"))
_LEFT = frozenset("any one some it that them yet already there".split())


@dataclass(frozen=True, slots=True)
class Alternative:
    """Tokens of an instruction.

    `tokens`: what is named or ordered instead; `condition`: when, with its "if", where that is told behind; else empty;
    `is_verbal`: whether it has a verb of its own, that is a task; `mark`: where it comes on top of what is ordered
    before, and its condition stays behind it ("water the roses, *and the tulips* if they're dry"), what parts them;
    `own`: that condition, if any;
    `is_run_on`: whether no mark parts it from the condition before it; `is_reminder`: whether it is named, behind its
    `mark`, as what is not to be forgotten ("and don't forget *the tulips*"); `praise`: what only says that it serves
    ("the radio *will do*").
    """

    tokens: range
    condition: range
    is_verbal: bool = False
    mark: range = range(0)
    own: range = range(0)
    is_run_on: bool = False
    is_reminder: bool = False
    praise: range = range(0)


def alternatives(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Alternative]:
    """The alternatives of a document, in text order; `tasks` maps token indices to task types.

    One stands right behind an "otherwise" or the like; at the end of a sentence behind a condition and a mark ("if
    there is none, a beer"); between an "or" and an "if"; or between a condition and an "if not" ("if it's hot, the jug
    if it isn't"). "A or B if C" without a comma is an alternative only where C denies something or names what A does.
    """
    document = observed.document
    if not any(cue.name in OPENING | TURNING for cue in observed.cues) and FORGET not in document.words:
        return
    known = {place.start for _, place in other_places(document, tasks)}
    parts = parts_of(observed, tasks)
    for k, part in enumerate(parts):
        if (rest := _in_any_case(observed, part)) and is_phrase(document, rest, tasks):
            yield Alternative(rest, range(rest.stop, rest.stop), mark=part.opening)
            continue
        if part.lead == "besides":
            if (named := _reminded(document, part.body, tasks)) is not None:
                yield Alternative(named, range(named.stop, named.stop), mark=part.opening, is_reminder=True)
            continue
        if served := _good_enough(document, parts, k, tasks):
            praise = range(served.stop, part.body.stop)
            is_run_on = part.lead == "turn" and part.opening.stop == served.start
            yield Alternative(served, range(served.stop, served.stop), is_run_on=is_run_on, praise=praise)
            continue
        body = bare(document, part.body, tasks)
        is_verbal = bool(body) and tasks.get(body.start, "check_state") != "check_state"
        is_named = is_verbal or (
            bool(body) and (is_phrase(document, body, tasks) or _is_kind(document, parts, k, body))
        )
        if not body or body.start in known or not is_named:
            continue
        is_ahead = _is_ahead(document, parts, k, tasks)
        is_besides = is_ahead and not is_verbal and document.tokens[part.body.start].lower == "and"
        is_besides = is_besides and not _is_contrary(document, parts[k + 1])  # not "..., and coffee if not"
        if is_ahead and not is_besides and (is_verbal or not _is_apart(document, parts, k, tasks)):
            condition = range(parts[k + 1].opening.start, parts[k + 1].body.stop)
            yield Alternative(_last_order(document, parts, k, body, tasks), condition, is_verbal)
        elif is_besides or (
            not is_verbal and (_is_added(document, parts, k, tasks) or _is_apart(document, parts, k, tasks))
        ):
            own = range(parts[k + 1].opening.start, parts[k + 1].body.stop)
            yield Alternative(body, range(body.stop, body.stop), mark=part.opening, own=own)
        elif not is_verbal and _is_behind(document, parts, k, body, tasks):
            is_run_on = part.lead == "mark" and not part.opening
            yield Alternative(body, range(body.stop, body.stop), is_run_on=is_run_on)


def _reminded(document: Document, body: range, tasks: Mapping[int, str]) -> range | None:
    """What is not to be forgotten, if no more is said of it: not "don't forget the hamster. Fill his bottle"."""
    named = bare(document, body, tasks)
    if not named or not is_phrase(document, named, tasks):
        return None
    sentences = document.sentences
    after = [token for token in document.tokens[named.stop :] if sentences[token.i] <= sentences[named.start] + 1]
    return None if any(token.lower in TAKING_UP for token in after) else named


def _is_ahead(document: Document, parts: Sequence[Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether an alternative stands ahead of its condition: "or *a pen* if there is none", "*the jug* if it isn't"."""
    part = parts[k]
    if part.is_last or k + 1 == len(parts):
        return False
    condition = parts[k + 1]
    is_done = condition.is_last or _goes_on(document, parts[k + 2 : k + 3])
    if part.lead == "or" and condition.lead == "if" and is_done and any(i in tasks for i in condition.body):
        return _is_either(document, parts[:k], part, condition, tasks)
    if part.lead == "or" and k and parts[k - 1].lead == "if" and is_done and _is_contrary(document, condition):
        return True  # "a cup if one is clean or *a glass* if not"
    is_next = part.lead == "mark" and part.body.stop == condition.opening.start and is_done
    if is_next and _is_second_choice(document, parts[k - 1], part, condition, tasks):
        return True
    if is_next and _follows_condition(parts, k, tasks):
        # "tea if it's morning, *coffee* if it's evening", which an order with a verb says as it stands
        is_named = condition.lead == "if" and not any(i in tasks for i in part.body)
        return _is_contrary(document, condition) or (is_named and any(i in tasks for i in condition.body))
    return False


def _is_kind(document: Document, parts: Sequence[Part], k: int, body: range) -> bool:
    """Whether a single word between an "or" and a condition names another kind of what is ordered, as that condition
    says that there is none of the first: "a green mug, or *brown* if there's no green"."""
    tokens = document.tokens
    if len(body) != 1 or tokens[body.start].pos != "ADJ" or parts[k].lead != "or" or not 0 < k < len(parts) - 1:
        return False
    asked = [tokens[i] for i in parts[k + 1].body]
    first = {tokens[i].lemma for i in parts[k - 1].body if tokens[i].pos == "ADJ" and tokens[i].dep == "amod"}
    is_lack = parts[k + 1].lead == "if" and any(token.lower in DENYING for token in asked)
    return is_lack and len(first) == 1 and any(token.lemma in first for token in asked)


def _last_order(document: Document, parts: Sequence[Part], k: int, body: range, tasks: Mapping[int, str]) -> range:
    """The last of several orders behind a case that opens their sentence, of which the first is what is done in that:
    "if it's dark, light the lamp and *draw the blinds* if not"."""
    is_fronted = k > 0 and parts[k - 1].lead == "if" and (k == 1 or parts[k - 2].is_last or not parts[k - 2].body)
    orders = [i for i in body if tasks.get(i, "check_state") != "check_state"]
    is_joined = len(orders) > 1 and document.tokens[orders[-1] - 1].lower == "and"
    return range(orders[-1], body.stop) if is_fronted and is_joined else body


def _is_second_choice(document: Document, before: Part, part: Part, condition: Part, tasks: Mapping[int, str]) -> bool:
    """Whether what is named behind an order and a comma is for where something is the matter with what the order names:
    "take the big pan, *the small one* if the big one is dirty", "a pen, *a pencil* if there isn't one"."""
    tokens, body = document.tokens, part.body
    is_ordered = before.lead == "start" and any(tasks.get(i, "check_state") != "check_state" for i in before.body)
    is_named = not any(i in tasks or tokens[i].tag == "CC" for i in body) and condition.lead == "if"
    if not (is_ordered and is_named and tokens[part.opening.start].text == ","):
        return False
    first = {tokens[i].lemma for i in before.body if tokens[i].pos in NAMING | {"ADJ"}}
    own, asked = ({tokens[i].lemma for i in words} for words in (body, condition.body))
    if not ADDING.isdisjoint(own):
        return False  # "mop the kitchen, the hall too if the kitchen is dirty"
    return _is_contrary(document, condition) or not asked.isdisjoint(first - own)


def _is_added(document: Document, parts: Sequence[Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether what is named with a condition of its own comes on top of the one order before: "water the roses, *and
    the tulips too* if they're dry"."""
    part = parts[k]
    is_afterthought = part.lead == "start" and bool(part.body) and document.tokens[part.body.start].lower == "and"
    if part.is_last or not (part.lead == "mark" or is_afterthought) or not 0 < k < len(parts) - 1:
        return False
    condition, tokens = parts[k + 1], document.tokens
    before = parts[k - 2 if is_afterthought and k > 1 and _is_tag_question(document, parts[k - 1]) else k - 1]
    gap = tokens[part.body.stop : condition.opening.start]
    is_too = not ADDING.isdisjoint(tokens[i].lower for i in part.body)
    is_too = is_too and any(tokens[i].lower in TAKING_UP | _SOME for i in condition.body)
    is_next = not gap or ((is_too or is_afterthought) and [token.text for token in gap] == [","])
    is_done = condition.is_last or _goes_on(document, parts[k + 2 : k + 3])
    is_next = is_next and condition.lead == "if" and is_done
    is_joined = (tokens[part.body.start].lower in ("and", "but") or is_too) and before.lead == "start"
    is_ordered = any(tasks.get(i, "check_state") != "check_state" for i in before.body)
    return is_next and is_joined and is_ordered and any(i in tasks for i in condition.body)


def _is_tag_question(document: Document, part: Part) -> bool:
    """Whether a part only makes a request of the order before: "pass me the salt, *would you?*"."""
    return part.lead == "mark" and tag_question(document, part.body.start) == part.body


def _is_apart(document: Document, parts: Sequence[Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether what "and" adds behind a condition has one of its own that asks of another thing: "bring the charger if
    the battery is low, *and a cup of tea* if there's any left"."""
    part, tokens = parts[k], document.tokens
    if part.lead != "mark" or part.is_last or k + 1 == len(parts) or not _follows_condition(parts, k, tasks):
        return False
    before, condition = parts[k - 1].body, parts[k + 1]
    is_next = condition.lead == "if" and part.body.stop == condition.opening.start and bool(condition.body)
    if (
        not is_next
        or tokens[part.body.start].lower != "and"
        or tokens[condition.body.start].lower in _SUBJECTS - {"there"}
    ):
        return False
    named = [{tokens[i].lemma for i in body if tokens[i].pos in NAMING} for body in (before, condition.body)]
    first = tokens[before.start].lower
    is_other = bool(named[0]) and first not in _SUBJECTS and named[0].isdisjoint(named[1])
    return is_other and any(i in tasks for i in condition.body) and not _is_contrary(document, condition)


def _is_behind(document: Document, parts: Sequence[Part], k: int, body: range, tasks: Mapping[int, str]) -> bool:
    """Whether an alternative stands behind its condition, or behind an "otherwise"; `body`: its own words."""
    part = parts[k]
    if part.lead == "mark" and not part.opening:
        return True
    is_turn = part.lead == "turn" or (part.lead == "mark" and k > 0 and _is_bare_turn(parts[k - 1]))
    following = parts[k + 1 : k + 2]
    is_turned_again = bool(following) and following[0].lead == "turn"
    if is_turn and (part.is_last or body.stop < part.body.stop or is_turned_again or _goes_on(document, following)):
        return True
    if part.lead != "mark" or not _follows_condition(parts, k, tasks):
        return False
    is_place = len(body) > 1 and document.tokens[body.start].lower in PREPOSITIONS
    is_missed = is_place and any(document.tokens[i].lower in DENYING for i in parts[k - 1].body)
    is_parted = _joint(document, parts[k - 1]) in (("or", "and") if is_missed else ("or",))
    is_parted = is_parted and _goes_on(document, following)
    if not (part.is_last or is_parted):
        return False
    if document.tokens[part.body.start].lower == "and":
        return False  # "close it if it's dark, *and the curtains*" goes with it
    first = document.tokens[body.start].lower
    if len(body) > 1:
        return True
    is_lack = document.tokens[body.start].tag == "NNS" and any(
        document.tokens[i].lower in DENYING for i in parts[k - 1].body
    )  # "if there are no apples left, *biscuits*"
    return first in POINTING or is_lack or (first not in PARTICLES and _is_joined(document, parts, k))


def _good_enough(document: Document, parts: Sequence[Part], k: int, tasks: Mapping[int, str]) -> range:
    """What is said to serve as well where what was ordered cannot be had, at the end of a sentence, behind a condition
    or an "otherwise": "if there's none, *water* will do"; else empty. Not what was named already ("if the milk is off,
    the milk is fine"), nor with an order of its own ("then navy will do: bring me that")."""
    part, tokens = parts[k], document.tokens
    is_failed = k > 0 and (part.lead == "turn" or _is_turn_alone(document, parts[k - 1]))
    is_last = part.is_last or _is_further_case(document, parts[k + 1 : k + 3])
    if not is_last or not (is_failed or (part.lead == "mark" and _follows_condition(parts, k, tasks))):
        return range(0)
    stop = next((i for i in part.body if is_praise(tokens, range(i, part.body.stop))), part.body.start)
    named = bare(document, range(part.body.start, stop), tasks)
    is_named = bool(named) and (is_phrase(document, named, tasks) or _is_other_sort(document, parts[k - 1], named))
    if not is_named or tokens[named.start].lower in POINTING:
        return range(0)
    behind = [token for token in tokens[part.body.stop :] if token.text not in MARKS]
    if behind and behind[0].i in tasks and tokens[part.body.stop].text not in ENDS:
        return range(0)
    said = {token.lemma for token in tokens[: part.opening.start] if token.i not in named}
    is_other = any(tokens[i].lemma not in said and tokens[i].pos in _TELLING for i in named)
    return named if is_other or tokens[named.start].lower in _WHICHEVER else range(0)


def _is_other_sort(document: Document, condition: Part, named: range) -> bool:
    """Whether a single word names another sort of what a condition says that there is none of: "if there's no red one,
    *blue* is fine"."""
    asked = [document.tokens[i] for i in condition.body]
    is_lack = condition.lead == "if" and any(token.lower in DENYING for token in asked)
    is_sort = len(named) == 1 and document.tokens[named.start].pos == "ADJ"
    return is_lack and is_sort and any(token.pos == "ADJ" for token in asked)


def _is_further_case(document: Document, behind: Sequence[Part]) -> bool:
    """Whether no more than a further case goes on: ", and if we're out of wine, ..."."""
    words = [token.lower for part in behind[:1] for token in document.tokens[part.body.start : part.body.stop]]
    return len(behind) > 1 and behind[0].lead == "mark" and words in (["and"], ["but"]) and behind[1].lead == "if"


def _is_turn_alone(document: Document, part: Part) -> bool:
    """Whether a part is no more than an "otherwise", be it a question: "no luck? Then the radio will do"."""
    behind = document.tokens[part.opening.stop : part.opening.stop + 1]
    return part.lead == "turn" and not part.body and bool(behind) and behind[0].text in ("?", ",")


def _in_any_case(observed: Observed, part: Part) -> range:
    """What is said behind an "either way" that a mark parts from the rest: "and either way *a spoon*"."""
    first = next((i for i in part.body if observed.document.tokens[i].lower not in JOINING), part.body.stop)
    last = next((cue.last for cue in observed.cues if cue.name == "either_way" and cue.first == first), None)
    if last is None or part.lead != "mark" or observed.document.tokens[last].tag.startswith("W"):
        return range(0)  # "whatever the score"
    return range(last + 1, part.body.stop)


def _goes_on(document: Document, following: Sequence[Part]) -> bool:
    """Whether the next part only goes on: "*and then* close the door"."""
    return bool(following) and bool(following[0].body) and document.tokens[following[0].body.start].lower in JOINING


def _is_joined(document: Document, parts: Sequence[Part], k: int) -> bool:
    """Whether an "or" or "and" leads the condition that a part follows: "a beer, or if there is none, *lemonade*"."""
    return _joint(document, parts[k - 1]) in ("or", "and", ",")


def _joint(document: Document, condition: Part) -> str:
    """The word right ahead of a condition, be it that a comma parts them ("tea or, *if there is none*, water"); "" at
    the beginning."""
    tokens, i = document.tokens, condition.opening.start - 1
    if i > 0 and tokens[i].text == "," and tokens[i - 1].lower in ("or", "and"):
        i -= 1
    return tokens[i].lower if i >= 0 else ""


def _follows_condition(parts: Sequence[Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether the part before tells a condition, and the same sentence goes on."""
    if k == 0 or parts[k - 1].is_last:
        return False
    said = [tasks[i] for i in parts[k - 1].body if i in tasks]
    # not "if it's full empty it, the big one"
    is_alone = all(kind in ("check_state", "searching") for kind in said[1:])
    return parts[k - 1].lead == "if" and bool(said) and is_alone


def _is_bare_turn(part: Part) -> bool:
    return part.lead == "turn" and not part.body and not part.is_last


def _is_contrary(document: Document, part: Part) -> bool:
    """Whether a condition says no more than that the one before it does not hold: "if not", "if there isn't any"."""
    if part.lead == "turn":
        return not part.body
    words = [token.lower for token in document.tokens[part.body.start : part.body.stop]]
    return (
        len(words) > 2
        and words[0] in _SUBJECTS
        and document.tokens[part.body.start + 1].pos in ("AUX", "VERB")
        and words[2] in DENYING
        and set(words[3:]) <= _LEFT
    )


def _is_either(
    document: Document, before: Sequence[Part], part: Part, condition: Part, tasks: Mapping[int, str]
) -> bool:
    """Whether "A or B if C" means B where C holds and A where not, rather than A or B, as you like, where C holds."""
    tokens = document.tokens
    if not before:
        return False
    if before[-1].lead == "if":  # "tea if it's cold or *juice* if it's hot"
        is_order = document.tokens[part.body.start].pos == "VERB"
        if len(before) < 2:
            return False
        ordered = before[-2]
        is_ahead = ordered.lead in ("start", "mark") and not ordered.is_last
        return is_ahead and not is_order and any(tasks.get(i, "check_state") != "check_state" for i in ordered.body)
    if tokens[part.opening.start - 1].text in MARKS or tokens[before[-1].body.start].lower == "either":
        return True
    asked = tokens[condition.body.start : condition.body.stop]
    if any(token.lower in DENYING for token in asked):
        return True
    own = {tokens[i].lemma for i in part.body}
    first = {tokens[i].lemma for i in before[-1].body if tokens[i].pos in NAMING | {"ADJ"}}
    return any(token.lemma in first - own for token in asked)
