"""The carom table as a person plays on it: by posted events."""

import math

import msgspec
import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import carom_trajectory
from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import CAROM_GRADES, decide_carom, hand_of, position_of, weigh
from game.billiards.table.carom import BALL_RADIUS, RED, WHITE, YELLOW, fits
from game.levels import LevelError, parse_level
from game.scenes.carom import layout
from game.scenes.carom.level import CaromContent, read_game
from game.scenes.carom.opponents import CaromOpponents
from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.choices import GRADES
from game.stage import Action, Decision, Pointer, SetParameter, Stage, replay_scene
from tests.scenes.carom.carom_stages import (
    click,
    click_row,
    drag,
    level_of,
    open_level,
    press,
    seconds,
    until_aiming,
)

PLACED = "white = [0.9, 0.7]\nyellow = [0.41, 1.1]\nred = [0.71, 2.13]\n"


def recorded(stage):
    """The recording of a stage, read back as from a file."""
    return msgspec.json.decode(msgspec.json.encode(stage.recording), type=type(stage.recording))


# -- the map, chosen and played ---------------------------------------------------------------------


def test_a_click_shows_a_way_and_a_second_one_plays_it():
    stage = open_level("practice")
    course = stage.scene.course
    click_row(stage, 0)
    group = stage.scene.advisor.maker.latest.map.groups[0]
    assert course.chosen == group.stroke and course.phase == "aiming"
    assert course.stroke.azimuth == pytest.approx(math.remainder(group.stroke.azimuth, math.tau))
    assert course.stroke.cue_speed == pytest.approx(group.stroke.cue_speed)
    assert course.stroke.tip_left == pytest.approx(group.stroke.tip_left, abs=1e-6)
    assert course.stroke.tip_up == pytest.approx(group.stroke.tip_up, abs=1e-6)
    click_row(stage, 0)
    assert course.phase == "striking"
    until_aiming(stage)
    frame = course.model.frame
    assert frame.last.stroke == group.stroke
    assert frame.game.points == (1,) and frame.game.run == 1


def test_a_recording_plays_the_same_without_drawing_a_map():
    stage = open_level("practice")
    click_row(stage, 1)
    click_row(stage, 1)
    until_aiming(stage)
    again = replay_scene(recorded(stage), CaromScene)
    assert again.digest() == stage.digest()
    assert again.scene.advisor.maker.latest is None


def test_a_click_counts_only_for_the_position_that_was_shown():
    stage = open_level("practice")
    stage.listen(at_once=True)
    click(stage, *layout.row_box(0).middle)
    drag(stage, (0.71, 2.13), (0.75, 2.0), (0.9, 1.6))
    stage.listen(at_once=True)
    assert stage.scene.course.chosen is None


def test_what_is_chosen_is_played_by_its_button_and_key():
    for way in ("button", "key"):
        stage = open_level("practice")
        click_row(stage, 2)
        chosen = stage.scene.course.chosen
        if way == "button":
            click(stage, *layout.button_box(layout.BUTTONS.index("play")).middle)
        else:
            stage.post(Action("play"))
        assert stage.scene.course.pending == chosen


def test_clicks_beside_the_rows_do_nothing():
    stage = open_level("practice")
    stage.listen(at_once=True)
    before = stage.digest()
    for row in (-1, 40):
        click(stage, layout.row_box(row).middle[0], layout.LIST.left + 0.1)
        stage.listen(at_once=True)
    click(stage, layout.LIST.top + 0.02, layout.LIST.left + 0.1)
    stage.listen(at_once=True)
    assert stage.scene.course.chosen is None and stage.digest() == before


def test_the_map_is_of_the_position_that_the_balls_are_dragged_to():
    stage = open_level("practice")
    stage.listen(at_once=True)
    first = stage.scene.advisor.maker.latest
    drag(stage, (0.71, 2.13), (0.75, 2.0), (0.9, 1.6))
    stage.listen(at_once=True)
    second = stage.scene.advisor.maker.latest
    assert second.key != first.key
    assert second.position.places[RED].tolist() == pytest.approx([0.9, 1.6])
    assert stage.scene.advisor.drawn() is second


