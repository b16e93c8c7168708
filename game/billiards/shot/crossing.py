"""Whether the cue ball crosses a line across the table before it meets its first ball (WPA 6.11)."""

from __future__ import annotations

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel, lean_kernel


@inner_kernel(inline="always")
def _y_at(segment, time):
    """Where a ball is at a time of its segment (12,), along the table, m."""
    t = max(time - segment[s.SEG_TIME], 0.0)
    return segment[s.SEG_Y] + t * (segment[s.SEG_VY] + t * segment[s.SEG_AY])


@inner_kernel(inline="always")
def _highest(segment, end):
    """The largest y, m, on a segment (12,) up to a time, s: at an end of the parabola, or at its vertex."""
    highest = max(segment[s.SEG_Y], _y_at(segment, end))
    if segment[s.SEG_AY] < 0.0 and segment[s.SEG_VY] > 0.0:
        vertex = segment[s.SEG_TIME] - 0.5 * segment[s.SEG_VY] / segment[s.SEG_AY]
        if vertex < end:
            highest = max(highest, _y_at(segment, vertex))
    return highest


@inner_kernel
def stays_short(segments, first, last, cue, ball, time, line):
    """True if `ball` lies at y <= line (m) when the cue ball touches it at `time`, s, and the cue ball's
    middle has not been beyond that line before. segments (s, 12): rows `first` to `last` of the shot's.
    """
    target = -1
    for row in range(first, last):
        if segments[row, s.SEG_TIME] <= time and int(segments[row, s.SEG_BALL]) == ball:
            target = row
    if target < 0 or _y_at(segments[target], time) > line:
        return False
    before = -1
    for row in range(first, last):
        if int(segments[row, s.SEG_BALL]) != cue or segments[row, s.SEG_TIME] >= time:
            continue
        if before >= 0 and _highest(segments[before], segments[row, s.SEG_TIME]) > line:
            return False
        before = row
    return before < 0 or _highest(segments[before], time) <= line


@lean_kernel
def short_contact(segments, cue, ball, time, line):
    """`stays_short` for all segments (s, 12) of one shot."""
    return stays_short(segments, 0, segments.shape[0], cue, ball, time, line)
