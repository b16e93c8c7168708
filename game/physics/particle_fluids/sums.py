"""Sums over the pairs of a fluid of particles.

Densities are relative to rest: α = Σ V W, with the volume V that each particle has at rest. So liquids of
different density meet without a jump (Solenthaler and Pajarola 2008). A force between two particles is made
once and given to both, so momentum is kept to rounding.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.particle_fluids.smoothing import LEAST, slope, weight


class Body(NamedTuple):
    """Particles in sorted order. volume, light: (n,) m³, 1/kg for 1 m of depth; light 0: of a wall.

    share: (n,) of the kernel beyond walls; push: (n, 2) its gradient, 1/m; origin: (n, 2) m where both hold.
    """

    volume: Floats
    light: Floats
    share: Floats
    push: Floats
    origin: Floats


class Felt(NamedTuple):
    """Of each pair: the kernel (m,) 1/m², and its gradient at the first particle (m, 2) 1/m³."""

    weight: Floats
    pull: Floats


@inner_kernel
def share_at(body, i, place):
    """Share of the kernel beyond walls as particle i is elsewhere, in a line from where it was felt."""
    moved = body.push[i, 0] * (place[i, 0] - body.origin[i, 0]) + body.push[i, 1] * (
        place[i, 1] - body.origin[i, 1]
    )
    return max(body.share[i] + moved, 0.0)


@lean_kernel
def weigh(pairs, support, kinds, felt):
    """Fill what pairs feel; kinds: kernels of the value and of the gradient."""
    of_value, of_slope = kinds
    area = 1.0 / (support * support)
    for k in range(pairs.start[-1]):
        q = pairs.gap[k] / support
        felt.weight[k] = area * weight(of_value, q)
        steep = area / support * slope(of_slope, max(q, LEAST))
        felt.pull[k, 0] = steep * pairs.unit[k, 0]
        felt.pull[k, 1] = steep * pairs.unit[k, 1]


@lean_kernel
def fill_density(pairs, felt, body, own, density):
    """Relative densities (n,); own: the kernel at a particle's own place, 1/m²."""
    for i in range(len(density)):
        density[i] = body.volume[i] * own + body.share[i]
    for i in range(len(density)):
        total = 0.0
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            total += body.volume[j] * felt.weight[k]
            density[j] += body.volume[i] * felt.weight[k]
        density[i] += total


