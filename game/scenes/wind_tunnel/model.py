"""The tunnel with its shape, what is measured of it, the smoke, and the flights."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.tunnel import (
    PlateFit,
    SeriesFit,
    Sweep,
    SweepPlan,
    Tunnel,
    TunnelOutline,
    TunnelSettings,
    TunnelState,
    fit_plate,
    fit_series,
    outline_of,
    shape_named,
)
from game.physics.tunnel.averages import Average, Mean
from game.physics.tunnel.streaks import Rake
from game.physics.tunnel.sweep import ANGLE, BOOK, DRAG, with_images
from game.scenes.wind_tunnel.flights import Flights, FlightsState
from game.scenes.wind_tunnel.level import WindTunnelContent
from game.scenes.wind_tunnel.parameters import OF_MEASURING, WindTunnelParameters
from game.stage import Part
from game.stage.messages import Messages

NOZZLES, SPECKS = 20, 150
SPACING = 0.02  # of the tunnel's height, between specks of smoke


class WindTunnelState(NamedTuple):
    """tunnel; mean: the row of `Average`; table and at of `Sweep`; specks and since of `Rake`; flights;
    counts (2,): shapes that were refused, sweeps that were completed.
    """

    tunnel: TunnelState
    mean: Floats
    table: Floats
    at: Floats
    specks: Floats
    since: Floats
    flights: FlightsState
    counts: Floats


class WindTunnelModel(Part):
    """``said``: what there is to tell, which the scene takes."""

    def __init__(self, content: WindTunnelContent, parameters: WindTunnelParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.counts: Floats = np.zeros(2)
        self.said = Messages()
        named = parameters.shape if parameters.shape != "drawn" else "disc"
        outline = outline_of(content.outline) if content.outline else shape_named(named)
        self.tunnel = Tunnel(outline, self._settings(), math.radians(parameters.attack))
        self.average = Average(*self._times())
        self.sweep = Sweep()
        tall = self.tall
        self.rake = Rake(NOZZLES, SPECKS, 0.0, tall, SPACING * tall)
        self.flights = Flights(outline, parameters, active)
        self._fit_key: tuple[object, ...] = ()
        self._series: SeriesFit | None = None
        self._plate_fit: PlateFit | None = None
        for stroke in content.strokes:
            self.draw_outline(stroke)
        if content.sweep:
            self.begin_sweep()

    # -- what it is made of -------------------------------------------------------------------------

    def _settings(self) -> TunnelSettings:
        chosen, content = self.parameters, self.content
        return TunnelSettings(
            cells=float(chosen.cells), width=content.width or 2.0 * chosen.height, height=chosen.height,
            at=content.at, wind=chosen.wind, reynolds=chosen.reynolds, walls=chosen.walls,
            profile=content.profile, courant=chosen.courant, nudge=content.nudge, effects=self.active,
        )  # fmt: skip

    def _times(self) -> tuple[float, float]:
        """s of settling and averaging."""
        unit = self.unit
        return self.parameters.settle * unit, self.parameters.window * unit

    @property
    def unit(self) -> float:
        """s that the wind takes for a chord."""
        return self.tunnel.outline.chord / self.tunnel.settings.pace

    @property
    def wide(self) -> float:
        """m of the tunnel."""
        return self.tunnel.grid.nx * self.tunnel.grid.cell

    @property
    def tall(self) -> float:
        """m of the tunnel."""
        return self.tunnel.grid.ny * self.tunnel.grid.cell

    @property
    def attack(self) -> float:
        """Degrees, now."""
        return math.degrees(self.tunnel.attack)

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        chosen = self.parameters
        if name == "shape":
            if chosen.shape != "drawn":
                self.change_outline(shape_named(chosen.shape), chosen.attack)
        elif name == "attack":
            if not self.sweep.running:
                self.turn(chosen.attack)
        elif name in ("reynolds", "wind", "courant"):
            self.tunnel.change_settings(self._settings())
            self._measure_anew()
        elif name in OF_MEASURING:
            self.average.settle, self.average.window = self._times()
        elif name in ("inertia", "half_chord"):
            self.launch()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.tunnel.change_settings(self._settings())
        self.flights.change_effects(active)

    # -- the shape ----------------------------------------------------------------------------------

    def change_outline(self, outline: TunnelOutline, degrees: float) -> bool:
        """Another shape at an angle of attack, or a message and False if it cannot be."""
        try:
            self.tunnel.change_outline(outline, math.radians(degrees))
        except ValueError as error:
            return self._refuse(error)
        self.sweep.clear()
        self._measure_anew()
        self.flights.change_outline(outline)
        return True

    def draw_outline(self, points: ArrayLike) -> bool:
        """A drawn shape (n, 2) m, where the tunnel holds it; False, and a message, if it cannot be."""
        try:
            outline = outline_of(points)
        except ValueError as error:
            return self._refuse(error)
        if not self.change_outline(outline, 0.0):
            return False
        self.parameters.shape, self.parameters.attack = "drawn", 0.0  # it stands as it was drawn
        return True

    def _refuse(self, error: ValueError) -> bool:
        self.counts[0] += 1.0
        self.said.say(f"Refused: {error}.")
        return False

    def turn(self, degrees: float) -> None:
        """Another angle of attack by hand; the measurement begins again."""
        self.tunnel.turn(math.radians(degrees))
        self._measure_anew()

    def _measure_anew(self) -> None:
        self.average.settle, self.average.window = self._times()
        self.average.clear()

    # -- the sweep ----------------------------------------------------------------------------------

    def begin_sweep(self) -> None:
        """Measure angle after angle from now on."""
        chosen = self.parameters
        plan = SweepPlan(int(chosen.angles), int(chosen.checks), bool(chosen.symmetry))
        self.tunnel.turn(self.sweep.begin(self.tunnel.outline, plan))
        self._measure_anew()

    def stop_sweep(self) -> None:
        """What was measured stays; the shape is held as the parameter says."""
        self.sweep.stop()
        self.turn(self.parameters.attack)

    def _go_on(self) -> None:
        """The angle is measured: to the next one, or to the flights."""
        following = self.sweep.keep(self.average.mean(self.unit))
        if following is not None:
            self.tunnel.turn(following)
            self.average.clear()
            return
        self.counts[1] += 1.0
        self.turn(self.parameters.attack)
        self.launch()

    def chosen_rows(self, rows: Floats) -> Floats:
        """Rows of the table with what is to be fitted in the columns of the wall's forces."""
        if self.parameters.measure == "book":
            rows = rows.copy()
            rows[:, DRAG : DRAG + 3] = rows[:, BOOK : BOOK + 3]
        return rows

    def samples(self, checks: bool = False) -> tuple[Floats, Floats]:
        """Angles (n,) rad and coefficients (n, 3) that were measured, images by symmetry among them."""
        return with_images(self.chosen_rows(self.sweep.measured(checks)), self.tunnel.outline)

    def _fit(self) -> None:
        key = (self.sweep.table.tobytes(), self.parameters.measure, int(self.parameters.order))
        if key == self._fit_key:
            return
        self._fit_key, self._series, self._plate_fit = key, None, None
        if self.sweep.complete:
            angles, values = self.samples()
            self._series = fit_series(angles, values, int(self.parameters.order))
            self._plate_fit = fit_plate(angles, values)

    @property
    def series(self) -> SeriesFit | None:
        """The fitted series, once all angles are measured."""
        self._fit()
        return self._series

    @property
    def plate_fit(self) -> PlateFit | None:
        """The plates' law, fitted, once all angles are measured."""
        self._fit()
        return self._plate_fit

    def check_error(self) -> tuple[float, float]:
        """Root mean square of the series' error in drag and lift at the checks; 0 for none."""
        rows = self.chosen_rows(self.sweep.measured(True))
        series = self.series
        if series is None or not len(rows):
            return 0.0, 0.0
        error = series.error(rows[:, ANGLE], rows[:, DRAG : DRAG + 3])
        return float(error[0]), float(error[1])

    def launch(self) -> None:
        """Let all fly from the top: by the law's default, and by what was measured as far as it was."""
        self.flights.launch(self.tunnel.outline, self.series, self.plate_fit)

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Steps of the gas, then the flights for dt (s)."""
        wind = self.tunnel.settings.wind
        for _ in range(int(self.parameters.pace)):
            length = self.tunnel.step_length
            self.tunnel.step()
            self.rake.step(self.tunnel.gas, length, wind)
            self.average.take(self.tunnel.reading, length)
            if self.sweep.running and self.average.done:
                self._go_on()
        self.flights.advance(dt)

    def fastest(self) -> float:
        """m/s, of the gas."""
        gas = self.tunnel.gas
        return float(max(np.max(np.abs(gas.u)), np.max(np.abs(gas.v))))

    def mean(self) -> Mean:
        """Of the angle at which it is held now."""
        return self.average.mean(self.unit)

    def state(self) -> WindTunnelState:
        """All that later steps depend on."""
        return WindTunnelState(
            self.tunnel.state(), self.average.row, self.sweep.table, self.sweep.at, self.rake.specks,
            self.rake.since, self.flights.state(), self.counts,
        )  # fmt: skip

    def restore(self, state: WindTunnelState) -> None:
        """Take over a copy of a state."""
        self.tunnel.restore(state.tunnel)
        self.average.settle, self.average.window = self._times()
        self.average.row[:] = state.mean
        self.sweep.table, self.sweep.at[:] = state.table.copy(), state.at
        self.rake.specks[:], self.rake.since[:] = state.specks, state.since
        self.flights.restore(self.tunnel.outline, state.flights)
        self.counts[:] = state.counts
