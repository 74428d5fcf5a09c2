"""Tasks that no model may see: idioms, needs, what is telegraphed, fragments, the cases without a verb."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.references.looks import shouts
from decomplex_bt.understanding.rules.cases.conditions import untold
from decomplex_bt.understanding.rules.cases.echoes import echoes
from decomplex_bt.understanding.rules.cases.mishaps import mishaps
from decomplex_bt.understanding.rules.cases.perfects import told_by
from decomplex_bt.understanding.rules.cases.preferences import preferences
from decomplex_bt.understanding.rules.cases.waits import postponed
from decomplex_bt.understanding.rules.ellipses.pro_verbs import pro_verbs
from decomplex_bt.understanding.rules.ellipses.second_cases import second_cases
from decomplex_bt.understanding.rules.ellipses.telegraph import telegraphed
from decomplex_bt.understanding.rules.ellipses.unspoken import unspoken
from decomplex_bt.understanding.rules.ellipses.verbless import verbless_cases
from decomplex_bt.understanding.rules.orders.assurances import assured_lists
from decomplex_bt.understanding.rules.orders.causatives import causative_types
from decomplex_bt.understanding.rules.orders.fronting import fronted
from decomplex_bt.understanding.rules.orders.idioms import idiomatic
from decomplex_bt.understanding.rules.orders.needs import needed, needs_of
from decomplex_bt.understanding.rules.orders.reports import orders_behind
from decomplex_bt.understanding.rules.speech.contractions import reports
from decomplex_bt.understanding.tasks import FoundTask


def with_further(observed: Observed, tasks: Sequence[FoundTask], types: Collection[str]) -> tuple[FoundTask, ...]:
    """The tasks with those that are idioms, needs, telegraphed or fragments, and without other words of these ("might
    be *switched*")."""
    document, found = observed.document, {task.token: task.type for task in tasks}
    later = postponed(observed, found)
    told = {**telegraphed(observed, found), **needed(observed, found), **idiomatic(document, {**found, **later})}
    told |= {i: observed.senses[i][0] for i in orders_behind(document, found) if observed.senses[i]}
    told |= {report.verb: "informing" for report in reports(document, found)}
    told |= causative_types(observed)
    told |= {i: "informing" for i, *_ in shouts(document) if document.tokens[i].lower == "gimme" and i not in found}
    told |= {**later, **{i: verb.type for i, verb in pro_verbs(observed, found).items()}}
    idioms = {i: type for i, type in told.items() if type in types}
    behind = {i + 1 for i in idioms if i + 1 < len(document) and document.tokens[i + 1].tag == "VBN"}
    behind |= needs_of(observed, (*found, *idioms))
    for fragment in list(unspoken(observed, {**found, **idioms})):
        behind.update(fragment.tokens)
        idioms[fragment.carrier] = fragment.type
    for case in second_cases(document):
        behind.update(case.tokens)
        idioms[case.carrier] = case.type
    for listed in assured_lists(document):
        behind.update(range(listed[0].thing.start, listed[-1].state.stop))
        idioms |= {one.carrier: "change_state" for one in listed}
    for case in verbless_cases(observed, found):  # an adjective is no order: "wash it when *dirty*"
        if case.carrier not in found or document.tokens[case.carrier].pos == "ADJ":
            idioms[case.carrier] = case.type
    idioms |= {order.verb: order.type for order in fronted(observed) if order.verb not in found}
    taken_up = list(echoes(document, found).values())
    idioms |= {echo.verb: "check_state" for echo in taken_up if echo.asks}
    undone = [echo.verb for echo in taken_up if not echo.asks and echo.verb not in found]
    idioms |= {verb: next(iter(observed.senses[verb])) for verb in undone if observed.senses[verb]}
    idioms |= {told_by(document, be): "check_state" for be in untold(document, {**found, **idioms})}
    idioms |= {mishap.verb: "check_state" for mishap in mishaps(document)}
    for wish in preferences(document, found):
        behind.update(wish.words)
        idioms[wish.check] = "check_state"
    kept = [task for task in tasks if task.token not in behind | idioms.keys()]
    added = [FoundTask(i, type, 1.0) for i, type in idioms.items()]
    return tuple(sorted([*kept, *added], key=lambda task: task.token))
