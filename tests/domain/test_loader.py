"""The loader reads the household once, and names file and key where data does not fit."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DataFileError, InputError

FILES = ("ontology.yaml", "kinds.yaml", "house.yaml", "words.yaml", "goals.yaml", "domain.pddl")


@pytest.fixture
def folder(household_folder: Path, tmp_path: Path) -> Path:
    for name in FILES:
        shutil.copy(household_folder / name, tmp_path / name)
    return tmp_path


def test_the_household_loads_once() -> None:
    assert load_domain() is load_domain("household")
    assert load_domain().house.user == "user"


def test_every_kind_of_the_house_is_known_and_every_thing_has_a_place() -> None:
    domain = load_domain()
    for name, item in domain.house.things.items():
        assert item.places or domain.kind(name).places, name


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("kinds.yaml", "cools: [food]", "cools: [foood]", r"kinds\.yaml.*fridge.*'foood'"),
        (
            "kinds.yaml",
            "tags: [dish, vessel, cup], radius: 0.05",
            "tags: [dish], places: {tv: 1}, radius: 0.05",
            r"kinds\.yaml",
        ),
        ("house.yaml", "kind: bookshelf", "kind: bookshelv", r"house\.yaml.*'bookshelv'"),
        ("words.yaml", "tasks: [motion]", "tasks: [walking]", r"words\.yaml.*'walking'"),
        ("words.yaml", "verbs: [go,", "verbs: [bring, go,", r"words\.yaml.*'bring' stands twice"),
        ("goals.yaml", "(inspected {location})", "(inspekted {location})", r"goals\.yaml.*inspekted"),
        ("goals.yaml", "  informing:", "  chatting:", r"goals\.yaml.*chatting"),
        ("goals.yaml", '"(carried {object})"', '"(carried {object}"', r"goals\.yaml.*taking.*no atom"),
        ("goals.yaml", "{object: thing, goal: place}", "{object: thing, goal: plaice}", r"goals\.yaml.*'plaice'"),
        ("goals.yaml", "{object: thing}, atoms", "{objekt: thing}, atoms", r"goals\.yaml.*taking.*'objekt'"),
        ("goals.yaml", '"on": powered-on', "onn: powered-on", r"goals\.yaml.*fluents.*'onn'"),
        ("ontology.yaml", "go {goal}", "go {gaol}", r"ontology\.yaml.*'motion'.*gaol"),
        ("ontology.yaml", "go {goal}", "go {goal", r"ontology\.yaml.*'motion'.*goal"),
        ("ontology.yaml", '{object: "What should I take?"}', '{object: "What?", obejct: "What?"}', r"'obejct'"),
        ("domain.pddl", "(told ?q - person)", "", r"domain\.pddl: action say.*\(told \?q\)"),
        ("domain.pddl", "(connects ?d ?a ?b)", "(joins ?d ?a ?b)", r"domain\.pddl: action pass.*joins"),
        ("domain.pddl", "(?d - doorway", "(?d - gate", r"domain\.pddl: action pass.*'gate'"),
        (
            "domain.pddl",
            "(and (at ?p) (openable",
            "(and (not (at ?p)) (openable",
            r"action open-up.*\(not \(at \?p\)\)",
        ),
        ("domain.pddl", "(not (at ?from)) (at ?to)", "(not (at ?from)) (at ?too)", r"action move.*\?too"),
        ("domain.pddl", "(in-room ?a) (at ?d)", "(in-room ?a ?b) (at ?d)", r"action pass.*2 objects instead of 1"),
        ("domain.pddl", "(:action pass", "(:action move", r":action: move stands twice"),
        ("domain.pddl", "(?d - doorway ?a", "(?d - place ?a", r"action pass: \?d in \(connects .*'place'.*'doorway'"),
        ("domain.pddl", "(in-room ?a) (at ?q)", "(in-room ?q) (at ?q)", r"follow: \?q .*'person'; .* takes 'room'"),
        ("domain.pddl", "(?q - person ?a - room", "(?q - object ?a - room", r"follow: \?q .*'object'; .* takes"),
        ("domain.pddl", "(followed ?q ?b)", "(followed ?b ?q)", r"follow: \?b in \(followed \?b \?q\) is of"),
        ("domain.pddl", "(?d - doorway ?a", "(?a - doorway ?a", r"action pass: \?a stands twice"),
        ("domain.pddl", "(in-room ?r - room)", "(in-room ?r - room) (in-room ?p - place)", r"s: in-room stands twice"),
        ("domain.pddl", "position - object", "position - person", r":types: (position|person) is a type of its own"),
        ("domain.pddl", "fact - object", "fact place - object", r":types: place stands twice"),
        (
            "goals.yaml",
            "{object: thing, goal: place}",
            "{object: thing, goal: position}",
            r"'position'; .*'place'",
        ),
        ("domain.pddl", ":effect (and (accompanied ?q))", "", r"action tag-along: expected"),
        ("domain.pddl", "(define (domain household)", "(define (domain household", r"domain\.pddl: a parenthesis"),
        ("house.yaml", "robot_start: {hallway: 2, living_room: 1, kitchen: 1}", "robot_start: {}", r"robot_start"),
        ("house.yaml", "robot_start: {hallway: 2, living_room: 1, kitchen: 1}", "robot_start: {study: 0}", r"all.* 0"),
        ("house.yaml", "rooms: {living_room: 2, study: 1,", "rooms: {living_room: 2, study: -1,", r"tom\.rooms\.study"),
        ("house.yaml", "things:\n", "things:\n  relic: {kind: pen, places: {bed: -1}}\n", r"relic\.places\.bed"),
        ("house.yaml", "things:\n", "things:\n  relic: {kind: pen, absent: 2}\n", r"relic\.absent"),
        ("house.yaml", "format: 1", "format: 2", r"house\.yaml: format"),
        ("kinds.yaml", "format: 1", "format: 2", r"kinds\.yaml: format"),
        ("house.yaml", "user: {kind: user", "user: {home: 0.5, kind: user", r"people\.user\.home: .* always at home"),
        ("kinds.yaml", "words: [pen,", "words: ['', pen,", r"kinds\.yaml: kinds\.pen\.words\.0: a word is blank"),
        ("kinds.yaml", "words: [pen,", "words: ['  ', pen,", r"kinds\.yaml: kinds\.pen\.words\.0: a word is blank"),
        ("house.yaml", "words: [anna]", "words: ['']", r"house\.yaml: people\.anna\.words\.0: a word is blank"),
        ("words.yaml", "verbs: [go,", "verbs: ['', go,", r"words\.yaml: groups\.0\.verbs\.0: a word is blank"),
        ("kinds.yaml", "words: [pen,", "states: [aperture], words: [pen,", r"kinds\.pen\.states: only furniture and"),
        ("kinds.yaml", "words: [pen,", "states: [power], words: [pen,", r"kinds\.pen\.states: .* 'power'"),
        ("kinds.yaml", "radius: 0.14", "radius: 2.0", r"kinds\.pillow\.radius: 2 m is too large.* up to 0\.25 m"),
        ("kinds.yaml", "shape: plate", "shape: sphere", r"kinds\.plate\.shape: .*'disc'.*'ball'.*\(got 'sphere'\)"),
        ("kinds.yaml", '["on", "off"]', '["off", "on"]', r"power\.values: expected \[on, off\].*\(got \[off, on\]\)"),
        ("kinds.yaml", "values: [clean, dirty]", "values: [clean, muddy]", r"cleanliness\.values: .*\[clean, dirty\]"),
        ("kinds.yaml", "  cleanliness:", "  hygiene:", r"state_pairs\.hygiene: .* no such state; known: .*cleanliness"),
        (
            "kinds.yaml",
            "state_pairs:",
            "state_pairs:\n  wet: {values: [wet, dry]}",
            r"state_pairs\.wet: .*leave it out",
        ),
        ("kinds.yaml", "open: [opened,", "open: [closed,", r"aperture\.words\.open: 'closed' means 'closed', too"),
        ("kinds.yaml", "cold: [cool,", "cold: [Warm,", r"temperature\.words\.cold: 'warm' means 'hot', too"),
        ("kinds.yaml", "empty: [emptied", "vacant: [emptied", r"fill\.words: 'vacant' is none of its values"),
        ("kinds.yaml", "fills: [cup], pours", "pours", r"kinds\.coffee machine\.pours: .*this kind fills none"),
        (
            "kinds.yaml",
            "power], heats",
            "fill], heats",
            r"kinds\.microwave\.heats: .* give the kind power among its `st",
        ),
        ("kinds.yaml", "[aperture, power], heats", "[power], heats", r"microwave\.heats: .* aperture among"),
        (
            "kinds.yaml",
            "states: [aperture], cools",
            "cools",
            r"fridge\.cools: .* closed; give the kind aperture among its",
        ),
        (
            "kinds.yaml",
            "states: [power], fills: [cup]",
            "heats: [food], fills: [cup]",
            r"coffee machine\.heats: .*inside: true.* aperture, power",
        ),
        ("kinds.yaml", "rinses: [dish,", "rinses: [food,", r"sink\.rinses: no thing .*'food' has 'cleanliness'"),
        ("kinds.yaml", "wipes: [wipeable]", "wipes: [dish]", r"rag\.wipes: no furniture.* 'dish' has 'cleanliness'"),
        ("kinds.yaml", "words: [pen,", "fills: [cup], words: [pen,", r"pen\.fills: expected .*and this is a thing"),
        ("house.yaml", "  pen_1:", "  slot_1:", r"house\.yaml: things\.slot_1: the name 'slot_1' is taken by planning"),
        ("house.yaml", "  pen_1:", "  power__tv:", r"things\.power__tv: the name 'power__tv' is taken by planning"),
    ],
)
def test_a_file_that_does_not_fit_is_named(folder: Path, file: str, old: str, new: str, message: str) -> None:
    text = (folder / file).read_text(encoding="utf-8")
    assert old in text
    (folder / file).write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(DataFileError, match=message):
        load_domain(folder)


def test_a_folder_is_read_anew_when_a_file_of_it_was_edited(folder: Path) -> None:
    before = load_domain(folder)
    assert load_domain(folder) is before
    text = (folder / "house.yaml").read_text(encoding="utf-8")
    (folder / "house.yaml").write_text(text.replace("default house", "another house"), encoding="utf-8")
    assert load_domain(folder).house.name == "another house"


def test_an_unknown_domain_names_the_known_ones() -> None:
    with pytest.raises(InputError, match=r"'hospital'.*household"):
        load_domain("hospital")


def test_a_folder_may_be_a_text_with_a_slash(tmp_path: Path) -> None:
    with pytest.raises(DataFileError):
        load_domain(f"{tmp_path}/")
    folder = load_domain("household").folder
    assert load_domain(str(folder)).folder == folder


@pytest.mark.parametrize("domain", [3, [], b"household"])
def test_what_is_no_domain_is_refused(domain: object) -> None:
    with pytest.raises(InputError, match="domain is"):
        load_domain(domain)  # type: ignore[arg-type]
