"""Pairs and manifolds beside their naive twins: every pair looked at, areas by another library."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import affinity, geometry

from game.physics.solids import Polygon, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import FIRST_POINT, GAP, NORMAL_X, POINT_WIDTH, POINTS


def scattered(seed):
    """30 convex polygons that overlap here and there, and their outlines."""
    rng = np.random.default_rng(seed)
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    for _ in range(30):
        angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, rng.integers(4, 9)))
        corners = rng.uniform(0.4, 1.0) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        world.add_body(Polygon(corners), rng.uniform(0.0, 5.0, 2), rng.uniform(0.0, 6.0))
    world.step(1e-9)
    shapes = [int(world.shapes_of(body)[0]) for body in world.ids().tolist()]
    return world, [geometry.Polygon(world.corners(shape)) for shape in shapes]


@pytest.mark.parametrize("seed", range(8))
def test_all_that_overlap_are_found_and_a_push_along_the_normal_parts_them(seed):
    world, outlines = scattered(seed)
    contacts = world.contacts
    known = {tuple(sorted(pair)): p for p, pair in enumerate(contacts.bodies.tolist())}
    deep = 0
    for i in range(len(outlines)):
        for j in range(i):
            area = outlines[i].intersection(outlines[j]).area
            if area == 0.0:
                continue
            assert (j, i) in known
            p = known[j, i]
            if area < 1e-3:  # a sliver may be left alone
                continue
            deep += 1
            points = int(contacts.marks[p, POINTS])
            assert points > 0
            a, b = contacts.bodies[p].tolist()
            kept = contacts.manifolds[p]
            gap = min(kept[FIRST_POINT + k * POINT_WIDTH + GAP] for k in range(points))
            c, s = world.bodies.rotations[a].tolist()
            x, y = kept[NORMAL_X : NORMAL_X + 2].tolist()
            normal = np.array([c * x - s * y, s * x + c * y])
            for part, parted in ((1.001, True), (0.9, False)):
                moved = affinity.translate(outlines[b], *(-part * gap * normal))
                assert (outlines[a].intersection(moved).area < 1e-9) == parted
    assert deep > 20


@pytest.mark.parametrize("turns", [(0.05, -0.05), (-0.08, 0.0), (0.0, 0.08), (0.06, 0.02)])
def test_what_is_kept_of_a_pair_is_forgotten_when_its_bodies_turn_against_each_other(turns):
    """The middle of the second is led round with the first: seen from there only the angle changes."""

    def pair(turn_a, turn_b):
        c, s = np.cos(turn_a), np.sin(turn_a)
        return ((0.0, 0.0), turn_a), ((0.98 * -s, 0.98 * c), turn_b)

    def gaps(poses):
        world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
        for position, angle in poses[0]:
            world.add_body(box(1.0, 1.0), position, angle)
        for pose in poses:
            for body, (position, angle) in enumerate(pose):
                rows = world.bodies
                rows.velocities[body], rows.spins[body] = 0.0, 0.0
                rows.positions[body], rows.angles[body] = position, angle
                rows.rotations[body] = np.cos(angle), np.sin(angle)
            world.step(1e-9)
        kept = world.contacts.manifolds[0, FIRST_POINT:]
        return np.array([kept[k * POINT_WIDTH + GAP] for k in range(world.contacts.marks[0, POINTS])])

    still, turned = pair(0.0, 0.0), pair(*turns)
    np.testing.assert_allclose(gaps([still, turned]), gaps([turned]), atol=1e-6)
    assert gaps([turned]).min() < gaps([still]).min() - 0.015
