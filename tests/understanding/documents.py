"""Documents built by hand, for tests of pure functions without a language model."""

from __future__ import annotations

from decomplex_bt.understanding.document import Document, Token


def document(*words: str) -> Document:
    """A document of words such as "bring/VB/ROOT/0": text, tag, dependency and head, or the text alone."""
    tokens, text = [], ""
    for i, word in enumerate(words):
        surface, tag, dep, head = word.split("/") if "/" in word else (word, "NN", "dep", str(i))
        text += (" " if text else "") + surface
        pos = {"V": "VERB", "N": "NOUN", "D": "DET", "I": "ADP", "J": "ADJ", "P": "PRON"}.get(tag[0], "X")
        tokens.append(
            Token(i, len(text) - len(surface), surface, surface.lower(), surface.lower(), tag, pos, dep, int(head))
        )
    return Document(text, tuple(tokens))
