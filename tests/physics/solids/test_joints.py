"""Joints: what each kind holds, what it carries, where it breaks, and all of them at once."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.effects import GRAVITY, JOINTS
from tests.physics.solids.setups import G, energy, run

UNIT = Material(density=1.0)
HANGING = {"effects": GRAVITY | JOINTS}


def empty(**settings):
    """A world without contacts, and a fixed body."""
    world = SolidWorld(SolidSettings(**{**HANGING, **settings}))
    return world, world.add_body(box(1.0, 1.0), (0.0, 5.0), kind="fixed")


def rod(world, length, mass, position, angle=0.0):
    """A thin rod of a mass (kg), along x at angle 0."""
    thin = 1e-3
    return world.add_body(box(length, thin, material=Material(mass / (length * thin))), position, angle)


def chain(world, base, count, load):
    """Links of 0.2 m and 1 kg that hang from (0, 0), the last one heavier; their ids."""
    links, before = [], base
    for k in range(count):
        mass = load if k == count - 1 else 1.0
        link = world.add_body(box(0.05, 0.2, material=Material(mass / 0.01)), (0.0, -0.1 - 0.2 * k))
        world.add_joint("pin", before, link, (0.0, -0.2 * k))
        links.append(link)
        before = link
    return links


@pytest.mark.parametrize("solver", ["soft-step", "sequential-impulses"])
def test_a_chain_under_a_thousand_times_its_links_does_not_stretch(solver):
    world, base = empty(solver=solver)
    last = chain(world, base, 100, 1000.0)[-1]
    worst = 0.0
    for _ in range(120):
        world.step(1 / 60)
        worst = max(worst, abs(-world.bodies.positions[last, 1] - 19.9))
    assert worst < 0.005 * 20.0
    assert world.joint_load(0)[0] == pytest.approx(1099.0 * G, rel=1e-6)


def test_sweeps_stretch_what_the_direct_solve_holds():
    stretch = {}
    for name in ("direct", "sweeps"):
        world, base = empty(joint_solver=name)
        last = chain(world, base, 12, 1000.0)[-1]
        run(world, 0.5)
        stretch[name] = abs(-world.bodies.positions[last, 1] - (0.1 + 0.2 * 11))
    assert stretch["direct"] < 1e-6 < 0.05 < stretch["sweeps"]


def test_a_heavy_swinging_chain_keeps_its_length():
    world, base = empty()
    links, before = [], base
    for k in range(15):
        mass = 1800.0 if k == 14 else 1.0
        link = world.add_body(box(0.2, 0.05, material=Material(mass / 0.01)), (0.1 + 0.2 * k, 0.0))
        world.add_joint("pin", before, link, (0.2 * k, 0.0))
        links.append(link)
        before = link
    worst, start = 0.0, energy(world)
    for _ in range(90):
        world.step(1 / 60)
        worst = max(worst, max(gap_of(world, k) for k in range(15)))
        assert energy(world) < start + 1e-6 * 1800.0 * G
    assert worst < 0.01


def gap_of(world, joint):
    """How far the two points of a joint are apart, m."""
    ends = []
    for n, body in enumerate(world.joints.bodies[joint]):
        c, s = world.bodies.rotations[body]
        x, y = world.joints.anchors[joint, 2 * n : 2 * n + 2]
        ends.append(world.bodies.positions[body] + (c * x - s * y, s * x + c * y))
    return float(np.hypot(*(ends[0] - ends[1])))


def test_a_rod_swings_with_its_period():
    world, base = empty(substeps=16)
    body = rod(world, 1.0, 1.0, (0.5, 0.0))
    world.add_joint("pin", base, body, (0.0, 0.0))
    run(world, 1.9333348543732456, 1.9333348543732456 / 116)
    assert world.bodies.positions[body] == pytest.approx((0.5, 0.0), abs=0.02)
    assert gap_of(world, 0) < 1e-3


def test_double_rod():
    """Both rods let go from horizontal, by Lagrange's equations."""
    world, base = empty(substeps=64)
    first, second = rod(world, 1.0, 1.0, (0.5, 0.0)), rod(world, 1.0, 1.0, (1.5, 0.0))
    world.add_joint("pin", base, first, (0.0, 0.0))
    world.add_joint("pin", first, second, (1.0, 0.0))
    run(world, 1.0)
    turned = world.bodies.angles[[first, second]] + 0.5 * math.pi
    assert turned == pytest.approx((-1.2077162381906033, -0.814391023091329), abs=0.02)
    assert world.bodies.spins[[first, second]] == pytest.approx(
        (-3.4065175329726127, -0.5160454721037531), abs=0.1
    )


