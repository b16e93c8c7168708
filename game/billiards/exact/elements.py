"""What a ball will do next of its own: meet a rail, a jaw or a pocket, or end its phase.

Within the rectangle that the straight rails leave free, no jaw, pocket or slanted cushion can be reached;
one look at where the path leaves it then settles the matter. All elements are searched only for a ball
outside of it, or one that leaves it where there is no nose.
"""

from __future__ import annotations

from game.billiards.exact.detection import first_contact_time, first_crossing
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    AT_REST,
    AX,
    AY,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
    CLEAR,
    EDGE,
    FREE_LEFT,
    FREE_LOWER,
    FREE_RIGHT,
    FREE_UPPER,
    FROM_X,
    FROM_Y,
    MOTION,
    NEVER,
    NO_EVENT,
    NORMAL_X,
    NORMAL_Y,
    OWN_ELEMENT,
    OWN_EVENT,
    OWN_TIME,
    PHASE_END,
    RADIUS,
    ROLLING,
    SLIDING,
    TIME,
    TO_X,
    TO_Y,
    VX,
    VY,
    X,
    Y,
)

WITHIN = 1e-12  # m; rounding of a ball in contact with a rail
LONGEST_SEARCH = 1e9  # s; stands for "without end" where nothing slows a ball


@inner_kernel(inline="always")
def _edge_crossing(gap, speed, half_acceleration, horizon):
    """`first_crossing`, with the cheap case first: the gap stays open for the whole horizon."""
    if gap + horizon * (min(speed, 0.0) + horizon * min(half_acceleration, 0.0)) > 0.0:
        return NEVER
    return first_crossing(gap, speed, half_acceleration, horizon)


@inner_kernel(forceinline=True)
def _leave_free_rectangle(state, i, horizon, physics):
    """When and over which edge (0 left, 1 right, 2 lower, 3 upper) the path leaves the free rectangle.

    Returns (0, -1) for a ball that is not within it.
    """
    radius = state[RADIUS, i]
    x = state[X, i]
    y = state[Y, i]
    left = x - physics[FREE_LEFT] - radius
    right = physics[FREE_RIGHT] - x - radius
    lower = y - physics[FREE_LOWER] - radius
    upper = physics[FREE_UPPER] - y - radius
    if min(min(left, right), min(lower, upper)) < -WITHIN:
        return 0.0, -1
    vx = state[VX, i]
    vy = state[VY, i]
    ax = state[AX, i]
    ay = state[AY, i]
    first = _edge_crossing(left, vx, ax, horizon)
    edge = 0
    t = _edge_crossing(right, -vx, -ax, horizon)
    if t < first:
        first = t
        edge = 1
    t = _edge_crossing(lower, vy, ay, horizon)
    if t < first:
        first = t
        edge = 2
    t = _edge_crossing(upper, -vy, -ay, horizon)
    if t < first:
        first = t
        edge = 3
    return first, edge


@inner_kernel(inline="always")
def _faces(state, i, t, cushions, k):
    """True if the foot of ball i on the line of cushion k, t s from now, lies on the cushion."""
    x = state[X, i] + t * (state[VX, i] + t * state[AX, i]) - cushions[k, FROM_X]
    y = state[Y, i] + t * (state[VY, i] + t * state[AY, i]) - cushions[k, FROM_Y]
    dx = cushions[k, TO_X] - cushions[k, FROM_X]
    dy = cushions[k, TO_Y] - cushions[k, FROM_Y]
    along = x * dx + y * dy
    return 0.0 <= along <= dx * dx + dy * dy


@inner_kernel(inline="always")
def _nose_at(state, i, t, edge, cushions):
    """The cushion on a free edge that the ball meets t s from now; -1 if there is a mouth."""
    for k in range(cushions.shape[0]):
        if cushions[k, EDGE] == edge and _faces(state, i, t, cushions, k):
            return k
    return -1


@inner_kernel(inline="always")
def _search_cushions(state, i, horizon, cushions):
    """First cushion met within `horizon`: (time, row)."""
    radius = state[RADIUS, i]
    found = -1
    for k in range(cushions.shape[0]):
        nx = cushions[k, NORMAL_X]
        ny = cushions[k, NORMAL_Y]
        gap = (state[X, i] - cushions[k, FROM_X]) * nx + (state[Y, i] - cushions[k, FROM_Y]) * ny - radius
        speed = state[VX, i] * nx + state[VY, i] * ny
        half = state[AX, i] * nx + state[AY, i] * ny
        t = first_crossing(gap, speed, half, horizon)
        if t < horizon and _faces(state, i, t, cushions, k):
            horizon = t
            found = k
    return horizon, found


@inner_kernel(inline="always")
def _search_discs(state, i, horizon, discs, grown_by):
    """First disc whose circle, grown by `grown_by` m, the centre enters within `horizon`: (time, row)."""
    found = -1
    for k in range(discs.shape[0]):
        reach = discs[k, 2] + grown_by
        x = discs[k, 0] - state[X, i]
        y = discs[k, 1] - state[Y, i]
        t = first_contact_time(
            x, y, -state[VX, i], -state[VY, i], -state[AX, i], -state[AY, i], reach, horizon
        )
        if t < horizon:
            horizon = t
            found = k
    return horizon, found


@inner_kernel
def _search_elements(state, i, horizon, cushions, jaws, pockets):
    """First element of the table met within `horizon`: (time, event, row)."""
    event = NO_EVENT
    element = -1
    t, k = _search_cushions(state, i, horizon, cushions)
    if k >= 0:
        event = BALL_CUSHION
        element = k
    t, k = _search_discs(state, i, t, jaws, state[RADIUS, i])
    if k >= 0:
        event = BALL_JAW
        element = k
    t, k = _search_discs(state, i, t, pockets, 0.0)
    if k >= 0:
        event = BALL_POCKET
        element = k
    return t, event, element


@inner_kernel(forceinline=True)
def plan_ball(state, modes, i, cushions, jaws, pockets, physics):
    """Set what ball i will do next of its own: OWN_TIME (s), OWN_EVENT, OWN_ELEMENT.

    NO_EVENT stands for the end of its phase.
    """
    state[OWN_TIME, i] = state[PHASE_END, i]
    modes[OWN_EVENT, i] = NO_EVENT
    modes[OWN_ELEMENT, i] = -1
    motion = modes[MOTION, i]
    if motion != SLIDING and motion != ROLLING:
        return
    if cushions.shape[0] + jaws.shape[0] + pockets.shape[0] == 0:
        return
    horizon = min(state[PHASE_END, i] - state[TIME, i], LONGEST_SEARCH)
    if state[CLEAR, i] > 0.0:
        t, edge = _leave_free_rectangle(state, i, horizon, physics)
        if t >= AT_REST:
            return
        if edge >= 0:
            element = _nose_at(state, i, t, edge, cushions)
            if element >= 0:
                state[OWN_TIME, i] = state[TIME, i] + t
                modes[OWN_EVENT, i] = BALL_CUSHION
                modes[OWN_ELEMENT, i] = element
                return
    t, event, element = _search_elements(state, i, horizon, cushions, jaws, pockets)
    if event != NO_EVENT:
        state[OWN_TIME, i] = state[TIME, i] + t
        modes[OWN_EVENT, i] = event
        modes[OWN_ELEMENT, i] = element
