"""Pixels of a sea that goes to the horizon: cuts through its waves one behind the other, lit pixel by pixel.

Cuts lie at depths that are even in the picture. What is nearer is painted first, and each column of pixels
only goes up from there, so that no pixel is painted twice. Slopes of short waves come from a tile. What a
slope mirrors is looked up by its angle to the eye; the sun shines where a slope turns to it.
"""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Inks, Singles
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, bounds_of
from game.worlds.painting.ripples import CELLS, LEVELS, SIDE, UNIT, Ripples, is_short, mean_square_slope

STEP = 10  # px from one sample of a cut to the next
HORIZON, AWAY = 4.2, 27.0  # m over the water, and before the plane x, y: of the eye
NEAREST, FARTHEST = 1.0, 0.012  # of the shrinking of what is in that plane
LAYERS_FAR, LAYERS_NEAR = 56, 32
SLOPES, STEEPEST = 128, 1.2  # places in a table of what slopes mirror, and to which slope
GLOWS = 512  # places in the table of the sun's glitter
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


NO_PICTURE: Inks = np.zeros((0, 0), np.uint32)


def shrink(z: Any) -> Any:
    """How large what stands z m behind the plane is beside what stands in it."""
    return AWAY / (AWAY + np.maximum(z, -0.8 * AWAY))


def projected(eye: float, x: Any, y: Any, z: Any) -> Any:
    """Places (n, 2) of the world's plane at which points are seen."""
    part = shrink(z)
    return np.stack([eye + (x - eye) * part, HORIZON + (y - HORIZON) * part], axis=-1)


# -- what the waves are in cuts -----------------------------------------------------------------------------


@inner_kernel
def _add_cuts(rows, z, first, step, deep, sums):
    """Levels, both slopes and downward accelerations (4, w) of the sea along x at z, from first by step. deep:
    m from this cut to the next. Returned: the mean square of slopes too fine to be seen."""
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
def see_sea(rows, shrinks, eye, light, wake, table, crests, gravity, sums, foam, cuts, lost):
    """Cuts by how they shrink (l,): cuts (l, 6, w), see TOP; lost (l,) mean squares of unseen slopes.

    crests: the least of the downward acceleration over gravity at which there is foam, and at which it is
    full; the mean height of waves, m. table: of a boat's waves.
    """
    count = cuts.shape[2]
    lx, ly, lz = light.to[0], light.to[1], light.to[2]
    for cut in range(shrinks.shape[0]):
        part = shrinks[cut]
        z = AWAY / part - AWAY
        beside = shrinks[cut - 1] if cut > 0 else shrinks[1]
        deep = abs(AWAY / beside - AWAY / part)
        step = STEP / (eye.scale * part)
        first = eye.x + (0.5 * STEP - eye.left) / (eye.scale * part) - eye.x / part
        # the column of the world's x is left + scale (eye + (x - eye) part)
        lost[cut] = _add_cuts(rows, z, first, step, deep, sums)
        _add_wake(table, wake, gravity, z, first, step, sums, foam)
        for i in range(count):
            level, sx, sz = sums[0, i], sums[1, i], sums[2, i]
            cuts[cut, TOP, i] = eye.zero - eye.scale * (HORIZON + (level - HORIZON) * part)
            vx, vy, vz = eye.x - first - step * i, HORIZON - level, -(z + AWAY)
            flat = math.sqrt(vx * vx + vz * vz)
            far = math.sqrt(flat * flat + vy * vy)
            # as much as the water rises away from the eye
            cuts[cut, TILT, i] = -(sx * vx + sz * vz) / flat
            hx, hy, hz = lx + vx / far, ly + vy / far, lz + vz / far
            cuts[cut, OFF_X, i] = sx + hx / hy
            cuts[cut, OFF_Z, i] = sz + hz / hy
            cuts[cut, THIN, i] = min(max(0.12 + 0.5 * level / crests[2] - 0.9 * sz, 0.0), 1.0)
            breaks = (sums[3, i] / gravity - crests[0]) / (crests[1] - crests[0])
            cuts[cut, FOAM, i] = max(min(max(breaks, 0.0), 1.0), foam[i])