def cantilever(**breaking):
    """Eight welded blocks of 0.5 m and 2 kg; the root is joint 0."""
    world, base = empty()
    before = base
    for k in range(8):
        block = world.add_body(box(0.5, 0.5, material=Material(8.0)), (0.25 + 0.5 * k, 0.0))
        world.add_joint("weld", before, block, (0.5 * k, 0.0), **(breaking if k == 0 else {}))
        before = block
    return world


def test_a_welded_cantilever_carries_its_bending_moment():
    """m g n² a / 2 at the root."""
    world = cantilever()
    run(world, 1.0)
    force, torque = world.joint_load(0)
    assert (force, torque) == pytest.approx((16.0 * G, 313.92), rel=1e-6)


@pytest.mark.parametrize(("part", "holds"), [(1.02, True), (0.98, False)])
def test_a_weld_breaks_by_its_moment(part, holds):
    world = cantilever(break_torque=313.92 * part)
    broken = []
    for _ in range(60):
        world.step(1 / 60)
        broken += world.joints_broken().tolist()
    assert broken == ([] if holds else [0])


@pytest.mark.parametrize(("part", "breaks"), [(1.02, []), (0.98, [3])])
def test_a_spinning_bar_breaks_at_the_weld_that_carries_most_for_it(part, breaks):
    """m w² a (n² - k²) / 2 at the weld after k of n parts."""
    world, base = empty(effects=JOINTS, substeps=16)
    parts = [
        world.add_body(
            box(0.2, 0.2, material=Material(25.0)),
            (0.1 + 0.2 * k, 0.0),
            velocity=(0.0, 12.0 * (0.1 + 0.2 * k)),
            spin=12.0,
        )
        for k in range(10)
    ]
    world.add_joint("pin", base, parts[0], (0.0, 0.0))
    for k in range(9):
        load = 1310.4 * part if k == 2 else math.inf
        world.add_joint("weld", parts[k], parts[k + 1], (0.2 * (k + 1), 0.0), break_force=load)
    broken = []
    for _ in range(12):
        world.step(1 / 60)
        broken += world.joints_broken().tolist()
    assert broken == breaks
    if not breaks:
        assert world.joint_load(3)[0] == pytest.approx(1310.4, rel=0.01)


def test_what_a_broken_joint_let_go_collides_from_the_next_step():
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    a = world.add_body(box(1.0, 1.0), (0.0, 0.0))
    b = world.add_body(box(1.0, 1.0), (0.9, 0.0))
    world.add_joint("weld", a, b, (0.45, 0.0), break_force=10.0)
    world.step(1 / 60)
    assert len(world.contacts.bodies) == 0
    world.add_force(b, (10_000.0, 0.0))
    world.step(1 / 60)
    assert world.joints_broken().tolist() == [0]
    world.set_velocity(b, (0.0, 0.0))
    world.step(1 / 60)
    assert len(world.contacts.bodies) == 1
    assert world.joints_broken().tolist() == []


def test_a_slider_keeps_to_its_axis_and_its_limits():
    world, base = empty(substeps=8)
    body = world.add_body(box(0.2, 0.2), (0.0, 0.0))
    turn = math.radians(30.0)
    world.add_joint(
        "slider", base, body, (0.0, 0.0), axis=(math.cos(turn), -math.sin(turn)), limits=(-0.1, 0.5)
    )
    run(world, 0.25)
    n = 120
    slid = 0.5 * G / 480**2 * n * (n + 1) / 2
    assert world.bodies.positions[body] == pytest.approx(
        (slid * math.cos(turn), -slid * math.sin(turn)), rel=1e-6
    )
    run(world, 2.0)
    assert world.bodies.positions[body] == pytest.approx(
        (0.5 * math.cos(turn), -0.5 * math.sin(turn)), abs=1e-4
    )
    assert world.bodies.angles[body] == pytest.approx(0.0, abs=1e-9)
    assert world.joint_load(0)[0] == pytest.approx(0.04 * G, rel=1e-3)


