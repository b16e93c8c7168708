"""Machines of the playground: a clock, a bridge, one thing after another, and what theory says of others."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import parse_level
from game.physics.dominoes import domino_wave_speed
from game.physics.solids.arrays.layout import BREAK_FORCE
from game.scenes.solids.level import BodyEntry, ShapeEntry, SolidContent
from game.scenes.solids.scene import Solids
from game.stage import SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.particle_stages import open_level, press, readouts, release
from tests.scenes.solids.test_hard_levels import ALL, after

G = 9.81


def pendulum_period(arm, bob, weight, swing):
    """Of a rod of density 1 that carries a disc, about the pivot of the anchor, which itself is light."""
    rod = 0.02 * arm * (arm - bob)
    ball = weight * math.pi * bob**2
    # the rod's box reaches from the pivot to the rim of the bob
    length = arm - bob
    inertia = rod * (length**2 + (0.02 * arm) ** 2) / 12.0 + rod * (0.5 * length) ** 2
    inertia += ball * (0.5 * bob**2 + arm**2)
    lever = rod * 0.5 * length + ball * arm
    return 2.0 * math.pi * math.sqrt(inertia / (G * lever)) * (1.0 + swing**2 / 16.0)


def test_the_clock_goes_by_its_pendulum_and_lets_one_tooth_go_in_a_period():
    stage = open_level(Solids, "clock")
    exact = pendulum_period(4.0, 0.35, 8.0, math.radians(6.6))
    (entry,) = ALL["clock"].content.expected
    assert entry.value == pytest.approx(exact, rel=3e-3)
    found = after(stage, 8.5)
    assert found["period"] == pytest.approx(exact, rel=5e-3)
    before = found["the wheel has turned"]
    periods = 2
    found = after(stage, periods * found["period"])
    assert before - found["the wheel has turned"] == pytest.approx(periods * 360.0 / 15.0, abs=4.0)


def test_the_clock_stops_without_its_spring():
    stage = open_level(Solids, "clock")
    after(stage, 1.0)
    world = stage.scene.model.world
    world.drive(0, 0.0, 0.0)
    turned = [abs(after(stage, 4.0)["the wheel has turned"]) for _ in range(4)]
    assert turned[-1] - turned[0] < 3.0


def truss_forces(n, a, h, t, rho, load):
    """Of the bars of a Warren truss with a load in its middle, N: pulls, and what their first pins carry."""
    knots = np.array([(a * k, 0.0) for k in range(n + 1)] + [(a * (k + 0.5), h) for k in range(n)])
    bars = [(k, k + 1) for k in range(n)] + [(n + 1 + k, n + 2 + k) for k in range(n - 1)]
    bars += [pair for k in range(n) for pair in ((k, n + 1 + k), (n + 1 + k, k + 1))]
    masses = np.full(len(knots), math.pi * (0.6 * t) ** 2 * rho)
    rows = np.zeros((2 * len(knots), len(bars) + 3))
    for j, (p, q) in enumerate(bars):
        way = knots[q] - knots[p]
        length = np.hypot(*way)
        rows[2 * p : 2 * p + 2, j] = way / length
        rows[2 * q : 2 * q + 2, j] = -way / length
        masses[[p, q]] += 0.5 * (length - 2.4 * t) * t * rho
    rows[0, -3] = rows[1, -2] = rows[2 * n + 1, -1] = 1.0  # a pin at the left, a roller at the right
    weights = np.zeros(2 * len(knots))
    weights[1::2] = G * masses
    weights[2 * (n // 2) + 1] += load
    forces = np.linalg.solve(rows, weights)[: len(bars)]
    ways = np.array([knots[q] - knots[p] for p, q in bars])
    lengths = np.hypot(*ways.T)
    ends = -forces[:, None] * ways / lengths[:, None]  # on the bar, at its first end, with half of its weight
    ends[:, 1] += 0.5 * G * (lengths - 2.4 * t) * t * rho
    return forces, np.hypot(*ends.T)


def bridge_forces():
    (truss,) = ALL["bridge"].content.trusses
    weight = ALL["bridge"].content.bodies[2]
    load = weight.density * 1.2 * 1.2 * G
    return truss_forces(truss.panels, truss.panel, truss.height, truss.thickness, truss.density, load)


def test_the_bars_of_the_bridge_carry_what_statics_says():
    (forces, pins), stage = bridge_forces(), open_level(Solids, "bridge")
    found = after(stage, 2.0)
    assert found["middle bar above"] == pytest.approx(-forces[8], rel=1e-4)
    assert found["middle bar below"] == pytest.approx(forces[2], rel=1e-4)
    world = stage.scene.model.world
    carried = [world.joint_load(2 + 2 * bar)[0] for bar in range(len(forces))]  # after both supports
    assert carried == pytest.approx(pins.tolist(), rel=1e-4)


@pytest.mark.parametrize(("part", "stands"), [(1.02, True), (0.98, False)])
def test_the_bridge_breaks_first_in_the_middle_above(part, stands):
    stage = open_level(Solids, "bridge")
    limit = part * bridge_forces()[1].max()
    model = stage.scene.model
    pins = np.arange(2, 2 + 2 * 23)
    model.world.joints.parameters[pins, BREAK_FORCE] = limit
    first = []
    for _ in range(60):
        stage.scene.advance(stage.dt)
        first = first or model.world.joints_broken().tolist()
    if stands:
        assert not first
    else:
        assert set(first) == {2 + 2 * 8, 3 + 2 * 8}
        assert readouts(stage)["pins that broke"] > 2


def test_a_disc_sent_across_breaks_the_bridge():
    stage = open_level(Solids, "bridge")
    stage.post(SetParameter("tool", "throw"))
    stage.run(1)
    press(stage, (-7.6, 2.41))
    release(stage, (-8.85, 2.41))  # thrown by 4/s for each metre
    stage.run(1)
    assert after(stage, 4.0)["pins that broke"] > 4


STEPS = ("dominoes begin", "the ball is in the cup", "the gate is open", "the bell rings")


@pytest.mark.parametrize("tier", ["play", "teach", "film"])
def test_one_thing_follows_another(tier):
    found = after(open_level(Solids, "rube-goldberg", tier=tier), 13.0)
    times = [found[name] for name in STEPS]
    assert times[0] > 0.0 and times == sorted(times) and times[3] < 12.0


@pytest.mark.parametrize(("gone", "last"), [(3, 1), (8, 2), (9, 4)])
def test_the_chain_ends_where_a_thing_is_taken_away(gone, last):
    """Without the ball at the edge, without the ball behind the gate; without the shelf it rings at once."""
    stage = open_level(Solids, "rube-goldberg")
    model = stage.scene.model
    model.remove(int(model.movable()[gone]))
    found = after(stage, 13.0)
    rung = [found[name] > 0.0 for name in STEPS]
    assert rung == ([True] * last + [False] * (4 - last) if gone != 9 else [True] * 4)
    if gone == 9:
        assert found["the bell rings"] < found["dominoes begin"]


@pytest.mark.parametrize("name", [name for name in ALL if not name.startswith("hard") and name != "pyramid"])
def test_what_a_machine_expects_comes_true(name):
    stage = open_level(Solids, name)
    after(stage, {"dominoes": 8.0, "galton-board": 8.0, "clock": 9.0, "newtons-cradle": 1.0}.get(name, 3.0))
    captions = captions_of(ALL[name].content.expected, stage.readouts())
    assert [caption.words for caption in captions if not caption.met] == []


def test_what_machines_expect_is_theory():
    expected = {
        name: {entry.readout: entry.value for entry in level.content.expected}
        for name, level in ALL.items()
        if not name.startswith("hard")
    }
    wave = 20 * 0.56 / (domino_wave_speed(0.4, 0.16, 0.2) * math.sqrt(G))
    assert expected["dominoes"]["from the 10th to the 30th"] == pytest.approx(wave, abs=1e-3)
    fall = math.sqrt(2.0 * G * 3.0 * (1.0 - math.cos(math.radians(45.0))))
    assert expected["newtons-cradle"]["fastest"] == pytest.approx(fall, abs=1e-3)
    assert expected["galton-board"]["right of the middle"] == 0.5 * 180
    lean = math.radians(20.0)
    storey = math.cos(lean) + 0.03 * math.sin(lean)
    assert expected["card-house"]["top"] == pytest.approx(2.5 * storey + 2 * 0.03, abs=1e-4)
    forces, _ = bridge_forces()
    assert expected["bridge"]["middle bar above"] == pytest.approx(-forces[8], abs=0.1)
    assert expected["bridge"]["middle bar below"] == pytest.approx(forces[2], abs=0.1)


SWING = """
scene = "solids"
title = "A swing"
about = "A rod on a pin."
[parameters]
step_length = 0.05
tier = "own"
substeps = 64
[content]
floor = -9.0
[[content.bodies]]
shapes = [{ box = [0.01, 1.0] }]
position = [0.00436, -0.49998]
angle = 0.5
[[content.joints]]
kind = "pin"
bodies = [-1, 0]
at = [0.0, 0.0]
[[content.gauges]]
name = "period"
measure = "period"
[content.view]
"""


def test_a_period_is_found_between_steps():
    """Of a rod on its end, 2 pi sqrt(2 L/(3 g)), though steps are a thirtieth of it."""
    stage = Stage(Solids, level=parse_level(SWING, "solids", SolidContent, "swing.toml"))
    exact = 2.0 * math.pi * math.sqrt(2.0 / (3.0 * G))
    found = []
    for _ in range(200):
        before = readouts(stage)["period"]
        now = after(stage, stage.dt)["period"]
        if now != before:
            found.append(now)
    assert len(found) >= 5
    assert found[1:] == pytest.approx([exact] * (len(found) - 1), rel=2e-3)


def test_only_blocks_of_the_arch_count_as_fallen():
    """Neither the ball that is there to be thrown nor a disc that a hand adds, be they below the height."""
    stage = open_level(Solids, "default")
    model = stage.scene.model
    blocks, (ball, *_) = list(model.gauges.blocks), model.movable().tolist()
    assert len(blocks) == 15 and ball not in blocks
    small = model.add(BodyEntry(shapes=(ShapeEntry(disc=0.1),), position=(5.0, 0.1)))
    model.world.bodies.positions[ball] = -5.0, 0.1
    assert after(stage, 0.1)["blocks that fell"] == 0
    model.world.bodies.positions[blocks[7]] = 4.0, 0.2
    assert after(stage, stage.dt)["blocks that fell"] == 1
    model.remove(blocks[7])
    again = model.add(BodyEntry(shapes=(ShapeEntry(disc=0.1),), position=(4.0, 0.1)))
    assert again == blocks[7] != small  # its number is given again, and is no block of the arch
    assert after(stage, stage.dt)["blocks that fell"] == 0
