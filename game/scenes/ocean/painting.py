"""Pixels of a sea that goes to the horizon: cuts through its waves one behind the other, lit, with foam.

Cuts lie at depths that are even in the picture. What is nearer is painted first, and each column of pixels
only goes up from there, so that no pixel is painted twice. Foam stands where the water falls by so much of
gravity that a crest breaks (Longuet-Higgins 1969).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Inks
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, bounds_of
from game.worlds.painting.inks import channels, opaque

STEP = 4  # px from one sample of a cut to the next
HORIZON, AWAY = 4.2, 27.0  # m over the water, and before the boat: of the eye
NEAREST, FARTHEST = 1.0, 0.012  # of the shrinking of what is at the boat
BREAKS, WHITE = 0.15, 0.36  # of gravity: where foam begins, and is full
LAYERS_FAR, LAYERS_NEAR = 52, 42


Triple = tuple[float, float, float]


class Eye(NamedTuple):
    """Where the picture is seen from, m along; the height (m) of its horizon; px of a point of the world:
    columns and rows of the origin, px to a m."""

    x: float
    left: float
    zero: float
    scale: float


class Light(NamedTuple):
    """Colours of deep water, of a thin crest, of sky at the horizon and above, of the sun (0 to 255 each);
    the sun's direction."""

    deep: Triple
    thin: Triple
    low: Triple
    high: Triple
    sun: Triple
    to: Triple
    glint: float


def shrink(z: Any) -> Any:
    """How large what stands z m behind the boat is beside what stands at it."""
    return AWAY / (AWAY + np.maximum(z, -0.8 * AWAY))


def projected(eye: float, x: Any, y: Any, z: Any) -> Any:
    """Places (n, 2) of the world's plane at the boat at which points are seen."""
    part = shrink(z)
    return np.stack([eye + (x - eye) * part, HORIZON + (y - HORIZON) * part], axis=-1)


@inner_kernel
def _add_cuts(rows, z, first, step, sums):
    """Levels, both slopes and downward accelerations (4, w) of the sea along x at z, from first by step."""
    count = sums.shape[1]
    for k in range(4):
        for i in range(count):
            sums[k, i] = 0.0
    for n in range(rows.shape[0]):
        high, kx, kz, rate = rows[n, 0], rows[n, 1], rows[n, 2], rows[n, 3]
        turn = kx * step
        high *= max(1.0 - abs(turn) / 2.4, 0.0)  # shorter than samples can show
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


@lean_kernel
def see_sea(rows, shrinks, eye, light, grain, gravity, sums, tops, colors):
    """Cuts (l,) by how they shrink: tops (l, w) px, colors (l, w, 4) red, green, blue 0 to 255, foam 0 to
    1."""
    count = tops.shape[1]
    for cut in range(shrinks.shape[0]):
        part = shrinks[cut]
        z = AWAY / part - AWAY
        step = STEP / (eye.scale * part)
        first = eye.x + (0.5 * STEP - eye.left) / (eye.scale * part) - eye.x / part
        # the column of the world's x is left + scale (eye + (x - eye) part)
        _add_cuts(rows, z, first, step, sums)
        haze = min(max((z + AWAY) / 900.0, 0.0), 1.0) ** 0.7
        for i in range(count):
            level, sx, sz = sums[0, i], sums[1, i], sums[2, i]
            tops[cut, i] = eye.zero - eye.scale * (HORIZON + (level - HORIZON) * part)
            x = first + step * i
            nx, ny, nz = -sx, 1.0, -sz
            size = 1.0 / math.sqrt(nx * nx + ny * ny + nz * nz)
            nx, ny, nz = nx * size, ny * size, nz * size
            vx, vy, vz = eye.x - x, HORIZON - level, -(z + AWAY)
            size = 1.0 / math.sqrt(vx * vx + vy * vy + vz * vz)
            vx, vy, vz = vx * size, vy * size, vz * size
            facing = max(nx * vx + ny * vy + nz * vz, 0.0)
            bare = 1.0 - facing
            mirror = 0.03 + 0.9 * bare * bare * bare * bare * (0.55 + 0.45 * bare)
            rx, ry, rz = 2.0 * facing * nx - vx, 2.0 * facing * ny - vy, 2.0 * facing * nz - vz
            up = math.sqrt(min(max(ry, 0.0), 1.0))
            shine = max(rx * light.to[0] + ry * light.to[1] + rz * light.to[2], 0.0)
            shine2 = shine * shine
            shine8 = shine2 * shine2 * shine2 * shine2
            gloss = light.glint * (shine8**12) + 0.16 * light.glint * shine8 * shine8
            thin = min(max(0.28 + 0.34 * level - 0.7 * sz, 0.0), 1.0)
            sun = max(nx * light.to[0] + ny * light.to[1] + nz * light.to[2], 0.0)
            g = grain[(cut * 61 + int(x * 9.0)) & 4095]
            breaks = (sums[3, i] / gravity - BREAKS) / (WHITE - BREAKS) + 0.7 * (g - 0.6)
            foam = min(max(breaks, 0.0), 1.0) * (1.0 - 0.6 * haze)
            colors[cut, i, 3] = foam
            for c in range(3):
                body = light.deep[c] + (light.thin[c] - light.deep[c]) * thin
                body *= 0.72 + 0.4 * sun
                sky = light.low[c] + (light.high[c] - light.low[c]) * up
                seen = body + (sky - body) * mirror + light.sun[c] * gloss
                seen += (0.5 * light.low[c] + 0.5 * light.sun[c] - seen) * foam * (0.55 + 0.4 * g)
                seen += (light.low[c] - seen) * 0.8 * haze
                colors[cut, i, c] = min(max(seen, 0.0), 255.0)


