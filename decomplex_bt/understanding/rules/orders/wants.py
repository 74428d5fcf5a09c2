"""Wants: what somebody is to have ("I need a pen", "Anna wants her book"), where nothing else is ordered that it would
be the reason of, and what somebody would like to be so ("I'd like it off")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.ellipses.fragments import NO_THINGS, STATES, Fragment
from decomplex_bt.understanding.rules.orders.needs import OPENING
from decomplex_bt.understanding.rules.orders.uses import uses
from decomplex_bt.understanding.vocabulary import ANIMALS, ONES, PERSON_NOUNS

_SPEAKERS = frozenset(("i", "we"))
_NEEDING = frozenset("need needs want wants".split())
_WOULD = frozenset("would 'd".split())
_LIKING = frozenset(("like", "love", "prefer"))
_COULD = (("could",), ("can",))
_WOULD_NOT = (("would", "n't"), ("would", "not"))
_AM = (("'m",), ("am",))
_COLLOQUIAL: Mapping[str, tuple[tuple[tuple[str, ...], ...], tuple[str, ...]]] = MappingProxyType(
    {
        "fancy": (((), ("do",)), ()),
        "do": (_COULD, ("with",)),
        "murder": (_COULD, ()),
        "mind": (_WOULD_NOT, ()),
        "dying": (_AM, ("for",)),
        "craving": (_AM, ()),
    }
)
"""By the verb of a wish what may stand between "I" and that, and what stands behind it."""
_LACKING = frozenset("no none not n't nt".split())
_HAVING = (["have"], ["'ve"], ["do"])
_ADVERBS = frozenset("also really just now rather still badly urgently".split())
_ASKING = frozenset(("check_state", "searching"))
_JOINING_CASES = frozenset(("and", "but", "or", ","))
_GOING_ON = frozenset(("and", "also"))
_INDEFINITE = frozenset("a an some another more something".split())
_OWN = frozenset("my our his her their its".split())
_SOMETHING = frozenset(("something", "anything"))
_NOMINAL = frozenset(("ADJ", "NUM", "NOUN", "PROPN"))
_NAMING = frozenset(("NOUN", "PROPN"))
_JOINING = frozenset(("and", "of"))
_CLOSING = frozenset("please now too robot thanks back though quickly urgently ,".split())
_LEADING = frozenset("in on at up over down by into onto".split())
_HERE = frozenset("here there upstairs downstairs outside inside".split())
_BEHIND_STATES = frozenset("please now too again if when then before after by and but so".split())
NOT_BROUGHT = frozenset(
    "nap break rest help assistance minute moment second sec bit hand haircut hug kiss job holiday vacation shower "
    "bath sleep time change ride lift walk chat talk word favour favor advice idea plan reason answer question space "
    "room peace quiet fun luck friend company way day night week hour while money wee pee work exercise air "
    "sun light information info detail practice lesson doctor nurse plumber chance explanation update".split()
)
"""What people need and is brought by nobody, or comes by itself."""
_ABSTRACT = ("ness", "tion", "sion", "ity", "ence", "ance", "ship")
_PLACES = frozenset(("room", "furniture", "floor", "person"))


def wants(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Fragment]:
    """What is wanted, carried by "need" or "want", or by the state; `tasks`: tokens that are tasks, with types."""
    document = observed.document
    if document.words.isdisjoint(_NEEDING | _LIKING | _COLLOQUIAL.keys()):
        return
    for verb, token in enumerate(document.tokens):
        if token.lower in _NEEDING | _LIKING and (who := _wanting(document, verb)):
            want = _state(document, who, verb, tasks) or _thing(observed, who, verb, verb, tasks)
            if want is not None:
                yield want
        if token.lower in _COLLOQUIAL and (said := _fancying(document, verb)):
            want = _thing(observed, said, verb, verb + len(_COLLOQUIAL[token.lower][1]), tasks)
            if want is not None:
                yield want


def _fancying(document: Document, verb: int) -> range:
    """Who begins a sentence with a wish in other words: "*I* could do with", "*I* wouldn't mind"; else empty."""
    words = [token.lower for token in document.tokens]
    ahead, behind = _COLLOQUIAL[words[verb]]
    if tuple(words[verb + 1 : verb + 1 + len(behind)]) != behind:
        return range(0)
    first = next(i for i in range(verb + 1) if document.sentences[i] == document.sentences[verb])
    while first < verb and words[first] in OPENING:
        first += 1
    between = [word for word in words[first + 1 : verb] if word not in _ADVERBS]
    is_said = words[first] in _SPEAKERS and (tuple(between) in ahead)
    return range(first, first + 1) if is_said else range(0)


def _wanting(document: Document, verb: int) -> range:
    """Who wants, where a sentence or what follows a comma begins with it: "*I* need", "*Anna* wants", "*Tom* would
    like"; else empty. "She" is told of, mostly, to say why."""
    tokens, sentences = document.tokens, document.sentences
    stop = verb
    while stop and tokens[stop - 1].lower in _ADVERBS:
        stop -= 1
    is_liking = tokens[verb].lower in _LIKING
    if is_liking and (not stop or tokens[stop - 1].lower not in _WOULD):
        return range(0)
    stop -= is_liking
    start = max(0, stop - 1)
    if tokens[start].lemma in PERSON_NOUNS | ANIMALS:
        start -= start > 0 and tokens[start - 1].tag in ("PRP$", "DT")
    if start >= stop or not _is_somebody(document, range(start, stop)):
        return range(0)
    first = next(i for i in range(verb + 1) if sentences[i] == sentences[verb])
    ahead = [i for i in range(first, start) if tokens[i].lower not in OPENING]
    is_second = any(tokens[i].lower in _NEEDING for i in ahead)
    is_denied = not _LACKING.isdisjoint(tokens[i].lower for i in ahead)  # "I don't want this one, I want that one"
    is_behind = bool(ahead) and (not is_second or is_denied) and tokens[start - 1].text == ","  # "I'm soaked, I need"
    is_joined = is_second and tokens[start - 1].lower == "and"
    return range(start, stop) if not ahead or is_behind or is_joined else range(0)


