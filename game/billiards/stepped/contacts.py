"""Contacts of one step: what overlaps after the balls have moved is turned round and moved apart.

Balls are looked at where the step has put them, pair after pair by index, as most game engines do: each
overlapping pair that closes collides by the table's model (`impacts`), and is moved apart by mass. A round
ends with the rails. Several rounds let what one repair has spoilt be repaired in the next. So contacts are
found up to a step late, a rack passes an impulse on in the order of its numbers, and balls that move more
than they are wide in a step may pass through each other.

The table itself is not to be passed: a ball whose centre has crossed a cushion's line within this step is
caught, however far it went, and a pocket takes a ball whose path has led over it.

Arrays: state, modes, pairs and the elements (cushions, jaws, pockets) as in `state`; old (2, n) m, places
when the step began; physics (20,); events (e, 4); counters (6,).
"""

from __future__ import annotations

import math

from game.billiards.laws.contacts.ball_ball_normal import closing_speed, reach_of
from game.billiards.laws.impacts import collide_pair, end_chatter, hit_rail, normal_between
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
    CLEAR,
    CLOSING_SPEED,
    FREE_LEFT,
    FREE_LOWER,
    FREE_RIGHT,
    FREE_UPPER,
    FROM_X,
    FROM_Y,
    MASS,
    MET,
    MOTION,
    NO_EVENT,
    NORMAL_X,
    NORMAL_Y,
    OWN_ELEMENT,
    OWN_EVENT,
    POCKETED,
    RADIUS,
    RAIL_TIME,
    ROLLING,
    SLIDING,
    TIME,
    TO_X,
    TO_Y,
    VX,
    VY,
    WZ,
    X,
    Y,
)

OVERLAP = 1e-12  # m; smaller ones are rounding, and left
RAIL_TURNS = 8  # repairs of one ball on the rails in a round: a corner takes two, a very fast ball more
OLD_X, OLD_Y = range(2)  # rows of old (2, n) m: where the balls were when the step began
EVENTS, LOST_EVENTS, PAIR_TESTS = range(3)  # counters


@lean_kernel
def log_event(events, counters, time, event, i, j):
    """Append an event to events (e, 4), or count it as lost when the list is full."""
    row = counters[EVENTS]
    if row >= events.shape[0]:
        counters[LOST_EVENTS] += 1
        return
    events[row, 0] = time
    events[row, 1] = event
    events[row, 2] = i
    events[row, 3] = j
    counters[EVENTS] = row + 1


@lean_kernel
def is_in_the_open(state, i, physics):
    """True if ball i is where no rail and no pocket can be."""
    radius = state[RADIUS, i]
    x = state[X, i]
    y = state[Y, i]
    return (
        state[CLEAR, i] > 0.0
        and physics[FREE_LEFT] + radius <= x <= physics[FREE_RIGHT] - radius
        and physics[FREE_LOWER] + radius <= y <= physics[FREE_UPPER] - radius
    )


@lean_kernel
def fall_into_pocket(state, modes, i, old, pockets):
    """Take ball i out of play if its path in this step led over a pocket. Returns the pocket, or -1."""
    path_x = state[X, i] - old[OLD_X, i]
    path_y = state[Y, i] - old[OLD_Y, i]
    squared = path_x * path_x + path_y * path_y
    for k in range(pockets.shape[0]):
        dx = pockets[k, 0] - old[OLD_X, i]
        dy = pockets[k, 1] - old[OLD_Y, i]
        part = (dx * path_x + dy * path_y) / squared if squared > 0.0 else 0.0
        part = min(1.0, max(0.0, part))
        dx -= part * path_x
        dy -= part * path_y
        if dx * dx + dy * dy < pockets[k, 2] * pockets[k, 2]:
            for row in range(VX, WZ + 1):
                state[row, i] = 0.0
            modes[MOTION, i] = POCKETED
            return k
    return -1


@lean_kernel
def faces(cushions, k, x, y):
    """True if the foot of x, y on the line of cushion k lies on the cushion."""
    dx = cushions[k, TO_X] - cushions[k, FROM_X]
    dy = cushions[k, TO_Y] - cushions[k, FROM_Y]
    along = (x - cushions[k, FROM_X]) * dx + (y - cushions[k, FROM_Y]) * dy
    return 0.0 <= along <= dx * dx + dy * dy


