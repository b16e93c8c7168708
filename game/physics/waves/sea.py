"""A sea of many plane waves on deep water, in two dimensions: each runs at the speed of its own length.

A wave of wave vector k swings at the rate w² = g |k| (Airy 1845, deep water). How high each is, a spectrum
says: a sea that a wind has raised to its full (Pierson, Moskowitz 1964), or one that it has blown over a
limited fetch only (JONSWAP: Hasselmann and others 1973). Their directions are spread about that of the wind.

Phases are kept at one point of reference, which may move. So numbers do not grow however far it goes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.kernels import elementary, elementwise

PHILLIPS, STEEP_PM = 8.1e-3, 0.74  # Pierson and Moskowitz 1964, by the wind at 19.5 m
PEAKED, NARROW, WIDE, STEEP_J = 3.3, 0.07, 0.09, 1.25  # Hasselmann and others 1973
GOLDEN = 0.6180339887498949
SHORTEST, LONGEST = 0.35, 320.0  # m
MODELS = ("jonswap", "pierson-moskowitz")
AMPLITUDE, ALONG, ACROSS, RATE, PHASE = range(5)  # columns of a wave: m, 1/m, 1/m, rad/s, rad
COLUMNS = 5
LEVEL, SLOPE_X, SLOPE_Z, RISE, LIFT = range(5)  # columns of the water at a point: m, 1, 1, m/s, m/s²


class SeaState(NamedTuple):
    """rows (n, COLUMNS) of waves."""

    rows: Floats


def pierson_moskowitz(rates: Floats, wind: float, gravity: float = 9.81) -> Floats:
    """m² s of a full sea at rates (n,) rad/s, for a wind in m/s."""
    if wind <= 0.0 or gravity <= 0.0:
        return np.zeros_like(rates)
    cut = np.minimum(STEEP_PM * elementwise.power(gravity / (wind * rates), 4.0), 700.0)
    return np.asarray(PHILLIPS * gravity * gravity * elementwise.power(rates, -5.0) * elementwise.exp(-cut))


def full_height(wind: float, gravity: float = 9.81) -> float:
    """m, the significant height of that sea: four times the root of the spectrum's integral."""
    return 2.0 * math.sqrt(PHILLIPS / STEEP_PM) * wind * wind / gravity if gravity > 0.0 else 0.0


def jonswap(rates: Floats, wind: float, fetch: float, gravity: float = 9.81) -> Floats:
    """m² s at rates (n,) rad/s, for a wind (m/s, at 10 m) that has blown over a fetch (m)."""
    if wind <= 0.0 or gravity <= 0.0:
        return np.zeros_like(rates)
    alpha = 0.076 * elementary.pow(wind * wind / (fetch * gravity), 0.22)
    peak = 22.0 * elementary.cbrt(gravity * gravity / (wind * fetch))
    cut = np.minimum(STEEP_J * elementwise.power(peak / rates, 4.0), 700.0)
    off = (rates - peak) / (np.where(rates > peak, WIDE, NARROW) * peak)
    bump = elementwise.exp(-np.minimum(0.5 * off * off, 700.0))
    shape = elementwise.power(np.full_like(rates, PEAKED), bump)
    return np.asarray(
        alpha * gravity * gravity * elementwise.power(rates, -5.0) * elementwise.exp(-cut) * shape
    )


@kernel
def run_waves(rows, speed, share, goals, dt):
    """All waves go on by dt (s) as a point sees them that goes along x at a speed (m/s); their amplitudes
    come nearer to ``goals`` (n,) m by a share.
    """
    for i in range(rows.shape[0]):
        phase = rows[i, PHASE] + (rows[i, ALONG] * speed - rows[i, RATE]) * dt
        rows[i, PHASE] = phase - 2.0 * math.pi * math.floor(phase / (2.0 * math.pi))
        rows[i, AMPLITUDE] += share * (goals[i] - rows[i, AMPLITUDE])


@kernel
def sea_at(rows, points, under, out):
    """out (n, 5), see LEVEL, at points (n, 2): x, z m from the point of reference. under: m below the mean
    level, at which shorter waves are felt less, as exp(-k d) (Smith 1883).
    """
    for p in range(points.shape[0]):
        level, along, across, rise, lift = 0.0, 0.0, 0.0, 0.0, 0.0
        for i in range(rows.shape[0]):
            high = rows[i, AMPLITUDE]
            if high == 0.0:
                continue
            kx, kz, rate = rows[i, ALONG], rows[i, ACROSS], rows[i, RATE]
            if under > 0.0:
                high *= elementary.exp(-under * math.sqrt(kx * kx + kz * kz))
            angle = kx * points[p, 0] + kz * points[p, 1] + rows[i, PHASE]
            c, s = high * elementary.cos(angle), high * elementary.sin(angle)
            level += c
            along -= kx * s
            across -= kz * s
            rise += rate * s
            lift -= rate * rate * c
        out[p, LEVEL], out[p, SLOPE_X], out[p, SLOPE_Z] = level, along, across
        out[p, RISE], out[p, LIFT] = rise, lift


