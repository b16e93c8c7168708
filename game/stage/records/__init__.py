"""Recordings: what was done to a scene, kept and played again."""
