"""Gapping: what a verb does to another thing elsewhere, without being said again ("the pan in the oven *and the lid on
the stove*", "give Anna the camera *and Tom the ball*", "turn the lamp on *and the radio off*", "put the pan away *and
the lid on the hook*").

As the guideline has it, the verb is one task, with its arguments in turn; acting on it takes them pair by pair
(`planning/distribution.py`).
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import ENDS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.vocabulary import ONES, PERSON_NOUNS, PREPOSITIONS

_ACTING = frozenset(("placing", "bringing", "taking", "change_state"))
_PAIRED = ("goal", "recipient", "source", "location", "state")
"""What is told beside the thing, anew for each one."""
_JOINTS = frozenset(("and", "n", "&", ","))
_PLACED = frozenset(("goal", "recipient", "source", "location"))
_TELLING_APART = frozenset("whichever which preferably ideally".split())
_INDEFINITE = frozenset(("a", "an", "some", "another"))
_NOMINAL = frozenset("DT PRP$ CD JJ JJR JJS NN NNS NNP VBN VBG".split())
_TO_WHOM = frozenset(("for", "to"))
_DETERMINERS = frozenset(
    "the a an my your our their his her its some another that this these those any one two".split()
)
_PERSONS = frozenset("me us him her them you".split())
_NOUNS = frozenset(("NOUN", "PROPN", "PRON", "NUM"))
_PARTS = frozenset(("DET", "ADJ", "NOUN", "PROPN", "PRON", "NUM", "ADP", "PART", "ADV"))
_LAST = frozenset(("too", "also", "please", "instead"))
_AWAY = frozenset("away out back in up down".split())
"""What tells where a thing goes without naming a place."""
_GOING_TO = frozenset("in into on onto under behind by beside to".split())


@dataclass(frozen=True, slots=True)
class Gapped:
    """A phrase without its verb: the thing and what is told of it, an argument of `type`, or empty where a particle
    tells it. `owner`: the verb's token."""

    owner: int
    thing: range
    told: range
    type: str

    @property
    def tokens(self) -> range:
        return range(min(self.thing.start, self.told.start), max(self.thing.stop, self.told.stop))

    @property
    def arguments(self) -> tuple[FoundArgument, ...]:
        thing = FoundArgument("object", self.owner, self.thing, CERTAIN)
        return (thing, FoundArgument(self.type, self.owner, self.told, CERTAIN)) if self.type else (thing,)


