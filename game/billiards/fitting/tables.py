"""The table that explains many tracks: friction, cushions and balls, found together with the strokes.

In turn: the strokes on the table as it is known, from the beginning. Then the table, each candidate with the
strokes let downhill from the best known. What is made least is the mean over the shots of the logarithm of
their error. So one shot that goes wrong early does not outweigh those that can be explained.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.fitting.errors import Goal, Ground, Target
from game.billiards.fitting.evolution import Evolution
from game.billiards.fitting.strokes import (
    EVERYTHING,
    QUICK,
    SHARP,
    Bench,
    Fit,
    fit_stroke,
    root_mean_squares,
)
from game.billiards.fitting.tracks import TableSize, TrackedShot
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import make_shot
from game.billiards.table.table import Table
from game.physics.kernels import elementary

CUSHION_HEIGHT = 0.037  # m; nose above the cloth of a carom table (UMB: 36 to 38 mm)
CAROM_MASS = 0.21  # kg
BLUR = 0.02  # m; less than that is as good as nothing, in the search for the table
ROUNDS = ((25, 1.0), (25, 0.4), (20, 0.25))  # generations, and the share of the first steps
EVALUATIONS = 60  # for each stroke of each candidate
START_OF_CAROM = Physics(
    "wallace-1988",
    "han-2005",
    sliding=0.24,
    rolling=0.005,
    spinning=0.008,
    ball_friction=0.07,
    cushion_friction=0.25,
    ball_restitution=0.94,
    cushion_restitution=0.86,
    cushion_restitution_fall=0.01,
)


class Range(NamedTuple):
    """Least, most, and the first step of a table's number."""

    least: float
    most: float
    step: float


RANGES = {
    "sliding": Range(0.05, 0.6, 0.02),
    "rolling": Range(0.001, 0.03, 0.0005),
    "spinning": Range(0.0003, 0.1, 0.003),
    "ball_friction": Range(0.005, 0.3, 0.02),
    "ball_restitution": Range(0.7, 1.0, 0.02),
    "cushion_friction": Range(0.02, 0.8, 0.03),
    "cushion_restitution": Range(0.4, 1.0, 0.03),
    "cushion_restitution_fall": Range(0.0, 0.15, 0.01),
}
COMPLIANCE = {"cushion_compliance": Range(0.1, 10.0, 0.4)}  # of the model that has it


class FittedTable(NamedTuple):
    """A table without pockets: its size, the height of its cushions' noses (m), its physics."""

    size: TableSize
    physics: Physics
    cushion_height: float = CUSHION_HEIGHT

    @property
    def table(self) -> Table:
        """As the exact table takes it."""
        return Table.bare(self.size.width, self.size.length, self.cushion_height)

    @property
    def radius(self) -> float:
        """Of its balls, m."""
        return 0.5 * self.size.ball_diameter

    @property
    def ground(self) -> Ground:
        """As the kernels of the fit take it."""
        middle = [[0.5 * self.size.width, 0.5 * self.size.length]]
        shot = make_shot(self.table, middle, radii=self.radius, masses=CAROM_MASS, physics=self.physics)
        return Ground(shot.constants, shot.layout.elements)


def free_names(physics: Physics, fixed: Iterable[str] = ()) -> dict[str, Range]:
    """The numbers to be found for this physics. fixed: those that are to stay."""
    known = {**RANGES, **(COMPLIANCE if physics.cushion == "stronge-2000" else {})}
    if physics.ball_ball in ("alciatore-2006", "frictional-alciatore"):
        known.pop("ball_friction")
    return {name: known[name] for name in known if name not in set(fixed)}


def target_of(shot: TrackedShot, table: FittedTable) -> Target:
    """A tracked shot for the kernels: its balls at rest where they were first seen."""
    places = resting_places(np.array([track.places[0] for track in shot.tracks]), table)
    ready = make_shot(table.table, places, radii=table.radius, masses=CAROM_MASS, physics=table.physics)
    samples = [np.column_stack([track.times, track.places]) for track in shot.tracks]
    ends = np.cumsum([len(rows) for rows in samples])
    ranges = np.column_stack([np.concatenate([[0], ends[:-1]]), ends]).astype(np.int64)
    return Target(ready.balls.copy(), np.concatenate(samples), ranges)


