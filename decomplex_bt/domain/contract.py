"""The contract between `domain.pddl` and the code: the types, fluents and actions that planning and skills go by name.

A domain keeps these names, and the order of parameters; it may add to them, change preconditions and effects, and leave
out an action that nothing in its goals and kinds asks for. Tests hold the tables against the code that relies on them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from decomplex_bt.domain.abilities import ABILITIES
from decomplex_bt.domain.goals import Goals
from decomplex_bt.domain.kinds import Kinds
from decomplex_bt.domain.pddl import Signatures, Types, pddl_adds, pddl_parameters, pddl_predicates, pddl_types
from decomplex_bt.errors import among

Objects = tuple[str, ...]
"""The types of the objects of a fluent, or of the parameters of an action, in order."""
POSITION = "position"
"""The type of all that the robot can be at: it is above three types that objects have."""
AT_POSITIONS = ("place", "person", "doorway")
OBJECT_TYPES = ("room", "thing", "slot", "fact", *AT_POSITIONS)
"""The types that objects of a problem have (`Domain.pddl_type`, `planning/problem.py`): each object has one of them."""

FLUENTS: Mapping[str, Objects] = {
    "in-room": ("room",),
    "at": ("position",),
    "within": ("position", "room"),
    "connects": ("doorway", "room", "room"),
    "open": ("position",),
    "closed": ("position",),
    "ready": ("position",),
    "openable": ("position",),
    "switchable": ("position",),
    "drainable": ("place",),
    "lies": ("thing", "place"),
    "has": ("person", "thing"),
    "hand-free": (),
    "holding": ("thing",),
    "slot-free": ("slot",),
    "on-tray": ("thing", "slot"),
    "carried": ("thing",),
    "inspected": ("place",),
    **{key: ("place", "thing") for key in ABILITIES if key != "wipes"},
    "wipes": ("thing", "place"),
    "about": ("fact", "object"),
    "known": ("fact",),
    "told": ("person",),
    "followed": ("person", "room"),
    "accompanied": ("person",),
}
"""The fluents that planning writes into problems, or it or the judge asks for by name.

