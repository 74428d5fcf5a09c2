"""What things need done: orders, unless what is said behind them tells what to do about it."""

from __future__ import annotations

import pytest

from decomplex_bt.domain.loader import load_domain
from decomplex_bt.understanding.document import Parser
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.gazetteer import Gazetteer
from decomplex_bt.understanding.interpreter import Interpreter
from decomplex_bt.understanding.rules.ellipses.likewise import so_does
from decomplex_bt.understanding.rules.orders.needs import belonging, in_need, needed


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser()


@pytest.fixture(scope="module")
def gazetteer() -> Gazetteer:
    domain = load_domain("household")
    return Gazetteer.of(domain.lexicon, domain.kinds)


def found(parser: Parser, gazetteer: Gazetteer, text: str) -> dict[str, str]:
    """The verbs of needs in a text with their task types."""
    observed = Observed(parser.parse(text), gazetteer)
    return {observed.document.tokens[i].text: kind for i, kind in needed(observed, {}).items()}


@pytest.mark.parametrize(
    ("text", "deeds"),
    [
        ("The ferns on the sill want watering.", {"watering": "change_state"}),
        ("Oh, and the puppy needs walking.", {"walking": "following"}),
        ("The recycling needs taking out; if it's raining, wear your hood.", {"taking": "taking"}),
        ("The shutters need to be closed before dark.", {"closed": "change_state"}),
        ("The mirrors could do with a wipe.", {"wipe": "change_state"}),
        ("The bath needs a scrub.", {"scrub": "change_state"}),
        ("My socks need washing.", {"washing": "change_state"}),
        ("If there's time left, the mirrors could do with a wipe.", {"wipe": "change_state"}),
        ("When it's dry again, the ferns want watering.", {"watering": "change_state"}),
        ("Right, it's time to rinse the sieve and dry it.", {"rinse": "change_state"}),
        (
            "The hall needs sweeping, and the rug could do with a good shake.",
            {"sweeping": "change_state", "shake": "change_state"},
        ),
    ],
)
def test_what_a_thing_needs_is_ordered(parser: Parser, gazetteer: Gazetteer, text: str, deeds: dict[str, str]) -> None:
    assert found(parser, gazetteer, text) == deeds


@pytest.mark.parametrize(
    "text",
    [
        "The kettle needs descaling, so fill it with vinegar.",  # which tells what to do about it
        "The stairs need vacuuming. Start with those at the top.",
        "The fish want feeding: two pinches of flakes.",
        "The van needs washing. Fetch the hose, then wash the van.",
        "The razor needs charging. Fetch the charger from the hall.",  # which is the reason
        "The patio needs sweeping. Get me the sweeper unless it rains.",
        "Does the lawn need mowing?",
        "If the lawn needs mowing, tell me.",
        "Tell Ben the lawn needs mowing.",
        "Bring me the needle, my coat needs mending.",
        "The ferns don't need watering.",
        "I need feeding.",
        "The stew could do with some pepper.",
        "The attic could do with a light.",
        "The gate needs a new hinge.",
        "The cupboard needs cleaning products.",
        "It's time to take my drops. Bring me the bottle.",
        "It's time to eat.",
    ],
)
def test_what_is_taken_up_or_said_of_a_case_is_no_order(parser: Parser, gazetteer: Gazetteer, text: str) -> None:
    assert found(parser, gazetteer, text) == {}


def test_what_needs_it_is_the_object(parser: Parser, gazetteer: Gazetteer) -> None:
    observed = Observed(parser.parse("The ferns on the sill want watering."), gazetteer)
    assert in_need(observed, 6) == {"object": range(0, 2), "location": range(2, 5)}
    assert in_need(observed, 3) == {}


def test_what_it_is_time_to_do_is_done_to_what_is_named_behind() -> None:
    read = Interpreter.load("household", encoder=False).interpret("It's time to feed the fish.")
    assert [(task.type, task.value("object")) for task in read.tasks] == [("change_state", "the fish")]


def test_a_need_is_read_as_a_task_with_what_needs_it() -> None:
    read = Interpreter.load("household", encoder=False).interpret("Grandma wants waking at seven.")
    assert (read.tasks[0].type, read.tasks[0].value("object")) == ("change_state", "Grandma")


@pytest.mark.parametrize(
    ("text", "carrier", "thing", "place"),
    [
        ("All the bowls belong on the shelf.", "belong", "All the bowls", "on the shelf"),
        ("Oh, and my coat belongs in the closet.", "belongs", "my coat", "in the closet"),
        ("The suitcase should go into the attic.", "go", "The suitcase", "into the attic"),
        ("The chairs ought to go back in the shed.", "go", "The chairs", "in the shed"),
    ],
)
def test_what_belongs_somewhere_is_put_there(parser: Parser, text: str, carrier: str, thing: str, place: str) -> None:
    document = parser.parse(text)
    (found,) = belonging(document)
    said = [" ".join(document.tokens[i].text for i in words) for words in (found.object, found.place)]
    assert (found.type, document.tokens[found.carrier].text, said) == ("placing", carrier, [thing, place])


