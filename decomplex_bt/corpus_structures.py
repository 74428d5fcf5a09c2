"""Structures of instructions: what makes the control flow of one hard to read, told by its annotation and its words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise

from decomplex_bt.flow import Do, Flow, If, Node
from decomplex_bt.instruction import Argument, Instruction, Task

COMPLEX = "complex"

_MARKERS = re.compile(
    r"\b(?:if|iff|unless|case|provided|providing|long as|assuming|suppos(?:e|ing)|when|whenever|where|whether|should"
    r"|granted|event|condition|otherwise|else|instead|alternatively|failing|then)\b",
    re.IGNORECASE,
)
"""Words before a verb that tell how its task depends on another."""
_ORDER = re.compile(r"\b(?:before|beforehand|prior|after|afterwards?|once|as soon as|until|till?)\b", re.IGNORECASE)
_NEGATION = re.compile(
    r"n['’]t\b|\b(?:not|never|no|none|nothing|nobody|nowhere|neither|nor|without|unless|cannot|cant|wont|aint"
    r"|(?:is|are|does|do|did|has|have|was|could)nt)\b",
    re.IGNORECASE,
)
_AUXILIARY = re.compile(
    r"\b(?:is|are|am|was|were|be|been|being|has|have|had|do|does|did|will|would|can|could|should|may|might|must|gets?|got"
    r"|(?:is|are|does|do|did|has|have|wo|ca)nt|its|theyre|hes|shes)\b|['’](?:s|re|ve|m|d|ll)\b|n['’]t\b",
    re.IGNORECASE,
)
_STATE_WORD = re.compile(
    r"on|off|in|out|back|here|there|home|left|gone|open|shut|locked|dirty|clean|full|empty|hot|cold|warm|wet|dry|damp"
    r"|ready|done|asleep|awake|loose|intact|low|red|green|brown|dead|stuck|visible|present|set|\w+(?:ed|ing)",
    re.IGNORECASE,
)
"""Words that can carry a condition without a verb ("any soap left?", "oven on?")."""
_REQUEST = re.compile(r"\b(?:could|would|can|will) (?:you|we)\b", re.IGNORECASE)
_SENTENCE_END = re.compile(r"(?<!\bMr)(?<!\bMrs)(?<!\bMs)(?<!\bDr)(?<!\bSt)[.?!]+(?=\s|$)|\n+")
_PERSONAL = frozenset("it its he him his she her hers they them their theirs this that these those".split())
_ANOTHER = re.compile(r"\b(?:one|ones|another|other|others|some|any|none)\b", re.IGNORECASE)
_PLACES = frozenset("there here in there over there on there up there down there".split())
_JOINT = re.compile(r"\b(?:and|or|nor|plus)\b|&", re.IGNORECASE)


def conditions(instruction: Instruction) -> list[If]:
    """The nodes of the flow that branch, in the order of the tree."""
    return [node for node, _ in instruction.flow.walk() if isinstance(node, If)]


def dependents(instruction: Instruction) -> Iterator[tuple[If, Node]]:
    """Every condition with each node directly in one of its branches; repeats, which have no words, are left out."""
    for condition in conditions(instruction):
        for node in (*condition.then, *condition.orelse):
            if not (isinstance(node, Do) and node.is_repeat):
                yield condition, node


def sentences(text: str) -> list[tuple[int, int]]:
    """Start and end of every sentence, told by full stop, question mark, exclamation mark or the end of a line."""
    bounds = [0, *(match.end() for match in _SENTENCE_END.finditer(text)), len(text)]
    return [(start, end) for start, end in pairwise(bounds) if re.search(r"\w", text[start:end])]


def before_verb(instruction: Instruction, task: Task) -> str:
    """The words before a task's verb that are in no mark, back to the last mark of another task."""
    text, own = instruction.text, [argument.span for argument in task.arguments if argument.span]
    others = (
        span.end
        for other in instruction.tasks
        if other.id != task.id
        for span in [other.span, *(argument.span for argument in other.arguments if argument.span)]
        if span.end <= task.span.start
    )
    start, end = max(others, default=0), task.span.start
    for span in sorted(own, reverse=True):
        if start <= span.start and span.end <= task.span.start:
            text = text[: span.start] + text[span.end :]
            end -= span.end - span.start
    return text[start:end]


