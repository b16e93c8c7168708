"""A room at dusk, painted once: a wall with a window and books, out of focus, and a table before it.

Its own light comes through the window; a flame on the table, SHINES m above it at x = 0, is the other one.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from game.arrays import Singles
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.shades import (
    Light,
    Plane,
    bump,
    grid_of,
    in_two_lights,
    lay,
    lay_lit,
    lit,
    smoothstep,
    soft,
)

WALL_BOX = ((-1.2, 0.03), (1.2, 0.99))  # m
TABLE_BOX = ((-1.2, -0.33), (1.2, 0.052))
LEAN = 0.14  # height of a circle on the table over its width, as it is seen from a little above
FRONT = -0.052  # m: the front edge of the table in the picture
SHINES = 0.085  # m: of the flame above the table
PLASTER, FRAME, SHELF, WOOD = (124, 112, 104), (96, 84, 74), (104, 72, 48), (150, 104, 68)
SKY = ((0.0, (232, 150, 104)), (0.28, (176, 142, 158)), (0.62, (92, 112, 168)), (1.0, (46, 66, 122)))
WINDOW, SILL = (-0.5, -0.135, 0.125, 0.62), 0.011  # m: left, right, bottom, top; of its frame
MOON = (-0.235, 0.345, 0.02)  # m: middle and radius
BOOKS = ((0.135, 0.56, 0.05), (0.13, 0.72, 0.3))  # m: rows of them: left, right, foot
BINDINGS = np.array(
    [(128, 44, 38), (44, 78, 84), (150, 112, 52), (62, 58, 92), (96, 98, 66), (140, 88, 66), (176, 158, 126)]
)


def draw_dusk_room(canvas: Canvas, own: Light, flame: Light) -> None:
    """Wall and table, behind what stands there and below it."""
    lay_lit(canvas, wall_picture(), WALL_BOX, own, flame)
    lay_lit(canvas, table_picture(), TABLE_BOX, own, flame)


@lru_cache(maxsize=1)
def wall_picture() -> Singles:
    """Plaster, the window with its sky, two rows of books; all as a lens sees it that looks at the table."""
    x, y = grid_of(WALL_BOX, (240, 600))
    random = np.random.default_rng(5)
    mottled = soft(random.standard_normal(x.shape), (9.0, 9.0)) * 16.0
    color = np.array(PLASTER) * (1.0 + 0.05 * mottled)[..., None]
    beside = np.maximum(x - WINDOW[1], 0.0)
    own = 0.16 + 0.5 / (1.0 + (beside / 0.16) ** 2) * bump(y - 0.25, 0.4)
    away = np.sqrt(x * x + (y - SHINES) ** 2)
    flame = 0.5 / (1.0 + (away / 0.22) ** 2) + 0.05
    _window(color, own, flame, x, y)
    for foot in BOOKS:
        _books(color, own, flame, x, y, foot, random)
    seen = soft(np.stack([own, flame], axis=2)[..., None] * color[:, :, None], (1.4, 1.4))
    return in_two_lights(seen[:, :, 0], seen[:, :, 1], np.ones(x.shape))


def _window(color: Plane, own: Plane, flame: Plane, x: Plane, y: Plane) -> None:
    """Frame, bars, sill; dusk behind them, with hills and a moon."""
    left, right, low, high = WINDOW
    opening = (x > left) & (x < right) & (y > low) & (y < high)
    up = (y - low) / (high - low)
    places = [stop for stop, _ in SKY]
    sky = np.stack([np.interp(up, places, [ink[c] for _, ink in SKY]) for c in range(3)], axis=-1)
    hills = low + 0.055 + 0.02 * np.sin(17.0 * x + 1.0) + 0.012 * np.sin(41.0 * x)
    sky = np.where((y < hills)[..., None], np.array((44.0, 46.0, 66.0)), sky)
    moon = np.sqrt((x - MOON[0]) ** 2 + (y - MOON[1]) ** 2)
    sky = sky + (230.0 * smoothstep(1.15, 0.9, moon / MOON[2]) + 46.0 * np.exp(-moon / 0.05))[..., None]
    bars = (np.abs(x - 0.5 * (left + right)) < 0.008) | (np.abs(y - low - 0.29) < 0.008)
    frame = (x > left - SILL) & (x < right + SILL) & (y > low - SILL) & (y < high + SILL) & (~opening | bars)
    sill = (np.abs(x - 0.5 * (left + right)) < 0.5 * (right - left) + 0.03) & (
        np.abs(y - low + 0.014) < 0.008
    )
    lay(color, opening, sky)
    own[opening], flame[opening] = 1.0, 0.02
    lay(color, frame | sill, FRAME)
    own[frame], own[sill] = 0.3, 0.75


def _books(
    color: Plane, own: Plane, flame: Plane, x: Plane, y: Plane, row: tuple[float, float, float],
    random: np.random.Generator,
) -> None:  # fmt: skip
    """A shelf, and books of many bindings on it, some of them with gilt lines; what lies behind is dark."""
    left, right, foot = row
    board = (x > left - 0.012) & (x < right + 0.02) & (np.abs(y - foot + 0.004) < 0.005)
    lay(color, board, SHELF)
    at = left
    while at < right:
        wide, tall = float(random.uniform(0.014, 0.034)), float(random.uniform(0.085, 0.145))
        leaning = float(random.uniform(-0.02, 0.16)) if random.uniform() < 0.1 else 0.0
        across = (x - at + leaning * (y - foot)) / wide
        spine = (across > 0.0) & (across < 0.94) & (y > foot) & (y < foot + tall)
        ink = BINDINGS[int(random.integers(len(BINDINGS)))]
        bands = (np.abs((y - foot) / tall - 0.8) < 0.03) | (np.abs((y - foot) / tall - 0.16) < 0.025)
        tone = np.sqrt(np.maximum(np.sin(np.pi * np.clip(across, 0.0, 1.0)), 0.0)) * float(
            random.uniform(0.8, 1.1)
        )
        lay(color, spine, np.where(bands[..., None], (206, 166, 92), ink) * (0.35 + 0.65 * tone)[..., None])
        flame[spine] *= 1.6
        own[spine] *= 0.9
        at += wide + (0.02 if leaning else 0.0)
        if random.uniform() < 0.05:
            at += 0.05


@lru_cache(maxsize=1)
def table_picture() -> Singles:
    """Boards of oiled wood, seen from a little above, and their edge to the viewer."""
    x, y = grid_of(TABLE_BOX, (640, 800))
    random = np.random.default_rng(8)
    fine = soft(random.standard_normal(x.shape), (0.9, 16.0)) * 6.5
    broad = soft(random.standard_normal(x.shape), (5.0, 45.0)) * 24.0
    deep = y / LEAN  # m on the table, away from the viewer
    board = np.floor(deep / 0.145 + 0.43 + 0.02 * broad)
    tint = random.uniform(-1.0, 1.0, 64)[np.mod(board, 64).astype(int)]
    rings = np.sin(2.0 * np.pi * (9.0 * deep + 1.1 * broad + 2.2 * tint + 0.25 * fine))
    tone = 0.8 + 0.1 * tint + 0.09 * rings + 0.07 * fine + 0.05 * broad
    seam = np.abs(deep / 0.145 + 0.43 - np.round(deep / 0.145 + 0.43)) * 0.145 * LEAN
    tone *= 1.0 - 0.55 * bump(seam, 0.0006)
    color = np.array(WOOD) * tone[..., None]
    color[..., 2] *= 1.0 - 0.12 * rings
    # both lights on the top: the flame's falls off, and what carries it keeps it from its foot
    away = np.sqrt(x * x + deep * deep)
    flame = 1.3 / (1.0 + (away / 0.1) ** 2) ** 1.25 * (0.42 + 0.58 * smoothstep(0.018, 0.042, away)) + 0.05
    flame += 0.5 * bump(x, 0.012) * np.exp(y / 0.03) * (y < 0.0)  # its image in the polish
    own = 0.4 + 0.55 * bump(x + 0.31, 0.17) * smoothstep(-0.05, 0.05, y)
    shadow = bump(x - 0.028 - 0.2 * deep, 0.034) * bump(y, 0.006) * (x > -0.011)
    own *= (1.0 - 0.35 * shadow) * (0.75 + 0.25 * smoothstep(0.052, 0.03, y))
    below = y < FRONT  # the edge: a rounded lip, then its face
    lip = smoothstep(FRONT - 0.009, FRONT, y)
    face = 1.0 / (1.0 + (x / 0.3) ** 2)
    own = np.where(below, 0.14 + 0.5 * lip * lip, own)
    flame = np.where(below, (0.06 + 0.5 * lip**3) * face, flame)
    gap = bump(y - FRONT + 0.034, 0.0016)  # between the board and the frame under it
    under = np.where(below, (1.0 - 0.8 * gap) * np.where(y < FRONT - 0.034, 0.55, 1.0), 1.0)
    return lit(color * under[..., None], own, flame, smoothstep(0.052, 0.0495, y))
