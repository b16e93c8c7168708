"""Cuts through the waves of a sea, one behind the other to the horizon: levels, slopes, foam, a boat's waves.

Cuts lie at depths that are even in the picture. Foam stands where the water falls so fast that as much of the
sea is white as was seen at that wind.
"""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Singles
from game.compiler.decorator import inner_kernel, lean_kernel
from game.worlds.painting.sea.ripples import is_short

STEP = 10  # px from one sample of a cut to the next
HORIZON, AWAY = 4.2, 27.0  # m over the water, and before the plane x, y: of the eye
NEAREST, FARTHEST = 1.0, 0.012  # of the shrinking of what is in that plane
LAYERS_FAR, LAYERS_NEAR = 56, 32
TOP, TILT, OFF_X, OFF_Z, THIN, FOAM = range(6)  # of a sample: px, slope to the eye, from the sun's, shares


Triple = tuple[float, float, float]


class Eye(NamedTuple):
    """Where the picture is seen from, m along; the height (m) of its horizon; px of a point of the world:
    columns and rows of the origin, px to a m."""

    x: float
    left: float
    zero: float
    scale: float


class Light(NamedTuple):
    """Colours of deep water, of a thin crest, of the sun and of foam (0 to 255 each); the sun's direction;
    how bright its glitter is."""

    deep: Triple
    thin: Triple
    sun: Triple
    foam: Triple
    to: Triple
    glint: float


class Wake(NamedTuple):
    """Of a boat in the plane x, y: m of its stern and bow, m of its half breadth, its speed, m/s; its
    waves' height, m."""

    stern: float
    bow: float
    half: float
    speed: float
    high: float


NO_WAKE = Wake(0.0, 0.0, 1.0, 0.0, 0.0)


class Cuts(NamedTuple):
    """shrinks (l,): how large what stands in each cut is beside what stands in the plane. samples (l, 6, w),
    see TOP; lost (l,): mean squares of slopes too fine to be seen; sums (4, w) and foam (w,) of one cut.
    """

    shrinks: Floats
    samples: Floats
    lost: Floats
    sums: Floats
    foam: Floats


def shrink(z: Any) -> Any:
    """How large what stands z m behind the plane is beside what stands in it."""
    return AWAY / (AWAY + np.maximum(z, -0.8 * AWAY))


def projected(eye: float, x: Any, y: Any, z: Any) -> Any:
    """Places (n, 2) of the world's plane at which points are seen."""
    part = shrink(z)
    return np.stack([eye + (x - eye) * part, HORIZON + (y - HORIZON) * part], axis=-1)


@inner_kernel
def _add_cuts(rows, z, first, step, deep, sums):
    """Levels, both slopes and downward accelerations (4, w) of the sea along x at z, from first by step.

    deep: m to the next cut. Returned: the mean square of slopes too fine to be seen.
    """
    count, lost = sums.shape[1], 0.0
    for k in range(4):
        for i in range(count):
            sums[k, i] = 0.0
    for n in range(rows.shape[0]):
        high, kx, kz, rate = rows[n, 0], rows[n, 1], rows[n, 2], rows[n, 3]
        turn = kx * step
        share = max(1.0 - abs(turn) / 2.4, 0.0) * max(1.0 - abs(kz) * deep / 4.0, 0.0)
        lost += 0.5 * high * high * (kx * kx + kz * kz) * (1.0 - share * share)
        high *= share
        if high < 1e-4:
            continue
        angle = kx * first + kz * z + rows[n, 4]
        c, s = high * math.cos(angle), high * math.sin(angle)
        tc, ts = math.cos(turn), math.sin(turn)
        square = rate * rate
        for i in range(count):
            sums[0, i] += c
            sums[1, i] -= kx * s
            sums[2, i] -= kz * s
            sums[3, i] += square * c
            c, s = c * tc - s * ts, s * tc + c * ts
    return lost


@inner_kernel
def _add_wake(table, wake, gravity, z, first, step, sums, foam):
    """The waves (Kelvin 1887) and the foam (w,) of a boat on one cut."""
    speed = max(wake.speed, 0.0)
    for i in range(foam.size):
        foam[i] = 0.0
    if speed < 0.4:
        return
    number = gravity / (speed * speed)
    side = abs(z)
    for i in range(foam.size):
        x = first + step * i
        back = wake.bow - x
        if back < -1.0:
            continue
        u, v = back * number * 6.0, side * number * 6.0
        if 1.0 <= u < table.shape[1] - 2 and v < table.shape[0] - 2:
            a, b = int(u), int(v)
            p, q = u - a, v - b
            for c in range(3):
                low = table[b, a, c] + p * (table[b, a + 1, c] - table[b, a, c])
                high = table[b + 1, a, c] + p * (table[b + 1, a + 1, c] - table[b + 1, a, c])
                value = (low + q * (high - low)) * wake.high
                if c > 0:
                    value *= number
                if c == 2 and z < 0.0:
                    value = -value
                sums[c, i] += value
        astern = wake.stern - x
        pace = min(speed / 1.7, 1.25)
        if astern > -0.3:  # what the stern has stirred
            wide = 0.6 * wake.half + 0.16 * math.sqrt(max(astern, 0.0)) + 0.02 * max(astern, 0.0)
            edge = min(max((wide - side) / 0.5, 0.0), 1.0)
            along = side / max(wide, 0.1)
            foam[i] = (
                edge * pace * (0.46 + 0.4 * along * along) * math.exp(-max(astern, 0.0) / (11.0 * speed))
            )
        if back > -0.4:  # the bow's wave runs out to both sides
            arm = 0.25 + 0.6 * wake.half * min(back / 2.2, 1.0) + 0.33 * max(back - 1.6, 0.0)
            edge = max(1.0 - abs(side - arm) / (0.4 + 0.07 * max(back, 0.0)), 0.0)
            foam[i] = max(foam[i], 0.85 * edge * pace * math.exp(-max(back, 0.0) / (2.2 * speed)))


