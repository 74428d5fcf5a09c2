"""Conditions: the case of somebody or something named, or one that more than an "if" opens, is a check, be none of its
words a task by itself ("if *the sun's gone*, ...", "when *Tom's taken the bins out*, ...", "in the event that ...")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS
from decomplex_bt.understanding.document import MARKS, Document
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.rules.cases.certain_cases import CertainCase, certain_cases
from decomplex_bt.understanding.rules.cases.checks import CALLING, OVER
from decomplex_bt.understanding.rules.cases.expectations import expectations
from decomplex_bt.understanding.rules.orders.uses import uses
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS

_OPENING = frozenset(("if", "unless", "when"))
_JOINING = frozenset(("and", "but", "or", "so", "only"))
_BE_OR_HAVE = frozenset("is are 's 're has have was were had".split())
_WAITING = frozenset(("as", "once", "after"))
_HAVE = frozenset("has have had 's".split())
_ARE_OR_HAVE = frozenset("are 're have 've".split())
_PLANNING = frozenset("going trying planning wondering thinking asking struggling having feeling getting".split())
"""What tells of no work that somebody is at."""
_APPROVING = frozenset("need want require prefer allow permit do finish settle sort".split())
_LEFT = frozenset("gone left come arrived returned".split())
_AM_OR_HAVE = frozenset("am 'm m are 're have 've ve".split())
_PERSONS = frozenset("he she they we somebody someone anybody anyone nobody".split())
_UNNAMED = frozenset("you i it that this u".split())
_TRIED = frozenset("attempt try search sign".split())
"""What is told of the order before: "if the second attempt is unsuccessful", "if there's no sign of them"."""
_OF_ORDERS = frozenset("rest job jobs work tasks".split())
_DO = frozenset(("do", "does", "did"))
_NOT = frozenset("not n't nt".split())
_ANYBODY = tuple(
    tuple(words.split())
    for words in (
        "nobody", "no one", "noone", "somebody", "someone", "anybody", "anyone", "everybody", "everyone",
    )
)  # fmt: skip
_AHEAD = frozenset("has have had 's does do did will ca can not n't already ever actually really".split())
"""What stands ahead of the verb that says what somebody does or has done."""
_UNKNOWING = frozenset("know sure idea clue remember recall tell wonder certain unsure dunno".split())
_OF_EVENTS = frozenset(("it", "they", "he", "she"))
_FINITE = frozenset(("VBZ", "VBP", "VBD"))
_AUXILIARY = frozenset("be have do 's 're 've".split())
_AFTER_EVENTS = frozenset("and then up down off out over back".split())
_NAMING = frozenset("DT PRP PRP$ NN NNS NNP NNPS".split())
_PERFORMING = frozenset("read sing recite announce".split())
"""What one does for others and tells nobody whether something is so."""
_TELLING = frozenset("tell ask say know".split())
_GOING_BY = frozenset((("if", "so"), ("if", "not"), ("if", "yes"), ("if", "no")))
_OF_TASKS = frozenset("fail succeed manage".split())
"""What tells how a task went: "in the case that this fails"."""
_LONGEST = 6
"""The most words of a subject."""


def untold(document: Document, tasks: Mapping[int, str]) -> frozenset[int]:
    """The "is" or "has" of every case that begins a clause, has a noun, a person or "there" for its subject, and none
    of whose words up to its mark is among the `tasks`, which are tokens with types; not of what somebody is told. What
    is said not to be wanted or done needs no mark. Of `certain_cases` any verb, wherever they stand."""
    tokens = document.tokens
    certain = frozenset(case.verb for case in certain_cases(document) if _is_untold(document, case, tasks))
    return (
        certain
        | frozenset(_departures(document, tasks))
        | frozenset(_ends(document, tasks))
        | frozenset(_events(document, tasks))
        | frozenset(one.verb for one in expectations(document) if one.verb not in tasks)
        | frozenset(check for *_, check in _performed(document, tasks))
        | frozenset(_denials(document, tasks))
        | frozenset(_of_anybody(document, tasks))
        | frozenset(_doubts(document, tasks))
        | frozenset(_of_speaker(document))
        | frozenset(_times_of_speaker(document, tasks))
        | frozenset(_of_listener(document, tasks))
        | frozenset(_of_that(document, tasks))
        | frozenset(_happenings(document, tasks))
        | frozenset(
            be
            for i, token in enumerate(tokens)
            if token.lower in _OPENING
            and (i == 0 or tokens[i - 1].text in MARKS | _JOINING or _is_of_another(document, i))
            and (stop := next((j for j in range(i + 1, len(tokens)) if tokens[j].text in MARKS), len(tokens))) > i + 2
            and tasks.keys().isdisjoint(range(i, stop))
            and (be := _be(document, range(i + 1, stop))) is not None
            and not _is_told(document, tasks, i)
        )
    )


def _departures(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "has" of every clause that waits for somebody to have gone, behind or ahead of what is ordered: "close it as
    soon as *she's* gone to bed"."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower not in _WAITING or (token.lower == "as" and tokens[max(0, i - 1)].lower != "soon"):
            continue
        stop = next(
            (j for j in range(i + 1, len(tokens)) if tokens[j].lower in MARKS | _JOINING | {"then"}), len(tokens)
        )
        be = _be(document, range(i + 1, stop))
        is_gone = be is not None and tokens[be].lower in _HAVE and tokens[be + 1].lower in _LEFT
        if be is not None and is_gone and tasks.keys().isdisjoint(range(i, stop)) and not _is_told(document, tasks, i):
            yield be


def _ends(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "is" or "has" of every "when" behind what is ordered that waits for somebody to have gone or something to be
    over: "air the attic when *they're* gone", "when *the drum's* finished"; not of "you", "that" or the rest of the
    orders, and not of what is found out or told ("see when she's gone")."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower != "when" or i == 0 or tokens[i - 1].lemma in ASKING_LEMMAS | {"even", "for"}:
            continue
        stop = next((j for j in range(i + 1, len(tokens)) if tokens[j].lower in MARKS | _JOINING), len(tokens))
        subject = range(i + 1, min(stop - 1, i + 1 + _LONGEST))
        be = next((j for j in subject if j > i + 1 and tokens[j].lower in _BE_OR_HAVE), None)
        if be is None or tokens[be + 1].lower not in OVER or not tasks.keys().isdisjoint(range(i, stop)):
            continue
        named = range(i + 1, be)
        is_thing = tokens[be - 1].lower not in _OF_ORDERS and _is_named_subject(document, named)
        is_it = len(named) == 1 and tokens[be - 1].lower == "it"
        if (is_thing or is_it) and not _is_told(document, tasks, i):
            yield be


def _events(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The verb of every clause that waits for what somebody or something does by itself, and none of whose words is a
    task: "roll it up after *the paint dries*"; not "after you dry it"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-2]):
        if token.lower not in ("after", "once") or (i and tokens[i - 1].lower == "for"):
            continue
        subject = next((chunk for chunk in noun_chunks(document) if chunk.start == i + 1), range(i + 1, i + 2))
        verb = subject.stop
        is_pronoun = len(subject) == 1 and tokens[i + 1].lower in _OF_EVENTS
        if verb >= len(tokens) or not (is_pronoun or _is_named_subject(document, subject)):
            continue
        is_own = tokens[verb].tag in _FINITE and tokens[verb].lemma not in _AUXILIARY and tokens[verb].head != verb
        behind = tokens[verb + 1 : verb + 2]
        is_whole = not behind or behind[0].text in MARKS or behind[0].lower in _AFTER_EVENTS
        is_of_order = any(document.sentences[j] == document.sentences[i] for j in tasks)
        is_free = tasks.keys().isdisjoint(range(i, verb + 1)) and not _is_told(document, tasks, i)
        if is_own and is_whole and is_of_order and is_free:
            yield verb


def _performed(document: Document, tasks: Mapping[int, str]) -> Iterator[tuple[int, range, int]]:
    """Of every case behind an order to read, sing or announce, in which no other word is a task, the verb of that, the
    words of the case and its verb: "sing to Mia *if she cries*" tells nobody that."""
    tokens, sentences = document.tokens, document.sentences
    for owner in (i for i, kind in tasks.items() if kind == "informing" and tokens[i].lemma.lower() in _PERFORMING):
        behind = [t.i for t in tokens[owner + 1 :] if sentences[t.i] == sentences[owner]]
        opener = next((i for i in behind if tokens[i].lower in _OPENING | _WAITING and tokens[i].lower != "as"), None)
        ahead = range(owner + 1, opener or owner + 1)
        if opener is None or any(i in tasks or tokens[i].lower in MARKS | _JOINING for i in ahead):
            continue
        stop = next((i for i in behind if i > opener and tokens[i].text in MARKS), behind[-1] + 1)
        verb = _be(document, range(opener + 1, stop))
        verb = tokens[opener].head if verb is None else verb
        is_own = opener + 1 < verb < stop and (tokens[verb].tag[:2] == "VB" or tokens[verb].lower in _BE_OR_HAVE)
        if is_own and tasks.keys() & set(range(opener, stop)) <= {verb}:
            yield owner, range(opener, stop), verb


def _denials(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The verb behind the "doesn't" of every case that says what somebody or something named does not do, and that has
    no task up to it nor is followed by a check: "if *she doesn't want* it give it to the dog"."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        if token.lower not in _OPENING or not (i == 0 or tokens[i - 1].text in MARKS | _JOINING):
            continue
        subject = range(i + 1, min(len(tokens) - 2, i + 1 + _LONGEST))
        do = next((j for j in subject if j > i + 1 and tokens[j].lower in _DO), None)
        if do is None or not _is_named_subject(document, range(i + 1, do)):
            continue
        verb = do + 1
        while verb + 1 < len(tokens) and (tokens[verb].lower in _NOT or tokens[verb].tag == "RB"):
            verb += 1
        is_denied = any(tokens[j].lower in _NOT for j in range(do, verb))
        is_next = next((tasks[j] for j in sorted(tasks) if j >= i), "check_state") != "check_state"
        is_own = tokens[verb].tag in ("VB", "VBP") and tokens[verb].lemma not in _OF_TASKS
        is_free = tasks.keys().isdisjoint(range(i, verb + 1)) and not _is_told(document, tasks, i)
        if is_denied and is_own and is_next and is_free:
            yield verb


def _of_anybody(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The verb of every case of nobody or somebody in particular, or of the weather, also behind its order, that has no
    task up to it nor is followed by a check: "put it away if *nobody wants it*", "bring it in when *it rains*". Not of
    what is found out or told ("see if anyone ...")."""
    tokens = document.tokens
    for i, token in enumerate(tokens):
        before = tokens[i - 1].lemma if i else ""
        if token.lower not in _OPENING or before in ASKING_LEMMAS or before == "even":
            continue
        words = [t.lower for t in tokens[i + 1 : i + 4]]
        length = next((len(said) for said in _ANYBODY if tuple(words[: len(said)]) == said), 0)
        verb = i + 1 + length + (words[length : length + 1] == ["else"])
        while verb + 1 < len(tokens) and tokens[verb].lower in _AHEAD and tokens[verb + 1].tag[:2] in ("VB", "RB"):
            verb += 1
        if words[:1] == ["it"] and len(words) > 1 and words[1] in WEATHER:
            length, verb = 1, i + 2
        if not length or verb >= len(tokens) or tokens[verb].tag[:2] not in ("VB", "NN"):
            continue
        later = [tasks[j] for j in sorted(tasks) if j > i]
        is_of_order = any(document.sentences[j] == document.sentences[i] for j in tasks)
        is_free = tasks.keys().isdisjoint(range(i, verb + 1)) and not _is_told(document, tasks, i)
        if is_free and is_of_order and later[:1] != ["check_state"]:
            yield verb


