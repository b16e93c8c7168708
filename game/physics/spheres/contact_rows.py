"""A row for each contact of two bodies in space, for any inertia: arms, effective mass, material, impulses.

    1/m_eff = 1/m_a + 1/m_b + (r_a x n)·(I_a⁻¹ (r_a x n)) + (r_b x n)·(I_b⁻¹ (r_b x n))

(Hahn 1988; Mirtich 1996). And what an impulse at a contact does to its bodies. Arrays, here and where rows
are solved: work (n + 1, WORK_COLUMNS), velocities of bodies, see spheres; contacts: `Contacts`; contact: a
line of its normals, with the gap; row: a line of rows (count, ROW_COLUMNS); a, b: its bodies.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.spheres.contacts import FIRST, GAP, NX, NY, NZ, SECOND
from game.physics.spheres.spheres import (
    IXX,
    IXY,
    IXZ,
    IYY,
    IYZ,
    IZZ,
    VX,
    VY,
    VZ,
    WEIGHT,
    WX,
    WY,
    WZ,
)  # fmt: skip

# columns of a row: least separating speed to reach, effective mass, softness, friction, restitution, impulse
# along the normal, of friction (3), arms (3 each), arms x normal (3 each), impulse of collisions (4),
# separating speed before it, and of a joint round: impulse so far, least separating speed to reach
(
    BIAS, MASS, SOFT, MU, REBOUND, JN, JTX, JTY, JTZ, RAX, RAY, RAZ, RBX, RBY, RBZ,
    TAX, TAY, TAZ, TBX, TBY, TBZ, HIT, HITX, HITY, HITZ, BEFORE,
    JOINT, TARGET,
) = range(28)  # fmt: skip
ROW_COLUMNS = 28
TOUCHING = 1e-9  # of the radius: a gap up to this is none
STILL = 1e-12  # of the fastest approach: slower ones are rounding
STRING = -2  # in place of a second sphere


@inner_kernel
def angular_weight(work, i, x, y, z):
    """t · (I⁻¹ t) of body i, 1/kg."""
    return (
        work[i, IXX] * x * x
        + work[i, IYY] * y * y
        + work[i, IZZ] * z * z
        + 2.0 * (work[i, IXY] * x * y + work[i, IXZ] * x * z + work[i, IYZ] * y * z)
    )


@inner_kernel
def turn_body(work, i, x, y, z):
    """An angular impulse (kg m²/s) on body i."""
    work[i, WX] += work[i, IXX] * x + work[i, IXY] * y + work[i, IXZ] * z
    work[i, WY] += work[i, IXY] * x + work[i, IYY] * y + work[i, IYZ] * z
    work[i, WZ] += work[i, IXZ] * x + work[i, IYZ] * y + work[i, IZZ] * z


@inner_kernel
def push_bodies(work, row, a, b, jx, jy, jz):
    """An impulse (kg m/s) on b at its arm, and the opposite on a."""
    work[a, VX] -= work[a, WEIGHT] * jx
    work[a, VY] -= work[a, WEIGHT] * jy
    work[a, VZ] -= work[a, WEIGHT] * jz
    work[b, VX] += work[b, WEIGHT] * jx
    work[b, VY] += work[b, WEIGHT] * jy
    work[b, VZ] += work[b, WEIGHT] * jz
    turn_body(
        work, a, row[RAZ] * jy - row[RAY] * jz, row[RAX] * jz - row[RAZ] * jx, row[RAY] * jx - row[RAX] * jy
    )
    turn_body(
        work, b, row[RBY] * jz - row[RBZ] * jy, row[RBZ] * jx - row[RBX] * jz, row[RBX] * jy - row[RBY] * jx
    )


@inner_kernel
def push_along(work, row, contact, a, b, j):
    """An impulse j along the normal. A ball alone is not turned by it, not even by rounding."""
    nx, ny, nz = contact[NX], contact[NY], contact[NZ]
    ja, jb = work[a, WEIGHT] * j, work[b, WEIGHT] * j
    work[a, VX] -= ja * nx
    work[a, VY] -= ja * ny
    work[a, VZ] -= ja * nz
    work[b, VX] += jb * nx
    work[b, VY] += jb * ny
    work[b, VZ] += jb * nz
    turn_body(work, a, -j * row[TAX], -j * row[TAY], -j * row[TAZ])
    turn_body(work, b, j * row[TBX], j * row[TBY], j * row[TBZ])


@inner_kernel
def relative_velocity(work, row, a, b):
    """Velocity of b's contact point against a's."""
    ax = work[a, VX] + work[a, WY] * row[RAZ] - work[a, WZ] * row[RAY]
    ay = work[a, VY] + work[a, WZ] * row[RAX] - work[a, WX] * row[RAZ]
    az = work[a, VZ] + work[a, WX] * row[RAY] - work[a, WY] * row[RAX]
    bx = work[b, VX] + work[b, WY] * row[RBZ] - work[b, WZ] * row[RBY]
    by = work[b, VY] + work[b, WZ] * row[RBX] - work[b, WX] * row[RBZ]
    bz = work[b, VZ] + work[b, WX] * row[RBY] - work[b, WY] * row[RBX]
    return bx - ax, by - ay, bz - az


@inner_kernel
def normal_speed(work, row, contact, a, b):
    """How fast the contact points separate along the normal, m/s."""
    return (
        (work[b, VX] - work[a, VX]) * contact[NX]
        + (work[b, VY] - work[a, VY]) * contact[NY]
        + (work[b, VZ] - work[a, VZ]) * contact[NZ]
        + work[b, WX] * row[TBX] + work[b, WY] * row[TBY] + work[b, WZ] * row[TBZ]
        - work[a, WX] * row[TAX] - work[a, WY] * row[TAY] - work[a, WZ] * row[TAZ]
    )  # fmt: skip


@inner_kernel
def slip_of(work, row, contact, a, b):
    """Slip of the contact points (3 numbers, m/s), its size, and the mass that it meets."""
    ux, uy, uz = relative_velocity(work, row, a, b)
    speed = ux * contact[NX] + uy * contact[NY] + uz * contact[NZ]
    ux -= speed * contact[NX]
    uy -= speed * contact[NY]
    uz -= speed * contact[NZ]
    square = ux * ux + uy * uy + uz * uz
    if not square > 1e-300:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    weight = square * (work[a, WEIGHT] + work[b, WEIGHT])
    weight += angular_weight(
        work, a, row[RAY] * uz - row[RAZ] * uy, row[RAZ] * ux - row[RAX] * uz, row[RAX] * uy - row[RAY] * ux
    )
    weight += angular_weight(
        work, b, row[RBY] * uz - row[RBZ] * uy, row[RBZ] * ux - row[RBX] * uz, row[RBX] * uy - row[RBY] * ux
    )
    return ux, uy, uz, math.sqrt(square), square / weight if weight > 0.0 else 0.0


@inner_kernel
def rest_speed(e, numbers):
    """Approach (m/s) below which a contact does not bounce: 4 g h / (1 - e²), as overlap makes energy.

    From e = 0.9 on it grows no more; with e = 1 nothing is lost that could hide it, so 2 g h is taken.
    """
    fall = numbers.rest * abs(numbers.gravity) * numbers.nominal
    if e >= 1.0:
        return 0.5 * fall
    return fall / max(1.0 - e * e, 0.19)


@inner_kernel
def is_apart(offsets, s):
    """True if a sphere's centre is not its body's."""
    return offsets[s, 0] != 0.0 or offsets[s, 1] != 0.0 or offsets[s, 2] != 0.0


@inner_kernel
def measure_row(state, world, places, work, contacts, m, row, numbers):
    """Fill in the arms, effective mass and material of contact m."""
    composition, tables, contact = world.composition, world.tables, contacts.normals[m]
    s, other = contacts.spheres[m, FIRST], contacts.spheres[m, SECOND]
    a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
    # overlap is shared in proportion to the radii, so that both arms end at one point
    reach_a, reach_b = composition.radii[s], composition.radii[other] if other >= 0 else 0.0
    scale = 1.0 + min(contact[GAP], 0.0) / (reach_a + reach_b)
    for axis in range(3):
        row[RAX + axis] = contact[axis] * scale * reach_a + (places[s, axis] - state.positions[a, axis])
        row[RBX + axis] = 0.0
        row[TAX + axis] = 0.0
        row[TBX + axis] = 0.0
    if other >= 0:
        for axis in range(3):
            row[RBX + axis] = (places[other, axis] - state.positions[b, axis]) - contact[
                axis
            ] * scale * reach_b
    weight = work[a, WEIGHT] + work[b, WEIGHT]
    nx, ny, nz = contact[NX], contact[NY], contact[NZ]
    if is_apart(composition.offsets, s):
        row[TAX] = row[RAY] * nz - row[RAZ] * ny
        row[TAY] = row[RAZ] * nx - row[RAX] * nz
        row[TAZ] = row[RAX] * ny - row[RAY] * nx
        weight += angular_weight(work, a, row[TAX], row[TAY], row[TAZ])
    if other >= 0 and is_apart(composition.offsets, other):
        row[TBX] = row[RBY] * nz - row[RBZ] * ny
        row[TBY] = row[RBZ] * nx - row[RBX] * nz
        row[TBZ] = row[RBX] * ny - row[RBY] * nx
        weight += angular_weight(work, b, row[TBX], row[TBY], row[TBZ])
    row[MASS] = 1.0 / weight if weight > 0.0 else 0.0
    last = tables.restitution.shape[0] - 1
    kind = composition.kinds[other] if other >= 0 else last
    bare = other == STRING
    row[REBOUND] = 0.0 if bare else tables.restitution[composition.kinds[s], kind]
    row[MU] = 0.0 if bare else tables.friction[composition.kinds[s], kind] * numbers.rough


@inner_kernel
def prepare_rows(state, world, places, work, contacts, count, rows, numbers):
    """Rows of all contacts (count, ROW_COLUMNS) written; returns the fastest approach that bounces, m/s.

    The contacts' impulses are those of the last step.
    """
    held = contacts.impulses
    fastest = 0.0
    for m in range(count):
        contact, row = contacts.normals[m], rows[m]
        a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
        measure_row(state, world, places, work, contacts, m, row, numbers)
        speed = normal_speed(work, row, contact, a, b)
        touching = contact[GAP] <= TOUCHING * world.composition.radii[contacts.spheres[m, FIRST]]
        least = rest_speed(row[REBOUND], numbers)
        row[SOFT] = 0.0
        row[HIT] = row[HITX] = row[HITY] = row[HITZ] = 0.0
        row[JN] = held[m, 0] * numbers.carry
        x, y, z = held[m, 1], held[m, 2], held[m, 3]
        along = x * contact[NX] + y * contact[NY] + z * contact[NZ]  # as far as the normal has turned
        row[JTX] = (x - along * contact[NX]) * numbers.carry
        row[JTY] = (y - along * contact[NY]) * numbers.carry
        row[JTZ] = (z - along * contact[NZ]) * numbers.carry
        if speed < -least and touching:
            fastest = max(fastest, -speed)
        set_bias(contact, row, numbers)
    return fastest


@inner_kernel
def set_bias(contact, row, numbers):
    """The separating speed that a contact is to have at least; with softness, the mass it is solved with."""
    gap = contact[GAP]
    if gap > 0.0:
        row[BIAS] = -gap / numbers.h
    else:
        row[BIAS] = min(numbers.push * max(-gap - numbers.slop, 0.0), numbers.push_limit)
        row[SOFT] = numbers.softness
        row[MASS] *= 1.0 - numbers.softness
