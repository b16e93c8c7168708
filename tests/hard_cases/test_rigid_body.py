"""The hard cases of rigid bodies, C12 H1 to H9, as the levels that show them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import LevelError, parse_level
from game.physics.rigid import FreeTop, turn_between
from game.scenes.rigid_body.bodies import EXACT, A, B
from game.scenes.rigid_body.level import RigidContent
from game.scenes.rigid_body.scene import RigidBodyScene
from tests.scenes.particle_stages import open_level, readouts


def opened(name, **parameters):
    return open_level(RigidBodyScene, name, **parameters)


def body(stage, index=A):
    return stage.scene.model.bodies.all[index]


def test_spheres_in_one_place_turn_evenly():
    """One moment about all axes: L and spin are parallel and stay, by any method."""
    for method in ("explicit-euler", "implicit-gyroscopic", "splitting", "exact"):
        stage = opened("hard-01-in-one-place", method=method)
        moments = body(stage).moments
        assert moments[2] / moments[0] - 1.0 < 1e-12
        stage.run(120)
        assert np.allclose(body(stage).angular_velocity, (1, 2, 3), rtol=1e-11)
        assert abs(readouts(stage)["A: energy error"]) < 1e-11


def test_no_sphere_is_refused():
    with pytest.raises(LevelError, match="spheres"):
        RigidBodyScene(parse_level('scene = "c12"\n[content]\nspheres = []\n', "c12", RigidContent))


def test_points_in_a_row_do_not_turn_about_their_line():
    stage = opened("hard-02-in-a-row")
    moments = body(stage).moments
    assert moments[2] / moments[0] > 1e12
    stage.run(300)
    assert stage.fault is None
    for index in (A, EXACT):
        assert body(stage, index).spin[0] == 0.0
        assert np.isfinite(body(stage, index).state).all()
        assert np.sqrt(body(stage, index).spin @ body(stage, index).spin) == pytest.approx(
            math.sqrt(5.0), rel=1e-6
        )


def test_flips_at_the_instants_of_jacobis_solution():
    stage = opened("hard-03-middle-axis", step_length=1 / 120)
    one = body(stage)
    expected = FreeTop(one.moments, one.spin).flips(20.0)
    assert 5 <= len(expected) <= 7
    seen, side = [], 1.0
    for i in range(2400):
        stage.run(1)
        if one.spin[1] * side < 0.0:
            seen.append((i + 1) / 120)
            side = -side
    assert len(seen) == len(expected)
    assert np.allclose(seen, expected, rtol=0, atol=0.03)
    assert readouts(stage)["A: flips"] == len(expected)


def test_energy_rises_to_its_bound_or_falls():
    stage = opened("hard-04-the-sign-depends")
    last = 0.0
    for _ in range(40):
        stage.run(15)
        now = readouts(stage)
        assert now["A: energy"] >= last * (1.0 - 1e-12)
        assert now["A: energy"] <= now["greatest energy"] * (1.0 + 1e-12)
        last = now["A: energy"]
    assert last > 0.98 * now["greatest energy"]
    assert now["B: energy error"] < -0.1
    assert now["A: L error"] == 0.0


def test_a_quaternion_left_alone_grows_but_turns_alike():
    stage = opened("hard-05-not-normalized")
    rate = float(np.sqrt(body(stage).spin @ body(stage).spin))
    stage.run(60)
    size = readouts(stage)["A: |q| error"] + 1.0
    assert size == pytest.approx((1.0 + (rate / 120.0) ** 2) ** 30, rel=1e-9)
    assert readouts(stage)["B: |q| error"] == 0.0
    twin = opened("hard-05-not-normalized", normalizing=True)
    twin.run(60)
    assert turn_between(body(stage).state[3:7], body(twin).state[3:7]) < 1e-12


def test_more_than_half_a_turn_a_step():
    """Explicit Euler turns by 2 atan(w dt / 2) < pi; the exponential map is where the exact body is."""
    stage = opened("hard-06-more-than-half-a-turn")
    before = body(stage).orientation
    stage.run(1)
    angle = 250.0 / 60.0
    assert turn_between(before, body(stage).orientation) == pytest.approx(2 * math.atan(angle / 2), abs=1e-9)
    assert turn_between(before, body(stage, B).orientation) == pytest.approx(2 * math.pi - angle, abs=1e-9)
    stage.run(59)
    assert turn_between(body(stage, B).orientation, body(stage, EXACT).orientation) < 1e-9
    assert stage.fault is None


def test_a_millionfold_far_away():
    """Its spheres keep their distances, and the heavy one stays where the centre of mass is."""
    stage = opened("hard-07-a-millionfold", method="splitting")
    masses = body(stage).radii ** 3
    assert masses[0] / masses[1] == pytest.approx(1e6)
    design = stage.scene.model.bodies.design[:, :3]
    stage.run(200)
    places = body(stage).spheres()
    for a in range(4):
        for b in range(a):
            assert math.dist(places[a], places[b]) == pytest.approx(math.dist(design[a], design[b]), abs=1e-9)
    assert np.abs(places[0]).max() < 1e-5
    assert abs(readouts(stage)["A: energy error"]) < 1e-4


def test_a_symmetric_body_precesses_evenly():
    """The exact spin goes round the axis at (I3 - I1) / I1 w3; explicit Euler's opens up."""
    stage = opened("hard-08-symmetric", second="exact")
    one = body(stage, B)
    i1, _, i3 = one.moments
    start = one.spin
    rate = (i3 - i1) / i1 * start[2]
    for k in (30, 60, 90):
        stage.run(30)
        turned = np.array((math.cos(rate * k / 60), math.sin(rate * k / 60)))
        expected = (start[0] * turned[0] - start[1] * turned[1], start[0] * turned[1] + start[1] * turned[0])
        assert np.allclose(one.spin[:2], expected, rtol=0, atol=1e-9)
        assert one.spin[2] == pytest.approx(start[2], rel=1e-12)
    assert readouts(stage)["A: energy error"] > 1e-3


def test_rounding_alone_makes_it_flip_after_a_while():
    """Both stay for some seconds and flip later, each by its own rounding."""
    stage = opened("hard-09-on-the-middle-axis")
    rate = float(body(stage).spin[1])
    stage.run(180)
    for index in (A, B):
        assert body(stage, index).spin[1] == pytest.approx(rate, rel=1e-5)
    stage.run(60 * 30)
    assert stage.scene.model.bodies.accounts[A, 2] > 0
    assert stage.scene.model.bodies.accounts[B, 2] > 0
