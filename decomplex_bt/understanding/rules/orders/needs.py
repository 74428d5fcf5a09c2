"""Needs: what a thing needs done, what should be done to it, or it is time to do, ordered where nothing behind takes it
up ("the ferns want watering", "the bins should be emptied and rinsed")."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise, takewhile

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.domain.verbs import lemmas
from decomplex_bt.understanding.arguments import FoundArgument
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.exclusions import CLEANING
from decomplex_bt.understanding.rules.background.statements import BELONGING
from decomplex_bt.understanding.rules.ellipses.fragments import STATES, Fragment
from decomplex_bt.understanding.rules.ellipses.likewise import so_does
from decomplex_bt.understanding.rules.orders.deeds import WHERE_TO, done_to, forms, joined, type_of, types_of
from decomplex_bt.understanding.vocabulary import ANIMALS, PERSON_NOUNS

NEEDING = frozenset("need needs want wants needed wanted".split())
_COULD_DO_WITH = ("could", "do", "with")
_PRESENT = frozenset(("VBP", "VBZ", "VB", "NNS"))
_BETWEEN = frozenset("also still really badly now urgently just both all".split())
OPENING = frozenset(
    ", and also oh right now so ok okey okay well um uh er erm hi hello hey robot please then anyway listen "
    "look".split()
)
"""What may stand between the beginning of a sentence and the thing that needs something done, or who wants it."""
_CASES = frozenset("if when unless once whenever".split())
_OBLIGING = frozenset(("should", "must"))
_OBLIGING_TO = frozenset("ought has have is are 's 're".split())
_IN_OBLIGATIONS = frozenset("also all both always first please now then got".split())
_SAYING_SO = NEEDING | {"could", "time", "be"}
_BEFORE_TIME = OPENING | frozenset("it 's is its about high".split())
_NOMINAL = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN"))
_PLACING = frozenset("in on at of from by under behind upstairs downstairs outside".split())
_INSIDE = _PLACING | {"'s"}
_PERSONAL = frozenset("it its they them their he him his she her one ones some that those so".split())
_FARTHEST = 3
"""Within so many words behind a need stands the verb of what is needed [tokens]."""
_OF_CASE = frozenset(("it", "they"))
_VAGUE = frozenset(("do", "see", "be", "have"))
_BUT_IF = frozenset((("but", "if"), ("but", "when")))
_LEAVE_IT = frozenset((("leave", "it"), ("leave", "them"), ("leave", "that")))
_LEADING_ON = frozenset((":", "-", "\u2013", "\u2014"))
_SHOULD = frozenset("should must ought has have".split())
_FOUND_OUT = frozenset(("searching", "check_state"))
"""What is to be *found* or *ready* somewhere is said to be there."""
_SUPPOSING = frozenset("already soon".split())


def needed(observed: Observed, tasks: Mapping[int, str]) -> dict[int, str]:
    """The verbs of what is to be done, with task types, of sentences that begin with a thing and say that it needs it;
    `tasks`: the tokens that are tasks already, with types.

    Not where the words behind take the thing up, since those tell what to do about it ("my shirt needs ironing, so get
    the board and iron it"), nor as a case ("if the ferns want watering"), in a question, a message or of a speaker.
    """
    document = observed.document
    found: dict[int, str] = {}
    if document.words.isdisjoint(_SAYING_SO):
        return found
    for i in range(len(document)):
        if (verb := _due(document, i)) is not None and verb not in tasks:
            found[verb] = type_of(observed, verb)
            continue
        verb = _deed(observed, i)
        if verb is None or not _is_of_thing(document, i) or _is_taken_up(document, _subject(document, i), verb):
            continue
        found |= types_of(observed, _subject(document, i), (verb, *joined(document, verb)), tasks)
    return found


def in_need(observed: Observed, verb: int) -> dict[str, range]:
    """The thing that needs what the verb says, as its `object`, with where it is as `location` if that is told right
    behind it, or what it is time to do it to; empty where no sentence begins by saying so."""
    document = observed.document
    if verb > 1 and _due(document, verb - 2) == verb:
        thing = next((chunk for chunk in noun_chunks(document) if chunk.start == verb + 1), None)
        return {} if thing is None else {"object": thing}
    first = document.sentences.index(document.sentences[verb])
    for i in range(verb - 1, first - 1, -1):
        deed = _deed(observed, i)
        if deed is not None and verb in (deed, *joined(document, deed)) and _is_of_thing(document, i):
            said = _subject(document, i)
            place = next((j for j in said if document.tokens[j].lower in _PLACING), said.stop)
            found = {"object": range(said.start, place), "location": range(place, said.stop)}
            return {name: tokens for name, tokens in found.items() if tokens}
    return {}


def needs_of(observed: Observed, verbs: Iterable[int]) -> frozenset[int]:
    """The words ahead of the verbs that only say that a thing needs it, and are no tasks: "the gate *wants* oiling"."""
    tokens = observed.document.tokens
    of_things = (verb for verb in verbs if in_need(observed, verb))
    return frozenset(i for verb in of_things for i in range(max(0, verb - _FARTHEST), verb) if _is_need(tokens[i]))


def with_needs(observed: Observed, arguments: Sequence[FoundArgument], verb: int, kind: str) -> list[FoundArgument]:
    """The arguments with what needs a deed, or should have it done, as what that is done to, also where that is told
    ahead of another deed ("the mats should be beaten and *put back*")."""
    thing = in_need(observed, verb).get("object", range(0))
    is_ahead = bool(thing) and thing.stop <= verb
    return done_to(observed.document, arguments, verb, kind, thing) if is_ahead else list(arguments)


def states_due(document: Document) -> Iterator[Fragment]:
    """What is to be in a state, beside what is to be done to another thing: "the blinds should be closed and *the
    fan should be on*"."""
    tokens = document.tokens
    if document.words.isdisjoint(_OBLIGING):
        return
    for i, token in enumerate(tokens[:-2]):
        words = [word.lower for word in tokens[i + 1 : i + 3]]
        if token.lower not in _OBLIGING or words[0] != "be" or words[1] not in STATES:
            continue
        behind = tokens[i + 3].lower if i + 3 < len(tokens) else "."
        said = _subject(document, i)
        if behind in MARKS | {"and", "then"} and _is_of_thing(document, i) and not _is_first(document, said):
            yield Fragment(range(said.start, i + 3), i + 2, said, range(0), "change_state")


def _is_first(document: Document, said: range) -> bool:
    """Whether nothing but fillers stands ahead of words in their sentence."""
    first = document.sentences.index(document.sentences[said.start])
    return all(token.lower in OPENING for token in document.tokens[first : said.start])


def belonging(document: Document) -> Iterator[Fragment]:
    """What is said to belong, or that it should go, somewhere, as an order to put it there: "the mugs *belong* in the
    cupboard"; not of people and animals, nor where the words behind tell what to do about it."""
    tokens = document.tokens
    if document.words.isdisjoint(BELONGING | {"go"}):
        return
    for i, token in enumerate(tokens):
        verb = i if token.lower in BELONGING else _should_go(document, i)
        if verb is None or not _is_of_thing(document, i):
            continue
        thing = _subject(document, i)
        start = verb + 1 + (tokens[verb + 1 : verb + 2] != () and tokens[verb + 1].lower == "back")
        stop = next((t.i for t in tokens[start:] if t.lower in MARKS or t.lower in ("and", "please")), len(tokens))
        is_place = stop - start > 1 and tokens[start].lower in WHERE_TO and tokens[stop - 1].pos in ("NOUN", "PROPN")
        living = PERSON_NOUNS | ANIMALS
        is_somebody = tokens[i - 1].lemma in living or (tokens[i - 1].pos == "PROPN" and len(thing) == 1)
        if is_place and not is_somebody and not _is_taken_up(document, thing, verb):
            yield Fragment(range(thing.start, stop), verb, thing, range(start, stop), "placing")


def _should_go(document: Document, should: int) -> int | None:
    """The "go" of "should go", "ought to go"."""
    words = [token.lower for token in document.tokens[should : should + 3]]
    if words[:1] == [] or words[0] not in _SHOULD:
        return None
    go = should + 1 + (words[1:2] == ["to"])
    return go if words[go - should : go - should + 1] == ["go"] else None


def due(document: Document) -> frozenset[int]:
    """The words that say no more than that it is time."""
    times = (i for i in range(len(document)) if _due(document, i) is not None) if "time" in document.words else ()
    return frozenset(j for i in times for j in range(document.sentences.index(document.sentences[i]), i + 1))


def _gerund(document: Document, need: int) -> int | None:
    """The "watering" of "wants watering"."""
    verb = _behind(document, need) if _is_need(document.tokens[need]) else None
    if verb is None or not verb.lower.endswith("ing") or not _VAGUE.isdisjoint(lemmas(verb.lower)):
        return None
    behind = document.tokens[verb.i + 1 : verb.i + 2]
    is_part = bool(behind) and behind[0].pos in ("NOUN", "PROPN")  # "needs cleaning products"
    return None if is_part or verb.tag not in ("VBG", "NN", "JJ") else verb.i


def _deed(observed: Observed, at: int) -> int | None:
    """The verb, or the noun, of what is to be done by the word that says so: "needs *emptying*", "should be *emptied*",
    "could do with a *wipe*"."""
    document = observed.document
    return _gerund(document, at) or _passive(document, at) or _obliged(observed, at) or _noun(observed, at)


def _passive(document: Document, need: int) -> int | None:
    """The "emptied" of "needs to be emptied"."""
    if not _is_need(document.tokens[need]):
        return None
    to = _behind(document, need)
    words = [token.lower for token in document.tokens[to.i : to.i + 2]] if to is not None else []
    verb = _behind(document, to.i + 1) if to is not None and words == ["to", "be"] else None
    return verb.i if verb is not None and verb.tag in ("VBN", "VBD") and _VAGUE.isdisjoint(lemmas(verb.lower)) else None


def _obliged(observed: Observed, at: int) -> int | None:
    """The "emptied" of "should be emptied", "is to be emptied"; no more than a guess is "should be emptied by now"."""
    document, verb = observed.document, _participle(observed.document, at)
    if verb is None:
        return None
    stop = next((t.i for t in document.tokens[verb:] if t.lower in MARKS), len(document))
    said = [token.lower for token in document.tokens[verb + 1 : stop]]
    is_guess = not _SUPPOSING.isdisjoint(said) or ("by", "now") in pairwise(said)
    kinds = {kind for form in forms(document, verb) for kind in observed.gazetteer.verbs.get(form, ())[:1]}
    return None if is_guess or not kinds or not _FOUND_OUT.isdisjoint(kinds) else verb


def _participle(document: Document, at: int) -> int | None:
    """The participle of "should be emptied", "has to be emptied" by its first word."""
    tokens = document.tokens
    if tokens[at].lower not in _OBLIGING | _OBLIGING_TO:
        return None
    words = [token for token in tokens[at + 1 : at + 7] if token.lower not in _IN_OBLIGATIONS]
    leading = ["be"] if tokens[at].lower in _OBLIGING else ["to", "be"]
    if [word.lower for word in words[: len(leading)]] != leading or len(words) == len(leading):
        return None
    verb = words[len(leading)]
    return verb.i if verb.tag in ("VBN", "VBD") and _VAGUE.isdisjoint(lemmas(verb.lower)) else None


def _noun(observed: Observed, could: int) -> int | None:
    """The "wipe" of "could do with a wipe", "needs a wipe": a deed, no thing."""
    tokens = observed.document.tokens
    is_could = tuple(token.lower for token in tokens[could : could + 3]) == _COULD_DO_WITH
    article = could + 3 if is_could else could + 1
    if not (is_could or _is_need(tokens[could])) or len(tokens) < article + 2:
        return None
    if tokens[article].lower not in ("a", "another"):
        return None
    is_described = article + 2 < len(tokens) and tokens[article + 2].pos == "NOUN"
    noun = tokens[article + 1 + is_described]
    is_deed = observed.gazetteer.verbs.get(noun.lower, ())[:1] == ("change_state",)
    is_thing = noun.lower not in CLEANING and bool(observed.gazetteer.category(noun.lemma))
    return noun.i if is_deed and not is_thing else None


def _due(document: Document, time: int) -> int | None:
    """The "feed" of "it's time to feed the fish", where it is the last sentence: a later one may tell what somebody
    needs for it ("it's time to take my pills. Bring me some water")."""
    tokens, sentences = document.tokens, document.sentences
    words = [token.lower for token in tokens[time : time + 2]]
    first = sentences.index(sentences[time])
    if words != ["time", "to"] or time + 3 >= len(tokens) or sentences[time] != sentences[-1]:
        return None
    verb, behind = tokens[time + 2], tokens[time + 3]
    is_led = all(token.lower in _BEFORE_TIME for token in tokens[first:time])
    return verb.i if is_led and verb.tag == "VB" and behind.tag in ("DT", "NN", "NNS", "RP") else None


def _is_need(token: Token) -> bool:
    return token.lower in NEEDING and token.tag in _PRESENT


def _behind(document: Document, at: int) -> Token | None:
    """The next word that is no adverb of degree."""
    return next((token for token in document.tokens[at + 1 :] if token.lower not in _BETWEEN), None)


def _subject(document: Document, need: int) -> range:
    """The words from the beginning of the sentence, or of what "and" joins to it, to the need, fillers left out."""
    tokens, sentences = document.tokens, document.sentences
    start = need
    while start and sentences[start - 1] == sentences[need] and tokens[start - 1].lower not in (",", "and"):
        start -= 1
    while start < need and tokens[start].lower in OPENING:
        start += 1
    return range(start, need)


def _is_of_thing(document: Document, need: int) -> bool:
    """Whether nothing stands ahead of a need in its sentence but a thing that has it, or another thing with its need
    ("the dog needs walking and *the cat wants feeding*"), or a case with a thing that "it" takes up ("if the yard is
    wet, *it wants sweeping*")."""
    tokens, sentences = document.tokens, document.sentences
    said = _subject(document, need)
    words = tokens[said.start : said.stop]
    first = sentences.index(sentences[need])
    ahead = [i for i in range(first, said.start) if tokens[i].lower not in OPENING]
    is_case = bool(ahead) and tokens[ahead[0]].lower in _CASES and tokens[said.start - 1].text == ","
    if is_case and len(words) == 1 and words[0].lower in _OF_CASE:
        return any(tokens[i].pos in ("NOUN", "PROPN") for i in ahead) and tokens[need].lower in NEEDING
    is_modal = tokens[need].tag == "MD"  # ahead of which nothing is a verb: "the duvet *covers* should"
    if is_modal and len(words) > 1 and words[-1].tag in ("VBZ", "VBP", "VB"):
        words = words[:-1]
    is_named = any(token.pos in ("NOUN", "PROPN") for token in words) or (len(words) > 1 and words[0].pos == "DET")
    if not is_named or not (words[0].pos in _NOMINAL or words[0].tag == "PRP$"):
        return False
    if any(token.pos not in _NOMINAL and token.lower not in _INSIDE and token.tag != "PRP$" for token in words):
        return False
    needs = [i for i in ahead if _is_need(tokens[i]) or _participle(document, i) is not None]
    is_first = not ahead or is_case or (len(needs) == 1 and _is_of_thing(document, needs[0]))
    end = next((token.lower for token in tokens[need:] if token.lower in ENDS), ".")
    return is_first and end != "?"


def _is_taken_up(document: Document, subject: range, verb: int) -> bool:
    """Whether what is said behind a need, up to the end of the next sentence, speaks of the thing again or says by its
    mark that it tells how; or what comes later at all names it."""
    tokens, sentences = document.tokens, document.sentences
    said = takewhile(lambda token: token.lower not in _PLACING, tokens[subject.start : subject.stop])
    named = [token.lemma for token in said if token.pos in ("NOUN", "PROPN")][-1:]
    later = tokens[verb + 1 :]
    besides = {
        i for one in so_does(document) for i in (*one.words, *one.other) if tokens[i].lower not in ("its", "their")
    }
    besides.update(_left_alone(document, verb))
    besides.add(verb + 1)  # "the twins should be told *that* ..."
    near = [token for token in later if sentences[token.i] <= sentences[verb] + 1 and token.i not in besides]
    if any(token.lower in _LEADING_ON and sentences[token.i] == sentences[verb] for token in later):
        return True
    clause = next((t.i for t in later if t.lower in MARKS | {"and"}), len(tokens))
    near = [token for token in near if token.tag != "PRP$" or token.i > clause]  # "Dad should be given *his* paper"
    is_of_living = any(tokens[i].lemma in PERSON_NOUNS | ANIMALS for i in subject[-1:])
    if not is_of_living:  # "Tom's shirt needs washing, and *his* socks need washing"
        near = [token for token in near if token.tag != "PRP$" or token.lower not in ("his", "her")]
    is_meant = any(token.lower in _PERSONAL and not _is_of_weather(document, token.i) for token in near)
    return is_meant or any(token.lemma in named for token in later) or _is_helped(tokens[verb], near)


def _left_alone(document: Document, verb: int) -> range:
    """The words from a "but if" behind a need to the end of its sentence, in which the thing is only left as it is:
    "the bath needs cleaning, *but if there's someone in it, leave it alone*"."""
    tokens, sentences = document.tokens, document.sentences
    stop = next((t.i for t in tokens[verb:] if sentences[t.i] != sentences[verb]), len(tokens))
    words = [token.lower for token in tokens[verb + 1 : stop]]
    start = next((i for i, pair in enumerate(pairwise(words)) if pair in _BUT_IF), len(words))
    is_left = any(pair in _LEAVE_IT for pair in pairwise(words[start:]))
    return range(verb + 1 + start, stop) if is_left else range(0)


def _is_helped(deed: Token, near: Sequence[Token]) -> bool:
    """Whether what is said behind a need is of the tool for it: "the phone needs *charging*. Get the *charger*"."""
    stems = tuple(stem for lemma in lemmas(deed.lower) if len(stem := lemma.removesuffix("e")) > 2)
    nouns = (token.lower for token in near if token.pos in ("NOUN", "PROPN") and token.lower != deed.lower)
    return any(noun.startswith(stems) for noun in nouns)


def _is_of_weather(document: Document, at: int) -> bool:
    """Whether it is the "it" of "it's raining"."""
    behind = document.tokens[at + 1 : at + 4]
    return document.tokens[at].lower == "it" and any(token.lemma in WEATHER for token in behind)
