"""The trained interpreter, end to end: valid whatever the text, the same everywhere, and honest about bad input."""

import json
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import DataFileError, InputError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument
from decomplex_bt.understanding.damage import ModelError
from decomplex_bt.understanding.interpreter import MAX_CHARACTERS, Interpreter, without_rivals
from decomplex_bt.understanding.manifest import check_encoder

PEN = "Bring me a pen if you can find one on the desk, otherwise look in the drawer."


def assert_valid(instruction, ontology):
    assert Flow.from_json(instruction.flow.to_json(), task_count=len(instruction.tasks)) == instruction.flow
    starts = [task.span.start for task in instruction.tasks]
    assert starts == sorted(set(starts))
    assert [task.id for task in instruction.tasks] == list(range(1, len(starts) + 1))
    for task in instruction.tasks:
        assert task.type in ontology.task_types
        assert 0 <= task.confidence <= 1
        for argument in task.arguments:
            assert argument.type in ontology.argument_types
            assert argument.value.strip()
            assert 0 <= argument.confidence <= 1 + 1e-9
            assert argument.span is None or argument.span.of(instruction.text).strip()


@pytest.mark.parametrize(
    ("text", "flow"),
    [
        ("Turn off the computer when nobody is in the study.", [{"if": 2, "else": [1]}]),
        ("Turn off the fan when no-one is in the bathroom.", [{"if": 2, "else": [1]}]),
        (
            "Look for my phone on the desk and bring it if you see it, or else look in the bin.",
            [{"if": [1, 3], "then": [2], "else": [4]}],
        ),
        ("Don't turn on the tv before you close the curtains.", [2, 1]),
        ("Don't open the window before the heater is off.", [2, 1]),
    ],
)
def test_what_english_settles_is_read_so(interpreter, text, flow):
    assert interpreter.interpret(text).flow.to_json() == flow


def test_a_sentence_becomes_tasks_arguments_and_flow(interpreter):
    instruction = interpreter.interpret(PEN)
    assert [(t.span.of(PEN), t.type) for t in instruction.tasks] == [
        ("Bring", "bringing"),
        ("find", "searching"),
        ("look", "searching"),
    ]
    assert instruction.flow.to_json() == [{"if": 2, "then": [1], "else": [3]}]
    assert instruction.task(2).value("object") == "a pen"
    assert instruction.task(3).value("object") == "a pen"
    assert instruction.task(3).value("location") == "in the drawer"


@pytest.mark.parametrize(
    "text",
    ["?!", "🤖🤖", "Ferme la fenêtre, s'il te plaît", "if", "if if if unless otherwise", "x" * MAX_CHARACTERS,
     "a\u0301 \u202e]([1:x", "Bring me\na cup\n\nand\tgo", "((((((", "bring bring bring it it",
     " leading and trailing "],
)  # fmt: skip
def test_any_text_gives_a_valid_instruction(interpreter, ontology, text):
    instruction = interpreter.interpret(text)
    assert instruction.text == text
    assert_valid(instruction, ontology)
    json.dumps(instruction.to_json())


def test_text_without_a_task_has_a_warning(interpreter):
    instruction = interpreter.interpret("The weather is lovely today.")
    assert instruction.tasks == ()
    assert instruction.to_json()["flow"] == []
    assert instruction.warnings


@pytest.mark.parametrize("text", ["", "  \n", "a" * (MAX_CHARACTERS + 1), "half \ud83d"])
def test_unusable_text_is_bad_input(interpreter, text):
    with pytest.raises(InputError):
        interpreter.interpret(text)


def test_a_batch_gives_what_one_by_one_gives(interpreter):
    texts = [PEN, "Close the window.", "If the oven is on, turn it off and tell Anna."]
    assert list(interpreter.interpret_batch(texts)) == [interpreter.interpret(text) for text in texts]


