"""Words that carry no task though a model says so: "if he's *mowing* the lawn", "*start* cooking the rice"."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from decomplex_bt.domain.clauses import WEATHER
from decomplex_bt.understanding.document import ENDS, MARKS, Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.background.hearsay import is_hearsay
from decomplex_bt.understanding.rules.background.plans import is_planned
from decomplex_bt.understanding.rules.cases.checks import is_gerund, whole_state
from decomplex_bt.understanding.rules.cases.concessions import either_way
from decomplex_bt.understanding.rules.cases.leftovers import is_left_of
from decomplex_bt.understanding.rules.cases.questions import is_deliberated
from decomplex_bt.understanding.rules.findings import HANDLING, Findings
from decomplex_bt.understanding.rules.orders.idioms import is_light
from decomplex_bt.understanding.rules.orders.prohibitions import is_elided, is_left_alone
from decomplex_bt.understanding.rules.orders.wishes import is_background, is_served, is_taken_up
from decomplex_bt.understanding.rules.speech.asides import concession, is_explained, means, musing, reason, tag_question
from decomplex_bt.understanding.tasks import FoundTask
from decomplex_bt.understanding.vocabulary import TIMES_OF_DAY

_BE = frozenset(("be", "been", "'s", "is", "are", "'re", "re", "s"))
_MANNERS = frozenset("all both also actually still always really properly firmly securely definitely fully".split())
_ASKING = frozenset("check see verify confirm look find".split())
_CLAUSE_ENDS = ENDS | frozenset((",", ":", "and", "or", "but"))
_NOT = frozenset("not n't nt".split())
_CAN = frozenset("ca can could".split())
_MISSING = frozenset("i we and but so still just oh well sorry hey robot".split())
"""What may stand ahead of a "can't find", beside a mark."""
_CASES = frozenset("if unless when only_if until before after".split())
_NAMED = ("RB", "DT", "PRP$", "JJ", "NN", "NNP", "NNS")
_FAVOURS = frozenset("favour favor kindness".split())
_BESIDE_FAVOURS = _FAVOURS | frozenset("me us the a an of and to by please , big huge great".split())
_PICKED = (frozenset("any anything all those ones".split()), frozenset(("that", "which")))
_LOOKS = frozenset(("check_state", "searching"))


def is_no_task(
    observed: Observed, findings: Findings, before: FoundTask | None, task: FoundTask, following: FoundTask | None
) -> bool:
    """Whether a word carries no task though a model says so; `before` is the last task that was kept."""
    document, at = observed.document, task.token
    return (
        at in findings.idle
        or _is_name(observed, at)
        or (task.type == "check_state" and _is_beside(document, at))
        or (task.type in HANDLING and is_taken_up(document, at, findings.tasks))
        or any(rule(document, at) for rule in _ALONE)
        or any(rule(document, at, findings.tasks) for rule in _AMONG_TASKS)
        or (before is not None and (before.token >= at or any(rule(document, before, task) for rule in _BEHIND)))
        or (following is not None and any(rule(document, task, following) for rule in _AHEAD))
        or (before is None and following is not None and _is_missed(observed, task))
    )


def _is_greeting(document: Document, at: int) -> bool:
    """Whether it is the time of day that somebody is wished: "good *morning*"."""
    tokens = document.tokens
    return at > 0 and tokens[at - 1].lower == "good" and tokens[at].lower in TIMES_OF_DAY | {"day"}


def _is_musing(document: Document, at: int) -> bool:
    return musing(document, at) is not None


def _is_either_way(document: Document, at: int) -> bool:
    return either_way(document, at) is not None


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


def _is_of_any(document: Document, at: int) -> bool:
    """Whether a "be" only tells which of several are meant: "close any that *'s* open"."""
    ahead = [token.lower for token in document.tokens[max(0, at - 2) : at]]
    is_be = document.tokens[at].lower in ("'s", "is", "are")
    return (
        is_be and len(ahead) == len(_PICKED) and all(word in known for word, known in zip(ahead, _PICKED, strict=True))
    )


def _is_beside(document: Document, at: int) -> bool:
    """Whether a check only tells why, or what makes no difference."""
    return reason(document, at) is not None or concession(document, at) is not None


def _is_means(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    return means(document, at, tasks) is not None


def _is_left_alone(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    return is_left_alone(document, at, [i for i, kind in tasks.items() if kind not in _LOOKS])


def _is_joined_state(document: Document, at: int, tasks: Mapping[int, str]) -> bool:
    """Whether a word only is a further state of a check before it: "if it's clean and *dry*"."""
    check = max((i for i in tasks if i < at), default=None)
    if check is None or tasks[check] != "check_state" or document.tokens[check].lower not in _BE:
        return False
    first = next((i for i in range(check + 1, at) if document.tokens[i].tag in ("JJ", "VBN")), at)
    return first < at and at in whole_state(document, range(first, first + 1))


def _is_left(document: Document, check: FoundTask, task: FoundTask) -> bool:
    return is_left_of(document, check.token, task.token)


def _is_light(document: Document, verb: FoundTask, task: FoundTask) -> bool:
    return is_light(document, verb.token, task.token)


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


def _is_had(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a noun is what a thing is asked to have: "if the pie has *nuts* in it"."""
    tokens = document.tokens
    is_having = check.type == task.type == "check_state" and tokens[check.token].lower in ("has", "have")
    between = tokens[check.token + 1 : task.token]
    return is_having and tokens[task.token].pos == "NOUN" and all(t.pos in ("DET", "ADJ", "NOUN") for t in between)


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


