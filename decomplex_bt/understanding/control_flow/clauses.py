"""Reading the clause around each task: the cues that open it, its negation, the state it tests, where it ends."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.control_flow.arcs import Wording
from decomplex_bt.understanding.control_flow.clause import AROUND, FINDING_OUT, Clause, MarkedTask
from decomplex_bt.understanding.control_flow.denials import WILLING, negations
from decomplex_bt.understanding.control_flow.events import is_event
from decomplex_bt.understanding.control_flow.openings import (
    ITS,
    OTHERWISE,
    STARTING,
    ability,
    allows,
    asks_open,
    calls_off,
    is_adverb,
    is_due_before_others,
    is_end,
    is_had_done,
    is_mere_contrast,
    is_on_arrival,
    is_past_idle,
    is_past_supposition,
    is_past_wait,
    is_waited_for,
    let_be,
    of_both,
    opens_matter,
    picks,
    says_in_vain,
    takes_up_case,
    tells_matter,
    tells_where,
    turns,
)
from decomplex_bt.understanding.control_flow.presence import presence_asked
from decomplex_bt.understanding.control_flow.skips import skipped
from decomplex_bt.understanding.control_flow.stretch import PUNCTUATION, Stretch
from decomplex_bt.understanding.control_flow.wording import (
    BEING,
    ECHOING,
    PERSONS,
    REFERRING,
    is_bare,
    is_of_somebody,
    wording,
)
from decomplex_bt.understanding.cue_phrases import ASKING_LEMMAS
from decomplex_bt.understanding.cues import Cue
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import head_of
from decomplex_bt.understanding.references.identity import identity_of
from decomplex_bt.understanding.references.phrases import nobody
from decomplex_bt.understanding.rules.background.guesses import guesses
from decomplex_bt.understanding.rules.cases.concessions import concessions
from decomplex_bt.understanding.rules.orders.prohibitions import is_elided, is_forbidden
from decomplex_bt.understanding.vocabulary import PERSON_NOUNS, WEEKDAYS

_DENYING = frozenset(("not", "n't", "nt"))
_CONTRACTED = frozenset(("'s", "'re"))
_AWAY = frozenset("away out off back".split())
_HAVE = frozenset(("have", "'ve"))
_ANY = frozenset(("any", "some", "one"))
_OF_KIND = frozenset(("a", "an", "another"))
_WHETHER = frozenset("if whether does do is are has have can could would will".split())
_CASES = frozenset(("if", "only_if", "unless", "when"))
_IT = ("this", "that", "it")
_ALL_OF_IT = frozenset((*(f"all {it}" for it in _IT), *(f"all of {it}" for it in _IT), *(f"{it} all" for it in _IT)))
_NONE_OF_IT = frozenset(
    (
        *(f"none of {it}" for it in _IT), *(f"skip all {it}" for it in _IT), *(f"skip all of {it}" for it in _IT),
        *(f"there 's no need for any of {it}" for it in _IT), *(f"do n't do any of {it}" for it in _IT),
        *(f"do n't bother with any of {it}" for it in _IT), "the whole thing 's off", "it 's all off", "it is all off",
    )
)  # fmt: skip
_TOO = frozenset(("either", "too"))
_INNER = frozenset(("still", "not", "can", "there", "also"))
_WAYS = frozenset(("back", "home", "out", "again"))
_TURNING_UP = frozenset("turn show pop".split())
_APPEARING = frozenset("surface appear reappear".split())
_NUMBERS = {"it": "one", "they": "many", "them": "many", "those": "many", "these": "many"}
_DEFINITE = frozenset("the my your his her our their this that these those".split())
_IS = frozenset(("is", "are", "'s", "be"))
_JOINING = frozenset(("and", "or", "of", "&"))
_DOING = frozenset(("do", "does", "did"))
_THINGS = frozenset("it they them that this those these one".split())
_PARTICLES = frozenset("on off up down out in".split())
_EMPTY = frozenset("at all properly fully for you , then".split())
_MOVING = frozenset(("come", "go", "turn", "switch", "move"))
_FITTING = frozenset(("fit", "stop", "find"))
_HAPPENING = frozenset(
    "open close shut start light flush pair work go come turn switch move budge lock unlock respond connect".split()
)


def clauses_of(observed: Observed, tasks: Sequence[MarkedTask]) -> tuple[Clause, ...]:
    """The clause of every task, in text order."""
    said = frozenset(j for task in tasks for _, indices in task.arguments for j in indices)
    clauses: list[Clause] = []
    for k in range(len(tasks)):
        clause = _clause(observed, tasks, k, said)
        clauses.append(_excepted(clause) if _is_excepted(clause, clauses) else clause)
    return tuple(clauses)


def _is_excepted(clause: Clause, before: Sequence[Clause]) -> bool:
    """Whether an "unless" before governs a clause as well: "unless it is wet or it is dark". What follows an "or if" is
    the consequence of that alone, unless the sentence began with the "unless"."""
    if not before or not clause.is_joined_check or not before[-1].is_check or clause.sentence != before[-1].sentence:
        return False
    is_first = len(before) == 1 or before[-2].sentence != clause.sentence
    is_joint = clause.opening in (("or",), ("and",)) or (
        clause.opening == ("or", "if") and (clause.ends_sentence or is_first)
    )
    return is_joint and (before[-1].is_excepted or "unless" in before[-1].near)


def _excepted(clause: Clause) -> Clause:
    """The clause as one under an "unless": unless A or B is if not A and not B, unless A and B if not A or not B."""
    wording = clause.wording
    joins = {"or": "and", "and": "or"}[clause.opening[0]]
    return replace(clause, is_excepted=True, wording=replace(wording, is_negated=not wording.is_negated, joins=joins))


def last_named(clauses: Sequence[Clause], k: int) -> Clause:
    """The last clause before `k`, at least 1, that names its object; the one right before where none does."""
    return next((clauses[j] for j in range(k - 1, -1, -1) if clauses[j].objects), clauses[k - 1])


def wordings_of(clauses: Sequence[Clause]) -> tuple[Wording, ...]:
    return tuple(clause.wording for clause in clauses)


def _clause(observed: Observed, tasks: Sequence[MarkedTask], k: int, said: frozenset[int]) -> Clause:
    """The clause of task `k`; `said`: the tokens of all arguments."""
    document, task, token = observed.document, tasks[k], tasks[k].token
    stretch = Stretch.around(observed, tasks, k, said)
    previous, following, split = stretch.previous, stretch.following, stretch.split
    first, own_last = stretch.first, stretch.own_last
    says_too = document.tokens[stretch.last].lower in _TOO
    far, near = stretch.names(previous, split + 1), stretch.names(split, token)
    behind = stretch.names(token, stretch.end)
    # "lock up but before that feed the cat": where no mark stands between, it belongs to what follows
    own = tuple(name for name in behind if not (stretch.is_open and name in ("before_that", "before_all")))
    ahead = [cue for cue in stretch.cues if previous < cue.first < token]
    is_joined = previous >= 0 and document.sentences[previous] == document.sentences[token]
    is_excluded = "unless" in near
    return Clause(
        task=task,
        first=first,
        last=stretch.last - says_too,
        far=far,
        near=near,
        behind=behind,
        sentence=document.sentences[token],
        boundary="start" if previous < 0 else (document.tokens[split].text if split > previous else "none"),
        wording=wording(observed, task, first, own_last, (far, near, own), is_joined),
        objects=tuple(_nouns(document, task, ("object",))),
        thing=_thing(document, task),
        nouns=frozenset(_nouns(document, task, [kind for kind, _ in task.arguments])),
        receivers=frozenset(_nouns(document, task, ("recipient", "goal"))),
        places=_places(document, task),
        has_pronoun=any(
            document.tokens[indices[-1]].lower in REFERRING for _, indices in task.arguments if len(indices)
        ),
        number=next((_number(document, indices) for kind, indices in task.arguments if kind == "object"), ""),
        covers=_covers(document, [cue for cue in ahead if cue.name in _CASES]),
        ends_sentence=following == len(document) or document.sentences[following] != document.sentences[token],
        is_asked=(observed.question[token] and _CASES.isdisjoint(near))  # not "could you close it *if it's open*?"
        or "whether" in behind
        or (
            document.tokens[token].tag == "VB"
            and document.tokens[token].lemma in ASKING_LEMMAS
            and (task.type != "check_state" or _CASES.isdisjoint(near))  # not "if he doesn't *know*"
        ),
        is_forbidden=is_forbidden(document, token),
        is_otherwise=any(
            cue.name == "else" and document.tokens[cue.first].lower in OTHERWISE and not is_adverb(document, cue.first)
            for cue in ahead
        ),
        is_of_somebody=is_of_somebody(document, task, PERSONS),
        is_of_person=is_of_somebody(document, task, PERSONS - {"they"}),
        asks_where=_asks_where(document, task, behind),
        says_absent=not is_excluded and _says_absent(observed, task, first, own_last),
        says_named_absent=not is_excluded and _says_absent(observed, task, first, own_last, is_named=True),
        says_undone=_says_undone(observed, task, previous, own_last, near),
        says_named_undone=_says_undone(observed, task, previous, own_last, near, is_named=True),
        says_only_whether=_says_only_whether(document, task, own_last),
        question=_question(document, task),
        is_of_it=is_of_somebody(document, task, ITS),
        says_there_is=task.type == "check_state" and token > 0 and document.tokens[token - 1].lower == "there",
        is_of_some=_is_of_some(document, task),
        verb=document.tokens[token].lemma,
        is_of_nobody=bool(nobody(document, token)),
        is_of_weather=_is_of_weather(document, task, first, own_last),
        ways=frozenset(t.lower for t in document.tokens[token + 1 : own_last + 1] if t.lower in _WAYS),
        opening=tuple(
            cue.name
            for cue in stretch.cues
            if split < cue.first < token and cue.first not in said and cue.name not in _INNER
        ),
        calls_off=task.type == "check_state" and calls_off(document, previous, token, following, far + near),
        skips=skipped(document, previous, token, following) if task.type == "check_state" else frozenset(),
        is_new_matter=previous >= 0
        and ((not is_joined and opens_matter(document, token)) or tells_matter(document, previous, token)),
        allows=task.type == "check_state" and allows(document, token, following, far + near),
        is_had_done=is_had_done(document, stretch.cues, token),
        said_state=_said_state(document, task),
        asks_open=task.type in FINDING_OUT and "if" not in near and asks_open(document, token),
        ability=ability(document, ahead, token),
        is_in_vain=says_in_vain(ahead, document),
        is_only_then=any(cue.name == "then" and document.tokens[cue.first].lower == "only" for cue in ahead),
        is_unwilling=_is_unwilling(observed, task, first, own_last),
        says_too=says_too,
        says_still="still" in near or any(t.lower == "still" for t in document.tokens[first : own_last + 1]),
        identified=_identified(document, task),
        says_instead=task.type == "check_state" and any(cue == "instead" for cue in (*near, *own)),
        forbids_order=any(is_elided(document, i) for i in range(token + 1, following)),
        is_past_idle=is_past_idle(observed, previous, split, token),
        is_either_way=any(previous < words.start < token for words in concessions(document)),
        is_past_guess=any(document.sentences[w.start] == document.sentences[token] - 1 for w in guesses(document)),
        is_mere_contrast=(task.type != "check_state" or is_due_before_others(document, token))
        and is_mere_contrast(document, token),
        is_waited_for=is_waited_for(document, ahead, token),
        is_end=is_end(document, ahead, token),
        says_already=task.type == "check_state"
        and any(t.lower == "already" for t in document.tokens[first : own_last + 1]),
        picks=picks(document, token),
        tells_where=task.type == "check_state" and tells_where(document, token),
        is_and_then=any(
            document.tokens[cue.last].lower == "then" and document.tokens[cue.last - 1].lower == "and" for cue in ahead
        ),
        removes=any(t.lower in _AWAY for t in document.tokens[token + 1 : own_last + 1]),
        is_of_any=is_of_somebody(document, task, _ANY),
        lets_be=let_be(document, token) if task.type == "check_state" else "",
        is_of_kind=_begins_with(document, task, _OF_KIND),
        names_any=_begins_with(document, task, _ANY),
        turns=turns(document, ahead, token),
        is_then=document.tokens[stretch.last].lower == "then",
        case=takes_up_case(document, previous, token),
        is_on_arrival=is_on_arrival(document, previous, token),
        of_both=of_both(document, previous, token, own_last if task.type in FINDING_OUT else token - 1),
        is_urged=[t.lower for t in document.tokens[max(0, token - 2) : token]] == ["but", "do"],
        is_reminder=[t.lower for t in document.tokens[max(0, token - 2) : token]] == ["forget", "to"],
        is_past_wait=is_past_wait(document, previous, token),
        is_past_supposition=task.type == "check_state" and is_past_supposition(document, token),
        presence=presence_asked(
            document, task, is_negated="not" in near or bool(negations(observed, token, first, own_last))
        ),
        is_event=is_event(document, ahead, task),
        turns_up=task.type == "check_state" and _turns_up(document, task),
        is_had=_is_had([t.lower for t in document.tokens[previous + 1 : token]]),
    )


def _begins_with(document: Document, task: MarkedTask, words: Collection[str]) -> bool:
    """Whether one of some words begins an object of more than that word."""
    things = [indices for kind, indices in task.arguments if kind == "object" and len(indices) > 1]
    return any(document.tokens[indices[0]].lower in words for indices in things)


def _turns_up(document: Document, task: MarkedTask) -> bool:
    verb, behind = document.tokens[task.token], document.tokens[task.token + 1 : task.token + 2]
    is_up = verb.lemma in _TURNING_UP and bool(behind) and behind[0].lower == "up"
    return (is_up or verb.lemma in _APPEARING) and is_of_somebody(document, task, ITS | PERSONS)


def _is_had(words: Sequence[str]) -> bool:
    """Whether words say to wait until something is in hand: "once you have it", "when you've got them"."""
    for you in (i for i, word in enumerate(words) if word == "you"):
        have, *behind = [word for word in words[you + 1 : you + 4] if word not in ("got", "found")] or [""]
        is_led = words[you - 1 : you] in (["once"], ["when"]) or words[max(0, you - 3) : you] == ["as", "soon", "as"]
        if is_led and have in _HAVE and behind[:1] in (["it"], ["them"], ["one"]):
            return True
    return False


def _identified(document: Document, task: MarkedTask) -> str:
    if task.type != "check_state":
        return ""
    identity = identity_of(document, task.token)
    if identity is not None:
        return document.tokens[identity.name.stop - 1].lemma if identity.is_pronoun(document) else ""
    around = document.tokens[max(0, task.token - 1) : task.token + 2]
    is_name = len(around) == 3 and around[0].lower in ITS and around[1].lower in _IS and around[2].tag == "NNP"
    return around[2].lemma if is_name and around[2].lower not in WEEKDAYS else ""


def _says_only_whether(document: Document, task: MarkedTask, last: int) -> bool:
    is_denied = task.token < last and document.tokens[task.token + 1].lower in _DENYING
    return is_bare(document, task, last, ECHOING | _DENYING | (_CONTRACTED if is_denied else frozenset()))


def _is_of_weather(document: Document, task: MarkedTask, first: int, last: int) -> bool:
    is_of_it = not _nouns(document, task, ("object", "location"))
    words = {token.lower for token in document.tokens[first : last + 1]}
    return task.type == "check_state" and is_of_it and not words.isdisjoint(WEATHER)


def _places(document: Document, task: MarkedTask) -> frozenset[str]:
    tokens = [document.tokens[j] for kind, indices in task.arguments if kind in ("source", "location") for j in indices]
    return frozenset(t.lemma for t in tokens if t.pos in ("NOUN", "PROPN") or t.lower in AROUND)


def _nouns(document: Document, task: MarkedTask, kinds: Collection[str]) -> list[str]:
    """The nouns, as lemmas, of a task's arguments of some kinds."""
    indices = [j for kind, indices in task.arguments if kind in kinds for j in indices]
    return [document.tokens[j].lemma for j in indices if document.tokens[j].pos in ("NOUN", "PROPN")]


