"""The domain: a folder of data files, read once, checked against each other, and handed on as one frozen value."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from importlib.resources import files
from pathlib import Path

from decomplex_bt.domain.abilities import check_abilities
from decomplex_bt.domain.contract import check_deeds, check_goal_types, check_names
from decomplex_bt.domain.document import Model, check_record, load_yaml, read_text
from decomplex_bt.domain.goals import Goals, check_goals
from decomplex_bt.domain.house import House
from decomplex_bt.domain.kinds import Kind, Kinds
from decomplex_bt.domain.lexicon import Lexicon
from decomplex_bt.domain.nouns import Nouns
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.domain.pddl import Types, check_pddl, pddl_predicates, pddl_types
from decomplex_bt.domain.survey import check_house
from decomplex_bt.errors import DataFileError, InputError, among

_FILES = ("ontology.yaml", "kinds.yaml", "house.yaml", "words.yaml", "goals.yaml", "domain.pddl")


@dataclass(frozen=True, eq=False)
class Domain:
    """Everything that is known before an episode: task types, words, kinds, the house, goals and the PDDL text.

    Compared by identity: a folder is loaded once per process, and anew when one of its files was changed.
    """

    name: str
    folder: Path
    ontology: Ontology
    kinds: Kinds
    house: House
    lexicon: Lexicon
    goals: Goals
    domain_pddl: str = field(repr=False)
    nouns: Nouns = field(repr=False)

    def kind(self, name: str) -> Kind:
        """The kind of an entity of the house. Raises `KeyError` (also for an opening without a door)."""
        return self.house.kind(name, self.kinds)

    def room_of(self, place: str) -> str | None:
        """The room of a piece of furniture, a fixture or a floor, or the room itself; None for anything else."""
        if place in self.house.furniture:
            return self.house.furniture[place].room
        room = place.removesuffix("_floor")
        return room if room in self.house.rooms else None

    def pddl_type(self, name: str) -> str:
        """The most special PDDL type of an entity, room or doorway: one of `contract.OBJECT_TYPES`. Raises `KeyError`
        where there is none."""
        house = self.house
        if name in house.things:
            return "thing"
        if name in house.people:
            return "person"
        if name in house.rooms:
            return "room"
        if name in house.doorways:
            return "doorway"
        if self.room_of(name) is not None:
            return "place"
        raise KeyError(name)

    def has_type(self, name: str, of: str) -> bool:
        """Whether an entity, room or doorway is of this PDDL type, or of one below it."""
        try:
            special = self.pddl_type(name)
        except KeyError:
            return False
        return self._types.is_a(special, of)

    @cached_property
    def _types(self) -> Types:
        return pddl_types(self.domain_pddl)


def load_domain(domain: str | Path = "household") -> Domain:
    """The domain of this name among those shipped, or the one in this folder: a path, or a text with a slash.

    Raises `DataFileError` where a file is missing or broken, or where two files do not fit; `InputError` for an
    unknown name.
    """
    if is_folder(domain):
        return _read(Path(domain).resolve())
    shipped = Path(str(files("decomplex_bt.domains")))
    folder = shipped / domain
    if not (folder / "ontology.yaml").is_file():
        known = sorted(path.parent.name for path in shipped.glob("*/ontology.yaml"))
        raise InputError(
            f"unknown domain {domain!r}; expected one of {', '.join(known)}, or a folder, written with a slash "
            f"as in ./{Path(domain).name or 'mine'} (in Python also a Path)"
        )
    return _read(folder.resolve())


def is_folder(domain: str | Path) -> bool:
    """Whether a domain is said by its folder, not by the name of a shipped one. Raises `InputError` for neither."""
    if not isinstance(domain, str | Path):
        raise InputError(f"domain is {domain!r}; expected the name of a shipped one, a folder or a Domain")
    return isinstance(domain, Path) or Path(domain).name != domain


def _read(folder: Path) -> Domain:
    return _load(folder, tuple(read_text(folder / name) for name in _FILES))


@lru_cache(maxsize=16)
def _load(folder: Path, texts: tuple[str, ...]) -> Domain:
    """The domain of a folder whose files have these texts: one that was edited is read anew."""
    text_of = dict(zip(_FILES, texts, strict=True))

    def record(name: str, model: type[Model]) -> Model:
        return check_record(load_yaml(text_of[name], folder / name), model, folder / name)

    ontology = record("ontology.yaml", Ontology)
    kinds = record("kinds.yaml", Kinds)
    house = record("house.yaml", House)
    lexicon = record("words.yaml", Lexicon)
    goals = record("goals.yaml", Goals)
    domain_pddl = text_of["domain.pddl"]
    with _blame(folder / "kinds.yaml"):
        check_abilities(kinds)
    with _blame(folder / "house.yaml"):
        check_house(house, kinds, lexicon.colours)
    with _blame(folder / "words.yaml"):
        _check_words(lexicon, ontology, kinds)
    with _blame(folder / "domain.pddl"):
        check_pddl(domain_pddl)
        check_names(domain_pddl)
    with _blame(folder / "goals.yaml"):
        _check_task_types(goals, ontology)
        values = tuple(value for pair in kinds.state_pairs.values() for value in pair.values)
        predicates, types = pddl_predicates(domain_pddl), pddl_types(domain_pddl)
        check_goals(goals, predicates, types, values, ontology.argument_types)
        check_goal_types(goals, types)
    with _blame(folder / "domain.pddl"):
        check_deeds(domain_pddl, goals, kinds)
    nouns = Nouns.of(house, kinds)
    return Domain(folder.name, folder, ontology, kinds, house, lexicon, goals, domain_pddl, nouns)


@contextmanager
def _blame(path: Path) -> Iterator[None]:
    """Turns what a check finds into an error that names the file."""
    try:
        yield
    except ValueError as error:
        raise DataFileError(path, str(error)) from None


def _check_words(lexicon: Lexicon, ontology: Ontology, kinds: Kinds) -> None:
    values = {value for pair in kinds.state_pairs.values() for value in pair.values}
    for group in lexicon.groups:
        for task in group.tasks:
            if task not in ontology.task_types:
                raise ValueError(
                    f"groups: {group.verbs[0]!r}: unknown task type {task!r}{among(task, ontology.task_types)}"
                )
        if group.state is not None and group.state not in values:
            raise ValueError(f"groups: {group.verbs[0]!r}: unknown state {group.state!r}{among(group.state, values)}")


def _check_task_types(goals: Goals, ontology: Ontology) -> None:
    if unknown := sorted(set(goals.goals) - set(ontology.task_types)):
        raise ValueError(
            f"goals.{unknown[0]}: no such task type in ontology.yaml{among(unknown[0], ontology.task_types)}"
        )
    if without := sorted(set(ontology.task_types) - set(goals.goals)):
        raise ValueError(f"goals: the task type {without[0]!r} of ontology.yaml has no goal")
