"""What of a polygon is below a level: area, moments, waterline (Archimedes; Green 1828).

The part below is cut off by the level. Heights count from the level, so that the cut itself adds nothing to
the sums along the edges, and concave outlines need no care.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.kernels import elementary

TURNS = 80  # of the search for a level, at most
NEAR = 1e-14  # of the extent: where the search ends


@kernel
def cut(corners, c, s, depth):
    """Of corners (n, 2) m about the centre of mass, turned by cosine c and sine s, below a level so high
    above that centre (m).

    Found: area m²; its moments along x (from the centre) and in height (from the level), m³. The waterline's
    width m, its first and second moment, m², m³. Left and right end of what is wet, m. Lowest and highest
    corner from the level, m.
    """
    area, moment_x, moment_h = 0.0, 0.0, 0.0
    width, first, second = 0.0, 0.0, 0.0
    left, right, low, top = math.inf, -math.inf, math.inf, -math.inf
    count = corners.shape[0]
    for i in range(count):
        j = i + 1 if i + 1 < count else 0
        px = c * corners[i, 0] - s * corners[i, 1]
        ph = s * corners[i, 0] + c * corners[i, 1] - depth
        qx = c * corners[j, 0] - s * corners[j, 1]
        qh = s * corners[j, 0] + c * corners[j, 1] - depth
        low, top = min(low, ph), max(top, ph)
        if ph >= 0.0 and qh >= 0.0:
            continue
        if (ph < 0.0) != (qh < 0.0):
            x = px + ph / (ph - qh) * (qx - px)
            side = 1.0 if ph < 0.0 else -1.0  # anticlockwise: an edge that goes up is a right end
            width += side * x
            first += side * 0.5 * x * x
            second += side * x * x * x / 3.0
            if ph < 0.0:
                qx, qh = x, 0.0
            else:
                px, ph = x, 0.0
        left, right = min(left, px, qx), max(right, px, qx)
        cross = px * qh - qx * ph
        area += 0.5 * cross
        moment_x += cross * (px + qx) / 6.0
        moment_h += cross * (ph + qh) / 6.0
    return area, moment_x, moment_h, width, first, second, left, right, low, top


@kernel
def ends(corners, c, s):
    """Lowest and highest place of all corners from the centre of mass, then left and right end, m."""
    low, top, left, right = math.inf, -math.inf, math.inf, -math.inf
    for i in range(corners.shape[0]):
        x = c * corners[i, 0] - s * corners[i, 1]
        y = s * corners[i, 0] + c * corners[i, 1]
        low, top, left, right = min(low, y), max(top, y), min(left, x), max(right, x)
    return low, top, left, right


@kernel
def level_over(corners, c, s, place, tank, water):
    """Height (m) of the level in a tank ``tank`` m wide with ``water`` m² in it, for a body whose centre is
    at ``place`` m over the floor. Newton's method, kept between bounds.
    """
    low, high = water / tank, (water + outline_area(corners)) / tank
    level = low
    for _ in range(TURNS):
        found = cut(corners, c, s, level - place)
        excess = level * tank - water - found[0]
        if excess > 0.0:
            high = level
        else:
            low = level
        slope = tank - found[3]
        step = excess / slope if slope > 0.0 else math.inf
        guess = level - step
        if not low <= guess <= high:
            guess = 0.5 * (low + high)
        if abs(guess - level) <= NEAR * (abs(level) + high):
            return guess
        level = guess
    return level


@kernel
def outline_area(corners):
    """m², of an anticlockwise polygon."""
    area, count = 0.0, corners.shape[0]
    for i in range(count):
        j = i + 1 if i + 1 < count else 0
        area += 0.5 * (corners[i, 0] * corners[j, 1] - corners[j, 0] * corners[i, 1])
    return area


@kernel
def depth_for(corners, c, s, displaced):
    """Height (m) of the level over the centre of mass at which so much (m²) is below it; beyond the top if
    all of it is less.
    """
    low, high, _, _ = ends(corners, c, s)
    extent, depth = high - low, 0.5 * (low + high)
    for _ in range(TURNS):
        found = cut(corners, c, s, depth)
        lack = displaced - found[0]
        if lack > 0.0:
            low = depth
        else:
            high = depth
        guess = depth + lack / found[3] if found[3] > 0.0 else math.inf
        if not low < guess < high:
            guess = 0.5 * (low + high)
        if abs(guess - depth) <= NEAR * extent:
            return guess
        depth = guess
    return depth


@kernel
def arm_at(corners, displaced, angle):
    """Righting arm (m) of a free body: above 0 it turns clockwise, towards smaller angles."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    depth = depth_for(corners, c, s, displaced)
    found = cut(corners, c, s, depth)
    return -found[1] / found[0] if found[0] > 0.0 else 0.0


@kernel
def measure_arms(corners, displaced, angles, arms):
    """Righting arms (n,) m at angles (n,) rad."""
    for k in range(angles.shape[0]):
        arms[k] = arm_at(corners, displaced, angles[k])


@kernel
def arm_root(corners, displaced, low, high):
    """The angle (rad) between two of which the righting arm changes its sign, by halving."""
    rising = arm_at(corners, displaced, low) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if (arm_at(corners, displaced, middle) < 0.0) == rising:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
