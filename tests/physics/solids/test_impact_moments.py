"""Impacts within a step: at their moment, at one point of both bodies, whatever the step."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import floor_world, run

AWAKE = USUAL.without(SLEEP)
FRAME = 1.0 / 60.0
WITHOUT_SLOP = ["soft-step", "complementarity"]


def totals(world):
    """Momentum N s, N s and spin about the origin N m s."""
    rows = world.bodies
    mass, inertia = 1.0 / rows.inverse_masses, 1.0 / rows.inverse_inertias
    (x, y), (vx, vy) = rows.positions.T, rows.velocities.T
    return np.array(
        [(mass * vx).sum(), (mass * vy).sum(), (mass * (x * vy - y * vx) + inertia * rows.spins).sum()]
    )


def collision(seed, e, **settings):
    """Two boxes that meet askew, with friction: by how much momentum is off in the step in which they meet,
    and spin as part of the impulse times half a diagonal; whether they meet at all.
    """
    rng = np.random.default_rng(seed)
    material = Material(friction=rng.uniform(0.0, 1.0), restitution=e)
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), bounce=0.1, **settings))
    speed, turns = rng.uniform(3.0, 8.0), rng.uniform(0.0, 6.0, 2)
    world.add_body(box(1.0, 0.6, material=material), (0.0, 0.0), turns[0], spin=rng.uniform(-3, 3))
    world.add_body(
        box(0.8, 0.5, material=material), (-1.6, rng.uniform(-0.4, 0.4)), turns[1],
        (speed, 0.0), rng.uniform(-3, 3),
    )  # fmt: skip
    before, start = totals(world), world.bodies.velocities.copy()
    for _ in range(30):
        world.step(FRAME)
        if np.abs(world.bodies.velocities - start).max() > 0.1:
            break
    impulse = math.hypot(*world.bodies.velocities[0].tolist()) / float(world.bodies.inverse_masses[0])
    off = np.abs(totals(world) - before)
    return off[:2].max(), off[2] / (0.58 * impulse) if impulse > 0.1 else 0.0, impulse > 0.1


@pytest.mark.parametrize("solver", WITHOUT_SLOP)
def test_two_that_bounce_off_each_other_keep_momentum_and_spin_to_rounding(solver):
    """A second touch in the same step, too slow to be an impact, may cost some spin: one in ten."""
    found = [collision(seed, e, solver=solver) for seed in range(40) for e in (0.5, 1.0)]
    assert sum(met for _, _, met in found) > 70
    assert max(momentum for momentum, _, _ in found) < 1e-12
    spins = np.sort([spin for _, spin, _ in found])
    assert spins[-9] < 1e-13
    assert spins[-1] < 0.05


@pytest.mark.parametrize("substeps", [4, 24])
def test_two_that_do_not_bounce_keep_nearly_all_spin(substeps):
    """They press on after the impact, by levers of the step's beginning."""
    spins = [collision(seed, 0.0, substeps=substeps)[1] for seed in range(60)]
    assert np.median(spins) < 1e-4
    assert max(spins) < 0.03


def rebound(substeps, height=1.0, e=0.8):
    """Highest speed of rising times itself, over that of the law: of a disc let fall."""
    material = Material(restitution=e, friction=0.0)
    world, _ = floor_world(material, substeps=substeps, effects=AWAKE)
    ball = world.add_body(Disc(0.1, material=material), (0.0, 0.1 + height))
    highest, rising = 0.0, False
    for _ in range(90):
        world.step(FRAME)
        speed = float(world.bodies.velocities[ball, 1])
        if rising and speed <= 0.0:
            break
        rising = rising or speed > 0.0
        if rising:
            highest = max(highest, float(world.bodies.positions[ball, 1]) - 0.1 + speed * speed / 19.62)
    return highest / (e * e * height)


def test_the_height_of_a_rebound_errs_by_the_length_of_a_substep():
    off = {
        n: np.mean([abs(rebound(n, height) - 1.0) for height in np.linspace(1.0, 1.2, 7)])
        for n in (4, 24, 96)
    }
    assert off[4] < 0.02
    assert off[24] < 0.25 * off[4]
    assert off[96] < 0.35 * off[24]


