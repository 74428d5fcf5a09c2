"""Alternatives: what is to be taken or done instead, told without its verb ("otherwise *an apple*") or ahead of its
condition ("bring a pen, or *a pencil* if there is none", "close it if it's dark, *open it* if not")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.phrases import ONES, PERSON_NOUNS, PLACE_ADVERBS, PREPOSITIONS, noun_chunks
from decomplex_bt.understanding.rules.speech.asides import tag_question

_OPENING = frozenset(("if", "only_if", "unless"))
_TURNING = frozenset(("else", "fail"))
_JOINING = frozenset("and but or so then just maybe perhaps please".split())
_LEADING = _JOINING | {"also", "only"}
_CLOSING = frozenset("please instead then though thanks too also well as altogether completely entirely".split())
_ADDING = frozenset(("too", "also", "well"))
_BEGINNING = frozenset(("DET", "NOUN", "PROPN", "ADJ", "NUM"))
_NAMING = frozenset(("NOUN", "PROPN"))
_ARTICLES = frozenset("a an some the".split())
_WHOLE = ("thing", "body", "one", "where", "who", "what")
_IDLE = frozenset("case course mind time day thank bother worry love".split())
"""What ends phrases that name nothing: "in which case", "of course", "any time"."""
_NO_PARTS = frozenset(("VERB", "AUX", "SCONJ", "INTJ"))
_POINTING = frozenset(("that", "those"))
_SOMETHING = frozenset(("anything", "something"))
_CHOOSING = frozenset(("or", "else", "otherwise"))
_SHARED = _POINTING | {"them", "these", "it"}
"""What some is taken of: "two of those"."""
_DENYING = frozenset(("not", "n't", "n’t", "nt", "no", "none", "nobody", "nothing"))
_SUBJECTS = frozenset("it he she they there that this i you we".split())
_FORGET = "forget"
_DO_NOT = frozenset((("do", "n't"), ("do", "n\u2019t"), ("do", "not"), ("do", "nt")))
_TAKING_UP = frozenset("it its they them their he him his she her".split())
_CLOSED = frozenset("any one none some it them there here home left".split())
"""What may end a condition that is said in full: "if there isn't *one*", "if she's *home*"."""
_MOVING = frozenset(("placing", "bringing", "taking"))
_WHERE = frozenset("in out outside inside up upstairs downstairs off on".split())
_TO_WHOM = frozenset(("to", "for"))
_UNSURE = frozenset((("else",), ("perhaps",), ("maybe",), ("possibly",), ("failing", "that")))
"""What stands behind an "or" between two places of which the speaker does not know which it is."""
_SOME = frozenset(("any", "some", "one"))
_WILL = frozenset("will would should 'll \u2019ll 'd \u2019d might".split())
_IS = frozenset("is are 's \u2019s".split())
_GOOD = frozenset("fine ok okay great good lovely perfect nice alright enough acceptable grand".split())
_QUITE = frozenset("just perfectly quite also probably all".split())
_PRAISING = frozenset("nicely just me by with fine".split())
"""What may stand behind "will do": "nicely", "by me"."""
_WHICHEVER = frozenset(("any", "another"))
_SHORTEST = 2
"""The words at least of such praise: "is fine"."""
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


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of a sentence between two marks or words of `lead`; `opening`: the tokens of that word."""

    lead: str
    opening: range
    body: range
    is_last: bool


