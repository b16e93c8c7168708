"""Pushing out: a vertex and the triangle that it lies in move apart along its way out, by their masses.

    λ = s d / (w + Σ β_i² w_i),   p ← p + λ w r,   q_i ← q_i - λ β_i w_i r

with depth d and way out r of the vertex, β its barycentric coordinates, w inverse masses (a constraint of
position as Müller and others 2006 solve it). Momentum stays. Speeds get no more than an inelastic impact with
Coulomb friction asks for, so that a vertex that began deep inside is not shot out.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.constraints.motion import INVERSE_MASS, VX, X
from game.physics.deformables.depth import DEPTH, OUT_X, OUT_Y
from game.physics.deformables.predicates import weights_in


@lean_kernel
def shift(fields, first, row, v, corners, beta, amount):
    """Give a vertex and, the other way, a triangle ``amount`` along (x, y) = row in rows first, first + 1."""
    a, b, c = corners
    for axis in range(2):
        step = amount * row[axis]
        fields[first + axis, v] += fields[INVERSE_MASS, v] * step
        fields[first + axis, a] -= fields[INVERSE_MASS, a] * beta[0] * step
        fields[first + axis, b] -= fields[INVERSE_MASS, b] * beta[1] * step
        fields[first + axis, c] -= fields[INVERSE_MASS, c] * beta[2] * step


@lean_kernel
def speed_along(fields, v, corners, beta, row):
    """How fast a vertex goes along a direction against the place of the triangle that it is at, m/s."""
    a, b, c = corners
    vx = fields[VX, v] - beta[0] * fields[VX, a] - beta[1] * fields[VX, b] - beta[2] * fields[VX, c]
    vy = (
        fields[VX + 1, v]
        - beta[0] * fields[VX + 1, a]
        - beta[1] * fields[VX + 1, b]
        - beta[2] * fields[VX + 1, c]
    )
    return vx * row[0] + vy * row[1]


@lean_kernel
def push_out(fields, points, store, contacts, hits, rows, shares, stiffness, friction):
    """All contacts one after the other; fields (positions, velocities) are written.

    points: where depths were measured; shares (n,): scratch, in how many triangles each vertex lies.
    """
    shares[:] = 0
    for k in range(hits):
        shares[contacts[k] & 0xFFFF_FFFF] += 1
    for k in range(hits):
        t = contacts[k] >> 32
        v = contacts[k] & 0xFFFF_FFFF
        if rows[DEPTH, v] <= 0.0:
            continue
        a = int(store.triangles[t, 0])
        b = int(store.triangles[t, 1])
        c = int(store.triangles[t, 2])
        corners = (a, b, c)
        beta = weights_in(points[v], points[a], points[b], points[c])
        mobility = (
            fields[INVERSE_MASS, v]
            + beta[0] * beta[0] * fields[INVERSE_MASS, a]
            + beta[1] * beta[1] * fields[INVERSE_MASS, b]
            + beta[2] * beta[2] * fields[INVERSE_MASS, c]
        )
        if mobility <= 0.0:
            continue
        out = (rows[OUT_X, v], rows[OUT_Y, v])
        shift(fields, X, out, v, corners, beta, stiffness * rows[DEPTH, v] / (shares[v] * mobility))
        approach = -speed_along(fields, v, corners, beta, out)
        if approach <= 0.0:
            continue
        shift(fields, VX, out, v, corners, beta, approach / mobility)
        along = (-out[1], out[0])
        slip = speed_along(fields, v, corners, beta, along)
        most = friction * approach
        shift(fields, VX, along, v, corners, beta, -min(max(slip, -most), most) / mobility)
