"""How a billiard table, its balls and the cue are drawn on a canvas, with the straight lines of the aim."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.billiards.table.aim import FirstContact, first_contact
from game.billiards.table.table import CUSHION_DEPTH, Table
from game.scenes.lecture_table.marks import MARK_S, PASSED_S
from game.scenes.shared.tables.cue import PULLING, STRIKING, CueControl
from game.stage import Frame, WarmUp
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters import ball as ball_painter
from game.ui.painters import cue as cue_painter
from game.ui.painters import table as table_painter
from game.ui.painters.ball import BallPainter
from game.ui.painters.cue import draw_cue
from game.ui.painters.table import TablePainter, TableView

if TYPE_CHECKING:
    from game.scenes.lecture_table.scene import LectureTable

Array = NDArray[np.float64]

CUE_LENGTH = 1.47  # m
WOOD = 0.074  # m, breadth of the frame outside the cushions
SURROUND = 0.175  # m of floor and frame shown around the bed
TELEPORT = 0.25  # m; a ball that moved farther in one step was put there, and is not drawn in between
QUARTER_TURN = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # table frame to screen frame

_ball_painter = BallPainter(FELT)
_table_painter = TablePainter()


class Balls(NamedTuple):
    """What is drawn of balls: positions (n, 2) m, radii (n,) m, numbers, turns (n, 3, 3), opacities (n,)."""

    positions: Array
    radii: Array
    numbers: NDArray[np.int64]
    turns: Array
    opacities: Array


def warm_ups() -> list[WarmUp]:
    """Kernels that draw tables, balls and cues."""
    return [
        WarmUp(name, call)
        for painter in (ball_painter, table_painter, cue_painter)
        for name, call in painter.WARM_UPS
    ]


def frame_of(table: Table) -> Frame:
    """The bed with its frame and some floor."""
    return Frame(-SURROUND, -SURROUND, table.width + SURROUND, table.length + SURROUND)


def matrices_of(quaternions: Array) -> Array:
    """Rotation matrices (n, 3, 3) of unit quaternions (n, 4), scalar first."""
    w, x, y, z = quaternions.T
    return np.stack(
        (
            np.stack((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)), axis=-1),
            np.stack((2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)), axis=-1),
            np.stack((2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)), axis=-1),
        ),
        axis=-2,
    )


def draw_table(
    canvas: Canvas, table: Table, origin: tuple[float, float] = (0.0, 0.0), alone: bool = True
) -> None:
    """Cloth, cushions, wood and pockets, from a picture that is kept while nothing about it changes.

    ``origin``: where the table's corner lies in the world. ``alone``: it may cover the whole canvas.
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
        _table_painter.draw(canvas.surface.subsurface(region), table, view, canvas.theme)


def draw_balls(canvas: Canvas, balls: Balls, table: Table, origin: tuple[float, float] = (0.0, 0.0)) -> None:
    """Shaded balls with their shadows, numbers and stripes turned as they have rolled."""
    pixels, clip = canvas.raster_target
    points = np.array([canvas.place(point) for point in balls.positions + origin]).reshape(-1, 2)
    turns = QUARTER_TURN @ balls.turns
    middle = canvas.place((origin[0] + 0.5 * table.width, origin[1] + 0.5 * table.length))
    scale = canvas.pixels_per_unit
    _ball_painter.draw(
        pixels,
        clip,
        points,
        balls.radii * scale,
        balls.numbers,
        np.ascontiguousarray(turns),
        middle,
        scale,
        balls.opacities,
    )


