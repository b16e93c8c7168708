"""The snooker table as a person plays on it: by posted events."""

import math

import msgspec
import pytest

from game.levels import Level, LevelError, format_level, level_files, load_level, parse_level
from game.scenes.snooker import layout
from game.scenes.snooker.scene import SnookerScene
from game.scenes.snooker.view.magnifier import box_beside
from game.scenes.snooker.view.words import foul_to_come, line_of, standing_of
from game.stage import Action, Decision, Pointer, SetParameter, Stage, replay_scene
from tests.scenes.snooker.snooker_stages import (
    click,
    drag,
    level_of,
    open_level,
    press_button,
    seconds,
    until_aiming,
)

YELLOW, GREEN, BROWN, BLUE, PINK, BLACK = range(16, 22)
COLOURS = "spotted = [16, 17, 18, 19, 20, 21]\n"
AFTER_RED = f"""{COLOURS}after_red = true
balls = [{{ number = 0, position = [0.4, 2.3] }}, {{ number = 1, position = [1.5, 1.2] }}]
"""

RED_BEYOND = AFTER_RED.replace("after_red = true\n", "")


def strike(stage, aim, power=2.0, **set_up):
    """Play a stroke by hand, to its end."""
    stage.scene.course.cue.point_to(aim)
    stage.post(SetParameter("power", power))
    for name, value in set_up.items():
        stage.post(SetParameter(name, value))
    stage.post(Action("strike"))
    seconds(stage, 0.02)
    return until_aiming(stage)


def aim_at(stage, ball):
    """Direction from the cue ball to a ball, rad."""
    frame = stage.scene.model.frame
    (x, y), (px, py) = frame.cue_ball, frame.layout.place_of(ball)
    return math.atan2(py - y, px - x)


def recorded(stage):
    return msgspec.json.decode(msgspec.json.encode(stage.recording), type=type(stage.recording))


def test_a_pulled_cue_strikes_and_a_recording_plays_the_same():
    stage = open_level()
    x, y = stage.scene.model.frame.cue_ball
    stage.post(Pointer("move", 1.02, 2.8))
    drag(stage, (x + 0.01, y + 0.4), (x, y + 0.3), (x, y + 0.15))
    assert stage.scene.course.phase == "striking"
    until_aiming(stage)
    frame = stage.scene.model.frame
    assert frame.strokes == 1 and frame.last.stroke.cue_speed > 1.0
    assert replay_scene(recorded(stage), SnookerScene).digest() == stage.digest()


def test_the_cue_ball_is_dragged_within_the_d():
    stage = open_level()
    place = stage.scene.model.frame.cue_ball
    drag(stage, place, (0.7, 0.65), (0.2, 2.0))
    x, y = stage.scene.model.frame.cue_ball
    assert y <= 0.737 + 1e-9 and math.hypot(x - 0.889, y - 0.737) <= 0.292 + 1e-9
    assert stage.scene.course.phase == "aiming"


@pytest.mark.parametrize("to", [(0.8, 0.6), (1.05, 0.7), (0.889, 0.5)])
def test_within_the_d_the_cue_ball_lies_where_it_was_let_go(to):
    stage = open_level()
    drag(stage, stage.scene.model.frame.cue_ball, (0.85, 0.65), to)
    assert stage.scene.model.frame.cue_ball == pytest.approx(to, abs=1e-9)


def test_the_colour_aimed_at_is_nominated_and_potted():
    stage = level_of(AFTER_RED.replace("[0.4, 2.3]", "[0.36, 3.2]").replace(", 21]", "]").replace(
        "balls = [", "balls = [{ number = 21, position = [0.18, 3.38] }, "))  # fmt: skip
    stage.scene.course.cue.point_to(aim_at(stage, BLACK))
    assert stage.scene.course.call.ball == BLACK
    strike(stage, aim_at(stage, BLACK), 1.5)
    state = stage.scene.model.game
    assert state.points == (7, 0) and state.stage == "red" and state.turn == 0


def test_aimed_at_a_cushion_a_colour_must_be_nominated_by_hand():
    stage = level_of(AFTER_RED)
    course = stage.scene.course
    course.cue.point_to(math.pi)
    stage.post(Action("strike"))
    seconds(stage, 0.05)
    assert course.phase == "aiming" and stage.scene.model.frame.strokes == 0
    click(stage, *layout.chip_place(PINK))
    assert course.call.ball == PINK and course.chosen == PINK
    click(stage, *layout.chip_place(PINK))
    assert course.chosen is None
    stage.post(Action("nominate-7"))
    seconds(stage, 0.02)
    assert course.call.ball == BLACK
    course.cue.point_to(math.pi)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert stage.scene.model.frame.last.call.ball == BLACK


