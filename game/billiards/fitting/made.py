"""Tracks made by the program: shots on a table that is known, seen by a camera that is not perfect.

For tests of the fit, and for the examples that are shipped: it is known what is to be found in them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.fitting.fitting import FittedShot, FittedStroke
from game.billiards.fitting.tables import CAROM_MASS, FittedTable
from game.billiards.fitting.tracks import Track, TrackedShot
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.simulation import simulate_exact
from game.physics.kernels import elementary, linear

FRAMES_HZ = 50.0
STILL = 0.003  # m; a ball that has not moved so far since its last sample is not noted again
APART = 0.15  # m; least distance of the balls' centres at the start
AT_CUSHION = 0.1  # m; least distance of a centre from the noses at the start
SPEEDS = (2.0, 4.5)  # m/s
TIP = 0.45  # ball radii; largest offset of the tip
MAX_SECONDS = 30.0


class MadeShot(NamedTuple):
    """A shot with its track, and what really was: the stroke, and the shot as it was played."""

    tracked: TrackedShot
    stroke: FittedStroke
    shot: Shot


def make_tracks(table: FittedTable, count: int, seed: int, noise: float) -> list[MadeShot]:
    """Shots with three balls at random places; the same for the same seed. noise: standard deviation of
    each coordinate of each sample, m. ValueError if it is negative or count below 1."""
    if not (0.0 <= noise <= 0.1) or count < 1:
        raise ValueError("make_tracks: needs at least one shot, and noise between 0 and 0.1 m")
    chance = np.random.default_rng(seed)
    return [_make_shot(table, str(k + 1), chance, noise) for k in range(count)]


def _make_shot(table: FittedTable, name: str, chance: np.random.Generator, noise: float) -> MadeShot:
    places = _scattered(table, chance)
    towards = places[1] - places[0]
    # at most three quarters of the way to a miss, so that the balls meet
    reach = elementary.asin(min(1.0, 1.5 * table.radius / elementary.length(*towards.tolist())))
    aim = elementary.atan2(towards[1], towards[0]) + linear.uniform(chance, -reach, reach)
    off, way = TIP * math.sqrt(linear.uniform(chance)), linear.uniform(chance, -math.pi, math.pi)
    stroke = FittedStroke(
        aim,
        linear.uniform(chance, *SPEEDS),
        off * elementary.cos(way),
        off * elementary.sin(way),
        linear.uniform(chance, 0.0, 0.02),
    )
    ready = make_shot(
        table.table, places, radii=table.radius, masses=CAROM_MASS, physics=table.physics, ids=("0", "1", "2")
    )
    blow = stroke.strike(table.radius)
    shot = ready.struck(0, blow.velocity, blow.spin)
    return MadeShot(track_shot(shot, name, stroke.start, chance, noise), stroke, shot)


def _scattered(table: FittedTable, chance: np.random.Generator) -> Floats:
    """Three places, apart from each other and from the cushions."""
    low = table.radius + AT_CUSHION
    high = np.array([table.size.width, table.size.length]) - low
    while True:
        places = linear.uniform(chance, low, high, (3, 2))
        gaps = [elementary.length(*(places[i] - places[j]).tolist()) for i in range(3) for j in range(i)]
        if min(gaps) >= APART:
            return places


def track_shot(shot: Shot, name: str, start: float, chance: np.random.Generator, noise: float) -> TrackedShot:
    """What a camera sees of a shot whose struck ball leaves at `start` s on its clock."""
    played = simulate_exact(shot, until=MAX_SECONDS)
    frames = np.arange(math.floor((start + played.end_time) * FRAMES_HZ) + 2) / FRAMES_HZ
    states = np.array([played.state_at(time - start).positions for time in frames])
    seen = states + noise * chance.standard_normal(states.shape)
    radius = float(shot.balls[0, 7])
    seen = np.clip(seen, radius, np.array([shot.table.width, shot.table.length]) - radius)
    tracks = []
    for ball in range(states.shape[1]):
        rows = _noted(states[:, ball])
        tracks.append(Track(frames[rows], seen[rows, ball]))
    return TrackedShot(name, shot.ids, tuple(tracks))


def _noted(places: Floats) -> list[int]:
    """Frames (rows) that a tracker notes of a ball at places (m, 2): the first, the last, and each in which
    it has moved."""
    rows = [0]
    for k in range(1, len(places)):
        if elementary.length(*(places[k] - places[rows[-1]]).tolist()) > STILL:
            rows.append(k)
    if rows[-1] != len(places) - 1:
        rows.append(len(places) - 1)
    return rows


def as_fitted(made: MadeShot) -> FittedShot:
    """The true stroke in the form of a found one, without an error."""
    return FittedShot(made.tracked.id, made.stroke, 0.0, 0.0, held_out=True)
