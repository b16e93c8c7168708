"""The tables with every parameter at both ends of its range: a stroke, and all that comes of it."""

import math

import numpy as np
import pytest

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.laws.contacts import CUSHION_MODELS
from game.billiards.table.rack import BALL_RADIUS
from game.levels import level_files, load_level
from game.scenes.billiards.scene import Billiards
from game.scenes.lecture_table.scene import LectureTable
from game.scenes.three_tables.places import ORIGINS
from game.scenes.three_tables.scene import ThreeTables
from game.scenes.two_balls.scene import LectureBalls
from game.stage import Action, Param, Pointer, Stage
from tests.scenes.billiards.billiards_stages import aim


def ends_of(scene):
    """(name, value) for both ends of every number that the scene declares."""
    numbers = [
        (name, parameter)
        for name, parameter in scene.declared_parameters().items()
        if isinstance(parameter, Param)
    ]
    assert len(numbers) > 5
    return [(name, value) for name, parameter in numbers for value in (parameter.minimum, parameter.maximum)]


def cases_of(scene):
    return pytest.mark.parametrize(
        ("name", "value"), ends_of(scene), ids=[f"{name}={value:g}" for name, value in ends_of(scene)]
    )


def opened(scene, level: str, **parameters) -> Stage:
    path = next(path for path in level_files(scene.name) if path.stem == level)
    return Stage(scene, level=load_level(path, scene.name, scene.content_type), parameters=parameters)


def run(stage: Stage, s: float) -> None:
    stage.run(round(s / stage.dt))
    assert stage.fault is None, stage.fault


def pull(stage: Stage, x: float, y: float) -> None:
    """Aim up the table at the rack, pull back, let go."""
    stage.post(Pointer("move", x, y + 1.0))
    stage.post(Pointer("down", x, y + 1.0, button=1))
    stage.post(Pointer("move", x, y + 0.7, button=1))
    stage.post(Pointer("up", x, y + 0.7, button=1))


@cases_of(Billiards)
def test_billiards(name, value):
    stage = opened(Billiards, "default", **{name: value})
    scene = stage.scene
    aim(stage, 0.5 * math.pi)
    before = scene.model.frame.layout.places
    stage.post(Action("strike"))
    for _ in range(300):
        run(stage, 0.25)
        assert scene.play.phase in ("striking", "rolling", "aiming")
        if scene.play.phase == "aiming":
            break
    assert scene.play.phase == "aiming" and scene.model.frame.strokes == 1
    assert scene.model.frame.last.frame.layout.places == before != scene.model.frame.layout.places


@pytest.mark.parametrize("cushion", sorted(CUSHION_MODELS))
def test_the_smallest_ball_of_all_meets_a_cushion(cushion):
    """The spread of radii ends where a nose is still below the top of the ball, whatever is drawn."""
    radius = (1.0 - Billiards.parameter("radius_spread").maximum) * BALL_RADIUS
    shot = make_shot(
        Table.pool(), [[0.6, 1.0]], [(-2.0, 0.3)], radii=radius, physics=Physics(cushion=cushion)
    )
    assert "ball-cushion" in [event.type for event in simulate(shot).events]


@cases_of(LectureTable)
def test_lecture_table(name, value):
    stage = opened(LectureTable, "free-play", **{name: value})
    model = stage.scene.model
    before = model.table.positions.copy()
    pull(stage, *before[0])
    run(stage, 6.0)
    assert model.strokes == 1
    assert np.isfinite(model.table.positions).all()
    assert (model.table.positions != before).any()


@cases_of(ThreeTables)
def test_three_tables(name, value):
    stage = opened(ThreeTables, "your-stroke", **{name: value})
    model = stage.scene.model
    x, y = model.start[0]
    pull(stage, x + ORIGINS[2][0], y + ORIGINS[2][1])
    run(stage, 1.5)
    assert model.playing and model.shown_s > 0.0
    assert (model.places[:, 0] != model.start[0]).any(axis=1).all(), "the cue ball moves on all three"
    assert np.isfinite(model.places).all()


@cases_of(LectureBalls)
def test_lecture_balls(name, value):
    stage = opened(LectureBalls, "default", **{name: value})
    before = [ball.position for ball in stage.scene.model.balls]
    run(stage, 10.0)
    assert stage.readouts()
    assert [ball.position for ball in stage.scene.model.balls] != before
