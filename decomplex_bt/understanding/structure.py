"""Features of tasks in their order, for the models of role, attachment and order (the default control flow)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from decomplex_bt.understanding.arcs import CONDITION_ROLES, Wording, branch_orders
from decomplex_bt.understanding.clauses import Clause, wordings_of
from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cues import GOVERNING
from decomplex_bt.understanding.features import Observed

_PRONOUNS = frozenset("it they them that this those these one there he she".split())
_SIGNALS = (
    "if", "only_if", "unless", "when", "else", "fail", "so", "either_way", "then", "after_that", "before",
    "before_that", "after", "until", "first", "last", "either", "also", "while", "but", "or", "and", "not",
    "instead", "depending", "whether", "even_if",
)  # fmt: skip


def paper_features(observed: Observed, clauses: Sequence[Clause], *, with_task_type: bool = True) -> list[Features]:
    """The observation features of the paper's dependency CRF, row by row (DeComplex, Table II)."""
    document = observed.document
    items: list[Features] = []
    for clause in clauses:
        i = clause.task.token
        children = [document.tokens[child] for child in document.children[i]]
        item: Features = {
            "pos": document.tokens[i].tag,
            "dep": document.tokens[i].dep,
            "has_mark": any(child.dep == "mark" for child in children),
            "advmod_child": next((child.lower for child in children if child.dep == "advmod"), ""),
            "has_advcl_child": any(child.dep == "advcl" for child in children),
            "length_conj": sum(child.dep == "conj" for child in children),
        }
        if with_task_type:
            item["task_type"] = clause.task.type
        items.append(item)
    return items


@dataclass(frozen=True)
class Chain:
    """The clauses of an instruction's tasks, with the features of each that hold whatever labels the tasks get."""

    observed: Observed
    clauses: Sequence[Clause]

    @cached_property
    def wordings(self) -> tuple[Wording, ...]:
        return wordings_of(self.clauses)

    @cached_property
    def own(self) -> tuple[Features, ...]:
        """Of every clause the features of its own."""
        return tuple(_own_features(self.observed, self.clauses, k) for k in range(len(self.clauses)))

    @cached_property
    def neighbours(self) -> tuple[Mapping[int, Features], ...]:
        """Of every clause those of the two before and behind it, by how far away they are."""
        return tuple(
            {
                offset: _neighbour_features(self.observed, self.clauses, k, offset)
                for offset in (-2, -1, 1, 2)
                if 0 <= k + offset < len(self.clauses)
            }
            for k in range(len(self.clauses))
        )


def role_features(chain: Chain) -> list[Features]:
    """For every task: is it a condition, a mention of one, or a plain task?"""
    items: list[Features] = []
    for k, (own, neighbours) in enumerate(zip(chain.own, chain.neighbours, strict=True)):
        item = dict(own)
        for offset in (-2, -1, 1, 2):
            item.update(neighbours.get(offset) or {f"{offset:+d}.none": 1.0})
        item.update(_resemblance_features(chain.observed, chain.clauses, k))
        item.update(_surrounding_features(chain.observed, chain.clauses, k))
        items.append(item)
    return items


def attachment_features(chain: Chain, roles: Sequence[str]) -> list[Features]:
    """For every task, the roles being known: to which condition does it belong, and to which side of it?"""
    clauses = chain.clauses
    items: list[Features] = []
    for k, clause in enumerate(clauses):
        item = dict(chain.own[k])
        item["role"] = roles[k]
        item["role.type"] = f"{roles[k]}.{clause.task.type}"
        for offset in (-2, -1, 1, 2):
            item[f"role{offset:+d}"] = roles[k + offset] if 0 <= k + offset < len(roles) else "none"
        item["roles"] = f"{item['role-1']}|{roles[k]}|{item['role+1']}"
        before = [j for j in range(k - 1, -1, -1) if roles[j] in CONDITION_ROLES]
        after = [j for j in range(k + 1, len(roles)) if roles[j] in CONDITION_ROLES]
        item["conditions"] = f"{min(2, len(before))}|{min(2, len(after))}"
        if before:
            item.update(_left_features(clauses, k, before, roles))
        if after:
            item.update(_right_features(clauses, k, after[0]))
        for offset in (-1, 1):
            item.update(chain.neighbours[k].get(offset, {}))
        items.append(item)
    return items


