"""Impulses between two bodies at a touch, in three dimensions, for any inertia.

Collisions: an impulse along the normal turns the approach v_n of the contact points into -e v_n,
    j = -(1 + e) v_n m_eff,  1/m_eff = 1/m_a + 1/m_b + (r_a x n)·(I_a⁻¹ (r_a x n)) + ...
and Coulomb's friction stops the slip or takes mu j (Hahn 1988; Mirtich 1996). One touch after the other,
again until none approaches: what happens in Newton's cradle. Or all at once, by accumulated impulses that
only push: Newton's law at every touch.

Bearing: after the forces have acted, impulses that stop what still approaches, accumulated and clamped,
warm started (Catto 2005, "Iterative dynamics with temporal coherence").
"""

from __future__ import annotations

import math

from game.physics.lean import inner_kernel, lean_kernel
from game.physics.rigid import ledger
from game.physics.rigid.contacts import FAR, FIRST, GAP, NX, NY, NZ, SECOND
from game.physics.rigid.ledger import weigh_pair
from game.physics.rigid.spheres import (
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
)

# columns of a row: least separating speed wanted, effective mass, softness, friction, restitution, impulse
# along the normal, of friction (3), arms (3 each), arms x normal (3 each), impulse of collisions (4)
(
    BIAS, MASS, SOFT, MU, REBOUND, JN, JTX, JTY, JTZ, RAX, RAY, RAZ, RBX, RBY, RBZ,
    TAX, TAY, TAZ, TBX, TBY, TBZ, HIT, HITX, HITY, HITZ, BEFORE,
) = range(26)  # fmt: skip
ROW_COLUMNS = 26
TOUCHING = 1e-9  # of the radius: a gap up to this is none
STILL = 1e-12  # of the fastest approach: slower ones are rounding
STRING = -2  # in place of a second sphere
STRIDE = 4  # touches are swept in strides, so that one need not wait for the result of the one before


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
def push_along(work, row, touch, a, b, j):
    """An impulse j along the normal. A ball alone is not turned by it, not even by rounding."""
    nx, ny, nz = touch[NX], touch[NY], touch[NZ]
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
def normal_speed(work, row, touch, a, b):
    """How fast the contact points separate along the normal, m/s."""
    return (
        (work[b, VX] - work[a, VX]) * touch[NX]
        + (work[b, VY] - work[a, VY]) * touch[NY]
        + (work[b, VZ] - work[a, VZ]) * touch[NZ]
        + work[b, WX] * row[TBX] + work[b, WY] * row[TBY] + work[b, WZ] * row[TBZ]
        - work[a, WX] * row[TAX] - work[a, WY] * row[TAY] - work[a, WZ] * row[TAZ]
    )  # fmt: skip


