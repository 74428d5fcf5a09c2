"""Tasks as English settles them: `corrected` applies the facts here, the idioms, the asides and the wishes."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise, zip_longest

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.document import ENDS, MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.looks import looks, shouts
from decomplex_bt.understanding.references.phrases import degree_asked
from decomplex_bt.understanding.references.relatives import found_places
from decomplex_bt.understanding.rules.background.accounts import accounts
from decomplex_bt.understanding.rules.background.hearsay import is_hearsay
from decomplex_bt.understanding.rules.background.plans import is_planned
from decomplex_bt.understanding.rules.background.purposes import purposes
from decomplex_bt.understanding.rules.cases.checks import is_gerund, whole_state
from decomplex_bt.understanding.rules.cases.concessions import either_way
from decomplex_bt.understanding.rules.cases.conditions import untold
from decomplex_bt.understanding.rules.cases.deeds_of_others import deeds_of_others
from decomplex_bt.understanding.rules.cases.echoes import echoes
from decomplex_bt.understanding.rules.cases.mishaps import mishaps
from decomplex_bt.understanding.rules.cases.perfects import (
    are_gone,
    is_asked_done,
    is_denied_of_others,
    is_done_by_others,
    passive_participle,
    perfect_participle,
    told_by,
)
from decomplex_bt.understanding.rules.cases.precautions import precautions
from decomplex_bt.understanding.rules.cases.preferences import is_wished, preferences
from decomplex_bt.understanding.rules.cases.questions import is_deliberated, questions
from decomplex_bt.understanding.rules.cases.waits import forgone, postponed
from decomplex_bt.understanding.rules.ellipses.pro_verbs import pro_verbs
from decomplex_bt.understanding.rules.ellipses.second_cases import second_cases
from decomplex_bt.understanding.rules.ellipses.sequels import sequels
from decomplex_bt.understanding.rules.ellipses.telegraph import telegraphed
from decomplex_bt.understanding.rules.ellipses.unspoken import unspoken
from decomplex_bt.understanding.rules.ellipses.verbless import verbless_cases
from decomplex_bt.understanding.rules.orders.assistance import helping_hands
from decomplex_bt.understanding.rules.orders.assurances import assured_lists, is_assured, is_assured_too
from decomplex_bt.understanding.rules.orders.calls import is_sent_for
from decomplex_bt.understanding.rules.orders.causatives import causative_types, without_tasks
from decomplex_bt.understanding.rules.orders.deeds import forms
from decomplex_bt.understanding.rules.orders.doors import admitted, is_answered
from decomplex_bt.understanding.rules.orders.fronting import fronted
from decomplex_bt.understanding.rules.orders.handing import payee
from decomplex_bt.understanding.rules.orders.idioms import (
    encountered,
    for_somebody,
    idiomatic,
    is_heard,
    is_light,
    prospect_of,
)
from decomplex_bt.understanding.rules.orders.loading import loading
from decomplex_bt.understanding.rules.orders.needs import needed, needs_of
from decomplex_bt.understanding.rules.orders.omissions import omitted
from decomplex_bt.understanding.rules.orders.pauses import pauses
from decomplex_bt.understanding.rules.orders.prohibitions import is_elided, is_left_alone, let_be
from decomplex_bt.understanding.rules.orders.puttings import LAYING, is_put_on, is_put_somewhere, is_the_table
from decomplex_bt.understanding.rules.orders.reports import orders_behind, within_reports
from decomplex_bt.understanding.rules.orders.resuming import resumed
from decomplex_bt.understanding.rules.orders.wishes import is_background, is_served, is_taken_up
from decomplex_bt.understanding.rules.speech.asides import (
    concession,
    is_explained,
    means,
    musing,
    reason,
    tag_question,
    tagged,
)
from decomplex_bt.understanding.rules.speech.contractions import reports
from decomplex_bt.understanding.tasks import FoundTask

_HANDLING = frozenset(("taking", "placing", "bringing", "change_state"))
_NEAR_DOWN = 4
"""Within so many words behind "set" stands the "down" by which something is put down [tokens]."""
_BE = frozenset(("be", "been", "'s", "is", "are", "'re", "re", "s"))
_SOME = frozenset("any some enough anything".split())
_MANNERS = frozenset("all both also actually still always really properly firmly securely definitely fully".split())
_IS_OR_HAS = frozenset(("'s", "\u2019s"))
_TIDYING = frozenset(("clear", "tidy", "clean", "wash"))
_ASKING = frozenset("check see verify confirm look find".split())
_CLAUSE_ENDS = ENDS | frozenset((",", ":", "and", "or", "but"))
_NOT = frozenset("not n't n\u2019t nt".split())
_CAN = frozenset("ca can could".split())
_MISSING = frozenset("i we and but so still just oh well sorry hey robot".split())
"""What may stand ahead of a "can't find", beside a mark."""
_CASES = frozenset("if unless when only_if until before after".split())
_NAMED = ("RB", "DT", "PRP$", "JJ", "NN", "NNP", "NNS")
_DRAWING = frozenset("drop lower raise pull let draw".split())
_COVERINGS = frozenset("blind shade shutter curtain drape".split())
_FAVOURS = frozenset("favour favor kindness".split())
_BESIDE_FAVOURS = _FAVOURS | frozenset("me us the a an of and to by please , big huge great".split())
_LOOKS = frozenset(("check_state", "searching"))


def corrected(observed: Observed, tasks: Sequence[FoundTask], types: Collection[str]) -> tuple[FoundTask, ...]:
    """The tasks, in text order, brought in line with the facts; `types`: those that there are."""
    document = observed.document
    types_found = {task.token: task.type for task in tasks}
    found: list[FoundTask] = []
    called = {shout.verb for shout in shouts(document)}
    looked = {look.verb: look.words for look in looks(document)}
    tasks = [
        task
        for task in _with_passives(document, _with_tagged(document, tasks))
        if not _is_genitive(document, looked.values(), task.token)
    ]
    asked = {question.verb: question for question in questions(document, types_found)}
    idle = (forgone(document) | let_be(document) | without_tasks(observed) | omitted(observed)).union(
        *pauses(document), *helping_hands(document), *found_places(document)
    )
    within_others = within_reports(document, types_found) | precautions(document, types_found)
    within_others |= purposes(document, types_found) | accounts(document, types_found)
    others = list(deeds_of_others(document))
    within_others = within_others.union(*(deed.idle for deed in others))
    within_others = within_others.union(*(sequel.words for sequel in sequels(observed, types_found)))
    within_others = within_others.union(*(question.tokens for question in asked.values()))
    for task, following in zip_longest(tasks, tasks[1:]):
        end = len(document) if following is None else following.token
        if task.token in asked:
            question = asked[task.token]
            is_of_somebody = document.tokens[question.tokens.start].lower == "who"
            is_told = not is_of_somebody and (question.place or question.state) and task.type != "searching"
            task = replace(task, type="check_state" if is_told else "searching")
        is_too = task.type == "check_state" and bool(found) and is_assured_too(document, task.token, found[-1].token)
        fact = "change_state" if is_too else _type(observed, task, end)
        token = told_by(document, task.token) if task.type == "check_state" else task.token
        if fact in types and token < end and (not found or found[-1].token < token):
            task = replace(task, type=fact, token=token)
        if task.type in _HANDLING and task.token in (*looked, *called):
            task = replace(task, type="searching" if task.token in looked else "informing")
        if task.type == "motion" and document.tokens[task.token].lemma == "use":
            task = replace(task, type="placing" if any(one.type == "placing" for one in found) else task.type)
        if task.type == "informing" and document.tokens[task.token].lemma == "feed":
            task = replace(task, type="change_state")
        going_on = resumed(observed, task.token) if task.type != "check_state" else None
        if going_on is not None and going_on[0] <= end:
            task = replace(task, token=going_on[0], type=going_on[1])
        if _asks_got(document, task.token) or any(deed.verb == task.token for deed in others):
            task = replace(task, type="check_state")
        if (be := prospect_of(document, task.token)) is not None:
            task = replace(task, token=be, type="check_state")
        if following is not None and is_light(document, task.token, following.token):
            task = replace(task, type=following.type)
        is_none = (
            task.token in within_others
            or _is_reported_state(document, task, found)
            or _is_tag(document, task.token, found)
            or musing(document, task.token) is not None
            or means(document, task.token, types_found) is not None
            or (following is not None and _is_wish_for(document, task, following))
            or (task.type in _HANDLING and is_taken_up(document, task.token, types_found))
            or (bool(found) and _is_progressive(document, found[-1], task))
            or (bool(found) and _is_left_of(document, found[-1], task))
            or (bool(found) and _is_had(document, found[-1], task))
            or (following is not None and _is_with_see(document, task.token, following.token))
            or (following is not None and _is_beginning(document, task.token, following.token))
            or (following is not None and _is_favour(document, task.token, following.token))
            or _is_event(document, task.token)
            or (bool(found) and is_light(document, found[-1].token, task.token))
            or (following is not None and is_background(document, task.token, following.token, following.type))
            or (task.type == "check_state" and _is_beside(document, task.token))
            or either_way(document, task.token) is not None
            or is_elided(document, task.token)
            or is_left_alone(document, task.token, [i for i, kind in types_found.items() if kind not in _LOOKS])
            or is_planned(document, task.token, types_found)
            or is_hearsay(document, task.token)
            or is_deliberated(document, task.token)
            or is_explained(document, task.token)
            or task.token in idle
            or (bool(found) and found[-1].token >= task.token)
            or _is_joined_state(document, task.token, types_found)
            or (bool(found) and _is_of_case(document, found[-1], task))
            or _is_name(observed, task.token)
            or (not found and following is not None and _is_missed(observed, task))
        )
        if not is_none:
            found.append(task)
    return _with_idioms(observed, found, types)


def _is_progressive(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a verb says what somebody is doing where that is a check: "if Dad *is* still *mowing* the lawn", or who
    somebody is ("if it's Tom *bringing* the keys")."""
    is_check = check.type == "check_state" != task.type and document.tokens[check.token].lower in _BE
    between = document.tokens[check.token + 1 : task.token]
    is_of_it = check.token > 0 and document.tokens[check.token - 1].lower in ("it", "that")
    known = _NAMED if is_of_it else ("RB",)
    is_doing = is_gerund(document.tokens[task.token])
    said = document.tokens[task.token].lower  # "it's proper chucking it down", not "if it's warm pour me one"
    is_doing = is_doing or (is_of_it and said in WEATHER and said.endswith("ing"))
    return is_check and is_doing and all(token.tag in known for token in between)


