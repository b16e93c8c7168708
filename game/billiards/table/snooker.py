"""What lies on a snooker table, and where: 15 reds, six colours, their spots, the baulk line and the D.

Balls by number: 0 the cue ball, 1 to 15 the reds, 16 to 21 yellow, green, brown, blue, pink, black. Numbers
such as 1.1(e) are those of the WPBSA's Official Rules of the Games of Snooker and Billiards (2019).

The balls' mass is that of Mathavan, Jackson and Parkin (2010, A theoretical analysis of billiard ball
dynamics under cushion impacts).
"""

from __future__ import annotations

import math

from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.physics.kernels import elementary

Point = tuple[float, float]

BALL_RADIUS = 0.02625  # m; 52.5 mm across (1.2(b))
BALL_MASS = 0.1406  # kg (Mathavan, Jackson, Parkin 2010)

RED_NUMBERS = tuple(range(1, 16))
YELLOW, GREEN, BROWN, BLUE, PINK, BLACK = COLOURS = tuple(range(16, 22))
COLOUR_NAMES = dict(zip(COLOURS, ("yellow", "green", "brown", "blue", "pink", "black"), strict=True))
BALLS = 22

MIDDLE = 0.5 * SNOOKER_WIDTH
BAULK = 0.737  # m from the bottom cushion (1.1(d))
D_RADIUS = 0.292  # m (1.1(e))
BLACK_FROM_TOP = 0.324  # m from the top cushion (1.1(f)(i))
SPOTS: dict[int, Point] = {
    YELLOW: (MIDDLE + D_RADIUS, BAULK),  # to the right as seen from baulk (1.1(f))
    GREEN: (MIDDLE - D_RADIUS, BAULK),
    BROWN: (MIDDLE, BAULK),
    BLUE: (MIDDLE, 0.5 * SNOOKER_LENGTH),
    PINK: (MIDDLE, 0.75 * SNOOKER_LENGTH),
    BLACK: (MIDDLE, SNOOKER_LENGTH - BLACK_FROM_TOP),
}
FROZEN = 1e-4  # m; balls that are so near touch
APART = 5e-4  # m; between balls that are put as near as they go without touching


def value_of(ball: int) -> int:
    """What a ball is worth: a red 1, the colours 2 to 7 (3.1(a))."""
    return 1 if ball <= 15 else ball - 14


def name_of(ball: int) -> str:
    """A ball in words."""
    return "cue ball" if ball == 0 else COLOUR_NAMES.get(ball, "red")


def opening_places(reds: int = 15) -> dict[int, Point]:
    """Where the object balls lie at the start (3.2): the triangle behind the pink, as near as it goes.

    reds: 15 or 6 (six-red snooker: a triangle of three rows). ValueError for another number.
    """
    rows = {15: 5, 10: 4, 6: 3}.get(reds)
    if rows is None:
        raise ValueError(f"reds: expected 15, 10 or 6, got {reds!r}")
    places = dict(SPOTS)
    pitch = 2.0 * BALL_RADIUS
    apex, number = SPOTS[PINK][1] + pitch + APART, 1
    for row in range(rows):
        for place in range(row + 1):
            places[number] = (
                MIDDLE + (place - 0.5 * row) * pitch, apex + row * pitch * math.sqrt(0.75)
            )  # fmt: skip
            number += 1
    return places


def in_the_d(x: float, y: float) -> bool:
    """True if a ball at (x, y) m lies on or within the lines of the D (3.5(a))."""
    return y <= BAULK + 1e-9 and elementary.square(x - MIDDLE) + elementary.square(
        y - BAULK
    ) <= elementary.square(D_RADIUS + 1e-9)


def nearest_in_the_d(x: float, y: float) -> Point:
    """The place of the D nearest to (x, y) m."""
    dx, dy = x - MIDDLE, min(y - BAULK, 0.0)
    distance = elementary.hypot(dx, dy)
    if distance <= D_RADIUS:
        return x, BAULK + dy
    return MIDDLE + dx * D_RADIUS / distance, BAULK + dy * D_RADIUS / distance


def touching(places: dict[int, Point], ball: int = 0) -> tuple[int, ...]:
    """Balls that a ball touches, of places by number, m."""
    if ball not in places:
        return ()
    x, y = places[ball]
    return tuple(
        other for other, (px, py) in sorted(places.items())
        if other != ball and elementary.hypot(px - x, py - y) <= 2.0 * BALL_RADIUS + FROZEN
    )  # fmt: skip


def is_occupied(places: dict[int, Point], spot: Point) -> bool:
    """True if a ball cannot be put on a spot without touching another (2.18)."""
    return any(
        elementary.hypot(x - spot[0], y - spot[1]) < 2.0 * BALL_RADIUS + FROZEN for x, y in places.values()
    )


def respotted(places: dict[int, Point], colours: tuple[int, ...]) -> dict[int, Point]:
    """Places by number with colours put back (3.7): each on its own spot. If that is occupied, on the highest
    free one, the higher value first. If all are, as near as can be to its own towards the top cushion, and if
    there is no space, towards the bottom cushion.
    """
    places = {ball: at for ball, at in places.items() if ball not in colours}
    waiting = []
    for colour in sorted(colours, reverse=True):
        if is_occupied(places, SPOTS[colour]):
            waiting.append(colour)
        else:
            places[colour] = SPOTS[colour]
    for colour in waiting:
        free = [spot for spot in reversed(COLOURS) if not is_occupied(places, SPOTS[spot])]
        places[colour] = SPOTS[free[0]] if free else _beyond(places, SPOTS[colour])
    return places


def _beyond(places: dict[int, Point], spot: Point) -> Point:
    """The free place nearest to a spot on the line along the table: towards the top (3.7(f)), else the bottom
    cushion (3.7(g)).
    """
    x, y = spot
    reach = 2.0 * BALL_RADIUS + APART
    up, down = [y], [y]
    for px, py in places.values():
        under = reach * reach - elementary.square(px - x)
        if under > 0.0:
            up.append(py + math.sqrt(under))
            down.append(py - math.sqrt(under))
    order = sorted(at for at in up if y <= at <= SNOOKER_LENGTH - BALL_RADIUS)
    order += sorted((at for at in down if BALL_RADIUS <= at < y), reverse=True)
    for at in order:
        if not is_occupied(places, (x, at)):
            return x, at
    raise ValueError("spots: there is no place for a colour on its line")
