"""The carom table: measures, spots, corners, balls put back; and all models play on it."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import carom_shot
from game.billiards.shot.cloths import CLOTHS
from game.billiards.simulation import simulate
from game.billiards.table.carom import (
    BALL_RADIUS,
    BOTTOM_SPOT,
    CENTRE_SPOT,
    RED,
    STARTING_OFFSET,
    TOP_SPOT,
    WHITE,
    YELLOW,
    corner_of,
    diamonds,
    fits,
    frozen_cushions,
    respotted,
    starting_position,
    touching,
)
from game.billiards.table.table import Table

D = 2.0 * BALL_RADIUS


def test_the_table_has_four_full_rails_and_no_pockets():
    table = Table.carom()
    assert (table.width, table.length, table.cushion_height) == (1.42, 2.84, 0.037)
    assert len(table.pockets) == len(table.jaws) == 0
    assert table.cushions[:, 4:].tolist() == [[1, 0], [-1, 0], [0, 1], [0, -1]]  # left, right, lower, upper
    lengths = np.hypot(*(table.cushions[:, 2:4] - table.cushions[:, :2]).T)
    assert lengths.tolist() == [2.84, 2.84, 1.42, 1.42]


@pytest.mark.parametrize("cue", [WHITE, YELLOW])
@pytest.mark.parametrize("side", [-1, 1])
def test_starting_position(cue, side):
    places = starting_position(cue, side)
    assert places[RED].tolist() == pytest.approx([0.71, 2.13])
    assert places[1 - cue].tolist() == pytest.approx([0.71, 0.71])
    assert places[cue].tolist() == pytest.approx([0.71 + side * 0.1825, 0.71])
    assert fits(places)


@pytest.mark.parametrize(("cue", "side"), [(RED, 1), (WHITE, 0), (WHITE, 2)])
def test_no_other_starting_position(cue, side):
    with pytest.raises(ValueError, match="starting position"):
        starting_position(cue, side)


def test_what_touches():
    places = np.array([[0.5, 0.5], [0.5 + D + 5e-5, 0.5], [0.5, 0.5 + D + 2e-4]])
    assert touching(places, WHITE) == (YELLOW,)
    assert touching(places, YELLOW) == (WHITE,)
    assert touching(places, RED) == ()
    r = BALL_RADIUS
    assert frozen_cushions((r, 1.0)) == (0,)
    assert frozen_cushions((1.42 - r - 5e-5, 1.0)) == (1,)
    assert frozen_cushions((r, r)) == (0, 2)
    assert frozen_cushions((1.0, 2.84 - r)) == (3,)
    assert frozen_cushions((r + 2e-4, 1.0)) == ()


def test_corners_are_triangles_of_71_by_35_cm():
    assert [corner_of(p) for p in ((0.1, 0.1), (1.3, 0.1), (0.1, 2.7), (1.3, 2.7))] == [0, 1, 2, 3]
    assert corner_of((0.71, 1.42)) == -1
    assert corner_of((0.354, 0.0)) == 0 and corner_of((0.356, 0.0)) == -1
    assert corner_of((0.0, 0.709)) == 0 and corner_of((0.0, 0.711)) == -1
    assert corner_of((0.18, 0.356)) == -1


def test_balls_are_put_back_on_their_own_spots():
    places = np.array([[0.3, 0.3], [0.3 + D, 0.3], [1.0, 2.0]])
    assert respotted(places, (WHITE, YELLOW), WHITE).tolist() == [
        list(BOTTOM_SPOT),
        list(CENTRE_SPOT),
        [1.0, 2.0],
    ]
    assert respotted(places, (WHITE, YELLOW), YELLOW).tolist() == [
        list(CENTRE_SPOT),
        list(BOTTOM_SPOT),
        [1.0, 2.0],
    ]
    assert respotted(places, (RED,), WHITE)[RED].tolist() == list(TOP_SPOT)


def test_a_ball_whose_spot_is_taken_goes_to_the_spot_of_the_ball_there():
    on_top = np.array([[0.3, 0.3], list(TOP_SPOT), [0.3 + D, 0.3]])
    back = respotted(on_top, (WHITE, RED), WHITE)  # yellow lies on the red ball's spot
    assert back[RED].tolist() == list(CENTRE_SPOT)
    assert back[WHITE].tolist() == list(BOTTOM_SPOT)
    round_the_table = np.array([list(TOP_SPOT), list(BOTTOM_SPOT), [0.3, 0.3]])
    back = respotted(round_the_table, (RED,), WHITE)  # white on the top spot, yellow on white's
    assert back[RED].tolist() == list(CENTRE_SPOT)
    assert fits(back)


def test_diamonds_divide_the_rails():
    points = diamonds()
    assert points.shape == (20, 2)
    assert sorted(set(points[points[:, 0] == 0.0, 1].tolist())) == pytest.approx(
        [0.355 * k for k in range(1, 8)]
    )
    assert sorted(set(points[points[:, 1] == 2.84, 0].tolist())) == pytest.approx(
        [0.355 * k for k in (1, 2, 3)]
    )


def test_places_that_balls_cannot_have():
    good = starting_position(WHITE)
    for row, place in (
        (WHITE, (BALL_RADIUS - 1e-3, 1.0)),
        (RED, (0.7, 2.84)),
        (WHITE, (0.71 + D - 1e-3, 0.71)),
    ):
        bad = good.copy()
        bad[row] = place
        assert not fits(bad)


@pytest.mark.parametrize("cloth", sorted(CLOTHS))
@pytest.mark.parametrize("model", ["exact", "stepped", "lecture"])
def test_every_model_plays_on_it(cloth, model):
    shot = carom_shot(
        Table.carom(), CLOTHS[cloth], starting_position(WHITE), WHITE, Stroke(3.0, math.radians(97.3))
    )
    final = simulate(shot, model).final
    places = np.array([final[name] for name in ("white", "yellow", "red")])
    assert np.hypot(*(places[WHITE] - (0.71 + STARTING_OFFSET, 0.71))) > 0.1
    assert (places > 0.9 * BALL_RADIUS).all() and (places < np.array([1.42, 2.84]) - 0.9 * BALL_RADIUS).all()


def test_a_heated_cloth_carries_a_ball_farther():
    def lengths(cloth):
        places = np.array([[0.4, 0.2], [1.3, 0.1], [1.3, 2.7]])
        shot = carom_shot(Table.carom(), CLOTHS[cloth], places, WHITE, Stroke(2.5, 0.5 * math.pi))
        cushions = simulate(shot).rows
        return int((cushions[:, 1] == 1).sum())

    assert lengths("heated") > lengths("club") >= 2
