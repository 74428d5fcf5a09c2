"""The lexicon: verbs with the task type and the state they imply, and the small words that grounding needs."""

from __future__ import annotations

from functools import cached_property

from pydantic import Field, model_validator

from decomplex_bt.domain.document import Format, Record, Word


class VerbSense(Record):
    """What a verb (with its particle) can mean. `tasks`: likeliest first. `state`: what it implies ("heat": hot).
    `goal`: where it puts a thing or leads, in words ("throw away": trash can; "come back": here)."""

    tasks: tuple[str, ...] = Field(min_length=1)
    state: str | None = None
    goal: str | None = None


class VerbGroup(VerbSense):
    """Verbs of one sense, as the file lists them: lemmas, or "lemma particle"."""

    verbs: tuple[Word, ...] = Field(min_length=1)


class Lexicon(Record):
    """`words.yaml`: verbs in groups of one sense, colours, and the small words around nouns.

    `all_words` ask for all of a kind; `anything_words` for any thing at a place; `anybody_words`, `everybody_words` for
    people of the house; `here_words` for the place of the one who speaks; `presence_words` and, in a condition,
    `presence_verbs` say only that something is there, `absence_words` and, of people, `absence_verbs` that it is not.
    `prepositions` lead a phrase, those in `beside` mean near or under a thing; `determiners` do not say which one is
    meant; `measures` count ("a slice of bread"); `parts` stand for the whole ("the fridge door").
    """

    format: Format
    groups: tuple[VerbGroup, ...]
    colours: tuple[Word, ...]
    user_words: tuple[Word, ...]
    all_words: tuple[Word, ...] = ()
    anything_words: tuple[Word, ...] = ()
    anybody_words: tuple[Word, ...] = ()
    everybody_words: tuple[Word, ...] = ()
    here_words: tuple[Word, ...] = ()
    presence_words: tuple[Word, ...] = ()
    presence_verbs: tuple[Word, ...] = ()
    absence_words: tuple[Word, ...] = ()
    absence_verbs: tuple[Word, ...] = ()
    prepositions: tuple[Word, ...] = ()
    beside: tuple[Word, ...] = ()
    determiners: tuple[Word, ...] = ()
    measures: dict[Word, int] = {}
    parts: tuple[Word, ...] = ()

    @model_validator(mode="after")
    def _check(self) -> Lexicon:
        seen: set[str] = set()
        for group in self.groups:
            for verb in group.verbs:
                if verb in seen:
                    raise ValueError(f"the verb {verb!r} stands twice; give its one group several tasks instead")
                seen.add(verb)
        return self

    @cached_property
    def verbs(self) -> dict[str, VerbSense]:
        """Every verb, by lemma or "lemma particle" ("turn on"), with what it can mean."""
        return {
            verb: VerbSense(tasks=group.tasks, state=group.state, goal=group.goal)
            for group in self.groups
            for verb in group.verbs
        }
