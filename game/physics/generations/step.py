"""One step of all stars: a special one flies by itself, the others in one sweep a kind.

Special is what dies, may meet the ground, leaves a trail or is driven within the step. For such a star all
that happens stands in the order of time: it flies from the beginning of the step to each instant by itself,
so births have their own instant and place, whatever the step. What is born waits in a queue and flies the
rest of the step the same way; its own children join the queue.

A step of 60,000 stars takes 107 us: 89 to fly, 11 to find special ones, 7 for the call. The divider alone is
held for 51 us by a root and a division a star (AMD EPYC 9004, vectors of eight). Memory is no bound: 6,000
stars take as long each.

Places of a kind are one run of the pool; the dead are replaced by the last of the run.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.physics.generations import kinds
from game.physics.generations.effects import GROUND_BIT, THRUST_BIT, TRAILS_BIT
from game.physics.generations.flight import SPLIT_DRAG, Law, Star, fly, fly_split, terms_over
from game.physics.generations.patterns import burst_velocity, child_identity, life_of

X, Y, Z, VX, VY, VZ, BORN, DIES, BURNT = range(9)
FIELDS = 9
MOVED = 6  # fields that a flight changes
MADE, ENDED, DROPPED, LANDED, REPORTED, UNREPORTED = range(6)
TALLIES = 6
WHAT, WHICH, INSTANT, AT_X, AT_Y, AT_Z, SPEED_X, SPEED_Y = range(8)
REPORT_COLUMNS = 8
BLOCK = 512  # stars; what is looked at before they fly is still at hand then
SLACK = 2.0**-44  # relative: an instant this near to a step's end belongs to the step
FALLS = 60  # halvings in the search for the instant of a fall


class Pool(NamedTuple):
    """Where stars live. The first three are the state; the others are scratch and reports."""

    fields: NDArray[np.float64]  # (FIELDS, n): x, y, z m, velocity m/s, born, dies s, share burnt a second
    identities: NDArray[np.int64]  # (n,)
    counts: NDArray[np.int64]  # (kinds,) alive
    tallies: NDArray[np.int64]  # (TALLIES,)
    before: NDArray[np.int64]  # (kinds,) alive at the beginning of the step
    special: NDArray[np.int64]  # (n,) places
    kept: NDArray[np.float64]  # (MOVED, n) state of the special ones as it was
    queue: NDArray[np.float64]  # (k, FIELDS) of those born in this step
    queued: NDArray[np.int64]  # (k, 2) identity and kind
    reports: NDArray[np.float64]  # (m, REPORT_COLUMNS)


class Rules(NamedTuple):
    """What holds for a whole step."""

    method: int
    mask: int
    seed: int
    ground: float  # m


@kernel
def law_of(table, kind):
    """How a kind flies."""
    row = table.kinds[kind]
    return Law(row[kinds.WEIGHT], row[kinds.LINEAR], row[kinds.QUADRATIC], row[kinds.EXHAUST])


@kernel(forceinline=True)
def star_of(row, now):
    """A row of fields as a star that flies on from an instant (s)."""
    return Star(row[X], row[Y], row[Z], row[VX], row[VY], row[VZ], now - row[BORN], row[BURNT])


@kernel
def step_stars(rules, table, air, pool, now, h):
    """Move all stars on from an instant by h (s), with all births and deaths in it."""
    end = now + h
    limit = end + SLACK * (abs(end) + h)
    pool.tallies[REPORTED] = 0
    for kind in range(pool.counts.shape[0]):
        pool.before[kind] = pool.counts[kind]
    for kind in range(pool.counts.shape[0]):
        found = sweep(rules, table, air, pool, kind, (now, h, limit))
        fly_special(rules, table, air, pool, (kind, found), (now, end, limit))


@kernel
def sweep(rules, table, air, pool, kind, instants):
    """Fly a kind's stars over h (s), special or not, all alike; how many are special.

    Block by block, while it is at hand, the special ones are listed first and their state is kept. instants:
    now, h, and until when a death belongs to the step (s).
    """
    now, h, limit = instants
    begin = table.begin[kind]
    end = begin + pool.before[kind]
    every = rules.mask & TRAILS_BIT != 0 and leaves_trail(table, kind)
    every = every or (rules.mask & THRUST_BIT != 0 and table.kinds[kind, kinds.EXHAUST] > 0.0)
    lowest = -math.inf
    if rules.mask & GROUND_BIT and table.kinds[kind, kinds.DIES_ON_GROUND] > 0.0:
        lowest = rules.ground + 2.0 * h * h * air.gravity * abs(table.kinds[kind, kinds.WEIGHT])
    law = law_of(table, kind)
    terms = terms_over(rules.mask, law, air, h)
    found = 0
    for low in range(begin, end, BLOCK):
        places = (low, min(low + BLOCK, end))
        if every or any_special(pool.fields, places, (limit, lowest), h):
            found = list_special(pool, every, places, (limit, lowest), h, found)
        if rules.method != SPLIT_DRAG:
            sweep_staged(rules, law, air, pool.fields, places, (now, h))
        elif terms.reach > 0.0:
            sweep_split(terms, True, pool.fields, places, (now, h))
        else:
            sweep_split(terms, False, pool.fields, places, (now, h))
    return found


@kernel
def any_special(rows, places, limits, h):
    """Whether one at some places dies by an instant (s) or may come down to a height (m), the two limits."""
    limit, lowest = limits
    y = rows[Y][places[0] : places[1]]
    vy = rows[VY][places[0] : places[1]]
    dies = rows[DIES][places[0] : places[1]]
    several = 0
    for i in range(y.shape[0]):
        low = 1 if y[i] + 2.0 * h * min(vy[i], 0.0) <= lowest else 0
        dead = 1 if dies[i] <= limit else 0
        several += low | dead
    return several > 0


@kernel
def list_special(pool, every, places, limits, h, found):
    """List the special ones among some places, from line ``found`` on; the next line."""
    limit, lowest = limits
    for i in range(places[0], places[1]):
        low = pool.fields[Y, i] + 2.0 * h * min(pool.fields[VY, i], 0.0) <= lowest
        if every or low or pool.fields[DIES, i] <= limit:
            pool.special[found] = i
            for row in range(MOVED):
                pool.kept[row, found] = pool.fields[row, i]
            found += 1
    return found


@kernel
def leaves_trail(table, kind):
    """Whether stars of a kind leave something along their way."""
    for row in range(table.first[kind], table.first[kind + 1]):
        if table.births[row, kinds.OCCASION] == kinds.ALONG:
            return True
    return False


@kernel
def sweep_staged(rules, law, air, rows, places, instants):
    """Fly stars over h (s) by a method that takes the drag as any other force. instants: now and h (s)."""
    now, h = instants
    for i in range(places[0], places[1]):
        star = star_of(rows[:, i], now)
        flown = fly(rules.method, rules.mask, law, air, star, h)
        rows[X, i], rows[Y, i], rows[Z, i], rows[VX, i], rows[VY, i], rows[VZ, i] = flown


@kernel(forceinline=True)
def sweep_split(terms, quadratic, rows, places, instants):
    """The same by split drag; rows in one dimension, so that the compiler takes four stars at a time."""
    now, h = instants
    begin, end = places
    x = rows[X][begin:end]
    y = rows[Y][begin:end]
    z = rows[Z][begin:end]
    vx = rows[VX][begin:end]
    vy = rows[VY][begin:end]
    vz = rows[VZ][begin:end]
    born = rows[BORN][begin:end]
    burnt = rows[BURNT][begin:end]
    for i in range(x.shape[0]):
        star = Star(x[i], y[i], z[i], vx[i], vy[i], vz[i], now - born[i], burnt[i])
        x1, y1, z1, ux, uy, uz = fly_split(terms, quadratic, star, h)
        x[i] = x1
        y[i] = y1
        z[i] = z1
        vx[i] = ux
        vy[i] = uy
        vz[i] = uz


@kernel
def fly_special(rules, table, air, pool, which, instants):
    """Fly a kind's special stars again, each by itself, and take away those that ended. which: kind, n."""
    kind, found = which
    now, end, limit = instants
    begin = table.begin[kind]
    for k in range(found - 1, -1, -1):  # from the last: what takes a place has been flown already
        i = pool.special[k]
        pool.queue[0] = pool.fields[:, i]
        for row in range(MOVED):
            pool.queue[0, row] = pool.kept[row, k]
        pool.queued[0, 0] = pool.identities[i]
        pool.queued[0, 1] = kind
        alive, waiting = live(rules, table, air, pool, 1, (now, end, limit))
        if alive:
            pool.fields[:, i] = pool.queue[0]
        else:
            last = begin + pool.counts[kind] - 1
            pool.fields[:, i] = pool.fields[:, last]
            pool.identities[i] = pool.identities[last]
            pool.counts[kind] -= 1
        raise_children(rules, table, air, pool, waiting, (end, limit))


