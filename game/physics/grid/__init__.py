"""The staggered grid that gas, and later water, lives on: layout, sides, sampling, solids in it."""

from game.physics.grid.borders import KINDS, SIDES, Border, Borders, Edges, edges_of
from game.physics.grid.layout import PAD, Grid

__all__ = ["KINDS", "PAD", "SIDES", "Border", "Borders", "Edges", "Grid", "edges_of"]
