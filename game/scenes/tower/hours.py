"""Light on the tower: by day that of the sun, by night that of lamps at its foot and of the moon."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.scenes.tower.air import LAMP_RISES
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.inks import channels, packed


class Hour(NamedTuple):
    """Colours 0xRRGGBB of an hour; its sky from above to the horizon."""

    sky: tuple[int, int, int]
    sun: int
    towns: tuple[int, int, int]
    ground: tuple[int, int]
    slab: int
    column: int
    rubble: tuple[int, int]
    edge: int
    glass: tuple[int, int]  # no lamp is on: the house is empty; some panes mirror the sky
    room: int  # behind the panes
    dust: tuple[int, int]
    sheen: tuple[int, int]  # added where some, where all of the light falls on dust
    lamp: int  # colour of the lamps at the foot
    lamps: float  # their light at the foot, beside that of the hour
    mirrors: float  # share of light that the street mirrors: by night it is wet, as dust is laid by water


DAY = Hour(
    (0x8FB7DA, 0xC9DDE8, 0xF6E7CF), 0xFFF6DC, (0xBCC9D3, 0xA9BCCB, 0x8499AB), (0x8D9A78, 0x5E6B52),
    0xB9B2A6, 0x9C968C, (0x8A847A, 0xA59E92), 0x4A463F, (0x8FB4C8, 0xBFD8E2), 0x59616A, (0xE6DCCB, 0xA99F90),
    (0x1C1915, 0x38322A), 0xFFFFFF, 0.0, 0.0,
)  # fmt: skip
NIGHT = Hour(
    (0x0B122C, 0x1A2347, 0x74485A), 0xF3D8B4, (0x33304F, 0x20263F, 0x121727), (0x23252E, 0x0E1016),
    0x4E4F5A, 0x42434E, (0x3B3B44, 0x484750), 0x07080C, (0x1D2B44, 0x31456A), 0x0B0E18, (0x8F857E, 0x413B40),
    (0x4E3F33, 0xB48F68), 0xFFD9A0, 1.0, 0.2,
)  # fmt: skip


def hour_of(canvas: Canvas) -> Hour:
    """By the theme."""
    color = canvas.color("stage")
    return NIGHT if color.r + color.g + color.b < 384 else DAY


def lamplight(hour: Hour, heights: Any) -> Any:
    """Light of the lamps at heights (m), beside that of the hour."""
    share = np.maximum(np.asarray(heights), 0.0) / LAMP_RISES
    return hour.lamps / (1.0 + share * share) ** 0.75


def lit(hour: Hour, inks: Longs, heights: Floats) -> Longs:
    """Colours (n,) of what stands at heights (n,) m, in the light of the lamps."""
    if hour.lamps == 0.0:
        return inks
    light = channels(hour.lamp) / 255.0 * (1.9 * lamplight(hour, heights))[:, None]
    return packed(np.minimum(channels(inks) * (1.0 + light), 255.0))
