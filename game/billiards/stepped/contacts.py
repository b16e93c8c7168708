"""Contacts of one step: what overlaps after the balls have moved is turned round and moved apart.

Balls are looked at where the step has put them, pair after pair by index, as most game engines do: each
overlapping pair that closes collides by the table's model (`impacts`), and is moved apart by mass. A round
ends with the rails. Several rounds let what one repair has spoilt be repaired in the next. So contacts are
found up to a step late, a rack passes an impulse on in the order of its numbers. Balls that move more than
they are wide in a step may pass through each other.

The table itself is not to be passed: a ball whose centre has crossed a cushion's line within this step is
caught, however far it went. A pocket takes a ball whose path has led over it.

Arrays: state, modes, pairs and the elements (cushions, jaws, pockets) as in `state`; old (2, n) m, places
when the step began; physics (20,); events (e, 4); counters (6,).
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.contacts.ball_ball_normal import closing_speed, reach_of
from game.billiards.laws.impacts import collide_pair, end_chatter, hit_rail, normal_between
from game.billiards.laws.lean import lean_kernel

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
    radius = state[s.RADIUS, i]
    x = state[s.X, i]
    y = state[s.Y, i]
    return (
        state[s.CLEAR, i] > 0.0
        and physics[s.FREE_LEFT] + radius <= x <= physics[s.FREE_RIGHT] - radius
        and physics[s.FREE_LOWER] + radius <= y <= physics[s.FREE_UPPER] - radius
    )


@lean_kernel
def fall_into_pocket(state, modes, i, old, pockets):
    """Take ball i out of play if its path in this step led over a pocket. Returns the pocket, or -1."""
    path_x = state[s.X, i] - old[OLD_X, i]
    path_y = state[s.Y, i] - old[OLD_Y, i]
    squared = path_x * path_x + path_y * path_y
    for k in range(pockets.shape[0]):
        dx = pockets[k, 0] - old[OLD_X, i]
        dy = pockets[k, 1] - old[OLD_Y, i]
        part = (dx * path_x + dy * path_y) / squared if squared > 0.0 else 0.0
        part = min(1.0, max(0.0, part))
        dx -= part * path_x
        dy -= part * path_y
        if dx * dx + dy * dy < pockets[k, 2] * pockets[k, 2]:
            for row in range(s.VX, s.WZ + 1):
                state[row, i] = 0.0
            modes[s.MOTION, i] = s.POCKETED
            return k
    return -1


@lean_kernel
def faces(cushions, k, x, y):
    """True if the foot of x, y on the line of cushion k lies on the cushion."""
    dx = cushions[k, s.TO_X] - cushions[k, s.FROM_X]
    dy = cushions[k, s.TO_Y] - cushions[k, s.FROM_Y]
    along = (x - cushions[k, s.FROM_X]) * dx + (y - cushions[k, s.FROM_Y]) * dy
    return 0.0 <= along <= dx * dx + dy * dy


@lean_kernel
def deepest_rail(state, i, old, cushions, jaws):
    """What ball i has sunk into most: depth (m, 0 if nothing), event, element, unit vector to the ball."""
    x = state[s.X, i]
    y = state[s.Y, i]
    old_x = old[OLD_X, i]
    old_y = old[OLD_Y, i]
    radius = state[s.RADIUS, i]
    depth = 0.0
    event = s.NO_EVENT
    element = -1
    normal_x = 1.0
    normal_y = 0.0
    for k in range(cushions.shape[0]):
        nx = cushions[k, s.NORMAL_X]
        ny = cushions[k, s.NORMAL_Y]
        height = (x - cushions[k, s.FROM_X]) * nx + (y - cushions[k, s.FROM_Y]) * ny
        if radius - height <= depth:
            continue
        met = faces(cushions, k, x, y)
        if height <= 0.0:
            was = (old_x - cushions[k, s.FROM_X]) * nx + (old_y - cushions[k, s.FROM_Y]) * ny
            met = was >= 0.0 and (met or faces(cushions, k, old_x, old_y))
        if met:
            depth = radius - height
            event = s.BALL_CUSHION
            element = k
            normal_x = nx
            normal_y = ny
    for k in range(jaws.shape[0]):
        dx = x - jaws[k, 0]
        dy = y - jaws[k, 1]
        distance = math.sqrt(dx * dx + dy * dy)
        if distance > 0.0 and jaws[k, 2] + radius - distance > depth:
            depth = jaws[k, 2] + radius - distance
            event = s.BALL_JAW
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
        if state[s.VX, i] * nx + state[s.VY, i] * ny < -s.CLOSING_SPEED:
            now = state[s.TIME, i]
            same = modes[s.OWN_EVENT, i] == event and modes[s.OWN_ELEMENT, i] == element
            if not (same and state[s.RAIL_TIME, i] == now):
                log_event(events, counters, now, event, i, element)
            modes[s.OWN_EVENT, i] = event
            modes[s.OWN_ELEMENT, i] = element
            hit_rail(state, modes, i, event, element, cushions, jaws, physics)
            modes[s.MOTION, i] = s.SLIDING
        state[s.X, i] += depth * nx
        state[s.Y, i] += depth * ny
    return overlapped


@lean_kernel
def meet_ball(state, modes, pairs, i, j, overlap, physics, events, counters):
    """Balls i and j overlap (m): they collide if they close, and are moved apart."""
    nx, ny = normal_between(state, i, j)
    if closing_speed(state, i, j, nx, ny) > s.CLOSING_SPEED:
        collide_pair(state, i, j, nx, ny, physics)
        modes[s.MOTION, i] = s.SLIDING
        modes[s.MOTION, j] = s.SLIDING
        now = state[s.TIME, i]
        if pairs[s.MET, i, j] < now:
            log_event(events, counters, now, s.BALL_BALL, i, j)
            end_chatter(state, pairs, i, j, nx, ny, now)
    if overlap > OVERLAP:
        share = overlap * state[s.MASS, j] / (state[s.MASS, i] + state[s.MASS, j])
        state[s.X, i] -= share * nx
        state[s.Y, i] -= share * ny
        state[s.X, j] += (overlap - share) * nx
        state[s.Y, j] += (overlap - share) * ny


@lean_kernel
def meet_balls(state, modes, pairs, physics, events, counters):
    """One round over all pairs. Returns True if one overlapped."""
    overlapped = False
    n = state.shape[1]
    counters[PAIR_TESTS] += n * (n - 1) // 2
    for i in range(n - 1):
        if modes[s.MOTION, i] == s.POCKETED:
            continue
        for j in range(i + 1, n):
            dx = state[s.X, j] - state[s.X, i]
            dy = state[s.Y, j] - state[s.Y, i]
            reach = reach_of(state[s.RADIUS, i], state[s.RADIUS, j])
            squared = dx * dx + dy * dy
            if squared < reach * reach and modes[s.MOTION, j] != s.POCKETED:
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
        motion = modes[s.MOTION, i]
        if (motion in (s.SLIDING, s.ROLLING)) and not is_in_the_open(state, i, physics):
            pocket = fall_into_pocket(state, modes, i, old, pockets)
            if pocket >= 0:
                log_event(events, counters, state[s.TIME, i], s.BALL_POCKET, i, pocket)
    for _ in range(passes):
        overlapped = meet_balls(state, modes, pairs, physics, events, counters)
        for i in range(n):
            if modes[s.MOTION, i] == s.POCKETED or is_in_the_open(state, i, physics):
                continue
            if meet_rails(state, modes, i, old, cushions, jaws, physics, events, counters):
                overlapped = True
        if not overlapped:
            return