@kernel
def raise_children(rules, table, air, pool, waiting, instants):
    """Let all that wait in the queue, from place 1 on, fly to the step's end, with their children."""
    end, limit = instants
    while waiting > 1:
        waiting -= 1
        pool.queue[0] = pool.queue[waiting]
        pool.queued[0] = pool.queued[waiting]
        kind = pool.queued[0, 1]
        alive, waiting = live(rules, table, air, pool, waiting, (-math.inf, end, limit))
        pool.tallies[MADE] += 1
        if alive:
            if pool.counts[kind] == table.begin[kind + 1] - table.begin[kind]:
                pool.tallies[DROPPED] += 1
                pool.tallies[ENDED] += 1
            else:
                place = table.begin[kind] + pool.counts[kind]
                pool.fields[:, place] = pool.queue[0]
                pool.identities[place] = pool.queued[0, 0]
                pool.counts[kind] += 1


@kernel
def live(rules, table, air, pool, waiting, instants):
    """What the star at place 0 goes through until the step's end: (whether it lives, the queue's end).

    instants: beginning (s; -inf for one that is just born), end, and until when a death belongs to the step.
    """
    now, end, limit = instants
    star = pool.queue[0]
    kind = pool.queued[0, 1]
    fresh = now == -math.inf
    begin = star[BORN] if fresh else now
    law = law_of(table, kind)
    stop = min(star[DIES], end) if star[DIES] <= limit else end
    stop = max(stop, begin)
    if fresh:
        waiting = bear(rules, table, pool, waiting, kinds.AT_BIRTH, begin)
    landed, stop = find_landing(rules, table, air, star, kind, (begin, stop))
    if rules.mask & TRAILS_BIT:
        waiting = leave_trail(rules, table, air, pool, waiting, (begin, stop, fresh))
    flown = fly(rules.method, rules.mask, law, air, star_of(star, begin), stop - begin)
    star[X], star[Y], star[Z], star[VX], star[VY], star[VZ] = flown
    if landed:
        star[Y] = rules.ground
        pool.tallies[LANDED] += 1
        waiting = bear(rules, table, pool, waiting, kinds.AT_HIT, stop)
    elif star[DIES] <= limit:
        waiting = bear(rules, table, pool, waiting, kinds.AT_DEATH, stop)
    else:
        return True, waiting
    pool.tallies[ENDED] += 1
    return False, waiting


