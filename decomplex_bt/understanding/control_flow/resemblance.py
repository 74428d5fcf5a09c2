"""How a task resembles earlier ones: a mention speaks of the same thing, or asks how an action went."""

from __future__ import annotations

from collections.abc import Sequence

from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cue_phrases import GOVERNING, last_of
from decomplex_bt.understanding.document import Token
from decomplex_bt.understanding.features import Observed

PRONOUNS = frozenset("it they them that this those these one there he she".split())


def resemblance_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
    """How a task resembles earlier ones: a mention speaks of the same thing, often by pronoun or with the opposite
    state."""
    clause = clauses[k]
    item: Features = {}
    for j in range(k - 1, -1, -1):
        other = clauses[j]
        if clause.wording.is_opposite_of(other.wording):
            item["opposite_state"] = min(3, k - j)
        if clause.wording.state is not None and clause.wording.state == other.wording.state:
            item["same_state"] = min(3, k - j)
        if set(clause.objects) & set(other.objects):
            item.setdefault("same_object", min(3, k - j))
            item.setdefault("same_object.types", f"{other.task.type}|{clause.task.type}")
    item.update(_mention_features(observed, clauses, k))
    item.update(_outcome_features(observed, clauses, k))
    item["object"] = "noun" if clause.objects else "pronoun" if _speaks_of_pronoun(observed, clause) else "none"
    item["object.type"] = f"{item['object']}.{clause.task.type}.{last_of(clause.near, GOVERNING)}"
    item["earlier_search"] = any(other.task.type == "searching" for other in clauses[:k])
    item["earlier_check"] = any(other.task.type == "check_state" for other in clauses[:k])
    item["argument_count"] = min(3, len(clause.task.arguments))
    return item


def _mention_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
    """How a clause compares with the nearest earlier one that can be asked about: a check, a search, a question."""
    clause = clauses[k]
    earlier = [j for j in range(k - 1, -1, -1) if clauses[j].task.type in ("check_state", "searching")]
    if not earlier or clause.task.type not in ("check_state", "searching"):
        return {}
    tokens = observed.document.tokens
    lemma = tokens[clause.task.token].lemma
    kinds = {kind for kind, _ in clause.task.arguments}
    says = "state" if "state" in kinds else "place" if "location" in kinds else "nothing"
    what = "noun" if clause.objects else "pronoun" if _speaks_of_pronoun(observed, clause) else "none"
    opens = last_of(clause.near, GOVERNING)
    item: Features = {"says": f"{says}.{what}.{opens}.{clause.wording.is_negated}"}
    for rank, j in enumerate(earlier[:2]):
        other = clauses[j]
        same = tokens[other.task.token].lemma == lemma
        shared = bool(set(clause.objects) & set(other.objects))
        differs = clause.wording.is_negated != other.wording.is_negated
        opposite = clause.wording.is_opposite_of(other.wording)
        asked = "question" if observed.question[other.task.token] else last_of(other.near, GOVERNING)
        mark = f"asked{rank}"
        item[f"{mark}.pair"] = f"{says}.{what}.{same}.{shared}.{differs}.{opposite}"
        item[f"{mark}.opens"] = f"{opens}.{asked}.{says}.{what}"
        item[f"{mark}.gap"] = f"{min(4, k - j)}.{says}.{what}.{opens}.{other.task.type}"
        item[f"{mark}.differs"] = f"{differs}.{opposite}.{other.task.type}.{clause.task.type}.{opens}"
        item[f"{mark}.first_word"] = f"{tokens[min(clause.first, clause.task.token)].lower}.{other.task.type}"
    return item


def _outcome_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
    """Whether a condition asks how an action before it went ("turn it on; if it will not light, ..."), seen from both:
    then the action is the condition, and what asks is a mention of it."""
    item: Features = {}
    asking = next((m for m in range(k + 1, min(k + 4, len(clauses))) if _asks(clauses[m])), None)
    if asking is not None:
        gap = f"{asking - k}.{min(2, clauses[asking].sentence - clauses[k].sentence)}"
        for name, value in _outcome(observed, clauses, k, asking).items():
            item[f"outcome.{name}"] = value
            item[f"outcome.{name}.gap"] = f"{value}.{gap}"
    if _asks(clauses[k]):
        for j in range(k - 1, max(-1, k - 3), -1):
            gap = f"{k - j}.{min(2, clauses[k].sentence - clauses[j].sentence)}"
            for name, value in _outcome(observed, clauses, j, k).items():
                item[f"action{k - j}.{name}"] = f"{value}.{gap}"
    return item


def _asks(clause: Clause) -> bool:
    return bool({*clause.far, *clause.near} & _ASKING)


_ASKING = frozenset(("if", "unless", "when", "fail", "else", "so"))


def _outcome(observed: Observed, clauses: Sequence[Clause], j: int, m: int) -> dict[str, str]:
    """How the clause of task `m` speaks of the action `j`."""
    action, clause = clauses[j], clauses[m]
    tokens = observed.document.tokens
    inside = range(clause.first, clause.last + 1)
    modal = next((tokens[i].lemma for i in inside if tokens[i].tag == "MD"), "") or next(
        (tokens[i].lemma for i in inside if tokens[i].lemma in ("do", "have", "be")), "none"
    )
    subject = next((tokens[i] for i in inside if tokens[i].dep in ("nsubj", "nsubjpass", "expl")), None)
    what = "none" if subject is None else _kind_of(subject, action)
    says = next((word for word in _OUTCOMES if any(tokens[i].lower == word for i in inside)), "") or "+".join(
        sorted({kind for kind, _ in clause.task.arguments} & {"state", "location"})
    )
    turned = f"{clause.wording.is_negated}.{clause.wording.is_contrary}"
    same = tokens[action.task.token].lemma == tokens[clause.task.token].lemma
    kinds = f"{action.task.type}.{clause.task.type}"
    return {
        "how": f"{kinds}.{turned}.{modal}.{same}",
        "of": f"{kinds}.{turned}.{what}",
        "says": f"{action.task.type}.{turned}.{says}",
        "verb": f"{action.task.type}.{tokens[clause.task.token].lemma}.{clause.wording.is_negated}",
    }


def _kind_of(subject: Token, action: Clause) -> str:
    """Of a clause's subject: the pronoun it is, whether the action names it, or else its part of speech."""
    if subject.lower in _SUBJECTS:
        return subject.lower
    return "shared" if subject.lemma in action.nouns else subject.pos


_SUBJECTS = frozenset("it they that this you there he she any none".split())
_OUTCOMES = ("there", "work", "fail", "open", "gone", "stuck", "possible", "manage", "reach", "budge")


def _speaks_of_pronoun(observed: Observed, clause: Clause) -> bool:
    return any(observed.document.tokens[j].lower in PRONOUNS for j in range(clause.first, clause.last + 1))
