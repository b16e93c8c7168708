"""The yard by itself: sky, trees, a low wall, flagstones, a wooden frame with hooks, a table with matches."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Inks
from game.scenes.burning_cloth import tables
from game.scenes.burning_cloth.tables import BOX, BOX_HIGH
from game.ui.raster.pixels import OPAQUE

Floats = NDArray[Any]  # of single precision, for pictures
CELL = 1.0 / 300.0  # m of the yard to a cell of its picture
LEFT, BOTTOM, RIGHT, TOP_EDGE = -2.5, -0.6, 2.5, 2.6  # m that are painted
GROUND, WALL_TOP = 0.11, 0.66  # m: where the wall stands on the ground, and how high it is
POSTS, POST_HALF, BEAM = (-1.0, 0.9), 0.038, (1.76, 1.85)  # m
# night, day: sky above, at the horizon, trees, stone, mortar, flags, wood; light of the sky (256: all)
NIGHT = (0x070D1C, 0x242440, 0x10161C, 0x6E675F, 0x3B3733, 0x5C554C, 0x6A4A30, 120)
DAY = (0x8DB7D6, 0xF3E3C4, 0x6F8A66, 0xB9AD9A, 0x8E8474, 0xB3A48C, 0x8E6440, 246)


class YardPicture(NamedTuple):
    """colors (h, w) 0xFFRRGGBB in the light of the sky; takes (h, w) 0 to 255: how much firelight shows
    there; own: what the sky's light was, 256 being full.
    """

    colors: Inks
    takes: NDArray[np.uint8]
    own: float


def _parts(ink: int) -> Floats:
    return np.array([ink >> 16 & 255, ink >> 8 & 255, ink & 255], dtype=np.float32)


def _smooth(random: np.random.Generator, shape: tuple[int, int], coarse: int) -> Floats:
    """Soft patches, about -1 to 1."""
    small = random.standard_normal((shape[0] // coarse + 3, shape[1] // coarse + 3), dtype=np.float32)
    rows, columns = (np.arange(n, dtype=np.float32) / coarse for n in shape)
    i, j = rows.astype(int), columns.astype(int)
    f, g = rows - i, columns - j
    f, g = (f * f * (3 - 2 * f))[:, None], (g * g * (3 - 2 * g))[None, :]
    upper = small[i][:, j] * (1.0 - g) + small[i][:, j + 1] * g
    lower = small[i + 1][:, j] * (1.0 - g) + small[i + 1][:, j + 1] * g
    return np.asarray(upper * (1.0 - f) + lower * f)


def _lay(colors: Floats, takes: Floats, where: NDArray[np.bool_], over: Floats, light: float) -> None:
    """Other colours where a shape is, and how much firelight shows on it."""
    colors[where] = np.broadcast_to(over, colors.shape)[where]
    takes[where] = light


@lru_cache(maxsize=2)
def yard_picture(dark: bool) -> YardPicture:
    """All of it, as the theme has it."""
    inks = NIGHT if dark else DAY
    x = (np.arange(LEFT, RIGHT, CELL)[None, :] + 0.5 * CELL).astype(np.float32)
    y = (np.arange(TOP_EDGE, BOTTOM, -CELL)[:, None] - 0.5 * CELL).astype(np.float32)
    random = np.random.default_rng(10)
    shape = (y.shape[0], x.shape[1])
    x, y = np.broadcast_to(x, shape), np.broadcast_to(y, shape)
    grain = random.standard_normal(shape, dtype=np.float32)
    large, middling, small = (_smooth(random, shape, n) / m for n, m in ((150, 1.6), (60, 2.6), (23, 6.0)))
    cloud = large + middling + small
    fine = _smooth(random, shape, 9)
    colors, takes = _sky(x, y, inks, cloud, random, dark)
    _trees(colors, takes, x, y, inks, random)
    _wall(colors, takes, x, y, inks, (cloud, fine, grain), random)
    _flags(colors, takes, x, y, inks, (cloud, fine, grain), random)
    _frame(colors, takes, x, y, inks, fine)
    _table(colors, takes, x, y, inks, fine)
    colors *= np.where(takes > 0.0, inks[7] / 256.0, 1.0)[..., None]
    packed = np.clip(colors + 0.5, 0.0, 255.0).astype(np.uint32)
    found = packed[..., 0] << 16 | packed[..., 1] << 8 | packed[..., 2] | np.uint32(OPAQUE)
    return YardPicture(
        np.ascontiguousarray(found, dtype=np.uint32),
        np.clip(255.0 * takes, 0, 255).astype(np.uint8),
        float(inks[7]),
    )


def _sky(
    x: Floats, y: Floats, inks: tuple[int, ...], cloud: Floats, random: np.random.Generator, dark: bool
) -> tuple[Floats, Floats]:  # fmt: skip
    """From the horizon up, with clouds, by night with stars and a moon."""
    above, horizon = _parts(inks[0]), _parts(inks[1])
    rise = np.clip((y - WALL_TOP) / (TOP_EDGE - WALL_TOP), 0.0, 1.0) ** 0.7
    colors = horizon + (above - horizon) * (rise + 0.0 * x)[..., None]
    band = np.exp(-(((y - 1.25) / 0.55) ** 2)) * np.clip(cloud - 0.1, 0.0, 1.0)
    tint = np.array((70.0, 62.0, 84.0) if dark else (255.0, 250.0, 240.0), dtype=np.float32)
    colors = colors + (tint - colors) * (0.3 if dark else 0.6) * band[..., None]
    if dark:
        for k in range(170):
            row, column = (
                int(random.integers(colors.shape[0] * 6 // 10)),
                int(random.integers(colors.shape[1])),
            )
            bright = float(random.uniform(30.0, 150.0))
            colors[row : row + 1 + (k % 5 == 0), column : column + 1 + (k % 5 == 0)] += bright
        moon = np.sqrt((x - 1.42) ** 2 + (y - 1.55) ** 2)
        colors += (np.clip((0.075 - moon) / 0.004, 0.0, 1.0) * 190.0 + 46.0 * np.exp(-moon / 0.16))[
            ..., None
        ] * (np.array((1.0, 0.97, 0.86), dtype=np.float32))
    return colors.astype(np.float32), np.zeros(colors.shape[:2], np.float32)


def _trees(
    colors: Floats, takes: Floats, x: Floats, y: Floats, inks: tuple[int, ...], random: np.random.Generator
) -> None:  # fmt: skip
    """Two rows of treetops, the farther one paler."""
    horizon, tree = _parts(inks[1]), _parts(inks[2])
    for high, wide, share, light in ((1.0, 0.9, 0.45, 0.02), (0.86, 0.5, 0.0, 0.1)):
        places = np.arange(LEFT - 0.5, RIGHT + 0.5, 0.34 * wide)
        outline = np.full(x.shape, -1.0, np.float32)
        for place in places:
            radius = wide * float(random.uniform(0.22, 0.42))
            top = high * float(random.uniform(0.86, 1.06))
            away = np.clip(1.0 - ((x - place - float(random.uniform(-0.1, 0.1))) / radius) ** 2, 0.0, None)
            outline = np.maximum(outline, top - radius * 0.8 + 0.8 * radius * np.sqrt(away))
        ragged = outline + 0.02 * _smooth(random, x.shape, 7) + 0.03 * _smooth(random, x.shape, 22)
        shade = np.clip((ragged - y) / 0.25, 0.0, 1.0)
        ink = (tree + (horizon - tree) * share) * (1.12 - 0.3 * shade)[..., None]
        _lay(colors, takes, (y < ragged) & (y > 0.0), ink, light)


def _wall(
    colors: Floats, takes: Floats, x: Floats, y: Floats, inks: tuple[int, ...],
    noise: tuple[Floats, Floats, Floats], random: np.random.Generator,
) -> None:  # fmt: skip
    """Courses of stones with a coping."""
    stone, mortar = _parts(inks[3]), _parts(inks[4])
    cloud, fine, grain = noise
    high = 0.118
    course = np.floor(y / high)
    shift = np.array([random.uniform(0.0, 1.0) for _ in range(64)], dtype=np.float32)[
        np.mod(course, 64).astype(int)
    ]
    along = (x + 0.02 * np.sin(3.0 * y)) / 0.235 + 2.0 * shift
    number = np.floor(along)
    tints = random.uniform(-1.0, 1.0, (61, 53)).astype(np.float32)
    tint = tints[np.mod(course, 61).astype(int), np.mod(number, 53).astype(int)]
    edge_x = np.minimum(along - number, 1.0 - along + number) * 0.235
    edge_y = np.minimum(np.mod(y, high), high - np.mod(y, high))
    edge = np.minimum(edge_x, edge_y + 0.0 * x) + 0.0025 * fine
    lit = np.clip(edge / 0.012, 0.0, 1.0)
    tone = stone * (0.72 + 0.13 * tint + 0.06 * cloud + 0.05 * fine + 0.02 * grain + 0.18 * lit)[..., None]
    tone = np.where((edge < 0.005)[..., None], mortar * (0.9 + 0.05 * fine)[..., None], tone)
    low = np.clip((y - GROUND) / 0.2, 0.0, 1.0)
    where = (y <= WALL_TOP) & (y > GROUND) & (x < 99.0)
    _lay(colors, takes, where, tone * (0.72 + 0.28 * low)[..., None], 0.62)
    cap = (y > WALL_TOP - 0.005) & (y <= WALL_TOP + 0.05 + 0.0 * x)
    seam = np.abs(np.mod(x / 0.47, 1.0) - 0.5) > 0.494
    tone = stone * (0.98 + 0.07 * fine + 0.05 * cloud - 0.4 * seam - 0.3 * (y < WALL_TOP + 0.008))[..., None]
    _lay(colors, takes, cap, tone, 0.6)


def _flags(
    colors: Floats, takes: Floats, x: Floats, y: Floats, inks: tuple[int, ...],
    noise: tuple[Floats, Floats, Floats], random: np.random.Generator,
) -> None:  # fmt: skip
    """Flagstones that come towards the viewer."""
    flag, mortar = _parts(inks[5]), _parts(inks[4])
    cloud, fine, grain = noise
    near = np.clip((GROUND - y) / (GROUND - BOTTOM), 0.0, 1.0)  # 0 at the wall, 1 in front
    depth = 0.9 / (0.16 + near)  # the farther, the larger
    row = np.floor(depth * 3.1)
    shift = random.uniform(0.0, 1.0, 64).astype(np.float32)[np.mod(row, 64).astype(int)]
    along = (x - 0.1) * depth / 1.5 + 0.5 * shift
    number = np.floor(along)
    tints = random.uniform(-1.0, 1.0, (61, 53)).astype(np.float32)
    tint = tints[np.mod(row, 61).astype(int), np.mod(number, 53).astype(int)]
    edge_x = np.minimum(along - number, 1.0 - along + number) * 1.5 / depth
    part = np.mod(depth * 3.1, 1.0)
    edge = np.minimum(edge_x, np.minimum(part, 1.0 - part) * (0.05 + 0.1 * near)) + 0.002 * fine
    tone = flag * (0.78 + 0.1 * tint + 0.06 * cloud + 0.04 * fine + 0.02 * grain + 0.22 * near)[..., None]
    tone = np.where((edge < 0.004 + 0.004 * near)[..., None], mortar * (0.8 + 0.2 * near)[..., None], tone)
    shade = 1.0 - 0.45 * np.exp(-(GROUND - y) / 0.035)
    _lay(colors, takes, (y <= GROUND) & (x < 99.0), tone * shade[..., None], 0.78)


def _frame(
    colors: Floats, takes: Floats, x: Floats, y: Floats, inks: tuple[int, ...], fine: Floats
) -> None:  # fmt: skip
    """Two posts, a beam across them with its braces, and two iron hooks."""
    wood = _parts(inks[6])
    for post in POSTS:
        across = (x - post) / POST_HALF
        foot = np.exp(-(((x - post) / 0.11) ** 2)) * np.exp(-(((y - 0.005) / 0.022) ** 2))
        colors *= (1.0 - 0.5 * foot)[..., None]
        where = (np.abs(across) < 1.0) & (y > 0.0) & (y < BEAM[1])
        tone = wood * (0.86 - 0.22 * across + 0.08 * np.sin(60.0 * x + 2.5 * fine) * 0.8)[..., None]
        _lay(colors, takes, where, tone * (0.75 + 0.25 * np.clip(y / 0.4, 0.0, 1.0))[..., None], 0.9)
    for post, side in ((POSTS[0], 1.0), (POSTS[1], -1.0)):
        along = ((x - post) * side + (BEAM[0] - y)) / np.float32(2.0) ** 0.5
        beside = ((x - post) * side - (BEAM[0] - y - 0.26)) / np.float32(2.0) ** 0.5
        where = (np.abs(beside) < 0.02) & ((x - post) * side > 0.0) & (y < BEAM[0]) & (along < 0.6)
        where &= (x - post) * side < 0.2
        _lay(colors, takes, where, wood * (0.72 + 0.12 * fine)[..., None], 0.85)
    inside = (y > BEAM[0]) & (y < BEAM[1]) & (x > POSTS[0] - 0.16) & (x < POSTS[1] + 0.16)
    up = (y - BEAM[0]) / (BEAM[1] - BEAM[0])
    tone = wood * (0.66 + 0.42 * up + 0.07 * np.sin(150.0 * y + 4.0 * fine) + 0.04 * fine)[..., None]
    _lay(colors, takes, inside, tone, 0.95)
    iron = np.array((52.0, 50.0, 50.0), dtype=np.float32)
    for side in (-1.0, 1.0):
        at = 0.5 * side * tables.SPAN
        shank = (np.abs(x - at) < 0.0045) & (y > tables.TOP + 0.035) & (y < BEAM[0] + 0.012)
        ring = np.abs(np.sqrt((x - at) ** 2 + (y - tables.TOP - 0.012) ** 2) - 0.022) < 0.0045
        ring &= ~((x - at > 0.004) & (y > tables.TOP + 0.012))
        plate = (np.abs(x - at) < 0.02) & (np.abs(y - BEAM[0] - 0.03) < 0.02)
        _lay(colors, takes, shank | ring | plate, iron + 0.0 * colors, 0.9)


def _table(
    colors: Floats, takes: Floats, x: Floats, y: Floats, inks: tuple[int, ...], fine: Floats
) -> None:  # fmt: skip
    """A small table; its top is seen a little from above. On it the box of matches."""
    wood = _parts(inks[6]) * np.float32(1.12)
    shadow = np.exp(-(((x - 1.25) / 0.34) ** 4)) * np.exp(-(((y + 0.02) / 0.05) ** 2))
    colors *= (1.0 - 0.45 * shadow)[..., None]
    for at, back in (
        (tables.TABLE_FROM + 0.07, True),
        (tables.TABLE_TO - 0.07, True),
        (tables.TABLE_FROM + 0.04, False),
        (tables.TABLE_TO - 0.04, False),
    ):
        foot = 0.05 if back else -0.03
        across = (x - at) / 0.02
        where = (np.abs(across) < 1.0) & (y > foot) & (y < tables.TABLE - 0.03)
        _lay(
            colors,
            takes,
            where,
            wood * ((0.5 if back else 0.8) - 0.18 * across + 0.05 * fine)[..., None],
            0.7,
        )
    rail = (
        (x > tables.TABLE_FROM + 0.02)
        & (x < tables.TABLE_TO - 0.02)
        & (y > tables.TABLE - 0.1)
        & (y < tables.TABLE - 0.03)
    )
    _lay(colors, takes, rail, wood * (0.66 + 0.06 * fine + 0.0 * y)[..., None], 0.8)
    top = (y > tables.TABLE - 0.03) & (y < tables.TABLE + 0.035)
    lean = 0.035 * np.clip((y - tables.TABLE + 0.005) / 0.04, 0.0, 1.0)
    top &= (x > tables.TABLE_FROM + lean) & (x < tables.TABLE_TO - lean)
    plank = np.abs(np.mod((y - tables.TABLE) / 0.02, 1.0) - 0.5) > 0.46
    tone = wood * (0.98 + 0.07 * np.sin(30.0 * x + 3.0 * fine) + 0.05 * fine - 0.25 * plank)[..., None]
    front = y < tables.TABLE - 0.006
    tone = np.where(front[..., None], wood * (0.78 + 0.06 * fine)[..., None], tone)
    _lay(colors, takes, top, tone, 1.0)
    box = (x > BOX[0]) & (x < BOX[1]) & (y > tables.TABLE) & (y < tables.TABLE + BOX_HIGH)
    blue, rough, card = (
        np.array(c, dtype=np.float32) for c in ((150, 44, 34), (62, 44, 40), (226, 196, 134))
    )
    shade = np.exp(-(((x - 0.5 * (BOX[0] + BOX[1])) / 0.1) ** 4)) * np.exp(
        -(((y - tables.TABLE + 0.002) / 0.012) ** 2)
    )
    colors *= (1.0 - 0.35 * shade * (y < tables.TABLE + 0.002))[..., None]
    _lay(colors, takes, box, rough * (1.0 + 0.12 * fine)[..., None], 0.9)
    lid = box & (y > tables.TABLE + BOX_HIGH - 0.014)
    _lay(colors, takes, lid, card + 0.0 * colors, 0.95)
    label = lid & (x > BOX[0] + 0.018) & (x < BOX[1] - 0.018) & (y < tables.TABLE + BOX_HIGH - 0.002)
    _lay(colors, takes, label, blue + 0.0 * colors, 0.95)
