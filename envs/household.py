"""The household environment: a robot that is told in one sentence what to do, behind the Gymnasium API."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from copy import deepcopy
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import gymnasium as gym
import numpy as np

from decomplex_bt.envs.config import HouseholdConfig, read_config
from decomplex_bt.envs.values import plain
from decomplex_bt.errors import InputError, among

if TYPE_CHECKING:
    from gymnasium.envs.registration import EnvSpec

    from decomplex_bt.domain.loader import Domain
    from decomplex_bt.envs.baselines import Policy
    from decomplex_bt.envs.embodiment import HouseholdEmbodiment
    from decomplex_bt.envs.episode import Episode
    from decomplex_bt.envs.home import Home
    from decomplex_bt.envs.judge import Judge
    from decomplex_bt.envs.options import Options, Request
    from decomplex_bt.envs.randomness import Generators
    from decomplex_bt.envs.rendering.camera import Camera
    from decomplex_bt.envs.rendering.scene import Scene
    from decomplex_bt.envs.setting import Setting
    from decomplex_bt.envs.verdict import Verdict
    from decomplex_bt.envs.world import World
    from decomplex_bt.envs.world_truth import WorldTruth

__all__ = ["HouseholdConfig", "HouseholdEnv"]

DEFAULT_DOMAIN = "household"
_MADE_ANEW = frozenset({"_home", "_episode", "_judge", "_camera", "_bodies"})
"""Attributes that a pickle leaves out: they hold what does not pickle, or belong to somebody else."""
_DRAWN_FROM = ("_np_random", "action_space", "observation_space")
"""Attributes that random numbers are drawn from."""
_CONFIG = ("max_seconds", "balance", "reward")
_ARGUMENTS = ("instruction", "gold", "domain", "house", "size", "house_seed", "config", "render_mode")
Action = Mapping[str, Any]
Observation = dict[str, Any]


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

    Speeds beyond the bounds are clipped; all else that is no action is refused (`InputError`) and not done. With both
    speeds 0 the robot brakes: it stands within the step, and stays where it is unless it is pushed. An interaction
    takes effect at once, before the drive; an impossible one changes nothing, and its reason is in the next
    observation. A device with a door is switched on only while it is closed; then it works on what is in it. The
    gripper reaches 0.8 m; speaking and handing over need 1.5 m.

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
    | `result` | `Discrete(13)` | what came of the last interaction (`interface.Result`) |
    | `seconds` | `Box((1,))` | simulated time |

    Columns of the entity table (`interface.COLUMNS`): visible, x, y, heading, place, inspected, power, aperture,
    temperature, cleanliness, fill. What is not seen is masked: coordinates 0 (places and the user keep theirs),
    place and states -1. Row `r` is `env.unwrapped.entities[r]`. The robot looks every fifth step, and in any step
    in which it has changed something; between looks the table stays. A floor counts as inspected when each part of it
    was in view within the last 15 s; things seen on it in that time are then reported as they were seen last, until
    the spot is in view again.

    ## Rewards
    1.0 with success, else 0. `reward="progress"`: the change in the share of goal conditions met.

    ## Termination and truncation
    `terminated`: everything due is done (success), a task was done that was not due (violation), or the robot said
    `finish`. `truncated`: the time limit, by default 600 s of simulated time, 1800 s in large houses. After either,
    `step` raises `gymnasium.error.ResetNeeded` until the next reset.

    ## Arguments
    Of `HouseholdEnv` and, after the id, of `gym.make`. They hold for all episodes; what is of one episode alone
    (placement, noise, meddling, ...) is a reset option.

    | argument | meaning |
    |---|---|
    | `instruction` | a text, an annotated `Instruction` or a corpus `Example`; without it each reset draws one |
    | `gold` | the reading the judge goes by, for a text: an `Instruction` or `Example` |
    | `domain` | a shipped domain's name, the path of a domain's folder, or a `Domain`; "household" |
    | `house`, `size`, `house_seed` | which house, or which houses: see below |
    | `config` | `HouseholdConfig` or a mapping: `max_seconds`, `balance`, `reward`, the robot's abilities and senses |
    | `render_mode` | "rgb_array", "human", "ansi"; None: no pictures |

    ## Houses
    The default is the domain's house. `house=` (the path of a house file) makes an environment for another one;
    `size="small"`, `"medium"` or `"large"` one for generated houses of 2 to 4, 6 to 10 or 20 to 40 rooms (the ids
    HouseholdSmall-v0, HouseholdMedium-v0 and HouseholdLarge-v0): `house_seed=` fixes which, without it each reset draws
    one. Their entity tables have as many rows as the largest house needs; rows that stand for nothing are masked, and
    `entities` is of the house of the episode.

    Whatever the arguments name (a domain, a house, a size) is read and checked at once, and so are the configuration
    and the form of an instruction. Whether an instruction suits the house is found out by the first reset, for it takes
    the house of that episode and, for a text, the interpreter, which takes seconds to load. The shipped house is read
    when it is first asked for: by a space, `entities`, or the first reset.

    ## Reset options
    `house_seed` (stays until another is given, and None undoes it) and `house` (a file, for this episode), as long as
    it fits the spaces, `instruction` (a text, an annotated `Instruction` or a corpus `Example`; stays until replaced,
    and None lets resets draw one again), `gold` (the reading the judge goes by; beside an `instruction` it stays with
    it, else it holds for this episode, of the instruction there is or of its own text), `balance`, `placement`,
    `states`, `broken`, `people`, `noise`, `grasp_slip`, `missed_detection`, `meddling`, `chance`, `max_seconds`,
    `reward`: see `options.Options`. Unknown keys are refused. A reset that is refused leaves instruction, house and
    episode as they were. Without an instruction each reset draws one from the corpus; in the world drawn for it, it may
    be infeasible (`info["feasible"]`). A text without a gold reading is understood by the interpreter, which is loaded
    then.

    ## Info keys
    | key | meaning |
    |---|---|
    | `instruction` | the exact text |
    | `is_success` | everything due was done, at most one step late; true after reset: nothing was left to do |
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

    _spec: EnvSpec | None = None
    metadata: dict[str, Any] = {"render_modes": ["human", "rgb_array", "ansi"], "render_fps": 10}

    def __init__(
        self,
        instruction: Any = None,
        *,
        gold: Any = None,
        domain: str | Path | Domain = DEFAULT_DOMAIN,
        house: str | Path | None = None,
        size: str | None = None,
        house_seed: int | None = None,
        config: HouseholdConfig | Mapping[str, Any] | None = None,
        render_mode: str | None = None,
        **others: Any,
    ) -> None:
        if others:
            _refuse(others)
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            modes = ", ".join(self.metadata["render_modes"])
            raise InputError(f"render_mode is {render_mode!r}; expected one of {modes}")
        self.config = read_config(config, HouseholdConfig, "config")
        self.render_mode = render_mode
        self._site: dict[str, Any] = {
            "domain": _lasting(domain) if _is_path(domain) else domain,
            "house": _lasting(house),
            "size": size,
            "house_seed": house_seed,
        }
        self._bodies: list[weakref.ref[HouseholdEmbodiment]] = []
        self._camera: Camera | None = None
        self._judge: Judge | None = None
        self._episode: Episode | None = None
        self._request: Request | None = None
        if self._site != {"domain": DEFAULT_DOMAIN, "house": None, "size": None, "house_seed": None}:
            _ = self._home  # what is named is checked at once
        if instruction is not None or gold is not None:
            from decomplex_bt.envs.options import read_request

            self._request = read_request(instruction, gold)

    # -- the Gymnasium API --------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None, instruction: Any = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begins an episode; `instruction` is the option of that name, None one that is not given. A seed may be one of
        numpy's whole numbers.

        Raises `InputError` for options or an instruction that cannot be used, `DataFileError` where the domain's files
        are broken; instruction, house, episode and random numbers are then those from before.
        """
        with self._unchanged_if_refused() as before:
            begin = self._prepare(seed, options, instruction)
            return self._begin(begin, before)

    def check_reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> None:
        """Raises what `reset` would raise for these; changes nothing."""
        with self._unchanged_if_refused(is_rehearsal=True):
            self._prepare(seed, options, None)

    def step(self, action: Action) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Does one action. Raises `InputError` for one that is none, and `gymnasium.error.ResetNeeded` where no episode
        runs: before the first reset, and after an episode's end."""
        episode = self._episode or self._running
        if episode.is_over:
            raise gym.error.ResetNeeded("the episode is over; call reset() for the next one")
        reward, terminated, truncated = episode.step(action)
        if (terminated or truncated) and self._bodies:
            self._tell_bodies()
        if self._camera is not None or self.render_mode is not None:
            self._film()
        return self._observe(episode), reward, terminated, truncated, episode.inform()

    def observe(self) -> Observation:
        """The observation of this moment: what `reset` or the last `step` returned, also of an episode that was loaded,
        unpickled or copied. Raises `gymnasium.error.ResetNeeded` where there is none."""
        return self._observe(self._running)

    def inform(self) -> dict[str, Any]:
        """The info of this moment, as `observe` has the observation."""
        return self._inform(self._running)

    @cached_property
    def observation_space(self) -> gym.Space[Any]:  # type: ignore[override]
        """The space of what `reset` and `step` return."""
        return self._make_observation_space()

    @cached_property
    def action_space(self) -> gym.Space[Any]:  # type: ignore[override]
        """The space of what `step` takes."""
        return self._make_action_space()

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

    @property
    def spec(self) -> EnvSpec | None:
        """The spec it was made by, if it was; its arguments are plain where JSON would not keep them."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        if spec is not None:
            spec = replace(spec, kwargs={name: _plain(value) for name, value in spec.kwargs.items()})
        self._spec = spec

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
        from decomplex_bt.envs.world_truth import WorldTruth

        return WorldTruth(self.world, self._running.sensor)

    def policy(self, name: str, **arguments: Any) -> Policy:
        """A registered policy for this environment: "tree", "oracle", "random" or "idle" (`baselines.make_policy`)."""
        from decomplex_bt.envs.baselines import make_policy

        return make_policy(name, self, **arguments)

    @property
    def domain(self) -> Domain:
        """The domain with the house of now in it."""
        return self._home.domain

    @property
    def setting(self) -> Setting:
        """What all episodes in the house of now share: its geometry, spots and prior."""
        return self._home.setting

    @property
    def entities(self) -> tuple[str, ...]:
        """The names of the rows of the entity table, in the house of now."""
        return self._home.setting.geometry.names

    @property
    def world(self) -> World:
        """The truth of the running episode, for judges and pictures; reading it is cheating for an agent."""
        return self._running.world

    @property
    def camera(self) -> Camera:
        """What pictures are taken with; its captions may be set."""
        if self._camera is None:
            self._camera = self._make_camera()
        return self._camera

    @property
    def verdict(self) -> Verdict | None:
        """The judge's verdict so far."""
        return None if self._episode is None else self._episode.verdict

    @property
    def instruction(self) -> str | None:
        """The instruction of the next bare reset; None: one is drawn. Settable with whatever the option takes."""
        return None if self._request is None else self._request.text

    @instruction.setter
    def instruction(self, value: Any) -> None:
        from decomplex_bt.envs.options import read_request

        self._request, self._judge = read_request(value), None

    @property
    def request(self) -> Request | None:
        """`instruction` with its gold reading, where it has one."""
        return self._request

    # -- recording and replay -----------------------------------------------------------------------------------------

    def state_dict(self) -> dict[str, Any]:
        """The running episode as plain values, which JSON keeps: where and how it began, and every action since."""
        from decomplex_bt.envs.recording import FORMAT, circumstances

        episode = self._running
        made_in = circumstances(episode.domain, episode.house, self.config)
        return {"format": FORMAT, **made_in, **episode.recording.to_dict()}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        """Brings the environment to a recorded moment by doing all of it again, exactly; `observe` shows it.

        Raises `InputError` for what is no recording, for one that was made in another house, domain or configuration,
        and where the replay departs from it, naming the step; the environment is then as it was.
        """
        self.np_random = self._replay(state)

    def _replay(self, state: Mapping[str, Any]) -> np.random.Generator:
        """Does a recorded episode again; the generator as it left it is the value."""
        from decomplex_bt.envs.options import check_keys, read_options
        from decomplex_bt.envs.recording import Recorded

        recorded = Recorded.read(state)
        with self._unchanged_if_refused() as before:
            self._home.move((recorded.house.path, recorded.house.seed))
            self._home.renew_stage()  # the episode of before keeps its own until this one is known to be exact
            recorded.check_circumstances(self.domain, self.config)
            check_keys(recorded.options)
            options, rng = read_options(recorded.options, self.setting.geometry), recorded.begin_random()
            episode = self._draw(options, rng, recorded.request)()
            camera = None if self._camera is None and self.render_mode is None else self._make_camera()
            for forward, turn, interaction, target in recorded.actions:
                if episode.is_over:
                    break
                if camera is not None:
                    camera.note(episode.world)
                episode.step({"drive": (forward, turn), "interact": interaction, "target": target})
            recorded.check(episode.recording)
        if self._episode is not None:
            self._episode.world.dismantle()
        if self.domain is not before:
            self._judge = None
        self._enter(episode, before)
        if camera is not None:
            self._change_camera(camera)
            self._film()
        if episode.is_over:
            self._tell_bodies()
        return rng

    def __getstate__(self) -> tuple[dict[str, Any], dict[str, Any] | None, int | None]:
        """All attributes but those that are made anew, the running episode's recording, and the seed of the houses to
        come, which need not be the one that the environment was made with."""
        kept = {name: value for name, value in vars(self).items() if name not in _MADE_ANEW}
        seed = self._home.seed if "_home" in vars(self) else self._site["house_seed"]
        return kept, None if self._episode is None else self.state_dict(), seed

    def __setstate__(self, state: tuple[dict[str, Any], dict[str, Any] | None, int | None]) -> None:
        kept, recorded, seed = state
        vars(self).update(kept, _bodies=[], _camera=None, _judge=None, _episode=None)
        if recorded is not None:
            self._replay(recorded)
        if seed != self._site["house_seed"]:
            self._home.seed = seed

    def __copy__(self) -> HouseholdEnv:
        """A shallow copy shares what the attributes hold, but for what random numbers are drawn from: neither is to
        change what the other draws next."""
        kept, recorded, seed = self.__getstate__()
        kept |= {name: deepcopy(kept[name]) for name in _DRAWN_FROM if name in kept}
        twin = type(self).__new__(type(self))
        twin.__setstate__((kept, recorded, seed))
        return twin

    # -- the house ----------------------------------------------------------------------------------------------------

    @cached_property
    def _home(self) -> Home:
        from decomplex_bt.envs.home import Home

        return Home(**self._site)

    def _choose_house(self, options: Mapping[str, Any] | None, request: Request | None) -> None:
        before = self.domain
        self._home.choose(options, request, self.np_random)
        if self.domain is not before:
            self._judge = None

    def _enter(self, episode: Episode, before: Domain) -> None:
        """Makes an episode the running one. Where its house is another one than before, whoever has the map of the old
        one gets the new one."""
        self._episode = episode
        if self.domain is before:
            return
        self._change_camera(None)
        for body in (reference() for reference in self._bodies):
            if body is not None:
                body.move_to(self.domain)

    @contextmanager
    def _unchanged_if_refused(self, *, is_rehearsal: bool = False) -> Iterator[Domain]:
        """Brings house, instruction and random numbers back where an episode could not begin, or is not to; the domain
        from before is its value."""
        address, request, judge = self._home.address, self._request, self._judge
        rng, seed = self._np_random, self._np_random_seed
        numbers = {} if rng is None else rng.bit_generator.state
        is_kept = False
        try:
            yield self.domain
            is_kept = not is_rehearsal
        finally:
            if not is_kept:
                self._home.address, self._request, self._judge = address, request, judge
                self._np_random, self._np_random_seed = rng, seed
                if rng is not None:
                    rng.bit_generator.state = numbers

    # -- an episode ---------------------------------------------------------------------------------------------------

    def _prepare(self, seed: int | None, options: dict[str, Any] | None, instruction: Any) -> Callable[[], Episode]:
        """Draws the episode that is asked for, in the house that is asked for; what is given back makes it."""
        from decomplex_bt.envs.options import asked_by, check_keys, read_options, with_instruction

        check_keys(options)
        options = with_instruction(options, instruction)
        request, asked = asked_by(options, self._request)
        super().reset(seed=plain(seed))
        self._choose_house(options, asked)
        checked = read_options(options, self.setting.geometry)
        if request is not self._request:
            self._request, self._judge = request, None
        return self._draw(checked, self.np_random, asked)

    def _begin(self, begin: Callable[[], Episode], before: Domain) -> tuple[Observation, dict[str, Any]]:
        """Begins an episode in the house of now; up to here nothing of the last one was touched."""
        if self._episode is not None:
            self._episode.world.dismantle()  # its shapes are for the next
        self._enter(episode := begin(), before)
        if self._camera is not None:
            self._camera.reset()
        if self.render_mode is not None:
            self._film()
        return self._observe(episode), self._inform(episode)

    def _draw(self, options: Options, rng: np.random.Generator, request: Request | None) -> Callable[[], Episode]:
        """Draws all that an episode in the house of now begins with; what is given back makes it."""
        from decomplex_bt.envs.episode import Episode
        from decomplex_bt.envs.opening import draw_start
        from decomplex_bt.envs.randomness import draw_generators
        from decomplex_bt.envs.recording import Recording

        numbers = rng.bit_generator.state
        generators = draw_generators(rng)
        request, judge = self._ask(request, generators)
        start = draw_start(self.setting, options, judge.tests, self.config.balance, generators)
        recording = Recording(numbers, request, options)
        return partial(Episode, self._home, judge, start, self.config, recording, generators)

    def _ask(self, request: Request | None, generators: Generators) -> tuple[Request, Judge]:
        """What the robot is asked to do, with its judge; drawn from the corpus where nothing is asked."""
        from decomplex_bt.envs.opening import draw_asked, judge_for

        if request is None:
            return draw_asked(self._home.base, self.setting, generators.asking)
        if request is not self._request:  # of this episode alone, whose judge is not that of the resets to come
            return request, judge_for(request, self.domain)
        if self._judge is None:
            self._judge = judge_for(request, self.domain)
        return request, self._judge

    @property
    def _running(self) -> Episode:
        if self._episode is None:
            raise gym.error.ResetNeeded("there is no episode yet; call reset() first")
        return self._episode

    def _tell_bodies(self) -> None:
        """Tells the bodies that were handed out that the episode is over; they ask for nothing themselves."""
        episode = self._running
        for body in (reference() for reference in self._bodies):
            if body is not None:
                body.end(episode.observe(), is_out_of_time=episode.is_out_of_time)

    def _make_camera(self) -> Camera:
        from decomplex_bt.envs.rendering.camera import Camera

        sensing = self.config.sensing
        return Camera(self.setting.geometry, sight=(sensing.range, np.deg2rad(sensing.field_of_view)))

    def _change_camera(self, camera: Camera | None) -> None:
        if self._camera is not None:
            self._camera.close()
        self._camera = camera

    def _observe(self, episode: Episode) -> Observation:
        return episode.observe()

    def _inform(self, episode: Episode) -> dict[str, Any]:
        info = episode.inform()
        return info if episode.recording.actions else {**info, "exempt": episode.world.exempt}

    def _scene(self) -> Scene:
        return self.camera.scene(self.world, instruction=self._running.text, **self._running.captions())

    def _film(self) -> None:
        self.camera.note(self.world)
        if self.render_mode == "human":
            self.render()

    # -- spaces -------------------------------------------------------------------------------------------------------

    def _make_action_space(self) -> gym.Space[Any]:
        from decomplex_bt.envs.spaces import action_space

        return action_space(self._home.rows)

    def _make_observation_space(self) -> gym.Space[Any]:
        from decomplex_bt.envs.spaces import observation_space

        return observation_space(self._home.rows, self._home.bounds, self.config.world.tray_slots)


