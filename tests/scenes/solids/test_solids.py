"""The playground of solids: machines do what they should, and every tool what it says."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import format_level, level_files, parse_level
from game.physics.solids.arrays.state import DYNAMIC
from game.scenes.solids.level import SolidContent
from game.scenes.solids.scene import Solids
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from tests.scenes.particle_stages import drag, move, open_level, press, readouts, release

LEVELS = [path.stem for path in level_files("solids")]
EMPTY = """
scene = "solids"
title = "Empty"
about = "Nothing but the ground."
[content]
"""


def empty(**parameters) -> Stage:
    level = parse_level(EMPTY, "solids", SolidContent, "empty.toml")
    return Stage(Solids, level=level, parameters=parameters)


def draw(stage, points, button=1):
    press(stage, points[0], button)
    for point in points[1:]:
        move(stage, point, button)
    release(stage, points[-1], button)
    stage.run(1)


def bodies(stage):
    return stage.scene.model.movable()


def test_the_arch_stands_and_falls_without_its_keystone():
    stage = open_level(Solids, "default")
    stage.run(240)
    assert readouts(stage)["blocks that fell"] == 0
    model = stage.scene.model
    keystone = model.movable()[8]
    x, y = model.world.bodies.positions[keystone]
    stage.post(SetParameter("tool", "delete"))
    press(stage, (x, y))
    release(stage, (x, y))
    stage.run(240)
    assert readouts(stage)["blocks that fell"] > 3


def test_the_house_of_cards_stands_by_friction_alone():
    tops = {}
    for friction in (0.8, 0.05):
        stage = open_level(Solids, "card-house", friction=friction)
        top = readouts(stage)["top"]
        stage.run(300)
        tops[friction] = readouts(stage)["top"] - top
    assert abs(tops[0.8]) < 0.02
    assert tops[0.05] < -1.0


def test_the_wave_of_dominoes_runs_as_fast_as_the_theory_says():
    """1.3466 sqrt(g h) at d/h 0.16, s/h 0.4, friction 0.2 (van Leeuwen 2010)."""
    stage = open_level(Solids, "dominoes", step_length=1.0 / 240.0)
    rows = stage.scene.model.world.bodies
    ids = stage.scene.model.movable()
    hit = {}
    for step in range(2400):
        stage.run(1)
        for k in (12, 32):
            if k not in hit and rows.angles[ids[k]] < -0.01:
                hit[k] = step / 240.0
        if len(hit) == 2:
            break
    speed = 20 * 0.56 / (hit[32] - hit[12])
    assert speed / math.sqrt(9.81) == pytest.approx(1.3466, rel=0.05)


def test_the_cradle_sends_one_ball_for_one():
    stage = open_level(Solids, "newtons-cradle")
    first = readouts(stage)["sum"]
    most = np.zeros(5)
    ids = stage.scene.model.movable()
    start = stage.scene.model.world.bodies.positions[ids, 0].copy()
    for _ in range(1400):
        stage.run(1)
        most = np.maximum(most, stage.scene.model.world.bodies.positions[ids, 0] - start)
    assert most[4] > 1.6 and most[1:4].max() < 0.3
    assert readouts(stage)["sum"] == pytest.approx(first, rel=0.02)


def test_the_trebuchet_throws_its_stone_and_makes_no_energy():
    stage = open_level(Solids, "catapult")
    before = readouts(stage)["sum"]
    for _ in range(30):
        stage.run(6)
        now = readouts(stage)["sum"]
        assert now < before + 0.01 * abs(before)
        before = now
    assert readouts(stage)["the stone's way"] > 10.0


@pytest.mark.parametrize("tool", ["disc", "box", "polygon", "capsule"])
def test_a_drag_makes_a_body_that_falls_and_rests(tool):
    stage = empty(tool=tool, density=2.0)
    draw(stage, [(0.0, 2.0), (0.5, 2.4), (1.0, 2.5)])
    assert len(bodies(stage)) == 1
    stage.run(300)
    assert readouts(stage)["awake"] == 0 and readouts(stage)["contacts"] > 0


def test_a_drawn_concave_outline_becomes_one_body_of_convex_parts():
    stage = empty(tool="outline")
    outline = [(0.0, 1.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0), (1.0, 4.0), (0.0, 4.0)]
    sides = zip(outline, outline[1:] + outline[:1], strict=True)
    path = [tuple(np.add(a, t * np.subtract(b, a))) for a, b in sides
            for t in np.linspace(0.0, 1.0, 20)]  # fmt: skip
    draw(stage, path)
    (body,) = bodies(stage)
    world = stage.scene.model.world
    assert len(world.shapes_of(int(body))) == 2
    assert 1.0 / world.bodies.inverse_masses[body] == pytest.approx(5.0, rel=0.01)


def test_a_pin_holds_a_body_to_the_ground_and_a_cut_sets_it_free():
    stage = empty(tool="disc")
    draw(stage, [(0.0, 4.0), (0.5, 4.0)])
    stage.post(SetParameter("tool", "pin"))
    stage.run(1)
    y = float(stage.scene.model.world.bodies.positions[bodies(stage)[0], 1])
    draw(stage, [(0.0, y)])
    stage.run(120)
    assert stage.scene.model.world.bodies.positions[bodies(stage)[0], 1] == pytest.approx(y, abs=0.01)
    drag(stage, (-0.2, y - 0.3), (0.2, y + 0.3), button=3, steps=2)
    stage.run(200)
    assert stage.scene.model.world.bodies.positions[bodies(stage)[0], 1] < 1.0


def test_a_line_through_a_body_cuts_it_in_two_that_go_on_as_before():
    stage = empty(tool="box", gravity=0.0)
    draw(stage, [(-1.0, 2.0), (1.0, 3.0)])
    (body,) = bodies(stage)
    world = stage.scene.model.world
    world.set_velocity(int(body), (0.3, 0.2), 0.5)
    mass = 1.0 / world.bodies.inverse_masses[body]
    x, y = world.bodies.positions[body]
    draw(stage, [(x - 0.1, y - 2.0), (x + 0.1, y + 2.0)], button=3)
    pieces = bodies(stage)
    assert len(pieces) == 2
    masses = 1.0 / world.bodies.inverse_masses[pieces]
    assert masses.sum() == pytest.approx(mass)
    momentum = (masses[:, None] * world.bodies.velocities[pieces]).sum(axis=0)
    assert momentum == pytest.approx(mass * np.array([0.3, 0.2]), rel=1e-6)
    assert world.bodies.spins[pieces] == pytest.approx([0.5, 0.5], rel=1e-6)


def test_the_mouse_lifts_a_body_and_a_throw_sends_it_off():
    stage = empty(tool="box")
    draw(stage, [(0.0, 0.0), (1.0, 1.0)])
    stage.post(SetParameter("tool", "hand"))
    press(stage, (0.5, 0.5))
    for k in range(60):
        move(stage, (0.5, 0.5 + 0.05 * k))
        stage.run(1)
    (body,) = bodies(stage)
    assert stage.scene.model.world.bodies.positions[body, 1] > 2.0
    stage.post(Pointer("cancel", 0.0, 0.0))
    stage.run(200)
    assert stage.scene.model.world.bodies.positions[body, 1] < 0.6
    stage.post(SetParameter("tool", "throw"))
    x, y = stage.scene.model.world.bodies.positions[body]
    press(stage, (x, y))
    move(stage, (x - 1.0, y - 0.5))
    release(stage, (x - 1.0, y - 0.5))
    stage.run(1)
    assert stage.scene.model.world.bodies.velocities[body, 0] == pytest.approx(4.0, rel=0.05)


def test_copies_and_deletions():
    stage = empty(tool="disc")
    draw(stage, [(0.0, 1.0), (0.5, 1.0)])
    stage.post(SetParameter("tool", "duplicate"))
    stage.run(1)
    draw(stage, [(0.0, 1.0), (3.0, 1.0)])
    assert len(bodies(stage)) == 2
    stage.post(Action("delete-chosen"))
    stage.run(1)
    assert len(bodies(stage)) == 1


def test_friction_and_restitution_reach_what_has_none_of_its_own():
    stage = empty(tool="disc", restitution=0.0)
    draw(stage, [(0.0, 3.0), (0.3, 3.0)])
    stage.post(SetParameter("restitution", 0.9))
    stage.post(SetParameter("friction", 0.1))
    stage.run(1)
    model = stage.scene.model
    (shape,) = model.world.shapes_of(int(bodies(stage)[0]))
    assert model.world.shapes.restitutions[shape] == 0.9
    assert model.world.shapes.frictions[shape] == 0.1
    top = 0.0
    for _ in range(120):
        stage.run(1)
        body = bodies(stage)[0]
        if model.world.bodies.velocities[body, 1] > 0.0:
            top = max(top, float(model.world.bodies.positions[body, 1]))
    assert top > 1.8


def test_without_gravity_nothing_falls():
    stage = empty(tool="disc")
    stage.post(SetEffect("gravity", False))
    draw(stage, [(0.0, 3.0), (0.3, 3.0)])
    stage.run(60)
    assert stage.scene.model.world.bodies.positions[bodies(stage)[0], 1] == pytest.approx(3.0, abs=1e-9)


@pytest.mark.parametrize("name", [name for name in LEVELS if name != "pyramid"])
def test_a_level_that_was_saved_goes_on_as_the_world_did(name):
    stage = open_level(Solids, name)
    stage.run(30)
    level = stage.scene.level
    text = format_level(
        type(level)(
            scene="solids", title="Saved", about="Saved.", parameters={}, content=stage.scene.save_content(),
            path=level.path,
        )
    )  # fmt: skip
    again = Stage(Solids, level=parse_level(text, "solids", SolidContent, "saved.toml"))
    first, second = stage.scene.model, again.scene.model
    assert len(first.movable()) == len(second.movable())
    assert np.allclose(
        first.world.bodies.positions[first.movable()],
        second.world.bodies.positions[second.movable()],
        atol=1e-9,
    )
    assert np.allclose(
        first.world.bodies.inverse_masses[first.movable()],
        second.world.bodies.inverse_masses[second.movable()],
    )
    mobile = first.world.bodies.flags & DYNAMIC != 0
    assert mobile.sum() == (second.world.bodies.flags & DYNAMIC != 0).sum()


def test_steps_back_come_to_the_same_bits():
    stage = open_level(Solids, "dominoes")
    stage.run(90)
    digest = stage.digest()
    stage.run(30)
    for _ in range(30):
        stage.step_back()
    assert stage.digest() == digest


def test_nonsense_in_a_level_is_one_line():
    text = EMPTY + "[[content.bodies]]\nshapes = [{ disc = 1.0, box = [1.0, 1.0] }]\n"
    level = parse_level(text, "solids", SolidContent, "wrong.toml")
    with pytest.raises(ValueError, match="expected one of disc") as found:
        Stage(Solids, level=level)
    assert "\n" not in str(found.value)