def test_a_map_drawn_in_the_background_is_the_one_drawn_at_once():
    stage, other = open_level("practice"), open_level("practice")
    stage.listen(at_once=True)
    advisor = other.scene.advisor
    advisor.drawn()
    advisor.maker.wait()
    found, wanted = advisor.maker.latest, stage.scene.advisor.maker.latest
    assert advisor.maker.failure == "" and found.map.fine
    assert [(g.code, g.stroke, g.chance) for g in found.map.groups] == [
        (g.code, g.stroke, g.chance) for g in wanted.map.groups
    ]


def test_no_map_while_balls_roll_or_it_is_switched_off():
    stage = open_level("practice")
    stage.post(SetParameter("map", False))
    assert not stage.scene.advisor.active and stage.scene.advisor.now() is None
    stage.post(Action("map"))
    assert stage.scene.advisor.active
    stage.post(Action("strike"))
    seconds(stage, 0.5)
    assert not stage.scene.advisor.active


def test_what_may_be_off_is_told_of_the_chosen_stroke():
    stage = open_level("practice")
    assert stage.scene.advisor.study() is None
    click_row(stage, 0)
    studied = stage.scene.advisor.study()
    assert studied.stroke == stage.scene.course.chosen and min(studied.tolerance.aim) >= 0.0
    assert max(studied.tolerance.aim) > 0.0 and (studied.tips > 0).any()
    assert stage.scene.advisor.study() is studied


# -- balls dragged ----------------------------------------------------------------------------------


def test_a_ball_that_is_dragged_stays_on_the_bed_and_beside_the_others():
    stage = open_level("practice")
    way = [(0.0, 0.0), (2.0, 5.0), (0.42, 1.1), (0.9, 0.7), (0.65, 0.9)]
    press(stage, 0.71, 2.13)
    for x, y in way:
        stage.post(Pointer("move", x, y, button=1))
        assert fits(stage.scene.model.frame.positions)
    assert stage.scene.model.frame.places[RED] == (0.65, 0.9)
    assert (stage.scene.model.places == stage.scene.model.frame.positions).all()


def test_dragging_turns_a_match_into_practice_and_undo_brings_it_back():
    stage = level_of(PLACED)
    match = stage.scene.model.frame
    drag(stage, (0.41, 1.1), (0.5, 1.0), (0.6, 1.0))
    frame = stage.scene.model.frame
    assert frame.game.players == ("Practice",) and frame.game.cue == WHITE
    assert any("practice" in words for words in stage.scene.messages())
    stage.post(Action("undo"))
    assert stage.scene.model.frame.game == match.game and stage.scene.model.frame.places == match.places


def test_a_press_that_does_not_move_a_ball_changes_nothing():
    stage = level_of(PLACED)
    before = stage.scene.model.frame
    click(stage, 0.41, 1.1)
    assert (
        stage.scene.model.frame is before
        and stage.scene.course.grip == grip.NOTHING
        and len(stage.scene.model.frame.game.players) == 2
    )


# -- strokes by hand --------------------------------------------------------------------------------


def test_the_cue_is_aimed_pulled_and_let_go():
    stage = open_level("practice")
    stage.post(Pointer("move", 0.9, 1.9))
    assert stage.scene.course.cue.aim == pytest.approx(0.5 * math.pi)
    drag(stage, (0.9, 1.9), (0.9, 1.75))
    assert stage.scene.course.phase == "striking"
    until_aiming(stage)
    last = stage.scene.model.frame.last
    assert last.stroke.azimuth == pytest.approx(0.5 * math.pi, abs=1e-9)
    assert last.stroke.cue_speed > 0.5


