"""The lessons at snooker and carom: each is done as it says, and not by the stroke of another one."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.level_index import lessons_of, next_lesson
from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import carom_trajectory
from game.billiards.game.carom_summary import CaromSummary, as_shot
from game.billiards.game.goals import Goal, Pot, Zone, missed, stars_of
from game.billiards.game.rules import CUE_BALL
from game.billiards.table.carom import RED, WHITE, YELLOW
from game.billiards.table.snooker import name_of
from game.levels import LevelError, level_files
from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables.lessons.order import LAST, LESSON, level_after
from game.scenes.snooker.scene import SnookerScene
from game.stage import Action, Stage, replay_scene
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.carom import carom_stages as carom
from tests.scenes.snooker import snooker_stages as snooker

TABLES = {"snooker": (snooker, SnookerScene), "carom": (carom, CaromScene)}
LESSONS = [
    (table, path.stem) for table in TABLES for path in level_files(table) if path.stem.startswith(LESSON)
]


def struck(table: str, stage: Stage, stroke: Stroke) -> Stage:
    """Play a stroke of a person to its end."""
    course, chosen = stage.scene.course, stage.scene.parameters
    course.cue.point_to(stroke.azimuth)
    chosen.power = stroke.cue_speed * course.ball_per_cue
    chosen.tip_left, chosen.tip_up, chosen.elevation = stroke.tip_left, stroke.tip_up, 0.0
    if table == "snooker":
        course.locked = True
    stage.post(Action("strike"))
    stages = TABLES[table][0]
    stages.seconds(stage, 0.1)
    return stages.until_aiming(stage)


def test_there_are_the_same_five_at_every_table_and_the_start_card_finds_them():
    names = [path.stem for path in level_files("billiards") if path.stem.startswith(LESSON)]
    for table in TABLES:
        assert [name for where, name in LESSONS if where == table] == names
        heads = lessons_of(table)
        assert [head.path.stem for head in heads] == names and next_lesson(heads) == heads[0]
    assert [level_after(name) for name in names] == [*names[1:], LAST]


@pytest.mark.parametrize(("table", "name"), LESSONS)
def test_the_solution_wins_three_stars_and_the_next_lesson_follows(table: str, name: str):
    stage = TABLES[table][0].open_level(name)
    scene = stage.scene
    lesson, before = scene.model.content.lesson, scene.model.frame
    assert scene.stars == (0, 3) and scene.level_wanted == ""
    struck(table, stage, lesson.solution.stroke())
    assert scene.stars == (3, 3)
    assert scene.model.frame.words[0] == "★★★"
    assert scene.model.seen() is not None and scene.model.frame.last is not None, "it can be seen again"
    lies = (lambda frame: frame.places) if table == "carom" else (lambda frame: frame.layout.places)
    assert lies(scene.model.frame) == lies(before), "it can be tried again at once"
    assert scene.course.may_aim
    stage.post(Action("lesson"))
    assert scene.level_wanted == level_after(name)


@pytest.mark.parametrize("table", TABLES)
def test_a_lesson_replays_to_the_bit(table: str):
    stage = TABLES[table][0].open_level("lesson-1-stop")
    stage.post(Action("strike"))
    TABLES[table][0].seconds(stage, 0.1)
    TABLES[table][0].until_aiming(stage)
    assert stage.scene.model.frame.words
    stage.post(Action("lesson"))
    TABLES[table][0].seconds(stage, 0.1)
    assert replay_scene(stage.recording, TABLES[table][1]).digest() == stage.digest()


@pytest.mark.parametrize("table", TABLES)
def test_a_missed_stroke_says_why_in_the_words_of_the_table(table: str):
    stage = TABLES[table][0].open_level("lesson-2-follow")
    stroke = stage.scene.model.content.lesson.solution.stroke()
    struck(table, stage, stroke._replace(azimuth=stroke.azimuth + 1.5))
    assert stage.scene.stars == (0, 3)
    said = " ".join(stage.scene.model.frame.words)
    assert ("red did not go down" if table == "snooker" else "did not touch the yellow") in said


def stars_without(table: str, name: str, left: float, up: float) -> int:
    """Most stars that strokes with the tip at (left, up) win, at whatever speed, aimed about the ball."""
    stage = TABLES[table][0].open_level(name)
    frame, lesson = stage.scene.model.frame, stage.scene.model.content.lesson
    aim, most = lesson.solution.stroke().azimuth, 0
    for speed in np.linspace(0.9, 3.3, 7):
        for turn in np.radians(np.linspace(-1.2, 1.2, 13)):
            played = frame.play(Stroke(float(speed), aim + float(turn), 0.0, left, up))
            shot = as_shot(played.summary, WHITE) if table == "carom" else played.summary
            most = max(most, stars_of(lesson.goals, shot))
    return most


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize(
    ("name", "up"), [("lesson-2-follow", -0.4), ("lesson-3-draw", 0.3), ("lesson-4-side", 0.0)]
)
def test_a_lesson_wants_the_spin_that_it_teaches(table: str, name: str, up: float):
    assert stars_without(table, name, 0.0, up) < 3


def test_a_stroke_at_carom_is_seen_as_goals_see_one():
    path = (("ball", YELLOW), ("cushion", 2), ("ball", RED), ("ball", YELLOW))
    rest = np.array([[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]])
    shot = as_shot(CaromSummary(path, rest, off_table=(RED,)), WHITE)
    assert shot.first == (1,) and shot.touched == (1, 2) and shot.off_table == (2,)
    assert shot.cue_path == (("ball", 1), ("cushion", 2), ("ball", 2), ("ball", 1))
    assert shot.rest == ((CUE_BALL, 0.1, 0.2), (1, 0.3, 0.4))
    other = as_shot(CaromSummary((("ball", WHITE), ("ball", RED)), rest), YELLOW)
    assert other.first == (1,) and other.touched == (1, 2)
    assert other.rest == ((1, 0.1, 0.2), (CUE_BALL, 0.3, 0.4), (2, 0.5, 0.6))


def test_goals_of_a_real_stroke_at_carom_are_those_of_its_path():
    stage = carom.open_level("lesson-1-stop")
    frame = stage.scene.model.frame
    stroke = stage.scene.model.content.lesson.solution.stroke()
    shot = as_shot(frame.play(stroke).summary, WHITE)
    end = carom_trajectory(frame, stroke).end[0, :2]
    assert math.dist(shot.rest[0][1:], end) < 1e-12
    assert not missed(Goal(cue_touches=(1,), zones=(Zone(0, *map(float, end), 0.001),)), shot)
    assert missed(Goal(cue_touches=(1, 2)), shot)


def test_goals_speak_of_balls_up_to_the_black_and_only_where_it_lies():
    shot = snooker.open_level("lesson-1-stop").scene.model.frame.play(Stroke(1.0, 0.0)).summary
    assert missed(Goal(pots=(Pot(21),)), shot, name_of) == ("The black did not go down.",)
    with pytest.raises((LevelError, ValueError), match="no ball 16"):
        pool.level_of(
            'game = "drill"\nballs = [{number = 0, position = [0.5, 0.5]}, '
            "{number = 1, position = [0.5, 1.0]}]\n[content.goal]\npots = [{ball = 16}]"
        )
    with pytest.raises((LevelError, ValueError), match="no ball 3"):
        carom.level_of('[content.lesson]\nsays = "x"\n[content.lesson.goal]\ncue_touches = [3]')


def test_no_ball_is_moved_by_hand_in_a_lesson():
    stage = carom.open_level("lesson-1-stop")
    places = stage.scene.model.frame.places
    carom.press(stage, *places[1])
    assert stage.scene.course.grip.kind.name != "BALL"
