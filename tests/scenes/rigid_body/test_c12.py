"""The rigid body scene, C12: built, pushed, its density changed, kept inside, replayed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, format_level, level_files, parse_level
from game.physics.rigid import mass_properties
from game.physics.rigid.free_top import FreeTop
from game.scenes.rigid_body.bodies import EXACT, FLIPS, A, B, turns_over
from game.scenes.rigid_body.camera import camera_matrix
from game.scenes.rigid_body.level import RigidContent
from game.scenes.rigid_body.model import TRAIL
from game.scenes.rigid_body.momentum_sphere import separatrix
from game.scenes.rigid_body.scene import RigidBodyScene
from game.scenes.rigid_body.view import hull_of_discs
from game.stage import Action, SetEffect, SetParameter, Stage, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release, stage_of

LEVELS = level_files("c12")


def plain(**declared) -> Stage:
    """Two spheres at rest side by side, looked at from the front."""
    level = parse_level(
        'scene = "c12"\n[effects]\noff = ["gravity", "drag"]\n[content]\nspheres = [\n'
        "{ position = [-0.5, 0.0], radius = 0.3 }, { position = [0.5, 0.0], radius = 0.3 } ]\n",
        "c12",
        RigidContent,
    )
    declared = {"turn": 0.0, "tilt": 0.0, "density": 100.0, **declared}
    return Stage(RigidBodyScene, level=level, parameters=declared)


def body(stage, index=A):
    return stage.scene.model.bodies.all[index]


def test_spheres_are_read_and_joined():
    """C12.1, .4"""
    stage = plain()
    mass, center, inertia = mass_properties([(-0.5, 0.0), (0.5, 0.0)], [0.3, 0.3], 100.0)
    assert body(stage).mass == pytest.approx(mass)
    assert np.allclose(body(stage).position, center, atol=1e-15)
    assert np.allclose(body(stage).inertia, inertia, rtol=1e-13, atol=1e-13)


def test_spheres_are_clicked_and_dragged_and_removed():
    """C12.1: also while it stands still; undone, redone, saved and read back."""
    stage = plain()
    stage.pause()
    stage.post(Action("sphere"))
    click(stage, (0.0, 0.8))
    assert np.allclose(stage.scene.model.bodies.design[2, :4], (0.0, 0.8, 0.0, 0.15), atol=1e-12)
    drag(stage, (0.0, -0.5), (0.25, -0.5), steps=3, run=0)
    assert np.allclose(stage.scene.model.bodies.design[3, :4], (0.0, -0.5, 0.0, 0.25), atol=1e-12)
    assert np.allclose(body(stage).spheres(), stage.scene.model.bodies.design[:, :3], atol=1e-12)
    stage.post(Action("remove"))
    click(stage, (-0.5, 0.0))
    assert len(stage.scene.model.bodies.design) == 3
    stage.post(Action("undo"))
    stage.post(Action("undo"))
    assert len(stage.scene.model.bodies.design) == 3
    assert stage.scene.model.bodies.design[2, 1] == pytest.approx(0.8)
    stage.post(Action("redo"))
    stage.post(Action("redo"))
    assert len(stage.scene.model.bodies.design) == 3
    assert stage.scene.model.bodies.design[0, 0] == 0.5
    text = format_level(Level(scene="c12", content=stage.scene.save_content()))
    back = RigidBodyScene(parse_level(text, "c12", RigidContent), {"density": 100.0})
    assert np.allclose(back.model.bodies.all[A].spheres(), body(stage).spheres(), atol=1e-12)
    assert np.allclose(back.model.bodies.all[A].inertia, body(stage).inertia, rtol=1e-12, atol=1e-12)
    for _ in range(3):
        click(stage, stage.scene.model.bodies.all[A].spheres()[0][:2])
    assert len(stage.scene.model.bodies.design) == 1
    assert any("last sphere" in words for words in stage.scene.messages())
    stage.resume()
    stage.run(5)
    assert stage.fault is None


def test_what_is_added_while_it_turns_changes_no_velocity_of_what_was_there():
    stage = plain()
    body(stage).angular_velocity = (0.0, 0.0, 2.0)
    stage.scene.model.bodies.meet()
    old, before = body(stage).position, body(stage).velocity
    stage.post(Action("sphere"))
    click(stage, (0.0, 1.0))
    now = body(stage)
    assert np.allclose(now.angular_velocity, (0.0, 0.0, 2.0), atol=1e-12)
    offset = now.position - old
    assert np.allclose(now.velocity, before + np.cross((0, 0, 2.0), offset), atol=1e-12)


def test_a_drawn_force_acts_at_its_point():
    """C12.5, .6: P = f t, L = r x f t; drawn while it acts."""
    stage = plain(strength=1000.0, push_time=0.05)
    drag(stage, (0.5, 0.1), (0.5, 0.4), steps=2, run=0)
    assert stage.scene.model.push is not None
    words = [row[1] for row in stage.scene.legend()]
    assert "force f" in words
    stage.run(10)
    assert stage.scene.model.push is None
    assert np.allclose(body(stage).momentum, (0.0, 300.0 * 0.05, 0.0), rtol=1e-12, atol=1e-12)
    angular = body(stage).angular_momentum
    assert angular[2] == pytest.approx(0.5 * 15.0, rel=2e-3)
    assert np.allclose(body(stage, EXACT).angular_momentum, angular, rtol=0.05, atol=0.05)
    before = body(stage).momentum
    stage.run(3)
    assert np.array_equal(body(stage).momentum, before)


def test_the_point_that_is_pushed_is_on_the_surface_before():
    """A force in the picture's plane at the near side of a sphere turns about the vertical as well."""
    stage = plain(push_time=0.02)
    drag(stage, (0.5, 0.0), (0.8, 0.0), steps=2, run=0)
    stage.run(3)
    assert np.allclose(body(stage).momentum, (2000 * 0.3 * 0.02, 0, 0), atol=1e-9)
    assert body(stage).angular_momentum[1] == pytest.approx(0.3 * 12.0, rel=1e-2)


