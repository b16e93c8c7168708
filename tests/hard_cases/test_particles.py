"""Particles where it hurts: born inside stones, stiff drag, full pools, wedges, grazes, rest, absurdity."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG
from game.physics.particles import CALM, CONTACTS, METHODS, OBSTACLES, Discs, Emitter, ParticleSystem
from game.physics.particles.runaway import FARTHEST

FREE = EffectSet([GRAVITY])


def run(system, dt, steps):
    for _ in range(steps):
        system.step(dt)
        assert np.all(np.isfinite(system.state().fields))
    system.check()
    return system


@pytest.mark.parametrize("contact", CONTACTS)
def test_born_inside_a_stone(contact):
    """Put on the surface along the normal, at the very centre upwards; never faster than it was sent out."""
    stone = Discs([(0, 0)], [0.5], 0.0)
    nozzle = Emitter((0.1, 0.2), rate=200.0, speed=3.0, spread=math.pi)
    system = ParticleSystem(
        400, emitters=[nozzle], solids=stone, effects=EffectSet([OBSTACLES]), contact=contact
    )
    run(system, 1 / 60, 1)
    gaps, _, _ = stone.sample(system.positions)
    assert len(system) == 3
    assert gaps.min() >= -1e-12
    run(system, 1 / 60, 50)
    assert np.linalg.norm(system.velocities, axis=1).max() <= 3.0 + 1e-12
    for rate in (1000.0, 3000.0):  # births at the very end of a step, and without time to fly
        system = ParticleSystem(
            400, emitters=[Emitter((0.1, 0.2), rate=rate, speed=3.0, spread=math.pi)], solids=stone,
            effects=EffectSet([OBSTACLES]), contact=contact, life=0.1,
        )  # fmt: skip
        run(system, 1 / 250, 50)
    centre = ParticleSystem(
        4, solids=Discs([(1, 1)], [0.5]), effects=EffectSet([OBSTACLES]), contact=contact, life=9
    )
    centre.add([(1, 1)], [(0, 0)])
    run(centre, 1 / 60, 1)
    assert np.allclose(centre.positions[0], (1, 1.5), rtol=0, atol=1e-12)
    assert np.array_equal(centre.velocities[0], (0, 0))


def test_a_step_longer_than_a_life():
    """Each is born and dies in the step, exactly once."""
    system = ParticleSystem(10, emitters=[Emitter(rate=100.0)], effects=FREE, life=0.03)
    run(system, 0.5, 4)
    assert (system.born, system.died, len(system)) == (200, 197, 3)
    assert system.dropped == 0


def test_full_pool_drops_and_counts():
    system = ParticleSystem(100, emitters=[Emitter(rate=1000.0)], effects=FREE, life=1.0)
    run(system, 1 / 50, 100)
    assert len(system) == 100
    # room comes free once a life: 100 births at the beginning and 100 after a second
    assert system.born == 200
    assert system.dropped == 2000 - 200
    run(system, 1 / 50, 1)
    system.change_emitter(0, Emitter(rate=0.0))
    run(system, 1 / 50, 60)
    assert len(system) == 0


def test_count_of_births():
    system = ParticleSystem(2000, emitters=[Emitter(rate=400.0)], effects=FREE, life=2.5)
    for dt, steps in ((1 / 60, 60), (1 / 240, 240), (0.5, 1), (0.87, 1)):
        run(system, dt, steps)
    assert system.time_s == pytest.approx(3.37, abs=1e-12)
    assert (system.born, len(system)) == (1348, 1000)


@pytest.mark.parametrize(
    ("method", "growth"), [("explicit-euler", 2.33), ("verlet", 3.22), ("midpoint", 3.22), ("rk4", 2.19)]
)
def test_stiff_drag_without_substeps_grows_as_predicted(method, growth):
    """k = 200/s at 1/60 s: each step multiplies the speed by the method's polynomial of k dt."""
    system = ParticleSystem(
        4,
        effects=GRAVITY | DRAG,
        method=method,
        forces=CALM._replace(drag=200.0, gravity=0.0),
        substeps=1,
        life=99,
    )
    system.add([(0, 0)], [(1, 0)])
    system.step(1 / 60)
    assert abs(system.velocities[0, 0]) == pytest.approx(growth, abs=5e-3)