def is_marked(instruction: Instruction, number: int) -> bool:
    """Whether a word before a task's verb tells its dependency ("if", "otherwise"; DeComplex, section III-C)."""
    return bool(_MARKERS.search(before_verb(instruction, instruction.task(number))))


def _depending(instruction: Instruction) -> set[int]:
    """The tasks that are a condition or stand in a branch, first mentions only."""
    return {condition.task for condition in conditions(instruction)} | {n.task for _, n in dependents(instruction)}


def _sentence(instruction: Instruction, number: int, bounds: Sequence[tuple[int, int]]) -> int:
    start = instruction.task(number).span.start
    return next((i for i, (_, end) in enumerate(bounds) if start < end), len(bounds))


def _is_implicit(instruction: Instruction) -> bool:
    bounds = sentences(instruction.text)
    return any(
        _sentence(instruction, node.task, bounds) not in {_sentence(instruction, n, bounds) for n in condition.tasks}
        for condition, node in dependents(instruction)
    )


def _is_against_the_text(instruction: Instruction) -> bool:
    """Whether steps come in another order than in the text; a condition said after its branch is not meant."""
    return any(order != sorted(order) for order in _orders(instruction.flow))


def _orders(flow: Flow) -> Iterable[list[int]]:
    yield [_earliest(node) for node in flow.nodes]
    for node, _ in flow.walk():
        if isinstance(node, If):
            yield [_earliest(child) for child in node.then]
            yield [_earliest(child) for child in node.orelse]


def _earliest(node: Node) -> int:
    if isinstance(node, Do):
        return node.task
    return min([*node.tasks, *(_earliest(child) for child in (*node.then, *node.orelse))])


def _sequences(flow: Flow) -> Iterator[tuple[Node, ...]]:
    yield flow.nodes
    for node, _ in flow.walk():
        if isinstance(node, If):
            yield node.then
            yield node.orelse


def _has_if(nodes: Iterable[Node]) -> bool:
    return any(isinstance(node, If) for node in nodes)


def _is_repeat(node: Node) -> bool:
    return isinstance(node, Do) and node.is_repeat


def _ends_several(instruction: Instruction) -> bool:
    """Whether a branch of several tasks is followed by a task for both outcomes."""
    return any(
        isinstance(node, If) and max(len(node.then), len(node.orelse)) > 1 and isinstance(after, Do)
        for nodes in _sequences(instruction.flow)
        for node, after in pairwise(nodes)
    )


def _joins_conditions(instruction: Instruction) -> bool:
    """ "if A and B" (a condition alone in a branch, else nothing or what stands there too) or "if A or B"."""
    return any(
        (len(node.then) == 1 and _has_if(node.then) and all(map(_is_repeat, node.orelse)))
        or any(isinstance(inner, If) and any(map(_is_repeat, inner.then)) for inner in node.orelse)
        for node in conditions(instruction)
    )


def _asks_condition(instruction: Instruction) -> bool:
    """Whether a sentence that ends with a question mark holds nothing but mentions of conditions."""
    mentions = {number for condition in conditions(instruction) for number in condition.tasks}
    for start, end in sentences(instruction.text):
        sentence = instruction.text[start:end].rstrip()
        inside = {task.id for task in instruction.tasks if start <= task.span.start < end}
        if sentence.endswith("?") and inside and inside <= mentions and not _REQUEST.search(sentence):
            return True
    return False


def _has_verbless(instruction: Instruction) -> bool:
    for condition in conditions(instruction):
        for number in condition.tasks:
            task = instruction.task(number)
            if task.type == "check_state" and _STATE_WORD.fullmatch(task.span.of(instruction.text)):
                clause = re.split(r"[.?!,;:]|\b(?:and|but)\b", before_verb(instruction, task))[-1]
                if not _AUXILIARY.search(clause) and any(a.span and a.span < task.span for a in task.arguments):
                    return True
    return False


def _is_negated(instruction: Instruction) -> bool:
    text = instruction.text
    messages = [a.span for t in instruction.tasks for a in t.arguments if a.span and a.type == "message"]
    for span in sorted(messages, reverse=True):
        text = text[: span.start] + text[span.end :]
    return bool(_NEGATION.search(text))


def _says_order(instruction: Instruction) -> bool:
    return any(_ORDER.search(before_verb(instruction, task)) for task in instruction.tasks)