def alternatives(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Alternative]:
    """The alternatives of a document, in text order; `tasks` maps token indices to task types.

    One stands right behind an "otherwise" or the like; at the end of a sentence behind a condition and a mark ("if
    there is none, a beer"); between an "or" and an "if"; or between a condition and an "if not" ("if it's hot, the jug
    if it isn't"). "A or B if C" without a comma is an alternative only where C denies something or names what A does.
    """
    document = observed.document
    if not any(cue.name in _OPENING | _TURNING for cue in observed.cues) and _FORGET not in document.words:
        return
    known = {place.start for _, place in other_places(document, tasks)}
    parts = list(_split(document, list(_parts(observed, tasks)), tasks))
    for k, part in enumerate(parts):
        if (rest := _in_any_case(observed, part)) and _is_phrase(document, rest, tasks):
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
        body = _bare(document, part.body, tasks)
        is_verbal = bool(body) and tasks.get(body.start, "check_state") != "check_state"
        is_named = is_verbal or (
            bool(body) and (_is_phrase(document, body, tasks) or _is_kind(document, parts, k, body))
        )
        if not body or body.start in known or not is_named:
            continue
        if _is_ahead(document, parts, k, tasks) and (is_verbal or not _is_apart(document, parts, k, tasks)):
            condition = range(parts[k + 1].opening.start, parts[k + 1].body.stop)
            yield Alternative(_last_order(document, parts, k, body, tasks), condition, is_verbal)
        elif not is_verbal and (_is_added(document, parts, k, tasks) or _is_apart(document, parts, k, tasks)):
            own = range(parts[k + 1].opening.start, parts[k + 1].body.stop)
            yield Alternative(body, range(body.stop, body.stop), mark=part.opening, own=own)
        elif not is_verbal and _is_behind(document, parts, k, body, tasks):
            is_run_on = part.lead == "mark" and not part.opening
            yield Alternative(body, range(body.stop, body.stop), is_run_on=is_run_on)


def other_places(document: Document, tasks: Mapping[int, str]) -> Iterator[tuple[int, range]]:
    """Of every second place where something is said to be or looked for, the "or" that joins it to the first, and its
    words: "it's in the hall or else *under the desk*". An order for another place says what to do where it fails."""
    tokens, words = document.tokens, [token.lower for token in document.tokens]
    for joint in (i for i, word in enumerate(words) if word == "or"):
        start = joint + 1 + (words[joint + 1 : joint + 2] == [","])
        unsure = next((u for u in _UNSURE if words[start : start + len(u)] == [*u]), ())
        start += len(unsure)
        start += words[start : start + 1] == [","]
        ends = (t.i for t in tokens[start:] if t.text in MARKS or t.tag == "CC" or t.i in tasks)
        place = range(start, next(ends, len(tokens)))
        if not unsure or len(place) < 2 or words[start] not in PREPOSITIONS or not _is_phrase(document, place, tasks):
            continue
        before = [t for t in tokens[:joint] if document.sentences[t.i] == document.sentences[joint]]
        verb = next((t for t in reversed(before) if t.pos in ("VERB", "AUX") or t.i in tasks), None)
        is_there = verb is not None and (verb.lemma in ("be", "'s") or tasks.get(verb.i) == "searching")
        if is_there and not _is_of_order(before, tasks):
            yield joint, place


def _is_of_order(before: Sequence[Token], tasks: Mapping[int, str]) -> bool:
    """Whether a second place behind a condition takes the place of that in the order ahead of it: "put it in the box if
    there's room, or else *on the shelf*"; `before`: what its sentence says up to there."""
    opener = next((n for n, t in enumerate(before) if t.lower in ("if", "unless")), 0)
    ordered = next((n for n, t in enumerate(before[:opener]) if tasks.get(t.i, "check_state") in _MOVING), opener)
    return any(t.lower in PREPOSITIONS for t in before[ordered:opener])


def _reminders(document: Document) -> Iterator[range]:
    """The words of every "and don't forget" behind which no verb stands."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-1]):
        if token.lower != _FORGET or tokens[i + 1].lower == "to":
            continue
        start = i - 1 if tokens[i - 1].lower == "never" else i - 2
        if start < 0 or (start == i - 2 and (tokens[start].lower, tokens[i - 1].lower) not in _DO_NOT):
            continue
        while start and tokens[start - 1].lower in ("and", "but", ",", "oh"):
            start -= 1
        yield range(start, i + 1)


def _reminded(document: Document, body: range, tasks: Mapping[int, str]) -> range | None:
    """What is not to be forgotten, if no more is said of it: not "don't forget the hamster. Fill his bottle"."""
    named = _bare(document, body, tasks)
    if not named or not _is_phrase(document, named, tasks):
        return None
    sentences = document.sentences
    after = [token for token in document.tokens[named.stop :] if sentences[token.i] <= sentences[named.start] + 1]
    return None if any(token.lower in _TAKING_UP for token in after) else named


def _is_ahead(document: Document, parts: Sequence[_Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether an alternative stands ahead of its condition: "or *a pen* if there is none", "*the jug* if it isn't"."""
    part = parts[k]
    if part.is_last or k + 1 == len(parts):
        return False
    condition = parts[k + 1]
    is_done = condition.is_last or _goes_on(document, parts[k + 2 : k + 3])
    if part.lead == "or" and condition.lead == "if" and is_done and any(i in tasks for i in condition.body):
        return _is_either(document, parts[:k], part, condition)
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


