"""The inline format: what it says, what it refuses and how, and that writing is the inverse of reading."""

import pytest

from decomplex_bt.corpus import lint, parse_corpus, read_corpus, read_markup, read_voices, write_markup
from decomplex_bt.errors import DataFileError, InputError

PEN = """
- id: pen-or-drawer
  text: >-
    [Bring](1:bringing) [me](1:recipient) [a pen](1:object) if you can [find](2:searching) [it](2:object=a pen)
    [on the table](2:location), if you cannot [find](3:searching) [one](3:object=a pen) then
    [search](4:searching) [in the drawer](4:location).
  implied: {4: {object: a pen}}
  flow: [{if: [2, 3], then: [1], else: [4]}]
"""


def example(ontology, text, flow="[1]", more=""):
    return parse_corpus(f"- id: a\n  text: >-\n    {text}\n  flow: {flow}\n{more}", ontology, path="file.yaml")[0]


def test_the_guidelines_example_reads_as_the_guideline_says(ontology):
    instruction = parse_corpus(PEN, ontology)[0].instruction
    assert instruction.text.startswith("Bring me a pen if you can find it on the table, if you cannot find one then")
    printed = instruction.to_json()
    assert [(t["start"], t["end"], t["dependency"]) for t in printed["tasks"]] == [
        (0, 5, "dependent_positive"),
        (26, 30, "conditional"),
        (62, 66, "conditional"),
        (76, 82, "dependent_negative"),
    ]
    assert printed["tasks"][3]["arguments"][0] == {
        "type": "object", "start": None, "end": None, "surface": None, "value": "a pen", "confidence": 1.0,
    }  # fmt: skip
    assert printed["flow"] == [{"if": [2, 3], "then": [1], "else": [4]}]


@pytest.mark.parametrize(
    ("text", "flow", "more", "problem"),
    [
        ("[go](1:fly)", "[1]", "", "unknown label 'fly'"),
        ("[go](1:motion) [go](1:motion)", "[1]", "", "marked twice"),
        ("[go](2:motion)", "[2]", "", "number 1, not 2"),
        ("[pick up](1:taking)", "[1]", "", "one token"),
        ("[go ](1:motion)", "[1]", "", "starts or ends with a space"),
        ("[go](1:motion) [home](2:goal)", "[1]", "", "no token is marked as task 2"),
        ("[go](1:motion=there)", "[1]", "", "has a referent"),
        ("[go](1:motion) now]", "[1]", "", "stray ']'"),
        ("[go](1:motion)", "[1, 2]", "", "there is no task 2"),
        ("[go](1:motion)", "[1]", "  implied: {1: {place: home}}", "unknown argument type 'place'"),
        ("[go](1:motion)", "[1]", "  implied: {1: {state: on}}", "implied.1.state"),
        ("[go](1:motion)", "[1]", "  colour: red", "colour"),
    ],
)
def test_a_wrong_example_is_refused_naming_file_line_and_fault(ontology, text, flow, more, problem):
    with pytest.raises(DataFileError, match=r"file\.yaml:1: ") as caught:
        example(ontology, text, flow, more)
    assert problem in str(caught.value)
    assert "\n" not in str(caught.value)


def test_an_id_stands_once(ontology):
    with pytest.raises(DataFileError, match="twice"):
        parse_corpus(PEN + PEN, ontology)


def test_a_key_given_twice_is_refused(ontology):
    with pytest.raises(DataFileError, match="stands twice"):
        parse_corpus("- id: a\n  id: b\n  text: x\n  flow: []", ontology)


def test_brackets_can_be_escaped(ontology):
    instruction = example(ontology, r"[go](1:motion) \[quickly\] [home](1:goal)").instruction
    assert instruction.text == "go [quickly] home"
    assert write_markup(instruction) == r"[go](1:motion) \[quickly\] [home](1:goal)"


def test_a_pronoun_without_a_referent_gets_a_second_look(ontology):
    assert [remark for _, remark in lint([example(ontology, "[take](1:taking) [it](1:object)")], ontology)]
    assert not list(lint([example(ontology, "[take](1:taking) [it](1:object=the cup)")], ontology))


def test_every_file_of_the_corpus_reads_and_survives_a_round_trip(ontology, household_folder):
    for example in read_corpus(household_folder / "corpus", ontology):
        said = example.instruction
        implied = {t.id: {a.type: a.value for a in t.arguments if a.span is None} for t in said.tasks}
        again = read_markup(write_markup(said), ontology, flow=said.flow.to_json(), implied=implied)
        assert again.text == said.text, example.id
        assert again.flow == said.flow, example.id
        for mine, theirs in zip(again.tasks, said.tasks, strict=True):
            assert set(mine.arguments) == set(theirs.arguments), example.id


def test_every_voice_has_a_file_a_split_and_the_test_voices_are_whole_files(household_folder):
    voices = read_voices(household_folder / "corpus")
    files = {file.stem for file in (household_folder / "corpus").glob("*.yaml")} - {"voices"}
    assert set(voices) == files
    assert {voice.split for voice in voices.values()} == {"train", "development", "test"}


def test_a_corpus_is_read_from_a_path_or_its_text(ontology, tmp_path):
    path = tmp_path / "mine.yaml"
    path.write_text(PEN, encoding="utf-8")
    assert read_corpus(str(path), ontology) == read_corpus(path, ontology)
    with pytest.raises(InputError, match="path is 3; expected a corpus file, or a folder"):
        read_corpus(3, ontology)


@pytest.mark.parametrize("text", ["", "# nothing yet\n"])
def test_an_empty_file_is_called_so(text, ontology):
    with pytest.raises(DataFileError, match=r"mine\.yaml: the file is empty; expected a list of examples"):
        parse_corpus(text, ontology, path="mine.yaml")
