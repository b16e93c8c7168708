"""Births and deaths within a step: each particle begins at its own instant, and none is lost unseen.

The n-th particle of an emitter of constant rate is born at n / rate: so after any time T exactly
floor(rate T) have been born, whatever the step. A change of rate keeps the fraction of the particle that was
under way. The pool is a ring in the order of birth: those that die of age are always at its head.

Tuples of arrays:
pool       fields (>= 5, n), x, y, vx, vy, birth; tags (2, n), see `encounters`; tallies (TALLIES,); capacity
sources    emitters (m, EMITTER_COLUMNS), counts (m, 2), due (m,) scratch, seed
listed     hits (LIST_ROWS, k) and who (k,), the list of those to be resolved
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary
from game.physics.particles import encounters
from game.physics.particles.effects import REPORTS_BIT
from game.physics.particles.random_numbers import uniform_pair

# an emitter's row: position at the end of the step and at its beginning (m), axis (rad from +y, clockwise),
# spread (rad to each side), speed (m/s) and half its range (part of it), width of the nozzle (m), rate (1/s),
# fraction of a particle under way when the rate was set, and that instant (s)
POSITION_X, POSITION_Y, FROM_X, FROM_Y, AXIS, SPREAD = range(6)
SPEED, SPEED_RANGE, WIDTH, RATE, CARRY, SINCE = range(6, 12)
EMITTER_COLUMNS = 12
MADE, SERIAL = 0, 1  # births since the rate was set; births ever: columns of the emitters' int64 array
IDENTITY_STEP = 1 << 40  # identity = emitter * IDENTITY_STEP + serial number; exact as a float
SLACK = 2.0**-48  # relative: an instant that differs from a step's end by rounding only belongs to the step


@lean_kernel
def births_until(rate, carry, since, now):
    """Whole particles of one emitter from the setting of its rate (s) until now (s)."""
    phase = carry + rate * max(now - since, 0.0)
    return math.floor(phase + SLACK * (phase + rate * abs(now)))


@lean_kernel
def retire(mask, pool, listed, found, life, now, h):
    """Take those whose life (s) ends in this step from the ring's head; the next free place of the list.

    For reports, each goes to the list to be flown to the instant of its death. If the list is full, the rest
    waits for another call.
    """
    fields, tags, tallies, capacity = pool
    hits, who = listed
    end = now + h
    limit = end + SLACK * (abs(end) + life)
    while tallies[encounters.COUNT] > 0 and found < who.shape[0]:
        place = tallies[encounters.HEAD]
        instant = fields[4, place] + life
        if instant > limit:
            break
        if mask & REPORTS_BIT:
            for row in range(4):
                hits[row, found] = fields[row, place]
            hits[encounters.START, found] = 0.0
            hits[encounters.DURATION, found] = min(max(instant - now, 0.0), h)
            hits[encounters.IDENTITY, found] = tags[0, place]
            who[found] = -1
            found += 1
        tallies[encounters.HEAD] = place + 1 if place + 1 < capacity else 0
        tallies[encounters.COUNT] -= 1
        tallies[encounters.DIED] += 1
    return found


@lean_kernel
def launch(emitter, seed, stream, serial, part, hits, entry):
    """Write where and how particle number ``serial`` of an emitter starts to the list.

    ``part``: how far into the step it is born, 0 to 1, for an emitter that moves.
    """
    angle, across = uniform_pair(seed, stream, 2 * serial)
    faster, _ = uniform_pair(seed, stream, 2 * serial + 1)
    direction = emitter[AXIS] + emitter[SPREAD] * (2.0 * angle - 1.0)
    speed = emitter[SPEED] * (1.0 + emitter[SPEED_RANGE] * (2.0 * faster - 1.0))
    aside = emitter[WIDTH] * (across - 0.5)
    x = emitter[FROM_X] + part * (emitter[POSITION_X] - emitter[FROM_X])
    y = emitter[FROM_Y] + part * (emitter[POSITION_Y] - emitter[FROM_Y])
    hits[0, entry] = x + aside * elementary.cos(emitter[AXIS])
    hits[1, entry] = y - aside * elementary.sin(emitter[AXIS])
    hits[2, entry] = speed * elementary.sin(direction)
    hits[3, entry] = speed * elementary.cos(direction)


@lean_kernel
def next_birth(emitters, counts, due):
    """The emitter whose next particle is born first, and when: (index or -1, instant in s)."""
    chosen = -1
    first = math.inf
    for e in range(emitters.shape[0]):
        if counts[e, MADE] < due[e]:
            rate = emitters[e, RATE]
            instant = emitters[e, SINCE] + (counts[e, MADE] + 1 - emitters[e, CARRY]) / rate
            if instant < first:
                first = instant
                chosen = e
    return chosen, first


@lean_kernel
def emit(mask, pool, sources, listed, found, life, now, h):
    """Give birth to all particles due in this step, in the order of their instants; the list's next place.

    Written: counts (m, 2), tallies, and for each survivor its instant of birth, tags and a line of the list.
    Without space in the ring one is dropped and counted. One whose life is over within the step is born and
    dies in it. If the list is full, the rest waits for another call.
    """
    fields, tags, tallies, capacity = pool
    emitters, counts, due, seed = sources
    hits, who = listed
    end = now + h
    for e in range(emitters.shape[0]):
        due[e] = 0
        if emitters[e, RATE] > 0.0:
            due[e] = births_until(emitters[e, RATE], emitters[e, CARRY], emitters[e, SINCE], end)
    while found < who.shape[0]:
        e, instant = next_birth(emitters, counts, due)
        if e < 0:
            break
        serial = counts[e, SERIAL]
        counts[e, MADE] += 1
        counts[e, SERIAL] += 1
        age = min(max(end - instant, 0.0), h)
        stillborn = age + SLACK * (abs(end) + life) >= life
        if not stillborn and tallies[encounters.COUNT] == capacity:
            tallies[encounters.DROPPED] += 1
            continue
        tallies[encounters.BORN] += 1
        if stillborn:
            tallies[encounters.DIED] += 1
            if mask & REPORTS_BIT == 0:
                continue
        launch(emitters[e], seed, e, serial, 1.0 - age / h, hits, found)
        hits[encounters.START, found] = h - age
        hits[encounters.DURATION, found] = min(age, life)
        hits[encounters.IDENTITY, found] = e * IDENTITY_STEP + serial
        who[found] = -1
        if not stillborn:
            place = (tallies[encounters.HEAD] + tallies[encounters.COUNT]) % capacity
            fields[4, place] = instant
            tags[0, place] = e * IDENTITY_STEP + serial
            tags[1, place] = 0
            who[found] = place
            tallies[encounters.COUNT] += 1
        found += 1
    return found