@inner_kernel
def rest_speed(e, numbers):
    """Approach (m/s) below which a touch does not bounce: 4 g h / (1 - e²), as overlap makes energy.

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
def measure_row(work, makeup, state, places, touch, row, who, a, b, tables, numbers):
    """Fill in the arms, effective mass and material of one touch."""
    s, other = who[FIRST], who[SECOND]
    # overlap is shared in proportion to the radii, so that both arms end at one point
    reach_a, reach_b = makeup.radii[s], makeup.radii[other] if other >= 0 else 0.0
    scale = 1.0 + min(touch[GAP], 0.0) / (reach_a + reach_b)
    for axis in range(3):
        row[RAX + axis] = touch[axis] * scale * reach_a + (places[s, axis] - state.positions[a, axis])
        row[RBX + axis] = 0.0
        row[TAX + axis] = 0.0
        row[TBX + axis] = 0.0
    if other >= 0:
        for axis in range(3):
            row[RBX + axis] = (places[other, axis] - state.positions[b, axis]) - touch[axis] * scale * reach_b
    weight = work[a, WEIGHT] + work[b, WEIGHT]
    nx, ny, nz = touch[NX], touch[NY], touch[NZ]
    if is_apart(makeup.offsets, s):
        row[TAX] = row[RAY] * nz - row[RAZ] * ny
        row[TAY] = row[RAZ] * nx - row[RAX] * nz
        row[TAZ] = row[RAX] * ny - row[RAY] * nx
        weight += angular_weight(work, a, row[TAX], row[TAY], row[TAZ])
    if other >= 0 and is_apart(makeup.offsets, other):
        row[TBX] = row[RBY] * nz - row[RBZ] * ny
        row[TBY] = row[RBZ] * nx - row[RBX] * nz
        row[TBZ] = row[RBX] * ny - row[RBY] * nx
        weight += angular_weight(work, b, row[TBX], row[TBY], row[TBZ])
    row[MASS] = 1.0 / weight if weight > 0.0 else 0.0
    last = tables.restitution.shape[0] - 1
    kind = makeup.kinds[other] if other >= 0 else last
    bare = other == STRING
    row[REBOUND] = 0.0 if bare else tables.restitution[makeup.kinds[s], kind]
    row[MU] = 0.0 if bare else tables.friction[makeup.kinds[s], kind] * numbers.rough


@inner_kernel
def prepare_rows(state, makeup, places, work, touches, who, ids, held, count, tables, numbers, rows):
    """Rows of all touches (count, ROW_COLUMNS) written; returns the fastest approach that bounces, m/s.

    held: (count, 4) impulses of the last step.
    """
    fastest = 0.0
    for m in range(count):
        touch, row = touches[m], rows[m]
        a, b = ids[m, FIRST], ids[m, SECOND]
        measure_row(work, makeup, state, places, touch, row, who[m], a, b, tables, numbers)
        speed = normal_speed(work, row, touch, a, b)
        touching = touch[GAP] <= TOUCHING * makeup.radii[who[m, FIRST]]
        least = rest_speed(row[REBOUND], numbers)
        row[BEFORE] = speed
        row[SOFT] = 0.0
        row[HIT] = row[HITX] = row[HITY] = row[HITZ] = 0.0
        row[JN] = held[m, 0] * numbers.carry
        x, y, z = held[m, 1], held[m, 2], held[m, 3]
        along = x * touch[NX] + y * touch[NY] + z * touch[NZ]  # as far as the normal has turned
        row[JTX] = (x - along * touch[NX]) * numbers.carry
        row[JTY] = (y - along * touch[NY]) * numbers.carry
        row[JTZ] = (z - along * touch[NZ]) * numbers.carry
        if speed < -least and touching:
            fastest = max(fastest, -speed)
        set_bias(touch, row, numbers)
    return fastest


@inner_kernel
def set_bias(touch, row, numbers):
    """The separating speed that a touch is to have at least; with softness, the mass it is solved with."""
    gap = touch[GAP]
    if gap > 0.0:
        row[BIAS] = -gap / numbers.h
    else:
        row[BIAS] = min(numbers.push * max(-gap - numbers.slop, 0.0), numbers.push_limit)
        row[SOFT] = numbers.softness
        row[MASS] *= 1.0 - numbers.softness


@inner_kernel
def collide(work, row, touch, a, b, j):
    """An impulse j along the normal with its friction, added to what the row has of collisions."""
    push_along(work, row, touch, a, b, j)
    row[HIT] += j
    if row[MU] > 0.0:
        ux, uy, uz, slip, mass = slip_of(work, row, touch, a, b)
        if slip > 0.0:
            part = -min(mass, row[MU] * j / slip)
            push_bodies(work, row, a, b, part * ux, part * uy, part * uz)
            row[HITX] += part * ux
            row[HITY] += part * uy
            row[HITZ] += part * uz


@inner_kernel
def slip_of(work, row, touch, a, b):
    """Slip of the contact points (3 numbers, m/s), its size, and the mass that it meets."""
    ux, uy, uz = relative_velocity(work, row, a, b)
    speed = ux * touch[NX] + uy * touch[NY] + uz * touch[NZ]
    ux -= speed * touch[NX]
    uy -= speed * touch[NY]
    uz -= speed * touch[NZ]
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
def collide_and_enter(work, positions, row, touch, who, a, b, j, speed, ring, counters, sums):
    """A collision, entered into the ledger."""
    entry = ring[int(counters[2]) % ring.shape[0]]
    weigh_pair(work, positions, a, b, sums[0])
    ux, uy, uz = relative_velocity(work, row, a, b)
    hit, x, y, z = row[HIT], row[HITX], row[HITY], row[HITZ]
    collide(work, row, touch, a, b, j)
    jx = (row[HIT] - hit) * touch[NX] + row[HITX] - x
    jy = (row[HIT] - hit) * touch[NY] + row[HITY] - y
    jz = (row[HIT] - hit) * touch[NZ] + row[HITZ] - z
    wx, wy, wz = relative_velocity(work, row, a, b)
    weigh_pair(work, positions, a, b, sums[1])
    entry[ledger.TIME] = counters[0]
    entry[ledger.ONE], entry[ledger.OTHER] = who[FIRST], max(who[SECOND], -1)
    entry[ledger.X] = positions[a, 0] + row[RAX]
    entry[ledger.Y] = positions[a, 1] + row[RAY]
    entry[ledger.Z] = positions[a, 2] + row[RAZ]
    entry[ledger.JX], entry[ledger.JY], entry[ledger.JZ] = jx, jy, jz
    entry[ledger.BEFORE] = speed
    entry[ledger.AFTER] = wx * touch[NX] + wy * touch[NY] + wz * touch[NZ]
    entry[ledger.REBOUND] = row[REBOUND]
    entry[ledger.EXPECTED] = 0.5 * (jx * (ux + wx) + jy * (uy + wy) + jz * (uz + wz))
    ledger.enter(entry, sums, 1.0 if who[SECOND] < 0 else 0.0)
    counters[2] += 1.0


@lean_kernel
def collide_in_turn(
    work, positions, radii, touches, who, ids, count, rows, fastest, numbers, ring, counters, sums
):  # fmt: skip
    """Collisions one after the other, in rounds, until none approaches. Returns rounds and impulses made.

    ring, counters, sums (2, 7): the ledger (see ledger.py) that each is entered into.
    """
    made = 0
    for turn in range(numbers.rounds):
        changed = False
        for m in range(count):
            touch, row = touches[m], rows[m]
            a, b = ids[m, FIRST], ids[m, SECOND]
            if touch[GAP] > TOUCHING * radii[who[m, FIRST]]:
                continue
            speed = normal_speed(work, row, touch, a, b)
            least = max(rest_speed(row[REBOUND], numbers), STILL * fastest)
            if speed < -least and row[MASS] > 0.0:
                mass = row[MASS] / (1.0 - row[SOFT])
                j = -(1.0 + row[REBOUND]) * speed * mass
                collide_and_enter(work, positions, row, touch, who[m], a, b, j, speed, ring, counters, sums)
                made += 1
                changed = True
        if not changed:
            return turn, made
    return numbers.rounds, made


@lean_kernel
def collide_at_once(
    work, positions, radii, touches, who, ids, count, rows, fastest, numbers, ring, counters, sums
):  # fmt: skip
    """Newton's law at all touches together: v_n' >= -e v_n, impulses push or are nought.

    Accumulated impulses are swept until nothing changes. Returns sweeps and touches that bounced. In the
    ledger each touch has its share of the joint collision, as if it came after those before it.
    """
    made = 0
    for turn in range(numbers.rounds):
        change = 0.0
        for m in range(count):
            touch, row = touches[m], rows[m]
            a, b = ids[m, FIRST], ids[m, SECOND]
            if touch[GAP] > TOUCHING * radii[who[m, FIRST]]:
                continue
            bounces = row[BEFORE] < -rest_speed(row[REBOUND], numbers)
            made += int(bounces and turn == 0)
            wanted = -row[REBOUND] * row[BEFORE] if bounces else min(row[BEFORE], 0.0)
            speed = normal_speed(work, row, touch, a, b)
            mass = row[MASS] / (1.0 - row[SOFT])
            j = max(row[HIT] - (speed - wanted) * mass, 0.0) - row[HIT]
            change = max(change, abs(speed - wanted) if j != 0.0 else 0.0)
            push_along(work, row, touch, a, b, j)
            row[HIT] += j
        if change <= 1e-15 * fastest:
            break
    for m in range(count):
        row = rows[m]
        j = row[HIT]
        if j > 0.0:
            # taken back and made again, with its friction, so that it can be entered
            a, b = ids[m, FIRST], ids[m, SECOND]
            push_along(work, row, touches[m], a, b, -j)
            row[HIT] = 0.0
            collide_and_enter(
                work, positions, row, touches[m], who[m], a, b, j, row[BEFORE], ring, counters, sums
            )
    return turn + 1, made


@inner_kernel
def pass_over(work, touches, ids, count, rows, numbers):
    """After the collisions: a gap that is closing too fast to be borne takes no part until it has closed."""
    for m in range(count):
        touch, row = touches[m], rows[m]
        if touch[GAP] > 0.0 and row[BIAS] < 0.0:
            speed = normal_speed(work, row, touch, ids[m, FIRST], ids[m, SECOND])
            if speed < -rest_speed(row[REBOUND], numbers):
                touch[GAP] = FAR
                row[BIAS] = -FAR / numbers.h
                row[JN] = row[JTX] = row[JTY] = row[JTZ] = 0.0


@inner_kernel
def start_warm(work, touches, ids, count, rows):
    """Begin with the impulses of the last step."""
    for m in range(count):
        row = rows[m]
        a, b = ids[m, FIRST], ids[m, SECOND]
        if row[JN] > 0.0:
            push_along(work, row, touches[m], a, b, row[JN])
            push_bodies(work, row, a, b, row[JTX], row[JTY], row[JTZ])


@inner_kernel
def sweep_rows(work, touches, ids, count, rows):
    """One sweep over all touches: normal impulses that only push, friction within mu times that."""
    for first in range(STRIDE):
        for m in range(first, count, STRIDE):
            touch, row = touches[m], rows[m]
            a, b = ids[m, FIRST], ids[m, SECOND]
            speed = normal_speed(work, row, touch, a, b)
            j = max(row[JN] - (speed - row[BIAS]) * row[MASS] - row[SOFT] * row[JN], 0.0)
            if j != row[JN]:
                push_along(work, row, touch, a, b, j - row[JN])
                row[JN] = j
            if row[MU] <= 0.0:
                continue
            ux, uy, uz, slip, mass = slip_of(work, row, touch, a, b)
            x, y, z = row[JTX] - mass * ux, row[JTY] - mass * uy, row[JTZ] - mass * uz
            size = math.sqrt(x * x + y * y + z * z)
            most = row[MU] * j
            if size > most:
                x *= most / size
                y *= most / size
                z *= most / size
            if slip > 0.0 or size > most:
                push_bodies(work, row, a, b, x - row[JTX], y - row[JTY], z - row[JTZ])
                row[JTX], row[JTY], row[JTZ] = x, y, z


@inner_kernel
def harden_rows(touches, count, rows):
    """Take softness and push back out of the rows: what follows removes the speed they gave."""
    for m in range(count):
        row = rows[m]
        row[MASS] /= 1.0 - row[SOFT]
        row[SOFT] = 0.0
        row[BIAS] = min(row[BIAS], 0.0)


@inner_kernel
def keep_impulses(count, rows, held):
    """Impulses (count, 4) for the next step."""
    for m in range(count):
        for column in range(4):
            held[m, column] = rows[m, JN + column]
