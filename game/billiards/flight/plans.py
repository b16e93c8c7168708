"""What a ball in the air will do next of its own: land, meet a nose, fall into a pocket, leave the table.

All are first roots: of a quadratic for slate, rail tops, walls, pockets and the table's edge; of a quartic
(`detection.first_contact_time`, in the plane across it) for the edge of a nose. The rim of a jaw, a circle,
has an equation of eighth degree: its contact is approached by steps of distance over largest speed, which
cannot jump over it (conservative advancement; Mirtich 1996, Impulse-based dynamic simulation, ch. 2), up to
RIM_TOUCH.

A pocket takes a ball that comes down through the level of the slate over its hole, or that would leave the
hole's circle towards the rails lower than their top.
"""

from __future__ import annotations

import math

from game.billiards.exact.detection import first_contact_time, first_crossing
from game.billiards.exact.elements import LONGEST_SEARCH
from game.billiards.flight.air import falls_to, height_after
from game.billiards.flight.region import faces_cushion, is_over_bed, pocket_below
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    AT_REST,
    BALL_CUSHION,
    BALL_JAW,
    BALL_OFF,
    BALL_POCKET,
    BALL_RAIL_TOP,
    BALL_SLATE,
    CUSHION_HEIGHT,
    FREE_LEFT,
    FREE_LOWER,
    FREE_RIGHT,
    FREE_UPPER,
    FROM_X,
    FROM_Y,
    GRAVITY,
    NEVER,
    NORMAL_X,
    NORMAL_Y,
    OWN_ELEMENT,
    OWN_EVENT,
    OWN_TIME,
    RADIUS,
    TIME,
    VX,
    VY,
    VZ,
    X,
    Y,
    Z,
)
from game.billiards.table.table import RAIL_WIDTH

RIM_TOUCH = 1e-12  # m; so near is contact
RIM_STEPS = 500


@inner_kernel
def _landing(state, i, elements, physics):
    """When ball i comes down, and on what, if nothing is in its way: (time, event, element)."""
    height = physics[CUSHION_HEIGHT]
    top = falls_to(state[Z, i], state[VZ, i], height, physics[GRAVITY])
    if 0.0 < top < NEVER:
        x = state[X, i] + top * state[VX, i]
        y = state[Y, i] + top * state[VY, i]
        if not is_over_bed(x, y, elements, physics) and pocket_below(x, y, elements.pockets) < 0:
            return top, BALL_RAIL_TOP, -1
    t = falls_to(state[Z, i], state[VZ, i], 0.0, physics[GRAVITY])
    if t >= NEVER:
        t = 0.0
    x = state[X, i] + t * state[VX, i]
    y = state[Y, i] + t * state[VY, i]
    pocket = pocket_below(x, y, elements.pockets)
    if pocket >= 0:
        return t, BALL_POCKET, pocket
    return t, BALL_SLATE if is_over_bed(x, y, elements, physics) else BALL_OFF, -1


@inner_kernel
def _nose_time(state, i, k, horizon, cushions, physics):
    """When ball i, in the air, meets wall or nose of cushion k; NEVER if not within `horizon` s."""
    radius = state[RADIUS, i]
    nx = cushions[k, NORMAL_X]
    ny = cushions[k, NORMAL_Y]
    gap = (state[X, i] - cushions[k, FROM_X]) * nx + (state[Y, i] - cushions[k, FROM_Y]) * ny
    speed = state[VX, i] * nx + state[VY, i] * ny
    above = state[Z, i] + radius - physics[CUSHION_HEIGHT]
    t = first_crossing(gap - radius, speed, 0.0, horizon)
    low = t < AT_REST and height_after(state, i, t, physics) + radius < physics[CUSHION_HEIGHT]
    if low and faces_cushion(state[X, i] + t * state[VX, i], state[Y, i] + t * state[VY, i], cushions, k):
        return t
    t = first_contact_time(gap, above, speed, state[VZ, i], 0.0, -0.5 * physics[GRAVITY], radius, horizon)
    if t >= AT_REST or gap + t * speed < 0.0:
        return NEVER
    if height_after(state, i, t, physics) + radius < physics[CUSHION_HEIGHT]:
        return NEVER
    if faces_cushion(state[X, i] + t * state[VX, i], state[Y, i] + t * state[VY, i], cushions, k):
        return t
    return NEVER


