"""How far a computed shot is from its track: the kernel that the fit asks.

A stroke is five numbers: the direction in which the ball leaves (rad from the x axis), and its speed (m/s).
Then the offset of the tip to the left and up (ball radii, cue level). Last comes the time when it leaves on
the track's clock (s). Velocity and spin are those of `game.billiards.shot.cue.strike` without squirt.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.exact.play import place_balls, play_shot
from game.billiards.laws import state as col
from game.billiards.laws.batch import Elements, view_workspace, workspace
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.physics.kernels import elementary

DIRECTION, SPEED, LEFT, UP, START = range(5)
STROKE_COLUMNS = 5
SQUARES, ROBUST, COUNT = range(3)  # columns of the sums of each ball
SUM_COLUMNS = 3

MAX_EVENTS = 600
ROOM_EVENTS = 1200
ROOM_SEGMENTS = 4000
LARGEST_TIP = 0.7  # ball radii; farther out a tip slips off. Strokes beyond it cost, so that none is chosen
EARLIEST, LATEST = 0.05, 0.02  # s; before and after the first sample that may have moved
UNPLAYABLE = 1e6


class Target(NamedTuple):
    """What a stroke is to explain. balls (n, 11): at rest, as the kernels read them, the struck one first.
    samples (s, 3): time s, x, y m in the table's frame; ranges (n, 2): rows of each ball."""

    balls: Floats
    samples: Floats
    ranges: NDArray[np.int64]


class Ground(NamedTuple):
    """The table: physics (20,), elements (4, 7), the cushions, about its middle."""

    physics: Floats
    elements: Floats


class Goal(NamedTuple):
    """How much counts: samples up to `horizon` s; distances above `sharp` m count as their logarithm."""

    horizon: float
    sharp: float


class Scratch(NamedTuple):
    """Space for one shot of n balls, and for a simplex."""

    floats: Floats
    integers: NDArray[np.int64]
    balls: Floats
    events: Floats
    segments: Floats
    simplex: Floats


def scratch_for(n: int) -> Scratch:
    """Scratch for shots of n balls."""
    space = workspace(n)
    return Scratch(
        space.floats,
        space.integers,
        np.zeros((n, col.IN_COLUMNS)),
        np.zeros((ROOM_EVENTS, 4)),
        np.zeros((ROOM_SEGMENTS, col.SEGMENT_COLUMNS)),
        np.zeros((STROKE_COLUMNS + 4, STROKE_COLUMNS + 1)),
    )


@inner_kernel
def strike_ball(balls, stroke):
    """Give the first ball the velocity and the spin of a stroke."""
    speed = stroke[SPEED]
    dx = elementary.cos(stroke[DIRECTION])
    dy = elementary.sin(stroke[DIRECTION])
    turn = 2.5 * speed / balls[0, col.IN_RADIUS]
    balls[0, col.IN_VX] = speed * dx
    balls[0, col.IN_VY] = speed * dy
    balls[0, col.IN_WX] = -turn * stroke[UP] * dy
    balls[0, col.IN_WY] = turn * stroke[UP] * dx
    balls[0, col.IN_WZ] = -turn * stroke[LEFT]
    balls[0, col.IN_MOTION] = col.SLIDING


@inner_kernel(inline="always")
def _next_of(segments, row, end, ball):
    """First row from `row` on that is a segment of that ball, or `end`."""
    while row < end and segments[row, col.SEG_BALL] != ball:
        row += 1
    return row


@inner_kernel
def compare_ball(target, segments, end, ball, start, goal, sums):
    """Sum up how far a ball is from its track: squares (m^2), their robust form, how many samples."""
    scale = goal.sharp * goal.sharp
    squares = 0.0
    robust = 0.0
    count = 0
    row = _next_of(segments, 0, end, ball)
    after = _next_of(segments, row + 1, end, ball)
    for s in range(target.ranges[ball, 0], target.ranges[ball, 1]):
        if target.samples[s, 0] > goal.horizon:
            break
        t = target.samples[s, 0] - start
        while after < end and segments[after, col.SEG_TIME] <= t:
            row = after
            after = _next_of(segments, row + 1, end, ball)
        e = max(t - segments[row, col.SEG_TIME], 0.0)
        x = segments[row, col.SEG_X] + e * (segments[row, col.SEG_VX] + e * segments[row, col.SEG_AX])
        y = segments[row, col.SEG_Y] + e * (segments[row, col.SEG_VY] + e * segments[row, col.SEG_AY])
        x -= target.samples[s, 1]
        y -= target.samples[s, 2]
        square = x * x + y * y
        squares += square
        robust += scale * elementary.log1p(square / scale)
        count += 1
    sums[ball, SQUARES] = squares
    sums[ball, ROBUST] = robust
    sums[ball, COUNT] = count


@inner_kernel(inline="always")
def _out_of_reach(target, stroke):
    """What a stroke costs, relative and absolute, for what no cue can do."""
    over = max(stroke[LEFT] * stroke[LEFT] + stroke[UP] * stroke[UP] - LARGEST_TIP * LARGEST_TIP, 0.0)
    seen = target.samples[target.ranges[0, 0] + 1, 0]
    early = max(seen - EARLIEST - stroke[START], 0.0)
    late = max(stroke[START] - seen - LATEST, 0.0)
    backwards = max(-stroke[SPEED], 0.0)
    return 1.0 + 10.0 * over, 10.0 * over + 1e3 * (early * early + late * late) + 1e3 * backwards


@inner_kernel
def track_error(target, scratch, ground, stroke, goal, sums):
    """Play a stroke and compare it with its track. sums (n, 3) are written; returns the cost.

    The cost is the sum of sharp^2 log(1 + r^2/sharp^2) over all samples r m off (Cauchy's loss), and more for
    strokes that no cue can make.
    """
    n = target.balls.shape[0]
    balls = scratch.balls
    for i in range(n):
        for column in range(col.IN_COLUMNS):
            balls[i, column] = target.balls[i, column]
    strike_ball(balls, stroke)
    arrays = view_workspace(scratch.floats, scratch.integers, n)
    cushions = ground.elements.shape[0]
    elements = Elements(ground.elements, ground.elements[cushions:], ground.elements[cushions:])
    place_balls(arrays.state, arrays.modes, arrays.pairs, balls, ground.physics)
    until = max(goal.horizon - stroke[START], 0.0)
    status, _, end, _ = play_shot(
        arrays, elements, ground.physics, until, MAX_EVENTS, scratch.events, scratch.segments, 0, 0
    )
    cost = 0.0
    for i in range(n):
        compare_ball(target, scratch.segments, end, i, stroke[START], goal, sums)
        cost += sums[i, ROBUST]
    times, plus = _out_of_reach(target, stroke)
    if status != col.FINISHED:
        plus += UNPLAYABLE
    return times * cost + plus


@lean_kernel
def errors_of(target, scratch, ground, strokes, goal, sums, costs):
    """`track_error` of strokes (k, 5): sums (k, n, 3), costs (k,)."""
    for k in range(strokes.shape[0]):
        costs[k] = track_error(target, scratch, ground, strokes[k], goal, sums[k])
