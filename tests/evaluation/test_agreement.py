"""Two annotations held against each other: what counts as the same, what is listed; and the shipped second one."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from decomplex_bt.cli import main
from decomplex_bt.corpus import SECOND_ANNOTATION, Example, parse_corpus, read_corpus
from decomplex_bt.errors import InputError
from decomplex_bt.evaluation.agreement import agreement, disagreements, kappa, matched

FIRST = """
- id: a
  text: "[Take](1:taking) [the cup](1:object) and come back and [tell](2:informing) [me](2:recipient)."
  flow: [1, 2]
- id: b
  text: "If [it](1:object=the cup) [is](1:check_state)n't [hot](1:state), [heat](2:change_state) [it](2:object=a cup)."
  flow: [{if: 1, else: [2]}]
"""
SECOND = """
- id: b
  text: "If [it](1:object=The cup) [is](1:check_state)n't [hot](1:state), [heat](2:change_state) [it](2:object=it)."
  flow: [{if: 1, else: [2]}]
- id: a
  text: "[Take](1:taking) [the cup](1:object) and [come](2:motion) back and [tell](3:informing) [me](3:recipient)."
  flow: [1, 2, 3]
"""


def pairs(ontology, first: str = FIRST, second: str = SECOND) -> list[tuple[Example, Example]]:
    return matched(parse_corpus(first, ontology), parse_corpus(second, ontology))


def test_agreement_counts_labels_flows_and_values(ontology) -> None:
    found = agreement([(one.instruction, other.instruction) for one, other in pairs(ontology)])
    assert found.scores.tasks.overall.value == pytest.approx(2 * 4 / (4 + 5))
    assert found.scores.arguments.overall.value == 1.0
    assert found.argument_kappa == 1.0
    # a: Take the cup and come back and tell me . (10); b: If it is n't hot , heat it . (9)
    chance = (15 * 14 + 1 + 1 + 1 + 1) / 19**2
    assert found.task_kappa == pytest.approx((18 / 19 - chance) / (1 - chance))
    assert (found.complex_flow.count, found.complex_flow.total) == (1, 2)
    assert (found.values.count, found.values.total) == (4, 5)


def test_kappa_is_known_from_a_table() -> None:
    labels = [("x", "x")] * 20 + [("x", "y")] * 5 + [("y", "x")] * 10 + [("y", "y")] * 15
    assert kappa(labels) == pytest.approx(0.4)
    assert kappa([("x", "x")]) is None


def test_disagreements_say_what_is_different(ontology) -> None:
    listed = {found.id: found for found in disagreements(pairs(ontology))}
    assert listed["b"].kinds == ("values",)
    assert listed["a"].kinds == ("tasks", "flow")
    assert "second only: come:motion" in listed["a"].differences
    assert "first only:  [1 Take, 2 tell]" in listed["a"].differences


@pytest.mark.parametrize(("old", "new"), [("id: a", "id: z"), ("the cup](1:object) and", "the mug](1:object) and")])
def test_other_instructions_are_refused_by_name(ontology, old: str, new: str) -> None:
    with pytest.raises(InputError, match=r"'[az]'"):
        pairs(ontology, second=SECOND.replace(old, new))


def test_the_second_annotation_is_of_shipped_instructions_and_no_voice(
    ontology, household_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    corpus = household_folder / "corpus"
    second = read_corpus(corpus / SECOND_ANNOTATION, ontology)
    assert not {example.voice for example in second} & {example.voice for example in read_corpus(corpus, ontology)}
    assert main(["corpus", "agreement", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["all"]["instructions"] == len(second) == sum(part["instructions"] for part in found["voices"].values())
    assert found["all"]["tasks"]["f1"] > 0.98
    assert main(["corpus", "agreement", str(corpus)]) == 2


def test_nothing_agrees_with_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("first.yaml", "second.yaml"):
        (tmp_path / name).write_text("[]\n", encoding="utf-8")
    assert main(["corpus", "agreement", str(tmp_path / "first.yaml"), str(tmp_path / "second.yaml")]) == 2
    assert "second.yaml: there is no instruction in it" in capsys.readouterr().err


def test_three_annotations_are_of_the_same_instructions_and_of_no_voice(ontology, household_folder: Path) -> None:
    corpus = household_folder / "corpus"
    files = sorted((corpus / "three_annotations").glob("*.yaml"))
    sets = [file for file in files if "." not in file.stem]
    assert len(files) == 3 * len(sets) > 0
    known = {example.instruction.text for example in read_corpus(corpus, ontology)}
    for file in sets:
        first = {example.id: example.instruction.text for example in read_corpus(file, ontology)}
        assert known.isdisjoint(first.values())
        for other in ("second", "third"):
            again = read_corpus(file.with_suffix(f".{other}.yaml"), ontology)
            assert {example.id: example.instruction.text for example in again} == first


def test_the_outsiders_are_of_no_voice_and_annotated_twice(ontology, household_folder: Path) -> None:
    corpus = household_folder / "corpus"
    first = read_corpus(corpus / "outsiders", ontology)
    second = read_corpus(corpus / "outsiders" / SECOND_ANNOTATION, ontology)
    texts = {example.id: example.instruction.text for example in first}
    assert texts == {example.id: example.instruction.text for example in second}
    known = {example.instruction.text for example in read_corpus(corpus, ontology)}
    assert texts
    assert known.isdisjoint(texts.values())
