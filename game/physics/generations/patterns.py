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
SALT_DIRECTION, SALT_SPEED, SALT_SCATTER, SALT_LIFE, SALT_REACH = 1, 2, 3, 4, 5


@kernel
def child_identity(parent, row, number):
    """Identity of a child, below 2**62, from its parent's, the row of its birth and its number."""
    a, b = threefry(parent & WORD, (parent >> 32) & WORD, number & WORD, row & WORD)
    return ((a & 0x3FFFFFFF) << 32) | b


@kernel
def burst_velocity(birth, points, seed, identity, number):
    """Velocity (m/s) of child ``number`` relative to what it inherits: (vx, vy, vz).

    birth: its row. identity: the parent's. Children 2 j and 2 j + 1 of paired patterns share their numbers.
    """
    pattern = int(birth[kinds.PATTERN])
    paired = pattern in (kinds.SPHERE, kinds.RING, kinds.DISC)
    draw = number // 2 if paired else number
    sign = -1.0 if paired and number % 2 else 1.0
    a, b = uniform_pair(seed + SALT_DIRECTION, identity & WORD, (identity >> 32) * 8192 + draw)
    faster, _ = uniform_pair(seed + SALT_SPEED, identity & WORD, (identity >> 32) * 8192 + draw)
    speed = sign * birth[kinds.SPEED] * (1.0 + birth[kinds.SPEED_SPREAD] * (2.0 * faster - 1.0))
    dx, dy, dz = direction(birth, pattern, points, a, b, draw, number)
    vx = speed * dx
    vy = speed * dy
    vz = speed * dz
    if birth[kinds.SCATTER] > 0.0:
        a, b = uniform_pair(seed + SALT_SCATTER, identity & WORD, (identity >> 32) * 8192 + draw)
        c, _ = uniform_pair(seed + SALT_REACH, identity & WORD, (identity >> 32) * 8192 + draw)
        away = sign * birth[kinds.SCATTER] * elementary.cbrt(c)
        sx, sy, sz = on_sphere(a, b)
        vx += away * sx
        vy += away * sy
        vz += away * sz
    return vx, vy, vz


@kernel
def on_sphere(a, b):
    """A unit vector, even over all directions, from two random numbers: even in height (Archimedes)."""
    height = 2.0 * a - 1.0
    across = math.sqrt(max(1.0 - height * height, 0.0))
    return across * elementary.cos(FULL_TURN * b), height, across * elementary.sin(FULL_TURN * b)


@kernel
def direction(birth, pattern, points, a, b, draw, number):
    """Where a child goes: a vector of length 1, or less for discs and shapes. a, b: two random numbers."""
    count = birth[kinds.COUNT]
    tilt, spread = birth[kinds.ANGLE], birth[kinds.SPREAD]
    if pattern == kinds.SPHERE:
        return on_sphere(a, b)
    if pattern == kinds.RING:  # half of it; the other half are the opposite ones
        angle = FULL_TURN * draw / count
        x, y = elementary.cos(angle), elementary.cos(spread) * elementary.sin(angle)
        return (
            x * elementary.cos(tilt) - y * elementary.sin(tilt),
            x * elementary.sin(tilt) + y * elementary.cos(tilt),
            elementary.sin(spread) * elementary.sin(angle),
        )
    if pattern == kinds.DISC:
        reach = math.sqrt(a)
        return reach * elementary.cos(FULL_TURN * b), reach * elementary.sin(FULL_TURN * b), 0.0
    if pattern == kinds.CONE:  # turned about its axis by b
        off = spread * (2.0 * a - 1.0)
        aside, depth = elementary.sin(off) * elementary.cos(math.pi * b), elementary.sin(math.pi * b)
        x, y = aside, elementary.cos(off)
        return (
            x * elementary.cos(tilt) + y * elementary.sin(tilt),
            y * elementary.cos(tilt) - x * elementary.sin(tilt),
            elementary.sin(off) * depth,
        )
    if pattern == kinds.ARMS:  # by turns to the back and to the front
        angle = tilt + FULL_TURN * number / count
        flat, out = elementary.cos(spread), elementary.sin(spread) * (1.0 - 2.0 * (number % 2))
        return flat * elementary.sin(angle), flat * elementary.cos(angle), out
    point = int(birth[kinds.FIRST_POINT]) + number % int(birth[kinds.SHAPE_POINTS])
    return points[point, 0], points[point, 1], 0.0


@kernel
def life_of(life, spread, seed, identity):
    """Seconds that a star lives."""
    a, _ = uniform_pair(seed + SALT_LIFE, identity & WORD, identity >> 32)
    return life * (1.0 + spread * (2.0 * a - 1.0))
