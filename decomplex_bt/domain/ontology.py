"""The ontology: which task types and argument types there are, and which arguments a task needs."""

from __future__ import annotations

import re

from pydantic import model_validator

from decomplex_bt.domain.document import Format, Record
from decomplex_bt.errors import among


class TaskType(Record):
    """One task type.

    `required`: groups of argument types, one of each group is needed, the first of a group is what is asked for.
    `questions`: argument type to the question that asks for it. `says`: the task in plain English, with argument types
    in braces. `frames`: HuRIC 2.1 frames that map to this type.
    """

    description: str
    arguments: tuple[str, ...]
    required: tuple[tuple[str, ...], ...] = ()
    questions: dict[str, str] = {}
    says: str
    frames: tuple[str, ...] = ()


class Ontology(Record):
    """`ontology.yaml`: the task types and argument types of a domain, by name."""

    format: Format
    argument_types: dict[str, str]
    task_types: dict[str, TaskType]

    @model_validator(mode="after")
    def _check(self) -> Ontology:
        for name, task_type in self.task_types.items():
            for argument in task_type.arguments:
                if argument not in self.argument_types:
                    raise ValueError(
                        f"task type {name!r} takes the unknown argument type {argument!r}"
                        f"{among(argument, self.argument_types)}"
                    )
            for word in task_type.says.split():
                match = re.fullmatch(r"\{(\w+)\}", word)
                if re.search("[{}]", word) and (match is None or match[1] not in task_type.arguments):
                    raise ValueError(
                        f"task type {name!r} says {word!r}; expected one of its arguments in braces, a word of its own"
                    )
            if unknown := [argument for argument in task_type.questions if argument not in task_type.arguments]:
                raise ValueError(f"task type {name!r} asks for {unknown[0]!r}, which is none of its arguments")
            for group in task_type.required:
                for argument in group:
                    if argument not in task_type.arguments:
                        raise ValueError(f"task type {name!r} requires {argument!r}, which is none of its arguments")
                if group[0] not in task_type.questions:
                    raise ValueError(f"task type {name!r} has no question for the required argument {group[0]!r}")
        return self
