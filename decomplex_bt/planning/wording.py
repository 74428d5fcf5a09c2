"""Wording: what a task's verb and the words around it say that is in no argument."""

from __future__ import annotations

import re

from decomplex_bt.domain.clauses import asks_presence, clause_around, is_of_anything, is_of_nobody, is_of_weather
from decomplex_bt.domain.lexicon import VerbSense
from decomplex_bt.domain.loader import Domain
from decomplex_bt.domain.verbs import lemmas, sense_of
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.planning.prepositions import split_preposition
from decomplex_bt.planning.state_words import read_state

_FINDING_OUT = frozenset(("check", "verify", "test", "inspect", "look", "see"))
_BESIDES = r"(?:but|except(?:\s+for)?|besides|apart\s+from|other\s+than)"
_ELSE = re.compile(rf"\b(?:nobody|no[- ]?one)\s+(?:else|{_BESIDES})\b|\b{_BESIDES}\s+(?:me|us|myself)\b", re.IGNORECASE)
_OF_ANY = re.compile(
    r"\bany(?:\s+of\s+(?:them|these|those))?\s+(?:that|which)(?:'s|'re|\s+is|\s+are)\s+$", re.IGNORECASE
)
_OUT_OF_ORDER = re.compile(r"\b(?:broken|out of (?:order|action)|defective|faulty|kaput|bust(?:ed)?)\b", re.IGNORECASE)
_WORKING = frozenset(("work", "function"))
_PARTICLES = re.compile(r"[a-z']+")


