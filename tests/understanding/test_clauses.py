"""Which clauses can be mentions of an earlier condition."""

from __future__ import annotations

from re import findall

import pytest

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.clauses import Clause, clauses_of
from decomplex_bt.understanding.dependencies import chained_roles, marked_tasks
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer

DOMAIN = load_domain("household")
PARSER = Parser()


def clauses(markup: str) -> tuple[Clause, ...]:
    count = max(int(number) for number in findall(r"\((\d)", markup))
    instruction = read_markup(markup, DOMAIN.ontology, flow=list(range(1, count + 1)))
    observed = Observed(PARSER.parse(instruction.text), Gazetteer.of(DOMAIN.lexicon, DOMAIN.kinds))
    return clauses_of(observed, marked_tasks(observed, instruction))


@pytest.mark.parametrize(
    "markup",
    [
        # where it is, then how it is
        "[Check](1:check_state) whether [the boots](1:object) are [in the hall](1:location). If [they](2:object) "
        "[are](2:check_state) [muddy](2:state), [wash](3:change_state) [them](3:object).",
        # one timer, several scones
        "When [the timer](1:object) [rings](1:check_state), [open](2:change_state) [the oven](2:object). If "
        "[they](3:object)['re](3:check_state) [pale](3:state), [close](4:change_state) [it](4:object).",
    ],
)
def test_a_check_of_another_matter_is_a_condition_of_its_own(markup: str) -> None:
    found = clauses(markup)
    later = next(k for k in range(1, len(found)) if found[k].task.type == "check_state")
    assert found[later].is_of_another(found[0])
    roles = ["condition", *["task"] * (len(found) - 1)]
    roles[later] = "mention"
    assert chained_roles(found, roles)[later] == "condition"


@pytest.mark.parametrize(
    "markup",
    [
        "If [the boots](1:object) [are](1:check_state) [in the hall](1:location), [wash](2:change_state) "
        "[them](2:object). If [they](3:object)['re](3:check_state) [gone](3:state), [tell](4:informing) me.",
        "If [the boots](1:object) [are](1:check_state) [wet](1:state), [dry](2:change_state) [them](2:object). If "
        "[they](3:object)['re](3:check_state) [dry](3:state), [tell](4:informing) me.",
        "If [the drops](1:object) [are](1:check_state) [in it](1:location), [bring](2:bringing) [it](2:object). If "
        "[they](3:object) [are](3:check_state)n't, [tell](4:informing) me.",
    ],
)
def test_what_says_the_same_again_or_its_opposite_stays_a_mention(markup: str) -> None:
    found = clauses(markup)
    assert not found[2].is_of_another(found[0])
    roles = ("condition", "task", "mention", "task")
    assert chained_roles(found, roles) == roles
