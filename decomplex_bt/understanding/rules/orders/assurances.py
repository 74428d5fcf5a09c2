"""Assurances: what somebody is to make sure of, which is brought about ("make sure the gate is locked"), or its
opposite where it is denied ("make sure the oven is not on")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.instruction import Argument, Task
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.states import OPPOSITES
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

_SURE = frozenset(("sure", "certain"))
_BE = frozenset(("be", "been", "'s", "is", "are", "'re", "re", "s"))
_MANNERS = frozenset("all both also actually still always really properly firmly securely definitely fully".split())
_DENYING = frozenset("not n't nt never longer".split())
_PASSED_OVER = _MANNERS | _DENYING | {"no", "left", "ever"}
"""What may stand between an "is" and the state: "is *no longer* on", "is*n't left* open"."""
_OF_NONE = frozenset(("none", "neither"))
_PREDICATES = frozenset(("JJ", "VBN", "VBD", "RP"))
_SHORT_STATES = frozenset("shut open closed locked unlocked unplugged running".split())
_PREPOSITIONS = frozenset(("on", "off"))
_NOMINAL = ("DT", "NN", "PRP", "CD", "JJ", "WP")
_NOT_BROUGHT_ABOUT = frozenset(
    "asleep awake alive ok okay okey fine well safe happy comfortable gone there here home in out back ready".split()
)
_TAKEN_UP = frozenset(("if", "unless", "otherwise", "else"))
_PERSONS = frozenset("i you we he she somebody someone anybody anyone nobody everybody everyone".split())
_NAMING = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN"))
_DETERMINERS = frozenset(("DT", "PRP$", "CD"))
_LONGEST_NAME = 6
"""The most words that name a thing in a list of what is made sure of."""
_ANTONYMS = {
    **OPPOSITES,
    "open": "closed",
    "cold": "hot",
    "full": "empty",
    "dry": "wet",
    "running": "off",
    "lit": "off",
}
"""What holds of a thing instead of a state, of several opposites the plainest."""


@dataclass(frozen=True, slots=True)
class Assured:
    """One of several things that somebody makes sure of, each an order of its own: the token that carries it (the verb
    for the first, else its "is"), the thing, its "is" and the state."""

    carrier: int
    thing: range
    be: int
    state: range


def assured_lists(document: Document) -> Iterator[tuple[Assured, ...]]:
    """Of every "make sure *the gate's shut, the shed's locked and the hose is off*" all that is in the list."""
    if document.words.isdisjoint(_SURE | {"ensure", "see"}):
        return
    for token in document.tokens:
        if (be := _being(document, token.i)) is None or not is_assured(document, token.i):
            continue
        start = _start(document, token.i, be)
        found = [one] if (one := _assured(document, token.i, start)) is not None else []
        is_ended = False
        while found and (following := _behind_joint(document, found[-1].state.stop)):
            is_ended = is_ended or any(
                word.lower == "and" for word in document.tokens[found[-1].state.stop : following]
            )
            further = _assured(document, None, following)
            if further is None:
                break
            found.append(further)
        said = {" ".join(word.lower for word in document.tokens[one.state.start : one.state.stop]) for one in found}
        if len(found) > 1 and (is_ended or len(said) == 1):
            yield tuple(found)


def _start(document: Document, verb: int, be: int) -> int:
    """Where begins what a verb makes sure of: behind "sure", "to it" and "that"."""
    before = [t.i for t in document.tokens[verb:be] if t.lower in _SURE | {"ensure", "it", "that"} and t.i < verb + 4]
    return before[-1] + 1


def _behind_joint(document: Document, at: int) -> int:
    """What follows a comma or an "and" at a token, or both; 0 where neither stands there."""
    stop = at
    while stop < len(document) and document.tokens[stop].lower in (",", "and"):
        stop += 1
    return stop if at < stop < len(document) else 0


def _assured(document: Document, carrier: int | None, start: int) -> Assured | None:
    """A thing that is named at a token and its state, with nothing behind in their clause; or None. Somebody's state is
    not brought about."""
    tokens = document.tokens
    be = next((token.i for token in tokens[start : start + _LONGEST_NAME + 1] if token.lower in _BE), start)
    name = tokens[start:be]
    is_named = bool(name) and all(
        token.pos in _NAMING or token.tag == "PRP$" or (token.i > start and tokens[token.i - 1].tag in _DETERMINERS)
        for token in name
    )
    if not is_named or name[-1].lemma in PERSON_NOUNS | ANIMALS:
        return None
    told = _predicate(document, be)
    stop = next((token.i for token in tokens[be:] if token.lower in MARKS or token.lower == "and"), len(tokens))
    words = [token for token in told if token.i < stop]
    if not 0 < len(words) < 3 or words[-1].i != stop - 1 or not _is_state(words):
        return None
    return Assured(be if carrier is None else carrier, range(start, be), be, range(words[0].i, stop))


def with_assured(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with each thing in a list of what somebody makes sure of, and its state, as those of its order."""
    kept = list(arguments)
    for one in (one for listed in assured_lists(document) for one in listed if one.carrier in tasks):
        words = {*range(one.thing.start, one.state.stop)}
        kept = [a for a in kept if words.isdisjoint(a.tokens)]
        kept.append(FoundArgument("object", one.carrier, one.thing, CERTAIN))
        kept.append(FoundArgument("state", one.carrier, one.state, CERTAIN))
    return kept


