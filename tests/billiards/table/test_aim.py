"""The ghost ball: first contact of a straight way, against closed forms and a walk in small steps."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards.table.aim import first_contact
from game.billiards.table.rack import BALL_RADIUS as R
from game.billiards.table.table import Table

OPEN = Table.open()


def contact(angle, positions, radii=None, table=OPEN, in_play=None):
    positions = np.asarray(positions, dtype=float)
    radii = np.full(len(positions), R) if radii is None else np.asarray(radii, dtype=float)
    in_play = np.ones(len(positions), dtype=bool) if in_play is None else np.asarray(in_play)
    return first_contact(0, angle, positions, radii, in_play, table)


def test_head_on_touches_at_the_sum_of_the_radii():
    hit = contact(0.0, [[0.0, 0.0], [1.0, 0.0]])
    assert (hit.kind, hit.target) == ("ball", 1)
    assert hit.distance == pytest.approx(1.0 - 2 * R, abs=1e-15)
    assert hit.cut == pytest.approx(0.0, abs=1e-7)


def test_half_ball_cut_is_thirty_degrees():
    hit = contact(0.0, [[0.0, 0.0], [1.0, R]])
    assert math.degrees(hit.cut) == pytest.approx(30.0, abs=1e-9)


def test_balls_out_of_play_and_behind_are_passed():
    assert contact(0.0, [[0, 0], [1, 0]], in_play=[True, False]).kind == "nothing"
    assert contact(math.pi, [[0, 0], [1, 0]]).kind == "nothing"


def test_a_touching_ball_counts_only_when_the_way_leads_into_it():
    touching = [[0.0, 0.0], [2 * R, 0.0]]
    assert contact(0.0, touching).distance == 0.0
    assert contact(math.radians(91.0), touching).kind == "nothing"


def test_cushion_and_pocket():
    table = Table.pool()
    start = [[table.width / 2, table.length / 4]]
    hit = contact(0.0, start, table=table)
    assert hit.kind == "cushion"
    assert hit.ghost[0] == pytest.approx(table.width - R, abs=1e-12)
    corner = table.pockets[0]
    aim = math.atan2(corner[1] - start[0][1], corner[0] - start[0][0])
    assert contact(aim, start, table=table).kind == "pocket"


@given(
    angle=st.floats(-math.pi, math.pi),
    x=st.floats(-1.0, 1.0),
    y=st.floats(-1.0, 1.0),
    radius=st.floats(0.01, 0.1),
)
def test_the_ghost_touches_and_nothing_was_touched_before(angle, x, y, radius):
    if x * x + y * y <= (R + radius) ** 2:
        return
    hit = contact(angle, [[0.0, 0.0], [x, y]], [R, radius])
    ways = np.linspace(0.0, 1.0, 400)
    ways = ways * (hit.distance if hit.kind == "ball" else 3.0)
    gaps = np.hypot(ways * math.cos(angle) - x, ways * math.sin(angle) - y) - (R + radius)
    assert gaps.min() > -1e-9
    if hit.kind == "ball":
        assert math.dist(hit.ghost, (x, y)) == pytest.approx(R + radius, rel=1e-9)
