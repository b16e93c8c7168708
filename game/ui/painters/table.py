"""The billiard table at rest: everything that does not move, drawn once for each size and kept.

Shadow, frame, cloth, cushions, pockets, sights, head line and spots. The long side lies where the view puts
it: to the right in ``TableView``, which also says how large the table may be.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from typing import NamedTuple

import numpy as np
import pygame

from game.billiards.table.table import CUSHION_DEPTH, Table
from game.ui.look import theme as colors
from game.ui.look.theme import Theme
from game.ui.painters.table_shapes import CushionShape, cushion_shapes
from game.ui.painters.table_surface import (
    DRAWN_AT,
    paint_cloth,
    paint_floor,
    paint_glow,
    paint_pocket,
    paint_wood,
)
from game.ui.raster import (
    BUTT,
    clip_of,
    fill_disc,
    fill_polygon,
    fill_shadow,
    packed,
    pixels_of,
    scratch_for,
    stroke_polyline,
    stroke_segment,
)

Array = np.ndarray
WOOD = 0.074  # m; breadth of the frame
SURROUND = CUSHION_DEPTH + WOOD  # m; from the nose to the table's outer edge
SIGHT_LONG, SIGHT_SHORT = 0.0171, 0.0104  # m; half diagonals of a sight
SPOT_RADIUS = 0.0051  # m
SHADOW_DOWN, SHADOW_BLUR = 0.020, 0.050  # m
GLOW = 6.0  # of 255; the ground is so much lighter round a dark table that stands among others
FLOOR = pygame.Color(58, 42, 31)  # boards under the lamp
SIDE_LINER = 0.0067  # m; the liner of a side pocket reaches so far into the cushions' line


KEPT_PICTURES = 6  # the scene's, and those of its thumbnails


class TableView(NamedTuple):
    """Where a table lies in the window: left and top px of its bed, px per metre.

    The bed's length runs to the right and its width downwards: seen from above, not mirrored.
    """

    left: float
    top: float
    scale: float

    def to_screen(self, x: float, y: float) -> tuple[float, float]:
        """Place px of a point (x, y) m in the table's frame."""
        return self.left + y * self.scale, self.top + x * self.scale

    def points(self, places: Array) -> Array:
        """Places (n, 2) px of points (n, 2) m."""
        return np.ascontiguousarray(places[:, ::-1] * self.scale + (self.left, self.top))

    def middle(self, table: Table) -> tuple[float, float]:
        """Place px of the middle of the bed."""
        return self.to_screen(0.5 * table.width, 0.5 * table.length)


def fit_table(area: pygame.Rect, table: Table) -> TableView:
    """The largest view of a table with its frame inside ``area``, its bed a multiple of 8 px if it is large.

    Never smaller than a bed of 16 px.
    """
    scale = min(area.w / (table.length + 2.0 * SURROUND), area.h / (table.width + 2.0 * SURROUND))
    length = max(16.0, math.floor(scale * table.length / 16.0 + 1e-9) * 16.0)
    if length < 160.0:
        length = max(16.0, scale * table.length)
    scale = length / table.length
    left = math.floor(area.x + 0.5 * (area.w - length))
    top = math.floor(area.y + 0.5 * (area.h - table.width * scale))
    return TableView(float(left), float(top), scale)


class Dress(NamedTuple):
    """What a table wears: the cloth's colour; of its cushions 0xRRGGBB on the slope towards the lamp, the
    other slopes. Then the top of the short rails and of the long ones, under the nose. spots: places as
    shares of width and length; line: share of the length at which a line is drawn across, None for none.
    sights: the frame has diamonds.
    """

    felt: pygame.Color
    slope_lit: int
    slope: int
    top_short: int
    top: int
    nose: int
    spots: tuple[tuple[float, float], ...]
    line: float | None
    sights: bool = True


POOL = Dress(colors.FELT, 0x1E6A63, 0x1A5A54, 0x24726A, 0x28756D, 0x0E3C37, ((0.5, 0.25), (0.5, 0.75)), 0.25)


def carom_dress(felt: pygame.Color, spots: tuple[tuple[float, float], ...]) -> Dress:
    """A carom table's: the spots of the game, no line; cushions in shades of its cloth."""
    white, black = pygame.Color("#FFFFFF"), pygame.Color("#000000")

    def shade(towards: pygame.Color, share: float) -> int:
        return packed(colors.mix(felt, towards, share))

    return Dress(
        felt, shade(black, 0.06), shade(black, 0.18), shade(white, 0.04), shade(white, 0.06),
        shade(black, 0.48), spots, None,
    )  # fmt: skip


