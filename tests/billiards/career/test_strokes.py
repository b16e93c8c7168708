"""What is counted of strokes: geometry in closed form, classes, the CSV text."""

import csv
import io
import math

import pytest

from game.billiards.career.strokes import (
    BREAK,
    CHANCES,
    CUTS,
    DISTANCES,
    POINT,
    POT,
    WAYS,
    StrokeFact,
    by_opponent,
    csv_of,
    shares,
    summary_of,
    summary_words,
)  # fmt: skip
from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import new_frame
from game.billiards.game.games import EightBall
from game.billiards.map.stroke_facts import measured
from game.billiards.table.rack import BALL_RADIUS


def fact(distance=0.5, cut=10.0, made=True, chance=0.5, opponent="tom", kind=POT, stray=None, speed=2.0):
    return StrokeFact(
        "2026-01-01T10:00:00", "eight-ball", opponent, kind, distance, cut, made, chance, stray, speed
    )


def test_shares_are_of_their_classes():
    facts = [
        fact(0.1),
        fact(0.3, made=False, chance=0.7),
        fact(1.0, cut=50.0),
        fact(kind=BREAK, distance=0.1),
    ]
    near, far = shares(facts, DISTANCES)
    assert (near.pots, near.made, near.expected) == (2, 0.5, pytest.approx(0.6))
    assert (far.middle, far.pots, far.made) == (pytest.approx(1.0), 1, 1.0)
    assert [one.pots for one in shares(facts, CUTS, "cut")] == [2, 1]


def test_a_figure_on_the_edge_of_two_classes_is_of_the_upper_one():
    (found,) = shares([fact(DISTANCES[1])], DISTANCES)
    assert DISTANCES[1] < found.middle < DISTANCES[2]


def test_points_of_carom_have_classes_of_their_own():
    points = [fact(kind=POINT, chance=chance, made=chance > 0.3) for chance in (0.05, 0.4, 1.0)]
    assert [one.made for one in shares(points, CHANCES, "chance", POINT)] == [0.0, 1.0, 1.0]
    assert [one.middle for one in shares(points, WAYS, "cushions", POINT)] == [0.5]
    assert shares(points, DISTANCES) == []
    assert "2 of 3 points, 1.4 expected" in summary_words("all", summary_of(points))
    assert "pots" not in summary_words("all", summary_of(points))


def test_a_summary_leaves_out_what_was_not_measured():
    facts = [
        fact(stray=0.1),
        fact(made=False, stray=0.3),
        fact(kind=BREAK, speed=6.0),
        fact(kind=BREAK, speed=8.0),
    ]
    found = summary_of(facts)
    assert found == (2, 1, 1.0, pytest.approx(0.2), 7.0, 0, 0, 0.0)
    assert math.isnan(summary_of([]).stray)
    assert set(by_opponent([*facts, fact(opponent="vera")])) == {"tom", "vera"}


def test_the_csv_is_read_back_with_every_stroke():
    rows = list(csv.DictReader(io.StringIO(csv_of([fact(stray=0.25), fact(made=False)]))))
    assert [row["made"] for row in rows] == ["1", "0"]
    assert [row["position_error_m"] for row in rows] == ["0.2500", ""]
    figures = ("distance_m", "cut_deg", "chance", "cue_speed_m_s", "cushions_first")
    assert [float(rows[0][name]) for name in figures] == [0.5, 10.0, 0.5, 2.0, 0.0]


def frame_with(cue, ball):
    frame = new_frame(EightBall(opening=False, in_hand="", on_table=(3,)), seed=1)
    return frame.replace(layout=arrange({0: cue, 3: ball}, frame.layout.balls))


def test_distance_cut_and_stray_of_a_stroke_in_closed_form():
    width = 1.27
    frame = frame_with((0.5 * width, 0.8), (0.5 * width, 1.4))
    meant = Stroke(1.0, 0.5 * math.pi)
    straight = measured(frame, frame.play(meant), meant)
    assert straight.distance == pytest.approx(0.6 - 2.0 * BALL_RADIUS)
    assert straight.cut == pytest.approx(0.0, abs=1e-6)
    assert straight.stray is None
    assert straight.kind == POT
    aside = Stroke(1.0, 0.5 * math.pi + math.asin(BALL_RADIUS / 0.6))  # half a ball: sin of the cut is 1/2
    thin = measured(frame, frame.play(aside), aside)
    assert thin.cut == pytest.approx(30.0, abs=1e-6)
    strayed = measured(frame, frame.play(aside), meant)
    assert strayed.cut == pytest.approx(0.0, abs=1e-6)
    assert strayed.stray > 0.05
    nowhere = Stroke(1.0, -0.5 * math.pi)
    assert measured(frame, frame.play(nowhere), nowhere) is None


def test_a_pot_is_seen_and_its_chance_falls_with_the_distance():
    near = frame_with((0.25, 0.25), (0.12, 0.12))
    stroke = Stroke(1.0, math.radians(225.0))
    made = measured(near, near.play(stroke), stroke)
    assert made.made
    far = frame_with((1.0, 1.0), (0.6, 0.6))
    long = measured(far, far.play(stroke), stroke)
    assert 0.0 < long.chance < made.chance <= 1.0
