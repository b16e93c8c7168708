"""Collision detection that can be interrupted: space-time bounds, trees of circles (Hubbard 1993, 1996)."""