def resting_places(places: Floats, table: FittedTable) -> Floats:
    """Places (n, 2) m moved no more than needed: off the cushions, and balls off each other."""
    radius = table.radius
    low = np.full(2, radius)
    high = np.array([table.size.width, table.size.length]) - radius
    places = np.clip(places, low, high)
    for _ in range(100):
        moved = False
        for i in range(len(places)):
            for j in range(i):
                apart = places[i] - places[j]
                distance = elementary.length(*apart.tolist())
                if distance < 2.0 * radius:
                    way = apart / distance if distance > 0.0 else np.array([1.0, 0.0])
                    push = 0.5 * (2.0 * radius - distance) + 1e-9
                    places[i] = np.clip(places[i] + push * way, low, high)
                    places[j] = np.clip(places[j] - push * way, low, high)
                    moved = True
        if not moved:
            break
    return places


class TableSearch:
    """The search for a table: its training shots, their best strokes so far."""

    def __init__(
        self,
        shots: Iterable[TrackedShot],
        start: FittedTable,
        fixed: Iterable[str] = (),
        progress: Callable[[str], None] = lambda words: None,
    ) -> None:
        """fixed: names of numbers that stay as `start` has them. progress is told what is being done."""
        self.table = start
        self.benches = [Bench(target_of(shot, start)) for shot in shots]
        self.ranges = free_names(start.physics, fixed)
        self.progress = progress
        self.strokes: list[Floats] = []
        self._last: list[Floats] = []

    def run(self, rounds: tuple[tuple[int, float], ...] | None = None) -> FittedTable:
        """The table after some rounds (ROUNDS), each so many generations and a share of the first steps."""
        rounds = ROUNDS if rounds is None else rounds
        low = np.array([spread.least for spread in self.ranges.values()])
        high = np.array([spread.most for spread in self.ranges.values()])
        steps = np.array([spread.step for spread in self.ranges.values()])
        for number, (turns, share) in enumerate(rounds):
            self._find_strokes(f"round {number + 1} of {len(rounds)}")
            start = np.array([getattr(self.table.physics, name) for name in self.ranges])
            search = Evolution(np.clip(start, low, high), steps * share, seed=number)
            for turn in range(turns):
                least = search.turn(self.score)
                self.table = self._with(np.clip(search.mean, low, high))
                self._keep()
                self.progress(
                    f"round {number + 1} of {len(rounds)}: table, generation {turn + 1} of {turns},"
                    f" {100.0 * elementary.exp(least):.1f} cm"
                )
        return self.table

    def _with(self, values: Floats) -> FittedTable:
        numbers: dict[str, Any] = {
            name: float(value) for name, value in zip(self.ranges, values, strict=True)
        }
        return self.table._replace(physics=self.table.physics._replace(**numbers))

    def _find_strokes(self, words: str) -> None:
        ground = self.table.ground
        self.strokes = []
        for k, bench in enumerate(self.benches):
            self.progress(f"{words}: strokes, shot {k + 1} of {len(self.benches)}")
            self.strokes.append(fit_stroke(bench, ground, QUICK)[0].stroke)

    def score(self, values: Floats) -> float:
        """Mean over the shots of log(rms of the cue ball)/2 + log(rms of all)/2, each not below BLUR."""
        for value, spread in zip(values.tolist(), self.ranges.values(), strict=True):
            if not spread.least <= value <= spread.most:
                return 50.0
        ground = self._with(values).ground
        goal = Goal(EVERYTHING, SHARP)
        self._last = []
        total = 0.0
        for bench, stroke in zip(self.benches, self.strokes, strict=True):
            fit = bench.downhill(ground, stroke[None], goal, EVALUATIONS)[0]
            self._last.append(fit.stroke)
            total += score_of(fit)
        return total / len(self.benches)

    def _keep(self) -> None:
        """The strokes of the table as it is now are where the next candidates begin."""
        values = np.array([getattr(self.table.physics, name) for name in self.ranges])
        self.score(values)
        self.strokes = self._last


def score_of(fit: Fit) -> float:
    """Logarithm of how far off a shot is (log of m), of cue ball and of all balls alike."""
    cue, every = root_mean_squares(fit.sums)
    return 0.25 * (elementary.log(cue * cue + BLUR * BLUR) + elementary.log(every * every + BLUR * BLUR))