@lean_kernel
def deepest_rail(state, i, old, cushions, jaws):
    """What ball i has sunk into most: depth (m, 0 if nothing), event, element, unit vector to the ball."""
    x = state[X, i]
    y = state[Y, i]
    old_x = old[OLD_X, i]
    old_y = old[OLD_Y, i]
    radius = state[RADIUS, i]
    depth = 0.0
    event = NO_EVENT
    element = -1
    normal_x = 1.0
    normal_y = 0.0
    for k in range(cushions.shape[0]):
        nx = cushions[k, NORMAL_X]
        ny = cushions[k, NORMAL_Y]
        height = (x - cushions[k, FROM_X]) * nx + (y - cushions[k, FROM_Y]) * ny
        if radius - height <= depth:
            continue
        met = faces(cushions, k, x, y)
        if height <= 0.0:
            was = (old_x - cushions[k, FROM_X]) * nx + (old_y - cushions[k, FROM_Y]) * ny
            met = was >= 0.0 and (met or faces(cushions, k, old_x, old_y))
        if met:
            depth = radius - height
            event = BALL_CUSHION
            element = k
            normal_x = nx
            normal_y = ny
    for k in range(jaws.shape[0]):
        dx = x - jaws[k, 0]
        dy = y - jaws[k, 1]
        distance = math.sqrt(dx * dx + dy * dy)
        if distance > 0.0 and jaws[k, 2] + radius - distance > depth:
            depth = jaws[k, 2] + radius - distance
            event = BALL_JAW
            element = k
            normal_x = dx / distance
            normal_y = dy / distance
    return depth, event, element, normal_x, normal_y


@lean_kernel
def meet_rails(state, modes, i, old, cushions, jaws, physics, events, counters):
    """Turn ball i round at the rails that it has sunk into, and put it back. True if there was one."""
    overlapped = False
    for _ in range(RAIL_TURNS):
        depth, event, element, nx, ny = deepest_rail(state, i, old, cushions, jaws)
        if depth <= OVERLAP:
            break
        overlapped = True
        if state[VX, i] * nx + state[VY, i] * ny < -CLOSING_SPEED:
            now = state[TIME, i]
            same = modes[OWN_EVENT, i] == event and modes[OWN_ELEMENT, i] == element
            if not (same and state[RAIL_TIME, i] == now):
                log_event(events, counters, now, event, i, element)
            modes[OWN_EVENT, i] = event
            modes[OWN_ELEMENT, i] = element
            hit_rail(state, modes, i, event, element, cushions, jaws, physics)
            modes[MOTION, i] = SLIDING
        state[X, i] += depth * nx
        state[Y, i] += depth * ny
    return overlapped


@lean_kernel
def meet_ball(state, modes, pairs, i, j, overlap, physics, events, counters):
    """Balls i and j overlap (m): they collide if they close, and are moved apart."""
    nx, ny = normal_between(state, i, j)
    if closing_speed(state, i, j, nx, ny) > CLOSING_SPEED:
        collide_pair(state, i, j, nx, ny, physics)
        modes[MOTION, i] = SLIDING
        modes[MOTION, j] = SLIDING
        now = state[TIME, i]
        if pairs[MET, i, j] < now:
            log_event(events, counters, now, BALL_BALL, i, j)
            end_chatter(state, pairs, i, j, nx, ny, now)
    if overlap > OVERLAP:
        share = overlap * state[MASS, j] / (state[MASS, i] + state[MASS, j])
        state[X, i] -= share * nx
        state[Y, i] -= share * ny
        state[X, j] += (overlap - share) * nx
        state[Y, j] += (overlap - share) * ny


@lean_kernel
def meet_balls(state, modes, pairs, physics, events, counters):
    """One round over all pairs. Returns True if one overlapped."""
    overlapped = False
    n = state.shape[1]
    counters[PAIR_TESTS] += n * (n - 1) // 2
    for i in range(n - 1):
        if modes[MOTION, i] == POCKETED:
            continue
        for j in range(i + 1, n):
            dx = state[X, j] - state[X, i]
            dy = state[Y, j] - state[Y, i]
            reach = reach_of(state[RADIUS, i], state[RADIUS, j])
            squared = dx * dx + dy * dy
            if squared < reach * reach and modes[MOTION, j] != POCKETED:
                overlap = reach - math.sqrt(squared)
                meet_ball(state, modes, pairs, i, j, overlap, physics, events, counters)
                overlapped = overlapped or overlap > OVERLAP
    return overlapped


@lean_kernel
def settle_contacts(steps, elements, physics, passes, log):
    """Pockets, then up to `passes` rounds of balls and rails, until nothing overlaps."""
    state, modes, pairs, old = steps
    cushions, jaws, pockets = elements
    events, counters = log
    n = state.shape[1]
    for i in range(n):
        motion = modes[MOTION, i]
        if (motion in (SLIDING, ROLLING)) and not is_in_the_open(state, i, physics):
            pocket = fall_into_pocket(state, modes, i, old, pockets)
            if pocket >= 0:
                log_event(events, counters, state[TIME, i], BALL_POCKET, i, pocket)
    for _ in range(passes):
        overlapped = meet_balls(state, modes, pairs, physics, events, counters)
        for i in range(n):
            if modes[MOTION, i] == POCKETED or is_in_the_open(state, i, physics):
                continue
            if meet_rails(state, modes, i, old, cushions, jaws, physics, events, counters):
                overlapped = True
        if not overlapped:
            return
