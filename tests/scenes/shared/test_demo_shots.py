"""What a table does by itself: strokes, the cue ball put back, balls as somebody left them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table
from game.scenes.shared.tables.demo_shots import (
    BREAK_SPEED,
    STEEPEST_CUT,
    choose_stroke,
    free_head_spot,
    scattered_orientations,
)

R = 0.028575
TABLE = Table.pool()


def stroke_for(*places: tuple[float, float], gone: tuple[int, ...] = (), seed: int = 1, stroke: int = 1):
    in_play = np.ones(len(places), dtype=bool)
    in_play[list(gone)] = False
    return choose_stroke(np.array(places), np.full(len(places), R), in_play, TABLE, seed, stroke)


def bearing(start, end) -> float:
    return math.atan2(end[1] - start[1], end[0] - start[0])


def aside(one: float, other: float) -> float:
    return abs(math.remainder(one - other, math.tau))


def test_without_another_ball_the_cue_ball_is_rolled_up_the_table():
    assert stroke_for((0.5, 0.5)) == (0.5 * math.pi, 1.0)
    assert stroke_for((0.5, 0.5), (0.6, 0.9), gone=(1,)) == (0.5 * math.pi, 1.0)


def test_the_first_stroke_is_a_break_into_the_ball_nearest_the_head():
    cue, apex = (0.6, 0.5), (0.64, 1.8)
    for seed in range(5):
        found = stroke_for(cue, (0.7, 2.0), apex, (0.1, 1.9), (0.2, 1.0), gone=(4,), seed=seed, stroke=0)
        assert found.speed == BREAK_SPEED and 0.0 < aside(found.aim, bearing(cue, apex)) < 0.02
    assert stroke_for(cue, apex, seed=1, stroke=0) == stroke_for(cue, apex, seed=1, stroke=0)
    assert stroke_for(cue, apex, seed=1, stroke=0) != stroke_for(cue, apex, seed=2, stroke=0)


def straight(pocket: int, away: float, behind: float, cut: float = 0.0):
    """A cue ball and a ball in a line with a pocket, so far from each other's places, cut by an angle."""
    target = TABLE.pockets[pocket, :2]
    way = np.array([0.5 * TABLE.width, 0.5 * TABLE.length]) - target
    way = way / np.hypot(*way)
    ball = target + away * way
    ghost = ball + 2.0 * R * way
    turn = np.array([[math.cos(cut), -math.sin(cut)], [math.sin(cut), math.cos(cut)]])
    return tuple(ghost + behind * turn @ way), tuple(ball), tuple(ghost)


@pytest.mark.parametrize("cut", [0.0, 0.4, -0.9])
def test_an_open_pot_is_played_at_the_ghost_ball_by_the_way_there_is(cut):
    cue, ball, ghost = straight(0, 0.4, 0.3, cut)
    for seed in range(4):
        found = stroke_for(cue, ball, seed=seed)
        assert aside(found.aim, bearing(cue, ghost)) < 0.008
        assert found.speed == pytest.approx(1.2 + 1.1 * (0.3 + 0.4 / math.cos(cut)), rel=0.02)


def test_of_two_pots_the_easier_is_played_and_the_hard_one_alone():
    near_cue, near, ghost = straight(0, 0.25, 0.3)
    _, far, _ = straight(3, 0.5, 0.3)
    for order in ((near, far), (far, near)):
        assert aside(stroke_for(near_cue, *order).aim, bearing(near_cue, ghost)) < 0.008


def test_no_pot_is_seen_past_a_ball_that_hides_it():
    cue, ball, ghost = straight(0, 0.5, 0.5)
    hiding = tuple(0.5 * (np.array(cue) + ghost))
    found = stroke_for(cue, ball, hiding)
    assert aside(found.aim, bearing(cue, hiding)) < 0.05  # the nearest ball, by a stroke for no pot
    in_the_way = tuple(np.array(ball) + 0.5 * (TABLE.pockets[0, :2] - ball))
    assert (
        stroke_for(cue, ball, in_the_way).speed >= 3.0
        or aside(stroke_for(cue, ball, in_the_way).aim, bearing(cue, ghost)) > 0.008
    )


def test_without_a_pot_the_nearest_ball_is_played_between_three_and_five():
    cue = (0.5 * TABLE.width, 0.3)
    ball = (cue[0] + 2.0 * R + 0.02, 0.3)  # no pocket within the steepest cut
    speeds = []
    for seed in range(6):
        found = stroke_for(cue, ball, (0.1, 2.2), seed=seed, gone=(2,))
        assert aside(found.aim, 0.0) < 0.05
        speeds.append(found.speed)
    assert 3.0 <= min(speeds) < max(speeds) <= 5.0
    assert math.degrees(STEEPEST_CUT) == pytest.approx(65.0)


def test_the_cue_ball_is_put_on_the_head_spot_or_as_near_along_the_middle_as_is_free():
    spot = np.array([0.5 * TABLE.width, HEAD_SPOT * TABLE.length])
    asked = []
    assert free_head_spot(TABLE, R, lambda place: asked.append(place) or len(asked) == 5) is not None
    steps = [(place - spot)[1] / (0.5 * R) for place in asked]
    assert steps == pytest.approx([0.0, -1.0, 1.0, -2.0, 2.0])
    assert all(place[0] == spot[0] for place in asked)
    asked.clear()
    assert free_head_spot(TABLE, R, lambda place: asked.append(place) or False) is None
    assert len(asked) == 400


def test_balls_lie_with_their_numbers_up_tilted_by_12_to_40_degrees():
    """Units: half of the tilt is between 0.1 and 0.35 rad; seen from above they stand a quarter turned."""
    found = scattered_orientations(200, 3)
    assert found.shape == (200, 4) and np.abs((found * found).sum(axis=1) - 1.0).max() < 1e-12
    # the tilt is what is left without the quarter turn about z that comes after it
    w, x, y, z = found.T
    half = math.sqrt(0.5)
    tilt = np.arccos(half * (w + z))
    assert tilt.min() == pytest.approx(0.1, abs=0.01) and tilt.max() == pytest.approx(0.35, abs=0.01)
    axis = np.stack([half * (x - y), half * (x + y), half * (z - w)], axis=1) / np.sin(tilt)[:, None]
    assert np.abs(axis.mean(axis=0)).max() < 0.2 and np.all(np.abs(np.linalg.norm(axis, axis=1) - 1.0) < 1e-9)
    assert np.array_equal(found, scattered_orientations(200, 3))
    assert not np.array_equal(found[:10], scattered_orientations(10, 4))
