"""The exact table with balls that leave the slate: `exact.play`, from event to event, a batch in one kernel.

A kernel of its own, so that shots without a hop pay nothing: which of the two plays a shot is chosen in
`simulation`. What lies on the slate goes through the same functions as there. A shot without a hop comes out
the same to the last bit. Balls have two more columns (IN_Z, IN_VZ), segments two more (SEG_Z, SEG_VZ).

A ball may come to rest on top of a rail, or wedged between balls and rails (MOST_CONTACTS without touching
the slate). It does not rest on the bed: it counts as off the table (WPA 2016, 6.5 and 8.5).
"""

from __future__ import annotations

from game.billiards.exact.elements import plan_ball
from game.billiards.exact.meeting import meet
from game.billiards.exact.play import place_balls, record_event, soonest_ball
from game.billiards.exact.settling import settle_group
from game.billiards.flight.air import advance_anywhere, enter_air_or_slate
from game.billiards.flight.collision import meet_in_air
from game.billiards.flight.nose import hit_nose, hop_of
from game.billiards.flight.pairs import refresh_everywhere
from game.billiards.flight.plans import plan_flight
from game.billiards.flight.slate import bounce_on_level
from game.billiards.laws import state as col
from game.billiards.laws.batch import Elements, view_workspace
from game.billiards.laws.impacts import hit_rail
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.laws.motion import end_phase, enter_phase

MOST_CONTACTS = 1000  # of a ball in the air in a row, none with the slate
LOST = -1  # in AIR_COUNT: the ball has left the table; it is POCKETED for all that asks who is still there


@inner_kernel
def _motion_of(modes, i):
    """The motion of ball i as it is written down."""
    return col.OFF_TABLE if modes[col.AIR_COUNT, i] == LOST else modes[col.MOTION, i]


@inner_kernel
def _record(segments, row, state, modes, i, physics):
    """Write the segment that ball i now begins."""
    for column in range(col.SEG_BALL):
        segments[row, column] = state[col.TIME + column, i]
    segments[row, col.SEG_X] += physics[col.MIDDLE_X]
    segments[row, col.SEG_Y] += physics[col.MIDDLE_Y]
    segments[row, col.SEG_BALL] = i
    segments[row, col.SEG_MOTION] = _motion_of(modes, i)
    segments[row, col.SEG_Z] = state[col.Z, i]
    segments[row, col.SEG_VZ] = state[col.VZ, i]


@inner_kernel
def _take_away(state, modes, i, event, physics):
    """Ball i is gone: into a pocket, or off the table."""
    for row in range(col.VX, col.WZ + 1):
        state[row, i] = 0.0
    state[col.Z, i] = 0.0
    state[col.VZ, i] = 0.0
    enter_phase(state, modes, i, col.POCKETED, physics)
    modes[col.AIR_COUNT, i] = LOST if event == col.BALL_OFF else 0


@inner_kernel
def _come_down(state, modes, i, event, physics):
    """Ball i bounces on the slate or on top of a rail. Returns the event; BALL_OFF if it stays there."""
    state[col.Z, i] = physics[col.CUSHION_HEIGHT] if event == col.BALL_RAIL_TOP else 0.0
    bounce_on_level(state, i, physics)
    if event == col.BALL_RAIL_TOP and state[col.VZ, i] == 0.0:
        _take_away(state, modes, i, col.BALL_OFF, physics)
        return col.BALL_OFF
    enter_air_or_slate(state, modes, i, physics)
    return event


