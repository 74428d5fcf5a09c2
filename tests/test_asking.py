"""What is in doubt or missing: what `parse --alternatives` tells, the question of `tree` and of the agent, `settle`."""

from __future__ import annotations

import io
import json
import sys
from dataclasses import replace

import gymnasium as gym
import pytest

import decomplex_bt
from decomplex_bt.cli import main
from decomplex_bt.corpus import read_markup
from decomplex_bt.domain.loader import load_domain
from decomplex_bt.errors import InputError, MissingArgumentError, UnknownWordError
from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Alternative, Doubt, Missing
from decomplex_bt.understanding.interpreter import Interpreter

MARKED = (
    "If [the tv](1:object) [is](1:check_state) [on](1:state), [turn](2:change_state) [it](2:object=the tv) "
    "[off](2:state) and [open](3:change_state) [the fridge](3:object)."
)
ALWAYS, DEPENDS = [{"if": 1, "then": [2]}, 3], [{"if": 1, "then": [2, 3]}]
QUESTION = "Should I open the fridge in any case, or only if the tv is on?"


def _read(markup, flow):
    return read_markup(markup, load_domain("household").ontology, flow=flow)


class Unsure:
    """Understands one sentence, in two ways."""

    def __init__(self):
        self.domain = load_domain("household")
        tasks = _read(MARKED, ALWAYS)
        other = (Alternative(Flow.from_json(DEPENDS), 0.25),)
        self.instruction = replace(tasks, confidence=0.5, alternatives=other)

    def interpret(self, text):
        return replace(self.instruction, text=text)

    def interpret_batch(self, texts, *, jobs=1):
        return map(self.interpret, texts)


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture(autouse=True)
def text(monkeypatch):
    unsure = Unsure()
    monkeypatch.setattr(Interpreter, "load", lambda *args, **options: unsure)
    return unsure.instruction.text


def test_parse_tells_other_flows_only_where_asked_to(text, tmp_path, capsys):
    file = tmp_path / "lines.txt"
    file.write_text(text + "\n", encoding="utf-8")

    def parse(*options):
        assert main(["parse", str(file), *options]) == 0
        return capsys.readouterr().out

    plain, told, none = (
        json.loads(parse("--json", *options)) for options in ((), ("--alternatives", "3"), ("--alternatives", "0"))
    )
    assert list(plain) == ["text", "tasks", "flow", "missing", "warnings"]
    assert list(told) == [*plain, "confidence", "alternatives"]
    assert told["confidence"] == 0.5
    assert told["alternatives"] == [{"flow": DEPENDS, "probability": 0.25}]
    assert none["alternatives"] == []
    for task in told["tasks"]:
        assert task.pop("dependency_confidence") == 1.0
    assert {key: told[key] for key in plain} == plain
    shown = parse("--format", "text", "--alternatives", "1")
    assert "confidence: 50%" in shown
    assert "or, with 25%:" in shown
    assert "or, with" not in parse("--format", "text")


@pytest.mark.parametrize(
    ("typed", "options", "flow", "asked"),
    [
        ("2\n", (), DEPENDS, 1),
        ("nonsense\nonly if it is on\n", (), DEPENDS, 2),
        ("in any case\n", (), ALWAYS, 1),
        ("\n", (), ALWAYS, 1),
        ("", (), ALWAYS, 1),
        ("2\n", ("--threshold", "0"), ALWAYS, 0),
        ("2\n", ("--threshold", "0.5"), ALWAYS, 0),
        ("2\n", ("--json",), ALWAYS, 0),
    ],
)
def test_on_a_terminal_the_answer_decides(text, typed, options, flow, asked, monkeypatch, capsys):
    def tree(*more):
        assert main(["tree", text, *more]) == 0
        return capsys.readouterr()

    monkeypatch.setattr(sys, "stdin", Terminal(typed))
    out, err = tree(*options)
    assert err.count(QUESTION) == asked
    depth = "  " if flow == ALWAYS else "      "
    assert "--json" in options or out.endswith(f"\n{depth}· make the fridge open\n"), out


@pytest.mark.parametrize(
    ("instruction", "ask", "says"),
    [
        ("Put the cup.", None, "ask is None; expected a function"),
        (3, lambda question: "on the bed", "instruction is a int; expected a text or an Instruction"),
    ],
)
def test_what_cannot_be_settled_is_refused_in_a_line(instruction, ask, says):
    with pytest.raises(InputError, match=says):
        decomplex_bt.settle(instruction, ask)