def with_gapped(
    observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with those of gapped phrases, of whose words no other has any."""
    document, kept = observed.document, list(arguments)
    for other in gapped(observed, tasks, kept):
        begin, end = other.tokens.start, other.tokens.stop
        before = [_until(document, a, begin) for a in kept if a.tokens.start < begin]
        before = [a for a in before if document.tokens[a.tokens.start].lower not in _JOINTS]
        kept = [*before, *other.arguments, *(a for a in kept if a.tokens.start >= end)]
    return kept


def with_added(observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with the things that an "and" adds at the end of a clause, behind what is told of the first one
    ("the pills from the drawer *and a glass of water*"): no further places, and no other argument's words."""
    kept = list(arguments)
    for owner, kind in sorted(tasks.items()):
        said = {i for a in kept if a.owner == owner and a.type == "object" for i in a.tokens}
        phrases = list(_phrases(observed, tasks, owner, said)) if kind in _ACTING else []
        has_aside = len(phrases) == 2 and _is_aside(observed.document, phrases[0][0])
        if not phrases or len(phrases) != 1 + has_aside or not phrases[-1][1]:
            continue
        phrase = phrases[-1][0]
        own = sorted((a for a in kept if a.owner == owner and owner < a.tokens.start), key=lambda a: a.tokens.start)
        before = [_until(observed.document, a, phrase.start) for a in own if a.tokens.start < phrase.start]
        is_told = len(before) > 1 and before[-1].type in _PLACED and "object" in (a.type for a in before[:-1])
        is_told |= has_aside and "object" in (a.type for a in before)
        behind = [a for a in kept if a.tokens.stop > phrase.start and a.tokens.start < phrase.stop]
        behind = [a for a in behind if a not in own[: len(before)]]
        is_vague = observed.document.tokens[phrase.start].lower in _INDEFINITE
        is_free = all((a.owner, a.tokens.start) == (owner, phrase.start) for a in behind)
        is_free = is_free and all(a.type == "object" or is_vague for a in behind)
        if is_told and is_free and _is_thing(observed, phrase, kind):
            before = [replace(a, confidence=CERTAIN) if a.type == "object" else a for a in before]
            kept = [a for a in kept if a not in (*own, *behind)] + [
                *before,
                FoundArgument("object", owner, phrase, CERTAIN),
            ]
    return kept


def _is_aside(document: Document, phrase: range) -> bool:
    """Whether a phrase between commas tells of the thing ahead of it which one it is: "the cup, *the small one*, and
    ...", "a pen, *whichever is closest*, and ..."."""
    words = document.tokens[phrase.start : phrase.stop]
    return words[0].lower in _TELLING_APART or words[-1].lower in ONES


def _is_thing(observed: Observed, phrase: range, task_type: str) -> bool:
    """Whether a phrase behind an "and" is a noun with no more than words before it, and no further place: an indefinite
    one, one that is known to be a thing, or to change its state where that is asked, or one that a comma parts off."""
    words = observed.document.tokens[phrase.start : phrase.stop]
    cut = next((k for k, word in enumerate(words) if word.lower == "of"), len(words))
    named = words[:cut]
    if not named or named[-1].tag not in ("NN", "NNS") or named[-1].lemma in PERSON_NOUNS:
        return False
    if any(word.tag not in _NOMINAL for word in (*named, *words[cut + 1 :])) or any(w.pos == "DET" for w in named[1:]):
        return False
    category = observed.gazetteer.category(named[-1].lemma)
    may_change = task_type == "change_state" and bool(observed.gazetteer.changeable.get(named[-1].lemma))
    is_parted = observed.document.tokens[phrase.start - 2].text == ","
    is_vague = words[0].lower in _INDEFINITE or words[0].tag == "CD"
    return (
        is_vague
        or may_change
        or category == "thing"
        or (is_parted and category == "" and words[0].lower in _DETERMINERS)
    )


def gapped(observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> Iterator[Gapped]:
    """The gapped phrases of a document, in text order. They follow, behind an "and" or in a list that ends with one,
    what the verb does first, and tell the same two things in the same way; `arguments`: as the models have them."""
    document = observed.document
    for owner, kind in sorted(tasks.items()):
        if kind not in _ACTING:
            continue
        phrases = list(_phrases(observed, tasks, owner))
        while phrases and not phrases[-1][1]:
            phrases.pop()  # a list ends with "and"
        if not phrases:
            continue
        begin = phrases[0][0].start
        own = (a for a in arguments if a.owner == owner and owner < a.tokens.start < begin)
        first = [_until(document, a, begin) for a in own]
        found: list[Gapped] = []
        is_away = kind != "change_state" and document.tokens[begin - 2].lower in _AWAY
        for phrase, _ in phrases:
            one = _led_away(document, owner, phrase, first, is_away=is_away) if kind != "change_state" else None
            one = one or _read(observed, owner, phrase, first)
            if one is None:
                break
            found.append(one)
        if len(found) == len(phrases):
            yield from found


def _until(document: Document, argument: FoundArgument, stop: int) -> FoundArgument:
    """An argument as far as it stands before a token, without an "and" or comma at its end."""
    last = min(argument.tokens.stop, stop)
    while last > argument.tokens.start + 1 and document.tokens[last - 1].lower in _JOINTS:
        last -= 1
    return replace(argument, tokens=range(argument.tokens.start, last))


def _phrases(
    observed: Observed, tasks: Mapping[int, str], owner: int, said: Container[int] = ()
) -> Iterator[tuple[range, bool]]:
    """The phrases behind the first "and" or comma after a verb up to where its clause ends, and whether an "and" leads
    each; an "or" ends it but among the tokens `said`."""
    tokens = observed.document.tokens
    opening = {cue.first for cue in observed.cues if cue.name in _OPENING}
    stop = owner + 1
    while stop < len(tokens) and tokens[stop].text not in ENDS and stop not in opening:
        if stop in tasks or tokens[stop].lower in ("then", "but", ":"):
            break
        if tokens[stop].lower == "or" and stop not in said:
            break
        stop += 1
    is_cut = stop < len(tokens) and stop in tasks
    first, is_led, begun = owner + 1, False, False
    for i in range(owner + 1, stop + 1):
        is_last = i == stop
        if not is_last and tokens[i].lower not in _JOINTS:
            continue
        phrase = _trimmed(observed.document, range(first, i))
        if begun and phrase and not (is_last and is_cut):
            yield phrase, is_led
        if not is_last:
            is_led = tokens[i].lower != "," or (is_led and first == i)
            begun, first = True, i + 1


def _trimmed(document: Document, phrase: range) -> range:
    stop = phrase.stop
    while stop > phrase.start and document.tokens[stop - 1].lower in _LAST:
        stop -= 1
    return range(phrase.start, stop)


def _read(observed: Observed, owner: int, phrase: range, first: Sequence[FoundArgument]) -> Gapped | None:
    """A phrase that tells of a thing what the first arguments tell of theirs, in the same way; else None."""
    document = observed.document
    words = document.tokens[phrase.start : phrase.stop]
    if len(words) < 2 or not all(_is_part(document, word, phrase.start) for word in words):
        return None
    told = [argument for argument in first if argument.type in _PAIRED]
    if not any(argument.type == "object" for argument in first) or not told:
        return None
    state = next((argument for argument in told if argument.type == "state"), None)
    if state is not None and len(state.tokens) == 1 and words[-1].lower in observed.gazetteer.pairs:
        return Gapped(owner, range(phrase.start, phrase.stop - 1), range(phrase.stop - 1, phrase.stop), "state")
    cut = next((w.i for w in words[1:] if w.lower in PREPOSITIONS or w.lower in _TO_WHOM), None)
    if cut is not None and cut + 1 < phrase.stop and document.tokens[cut - 1].pos in _NOUNS | {"DET", "ADJ"}:
        for argument in told:
            lead = document.tokens[argument.tokens.start].lower
            is_same = lead == words[cut - phrase.start].lower or (argument.type == "goal" and lead in PREPOSITIONS)
            is_person = argument.type == "recipient" and words[cut - phrase.start].lower in _TO_WHOM
            if is_same or is_person:
                return Gapped(owner, range(phrase.start, cut), range(cut, phrase.stop), argument.type)
        return None
    recipient = next((argument for argument in told if argument.type == "recipient"), None)
    thing = next(argument for argument in first if argument.type == "object")
    if recipient is None or recipient.tokens.start > thing.tokens.start:
        return None
    cut = next((w.i for w in words[1:] if w.lower in _DETERMINERS), None)
    if cut is None:
        return None
    whom = document.tokens[cut - 1]
    if whom.lower in _PERSONS or whom.pos == "PROPN" or whom.lemma in PERSON_NOUNS:
        return Gapped(owner, range(cut, phrase.stop), range(phrase.start, cut), "recipient")
    return None


def _led_away(
    document: Document, owner: int, phrase: range, first: Sequence[FoundArgument], *, is_away: bool
) -> Gapped | None:
    """A phrase that tells where a thing goes where a particle tells it of either: "the lid on the hook" behind "put the
    pan away", "*the lid away*" behind that or "put the pan on the hook"; else None."""
    tokens = document.tokens
    is_told = is_away or any(argument.type == "goal" for argument in first)
    cut = next((i for i in phrase if tokens[i].lower in _AWAY | _GOING_TO), phrase.stop)
    is_thing = cut > phrase.start + 1 and tokens[phrase.start].lower in _DETERMINERS and tokens[cut - 1].pos in _NOUNS
    is_thing = is_thing and all(_is_part(document, tokens[i], phrase.start) for i in phrase)
    if not is_told or not is_thing or not any(argument.type == "object" for argument in first):
        return None
    if cut + 1 == phrase.stop and tokens[cut].lower in _AWAY:
        return Gapped(owner, range(phrase.start, cut), range(cut, phrase.stop), "")
    if not is_away or cut + 1 >= phrase.stop or tokens[cut].lower not in _GOING_TO:
        return None
    last = tokens[phrase.stop - 1]
    is_whom = tokens[cut].lower in _TO_WHOM and (last.pos == "PROPN" or last.lemma in PERSON_NOUNS)
    told = "recipient" if is_whom else "goal"
    return Gapped(owner, range(phrase.start, cut), range(cut, phrase.stop), told)


def _is_part(document: Document, word: Token, start: int) -> bool:
    """Whether a word is part of a phrase; nouns are taken for verbs there, "Anna her *keys*"."""
    is_named = word.i > start and document.tokens[word.i - 1].pos in ("DET", "ADJ", "PRON", "NOUN")
    return word.pos in _PARTS or (word.pos == "VERB" and is_named)


_OPENING = frozenset(("if", "only_if", "unless", "when", "else", "fail", "before", "after", "until", "while", "so"))
