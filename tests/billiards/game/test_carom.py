"""Rules of carom, case by case, as a referee would write them down."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import new_carom, points_of
from game.billiards.game.carom_summary import CaromSummary
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_zones import ENTERED, INSIDE
from game.billiards.table.carom import (
    BALL_RADIUS,
    BOTTOM_SPOT,
    CENTRE_SPOT,
    RED,
    TOP_SPOT,
    WHITE,
    YELLOW,
    starting_position,
)

D = 2.0 * BALL_RADIUS
APART = np.array([[0.3, 0.4], [1.0, 1.3], [0.5, 2.2]])
LETTERS = {"w": ("ball", WHITE), "y": ("ball", YELLOW), "r": ("ball", RED)} | {
    letter: ("cushion", rail) for rail, letter in enumerate("<>_^")
}


def did(path, rest=APART, **more):
    """A summary; the path in letters: balls w y r, cushions < > _ ^."""
    return CaromSummary(tuple(LETTERS[letter] for letter in path), np.array(rest), **more)


def game(kind="three-cushion", **fields):
    return Carom(kind=kind, **({"opening": False} | fields))


# -- what a point is --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "path", "scores"),
    [
        ("straight-rail", "ry", True),
        ("straight-rail", "yr", True),
        ("straight-rail", "<y_r", True),
        ("straight-rail", "rrr", False),
        ("straight-rail", "r<^", False),
        ("straight-rail", "", False),
        ("one-cushion", "ry", False),
        ("one-cushion", "ry<", False),
        ("one-cushion", "r<y", True),
        ("one-cushion", "<ry", True),
        ("three-cushion", "r<^>y", True),
        ("three-cushion", "<^>ry", True),
        ("three-cushion", "<^>r_y", True),
        ("three-cushion", "<r^>y", True),
        ("three-cushion", "<^r>y", True),
        ("three-cushion", "r<^y>", False),
        ("three-cushion", "r<>y", False),
        ("three-cushion", "r<<<y", True),  # three impacts, not three different cushions
        ("three-cushion", "r<r^r>y", True),
        ("three-cushion", "<^>r", False),
    ],
)
def test_points(kind, path, scores):
    verdict = game(kind).judge(did(path))
    assert verdict.scored == scores
    assert verdict.game.points == ((1, 0) if scores else (0, 0))
    assert verdict.game.turn == (0 if scores else 1)


@pytest.mark.parametrize(
    ("path", "more", "said"),
    [
        ("r<^y", {}, "Only 2 of 3 cushions before the second ball."),
        ("<^>", {}, "Not touched: yellow and red."),
        ("r<^>y", {"into": (RED,)}, "The cue ball was played into the red ball it touched."),
    ],
)
def test_a_stroke_without_a_point_says_why(path, more, said):
    words = game().judge(did(path, **more)).words
    assert words[0] == said and not any("Only" in one or "Not" in one for one in words[1:])


def test_the_second_player_plays_the_yellow_ball():
    verdict = game(turn=1, innings=(1, 1)).judge(did("r<^>w"))
    assert verdict.game.points == (0, 1)
    assert game(turn=1, innings=(1, 1)).judge(did("r<^>y")).scored is False


def test_run_innings_average_high_run():
    now = game(target=0)
    for path in ("r<^>y", "r<^>y", "r", "w", "r<^>y", ""):
        now = now.judge(did(path)).game
    assert (now.points, now.innings, now.high_runs, now.run, now.turn) == ((3, 0), (2, 2), (2, 0), 0, 1)
    assert now.average(0) == 1.5 and now.average(1) == 0.0
    assert Carom().average(1) == 0.0


def test_points_of_a_head_start_are_none_of_the_average():
    now = game(target=0, points=(4, 0), given=(4, 0))
    for path in ("r<^>y", "r<^>y", "r", "w", "r<^>y", ""):
        now = now.judge(did(path)).game
    assert (now.points, now.innings, now.high_runs) == ((7, 0), (2, 2), (2, 0))
    assert (now.average(0), now.average(1)) == (1.5, 0.0)
    ended = msgspec.structs.replace(now, ended=True).next_game().game
    assert (ended.points, ended.given, ended.average(0)) == ((0, 0), (0, 0), 0.0)


# -- the beginning ----------------------------------------------------------------------------------


@pytest.mark.parametrize(("path", "foul"), [("r<^>y", False), ("y<^>r", True), ("<r^>y", True), ("", True)])
def test_from_the_starting_position_the_red_ball_comes_first_directly(path, foul):
    verdict = Carom().judge(did(path))
    assert [f.kind for f in verdict.fouls] == (["opening"] if foul else [])
    assert verdict.scored is not foul
    assert verdict.game.opening is False


def test_players_begin_in_turns():
    verdict = game(ended=True, points=(15, 3), won=(1, 0)).next_game()
    after = verdict.game
    assert (after.turn, after.breaker, after.points, after.innings, after.won) == (
        1,
        1,
        (0, 0),
        (0, 1),
        (1, 0),
    )
    assert after.opening and not after.ended
    assert (verdict.places == starting_position(YELLOW)).all()


# -- balls that touch -------------------------------------------------------------------------------


def touching_pair(kind, ball=RED):
    rest = APART.copy()
    rest[ball] = rest[WHITE] + (D, 0.0)
    verdict = game(kind).judge(did("r<^>y", rest))
    assert verdict.scored
    return verdict


@pytest.mark.parametrize("kind", ["straight-rail", "one-cushion", "three-cushion"])
def test_a_player_whose_ball_touches_another_chooses(kind):
    verdict = touching_pair(kind)
    assert [option.name for option in verdict.game.options] == ["away", "spots"]
    with pytest.raises(ValueError, match="must choose"):
        verdict.game.judge(did("r<^>y"))
    away = verdict.game.choose("away", verdict.places)
    assert away.game.options == () and (away.places == verdict.places).all()
    with pytest.raises(ValueError, match="nothing to choose"):
        away.game.choose("spots", away.places)


def test_three_cushion_puts_only_the_touching_balls_back():
    verdict = touching_pair("three-cushion")
    back = verdict.game.choose("spots", verdict.places)
    assert back.places.tolist() == [list(BOTTOM_SPOT), APART[YELLOW].tolist(), list(TOP_SPOT)]
    assert not back.game.opening
    verdict = touching_pair("three-cushion", YELLOW)
    back = verdict.game.choose("spots", verdict.places)
    assert back.places.tolist() == [list(BOTTOM_SPOT), list(CENTRE_SPOT), APART[RED].tolist()]


@pytest.mark.parametrize("kind", ["straight-rail", "one-cushion"])
def test_other_games_begin_again_with_all_three(kind):
    verdict = touching_pair(kind)
    back = verdict.game.choose("spots", verdict.places)
    assert (back.places == starting_position(WHITE)).all() and back.game.opening


def test_object_balls_that_touch_each_other_are_left():
    rest = APART.copy()
    rest[RED] = rest[YELLOW] + (D, 0.0)
    assert game().judge(did("r<^>y", rest)).game.options == ()
    assert len(game().judge(did("r", rest)).game.options) == 2  # but they do touch the next player's ball


def test_a_ball_that_touches_must_not_be_played_into():
    verdict = game().judge(did("r<^>y", into=(RED,)))
    assert not verdict.scored and [f.kind for f in verdict.fouls] == ["touching"]
    assert verdict.game.turn == 1


# -- balls off the table ----------------------------------------------------------------------------


def test_a_ball_off_the_table_is_a_foul_and_comes_back():
    verdict = game().judge(did("r<^>y", off_table=(RED, WHITE)))
    assert not verdict.scored and verdict.game.turn == 1
    # the next player's ball would be put below, the ball of the one who played in the centre
    assert verdict.places.tolist() == [list(CENTRE_SPOT), APART[YELLOW].tolist(), list(TOP_SPOT)]
    assert not verdict.game.opening


@pytest.mark.parametrize("kind", ["straight-rail", "one-cushion"])
def test_in_other_games_all_begin_again_after_a_ball_left(kind):
    verdict = game(kind).judge(did("r<y", off_table=(YELLOW,)))
    assert (verdict.places == starting_position(YELLOW)).all() and verdict.game.opening


# -- the end ----------------------------------------------------------------------------------------


def test_who_begins_and_reaches_the_target_grants_a_last_inning():
    verdict = game(target=3, points=(2, 1), innings=(4, 3)).judge(did("r<^>y"))
    last = verdict.game
    assert verdict.scored and not last.ended
    assert (last.turn, last.opening, last.innings, last.points) == (1, True, (4, 4), (3, 1))
    assert (verdict.places == starting_position(YELLOW)).all()
    missed = last.judge(did("w"))
    assert missed.game.ended and missed.game.winner == 0 and missed.game.won == (1, 0)
    scored = last.judge(did("r<^>w"))
    assert scored.scored and not scored.game.ended and scored.game.turn == 1
    level = scored.game.judge(did("r<^>w")).game
    assert level.ended and level.winner is None and level.points == (3, 3)


def test_who_begins_second_ends_it_at_once():
    after = game(target=3, turn=1, points=(1, 2), innings=(4, 4)).judge(did("r<^>w")).game
    assert after.ended and after.winner == 1


def test_without_equality_of_innings_the_target_ends_it():
    after = game(target=3, points=(2, 2), equalise=False).judge(did("r<^>y")).game
    assert after.ended and after.winner == 0
    with pytest.raises(ValueError, match="over"):
        after.judge(did("r"))


def test_a_limit_of_innings():
    now = game(most_innings=2, innings=(2, 1), points=(3, 2), target=0)
    now = now.judge(did("r")).game
    assert not now.ended and now.innings == (2, 2)
    drawn = now.judge(did("r<^>w")).game.judge(did("r")).game
    assert drawn.ended and drawn.winner is None
    lost = now.judge(did("")).game
    assert lost.ended and lost.winner == 0


def test_one_player_plays_on():
    now = game(
        players=("Player",), points=(0,), innings=(1,), high_runs=(0,), safeties=(0,), won=(0,), target=0
    )
    now = now.judge(did("r<^>y")).game.judge(did("")).game
    assert (now.turn, now.points, now.innings, now.run) == (0, (1,), (2,), 0)


def test_practice_goes_on_with_the_same_ball():
    now = game("one-cushion", turn=1, innings=(3, 3), points=(4, 2)).alone()
    assert (now.cue, now.kind, now.points, now.target) == (YELLOW, "one-cushion", (0,), 0)
    after = now.judge(did("r<w")).game.judge(did("")).game
    assert (after.cue, after.points, after.innings, after.ended) == (YELLOW, (1,), (2,), False)


# -- safeties ---------------------------------------------------------------------------------------


def test_a_safety_scores_nothing_and_passes():
    verdict = game().judge(did("r<^>y"), safety=True)
    assert not verdict.scored and not verdict.fouls
    assert verdict.game.turn == 1 and verdict.game.safeties == (1, 0)


def test_a_safety_must_touch_a_ball():
    assert [f.kind for f in game().judge(did("<^>"), safety=True).fouls] == ["no contact"]


def test_a_second_safety_in_a_row_lets_the_other_choose():
    verdict = game(safeties=(1, 0)).judge(did("r"), safety=True)
    assert [f.kind for f in verdict.fouls] == ["safety"]
    assert [option.name for option in verdict.game.options] == ["accept", "start"]
    start = verdict.game.choose("start", verdict.places)
    assert (start.places == starting_position(YELLOW)).all() and start.game.opening
    accept = verdict.game.choose("accept", verdict.places)
    assert (accept.places == verdict.places).all() and not accept.game.options
    assert game(safeties=(1, 0)).judge(did("r")).game.safeties == (0, 0)  # another stroke between
    assert not game(safeties=(1, 0), most_safeties=2).judge(did("r"), safety=True).fouls


# -- the barred corners of straight rail ------------------------------------------------------------

CORNERED = np.array([[0.5, 0.5], [0.1, 0.1], [0.1, 0.2]])


def test_two_points_in_a_corner_then_a_ball_must_leave_it():
    entered = game("straight-rail").judge(did("ry", CORNERED)).game
    assert entered.inside == ENTERED
    inside = entered.judge(did("ry", CORNERED)).game
    assert inside.inside == INSIDE
    barred = inside.judge(did("ry", CORNERED))
    assert not barred.scored and [f.kind for f in barred.fouls] == ["corner"]
    back = inside.judge(did("ry", CORNERED, left_corner=(RED,)))
    assert back.scored and back.game.inside == ENTERED  # out and in again
    assert inside.judge(did("ry", APART, left_corner=(RED,))).game.inside == 0


def test_cushion_games_have_no_barred_corners():
    assert game("one-cushion", inside=INSIDE).judge(did("r<y", CORNERED)).scored


def test_a_player_who_comes_to_such_a_position_has_entered():
    rest = np.array([[0.1, 0.1], [0.5, 0.5], [0.1, 0.2]])
    assert game("straight-rail").judge(did("r", rest)).game.inside == ENTERED


# -- strokes on the table ---------------------------------------------------------------------------


def test_a_stroke_is_judged_by_what_the_balls_did():
    frame = new_carom(Carom(kind="straight-rail", opening=False)).replace(
        places=((0.3, 1.0), (0.9, 1.3), (0.7, 1.0))
    )
    cut = math.asin(0.8 * D / 0.4)
    found = [
        frame.play(Stroke(2.0, aim, 0.0, 0.0, up))
        for aim in np.linspace(-cut, cut, 41).tolist()
        for up in (0.0, 0.3)
    ]
    scored = [played for played in found if played.verdict.scored]
    assert scored and len(scored) < len(found)
    for played in scored:
        balls = [number for kind, number in played.summary.path if kind == "ball"]
        assert {YELLOW, RED} <= set(balls)
        assert played.frame.game.points == (1, 0)
        assert played.frame.earlier is not None and played.frame.strokes == 1


def test_the_cushion_that_the_cue_ball_lies_against_does_not_count():
    places = ((BALL_RADIUS, 1.0), (1.3, 2.7), (1.3, 0.1))
    frame = new_carom(Carom(opening=False)).replace(places=places)
    into = frame.play(Stroke(2.0, math.pi)).summary  # straight into the left rail, back to the right one
    assert into.path[0] == ("cushion", 1)
    free = frame.replace(places=((BALL_RADIUS + 1e-3, 1.0), *places[1:]))
    assert free.play(Stroke(2.0, math.pi)).summary.path[0] == ("cushion", 0)


@pytest.mark.parametrize("gap", [0.0, 5e-5])
def test_a_ball_that_touches_is_played_into_or_left_alone(gap):
    places = ((0.5, 1.0), (1.2, 2.0), (0.5 + D + gap, 1.0))
    frame = new_carom(Carom(opening=False)).replace(places=places)
    assert frame.play(Stroke(2.0, 0.0)).summary.into == (RED,)
    assert frame.play(Stroke(2.0, 2.5)).summary.into == ()
    apart = frame.replace(places=(*places[:2], (0.5 + D + 1e-3, 1.0)))
    assert apart.play(Stroke(2.0, 0.0)).summary.into == ()


def test_a_ball_seen_outside_its_corner_has_left_it():
    frame = new_carom(Carom(kind="straight-rail", opening=False)).replace(
        places=((0.05, 0.10), (0.05, 0.60), (0.15, 0.10))
    )
    soft = frame.play(Stroke(0.1, 0.0)).summary
    hard = frame.play(Stroke(3.0, 0.0)).summary
    assert RED in hard.left_corner and soft.left_corner == ()


def test_strokes_from_a_game_with_an_open_choice_are_refused():
    frame = new_carom(Carom(ended=True))
    with pytest.raises(ValueError, match="over"):
        frame.strike(Stroke(1.0, 0.0))
    assert points_of(frame.positions) == frame.places
