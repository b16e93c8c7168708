"""Collisions between bodies in space, one after the other: impulses at contacts that approach.

An impulse along the normal turns the approach v_n of the contact points into -e v_n,
    j = -(1 + e) v_n m_eff,
and Coulomb's friction stops the slip or takes mu j (Hahn 1988; Mirtich 1996). One contact after the other,
again until none approaches: what happens in Newton's cradle. All of them at once: see joint_impulses.
Arrays as in contact_rows.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.spheres import contact_rows, ledger
from game.physics.spheres import contacts as c
from game.physics.spheres.contact_rows import (  # fmt: skip
    normal_speed,
    push_along,
    push_bodies,
    relative_velocity,
    rest_speed,
    slip_of,
)
from game.physics.spheres.ledger import weigh_pair
from game.physics.spheres.spheres import WEIGHT


@inner_kernel
def collide(work, row, contact, a, b, j):
    """An impulse j along the normal with its friction, added to what the row has of collisions."""
    push_along(work, row, contact, a, b, j)
    row[contact_rows.HIT] += j
    if row[contact_rows.MU] > 0.0:
        ux, uy, uz, slip, mass = slip_of(work, row, contact, a, b)
        if slip > 0.0:
            part = -min(mass, row[contact_rows.MU] * j / slip)
            push_bodies(work, row, a, b, part * ux, part * uy, part * uz)
            row[contact_rows.HITX] += part * ux
            row[contact_rows.HITY] += part * uy
            row[contact_rows.HITZ] += part * uz


@inner_kernel
def collide_and_enter(work, positions, contacts, m, row, j, speed, log):
    """An impulse j at contact m, which separates at ``speed`` (m/s) before; entered into the ledger."""
    ring, counters, sums = log
    contact, who = contacts.normals[m], contacts.spheres[m]
    a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
    entry = ring[int(counters[2]) % ring.shape[0]]
    weigh_pair(work, positions, a, b, sums[0])
    ux, uy, uz = relative_velocity(work, row, a, b)
    hit, x, y, z = (
        row[contact_rows.HIT],
        row[contact_rows.HITX],
        row[contact_rows.HITY],
        row[contact_rows.HITZ],
    )
    collide(work, row, contact, a, b, j)
    jx = (row[contact_rows.HIT] - hit) * contact[c.NX] + row[contact_rows.HITX] - x
    jy = (row[contact_rows.HIT] - hit) * contact[c.NY] + row[contact_rows.HITY] - y
    jz = (row[contact_rows.HIT] - hit) * contact[c.NZ] + row[contact_rows.HITZ] - z
    wx, wy, wz = relative_velocity(work, row, a, b)
    weigh_pair(work, positions, a, b, sums[1])
    entry[ledger.TIME] = counters[0]
    entry[ledger.ONE], entry[ledger.OTHER] = who[c.FIRST], max(who[c.SECOND], -1)
    entry[ledger.X] = positions[a, 0] + row[contact_rows.RAX]
    entry[ledger.Y] = positions[a, 1] + row[contact_rows.RAY]
    entry[ledger.Z] = positions[a, 2] + row[contact_rows.RAZ]
    entry[ledger.JX], entry[ledger.JY], entry[ledger.JZ] = jx, jy, jz
    entry[ledger.BEFORE] = speed
    entry[ledger.AFTER] = wx * contact[c.NX] + wy * contact[c.NY] + wz * contact[c.NZ]
    entry[ledger.REBOUND] = row[contact_rows.REBOUND]
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
            a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            if contact[c.GAP] > contact_rows.TOUCHING * radii[contacts.spheres[m, c.FIRST]]:
                continue
            speed = normal_speed(work, row, contact, a, b)
            least = max(rest_speed(row[contact_rows.REBOUND], numbers), contact_rows.STILL * fastest)
            if speed < -least and row[contact_rows.MASS] > 0.0:
                mass = row[contact_rows.MASS] / (1.0 - row[contact_rows.SOFT])
                j = -(1.0 + row[contact_rows.REBOUND]) * speed * mass
                collide_and_enter(work, positions, contacts, m, row, j, speed, log)
                made += 1
                changed = True
        if not changed:
            return turn, made
    return numbers.rounds, made