@inner_kernel
def add_gradients(pairs, felt, body, total):
    """Gradient of each density by its own particle's place, (n, 2) 1/m."""
    for i in range(len(total)):
        total[i, 0], total[i, 1] = body.push[i, 0], body.push[i, 1]
    for i in range(len(total)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            gx, gy = felt.pull[k, 0], felt.pull[k, 1]
            total[i, 0] += body.volume[j] * gx
            total[i, 1] += body.volume[j] * gy
            total[j, 0] -= body.volume[i] * gx
            total[j, 1] -= body.volume[i] * gy


@lean_kernel
def fill_gradients(pairs, felt, body, total):
    """`add_gradients`, for callers in Python."""
    add_gradients(pairs, felt, body, total)


@inner_kernel
def _widen(spread, i, x, y):
    """Add g gᵀ / |g| to row i of a table of symmetric matrices (xx, yy) and half their xy."""
    size = math.sqrt(x * x + y * y)
    if size > 0.0:
        spread[0, i] += x * x / size
        spread[1, i] += y * y / size
        spread[2, i] += x * y / size


@lean_kernel
def fill_bound(pairs, felt, body, total, spread, bound):
    """A diagonal (n,) that is at least the matrix of the pressures, whatever the densities.

    A particle k feels the pressures about it by gradients g_ik: it adds G = Σ g_ik g_jk / m_k to the matrix.
    Let t be the largest eigenvalue of Σ_i g_ik g_ikᵀ / |g_ik|. Then G is at most diag(|g_ik| t / m_k), by
    Cauchy's inequality, and a Jacobi step divided by the sum of these cannot overshoot. The matrix's own
    diagonal is too small: the matrix is up to 2.2 times as large on a lattice, 3.3 times in disorder, and
    5 times where light particles lie among heavy ones. total: (n, 2), spread: (3, n), scratch.
    """
    count = len(bound)
    add_gradients(pairs, felt, body, total)
    for i in range(count):
        spread[0, i], spread[1, i], spread[2, i] = 0.0, 0.0, 0.0
        _widen(spread, i, total[i, 0], total[i, 1])
    for i in range(count):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            if body.light[j] > 0.0:
                _widen(spread, i, body.volume[i] * felt.pull[k, 0], body.volume[i] * felt.pull[k, 1])
            if body.light[i] > 0.0:
                _widen(spread, j, body.volume[j] * felt.pull[k, 0], body.volume[j] * felt.pull[k, 1])
    for i in range(count):
        half, apart = 0.5 * (spread[0, i] + spread[1, i]), 0.5 * (spread[0, i] - spread[1, i])
        spread[0, i] = body.light[i] * (half + math.sqrt(apart * apart + spread[2, i] * spread[2, i]))
        size = math.sqrt(total[i, 0] * total[i, 0] + total[i, 1] * total[i, 1])
        bound[i] = size * spread[0, i]
    for i in range(count):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            size = math.sqrt(felt.pull[k, 0] * felt.pull[k, 0] + felt.pull[k, 1] * felt.pull[k, 1])
            bound[i] += body.volume[j] * size * spread[0, j]
            bound[j] += body.volume[i] * size * spread[0, i]
    for i in range(count):
        bound[i] *= body.volume[i]


@lean_kernel
def push_by_pressure(pairs, felt, body, pressure, pushed):
    """Accelerations (n, 2) by pressures (n,): what follows from each particle's own constraint."""
    for i in range(len(pressure)):
        own = body.light[i] * body.volume[i] * pressure[i]
        pushed[i, 0], pushed[i, 1] = -own * body.push[i, 0], -own * body.push[i, 1]
    for i in range(len(pressure)):
        ax, ay = 0.0, 0.0
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            both = body.volume[i] * body.volume[j] * (pressure[i] + pressure[j])
            fx, fy = both * felt.pull[k, 0], both * felt.pull[k, 1]
            ax += fx
            ay += fy
            pushed[j, 0] += body.light[j] * fx
            pushed[j, 1] += body.light[j] * fy
        pushed[i, 0] -= body.light[i] * ax
        pushed[i, 1] -= body.light[i] * ay


@lean_kernel
def fill_rates(pairs, felt, body, velocity, rate):
    """Rates (n,) 1/s at which relative densities grow as particles go at velocities (n, 2)."""
    for i in range(len(rate)):
        rate[i] = body.push[i, 0] * velocity[i, 0] + body.push[i, 1] * velocity[i, 1]
    for i in range(len(rate)):
        total = 0.0
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            closing = felt.pull[k, 0] * (velocity[i, 0] - velocity[j, 0]) + felt.pull[k, 1] * (
                velocity[i, 1] - velocity[j, 1]
            )
            total += body.volume[j] * closing
            rate[j] += body.volume[i] * closing
        rate[i] += total


@lean_kernel
def attract(pairs, support, strength, kind, changes):
    """Surface tension as a force between pairs: apart below a third of the support, together beyond.

    strength: (kinds, kinds) N for volumes of 1; changes: (velocity, body, dt). The shape is close to
    the cosine of Tartakovsky and Meakin (2005).
    """
    velocity, body, dt = changes
    for i in range(len(kind)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            q = pairs.gap[k] / support
            force = dt * strength[kind[i], kind[j]] * body.volume[i] * body.volume[j] * cohesion(q)
            fx, fy = force * pairs.unit[k, 0], force * pairs.unit[k, 1]
            velocity[i, 0] -= body.light[i] * fx
            velocity[i, 1] -= body.light[i] * fy
            velocity[j, 0] += body.light[j] * fx
            velocity[j, 1] += body.light[j] * fy


@inner_kernel
def cohesion(q):
    """-cos(3π q / 2) by a polynomial that has its zeros at 1/3 and 1, and -1 at 0."""
    return (q - 1.0 / 3.0) * (1.0 - q) * (3.0 + 4.2 * q)


@lean_kernel
def spread_heat(pairs, felt, body, values, spread):
    """Spread temperatures by conduction. values: (temperature, heat), (n,); spread: diffusivity times dt, m².

    Heat is in kelvin of the liquid's own heat capacity; what one loses the other gains, by volume.
    """
    temperature, heat = values
    for i in range(len(temperature)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            if pairs.gap[k] > 0.0 and body.light[i] > 0.0 and body.light[j] > 0.0:
                steep = math.sqrt(felt.pull[k, 0] * felt.pull[k, 0] + felt.pull[k, 1] * felt.pull[k, 1])
                flow = 2.0 * spread * steep / pairs.gap[k] * (temperature[j] - temperature[i])
                heat[i] += body.volume[j] * flow
                heat[j] -= body.volume[i] * flow


@inner_kernel
def add_bounded(values, changes, most):
    """Add changes (n, 2), all made smaller alike so that none is longer than ``most``: that keeps sums."""
    longest = 0.0
    for i in range(len(changes)):
        longest = max(longest, changes[i, 0] * changes[i, 0] + changes[i, 1] * changes[i, 1])
    longest = math.sqrt(longest)
    share = most / longest if longest > most else 1.0
    for i in range(len(changes)):
        values[i, 0] += share * changes[i, 0]
        values[i, 1] += share * changes[i, 1]


@lean_kernel
def add_changes(values, changes, most):
    """`add_bounded`, for callers in Python."""
    add_bounded(values, changes, most)


@lean_kernel
def keep_apart(pairs, body, place, least, moved):
    """Move pairs nearer than ``least`` (m) apart by half of what they lack, by their inverse masses.

    A kernel that is flat at its middle does not part two that have come to one spot. moved: (n, 2) scratch.
    """
    for i in range(len(place)):
        moved[i, 0], moved[i, 1] = 0.0, 0.0
    for i in range(len(place)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            both = body.light[i] + body.light[j]
            dx, dy = place[i, 0] - place[j, 0], place[i, 1] - place[j, 1]
            gap = math.sqrt(dx * dx + dy * dy)
            if gap >= least or both == 0.0:
                continue
            x, y = pairs.unit[k, 0], pairs.unit[k, 1]
            if gap > 1e-150:
                x, y = dx / gap, dy / gap
            way = 0.5 * (least - gap) / both
            moved[i, 0] += way * body.light[i] * x
            moved[i, 1] += way * body.light[i] * y
            moved[j, 0] -= way * body.light[j] * x
            moved[j, 1] -= way * body.light[j] * y
    add_bounded(place, moved, least)
