"""Any of several: of what a check asks for any, an order behind it means all that are so ("if any windows are open,
close them"), and so does one that asks for "any" itself ("wash any dirty cups", but not "bring any of the cups")."""

from __future__ import annotations

from dataclasses import dataclass, replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.planning.ground_task import FINDING_OUT, HANDLING, HERE, GroundTask, Referent
from decomplex_bt.planning.noun_phrase import NounPhrase

_ANY, _SOME = "any", "some"


@dataclass(frozen=True, slots=True)
class _Asked:
    """What a check asks of any of several: the state, and the places where they are."""

    where: tuple[tuple[str, str], ...]
    places: tuple[Referent, ...]


class Several:
    """What the checks of one text have asked of any of several, by the words for them."""

    def __init__(self, domain: Domain) -> None:
        self._domain = domain
        self._asked: dict[str, _Asked] = {}
        self._of_several: set[str] = set()

    def read(self, phrase: NounPhrase, referent: Referent, task_type: str) -> tuple[Referent, tuple[Referent, ...]]:
        """The referent as a task of a type means it, and the places where a check before asked for it."""
        word, behind, *_ = (*phrase.text.split(), "")
        is_of_several = referent.is_any and not referent.is_all and phrase.plurals and not phrase.entities
        if not is_of_several or word not in (_ANY, _SOME):
            return referent, ()
        self._of_several.add(referent.phrase)
        asked = self._asked.get(referent.phrase)
        if task_type not in HANDLING or (asked is None and (word != _ANY or behind == "of")):
            return referent, ()
        where = (*referent.where, *(w for w in asked.where if w not in referent.where)) if asked is not None else ()
        every = replace(referent, is_all=True, where=where or referent.where)
        return every, asked.places if asked is not None else ()

    def note(self, task: GroundTask) -> None:
        """Takes in a task that may ask for any of several."""
        if task.type not in FINDING_OUT:
            return
        state = task.state if task.state not in (None, HERE) else None
        told = () if state is None else ((self._domain.kinds.pair_of(state), state),)
        for referent in task.objects:
            if referent.phrase in self._of_several and not task.is_denied:
                self._asked[referent.phrase] = _Asked((*referent.where, *told), task.places)
