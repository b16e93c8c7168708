"""The rule that ends chatter: contacts that repeat without end in finite time (Zeno's paradox).

A ball pressed against another, or against a rail, by its own spin bounces ever faster and lower. The k-th
further repeat of a contact within CHATTER_TIME, after ALLOWED_REPEATS, leaves with a separating speed of at
least FIRST_SPEED 4^k, at most LARGEST_SPEED. The energy for it is taken from the spin of the balls in the
contact; what they do not have is not given. So no chatter lasts longer than about fifteen contacts in a row
while there is spin. No balls sink into each other, and energy never rises. A contact that has repeated
LAST_REPEATS times and still gets less than the rule asks for has no energy left for it: see `settling`.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel

CHATTER_TIME = 0.02  # s
ALLOWED_REPEATS = 3
LAST_REPEATS = 30  # twice as many as chatter takes that is paid for
FIRST_SPEED = 1e-6  # m/s
LARGEST_SPEED = 3e-3  # m/s; apart for 2 ms on cloth with mu = 0.2


@inner_kernel(inline="always")
def least_separating_speed(repeats):
    """Separating speed that the rule asks for after so many repeats, at least ALLOWED_REPEATS, m/s."""
    speed = FIRST_SPEED
    for _ in range(repeats - ALLOWED_REPEATS):
        speed *= 4.0
        if speed >= LARGEST_SPEED:
            return LARGEST_SPEED
    return speed


@inner_kernel
def separate(state, i, j, nx, ny, demanded):
    """Raise the separating speed of balls i and j to `demanded` m/s, at the cost of their spin.

    n is the unit vector from i to j; for a ball and a rail j is -1, and n points into the rail. Returns
    whether they separate as fast as that.
    """
    count = 1 if j < 0 else 2
    separating = 0.0
    inverse = 0.0
    available = 0.0
    for side in range(count):
        ball = i if side == 0 else j
        sign = -1.0 if side == 0 else 1.0
        separating += sign * (state[s.VX, ball] * nx + state[s.VY, ball] * ny)
        inverse += 1.0 / state[s.MASS, ball]
        inertia = 0.4 * state[s.MASS, ball] * state[s.RADIUS, ball] * state[s.RADIUS, ball]
        for row in range(s.WX, s.WZ + 1):
            available += 0.5 * inertia * state[row, ball] * state[row, ball]
    if separating >= demanded:
        return True
    start = max(separating, 0.0)
    cost = 0.5 * (demanded - start) * (demanded + start) / inverse
    speed = demanded
    factor = 0.0
    if cost > available:
        speed = math.sqrt(start * start + 2.0 * available * inverse)
    elif available > 0.0:
        factor = math.sqrt(1.0 - cost / available)
    impulse = (speed - separating) / inverse
    for side in range(count):
        ball = i if side == 0 else j
        push = (-impulse if side == 0 else impulse) / state[s.MASS, ball]
        state[s.VX, ball] += push * nx
        state[s.VY, ball] += push * ny
        for row in range(s.WX, s.WZ + 1):
            state[row, ball] *= factor
    return speed == demanded
