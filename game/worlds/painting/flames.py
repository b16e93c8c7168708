"""Burning gas as it is seen: hot soot shines, cold soot is smoke."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats, Longs, Singles
from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.glowing import SECOND, WAVE, WAVES, GlowLook

HEAT_STOPS = ((0.0, "stage"), (0.25, "violet"), (0.55, "vermilion"), (0.8, "amber"), (1.0, "yellow"))
FIRELIGHT = 0xFF8A30
WHITE = 6500.0  # K, of daylight, which is white
SENSED, EXPOSURE, GAMMA = 0.3, 4.5, 2.2  # power of brightness, strength of the brightest, of the screen
STOPS = 24  # of a table of colours


class FlameLook(NamedTuple):
    """When gas is seen. glows, brightest: K from which it begins to, and is; bare: brightness of hot gas
    without soot; shining: kg/m³ of soot with which a flame is seen in full; thick: kg/m³ of soot over which
    smoke would hide all, and most: what it hides at most; burns: K from which gas counts as flame.
    """

    glows: float
    brightest: float
    bare: float
    shining: float
    thick: float
    most: float
    burns: float


@lean_kernel
def see_gas(look: Any, temperature: Any, soot: Any, edge: Any, veil: Any) -> None:
    """veil (ny, nx, 2) float32, written: how thick the smoke and how bright the flames are, 0 to 1.

    temperature K, soot kg/m³, edge: share that is seen of each cell; all (ny, nx).
    """
    for j in range(veil.shape[0]):
        for i in range(veil.shape[1]):
            there = max(soot[j, i], 0.0)
            warm = min(max((temperature[j, i] - look.glows) / (look.brightest - look.glows), 0.0), 1.0)
            full = look.bare + (1.0 - look.bare) * min(there / look.shining, 1.0)
            veil[j, i, 1] = warm * full * edge[j, i]
            thick = min(there / look.thick, look.most)
            veil[j, i, 0] = thick * (1.0 - min(2.0 * warm, 1.0)) * edge[j, i]


def warm_up_gas() -> None:
    """Compile what gas is seen by."""
    cells, veil = np.zeros((2, 2, 5)), np.zeros((2, 2, 2), np.float32)
    look = FlameLook(1.0, 2.0, 0.5, 1.0, 1.0, 1.0, 1.0)
    see_gas(look, cells[..., 0], cells[..., 3], np.ones((2, 2)), veil)


def flame_height(look: FlameLook | GlowLook, temperature: Floats, cell: float) -> float:
    """m, of the highest row of gas that is seen to burn; cell: m."""
    rows = np.flatnonzero(np.max(temperature, axis=1) > look.burns)
    return float(rows[-1] + 1) * cell if len(rows) else 0.0


@lru_cache(maxsize=8)
def glow_stops(dark: float, bright: float) -> tuple[tuple[float, pygame.Color], ...]:
    """Stops from 0 to 1: black bodies of temperatures from ``dark`` to ``bright``, K.

    Each channel is Planck's radiance at its wavelength over that of daylight; Wien's law is near enough. How
    bright it seems goes with a power of the luminance (Stevens 1957). Light of strength x is shown as
    1 - exp(-x), as film takes it on.
    """
    stops = [(0.0, pygame.Color(0, 0, 0))]
    for k in range(1, STOPS + 1):
        share = k / STOPS
        kelvin = dark + (bright - dark) * share
        seen = EXPOSURE * math.exp(-SENSED * SECOND / WAVE * (1.0 / kelvin - 1.0 / bright))
        seen *= min(1.0, 5.0 * share)  # to black at the dark end
        colder = 1.0 / kelvin - 1.0 / WHITE
        channels = [seen * math.exp(-SECOND * (1.0 / wave - 1.0 / WAVE) * colder) for wave in WAVES]
        inks = [round(255.0 * (1.0 - math.exp(-x)) ** (1.0 / GAMMA)) for x in channels]
        stops.append((share, pygame.Color(*inks)))
    return tuple(stops)


def glow_inks(shares: Floats, dark: float, bright: float) -> Longs:
    """Colours 0xRRGGBB (...) of `glow_stops` at shares (...) 0 to 1."""
    stops = glow_stops(dark, bright)
    places = [place for place, _ in stops]
    found = [np.interp(shares, places, [color[k] for _, color in stops]) for k in range(3)]
    red, green, blue = (np.asarray(channel + 0.5).astype(np.int64) for channel in found)
    return np.asarray(red << 16 | green << 8 | blue)


def draw_firelight(
    canvas: Canvas, veil: Singles, half: float, blocks: int, least: float, size: float, share: float
) -> None:
    """The light about flames, as soft glows of so many blocks across a veil (ny, nx, 2) over 2 ``half`` m.

    least: light of a block that shows none; size: of a glow, in blocks; share: of its light.
    """
    ny, nx = veil.shape[:2]
    block = max(nx // blocks, 1)
    rows, columns = ny // block, nx // block
    light = veil[: rows * block, : columns * block, 1].reshape(rows, block, columns, block).mean(axis=(1, 3))
    j, i = np.nonzero(light > least)
    if len(j):
        step = 2.0 * half / nx * block
        at = np.stack([-half + (i + 0.5) * step, (j + 0.5) * step], axis=1)
        inks = np.full(len(j), FIRELIGHT, dtype=np.uint32)
        canvas.soft_glow(at, np.full(len(j), size * step), inks, share * np.minimum(light[j, i], 0.8))