@lean_kernel
def fill_mirrors(shrinks, rough, sky, light, haze, mirrors):
    """mirrors (l, SLOPES, 4): what a slope shows, and the share of it that is mirrored, in each cut.

    rough (l,): mean squares of slopes that are not seen one by one. sky (n, 3): by the root of the sine of
    height; haze (l,): shares of the colour of the horizon.
    """
    last = sky.shape[0] - 1
    for cut in range(shrinks.shape[0]):
        away = AWAY / shrinks[cut]
        far = math.sqrt(away * away + HORIZON * HORIZON)
        up, flat = HORIZON / far, away / far
        spread = math.sqrt(0.5 * rough[cut])
        for n in range(mirrors.shape[1]):
            whole, red, green, blue, sent = 0.0, 0.0, 0.0, 0.0, 0.0
            for tap in range(3):
                slope = STEEPEST * (2.0 * (n + 0.5) / mirrors.shape[1] - 1.0) + spread * (tap - 1.0)
                size = math.sqrt(1.0 + slope * slope)
                facing = (up + slope * flat) / size
                weight = max(facing, 0.02) * (2.0 if tap == 1 else 1.0)  # steep faces fill more of the view
                facing = min(max(facing, 0.02), 1.0)
                bare = (1.0 - facing) * (1.0 - facing)
                share = 0.02 + 0.98 * bare * bare * (1.0 - facing)
                rise = 2.0 * facing / size - up
                # a ray that goes down meets other waves, which mirror the lowest sky
                dim = 1.0 if rise > 0.0 else max(1.0 + 1.6 * rise, 0.55)
                place = math.sqrt(min(max(rise, 0.0), 1.0)) * last
                i = min(int(place), last - 1)
                f = place - i
                body = 0.75 + 0.35 * min(max(0.5 - slope, 0.0), 1.0)
                whole += weight
                sent += weight * share
                red += weight * (
                    light.deep[0] * body * (1.0 - share)
                    + dim * share * (sky[i, 0] + f * (sky[i + 1, 0] - sky[i, 0]))
                )
                green += weight * (
                    light.deep[1] * body * (1.0 - share)
                    + dim * share * (sky[i, 1] + f * (sky[i + 1, 1] - sky[i, 1]))
                )
                blue += weight * (
                    light.deep[2] * body * (1.0 - share)
                    + dim * share * (sky[i, 2] + f * (sky[i + 1, 2] - sky[i, 2]))
                )
            veil = haze[cut]
            mirrors[cut, n, 0] = red / whole + veil * (sky[0, 0] - red / whole)
            mirrors[cut, n, 1] = green / whole + veil * (sky[0, 1] - green / whole)
            mirrors[cut, n, 2] = blue / whole + veil * (sky[0, 2] - blue / whole)
            mirrors[cut, n, 3] = sent / whole


# -- pixels -------------------------------------------------------------------------------------------------


@inner_kernel
def _slopes(tiles, level, u, v):
    """Slopes of short waves at a place in cells, x and z, both above 0."""
    i, j = int(u), int(v)
    wide, high = tiles.shape[1] - 1, (tiles.shape[2] >> level) - 1
    a, b = i & wide, j & high
    if level > 1:
        a &= wide >> 1
        return UNIT * tiles[level, a, b, 0], UNIT * tiles[level, a, b, 1]
    c, d = (a + 1) & wide, (b + 1) & high
    q, r = UNIT * (u - i), v - j
    k01, k11, k10 = q - q * r, q * r, UNIT * r - q * r
    k00 = UNIT - k01 - k11 - k10
    rx = k00 * tiles[level, a, b, 0] + k01 * tiles[level, c, b, 0]
    rx += k10 * tiles[level, a, d, 0] + k11 * tiles[level, c, d, 0]
    rz = k00 * tiles[level, a, b, 1] + k01 * tiles[level, c, b, 1]
    rz += k10 * tiles[level, a, d, 1] + k11 * tiles[level, c, d, 1]
    return rx, rz


