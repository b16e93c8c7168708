"""What each effect costs per step: measured on copies of the scene, a little in every frame.

A cost is the difference of two measurements made in turn, with the effect and without it, from the same
state. The median of several such differences is given. So neither a drifting processor speed nor one
interruption moves it much. What does not exceed the noise of that median counts as nothing. The scene in play
is only read.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import Any

from game.physics.effects import EffectSet
from game.stage.declarations import WarmUp
from game.stage.scene import Scene
from game.stage.stage import Stage
from game.stage.states.state import copy_state
from game.stage.warming import Warming

ROUNDS = 15  # pairs of measurements for one effect
FEW_ROUNDS = 3  # of a scene that takes longer than a frame: in the thread, as its copies come to step
MOST_STEPS = 64  # of one measurement, however cheap a step is
NOISE = 3.0  # standard errors of a median that a cost must exceed
BARE = ""  # name of the variant with every effect off


class EffectMeter:
    """Measures the effects of a stage's scene one after the other, as long as `slice` is called.

    `costs`: s per step by effect, for one that is on the time saved without it, for one that is off the time
    added with it. Effects not measured yet are missing. `bare`: s of a step with all effects off, NaN until
    measured. `done`: True when all have been measured; changing parameters or effects begins again, and
    another level forgets what was measured.

    ``clock`` gives s. Copies are built, and code of a new variant compiles, in a thread meanwhile.
    """

    def __init__(self, stage: Stage, clock: Callable[[], float] = perf_counter):
        self._stage = stage
        self._clock = clock
        self.costs: dict[str, float] = {}
        self.bare = math.nan
        self.done = False
        self._key: Any = None
        self._waiting: list[str] = []
        self._measuring: _Comparison | None = None

    def slice(self, budget_s: float) -> None:
        """Measure for about so many seconds; nothing while copies are built."""
        if self._stage.fault is not None:
            return
        end = self._clock() + budget_s
        self._begin_again_if_changed()
        while not self.done:
            if self._measuring is None:
                self._measuring = self._next()
            comparison = self._measuring
            if not comparison.ready:
                return
            if not comparison.measure(self._stage.scene.state(), budget_s):
                self._note(comparison)
                self._measuring = None
                self.done = not self._waiting
            if self._clock() >= end:
                return

    def _begin_again_if_changed(self) -> None:
        scene = self._stage.scene
        key = (id(self._stage.scene_type), scene.level, dict(scene.values), scene.active)
        if key != self._key:
            if self._key is not None and key[:2] != self._key[:2]:
                self.costs, self.bare = {}, math.nan
            self._key = key
            self._measuring = None
            self._waiting = [BARE, *self._stage.scene_type.effects.names]
            self.costs = {name: cost for name, cost in self.costs.items() if name in self._waiting}
            self.done = False

    def _next(self) -> _Comparison:
        """The next comparison; its copies are being made."""
        name = self._waiting.pop(0)
        active = self._stage.scene.active
        other = (
            EffectSet() if name == BARE else active.without(name) if name in active else active.with_(name)
        )
        return _Comparison(name, self._stage, other, self._clock)

    def _note(self, comparison: _Comparison) -> None:
        if not comparison.differences:
            return
        if comparison.name == BARE:
            self.bare = median(comparison.others)
            return
        more = _beyond_noise(comparison.differences)  # of the other variant
        self.costs[comparison.name] = -more if comparison.name in self._stage.scene.active else more


def _beyond_noise(differences: list[float]) -> float:
    """Their median, s; 0 if it is less than `NOISE` of its standard errors, by the deviations from it."""
    middle = median(differences)
    spread = 1.4826 * median(abs(one - middle) for one in differences)  # of a normal distribution
    error = 1.2533 * spread / math.sqrt(len(differences))
    return middle if abs(middle) > NOISE * error else 0.0


class _Comparison:
    """Two copies of the scene, one with other effects; measured in turn, from the present state.

    Those of a scene that takes longer than a frame are measured from the state that it begins with.
    """

    def __init__(self, name: str, stage: Stage, active: EffectSet, clock: Callable[[], float]):
        self.name = name
        self.differences: list[float] = []
        self.others: list[float] = []
        self._clock = clock
        self._dt = stage.dt
        values, before = dict(stage.scene.values), stage.scene.active
        self._builds = [lambda: stage.build_scene(values, before), lambda: stage.build_scene(values, active)]
        self._copies: list[Scene] = []
        self._steps = 0
        self._complete = False  # measured in the thread already
        self._warming = Warming([WarmUp(name, self._make)])

    def _make(self) -> None:
        """Build the copies and compile what they need: large scenes take longer than a frame may."""
        for build in self._builds:
            copy = build()
            copy.advance(self._dt)
            self._copies.append(copy)
        if self._copies[0].takes_long(None):
            for _ in range(FEW_ROUNDS):
                now, other = (self._step(copy, 1) for copy in self._copies)
                self._take(now, other)
            self._complete = True

    @property
    def ready(self) -> bool:
        """True when both variants are built and their code is compiled."""
        return self._warming.finished

    def measure(self, state: Any, budget_s: float) -> bool:
        """Take one pair of measurements; False when there are enough, or the scene will not be measured."""
        if self._complete or self._warming.errors:
            return False  # enough; or it cannot do without an effect, which then has no cost to show
        present, changed = self._copies
        try:
            if not self._steps:
                cost = max(self._time(present, state, 1), 1e-9)
                self._steps = max(1, min(MOST_STEPS, int(0.25 * budget_s / cost)))
            if len(self.differences) % 2:
                now = self._time(present, state, self._steps)
                other = self._time(changed, state, self._steps)
            else:
                other = self._time(changed, state, self._steps)
                now = self._time(present, state, self._steps)
        except Exception:  # without an effect a scene may run into what it is not made for
            return False
        self._take(now, other)
        return len(self.differences) < ROUNDS

    def _take(self, now: float, other: float) -> None:
        self.differences.append(other - now)
        self.others.append(other)

    def _time(self, scene: Scene, state: Any, steps: int) -> float:
        """Seconds of a step, from a state, on average over ``steps``."""
        scene.restore(copy_state(state))
        return self._step(scene, steps)

    def _step(self, scene: Scene, steps: int) -> float:
        """Seconds of a step, on average over ``steps``."""
        began = self._clock()
        for _ in range(steps):
            scene.advance(self._dt)
        return (self._clock() - began) / steps
