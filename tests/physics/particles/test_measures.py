"""What is measured of a swarm, and where it is between two steps."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.fields import DRAG, GRAVITY, WIND
from game.physics.particles import CALM, Discs, Emitter, ParticleSystem
from game.physics.particles.in_between import Instant, Shown, Swarm, gather_touching, place_between
from game.physics.particles.measures import count_touching, envelope, measure_deviation, measure_swarm

SPEED, G = 6.0, 9.81
FREE = CALM._replace(gravity=0.0, drag=0.0)
THROWN = FREE._replace(gravity=G)
BLOWN = CALM._replace(gravity=G, drag=0.7, wind_x=2.0, wind_y=0.5)


def swarm(law, effects, **changes):
    settings = {
        "emitters": [Emitter(rate=400.0, spread=0.6, speed=SPEED, speed_range=0.0, width=0.0)],
        "effects": effects,
        "method": "exponential",
        "life": 1e9,
        "forces": law,
        "floor": -1e3,
    }
    return ParticleSystem(300, **{**settings, **changes})


def deviation(system, law, since=0.0, tolerance=1e-9, stride=1):
    return measure_deviation(
        Swarm(system.fields, system.tags), 0, len(system), stride, system.state().emitters, law,
        system.time_s, since, tolerance,
    )  # fmt: skip


def test_energy_and_height_are_sums():
    system = swarm(THROWN, GRAVITY | GRAVITY)
    for _ in range(20):
        system.step(0.03)
    (x, y), v = system.positions.T, system.velocities
    kinetic, potential, highest = measure_swarm(system.fields, 0, len(system), G, -2.0, -math.inf)
    assert kinetic == pytest.approx(0.5 * (v * v).sum(), rel=1e-12)
    assert potential == pytest.approx(G * (y + 2.0).sum(), rel=1e-12)
    assert highest == y.max() and len(x) == len(system) > 200
    births = system.fields[4, : len(system)]
    lately = np.median(births)
    assert measure_swarm(system.fields, 0, len(system), G, -2.0, lately)[2] == y[births >= lately].max()
    assert measure_swarm(system.fields, 0, len(system), G, -2.0, system.time_s + 1.0)[2] == -math.inf


@pytest.mark.parametrize(("law", "effects"), [(THROWN, GRAVITY | GRAVITY), (BLOWN, GRAVITY | DRAG | WIND)])
def test_a_swarm_lies_on_its_circles(law, effects):
    """However they were aimed: particles of one age are on one circle, to rounding."""
    system = swarm(law, effects, substeps=4)
    for _ in range(30):
        system.step(1.0 / 60.0)
    worst, outside, looked = deviation(system, law, tolerance=1e-9)
    assert looked == len(system) == 200
    assert worst < 1e-13 and outside == 0
    assert deviation(system, law, since=0.401)[2] == 40
    assert deviation(system, law, stride=3)[2] == 67
    system.fields[0, 7] += 5.0
    worst, outside, _ = deviation(system, law, tolerance=1e-2)
    assert worst > 0.5 and outside == 1


def test_what_has_touched_a_stone_is_not_compared():
    system = swarm(THROWN, ParticleSystem(1).effects, solids=Discs([(0.0, 1.5)], [0.6]), floor=-50.0)
    for _ in range(60):
        system.step(1.0 / 60.0)
    touched = count_touching(system.tags, 0, len(system), 1)
    assert 0 < touched <= len(system)
    assert deviation(system, THROWN)[2] == len(system) - touched
    positions = np.ascontiguousarray(system.positions)
    places = np.zeros_like(positions)
    found = gather_touching(system.tags, positions, 0, len(system), 1, 0, 0, places)
    assert found == touched
    assert np.array_equal(places[:found], positions[system.tags[1, : len(system)] >= 1])
    assert count_touching(system.tags, 0, len(system), 1000) == 0


def test_the_envelope_is_the_parabola_of_safety():
    """Torricelli 1644: y = v²/2g - g x²/2v²."""
    curve = envelope(THROWN, SPEED, 2.0, points=50)
    x, y = curve.T
    assert len(curve) == 100 and (np.diff(x) >= -1e-9).all()
    assert y == pytest.approx(SPEED**2 / (2 * G) - G * x * x / (2 * SPEED**2), abs=1e-5)


@pytest.mark.parametrize("wind", [3.0, -3.0])
def test_no_particle_passes_the_envelope(wind):
    """Of all ways that can be aimed: in every direction seen from the middle, none goes farther out."""
    law = BLOWN._replace(wind_x=wind)
    curve = envelope(law, SPEED, 1.5, points=400)
    assert (np.diff(curve[:, 0]) >= -1e-6).all()
    k, times = law.drag, np.linspace(1e-3, 1.5, 300)
    reach = (1.0 - np.exp(-k * times)) / k
    drift = (times - reach) / k
    for angle in np.linspace(0.0, math.pi, 41):
        x = SPEED * math.cos(angle) * reach + wind * (times - reach)
        y = SPEED * math.sin(angle) * reach + law.wind_y * (times - reach) - G * drift
        under = (x > curve[0, 0]) & (x < curve[-1, 0])
        assert (y[under] <= np.interp(x[under], *curve.T) + 2e-3).all()


def test_there_is_no_envelope_without_a_force_or_before_circles_overlap():
    assert envelope(FREE, SPEED, 5.0).shape == (0, 2)
    assert envelope(THROWN, SPEED, 0.5).shape == (0, 2)


def test_between_two_steps():
    """Part of the way for those that were there; the new ones come out of the nozzle along their velocity,
    and wait in it until they are born."""
    dt, alpha = 0.01, 0.4
    system = swarm(THROWN, GRAVITY | GRAVITY)
    system.step(dt)
    before, tags = system.fields.copy(), system.tags.copy()
    old = len(system)
    system.step(dt)
    n = len(system)
    assert (old, n) == (4, 8)
    positions, velocities, trails = np.zeros((3, n + 1, 2))
    row = place_between(
        Swarm(system.fields, system.tags), Swarm(before, tags), 0, n, Instant(alpha, dt, system.time_s), 0.01,
        Shown(positions, velocities, trails), 1,
    )  # fmt: skip
    assert row == n + 1
    assert np.array_equal(velocities[1:], system.velocities)
    now, then = system.positions, before[:2, :n].T
    assert positions[1 : old + 1] == pytest.approx(then[:old] + alpha * (now - then)[:old])
    back = (1.0 - alpha) * dt
    lived = system.time_s - system.fields[4, old:n, None]
    assert positions[old + 1 :] == pytest.approx(
        now[old:] - np.minimum(back, lived) * system.velocities[old:]
    )
    assert (lived < back).any() and (lived > back).any()
    age = system.time_s - back - system.fields[4, :n]
    part = np.clip(age / 0.01, 0.0, 1.0)[:, None]
    assert trails[1:] == pytest.approx(part * system.velocities)
    unborn = age <= 0.0
    assert unborn.any() and not trails[1:][unborn].any()
