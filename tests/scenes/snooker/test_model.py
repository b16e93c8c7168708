"""The snooker table's model: places, turns, what parameters set, the word of a frame, readouts."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.table.snooker import BALL_MASS, BALLS
from game.scenes.shared.tables.course import REPLAY
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.snooker.readouts import readouts
from game.scenes.snooker.scene import SnookerScene
from tests.scenes.snooker.snooker_stages import level_of

TWO = """spotted = [16, 17, 18, 19, 20, 21]
balls = [{ number = 0, position = [0.5, 2.0] }, { number = 1, position = [1.2, 1.2] }]
"""


@pytest.fixture
def scene() -> SnookerScene:
    return level_of(TWO).scene


def test_balls_are_where_the_frame_has_them(scene):
    model = scene.course.model
    assert model.places.shape == (BALLS, 2) and model.places[0].tolist() == [0.5, 2.0]
    assert model.places[1].tolist() == [1.2, 1.2]
    for number, x, y in model.frame.layout.places:
        assert model.places[number].tolist() == [x, y]
    assert model.numbers == [] and model.played is None


def test_balls_begin_turned_as_somebody_left_them(scene):
    model = scene.course.model
    w, x, y, z = scattered_orientations(BALLS, model.seed_of_lots)[3]
    assert model.turns[3, :, 2] == pytest.approx(
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)]
    )
    assert np.array_equal(model.turns, model.turns_before)
    assert model.turns is not model.turns_before


def test_what_is_chosen_is_the_tables_and_the_games(scene):
    course = scene.course
    chosen, model = course.parameters, course.model
    chosen.sliding, chosen.rolling, chosen.ball_restitution, chosen.cushion_restitution = 0.3, 0.02, 0.9, 0.7
    other = next(word for word in type(chosen).miss.options if word != chosen.miss)
    chosen.best_of, chosen.miss = "5", other
    model.configure(scene.active)
    physics = model.frame.physics
    assert (physics.sliding, physics.rolling) == (0.3, 0.02)
    assert (physics.ball_restitution, physics.cushion_restitution) == (0.9, 0.7)
    assert model.game.best_of == 5 and model.game.miss_rule == other
    chosen.best_of = "open"
    model.configure(scene.active)
    assert model.game.best_of == 0


def test_equal_frames_have_equal_words(scene):
    model, other = scene.course.model, level_of(TWO).scene.course.model
    assert model.word == other.word and len(model.word) == 16
    moved = level_of(TWO.replace("1.2, 1.2", "1.2, 1.21")).scene.course.model
    assert moved.word != model.word
    kept = model.word
    model.frame = moved.frame
    assert model.word == moved.word != kept


@pytest.mark.compiled
def test_a_stroke_rolls_is_measured_and_settles(scene):
    """A rolling ball with nothing in its way: readouts against the trajectory's own numbers."""
    course, model = scene.course, scene.course.model
    model.strike(Stroke(1.0, 0.0), Call())
    played = model.played
    assert model.numbers == [number for number, _, _ in model.frame.last.frame.layout.places]
    course.clock[0] = 0.25
    model.roll(0.25)
    motion = played.trajectory.state_at(0.25)
    cue = model.numbers.index(CUE_BALL)
    assert np.array_equal(model.places[model.numbers], motion.positions)
    found = {}
    for phase in (REPLAY, "aiming"):
        course.phase = phase
        found[phase] = {one.name: (one.value, one.unit) for one in readouts(course)}
    energy = 0.5 * BALL_MASS * float((motion.velocities**2).sum())
    assert found[REPLAY]["energy"] == (pytest.approx(energy), "J")
    assert found[REPLAY]["cue ball"] == (pytest.approx(math.hypot(*motion.velocities[cue])), "m/s")
    assert found[REPLAY]["shot"] == (0.25, "s")
    assert found[REPLAY]["events"][0] == int((played.trajectory.times <= 0.25).sum())
    assert found[REPLAY]["break"][0] == model.game.run
    assert found[REPLAY]["points left"][0] == model.game.points_left
    still = [found["aiming"][name][0] for name in ("energy", "cue ball", "events", "shot")]
    assert still == [0.0, 0.0, 0, 0.0]
    before = model.turns.copy()
    model.settle()
    assert model.places[0] == pytest.approx(model.frame.layout.place_of(0) if model.frame.cue_ball else 0.0)
    assert not np.array_equal(model.turns[0], before[0]) and np.array_equal(model.turns[21], before[21])
    assert model.turns[0] @ model.turns[0].T == pytest.approx(np.eye(3), abs=1e-9)
    model.go_back_to(model.frame.last.frame)
    assert np.array_equal(model.turns, before) and model.places[0].tolist() == [0.5, 2.0]
