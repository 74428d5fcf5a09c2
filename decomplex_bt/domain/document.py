"""A data file as a checked document: safe YAML whose errors name the file, the line and the key."""

from __future__ import annotations

import re
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar, get_args, get_origin

import yaml
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from decomplex_bt.errors import DataFileError, among


class Record(BaseModel):
    """Base of everything read from a data file: immutable, no unknown keys, no silent conversion of strings, finite
    numbers."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False, allow_inf_nan=False)


def _check_weights(weights: dict[str, float]) -> dict[str, float]:
    if weights and not any(weights.values()):
        raise ValueError("all weights are 0; one at least must be greater")
    return weights


def _check_word(word: str) -> str:
    if not word.strip():
        raise ValueError("a word is blank; write it, or leave it out")
    return word


Model = TypeVar("Model", bound=BaseModel)
Format = Literal[1]
"""The version of a domain's files that this version of the package reads."""
Probability = Annotated[float, Field(ge=0, le=1)]
Word = Annotated[str, AfterValidator(_check_word)]
"""A word or phrase that somebody says."""
Weights = Annotated[dict[str, Annotated[float, Field(ge=0, allow_inf_nan=False)]], AfterValidator(_check_weights)]
"""Relative weights by name."""


if TYPE_CHECKING:
    from yaml import SafeLoader as _SafeLoader
else:
    # in C where PyYAML has it: eight times as fast, and reading YAML is most of what loading a domain costs
    _SafeLoader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class _Loader(_SafeLoader):
    """Safe YAML that refuses a key given twice, which plain YAML takes silently."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Hashable, Any]:
        seen: set[Any] = set()
        for key_node, _ in node.value:
            key = self.construct_object(key_node, deep=True)
            if isinstance(key, Hashable) and key in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"the key {key!r} stands twice", key_node.start_mark
                )
            seen.add(key)
        return super().construct_mapping(node, deep)


def read_text(path: Path) -> str:
    """The text of a file. Raises `DataFileError` where it cannot be read, or not as UTF-8."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise DataFileError(path, f"not valid UTF-8 at byte {error.start}; save the file as UTF-8") from None
    except OSError as error:
        raise DataFileError(path, f"cannot be read: {error.strerror}") from None


def read_yaml(path: Path) -> Any:
    """The plain value of a YAML file. Raises `DataFileError` naming the line where it is not readable as UTF-8 YAML."""
    return load_yaml(read_text(path), path)


def load_yaml(text: str, path: str | Path) -> Any:
    """As `read_yaml`, from text; `path` serves for messages."""
    try:
        return yaml.load(text, Loader=_Loader)  # a SafeLoader
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else None
        raise DataFileError(path, f"not valid YAML: {error.problem}", line=line) from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise DataFileError(path, f"not valid YAML: {_first_line(error)}") from None


def item_lines(text: str) -> list[int]:
    """The line (from 1) at which each item of a top-level YAML list starts; empty if it is no list."""
    node = yaml.compose(text, Loader=_SafeLoader)
    if not isinstance(node, yaml.SequenceNode):
        return []
    return [item.start_mark.line + 1 for item in node.value]


def read_record(path: Path, model: type[Model]) -> Model:
    """The file as a `model`. Raises `DataFileError` naming file and key."""
    return check_record(read_yaml(path), model, path)


def check_record(value: Any, model: type[Model], path: str | Path, *, line: int | None = None) -> Model:
    """`value` as a `model`. Raises `DataFileError` naming file, line (where given) and key."""
    try:
        return model.model_validate(value)
    except ValidationError as error:
        first = error.errors()[0]
        if first["type"] == "value_error" and not first["loc"]:  # which names its keys itself
            raise DataFileError(path, str(first["ctx"]["error"]), line=line) from None
        key = ".".join(str(part) for part in first["loc"]) or "the whole"
        if first["type"] == "missing":
            raise DataFileError(path, f"{key}: it is missing, and required", line=line) from None
        if first["type"] == "extra_forbidden":
            known = _keys_at(model, first["loc"][:-1])
            raise DataFileError(
                path, f"{key}: there is no such key{among(first['loc'][-1], known)}", line=line
            ) from None
        said = _in_yaml(first["msg"].removeprefix("Value error, "))
        got = repr(first["input"])
        got = got if len(got) <= 60 else got[:57] + "..."
        raise DataFileError(path, f"{key}: {said} (got {got})", line=line) from None


def _in_yaml(said: str) -> str:
    """What pydantic says, in the words of a data file instead of Python's."""
    said = re.sub(r"valid (mapping|dictionary)( or instance of \w+)?", "mapping", said)
    return said.replace("valid tuple", "list").replace("Tuple", "List").replace(" after validation", "")


def _keys_at(model: Any, location: Sequence[int | str]) -> list[str]:
    """The keys that a model takes where a location in it leads to; none where that is no model."""
    for part in location:
        while get_origin(model) is Annotated:
            model = get_args(model)[0]
        if isinstance(model, type) and issubclass(model, BaseModel):
            model = model.model_fields[str(part)].annotation
        else:
            model = next(iter(get_args(model)[-1:] if get_origin(model) is dict else get_args(model)), None)
    return list(model.model_fields) if isinstance(model, type) and issubclass(model, BaseModel) else []


def _first_line(error: Exception) -> str:
    return str(error).splitlines()[0] if str(error) else type(error).__name__
