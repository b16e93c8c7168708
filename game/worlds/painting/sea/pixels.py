"""Pixels of a sea: what slopes mirror, the glitter of the sun, foam, and a boat upside down.

What is nearer is painted first, and each column of pixels only goes up from there: no pixel is painted
twice. What a slope mirrors is looked up by its angle to the eye; the sun shines where a slope turns to it.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Inks, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, bounds_of
from game.worlds.painting.sea.cuts import AWAY, FOAM, HORIZON, OFF_X, OFF_Z, STEP, THIN, TILT, TOP
from game.worlds.painting.sea.ripples import SIDE, UNIT

SLOPES, STEEPEST = 128, 1.2  # places in a table of what slopes mirror, and to which slope
GLOWS = 512  # places in the table of the sun's glitter


class Shades(NamedTuple):
    """Of each cut: levels (l,) of the tiles by which it is seen; mirrors (l, SLOPES, 4): what a slope shows,
    and the share of it that is mirrored; rough (l,): mean squares of slopes that are not seen one by one;
    veils (l,): how much of what lies behind it hides, 256 being all of it.
    """

    levels: Longs
    mirrors: Floats
    rough: Floats
    veils: Longs


class Patterns(NamedTuple):
    """Tiles of `Ripples`, froth and glitter; moves (2,): m by which foam has gone along x and z."""

    tiles: NDArray[np.int16]
    froth: NDArray[np.uint8]
    glows: Floats
    moves: Floats


class Paper(NamedTuple):
    """Pixels and what of them is painted. bare (h, w): the picture from the column ``beside`` on before there
    was a boat in it, which the water mirrors. every: of so many columns one is lit, the others are between.
    """

    pixels: Inks
    clip: Longs
    bare: Inks
    beside: int
    every: int


@lean_kernel
def fill_mirrors(shrinks, shades, sky, light, haze):
    """The mirrors of shades. sky (n, 3): its colours by the root of the sine of height; haze (l,): shares of
    the colour of the horizon.
    """
    rough, mirrors = shades.rough, shades.mirrors
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
def _light_pixel(mirror, last, k, light, patterns, seen, slopes, place, dull):
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
        glow = patterns.glows[int(spot * (GLOWS / 8.0))] * (0.25 + sent) * light.glint
    red = last[n, 0] + k * (mirror[n, 0] - last[n, 0]) + thin * light.thin[0] + glow * light.sun[0]
    green = last[n, 1] + k * (mirror[n, 1] - last[n, 1]) + thin * light.thin[1] + glow * light.sun[1]
    blue = last[n, 2] + k * (mirror[n, 2] - last[n, 2]) + thin * light.thin[2] + glow * light.sun[2]
    if foam > 0.0:
        white = min((_white(patterns.froth, place[0], place[1]) - 255.0 + 255.0 * foam) * 0.0102, 0.92)
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
def _mirrored(paper, row, column, eye, z, tilt, rx, mirror, ink):
    """A pixel's ink, with the boat in it if that is what the water mirrors there."""
    bare, beside, apart = paper.bare, paper.beside, -2.0 * z * eye.scale
    high = int(2.0 * eye.zero - row - apart * tilt)
    at = int(column - apart * rx)
    if not (0 <= high < row and beside <= at < beside + bare.shape[1] and high < bare.shape[0]):
        return ink
    boat = int(paper.pixels[high, at])
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
def paint_sea(paper, eye, light, cuts, shades, patterns):
    """Paint cuts, the nearest first, upwards. The light's thin crest is what it has over deep water."""
    pixels, every, tiles, shrinks = paper.pixels, paper.every, patterns.tiles, cuts.shrinks
    samples, moves = cuts.samples, patterns.moves
    x_low, y_low, x_high, y_high = bounds_of(pixels, paper.clip)
    left, beside, wide = paper.clip[0], paper.beside, paper.bare.shape[1]
    last_sample = samples.shape[2] - 1
    to_cell, ahead = tiles.shape[2] / SIDE, 64.0 * SIDE
    most = tiles.shape[0] - 1
    above = y_high
    for column in range(x_low, x_high, every):
        place = min(max((column - left) / STEP - 0.5, 0.0), last_sample - 1e-6)
        i = int(place)
        f = place - i
        across = (column - left - eye.left) / eye.scale - eye.x  # m from the eye, in the plane x, y
        lean = across / math.sqrt(across * across + AWAY * AWAY)
        before = samples[0, TOP, i] + f * (samples[0, TOP, i + 1] - samples[0, TOP, i])
        lowest = y_high if before >= y_high else max(math.ceil(before), y_low)
        foot = lowest
        s0 = samples[0, TILT, i] + f * (samples[0, TILT, i + 1] - samples[0, TILT, i])
        x0 = samples[0, OFF_X, i] + f * (samples[0, OFF_X, i + 1] - samples[0, OFF_X, i])
        z0 = samples[0, OFF_Z, i] + f * (samples[0, OFF_Z, i + 1] - samples[0, OFF_Z, i])
        t0 = samples[0, THIN, i] + f * (samples[0, THIN, i + 1] - samples[0, THIN, i])
        w0 = samples[0, FOAM, i] + f * (samples[0, FOAM, i + 1] - samples[0, FOAM, i])
        p0 = shrinks[0]
        for cut in range(1, shrinks.size):
            top = samples[cut, TOP, i] + f * (samples[cut, TOP, i + 1] - samples[cut, TOP, i])
            s1 = samples[cut, TILT, i] + f * (samples[cut, TILT, i + 1] - samples[cut, TILT, i]) - s0
            x1 = samples[cut, OFF_X, i] + f * (samples[cut, OFF_X, i + 1] - samples[cut, OFF_X, i]) - x0
            z1 = samples[cut, OFF_Z, i] + f * (samples[cut, OFF_Z, i + 1] - samples[cut, OFF_Z, i]) - z0
            t1 = samples[cut, THIN, i] + f * (samples[cut, THIN, i + 1] - samples[cut, THIN, i]) - t0
            w1 = samples[cut, FOAM, i] + f * (samples[cut, FOAM, i + 1] - samples[cut, FOAM, i]) - w0
            p1 = shrinks[cut] - p0
            first = max(math.floor(top), y_low)
            if first < lowest:
                long = 1.0 / max(before - top, 1.0)
                level = shades.levels[cut]
                to_row = to_cell / (1 << min(level, most))
                to_column = 0.5 * to_cell if level > 1 else to_cell
                dull, mirror = 1.0 / shades.rough[cut], shades.mirrors[cut]
                for row in range(first, lowest):
                    k = min(max((before - row) * long, 0.0), 1.0)
                    inverse = 1.0 / (p0 + k * p1)
                    x = across * inverse + eye.x + ahead
                    z = AWAY * inverse - AWAY + ahead
                    rx, rz = 0.0, 0.0
                    if level <= most:
                        rx, rz = _slopes(tiles, level, x * to_column, z * to_row)
                    seen = s0 + k * s1, x0 + k * x1, z0 + k * z1, t0 + k * t1, w0 + k * w1
                    ink = _light_pixel(
                        mirror, shades.mirrors[cut - 1], k, light, patterns, seen, (rx, rz, lean),
                        (x + moves[0], z + moves[1]), dull,
                    )  # fmt: skip
                    if beside <= column < beside + wide:
                        tilt = s0 + k * s1 + rz + lean * rx
                        ink = _mirrored(paper, row, column, eye, z - ahead, tilt, rx, mirror, ink)
                    if shades.veils[cut] >= 256:
                        pixels[row, column] = 0xFF000000 | ink
                    else:
                        blend(pixels, row, column, ink, shades.veils[cut])
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