def _of_speaker(document: Document) -> Iterator[int]:
    """The verb of every case of what the speaker will say or do to be heard: "close it if *I tell you to*", "when *I
    ring*"; whether somebody else is rung then, is left to the models."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-2]):
        is_opened = token.lower in ("if", "unless", "when", "once") and tokens[i + 1].lower in ("i", "we")
        if not is_opened or (i and tokens[i - 1].lemma in ASKING_LEMMAS | _TELLING | {"even", "mind"}):
            continue
        behind = tokens[i + 3 : i + 4]
        is_of_other = bool(behind) and behind[0].tag in _NAMING and behind[0].lower != "you"
        is_heard = token.lower in ("if", "unless") or not is_of_other
        if tokens[i + 2].lemma in CALLING and tokens[i + 2].tag in ("VBP", "VB") and is_heard:
            yield i + 2


def _times_of_speaker(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "am" or "have" of every clause, at the end or ahead of what is ordered, that waits for how or where the
    speaker will be: "pass me the lamp once *I'm* through the hatch", "when *we've* left"; not "when I was a girl"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-3]):
        is_led = token.lower in ("once", "when", "as") and (
            token.lower != "as" or tokens[max(0, i - 1)].lower == "soon"
        )
        be = tokens[i + 2]
        if not is_led or tokens[i + 1].lower not in ("i", "we") or be.lower not in _AM_OR_HAVE:
            continue
        is_of_deed = tokens[i + 3].lower in OVER and any(t.tag == "VBG" for t in tokens[i + 4 : i + 5])
        if (i and tokens[i - 1].lower == "for") or is_of_deed:
            continue  # "keep some for when I'm back"; being done with talking is left to the models
        stop = next((j for j in range(i + 3, len(tokens)) if tokens[j].lower in MARKS | {"and", "then"}), len(tokens))
        is_free = tasks.keys().isdisjoint(range(i, stop)) and not _is_told(document, tasks, i)
        if is_free and stop > i + 3 and tokens[i + 3].tag not in ("VBG", "MD", "TO", "DT"):
            yield i + 2


def _of_listener(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "are" or "have" of every case of what the one spoken to is doing, right behind what is ordered, or is done
    with: "turn it off if *you're* not watching it", "if *you've* finished with it, ..."; not "if you're done"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-3]):
        if token.lower != "if" or tokens[i + 1].lower != "you" or tokens[i + 2].lower not in _ARE_OR_HAVE:
            continue
        said = next((t for t in tokens[i + 3 :] if t.lower not in _NOT and t.tag != "RB"), token)
        is_over = said.lower in ("finished", "done") and [t.lower for t in tokens[said.i + 1 : said.i + 2]] == ["with"]
        is_doing = said.tag == "VBG" and said.lower not in _PLANNING and tokens[i + 2].lemma != "have"
        stop = next((j for j in range(i + 1, len(tokens)) if tokens[j].text in MARKS), len(tokens))
        is_free = tasks.keys().isdisjoint(range(i, stop)) and not _is_told(document, tasks, i)
        if is_free and (is_over or (is_doing and _is_behind_order(document, tasks, i))):
            yield i + 2


def _of_that(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "is" of every case, right behind what is ordered, of what has become of something that is pointed at: "hand
    me another if *that's* broken"; not "if that's needed"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-3]):
        is_that = token.lower == "if" and tokens[i + 1].lower == "that" and tokens[i + 2].lower in _BE_OR_HAVE
        behind = tokens[i + 4 : i + 5]
        is_state = tokens[i + 3].tag == "VBN" and tokens[i + 3].lemma not in _APPROVING
        is_whole = not behind or behind[0].text in MARKS
        if is_that and is_state and is_whole and _is_behind_order(document, tasks, i) and i + 3 not in tasks:
            yield i + 2


def _is_behind_order(document: Document, tasks: Mapping[int, str], opener: int) -> bool:
    """Whether a case stands behind an order of its sentence, without a mark between."""
    before = max((i for i in tasks if i < opener), default=None)
    if before is None or tasks[before] in ("check_state", "informing"):
        return False
    return all(token.text not in MARKS for token in document.tokens[before:opener])


def _happenings(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "be" of every case of what happens to be so: "if there happens to *be* a letter"."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-3]):
        if token.lower not in ("happens", "happen") or [t.lower for t in tokens[i + 1 : i + 3]] != ["to", "be"]:
            continue
        opener = next((j for j in range(i - 1, max(-1, i - _LONGEST), -1) if tokens[j].lower in _OPENING), None)
        if opener is not None and tasks.keys().isdisjoint(range(opener, i + 3)):
            yield i + 2


def _doubts(document: Document, tasks: Mapping[int, str]) -> Iterator[int]:
    """The "is" or "has" of what the speaker does not know, where an "if so" or "if not" right behind goes by it: "I've
    no idea whether *there's* bread. If not, ..."."""
    tokens = document.tokens
    for i, token in enumerate(tokens[:-2]):
        if token.lower not in ("if", "whether") or i == 0:
            continue
        first = next((j + 1 for j in range(i - 1, -1, -1) if tokens[j].text in MARKS), 0)
        stop = next((j for j in range(i, len(tokens)) if tokens[j].text in MARKS), len(tokens))
        is_unknown = _UNKNOWING & {t.lemma for t in tokens[first:i]} and not tasks.keys() & set(range(first, stop))
        behind = tuple(t.lower for t in tokens[stop + 1 : stop + 3])
        be = _be(document, range(i + 1, stop)) if is_unknown and behind in _GOING_BY else None
        if be is not None:
            yield be


