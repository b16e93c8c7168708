"""Soft bodies as a person meets them: levels come to what they expect; the hand, the effects, the picture."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import level_files, load_level
from game.scenes.deformables.scene import Deformables
from game.stage import ParameterError, Pointer, SetEffect, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import measured

LEVELS = {path.stem: path for path in level_files("p04")}
HARD = [name for name in LEVELS if name.startswith("hard-")]


def opened(name: str) -> Stage:
    return Stage(Deformables, level=load_level(LEVELS[name], "p04", Deformables.content_type))


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name):
    stage = opened(name)
    stage.run(math.ceil(0.5 / stage.dt))
    content = stage.scene.model.content
    assert content.expected
    assert all(caption.met for caption in captions_of(content.expected, stage.readouts()))


def test_what_is_fast_and_thin_is_on_the_other_side():
    stage = opened("hard-07-fast-and-thin")
    owners = stage.scene.model.bodies.store.topology.mesh_of
    seen = []
    for _ in range(4):
        seen.append(stage.scene.model.bodies.points[owners == 1, 0].mean())
        stage.run(1)
    assert seen[0] < 0.2 < seen[-1]


@pytest.mark.parametrize("name", ["default", "worm", "combs"])
def test_in_a_level_bodies_come_to_lie_on_each_other(name):
    stage = opened(name)
    stage.run(150)
    bodies = stage.scene.model.bodies
    assert measured(stage, "contacts") > 0 and measured(stage, "edges crossing") > 0
    assert measured(stage, "deepest") < 0.08
    assert bodies.points[:, 1].min() > -0.05 and np.abs(bodies.points[:, 0]).max() < 1.65


def test_twenty_thousand_triangles_are_there_and_found():
    stage = opened("many")
    assert measured(stage, "triangles") == 20_100
    stage.run(2)
    assert stage.scene.model.wrong() is None


def test_the_hand_drags_a_body_and_lets_go():
    stage = Stage(Deformables)
    system = stage.scene.model.bodies.system
    x, y = system.positions[0]
    stage.post(Pointer("down", x, y, button=1))
    assert system.held == 0
    stage.post(Pointer("move", x, 9.0, button=1))
    stage.run(12)
    assert system.positions[0, 1] > y + 0.5
    stage.post(Pointer("up", x, 9.0, button=1))
    assert system.held == -1


def test_effects_switch_contacts_and_pushing():
    stage = opened("worm")
    stage.run(90)
    assert measured(stage, "self-contacts") > 0
    stage.post(SetEffect("self-contacts", False))
    assert measured(stage, "contacts") == 0
    stage.post(SetEffect("self-contacts", True))
    stage.post(SetEffect("pushing", False))
    before = measured(stage, "deepest")
    stage.run(30)
    assert before > 0.0 and measured(stage, "contacts") > 0


def test_cells_and_slots_change_work_and_not_what_is_found():
    stage = opened("hard-04-seven-slots")
    found, work = measured(stage, "contacts"), measured(stage, "false cells")
    stage.post(SetParameter("table", 100_003))
    assert measured(stage, "contacts") == found and measured(stage, "false cells") < 0.1 < work
    stage.post(SetParameter("cell", 3.0))
    assert measured(stage, "contacts") == found
    with pytest.raises(ParameterError, match="table"):
        stage.post(SetParameter("table", 0))


def test_the_picture_differs_in_each_view():
    prepare()
    seen = set()
    for view, shown in (("meshes", True), ("cells", True), ("table", True), ("meshes", False)):
        stage = Stage(Deformables, parameters={"view": view, "contacts": shown, "strip": shown})
        stage.run(30)
        seen.add(np.asarray(picture_of_stage(stage, (320, 180), "light").get_buffer()).tobytes())
    assert len(seen) == 4


@pytest.mark.parametrize("name", LEVELS)
def test_bodies_begin_within_the_picture_and_a_hand_takes_hold_of_them(name):
    stage = opened(name)
    frame, points = stage.scene.frame(), stage.scene.model.bodies.points
    assert np.all((points[:, 0] > frame.left) & (points[:, 0] < frame.right))
    x, y = points[np.argmax(points[:, 1])].tolist()
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("move", x + 0.05, y, button=1))
    stage.run(10)
    assert np.min(np.hypot(*(stage.scene.model.bodies.points - (x + 0.05, y)).T)) < 0.03


def test_vertices_and_edges_of_a_contact_have_marks_of_different_shape_and_colour():
    shapes = [mark.split(":") for mark, words, _ in opened("default").scene.legend() if "fixed" not in words]
    assert len({shape for shape, _ in shapes}) == len({color for _, color in shapes}) == len(shapes)
