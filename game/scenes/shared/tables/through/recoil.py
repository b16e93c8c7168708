"""The recoil of the picture: it gives way along a person's stroke, and comes back."""

from __future__ import annotations

import math
from typing import Any

from game.ui.canvas.canvas import Canvas

LASTS_S = 0.22  # s after the hit
FADES_S = 0.05  # s, time constant
FARTHEST = 5.0  # design px, of a stroke at LOUD m/s of the cue
LOUD = 6.0  # m/s


def recoil(cue_speed: float, since_s: float) -> float:
    """How far the picture gives way, design px, so long after a hit by a cue of that speed, m/s."""
    if not 0.0 <= since_s < LASTS_S:
        return 0.0
    size = FARTHEST * min(cue_speed / LOUD, 1.0)
    return size * math.exp(-since_s / FADES_S) * math.cos(math.pi * since_s / FADES_S)


def draw_recoil(canvas: Canvas, parameters: Any, stroke: Any, since_s: float) -> None:
    """Shift what has been drawn, unless the player wants none or the theme less motion."""
    if not parameters.recoil or canvas.look.less_motion:
        return
    size = recoil(stroke.cue_speed, since_s) * canvas.k
    angle = canvas.camera.angle_to_screen(stroke.azimuth)
    x, y = round(size * math.cos(angle)), round(size * math.sin(angle))
    if x or y:
        place = canvas.rect.clip(canvas.surface.get_rect())
        canvas.surface.subsurface(place).scroll(x, y)
