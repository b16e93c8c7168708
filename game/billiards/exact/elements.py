"""What a ball will do next of its own: meet a rail, a jaw or a pocket, or end its phase.

Within the rectangle that the straight rails leave free, no jaw, pocket or slanted cushion can be reached. One
look at where the path leaves it then settles the matter. All elements are searched only for a ball outside of
it, or one that leaves it where there is no nose.
"""

from __future__ import annotations

from game.billiards.exact.detection import first_contact_time, first_crossing
from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel

WITHIN = 1e-12  # m; rounding of a ball in contact with a rail
LONGEST_SEARCH = 1e9  # s; stands for "without end" where nothing slows a ball


@inner_kernel(inline="always")
def _edge_crossing(gap, speed, half_acceleration, horizon):
    """`first_crossing`, with the cheap case first: the gap stays open for the whole horizon."""
    if gap + horizon * (min(speed, 0.0) + horizon * min(half_acceleration, 0.0)) > 0.0:
        return s.NEVER
    return first_crossing(gap, speed, half_acceleration, horizon)


@inner_kernel(forceinline=True)
def _leave_free_rectangle(state, i, horizon, physics):
    """When and over which edge (0 left, 1 right, 2 lower, 3 upper) the path leaves the free rectangle.

    Returns (0, -1) for a ball that is not within it.
    """
    radius = state[s.RADIUS, i]
    x = state[s.X, i]
    y = state[s.Y, i]
    left = x - physics[s.FREE_LEFT] - radius
    right = physics[s.FREE_RIGHT] - x - radius
    lower = y - physics[s.FREE_LOWER] - radius
    upper = physics[s.FREE_UPPER] - y - radius
    if min(min(left, right), min(lower, upper)) < -WITHIN:
        return 0.0, -1
    vx = state[s.VX, i]
    vy = state[s.VY, i]
    ax = state[s.AX, i]
    ay = state[s.AY, i]
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
    x = state[s.X, i] + t * (state[s.VX, i] + t * state[s.AX, i]) - cushions[k, s.FROM_X]
    y = state[s.Y, i] + t * (state[s.VY, i] + t * state[s.AY, i]) - cushions[k, s.FROM_Y]
    dx = cushions[k, s.TO_X] - cushions[k, s.FROM_X]
    dy = cushions[k, s.TO_Y] - cushions[k, s.FROM_Y]
    along = x * dx + y * dy
    return 0.0 <= along <= dx * dx + dy * dy


@inner_kernel(inline="always")
def _nose_at(state, i, t, edge, cushions):
    """The cushion on a free edge that the ball meets t s from now; -1 if there is a mouth."""
    for k in range(cushions.shape[0]):
        if cushions[k, s.EDGE] == edge and _faces(state, i, t, cushions, k):
            return k
    return -1


@inner_kernel(inline="always")
def _search_cushions(state, i, horizon, cushions):
    """First cushion met within `horizon`: (time, row)."""
    radius = state[s.RADIUS, i]
    found = -1
    for k in range(cushions.shape[0]):
        nx = cushions[k, s.NORMAL_X]
        ny = cushions[k, s.NORMAL_Y]
        gap = (
            (state[s.X, i] - cushions[k, s.FROM_X]) * nx
            + (state[s.Y, i] - cushions[k, s.FROM_Y]) * ny
            - radius
        )
        speed = state[s.VX, i] * nx + state[s.VY, i] * ny
        half = state[s.AX, i] * nx + state[s.AY, i] * ny
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
        x = discs[k, 0] - state[s.X, i]
        y = discs[k, 1] - state[s.Y, i]
        t = first_contact_time(
            x, y, -state[s.VX, i], -state[s.VY, i], -state[s.AX, i], -state[s.AY, i], reach, horizon
        )
        if t < horizon:
            horizon = t
            found = k
    return horizon, found


@inner_kernel
def _search_elements(state, i, horizon, cushions, jaws, pockets):
    """First element of the table met within `horizon`: (time, event, row)."""
    event = s.NO_EVENT
    element = -1
    t, k = _search_cushions(state, i, horizon, cushions)
    if k >= 0:
        event = s.BALL_CUSHION
        element = k
    t, k = _search_discs(state, i, t, jaws, state[s.RADIUS, i])
    if k >= 0:
        event = s.BALL_JAW
        element = k
    t, k = _search_discs(state, i, t, pockets, 0.0)
    if k >= 0:
        event = s.BALL_POCKET
        element = k
    return t, event, element


@inner_kernel(forceinline=True)
def plan_ball(state, modes, i, cushions, jaws, pockets, physics):
    """Set what ball i will do next of its own: OWN_TIME (s), OWN_EVENT, OWN_ELEMENT.

    NO_EVENT stands for the end of its phase.
    """
    state[s.OWN_TIME, i] = state[s.PHASE_END, i]
    modes[s.OWN_EVENT, i] = s.NO_EVENT
    modes[s.OWN_ELEMENT, i] = -1
    motion = modes[s.MOTION, i]
    if motion != s.SLIDING and motion != s.ROLLING:
        return
    if cushions.shape[0] + jaws.shape[0] + pockets.shape[0] == 0:
        return
    horizon = min(state[s.PHASE_END, i] - state[s.TIME, i], LONGEST_SEARCH)
    if state[s.CLEAR, i] > 0.0:
        t, edge = _leave_free_rectangle(state, i, horizon, physics)
        if t >= s.AT_REST:
            return
        if edge >= 0:
            element = _nose_at(state, i, t, edge, cushions)
            if element >= 0:
                state[s.OWN_TIME, i] = state[s.TIME, i] + t
                modes[s.OWN_EVENT, i] = s.BALL_CUSHION
                modes[s.OWN_ELEMENT, i] = element
                return
    t, event, element = _search_elements(state, i, horizon, cushions, jaws, pockets)
    if event != s.NO_EVENT:
        state[s.OWN_TIME, i] = state[s.TIME, i] + t
        modes[s.OWN_EVENT, i] = event
        modes[s.OWN_ELEMENT, i] = element