@lean_kernel
def paint_sea(pixels, clip, tops, colors, veils):
    """Paint cuts (l, w), the nearest first, upwards from the lower edge. veils (l,): how much of what lies
    behind each hides, 256 being all of it."""
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    last_sample = tops.shape[1] - 1
    for column in range(x_low, x_high):
        place = min(max((column - clip[0]) / STEP - 0.5, 0.0), last_sample - 1e-6)
        i = int(place)
        f = place - i
        lowest, before, r0, g0, b0 = y_high, 1.0 * y_high, -1.0, 0.0, 0.0
        for cut in range(tops.shape[0]):
            top = tops[cut, i] + f * (tops[cut, i + 1] - tops[cut, i])
            r = colors[cut, i, 0] + f * (colors[cut, i + 1, 0] - colors[cut, i, 0])
            g = colors[cut, i, 1] + f * (colors[cut, i + 1, 1] - colors[cut, i, 1])
            b = colors[cut, i, 2] + f * (colors[cut, i + 1, 2] - colors[cut, i, 2])
            if r0 < 0.0:
                r0, g0, b0 = r, g, b
            first = max(math.floor(top), y_low)
            if first < lowest:
                long = max(before - top, 1.0)
                veil = veils[cut]
                for row in range(first, lowest):
                    share = min(max((before - row) / long, 0.0), 1.0)
                    red, green = int(r0 + (r - r0) * share), int(g0 + (g - g0) * share)
                    blue = int(b0 + (b - b0) * share)
                    ink = red << 16 | green << 8 | blue
                    if veil >= 256:
                        pixels[row, column] = 0xFF000000 | ink
                    else:
                        blend(pixels, row, column, ink, veil)
                lowest = first
            before, r0, g0, b0 = top, r, g, b


@lru_cache(maxsize=1)
def grain_of() -> Floats:
    """(4096,) 0 to 1, for foam."""
    random = np.random.default_rng(5)
    rough = random.random(4096)
    return np.asarray(0.5 * rough + 0.3 * np.roll(rough, 1) + 0.2 * np.roll(rough, 2))


