"""What the reader of an instruction should know besides its flow: arguments still missing, words taken lightly."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from decomplex_bt.domain.clauses import asks_presence, clause_around, is_of_anything, is_of_nobody, is_of_weather
from decomplex_bt.domain.loader import Domain
from decomplex_bt.flow import Flow, If
from decomplex_bt.instruction import Argument, Missing, Task
from decomplex_bt.understanding.document import MARKS, Document, Token
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.chunks import head_of
from decomplex_bt.understanding.references.gaps import ASIDE, NAMING_FORMS, gap_of, is_let_through
from decomplex_bt.understanding.references.relatives import exclusions
from decomplex_bt.understanding.rules.cases.questions import asks_openly
from decomplex_bt.understanding.rules.cases.times import times
from decomplex_bt.understanding.rules.ellipses.alternatives import alternatives
from decomplex_bt.understanding.rules.orders.omissions import of_all
from decomplex_bt.understanding.rules.orders.prohibitions import forbidden, is_needless
from decomplex_bt.understanding.vocabulary import AIRED, WARMTH

NO_TASK = "no task that this robot knows was found in the text"

_REPEATING = {
    "while": "while", "whilst": "while", "until": "until", "till": "until", "whenever": "whenever", "twice": "twice", "repeatedly": "repeatedly",
    "every": "every time", "times": "several times", "keep": "keep on",
}  # fmt: skip


_SPANS = frozenset("second seconds minute minutes hour hours day days week weeks".split())
_MAKING = frozenset("make brew cook bake fix prepare mix buy purchase order book hire rent".split())
_COUNTING = frozenset(("count", "tally"))
_ONE_OF_EACH = {
    "motion": "goal", "following": "goal", "placing": "goal", "bringing": "recipient", "informing": "recipient",
}  # fmt: skip
"""By type of task, what a task has one of, or one for each thing."""
_HOW_MANY = "how many "


def missing_arguments(observed: Observed, tasks: Sequence[Task], flow: Flow, domain: Domain) -> Iterator[Missing]:
    """The required arguments that are neither said, implied, given by the verb nor by default, of
    all tasks but later mentions."""
    mentions, verbs = flow.mentions(), [task.span for task in tasks]
    completed = _completed_by_mentions(observed, tasks, flow)
    for task in tasks:
        if task.id in mentions:
            continue
        task_type = domain.ontology.task_types[task.type]
        given = {argument.type for argument in task.arguments if not _is_open(observed, task, argument)}
        given |= completed.get(task.id, set())
        if task.type == "bringing":
            given.add("recipient")
        if task.type in ("change_state", "check_state") and _says_state(observed, task):
            given.add("state")
        if task.type == "check_state":
            verb = observed.document.indices(task.span).start
            clause = clause_around(observed.document.text, task.span, verbs)
            is_presence, is_named = asks_presence(clause), _asks_who(observed, task)
            is_said = is_of_nobody(clause) or (is_of_anything(clause) and "location" in given)
            given |= {"object"} if is_said else {"state"} if is_presence else set()
            is_around = is_of_weather(clause) or _is_of_air(observed, task, tasks)
            if is_around or is_named or asks_openly(observed.document, verb):
                given |= {"object", "state"}
        place = observed.document.indices(task.span).start
        if (
            is_let_through(observed.document, place)
            or observed.gazetteer.ending_type(observed.document, place) == task.type
        ):
            given.add("goal")
        for group in task_type.required:
            if not given & set(group):
                yield Missing(task.id, group[0], task_type.questions[group[0]])


def _is_of_air(observed: Observed, check: Task, tasks: Sequence[Task]) -> bool:
    """Whether an "it" is how warm it is around, which is all that there is to do: "open the window if *it's warm*"."""
    document = observed.document
    spans = [a.span for task in tasks if task is not check for a in task.arguments if a.type == "object" and a.span]
    handled = {document.tokens[head_of(document, document.indices(span))].lemma for span in spans}
    is_warmth = any(not WARMTH.isdisjoint(state.lower().split()) for state in check.values("state"))
    return is_warmth and check.value("object") == "it" and bool(handled) and handled <= AIRED


def _completed_by_mentions(observed: Observed, tasks: Sequence[Task], flow: Flow) -> dict[int, set[str]]:
    """By the number of a check what its later mentions tell of it: "check on the kids; if they've *woken up*, ..."."""
    of = {task.id: task for task in tasks}
    told: dict[int, set[str]] = {}
    for node, _ in flow.walk():
        if not isinstance(node, If) or of[node.task].type != "check_state":
            continue
        mentions = [of[number] for number in node.tasks[1:] if of[number].type == "check_state"]
        says = any(mention.value("state") is not None or _says_state(observed, mention) for mention in mentions)
        told[node.task] = {"state"} if says else set()
    return told


def _is_open(observed: Observed, task: Task, argument: Argument) -> bool:
    """Whether its words mean something else, and nothing in the instruction says what: "put it on the table"."""
    if argument.span is None or argument.value != argument.span.of(observed.document.text):
        return False
    if task.type == "check_state" and argument.value.lower() == "there" and task.value("object") is not None:
        return False  # "give it to Ann. If she isn't there, ..."
    gap = gap_of(observed.document, task, argument)
    if gap is None or argument.type in ASIDE or gap.form in NAMING_FORMS:
        return False
    if gap.word in _NAMING or not _LEAVING_OUT.isdisjoint(argument.value.lower().split()):
        return False
    # "if the big one's broken", "if Mia's is empty"; what is to be taken or changed must be known
    is_told = task.type == "check_state" and gap.form in ("one", "own") and len(gap.tokens) > 1
    return not is_told


_NAMES = frozenset(("NOUN", "PROPN", "PRON", "NUM"))
"""What ends the words that say who or what "it" is, and not how."""
_NAMING = frozenset(("machine", "place", "inside"))
"""What may stand for a thing named before, and names one that everybody knows where none was: "if the machine's free",
"go inside"."""


_LEAVING_OUT = frozenset(("except", "excepting", "excluding", "but"))
"""What sets a possessive beside the noun it goes with: "every door except the kitchen's"."""


def _asks_who(observed: Observed, task: Task) -> bool:
    """Whether a check asks who or what it is, of which "it" names nothing: "if it's the plumber"."""
    document, verb = observed.document, observed.document.indices(task.span).start
    said = [document.indices(argument.span) for argument in task.arguments if argument.span is not None]
    said = [words for words in said if document.tokens[words.start].lower != "it"]
    is_named = len(said) == 1 and said[0].start == verb + 1 and document.tokens[said[0].stop - 1].pos in _NAMES
    word = document.tokens[verb]
    is_it = verb > 0 and word.lemma in ("be", "'s") and document.tokens[verb - 1].lower == "it"
    return (is_it or word.lower == "its") and is_named


def warnings_of(observed: Observed, tasks: Sequence[Task]) -> Iterator[str]:
    """One line each: no task found, a prohibition that is not watched, what has no verb, what is left out, repetition
    that is read as once, what would have to be made or counted, times."""
    document = observed.document
    for verb in forbidden(observed):
        if is_needless(document, verb):
            continue
        end = _clause_end(document, verb, {document.indices(task.span).start for task in tasks})
        yield f"{document.span(verb, end - 1).of(document.text)!r} is forbidden: a prohibition is not watched"
    if not tasks:
        yield NO_TASK
        return
    starts = {task.span.start for task in tasks}
    types = {document.indices(task.span).start: task.type for task in tasks}
    for other in alternatives(observed, types):
        if other.is_verbal:
            continue
        phrase = document.span(other.tokens.start, other.tokens.stop - 1).of(document.text)
        yield f"{phrase!r} is no task, for it has no verb: say what to do with it"
    said_of = [argument.span for task in tasks for argument in task.arguments if argument.span is not None]
    for left_out in exclusions(document, types):
        span = document.span(left_out.tokens.start, left_out.tokens.stop - 1)
        if not any(one.start <= span.start and span.end <= one.end for one in said_of):
            yield f"{span.of(document.text)!r} leaves something out, which no argument says: planning alone heeds it"
    for words, is_in_case in of_all(observed):
        phrase = document.span(words.start, words.stop - 1).of(document.text)
        heeded = ", in a case: nothing heeds it, say each by itself" if is_in_case else ": planning alone heeds it"
        yield f"{phrase!r} leaves something out, which no argument says{heeded}"
    repeated = (_repetition(document, token) for token in document.tokens if token.start not in starts)
    for word in dict.fromkeys(word for word in repeated if word):
        yield f"{word!r} is read as if once: repetition and waiting are not part of the flow"
    if any(_says_retry(document, token) for token in document.tokens if token.start not in starts):
        yield "'try again' is no task: say what to do again"
    yield from _beyond(observed, tasks)
    for time in times(document):
        span = document.span(time.start, time.stop - 1)
        if not any(one.start < span.end and span.start < one.end for one in said_of):
            yield f"{span.of(document.text)!r} is not heeded: times are not part of the flow"


def _clause_end(document: Document, verb: int, carriers: Container[int]) -> int:
    """Where the words of a verb end: at a mark, or at what joins the next order to it ("open the window *and* turn")."""
    tokens = document.tokens
    for i in range(verb + 1, len(tokens)):
        behind = next((t for t in tokens[i + 1 :] if t.tag != "RB" and t.lower != "please"), None)
        is_verb = behind is not None and (behind.i in carriers or behind.tag in ("VB", "VBP"))
        if tokens[i].text in _END or i in carriers or (tokens[i].lower in _LINKS and is_verb):
            return i
    return len(tokens)


def _repetition(document: Document, token: Token) -> str:
    """How a word, with those behind it, says that something is done again and again, or waited for; "" where it says
    nothing of the kind."""
    word, behind = token.lower, [other.lower for other in document.tokens[token.i + 1 : token.i + 3]]
    if word == "every":
        return _REPEATING[word] if behind[:1] == ["time"] else "every so often" if _SPANS.intersection(behind) else ""
    if word == "while" and behind[:1] == ["you"]:
        return ""  # "put the kettle on while you're there"
    if word == "wait" and token.tag in ("VB", "VBP"):
        return word if behind[:1] == ["for"] or _SPANS.intersection(behind[1:]) else ""
    if (behind == ["and", word] and word in ("again", "over")) or [word, *behind] == ["back", "and", "forth"]:
        return f"{word} {' '.join(behind)}"
    return _REPEATING.get(word, "")


def _says_retry(document: Document, token: Token) -> bool:
    behind = [other.lower for other in document.tokens[token.i + 1 : token.i + 3]]
    return token.lower == "try" and (behind[:1] == ["again"] or behind == ["once", "more"])


def _beyond(observed: Observed, tasks: Sequence[Task]) -> Iterator[str]:
    """Orders that are carried out as less than they say: what is to be made is brought, what is to be counted seen."""
    document = observed.document
    for task in tasks:
        verb = document.tokens[document.indices(task.span).start]
        if task.type in ("bringing", "taking") and verb.lemma in _MAKING:
            known = "bring" if task.type == "bringing" else "take"
            yield f"{verb.text!r} is read as {known!r}: nothing is made or bought here"
        if task.type in ("searching", "check_state") and verb.lemma in _COUNTING:
            yield f"{verb.text!r} is read as 'look for': what is seen is not counted"
        kind = _ONE_OF_EACH.get(task.type, "")
        told = task.values(kind)
        if len(told) > 1 and len(task.values("object")) < len(told):
            yield f"{told[1]!r} is one {kind} more of {verb.text!r}: only {told[0]!r} is heeded, say an order for each"
        for message in task.values("message"):
            if message.lower().startswith(_HOW_MANY):
                yield f"{message!r} is told without a number: what is seen is not counted"


_END = MARKS | {"but"}
_LINKS = frozenset(("and", "then"))


def _says_state(observed: Observed, task: Task) -> bool:
    """Whether the verb itself says the state ("open", "heat"); unknown verbs are taken to ("iron the shirt")."""
    i = observed.document.indices(task.span).start
    token = observed.document.tokens[i]
    if task.type == "check_state":
        return token.lemma not in _CHECKING
    things = (observed.document.indices(a.span) for a in task.arguments if a.type == "object" and a.span is not None)
    if any((token.lemma, observed.document.tokens[thing[-1]].lemma) in _SAYING for thing in things):
        return True
    particle = observed.gazetteer.particle(observed.document, i)
    return particle is not None or token.lemma not in _GENERIC


_CHECKING = frozenset("check see be look verify make find confirm inspect".split())
_GENERIC = frozenset("turn switch set make put get have leave keep adjust flip".split())
_SAYING = frozenset((("make", "bed"), ("make", "tea"), ("make", "coffee"), ("set", "table"), ("set", "alarm")))
"""Verbs and what they say the state of only with it."""