def _is_somebody(document: Document, who: range) -> bool:
    last = document.tokens[who.stop - 1]
    is_name = last.pos == "PROPN" and last.text[:1].isupper() and len(who) == 1
    return last.lower in _SPEAKERS or last.lemma in PERSON_NOUNS | ANIMALS or is_name


def _state(document: Document, who: range, verb: int, tasks: Mapping[int, str]) -> Fragment | None:
    """What the speaker would like to be on, off, open or closed: "I want *the radio* on"."""
    tokens = document.tokens
    if tokens[who.start].lower not in _SPEAKERS or any(kind == "informing" for kind in _before(document, tasks, verb)):
        return None
    stop = verb + 1
    while stop < len(tokens) and (tokens[stop].pos in _NOMINAL | {"DET"} or tokens[stop].tag == "PRP$"):
        if tokens[stop].lower in STATES:
            break
        stop += 1
    is_pronoun = stop == verb + 1 < len(tokens) and tokens[stop].lower in ("it", "them", "that", "those")
    stop += is_pronoun
    thing = range(verb + 1, stop)
    is_named = bool(thing) and (is_pronoun or (tokens[stop - 1].pos in _NAMING and _is_whole_thing(document, thing)))
    if not is_named or stop >= len(tokens) or tokens[stop].lower not in STATES:
        return None
    behind = tokens[stop + 1].lower if stop + 1 < len(tokens) else "."
    if behind not in MARKS | _BEHIND_STATES:
        return None
    return Fragment(range(who.start, stop + 1), stop, thing, range(0), "change_state")


def _is_whole_thing(document: Document, thing: range) -> bool:
    """Whether what is to be on is no garment, which somebody has on."""
    return document.tokens[thing.stop - 1].lemma not in NO_THINGS and document.tokens[thing.start].pos != "ADJ"


def _before(document: Document, tasks: Mapping[int, str], verb: int) -> list[str]:
    """The types of the tasks ahead of a verb in its sentence, back to a mark."""
    found, i = [], verb - 1
    while i >= 0 and document.tokens[i].lower not in MARKS:
        found += [tasks[i]] if i in tasks else []
        i -= 1
    return found


