"""Manifolds: gap and normal of two shapes nearly in contact, against the distance of their outlines."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from shapely import affinity

from game.physics.solids import Capsule, Disc, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import FIRST_POINT, GAP, NORMAL_X, NORMAL_Y, POINT_WIDTH, POINTS
from game.physics.solids.effects import CONTACTS

APART = 1e-3  # m
CORNERS = (-0.4, 0.0), (0.4, 0.1)
SHAPES = {  # each with its core, which has no rounding
    "disc": (Disc(0.3), shapely.Point(0.0, 0.0), 0.3),
    "capsule": (Capsule(*CORNERS, 0.15), shapely.LineString(CORNERS), 0.15),
    "box": (box(0.9, 0.5), shapely.box(-0.45, -0.25, 0.45, 0.25), 0.0),
    "rounded box": (box(0.7, 0.7, 0.1), shapely.box(-0.25, -0.25, 0.25, 0.25), 0.1),
}


def placed(core, place, angle):
    """A core turned about the origin and moved."""
    return affinity.translate(affinity.rotate(core, angle, origin=(0.0, 0.0), use_radians=True), *place)


@pytest.mark.parametrize("first", SHAPES)
@pytest.mark.parametrize("second", SHAPES)
def test_the_gap_is_the_distance_and_the_normal_its_direction(first, second):
    random = np.random.default_rng(1)
    (shape, core, rounding), (other, other_core, other_rounding) = SHAPES[first], SHAPES[second]
    for _ in range(8):
        turns, way = random.uniform(-math.pi, math.pi, 2), random.uniform(-math.pi, math.pi)
        middle, heading = random.uniform(-1.0, 1.0, 2), np.array([math.cos(way), math.sin(way)])
        standing = placed(core, middle, turns[0])
        near, far = 0.0, 3.0  # along the heading, until they are apart by so much
        for _ in range(60):
            there = 0.5 * (near + far)
            meets = placed(other_core, middle + there * heading, turns[1])
            apart = standing.distance(meets) - rounding - other_rounding
            near, far = (there, far) if apart < APART else (near, there)
        world = SolidWorld(SolidSettings(gravity=(0.0, 0.0), effects=CONTACTS))
        world.add_body(shape, middle, turns[0])
        world.add_body(other, middle + far * heading, turns[1])
        world.step(1e-9)
        assert world.contacts.count[0] == 1
        points = int(world.contacts.marks[0, POINTS])
        manifold = world.contacts.manifolds[0]
        assert points >= 1
        gaps = manifold[FIRST_POINT + GAP :: POINT_WIDTH][:points]
        assert gaps.min() == pytest.approx(APART, abs=1e-6)
        a = int(world.contacts.bodies[0, 0])
        turn = turns[a]
        nx, ny = manifold[NORMAL_X], manifold[NORMAL_Y]
        normal = np.array(
            [math.cos(turn) * nx - math.sin(turn) * ny, math.sin(turn) * nx + math.cos(turn) * ny]
        )
        ends = shapely.get_coordinates(shapely.shortest_line(standing, meets))
        line = (ends[1] - ends[0]) / math.dist(*ends) * (1.0 if a == 0 else -1.0)
        assert normal @ line == pytest.approx(1.0, abs=1e-3)
