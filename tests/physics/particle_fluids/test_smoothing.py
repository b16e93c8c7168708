"""Kernels in the plane, held to their closed factors and to sums over a lattice."""

import numpy as np
import pytest

from game.physics.particle_fluids.smoothing import CUBIC, FACTORS, NAMES, POLY6, WENDLAND, fill_kernel

# 4/pi, 10/pi, 40/(7 pi), 7/pi, 10/(3 pi), by closed form and by quadrature elsewhere
KNOWN = {
    "poly6": 1.2732395447351628, "spiky": 3.183098861837907, "cubic": 1.8189136353359467,
    "wendland": 2.228169203286535, "viscous": 1.0610329539459689,
}  # fmt: skip
LATTICE = {
    2.0: {"poly6": 1.0146127622108327, "cubic": 1.000861832776646, "wendland": 1.0376017869915068},
    3.0: {"poly6": 1.002329255991025, "cubic": 1.0034403964801626, "wendland": 1.0051423407773563},
}


def values_at(kind, distances):
    values, slopes = np.zeros(len(distances)), np.zeros(len(distances))
    fill_kernel(kind, distances, values, slopes)
    return values, slopes


@pytest.mark.parametrize("kind", range(5), ids=NAMES)
def test_a_kernel_fills_the_plane_once(kind):
    points, parts = np.polynomial.legendre.leggauss(40)
    total = 0.0
    for low, high in ((0.0, 0.5), (0.5, 1.0)):
        q = low + (high - low) * 0.5 * (1.0 + points)
        total += float(np.sum(0.5 * (high - low) * parts * 2.0 * np.pi * q * values_at(kind, q)[0]))
    assert total == pytest.approx(1.0, abs=1e-12)
    assert FACTORS[kind] == pytest.approx(KNOWN[NAMES[kind]], rel=1e-14)


@pytest.mark.parametrize("kind", range(5), ids=NAMES)
def test_its_slope_is_that_of_its_values(kind):
    q, step = np.linspace(0.1, 0.99, 60), 1e-6
    q = q[np.abs(q - 0.5) > 0.01]
    rise = (values_at(kind, q + step)[0] - values_at(kind, q - step)[0]) / (2.0 * step)
    assert values_at(kind, q)[1] == pytest.approx(rise, abs=2e-7 * FACTORS[kind] * 100)
    beyond, flat = values_at(kind, np.array([1.0, 1.5]))
    assert not beyond.any() and not flat.any()


@pytest.mark.parametrize("ratio", LATTICE)
@pytest.mark.parametrize("kind", [POLY6, CUBIC, WENDLAND], ids=["poly6", "cubic", "wendland"])
def test_sums_over_a_square_lattice(kind, ratio):
    at = np.arange(-4, 5)
    gaps = np.hypot(*np.meshgrid(at, at)).ravel() / ratio
    found = float(np.sum(values_at(kind, gaps)[0])) / (ratio * ratio)
    assert found == pytest.approx(LATTICE[ratio][NAMES[kind]], rel=1e-9)