@inner_kernel
def _rim_time(state, i, k, horizon, jaws, physics):
    """When ball i, in the air, meets wall or rim of jaw k; NEVER if not within `horizon` s."""
    radius = state[RADIUS, i]
    x = state[X, i] - jaws[k, 0]
    y = state[Y, i] - jaws[k, 1]
    vx = state[VX, i]
    vy = state[VY, i]
    reach = jaws[k, 2] + radius
    t = 0.0
    if x * x + y * y > reach * reach:
        t = first_contact_time(x, y, vx, vy, 0.0, 0.0, reach, horizon)
        if t >= AT_REST:
            return NEVER
    bound = math.sqrt(vx * vx + vy * vy)
    bound += max(abs(state[VZ, i]), abs(state[VZ, i] - physics[GRAVITY] * horizon))
    for _ in range(RIM_STEPS):
        px = x + t * vx
        py = y + t * vy
        far = math.sqrt(px * px + py * py)
        across = far - jaws[k, 2]
        above = height_after(state, i, t, physics) + radius - physics[CUSHION_HEIGHT]
        if across <= 0.0:
            return NEVER  # over the top
        up = max(above, 0.0)
        distance = math.sqrt(across * across + up * up)
        closing = -(across * (px * vx + py * vy) / far + up * (state[VZ, i] - physics[GRAVITY] * t))
        gap = distance - radius
        if gap <= RIM_TOUCH and closing > 0.0:
            return t
        t += max(gap, RIM_TOUCH if closing > 0.0 else 1e-7) / bound
        if not t <= horizon:
            return NEVER
    return t


@inner_kernel
def _hole_time(state, i, k, horizon, elements, physics):
    """When ball i, low over pocket k, is stopped by the back of the hole; NEVER if not within `horizon` s."""
    pocket = elements.pockets[k]
    x = state[X, i] - pocket[0]
    y = state[Y, i] - pocket[1]
    vx = state[VX, i]
    vy = state[VY, i]
    speed_square = vx * vx + vy * vy
    along = x * vx + y * vy
    square = along * along - speed_square * (x * x + y * y - pocket[2] * pocket[2])
    if speed_square == 0.0 or square <= 0.0:
        return NEVER
    t = (math.sqrt(square) - along) / speed_square
    if not 0.0 <= t <= horizon or height_after(state, i, t, physics) >= physics[CUSHION_HEIGHT]:
        return NEVER
    px = state[X, i] + t * vx
    py = state[Y, i] + t * vy
    return NEVER if is_over_bed(px, py, elements, physics) else t


@inner_kernel
def _edge_time(state, i, horizon, physics):
    """When the centre of ball i is beyond the rails; NEVER if not within `horizon` s."""
    vx = state[VX, i]
    vy = state[VY, i]
    t = first_crossing(physics[FREE_RIGHT] + RAIL_WIDTH - state[X, i], -vx, 0.0, horizon)
    t = min(t, first_crossing(state[X, i] - physics[FREE_LEFT] + RAIL_WIDTH, vx, 0.0, horizon))
    t = min(t, first_crossing(physics[FREE_UPPER] + RAIL_WIDTH - state[Y, i], -vy, 0.0, horizon))
    return min(t, first_crossing(state[Y, i] - physics[FREE_LOWER] + RAIL_WIDTH, vy, 0.0, horizon))


@inner_kernel
def plan_flight(state, modes, i, elements, physics):
    """Set what ball i, in the air, will do next of its own: OWN_TIME (s), OWN_EVENT, OWN_ELEMENT."""
    best, event, element = _landing(state, i, elements, physics)
    best = min(best, LONGEST_SEARCH)
    for k in range(elements.cushions.shape[0]):
        t = _nose_time(state, i, k, best, elements.cushions, physics)
        if t < best:
            best = t
            event = BALL_CUSHION
            element = k
    for k in range(elements.jaws.shape[0]):
        t = _rim_time(state, i, k, best, elements.jaws, physics)
        if t < best:
            best = t
            event = BALL_JAW
            element = k
    for k in range(elements.pockets.shape[0]):
        t = _hole_time(state, i, k, best, elements, physics)
        if t < best:
            best = t
            event = BALL_POCKET
            element = k
    t = _edge_time(state, i, best, physics)
    if t < best:
        best = t
        event = BALL_OFF
        element = -1
    state[OWN_TIME, i] = state[TIME, i] + best
    modes[OWN_EVENT, i] = event
    modes[OWN_ELEMENT, i] = element
