"""What an instruction tells of single words: looks, shouts, questions, deeds of others, and which are idle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.looks import looks, shouts
from decomplex_bt.understanding.references.relatives import found_places
from decomplex_bt.understanding.rules.background.accounts import accounts
from decomplex_bt.understanding.rules.background.purposes import purposes
from decomplex_bt.understanding.rules.cases.deeds_of_others import deeds_of_others
from decomplex_bt.understanding.rules.cases.precautions import precautions
from decomplex_bt.understanding.rules.cases.questions import Question, questions
from decomplex_bt.understanding.rules.cases.waits import forgone
from decomplex_bt.understanding.rules.ellipses.sequels import sequels
from decomplex_bt.understanding.rules.orders.assistance import helping_hands
from decomplex_bt.understanding.rules.orders.causatives import without_tasks
from decomplex_bt.understanding.rules.orders.omissions import omitted
from decomplex_bt.understanding.rules.orders.pauses import pauses
from decomplex_bt.understanding.rules.orders.prohibitions import let_be
from decomplex_bt.understanding.rules.orders.reports import within_reports

HANDLING = frozenset(("taking", "placing", "bringing", "change_state"))
"""The types of tasks that do something to a thing."""


@dataclass(frozen=True, slots=True)
class Findings:
    """Of an instruction: the `looks` by their verbs, with their words; the verbs of `shouts`; the `questions` and the
    `deeds` of others, by their verbs; and the `idle` words, which carry no task, whatever a model makes of them.

    `tasks` maps token indices to the task types that the model found.
    """

    tasks: Mapping[int, str]
    looks: Mapping[int, range]
    shouts: frozenset[int]
    questions: Mapping[int, Question]
    deeds: frozenset[int]
    idle: frozenset[int]

    @classmethod
    def of(cls, observed: Observed, tasks: Mapping[int, str]) -> Findings:
        document = observed.document
        asked = {question.verb: question for question in questions(document, tasks)}
        deeds = list(deeds_of_others(document))
        idle = frozenset().union(
            forgone(document),
            let_be(document),
            without_tasks(observed),
            omitted(observed),
            within_reports(document, tasks),
            precautions(document, tasks),
            purposes(document, tasks),
            accounts(document, tasks),
            *pauses(document),
            *helping_hands(document),
            *found_places(document),
            *(deed.idle for deed in deeds),
            *(sequel.words for sequel in sequels(observed, tasks)),
            *(question.tokens for question in asked.values()),
        )
        return cls(
            tasks,
            {look.verb: look.words for look in looks(document)},
            frozenset(shout.verb for shout in shouts(document)),
            asked,
            frozenset(deed.verb for deed in deeds),
            idle,
        )
