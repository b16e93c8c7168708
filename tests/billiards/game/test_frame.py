"""A frame: the cue ball in hand, a stroke under way, and the frames that one can go back to."""

import math

import pytest

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import MOST_KEPT, Frame, new_frame
from game.billiards.game.games import EightBall, Practice
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table

POOL = Table.pool()


def practice(places, **changes) -> Frame:
    """A frame of practice with balls at places."""
    game = Practice(rack="", on_table=tuple(n for n in places if n), **changes)
    return Frame(game, arrange(places), POOL)


def test_the_cue_ball_in_hand_goes_as_near_as_it_may_lie():
    frame = new_frame(EightBall(), seed=1)
    moved = frame.move_cue_ball(0.5, 1.5)  # beyond the line
    assert moved.cue_ball[1] <= HEAD_SPOT * POOL.length and frame.cue_ball != moved.cue_ball
    assert frame.move_cue_ball(0.5, 0.5).cue_ball == (0.5, 0.5)
    fixed = practice({0: (0.3, 0.3), 1: (1.0, 2.0)}, in_hand="")
    with pytest.raises(ValueError, match="not in hand"):
        fixed.move_cue_ball(0.5, 0.5)


def test_a_missing_cue_ball_is_put_on_the_head_spot_if_it_is_in_hand():
    frame = practice({1: (1.0, 2.0)}, in_hand="anywhere")
    assert frame.cue_ball is None and not frame.playable
    placed = frame.with_cue_ball()
    assert placed.cue_ball == (0.5 * POOL.width, HEAD_SPOT * POOL.length) and placed.playable
    assert placed.with_cue_ball() is placed
    gone = practice({1: (1.0, 2.0)}, in_hand="")
    assert gone.with_cue_ball() is gone


def test_a_stroke_under_way_keeps_the_balls_where_they_lay():
    frame = practice({0: (0.3, 1.27), 1: (1.0, 2.0)})
    with pytest.raises(ValueError, match="no stroke"):
        frame.outcome()
    struck = frame.strike(Stroke(1.5, math.pi))
    assert struck.layout is frame.layout and struck.strokes == 1 and struck.earlier is frame
    assert struck.last.frame.layout is frame.layout and struck.last.stroke == Stroke(1.5, math.pi)
    played = struck.outcome()
    assert played.frame.layout.numbers == (1,) and played.frame.foul and played.frame.earlier is frame
    assert played.frame.words == played.verdict.words
    with pytest.raises(ValueError, match="put down first"):
        played.frame.strike(Stroke(1.0, 0.0))
    assert played.trajectory.digest == frame.play(Stroke(1.5, math.pi)).trajectory.digest


def test_only_so_many_frames_are_kept_to_go_back_to():
    frame = practice({0: (0.3, 1.27), 1: (1.0, 2.0)})
    for _ in range(MOST_KEPT + 20):
        frame = frame.strike(Stroke(0.1, 0.0))
    count, at = 0, frame
    while at.earlier is not None:
        at = at.earlier
        count += 1
        assert at.last is None or at.last.frame.earlier is None  # a stroke holds no chain of its own
    assert count == MOST_KEPT and frame.strokes == MOST_KEPT + 20


def test_the_next_rack_cannot_be_undone():
    frame = new_frame(EightBall(), seed=3)
    over = frame.strike(Stroke(1.0, 0.0)).replace(game=EightBall(winner=0, won=(1, 0)))
    racked = over.next_rack(seed=4)
    assert racked.earlier is None and racked.last is None and racked.game.opening


def test_equal_tables_have_equal_conditions():
    one, other = new_frame(EightBall(), seed=1), new_frame(EightBall(), seed=2)
    assert one.conditions == other.conditions and hash(one.conditions) == hash(other.conditions)
    bare = one.replace(table=Table.bare(POOL.width, POOL.length))
    assert bare.conditions != one.conditions and not bare.conditions.pockets
    slow = one.replace(physics=one.physics._replace(sliding=0.5))
    assert slow.conditions != one.conditions
