"""Are the balls of a shot possible: numbers, motions and places that do not contradict each other."""

from __future__ import annotations

import math

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.contacts import CUSHION_MODELS, RESTITUTION
from game.billiards.laws.state import MOTIONS
from game.billiards.shot.physics import Physics, ShotError
from game.billiards.table.table import Table
from game.physics.kernels import elementary

OVERLAP = 1e-6  # m; balls that overlap more than this are refused
LARGEST = {"position": 1e4, "velocity": 1e4, "spin": 1e6, "radius": 1e2, "mass": 1e6}  # SI
SMALLEST = {"radius": 1e-5, "mass": 1e-9}  # SI


def check_balls(balls: Floats, table: Table, physics: Physics) -> None:
    """ShotError if a ball's numbers are absurd, or contradict each other or the table.

    balls (n, 11): columns as in `Shot`, places from a corner of the table as in a file.
    """
    for i, row in enumerate(balls.tolist()):
        fields = {
            "position": row[0:2],
            "velocity": row[2:4],
            "spin": row[4:7],
            "radius": row[7:8],
            "mass": row[8:9],
        }
        for name, values in fields.items():
            for value in values:
                if not math.isfinite(value) or abs(value) > LARGEST[name]:
                    raise ShotError(
                        f"balls[{i}].{name}: must be finite and at most {LARGEST[name]:g}, got {value!r}"
                    )
                if name in SMALLEST and value < SMALLEST[name]:
                    raise ShotError(f"balls[{i}].{name}: must be at least {SMALLEST[name]:g}, got {value!r}")
        _check_motion(i, row)
        needs_height = CUSHION_MODELS[physics.cushion] != RESTITUTION and len(table.cushions) + len(
            table.jaws
        )
        if needs_height and not abs(table.cushion_height / row[7] - 1.0) < 1.0:
            raise ShotError(
                f"table.cushion_height: {physics.cushion} needs it between 0 and twice the radius of"
                f" balls[{i}], got {table.cushion_height!r}"
            )
    _check_overlap(balls)


def _check_motion(i: int, row: list[float]) -> None:
    """The stated motion must fit velocity and spin."""
    motion = int(row[9])
    vx, vy, wx, wy, wz, radius = row[2:8]
    if motion in (s.STATIONARY, s.SPINNING) and (vx, vy, wx, wy) != (0.0, 0.0, 0.0, 0.0):
        raise ShotError(f"balls[{i}].motion: {MOTIONS[motion]}, but it has velocity or spin about x or y")
    if motion == s.STATIONARY and wz != 0.0:
        raise ShotError(f"balls[{i}].motion: stationary, but it spins about z")
    if motion == s.ROLLING:
        slip = elementary.hypot(vx - radius * wy, vy + radius * wx)
        if slip > 1e-6 * (1.0 + elementary.hypot(vx, vy)):
            raise ShotError(
                f"balls[{i}].spin: a rolling ball has spin (-vy/R, vx/R), this one slips at {slip:.3g} m/s"
            )


def _check_overlap(balls: Floats) -> None:
    present = [i for i in range(len(balls)) if int(balls[i, 9]) != s.POCKETED]
    for place, i in enumerate(present):
        for j in present[:place]:
            reach = 2.0 * math.sqrt(balls[i, 7] * balls[j, 7])
            gap = elementary.hypot(balls[i, 0] - balls[j, 0], balls[i, 1] - balls[j, 1]) - reach
            if gap < -OVERLAP:
                raise ShotError(f"balls[{j}] and balls[{i}] overlap by {-gap:.3g} m")
