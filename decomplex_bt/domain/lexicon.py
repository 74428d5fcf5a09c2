"""The lexicon: verbs with the task type and the state they imply, and the small words that grounding needs."""

from __future__ import annotations

from decomplex_bt.domain.document import Record


class VerbSense(Record):
    """What a verb (with its particle) can mean. `state`: the state it implies ("heat": hot); `tasks`: likeliest first."""

    tasks: tuple[str, ...]
    state: str | None = None


class Lexicon(Record):
    """`words.yaml`: verbs by lemma or "lemma particle" ("turn on"), colours, words for the user and for everything."""

    format: int
    verbs: dict[str, VerbSense]
    colours: tuple[str, ...]
    user_words: tuple[str, ...]
