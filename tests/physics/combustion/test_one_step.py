"""One step of burning in a few cells, counted anew cell by cell; what a fuel may be made of."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.combustion import Flames, GasFuel
from game.physics.combustion.effects import EXPANSION, FLAMES

COLUMNS = (1, 2, 0, 3)
FUEL = GasFuel(
    effects=FLAMES | EXPANSION, ignition=600.0, rate=4.0, oxygen=3.0, heat=2e6, capacity=1e3, soot=0.1
)
CELLS = [  # oxygen, temperature, fuel, soot
    (0.30, 900.0, 0.02, 0.0), (0.03, 700.0, 0.05, 0.001), (0.30, 599.9, 0.02, 0.0), (0.30, 600.0, 0.01, 0.0),
    (0.00, 900.0, 0.02, 0.0), (0.30, 900.0, 0.00, 0.002),
]  # fmt: skip


def test_every_cell_that_can_burns_and_is_counted():
    cells, source, dt, h = np.array(CELLS).reshape(2, 3, 4).copy(), np.zeros((2, 3)), 0.25, 0.5
    flames = Flames(COLUMNS, h, FUEL)
    flames.step(cells, dt, source)
    share = 1.0 - math.exp(-4.0 * dt)
    burnt = []
    for (oxygen, warm, fuel, soot), now, grows in zip(
        CELLS, cells.reshape(6, 4), source.ravel().tolist(), strict=True
    ):
        gone = min(fuel, oxygen / 3.0) * share if warm >= 600.0 else 0.0
        burnt.append(gone)
        hotter = warm + 2e6 * gone / 1e3
        assert now == pytest.approx((oxygen - 3.0 * gone, hotter, fuel - gone, soot + 0.1 * gone), rel=1e-12)
        assert grows == pytest.approx((hotter - warm) / (warm * dt), rel=1e-9, abs=1e-12)
    assert flames.alight == sum(gone > 0.0 for gone in burnt) == 3
    assert flames.fiercest == pytest.approx(2e6 * max(burnt) / dt)
    assert flames.power == pytest.approx(2e6 * sum(burnt) * h * h / dt)
    books = flames.books_now()
    assert (books.burnt, books.used) == pytest.approx((sum(burnt) * h * h, 3.0 * sum(burnt) * h * h))


def test_contents_are_counted_from_the_ambient():
    cells = np.array(CELLS).reshape(2, 3, 4)
    oxygen, warm, fuel, soot = cells.reshape(6, 4).sum(axis=0) * 0.25
    found = Flames(COLUMNS, 0.5, FUEL).contents(cells)
    assert found == pytest.approx((1e3 * (warm - 6 * 0.25 * 293.15), fuel, oxygen, soot), rel=1e-12)


@pytest.mark.parametrize(
    "name", ["ignition", "rate", "heat", "soot", "soot_rate", "soot_size", "glow", "soot_glow", "ambient"]
)
def test_what_may_be_nothing_may(name):
    assert getattr(GasFuel(**{name: 0.0}), name) == 0.0


@pytest.mark.parametrize("name", ["oxygen", "capacity"])
def test_what_is_divided_by_must_be_more_than_nothing(name):
    with pytest.raises(ValueError, match=f"^{name} = 0.0: expected a number above 0"):
        GasFuel(**{name: 0.0})
