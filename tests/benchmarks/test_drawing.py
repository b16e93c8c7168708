"""What drawing costs: figures for a person, and ratios to plain numpy that hold on any machine."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.billiards.table.table import Table
from game.lab.timing import least_time
from game.ui.look.theme import DARK, FELT
from game.ui.painters.ball import BallPainter, ScreenBalls
from game.ui.painters.ball_picture import ball_picture, turned
from game.ui.painters.cue import draw_cue
from game.ui.painters.table import fit_table, table_picture
from game.ui.raster import BUTT, fill_particle_streaks, fill_particles, stroke_segments

SIZE = (1280, 720)
PARTICLES = 100_000


@pytest.fixture
def paper():
    return np.zeros(SIZE[::-1], np.uint32), np.array((0, 0, *SIZE), np.int64)


@pytest.fixture
def particles():
    rng = np.random.default_rng(1)
    points = rng.uniform((0, 48), (960, 560), (PARTICLES, 2))
    return (
        points,
        rng.normal(0.0, 300.0, (PARTICLES, 2)),
        rng.integers(0, 1 << 24, PARTICLES).astype(np.uint32),
    )


@pytest.fixture
def balls():
    rng = np.random.default_rng(2)
    turns = np.array([turned(*rng.normal(0.0, 2.0, 3)) for _ in range(16)])
    return ScreenBalls(rng.uniform((130, 110), (1150, 610), (16, 2)), np.full(16, 11.5), np.arange(16), turns)


@pytest.fixture
def timed(request):
    """Asks for a run that measures: beside other work a ratio of costs is that of shared caches, too."""
    if not request.config.getoption("benchmark_enable"):
        pytest.skip("measures only with --benchmark-enable")


@pytest.mark.parametrize("radius", [1.15, 2.0])
def test_particles(paper, particles, benchmark, radius):
    points, _, colors = particles
    benchmark.pedantic(fill_particles, (*paper, points, colors, radius, 1.0), rounds=40, warmup_rounds=3)
    assert (paper[0] != 0).mean() > 0.3


def test_streaks_of_a_fountain(paper, particles, benchmark):
    points, trails, colors = (array[:12_000].copy() for array in particles)
    arguments = (*paper, points, trails, colors, 1.15, 0.017, 1.0)
    benchmark.pedantic(fill_particle_streaks, arguments, rounds=40, warmup_rounds=3)
    assert (paper[0] != 0).mean() > 0.05


def test_many_segments(paper, particles, benchmark):
    start = particles[0][:5_000]
    segments = np.hstack([start, start + 10.0])
    colors = np.full(5_000, 0xFFFFFF, np.uint32)
    benchmark.pedantic(
        stroke_segments, (*paper, segments, 1.5, BUTT, colors, 1.0), rounds=20, warmup_rounds=2
    )
    assert (paper[0] != 0).mean() > 0.02


def test_sixteen_balls(paper, balls, benchmark):
    painter = BallPainter(FELT)
    benchmark.pedantic(painter.draw, (*paper, balls, (640.0, 360.0), 403.0), rounds=60, warmup_rounds=3)
    assert (paper[0] != 0).mean() > 0.005


@pytest.mark.parametrize("size", [SIZE, (1920, 1080)])
def test_table(benchmark, size):
    table = Table.pool()
    view = fit_table(pygame.Rect(80, 56, size[0] - 160, size[1] - 112), table)
    made = benchmark.pedantic(table_picture, (size, table, view, DARK), rounds=5, warmup_rounds=1)
    assert made.get_size() == size


def test_cue(paper, benchmark):
    arguments = (*paper, (668.0, 293.0), (-583.0, 102.5), 403.0, 0.1, (640.0, 360.0))
    benchmark.pedantic(draw_cue, arguments, rounds=40, warmup_rounds=3)
    assert (paper[0] != 0).mean() > 0.002


def test_balls_are_drawn_many_times_faster_than_by_numpy(paper, balls, timed):
    painter = BallPainter(FELT)
    kernel = least_time(lambda: painter.draw(*paper, balls, (640.0, 360.0), 403.0))
    pairs = list(zip(balls.numbers, balls.turns, strict=True))
    numpy = least_time(lambda: [ball_picture(int(n), 11.5, t, FELT) for n, t in pairs], 5)
    assert kernel < numpy / 5.0


def test_a_particle_costs_no_more_than_a_dozen_plain_pixels(paper, particles, timed):
    """An anti-aliased disc covers 8 pixels; numpy sets one pixel of each particle."""
    points, _, colors = particles

    def plain():
        columns, rows = points.astype(np.int64).T
        paper[0][rows, columns] = colors

    assert least_time(lambda: fill_particles(*paper, points, colors, 1.15, 1.0)) < 12.0 * least_time(plain)