def test_a_slider_turns_with_the_body_it_belongs_to():
    """Momentum and angular momentum of a free pair are kept."""
    world, _ = empty(effects=JOINTS, substeps=16)
    a = world.add_body(box(1.0, 0.2), (0.0, 0.0), spin=2.0)
    b = world.add_body(box(0.2, 0.2), (0.3, 0.1), velocity=(0.5, 0.6), spin=2.0)
    world.add_joint("slider", a, b, (0.3, 0.1), axis=(1.0, 0.0))
    before = momentum(world, (a, b))
    run(world, 1.0)
    assert momentum(world, (a, b)) == pytest.approx(before, abs=2e-3)
    assert world.bodies.angles[a] == pytest.approx(world.bodies.angles[b], abs=1e-3)
    c, s = world.bodies.rotations[a]
    x, y = world.bodies.positions[b] - world.bodies.positions[a]
    assert c * y - s * x == pytest.approx(0.1, abs=2e-3)


def momentum(world, bodies):
    """px, py, L about the origin."""
    total = np.zeros(3)
    for body in bodies:
        m, i = 1.0 / world.bodies.inverse_masses[body], 1.0 / world.bodies.inverse_inertias[body]
        (x, y), (vx, vy) = world.bodies.positions[body], world.bodies.velocities[body]
        total += m * vx, m * vy, m * (x * vy - y * vx) + i * world.bodies.spins[body]
    return total


def test_slider_crank_driven_by_a_motor():
    """Piston's place and speed at 60 degrees (r 0.2, l 0.5, 10 rad/s)."""
    world, base = empty(effects=JOINTS, substeps=16)
    crank, link = rod(world, 0.2, 1.0, (0.1, 0.0)), rod(world, 0.5, 1.0, (0.45, 0.0))
    piston = world.add_body(box(0.1, 0.1), (0.7, 0.0))
    world.add_joint("motor", base, crank, (0.0, 0.0), speed=10.0)
    world.add_joint("pin", crank, link, (0.2, 0.0))
    world.add_joint("pin", link, piston, (0.7, 0.0))
    world.add_joint("slider", base, piston, (0.7, 0.0))
    turns = math.tau + math.radians(60.0)  # past both dead centres
    run(world, turns / 10.0, turns / 10.0 / 60)
    assert world.bodies.spins[crank] == pytest.approx(10.0, rel=1e-3)
    place = float(world.bodies.positions[piston, 0])
    angle = float(world.bodies.angles[crank])
    assert place == pytest.approx(
        0.2 * math.cos(angle) + math.sqrt(0.25 - 0.04 * math.sin(angle) ** 2), abs=1e-3
    )
    assert angle == pytest.approx(turns, abs=0.05)
    assert max(gap_of(world, k) for k in range(3)) < 1e-3


@pytest.mark.parametrize("joint_solver", ["direct", "sweeps"])
def test_loops_and_redundant_joints_stay_finite(joint_solver):
    world, base = empty(joint_solver=joint_solver, substeps=8)
    left = world.add_body(box(0.1, 1.0), (-0.5, -0.5))
    right = world.add_body(box(0.1, 1.0), (0.5, -0.5))
    across = world.add_body(box(1.0, 0.1), (0.0, -1.0), velocity=(1.0, 0.0))
    more = world.add_body(box(0.2, 0.2), (0.0, -1.2))
    world.add_joint("pin", base, left, (-0.5, 0.0))
    world.add_joint("pin", base, right, (0.5, 0.0))
    world.add_joint("pin", left, across, (-0.5, -1.0))
    world.add_joint("pin", right, across, (0.5, -1.0))
    for _ in range(3):
        world.add_joint("weld", across, more, (0.0, -1.1))
    run(world, 2.0)
    assert np.isfinite(world.bodies.positions).all()
    loads = [world.joint_load(k) for k in range(7)]
    assert np.isfinite(loads).all()
    assert max(gap_of(world, k) for k in range(7)) < (1e-3 if joint_solver == "direct" else 0.05)


