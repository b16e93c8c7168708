"""What a ball in the air will do next of its own: land, meet a nose, fall into a pocket, leave the table.

All are first roots: of a quadratic for slate, rail tops, walls, pockets and the table's edge. They are roots
of a quartic (`detection.first_contact_time`, in the plane across it) for the edge of a nose. The rim of a
jaw, a circle, has an equation of eighth degree: its contact is approached by steps of distance over largest
speed, which cannot jump over it (conservative advancement; Mirtich 1996, Impulse-based dynamic simulation,
ch. 2), up to RIM_TOUCH.

A pocket takes a ball that comes down through the level of the slate over its hole. So it does one that would
leave the hole's circle towards the rails lower than their top.
"""

from __future__ import annotations

import math

from game.billiards.exact.detection import first_contact_time, first_crossing
from game.billiards.exact.elements import LONGEST_SEARCH
from game.billiards.flight.air import falls_to, height_after
from game.billiards.flight.region import faces_cushion, is_over_bed, pocket_below
from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel
from game.billiards.table.table import RAIL_WIDTH

RIM_TOUCH = 1e-12  # m; so near is contact
RIM_STEPS = 500


@inner_kernel
def _landing(state, i, elements, physics):
    """When ball i comes down, and on what, if nothing is in its way: (time, event, element)."""
    height = physics[s.CUSHION_HEIGHT]
    top = falls_to(state[s.Z, i], state[s.VZ, i], height, physics[s.GRAVITY])
    if 0.0 < top < s.NEVER:
        x = state[s.X, i] + top * state[s.VX, i]
        y = state[s.Y, i] + top * state[s.VY, i]
        if not is_over_bed(x, y, elements, physics) and pocket_below(x, y, elements.pockets) < 0:
            return top, s.BALL_RAIL_TOP, -1
    t = falls_to(state[s.Z, i], state[s.VZ, i], 0.0, physics[s.GRAVITY])
    if t >= s.NEVER:
        t = 0.0
    x = state[s.X, i] + t * state[s.VX, i]
    y = state[s.Y, i] + t * state[s.VY, i]
    pocket = pocket_below(x, y, elements.pockets)
    if pocket >= 0:
        return t, s.BALL_POCKET, pocket
    return t, s.BALL_SLATE if is_over_bed(x, y, elements, physics) else s.BALL_OFF, -1


@inner_kernel
def _nose_time(state, i, k, horizon, cushions, physics):
    """When ball i, in the air, meets wall or nose of cushion k; NEVER if not within `horizon` s."""
    radius = state[s.RADIUS, i]
    nx = cushions[k, s.NORMAL_X]
    ny = cushions[k, s.NORMAL_Y]
    gap = (state[s.X, i] - cushions[k, s.FROM_X]) * nx + (state[s.Y, i] - cushions[k, s.FROM_Y]) * ny
    speed = state[s.VX, i] * nx + state[s.VY, i] * ny
    above = state[s.Z, i] + radius - physics[s.CUSHION_HEIGHT]
    t = first_crossing(gap - radius, speed, 0.0, horizon)
    low = t < s.AT_REST and height_after(state, i, t, physics) + radius < physics[s.CUSHION_HEIGHT]
    if low and faces_cushion(
        state[s.X, i] + t * state[s.VX, i], state[s.Y, i] + t * state[s.VY, i], cushions, k
    ):
        return t
    t = first_contact_time(gap, above, speed, state[s.VZ, i], 0.0, -0.5 * physics[s.GRAVITY], radius, horizon)
    if t >= s.AT_REST or gap + t * speed < 0.0:
        return s.NEVER
    if height_after(state, i, t, physics) + radius < physics[s.CUSHION_HEIGHT]:
        return s.NEVER
    if faces_cushion(state[s.X, i] + t * state[s.VX, i], state[s.Y, i] + t * state[s.VY, i], cushions, k):
        return t
    return s.NEVER


