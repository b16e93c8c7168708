"""Colours of sea and sky, by day and late, in fair weather and in a storm."""

from __future__ import annotations

from game.worlds.painting.clouds import Sun, Weather
from game.worlds.painting.sea.cuts import Light, Triple

# by day and late; of each fair weather and a storm
SKIES = (
    (
        Weather(0x3E82C4, 0xD3E4EA, 0xFFFFFF, 0xA9BCCB, 0.42, 0.8),
        Weather(0x5B6670, 0xA3ADB0, 0xA7AFB3, 0x596570, 0.98, 0.3),
    ),
    (
        Weather(0x2A3560, 0xF3A766, 0xFFC79A, 0x5E4C6C, 0.44, 0.8),
        Weather(0x3A4350, 0x8F8C8A, 0x878A92, 0x343B47, 0.98, 0.3),
    ),
)
SUNS = (Sun(0.74, 0.52, 0xFFF2D0, 0.55), Sun(0.74, 0.2, 0xFFB060, 0.85))
LIGHTS = (
    (
        Light((8, 52, 84), (38, 138, 140), (255, 246, 222), (246, 250, 252), (0.36, 0.44, 0.82), 1.2),
        Light((20, 46, 58), (52, 104, 104), (190, 196, 196), (226, 232, 234), (0.36, 0.6, 0.71), 0.1),
    ),
    (
        Light((12, 28, 50), (40, 92, 100), (255, 178, 96), (244, 214, 190), (0.36, 0.16, 0.92), 1.5),
        Light((17, 35, 46), (44, 88, 92), (176, 168, 160), (206, 212, 216), (0.36, 0.5, 0.79), 0.1),
    ),
)


def light_of(late: bool, storm: float, sun: Triple) -> Light:
    """Between fair weather (0) and a storm (1). sun: its direction in fair weather."""
    fair, bad = LIGHTS[late]

    def mixed(one: Triple, other: Triple) -> Triple:
        red, green, blue = (a + (b - a) * storm for a, b in zip(one, other, strict=True))
        return red, green, blue

    deep, thin, shine, foam = (mixed(one, other) for one, other in zip(fair[:4], bad[:4], strict=True))
    to = mixed(sun, bad.to)
    return Light(deep, thin, shine, foam, to, fair.glint + (bad.glint - fair.glint) * min(1.5 * storm, 1.0))
