"""The challenge of a day: pot a ball by one stroke, and stop the cue ball as near as can be to a place.

Position and place follow from the date alone, so that they are the same for all. The searching player plays
it first: a day of which it finds no solution is drawn again. How near the best stroke of its search comes is
the par.
"""

from __future__ import annotations

import hashlib
import math
from datetime import date
from typing import NamedTuple

import numpy as np

from game.billiards.game.arrangement import Arrangement, Stroke, arrange, is_free
from game.billiards.game.frame import Frame, Played
from game.billiards.game.games import Drill
from game.billiards.game.goals import Goal, Pot, Zone, missed
from game.billiards.game.rules import CUE_BALL, ShotSummary
from game.billiards.search.aims import all_aims
from game.billiards.search.finding import search
from game.billiards.search.looking import Effort
from game.billiards.search.strokes import Board, Noise
from game.billiards.search.view import View
from game.billiards.table.table import Table

Place = tuple[float, float]
TARGET = 1  # number of the ball to pot
BALLS = 4  # the cue ball, the ball to pot, and two that are in the way
DRAWS = 200  # positions that are tried for a day
EDGE = 0.12  # m from the cushions to where balls and the place lie
LEAST_PAR, MOST_PAR = 0.005, 0.15  # m; a nearer par is rounded up, a farther one is no challenge
NEAR = 3.0  # pars within which the second star is won
EFFORT = Effort(
    ("direct",), (0.7, 1.0, 1.5, 2.2, 3.0), (-0.4, -0.2, 0.0, 0.2, 0.4), (-0.3, 0.0, 0.3), candidates=6,
    rays=17, finalists=48, samples=8,
)  # fmt: skip


class Challenge(NamedTuple):
    """A day's. day: as 2026-11-23. balls: number, x, y m. place: where the cue ball is to stop, m.

    par: how near the searching player comes, m; stroke: by which one.
    """

    day: str
    balls: tuple[tuple[int, float, float], ...]
    place: Place
    par: float
    stroke: Stroke

    @property
    def goals(self) -> tuple[Goal, ...]:
        """Of its stars: the ball, near the place, as near as par."""
        x, y = self.place
        rings = (Zone(CUE_BALL, x, y, reach * self.par) for reach in (NEAR, 1.0))
        return (Goal(pots=(Pot(TARGET),)), *(Goal(zones=(ring,)) for ring in rings))


def challenge_of(day: str) -> Challenge:
    """The challenge of a day, as 2026-11-23. ValueError for what is no date.

    The same day gives the same bits on every machine.
    """
    date.fromisoformat(day)
    seed = int.from_bytes(hashlib.blake2b(day.encode(), digest_size=8).digest(), "big")
    rng = np.random.default_rng(seed)
    table = Table.pool()
    for _ in range(DRAWS):
        layout, place = _drawn(rng, table)
        found = _solved(layout, table, place)
        if found is not None and found[0] <= MOST_PAR:
            return Challenge(day, layout.places, place, max(found[0], LEAST_PAR), found[1])
    raise ValueError(f"challenge: none was found for {day}")


def _drawn(rng: np.random.Generator, table: Table) -> tuple[Arrangement, Place]:
    """Balls and a place, all apart; millimetres, so that a file says them exactly."""
    layout = arrange({})
    for number in range(BALLS):
        layout = layout.with_ball(number, _free(rng, table, layout, number))
    return layout, _free(rng, table, layout, BALLS)


def _free(rng: np.random.Generator, table: Table, layout: Arrangement, number: int) -> Place:
    """A place at which a ball would lie free."""
    while True:
        across, along = rng.random(2).tolist()
        x = round(EDGE + (table.width - 2.0 * EDGE) * across, 3)
        y = round(EDGE + (table.length - 2.0 * EDGE) * along, 3)
        if is_free(layout, table, number, x, y):
            return x, y


def _solved(layout: Arrangement, table: Table, place: Place) -> tuple[float, Stroke] | None:
    """How near the best of the strokes that the search finds comes, m, and the stroke; None without a pot."""
    view = View(Board(layout, table), Noise())
    looked = search(view, all_aims(layout.numbers, (TARGET,), (TARGET,), 0), EFFORT, 0, threads=1)
    if looked is None:
        return None
    frame, best = frame_of(layout, table), None
    for row in looked.strokes:
        stroke = Stroke(*row.tolist())
        far = distance(frame.play(stroke), place)
        if far is not None and (best is None or far < best[0]):
            best = far, stroke
    return best


def frame_of(layout: Arrangement, table: Table) -> Frame:
    """The position of a challenge before the first try."""
    numbers = tuple(number for number in layout.numbers if number != CUE_BALL)
    return Frame(Drill(goal=Goal(pots=(Pot(TARGET),)), set_up=numbers, on_table=numbers), layout, table)


def distance(played: Played, place: Place) -> float | None:
    """How far from a place the cue ball of a stroke stopped, m; None if the ball did not go down."""
    return missed_by(played.summary, place)


def missed_by(shot: ShotSummary, place: Place) -> float | None:
    """The same of what the referee saw."""
    if missed(Goal(pots=(Pot(TARGET),)), shot):
        return None
    at = next(((x, y) for ball, x, y in shot.rest if ball == CUE_BALL), None)
    if at is None:
        return None
    dx, dy = at[0] - place[0], at[1] - place[1]
    return math.sqrt(dx * dx + dy * dy)
