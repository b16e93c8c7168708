"""Balls that have flown out of view begin again; what friction took stays lost whatever the hand does."""

import numpy as np
import pytest

from game.levels import Level, level_files
from game.physics.solids.tracks.motion import FREE, PIECE, VX, VY, X, Y
from game.scenes.tracks.level import BallEntry, GaugeEntry, TrackContent, View
from game.scenes.tracks.scene import Tracks
from game.stage import SetEffect, SetParameter, Stage
from game.worlds.entries.tracks import TrackEntry
from tests.scenes.particle_stages import move, open_level, press, readouts, release

NAMES = [file.stem for file in level_files("tracks")]


def fastest(stage):
    return float(np.hypot(*stage.scene.model.rows[:, VX : VY + 1].T).max(initial=0.0))


@pytest.mark.parametrize("name", [name for name in NAMES if not name.startswith(("hard", "empty"))])
def test_no_stage_is_empty_after_half_a_minute(name):
    stage = open_level(Tracks, name)
    view, seen = stage.scene.frame(), 0
    for _ in range(60):
        stage.run(round(0.5 / stage.dt))
        x, y = stage.scene.model.rows[:, X : Y + 1].T
        there = (x > view.left) & (x < view.right) & (y > view.bottom) & (y < view.top)
        seen += bool(there.any())
        assert fastest(stage) < 25.0
    assert stage.fault is None and seen >= 54


def test_a_ball_comes_back_as_it_began_on_its_track():
    stage = open_level(Tracks, "default")
    rows = stage.scene.model.rows
    first, pieces = rows.copy(), stage.scene.model.tracks.riders.balls.pieces.copy()
    for _ in range(round(12.0 / stage.dt)):
        before = rows[:, X].copy()
        stage.run(1)
        back = np.flatnonzero(np.abs(rows[:, X] - before) > 2.0)
        if len(back):
            break
    (ball,) = back.tolist()
    assert np.allclose(rows[ball, : VY + 1], first[ball, : VY + 1])
    assert stage.scene.model.tracks.riders.balls.pieces[ball, PIECE] == pieces[ball, PIECE] != FREE
    assert (stage.scene.model.balls.trail[:, ball] == rows[ball, X : Y + 1]).all()
    stage.step_back()
    assert abs(stage.scene.model.rows[ball, X] - first[ball, X]) > 2.0
    stage.run(1)
    assert np.allclose(stage.scene.model.rows[ball, : VY + 1], first[ball, : VY + 1])


def falling(**parameters):
    content = TrackContent(
        balls=(BallEntry(position=(0.0, 1.0), velocity=(0.5, 0.0), spin=3.0, seated=False),),
        view=View(left=-1.0, bottom=0.0, right=1.0, top=2.0),
    )
    return Stage(Tracks, level=Level(scene="tracks", content=content), parameters=parameters)


def test_one_that_falls_is_back_when_it_is_half_a_view_below_and_its_loss_is_nothing():
    stage = falling()
    row = stage.scene.model.rows[0]
    lowest = 1.0
    for _ in range(round(3.0 / stage.dt)):
        stage.run(1)
        lowest = min(lowest, float(row[Y]))
    assert -1.0 < lowest < -0.9 and stage.scene.model.rows[0, VX] == 0.5
    assert abs(readouts(stage)["lost"]) < 1e-6


def test_whoever_wants_it_lets_them_fall():
    stage = falling(again=False)
    stage.run(round(3.0 / stage.dt))
    assert stage.scene.model.rows[0, Y] < -20.0


def test_a_ball_that_the_hand_has_put_somewhere_begins_there():
    stage = falling()
    press(stage, (0.0, 1.0))
    move(stage, (0.4, 1.6))
    release(stage, (0.4, 1.6))
    stage.run(round(0.7 / stage.dt))
    rows = stage.scene.model.rows
    places = []
    for _ in range(round(1.0 / stage.dt)):
        stage.run(1)
        places.append(rows[0, X : Y + 1].tolist())
    assert min(abs(x - 0.4) + abs(y - 1.6) for x, y in places) < 0.02
    assert all(x == pytest.approx(0.4) for x, _ in places)


@pytest.mark.parametrize("edit", ["hold", "draw", "gravity", "effect", "new ball", "delete"])
def test_what_is_lost_stays_lost_after_an_edit(edit):
    content = TrackContent(
        tracks=(TrackEntry(points=((-4.0, 3.0), (-2.0, 1.0), (0.0, 0.4), (2.0, 1.0), (4.0, 3.0))),),
        balls=(BallEntry(position=(-3.0, 2.0), friction=0.05),),
    )
    stage = Stage(Tracks, level=Level(scene="tracks", content=content), parameters={"again": False})
    stage.run(round(3.0 / stage.dt))
    before = readouts(stage)["lost"]
    assert before > 1e-3
    rows = stage.scene.model.rows
    if edit == "hold":
        place = tuple(rows[0, X : Y + 1].tolist())
        press(stage, place)
        move(stage, (place[0], place[1] + 0.5))
        release(stage, (place[0], place[1] + 0.5))
    elif edit == "draw":
        stage.post(SetParameter("tool", "draw"))
        press(stage, (-3.5, 3.0))
        for k in range(8):
            move(stage, (-3.5 + 0.3 * k, 3.0))
        release(stage, (-1.0, 3.0))
    elif edit == "gravity":
        stage.post(SetParameter("gravity", 3.0))
    elif edit == "effect":
        stage.post(SetEffect("gravity", False))
    elif edit == "new ball":
        stage.post(SetParameter("tool", "ball"))
        press(stage, (0.0, 3.0))
        release(stage, (0.0, 3.0))
    else:
        stage.post(SetParameter("tool", "delete"))
        press(stage, tuple(rows[0, X : Y + 1].tolist()))
    now = readouts(stage)["lost"]
    assert now == pytest.approx(before, rel=1e-6)
    stage.run(60)
    assert readouts(stage)["lost"] >= now - 1e-6 * abs(now)


@pytest.mark.parametrize(("measure", "stays"), [("speed", [0]), ("high", [0]), ("period", [0]),
                                                ("past", [0, 1]), ("leaves", [])])  # fmt: skip
def test_a_ball_on_which_a_gauge_goes_on_measuring_does_not_come_back(measure, stays):
    content = TrackContent(
        balls=(
            BallEntry(position=(-0.5, 1.0), seated=False), BallEntry(position=(0.5, 1.0), seated=False),
        ),
        gauges=(GaugeEntry(name="measured", measure=measure, of=0, level=5.0),),
        view=View(left=-1.0, bottom=0.0, right=1.0, top=2.0),
    )  # fmt: skip
    stage = Stage(Tracks, level=Level(scene="tracks", content=content))
    stage.run(round(3.0 / stage.dt))
    fallen = np.flatnonzero(stage.scene.model.rows[:, Y] < -10.0).tolist()
    assert fallen == stays
