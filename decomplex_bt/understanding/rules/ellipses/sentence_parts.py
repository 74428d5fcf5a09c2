"""Parts of a sentence, at its marks and the words that lead cases and turns, with the phrases that stand in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.cues import Cue
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import PARTICLES
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.vocabulary import ONES, PERSON_NOUNS, PLACE_ADVERBS, PREPOSITIONS

OPENING = frozenset(("if", "only_if", "unless"))
TURNING = frozenset(("else", "fail"))
JOINING = frozenset("and but or so then just maybe perhaps please".split())
_LEADING = JOINING | {"also", "only"}
_CLOSING = frozenset("please instead then though thanks too also well as altogether completely entirely".split())
ADDING = frozenset(("too", "also", "well"))
_BEGINNING = frozenset(("DET", "NOUN", "PROPN", "ADJ", "NUM"))
NAMING = frozenset(("NOUN", "PROPN"))
_ARTICLES = frozenset("a an some the".split())
_WHOLE = ("thing", "body", "one", "where", "who", "what")
_IDLE = frozenset("case course mind time day thank bother worry love".split())
"""What ends phrases that name nothing: "in which case", "of course", "any time"."""
_NO_PARTS = frozenset(("VERB", "AUX", "SCONJ", "INTJ"))
POINTING = frozenset(("that", "those"))
_SOMETHING = frozenset(("anything", "something"))
_CHOOSING = frozenset(("or", "else", "otherwise"))
_SHARED = POINTING | {"them", "these", "it"}
"""What some is taken of: "two of those"."""
DENYING = frozenset(("not", "n't", "nt", "no", "none", "nobody", "nothing"))
FORGET = "forget"
_OR_ELSE = ("or", "else")
_DO_NOT = frozenset((("do", "n't"), ("do", "not"), ("do", "nt")))
TAKING_UP = frozenset("it its they them their he him his she her".split())
_CLOSED = frozenset("any one none some it them there here home left".split())
"""What may end a condition that is said in full: "if there isn't *one*", "if she's *home*"."""
_WHERE = frozenset("in out outside inside up upstairs downstairs off on".split())
_TO_WHOM = frozenset(("to", "for"))
_WILL = frozenset("will would should 'll 'd might".split())
_IS = frozenset("is are 's".split())
_GOOD = frozenset("fine ok okay great good lovely perfect nice alright enough acceptable grand".split())
_QUITE = frozenset("just perfectly quite also probably all".split())
_PRAISING = frozenset("nicely just me by with fine".split())
"""What may stand behind "will do": "nicely", "by me"."""
_SHORTEST = 2
"""The words at least of such praise: "is fine"."""


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a sentence between two marks or words of `lead`; `opening`: the tokens of that word."""

    lead: str
    opening: range
    body: range
    is_last: bool


def _reminders(document: Document) -> Iterator[range]:
    """The words of every "and don't forget" behind which no verb stands."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-1]):
        if token.lower != FORGET or tokens[i + 1].lower == "to":
            continue
        start = i - 1 if tokens[i - 1].lower == "never" else i - 2
        if start < 0 or (start == i - 2 and (tokens[start].lower, tokens[i - 1].lower) not in _DO_NOT):
            continue
        while start and tokens[start - 1].lower in ("and", "but", ",", "oh"):
            start -= 1
        yield range(start, i + 1)


def parts_of(observed: Observed, tasks: Mapping[int, str]) -> list[Part]:
    """The parts of a text in text order; `tasks` maps token indices to task types."""
    return list(_split(observed.document, list(_parts(observed, tasks)), tasks))


def _parts(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Part]:
    tokens = observed.document.tokens
    leads = {
        cue.first: ("or" if _is_of_case_behind(observed, cue) else "turn", cue.last)
        for cue in observed.cues
        if cue.name in TURNING and cue.first not in tasks and not _is_part(tokens, cue.first, cue.last)
    }
    leads |= {cue.first: ("if", cue.last) for cue in observed.cues if cue.name in OPENING and cue.first not in leads}
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
                yield Part(lead, opening, range(first, i), is_last)
            lead, opening, first = "start" if is_last else name, range(i, last + 1), last + 1
            i = last
        i += 1
    if first < len(tokens) or lead == "turn":
        yield Part(lead, opening, range(first, len(tokens)), is_last=True)


def _is_of_case_behind(observed: Observed, cue: Cue) -> bool:
    """Whether an "or else" joins what is done in a case told behind it, as "or" does: "take it to Ann, *or else* leave
    it here if she's out"."""
    tokens = observed.document.tokens
    if [token.lower for token in tokens[cue.first : cue.last + 1]] != list(_OR_ELSE):
        return False
    case = next((other.first for other in observed.cues if other.name in OPENING and other.first > cue.last), 0)
    return case > cue.last + 1 and all(token.text not in MARKS for token in tokens[cue.last : case])


