"""What a person can look into: the formula of a motion, weights of a skin, a Jacobian, a sphere's inertia."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.key_frames.live_formula import piece_of
from game.scenes.key_frames.scene import KeyFraming
from game.scenes.rigid_body.camera import camera_matrix
from game.scenes.rigid_body.scene import RigidBodyScene
from game.scenes.rigid_body.sphere_card import card_of
from game.scenes.skeletons.inverse_kinematics import InverseKinematics
from game.scenes.skeletons.skinning import Skinning
from game.scenes.skeletons.view.jacobian import pull_of
from game.scenes.skeletons.view.point_weights import point_at, shares_of
from game.stage import Stage
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import move, open_level


@pytest.mark.parametrize("method", ["nearest", "linear", "bezier", "spline", "centripetal"])
def test_the_sum_of_the_formula_is_where_the_box_is(method):
    stage = open_level(KeyFraming, "default", interpolation=method, formula=True)
    for _ in range(12):
        stage.run(9)
        piece = piece_of(stage.scene.model)
        assert sum(piece.weights) == pytest.approx(1.0)
        assert 0.0 <= piece.u <= 1.0
        assert piece.x == pytest.approx(stage.scene.model.pose[0], abs=1e-9)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert any(words.startswith("piece ") for words in canvas.drawn)


def test_a_single_key_has_no_formula():
    assert piece_of(open_level(KeyFraming, "hard-01-one-key").scene.model) is None


def test_columns_and_pulls_are_those_of_the_error():
    """J by turning each joint a little; J^T e as minus the slope of half the squared error."""
    lengths, angles, target = np.array([1.0, 0.8, 0.6]), np.array([0.3, 0.5, -0.9]), np.array([0.4, 1.1])

    def joints_of(turned):
        headings = np.cumsum(turned)
        steps = lengths[:, None] * np.column_stack((np.cos(headings), np.sin(headings)))
        points = np.vstack((np.zeros(2), np.cumsum(steps, axis=0)))
        return points[:-1], points[-1]

    pull = pull_of(*joints_of(angles), target)
    for i in range(3):
        turn = np.zeros(3)
        turn[i] = 1e-6
        ends = [joints_of(angles + sign * turn)[1] for sign in (1.0, -1.0)]
        assert pull.columns[i] == pytest.approx((ends[0] - ends[1]) / 2e-6, abs=1e-6)
        errors = [0.5 * ((target - end) ** 2).sum() for end in ends]
        assert pull.asked[i] == pytest.approx(-(errors[0] - errors[1]) / 2e-6, abs=1e-6)


@pytest.mark.parametrize("compare", [True, False])
def test_the_jacobian_is_drawn_at_the_chosen_figure(compare):
    stage = open_level(InverseKinematics, "hard-07-running-target", jacobian=True, compare=compare)
    stage.run(20)
    plain = open_level(InverseKinematics, "hard-07-running-target", compare=compare)
    plain.run(20)
    pictures = []
    for one in (stage, plain):
        canvas = labels_of(one)
        one.scene.draw(canvas, 1.0)
        pictures.append(canvas.surface.copy())
    assert pictures[0].get_buffer().raw != pictures[1].get_buffer().raw


def test_a_point_of_the_skin_is_the_mean_of_where_its_bones_take_it():
    stage = open_level(Skinning, "bent-bar", motion=False, weights=True)
    stage.run(2)
    rig = stage.scene.model.rig
    points = rig.show(rig.now, "linear").copy()
    followed = 0
    for point in range(0, int(rig.starts[-1]), 7):
        shares = shares_of(rig, point)
        followed = max(followed, len(shares))
        mean = sum(share.weight * share.place for share in shares)
        assert mean == pytest.approx(points[point], abs=1e-9)
        assert [share.weight for share in shares] == sorted((share.weight for share in shares), reverse=True)
    assert followed > 1
    assert point_at(rig, points, (99.0, 99.0)) == -1
    move(stage, points[11], button=0)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert any("%" in words for words in canvas.drawn)


def test_what_the_spheres_add_makes_up_the_moment_of_inertia():
    stage = Stage(RigidBodyScene)
    stage.run(30)
    model = stage.scene.model
    body = model.bodies.all[0]
    cards = [card_of(model, 0, i) for i in range(len(body.radii))]
    spin, momentum = np.array(body.angular_velocity), np.array(body.angular_momentum)
    about_axis = float(spin @ momentum) / float(spin @ spin)
    assert sum(card.own + card.offset for card in cards) == pytest.approx(about_axis, rel=1e-9)
    assert sum(card.mass for card in cards) == pytest.approx(body.mass)


def test_a_sphere_under_the_pointer_shows_its_numbers():
    stage = Stage(RigidBodyScene)
    shown, body = stage.scene.parameters, stage.scene.model.bodies.all[0]
    place = (camera_matrix(shown.turn, shown.tilt) @ body.spheres()[1])[:2]
    move(stage, place, button=0)
    assert stage.scene.hand.hovered == 1
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert any(words.startswith("2/5 m r²") for words in canvas.drawn)
    move(stage, (place[0] + 3.0, place[1]), button=0)
    assert stage.scene.hand.hovered == -1
