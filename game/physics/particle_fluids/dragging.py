"""Viscosity, implicitly: honey at the step of water (Weiler, Koschier, Brand and Bender 2018).

Each pair resists only along its own direction, so angular momentum is kept as well:

    ν ∇² v  ≈  8 ν Σ V (v · n) |W'| / r  n

The factor of the plane is 2 (d + 2) = 8. The system (M + dt K) v = M v₀ is symmetric. It is solved by
conjugate gradients with the masses, whose steps keep momentum however soon they end.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel

PLANE = 8.0
LEAST_GAP = 1e-3  # of the support


@lean_kernel
def fill_drags(pairs, felt, body, drags, values):
    """Fill kg/s of each pair (m,) and of each particle at a wall (n,).

    drags: (pair, wall); values: (viscosity (kinds,) Pa s, kind (n,), gap to a wall m,
    support m, share of the wall's drag).
    """
    pair, wall = drags
    viscosity, kind, spacing, support, sticking = values
    for i in range(len(kind)):
        steep = math.sqrt(body.push[i, 0] * body.push[i, 0] + body.push[i, 1] * body.push[i, 1])
        wall[i] = 0.5 * PLANE * sticking * viscosity[kind[i]] * body.volume[i] * steep / spacing
    for i in range(len(kind)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            a, b = viscosity[kind[i]], viscosity[kind[j]]
            mean = 2.0 * a * b / (a + b) if a + b > 0.0 else 0.0
            if body.light[i] == 0.0 or body.light[j] == 0.0:
                mean = sticking * (a if body.light[j] == 0.0 else b)
            steep = math.sqrt(felt.pull[k, 0] * felt.pull[k, 0] + felt.pull[k, 1] * felt.pull[k, 1])
            gap = max(pairs.gap[k], LEAST_GAP * support)
            pair[k] = PLANE * mean * body.volume[i] * body.volume[j] * steep / gap


@inner_kernel
def product(pairs, body, drags, dt, vector, result):
    """(M + dt K) of a vector (n, 2); rows of wall particles are 0."""
    pair, wall = drags
    for i in range(len(vector)):
        heavy = 1.0 / body.light[i] + dt * wall[i] if body.light[i] > 0.0 else 0.0
        result[i, 0], result[i, 1] = heavy * vector[i, 0], heavy * vector[i, 1]
    for i in range(len(vector)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            x, y = pairs.unit[k, 0], pairs.unit[k, 1]
            force = dt * pair[k] * ((vector[i, 0] - vector[j, 0]) * x + (vector[i, 1] - vector[j, 1]) * y)
            if body.light[i] > 0.0:
                result[i, 0] += force * x
                result[i, 1] += force * y
            if body.light[j] > 0.0:
                result[j, 0] -= force * x
                result[j, 1] -= force * y


@lean_kernel
def drag_along(pairs, body, drags, velocity, vectors, rules):
    """Let viscosity act for dt (s) on velocities (n, 2). vectors: four of (n, 2), scratch.

    rules: (dt, error, iterations); error: of the residual against the momentum. Returns the iterations made.
    """
    dt, allowed, most = rules
    rest, turned, step, image = vectors
    count = len(velocity)
    product(pairs, body, drags, dt, velocity, image)
    size, along = 0.0, 0.0
    for i in range(count):
        for a in range(2):
            rest[i, a], step[i, a] = 0.0, 0.0
            if body.light[i] > 0.0:
                heavy = 1.0 / body.light[i]
                size += heavy * velocity[i, a] * heavy * velocity[i, a]
                rest[i, a] = heavy * velocity[i, a] - image[i, a]
                step[i, a] = rest[i, a] / heavy
            along += rest[i, a] * step[i, a]
    made = 0
    while made < most and along > 0.0:
        product(pairs, body, drags, dt, step, image)
        curved = 0.0
        for i in range(count):
            curved += step[i, 0] * image[i, 0] + step[i, 1] * image[i, 1]
        if not curved > 0.0:
            break
        length, left, before = along / curved, 0.0, along
        along = 0.0
        for i in range(count):
            if body.light[i] == 0.0:
                continue
            for a in range(2):
                velocity[i, a] += length * step[i, a]
                rest[i, a] -= length * image[i, a]
                left += rest[i, a] * rest[i, a]
                turned[i, a] = rest[i, a] * body.light[i]
                along += rest[i, a] * turned[i, a]
        made += 1
        if left <= allowed * allowed * size:
            break
        for i in range(count):
            if body.light[i] > 0.0:
                step[i, 0] = turned[i, 0] + along / before * step[i, 0]
                step[i, 1] = turned[i, 1] + along / before * step[i, 1]
    return made
