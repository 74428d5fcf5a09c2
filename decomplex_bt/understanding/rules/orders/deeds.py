"""Deeds: what is done to a thing that is named ahead of it ("the mats need *beating* and *putting back*", "get the mats
*beaten*")."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.exclusions import CLEANING
from decomplex_bt.understanding.references.phrases import is_deed
from decomplex_bt.understanding.rules.orders.puttings import LAYING, is_the_table

WHERE_TO = frozenset("in into on onto under behind by inside next".split())
_TO_PLACES = frozenset("to into onto up down upstairs downstairs outside inside over across".split())
_LEADING_TO = WHERE_TO | {"with"}
_DONE_TO = {"walk": "following", "feed": "change_state", "leave": "placing"}
"""What a verb tells where a thing needs it: "the dog needs walking", "the cat needs feeding"."""
_GIVING = frozenset("give hand offer show serve bring send".split())
_SAME_FORMS = frozenset("put cut set shut".split())
"""Participles that are the bare verbs, too."""
_FAR = 3
"""At most so far behind a comma stands the verb that it joins: ", and then *dried*" [tokens]."""
_ENDING = frozenset(("placing", "bringing", "taking"))
"""What is done to a thing and may end at a place."""
_FREEING = frozenset("drain shake rinse wash towel".split())
_FINITE = frozenset(("VBZ", "VBP", "MD"))
_OPENING_CLAUSES = frozenset("if when unless until till once before after while but or so because as".split())


def types_of(observed: Observed, thing: range, deeds: Collection[int], tasks: Collection[int]) -> dict[int, str]:
    """The task types of deeds to a thing that are no `tasks` yet, and of those that tell themselves what they are."""
    document = observed.document
    found = {deed: type_of(observed, deed) for deed in deeds if deed not in tasks}
    found |= {deed: "placing" for deed in deeds if _is_put_there(document, deed)}
    found |= {deed: "change_state" for deed in deeds if _is_given_deed(document, deed)}
    found |= {deed: "change_state" for deed in deeds if _is_laid(document, deed, thing)}
    return found | {deed: "bringing" for deed in deeds if _is_taken_there(document, deed)}


def joined(document: Document, verb: int) -> Iterator[int]:
    """The verbs in the same form that an "and" or a comma joins to a deed: "should be dried and *put* away", "needs
    oiling and *hanging* up"; up to the next clause."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[verb].tag not in ("VBG", "VBN", "VBD") and not tokens[verb].lower.endswith("ing"):
        return  # "needs a wipe"
    for i in range(verb + 1, len(document) - 1):
        if sentences[i] != sentences[verb] or tokens[i].tag in _FINITE or tokens[i].lower in _OPENING_CLAUSES:
            return
        behind = next((token.i for token in tokens[i + 1 :] if token.lower not in ("and", "then")), i)
        is_joint = tokens[i].lower in (",", "and") and i < behind <= i + _FAR
        if is_joint and _is_in_form(tokens[verb], tokens[behind]) and not _is_of_noun(document, behind):
            yield behind


def type_of(observed: Observed, verb: int) -> str:
    """The task type of a deed by its form, with its particle: one that is done to a thing, or along with somebody."""
    verbs, document = observed.gazetteer.verbs, observed.document
    particle = observed.gazetteer.particle(document, verb)
    bare = forms(document, verb)
    known = [f"{form} {particle}" for form in bare] + bare
    form = next((form for form in known if form in verbs), None)
    return "change_state" if form is None else _DONE_TO.get(form, verbs[form][0])


def done_to(
    document: Document, arguments: Sequence[FoundArgument], deed: int, kind: str, thing: range
) -> list[FoundArgument]:
    """The arguments with a thing as what a deed is done to, or as who is told or given something ("Ann should be
    *given* her drops"); what stands behind a preposition is where it ends."""
    own = [a for a in arguments if a.owner == deed and a.tokens.start > deed]
    others = [a for a in arguments if a.owner != deed]
    kept = [_at_its_end(document, a) if kind in _ENDING and a.type in ("object", "source") else a for a in own]
    is_given = kind == "bringing" and document.tokens[deed].lemma in _GIVING
    if (is_given or kind == "placing") and (told := _told_behind(document, deed, is_given)) and not kept:
        kept.append(FoundArgument("object" if is_given else "goal", deed, told, CERTAIN))
    is_received = kind == "informing" or (is_given and any(a.type == "object" for a in kept))
    name = "recipient" if is_received else "object"
    if name == "object":
        kept = [a for a in kept if a.type != "object"]
    return [*others, *kept, FoundArgument(name, deed, thing, CERTAIN)]


