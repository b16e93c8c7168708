"""Collisions between bodies in space, one after the other: impulses at contacts that approach.

An impulse along the normal turns the approach v_n of the contact points into -e v_n,
    j = -(1 + e) v_n m_eff,
and Coulomb's friction stops the slip or takes mu j (Hahn 1988; Mirtich 1996). One contact after the other,
again until none approaches: what happens in Newton's cradle. All of them at once: see joint_impulses.
Arrays as in contact_rows.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.spheres import ledger
from game.physics.spheres.contact_rows import (
    HIT,
    HITX,
    HITY,
    HITZ,
    MASS,
    MU,
    RAX,
    RAY,
    RAZ,
    REBOUND,
    SOFT,
    STILL,
    TOUCHING,
    normal_speed,
    push_along,
    push_bodies,
    relative_velocity,
    rest_speed,
    slip_of,
)  # fmt: skip
from game.physics.spheres.contacts import FIRST, GAP, NX, NY, NZ, SECOND
from game.physics.spheres.ledger import weigh_pair
from game.physics.spheres.spheres import WEIGHT


@inner_kernel
def collide(work, row, contact, a, b, j):
    """An impulse j along the normal with its friction, added to what the row has of collisions."""
    push_along(work, row, contact, a, b, j)
    row[HIT] += j
    if row[MU] > 0.0:
        ux, uy, uz, slip, mass = slip_of(work, row, contact, a, b)
        if slip > 0.0:
            part = -min(mass, row[MU] * j / slip)
            push_bodies(work, row, a, b, part * ux, part * uy, part * uz)
            row[HITX] += part * ux
            row[HITY] += part * uy
            row[HITZ] += part * uz


@inner_kernel
def collide_and_enter(work, positions, contacts, m, row, j, speed, log):
    """An impulse j at contact m, which separates at ``speed`` (m/s) before; entered into the ledger."""
    ring, counters, sums = log
    contact, who = contacts.normals[m], contacts.spheres[m]
    a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
    entry = ring[int(counters[2]) % ring.shape[0]]
    weigh_pair(work, positions, a, b, sums[0])
    ux, uy, uz = relative_velocity(work, row, a, b)
    hit, x, y, z = row[HIT], row[HITX], row[HITY], row[HITZ]
    collide(work, row, contact, a, b, j)
    jx = (row[HIT] - hit) * contact[NX] + row[HITX] - x
    jy = (row[HIT] - hit) * contact[NY] + row[HITY] - y
    jz = (row[HIT] - hit) * contact[NZ] + row[HITZ] - z
    wx, wy, wz = relative_velocity(work, row, a, b)
    weigh_pair(work, positions, a, b, sums[1])
    entry[ledger.TIME] = counters[0]
    entry[ledger.ONE], entry[ledger.OTHER] = who[FIRST], max(who[SECOND], -1)
    entry[ledger.X] = positions[a, 0] + row[RAX]
    entry[ledger.Y] = positions[a, 1] + row[RAY]
    entry[ledger.Z] = positions[a, 2] + row[RAZ]
    entry[ledger.JX], entry[ledger.JY], entry[ledger.JZ] = jx, jy, jz
    entry[ledger.BEFORE] = speed
    entry[ledger.AFTER] = wx * contact[NX] + wy * contact[NY] + wz * contact[NZ]
    entry[ledger.REBOUND] = row[REBOUND]
    entry[ledger.EXPECTED] = 0.5 * (jx * (ux + wx) + jy * (uy + wy) + jz * (uz + wz))
    ledger.enter(entry, sums, ledger.taken_by_fixed(work[a, WEIGHT], work[b, WEIGHT]))
    counters[2] += 1.0


@inner_kernel
def collide_in_turn(work, positions, radii, contacts, count, rows, fastest, numbers, log):
    """Collisions one after the other, in rounds, until none approaches. Returns rounds and impulses made.

    log: the `Ledger` that each is entered into.
    """
    made = 0
    for turn in range(numbers.rounds):
        changed = False
        for m in range(count):
            contact, row = contacts.normals[m], rows[m]
            a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
            if contact[GAP] > TOUCHING * radii[contacts.spheres[m, FIRST]]:
                continue
            speed = normal_speed(work, row, contact, a, b)
            least = max(rest_speed(row[REBOUND], numbers), STILL * fastest)
            if speed < -least and row[MASS] > 0.0:
                mass = row[MASS] / (1.0 - row[SOFT])
                j = -(1.0 + row[REBOUND]) * speed * mass
                collide_and_enter(work, positions, contacts, m, row, j, speed, log)
                made += 1
                changed = True
        if not changed:
            return turn, made
    return numbers.rounds, made
