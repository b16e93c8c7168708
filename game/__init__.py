"""Carom: a physics arcade on one fixed-timestep core."""

__version__ = "0.4.0"