def test_a_batch_in_several_processes_gives_the_same_in_order(interpreter, monkeypatch):
    monkeypatch.setattr("decomplex_bt.understanding.interpreter.CHUNK", 2)
    texts = [f"If the oven is on, bring me {count} cups." for count in ("two", "three", "four", "five", "six")]
    assert list(interpreter.interpret_batch(texts, jobs=2)) == list(interpreter.interpret_batch(texts))


def test_several_processes_read_by_the_domain_that_the_interpreter_has():
    shipped = load_domain("household")
    placing = shipped.ontology.task_types["placing"]
    asking = placing.model_copy(update={"questions": {**placing.questions, "goal": "And where to?"}})
    types = {**shipped.ontology.task_types, "placing": asking}
    domain = replace(shipped, ontology=shipped.ontology.model_copy(update={"task_types": types}))
    interpreter = Interpreter.load(domain, encoder=False)
    (found,) = interpreter.interpret_batch(["Put the cup."], jobs=2)
    assert found.missing[0].question == "And where to?"
    assert found == interpreter.interpret("Put the cup.")


def test_an_unusable_text_of_a_batch_is_bad_input_in_several_processes_too(interpreter):
    with pytest.raises(InputError, match="empty"):
        list(interpreter.interpret_batch(["Close the door.", " "], jobs=2))


@pytest.mark.parametrize(
    "text",
    [
        "Water Nan's plants; if Tom's are dry, call me.",
        "If the old one is broken, call me.",
        "Check on the twins; if they've fallen asleep, close the door.",
        "Please make your bed and set the table.",
        "Change the towels.",
        "If the gate is unlocked, go inside.",
    ],
)
def test_what_is_told_is_not_asked_for(interpreter, text):
    assert interpreter.interpret(text).missing == ()


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("If it is broken, call me.", ["object"]),
        ("Bring me the red one.", ["object"]),
        ("Change it.", ["object"]),
        ("Set the radio.", ["state"]),
        ("Switch the lamp.", ["state"]),
    ],
)
def test_what_is_not_told_is_asked_for(interpreter, text, arguments):
    assert [m.argument for m in interpreter.interpret(text).missing] == arguments


def test_a_missing_argument_asks_its_question(interpreter):
    missing = interpreter.interpret("Put the cup.").missing
    assert [(m.task, m.argument, m.question) for m in missing] == [(1, "goal", "Where should I put it?")]


@pytest.mark.parametrize("text", ["If it's raining, close the window.", "Should it snow, close the window."])
def test_the_weather_lacks_nothing(interpreter, text):
    assert interpreter.interpret(text).missing == ()


@pytest.mark.parametrize(
    "text",
    [
        "If there is no coffee, bring me tea.",
        "Are there any batteries? If not, tell me.",
        "If one of the windows is open, close it.",
        "Bring me one of the mugs.",
        "The dog is probably in the garden. If he is, bring him in.",
    ],
)
def test_being_there_needs_no_state_one_of_several_no_name_and_what_is_so_was_said(interpreter, text):
    assert interpreter.interpret(text).missing == ()


def test_the_machine_is_named_where_it_stands_for_nothing(interpreter):
    assert interpreter.interpret("If the machine's free, wash my towel.").missing == ()
    assert [m.argument for m in interpreter.interpret("Bring it to me.").missing] == ["object"]


def test_what_is_put_is_not_where_it_is_put(interpreter):
    task = interpreter.interpret("Pick up the ball and drop it.").tasks[-1]
    assert task.value("object") == "the ball"
    assert task.value("goal") is None


