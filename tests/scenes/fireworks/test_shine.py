"""Smoke in the light of bursts: by distance in all three directions, for as long as a burst lasts."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.generations.step import BORN, DIES, FIELDS, X, Y, Z
from game.scenes.fireworks.eye import Seen
from game.scenes.fireworks.shine import (
    BLINK_SHARE,
    CELLS,
    FLASH_FADES,
    FLASH_REACH,
    STAR_LIT,
    STAR_REACH,
    WHITEST,
    Glow,
    light_smoke,
    shed_light,
    shine,
)

FLASH = (10.0, 50.0, 80.0, 30.0, 9.0, 6.0, 3.0)  # s, x, y, depth, red, green, blue


def lit(places, flashes, time: float = 10.0, lamps=()) -> np.ndarray:
    """How much light falls on smoke of a second at some places (n, 3: x, y, depth), under a dark sky."""
    places = np.asarray(places)
    rows = np.zeros((FIELDS, len(places)))
    rows[[X, Y, Z]] = places.T
    rows[BORN], rows[DIES] = time - 1.0, time + 1.0
    n = len(places)
    colors, shares = np.zeros(n, np.int64), np.zeros(n)
    made = light_smoke(
        rows, np.array(flashes).reshape(-1, 7), np.array(lamps).reshape(-1, 6),
        Seen(0.0, time, 0.0), np.zeros(4), np.zeros((n, 2)), np.zeros(n), colors, shares,
    )  # fmt: skip
    assert made == n
    if flashes:
        assert set(colors.tolist()) == {0xFFAA55}  # of the burst's colour
    return shares / (1.0 - shares / WHITEST)


def test_a_burst_lights_by_the_square_of_the_distance_in_all_directions():
    there = np.array(FLASH[1:4])
    ways = FLASH_REACH * np.array(
        [(0, 0, 0), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    )
    shares = lit(there + ways, [FLASH])
    assert shares[1:] == pytest.approx(0.5 * shares[0])
    assert lit(there + 3.0 * ways, [FLASH])[1:] == pytest.approx(0.1 * shares[0])


def test_a_burst_fades_and_does_not_light_before_it_is_there():
    there = [FLASH[1:4]]
    at_once, later = lit(there, [FLASH]), lit(there, [FLASH], 10.0 + FLASH_FADES)
    assert later == pytest.approx(at_once * np.exp(-1.0))
    assert lit(there, [FLASH, FLASH]) == pytest.approx(2.0 * at_once)


def test_smoke_gives_back_no_more_than_its_share_however_much_falls_on_it():
    bright = [(*FLASH[:4], *(1e6 * channel for channel in FLASH[4:]))]
    shares = np.zeros(1)
    rows = np.zeros((FIELDS, 1))
    rows[[X, Y, Z], 0] = FLASH[1:4]
    rows[BORN], rows[DIES] = 9.0, 11.0
    light_smoke(
        rows, np.array(bright), np.zeros((0, 6)), Seen(0.0, 10.0, 0.0), np.zeros(4), np.zeros((1, 2)),
        np.zeros(1), np.zeros(1, np.int64), shares,
    )  # fmt: skip
    assert shares[0] == pytest.approx(WHITEST, rel=1e-3)


def test_stars_light_smoke_from_where_they_are_by_their_colour():
    stars = np.zeros((FIELDS, 3))
    stars[[X, Y, Z]] = np.array([(10.0, 50.0, 5.0), (12.0, 52.0, 9.0), (11.0, 51.0, 7.0)]).T
    stars[DIES] = 4.0
    shades = np.tile((255.0, 170.0, 85.0), (8, 1))
    cells = np.zeros((int(np.prod(CELLS)), 7))
    shed_light(stars, shades, Glow(2, 0, 0.0, 0.0, 0.0, 0.0), 1.0, 1, cells)
    (some,) = cells[cells[:, 6] > 0.0]
    assert some[:3] / some[6] == pytest.approx((11.0, 51.0, 7.0))
    assert some[3:6] == pytest.approx((3.0, 2.0, 1.0))
    lamp = (*(some[:3] / some[6]), *some[3:6])
    there = np.array([lamp[:3], (11.0, 51.0, 7.0 + STAR_REACH)])
    assert lit(there, [], lamps=[lamp]) == pytest.approx((3.0 * STAR_LIT, 1.5 * STAR_LIT))
    half = np.zeros_like(cells)
    shed_light(stars[:, [0, 0, 1, 1]], shades, Glow(2, 0, 0.0, 0.0, 0.0, 0.0), 1.0, 2, half)
    assert half[:, 3].sum() == pytest.approx(4.0)  # two that are taken stand for four


def brightness(glow: Glow, times: np.ndarray) -> np.ndarray:
    """How bright a white star is drawn at some times (s), of 1."""
    rows, found = np.zeros((FIELDS, 1)), []
    rows[DIES], shades = 303.7, np.full((4, 3), 255.0)
    places, colors, sizes, shares = (
        np.zeros((2, 2)),
        np.zeros(2, np.int64),
        np.zeros(2, np.int64),
        np.zeros(2),
    )
    for time in times.tolist():
        assert shine(rows, shades, glow, Seen(0.0, time, 0.0), places, colors, sizes, shares, 0) == 1
        found.append((int(colors[0]) & 0xFF) / 255.0)
    return np.array(found)


def test_a_strobe_is_bright_for_its_share_of_the_time_and_nearly_dark_else():
    found = brightness(Glow(2, 0, 0.0, 0.0, 3.0, 0.0), np.linspace(0.0, 300.0, 3001))
    assert sorted(set(found.tolist())) == pytest.approx([0.05, 1.0], abs=0.5 / 255)
    assert float(np.mean(found > 0.5)) == pytest.approx(BLINK_SHARE, abs=0.02)


def test_a_spark_twinkles_down_to_what_its_kind_says():
    found = brightness(Glow(2, 0, 0.0, 0.0, 0.0, 0.4), np.linspace(0.0, 100.0, 1001))
    assert (found.min(), found.max()) == pytest.approx((0.6, 1.0), abs=0.01)
    assert float(found.mean()) == pytest.approx(0.8, abs=0.01)
