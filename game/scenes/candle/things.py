"""Candle, flame and glass, painted once each: wax in two lights, a teardrop of light, clear walls."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from game.arrays import Singles
from game.scenes.candle.air import CANDLE, TOP, WALL
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.dusk_room import LEAN, SHINES
from game.worlds.painting.shades import Light, Plane, bump, grid_of, in_two_lights, lay_lit, lit, smoothstep

WAX_BOX = ((-0.017, -0.005), (0.017, TOP + 0.004))  # m
FLAME_HALF, FLAME_WIDE = 0.034, 0.0072  # m: half of the flame's picture, of itself where it is widest
MARGIN, FOOT = 0.014, 0.016  # m of the glass's picture beside and above it, and below
SHOULDER, THICK = (
    0.034,
    0.0048,
)  # m: radius of the glass where its wall becomes its top; of its wall as it is seen
WAX = (240.0, 226.0, 198.0)
DRIPS = (  # where they leave the rim, how far they come, how thick they are, m
    (0.0066, 0.021, 0.0016), (-0.0078, 0.036, 0.0013), (-0.0022, 0.0425, 0.0014), (0.0096, 0.038, 0.0011),
)  # fmt: skip


def draw_wax(canvas: Canvas, own: Light, flame: Light) -> None:
    """The candle without its wick."""
    lay_lit(canvas, wax_picture(), WAX_BOX, own, flame)


def draw_glass(canvas: Canvas, size: tuple[float, float], rim: float, own: Light, flame: Light) -> None:
    """The glass, half so wide inside and so high, its rim at a height, m."""
    wide, tall = size[0] + WALL + MARGIN, size[1] + WALL + MARGIN
    lay_lit(canvas, glass_picture(*size), ((-wide, rim - FOOT), (wide, rim + tall)), own, flame)


def _capsule(x: Plane, y: Plane, at: float, low: float, thick: float) -> Plane:
    """How far outside a drip from the rim down to ``low``, m; it is thicker where it ends."""
    radius = thick * (0.8 + 0.45 * bump(y - low, 0.004))
    beside = x - at - 0.0005 * np.sin(240.0 * y + 900.0 * at)
    beyond = np.maximum(low - y, 0.0) + np.maximum(y - TOP + 0.0015, 0.0)
    return np.asarray(np.sqrt(beside * beside + beyond * beyond) - radius)


@lru_cache(maxsize=1)
def wax_picture() -> Singles:
    """Wax: a rounded shoulder, a rim about a pool, drips; light goes through it near the top."""
    x, y = grid_of(WAX_BOX, (290, 170))
    across = np.clip(x / CANDLE, -1.0, 1.0)
    round_ = np.sqrt(1.0 - across * across)
    rim = TOP + 0.0009 * np.sin(420.0 * x + 0.6) + 0.0005 * np.sin(900.0 * x)
    corner = np.maximum(np.abs(x) - CANDLE + 0.004, 0.0) / 0.004
    top = rim - 0.004 * (1.0 - np.sqrt(np.clip(1.0 - corner * corner, 0.0, 1.0)))
    inside = smoothstep(0.0002, -0.0002, np.abs(x) - CANDLE) * smoothstep(0.0002, -0.0002, y - top)
    inside = inside * smoothstep(-0.0003, 0.0003, y + LEAN * CANDLE * round_)
    cover, lift, side = inside.copy(), np.zeros(x.shape), np.zeros(x.shape)
    for at, low, thick in DRIPS:
        out = _capsule(x, y, at, low, thick)
        here = smoothstep(0.00025, -0.00025, out)
        cover = np.maximum(cover, here * (y < TOP))
        lift = np.maximum(lift, here)
        side += here * np.clip((x - at) / thick, -1.0, 1.0)
    deep = np.maximum(TOP - y, 0.0)
    through = 1.25 * np.exp(-deep / 0.0085) + 0.4 * np.exp(-deep / 0.03)
    flame = (
        through * (0.5 + 0.5 * round_) * (1.0 - 0.22 * side)
        + 0.17 * round_
        + 0.14 * lift * np.exp(-deep / 0.03)
    )
    own = 0.24 + 0.5 * np.clip(-0.75 * across + 0.5 * round_, 0.0, 1.0) + 0.1 * lift - 0.13 * side
    own += 0.25 * bump(across + 0.72, 0.09)  # a gleam of the window
    under = 1.0 - 0.5 * np.exp(-np.maximum(y, 0.0) / 0.004)
    color = np.array(WAX) * (1.0 + 0.0 * x)[..., None]
    color[..., 1] *= 1.0 - 0.16 * np.exp(-deep / 0.02)
    color[..., 2] *= 1.0 - 0.42 * np.exp(-deep / 0.025)  # what has gone through wax is redder
    pool = ((x / (0.8 * CANDLE)) ** 2 + ((y - TOP + 0.0016) / 0.0014) ** 2) ** 0.5
    wet = smoothstep(1.08, 0.95, pool)
    edge = bump(pool - 1.12, 0.1) * (np.abs(x) < CANDLE)
    glint = bump(x - 0.0035, 0.0012) * bump(y - TOP + 0.0011, 0.0004)
    flame = flame + 0.3 * edge - 0.28 * wet * smoothstep(1.0, 0.2, pool) + 0.8 * glint
    own = (own + 0.16 * edge - 0.1 * wet + 0.3 * glint) * under
    return lit(color, own, np.maximum(flame * under, 0.0), cover)


@lru_cache(maxsize=1)
def flame_picture() -> Singles:
    """A teardrop over its own height, 1, and 2 FLAME_HALF m: blue below, dark at the wick, then bright. Its
    blue stands in the layers of the room's light.
    """
    x, v = grid_of(((-FLAME_HALF, -0.06), (FLAME_HALF, 1.14)), (280, 340))
    within = np.clip(v, 1e-4, 1.0)
    half = FLAME_WIDE * (within**0.46 * (1.0 - within) ** 0.8) / 0.4205
    beyond = np.maximum(v - 1.0, 0.0) * 0.055 + np.maximum(-v, 0.0) * 0.055
    out = np.sqrt(np.maximum(np.abs(x) - half, 0.0) ** 2 + beyond * beyond)
    deep = np.clip((half - np.abs(x)) / FLAME_WIDE, 0.0, 1.0)
    body = smoothstep(0.0, 0.34, deep) * smoothstep(0.02, 0.3, v) * (1.0 - 0.25 * smoothstep(0.75, 1.0, v))
    dark = bump(v - 0.13, 0.14) * bump(x, 0.55 * FLAME_WIDE)
    body = body * (1.0 - 0.82 * dark)
    halo = np.exp(-out / 0.0022) * 0.2 + np.exp(-out / 0.009) * 0.1
    halo *= smoothstep(FLAME_HALF, 0.5 * FLAME_HALF, np.abs(x))
    halo *= smoothstep(0.0, 0.3, v) * smoothstep(1.14, 0.95, v)
    core = smoothstep(0.15, 0.75, deep)[..., None]
    bright = body[..., None] * ((1.05, 0.66, 0.2) + core * (0.25, 0.46, 0.5))
    bright += halo[..., None] * (1.0, 0.5, 0.16)
    shell = smoothstep(0.0, 0.14, deep) * smoothstep(0.5, 0.05, deep)
    shell += 0.5 * smoothstep(0.1, 0.3, deep) * (1.0 - dark)
    base = shell * smoothstep(0.34, 0.06, v) * smoothstep(-0.01, 0.04, v)
    cover = np.clip(0.75 * body + 0.7 * base + 0.35 * dark * (deep > 0.0), 0.0, 0.95)
    return in_two_lights(base[..., None] * (22.0, 70.0, 230.0), 255.0 * bright, cover)


def glass_inside(x: Plane, y: Plane, radius: float, high: float) -> Plane:
    """1 inside the glass that stands on the table, from its near rim up to its inner outline; 0 outside."""
    wide, tall = radius + WALL - THICK, high + WALL - THICK
    deep = _within(x, y, wide, tall, SHOULDER - THICK)
    rim = np.sqrt(np.maximum(1.0 - (x / (radius + WALL)) ** 2, 0.0)) * 0.6 * LEAN * (radius + WALL)
    return smoothstep(-0.0005, 0.0005, deep) * smoothstep(-0.0005, 0.0005, y + rim)


def _within(x: Plane, y: Plane, wide: float, tall: float, bend: float) -> Plane:
    """m within an outline that is round at its top corners; it goes on downwards."""
    dx, dy = np.abs(x) - wide + bend, y - tall + bend
    corner = np.sqrt(np.maximum(dx, 0.0) ** 2 + np.maximum(dy, 0.0) ** 2)
    return np.asarray(bend - corner - np.minimum(np.maximum(dx, dy), 0.0))


@lru_cache(maxsize=4)
def glass_picture(radius: float, high: float) -> Singles:
    """The glass, half so wide inside and so high (m): clear, seen by its edges and what it mirrors."""
    wide, tall = radius + WALL, high + WALL
    box = ((-wide - MARGIN, -FOOT), (wide + MARGIN, tall + MARGIN))
    x, y = grid_of(box, (round((tall + MARGIN + FOOT) / 5e-4), round(2.0 * (wide + MARGIN) / 5e-4)))
    deep = _within(x, y, wide, tall, SHOULDER)
    ring = np.sqrt((x / wide) ** 2 + (y / (0.6 * LEAN * wide)) ** 2)
    above = np.where(y > 0.0, 1.0, 0.0) * smoothstep(-0.0004, 0.0004, deep)
    outer = bump(deep - 0.0006, 0.0006) * above
    bent = np.exp(-np.maximum(deep, 0.0) / 0.0028) * above  # light that comes along the wall
    inner = bump(deep - THICK, 0.0005) * above
    slope = np.sqrt((x / wide**2) ** 2 + (y / (0.6 * LEAN * wide) ** 2) ** 2) / np.maximum(ring, 0.1)
    round_ = (ring - 0.985) / slope  # m outside the rim
    foot = bump(round_, 0.00055) * (0.3 + 0.7 * smoothstep(0.002, -0.004, y))
    foot += 0.4 * bump(round_ + 0.0012, 0.0006) * (y < 0.0)
    foot *= (y < 0.0) | (np.abs(x) > CANDLE)  # the candle stands before its far side
    h, s = y / tall, x / wide
    pane = smoothstep(0.035, -0.015, np.abs(s + 0.76) - 0.05) * (0.45 + 0.55 * h)
    pane *= smoothstep(0.3, 0.36, h) * smoothstep(0.9, 0.8, h)
    pane *= 1.0 - 0.75 * bump(h - 0.6, 0.018)  # the bars of the window
    streak = bump(s - 0.8, 0.022) * smoothstep(0.06, 0.3, h) * smoothstep(0.92, 0.7, h)
    crown = bump(y - tall + 0.0062 + 0.02 * s * s, 0.0016) * smoothstep(0.55, 0.1, np.abs(s + 0.25))
    own = 0.34 * outer + 0.2 * bent + 0.14 * inner + 0.3 * foot + 0.24 * pane + 0.14 * streak + 0.3 * crown
    image = bump(np.abs(s) - 0.86, 0.02) * bump(y - SHINES, 0.02)
    near = 0.3 + 0.7 * bump(y - SHINES, 0.05)
    flame = (0.55 * outer + 0.3 * bent + 0.24 * inner) * near + 0.4 * foot + 0.5 * image + 0.2 * crown
    gray = np.stack([own, flame], axis=2)[..., None] * (235.0, 235.0, 235.0)
    return in_two_lights(gray[:, :, 0], gray[:, :, 1], np.clip(0.16 * bent + 0.12 * outer, 0.0, 1.0))
