"""The scene of tracks: what levels expect is measured, and every tool does what it says."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import level_files
from game.physics.solids.tracks.motion import FREE, PIECE, SPEED, VY, X, Y
from game.scenes.tracks.scene import Tracks
from game.stage import Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.particle_stages import move, open_level, press, readouts, release

SECONDS = {"default": 6.5, "hard-01-loop-of-fifty-chords": 6.5, "bowl": 4.0, "cylinder": 3.0, "race": 2.0,
           "tautochrone": 2.0, "hard-02-uneven-points": 2.5, "hard-04-groove": 4.0}  # fmt: skip
LEVELS = [path.stem for path in level_files("tracks")]


@pytest.mark.parametrize("name", SECONDS)
def test_what_a_level_expects_is_measured(name):
    stage = open_level(Tracks, name)
    content = stage.scene.model.content
    assert content.expected
    stage.run(round(SECONDS[name] / stage.scene.dt))
    captions = captions_of(content.expected, stage.scene.readouts())
    assert [caption.words for caption in captions if not caption.met] == []


@pytest.mark.parametrize("chords", [20, 800])
def test_the_number_of_chords_changes_nothing_about_the_loop(chords):
    stage = open_level(Tracks, "default", chords=chords)
    stage.run(780)
    assert readouts(stage)["rode through"] == 1


def test_without_a_level_the_disc_rolls_through_the_loop():
    stage = Stage(Tracks)
    balls = stage.scene.model.tracks.riders.balls
    places = []
    for _ in range(96):
        stage.run(4)
        assert balls.pieces[0, PIECE] != FREE
        places.append(balls.rows[0, [X, Y]])
    x, y = np.array(places).T
    top = int(np.argmax(y * (np.abs(x) < 0.9)))
    assert y[top] > 1.8  # of a loop 2 m high, by a disc of 0.1 m
    assert x[:top].min() < -3.0 and x[top:].max() > 2.0


def test_the_speed_is_what_the_energy_says():
    stage = open_level(Tracks, "bowl")
    for _ in range(20):
        stage.run(17)
        found = readouts(stage)
        assert found["speed"] == pytest.approx(found["exact"], abs=1e-6)


def test_a_track_is_drawn_and_carries_a_ball():
    stage = open_level(Tracks, "bowl", tool="draw")
    before = len(stage.scene.model.tracks.riders.curves)
    path = [(x, -0.2 - 0.05 * x) for x in np.linspace(-2.0, 2.0, 60)]
    press(stage, path[0])
    for point in path[1:]:
        move(stage, point)
    release(stage, path[-1])
    stage.post(SetParameter("tool", "ball"))
    press(stage, (-1.5, 0.4))
    release(stage, (-1.5, 0.4))
    stage.run(120)
    model = stage.scene.model
    assert len(model.tracks.riders.curves) == before + 1
    assert model.tracks.riders.track_of(1) == before
    assert model.tracks.riders.balls.rows[1, SPEED] != 0.0


def test_a_drawing_that_is_cancelled_is_no_track():
    stage = open_level(Tracks, "bowl", tool="draw")
    before = len(stage.scene.model.tracks.riders.curves)
    press(stage, (-2.0, -0.2))
    for x in np.linspace(-1.9, 2.0, 20):
        move(stage, (x, -0.2))
    stage.post(Pointer("cancel", 0.0, 0.0))
    release(stage, (2.0, -0.2))
    assert len(stage.scene.model.tracks.riders.curves) == before


def test_a_ball_in_the_hand_stays_there_and_then_falls():
    stage = open_level(Tracks, "bowl")
    ball = stage.scene.model.tracks.riders.balls.rows[0, [X, Y]].copy()
    press(stage, ball)
    move(stage, (0.0, 1.0))
    stage.run(60)
    assert stage.scene.model.tracks.riders.balls.rows[0, [X, Y]] == pytest.approx([0.0, 1.0])
    release(stage, (0.0, 1.0))
    stage.run(10)
    assert stage.scene.model.tracks.riders.balls.rows[0, VY] < -0.5


def test_a_bend_moves_the_track_under_the_ball():
    stage = open_level(Tracks, "race", tool="bend")
    press(stage, (0.8, 2.7))
    for k in range(10):
        move(stage, (0.8, 2.7 - 0.02 * k))
        stage.run(1)
    release(stage, (0.8, 2.5))
    stage.run(5)
    model = stage.scene.model
    assert model.tracks.riders.balls.pieces[0, PIECE] != FREE
    middle = np.asarray(model.tracks.riders.curves[0].points)
    assert middle[np.abs(middle[:, 0] - 0.8).argmin(), 1] < 2.6


def test_delete_takes_a_ball_then_its_track():
    stage = open_level(Tracks, "bowl", tool="delete")
    place = stage.scene.model.tracks.riders.balls.rows[0, [X, Y]].copy()
    for at in (place, (1.0, 1.0)):
        press(stage, at)
        release(stage, at)
        stage.run(1)
    assert len(stage.scene.model.balls.energies) == 0 and len(stage.scene.model.tracks.riders.curves) == 0
    assert stage.fault is None


@pytest.mark.parametrize("name", ["default", "funnel"])
def test_a_saved_level_holds_the_same_balls_and_tracks(name):
    stage = open_level(Tracks, name)
    stage.run(50)
    content = stage.scene.save_content()
    model = stage.scene.model
    assert len(content.tracks) == len(model.tracks.riders.curves)
    assert [ball.position for ball in content.balls] == [
        tuple(row) for row in model.tracks.riders.balls.rows[:, X : Y + 1]
    ]


def test_steps_back_also_over_a_bent_track():
    stage = open_level(Tracks, "race", tool="bend")
    stage.run(20)
    digest = stage.digest()
    stage.run(1)
    press(stage, (0.8, 2.7))
    move(stage, (0.8, 2.4))
    release(stage, (0.8, 2.4))
    stage.run(19)
    assert stage.digest() != digest
    for _ in range(20):
        stage.step_back()
    assert stage.digest() == digest
