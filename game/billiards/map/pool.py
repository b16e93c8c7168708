"""The map of a position at pool: every pot and combination, and where the cue ball may end after it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.map.grid import Grid, aims_of, neighbours
from game.billiards.map.leaving import heat
from game.billiards.search import outcomes as o
from game.billiards.search.chances import DRAWS, as_hand_does, pocket_of
from game.billiards.search.legality import Legality
from game.billiards.search.outcomes import Outcomes
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise

SEED = 61
SPEEDS = (0.8, 1.3, 2.0, 3.0)  # m/s of the cue
LEFTS, UPS = (-0.3, 0.0, 0.3), (-0.4, 0.0, 0.4)  # ball radii
AIMS = 500
MOST_CUSHIONS = 3  # that the name of a pot tells apart


class Pot(NamedTuple):
    """Strokes that pot one ball into one pocket by one chain of balls.

    ball, chain: numbers, the chain from the cue ball to this one; cushions: that the ball touches before it
    falls, at most MOST_CUSHIONS. pocket: row. stroke: the best. chance: how often a hand pots with it.
    rows (k,): of the map's strokes. ends (j, 2) m: where the cue ball ends after the hand's strokes that pot.
    """

    ball: int
    pocket: int
    chain: tuple[int, ...]
    cushions: int
    stroke: Stroke
    chance: float
    rows: NDArray[np.intp]
    ends: Floats

    @property
    def combination(self) -> bool:
        """True if another ball sends this one in."""
        return len(self.chain) > 2


class PoolMap(NamedTuple):
    """strokes (m, 5) of the grid, keys (m,) of those that pot (0: none), pots, the surest first; outcomes."""

    strokes: Floats
    keys: NDArray[np.int64]
    pots: tuple[Pot, ...]
    outcomes: Outcomes


def grid_for(board: Board, aims: int = AIMS) -> Grid:
    """The strokes that a map of a board begins with."""
    return Grid(
        aims_of(board.places, board.radii, board.cue, aims), np.array(SPEEDS), np.array(LEFTS), np.array(UPS)
    )


def pool_map(
    board: Board,
    noise: Noise,
    legality: Legality | None = None,
    groups: int = 16,
    draws: int = DRAWS,
    seed: int = SEED,
) -> PoolMap:
    """Every pot at a board that breaks no rule. legality: what the rules ask, None for nothing."""
    legality = Legality.free(board) if legality is None else legality
    grid = grid_for(board)
    strokes = grid.strokes
    outcomes = board.play(strokes)
    keys = pot_keys(board, outcomes, legality)
    alike = neighbours(keys, grid.shape)
    found, counts = np.unique(keys[keys > 0], return_counts=True)
    chosen = found[np.lexsort((found, -counts))][:groups].tolist()
    if not chosen:
        return PoolMap(strokes, keys, (), outcomes)
    best, members = [], []
    for key in chosen:
        rows = np.flatnonzero(keys == key)
        near = rows[np.argsort(-alike[rows], kind="stable")[:4]]
        tried = board.play(with_noise(strokes[near], draw_noise(seed, 16), noise, board.radius))
        share = _goes_down(board, tried, legality, key).reshape(len(near), -1)
        best.append(strokes[near[int(np.argmax(share.mean(axis=1)))]])
        members.append(rows)
    played = board.play(as_hand_does(np.array(best), noise, board.radius, draws))
    pots = []
    for k, key in enumerate(chosen):
        own = played.rows(slice(k * draws, (k + 1) * draws))
        good = _goes_down(board, own, legality, key)
        ends = own.places[good, board.cue]
        pots.append(_pot(board, outcomes, members[k], best[k], float(good.mean()), ends))
    return PoolMap(strokes, keys, tuple(sorted(pots, key=lambda pot: -pot.chance)), outcomes)


def pot_keys(board: Board, outcomes: Outcomes, legality: Legality | None = None) -> NDArray[np.int64]:
    """A number (m,) for what each stroke pots: ball, pocket, chain and cushions; 0 for nothing, or a foul.

    Of several balls it is the one of the lowest row. legality: what the rules ask, None for nothing.
    """
    facts, histories = outcomes.facts, outcomes.histories
    legality = Legality.free(board) if legality is None else legality
    down = facts[:, o.DOWN]
    row = np.zeros(len(down), np.int64)
    for ball in range(board.count - 1, -1, -1):
        row = np.where(down & (1 << ball) != 0, ball, row)
    own = histories[np.arange(len(row)), row]
    cushions = np.minimum(own[:, o.CUSHIONS], MOST_CUSHIONS)
    key = 1 + row + 16 * (np.maximum(own[:, o.POCKET], 0) + 8 * (cushions + 4 * own[:, o.CHAIN]))
    return np.where((down != 0) & ~legality.fouls(board, outcomes), key, 0)


def _goes_down(board: Board, outcomes: Outcomes, legality: Legality, key: int) -> NDArray[np.bool_]:
    """Which strokes (m,) send the ball of a key into its pocket without a foul, however it got there."""
    ball, pocket = (key - 1) % 16, (key - 1) // 16 % 8
    return pocket_of(board, outcomes, legality, ball) == pocket


def _balls_down(keys: NDArray[np.int64]) -> NDArray[np.int64]:
    """Ball and pocket of keys (m,), without how it got there; 0 for none."""
    return np.where(keys > 0, 1 + (keys - 1) % 128, 0)


def _pot(
    board: Board, outcomes: Outcomes, rows: NDArray[np.intp], stroke: Floats, chance: float, ends: Floats
) -> Pot:
    """What stands behind a key, by one of its strokes."""
    facts, histories = outcomes.facts[rows[0]], outcomes.histories[rows[0]]
    ball = next(k for k in range(board.count) if facts[o.DOWN] & (1 << k))
    pocket, bits, _, cushions = histories[ball].tolist()
    numbers = board.layout.numbers
    between = [numbers[k] for k in range(board.count) if bits & (1 << k) and k not in (board.cue, ball)]
    chain = (numbers[board.cue], *between, numbers[ball])
    return Pot(
        numbers[ball],
        pocket,
        chain,
        min(cushions, MOST_CUSHIONS),
        Stroke(*stroke.tolist()),
        chance,
        rows,
        ends,
    )


def cue_ball_heat(
    board: Board, drawn: PoolMap, ball: int, pocket: int, columns: int = 32, rows: int = 64
) -> Floats:
    """Where the cue ball may end after some stroke of the map that pots a ball (number) into a pocket
    (row): share of those strokes in each cell (rows, columns), from the lower end and the left.

    What is 0 cannot be had.
    """
    row = board.layout.numbers.index(ball)
    potting = _balls_down(drawn.keys) == 1 + row + 16 * pocket
    ends = drawn.outcomes.places[potting, board.cue]
    return heat(ends, columns, rows, board.table.width, board.table.length)
