"""Light on the tower by day and by night, and what stands about it: sky, a town, the street, lamps."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.scenes.tower.air import LAMP_RISES, LAMPS_AT
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.lights import sky_picture
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.inks import channels, color_of, packed, shaded


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


BEHIND = ((0.06, 2.0), (0.14, 1.4), (0.3, 0.9))  # of the towns: share of the camera's way, of their size
LIT_WINDOWS = (0xFFC36B, 0xFFE0A6, 0xA9C7FF)
WINDOW = (0.16, 0.2)  # half of it, beside the way from one to the next
LIT_SHARE = 0.12  # of windows with a lamp behind
WIDE = 260.0  # m of a town to both sides
CLOUD_CELLS = (40, 72)  # rows and columns of the clouds
CLOUDS_M = 64.0  # m up to which they stand
CLOUDS_SLIDE = 0.05  # cells for each metre of the camera's way
GROUND_BANDS, GROUND_M = 14, 16.0  # bands of the street, m below the horizon in all
FENCE = (17.5, 46.0, 1.5)  # m: where it begins and ends at both sides, its height


class Town(NamedTuple):
    """roofs (n, 2) m from the left to the right; windows (4 k, 2) m that are lit, and their colours."""

    roofs: Floats
    windows: Floats
    inks: Longs


class Site:
    """Paints what does not move."""

    def __init__(self) -> None:
        random = np.random.default_rng(3)
        self._clouds = _clouds(random)
        self._towns = [_town(random, size) for _, size in BEHIND]

    def paint(self, canvas: Canvas) -> None:
        """Sky, moon or sun, three rows of a town, the street, a fence and the lamps."""
        hour, seen = hour_of(canvas), canvas.camera.visible()
        night = hour.lamps > 0.0
        rows, columns = canvas.raster_target[0].shape
        stops = tuple(zip((0.0, 0.6, 1.0), map(color_of, hour.sky), strict=True))
        canvas.backdrop(sky_picture(stops, rows, min(columns, 64)), 0.0, rows)
        if night:
            canvas.stars(0.0, 260, 5, 0.8)
        width, (x, _) = seen.right - seen.left, canvas.camera.center
        sun = seen.left + 0.79 * width, 0.36 * (seen.top - seen.bottom) + max(seen.bottom, 0.0)
        canvas.soft_glow([sun], [0.12 * width], hour.sun, 0.3)
        self._paint_clouds(canvas, hour, sun)
        canvas.discs(np.array([sun]), 0.017 * width, color_of(hour.sun), 1.0)
        for (slide, size), town, ink in zip(BEHIND, self._towns, hour.towns, strict=True):
            self._paint_town(canvas, town, ink, ((1.0 - slide) * x, -0.4 * size), night)
        self._paint_ground(canvas, hour, sun[0])
        self._paint_fence(canvas, hour)
        if night:
            self._paint_lamps(canvas, hour)
        canvas.bloom(0.8)

    def _paint_clouds(self, canvas: Canvas, hour: Hour, sun: tuple[float, float]) -> None:
        """Thin clouds, brighter about the moon or the sun."""
        seen = canvas.camera.visible()
        width, x = seen.right - seen.left, canvas.camera.center[0]
        shift = round(x * CLOUDS_SLIDE) % self._clouds.shape[1]
        cover = np.roll(self._clouds, -shift, axis=1)
        rows, columns = cover.shape
        away = np.hypot(
            (np.arange(columns) / columns * width + seen.left - sun[0])[None, :],
            1.4 * (np.arange(rows)[:, None] / rows * CLOUDS_M - sun[1]),
        )
        glow = cover * np.exp(-away / (0.16 * width))
        some, most = map(color_of, hour.sheen)
        stops = ((0.0, color_of(0)), (0.5, some), (1.0, most))
        veil = np.stack([0.35 * cover, glow], axis=2)
        canvas.veil(veil, (seen.left, 0.0), (seen.right, CLOUDS_M), color_of(hour.towns[0]), stops)

    @staticmethod
    def _paint_town(canvas: Canvas, town: Town, ink: int, by: tuple[float, float], night: bool) -> None:
        seen = canvas.camera.visible()
        shifted = town.roofs + np.array(by)
        near = (shifted[:, 0] > seen.left - 40.0) & (shifted[:, 0] < seen.right + 40.0)
        kept = shifted[near]
        if len(kept) > 2:
            outline = np.concatenate([[(kept[0, 0], -2.0)], kept, [(kept[-1, 0], -2.0)]])
            canvas.polygon(outline, fill=color_of(ink))
        if night:
            paint_quads(canvas, town.windows + np.array(by), town.inks, 0.8)

    @staticmethod
    def _paint_ground(canvas: Canvas, hour: Hour, sun_x: float) -> None:
        """A street in bands, the nearer the darker, with the light of the sun or the moon on it."""
        seen = canvas.camera.visible()
        near, far = color_of(hour.ground[1]), color_of(hour.ground[0])
        heights = -GROUND_M * np.linspace(0.0, 1.0, GROUND_BANDS + 1) ** 1.6
        heights[-1] = min(seen.bottom, -GROUND_M) - 1.0
        wide = 0.02 * (seen.right - seen.left)
        for k in range(GROUND_BANDS):
            ink = far.lerp(near, k / (GROUND_BANDS - 1.0))
            top, low = float(heights[k]), float(heights[k + 1])
            canvas.polygon(
                [(seen.left, top), (seen.right, top), (seen.right, low), (seen.left, low)], fill=ink
            )
            half = wide * (0.8 + 0.22 * k)
            path = [(sun_x - half, top), (sun_x + half, top), (sun_x + half + 0.22 * wide, low),
                    (sun_x - half - 0.22 * wide, low)]  # fmt: skip
            canvas.polygon(path, fill=color_of(hour.sun), fill_alpha=0.12 * (1.0 - k / GROUND_BANDS) ** 2)

    @staticmethod
    def _paint_fence(canvas: Canvas, hour: Hour) -> None:
        """Boards round the site, to both sides of what comes down."""
        first, last, tall = FENCE
        left = np.arange(first, last, 2.4)
        boxes = np.array([[(a, 0.0), (a + 2.3, 0.0), (a + 2.3, tall), (a, tall)] for a in left])
        both = np.concatenate([boxes, boxes * (-1.0, 1.0)]).reshape(-1, 2)
        near = np.tile(np.exp(-(((left - LAMPS_AT) / 7.0) ** 2)), 2)
        light = 0.35 + 0.65 * near * hour.lamps if hour.lamps else np.ones(len(near))
        inks = shaded(np.full(len(light), hour.slab), light - 1.0)
        paint_quads(canvas, both, inks, 1.0, hour.edge)

    @staticmethod
    def _paint_lamps(canvas: Canvas, hour: Hour) -> None:
        """Two masts with lamps that point at the tower."""
        for side in (-1.0, 1.0):
            x = side * LAMPS_AT
            mast = np.array([(x - 0.12, 0.0), (x + 0.12, 0.0), (x + 0.12, 4.6), (x - 0.12, 4.6)])
            head = np.array([(x - 0.7, 4.5), (x + 0.7, 4.5), (x + 0.6, 5.3), (x - 0.6, 5.3)])
            paint_quads(canvas, np.concatenate([mast, head]), 0x15171D, 1.0, hour.edge)
            lens = np.array([(x - 0.5, 4.65), (x + 0.5, 4.65), (x + 0.45, 5.15), (x - 0.45, 5.15)])
            paint_quads(canvas, lens, 0xFFF3D6)
            canvas.soft_glow([(x, 4.9)], [7.0], hour.lamp, 0.9)
            canvas.soft_glow([(x - 6.0 * side, 0.4)], [9.0], hour.lamp, 0.25)


def _clouds(random: np.random.Generator) -> Floats:
    """How thick clouds are (rows, columns), 0 to 1: noise of four sizes, long and flat, fewer above."""
    rows, columns = CLOUD_CELLS
    found = np.zeros(CLOUD_CELLS)
    for parts, weight in ((3, 1.0), (6, 0.6), (12, 0.35), (24, 0.2)):
        knots = random.random((2 * parts, parts))
        v, u = np.linspace(0.0, 2 * parts - 1.001, rows), np.arange(columns) * parts / columns
        j, i = v.astype(int), u.astype(int)
        a, b = (v - j)[:, None], (u - i)[None, :]
        a, b, after = a * a * (3.0 - 2.0 * a), b * b * (3.0 - 2.0 * b), (i + 1) % parts
        low = knots[j][:, i] * (1.0 - b) + knots[j][:, after] * b
        high = knots[j + 1][:, i] * (1.0 - b) + knots[j + 1][:, after] * b
        found += weight * (low * (1.0 - a) + high * a)
    found = np.clip((found / 2.15 - 0.46) * 3.2, 0.0, 1.0)
    return np.asarray(found * np.linspace(1.0, 0.0, rows)[:, None])


def _town(random: np.random.Generator, scale: float) -> Town:
    """Houses side by side, some with masts; behind some windows there is light."""
    points, windows, inks, x = [], [], [], -WIDE
    while x < WIDE:
        wide, tall = random.uniform(2.0, 5.5) * scale, random.uniform(2.5, 9.0) * scale
        points += [(x, tall), (x + wide, tall)]
        across, up = 0.3 + 0.25 * scale, 0.35 + 0.3 * scale  # from window to window
        a, b = WINDOW[0] * across, WINDOW[1] * up
        for u in np.arange(x + 0.7 * across, x + wide - 0.5 * across, across).tolist():
            for v in np.arange(0.8 * scale, tall - 0.5 * up, up).tolist():
                if random.random() < LIT_SHARE:
                    windows += [(u - a, v - b), (u + a, v - b), (u + a, v + b), (u - a, v + b)]
                    inks.append(LIT_WINDOWS[int(random.integers(len(LIT_WINDOWS)))])
        if random.random() < 0.25:  # a mast
            middle = x + 0.5 * wide
            points[-1:-1] = [(middle - 0.1, tall), (middle, tall + 2.2 * scale), (middle + 0.1, tall)]
        x += wide
        if random.random() < 0.4:
            gap = random.uniform(0.6, 4.0) * scale
            points += [(x, 1.2 * scale), (x + gap, 1.2 * scale)]
            x += gap
    return Town(np.array(points), np.array(windows), np.array(inks))
