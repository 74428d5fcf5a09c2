"""Inline YAML, the format of the corpus: the writer; its reader is `decomplex_bt.corpus`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import yaml

from decomplex_bt.corpus import Example, write_markup
from decomplex_bt.formats.annotation import implied_of


def write_inline(examples: Sequence[Example]) -> str:
    """The text of a corpus file, which reads back as the same. Raises `InputError` where YAML cannot say it."""
    return "\n".join(map(_item, examples)) + "\n" if examples else "[]\n"


def _item(example: Example) -> str:
    instruction = example.instruction
    values: dict[str, Any] = {"id": example.id, "text": write_markup(instruction)}
    if implied := implied_of(instruction):
        values["implied"] = implied
    values["flow"] = instruction.flow.to_json()
    values |= {key: value for key, value in (("source", example.source), ("note", example.note)) if value}
    lines = [f"{key}: {_value(key, value)}" for key, value in values.items()]
    return "- " + "\n  ".join(lines)


def _value(key: str, value: Any) -> str:
    if key == "text" and value.isprintable() and value == value.strip() and value:
        return f">-\n    {value}"
    dumped = _dumped(value, is_plain=True)
    if "\x85" in dumped:  # a line break to a reader, which would make a space of it
        dumped = _dumped(value, is_plain=False)
    return dumped.removesuffix("\n").removesuffix("\n...")


def _dumped(value: Any, *, is_plain: bool) -> str:
    return yaml.safe_dump(value, default_flow_style=True, allow_unicode=is_plain, width=1_000_000, sort_keys=False)
