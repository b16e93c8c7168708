"""The map at pool: pots, combinations, and where the cue ball may end."""

import numpy as np
import pytest

from game.billiards.game.arrangement import arrange
from game.billiards.game.summary import summarize
from game.billiards.map.pool import cue_ball_heat, pool_map, pot_keys
from game.billiards.search.legality import Legality
from game.billiards.search.strokes import Board, Noise
from game.billiards.simulation import simulate
from game.billiards.table.table import Table

LAYOUT = {0: (0.5, 0.9), 1: (0.3, 0.5), 2: (1.0, 1.6), 3: (0.62, 1.9), 4: (0.25, 0.4)}


@pytest.fixture(scope="module")
def board():
    return Board(arrange(LAYOUT), Table.pool())


@pytest.fixture(scope="module")
def drawn(board):
    return pool_map(board, Noise(), draws=32)


def played(board, stroke):
    return summarize(simulate(board.layout.shot(board.table, board.physics, stroke)))


def test_every_pot_of_the_map_pots(board, drawn):
    from game.billiards.game.arrangement import Stroke

    assert len(drawn.strokes) == 18_000 and len(drawn.pots) > 6
    checked = 0
    for pot in drawn.pots:
        for row in pot.rows[:: max(1, len(pot.rows) // 6)].tolist():
            summary = played(board, Stroke(*drawn.strokes[row].tolist()))
            fallen = summary.pocketing(pot.ball)
            assert fallen is not None and fallen.pocket == pot.pocket and not summary.cue_pocketed
            checked += 1
    assert checked > 40


def test_pots_are_told_apart_by_chain_and_cushions(board, drawn):
    names = [(pot.ball, pot.pocket, pot.chain, pot.cushions) for pot in drawn.pots]
    assert len(set(names)) == len(names)
    assert all(pot.chain[0] == 0 and pot.chain[-1] == pot.ball for pot in drawn.pots)
    combination = next(pot for pot in drawn.pots if pot.combination)
    summary = played(board, combination.stroke)
    assert summary.first and summary.first[0] in combination.chain
    assert [pot.chance for pot in drawn.pots] == sorted((p.chance for p in drawn.pots), reverse=True)


def test_only_allowed_balls_may_be_hit_first(board, drawn):
    assert len({pot.chain[1] for pot in drawn.pots}) > 1
    only = pool_map(board, Noise(), legality=Legality((1,)), draws=8)
    assert only.pots and {pot.chain[1] for pot in only.pots} == {1}
    assert (
        (pot_keys(board, drawn.outcomes, Legality((1,))) > 0).sum()
        == (only.keys > 0).sum()
        < (drawn.keys > 0).sum()
    )


def test_where_the_cue_ball_may_end(board, drawn):
    pot = drawn.pots[0]
    cells = cue_ball_heat(board, drawn, pot.ball, pot.pocket, 8, 16)
    assert cells.shape == (16, 8) and cells.sum() == pytest.approx(1.0)
    x, y = drawn.outcomes.places[pot.rows[0], board.cue].tolist()
    assert cells[int(y / board.table.length * 16), int(x / board.table.width * 8)] > 0.0
    assert (cells > 0.0).sum() > 8  # there is a choice
    assert pot.ends.shape == (round(32 * pot.chance), 2)


def test_nothing_to_pot():
    board = Board(arrange({0: (0.6, 1.2)}), Table.pool())
    drawn = pool_map(board, Noise())
    assert drawn.pots == () and not drawn.keys.any()
    assert np.isfinite(drawn.strokes).all()