@inner_kernel
def _white(froth, x, z):
    """Of the pattern of foam, at a place in m above 0."""
    return froth[int(x * 60.0) & 511, int(z * 34.0) & 511]


@inner_kernel
def _light_pixel(mirror, last, k, light, glows, froth, seen, slopes, place, dull):
    """One pixel's ink: what its cut mirrors and the one before, a share k between;
    ``seen`` (5,) TILT to FOAM there; slopes of short waves; place, m."""
    tilt, gx, gz, thin, foam = seen
    rx, rz, lean = slopes
    tilt += rz + lean * rx
    gx += rx
    gz += rz
    n = min(max(int((tilt + STEEPEST) * (0.5 * SLOPES / STEEPEST)), 0), SLOPES - 1)
    sent = mirror[n, 3]
    thin *= 1.0 - sent
    spot = (gx * gx + gz * gz) * dull
    glow = 0.0
    if spot < 8.0:
        glow = glows[int(spot * (GLOWS / 8.0))] * (0.25 + sent) * light.glint
    red = last[n, 0] + k * (mirror[n, 0] - last[n, 0]) + thin * light.thin[0] + glow * light.sun[0]
    green = last[n, 1] + k * (mirror[n, 1] - last[n, 1]) + thin * light.thin[1] + glow * light.sun[1]
    blue = last[n, 2] + k * (mirror[n, 2] - last[n, 2]) + thin * light.thin[2] + glow * light.sun[2]
    if foam > 0.0:
        white = min((_white(froth, place[0], place[1]) - 255.0 + 255.0 * foam) * 0.0102, 0.92)
        if white > 0.0:
            lit = white * (0.84 + 0.5 * tilt)
            red += light.foam[0] * lit - red * white
            green += light.foam[1] * lit - green * white
            blue += light.foam[2] * lit - blue * white
    return (
        int(min(max(red, 0.0), 255.0)) << 16
        | int(min(max(green, 0.0), 255.0)) << 8
        | int(min(max(blue, 0.0), 255.0))
    )


@inner_kernel
def _mirrored(pixels, bare, beside, row, column, eye, z, tilt, rx, mirror, ink):
    """A pixel's ink, with the boat in it if that is what the water mirrors there."""
    apart = -2.0 * z * eye.scale
    high = int(2.0 * eye.zero - row - apart * tilt)
    at = int(column - apart * rx)
    if not (0 <= high < row and beside <= at < beside + bare.shape[1] and high < bare.shape[0]):
        return ink
    boat = int(pixels[high, at])
    if boat == bare[high, at - beside]:
        return ink
    n = min(max(int((tilt + STEEPEST) * (0.5 * SLOPES / STEEPEST)), 0), SLOPES - 1)
    share = int(230.0 * mirror[n, 3])
    red = (boat >> 16 & 255) * share + (ink >> 16 & 255) * (256 - share) >> 8
    green = (boat >> 8 & 255) * share + (ink >> 8 & 255) * (256 - share) >> 8
    return red << 16 | green << 8 | (boat & 255) * share + (ink & 255) * (256 - share) >> 8


@inner_kernel
def _between(pixels, column, every, tops, foot):
    """Columns that were left out are in the middle of those at both sides. tops: of the last and this."""
    for k in range(1, every):
        for row in range(min(tops[0], tops[1]), foot):
            here, last = pixels[row, column], pixels[row, column - every]
            if row < tops[0]:
                pixels[row, column - k] = here
            elif row < tops[1]:
                pixels[row, column - k] = last
            else:
                pixels[row, column - k] = ((here ^ last) & 0xFEFEFE) // 2 + (here & last) | 0xFF000000


