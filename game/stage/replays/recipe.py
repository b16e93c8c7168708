"""How the scenes of one stage are made: of which class, from which level, with which seed and step."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from game.levels import Level
from game.physics.effects import EffectSet
from game.stage.parameters import STEP_LENGTH
from game.stage.scene import Scene


class Recipe(NamedTuple):
    """``level`` None: the scene's defaults. ``seed`` and ``dt`` (s) None: as level and scene say."""

    scene_type: type[Scene]
    level: Level | None = None
    seed: int | None = None
    dt: float | None = None

    def first(self, parameters: Mapping[str, Any] | None, **choices: Any) -> Scene:
        """The scene as it was asked for: parameters, and effects by the words of Scene."""
        values = {**(parameters or {}), **self._step_length()}
        return self.scene_type(self.level, values, seed=self.seed, **choices)

    def of_level(self, level: Level | None) -> Scene:
        """A scene of a level alone, with its own seed."""
        return self.scene_type(level, self._step_length())

    def with_level(self, level: Level | None) -> Recipe:
        """The same for another level."""
        return self._replace(level=level, seed=None)

    def scene(self, values: Mapping[str, Any], active: EffectSet) -> Scene:
        """A scene with exactly these parameters and effects."""
        return self.scene_type(self.level, values, seed=self.seed, effects=active)

    def dt_of(self, scene: Scene) -> float:
        """Length of a step as the scene's parameter, the caller or the scene's class says."""
        if STEP_LENGTH in scene.values:
            return float(scene.values[STEP_LENGTH])
        return scene.dt if self.dt is None else self.dt

    def _step_length(self) -> dict[str, float]:
        """The step that the caller gave, for a scene that has a parameter for it."""
        if self.dt is None or STEP_LENGTH not in self.scene_type.declared_parameters():
            return {}
        return {STEP_LENGTH: self.dt}


def checked_seed(seed: int | None) -> int | None:
    """The seed; ValueError unless it is None or a whole number, 0 or more, of 63 bits."""
    if seed is not None and (isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**63):
        raise ValueError(f"seed = {seed!r}: expected a whole number, 0 or more")
    return seed
