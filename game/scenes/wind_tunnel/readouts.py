"""What is measured in the tunnel, and of the fit; NaN where nothing was measured yet."""

from __future__ import annotations

import math

from game.scenes.wind_tunnel.flights import DEFAULT, FITTED, SERIES
from game.scenes.wind_tunnel.model import WindTunnelModel
from game.stage import Readout


def readouts_of(model: WindTunnelModel) -> tuple[Readout, ...]:
    """Coefficients by both ways, how far these are apart, their spread, the sweep, the fit, the flights."""
    mean, now, tunnel = model.mean(), model.tunnel.forces(), model.tunnel
    gap = 100.0 * abs(mean.wall[0] - mean.book[0]) / max(abs(mean.book[0]), 1e-9)
    series, plate = model.series, model.plate_fit
    drag_error, lift_error = model.check_error()
    descents, glides = model.flights.descents(), model.flights.glides()
    return (
        Readout("drag", mean.book[0]),
        Readout("lift", mean.book[1]),
        Readout("moment", mean.book[2]),
        Readout("drag, wall", mean.wall[0]),
        Readout("lift, wall", mean.wall[1]),
        Readout("moment, wall", mean.wall[2]),
        Readout("drag now", now.book[0]),
        Readout("lift now", now.book[1]),
        Readout("friction", now.friction[0]),
        Readout("book gap", gap if mean.seconds > 0.0 else math.nan, "%"),
        Readout("spread of drag", mean.spread[0]),
        Readout("spread of lift", mean.spread[1]),
        Readout("drift", mean.drift),
        Readout("Strouhal", mean.strouhal),
        Readout("angle", model.attack, "°"),
        Readout("blockage", 100.0 * tunnel.blockage, "%"),
        Readout("angles measured", len(model.sweep.measured())),
        Readout("fit residual", float(series.residual[0]) if series is not None else math.nan),
        Readout("error at checks", drag_error),
        Readout("error at checks, lift", lift_error),
        Readout("drag, A", plate.drag if plate is not None else math.nan),
        Readout("drag turn, B", plate.drag_turn if plate is not None else math.nan),
        Readout("lift, C_T", plate.glide if plate is not None else math.nan),
        Readout("by its law", descents[DEFAULT], "m/s"),
        Readout("by the fit", descents[FITTED], "m/s"),
        Readout("as measured", descents[SERIES], "m/s"),
        Readout("glide, measured", glides[SERIES]),
        Readout("shapes refused", int(model.counts[0])),
        Readout("fastest", model.fastest(), "m/s"),
        Readout("volume error", tunnel.gas.report.after),
    )
