"""Any of several: of what a check asks for any, an order behind it means all that are so ("if any windows are open,
close them"), and so does one that asks for "any" itself ("wash any dirty cups", but not "bring any of the cups"). And
all that is taken from a place is all that was there, in a later task too ("take everything off the desk and bring it"),
as is all that is handled after a check of anything there ("if there is anything on the floor, pick everything up")."""

from __future__ import annotations

from dataclasses import dataclass, replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.instruction import Task
from decomplex_bt.planning.ground_task import FINDING_OUT, HANDLING, HERE, GroundTask, Referent
from decomplex_bt.planning.noun_phrase import NounPhrase

_ANY, _SOME = "any", "some"


@dataclass(frozen=True, slots=True)
class _Asked:
    """What a check asks of any of several: the state, and the places where they are."""

    where: tuple[tuple[str, str], ...]
    places: tuple[Referent, ...]


class Several:
    """What the checks of one text have asked of any of several, by the words for them, and where all of a kind are to
    be taken from."""

    def __init__(self, domain: Domain) -> None:
        self._domain = domain
        self._asked: dict[str, _Asked] = {}
        self._of_several: set[str] = set()
        self._taken_from: dict[Referent, tuple[Referent, ...]] = {}
        self._anything_at: tuple[Referent, ...] = ()

    def read(self, phrase: NounPhrase, referent: Referent, task: Task) -> tuple[Referent, tuple[Referent, ...]]:
        """The referent as a task means it, and the places where a task before asked for it."""
        if phrase.is_pronoun and task.type in HANDLING and referent in self._taken_from:
            return referent, self._taken_from[referent]
        if phrase.text in self._domain.lexicon.all_words and task.type in HANDLING:
            is_told = phrase.place is not None or task.argument("source", "location") is not None
            return referent, () if is_told else self._anything_at
        word, behind, *_ = (*phrase.text.split(), "")
        is_of_several = referent.is_any and not referent.is_all and phrase.plurals and not phrase.entities
        if not is_of_several or word not in (_ANY, _SOME):
            return referent, ()
        self._of_several.add(referent.phrase)
        asked = self._asked.get(referent.phrase)
        if task.type not in HANDLING or (asked is None and (word != _ANY or behind == "of")):
            return referent, ()
        where = (*referent.where, *(w for w in asked.where if w not in referent.where)) if asked is not None else ()
        every = replace(referent, is_all=True, where=where or referent.where)
        return every, asked.places if asked is not None else ()

    def note(self, task: GroundTask) -> None:
        """Takes in a task that may ask for any or for all of several."""
        if task.type in HANDLING and task.places:
            self._taken_from.update((referent, task.places) for referent in task.objects if referent.is_all)
        if task.type not in FINDING_OUT:
            return
        state = task.state if task.state not in (None, HERE) else None
        told = () if state is None else ((self._domain.kinds.pair_of(state), state),)
        for referent in task.objects:
            if len(referent.candidates) == len(self._domain.house.things) and not referent.is_all:
                self._anything_at = task.places
            if referent.phrase in self._of_several and not task.is_denied:
                self._asked[referent.phrase] = _Asked((*referent.where, *told), task.places)
