"""From spaCy's tokens to the word pieces of the pretrained encoder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from decomplex_bt.understanding.damage import ModelError

START, END, UNKNOWN = "[CLS]", "[SEP]", "[UNK]"
MAX_PIECES = 512
MAX_WORDS = 4096
"""Of how many words the pieces are remembered."""


@dataclass(frozen=True, slots=True)
class Pieced:
    """The piece ids of a text between start and end mark, and where each token's first piece stands, or the mark put
    before it. Tokens behind the limit of the encoder share the last place."""

    ids: tuple[int, ...]
    firsts: tuple[int, ...]


class Pieces:
    """The encoder's own word pieces, from `tokenizer.json`. Raises `DataFileError` where it cannot be read."""

    def __init__(self, path: Path) -> None:
        from tokenizers import Tokenizer

        try:
            self._tokenizer = Tokenizer.from_str(path.read_text(encoding="utf-8"))
        except Exception as error:  # the library raises plain exceptions for whatever it cannot read
            raise ModelError(path, f"no word pieces ({error})") from None
        self._tokenizer.no_truncation()
        self._tokenizer.no_padding()
        self._start, self._end, self._unknown = (self._id(name, path) for name in (START, END, UNKNOWN))
        self._of_word = lru_cache(maxsize=MAX_WORDS)(self._of_new_word)

    def _id(self, piece: str, path: Path) -> int:
        number = self._tokenizer.token_to_id(piece)
        if number is None:
            raise ModelError(path, f"the word piece {piece} is missing")
        return int(number)

    def mark(self, number: int) -> int:
        """The id of a piece that no text holds, to mark tokens with; there are 99 of them, numbered from 0, and one
        that stands for all others."""
        found = self._tokenizer.token_to_id(f"[unused{number}]")
        return self._unknown if found is None else int(found)

    def of(self, tokens: Sequence[str], marks: Mapping[int, int] | None = None) -> Pieced:
        """The pieces of a text's tokens; `marks`: the piece to put before a token."""
        ids, firsts = [self._start], []
        for i, token in enumerate(tokens):
            firsts.append(len(ids))
            if marks and i in marks:
                ids.append(marks[i])
            ids += self._of_word(token)
        last = MAX_PIECES - 2
        return Pieced((*ids[: last + 1], self._end), tuple(min(first, last) for first in firsts))

    def _of_new_word(self, word: str) -> list[int]:
        return self._tokenizer.encode(word, add_special_tokens=False).ids or [self._unknown]