class Sea:
    """``count`` waves of ``lengths`` from the shortest to the longest (m), and last of the rows (n,
    COLUMNS) a swell of one length, along x.

    heading: rad from x to where the wind blows; spread: rad to either side, by which directions differ, with
    the density of a cosine. ValueError for nonsense.
    """

    def __init__(
        self, count: int, heading: float = 0.0, spread: float = 0.6, gravity: float = 9.81, seed: int = 0,
        lengths: tuple[float, float] = (SHORTEST, LONGEST),
    ):  # fmt: skip
        shortest, longest = lengths
        if not (1 <= count <= 4096 and 0.0 <= spread <= math.pi and 0.0 <= gravity < math.inf):
            raise ValueError(f"count, spread, gravity = {count}, {spread}, {gravity}: out of range")
        if not 0.0 < shortest < longest < math.inf:
            raise ValueError(f"lengths = {lengths!r}: expected a shorter and a longer one, m")
        shares = np.arange(count + 1) / count
        edges = math.tau / longest * elementwise.power(np.full(count + 1, longest / shortest), shares)
        self.numbers: Floats = np.sqrt(edges[1:] * edges[:-1])
        self.edges, self.spread = edges, spread
        random = np.random.default_rng((seed, 15))
        if seed:  # no length is a whole part of another
            shift = elementwise.power(edges[1:] / edges[:-1], random.random(count) - 0.5)
            self.numbers = self.numbers * shift
        aim = np.remainder(GOLDEN * np.arange(1.0, count + 1.0), 1.0)
        self.turns: Floats = spread * elementwise.arcsin(2.0 * aim - 1.0) / (0.5 * math.pi)
        self.rows: Floats = np.zeros((count + 1, COLUMNS))
        self.rows[:-1, PHASE] = math.tau * random.random(count)
        self.swell = longest
        self.set_gravity(gravity)
        self.turn(heading)

    def set_gravity(self, gravity: float) -> None:
        """m/s²: how fast all waves swing."""
        self.gravity = gravity
        self.rows[:-1, RATE] = np.sqrt(gravity * self.numbers)
        self.set_swell(self.swell)
        self.widths: Floats = np.diff(np.sqrt(gravity * self.edges))

    def turn(self, heading: float) -> None:
        """Let all waves go about that direction (rad from x); their phases at the point of reference stay."""
        self.rows[:-1, ALONG] = self.numbers * elementwise.cos(heading + self.turns)
        self.rows[:-1, ACROSS] = self.numbers * elementwise.sin(heading + self.turns)

    def set_swell(self, length: float) -> None:
        """m, of the swell."""
        self.swell = length
        self.rows[-1, ALONG] = math.tau / length
        self.rows[-1, RATE] = math.sqrt(self.gravity * math.tau / length)

    def goals(self, model: str, wind: float, fetch: float, swell: float = 0.0) -> Floats:
        """Amplitudes (n,) m of a sea by a model of MODELS, for a wind (m/s), a fetch (m), a swell (m)
        high."""
        rates = self.rows[:-1, RATE]
        if model == "pierson-moskowitz":
            found = pierson_moskowitz(np.maximum(rates, 1e-9), wind, self.gravity)
        else:
            found = jonswap(np.maximum(rates, 1e-9), wind, fetch, self.gravity)
        return np.append(np.sqrt(2.0 * found * self.widths), 0.5 * swell)

    def significant(self) -> float:
        """m, of the waves of the wind: four times the root of the mean square of the level."""
        high = self.rows[:-1, AMPLITUDE]
        return 4.0 * math.sqrt(0.5 * float(np.sum(high * high)))

    def at(self, points: Floats, under: float = 0.0) -> Floats:
        """The water (n, 5), see LEVEL, at points (n, 2) m."""
        out: Floats = np.empty((len(points), 5))
        sea_at(self.rows, points, under, out)
        return out

    def step(self, speed: float, goals: Floats, share: float, dt: float) -> None:
        """Go on by dt (s) with the point of reference at a speed (m/s) along x."""
        run_waves(self.rows, speed, share, goals, dt)

    def state(self) -> SeaState:
        """All that later steps depend on."""
        return SeaState(self.rows)

    def restore(self, state: SeaState) -> None:
        """Take over a copy of a state."""
        self.rows[...] = state.rows
