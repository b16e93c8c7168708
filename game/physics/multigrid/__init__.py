"""The pressure equation on a grid with walls: multigrid, and simpler solvers to compare it with."""

from game.physics.multigrid.equation import Found
from game.physics.multigrid.solver import SOLVERS, USUAL_TURNS, PressureSolver

__all__ = ["SOLVERS", "USUAL_TURNS", "Found", "PressureSolver"]
