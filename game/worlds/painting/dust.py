"""Puffs of dust as they are seen: discs in discs, thin at the rim, lighter above."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.worlds.members.dust import AGE, LIFE, PLACE, SIZE
from game.worlds.painting.inks import color_of

CHUNK = 160  # puffs that are painted at once, the oldest first


def draw_dust(
    canvas: Canvas, dust: Floats, inks: tuple[int, int], lift: tuple[float, float] = (0.3, 0.2), chunk: int = CHUNK
) -> None:  # fmt: skip
    """Puffs (n, DUST_WIDTH), lit and shaded ink; lift: m by which light lies beside a puff's middle."""
    if not len(dust):
        return
    age = dust[:, AGE] / dust[:, LIFE]
    radius = dust[:, SIZE] * (0.6 + 1.5 * np.sqrt(dust[:, AGE]))
    (light, shade), thick = map(color_of, inks), ((1.0, 0.05), (0.72, 0.06), (0.48, 0.08))
    for first in range(0, len(dust), chunk):
        part = slice(first, first + chunk)
        fade = float(np.mean((1.0 - age[part]) * np.minimum(1.0, 6.0 * age[part] + 0.2)))
        where = dust[part][:, PLACE]
        for (share, veil), ink in zip(thick, (shade, shade, light), strict=True):
            at = where if ink is shade else where + np.array(lift)
            canvas.discs(at, radius[part] * share, ink, veil * min(1.0, 1.6 * fade))
