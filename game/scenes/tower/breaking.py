"""Breaks a body into pieces: same place, same motion, same mass."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementwise, linear
from game.physics.solids import Material, Polygon, SolidWorld

STOP_S = 0.05  # s: what stops a body within about so long counts as one stop
SCATTER = 0.35  # of the speed of a stop: that of the pieces it makes, apart
SLANT = 0.35  # m of length for each m across, at most: how obliquely a piece breaks


def cuts_of(wide: float, tall: float, count: int, random: np.random.Generator) -> list[Floats]:
    """Corners (4, 2) m of so many pieces of a box about its middle, cut across its longer side."""
    long, across = max(wide, tall), min(wide, tall)
    even = (np.arange(1, count) + linear.uniform(random, -0.3, 0.3, count - 1)) / count
    slants = linear.uniform(random, -SLANT, SLANT, count - 1) * min(across, 0.3 * long / count)
    ends = np.concatenate([[-0.5 * long], (even - 0.5) * long, [0.5 * long]])
    tilts = np.concatenate([[0.0], slants, [0.0]])
    pieces = []
    for k in range(count):
        a, b, s, t = ends[k], ends[k + 1], tilts[k], tilts[k + 1]
        piece = np.array(
            [(a - s, -0.5 * across), (b - t, -0.5 * across), (b + t, 0.5 * across), (a + s, 0.5 * across)]
        )
        pieces.append(piece if wide >= tall else np.stack([-piece[:, 1], piece[:, 0]], axis=1))
    return pieces


def halves_of(corners: Floats, random: np.random.Generator) -> list[Floats]:
    """A convex quadrangle in two, across its longer pair of sides."""
    sides = elementwise.hypot(*(np.roll(corners, -1, axis=0) - corners).T)
    if sides[0] + sides[2] < sides[1] + sides[3]:
        corners = np.roll(corners, -1, axis=0)
    s, t = linear.uniform(random, 0.35, 0.65, 2)
    a, b, c, d = corners
    p, q = a + s * (b - a), d + t * (c - d)
    return [np.array([a, p, q, d]), np.array([p, b, c, q])]


def middle_of(corners: Floats) -> tuple[float, float, float]:
    """Centre of mass (m) and area (m²) of a convex polygon (n, 2)."""
    after = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * after[:, 1] - after[:, 0] * corners[:, 1]
    area = 0.5 * float(cross.sum())
    x, y = (cross[:, None] * (corners + after)).sum(axis=0) / (6.0 * area)
    return float(x), float(y), area


def apart(pieces: Sequence[Floats], stopped: float, random: np.random.Generator) -> Floats:
    """m/s (n, 2) at which pieces fly apart where a stop has taken ``stopped`` m/s from their body.

    Those to the left fly to the left and those to the right to the right, all up by less: SCATTER squared of
    the energy that was lost, at most.
    """
    middles = np.array([middle_of(corners)[0] for corners in pieces])
    side = np.sign(middles - middles.mean())
    speeds = SCATTER * stopped * linear.uniform(random, 0.3, 1.0, (len(pieces), 2))
    return np.asarray(speeds * np.column_stack([side, np.full(len(pieces), 0.5)]))


def break_up(
    world: SolidWorld, body: int, pieces: Sequence[Floats], material: Material, thrown: Floats | None = None
) -> list[tuple[int, float, float, float]]:
    """Put pieces, corners in the frame of a body, in its place: (body, kg, breadth, height m) of each.

    thrown: (n, 2) m/s that each gets beside the body's own motion; what their momenta sum to is taken off.
    """
    rows = world.bodies
    x, y = rows.positions[body].tolist()
    angle, (vx, vy) = float(rows.angles[body]), rows.velocities[body].tolist()
    spin, (c, s) = float(rows.spins[body]), rows.rotations[body].tolist()
    world.remove_body(body)
    middles = [middle_of(corners) for corners in pieces]
    extra = np.zeros((len(pieces), 2)) if thrown is None else thrown.copy()
    areas = np.array([area for _, _, area in middles])
    extra -= (areas[:, None] * extra).sum(axis=0) / areas.sum()
    made = []
    for corners, (mx, my, area), (ex, ey) in zip(pieces, middles, extra.tolist(), strict=True):
        rx, ry = c * mx - s * my, s * mx + c * my
        new = world.add_body(
            Polygon(corners, material=material), (x, y), angle,
            (vx - spin * ry + ex, vy + spin * rx + ey), spin,
        )  # fmt: skip
        wide, tall = np.ptp(corners, axis=0).tolist()
        made.append((new, material.density * area, wide, tall))
    return made


def shocks_of(shocks: Floats, before: Floats, after: Floats, dt: float) -> Floats:
    """m/s (n,) that bodies have lost of their speed lately, a step of dt (s) on: what was lost earlier fades.

    before, after: velocities (n, 2) m/s. So a stop counts as one whether it takes one step or ten.
    """
    lost = elementwise.hypot(*before.T) - elementwise.hypot(*after.T)
    return np.asarray(shocks / (1.0 + dt / STOP_S) + np.maximum(lost, 0.0))


def grind(world: SolidWorld, bodies: Longs, kilograms: float) -> Floats:
    """Take so much mass from bodies, from each by its share of it; kg (n,) that they have then."""
    rows = world.bodies
    masses = 1.0 / rows.inverse_masses[bodies]
    left = masses - kilograms * masses / masses.sum()
    rows.inverse_inertias[bodies] *= masses / left
    rows.inverse_masses[bodies] = 1.0 / left
    return np.asarray(left)
