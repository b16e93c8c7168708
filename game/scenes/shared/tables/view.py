"""How a billiard table, its balls and the cue are drawn on a canvas, with the straight lines of the aim."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.table.aim import FirstContact, first_contact
from game.billiards.table.table import Table
from game.scenes.shared.tables.cue import PULLING, STRIKING, CueControl
from game.scenes.shared.tables.through.push import Push
from game.stage import Frame, WarmUp
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters import ball as ball_painter
from game.ui.painters import cue as cue_painter
from game.ui.painters import table as table_painter
from game.ui.painters.ball import BallPainter, ScreenBalls
from game.ui.painters.cue import draw_cue
from game.ui.painters.perspective import ground as ground_painter
from game.ui.painters.perspective import spheres as sphere_painter
from game.ui.painters.table import POOL, Dress, TablePainter, TableView

CUE_LENGTH = 1.47  # m
WOOD = 0.074  # m, breadth of the frame outside the cushions
SURROUND = 0.175  # m of floor and frame shown around the bed
EYE = 0.8  # m above the cloth, from which a ball in the air looks larger
SHADOW_SHIFT = (0.75, 0.5)  # m of the shadow along x (down) and y (right) for each m of height
SHADOW_FADE = 0.15  # m of height at which a shadow is twice as wide, and half as dark
SHADOW = pygame.Color(0, 0, 0)
QUARTER_TURN = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # table frame to screen frame

_table_painter = TablePainter()


@lru_cache(maxsize=4)
def _ball_painter(red: int, green: int, blue: int) -> BallPainter:
    """The painter of balls on a cloth of that colour."""
    return BallPainter(pygame.Color(red, green, blue))


class Balls(NamedTuple):
    """What is drawn of balls: positions (n, 2) m, radii (n,) m, numbers, turns (n, 3, 3), opacities (n,).

    heights (n,) m above where they would lie; None: all lie.
    """

    positions: Floats
    radii: Floats
    numbers: NDArray[np.int64]
    turns: Floats
    opacities: Floats
    heights: Floats | None = None

    def some(self, chosen: NDArray[np.bool_]) -> Balls:
        """Some of the balls, by (n,) bools, as if they lay."""
        return Balls(
            self.positions[chosen], self.radii[chosen], self.numbers[chosen], self.turns[chosen],
            self.opacities[chosen],
        )  # fmt: skip


def warm_ups() -> list[WarmUp]:
    """Kernels that draw tables, balls and cues."""
    return [
        WarmUp(name, call)
        for painter in (ball_painter, table_painter, cue_painter, ground_painter, sphere_painter)
        for name, call in painter.WARM_UPS
    ]


def frame_of(table: Table) -> Frame:
    """The bed with its frame and some floor."""
    return Frame(-SURROUND, -SURROUND, table.width + SURROUND, table.length + SURROUND)


def draw_table(
    canvas: Canvas,
    table: Table,
    origin: tuple[float, float] = (0.0, 0.0),
    alone: bool = True,
    dress: Dress = POOL,
) -> None:
    """Cloth, cushions, wood and pockets, from a picture that is kept while nothing about it changes.

    ``origin``: where the table's corner lies in the world. ``alone``: it may cover the whole canvas, with
    the floor of its room.
    """
    region = canvas.rect
    left, top = canvas.camera.to_screen(*origin)
    if not alone:
        corners = [(origin[0] - SURROUND, origin[1] - SURROUND)]
        corners += [(origin[0] + table.width + SURROUND, origin[1] + table.length + SURROUND)]
        (x0, y0), (x1, y1) = (canvas.camera.to_screen(*corner) for corner in corners)
        region = pygame.Rect(round(x0), round(y0), round(x1 - x0), round(y1 - y0)).clip(canvas.rect)
    if region.w > 0 and region.h > 0:
        view = TableView(left - region.x, top - region.y, canvas.camera.scale)
        _table_painter.draw(canvas.surface.subsurface(region), table, view, canvas.theme, dress, alone)


def draw_balls(
    canvas: Canvas,
    balls: Balls,
    table: Table,
    origin: tuple[float, float] = (0.0, 0.0),
    felt: pygame.Color = FELT,
) -> None:
    """Shaded balls with their shadows, numbers and stripes turned as they have rolled.

    Those in the air come last: larger, as they are nearer to the eye, with their shadow apart on the cloth.
    """
    if balls.heights is not None and balls.heights.any():
        flies = balls.heights > 0.0
        draw_balls(canvas, balls.some(~flies), table, origin, felt)
        _draw_flying(canvas, balls, flies, table, origin, felt)
        return
    _paint_balls(canvas, balls, table, origin, felt)


def _draw_flying(
    canvas: Canvas,
    balls: Balls,
    flies: NDArray[np.bool_],
    table: Table,
    origin: tuple[float, float],
    felt: pygame.Color,
) -> None:
    """The balls in the air over their shadows."""
    assert balls.heights is not None
    heights = balls.heights[flies]
    flying = balls.some(flies)
    for place, radius, height, opacity in zip(
        flying.positions, flying.radii.tolist(), heights.tolist(), flying.opacities.tolist(), strict=True
    ):
        below = np.array((SHADOW_SHIFT[0] * height, SHADOW_SHIFT[1] * height)) + place + origin
        spread = 1.0 + height / SHADOW_FADE
        alpha = 0.45 * opacity / spread
        for share in (1.0, 0.8, 0.6):  # a soft edge
            canvas.circle(below, spread * radius * share, fill=SHADOW, fill_alpha=0.5 * alpha)
    larger = flying._replace(radii=flying.radii * EYE / np.maximum(EYE - heights, 0.25 * EYE))
    _paint_balls(canvas, larger, table, origin, felt, shadows=False)


def _paint_balls(
    canvas: Canvas,
    balls: Balls,
    table: Table,
    origin: tuple[float, float],
    felt: pygame.Color,
    shadows: bool = True,
) -> None:
    """Balls where they are, each with the shadow of one that lies."""
    pixels, clip = canvas.raster_target
    points = np.array([canvas.place(point) for point in balls.positions + origin]).reshape(-1, 2)
    turns = QUARTER_TURN @ balls.turns
    middle = canvas.place((origin[0] + 0.5 * table.width, origin[1] + 0.5 * table.length))
    scale = canvas.pixels_per_unit
    drawn = ScreenBalls(
        points, balls.radii * scale, balls.numbers, np.ascontiguousarray(turns), balls.opacities
    )
    _ball_painter(felt.r, felt.g, felt.b).draw(pixels, clip, drawn, middle, scale, shadows)


def draw_aim(canvas: Canvas, first: FirstContact, start: Floats, radius: float, cue: CueControl) -> None:
    """The path to the first contact, the ghost ball there, and the cut angle."""
    canvas.line(start, first.ghost, FELT_LINE, 1.5)
    if first.kind in ("nothing", "pocket"):
        return
    canvas.circle(first.ghost, radius, fill=FELT_LINE, fill_alpha=0.22, outline=FELT_LINE, width=1.5)
    if first.kind == "cushion":
        x, y = math.cos(cue.aim), math.sin(cue.aim)
        nx, ny = first.normal
        into = x * nx + y * ny
        out = (x - 2.0 * into * nx, y - 2.0 * into * ny)
        _draw_dashed(canvas, first.ghost, out, 0.35, FELT_LINE)


def draw_split(canvas: Canvas, table: Table, first: FirstContact, balls: Balls, cue: CueControl) -> None:
    """Where the two balls of the first contact go: the object ball along the normal, the other across it."""
    n = np.array(first.normal)
    aim = np.array((math.cos(cue.aim), math.sin(cue.aim)))
    target = balls.positions[first.target]
    canvas.circle(target, float(balls.radii[first.target]) * 1.25, outline=FELT_COOL, width=1.5)
    in_play = balls.opacities > 0.99
    onward = first_contact(first.target, math.atan2(n[1], n[0]), balls.positions, balls.radii, in_play, table)
    reach = min(onward.distance, 2.0) * max(math.cos(first.cut), 0.05)
    if onward.kind == "pocket":
        reach = onward.distance
    _draw_dashed(canvas, target, n, reach, FELT_COOL)
    across = aim - (aim @ n) * n
    length = math.sqrt(float(across @ across))
    if length > 1e-3:
        _draw_dashed(canvas, first.ghost, across / length, 0.5 * length, FELT_LINE)
    side = 1.0 if aim[0] * n[1] - aim[1] * n[0] > 0.0 else -1.0
    place = np.array(first.ghost) + side * np.array((n[1], -n[0])) * 0.13
    canvas.label(place, cut_words(first.cut), FELT_LINE)


def cut_words(cut: float) -> str:
    """The angle of a cut, rad, in degrees; to a tenth where whole ones would say that the ball is missed."""
    degrees = math.degrees(cut)
    return f"cut {degrees:.0f}°" if degrees < 89.5 else f"cut {degrees:.1f}°"


def _draw_dashed(
    canvas: Canvas,
    start: Floats | tuple[float, float],
    direction: Floats | tuple[float, float],
    length: float,
    color: pygame.Color,
) -> None:
    if not math.isfinite(length):
        return
    end = (start[0] + direction[0] * length, start[1] + direction[1] * length)
    canvas.line(start, end, color, 1.75, dash=(8.0, 6.0))


def draw_cue_behind(
    canvas: Canvas,
    table: Table,
    ball: Floats,
    radius: float,
    cue: CueControl,
    words_y: float,
    push: Push | None = None,
) -> None:
    """The cue behind a ball; while it is pulled, the speed that it would give, ``words_y`` px below.

    push: of strokes that may be pushed; None at a table that has none.
    """
    pushed = push is not None and push.chosen and cue.phase != STRIKING
    gap, aim = (push.gap, cue.aim + push.swayed) if push is not None and pushed else (cue.gap, cue.aim)
    along = (math.cos(aim), math.sin(aim))
    back = radius + gap
    draw_stick(canvas, table, (ball[0] - back * along[0], ball[1] - back * along[1]), along)
    if push is not None and push.held:
        canvas.label(ball, push.words, FELT_WARM, 13, "semibold", offset=(0.0, words_y))
    elif cue.phase == PULLING:
        canvas.label(ball, f"{cue.speed:.1f} m/s", FELT_WARM, 13, "semibold", offset=(0.0, words_y))


def draw_stick(canvas: Canvas, table: Table, tip: tuple[float, float], along: tuple[float, float]) -> None:
    """A cue with its tip at a point of the table, pointing along a unit vector."""
    pixels, clip = canvas.raster_target
    x, y = canvas.place(tip)
    far_x, far_y = canvas.place((tip[0] - along[0], tip[1] - along[1]))
    scale = canvas.pixels_per_unit
    middle = canvas.place((0.5 * table.width, 0.5 * table.length))
    draw_cue(pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, 0.0, middle)