def test_a_pull_as_long_as_the_button_is_down():
    stage = plain(pushing="hold", strength=200.0)
    press(stage, (0.5, 0.1))
    for i in range(60):
        move(stage, (0.5, 0.1 + 0.01 * i))
        stage.run(1)
    assert body(stage).velocity[1] > 0.1
    release(stage, (0.5, 0.7))
    before = body(stage).momentum
    stage.run(2)
    assert np.array_equal(body(stage).momentum, before)
    stage.post(SetEffect("pushes", False))
    drag(stage, body(stage).spheres()[1][:2], (3.0, 3.0), steps=3)
    assert np.array_equal(body(stage).momentum, before)


def test_the_view_is_turned_with_the_right_button_or_beside_the_body():
    stage = plain()
    drag(stage, (0.0, 0.0), (1.0, -0.5), button=3, steps=4, run=0)
    assert stage.scene.parameters.turn == pytest.approx(28.0)
    assert stage.scene.parameters.tilt == pytest.approx(14.0)
    drag(stage, (2.0, 1.5), (1.0, 1.5), steps=4, run=0)
    assert stage.scene.parameters.turn == pytest.approx(0.0, abs=1e-9)
    view = camera_matrix(30.0, 40.0)
    assert np.allclose(view @ view.T, np.eye(3), atol=1e-15)
    assert view[2] @ (0, 1, 0) == pytest.approx(math.sin(math.radians(40.0)))
    assert np.linalg.det(view) == pytest.approx(1.0)


def test_it_stays_in_its_window_mirrored_or_struck():
    """C12.7"""
    for wall in ("mirror", "impulse"):
        stage = open_level(RigidBodyScene, "default", wall=wall, method="splitting")
        for index in (A, B, EXACT):
            body(stage, index).velocity = (3.0, 2.0, -1.0)
        shift, turning = body(stage).kinetic_energy
        for _ in range(300):
            stage.run(1)
            places, radii = body(stage).spheres(), body(stage).radii[:, None]
            assert np.all(np.abs(places) + radii <= stage.scene.model.panes.half_sides + 1e-9)
        assert body(stage).bounces > 5
        assert sum(body(stage).kinetic_energy) == pytest.approx(shift + turning, rel=1e-3)
        if wall == "mirror":
            assert body(stage).kinetic_energy[0] == pytest.approx(shift, rel=1e-12)


def test_density_is_changed_while_it_runs():
    """C12.8"""
    stage = open_level(RigidBodyScene, "default")
    stage.run(10)
    before = readouts(stage)
    stage.post(SetParameter("density", 1400.0))
    after = readouts(stage)
    assert after["mass"] == pytest.approx(2.0 * before["mass"])
    assert after["I2"] == pytest.approx(2.0 * before["I2"])
    assert after["angular speed"] == pytest.approx(0.5 * before["angular speed"])
    stage.post(SetParameter("keep", "velocity"))
    stage.post(SetParameter("density", 700.0))
    assert readouts(stage)["angular speed"] == pytest.approx(0.5 * before["angular speed"])
    assert readouts(stage)["mass"] == before["mass"]
    stage.run(5)
    assert stage.fault is None