@inner_kernel
def _happen(state, modes, i, elements, physics):
    """Carry out what ball i planned of its own. Returns the event, and whether the ball is stuck."""
    event = modes[col.OWN_EVENT, i]
    if event == col.NO_EVENT:
        return end_phase(state, modes, i, physics), False
    flies = modes[col.MOTION, i] == col.AIRBORNE
    advance_anywhere(state, modes, i, state[col.OWN_TIME, i], physics)
    if event in (col.BALL_POCKET, col.BALL_OFF):
        _take_away(state, modes, i, event, physics)
        return event, False
    if event in (col.BALL_SLATE, col.BALL_RAIL_TOP):
        return _come_down(state, modes, i, event, physics), False
    element = modes[col.OWN_ELEMENT, i]
    if flies:
        modes[col.AIR_COUNT, i] += 1
        hit_nose(state, modes, i, event, element, elements.cushions, elements.jaws, physics)
        return event, False
    hop = hop_of(state, i, event, element, elements.cushions, elements.jaws, physics)
    stuck = hit_rail(state, modes, i, event, element, elements.cushions, elements.jaws, physics)
    state[col.VZ, i] = hop
    enter_air_or_slate(state, modes, i, physics)
    return event, stuck


@inner_kernel
def _plan_changed(arrays, changed, elements, physics, segments, segment):
    """Plan the first balls of row MEMBER again, each of which begins a segment. Returns their end."""
    state, modes, pairs = arrays.state, arrays.modes, arrays.pairs
    cushions, jaws, pockets = elements
    for q in range(changed):
        i = modes[col.MEMBER, q]
        if segments.shape[0] > 0:
            _record(segments, segment, state, modes, i, physics)
            segment += 1
        if modes[col.MOTION, i] == col.AIRBORNE:
            plan_flight(state, modes, i, elements, physics)
        else:
            plan_ball(state, modes, i, cushions, jaws, pockets, physics)
    for q in range(changed):
        refresh_everywhere(state, modes, pairs, modes[col.MEMBER, q], physics)
    return segment


@inner_kernel
def _meet(arrays, i, j, now, physics):
    """As `meeting.meet`, for balls anywhere. Returns contacts, changed balls, and one that is stuck or -1."""
    state, modes, ends = arrays.state, arrays.modes, arrays.cluster.ends
    if modes[col.MOTION, i] != col.AIRBORNE and modes[col.MOTION, j] != col.AIRBORNE:
        return meet(arrays, i, j, now, physics)
    meet_in_air(state, modes, i, j, now, physics)
    ends[col.FIRST, 0] = i
    ends[col.SECOND, 0] = j
    return 1, 2, -1


@inner_kernel
def _remove_wedged(state, modes, changed, now, events, row, physics):
    """Take those of the first balls of row MEMBER away that find no end. Returns the next row of events."""
    for q in range(changed):
        i = modes[col.MEMBER, q]
        if modes[col.AIR_COUNT, i] > MOST_CONTACTS:
            _take_away(state, modes, i, col.BALL_OFF, physics)
            record_event(events, row, now, col.BALL_OFF, i, -1)
            row += 1
    return row


@inner_kernel
def _place(arrays, balls, physics, events, row):
    """Put the balls on the table at time 0; what is pressed onto the slate bounces. Returns the next row."""
    state, modes = arrays.state, arrays.modes
    place_balls(state, modes, arrays.pairs, balls, physics)
    for i in range(balls.shape[0]):
        state[col.Z, i] = balls[i, col.IN_Z]
        state[col.VZ, i] = balls[i, col.IN_VZ]
        modes[col.AIR_COUNT, i] = LOST if modes[col.MOTION, i] == col.OFF_TABLE else 0
        if modes[col.MOTION, i] == col.OFF_TABLE:
            modes[col.MOTION, i] = col.POCKETED
        if modes[col.MOTION, i] == col.POCKETED or (state[col.Z, i] == 0.0 and state[col.VZ, i] == 0.0):
            continue
        if state[col.Z, i] == 0.0 and state[col.VZ, i] < 0.0:
            bounce_on_level(state, i, physics)
            record_event(events, row, 0.0, col.BALL_SLATE, i, -1)
            row += 1
        enter_air_or_slate(state, modes, i, physics)
    return row