def _asks_got(document: Document, at: int) -> bool:
    """Whether a "got" that begins a sentence asks if there is something: "*got* any bread left?"."""
    tokens = document.tokens
    is_first = at == 0 or tokens[at - 1].text in ENDS or document.sentences[at - 1] != document.sentences[at]
    return is_first and tokens[at].lower == "got" and at + 1 < len(tokens) and tokens[at + 1].lower in _SOME


def _is_left_of(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a "left" only says that there is still some of what is asked after: "got any bread *left*", "do we have
    some bread *left*"."""
    between = document.tokens[check.token + 1 : task.token]
    is_had = document.tokens[check.token].lower == "have" and any(token.lower in _SOME for token in between)
    is_left = document.tokens[task.token].lower == "left" and (is_had or _asks_got(document, check.token))
    return is_left and all(token.text not in MARKS and not token.tag.startswith("V") for token in between)


def _is_had(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a noun is what a thing is asked to have: "if the pie has *nuts* in it"."""
    tokens = document.tokens
    is_having = check.type == task.type == "check_state" and tokens[check.token].lower in ("has", "have")
    between = tokens[check.token + 1 : task.token]
    return is_having and tokens[task.token].pos == "NOUN" and all(t.pos in ("DET", "ADJ", "NOUN") for t in between)


def _is_genitive(document: Document, looked: Collection[range], at: int) -> bool:
    """Whether a "'s" is none of a check: "have a butcher's"."""
    return document.tokens[at].lower in _IS_OR_HAS and any(at in words for words in looked)


def _with_passives(document: Document, tasks: Sequence[FoundTask]) -> Sequence[FoundTask]:
    """The tasks, those next to each other that are one check ("has *been* *put* away", "*has* *put* it", "*did* *eat*
    it") as one."""
    kept = list(tasks)
    for task, following in pairwise(tasks):
        is_denied = following.token == task.token + 2 and is_denied_of_others(document, following.token)
        is_next = following.token == task.token + 1 and following.type == "check_state"
        if task.type == "check_state" and is_next and _is_over(document, task.token):
            kept.remove(following)
            continue
        is_did = following.token == task.token + 1 and document.tokens[task.token].lower in ("do", "does", "did")
        if task.type == "check_state" and (is_denied or (is_did and following.type == "check_state")):
            kept.remove(task)
        if task.type == "check_state" and following.token in (
            passive_participle(document, task.token),
            perfect_participle(document, task.token),
        ):
            kept[kept.index(following)] = replace(following, type="check_state")
            kept.remove(task)
    return kept


def _with_tagged(document: Document, tasks: Sequence[FoundTask]) -> Sequence[FoundTask]:
    """The tasks, those carried by a tag question without a comma by the "is" of its statement: "the tap*'s* on isn't
    it?"."""
    taken = {task.token for task in tasks}
    moved = {task.token: tagged(document, task.token) for task in tasks if task.type == "check_state"}
    return [
        task if (be := moved.get(task.token)) is None or taken & {*range(be, task.token)} else replace(task, token=be)
        for task in tasks
    ]


def _is_over(document: Document, at: int) -> bool:
    """Whether a verb says that what the next one does is over, or begun: "has it *finished* proving?"."""
    tokens = document.tokens
    is_told = tokens[at].lemma in ("finish", "stop", "start", "begin", "quit", "keep")
    return is_told and at + 1 < len(tokens) and tokens[at + 1].tag == "VBG"


def _with_idioms(observed: Observed, tasks: Sequence[FoundTask], types: Collection[str]) -> tuple[FoundTask, ...]:
    """The tasks with those that are idioms, needs, telegraphed or fragments, and without other words of these ("might
    be *switched*")."""
    document, found = observed.document, {task.token: task.type for task in tasks}
    later = postponed(observed, found)
    told = {**telegraphed(observed, found), **needed(observed, found), **idiomatic(document, {**found, **later})}
    told |= {i: observed.senses[i][0] for i in orders_behind(document, found) if observed.senses[i]}
    told |= {report.verb: "informing" for report in reports(document, found)}
    told |= causative_types(observed)
    told |= {i: "informing" for i, *_ in shouts(document) if document.tokens[i].lower == "gimme" and i not in found}
    told |= {**later, **{i: verb.type for i, verb in pro_verbs(observed, found).items()}}
    idioms = {i: type for i, type in told.items() if type in types}
    behind = {i + 1 for i in idioms if i + 1 < len(document) and document.tokens[i + 1].tag == "VBN"}
    behind |= needs_of(observed, (*found, *idioms))
    for fragment in list(unspoken(observed, {**found, **idioms})):
        behind.update(fragment.tokens)
        idioms[fragment.carrier] = fragment.type
    for case in second_cases(document):
        behind.update(case.tokens)
        idioms[case.carrier] = case.type
    for listed in assured_lists(document):
        behind.update(range(listed[0].thing.start, listed[-1].state.stop))
        idioms |= {one.carrier: "change_state" for one in listed}
    for case in verbless_cases(observed, found):  # an adjective is no order: "wash it when *dirty*"
        if case.carrier not in found or document.tokens[case.carrier].pos == "ADJ":
            idioms[case.carrier] = case.type
    idioms |= {order.verb: order.type for order in fronted(observed) if order.verb not in found}
    taken_up = list(echoes(document, found).values())
    idioms |= {echo.verb: "check_state" for echo in taken_up if echo.asks}
    undone = [echo.verb for echo in taken_up if not echo.asks and echo.verb not in found]
    idioms |= {verb: next(iter(observed.senses[verb])) for verb in undone if observed.senses[verb]}
    idioms |= {told_by(document, be): "check_state" for be in untold(document, {**found, **idioms})}
    idioms |= {mishap.verb: "check_state" for mishap in mishaps(document)}
    for wish in preferences(document, found):
        behind.update(wish.words)
        idioms[wish.check] = "check_state"
    kept = [task for task in tasks if task.token not in behind | idioms.keys()]
    added = [FoundTask(i, type, 1.0) for i, type in idioms.items()]
    return tuple(sorted([*kept, *added], key=lambda task: task.token))


def _is_beginning(document: Document, verb: int, gerund: int) -> bool:
    """Whether a verb only says to begin what the one behind it orders: "*start* cooking the rice"."""
    is_begun = document.tokens[verb].lemma in ("start", "begin") and document.tokens[verb].tag in ("VB", "VBP")
    return is_begun and gerund == verb + 1 and is_gerund(document.tokens[gerund])


def _is_covering(said: Sequence[Token]) -> bool:
    """Whether the first thing named is what covers a window, and no place for it: "drop *the blinds*"."""
    noun = next((i for i, token in enumerate(said) if token.pos in ("NOUN", "PROPN")), len(said))
    behind = said[noun + 1].lower if noun + 1 < len(said) else ""
    return noun < len(said) and said[noun].lemma in _COVERINGS and behind not in ("on", "onto", "into", "off")


def _is_favour(document: Document, verb: int, order: int) -> bool:
    """Whether a verb only says that the order behind it would be kind: "*do* me the favour of heating it", "would you
    mind if I *asked* you to heat it"."""
    tokens = document.tokens
    words = [token.lower for token in tokens[verb + 1 : order]]
    is_favour = tokens[verb].lemma in ("do", "make") and not _FAVOURS.isdisjoint(words)
    ahead = [token.lower for token in tokens[max(0, verb - 3) : verb]]
    is_asked = tokens[verb].lemma == "ask" and ahead[-2:] in (["if", "i"], ["if", "we"]) and ahead[:1] == ["mind"]
    return (is_favour and _BESIDE_FAVOURS.issuperset(words)) or (is_asked and words == ["you", "to"])


def _is_event(document: Document, at: int) -> bool:
    """Whether a noun only tells before or after what something is done: "bring it before my telephone *call*"."""
    tokens = document.tokens
    if tokens[at].tag != "NN" or tokens[at].lower.endswith("ing"):
        return False
    start = at
    while start and tokens[start - 1].pos in ("NOUN", "PROPN", "ADJ"):
        start -= 1
    is_named = start > 1 and (tokens[start - 1].tag == "PRP$" or tokens[start - 1].lower in ("the", "a", "an"))
    return is_named and tokens[start - 2].lower in ("before", "after", "during")


def _is_with_see(document: Document, verb: int, see: int) -> bool:
    """Whether a verb is one with the "see" behind it: "*check* to see if", "*look* and see whether", or what it asks is
    what one sees: "*check* whether you find one"."""
    tokens = document.tokens
    is_look = tokens[verb].lemma in ("check", "look") and tokens[verb].tag in ("VB", "VBP")
    between = [token.lower for token in tokens[verb + 1 : see]]
    is_joined = tokens[see].lemma == "see" and between in (["to"], ["and"])
    is_found = tokens[see].lemma in ("see", "find") and between[:2] in (["if", "you"], ["whether", "you"])
    return is_look and (is_joined or (is_found and between[2:] in ([], ["can"], ["could"])))


def _is_wish_for(document: Document, task: FoundTask, following: FoundTask) -> bool:
    fetches = following.type in ("bringing", "taking")
    return fetches and task.type == "bringing" and is_served(document, task.token, following.token)


def _is_missed(observed: Observed, task: FoundTask) -> bool:
    """Whether a verb only tells that somebody cannot find what is then looked for: "can't find my passport, look in the
    safe"; not of "it", which was looked for before, and not where that is asked or a case."""
    tokens, at = observed.document.tokens, task.token
    if task.type != "searching" or observed.question[at] or at < 2 or at + 1 >= len(tokens):
        return False
    is_denied = tokens[at - 1].lower in _NOT and tokens[at - 2].lower in _CAN
    before = tokens[at - 3].lower if at > 2 else "."
    is_own = before in _MISSING or (at > 2 and tokens[at - 3].lower in MARKS) or at == 2
    is_named = tokens[at + 1].tag in ("DT", "PRP$", "NN", "NNS", "NNP", "NNPS", "JJ") and tokens[at + 1].pos != "PRON"
    return is_denied and is_own and (is_named or tokens[at + 1].tag == "PRP$") and not _is_case(observed, at)


def _is_case(observed: Observed, at: int) -> bool:
    """Whether a word that opens a condition stands ahead of a verb in its sentence."""
    sentences = observed.document.sentences
    return any(c.name in _CASES and c.first < at and sentences[c.first] == sentences[at] for c in observed.cues)


def _is_beside(document: Document, at: int) -> bool:
    """Whether a check only tells why, or what makes no difference."""
    return reason(document, at) is not None or concession(document, at) is not None


def _is_joined_state(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    """Whether a word only is a further state of a check before it: "if it's clean and *dry*"."""
    check = max((i for i in tasks if i < at), default=None)
    if check is None or tasks[check] != "check_state" or document.tokens[check].lower not in _BE:
        return False
    first = next((i for i in range(check + 1, at) if document.tokens[i].tag in ("JJ", "VBN")), at)
    return first < at and at in whole_state(document, range(first, first + 1))


def _is_of_case(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a verb only tells of what a case asks when or what for: "if you see it *when you vacuum*", "if anybody
    comes *to fetch it*"."""
    tokens, at = document.tokens, task.token
    between = [token.lower for token in tokens[check.token + 1 : at]]
    first = document.sentences.index(document.sentences[at])
    ahead = {token.lower for token in tokens[first : check.token]}
    if ahead.isdisjoint(("if", "unless")) or not MARKS.isdisjoint(between) or task.type == "check_state":
        return False
    is_when = between[-2:] in (["when", "you"], ["while", "you"]) and check.type in _LOOKS
    return is_when or (between == ["to"] and tokens[check.token].lemma == "come" and check.type == "check_state")


def _is_name(observed: Observed, at: int) -> bool:
    """Whether a word is a name without a verb before it: "give Tom the ball, and *Lily* the kite"."""
    tokens = observed.document.tokens
    return (
        0 < at < len(tokens) - 1
        and tokens[at].pos == "PROPN"
        and tokens[at].text[0].isupper()
        and not observed.senses[at]
        and tokens[at - 1].lower in ("and", "&", ",")
        and tokens[at + 1].tag in ("DT", "PRP$")
    )


def _is_tag(document: Document, at: int, before: Sequence[FoundTask]) -> bool:
    """Whether a verb only asks for agreement with the check before it: "he's asleep, is he?"."""
    is_behind = bool(before) and document.sentences[before[-1].token] == document.sentences[at]
    return is_behind and tag_question(document, at) is not None


def _is_reported_state(document: Document, task: FoundTask, before: Sequence[FoundTask]) -> bool:
    """Whether a participle is how a check asks that something is ("check that the heater's switched on")."""
    tokens, at = document.tokens, task.token
    if (
        task.type == "check_state"
        or tokens[at].tag not in ("VBN", "VBD")
        or not before
        or before[-1].type != "check_state"
    ):
        return False
    check = before[-1].token
    between = tokens[check + 1 : at]
    return (
        tokens[check].lemma in _ASKING
        and bool(between)
        and (between[-1].lower in _BE or (between[-1].lower in _MANNERS and between[-2:][0].lower in _BE))
        and not any(token.lower in _CLAUSE_ENDS for token in between)
    )


def _type(observed: Observed, task: FoundTask, following: int) -> str:
    """The type that a task has by the words up to the `following` one; its own where they settle nothing."""
    document = observed.document
    said = document.tokens[task.token + 1 : following]
    lemma = document.tokens[task.token].lemma
    if task.type in _HANDLING and lemma in _DRAWING and _is_covering(said):
        return "change_state"
    if task.type in _HANDLING and observed.gazetteer.ending_type(document, task.token) == "placing":
        return "placing"
    if task.type == "change_state" and lemma == "put":
        return "placing" if is_put_somewhere(said) else task.type
    if task.type == "placing" and (
        is_put_on(observed, said)
        if lemma == "put"
        else not LAYING.isdisjoint(forms(document, task.token)) and is_the_table(said)
    ):
        return "change_state"
    if task.type == "change_state" and lemma == "set" and any(t.lower == "down" for t in said[:_NEAR_DOWN]):
        return "placing"
    if task.type in ("searching", "informing") and is_heard(document, task.token):
        return "check_state"
    if task.type in _HANDLING | {"change_state"} and is_sent_for(document, task.token):
        return "informing"
    if task.type in ("following", "informing") and lemma == "meet":
        return "searching"
    if task.type != "check_state" and payee(document, task.token):
        return "bringing"
    if task.type == "taking" and for_somebody(document, task.token):
        return "bringing"
    if task.type in _HANDLING and loading(observed, task.token) is not None:
        return "placing"
    if task.type == "searching" and degree_asked(document, task.token):
        return "check_state"
    if task.type == "check_state" and is_assured(document, task.token):
        return "change_state"
    if task.type != "check_state" and is_done_by_others(document, task.token):
        return "check_state"
    if task.type in _HANDLING and (is_asked_done(document, task.token) or is_denied_of_others(document, task.token)):
        return "check_state"
    if task.type == "motion" and lemma in _TIDYING and observed.gazetteer.particle(document, task.token) == "up":
        return "change_state"  # "hoover the stairs and clear up"
    if task.type == "bringing" and is_wished(document, task.token):
        return "check_state"
    if task.type == "motion" and are_gone(document, task.token):
        return "check_state"
    if task.type != "check_state" and (admitted(document, task.token) or is_answered(document, task.token)):
        return "change_state"
    if task.type == "informing" and lemma == "enter":
        return "motion"  # "only enter if Tom says so"
    if task.type == "motion" and encountered(document, task.token):
        return "searching"
    return task.type
