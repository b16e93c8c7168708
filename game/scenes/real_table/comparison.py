"""One tracked shot and what each model computes for it: the path, how far it is off its track, what it cost.

A model of the cushions gets the stroke that suits it best: that of Han's cushions, found anew, and let
downhill under the others. The table that steps, and the lecture's, play the stroke of the first.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from time import perf_counter

import numpy as np

from game.arrays import Floats
from game.billiards.fitting.errors import Goal
from game.billiards.fitting.fitting import FittedShot, FittedStroke, computed_shot
from game.billiards.fitting.strokes import EVERYTHING, PLAIN, QUICK, Bench, fit_stroke
from game.billiards.fitting.tables import FittedTable, target_of
from game.billiards.fitting.tracks import TrackedShot
from game.billiards.shot.physics import ShotError
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate
from game.physics.kernels import elementary, elementwise

MODELS = ("han", "mathavan", "stronge", "stepped", "lecture")
LABELS = {
    "han": "Exact, Han 2005",
    "mathavan": "Exact, Mathavan 2010",
    "stronge": "Exact, Stronge 2000",
    "stepped": "Stepped, Han 2005",
    "lecture": "As in the lecture",
}
DOWNHILL = 250  # strokes tried from the one that is known
PRICED = 5  # times that a shot is played to know what it costs


class Played:
    """A shot under one model. errors: for each ball, how far off it is at each of its samples, m."""

    def __init__(
        self, shot: TrackedShot, stroke: FittedStroke, table: FittedTable, model: str, **options: float
    ) -> None:
        self.stroke = stroke
        way = model if model in ("stepped", "lecture") else "exact"
        self.trajectory, self.price_s = _timed(shot, stroke, table, way, options)
        self.errors = [
            elementwise.hypot(*(self.places(track.times)[:, ball] - track.places).T)
            for ball, track in enumerate(shot.tracks)
        ]

    def places(self, times: Floats) -> Floats:
        """Places (m, n, 2) at times (m,) of the track's clock."""
        start = self.stroke.start
        return np.array([self.trajectory.state_at(time - start).positions for time in times.tolist()])

    @property
    def rmse_cue(self) -> float:
        """Root of the mean squared distance over the samples of the cue ball, m."""
        return math.sqrt(float((self.errors[0] * self.errors[0]).mean()))

    @property
    def rmse_all(self) -> float:
        """The same over the samples of all balls, m."""
        return math.sqrt(float((elementary.square(np.concatenate(self.errors))).mean()))


def _timed(
    shot: TrackedShot, stroke: FittedStroke, table: FittedTable, way: str, options: dict[str, float]
) -> tuple[Trajectory, float]:
    """The shot as it is played, and the least time that took, s."""
    ready = computed_shot(shot, FittedShot(shot.id, stroke, 0.0, 0.0, held_out=True), table)
    least = math.inf
    for _ in range(PRICED if way == "exact" else 1):
        began = perf_counter()
        played = simulate(ready, way, until=max(shot.end_time, 0.1), **options)
        least = min(least, perf_counter() - began)
    return played, least


class Comparison:
    """A tracked shot under all models; one that cannot play it is left out."""

    def __init__(
        self, shot: TrackedShot, tables: Mapping[str, FittedTable], base: FittedTable, dt: float
    ) -> None:
        """tables: for each model of the cushions. base: on it the first stroke is found. dt: of
        the table that steps, s."""
        self.shot = shot
        self.models: dict[str, Played] = {}
        bench = Bench(target_of(shot, base))
        stroke = _first_stroke(_ByName(shot), base)
        for model, table in tables.items():
            fit = bench.downhill(table.ground, stroke[None], Goal(EVERYTHING, PLAIN), DOWNHILL)[0]
            found = FittedStroke(*fit.stroke.tolist())
            self._play(model, found, table)
            if model == "han":
                stroke = fit.stroke
                self._play("stepped", found, table, dt=dt)
                self._play("lecture", found, table)

    def _play(self, model: str, stroke: FittedStroke, table: FittedTable, **options: float) -> None:
        try:
            self.models[model] = Played(self.shot, stroke, table, model, **options)
        except (ShotError, RuntimeError):
            return


class _ByName:
    """A tracked shot as a key: equal tracks, equal keys."""

    def __init__(self, shot: TrackedShot) -> None:
        self.shot = shot
        arrays = [a for track in shot.tracks for a in (track.times, track.places)]
        self._key = (shot.id, *(array.tobytes() for array in arrays))

    def __hash__(self) -> int:
        return hash(self._key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ByName) and self._key == other._key


@lru_cache(maxsize=64)
def _first_stroke(key: _ByName, table: FittedTable) -> Floats:
    """The stroke (5,) that explains a track best on a table."""
    return fit_stroke(Bench(target_of(key.shot, table)), table.ground, QUICK)[0].stroke
