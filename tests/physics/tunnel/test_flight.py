"""Flight by a series: with the plates' own coefficients it is the plates' flight."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.grid import Grid
from game.physics.plates import Plate, Plates
from game.physics.plates.effects import PLATES
from game.physics.plates.law import SPIN, THETA, VX, VY
from game.physics.tunnel import TUNNEL, DataFlight, SeriesFit
from game.physics.tunnel.streaks import PARKED, Rake


def own_series(plate: Plate) -> SeriesFit:
    """C_D = A - B cos 2 alpha, C_L = C_T sin 2 alpha, C_M = pi/4 (1 - beta²) sin 2 alpha."""
    values = np.zeros((3, 5))
    values[0, 0], values[0, 3] = plate.drag, -plate.drag_turn
    values[1, 4] = plate.glide
    values[2, 4] = 0.25 * math.pi * (1.0 - plate.thickness**2)
    return SeriesFit(2, values, np.zeros(3))


@pytest.mark.parametrize("plate", [Plate(0.05, 1.1), Plate(0.02, 1.4, 0.2), Plate(0.1, 3.0, 0.5)])
def test_with_the_laws_own_coefficients_it_flies_as_the_plates_room(plate):
    room = Plates([plate], [(0.0, 0.0, 0.2)], effects=TUNNEL.known & PLATES.known)
    room.set_motion(0, (0.1, -0.05), 0.3)
    flight = DataFlight(plate, own_series(plate))
    flight.row[:] = 0.0, 0.0, 0.2, 0.1, -0.05, 0.3
    for _ in range(60):
        room.step(1.0 / 240.0)
        flight.step(1.0 / 240.0)
    assert flight.row[:2] == pytest.approx(room.positions[0], abs=2e-5)
    assert flight.row[2] == pytest.approx(room.rows[THETA, 0], abs=1e-3)
    assert flight.row[3:] == pytest.approx(room.rows[[VX, VY, SPIN], 0], abs=1e-2)
    assert abs(flight.row[1]) > plate.half_chord


def test_what_is_switched_off_does_not_act():
    plate = Plate(0.05, 2.0, 0.1)
    still = DataFlight(plate, own_series(plate))
    still.step(0.1, gravity=0.0)
    assert not still.row.any()
    free = DataFlight(plate, SeriesFit(0, np.zeros((3, 1)), np.zeros(3)))
    free.row[2] = 0.5 * math.pi  # edge on, its heavy way down
    free.step(0.1, drag=False, lift=False)
    # (I + beta²) v' = (I - beta) g along the chord
    assert free.row[4] == pytest.approx(-9.81 * 0.1 * (2.0 - 0.1) / (2.0 + 0.01), rel=1e-9)


def test_a_series_whose_drag_dips_below_zero_does_not_push():
    plate = Plate(0.05, 2.0, 0.1)
    pushing = SeriesFit(0, np.array([[-5.0], [0.0], [0.0]]), np.zeros(3))
    flight = DataFlight(plate, pushing)
    flight.row[3] = 1.0
    flight.step(0.05, gravity=0.0)
    assert math.hypot(*flight.row[3:5]) == pytest.approx(1.0, rel=1e-6)


def test_a_nose_that_the_moment_raises_turns_clockwise():
    plate = Plate(0.05, 2.0, 0.1)
    flight = DataFlight(plate, SeriesFit(0, np.array([[0.0], [0.0], [0.5]]), np.zeros(3)))
    flight.row[3] = -1.0  # nose first, to the left
    flight.step(0.01, gravity=0.0)
    assert flight.row[5] < 0.0


def test_lift_is_upwards_for_a_raised_nose():
    plate = Plate(0.05, 2.0, 0.1)
    flight = DataFlight(plate, own_series(plate))
    flight.row[2], flight.row[3] = -0.3, -1.0
    flight.step(0.002, gravity=0.0)
    assert flight.row[4] > 0.0 and flight.row[3] > -1.0


def test_steps_and_flights_that_run_away_are_refused():
    flight = DataFlight(Plate(), own_series(Plate()))
    for dt in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="dt"):
            flight.step(dt)
    flight.row[3] = 1e300
    with pytest.raises(FloatingPointError):
        flight.step(1.0)


class Wind:
    """An even wind on a grid, as a gas has it."""

    def __init__(self, u: float, v: float):
        self.grid = Grid(40, 20, 0.1)
        self.u, self.v = np.full((20, 41), u), np.full((21, 40), v)


def test_specks_drift_with_the_wind_are_let_go_evenly_and_end_at_the_outflow():
    rake = Rake(3, 30, 0.0, 2.0, 0.2)
    wind = Wind(1.0, 0.1)
    for _ in range(60):
        rake.step(wind, 0.05, 1.0)
    there = rake.specks[1, :, 0] >= 0.0
    x, y = rake.specks[1, there].T
    assert y == pytest.approx(1.0 + 0.1 * x)
    assert -np.diff(x) == pytest.approx(np.full(len(x) - 1, -0.2)) or np.diff(x) == pytest.approx(0.2)
    for _ in range(60):
        rake.step(wind, 0.05, 1.0)
    assert rake.specks[:, :, 0].max() <= 4.0
    assert (rake.specks[:, 25:, 0] == PARKED).all()
    lines = rake.lines()
    assert np.isnan(lines[:, 25:]).all() and np.isfinite(lines[:, 1:10]).all()


def test_a_line_is_torn_where_specks_have_come_apart():
    rake = Rake(1, 6, 0.0, 1.0, 0.1)
    rake.specks[0, :, 0] = (0.0, 0.1, 0.2, 1.2, 1.3, 1.4)
    rake.specks[0, :, 1] = 0.5
    lines = rake.lines()
    assert np.isnan(lines[0, 3]).all() and np.isfinite(lines[0, [0, 1, 2, 4, 5]]).all()
