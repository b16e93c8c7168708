"""Guided lessons at the tables: what one teaches, what it is worth, which follows which."""
