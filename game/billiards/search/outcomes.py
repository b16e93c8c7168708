"""What came of many shots, as arrays: the referee's summary of each, in a kernel.

The twin of `game.billiards.game.summary`, for searching. Chains are kept as sets of balls, and a ball that
lay against a cushion counts as driven to it when it touches it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.laws import state as col
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.shot.crossing import stays_short

# columns of facts (m, 7): rows of the balls that the cue ball touched first, as bits; 1 if it went down; 1
# if any ball touched a cushion after the first contact; rows of the balls that went down, as bits; 1 if the
# shot was given up; cushions that the cue ball touched before the first contact; 1 if the first ball lay
# behind the board's line, which the cue ball had not crossed before
FIRST_BALLS, SCRATCH, CUSHIONED, DOWN, GIVEN_UP, CUSHIONS_FIRST, SHORT = range(7)
FACTS = 7
NO_LINE = -np.inf  # m; a line from which no cue ball is played

# columns of histories (m, n, 4), for each ball: the pocket it went into (-1: none), balls that sent it on
# (with itself and the cue ball, as bits), contacts with balls and with cushions until it went down
POCKET, CHAIN, CONTACTS, CUSHIONS = range(4)
HISTORY_COLUMNS = 4

NOWHERE = -1e3  # m; place of a ball that went down


class Outcomes(NamedTuple):
    """What came of m strokes at n balls: facts (m, 7), histories (m, n, 4), places (m, n, 2) m at the end."""

    facts: NDArray[np.int64]
    histories: NDArray[np.int64]
    places: NDArray[np.float64]

    @classmethod
    def empty(cls, m: int, n: int) -> Outcomes:
        """Arrays for m strokes at n balls, not yet written."""
        return cls(
            np.empty((m, FACTS), np.int64), np.empty((m, n, HISTORY_COLUMNS), np.int64), np.empty((m, n, 2))
        )

    def rows(self, chosen: NDArray[np.intp] | slice) -> Outcomes:
        """Some of the strokes, by their rows (k,) or a slice."""
        return Outcomes(self.facts[chosen], self.histories[chosen], self.places[chosen])


@inner_kernel(inline="always")
def _send(histories, cue, i, j):
    """Ball i, moving, sends ball j on."""
    chain = histories[i, CHAIN]
    if j != cue and chain & (1 << j) == 0:
        histories[j, CHAIN] = chain | (1 << j)


@inner_kernel
def _meet(histories, moving, cue, i, j):
    """Balls i and j meet; returns the bits of those that move after it."""
    i_moves = moving & (1 << i) != 0
    j_moves = moving & (1 << j) != 0
    before = histories[i, CHAIN]
    if j_moves:
        _send(histories, cue, j, i)
    if i_moves:
        after = histories[i, CHAIN]
        histories[i, CHAIN] = before
        _send(histories, cue, i, j)
        histories[i, CHAIN] = after
    histories[i, CONTACTS] += 1
    histories[j, CONTACTS] += 1
    return moving | (1 << i) | (1 << j)


@inner_kernel
def _meet_at_once(events, start, end, histories, moving, cue):
    """Contacts of one moment, rows start to end: from the balls that move on to those that they send.

    Contacts that are done are marked by a negative type.
    """
    left = end - start
    while left > 0:
        chosen = -1
        for row in range(start, end):
            if events[row, 1] >= 0.0:
                if chosen < 0:
                    chosen = row
                pair = (1 << int(events[row, 2])) | (1 << int(events[row, 3]))
                if moving & pair != 0:
                    chosen = row
                    break
        moving = _meet(histories, moving, cue, int(events[chosen, 2]), int(events[chosen, 3]))
        events[chosen, 1] = -1.0
        left -= 1
    return moving


@inner_kernel
def _follow_shot(events, start, end, cue, facts, histories):
    """Go through one shot's events; writes facts (7,) and histories (n, 4). Returns the row of the event in
    which the cue ball met its first ball, -1 if it met none.
    """
    moving = 1 << cue
    first = -1
    row = start
    while row < end:
        event = int(events[row, 1])
        i = int(events[row, 2])
        if event == col.BALL_BALL:
            last = row + 1
            while last < end and events[last, 0] == events[row, 0] and events[last, 1] == col.BALL_BALL:
                last += 1
            new = facts[FIRST_BALLS] == 0
            for k in range(row, last):
                a = int(events[k, 2])
                b = int(events[k, 3])
                if new and (a == cue or b == cue):
                    if first < 0:
                        first = k
                    facts[FIRST_BALLS] |= 1 << (b if a == cue else a)
            moving = _meet_at_once(events, row, last, histories, moving, cue)
            row = last
            continue
        if event in (col.BALL_CUSHION, col.BALL_JAW):
            histories[i, CUSHIONS] += 1
            if facts[FIRST_BALLS] != 0:
                facts[CUSHIONED] = 1
            elif i == cue:
                facts[CUSHIONS_FIRST] += 1
        elif event == col.BALL_POCKET:
            moving &= ~(1 << i)
            histories[i, POCKET] = int(events[row, 3])
            if i == cue:
                facts[SCRATCH] = 1
            else:
                facts[DOWN] |= 1 << i
        elif event == col.BALL_OFF:
            moving &= ~(1 << i)
            facts[SCRATCH] = 1  # as bad: the cue ball in hand for the other
        elif event in (col.ROLLING_STATIONARY, col.ROLLING_SPINNING, col.SPINNING_STATIONARY):
            moving &= ~(1 << i)
        row += 1
    return first


@lean_kernel
def sum_up(log, cue, line, first, last, outcomes):
    """Sum up shots `first` to `last` of a log into the outcomes (m).

    log: a `batch.Log`; types of contacts are overwritten. line: m, behind which no ball may be met first,
    NO_LINE without one; only with a line are segments looked at.
    """
    events = log.events
    ends = log.ends
    final = log.final
    facts = outcomes.facts
    histories = outcomes.histories
    places = outcomes.places
    n = final.shape[1]
    for s in range(first, last):
        for column in range(FACTS):
            facts[s, column] = 0
        for i in range(n):
            histories[s, i, POCKET] = -1
            histories[s, i, CHAIN] = 0
            histories[s, i, CONTACTS] = 0
            histories[s, i, CUSHIONS] = 0
        histories[s, cue, CHAIN] = 1 << cue
        if ends[s, col.STATUS] != col.FINISHED:
            facts[s, GIVEN_UP] = 1
        met = _follow_shot(
            events, int(ends[s, col.EVENTS_START]), int(ends[s, col.EVENTS_END]), cue, facts[s], histories[s]
        )
        if met >= 0 and line > NO_LINE:
            ball = int(events[met, 2]) + int(events[met, 3]) - cue
            begin, stop = int(ends[s, col.SEGMENTS_START]), int(ends[s, col.SEGMENTS_END])
            if stays_short(log.segments, begin, stop, cue, ball, events[met, 0], line):
                facts[s, SHORT] = 1
        for i in range(n):
            down = final[s, i, col.IN_MOTION] == col.POCKETED or final[s, i, col.IN_MOTION] == col.OFF_TABLE
            places[s, i, 0] = NOWHERE if down else final[s, i, col.IN_X]
            places[s, i, 1] = NOWHERE if down else final[s, i, col.IN_Y]


@inner_kernel(inline="always")
def is_foul(facts, first):
    """True if a stroke breaks the rules of contact: see `game.billiards.game.rules.common_fouls`. first: bits
    of the balls that may be touched first.
    """
    return (
        facts[GIVEN_UP] != 0
        or facts[SCRATCH] != 0
        or facts[FIRST_BALLS] & first == 0
        or facts[SHORT] != 0
        or (facts[DOWN] == 0 and facts[CUSHIONED] == 0)
    )


@lean_kernel
def find_fouls(facts, first, barred, fouls):
    """Mark the strokes (m,) that are a foul, or in which one of the barred balls (bits) goes down."""
    for s in range(facts.shape[0]):
        fouls[s] = is_foul(facts[s], first) or facts[s, DOWN] & barred != 0
