"""Artistic billiards: figures, the ways they ask for, attempts, points, and who wins."""

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import new_carom
from game.billiards.game.games.artistic import ATTEMPTS, AnyCarom, Artistic, route_of
from game.billiards.game.games.artistic_figures import FIGURES, LETTERS
from game.billiards.players.carom import CAROM_GRADES, decide_carom, position_of
from game.billiards.table.carom import RED, YELLOW, fits
from tests.billiards.game.test_carom import did

FIRST = FIGURES[0]


def at(figure: int, **fields) -> Artistic:
    return Artistic(figure=figure, **fields)


@pytest.mark.parametrize("number", range(len(FIGURES)), ids=lambda k: FIGURES[k].name)
def test_every_figure_can_be_made_by_its_stroke_and_by_no_other_way(number):
    figure = FIGURES[number]
    frame = new_carom(at(number))
    assert fits(frame.positions) and 4 <= figure.points <= 11 and set(figure.route) <= set(LETTERS)
    played = frame.play(figure.stroke)
    assert played.verdict.scored and route_of(played.summary) == figure.route
    assert played.frame.game.points == (figure.points, 0)
    wide = figure.stroke._replace(azimuth=figure.stroke.azimuth + 0.7)
    assert not frame.play(wide).verdict.scored


def test_the_search_reads_the_same_way_from_a_stroke():
    for number, figure in enumerate(FIGURES):
        position = position_of(new_carom(at(number)))
        routes = position.play(np.array([figure.stroke, Stroke(1.0, -1.5)]))
        assert position.wanted.scores(routes).tolist() == [True, False], figure.name
        another = position.wanted._replace(code=position.wanted.code + 1)
        assert not another.scores(routes).any(), "a cannon by another way scores nothing"


def test_a_cannon_by_another_way_is_an_attempt_that_failed():
    verdict = at(0).judge(did("<ry"))
    assert not verdict.scored and not verdict.fouls
    assert (verdict.game.turn, verdict.game.attempts, verdict.game.points) == (0, 1, (0, 0))
    assert (verdict.places == at(0).start()).all()


def test_a_ball_met_twice_with_nothing_between_is_one_touch():
    assert route_of(did("rry")) == "ry" and route_of(did("r>>y")) == "r>>y"
    assert route_of(did("r<")) == ""


def test_after_three_attempts_the_other_plays_the_same_figure():
    game = at(0)
    for count in range(ATTEMPTS):
        assert (game.turn, game.attempts) == (0, count)
        game = game.judge(did("r")).game
    assert (game.turn, game.attempts, game.figure, game.innings) == (1, 0, 0, (1, 1))


def test_a_figure_that_is_made_is_not_tried_again():
    verdict = at(0, attempts=1).judge(did("ry"))
    assert verdict.scored and verdict.game.points == (FIRST.points, 0)
    assert (verdict.game.turn, verdict.game.figure, verdict.game.high_runs) == (1, 0, (1, 0))
    following = verdict.game.judge(did("ry"))
    assert (following.game.turn, following.game.figure) == (0, 1)
    assert (following.places == at(1).start()).all() and FIGURES[1].name in " ".join(following.words)


def test_both_play_the_white_ball():
    assert at(0, turn=1, innings=(1, 1)).cue == 0
    assert at(0, turn=1, innings=(1, 1)).judge(did("ry")).game.points == (0, FIRST.points)


@pytest.mark.parametrize(
    ("shot", "kind"),
    [(did("ry", off_table=(YELLOW,)), "off the table"), (did("ry", into=(RED,)), "touching")],
)
def test_a_foul_makes_no_figure(shot, kind):
    verdict = at(0).judge(shot)
    assert not verdict.scored and [foul.kind for foul in verdict.fouls] == [kind]
    assert verdict.game.attempts == 1


@pytest.mark.parametrize(("points", "winner"), [((10, 0), 0), ((0, 30), 1), ((11, 0), None)])
def test_after_the_last_figure_more_points_win(points, winner):
    last = len(FIGURES) - 1
    game = at(last, turn=1, points=points, attempts=2, innings=(12, 12))
    verdict = game.judge(did("ry") if winner == 1 else did("r>^<_><^y") if winner is None else did("r"))
    assert verdict.game.over and verdict.game.winner == winner
    with pytest.raises(ValueError, match="over"):
        verdict.game.judge(did("ry"))
    again = verdict.game.next_game().game
    assert isinstance(again, Artistic) and (again.figure, again.points, again.turn) == (0, (0, 0), 1)


def test_a_match_is_kept_and_read_again():
    game = at(3, attempts=2, turn=1, points=(9, 4))
    assert msgspec.convert(msgspec.to_builtins(game), AnyCarom) == game


@pytest.mark.parametrize("cloth", ["heated", "club"])
def test_players_try_the_figures_and_a_master_makes_more_than_a_novice(cloth):
    from game.billiards.players.carom import hand_of
    from game.billiards.shot.cloths import CLOTHS

    made = {}
    for name in ("novice", "master"):
        grade, count = CAROM_GRADES[name], 0
        for number in range(9):
            frame = new_carom(at(number), CLOTHS[cloth])
            stroke = decide_carom(frame, grade).stroke
            for seed in range(3):
                count += frame.play(hand_of(stroke, grade, seed)).verdict.scored
        made[name] = count
    assert made["master"] > made["novice"]
    assert made["master"] >= 9
