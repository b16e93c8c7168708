"""Burning gas: fuel, oxygen, temperature and soot in the cells of a grid."""

from game.physics.combustion.flames import Books, Flames, GasFuel, checked_cells

__all__ = ["Books", "Flames", "GasFuel", "checked_cells"]