def _is_named_subject(document: Document, words: range) -> bool:
    named = document.tokens[words.start : words.stop]
    is_named = any(t.pos in ("NOUN", "PROPN") for t in named) or named[0].lower in _PERSONS
    return is_named and named[0].lower not in _UNNAMED and _TRIED.isdisjoint(t.lemma for t in named)


def without_cases(
    document: Document, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments but for those that tasks ahead of such a case have in it: "inform Tom *in the event that* ..." has
    no message, nor has "sing to Mia *if she cries*"."""
    checks = {i for i, kind in tasks.items() if kind == "check_state"}
    cases = [case for case in certain_cases(document) if not checks.isdisjoint(case.words)]
    kept = [
        a
        for a in arguments
        if not any(a.owner < case.words.start <= a.tokens.stop - 1 <= case.words[-1] for case in cases)
    ]
    for _, who, verb in expectations(document):
        if tasks.get(verb) == "check_state":
            kept = [a for a in kept if set(a.tokens).isdisjoint(who)]
            kept.append(FoundArgument("object", verb, who, CERTAIN))
    for owner, words, check in _performed(document, tasks):
        ahead = [a for a in kept if a.owner != owner or a.tokens.start < words.start]
        kept = [
            replace(a, tokens=range(a.tokens.start, words.start)) if a.owner == owner and words.start in a.tokens else a
            for a in ahead
        ]
        told = {"object": range(words.start + 1, check), "state": range(check + 1, words.stop)}
        is_be = document.tokens[check].lower in _BE_OR_HAVE and document.tokens[words.stop - 1].tag in ("JJ", "VBN")
        if is_be and not any(a.owner == check for a in kept):
            kept += [FoundArgument(name, check, tokens, CERTAIN) for name, tokens in told.items()]
    return kept


def _is_untold(document: Document, case: CertainCase, tasks: Mapping[int, str]) -> bool:
    """Whether no word up to the verb of a case is a task, and no check further on; not of how a task went."""
    if document.tokens[case.verb].lemma in _OF_TASKS:
        return False
    is_told = any(i in tasks for i in range(case.words.start, case.verb + 1))
    return not is_told and all(tasks.get(i) != "check_state" for i in case.words)


def _be(document: Document, clause: range) -> int | None:
    """The "is" or "has" behind the subject of a clause, where something is said behind it."""
    tokens = document.tokens
    subject = range(clause.start, min(clause.stop - 1, clause.start + _LONGEST))
    be = next((i for i in subject if i > clause.start and tokens[i].lower in _BE_OR_HAVE), None)
    if be is None or tokens[clause.start].lower in _UNNAMED:
        return None
    if tokens[clause.start].lower != "there":
        return be if _is_named_subject(document, range(clause.start, be)) else None
    named = tokens[be + 1 : clause.stop]
    used = {i for use in uses(document) for i in use.words}
    is_named = all(t.tag != "TO" or t.i in used for t in named)  # not "if there's nothing to sort out"
    return be if be == clause.start + 1 and is_named and _TRIED.isdisjoint(t.lemma for t in named) else None


def _is_told(document: Document, tasks: Mapping[int, str], opener: int) -> bool:
    """Whether the case is in the message of the order right before: "tell Ann, if the bus is late, to wait"."""
    before = max((i for i in tasks if i < opener), default=None)
    is_same = before is not None and document.sentences[before] == document.sentences[opener]
    is_same = is_same and not _is_of_another(document, opener)
    return is_same and before is not None and tasks[before] == "informing"


def _is_of_another(document: Document, opener: int) -> bool:
    """Whether the case says when somebody else is told or given something: "call Tom, *or Anna* if he's out"."""
    tokens = document.tokens
    joint = next((i for i in range(opener - 1, max(opener - _LONGEST, 0), -1) if tokens[i].lower == "or"), None)
    if joint is None:
        return False
    named = tokens[joint + 1 + (tokens[joint + 1].lower in ("to", "for", "else")) : opener]
    is_person = bool(named) and (named[-1].pos == "PROPN" or named[-1].lemma in PERSON_NOUNS)
    return is_person and tokens[joint - 1].text in MARKS and named[0].pos in ("PROPN", "DET", "PRON", "NOUN", "ADJ")
