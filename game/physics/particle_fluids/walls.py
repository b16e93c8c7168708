"""Walls of a vessel for particles that have no neighbours there: the share of a kernel beyond the wall.

What a particle near a wall lacks in density is the integral of its kernel over the wall. "weights" takes it
from a table over the distance of the nearest wall, taken for endless and plane (Harada, Koshizuka and
Kawaguchi 2007). "exact" adds over the edges of the vessel what the divergence theorem makes of the integral,
so corners and gaps are right (after Ferrand and others 2013):

    ∫ W dA = Σ ∫ F(r) / r² (r · n) ds,   F(r) = ∫₀ʳ W s ds,   and its gradient   - Σ n ∫ W ds

"particles" sets a row of particles that do not move on the edges; each has the volume 1 / Σ W of its row
(Akinci and others 2012). "none": particles are stopped, and lack density.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.particle_fluids.smoothing import fill_kernel, weight

WALLS = ("none", "weights", "exact", "particles")
NONE, WEIGHTS, EXACT, PARTICLES = range(4)
TABLE = 512
GAUSS = 8  # points on each half of a chord
MOST_EDGES = 2000
MARGIN = 0.1  # spacings that a particle keeps off a wall


class WallTable(NamedTuple):
    """Of a kernel of support 1: TABLE + 1 rows over r² (flux), over the gap to a plane wall (share, slope).

    flux: F(r) / r²; share: beyond the plane; slope: ∫ W along it. points, parts: Gauss' rule on (0, 1).
    """

    flux: Floats
    share: Floats
    slope: Floats
    points: Floats
    parts: Floats


@inner_kernel
def between(table, x):
    """A table over (0, 1), in lines."""
    at = min(max(x, 0.0), 1.0) * TABLE
    i = min(int(at), TABLE - 1)
    return table[i] + (at - i) * (table[i + 1] - table[i])


@inner_kernel
def nearest_on(edges, k, x, y):
    """Of edge k (ax, ay, bx, by) from (x, y): vector to its nearest point."""
    ax, ay = edges[k, 0] - x, edges[k, 1] - y
    dx, dy = edges[k, 2] - edges[k, 0], edges[k, 3] - edges[k, 1]
    part = min(max(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0), 1.0)
    return ax + part * dx, ay + part * dy


@inner_kernel
def beyond_edge(edge, x, y, kind, table):
    """Share of a kernel of support 1 at (x, y) beyond one edge, and ∫ W ds along it; edge: in supports."""
    ax, ay, bx, by = edge
    length = math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
    tx, ty = (bx - ax) / length, (by - ay) / length
    first, last = (ax - x) * tx + (ay - y) * ty, (bx - x) * tx + (by - y) * ty
    off = (ax - x) * ty - (
        ay - y
    ) * tx  # distance to the line; above 0 inside, where the wall is to the right
    half = 1.0 - off * off
    if half <= 0.0:
        return 0.0, 0.0
    half = math.sqrt(half)
    low, high = max(first, -half), min(last, half)
    if low >= high:
        return 0.0, 0.0
    flux, along = 0.0, 0.0
    for side in range(2):
        begin = max(low, 0.0) if side else low
        end = high if side else min(high, 0.0)
        if end > begin:
            for g in range(len(table.points)):
                s = begin + (end - begin) * table.points[g]
                q = math.sqrt(off * off + s * s)
                flux += table.parts[g] * (end - begin) * between(table.flux, q * q)
                along += table.parts[g] * (end - begin) * weight(kind, q)
    turn = 0.0
    if off != 0.0:
        turn = elementary.atan2(off * (high - low), off * off + high * low) / (2.0 * math.pi)
    return turn - off * flux, along


@lean_kernel
def fill_shares(place, edges, settings, table, share, push):
    """Share of the kernel beyond the walls (n,) and its gradient (n, 2) 1/m at places (n, 2) m.

    edges: (k, 4), the inside to the left; settings: (method, kernel, support m).
    """
    method, kind, support = settings
    for i in range(len(place)):
        share[i], push[i, 0], push[i, 1] = 0.0, 0.0, 0.0
        if method in (NONE, PARTICLES):
            continue
        x, y = place[i, 0], place[i, 1]
        best, bx, by = math.inf, 0.0, 0.0
        for k in range(len(edges)):
            dx, dy = nearest_on(edges, k, x, y)
            gap = dx * dx + dy * dy
            if not gap < support * support:
                continue
            if method == WEIGHTS:
                if gap < best:
                    best, bx, by = gap, dx, dy
                continue
            edge = (
                (edges[k, 0] - x) / support, (edges[k, 1] - y) / support,
                (edges[k, 2] - x) / support, (edges[k, 3] - y) / support,
            )  # fmt: skip
            part, along = beyond_edge(edge, 0.0, 0.0, kind, table)
            share[i] += part
            length = math.sqrt(
                (edge[2] - edge[0]) * (edge[2] - edge[0]) + (edge[3] - edge[1]) * (edge[3] - edge[1])
            )
            push[i, 0] += along * (edge[3] - edge[1]) / length / support
            push[i, 1] -= along * (edge[2] - edge[0]) / length / support
        if best < math.inf:
            gap = math.sqrt(best)
            share[i] = between(table.share, gap / support)
            if gap > 0.0:
                pull = between(table.slope, gap / support) / support
                push[i, 0], push[i, 1] = pull * bx / gap, pull * by / gap


@inner_kernel
def is_inside(edges, x, y):
    """Whether a place lies in the vessel, by how often a ray to the right crosses its edges."""
    inside = False
    for k in range(len(edges)):
        if (edges[k, 1] > y) != (edges[k, 3] > y):
            share = (y - edges[k, 1]) / (edges[k, 3] - edges[k, 1])
            if x < edges[k, 0] + share * (edges[k, 2] - edges[k, 0]):
                inside = not inside
    return inside


@lean_kernel
def hold_inside(place, velocity, moving, edges, margin):
    """Bring back what has left the vessel or is nearer than ``margin`` to an edge, and stop it there.

    moving: (n,) 0 for what stays. Returns how many were brought back from outside.
    """
    outside = 0
    for i in range(len(place)):
        if moving[i] == 0.0:
            continue
        for _ in range(2):  # in a corner two walls have their turn
            x, y = place[i, 0], place[i, 1]
            best, at = math.inf, 0
            for k in range(len(edges)):
                dx, dy = nearest_on(edges, k, x, y)
                if dx * dx + dy * dy < best:
                    best, at = dx * dx + dy * dy, k
            within = is_inside(edges, x, y)
            if within and best >= margin * margin:
                break
            outside += not within
            dx, dy = nearest_on(edges, at, x, y)
            length = elementary.hypot(edges[at, 2] - edges[at, 0], edges[at, 3] - edges[at, 1])
            nx, ny = -(edges[at, 3] - edges[at, 1]) / length, (edges[at, 2] - edges[at, 0]) / length
            place[i, 0], place[i, 1] = x + dx + margin * nx, y + dy + margin * ny
            into = velocity[i, 0] * nx + velocity[i, 1] * ny
            if into < 0.0:
                velocity[i, 0] -= into * nx
                velocity[i, 1] -= into * ny
    return outside


class Contacts(NamedTuple):
    """Walls that particles may come to. normal: (n, 2, 2) of the two nearest, inwards.

    room: (n, 2) m that a particle may still go towards each; infinite where there is none.
    """

    normal: Floats
    room: Floats


@lean_kernel
def fill_contacts(place, edges, reach, margin, contacts):
    """Fill the contacts of places (n, 2) m with walls nearer than ``reach``; ``margin``: what is kept off."""
    for i in range(len(place)):
        contacts.room[i, 0], contacts.room[i, 1] = math.inf, math.inf
        for k in range(len(edges)):
            dx, dy = nearest_on(edges, k, place[i, 0], place[i, 1])
            gap = math.sqrt(dx * dx + dy * dy)
            if not 0.0 < gap < reach:
                continue
            room, at = max(gap - margin, 0.0), 1
            if room >= contacts.room[i, 1]:
                continue
            if room < contacts.room[i, 0]:
                contacts.room[i, 1] = contacts.room[i, 0]
                for c in range(2):
                    contacts.normal[i, 1, c] = contacts.normal[i, 0, c]
                at = 0
            contacts.room[i, at] = room
            contacts.normal[i, at, 0], contacts.normal[i, at, 1] = -dx / gap, -dy / gap


@inner_kernel
def stop_at_walls(velocity, contacts, dt):
    """Take from velocities (n, 2) what would lead beyond a wall within dt (s)."""
    for i in range(len(velocity)):
        for c in range(2):
            if contacts.room[i, c] < math.inf:
                x, y = contacts.normal[i, c, 0], contacts.normal[i, c, 1]
                beyond = velocity[i, 0] * x + velocity[i, 1] * y + contacts.room[i, c] / dt
                if beyond < 0.0:
                    velocity[i, 0] -= beyond * x
                    velocity[i, 1] -= beyond * y


@lru_cache(maxsize=8)
def wall_table(kind: int) -> WallTable:
    """Tables of a kernel of support 1."""
    from_gauss, parts = np.polynomial.legendre.leggauss(GAUSS)
    points, parts = 0.5 * (1.0 + from_gauss), 0.5 * parts
    ends = np.sqrt(np.arange(1, TABLE + 1) / TABLE)
    at = ends[:, None] * points
    value = np.zeros(at.size)
    fill_kernel(kind, at.ravel(), value, np.zeros(at.size))
    # in quarters, as some kernels are made of two pieces
    flux = np.zeros(TABLE + 1)
    for i in range(4):
        s = ends[:, None] * (i + points) / 4.0
        fill_kernel(kind, s.ravel(), value, np.zeros(value.size))
        flux[1:] += np.sum(0.25 * parts * ends[:, None] * s * value.reshape(s.shape), axis=1)
    flux[1:] /= np.square(ends)
    flux[0] = flux[1] + (flux[1] - flux[2])
    share, slope = np.zeros(TABLE + 1), np.zeros(TABLE + 1)
    table = WallTable(flux, share, slope, points, parts)
    gaps = np.arange(TABLE + 1) / TABLE
    places = np.stack([np.zeros(TABLE + 1), gaps], axis=1)
    push = np.zeros((TABLE + 1, 2))
    fill_shares(places, np.array([[-2.0, 0.0, 2.0, 0.0]]), (EXACT, kind, 1.0), table, share, push)
    share[0] = 0.5
    slope[:] = -push[:, 1]
    return table


def edges_of(loops: Sequence[ArrayLike]) -> Floats:
    """Edges (k, 4) m of closed loops of corners (m, 2), the inside to the left: the first is the vessel.

    Further loops are what stands in it. ValueError for loops of fewer than 3 corners, or without area.
    """
    found = []
    for number, loop in enumerate(loops):
        corners = np.asarray(loop, dtype=np.float64)
        if corners.ndim != 2 or corners.shape[1] != 2 or not np.isfinite(corners).all():
            raise ValueError("vessel: expected loops of finite corners (m, 2)")
        corners = corners[np.any(corners != np.roll(corners, 1, axis=0), axis=1)]
        after = np.roll(corners, -1, axis=0)
        area = 0.5 * float(np.sum(corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]))
        if len(corners) < 3 or area == 0.0:
            raise ValueError(f"vessel: loop {number} needs 3 corners and an area")
        if (area > 0.0) != (number == 0):
            corners, after = after[::-1], corners[::-1]
        found.append(np.concatenate([corners, after], axis=1))
    edges = np.concatenate(found) if found else np.zeros((0, 4))
    if len(edges) > MOST_EDGES:
        raise ValueError(f"vessel: {len(edges)} edges, expected at most {MOST_EDGES}")
    return np.ascontiguousarray(edges)


def wall_places(edges: Floats, spacing: float) -> Floats:
    """Places (m, 2) of wall particles about ``spacing`` apart along edges."""
    found = []
    for ax, ay, bx, by in edges.tolist():
        count = max(1, round(math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay)) / spacing))
        share = np.arange(count) / count
        found.append(np.stack([ax + share * (bx - ax), ay + share * (by - ay)], axis=1))
    return np.concatenate(found) if found else np.zeros((0, 2))


@lean_kernel
def _is_inside(edges, x, y):
    """`is_inside`, for callers in Python."""
    return is_inside(edges, x, y)


def is_held(edges: Floats, place: ArrayLike) -> bool:
    """Whether a place (2,) lies in the vessel; without edges, everywhere."""
    x, y = np.asarray(place, dtype=np.float64)
    return not len(edges) or bool(_is_inside(edges, float(x), float(y)))
