"""Smoke in the light of bursts: by distance in all three directions, for as long as a burst lasts."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.generations.step import BORN, DEPTH, DIES, FIELDS, X, Y
from game.scenes.fireworks.shine import FLASH_FADES, FLASH_REACH, Seen, light_smoke

FLASH = (10.0, 50.0, 80.0, 30.0, 9.0, 6.0, 3.0)  # s, x, y, depth, red, green, blue


def lit(places, flashes, time: float = 10.0) -> np.ndarray:
    """How much light smoke of two seconds at some places (n, 3: x, y, depth) gives back; a dark sky."""
    places = np.asarray(places)
    rows = np.zeros((FIELDS, len(places)))
    rows[[X, Y, DEPTH]] = places.T
    rows[BORN], rows[DIES] = time - 2.0, time + 2.0
    n = len(places)
    colors, shares = np.zeros(n, np.int64), np.zeros(n)
    made = light_smoke(
        rows, np.array(flashes).reshape(-1, 7), Seen(0.0, time, 0.0), np.zeros(4), np.zeros((n, 2)),
        np.zeros(n), colors, shares,
    )  # fmt: skip
    assert made == n
    if flashes:
        assert set(colors.tolist()) == {0xFFAA55}  # of the burst's colour
    return shares


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
