"""Collisions at all contacts at once: Newton's law v_n' >= -e v_n by impulses that only push, in rounds.

Into a round go the contacts that approach, with those that rest; what separates takes no part, as an impulse
there would only make energy. What approaches because of the round comes next, until nothing does
(generalised reflections; Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012, "Reflections on Simultaneous
Impact"). Each impulse j adds j (v_n + v_n') / 2 to the energy, which is -(1 - e) j |v_n| / 2 where a contact
approached and not above 0 where it rested: so no round raises it, also where e differs among contacts.
Impulses of a round are accumulated and clamped (projected Gauss-Seidel; Moreau 1988; Catto 2005). Arrays as
in contact_rows.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.spheres import contact_rows, ledger
from game.physics.spheres.contact_rows import normal_speed, push_along, rest_speed  # fmt: skip
from game.physics.spheres.contacts import FIRST, GAP, SECOND
from game.physics.spheres.impulses import collide, collide_and_enter

LEAST_SWEEPS = (
    200  # of a round, at most; with fewer contacts more, as a light sphere between heavy ones needs
)
SWEPT = 40_000  # contacts swept in a round, in all
SETTLED = 1e-15  # of the fastest approach: a sweep that changes speeds by less is the last
SEPARATING, ABSENT = 1e300, 2e300  # in place of an expected speed: contacts that take no part


@inner_kernel
def collide_at_once(work, positions, radii, contacts, count, rows, fastest, numbers, log):
    """Newton's law at all contacts together, in rounds. Returns rounds and impulses made.

    Friction follows each round, contact by contact. If collisions go on without end (e < 1 between spheres in
    contact), or nothing that approaches rebounds, a last round takes the approach from every contact.
    """
    before = log.counters[2]
    for turn in range(numbers.rounds):
        rebound = measure_round(work, radii, contacts, count, rows, fastest, numbers)
        if rebound < 0.0:
            return turn, int(log.counters[2] - before)
        ends = rebound == 0.0 or turn == numbers.rounds - 1
        if ends:
            join_all(count, rows)
        for _ in range(max(LEAST_SWEEPS, SWEPT // count)):
            if not sweep_jointly(work, contacts, count, rows) > SETTLED * fastest:
                break
        hold_energy(work, contacts, count, rows)
        enter_joint(work, positions, contacts, count, rows, log)
        if ends:
            break
    return turn + 1, int(log.counters[2] - before)


@inner_kernel
def measure_round(work, radii, contacts, count, rows, fastest, numbers):
    """Contacts that take part in a round, and the separating speed that each is to have at least.

    Returns the largest restitution of a contact that approaches; -1 if none does.
    """
    rebound = -1.0
    for m in range(count):
        contact, row = contacts.normals[m], rows[m]
        row[contact_rows.JOINT] = 0.0
        row[contact_rows.TARGET] = ABSENT
        if (
            contact[GAP] > contact_rows.TOUCHING * radii[contacts.spheres[m, FIRST]]
            or not row[contact_rows.MASS] > 0.0
        ):
            continue
        speed = normal_speed(work, row, contact, contacts.bodies[m, FIRST], contacts.bodies[m, SECOND])
        row[contact_rows.BEFORE] = speed
        rest = max(rest_speed(row[contact_rows.REBOUND], numbers), contact_rows.STILL * fastest)
        if abs(speed) <= rest:
            row[contact_rows.TARGET] = -abs(speed)  # it rests: no rebound, and what is left is borne later
        elif speed < 0.0:
            row[contact_rows.TARGET] = -row[contact_rows.REBOUND] * speed
            rebound = max(rebound, row[contact_rows.REBOUND])
        else:
            row[contact_rows.TARGET] = SEPARATING
    return rebound


@inner_kernel
def join_all(count, rows):
    """No contact is to approach, none rebounds, and what separates takes part: a round that ends all at once.

    It leads to the nearest velocities that no contact forbids, which cannot be faster: rest is among them.
    """
    for m in range(count):
        if rows[m, contact_rows.TARGET] != ABSENT:
            rows[m, contact_rows.TARGET] = min(rows[m, contact_rows.TARGET], 0.0)


@inner_kernel
def sweep_jointly(work, contacts, count, rows):
    """One sweep over all contacts of a round; returns the largest change of a speed, m/s."""
    change = 0.0
    for m in range(count):
        contact, row = contacts.normals[m], rows[m]
        if row[contact_rows.TARGET] >= SEPARATING:
            continue
        a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
        missing = row[contact_rows.TARGET] - normal_speed(work, row, contact, a, b)
        mass = row[contact_rows.MASS] / (1.0 - row[contact_rows.SOFT])
        j = max(row[contact_rows.JOINT] + missing * mass, 0.0) - row[contact_rows.JOINT]
        if j != 0.0:
            change = max(change, abs(missing))
            push_along(work, row, contact, a, b, j)
            row[contact_rows.JOINT] += j
    return change


@inner_kernel
def hold_energy(work, contacts, count, rows):
    """Impulses of a round that raise the energy, as too few sweeps can leave them, made as much smaller.

    With all of them times s the energy changes by s j·v + s² (j·v' - j·v) / 2.
    """
    along = change = 0.0
    for m in range(count):
        row = rows[m]
        if row[contact_rows.JOINT] > 0.0:
            a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
            speed = normal_speed(work, row, contacts.normals[m], a, b)
            along += row[contact_rows.JOINT] * row[contact_rows.BEFORE]
            change += row[contact_rows.JOINT] * (speed - row[contact_rows.BEFORE])
    if not 2.0 * along + change > 1e-12 * change:
        return
    share = max(-2.0 * along / change, 0.0)
    for m in range(count):
        row = rows[m]
        if row[contact_rows.JOINT] > 0.0:
            j = share * row[contact_rows.JOINT]
            a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
            push_along(work, row, contacts.normals[m], a, b, j - row[contact_rows.JOINT])
            row[contact_rows.JOINT] = j


@inner_kernel
def enter_joint(work, positions, contacts, count, rows, log):
    """Friction of a round whose impulses along the normals have acted, and the ledger of it.

    The energy of the round is shared out: each normal impulse has its work, j times the mean of the speeds
    before and after, in sum all of it. What friction takes is measured, as it is made.
    """
    ring, counters = log.ring, log.counters
    first = int(counters[2])
    made = 0
    for m in range(count):
        row = rows[m]
        if row[contact_rows.JOINT] > 0.0:
            entry = ring[(first + made) % ring.shape[0]]
            a, b = contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
            entry[ledger.AFTER] = normal_speed(work, row, contacts.normals[m], a, b)
            entry[ledger.CHANGE] = (
                0.5 * row[contact_rows.JOINT] * (row[contact_rows.BEFORE] + entry[ledger.AFTER])
            )
            made += 1
    skipped = made - ring.shape[0]
    for m in range(count):
        row = rows[m]
        j = row[contact_rows.JOINT]
        if j > 0.0:
            contact, a, b = contacts.normals[m], contacts.bodies[m, FIRST], contacts.bodies[m, SECOND]
            entry = ring[int(counters[2]) % ring.shape[0]]
            if skipped > 0:  # more at once than the ledger has lines: the last of them are entered
                skipped -= 1
                push_along(work, row, contact, a, b, -j)
                collide(work, row, contact, a, b, j)
                counters[2] += 1.0
                continue
            after, share = entry[ledger.AFTER], entry[ledger.CHANGE]
            # taken back and made again, with its friction, so that it can be weighed
            speeds = normal_speed(work, row, contact, a, b)
            push_along(work, row, contact, a, b, -j)
            speeds += normal_speed(work, row, contact, a, b)
            collide_and_enter(work, positions, contacts, m, row, j, row[contact_rows.BEFORE], log)
            entry[ledger.AFTER] = after
            entry[ledger.CHANGE] += share - 0.5 * j * speeds
            entry[ledger.EXPECTED] += share - 0.5 * j * speeds
