"""A fire of the plane as it is seen in space: sheets of it, one behind the other, shaken as flames are.

Each sheet has its part of the depth of the gas, and shines through those before it. What is smaller than a
cell of the gas is drawn by chance: a pattern that rises with the flames moves each sheet, by more the higher
it is. That is a picture alone; nothing that is measured knows of it.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from game.arrays import Floats, Singles
from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary
from game.worlds.painting.glowing import SECOND, WAVE, GlowLook

SHEETS = 3
FINE = 288  # pixels across
PERIOD = 256  # pixels after which the pattern comes again
WAVES = ((0.17, 0.6), (0.06, 0.4))  # m, share: sizes of what the pattern is made of
RISES = (1.15, 1.4, 1.7)  # m/s at which the pattern of each sheet goes up
APART = ((-0.055, 0.05), (0.0, 0.0), (0.05, -0.045))  # m: where the upper part of each sheet stands
CALM, SHAKEN = 0.004, 0.05  # m by which sheets are moved at their foot, and at the head of flames
FOOT, HEAD = 0.15, 0.65  # m: heights between which that grows
LEAST = 1e-7  # of the brightest: less is not seen


@lean_kernel
def see_gas(look: Any, temperature: Any, soot: Any, edge: Any, seen: Any) -> None:
    """seen (ny, nx, 3), written: red light of a sheet, 1 as of a black body of look.bright. Then what share
    of light it lets through, and how thick the smoke is.

    temperature K, soot kg/m³, edge: share that is seen of each cell; all (ny, nx). Wien's law.
    """
    for j in range(seen.shape[0]):
        for i in range(seen.shape[1]):
            there, kelvin = max(soot[j, i], 0.0), temperature[j, i]
            emissivity, light = 0.0, 0.0
            if kelvin > 0.8 * look.dark:
                emissivity = -elementary.expm1(-(look.clear + there / look.opaque) * edge[j, i] / SHEETS)
                light = emissivity * elementary.exp(-SECOND / WAVE * (1.0 / kelvin - 1.0 / look.bright))
            seen[j, i, 0], seen[j, i, 1] = light, 1.0 - emissivity
            seen[j, i, 2] = min(there / look.thick, look.most) * edge[j, i]


@lean_kernel
def lay_sheets(look: Any, seen: Any, shake: Any, rows: Any, moves: Any, veil: Any) -> None:
    """veil (f ny, f nx, 2) float32, written: how thick the smoke and how bright the flames are, 0 to 1.

    seen: of `see_gas`. shake (PERIOD, PERIOD, 2): the pattern. rows (f ny, 2): by how many pixels of the veil
    it moves each row, and share of ``moves`` there. moves (SHEETS, 3): pixels along and up, and how far the
    pattern has risen. Bright is the share on the way from look.dark to look.bright of the temperature of the
    black body that is as bright.
    """
    ny, nx = seen.shape[0], seen.shape[1]
    fine = veil.shape[1] / nx
    for y in range(veil.shape[0]):
        for x in range(veil.shape[1]):
            light, thick = 0.0, 0.0
            for k in range(SHEETS):
                n = shake[(y - int(moves[k, 2])) % PERIOD, (x + 83 * k) % PERIOD]
                px = x + rows[y, 0] * n[0] - rows[y, 1] * moves[k, 0]
                py = y + rows[y, 0] * n[1] - rows[y, 1] * moves[k, 1]
                u = min(max((px + 0.5) / fine - 0.5, 0.0), nx - 1.001)
                v = min(max((py + 0.5) / fine - 0.5, 0.0), ny - 1.001)
                i, j = int(u), int(v)
                f, g = u - i, v - j
                a, b, c, d = (1.0 - g) * (1.0 - f), (1.0 - g) * f, g * (1.0 - f), g * f
                low, right, high, both = seen[j, i], seen[j, i + 1], seen[j + 1, i], seen[j + 1, i + 1]
                own = a * low[0] + b * right[0] + c * high[0] + d * both[0]
                through = a * low[1] + b * right[1] + c * high[1] + d * both[1]
                light = own + through * light
                thick += a * low[2] + b * right[2] + c * high[2] + d * both[2]
            share = 0.0
            if light > LEAST:
                kelvin = 1.0 / (1.0 / look.bright - WAVE / SECOND * elementary.log(light))
                share = min(max((kelvin - look.dark) / (look.bright - look.dark), 0.0), 1.0)
            veil[y, x, 0] = min(thick / SHEETS, 1.0) * (1.0 - min(3.0 * share, 1.0))
            veil[y, x, 1] = share


@lru_cache(maxsize=1)
def pattern(fine: int) -> Floats:
    """(PERIOD, PERIOD, 2) of soft patches, about -1 to 1, without seams; fine: pixels in a metre."""
    random, found = np.random.default_rng(62), np.zeros((PERIOD, PERIOD, 2))
    waves = np.fft.fftfreq(PERIOD, 1.0 / fine)
    square = elementary.square(waves)[:, None] + elementary.square(waves)[None]
    for size, share in WAVES:
        for way in range(2):
            soft = elementary.square(elementary.square(1.0 / (1.0 + 0.25 * size * size * square)))
            kept = np.fft.fft2(random.standard_normal((PERIOD, PERIOD))) * soft
            part = np.real(np.fft.ifft2(kept))
            found[..., way] += share * part / (2.0 * np.std(part)) * (1.0 if way == 0 else 1.6)
    return found


class Sheets:
    """Sees a gas of cells (ny, nx), ``cell`` m wide and above a floor, as sheets."""

    def __init__(self, look: GlowLook, shape: tuple[int, int], cell: float):
        self.look = look
        self.fine = max(round(FINE / shape[1]), 1)
        self.per_metre = self.fine / cell
        self._seen = np.zeros((*shape, 3))
        self._veil = np.zeros((shape[0] * self.fine, shape[1] * self.fine, 2), np.float32)
        up = (np.arange(self._veil.shape[0]) + 0.5) / self.per_metre
        part = np.clip((up - FOOT) / (HEAD - FOOT), 0.0, 1.0)
        self._rows = np.column_stack([(CALM + (SHAKEN - CALM) * part) * self.per_metre, part])

    def veil(self, temperature: Floats, soot: Floats, edge: Floats, time: float) -> Singles:
        """(f ny, f nx, 2) as canvases take it, at a time (s); good until the next call."""
        see_gas(self.look, temperature, soot, edge, self._seen)
        moves = np.array([
            (x * self.per_metre, y * self.per_metre, float(int(rise * time * self.per_metre) % PERIOD))
            for (x, y), rise in zip(APART, RISES, strict=True)
        ])  # fmt: skip
        lay_sheets(self.look, self._seen, pattern(round(self.per_metre)), self._rows, moves, self._veil)
        return self._veil


def warm_up_sheets() -> None:
    """Compile what sheets are seen by."""
    cells, look = np.full((4, 4, 4), 900.0), GlowLook(500.0, 1000.0, 0.5, 1.0, 1.0, 1.0, 1.0)
    Sheets(look, (4, 4), 0.5).veil(cells[..., 0], cells[..., 3], np.ones((4, 4)), 0.0)
