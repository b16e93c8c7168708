"""Kinds of strokes that are counted for ever."""

POT, BREAK, POINT = KINDS = ("pot", "break", "point")
