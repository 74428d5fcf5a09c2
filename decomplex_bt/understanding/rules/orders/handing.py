"""Handing: what is given or fetched, to whom, and what goes along with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.phrases import is_pronoun
from decomplex_bt.understanding.rules.spans.goals import CLAUSE_ENDS
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS, TIME_UNITS

_HANDING = frozenset("give feed hand serve offer pass".split())
_CARRYING = _HANDING | {"bring", "get", "fetch", "take"}
_HANDLING = frozenset(("bringing", "taking", "placing"))
_ALONG = frozenset(("along", "together"))
_OWNING = frozenset("baby child kid dad mum mom".split())
"""Persons by whom things are called: "bring the baby bottle"."""
_REGARDS = frozenset("compliment regard thanks thank love wish care hand finger apology smile".split())
"""What comes with a thing without being one."""
_CARRIERS = frozenset("tray trolley cart basket bag wheelbarrow tongs glove lift elevator friend".split())
"""What a thing is carried with."""
_WHOM = {"get": "object", "fetch": "object"} | dict.fromkeys(("bring", "give", "hand", "pass"), "recipient")
"""What somebody is to these verbs where nothing else is named."""
_SERVING = (_CARRYING - {"take"}) | {"carry"}
_INDEFINITE = frozenset("a an some another".split())
_PRONOUNS = frozenset(("it", "them", "this", "that"))
_ONES = frozenset(("one", "ones", "some", "another"))
_MONEY = frozenset("bill fee fare rent money cash fine tip deposit toll charge price amount invoice it".split())


def called(document: Document, arguments: Sequence[FoundArgument], fetching: int) -> list[FoundArgument]:
    """The arguments with who is fetched as the object where the order names nothing else: "if she cries, get *me*"; of
    what is brought or given to whom, nothing is said then: "bring *me*"."""
    whom, end = range(fetching + 1, fetching + 2), fetching + 2
    is_end = end == len(document) or (end < len(document) and document.tokens[end].text in MARKS)
    own = {a.type for a in arguments if a.owner == fetching and a.tokens != whom}
    kind = _WHOM.get(document.tokens[fetching].lemma)
    if kind is None or not is_end or own & {"object", kind}:
        return list(arguments)
    if kind == "recipient" and document.tokens[whom[0]].lower not in ("me", "us"):
        return list(arguments)
    return [replace(a, type=kind) if (a.owner, a.tokens) == (fetching, whom) else a for a in arguments]


def fed(document: Document, arguments: Sequence[FoundArgument], feeding: int) -> list[FoundArgument]:
    """The arguments with who is fed as what that is done to, where nothing is said of the food: "feed *the dog*"."""
    own = {a.type for a in arguments if a.owner == feeding}
    if document.tokens[feeding].lemma != "feed" or "object" in own:
        return list(arguments)
    return [replace(a, type="object") if (a.owner, a.type) == (feeding, "recipient") else a for a in arguments]


def payee(document: Document, paying: int) -> range:
    """Who is paid, where no more is said: "pay *the baker*", not "pay the bill"; empty for any other verb."""
    if document.tokens[paying].lemma != "pay":
        return range(0)
    whom = next((chunk for chunk in noun_chunks(document) if chunk.start == paying + 1), range(0))
    behind = document.tokens[whom.stop : whom.stop + 1]
    is_all = not behind or behind[0].text in MARKS or behind[0].lower in CLAUSE_ENDS
    is_somebody = bool(whom) and document.tokens[whom[0]].pos in ("DET", "PRON", "PROPN")
    return whom if is_all and is_somebody and document.tokens[whom[-1]].lemma not in _MONEY else range(0)


def paid(document: Document, arguments: Sequence[FoundArgument], paying: int) -> list[FoundArgument]:
    """The arguments with who is paid as who gets something."""
    whom = payee(document, paying)
    if not whom:
        return list(arguments)
    kept = [a for a in arguments if set(whom).isdisjoint(a.tokens) and (a.owner, a.type) != (paying, "object")]
    return [*kept, FoundArgument("recipient", paying, whom, CERTAIN)]


def served(document: Document, arguments: Sequence[FoundArgument], bringing: int) -> list[FoundArgument]:
    """The arguments with what is brought along as part of the thing right behind which it stands ("bring me *my coffee
    with two biscuits*"), else as another object ("bring it here *with two biscuits*"); not how or in what it is brought
    ("with care", "with my regards", "with a trolley")."""
    stops = {phrase.start: phrase.stop for phrase in noun_chunks(document)}
    led = next(
        (i for i in range(bringing + 2, _clause_end(document, bringing)) if document.tokens[i].lower == "with"), 0
    )
    along = range(led, _with_behind(document, led, stops)) if led else range(0)
    if not along or not _is_free(arguments, along, bringing):
        return list(arguments)
    own = [a for a in arguments if (a.owner, a.type) == (bringing, "object") and a.tokens.start in range(bringing, led)]
    rest = [a for a in arguments if a in own or set(along).isdisjoint(a.tokens)]
    last = next((a for a in own if a.tokens.stop >= led), None)
    if last is not None and not is_pronoun(document, last.tokens) and last.tokens.start + 1 != led:
        whole = replace(last, tokens=range(last.tokens.start, max(along.stop, last.tokens.stop)))
        return [whole if a is last else a for a in rest]
    thing = range(bringing + 1, bringing + 2)
    is_served = document.tokens[bringing].lemma in _SERVING and _is_indefinite(document, led + 1)
    is_served &= all(document.tokens[a.tokens.start].lower not in _ONES for a in own)  # "bring me one with two sugars"
    if not is_served or (not own and document.tokens[thing.start].lower not in _PRONOUNS):
        return list(arguments)
    rest = [_cut(a, led) if a in own else a for a in rest]
    told = [thing] if not own else []
    return rest + [FoundArgument("object", bringing, words, CERTAIN) for words in (*told, along)]


def _cut(argument: FoundArgument, stop: int) -> FoundArgument:
    """An argument that is certain, up to a token."""
    return replace(argument, tokens=range(argument.tokens.start, min(argument.tokens.stop, stop)), confidence=CERTAIN)


def _is_free(arguments: Sequence[FoundArgument], along: range, bringing: int) -> bool:
    """Whether a "with" and a thing are no other task's, nor anything but how or where something is brought."""
    others = [a for a in arguments if not set(along).isdisjoint(a.tokens)]
    return all(
        a.owner == bringing and (a.type in ("manner", "goal", "object") and a.tokens.stop <= along.stop) for a in others
    )


def _is_indefinite(document: Document, at: int) -> bool:
    return document.tokens[at].lower in _INDEFINITE or document.tokens[at].tag in ("CD", "PRP$")


def _clause_end(document: Document, verb: int) -> int:
    ends = (token.i for token in document.tokens[verb + 1 :] if token.lower in CLAUSE_ENDS)
    return next(ends, len(document))


def _with_behind(document: Document, at: int, stops: Mapping[int, int]) -> int:
    """Where a "with" and a thing end that stand at a token; 0 where none do."""
    tokens, stop = document.tokens, stops.get(at + 1, 0)
    is_thing = stop and tokens[at].lower == "with" and tokens[at + 1].tag in ("DT", "CD", "PRP$")
    if not is_thing or tokens[stop - 1].lemma in _REGARDS | _CARRIERS:
        return 0
    return stops.get(stop + 1, stop) if [token.lower for token in tokens[stop : stop + 1]] == ["of"] else stop


def divided(document: Document, arguments: Sequence[FoundArgument], bringing: int) -> list[FoundArgument]:
    """The arguments, with what stands right behind a verb of giving as who gets it, then what: "give the dog water",
    "bring the guests towels"; where nothing else says who gets it."""
    own = {a.type: a for a in arguments if a.owner == bringing}
    both = own.get("object")
    if both is None or both.tokens.start != bringing + 1 or {"recipient", "goal"} & own.keys():
        return list(arguments)
    nouns = [document.tokens[j] for j in both.tokens if document.tokens[j].pos in ("NOUN", "PROPN")]
    if len(nouns) < 2 or nouns[-1].i != both.tokens.stop - 1 or nouns[0].i + len(nouns) != both.tokens.stop:
        return list(arguments)
    whom, verb = nouns[-2], document.tokens[bringing].lemma
    is_name = nouns[0].i == both.tokens.start and all(noun.tag == "NNP" for noun in nouns[:-1])
    is_living = is_name or whom.lemma in PERSON_NOUNS | ANIMALS
    is_whom = (verb in _HANDING and is_living) or is_name or whom.tag == "NNS" or whom.lemma in PERSON_NOUNS - _OWNING
    if (len(nouns) > 2 and not is_name) or verb not in _CARRYING or not is_whom:
        return list(arguments)
    others = [a for a in arguments if a is not both]
    recipient = replace(both, type="recipient", tokens=range(both.tokens.start, nouns[-1].i))
    return [*others, recipient, replace(both, tokens=range(nouns[-1].i, both.tokens.stop))]


def with_gift(document: Document, arguments: Sequence[FoundArgument], giving: int) -> list[FoundArgument]:
    """The arguments with what stands right behind who gets it as the object, where the order has none: "give it *a
    drink*", "hand Ann *the keys*"; not how long something goes on ("give it five minutes")."""
    own = {a.type: a for a in arguments if a.owner == giving}
    whom = own.get("recipient")
    if "object" in own or whom is None or whom.tokens.start != giving + 1:
        return list(arguments)
    gift = next((chunk for chunk in noun_chunks(document) if chunk.start == whom.tokens.stop), range(0))
    is_free = bool(gift) and not any(set(gift) & set(a.tokens) for a in arguments)
    is_thing = is_free and document.tokens[gift[-1]].lemma not in _REGARDS | TIME_UNITS
    is_giving = document.tokens[giving].lemma in _HANDING
    return [*arguments, FoundArgument("object", giving, gift, CERTAIN)] if is_thing and is_giving else [*arguments]


def accompanied(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments with what is handled along with a thing: part of its words where it stands right behind them
    ("fetch *the drill along with the cable*"), else another object ("carry it out together with *the flowers*")."""
    tokens, kept = document.tokens, list(arguments)
    phrases = {phrase.start: phrase for phrase in noun_chunks(document)}
    for i in range(1, len(tokens) - 2):
        phrase = phrases.get(i + 2)
        if tokens[i].lower not in _ALONG or tokens[i + 1].lower != "with" or phrase is None:
            continue
        verb = max((token for token in tasks if token < i), default=None)
        if verb is None or tasks[verb] not in _HANDLING or not _is_of_clause(document, verb, i):
            continue
        if any(not set(a.tokens).isdisjoint(phrase) for a in kept if a.owner != verb or a.tokens.start < i):
            continue
        things = [a for a in kept if (a.owner, a.type) == (verb, "object") and a.tokens.start < i]
        if not things:
            continue
        known = (a.tokens.stop for a in kept if a.type == "object" and a.tokens.start in (i + 1, phrase.start))
        phrase = range(phrase.start, max(phrase.stop, *known, 0))
        kept = [a for a in kept if set(a.tokens).isdisjoint(range(i, phrase.stop))]
        last = things[-1]
        if last.tokens.stop == i and not is_pronoun(document, last.tokens):
            kept = [replace(a, tokens=range(a.tokens.start, phrase.stop)) if a is last else a for a in kept]
        else:
            kept.append(FoundArgument("object", verb, phrase, CERTAIN))
    return kept


def _is_of_clause(document: Document, verb: int, at: int) -> bool:
    """Whether a word stands in the clause of a verb before it."""
    return not any(token.lower in MARKS - {"-"} for token in document.tokens[verb : at - 1])


def given(arguments: Sequence[FoundArgument], bringing: int, whom: range) -> list[FoundArgument]:
    """The arguments with the recipient that a "for Ella" tells, where nobody else gets it."""
    is_taken = any(
        set(a.tokens) & set(whom) or (a.owner == bringing and a.type in ("recipient", "goal")) for a in arguments
    )
    return [*arguments, FoundArgument("recipient", bringing, whom, CERTAIN)] if whom and not is_taken else [*arguments]
