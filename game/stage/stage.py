"""The stage: plays a scene in real time, lets events in and keeps a recording.

real time -> clock -> steps -> session (states, events, snapshots) -> picture and readouts
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Protocol

from game.levels import Level, LevelError
from game.physics.effects import EffectSet
from game.stage.clock import FixedStep
from game.stage.declarations import Readout
from game.stage.events import Action, StageEvent
from game.stage.fault import Fault
from game.stage.records.keeping import recording_of
from game.stage.records.recipe import Recipe, checked_seed
from game.stage.records.recording import Recording
from game.stage.records.rerun import Kept
from game.stage.sampling import Sampling
from game.stage.scene import Scene
from game.stage.series import StripSeries
from game.stage.session import Session
from game.stage.validation import checked_event

SLOWEST = 1.0 / 16.0
FASTEST = 4.0
NEWEST = 1.0 - 2.0**-53  # alpha that shows the newest state


class Cue(Protocol):
    """Who has a say before each step, such as a story."""

    def before_step(self) -> None:
        """Post what is due at the step at which the stage stands; it may have gone back."""

    def restart(self) -> None:
        """The stage stands at step 0 of a new session."""


class Stage:
    """One scene in play. ``cue``: asked before each step, if there is one.

    ``level`` None: the scene's defaults. ``parameters`` and ``seed`` stand in for the level's,
    ``effects_off`` are switched off beside the level's, ``effects`` are exactly those active. ``dt``: s, else
    the scene's own. ``record``: keep all events for a recording. ``snapshot_bytes``: what snapshots may take.
    ``max_steps``: the most steps that one frame makes. ``charts``: take readouts for strip charts on the way.

    Raises ParameterError, LevelError or ValueError for what the scene refuses.
    """

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

    # -- what it is doing ---------------------------------------------------------------------------

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
    def paused(self) -> bool:
        """True while it stands still and shows the newest state."""
        return self._paused

    @paused.setter
    def paused(self, value: bool) -> None:
        if value != self._paused:
            self._paused = value
            self.clock.hold()
            self._session.keep_previous()  # the picture goes on from the state it shows

    @property
    def still(self) -> bool:
        """True while it stands still, or a timeline of the scene's own is paused."""
        return self._paused or self.scene.resting

    def play_or_pause(self, own: bool = True) -> None:
        """Go on if it is `still`, else stand still.

        Of a scene that has a ``play_action`` its own timeline pauses, and steps are made all the same; but
        not while remembered events act again, which an action would end, nor if it is not to (``own``).
        """
        own = own and not self._session.repeating and bool(self.scene.play_action)
        rests = own and self.scene.resting
        if self._paused or rests:
            self.resume()
            if rests:
                self.post(Action(self.scene.play_action))
        elif own:
            self.post(Action(self.scene.play_action))
        else:
            self.pause()

    def pause(self) -> None:
        """Stand still."""
        self.paused = True

    def resume(self) -> None:
        """Go on from the state that is shown."""
        self.paused = False

    @property
    def speed(self) -> float:
        """Simulated seconds for each real one, 1/16 to 4; ValueError for anything else."""
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        if not SLOWEST <= value <= FASTEST:
            raise ValueError(f"speed = {value!r}: outside 1/16 to 4")
        self._speed = float(value)

    @property
    def alpha(self) -> float:
        """How far the picture is between the last two states; the newest one when it stands still."""
        return NEWEST if self._paused or self._session.fault is not None else self.clock.alpha

    @property
    def dropped_s(self) -> float:
        """Real time that was dropped because the steps took too long, s."""
        return self.clock.dropped_s

    @property
    def step_cost_s(self) -> float:
        """Running median of the measured time of a step, s; NaN before the first."""
        return self._session.timer.median_s

    @property
    def last_step_s(self) -> float:
        """Measured time of a step now, s, a single hitch left out; 0 before the first."""
        return self._session.timer.last_s

    @property
    def first_step(self) -> int:
        """The earliest step that `step_back` can reach."""
        return self._session.first_step

    @property
    def snapshot_bytes(self) -> int:
        """What the snapshots take now."""
        return self._session.snapshot_bytes

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

    # -- running ------------------------------------------------------------------------------------

    def advance(self, elapsed_s: float) -> int:
        """Make the steps that a frame of ``elapsed_s`` real seconds asks for; returns how many were made.

        ValueError if ``elapsed_s`` is not a number.
        """
        if math.isnan(elapsed_s):
            raise ValueError("elapsed_s is not a number")
        if self._paused or self._session.fault is not None:
            self.clock.hold()
            return 0
        due = self.clock.advance(elapsed_s * self._speed)
        return self._make(due)

    def run(
        self, steps: int, progress: Callable[[int, int], Any] | None = None, players: bool = False
    ) -> int:
        """Make so many steps as fast as it goes; returns how many were made (fewer after a fault).

        ValueError unless it is a whole number from 0 on.

        ``progress(done, total)`` is called about a hundred times; if it returns False the run stops.
        ``players``: before each step the scene's own players are listened to. Simulated time stands still
        while they think, so that what they do does not depend on the machine.
        """
        if isinstance(steps, bool) or not isinstance(steps, int) or steps < 0:
            raise ValueError(f"steps = {steps!r}: expected a whole number, 0 or more")
        self._sampling.skip_to(self.step_number + steps, self.dt)
        made = 0
        portion = max(1, steps // 100) if progress is not None else steps
        while made < steps:
            asked = min(portion, steps - made)
            done = self._make(asked, players)
            made += done
            if done < asked or (progress is not None and progress(made, steps) is False):
                break
        self._sampling.skip_no_more(self.step_number)
        return made

    def _make(self, steps: int, players: bool = False) -> int:
        """Make steps until one fails; returns how many were made."""
        session = self._session
        if session.fault is not None:
            return 0
        made = 0
        while made < steps:
            if self.cue is not None:
                self.cue.before_step()
                session = self._session
                if session.fault is not None:
                    break
            if players:
                self.listen(at_once=True)
            if made == steps - 1:
                session.keep_previous()
            if not session.advance():
                break
            made += 1
            if session.step >= self._sampling.due:
                self._sample()
            if session.dt != self.clock.dt:
                self.clock.change_dt(session.dt)
        self.clock.steps = session.step
        return made

    def step(self) -> None:
        """One step, and pause."""
        self.paused = True
        self._make(1)

    def step_back(self) -> bool:
        """Undo one step and the events since, and pause; False at the first remembered step.

        Steps forward then repeat what was, events included, until a new event takes another way. A fault is
        undone by going back as well.
        """
        self.paused = True
        if not self._session.go_back():
            return False
        self._follow_session()
        self._sampling.go_back(self.step_number)
        return True

    @property
    def events_acted(self) -> int:
        """How many events have acted since the beginning."""
        return self._session.timeline.acted

    def return_to(self, step: int, events: int | None = None) -> None:
        """Stand at an earlier step as it was, or at the beginning with what it began with; no later event is
        remembered. ``events``: only so many of all have acted then, of those at that step the first ones.

        ValueError unless it is `first_step` or later, or 0.
        """
        session = self._session
        if step and not session.first_step <= step <= session.step:
            raise ValueError(f"step {step}: outside {session.first_step} to {session.step}")
        if step < session.first_step:
            values, active, _ = session.start
            self._begin(self.build_scene(values, active))
            return
        session.return_to(step, events)
        session.keep_previous()
        self._follow_session()
        self.clock.hold()
        self._sampling.go_back(step)

    def kept_from(self, step: int) -> Kept:
        """What it takes to go once more from a step (or the first one that can be) to where it stands."""
        session = self._session
        snapshot, events = session.kept(step)
        first = max(step, snapshot.step)
        return Kept(
            self.scene_type, self.build_scene, snapshot, events, first, session.step, self.digest(), self.dt
        )

    def forget_future(self) -> None:
        """Drop the events that were remembered of later steps."""
        self._session.forget_future()

    def stop(self, what: str, error: Exception) -> Fault:
        """Stand still, as what somebody asked of the scene (``what``: readouts, a picture) has raised.

        A step back, a reset or another level lets it go on.
        """
        return self._session.stop(what, error)

    # -- events -------------------------------------------------------------------------------------

    def check(self, event: StageEvent) -> StageEvent:
        """The event in plain numbers; ParameterError for one that is refused whatever the state is."""
        return checked_event(event, self.scene_type, self.level)

    def let_go(self) -> None:
        """Take back a drag that is under way, as nobody holds it any more."""
        self._session.let_go()
        self._follow_session()

    def post(self, event: StageEvent) -> None:
        """Let an event act now, before the next step, and record it.

        Raises ParameterError for what is refused; then nothing has changed and nothing is recorded.
        """
        self._session.let_in(self.check(event))
        self._follow_session()
        if self._paused and self._session.fault is None:
            self._sample()  # no step will do it

    def listen(self, at_once: bool = False) -> None:
        """Post what the scene's own players have decided, unless a remembered future will say it.

        ``at_once``: wait for those that think, see `Scene.decisions`. ParameterError for what is refused.
        """
        if self._paused or self._session.fault is not None or self._session.repeating:
            return
        for event in self.scene.decisions(at_once):
            self.post(event)

    def _follow_session(self) -> None:
        """Take over step number and step length where the session moved by itself."""
        self.clock.steps = self._session.step
        if self._session.dt != self.clock.dt:
            self.clock.change_dt(self._session.dt)

    # -- beginning ----------------------------------------------------------------------------------

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
