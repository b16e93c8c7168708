"""What the cue ball of many strokes at carom touched, in order, as one number each; read off in a kernel.

The twin of `game.billiards.game.carom_summary` for searching. Rows of the balls: the cue ball, the other cue
ball, the red one.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.laws import state as col
from game.billiards.laws.lean import lean_kernel
from game.billiards.search.strokes import CHUNK, Board, in_threads
from game.billiards.table.balk import Zone

OTHER, RED = 1, 2  # rows of the object balls
# a route is written in digits of base 8, the first touch in the highest: 1 to 4 for the rails left, right,
# lower, upper, then the balls; a ball that is touched several times with nothing between is written once
BALL_DIGIT = 4  # of a ball is this and its row
RAILS = 4  # bits of what the cue ball touches: first the rails, then the balls by row
DIGITS = 20  # that are kept of a route

# columns of facts (m, 4): cushions before the second object ball (-1: not both touched), row of the ball that
# was touched first (0: none) if no cushion came before it (else negative), how often balls met that need not
# have (kisses), 1 if the cue ball was played into a ball that it lay against
CUSHIONS, FIRST, KISSES, INTO = range(4)
FACTS = 4


class Routes(NamedTuple):
    """Of m strokes: codes (m,), facts (m, 4), times (m,) s of the second object ball's touch, ends (m, 3,
    2) m of the balls by row. A route that touched both ends with the second one; its code is 0 else.
    """

    codes: NDArray[np.int64]
    facts: NDArray[np.int64]
    times: Floats
    ends: Floats

    @classmethod
    def empty(cls, m: int) -> Routes:
        """Arrays for m strokes, not yet written."""
        return cls(np.empty(m, np.int64), np.empty((m, FACTS), np.int64), np.empty(m), np.empty((m, 3, 2)))


class Wanted(NamedTuple):
    """What scores: so many cushions before the second ball; opening: the red ball first, directly.

    leave: zones in which both object balls lie, and of which one of them must come out to stay. code: of the
    only route that scores, 0 for any.
    """

    cushions: int
    opening: bool = False
    leave: tuple[Zone, ...] = ()
    code: int = 0

    def scores(self, routes: Routes) -> NDArray[np.bool_]:
        """Which of m strokes make a point (m,)."""
        facts = routes.facts
        good = (facts[:, CUSHIONS] >= self.cushions) & (facts[:, INTO] == 0)
        if self.code:
            good &= routes.codes == self.code
        for zone in self.leave:
            good &= ~(zone.holds(routes.ends[:, OTHER]) & zone.holds(routes.ends[:, RED]))
        return good & (facts[:, FIRST] == RED) if self.opening else good


@lean_kernel
def read_routes(events, ends, final, against, codes, facts, times, places):
    """Read off the shots whose ends are given, see `Routes`. against: what the cue ball touches, as bits."""
    for s in range(ends.shape[0]):
        code = 0
        digits = 0
        cushions = 0
        touched = 0
        lying = against
        facts[s, CUSHIONS] = -1
        facts[s, FIRST] = 0
        facts[s, KISSES] = 0
        facts[s, INTO] = 0
        times[s] = -1.0
        for row in range(int(ends[s, col.EVENTS_START]), int(ends[s, col.EVENTS_END])):
            event = int(events[row, 1])
            i = int(events[row, 2])
            j = int(events[row, 3])
            digit = 0
            if event == col.BALL_BALL and i == 0:
                digit = BALL_DIGIT + j
                if touched == 0:
                    facts[s, FIRST] = j if digits == 0 else -j
                if touched & (1 << j) != 0:
                    facts[s, KISSES] += 1
                if digits == 0 and against & (1 << (RAILS + j)) != 0:
                    facts[s, INTO] = 1
                touched |= 1 << j
            elif event == col.BALL_BALL:
                facts[s, KISSES] += 1
            elif event == col.BALL_CUSHION and i == 0:
                if digits == 0 and lying & (1 << j) != 0:
                    lying = 0
                else:
                    digit = 1 + j
                    cushions += 1
            repeated = digit > BALL_DIGIT and code % 8 == digit
            if digit > 0 and digits < DIGITS and not repeated:
                code = 8 * code + digit
                digits += 1
            if touched == 6:
                facts[s, CUSHIONS] = cushions if ends[s, col.STATUS] == col.FINISHED else -1
                times[s] = events[row, 0]
                break
        codes[s] = code if touched == 6 else 0
        for k in range(3):
            places[s, k, 0] = final[s, k, col.IN_X]
            places[s, k, 1] = final[s, k, col.IN_Y]


def play_routes(
    board: Board, strokes: Floats, against: int = 0, pool: ThreadPoolExecutor | None = None
) -> Routes:
    """Play strokes (m, 5) at a board of three balls whose cue ball is the first. against: what it
    touches, as bits. pool: threads to share them among."""
    routes = Routes.empty(len(strokes))

    def play(start: int) -> None:
        chunk = strokes[start : start + CHUNK]
        parts = [column[start : start + len(chunk)] for column in routes]
        for log, first, end in board.played(chunk):
            rows = (column[first:end] for column in parts)
            read_routes(log.events, log.ends[first:end], log.final[first:end], against, *rows)

    in_threads(pool, play, range(0, len(strokes), CHUNK))
    return routes


def touches(code: int) -> tuple[int, ...]:
    """Digits of a route in order: rails 1 to 4, balls BALL_DIGIT and their row."""
    digits = []
    while code > 0:
        digits.append(code % 8)
        code //= 8
    return tuple(reversed(digits))
