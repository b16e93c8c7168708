"""The guide: whole path, to the first ball, none; and what suits which game."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Struck
from game.levels import load_level
from game.scenes.billiards import layout
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view.score_board import key_rows
from game.scenes.shared.tables.choices import FIRST, NONE, WHOLE
from game.scenes.shared.tables.prediction import FIRST_BALL, SET_OFF, foresee
from game.stage import Action, SetParameter, Stage
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    level_of,
    open_level,
    press,
    straight_pot,
)


@pytest.mark.parametrize(
    ("level", "guide"),
    [("default", FIRST), ("nine-ball", FIRST), ("practice", WHOLE), ("drill-01-stop", WHOLE)],
)
def test_games_show_the_way_to_the_first_ball_and_practice_all_of_it(level: str, guide: str):
    assert open_level(level).scene.play.guide == guide


def test_a_choice_holds_in_every_game_and_the_button_and_v_go_round():
    stage = open_level("default", guide=WHOLE)
    play = stage.scene.play
    assert play.guide == WHOLE
    row = [name for name, _, _ in stage.scene.buttons.rows()].index("view")
    seen = []
    for _ in range(3):
        press(stage, layout.button_box(row))
        seen.append((play.guide, stage.scene.buttons.rows()[row][1]))
    assert seen == [(FIRST, "First ball"), (NONE, "No guide"), (WHOLE, "Full path")]
    stage.post(Action("view"))
    assert play.guide == FIRST
    stage.post(SetParameter("guide", "auto"))
    assert play.guide == FIRST and open_level("practice").scene.play.guide == WHOLE


def test_to_the_first_ball_nothing_after_it_is_foreseen():
    stage = straight_pot("eight-ball")
    aim(stage, AT_THE_CORNER)
    struck = Struck(stage.scene.model.frame, stage.scene.aiming.stroke)
    whole, first = foresee(struck, 30), foresee(struck, FIRST_BALL)
    assert whole.others[0].potted and len(whole.after) > 2
    assert first.ghost == whole.ghost and first.target == whole.target == 3 and first.cut == whole.cut
    assert np.array_equal(first.approach, whole.approach)
    assert len(first.after) == 0 and first.last is None
    (begun,) = first.others
    assert begun.number == 3 and not begun.potted
    way = np.hypot(*np.diff(begun.points, axis=0).T).sum()
    assert way == pytest.approx(SET_OFF, abs=1e-9)
    assert begun.points[0] == pytest.approx(first.target_place)
    along = begun.points[-1] - begun.points[0]
    assert math.atan2(along[1], along[0]) == pytest.approx(AT_THE_CORNER, abs=0.02)


def test_the_way_to_the_first_ball_may_lead_over_cushions():
    stage = level_of(
        'game = "eight-ball"\nballs = [{ number = 0, position = [0.3, 0.6] }, { number = 3,'
        " position = [0.3, 1.6] }, { number = 5, position = [0.6, 1.1] }]"
    )
    frame = stage.scene.model.frame
    found = [
        foresee(Struck(frame, Stroke(3.0, math.radians(a))), FIRST_BALL) for a in np.arange(115.0, 135.0, 0.5)
    ]
    banked = [sight for sight in found if sight.target is not None and sight.bounces]
    assert banked
    for sight in banked:
        assert len(sight.bounces) >= 1 and np.hypot(*(sight.approach - sight.bounces[0]).T).min() < 1e-9


def test_the_lines_have_a_key_that_says_no_more_than_is_shown():
    assert [row.words for row in key_rows(WHOLE, False)] == ["cue ball", "after the hit", "other balls"]
    assert [row.words for row in key_rows(FIRST, False)] == ["cue ball", "first ball sets off"]
    assert key_rows(NONE, True) == ()
    assert "hand" in key_rows(FIRST, True)[-1].words


@pytest.mark.parametrize(("written", "guide"), [("true", "auto"), ("false", "none")])
def test_a_level_and_an_event_with_the_former_switch_still_open(tmp_path, written, guide):
    path = tmp_path / "old.toml"
    path.write_text(f'scene = "billiards"\ntitle = "Old"\n[parameters]\nprediction = {written}\n')
    stage = Stage(Billiards, level=load_level(path, "billiards", Billiards.content_type))
    assert stage.scene.parameters.guide == guide
    other = Stage(Billiards)
    other.post(SetParameter("prediction", written == "true"))
    other.run(1)
    assert other.scene.parameters.guide == guide