@pytest.mark.parametrize(
    ("text", "recipient", "thing"),
    [
        ("Give the dog water.", "the dog", "water"),
        ("Bring the guests towels.", "the guests", "towels"),
        ("Bring the plumber coffee.", "the plumber", "coffee"),
        ("Bring the baby bottle.", None, "the baby bottle"),
        ("Give the dog bowl to Anna.", "to Anna", "the dog bowl"),
    ],
)
def test_who_gets_something_may_stand_before_it_without_an_article(interpreter, text, recipient, thing):
    (task,) = interpreter.interpret(text).tasks
    assert (task.value("recipient"), task.value("object")) == (recipient, thing)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Put the book.", "placing"),
        ("Put down the cup.", "placing"),
        ("Put the pen on the desk.", "placing"),
        ("Put the kettle on.", "change_state"),
        ("Put out the light.", "change_state"),
    ],
)
def test_to_put_something_is_to_place_it_unless_it_is_put_on_or_out(interpreter, text, kind):
    assert [task.type for task in interpreter.interpret(text).tasks] == [kind]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If the furnace filter is dirty, take it out and bring me a new one.", "a new furnace filter"),
        ("Put the blue bin by the gate and bring the green one to me.", "the green bin"),
        ("Close the kitchen window and open the bathroom one.", "the bathroom window"),
    ],
)
def test_another_one_is_named_by_the_noun_less_what_tells_it_apart(interpreter, text, value):
    assert interpreter.interpret(text).tasks[-1].values("object") == (value,)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("I don't want the red mug, give me the other one.", "the other mug"),
        ("Give me a book and then give Anna another one.", "another book"),
        ("Start the washing machine if the shirt is inside.", "the washing machine"),
        ("If the soup is inside, turn on the microwave.", "the microwave"),
        ("Open the desk drawer; if the charger is inside, close it.", "the desk drawer"),
        ("If the pan is in there, turn off the oven.", "the oven"),
        ("If Tom is inside, close the fridge.", "inside"),
    ],
)
def test_the_other_one_and_inside_are_settled_by_what_is_named(interpreter, text, value):
    assert value in [argument.value for task in interpreter.interpret(text).tasks for argument in task.arguments]


def test_a_task_keeps_two_arguments_of_a_type_only_where_both_are_likely(interpreter):
    sure, likely, doubtful = (Argument("object", text, None, c) for text, c in (("a", 0.9), ("b", 0.6), ("c", 0.4)))
    place = Argument("goal", "d", None, 0.2)
    assert without_rivals([doubtful, sure, place, likely]) == (sure, place, likely)
    assert len(without_rivals([doubtful, replace(doubtful, value="e")])) == 1


def test_the_same_text_is_understood_alike_under_any_hash_seed(printed_under_hash_seeds):
    program = (
        "import json; from decomplex_bt.understanding.interpreter import Interpreter;"
        f"print(json.dumps(Interpreter.load('household').interpret({PEN!r}).to_json()))"
    )
    assert len(printed_under_hash_seeds(program)) == 1


def test_damaged_models_are_refused_by_name(tmp_path):
    domain = load_domain("household")
    shutil.copytree(domain.folder / "models", tmp_path / "models")
    with (tmp_path / "models" / "tasks.crf").open("ab") as file:
        file.write(b"x")
    with pytest.raises(DataFileError, match=r"tasks\.crf: the model is not the one in the manifest"):
        Interpreter.load(domain, models=tmp_path / "models")
    with pytest.raises(DataFileError, match=f"run `decomplex-bt train --output {tmp_path} --force`"):
        Interpreter.load(domain, models=tmp_path)


def test_an_encoder_that_learnt_from_voices_unknown_to_the_models_beside_it_is_refused(tmp_path):
    shipped = load_domain("household").folder / "models"
    shutil.copytree(shipped, tmp_path / "models")
    path = tmp_path / "models" / "manifest.json"
    manifest = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(json.dumps(manifest | {"voices": ["mine"]}), encoding="utf-8")
    with pytest.raises(
        DataFileError, match=r"encoder/manifest\.json: .*not trained together.*train --output .*--encoder"
    ):
        Interpreter.load("household", models=tmp_path / "models", encoder=True)
    assert Interpreter.load("household", models=tmp_path / "models", encoder=False)
    check_encoder(shipped, shipped / "encoder")


