"""An episode: the world, the robot's eyes and the judge, from the start that was drawn to the verdict."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot
from struct import Struct
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from decomplex_bt.envs.config import MAX_SPEED, MAX_TURN_RATE
from decomplex_bt.envs.hands import interact
from decomplex_bt.envs.interface import ROBOT_FIELDS, Interaction, Result
from decomplex_bt.envs.meddling import Meddler, Move
from decomplex_bt.envs.sensing import FIRST_STATE, PLACE, Sensor
from decomplex_bt.envs.spaces import encode, read_action, shown
from decomplex_bt.envs.walking import advance
from decomplex_bt.envs.world import World

if TYPE_CHECKING:
    from decomplex_bt.envs.chance import Start
    from decomplex_bt.envs.config import HouseholdConfig
    from decomplex_bt.envs.home import Home
    from decomplex_bt.envs.judge import Judge
    from decomplex_bt.envs.options import Options
    from decomplex_bt.envs.randomness import Generators
    from decomplex_bt.envs.recording import Recording
    from decomplex_bt.envs.verdict import Verdict

UNKNOWN_LENGTH = -1.0
"""What `shortest_length` is until there is one: a number that equals itself, or infos could not be compared."""
RESULT_NAMES = tuple(result.name.lower().replace("_", " ") for result in Result)
Observation = dict[str, Any]
_NONE, _FINISH, _OK = Interaction.NONE, Interaction.FINISH, Result.OK
_pack = Struct("6f").pack_into
_TOLD = ("seconds", "path_length", "shortest_length", "events", "moved_by_others", "result")
"""The keys of an info besides those of the judge and those that are constant."""


class Episode:
    """One episode of an environment. Making it takes the first look, `step` does one action.

    `world`, `sensor`, `judge` and `verdict` are of this moment, `start` is how the world began, `text` the instruction;
    `house` is the path or the seed of its house; `is_over` after the step that ended it, `is_out_of_time` where that
    was the time limit alone.
    """

    def __init__(
        self,
        home: Home,
        judge: Judge,
        start: Start,
        config: HouseholdConfig,
        recording: Recording,
        generators: Generators,
    ) -> None:
        self.domain, self.setting, self.house, self._rows = home.domain, home.setting, home.house, home.rows
        self.judge, self.start, self.recording = judge, start, recording
        self.text = text = recording.request.text
        options = recording.options
        self._config = config
        self._codes, self._shown_text = encode(text), shown(text)
        limits = (options.max_seconds, config.max_seconds, home.seconds)
        self._max_seconds = next(limit for limit in limits if limit is not None)
        self._is_progress_rewarded = (options.reward or config.reward) == "progress"
        self._result = Result.NONE
        self._path_length, self._shortest_length = 0.0, UNKNOWN_LENGTH
        setting = home.setting
        self.world = World(
            setting.geometry,
            setting.prior,
            setting.spots,
            start,
            config=config.world,
            noise=generators.noise,
            whims=(lambda: generators.whims.random()) if options.chance else _no_whim,
            stage=home.stage,
        )
        recording.begin(self.world, start)
        self.sensor = Sensor(self.world, config.sensing)
        self._add_noise(options)
        self.sensor.look()
        self._judged_arrangement = self.world.arrangement
        self._judged_deeds = self._stand()
        self.verdict: Verdict = judge.begin(self.world, self.sensor)
        self._meddler = self._make_meddler(options.meddling, generators)
        self._move: Move | None = None
        self._held_version = -1
        numbers = np.zeros(len(ROBOT_FIELDS) + 1, dtype=np.float32)
        self._numbers, self._pose, self._clock = numbers.data, numbers[:-1], numbers[-1:]
        self._is_table_full = len(self.sensor.table) == self._rows
        self._constant_info = {"instruction": text, **judge.feasibility()}
        self.is_over = self.is_out_of_time = False

    def _add_noise(self, options: Options) -> None:
        """How likely grasps slip and looks miss something: as the house has it, or as the options want it."""
        if not options.noise or not options.chance:
            self.world.grasp_slip = self.sensor.missed_detection = 0.0
        if options.grasp_slip is not None:
            self.world.grasp_slip = options.grasp_slip
        if options.missed_detection is not None:
            self.sensor.missed_detection = options.missed_detection

    def _make_meddler(self, rate: float, generators: Generators) -> Meddler | None:
        if rate == 0.0:
            return None
        return Meddler(
            self.world, generators.meddling, rate=rate, mentioned=self.judge.mentioned, allows=self.judge.allows
        )

    # -- a step -------------------------------------------------------------------------------------------------------

    def step(self, action: Mapping[str, Any]) -> tuple[float, bool, bool]:
        """Does one action: the reward, whether it is over, whether the time is. Raises `InputError` for no action."""
        world = self.world
        forward, turn, interaction, target = read_action(action, self._rows)
        if self._meddler is not None:
            self._move = self._meddle(self._meddler)
        if interaction is not _NONE and self._stand() != self._judged_deeds:
            self.judge.brace()
            self._judged_deeds = self._stand()
        self._result = interact(world, interaction, target)
        if world.walks:
            self._let_walk()
        x, y = world.robot
        world.drive(forward, turn)
        x_now, y_now = world.robot
        self._path_length += hypot(x_now - x, y_now - y)
        has_looked = self.sensor.look()
        is_finished = interaction is _FINISH
        is_late = world.seconds >= self._max_seconds - 1e-9
        before = self.verdict
        event = world.event
        is_deed = event is not None and event.result is _OK
        is_news = has_looked or is_deed or world.arrangement != self._judged_arrangement
        if is_news or is_finished or is_late or self.judge.minds_position:
            self._judged_arrangement = world.arrangement
            self.verdict = self.judge.update(event)
        if is_deed:
            self._judged_deeds = self._stand()
        if is_finished:
            self.verdict = self.judge.finish()
        self.recording.note(forward, turn, interaction, target)
        terminated = is_finished or self.verdict.is_over
        if terminated and self.verdict.is_success:
            self._shortest_length = self._measure_shortest_path()
        self.is_over = terminated or is_late
        self.is_out_of_time = is_late and not terminated
        return self._reward(before, terminated), terminated, self.is_out_of_time

    def _meddle(self, meddler: Meddler) -> Move | None:
        """Lets somebody else move a thing, if it is time to, and tells the judge."""
        move = meddler.act()
        if move is not None:
            self.judge.take_in(move.thing)
        return move

    def _let_walk(self) -> None:
        """Lets the people who walk go on, and tells the judge of what they do and the robot did not."""
        event = self.world.event
        if event is not None and event.result is _OK:
            self.judge.note_deed()
        for door in advance(self.world):
            self.judge.take_in(door)

    def _stand(self) -> tuple[int, int]:
        """What is another value when anything was changed or brought into another room."""
        return self.world.version, self.world.arrangement

    def _reward(self, before: Verdict, terminated: bool) -> float:
        now = self.verdict
        if self._is_progress_rewarded and now.total:
            return (now.met - before.met) / now.total
        return float(now.is_success and terminated)

    def _measure_shortest_path(self) -> float:
        from decomplex_bt.envs.shortest import ShortestPath

        world, sensing = self._config.world, self._config.sensing
        path = ShortestPath(
            self.domain,
            self.setting.geometry,
            self.start,
            reach=world.reach,
            earshot=world.speak_reach,
            sight=(sensing.range, sensing.inside_range),
        )
        length = path.length(*self.judge.carried_out())
        # What was driven is a way to do it: the shortest is no longer than that.
        return UNKNOWN_LENGTH if length is None else min(length, self._path_length)

    # -- what is told of it -------------------------------------------------------------------------------------------

    def observe(self) -> Observation:
        """What the robot sees of this moment, as `HouseholdEnv` describes it; fresh arrays."""
        world = self.world
        x, y = world.robot
        speed, turn_rate = world.speed, world.turn_rate
        if not (-MAX_SPEED <= speed <= MAX_SPEED and -MAX_TURN_RATE <= turn_rate <= MAX_TURN_RATE):
            speed, turn_rate = _clip(speed, MAX_SPEED), _clip(turn_rate, MAX_TURN_RATE)
        _pack(self._numbers, 0, x, y, world.robot_heading, speed, turn_rate, world.seconds)
        if world.version != self._held_version:
            self._held_version = world.version
            self._held = np.array((world.held, *world.tray), dtype=np.int16)
        return {
            "instruction": self._shown_text,
            "instruction_codes": self._codes.copy(),
            "robot": self._pose.copy(),
            "held": self._held.copy(),
            "entities": self.sensor.table.copy() if self._is_table_full else self._table(),
            "result": int(self._result),
            "seconds": self._clock.copy(),
        }

    def _table(self) -> NDArray[np.float32]:
        """The entity table of a house with fewer rows than the space has: those over are as of what is not seen."""
        table = self.sensor.table
        full = np.zeros((self._rows, table.shape[1]), dtype=np.float32)
        full[:, PLACE] = full[:, FIRST_STATE:] = -1
        full[: len(table)] = table
        return full

    def inform(self) -> dict[str, Any]:
        """The info of this moment, as `HouseholdEnv` describes it; a fresh mapping."""
        world = self.world
        info = self.judge.report(self._constant_info, _TOLD)
        info["seconds"] = world.seconds
        info["path_length"] = self._path_length
        info["shortest_length"] = self._shortest_length
        move, event = self._move, world.event
        info["events"] = events = [] if move is None else [str(move)]
        if event is not None:
            events.append(str(event))
        info["moved_by_others"] = 0 if self._meddler is None else self._meddler.moves
        info["result"] = RESULT_NAMES[self._result]
        return info

    def captions(self) -> dict[str, str]:
        """What a picture says besides the instruction: the verdict, or the task that is due."""
        verdict = self.verdict
        if verdict.is_success or verdict.unsettled is None:
            return {"verdict": "success"} if verdict.is_success else {}
        return {"due": f"due: {self.judge.reading.phrase(verdict.unsettled)}"}


def _no_whim() -> float:
    """Where people go who may go wherever they like, if nothing is left to chance: always to the first room."""
    return 0.0


def _clip(value: float, most: float) -> float:
    return min(max(value, -most), most)