def _split(document: Document, parts: Sequence[Part], tasks: Mapping[int, str]) -> Iterator[Part]:
    """The parts, with what is named behind a condition without a mark as one of its own, as if a mark stood there: "or
    if it's full *the big one*", "the cup if it's clean *the mug* if not"; and what is named on top of an order."""
    for k, part in enumerate(parts):
        is_start = part.lead == "start" and k + 1 < len(parts)
        if is_start and (added := _and_too(document, part.body, parts[k + 1], tasks)):
            yield replace(part, body=range(part.body.start, added.start))
            yield Part("mark", range(added.start, added.start), added, is_last=part.is_last)
            continue
        praised = _praised_within(document, part.body, tasks) if part.lead == "if" and part.is_last else 0
        if praised:
            yield Part(part.lead, part.opening, range(part.body.start, praised), is_last=False)
            yield Part("mark", range(praised, praised), range(praised, part.body.stop), is_last=True)
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
        yield Part(part.lead, part.opening, range(part.body.start, start), is_last=False)
        yield Part("mark", range(start, start), range(start, part.body.stop), is_last=part.is_last)


def _is_order(following: Sequence[Part], tasks: Mapping[int, str]) -> bool:
    """Whether what is done in a case is an order behind its mark, so that a place at the end of the case is its
    own: "or if there's no room on the hook, *lay it in the box*"."""
    first = following[0].body.start if following and following[0].lead == "mark" else -1
    return tasks.get(first, "check_state") != "check_state"


def _praised_within(document: Document, body: range, tasks: Mapping[int, str]) -> int:
    """Where what will do as well begins, behind a condition without a mark that denies something: "if there's none *a
    juice will do*"; 0 where nothing does."""
    tokens = document.tokens
    stop = next((i for i in body[2:] if is_praise(tokens, range(i, body.stop))), 0)
    named = next((chunk for chunk in noun_chunks(document) if stop and chunk.stop == stop), range(0))
    ahead = range(body.start, named.start)
    is_case = any(i in tasks for i in ahead) and any(tokens[i].lower in DENYING for i in ahead)
    return named.start if named and is_case else 0


