"""Puffs of dust as they are seen: discs in discs, thin at the rim, lighter above."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.inks import color_of

CHUNK = 160  # puffs that are painted at once, the oldest first


def draw_dust(
    canvas: Canvas,
    puffs: tuple[Floats, Floats, Floats],
    inks: tuple[int, int],
    lift: tuple[float, float] = (0.3, 0.2),
    chunk: int = CHUNK,
) -> None:
    """Puffs: places (n, 2) m, shares of their life that are over and radii m, (n,). inks: lit and in shade;
    lift: m by which light lies beside a puff's middle.
    """
    places, ages, radii = puffs
    (light, shade), thick = map(color_of, inks), ((1.0, 0.05), (0.72, 0.06), (0.48, 0.08))
    for first in range(0, len(places), chunk):
        part = slice(first, first + chunk)
        fade = float(np.mean((1.0 - ages[part]) * np.minimum(1.0, 6.0 * ages[part] + 0.2)))
        for (share, veil), ink in zip(thick, (shade, shade, light), strict=True):
            at = places[part] if ink is shade else places[part] + np.array(lift)
            canvas.discs(at, radii[part] * share, ink, veil * min(1.0, 1.6 * fade))
