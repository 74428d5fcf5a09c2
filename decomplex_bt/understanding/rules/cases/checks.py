"""Checks: what a check asks of, and which state of it, as English settles it."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from itertools import dropwhile

from decomplex_bt.domain.clauses import WEATHER, is_air
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.cue_phrases import WISHING
from decomplex_bt.understanding.document import FINITE, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.identity import identity_of, order_behind
from decomplex_bt.understanding.references.phrases import degree_asked, nobody
from decomplex_bt.understanding.vocabulary import AIRED, PREPOSITIONS, WARMTH

_BE = frozenset(("is", "'s", "was"))
_NOMINAL = frozenset(("DET", "NOUN", "PROPN", "PRON"))
_UNNAMED = frozenset("somebody someone something visitor visitors caller stranger".split())
_EMPTY = frozenset("it there that this what which who that nothing nobody none".split())
_SUBJECTS = frozenset("i we he she they".split())
OVER = frozenset("gone left finished done".split())
"""What says that somebody has gone, or is done with something."""
CALLING = frozenset("tell ask say call shout ring whistle signal wave text yell".split())
"""What a speaker does to be heard."""
_STATING = frozenset("be 's 're have".split())
_LEFT = frozenset("left over still".split())
_OF_CHECKS = frozenset(("object", "state", "location"))
_DESCRIBING = frozenset(("JJ", "VBN", "JJR"))
_JOINING = frozenset(("and", "or", "but"))
_BEHIND_PARTICLES = frozenset(("ADV", "CCONJ", "SCONJ", "VERB", "AUX"))
_DEGREES = frozenset("not n't still too also very quite only nearly almost already fully completely".split())
_BEFORE_WEATHER = frozenset(
    "it be been 's is are 're re s just already not n't finally actually really now all still started starts "
    "starting getting gets turned so too very only outside a an the stopped stops begun begins begin to looks "
    "look looking like".split()
)
"""What may stand between the verb of a check and the word for the weather or the day."""
_WHETHER = frozenset(("whether", "if"))
_TEMPERATURES = frozenset("hot cold warm freezing chilly cool icy wet dry".split())
_NO_GERUNDS = frozenset("bring sing ring fling swing string sting cling".split())
_OUTSIDE = frozenset("outside out outdoors today tonight tomorrow".split())
_OF_THINGS = frozenset(("foggy", "pours"))
_STATES = frozenset("on off in out up down over".split())
"""Prepositions that alone say how something is."""


def done_by_nobody(document: Document, verb: int) -> dict[str, range]:
    """What nobody does something to, as the object of the check: "if nobody answers *the phone*"."""
    things = (phrase for phrase in noun_chunks(document) if phrase.start == verb + 1)
    is_act = document.tokens[verb].tag in ("VBZ", "VBP", "VBD") and document.tokens[verb].lemma not in _STATING
    thing = next(things, None) if is_act and nobody(document, verb) else None
    if thing is None or document.tokens[thing.start].tag not in ("DT", "PRP$"):
        return {}
    return {} if document.tokens[thing.stop - 1].dep == "npadvmod" else {"object": thing}  # "nobody comes this morning"


def without_air(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments without an "it" that is no thing, but how warm it is around: nothing that is handled is itself
    ("open the window if *it*'s warm", "bring me a jumper if *it*'s cold")."""
    own = {a.type: a for a in arguments if a.owner == check}
    thing, state = own.get("object"), own.get("state")
    if thing is None or state is None or [document.tokens[i].lower for i in thing.tokens] != ["it"]:
        return list(arguments)
    words = {document.tokens[i].lower for i in state.tokens}
    handled = {document.tokens[a.tokens[-1]].lemma for a in arguments if a.type == "object" and a.owner != check}
    is_air = not words.isdisjoint(WARMTH) and "location" not in own and bool(handled) and handled <= AIRED
    return [a for a in arguments if a is not thing] if is_air else list(arguments)


def is_gerund(token: Token) -> bool:
    """Whether a verb says what somebody is doing; of "if there are bring me two" the tagger says so, too."""
    return token.tag == "VBG" and token.lower not in _NO_GERUNDS


def doing(document: Document, check: int) -> dict[str, range]:
    """What somebody is doing to something, as the state of the check: "if Dad is still *mowing the lawn*"."""
    tokens = document.tokens
    verb = next((t.i for t in tokens[check + 1 :] if t.tag != "RB"), check)
    if tokens[check].lower not in _BE | {"are", "'re"} or not is_gerund(tokens[verb]):
        return {}
    thing = next((phrase for phrase in noun_chunks(document) if phrase.start == verb + 1), None)
    if thing is None or tokens[thing.start].tag not in ("DT", "PRP$"):  # not "if it's sticking turn it down"
        return {}
    is_done_to = any(tokens[i].dep == "dobj" and i in thing for i in document.children[verb])
    return {"state": range(verb, thing.stop)} if is_done_to else {}


