"""What is heard of a shot: impacts that are fast enough, those close together as one."""

import math

import numpy as np
import pytest

from game.billiards.laws.state import BALL_BALL, BALL_CUSHION, BALL_POCKET
from game.billiards.rhythm.hearing import TOGETHER, clicks_of
from game.billiards.shot.impacts import FALL, QUIETEST, heard_impacts
from game.billiards.shot.physics import FRICTIONLESS
from game.billiards.shot.shot import make_shot
from game.billiards.simulation import simulate_exact
from game.billiards.table.rack import BALL_RADIUS as R
from game.billiards.table.table import Table

TABLE = Table.pool()


def rolled(speed: float, gap: float):
    """A ball that meets a resting one after ``gap`` m, without friction."""
    places = [(0.6, 0.8), (0.6, 0.8 + 2.0 * R + gap)]
    return simulate_exact(
        make_shot(TABLE, places, [(0.0, speed), (0.0, 0.0)], physics=FRICTIONLESS), until=2.0
    )


def test_the_stroke_and_the_impact_are_heard_at_their_times():
    heard = clicks_of(rolled(1.0, 0.4))
    assert heard[:2] == (0.0, pytest.approx(0.4, abs=1e-12))


def test_what_is_too_slow_is_not_heard():
    assert clicks_of(rolled(0.99 * QUIETEST, 0.01)) == (0.0,)
    assert len(clicks_of(rolled(1.01 * QUIETEST, 0.01))) == 2


def test_impacts_close_together_are_one():
    places = [(0.6, 0.8), (0.6, 0.8 + 2.0 * R + 0.1), (0.6, 0.8 + 4.0 * R + 0.1 + 0.3 * TOGETHER)]
    shot = make_shot(TABLE, places, [(0.0, 1.0), (0.0, 0.0), (0.0, 0.0)], physics=FRICTIONLESS)
    played = simulate_exact(shot, until=0.2)
    assert sum(1 for row in played.rows.tolist() if row[1] == BALL_BALL) == 2
    assert len(clicks_of(played)) == 2


def test_balls_close_in_by_the_part_along_the_line_between_them():
    aside = R
    along = math.sqrt(4.0 * R * R - aside * aside)
    places = [(0.6, 0.8), (0.6 + aside, 0.8 + 0.2 + along)]
    shot = make_shot(TABLE, places, [(0.0, 2.0), (0.0, 0.0)], physics=FRICTIONLESS)
    first = next(heard_impacts(simulate_exact(shot, until=0.2)))
    assert (first.time, first.code) == (pytest.approx(0.1, abs=1e-9), BALL_BALL)
    assert first.speed == pytest.approx(2.0 * along / (2.0 * R), rel=1e-12)
    assert first.place == pytest.approx((0.6, 1.0), abs=1e-9)


def test_a_cushion_is_met_by_the_part_across_it_and_a_pocket_always_is_heard():
    moving = [(0.8, -0.6), (0.0, 0.02)]
    to_the_cushion = make_shot(TABLE, [(1.0, 0.8)], [moving[0]], physics=FRICTIONLESS)
    first = next(heard_impacts(simulate_exact(to_the_cushion, until=0.5)))
    assert first.code == BALL_CUSHION and first.speed == pytest.approx(0.8, rel=1e-12)
    pocket = TABLE.pockets[0]
    middle = np.array((0.5 * TABLE.width, 0.5 * TABLE.length))
    way = (pocket[:2] - middle) / np.hypot(*(pocket[:2] - middle))
    start = pocket[:2] - way * (pocket[2] + 0.01)
    falling = make_shot(TABLE, [start], [0.02 * way], physics=FRICTIONLESS)
    (fall,) = heard_impacts(simulate_exact(falling, until=2.0))
    assert fall.code == BALL_POCKET and fall.speed == FALL
