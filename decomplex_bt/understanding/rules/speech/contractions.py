"""Contractions: words that stand for several ("lemme know if it's on", "it's gonna be cold")."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from decomplex_bt.understanding.document import MARKS, Document

_ASKING = frozenset("if whether what where who how why which that".split())


class Report(NamedTuple):
    """A "lemme know", which is "let me know": its first word, and what is to be told, or empty."""

    verb: int
    message: range


def reports(document: Document, tasks: Mapping[int, str]) -> Iterator[Report]:
    """Every "lemme know" of a document; its message goes up to a mark, or what joins the next of the `tasks` to it."""
    tokens = document.tokens
    if "lemme" not in document.words:
        return
    for i, token in enumerate(tokens[:-1]):
        if token.lower != "lemme" or tokens[i + 1].lower != "know":
            continue
        start = i + 2
        ends = (t.i for t in tokens[start:] if t.text in MARKS or (t.i in tasks and tasks[t.i] != "check_state"))
        stop = next(ends, len(tokens))
        while stop > start and tokens[stop - 1].lower in ("and", "but", "then", "so"):
            stop -= 1
        is_asked = start < stop and tokens[start].lower in _ASKING
        yield Report(i, range(start, stop) if is_asked else range(start, start))
