"""A row for each contact of two bodies in space, for any inertia: arms, effective mass, material, impulses.

    1/m_eff = 1/m_a + 1/m_b + (r_a x n)·(I_a⁻¹ (r_a x n)) + (r_b x n)·(I_b⁻¹ (r_b x n))

(Hahn 1988; Mirtich 1996). And what an impulse at a contact does to its bodies. Arrays, here and where rows
are solved: work (n + 1, WORK_COLUMNS), velocities of bodies, see spheres; contacts: `Contacts`; contact: a
line of its normals, with the gap; row: a line of rows (count, ROW_COLUMNS); a, b: its bodies.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.spheres import contacts as c
from game.physics.spheres import spheres  # fmt: skip

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
        work[i, spheres.IXX] * x * x
        + work[i, spheres.IYY] * y * y
        + work[i, spheres.IZZ] * z * z
        + 2.0 * (work[i, spheres.IXY] * x * y + work[i, spheres.IXZ] * x * z + work[i, spheres.IYZ] * y * z)
    )


@inner_kernel
def turn_body(work, i, x, y, z):
    """An angular impulse (kg m²/s) on body i."""
    work[i, spheres.WX] += work[i, spheres.IXX] * x + work[i, spheres.IXY] * y + work[i, spheres.IXZ] * z
    work[i, spheres.WY] += work[i, spheres.IXY] * x + work[i, spheres.IYY] * y + work[i, spheres.IYZ] * z
    work[i, spheres.WZ] += work[i, spheres.IXZ] * x + work[i, spheres.IYZ] * y + work[i, spheres.IZZ] * z


@inner_kernel
def push_bodies(work, row, a, b, jx, jy, jz):
    """An impulse (kg m/s) on b at its arm, and the opposite on a."""
    work[a, spheres.VX] -= work[a, spheres.WEIGHT] * jx
    work[a, spheres.VY] -= work[a, spheres.WEIGHT] * jy
    work[a, spheres.VZ] -= work[a, spheres.WEIGHT] * jz
    work[b, spheres.VX] += work[b, spheres.WEIGHT] * jx
    work[b, spheres.VY] += work[b, spheres.WEIGHT] * jy
    work[b, spheres.VZ] += work[b, spheres.WEIGHT] * jz
    turn_body(
        work, a, row[RAZ] * jy - row[RAY] * jz, row[RAX] * jz - row[RAZ] * jx, row[RAY] * jx - row[RAX] * jy
    )
    turn_body(
        work, b, row[RBY] * jz - row[RBZ] * jy, row[RBZ] * jx - row[RBX] * jz, row[RBX] * jy - row[RBY] * jx
    )


@inner_kernel
def push_along(work, row, contact, a, b, j):
    """An impulse j along the normal. A ball alone is not turned by it, not even by rounding."""
    nx, ny, nz = contact[c.NX], contact[c.NY], contact[c.NZ]
    ja, jb = work[a, spheres.WEIGHT] * j, work[b, spheres.WEIGHT] * j
    work[a, spheres.VX] -= ja * nx
    work[a, spheres.VY] -= ja * ny
    work[a, spheres.VZ] -= ja * nz
    work[b, spheres.VX] += jb * nx
    work[b, spheres.VY] += jb * ny
    work[b, spheres.VZ] += jb * nz
    turn_body(work, a, -j * row[TAX], -j * row[TAY], -j * row[TAZ])
    turn_body(work, b, j * row[TBX], j * row[TBY], j * row[TBZ])


@inner_kernel
def relative_velocity(work, row, a, b):
    """Velocity of b's contact point against a's."""
    ax = work[a, spheres.VX] + work[a, spheres.WY] * row[RAZ] - work[a, spheres.WZ] * row[RAY]
    ay = work[a, spheres.VY] + work[a, spheres.WZ] * row[RAX] - work[a, spheres.WX] * row[RAZ]
    az = work[a, spheres.VZ] + work[a, spheres.WX] * row[RAY] - work[a, spheres.WY] * row[RAX]
    bx = work[b, spheres.VX] + work[b, spheres.WY] * row[RBZ] - work[b, spheres.WZ] * row[RBY]
    by = work[b, spheres.VY] + work[b, spheres.WZ] * row[RBX] - work[b, spheres.WX] * row[RBZ]
    bz = work[b, spheres.VZ] + work[b, spheres.WX] * row[RBY] - work[b, spheres.WY] * row[RBX]
    return bx - ax, by - ay, bz - az


@inner_kernel
def normal_speed(work, row, contact, a, b):
    """How fast the contact points separate along the normal, m/s."""
    return (
        (work[b, spheres.VX] - work[a, spheres.VX]) * contact[c.NX]
        + (work[b, spheres.VY] - work[a, spheres.VY]) * contact[c.NY]
        + (work[b, spheres.VZ] - work[a, spheres.VZ]) * contact[c.NZ]
        + work[b, spheres.WX] * row[TBX] + work[b, spheres.WY] * row[TBY] + work[b, spheres.WZ] * row[TBZ]
        - work[a, spheres.WX] * row[TAX] - work[a, spheres.WY] * row[TAY] - work[a, spheres.WZ] * row[TAZ]
    )  # fmt: skip


@inner_kernel
def slip_of(work, row, contact, a, b):
    """Slip of the contact points (3 numbers, m/s), its size, and the mass that it meets."""
    ux, uy, uz = relative_velocity(work, row, a, b)
    speed = ux * contact[c.NX] + uy * contact[c.NY] + uz * contact[c.NZ]
    ux -= speed * contact[c.NX]
    uy -= speed * contact[c.NY]
    uz -= speed * contact[c.NZ]
    square = ux * ux + uy * uy + uz * uz
    if not square > 1e-300:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    weight = square * (work[a, spheres.WEIGHT] + work[b, spheres.WEIGHT])
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
    s, other = contacts.spheres[m, c.FIRST], contacts.spheres[m, c.SECOND]
    a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
    # overlap is shared in proportion to the radii, so that both arms end at one point
    reach_a, reach_b = composition.radii[s], composition.radii[other] if other >= 0 else 0.0
    scale = 1.0 + min(contact[c.GAP], 0.0) / (reach_a + reach_b)
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
    weight = work[a, spheres.WEIGHT] + work[b, spheres.WEIGHT]
    nx, ny, nz = contact[c.NX], contact[c.NY], contact[c.NZ]
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
        a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
        measure_row(state, world, places, work, contacts, m, row, numbers)
        speed = normal_speed(work, row, contact, a, b)
        touching = contact[c.GAP] <= TOUCHING * world.composition.radii[contacts.spheres[m, c.FIRST]]
        least = rest_speed(row[REBOUND], numbers)
        row[SOFT] = 0.0
        row[HIT] = row[HITX] = row[HITY] = row[HITZ] = 0.0
        row[JN] = held[m, 0] * numbers.carry
        x, y, z = held[m, 1], held[m, 2], held[m, 3]
        along = x * contact[c.NX] + y * contact[c.NY] + z * contact[c.NZ]  # as far as the normal has turned
        row[JTX] = (x - along * contact[c.NX]) * numbers.carry
        row[JTY] = (y - along * contact[c.NY]) * numbers.carry
        row[JTZ] = (z - along * contact[c.NZ]) * numbers.carry
        if speed < -least and touching:
            fastest = max(fastest, -speed)
        set_bias(contact, row, numbers)
    return fastest


@inner_kernel
def set_bias(contact, row, numbers):
    """The separating speed that a contact is to have at least; with softness, the mass it is solved with."""
    gap = contact[c.GAP]
    if gap > 0.0:
        row[BIAS] = -gap / numbers.h
    else:
        row[BIAS] = min(numbers.push * max(-gap - numbers.slop, 0.0), numbers.push_limit)
        row[SOFT] = numbers.softness
        row[MASS] *= 1.0 - numbers.softness