def test_keys_turn_the_cue_as_long_as_one_may_aim():
    stage = open_level("practice")
    cue = stage.scene.course.cue
    start = cue.aim
    stage.post(Action("left"))
    turned = cue.aim
    assert math.remainder(turned - start, math.tau) > 0.0
    stage.post(Action("right"))
    assert cue.aim == pytest.approx(start)
    for other in ("first", "second"):  # of options that nobody has now
        stage.post(Action(other))
    assert cue.aim == pytest.approx(start)
    stage.post(Action("demo"))
    assert not stage.scene.course.may_aim
    stage.post(Action("left"))
    assert cue.aim == pytest.approx(start)


@pytest.mark.parametrize(
    "decision", [Decision("show", (1.0,)), Decision("option", (0.0, 1.0)), Decision("other", (1.0,))]
)
def test_decisions_that_are_none_are_refused(decision):
    with pytest.raises(ValueError, match=f"{decision.name}: expected show, play or option"):
        open_level("practice").scene.decide(decision)


def test_the_stroke_is_the_exact_tables():
    stage = open_level("practice", power=3.0, tip_left=0.2)
    stroke = stage.scene.course.stroke
    expected = carom_trajectory(stage.scene.model.frame, stroke).end
    stage.post(Action("strike"))
    until_aiming(stage)
    assert stage.scene.model.places[WHITE].tolist() == expected[0, :2].tolist()


def test_escape_lets_go_of_a_pulled_cue():
    stage = open_level("practice")
    press(stage, 0.9, 1.9)
    stage.post(Pointer("move", 0.9, 1.5, button=1))
    stage.post(Pointer("cancel", 0.9, 1.5))
    stage.post(Pointer("up", 0.9, 1.5, button=1))
    assert stage.scene.course.phase == "aiming"


def test_the_tip_is_set_on_its_picture():
    stage = open_level("practice")
    x, y = layout.TIP_MIDDLE
    press(stage, x - 0.3 * layout.TIP_RADIUS, y - 0.4 * layout.TIP_RADIUS)
    chosen = stage.scene.parameters
    assert (chosen.tip_left, chosen.tip_up) == pytest.approx((0.4, 0.3), abs=1e-3)
    stage.post(Pointer("move", x, y + 2.0, button=1))
    assert chosen.tip_left == pytest.approx(-0.6)


def test_the_hand_is_measured_from_strokes_that_were_meant():
    stage = open_level("practice", odds="own", hand="average")
    fallback = stage.scene.advisor.noise
    assert fallback == CAROM_GRADES["club"].noise
    for _ in range(5):
        click_row(stage, 0)
        stage.post(Action("strike"))
        until_aiming(stage)
        stage.post(Action("undo"))
    assert len(stage.scene.course.own) == 5
    assert stage.scene.advisor.noise != fallback and stage.scene.advisor.noise.azimuth > 0.0


def test_undo_goes_back_before_the_stroke():
    stage = open_level("practice")
    places = stage.scene.model.frame.places
    stage.post(Action("strike"))
    until_aiming(stage)
    assert stage.scene.model.frame.places != places
    stage.post(Action("undo"))
    assert stage.scene.model.frame.places == places
    stage.post(Action("undo"))
    assert any("Nothing to undo" in words for words in stage.scene.messages())


def test_the_second_player_moves_the_yellow_ball():
    stage = level_of(
        f"{PLACED}[content.saved]\ngame = 'carom'\nturn = 1\nopening = false\ninnings = [1, 1]\n"
    )
    stage.scene.course.begin_stroke(Stroke(2.0, 0.5 * math.pi))
    while stage.scene.course.phase != "rolling":
        seconds(stage, 0.05)
    seconds(stage, 0.3)
    places = stage.scene.model.places
    assert places[[WHITE, RED]].tolist() == [[0.9, 0.7], [0.71, 2.13]]
    assert places[YELLOW, 1] > 1.2


# -- matches ----------------------------------------------------------------------------------------


def test_grades_are_those_of_the_players():
    assert tuple(CAROM_GRADES) == GRADES