def _is_path(domain: Any) -> bool:
    return isinstance(domain, Path) or (isinstance(domain, str) and Path(domain).name != domain)


def _lasting(path: Any) -> Any:
    """The same path, whatever the working directory is by the time when a copy of the environment needs it."""
    return Path(path).absolute() if isinstance(path, str | Path) else path


def _plain(argument: Any) -> Any:
    """An argument as a spec keeps it: JSON makes mappings of configurations and instructions, and cannot keep these."""
    return str(argument.resolve()) if isinstance(argument, Path) else plain(argument)


def _refuse(arguments: Mapping[str, Any]) -> None:
    """Raises `InputError` for arguments that are fields of the config or reset options, `TypeError` for any other."""
    from decomplex_bt.envs.options import KEYS

    unknown = [name for name in arguments if name not in KEYS]
    if unknown:
        raise TypeError(f"HouseholdEnv takes no argument {unknown[0]!r}{among(unknown[0], _ARGUMENTS)}")
    if all(name in _CONFIG for name in arguments):
        raise InputError(
            f"{', '.join(arguments)}: no argument of the environment but a field of its config; "
            f"call gym.make(..., config={arguments!r}), or env.reset(options={arguments!r}) for one episode"
        )
    given = ", ".join(f"{name!r}: {value!r}" for name, value in arguments.items())
    raise InputError(
        f"{', '.join(arguments)}: no argument of the environment but an option of each reset; "
        f"call env.reset(options={{{given}}})"
    )
