"""Splits, and a parser that only remembers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from decomplex_bt.corpus import Example, parse_corpus
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.domain.ontology import Ontology
from decomplex_bt.errors import InputError
from decomplex_bt.reproduction.dataset import KnownDocuments, Sample, random_splits, read_samples, voice_splits
from decomplex_bt.understanding.document import Document
from decomplex_bt.understanding.features import Observed

ONE = '- {id: "%d", text: "[Go](1:motion).", flow: [1]}\n'
TWO = '- {id: "%d", text: "[Go](1:motion), [come](2:motion).", flow: [1, 2]}\n'


@pytest.fixture
def samples(ontology: Ontology) -> list[Sample]:
    """Six voices with five instructions of one task and five of two each."""
    text = "".join(ONE % i for i in range(5)) + "".join(TWO % i for i in range(5, 10))
    examples: list[Example] = []
    for voice in "abcdef":
        examples += parse_corpus(text, ontology, path=f"{voice}.yaml")
    return [Sample(example, Observed(Document("", ()), None)) for example in examples]  # type: ignore[arg-type]


def test_a_random_split_tests_a_fifth_of_each_kind(samples: list[Sample]) -> None:
    splits = random_splits(samples, 3, np.random.default_rng(0))
    assert len({split.test for split in splits}) == 3
    for split in splits:
        assert sorted((*split.train, *split.test)) == list(range(60))
        assert [samples[i].is_complex for i in split.test].count(True) == len(split.test) // 2 == 6


def test_whole_voices_are_left_out_each_once_in_five_splits(samples: list[Sample]) -> None:
    splits = voice_splits(samples, 5, np.random.default_rng(0))
    left_out = []
    for split in splits:
        tested = {samples[i].example.voice for i in split.test}
        assert not tested & {samples[i].example.voice for i in split.train}
        left_out += sorted(tested)
    assert sorted(left_out) == list("abcdef")


def test_the_same_seed_gives_the_same_splits(samples: list[Sample]) -> None:
    for protocol in (random_splits, voice_splits):
        assert protocol(samples, 4, np.random.default_rng(5)) == protocol(samples, 4, np.random.default_rng(5))


def test_one_voice_cannot_be_left_out(samples: list[Sample]) -> None:
    with pytest.raises(InputError, match="only one voice"):
        voice_splits(samples[:10], 1, np.random.default_rng(0))


def test_too_few_complex_instructions_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(TWO % 1, encoding="utf-8")
    (tmp_path / "voices.yaml").write_text("voices: {a: {description: x, split: train}}", encoding="utf-8")
    with pytest.raises(InputError, match="at least 10"):
        read_samples(tmp_path, load_domain("household"), None)


def test_known_documents_are_not_parsed_again() -> None:
    document = Document("Go.", ())
    parser = KnownDocuments({"Go.": document}, "none")
    assert parser.parse("Go.") is document
    assert "_parser" not in vars(parser), "the language model was loaded for nothing"
    found = list(parser.parse_batch(["Go.", "Come.", "Go."]))
    assert [len(each) for each in found] == [0, 2, 0]
    assert found[0] is found[2] is document