def draw_aim(canvas: Canvas, first: FirstContact, start: Array, radius: float, cue: CueControl) -> None:
    """The way to the first contact, the ghost ball there, and the cut angle."""
    canvas.line(start, first.ghost, FELT_LINE, 1.5)
    if first.kind in ("nothing", "pocket"):
        return
    canvas.circle(first.ghost, radius, fill=FELT_LINE, fill_alpha=0.22, outline=FELT_LINE, width=1.5)
    way = (math.cos(cue.aim), math.sin(cue.aim))
    if first.kind == "cushion":
        nx, ny = first.normal
        along = way[0] * nx + way[1] * ny
        out = (way[0] - 2.0 * along * nx, way[1] - 2.0 * along * ny)
        _dashed_way(canvas, first.ghost, out, 0.35, FELT_LINE)


def draw_split(canvas: Canvas, table: Table, first: FirstContact, balls: Balls, cue: CueControl) -> None:
    """Where the two balls of the first contact go: the object ball along the normal, the other across it."""
    n = np.array(first.normal)
    way = np.array((math.cos(cue.aim), math.sin(cue.aim)))
    target = balls.positions[first.target]
    canvas.circle(target, float(balls.radii[first.target]) * 1.25, outline=FELT_COOL, width=1.5)
    in_play = balls.opacities > 0.99
    onward = first_contact(first.target, math.atan2(n[1], n[0]), balls.positions, balls.radii, in_play, table)
    reach = min(onward.distance, 2.0) * max(math.cos(first.cut), 0.05)
    if onward.kind == "pocket":
        reach = onward.distance
    _dashed_way(canvas, target, n, reach, FELT_COOL)
    across = way - (way @ n) * n
    length = math.sqrt(float(across @ across))
    if length > 1e-3:
        _dashed_way(canvas, first.ghost, across / length, 0.5 * length, FELT_LINE)
    side = 1.0 if way[0] * n[1] - way[1] * n[0] > 0.0 else -1.0
    place = np.array(first.ghost) + side * np.array((n[1], -n[0])) * 0.13
    canvas.label(place, cut_words(first.cut), FELT_LINE)


def cut_words(cut: float) -> str:
    """The angle of a cut, rad, in degrees; to a tenth where whole ones would say that the ball is missed."""
    degrees = math.degrees(cut)
    return f"cut {degrees:.0f}°" if degrees < 89.5 else f"cut {degrees:.1f}°"


def _dashed_way(
    canvas: Canvas,
    start: Array | tuple[float, float],
    way: Array | tuple[float, float],
    length: float,
    color: pygame.Color,
) -> None:
    if not math.isfinite(length):
        return
    end = (start[0] + way[0] * length, start[1] + way[1] * length)
    canvas.line(start, end, color, 1.75, dash=(8.0, 6.0))


def draw_lecture_table(scene: LectureTable, canvas: Canvas, alpha: float) -> None:
    """The lecture's table, ``alpha`` of the way from the state before to the state now."""
    table = scene.table.table
    draw_table(canvas, table)
    canvas.halo = FELT
    balls = _balls_of(scene, alpha)
    _draw_marks(scene, canvas)
    _draw_passed(scene, canvas)
    aiming = scene.white_ready and not scene.plays_itself and scene.cue.phase != STRIKING
    if aiming and scene.aim_line:
        first = first_contact(
            0, scene.cue.aim, balls.positions, balls.radii, scene.table.state.in_play, table
        )
        draw_aim(canvas, first, balls.positions[0], float(balls.radii[0]), scene.cue)
        if first.kind == "ball":
            draw_split(canvas, table, first, balls, scene.cue)
    draw_balls(canvas, balls, table)
    if scene.white_ready and (aiming or scene.cue.phase == STRIKING):
        _draw_cue(scene, canvas, balls)
    _draw_resting_cue(scene, canvas, table)