def _thing(document: Document, task: MarkedTask) -> frozenset[str]:
    tokens = [document.tokens[j] for kind, indices in task.arguments if kind == "object" for j in indices]
    return frozenset(token.lemma for token in tokens if token.pos not in ("DET", "ADP", "PUNCT"))


def _is_sought(document: Document, indices: range) -> bool:
    """Whether something of a certain kind is meant, no certain thing: "clean towels", "a free chair"."""
    tokens = [document.tokens[j] for j in indices]
    return any(token.pos == "ADJ" for token in tokens) and tokens[0].lower not in _DEFINITE


def _asks_where(document: Document, task: MarkedTask, behind: Sequence[str]) -> bool:
    kinds = {kind for kind, _ in task.arguments}
    if any(kind == "object" and _is_sought(document, indices) for kind, indices in task.arguments):
        return False  # "are there clean towels in the bathroom?" asks how they are as well
    is_asked = document.tokens[task.token].lemma in BEING or "whether" in behind
    return task.type == "check_state" and "location" in kinds and "state" not in kinds and is_asked


def _number(document: Document, indices: range) -> str:
    """Whether an object is one thing or many; open of people, who may be "they" one by one."""
    tokens = [document.tokens[j] for j in indices]
    if len(tokens) == 1 and tokens[0].lower in _NUMBERS:
        return _NUMBERS[tokens[0].lower]
    head = document.tokens[head_of(document, indices)]
    if _is_sought(document, indices):  # "clean towels ... if they're all dirty"
        return ""
    if head.lemma in PERSON_NOUNS or head.pos != "NOUN" or any(token.lower in _JOINING for token in tokens):
        return ""
    return {"NN": "one", "NNS": "many"}.get(head.tag, "")