def _thing(observed: Observed, who: range, verb: int, last: int, tasks: Mapping[int, str]) -> Fragment | None:
    """What is to be brought: something that can be, and of which nothing says what else is to be done; `last`: the last
    word of the wish ahead of it."""
    document = observed.document
    tokens = document.tokens
    thing = _named(document, last)
    if not thing or _is_of_order(document, who, thing, tasks):
        return None
    stop = next((token.i for token in tokens[thing.stop :] if token.lower in ENDS), len(tokens))
    if stop < len(tokens) and tokens[stop].text == "?":
        return None
    end = next((token.i for token in tokens[thing.stop : stop] if token.lower in (",", "if")), stop)
    while end > thing.stop and tokens[end - 1].lower in _CLOSING:
        end -= 1
    place = range(thing.stop + (tokens[thing.stop : end][:1] != () and tokens[thing.stop].lower == "over"), end)
    if place and not _is_place(document, place):
        return None
    can_be = _can_be_brought(observed, thing, tokens[who.start].lower, is_told=bool(place))
    words = range(who.start, max(thing.stop, place.stop))
    return Fragment(words, verb, thing, place, "bringing", recipient=who) if can_be else None


def _is_of_order(document: Document, who: range, thing: range, tasks: Mapping[int, str]) -> bool:
    """Whether what is ordered before or behind a want tells what to do about it ("boil the kettle. *I need hot water*",
    "*I need a cloth*. There may be one in the sink"): not before one that goes on ("and I need"), nor its own case."""
    tokens, sentences = document.tokens, document.sentences
    others = {i: kind for i, kind in tasks.items() if tokens[i].lower not in _NEEDING | _LIKING | _COLLOQUIAL.keys()}
    others = {i: kind for i, kind in others.items() if not _is_in_its_place(document, who, i)}
    if [t.lower for t in tokens[thing.stop : thing.stop + 1]] == ["if"]:  # "I fancy a plum *if there are any*"
        case = [i for i in others if i > thing.stop and sentences[i] == sentences[thing.stop]]
        others = {i: kind for i, kind in others.items() if i not in case or kind not in _ASKING}
    if any(i >= thing.stop and not (kind in _ASKING and _is_case(document, i)) for i, kind in others.items()):
        return True
    first = next(i for i in range(who.start + 1) if sentences[i] == sentences[who.start])
    is_going_on = not _GOING_ON.isdisjoint(token.lower for token in tokens[first : thing.start])
    ahead = {i: kind for i, kind in others.items() if i < who.start}
    return not is_going_on and any(
        kind not in _ASKING or (i < first and not _is_case(document, i)) for i, kind in ahead.items()
    )


def _is_in_its_place(document: Document, who: range, order: int) -> bool:
    """Whether an order of the next sentence is for where there is none of what is wanted, or it is not where it is
    thought to be: "I need a saw. If there is none, *bring* the axe", "I fancy a tea. If we have no milk, *bring* me a
    juice", "I need my pen. If it isn't on the desk, *ask* Tom"."""
    tokens, sentences = document.tokens, document.sentences
    ahead = [t.lower for t in tokens[who.stop : order + 2] if sentences[t.i] == sentences[order]]
    if sentences[order] != sentences[who.start] + 1 or "if" not in ahead:
        return False
    case = ahead[ahead.index("if") + 1 :]
    is_none = ahead[:1] == ["if"] and ("there" in case or (case[:1] in (["we"], ["you"]) and case[1:2] in _HAVING))
    is_elsewhere = case[:1] in (["it"], ["they"]) and not _LEADING.isdisjoint(ahead)
    return (is_none or is_elsewhere) and not _LACKING.isdisjoint(case)


def _is_case(document: Document, check: int) -> bool:
    """Whether a check's sentence begins with an "if": "I need a pen. *If there's none*, a pencil will do"."""
    sentences = document.sentences
    words = (token.lower for token in document.tokens if sentences[token.i] == sentences[check])
    return next((word for word in words if word not in _JOINING_CASES), "") == "if"


