"""The exact table: from event to event, a whole batch of shots in one kernel.

State of balls stands still between their events; time is the time of the next event. Each event changes one
ball, or the balls of one contact: they get a new phase, a new plan (`elements`) and new contact times
(`pairs`). Everything that happens is written down as events and as segments, the closed forms of each
ball's path, from which any moment can be had. All are right to rounding, but for the cushion of Mathavan
2010, which is followed in steps: see `contacts.cushion_mathavan_2010`.
"""

from __future__ import annotations

from game.billiards.exact.elements import plan_ball
from game.billiards.exact.meeting import meet
from game.billiards.exact.pairs import RENEWED, lies_apart, refresh_pairs
from game.billiards.exact.settling import settle_group
from game.billiards.laws import state as col
from game.billiards.laws.batch import Elements, view_workspace
from game.billiards.laws.impacts import hit_rail
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.laws.motion import advance, end_phase, enter_phase


@inner_kernel(inline="always")
def record_ball(segments, row, state, modes, i, physics):
    """Write the segment that ball i now begins."""
    for column in range(col.SEG_BALL):
        segments[row, column] = state[col.TIME + column, i]
    segments[row, col.SEG_X] += physics[col.MIDDLE_X]
    segments[row, col.SEG_Y] += physics[col.MIDDLE_Y]
    segments[row, col.SEG_BALL] = i
    segments[row, col.SEG_MOTION] = modes[col.MOTION, i]


@inner_kernel(inline="always")
def record_event(events, row, time, event, i, j):
    """Write an event."""
    events[row, 0] = time
    events[row, 1] = event
    events[row, 2] = i
    events[row, 3] = j


@inner_kernel(forceinline=True)
def place_balls(state, modes, pairs, balls, physics):
    """Put the balls of a shot on the table, at time 0."""
    n = balls.shape[0]
    for i in range(n):
        state[col.TIME, i] = 0.0
        for column in range(col.IN_WZ + 1):
            state[col.X + column, i] = balls[i, column]
        state[col.RADIUS, i] = balls[i, col.IN_RADIUS]
        state[col.MASS, i] = balls[i, col.IN_MASS]
        state[col.INVERSE_MASS, i] = 1.0 / balls[i, col.IN_MASS]
        state[col.CLEAR, i] = balls[i, col.IN_CLEAR]
        state[col.RAIL_TIME, i] = -1.0
        state[col.PAIR_TIME, i] = col.NEVER
        modes[col.PARTNER, i] = -1
        modes[col.RAIL_COUNT, i] = 0
        enter_phase(state, modes, i, int(balls[i, col.IN_MOTION]), physics)
        for j in range(n):
            pairs[col.MEET, i, j] = col.NEVER
            pairs[col.MET, i, j] = -1.0
            pairs[col.REPEATS, i, j] = 0.0


@inner_kernel(inline="always")
def soonest_ball(state):
    """The ball whose next event comes first, the lowest number of several."""
    first = 0
    least = state[col.NEXT_TIME, 0]
    for i in range(1, state.shape[1]):
        time = state[col.NEXT_TIME, i]
        first = i if time < least else first
        least = min(time, least)
    return first


@inner_kernel(forceinline=True)
def happen_to_ball(state, modes, i, elements, physics):
    """Carry out what ball i planned of its own. Returns the event, and whether the ball is stuck."""
    event = modes[col.OWN_EVENT, i]
    if event == col.NO_EVENT:
        return end_phase(state, modes, i, physics), False
    advance(state, modes, i, state[col.OWN_TIME, i], physics)
    stuck = False
    if event == col.BALL_POCKET:
        for row in range(col.VX, col.WZ + 1):
            state[row, i] = 0.0
        enter_phase(state, modes, i, col.POCKETED, physics)
    else:
        cushions, jaws = elements.cushions, elements.jaws
        stuck = hit_rail(state, modes, i, event, modes[col.OWN_ELEMENT, i], cushions, jaws, physics)
        enter_phase(state, modes, i, col.SLIDING, physics)
    return event, stuck


@inner_kernel(inline="always")
def plan_changed(arrays, changed, starts, elements, physics, segments, segment):
    """Plan the first balls of row MEMBER again, each of which begins a segment. Returns their end.

    starts: the shot does, so all balls are planned for the first time.
    """
    state, modes, pairs = arrays.state, arrays.modes, arrays.pairs
    cushions, jaws, pockets = elements
    for q in range(changed):
        i = modes[col.MEMBER, q]
        if segments.shape[0] > 0:
            record_ball(segments, segment, state, modes, i, physics)
            segment += 1
        plan_ball(state, modes, i, cushions, jaws, pockets, physics)
    for q in range(changed):
        i = modes[col.MEMBER, q]
        if starts and lies_apart(state, modes, i):
            # what moves looks at this ball, and nothing that lies still need do so
            state[col.NEXT_TIME, i] = min(state[col.PAIR_TIME, i], state[col.OWN_TIME, i])
            continue
        refresh_pairs(state, modes, pairs, i)
        modes[col.MARK, i] = RENEWED
    for q in range(changed):
        modes[col.MARK, modes[col.MEMBER, q]] = 0
    return segment


