"""When two things on parabolic paths first come into contact.

The gap of two balls is a quartic f in time whose fourth derivative is not negative. So f lies above its own
cubic, and on [0, D] above the parabola f0 + f1 d + (f2 + min(0, f3) D/3) d^2/2, where f1 to f3 are its
derivatives here. Its first root is found by steps to the roots of such parabolas: no step can jump over a
root, and near one they converge cubically. A gap that starts at nothing is never searched at once for a
root: only approach counts there, so a fresh contact cannot be found again.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel

MAX_STEPS = 200
LAST_PLACE = 2.0**-52
BEHIND = 1e-9  # m; a ball further behind a line than rounding can bring it is in no contact with it


@inner_kernel(inline="always")
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


@inner_kernel(inline="always")
def _step_in_contact(slope, curvature, threshold):
    """Step from contact to where the next collision might be at the earliest; -1 if there is none."""
    if curvature >= 0.0:
        return -1.0
    if slope > threshold:
        return 2.0 * slope / (-curvature)
    return max((slope + threshold) / (-curvature), 1e-12)


@inner_kernel(forceinline=True)
def first_closing(c0, c1, c2, c3, c4, threshold, missed, horizon):
    """First root within `horizon`, s, of c0 + c1 t + ... + c4 t^4 with a slope of at most -threshold.

    c4 must not be negative. `missed` if there is none.
    """
    t = 0.0
    for _ in range(MAX_STEPS):
        gap = c0 + t * (c1 + t * (c2 + t * (c3 + t * c4)))
        slope = c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * 4.0 * c4))
        if gap > 0.0:
            end = horizon
            if slope < 0.0:
                end = min(
                    horizon, t - 2.0 * gap / slope
                )  # a root on a parabola of positive curvature is nearer
            bend = 2.0 * c2 + t * (6.0 * c3 + 12.0 * c4 * t)
            third = (2.0 * c3 + 8.0 * c4 * t) * (end - t)
            curvature = bend + min(0.0, third)
            step = _step_apart(gap, slope, curvature)
            if step < 0.0 or t + step > end:
                if end >= horizon:
                    return missed
                t = end
                continue
            t += step
            slope += curvature * step
            # by how much f is above the parabola there: is that less than a last place of t?
            if step * step * (0.5 * abs(third) + c4 * step * step) > -slope * LAST_PLACE * t:
                continue
        if slope <= -threshold:
            return t if t <= horizon else missed
        bend = 2.0 * c2 + t * (6.0 * c3 + 12.0 * c4 * t)
        curvature = bend + min(0.0, 3.0 * c3 + 12.0 * c4 * t) * (horizon - t)
        step = _step_in_contact(slope, curvature, threshold)
        if step < 0.0 or not (t + step <= horizon):
            return missed
        t += step
    return missed


@inner_kernel
def first_contact_time(x, y, vx, vy, ax, ay, reach, horizon):
    """Time until two points on parabolic paths come within `reach` of each other while approaching, s.

    x + vx t + ax t^2 (and y): position of one seen from the other, m. At most `horizon` s ahead. NEVER if
    they do not; AT_REST if they do not, but are in contact now and do not separate.
    """
    distance = math.sqrt(x * x + y * y)
    c0 = (distance - reach) * (distance + reach)  # keeps all digits of a tiny gap
    c1 = 2.0 * (x * vx + y * vy)
    c2 = vx * vx + vy * vy + 2.0 * (x * ax + y * ay)
    c3 = 2.0 * (vx * ax + vy * ay)
    c4 = ax * ax + ay * ay
    threshold = 2.0 * reach * s.CLOSING_SPEED
    missed = s.AT_REST if distance - reach <= s.CONTACT_GAP and c1 <= threshold else s.NEVER
    return first_closing(c0, c1, c2, c3, c4, threshold, missed, horizon)


@inner_kernel
def first_crossing(gap, speed, half_acceleration, horizon):
    """Time until gap + speed t + half_acceleration t^2 falls to 0, s; NEVER if not within `horizon`.

    A path that starts further behind than BEHIND may come forward, and fall back later.
    """
    if gap < -BEHIND:
        discriminant = speed * speed - 4.0 * half_acceleration * gap
        if speed <= 0.0 or half_acceleration >= 0.0 or discriminant <= 0.0:
            return s.NEVER
        t = (speed + math.sqrt(discriminant)) / (-2.0 * half_acceleration)
        return t if t <= horizon else s.NEVER
    if gap <= 0.0:
        if speed <= -s.CLOSING_SPEED:
            return 0.0
        if half_acceleration >= 0.0:
            return s.NEVER
        if speed > s.CLOSING_SPEED:
            t = speed / (-half_acceleration)
        else:
            t = (speed + s.CLOSING_SPEED) / (-2.0 * half_acceleration)
        return t if t <= horizon else s.NEVER
    t = _step_apart(gap, speed, 2.0 * half_acceleration)
    if t < 0.0 or not (t <= horizon) or speed + 2.0 * half_acceleration * t > -s.CLOSING_SPEED:
        return s.NEVER
    return t
