"""Random heaps, and how much energy any step of them gains: for the test of a few, and by hand for many.

python -m tests.physics.solids.random_scenes 10000 --log heaps.log

runs them in pieces, a line of the log for each; begun again, it goes on behind the last line. A heap that
raises, leaves numbers that are not finite, or gains above GAINS_TOO_MUCH has a line of its own.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import NamedTuple

import numpy as np

from game.physics.solids import Capsule, Disc, Material, Polygon, box
from tests.physics.solids.setups import floor_world

FRAME = 1.0 / 60.0
PIECE = 100  # heaps
GAINS_TOO_MUCH = 1e-9  # of a heap's energy in a step


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


def piece(first, last):
    """What came of the heaps first to last - 1, to be written down."""
    gains, wrong = [], []
    for seed in range(first, last):
        try:
            gains.append(largest_gain(seed))
        except (ArithmeticError, AssertionError, ValueError) as error:
            wrong.append({"seed": seed, "raised": repr(error)})
    worst = max(gains, default=Worst(-1.0, first, 0))
    wrong += [gain._asdict() for gain in gains if gain.gain > GAINS_TOO_MUCH]
    above = {f"above {bound:g}": sum(gain.gain > bound for gain in gains) for bound in (1e-12, 1e-10, 1e-9)}
    return {"first": first, "last": last, "worst": worst._asdict(), **above, "wrong": wrong}


def main(count, log):
    """Run what the log does not tell of yet, up to so many heaps, and say what came of all."""
    told = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
    for first in range(told[-1]["last"] if told else 0, count, PIECE):
        told.append(piece(first, min(first + PIECE, count)))
        with log.open("a") as file:
            print(json.dumps(told[-1]), file=file)
    print("heaps:", told[-1]["last"] if told else 0)
    print("worst:", max((part["worst"] for part in told), key=lambda worst: worst["gain"], default=None))
    print("wrong:", [found for part in told for found in part["wrong"]])


if __name__ == "__main__":
    given = argparse.ArgumentParser()
    given.add_argument("count", type=int)
    given.add_argument("--log", type=Path, required=True)
    main(**vars(given.parse_args()))
