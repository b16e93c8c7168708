"""When the next spheres come into contact: exactly, for flight under constant gravity.

Two spheres fall alike, so they approach along a straight line and |d + v t| = r_a + r_b is a quadratic. Its
constant term is taken as (d - R)(d + R), which loses no digits for spheres nearly in contact. A wall is met
where v t - c g t² uses up the gap; c says how the scheme falls: 0 explicit, 1 semi-implicit, 1/2 exact. What
is too slow to bounce is not waited for: a heap at rest would divide each step by all of its contacts. Source:
Ericson, Real-Time Collision Detection (2005), 5.5.

Arrays: places (s, 3) m; work (n + 1, WORK_COLUMNS), velocities; pairs (p, 2).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres.contact_rows import TOUCHING, rest_speed
from game.physics.spheres.effects import COLLISIONS_BIT, LEDGES_BIT, WINDOW_BIT
from game.physics.spheres.spheres import VX, VY, VZ

NEVER = math.inf
NEAR = 0.1  # of the radius: farther nothing may go in a step that is not watched
MOMENT = 1e-9  # of a substep: shortest part, so that time goes on
IMPACTS_PER_SPHERE, MOST_IMPACTS = 8, 400  # parts of a substep, at most; the last one takes what is left
ROUNDING = 1e-15  # of a substep; less is nothing left


@inner_kernel
def meeting_time(dx, dy, dz, vx, vy, vz, reach, touching):
    """First t >= 0 (s) with |d + v t| = reach, or infinity if never or if they are in contact already."""
    square = dx * dx + dy * dy + dz * dz
    closing = -(dx * vx + dy * vy + dz * vz)
    if not closing > 0.0:
        return NEVER
    length = math.sqrt(square)
    if length - reach <= touching:
        return NEVER
    speed = vx * vx + vy * vy + vz * vz
    left = (length - reach) * (length + reach)
    under = closing * closing - speed * left
    if under < 0.0:
        return NEVER
    return left / (closing + math.sqrt(under))


@inner_kernel
def falling_time(gap, speed, bend, touching):
    """First t > 0 (s) with gap + speed t - bend t² = 0, or infinity if never or in contact already."""
    if gap <= touching:
        return speed / bend if speed > 0.0 and bend > 0.0 else NEVER
    under = speed * speed + 4.0 * bend * gap
    if under < 0.0:
        return NEVER
    below = math.sqrt(under) - speed
    return 2.0 * gap / below if below > 0.0 else NEVER


@inner_kernel
def borne_speed(e, radius, numbers):
    """Approach (m/s) that does not bounce: what is slower rests when in contact, whenever that is.

    In no case so fast that a sphere could go far in the meantime.
    """
    return min(rest_speed(e, numbers), NEAR * radius / numbers.h)


@inner_kernel
def wall_time(gap, speed, bend, touching, borne):
    """`falling_time` of what is faster than ``borne`` (m/s) when it meets the wall."""
    if speed * speed + 4.0 * bend * max(gap, 0.0) <= borne * borne:
        return NEVER
    return falling_time(gap, speed, bend, touching)


@inner_kernel
def window_time(places, radius, work, s, i, window, bend, borne):
    """When sphere s of body i meets the window, s."""
    touching = TOUCHING * radius
    x, y = places[s, 0], places[s, 1]
    first = wall_time(x - radius - window[0], work[i, VX], 0.0, touching, borne)
    first = min(first, wall_time(window[2] - radius - x, -work[i, VX], 0.0, touching, borne))
    first = min(first, wall_time(y - radius - window[1], work[i, VY], bend, touching, borne))
    return min(first, wall_time(window[3] - radius - y, -work[i, VY], -bend, touching, borne))


@inner_kernel
def ledge_time(x, y, radius, vx, vy, ledge, borne):
    """When a sphere that goes straight on meets a ledge, s: its line, or else the nearer of its ends."""
    ex, ey = ledge[2] - ledge[0], ledge[3] - ledge[1]
    length = math.sqrt(ex * ex + ey * ey)
    px, py = x - ledge[0], y - ledge[1]
    across = (px * ey - py * ex) / length
    speed = (vx * ey - vy * ex) / length
    side = 1.0 if across >= 0.0 else -1.0
    gap = side * across - radius
    touching = TOUCHING * radius
    if gap > touching and -side * speed > borne:
        t = gap / (-side * speed)
        along = ((px + vx * t) * ex + (py + vy * t) * ey) / length
        if 0.0 <= along <= length:
            return t
    if vx * vx + vy * vy <= borne * borne:
        return NEVER
    first = meeting_time(-px, -py, 0.0, -vx, -vy, 0.0, radius, touching)
    return min(first, meeting_time(ex - px, ey - py, 0.0, -vx, -vy, 0.0, radius, touching))


@lean_kernel
def first_impact(places, world, work, pairs, numbers):
    """Seconds until the first new contact that bounces, or numbers.h if there is none before.

    Nothing is changed. Only what moves farther than numbers.fast of its radius within h is looked at.
    """
    composition, surroundings, tables = world.composition, world.surroundings, world.tables
    radii, owners, kinds = composition.radii, composition.owners, composition.kinds
    h, mask, fast = numbers.h, numbers.mask, numbers.fast
    wall = tables.restitution.shape[0] - 1
    first = h
    if mask & COLLISIONS_BIT:
        for p in range(pairs.shape[0]):
            a, b = pairs[p, 0], pairs[p, 1]
            i, j = owners[a], owners[b]
            vx, vy, vz = work[j, VX] - work[i, VX], work[j, VY] - work[i, VY], work[j, VZ] - work[i, VZ]
            least = fast * min(radii[a], radii[b])
            if i == j or (vx * vx + vy * vy + vz * vz) * h * h < least * least:
                continue
            dx, dy = places[b, 0] - places[a, 0], places[b, 1] - places[a, 1]
            dz = places[b, 2] - places[a, 2]
            borne = borne_speed(tables.restitution[kinds[a], kinds[b]], min(radii[a], radii[b]), numbers)
            closing = -(dx * vx + dy * vy + dz * vz)
            if closing <= borne * math.sqrt(dx * dx + dy * dy + dz * dz):
                continue
            touching = TOUCHING * radii[a]
            first = min(first, meeting_time(dx, dy, dz, vx, vy, vz, radii[a] + radii[b], touching))
    for s in range(radii.shape[0]):
        i = owners[s]
        vx, vy = work[i, VX], work[i, VY]
        if (vx * vx + vy * vy) * h * h < fast * fast * radii[s] * radii[s]:
            continue
        borne = borne_speed(tables.restitution[kinds[s], wall], radii[s], numbers)
        fall = numbers.lag * numbers.gravity
        if mask & WINDOW_BIT:
            first = min(first, window_time(places, radii[s], work, s, i, surroundings.window, fall, borne))
        if mask & LEDGES_BIT:
            for k in range(surroundings.ledges.shape[0]):
                ledge = surroundings.ledges[k]
                first = min(
                    first, ledge_time(places[s, 0], places[s, 1], radii[s], vx, vy - fall * h, ledge, borne)
                )
    return first


@lean_kernel
def swept_pairs(places, composition, work, h, pairs):
    """Brute force: pairs a < b of spheres that could meet within h (s), sorted, into pairs (capacity, 2)."""
    radii, owners = composition.radii, composition.owners
    m = 0
    for a in range(radii.shape[0]):
        i = owners[a]
        for b in range(a + 1, radii.shape[0]):
            j = owners[b]
            vx, vy, vz = work[j, VX] - work[i, VX], work[j, VY] - work[i, VY], work[j, VZ] - work[i, VZ]
            reach = math.sqrt(vx * vx + vy * vy + vz * vz) * h + radii[a] + radii[b]
            dx, dy = places[b, 0] - places[a, 0], places[b, 1] - places[a, 1]
            dz = places[b, 2] - places[a, 2]
            if dx * dx + dy * dy + dz * dz <= reach * reach:
                if m < pairs.shape[0]:
                    pairs[m, 0] = a
                    pairs[m, 1] = b
                m += 1
    return m


def divide_at_impacts(
    nominal: float, spheres: int, pause: bool, time_to_impact: Callable[[float], float]
) -> Iterator[float]:
    """Lengths (s) of the parts of a substep of ``nominal`` length, one after another, each to be stepped.

    time_to_impact: seconds until the first impact from where the spheres are now, at most those given. pause:
    after a part that ends at an impact comes one of a moment, in which what has met collides before
    displacements are computed. For schemes that move last.
    """
    left = nominal
    most = min(IMPACTS_PER_SPHERE * spheres, MOST_IMPACTS)
    struck = False
    for part in range(most):
        if part == most - 1:
            h = left
        elif struck and pause:
            h = min(MOMENT * nominal, left)
        else:
            h = min(max(time_to_impact(left), MOMENT * nominal), left)
        struck = not struck and h < left
        yield h
        left -= h
        if not left > ROUNDING * nominal:
            return
