"""The first ten minutes: each lesson can be done as it says, and not by the stroke of the one before."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.search.chances import pocket_of
from game.billiards.search.legality import Legality
from game.billiards.search.strokes import Board
from game.levels import level_files
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view.words import line_of
from game.scenes.shared.tables.lessons.order import LAST, LESSON, level_after
from game.stage import Action, Stage, replay_scene
from tests.scenes.billiards.billiards_stages import open_level, seconds, until_aiming

LESSONS = [path.stem for path in level_files("billiards") if path.stem.startswith(LESSON)]


def struck(stage: Stage, stroke: Stroke) -> Stage:
    """Play a stroke of a person to its end."""
    stage.scene.aiming.aim_as(stroke)
    stage.post(Action("strike"))
    seconds(stage, 0.1)
    return until_aiming(stage)


def strokes_that_pot(frame: Frame, lefts, ups) -> tuple[np.ndarray, np.ndarray]:
    """Strokes (m, 5) of a grid that send the 1 into the pocket of the goal, and where the cue ball ends."""
    board = Board(frame.layout, frame.table, frame.physics)
    goal = frame.game.goal.pots[0]
    (cx, cy), (ox, oy) = frame.layout.positions.tolist()
    middle = math.atan2(oy - cy, ox - cx)
    strokes = np.array(
        [
            (speed, middle + turn, 0.0, left, up)
            for speed in np.linspace(0.7, 3.5, 12)
            for left in lefts
            for up in ups
            for turn in np.radians(np.linspace(-7.0, 7.0, 113))
        ]
    )
    outcomes = board.play(strokes)
    down = pocket_of(board, outcomes, Legality.free(board), 1) == goal.pocket
    return strokes[down], outcomes.places[down, board.cue]


def rings(frame: Frame) -> list[float]:
    """Radii of the rings, m, the widest first."""
    return [goal.zones[0].radius for goal in (frame.game.goal, *frame.game.more)]


def distance(frame: Frame, ends: np.ndarray) -> np.ndarray:
    """How far ends (m, 2) are from the middle of the rings, m."""
    zone = frame.game.goal.zones[0]
    return np.hypot(*(ends - (zone.x, zone.y)).T)


@pytest.mark.parametrize("name", LESSONS)
def test_the_solution_wins_three_stars_and_its_replay_too(name: str):
    stage = open_level(name)
    frame = stage.scene.model.frame
    radii = rings(frame)
    assert len(radii) == 3 and radii == sorted(radii, reverse=True)
    assert line_of(stage.scene.play, None).lead == stage.scene.model.content.lesson
    struck(stage, stage.scene.model.content.solution.stroke())
    assert stage.scene.stars == (3, 3)
    assert "next lesson" in line_of(stage.scene.play, None).more
    stage.post(Action("lesson"))
    assert stage.scene.level_wanted == level_after(name)
    assert stage.scene.model.frame.layout.places == frame.layout.places, "it can be tried again at once"


def test_a_lesson_replays_to_the_bit():
    stage = open_level(LESSONS[0])
    stage.post(Action("strike"))
    seconds(stage, 3.0)
    stage.post(Action("lesson"))
    seconds(stage, 0.1)
    assert replay_scene(stage.recording, Billiards).digest() == stage.digest()


@pytest.mark.parametrize(
    ("name", "lefts", "ups"),
    [
        ("lesson-2-follow", (0.0,), (-0.5, -0.3)),
        ("lesson-3-draw", (0.0,), (0.0, 0.25, 0.5)),
        ("lesson-4-side", (0.0,), (0.0,)),
    ],
)
def test_a_lesson_wants_the_spin_that_it_teaches(name: str, lefts, ups):
    """No stroke without it, at whatever speed, wins three stars."""
    frame = open_level(name).scene.model.frame
    strokes, ends = strokes_that_pot(frame, lefts, ups)
    assert len(strokes) > 80
    assert distance(frame, ends).min() > rings(frame)[2]


def test_the_lesson_of_speed_needs_no_spin_and_not_just_any_speed():
    frame = open_level("lesson-5-speed").scene.model.frame
    strokes, ends = strokes_that_pot(frame, (0.0,), (0.0,))
    apart = distance(frame, ends)
    assert not open_level("lesson-5-speed").scene.model.content.solution.tip_up
    fit = strokes[apart < rings(frame)[1], 0]
    assert 1.0 < fit.min() <= fit.max() < 2.6, "neither the softest nor the hardest"


def test_lessons_follow_each_other_and_lead_to_a_game():
    assert len(LESSONS) == 5
    assert [level_after(name) for name in LESSONS] == [*LESSONS[1:], LAST]
    assert level_after("drill-01-stop") == "" and level_after("default") == ""
    stage = open_level("drill-01-stop")
    stage.post(Action("lesson"))
    assert stage.scene.level_wanted == ""
