"""How far a condition reaches: features of a task and the conditions on either side of it."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cue_phrases import GOVERNING, SIGNALS, STRONG, last_of

_TURNS = ("either_way", "else", "fail", "so", "after_that", "last", "then", "instead", "also", "but")


def _shape(clauses: Sequence[Clause], j: int) -> str:
    """How the clause of condition `j` lies in its sentence: what comes before its cue and what after its end. A
    condition that opens its sentence governs what follows, one that closes it what came before."""
    clause = clauses[j]
    opens = clause.boundary
    if opens == "none":
        opens = next((word for word in ("and", "but") if word in clause.near), "none")
    if j == 0 or clauses[j - 1].sentence != clause.sentence:
        opens = "start"
    if j + 1 == len(clauses):
        closes = "end"
    elif clauses[j + 1].sentence != clause.sentence:
        closes = "sentence"
    else:
        closes = clauses[j + 1].boundary
    return f"{opens}.{closes}"


def _last_turn(clauses: Sequence[Clause], j: int, k: int) -> tuple[str, int]:
    """The last cue after condition `j` that turns the talk (otherwise, either way, after that, ...), up to task `k`,
    with the number of tasks since it."""
    for m in range(k, j, -1):
        own = (*clauses[m].far, *clauses[m].near)
        for name in _TURNS:
            if name in own:
                return name, k - m
        if m < k and any(name in clauses[m].behind for name in _TURNS[:4]):
            return next(name for name in _TURNS[:4] if name in clauses[m].behind), k - m
    return "none", k - j


def left_features(clauses: Sequence[Clause], k: int, before: Sequence[int], roles: Sequence[str]) -> Features:
    j = before[0]
    clause, condition = clauses[k], clauses[j]
    sentences = min(2, clause.sentence - condition.sentence)
    shape = _shape(clauses, j)
    governing = last_of(condition.near, GOVERNING)
    item: Features = {
        "left.gap": min(4, k - j),
        "left.sentences": sentences,
        "left.type": condition.task.type,
        "left.types": f"{condition.task.type}|{clause.task.type}",
        "left.negated": condition.wording.is_negated,
        "left.governing": governing,
        "left.role": roles[j],
        "left.shape": shape,
        "left.shape.gap": f"{shape}.{min(3, k - j)}.{sentences}",
        "left.shape.role": f"{shape}.{roles[j]}.{roles[k]}",
        "left.question": f"{governing}.{sentences}.{min(2, k - j)}.{clause.boundary}",
    }
    turn, since = _last_turn(clauses, j, k)
    stretch = "own" if since == 0 else "same" if clauses[k - since].sentence == clause.sentence else "other"
    item["turn"] = f"{turn}.{stretch}"
    item["turn.shape"] = f"{turn}.{stretch}.{shape}"
    item["turn.gap"] = f"{turn}.{stretch}.{min(3, k - j)}.{sentences}"
    item["turn.role"] = f"{turn}.{stretch}.{roles[k]}.{roles[j]}"
    item["turn.governing"] = f"{turn}.{stretch}.{governing}.{condition.wording.is_negated}"
    item["turn.boundary"] = f"{turn}.{clause.boundary}.{sentences}"
    within = [m for m in range(j + 1, k) if roles[m] not in CONDITION_ROLES]
    link = ".".join(
        (
            str(clause.has_pronoun),
            str(bool(clause.nouns & condition.nouns)),
            str(any(clause.nouns & clauses[m].nouns for m in within)),
            str(bool(clause.nouns)),
        )
    )
    item["link"] = f"{link}.{sentences}"
    item["link.turn"] = f"{link}.{turn}.{stretch}"
    item["link.gap"] = f"{link}.{min(2, len(within))}.{sentences}.{clause.boundary}"
    item["link.role"] = f"{link}.{roles[k]}.{roles[j]}"
    between: set[str] = set(condition.behind)
    for m in range(j + 1, k + 1):
        between |= {*clauses[m].far, *clauses[m].near}
        if m < k:
            between |= set(clauses[m].behind)
    for cue in SIGNALS:
        if cue in between:
            item[f"between.{cue}"] = 1.0
    strong = [cue for cue in ("either_way", "else", "fail", "so") if cue in between]
    item["turns"] = "+".join(strong)
    item["turns.type"] = f"{'+'.join(strong)}.{clause.task.type}"
    if len(before) > 1:
        second = clauses[before[1]]
        item["left.second.gap"] = min(4, k - before[1])
        item["left.second.same_sentence"] = second.sentence == condition.sentence
        item["left.second.between"] = min(3, before[0] - before[1])
        item["left.second.turn"] = f"{turn}.{stretch}.{roles[before[1]]}.{roles[j]}"
        item["left.second.shape"] = f"{_shape(clauses, before[1])}|{shape}"
        item["left.second.object"] = bool(set(second.objects) & set(clause.objects))
    return item


def right_features(clauses: Sequence[Clause], k: int, j: int) -> Features:
    clause, condition = clauses[k], clauses[j]
    governing = last_of(condition.near, GOVERNING)
    opens = {*clauses[k + 1].far, *clauses[k + 1].near, *clause.behind}
    shape = _shape(clauses, j)
    sentences = min(2, condition.sentence - clause.sentence)
    joiner = next((word for word in ("but", "or", "and") if word in (*condition.near, *condition.far)), "none")
    item = _replacement_features(clauses, k, j, joiner)
    return item | {
        "right.gap": min(4, j - k),
        "right.sentences": sentences,
        "right.type": condition.task.type,
        "right.governing": governing,
        "right.boundary": condition.boundary,
        "right.near": f"{j - k == 1}.{sentences == 0}.{governing}",
        "right.boundary.governing": f"{condition.boundary}.{governing}.{min(2, j - k)}",
        "right.negated": condition.wording.is_negated,
        "right.opens": "+".join(sorted(opens & STRONG)),
        "right.shape": f"{shape}.{sentences}",
        "right.shape.gap": f"{shape}.{sentences}.{min(3, j - k)}.{governing}",
        "right.but": f"{'but' in (*condition.near, *condition.far)}.{shape}.{sentences}",
    }


def _replacement_features(clauses: Sequence[Clause], k: int, j: int, joiner: str) -> Features:
    """Whether what follows the condition `j` takes the place of task `k` ahead of it ("bring me the tea, but if it is
    cold, the milk instead"): then `k` belongs to the other side."""
    consequences = [m for m in range(j + 1, min(j + 4, len(clauses))) if clauses[m].sentence <= clauses[j].sentence + 1]
    if not consequences:
        return {"right.replaces": "nothing"}
    instead = any("instead" in (*clauses[m].near, *clauses[m].far, *clauses[m].behind) for m in (j, *consequences))
    nearest = clauses[consequences[0]]
    alike = any(clauses[m].task.type == clauses[k].task.type for m in consequences)
    shared = bool(set(clauses[k].objects) & {noun for m in consequences for noun in clauses[m].objects})
    negated = clauses[j].wording.is_negated
    sentences = min(2, clauses[j].sentence - clauses[k].sentence)
    between = any(clauses[m].task.type == clauses[k].task.type for m in range(k + 1, j))
    return {
        "right.replaces": f"{instead}.{alike}",
        "right.replaces.joiner": f"{instead}.{alike}.{joiner}.{sentences}.{negated}",
        "right.replaces.types": f"{clauses[k].task.type}|{nearest.task.type}.{negated}",
        "right.replaces.what": f"{alike}.{shared}.{bool(nearest.objects)}.{between}.{min(3, j - k)}",
    }
