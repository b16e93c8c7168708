"""Collision detection that can be interrupted: space-time bounds, and trees of circles (Hubbard 1993, 1996)."""