def test_a_foul_is_foretold_and_what_follows_is_said_first():
    stage = level_of(RED_BEYOND)
    course = stage.scene.course
    assert foul_to_come(course, BLUE) == "foul: a red is on" and foul_to_come(course, 1) == ""
    strike(stage, aim_at(stage, BLUE), 1.5)
    line = line_of(course)
    assert line.foul and "5 to Ben" in line.lead and "blue was hit first" in line.more


def test_options_after_a_miss_by_buttons_and_put_back_exactly():
    stage = level_of(RED_BEYOND)
    before = stage.scene.model.frame.layout.places
    strike(stage, aim_at(stage, BLUE), 1.5)
    options = stage.scene.model.game.options
    assert [option.name for option in options] == ["play", "again", "replay"]
    click(stage, *layout.option_box(2, 3).middle)
    model = stage.scene.model
    assert model.frame.layout.places == before and model.game.turn == 0 and not model.game.options
    strike(stage, aim_at(stage, BLUE), 1.5)
    stage.post(Action("second"))
    seconds(stage, 0.02)
    assert model.game.turn == 0 and model.frame.layout.places != before


def test_undo_goes_back_before_the_foul():
    stage = open_level()
    before = stage.digest()
    strike(stage, 0.2)
    assert stage.digest() != before
    press_button(stage, "undo")
    frame = stage.scene.model.frame
    assert frame.strokes == 0 and frame.snooker.points == (0, 0)


def test_a_concession_is_asked_once_and_a_claim_is_not():
    stage = open_level()
    press_button(stage, "concede")
    assert stage.scene.model.game.winner is None and ("concede", "Sure?", True) in stage.scene.hand.buttons()
    press_button(stage, "concede")
    assert stage.scene.model.game.winner == 1
    names = [button[0] for button in stage.scene.hand.buttons()]
    assert names == ["undo", "replay", "eye", "view", "coach", "rack"]
    press_button(stage, "rack")
    state = stage.scene.model.game
    assert state.winner is None and state.won == (0, 1) and state.turn == 1
    ahead = level_of("spotted = [21]\nballs = [{ number = 0, position = [0.4, 2.3] }]\npoints = [60, 10]\n")
    press_button(ahead, "concede")
    assert ahead.scene.model.game.winner == 0


def test_the_board_says_what_is_on_what_is_left_and_who_needs_snookers():
    stage = open_level("hard-03-snookers-needed")
    board = standing_of(stage.scene.course, stage.scene.opponents.thinker, "")
    assert board.on == "brown on" and board.left == "22 left" and board.chip == BROWN
    assert "needs 2 snookers" in board.cards[0].status and "needs" not in board.cards[1].status
    assert (board.cards[0].points, board.cards[1].points) == ("38", "68")
    shown = {readout.name: readout.value for readout in stage.scene.readouts()}
    assert shown == {"break": 0, "points left": 22, "energy": 0, "cue ball": 0, "events": 0, "shot": 0}


def test_match_and_referee_follow_the_parameters():
    stage = open_level(best_of="3", miss="club")
    state = stage.scene.model.game
    assert state.best_of == 3 and state.miss_rule == "club" and state.frames_to_win == 2
    stage.post(SetParameter("miss", "off"))
    seconds(stage, 0.02)
    assert stage.scene.model.game.miss_rule == "off"
    assert len(open_level(game="six-red").scene.model.game.reds_left) == 6


def test_a_computer_player_breaks_off_and_its_decisions_are_recorded():
    stage = open_level("six-red", first_player="novice")
    seconds(stage, 0.9)
    stage.listen(at_once=True)
    seconds(stage, 0.2)
    assert stage.scene.course.phase in ("striking", "rolling")
    until_aiming(stage)
    frame = stage.scene.model.frame
    assert frame.strokes == 1 and frame.last.frame.cue_ball is not None
    assert replay_scene(recorded(stage), SnookerScene).digest() == stage.digest()


def test_wrong_decisions_are_refused():
    scene = open_level().scene
    for wrong in (Decision("stroke", (1.0,)), Decision("option", (3.0,)), Decision("white", (0.1, 0.1, 0.1)),
                  Decision("nonsense", ())):  # fmt: skip
        with pytest.raises(ValueError, match=r"expected|there are|option"):
            scene.decide(wrong)


def test_a_drill_begins_again_and_counts():
    stage = open_level("practice-06-behind-brown")
    start = stage.scene.model.frame.layout.places
    strike(stage, aim_at(stage, BROWN), 1.0)
    state = stage.scene.model.game
    assert state.over and (state.attempts, state.made) == (1, 0)
    press_button(stage, "rack")
    assert stage.scene.model.frame.layout.places == start
    state = stage.scene.model.game
    assert not state.over and (state.attempts, state.made) == (1, 0)


def test_a_replay_shows_the_last_stroke_and_changes_nothing():
    stage = open_level()
    strike(stage, 1.2)
    word = stage.scene.model.word
    press_button(stage, "replay")
    assert stage.scene.course.phase == "replay"
    until_aiming(stage)
    assert stage.scene.model.word == word


