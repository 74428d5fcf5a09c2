"""The household environment: a robot that is told in one sentence what to do, behind the Gymnasium API."""

from __future__ import annotations

import weakref
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import hypot
from pathlib import Path
from typing import TYPE_CHECKING, Any

import gymnasium as gym
import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from decomplex_bt.domain.loader import Domain, load_domain
from decomplex_bt.envs.hands import interact
from decomplex_bt.envs.interface import Interaction, Result
from decomplex_bt.envs.judge import Judge
from decomplex_bt.envs.meddling import Meddler, Move
from decomplex_bt.envs.opening import can_be_asked, draw_asked, draw_start, judge_for
from decomplex_bt.envs.options import (
    Options,
    Request,
    check_keys,
    read_house,
    read_options,
    read_request,
)
from decomplex_bt.envs.recording import Recording
from decomplex_bt.envs.residence import Residence
from decomplex_bt.envs.sensing import FIRST_STATE, PLACE, SensingConfig, Sensor
from decomplex_bt.envs.setting import Setting, setting_of
from decomplex_bt.envs.spaces import (
    MAX_SPEED,
    MAX_TURN_RATE,
    action_space,
    encode,
    observation_space,
    read_action,
    shown,
)
from decomplex_bt.envs.stage import Stage
from decomplex_bt.envs.walking import advance
from decomplex_bt.envs.world import World, WorldConfig
from decomplex_bt.envs.world_truth import WorldTruth
from decomplex_bt.errors import InputError

if TYPE_CHECKING:
    from decomplex_bt.envs.baselines import Policy
    from decomplex_bt.envs.embodiment import HouseholdEmbodiment
    from decomplex_bt.envs.rendering.camera import Camera
    from decomplex_bt.envs.rendering.scene import Scene
    from decomplex_bt.envs.verdict import Verdict

HOUSE_TRIES = 50
"""Houses drawn before none is found in which the instruction can be asked for."""
UNKNOWN_LENGTH = -1.0
"""What `shortest_length` is until there is one: a number that equals itself, or infos could not be compared."""
RESULT_NAMES = tuple(result.name.lower().replace("_", " ") for result in Result)
Action = Mapping[str, Any]
Observation = dict[str, Any]


@dataclass(frozen=True, slots=True)
class HouseholdConfig:
    """How an environment is set up. `max_seconds` of simulated time, `balance` in [0, 0.5], `reward` "success" or
    "progress"; what the robot can do, and how it sees."""

    max_seconds: float = 600.0
    balance: float = 0.3
    reward: str = "success"
    world: WorldConfig = field(default_factory=WorldConfig)
    sensing: SensingConfig = field(default_factory=SensingConfig)


