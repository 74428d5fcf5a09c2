"""Amendments: the arguments that a model found, with what is certain of them whatever it found: those that are taken
back, corrected or said aside are other ones or none."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument, FoundArguments
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.relatives import found_places
from decomplex_bt.understanding.rules.background.accounts import without_accounts
from decomplex_bt.understanding.rules.background.guesses import without_guessed
from decomplex_bt.understanding.rules.background.hearsay import hearsays
from decomplex_bt.understanding.rules.background.plans import plans
from decomplex_bt.understanding.rules.background.purposes import purposes
from decomplex_bt.understanding.rules.background.statements import with_nearer_places, without_places_of_others
from decomplex_bt.understanding.rules.cases.conditions import without_cases
from decomplex_bt.understanding.rules.cases.deeds_of_others import deeds_of_others
from decomplex_bt.understanding.rules.cases.echoes import echoes
from decomplex_bt.understanding.rules.cases.precautions import precautions
from decomplex_bt.understanding.rules.cases.questions import with_questions
from decomplex_bt.understanding.rules.cases.waits import forgone
from decomplex_bt.understanding.rules.ellipses.alternatives import alternatives
from decomplex_bt.understanding.rules.ellipses.gapping import with_added, with_gapped
from decomplex_bt.understanding.rules.ellipses.second_cases import second_cases
from decomplex_bt.understanding.rules.ellipses.sequels import with_sequels
from decomplex_bt.understanding.rules.ellipses.unspoken import unspoken
from decomplex_bt.understanding.rules.ellipses.verbless import verbless_cases
from decomplex_bt.understanding.rules.orders.assistance import helping_hands
from decomplex_bt.understanding.rules.orders.assurances import with_assured
from decomplex_bt.understanding.rules.orders.fronting import with_fronted
from decomplex_bt.understanding.rules.orders.handing import accompanied
from decomplex_bt.understanding.rules.orders.needs import due
from decomplex_bt.understanding.rules.orders.omissions import omitted
from decomplex_bt.understanding.rules.orders.pauses import pauses
from decomplex_bt.understanding.rules.orders.prohibitions import let_be, prohibitions
from decomplex_bt.understanding.rules.orders.turns import with_turns
from decomplex_bt.understanding.rules.orders.uses import with_uses
from decomplex_bt.understanding.rules.orders.wishes import backgrounds, wishers
from decomplex_bt.understanding.rules.spans.bounds import up_to_order
from decomplex_bt.understanding.rules.spans.corrections import (
    corrected,
    dated,
    entire,
    is_bare_preposition,
    is_of_nobody,
    is_of_wish,
    is_one_who_asks,
    is_said_again,
    told_behind,
    with_choices_as_one,
    with_either_place,
    with_goal_of_somebody,
    with_spill_cleaned_up,
    with_thing_asked_for,
    without_looks,
)
from decomplex_bt.understanding.rules.spans.extents import (
    with_features,
    with_marks,
    with_passages,
    with_purposes,
    with_whole_clauses,
    with_whole_compounds,
    with_whole_pairs,
    with_whole_places,
    without_questions,
)
from decomplex_bt.understanding.rules.spans.relatives import told_apart, with_relative_places, without_excluded
from decomplex_bt.understanding.rules.spans.shares import with_shares
from decomplex_bt.understanding.rules.spans.task_arguments import Setting, of_task
from decomplex_bt.understanding.rules.speech.asides import asides, means_of, reasons
from decomplex_bt.understanding.rules.speech.contractions import reports
from decomplex_bt.understanding.rules.speech.withdrawals import Withdrawals
from decomplex_bt.understanding.vocabulary import ONES

_PLACES = frozenset(("source", "location"))
_WHERE_TO = _PLACES | {"goal"}
_WAYS = frozenset(("path", "manner"))

Tasks = Mapping[int, str]
"""The types of tasks by the tokens that carry them."""


def amended(observed: Observed, tasks: Tasks, withdrawals: Withdrawals, found: FoundArguments) -> FoundArguments:
    """The arguments in the order of the text, put right in five steps, each of which takes what the one before left.

    What is said of no task goes first, so that nothing below takes it for the neighbour of something. Then come whole
    phrases, then single ones, which may end where another begins; then each task by itself; and last what is said
    without a verb, which has no task of its own to find it.
    """
    kept = _of_tasks(observed, tasks, withdrawals, found.arguments)
    kept = _with_whole_phrases(observed, tasks, kept)
    kept = _put_right(observed, tasks, withdrawals, kept)
    setting = Setting.of(observed, tasks)
    for task in tasks:
        kept = of_task(setting, kept, task)
    kept = _told_without_verb(observed, tasks, kept)
    kept = _beside_each_other(observed, tasks, kept)
    return FoundArguments(tuple(sorted(kept, key=lambda argument: argument.tokens.start)), found.probability)


def _of_tasks(
    observed: Observed, tasks: Tasks, withdrawals: Withdrawals, arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments without those that are forbidden, said aside or of somebody's plans; a place may be told by a
    reason ("since it's still *in the sink*, fish it out")."""
    document = observed.document
    idle = withdrawals.tokens | asides(document, tasks) | prohibitions(observed, tasks) | backgrounds(document, tasks)
    idle |= due(document) | forgone(document) | hearsays(document) | precautions(document, tasks)
    idle = idle.union(*(deed.idle for deed in deeds_of_others(document)))
    idle |= wishers(document, tasks) | let_be(document) | omitted(observed)
    unsaid = (found.tokens for found in alternatives(observed, tasks) if not found.is_verbal)
    idle = idle.union(*found_places(document), *pauses(document), *helping_hands(document), *unsaid)
    why, meant, how = reasons(document, tasks), plans(document, tasks), means_of(document, tasks)
    what_for = purposes(document, tasks)

    def is_of_task(argument: FoundArgument) -> bool:
        start, kind = argument.tokens.start, argument.type
        is_place = kind in _WHERE_TO and tasks.get(argument.owner) != "check_state"
        return not (
            start in idle
            or (start in why and kind not in _PLACES)
            or (start in meant | what_for and not is_place)
            or (start in how and kind not in _WAYS)
        )

    return [argument for argument in arguments if is_of_task(argument)]


