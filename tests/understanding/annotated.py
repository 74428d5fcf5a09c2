"""Clauses of annotated text, for tests of what is made certain of roles and sides."""

from __future__ import annotations

from re import findall

from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.control_flow.clause import Clause
from decomplex_bt.understanding.control_flow.clauses import clauses_of
from decomplex_bt.understanding.dependencies import marked_tasks
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer

DOMAIN = load_domain("household")
PARSER = Parser()


def clauses(markup: str) -> tuple[Clause, ...]:
    """The clauses of the tasks of an instruction in markup, in text order; each task number has one digit."""
    count = max(int(number) for number in findall(r"\((\d)", markup))
    instruction = read_markup(markup, DOMAIN.ontology, flow=list(range(1, count + 1)))
    observed = Observed(PARSER.parse(instruction.text), Gazetteer.of(DOMAIN.lexicon, DOMAIN.kinds))
    return clauses_of(observed, marked_tasks(observed, instruction))
