"""Flight by measured coefficients: the plates' law with drag, lift and moment from a series.

Added mass, lift and drag of a spin (C_R, mu_1, mu_2) are those of the plates' law for the ellipse of the same
chord and area. No tunnel with an outline at rest can measure them. An outline moves through air at rest. Its
drag, lift and moment are the series at its angle of attack, as Martin, Umetani and Bickel (2015) take them.
Nothing remembers what was before. The law's own torque, -(1 - beta²) u_x u_y, is the moment pi/4 (1 - beta²)
sin 2 alpha, and the measured one takes its place. A drag below 0, which a series may come to between its
angles, counts as 0.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, kernel
from game.physics.kernels import elementary
from game.physics.plates import Plate
from game.physics.plates import law as la
from game.physics.plates.law import law_of
from game.physics.tunnel.fit import SeriesFit

X, Y, THETA, VX, VY, SPIN = range(6)
PART = 0.02  # of the plate's unit of time a/U that a substep is long at most
MOST_SUBSTEPS = 512


@inner_kernel
def _series(coefficients, c, s):
    """Drag, lift, moment at an angle of cosine c and sine s."""
    drag, lift, moment = coefficients[0, 0], coefficients[1, 0], coefficients[2, 0]
    p, q = c, s
    for k in range(1, coefficients.shape[1], 2):
        drag += coefficients[0, k] * p + coefficients[0, k + 1] * q
        lift += coefficients[1, k] * p + coefficients[1, k + 1] * q
        moment += coefficients[2, k] * p + coefficients[2, k + 1] * q
        p, q = p * c - q * s, p * s + q * c
    return drag, lift, moment


@inner_kernel
def _rates(motion, law, coefficients, rules):
    """Accelerations (x, y, spin) of a motion (angle, vx, vy, spin)."""
    theta, vx, vy, spin = motion
    c, s = elementary.cos(theta), elementary.sin(theta)
    ux, uy = c * vx + s * vy, c * vy - s * vx
    squared = ux * ux + uy * uy
    fx, fy, moment = 0.0, 0.0, 0.0
    if squared > 0.0:
        speed = math.sqrt(squared)
        ca, sa = -ux / speed, -uy / speed
        drag, lift, turns = _series(coefficients, ca, sa)
        drag, lift = rules[1] * max(drag, 0.0), rules[2] * lift
        strength = squared / (math.pi * law[la.HALF])
        fx, fy = strength * (drag * ca - lift * sa), strength * (drag * sa + lift * ca)
        moment = -2.0 / math.pi * squared * turns
    turn = rules[2] * law[la.TURN] * spin
    bx, by = -rules[0] * s, -rules[0] * c
    ax = (law[la.MASS_Y] * spin * uy - turn * uy + law[la.WEIGHT] * bx + fx) / law[la.MASS_X] - spin * uy
    ay = (turn * ux - law[la.MASS_X] * spin * ux + law[la.WEIGHT] * by + fy) / law[la.MASS_Y] + spin * ux
    moment -= rules[1] * (law[la.TORQUE] + law[la.TORQUE_2] * abs(spin)) * spin
    return c * ax - s * ay, s * ax + c * ay, moment / law[la.INERTIA]


@kernel
def glide(row, law, coefficients, rules, dt, substeps):
    """Go on by dt (s) in so many steps of Runge-Kutta of fourth order.

    row (6,): x, y, angle, velocity, spin; law: a column of `plates.law`; rules (3,): gravity m/s², 1 if drag
    is computed, 1 if lift is.
    """
    h = dt / substeps
    for _ in range(substeps):
        sx, sy, st, svx, svy, sw = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        kx, ky, kt, kvx, kvy, kw = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for stage in range(4):
            part = 0.0 if stage == 0 else (h if stage == 3 else 0.5 * h)
            weight = 1.0 if stage == 0 or stage == 3 else 2.0
            theta, spin = row[THETA] + part * kt, row[SPIN] + part * kw
            vx, vy = row[VX] + part * kvx, row[VY] + part * kvy
            kvx, kvy, kw = _rates((theta, vx, vy, spin), law, coefficients, rules)
            kx, ky, kt = vx, vy, spin
            sx, sy, st = sx + weight * kx, sy + weight * ky, st + weight * kt
            svx, svy, sw = svx + weight * kvx, svy + weight * kvy, sw + weight * kw
        row[X] += h / 6.0 * sx
        row[Y] += h / 6.0 * sy
        row[THETA] += h / 6.0 * st
        row[VX] += h / 6.0 * svx
        row[VY] += h / 6.0 * svy
        row[SPIN] += h / 6.0 * sw


class DataFlight:
    """One outline in still air. ``row`` (6,): x, y m, angle rad, velocity m/s, spin rad/s.

    plate: chord, inertia, thickness and what the tunnel cannot measure; series: what it has. An angle of 0
    flies with the nose to the left.
    """

    def __init__(self, plate: Plate, series: SeriesFit):
        self.plate, self.law = plate, law_of(plate)
        self.coefficients = np.ascontiguousarray(series.coefficients)
        self.row: Floats = np.zeros(6)

    def step(self, dt: float, gravity: float = 9.81, drag: bool = True, lift: bool = True) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0; FloatingPointError if it runs away."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        substeps = min(MOST_SUBSTEPS, math.ceil(dt / (PART * self.plate.time)))
        rules = np.array([gravity, float(drag), float(lift)])
        glide(self.row, self.law, self.coefficients, rules, float(dt), substeps)
        if not np.isfinite(self.row).all():
            raise FloatingPointError("the flight by measured coefficients is not finite")
