"""Where to put a white ball that is in hand: behind the balls that can be potted, at cuts and distances.

Many places are looked at quickly, the best of them again and closely.
"""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.arrangement import Arrangement, bed_for, nearest_free
from game.billiards.game.rules import CUE_BALL, Hand
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.search.lanes import openness, pocket_window, pot_chance
from game.billiards.search.looking import Effort, look
from game.billiards.search.outcomes import NOWHERE
from game.billiards.search.rating import BLOCKED, Aims
from game.billiards.search.strokes import Board, Noise, in_threads
from game.billiards.search.view import UNLIMITED, Clock, View
from game.billiards.shot.shot import Physics
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table

Array = NDArray[np.float64]

CUTS = np.radians([0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0])
DISTANCES = np.array([0.15, 0.3, 0.5])  # m; from the white ball to where it meets the other
MOST_PLACES = 15 * 6 * 7 * 3

# columns of places for the white ball (c, 4): x, y m; row of the ball that it lies for; estimated chance
PLACE_X, PLACE_Y, PLACE_BALL, PLACE_CHANCE = range(4)


@inner_kernel
def _is_clear(places, radii, cue, x, y):
    """True if the white ball overlaps no other at (x, y) m."""
    for k in range(places.shape[0]):
        if k != cue:
            dx = places[k, 0] - x
            dy = places[k, 1] - y
            reach = radii[cue] + radii[k] + 1e-6
            if dx * dx + dy * dy < reach * reach:
                return False
    return True


@lean_kernel
def list_places(places, radii, gates, cue, playable, needed, sight, bed, room, cuts, distances, found):
    """Places for the white ball to pot a ball from, to found (c, 4). Returns how many.

    places (n, 2): m, of which the white ball's is written over. bed: where its centre may lie. room (n,).
    """
    n = places.shape[0]
    product = 1.0
    for i in range(n):
        room[i] = 1.0
        if needed & (1 << i) != 0 and places[i, 0] > 0.5 * NOWHERE:
            room[i] = max(openness(places, radii, gates, cue, i, sight), BLOCKED)
            product *= room[i]
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
                    x = places[ball, 0] - reach * math.cos(direction) + distances[d] * math.cos(back)
                    y = places[ball, 1] - reach * math.sin(direction) + distances[d] * math.sin(back)
                    inside = bed[0] <= x <= bed[1] and bed[2] <= y <= bed[3]
                    if not (inside and _is_clear(places, radii, cue, x, y)):
                        continue
                    places[cue, 0] = x
                    places[cue, 1] = y
                    chance = pot_chance(places, radii, gates, cue, ball, p, sight, bed)
                    if chance > 0.0 and count < found.shape[0]:
                        found[count, PLACE_X] = x
                        found[count, PLACE_Y] = y
                        found[count, PLACE_BALL] = ball
                        found[count, PLACE_CHANCE] = chance * product / room[ball]
                        count += 1
    return count


def places_for_white(
    lie: Arrangement, table: Table, physics: Physics, hand: Hand, aims: Aims, noise: Noise, most: int
) -> Array:
    """The likeliest places (c, 4) for a white ball in hand, not more than a share of them for one ball.

    aims: in rows of the arrangement with the white ball.
    """
    radius = float(lie.balls.radii[CUE_BALL])
    left, right, lower, upper = bed_for(table, radius)
    if hand == "behind the line":
        upper = min(upper, HEAD_SPOT * table.length)
    with_white = lie.with_ball(
        CUE_BALL, nearest_free(lie, table, CUE_BALL, 0.5 * (left + right), lower, hand)
    )
    view = View(Board(with_white, table, physics), noise)
    found = np.empty((MOST_PLACES, 4))
    count = list_places(
        view.places.copy(), view.radii, view.gates, view.board.cue, aims.first & aims.score, aims.needed,
        view.sight, np.array([left, right, lower, upper]), np.empty(view.board.count), CUTS, DISTANCES, found,
    )  # fmt: skip
    order = np.argsort(-found[:count, PLACE_CHANCE], kind="stable")
    taken: list[int] = []
    share: dict[int, int] = {}
    for row in order.tolist():
        ball = int(found[row, PLACE_BALL])
        share[ball] = share.get(ball, 0) + 1
        if share[ball] <= max(2, most // 4):
            taken.append(row)
        if len(taken) == most:
            break
    return found[taken]


def place_white(
    lie: Arrangement,
    table: Table,
    physics: Physics,
    hand: Hand,
    aims: Aims,
    noise: Noise,
    effort: Effort,
    draws: Array,
    keep: int,
    most: int = 24,
    pool: ThreadPoolExecutor | None = None,
    clock: Clock = UNLIMITED,
) -> list[Arrangement]:
    """Arrangements with the white ball at its best places, the best first: at least one, at most `keep`.

    effort: how hard to look at each of `most` places; when time is out, the likelier ones have been.
    draws: random deviations of strokes, as `look` takes them.
    """
    without = lie.without(CUE_BALL)
    places = places_for_white(without, table, physics, hand, aims, noise, most)
    if not len(places):
        spot = nearest_free(without, table, CUE_BALL, 0.5 * table.width, HEAD_SPOT * table.length, hand)
        return [without.with_ball(CUE_BALL, spot)]
    lies = [without.with_ball(CUE_BALL, row[:2]) for row in places]

    def worth(i: int) -> float:
        if i > 0 and clock.is_out():
            return -1.0
        looked = look(View(Board(lies[i], table, physics), noise), aims, effort, draws)
        return float(looked.worth[0]) if looked is not None else 0.0

    worths = np.array(in_threads(pool, worth, range(len(lies))))
    return [lies[i] for i in np.argsort(-worths, kind="stable")[:keep].tolist()]