class SeaPainter:
    """Keeps the cuts of a picture."""

    def __init__(self) -> None:
        self._width = 0

    def _fit(self, width: int) -> None:
        count = -(-width // STEP) + 2
        if count != self._width:
            self._width = count
            self._sums = np.zeros((4, count))
            self._tops = [np.zeros((n, count)) for n in (LAYERS_NEAR, LAYERS_FAR)]
            self._colors = [np.zeros((n, count, 4)) for n in (LAYERS_NEAR, LAYERS_FAR)]

    def paint(self, canvas: Any, rows: Floats, light: Light, near: bool, gravity: float) -> None:
        """The sea before the boat, or behind it, by its waves (n, 5)."""
        pixels, clip = canvas.raster_target
        width = int(clip[2] - clip[0])
        if width <= 1:
            return
        self._fit(width)
        seen = canvas.camera.visible()
        x, y = canvas.place((0.0, 0.0))
        scale = float(canvas.pixels_per_unit)
        eye = Eye(0.5 * (seen.left + seen.right), float(x - clip[0]), float(y), scale)
        lowest = max((HORIZON - seen.bottom) / HORIZON, NEAREST + 0.05) * 1.6
        if near:
            shrinks = np.linspace(lowest, NEAREST + 0.035, LAYERS_NEAR)
            veils = np.linspace(256.0, 205.0, LAYERS_NEAR).astype(np.int64)
        else:
            shrinks = np.linspace(NEAREST + 0.12, FARTHEST, LAYERS_FAR)
            veils = np.full(LAYERS_FAR, 256, np.int64)
        which = 0 if near else 1
        tops, colors = self._tops[which], self._colors[which]
        rows = np.ascontiguousarray(rows)
        see_sea(rows, shrinks, eye, light, grain_of(), max(gravity, 0.1), self._sums, tops, colors)
        paint_sea(pixels, clip, tops, colors, veils)


def warm_up_sea() -> None:
    """Compile what paints, on a tiny picture."""
    tops, colors = np.zeros((2, 4)), np.zeros((2, 4, 4))
    light = Light(*(((0.0, 0.0, 0.0),) * 6), 1.0)
    rows = np.array([[0.1, 0.3, 0.1, 1.0, 0.0]])
    see_sea(
        rows,
        np.array((1.0, 0.5)),
        Eye(0.0, 4.0, 4.0, 1.0),
        light,
        grain_of(),
        9.81,
        np.zeros((4, 4)),
        tops,
        colors,
    )
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    paint_sea(pixels, clip, tops, colors, np.full(2, 256, np.int64))


# -- the sky ------------------------------------------------------------------------------------------------

# by day and late, fair and in a storm: above, at the horizon, clouds in light, clouds in shade
SKIES = (
    ((0x4E8BC4, 0xD9E7EA, 0xFFFFFF, 0xB4C3CF), (0x59646E, 0xA3ABAD, 0x979FA4, 0x5E6870)),
    ((0x1C2450, 0xF0A060, 0xFFC890, 0x6C5068), (0x323A48, 0x84807F, 0x74727A, 0x424852)),
)
LIGHTS = (
    (
        Light(
            (10, 58, 92),
            (46, 138, 140),
            (214, 228, 232),
            (92, 150, 204),
            (255, 246, 222),
            (0.36, 0.44, 0.82),
            1.0,
        ),
        Light(
            (22, 50, 62),
            (58, 104, 104),
            (158, 167, 170),
            (90, 100, 110),
            (190, 196, 196),
            (0.36, 0.6, 0.71),
            0.12,
        ),
    ),
    (
        Light(
            (14, 26, 52), (52, 76, 90), (226, 148, 96), (40, 48, 92), (255, 190, 120), (0.36, 0.2, 0.91), 1.2
        ),
        Light(
            (22, 38, 50), (56, 88, 92), (128, 124, 126), (56, 64, 78), (176, 168, 160), (0.36, 0.5, 0.79), 0.1
        ),
    ),
)
SUN = (0.74, 0.3)  # shares of the width and of the height above the horizon
LEVELS = 16  # of a storm, in which the sky is kept


def light_of(late: bool, storm: float) -> Light:
    """Between fair weather (0) and a storm (1)."""
    fair, bad = LIGHTS[late]

    def mixed(one: Triple, other: Triple) -> Triple:
        red, green, blue = (a + (b - a) * storm for a, b in zip(one, other, strict=True))
        return red, green, blue

    colors = [mixed(one, other) for one, other in zip(fair[:6], bad[:6], strict=True)]
    deep, thin, low, high, sun, to = colors
    return Light(deep, thin, low, high, sun, to, fair.glint + (bad.glint - fair.glint) * storm)


@lru_cache(maxsize=2)
def clouds_of(rows: int, columns: int) -> tuple[Floats, Floats]:
    """(rows, columns) of noise -1 to 1 that goes on at its sides, flatter towards the horizon; its slope."""
    random = np.random.default_rng(15)
    tall, wide = 256, 1024
    spectrum = np.fft.rfft2(random.standard_normal((tall, wide)))
    ky, kx = np.fft.fftfreq(tall)[:, None] * tall, np.fft.rfftfreq(wide)[None, :] * wide
    size = np.sqrt(ky * ky + 0.3 * kx * kx) + 5.0
    noise = np.fft.irfft2(spectrum * size**-2.5, s=(tall, wide))
    noise /= np.std(noise)
    down = np.linspace(0.0, 1.0, rows)
    at = (250.0 / (1.3 - down)) % tall  # rows crowd towards the horizon
    j = at.astype(np.int64)
    part = (at - j)[:, None]
    x = np.linspace(0.0, wide, columns, endpoint=False)
    i = x.astype(np.int64)
    f = (x - i)[None, :]
    both = [noise[k % tall][:, i] * (1.0 - f) + noise[k % tall][:, (i + 1) % wide] * f for k in (j, j + 1)]
    field = both[0] * (1.0 - part) + both[1] * part
    light = field - np.roll(field, -max(columns // 60, 1), axis=1)
    return field, light


@lru_cache(maxsize=LEVELS + 1)
def sky_of(rows: int, columns: int, late: bool, level: int) -> Inks:
    """(rows, columns) of a sky down to the horizon, ``level`` of LEVELS stormy; it goes on at its sides."""
    storm = level / LEVELS
    small = (rows + 1) // 2, (columns + 1) // 2
    fair, bad = (np.array([channels(ink) for ink in one]) for one in SKIES[late])
    above, low, lit, shade = fair + (bad - fair) * storm
    down = (np.linspace(0.0, 1.0, small[0]) ** 1.4)[:, None, None]
    field, light = clouds_of(*small)
    colors = np.broadcast_to(above + (low - above) * down, (*small, 3)).copy()
    cover = np.clip((field - 0.15 + 1.9 * storm) / 1.6, 0.0, 1.0)[..., None]
    cover = cover * cover * (3.0 - 2.0 * cover) * (0.92 - 0.35 * down * (1.0 - storm))
    bright = np.clip(0.62 + 1.1 * light - 0.28 * field, 0.0, 1.0)[..., None]
    cloud = shade + (lit - shade) * bright
    colors += (cloud - colors) * cover
    colors += (low - colors) * 0.9 * down**5
    colors[:, 1:-1] = 0.25 * (colors[:, :-2] + colors[:, 2:]) + 0.5 * colors[:, 1:-1]
    return np.ascontiguousarray(np.repeat(np.repeat(opaque(colors), 2, axis=0), 2, axis=1)[:rows, :columns])
