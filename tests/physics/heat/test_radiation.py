"""Cooling by radiation against Taylor's series in forty digits, over all the ways that it is computed."""

from __future__ import annotations

from decimal import Decimal, localcontext

import numpy as np
import pytest

from game.physics.heat.radiation import cooled


def exactly(start: float, ambient: float, rate: float, dt: float) -> Decimal:
    """Forty digits, twenty terms, small steps."""
    steps = 12
    hot, b, h = Decimal(start), Decimal(rate), Decimal(dt) / steps
    around = Decimal(ambient) ** 4
    for _ in range(steps):
        terms, squares = [hot], []
        for k in range(20):
            squares.append(sum(terms[i] * terms[k - i] for i in range(k + 1)))
            fourth = sum(squares[i] * squares[k - i] for i in range(k + 1))
            terms.append(-b * (fourth - (around if k == 0 else 0)) / (k + 1))
        hot = sum(term * h**k for k, term in enumerate(terms))
    return hot


@pytest.mark.parametrize("way", [1e-6, 3e-4, 4.9e-4, 5.1e-4, 4e-3, 9.9e-3, 0.0101, 0.03, 0.079, 0.081, 0.15])
def test_cooling_is_exact_however_it_is_computed(way):
    rng = np.random.default_rng(3)
    with localcontext() as context:
        context.prec = 40
        for _ in range(6):
            start, ambient = 10.0 ** rng.uniform(2.3, 3.6), 10.0 ** rng.uniform(2.3, 3.3)
            rate = way * 60.0 / max(start, ambient) ** 3
            want = exactly(start, ambient, rate, 1.0 / 60.0)
            assert abs(Decimal(cooled(start, ambient, rate, 1.0 / 60.0)) / want - 1) < Decimal("1e-12")


def test_cooling_is_monotone_and_never_passes_what_is_around():
    """In the time, across the borders between the ways, from above and from below."""
    for start, ambient in ((1500.0, 300.0), (250.0, 900.0), (300.0, 299.999999)):
        rate = 0.4 * 60.0 / max(start, ambient) ** 3
        times = np.sort(np.concatenate([np.linspace(0.0, 1.0 / 60.0, 900), np.geomspace(1e-9, 1e3, 200)]))
        found = np.array([cooled(start, ambient, rate, float(t)) for t in times])
        assert np.all(np.diff(found) * np.sign(ambient - start) >= -4e-16 * start)
        assert found.min() >= min(start, ambient) and found.max() <= max(start, ambient)
