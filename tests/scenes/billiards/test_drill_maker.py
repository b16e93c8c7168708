"""Drills of one's own: made by hand, saved as a level, opened, counted in sets."""

import msgspec
import pytest

from game.app.stagehand.files import present_level
from game.billiards.game.games import Drill, Practice, RunDrill
from game.billiards.game.goals import Pot, Zone
from game.levels import format_level, level_files, load_level, parse_level
from game.scenes.billiards import layout
from game.scenes.billiards.level import BilliardsContent
from game.scenes.billiards.practice.sets import drill_title, standing_set
from game.scenes.billiards.scene import Billiards
from game.stage import Action, Decision, Stage, replay_scene
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    click,
    drag,
    open_level,
    point,
    press,
    seconds,
    straight_pot,
    until_aiming,
)
from tests.scenes.test_saved_at_any_moment import opened_again

TWO_BALLS = "balls = [{number=0,position=[0.3,0.3]},{number=2,position=[0.6,0.9]}]"
NO_CALL = (-1.0, -1.0, 0.0, 0.0)


def press_button(stage, name: str) -> None:
    rows = [row[0] for row in stage.scene.buttons.rows()]
    press(stage, layout.button_box(rows.index(name)))


def strike(stage, speed, azimuth):
    stage.post(Decision("stroke", (speed, azimuth, 0.0, 0.0, 0.0, *NO_CALL)))
    return until_aiming(seconds(stage, 0.25))


@pytest.fixture
def making():
    """Straight before the corner, the goal chosen by hand: the 3 into that corner, a zone where one drags."""
    stage = straight_pot()
    stage.post(Action("set-up"))
    press_button(stage, "drill")
    return stage


def made(stage):
    """With a goal that a soft stroke meets, played."""
    point(stage, "move", 0.22, 0.22)
    click(stage, 0.22, 0.22)
    px, py = stage.scene.model.frame.table.pockets[0, :2].tolist()
    point(stage, "move", px, py)
    click(stage, px, py)
    drag(stage, (0.45, 0.5), (0.45, 0.95))
    press_button(stage, "drill-play")
    return stage


def test_a_drill_made_by_hand_is_played_and_counted(making):
    stage = made(making)
    game = stage.scene.model.frame.game
    assert isinstance(game, Drill) and game.goal.pots == (Pot(3, 0),)
    assert game.goal.zones == (Zone(0, 0.45, 0.5, 0.45),) and (game.tries, game.needed) == (10, 7)
    assert stage.scene.model.frame.layout.place_of(3) == (0.22, 0.22)
    strike(stage, 0.5, AT_THE_CORNER)
    game = stage.scene.model.frame.game
    assert (game.attempts, game.made) == (1, 1) and stage.scene.practised[2:] == (1, 1, 10)
    strike(stage, 0.5, AT_THE_CORNER + 0.5)
    assert stage.scene.practised[2:] == (1, 2, 10)
    stage.post(Action("undo"))
    assert stage.scene.practised[2:] == (1, 2, 10)
    assert replay_scene(stage.recording, Billiards).digest() == stage.digest()


def test_it_is_saved_as_a_level_that_begins_anew(making):
    stage = strike(made(making), 0.5, AT_THE_CORNER)
    text = format_level(present_level(stage, stage.scene.level_title))
    level = parse_level(text, "billiards", BilliardsContent)
    assert level.title == "Drill: pot the 3, upper left pocket. The cue ball stops in its ring"
    again = Stage(Billiards, level=level)
    game = again.scene.model.frame.game
    assert (game.goal, game.tries, game.needed, game.attempts) == (
        stage.scene.model.frame.game.goal,
        10,
        7,
        0,
    )
    assert again.scene.model.frame.layout.places == stage.scene.model.frame.layout.places
    assert again.scene.practised.key == stage.scene.practised.key
    assert again.scene.practised.title == level.title


def test_what_is_saved_before_it_is_played_is_the_drill_and_opens(making):
    press_button(making, "drill")
    press_button(making, "clear")
    drag(making, layout.tray_place(6), (0.4, 1.0))
    drag(making, layout.tray_place(2), (0.8, 1.6))
    press_button(making, "drill")
    again = opened_again(making)
    game = again.scene.model.frame.game
    assert isinstance(game, Practice) and game.on_table == (2, 6) and game.in_hand == ""
    click(making, 0.4, 1.0)
    opened_again(making)  # a ball without a pocket: still practice
    px, py = making.scene.model.frame.table.pockets[3, :2].tolist()
    click(making, px, py)
    drag(making, (0.45, 0.5), (0.45, 0.8))
    again = opened_again(making)
    game = again.scene.model.frame.game
    assert isinstance(game, Drill) and game.goal.pots == (Pot(6, 3),)
    assert game.goal.zones == (Zone(0, 0.45, 0.5, 0.3),)
    assert again.scene.model.frame.layout.places == making.scene.model.frame.layout.places


