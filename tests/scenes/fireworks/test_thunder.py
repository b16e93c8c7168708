"""Sound that comes later than the light, to a listener who walks; and how large the table of stars is."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from game.scenes.fireworks.shells import Amounts, spark_kinds
from game.scenes.fireworks.thunder import EAR, NEAR, SPEED_OF_SOUND, WALKING, Thunder


def test_a_walking_listener_hears_it_when_and_where_the_wave_meets_them():
    """Instant, side and loudness, in a step of 0.9 s, found anew by Brent's method."""
    place, distance, now, dt = (200.0, 150.0, 40.0), 60.0, 0.3, 0.9
    thunder = Thunder(0.0, distance)
    thunder.emit(0.0, place, "burst", 0.8)
    walk_to = (100.0, distance)
    met = []
    for step in range(2):
        thunder.go_on(now + step * dt, dt, walk_to)
        met += thunder.sounds()

    def away(instant: float) -> tuple[float, float]:
        ear = WALKING * (instant - now)
        x = place[0] - ear
        return x, math.hypot(x, place[1] - EAR, place[2] + distance)

    instant = brentq(lambda t: SPEED_OF_SOUND * t - away(t)[1], 0.0, 2.3, xtol=1e-12)
    assert now < instant < now + dt
    x, way = away(instant)
    sound = met[0]
    assert sound.kind == "burst"
    assert sound.time == pytest.approx(instant, abs=1e-9)
    assert sound.pan == pytest.approx(x / way, rel=1e-9)
    assert sound.speed == pytest.approx(0.8 * NEAR / way, rel=1e-9)


@pytest.mark.parametrize("share", [0.25, 0.5, 1.0])
def test_a_share_of_the_places_is_that_of_every_kind(share):
    whole, part = (np.array([kind.capacity for kind in spark_kinds(Amounts(places=p))]) for p in (1.0, share))
    assert part == pytest.approx(share * whole, abs=1.0)
    assert all(kind.capacity == 1 for kind in spark_kinds(Amounts(places=1e-9)))
