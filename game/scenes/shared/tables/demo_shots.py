"""What a table does by itself: balls turned as somebody left them, the cue ball put back, strokes while the
cue is not held.

What is random is the same for the same seed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.table.aim import first_contact
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table
from game.physics.kernels import elementary, elementwise, linear

STEEPEST_CUT = math.radians(65.0)
BREAK_SPEED = 7.5  # m/s


def scattered_orientations(count: int, seed: int) -> Floats:
    """Unit quaternions (count, 4) of balls with their numbers up, as the table is drawn, a little tilted."""
    random = np.random.default_rng((seed, count))
    axes = random.normal(size=(count, 3))
    halves = linear.uniform(random, 0.1, 0.35, count)
    x, y, z = (elementwise.sin(halves) * axes.T) / np.sqrt((axes * axes).sum(axis=1))
    w, quarter = (
        elementwise.cos(halves),
        math.sqrt(0.5),
    )  # after a quarter turn about z, half of which has this sine
    return np.stack((w - z, x + y, y - x, z + w), axis=1) * quarter


def free_head_spot(table: Table, radius: float, is_free: Callable[[Floats], bool]) -> Floats | None:
    """The head spot (2,) m, or the free place nearest to it along the middle; None without one."""
    spot = np.array([0.5 * table.width, HEAD_SPOT * table.length])
    for k in range(400):
        place = spot + np.array([0.0, (k + 1) // 2 * (1 - 2 * (k % 2)) * 0.5 * radius])
        if is_free(place):
            return place
    return None


class ChosenStroke(NamedTuple):
    """Direction (rad) and speed of the cue ball (m/s)."""

    aim: float
    speed: float


def choose_stroke(
    positions: Floats, radii: Floats, in_play: NDArray[np.bool_], table: Table, seed: int, stroke: int
) -> ChosenStroke:
    """A stroke for ball 0: the ball and pocket of the straightest open pot, else the nearest ball.

    positions (n, 2) m, radii (n,) m. ``stroke`` counts strokes since the rack: the first is a break.
    """
    random = np.random.default_rng((seed, stroke))
    cue_ball = positions[0]
    others = [ball for ball in range(1, len(radii)) if in_play[ball]]
    if not others:
        return ChosenStroke(0.5 * math.pi, 1.0)
    if stroke == 0:
        apex = min(others, key=lambda ball: float(positions[ball, 1]))
        return ChosenStroke(_bearing(cue_ball, positions[apex]) + random.normal(0.0, 0.004), BREAK_SPEED)
    best: tuple[float, float, float] | None = None
    for ball in others:
        for pocket in table.pockets:
            pot = _pot(ball, pocket, positions, radii, in_play, table)
            if pot is not None and (best is None or pot[0] < best[0]):
                best = pot
    if best is None:
        nearest = min(others, key=lambda ball: float(np.sum(elementary.square(positions[ball] - cue_ball))))
        return ChosenStroke(
            _bearing(cue_ball, positions[nearest]) + random.normal(0.0, 0.01), 3.0 + 2.0 * random.random()
        )
    return ChosenStroke(best[1] + random.normal(0.0, 0.0015), best[2])


def _bearing(start: Floats, end: Floats) -> float:
    return elementary.atan2(float(end[1] - start[1]), float(end[0] - start[0]))


def _pot(
    ball: int, pocket: Floats, positions: Floats, radii: Floats, in_play: NDArray[np.bool_], table: Table
) -> tuple[float, float, float] | None:
    """Difficulty, aim and speed of sending a ball straight into a pocket; None if the path is not open."""
    path = pocket[:2] - positions[ball]
    distance = math.sqrt(float(linear.product(path, path)))
    if distance < 1e-6:
        return None
    ghost = positions[ball] - path / distance * (radii[0] + radii[ball])
    run = ghost - positions[0]
    length = math.sqrt(float(linear.product(run, run)))
    if length < 1e-6:
        return None
    cosine = float(linear.product(run, path)) / (length * distance)
    if cosine < elementary.cos(STEEPEST_CUT):
        return None
    aim = _bearing(positions[0], ghost)
    first = first_contact(0, aim, positions, radii, in_play, table)
    if first.kind != "ball" or first.target != ball:
        return None
    onward = first_contact(
        ball, elementary.atan2(float(path[1]), float(path[0])), positions, radii, in_play, table
    )
    if onward.kind != "pocket":
        return None
    difficulty = (length * distance + 0.3 * distance) / (cosine * cosine)
    return difficulty, aim, min(1.2 + 1.1 * (length + distance / cosine), 6.0)
