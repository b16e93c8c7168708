"""Time of the lecture table's step, and of what stands beside it. Nothing here fails on a slow machine."""

from __future__ import annotations

import numpy as np
import pytest

from game.billiards.laws.joint import ContactGraph, joint_scratch, solve_joint_impulses
from game.billiards.lecture.settings import lecture_settings
from game.billiards.lecture.state import LECTURE_EFFECTS
from game.billiards.lecture.table import LectureTable
from game.billiards.table.rack import BALL_RADIUS, eight_ball_rack
from game.billiards.table.table import Table

FRAME = 1.0 / 60.0
LOSSLESS = {"bounce": 1.0, "restitution": 1.0, "friction": 1.0, "minimum_speed": 0.0}


def spread_balls(speed: float, order: str, effects=LECTURE_EFFECTS) -> LectureTable:
    """Sixteen balls all over the table, moving at about `speed`."""
    rng = np.random.default_rng(0)
    positions = [[0.15 + 0.3 * (k % 4), 0.3 + 0.6 * (k // 4)] for k in range(16)]
    velocities = speed * rng.normal(size=(16, 2))
    settings = lecture_settings(**LOSSLESS, order=order)
    return LectureTable(Table.pool(), positions, velocities=velocities, effects=effects, settings=settings)


def timed_step(benchmark, balls: LectureTable, steps: int = 1) -> None:
    """Time one call from the same state each round."""
    start = [array.copy() for array in balls.state]

    def back():
        for array, then in zip(balls.state, start, strict=True):
            array[...] = then
        return (FRAME, steps), {}

    benchmark.pedantic(balls.step, setup=back, rounds=300, warmup_rounds=5)
    assert balls.not_finite == -1


@pytest.mark.parametrize("order", ["joint", "pairwise"])
@pytest.mark.parametrize("speed", [0.0, 0.3, 1.0, 4.0])
def test_step_of_sixteen_balls(benchmark, speed, order):
    timed_step(benchmark, spread_balls(speed, order))


@pytest.mark.parametrize("without", [effect.name for effect in LECTURE_EFFECTS])
def test_step_without_an_effect(benchmark, without):
    timed_step(benchmark, spread_balls(1.0, "joint", LECTURE_EFFECTS.without(without)))


def test_frame_of_the_break(benchmark):
    balls = LectureTable(Table.pool(), eight_ball_rack(Table.pool()))
    balls.strike(0, (0.0, 8.0))
    while not balls.events:
        start = [array.copy() for array in balls.state]
        balls.step(FRAME)
    for array, then in zip(balls.state, start, strict=True):
        array[...] = then
    timed_step(benchmark, balls)


def test_whole_break_in_one_call(benchmark):
    """Six seconds from the stroke on."""
    balls = LectureTable(Table.pool(), eight_ball_rack(Table.pool()))
    balls.strike(0, (0.3, 8.0))
    timed_step(benchmark, balls, 360)


@pytest.mark.parametrize("join_resting", [False, True])
def test_joint_impulses_of_a_touching_rack(benchmark, join_resting):
    positions = eight_ball_rack(Table.pool())
    positions[0] = positions[1] - [0.0, 2.0 * BALL_RADIUS]
    pairs = [(a, b) for a in range(16) for b in range(a + 1, 16)]
    apart = {pair: positions[pair[1]] - positions[pair[0]] for pair in pairs}
    touching = [pair for pair in pairs if np.linalg.norm(apart[pair]) < 2.0 * BALL_RADIUS + 1e-9]
    first, second = np.array(touching).T.copy()
    normals = np.array([apart[pair] / np.linalg.norm(apart[pair]) for pair in touching])
    scratch, count = joint_scratch(16, len(touching)), len(touching)
    velocities, impulses = np.zeros((16, 2)), np.zeros(count)

    def solve():
        velocities[:] = 0.0
        velocities[0, 1] = 8.0
        return solve_joint_impulses(
            count,
            ContactGraph(first, second, normals),
            np.full(count, 0.95),
            np.full(16, 6.0),
            velocities,
            impulses,
            join_resting,
            scratch,
        )

    assert benchmark(solve) >= 1