@inner_kernel
def _rim_time(state, i, k, horizon, jaws, physics):
    """When ball i, in the air, meets wall or rim of jaw k; NEVER if not within `horizon` s."""
    radius = state[s.RADIUS, i]
    x = state[s.X, i] - jaws[k, 0]
    y = state[s.Y, i] - jaws[k, 1]
    vx = state[s.VX, i]
    vy = state[s.VY, i]
    reach = jaws[k, 2] + radius
    t = 0.0
    if x * x + y * y > reach * reach:
        t = first_contact_time(x, y, vx, vy, 0.0, 0.0, reach, horizon)
        if t >= s.AT_REST:
            return s.NEVER
    bound = math.sqrt(vx * vx + vy * vy)
    bound += max(abs(state[s.VZ, i]), abs(state[s.VZ, i] - physics[s.GRAVITY] * horizon))
    for _ in range(RIM_STEPS):
        px = x + t * vx
        py = y + t * vy
        far = math.sqrt(px * px + py * py)
        across = far - jaws[k, 2]
        above = height_after(state, i, t, physics) + radius - physics[s.CUSHION_HEIGHT]
        if across <= 0.0:
            return s.NEVER  # over the top
        up = max(above, 0.0)
        distance = math.sqrt(across * across + up * up)
        closing = -(across * (px * vx + py * vy) / far + up * (state[s.VZ, i] - physics[s.GRAVITY] * t))
        gap = distance - radius
        if gap <= RIM_TOUCH and closing > 0.0:
            return t
        t += max(gap, RIM_TOUCH if closing > 0.0 else 1e-7) / bound
        if not t <= horizon:
            return s.NEVER
    return t


@inner_kernel
def _hole_time(state, i, k, horizon, elements, physics):
    """When ball i, low over pocket k, is stopped by the back of the hole; NEVER if not within `horizon` s."""
    pocket = elements.pockets[k]
    x = state[s.X, i] - pocket[0]
    y = state[s.Y, i] - pocket[1]
    vx = state[s.VX, i]
    vy = state[s.VY, i]
    speed_square = vx * vx + vy * vy
    along = x * vx + y * vy
    square = along * along - speed_square * (x * x + y * y - pocket[2] * pocket[2])
    if speed_square == 0.0 or square <= 0.0:
        return s.NEVER
    t = (math.sqrt(square) - along) / speed_square
    if not 0.0 <= t <= horizon or height_after(state, i, t, physics) >= physics[s.CUSHION_HEIGHT]:
        return s.NEVER
    px = state[s.X, i] + t * vx
    py = state[s.Y, i] + t * vy
    return s.NEVER if is_over_bed(px, py, elements, physics) else t


@inner_kernel
def _edge_time(state, i, horizon, physics):
    """When the centre of ball i is beyond the rails; NEVER if not within `horizon` s."""
    vx = state[s.VX, i]
    vy = state[s.VY, i]
    t = first_crossing(physics[s.FREE_RIGHT] + RAIL_WIDTH - state[s.X, i], -vx, 0.0, horizon)
    t = min(t, first_crossing(state[s.X, i] - physics[s.FREE_LEFT] + RAIL_WIDTH, vx, 0.0, horizon))
    t = min(t, first_crossing(physics[s.FREE_UPPER] + RAIL_WIDTH - state[s.Y, i], -vy, 0.0, horizon))
    return min(t, first_crossing(state[s.Y, i] - physics[s.FREE_LOWER] + RAIL_WIDTH, vy, 0.0, horizon))


@inner_kernel
def plan_flight(state, modes, i, elements, physics):
    """Set what ball i, in the air, will do next of its own: OWN_TIME (s), OWN_EVENT, OWN_ELEMENT."""
    best, event, element = _landing(state, i, elements, physics)
    best = min(best, LONGEST_SEARCH)
    for k in range(elements.cushions.shape[0]):
        t = _nose_time(state, i, k, best, elements.cushions, physics)
        if t < best:
            best = t
            event = s.BALL_CUSHION
            element = k
    for k in range(elements.jaws.shape[0]):
        t = _rim_time(state, i, k, best, elements.jaws, physics)
        if t < best:
            best = t
            event = s.BALL_JAW
            element = k
    for k in range(elements.pockets.shape[0]):
        t = _hole_time(state, i, k, best, elements, physics)
        if t < best:
            best = t
            event = s.BALL_POCKET
            element = k
    t = _edge_time(state, i, best, physics)
    if t < best:
        best = t
        event = s.BALL_OFF
        element = -1
    state[s.OWN_TIME, i] = state[s.TIME, i] + best
    modes[s.OWN_EVENT, i] = event
    modes[s.OWN_ELEMENT, i] = element
