"""The capsule of least area, found everywhere at once: branch and bound, with a proof of how good it is.

Unlike the least box it need not lie along a side of the hull, nor have the least radius: a rectangle's has
corners on its round ends. With a core along θ and a radius r the shortest core has the length L(θ, r), the
least of a convex function of where the core lies. If a capsule along θ' with r' fits, then so does one along
θ with the same core, turned, and r' + L sin(δ / 2), δ = |θ - θ'|. So in a cell |θ' - θ| <= δ, r1 <= r' <= r2

    area >= 2 r1 L(θ, r2 + D sin(δ / 2)) + π r1²,        D the diameter of the points

and cells that cannot beat the best capsule so far by more than the tolerance are dropped.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.physics.bounds.boxes import extents_along
from game.physics.bounds.building import CAPSULE, GOLDEN, REFINED
from game.physics.bounds.capsules import area_of_capsule, write_core
from game.physics.bounds.door import Array, as_points
from game.physics.bounds.fits import Capsule, capsule_of, fit_row, thinnest_capsule
from game.physics.bounds.hull import hull_of
from game.physics.jit import kernel

ROUNDS = 40  # of golden section, for where the core lies: 4e-9 of the room
CELLS = 1 << 16  # most cells that wait at once
POLISHING = 4  # rounds of nested golden section, each about the best of the last


@kernel
def span_at(hull, h, c, s, middle, radius):
    """Length of the core at height ``middle``, m; below 0 where one centre would do with room to spare."""
    low, high = math.inf, -math.inf
    for i in range(h):
        v = c * hull[i, 1] - s * hull[i, 0] - middle
        q = math.sqrt(max((radius - v) * (radius + v), 0.0))
        u = c * hull[i, 0] + s * hull[i, 1]
        low = min(low, u + q)
        high = max(high, u - q)
    return high - low


@kernel
def shortest_core(hull, h, c, s, radius):
    """Length of the shortest core along (c, s) for a radius, and its height; inf if the hull is broader."""
    _, _, v0, v1 = extents_along(hull, h, c, s)
    low, high = v1 - radius, v0 + radius
    if low > high:
        return math.inf, 0.5 * (v0 + v1)
    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_left = at_right = 0.0
    known = 0  # 1: the right one is known, 2: the left one
    for _ in range(ROUNDS):
        if known != 2:
            at_left = span_at(hull, h, c, s, left, radius)
        if known != 1:
            at_right = span_at(hull, h, c, s, right, radius)
        if at_left <= at_right:
            high, right, at_right, known = right, left, at_left, 1
            left = high - GOLDEN * (high - low)
        else:
            low, left, at_left, known = left, right, at_right, 2
            right = low + GOLDEN * (high - low)
    return max(min(at_left, at_right), 0.0), 0.5 * (low + high)


@kernel
def prove_least(hull, h, least_radius, diameter, tolerance, cells, best):
    """Branch and bound over direction and radius; returns the lower bound of the area, m².

    cells (k, 4): room for cells (angle, half width, radius from, radius to). best (3,): area, angle and
    radius of the best capsule so far; improved. The bound is 0 if the room was too small.
    """
    top = 0
    most = math.sqrt(best[0] / math.pi)
    for i in range(32):
        cells[top, 0], cells[top, 1] = (i + 0.5) * math.pi / 32.0, 0.5 * math.pi / 32.0
        cells[top, 2], cells[top, 3] = least_radius, most
        top += 1
    bound = best[0]
    while top > 0:
        top -= 1
        angle, half, near, far = cells[top, 0], cells[top, 1], cells[top, 2], cells[top, 3]
        c, s = math.cos(angle), math.sin(angle)
        length, _ = shortest_core(hull, h, c, s, far + diameter * math.sin(0.5 * half))
        least = area_of_capsule(length, near)
        if least >= best[0] * (1.0 - tolerance):
            bound = min(bound, least)
            continue
        length, _ = shortest_core(hull, h, c, s, far)
        area = area_of_capsule(length, far)
        if area < best[0]:
            best[0], best[1], best[2] = area, angle, far
        if top + 2 > len(cells):
            return 0.0
        by_angle = diameter * half > far - near
        for side in range(2):
            cells[top, 0], cells[top, 1], cells[top, 2], cells[top, 3] = angle, half, near, far
            if by_angle:
                cells[top, 0], cells[top, 1] = angle + (side - 0.5) * half, 0.5 * half
            else:
                cells[top, 2 + (1 - side)] = 0.5 * (near + far)
            top += 1
    return min(bound, best[0])


@kernel
def best_radius(hull, h, angle, near, far, best):
    """Least area on one angle for radii from ``near`` to ``far``, m²; ``best`` is improved."""
    c, s = math.cos(angle), math.sin(angle)
    _, _, v0, v1 = extents_along(hull, h, c, s)
    near = max(near, 0.5 * (v1 - v0))
    far = max(far, near)
    least = at_left = math.inf
    for k in range(ROUNDS):
        radius = far - GOLDEN * (far - near) if k % 2 == 0 else near + GOLDEN * (far - near)
        if k == 0:
            radius = near
        length, _ = shortest_core(hull, h, c, s, radius)
        area = area_of_capsule(length, radius)
        if area < best[0]:
            best[0], best[1], best[2] = area, angle, radius
        least = min(least, area)
        if k % 2 == 0:
            at_left = area
        elif k > 1 and at_left <= area:
            far = near + GOLDEN * (far - near)
        elif k > 1:
            near = far - GOLDEN * (far - near)
    return least


@kernel
def polish(hull, h, angle_room, radius_room, least_radius, best):
    """Improve ``best`` (area, angle, radius) by golden section over angles, and over radii for each."""
    near, far = max(best[2] - radius_room, least_radius), best[2] + radius_room
    low, high = best[1] - angle_room, best[1] + angle_room
    at_left = at_right = -1.0
    for _ in range(ROUNDS):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        for side in range(2):
            if (at_left if side == 0 else at_right) >= 0.0:
                continue
            area = best_radius(hull, h, left if side == 0 else right, near, far, best)
            if side == 0:
                at_left = area
            else:
                at_right = area
        if at_left <= at_right:
            high, at_right, at_left = right, at_left, -1.0
        else:
            low, at_left, at_right = left, at_right, -1.0


def diameter_bound(hull: Array) -> float:
    """The greatest distance of two corners (h, 2), m, or a little more where there are very many."""
    if len(hull) > 400:
        width, height = np.ptp(hull, axis=0).tolist()
        return math.sqrt(width * width + height * height)
    way = hull[:, None, :] - hull[None, :, :]
    return math.sqrt(float((way * way).sum(axis=2).max()))


def least_capsule(points: ArrayLike, tolerance: float = 1e-3) -> tuple[Capsule, float]:
    """The capsule of least area round points (n, 2) m, and a proven lower bound of that area, m².

    The bound is within ``tolerance`` of the area; the capsule itself, polished, is much nearer to the least.
    ValueError for what are no points, or a tolerance not between 1e-6 and 0.5.
    """
    given = as_points(points)
    if not 1e-6 <= tolerance <= 0.5:
        raise ValueError(f"tolerance: 1e-6 to 0.5 is wanted, not {tolerance!r}")
    hull, origin = hull_of(given)
    h = len(hull)
    start = capsule_of(fit_row(given, CAPSULE, REFINED, 1.0))
    thin = thinnest_capsule(given)
    if h <= 2 or thin.radius <= 0.0:
        return thin, thin.area
    diameter = diameter_bound(hull)
    best = np.zeros(3)
    for capsule in (start, thin):
        if best[0] == 0.0 or capsule.area < best[0]:
            dx, dy = capsule.end[0] - capsule.start[0], capsule.end[1] - capsule.start[1]
            best[:] = capsule.area, math.atan2(dy, dx), capsule.radius
    room = math.radians(1.0), 0.1 * best[2]
    polish(hull, h, *room, thin.radius, best)
    bound = float(prove_least(hull, h, thin.radius, diameter, tolerance, np.empty((CELLS, 4)), best))
    for i in range(POLISHING):
        polish(hull, h, room[0] * 0.1**i, room[1] * 0.1**i, thin.radius, best)
    angle, radius = best[1:].tolist()
    c, s = math.cos(angle), math.sin(angle)
    _, middle = shortest_core(hull, h, c, s, radius)
    volumes = np.zeros((1, 6))
    along = hull @ (c, s)
    q = np.sqrt(np.maximum(radius**2 - (hull @ (-s, c) - middle) ** 2, 0.0))
    low, high = float((along + q).min()), float((along - q).max())
    if low > high:
        low = high = 0.5 * (low + high)
    write_core(hull, h, c, s, middle, low, high, *origin.tolist(), volumes, 0)
    found = min((capsule_of(volumes[0]), start, thin), key=lambda capsule: capsule.area)
    return found, min(bound, found.area)


def minimal_capsule(points: ArrayLike) -> Capsule:
    """The capsule of least area round points (n, 2) m; see `least_capsule` for how that is proven."""
    return least_capsule(points)[0]
