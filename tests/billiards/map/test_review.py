"""The review of a stroke: what is put right pots on the exact table, and what is called the best is."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.game.games import Practice
from game.billiards.game.rules import Call
from game.billiards.map.causes import AIM, PACE, SPIN, THROW
from game.billiards.map.pool import pool_map
from game.billiards.map.review import best_pot, review
from game.billiards.search.chances import as_hand_does
from game.billiards.search.legality import board_of
from game.billiards.search.strokes import Noise
from game.billiards.table.rack import BALL_RADIUS
from game.billiards.table.table import Table

CLUB = Noise().scaled(2.8)
CORNER = math.atan2(-1.0, -1.0)  # rad, from the cue ball to the 3 and on into the pocket


def frame_of(places: dict[int, tuple[float, float]]) -> Frame:
    """Balls to practise with."""
    numbers = tuple(number for number in places if number)
    game = Practice(rack="", on_table=numbers, opening=False, set_up=(), hand="")
    return Frame(game, arrange(places), Table.pool())


STRAIGHT = {0: (0.5, 0.5), 3: (0.22, 0.22), 5: (0.9, 2.2)}
CUT = {0: (0.75, 1.95), 1: (0.22, 2.20)}


def down(frame: Frame, stroke: Stroke, ball: int) -> bool:
    """True if the ball goes down and the cue ball does not, played by the game itself."""
    summary = frame.strike(stroke, Call()).outcome().summary
    return summary.pocketing(ball) is not None and not summary.cue_pocketed


def put_right(done: Stroke, cause) -> Stroke:
    """The stroke with the change of one cause."""
    if cause.name == AIM:
        return done._replace(azimuth=done.azimuth + cause.change)
    if cause.name == PACE:
        return done._replace(cue_speed=done.cue_speed + cause.change)
    if cause.up:
        return done._replace(tip_up=done.tip_up + cause.change)
    return done._replace(tip_left=done.tip_left + cause.change)


def test_a_pot_that_goes_down_has_no_causes_and_its_chance_is_that_of_the_hand():
    frame, stroke = frame_of(STRAIGHT), Stroke(2.0, CORNER)
    found = review(frame, stroke, stroke, Call(), CLUB)
    assert found.made and found.causes == () and (found.ball, found.pocket) == (3, 0)
    board = board_of(frame)
    hand = as_hand_does(np.array([stroke]), CLUB, board.radius)
    share = np.mean([down(frame, Stroke(*one), 3) for one in hand.tolist()])
    assert found.chance == pytest.approx(share, abs=1e-12)


def test_what_was_there_is_the_surest_pot_of_the_map():
    frame, stroke = frame_of(STRAIGHT), Stroke(2.0, CORNER - 0.03)
    found = review(frame, stroke, stroke, Call(), CLUB)
    pots = pool_map(board_of(frame), CLUB).pots
    assert found.best.chance == max(pot.chance for pot in pots) >= found.chance
    assert best_pot(frame, CLUB).stroke == found.best.stroke
    assert down(frame, found.best.stroke, found.best.ball)


@pytest.mark.parametrize("turn", [-0.03, 0.035])
def test_an_aim_beside_is_found_with_its_side_and_put_right_it_pots(turn: float):
    frame, stroke = frame_of(STRAIGHT), Stroke(2.0, CORNER + turn)
    found = review(frame, stroke, stroke, Call(), CLUB)
    assert not found.made and not found.strayed and found.causes[0].name == AIM
    assert found.causes[0].change * turn < 0.0, "it is turned back"
    for cause in found.causes:
        if cause.name != THROW:
            assert down(frame, put_right(stroke, cause), 3) and not down(frame, stroke, 3)


def test_too_soft_is_a_matter_of_speed():
    frame = frame_of({0: (0.8, 0.8), 3: (0.5, 0.5)})
    slow = next(
        stroke
        for stroke in (Stroke(v, CORNER, 0.0, 0.0, -0.4) for v in np.arange(1.5, 0.1, -0.02).tolist())
        if not down(frame, stroke, 3)
    )
    found = review(frame, slow, slow, Call(), CLUB)
    pace = next(cause for cause in found.causes if cause.name == PACE)
    assert pace.change > 0.0 and down(frame, put_right(slow, pace), 3)


def test_a_hand_that_strayed_is_told_by_what_was_meant():
    frame = frame_of(STRAIGHT)
    meant, done = Stroke(2.0, CORNER), Stroke(2.2, CORNER + 0.03, 0.0, 0.02)
    found = review(frame, meant, done, Call(), CLUB)
    assert found.strayed and not found.made
    assert [cause.name for cause in found.causes] == [AIM], "speed and spin put right alone do not pot"
    assert found.causes[0].change == pytest.approx(-0.03)
    assert found.causes[0].size == pytest.approx(0.03 / CLUB.azimuth)


def test_throw_is_a_cause_where_the_ball_falls_without_friction():
    frame = frame_of(CUT)
    thrown = [
        stroke
        for stroke in (Stroke(1.0, angle) for angle in np.linspace(2.72, 2.82, 200).tolist())
        if not down(frame, stroke, 1)
        and THROW in [cause.name for cause in review(frame, stroke, stroke, Call(), CLUB).causes]
    ][:1]
    assert thrown, "cuts that throw takes off"
    smooth = frame.replace(physics=frame.physics._replace(ball_ball="elastic", ball_friction=0.0))
    assert down(smooth, thrown[0], 1) and not down(frame, thrown[0], 1)


def test_no_pot_was_tried_by_a_stroke_at_a_cushion_or_a_safety():
    frame = frame_of(STRAIGHT)
    cushion = Stroke(2.0, 0.1)
    assert review(frame, cushion, cushion, Call(), CLUB).ball is None
    pot = Stroke(2.0, CORNER)
    assert review(frame, pot, pot, Call(safety=True), CLUB).ball is None
    assert SPIN not in [cause.name for cause in review(frame, pot, pot, Call(), CLUB).causes]


def test_a_ball_that_follows_its_ball_down_is_a_foul_and_a_lower_tip_puts_it_right():
    frame, follow = frame_of(STRAIGHT), Stroke(2.0, CORNER, 0.0, 0.0, 0.1)
    found = review(frame, follow, follow, Call(), CLUB)
    assert found.foul and not found.made and found.pocket == 0
    assert frame.strike(follow, Call()).outcome().summary.cue_pocketed
    for cause in found.causes:
        assert down(frame, put_right(follow, cause), 3)


def test_a_ball_that_is_missed_by_a_little_was_tried_all_the_same():
    frame = frame_of(STRAIGHT)
    reach = math.asin(2.0 * BALL_RADIUS / math.dist(STRAIGHT[0], STRAIGHT[3]))
    for beside, ball in ((math.radians(0.8), 3), (math.radians(4.0), None)):
        stroke = Stroke(2.0, CORNER + reach + beside)
        assert frame.strike(stroke, Call()).outcome().summary.first == ()
        assert review(frame, stroke, stroke, Call(), CLUB).ball == ball
