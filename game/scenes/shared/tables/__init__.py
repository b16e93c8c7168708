"""Billiard tables as scenes show them: the cue, the cloth, the sounds."""