def _balls_of(scene: LectureTable, alpha: float) -> Balls:
    """Balls between the two states; those that have just fallen fade in their pocket."""
    state, previous = scene.state(), scene.previous or scene.state()
    from_x, now = previous.offsets, state.offsets
    jump = np.abs(now - from_x).max(axis=1) > TELEPORT
    share = np.where(jump | (previous.in_play != state.in_play), 1.0, alpha)[:, None]
    positions = from_x + share * (now - from_x) + scene.table.middle
    fading = 1.0 - scene.sunk_s / 0.35
    opacities = np.where(state.in_play, 1.0, np.clip(fading, 0.0, 1.0))
    fallen = ~state.in_play & (opacities > 0.0)
    for ball in np.flatnonzero(fallen):
        hole = int(state.pocketed_by[ball])
        if hole >= 0:
            positions[ball] += (1.0 - opacities[ball]) * (table_pocket(scene, hole) - positions[ball])
    radii = scene.table.state.radii * np.where(fallen, 0.8 + 0.2 * opacities, 1.0)
    return Balls(positions, radii, scene.numbers, matrices_of(state.orientations), opacities)


def table_pocket(scene: LectureTable, hole: int) -> Array:
    """Middle of a pocket, m."""
    return scene.table.table.pockets[hole, :2]


def _draw_marks(scene: LectureTable, canvas: Canvas) -> None:
    """Contacts of the last moments as amber rings that fade."""
    mx, my = scene.table.middle.tolist()
    for x, y, age, impulse in scene.marks.tolist():
        strength = 1.0 - age / MARK_S
        if strength > 0.0:
            size = 3.0 + 9.0 * min(abs(impulse) / 0.8, 1.0) + 6.0 * (1.0 - strength)
            canvas.ring((x + mx, y + my), size, FELT_WARM, 1.5, alpha=0.8 * strength)


def _draw_passed(scene: LectureTable, canvas: Canvas) -> None:
    """Where two balls went through each other between two steps, and nobody noticed."""
    if not scene.passed:
        return
    when, first, second, *places = scene.passed
    strength = 1.0 - (scene.played_s - when) / PASSED_S
    if not 0.0 < strength <= 1.0:
        return
    middle, radii = scene.table.middle, scene.table.state.radii
    for ball, place in ((first, places[:2]), (second, places[2:])):
        ring = (place[0] + middle[0], place[1] + middle[1])
        canvas.circle(
            ring, float(radii[int(ball)]), outline=FELT_WARM, width=1.6, dash=(4.0, 3.0), alpha=strength
        )
    canvas.label(ring, "passed unseen", FELT_WARM, 13, "semibold", offset=(0.0, -26.0), alpha=strength)


def _draw_cue(scene: LectureTable, canvas: Canvas, balls: Balls) -> None:
    """The cue of who plays, behind the white ball; while pulled, the speed that it would give."""
    white, radius = balls.positions[0], float(balls.radii[0])
    back = radius + scene.cue.gap
    way = (math.cos(scene.cue.aim), math.sin(scene.cue.aim))
    draw_stick(canvas, scene.table.table, (white[0] - back * way[0], white[1] - back * way[1]), way)
    if scene.cue.phase == PULLING:
        canvas.label(white, f"{scene.cue.speed:.1f} m/s", FELT_WARM, 13, "semibold", offset=(0.0, -28.0))


def _draw_resting_cue(scene: LectureTable, canvas: Canvas, table: Table) -> None:
    """The other player's cue, laid beside the table."""
    x = table.width + CUSHION_DEPTH + WOOD + 0.035
    draw_stick(
        canvas,
        table,
        (x, 0.5 * table.length + (1 - 2 * scene.player) * 0.5 * CUE_LENGTH),
        (0.0, 1.0 - 2 * scene.player),
    )


def draw_stick(canvas: Canvas, table: Table, tip: tuple[float, float], way: tuple[float, float]) -> None:
    """A cue with its tip at a point of the table, pointing along a unit vector."""
    pixels, clip = canvas.raster_target
    x, y = canvas.place(tip)
    far_x, far_y = canvas.place((tip[0] - way[0], tip[1] - way[1]))
    scale = canvas.pixels_per_unit
    middle = canvas.place((0.5 * table.width, 0.5 * table.length))
    draw_cue(pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, 0.0, middle)
