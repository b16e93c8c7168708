"""What a map costs: 18 000 strokes at carom, and at pool with nine object balls; then the close look.

python -m pytest tests/benchmarks/test_carom_map.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np

from game.billiards.game.arrangement import arrange
from game.billiards.map.carom import draw_map, whole_map
from game.billiards.map.pool import grid_for
from game.billiards.search.strokes import Board, Noise
from game.billiards.table.table import Table
from tests.billiards.map.positions import position_at

PLACES = np.array([[0.9, 0.7], [0.41, 1.1], [0.71, 2.13]])
NINE = {
    0: (0.13, 0.62), 1: (0.98, 0.32), 2: (0.27, 2.31), 3: (1.02, 1.39), 4: (0.64, 0.24), 5: (1.15, 2.04),
    6: (0.42, 1.58), 7: (0.85, 1.85), 8: (0.21, 1.05), 9: (0.71, 1.12),
}  # fmt: skip


def test_coarse_map_at_carom(benchmark):
    """The goal is 50 ms."""
    position = position_at(PLACES)
    drawn = benchmark(lambda: next(draw_map(position, Noise())))
    assert len(drawn.strokes) == 18_000 and drawn.groups


def test_whole_map_at_carom(benchmark):
    position = position_at(PLACES)
    drawn = benchmark(lambda: whole_map(position, Noise()))
    assert drawn.fine and drawn.groups[0].chance > 0.2


def test_coarse_map_at_pool(benchmark):
    """The goal is 100 ms."""
    board = Board(arrange(NINE), Table.pool())
    strokes = grid_for(board).strokes
    outcomes = benchmark(lambda: board.play(strokes))
    assert len(outcomes.facts) == 18_000