class HouseholdEnv(gym.Env[Observation, Action]):
    """A mobile robot in a house of rooms, furniture, things and people, with one sentence that says what it is to do.

    ## Description
    A round robot (radius 0.22 m) with a differential drive, a gripper for one thing and a tray for four moves in a
    house of about 12 x 9 m, seen from above. It sees what is in its range and line of sight, not what lies in a closed
    container. Physics run at 100 Hz, an action lasts 0.1 s. SI units; origin bottom left, headings in radians,
    counter-clockwise from +x. Where things lie, which state they are in, what is broken, who is at home: all of it is
    drawn anew by every `reset` and mixed towards the instruction, so that each outcome of what it tests comes up.

    ## Action space
    `Dict`:

    | key | space | meaning |
    |---|---|---|
    | `drive` | `Box(-1, 1, (2,))` | forward and turning speed, as shares of 1 m/s and 2.5 rad/s (positive: left) |
    | `interact` | `Discrete(13)` | `interface.Interaction`: none, pick, place, open, close, ... |
    | `target` | `Discrete(rows)` | the row it is about (which, `interface.OBSERVATION_KEYS` says) |

    An interaction takes effect at once, before the drive; an impossible one changes nothing, and its reason is in the
    next observation. The gripper reaches 0.8 m; speaking and handing over need 1.5 m.

    To be led somewhere, the robot says so near a person: `say` with a place as target asks them to lead the way there
    (a room's floor stands for the room), with "robot" as target wherever they like. They wait while the robot is
    over 3 m behind, and open the doors on their way.

    ## Observation space
    `Dict`:

    | key | space | meaning |
    |---|---|---|
    | `instruction` | `Text(2000)` | the instruction in printable ASCII and Latin-1, other characters as "?" |
    | `instruction_codes` | `Box(0, 255, (2000,), uint8)` | its code points, 0 after its end |
    | `robot` | `Box((5,))` | x, y (m), heading (rad), forward speed (m/s), turn rate (rad/s) |
    | `held` | `Box(-1, rows - 1, (5,), int16)` | rows of what is in the gripper and the tray's slots, -1 where free |
    | `entities` | `Box((rows, 11))` | the entity table, one row for each place, thing, person and the robot |
    | `result` | `Discrete(12)` | what came of the last interaction (`interface.Result`) |
    | `seconds` | `Box((1,))` | simulated time |

    Columns of the entity table (`interface.COLUMNS`): visible, x, y, heading, place, inspected, power, aperture,
    temperature, cleanliness, fill. What is not seen is masked: coordinates 0 (places and the user keep theirs),
    place and states -1. Row `r` is `env.unwrapped.entities[r]`. The robot looks every fourth step, and in any step
    in which something was changed; between looks the table stays. A floor counts as inspected when
    each part of it was in view within the last 15 s; things seen on it in that time are then reported where they were.

    ## Rewards
    1.0 with success, else 0. `reward="progress"`: the change in the share of goal conditions met.

    ## Termination and truncation
    `terminated`: everything due is done (success), a task was done that was not due (violation), or the robot said
    `finish`. `truncated`: the time limit, 600 s of simulated time by default.

    ## Houses
    The default is the domain's house. `house=` (the path of a house file) makes an environment for another one;
    `size="small"`, `"medium"` or `"large"` one for generated houses of 2 to 4, 6 to 10 or 20 to 40 rooms (the ids
    HouseholdSmall-v0, HouseholdMedium-v0 and HouseholdLarge-v0): `house_seed=` fixes which, without it each reset draws
    one. Their entity tables have as many rows as the largest house needs; rows that stand for nothing are masked, and
    `entities` is of the house of the episode.

    ## Reset options
    `house_seed` (stays until another is given) and `house` (a file, for this episode), as long as it fits the spaces,
    `instruction` (a text, an annotated `Instruction` or a corpus `Example`; stays until replaced), `gold` (the reading
    the judge goes by, for a text), `balance`, `placement`, `states`, `broken`, `people`, `noise`, `grasp_slip`,
    `missed_detection`, `meddling`, `chance`, `max_seconds`, `reward`: see `options.Options`. Unknown keys are refused. Without an instruction each reset draws
    one from the corpus. A text without a gold reading is understood by the interpreter, which is loaded then.

    ## Info keys
    | key | meaning |
    |---|---|
    | `instruction` | the exact text |
    | `is_success` | everything due was done; as of this step, at most one step late |
    | `goal_conditions_met`, `goal_conditions_total` | tasks and conditions settled, and all that are due |
    | `branches` | of each condition reached: `task`, `truth` (None: undecided), `taken` ("then", "else", None) |
    | `violations` | what was brought about that was not due, in words; one ends the episode |
    | `unsettled` | the number of the task due now, 0 when nothing is left |
    | `feasible`, `infeasible_cause` | whether one who knows the world could succeed; if not, why (else None) |
    | `path_length` | metres driven |
    | `shortest_length` | with success the shortest path there was (`shortest`), in metres; -1 before and without |
    | `seconds` | simulated time |
    | `result`, `events` | what came of the last interaction; what happened in this step, in words |
    | `moved_by_others` | how many things somebody else has moved so far (`meddling`) |
    | `judged_by` | "gold" or "interpreted": whose reading the judge goes by |
    | `exempt` | after reset only: what the balance could not mix |

    They are for people and judges; an agent may use `instruction` alone.

    ## Version history
    v0: first version.
    """

    metadata: dict[str, Any] = {"render_modes": ["human", "rgb_array", "ansi"], "render_fps": 10}

    def __init__(
        self,
        instruction: Any = None,
        *,
        gold: Any = None,
        domain: str | Path | Domain = "household",
        house: str | Path | None = None,
        size: str | None = None,
        house_seed: int | None = None,
        config: HouseholdConfig | None = None,
        render_mode: str | None = None,
    ) -> None:
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            modes = ", ".join(self.metadata["render_modes"])
            raise InputError(f"render_mode is {render_mode!r}; expected one of {modes}")
        self._arguments = {"domain": domain, "house": house, "size": size, "config": config, "render_mode": render_mode}
        self._base = domain if isinstance(domain, Domain) else load_domain(domain)
        self.config = config or HouseholdConfig()
        self.render_mode = render_mode
        self._bodies: list[weakref.ref[HouseholdEmbodiment]] = []
        self._camera: Camera | None = None
        self._judge: Judge | None = None
        path, self._house_seed = read_house({"house": house, "house_seed": house_seed})
        self.domain: Domain
        self.setting: Setting
        self.entities: tuple[str, ...]
        self._residence = Residence(self._base, path=path, size=size)
        self._move_into(self._residence.domain(self._house_seed))
        self._rows, self._bounds = self._residence.extent(self.setting.geometry)
        self._request = read_request(instruction, gold)
        self._world: World | None = None
        self._meddler: Meddler | None = None
        self._move: Move | None = None
        self._sensor: Sensor
        self._judging: Judge
        self._recording: Recording
        self._house: tuple[str | None, int | None]
        self._verdict: Verdict | None = None
        self.observation_space = self._make_observation_space()
        self.action_space = self._make_action_space()

    # -- the Gymnasium API --------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None, instruction: Any = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begins an episode; `instruction` is the option of that name.

        Raises `InputError` for options or an instruction that cannot be used.
        """
        if instruction is not None:
            options = {**(options or {}), "instruction": instruction}
        check_keys(options)
        super().reset(seed=seed)
        self._choose_house(options)
        return self._begin(read_options(options, self.setting.geometry))

    def step(self, action: Action) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Does one action. Raises `InputError` for one that is none, `gymnasium.error.ResetNeeded` before a reset."""
        world = self.world
        forward, turn, interaction, target = read_action(action, self._rows)
        self._move = self._meddle()
        self._result = interact(world, interaction, target)
        if world.walks:
            advance(world)
        x, y = world.robot
        world.drive(forward, turn)
        self._path_length += hypot(world.robot[0] - x, world.robot[1] - y)
        has_looked = self._sensor.look()
        is_finished = interaction is Interaction.FINISH
        is_late = world.seconds >= self._max_seconds - 1e-9
        before = self._verdict
        if has_looked or is_finished or is_late or self._has_news():
            self._take_verdict()
        self._recording.note(forward, turn, int(interaction), target, world)
        terminated = is_finished or (self._verdict is not None and self._verdict.is_over)
        truncated = is_late and not terminated
        if terminated and self._verdict is not None and self._verdict.is_success:
            self._shortest_length = self._measure_shortest_path()
        if (terminated or truncated) and self._bodies:
            self._tell_bodies()
        if self._camera is not None or self.render_mode is not None:
            self._film()
        return self._observe(), self._reward(before, terminated), terminated, truncated, self._inform()

    def render(self) -> Any:
        """A picture `(height, width, 3)`, a text map, or None after showing it on the screen, by the render mode."""
        if self.render_mode is None:
            gym.logger.warn("render() needs a render mode; give gym.make one, as in render_mode='rgb_array'")
            return None
        return self.camera.show(self._scene(), self.render_mode)  # type: ignore[arg-type]

    def render_svg(self) -> str:
        """This moment as vectors, an SVG document; in any render mode."""
        return self.camera.svg(self._scene())

    def render_pdf(self) -> bytes:
        """This moment as vectors, a PDF document of one page; in any render mode."""
        return self.camera.pdf(self._scene())

    def close(self) -> None:
        if self._camera is not None:
            self._camera.close()

    # -- for agents, judges, pictures ---------------------------------------------------------------------------------

    def embodiment(self) -> HouseholdEmbodiment:
        """A fresh body that knows the house map and nothing of the episode."""
        from decomplex_bt.envs.embodiment import BodyConfig, HouseholdEmbodiment
        from decomplex_bt.envs.navigation import Limits

        world = self.config.world
        limits = Limits(
            speed=world.max_speed,
            turn_rate=world.max_turn_rate,
            acceleration=world.max_acceleration,
            turn_acceleration=world.max_turn_acceleration,
            step=world.step_seconds,
        )
        body = HouseholdEmbodiment(
            self.domain, BodyConfig(limits=limits, reach=world.reach, reach_person=world.speak_reach)
        )
        self._bodies = [other for other in self._bodies if other() is not None] + [weakref.ref(body)]
        return body

    def truth(self) -> WorldTruth:
        """The running episode's world as the judge reads it; for judges and the oracle, cheating for an agent."""
        return WorldTruth(self.world, self._sensor)

    def policy(self, name: str, **arguments: Any) -> Policy:
        """A registered policy for this environment: "tree", "oracle", "random" or "idle" (`baselines.make_policy`)."""
        from decomplex_bt.envs.baselines import make_policy

        return make_policy(name, self, **arguments)

    @property
    def world(self) -> World:
        """The truth of the running episode, for judges and pictures; reading it is cheating for an agent."""
        if self._world is None:
            raise gym.error.ResetNeeded("there is no episode yet; call reset() first")
        return self._world

    @property
    def camera(self) -> Camera:
        """What pictures are taken with; its captions may be set."""
        if self._camera is None:
            from decomplex_bt.envs.rendering.camera import Camera

            sensing = self.config.sensing
            self._camera = Camera(self.setting.geometry, sight=(sensing.range, np.deg2rad(sensing.field_of_view)))
        return self._camera

    @property
    def verdict(self) -> Verdict | None:
        """The judge's verdict so far."""
        return self._verdict

    @property
    def instruction(self) -> str | None:
        """The instruction of the next bare reset; None: one is drawn. Settable with whatever the option takes."""
        return None if self._request is None else self._request.text

    @instruction.setter
    def instruction(self, value: Any) -> None:
        self._request, self._judge = read_request(value), None

    # -- recording and replay -----------------------------------------------------------------------------------------

    def state_dict(self) -> dict[str, Any]:
        """The running episode as plain values: how it began and every action since."""
        _ = self.world
        return {**self._recording.to_dict(), "house": self._house}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        """Brings the environment to a recorded moment by doing all of it again, exactly.

        Raises `InputError` naming the step at which the replay departs from the recording.
        """
        self._house = state["house"]
        self._move_into(self._residence.domain(self._house[1], path=self._house[0]))
        self.np_random.bit_generator.state = state["generator"]
        self._judge = None
        self._begin(state["options"], replayed=state["request"])
        for forward, turn, interaction, target in state["actions"]:
            HouseholdEnv.step(self, {"drive": (forward, turn), "interact": interaction, "target": target})
        self._recording.check(state["checksums"])

    def __getstate__(self) -> dict[str, Any]:
        return {
            "arguments": {**self._arguments, "domain": self._base.folder, "house_seed": self._house_seed},
            "request": self._request,
            "episode": None if self._world is None else self.state_dict(),
            "generator": None if self._np_random is None else self.np_random.bit_generator.state,
            "seed": self._np_random_seed,
            "spec": self.spec,
        }

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__init__(**state["arguments"])  # type: ignore[misc]
        if state["episode"] is not None:
            self.load_state_dict(state["episode"])
        self._request, self.spec = state["request"], state["spec"]
        if state["generator"] is not None:
            self.np_random.bit_generator.state = state["generator"]
            self._np_random_seed = state["seed"]

    # -- the house ----------------------------------------------------------------------------------------------------

    def _choose_house(self, options: Mapping[str, Any] | None) -> None:
        """Moves into the house that the options name, or that is due, or that is drawn.

        A house is drawn until the instruction, where there is one, can be asked for in it.
        """
        path, seed = read_house(options)
        self._house_seed = self._house_seed if seed is None else seed
        request = read_request((options or {}).get("instruction"), (options or {}).get("gold")) or self._request
        if path is not None or self._house_seed is not None or not self._residence.is_generated:
            self._house = path, self._house_seed if path is None else None
            self._move_into(self._residence.domain(self._house[1], path=path))
            return
        for _ in range(HOUSE_TRIES):
            self._house = None, int(self.np_random.integers(2**31))
            self._move_into(self._residence.domain(self._house[1]))
            if request is None or can_be_asked(request, self.domain):
                return
        assert request is not None
        raise InputError(f"none of {HOUSE_TRIES} houses drawn is one in which {request.text!r} can be asked for")

    def _move_into(self, domain: Domain) -> None:
        """Lives in the domain's house from now on; whoever has the map of another one gets the new one."""
        if getattr(self, "domain", None) is domain:
            return
        setting = setting_of(domain)
        if hasattr(self, "_rows"):
            self._residence.check(setting.geometry, self._rows, self._bounds)
        self.domain, self.setting, self.entities = domain, setting, setting.geometry.names
        self._stage = Stage(setting.geometry)
        self._judge = None
        if self._camera is not None:
            self._camera.close()
            self._camera = None
        for body in (reference() for reference in self._bodies):
            if body is not None:
                body.move_to(domain)

    # -- beginning ----------------------------------------------------------------------------------------------------

    def _begin(self, options: Options, replayed: Request | None = None) -> tuple[Observation, dict[str, Any]]:
        generator = self.np_random.bit_generator.state
        base, mixing, asking, noise, whims = map(np.random.default_rng, self.np_random.integers(2**63, size=5))
        if options.request is not None:
            self._request, self._judge = options.request, None
        self._options = options
        request, judge = self._ask(replayed or self._request, asking)
        self._text, self._judging = request.text, judge
        self._codes = encode(self._text)
        self._shown_text = shown(self._text)
        self._max_seconds = self.config.max_seconds if options.max_seconds is None else options.max_seconds
        self._reward_kind = options.reward or self.config.reward
        self._recording = Recording(generator, request, options)
        self._result = Result.NONE
        self._move = None
        self._path_length, self._shortest_length = 0.0, UNKNOWN_LENGTH
        self._start = draw_start(self.setting, options, judge.tests, self.config.balance, base, mixing)
        setting = self.setting
        if self._world is not None:
            self._world.dismantle()
        self._world = World(
            setting.geometry,
            setting.prior,
            setting.spots,
            self._start,
            config=self.config.world,
            rng=noise,
            whims=whims,
            stage=self._stage,
        )
        self._sensor = Sensor(self._world, self.config.sensing, noise)
        self._add_noise(options)
        self._sensor.look()
        self._judged_arrangement = self._world.arrangement
        self._verdict = judge.begin(self._world, self._sensor)
        self._meddler = self._make_meddler(options.meddling, noise)
        self._held_version = -1
        self._constant_info = {"instruction": self._text, **judge.feasibility()}
        if self._camera is not None:
            self._camera.reset()
        if self.render_mode is not None:
            self._film()
        return self._observe(), {**self._inform(), "exempt": self._world.exempt}

    def _add_noise(self, options: Options) -> None:
        """How likely grasps slip and looks miss something: as the house has it, or as the options want it."""
        world, sensor = self.world, self._sensor
        if not options.noise or not options.chance:
            world.grasp_slip = sensor.missed_detection = 0.0
        if options.grasp_slip is not None:
            world.grasp_slip = options.grasp_slip
        if options.missed_detection is not None:
            sensor.missed_detection = options.missed_detection

    def _make_meddler(self, rate: float, noise: Generator) -> Meddler | None:
        if rate == 0.0:
            return None
        judge, rng = self._judging, noise.spawn(1)[0]  # spawning leaves the noise as it is
        return Meddler(self.world, rng, rate=rate, mentioned=judge.mentioned, allows=judge.allows)

    def _ask(self, request: Request | None, rng: Generator) -> tuple[Request, Judge]:
        """What the robot is asked to do, with its judge; drawn from the corpus where nothing is asked."""
        if request is None:
            return draw_asked(self._base, self.domain, rng)
        if self._judge is None:
            self._judge = judge_for(request, self.domain)
        return request, self._judge

    # -- a step's parts -----------------------------------------------------------------------------------------------

    def _meddle(self) -> Move | None:
        """Lets somebody else move a thing, if it is time to, and tells the judge."""
        move = None if self._meddler is None else self._meddler.act()
        if move is not None:
            self._judging.take_in(move.thing)
        return move

    def _has_news(self) -> bool:
        """Whether something happened between two looks that the judge may go by."""
        world = self.world
        is_rearranged = world.arrangement != self._judged_arrangement
        return is_rearranged or world.event is not None or self._judging.minds_position

    def _tell_bodies(self) -> None:
        """Tells the bodies that were handed out that the episode is over; they ask for nothing themselves."""
        for body in (reference() for reference in self._bodies):
            if body is not None:
                body.end(HouseholdEnv._observe(self))

    def _measure_shortest_path(self) -> float:
        from decomplex_bt.envs.shortest import ShortestPath

        world, sensing = self.config.world, self.config.sensing
        path = ShortestPath(
            self.domain,
            self.setting.geometry,
            self._start,
            reach=world.reach,
            earshot=world.speak_reach,
            sight=(sensing.range, sensing.inside_range),
        )
        length = path.length(*self._judging.carried_out())
        # What was driven is a way to do it: the shortest is no longer than that.
        return UNKNOWN_LENGTH if length is None else min(length, self._path_length)

    def _take_verdict(self) -> None:
        world = self.world
        self._judged_arrangement = world.arrangement
        self._verdict = self._judging.update(world.event)

    def _observe(self) -> Observation:
        world = self._world
        assert world is not None
        x, y = world.robot
        speed, turn_rate = _clip(world.speed, MAX_SPEED), _clip(world.turn_rate, MAX_TURN_RATE)
        numbers = np.array((x, y, world.robot_heading, speed, turn_rate, world.seconds), dtype=np.float32)
        if world.version != self._held_version:
            self._held_version = world.version
            self._held = np.array((world.held, *world.tray), dtype=np.int16)
        return {
            "instruction": self._shown_text,
            "instruction_codes": self._codes.copy(),
            "robot": numbers[:5],
            "held": self._held.copy(),
            "entities": self._table(),
            "result": int(self._result),
            "seconds": numbers[5:],
        }

    def _table(self) -> NDArray[np.float32]:
        """The entity table, a fresh one; rows that stand for nothing in this house are as of what is not seen."""
        table = self._sensor.table
        if len(table) == self._rows:
            return table.copy()
        full = np.zeros((self._rows, table.shape[1]), dtype=np.float32)
        full[:, PLACE] = full[:, FIRST_STATE:] = -1
        full[: len(table)] = table
        return full

    def _inform(self) -> dict[str, Any]:
        world = self.world
        info = self._judging.report(self._constant_info)
        info["seconds"] = world.seconds
        info["path_length"] = self._path_length
        info["shortest_length"] = self._shortest_length
        info["events"] = [str(event) for event in (self._move, world.event) if event is not None]
        info["moved_by_others"] = 0 if self._meddler is None else self._meddler.moves
        info["result"] = RESULT_NAMES[self._result]
        return info

    def _reward(self, before: Verdict | None, terminated: bool) -> float:
        now = self._verdict
        if now is None:
            return 0.0
        if self._reward_kind == "progress":
            met = before.met if before is not None else 0
            return (now.met - met) / now.total if now.total else float(now.is_success and terminated)
        return float(now.is_success and terminated)

    def _scene(self) -> Scene:
        return self.camera.scene(self.world, instruction=self._text, **self._captions())

    def _captions(self) -> dict[str, str]:
        """What a picture says besides the instruction: the verdict, or the task that is due."""
        verdict = self._verdict
        if verdict is None or verdict.is_success or verdict.unsettled is None:
            return {"verdict": "success"} if verdict is not None and verdict.is_success else {}
        return {"due": f"due: {self._judging.reading.phrase(verdict.unsettled)}"}

    def _film(self) -> None:
        self.camera.note(self.world)
        if self.render_mode == "human":
            self.render()

    # -- spaces -------------------------------------------------------------------------------------------------------

    def _make_action_space(self) -> gym.Space[Any]:
        return action_space(self._rows)

    def _make_observation_space(self) -> gym.Space[Any]:
        return observation_space(self._rows, self._bounds, self.config.world.tray_slots)


def _clip(value: float, most: float) -> float:
    return value if -most <= value <= most else most if value > 0 else -most
