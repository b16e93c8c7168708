"""What a stroke would do, seen before it is played: the exact paths of the balls up to the n-th event."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame, Struck, trajectory_of
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.summary import is_short
from game.billiards.laws import state as s
from game.billiards.shot.paths import Paths
from game.physics.kernels import elementary, elementwise, linear

FIRST_BALL = 0  # in place of a number of events: up to the first ball, and where that sets off
SET_OFF = 0.12  # m, so far
MOST_CUSHIONS = 30  # that are shown on the way to a first ball
LEAST_HOP = 0.001  # m; a ball that rises less is not shown to fly
LEAST_PATH = 0.004  # m; a ball that moves less is not shown to move


class BallPath(NamedTuple):
    """The path of one ball: its number, points (n, 2) m, and whether it ends in a pocket."""

    number: int
    points: Floats
    potted: bool


class Sight(NamedTuple):
    """What is foreseen. approach: of the cue ball to its first ball; after: from there on.

    ghost: where the cue ball then is; target: the ball it meets, None if none; cut: rad. others: paths of
    the balls that move. bounces: where the cue ball meets cushions. last: where it comes to rest, None if
    that is later than is shown, or in a pocket. flights: of the cue ball, points (n, 3) m with the height;
    rolls: the parts of its path between them, (n, 2) m; both empty if it does not fly. short: the target lies
    behind the head string, which the cue ball has not crossed.
    """

    approach: Floats
    after: Floats
    ghost: tuple[float, float] | None
    target: int | None
    target_place: tuple[float, float]
    cut: float
    others: tuple[BallPath, ...]
    bounces: tuple[tuple[float, float], ...]
    last: tuple[float, float] | None
    flights: tuple[Floats, ...] = ()
    rolls: tuple[Floats, ...] = ()
    short: bool = False


def foresee(struck: Struck, events: int) -> Sight:
    """The paths of a stroke up to its n-th contact, or the FIRST_BALL. ValueError if it cannot be played."""
    trajectory = trajectory_of(struck)
    rows = trajectory.rows
    contacts = rows[rows[:, 1] <= s.BALL_POCKET]
    numbers = list(struck.frame.layout.numbers)
    cue = numbers.index(CUE_BALL)
    only_first, events = events == FIRST_BALL, events or _until_first_ball(contacts, cue)
    whole = len(contacts) < events
    until = trajectory.end_time if whole else float(contacts[events - 1, 0])
    seen = contacts[contacts[:, 0] <= until]
    first = next((row for row in seen.tolist() if row[1] == s.BALL_BALL and cue in row[2:]), None)
    meets = first[0] if first is not None else until
    paths = Paths(trajectory)
    ghost, target, cut, place, short = None, None, 0.0, (0.0, 0.0), False
    if first is not None:
        other = int(first[3] if int(first[2]) == cue else first[2])
        ghost, target = paths.arriving(cue, meets)[0], numbers[other]
        place = paths.arriving(other, meets)[0]
        cut = _cut(paths.path(cue, 0.0, meets), ghost, place)
        short = is_short(trajectory, cue, other, meets)
        if only_first:
            begun = BallPath(target, beginning(paths.path(other, meets, trajectory.end_time)), False)
            return Sight(
                paths.path(cue, 0.0, meets), np.empty((0, 2)), ghost, target, place, cut, (begun,),
                _bounces(paths, seen, cue), None, *_flown(struck, paths, cue, meets), short,
            )  # fmt: skip
    sunk = {int(i): t for t, e, i, _ in seen.tolist() if e == s.BALL_POCKET}
    others = tuple(
        BallPath(numbers[ball], points, ball in sunk)
        for ball in range(len(numbers))
        if ball != cue and paths.moves(ball) and _length(points := paths.path(ball, 0.0, until)) > LEAST_PATH
    )
    last = paths.arriving(cue, until + 1e-9)[0] if whole and cue not in sunk else None
    return Sight(
        paths.path(cue, 0.0, meets),
        paths.path(cue, meets, until),
        ghost,
        target,
        place,
        cut,
        others,
        _bounces(paths, seen, cue),
        last,
        *_flown(struck, paths, cue, until),
        short,
    )


def _flown(
    struck: Struck, paths: Paths, cue: int, until: float
) -> tuple[tuple[Floats, ...], tuple[Floats, ...]]:
    """Flights of the cue ball, and its path between them; hops too low to be seen are rolled."""
    flights = paths.in_air(cue, 0.0, until, struck.frame.physics.gravity)
    if not any(float(flight[:, 2].max()) > LEAST_HOP for flight in flights):
        return (), ()
    return tuple(flights), tuple(paths.on_cloth(cue, 0.0, until))


def _until_first_ball(contacts: Floats, cue: int) -> int:
    """How many contacts there are until the cue ball meets a ball; MOST_CUSHIONS if it never does."""
    met = (contacts[:, 1] == s.BALL_BALL) & (contacts[:, 2:] == cue).any(axis=1)
    return int(met.argmax()) + 1 if met.any() else MOST_CUSHIONS


def _bounces(paths: Paths, seen: Floats, cue: int) -> tuple[tuple[float, float], ...]:
    """Where the cue ball meets cushions, m."""
    return tuple(
        paths.arriving(cue, t)[0]
        for t, e, i, _ in seen.tolist()
        if e in (s.BALL_CUSHION, s.BALL_JAW) and int(i) == cue
    )


def beginning(points: Floats) -> Floats:
    """The first SET_OFF of a path (n, 2) m."""
    way = np.concatenate([[0.0], np.cumsum(elementwise.hypot(*np.diff(points, axis=0).T))])
    count = int(np.searchsorted(way, SET_OFF))
    if count == len(points):
        return points
    share = (SET_OFF - way[count - 1]) / (way[count] - way[count - 1])
    end = points[count - 1] + share * (points[count] - points[count - 1])
    return np.concatenate([points[:count], end[None]])


def _cut(approach: Floats, ghost: tuple[float, float], place: tuple[float, float]) -> float:
    """Angle between the path at the contact and the line of centres, rad."""
    if len(approach) < 2:
        return 0.0
    along = approach[-1] - approach[-2]
    normal = np.array(place) - ghost
    size = math.sqrt(float(linear.product(along, along)) * float(linear.product(normal, normal)))
    return (
        elementary.acos(min(max(float(linear.product(along, normal)) / size, -1.0), 1.0))
        if size > 0.0
        else 0.0
    )


def _length(points: Floats) -> float:
    """How far the end of a path, or its middle, is from its beginning, m."""
    (x, y), (mx, my), (ex, ey) = points[0].tolist(), points[len(points) // 2].tolist(), points[-1].tolist()
    return max(abs(mx - x), abs(my - y), abs(ex - x), abs(ey - y))


class Foresight:
    """What is foreseen of one stroke, kept while neither it nor what it is played from changes."""

    def __init__(self) -> None:
        self._key: object = None
        self._sight: Sight | None = None

    def of(self, frame: Frame, stroke: Stroke, events: int) -> Sight | None:
        """What is foreseen up to the n-th contact; None if the stroke cannot be played."""
        key = (frame.layout.places, stroke, frame.conditions, events)
        if key != self._key:
            self._key = key
            try:
                self._sight = foresee(Struck(frame, stroke), events)
            except ValueError:
                self._sight = None
        return self._sight
