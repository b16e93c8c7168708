"""The speed of a stroke in lengths of the table: how far the ball goes up and down it."""

from __future__ import annotations

from functools import lru_cache

from game.billiards.laws.state import BALL_CUSHION
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import make_shot
from game.billiards.simulation import SimulationError, simulate
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import Table

LONGEST_S = 60.0  # s; without cloth a ball would never come to rest


@lru_cache(maxsize=256)
def table_lengths(speed: float, physics: Physics, width: float, length: float) -> float:
    """Lengths of a table (m) that a ball runs which sets off without spin from one short cushion straight at
    the other, m/s: on the cloth and between the cushions of ``physics``. What it runs within LONGEST_S; inf
    where it meets cushions too often to be followed.
    """
    table, middle = Table.bare(width, length, Table.pool().cushion_height), 0.5 * width
    shot = make_shot(
        table, [[middle, BALL_RADIUS]], radii=BALL_RADIUS, masses=BALL_MASS, physics=physics, ids=("0",)
    ).struck(0, (0.0, speed, 0.0), (0.0, 0.0, 0.0))
    try:
        trajectory = simulate(shot, until=LONGEST_S)
    except SimulationError:
        return float("inf")
    way = length - 2.0 * BALL_RADIUS
    hits = int((trajectory.rows[:, 1] == BALL_CUSHION).sum())
    end = float(trajectory.state_at(trajectory.end_time).positions[0, 1]) - BALL_RADIUS
    return (hits * way + (way - end if hits % 2 else end)) / length
