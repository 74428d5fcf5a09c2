"""What refers to what: phrases, spellings and a model trained on a handful of instructions."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest
from documents import document as parsed

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DataFileError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.understanding.coreference import ReferenceModel, likeliest, train_references
from decomplex_bt.understanding.document import Document, Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.references.affinity import options_of
from decomplex_bt.understanding.references.chunks import noun_chunks
from decomplex_bt.understanding.references.context import Context
from decomplex_bt.understanding.references.gaps import gap_of, unsaid_gaps
from decomplex_bt.understanding.references.nouns import noun_of
from decomplex_bt.understanding.references.options import Option
from decomplex_bt.understanding.references.phrases import Candidate, candidates_of, predicates_of
from decomplex_bt.understanding.references.spellings import part_of, spellings

GAZETTEER = Gazetteer({}, {}, frozenset())


def document(*words: str) -> Document:
    """A document of words with tags alone ("bring/VB"), without a parse."""
    return parsed(*(f"{word}/dep/{i}" for i, word in enumerate(words)))


def argument(doc: Document, kind: str, first: int, last: int, value: str | None = None) -> Argument:
    span = doc.span(first, last)
    return Argument(kind, value or span.of(doc.text), span)


def fetched(thing: str, pronoun: str) -> tuple[Observed, Instruction]:
    """ "take the THING and bring PRONOUN", the pronoun standing for the thing."""
    doc = document("take/VB", "the/DT", f"{thing}/NN", "and/CC", "bring/VB", f"{pronoun}/PRP")
    value = f"the {thing}"
    tasks = (
        Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, 2),)),
        Task(2, "bringing", doc.span(4, 4), (argument(doc, "object", 5, 5, value),)),
    )
    return Observed(doc, GAZETTEER), Instruction(doc.text, tasks, Flow.from_json([1, 2]))


def test_a_trained_model_resolves_a_pronoun_and_leaves_names_alone(tmp_path):
    ontology = load_domain("household").ontology
    train_references(tmp_path / "r.json", [fetched(t, "it") for t in ("cup", "pen", "book", "plate")], ontology)
    observed, gold = fetched("vase", "it")
    said = [
        replace(t, arguments=tuple(replace(a, value=a.span.of(gold.text)) for a in t.arguments if a.span))
        for t in gold.tasks
    ]
    tasks = ReferenceModel(tmp_path / "r.json", ontology).resolve(observed, said, gold.flow)
    assert [task.values("object") for task in tasks] == [("the vase",), ("the vase",)]
    assert 0 < tasks[1].arguments[-1].confidence <= 1


def test_the_same_data_gives_the_same_file(tmp_path):
    ontology = load_domain("household").ontology
    for name in ("a", "b"):
        train_references(tmp_path / name, [fetched(t, "it") for t in ("cup", "pen", "book")], ontology)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    assert json.loads((tmp_path / "a").read_text(encoding="utf-8"))


def test_options_with_the_same_words_share_their_chances():
    options = [Option(None, "object", text, ()) for text in ("the cup", "the pen", "the pen")]
    chosen, probability = likeliest(options, [0.5, 0.0, 0.1])
    assert chosen == 2
    assert probability == pytest.approx((1 + math.exp(0.1)) / (1 + math.exp(0.1) + math.exp(0.5)))


def test_a_broken_file_is_named(tmp_path):
    (tmp_path / "r.json").write_text("[1]", encoding="utf-8")
    with pytest.raises(DataFileError, match=r"r\.json.*decomplex-bt train"):
        ReferenceModel(tmp_path / "r.json", load_domain("household").ontology)


def test_no_data_trains_a_model_that_leaves_words_as_they_are(tmp_path):
    ontology = load_domain("household").ontology
    train_references(tmp_path / "r.json", [], ontology)
    assert ReferenceModel(tmp_path / "r.json", ontology).resolve(fetched("cup", "it")[0], [], Flow()) == ()


def test_candidates_are_whole_short_possessor_and_outside():
    doc = document("bring/VB", "mrs/NN", "smith/NN", "'s/POS", "bag/NN", "by/IN", "the/DT", "door/NN")
    task = Task(1, "bringing", doc.span(0, 0), (argument(doc, "object", 1, 7),))
    texts = {c.text for c in candidates_of(Observed(doc, GAZETTEER), [task])}
    assert {"mrs smith 's bag by the door", "mrs smith 's bag", "mrs smith", "the door"} <= texts


def test_a_noun_chunk_ends_before_a_determiner_and_a_time():
    doc = document("the/DT", "red/JJ", "cup/NN", "the/DT", "pen/NN", "yesterday/NN")
    assert list(noun_chunks(doc)) == [range(0, 3), range(3, 5)]


def test_a_noun_chunk_begins_with_no_s_and_may_be_a_noun_that_the_tagger_missed():
    doc = document(
        "where/WRB", "'s/POS", "grandpa/NN", "wants/VBZ", "her/PRP$", "key/JJ", "on/IN", "his/PRP$", "own/JJ"
    )
    assert list(noun_chunks(doc)) == [range(2, 3), range(4, 6)]


@pytest.mark.parametrize(
    ("text", "chunks"),
    [
        ("Give Anna somebody else's coat.", ["Anna", "somebody else's coat"]),
        ("Take no one else's socks.", ["no one else's socks"]),
        ("Someone's socks are in our load.", ["Someone's socks", "our load"]),
        ("Somebody's left a pram on the landing.", ["a pram", "the landing"]),
        ("Check if somebody's home.", ["home"]),
        ("Bring me back milk.", ["milk"]),
    ],
)
def test_what_somebody_unnamed_has_is_a_chunk_of_its_own(text, chunks):
    parsed = Parser().parse(text)
    assert [parsed.span(chunk.start, chunk.stop - 1).of(text) for chunk in noun_chunks(parsed)] == chunks


def test_a_noun_chunk_begins_with_a_participle_that_tells_which():
    parsed = Parser().parse("Running shoes by the door need cleaning, dried beans go in the jar.")
    texts = [parsed.span(chunk.start, chunk.stop - 1).of(parsed.text) for chunk in noun_chunks(parsed)]
    assert texts == ["Running shoes", "the door", "cleaning", "dried beans", "the jar"]


@pytest.mark.parametrize(
    ("words", "kinds", "expected"),
    [
        (("the/DT", "green/JJ", "one/NN"), range(4, 7), "the green cup"),
        (("one/CD",), range(4, 5), "a red cup"),
        (("half/NN", "of/IN", "it/PRP"), range(4, 7), "half of the red cup"),
        (("mine/PRP",), range(4, 5), "my cup"),
        (("the/DT", "rest/NN"), range(4, 6), "the rest of the red cup"),
        (("a/DT", "piece/NN"), range(4, 6), "a piece of the red cup"),
        (("any/DT", "that/WDT", "leak/VBP"), range(4, 7), "any red cup that leak"),
        (("those/DT", "without/IN", "lids/NNS"), range(4, 7), "the red cups without lids"),
        (("the/DT", "spare/JJ"), range(4, 6), "the spare cup"),
        (("some/DT", "cold/JJ"), range(4, 6), "some cold cup"),
    ],
)
def test_words_that_refer_are_spelled_with_the_noun(words, kinds, expected):
    doc = document("take/VB", "the/DT", "red/JJ", "cup/NN", *words)
    task = Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, 3),))
    gap = gap_of(doc, task, argument(doc, "object", kinds.start, kinds.stop - 1))
    assert gap is not None
    cup = next(c for c in candidates_of(Observed(doc, GAZETTEER), [task]) if c.text == "the red cup")
    assert expected in {text for text, _ in spellings(doc, gap, cup)}


def test_some_of_several_known_things_are_some_of_them_or_some_like_them():
    doc = document("wash/VB", "the/DT", "cups/NNS", "if/IN", "any/DT", "are/VBP", "dirty/JJ")
    tasks = (
        Task(1, "change_state", doc.span(0, 0), (argument(doc, "object", 1, 2),)),
        Task(2, "check_state", doc.span(5, 5), (argument(doc, "object", 4, 4), argument(doc, "state", 6, 6))),
    )
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    cups = next(c for c in candidates_of(Observed(doc, GAZETTEER), tasks) if c.text == "the cups")
    assert {"any of the cups", "any cups", "the cups"} <= {text for text, _ in spellings(doc, gap, cups)}


@pytest.mark.parametrize(
    ("kind", "words", "is_open"),
    [
        ("state", ("it/PRP",), True),  # "if she spits it out"
        ("manner", ("with/IN", "it/PRP"), True),
        ("message", ("it/PRP",), True),
        ("message", ("that/IN", "it/PRP", "works/VBZ"), False),
        ("state", ("out/RP",), False),
        ("state", ("that/DT",), False),  # mostly a deed
    ],
)
def test_what_says_something_itself_refers_only_by_a_word_alone(kind, words, is_open):
    doc = document("does/VB", *words)
    task = Task(1, "check_state", doc.span(0, 0), (argument(doc, kind, 1, len(words)),))
    assert (gap_of(doc, task, task.arguments[0]) is not None) == is_open


def test_a_deed_is_taken_up_with_all_that_is_said_behind_its_verb():
    doc = document("if/IN", "he/PRP", "has/VBZ", "fed/VBN", "the/DT", "cat/NN", "and/CC", "been/VBN", "out/RB")
    tasks = (
        Task(1, "check_state", doc.span(3, 3), (argument(doc, "object", 1, 1), argument(doc, "state", 4, 5))),
        Task(2, "check_state", doc.span(7, 7)),
    )
    texts = {c.text for c in predicates_of(Observed(doc, GAZETTEER), tasks)}
    assert {"fed the cat", "been"} <= texts


def test_who_is_brought_something_may_be_left_unsaid_as_where_to():
    doc = document("hand/VB", "it/PRP", "over/RP")
    task = Task(1, "bringing", doc.span(0, 0), (argument(doc, "object", 1, 1),))
    gaps = unsaid_gaps(Observed(doc, GAZETTEER), task, load_domain("household").ontology)
    assert [gap.type for gap in gaps] == ["recipient", "goal"]


def test_relations_in_the_flow():
    doc = document(*(f"do{i}/VB" for i in range(6)))
    tasks = [Task(i + 1, "taking", doc.span(i, i)) for i in range(6)]
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([{"if": [1, 2], "then": [3], "else": [4, 5]}, 6]))
    assert context.relation(1, 3) == "condition.then.0"
    assert context.relation(1, 5) == "condition.else.0"
    assert context.relation(3, 4) == "exclusive"
    assert context.relation(4, 5) == "same"
    assert context.relation(1, 2) == "first"
    assert context.relation(3, 6) == "inner"


def test_a_goal_is_open_unless_the_verb_says_it_for_this_type():
    ontology = load_domain("household").ontology
    gazetteer = Gazetteer({}, {}, frozenset(), ending={"return": "motion", "discard": "placing"})
    for verb, open_types in (("return", ["goal"]), ("discard", [])):
        doc = document(f"{verb}/VB", "it/PRP")
        task = Task(1, "placing", doc.span(0, 0), (argument(doc, "object", 1, 1),))
        assert [gap.type for gap in unsaid_gaps(Observed(doc, gazetteer), task, ontology)] == open_types


def test_one_of_another_colour_and_another_are_not_the_thing_itself():
    doc = document("take/VB", "my/PRP$", "grey/JJ", "hoodie/NN", "and/CC", "bring/VB", "the/DT", "black/JJ", "one/NN")
    gazetteer = Gazetteer({}, {}, frozenset(), colours=frozenset(("grey", "black")))
    tasks = (
        Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, 3),)),
        Task(2, "bringing", doc.span(5, 5), (argument(doc, "object", 6, 8),)),
    )
    context = Context(Observed(doc, gazetteer), tasks, Flow.from_json([1, 2]))
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    texts = {option.text for option in options_of(context, gap)}
    assert "the black hoodie" in texts
    assert "my grey hoodie" not in texts


def test_that_one_is_the_thing_itself_and_a_name_keeps_its_s():
    doc = document("take/VB", "the/DT", "torch/NN", "and/CC", "bring/VB", "that/DT", "one/NN")
    task = Task(1, "bringing", doc.span(4, 4), (argument(doc, "object", 5, 6),))
    gap = gap_of(doc, task, task.arguments[0])
    torch = next(c for c in candidates_of(Observed(doc, GAZETTEER), (task,)) if c.text == "the torch")
    assert {text for text, _ in spellings(doc, gap, torch)} == {"the torch", "a torch", "one torch"}


def test_a_pronoun_that_is_joined_to_a_thing_is_filled_in_its_place(tmp_path):
    ontology = load_domain("household").ontology
    train_references(tmp_path / "r.json", [fetched(t, "it") for t in ("cup", "pen", "book", "plate")], ontology)
    doc = document("take/VB", "the/DT", "vase/NN", "and/CC", "bring/VB", "it/PRP", "and/CC", "the/DT", "mop/NN")
    tasks = (
        Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, 2),)),
        Task(2, "bringing", doc.span(4, 4), (argument(doc, "object", 5, 8),)),
    )
    model = ReferenceModel(tmp_path / "r.json", ontology)
    found = model.resolve(Observed(doc, GAZETTEER), tasks, Flow.from_json([1, 2]))
    assert found[1].values("object") == ("the vase and the mop",)


@pytest.mark.parametrize(
    ("said", "value", "expected"),
    [
        (("one", "of", "them"), "the vases", {"one of them": "one of the vases"}),
        (("one", "of", "them"), "one of the vases", {"one of them": "one of the vases"}),
        (("it",), "the vase", {}),
    ],
)
def test_what_words_for_a_part_say_goes_on_to_what_stands_for_them(said, value, expected):
    doc = document("take/VB", *(f"{word}/{'IN' if word == 'of' else 'PRP'}" for word in said))
    task = Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, len(said)),))
    gap = gap_of(doc, task, task.arguments[0])
    assert part_of(doc, task.arguments[0], gap, value) == expected


def test_a_glass_of_it_is_no_bottle():
    doc = document("take/VB", "the/DT", "cider/NN", "and/CC", "bring/VB", "a/DT", "glass/NN", "of/IN", "it/PRP")
    tasks = (
        Task(1, "taking", doc.span(0, 0), (argument(doc, "object", 1, 2),)),
        Task(2, "bringing", doc.span(4, 4), (argument(doc, "object", 5, 8),)),
    )
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([1, 2]))
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    assert {option.text for option in options_of(context, gap)} - {""} == {"a glass of the cider"}


def test_what_there_is_none_of_is_not_switched_off_but_may_be_looked_for():
    words = "if/IN there/EX is/VBZ no/DT steam/NN ,/, turn/VB it/PRP off/RP or/CC look/VB for/IN it/PRP".split()
    doc = document(*words)
    steam = Argument("object", "steam", doc.span(4, 4))
    tasks = (
        Task(1, "check_state", doc.span(2, 2), (steam,)),
        Task(2, "change_state", doc.span(6, 6), (argument(doc, "object", 7, 7), argument(doc, "state", 8, 8))),
        Task(3, "searching", doc.span(10, 10), (argument(doc, "object", 12, 12),)),
    )
    flow = Flow.from_json([{"if": 1, "else": [2, 3]}])
    context = Context(Observed(doc, GAZETTEER), tasks, flow)
    for task, expected in ((tasks[1], False), (tasks[2], True)):
        gap = gap_of(doc, task, task.arguments[0])
        assert ("steam" in {option.text for option in options_of(context, gap)}) == expected


def test_nothing_that_is_named_later_is_she_unless_a_person():
    doc = document(*"if/IN she/PRP wakes/VBZ ,/, bring/VB her/PRP the/DT cake/NN".split())
    tasks = (
        Task(1, "check_state", doc.span(2, 2), (argument(doc, "object", 1, 1),)),
        Task(2, "bringing", doc.span(4, 4), (argument(doc, "recipient", 5, 5), argument(doc, "object", 6, 7))),
    )
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([{"if": 1, "then": [2]}]))
    gap = gap_of(doc, tasks[0], tasks[0].arguments[0])
    assert {option.text for option in options_of(context, gap)} == {""}


def test_him_in_the_branch_of_who_it_is_is_that_person():
    doc = document(*"somebody/NN rings/VBZ ,/, if/IN it/PRP is/VBZ the/DT vicar/NN ,/, tell/VB him/PRP".split())
    tasks = (
        Task(1, "check_state", doc.span(5, 5), (argument(doc, "object", 4, 4), argument(doc, "state", 6, 7))),
        Task(2, "informing", doc.span(9, 9), (argument(doc, "recipient", 10, 10),)),
    )
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([{"if": 1, "then": [2]}]))
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    assert {option.text for option in options_of(context, gap)} - {""} == {"the vicar"}


def test_nobody_is_given_or_told_what_was_handled():
    doc = document(*"bring/VB her/PRP the/DT scarf/NN and/CC tell/VB her/PRP".split())
    tasks = (
        Task(1, "bringing", doc.span(0, 0), (argument(doc, "recipient", 1, 1), argument(doc, "object", 2, 3))),
        Task(2, "informing", doc.span(5, 5), (argument(doc, "recipient", 6, 6),)),
    )
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([1, 2]))
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    assert {option.text for option in options_of(context, gap)} == {""}


def test_what_there_is_none_of_is_brought_by_its_name():
    doc = document(*"no/DT paper/NN left/VBN ?/. bring/VB some/DT".split())
    tasks = (
        Task(1, "check_state", doc.span(2, 2), (argument(doc, "object", 0, 1),)),
        Task(2, "bringing", doc.span(4, 4), (argument(doc, "object", 5, 5),)),
    )
    context = Context(Observed(doc, GAZETTEER), tasks, Flow.from_json([{"if": 1, "else": [2]}]))
    gap = gap_of(doc, tasks[1], tasks[1].arguments[0])
    texts = {option.text for option in options_of(context, gap)}
    assert "some paper" in texts
    assert not any(text.startswith("no ") for text in texts)


def test_what_is_put_away_or_hung_up_says_where_itself():
    doc = document(*"hang/VB up/RP the/DT shirt/NN".split())
    (task,) = (Task(1, "placing", doc.span(0, 0), (argument(doc, "object", 2, 3),)),)
    ontology = load_domain("household").ontology
    assert [gap.type for gap in unsaid_gaps(Observed(doc, GAZETTEER), task, ontology)] == []
    laid = document(*"lay/VB down/RP the/DT shirt/NN".split())
    assert [gap.type for gap in unsaid_gaps(Observed(laid, GAZETTEER), task, ontology)] == ["goal"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("robot/NN", "take/VB", "it/PRP"), set()),
        (("hey/UH", "robot/NN", "take/VB", "it/PRP"), set()),
        (("the/DT", "robot/NN", "fell/VBD"), {"the robot"}),
        (("toy/NN", "robot/NN", "fell/VBD"), {"toy robot"}),
    ],
)
def test_the_robot_that_is_spoken_to_is_nobodys_referent(words: tuple[str, ...], expected: set[str]) -> None:
    found = {candidate.text for candidate in candidates_of(Observed(document(*words), GAZETTEER), ())}
    assert {text for text in found if "robot" in text} == expected


@pytest.mark.parametrize(
    ("noun", "is_plural", "wanted"),
    [
        ("lunchboxes/NNS", False, "lunchbox"),
        ("mugs/NNS", False, "mug"),
        ("battery/NN", True, "batteries"),
        ("key/NN", True, "keys"),
        ("glass/NN", True, "glasses"),
    ],
)
def test_a_noun_is_put_into_the_number_that_is_meant(noun: str, is_plural: bool, wanted: str) -> None:
    doc = document("take/VB", "the/DT", noun)
    candidate = Candidate(doc.text[5:], range(1, 3), 2)
    assert noun_of(doc, candidate, is_plural=is_plural) == wanted


@pytest.mark.parametrize(
    ("words", "is_certain"),
    [
        ("check/VB the/DT pot/NN ,/, if/IN be/VB dirty/JJ", True),
        ("check/VB the/DT pot/NN ,/, if/IN be/VB raining/VBG", False),
        ("check/VB the/DT pot/NN ,/, it/PRP be/VB dirty/JJ", False),
        ("check/VB the/DT pot/NN ,/, if/IN be/VB cold/JJ", False),  # outside
    ],
)
def test_a_check_without_a_subject_is_of_something(words: str, is_certain: bool) -> None:
    doc = document(*words.split())
    task = Task(2, "check_state", doc.span(5, 5), (Argument("state", doc.span(6, 6).of(doc.text), doc.span(6, 6)),))
    gaps = unsaid_gaps(Observed(doc, GAZETTEER), task, load_domain("household").ontology)
    assert [gap.is_certain for gap in gaps if gap.type == "object"] == [is_certain]


def test_nobody_is_no_thing_that_was_named_before():
    doc = document(*"if/IN the/DT tap/NN is/VBZ on/RP ,/, and/CC if/IN nobody/NN is/VBZ in/IN ,/, go/VB".split())
    first = Task(1, "check_state", doc.span(3, 3), (argument(doc, "object", 1, 2), argument(doc, "state", 4, 4)))
    second = Task(2, "check_state", doc.span(9, 9), (argument(doc, "location", 10, 10),))
    observed = Observed(doc, GAZETTEER)
    context = Context(observed, (first, second), Flow.from_json([1, 2]))
    gap = next(iter(unsaid_gaps(observed, second, load_domain("household").ontology)))
    assert (gap.type, {option.text for option in options_of(context, gap)}) == ("object", {""})


def test_what_there_is_has_no_state_that_another_thing_has():
    doc = document(*"if/IN it/PRP is/VBZ full/JJ ,/, and/CC if/IN there/EX is/VBZ a/DT letter/NN ,/, go/VB".split())
    first = Task(1, "check_state", doc.span(2, 2), (argument(doc, "object", 1, 1), argument(doc, "state", 3, 3)))
    second = Task(2, "check_state", doc.span(8, 8), (argument(doc, "object", 9, 10),))
    observed = Observed(doc, GAZETTEER)
    context = Context(observed, (first, second), Flow.from_json([1, 2]))
    (gap,) = unsaid_gaps(observed, second, load_domain("household").ontology)
    assert {option.text for option in options_of(context, gap)} == {""}


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Start the mower. If it doesn't start, clean the filter and start it again.", "the mower"),
        ("Unplug the toaster, empty the tray and plug it in again.", "the toaster"),
        ("Close the window. Open the oven, take out the tray and close it again.", "the oven"),
        ("Turn off the modem, check the cable and turn it back on.", "the modem"),
        ("Clean the filter and check it again.", "the filter"),
        ("The kitchen floor is dirty. Get the broom and sweep it.", "The kitchen floor"),
        ("If there is water on the floor, get the mop and mop it up.", "water"),
        ("Get the mop from the closet and clean it.", "the mop"),
        ("Get a cloth and wash it.", "a cloth"),
    ],
)
def test_what_was_done_before_is_done_again_and_what_cleans_is_not_cleaned(
    text: str, meant: str, encoder: bool
) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == meant


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Take the stew out of the fridge, and if the hob works, reheat it.", "the stew"),
        ("get the rolls from the freezer and if the oven is hot bake them", "the rolls"),
        ("Take the rice from the shelf and if the pot is clean, cook it.", "the rice"),
        ("Carry the tablet to the study, and if the charger is free, charge it.", "the tablet"),
        ("Take my shirt to the cellar, and if the dryer is empty, dry it.", "my shirt"),
        ("If the attic is empty and the fan is on, turn the fan off and air it.", "the attic"),
        ("fetch the telescope up from the cellar and if the lens cap is missing leave it in the hall", "the telescope"),
        ("Wash the pan, and if there is no soap left, put it on the list.", "soap"),
        ("Bring me the camera, and if the battery is empty, charge it.", "the battery"),
        ("Clear the table, and if the freezer is icy, defrost it.", "the freezer"),
        ("Wash the car, and if the shutter is open, shut it.", "the shutter"),
        ("Fetch the ladder, and if the key is missing, look for it.", "the key"),
        ("Rinse the jug, and if the cup is dirty, put it in the dishwasher.", "the cup"),
        ("Take the flask to the office, and if there's any coffee left, fill it.", "the flask"),
        ("Bring the basin up here and if there is water in the can fill it", "the basin"),
        ("If the flask is empty, fill it.", "the flask"),
    ],
)
def test_what_a_thing_is_done_with_or_what_is_missing_is_not_what_it_is_done_to(
    text: str, meant: str, encoder: bool
) -> None:
    assert Interpreter.load(encoder=encoder).interpret(text).tasks[-1].value("object") == meant


def test_what_a_check_asks_is_told_by_the_first_that_takes_it_up():
    words = "check/VB it/PRP ./. if/IN it/PRP is/VBZ hot/JJ ,/, go/VB ,/, if/IN it/PRP is/VBZ cold/JJ ,/, stop/VB"
    doc = document(*words.split())
    first = Task(1, "check_state", doc.span(0, 0), (argument(doc, "object", 1, 1),))
    second = Task(2, "check_state", doc.span(5, 5), (argument(doc, "state", 6, 6),))
    third = Task(3, "check_state", doc.span(12, 12), (argument(doc, "state", 13, 13),))
    last = Task(4, "motion", doc.span(15, 15))
    observed = Observed(doc, GAZETTEER)
    context = Context(observed, (first, second, third, last), Flow.from_json([{"if": [1, 2, 3], "then": [4]}]))
    (gap,) = unsaid_gaps(observed, first, load_domain("household").ontology)
    options = {option.text for option in options_of(context, gap)}
    assert "hot" in options
    assert "cold" not in options
