"""Bounds of boxes in motion: what a box covers until it is looked at again, if it goes on as it did.

A bound begins with the four sides of a box as they are, each with a rate (m a step). It holds for some steps
as long as no side is farther than a pad from where it was to be. What the box covers in that time lies
between its first and its last place. So the extent of the bound in any direction is known from these two.
When each bound is used up stands in a queue of events: a ring of lists, one for each coming step (a calendar
queue: Brown 1988).

A rate is taken from where a box was when its bound began. One that has left its bound early, by a bounce or a
leap, gets a bound that stays where it is. It is looked at again a step later.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, kernel

NOBODY = -1
RING = 256  # steps; a bound that would hold longer is looked at again then
NEVER = 1 << 62
HELD, NEW, LEFT, DUE = range(4)  # why a box gets a new bound, or that it does not
WAITS, TRUSTED, UNKNOWN = range(3)  # states of a bound's rate
LEAST_STEPS = 4  # that the bound of a box holds that goes farther in a step than its bound may grow
SHORT_LIFE = 8  # steps; a bound left sooner makes the next estimate of the rate take longer
MOST_PATIENCE = 5  # powers of two, steps
AGREE = 0.1  # share of a fast box's rate by which two estimates may differ
ROUNDING = 1e-12  # of coordinates, added to pads
LEVELS = 4  # of widths: up to 4, 16, 64 typical sizes, and the rest
MOST_STRIPS = 128
SCALES = 8
AXIS, GROWTH, PAD, TYPICAL, STAGGER, ORIGIN, HEIGHT, STRIPS = range(SCALES)


class Bounds(NamedTuple):
    """The arrays of all bounds by id, all written."""

    start: NDArray[np.float64]  # (capacity, 4) m, sides when the bound began
    rates: NDArray[np.float64]  # (capacity, 4) m a step
    guess: NDArray[np.float64]  # (capacity, 4) m a step: the last estimate that was not trusted, or nan
    spans: NDArray[np.float64]  # (capacity, 4) m: x0 y0 x1 y1 of the whole bound
    pads: NDArray[np.float64]  # (capacity, 2) m: a side may deviate by, and the bound is wider by
    begun: NDArray[np.int64]  # (capacity, 2) step in which it began, and in which it is used up
    links: NDArray[np.int32]  # (capacity, 2) after and before in the list of a step
    heads: NDArray[np.int32]  # (RING,)
    marks: NDArray[np.uint8]  # (capacity, 3): why it is new, state, patience
    lanes: NDArray[np.uint16]  # (capacity,) level of width, and strip in it
    aligned: NDArray[np.int8]  # (capacity,) number of the direction across its motion, or NOBODY


WHY, STATE, PATIENCE = range(3)


@inner_kernel
def holds(bounds, boxes, box, step):
    """Whether all sides of a box are where its bound says, up to the pad."""
    age = 1.0 * (step - bounds.begun[box, 0])
    pad, inside = bounds.pads[box, 0], True
    for side in range(4):
        there = bounds.start[box, side] + age * bounds.rates[box, side]
        now = boxes[box, side]
        inside &= (abs(now - there) <= pad) | (now == there)
    return inside


@inner_kernel
def unlink(bounds, box):
    """Take a box out of the queue of events."""
    if bounds.begun[box, 1] == NEVER:
        return
    after, before = bounds.links[box, 0], bounds.links[box, 1]
    if before >= 0:
        bounds.links[before, 0] = after
    else:
        bounds.heads[bounds.begun[box, 1] % RING] = after
    if after >= 0:
        bounds.links[after, 1] = before
    bounds.begun[box, 1] = NEVER


@inner_kernel
def enqueue(bounds, box, step):
    """Put a box into the list of a step, fewer than RING ahead."""
    head = bounds.heads[step % RING]
    bounds.links[box, 0], bounds.links[box, 1] = head, NOBODY
    if head >= 0:
        bounds.links[head, 1] = box
    bounds.heads[step % RING] = box
    bounds.begun[box, 1] = step


@kernel(_nrt=False)
def forget_bounds(bounds: Any, ids):
    """Boxes go, or come anew: they have no bound."""
    for box in ids:
        unlink(bounds, box)
        bounds.marks[box, WHY], bounds.marks[box, STATE], bounds.marks[box, PATIENCE] = NEW, UNKNOWN, 0


@kernel(_nrt=False)
def find_events(bounds: Any, boxes, alive, top, step, events):
    """List the boxes that are new, have left their bound, or whose bound is used up; returns their number."""
    marks = bounds.marks
    for box in range(top):
        if alive[box]:
            known = marks[box, STATE] != UNKNOWN
            marks[box, WHY] = NEW if not known else (HELD if holds(bounds, boxes, box, step) else LEFT)
    box = bounds.heads[step % RING]
    while box >= 0:
        marks[box, WHY] = DUE
        box = bounds.links[box, 0]
    count = 0
    for box in range(top):
        if alive[box] and marks[box, WHY] != HELD:
            events[count] = box
            count += 1
    return count


@inner_kernel
def _size(boxes, box, typical):
    """A box's size, or a quarter of the typical one if that is more; infinite sides do not count."""
    width, height = boxes[box, 2] - boxes[box, 0], boxes[box, 3] - boxes[box, 1]
    size = 0.5 * ((width if width < np.inf else 0.0) + (height if height < np.inf else 0.0))
    return max(size, 0.25 * typical)


