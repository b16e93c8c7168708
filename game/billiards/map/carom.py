"""The map of a carom position: coarse over all strokes, then fine where they score.

`draw_map` goes through aim, speed and tip on a grid, keeps what scores, and puts strokes of one order of
touches into a group. It looks round the best of each: how often a hand makes it, how far it may be off. What
it finds depends on the position, what is wanted and the seed only.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke, arrange, equal_balls
from game.billiards.map.grid import Grid, aims_of, neighbours
from game.billiards.map.routes import KISSES, RAILS, Routes, Wanted, play_routes
from game.billiards.search import strokes as s
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.billiards.shot.physics import Physics
from game.billiards.table.carom import BALL_MASS, BALL_RADIUS, RED, frozen_cushions, touching
from game.billiards.table.table import Table
from game.physics.kernels import elementwise

SEED = 61
AIMS = 300
LEFTS, UPS = (-0.5, -0.25, 0.0, 0.25, 0.5), (-0.3, 0.0, 0.3)  # ball radii
SPEEDS = {
    0: (0.5, 0.9, 1.6, 2.8),
    1: (0.8, 1.4, 2.2, 3.4),
    3: (1.6, 2.4, 3.4, 4.8),
}  # m/s, by cushions wanted
LARGEST_TIP = 0.6  # ball radii


class Search(NamedTuple):
    """How hard a map looks. aims, speeds (every k-th), groups that are looked at closely, candidates of each,
    draws for a first guess of their chance. Then moves from the best of them, and draws for the chance that
    is shown.
    """

    aims: int = AIMS
    every_speed: int = 1
    groups: int = 16
    candidates: int = 6
    first_draws: int = 16
    moves: int = 24
    draws: int = 96


THOROUGH = Search()
GLANCE = Search(aims=72, every_speed=2, groups=5, candidates=3, first_draws=6, moves=0, draws=12)


class Group(NamedTuple):
    """Strokes whose cue ball touches the same things in the same order.

    code: see `routes`. found: so many of the grid's strokes. stroke: the best. chance: how often a hand
    scores with it, by any way. meant: how often by this one. error: standard deviation of the chance.
    kisses: of the best. rows (found,): of the grid. ends (k, 3, 2) m: where white, yellow and red lie after
    the hand's strokes that score.
    """

    code: int
    found: int
    stroke: Stroke
    chance: float
    meant: float
    error: float
    kisses: int
    rows: NDArray[np.intp]
    ends: Floats


class CaromMap(NamedTuple):
    """strokes (m, 5) of the grid, codes (m,) of those that score, 0 for the others; groups, the surest first.

    fine: chances have been counted; before, they stand for how much of the grid a group takes.
    """

    strokes: Floats
    codes: NDArray[np.int64]
    groups: tuple[Group, ...]
    fine: bool


class Position:
    """Three balls made ready. places (3, 2) m of white, yellow, red; cue: the ball that is played."""

    def __init__(self, places: Floats, cue: int, table: Table, physics: Physics, wanted: Wanted) -> None:
        self.places = np.asarray(places, dtype=np.float64)
        self.cue = cue
        self.wanted = wanted
        self.order = [cue, 1 - cue, RED]
        own = self.places[self.order]
        layout = arrange({row: (float(x), float(y)) for row, (x, y) in enumerate(own.tolist())},
                         equal_balls(BALL_RADIUS, BALL_MASS))  # fmt: skip
        self.board = Board(layout, table, physics)
        self.against = _against(own)

    def moved(self, places: Floats) -> Position:
        """The same with its balls elsewhere, for the next stroke. places (3, 2) m, apart and on the bed."""
        other = Position.__new__(Position)
        other.__dict__.update(self.__dict__)
        other.places = places
        other.board = self.board.moved(places[self.order], np.arange(3))
        other.against = _against(places[self.order])
        other.wanted = self.wanted._replace(opening=False, leave=(), code=0)
        return other

    def play(self, strokes: Floats) -> Routes:
        """What comes of strokes (m, 5)."""
        return play_routes(self.board, np.ascontiguousarray(strokes), self.against)

    def ends(self, routes: Routes) -> Floats:
        """Where white, yellow and red come to rest (m, 3, 2) m."""
        ends = np.empty_like(routes.ends)
        ends[:, self.order] = routes.ends
        return ends


def _against(own: Floats) -> int:
    """What the cue ball touches, as bits for `read_routes`. own (3, 2) m: places by row."""
    x, y = own[0].tolist()
    rails = sum(1 << rail for rail in frozen_cushions((x, y)))
    return rails + sum(1 << (RAILS + row) for row in touching(own, 0))


def grid_for(position: Position, search: Search = THOROUGH) -> Grid:
    """The strokes that a map of a position begins with."""
    rows = position.places[position.order]
    aims = aims_of(rows, np.full(3, BALL_RADIUS), 0, search.aims)
    speeds = SPEEDS[position.wanted.cushions][:: search.every_speed]
    return Grid(aims, np.array(speeds), np.array(LEFTS), np.array(UPS))


def draw_map(
    position: Position, noise: Noise, search: Search = THOROUGH, seed: int = SEED
) -> Iterator[CaromMap]:
    """The map of a position as the hand with that noise plays it: coarse, and then fine.

    At the end of the second one all groups that it shows have been counted.
    """
    grid = grid_for(position, search)
    strokes = grid.strokes
    routes = position.play(strokes)
    codes = np.where(position.wanted.scores(routes), routes.codes, 0)
    alike = neighbours(codes, grid.shape)
    coarse = _coarse_groups(strokes, codes, alike, routes)
    yield CaromMap(strokes, codes, tuple(coarse), False)
    near = _Close(position, noise, search, seed)
    fine = near.looked_at(coarse[: search.groups], alike, strokes, _steps(grid))
    fine.sort(key=lambda group: (-group.chance, -group.meant, group.code))
    yield CaromMap(strokes, codes, tuple(fine), True)


def whole_map(position: Position, noise: Noise, search: Search = THOROUGH, seed: int = SEED) -> CaromMap:
    """The map at its end."""
    *_, last = draw_map(position, noise, search, seed)
    return last


def _steps(grid: Grid) -> Floats:
    """Typical distances (5,) between neighbours of a grid, by the columns of a stroke."""
    steps = np.zeros(5)
    for column, values in zip((s.AZIMUTH, s.SPEED, s.TIP_LEFT, s.TIP_UP), grid, strict=True):
        steps[column] = float(np.median(np.diff(values))) if len(values) > 1 else 0.0
    return steps


def _coarse_groups(
    strokes: Floats, codes: NDArray[np.int64], alike: NDArray[np.int64], routes: Routes
) -> list[Group]:
    """Groups of the grid, the largest first."""
    scoring = np.flatnonzero(codes)
    found, inverse, counts = np.unique(codes[scoring], return_inverse=True, return_counts=True)
    weights = np.bincount(inverse, weights=1.0 + alike[scoring], minlength=len(found))
    nowhere = np.empty((0, 3, 2))
    groups = []
    members = np.split(scoring[np.argsort(inverse, kind="stable")], np.cumsum(counts)[:-1])
    for k in np.lexsort((found, -weights)).tolist():
        rows = members[k]
        best = int(rows[np.argmax(alike[rows])])
        share = float(counts[k]) / len(codes)
        groups.append(
            Group(int(found[k]), int(counts[k]), Stroke(*strokes[best].tolist()), share, share, 0.0,
                  int(routes.facts[best, KISSES]), rows, nowhere)
        )  # fmt: skip
    return groups


class _Close:
    """Looks closely at groups: which of their strokes a hand makes most often."""

    def __init__(self, position: Position, noise: Noise, search: Search, seed: int) -> None:
        self.position = position
        self.noise = noise
        self.search = search
        self.seed = seed

    def chances(self, strokes: Floats, draws: Floats) -> Floats:
        """Share (m,) of the hand's strokes that score, for strokes (m, 5)."""
        noisy = with_noise(strokes, draws, self.noise, BALL_RADIUS)
        scored = self.position.wanted.scores(self.position.play(noisy))
        return scored.reshape(len(strokes), len(draws)).mean(axis=1)

    def looked_at(
        self, groups: list[Group], alike: NDArray[np.int64], strokes: Floats, steps: Floats
    ) -> list[Group]:
        """The groups with their best strokes and chances."""
        if not groups:
            return []
        search = self.search
        kept = [
            group.rows[np.argsort(-alike[group.rows], kind="stable")[: search.candidates]] for group in groups
        ]
        candidates = np.concatenate([strokes[rows] for rows in kept])
        owner = np.repeat(np.arange(len(groups)), [len(rows) for rows in kept])
        draws = draw_noise(self.seed, search.first_draws)
        chances = self.chances(candidates, draws)
        best = _best_of_each(candidates, owner, chances, len(groups))
        if search.moves:
            best = self._moved(best, groups, draws, steps)
        return self._counted(groups, best)

    def _moved(self, best: Floats, groups: list[Group], draws: Floats, steps: Floats) -> Floats:
        """Better strokes (g, 5) near the best ones, of the same group."""
        search = self.search
        random = np.random.default_rng(self.seed + 1)
        moves = random.normal(0.0, 0.4, (search.moves, 5)) * steps
        moves[0] = 0.0
        near = (best[:, None] + moves).reshape(-1, 5)
        tips = elementwise.hypot(near[:, s.TIP_LEFT], near[:, s.TIP_UP])
        near[:, [s.TIP_LEFT, s.TIP_UP]] *= np.minimum(LARGEST_TIP / np.maximum(tips, LARGEST_TIP), 1.0)[
            :, None
        ]
        near[:, s.SPEED] = np.maximum(near[:, s.SPEED], 0.2)
        owner = np.repeat(np.arange(len(groups)), search.moves)
        routes = self.position.play(near)
        wanted = np.array([group.code for group in groups])[owner]
        same = self.position.wanted.scores(routes) & (routes.codes == wanted)
        chances = np.full(len(near), -1.0)
        chances[same] = self.chances(near[same], draws)
        return _best_of_each(near, owner, chances, len(groups))

    def _counted(self, groups: list[Group], best: Floats) -> list[Group]:
        """Chances of the best strokes (g, 5), with draws that did not choose them."""
        draws = draw_noise(self.seed + 2, self.search.draws)
        meant = self.position.play(best)
        routes = self.position.play(with_noise(best, draws, self.noise, BALL_RADIUS))
        scores = self.position.wanted.scores(routes).reshape(len(groups), -1)
        codes = routes.codes.reshape(len(groups), -1)
        ends = self.position.ends(routes).reshape(len(groups), -1, 3, 2)
        counted = []
        for k, group in enumerate(groups):
            chance = float(scores[k].mean())
            counted.append(
                group._replace(
                    stroke=Stroke(*best[k].tolist()), chance=chance, kisses=int(meant.facts[k, KISSES]),
                    meant=float((scores[k] & (codes[k] == group.code)).mean()),
                    error=float(np.sqrt(max(chance * (1.0 - chance), 0.25 / len(draws)) / len(draws))),
                    ends=ends[k][scores[k]],
                )
            )  # fmt: skip
        return counted


def _best_of_each(strokes: Floats, owner: NDArray[np.intp], worth: Floats, groups: int) -> Floats:
    """The stroke of most worth of each group (g, 5); the first of equals."""
    order = np.lexsort((np.arange(len(owner)), -worth, owner))
    firsts = np.searchsorted(owner[order], np.arange(groups))
    return strokes[order[firsts]]