def test_the_hammer_flips_about_its_middle_axis():
    """The scene opens with two: B flips as often as the exact solution says, A only at first; it is said."""
    stage = open_level(RigidBodyScene, "default")
    top = FreeTop(body(stage, EXACT).moments, body(stage, EXACT).spin)
    quarter = 0.25 * top.period  # s: so long after a change of sign L is nearest to the middle axis
    messages, counts = [], []
    for flips, change in enumerate(top.flips(60.0), start=1):
        stage.run(math.floor((change + quarter) / stage.dt) - stage.step_number)
        messages += stage.scene.messages()
        now = readouts(stage)
        assert now["B: flips"] == now["exact: flips"] == flips
        counts.append(now["A: flips"])
    assert flips > 10
    assert counts[1:] == [4] * (flips - 1), "from 5 s on explicit Euler turns about another axis"
    assert sum("turned over" in words for words in messages) == 1
    assert now["B: angular error"] < 10.0


@pytest.mark.parametrize("name", ["bouncing", "hard-08-symmetric", "thousand-spheres"])
def test_what_goes_round_another_axis_has_not_turned_over(name):
    """The part of the spin about the middle axis changes its sign there as well."""
    stage = open_level(RigidBodyScene, name)
    messages = []
    for _ in range(60):
        stage.run(10)
        messages += stage.scene.messages()
    assert not stage.scene.model.bodies.accounts[:, FLIPS].any()
    assert not any("turned over" in words for words in messages)


def test_near_the_middle_axis_is_known_from_energy_and_momentum():
    """Moments 1, 2, 3: L along the middle axis, 29° and 31° from it towards either side."""
    moments = (1.0, 2.0, 3.0)
    for degrees, near in ((0.0, True), (29.0, True), (31.0, False), (90.0, False)):
        middle, side = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        for end in (1.0, 3.0):
            energy = 0.5 * (middle * middle / 2.0 + side * side / end)
            assert turns_over(moments, energy, 1.0) is near
    assert not turns_over((1.0, 1.0, 2.0), 0.5, 1.0)
    assert not turns_over((1.0, 2.0, 2.0), 0.3, 1.0)
    assert not turns_over((0.0, 2.0, 2.0), 0.25, 1.0)
    assert not turns_over(moments, 0.0, 0.0)


def test_twin_view_and_accounts():
    """Explicit Euler makes energy and keeps L; the engines' method loses both; |q| drifts if it is let."""
    stage = open_level(RigidBodyScene, "default", twin=True, second="implicit-gyroscopic")
    stage.run(1200)
    now = readouts(stage)
    assert now["A: energy error"] > 0.5
    assert now["A: energy"] <= now["greatest energy"] * (1 + 1e-12)
    assert now["A: L error"] == 0.0
    assert now["B: energy error"] < -0.01
    assert now["B: L error"] < -0.01
    assert now["A: |q| error"] == 0.0
    assert now["exact: energy"] == pytest.approx(now["A: energy"] / (1.0 + now["A: energy error"]), rel=1e-9)
    stage.post(SetParameter("normalizing", False))
    stage.run(60)
    assert readouts(stage)["A: |q| error"] > 0.01
    stage.post(Action("meet"))
    assert readouts(stage)["A: angular error"] == 0.0
    stage.post(Action("still"))
    assert readouts(stage)["angular speed"] == 0.0


def test_the_help_shows_a_step_of_each_integrator():
    titles = {equation.title for equation in RigidBodyScene.equations}
    assert titles.issuperset(RigidBodyScene.parameter("method").labels)


def test_effects_that_are_off_do_nothing():
    stage = open_level(RigidBodyScene, "default")
    stage.post(SetEffect("rotation", False))
    turn = body(stage).orientation
    stage.run(20)
    assert np.array_equal(body(stage).orientation, turn)
    stage.post(SetEffect("gravity", True))
    stage.run(10)
    assert body(stage).velocity[1] < -1.0
    stage.post(SetEffect("window", False))
    stage.run(200)
    assert body(stage).position[1] < -10.0
    stage.post(SetEffect("drag", True))
    stage.post(SetEffect("gravity", False))
    speed = body(stage).velocity[1]
    stage.run(60)
    assert body(stage).velocity[1] == pytest.approx(speed * math.exp(-0.2), rel=1e-9)


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_steps_restores_and_steps_again(path):
    stage = stage_of(RigidBodyScene, path)
    stage.run(12)
    for _ in range(4):
        assert stage.step_back()
    middle = stage.digest()
    stage.run(8)
    again = stage_of(RigidBodyScene, path)
    again.run(8)
    assert again.digest() == middle
    again.run(8)
    assert again.digest() == stage.digest()
    assert stage.fault is None
    for one in stage.scene.model.bodies.all:
        one.check()