def _is_of_some(document: Document, task: MarkedTask) -> bool:
    said = [[document.tokens[j].lower for j in indices] for kind, indices in task.arguments if kind == "object"]
    return any(words[-2:] in (["of", "them"], ["of", "these"], ["of", "those"]) for words in said)


def _covers(document: Document, openings: Sequence[Cue]) -> str:
    """Whether words like "all this" stand before the word that opens a condition, at the beginning of a clause."""
    if len(openings) != 1:
        return ""
    stop = openings[0].first
    words = [token.lower for token in document.tokens[max(0, stop - 6) : stop]]
    words = words[next((i + 1 for i in range(len(words) - 1, -1, -1) if words[i] in STARTING), 0) :]
    said = " ".join(words)
    if said in _ALL_OF_IT:
        return "-" if openings[0].name == "unless" else "+"
    return "-" if said in _NONE_OF_IT and openings[0].name != "unless" else ""


def _says_absent(observed: Observed, task: MarkedTask, first: int, last: int, *, is_named: bool = False) -> bool:
    said = {kind: [observed.document.tokens[j].lower for j in indices] for kind, indices in task.arguments}
    is_being = observed.document.tokens[task.token].lower in _IS or observed.document.tokens[task.token].lemma in BEING
    thing = said.get("object", [""])
    is_of_it = thing[0] in _DEFINITE if is_named else REFERRING.issuperset(thing)
    is_check = task.type == "check_state" and is_being and "state" not in said
    return is_check and is_of_it and bool(negations(observed, task.token, first, last))