class TablePainter:
    """Keeps the last few pictures of tables; ``draw`` makes one when table, view, size or theme are new."""

    def __init__(self) -> None:
        self._pictures: OrderedDict[tuple[object, ...], pygame.Surface] = OrderedDict()

    def draw(
        self, surface: pygame.Surface, table: Table, view: TableView, theme: Theme, dress: Dress = POOL,
        room: bool = True,
    ) -> None:  # fmt: skip
        """Cover a surface with a room's floor, or a plain ground, and on it the table and its shadow."""
        measures = (table.width, table.length, *(array.tobytes() for array in table[3:]))
        felt = (dress.felt.r, dress.felt.g, dress.felt.b)
        key = (surface.get_size(), measures, view, theme.name, felt, dress[1:], room)
        picture = self._pictures.get(key)
        if picture is None:
            picture = self._pictures[key] = table_picture(surface.get_size(), table, view, theme, dress, room)
            while len(self._pictures) > KEPT_PICTURES:
                self._pictures.popitem(last=False)
        self._pictures.move_to_end(key)
        surface.blit(picture, (0, 0))


def table_picture(
    size: tuple[int, int], table: Table, view: TableView, theme: Theme, dress: Dress = POOL, room: bool = True
) -> pygame.Surface:
    """A picture of ``size`` px with a table and its shadow on the floor of a ``room``, or on plain ground.

    By the light theme the ground is always plain: words stand on it.
    """
    picture = pygame.Surface((max(1, size[0]), max(1, size[1])), 0, 32)
    picture.fill(theme.bg)
    pixels, clip = pixels_of(picture), clip_of(picture)
    _draw_ground(pixels, clip, table, view, theme, dress.felt, room)
    _draw_marks(pixels, clip, table, view, dress)
    shapes = cushion_shapes(table, CUSHION_DEPTH)
    for shape in shapes:
        _draw_cushion(pixels, clip, view, shape, dress)
    _draw_pockets(pixels, clip, table, view, theme)
    if dress.sights:
        _draw_sights(pixels, clip, table, view)
    return picture


def _line(view: TableView) -> float:
    """Width px of a thin line."""
    return max(1.0, view.scale / DRAWN_AT)


def _channels(color: pygame.Color) -> Array:
    return np.array([color.r, color.g, color.b], np.float64)


def _draw_ground(
    pixels: Array, clip: Array, table: Table, view: TableView, theme: Theme, felt: pygame.Color,
    room: bool,
) -> None:  # fmt: skip
    """Floor, shadow, frame, cloth."""
    s = view.scale
    x, y = view.middle(table)
    half_x, half_y = 0.5 * table.length * s, 0.5 * table.width * s
    reach_x, reach_y = half_x + SURROUND * s, half_y + SURROUND * s
    dark = theme.name == "dark"
    if dark and room:
        box = np.array((x, y, reach_x, reach_y))
        paint_floor(pixels, box, s, _channels(FLOOR), _channels(theme.bg))
    elif dark:
        paint_glow(pixels, x, y, packed(theme.bg), GLOW)
    _draw_shadow(
        pixels, clip, (x - reach_x, y - reach_y, x + reach_x, y + reach_y), s, 0.51 if dark else 0.21
    )
    bed = np.array((x, y, half_x, half_y))
    inks = np.stack([_channels(c) for c in (colors.WOOD_DARK, colors.WOOD_LIGHT)])
    paint_cloth(pixels, bed, s, CUSHION_DEPTH * s, _channels(felt))
    paint_wood(pixels, bed, s, CUSHION_DEPTH * s, WOOD * s, inks, 0.79 if dark else 1.12)


def _draw_shadow(
    pixels: Array, clip: Array, box: tuple[float, float, float, float], scale: float, opacity: float
) -> None:
    """The table's shadow on the floor, drawn only where the table does not hide it."""
    left, top, right, bottom = box
    down = SHADOW_DOWN * scale
    inside = 0.5 * WOOD * scale  # the frame's round corners show a little of the floor
    a, b = int(max(0.0, left + inside)), int(max(0.0, right - inside))
    c, d = int(max(0.0, top + inside)), int(max(0.0, bottom - inside))
    for part in ((0, 0, clip[2], c), (0, d, clip[2], clip[3]), (0, c, a, d), (b, c, clip[2], d)):
        area = np.array(part, np.int64)
        fill_shadow(
            pixels,
            area,
            left,
            top + down,
            right,
            bottom + down,
            0.05 * scale,
            SHADOW_BLUR * scale,
            0,
            opacity,
        )


def _draw_marks(pixels: Array, clip: Array, table: Table, view: TableView, dress: Dress) -> None:
    """The line across, such as pool's head line, and the spots."""
    if dress.line is not None:
        at = dress.line * table.length
        (x0, y0), (x1, y1) = view.to_screen(0.0, at), view.to_screen(table.width, at)
        stroke_segment(pixels, clip, x0, y0, x1, y1, _line(view), BUTT, packed(colors.FELT_LINE), 0.15)
    for across, along in dress.spots:
        place = view.to_screen(across * table.width, along * table.length)
        fill_disc(pixels, clip, *place, SPOT_RADIUS * view.scale, 0, 0.42)


