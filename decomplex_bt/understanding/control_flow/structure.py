"""Features of tasks in their order, for the models of role, attachment and order, and for the paper's model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from decomplex_bt.understanding.control_flow.arcs import CONDITION_ROLES, Wording, other_orders
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import wordings_of
from decomplex_bt.understanding.control_flow.reach import left_features, right_features
from decomplex_bt.understanding.control_flow.resemblance import PRONOUNS, resemblance_features
from decomplex_bt.understanding.crf import Features
from decomplex_bt.understanding.cue_phrases import GOVERNING, SIGNALS, STRONG, last_of
from decomplex_bt.understanding.features import Observed


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
        item.update(resemblance_features(chain.observed, chain.clauses, k))
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
            item.update(left_features(clauses, k, before, roles))
        if after:
            item.update(right_features(clauses, k, after[0]))
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
        item["rest"] = rest = _rest(clauses, k, behind)
        joint = _joint(clause)
        if k and document.tokens[clauses[k - 1].task.token].lemma in _WAITING:  # "wait until ..." is in order as it is
            item["waits"] = "+".join(sorted({"until", "after", "when"}.intersection(clause.near)))
        nearby = min(3, sum(clauses[j].sentence == clause.sentence for j in ahead))
        for label in clause.wording.orders:
            item[f"says.{label}"] = 1.0
            item[f"says.{label}.place"] = f"{place}.{roles[k]}"
            item[f"says.{label}.opens"] = f"{opens}.{len(ahead) > 0}"
            item[f"says.{label}.rest"] = rest
            item[f"says.{label}.ahead"] = f"{min(3, len(ahead))}.{nearby}"
        for label in other_orders(roles, attachments, wordings, k):
            item[f"elsewhere.{label}"] = f"{place}.{clause.boundary}"
            item[f"elsewhere.{label}.role"] = roles[k]
        for label in ("before", "after", "first", "last"):
            item[f"others.{label}.ahead"] = any(label in clauses[j].wording.orders for j in ahead)
            item[f"others.{label}.behind"] = any(label in clauses[j].wording.orders for j in behind)
        for name in ("near", "far", "behind"):
            for cue in sorted(_ORDER_CUES.intersection(getattr(clause, name))):
                item[f"{name}.{cue}"] = 1.0
                item[f"{name}.{cue}.first"] = str(k == 0)
                item[f"{name}.{cue}.tag"] = document.tokens[clause.task.token].tag
                item[f"{name}.{cue}.rest"] = rest
                item[f"{name}.{cue}.frame"] = f"{clause.boundary}.{joint}.{rest}"
        for offset in (-1, 1):
            if 0 <= k + offset < len(clauses):
                other = clauses[k + offset]
                for name in ("near", "far", "behind"):
                    for cue in sorted(_ORDER_CUES.intersection(getattr(other, name))):
                        item[f"{offset:+d}.{name}.{cue}"] = 1.0
                item[f"{offset:+d}.same_sentence"] = str(other.sentence == clause.sentence)
                item[f"{offset:+d}.same_parent"] = str(attachments[k + offset] == attachments[k])
            else:
                item[f"{offset:+d}.none"] = 1.0
        items.append(item)
    return items


def _joint(clause: Clause) -> str:
    return next((word for word in ("and", "or", "but") if word in clause.near), "none")


def _rest(clauses: Sequence[Clause], k: int, behind: Sequence[int]) -> str:
    """What a task may take along: how many siblings follow it in its sentence, and how the next one joins it."""
    same = [j for j in behind if clauses[j].sentence == clauses[k].sentence]
    if not same:
        return "0"
    following = clauses[same[0]]
    return f"{min(2, len(same))}.{_joint(following)}.{following.boundary}.{'says' if following.wording.orders else ''}"


_WAITING = frozenset(("wait", "stay"))
_ORDER_CUES = frozenset(
    (
        "before",
        "before_that",
        "before_all",
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
    governing = last_of(clause.near, GOVERNING)
    item: Features = {
        "bias": 1.0,
        "type": clause.task.type,
        "lemma": token.lemma,
        "tag": token.tag,
        "dep": token.dep,
        "has_mark": any(child.dep == "mark" for child in children),
        "has_advcl": any(child.dep == "advcl" for child in children),
        "conj": min(2, sum(child.dep == "conj" for child in children)),
        "subject": subject if subject in PRONOUNS | {"you", "i"} else ("noun" if subject else "none"),
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
            if cue in SIGNALS:
                item[f"{name}.{cue}"] = 1.0
    if k and clause.wording.joins:
        item["joins"] = clause.wording.joins
        item["joins.types"] = f"{clause.wording.joins}.{clauses[k - 1].task.type}.{clause.task.type}"
        item["joins.opened"] = f"{clause.wording.joins}.{last_of(clauses[k - 1].near, GOVERNING)}.{clause.task.type}"
    first_word = document.tokens[min(clause.first, i)].lower
    item["first_word"] = first_word
    item["type.new_sentence"] = f"{clause.task.type}.{item['new_sentence']}"
    item["near.type"] = f"{'+'.join(sorted(set(clause.near) & STRONG))}.{clause.task.type}"
    item["far.signal"] = "+".join(sorted(set(clause.far) & STRONG))
    return item


def _neighbour_features(observed: Observed, clauses: Sequence[Clause], k: int, offset: int) -> Features:
    other = clauses[k + offset]
    token = observed.document.tokens[other.task.token]
    mark = f"{offset:+d}"
    item: Features = {
        f"{mark}.type": other.task.type,
        f"{mark}.types": f"{other.task.type}|{clauses[k].task.type}",
        f"{mark}.same_sentence": other.sentence == clauses[k].sentence,
        f"{mark}.governing": last_of(other.near, GOVERNING),
        f"{mark}.tag": token.tag,
        f"{mark}.negated": other.wording.is_negated,
        f"{mark}.question": observed.question[other.task.token],
    }
    for name in ("near", "far", "behind"):
        for cue in sorted(STRONG.intersection(getattr(other, name))):
            item[f"{mark}.{name}.{cue}"] = 1.0
    if offset == 1:
        item["+1.far.first"] = next(
            (cue for cue in other.far if cue in STRONG), next((cue for cue in other.near if cue in STRONG), "")
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
            signals = {*clauses[k + distance].far, *clauses[k + distance].near} & STRONG
            pronoun = "own" if clauses[k + distance].objects else "pro"
            kinds = f"{clauses[k + distance].task.type}.{pronoun}.{clause.task.type}"
            item[f"ahead{distance}"] = f"{'+'.join(sorted(signals))}.{kinds}"
    if k and clauses[k - 1].sentence == clause.sentence:
        before = clauses[k - 1]
        joint = "or" if "or" in clause.near else "and" if "and" in clause.near else "none"
        opened = last_of((*before.far, *before.near), GOVERNING)
        item["joint"] = f"{joint}.{opened}.{last_of(clause.near, GOVERNING)}.{clause.task.type}.{clause.boundary}"
        item["joint.else"] = f"{item['joint']}.{bool(ahead & _CLOSING)}"
    return item