@pytest.mark.parametrize(
    "method", ["explicit-euler", "verlet", "midpoint", "rk4", "stormer-verlet", "exponential"]
)
def test_stiff_drag_is_done_right(method):
    """As the system does it by itself: within 1 % of g / k after 5 / k."""
    k = 200.0
    system = ParticleSystem(4, effects=GRAVITY | DRAG, method=method, forces=CALM._replace(drag=k), life=99)
    system.add([(0, 0)], [(0, 0)])
    dt = 5.0 / k / 2.0
    run(system, dt, 2)
    assert abs(-system.velocities[0, 1] * k / 9.81 - 1.0) < 0.01


@pytest.mark.parametrize(("contact", "stopped"), [("end", False), ("chord", True), ("root", True)])
@pytest.mark.parametrize("speed", [50.0, 1000.0, 9000.0])
def test_fast_particle_and_small_stone(contact, stopped, speed):
    """A stone of 2 cm: passed by when only the end of a step is looked at, never with the swept ways."""
    stone = Discs([(0.25 * speed / 60, 0.0)], [0.02], 0.5)
    system = ParticleSystem(4, solids=stone, effects=EffectSet([OBSTACLES]), contact=contact, life=9)
    system.add([(0, 0.005)], [(speed, 0)])
    run(system, 1 / 60, 1)
    assert (system.velocities[0, 0] < 0) == stopped


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("offset", [-1e-12, 0.0, 1e-12, 1e-9, -1e-9, -1e-6])
def test_a_graze_gains_no_energy_and_nobody_sticks(contact, offset):
    """Past the top of a stone at a hair's breadth: no energy is won, none to speak of lost, nobody sticks."""
    system = ParticleSystem(
        4, solids=Discs([(1, 0)], [0.5], 0.5), effects=EffectSet([OBSTACLES]), contact=contact, life=9
    )
    system.add([(0, 0.5 + offset)], [(6, 0)])
    run(system, 1 / 60, 40)
    speed = np.linalg.norm(system.velocities[0])
    assert 6.0 * (1 - 1e-4) <= speed <= 6.0 + 1e-12
    assert system.positions[0, 0] == pytest.approx(4.0, abs=1e-2)


@pytest.mark.parametrize(
    ("method", "contact", "e"),
    [(method, contact, 0.5) for method in METHODS for contact in CONTACTS]
    + [("explicit-euler", contact, e) for contact in CONTACTS for e in (0.0, 0.8)],
)
def test_everything_comes_to_rest_on_a_floor_and_on_a_stone(method, contact, e):
    """On a floor and on the top of a stone everything comes to rest, whatever the method."""
    stone = Discs([(3, 0)], [1.0], e)
    system = ParticleSystem(
        4, solids=stone, effects=GRAVITY | GROUND | OBSTACLES, method=method, contact=contact,
        floor_restitution=e, life=1e9,
    )  # fmt: skip
    system.add([(0, 1), (3, 2)], [(0, 0), (0, 0)])
    for _ in range(60 * 8):
        system.step(1 / 60)
    assert np.allclose(system.positions, [(0, 0), (3, 1)], rtol=0, atol=1e-12)
    assert np.allclose(system.velocities, 0.0, rtol=0, atol=1e-12)


def test_bounce_floor_without_a_rule_for_rest():
    """Why there is one: a twin that only clamps and reflects never rests with explicit Euler, at about
    3 g dt / (1 - e²), nor with Verlet; with semi-implicit Euler it does."""
    e, dt, g = 0.9, 1 / 60, 9.81
    heights = {}
    for method in ("explicit-euler", "verlet", "semi-implicit-euler"):
        y, v, top = 1.0, 0.0, 0.0
        for i in range(60 * 60):
            if method == "explicit-euler":
                y, v = y + dt * v, v - dt * g
            elif method == "verlet":
                y, v = y + dt * v - g * dt * dt / 2, v - dt * g
            else:
                v -= dt * g
                y += dt * v
            if y < 0.0:
                y, v = 0.0, abs(v) * e
            top = max(top, y) if i > 60 * 50 else 0.0
        heights[method] = top
    bounce = 3 * g * dt / (1 - e * e)
    assert heights["explicit-euler"] == pytest.approx(bounce**2 / (2 * g), rel=0.2)
    assert 0.05 < heights["verlet"] < 0.13
    assert heights["semi-implicit-euler"] < 1e-2


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_wedge_between_overlapping_stones(contact, e):
    """Into the cusp between two stones that just overlap: every step ends, time dropped is counted."""
    stones = Discs([(-0.5, 0), (0.5, 0)], [0.5001, 0.5001], e)
    system = ParticleSystem(60, solids=stones, effects=GRAVITY | OBSTACLES, contact=contact, life=1e9)
    x = np.linspace(-0.2, 0.2, 41)
    system.add(np.stack([x, np.full(41, 1.0)], axis=1), np.tile([0.0, -20.0], (41, 1)))
    run(system, 1 / 60, 60)
    assert stones.sample(system.positions)[0].min() > -2e-4
    if contact != "end":
        energies = np.sum(system.velocities**2, axis=1) / 2 + 9.81 * system.positions[:, 1]
        assert energies.max() < 200 + 9.81 + 1e-9
        assert system.cut_short > 0


