"""Impact of particles on solids, by Newton's law, in three ways that differ in what they cost and are worth.

    end      fly the whole step; what has ended inside is put on the surface and reflected. Every method is of
             first order with it, and a fast particle may pass through a small solid.
    chord    where the chord of the step crosses the surface, position and velocity are interpolated and
             reflected, and the rest of the step is flown from there: second order.
    root     the instant at which the method's own step reaches the surface is solved for: full order.

Newton's law v⁺ = v⁻ - (1 + e) (v⁻ · n) n, with v relative to the surface. Slow impacts do not rebound, else
no particle would ever rest: stepping gives every bounce of an explicit method about v g h of energy
(measured; it is balanced by the loss at v = 3 g h / (1 - e²) for explicit Euler). Chord crossing of step
maps: Shampine and Thompson 2000, "Event location for ordinary differential equations".

solids: (k, COLUMNS) rows of discs, see `solids`. particle: its x, y, vx, vy (m, m/s).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import lean_kernel
from game.physics.particles.effects import GROUND_BIT, OBSTACLES_BIT
from game.physics.particles.flight import EXPLICIT_EULER, fly_alone
from game.physics.particles.forces import acceleration
from game.physics.particles.solids import surface, surface_velocity

CONTACTS = ("end", "chord", "root")
END, CHORD, ROOT = range(3)
MAX_CONTACTS = 8  # in one step of one particle; the time left then is dropped and counted
ENOUGH = 3  # rounds of pushing out of solids that overlap before it is asked whether they lead anywhere
TOUCH = 1e-12  # m, gap at which a particle counts as on the surface
CREEP = 1e-12  # of the speed: an approach as slow as this is rounding
ROOT_ROUNDS = 80  # the regula falsi used needs about 8; bisection alone would need 53


class Rules(NamedTuple):
    """What every contact of a step needs to know."""

    mode: int  # END, CHORD or ROOT
    method: int  # index in METHODS
    mask: int  # of effects
    floor: float  # m
    floor_restitution: float
    h: float  # s, the whole step


@lean_kernel
def rest_speed(rules, restitution, push):
    """Speed (m/s) of approach below which there is no rebound, for an acceleration ``push`` into the surface.

    Where steps feed energy to bounces, a little more than the speed at which gain and loss balance. Else the
    speed of a bounce that four steps would not resolve. A perfectly elastic surface has no such speed.
    """
    if restitution >= 1.0:
        return 0.0
    if rules.mode == END or rules.method == EXPLICIT_EULER:
        return 4.0 * push * rules.h / (1.0 - restitution * restitution)
    return 2.0 * push * rules.h


@lean_kernel
def strike(rules, law, solids, j, particle, t, spring, impulses):
    """Newton's law at solid j for a particle on its surface, t (s) into the step: (vx, vy, impulse, stays).

    A particle that leaves is left alone. ``spring``: part of the restitution that holds, 1 or 0. What the
    solid gets (kg m/s for 1 kg) is added to ``impulses`` (k, 2).
    """
    x, y, vx, vy = particle
    _, nx, ny = surface(solids, j, rules.floor, x, y, t)
    ux, uy = surface_velocity(solids, j)
    approach = -((vx - ux) * nx + (vy - uy) * ny)
    if approach <= 0.0:
        return vx, vy, 0.0, False
    ax, ay = acceleration(rules.mask, law, x, y, vx, vy)
    e = spring * (rules.floor_restitution if j == solids.shape[0] else solids[j, 5])
    resting = max(rest_speed(rules, e, max(-(ax * nx + ay * ny), 0.0)), CREEP * (abs(vx) + abs(vy)))
    stays = e == 0.0 or approach <= resting
    change = approach if stays else (1.0 + e) * approach
    if j < solids.shape[0]:
        impulses[j, 0] -= change * nx
        impulses[j, 1] -= change * ny
    return vx + change * nx, vy + change * ny, change, stays


@lean_kernel
def is_there(rules, solids, j):
    """Whether solid j (the floor comes last) is switched on."""
    if j == solids.shape[0]:
        return rules.mask & GROUND_BIT != 0
    return rules.mask & OBSTACLES_BIT != 0


@lean_kernel
def push_out(rules, law, solids, x, y, vx, vy, t, impulses):
    """Put a particle that is inside or on solids on their surfaces and reflect it.

    Returns (x, y, vx, vy, impulse, last, stuck).

    They rebound with mode END only: with the others, one that is inside was born there or run over. Solids
    may overlap: up to MAX_CONTACTS rounds, and after ENOUGH of them no more once one finds it as deep inside
    as the one before: such a place has no way out by pushing. ``last``: the solid last met, or -1. ``stuck``:
    still inside one.
    """
    spring = 1.0 if rules.mode == END else 0.0
    last = -1
    impulse = 0.0
    depth = math.inf
    inside = False
    for turn in range(MAX_CONTACTS):
        before = depth
        depth = 0.0
        inside = False
        for j in range(solids.shape[0] + 1):
            if not is_there(rules, solids, j):
                continue
            gap, nx, ny = surface(solids, j, rules.floor, x, y, t)
            if gap > TOUCH:
                continue
            x -= gap * nx
            y = y - gap * ny if j < solids.shape[0] else rules.floor
            vx, vy, change, _ = strike(rules, law, solids, j, (x, y, vx, vy), t, spring, impulses)
            impulse = max(impulse, change)
            last = j
            depth = max(depth, -gap)
            inside = inside or gap < -TOUCH
        if not inside or (turn >= ENOUGH and depth >= before):
            break
    return x, y, vx, vy, impulse, last, inside


@lean_kernel
def nearest_part(solids, j, x0, y0, x1, y1, t, left):
    """Part of a straight path, in [0, 1], at which it is nearest to the centre of disc j, and terms.

    Returns (part, along, length, outside) with along = -m·d, length = d·d, outside = m·m - R².
    """
    mx = x0 - (solids[j, 0] + t * solids[j, 3])
    my = y0 - (solids[j, 1] + t * solids[j, 4])
    dx = x1 - x0 - left * solids[j, 3]
    dy = y1 - y0 - left * solids[j, 4]
    along = -(mx * dx + my * dy)
    length = dx * dx + dy * dy
    outside = mx * mx + my * my - solids[j, 2] * solids[j, 2]
    if along <= 0.0:
        return 0.0, along, length, outside
    return min(along / length, 1.0), along, length, outside


@lean_kernel
def chord_time(rules, solids, j, x0, y0, x1, y1, t, left):
    """Flight time (s) at which the straight path of ``left`` (s) enters solid j; 2 left if it does not."""
    if j == solids.shape[0]:
        return left * (y0 - rules.floor) / (y0 - y1) if y1 < rules.floor else 2.0 * left
    part, along, length, outside = nearest_part(solids, j, x0, y0, x1, y1, t, left)
    if part == 0.0 or along * along < length * outside:
        return 2.0 * left
    part = outside / (along + math.sqrt(along * along - length * outside))
    return left * max(part, 0.0) if part <= 1.0 else 2.0 * left


@lean_kernel
def gap_after(rules, law, solids, j, particle, t, flown):
    """Distance (m) to solid j after a flight of ``flown`` (s) that begins t (s) into the step."""
    x, y, vx, vy = particle
    x1, y1, _, _ = fly_alone(rules.method, rules.mask, law, x, y, vx, vy, flown)
    return surface(solids, j, rules.floor, x1, y1, t + flown)[0]


@lean_kernel
def root_time(rules, law, solids, j, particle, x1, y1, t, left):
    """Flight time (s) at which the step map enters solid j; 2 left if it does not.

    Regula falsi (Illinois), now and then a bisection, from outside at 0 to a time at which it is inside: the
    end, or where a chord that leaves again is nearest. The answer is on the outer side to rounding.
    """
    high = left
    gap_high = gap_after(rules, law, solids, j, particle, t, high)
    if gap_high >= 0.0:
        if j == solids.shape[0]:
            return 2.0 * left
        high *= nearest_part(solids, j, particle[0], particle[1], x1, y1, t, left)[0]
        gap_high = gap_after(rules, law, solids, j, particle, t, high)
        if gap_high >= 0.0:
            return 2.0 * left
    low = 0.0
    gap_low = gap_after(rules, law, solids, j, particle, t, low)
    moved = 0  # the end that moved last: -1 low, 1 high
    for turn in range(ROOT_ROUNDS):
        middle = low + (high - low) * gap_low / (gap_low - gap_high)
        if turn % 8 == 7 or not low < middle < high:
            middle = 0.5 * (low + high)
            if not low < middle < high:
                break
        gap = gap_after(rules, law, solids, j, particle, t, middle)
        if gap >= 0.0:
            low = middle
            gap_low = gap
            if moved < 0:
                gap_high *= 0.5
            moved = -1
        else:
            high = middle
            gap_high = gap
            if moved > 0:
                gap_low *= 0.5
            moved = 1
        if gap == 0.0:
            break
    return low


@lean_kernel
def first_contact(rules, law, solids, particle, x1, y1, t, left):
    """The first solid on the path of a particle to (x1, y1): (index or -1, flight time in s until then).

    A particle that touches and approaches meets it at once; one that touches and leaves does not, unless it
    ends inside or on it: then at the end. For one that begins inside the time is -1.
    """
    x, y, vx, vy = particle
    earliest = 2.0 * left
    which = -1
    for j in range(solids.shape[0] + 1):
        if not is_there(rules, solids, j):
            continue
        gap, nx, ny = surface(solids, j, rules.floor, x, y, t)
        if gap < -TOUCH:
            return j, -1.0
        if gap <= TOUCH:
            ux, uy = surface_velocity(solids, j)
            if (vx - ux) * nx + (vy - uy) * ny < 0.0:
                return j, 0.0
            gap, nx, ny = surface(solids, j, rules.floor, x1, y1, t + left)
            when = left if gap <= TOUCH else 2.0 * left
        elif rules.mode == ROOT:
            when = root_time(rules, law, solids, j, particle, x1, y1, t, left)
        else:
            when = chord_time(rules, solids, j, x, y, x1, y1, t, left)
        if when < earliest:
            earliest = when
            which = j
    return which, earliest


@lean_kernel(forceinline=True)  # into the loop over the list: a third of that loop's time
def fly_among_solids(rules, law, solids, particle, t, left, impulses):
    """Flight of ``left`` (s), begun t (s) into the step, with what it meets on its path.

    Returns (x, y, vx, vy, greatest impulse, solid last met or -1, time dropped in s). One that cannot be
    pushed out of solids that overlap stays there for the rest of its time, which is dropped: more rounds of
    the same would cost a heap of stones the square of its number, and lead nowhere.
    """
    x, y, vx, vy = particle
    last = -1
    impulse = 0.0
    stays = rules.mode == END
    for _ in range(MAX_CONTACTS):
        x1, y1, ux, uy = fly_alone(rules.method, rules.mask, law, x, y, vx, vy, left)
        if stays:
            x, y, vx, vy, change, met, _ = push_out(rules, law, solids, x1, y1, ux, uy, t + left, impulses)
            return x, y, vx, vy, max(impulse, change), met if met >= 0 else last, 0.0
        which, when = first_contact(rules, law, solids, (x, y, vx, vy), x1, y1, t, left)
        if which < 0:
            return x1, y1, ux, uy, impulse, last, 0.0
        if when < 0.0:
            x, y, vx, vy, change, last, stuck = push_out(rules, law, solids, x, y, vx, vy, t, impulses)
            impulse = max(impulse, change)
            if stuck:
                return x, y, vx, vy, impulse, last, left
            continue
        if rules.mode == ROOT:
            x, y, vx, vy = fly_alone(rules.method, rules.mask, law, x, y, vx, vy, when)
        else:
            part = when / left if left > 0.0 else 0.0  # one born at the very end has no time to fly
            x += part * (x1 - x)
            y += part * (y1 - y)
            vx += part * (ux - vx)
            vy += part * (uy - vy)
        t += when
        left -= when
        gap, nx, ny = surface(solids, which, rules.floor, x, y, t)
        x -= gap * nx
        y = y - gap * ny if which < solids.shape[0] else rules.floor
        vx, vy, change, stays = strike(rules, law, solids, which, (x, y, vx, vy), t, 1.0, impulses)
        impulse = max(impulse, change)
        last = which
        if left <= 0.0:
            return x, y, vx, vy, impulse, last, 0.0
    return x, y, vx, vy, impulse, last, left