def test_a_recorded_session_with_edits_replays_exactly():
    stage = open_level(RigidBodyScene, "default", twin=True)
    stage.run(5)
    seen = camera_matrix(stage.scene.parameters.turn, stage.scene.parameters.tilt) @ body(stage).spheres()[8]
    drag(stage, (seen[0] + stage.scene.model.panes.shift(A), seen[1]), (-1.0, 1.0), steps=6)
    stage.run(3)
    stage.post(Action("sphere"))
    drag(stage, (2.0, 0.6), (2.3, 0.6), steps=3)
    stage.post(SetParameter("density", 900.0))
    stage.post(SetParameter("method", "rk4"))
    drag(stage, (0.0, 1.0), (0.7, 1.2), button=3, steps=4)
    stage.post(Action("undo"))
    stage.post(SetEffect("window", False))
    stage.run(10)
    assert replay_scene(stage.recording, RigidBodyScene).digest() == stage.digest()
    number, digest = stage.step_number, stage.digest()
    for _ in range(20):
        assert stage.step_back()
    while stage.step_number < number:
        stage.step()
    assert stage.digest() == digest


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("[content]\nspin = [0.0, 1.0, 2.0]", "spheres"),
        ("[content]\nspheres = [{ position = [0, 0], radius = 0.0 }]", "content.spheres[0].radius"),
        ("[content]\nspheres = [{ position = [0], radius = 1.0 }]", "content.spheres[0].position"),
        ("[content]\nspheres = [{ position = [0, nan], radius = 1.0 }]", "content.spheres[0].position[1]"),
        (
            '[content]\nspheres = [{ position = [0, 0], radius = 1.0, color = "red" }]',
            "content.spheres[0].color",
        ),
        (
            "[content]\norientation = [0, 0, 0, 0]\nspheres = [{ position = [0, 0], radius = 1.0 }]",
            "quaternion",
        ),
        (
            "[[content.rocks]]\nhalf_axes = [1, 1, 1]\nspheres = 5000\nradius = 0.1",
            "content.rocks[0].spheres",
        ),
        ("[parameters]\ndensity = -1.0", "parameters.density"),
        ('[parameters]\nmethod = "verlet"', "parameters.method"),
        ("[content]\nsphere = []", "sphere"),
    ],
)
def test_what_is_broken_in_a_level_is_named(text, field):
    with pytest.raises(LevelError) as caught:
        RigidBodyScene(parse_level(f'scene = "c12"\n{text}\n', "c12", RigidContent))
    assert field in str(caught.value)


def test_a_method_that_explodes_is_stopped_at_its_last_finite_state():
    """What is not finite stops the scene, says so, and can be reset."""
    stage = open_level(RigidBodyScene, "default", method="body-euler", step_length=0.1)
    for _ in range(200):
        stage.run(10)
        if stage.fault is not None:
            break
    assert stage.fault is not None
    assert np.isfinite(body(stage).state).all()
    stage.reset()
    stage.post(SetParameter("method", "splitting"))
    stage.run(50)
    assert stage.fault is None


def test_the_curves_that_separate_the_sphere_of_l():
    """On them the energy is that of a spin about axis 2; a symmetric body has none."""
    moments = np.array((1.0, 2.0, 3.0))
    curves = separatrix(moments)
    assert len(curves) == 2
    for curve in curves:
        assert np.allclose((curve * curve).sum(axis=1), 1.0)
        assert np.allclose((curve * curve / moments).sum(axis=1), 1.0 / 2.0)
    assert separatrix(np.array((1.0, 1.0, 3.0))) == []


def test_the_trail_is_where_l_has_been_in_the_body():
    stage = open_level(RigidBodyScene, "default", method="exact")
    moments = body(stage).moments
    stage.run(TRAIL + 50)
    trail = stage.scene.model.trail_of(A)
    assert trail.shape == (TRAIL, 3)
    assert np.allclose((trail * trail).sum(axis=1), 1.0)
    energies = (trail * trail / moments).sum(axis=1)
    assert np.allclose(energies, energies[0], rtol=1e-11)
    seen = moments * body(stage).spin
    assert np.allclose(trail[-1], seen / np.linalg.norm(seen))


def test_a_hull_touches_each_disc_from_without():
    centers, radii = np.array(((0.0, 0.0), (3.0, 0.0), (1.0, 0.5))), np.array((1.0, 0.5, 0.2))
    hull = hull_of_discs(centers, radii)
    assert np.allclose(hull[0], hull[-1])
    assert hull[:, 0].min() == pytest.approx(-1.0, abs=1e-12)
    assert hull[:, 0].max() == pytest.approx(3.5)
    off = np.sqrt(((hull[:, None] - centers) ** 2).sum(axis=2)) - radii
    assert np.all(off > -1e-12)
    assert np.all(off[:, 2] > 0.1)


def test_a_separatrix_of_moments_that_differ_by_rounding_alone_is_drawn():
    apart = np.nextafter(3.0, 4.0)
    for moments in ((1.0, 3.0, apart), (3.0, apart, 4.0), (1e300, 2e300, 3e300), (1.0, 2.0, 4.0)):
        for curve in separatrix(np.array(moments)):
            assert np.allclose(np.linalg.norm(curve, axis=1), 1.0, atol=1e-12)