def whole_state(document: Document, state: range) -> range:
    """A state with the particle of its verb and those that are joined to it, where nothing else is said behind: "boxed
    *up*", "clean *and dry*", "awake *but not hungry*", "asleep *or busy*"."""
    tokens, stop = document.tokens, state.stop
    if _is_with_particle(document, state):
        return range(state.start, stop + 1)
    is_described = bool(state) and tokens[state.stop - 1].tag in _DESCRIBING
    while is_described and stop + 1 < len(tokens) and tokens[stop].lower in _JOINING:
        at = stop + 1
        while at < len(tokens) and tokens[at].lower in _DEGREES:
            at += 1
        if at >= len(tokens) or tokens[at].tag not in _DESCRIBING:
            break
        behind = tokens[at + 1 : at + 2]
        if behind and behind[0].text not in MARKS and behind[0].tag not in ("VB", "VBP"):
            break
        stop = at + 1
    return range(state.start, stop)


def _is_with_particle(document: Document, state: range) -> bool:
    """Whether a particle behind a participle is said of it, and leads nowhere: "boxed *up*", not "left *in* it"."""
    tokens, at = document.tokens, state.stop
    tags = [token.tag for token in tokens[at - 1 : at + 1]] if state else []
    if tags != ["VBN", "RP"]:
        return False
    return at + 1 == len(tokens) or tokens[at + 1].text in MARKS or tokens[at + 1].pos in _BEHIND_PARTICLES


def with_place(
    document: Document, tasks: Container[int], arguments: Sequence[FoundArgument], check: int
) -> list[FoundArgument]:
    """The arguments with where somebody is as a place and no state, and whole: "if she's *at work*". What goes wrong on
    the way is in no place ("if the blind sticks *on the way up*")."""
    kept: list[FoundArgument] = []
    for a in arguments:
        place = _place(document, a.tokens) if (a.owner, a.type) == (check, "state") else range(0)
        place = place if all(i not in tasks for i in place) else range(0)  # "if it's on *check* whether ..."
        is_where = bool(place) and document.tokens[place.start].lower in PREPOSITIONS
        if is_where and document.tokens[check].pos == "AUX":
            kept.append(replace(a, type="location", tokens=place))
        elif not place:
            kept.append(a)
    return kept


def _place(document: Document, state: range) -> range:
    """The phrase of which a state has but the preposition, or that says "at work" or "on the way"; else empty. Who is
    "at her prayers" is in a state."""
    tokens, word = document.tokens, document.tokens[state.start]
    chunk = next((chunk for chunk in noun_chunks(document) if chunk.start == state.start + 1), range(0))
    if not chunk or word.dep != "prep" or tokens[chunk[-1]].head != word.i:
        return range(0)
    if any(token.tag in FINITE for token in tokens[chunk.stop : chunk.stop + 1]):
        return range(0)  # "if the light is on the kids are home"
    is_way = word.lower == "on" and tokens[chunk[-1]].lower == "way" and tokens[word.head].pos == "VERB"
    is_at = word.lower == "at" and tokens[chunk.start].pos == "NOUN"
    is_bare = len(state) == 1 and word.lower not in _STATES  # not "if it's still *on* next door"
    return range(state.start, chunk.stop) if is_bare or is_at or is_way else range(0)