def test_a_rope_is_slack_then_taut():
    world, base = empty(substeps=8)
    body = world.add_body(Disc(0.1), (0.0, 0.0))
    world.add_joint("rope", base, body, (0.0, 0.5), (0.0, 0.0), length=1.0)
    run(world, 0.25)
    assert world.joint_load(0)[0] == 0.0
    assert world.bodies.velocities[body, 1] == pytest.approx(-0.25 * G)
    run(world, 2.0)
    assert world.bodies.positions[body, 1] == pytest.approx(-0.5, abs=1e-3)
    mass = 1.0 / world.bodies.inverse_masses[body]
    assert world.joint_load(0)[0] == pytest.approx(mass * G, rel=1e-6)
    world.push(body, world.bodies.positions[body], (0.0, 2.0 * mass))
    run(world, 0.1)
    assert world.bodies.positions[body, 1] == pytest.approx(-0.5 + 0.2 - 0.5 * G * 0.01, abs=0.01)


def test_a_chain_of_ropes_under_a_heavy_load_does_not_stretch():
    world, base = empty()
    before, at = base, (0.0, 0.0)
    for k in range(20):
        body = world.add_body(
            Disc(0.05, material=Material((1000.0 if k == 19 else 1.0) / (math.pi * 0.0025))),
            (0.0, -0.5 * (k + 1)),
        )
        world.add_joint("rope", before, body, at, (0.0, -0.5 * (k + 1)))
        before, at = body, (0.0, -0.5 * (k + 1))
    run(world, 1.0)
    assert world.bodies.positions[before, 1] == pytest.approx(-10.0, abs=0.01)
    assert world.joint_load(0)[0] == pytest.approx(1019.0 * G, rel=1e-4)


def test_a_spring_swings_with_its_frequency_and_damping():
    world, base = empty(gravity=(0.0, 0.0), substeps=64)
    body = world.add_body(Disc(0.1), (0.0, -1.2))
    world.add_joint("spring", base, body, (0.0, 0.0), (0.0, -1.2), length=1.0, hertz=2.0, damping=0.05)
    run(world, 0.5)
    shrunk = math.exp(-0.05 * math.tau)
    assert -1.0 - world.bodies.positions[body, 1] == pytest.approx(0.2 * shrunk, rel=0.05)
    run(world, 10.0)
    assert world.bodies.positions[body, 1] == pytest.approx(-1.0, abs=1e-3)


def test_a_motor_spins_up_by_its_torque_and_holds_its_speed():
    world, base = empty(gravity=(0.0, 0.0))
    wheel = world.add_body(Disc(0.5), (0.0, 0.0))
    joint = world.add_joint("motor", base, wheel, (0.0, 0.0), speed=6.0, most=0.1)
    inertia = 1.0 / world.bodies.inverse_inertias[wheel]
    run(world, 0.5)
    assert world.bodies.spins[wheel] == pytest.approx(0.1 * 0.5 / inertia, rel=1e-9)
    assert world.joint_load(joint)[1] == pytest.approx(0.1)
    run(world, 10.0)
    assert world.bodies.spins[wheel] == pytest.approx(6.0, rel=1e-9)
    world.drive(joint, -2.0, 10.0)
    run(world, 1.0)
    assert world.bodies.spins[wheel] == pytest.approx(-2.0, rel=1e-9)


def test_a_pin_stops_at_its_limits():
    world, base = empty(substeps=8)
    body = rod(world, 1.0, 1.0, (0.5, 0.0))
    world.add_joint("pin", base, body, (0.0, 0.0), limits=(-0.5, 0.1))
    run(world, 3.0)
    assert world.bodies.angles[body] == pytest.approx(-0.5, abs=1e-3)
    assert world.bodies.spins[body] == pytest.approx(0.0, abs=1e-6)


