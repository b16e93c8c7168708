"""Opponents that search for strokes, and matches that play themselves."""
