"""Laws that move particles by an explicit force or displacement, as their papers print them.

"mueller-2003" (P09): pressure from the state p = k (α - 1) and a viscous force, by three kernels.
"clavet-2005" (P11): particles are displaced so that two densities, one of them of near neighbours, relax.
"position-based" (Macklin and Müller 2013): each density is a constraint of positions. In the prints of 2005
and 2013 masses are equal; here each pair shares its displacement by inverse masses, so momentum is kept. In
2005 particles are moved one after the other; here all at once, so their order does not matter.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.particle_fluids.smoothing import LEAST, POLY6, SPIKY, slope, weight
from game.physics.particle_fluids.sums import add_bounded, share_at

SOFT = 0.02  # of the mean response: what keeps lone particles' multipliers finite
MOST_MOVED = 0.25  # supports, in one displacement
JACOBI = 0.4  # of a displacement by all constraints at once, which overshoots
NEAR_STIFFNESS = 2.5  # of the near density's pressure, against the other's


@lean_kernel
def viscous_force(pairs, body, viscosity, kind, support, changes):
    """Müller's explicit viscosity, by a kernel whose Laplacian is 40/π (1 - q) in the plane.

    changes: (velocity after, before, dt).
    """
    after, before, dt = changes
    area = 1.0 / (support * support)
    for i in range(len(kind)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            curved = 40.0 / math.pi * area * area * (1.0 - pairs.gap[k] / support)
            mean = 0.5 * (viscosity[kind[i]] + viscosity[kind[j]])
            force = dt * mean * body.volume[i] * body.volume[j] * curved
            for a in range(2):
                change = force * (before[j, a] - before[i, a])
                after[i, a] += body.light[i] * change
                after[j, a] -= body.light[j] * change


@inner_kernel
def between_now(place, i, j, x, y):
    """Gap of a pair that moves, and its direction; the one it had where they meet."""
    dx, dy = place[i, 0] - place[j, 0], place[i, 1] - place[j, 1]
    gap = math.sqrt(dx * dx + dy * dy)
    if gap > 1e-150:
        return gap, dx / gap, dy / gap
    return 0.0, x, y


@lean_kernel
def relax_twice(pairs, body, place, support, moved, work, rules):
    """One double density relaxation of places (n, 2) m; moved: (n, 2) scratch.

    rules: (stiffness 1/s², rest, beyond, dt). rest: Σ (1 - q)² of a particle inside liquid at rest.
    beyond: how many times that is the density of no pressure, so that both pressures balance at rest.
    """
    stiffness, rest, beyond, dt = rules
    near, far = work.response, work.density
    for i in range(len(place)):
        near[i], far[i] = body.share[i] * rest, body.share[i] * rest
        moved[i, 0], moved[i, 1] = 0.0, 0.0
    for i in range(len(place)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            gap, _, _ = between_now(place, i, j, 0.0, 0.0)
            room = max(1.0 - gap / support, 0.0)
            far[i] += room * room
            far[j] += room * room
            near[i] += room * room * room
            near[j] += room * room * room
    scale = dt * dt * stiffness * support
    for i in range(len(place)):
        if body.light[i] > 0.0:
            held = scale * max(far[i] / rest - 1.0, 0.0) / beyond * support
            moved[i, 0] -= held * body.push[i, 0]
            moved[i, 1] -= held * body.push[i, 1]
    for i in range(len(place)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            both = body.light[i] + body.light[j]
            gap, nx, ny = between_now(place, i, j, pairs.unit[k, 0], pairs.unit[k, 1])
            room = max(1.0 - gap / support, 0.0)
            if both == 0.0 or room == 0.0:
                continue
            pressed = 0.5 * (far[i] + far[j]) / (rest * beyond) - 1.0
            nearly = NEAR_STIFFNESS * 0.5 * (near[i] + near[j]) / rest
            way = min(scale * (pressed * room + nearly * room * room), 0.25 * support)
            moved[i, 0] += way * body.light[i] / both * nx
            moved[i, 1] += way * body.light[i] / both * ny
            moved[j, 0] -= way * body.light[j] / both * nx
            moved[j, 1] -= way * body.light[j] / both * ny
    add_bounded(place, moved, MOST_MOVED * support)


@lean_kernel
def meet_densities(pairs, body, place, support, work, now, rules):
    """One iteration of position based fluids on places (n, 2) m; rules: (clumping strength, rest density).

    now: (m, 4) scratch, what pairs feel at these places: both sums over them need it, and roots are dear.

    Kernels as printed: poly6 for densities, spiky for gradients. Returns the mean excess of density before.
    """
    strength, rest = rules
    area, count = 1.0 / (support * support), len(place)
    density, response, total, pushed = work.density, work.response, work.total, work.pushed
    for i in range(count):
        density[i] = body.volume[i] * area * weight(POLY6, 0.0) / rest + share_at(body, i, place)
        response[i] = 0.0
        total[i, 0], total[i, 1] = body.push[i, 0], body.push[i, 1]
        pushed[i, 0], pushed[i, 1] = 0.0, 0.0
    for i in range(count):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            gap, nx, ny = between_now(place, i, j, pairs.unit[k, 0], pairs.unit[k, 1])
            q = gap / support
            shape, steep = weight(POLY6, q), area / support * slope(SPIKY, max(q, LEAST))
            value = area * shape / rest
            now[k, 0], now[k, 1], now[k, 2], now[k, 3] = nx, ny, shape, steep
            density[i] += body.volume[j] * value
            density[j] += body.volume[i] * value
            total[i, 0] += body.volume[j] * steep * nx
            total[i, 1] += body.volume[j] * steep * ny
            total[j, 0] -= body.volume[i] * steep * nx
            total[j, 1] -= body.volume[i] * steep * ny
            response[i] += body.volume[j] * body.volume[j] * body.light[j] * steep * steep
            response[j] += body.volume[i] * body.volume[i] * body.light[i] * steep * steep
    error, wanted, stiff = 0.0, 0, 0.0
    for i in range(count):
        square = total[i, 0] * total[i, 0] + total[i, 1] * total[i, 1]
        response[i] += body.light[i] * square
        if body.light[i] > 0.0:
            error += max(density[i] - 1.0, 0.0)
            stiff += response[i] / body.light[i]
            wanted += 1
    soft = SOFT * stiff / max(wanted, 1)
    for i in range(count):
        if body.light[i] > 0.0 and response[i] > 0.0:
            density[i] = JACOBI * max(density[i] - 1.0, 0.0) / (response[i] + soft * body.light[i])
        else:
            density[i] = 0.0
    clump_at = weight(POLY6, 0.2)
    for i in range(count):
        pushed[i, 0] -= body.light[i] * density[i] * body.push[i, 0]
        pushed[i, 1] -= body.light[i] * density[i] * body.push[i, 1]
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            nx, ny, steep = now[k, 0], now[k, 1], now[k, 3]
            ratio = now[k, 2] / clump_at
            heavy = max(body.light[i], body.light[j])
            apart = strength * support * ratio * ratio * ratio * ratio / heavy if heavy > 0.0 else 0.0
            both = (density[i] * body.volume[j] + density[j] * body.volume[i]) * steep - apart
            pushed[i, 0] -= body.light[i] * both * nx
            pushed[i, 1] -= body.light[i] * both * ny
            pushed[j, 0] += body.light[j] * both * nx
            pushed[j, 1] += body.light[j] * both * ny
    add_bounded(place, pushed, MOST_MOVED * support)
    return error / max(wanted, 1)


@lean_kernel
def smooth_velocities(pairs, body, felt, share, velocity, before):
    """XSPH: each velocity goes a share of the way to those around it (Schechter and Bridson 2012)."""
    for i in range(len(velocity)):
        before[i, 0], before[i, 1] = velocity[i, 0], velocity[i, 1]
    for i in range(len(velocity)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            both = body.light[i] + body.light[j]
            if both == 0.0:
                continue
            part = share * felt.weight[k] * (body.volume[i] + body.volume[j]) / both
            for a in range(2):
                change = part * (before[j, a] - before[i, a])
                velocity[i, a] += body.light[i] * change
                velocity[j, a] -= body.light[j] * change
