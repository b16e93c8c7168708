"""Exact values to hold computations against, with how each was derived.

Numbers were computed to 30 digits and along a second, independent way; all figures given are significant.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary


class Carom(NamedTuple):
    """Three balls without friction or loss on a bare table, and where they are at `time`, s.

    positions and velocities (3, 2) m, m/s. event_times: ball 0 meets ball 1; ball 1 the right wall; ball 0
    the lower wall. On its way back ball 1 passes ball 2 by 4.2 mm.
    """

    width: float
    length: float
    radius: float
    start: Floats
    velocities: Floats
    event_times: tuple[float, ...]
    time: float
    end: Floats
    end_velocities: Floats


# roots of the quadratics of contact, each flight and reflection exact
CAROM = Carom(
    width=2.54,
    length=1.27,
    radius=0.028575,
    start=np.array([[0.5, 0.6], [1.2, 0.615], [2.2, 1.12]]),
    velocities=np.array([[2.0, 0.0], [0.0, 0.0], [0.0, 0.0]]),
    event_times=(0.322426813296247, 1.02665275282392, 1.45054212668299),
    time=1.5,
    end=np.array([[1.30709736791472, 0.053626929465729], [1.62994736791472, 1.21147692946573], [2.2, 1.12]]),
    end_velocities=np.array(
        [[0.137778053333884, 0.506530665100637], [-1.86222194666612, 0.506530665100637], [0.0, 0.0]]
    ),
)


def two_balls(start: Floats, velocities: Floats, radius: float, time: float) -> Floats:
    """Positions (2, 2) m at `time` s of two equal balls that meet once, elastic, without friction.

    start, velocities (2, 2). Time of contact from |d + u t| = 2 R, its constant term written as
    (|d| - 2 R)(|d| + 2 R), which does not cancel for balls almost touching.
    """
    d = start[1] - start[0]
    u = velocities[1] - velocities[0]
    distance = math.sqrt(float(d @ d))
    a, b = float(u @ u), float(d @ u)
    c = (distance - 2.0 * radius) * (distance + 2.0 * radius)
    root = b * b - a * c
    if b >= 0.0 or root < 0.0:
        return start + velocities * time
    contact = c / (-b + math.sqrt(root))
    if contact >= time:
        return start + velocities * time
    met = start + velocities * contact
    normal = (met[1] - met[0]) / (2.0 * radius)
    swap = float(normal @ (velocities[0] - velocities[1])) * normal
    after = np.array([velocities[0] - swap, velocities[1] + swap])
    return met + after * (time - contact)


def missed_share(speed: float, dt: float, radius: float) -> float:
    """Share of hits that a test once a step misses, impact parameters even over [0, 2 R].

    With D = 2 R, c = v dt, b0 = sqrt(D^2 - c^2): P = 1 - b0/(2 D) - D/(2 c) acos(b0/D), and for c >= D P = 1
    - pi D/(4 c). A chord of the circle of contact shorter than the way of one step may fall between two
    tests. Only its first half counts, as in the second the balls part again.
    """
    d, c = 2.0 * radius, speed * dt
    if c >= d:
        return 1.0 - math.pi * d / (4.0 * c)
    b0 = math.sqrt(d * d - c * c)
    return 1.0 - b0 / (2.0 * d) - d / (2.0 * c) * elementary.acos(b0 / d)