def test_a_mouse_pulls_by_no_more_than_its_force():
    world, base = empty(gravity=(0.0, 0.0))
    body = world.add_body(box(1.0, 1.0), (0.0, 0.0))
    joint = world.add_joint("mouse", base, body, (0.0, 0.0), hertz=5.0, most=2.0)
    world.drag_to(joint, (10.0, 0.0))
    run(world, 1.0)
    assert world.bodies.velocities[body, 0] == pytest.approx(2.0, rel=1e-6)
    world.set_velocity(body, (0.0, 0.0))
    world.drag_to(joint, world.bodies.positions[body] + (0.01, 0.02))
    goal = world.bodies.positions[body] + (0.01, 0.02)
    run(world, 3.0)
    assert world.bodies.positions[body] == pytest.approx(goal, abs=1e-5)


def test_a_mouse_brings_the_point_it_holds_to_its_target():
    world, base = empty(gravity=(0.0, 0.0))
    body = world.add_body(box(1.0, 1.0), (1.0, 2.0))
    joint = world.add_joint("mouse", base, body, (1.4, 2.3), hertz=5.0)
    goal = np.array((1.6, 2.0))
    world.drag_to(joint, goal)
    run(world, 1.0)
    angle = world.bodies.angles[body]
    lever = (
        0.4 * math.cos(angle) - 0.3 * math.sin(angle),
        0.4 * math.sin(angle) + 0.3 * math.cos(angle),
    )
    assert abs(angle) > 0.1
    assert world.bodies.positions[body] + lever == pytest.approx(goal, abs=0.01)


def test_a_weld_with_a_compliance_bends():
    world, base = empty()
    body = rod(world, 1.0, 1.0, (0.5, 0.0))
    world.add_joint("weld", base, body, (0.0, 0.0), hertz=3.0)
    run(world, 4.0)
    assert -0.2 < world.bodies.angles[body] < -0.005
    assert abs(world.bodies.spins[body]) < 1e-3


def test_joints_can_be_switched_off():
    world, base = empty(effects=GRAVITY)
    body = world.add_body(Disc(0.1), (0.0, 0.0))
    world.add_joint("weld", base, body, (0.0, 0.0))
    run(world, 0.5)
    assert world.bodies.velocities[body, 1] == pytest.approx(-0.5 * G)


def test_restored_joints_go_on_equal_to_the_bit():
    world, base = empty()
    links = chain(world, base, 8, 50.0)
    world.add_joint("distance", base, links[3], (0.4, 0.0), (0.0, -0.7))
    world.push(links[4], (0.0, -0.9), (3.0, 0.0))
    run(world, 0.3)
    before = world.state()
    run(world, 0.5)
    after = world.bodies.positions.copy()
    world.restore(before)
    run(world, 0.5)
    assert np.array_equal(world.bodies.positions, after)


@pytest.mark.parametrize(
    ("kind", "options", "field"),
    [
        ("spring", {}, "hertz"),
        ("weld", {"limits": (0.0, 1.0)}, "limits"),
        ("pin", {"limits": (1.0, 0.0)}, "limits"),
        ("pin", {"limits": (math.nan, 0.0)}, "limits"),
        ("slider", {"axis": (0.0, 0.0)}, "axis"),
        ("motor", {"speed": math.nan}, "speed"),
        ("motor", {"most": -1.0}, "most"),
        ("rope", {"length": -1.0}, "length"),
        ("weld", {"break_force": 0.0}, "break_force"),
        ("glue", {}, "kind"),
    ],
)
def test_nonsense_is_refused_and_leaves_no_joint(kind, options, field):
    world, base = empty()
    body = world.add_body(Disc(0.1), (0.0, 0.0))
    with pytest.raises(ValueError, match=field):
        world.add_joint(kind, base, body, (0.0, 0.0), **options)
    assert (world.joints.kinds == -1).all()
    world.step(1 / 60)