@lru_cache(maxsize=1)
def froth_of() -> NDArray[np.uint8]:
    """(512, 512) from 0 to 255, as much of it below each value as the value says; it goes on at its sides."""
    random = np.random.default_rng(5)
    size = np.hypot(np.fft.fftfreq(512)[:, None], np.fft.rfftfreq(512)[None, :]) * 512.0
    noise = np.fft.irfft2(np.fft.rfft2(random.standard_normal((512, 512))) * (size + 6.0) ** -1.15)
    veins = np.fft.irfft2(np.fft.rfft2(random.standard_normal((512, 512))) * (size + 20.0) ** -1.9)
    noise = noise / np.std(noise) - 1.1 * np.abs(veins / np.std(veins))
    ranks = np.empty(noise.size, np.uint8)
    ranks[np.argsort(noise, axis=None, kind="stable")] = np.arange(noise.size) * 256 // noise.size
    return ranks.reshape(noise.shape)


@lru_cache(maxsize=1)
def glow_table() -> Floats:
    """(GLOWS,) of the sun's glitter by the square of a slope's distance over the roughness, 0 to 8."""
    return np.asarray((np.exp(-4.0 * np.arange(GLOWS) / GLOWS) - math.exp(-4.0)) / (1.0 - math.exp(-4.0)))