def _with_whole_phrases(observed: Observed, tasks: Tasks, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with all that belongs to the thing or the place that they name, and nothing else."""
    document = observed.document
    kept = with_turns(document, tasks, without_cases(document, tasks, list(arguments)))
    kept = with_whole_compounds(document, tasks, kept)
    kept = with_whole_clauses(document, with_whole_pairs(document, with_whole_places(document, kept)))
    kept = with_passages(document, tasks, without_questions(document, tasks, kept))
    kept = with_uses(document, with_marks(document, tasks, with_features(document, tasks, kept)))
    kept = with_relative_places(observed, tasks, kept)
    kept = without_excluded(document, tasks, told_apart(document, tasks, kept))
    return with_questions(document, tasks, kept)


def _put_right(
    observed: Observed, tasks: Tasks, withdrawals: Withdrawals, arguments: Sequence[FoundArgument]
) -> list[FoundArgument]:
    """The arguments, each of the type and the task that its own words tell, and as the speaker corrects it."""
    document = observed.document
    kept = with_spill_cleaned_up(document, tasks, [with_goal_of_somebody(document, tasks, a) for a in arguments])
    kept = dated(document, [told_behind(document, tasks, a, kept) for a in kept])
    kept = [with_thing_asked_for(document, tasks, entire(document, a), kept) for a in kept]
    kept = [a for a in kept if not is_said_again(document, a, kept) and not is_of_wish(tasks, a)]
    kept = without_looks(document, tasks, [a for a in kept if not is_of_nobody(document, a)])
    for phrase in withdrawals.corrections:
        kept = corrected(observed, kept, phrase)
    for telling, echo in echoes(document, tasks).items():
        kept = [a for a in kept if (a.owner, a.type) != (telling, "message") or not set(a.tokens) & set(echo.tokens)]
    return kept


def _told_without_verb(observed: Observed, tasks: Tasks, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments with what reports, fragments, second and verbless cases tell, which have no verb of their own."""
    document, kept = observed.document, list(arguments)
    for report in reports(document, tasks):
        if report.message:
            kept = [a for a in kept if a.tokens.start not in report.message]
            kept.append(FoundArgument("message", report.verb, report.message, CERTAIN))
    for fragment in unspoken(observed, tasks):
        if fragment.carrier in tasks:
            kept = [argument for argument in kept if set(argument.tokens).isdisjoint(fragment.tokens)]
            kept += [FoundArgument(name, fragment.carrier, said, CERTAIN) for name, said in fragment.told.items()]
    kept = with_shares(document, tasks, with_assured(document, tasks, kept))
    for case in second_cases(document):
        if case.carrier in tasks:
            kept = [_cut_short(a, case.tokens.start) for a in kept if a.tokens.start not in case.tokens]
            kept += [FoundArgument(name, case.carrier, said, CERTAIN) for name, said in case.told.items()]
    for case in verbless_cases(observed, tasks):
        within = [argument for argument in kept if not set(argument.tokens).isdisjoint(case.tokens)]
        if case.carrier in tasks and not _is_named(document, within, case.carrier):
            kept = [argument for argument in kept if argument not in within]
            kept += [FoundArgument(name, case.carrier, said, CERTAIN) for name, said in case.told.items()]
    return kept


def _cut_short(argument: FoundArgument, stop: int) -> FoundArgument:
    """The argument up to a token, where it begins ahead of that."""
    start = argument.tokens.start
    return replace(argument, tokens=range(start, min(argument.tokens.stop, stop))) if start < stop else argument


def _is_named(document: Document, arguments: Sequence[FoundArgument], carrier: int) -> bool:
    """Whether a verbless case already has an argument that names something, and is no mere word of a phrase."""
    last = [document.tokens[a.tokens[-1]] for a in arguments if a.owner == carrier]
    return any(token.pos in ("NOUN", "PROPN", "NUM") or token.lower in ONES for token in last)


def _beside_each_other(observed: Observed, tasks: Tasks, arguments: Sequence[FoundArgument]) -> list[FoundArgument]:
    """The arguments as those around settle them: two of a choice, what is left unsaid, whose a place is."""
    document = observed.document
    kept = with_either_place(document, tasks, with_choices_as_one(document, arguments))
    kept = with_gapped(observed, tasks, accompanied(document, tasks, kept))
    kept = with_fronted(observed, tasks, with_sequels(observed, tasks, with_added(observed, tasks, kept)))
    kept = without_accounts(document, tasks, without_places_of_others(observed, tasks, kept))
    kept = with_purposes(document, tasks, kept)
    kept = [up_to_order(document, tasks, a) for a in kept]
    kept = without_guessed(document, with_nearer_places(document, tasks, kept))
    return [a for a in kept if not (is_bare_preposition(document, a) or is_one_who_asks(document, tasks, a))]
