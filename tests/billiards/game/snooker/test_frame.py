"""Frames of snooker on the exact table: strokes, placing, respotting, put back, what the referee sees."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.game.snooker.frame import (
    SnookerFrame,
    curves_of,
    nearest_gap,
    new_snooker_frame,
    pushes,
)
from game.billiards.game.snooker.rules import new_snooker
from game.billiards.laws.state import BALL_BALL, IN_X, IN_Y
from game.billiards.table.snooker import (
    BALL_RADIUS,
    COLOURS,
    FROZEN,
    MIDDLE,
    SPOTS,
    in_the_d,
    touching,
)
from tests.billiards.game.snooker.referee import BLACK, BLUE, game, order

R = BALL_RADIUS


def lying(state, **places) -> SnookerFrame:
    """A frame with balls at places, by the names of the referee's table: c the cue ball, b21 the black."""
    numbers = {0 if name == "c" else int(name[1:]): at for name, at in places.items()}
    return new_snooker_frame(msgspec.structs.replace(state, on_table=tuple(n for n in numbers if n)), numbers)


def towards(frame, ball, speed, aside=0.0):
    """A stroke at a ball, ``aside`` of a finest cut (-1 to 1)."""
    (x, y), (px, py) = frame.cue_ball, frame.layout.place_of(ball)
    half = math.asin(2.0 * R / math.hypot(px - x, py - y))
    return Stroke(speed, math.atan2(py - y, px - x) + aside * half)


def test_the_break_opens_the_pack_of_fifteen():
    frame = new_snooker_frame(new_snooker())
    played = frame.play(towards(frame.move_cue_ball(MIDDLE + 0.2, 0.7), 15, 6.0))
    assert played.trajectory.end_time < 60.0
    moved = [
        ball for ball, x, y in played.frame.layout.places
        if 1 <= ball <= 15 and math.dist((x, y), frame.layout.place_of(ball)) > 1e-3
    ]  # fmt: skip
    assert len(moved) >= 8
    contacts = played.trajectory.rows[played.trajectory.rows[:, 1] == BALL_BALL]
    assert len(contacts) > 15


@pytest.mark.parametrize("seed", range(6))
def test_random_strokes_keep_what_must_hold(seed):
    """Balls stay on the bed or fall, none overlaps, the rules' balls are those that lie there."""
    rng = np.random.default_rng(seed)
    frame = new_snooker_frame(new_snooker(reds=(15, 6)[seed % 2]))
    total = 0
    for _ in range(25):
        state = frame.snooker
        if state.options:
            names = [option.name for option in state.options]
            frame = frame.choose(names[rng.integers(len(names))]).with_cue_ball()
            continue
        if state.over:
            frame = frame.next_rack().with_cue_ball()
            continue
        call = Call(int(rng.choice(COLOURS))) if state.needs_call() else Call()
        played = frame.play(
            Stroke(rng.uniform(0.5, 7.0), rng.uniform(0.0, math.tau), 0.0, *rng.uniform(-0.4, 0.4, 2)), call
        )
        assert np.isfinite(played.trajectory.end[:, [IN_X, IN_Y]]).all()
        frame = played.frame.with_cue_ball()
        places = frame.places_by_number
        assert set(places) - {0} == set(frame.game.on_table)
        at = np.array(list(places.values()))
        gaps = np.hypot(*(at[:, None] - at[None]).transpose(2, 0, 1)) + 9.0 * np.eye(len(at))
        assert gaps.min() > 2.0 * R - 1e-6
        assert (at > -0.045).all() and (at < (1.778 + 0.045, 3.569 + 0.045)).all()
        assert sum(frame.snooker.points) >= total or state.opening
        total = sum(frame.snooker.points)


def test_a_straight_ball_falls_into_each_pocket_and_the_jaws_reject_a_wide_one():
    for pocket in range(6):
        table = new_snooker_frame(new_snooker()).table
        px, py, _ = table.pockets[pocket]
        inward = np.array([MIDDLE - px, (0.5 * 3.569 - py) or 0.0])
        inward[1] = (
            np.sign(inward[1]) * abs(inward[0]) if abs(inward[1]) > 0.1 else 0.0
        )  # 45 degrees at a corner
        inward /= np.hypot(*inward)
        ball, cue = np.array((px, py)) + 0.35 * inward, np.array((px, py)) + 0.75 * inward
        frame = lying(order(BLACK), c=tuple(cue), b21=tuple(ball))
        assert frame.play(towards(frame, BLACK, 1.5)).summary.balls_down == (BLACK,), pocket
        wide = frame.play(towards(frame, BLACK, 1.5, 0.35))
        assert BLACK not in wide.summary.balls_down, pocket


