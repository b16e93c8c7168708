"""Shots on the exact table, and the same break on the tables that step."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from game.billiards import Shot, Table, eight_ball_rack, make_shot, simulate, strike
from game.billiards.many import play_batch
from game.billiards.shot.shot import batch_of
from game.billiards.simulation import MAX_EVENTS
from game.billiards.table.rack import BALL_RADIUS
from game.lab.benchmarks.scenario import Call, Peer, Scenario

BATCH = 100


def break_shot(gap: float = 1e-4) -> Shot:
    """A break of a rack of fifteen at 8 m/s. gap: between the balls of the rack, m."""
    table = Table.pool()
    racked = eight_ball_rack(table, BALL_RADIUS, gap=gap, seed=3)
    return make_shot(table, racked).struck(0, (0.02, 8.0), (-30.0, 0.0, 0.0))


def cut_shot() -> Shot:
    """One ball cut at 3 m/s."""
    return make_shot(Table.pool(), [[0.6, 0.6], [0.62, 1.2]]).struck(0, (0.0, 3.0), (-30.0, 0.0, 0.0))


def random_shots(balls: int, count: int = BATCH) -> list[Shot]:
    """Shots among balls that lie anywhere, with any speed up to 4 m/s."""
    table, radius = Table.pool(), BALL_RADIUS
    generator = np.random.default_rng(balls)
    shots: list[Shot] = []
    while len(shots) < count:
        room = (table.width - radius, table.length - radius)
        places = generator.uniform((radius, radius), room, (balls, 2))
        apart = places[:, None] - places[None]
        gaps = np.sqrt((apart * apart).sum(axis=2)) + 9.0 * np.eye(balls)
        if gaps.min() > 2.0 * radius:
            speed, azimuth = generator.uniform(0.5, 4.0), generator.uniform(0.0, 2.0 * math.pi)
            stroke = strike(speed, azimuth, 0.0, *generator.uniform(-0.3, 0.3, 2))
            shots.append(make_shot(table, places).struck(0, stroke.velocity, stroke.spin))
    return shots


def _batch(make: Callable[[], list[Shot]]) -> Call:
    batch = batch_of(make())
    return lambda: play_batch(batch, math.inf, MAX_EVENTS)


def _break(model: str) -> Call:
    shot = break_shot()
    return lambda: simulate(shot, model=model)


SCENARIOS = (
    Scenario(
        "break", "Break of 16 balls, to the end", "shot", partial(_break, "exact"),
        peers=(Peer("stepped at 1/240 s", partial(_break, "stepped")),),
    ),
    Scenario(
        "cut", "Cut of one ball, in a batch", "shot", partial(_batch, lambda: [cut_shot()] * BATCH), BATCH
    ),
    *(
        Scenario(
            f"random-{n}", f"Random shots, {n} balls, in a batch", "shot",
            partial(_batch, partial(random_shots, n)), BATCH,
        )
        for n in (2, 5, 9, 16)
    ),
)  # fmt: skip
