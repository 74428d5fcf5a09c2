"""S-expressions, as PDDL is written in them: text to nested tuples of lower-case words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

Sexpr = str | tuple["Sexpr", ...]

_TOKEN = re.compile(r";[^\n]*|[()]|[^\s();]+")


@lru_cache(maxsize=4)  # each section of a domain is asked for on its own
def read_sexpr(text: str) -> Sexpr:
    """The one expression that the text holds, without comments. Raises `ValueError` where parentheses do not match."""
    tokens = (match[0].lower() for match in _TOKEN.finditer(text) if not match[0].startswith(";"))
    value = _read(tokens, next(tokens, ")"))
    if next(tokens, None) is not None:
        raise ValueError("something stands behind the last parenthesis")
    return value


def typed_list(items: tuple[Sexpr, ...]) -> Iterator[tuple[str, str]]:
    """The (name, type) pairs of a PDDL list such as `?a ?b - room ?t - thing`; without a type it is "object"."""
    pending: list[str] = []
    words = iter([str(item) for item in items])
    for word in words:
        if word != "-":
            pending.append(word)
            continue
        kind = next(words, "object")
        yield from ((name, kind) for name in pending)
        pending = []
    yield from ((name, "object") for name in pending)


def _read(tokens: Iterator[str], token: str) -> Sexpr:
    if token == ")":
        raise ValueError("an expression is missing or closed twice")
    if token != "(":
        return token
    items: list[Sexpr] = []
    for token in tokens:
        if token == ")":
            return tuple(items)
        items.append(_read(tokens, token))
    raise ValueError("a parenthesis is not closed")