@kernel
def find_landing(rules, table, air, star, kind, instants):
    """Whether a star meets the ground between two instants (s), and when; else the latter."""
    begin, stop = instants
    if rules.mask & GROUND_BIT == 0 or table.kinds[kind, kinds.DIES_ON_GROUND] == 0.0:
        return False, stop
    law = law_of(table, kind)
    flown = star_of(star, begin)
    _, y, _, _, vy, _ = fly(rules.method, rules.mask, law, air, flown, stop - begin)
    if y > rules.ground or (y == rules.ground and vy >= 0.0):
        return False, stop
    low, high = 0.0, stop - begin
    for _ in range(FALLS):
        middle = 0.5 * (low + high)
        _, y, _, _, _, _ = fly(rules.method, rules.mask, law, air, flown, middle)
        if y > rules.ground:
            low = middle
        else:
            high = middle
    return True, begin + high


@kernel
def leave_trail(rules, table, air, pool, waiting, instants):
    """Bear what the star at place 0 leaves between two instants (s), each at its own place and time."""
    begin, stop, fresh = instants
    star = pool.queue[0]
    kind = pool.queued[0, 1]
    law = law_of(table, kind)
    flown = star_of(star, begin)
    for row in range(table.first[kind], table.first[kind + 1]):
        birth = table.births[row]
        if birth[kinds.OCCASION] != kinds.ALONG:
            continue
        made = 0 if fresh else trail_until(birth[kinds.RATE], star[BORN], begin)
        for number in range(made, trail_until(birth[kinds.RATE], star[BORN], stop)):
            instant = min(max(star[BORN] + number / birth[kinds.RATE], begin), stop)
            at = fly(rules.method, rules.mask, law, air, flown, instant - begin)
            waiting = enqueue(rules, table, pool, waiting, (row, number), (at, instant))
    return waiting


