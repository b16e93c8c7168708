"""What lies on a carom table, and where: three balls, the spots, the diamonds, the barred corners.

Balls are named by WHITE, YELLOW and RED, also by their rows. Numbers of articles are those of the Union
Mondiale de Billard, World rules of carom billiard.
"""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.table.balk import CORNERS, zone_at
from game.billiards.table.table import CAROM_LENGTH, CAROM_WIDTH
from game.physics.kernels import elementary, elementwise

Point = tuple[float, float]

WHITE, YELLOW, RED = range(3)
BALL_NAMES = ("white", "yellow", "red")

BALL_RADIUS = 0.03075  # m; 61 to 61.5 mm across (article 12)
BALL_MASS = 0.21  # kg; 205 to 220 g (article 12)
FROZEN = 1e-4  # m; balls, or a ball and a cushion, that are so near touch

TOP_SPOT = (0.5 * CAROM_WIDTH, 0.75 * CAROM_LENGTH)  # m; the red ball's (article 13)
CENTRE_SPOT = (0.5 * CAROM_WIDTH, 0.5 * CAROM_LENGTH)
BOTTOM_SPOT = (0.5 * CAROM_WIDTH, 0.25 * CAROM_LENGTH)
STARTING_OFFSET = 0.1825  # m; the two starting spots lie so far to either side of the bottom spot
SPOTS = (
    TOP_SPOT, CENTRE_SPOT, BOTTOM_SPOT,
    (BOTTOM_SPOT[0] - STARTING_OFFSET, BOTTOM_SPOT[1]), (BOTTOM_SPOT[0] + STARTING_OFFSET, BOTTOM_SPOT[1]),
)  # fmt: skip


def starting_position(cue: int, side: int = 1) -> Floats:
    """Places (3, 2) m of white, yellow and red for the first stroke (article 23).

    cue: WHITE or YELLOW, whose player begins; its ball lies on the starting spot to the right (side 1) or to
    the left (-1) of the other's. ValueError for another ball or side.
    """
    if cue not in (WHITE, YELLOW) or side not in (-1, 1):
        raise ValueError(f"starting position: cue ball 0 or 1, side -1 or 1, got {cue!r}, {side!r}")
    places = np.empty((3, 2))
    places[cue] = BOTTOM_SPOT[0] + side * STARTING_OFFSET, BOTTOM_SPOT[1]
    places[1 - cue] = BOTTOM_SPOT
    places[RED] = TOP_SPOT
    return places


def touching(places: Floats, ball: int) -> tuple[int, ...]:
    """Balls that a ball touches. places (3, 2) m."""
    gaps = elementwise.hypot(*(places - places[ball]).T) - 2.0 * BALL_RADIUS
    return tuple(other for other in range(3) if other != ball and gaps[other] <= FROZEN)


def frozen_cushions(place: Point) -> tuple[int, ...]:
    """Rails (left, right, lower, upper: 0 to 3) that a ball at (x, y) m touches."""
    x, y = place
    gaps = (x, CAROM_WIDTH - x, y, CAROM_LENGTH - y)
    return tuple(rail for rail, gap in enumerate(gaps) if gap - BALL_RADIUS <= FROZEN)


def corner_of(place: Point) -> int:
    """The barred corner at (x, y) m: 0 lower left, 1 lower right, 2 upper left, 3 upper right; -1."""
    return zone_at(CORNERS, place)


def respotted(places: Floats, balls: tuple[int, ...], cue: int) -> Floats:
    """Places (3, 2) m with some balls put back (article 83): the red ball on the top spot, the player's on
    the bottom spot, the other one in the centre. A ball whose spot is taken goes to the spot of the ball
    there.
    """
    own = {RED: TOP_SPOT, cue: BOTTOM_SPOT, 1 - cue: CENTRE_SPOT}
    now = places.copy()
    lying = [ball for ball in range(3) if ball not in balls]
    for ball in sorted(balls, key=(RED, cue, 1 - cue).index):
        spot = own[ball]
        for _ in range(3):
            taker = next((k for k in lying if elementary.dist(now[k], spot) < 2.0 * BALL_RADIUS), None)
            if taker is None:
                break
            spot = own[taker]
        now[ball] = spot
        lying.append(ball)
    return now


def diamonds() -> Floats:
    """Places (20, 2) m on the noses that the diamonds point to: at the eighths of the long rails, the
    quarters of the short ones, corners left out.
    """
    long = [(x, CAROM_LENGTH * k / 8.0) for x in (0.0, CAROM_WIDTH) for k in range(1, 8)]
    short = [(CAROM_WIDTH * k / 4.0, y) for y in (0.0, CAROM_LENGTH) for k in range(1, 4)]
    return np.array(long + short)


def fits(places: Floats) -> bool:
    """True if three balls can lie at places (3, 2) m: on the bed, none overlapping."""
    inside = (
        (places >= BALL_RADIUS).all()
        and (places[:, 0] <= CAROM_WIDTH - BALL_RADIUS).all()
        and (places[:, 1] <= CAROM_LENGTH - BALL_RADIUS).all()
    )
    gaps = [elementary.dist(places[i], places[j]) for i in range(3) for j in range(i)]
    return bool(inside) and min(gaps) >= 2.0 * BALL_RADIUS
