"""The particle fountain, C04.1 to C04.8 and beyond, by stage events."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import LevelError, format_level, level_files, parse_level
from game.physics.fields import DRAG, WIND
from game.physics.particles import METHODS, OBSTACLES
from game.scenes.fountain.exact import exact_envelope
from game.scenes.fountain.hand import rim_handle
from game.scenes.fountain.level import FountainContent
from game.scenes.fountain.scene import Fountain
from game.stage import Action, ParameterError, SetEffect, SetParameter, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release, stage_of

LEVELS = level_files("c04")
FAST = {"rate": 1000.0, "step_length": 1.0 / 60.0}


def test_a_fountain_upwards_under_gravity_with_a_round_stone():
    """C04.1"""
    stage = open_level(Fountain, "default", **FAST)
    stage.run(90)
    system = stage.scene.model.system
    assert stage.scene.parameters.gravity == 9.81
    assert stage.scene.y_up
    assert system.positions[:, 1].max() > 3.0
    assert len(system.solids) == 1
    assert readouts(stage)["impacts"] > 100
    assert system.solids.sample(system.positions)[0].min() > -1e-9


def test_rate_angle_life_and_speed():
    """C04.2 to C04.5, changed while it runs."""
    stage = open_level(Fountain, "default", **FAST, spread=10.0, speed=5.0, life=1.0)
    stage.post(SetEffect("obstacles", False))
    stage.run(60)
    assert readouts(stage)["born"] == 1000
    v = stage.scene.model.system.velocities + np.array([[0.0, 9.81]]) * stage.scene.model.system.ages[:, None]
    aloft = stage.scene.model.system.positions[:, 1] > 0.01
    angles = np.degrees(np.arctan2(v[aloft, 0], v[aloft, 1]))
    assert 9.5 < np.abs(angles).max() <= 10.0 + 1e-9
    assert np.allclose(np.linalg.norm(v[aloft], axis=1), 5.0, rtol=0, atol=1e-9)
    stage.post(SetParameter("rate", 2000.0))
    stage.run(60)
    assert readouts(stage)["born"] == 3000
    assert readouts(stage)["particles"] == 2000
    stage.post(SetParameter("life", 0.25))
    stage.run(1)
    assert readouts(stage)["particles"] == 500
    stage.post(SetParameter("speed", 9.0))
    stage.run(60)
    assert readouts(stage)["highest"] == pytest.approx(9.0 * 0.25 - 4.905 / 16, abs=0.05)


def test_methods_are_chosen_live():
    """C04.6: each goes on from where the one before was; explicit Euler goes above the exact curve."""
    stage = open_level(Fountain, "default", **FAST)
    outside = {}
    for method in METHODS:
        stage.post(SetParameter("method", method))
        stage.run(200)
        outside[method] = readouts(stage)["outside the curve"]
        assert stage.fault is None
    assert outside["explicit-euler"] > 50
    assert all(outside[method] == 0 for method in METHODS if not method.endswith("euler"))


def test_newtons_law_with_restitution_one_half():
    """C04.7: a particle that falls on the top of the stone rises to a quarter of its height."""
    stage = open_level(Fountain, "hard-08-rest", method="verlet", restitution=0.5)
    assert Fountain.parameter("restitution").default == 0.5
    heights = []
    for _ in range(90):
        stage.run(1)
        heights.append(float(stage.scene.model.system.positions[0, 1]) - 2.5)
    low = int(np.argmin(heights[:50]))
    assert max(heights[low:]) == pytest.approx(1.5 * 0.25, rel=0.02)


def test_start_pause_and_stop():
    """C04.8: the stage pauses; the emitter stops and starts; all is cleared."""
    stage = open_level(Fountain, "default", **FAST)
    stage.run(30)
    stage.pause()
    assert stage.advance(1.0) == 0
    stage.resume()
    assert stage.advance(0.1) == 6
    stage.post(Action("emit"))
    born = readouts(stage)["born"]
    stage.run(30)
    assert readouts(stage)["born"] == born
    stage.post(Action("emit"))
    stage.run(30)
    assert readouts(stage)["born"] == born + 500
    stage.post(Action("clear"))
    assert readouts(stage)["particles"] == 0
    stage.reset()
    assert stage.step_number == 0


def test_the_stone_is_dragged_pushes_and_may_be_made_larger():
    stage = open_level(Fountain, "default", **FAST)
    stage.run(60)
    drag(stage, (0.2, 2.42), (1.7, 3.0), steps=30)
    centre = stage.scene.model.system.solids.centres[0]
    assert np.allclose(centre, (1.7, 3.0), rtol=0, atol=1e-9)
    assert stage.scene.model.system.solids.sample(stage.scene.model.system.positions)[0].min() > -1e-9
    drag(stage, rim_handle(1.7, 3.0, 0.45), (1.7 + 0.9, 3.0), steps=5)
    assert stage.scene.model.system.solids.radii[0] == pytest.approx(0.9, abs=1e-9)
    stage.run(20)
    assert stage.scene.model.system.solids.sample(stage.scene.model.system.positions)[0].min() > -1e-9


def test_a_fast_hand_does_not_shoot_particles_away():
    stage = open_level(Fountain, "default", **FAST)
    stage.run(90)
    drag(stage, (0.2, 2.42), (-60.0, 2.4), steps=3)
    stage.run(30)
    assert np.linalg.norm(stage.scene.model.system.velocities, axis=1).max() < 2 * 25.0 + 10.0


def test_stones_come_and_go():
    stage = open_level(Fountain, "default", **FAST)
    click(stage, (-1.5, 3.0), shift=True)
    assert len(stage.scene.model.system.solids) == 2
    stage.run(60)
    click(stage, (0.2, 2.42), button=3)
    assert len(stage.scene.model.system.solids) == 1
    assert np.allclose(stage.scene.model.system.solids.centres[0], (-1.5, 3.0))
    for i in range(40):
        click(stage, (30.0 + i, 30.0), shift=True)
    assert len(stage.scene.model.system.solids) == 32
    assert any("32 stones" in words for words in stage.scene.messages())


def test_nozzle_and_vortex_are_dragged():
    stage = open_level(Fountain, "whirlwind", **FAST)
    drag(stage, (-1.2, 0.0), (1.5, 0.5))
    stage.run(3)
    newest = stage.scene.model.system.positions[-1]
    assert min(math.dist(newest, place) for place in ((1.5, 0.5), (1.6, 0.0))) < 0.15
    drag(stage, stage.scene.model.vortex_centre, (2.0, 3.0))
    assert stage.scene.model.vortex_centre == (2.0, 3.0)
    assert stage.scene.model.system.forces.whirl_x == 2.0


def test_what_is_dragged_keeps_its_distance_from_the_pointer():
    stage = open_level(Fountain, "whirlwind", **FAST)
    drag(stage, (-1.15, -0.1), (0.85, 0.9))
    assert stage.scene.model.system.state().emitters[0, :2] == pytest.approx((0.8, 1.0), abs=1e-12)
    x, y = stage.scene.model.vortex_centre
    drag(stage, (x + 0.1, y - 0.2), (2.1, 2.8))
    assert stage.scene.model.vortex_centre == pytest.approx((2.0, 3.0), abs=1e-12)
    press(stage, (30.0, 30.0), shift=True)
    release(stage, (30.0, 30.0))
    x, y, radius = stage.scene.model.system.solids.rows[-1, :3].tolist()
    handle = rim_handle(x, y, radius)
    press(stage, (handle[0] + 0.08, handle[1] + 0.02))
    move(stage, (handle[0] + 0.08, handle[1] + 0.02))
    assert stage.scene.model.system.solids.rows[-1, 2] == pytest.approx(radius, rel=1e-6)


def test_the_nozzle_stays_above_the_ground():
    """Taken by its body, which is drawn below the point where particles are born, and pulled down."""
    stage = open_level(Fountain, "default", **FAST)
    drag(stage, (0.0, -0.1), (1.5, -0.4))
    assert stage.scene.model.system.state().emitters[0, :2] == pytest.approx((1.5, 0.0), abs=1e-12)
    stage.post(SetEffect("ground", False))
    drag(stage, (1.5, -0.1), (1.5, -0.4))
    assert stage.scene.model.system.state().emitters[0, 1] == pytest.approx(-0.3, abs=1e-12)
    stage.run(30)
    assert readouts(stage)["error"] < 1e-9
    stage.post(SetEffect("ground", True))  # it stands in the ground now: nothing is claimed
    stage.run(1)
    assert math.isnan(readouts(stage)["exact"])


@pytest.mark.parametrize("to", [(1.0, 1.0), (-0.5, -0.4)])
def test_the_exact_height_and_the_error_hold_again_at_once_where_the_nozzle_was_dragged(to):
    """For those born since it came to rest; others left it on its way, or higher up."""
    stage = open_level(
        Fountain, "default", rate=4000.0, step_length=1 / 60, method="exponential", spread=60.0
    )
    drag(stage, (0.0, 0.0), (-2.0, 2.0))
    stage.run(120)
    drag(stage, (-2.0, 2.0), to)
    assert any("born since" in words for _, words, _ in stage.scene.legend())
    for _ in range(100):
        stage.run(2)
        values = readouts(stage)
        assert values["error"] < 1e-11
        assert values["outside the curve"] == 0
        assert values["highest"] <= values["exact"] + 1e-9
    assert values["highest"] > values["exact"] - 0.1
    assert not any("born since" in words for _, words, _ in stage.scene.legend())


@pytest.mark.parametrize("drag_on", [False, True])
def test_nobody_passes_the_exact_envelope(drag_on):
    """Beyond: also with drag and wind, to rounding, by the method that is exact for them."""
    stage = open_level(
        Fountain, "default", rate=4000.0, step_length=1 / 60, method="exponential", spread=60.0
    )
    if drag_on:
        stage.post(SetEffect("drag", True))
        stage.post(SetEffect("wind", True))
        assert DRAG in stage.scene.active and WIND in stage.scene.active
    stage.post(Action("clear"))
    stage.run(150)
    values = readouts(stage)
    assert values["error"] < 1e-11
    assert values["outside the curve"] == 0
    assert values["exact"] - 0.1 < values["highest"] <= values["exact"] + 1e-9
    curve = exact_envelope(stage.scene.model)
    assert np.all(np.diff(curve[:, 0]) > 0.0)


def test_no_reference_where_none_is_known():
    stage = open_level(Fountain, "default", **FAST)
    stage.post(SetEffect("quadratic-drag", True))
    stage.run(10)
    values = readouts(stage)
    assert math.isnan(values["exact"]) and math.isnan(values["error"])


def test_wind_blows_and_what_is_off_does_not():
    stage = open_level(Fountain, "default", **FAST, wind=20.0)
    stage.run(60)
    still = stage.scene.model.system.positions[:, 0].mean()
    stage.post(SetEffect("wind", True))
    stage.run(60)
    assert stage.scene.model.system.positions[:, 0].mean() < still + 0.5
    stage.post(SetEffect("drag", True))
    stage.run(60)
    assert stage.scene.model.system.positions[:, 0].mean() > still + 2.0


def test_energy_stays_level_without_loss():
    """Restitution 1 and Verlet by the chord: the energy of those in flight stays that of the nozzle."""
    stage = open_level(
        Fountain, "default", rate=1000.0, restitution=1.0, ground_restitution=1.0, step_length=1 / 240
    )
    stage.run(600)
    values = readouts(stage)
    assert values["kinetic"] + values["potential"] == pytest.approx(40.5 * values["particles"], rel=2e-3)


def test_full_pool_is_told_once():
    stage = open_level(Fountain, "hard-03-full-pool", step_length=1 / 60)
    stage.run(60)
    messages = stage.scene.messages()
    assert len([words for words in messages if "full" in words]) == 1
    assert readouts(stage)["dropped"] > 1000
    assert readouts(stage)["particles"] == 2000


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_steps_restores_and_steps_again(path):
    small = {"places": 6000} if path.stem == "hundred-thousand" else {}
    stage = stage_of(Fountain, path, **small)
    stage.run(30)
    for _ in range(5):
        assert stage.step_back()
    middle = stage.digest()
    stage.run(20)
    again = stage_of(Fountain, path, **small)
    again.run(25)
    assert again.digest() == middle
    again.run(20)
    assert again.digest() == stage.digest()
    assert stage.fault is None
    stage.scene.model.system.check()


def test_a_recorded_session_replays_exactly():
    stage = open_level(Fountain, "default", **FAST)
    stage.run(20)
    drag(stage, (0.2, 2.42), (0.9, 2.0))
    stage.post(SetParameter("method", "rk4"))
    stage.post(SetEffect("drag", True))
    click(stage, (-1.0, 2.0), shift=True)
    drag(stage, (0.0, 0.0), (0.4, 0.0))
    stage.post(SetParameter("rate", 3000.0))
    stage.run(40)
    twin = replay_scene(stage.recording, Fountain)
    assert twin.digest() == stage.digest()


def test_stepping_back_undoes_the_hand():
    stage = open_level(Fountain, "default", **FAST)
    stage.run(10)
    before = stage.digest()
    press(stage, (0.2, 2.42))
    stage.run(1)
    click(stage, (3.0, 3.0), shift=True)
    stage.run(5)
    while stage.step_number > 10:
        stage.step_back()
    stage.step_back()
    stage.step()
    assert len(stage.scene.model.system.solids) == 1
    assert stage.digest() == before


def test_the_content_is_saved_as_it_stands():
    stage = open_level(Fountain, "default", **FAST)
    drag(stage, (0.2, 2.42), (1.0, 2.0))
    click(stage, (-2.0, 1.0), shift=True)
    level = stage.level.__class__(scene="c04", title="mine", content=stage.scene.save_content())
    back = parse_level(format_level(level), "c04", FountainContent)
    assert len(back.content.stones) == 2
    assert math.dist(back.content.stones[0].centre, (1.0, 2.0)) < 1e-9


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("[content]\nstones = [{ centre = [0, 0], radius = -1.0 }]", "content.stones[0].radius"),
        ("[content]\nstones = [{ centre = [0, 1e9], radius = 1.0 }]", "content.stones[0].centre[1]"),
        ("[content]\nstones = [{ centre = [0, 0], radius = nan }]", "content.stones[0].radius"),
        ("[content]\nnozzles = [{ tilt = 300.0 }]", "content.nozzles[0].tilt"),
        ("[content]\nwhirls = 3", "content"),
        ("[parameters]\nrate = -5.0", "parameters.rate"),
        ('[effects]\noff = ["fire"]', "effects.off"),
    ],
)
def test_what_is_broken_in_a_level_is_named(text, field):
    with pytest.raises(LevelError) as caught:
        Fountain(parse_level(f'scene = "c04"\n{text}\n', "c04", FountainContent))
    assert field in str(caught.value)


@pytest.mark.parametrize(
    ("parameter", "value"), [("rate", -1.0), ("life", 0.0), ("method", "magic"), ("places", 0)]
)
def test_values_out_of_range_are_refused(parameter, value):
    stage = open_level(Fountain, "default", **FAST)
    with pytest.raises(ParameterError, match=parameter):
        stage.post(SetParameter(parameter, value))
    stage.run(1)
    assert stage.fault is None


def test_without_a_level_all_effects_are_on():
    scene = Fountain()
    assert OBSTACLES in scene.active
    for _ in range(5):
        scene.advance(scene.parameters.step_length)
    assert len(scene.legend()) >= 2


def test_no_envelope_is_claimed_for_a_nozzle_within_a_stone():
    """Who is born there begins on the surface, and may rise above the curve of the nozzle."""
    stage = open_level(Fountain, "hard-01-born-inside", **FAST)
    stage.run(60)
    values = readouts(stage)
    assert len(exact_envelope(stage.scene.model)) == 0 and math.isnan(values["exact"])
    assert all(label != "exact envelope" for _, label, _ in stage.scene.legend())
    stage.post(SetEffect("obstacles", False))
    stage.run(1)
    curve = exact_envelope(stage.scene.model)
    nozzle = stage.scene.model.system.state().emitters[0, 1]
    assert readouts(stage)["exact"] == pytest.approx(nozzle + curve[:, 1].max())
