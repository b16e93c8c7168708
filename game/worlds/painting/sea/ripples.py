"""Slopes of the short waves of a sea, as a tile that repeats: what is too fine for cuts through the water.

A tile holds whole waves only, so each wave vector moves to the nearest of its lattice (Tessendorf 2001). How
steep the finest are, the wind says: Cox and Munk (1954) measured the mean square of a sea's slopes.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import lean_kernel

SIDE, CELLS, LEVELS = 8.0, 256, 8  # m, cells along each side, levels: each half as fine across as the last
LONGEST = 2.4  # m: longer waves are seen in the cuts
FINE = 0.42  # m: shorter ones are none of the sea's own, and are added
WAVES = 1400  # of those
UNIT = 2.0**-13  # of a slope in a tile
TENSION = 7.3e-5  # m³/s², of water over its density
STILL, BY_WIND, FINE_SHARE = 0.001, 0.00512, 0.55  # Cox and Munk 1954; of it in waves that a tile can hold


def mean_square_slope(wind: float) -> float:
    """Of a sea under a wind, m/s (Cox and Munk 1954, clean water)."""
    return STILL + BY_WIND * wind


def is_short(rows: Floats) -> NDArray[np.bool_]:
    """(n,) whether waves (n, 5), see `Sea`, are those of the tile."""
    return np.asarray(np.hypot(rows[:, 1], rows[:, 2]) > math.tau / LONGEST, dtype=np.bool_)


@lean_kernel
def halve(found, tiles):
    """found (n, n, 2), slopes by x and z; tiles (l, n, n, 2): in UNITs, the first columns of each level the
    means of two of the level before, and from the third on of two rows as well."""
    for i in range(tiles.shape[1]):
        for j in range(tiles.shape[2]):
            for c in range(2):
                tiles[0, i, j, c] = min(max(found[i, j, c] / UNIT, -32000.0), 32000.0)
    for level in range(1, tiles.shape[0]):
        wide = 1 if level == 2 else 0
        for i in range(tiles.shape[1] >> (1 if level > 1 else 0)):
            for j in range(tiles.shape[2] >> level):
                for c in range(2):
                    both = tiles[level - 1, i << wide, 2 * j, c] + tiles[level - 1, i << wide, 2 * j + 1, c]
                    if wide:
                        both += tiles[1, 2 * i + 1, 2 * j, c] + tiles[1, 2 * i + 1, 2 * j + 1, c]
                        both >>= 1
                    tiles[level, i, j, c] = both >> 1


class Ripples:
    """``tiles`` (LEVELS, CELLS, CELLS, 2): slopes along x and z in UNITs, by x and z of a place.

    ``rough`` (LEVELS + 1,): mean squares of the slope that each has lost, the last all of it.
    """

    def __init__(self) -> None:
        self.tiles: NDArray[np.int16] = np.zeros((LEVELS, CELLS, CELLS, 2), np.int16)
        self.rough: Floats = np.zeros(LEVELS + 1)
        random = np.random.default_rng(54)
        least = math.tau / SIDE
        size = np.exp(random.uniform(math.log(SIDE / FINE), math.log(0.42 * CELLS), WAVES))
        turn = random.uniform(-math.pi, math.pi, WAVES)
        whole = np.rint(np.stack([size * np.cos(turn), size * np.sin(turn)])).astype(np.int64)
        whole[
            :, (whole[1] < 0) | ((whole[1] == 0) & (whole[0] < 0))
        ] *= -1  # a half of the lattice, each once
        self._whole = np.unique(whole, axis=1)
        k = least * np.hypot(*self._whole)
        self._numbers, self._turn = k, np.arctan2(self._whole[1], self._whole[0])
        self._rates = np.sqrt(9.81 * k + TENSION * k * k * k)
        self._phases = random.uniform(0.0, math.tau, len(k))
        self._spectrum = np.zeros((CELLS, CELLS), np.complex64)

    def make(self, rows: Floats, wind: tuple[float, float], sailed: float, time: float) -> None:
        """The tile at a time (s) beside a boat that has sailed so far (m). rows (n, 5) of a `Sea`; wind: m/s
        along x and z."""
        strong, heading = math.hypot(*wind), math.atan2(wind[1], wind[0])
        short = rows[is_short(rows)]
        whole = np.rint(short[:, 1:3].T * (SIDE / math.tau)).astype(np.int64)
        seen = 0.5 * float(np.sum(rows[:, 0] ** 2 * (rows[:, 1] ** 2 + rows[:, 2] ** 2)))
        rest = FINE_SHARE * max(mean_square_slope(strong) - 0.6 * seen, STILL)
        with_wind = np.cos(self._turn - heading)
        share = with_wind * with_wind
        high = np.sqrt(2.0 * rest * share / float(np.sum(share))) / self._numbers
        along = self._whole[0] * (math.tau / SIDE)
        phases = self._phases + along * math.fmod(sailed, SIDE) - np.copysign(self._rates, with_wind) * time
        self._spectrum[:] = 0.0
        self._add(self._whole, high, phases)
        for n in range(len(short)):  # two may come to the same place of the lattice
            self._add(whole[:, n : n + 1], short[n : n + 1, 0], short[n : n + 1, 4])
        found = np.fft.ifft2(self._spectrum)
        halve(found.view(np.float32).reshape(CELLS, CELLS, 2), self.tiles)
        powers = []
        for n, tile in enumerate(self.tiles):
            part = UNIT * tile[: CELLS >> (n > 1) : 4, : CELLS >> n]
            powers.append(2.0 * float(np.mean(part * part)))
        self.rough[:] = np.maximum(powers[0] - np.array([*powers, 0.0]), 0.0)

    def _add(self, whole: Longs, high: Floats, phases: Floats) -> None:
        """Waves that stand so many times (2, n) in the tile along x and z, no two alike."""
        i, j = whole
        half = (0.5 * CELLS * CELLS) * high * np.exp(1j * phases)
        slopes = 1j * (i + 1j * j) * (math.tau / SIDE)  # along x, and as the imaginary part along z
        self._spectrum[i % CELLS, j % CELLS] += slopes * half
        self._spectrum[-i % CELLS, -j % CELLS] -= slopes * np.conj(half)