@lean_kernel
def see_sea(rows, cuts, eye, light, wake, table, crests, gravity):
    """Fill the samples of cuts. crests: the least of the downward acceleration over gravity at which there is
    foam, and at which it is full; the height of a usual crest, m. table: of a boat's waves.
    """
    sums, foam, shrinks, samples = cuts.sums, cuts.foam, cuts.shrinks, cuts.samples
    count = samples.shape[2]
    lx, ly, lz = light.to[0], light.to[1], light.to[2]
    for cut in range(shrinks.shape[0]):
        part = shrinks[cut]
        z = AWAY / part - AWAY
        beside = shrinks[cut - 1] if cut > 0 else shrinks[1]
        deep = abs(AWAY / beside - AWAY / part)
        step = STEP / (eye.scale * part)
        first = eye.x + (0.5 * STEP - eye.left) / (eye.scale * part) - eye.x / part
        # the column of the world's x is left + scale (eye + (x - eye) part)
        cuts.lost[cut] = _add_cuts(rows, z, first, step, deep, sums)
        _add_wake(table, wake, gravity, z, first, step, sums, foam)
        for i in range(count):
            level, sx, sz = sums[0, i], sums[1, i], sums[2, i]
            samples[cut, TOP, i] = eye.zero - eye.scale * (HORIZON + (level - HORIZON) * part)
            vx, vy, vz = eye.x - first - step * i, HORIZON - level, -(z + AWAY)
            flat = math.sqrt(vx * vx + vz * vz)
            far = math.sqrt(flat * flat + vy * vy)
            # as much as the water rises away from the eye
            samples[cut, TILT, i] = -(sx * vx + sz * vz) / flat
            hx, hy, hz = lx + vx / far, ly + vy / far, lz + vz / far
            samples[cut, OFF_X, i] = sx + hx / hy
            samples[cut, OFF_Z, i] = sz + hz / hy
            samples[cut, THIN, i] = min(max(0.12 + 0.5 * level / crests[2] - 0.9 * sz, 0.0), 1.0)
            breaks = (sums[3, i] / gravity - crests[0]) / (crests[1] - crests[0])
            samples[cut, FOAM, i] = max(min(max(breaks, 0.0), 1.0), foam[i])


@lru_cache(maxsize=1)
def wake_table() -> Singles:
    """(120, 300, 3): level and both slopes of the waves behind a point that moves (Kelvin 1887).

    Places are sixths of v²/g to the side and astern. 1 is the highest.
    """
    turn = np.linspace(-1.2, 1.2, 241)
    c, s = np.cos(turn), np.sin(turn)
    weight = np.exp(-(((1.0 / (c * c) - 1.0) / 2.2) ** 2)) / (c * c)
    x, z = np.arange(300)[:, None] / 6.0, np.arange(120)[:, None] / 6.0
    wave = np.exp(1j * x / c) * weight  # along x: k cos θ, with k = sec² θ
    side = np.exp(1j * z * s / (c * c)).T
    fade = np.exp(-np.arange(300) / 150.0) * np.minimum(np.arange(300) / 9.0, 1.0)
    level = (wave @ side).imag.T * fade
    along = -((wave * (1.0 / c)) @ side).real.T * fade  # x goes ahead, places astern
    across = ((wave * (s / (c * c))) @ side).real.T * fade
    most = float(np.max(np.abs(level)))
    return np.ascontiguousarray(np.stack([level, along, across], axis=2) / most, np.float32)


def whitecaps(wind: float) -> float:
    """Share of a sea that is white under a wind, m/s (Monahan, O'Muircheartaigh 1980)."""
    return min(3.84e-6 * max(wind, 0.0) ** 3.41, 0.5)


def crests_of(rows: Floats, wind: float, gravity: float) -> Floats:
    """Downward accelerations over gravity at which foam begins and is full; m of a usual crest.

    As much of the sea is white as a wind (m/s) makes it. rows (n, 5): its waves.
    """
    rows = rows[~is_short(rows)]
    spread = math.sqrt(0.5 * float(np.sum((rows[:, 0] * rows[:, 3] ** 2) ** 2))) / max(gravity, 0.1)
    share, usual = whitecaps(wind), NormalDist()
    least, most = (usual.inv_cdf(1.0 - min(max(share * k, 1e-6), 0.9)) for k in (1.7, 0.3))
    high = math.sqrt(0.5 * float(np.sum(rows[:, 0] ** 2)))
    return np.array((max(spread, 1e-6) * least, max(spread, 1e-6) * most, max(2.0 * high, 0.25)))
