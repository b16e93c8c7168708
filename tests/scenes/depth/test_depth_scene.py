"""Two shapes that overlap as a person meets them: levels come to what they expect; hand and actions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely.geometry import Point, Polygon

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import level_files, load_level
from game.physics.narrowphase.depth import PRESETS, preset
from game.scenes.depth.borders import border_of, common
from game.scenes.depth.scene import Depth
from game.stage import Action, Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import measured
from tests.scenes.labels import labels_of

LEVELS = level_files("p32")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Depth, level=load_level(path, "p32", Depth.content_type))


@pytest.mark.parametrize("name", [path.stem for path in HARD])
def test_a_hard_level_comes_to_what_it_expects(name):
    stage = opened(name)
    stage.run(90 if stage.scene.model.content.moves else 1)
    assert stage.scene.model.content.expected
    assert all(caption.met for caption in captions_of(stage.scene.model.content.expected, stage.readouts()))


@pytest.mark.parametrize("name", [path.stem for path in LEVELS])
def test_brute_force_finds_nothing_shorter_in_any_level(name):
    stage = opened(name)
    stage.post(SetParameter("grid", 17))
    stage.post(Action("check"))
    tolerance = stage.scene.parameters.tolerance
    assert measured(stage, "brute force") >= measured(stage, "generalised") - tolerance
    assert measured(stage, "generalised") <= measured(stage, "translation")
    assert measured(stage, "left uncertain") <= tolerance


@pytest.mark.parametrize(("name", "least"), [("default", 80.0), ("slot", 80.0), ("gears", 30.0)])
def test_what_turning_saves_in_the_levels_that_say_so(name, least):
    assert measured(opened(name), "shorter by") > least


def test_a_moves_out_and_no_farther_than_the_norm_says():
    stage = opened("moving")
    sigma, speed = measured(stage, "generalised"), stage.scene.parameters.speed
    before = sigma
    steps = math.ceil(1.05 * sigma / (speed * stage.dt))
    for _ in range(steps):
        stage.run(1)
        now = measured(stage, "generalised")
        assert now <= before + stage.scene.parameters.tolerance
        before = now
    assert measured(stage, "generalised") == 0.0
    stage.run(1)
    assert not stage.scene.model.moves
    places = stage.scene.model.places.copy()
    stage.run(10)
    assert np.array_equal(stage.scene.model.places, places)


def test_the_hand_drags_and_turns_what_is_under_it():
    stage = opened("slot")
    scene = stage.scene
    x, y, turn = scene.model.places[0].tolist()
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("move", x + 0.1, y + 2.0, button=1))
    assert scene.model.places[0].tolist() == pytest.approx([x + 0.1, y + 2.0, turn])
    assert measured(stage, "generalised") == 0.0
    stage.post(Pointer("up", x + 0.1, y + 2.0, button=1))
    stage.post(Pointer("move", 0.0, 0.0))
    stage.post(Pointer("down", 0.5, 0.0, button=1, shift=True))  # B, right of its centroid
    stage.post(Pointer("move", 0.0, 0.5, button=1))
    assert scene.model.places[1].tolist() == pytest.approx([0.0, 0.0, 0.5 * math.pi])
    stage.post(Pointer("cancel", 0.0, 0.5))
    stage.post(Action("turn-right"))  # B, which was held last
    assert scene.model.places[1, 2] == pytest.approx(0.5 * math.pi - math.radians(5.0))
    stage.post(Pointer("down", 0.0, 0.5, button=3))
    stage.post(Pointer("move", -0.5, 0.0, button=3))
    assert scene.model.places[1, 2] == pytest.approx(math.pi - math.radians(5.0))
    stage.post(Pointer("up", -0.5, 0.0, button=3))
    stage.post(Action("again"))
    assert scene.model.places[0].tolist() == pytest.approx([x, y, turn])


def test_nothing_is_taken_in_the_gap_of_a_slot():
    stage = opened("slot")
    stage.post(Pointer("down", 0.1, -0.3, button=1))
    assert stage.scene.hand.at((0.1, -0.3)) == -1 and stage.scene.hand.at((0.3, -0.3)) == 1


def test_another_shape_is_measured_where_the_one_before_was():
    stage = opened("slot")
    places = stage.scene.model.places.copy()
    stage.post(SetParameter("shape_a", "disc"))
    assert np.array_equal(stage.scene.model.places, places)
    assert stage.scene.model.pair.a.reach == pytest.approx(0.75)
    assert measured(stage, "shorter by") < 5.0


def test_a_finer_tolerance_leaves_less_uncertain():
    stage = opened("stars")
    stage.post(SetParameter("tolerance", 0.1))
    coarse = measured(stage, "left uncertain"), measured(stage, "angles tried")
    stage.post(SetParameter("tolerance", 0.001))
    fine = measured(stage, "left uncertain"), measured(stage, "angles tried")
    assert fine[0] <= 0.001 < coarse[0] and fine[1] > coarse[1]


def test_a_saved_level_has_the_shapes_where_they_are():
    stage = opened("moving")
    stage.run(30)
    kept = stage.scene.save_content()
    for entry, place in zip((kept.a, kept.b), stage.scene.model.places.tolist(), strict=True):
        assert (*entry.position, math.radians(entry.turn)) == pytest.approx(
            (place[0], place[1], math.remainder(place[2], math.tau))
        )
    assert kept.moves and kept.a.size == 1.2


@pytest.mark.parametrize("name", PRESETS)
def test_the_outer_border_goes_once_round_the_area(name):
    """Green's theorem over the segments gives the area; no seam between parts is left."""
    shape = preset(name)
    border = border_of(shape)
    a, b = border[:, 0], border[:, 1]
    assert 0.5 * float(np.sum(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])) == pytest.approx(shape.area)
    middles, along = 0.5 * (a + b), b - a
    out = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
    parts = [Polygon(part) for part in shape.placed(0.0, 0.0, 0.0)]
    for point in middles + 1e-4 * out:
        assert not any(part.contains(Point(point)) for part in parts)


def test_what_two_polygons_share():
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    region = common(square, square + np.array((0.5, 0.25)))
    assert np.ptp(region, axis=0) == pytest.approx((0.5, 0.75)) and region.min(axis=0) == pytest.approx(
        (0.5, 0.25)
    )
    assert len(common(square, square + np.array((2.0, 0.0)))) == 0


def test_the_picture_shows_ways_curve_and_intervals():
    prepare()
    seen = set()
    for hidden in ((), ("ghosts",), ("curve",), ("intervals",)):
        stage = Stage(Depth, parameters=dict.fromkeys(hidden, False))
        seen.add(np.asarray(picture_of_stage(stage, (320, 180), "light").get_buffer()).tobytes())
    stage.post(Action("check"))
    seen.add(np.asarray(picture_of_stage(stage, (320, 180), "light").get_buffer()).tobytes())
    assert len(seen) == 5


@pytest.mark.parametrize("name", [path.stem for path in HARD])
def test_what_is_expected_stands_in_the_middle_above_the_shapes(name):
    """Not at the left, where the legend is."""
    stage = opened(name)
    canvas, frame = labels_of(stage), stage.scene.frame()
    stage.scene.draw(canvas, 1.0)
    for caption in captions_of(stage.scene.model.content.expected, stage.readouts()):
        (x, y), _, size, weight, _, (_, down) = canvas.drawn[caption.words]
        assert x == pytest.approx(0.5 * (frame.left + frame.right))
        assert y - (down + canvas.fonts.size(caption.words, size, weight)[1]) / canvas.pixels_per_unit > 1.8
