"""Particles go with the liquid by the midpoint rule (RK2), and stay out of walls."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.transfer import ONE, split, value_at

NEAR, FAR = 0.02, 0.2  # cells that particles keep from walls
GOLDEN = 0.6180339887498949


@inner_kernel
def clearance(k):
    """Cells that particle k keeps from walls. Each has its own: two that were pressed to one place would stay
    together for ever.
    """
    part = GOLDEN * k
    return NEAR + (FAR - NEAR) * (part - math.floor(part))


@inner_kernel
def _slope(distance, x, y):
    """Distance (cells) at a place, and its slope along x and y; x, y in halves of cells."""
    i, f, _ = split(x, distance.shape[1] - 1)
    j, g, _ = split(y, distance.shape[0] - 1)
    a, b, c, d = distance[j, i], distance[j, i + ONE], distance[j + ONE, i], distance[j + ONE, i + ONE]
    low, high = a + f * (b - a), c + f * (d - c)
    return low + g * (high - low), (b - a) + g * ((d - c) - (b - a)), high - low


@inner_kernel
def _is_loose(rank, x, y):
    """Whether no cell around a place is wet; x, y in points of cells' centres."""
    i, _, _ = split(x, rank.shape[1] - 1)
    j, _, _ = split(y, rank.shape[0] - 1)
    return rank[j, i] == 0 and rank[j, i + ONE] == 0 and rank[j + ONE, i] == 0 and rank[j + ONE, i + ONE] == 0


@inner_kernel
def _stop(particles, k, nx, ny, u, v):
    """Take away what of a particle's speed goes into a wall with this normal and speed."""
    into = (particles.speeds[k, 0] - u) * nx + (particles.speeds[k, 1] - v) * ny
    if into < 0.0:
        particles.speeds[k, 0] -= into * nx
        particles.speeds[k, 1] -= into * ny


@inner_kernel
def _meet_walls(particles, k, x, y, walls):
    """A place (cells) that is out of walls; speeds into them are lost."""
    clear = clearance(k)
    for _ in range(2):
        d, along, up = _slope(walls.distance, 2.0 * x, 2.0 * y)
        length = math.sqrt(along * along + up * up)
        if d >= clear or not length > 0.0:
            break
        nx, ny = along / length, up / length
        x, y = x + (clear - d) * nx, y + (clear - d) * ny
        _stop(particles, k, nx, ny, value_at(walls.u, x, y - 0.5), value_at(walls.v, x - 0.5, y))
    return x, y


@inner_kernel
def _meet_sides(particles, k, x, y, cells):
    """The same at the closed sides of the grid."""
    ny, nx = cells.phi.shape
    clear = clearance(k)
    if x < clear and cells.ends[0] == 0:
        x = clear
        _stop(particles, k, 1.0, 0.0, 0.0, 0.0)
    if x > nx - clear and cells.ends[1] == 0:
        x = nx - clear
        _stop(particles, k, -1.0, 0.0, 0.0, 0.0)
    if y < clear and cells.ends[2] == 0:
        y = clear
        _stop(particles, k, 0.0, 1.0, 0.0, 0.0)
    if y > ny - clear and cells.ends[3] == 0:
        y = ny - clear
        _stop(particles, k, 0.0, -1.0, 0.0, 0.0)
    return x, y


@lean_kernel
def advect(particles, cells, walls, origin, dt, fall):
    """Move all by dt (s); fall: m, what gravity adds in dt beyond the new speed, for drops that fly free."""
    h = origin[2]
    step = dt / h
    for k in range(particles.alive[0]):
        x, y = (particles.places[k, 0] - origin[0]) / h, (particles.places[k, 1] - origin[1]) / h
        if _is_loose(cells.rank, x - 0.5, y - 0.5):
            x, y = x + step * particles.speeds[k, 0], y + step * particles.speeds[k, 1] + fall / h
        else:
            u, v = value_at(cells.u, x, y - 0.5), value_at(cells.v, x - 0.5, y)
            across, upright = x + 0.5 * step * u, y + 0.5 * step * v
            x += step * value_at(cells.u, across, upright - 0.5)
            y += step * value_at(cells.v, across - 0.5, upright)
        if walls.present[0]:
            x, y = _meet_walls(particles, k, x, y, walls)
        x, y = _meet_sides(particles, k, x, y, cells)
        particles.places[k, 0], particles.places[k, 1] = origin[0] + h * x, origin[1] + h * y


@lean_kernel
def fastest(particles):
    """m/s, of all components."""
    most = 0.0
    for k in range(particles.alive[0]):
        most = max(most, max(abs(particles.speeds[k, 0]), abs(particles.speeds[k, 1])))
    return most


@lean_kernel
def drop_outside(particles, low, high):
    """Take away those that are not between two corners (m); how many."""
    kept = 0
    for k in range(particles.alive[0]):
        x, y = particles.places[k, 0], particles.places[k, 1]
        if low[0] <= x <= high[0] and low[1] <= y <= high[1]:
            if kept < k:
                for m in range(2):
                    particles.places[kept, m] = particles.places[k, m]
                    particles.speeds[kept, m] = particles.speeds[k, m]
                for m in range(4):
                    particles.affine[kept, m] = particles.affine[k, m]
            kept += 1
    gone = particles.alive[0] - kept
    particles.alive[0] = kept
    return gone