def test_a_path_does_not_depend_on_the_pool_or_on_others():
    """The path of a particle by its identity does not depend on the pool, on other emitters or on the seed
    of others."""
    lone = Emitter((0, 0), rate=50.0, spread=0.3)
    crowd = Emitter((2, 0), rate=40_000.0, spread=0.6)
    kept = {}
    for count, sources in ((200, [lone]), (100_000, [lone, crowd])):
        system = ParticleSystem(
            count, emitters=sources, solids=Discs([(0.2, 2)], [0.4]), effects=GRAVITY | OBSTACLES, seed=4
        )
        for _ in range(120):
            system.step(1 / 60)
        mine = system.identities < 2**40
        kept[count] = (system.identities[mine], system.positions[mine], system.velocities[mine])
    for few, many in zip(*kept.values(), strict=True):
        assert np.array_equal(few, many)
    assert len(kept[200][0]) == 100
    nobody = ParticleSystem(10, effects=GRAVITY | OBSTACLES | GROUND)
    run(nobody, 1 / 60, 10)
    assert len(nobody) == 0


@pytest.mark.parametrize("contact", CONTACTS)
def test_absurd_but_finite_numbers_end(contact):
    """Subnormal sizes, the largest coordinates and speeds, a step of a thousand seconds."""
    stones = Discs([(1e6, 0), (0, 0), (0, 1)], [1e6, 1e-300, 5e-324])
    system = ParticleSystem(
        10, solids=stones, effects=GRAVITY | DRAG | OBSTACLES | GROUND, contact=contact, life=1e12, floor=-1e6
    )
    system.add([(0, 0), (1e6, 1e6), (-1e6, 0), (0, 1)], [(1e6, 0), (-1e6, 1e6), (0, 0), (5e-324, 0)])
    for dt in (1e-300, 1e-9, 1.0, 1000.0):
        system.step(dt)
        assert np.all(np.isfinite(system.positions))


def test_two_runs_give_the_same_bits():
    states = []
    for _ in range(2):
        system = ParticleSystem(
            3000, emitters=[Emitter(rate=2000.0)], solids=Discs([(0.1, 2)], [0.4]),
            effects=GRAVITY | DRAG | OBSTACLES | GROUND, seed=1,
        )  # fmt: skip
        run(system, 1 / 120, 300)
        states.append([np.array(part) for part in system.state()])
    for a, b in zip(*states, strict=True):
        assert a.tobytes() == b.tobytes()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("contact", CONTACTS)
def test_drag_that_no_step_can_follow_leaves_numbers(method, contact):
    """q |v| h = 50 000: explicit methods throw the particles away, and they are held far out; the others slow
    them down."""
    law = CALM._replace(drag=500.0, quadratic_drag=10.0)
    everything = EffectSet([GRAVITY, DRAG, QUADRATIC_DRAG, GROUND, OBSTACLES])
    system = ParticleSystem(
        40, solids=Discs([(0.5, 1.0)], [0.5]), effects=everything, method=method, contact=contact, life=30.0,
        forces=law, substeps=1,
    )  # fmt: skip
    angles = np.linspace(0.0, 6.0, 40)
    system.add(np.full((40, 2), 3.0), 1e4 * np.column_stack([np.cos(angles), np.sin(angles)]))
    held = 0
    for _ in range(40):
        run(system, 0.5, 1)
        held += system.runaways
        assert np.abs(system.fields[:4]).max() <= FARTHEST
    assert (held > 0) == (method not in ("stormer-verlet", "exponential"))


def test_who_is_not_thrown_away_is_not_looked_for():
    """The guard costs nothing where the step is short enough, and finds those put in by hand."""
    system = ParticleSystem(4, effects=EffectSet([DRAG, QUADRATIC_DRAG]), forces=CALM)
    assert not system.may_run_away(1.0 / 240.0)
    system.add([(0.0, 0.0)], [(1e6, 0.0)])
    assert system.may_run_away(1.0 / 240.0)
    again = ParticleSystem(4, effects=EffectSet([DRAG, QUADRATIC_DRAG]), forces=CALM)
    again.restore(system.state())
    assert again.may_run_away(1.0 / 240.0)
