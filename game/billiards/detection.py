"""When two things on parabolic ways first touch.

The gap of two balls is a quartic in time. Its first root is found by steps along a parabola that lies under
it, f + f' d + m d^2/2 with m the least f'' over the rest of the horizon: no step can jump over a root, and
near one the steps become Newton's. A gap that starts at nothing is never searched at once for a root: only
approach counts there, so a fresh contact cannot be found again.
"""

from __future__ import annotations

import math

from game.billiards.state import AT_REST, CLOSING_SPEED, CONTACT_GAP, NEVER
from game.physics.jit import kernel

MAX_STEPS = 200
LAST_PLACE = 2.0**-52
BEHIND = 1e-9  # m; a ball further behind a line than rounding can bring it does not touch it


@kernel(inline="always")
def least_curvature(quadratic, cubic, quartic, start, end):
    """Least value over [start, end] of f'' = 2 c2 + 6 c3 t + 12 c4 t^2, with c4 >= 0."""
    lowest = start
    if -cubic > 4.0 * quartic * start:
        lowest = end
        if -cubic < 4.0 * quartic * end:
            lowest = -cubic / (4.0 * quartic)
    return 2.0 * quadratic + lowest * (6.0 * cubic + 12.0 * quartic * lowest)


@kernel(inline="always")
def _step_apart(gap, slope, curvature):
    """Step to the first root ahead of gap + slope d + curvature d^2/2, with gap > 0; -1 if there is none."""
    discriminant = slope * slope - 2.0 * curvature * gap
    if discriminant < 0.0:
        return -1.0
    root = math.sqrt(discriminant)
    if slope < 0.0:
        return 2.0 * gap / (root - slope)
    if curvature < 0.0:
        return (root + slope) / (-curvature)
    return -1.0


@kernel(inline="always")
def _step_in_contact(slope, curvature, threshold):
    """Step from contact to where the next collision might be at the earliest; -1 if there is none."""
    if curvature >= 0.0:
        return -1.0
    if slope > threshold:
        return 2.0 * slope / (-curvature)
    return max((slope + threshold) / (-curvature), 1e-12)


@kernel
def first_touch(x, y, vx, vy, ax, ay, reach, horizon):
    """Time until two points on parabolic ways come within `reach` of each other while approaching, s.

    x + vx t + ax t^2 (and y): position of one seen from the other, m. At most `horizon` s ahead. NEVER if
    they do not; AT_REST if they do not, but touch now.
    """
    distance = math.sqrt(x * x + y * y)
    c0 = (distance - reach) * (distance + reach)  # keeps all digits of a tiny gap
    c1 = 2.0 * (x * vx + y * vy)
    c2 = vx * vx + vy * vy + 2.0 * (x * ax + y * ay)
    c3 = 2.0 * (vx * ax + vy * ay)
    c4 = ax * ax + ay * ay
    threshold = 2.0 * reach * CLOSING_SPEED
    missed = AT_REST if distance - reach <= CONTACT_GAP else NEVER
    t = 0.0
    for _ in range(MAX_STEPS):
        gap = c0 + t * (c1 + t * (c2 + t * (c3 + t * c4)))
        slope = c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * 4.0 * c4))
        curvature = least_curvature(c2, c3, c4, t, horizon)
        step = 0.0
        if gap > 0.0:
            step = _step_apart(gap, slope, curvature)
            if step < 0.0:
                return missed
        if step <= LAST_PLACE * t:  # in contact
            if slope <= -threshold:
                return t
            step = _step_in_contact(slope, curvature, threshold)
            if step < 0.0:
                return missed
        t += step
        if not (t <= horizon):
            return missed
    return t if slope <= -threshold else missed


@kernel
def first_crossing(gap, speed, half_acceleration, horizon):
    """Time until gap + speed t + half_acceleration t^2 falls to 0, s; NEVER if not within `horizon`."""
    if gap <= 0.0:
        if gap < -BEHIND:
            return NEVER
        if speed <= -CLOSING_SPEED:
            return 0.0
        if half_acceleration >= 0.0:
            return NEVER
        if speed > CLOSING_SPEED:
            t = speed / (-half_acceleration)
        else:
            t = (speed + CLOSING_SPEED) / (-2.0 * half_acceleration)
        return t if t <= horizon else NEVER
    t = _step_apart(gap, speed, 2.0 * half_acceleration)
    if t < 0.0 or not (t <= horizon) or speed + 2.0 * half_acceleration * t > -CLOSING_SPEED:
        return NEVER
    return t