def _draw_cushion(pixels: Array, clip: Array, view: TableView, shape: CushionShape, dress: Dress) -> None:
    """Top, slope, their edge, the dark line under the nose and the joint to the wood."""
    cover, area, extent = scratch_for(pixels)
    line = _line(view)
    outline, top = view.points(shape.outline), view.points(shape.top)
    upright = abs(shape.normal[1]) > 0.5  # a short rail, which stands upright on the screen
    faces_lamp = shape.normal[0] < -0.5  # the lower rail's slope looks at the nearer lamp
    stroke_polyline(pixels, clip, cover, view.points(shape.nose), 2.0 * line, False, dress.nose, 0.9)
    fill_polygon(pixels, clip, area, extent, outline, dress.slope_lit if faces_lamp else dress.slope, 1.0)
    fill_polygon(pixels, clip, area, extent, top, dress.top_short if upright else dress.top, 1.0)
    (x0, y0), (x1, y1) = view.points(shape.ridge)
    stroke_segment(pixels, clip, x0, y0, x1, y1, line, BUTT, 0xF4EDE0, 0.09)
    nx, ny = shape.normal[1], shape.normal[0]  # into the table, on the screen
    (x0, y0), (x1, y1) = view.points(shape.back) + 0.5 * line * np.array((nx, ny))
    stroke_segment(pixels, clip, x0, y0, x1, y1, line, BUTT, 0, 0.40)


def _draw_pockets(pixels: Array, clip: Array, table: Table, view: TableView, theme: Theme) -> None:
    """Holes, their liners and brass."""
    s = view.scale
    left, top = view.to_screen(-CUSHION_DEPTH, -CUSHION_DEPTH)
    right, bottom = view.to_screen(table.width + CUSHION_DEPTH, table.length + CUSHION_DEPTH)
    brass = packed(
        colors.mix(pygame.Color(0, 0, 0), colors.POCKET_RING, 0.80 if theme.name == "dark" else 1.0)
    )
    unit = _line(view) if s > 150.0 else 1.6 * s / DRAWN_AT
    for x, y, radius in table.pockets:
        px, py = view.to_screen(float(x), float(y))
        at_side = radius < y < table.length - radius
        lip = SIDE_LINER * s if at_side else 0.0
        wood = np.array((left, top + lip, right, bottom - lip))
        paint_pocket(pixels, clip, px, py, float(radius) * s, unit, wood, brass)


def _draw_sights(pixels: Array, clip: Array, table: Table, view: TableView) -> None:
    """Inlaid diamonds at the eighths of the long rails and the quarters of the short ones."""
    off = CUSHION_DEPTH + 0.5 * WOOD
    middle = 0.5 * table.length
    for i in range(1, 8):
        y = table.length * i / 8.0
        if not any(abs(y - p[1]) < 2.0 * p[2] for p in table.pockets if abs(p[1] - middle) < p[2]):
            for x in (-off, table.width + off):
                _draw_sight(pixels, clip, view, x, y, False)
    for i in range(1, 4):
        for y in (-off, table.length + off):
            _draw_sight(pixels, clip, view, table.width * i / 4.0, y, True)


def _draw_sight(pixels: Array, clip: Array, view: TableView, x: float, y: float, upright: bool) -> None:
    """One diamond in three tones, as mother of pearl."""
    _, area, extent = scratch_for(pixels)
    px, py = view.to_screen(x, y)
    a, b = SIGHT_LONG * view.scale, SIGHT_SHORT * view.scale
    if upright:
        a, b = b, a
    line = _line(view)
    diamond = np.array(((-a, 0.0), (0.0, -b), (a, 0.0), (0.0, b)))
    place = np.array((px, py))
    seat = place + diamond * (1.0 + line / min(a, b))
    low_left = place + np.array(((-a, 0.0), (0.0, 0.0), (0.0, b)))
    low_right = place + np.array(((a, 0.0), (0.0, b), (0.0, 0.0)))
    fill_polygon(pixels, clip, area, extent, seat, 0, 0.22)
    fill_polygon(pixels, clip, area, extent, place + diamond, 0xF3EFE6, 1.0)
    fill_polygon(pixels, clip, area, extent, low_left, packed(colors.INLAY), 1.0)
    fill_polygon(pixels, clip, area, extent, low_right, 0xC8CFCC, 1.0)


def _warm_up() -> None:
    """Compile the kernels of the table."""
    table = Table.pool()
    table_picture((64, 40), table, fit_table(pygame.Rect(0, 0, 64, 40), table), colors.DARK)


WARM_UPS = [("table_picture", _warm_up)]