def test_without_a_terminal_nobody_is_asked(text, monkeypatch, capsys):
    monkeypatch.setattr(sys, "stdin", io.StringIO("2\n"))
    assert main(["plan", text, "--threshold", "1"]) == 0
    assert QUESTION not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("answer", "options", "flow"),
    [("only if the tv is on", {}, DEPENDS), (None, {}, ALWAYS), ("2", {"threshold": 0.0}, ALWAYS)],
)
def test_an_agent_asks_whoever_it_was_given(text, answer, options, flow):
    asked: list[Missing | Doubt] = []

    def ask(question: Missing | Doubt) -> str | None:
        asked.append(question)
        return answer

    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    observation, _ = env.reset(seed=0)
    agent = decomplex_bt.TreeAgent(env, ask=ask, **options)
    agent.reset(observation, {"instruction": text})
    assert agent.instruction.flow.to_json() == agent.grounded.flow.to_json() == flow
    assert [question.question for question in asked] == ([] if options else [QUESTION])
    silent = decomplex_bt.TreeAgent(env, threshold=1.0)
    silent.reset(observation, {"instruction": text})
    assert silent.instruction.flow.to_json() == ALWAYS


def test_a_doubt_is_settled_by_a_choice_itself_and_by_nothing_that_is_none(text):
    assert decomplex_bt.settle(text, lambda doubt: doubt.choices[1]).flow.to_json() == DEPENDS
    for nonsense in ("nonsense", "the second", 3, True, 1.0):
        with pytest.raises(InputError, match=rf"is {nonsense!r}; expected"):
            decomplex_bt.settle(text, lambda doubt, answer=nonsense: answer)


@pytest.mark.parametrize(("answer", "flow"), [("2", DEPENDS), (2, DEPENDS), ("1", ALWAYS), (None, ALWAYS)])
def test_robot_and_judge_go_by_one_settled_flow(text, answer, flow):
    instruction = decomplex_bt.settle(text, lambda question: answer)
    assert instruction.flow.to_json() == flow
    info = _carried_out(instruction, {"states": {"tv": "off", "fridge": "closed"}})
    assert info["is_success"]
    assert info["goal_conditions_total"] == (1 if flow == DEPENDS else 2)


def _carried_out(instruction, options):
    """The last info of the agent's loop, with one instruction for the judge and the robot."""
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    observation, info = env.reset(seed=1, instruction=instruction, options={"noise": False, **options})
    agent = decomplex_bt.TreeAgent(env, flow=instruction)
    agent.reset(observation, info)
    terminated = truncated = False
    while not (terminated or truncated or agent.done):
        observation, _, terminated, truncated, info = env.step(agent.act(observation))
    return info


def test_what_is_missing_is_asked_for_before_the_judge_needs_it():
    put = _read("[Put](1:placing) [the pen](1:object) [down](1:direction).", [1])
    with pytest.raises(MissingArgumentError, match=r"decomplex_bt\.settle\(text, ask\)"):
        gym.make("decomplex_bt/Household-v0", disable_env_checker=True).reset(seed=1, instruction=put)
    asked = []
    instruction = decomplex_bt.settle(put, lambda question: asked.append(question.question) or "on the bed")
    assert asked == ["Where should I put it?"]
    assert instruction.tasks[0].value("goal") == "on the bed"
    assert decomplex_bt.settle(instruction, lambda question: pytest.fail(question.question)) == instruction
    env = gym.make("decomplex_bt/Household-v0", disable_env_checker=True)
    observation, _ = env.reset(seed=1, instruction=instruction)
    with pytest.raises(MissingArgumentError, match="to `TreeAgent` as the flow"):
        decomplex_bt.TreeAgent(env, flow=put).reset(observation, {})
    assert _carried_out(instruction, {"placement": {"pen_1": "desk"}})["is_success"]
    for nothing in (None, ""):
        with pytest.raises(MissingArgumentError):
            decomplex_bt.settle(put, lambda question, answer=nothing: answer)
    with pytest.raises(UnknownWordError, match="the moon"):
        decomplex_bt.settle(put, lambda question: "on the moon")


def test_an_answer_belongs_to_the_task_that_was_asked_about():
    markup = (
        "[Put](1:placing) [the apple](1:object) [in the fridge](1:goal) and [the mug](1:object) [on the desk](1:goal), "
        "and [put](2:placing) [the book](2:object) [down](2:direction)."
    )
    instruction = decomplex_bt.settle(_read(markup, [1, 2]), lambda question: "on the bed")
    assert [task.value("goal") for task in instruction.tasks] == ["in the fridge", "on the bed", "on the desk"]
