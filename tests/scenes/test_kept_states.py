"""What a scene has become: it holds its own invariants, and can be saved and opened again."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import Level, load_level, parse_level, save_level
from game.physics.bounds import FITS, build_tree, tandem
from game.scenes.bounds.capsules import Capsules
from game.scenes.bounds.oriented_boxes import OrientedBoxes
from game.scenes.rigid_body.level import FARTHEST as FARTHEST_BODY
from game.scenes.rigid_body.scene import RigidBodyScene
from game.scenes.shared.outlines.level import FARTHEST
from game.scenes.spheres.level import FARTHEST as FARTHEST_SPHERE
from game.scenes.spheres.scene import SphereCollisions
from game.scenes.two_balls.scene import LectureBalls
from game.stage import SetParameter, Stage


def stage_of(scene_type, content: str) -> Stage:
    text = f'scene = "{scene_type.name}"\n{content}'
    return Stage(scene_type, level=parse_level(text, scene_type.name, scene_type.content_type))


def kept(stage: Stage, tmp_path):
    """The content as it is after having been saved and read again."""
    scene = stage.scene
    scene.check()
    path = tmp_path / "kept.toml"
    save_level(Level(scene=scene.name, content=scene.save_content()), path)
    level = load_level(path, scene.name, scene.content_type)
    Stage(type(scene), level=level).scene.check()
    return level.content


@pytest.mark.parametrize(
    "orientation",
    [(1e200, -1e200, 3e199, 0.0), (1.7e308, 1.7e308, 1.7e308, 1.7e308), (1e-149, 3e-149, 0, 5e-324)],
)
def test_spheres_are_turned_by_quaternions_of_any_length(orientation, tmp_path):
    entry = f"position = [0, 1]\norientation = {[float(part) for part in orientation]}"
    stage = stage_of(SphereCollisions, f"[[content.spheres]]\n{entry}\nturning = [1.0, 2.0, 3.0]")
    found = stage.scene.model.world.bodies.state.orientations[0]
    largest = max(map(abs, orientation))
    wanted = np.array([part / largest for part in orientation])
    np.testing.assert_allclose(found, wanted / np.linalg.norm(wanted), rtol=0.0, atol=1e-15)
    stage.run(20)
    kept(stage, tmp_path)


def test_spheres_that_have_flown_away_are_kept(tmp_path):
    stage = stage_of(
        SphereCollisions, "[[content.spheres]]\nposition = [0, 1]\n[[content.spheres]]\nposition = [3, 1]"
    )
    bodies = stage.scene.model.world.bodies
    bodies.state.positions[0] = (54_321.5, 2.0 * FARTHEST_SPHERE, 0.0)
    mass = bodies.composition.masses[0]
    bodies.state.momenta[0] = mass * np.array((-234_567.0, 3.0 * FARTHEST_SPHERE, 0.0))
    first, second = kept(stage, tmp_path).spheres
    assert first.position == (54_321.5, FARTHEST_SPHERE, 0.0)
    assert first.velocity == pytest.approx((-234_567.0, FARTHEST_SPHERE, 0.0), rel=1e-14)
    assert second.position == (3.0, 1.0, 0.0)


def test_a_body_that_has_run_away_is_kept(tmp_path):
    stage = stage_of(RigidBodyScene, "[[content.spheres]]\nposition = [0, 0, 0]\nradius = 1")
    body = stage.scene.model.bodies.all[0]
    body.position = (3e8, -2.0 * FARTHEST_BODY, 0.0)
    body.velocity, body.angular_velocity = (12_345.5, 0.0, 0.0), (0.0, 54_321.0, 0.0)
    content = kept(stage, tmp_path)
    assert content.place == (3e8, -FARTHEST_BODY, 0.0)
    assert content.velocity == pytest.approx((12_345.5, 0.0, 0.0), rel=1e-14)
    assert content.spin == pytest.approx((0.0, 54_321.0, 0.0), rel=1e-14)


def test_balls_outside_the_lectures_window_are_kept_at_its_edge(tmp_path):
    stage = Stage(LectureBalls)
    first, second = stage.scene.model.balls
    first.position, first.velocity = (-7.5, 1e9), (2e6, -3.0)
    second.position = (20.25, 30.5)
    content = kept(stage, tmp_path)
    assert (content.ball_1.position, content.ball_1.velocity) == ((0.0, 400.0), (1e6, -3.0))
    assert content.ball_2.position == (20.25, 30.5)


@pytest.mark.parametrize("scene_type", [OrientedBoxes, Capsules])
def test_an_outline_that_sways_at_the_end_of_the_world_is_kept(scene_type, tmp_path):
    outline = '[[content.outlines]]\nshape = "points"\npoints = [[0, 0], [1, 0], [0, 1]]\n'
    stage = stage_of(
        scene_type,
        f"{outline}{outline}position = [{FARTHEST}, {-FARTHEST}]",
    )
    stage.post(SetParameter("sway", stage.scene.parameter("sway").maximum))
    for _ in range(40):
        stage.run(10)
        x, y = kept(stage, tmp_path).outlines[1].position
        assert x <= FARTHEST and y >= -FARTHEST


@pytest.mark.parametrize("kind", ["obb", "capsule", "aabb"])
def test_points_that_come_to_stand_above_each_other(kind):
    """Counted from the first corner their x are equal, and their y are in another order."""
    for places in (
        [(-2.0, 0.0), (0.0, 0.75), (1e-17, 0.0)],
        [(-2.0, 0.0), (-1e-17, -1e-20), (0.0, 0.75), (1e-17, 0.0)],
        [(-2.0, 0.0), (-1e-17, 0.5), (0.0, -0.75), (1e-17, 0.0), (1e-16, -0.9)],
    ):
        for turn in range(4):
            points = np.array(places) @ np.linalg.matrix_power([[0.0, 1.0], [-1.0, 0.0]], turn)
            plain = build_tree(points, kind, 4)
            for tree in (plain, *(build_tree(points, kind, 1, fit=fit) for fit in FITS)):
                tree.check()
                assert tree.segments == len(points) - 1


@pytest.mark.parametrize("kind", ["obb", "capsule", "aabb"])
@pytest.mark.parametrize("size", [5e-324, 1e-310, 1e-200, 1e-155, 1e-101, 1e-90])
def test_points_nearer_than_products_can_tell(kind, size):
    generator = np.random.default_rng(3)
    for count in (1, 2, 3, 12, 60):
        points = size * generator.uniform(-9.0, 9.0, (count, 2))
        a = build_tree(points, kind, 2)
        b = build_tree(points + np.array((0.0, 1.0)) * generator.integers(0, 2), kind, 2)
        a.check()
        b.check()
        found = tandem(a, b, (20.0 * size, 0.0), 0.0 if kind == "aabb" else 0.3)
        assert found.volume_tests > 0
