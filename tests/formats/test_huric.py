"""HuRIC 2.1: frames to tasks by the domain's rules, on commands of our own in its structure."""

from __future__ import annotations

from pathlib import Path

import pytest

from decomplex_bt.corpus import write_markup
from decomplex_bt.domain.document import read_record
from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.errors import DataFileError
from decomplex_bt.formats.huric import RULES_FILE, Rules, read_huric, single_tasks

Frame = tuple[str, str, dict[str, str]]


@pytest.fixture(scope="module")
def domain() -> Domain:
    return load_domain("household")


def command(words: str, *frames: Frame) -> str:
    """A command as an .hrc file; a frame is its name, its verb and its elements, each by their words."""
    tokens = words.split()

    def marks(phrase: str) -> str:
        parts = phrase.split()
        start = next(i for i in range(len(tokens)) if tokens[i : i + len(parts)] == parts)
        return "".join(f'<token id="{start + i + 1}"/>' for i in range(len(parts)))

    def head(phrase: str) -> int:
        noun = next((w for w in phrase.split() if w in ("spoon", "pot", "heater")), phrase.split()[-1])
        return tokens.index(noun) + 1

    return (
        f'<huricExample id="1"><commands><command><sentence>{words}</sentence><tokens>'
        + "".join(f'<token id="{i}" lemma="{w}" pos="X" surface="{w}"/>' for i, w in enumerate(tokens, 1))
        + "</tokens><semantics><frames>"
        + "".join(
            f'<frame name="{name}"><lexicalUnit>{marks(verb)}</lexicalUnit><frameElements>'
            + "".join(
                f'<frameElement type="{kind}" semanticHead="{head(phrase)}">{marks(phrase)}</frameElement>'
                for kind, phrase in elements.items()
            )
            + "</frameElements></frame>"
            for name, verb, elements in frames
        )
        + "</frames></semantics></command></commands></huricExample>"
    )


def read(tmp_path: Path, domain: Domain, text: str):
    folder = tmp_path / "Ours"
    folder.mkdir(exist_ok=True)
    (folder / "1.hrc").write_text(text, encoding="utf-8")
    return read_huric(folder, domain)[0]


CASES = {
    "a place in the theme": (
        command("grab the spoon in the pot", ("Taking", "grab", {"Theme": "the spoon in the pot"})),
        "[grab](1:taking) [the spoon](1:object) [in the pot](1:source)",
    ),
    "a relative clause": (
        command(
            "fetch me the pot that is on the stove",
            ("Bringing", "fetch", {"Theme": "the pot that is on the stove", "Beneficiary": "me"}),
            ("Being_located", "is", {"Theme": "that", "Location": "on the stove"}),
        ),
        "[fetch](1:bringing) [me](1:recipient) [the pot](1:object) that is [on the stove](1:source)",
    ),
    "a statement ahead": (
        command(
            "there 's a pot on the stove could you carry it to me",
            ("Being_located", "there 's", {"Theme": "a pot", "Location": "on the stove"}),
            ("Bringing", "carry", {"Agent": "you", "Theme": "it", "Goal": "to me"}),
        ),
        "there's a pot [on the stove](1:source) could you [carry](1:bringing) [it](1:object=a pot) "
        "[to me](1:recipient)",
    ),
    "a statement with a verb of finding": (
        command(
            "wash the pot you can find it under the sink",
            ("Change_operational_state", "wash", {"Device": "the pot"}),
            ("Locating", "find", {"Perceiver": "you", "Sought_entity": "it", "Ground": "under the sink"}),
        ),
        "[wash](1:change_state) [the pot](1:object) you can find it [under the sink](1:location)",
    ),
    "a state without its copula": (
        command(
            "check if the heater is off",
            ("Inspecting", "check", {"Ground": "the heater", "Desired_state": "is off"}),
        ),
        "[check](1:check_state) if [the heater](1:object) is [off](1:state)",
    ),
    "a check for a thing": (
        command(
            "check whether there 's soup in the pot",
            ("Inspecting", "check", {"Ground": "there 's soup in the pot"}),
            ("Being_located", "there 's", {"Theme": "soup", "Location": "in the pot"}),
        ),
        "[check](1:check_state) whether there's [soup](1:object) [in the pot](1:location)",
    ),
    "an inspection is a search": (
        command("inspect the cellar", ("Inspecting", "inspect", {"Ground": "the cellar"})),
        "[inspect](1:searching) [the cellar](1:location)",
    ),
    "two frames of a verb": (
        command(
            "walk to the den then into the cellar",
            ("Motion", "walk", {"Goal": "to the den"}),
            ("Motion", "walk", {"Goal": "into the cellar"}),
        ),
        "[walk](1:motion) [to the den](1:goal) then [into the cellar](1:goal)",
    ),
    "several tasks, a pronoun": (
        command(
            "walk towards the heater and switch it off",
            ("Change_operational_state", "switch", {"Device": "it", "Operational_state": "off"}),
            ("Motion", "walk", {"Goal": "towards the heater"}),
        ),
        "[walk](1:motion) [towards the heater](1:goal) and [switch](2:change_state) [it](2:object=the heater) "
        "[off](2:state)",
    ),
    "no task": (
        command("this is the cellar", ("Being_in_category", "is", {"Item": "this", "Category": "the cellar"})),
        "this is the cellar",
    ),
}


@pytest.mark.parametrize(("text", "markup"), CASES.values(), ids=CASES.keys())
def test_a_command_reads_by_the_corpus_conventions(text: str, markup: str, tmp_path: Path, domain: Domain) -> None:
    example = read(tmp_path, domain, text)
    assert write_markup(example.instruction) == markup
    assert example.instruction.flow.to_json() == [task.id for task in example.instruction.tasks]
    assert (example.id, example.voice, example.source) == ("1", "Ours", "HuRIC 2.1 Ours/1")


def test_single_tasks_are_those_with_one(tmp_path: Path, domain: Domain) -> None:
    examples = [read(tmp_path, domain, CASES[name][0]) for name in ("a place in the theme", "no task")]
    assert [e.instruction.text for e in single_tasks(examples)] == ["grab the spoon in the pot"]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (command("sing", ("Singing", "sing", {})), "unknown frame 'Singing'"),
        (command("go far", ("Motion", "go", {"Tempo": "far"})), "unknown element 'Tempo' of frame Motion"),
        (command("go").replace('surface="go"', ""), "no 'surface'"),
        (command("go", ("Motion", "go", {})).replace('<token id="1"/>', '<token id="9"/>'), "unknown token '9'"),
    ],
)
def test_what_the_rules_do_not_know_is_named(text: str, problem: str, tmp_path: Path, domain: Domain) -> None:
    with pytest.raises(DataFileError, match=problem) as caught:
        read(tmp_path, domain, text)
    assert "1.hrc" in str(caught.value)


def test_every_frame_of_the_ontology_has_rules(domain: Domain) -> None:
    rules = read_record(domain.folder / RULES_FILE, Rules)
    assert {frame for t in domain.ontology.task_types.values() for frame in t.frames} <= set(rules.frames)