def order_features(chain: Chain, roles: Sequence[str], attachments: Sequence[str]) -> list[Features]:
    """For every task, role and attachment being known: is it executed out of the order of the text?"""
    document, clauses, wordings = chain.observed.document, chain.clauses, chain.wordings
    items: list[Features] = []
    for k, clause in enumerate(clauses):
        item: Features = {
            "bias": 1.0,
            "role": roles[k],
            "attached": attachments[k],
            "boundary": clause.boundary,
            "tag": document.tokens[clause.task.token].tag,
        }
        alike = [j for j, place in enumerate(attachments) if place == attachments[k]]
        ahead = [j for j in alike if j < k]
        behind = [j for j in alike if j > k]
        place = f"{min(2, len(ahead))}.{min(2, len(behind))}"
        opens = k == 0 or clauses[k - 1].sentence != clause.sentence
        for label in clause.wording.orders:
            item[f"says.{label}"] = 1.0
            item[f"says.{label}.place"] = f"{place}.{roles[k]}"
            item[f"says.{label}.opens"] = f"{opens}.{len(ahead) > 0}"
        for label in branch_orders(roles, attachments, wordings, k):
            item[f"branch.{label}"] = f"{place}.{clause.boundary}"
        for label in ("before", "after", "first", "last"):
            item[f"others.{label}.ahead"] = any(label in clauses[j].wording.orders for j in ahead)
            item[f"others.{label}.behind"] = any(label in clauses[j].wording.orders for j in behind)
        for name in ("near", "far", "behind"):
            for cue in _ORDER_CUES.intersection(getattr(clause, name)):
                item[f"{name}.{cue}"] = 1.0
                item[f"{name}.{cue}.first"] = str(k == 0)
                item[f"{name}.{cue}.tag"] = document.tokens[clause.task.token].tag
        for offset in (-1, 1):
            if 0 <= k + offset < len(clauses):
                other = clauses[k + offset]
                for name in ("near", "far", "behind"):
                    for cue in _ORDER_CUES.intersection(getattr(other, name)):
                        item[f"{offset:+d}.{name}.{cue}"] = 1.0
                item[f"{offset:+d}.same_sentence"] = str(other.sentence == clause.sentence)
                item[f"{offset:+d}.same_parent"] = str(attachments[k + offset] == attachments[k])
            else:
                item[f"{offset:+d}.none"] = 1.0
        items.append(item)
    return items


_ORDER_CUES = frozenset(
    (
        "before",
        "before_that",
        "after",
        "until",
        "first",
        "last",
        "after_that",
        "then",
        "while",
        "when",
        "not",
        "if",
        "either_way",
        "but",
    )
)


def _own_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
    document = observed.document
    clause = clauses[k]
    i = clause.task.token
    token = document.tokens[i]
    children = [document.tokens[child] for child in document.children[i]]
    subject = next((child.lower for child in children if child.dep in ("nsubj", "nsubjpass", "expl")), "")
    governing = _last_of(clause.near, GOVERNING)
    item: Features = {
        "bias": 1.0,
        "type": clause.task.type,
        "lemma": token.lemma,
        "tag": token.tag,
        "dep": token.dep,
        "has_mark": any(child.dep == "mark" for child in children),
        "has_advcl": any(child.dep == "advcl" for child in children),
        "conj": min(2, sum(child.dep == "conj" for child in children)),
        "subject": subject if subject in _PRONOUNS | {"you", "i"} else ("noun" if subject else "none"),
        "negated": clause.wording.is_negated,
        "boundary": clause.boundary,
        "governing": governing,
        "governing.type": f"{governing}.{clause.task.type}",
        "question": observed.question[i],
        "question.type": f"{observed.question[i]}.{clause.task.type}",
        "place": "only" if len(clauses) == 1 else "first" if k == 0 else "last" if k == len(clauses) - 1 else "inside",
        "new_sentence": k == 0 or clauses[k - 1].sentence != clause.sentence,
        "ends_sentence": k == len(clauses) - 1 or clauses[k + 1].sentence != clause.sentence,
    }
    for name in ("near", "far", "behind"):
        for cue in dict.fromkeys(getattr(clause, name)):
            if cue in _SIGNALS:
                item[f"{name}.{cue}"] = 1.0
    if k and clause.wording.joins:
        item["joins"] = clause.wording.joins
        item["joins.types"] = f"{clause.wording.joins}.{clauses[k - 1].task.type}.{clause.task.type}"
        item["joins.opened"] = f"{clause.wording.joins}.{_last_of(clauses[k - 1].near, GOVERNING)}.{clause.task.type}"
    first_word = document.tokens[min(clause.first, i)].lower
    item["first_word"] = first_word
    item["type.new_sentence"] = f"{clause.task.type}.{item['new_sentence']}"
    item["near.type"] = f"{'+'.join(sorted(set(clause.near) & _STRONG))}.{clause.task.type}"
    item["far.signal"] = "+".join(sorted(set(clause.far) & _STRONG))
    return item


