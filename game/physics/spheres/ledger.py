"""A ledger of collisions: what each one did to momentum, angular momentum and energy, and what it should do.

Nothing may be lost of momentum and angular momentum (walls and fixed bodies take what they are given). The
energy must change by J · (u + u') / 2, the impulse times the mean of the contact points' relative velocities
before and after. For smooth spheres that is -(1 - e²) m_eff v_n² / 2.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres import spheres
from game.physics.spheres.contacts import GAP, SECOND

# columns of an entry: s, spheres (-1 a wall), contact point m, impulse on the second one kg m/s, separating
# speed before and after m/s, restitution, energy J: change and what it should be, momentum and angular
# momentum that are missing
(
    TIME, ONE, OTHER, X, Y, Z, JX, JY, JZ, BEFORE, AFTER, REBOUND, CHANGE, EXPECTED,
    LOST_MOMENTUM, LOST_SPIN,
) = range(16)  # fmt: skip
LEDGER_COLUMNS = 16
LEDGER_ROWS = 256


class Ledger(NamedTuple):
    """Where collisions are entered, and the scratch buffer in which a pair is weighed."""

    ring: NDArray[np.float64]  # (LEDGER_ROWS, LEDGER_COLUMNS), the last collisions
    counters: NDArray[np.float64]  # (8,), see steps.py
    sums: NDArray[np.float64]  # (2, 7) of a pair before and after: see `weigh_pair`


class Totals(NamedTuple):
    """Of all bodies together; angular momentum about the origin."""

    momentum: tuple[float, float, float]  # kg m/s
    spin: tuple[float, float, float]  # kg m²/s
    translational: float  # J
    rotational: float  # J
    potential: float  # J, above y = 0

    @property
    def energy(self) -> float:
        """J, all of it."""
        return self.translational + self.rotational + self.potential


@inner_kernel
def spin_of(work, i):
    """Angular momentum I ω (3 numbers, kg m²/s) of body i about its centre; 0 for what nothing turns."""
    a, b, c = work[i, spheres.IXX], work[i, spheres.IYY], work[i, spheres.IZZ]
    d, e, f = work[i, spheres.IXY], work[i, spheres.IXZ], work[i, spheres.IYZ]
    x, y, z = work[i, spheres.WX], work[i, spheres.WY], work[i, spheres.WZ]
    if d == 0.0 and e == 0.0 and f == 0.0:
        if a <= 0.0 or b <= 0.0 or c <= 0.0:
            return 0.0, 0.0, 0.0
        return x / a, y / b, z / c
    aa, bb, cc = b * c - f * f, a * c - e * e, a * b - d * d
    dd, ee, ff = e * f - d * c, d * f - e * b, d * e - a * f
    whole = a * aa + d * dd + e * ee
    return (
        (aa * x + dd * y + ee * z) / whole,
        (dd * x + bb * y + ff * z) / whole,
        (ee * x + ff * y + cc * z) / whole,
    )


@inner_kernel
def weigh_pair(work, positions, a, b, sums):
    """Momentum (3), angular momentum about the origin (3), kinetic energy of two bodies: sums (7,) written.

    The second one may be what nothing moves, of which nothing is counted.
    """
    for column in range(7):
        sums[column] = 0.0
    for turn in range(2):
        i = b if turn else a
        if work[i, spheres.WEIGHT] <= 0.0:
            continue
        mass = 1.0 / work[i, spheres.WEIGHT]
        vx, vy, vz = work[i, spheres.VX], work[i, spheres.VY], work[i, spheres.VZ]
        sx, sy, sz = spin_of(work, i)
        x, y, z = positions[i, 0], positions[i, 1], positions[i, 2]
        sums[0] += mass * vx
        sums[1] += mass * vy
        sums[2] += mass * vz
        sums[3] += mass * (y * vz - z * vy) + sx
        sums[4] += mass * (z * vx - x * vz) + sy
        sums[5] += mass * (x * vy - y * vx) + sz
        sums[6] += 0.5 * mass * (vx * vx + vy * vy + vz * vz)
        sums[6] += 0.5 * (sx * work[i, spheres.WX] + sy * work[i, spheres.WY] + sz * work[i, spheres.WZ])


@inner_kernel
def taken_by_fixed(weight_a, weight_b):
    """Share of the impulse on b that what nothing moves takes: 1 as b, -1 as a, 0 if both move."""
    return 1.0 if weight_b <= 0.0 else -1.0 if weight_a <= 0.0 else 0.0


@inner_kernel
def enter(entry, sums, taken):
    """Change of energy, and momentum and angular momentum that are missing: from sums (2, 7), then and now.

    entry holds contact point and impulse already. taken: 1 if nothing moves the second one, which takes the
    impulse, -1 if nothing moves the first one, 0 else.
    """
    jx, jy, jz = entry[JX] * taken, entry[JY] * taken, entry[JZ] * taken
    lost_x = sums[1, 0] - sums[0, 0] + jx
    lost_y = sums[1, 1] - sums[0, 1] + jy
    lost_z = sums[1, 2] - sums[0, 2] + jz
    spin_x = sums[1, 3] - sums[0, 3] + entry[Y] * jz - entry[Z] * jy
    spin_y = sums[1, 4] - sums[0, 4] + entry[Z] * jx - entry[X] * jz
    spin_z = sums[1, 5] - sums[0, 5] + entry[X] * jy - entry[Y] * jx
    entry[CHANGE] = sums[1, 6] - sums[0, 6]
    entry[LOST_MOMENTUM] = math.sqrt(lost_x * lost_x + lost_y * lost_y + lost_z * lost_z)
    entry[LOST_SPIN] = math.sqrt(spin_x * spin_x + spin_y * spin_y + spin_z * spin_z)


@lean_kernel
def sum_totals(state, composition, work, gravity):
    """Of all bodies: momentum (3), angular momentum about the origin (3), energy of motion, of turning and
    of height (J). ``work`` as gather_velocities left it."""
    px = py = pz = lx = ly = lz = moving = turning = height = 0.0
    for i in range(composition.masses.shape[0]):
        if work[i, spheres.WEIGHT] <= 0.0:
            continue
        ax, ay, az = state.momenta[i, 0], state.momenta[i, 1], state.momenta[i, 2]
        sx, sy, sz = state.spins[i, 0], state.spins[i, 1], state.spins[i, 2]
        x, y, z = state.positions[i, 0], state.positions[i, 1], state.positions[i, 2]
        px += ax
        py += ay
        pz += az
        lx += y * az - z * ay + sx
        ly += z * ax - x * az + sy
        lz += x * ay - y * ax + sz
        moving += 0.5 * work[i, spheres.WEIGHT] * (ax * ax + ay * ay + az * az)
        turning += 0.5 * (sx * work[i, spheres.WX] + sy * work[i, spheres.WY] + sz * work[i, spheres.WZ])
        height += composition.masses[i] * gravity * y
    return px, py, pz, lx, ly, lz, moving, turning, height


@lean_kernel
def deepest_overlap(contacts, count):
    """Deepest overlap (m) of contacts that have just been found; 0 if there is none."""
    deepest = 0.0
    for m in range(count):
        if contacts.spheres[m, SECOND] != -2:
            deepest = max(deepest, -contacts.normals[m, GAP])
    return deepest