def _is_place(document: Document, words: range) -> bool:
    """Whether words say where something is wanted: "in the kitchen", "over here"; not "for my tea"."""
    first, last = document.tokens[words.start], document.tokens[words.stop - 1]
    is_led = first.lower in _LEADING or (first.lower == "here" and len(words) == 1)
    return is_led and (last.pos in _NAMING or last.lower in _HERE)


def _named(document: Document, verb: int) -> range:
    """The thing behind a verb of wanting: "a pen and some ink", "a cup of tea", "something to write with", "a cloth
    to wipe the table with"."""
    tokens, start = document.tokens, verb + 1
    if start >= len(tokens):
        return range(0)
    use = next((use.words for use in uses(document) if use.words.start > start), range(0))
    if use and all(t.pos in _NOMINAL | {"DET", "PRON", "CCONJ"} for t in tokens[start : use.start]):
        return range(start, use.stop)
    if tokens[start].lower in _SOMETHING:
        stop = start + 1
        while stop < len(tokens) and tokens[stop].pos == "ADJ":
            stop += 1
        if stop + 1 < len(tokens) and tokens[stop].lower == "to" and tokens[stop + 1].tag == "VB":
            stop += 2
            stop += stop < len(tokens) and tokens[stop].tag in ("IN", "RP")
        if stop == start + 1:
            return range(0)
        is_joined = stop + 1 < len(tokens) and tokens[stop].lower == "and" and tokens[stop + 1].lower in _SOMETHING
        return range(start, _named(document, stop).stop or stop) if is_joined else range(start, stop)
    is_led = tokens[start].lower in _INDEFINITE | _OWN or tokens[start].pos == "NUM" or tokens[start].lower == "the"
    if _is_stuff(document, start):
        return range(start, start + 1)
    stop = start + 1
    while stop < len(tokens) and is_led:
        is_joint = tokens[stop].lower in _JOINING and tokens[stop - 1].pos in _NAMING and stop + 1 < len(tokens)
        if is_joint and (tokens[stop + 1].pos in _NOMINAL | {"DET"} or tokens[stop + 1].tag == "PRP$"):
            stop += 2
        elif tokens[stop].pos in _NOMINAL and tokens[stop].lower not in _CLOSING:
            stop += 1
        else:
            break
    is_named = tokens[stop - 1].pos in _NAMING or (stop > start + 1 and tokens[stop - 1].lower in ONES)
    return range(start, stop) if is_led and is_named else range(0)


def _is_stuff(document: Document, i: int) -> bool:
    """Whether a noun stands alone, as that of a stuff does: "I need *water*", not "a water bottle"."""
    tokens = document.tokens
    is_ended = i + 1 >= len(tokens) or tokens[i + 1].text in MARKS or tokens[i + 1].lower in _CLOSING
    return tokens[i].tag == "NN" and is_ended


def _can_be_brought(observed: Observed, thing: range, who: str, *, is_told: bool) -> bool:
    """Whether it is a thing to be brought: for others, and for "us" without a word where, only what is known to be
    carried about or is their own, since people want jobs and dogs, and "we need milk" may be for the next shopping."""
    tokens = observed.document.tokens
    used = {i for use in uses(observed.document) for i in use.words}
    nouns = [tokens[i] for i in thing if tokens[i].pos in _NAMING and i not in used]
    heads = [noun for noun in nouns if noun.i + 1 == thing.stop or tokens[noun.i + 1].pos not in _NAMING]
    if tokens[thing.start].lower in _SOMETHING or tokens[thing.stop - 1].lower in ONES:
        return who == "i"
    if not heads or any(token.lemma in NOT_BROUGHT or token.lemma.endswith(_ABSTRACT) for token in heads):
        return False
    kinds = {observed.gazetteer.category(token.lemma) for token in heads}
    is_fixed = not kinds.isdisjoint(_PLACES) and used.isdisjoint(thing)
    if is_fixed or not PERSON_NOUNS.isdisjoint(token.lemma for token in heads):
        return False
    is_known = "thing" in kinds
    if len(thing) == 1 and not is_known:
        return False  # "I need quiet"
    if who == "we":
        return is_known and is_told
    return who == "i" or is_known or tokens[thing.start].lower in _OWN
