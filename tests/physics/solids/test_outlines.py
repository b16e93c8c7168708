"""Masses by closed forms, and drawn outlines cut into convex parts, against shapely."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from game.physics.solids import Capsule, Polygon, SolidSettings, SolidWorld, box
from game.physics.solids.mass import polygon_mass, rounded_mass
from game.physics.solids.outlines import clean_outline, convex_parts, is_convex, signed_area
from game.physics.solids.shapes import parts_mass

L_SHAPE = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)]


def star(seed, count=20):
    rng = np.random.default_rng(seed)
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return rng.uniform(0.3, 1.0, count)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def test_the_mass_of_an_l():
    found = polygon_mass(np.array(L_SHAPE, dtype=float))
    assert (found.mass, *found.centre, found.inertia) == pytest.approx((6.0, 1.0, 1.5, 12.5))
    compound = parts_mass(Polygon(L_SHAPE).parts())
    assert (compound.mass, *compound.centre, compound.inertia) == pytest.approx((6.0, 1.0, 1.5, 12.5))


def test_the_mass_of_a_capsule_and_of_rounding():
    found = parts_mass(Capsule((-0.5, 0.0), (0.5, 0.0), 0.25).parts())
    assert (found.mass, found.inertia) == pytest.approx((0.6963495408493621, 0.12813997503054975), rel=1e-12)
    square = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    rounded = rounded_mass(square, 0.5)
    assert rounded.mass == pytest.approx(4.0 + 4.0 + np.pi / 4.0)
    assert rounded.centre == pytest.approx((0.0, 0.0), abs=1e-15)


@pytest.mark.parametrize("seed", range(12))
def test_parts_are_convex_and_cover_the_outline(seed):
    outline = clean_outline("corners", star(seed)[:: 1 if seed % 2 else -1])
    parts = convex_parts(outline)
    assert all(is_convex(part) and signed_area(part) > 0.0 for part in parts)
    whole = shapely.union_all([shapely.Polygon(part) for part in parts])
    assert sum(signed_area(part) for part in parts) == pytest.approx(signed_area(outline), rel=1e-12)
    assert whole.symmetric_difference(shapely.Polygon(outline)).area < 1e-9
    assert len(parts) < len(outline) - 2


def test_a_compound_rests_on_its_feet():
    world = SolidWorld(SolidSettings())
    world.add_body(box(20.0, 1.0), (0.0, -0.5), kind="fixed")
    body = world.add_body(
        Polygon([(0, 0), (1, 0), (1, 2), (3, 2), (3, 0), (4, 0), (4, 3), (0, 3)]), (-2.0, 0.1)
    )
    for _ in range(180):
        world.step(1.0 / 60.0)
    assert world.origin(body) == pytest.approx((-2.0, 0.0), abs=5e-3)
    assert world.bodies.angles[body] == pytest.approx(0.0, abs=1e-4)
