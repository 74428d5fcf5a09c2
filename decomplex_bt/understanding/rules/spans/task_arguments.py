"""Task arguments: what is certain of the arguments of one task, by its type."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from decomplex_bt.understanding.arguments import CERTAIN, FoundArgument
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.rules.cases.checks import (
    asked,
    departed,
    doing,
    done_by_nobody,
    identified,
    that_there_is,
    with_named_state,
    with_place,
    with_subject,
    with_told,
    with_whole_state,
    without_air,
    without_left,
)
from decomplex_bt.understanding.rules.cases.mishaps import mishaps
from decomplex_bt.understanding.rules.cases.preferences import Preference, preferences
from decomplex_bt.understanding.rules.cases.waits import kept_from
from decomplex_bt.understanding.rules.ellipses.telegraph import named
from decomplex_bt.understanding.rules.orders.assistance import with_helped
from decomplex_bt.understanding.rules.orders.calls import with_called
from decomplex_bt.understanding.rules.orders.causatives import with_biddings, with_done
from decomplex_bt.understanding.rules.orders.deeds import without_deed, without_particle
from decomplex_bt.understanding.rules.orders.doors import admitted
from decomplex_bt.understanding.rules.orders.handing import called, divided, fed, given, paid, served, with_gift
from decomplex_bt.understanding.rules.orders.idioms import (
    encountered,
    for_somebody,
    foreseen,
    heard,
    predicated,
    troubled,
)
from decomplex_bt.understanding.rules.orders.loading import with_loaded
from decomplex_bt.understanding.rules.orders.needs import in_need, with_needs
from decomplex_bt.understanding.rules.orders.reports import with_next_told, with_reports, without_times
from decomplex_bt.understanding.rules.orders.resuming import without_lead
from decomplex_bt.understanding.rules.orders.rounds import with_rounds
from decomplex_bt.understanding.rules.spans.bounds import before_orders, is_of_forbidden
from decomplex_bt.understanding.rules.spans.goals import gone_back, gone_to, put_in, put_inside, put_out
from decomplex_bt.understanding.vocabulary import PREPOSITIONS

_WITHOUT_THINGS = frozenset(("check_state", "informing", "motion"))
_HANDLED = frozenset(("change_state", "taking", "placing", "following"))


@dataclass(frozen=True, slots=True)
class Setting:
    """An instruction whose tasks are known, by token with their types: what one of them may tell of another."""

    observed: Observed
    tasks: Mapping[int, str]
    happening: Mapping[int, Mapping[str, range]]
    """By the verb of a mishap what it tells ("if *the glass breaks*")."""
    wishes: Mapping[int, Preference]
    """By the check that it is what somebody would rather have."""

    @classmethod
    def of(cls, observed: Observed, tasks: Mapping[int, str]) -> Setting:
        document = observed.document
        happening = {mishap.verb: mishap.told for mishap in mishaps(document)}
        return cls(observed, tasks, happening, {wish.check: wish for wish in preferences(document, tasks)})

    @property
    def document(self) -> Document:
        return self.observed.document


def of_task(setting: Setting, arguments: Sequence[FoundArgument], task: int) -> list[FoundArgument]:
    """The arguments with what is certain of those of one task, by its token; the others as they are."""
    kind, document = setting.tasks[task], setting.document
    kept = without_lead(document, arguments, task)
    if kind in _OF_TYPE:
        kept = _OF_TYPE[kind](setting, kept, task)
    if not any(a.owner == task and len(a.tokens) > 1 for a in kept):
        kept = with_told(kept, task, kept_from(document, setting.tasks, task))
    if kind in _HANDLED and not any(a.owner == task and task + 1 in a.tokens for a in kept):
        kept = with_told(kept, task, _taken_up_behind(document, task))
    if kind != "check_state":
        kept = with_needs(setting.observed, with_done(setting.observed, kept, task, kind), task, kind)
    if kind not in _WITHOUT_THINGS and not any((a.owner, a.type) == (task, "object") for a in kept):
        kept = with_told(kept, task, in_need(setting.observed, task) or _telegraphed(document, task))
    return kept


def _of_motion(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    return gone_back(setting.document, kept, task)


def _of_placing(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    kept = [a for a in kept if a.owner != task or not _is_particle(document, a)]
    kept = put_out(document, put_in(setting.observed, with_loaded(setting.observed, kept, task), task), task)
    kept = put_inside(document, gone_to(document, kept, task), task)
    if whom := admitted(document, task):
        kept = [a for a in kept if a.owner != task or not set(a.tokens) & set(whom)]
        kept.append(FoundArgument("object", task, whom, CERTAIN))
    return kept


def _of_bringing(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    kept = given(with_gift(document, divided(document, kept, task), task), task, for_somebody(document, task))
    kept = paid(document, served(document, called(document, kept, task), task), task)
    return with_told(kept, task, {"object": said} if (said := troubled(document, task)) else {})


def _of_change(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    kept = [a for a in kept if a.owner != task or not is_of_forbidden(document, a)]
    return without_particle(setting.observed, without_deed(document, fed(document, kept, task), task), task)


def _of_check(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    kept = [_undenied(document, a) if a.owner == task else a for a in kept]
    kept = with_place(document, setting.tasks, kept, task)
    kept = with_whole_state(document, that_there_is(document, kept, task), task)
    kept = departed(document, without_left(document, kept, task), task)
    for told in (done_by_nobody(document, task), doing(document, task), setting.happening.get(task, {})):
        kept = with_told(kept, task, told)
    kept = with_told(_of_now(document, kept, task), task, heard(document, task))
    kept = with_told(kept, task, before_orders(setting.tasks, predicated(document, task)))
    kept = setting.wishes[task].told(kept) if task in setting.wishes else kept
    kept = asked(document, kept, task, setting.tasks)
    kept = with_named_state(document, identified(setting.observed, kept, task), task)
    return without_air(document, with_subject(document, kept, task), task)


def _of_informing(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    kept = without_times(document, with_reports(document, setting.tasks, kept, task), task)
    return with_called(document, with_biddings(document, with_next_told(document, kept, task), task), task)


def _of_following(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    return with_helped(setting.document, kept, task)


def _of_searching(setting: Setting, kept: list[FoundArgument], task: int) -> list[FoundArgument]:
    document = setting.document
    if met := encountered(document, task):
        kept = [a for a in kept if not {met.start - 1, *met} & {*a.tokens}]
        kept.append(FoundArgument("object", task, met, CERTAIN))
    if document.tokens[task].lemma == "meet":
        kept = [replace(a, type="location") if (a.owner, a.type) == (task, "goal") else a for a in kept]
    return with_rounds(document, setting.tasks, kept, task)


_OF_TYPE: Mapping[str, Callable[[Setting, list[FoundArgument], int], list[FoundArgument]]] = {
    "motion": _of_motion,
    "placing": _of_placing,
    "bringing": _of_bringing,
    "change_state": _of_change,
    "check_state": _of_check,
    "informing": _of_informing,
    "following": _of_following,
    "searching": _of_searching,
}


def _is_particle(document: Document, argument: FoundArgument) -> bool:
    """Whether a state is but a particle, which is none of what is put somewhere: "hang it back *on*"."""
    is_single = argument.type == "state" and len(argument.tokens) == 1
    return is_single and document.tokens[argument.tokens.start].lower in PREPOSITIONS


def _undenied(document: Document, argument: FoundArgument) -> FoundArgument:
    """The argument of a check without the "no" ahead of its noun, which denies the condition: "if no *lamp* is on". In
    "none of the lamps" the words pick one."""
    words = [document.tokens[i].lower for i in argument.tokens]
    if argument.type != "object" or len(words) < 2 or words[0] != "no" or words[1] == "one":
        return argument
    return replace(argument, tokens=range(argument.tokens.start + 1, argument.tokens.stop))


def _of_now(document: Document, arguments: Sequence[FoundArgument], check: int) -> list[FoundArgument]:
    """The arguments, none of which goes on from what is spoken of to what is to come: "*Tom*'s gonna be late"."""
    coming = foreseen(document, check)
    if not coming:
        return list(arguments)
    kept = [a for a in arguments if a.type == "state" or a.tokens.start not in coming]
    return [
        replace(a, tokens=range(a.tokens.start, check)) if a.tokens.start < check < a.tokens.stop else a for a in kept
    ]


def _telegraphed(document: Document, verb: int) -> dict[str, range]:
    """What a verb that the tagger takes for a noun is done to: "water *plants*"."""
    is_telegram = not any(token.tag in ("DT", "PRP$") for token in document.tokens)
    thing = named(document, verb) if is_telegram else range(0)
    return {"object": thing} if thing else {}


def _taken_up_behind(document: Document, verb: int) -> dict[str, range]:
    """The pronoun right behind a verb as its object: "wake *him*"."""
    token = document.tokens[verb + 1] if verb + 1 < len(document) else None
    is_object = token is not None and token.lower in ("him", "it", "them", "her") and token.tag == "PRP"
    return {"object": range(verb + 1, verb + 2)} if is_object else {}