@pytest.mark.parametrize(
    "text",
    [
        "The van belongs to Sid.",
        "The dog should go into the garden.",
        "My son has to go into town.",
        "Lea should go into the attic.",
        "The bowls belong on the shelf, so put them there.",
        "If the bowls belong on the shelf, put them there.",
        "Where do the bowls belong?",
        "The party should go well.",
    ],
)
def test_what_else_belongs_or_goes_is_not_put(parser: Parser, text: str) -> None:
    assert not list(belonging(parser.parse(text)))


@pytest.mark.parametrize(
    ("text", "carriers", "things"),
    [
        ("The fan needs cleaning, and so does the heater.", ["cleaning", "does"], ["The fan", "the heater"]),
        ("Sid's coat needs washing. So do his socks.", ["washing", "do"], ["Sid's coat", "his socks"]),
        ("Sid's coat needs washing, and his socks need washing.", ["washing", "washing"], ["Sid's coat", "his socks"]),
    ],
)
def test_so_does_another_thing(text: str, carriers: list[str], things: list[str]) -> None:
    found = Interpreter.load().interpret(text)
    assert [task.span.of(text) for task in found.tasks] == carriers
    assert [task.value("object") for task in found.tasks] == things


@pytest.mark.parametrize("text", ["The hall needs sweeping. So do the kitchen.", "I'm tired, so do the pots."])
def test_an_order_behind_so_says_no_need(parser: Parser, text: str) -> None:
    assert not list(so_does(parser.parse(text)))


@pytest.mark.parametrize(
    ("text", "deeds"),
    [
        ("If the yard's wet, it wants sweeping.", ["sweeping"]),
        ("If the jugs are full, they need emptying.", ["emptying"]),
        ("The yard needs sweeping if it's wet, and the gate wants oiling.", ["sweeping", "oiling"]),
        ("If the trunk is full, it needs emptying, and the shelf wants dusting.", ["emptying", "dusting"]),
    ],
)
def test_what_is_needed_in_a_case_or_by_another_thing_is_one_order_each(
    interpreter: Interpreter, text: str, deeds: list[str]
) -> None:
    tasks = interpreter.interpret(text).tasks
    assert [task.span.of(text) for task in tasks if task.type != "check_state"] == deeds
    assert sum(task.type == "check_state" for task in tasks) == 1


@pytest.mark.parametrize("text", ["If Lea is up, she wants feeding.", "If the ferns want watering, tell me."])
def test_what_somebody_needs_or_is_a_case_is_no_order(interpreter: Interpreter, text: str) -> None:
    tasks = interpreter.interpret(text).tasks
    assert not any(task.span.of(text) in ("feeding", "watering") for task in tasks)


@pytest.mark.parametrize(
    ("text", "orders"),
    [
        ("The blankets should be aired.", [("change_state", {"object": "The blankets"})]),
        ("The pillow covers must be boiled.", [("change_state", {"object": "The pillow covers"})]),
        (
            "The rake in the yard is to be taken to the shed.",
            [("bringing", {"object": "The rake", "goal": "to the shed"})],
        ),
        ("The letter should be left on the piano.", [("placing", {"object": "The letter", "goal": "on the piano"})]),
        ("Nana should be given her drops.", [("bringing", {"recipient": "Nana", "object": "her drops"})]),
        ("The hamster's to be fed at noon.", [("change_state", {"object": "The hamster"})]),
        ("The carpet should be given a brush.", [("change_state", {"object": "The carpet"})]),
        (
            "The twins should be told that lunch is on the table.",
            [("informing", {"recipient": "The twins", "message": "that lunch is on the table"})],
        ),
        (
            "The shutters should be closed and the fan should be on.",
            [("change_state", {"object": "The shutters"}), ("change_state", {"object": "the fan"})],
        ),
    ],
)
def test_what_should_be_done_to_a_thing_is_ordered(text: str, orders: list[tuple[str, dict[str, str]]]) -> None:
    found = Interpreter.load("household", encoder=False).interpret(text)
    assert [(task.type, {a.type: a.value for a in task.arguments}) for task in found.tasks] == orders


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("The crates need scrubbing and putting in the van.", "in the van"),
        ("The blankets should be stripped off and put in the washer.", "in the washer"),
        ("The bowls must be rinsed, dried and put back on the rack.", "on the rack"),
        ("The records want dusting and putting on the shelf.", "on the shelf"),
    ],
)
def test_a_further_deed_is_done_to_the_same_thing(text: str, goal: str) -> None:
    found = Interpreter.load("household", encoder=False).interpret(text)
    assert len({task.value("object") for task in found.tasks}) == 1 < len(found.tasks)
    assert (found.tasks[-1].type, found.tasks[-1].value("goal")) == ("placing", goal)


def test_a_deed_with_a_particle_is_joined(parser: Parser, gazetteer: Gazetteer) -> None:
    found_ones = found(parser, gazetteer, "The shears need oiling and hanging up.")
    assert found_ones == {"oiling": "change_state", "hanging": "placing"}


@pytest.mark.parametrize(
    "text",
    [
        "The shears should be put away by now.",  # a guess
        "The shears are to be found in the shed.",
        "The shears should be in the shed.",
        "Is the gate to be locked?",
        "The fan should be on.",
        "The crates should be stacked. Put them in the van.",
        "The mats need beating and vacuuming bags are in the hall.",
    ],
)
def test_what_is_expected_or_taken_up_is_no_order(parser: Parser, gazetteer: Gazetteer, text: str) -> None:
    assert set(found(parser, gazetteer, text)) <= {"beating"}
