"""Sheets of a fire: as bright together as the whole depth of gas, and moved by chance alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.worlds.painting.glowing import SECOND, WAVE, GlowLook
from game.worlds.painting.sheets import PERIOD, Sheets, pattern

LOOK = GlowLook(680.0, 1450.0, 0.05, 1e-4, 1.6e-3, 0.85, 950.0)
SHAPE = (48, 48)


def seen(kelvin: float, soot: float, time: float = 0.0) -> np.ndarray:
    """The veil of gas that is alike everywhere."""
    sheets = Sheets(LOOK, SHAPE, 1.6 / 48)
    return sheets.veil(np.full(SHAPE, kelvin), np.full(SHAPE, soot), np.ones(SHAPE), time)


@pytest.mark.parametrize("kelvin", [900.0, 1200.0, 1400.0])
@pytest.mark.parametrize("soot", [0.0, 1e-5, 3e-4])
def test_sheets_together_are_as_bright_as_the_whole_depth(kelvin, soot):
    """Wien's law with the emissivity of all of it, wherever each sheet is moved."""
    emissivity = -math.expm1(-(0.05 + soot / 1e-4))
    bright = 1.0 / (1.0 / kelvin - WAVE / SECOND * math.log(emissivity))
    share = min(max((bright - 680.0) / (1450.0 - 680.0), 0.0), 1.0)
    assert seen(kelvin, soot)[..., 1] == pytest.approx(share, abs=1e-5)


def test_cold_soot_is_smoke_and_hot_soot_is_none():
    veil = seen(400.0, 8e-4)
    assert np.all(veil[..., 1] == 0.0) and veil[..., 0] == pytest.approx(0.5, abs=1e-6)
    assert np.all(seen(1300.0, 8e-4)[..., 0] == 0.0)


def test_a_tongue_is_shaken_more_the_higher_it_is_and_otherwise_a_moment_later():
    temperature, soot = np.full(SHAPE, 293.15), np.full(SHAPE, 2e-4)
    temperature[:, 20:28] = 1200.0
    sheets = Sheets(LOOK, SHAPE, 1.6 / 48)
    first = sheets.veil(temperature, soot, np.ones(SHAPE), 1.0).copy()
    then = sheets.veil(temperature, soot, np.ones(SHAPE), 1.1).copy()
    again = sheets.veil(temperature, soot, np.ones(SHAPE), 1.0)
    assert np.array_equal(first, again) and not np.array_equal(first, then)
    changed = np.abs(then - first)[..., 1].sum(axis=1)
    assert changed[200:260].mean() > 4.0 * changed[:20].mean()


def test_the_pattern_has_no_seam():
    """From one rim to the other it is as smooth as within."""
    found = pattern(180)
    assert found.shape == (PERIOD, PERIOD, 2)
    steps = np.abs(np.diff(found, axis=0)).max()
    assert (
        np.abs(found[0] - found[-1]).max() <= steps
        and np.abs(found[:, 0] - found[:, -1]).max() <= 1.3 * steps
    )