@pytest.mark.parametrize(
    "name", ["default", "set-01-stop-ladder-1", "set-07-line-up", "ghost-09", "trick-02-plant"]
)
def test_a_set_up_is_saved_as_what_would_be_played(name):
    stage = open_level(name)
    stage.post(Action("set-up"))
    untouched = opened_again(stage).scene.model.frame
    assert msgspec.to_builtins(untouched.game) == msgspec.to_builtins(stage.scene.model.frame.game)
    place = stage.scene.model.frame.cue_ball or layout.tray_place(0)
    point(stage, "down", *place, button=1)
    point(stage, "move", 0.7, 1.2)
    again = opened_again(stage).scene.model.frame  # in the midst of the drag
    assert again.cue_ball == stage.scene.model.frame.cue_ball != untouched.cue_ball
    assert isinstance(again.game, Practice)
    point(stage, "move", -0.3, 1.2)
    point(stage, "up", -0.3, 1.2, button=1)  # the cue ball put aside
    assert stage.scene.model.frame.cue_ball is None
    assert opened_again(stage).scene.model.frame.game.in_hand == "anywhere"


def test_ten_tries_and_the_set_is_over(making):
    stage = made(making)
    for k in range(10):
        strike(stage, 0.5, AT_THE_CORNER + 0.5 * (k < 4))
    game = stage.scene.model.frame.game
    assert (
        game.over and game.made == 6 and stage.scene.model.frame.words[0].endswith("7 were needed, not met.")
    )
    assert ("rack", "Again", True) in stage.scene.buttons.rows()
    stage.post(Action("rack"))
    assert not stage.scene.model.frame.game.over and stage.scene.practised[2:] == (0, 0, 10)


def test_nothing_and_half_a_goal_is_told(making):
    press_button(making, "drill-play")
    assert making.scene.play.phase == "set-up"
    assert any("drag a zone" in line for line in making.scene.messages())
    click(making, 0.22, 0.22)
    press_button(making, "drill-play")
    assert any("no pocket" in line for line in making.scene.messages())
    click(making, 0.22, 0.22)  # once more takes it back
    assert making.scene.maker.ball is None
    drag(making, (0.6, 1.5), (0.6, 1.5))
    assert making.scene.maker.lacking == ""
    press_button(making, "drill-zone")
    assert making.scene.maker.zone is None


def test_a_ball_that_is_dragged_is_moved_and_not_chosen(making):
    drag(making, (0.22, 0.22), (0.4, 1.0))
    assert making.scene.maker.ball is None
    assert making.scene.model.frame.layout.place_of(3) == pytest.approx((0.4, 1.0))


def test_the_wheel_sets_how_many_of_how_many(making):
    point(making, "wheel", 0.6, 1.5, wheel=2.0)
    point(making, "wheel", 0.6, 1.5, wheel=-2.0, control=True)
    assert (making.scene.maker.needed, making.scene.maker.tries) == (8, 8)
    point(making, "wheel", 0.6, 1.5, wheel=-100.0)
    point(making, "wheel", 0.6, 1.5, wheel=500.0, control=True)
    assert (making.scene.maker.needed, making.scene.maker.tries) == (1, 100)
    press_button(making, "drill-needed")
    assert making.scene.maker.needed == 2


def test_without_a_goal_the_same_balls_are_only_practised(making):
    press_button(making, "drill")
    press_button(making, "set-up")
    assert making.scene.play.phase == "aiming" and not isinstance(making.scene.model.frame.game, Drill)


SETS = [path for path in level_files("billiards") if path.stem.startswith("set-")]


class TestShipped:
    def test_there_are_enough(self):
        assert len(SETS) >= 9
        assert (
            sum(load_level(path, "billiards", BilliardsContent).content.game == "run-drill" for path in SETS)
            == 3
        )

    @pytest.mark.parametrize("path", SETS, ids=lambda path: path.stem)
    def test_it_can_be_met_and_has_words(self, path):
        stage = open_level(path.stem)
        game, content = stage.scene.model.frame.game, stage.scene.model.content
        assert stage.level.about and game.needed > 0 and drill_title(game, stage.level) == stage.level.title
        if isinstance(game, RunDrill):
            assert game.needed <= game.tries * game.count and game.in_hand == "anywhere"
            return
        stage.scene.play.begin_stroke(content.solution.stroke(), stage.scene.aiming.call)
        until_aiming(seconds(stage, 0.5))
        assert (stage.scene.model.frame.game.made, stage.scene.model.frame.game.attempts) == (1, 1)
        assert standing_set(stage.scene.play, stage.level)[2:] == (1, 1, 10)

    def test_a_run_drill_goes_on_until_a_miss(self):
        stage = open_level("set-09-l")
        strike(stage, 1.0, 0.0)
        assert stage.scene.practised[2:] == (0, 7, 35)
        assert (
            len(stage.scene.model.frame.layout.numbers) == 8
            and stage.scene.model.frame.game.in_hand == "anywhere"
        )
        assert stage.scene.save_content() == stage.level.content

    @pytest.mark.parametrize(
        ("content", "why"),
        [('game = "run-drill"', "needs the cue ball"),
         (f'game = "run-drill"\nneeded = 3\ntries = 2\n{TWO_BALLS}', "needed: 3 of 2 cannot be met"),
         (f'game = "run-drill"\n{TWO_BALLS}\n[content.goal]\ndown = 1', "a run-drill has none")],
    )  # fmt: skip
    def test_one_that_contradicts_itself_is_refused(self, content, why):
        level = parse_level(f'scene = "billiards"\n[content]\n{content}', "billiards", BilliardsContent)
        with pytest.raises(ValueError, match=why):
            Stage(Billiards, level=level)
