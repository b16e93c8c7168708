"""The study of stars: its exact height, and the order that each method really has."""

import math

import pytest

from game.lab import fit_order, run_study
from game.lab.studies.stars import DRAG, ORDERS, SPEED, height_after, star_study, throw


def test_the_exact_height():
    """v0 60, terminal speed 31.3: the top by ln(1 + (v0/vt)²) vt²/2g, a quarter second by a fine flight."""
    terminal = math.sqrt(9.81 / DRAG)
    top = terminal / 9.81 * math.atan(SPEED / terminal)
    assert height_after(top) == pytest.approx(terminal**2 / 19.62 * math.log1p((SPEED / terminal) ** 2))
    assert height_after(0.0) == 0.0
    assert throw("rk4", 1e-3, 250) == pytest.approx(height_after(0.25), abs=1e-9)
    with pytest.raises(ValueError, match="falls"):
        height_after(top + 0.1)


def test_every_method_has_its_order():
    table = run_study(star_study, repeats=1)
    for method, order in ORDERS.items():
        assert fit_order(table.of(method)) == pytest.approx(order, abs=0.25), method
