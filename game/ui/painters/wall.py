"""The workshop's wall behind the run: boards, in the light of lamps; it lies a little farther back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats, Inks
from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas

BACK = 0.93  # as large as a thing on the wall is seen, over one on a track
CELL = 1.0 / 16.0  # m of the wall to a cell of its picture
LEFT, BOTTOM, RIGHT, TOP = -30.0, -16.0, 60.0, 36.0  # m of the wall that is painted
BOARD, SEAM = 1.25, 0.022  # m: breadth of a board, of the groove between two
# m; of the wall, each over what is to be seen
LAMPS = (
    (4.6, 15.0), (14.2, 15.0), (24.0, 15.0), (8.0, 9.7), (11.0, 10.7), (18.6, 9.5), (24.6, 8.3), (15.4, 4.7),
)  # fmt: skip
LOW = 3  # so many of them hang at the top; those after them light less
SHADE = np.array([(-0.52, 0.0), (0.52, 0.0), (0.2, 0.34), (0.12, 0.46), (-0.12, 0.46), (-0.2, 0.34)])  # m
CORD = np.array([(0.0, 0.4), (0.0, 14.0)])  # m
BULB = np.array([(-0.34, 0.0), (0.34, 0.0), (0.26, -0.07), (-0.26, -0.07)])
SHADES = {False: (0x5E7F78, 0x3C544F, 0xFFFBEF), True: (0x2E4A47, 0x16211F, 0xFFE9B8)}  # shade, edge, light
# of the wall by day and by night: paint, in the light, in the shade below, bench and its edge
DAY = (0xCFC7B6, 0xFBF4E2, 0x9C9384, 0x8A6444, 0xB98B5E)
NIGHT = (0x24323F, 0xA5845C, 0x10171F, 0x33251C, 0x6B4E38)


@lean_kernel
def paint_wall(pixels, clip, picture, rows, columns, light, foot):
    """Lay a picture over what is clipped: cell (rows[y], columns[x]) at each pixel, above row ``foot`` of the
    picture lit by light[x] (256: as it is). Rows of pixels in one row of cells are alike.
    """
    left, top, width = clip[0], clip[1], columns.shape[0]
    for y in range(rows.shape[0]):
        row = rows[y]
        if y > 0 and rows[y - 1] == row:
            for x in range(width):
                pixels[top + y, left + x] = pixels[top + y - 1, left + x]
            continue
        for x in range(width):
            ink = picture[row, columns[x]]
            share = light[x]
            if share != 256 and row < foot:
                red = min((ink >> 16 & 255) * share >> 8, 255)
                green = min((ink >> 8 & 255) * share >> 8, 255)
                blue = min((ink & 255) * share >> 8, 255)
                ink = 0xFF000000 | red << 16 | green << 8 | blue
            pixels[top + y, left + x] = ink


class Wall:
    """Paints the background of a canvas; keeps the picture of its theme. foot: m, where the bench begins."""

    def __init__(self, foot: float) -> None:
        self._foot = min(max(foot, BOTTOM), TOP)
        self._dark: bool | None = None
        self._picture: Inks = np.zeros((1, 1), np.uint32)

    def draw(self, canvas: Canvas, dark: bool) -> None:
        """What is behind the run."""
        if dark != self._dark:
            self._dark, self._picture = dark, wall_picture(dark, self._foot)
        pixels, clip = canvas.raster_target
        width, height = int(clip[2] - clip[0]), int(clip[3] - clip[1])
        if width <= 0 or height <= 0:
            return
        (cx, cy), scale = canvas.camera.center, canvas.pixels_per_unit * BACK
        mid_x, mid_y = canvas.place((cx, cy))
        x = cx + (np.arange(width) + 0.5 + int(clip[0]) - mid_x) / scale
        y = cy - (np.arange(height) + 0.5 + int(clip[1]) - mid_y) / scale
        tall, wide = self._picture.shape
        columns = np.clip(((x - LEFT) / CELL).astype(np.int64), 0, wide - 1)
        rows = np.clip(((TOP - y) / CELL).astype(np.int64), 0, tall - 1)
        light = seam_light(x, 1.0 / scale, dark)
        paint_wall(pixels, clip, self._picture, rows, columns, light, int((TOP - self._foot) / CELL))
        self._draw_lamps(canvas, (cx, cy), dark)

    def _draw_lamps(self, canvas: Canvas, centre: tuple[float, float], dark: bool) -> None:
        """Shades on cords, and what shines below them."""
        for x, y in LAMPS:
            at = np.array([(x - centre[0]) * BACK + centre[0], (y - centre[1]) * BACK + centre[1]])
            width = max(1.4, 0.02 * canvas.pixels_per_unit)
            canvas.line(at + CORD[0], at + CORD[1], _ink(SHADES[dark][1]), width)
            canvas.polygon(at + BULB, fill=_ink(SHADES[dark][2]))
            canvas.polygon(at + SHADE, fill=_ink(SHADES[dark][0]), outline=_ink(SHADES[dark][1]), width=1.0)


def seam_light(x: NDArray[Any], pixel: float, dark: bool) -> NDArray[np.int64]:
    """How light columns of pixels (``pixel`` m wide, at x m) are where boards meet: 256 is no difference."""
    away = x - np.round(x / BOARD) * BOARD
    cover = np.clip((0.5 * (SEAM + pixel) - np.abs(away)) / pixel, 0.0, 1.0)
    edge = np.clip((0.5 * (SEAM + pixel) - np.abs(away - SEAM)) / pixel, 0.0, 1.0)
    shares = 256.0 * (1.0 - (0.55 if dark else 0.38) * cover * min(1.0, SEAM / pixel + 0.4) + 0.12 * edge)
    found: NDArray[np.int64] = shares.astype(np.int64)
    return found


def _ink(ink: int) -> pygame.Color:
    return pygame.Color(ink >> 16 & 255, ink >> 8 & 255, ink & 255)


def _parts(ink: int) -> Floats:
    return np.array([ink >> 16 & 255, ink >> 8 & 255, ink & 255], dtype=np.float64)


def wall_picture(dark: bool, foot: float) -> Inks:
    """Colours (h, w) 0xFFRRGGBB of the wall and of the bench below ``foot`` m, lit."""
    paint, lit, shade, bench, edge = (_parts(ink) for ink in (NIGHT if dark else DAY))
    x = np.arange(LEFT, RIGHT, CELL) + 0.5 * CELL
    y = (np.arange(TOP, BOTTOM, -CELL) - 0.5 * CELL)[:, None]
    random = np.random.default_rng(22)
    tints = random.uniform(-1.0, 1.0, int((RIGHT - LEFT) / BOARD) + 2)
    board = tints[((x - LEFT) / BOARD).astype(int)]
    light = np.zeros((len(y), len(x)))
    for number, (lamp_x, lamp_y) in enumerate(LAMPS):
        far = 9.0 if number < LOW else 4.5
        down = np.clip((lamp_y - y) / far, -1.0, 3.0)
        reach = 2.4 + far / 3.0 * np.clip(down, 0.0, None)
        cone = np.exp(-(((x - lamp_x) / reach) ** 2)) * np.exp(-((down / 1.15) ** 2))
        light += np.where(y > lamp_y, cone * np.exp(-(((y - lamp_y) / 0.9) ** 2)), cone)
    strength = np.clip(light * (0.72 if dark else 0.85), 0.0, 1.0)[..., None]
    dusk = np.clip((6.0 - y) / 20.0, 0.0, 0.7)[..., None] * np.ones((1, len(x), 1))
    colors = paint * (1.0 + 0.035 * board[None, :, None])
    colors = colors + (shade - colors) * dusk
    colors = colors + (lit - colors) * strength
    colors *= (
        1.0 + 0.003 * random.normal(size=(len(y), len(x), 1)) * np.linspace(0.6, 1.0, len(x))[None, :, None]
    )
    depth = np.clip((foot - y) / 5.0, 0.0, 1.0)[..., None]
    wood = edge + (bench - edge) * depth**0.35
    wood = wood * (1.0 + 0.05 * np.sin(9.0 * y[..., None] + 0.4 * np.sin(0.5 * x)[None, :, None]))
    colors = np.where(y[..., None] < foot, wood * (0.75 + 0.4 * strength), colors)
    near = np.exp(-np.clip((y - foot) / 0.7, 0.0, None))[..., None]
    colors = np.where(y[..., None] > foot, colors * (1.0 - 0.35 * near), colors)
    # a little noise, so that no bands are seen where light fades
    colors += random.uniform(-0.5, 0.5, colors.shape[:2])[..., None]
    packed = np.clip(colors + 0.5, 0.0, 255.0).astype(np.uint32)
    found = packed[..., 0] << 16 | packed[..., 1] << 8 | packed[..., 2] | np.uint32(0xFF000000)
    return np.ascontiguousarray(found, dtype=np.uint32)


def is_dark(canvas: Canvas) -> bool:
    """Whether the theme is dark: then only the lamps give light."""
    color = canvas.color("stage")
    return int(color.r) + int(color.g) + int(color.b) < 384


def warm_up_wall() -> None:
    """Compile what paints, on a tiny picture."""
    paint_wall(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((2, 2), np.uint32),
        np.zeros(4, np.int64), np.zeros(4, np.int64), np.full(4, 256, np.int64), 1,
    )  # fmt: skip