_STRONG = frozenset(
    ("if", "only_if", "unless", "when", "else", "fail", "so", "either_way", "before", "after", "until", "whether")
)


def _neighbour_features(observed: Observed, clauses: Sequence[Clause], k: int, offset: int) -> Features:
    other = clauses[k + offset]
    token = observed.document.tokens[other.task.token]
    mark = f"{offset:+d}"
    item: Features = {
        f"{mark}.type": other.task.type,
        f"{mark}.types": f"{other.task.type}|{clauses[k].task.type}",
        f"{mark}.same_sentence": other.sentence == clauses[k].sentence,
        f"{mark}.governing": _last_of(other.near, GOVERNING),
        f"{mark}.tag": token.tag,
        f"{mark}.negated": other.wording.is_negated,
        f"{mark}.question": observed.question[other.task.token],
    }
    for name in ("near", "far", "behind"):
        for cue in _STRONG.intersection(getattr(other, name)):
            item[f"{mark}.{name}.{cue}"] = 1.0
    if offset == 1:
        item["+1.far.first"] = next(
            (cue for cue in other.far if cue in _STRONG), next((cue for cue in other.near if cue in _STRONG), "")
        )
        item["+1.signal.type"] = f"{item['+1.far.first']}.{clauses[k].task.type}"
    return item


_OPENING = frozenset(("if", "only_if", "unless", "when", "depending"))
_CLOSING = frozenset(("else", "fail", "so"))


def _awaited(clauses: Sequence[Clause], k: int) -> str:
    """The next "otherwise", "if not" or "if that fails" after a task, unless another condition is opened before it: its
    condition must stand at or before it. With how many tasks and sentences lie between."""
    for m in range(k + 1, len(clauses)):
        words = (*clauses[m].far, *clauses[m].near)
        name = next((cue for cue in ("fail", "else", "so") if cue in words), None)
        if name is not None:
            checks = sum(clauses[j].task.type in ("check_state", "searching") for j in range(k + 1, m))
            return f"{name}.{min(3, m - k)}.{min(2, clauses[m].sentence - clauses[k].sentence)}.{min(1, checks)}"
        if any(cue in _OPENING for cue in words):
            return "opened"
    return "nothing"


