"""Overlap taken away from positions alone, so that no energy comes of it.

`split` finds, for all contacts together, displacements along the normals that leave no more overlap than the
slop. It does so as accumulated impulses do it for velocities (split impulses: Bullet; Tonge and others 2012).
`projection` moves one pair after the other, with its normal as it is by then (nonlinear Gauss-Seidel: Catto,
Box2D). Both take into account how far bodies move in this step. ``shifts`` (n + 1, 4) m holds that, and what
is added to it: x, y, z, inverse mass.

Arrays: shifts (n + 1, 4); places (s, 3) m; radii (s,) m. contacts: `Contacts`; numbers: `Numbers`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.spheres import contacts as c
from game.physics.spheres.resting_contacts import STRIDE

WEIGHT_COLUMN = 3


@inner_kernel
def split_apart(contacts, count, shifts, numbers):
    """Sweeps: pushes (kg m: displacements over inverse mass), accumulated and not below 0."""
    normals, pushes = contacts.normals, contacts.pushes
    slop, share, most = numbers.slop, numbers.share, numbers.most_shift
    for m in range(count):
        pushes[m] = 0.0
    for _ in range(numbers.passes):
        for first in range(STRIDE):
            for m in range(first, count, STRIDE):
                a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
                nx, ny, nz, gap = normals[m, c.NX], normals[m, c.NY], normals[m, c.NZ], normals[m, c.GAP]
                weight_a, weight_b = shifts[a, WEIGHT_COLUMN], shifts[b, WEIGHT_COLUMN]
                moved = (
                    (shifts[b, 0] - shifts[a, 0]) * nx
                    + (shifts[b, 1] - shifts[a, 1]) * ny
                    + (shifts[b, 2] - shifts[a, 2]) * nz
                )
                old = pushes[m]
                weight = weight_a + weight_b
                lack = min(share * (-slop - gap), most) - moved
                total = max(old + lack / weight if weight > 0.0 else 0.0, 0.0)
                pushes[m] = total
                push = total - old
                shifts[a, 0] -= weight_a * push * nx
                shifts[a, 1] -= weight_a * push * ny
                shifts[a, 2] -= weight_a * push * nz
                shifts[b, 0] += weight_b * push * nx
                shifts[b, 1] += weight_b * push * ny
                shifts[b, 2] += weight_b * push * nz


@inner_kernel
def project_apart(places, radii, contacts, count, shifts, numbers):
    """Sweeps: each overlap beyond the slop is reduced by a share, at most by ``most_shift`` m."""
    normals = contacts.normals
    slop, share, most = numbers.slop, numbers.share, numbers.most_shift
    for _ in range(numbers.passes):
        for first in range(STRIDE):
            for m in range(first, count, STRIDE):
                a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
                nx, ny, nz, gap = normals[m, c.NX], normals[m, c.NY], normals[m, c.NZ], normals[m, c.GAP]
                x, y, z = (
                    shifts[b, 0] - shifts[a, 0],
                    shifts[b, 1] - shifts[a, 1],
                    shifts[b, 2] - shifts[a, 2],
                )
                s, t = contacts.spheres[m, c.FIRST], contacts.spheres[m, c.SECOND]
                if t >= 0 and gap < c.FAR:
                    x += places[t, 0] - places[s, 0]
                    y += places[t, 1] - places[s, 1]
                    z += places[t, 2] - places[s, 2]
                    length = math.sqrt(x * x + y * y + z * z)
                    if length > 0.0:
                        nx, ny, nz = x / length, y / length, z / length
                    gap = length - radii[s] - radii[t]
                else:
                    gap += x * nx + y * ny + z * nz
                weight = shifts[a, WEIGHT_COLUMN] + shifts[b, WEIGHT_COLUMN]
                lack = min(share * (-slop - gap), most)
                if lack > 0.0 and weight > 0.0:
                    push_a = shifts[a, WEIGHT_COLUMN] * lack / weight
                    push_b = shifts[b, WEIGHT_COLUMN] * lack / weight
                    shifts[a, 0] -= push_a * nx
                    shifts[a, 1] -= push_a * ny
                    shifts[a, 2] -= push_a * nz
                    shifts[b, 0] += push_b * nx
                    shifts[b, 1] += push_b * ny
                    shifts[b, 2] += push_b * nz