@lean_kernel
def paint_sea(
    pixels,
    clip,
    eye,
    shrinks,
    cuts,
    levels,
    mirrors,
    rough,
    tiles,
    froth,
    glows,
    light,
    moves,
    veils,
    every,
    bare,
    beside,
):
    """Paint cuts (l, 6, w), the nearest first, upwards. levels (l,) of the tiles that each is seen by;
    veils (l,): how much of what lies behind each hides, 256 being all of it; moves: m by which foam has gone
    along x and z; every: of so many columns one is lit, the others are between. bare (h, w):
    the picture from the column ``beside`` on before there was a boat in it, which the water mirrors."""
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    last_sample = cuts.shape[2] - 1
    to_cell, ahead = tiles.shape[2] / SIDE, 64.0 * SIDE
    most = tiles.shape[0] - 1
    above = y_high
    for column in range(x_low, x_high, every):
        place = min(max((column - clip[0]) / STEP - 0.5, 0.0), last_sample - 1e-6)
        i = int(place)
        f = place - i
        across = (column - clip[0] - eye.left) / eye.scale - eye.x  # m from the eye, in the plane x, y
        lean = across / math.sqrt(across * across + AWAY * AWAY)
        before = cuts[0, TOP, i] + f * (cuts[0, TOP, i + 1] - cuts[0, TOP, i])
        lowest = y_high if before >= y_high else max(math.ceil(before), y_low)
        foot = lowest
        s0 = cuts[0, TILT, i] + f * (cuts[0, TILT, i + 1] - cuts[0, TILT, i])
        x0 = cuts[0, OFF_X, i] + f * (cuts[0, OFF_X, i + 1] - cuts[0, OFF_X, i])
        z0 = cuts[0, OFF_Z, i] + f * (cuts[0, OFF_Z, i + 1] - cuts[0, OFF_Z, i])
        t0 = cuts[0, THIN, i] + f * (cuts[0, THIN, i + 1] - cuts[0, THIN, i])
        w0 = cuts[0, FOAM, i] + f * (cuts[0, FOAM, i + 1] - cuts[0, FOAM, i])
        p0 = shrinks[0]
        for cut in range(1, shrinks.size):
            top = cuts[cut, TOP, i] + f * (cuts[cut, TOP, i + 1] - cuts[cut, TOP, i])
            s1 = cuts[cut, TILT, i] + f * (cuts[cut, TILT, i + 1] - cuts[cut, TILT, i]) - s0
            x1 = cuts[cut, OFF_X, i] + f * (cuts[cut, OFF_X, i + 1] - cuts[cut, OFF_X, i]) - x0
            z1 = cuts[cut, OFF_Z, i] + f * (cuts[cut, OFF_Z, i + 1] - cuts[cut, OFF_Z, i]) - z0
            t1 = cuts[cut, THIN, i] + f * (cuts[cut, THIN, i + 1] - cuts[cut, THIN, i]) - t0
            w1 = cuts[cut, FOAM, i] + f * (cuts[cut, FOAM, i + 1] - cuts[cut, FOAM, i]) - w0
            p1 = shrinks[cut] - p0
            first = max(math.floor(top), y_low)
            if first < lowest:
                long = 1.0 / max(before - top, 1.0)
                level = levels[cut]
                to_row = to_cell / (1 << min(level, most))
                to_column = 0.5 * to_cell if level > 1 else to_cell
                dull, mirror = 1.0 / rough[cut], mirrors[cut]
                for row in range(first, lowest):
                    k = min(max((before - row) * long, 0.0), 1.0)
                    inverse = 1.0 / (p0 + k * p1)
                    x = across * inverse + eye.x + ahead
                    z = AWAY * inverse - AWAY + ahead
                    rx, rz = 0.0, 0.0
                    if level <= most:
                        rx, rz = _slopes(tiles, level, x * to_column, z * to_row)
                    ink = _light_pixel(
                        mirror, mirrors[cut - 1], k, light, glows, froth, (s0 + k * s1, x0 + k * x1, z0 + k * z1, t0 + k * t1, w0 + k * w1),
                        (rx, rz, lean), (x + moves[0], z + moves[1]), dull,
                    )  # fmt: skip
                    if beside <= column < beside + bare.shape[1]:
                        tilt = s0 + k * s1 + rz + lean * rx
                        ink = _mirrored(
                            pixels, bare, beside, row, column, eye, z - ahead, tilt, rx, mirror, ink
                        )
                    if veils[cut] >= 256:
                        pixels[row, column] = 0xFF000000 | ink
                    else:
                        blend(pixels, row, column, ink, veils[cut])
                lowest = first
            before = top
            s0 += s1
            x0 += x1
            z0 += z1
            t0 += t1
            w0 += w1
            p0 += p1
        if every > 1 and column > x_low:
            _between(pixels, column, every, (above, lowest), foot)
        above = lowest
    for column in range(x_high - (x_high - x_low - 1) % every, x_high):
        for row in range(above, y_high):
            pixels[row, column] = pixels[row, column - 1]