def test_what_is_saved_is_read_again():
    stage = level_of(AFTER_RED)
    strike(stage, aim_at(stage, BLUE), 1.0)
    content = stage.scene.save_content()
    text = format_level(Level(scene="snooker", content=content))
    second = Stage(SnookerScene, level=parse_level(text, "snooker", SnookerScene.content_type))
    assert second.scene.model.game == stage.scene.model.game
    assert second.scene.model.frame.layout.places == stage.scene.model.frame.layout.places


def test_a_miss_that_was_saved_can_still_be_put_back():
    stage = level_of(RED_BEYOND)
    before = stage.scene.model.frame.layout.places
    strike(stage, aim_at(stage, BLUE), 1.5)
    text = format_level(Level(scene="snooker", content=stage.scene.save_content()))
    second = Stage(SnookerScene, level=parse_level(text, "snooker", SnookerScene.content_type))
    again = second.scene.save_content()
    assert again == stage.scene.save_content() and again.put_back
    second.post(Action("third"))
    seconds(second, 0.02)
    assert second.scene.model.frame.layout.places == before and second.scene.model.game.turn == 0
    assert not second.scene.save_content().put_back


@pytest.mark.parametrize("path", list(level_files("snooker")), ids=lambda path: path.stem)
def test_every_level_opens_and_a_stroke_can_be_played(path):
    level = load_level(path, "snooker", SnookerScene.content_type)
    stage = Stage(SnookerScene, level=level, parameters={"first_player": "person", "second_player": "person"})
    course = stage.scene.course
    course.begin_stroke(course.stroke, course.call)
    until_aiming(stage)
    assert stage.scene.model.frame.strokes == 1


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("balls = [{ number = 22, position = [0.4, 2.3] }]", "number"),
        ("balls = [{ number = 0, position = [0.4, 2.3] }, { number = 0, position = [0.5, 2.3] }]", "twice"),
        ("balls = [{ number = 0, position = [0.4, 4.3] }]", "outside"),
        ("spotted = [19]\nballs = [{ number = 0, position = [0.889, 1.8] }]", "lies in"),
        ("spotted = [5]", "no colour"),
        ("balls = [{ number = 0, position = [0.4, 2.3] }]", "object ball"),
        ("spotted = [21]\nballs = [{ number = 1, position = [0.4, 2.3] }]", "all six"),
        ('drill = "pot"', "balls"),
        ("free_ball = true", "balls"),
    ],
)
def test_levels_that_contradict_themselves_are_refused(content, words):
    with pytest.raises(LevelError, match=words):
        level_of(content)


def test_the_magnifier_hides_neither_cue_ball_nor_contact():
    for cue, ghost in (((0.3, 0.4), (0.4, 3.2)), ((0.9, 1.7), (0.9, 2.0)), ((1.5, 3.3), (1.5, 0.3))):
        box = box_beside(cue, ghost, [cue, ghost])
        assert not box.holds(*cue) and not box.holds(*ghost)


def test_while_it_plays_itself_it_goes_on_and_a_press_takes_the_cue():
    stage = open_level("six-red")
    stage.post(Action("demo"))
    seconds(stage, 12.0)
    assert stage.scene.model.frame.strokes >= 1
    click(stage, 0.9, 1.0)
    assert not stage.scene.course.plays_itself


def test_a_computers_choice_takes_no_buttons_and_leaves_what_was_said_in_sight():
    """A miss: the computer has it played again; that it was one, and what it cost, is still told."""
    stage = open_level("default", second_player="club")
    course = stage.scene.course
    stage.post(Decision("stroke", (1.0, -0.5 * math.pi, 0.0, 0.0, 0.0, -1.0)))  # away from all balls
    until_aiming(stage)
    game = course.model.game
    assert game.turn == 1 and [option.name for option in game.options][-1] == "replay"
    assert line_of(course).lead.startswith("Foul and a miss: ") and line_of(course).foul
    assert not any(stage.scene.hand._button_at(*layout.option_box(k, 3).middle) for k in range(3))
    for _ in range(40):
        seconds(stage, 0.25)
        stage.listen(at_once=True)
        if not course.model.game.options:
            break
    line = line_of(course)
    assert not course.model.game.options
    assert "Foul and a miss: " in f"{line.lead} {line.more}" and "chooses" not in f"{line.lead} {line.more}"


def test_there_is_time_to_read_before_a_computer_chooses():
    stage = open_level("default", second_player="club")
    course = stage.scene.course
    stage.post(Decision("stroke", (1.0, -0.5 * math.pi, 0.0, 0.0, 0.0, -1.0)))
    until_aiming(stage)
    began = stage.time_s
    while course.model.game.options and stage.time_s < began + 20.0:
        seconds(stage, 0.1)
        stage.listen(at_once=True)
    assert not course.model.game.options and 2.5 < stage.time_s - began < 20.0
