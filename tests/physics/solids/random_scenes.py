"""Random heaps, and how much energy any step of them gains: for the test of a few, and by hand for many.

python -m tests.physics.solids.random_scenes 10000
"""

from __future__ import annotations

import sys
from typing import NamedTuple

import numpy as np

from game.physics.solids import Capsule, Disc, Material, Polygon, box
from tests.physics.solids.setups import floor_world

FRAME = 1.0 / 60.0


class Worst(NamedTuple):
    """The step that gained most, as part of the scene's energy at its start."""

    gain: float
    seed: int
    step: int


def heap(seed, **settings):
    """24 bodies of all shapes above a floor, apart from each other, thrown and spinning."""
    rng = np.random.default_rng(seed)
    restitution = float(rng.choice([0.0, 0.0, 0.5, 1.0]))
    material = Material(friction=float(rng.uniform(0.0, 1.0)), restitution=restitution)
    world, _ = floor_world(material, **settings)
    for k in range(24):
        size = 10.0 ** rng.uniform(-0.6, 0.0)
        angles = np.sort(rng.uniform(0, 2 * np.pi, 7))
        corners = 0.5 * size * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        shape = (
            box(size, size * rng.uniform(0.2, 1.0), material=material),
            Disc(0.5 * size, material=material),
            Capsule((-0.3 * size, 0.0), (0.3 * size, 0.0), 0.2 * size, material=material),
            Polygon(corners, material=material),
        )[k % 4]
        place = (1.6 * (k % 6) + rng.uniform(-0.1, 0.1), 1.0 + 1.6 * (k // 6))
        world.add_body(shape, place, rng.uniform(0, 6), rng.uniform(-3.0, 3.0, 2), rng.uniform(-5, 5))
    return world


def largest_gain(seed, steps=180, **settings):
    """`Worst` of one scene."""
    world = heap(seed, **settings)
    start = before = world.energy().total
    worst = Worst(-1.0, seed, 0)
    for step in range(steps):
        world.step(FRAME)
        now = world.energy().total
        worst = max(worst, Worst((now - before) / start, seed, step))
        before = now
    world.check()
    assert before < start
    return worst


def main(count):
    """Print the worst of so many scenes, and the share of steps' gains above some bounds."""
    gains = [largest_gain(seed) for seed in range(count)]
    print("worst:", max(gains))
    for bound in (1e-5, 1e-4, 1e-3):
        print(f"scenes with a step that gains more than {bound:g}:", sum(g.gain > bound for g in gains))


if __name__ == "__main__":
    main(int(sys.argv[1]))
