"""Where to put a cue ball that is in hand: behind the balls that can be potted, at cuts and distances.

Many places are looked at quickly, the best of them again and closely.
"""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Arrangement, bed_for, nearest_free
from game.billiards.game.rules import CUE_BALL, Hand
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.search.lanes import openness, pocket_window, pot_chance
from game.billiards.search.looking import Effort, look
from game.billiards.search.outcomes import NOWHERE
from game.billiards.search.rating import BLOCKED, Aims
from game.billiards.search.strokes import Board, Noise, in_threads
from game.billiards.search.view import UNLIMITED, Clock, View
from game.billiards.shot.physics import Physics
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table
from game.physics.kernels import elementary

CUTS = np.radians([0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0])
# m; from the cue ball to where it meets the other. Behind the line most balls are farther away
DISTANCES = np.array([0.15, 0.3, 0.5])
DISTANCES_FROM_LINE = np.array([0.15, 0.3, 0.5, 0.8, 1.2, 1.7])
MOST_PLACES = 15 * 6 * len(CUTS) * len(DISTANCES_FROM_LINE)

# columns of places for the cue ball (c, 4): x, y m; row of the ball that it lies for; estimated chance
PLACE_X, PLACE_Y, PLACE_BALL, PLACE_CHANCE = range(4)


@inner_kernel
def _is_clear(places, geometry, x, y):
    """True if the cue ball overlaps no other at (x, y) m."""
    radii, cue = geometry.radii, geometry.cue
    for k in range(places.shape[0]):
        if k != cue:
            dx = places[k, 0] - x
            dy = places[k, 1] - y
            reach = radii[cue] + radii[k] + 1e-6
            if dx * dx + dy * dy < reach * reach:
                return False
    return True


@lean_kernel
def list_places(places, geometry, region, playable, needed, cuts, distances, open_chances, found):
    """Places for the cue ball to pot a ball from, to found (c, 4). Returns how many.

    places (n, 2) m, of which the cue ball's is written over. region (4,) m: where its centre may be put
    down: left, right, lower, upper; once struck it goes where it likes on the bed. playable, needed: balls
    to pot now, and in all (bits of their rows). cuts (a,) rad and distances (b,) m from which each is tried.
    open_chances (n,): scratch buffer.
    """
    radii, gates, _, cue, _ = geometry
    n = places.shape[0]
    product = 1.0
    for i in range(n):
        open_chances[i] = 1.0
        if needed & (1 << i) != 0 and places[i, 0] > 0.5 * NOWHERE:
            open_chances[i] = max(openness(places, geometry, i), BLOCKED)
            product *= open_chances[i]
    count = 0
    for ball in range(n):
        if playable & (1 << ball) == 0:
            continue
        for p in range(gates.shape[0]):
            direction, half = pocket_window(gates, p, places[ball, 0], places[ball, 1], radii[ball])
            if half <= 0.0:
                continue
            reach = 2.0 * math.sqrt(radii[cue] * radii[ball])
            for c in range(cuts.shape[0]):
                for d in range(distances.shape[0]):
                    back = direction + math.pi + cuts[c]
                    x = (
                        places[ball, 0]
                        - reach * elementary.cos(direction)
                        + distances[d] * elementary.cos(back)
                    )
                    y = (
                        places[ball, 1]
                        - reach * elementary.sin(direction)
                        + distances[d] * elementary.sin(back)
                    )
                    inside = region[0] <= x <= region[1] and region[2] <= y <= region[3]
                    if not (inside and _is_clear(places, geometry, x, y)):
                        continue
                    places[cue, 0] = x
                    places[cue, 1] = y
                    chance = pot_chance(places, geometry, ball, p)
                    if chance > 0.0 and count < found.shape[0]:
                        found[count, PLACE_X] = x
                        found[count, PLACE_Y] = y
                        found[count, PLACE_BALL] = ball
                        found[count, PLACE_CHANCE] = chance * product / open_chances[ball]
                        count += 1
    return count


class BallInHand(NamedTuple):
    """A cue ball to be put down.

    layout: the other balls; hand: where it may be put; noise: how unsteady the shooter is.
    """

    layout: Arrangement
    table: Table
    physics: Physics
    hand: Hand
    noise: Noise

    def region(self) -> tuple[float, float, float, float]:
        """Where its centre may be: left, right, lower, upper, m."""
        left, right, lower, upper = bed_for(self.table, float(self.layout.balls.radii[CUE_BALL]))
        if self.hand == "behind the line":
            upper = min(upper, HEAD_SPOT * self.table.length)
        return left, right, lower, upper

    def placed(self, place: tuple[float, float]) -> Arrangement:
        """The balls with the cue ball at a place, m."""
        return self.layout.with_ball(CUE_BALL, place)

    def placed_near(self, x: float, y: float) -> Arrangement:
        """The balls with the cue ball at the free place nearest to (x, y) m."""
        return self.placed(nearest_free(self.layout, self.table, CUE_BALL, x, y, self.hand))

    def view(self, layout: Arrangement) -> View:
        """One of the arrangements as the search sees it."""
        return View(Board(layout, self.table, self.physics), self.noise)


def places_for_cue_ball(ball: BallInHand, aims: Aims, most: int) -> Floats:
    """The likeliest places (c, 4) for the cue ball, not more than a share of them for one object ball.

    aims: in rows of the arrangement with the cue ball.
    """
    left, right, lower, _ = ball.region()
    view = ball.view(ball.placed_near(0.5 * (left + right), lower))
    distances = DISTANCES_FROM_LINE if ball.hand == "behind the line" else DISTANCES
    found = np.empty((MOST_PLACES, 4))
    count = list_places(
        view.places.copy(), view.geometry, np.array(ball.region()), aims.first & aims.score, aims.needed,
        CUTS, distances, np.empty(view.board.count), found,
    )  # fmt: skip
    order = np.argsort(-found[:count, PLACE_CHANCE], kind="stable")
    taken: list[int] = []
    share: dict[int, int] = {}
    for row in order.tolist():
        target = int(found[row, PLACE_BALL])
        share[target] = share.get(target, 0) + 1
        if share[target] <= max(2, most // 4):
            taken.append(row)
        if len(taken) == most:
            break
    return found[taken]


def place_cue_ball(
    ball: BallInHand,
    aims: Aims,
    effort: Effort,
    draws: Floats,
    keep: int,
    most: int = 24,
    pool: ThreadPoolExecutor | None = None,
    clock: Clock = UNLIMITED,
) -> list[Arrangement]:
    """Arrangements with the cue ball at its best places, the best first: at least one, at most `keep`.

    effort: how hard to look at each of `most` places; when time is out, the likelier ones have been.
    draws: random deviations of strokes, as `look` takes them.
    """
    places = places_for_cue_ball(ball, aims, most)
    if not len(places):
        return [ball.placed_near(0.5 * ball.table.width, HEAD_SPOT * ball.table.length)]
    layouts = [ball.placed(row[:2]) for row in places]

    def worth(i: int) -> float:
        if i > 0 and clock.is_out():
            return -1.0
        looked = look(ball.view(layouts[i]), aims, effort, draws)
        return float(looked.worth[0]) if looked is not None else 0.0

    worths = np.array(in_threads(pool, worth, range(len(layouts))))
    return [layouts[i] for i in np.argsort(-worths, kind="stable")[:keep].tolist()]
