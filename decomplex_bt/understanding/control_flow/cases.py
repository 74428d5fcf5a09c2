"""Cases: the states of one thing, told one by one ("if it's lit, ...; if it's blinking, ...; if it's out, ...")."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, JOINTS
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.contrasts import is_case_beside
from decomplex_bt.understanding.states import OPPOSITES, are_alike, are_apart
from decomplex_bt.understanding.vocabulary import LEVELS

_MANY = 3
"""From so many cases on even opposites are states among others: "hot", "lukewarm", "cold"."""
_OPENING = frozenset(("if", "when"))
_TURNING = frozenset(("unless", "only_if", "even_if", "or"))


def told_apart(clauses: Sequence[Clause], roles: Sequence[str]) -> list[list[int]]:
    """The conditions that tell three or more states of one thing, or two and what else there may be, each list in text
    order."""
    runs = told_in_a_row(clauses, roles)
    return [run for run in runs if len(run) + _has_rest(clauses, roles, run) >= _MANY]


def _has_rest(clauses: Sequence[Clause], roles: Sequence[str], run: Sequence[int]) -> bool:
    """Whether an "otherwise" stands behind two or more states: "if it's hot, ...; if cold, ...; *otherwise* ..."."""
    later = range(run[-1] + 1, len(clauses)) if len(run) > 1 else range(0)
    first = next((j for j in later if roles[j] != "task" or {"else", "or"} & {*clauses[j].far, *clauses[j].near}), None)
    is_behind = first is not None and first > run[-1] + 1 and roles[first] == "task"
    return first is not None and is_behind and len(clauses[first].turns) == 1


def told_in_a_row(clauses: Sequence[Clause], roles: Sequence[str]) -> list[list[int]]:
    """The conditions that follow each other for different states of one thing: two at least are known to be of one
    matter, and none of another."""
    runs: list[list[int]] = [[]]
    for k, role in enumerate(roles):
        if role not in CONDITION_ROLES:
            continue
        if role in JOINTS or not all(_is_beside(clauses[k], clauses[j]) for j in runs[-1]):
            runs.append([])
        if role not in JOINTS and (_opens_case(clauses[k]) or _asks_state(clauses[k])):
            runs[-1].append(k)
    return [run for run in runs if _are_of_one_matter([clauses[k] for k in run])]


def _is_beside(clause: Clause, first: Clause) -> bool:
    """Whether it is a further case of what the other asks; where it names nothing it can only be of the same thing."""
    if not _asks_state(clause) and not _asks_state(first):
        return is_case_beside(clause, first)
    state, other = _state(clause), _state(first)
    return _is_bare(clause) and _asks_state(first) and state != other and not are_apart(state, other)


def _asks_state(clause: Clause) -> bool:
    """Whether it asks after a state in a sentence of its own: "is she awake?", "awake?"; not "any luck?"."""
    is_plain = clause.is_question and clause.task.type == "check_state" and not (clause.far or clause.near)
    is_plain = is_plain and not (clause.wording.is_negated or clause.says_answer or clause.says_there_is)
    return is_plain and (bool(clause.said_state) or _is_bare(clause)) and not clause.is_of_whereabouts


def _is_bare(clause: Clause) -> bool:
    """Whether all that it says is a state: "awake?"."""
    is_named = any(kind != "state" for kind, _ in clause.task.arguments)
    return clause.is_question and clause.task.type == "check_state" and not is_named and not clause.has_pronoun


def _state(clause: Clause) -> str:
    return clause.wording.state or clause.verb


def _are_of_one_matter(run: Sequence[Clause]) -> bool:
    """Whether states are known to be of one matter: by their words, as levels ("*below* 18", "*above* 25"), or as what
    somebody wishes."""
    states = [clause.wording.state or "" for clause in run]
    is_wish = len(run) > 1 and all(clause.is_wish for clause in run)
    levels = {clause.said_state[0] for clause in run if clause.said_state and clause.said_state[0] in LEVELS}
    return (
        is_wish
        or len(levels) > 1
        or sum(_is_bare(clause) for clause in run) > 1
        or any(are_alike(one, other) or OPPOSITES.get(one) == other for one, other in combinations(states, 2))
    )


def _opens_case(clause: Clause) -> bool:
    """Whether a clause says in which case something is done, ahead of that: not "call me if it's red"."""
    leading = {*clause.far, *clause.near}
    is_led = not _OPENING.isdisjoint(clause.near) and leading.isdisjoint(_TURNING) and clause.boundary != "none"
    return clause.is_check and is_led and bool(clause.said_state) and not clause.wording.is_negated