@pytest.mark.parametrize(
    ("of_crfs", "of_encoder"), [(["ann", "bob"], ["ann"]), (["ann"], ["ann", "bob"]), (["ann", "bob"], ["bob", "ann"])]
)
def test_either_of_models_and_encoder_may_have_learnt_from_more_voices(of_crfs, of_encoder, tmp_path):
    shipped = load_domain("household").folder / "models"
    for folder, voices in ((tmp_path, of_crfs), (tmp_path / "encoder", of_encoder)):
        folder.mkdir(exist_ok=True)
        manifest = json.loads((shipped / folder.relative_to(tmp_path) / "manifest.json").read_text(encoding="utf-8"))
        (folder / "manifest.json").write_text(json.dumps(manifest | {"voices": voices}), encoding="utf-8")
    check_encoder(tmp_path, tmp_path / "encoder")


@pytest.mark.parametrize(
    ("path", "command"),
    [
        ("models/tasks.crf", "decomplex-bt train --domain {}"),
        ("models/encoder/heads.npz", "decomplex-bt train --domain {} --encoder"),
        ("other/tasks.crf", "decomplex-bt train --output {}/other --force"),
    ],
)
def test_the_advice_is_to_train_where_the_model_is(path, command, tmp_path):
    (tmp_path / "ontology.yaml").write_text("")
    assert f"gone; run `{command.format(tmp_path)}`" in str(ModelError(tmp_path / path, "gone"))
    shipped = load_domain("household").folder / "models" / "tasks.crf"
    assert "run `decomplex-bt train --domain household`" in str(ModelError(shipped, "gone"))


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"models": 3}, "models is 3; expected a folder of trained models"),
        ({"encoder": "x"}, "encoder is 'x'; expected True, False, or None"),
        ({"models": "nowhere"}, r"nowhere/manifest\.json: cannot be read"),
    ],
)
def test_what_no_interpreter_can_be_loaded_with_is_refused(options, says):
    with pytest.raises(InputError, match=says):
        Interpreter.load("household", **options)


def test_what_is_no_text_or_no_batch_is_refused_at_once(interpreter):
    with pytest.raises(InputError, match="the instruction is None; expected a text"):
        interpreter.interpret(None)
    with pytest.raises(InputError, match=r"texts is 'Close the door\.'; expected several texts"):
        interpreter.interpret_batch("Close the door.")
    with pytest.raises(InputError, match="texts is None; expected several texts"):
        interpreter.interpret_batch(None)
    with pytest.raises(InputError, match="jobs is 0; expected at least one process"):
        interpreter.interpret_batch(["Close the door."], jobs=0)
    with pytest.raises(InputError, match="the instruction is 3; expected a text"):
        list(interpreter.interpret_batch(["Close the door.", 3]))


@pytest.mark.parametrize(
    "text",
    [
        "Check if the garage door is closed. If it isn't, close it.",
        "If the kettle's empty and Mum's not home, don't fill it, wash the mugs.",
        "If there's no milk, I'll have water, so bring me that.",
    ],
)
@pytest.mark.parametrize(
    "typed",
    [lambda text: text.replace("'", "\u2019"), str.upper, lambda text: text.replace("n't", "nt")],
    ids=["curly", "capitals", "left out"],
)
@pytest.mark.parametrize("encoder", [False, None])
def test_neither_capitals_nor_the_apostrophe_change_what_is_meant(text, typed, encoder):
    found, plain = (Interpreter.load(encoder=encoder).interpret(each) for each in (typed(text), text))
    assert found.flow == plain.flow
    assert [task.type for task in found.tasks] == [task.type for task in plain.tasks]
    assert [task.span.of(found.text) for task in found.tasks] == [typed(t.span.of(plain.text)) for t in plain.tasks]
    assert all(a.span.of(found.text) in typed(text) for task in found.tasks for a in task.arguments if a.span)


def test_threads_may_share_an_interpreter():
    shared = Interpreter.load(encoder=False)
    texts = [
        PEN,
        "Go to the kitchen.",
        "If it's cold, close the window, otherwise open the door and feed the dog.",
    ] * 20
    alone = [shared.interpret(text) for text in texts]
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        with ThreadPoolExecutor(3) as threads:
            assert list(threads.map(shared.interpret, texts)) == alone
    finally:
        sys.setswitchinterval(before)
