"""Wind as a formula: an even wind that the ground slows, and gusts that come, go and travel.

A gust is the stream function psi = (S_x Y - S_y X + K L) exp(-(X² + Y²)/(2 L²)) about its middle, times
sin²(pi t/T) while it lasts: air that blows with S at the middle and comes back round both sides, and turns
with K. So it has no divergence. Its mirror image below the ground goes with it, so no wind blows through
the ground. Velocity, gradient and rate are exact, whatever the place.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.plates import flight

AT_X, AT_Y, BEGINS, LASTS, GOES_X, GOES_Y, SIZE, BLOWS_X, BLOWS_Y, TURNS = range(10)
GUST = 10
MOST_GUSTS = 64
SHELTER_LEFT, SHELTER_RIGHT, SHELTER_TOP, SHELTER_REACH, SHELTER_SLANT = range(5)  # m; m/m
SHELTER = 5
FARTHEST, FASTEST = 1e6, 1e3  # m, m/s


class Gust(NamedTuple):
    """One gust: middle (m) at the time it begins (s), s it lasts, velocity of the middle (m/s), size L (m),
    wind at its middle (m/s), speed of its turning K (m/s, the peak is K/sqrt(e))."""

    place: tuple[float, float]
    begins: float
    lasts: float
    goes: tuple[float, float] = (0.0, 0.0)
    size: float = 1.0
    blows: tuple[float, float] = (0.0, 0.0)
    turns: float = 0.0

    def row(self) -> tuple[float, ...]:
        """(GUST,) numbers. ValueError, naming the field, for nonsense."""
        for name, value in self._asdict().items():
            if (
                not all(map(math.isfinite, np.atleast_1d(value)))
                or max(np.abs(np.atleast_1d(value))) > FARTHEST
            ):
                raise ValueError(f"gust.{name} = {value!r}: expected finite numbers within {FARTHEST:g}")
        for name in ("lasts", "size"):
            if not getattr(self, name) >= 1e-3:
                raise ValueError(f"gust.{name} = {getattr(self, name)!r}: expected at least 0.001")
        if max(map(abs, (*self.blows, self.turns))) > FASTEST:
            raise ValueError(f"gust.blows = {self.blows!r}: expected at most {FASTEST:g} m/s")
        return (*self.place, self.begins, self.lasts, *self.goes, self.size, *self.blows, self.turns)


@inner_kernel
def one_gust(air, i, away, goes, size, blows, share, change):
    """Add a gust or its image to the wind at a place ``away`` (m) from its middle.

    goes: of the middle, m/s; blows: wind at it and turning, m/s; share of its strength, and its rate 1/s.
    """
    goes_x, goes_y = goes
    sx, sy, turns = blows
    rx, ry, per = away[0], away[1], 1.0 / (size * size)
    exponent = 0.5 * (rx * rx + ry * ry) * per
    if exponent > 40.0:
        return
    e = elementary.exp(-exponent)
    p = sx * ry - sy * rx + turns * size
    wx, wy = e * (sx - p * ry * per), e * (sy + p * rx * per)
    xx = e * (sy * ry * per - rx * per * (sx - p * ry * per))
    xy = -e * (ry * per * (sx - p * ry * per) + (sx * ry + p) * per)
    yx = e * ((p - sy * rx) * per - rx * per * (sy + p * rx * per))
    air[flight.WX, i] += share * wx
    air[flight.WY, i] += share * wy
    air[flight.WX_X, i] += share * xx
    air[flight.WX_Y, i] += share * xy
    air[flight.WY_X, i] += share * yx
    air[flight.WY_Y, i] -= share * xx
    air[flight.WX_T, i] += change * wx - share * (goes_x * xx + goes_y * xy)
    air[flight.WY_T, i] += change * wy - share * (goes_x * yx - goes_y * xx)


@lean_kernel
def sample_wind(places, gusts, count, shelters, even, time, air):
    """Write the wind (WIND, n) at places: rows 0 and 1 of (k, n) m.

    gusts (m, GUST), the first ``count``; shelters (k, SHELTER): between walls that lean outwards by a
    slant, where the wind dies away below their top by e within each reach; even: wind (m/s) far above,
    height (m) within which the ground slows it (0: nowhere), height of the ground (m), 1 if the ground
    mirrors gusts.
    """
    speed, layer, floor, mirrors = even
    for i in range(places.shape[1]):
        x, y = places[0, i], places[1, i]
        for k in range(flight.WIND):
            air[k, i] = 0.0
        if layer > 0.0:
            e = elementary.exp(-max(y - floor, 0.0) / layer)
            air[flight.WX, i] = speed * (1.0 - e)
            air[flight.WX_Y, i] = speed * e / layer if y > floor else 0.0
        else:
            air[flight.WX, i] = speed
        for g in range(count):
            gust = gusts[g]
            since = time - gust[BEGINS]
            if since <= 0.0 or since >= gust[LASTS]:
                continue
            turn = math.pi / gust[LASTS]
            rises = elementary.sin(turn * since)
            share, change = rises * rises, 2.0 * turn * rises * elementary.cos(turn * since)
            cx, cy = gust[AT_X] + gust[GOES_X] * since, gust[AT_Y] + gust[GOES_Y] * since
            goes, size = (gust[GOES_X], gust[GOES_Y]), gust[SIZE]
            blows = (gust[BLOWS_X], gust[BLOWS_Y], gust[TURNS])
            one_gust(air, i, (x - cx, y - cy), goes, size, blows, share, change)
            if mirrors > 0.5:
                away = (x - cx, y - 2.0 * floor + cy)
                goes, blows = (goes[0], -goes[1]), (blows[0], -blows[1], -blows[2])
                one_gust(air, i, away, goes, size, blows, share, change)
        for k in range(shelters.shape[0]):
            below = shelters[k, SHELTER_TOP] - y
            lean = shelters[k, SHELTER_SLANT] * below
            if below > 0.0 and shelters[k, SHELTER_LEFT] + lean < x < shelters[k, SHELTER_RIGHT] - lean:
                left = elementary.exp(-below / shelters[k, SHELTER_REACH])
                for row in range(flight.WIND):
                    air[row, i] *= left
                air[flight.WX_Y, i] += air[flight.WX, i] / shelters[k, SHELTER_REACH]
                air[flight.WY_Y, i] += air[flight.WY, i] / shelters[k, SHELTER_REACH]


class GustyWind:
    """A wind and its gusts, those that are over forgotten.

    wind m/s, layer m, shelters: see `sample_wind`; floor: height of the ground (m), None: none. A `Field`.
    """

    def __init__(
        self, wind: float = 0.0, layer: float = 0.0, floor: float | None = 0.0, shelters: ArrayLike = ()
    ):
        self.floor = floor
        self.shelters: Floats = np.array(shelters, dtype=np.float64).reshape(-1, SHELTER)
        if not np.isfinite(self.shelters).all() or (self.shelters[:, SHELTER_REACH] <= 0.0).any():
            raise ValueError("shelters: expected left, right, top, a reach above 0, m, and a slant")
        self.gusts: Floats = np.zeros((MOST_GUSTS, GUST))
        self.count = 0
        self.set_wind(wind, layer)

    def set_wind(self, wind: float, layer: float = 0.0) -> None:
        """Another even wind (m/s) from now on; ValueError for nonsense."""
        if not -FASTEST <= wind <= FASTEST:
            raise ValueError(f"wind = {wind!r}: expected -{FASTEST:g} to {FASTEST:g} m/s")
        if not 0.0 <= layer <= FARTHEST:
            raise ValueError(f"layer = {layer!r}: expected 0 to {FARTHEST:g} m")
        self.wind, self.layer = float(wind), float(layer)

    def add(self, gust: Gust) -> None:
        """One more gust; without a place the one that began first makes way."""
        row = gust.row()
        if self.count == MOST_GUSTS:
            self._drop(int(np.argmin(self.gusts[: self.count, BEGINS])))
        self.gusts[self.count] = row
        self.count += 1

    def forget(self, time: float) -> None:
        """Drop the gusts that are over at a time (s)."""
        for k in range(self.count - 1, -1, -1):
            if self.gusts[k, BEGINS] + self.gusts[k, LASTS] <= time:
                self._drop(k)

    def _drop(self, k: int) -> None:
        self.gusts[k : self.count - 1] = self.gusts[k + 1 : self.count]
        self.count -= 1
        self.gusts[self.count] = 0.0

    def feel(self, places: Floats, time: float, air: Floats) -> None:
        """Write wind, gradient and rate (WIND, n) at places (rows x and y of (k, n) m)."""
        ground = 0.0 if self.floor is None else self.floor
        even = (self.wind, self.layer, ground, 0.0 if self.floor is None else 1.0)
        sample_wind(places, self.gusts, self.count, self.shelters, even, float(time), air)

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Wind (n, 2) m/s at points (n, 2) m."""
        places = np.ascontiguousarray(np.asarray(points, dtype=np.float64).reshape(-1, 2).T)
        air = np.zeros((flight.WIND, places.shape[1]))
        self.feel(places, time, air)
        return np.ascontiguousarray(air[:2].T)