def test_two_computer_players_play_and_their_recording_replays():
    stage = open_level("masters")
    for name in ("first_player", "second_player"):
        stage.post(SetParameter(name, "novice"))
    for _ in range(400):
        stage.listen(at_once=True)
        if stage.scene.course.phase == "rolling":
            stage.post(Action("strike"))
        seconds(stage, 0.2)
        if stage.scene.model.frame.strokes >= 4 and stage.scene.course.phase == "aiming":
            break
    frame = stage.scene.model.frame
    assert frame.strokes >= 4 and sum(frame.game.innings) >= 2
    assert stage.scene.opponents.thinker.failure == ""
    recording = recorded(stage)
    assert sum(isinstance(stamped.event, Decision) for stamped in recording.events) >= 4
    assert replay_scene(recording, CaromScene).digest() == stage.digest()


def test_a_player_weighs_what_a_stroke_leaves():
    frame = open_level("practice").scene.model.frame
    grade = CAROM_GRADES["expert"]._replace(looks=GLANCE, planned=3, ahead=2.0)
    position = position_of(frame)
    drawn = whole_map(position, grade.noise, GLANCE)
    choices = weigh(position, drawn, grade)
    assert [choice.worth for choice in choices] == sorted((c.worth for c in choices), reverse=True)
    for choice in choices:
        assert choice.worth == pytest.approx(choice.group.chance * (1.0 + 2.0 * choice.left))
    assert sum(choice.left > 0.0 for choice in choices) >= 1
    made = decide_carom(frame, grade)
    assert made.stroke == choices[0].group.stroke
    shaken = hand_of(made.stroke, grade, 3)
    assert shaken != made.stroke and shaken == hand_of(made.stroke, grade, 3)


def test_who_comes_to_balls_that_touch_chooses():
    stage = open_level("hard-02-balls-that-touch")
    assert [option.name for option in stage.scene.model.frame.game.options] == ["away", "spots"]
    stage.post(Action("strike"))
    assert stage.scene.course.phase == "aiming"
    click(stage, *layout.option_box(1, 2).middle)
    assert stage.scene.model.frame.game.options == ()
    assert stage.scene.model.frame.places[RED] == (0.71, pytest.approx(2.13))
    assert fits(stage.scene.model.frame.positions)


def test_computer_players_choose_too():
    stage = level_of("white = [0.6, 1.2]\nyellow = [1.1, 2.0]\nred = [0.6615, 1.2]\n", first_player="novice")
    for _ in range(20):
        stage.listen(at_once=True)
        seconds(stage, 0.2)
    assert stage.scene.model.frame.game.options == () or stage.scene.model.frame.strokes > 0
    assert stage.scene.opponents.thinker.failure == ""


def test_the_table_plays_by_itself_and_is_taken_over():
    stage = open_level("practice")
    stage.post(Action("demo"))
    seconds(stage, 4.0)
    assert stage.scene.model.frame.last is not None
    until_aiming(stage)
    press(stage, 0.9, 1.9)
    assert not stage.scene.course.plays_itself


def test_a_match_of_two_machines_begins_again():
    stage = level_of("", first_player="novice", second_player="novice", target=1, innings=1)
    scene = stage.scene
    scene.model.frame = scene.model.frame.replace(
        game=msgspec.structs.replace(scene.model.frame.game, ended=True)
    )
    seconds(stage, CaromOpponents.stays_s + 1.0)
    assert not scene.model.frame.game.ended and scene.model.frame.game.turn == 1


def test_the_cloth_acts_from_the_next_stroke_on():
    def end(cloth):
        stage = open_level("practice", cloth=cloth)
        stage.post(Action("strike"))
        until_aiming(stage)
        return stage.scene.model.frame.places[WHITE]

    assert end("club") != end("heated")
    stage = open_level("practice")
    stage.post(SetParameter("cloth", "club"))
    assert stage.scene.model.frame.physics.rolling == pytest.approx(0.0095)


def test_the_length_of_a_match_can_be_changed():
    stage = level_of("", target=9)
    stage.post(SetParameter("target", 4))
    assert stage.scene.model.frame.game.target == 4


# -- kept, and refused ------------------------------------------------------------------------------