@kernel
def trail_until(rate, born, now):
    """How many a star has left along its way by an instant (s), the first at its birth."""
    phase = (now - born) * rate
    return math.floor(phase + SLACK * (phase + rate * abs(now) + 1.0)) + 1


@kernel
def bear(rules, table, pool, waiting, occasion, instant):
    """Bear what is born of the star at place 0 on an occasion, and list it if its kind is listed."""
    star = pool.queue[0]
    kind = pool.queued[0, 1]
    if table.kinds[kind, kinds.REPORTS] > 0.0:
        report(pool, occasion, kind, instant, star)
    for row in range(table.first[kind], table.first[kind + 1]):
        birth = table.births[row]
        if birth[kinds.OCCASION] == occasion:
            at = ((star[X], star[Y], star[Z], star[VX], star[VY], star[VZ]), instant)
            for number in range(int(birth[kinds.COUNT])):
                waiting = enqueue(rules, table, pool, waiting, (row, number), at)
    return waiting


@kernel
def enqueue(rules, table, pool, waiting, which, at):
    """Put a child into the queue: (row of its birth, number), (place and velocity of the parent, instant)."""
    if waiting == pool.queue.shape[0]:
        pool.tallies[DROPPED] += 1
        return waiting
    row, number = which
    (x, y, z, vx, vy, vz), instant = at
    birth = table.births[row]
    child = int(birth[kinds.CHILD])
    parent = pool.queued[0, 0]
    identity = child_identity(parent, row, number)
    ux, uy, uz = burst_velocity(birth, table.points, rules.seed, row_identity(parent, row), number)
    life = life_of(
        table.kinds[child, kinds.LIFE], table.kinds[child, kinds.LIFE_SPREAD], rules.seed, identity
    )
    new = pool.queue[waiting]
    new[X] = x
    new[Y] = y
    new[Z] = z
    new[VX] = birth[kinds.INHERITED] * vx + ux
    new[VY] = birth[kinds.INHERITED] * vy + uy
    new[VZ] = birth[kinds.INHERITED] * vz + uz
    new[BORN] = instant
    new[DIES] = instant + life
    new[BURNT] = table.kinds[child, kinds.BURNS] / life
    pool.queued[waiting, 0] = identity
    pool.queued[waiting, 1] = child
    return waiting + 1


@kernel
def row_identity(parent, row):
    """What the random numbers of one burst hang on."""
    return parent ^ (row << 24)


@kernel
def report(pool, what, kind, instant, star):
    """List a birth, burst or fall; without a line left it is counted."""
    line = pool.tallies[REPORTED]
    if line == pool.reports.shape[0]:
        pool.tallies[UNREPORTED] += 1
        return
    pool.tallies[REPORTED] = line + 1
    entry = pool.reports[line]
    entry[WHAT] = what
    entry[WHICH] = kind
    entry[INSTANT] = instant
    entry[AT_X], entry[AT_Y], entry[AT_Z] = star[X], star[Y], star[Z]
    entry[SPEED_X], entry[SPEED_Y] = star[VX], star[VY]