def without_deed(document: Document, arguments: Sequence[FoundArgument], giving: int) -> list[FoundArgument]:
    """The arguments without a deed that a thing is given, and with that as what it is done to: "give *the shoes* a
    brush"."""
    kept = [a for a in arguments if not is_deed(document, a.tokens)]
    own = {a.type for a in kept if a.owner == giving}
    is_given = document.tokens[giving].lemma == "give" and (len(kept) < len(arguments) or _is_of_deed(document, giving))
    if not is_given or "object" in own:
        return kept
    return [replace(a, type="object") if (a.owner, a.type) == (giving, "recipient") else a for a in kept]


def without_particle(observed: Observed, arguments: Sequence[FoundArgument], verb: int) -> list[FoundArgument]:
    """The arguments without an "off" as the state of what is cleaned or freed of something, unless it makes a verb of
    its own: "wipe the table *off*"."""
    document = observed.document
    lemma = document.tokens[verb].lemma
    if lemma not in CLEANING | _FREEING or f"{lemma} off" in observed.gazetteer.verbs:
        return list(arguments)
    return [
        a
        for a in arguments
        if (a.owner, a.type) != (verb, "state") or [document.tokens[i].lower for i in a.tokens] != ["off"]
    ]


def _is_of_deed(document: Document, giving: int) -> bool:
    """Whether a deed ends the phrase behind a "give"."""
    ends = range(giving + 2, min(giving + 8, len(document) - 1))
    return any(is_deed(document, range(i, i + n)) for i in ends for n in (2, 3) if i + n <= len(document))


def _at_its_end(document: Document, argument: FoundArgument) -> FoundArgument:
    """What is taken for a thing behind a preposition, or for where it is now, as the place that is told with that:
    "put in *the wash*"."""
    start = argument.tokens.start - (argument.type == "object")
    if document.tokens[start].lower not in WHERE_TO | _TO_PLACES:
        return argument
    return replace(argument, type="goal", tokens=range(start, argument.tokens.stop))


def _told_behind(document: Document, verb: int, is_given: bool) -> range:
    """What stands right behind a deed: what somebody is to be given, or with its preposition where something is to be
    left ("with the porter"); empty where nothing does."""
    start = verb + 1 if is_given else verb + 2
    is_led = is_given or not _LEADING_TO.isdisjoint(token.lower for token in document.tokens[start - 1 : start])
    stop = next((chunk.stop for chunk in noun_chunks(document) if chunk.start == start), 0)
    return range(verb + 1, stop) if is_led and stop else range(0)


def _is_of_noun(document: Document, at: int) -> bool:
    """Whether a word only tells something of a noun behind it: "cleaning *rags*"."""
    behind = document.tokens[at + 1 : at + 2]
    return bool(behind) and behind[0].pos in ("NOUN", "PROPN", "ADJ")


def _is_in_form(deed: Token, verb: Token) -> bool:
    """Whether a verb is a gerund, or a participle, as the deed is that it is joined to."""
    if deed.lower.endswith("ing"):
        return verb.lower.endswith("ing") and verb.tag in ("VBG", "NN")
    return verb.tag in ("VBN", "VBD") or verb.lower in _SAME_FORMS


def forms(document: Document, verb: int) -> list[str]:
    """What a deed may be a form of."""
    token = document.tokens[verb]
    return list(dict.fromkeys((*lemmas(token.lower), token.lemma)))


def _is_put_there(document: Document, verb: int) -> bool:
    """Whether what is "put" or "left" is so right behind with a place: "putting *on the rack*"."""
    behind = document.tokens[verb + 1 : verb + 3]
    is_place = len(behind) > 1 and behind[0].lower in WHERE_TO and behind[1].tag in ("DT", "PRP$")
    return document.tokens[verb].lower in ("put", "putting", "left", "leaving") and is_place


def _is_taken_there(document: Document, verb: int) -> bool:
    """Whether what is "taken" or needs "taking" is so to a place: "taken *to the shed*"."""
    behind = document.tokens[verb + 1].lower if verb + 1 < len(document) else ""
    return document.tokens[verb].lower in ("taken", "taking") and behind in _TO_PLACES


def _is_laid(document: Document, verb: int, thing: range) -> bool:
    """Whether a table is "laid", which is put nowhere."""
    is_laying = not LAYING.isdisjoint(forms(document, verb))
    return is_laying and is_the_table(document.tokens[thing.start : thing.stop])


def _is_given_deed(document: Document, verb: int) -> bool:
    """Whether what a thing is "given" is a deed: "given *a wipe*"."""
    return document.tokens[verb].lemma == "give" and is_deed(document, range(verb + 1, min(verb + 3, len(document))))