@pytest.mark.parametrize("substeps", [4, 24])
def test_a_light_disc_that_lies_on_a_heavy_one_is_thrown_nine_times_as_high(substeps):
    """They fall together, 1,000 : 1, e 1: ((3 M - m)/(M + m))² of the height."""
    bouncy = Material(restitution=1.0, friction=0.0)
    world, _ = floor_world(bouncy, substeps=substeps, effects=AWAKE)
    world.add_body(Disc(0.5, material=Material(density=1000.0, restitution=1.0, friction=0.0)), (0.0, 1.5))
    light = world.add_body(Disc(0.5, material=bouncy), (0.0, 2.5))
    highest = 0.0
    for _ in range(150):
        world.step(FRAME)
        highest = max(highest, float(world.bodies.positions[light, 1]) - 1.5)
    assert highest == pytest.approx((2999.0 / 1001.0) ** 2, rel=0.06 / substeps)


@pytest.mark.parametrize("law", ["newton", "poisson", "energetic"])
@pytest.mark.parametrize("substeps", [1, 4, 24])
def test_a_corner_that_hits_the_floor_with_friction_goes_by_its_law(law, substeps):
    """A rod of 1 kg that sticks in compression: impulses in closed form, at any step."""
    e, mu, v, turn = 0.5, 0.9, 3.0, math.radians(60.0)
    width, length = 1e-4, 1.0
    rough = Material(friction=mu, restitution=e, density=1.0 / (width * length))
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), substeps=substeps, impact_law=law))
    world.add_body(box(20.0, 1.0, material=rough), (0.0, -0.5), kind="fixed")
    rod = world.add_body(box(length, width, material=rough), (0.0, 0.5), turn, (0.0, -v))
    inertia = 1.0 / float(world.bodies.inverse_inertias[rod])
    low = np.array([-0.5 * length, -0.5 * width])
    x, y = (
        math.cos(turn) * low[0] - math.sin(turn) * low[1],
        math.sin(turn) * low[0] + math.cos(turn) * low[1],
    )
    knn, knt, ktt = 1.0 + x * x / inertia, -x * y / inertia, 1.0 + y * y / inertia
    hold = -knt / ktt  # along +x; it would slide at once, and mu holds it
    assert abs(hold) < mu
    stuck = knn + knt * hold
    jn = (1.0 + e) * v / stuck  # it sticks from the first touch on: all laws are one
    run(world, 0.3)
    found = world.bodies.velocities[rod]
    assert found == pytest.approx((hold * jn, jn - v), rel=1e-9)
    assert world.bodies.spins[rod] == pytest.approx((x * jn - y * hold * jn) / inertia, rel=1e-9)


def test_a_disc_bounces_to_rounding_at_any_step():
    bouncy = Material(restitution=0.7, friction=0.1)
    for dt in (FRAME, 1.0 / 333.0, 1.0 / 2000.0):
        world, _ = floor_world(bouncy, gravity=(0.0, 0.0))
        ball = world.add_body(Disc(0.1, material=bouncy), (0.0, 0.3), velocity=(5.0, -4.0))
        world.step(dt)
        while world.bodies.velocities[ball, 1] < 0.0:
            world.step(dt)
        vx, vy = world.bodies.velocities[ball].tolist()
        assert (vx, vy) == pytest.approx((5.0 - 0.1 * 1.7 * 4.0, 2.8), rel=1e-12)
        hit = (0.3 - 0.1) / 4.0
        x, y = 5.0 * hit + vx * (world.time - hit), 0.1 + vy * (world.time - hit)
        assert world.bodies.positions[ball] == pytest.approx((x, y), rel=1e-12)


@pytest.mark.parametrize("substeps", [4, 24])
def test_a_small_box_shot_at_a_thin_wall_stays_on_its_side(substeps):
    """5 x 3 cm, 100 to 300 m/s, 2 cm: a hit at a corner makes it spin at thousands of rad/s."""
    for seed in (11, 48, 113, 214, 219, 275, 316, *range(30)):
        rng = np.random.default_rng(seed)
        restitution = float(rng.choice([0.0, 0.3, 0.8]))
        material = Material(friction=float(rng.uniform(0.0, 1.0)), restitution=restitution)
        world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), substeps=substeps))
        world.add_body(box(0.02, 40.0, material=material), (0.0, 0.0), kind="fixed")
        shot = world.add_body(
            box(0.05, 0.03, material=material), (-rng.uniform(1, 6), rng.uniform(-2, 2)),
            rng.uniform(0, 6.28), (rng.uniform(100.0, 300.0), rng.uniform(-30, 30)), rng.uniform(-200, 200),
        )  # fmt: skip
        before = world.energy().total
        for _ in range(30):
            world.step(FRAME)
            assert world.bodies.positions[shot, 0] < 0.0, seed
            now = world.energy().total
            assert now <= before * (1.0 + 1e-12), seed
            before = now