@inner_kernel
def _estimate(bounds, boxes, box, step, size):
    """Write the rate of each side since the bound began; whether it can be trusted, and the fastest.

    A slow box is trusted at once, a fast one when two estimates agree. ``guess`` becomes the estimate.
    """
    age = max(1.0 * (step - bounds.begun[box, 0]), 1.0)
    fastest, apart = 0.0, 0.0
    for side in range(4):
        rate = (boxes[box, side] - bounds.start[box, side]) / age
        if not abs(rate) < 1e300:
            rate = 0.0
        fastest = max(fastest, abs(rate))
        off = abs(rate - bounds.guess[box, side])
        apart = max(apart, off) if off < np.inf else np.inf
        bounds.rates[box, side], bounds.guess[box, side] = rate, rate
    return fastest <= size or apart <= AGREE * fastest, fastest


@inner_kernel
def _judge(bounds, boxes, box, step, size):
    """Give a box its rates; returns the fastest, m a step, or -1, and rates of 0, while none is trusted."""
    why, state = bounds.marks[box, WHY], bounds.marks[box, STATE]
    short = step - bounds.begun[box, 0] < SHORT_LIFE
    trusted, fastest = False, 0.0
    if state != UNKNOWN and not (state == TRUSTED and why == LEFT):
        trusted, fastest = _estimate(bounds, boxes, box, step, size)
        trusted |= state == TRUSTED
    else:
        for side in range(4):
            bounds.guess[box, side] = np.nan
    patience = bounds.marks[box, PATIENCE]
    if why == LEFT and short:
        patience = min(patience + 1, MOST_PATIENCE)
    elif patience > 0:
        patience -= 1
    bounds.marks[box, PATIENCE] = patience
    bounds.marks[box, STATE] = TRUSTED if trusted else WAITS
    if trusted:
        return fastest
    for side in range(4):
        bounds.rates[box, side] = 0.0
    return -1.0


@inner_kernel
def _steps_of(bounds, box, fastest, size, scales):
    """Steps that a bound is to hold: until it has grown by its share, or until the next estimate."""
    if fastest < 0.0:
        return 1 << int(bounds.marks[box, PATIENCE])  # uncompiled, 8 bits would stay 8 bits
    if fastest == 0.0:
        return NEVER
    steps = min(max(scales[GROWTH] * size / fastest, LEAST_STEPS), RING - 1.0)
    if scales[STAGGER] > 0.0:  # bounds that begin together are not to end together
        steps *= 0.5 + 0.5 * ((box * 0.6180339887498949) % 1.0)
    return max(int(steps), 1)


@inner_kernel
def _align(rates, directions):
    """Number of the direction most nearly across a motion; NOBODY if an axis is, which is kept anyway."""
    x, y = rates[0] + rates[2], rates[1] + rates[3]
    best, least = NOBODY, min(abs(x), abs(y))
    for number in range(len(directions)):
        along = abs(directions[number, 0] * x + directions[number, 1] * y)
        if along < least:
            best, least = number, along
    return best


