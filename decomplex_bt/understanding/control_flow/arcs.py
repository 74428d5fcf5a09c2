"""Control flow as one small label per task: what a sequence model can predict, a tree can be built from
(`construction`), and an annotated tree gives back (`derivation`).

Every task, in text order, has a role, an attachment and an order. The paper's four labels (DeComplex, Table I) say role
and branch; they cannot say to which condition a branch belongs, nesting, mentions, joint conditions or an order other
than that of the text. The labels here can:

role        `task`, `condition`, `mention` (of an earlier condition), `and` / `or` (a condition joined to the one
            before), `again` (a further mention of an unconditional task)
attachment  `top`, or direction, rank and side: `<1+` is the branch of the nearest condition to the left that follows
            when that clause holds *as it is stated*, `>1-` that of the nearest one to the right when it does not;
            without a side, `<1`, the condition that a mention is of, or how many plain tasks back an `again` means.
            Conditions count by groups of mentions; seen from the left, conditions joined by "and" / "or" count as one,
            their last. "As stated" includes the clause's own negation, so that `+` is the
            plain case after "if it is not there" too; the negation is a matter of grammar and handed in. `>1+=` is
            that branch and the other, which no model says and a rule may
order       `keep` (text order), `before` (ahead of the sibling before it), `first` (ahead of all siblings),
            `after` (behind the siblings after it in its sentence, at least one), `last` (behind all siblings);
            `before+` and `first+` take the siblings after it in its sentence along, as far as they have no order of
            their own ("lock up, but before that feed the cat and close the window")
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

ROLES = ("task", "condition", "mention", "and", "or", "again")
CONDITION_ROLES = frozenset(("condition", "mention", "and", "or"))
JOINTS = frozenset(("and", "or"))
ORDERS = ("keep", "before", "after", "first", "last", "before+", "first+")
TOP = "top"
BOTH = "="
"""Ends an attachment of what is done on the other side as well."""
_DESERTED = frozenset("free empty vacant unoccupied available deserted clear".split())
"""Says of a place that nobody is there."""
_AT_WORK = frozenset("working running going functioning operating operational lit live powered".split())
"""Says of what is switched on that it does what it should."""

_USED_UP = frozenset("empty gone finished".split())
"""Says that there is nothing in something, or none left of it."""
_OUT_OF_ORDER = frozenset("broken bust busted faulty defective dead".split())


@dataclass(frozen=True, slots=True)
class Arc:
    """The three labels of one task."""

    role: str = "task"
    attachment: str = TOP
    order: str = "keep"


@dataclass(frozen=True, slots=True)
class Wording:
    """What the words of a task's clause say for certain: whether it is negated, a state it tests with its opposite, if
    any, the number of its sentence, the order labels that its own cues speak for ("before you ...": `after`), and the
    `and` or `or` that joins it, as stated, to the clause before it as stated, without an "if" of its own ("unless A or
    B" is not A `and` not B). `is_contrary`: by its word alone it says that something failed or is not there ("if it
    sticks", "if she is gone"). `is_echo`: it affirms what was said and says no more ("if she is").
    `is_of_anybody`: it asks if somebody is somewhere or does something. `is_of_rest`: it says, its negation aside, that
    there is something in or left of something, or that this is there ("if there's *some left*"); `is_at_work`: that
    something works. `is_of_stock`: it asks for any of something ("if *there's any water* in the bowl")."""

    is_negated: bool = False
    state: str | None = None
    opposite: str | None = None
    sentence: int = 0
    orders: tuple[str, ...] = ()
    joins: str = ""
    is_contrary: bool = False
    is_echo: bool = False
    is_of_anybody: bool = False
    is_of_rest: bool = False
    is_at_work: bool = False
    is_of_stock: bool = False

    def is_opposite_of(self, other: Wording) -> bool:
        return self.state is not None and self.opposite is not None and other.state == self.opposite

    def contradicts(self, first: Wording) -> bool:
        """Whether a mention, its negation aside, says the opposite of what it mentions: another state of the same
        thing (else why say it), or that it failed."""
        is_at_work = first.state == "on" and self.state in _AT_WORK  # "turn on the fan; if it isn't working, ..."
        if self.state is not None and first.state is not None and self.state != first.state and not is_at_work:
            return True
        if first.is_of_anybody and self.state in _DESERTED:
            return True  # "see if anyone is in there. If it's free, ..."
        if first.is_of_stock and self.state in _USED_UP:
            return True  # "see if there's any water in the bowl. If it's empty, ..."
        if (self.is_of_rest and first.state in _USED_UP) or (self.is_at_work and first.state in _OUT_OF_ORDER):
            return True
        return self.is_contrary and not first.is_contrary


def is_flipped(mention: int, first: int, wordings: Sequence[Wording]) -> bool:
    """Whether a mention as stated is by grammar the opposite of its first mention without that one's negation."""
    flipped = wordings[mention].is_negated
    if mention != first and wordings[mention].contradicts(wordings[first]):
        flipped = not flipped
    return flipped


def side_of(is_opposite: bool) -> str:
    return "else" if is_opposite else "then"


def flip_of(token: int, first: int, wordings: Sequence[Wording], used: set[str]) -> bool:
    """`is_flipped`, but who states a condition again whose one side has its tasks already means the other side:
    "if it is dry, fold it; if it is damp, hang it up" needs no word list to know that damp is not dry. The
    echo of what is denied affirms it: "don't lock up unless she is in; if she is, tell her"."""
    flipped = is_flipped(token, first, wordings)
    is_affirmed = wordings[token].is_echo and wordings[first].is_negated
    if token != first and not is_affirmed and side_of(flipped) in used and len(used) == 1:
        return not flipped
    return flipped


def other_side(side: str) -> str:
    return "else" if side == "then" else "then"


def repeated(roles: Sequence[str], attachments: Sequence[str], i: int) -> int | None:
    """The earlier plain task that task `i`, an `again`, mentions: as many plain tasks back as the attachment's rank
    says."""
    earlier = [j for j in range(i - 1, -1, -1) if roles[j] == "task"]
    rank = int(attachments[i][1]) if attachments[i] != TOP else 1
    return earlier[min(rank, len(earlier)) - 1] if earlier else None


def other_orders(
    roles: Sequence[str], attachments: Sequence[str], wordings: Sequence[Wording], i: int
) -> tuple[str, ...]:
    """The order labels that other clauses speak for in place of task `i`'s own: further mentions of it ("sweep the
    hall, and before you sweep it ..."), the consequences of a condition: in "fetch the cup; if it is dirty, wash it
    first" it is the whole condition that comes first."""
    found: list[str] = []
    if roles[i] not in CONDITION_ROLES:
        for m in range(i + 1, len(roles)):
            if roles[m] == "again" and repeated(roles, attachments, m) == i:
                found += wordings[m].orders
        return tuple(dict.fromkeys(found))
    for m in range(i + 1, len(roles)):
        if roles[m] in CONDITION_ROLES or not attachments[m].startswith("<1"):
            break
        found += [order for order in wordings[m].orders if order in ("before", "first")]
    return tuple(dict.fromkeys(found))