def _surrounding_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
    """Which cues stand anywhere ahead and behind: without any, nothing is a condition; and how the task joins the
    clause before it ("if A and B")."""
    clause = clauses[k]
    ahead = {cue for other in clauses[k + 1 :] for cue in (*other.far, *other.near)} | set(clause.behind)
    own = {*clause.far, *clause.near}
    behind = {cue for other in clauses[:k] for cue in (*other.far, *other.near, *other.behind)}
    item: Features = {
        "ahead.if": bool(ahead & _OPENING),
        "ahead.else": bool(ahead & _CLOSING),
        "behind.if": bool(behind & _OPENING),
        "type.ahead": f"{clause.task.type}.{bool(ahead & _OPENING)}.{bool(ahead & _CLOSING)}.{bool(own & _OPENING)}",
    }
    awaited = _awaited(clauses, k)
    item["awaited"] = awaited
    item["awaited.type"] = f"{awaited}.{clause.task.type}.{observed.question[clause.task.token]}"
    for distance in (1, 2):
        if k + distance < len(clauses):
            signals = {*clauses[k + distance].far, *clauses[k + distance].near} & _STRONG
            pronoun = "own" if clauses[k + distance].objects else "pro"
            kinds = f"{clauses[k + distance].task.type}.{pronoun}.{clause.task.type}"
            item[f"ahead{distance}"] = f"{'+'.join(sorted(signals))}.{kinds}"
    if k and clauses[k - 1].sentence == clause.sentence:
        before = clauses[k - 1]
        joint = "or" if "or" in clause.near else "and" if "and" in clause.near else "none"
        opened = _last_of((*before.far, *before.near), GOVERNING)
        item["joint"] = f"{joint}.{opened}.{_last_of(clause.near, GOVERNING)}.{clause.task.type}.{clause.boundary}"
        item["joint.else"] = f"{item['joint']}.{bool(ahead & _CLOSING)}"
    return item


def _resemblance_features(observed: Observed, clauses: Sequence[Clause], k: int) -> Features:
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
    item["object.type"] = f"{item['object']}.{clause.task.type}.{_last_of(clause.near, GOVERNING)}"
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
    says = "state" if any(kind == "state" for kind, _ in clause.task.arguments) else (
        "place" if any(kind == "location" for kind, _ in clause.task.arguments) else "nothing"
    )
    what = "noun" if clause.objects else "pronoun" if _speaks_of_pronoun(observed, clause) else "none"
    opens = _last_of(clause.near, GOVERNING)
    item: Features = {"says": f"{says}.{what}.{opens}.{clause.wording.is_negated}"}
    for rank, j in enumerate(earlier[:2]):
        other = clauses[j]
        same = tokens[other.task.token].lemma == lemma
        shared = bool(set(clause.objects) & set(other.objects))
        differs = clause.wording.is_negated != other.wording.is_negated
        opposite = clause.wording.is_opposite_of(other.wording)
        asked = "question" if observed.question[other.task.token] else _last_of(other.near, GOVERNING)
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
    what = "none" if subject is None else subject.lower if subject.lower in _SUBJECTS else (
        "shared" if subject.lemma in action.nouns else subject.pos
    )
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


_SUBJECTS = frozenset("it they that this you there he she any none".split())
_OUTCOMES = ("there", "work", "fail", "open", "gone", "stuck", "possible", "manage", "reach", "budge")


def _speaks_of_pronoun(observed: Observed, clause: Clause) -> bool:
    return any(observed.document.tokens[j].lower in _PRONOUNS for j in range(clause.first, clause.last + 1))


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


def _left_features(clauses: Sequence[Clause], k: int, before: Sequence[int], roles: Sequence[str]) -> Features:
    j = before[0]
    clause, condition = clauses[k], clauses[j]
    sentences = min(2, clause.sentence - condition.sentence)
    shape = _shape(clauses, j)
    governing = _last_of(condition.near, GOVERNING)
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
    for cue in _SIGNALS:
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


def _right_features(clauses: Sequence[Clause], k: int, j: int) -> Features:
    clause, condition = clauses[k], clauses[j]
    governing = _last_of(condition.near, GOVERNING)
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
        "right.opens": "+".join(sorted(opens & _STRONG)),
        "right.shape": f"{shape}.{sentences}",
        "right.shape.gap": f"{shape}.{sentences}.{min(3, j - k)}.{governing}",
        "right.but": f"{'but' in (*condition.near, *condition.far)}.{shape}.{sentences}",
    }


def _replacement_features(clauses: Sequence[Clause], k: int, j: int, joiner: str) -> Features:
    """Whether what follows the condition `j` takes the place of task `k` ahead of it ("bring me the tea, but if it is
    cold, the milk instead"): then `k` belongs to the other side."""
    consequences = [
        m for m in range(j + 1, min(j + 4, len(clauses))) if clauses[m].sentence <= clauses[j].sentence + 1
    ]
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


def _last_of(names: Sequence[str], wanted: frozenset[str]) -> str:
    return next((name for name in reversed(names) if name in wanted), "none")
