"""Which balls can be hit, and how: snookered, snookering balls, a path to the full ball (WPBSA 2.17, 3.14).

Places are (x, y) m by number. Straight lines only, as the rules have it.
"""

from __future__ import annotations

import math

from game.billiards.table import snooker
from game.billiards.table.snooker import RED_NUMBERS, Point, in_the_d, touching
from game.physics.kernels import elementary

Places = dict[int, Point]
Discs = tuple[tuple[float, float, float], ...]  # of curved cushions: x, y, radius m

REACH = 2.0 * snooker.BALL_RADIUS
SLACK = 1e-9  # m; a ball that is passed so closely is not touched
D_RINGS, D_SPOKES = 6, 24  # of the places in the D that are looked from
FAN = 41  # directions between the two edges of a ball in which any part of it is sought


def _blocking(places: Places, start: Point, end: Point, skip: tuple[int, ...]) -> list[tuple[float, int]]:
    """Balls that a ball going from start to end would meet: (distance m to its start, number), sorted."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    found = []
    for ball, (x, y) in places.items():
        if ball in skip:
            continue
        px, py = x - start[0], y - start[1]
        share = 0.0 if square == 0.0 else min(max((px * dx + py * dy) / square, 0.0), 1.0)
        near = elementary.hypot(px - share * dx, py - share * dy)
        if share > 0.0 and near < REACH - SLACK:
            found.append((elementary.hypot(px, py), ball))
    return sorted(found)


def _ghost(start: Point, ball: Point, aside: float) -> Point:
    """Where a ball going from start is at the contact with another; aside: -1 to 1, the two finest edges."""
    dx, dy = ball[0] - start[0], ball[1] - start[1]
    distance = elementary.hypot(dx, dy)
    if distance <= REACH:
        return start
    half = elementary.asin(REACH / distance)
    angle = elementary.atan2(dy, dx) + aside * half
    along = distance * elementary.cos(aside * half)
    across = distance * elementary.sin(aside * half)
    reach = along - math.sqrt(max(REACH * REACH - across * across, 0.0))
    return start[0] + reach * elementary.cos(angle), start[1] + reach * elementary.sin(angle)


def full_path(places: Places, on: tuple[int, ...]) -> bool:
    """True if a ball on can be hit full, centre to centre. Reds do not hide reds: a red counts if no ball not
    on obstructs it (3.14(c)).
    """
    reds = tuple(ball for ball in on if ball in RED_NUMBERS)
    others = tuple(ball for ball in on if ball not in reds)
    return _reachable(places, reds, (0.0,), reds) or _reachable(places, others, (0.0,))


def any_path(places: Places, on: tuple[int, ...]) -> bool:
    """True if any part of a ball on can be hit in a straight line (3.14(b))."""
    return _reachable(places, on, tuple(-1.0 + 2.0 * k / (FAN - 1) for k in range(FAN)))


def _reachable(
    places: Places, on: tuple[int, ...], asides: tuple[float, ...], through: tuple[int, ...] = ()
) -> bool:
    """True if some ball on can be hit, so far to its side. through: balls that hide nothing."""
    start = places.get(0)
    if start is None:
        return True
    return any(
        not _blocking(places, start, _ghost(start, places[ball], aside), (0, ball, *through))
        for ball in on if ball in places for aside in asides
    )  # fmt: skip


def obstructions(places: Places, on: tuple[int, ...], ball: int, curves: Discs = ()) -> tuple[int, ...]:
    """Balls not on that hide part of a ball on from the cue ball, the nearest first; () if both extreme edges
    can be hit. Where a curved cushion is nearer than the ball, it does not count (2.17(e)).
    """
    start = places[0]
    found: list[tuple[float, int]] = []
    wall = math.inf
    for aside in (-1.0, 1.0):
        end = _ghost(start, places[ball], aside)
        found += _blocking(places, start, end, (0, *on))[:1]
        wall = min(wall, _curve_distance(start, end, curves))
    if found and wall < min(found)[0]:
        return ()
    return tuple(dict.fromkeys(number for _, number in sorted(found)))


def _curve_distance(start: Point, end: Point, curves: Discs) -> float:
    """How far the nearest curved cushion is that a ball going from start to end would meet; inf without."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    nearest = math.inf
    for x, y, radius in curves:
        px, py = x - start[0], y - start[1]
        share = 0.0 if square == 0.0 else min(max((px * dx + py * dy) / square, 0.0), 1.0)
        if elementary.hypot(px - share * dx, py - share * dy) < snooker.BALL_RADIUS + radius - SLACK:
            nearest = min(nearest, elementary.hypot(px, py) - radius)
    return nearest


def snookered(places: Places, on: tuple[int, ...], curves: Discs = ()) -> bool:
    """True if the cue ball is snookered (2.17): both extreme edges of no ball on can be hit. Without a cue
    ball it is in hand, and snookered only if it is from everywhere in the D (2.17(a)).
    """
    on = tuple(ball for ball in on if ball in places)
    if not on:
        return False
    if 0 in places:
        return _snookered_from(places, on, curves)
    return all(_snookered_from({**places, 0: at}, on, curves) for at in _d_places(places))


def _snookered_from(places: Places, on: tuple[int, ...], curves: Discs) -> bool:
    if any(ball in on for ball in touching(places)):
        return False  # what it touches it can hit
    return all(obstructions(places, on, ball, curves) for ball in on)


def snookering_balls(places: Places, on: tuple[int, ...], curves: Discs = ()) -> tuple[int, ...]:
    """The effective snookering balls (2.17(b), (c)): the nearest that hide the balls on; none where different
    balls hide different reds, and none if the cue ball is not snookered.
    """
    if 0 not in places or not snookered(places, on, curves):
        return ()
    hiding = {obstructions(places, on, ball, curves)[0] for ball in on if ball in places}
    return tuple(hiding) if len(hiding) == 1 else ()


def _d_places(places: Places) -> list[Point]:
    """Places all over the D where the cue ball can lie."""
    found = []
    for ring in range(D_RINGS + 1):
        for spoke in range(D_SPOKES + 1):
            angle = math.pi * (1.0 + spoke / D_SPOKES)
            r = snooker.D_RADIUS * ring / D_RINGS
            x, y = snooker.MIDDLE + r * elementary.cos(angle), snooker.BAULK + r * elementary.sin(angle)
            clear = all(
                elementary.hypot(x - px, y - py) > REACH + snooker.FROZEN for px, py in places.values()
            )
            if clear and in_the_d(x, min(y, snooker.BAULK)):
                found.append((x, min(y, snooker.BAULK)))
    return found
