"""Unspoken: what is asked or ordered in words that have no order of their own, of every kind."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.ellipses.elsewhere import elsewhere, first_searches, other_searches
from decomplex_bt.understanding.rules.ellipses.fragments import Fragment, fragments
from decomplex_bt.understanding.rules.ellipses.legs import legs
from decomplex_bt.understanding.rules.ellipses.renewals import renewals
from decomplex_bt.understanding.rules.ellipses.transfers import transfers
from decomplex_bt.understanding.rules.orders.needs import belonging, states_due
from decomplex_bt.understanding.rules.orders.wants import wants


def unspoken(observed: Observed, tasks: Mapping[int, str]) -> Iterator[Fragment]:
    """Questions and orders without a verb, what is said to belong somewhere, what is wanted, what is switched on again,
    where else something is, where to look for it first, or to go next; `tasks`: tokens that are tasks, with types."""
    yield from fragments(observed.document, observed.gazetteer.names)
    yield from transfers(observed)
    yield from belonging(observed.document)
    yield from states_due(observed.document)
    yield from wants(observed, tasks)
    yield from renewals(observed.document)
    yield from elsewhere(observed.document)
    yield from other_searches(observed.document, tasks)
    yield from first_searches(observed, tasks)
    yield from legs(observed.document, tasks)