def _is_kind(document: Document, parts: Sequence[_Part], k: int, body: range) -> bool:
    """Whether a single word between an "or" and a condition names another kind of what is ordered, as that condition
    says that there is none of the first: "a green mug, or *brown* if there's no green"."""
    tokens = document.tokens
    if len(body) != 1 or tokens[body.start].pos != "ADJ" or parts[k].lead != "or" or not 0 < k < len(parts) - 1:
        return False
    asked = [tokens[i] for i in parts[k + 1].body]
    first = {tokens[i].lemma for i in parts[k - 1].body if tokens[i].pos == "ADJ" and tokens[i].dep == "amod"}
    is_lack = parts[k + 1].lead == "if" and any(token.lower in _DENYING for token in asked)
    return is_lack and len(first) == 1 and any(token.lemma in first for token in asked)


def _last_order(document: Document, parts: Sequence[_Part], k: int, body: range, tasks: Mapping[int, str]) -> range:
    """The last of several orders behind a case that opens their sentence, of which the first is what is done in that:
    "if it's dark, light the lamp and *draw the blinds* if not"."""
    is_fronted = k > 0 and parts[k - 1].lead == "if" and (k == 1 or parts[k - 2].is_last or not parts[k - 2].body)
    orders = [i for i in body if tasks.get(i, "check_state") != "check_state"]
    is_joined = len(orders) > 1 and document.tokens[orders[-1] - 1].lower == "and"
    return range(orders[-1], body.stop) if is_fronted and is_joined else body


def _is_second_choice(
    document: Document, before: _Part, part: _Part, condition: _Part, tasks: Mapping[int, str]
) -> bool:
    """Whether what is named behind an order and a comma is for where something is the matter with what the order names:
    "take the big pan, *the small one* if the big one is dirty", "a pen, *a pencil* if there isn't one"."""
    tokens, body = document.tokens, part.body
    is_ordered = before.lead == "start" and any(tasks.get(i, "check_state") != "check_state" for i in before.body)
    is_named = not any(i in tasks or tokens[i].tag == "CC" for i in body) and condition.lead == "if"
    if not (is_ordered and is_named and tokens[part.opening.start].text == ","):
        return False
    first = {tokens[i].lemma for i in before.body if tokens[i].pos in _NAMING | {"ADJ"}}
    own, asked = ({tokens[i].lemma for i in words} for words in (body, condition.body))
    if not _ADDING.isdisjoint(own):
        return False  # "mop the kitchen, the hall too if the kitchen is dirty"
    return _is_contrary(document, condition) or not asked.isdisjoint(first - own)


