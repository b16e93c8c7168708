"""How a liquid is stepped."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from game.settings import Number, Option

CARRIERS = ("pic-flip", "apic")
SURFACES = ("ghost", "plain")
MULTIGRID, GRADIENTS = "multigrid", "conjugate-gradients"


class LiquidSettings(NamedTuple):
    """Numbers and choices of the method."""

    gravity: Annotated[float, Number(-100.0, 100.0, help="downwards", unit="m/s²")] = 9.81
    carrier: Annotated[int, Option(CARRIERS, help="how speeds pass between particles and cells")] = 1
    flip: Annotated[float, Number(0.0, 1.0, help="share of FLIP beside PIC")] = 0.95
    surface: Annotated[int, Option(SURFACES, help="where the pressure is 0: at the surface, or in air")] = 0
    courant: Annotated[float, Number(0.1, 2.0, help="cells that a particle crosses in a part step")] = 1.0
    keeping: Annotated[
        float, Number(0.0, 1.0, help="share of the crowding that one part step takes away")
    ] = 1.0
    residual: Annotated[float, Number(1e-12, 0.1, help="of the pressure, beside its right side")] = 1e-3
    turns: Annotated[int, Number(1, 1000, help="of the solver, at most", whole=True)] = 200
