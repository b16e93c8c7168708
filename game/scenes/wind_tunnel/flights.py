"""Three that fall side by side: by the plates' law as it is, by that law fitted, by the measured series."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, QUADRATIC_DRAG
from game.physics.plates import Plate, Plates, PlateState
from game.physics.plates.effects import CIRCULATION, PLATES
from game.physics.plates.law import THETA, X, Y
from game.physics.tunnel import DataFlight, PlateFit, SeriesFit, TunnelOutline
from game.scenes.wind_tunnel.parameters import WindTunnelParameters
from game.stage import Part

FLASHES = 48  # poses that are remembered of each
FLASH_S = 1.0 / 12.0  # s between two
TILT = 0.2  # rad, at the start
LANES = (-5.0, 0.0, 5.0)  # half chords: where they begin
DEFAULT, FITTED, SERIES = range(3)


class FlightsState(NamedTuple):
    """plates; coefficients (3, k) and row (6,) of the flight by the series, (3, 0) for none; flashes
    (FLASHES, 3, n) x, y, angle; clock (2,): s, flashes so far.
    """

    plates: PlateState
    coefficients: Floats
    row: Floats
    flashes: Floats
    clock: Floats


class Flights(Part):
    """One, before anything is measured, else three."""

    def __init__(self, outline: TunnelOutline, parameters: WindTunnelParameters, active: EffectSet):
        self.parameters, self.active = parameters, active
        self.clock: Floats = np.zeros(2)
        self.launch(outline, None, None)

    def plate(self, outline: TunnelOutline) -> Plate:
        """The law's default for an outline's thickness."""
        chosen = self.parameters
        thin = outline.thickness
        return Plate(chosen.half_chord, max(chosen.inertia, 1.001 * thin), thin)

    def launch(self, outline: TunnelOutline, series: SeriesFit | None, fitted: PlateFit | None) -> None:
        """From rest at the top, tilted a little."""
        usual = self.plate(outline)
        half = usual.half_chord
        plates = [usual]
        if fitted is not None:
            drag = min(max(fitted.drag, 0.0), 20.0)
            turn = min(max(fitted.drag_turn, -drag), drag)
            lift = min(max(fitted.glide, -20.0), 20.0)
            plates.append(usual._replace(drag=drag, drag_turn=turn, glide=lift))
        places = [(LANES[k] * half, 0.0, TILT) for k in range(len(plates))]
        self.plates = Plates(plates, places, effects=self.active & PLATES.known)
        self.data: DataFlight | None = None
        if series is not None:
            self.data = DataFlight(usual, series)
            self.data.row[0], self.data.row[2] = LANES[SERIES] * half, TILT
        self.clock[:] = 0.0
        self.flashes: Floats = np.tile(self.poses(), (FLASHES, 1, 1))

    def change_outline(self, outline: TunnelOutline) -> None:
        """Nothing has been measured of another shape."""
        self.launch(outline, None, None)

    def change_effects(self, active: EffectSet) -> None:
        """Compute these from now on."""
        self.active = active
        self.plates.effects = active & PLATES.known

    def poses(self) -> Floats:
        """(3, n): x, y m, angle rad of each."""
        found = self.plates.rows[[X, Y, THETA]]
        if self.data is not None:
            found = np.concatenate([found, self.data.row[:3, None]], axis=1)
        return np.asarray(found)

    @property
    def kinds(self) -> tuple[int, ...]:
        """Which of DEFAULT, FITTED, SERIES there are, in the order of `poses`."""
        return (DEFAULT, FITTED, SERIES)[: len(self.plates) + (self.data is not None)]

    @property
    def half(self) -> float:
        """m, half the chord."""
        return float(self.parameters.half_chord)

    def advance(self, dt: float) -> None:
        """All fall for dt (s)."""
        self.plates.step(dt)
        self.plates.check()
        if self.data is not None:
            on = self.active
            gravity = 9.81 if GRAVITY in on else 0.0
            self.data.step(dt, gravity, QUADRATIC_DRAG in on, CIRCULATION in on)
        self.clock[0] += dt
        if self.clock[0] >= self.clock[1] * FLASH_S:
            self.flashes[int(self.clock[1]) % FLASHES] = self.poses()
            self.clock[1] += 1.0

    def descents(self) -> tuple[float, float, float]:
        """m/s that each has fallen in the mean since it was let go; NaN for what does not fly."""
        time = max(float(self.clock[0]), 1e-9)
        down = -self.poses()[1] / time
        return tuple(float(down[k]) if k < len(down) else math.nan for k in range(3))  # type: ignore[return-value]

    def glides(self) -> tuple[float, float, float]:
        """Way along for each metre down since each was let go; 0 for what has not fallen, NaN for what is not
        there.
        """
        poses = self.poses()
        found = [0.0 if k < poses.shape[1] else math.nan for k in range(3)]
        for k in range(poses.shape[1]):
            down = -float(poses[1, k])
            if down > 0.1 * self.half:
                found[k] = abs(float(poses[0, k]) - LANES[k] * self.half) / down
        return found[0], found[1], found[2]

    def state(self) -> FlightsState:
        """All that later steps depend on."""
        data = self.data
        coefficients = data.coefficients if data is not None else np.zeros((3, 0))
        row = data.row if data is not None else np.zeros(6)
        return FlightsState(self.plates.state(), coefficients, row, self.flashes, self.clock)

    def restore(self, outline: TunnelOutline, state: FlightsState) -> None:
        """Take over a copy of a state."""
        self.plates.restore(state.plates)
        self.data = None
        if state.coefficients.shape[1]:
            order = (state.coefficients.shape[1] - 1) // 2
            series = SeriesFit(order, state.coefficients.copy(), np.zeros(3))
            self.data = DataFlight(self.plate(outline), series)
            self.data.row[:] = state.row
        self.flashes, self.clock[:] = state.flashes.copy(), state.clock
        assert math.isfinite(float(self.clock[0]))
