"""The painted sea: slopes of short waves, shares of foam, places of pixels; the two weathers of a sky."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.waves.sea import Sea
from game.worlds.painting import clouds
from game.worlds.painting.sea import cuts as sea
from game.worlds.painting.sea.painter import SeaPainter, Water
from game.worlds.painting.sea.ripples import (
    CELLS,
    FINE_SHARE,
    SIDE,
    UNIT,
    Ripples,
    is_short,
    mean_square_slope,
)

LIGHT = sea.Light((8.0, 52.0, 84.0), (38.0, 138.0, 140.0), (255.0,) * 3, (250.0,) * 3, (0.2, 0.2, 0.96), 1.0)


def test_a_short_wave_stands_in_the_tile_as_it_is():
    high, k = 0.02, math.tau / SIDE * np.array((5.0, -3.0))
    rows = np.array([[high, *k, 2.0, 0.7]])
    ripples = Ripples()
    ripples.make(np.zeros((0, 5)), (0.0, 0.0), 0.0, 0.0)
    without = ripples.tiles[0].astype(float)
    ripples.make(rows, (0.0, 0.0), 0.0, 0.0)
    at = np.arange(CELLS) * SIDE / CELLS
    slope = -high * np.sin(k[0] * at[:, None] + k[1] * at[None, :] + 0.7)
    for c in range(2):
        found = UNIT * (ripples.tiles[0, :, :, c] - without[:, :, c])
        assert found == pytest.approx(k[c] * slope, abs=4.0 * UNIT)


def test_the_finest_waves_are_as_steep_as_the_wind_makes_them():
    ripples, steep = Ripples(), []
    for wind in (4.0, 12.0):
        ripples.make(np.zeros((0, 5)), (0.0, wind), 3.0, 5.0)
        assert ripples.rough[-1] == pytest.approx(FINE_SHARE * mean_square_slope(wind), rel=0.05)
        assert (np.diff(ripples.rough) > 0.0).all()
        steep.append(UNIT * ripples.tiles[0])
    # steeper along the wind than across it, as Cox and Munk found
    assert np.std(steep[1][:, :, 1]) > 1.2 * np.std(steep[1][:, :, 0])


def test_as_much_is_white_as_the_wind_says():
    water = Sea(96, 0.5, seed=3)
    rows = water.rows
    rows[:, 0] = water.goals("pierson-moskowitz", 18.0, 1e5)
    least, most, _ = sea.crests_of(rows, 18.0, 9.81)
    random = np.random.default_rng(1)
    lift = water_lift(rows[~is_short(rows)], random.uniform(-400.0, 400.0, (4000, 2)))
    white = np.clip((lift - least) / (most - least), 0.0, 1.0)
    assert float(np.mean(white)) == pytest.approx(sea.whitecaps(18.0), rel=0.4)


def water_lift(rows, points):
    """Downward accelerations over gravity."""
    phases = points @ rows[:, 1:3].T + rows[:, 4]
    return np.cos(phases) @ (rows[:, 0] * rows[:, 3] ** 2) / 9.81


def painted(every: int, wake: sea.Wake = sea.NO_WAKE):
    """Pixels of a breeze before and behind the plane."""

    class Paper:
        raster_target = np.zeros((90, 160), np.uint32), np.array((0, 0, 160, 90), np.int64)
        pixels_per_unit = 6.0

        class camera:  # noqa: N801
            @staticmethod
            def visible():
                return type("seen", (), {"left": -13.3, "right": 13.4, "bottom": -4.0, "top": 11.0})

        @staticmethod
        def place(at):
            return 80.0 + 6.0 * at[0], 66.0 - 6.0 * at[1]

    water = Sea(32, 0.5, seed=3)
    water.rows[:, 0] = water.goals("jonswap", 8.0, 25_000.0)
    painter = SeaPainter(every)
    painter.ripples.make(water.rows, (8.0, 0.0), 0.0, 0.0)
    sky = np.linspace((240.0, 170.0, 100.0), (40.0, 50.0, 90.0), 32)
    for near in (False, True):
        painter.paint(Paper, Water(water.rows, LIGHT, sky, 9.81, 8.0, np.zeros(2), wake=wake), near)
    return Paper.raster_target[0]


def test_pixels_are_painted_up_to_the_horizon_and_a_column_left_out_is_between():
    whole, half = painted(1), painted(2)
    horizon = round(66.0 - 6.0 * sea.HORIZON)
    assert (whole[horizon + 3 :] != 0).all() and (half[horizon + 3 :] != 0).all()
    assert not whole[: horizon - 4].any()
    assert (half[:, ::2] == whole[:, ::2]).mean() > 0.99
    red = half[horizon + 6 :] >> 16 & 255
    low, high = np.minimum(red[:, 0:-2:2], red[:, 2::2]), np.maximum(red[:, 0:-2:2], red[:, 2::2])
    assert ((low <= red[:, 1:-1:2]) & (red[:, 1:-1:2] <= high)).all()


def test_a_boat_leaves_foam_astern_and_none_ahead():
    fast = sea.Wake(-3.0, 3.0, 1.3, 3.0, 0.1)
    changed = np.abs((painted(1, fast) >> 16 & 255).astype(int) - (painted(1) >> 16 & 255))
    assert changed[60:75, 8:56].mean() > 4.0 * changed[60:75, 110:].mean() + 1.0


def test_waves_behind_a_boat_are_as_long_as_its_speed_says():
    """On the course astern the phase turns once in 2 pi v²/g (Kelvin 1887)."""
    line = sea.wake_table()[0, 60:, 0]
    crests = np.flatnonzero((line[1:-1] > line[:-2]) & (line[1:-1] >= line[2:]))
    assert np.diff(crests).mean() / 6.0 == pytest.approx(math.tau, rel=0.03)


def test_a_sky_is_fair_then_foul_and_in_between_both():
    kinds = (clouds.Weather(0x204080, 0xF0A060, 0xFFFFFF, 0x606060, 0.4, 0.8),
             clouds.Weather(0x202020, 0x404040, 0x505050, 0x303030, 0.98, 0.3))  # fmt: skip
    sky = clouds.sky_of(64, 96, kinds, clouds.Sun(0.7, 0.3, 0x000000, 0.0))
    pixels, clip = np.zeros((64, 96), np.uint32), np.array((0, 0, 96, 64), np.int64)
    found = []
    for weather in (0.0, 0.5, 1.0):
        clouds.paint_sky(pixels, clip, 0, 64, sky, 0.0, weather, 0.0)
        found.append((pixels >> 16 & 255).astype(int))
    fair, half, foul = found
    assert (foul[:, :40] == (sky.pixels[1, :, :40] >> 16 & 255)).all()
    away = np.abs(half - fair) > 6
    assert 0.1 < away.mean() < 0.95 and fair.mean() > half.mean() > foul.mean()