class Wording:
    """The words of one instruction, as a domain's lexicon understands them."""

    def __init__(self, instruction: Instruction, domain: Domain) -> None:
        self._instruction, self._domain = instruction, domain

    def sense(self, task: Task) -> VerbSense | None:
        """What the verb, with its particle, implies ("turn … on", "heat", "throw … away"), as a verb of this type."""
        verb = self._instruction.verb_of(task)
        sense = sense_of(verb.span.of(self._instruction.text), self._particles(verb), self._domain.lexicon)
        return None if sense is None or task.type not in sense.tasks else sense

    def says_out(self, task: Task) -> bool:
        """Whether a thing is only to go out, wherever that is ("take the trash out")."""
        return "out" in self._particles(self._instruction.verb_of(task)) or task.value("goal") in ("out", "outside")

    def is_of_nobody(self, task: Task) -> bool:
        """Whether a check is of nobody's being there: of anybody's, with its branches changed over by the flow."""
        if task.type != "check_state" or task.value("object") not in (None, "one", "no one"):
            return False
        return is_of_nobody(self._clause(task))

    def is_of_nobody_else(self, task: Task) -> bool:
        """Whether a check of nobody leaves somebody out, who may be there ("nobody else", "nobody but me")."""
        return _ELSE.search(self._clause(task)) is not None

    def is_of_anything(self, task: Task) -> bool:
        """Whether a check is of anything's being at a place, or of nothing's, with its branches changed over."""
        if task.type != "check_state" or task.value("object") is not None or task.value("location") is None:
            return False
        return is_of_anything(self._clause(task))

    def is_of_any(self, state: Argument) -> bool:
        """Whether a state is asked of any of several ("check the windows and close any that are *open*")."""
        return state.span is not None and _OF_ANY.search(self._instruction.text[: state.span.start]) is not None

    def is_of_weather(self, task: Task) -> bool:
        """Whether a check is of the weather or the day, which no thing tells."""
        if task.type != "check_state" or (task.value("object") or "it").lower() != "it":
            return False
        return is_of_weather(self._clause(task))

    def is_of_working(self, task: Task) -> bool:
        """Whether a check asks whether something works or is broken (but not whether it is working, which is on)."""
        if task.type != "check_state":
            return False
        form, state = task.span.of(self._instruction.text).lower(), task.value("state")
        if state is not None or _OUT_OF_ORDER.search(form):
            return _OUT_OF_ORDER.search(state or form) is not None
        return task.value("location") is None and not form.endswith("ing") and not _WORKING.isdisjoint(lemmas(form))

    def has_presence_verb(self, task: Task) -> bool:
        """Whether a check asks only whether something is there: by its verb, or by what it asks ("if there is")."""
        form = task.span.of(self._instruction.text).lower()
        is_verb = any(lemma in self._domain.lexicon.presence_verbs for lemma in lemmas(form))
        return is_verb or asks_presence(self._clause(task))

    def says_state(self, task: Task) -> bool:
        """Whether the word that carries a check says itself what is asked ("oven on?", "any soap left?")."""
        is_presence = self.is_presence(task.span.of(self._instruction.text))
        return is_presence or self.is_state(task) or self.has_presence_verb(task) or self.has_absence_verb(task)

    def is_state(self, task: Task) -> bool:
        """Whether the word that carries a check is one of state ("oven on?")."""
        word = task.span.of(self._instruction.text)
        return read_state(word, self._domain.kinds.state_pairs, self._domain) is not None

    def is_presence(self, words: str) -> bool:
        _, rest = split_preposition(words, self._domain)
        return (
            words.lower().strip() in self._domain.lexicon.presence_words or rest in self._domain.lexicon.presence_words
        )

    def is_absence(self, words: str) -> bool:
        return words.lower().strip() in self._domain.lexicon.absence_words

    def is_bare_check(self, task: Task) -> bool:
        """Whether a check's verb asks to find out, and not what ("check the window", but not "has it finished")."""
        form = task.span.of(self._instruction.text).lower()
        return any(lemma in _FINDING_OUT for lemma in lemmas(form))

    def has_possession_verb(self, task: Task) -> bool:
        """Whether a check says by its verb that somebody has something ("if Tom has the keys")."""
        return "have" in lemmas(task.span.of(self._instruction.text).lower())

    def has_absence_verb(self, task: Task) -> bool:
        """Whether a check asks by its verb whether somebody is gone ("if Anna has left", "… has popped out")."""
        form, particle = task.span.of(self._instruction.text).lower(), self._word_behind(task)
        verbs = self._domain.lexicon.absence_verbs
        return any(verb in verbs for lemma in lemmas(form) for verb in (lemma, f"{lemma} {particle}"))

    def absence_particle(self, task: Task) -> str:
        """The word behind such a verb, which may say how somebody or something has gone: Anna, or a light, goes out."""
        return self._word_behind(task) if self.has_absence_verb(task) else ""

    def is_left(self, where: str) -> bool:
        """Whether a place is where somebody has gone from ("from the table"; "has left the kitchen"), and not to."""
        return split_preposition(where, self._domain)[0] in ("", "from", "out of")

    def is_house(self, where: str) -> bool:
        """Whether a place is the whole house."""
        return self.is_presence(f"in {split_preposition(where, self._domain)[1]}")

    def _word_behind(self, task: Task) -> str:
        match = re.compile(r" +([a-z]+)").match(self._instruction.text.lower(), task.span.end)
        return match[1] if match else ""

    def _particles(self, task: Task) -> list[str]:
        """The words behind the verb, up to the next task or the end of the sentence, that are in no argument."""
        text = self._instruction.text
        stops = [other.span.start for other in self._instruction.tasks if other.span.start > task.span.start]
        end = min([*stops, len(text)])
        spans = [a.span for other in self._instruction.tasks for a in other.arguments if a.span is not None]
        free: list[str] = []
        for match in _PARTICLES.finditer(text.lower(), task.span.end, end):
            if any(mark in text[task.span.end : match.start()] for mark in ".;!?"):
                break
            if not any(span.start <= match.start() < span.end for span in spans):
                free.append(match[0])
        return free

    def _clause(self, task: Task) -> str:
        return clause_around(self._instruction.text, task.span, [other.span for other in self._instruction.tasks])
