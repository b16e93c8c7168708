"""What is heard of a shot: impacts that are fast enough, those close together as one."""

import math

import pytest

from game.billiards.laws.state import BALL_BALL
from game.billiards.rhythm.hearing import AUDIBLE, TOGETHER, closing_speed, heard_impacts
from game.billiards.shot.shot import FRICTIONLESS, make_shot
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
    heard = heard_impacts(rolled(1.0, 0.4), 0.5)
    assert heard == (0.0, pytest.approx(0.4, abs=1e-12))


def test_what_is_too_slow_is_not_heard():
    assert heard_impacts(rolled(0.9 * AUDIBLE, 0.01), 1.0) == (0.0,)
    assert len(heard_impacts(rolled(1.1 * AUDIBLE, 0.01), 1.0)) == 2


def test_what_comes_after_the_last_beat_is_left_out():
    assert heard_impacts(rolled(1.0, 0.4), 0.4 - 2.0 * TOGETHER) == (0.0,)


def test_impacts_close_together_are_one():
    places = [(0.6, 0.8), (0.6, 0.8 + 2.0 * R + 0.1), (0.6, 0.8 + 4.0 * R + 0.1 + 0.3 * TOGETHER)]
    shot = make_shot(TABLE, places, [(0.0, 1.0), (0.0, 0.0), (0.0, 0.0)], physics=FRICTIONLESS)
    played = simulate_exact(shot, until=2.0)
    assert sum(1 for row in played.rows.tolist() if row[1] == BALL_BALL) >= 2
    assert len(heard_impacts(played, 0.2)) == 2


def test_balls_close_in_by_the_part_along_the_line_between_them():
    aside = R
    along = math.sqrt(4.0 * R * R - aside * aside)
    places = [(0.6, 0.8), (0.6 + aside, 0.8 + 0.2 + along)]
    played = simulate_exact(
        make_shot(TABLE, places, [(0.0, 2.0), (0.0, 0.0)], physics=FRICTIONLESS), until=2.0
    )
    time, code, i, j = played.rows[0].tolist()
    assert time == pytest.approx(0.1, abs=1e-9)
    assert closing_speed(played, time, int(code), int(i), int(j)) == pytest.approx(
        2.0 * along / (2.0 * R), rel=1e-5
    )
