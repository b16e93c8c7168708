"""Where in the picture the tunnel, the charts and the flights stand, m of the tunnel's own."""

from __future__ import annotations

from typing import NamedTuple

from game.scenes.wind_tunnel.model import WindTunnelModel
from game.stage import Frame


class Layout(NamedTuple):
    """Frames: of the tunnel, of the curves over the angle, of the polar, of the flights, of all."""

    tunnel: Frame
    curves: Frame
    polar: Frame
    flights: Frame
    whole: Frame


def layout_of(model: WindTunnelModel) -> Layout:
    """The tunnel above the charts, the flights at their right."""
    wide, tall = model.wide, model.tall
    unit = wide / 12.0
    low = -3.5 * unit
    return Layout(
        Frame(0.0, 0.0, wide, tall),
        Frame(0.55 * unit, low, 8.0 * unit, -0.75 * unit),
        Frame(8.9 * unit, low, wide, -0.75 * unit),
        Frame(wide + 0.4 * unit, low, wide + 6.4 * unit, tall),
        Frame(-0.3 * unit, low - 0.55 * unit, wide + 6.6 * unit, tall + 0.25 * unit),
    )