def is_assured(document: Document, at: int) -> bool:
    """ "Make sure the door is locked", "ensure it's off": who says so wants it locked, unless a later "if" asks how it
    was. Only of what can be brought about: not of where somebody is, or that they are well."""
    said = document.tokens[at:]
    be = _being(document, at)
    if be is None:
        return False
    predicate = _predicate(document, be)
    if any(token.lower in ("there", "nobody", "nothing") for token in document.tokens[at:be]):
        return False
    if not _is_state(predicate[:2]):
        return False
    last = document.sentences[at] + 1
    later = (token for token in said if token.i > be and document.sentences[token.i] <= last)
    return not any(token.lower in _TAKEN_UP and not _names(document, token.i + 1) for token in later)


def is_assured_too(document: Document, check: int, before: int) -> bool:
    """ "Make sure the window is shut and the heating is off": the second state, that of the check, is brought about
    like the first, of the task `before`."""
    tokens = document.tokens
    if any(one.be == check for listed in assured_lists(document) for one in listed):
        return True
    if tokens[check].lower not in _BE or document.sentences[before] != document.sentences[check]:
        return False
    between = {token.lower for token in tokens[before:check]}
    is_joined = "and" in between and _TAKEN_UP.isdisjoint(between) and between.isdisjoint(("whether", "when", "there"))
    return is_joined and is_assured(document, before) and _is_state(_predicate(document, check)[:2])


def with_denied(document: Document, tasks: Sequence[Task], kinds: Kinds) -> tuple[Task, ...]:
    """The tasks, with the opposite of a state that somebody makes sure does not hold: "is not on" is "off", and of what
    has no opposite "not sticky"; "none of the windows" that shall be open are all of them to be closed."""
    found: list[Task] = []
    for task in tasks:
        at = document.indices(task.span).start
        before = document.indices(found[-1].span).start if found else None
        be: int | None = None
        if task.type == "change_state" and is_assured(document, at):
            be = _being(document, at)
        elif task.type == "change_state" and before is not None and is_assured_too(document, at, before):
            be = at
        found.append(task if be is None else _denied(document, task, be, kinds))
    return tuple(found)


def _denied(document: Document, task: Task, be: int, kinds: Kinds) -> Task:
    told = _predicate(document, be)[0].i
    is_denied = any(token.lower in _DENYING for token in document.tokens[be + 1 : told])
    arguments = tuple(_of_all(document, a) if a.type == "object" else a for a in task.arguments)
    if not any(a.type == "state" for a in arguments):
        span = document.span(told, told)
        arguments = (*arguments, Argument("state", span.of(document.text), span, task.confidence))
    if is_denied != any(a.value != b.value for a, b in zip(arguments, task.arguments, strict=False)):
        other = _opposite(document.tokens[told].lower, kinds)
        arguments = tuple(replace(a, value=other) if a.type == "state" else a for a in arguments)
    return replace(task, arguments=arguments)


def _of_all(document: Document, argument: Argument) -> Argument:
    """The object, all of which is meant where none is said: "none of the windows", "neither of the lamps", behind a
    "no" as in "make sure no light is on"."""
    first, _, rest = argument.value.partition(" ")
    if first.lower() in _OF_NONE and rest:
        return replace(argument, value=f"{'both' if first.lower() == 'neither' else 'all'} {rest}")
    start = 0 if argument.span is None else document.indices(argument.span).start
    if first.lower() == "no" and rest:
        return replace(argument, value=f"every {rest}")
    return replace(argument, value=f"every {argument.value}") if _is_no(document, start - 1) else argument


def _is_no(document: Document, at: int) -> bool:
    return at >= 0 and document.tokens[at].lower == "no"


def _opposite(state: str, kinds: Kinds) -> str:
    """What holds where a state does not, in the domain's words if it has any."""
    for pair in kinds.state_pairs.values():
        for value in pair.values:
            if state in (value, *pair.words.get(value, ())):
                antonym = _ANTONYMS.get(state)
                other = kinds.opposite(value)
                return antonym if antonym in (other, *pair.words.get(other, ())) else other
    return _ANTONYMS.get(state, f"not {state}")


def _being(document: Document, at: int) -> int | None:
    """The "is" of what a verb makes sure of; None for any other verb."""
    said = document.tokens[at:]
    words = [token.lower for token in said[1:3]]
    if said[0].lemma == "ensure":
        start = 1
    elif said[0].lemma in ("make", "be") and words[:1] and words[0] in _SURE:
        start = 2
    elif said[0].lemma == "see" and words[:2] == ["to", "it"]:
        start = 3
    else:
        return None
    be = next((token for token in said[start:] if token.lower in _BE or token.lower in ENDS), None)
    return None if be is None or be.lower in ENDS else be.i


def _predicate(document: Document, be: int) -> list[Token]:
    """The words behind an "is" from the state on."""
    return [token for token in document.tokens[be + 1 :] if token.lower not in _PASSED_OVER]


def _names(document: Document, at: int) -> bool:
    """Whether a condition names something of its own ("if the light is on", "if she's tired") where it might take up
    what was said."""
    if at >= len(document):
        return False
    first = document.tokens[at]
    return first.lower in _PERSONS or first.tag in ("DT", "PRP$", "NN", "NNS", "NNP", "JJ")


def _is_state(predicate: Sequence[Token]) -> bool:
    """Whether what stands behind an "is" begins with a state to be brought about: "off", but not "off the hook"."""
    if not predicate or predicate[0].lower in _NOT_BROUGHT_ABOUT:
        return False
    state, *rest = predicate
    if state.lower in _PREPOSITIONS:
        return not rest or not rest[0].tag.startswith(_NOMINAL)
    return state.tag in _PREDICATES or state.lower in _SHORT_STATES
