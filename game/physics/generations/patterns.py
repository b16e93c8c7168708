"""Velocities with which stars leave a burst, and the names by which random numbers know each star.

A star's random numbers are a function of its identity, and that of its parent's and of which child it is: so
what becomes of one hangs neither on the order of the pool nor on anybody else.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.generations import kinds
from game.physics.kernels import elementary
from game.physics.particles.random_numbers import WORD, threefry, uniform_pair

FULL_TURN = 2.0 * math.pi
SALT_DIRECTION, SALT_SPEED, SALT_SCATTER, SALT_LIFE = 1, 2, 3, 4


@kernel
def child_identity(parent, row, number):
    """Identity of a child, below 2**62, from its parent's, the row of its birth and its number."""
    a, b = threefry(parent & WORD, (parent >> 32) & WORD, number & WORD, row & WORD)
    return ((a & 0x3FFFFFFF) << 32) | b


@kernel
def burst_velocity(birth, points, seed, identity, number):
    """Velocity (m/s) of child ``number`` relative to what it inherits: (vx, vy).

    birth: its row. identity: the parent's. Children 2 j and 2 j + 1 of paired patterns share their numbers.
    """
    pattern = int(birth[kinds.PATTERN])
    paired = pattern in (kinds.SPHERE, kinds.RING, kinds.DISC)
    draw = number // 2 if paired else number
    sign = -1.0 if paired and number % 2 else 1.0
    a, b = uniform_pair(seed + SALT_DIRECTION, identity & WORD, (identity >> 32) * 8192 + draw)
    faster, _ = uniform_pair(seed + SALT_SPEED, identity & WORD, (identity >> 32) * 8192 + draw)
    speed = sign * birth[kinds.SPEED] * (1.0 + birth[kinds.SPEED_SPREAD] * (2.0 * faster - 1.0))
    dx, dy = direction(birth, pattern, points, a, b, draw, number)
    vx = speed * dx
    vy = speed * dy
    if birth[kinds.SCATTER] > 0.0:
        a, b = uniform_pair(seed + SALT_SCATTER, identity & WORD, (identity >> 32) * 8192 + draw)
        away = sign * birth[kinds.SCATTER] * math.sqrt(a)
        vx += away * elementary.cos(FULL_TURN * b)
        vy += away * elementary.sin(FULL_TURN * b)
    return vx, vy


@kernel
def direction(birth, pattern, points, a, b, draw, number):
    """Where a child goes: a vector of length 1 or, seen from the side, less. a, b: two random numbers."""
    count = birth[kinds.COUNT]
    tilt = birth[kinds.ANGLE]
    if pattern == kinds.SPHERE:  # uniform on a sphere: its height is uniform, and the view is from the side
        height = 2.0 * a - 1.0
        across = math.sqrt(max(1.0 - height * height, 0.0)) * elementary.cos(FULL_TURN * b)
        return across, height
    if pattern == kinds.RING:  # half of it; the other half are the opposite ones
        angle = FULL_TURN * draw / count
        flat = elementary.cos(birth[kinds.SPREAD])
        x, y = elementary.cos(angle), flat * elementary.sin(angle)
        return x * elementary.cos(tilt) - y * elementary.sin(tilt), x * elementary.sin(
            tilt
        ) + y * elementary.cos(tilt)
    if pattern == kinds.DISC:
        reach = math.sqrt(a)
        return reach * elementary.cos(FULL_TURN * b), reach * elementary.sin(FULL_TURN * b)
    if pattern == kinds.CONE:
        angle = tilt + birth[kinds.SPREAD] * (2.0 * a - 1.0)
        return elementary.sin(angle), elementary.cos(angle)
    if pattern == kinds.ARMS:
        angle = tilt + FULL_TURN * number / count
        return elementary.sin(angle), elementary.cos(angle)
    point = int(birth[kinds.FIRST_POINT]) + number % int(birth[kinds.SHAPE_POINTS])
    return points[point, 0], points[point, 1]


@kernel
def life_of(life, spread, seed, identity):
    """Seconds that a star lives."""
    a, _ = uniform_pair(seed + SALT_LIFE, identity & WORD, identity >> 32)
    return life * (1.0 + spread * (2.0 * a - 1.0))
