"""Carom: a physics arcade on one fixed-timestep core."""

__version__ = "0.2.0"
