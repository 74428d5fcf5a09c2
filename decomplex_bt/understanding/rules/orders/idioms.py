"""Idioms: turns of phrase that say a task, or what it is about, whatever a model says of their words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import takewhile

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.cue_phrases import normal_form
from decomplex_bt.understanding.document import MARKS, Document, Token
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.identity import identities, order_behind
from decomplex_bt.understanding.references.looks import looks
from decomplex_bt.understanding.references.phrases import degree_asked, is_deed
from decomplex_bt.understanding.rules.cases.suppositions import MAY, supposed
from decomplex_bt.understanding.rules.cases.waits import AWAITING, BE_OR_HAVE, awaited
from decomplex_bt.understanding.rules.orders.assistance import helps_somewhere
from decomplex_bt.understanding.rules.orders.doors import LONGEST_NAMED, PEOPLE, admissions
from decomplex_bt.understanding.states import OPPOSITES
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_ASKED = frozenset("is are 's has have do does did if whether see to what who where".split())
_ASKING = frozenset(("check_state", "searching"))
_SPEAKERS = frozenset(("i", "we"))
_RELATIVES = frozenset(("that", "which", "who"))
_LOCATIONS = frozenset("home here there inside outside upstairs downstairs indoors outdoors nearby".split())
_TROUBLING = frozenset(("bother", "trouble"))
_ASKED_AFTER = {**dict.fromkeys(_TROUBLING, 3), "chance": 2}
"""How far behind a word what is asked for begins: "trouble you for", "chance of"."""
_FAVOURS = frozenset("hand minute moment second help favour favor word".split())
"""What is asked for and is no thing to be brought."""
_PHRASE = frozenset(("DET", "ADJ", "NUM", "NOUN", "PROPN", "PRON"))
_GETTING = frozenset(("get", "fetch", "grab", "pick"))
_ONESELF = frozenset(("me", "us"))
_NO_STATES = frozenset("too already so not yet then".split())
_OTHERS = frozenset("me him her us them they he she we i who".split())
_AGAIN = frozenset(("again", "already", "still", "by", "now", "anyway"))
_WITHOUT_MORE = frozenset("again quietly silently immediately at once now please straight right away".split())
_BEFORE_ORDERS = frozenset("and then just please simply".split())
_CASES = frozenset(("if", "unless"))
_JOINING = frozenset(("and", "but", "or", "so", "then"))
_DEGREES = frozenset("still too already really quite very not completely".split())
_NO_TERSE_STATES = frozenset("able possible necessary sure".split())
_COMING = frozenset("going gon about supposed due bound set".split())
_IS = frozenset("is are 's 're am 'm".split())
_NOT = frozenset(("not", "n't", "just", "still", "really"))
_SO_COMING = ("RB", "RP", "JJ", "VBN")
_BEFORE_ORDERS = frozenset("and then please first just always but".split())
_BEHIND_KNOCKS = frozenset("first before and on at twice once when if gently softly loudly".split())
_ITS = frozenset(("it", "them"))
_OPENING = frozenset(("when", "whenever", "once", "if", "unless", "while"))
_HEARING = frozenset("when whenever once if unless as until".split())
_NOBODY = (
    ("nobody", "else"), ("no", "one", "else"), ("nobody",), ("no", "one"), ("no", "-", "one"),
)  # fmt: skip


def idiomatic(document: Document, tasks: Mapping[int, str]) -> dict[int, str]:
    """The tokens that are tasks besides the `tasks` found, which are tokens with types; with their types.

    Checks are what may be so, where the next words take it up ("The door might be locked. In that case, ..."), the
    weather of "should it rain", what is to come ("if it's going to freeze"), that nobody is somewhere ("when nobody is
    in"), which one of several it is ("if it was the last one") and what a prohibition waits for ("don't start it before
    it's full"). "Have" in "have a look" is searching, "let" in "let go of the rope" placing, "trouble" in "might I
    trouble you for the salt" bringing, "leave" in "empty the bin and leave" motion, "open" in "if it's the plumber open
    for him" an order.
    """
    checks = (
        supposed(document, tasks) | _weather(document, tasks) | _absences(document, tasks) | _terse(document, tasks)
    )
    checks |= {i for i, told in awaited(document, tasks).items() if told.forbidden in tasks} - tasks.keys()
    checks |= _identities(document, tasks) | _prospects(document, tasks)
    checks |= {i for i in range(len(document)) if is_heard(document, i) and not _is_told(document, tasks, i)}
    orders = {order_behind(document, identity) for identity in identities(document) if identity.be in tasks}
    return {
        **{i: "change_state" for i in orders if i is not None and i not in tasks},
        **{i: "check_state" if degree_asked(document, i) else "searching" for i in _looks(document, tasks)},
        **dict.fromkeys((*admissions(document, tasks), *_lettings(document)), "placing"),
        **dict.fromkeys(_deeds(document), "change_state"),
        **dict.fromkeys(_leavings(document, tasks), "motion"),
        **dict.fromkeys(_troubles(document), "bringing"),
        **dict.fromkeys(_knocks(document, tasks), "informing"),
        **dict.fromkeys(helps_somewhere(document), "following"),
        **dict.fromkeys(checks, "check_state"),
    }


def is_heard(document: Document, at: int) -> bool:
    """Whether a verb says of a case what is to be heard in it: "once you *hear* the bell", "if you *hear* the baby"."""
    ahead = [token.lower for token in document.tokens[max(0, at - 2) : at]]
    return document.tokens[at].lower == "hear" and ahead[1:] == ["you"] and ahead[0] in _HEARING


def heard(document: Document, at: int) -> dict[str, range]:
    """What is to be heard in a case, as the object of the verb that says so; empty for any other verb."""
    chunks = noun_chunks(document) if is_heard(document, at) else ()
    thing = next((chunk for chunk in chunks if chunk.start == at + 1), None)
    return {} if thing is None else {"object": thing}


def _deeds(document: Document) -> Iterator[int]:
    """The "give" of every order to give something a wipe or the like: "*give* it a quick rinse"."""
    tokens = document.tokens
    if "give" not in document.words:
        return
    for phrase in (range(i, i + 2 + k) for k in (0, 1) for i in range(2, len(tokens) - 1 - k)):
        if is_deed(document, phrase):
            giving = next((j for j in range(phrase.start - 1, -1, -1) if tokens[j].lower == "give"), None)
            if giving is not None and phrase.start - giving <= LONGEST_NAMED:
                yield giving


def _knocks(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """Every order to knock, at which somebody may answer, that says no more: "if the door is shut, *knock*"."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower != "knock" or i in tasks or token.tag not in ("VB", "VBP", "NN", "NNP"):
            continue
        first = i
        while first and tokens[first - 1].lower in _BEFORE_ORDERS:
            first -= 1
        behind = [t.lower for t in tokens[i + 1 : i + 3]]
        is_order = first == 0 or tokens[first - 1].text in MARKS  # not "visitors just knock"
        is_only = not behind or behind[0] in MARKS or behind[0] in _BEHIND_KNOCKS
        is_sound = behind[1:] == ["knock"] or (i > 1 and tokens[i - 2].lower == "knock")
        if is_order and is_only and not is_sound:
            yield i


def _weather(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of "should it rain"; not of what somebody is told ("tell Anna should it rain ...")."""
    tokens = document.tokens
    return frozenset(
        i + 2
        for i, token in enumerate(tokens[:-2])
        if token.lower == "should"
        and tokens[i + 1].lower == "it"
        and tokens[i + 2].lemma in WEATHER
        and not _is_told(document, tasks, i)
    )


def _prospects(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The "is" of "if it *is* going to freeze", "unless Tom *is* about to leave", where no word of it is a task yet."""
    tokens, found = document.tokens, set()
    for i, token in enumerate(tokens):
        if token.lower not in ("if", "unless") or _is_told(document, tasks, i):
            continue
        be = next((t.i for t in tokens[i + 2 : i + 7] if t.lower in _IS), None)
        if be is None or not MARKS.isdisjoint(t.lower for t in tokens[i:be]):
            continue
        if (coming := _coming(document, be)) and not any(i < j < coming.stop for j in tasks):
            found.add(be)
    return frozenset(found)


def _coming(document: Document, be: int) -> range:
    """What is said to come behind a "be": "is *going to freeze*"; else empty."""
    tokens = document.tokens
    start = be + 1
    while start < len(tokens) and tokens[start].lower in _NOT:
        start += 1
    words = tokens[start : start + 3]
    is_coming = len(words) == 3 and words[0].lower in _COMING and words[1].lower in ("to", "na")
    if not is_coming or words[2].tag not in ("VB", "VBP", "NN"):
        return range(0)
    stop = start + 3
    kinds = _SO_COMING if words[2].lower == "be" else ("RB", "RP")
    stop += stop < len(tokens) and tokens[stop].lower in _ITS
    while stop < len(tokens) and tokens[stop].tag in kinds and tokens[stop].lower not in ("then", "just"):
        stop += 1
    return range(start, stop)


def prospect_of(document: Document, at: int) -> int | None:
    """The "is" of a case in which something is going to be so, for a word behind it that says what: "if it *'s* gonna
    be cold"; None for other words."""
    tokens = document.tokens
    be = next((i for i in range(at - 1, max(0, at - 7), -1) if tokens[i].lower in _IS), None)
    if be is None or at not in _coming(document, be):
        return None
    return be if any(token.lower in ("if", "unless") for token in tokens[max(0, be - 5) : be]) else None


def foreseen(document: Document, check: int) -> range:
    """What is said to come behind a check: "going to freeze"; else empty."""
    return _coming(document, check) if document.tokens[check].lower in _IS else range(0)


def _terse(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The states of conditions that are no more than one: "if *hot*, turn it off", "if still *damp* hang it up"."""
    tokens, found = document.tokens, set()
    for i, token in enumerate(tokens[:-1]):
        if token.lower not in ("if", "unless") or _is_told(document, tasks, i):
            continue
        at = i + 1
        while at + 1 < len(tokens) and tokens[at].lower in _DEGREES:
            at += 1
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        is_state = tokens[at].lower in OPPOSITES and tokens[at].lower not in _NO_TERSE_STATES
        is_alone = after is None or after.lower in MARKS or tasks.get(after.i, "check_state") != "check_state"
        if is_state and is_alone and at not in tasks:
            found.add(at)
    return frozenset(found)


def _absences(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of "when nobody is in", "once no one's there", where no word up to the end of the clause is a task yet;
    not of what somebody is told or asks."""
    tokens, found = document.tokens, set()
    for i, token in enumerate(tokens):
        if token.lower not in _OPENING or _is_told(document, tasks, i):
            continue
        words = [normal_form(token.lower) for token in tokens[i + 1 : i + 6]]
        length = next((len(nobody) for nobody in _NOBODY if tuple(words[: len(nobody)]) == nobody), None)
        if length is None or words[length : length + 1] != ["is"]:
            continue
        verb = i + 1 + length
        stop = next((j for j in range(verb, len(tokens)) if tokens[j].lower in MARKS | _JOINING), len(tokens))
        if not any(i < j < stop for j in tasks):
            found.add(verb)
    return frozenset(found)


def _identities(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The verbs of "if that was the last one", where no word of it is a task yet; not of what somebody is told or
    finds out ("check if that was the last one")."""
    return frozenset(
        identity.be
        for identity in identities(document)
        if identity.is_pronoun(document)
        and identity.is_of_order(document)
        and not any(identity.subject.start <= i < identity.name.stop for i in tasks)
        and not any(tasks.get(identity.subject.start - n) in _ASKING for n in (2, 3))
        and not _is_told(document, tasks, identity.subject.start)
    )


def _is_told(document: Document, tasks: Mapping[int, str], at: int) -> bool:
    """Whether the words at `at` stand in one clause with a verb of informing ahead of them."""
    for i in range(at - 1, -1, -1):
        if document.tokens[i].lower in MARKS or document.sentences[i] != document.sentences[at]:
            return False
        if i in tasks:
            return tasks[i] == "informing"
    return False


def _looks(document: Document, tasks: Mapping[int, str]) -> list[int]:
    """The verb of every order to have a look at which no word is a task yet."""
    tokens = document.tokens
    found = []
    for look in looks(document):
        words = range(look.verb + 1, look.words.stop)
        is_found = any(i in tasks for i in words) or (look.verb in tasks and tokens[look.verb].lemma != "have")
        if is_found or _is_of_others(document, look.verb) or _is_told(document, tasks, look.verb):
            continue  # "so that I can have a look"
        after = next((t.lower for t in tokens[look.words.stop :] if t.lower not in (",", ":", "-")), "")
        if after not in _ASKED:  # "have a look, is the gate open?" asks
            found.append(look.verb)
    return found


def is_light(document: Document, verb: int, noun: int) -> bool:
    """Whether a verb only helps a noun that is the order: "*have* a look", "*take* a quick peek"."""
    return any(look.verb == verb and noun in look.words for look in looks(document))


def _lettings(document: Document) -> list[int]:
    """Every "let" of an order to let go of something."""
    words = [token.lower for token in document.tokens]
    return [
        i for i in range(len(words) - 3) if words[i : i + 3] == ["let", "go", "of"] and not _is_of_others(document, i)
    ]


def _troubles(document: Document) -> list[int]:
    """Every word that makes a polite request for something: "could I *bother* you for a glass of water", "any *chance*
    of a cup of tea"."""
    words = [token.lower for token in document.tokens]
    verbs = [i for i in range(2, len(words) - 3) if words[i] in _TROUBLING and words[i + 1 : i + 3] == ["you", "for"]]
    verbs = [i for i in verbs if words[i - 1] in _SPEAKERS and words[i - 2] in MAY | {"can"}]
    chances = [i for i in range(1, len(words) - 2) if words[i - 1 : i + 2] == ["any", "chance", "of"]]
    return [i for i in (*verbs, *chances) if troubled(document, i)]


def troubled(document: Document, verb: int) -> range:
    """What somebody is "troubled for", or there is "any chance of": "the salt", not "a hand"; empty for any other
    word."""
    tokens = document.tokens
    start = verb + _ASKED_AFTER.get(tokens[verb].lower, len(tokens))
    words = list(takewhile(lambda token: token.pos in _PHRASE or token.lower == "of", tokens[start:]))
    named = [token for token in words if token.pos in ("NOUN", "PROPN")]
    return range(start, named[-1].i + 1) if named and named[0].lower not in _FAVOURS else range(0)


def _leavings(document: Document, tasks: Mapping[int, str]) -> list[int]:
    """Every "leave" of an order to go away: no word tells what to leave, behind it ("empty the bin and leave quietly")
    or put first ("the brown ones, leave"), and nobody else is said or told to."""
    tokens = document.tokens
    found = []
    for i, token in enumerate(tokens):
        if token.lower != "leave" or (i and tokens[i - 1].lower not in _BEFORE_ORDERS | MARKS):
            continue
        end = i + 1
        while end < len(tokens) and tokens[end].lower in _WITHOUT_MORE:
            end += 1
        is_bare = end == len(tokens) or tokens[end].lower in MARKS | _JOINING | {"without"}
        if is_bare and not (_is_listed(document, i) or _is_of_clause(document, tasks, i)):
            found.append(i)
    return found


def _is_listed(document: Document, order: int) -> bool:
    """Whether nothing but names stands ahead of an order in its sentence, up to a mark: "the brown ones, leave"."""
    words = document.tokens[document.sentences.index(document.sentences[order]) : order]
    return bool(words) and words[-1].lower in MARKS and not any(token.pos in ("VERB", "AUX") for token in words)


def _is_of_clause(document: Document, tasks: Mapping[int, str], verb: int) -> bool:
    """Whether a verb goes on with what others do or are told ("if they get up *and leave*", "ask him to eat *and
    leave*"), not with an order."""
    tokens = document.tokens
    if verb == 0 or tokens[verb - 1].lower in MARKS or _is_of_others(document, verb):
        return verb > 0 and tokens[verb - 1].lower not in MARKS
    start = next((j + 1 for j in range(verb - 1, -1, -1) if tokens[j].lower in MARKS), 0)
    opening = [j for j in range(start, verb) if tokens[j].lower in _OPENING | AWAITING | {"after"}]
    orders = [j for j, kind in tasks.items() if start <= j < verb and kind != "check_state"]
    is_case = bool(opening) and (not orders or tokens[opening[-1]].lower not in _CASES)
    others = [j for j in document.children[tokens[verb].head] if tokens[j].dep == "nsubj" and start <= j < verb]
    is_of_subject = tokens[verb].dep == "conj" and not orders and any(tokens[j].lower != "you" for j in others)
    return is_case or is_of_subject or _is_told(document, tasks, verb)


def _is_of_others(document: Document, verb: int) -> bool:
    """Whether a verb says what others than the one spoken to do: "I'd like to have a look", "let him have a look"."""
    tokens = document.tokens
    if any(tokens[j].dep in ("nsubj", "nsubjpass") and tokens[j].lower != "you" for j in document.children[verb]):
        return True
    before = [token.lower for token in tokens[max(0, verb - 2) : verb]]
    if before[-1:] == ["to"]:
        return before[0] != "you"  # "I need you to have a look"
    return before[-1:] != [] and before[-1] in _OTHERS


def for_somebody(document: Document, verb: int) -> range:
    """The "for Ella" of "get a coke for Ella", in the clause of a verb of getting; empty where there is none. "Pick
    them up for me" asks a favour."""
    tokens, sentences = document.tokens, document.sentences
    if tokens[verb].lemma not in _GETTING:
        return range(0)
    for i in range(verb + 1, len(tokens) - 1):
        if tokens[i].lower in MARKS | _JOINING or tokens[i].pos == "VERB" or sentences[i] != sentences[verb]:
            break
        if tokens[i].lower != "for":
            continue
        noun = i + 1 + (tokens[i + 1].tag in ("PRP$", "DT"))
        if tokens[i + 1].lower in _ONESELF and tokens[verb].lemma not in ("get", "fetch"):
            return range(0)
        if tokens[i + 1].lower in PEOPLE:
            return range(i, i + 2)
        if noun < len(tokens) and (tokens[noun].lemma in PERSON_NOUNS or tokens[noun].tag == "NNP"):
            return range(i, noun + 1)
    return range(0)


def encountered(document: Document, verb: int) -> range:
    """The "Ann" of "run into Ann", "bump into Ann", who is found; empty where somebody goes into a place."""
    tokens = document.tokens
    behind = tokens[verb + 1 : verb + 4]
    if tokens[verb].lemma not in ("run", "bump") or [t.lower for t in behind[:1]] != ["into"] or len(behind) < 2:
        return range(0)
    last = verb + 3 if len(behind) > 2 and behind[1].tag in ("DT", "PRP$") else verb + 2
    is_person = tokens[last].lemma in PERSON_NOUNS or tokens[last].tag in ("NNP", "PRP")
    return range(verb + 2, last + 1) if is_person else range(0)


def predicated(document: Document, check: int) -> dict[str, range]:
    """What the words of a check that may be so say of it: the `object`, its subject, and behind a "be" the `state`
    ("the attic door might be locked") or else the `location` ("the keys might be in the car"), as of "nobody is in the
    attic", and what is to come as the state ("going to rain"); nothing for any other check."""
    tokens = document.tokens
    if tokens[check].lower in _IS and (coming := _coming(document, check)):
        return {"state": coming}
    may = next((j for j in range(check - 1, max(-1, check - 5), -1) if tokens[j].lower in MAY), None)
    found = {}
    if may is not None and not any(tokens[j].lower in MARKS for j in range(may, check)):
        subject = _subject(document, may, check)
        if subject:
            found["object"] = subject
        if tokens[check].lower != "be":
            return found
    elif told := awaited(document, {}).get(check):
        found["object"] = told.subject
        if tokens[check].lower not in BE_OR_HAVE:
            return found
    elif not _is_of_nobody(document, check):
        return {}
    behind = next((t for t in tokens[check + 1 : check + 4] if t.tag != "RB"), None)
    adverb = tokens[check + 1] if behind is not None and check + 1 < behind.i else None
    if behind is None or (behind.lower in MARKS and adverb is not None and adverb.lower not in _NO_STATES):
        if adverb is not None:  # "poorly" and "upstairs" are adverbs to the tagger
            found["location" if adverb.lower in _LOCATIONS else "state"] = range(adverb.i, adverb.i + 1)
    elif behind.lower in _LOCATIONS:
        found["location"] = range(behind.i, behind.i + 1)
    elif behind.tag in ("JJ", "VBN", "VBG"):
        after = tokens[behind.i + 1] if behind.i + 1 < len(tokens) else None
        found["state"] = range(behind.i, behind.i + 1 + (after is not None and _goes_with(behind, after)))
    elif behind.pos == "ADP":
        stop = behind.i
        while stop < len(tokens) and tokens[stop].lower not in MARKS | _JOINING | _AGAIN:
            stop += 1
        is_lack = behind.lower == "out" and tokens[behind.i + 1 : behind.i + 2] and tokens[behind.i + 1].lower == "of"
        found["state" if is_lack else "location"] = range(behind.i, stop)  # "out of milk"
    return found


def _goes_with(participle: Token, after: Token) -> bool:
    """Whether a word belongs to the participle before it: "switched *off*", "watching *it*"."""
    return after.dep == "prt" or (participle.tag == "VBG" and after.lower in _ITS)


def _is_of_nobody(document: Document, check: int) -> bool:
    words = [normal_form(token.lower) for token in document.tokens[max(0, check - 3) : check + 1]]
    return words[-1:] == ["is"] and any(tuple(words[-1 - len(nobody) : -1]) == nobody for nobody in _NOBODY)


def _subject(document: Document, may: int, check: int) -> range:
    """The words right before "may" that name what it is said of: a noun with what stands before it, or several joined
    ones; none where more stands between ("the chair by the window may be broken")."""
    tokens = document.tokens
    heads = {check, tokens[check].head, tokens[may].head}
    subjects = [j for head in heads for j in document.children[head] if tokens[j].dep in ("nsubj", "nsubjpass")]
    head = max((j for j in subjects if j < may), default=None)
    is_of_weather = head is not None and tokens[head].lower == "it" and tokens[check].lemma in WEATHER
    if (
        head is None
        or is_of_weather
        or tokens[head].lower in _RELATIVES
        or tokens[head].pos not in ("NOUN", "PROPN", "PRON")
    ):
        return range(0)
    start = min([head, *(j for j in document.children[head] if j < head)])
    last = head
    while True:
        joined = [j for j in document.children[last] if tokens[j].dep == "conj" and last < j < may]
        if not joined:
            break
        last = joined[0]
    between = tokens[last + 1 : may]
    if last != head and any(token.tag != "RB" for token in between):
        return range(0)
    return range(start, last + 1)
