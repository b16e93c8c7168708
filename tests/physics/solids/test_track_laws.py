"""Times and speeds on tracks by quadrature and formulas: races, descents, crests, corners, a hexagon."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from game.physics.solids import Material, Polygon, SolidSettings, SolidWorld, box
from game.physics.solids.effects import SLEEP, USUAL
from game.physics.solids.tracks.curves import Curve, moved_aside
from game.physics.solids.tracks.motion import FREE, PIECE, SPEED, VX, VY, X, Y
from tests.physics.solids.test_tracks import DT, G, arrival, cycloid, passes_loop, run, seated, world_of

FREE_OF_FRICTION, ROLLING = 0.0, 1e6


def descent(way):
    """s from rest along a way (n, 2) of fine chords, without friction: each is uniformly accelerated."""
    speeds = np.sqrt(2.0 * G * (way[0, 1] - way[:, 1]))
    lengths = np.hypot(*np.diff(way, axis=0).T)
    return float((2.0 * lengths / (speeds[1:] + speeds[:-1])).sum())


def race_ways(a, b, count=4000):
    """From (0, 0) to (a, -b): a straight line, x = a (y/b)², a cycloid; dense where they are steep."""
    t = np.linspace(0.0, 1.0, count) ** 2
    turn = brentq(lambda u: (u - math.sin(u)) / (1.0 - math.cos(u)) - a / b, 0.1, 2.0 * math.pi - 0.1)
    angle = np.linspace(0.0, turn, count)
    r = b / (1.0 - math.cos(turn))
    return {
        "line": np.stack([a * t, -b * t], axis=1),
        "parabola": np.stack([a * t**2, -b * t], axis=1),
        "cycloid": r * np.stack([angle - np.sin(angle), np.cos(angle) - 1.0], axis=1),
    }


@pytest.mark.parametrize(("a", "b"), [(2.0, 1.0), (0.5 * math.pi, 1.0)])
def test_line_parabola_and_cycloid_race_in_their_times(a, b):
    """Bernoulli 1697: the cycloid is first."""
    times = {}
    for name, way in race_ways(a, b).items():
        exact = descent(way)
        times[name] = arrival(way[::10], a - 1e-6, 0.02, FREE_OF_FRICTION)
        assert times[name] == pytest.approx(exact, rel=5e-3), name
    assert times["cycloid"] < times["parabola"] < times["line"]
    assert descent(race_ways(2.0, 1.0)["line"]) == pytest.approx(math.sqrt(2.0 * 5.0 / G))


@pytest.mark.parametrize("part", [0.1, 0.6])
def test_a_bead_is_at_the_bottom_of_a_cycloid_after_pi_root_a_over_g(part):
    """Huygens 1673."""
    a, r = 0.5, 0.02
    way = cycloid(a, 600)
    other = way[::-1] * (-1.0, 1.0) + (2.0 * math.pi * a, 0.0)
    world = world_of(moved_aside(np.concatenate([way, other[1:]]), -r))
    turn = math.pi * part
    ball = world.add_ball(
        (a * (turn - math.sin(turn)), a * (math.cos(turn) - 1.0)), r, friction=FREE_OF_FRICTION
    )
    assert world.put_down(ball, 0.05)
    before = now = float(world.balls.rows[ball, X])
    step = 0
    while now < math.pi * a:
        before = now
        world.step(DT)
        step, now = step + 1, float(world.balls.rows[ball, X])
    when = (step - (now - math.pi * a) / (now - before)) * DT
    assert when == pytest.approx(math.pi * math.sqrt(a / G), rel=3e-3)


def test_a_bead_on_a_bezier():
    """Time by quadrature of ds/v; speed at the end by the drop."""
    px, py = np.array([0.0, 0.2, 1.0, 2.0]), np.array([1.0, 0.1, 0.0, 0.3])

    def at(t, p):
        return (1 - t) ** 3 * p[0] + 3 * t * (1 - t) ** 2 * p[1] + 3 * t * t * (1 - t) * p[2] + t**3 * p[3]

    def rate(t, p):
        return 3 * ((1 - t) ** 2 * (p[1] - p[0]) + 2 * t * (1 - t) * (p[2] - p[1]) + t * t * (p[3] - p[2]))

    def pace(u):  # t = u²: the start's infinite slowness goes
        t = u * u
        return 2.0 * u * math.hypot(rate(t, px), rate(t, py)) / math.sqrt(2.0 * G * (1.0 - at(t, py)))

    exact = quad(pace, 0.0, 1.0)[0]
    r = 0.002
    t = np.linspace(0.0, 1.0, 500)
    curve = np.stack([at(t, px), at(t, py)], axis=1)
    world = world_of(curve)
    way = moved_aside(curve, r)
    ball = world.add_ball(way[0], r, friction=FREE_OF_FRICTION)
    assert world.put_down(ball, 0.01)
    before = now = float(world.balls.rows[ball, X])
    step, end, speed = 0, float(way[-1, 0]), 0.0
    while now < end and step < 1000:
        before, speed = now, float(world.balls.rows[ball, SPEED])
        world.step(DT)
        step, now = step + 1, float(world.balls.rows[ball, X])
    assert (step - (now - end) / (now - before)) * DT == pytest.approx(exact, rel=5e-3)
    assert speed == pytest.approx(math.sqrt(2.0 * G * 0.7), rel=5e-3)


def test_a_bead_passes_a_loop_from_five_halves_of_its_radius():
    """A share of next to nothing: 5/2 (R - r)."""
    limit = 2.5 * 0.9
    assert not passes_loop(200, 0.99 * limit, FREE_OF_FRICTION, 1e-6)
    assert passes_loop(200, 1.01 * limit, FREE_OF_FRICTION, 1e-6)


@pytest.mark.parametrize(("part", "leaves"), [(0.98, False), (1.02, True)])
def test_a_crest_is_left_above_a_speed(part, leaves):
    """v² = g (1/kappa + r) of the centre, kappa = A (2 pi/lambda)²."""
    height, length, r = 0.3, 4.0, 0.2
    limit = math.sqrt(G * (1.0 / (height * (2.0 * math.pi / length) ** 2) + r))
    x = np.linspace(-1.0, 3.0, 400)
    world = world_of(np.stack([x, height * np.cos(2.0 * math.pi * x / length)], axis=1))
    v = part * limit
    ball = seated(world, (0.0, height + r), r, velocity=(v, 0.0), spin=-v / r, friction=ROLLING)
    run(world, 0.02)
    assert (world.balls.pieces[ball, PIECE] == FREE) == leaves


@pytest.mark.parametrize(("turning", "count"), [(2.0 * math.pi, 100), (0.5 * math.pi, 8)])
def test_the_corners_of_a_polyline_take_what_plastic_impacts_take(turning, count):
    """(1 + 2 cos d)/3 at each concave corner, by momentum about the next contact; without gravity. Steps are
    short: a shallow corner that lies between two substeps takes nothing.
    """
    d, r, chord = turning / count, 0.1, 0.5
    turns = d * np.arange(count + 1)
    steps = chord * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    points = np.concatenate([[(-2.0, 0.0)], np.cumsum(np.concatenate([[(0.0, 0.0)], steps]), axis=0)])
    world = world_of(Curve(points, corner=0.0), gravity=(0.0, 0.0))
    ball = seated(world, (-1.0, r), r, velocity=(5.0, 0.0), spin=-5.0 / r, friction=ROLLING)
    run(world, 1.9, 1.0 / 1000.0)
    vx, vy = world.balls.rows[ball, [VX, VY]]
    passed = round(math.atan2(vy, vx) / d)
    assert passed >= min(count, 15)
    assert math.hypot(vx, vy) / 5.0 == pytest.approx(((1.0 + 2.0 * math.cos(d)) / 3.0) ** passed, rel=1e-6)


def test_a_slow_disc_leaves_the_edge_of_a_table():
    """cos = 4/7 (1 + 3 v²/(4 g r)), from next to rest: 55.147 degrees."""
    r, v = 0.1, 0.01
    world = world_of([(-3.0, 0.0), (0.0, 0.0)])
    ball = seated(world, (-0.005, r), r, velocity=(v, 0.0), spin=-v / r, friction=ROLLING)
    for _ in range(8000):
        world.step(DT / 2.0)
        if world.balls.pieces[ball, PIECE] == FREE:
            break
    x, y = world.balls.rows[ball, [X, Y]]
    exact = math.degrees(math.acos(4.0 / 7.0 * (1.0 + 3.0 * v * v / (4.0 * G * r))))
    assert math.degrees(math.atan2(x, y)) == pytest.approx(exact, abs=1.0)


def test_a_hexagon_rolls_down_a_slope_at_its_own_speed():
    """A rimless wheel (McGeer 1990) with a prism's inertia: the energy of a fall is what an impact takes."""
    n, radius, slope = 6, 0.2, math.radians(20.0)
    half = math.pi / n
    inertia = radius**2 * (2.0 + math.cos(2.0 * half)) / 6.0  # of mass 1, about its centre
    about = inertia + radius**2
    keep = (inertia + radius**2 * math.cos(2.0 * half)) / about
    gain = 2.0 * G * radius * (math.cos(slope - half) - math.cos(slope + half)) / about
    start = math.sqrt(keep**2 * gain / (1.0 - keep**2))  # spin after each impact

    def pace(theta):
        return 1.0 / math.sqrt(
            start**2 + 2.0 * G * radius * (math.cos(slope - half) - math.cos(theta)) / about
        )

    exact = 2.0 * radius * math.sin(half) / quad(pace, slope - half, slope + half)[0]
    rough = Material(friction=10.0)
    world = SolidWorld(
        SolidSettings(
            substeps=24, effects=USUAL.without(SLEEP), gravity=(G * math.sin(slope), -G * math.cos(slope))
        )
    )
    world.add_body(box(400.0, 1.0, material=rough), (100.0, -0.5), kind="fixed")
    turns = 2.0 * math.pi * (np.arange(n) + 0.5) / n - 0.5 * math.pi
    body = world.add_body(
        Polygon(radius * np.stack([np.cos(turns), np.sin(turns)], axis=1), material=rough),
        (0.0, radius * math.cos(half)),
        velocity=(1.2, 0.0),
        spin=-6.0,
    )
    for _ in range(6 * 240):
        world.step(1.0 / 240.0)
    place = float(world.bodies.positions[body, 0])
    for _ in range(6 * 240):
        world.step(1.0 / 240.0)
    assert (world.bodies.positions[body, 0] - place) / 6.0 == pytest.approx(exact, rel=0.02)