def _is_added(document: Document, parts: Sequence[_Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether what is named with a condition of its own comes on top of the one order before: "water the roses, *and
    the tulips too* if they're dry"."""
    part = parts[k]
    is_afterthought = part.lead == "start" and bool(part.body) and document.tokens[part.body.start].lower == "and"
    if part.is_last or not (part.lead == "mark" or is_afterthought) or not 0 < k < len(parts) - 1:
        return False
    condition, tokens = parts[k + 1], document.tokens
    before = parts[k - 2 if is_afterthought and k > 1 and _is_tag_question(document, parts[k - 1]) else k - 1]
    gap = tokens[part.body.stop : condition.opening.start]
    is_too = not _ADDING.isdisjoint(tokens[i].lower for i in part.body)
    is_too = is_too and any(tokens[i].lower in _TAKING_UP | _SOME for i in condition.body)
    is_next = not gap or ((is_too or is_afterthought) and [token.text for token in gap] == [","])
    is_done = condition.is_last or _goes_on(document, parts[k + 2 : k + 3])
    is_next = is_next and condition.lead == "if" and is_done
    is_joined = (tokens[part.body.start].lower in ("and", "but") or is_too) and before.lead == "start"
    is_ordered = any(tasks.get(i, "check_state") != "check_state" for i in before.body)
    return is_next and is_joined and is_ordered and any(i in tasks for i in condition.body)


def _is_tag_question(document: Document, part: _Part) -> bool:
    """Whether a part only makes a request of the order before: "pass me the salt, *would you?*"."""
    return part.lead == "mark" and tag_question(document, part.body.start) == part.body


def _is_apart(document: Document, parts: Sequence[_Part], k: int, tasks: Mapping[int, str]) -> bool:
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
    named = [{tokens[i].lemma for i in body if tokens[i].pos in _NAMING} for body in (before, condition.body)]
    first = tokens[before.start].lower
    is_other = bool(named[0]) and first not in _SUBJECTS and named[0].isdisjoint(named[1])
    return is_other and any(i in tasks for i in condition.body) and not _is_contrary(document, condition)


def _is_behind(document: Document, parts: Sequence[_Part], k: int, body: range, tasks: Mapping[int, str]) -> bool:
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
    is_missed = is_place and any(document.tokens[i].lower in _DENYING for i in parts[k - 1].body)
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
        document.tokens[i].lower in _DENYING for i in parts[k - 1].body
    )  # "if there are no apples left, *biscuits*"
    return first in _POINTING or is_lack or (first not in PARTICLES and _is_joined(document, parts, k))


def _parts(observed: Observed, tasks: Mapping[int, str]) -> Iterator[_Part]:
    tokens = observed.document.tokens
    leads = {
        cue.first: ("turn", cue.last)
        for cue in observed.cues
        if cue.name in _TURNING and cue.first not in tasks and not _is_part(tokens, cue.first, cue.last)
    }
    leads |= {cue.first: ("if", cue.last) for cue in observed.cues if cue.name in _OPENING and cue.first not in leads}
    leads |= {  # "if it works"
        cue.first: ("if", cue.first)
        for cue in observed.cues
        if cue.name == "so" and not tasks.keys().isdisjoint(range(cue.first + 1, cue.last + 1))
    }
    leads |= {opening.start: ("besides", opening.stop - 1) for opening in _reminders(observed.document)}
    lead, opening, first, i = "start", range(0), 0, 0
    while i < len(tokens):
        name, last = leads.get(i, ("", i))
        if name == "if" and _says_not(observed.document, i):
            name, last = "turn", i + 1
        if tokens[i].text in MARKS and not _is_hyphen(tokens, i) and name != "besides":
            name = "mark"
        elif tokens[i].lower == "or" and not name:
            name = "or"
        if name:
            is_last = name == "mark" and tokens[i].text in ENDS
            if first < i or lead in ("turn", "or"):
                yield _Part(lead, opening, range(first, i), is_last)
            lead, opening, first = "start" if is_last else name, range(i, last + 1), last + 1
            i = last
        i += 1
    if first < len(tokens) or lead == "turn":
        yield _Part(lead, opening, range(first, len(tokens)), is_last=True)


def _split(document: Document, parts: Sequence[_Part], tasks: Mapping[int, str]) -> Iterator[_Part]:
    """The parts, with what is named behind a condition without a mark as one of its own, as if a mark stood there: "or
    if it's full *the big one*", "the cup if it's clean *the mug* if not"; and what is named on top of an order."""
    for k, part in enumerate(parts):
        is_start = part.lead == "start" and k + 1 < len(parts)
        if is_start and (added := _and_too(document, part.body, parts[k + 1], tasks)):
            yield replace(part, body=range(part.body.start, added.start))
            yield _Part("mark", range(added.start, added.start), added, is_last=part.is_last)
            continue
        praised = _praised_within(document, part.body, tasks) if part.lead == "if" and part.is_last else 0
        if praised:
            yield _Part(part.lead, part.opening, range(part.body.start, praised), is_last=False)
            yield _Part("mark", range(praised, praised), range(praised, part.body.stop), is_last=True)
            continue
        is_joined = k > 0 and document.tokens[part.opening.start - 1].lower in ("and", "or") if part.opening else False
        is_turned = not part.is_last and k + 1 < len(parts) and parts[k + 1].lead in ("if", "turn")
        ahead = next((other.body for other in reversed(parts[:k]) if other.body), range(0))
        start = _inner(document, ahead, part.body, tasks, is_turned=is_turned)
        is_place = start is not None and document.tokens[start].lower in PREPOSITIONS
        is_own = is_place and not part.is_last and _is_order(parts[k + 1 : k + 2], tasks)
        if part.lead != "if" or start is None or not (is_joined or is_turned) or is_own:
            yield part
            continue
        yield _Part(part.lead, part.opening, range(part.body.start, start), is_last=False)
        yield _Part("mark", range(start, start), range(start, part.body.stop), is_last=part.is_last)


def _is_order(following: Sequence[_Part], tasks: Mapping[int, str]) -> bool:
    """Whether what is done in a case is an order behind its mark, so that a place at the end of the case is its
    own: "or if there's no room on the hook, *lay it in the box*"."""
    first = following[0].body.start if following and following[0].lead == "mark" else -1
    return tasks.get(first, "check_state") != "check_state"


def _praised_within(document: Document, body: range, tasks: Mapping[int, str]) -> int:
    """Where what will do as well begins, behind a condition without a mark that denies something: "if there's none *a
    juice will do*"; 0 where nothing does."""
    tokens = document.tokens
    stop = next((i for i in body[2:] if _is_praise(tokens, range(i, body.stop))), 0)
    named = next((chunk for chunk in noun_chunks(document) if stop and chunk.stop == stop), range(0))
    ahead = range(body.start, named.start)
    is_case = any(i in tasks for i in ahead) and any(tokens[i].lower in _DENYING for i in ahead)
    return named.start if named and is_case else 0


def _and_too(document: Document, body: range, condition: _Part, tasks: Mapping[int, str]) -> range:
    """The end of an order that names something on top of it, which the condition right behind is about: "take the
    towels *and the blanket too* if it's dry", "... *and then the blanket* if it's dry"; else empty."""
    tokens = document.tokens
    joint = next((i for i in reversed(body) if tokens[i].lower == "and"), body.stop)
    named = _bare(document, range(joint, body.stop), tasks)
    is_too = bool(body) and tokens[body.stop - 1].lower in _ADDING and named.stop < body.stop
    is_too = is_too or [t.lower for t in tokens[joint : joint + 2]] == ["and", "then"]
    is_own = condition.lead == "if" and tokens[condition.body.start].lower in _TAKING_UP if condition.body else False
    is_ordered = any(tasks.get(i, "check_state") != "check_state" for i in range(body.start, joint))
    is_named = is_too and bool(named) and _is_phrase(document, named, tasks)
    return range(joint, body.stop) if is_own and is_ordered and is_named else range(0)


def _inner(document: Document, ahead: range, body: range, tasks: Mapping[int, str], *, is_turned: bool) -> int | None:
    """Where in a condition that is said in full a phrase begins that is no part of it, behind an "and" at most
    (`is_turned`: where another condition follows, "in the rack if it's wet *and in the drawer* if it's dry"); `ahead`:
    the order before."""
    said = [i for i in body if i in tasks]
    if not said or any(tasks[i] not in ("check_state", "searching") for i in said[:1]):
        return None
    led = {document.tokens[i].lower for i in ahead} & PREPOSITIONS
    for i in range(said[0] + 1, min(said[1:2], default=body.stop)):
        first, before = document.tokens[i], document.tokens[i - 1]
        is_added = is_turned and before.lower == "and" and i > said[0] + 2
        before = document.tokens[i - 2] if is_added else before
        is_state = before.pos == "ADJ" or (before.i == said[0] + 1 and document.tokens[said[0]].lower == "its")
        is_full = is_state or (before.tag == "VBN" and before.i > said[0]) or before.lower in _CLOSED
        is_full = is_full or (is_added and (before.lower in _WHERE or before.pos in _NAMING))
        if first.lower in PREPOSITIONS and i + 1 < body.stop:
            is_start = is_full and bool(led) if is_added else first.lower in led and not is_turned
            is_start = is_start and (is_full or before.pos in _NAMING)
        else:
            is_noun = is_added and first.pos in _NAMING
            is_named = first.pos in ("DET", "NUM") or first.tag == "PRP$" or is_noun
            is_start = is_full and first.lower not in ONES and is_named
        is_start = is_start or (is_turned and is_state and first.lower in PARTICLES and i + 1 == body.stop)
        is_start = is_start or _is_past_lack(document, range(body.start, i))
        if is_start and (words := _bare(document, range(i, body.stop), tasks)) and _is_phrase(document, words, tasks):
            return i
    return None


def _is_past_lack(document: Document, asked: range) -> bool:
    """Whether an article right behind words begins a phrase of its own, as they say that there is no such thing: "if
    there's no cake *a biscuit*"."""
    tokens = document.tokens
    said = tokens[asked.start : asked.stop]
    is_lack = said[0].lower == "there" and any(token.lower in _DENYING for token in said)
    behind = tokens[asked.stop : asked.stop + 1]
    return is_lack and said[-1].pos in _NAMING and bool(behind) and behind[0].lower in _ARTICLES


def _good_enough(document: Document, parts: Sequence[_Part], k: int, tasks: Mapping[int, str]) -> range:
    """What is said to serve as well where what was ordered cannot be had, at the end of a sentence, behind a condition
    or an "otherwise": "if there's none, *water* will do"; else empty. Not what was named already ("if the milk is off,
    the milk is fine"), nor with an order of its own ("then navy will do: bring me that")."""
    part, tokens = parts[k], document.tokens
    is_failed = k > 0 and (part.lead == "turn" or _is_turn_alone(document, parts[k - 1]))
    is_last = part.is_last or _is_further_case(document, parts[k + 1 : k + 3])
    if not is_last or not (is_failed or (part.lead == "mark" and _follows_condition(parts, k, tasks))):
        return range(0)
    stop = next((i for i in part.body if _is_praise(tokens, range(i, part.body.stop))), part.body.start)
    named = _bare(document, range(part.body.start, stop), tasks)
    if not named or not _is_phrase(document, named, tasks) or tokens[named.start].lower in _POINTING:
        return range(0)
    behind = [token for token in tokens[part.body.stop :] if token.text not in MARKS]
    if behind and behind[0].i in tasks and tokens[part.body.stop].text not in ENDS:
        return range(0)
    said = {token.lemma for token in tokens[: part.opening.start] if token.i not in named}
    is_other = any(tokens[i].lemma not in said and tokens[i].pos in _TELLING for i in named)
    return named if is_other or tokens[named.start].lower in _WHICHEVER else range(0)


def _is_further_case(document: Document, behind: Sequence[_Part]) -> bool:
    """Whether no more than a further case goes on: ", and if we're out of wine, ..."."""
    words = [token.lower for part in behind[:1] for token in document.tokens[part.body.start : part.body.stop]]
    return len(behind) > 1 and behind[0].lead == "mark" and words in (["and"], ["but"]) and behind[1].lead == "if"


def _is_turn_alone(document: Document, part: _Part) -> bool:
    """Whether a part is no more than an "otherwise", be it a question: "no luck? Then the radio will do"."""
    behind = document.tokens[part.opening.stop : part.opening.stop + 1]
    return part.lead == "turn" and not part.body and bool(behind) and behind[0].text in ("?", ",")


def _is_praise(tokens: Sequence[Token], words: range) -> bool:
    """Whether words say of something that it serves: "will do just as well", "would be fine too"."""
    said = [tokens[i].lower for i in words]
    while len(said) > _SHORTEST and said[-1] in _CLOSING | _PRAISING and not (said[-1] in _GOOD and said[-2] != "do"):
        said.pop()
    if said[0] not in _WILL | _IS:
        return said[0] == "works" and set(said[1:]) <= _CLOSING | _PRAISING
    said = [word for word in said if word not in _QUITE]
    if said[0] in _WILL:
        return said[1:] == ["do"] or (said[1:2] == ["be"] and len(said) == 3 and said[2] in _GOOD)
    return len(said) == 2 and said[1] in _GOOD


def _in_any_case(observed: Observed, part: _Part) -> range:
    """What is said behind an "either way" that a mark parts from the rest: "and either way *a spoon*"."""
    first = next((i for i in part.body if observed.document.tokens[i].lower not in _JOINING), part.body.stop)
    last = next((cue.last for cue in observed.cues if cue.name == "either_way" and cue.first == first), None)
    if last is None or part.lead != "mark" or observed.document.tokens[last].tag.startswith("W"):
        return range(0)  # "whatever the score"
    return range(last + 1, part.body.stop)


def _is_part(tokens: Sequence[Token], i: int, last: int) -> bool:
    """Whether what looks like an "otherwise" belongs to other words: "everything *else*", "the box, *no*, the bag"; not
    "no luck"."""
    if tokens[i].lower in ("no", "nope", "not"):
        return i == last
    return tokens[i].lower == "else" and i > 0 and tokens[i - 1].lower.endswith(_WHOLE)


def _is_hyphen(tokens: Sequence[Token], i: int) -> bool:
    return tokens[i].text == "-" and i > 0 and tokens[i - 1].end == tokens[i].start


def _says_not(document: Document, i: int) -> bool:
    """Whether "if not" has no clause of its own: "if not a glass of milk", "if not the blue one (will do)"."""
    stop = next((t.i for t in document.tokens[i:] if t.text in MARKS), len(document))
    stop = next((j for j in range(i + 2, stop) if _is_praise(document.tokens, range(j, stop))), stop)
    rest = document.tokens[i + 1 : stop]
    return len(rest) > 1 and rest[0].lower == "not" and all(t.pos not in ("VERB", "AUX") for t in rest)


def _bare(document: Document, body: range, tasks: Mapping[int, str]) -> range:
    """A part without the words that only join it to others, up to the next order ("an apple *and close it*")."""
    first, stop = body.start, body.stop
    while first < stop and document.tokens[first].lower in _LEADING:
        first += 1
    later = next((i for i in range(first + 1, stop) if i in tasks), stop) if first not in tasks else stop
    if later < stop and document.tokens[later - 1].lower in _JOINING:
        stop = later
    closing = _CLOSING if stop == body.stop else _JOINING
    while stop > first and document.tokens[stop - 1].lower in closing:
        stop -= 1
    return range(first, stop)


def _is_phrase(document: Document, body: range, tasks: Mapping[int, str]) -> bool:
    """Whether the tokens name a thing, a person or a place and nothing else."""
    words = document.tokens[body.start : body.stop]
    if len(words) == 1 and words[0].lower in _POINTING | PARTICLES | PLACE_ADVERBS:
        return True
    if len(words) == 1 and words[0].tag == "CD":
        return body.start > 0 and document.tokens[body.start - 1].lower in _CHOOSING  # not "if we've at least six"
    if words[-1].lower in _SHARED and words[-2:-1] and words[-2].lower == "of":
        return len(words) == 3
    is_person = words[-1].pos == "PROPN" or words[-1].lemma in PERSON_NOUNS
    if words[0].lower in _DENYING or words[-1].lemma in _IDLE or (words[0].lower == "with" and not is_person):
        return False  # "bring me one if there is one, with a fork", but "or if he's out, *with Tom*"
    is_led = words[0].lower in PREPOSITIONS and len(words) > 1
    if is_led and len(words) == 2 and words[1].pos == "NUM":
        return words[0].lower in _TO_WHOM  # "to twenty, or *to eighteen* if nobody is in", "for five"
    if is_led and len(words) == 2 and words[1].tag == "PRP":
        return words[0].lower in _TO_WHOM  # "to Tom if he's in, *to me* if not"
    if words[0].lower in _SOMETHING and words[-1].lower != "else":
        return not any(word.i in tasks or word.pos in _NO_PARTS for word in words)
    return (
        (is_led or words[0].pos in _BEGINNING or words[0].tag == "PRP$")
        and any(word.pos in _NAMING or word.lower in ONES for word in words)
        and not any(word.i in tasks or (word.pos in _NO_PARTS and not _is_of_noun(words, word)) for word in words)
    )


def _is_of_noun(words: Sequence[Token], word: Token) -> bool:
    """Whether a participle among words tells what kind of thing the noun right behind it is: "my *reading* glasses"."""
    behind = [other for other in words if other.i == word.i + 1]
    is_within = word.tag in ("VBG", "VBN") and word.i > words[0].i
    return is_within and bool(behind) and behind[0].pos in _NAMING


def _goes_on(document: Document, following: Sequence[_Part]) -> bool:
    """Whether the next part only goes on: "*and then* close the door"."""
    return bool(following) and bool(following[0].body) and document.tokens[following[0].body.start].lower in _JOINING


def _is_joined(document: Document, parts: Sequence[_Part], k: int) -> bool:
    """Whether an "or" or "and" leads the condition that a part follows: "a beer, or if there is none, *lemonade*"."""
    return _joint(document, parts[k - 1]) in ("or", "and", ",")


def _joint(document: Document, condition: _Part) -> str:
    """The word right ahead of a condition, be it that a comma parts them ("tea or, *if there is none*, water"); "" at
    the beginning."""
    tokens, i = document.tokens, condition.opening.start - 1
    if i > 0 and tokens[i].text == "," and tokens[i - 1].lower in ("or", "and"):
        i -= 1
    return tokens[i].lower if i >= 0 else ""


def _follows_condition(parts: Sequence[_Part], k: int, tasks: Mapping[int, str]) -> bool:
    """Whether the part before tells a condition, and the same sentence goes on."""
    if k == 0 or parts[k - 1].is_last:
        return False
    said = [tasks[i] for i in parts[k - 1].body if i in tasks]
    # not "if it's full empty it, the big one"
    is_alone = all(kind in ("check_state", "searching") for kind in said[1:])
    return parts[k - 1].lead == "if" and bool(said) and is_alone


def _is_bare_turn(part: _Part) -> bool:
    return part.lead == "turn" and not part.body and not part.is_last


def _is_contrary(document: Document, part: _Part) -> bool:
    """Whether a condition says no more than that the one before it does not hold: "if not", "if there isn't any"."""
    if part.lead == "turn":
        return not part.body
    words = [token.lower for token in document.tokens[part.body.start : part.body.stop]]
    return (
        len(words) > 2
        and words[0] in _SUBJECTS
        and document.tokens[part.body.start + 1].pos in ("AUX", "VERB")
        and words[2] in _DENYING
        and set(words[3:]) <= _LEFT
    )


def _is_either(document: Document, before: Sequence[_Part], part: _Part, condition: _Part) -> bool:
    """Whether "A or B if C" means B where C holds and A where not, rather than A or B, as you like, where C holds."""
    tokens = document.tokens
    if not before:
        return False
    if before[-1].lead == "if":  # "tea if it's cold or *juice* if it's hot"
        is_order = document.tokens[part.body.start].pos == "VERB"
        return len(before) == 2 and before[0].lead == "start" and not is_order
    if tokens[part.opening.start - 1].text in MARKS or tokens[before[-1].body.start].lower == "either":
        return True
    asked = tokens[condition.body.start : condition.body.stop]
    if any(token.lower in _DENYING for token in asked):
        return True
    own = {tokens[i].lemma for i in part.body}
    first = {tokens[i].lemma for i in before[-1].body if tokens[i].pos in _NAMING | {"ADJ"}}
    return any(token.lemma in first - own for token in asked)
