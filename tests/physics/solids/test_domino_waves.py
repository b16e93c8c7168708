"""Rows of dominoes against the theory of van Leeuwen 2010: how fast the wave runs, how what fell lies."""

from __future__ import annotations

import math

import pytest

from game.physics.dominoes import domino_wave_speed
from game.physics.solids import Material, box
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, floor_world


def row_of(thickness, gap, friction, count=36):
    """A world with a row of dominoes of 1 m, whose feet do not slip, and the first one pushed."""
    world, _ = floor_world(Material(friction=100.0), effects=USUAL.without(SLEEP))
    shape = box(thickness, 1.0, material=Material(friction=friction))
    row = [world.add_body(shape, (k * (gap + thickness), 0.5)) for k in range(count)]
    world.push(row[0], (0.0, 1.0), (0.1 * thickness / 0.16, 0.0))
    return world, row


@pytest.mark.parametrize(
    ("thickness", "gap", "friction", "within"),
    [
        (0.16, 0.2, 0.2, 0.07), (0.16, 0.3, 0.2, 0.03), (0.16, 0.5, 0.2, 0.03), (0.16, 0.7, 0.2, 0.03),
        (0.16, 0.4, 0.0, 0.05), (0.16, 0.4, 0.4, 0.03), (0.10, 0.3, 0.2, 0.03), (0.25, 0.5, 0.2, 0.03),
    ],
)  # fmt: skip
def test_the_wave_is_as_fast_as_theory_has_it(thickness, gap, friction, within):
    """In sqrt(g h). Where they stand close, or rub not at all, they part in between and are a few per cent
    faster than in the theory, in which they stay in touch.
    """
    world, row = row_of(thickness, gap, friction)
    times = {}
    while len(times) < 2 and world.time < 14.0:
        world.step(1.0 / 240.0)
        for k in (14, 32):
            if k not in times and world.bodies.angles[row[k]] < -0.02:
                times[k] = world.time
    found = 18 * (gap + thickness) / (times[32] - times[14]) / math.sqrt(G)
    assert found == pytest.approx(domino_wave_speed(gap, thickness, friction), rel=within)


def test_what_fell_leans_on_the_next_by_its_geometry():
    """cos = d/(s + d) from upright."""
    world, row = row_of(0.16, 0.4, 0.2, 24)
    for _ in range(240 * 6):
        world.step(1.0 / 240.0)
    tilts = [-math.degrees(float(world.bodies.angles[k])) for k in row[4:12]]
    assert tilts == pytest.approx([math.degrees(math.acos(0.16 / 0.56))] * 8, abs=1.0)
