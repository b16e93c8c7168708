"""Cases that break rigid body solvers: columns, pyramids, mass ratios, deep overlap, ties, and random
scenes.
"""

from __future__ import annotations

import math

import pytest

from game.physics.solids import (
    Disc,
    Material,
    NotFiniteError,
    Polygon,
    SolidSettings,
    SolidWorld,
    box,
)
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, column, energy, floor_world, run

AWAKE = USUAL.without(SLEEP)


def test_a_pyramid_keeps_its_shape_and_sinks_with_the_square_of_the_frequency():
    sinks = []
    for substeps in (4, 12):
        world, _ = floor_world(substeps=substeps, effects=AWAKE)
        rows = 20
        for r in range(rows):
            for k in range(rows - r):
                top = world.add_body(box(1.0, 1.0), (k - 0.5 * (rows - r - 1), 0.5 + r))
        run(world, 5.0)
        assert abs(world.bodies.positions[top, 0]) < 0.02
        sinks.append(rows - 0.5 - world.bodies.positions[top, 1])
    assert sinks[0] / sinks[1] == pytest.approx(9.0, rel=0.05)


@pytest.mark.parametrize(("substeps", "most"), [(8, 0.5), (32, 0.1)])
def test_a_thousand_times_heavier_box_on_ten_sinks_less_with_more_substeps(substeps, most):
    world, _ = floor_world(substeps=substeps, contact_hertz=15.0 * substeps)
    column(world, 10)
    heavy = world.add_body(box(1.0, 1.0, material=Material(density=1000.0)), (0.0, 10.5))
    run(world, 5.0)
    assert abs(world.bodies.positions[heavy, 0]) < 0.5
    assert 10.5 - world.bodies.positions[heavy, 1] < most


@pytest.mark.parametrize(("part", "slides"), [(0.98, True), (1.02, False)])
def test_a_box_on_a_slope_at_the_limit_of_friction(part, slides):
    mu = part * math.tan(math.radians(25.0))
    world, _ = floor_world(Material(friction=mu), 25.0, substeps=8)
    body = world.add_body(box(1.0, 1.0, material=Material(friction=mu)), (0.0, 0.5))
    run(world, 1.0)
    start = world.bodies.positions[body, 0]
    run(world, 5.0)
    gone = world.bodies.positions[body, 0] - start
    if slides:
        pull = 0.02 * G * math.sin(math.radians(25.0))
        assert gone == pytest.approx(0.5 * pull * (36.0 - 1.0), rel=0.03)
    else:
        assert abs(gone) < 1e-3


@pytest.mark.parametrize(("degrees", "topples"), [(26.0, False), (27.2, True)])
def test_a_tall_box_topples_beyond_its_angle(degrees, topples):
    """b/h = 1/2, so 26.565 degrees, with friction enough."""
    world, _ = floor_world(Material(friction=0.8), degrees, substeps=12)
    body = world.add_body(box(1.0, 2.0, material=Material(friction=0.8)), (0.0, 1.0))
    run(world, 8.0)
    assert (abs(world.bodies.angles[body]) > 0.5) == topples


def test_a_low_box_slides_and_does_not_topple_on_any_slope():
    world, _ = floor_world(Material(friction=0.25), 40.0)
    body = world.add_body(box(1.0, 3.0, material=Material(friction=0.25)), (0.0, 1.5))
    run(world, 1.0)
    assert abs(world.bodies.angles[body]) < 0.01
    assert world.bodies.positions[body, 0] > 1.0


def test_corner_on_corner_falls_to_either_side_without_nan():
    for number in range(40):
        world, _ = floor_world(effects=AWAKE)
        world.add_body(box(1.0, 1.0), (0.0, 0.5))
        body = world.add_body(
            box(1.0, 1.0), (1.0 + (number - 20) * 1e-6, 1.5 + math.sqrt(0.5) - 0.5), math.pi / 4
        )
        before = energy(world)
        for _ in range(60):
            world.step(1.0 / 60.0)
            now = energy(world)
            assert now <= before + 1e-3, number  # J of 14: what the springs of contacts give back
            before = now
        assert world.bodies.positions[body, 1] < 1.4


def test_far_away_and_mirrored_it_is_the_same():
    def scene(x, sign):
        world = SolidWorld(SolidSettings(substeps=4))
        world.add_body(box(50.0, 1.0), (x, -0.5), kind="fixed")
        for k in range(6):
            world.add_body(box(1.0, 0.5), (x + sign * 0.13 * k, 0.3 + 0.7 * k), sign * 0.1 * k)
        run(world, 1.0)
        return world.bodies.positions - (x, 0.0)

    near, far, mirrored = scene(0.0, 1.0), scene(1e5, 1.0), scene(0.0, -1.0)
    assert far == pytest.approx(near, abs=1e-6)
    assert mirrored * (-1.0, 1.0) == pytest.approx(near, abs=0.02)  # contacts are solved in turn


def test_a_small_box_rests_on_large_ground_and_a_sliver_is_finite():
    world = SolidWorld(SolidSettings())
    world.add_body(box(100.0, 1.0), (0.0, -0.5), kind="fixed")
    small = world.add_body(box(1e-3, 1e-3), (0.3, 6e-4))
    sliver = world.add_body(box(1.0, 1e-3), (5.0, 0.2), 0.3)
    run(world, 2.0)
    assert world.bodies.positions[small, 1] == pytest.approx(5e-4, abs=1e-4)
    assert world.bodies.positions[sliver, 1] == pytest.approx(5e-4, abs=1e-3)


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda w: w.add_body(Disc(-1.0)), "radius"),
        (lambda w: w.add_body(Disc(math.nan)), "radius"),
        (lambda w: w.add_body(box(1.0, 0.0)), "height"),
        (lambda w: w.add_body(Polygon([(0, 0), (1, 0)])), "corners"),
        (lambda w: w.add_body(Polygon([(0, 0), (1, 0), (2, 0)])), "corners"),
        (lambda w: w.add_body(Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])), "corners"),
        (lambda w: w.add_body(Disc(1.0), (math.inf, 0.0)), "position"),
        (lambda w: w.add_body(Disc(1.0), kind="loose"), "kind"),
        (lambda w: w.add_body(Disc(1e-300)), "shapes|radius"),
        (lambda w: w.add_body([]), "shapes"),
        (lambda w: Material(density=0.0), "density"),
        (lambda w: Material(friction=-1.0), "friction"),
        (lambda w: w.step(0.0), "dt"),
        (lambda w: w.step(math.nan), "dt"),
        (lambda w: w.add_joint("pin", 0, 0, (0.0, 0.0)), "body_b"),
        (lambda w: w.remove_body(7), "body 7"),
        (lambda w: SolidSettings(substeps=0), "substeps"),
        (lambda w: w.set(solver="magic"), "solver"),
        (lambda w: w.set(gravity=(math.nan, 0.0)), "gravity"),
    ],
)
def test_nonsense_is_answered_by_one_line_that_names_the_field(build, message):
    world, _ = floor_world()
    with pytest.raises(ValueError, match=message) as caught:
        build(world)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("quantity", ["positions", "angles", "velocities", "spins"])
def test_a_number_that_is_none_is_found_in_that_step_and_named(quantity):
    world, _ = floor_world()
    bodies = column(world, 3)
    run(world, 0.1)
    getattr(world.bodies, quantity)[bodies[1]] = math.nan
    with pytest.raises(NotFiniteError, match=rf"body {bodies[1]}: \w+ not finite after step 7"):
        world.step(1.0 / 60.0)
