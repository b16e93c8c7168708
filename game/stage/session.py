"""A session: the sequence of a scene's states, which steps and events alone decide. No real time in here.

Going back restores the last snapshot before a step and steps again, with the events that acted since. So what
a parameter, an effect or a drag did is undone as well. A step or event that fails (a state that is not
finite, an exception) is undone the same way: the scene stands at its last good state, and `fault` says why.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from time import perf_counter
from typing import Any

from game.definition import DefinitionError
from game.physics.effects import EffectSet
from game.physics.kernels.limits import LimitError
from game.stage.checks.validation import LOCKED, locked_parameters
from game.stage.events import Action, Decision, Pointer, SetEffect, SetParameter, StageEvent, Stamped
from game.stage.fault import Fault, fault_at, fault_in
from game.stage.parameters import STEP_LENGTH, ParameterError
from game.stage.records.recording import CHECK_INTERVAL, MAX_EVENTS, Check
from game.stage.scene import Scene
from game.stage.states.memory import recall, remember
from game.stage.states.snapshots import Snapshot, SnapshotRing
from game.stage.states.state import copy_state, digest_of, same_shapes
from game.stage.timeline import Timeline
from game.stage.timing import StepTimer
from game.stage.watch import FiniteWatch

Build = Callable[[Mapping[str, Any], EffectSet], Scene]


class Session:
    """A scene from its step 0 on. ``build`` makes it again with other parameters; ``dt``: s."""

    def __init__(self, scene: Scene, build: Build, dt: float, record: bool, snapshot_bytes: int):
        self.scene = scene
        self.step = 0
        self.fault: Fault | None = None
        self.timer = StepTimer()
        self.timeline = Timeline()
        self.start = (dict(scene.values), scene.active, dt)
        self._checks: list[Check] = []
        self._build = build
        self._dt = dt
        self._time_base_s = 0.0
        self._time_base_step = 0
        self.recorded = record
        self._locked = {name: scene.values[name] for name in sorted(locked_parameters(scene.level))}
        self._repeating = False  # stepping through a future that is remembered
        self._watch = FiniteWatch(scene.may_be_infinite)
        state = scene.state()
        if not hasattr(state, "_fields"):
            kind = type(state).__name__
            raise DefinitionError(
                f"{type(scene).__name__}.state() gives a {kind}: a NamedTuple of arrays is expected"
            )
        bad = self._watch.first_bad(state)
        if bad is not None:
            raise ValueError(f"{scene.name}: {bad} is not finite in the state it begins with")
        self._ring = SnapshotRing(snapshot_bytes)
        self._ring.add(self._snapshot())
        self._schedule()
        self.keep_previous()

    @property
    def step(self) -> int:
        """How many steps have been done."""
        return self._step

    @step.setter
    def step(self, step: int) -> None:
        self._step = step
        self.scene.begun = step > 0

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self._dt

    @property
    def time_s(self) -> float:
        """Simulated time: a whole number of steps times their length (since that was last changed)."""
        return self._time_base_s + (self.step - self._time_base_step) * self._dt

    @property
    def first_step(self) -> int:
        """The earliest step that can be gone back to."""
        return self._ring.first_step

    @property
    def snapshot_bytes(self) -> int:
        """What the snapshots take."""
        return self._ring.bytes

    @property
    def repeating(self) -> bool:
        """True while steps lead through a future that is remembered."""
        return self._repeating

    @property
    def checks(self) -> list[Check]:
        """Digests taken up to this step."""
        return [check for check in self._checks if check.step <= self.step]

    def digest(self) -> str:
        """Hash of the state and the step number."""
        return digest_of(self.scene.state(), self.step)

    def keep_previous(self) -> None:
        """Copy the state for the picture to start from; wanted once a frame, not once a step."""
        scene = self.scene
        scene.previous = copy_state(scene.state(), scene.previous)

    def stop(self, what: str, error: Exception) -> Fault:
        """Stand still where it is, as what was asked of the scene has raised; the fault that says so."""
        self.fault = fault_in(self.step, what, error)
        return self.fault

    def kept(self, step: int) -> tuple[Snapshot, tuple[Stamped, ...]]:
        """The latest kept state not after a step (the first one there is, if it is out of reach). Also the
        events that have acted since.
        """
        base = self._ring.before(max(step, self._ring.first_step))
        return base, tuple(self.timeline.since(base.events))

    def resume(self, snapshot: Snapshot, events: Sequence[Stamped]) -> None:
        """Go on from the state of another session of the same scene, and repeat what acted in it since."""
        self.timeline = Timeline(events)
        self._put_back(snapshot._replace(events=0))
        self._ring.forget_after(-1)
        self._ring.add(self._snapshot())
        self._repeat_events()
        self._repeating = self.timeline.has_future
        self._schedule()
        self.keep_previous()

    # -- forward ------------------------------------------------------------------------------------

    def advance(self) -> bool:
        """One step, and the events that a repeated future holds for it; False if the scene was stopped."""
        scene = self.scene
        began = perf_counter()
        try:
            scene.advance(self._dt)
        except Exception as error:
            self._stop(self.step + 1, type(error).__name__, error, self.step)
            return False
        self.timer.add(perf_counter() - began)
        self.step += 1
        bad = self._watch.first_bad(scene.state())
        if bad is not None:
            self._stop(self.step, bad, None, self.step - 1)
            return False
        if self.step >= self._next_chore:
            self._do_chores()
        if self._repeating:
            self._repeat_events()
            self._repeating = self.timeline.has_future
        return True

    def let_go(self) -> None:
        """Take back a drag that no event has ended."""
        held = self.timeline.held()
        if held is not None:
            self.let_in(Pointer("cancel", held.x, held.y))

    def let_in(self, event: StageEvent) -> None:
        """Let a checked event act now. ParameterError if the scene refuses it; then nothing has changed."""
        if self.timeline.has_future:
            held = self.timeline.held()
            self.forget_future()
            if held is not None and not _goes_on(event):
                # the hand let go in a future that is given up; a drag would stick to the pointer
                self._try(Pointer("cancel", held.x, held.y))
        elif self._ring.last_step > self.step or (self._checks and self._checks[-1].step > self.step):
            self.forget_future()  # it holds no events, but snapshots and digests of what will not come
        self._try(event)

    def _try(self, event: StageEvent) -> None:
        try:
            self._act(event)
            self._check_locks()
        except ValueError as error:
            self._return_to(self.step)
            raise error if isinstance(error, ParameterError) else ParameterError(str(error)) from error
        except Exception as error:
            self._stop(self.step, type(error).__name__, error, self.step)
            return
        state = self.scene.state()
        bad = self._watch.first_bad(state)
        if bad is not None:
            self._stop(self.step, bad, None, self.step)
            return
        self.timeline.add(self.step, event)
        if not self.recorded or len(self.timeline) > MAX_EVENTS:
            self.timeline.drop_before(self._ring.first_event)
        if not same_shapes(state, self.scene.previous):
            self.keep_previous()

    def _check_locks(self) -> None:
        """ParameterError if a hand or an action has changed a parameter that the level locks."""
        scene = self.scene
        for name, value in self._locked.items():
            if scene.values[name] != value:
                raise ParameterError(f"{scene.parameter(name).label}: {LOCKED}")

    def _act(self, event: StageEvent) -> None:
        """Hand an event to the scene."""
        scene = self.scene
        if isinstance(event, Pointer):
            scene.pointer(event)
        elif isinstance(event, Action):
            scene.action(event.name)
        elif isinstance(event, Decision):
            scene.decide(event)
        elif isinstance(event, SetEffect):
            scene.active = scene.active.with_(event.name) if event.on else scene.active.without(event.name)
            scene.effects_changed()
        else:
            self._set_parameter(event)

    def _set_parameter(self, event: SetParameter) -> None:
        """Take over a value that was checked as it came in."""
        scene, name, value = self.scene, event.name, event.value
        if scene.parameter(name).rebuild:
            self.scene = self._build({**scene.values, name: value}, scene.active)
        else:
            scene.values[name] = value
            scene.parameter_changed(name)
        if name == STEP_LENGTH:
            self._time_base_s, self._time_base_step = self.time_s, self.step
            self._dt = float(value)

    def _repeat_events(self) -> None:
        """Let the events of this step act again."""
        while (event := self.timeline.due(self.step)) is not None:
            self._act(event)

    def forget_future(self) -> None:
        """Drop all that was remembered of later steps."""
        self.timeline.drop_future()
        self._ring.forget_after(self.step)
        self._checks = self.checks
        self._repeating = False
        self._schedule()

    # -- back ---------------------------------------------------------------------------------------

    def go_back(self) -> bool:
        """Undo one step and the events since; False at the first remembered step. A fault is forgotten."""
        if self.step <= self._ring.first_step:
            return False
        self.fault = None
        self._return_to(self.step - 1)
        self._repeating = self.timeline.has_future
        return True

    def return_to(self, step: int, events: int | None = None) -> None:
        """Stand at an earlier step, from `first_step` on, as it was; what came later is forgotten.

        ``events``: only so many since the beginning have acted then.
        """
        self.fault = None
        if events is not None:
            self.timeline.drop_from(events)
        self._return_to(step)
        self.forget_future()

    def _return_to(self, step: int) -> None:
        """Stand at an earlier step, or at this one as it was before an event that failed."""
        base = self._ring.before(step)
        room = self._ring.dense_room(base)
        self._ring.forget_dense_after(step)
        self._put_back(base)
        self._repeat_events()
        while self.step < step:
            if self.step == step - 1:
                self.keep_previous()
            self.scene.advance(self._dt)
            self.step += 1
            bad = self._watch.first_bad(self.scene.state())
            if bad is not None:
                raise ArithmeticError(f"{bad} is not finite when step {self.step} is repeated")
            if step - self.step < room:
                self._ring.add_dense(self._snapshot())
            self._repeat_events()

    def _put_back(self, snapshot: Snapshot) -> None:
        """Make the scene what it was; built again if a parameter that shapes it has changed since."""
        scene, declared = self.scene, self.scene.declared_parameters()
        changed = [name for name, value in snapshot.values.items() if scene.values[name] != value]
        if any(declared[name].rebuild for name in changed):
            scene = self.scene = self._build(snapshot.values, snapshot.active)
        else:
            scene.values.update(snapshot.values)
            for name in changed:
                with suppress(
                    LimitError
                ):  # what parameters alone would lead to may be too much; the state is not
                    scene.parameter_changed(name)
        if scene.active != snapshot.active:
            scene.active = snapshot.active
            with suppress(LimitError):
                scene.effects_changed()
        scene.restore(copy_state(snapshot.state))
        recall(scene, snapshot.memory)
        if not same_shapes(snapshot.state, scene.previous):
            self.keep_previous()
        self.step, self._dt = snapshot.step, snapshot.dt
        self._time_base_s, self._time_base_step = snapshot.time_base_s, snapshot.time_base_step
        self.timeline.acted = snapshot.events

    def _stop(self, step: int, quantity: str, error: Exception | None, good_step: int) -> None:
        """Stand still at the last good state, and say what went wrong."""
        try:
            self._return_to(good_step)
        except Exception:  # what fails did so earlier, unseen: the last snapshot itself is good
            with suppress(Exception):  # a scene that cannot even be restored stays as it is, stopped
                self._put_back(self._ring.before(good_step))
            self.forget_future()
        self.fault = fault_at(step, quantity, error)

    # -- remembering --------------------------------------------------------------------------------

    def _snapshot(self) -> Snapshot:
        scene = self.scene
        return Snapshot(
            step=self.step,
            dt=self._dt,
            time_base_s=self._time_base_s,
            time_base_step=self._time_base_step,
            events=self.timeline.acted,
            values=dict(scene.values),
            active=scene.active,
            state=copy_state(scene.state()),
            memory=remember(scene),
        )

    def _do_chores(self) -> None:
        """Snapshots and digests that are due."""
        if self.step >= self._next_snapshot:
            self._ring.add(self._snapshot())
            if not self.recorded:
                self.timeline.drop_before(self._ring.first_event)
        due = self.recorded and self.step % CHECK_INTERVAL == 0
        if due and (not self._checks or self._checks[-1].step < self.step):
            self._checks.append(Check(self.step, self.digest()))
        self._schedule()

    def _schedule(self) -> None:
        """When the next chore is due."""
        latest = self._ring.before(self.step)
        self._next_snapshot = latest.step + self._ring.interval(latest)
        self._next_chore = self._next_snapshot
        if self.recorded:
            next_check = self.step + CHECK_INTERVAL - self.step % CHECK_INTERVAL
            self._next_chore = min(self._next_chore, next_check)


def _goes_on(event: StageEvent) -> bool:
    """Does an event carry on a drag that is under way?"""
    return isinstance(event, Pointer) and (event.kind in ("up", "cancel") or bool(event.button))
