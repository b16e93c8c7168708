"""Variants of a scene's step, by the effects that are on and the choices made: each is compiled once.

That takes up to seconds, so a variant is tried out on a copy of the scene before the scene itself steps so.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Mapping
from time import perf_counter
from typing import Any

from game.levels import Level
from game.physics.effects import EffectSet
from game.stage import Choice, Scene, SetEffect, SetParameter, Stage, StageEvent, Toggle
from game.stage.states.state import copy_state

STEPS, ENOUGH_S = 24, 0.05  # of a trial: so many steps, but no more than so many seconds


class Variants:
    """What has been compiled for one stage. `prepare` may be called in a thread while the scene stands."""

    def __init__(self, stage: Stage) -> None:
        self._stage = stage
        self._known = {self._key(stage.scene.values, stage.scene.active)}

    def concerns(self, event: StageEvent) -> bool:
        """Whether an event may lead to another variant; a number never does."""
        if isinstance(event, SetParameter):
            return isinstance(self._stage.scene.declared_parameters().get(event.name), Choice | Toggle)
        return isinstance(event, SetEffect)

    def prepare(self, events: Iterable[StageEvent]) -> None:
        """Compile all that these events, one after the other, lead to."""
        scene = self._stage.scene
        values, active = dict(scene.values), scene.active
        for event in events:
            if isinstance(event, SetParameter):
                values[event.name] = event.value
            elif isinstance(event, SetEffect) and event.name in scene.effects:
                active = active.with_(event.name) if event.on else active.without(event.name)
            if self.concerns(event) and self._key(values, active) not in self._known:
                self._known.add(self._key(values, active))
                with contextlib.suppress(Exception):  # the event itself says what is wrong when it comes
                    self._try_out(values, active)

    def prepare_level(self, level: Level | None) -> None:
        """Compile what a level needs; each may call for something that no other does."""
        with contextlib.suppress(Exception):
            scene = self._stage.scene_of(level)
            self._known.add(self._key(scene.values, scene.active))
            self._step(scene)

    def _try_out(self, values: Mapping[str, Any], active: EffectSet) -> None:
        """Step a copy of the scene, from the present state if it has one like it."""
        copy = self._stage.build_scene(values, active)
        with contextlib.suppress(Exception):
            copy.restore(copy_state(self._stage.scene.state()))
        self._step(copy)

    def _step(self, scene: Scene) -> None:
        began = perf_counter()
        for _ in range(STEPS):
            scene.advance(self._stage.dt)
            if perf_counter() - began > ENOUGH_S:
                break
        scene.readouts()

    def _key(self, values: Mapping[str, Any], active: EffectSet) -> tuple[Any, ...]:
        declared = self._stage.scene.declared_parameters().items()
        return active, *(
            values[name] for name, parameter in declared if isinstance(parameter, Choice | Toggle)
        )
