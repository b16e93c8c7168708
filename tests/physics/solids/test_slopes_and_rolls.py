"""Sliding, stopping, rolling, bouncing, in closed form: boxes and discs on slopes and belts."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import FIRST_POINT, NORMAL_IMPULSE, POINT_WIDTH, POINTS
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, column, floor_world, run

AWAKE = USUAL.without(SLEEP)


def on_slope(shape_of, height, mu, degrees, **motion):
    """A world tilted by so many degrees, and a body on it, of friction mu as its ground."""
    material = Material(friction=mu)
    world, _ = floor_world(material, degrees, substeps=12, effects=AWAKE)
    return world, world.add_body(shape_of(material), (0.0, height), **motion)


@pytest.mark.parametrize(("speed", "mu", "degrees"), [(5.0, 0.4, 0.0), (3.0, 0.5, -10.0)])
def test_a_box_stops_after_the_square_of_its_speed(speed, mu, degrees):
    """v²/(2 g (mu cos + sin)); degrees: uphill."""
    pull = G * (mu * math.cos(math.radians(degrees)) + math.sin(math.radians(degrees)))
    world, body = on_slope(lambda m: box(1.0, 1.0, material=m), 0.5, mu, -degrees, velocity=(speed, 0.0))
    run(world, 3.0, 1.0 / 240.0)
    assert world.bodies.positions[body, 0] == pytest.approx(speed**2 / (2.0 * pull), rel=1e-3)
    assert world.bodies.velocities[body, 0] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(("part", "topples"), [(0.98, False), (1.02, True)])
def test_a_box_four_times_as_high_as_wide_topples_beyond_a_quarter(part, topples):
    """tan = b/h, with friction enough."""
    degrees = math.degrees(math.atan(0.25)) * part
    world, body = on_slope(lambda m: box(1.0, 4.0, material=m), 2.0, 0.6, degrees)
    run(world, 8.0)
    assert (abs(world.bodies.angles[body]) > 0.5) == topples


@pytest.mark.parametrize(("part", "slides"), [(0.98, False), (1.02, True)])
def test_a_low_box_starts_to_slide_where_the_tangent_is_the_friction(part, slides):
    world, body = on_slope(lambda m: box(1.0, 1.0, material=m), 0.5, 0.4, math.degrees(math.atan(0.4)) * part)
    run(world, 6.0)
    assert (world.bodies.positions[body, 0] > 0.5) == slides
    assert abs(world.bodies.angles[body]) < 0.01


@pytest.mark.parametrize(("part", "slips"), [(0.98, False), (1.02, True)])
def test_a_disc_rolls_up_to_the_slope_whose_tangent_is_three_times_the_friction(part, slips):
    degrees = math.degrees(math.atan(0.6)) * part
    world, body = on_slope(lambda m: Disc(0.3, material=m), 0.3, 0.2, degrees)
    run(world, 2.0)
    speed, rim = float(world.bodies.velocities[body, 0]), -0.3 * float(world.bodies.spins[body])
    if slips:
        assert speed - rim > 0.01 * speed
    else:
        assert speed - rim == pytest.approx(0.0, abs=1e-3 * speed)


@pytest.mark.parametrize(("speed", "backspin", "mu"), [(4.0, 0.0, 0.25), (2.0, 40.0, 0.3)])
def test_sliding_turns_into_rolling(speed, backspin, mu):
    """After (v0 + r w0)/(3 mu g), with (2 v0 - r w0)/3 (Coriolis 1835)."""
    r = 0.2
    world, body = on_slope(lambda m: Disc(r, material=m), r, mu, 0.0, velocity=(speed, 0.0), spin=backspin)
    dt, when = 1.0 / 240.0, (speed + r * backspin) / (3.0 * mu * G)
    end = (2.0 * speed - r * backspin) / 3.0
    rows = world.bodies
    while abs(rows.velocities[body, 0] + r * rows.spins[body]) > 1e-3 and world.time < 3.0:
        world.step(dt)
    assert world.time == pytest.approx(when, abs=2.0 * dt)
    assert rows.velocities[body, 0] == pytest.approx(end, rel=2e-3)
    late = world.time - when
    distance = 0.5 * (speed + end) * when + late * end
    assert rows.positions[body, 0] == pytest.approx(distance, rel=5e-3)


def test_a_box_set_down_on_a_belt_slips_for_its_length():
    """v/(mu g) long, v²/(2 mu g) far; the belt gives twice what the box gets."""
    v, mu, dt = 2.0, 0.3, 1.0 / 480.0
    world = SolidWorld(SolidSettings(substeps=12, effects=AWAKE))
    material = Material(friction=mu)
    world.add_body(box(60.0, 1.0, material=material), (0.0, -0.5), kind="key-framed", velocity=(v, 0.0))
    body = world.add_body(box(0.5, 0.5, material=material), (0.0, 0.25))
    while world.bodies.velocities[body, 0] < 0.999 * v and world.time < 2.0:
        world.step(dt)
    assert world.time == pytest.approx(v / (mu * G), rel=0.01)
    assert v * world.time - world.bodies.positions[body, 0] == pytest.approx(v * v / (2 * mu * G), rel=0.01)


def test_a_shaken_plate_is_left_where_it_falls_faster_than_all_else():
    """Lift-off at sin wt = g/(A w²); it lands, without a bounce, where the parabola meets the plate again."""
    amplitude, rate, dt = 0.05, 20.0, 1.0 / 1920.0
    leaves = math.asin(G / (amplitude * rate**2)) / rate

    def gap(t):
        flown, plate = t - leaves, amplitude * math.sin(rate * t)
        start, speed = G / rate**2, amplitude * rate * math.cos(rate * leaves)
        return start + speed * flown - 0.5 * G * flown**2 - plate

    low, high = leaves + 0.1, leaves + 0.3
    assert gap(low) > 0.0 > gap(high)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if gap(middle) > 0.0 else (low, middle)
    world = SolidWorld(SolidSettings(substeps=4, effects=AWAKE))
    plate = world.add_body(box(2.0, 0.2), (0.0, -0.1), kind="key-framed")
    body = world.add_body(box(0.5, 0.5), (0.0, 0.25))
    gaps = []
    for step in range(600):
        height = amplitude * math.sin(rate * (step + 1) * dt) - 0.1
        world.set_velocity(plate, (0.0, (height - float(world.bodies.positions[plate, 1])) / dt))
        world.step(dt)
        gaps.append(float(world.bodies.positions[body, 1] - world.bodies.positions[plate, 1]) - 0.35)
    found, times = np.array(gaps), dt * np.arange(1, 601)
    for k in (48, 96, 192, 384):  # 0.05 s falls in the time in which it opens with the cube of the time
        assert found[k] == pytest.approx(gap(times[k]), rel=0.02, abs=1e-5), times[k]
    landed = times[(times > 0.1) & (found < 1e-5)][0]
    assert landed == pytest.approx(low, rel=0.01)


def bounced(dt):
    """s until a ball let fall from 1 m with restitution 0.8 is slower than 1 cm/s, and its path, m."""
    material = Material(restitution=0.8, friction=0.0)
    world, _ = floor_world(material, substeps=4, effects=AWAKE, bounce=0.01)
    ball = world.add_body(Disc(0.1, material=material), (0.0, 1.1))
    path, rest, before = 0.0, 0.0, 1.1
    for _ in range(round(4.5 / dt)):
        world.step(dt)
        now = float(world.bodies.positions[ball, 1])
        path += abs(now - before)
        if abs(now - before) > 0.01 * dt:
            rest = world.time
        before = now
    return rest, path


def test_a_ball_bounces_until_it_rests():
    """Time sqrt(2h/g)(1 + e)/(1 - e), path h (1 + e²)/(1 - e²): of first order in the step.

    A ball is at rest below 1 cm/s; the flights after that, 0.2 % of the time, are not waited for.
    """
    e, fastest = 0.8, math.sqrt(2.0 * G)
    flights = math.floor(math.log(0.01 / fastest) / math.log(e))
    waited = fastest / G * (1.0 + 2.0 * sum(e**k for k in range(1, flights + 1)))
    assert waited == pytest.approx(math.sqrt(2.0 / G) * (1.0 + e) / (1.0 - e), rel=2.5e-3)
    exact = waited, (1.0 + e**2) / (1.0 - e**2)
    coarse, fine = bounced(1.0 / 1000.0), bounced(1.0 / 4000.0)
    for k in (0, 1):
        off = [abs(found[k] / exact[k] - 1.0) for found in (coarse, fine)]
        assert off[1] < 0.45 * off[0]
        assert off[1] < (0.005, 0.002)[k]


def test_the_floor_carries_a_column_and_the_tonne_on_it():
    world, floor = floor_world(substeps=32, effects=AWAKE)
    column(world, 10)
    world.add_body(box(1.0, 1.0, material=Material(density=1000.0)), (0.0, 10.5))
    run(world, 30.0)
    contacts = world.contacts
    mine = (contacts.bodies == floor).any(axis=1)
    force = pressing(world, mine)
    assert force == pytest.approx((10.0 + 1000.0) * G, rel=1e-3)


def pressing(world, chosen):
    """Normal force of these contacts in the last substep, N."""
    contacts = world.contacts
    total = 0.0
    for row, marks in zip(contacts.manifolds[chosen], contacts.marks[chosen], strict=True):
        for k in range(int(marks[POINTS])):
            total += float(row[FIRST_POINT + k * POINT_WIDTH + NORMAL_IMPULSE])
    return total * 60.0 * world.settings.substeps