def _says_undone(
    observed: Observed, task: MarkedTask, previous: int, last: int, near: Sequence[str], *, is_named: bool = False
) -> bool:
    tokens = observed.document.tokens
    things = [indices for kind, indices in task.arguments if kind in ("object", "goal", "source", "location")]
    if is_named:
        is_of_it = len(things) == 1 and tokens[things[0].start].lower in _DEFINITE and things[0].stop <= task.token
    else:
        is_of_it = len(things) <= 1 and all(tokens[j].lower in _THINGS for indices in things for j in indices)
    if not is_of_it:
        return False
    first = next((j for j in range(task.token - 1, previous, -1) if tokens[j].text in PUNCTUATION), previous) + 1
    words = [token.lower for token in tokens[first : task.token]]
    # "it doesn't" is a cue for a failure in itself
    is_denied = "fail" in near or bool(negations(observed, task.token, first, last))
    behind = {token.lower for token in tokens[task.token + 1 : last + 1]}
    if "still" in words or not is_denied or not behind <= _PARTICLES | _EMPTY:
        return False
    lemma = tokens[task.token].lemma
    if lemma in _MOVING and behind.isdisjoint(_PARTICLES):
        return False  # "if they don't come"
    if not WILLING.isdisjoint(words):
        return lemma not in _FITTING
    return not _DOING.isdisjoint(words) and lemma in _HAPPENING


def _is_unwilling(observed: Observed, task: MarkedTask, first: int, last: int) -> bool:
    tokens = observed.document.tokens
    is_willed = any(token.lower in WILLING for token in tokens[first : task.token])
    is_check = task.type == "check_state" and is_of_somebody(observed.document, task, PERSONS)
    return is_check and is_willed and bool(negations(observed, task.token, first, last))


def _question(document: Document, task: MarkedTask) -> frozenset[str]:
    messages = [indices for kind, indices in task.arguments if kind == "message" and len(indices)]
    if task.type != "informing" or not messages or document.tokens[messages[0].start].lower not in _WHETHER:
        return frozenset()
    return frozenset(word for j in messages[0] for word in (document.tokens[j].lemma, document.tokens[j].lower))


def _said_state(document: Document, task: MarkedTask) -> tuple[str, ...]:
    """The words of the state argument of a check."""
    said = [j for kind, indices in task.arguments if kind == "state" for j in indices]
    return tuple(document.tokens[j].lower for j in said)