def test_the_cue_ball_is_placed_in_the_d_touching_nothing():
    frame = new_snooker_frame(new_snooker())
    for asked in ((0.1, 3.0), SPOTS[18], (MIDDLE + 0.29, 0.73), (1.7, 0.1)):
        placed = frame.move_cue_ball(*asked)
        assert in_the_d(*placed.cue_ball) and not touching(placed.places_by_number)
    for wrong in ((0.1, 0.1), SPOTS[18], (MIDDLE, 0.8)):
        with pytest.raises(ValueError, match="not free"):
            frame.place_cue_ball(*wrong)
    with pytest.raises(ValueError, match="not in hand"):
        lying(game(), c=(0.9, 1.2), b1=(0.5, 2.0)).move_cue_ball(0.9, 0.6)


def test_a_potted_colour_lies_on_its_spot_again():
    frame = lying(game(stage="colour"), c=(0.36, 3.2), b1=(1.5, 1.5), b19=(0.18, 3.38), b21=SPOTS[BLACK])
    played = frame.play(towards(frame, BLUE, 1.5), Call(BLUE))
    assert played.summary.balls_down == (BLUE,) and played.verdict.game.points == (5, 0)
    assert played.frame.layout.place_of(BLUE) == SPOTS[BLUE]


def test_a_miss_puts_every_ball_back_to_where_it_lay():
    frame = lying(game(), c=(0.9, 1.2), b1=(0.5, 2.0), b19=(0.9, 1.5), b21=SPOTS[BLACK])
    fouled = frame.play(towards(frame, BLUE, 2.0)).frame
    assert fouled.layout.places != frame.layout.places
    again = fouled.choose("replay")
    assert again.layout.places == frame.layout.places and again.game.turn == 0
    assert fouled.choose("play").layout.places == fouled.layout.places


def test_a_level_frame_leaves_the_black_alone_with_the_cue_ball_in_hand():
    frame = lying(order(BLACK, points=(40, 47)), c=(0.36, 3.2), b21=(0.18, 3.38))
    played = frame.play(towards(frame, BLACK, 1.5))
    assert played.summary.balls_down == (BLACK,)
    after = played.frame.with_cue_ball()
    assert after.layout.place_of(BLACK) == SPOTS[BLACK] and in_the_d(*after.cue_ball)
    assert after.layout.numbers == (0, BLACK) and after.snooker.black_again


def test_playing_away_from_a_touching_ball_and_into_it():
    at = (0.9, 1.2)
    frame = lying(game(), c=at, b1=(0.9, 1.2 + 2.0 * R), b19=(0.3, 0.6), b21=SPOTS[BLACK])
    away = frame.play(Stroke(1.0, -0.5 * math.pi + 0.2))
    assert away.verdict.legal and away.frame.layout.place_of(1) == pytest.approx((0.9, 1.2 + 2.0 * R))
    into = frame.play(Stroke(1.0, 0.5 * math.pi))
    assert [foul.kind for foul in into.verdict.fouls] == ["push stroke"]


def test_a_ball_almost_touching_is_pushed_unless_it_is_cut_finely():
    gap = FROZEN * 4.0
    frame = lying(game(), c=(0.9, 1.2), b1=(0.9, 1.2 + 2.0 * R + gap), b21=SPOTS[BLACK])
    full = frame.play(Stroke(2.0, 0.5 * math.pi))
    assert [foul.kind for foul in full.verdict.fouls] == ["push stroke"]
    fine = frame.play(Stroke(2.0, 0.5 * math.pi + 1.40))
    assert fine.summary.first == (1,) and fine.verdict.legal
    far = lying(game(), c=(0.9, 1.2), b1=(0.9, 1.3), b21=SPOTS[BLACK])
    assert far.play(Stroke(2.0, 0.5 * math.pi)).verdict.legal
    assert not pushes(full.trajectory, {0: (0.9, 1.2), 1: (0.9, 1.2 + 2.0 * R)})  # touching: judged by itself


def test_how_near_the_cue_ball_came_is_measured_along_its_path():
    frame = lying(game(), c=(0.4, 1.0), b1=(0.9, 1.0 + 2.0 * R + 0.03), b21=SPOTS[BLACK])
    short = frame.play(Stroke(0.1, 0.0))  # stops before it is abreast of the red
    x, _ = short.frame.layout.place_of(0)
    assert x < 0.9 and not short.summary.first
    apart = math.hypot(0.9 - x, 2.0 * R + 0.03) - 2.0 * R
    assert nearest_gap(short.trajectory, (1,)) == pytest.approx(apart, abs=1e-9)
    past = frame.play(Stroke(0.6, 0.0))
    assert nearest_gap(past.trajectory, (1,)) == pytest.approx(0.03, abs=1e-6)
    assert nearest_gap(past.trajectory, ()) == math.inf
    assert len(curves_of(frame.table)) == 12


def test_the_same_is_played_from_a_saved_frame():
    frame = new_snooker_frame(new_snooker())
    stroke = towards(frame, 11, 3.0, 0.5)
    saved = msgspec.convert(msgspec.to_builtins(frame.game), type(frame.game))
    again = new_snooker_frame(saved, frame.places_by_number)
    assert again.play(stroke).trajectory.digest == frame.play(stroke).trajectory.digest
