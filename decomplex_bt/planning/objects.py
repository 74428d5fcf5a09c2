"""What a task is done with: the referents of its objects, less what an exception leaves out."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import replace

from decomplex_bt.domain.loader import Domain
from decomplex_bt.errors import ImpossibleGoalError, UnknownWordError
from decomplex_bt.instruction import Task
from decomplex_bt.planning.exclusions import excluded_phrase
from decomplex_bt.planning.ground_task import FINDING_OUT, GroundTask, Referent
from decomplex_bt.planning.modifiers import DEFINITE
from decomplex_bt.planning.noun_phrase import NounPhrase
from decomplex_bt.planning.others import too_few
from decomplex_bt.planning.phrases import read_phrases
from decomplex_bt.planning.prepositions import split_preposition
from decomplex_bt.planning.referents import Referents
from decomplex_bt.planning.several import Several

_POSSESSIVE = re.compile(r"['\u2019]s$", re.IGNORECASE)


class Objects:
    """Finds the objects of the tasks of one text, in its order."""

    def __init__(self, domain: Domain, referents: Referents) -> None:
        self._domain, self._referents, self._several = domain, referents, Several(domain)

    def note(self, task: GroundTask) -> None:
        """Takes down what a grounded task asks of any of several; later phrases may mean all of those."""
        self._several.note(task)

    def find(
        self, task: Task, fits: Callable[[str], bool], ability: str, *, rooms: Iterable[str] = ()
    ) -> tuple[tuple[Referent, ...], tuple[Referent, ...]]:
        """The referents of the object arguments that fit, and of the places inside their phrases."""
        objects: list[Referent] = []
        inner: list[Referent] = []
        said = frozenset(rooms)
        for argument in task.arguments:
            if argument.type != "object":
                continue
            phrases = self._referents.phrases(argument)
            for phrase in phrases:
                self._refuse_anything(task, phrase)
                # "turn off *the tv* and the light in the bedroom" with the tv elsewhere: the place is the light's
                is_placed = phrase is phrases[-1] or self._referents.may_be_in(phrase, said)
                phrase = self._sought(phrase) if task.type == "searching" else phrase
                where = said if is_placed else frozenset()
                one = self._referents.referent(phrase, fits, ability, rooms=where, is_place=False)
                every, places = self._several.read(phrase, one, task)
                objects.append(every)
                inner.extend(places)
                if phrase.place is not None and self._referents.may_move(objects[-1:]):
                    inner.append(self._referents.where(phrase.place))
        objects = self._joined(objects)
        self._refuse_everything(task, objects, inner)
        return tuple(objects), tuple(inner)

    def _sought(self, phrase: NounPhrase) -> NounPhrase:
        """What is looked for: of "cups", unlike "the cups", any will do."""
        is_plural = bool(phrase.plurals) and not (phrase.entities or phrase.is_all or phrase.is_pronoun)
        words = split_preposition(phrase.text, self._domain)[1].split()
        return replace(phrase, is_definite=False) if is_plural and words[0] not in DEFINITE else phrase

    def _joined(self, objects: list[Referent]) -> list[Referent]:
        """The objects of one task where one is other than another of them: "a pen and one more" are two pens."""
        joined: list[Referent] = []
        for referent in objects:
            same = next((other for other in joined if other in referent.others), None)
            if same is None or same.candidates != referent.candidates:
                joined.append(referent)
                continue
            both = replace(same, count=same.count + referent.count)
            if both.count > len(both.candidates):
                raise too_few(referent.phrase, both.candidates)
            self._referents.settle(same, both)
            self._referents.settle(referent, both)
            joined[joined.index(same)] = both
        return joined

    def less(self, grounded: GroundTask, task: Task, left_out: str) -> GroundTask:
        """The grounded task without the objects that are left out."""
        noun = read_phrases(task.values("object")[0], self._domain)[0].noun
        words = excluded_phrase(left_out, noun, self._domain.lexicon.prepositions)
        phrases = read_phrases(_POSSESSIVE.sub("", words), self._domain)
        rooms = self._domain.house.rooms
        if all(name in rooms for phrase in phrases for name in phrase.entities or phrase.plurals):
            # "the lights, except for the kitchen", "the lights except the kitchen's"
            phrases = read_phrases(f"the {noun} in {_POSSESSIVE.sub('', words)}", self._domain)
        elif _POSSESSIVE.search(words):
            raise ImpossibleGoalError(f"whose {noun} is which is not known here ({left_out!r}); say which by its place")
        wanted = {pair: self._domain.kinds.opposite(value) for phrase in phrases for pair, value in phrase.wanted}
        is_told_by_state = len(wanted) == len(phrases) == 1 and not any(o.is_all for o in grounded.objects)
        if any(phrase.place for phrase in phrases) and not self._referents.may_move(grounded.objects):
            wanted = {}
        elif any(phrase.place for phrase in phrases) or (wanted and not is_told_by_state):
            raise ImpossibleGoalError(
                f"which ones {left_out!r} leaves out cannot be known beforehand; say them by name"
            )
        names = {name for phrase in phrases for name in (phrase.entities or phrase.plurals) if not wanted}
        objects = []
        for referent in grounded.objects:
            fit = self._referents.narrowed(referent, lambda name: name not in names)
            if fit is None:
                raise ImpossibleGoalError(f"{grounded.phrase!r}: {left_out!r} leaves nothing")
            fit = replace(fit, is_all=fit.is_all and len(fit.candidates) > 1, where=(*fit.where, *wanted.items()))
            self._referents.settle(referent, fit)
            objects.append(fit)
        return replace(grounded, objects=tuple(objects))

    def _refuse_everything(self, task: Task, objects: list[Referent], inner: list[Referent]) -> None:
        for referent in objects:
            has_place = inner or task.value("source") or task.value("location")
            if referent.is_all and len(referent.candidates) == len(self._domain.house.things) and not has_place:
                raise UnknownWordError(referent.phrase, expected="a thing, or everything at a place")

    def _refuse_anything(self, task: Task, phrase: NounPhrase) -> None:
        """Refuses "something" without a place where it is, and "anything" and "nothing" but to ask; "it" was found."""
        if not self.is_anything(phrase) or phrase.is_pronoun:
            return
        if task.type not in FINDING_OUT and not phrase.noun.startswith("some"):
            raise UnknownWordError(phrase.text, expected="a thing, or something or everything at a place")
        if phrase.place is None and not task.value("source") and not task.value("location"):
            raise UnknownWordError(phrase.text, expected=f"a thing, or {phrase.noun} at a place")

    def is_anything(self, phrase: NounPhrase) -> bool:
        return phrase.noun in self._domain.lexicon.anything_words