def with_whole_state(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with the whole of the state that a check asks for, and none of its parts beside it."""
    state = next((a for a in arguments if (a.owner, a.type) == (check, "state")), None)
    whole = whole_state(document, state.tokens) if state is not None else range(0)
    if state is None or whole == state.tokens:
        return list(arguments)
    kept = [a for a in arguments if a is state or not set(a.tokens) & set(whole)]
    return [replace(a, tokens=whole) if a is state else a for a in kept]


def that_there_is(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with what there is as the object of the check, and no state of nothing: "if there's *less than half
    a jug*"."""
    own = {a.type for a in arguments if a.owner == check}
    is_there = check > 0 and document.tokens[check - 1].lower == "there"
    if not is_there or "object" in own:
        return list(arguments)
    return [
        replace(a, type="object")
        if (a.owner, a.type) == (check, "state") and any(document.tokens[i].pos == "NOUN" for i in a.tokens)
        else a
        for a in arguments
    ]


def with_subject(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with what a check asks if "there is", where it has none, with who a wish is of, and what is wished
    for, and with who calls, is at work or is done: "whether there's *bread*", "if *she* doesn't want *the cake*", "when
    *I*'m *done*", "if *that*'s *broken*"."""
    tokens = document.tokens
    if any(a.owner == check for a in arguments):
        return list(arguments)
    chunks = list(noun_chunks(document))
    told: dict[str, range | None] = {}
    if tokens[check].lemma in WISHING:
        told = {"object": _dependent(document, chunks, check, "nsubj")}
        told["state"] = _dependent(document, chunks, check, "dobj")
    elif check > 1 and tokens[check - 1].lower == "there" and tokens[check - 2].lower == "whether":
        told = {"object": next((chunk for chunk in chunks if chunk.start == check + 1), None)}
    elif check and tokens[check - 1].lower in _SUBJECTS and (tokens[check].lemma in CALLING or _is_over(tokens, check)):
        told = {"object": range(check - 1, check)}
        told["state"] = range(check + 1, check + 2) if _is_over(tokens, check) else None
    elif (subject := _pointed_at(tokens, check)) is not None:
        is_denied = any(token.tag == "RB" for token in tokens[check + 1 : check + 2])
        stop = next((t.i for t in tokens[check + 1 :] if t.text in MARKS), len(tokens))
        told = {"object": subject}
        told["state"] = range(check + 1 + is_denied, stop) if tokens[check].tag != "VBN" else None
    return with_told(arguments, check, {name: words for name, words in told.items() if words})


def _pointed_at(tokens: Sequence[Token], check: int) -> range | None:
    """The "you" or "that" which is the subject of a case with no more than a participle: "if *that*'s broken", "if
    *you*'re not using it", "if *you*'ve finished with it"."""
    be = check - (tokens[check].tag == "VBN")
    is_case = be > 1 and tokens[be - 2].lower == "if" and tokens[be - 1].lower in ("you", "that")
    behind = next((t for t in tokens[be + 1 :] if t.tag != "RB"), None)
    is_participle = behind is not None and behind.tag in ("VBG", "VBN")
    return range(be - 1, be) if is_case and is_participle else None


def _is_over(tokens: Sequence[Token], check: int) -> bool:
    """Whether a check asks if somebody is done with something, or gone: "when I*'m* done"."""
    is_be_or_have = tokens[check].lemma in ("be", "have") or tokens[check].lower in _STATING
    return is_be_or_have and check + 1 < len(tokens) and tokens[check + 1].lower in OVER


def _dependent(document: Document, chunks: Sequence[range], verb: int, relation: str) -> range | None:
    """The phrase of a verb's subject or object."""
    tokens = document.tokens
    head = next((i for i in document.children[verb] if tokens[i].dep == relation), None)
    if head is None or tokens[head].lower in _EMPTY:
        return None
    return next((chunk for chunk in chunks if head in chunk), range(head, head + 1))


def without_left(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments without a state that only says that there is something: "if there is any milk *left*"."""
    around = {document.tokens[i].lower for i in range(max(check - 1, 0), min(check + 3, len(document)))}
    if "there" not in around:
        return list(arguments)
    return [
        a
        for a in arguments
        if (a.owner, a.type) != (check, "state") or {document.tokens[i].lower for i in a.tokens} - _LEFT
    ]


def departed(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments of a check with where somebody has gone as how they are, and who: "after *we*'ve gone *to bed*"."""
    own = {a.type for a in arguments if a.owner == check}
    tokens = document.tokens
    if "goal" not in own or "state" in own or tokens[check].lemma != "go":
        return list(arguments)
    kept = [replace(a, type="state") if (a.owner, a.type) == (check, "goal") else a for a in arguments]
    subject = next((i for i in document.children[check] if tokens[i].dep == "nsubj" and tokens[i].tag == "PRP"), None)
    if subject is None or "object" in own:
        return kept
    return [*kept, FoundArgument("object", check, range(subject, subject + 1), CERTAIN)]


def identified(observed: Observed, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with who or what it is as the state of "it", where somebody was spoken of before: "Somebody is at
    the door. If it's the plumber, ..."; where only "who" was asked for, "it" names nothing."""
    tokens = observed.document.tokens
    is_it = check > 0 and tokens[check].lower in _BE and tokens[check - 1].lower == "it"
    said = {token.lower for token in tokens[: max(0, check - 1)]}
    is_asked = said.isdisjoint(_UNNAMED)  # "ask who it is. If it's the plumber, ..."
    is_typed = is_asked and tokens[check].lower == "its"  # for "it's"
    if not (is_it or is_typed) or said.isdisjoint(_UNNAMED | {"who"}):
        return list(arguments)
    it = FoundArgument("object", check, range(check - is_it, check), CERTAIN)
    own = [a for a in arguments if a.owner == check and a.type in ("object", "state") and a.tokens != it.tokens]
    if is_asked and not own:
        names = (chunk for chunk in noun_chunks(observed.document) if chunk.start == check + 1)
        own = [FoundArgument("object", check, name, CERTAIN) for name in names]
    if len(own) != 1 or own[0].tokens.start != check + 1 or tokens[check + 1].pos not in _NOMINAL:
        return list(arguments)
    others = [a for a in arguments if a is not own[0] and set(a.tokens).isdisjoint(it.tokens)]
    if is_asked:
        return [*others, replace(own[0], type="object")]
    return [*others, it, replace(own[0], type="state")]


def with_named_state(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments with what a condition says something is: the object where "it" names nothing ("if it's *my
    cousin*"), else the state of what is spoken of ("if that noise is *the dryer*", "if that was *the last one*").
    A "should it be the vet" has the arguments that were found."""
    identity = identity_of(document, check)
    if identity is None or document.tokens[identity.subject.start - 1].lower == "should":
        return list(arguments)
    order = order_behind(document, identity)
    said = {*identity.subject, *identity.name, order}
    kept = [a for a in arguments if a.owner != order or document.tokens[a.tokens.start - 1].lower != "for"]
    others = [a for a in kept if a.owner != check or said.isdisjoint(a.tokens) or a.type not in _OF_CHECKS]
    own = {a.type: a for a in kept if a not in others}
    is_it = document.tokens[identity.subject.start].lower in ("it", "they")
    is_of_it = "object" in own and own["object"].tokens == identity.subject
    is_first = not any(a.tokens.stop <= identity.subject.start for a in kept)
    is_told = is_it and "state" in own and own["state"].tokens.start in identity.name and (is_of_it or not is_first)
    is_new = is_it and not is_told and not is_of_it and (is_first or not identity.is_of_order(document))
    is_new = is_new and not any(a.owner == check and a.type == "object" for a in others)
    if is_new or (is_it and identity.is_of_person(document) and not (is_told and is_of_it)):
        return [*others, FoundArgument("object", check, identity.name, CERTAIN)]
    if is_told or (not is_it and identity.is_pronoun(document) and not identity.is_of_order(document)):
        return kept
    subject = FoundArgument("object", check, identity.subject, CERTAIN)
    return [*others, subject, FoundArgument("state", check, identity.name, CERTAIN)]


def with_told(arguments: Sequence[FoundArgument], check: int, told: Mapping[str, range]) -> list[FoundArgument]:
    """The arguments with what an idiom tells of a check: in place of what lies within its words, but for what is of
    the right type already."""
    kept = list(arguments)
    for name, tokens in told.items():
        own = {a.type: a for a in kept if a.owner == check and a.type in _OF_CHECKS}
        if name == "location" and "state" in own:
            continue
        if name in own and not set(own[name].tokens) < set(tokens):
            continue
        kept = [a for a in kept if not set(a.tokens) <= set(tokens)]
        if not any(set(a.tokens) & set(tokens) for a in kept):
            kept.append(FoundArgument(name, check, tokens, CERTAIN))
    return kept


def asked(
    document: Document, arguments: Sequence[FoundArgument], check: int, tasks: Mapping[int, str]
) -> list[FoundArgument]:
    """The arguments, with what a "how full the jug is" is about as the object of its check, and without a state of that
    where a later check may say one."""
    thing = degree_asked(document, check)
    if not thing:
        return list(arguments)
    is_said_later = any(token > check and kind == "check_state" for token, kind in tasks.items())
    kept = [a for a in arguments if a.owner != check or a.type not in ("object", "state")]
    kept = [a for a in kept if set(a.tokens).isdisjoint(thing)]
    states = [a for a in arguments if (a.owner, a.type) == (check, "state")]
    return [*kept, FoundArgument("object", check, thing, CERTAIN), *([] if is_said_later else states)]


def naming(document: Document, verb: int, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments of a check without the "it" of weather and time, which names nothing ("if it's raining"), nor where
    it tells what it is like somewhere ("if it's stuffy in here"); of a word that tells of things as well ("if it is
    foggy") only where nothing is named before."""
    words = [token.lower for token in document.tokens[verb : verb + 9]]
    asked = next((i + 1 for i, word in enumerate(words[:4]) if word in _WHETHER), 0)
    said = list(dropwhile(_BEFORE_WEATHER.__contains__, words[asked:]))
    is_outside = said[:1] != [] and said[0] in _TEMPERATURES and said[1:2] != [] and said[1] in _OUTSIDE
    if not said or not (is_outside or said[0] in WEATHER or is_air(said)):
        return list(arguments)
    if said[0] in _OF_THINGS and any(token.pos in ("NOUN", "PROPN") for token in document.tokens[:verb]):
        return list(arguments)
    return [a for a in arguments if len(a.tokens) > 1 or document.tokens[a.tokens.start].lower != "it"]
