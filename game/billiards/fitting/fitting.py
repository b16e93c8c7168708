"""A whole fit: the table from training shots, then each shot's stroke on it, and what remains."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from game.billiards.fitting import errors
from game.billiards.fitting.strokes import THOROUGH, Bench, fit_stroke, polish, root_mean_squares
from game.billiards.fitting.tables import CAROM_MASS, FittedTable, TableSearch, target_of
from game.billiards.fitting.tracks import TrackedShot, TrackFile
from game.billiards.shot.cue import CUE_MASS, Strike, strike
from game.billiards.shot.shot import Shot, make_shot

Progress = Callable[[str], None]


class FittedStroke(NamedTuple):
    """A stroke with a level cue that does not squirt. azimuth rad from the x axis; speed of the ball, m/s;
    tip_left, tip_up in ball radii; start: when the ball leaves, s on the clock of the track."""

    azimuth: float
    speed: float
    tip_left: float
    tip_up: float
    start: float

    @property
    def cue_speed(self) -> float:
        """Speed of a cue of usual mass that gives the ball its speed, m/s."""
        off = 2.5 * (self.tip_left * self.tip_left + self.tip_up * self.tip_up)
        return 0.5 * self.speed * (1.0 + CAROM_MASS / CUE_MASS + off)

    def strike(self, radius: float) -> Strike:
        """Velocity and spin that it gives to a ball of that radius, m."""
        return strike(
            self.cue_speed,
            self.azimuth,
            tip_left=self.tip_left,
            tip_up=self.tip_up,
            ball_mass=CAROM_MASS,
            ball_radius=radius,
            cue_end_mass=None,
        )


class FittedShot(NamedTuple):
    """A shot with its stroke. rmse_cue, rmse_all: root of the mean squared distance between computed and
    tracked place over all samples, m: of the struck ball, and of all balls."""

    id: str
    stroke: FittedStroke
    rmse_cue: float
    rmse_all: float
    held_out: bool


def split(shots: Sequence[TrackedShot]) -> tuple[list[TrackedShot], list[TrackedShot]]:
    """Every second shot, from the first on, to train with; and the others."""
    return list(shots[::2]), list(shots[1::2])


def fit_table(
    train: Iterable[TrackedShot],
    start: FittedTable,
    fixed: Iterable[str] = (),
    progress: Progress | None = None,
) -> FittedTable:
    """The table that explains the training shots best. fixed: numbers of its physics that stay."""
    return TableSearch(train, start, fixed, progress or (lambda words: None)).run()


def fit_shot(shot: TrackedShot, table: FittedTable, held_out: bool = False) -> FittedShot:
    """The stroke that explains a shot best on this table."""
    bench = Bench(target_of(shot, table))
    ground = table.ground
    best = polish(bench, ground, fit_stroke(bench, ground, THOROUGH))
    row = best.stroke.tolist()
    stroke = FittedStroke(
        math.remainder(row[errors.DIRECTION], math.tau),
        row[errors.SPEED],
        row[errors.LEFT],
        row[errors.UP],
        row[errors.START],
    )
    return FittedShot(shot.id, stroke, *root_mean_squares(best.sums), held_out)


def fit_shots(
    shots: Sequence[TrackedShot],
    table: FittedTable,
    trained: Iterable[str] = (),
    progress: Progress | None = None,
) -> list[FittedShot]:
    """`fit_shot` of each. trained: ids of those that the table was found with."""
    known = set(trained)
    found = []
    for k, shot in enumerate(shots):
        if progress is not None:
            progress(f"strokes on the table found, shot {k + 1} of {len(shots)}")
        found.append(fit_shot(shot, table, shot.id not in known))
    return found


def computed_shot(shot: TrackedShot, fitted: FittedShot, table: FittedTable) -> Shot:
    """The shot as the exact table plays it."""
    balls = target_of(shot, table).balls
    ready = make_shot(
        table.table,
        balls[:, :2] + [0.5 * table.size.width, 0.5 * table.size.length],
        radii=table.radius,
        masses=CAROM_MASS,
        physics=table.physics,
        ids=shot.names,
    )
    blow = fitted.stroke.strike(table.radius)
    return ready.struck(0, blow.velocity, blow.spin)


def medians(shots: Sequence[FittedShot]) -> tuple[float, float]:
    """Medians of rmse_cue and rmse_all, m; nan of none."""
    if not shots:
        return math.nan, math.nan
    return (
        float(np.median([shot.rmse_cue for shot in shots])),
        float(np.median([shot.rmse_all for shot in shots])),
    )


def fit_data(file: TrackFile, table: FittedTable, shots: Sequence[FittedShot]) -> dict[str, Any]:
    """The result as plain values: table, shots."""
    physics = table.physics._asdict()
    models = {"ball_ball": physics.pop("ball_ball"), "cushion": physics.pop("cushion")}
    return {
        "format": "fit",
        "version": 1,
        "table": {
            "width": file.table.width,
            "length": file.table.length,
            "ball_diameter": file.table.ball_diameter,
            "cushion_height": table.cushion_height,
            "models": models,
            **physics,
        },
        "shots": [
            {
                "id": shot.id,
                "held_out": shot.held_out,
                "rmse_cue_m": shot.rmse_cue,
                "rmse_all_m": shot.rmse_all,
                "stroke": {**shot.stroke._asdict(), "cue_speed": shot.stroke.cue_speed},
            }
            for shot in shots
        ],
    }
