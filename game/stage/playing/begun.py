"""A scene that has begun: its session, the events that act in it, and how it begins again."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from game.levels import Level, LevelError
from game.physics.effects import EffectSet
from game.stage.checks.validation import checked_event
from game.stage.clock import FixedStep
from game.stage.declarations import Readout
from game.stage.events import StageEvent
from game.stage.fault import Fault
from game.stage.records.recording import Recording
from game.stage.replays.keeping import recording_of
from game.stage.replays.recipe import Recipe, checked_seed
from game.stage.sampling import Sampling
from game.stage.scene import Scene
from game.stage.series import StripSeries
from game.stage.session import Session


class Cue(Protocol):
    """What has a say before each step, such as a story."""

    def before_step(self) -> None:
        """Post what is due at the step at which the stage stands; it may have gone back."""

    def restart(self) -> None:
        """The stage stands at step 0 of a new session."""


class BegunStage:
    """A scene, its clock and its session; see `Stage` for what it is made with."""

    def __init__(
        self,
        scene_type: type[Scene],
        *,
        level: Level | None = None,
        parameters: Mapping[str, Any] | None = None,
        effects_off: Iterable[str] = (),
        effects: EffectSet | None = None,
        seed: int | None = None,
        dt: float | None = None,
        record: bool = True,
        snapshot_bytes: int = 64 << 20,
        max_steps: int = 15,
        charts: bool = True,
    ):
        self._recipe = Recipe(scene_type, level, checked_seed(seed), dt)
        self._sampling = Sampling(charts)
        self._record = record
        self._snapshot_bytes = snapshot_bytes
        self._speed = 1.0
        self._paused = False
        self.session_number = 0  # how often it has begun: another number, another session
        self.cue: Cue | None = None
        scene = self._recipe.first(parameters, effects_off=effects_off, effects=effects)
        self.clock = FixedStep(self._recipe.dt_of(scene), max_steps)
        self._begin(scene)

    # -- what it is -------------------------------------------------------------------------------------

    @property
    def scene_type(self) -> type[Scene]:
        """The class of the scene."""
        return self._recipe.scene_type

    @property
    def level(self) -> Level | None:
        """The level that it began with; None for the scene's defaults."""
        return self._recipe.level

    @property
    def scene(self) -> Scene:
        """The scene; another object after a reset, a new level or a parameter that builds it again."""
        return self._session.scene

    @property
    def series(self) -> StripSeries:
        """Readouts of the last seconds, for charts."""
        return self._sampling.series

    @property
    def fault(self) -> Fault | None:
        """Why the scene was stopped at its last good state, or None."""
        return self._session.fault

    @property
    def step_number(self) -> int:
        """Steps made since the beginning."""
        return self._session.step

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self._session.dt

    @property
    def time_s(self) -> float:
        """Simulated time, s."""
        return self._session.time_s

    @property
    def step_cost_s(self) -> float:
        """Running median of the measured time of a step, s; NaN before the first."""
        return self._session.timer.median_s

    @property
    def last_step_s(self) -> float:
        """Measured time of a step now, s, a single hitch left out; 0 before the first."""
        return self._session.timer.last_s

    def readouts(self) -> list[Readout]:
        """The scene's measured values."""
        return list(self.scene.readouts())

    def digest(self) -> str:
        """Hash of the state and the step number: equal for equal sessions."""
        return self._session.digest()

    @property
    def recording(self) -> Recording:
        """The session so far, as it can be kept and replayed; RecordingError if it was not recorded whole."""
        return recording_of(self._session, self.level)

    # -- events -----------------------------------------------------------------------------------------

    def check(self, event: StageEvent) -> StageEvent:
        """The event in plain numbers; ParameterError for one that is refused whatever the state is."""
        return checked_event(event, self.scene_type, self.level)

    def let_go(self) -> None:
        """Take back a drag that is under way, as it is held no more."""
        self._session.let_go()
        self._follow_session()

    def post(self, event: StageEvent) -> None:
        """Let an event act now, before the next step, and record it.

        Raises ParameterError for what is refused; then nothing has changed and nothing is recorded.
        """
        self.let_in(self.check(event))

    def let_in(self, event: StageEvent) -> None:
        """Let an event act that `check` gave, see `post`."""
        self._session.let_in(event)
        self._follow_session()
        if self._paused and self._session.fault is None:
            self._sample()  # no step will do it

    def stop(self, what: str, error: Exception) -> Fault:
        """Stand still, as what somebody asked of the scene (``what``: readouts, a picture) has raised.

        A step back, a reset or another level lets it go on.
        """
        return self._session.stop(what, error)

    def _follow_session(self) -> None:
        """Take over step number and step length where the session moved by itself."""
        self.clock.steps = self._session.step
        if self._session.dt != self.clock.dt:
            self.clock.change_dt(self._session.dt)

    # -- beginning --------------------------------------------------------------------------------------

    def reset(self) -> None:
        """Build the scene again with the present parameters and effects, and begin a new recording.

        LevelError, ParameterError or ValueError if it cannot be built so; then it goes on with what it had.
        """
        self._begin(self.build_scene(self.scene.values, self.scene.active))

    def scene_of(self, level: Level | None) -> Scene:
        """A new scene of a level, not in play; any thread may build it. LevelError if it refuses that."""
        return self._recipe.of_level(level)

    def load_level(self, level: Level | None, scene: Scene | None = None) -> None:
        """Begin again with a level, its parameters and its effects (None: the scene's defaults).

        ``scene``: what `scene_of` has built for it, if it has. LevelError if the scene refuses the level;
        then it goes on with what it had.
        """
        scene = self.scene_of(level) if scene is None else scene
        before, self._recipe = self._recipe, self._recipe.with_level(level)
        try:
            self._begin(scene)
        except ValueError as error:
            self._recipe = before
            if isinstance(error, LevelError):
                raise
            raise LevelError(level.path if level else None, "content", str(error)) from None

    def build_scene(self, values: Mapping[str, Any], active: EffectSet) -> Scene:
        """A new scene of the same level and seed, with the given parameters and effects."""
        return self._recipe.scene(values, active)

    def _begin(self, scene: Scene) -> None:
        """Step 0 of a new session; ValueError, and nothing changed, if the state is not finite."""
        self._session = Session(
            scene, self.build_scene, self._recipe.dt_of(scene), self._record, self._snapshot_bytes
        )
        self.session_number += 1
        self._follow_session()
        self.clock.hold()
        self.series.clear()
        self._sample()
        if self.cue is not None:
            self.cue.restart()

    def _sample(self) -> None:
        self._sampling.take(self._session)
