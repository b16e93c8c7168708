"""The hand on tracks: what each tool does at its bounds, on a small level of its own."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import parse_level
from game.physics.solids.tracks import Curve
from game.physics.solids.tracks.motion import FREE, PIECE, RADIUS, SHARE, SPEED, SPIN, VX, VY, X, Y
from game.scenes.tracks import hand as tracks_hand
from game.scenes.tracks.hand import FARTHEST, SHARES, TOOLS
from game.scenes.tracks.level import TrackContent
from game.scenes.tracks.scene import Tracks
from game.scenes.tracks.world import COLOURS
from game.stage import Pointer
from game.worlds.hands.curves import NOBODY, bent, drawn, nearest_curve
from game.worlds.hands.hand import Hand

WORDS = """scene = "tracks"
[content]
view = { left = -4.0, right = 4.0, bottom = 0.0, top = 5.0 }
tracks = [{ points = [[-2.0, 1.0], [2.0, 1.0]] }, { points = [[-2.0, 3.0], [2.0, 3.0]] }]
balls = [
    { position = [-1.0, 4.0], radius = 0.2, seated = false },
    { position = [1.0, 4.0], radius = 0.1, seated = false },
]
"""
REACH = TOOLS.near * 5.0


@pytest.fixture
def hand() -> Hand:
    scene = Tracks(parse_level(WORDS, "tracks", TrackContent))
    return scene.hand


def ball_at(hand, point):
    hand.before, hand.point = point, None
    return TOOLS.ball_at(hand)


def track_at(hand, point):
    hand.before, hand.point = point, None
    return TOOLS.track_at(hand)


def press(hand: Hand, x: float, y: float, tool: str | None = None) -> str:
    if tool is not None:
        hand.parameters.tool = tool
    return hand.take(Pointer("down", x, y, button=1))


def move(hand: Hand, x: float, y: float) -> str:
    return hand.take(Pointer("move", x, y, button=1))


def release(hand: Hand, x: float, y: float) -> str:
    return hand.take(Pointer("up", x, y, button=1))


def test_its_reach_is_a_share_of_the_height_in_view(hand):
    assert TOOLS.reach(hand) == pytest.approx(0.15)


def test_the_nearest_ball_by_its_rim_is_meant_within_reach(hand):
    assert ball_at(hand, (-1.0, 4.0)) == 0
    assert ball_at(hand, (-1.0, 4.0 + 0.2 + REACH - 1e-6)) == 0
    assert ball_at(hand, (-1.0, 4.0 + 0.2 + REACH + 1e-6)) == NOBODY
    assert ball_at(hand, (1.0 + 0.1 + REACH - 1e-6, 4.0)) == 1
    hand.model.tracks.hold(1, (-0.7, 4.0))
    assert ball_at(hand, (-0.8, 4.0)) == 0 and ball_at(hand, (-0.76, 4.0)) == 1  # by rims, not by centres
    for _ in range(2):
        hand.model.remove(0)
    assert ball_at(hand, (0.0, 0.0)) == NOBODY


def test_the_nearest_track_is_meant_within_twice_the_reach(hand):
    for x, y, found in (
        (0.0, 1.0 + 2.0 * REACH - 1e-6, 0), (0.0, 1.0 + 2.0 * REACH + 1e-6, NOBODY),
        (2.0 + 2.0 * REACH - 1e-6, 3.0, 1), (2.0 + 2.0 * REACH + 1e-6, 3.0, NOBODY),
    ):  # fmt: skip
        assert track_at(hand, (x, y)) == found


def test_a_held_ball_follows_at_rest_and_is_put_down(hand):
    row = hand.model.tracks.riders.balls.rows[0]
    row[VX], row[VY], row[SPIN], row[SPEED] = 1.0, 2.0, 3.0, 4.0
    assert press(hand, -1.1, 4.1, "hand") == "" and hand.held == 0
    assert row[[X, Y, VX, VY, SPIN, SPEED]].tolist() == [-1.1, 4.1, 0.0, 0.0, 0.0, 0.0]
    row[VX] = 5.0
    move(hand, 0.5, 3.5)
    assert row[[X, Y, VX]].tolist() == [0.5, 3.5, 0.0]
    assert hand.model.tracks.riders.balls.pieces[0, PIECE] == FREE
    put = []
    hand.model.tracks.riders.put_down = lambda ball, reach: put.append((ball, reach))
    release(hand, 0.5, 3.5)
    assert put == [(0, pytest.approx(0.5 * REACH))] and hand.held == NOBODY and hand.point is None
    assert hand.model.balls.energies[0] == pytest.approx(hand.model.tracks.riders.energies()[0].sum())
    press(hand, 0.0, 2.0)
    assert hand.held == NOBODY
    move(hand, 1.0, 2.0)
    release(hand, 1.0, 2.0)
    assert len(put) == 1


def test_another_button_and_moves_without_a_press_do_nothing(hand):
    assert hand.take(Pointer("down", -1.0, 4.0, button=3)) == "" and hand.point is None
    assert move(hand, -1.0, 4.0) == "" and release(hand, -1.0, 4.0) == ""
    press(hand, -1.0, 4.0, "hand")
    hand.take(Pointer("cancel", 0.0, 0.0))
    assert hand.held == NOBODY and hand.point is None


def test_places_beyond_the_world_are_at_its_end(hand):
    press(hand, -1.0, 4.0, "hand")
    move(hand, 1e9, -1e9)
    assert hand.point == (FARTHEST, -FARTHEST)
    move(hand, -1e9, 1e9)
    assert hand.model.tracks.riders.balls.rows[0, [X, Y]].tolist() == [-FARTHEST, FARTHEST]


@pytest.mark.parametrize("form", list(SHARES))
def test_a_new_ball_is_as_chosen_coloured_by_turns_and_in_the_hand(hand, form):
    hand.parameters.form, hand.parameters.radius = form, 0.25
    assert press(hand, 0.0, 2.0, "ball") == "" and hand.held == 2
    row = hand.model.tracks.riders.balls.rows[2]
    assert row[[X, Y, RADIUS]].tolist() == [0.0, 2.0, 0.25] and row[SHARE] == SHARES[form]
    assert hand.model.balls.tints.tolist()[2] == 2
    assert {"disc": 0.5, "sphere": 0.4, "ring": 1.0}[form] == row[SHARE]
    release(hand, 0.0, 2.0)
    for k in range(3, 8):
        press(hand, 0.3 * k - 2.0, 2.0)
        release(hand, 0.3 * k - 2.0, 2.0)
        assert hand.model.balls.tints[k] == k % (len(COLOURS) - 1)


def test_there_is_room_for_so_many_balls_and_tracks(hand, monkeypatch):
    monkeypatch.setattr(tracks_hand, "MOST_BALLS", 3)
    monkeypatch.setattr(TOOLS, "most_tracks", 3)
    assert press(hand, 0.0, 2.0, "ball") == ""
    release(hand, 0.0, 2.0)
    assert press(hand, 0.5, 2.0) == "There can be at most 3 balls." and len(hand.model.balls.energies) == 3
    for y, words in ((4.5, ""), (4.8, "There can be at most 3 tracks.")):
        press(hand, -2.0, y, "draw")
        move(hand, 2.0, y)
        assert release(hand, 2.0, y) == words
        assert len(hand.model.tracks.riders.curves) == 3 and hand.path == []


def test_a_path_takes_a_point_each_tenth_of_the_reach(hand):
    press(hand, 0.0, 2.0, "draw")
    move(hand, 0.1 * REACH * 0.999, 2.0)
    assert hand.path == [(0.0, 2.0)]
    move(hand, 0.1 * REACH * 1.001, 2.0)
    assert len(hand.path) == 2
    hand.path[:] = [(0.0, 2.0)]
    move(hand, 0.1 * TOOLS.reach(hand), 2.0)  # exactly a tenth is none yet
    assert len(hand.path) == 1
    assert release(hand, 0.0, 2.0) == "Drag to draw a track."
    assert len(hand.model.tracks.riders.curves) == 2


def test_a_track_is_bent_by_the_way_of_the_hand(hand):
    before = np.array(hand.model.tracks.riders.curves[1].points)
    press(hand, 0.0, 3.1, "bend")
    assert hand.held == 1
    move(hand, 0.2, 3.5)
    expected = bent(Curve(before), (0.0, 3.1), (0.2, 3.5), hand.parameters.bending)
    assert np.asarray(hand.model.tracks.riders.curves[1].points) == pytest.approx(np.asarray(expected.points))
    press(hand, 0.0, 2.0)
    assert hand.held == NOBODY and move(hand, 1.0, 2.0) == ""


def test_a_ball_goes_before_a_track_and_what_is_hit_by_neither_stays(hand):
    hand.model.tracks.hold(0, (0.0, 3.1))
    assert press(hand, 0.0, 3.0, "delete") == "" and hand.point is None
    assert len(hand.model.balls.energies) == 1 and len(hand.model.tracks.riders.curves) == 2
    press(hand, 0.0, 3.0)
    assert [float(curve.points[0][1]) for curve in hand.model.tracks.riders.curves] == [1.0]
    press(hand, 0.0, 2.0)
    assert len(hand.model.balls.energies) == 1 and len(hand.model.tracks.riders.curves) == 1


class TestCurves:
    def test_of_two_curves_the_nearer_is_found_and_of_equals_the_first(self):
        low, high = Curve([(0.0, 0.0), (1.0, 0.0)]), Curve([(0.0, 1.0), (1.0, 1.0)])
        assert nearest_curve([low, high], (0.5, 0.5), 1.0) == 0
        assert nearest_curve([low, high], (0.5, 0.51), 1.0) == 1
        assert nearest_curve([low, high], (0.5, 0.5), 0.5) == NOBODY
        assert nearest_curve([low, high], (1.3, -0.4), 0.5 + 1e-12) == 0
        assert nearest_curve([], (0.0, 0.0), 9.0) == NOBODY

    def test_a_closed_curve_has_a_side_from_its_last_point_to_its_first(self):
        points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
        assert nearest_curve([Curve(points, True)], (0.1, 1.0), 0.2) == 0
        assert nearest_curve([Curve(points)], (0.1, 1.0), 0.2) == NOBODY

    def test_points_follow_the_hand_by_a_bell_of_its_width(self):
        curve = Curve([(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)], False, 70.0)
        found = bent(curve, (1.0, 0.0), (1.5, -1.0), 2.0)
        shares = np.array([math.exp(-0.25), 1.0, math.exp(-1.0)])
        expected = np.asarray(curve.points) + shares[:, None] * (0.5, -1.0)
        assert np.asarray(found.points) == pytest.approx(expected)
        assert (found.closed, found.corner) == (False, 70.0)

    def test_a_path_is_a_curve_from_twice_the_reach_on(self):
        for length, made in ((0.199, False), (0.2, True)):
            assert (drawn([(0.0, 0.0), (length, 0.0)], 0.1) is not None) == made
        curve = drawn([(0.0, 0.0), (0.5, 0.011), (1.0, 0.0)], 0.1)
        assert len(curve.points) == 2 and curve.corner == 50.0 and not curve.closed
        assert len(drawn([(0.0, 0.0), (0.5, 0.013), (1.0, 0.0)], 0.1).points) == 3
        assert len(drawn([(0.0, 0.0), (0.5, 1.0), (1.0, 0.0), (2.0, 3.0)], 0.1, 2).points) == 2
        assert drawn([(0.0, 0.0)], 0.1) is None
