"""What scenes that are heard have in common."""

from __future__ import annotations

REMEMBERED_S = 0.4  # s that an impact stays in a line of sounds: more than the longest gap that is heard


def pan_of(y: float, length: float) -> float:
    """Left (-1) to right (1) across the window of a place ``y`` m along a table that lies on its side."""
    return max(-1.0, min(1.0, 1.6 * (y / length - 0.5)))
