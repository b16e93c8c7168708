"""Levels that are over soon begin again; what is small is shown through a lens; captions have room."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.fountain.scene import Fountain
from game.scenes.shared.insets import Zoom, draw_inset
from game.scenes.shared.repeats import Repeat
from game.scenes.skeletons.skinning import Skinning
from game.scenes.spheres.scene import SphereCollisions
from game.scenes.springs.rigid_links import RigidLinks
from game.stage import Frame, SetParameter
from game.worlds.expectations import with_headroom
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import click, open_level

REPEATED = [(Fountain, "hard-07-graze"), (SphereCollisions, "hard-06-grazing")]


def places_of(stage):
    model = stage.scene.model
    return (
        model.system.positions.copy()
        if isinstance(stage.scene, Fountain)
        else model.world.bodies.places().copy()
    )


@pytest.mark.parametrize(("scene_type", "name"), REPEATED)
def test_it_begins_again_as_it_began(scene_type, name):
    stage = open_level(scene_type, name)
    period = round(stage.level.content.repeat / stage.dt)
    stage.run(40)
    early = places_of(stage)
    stage.run(period - 40)
    assert not np.array_equal(places_of(stage), early)
    stage.run(40)
    assert np.array_equal(places_of(stage), early)
    digest = stage.digest()
    stage.run(10)
    for _ in range(10):
        stage.step_back()
    assert stage.digest() == digest


@pytest.mark.parametrize(("scene_type", "name"), REPEATED)
def test_who_takes_part_goes_on(scene_type, name):
    stage = open_level(scene_type, name)
    click(stage, (-3.9, 4.4))
    stage.run(2 * round(stage.level.content.repeat / stage.dt) + 40)
    assert stage.scene.repeat.left is None
    assert np.abs(places_of(stage)).max() > 8.0


def test_a_repeated_fountain_keeps_what_was_set_meanwhile():
    stage = open_level(Fountain, "hard-06-fast-and-small")
    stage.run(10)
    stage.post(SetParameter("restitution", 0.5))
    stage.run(round(7.0 / stage.dt))
    assert stage.scene.model.system.solids.rows[0, 5] == 0.5


def test_time_left():
    repeat = Repeat(1.0)
    assert [repeat.advance(0.25) for _ in range(6)] == [False, False, False, False, True, False]
    assert repeat.left == pytest.approx(0.5)
    repeat.end()
    assert repeat.left is None and not Repeat(0.0).advance(1.0)


@pytest.mark.parametrize("corner", ["topleft", "topright", "bottomleft", "bottomright"])
def test_an_inset_shows_a_place_larger_in_its_corner(corner):
    stage = open_level(Fountain, "hard-10-nobody")
    canvas, view = labels_of(stage), Frame(-4.0, -1.0, 4.0, 4.0)
    seen = []

    def draw():
        seen.append((canvas.pixels_per_unit, canvas.camera.center, canvas.words))
        canvas.label((0.0, 0.0), "within", "text1")

    outside, words = canvas.pixels_per_unit, canvas.words
    draw_inset(canvas, view, Zoom(centre=(1.0, 2.0), times=20.0, corner=corner), draw)
    ((scale, centre, spoken),) = seen
    assert scale == pytest.approx(20.0 * outside) and centre == (1.0, 2.0) and not spoken
    assert canvas.pixels_per_unit == outside and canvas.words == words
    x, y = canvas.drawn["20 times"][0]
    assert (x > 0.0) == corner.endswith("right") and (y > 1.0) == corner.startswith("top")


def test_what_is_drawn_in_a_lens_stays_in_it():
    stage = open_level(Fountain, "hard-10-nobody")
    canvas = labels_of(stage)
    canvas.fill()
    empty = canvas.surface.copy()
    with canvas.magnified((0.0, 0.0), (1.0, 1.0), (3.0, 3.0), 10.0):
        canvas.circle((3.0, 3.0), 50.0, "amber")
    changed = np.argwhere(
        np.frombuffer(canvas.surface.get_buffer().raw, np.uint32).reshape(600, 1000)
        != np.frombuffer(empty.get_buffer().raw, np.uint32).reshape(600, 1000)
    )
    (left, top), (right, bottom) = canvas.camera.to_screen(0.0, 1.0), canvas.camera.to_screen(1.0, 0.0)
    assert changed[:, 1].min() == pytest.approx(left, abs=1) and changed[:, 1].max() + 1 == pytest.approx(
        right, abs=1
    )
    assert changed[:, 0].min() == pytest.approx(top, abs=1) and changed[:, 0].max() + 1 == pytest.approx(
        bottom, abs=1
    )


def test_captions_have_room_above_what_moves():
    frame = Frame(0.0, 0.0, 4.0, 2.0)
    assert with_headroom(frame, 0) == frame
    assert with_headroom(frame, 2).top > with_headroom(frame, 1).top > 2.0
    stage = open_level(SphereCollisions, "hard-06-grazing")
    assert stage.scene.frame().top > stage.level.content.view.top + 0.4


OF_A_LEVEL = ("expected", "repeat", "zoom", "paths", "sheet", "label", "beside", "pendulum", "guide")
TOLD = [
    (Fountain, "hard-06-fast-and-small"), (SphereCollisions, "hard-06-grazing"), (RigidLinks, "draw"),
    (RigidLinks, "pendulum"), (RigidLinks, "one-budget"), (Skinning, "draw"),
]  # fmt: skip


@pytest.mark.parametrize(("scene_type", "name"), TOLD)
def test_what_a_level_tells_is_saved_with_it(scene_type, name):
    stage = open_level(scene_type, name)
    stage.run(5)
    given, saved = stage.level.content, stage.scene.save_content()
    names = [field for field in OF_A_LEVEL if hasattr(given, field)]
    assert any(getattr(given, field) for field in names)
    assert [getattr(saved, field) for field in names] == [getattr(given, field) for field in names]