@inner_kernel
def strip_of(value, scales):
    """Number of the strip in which a bound stands that begins there."""
    return int(min(max((value - scales[ORIGIN]) / scales[HEIGHT], 0.0), scales[STRIPS] - 1.0))


@inner_kernel
def _lane(bounds, box, scales):
    """The lane of the order where a bound stands: strips of the narrow ones first."""
    axis = int(scales[AXIS])
    width = max(bounds.spans[box, 2] - bounds.spans[box, 0], bounds.spans[box, 3] - bounds.spans[box, 1])
    level, most = 0, 4.0 * scales[TYPICAL]
    while level < LEVELS - 1 and not width <= most:
        level, most = level + 1, 4.0 * most
    return level * int(scales[STRIPS]) + strip_of(bounds.spans[box, 1 - axis], scales)


@kernel(_nrt=False)
def begin_bounds(bounds: Any, boxes, step, events, directions, scales):
    """Begin a bound for each of some boxes. ``directions``: (d, 2). ``scales``: (SCALES,)."""
    for box in events:
        unlink(bounds, box)
        size = _size(boxes, box, scales[TYPICAL])
        fastest = _judge(bounds, boxes, box, step, size)
        steps = _steps_of(bounds, box, fastest, size, scales)
        farthest, ahead = 0.0, 0.0 if steps == NEVER else 1.0 * steps
        for side in range(4):
            there = boxes[box, side] + ahead * bounds.rates[box, side]
            if abs(boxes[box, side]) < np.inf:
                farthest = max(farthest, abs(boxes[box, side]), abs(there))
        pad = scales[PAD] * size + ROUNDING * farthest
        if not farthest < 1e300:  # beyond that sums overflow: it is looked at in every step
            pad, farthest, steps = 0.0, 0.0, 1
            for side in range(4):
                bounds.rates[box, side] = 0.0
            ahead = 0.0
        wider = pad + ROUNDING * farthest
        bounds.pads[box, 0], bounds.pads[box, 1] = pad, wider
        for side in range(4):
            now = boxes[box, side]
            there = now + ahead * bounds.rates[box, side]
            bounds.start[box, side] = now
            bounds.spans[box, side] = min(now, there) - wider if side < 2 else max(now, there) + wider
        bounds.begun[box, 0] = step
        bounds.aligned[box] = _align(bounds.rates[box], directions) if fastest > 0.0 else NOBODY
        bounds.lanes[box] = _lane(bounds, box, scales)
        if steps != NEVER:
            enqueue(bounds, box, step + steps)


@inner_kernel
def ahead_of(bounds, box):
    """Steps from the first to the last place of a bound; its rates are 0 where it never ends."""
    end = bounds.begun[box, 1]
    return 0.0 if end == NEVER else 1.0 * (end - bounds.begun[box, 0])


@inner_kernel
def extent_along(bounds, box, x, y):
    """Least and greatest of x X + y Y over a bound."""
    start, rates = bounds.start[box], bounds.rates[box]
    left, right = (0, 2) if x >= 0.0 else (2, 0)
    low, high = (1, 3) if y >= 0.0 else (3, 1)
    ahead = ahead_of(bounds, box)
    wider = bounds.pads[box, 1] * (abs(x) + abs(y))
    least, greatest = x * start[left] + y * start[low], x * start[right] + y * start[high]
    least_change = min(ahead * (x * rates[left] + y * rates[low]), 0.0)
    greatest_change = max(ahead * (x * rates[right] + y * rates[high]), 0.0)
    return least + least_change - wider, greatest + greatest_change + wider


@inner_kernel
def apart_along(bounds, a, b, x, y):
    """Whether two bounds have no value of x X + y Y in common."""
    low, high = extent_along(bounds, a, x, y)
    lower, higher = extent_along(bounds, b, x, y)
    return high < lower or higher < low


@kernel(_nrt=False)
def write_extents(bounds: Any, ids, directions, out):
    """Extents of bounds along directions (d, 2), into ``out`` (n, d, 2) m."""
    for i in range(len(ids)):
        for number in range(len(directions)):
            low, high = extent_along(bounds, ids[i], directions[number, 0], directions[number, 1])
            out[i, number, 0], out[i, number, 1] = low, high
