"""Additive light: as strong as told, wherever between pixels; never past the clip or the brightest pixel."""

import math

import numpy as np
import pytest

from game.compiler.decorator import kernel
from game.ui.raster.additions import _add_between_plainly, _add_four_plainly, add_between, add_four
from game.ui.raster.glow import CELL, Bloom, add_lights, dither_grain, gather_glows, gather_lights, stamps_of
from game.ui.raster.water import mirror_rows, wave_table
from tests.ui.raster.paper import Paper

BLACK = 0xFF000000


@kernel
def add_four_here(pixels, position, weights, first, color):
    add_four(pixels, position, weights, first, color)


@kernel
def add_between_here(pixels, position, line, cell, grain, row):
    add_between(pixels, position, line, cell, grain, row)


@pytest.mark.compiled
def test_vector_instructions_do_what_plain_code_does():
    chance = np.random.default_rng(3)
    for _ in range(50):
        pixels = chance.integers(0, 2**32, 12).astype(np.uint32)
        weights = np.repeat(chance.integers(0, 257, 8), 4).astype(np.uint16)
        color, plain = int(chance.integers(0, 2**24)), pixels.copy()
        add_four_here(pixels, 3, weights, 16, color)
        _add_four_plainly(plain, 3, weights, 16, color)
        assert (pixels == plain).all()
        line = chance.integers(0, 8161, 12).astype(np.uint16)
        add_between_here(pixels, 5, line, 1, dither_grain(), 32)
        _add_between_plainly(plain, 5, line, 1, dither_grain(), 32)
        assert (pixels == plain).all()


def lights(paper, points, color=0x808080, radius=3.0):
    points = np.array(points, float).reshape(-1, 2)
    n = len(points)
    add_lights(
        paper.pixels, paper.pixels.reshape(-1), paper.clip, points, np.full(n, color, np.uint32),
        np.zeros(n, np.uint8), *stamps_of((radius,)),
    )  # fmt: skip


@pytest.mark.parametrize("radius", [1.5, 2.0, 3.7, 5.0, 7.5])
def test_a_light_is_as_strong_wherever_it_is(radius):
    """The integral of (1 - r²/R²)² is pi R²/3."""
    for x, y in ((20.0, 15.0), (20.4, 15.7), (19.1, 14.05)):
        paper = Paper()
        lights(paper, [(x, y)], radius=radius)
        assert paper.coverage.sum() == pytest.approx(math.pi * radius**2 / 3.0 * 128 / 255, rel=0.08)
        across, down = np.arange(40) + 0.5, np.arange(30) + 0.5
        total = paper.coverage.sum()
        assert (paper.coverage.sum(0) * across).sum() / total == pytest.approx(x, abs=0.1)
        assert (paper.coverage.sum(1) * down).sum() / total == pytest.approx(y, abs=0.1)


def test_light_adds_up_and_ends_at_white():
    paper = Paper()
    for _ in range(3):
        lights(paper, [(20.5, 15.5)], 0x203040)
    assert paper.pixels[15, 20] & 0xFFFFFF == pytest.approx(0x6090C0, abs=0x030303)
    for _ in range(40):
        lights(paper, [(20.5, 15.5)], 0x203040)
    assert paper.pixels[15, 20] == 0xFFFFFFFF


def test_stays_inside_the_clip_and_bears_anything():
    paper = Paper(clip=(5, 4, 30, 20))
    chance = np.random.default_rng(1)
    lights(paper, chance.uniform(-10.0, 50.0, (400, 2)), radius=7.5)
    lights(paper, [(math.nan, 3.0), (math.inf, 4.0), (1e300, -1e300), (5.0, math.nan)])
    assert paper.untouched_outside() and paper.coverage.any()


def test_stamps_of_absurd_sizes_are_refused():
    for radius in (0.0, -1.0, math.nan, 9.0):
        with pytest.raises(ValueError, match="radius"):
            stamps_of((radius,))


def test_bloom_spreads_light_round_its_place_and_is_dark_after():
    paper, bloom = Paper(160, 120), Bloom()
    bloom.fit(160, 120)
    point, share = np.array([(80.0, 60.0)]), np.array([8.0])
    gather_lights(bloom.light, 0.0, 0.0, point, np.array([0xFFFFFF], np.uint32), share)
    assert bloom.light[60 // CELL, 4 * (80 // CELL)] == 8.0 * 255.0
    bloom.shine(paper.pixels, paper.clip, 1.0, 0.6)
    light = paper.coverage
    assert not bloom.light.any()
    assert np.unravel_index(light.argmax(), light.shape) == pytest.approx((60, 80), abs=2)
    assert light[60, 80] > light[60, 100] > light[60, 130] >= 0.0
    assert light.sum() == pytest.approx(8.0 * CELL * CELL, rel=0.1)  # nothing is made or lost


def test_a_soft_glow_has_its_radius():
    paper, bloom = Paper(160, 120), Bloom()
    bloom.fit(160, 120)
    gather_glows(
        bloom.light, 0.0, 0.0, np.array([(80.0, 60.0), (math.nan, 0.0)]), np.array([24.0, 5.0]),
        np.array([0x00FF00, 0xFFFFFF], np.uint32), np.array([0.5, 1.0]),
    )  # fmt: skip
    bloom.shine(paper.pixels, paper.clip, 1.0, 0.0)
    green = (paper.pixels >> 8) & 255
    assert green[60, 80] == pytest.approx(127, abs=4) and green[60, 106] == 0 and green[30, 80] == 0
    assert green[60, 92] == pytest.approx(127 * 0.75**2, abs=6)
    assert not (paper.pixels & 0xFF00FF).any()


def test_bloom_fills_pictures_that_are_no_multiple_of_a_cell():
    paper, bloom = Paper(43, 30, clip=(2, 1, 41, 28)), Bloom()
    bloom.fit(39, 27)
    gather_glows(
        bloom.light, 2.0, 1.0, np.array([(40.0, 14.0)]), np.array([60.0]), np.array([0xFFFFFF], np.uint32),
        np.array([0.4]),
    )  # fmt: skip
    bloom.shine(paper.pixels, paper.clip, 1.0, 0.3)
    assert (paper.pixels[1:28, 2:41] & 0xFF > 10).all() and paper.untouched_outside()


def test_water_mirrors_what_is_above_and_changes_nothing_there():
    paper = Paper(60, 60)
    paper.pixels[:, :] = BLACK
    paper.pixels[20:24, :] = 0xFFFFFFFF
    above = paper.pixels[:40].copy()
    mirror_rows(paper.pixels, paper.clip, 40.0, 2.0, wave_table(), 1.5, 0x000040, 0.8)
    assert (paper.pixels[:40] == above).all()
    bright = ((paper.pixels[40:] >> 8) & 255).mean(axis=1)
    assert np.average(np.arange(20), weights=bright) == pytest.approx(8.5, abs=2.5)  # 17 above, squeezed by 2
    assert (paper.pixels[45:] & 255).min() > 0  # its own blue
    mirror_rows(paper.pixels, paper.clip, math.nan, 2.0, wave_table(), 1.5, 0, 0.8)
    mirror_rows(paper.pixels, paper.clip, -30.0, 2.0, wave_table(), 1.5, 0x000040, 0.8)
    assert ((paper.pixels >> 8) & 0xFF).max() == 0  # all water, with nothing to mirror