@inner_kernel
def _play(arrays, elements, physics, until, last_row, events, segments, row, segment):
    """Play one shot whose balls are placed. Returns status, end of events, end of segments, end time."""
    state, modes, ends = arrays.state, arrays.modes, arrays.cluster.ends
    n = state.shape[1]
    end_time = 0.0
    changed = n
    status = col.FINISHED
    for i in range(n):
        modes[col.MEMBER, i] = i
    while True:
        if row + ends.shape[1] + n > events.shape[0] or (
            segments.shape[0] > 0 and segment + n > segments.shape[0]
        ):
            status = col.BUFFER_FULL
            break
        segment = _plan_changed(arrays, changed, elements, physics, segments, segment)
        i = soonest_ball(state)
        now = state[col.NEXT_TIME, i]
        if not (now < col.AT_REST and now <= until):
            end_time = until if now < col.AT_REST else end_time
            break
        if row >= last_row:
            status = col.EVENT_LIMIT
            break
        end_time = now
        stuck_ball = -1
        if not state[col.PAIR_TIME, i] < state[col.OWN_TIME, i]:
            event, stuck = _happen(state, modes, i, elements, physics)
            record_event(events, row, now, event, i, modes[col.OWN_ELEMENT, i])
            row += 1
            modes[col.MEMBER, 0] = i
            changed = 1
            stuck_ball = i if stuck else -1
        else:
            written, changed, stuck_ball = _meet(arrays, i, modes[col.PARTNER, i], now, physics)
            for m in range(written):
                a = ends[col.FIRST, m]
                b = ends[col.SECOND, m]
                record_event(events, row, now, col.BALL_BALL, min(a, b), max(a, b))
                row += 1
        row = _remove_wedged(state, modes, changed, now, events, row, physics)
        if stuck_ball >= 0 and modes[col.MOTION, stuck_ball] != col.AIRBORNE:
            changed = settle_group(state, modes, stuck_ball, now, elements.cushions, elements.jaws, physics)
    return status, row, segment, end_time


@inner_kernel
def _write_final(state, modes, end_time, final, physics):
    """Bring all balls to the end and write them. Returns False if a number is not finite."""
    total = 0.0
    for i in range(final.shape[0]):
        if modes[col.MOTION, i] != col.POCKETED:
            advance_anywhere(state, modes, i, end_time, physics)
        for column in range(col.IN_WZ + 1):
            final[i, column] = state[col.X + column, i]
            total += abs(final[i, column])
        final[i, col.IN_X] += physics[col.MIDDLE_X]
        final[i, col.IN_Y] += physics[col.MIDDLE_Y]
        final[i, col.IN_RADIUS] = state[col.RADIUS, i]
        final[i, col.IN_MASS] = state[col.MASS, i]
        final[i, col.IN_MOTION] = _motion_of(modes, i)
        final[i, col.IN_CLEAR] = state[col.CLEAR, i]
        final[i, col.IN_Z] = state[col.Z, i]
        final[i, col.IN_VZ] = state[col.VZ, i]
        total += abs(state[col.Z, i]) + abs(state[col.VZ, i])
    return total < col.NEVER


@lean_kernel
def play_flying_shots(workspace, batch, log, first, until, max_events):
    """`exact.play.play_shots` for balls that leave the slate: balls and final (m, n, 13), segments (s, 14).

    Returns the number of the first shot that was not played.
    """
    balls, constants, elements, ranges = batch
    events, segments, ends, final = log
    shots = constants.shape[0]
    arrays = view_workspace(workspace.floats, workspace.integers, balls.shape[1])
    row = 0
    segment = 0
    for s in range(first, shots):
        physics = constants[s]
        table = Elements(
            elements[ranges[s, 0] : ranges[s, 1]],
            elements[ranges[s, 1] : ranges[s, 2]],
            elements[ranges[s, 2] : ranges[s, 3]],
        )
        if row + balls.shape[1] > events.shape[0]:
            return s
        row_end = _place(arrays, balls[s], physics, events, row)
        status, row_end, segment_end, end_time = _play(
            arrays, table, physics, until, row + max_events, events, segments, row_end, segment
        )
        if status == col.BUFFER_FULL:
            return s
        if not _write_final(arrays.state, arrays.modes, end_time, final[s], physics):
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