@inner_kernel(inline="always")
def play_shot(arrays, elements, physics, until, max_events, events, segments, row, segment):
    """Play one shot whose balls are placed. Returns status, end of events, end of segments, end time."""
    state, modes, ends = arrays.state, arrays.modes, arrays.cluster.ends
    cushions, jaws = elements.cushions, elements.jaws
    n = state.shape[1]
    last_row = row + max_events
    end_time = 0.0
    changed = n
    starts = True
    status = col.FINISHED
    for i in range(n):
        modes[col.MEMBER, i] = i
    while True:
        if row + ends.shape[1] > events.shape[0] or (
            segments.shape[0] > 0 and segment + n > segments.shape[0]
        ):
            status = col.BUFFER_FULL
            break
        segment = plan_changed(arrays, changed, starts, elements, physics, segments, segment)
        starts = False
        i = soonest_ball(state)
        now = state[col.NEXT_TIME, i]
        if not (now < col.AT_REST and now <= until):
            end_time = until if now < col.AT_REST else end_time
            break
        if row >= last_row:
            status = col.EVENT_LIMIT
            break
        end_time = now
        if not state[col.PAIR_TIME, i] < state[col.OWN_TIME, i]:
            event, stuck = happen_to_ball(state, modes, i, elements, physics)
            record_event(events, row, now, event, i, modes[col.OWN_ELEMENT, i])
            row += 1
            modes[col.MEMBER, 0] = i
            changed = 1
            if stuck:
                changed = settle_group(state, modes, i, now, cushions, jaws, physics)
            continue
        written, changed, stuck_ball = meet(arrays, i, modes[col.PARTNER, i], now, physics)
        for m in range(written):
            i = ends[col.FIRST, m]
            j = ends[col.SECOND, m]
            record_event(events, row, now, col.BALL_BALL, min(i, j), max(i, j))
            row += 1
        if stuck_ball >= 0:
            changed = settle_group(state, modes, stuck_ball, now, cushions, jaws, physics)
    return status, row, segment, end_time


@inner_kernel(inline="always")
def write_final(state, modes, end_time, final, physics):
    """Bring all balls to the end and write them. Returns False if a number is not finite."""
    total = 0.0
    middle_x = physics[col.MIDDLE_X]
    middle_y = physics[col.MIDDLE_Y]
    for i in range(final.shape[0]):
        if modes[col.MOTION, i] != col.POCKETED:
            advance(state, modes, i, end_time, physics)
        for column in range(col.IN_WZ + 1):
            final[i, column] = state[col.X + column, i]
            total += abs(final[i, column])
        final[i, col.IN_X] += middle_x
        final[i, col.IN_Y] += middle_y
        final[i, col.IN_RADIUS] = state[col.RADIUS, i]
        final[i, col.IN_MASS] = state[col.MASS, i]
        final[i, col.IN_MOTION] = modes[col.MOTION, i]
        final[i, col.IN_CLEAR] = state[col.CLEAR, i]
    return total < col.NEVER


@lean_kernel
def play_shots(
    floats,
    integers,
    balls,
    constants,
    elements,
    ranges,
    events,
    segments,
    ends,
    final,
    first,
    until,
    max_events,
):
    """Play shots from number `first` on until the log is full, each at most to the time `until` (s).

    floats, integers: a `Workspace`. balls to ranges: a `Batch`. events to final: a `Log`. They come one by
    one, as three tuples would take longer to pass than a short shot to play. Returns the number of the first
    shot that was not played.
    """
    shots = constants.shape[0]
    arrays = view_workspace(floats, integers, balls.shape[1])
    row = 0
    segment = 0
    for s in range(first, shots):
        physics = constants[s]
        table = Elements(
            elements[ranges[s, 0] : ranges[s, 1]],
            elements[ranges[s, 1] : ranges[s, 2]],
            elements[ranges[s, 2] : ranges[s, 3]],
        )
        place_balls(arrays.state, arrays.modes, arrays.pairs, balls[s], physics)
        status, row_end, segment_end, end_time = play_shot(
            arrays, table, physics, until, max_events, events, segments, row, segment
        )
        if status == col.BUFFER_FULL:
            return s
        if not write_final(arrays.state, arrays.modes, end_time, final[s], physics):
            status = col.NOT_FINITE
        ends[s, col.EVENTS_START] = row
        ends[s, col.EVENTS_END] = row_end
        ends[s, col.SEGMENTS_START] = segment
        ends[s, col.SEGMENTS_END] = segment_end
        ends[s, col.STATUS] = status
        ends[s, col.END_TIME] = end_time
        row = row_end
        segment = segment_end
    return shots
