"""The exact table: from event to event, a whole batch of shots in one kernel.

State of balls stands still between their events; time is the time of the next event. Each event changes one
ball, or the balls of one contact: they get a new phase, a new plan (`elements`) and new contact times
(`pairs`). Everything that happens is written down as events and as segments, the closed forms of each
ball's way, from which any moment can be had.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.cluster import collide_jointly, gather_contacts, has_company
from game.billiards.elements import plan_ball
from game.billiards.impacts import collide_pair, end_chatter, hit_rail, normal_between
from game.billiards.joint import joint_scratch
from game.billiards.motion import advance, end_phase, enter_phase
from game.billiards.pairs import refresh_pairs
from game.billiards.state import (
    AT_REST,
    BALL_BALL,
    BALL_POCKET,
    BUFFER_FULL,
    CLEAR,
    END_ROWS,
    EVENT_LIMIT,
    FINISHED,
    FIRST,
    FLOAT_ROWS,
    FORCE_ROWS,
    IMPULSE,
    IN_CLEAR,
    IN_MASS,
    IN_MOTION,
    IN_RADIUS,
    IN_WZ,
    INTEGER_ROWS,
    INVERSE_MASS,
    MARK,
    MASS,
    MEET,
    MEMBER,
    MET,
    MOTION,
    NEVER,
    NEXT_TIME,
    NO_EVENT,
    NOT_FINITE,
    OWN_ELEMENT,
    OWN_EVENT,
    OWN_TIME,
    PAIR_PLANES,
    PAIR_TIME,
    PARTNER,
    POCKETED,
    RADIUS,
    RAIL_COUNT,
    RAIL_TIME,
    REPEATS,
    SECOND,
    SEG_BALL,
    SEG_MOTION,
    SLIDING,
    TIME,
    VX,
    WZ,
    X,
)
from game.billiards.lean import lean_kernel

Array = NDArray[np.float64]
HIT = 3  # mark of a ball that got an impulse


class Workspace(NamedTuple):
    """Room for one shot of n balls with up to m contacts at once; kept and used again."""

    state: Array  # (FLOAT_ROWS, n)
    modes: NDArray[np.int64]  # (INTEGER_ROWS, n)
    pairs: Array  # (PAIR_PLANES, n, n)
    ends: NDArray[np.int64]  # (END_ROWS, m)
    forces: Array  # (FORCE_ROWS, m)
    normals: Array  # (m, 2)
    velocities: Array  # (n, 2)
    joint_contacts: Array
    joint_balls: Array


def workspace(n: int) -> Workspace:
    """Room for shots of n balls."""
    m = max(1, n * (n - 1) // 2)
    joint = joint_scratch(n, m)
    return Workspace(
        np.zeros((FLOAT_ROWS, n)),
        np.zeros((INTEGER_ROWS, n), np.int64),
        np.zeros((PAIR_PLANES, n, n)),
        np.zeros((END_ROWS, m), np.int64),
        np.zeros((FORCE_ROWS, m)),
        np.zeros((m, 2)),
        np.zeros((n, 2)),
        joint.contacts,
        joint.balls,
    )


class Batch(NamedTuple):
    """m shots of n balls each, as the kernel reads them.

    balls (m, n, 11), physics (m, 16): see `state`. cushions (c, 7), jaws (j, 3), pockets (p, 3): of all
    tables in use. ranges (m, 6): first and end of each shot's cushions, jaws, pockets.
    """

    balls: Array
    physics: Array
    cushions: Array
    jaws: Array
    pockets: Array
    ranges: NDArray[np.int64]


class Log(NamedTuple):
    """What the kernel writes; events and segments of all shots one after another, in order of time.

    times (e,) s. events (e, 3): type, ball, ball or element (-1: none). segments (s, 12): see `state`.
    ranges (m, 4): start and end of each shot's events, and of its segments. status (m,): see `state`.
    final (m, n, 11): balls as they come in. end_times (m,) s: time of the last event, or `until`.
    """

    times: Array
    events: NDArray[np.int64]
    segments: Array
    ranges: NDArray[np.int64]
    status: NDArray[np.int64]
    final: Array
    end_times: Array


@lean_kernel(inline="always")
def record_ball(segments, row, state, modes, i):
    """Write the segment that ball i now begins."""
    for column in range(SEG_BALL):
        segments[row, column] = state[TIME + column, i]
    segments[row, SEG_BALL] = i
    segments[row, SEG_MOTION] = modes[MOTION, i]


@lean_kernel(inline="always")
def record_event(times, events, row, time, event, i, j):
    """Write an event."""
    times[row] = time
    events[row, 0] = event
    events[row, 1] = i
    events[row, 2] = j


@lean_kernel(forceinline=True)
def place_balls(state, modes, pairs, balls, physics):
    """Put the balls of a shot on the table, at time 0."""
    n = balls.shape[0]
    for i in range(n):
        state[TIME, i] = 0.0
        for column in range(IN_WZ + 1):
            state[X + column, i] = balls[i, column]
        state[RADIUS, i] = balls[i, IN_RADIUS]
        state[MASS, i] = balls[i, IN_MASS]
        state[INVERSE_MASS, i] = 1.0 / balls[i, IN_MASS]
        state[CLEAR, i] = balls[i, IN_CLEAR]
        state[RAIL_TIME, i] = -1.0
        state[PAIR_TIME, i] = NEVER
        modes[PARTNER, i] = -1
        modes[RAIL_COUNT, i] = 0
        enter_phase(state, modes, i, int(balls[i, IN_MOTION]), physics)
        for j in range(n):
            pairs[MEET, i, j] = NEVER
            pairs[MET, i, j] = -1.0
            pairs[REPEATS, i, j] = 0.0


@lean_kernel(inline="always")
def soonest_ball(state):
    """The ball whose next event comes first, the lowest number of several."""
    first = 0
    least = state[NEXT_TIME, 0]
    for i in range(1, state.shape[1]):
        time = state[NEXT_TIME, i]
        first = i if time < least else first
        least = min(time, least)
    return first


@lean_kernel(forceinline=True)
def happen_to_ball(state, modes, i, cushions, jaws, physics):
    """Carry out what ball i planned of its own. Returns the event."""
    event = modes[OWN_EVENT, i]
    if event == NO_EVENT:
        return end_phase(state, modes, i, physics)
    advance(state, modes, i, state[OWN_TIME, i], physics)
    if event == BALL_POCKET:
        for row in range(VX, WZ + 1):
            state[row, i] = 0.0
        enter_phase(state, modes, i, POCKETED, physics)
    else:
        hit_rail(state, modes, i, event, modes[OWN_ELEMENT, i], cushions, jaws, physics)
        enter_phase(state, modes, i, SLIDING, physics)
    return event


@lean_kernel(forceinline=True)
def meet_alone(state, modes, pairs, i, j, now, physics):
    """Balls i and j collide, and no other contact takes part."""
    advance(state, modes, i, now, physics)
    advance(state, modes, j, now, physics)
    nx, ny = normal_between(state, i, j)
    collide_pair(state, i, j, nx, ny, physics)
    end_chatter(state, pairs, i, j, nx, ny, now)
    modes[MEMBER, 0] = i
    modes[MEMBER, 1] = j
    enter_phase(state, modes, i, SLIDING, physics)
    enter_phase(state, modes, j, SLIDING, physics)


@lean_kernel
def meet_in_company(
    state, modes, pairs, ends, forces, normals, velocities, joint_contacts, joint_balls, i, j, now, physics
):
    """Balls i and j collide together with all that touch them.

    Moves the contacts that got an impulse to the front of ends, and writes their balls to row MEMBER of
    modes. Returns the numbers of both.
    """
    count, found = gather_contacts(state, modes, pairs, i, j, now, ends, normals)
    for q in range(found):
        advance(state, modes, modes[MEMBER, q], now, physics)
    collide_jointly(
        state, modes, found, count, ends, normals, forces, velocities, joint_contacts, joint_balls, physics
    )
    written = 0
    for m in range(count):
        if forces[IMPULSE, m] > 0.0:
            a = ends[FIRST, m]
            b = ends[SECOND, m]
            end_chatter(state, pairs, a, b, normals[m, 0], normals[m, 1], now)
            ends[FIRST, written] = a
            ends[SECOND, written] = b
            written += 1
            modes[MARK, a] = HIT
            modes[MARK, b] = HIT
    changed = 0
    for q in range(found):
        k = modes[MEMBER, q]
        if modes[MARK, k] == HIT:
            modes[MEMBER, changed] = k
            changed += 1
            enter_phase(state, modes, k, SLIDING, physics)
    return written, changed


@lean_kernel
def play_shot(
    work, cushions, jaws, pockets, physics, until, max_events, times, events, segments, row, segment
):
    """Play one shot whose balls are placed. Returns status, end of events, end of segments, end time."""
    state, modes, pairs, ends, forces, normals, velocities, joint_contacts, joint_balls = work
    n = state.shape[1]
    first_row = row
    end_time = 0.0
    changed = n
    for i in range(n):
        modes[MEMBER, i] = i
    while True:
        if row + ends.shape[1] > times.shape[0] or segment + n > segments.shape[0]:
            return BUFFER_FULL, row, segment, end_time
        for q in range(changed):
            i = modes[MEMBER, q]
            record_ball(segments, segment + q, state, modes, i)
            plan_ball(state, modes, i, cushions, jaws, pockets, physics)
        segment += changed
        for q in range(changed):
            refresh_pairs(state, modes, pairs, modes[MEMBER, q])
        i = soonest_ball(state)
        now = state[NEXT_TIME, i]
        if not (now < AT_REST and now <= until):
            return FINISHED, row, segment, (until if now < AT_REST else end_time)
        if row - first_row >= max_events:
            return EVENT_LIMIT, row, segment, end_time
        end_time = now
        if not state[PAIR_TIME, i] < state[OWN_TIME, i]:
            event = happen_to_ball(state, modes, i, cushions, jaws, physics)
            record_event(times, events, row, now, event, i, modes[OWN_ELEMENT, i])
            row += 1
            modes[MEMBER, 0] = i
            changed = 1
            continue
        j = modes[PARTNER, i]
        ends[FIRST, 0] = i
        ends[SECOND, 0] = j
        written = 1
        changed = 2
        if has_company(pairs, i, j, now):
            written, changed = meet_in_company(
                state,
                modes,
                pairs,
                ends,
                forces,
                normals,
                velocities,
                joint_contacts,
                joint_balls,
                i,
                j,
                now,
                physics,
            )
        else:
            meet_alone(state, modes, pairs, i, j, now, physics)
        for m in range(written):
            i = ends[FIRST, m]
            j = ends[SECOND, m]
            record_event(times, events, row, now, BALL_BALL, min(i, j), max(i, j))
            row += 1


@lean_kernel
def write_final(state, modes, end_time, final, physics):
    """Bring all balls to the end and write them. Returns False if a number is not finite."""
    total = 0.0
    for i in range(final.shape[0]):
        if modes[MOTION, i] != POCKETED:
            advance(state, modes, i, end_time, physics)
        for column in range(IN_WZ + 1):
            final[i, column] = state[X + column, i]
            total += abs(final[i, column])
        final[i, IN_RADIUS] = state[RADIUS, i]
        final[i, IN_MASS] = state[MASS, i]
        final[i, IN_MOTION] = modes[MOTION, i]
    return total < NEVER


@lean_kernel
def play_shots(work, batch, log, first, until, max_events):
    """Play shots from number `first` on until the log is full, each at most to the time `until` (s).

    Returns the number of the first shot that was not played.
    """
    shots = batch.physics.shape[0]
    row = 0
    segment = 0
    for s in range(first, shots):
        physics = batch.physics[s]
        cushions = batch.cushions[batch.ranges[s, 0] : batch.ranges[s, 1]]
        jaws = batch.jaws[batch.ranges[s, 2] : batch.ranges[s, 3]]
        pockets = batch.pockets[batch.ranges[s, 4] : batch.ranges[s, 5]]
        place_balls(work.state, work.modes, work.pairs, batch.balls[s], physics)
        status, row_end, segment_end, end_time = play_shot(
            work,
            cushions,
            jaws,
            pockets,
            physics,
            until,
            max_events,
            log.times,
            log.events,
            log.segments,
            row,
            segment,
        )
        if status == BUFFER_FULL:
            return s
        if not write_final(work.state, work.modes, end_time, log.final[s], physics):
            status = NOT_FINITE
        log.status[s] = status
        log.end_times[s] = end_time
        log.ranges[s, 0] = row
        log.ranges[s, 1] = row_end
        log.ranges[s, 2] = segment
        log.ranges[s, 3] = segment_end
        row = row_end
        segment = segment_end
    return shots