def _is_tag(document: Document, before: FoundTask, task: FoundTask) -> bool:
    """Whether a verb only asks for agreement with the check before it: "he's asleep, is he?"."""
    is_same_sentence = document.sentences[before.token] == document.sentences[task.token]
    return is_same_sentence and tag_question(document, task.token) is not None


def _is_reported_state(document: Document, check: FoundTask, task: FoundTask) -> bool:
    """Whether a participle is how a check asks that something is ("check that the heater's switched on")."""
    tokens, at = document.tokens, task.token
    if task.type == "check_state" or tokens[at].tag not in ("VBN", "VBD") or check.type != "check_state":
        return False
    between = tokens[check.token + 1 : at]
    return (
        tokens[check.token].lemma in _ASKING
        and bool(between)
        and (between[-1].lower in _BE or (between[-1].lower in _MANNERS and between[-2:][0].lower in _BE))
        and not any(token.lower in _CLAUSE_ENDS for token in between)
    )


def _is_background(document: Document, task: FoundTask, following: FoundTask) -> bool:
    return is_background(document, task.token, following.token, following.type)


def _is_wish_for(document: Document, task: FoundTask, following: FoundTask) -> bool:
    fetches = following.type in ("bringing", "taking")
    return fetches and task.type == "bringing" and is_served(document, task.token, following.token)


def _is_with_see(document: Document, task: FoundTask, following: FoundTask) -> bool:
    """Whether a verb is one with the "see" behind it: "*check* to see if", "*look* and see whether", or what it asks is
    what one sees: "*check* whether you find one"."""
    tokens, verb, see = document.tokens, task.token, following.token
    is_look = tokens[verb].lemma in ("check", "look") and tokens[verb].tag in ("VB", "VBP")
    between = [token.lower for token in tokens[verb + 1 : see]]
    is_joined = tokens[see].lemma == "see" and between in (["to"], ["and"])
    is_found = tokens[see].lemma in ("see", "find") and between[:2] in (["if", "you"], ["whether", "you"])
    return is_look and (is_joined or (is_found and between[2:] in ([], ["can"], ["could"])))


def _is_beginning(document: Document, task: FoundTask, following: FoundTask) -> bool:
    """Whether a verb only says to begin what the one behind it orders: "*start* cooking the rice"."""
    verb, gerund = task.token, following.token
    is_begun = document.tokens[verb].lemma in ("start", "begin") and document.tokens[verb].tag in ("VB", "VBP")
    return is_begun and gerund == verb + 1 and is_gerund(document.tokens[gerund])


def _is_favour(document: Document, task: FoundTask, following: FoundTask) -> bool:
    """Whether a verb only says that the order behind it would be kind: "*do* me the favour of heating it", "would you
    mind if I *asked* you to heat it"."""
    tokens, verb, order = document.tokens, task.token, following.token
    words = [token.lower for token in tokens[verb + 1 : order]]
    is_favour = tokens[verb].lemma in ("do", "make") and not _FAVOURS.isdisjoint(words)
    ahead = [token.lower for token in tokens[max(0, verb - 3) : verb]]
    is_asked = tokens[verb].lemma == "ask" and ahead[-2:] in (["if", "i"], ["if", "we"]) and ahead[:1] == ["mind"]
    return (is_favour and _BESIDE_FAVOURS.issuperset(words)) or (is_asked and words == ["you", "to"])


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


_ALONE: tuple[Callable[[Document, int], bool], ...] = (
    _is_of_any,
    _is_greeting,
    _is_musing,
    _is_event,
    _is_either_way,
    is_elided,
    is_hearsay,
    is_deliberated,
    is_explained,
)
"""By the word alone."""
_AMONG_TASKS: tuple[Callable[[Document, int, Mapping[int, str]], bool], ...] = (
    _is_means,
    _is_left_alone,
    is_planned,
    _is_joined_state,
)
"""By the word and the tasks that the model found."""
_BEHIND: tuple[Callable[[Document, FoundTask, FoundTask], bool], ...] = (
    _is_reported_state,
    _is_tag,
    _is_progressive,
    _is_left,
    _is_had,
    _is_light,
    _is_of_case,
)
"""By the task before it."""
_AHEAD: tuple[Callable[[Document, FoundTask, FoundTask], bool], ...] = (
    _is_wish_for,
    _is_with_see,
    _is_beginning,
    _is_favour,
    _is_background,
)
"""By the task behind it."""
