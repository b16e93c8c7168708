"""Stable fluids as printed, in 1999 and in 2003."""

from game.physics.stable_fluids.fluid import PAPERS, PrintedFluid, PrintedState

__all__ = ["PAPERS", "PrintedFluid", "PrintedState"]