# -- tables -------------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def froth_of() -> NDArray[np.uint8]:
    """(512, 512) from 0 to 255, as much of it below each value as the value says; it goes on at its sides."""
    random = np.random.default_rng(5)
    size = np.hypot(np.fft.fftfreq(512)[:, None], np.fft.rfftfreq(512)[None, :]) * 512.0
    noise = np.fft.irfft2(np.fft.rfft2(random.standard_normal((512, 512))) * (size + 6.0) ** -1.15)
    veins = np.fft.irfft2(np.fft.rfft2(random.standard_normal((512, 512))) * (size + 20.0) ** -1.9)
    noise = noise / np.std(noise) - 1.1 * np.abs(veins / np.std(veins))
    ranks = np.empty(noise.size, np.uint8)
    ranks[np.argsort(noise, axis=None)] = np.arange(noise.size) * 256 // noise.size
    return ranks.reshape(noise.shape)


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


@lru_cache(maxsize=1)
def glow_table() -> Floats:
    """(GLOWS,) of the sun's glitter by the square of a slope's distance over the roughness, 0 to 8."""
    return np.asarray((np.exp(-4.0 * np.arange(GLOWS) / GLOWS) - math.exp(-4.0)) / (1.0 - math.exp(-4.0)))


def whitecaps(wind: float) -> float:
    """Share of a sea that is white under a wind, m/s (Monahan, O'Muircheartaigh 1980)."""
    return min(3.84e-6 * max(wind, 0.0) ** 3.41, 0.5)


def crests_of(rows: Floats, wind: float, gravity: float) -> Floats:
    """For `see_sea`: downward accelerations over gravity at which foam begins and is full, so that as much of
    the sea is white as wind (m/s) and waves (n, 5) say; m of a usual crest."""
    rows = rows[~is_short(rows)]
    spread = math.sqrt(0.5 * float(np.sum((rows[:, 0] * rows[:, 3] ** 2) ** 2))) / max(gravity, 0.1)
    share, usual = whitecaps(wind), NormalDist()
    least, most = (usual.inv_cdf(1.0 - min(max(share * k, 1e-6), 0.9)) for k in (1.7, 0.3))
    high = math.sqrt(0.5 * float(np.sum(rows[:, 0] ** 2)))
    return np.array((max(spread, 1e-6) * least, max(spread, 1e-6) * most, max(2.0 * high, 0.25)))