def _has_statement(instruction: Instruction) -> bool:
    """Whether a sentence of at least four words beside tasks holds none; within a sentence they are not seen."""
    bounds = sentences(instruction.text)
    with_task = {_sentence(instruction, task.id, bounds) for task in instruction.tasks}
    return bool(with_task) and any(
        i not in with_task and len(instruction.text[start:end].split()) >= 4 for i, (start, end) in enumerate(bounds)
    )


def _referring(instruction: Instruction) -> Iterator[tuple[Argument, list[str]]]:
    """Arguments whose value is not what their words say, with the words in lower case."""
    for task in instruction.tasks:
        for argument in task.arguments:
            if argument.span is not None and argument.value != argument.span.of(instruction.text):
                yield argument, re.findall(r"\w+", argument.span.of(instruction.text).lower())


def _has_joint(instruction: Instruction) -> bool:
    return any(
        argument.span is not None
        and argument.type not in ("message", "manner", "state")
        and _JOINT.search(argument.span.of(instruction.text))
        for task in instruction.tasks
        for argument in task.arguments
    )


def _fails(instruction: Instruction, types: frozenset[str], *, among: bool) -> bool:
    """Whether what follows a task's failure is said, of a task that is (`among`) or is not of these types."""
    return any(node.orelse and (instruction.task(node.task).type in types) == among for node in conditions(instruction))


STRUCTURES: Mapping[str, Callable[[Instruction], bool]] = {
    COMPLEX: lambda instruction: len(instruction.tasks) > 1,
    "with a single task": lambda instruction: len(instruction.tasks) == 1,
    "without a task": lambda instruction: not instruction.tasks,
    "with a condition": lambda instruction: bool(conditions(instruction)),
    "with a marked dependency": lambda instruction: any(is_marked(instruction, n) for n in _depending(instruction)),
    "with an unmarked dependency": lambda i: any(not is_marked(i, n) for n in _depending(i)),
    "task before its condition": lambda i: any(node.task < condition.task for condition, node in dependents(i)),
    "implicit, over sentences": _is_implicit,
    "with an else": lambda instruction: any(node.orelse for node in conditions(instruction)),
    "with then and else": lambda instruction: any(node.then and node.orelse for node in conditions(instruction)),
    "with an else-if": lambda instruction: any(
        len(node.orelse) == 1 and _has_if(node.orelse) for node in conditions(instruction)
    ),
    "with a nested condition": lambda instruction: any(
        _has_if((*node.then, *node.orelse)) for node in conditions(instruction)
    ),
    "nested in then": lambda instruction: any(_has_if(node.then) for node in conditions(instruction)),
    "nested in else": lambda instruction: any(_has_if(node.orelse) for node in conditions(instruction)),
    "with several conditions": lambda instruction: len(conditions(instruction)) > 1,
    "independent conditions": lambda instruction: any(
        sum(isinstance(node, If) for node in nodes) > 1 for nodes in _sequences(instruction.flow)
    ),
    "A and B, or A or B": _joins_conditions,
    "with a repeat": lambda instruction: any(_is_repeat(node) for node, _ in instruction.flow.walk()),
    "with merged mentions": lambda instruction: any(len(node.tasks) > 1 for node, _ in instruction.flow.walk()),
    "failed action": lambda instruction: _fails(instruction, frozenset(("check_state", "searching")), among=False),
    "failed search": lambda instruction: _fails(instruction, frozenset(("searching",)), among=True),
    "several, then for both": _ends_several,
    "question as condition": _asks_condition,
    "verbless condition": _has_verbless,
    "out of order": _is_against_the_text,
    "before, after, once, until": _says_order,
    "with a negation": _is_negated,
    "with an implied argument": lambda instruction: any(
        argument.span is None for task in instruction.tasks for argument in task.arguments
    ),
    "with a reference": lambda instruction: any(True for _ in _referring(instruction)),
    "it, her, them, that": lambda i: any(words[-1] in _PERSONAL for _, words in _referring(i) if words),
    "one, another, the other": lambda i: any(_ANOTHER.search(" ".join(words)) for _, words in _referring(i)),
    "there, here": lambda i: any(words[-1] in _PLACES for _, words in _referring(i) if words),
    "with things joined": _has_joint,
    "with a plain statement": _has_statement,
}
"""Structures by name, with what an instruction that has it looks like.

"task before its condition" is what the paper calls out of order (DeComplex, section III-C), "implicit" a task in
another sentence than every mention of its condition. Sentences and marks are told by punctuation and words: what has no
full stops has no implicit ones. "out of order": steps in another order than in the text.
"""