Those of state values come from `goals.yaml`."""
_OF_GOALS = frozenset(("about", "known", "told", "followed", "accompanied"))
"""Those that only a goal asks for: a domain without such a goal may leave them out."""

ACTIONS: Mapping[str, Objects] = {
    "move": ("position", "position", "room"),
    "pass": ("doorway", "room", "room"),
    "follow": ("person", "room", "room"),
    "tag-along": ("person",),
    "open-up": ("position",),
    "close-up": ("position",),
    "switch-on": ("position",),
    "switch-off": ("position",),
    "pick": ("thing", "place"),
    "place": ("thing", "place"),
    "stow": ("thing", "slot"),
    "unstow": ("thing", "slot"),
    "give": ("thing", "person"),
    "receive": ("thing", "person"),
    "heat": ("thing", "place"),
    "wash": ("thing", "place"),
    "chill": ("thing", "place"),
    "rinse": ("thing", "place"),
    "fill": ("thing", "place"),
    "drain": ("thing", "place"),
    "drain-place": ("place",),
    "wipe": ("place", "thing"),
    "inspect": ("place",),
    "sense": ("fact", "thing", "place"),
    "sense-held": ("fact", "thing"),
    "sense-given": ("fact", "thing", "person"),
    "sense-place": ("fact", "position"),
    "say": ("person",),
}
"""What an action takes that a skill of the robot carries out (`envs/skills.py`); a domain may narrow the types."""

_ALWAYS = ("move", "pass", "open-up", "close-up", "pick", "place", "inspect")
"""Actions without which no thing is found, reached and handled; with the others a domain need not have them all."""
_FOR_GOALS: Mapping[str, tuple[str, ...]] = {
    "has": ("give", "receive"),
    "known": ("sense", "sense-held", "sense-given", "sense-place"),
    "told": ("say",),
    "followed": ("follow",),
    "accompanied": ("tag-along",),
}
"""Actions that are needed where a goal is about a fluent."""
_BRINGS: Mapping[str, str] = {
    "open-up": "open",
    "close-up": "closed",
    "switch-on": "on",
    "switch-off": "off",
    "drain-place": "empty",
    **{ability.action: ability.brings for ability in ABILITIES.values()},
}
"""The state value that the skill of an action brings about in the world."""


def check_names(text: str) -> None:
    """Raises `ValueError` where a PDDL domain lacks a type or a fluent that is gone by its name, has one with other
    objects, or an action with parameters of which there can be no objects, or other ones than its skill takes."""
    types, predicates = pddl_types(text), pddl_predicates(text)
    _check_types(types)
    for name, objects in FLUENTS.items():
        if name not in predicates:
            if name in _OF_GOALS or name in ABILITIES:  # of which `check_deeds` says whether a kind has it
                continue
            raise ValueError(_lacking(name, predicates))
        if not _fits(objects, predicates[name], types):
            raise ValueError(
                f":predicates: {name} takes {_listed(predicates[name])}; planning gives it {_listed(objects)}"
            )
    for name, parameters in pddl_parameters(text).items():
        for variable, of in parameters:
            if not is_had(of, types):
                raise ValueError(f"action {name}: {variable} is of the type {of!r}, which {_NOBODY}")
    check_parameters(text)


def check_parameters(text: str) -> None:
    """Raises `ValueError` that names the action whose parameters are not those that its skill takes."""
    types = pddl_types(text)
    for name, parameters in pddl_parameters(text).items():
        found = tuple(of for _, of in parameters)
        if name in ACTIONS and not _fits(found, ACTIONS[name], types):
            raise ValueError(
                f"action {name}: its parameters are {_listed(found)}; expected {_listed(ACTIONS[name])} in this order, "
                "as the robot's skill and the planning take them"
            )


def check_deeds(text: str, goals: Goals, kinds: Kinds) -> None:
    """Raises `ValueError` where a PDDL domain lacks an action that its goals and kinds need, or has one that does not
    bring about the state that its skill does."""
    adds, predicates = pddl_adds(text), pddl_predicates(text)
    for key in ABILITIES:
        if key not in predicates and any(getattr(kind, key) for kind in kinds.kinds.values()):
            raise ValueError(_lacking(key, predicates))
    for name, why in _needed(goals, kinds):
        if name not in adds:
            raise ValueError(f"there is no action {name}, by which the robot {why}{among(name, adds)}; keep the name")
    values = {value for pair in kinds.state_pairs.values() for value in pair.values}
    for name, value in _BRINGS.items():
        if name in adds and value in values and goals.fluent(value) not in {atom[0] for atom in adds[name]}:
            raise ValueError(
                f"action {name}: its effect lacks ({goals.fluent(value)} ...), which the robot's skill brings about; "
                f"add it, or mend what {value!r} is called under `fluents` in goals.yaml"
            )


def _lacking(name: str, predicates: Signatures) -> str:
    return (
        f":predicates: there is no {_said(name, FLUENTS[name])}, which planning goes by{among(name, predicates)}; "
        "keep the name"
    )


def check_goal_types(goals: Goals, types: Types) -> None:
    """Raises `ValueError` where a goal is for objects of a type that none is of, or a fluent that is gone by its name
    is called otherwise."""
    for task_type, templates in goals.goals.items():
        for role, of in ((role, of) for template in templates for role, of in template.of.items()):
            if of in types and not is_had(of, types):
                raise ValueError(f"goals.{task_type}: {role} is of the type {of!r}, which {_NOBODY}")
    if renamed := [value for value in FLUENTS if goals.fluent(value) != value]:
        raise ValueError(f"fluents.{renamed[0]}: planning goes by ({renamed[0]} ?object); leave it out")


def is_had(of: str, types: Types) -> bool:
    """Whether there can be objects of a type."""
    return any(types.is_a(special, of) for special in OBJECT_TYPES)


_NOBODY = (
    f"no object ever is: objects are of the types {', '.join(OBJECT_TYPES)} and of those above them; take one of "
    "these, and narrow it by a fluent, as (heats ?p ?t) does"
)


def _check_types(types: Types) -> None:
    for name in (*OBJECT_TYPES, POSITION):
        if name not in types:
            raise ValueError(
                f":types: there is no {name!r}{among(name, types.names())}; objects are of the types "
                f"{', '.join(OBJECT_TYPES)}, of which {', '.join(AT_POSITIONS)} are a {POSITION}: keep these names"
            )
    for special in OBJECT_TYPES:
        for general in (*OBJECT_TYPES, POSITION):
            expected = special == general or (general == POSITION and special in AT_POSITIONS)
            if types.is_a(special, general) != expected:
                raise ValueError(
                    f":types: {special!r} is {'one of' if not expected else 'not one of'} {general!r}; expected "
                    f"{', '.join(AT_POSITIONS)} below {POSITION}, and none of the other types of objects below another"
                )


def _needed(goals: Goals, kinds: Kinds) -> Iterator[tuple[str, str]]:
    """The actions that a domain needs, each with what the robot does by it."""
    yield from ((name, "reaches and handles things") for name in _ALWAYS)
    wanted = {parts[0] for templates in goals.goals.values() for template in templates for parts in template.parts()}
    for fluent, names in _FOR_GOALS.items():
        if fluent in wanted:
            yield from ((name, f"brings about or goes on from ({fluent} ...), a goal of goals.yaml") for name in names)
    for key, ability in ABILITIES.items():
        if able := next((name for name, kind in kinds.kinds.items() if getattr(kind, key)), None):
            yield ability.action, f"makes use of kinds.{able}.{key}"
    for name, kind in kinds.kinds.items():
        if kind.is_device:
            yield from ((action, f"switches what has power, as kinds.{name}") for action in ("switch-on", "switch-off"))
        if "fill" in kind.states and kind.category != "thing":
            yield "drain-place", f"empties kinds.{name}"


def _fits(special: Objects, general: Objects, types: Types) -> bool:
    """Whether objects of the first types are of the second ones, one by one."""
    return len(special) == len(general) and all(map(types.is_a, special, general))


def _said(name: str, objects: Objects) -> str:
    return f"({' '.join((name, *(f'?{of}' for of in objects)))})"


def _listed(objects: Objects) -> str:
    return f"({', '.join(objects)})" if objects else "no objects"