class SeaPainter:
    """Keeps the cuts of a picture, and the tile of short waves. every: of so many columns one is lit."""

    def __init__(self, every: int = 2) -> None:
        self.every = every
        self.ripples = Ripples()
        self._width = 0

    def _fit(self, width: int) -> None:
        count = -(-width // STEP) + 2
        if count != self._width:
            self._width = count
            self._sums, self._foam = np.zeros((4, count)), np.zeros(count)
            self._cuts = [np.zeros((n, 6, count)) for n in (LAYERS_NEAR, LAYERS_FAR)]
            self._mirrors = np.zeros((max(LAYERS_FAR, LAYERS_NEAR), SLOPES, 4))

    def paint(
        self, canvas: Any, rows: Floats, light: Light, sky: Floats, near: bool, gravity: float, *,
        wind: float, moves: Floats, crests: Floats, haze: float = 0.0, wake: Wake = NO_WAKE, bare: Inks = NO_PICTURE, beside: int = 0,
    ) -> None:  # fmt: skip
        """The sea before the plane x, y, or behind it, by its waves (n, 5). bare (h, w): the picture before
        there was a boat in it, from the column ``beside`` on."""
        pixels, clip = canvas.raster_target
        width = int(clip[2] - clip[0])
        if width <= 1:
            return
        self._fit(width)
        seen = canvas.camera.visible()
        x, y = canvas.place((0.0, 0.0))
        scale = float(canvas.pixels_per_unit)
        eye = Eye(0.5 * (seen.left + seen.right), float(x - clip[0]), float(y), scale)
        lowest = max((HORIZON - seen.bottom) / HORIZON, NEAREST + 0.05) * 1.5
        if near:
            shrinks = np.linspace(lowest, NEAREST + 0.035, LAYERS_NEAR)
            veils = np.where(shrinks > 1.14, 256, 215).astype(np.int64)
        else:
            shrinks = np.linspace(NEAREST + 0.12, FARTHEST, LAYERS_FAR)
            veils = np.full(LAYERS_FAR, 256, np.int64)
        which = 0 if near else 1
        cuts, mirrors, lost = self._cuts[which], self._mirrors[: len(shrinks)], np.zeros(len(shrinks))
        long = np.ascontiguousarray(rows[~is_short(rows)])
        see_sea(
            long, shrinks, eye, light, wake, wake_table(), crests, max(gravity, 0.1), self._sums, self._foam,
            cuts, lost,
        )  # fmt: skip
        pixel = AWAY / (shrinks * shrinks * scale * HORIZON)  # m of a row of pixels, away from the eye
        levels = np.rint(np.log2(np.maximum(pixel * CELLS / SIDE, 1.0))).astype(np.int64)
        levels = np.minimum(levels, LEVELS)
        unseen = self.ripples.rough[levels]
        light = light._replace(thin=tuple(a - b for a, b in zip(light.thin, light.deep, strict=True)))
        rough = unseen + lost + 0.12 * mean_square_slope(wind)
        veil = 1.0 - np.exp(-AWAY / shrinks / (900.0 - 550.0 * haze))
        fill_mirrors(shrinks, rough, sky, light, veil, mirrors)
        paint_sea(
            pixels, clip, eye, shrinks, cuts, levels, mirrors, 2.0 * rough, self.ripples.tiles, froth_of(),
            glow_table(), light, moves, veils, self.every, bare, beside,
        )  # fmt: skip


def warm_up_sea() -> None:
    """Compile what paints, on a tiny picture."""
    shrinks, cuts, lost = np.array((1.0, 0.5)), np.zeros((2, 6, 4)), np.zeros(2)
    light = Light(*(((0.0, 0.0, 0.0),) * 4), (0.3, 0.3, 0.9), 1.0)
    rows = np.array([[0.1, 0.3, 0.1, 1.0, 0.0]])
    eye, moves = Eye(0.0, 4.0, 4.0, 1.0), np.zeros(2)
    see_sea(
        rows, shrinks, eye, light, NO_WAKE, wake_table(), np.array((0.1, 0.2, 1.0)), 9.81, np.zeros((4, 4)),
        np.zeros(4), cuts, lost,
    )  # fmt: skip
    mirrors = np.zeros((2, SLOPES, 4))
    fill_mirrors(shrinks, np.ones(2), np.zeros((8, 3)), light, lost, mirrors)
    ripples = Ripples()
    ripples.make(rows, (1.0, 0.0), 0.0, 0.0)
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    paint_sea(
        pixels, clip, eye, shrinks, cuts, np.zeros(2, np.int64), mirrors, np.ones(2), ripples.tiles, froth_of(),
        glow_table(), light, moves, np.full(2, 256, np.int64), 2, pixels[:0, :0].copy(), 0,
    )  # fmt: skip
