"""The end of chatter that nothing pays for: balls wedged between rails, or pressed together, stop as one.

Two balls in the mouth of a pocket are in contact with each other and with a facing each. Their closing
speeds die out in ever shorter bounces, an infinite number of them in a finite time, and cloth friction
presses them together again.
`chatter.separate` ends that at the cost of their spin; where there is no spin left, the contact would go on
without end. What is then within JOINED of each other is one body that does not rebound (a perfectly
inelastic cluster): it goes on with its common velocity, less what would take it into a rail that it
contact, and without spin. Two rails that face each other take all of it. Momentum is kept but for what the
rails take, and energy falls. All move alike from there on, on the same cloth, so none closes on another.
"""

from __future__ import annotations

import math

from game.billiards.exact.cluster import gap_at
from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.motion import advance, enter_phase

JOINED = 1e-7  # m; what is so near belongs to the group: its bounces at 3 mm/s take 30 microseconds


@inner_kernel
def _gather_group(state, modes, i, now, physics):
    """Write all balls that hang together with ball i to row MEMBER of modes, at `now`; returns how many."""
    n = state.shape[1]
    for k in range(n):
        modes[s.MARK, k] = 0
    modes[s.MEMBER, 0] = i
    modes[s.MARK, i] = 1
    found = 1
    head = 0
    while head < found:
        a = modes[s.MEMBER, head]
        head += 1
        for k in range(n):
            if (
                modes[s.MARK, k] == 0
                and modes[s.MOTION, k] != s.POCKETED
                and modes[s.MOTION, k] != s.AIRBORNE
            ):
                gap, _, _ = gap_at(state, a, k, now)
                if gap <= JOINED:
                    modes[s.MARK, k] = 1
                    modes[s.MEMBER, found] = k
                    found += 1
    for q in range(found):
        advance(state, modes, modes[s.MEMBER, q], now, physics)
    return found


@inner_kernel
def _common_velocity(state, modes, found):
    """Momentum of the group over its mass, m/s. Sums are of numbers on a grid: any order gives the same,
    to 2^-40 of the largest."""
    largest = 0.0
    heaviest = 0.0
    for q in range(found):
        k = modes[s.MEMBER, q]
        mass = state[s.MASS, k]
        largest = max(largest, mass * max(abs(state[s.VX, k]), abs(state[s.VY, k])))
        heaviest = max(heaviest, mass)
    grid = 1.5 * math.ldexp(1.0, math.frexp(largest)[1] + 12)
    mass_grid = 1.5 * math.ldexp(1.0, math.frexp(heaviest)[1] + 12)
    x = 0.0
    y = 0.0
    whole = 0.0
    for q in range(found):
        k = modes[s.MEMBER, q]
        mass = state[s.MASS, k]
        x += (mass * state[s.VX, k] + grid) - grid
        y += (mass * state[s.VY, k] + grid) - grid
        whole += (mass + mass_grid) - mass_grid
    return x / whole, y / whole


@inner_kernel
def _rail_at(state, modes, found, number, cushions, jaws):
    """Whether a ball of the group is in contact with that rail, and the unit vector from the rail to it.

    Rails are numbered for each ball of the group in turn: the cushions, then the jaws.
    """
    rails = cushions.shape[0] + jaws.shape[0]
    ball = modes[s.MEMBER, number // rails]
    k = number % rails
    if k < cushions.shape[0]:
        nx = cushions[k, s.NORMAL_X]
        ny = cushions[k, s.NORMAL_Y]
        x = state[s.X, ball] - cushions[k, s.FROM_X]
        y = state[s.Y, ball] - cushions[k, s.FROM_Y]
        dx = cushions[k, s.TO_X] - cushions[k, s.FROM_X]
        dy = cushions[k, s.TO_Y] - cushions[k, s.FROM_Y]
        along = x * dx + y * dy
        contact = abs(x * nx + y * ny - state[s.RADIUS, ball]) <= JOINED
        return contact and 0.0 <= along <= dx * dx + dy * dy, nx, ny
    k -= cushions.shape[0]
    x = state[s.X, ball] - jaws[k, 0]
    y = state[s.Y, ball] - jaws[k, 1]
    distance = math.sqrt(x * x + y * y)
    return abs(distance - jaws[k, 2] - state[s.RADIUS, ball]) <= JOINED, x / distance, y / distance


@inner_kernel
def _is_free(state, modes, found, vx, vy, cushions, jaws):
    """True if no ball of the group goes into a rail in contact with the velocity v."""
    rails = cushions.shape[0] + jaws.shape[0]
    rounding = -1e-12 * math.sqrt(vx * vx + vy * vy)
    for number in range(found * rails):
        contact, nx, ny = _rail_at(state, modes, found, number, cushions, jaws)
        if contact and vx * nx + vy * ny < rounding:
            return False
    return True


@inner_kernel
def _freed_velocity(state, modes, found, vx, vy, cushions, jaws):
    """The velocity nearest to v that takes no ball of the group into a rail in contact: v itself, v
    along one of the rails, or none."""
    if _is_free(state, modes, found, vx, vy, cushions, jaws):
        return vx, vy
    best_x = 0.0
    best_y = 0.0
    for number in range(found * (cushions.shape[0] + jaws.shape[0])):
        contact, nx, ny = _rail_at(state, modes, found, number, cushions, jaws)
        into = vx * nx + vy * ny
        if contact and into < 0.0:
            x = vx - into * nx
            y = vy - into * ny
            if x * x + y * y > best_x * best_x + best_y * best_y and _is_free(
                state, modes, found, x, y, cushions, jaws
            ):
                best_x = x
                best_y = y
    return best_x, best_y


@inner_kernel
def settle_group(state, modes, i, now, cushions, jaws, physics):
    """Ball i and all that hang together with it go on as one body, at `now` (s).

    Its balls are written to row MEMBER of modes, each in a new phase. Returns how many there are.
    """
    found = _gather_group(state, modes, i, now, physics)
    vx, vy = _common_velocity(state, modes, found)
    vx, vy = _freed_velocity(state, modes, found, vx, vy, cushions, jaws)
    for q in range(found):
        k = modes[s.MEMBER, q]
        state[s.VX, k] = vx
        state[s.VY, k] = vy
        for row in range(s.WX, s.WZ + 1):
            state[row, k] = 0.0
        enter_phase(state, modes, k, s.SLIDING, physics)
    return found