def test_a_saved_game_opens_as_it_was():
    stage = level_of(PLACED)
    stage.post(Action("strike"))
    until_aiming(stage)
    content = stage.scene.save_content()
    game, places = stage.scene.model.frame.game, stage.scene.model.frame.places
    text = msgspec.json.decode(msgspec.json.encode(content))
    again = msgspec.convert(text, CaromContent)
    scene = CaromScene(level=msgspec.structs.replace(stage.scene.level, content=again))
    assert scene.model.frame.game == game and scene.model.frame.places == places
    assert stage.scene.worth_keeping() == (game, places)
    assert open_level("practice").scene.worth_keeping() is None


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("white = [0.9, 0.7]", "yellow"),
        ("white = [0.9, 0.7]\nyellow = [0.91, 0.7]\nred = [0.7, 2.0]", "two balls"),
        ("white = [0.01, 0.7]\nyellow = [0.5, 0.7]\nred = [0.7, 2.0]", "cushion"),
        ('game = "snooker"', "game"),
        ("[content.saved]\npoints = [1]", "saved"),
        ("[content.saved]\ngame = 'carom'\nturn = 2", "turn"),
    ],
)
def test_bad_levels_are_refused_by_field_and_reason(content, says):
    with pytest.raises(LevelError, match=says):
        level = parse_level(f'scene = "carom"\n[content]\n{content}', "carom", CaromScene.content_type)
        Stage(CaromScene, level=level)


@pytest.mark.parametrize(
    "event", [Decision("show", (1.0,)), Decision("boast", ()), Decision("play", (1.0, 0.0, 0.0, 0.9, 0.9))]
)
def test_decisions_that_cannot_be_are_refused(event):
    stage = open_level("practice")
    before = stage.digest()
    with pytest.raises(ValueError):
        stage.post(event)
    assert stage.digest() == before


def test_what_is_heard_and_measured():
    stage = open_level("practice")
    assert stage.scene.hearing() is None
    stage.scene.course.begin_stroke(Stroke(3.0, 0.5 * math.pi))
    for _ in range(400):
        if stage.scene.course.phase == "rolling":
            break
        seconds(stage, 0.05)
    seconds(stage, 1.5)
    heard = stage.scene.hearing()
    assert [sound.kind for sound in heard.sounds[:2]] == ["tip", "cushion"]
    measured = {readout.name: readout.value for readout in stage.scene.readouts()}
    assert measured["energy"] > 0.0 and measured["cushions"] >= 1 and measured["cue ball"] > 0.0


def test_boxes_do_not_overlap():
    boxes = [layout.TABLE, layout.BOARD, layout.LIST, layout.TIP, layout.FOOT]
    boxes += [layout.button_box(k) for k in range(len(layout.BUTTONS))]
    frame = layout.FRAME
    for k, box in enumerate(boxes):
        assert (
            frame.left <= box.top < box.bottom <= frame.right
            and frame.bottom <= box.left < box.right <= frame.top
        )
        for other in boxes[:k]:
            apart = (
                box.top >= other.bottom
                or box.bottom <= other.top
                or box.left >= other.right
                or box.right <= other.left
            )
            assert apart, (box, other)
    last = layout.row_box(layout.ROWS - 1)
    assert last.bottom <= layout.LIST.bottom
    assert np.hypot(*np.subtract(layout.TIP_MIDDLE, layout.TIP.middle)) < 1.0
    assert layout.row_at(*layout.row_box(3).middle) == 3 and layout.row_at(0.0, 0.0) == -1
    assert YELLOW == 1 and BALL_RADIUS > 0.0


@pytest.mark.parametrize(("start", "points"), [(3, (3, 0)), (-2, (0, 2))])
def test_a_head_start_begins_with_points_and_without_an_average(start, points):
    stage = open_level("straight-rail", head_start=start)
    game = stage.scene.model.frame.game
    assert game.points == game.given == points
    assert {one.name: one.value for one in stage.scene.readouts()}["average"] == 0.0
    assert read_game(msgspec.to_builtins(game)) == game
    old = {name: value for name, value in msgspec.to_builtins(game).items() if name != "given"}
    assert read_game(old).given == (0, 0), "a game that was kept before head starts were told apart"