def _and_too(document: Document, body: range, condition: Part, tasks: Mapping[int, str]) -> range:
    """The end of an order that names something on top of it, which the condition right behind is about: "take the
    towels *and the blanket too* if it's dry", "... *and then the blanket* if it's dry"; else empty."""
    tokens = document.tokens
    joint = next((i for i in reversed(body) if tokens[i].lower == "and"), body.stop)
    named = bare(document, range(joint, body.stop), tasks)
    is_too = bool(body) and tokens[body.stop - 1].lower in ADDING and named.stop < body.stop
    is_too = is_too or [t.lower for t in tokens[joint : joint + 2]] == ["and", "then"]
    is_own = condition.lead == "if" and tokens[condition.body.start].lower in TAKING_UP if condition.body else False
    is_ordered = any(tasks.get(i, "check_state") != "check_state" for i in range(body.start, joint))
    is_named = is_too and bool(named) and is_phrase(document, named, tasks)
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
        is_full = is_full or (is_added and (before.lower in _WHERE or before.pos in NAMING))
        if first.lower in PREPOSITIONS and i + 1 < body.stop:
            is_start = is_full and bool(led) if is_added else first.lower in led and not is_turned
            is_start = is_start and (is_full or before.pos in NAMING)
        else:
            is_noun = is_added and first.pos in NAMING
            is_named = first.pos in ("DET", "NUM") or first.tag == "PRP$" or is_noun
            is_start = is_full and first.lower not in ONES and is_named
        is_start = is_start or (is_turned and is_state and first.lower in PARTICLES and i + 1 == body.stop)
        is_start = is_start or _is_past_lack(document, range(body.start, i))
        if is_start and (words := bare(document, range(i, body.stop), tasks)) and is_phrase(document, words, tasks):
            return i
    return None


def _is_past_lack(document: Document, asked: range) -> bool:
    """Whether an article right behind words begins a phrase of its own, as they say that there is no such thing: "if
    there's no cake *a biscuit*"."""
    tokens = document.tokens
    said = tokens[asked.start : asked.stop]
    is_lack = said[0].lower == "there" and any(token.lower in DENYING for token in said)
    behind = tokens[asked.stop : asked.stop + 1]
    return is_lack and said[-1].pos in NAMING and bool(behind) and behind[0].lower in _ARTICLES


def is_praise(tokens: Sequence[Token], words: range) -> bool:
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
    stop = next((j for j in range(i + 2, stop) if is_praise(document.tokens, range(j, stop))), stop)
    rest = document.tokens[i + 1 : stop]
    return len(rest) > 1 and rest[0].lower == "not" and all(t.pos not in ("VERB", "AUX") for t in rest)


def bare(document: Document, body: range, tasks: Mapping[int, str]) -> range:
    """A part without the words that only join it to others, up to the next order ("an apple *and close it*")."""
    first, stop = body.start, body.stop
    while first < stop and document.tokens[first].lower in _LEADING:
        first += 1
    later = next((i for i in range(first + 1, stop) if i in tasks), stop) if first not in tasks else stop
    if later < stop and document.tokens[later - 1].lower in JOINING:
        stop = later
    closing = _CLOSING if stop == body.stop else JOINING
    while stop > first and document.tokens[stop - 1].lower in closing:
        stop -= 1
    return range(first, stop)


def is_phrase(document: Document, body: range, tasks: Mapping[int, str]) -> bool:
    """Whether the tokens name a thing, a person or a place and nothing else."""
    words = document.tokens[body.start : body.stop]
    if len(words) == 1 and words[0].lower in POINTING | PARTICLES | PLACE_ADVERBS:
        return True
    if len(words) == 1 and words[0].tag == "CD":
        return body.start > 0 and document.tokens[body.start - 1].lower in _CHOOSING  # not "if we've at least six"
    if words[-1].lower in _SHARED and words[-2:-1] and words[-2].lower == "of":
        return len(words) == 3
    is_person = words[-1].pos == "PROPN" or words[-1].lemma in PERSON_NOUNS
    if words[0].lower in DENYING or words[-1].lemma in _IDLE or (words[0].lower == "with" and not is_person):
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
        and any(word.pos in NAMING or word.lower in ONES for word in words)
        and not any(word.i in tasks or (word.pos in _NO_PARTS and not _is_of_noun(words, word)) for word in words)
    )


def _is_of_noun(words: Sequence[Token], word: Token) -> bool:
    """Whether a participle among words tells what kind of thing the noun right behind it is: "my *reading* glasses"."""
    behind = [other for other in words if other.i == word.i + 1]
    is_within = word.tag in ("VBG", "VBN") and word.i > words[0].i
    return is_within and bool(behind) and behind[0].pos in NAMING
