"""What a clause right ahead of an order offers, and what is filled as there is nothing in it."""

from __future__ import annotations

import pytest

from decomplex_bt.understanding.interpreter import Interpreter


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "value"),
    [
        ("If it's windy bring me the cap, otherwise the scarf is fine, just lay it on the stool.", "lay", "the scarf"),
        ("If the silver tray is scratched, bring it to me; otherwise the wooden tray will do, put it on the bar.",
         "put", "the wooden tray"),
        ("If the jam is gone, call me, otherwise the figs are okay, so put them on the table.", "put", "the figs"),
        # nothing is offered
        ("If the scarf is fine, lay it on the stool.", "lay", "the scarf"),
        ("Iron the scarf, my sister is fine with that, and fold it.", "fold", "the scarf"),
    ],
)  # fmt: skip
def test_what_will_do_is_what_the_order_behind_is_about(text: str, verb: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == verb] == [value]


@pytest.mark.parametrize("encoder", [False, True])
@pytest.mark.parametrize(
    ("text", "verb", "value"),
    [
        ("See if there is any ink in the printer; if not, refill it.", "refill", "the printer"),
        ("If there's no sand in the bucket, fill it up.", "fill", "the bucket"),
        ("See if there's any juice in the jug on the shelf; if not, fill it.", "fill", "the jug"),
        ("check if theres any seed left in the budgies bowl, if not fill it up", "fill", "the budgies bowl"),
        # a thing, no stuff
        ("If there is a bucket in the shed, fill it.", "fill", "a bucket"),
        ("If there is no salt in the larder, put it on the list.", "put", "salt"),
    ],
)
def test_what_is_empty_is_filled(text: str, verb: str, value: str, encoder: bool) -> None:
    found = Interpreter.load(encoder=encoder).interpret(text)
    assert [task.value("object") for task in found.tasks if task.span.of(text) == verb] == [value]


@pytest.mark.parametrize(
    ("text", "whom", "what"),
    [
        ("The pony looks thirsty. Fill the bucket and give it a drink.", "The pony", "a drink"),
        ("Fill the jug and give the fern a drink.", "the fern", "a drink"),
    ],
)
def test_what_is_filled_is_not_who_drinks(interpreter: Interpreter, text: str, whom: str, what: str) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.value("recipient"), task.value("object")) == (whom, what)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("If the safe is locked, get the code from Ann and open it.", "the safe"),
        ("If the shed's locked, fetch the key from the hook, open it and bring me the rake.", "the shed"),
        # what is got to be opened, or by itself
        ("If the shop is shut, get the tin from the shelf and open it.", "the tin"),
        ("Get the parcel from the hall and open it.", "the parcel"),
    ],
)
def test_what_is_locked_is_opened_and_no_key(interpreter: Interpreter, text: str, value: str) -> None:
    opened = [task for task in interpreter.interpret(text).tasks if task.span.of(text) == "open"]
    assert [task.value("object") for task in opened] == [value]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Get the tin from the shelf, open it and look inside.", "the tin"),
        ("If the top drawer is full, use the bottom one.", "the bottom drawer"),
    ],
)
def test_what_is_opened_or_used_instead_is_the_place(interpreter: Interpreter, text: str, value: str) -> None:
    task = interpreter.interpret(text).tasks[-1]
    assert (task.value("location") or task.value("goal"), task.value("object")) in ((value, None), (value, "the tin"))
