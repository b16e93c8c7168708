"""A wind tunnel on the grid of the gas: forces on any outline, measured twice, and flight by them."""

from game.physics.tunnel.effects import TUNNEL
from game.physics.tunnel.fit import PlateFit, SeriesFit, fit_plate, fit_series
from game.physics.tunnel.flight import DataFlight
from game.physics.tunnel.outlines import SHAPES, TunnelOutline, outline_of, shape_named
from game.physics.tunnel.sweep import Sweep, SweepPlan
from game.physics.tunnel.tunnel import Forces, Tunnel, TunnelSettings, TunnelState

__all__ = [
    "SHAPES",
    "TUNNEL",
    "DataFlight",
    "Forces",
    "PlateFit",
    "SeriesFit",
    "Sweep",
    "SweepPlan",
    "Tunnel",
    "TunnelOutline",
    "TunnelSettings",
    "TunnelState",
    "fit_plate",
    "fit_series",
    "outline_of",
    "shape_named",
]
