"""A table painted in perspective from the state of a game: ground, lines, balls, cue, ghost ball."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.billiards.table.table import Table
from game.scenes.shared.tables.eye.lines import Ghost, Line, draw_lines_seen
from game.scenes.shared.tables.view import Balls
from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_LINE, FELT_WARM
from game.ui.painters.perspective.eye import TO_ROOM, Eye, room_points
from game.ui.painters.perspective.ground import paint_ground
from game.ui.painters.perspective.relief import EDGE, SCALE, Relief, relief_of, sheet_size
from game.ui.painters.perspective.spheres import RoomBalls, paint_balls_seen
from game.ui.painters.perspective.stick import paint_stick
from game.ui.painters.table import SURROUND, Dress, TableView, table_picture
from game.ui.raster import clip_of, fill_disc, packed, pixels_of, stroke_ring

KEPT = 3  # reliefs
FALLEN = 0.10  # m that a ball has dropped in a pocket when it is gone


class Furniture(NamedTuple):
    """What does not move: the table, what it wears, and what else is drawn on the cloth."""

    table: Table
    dress: Dress
    draw: Callable[[Canvas], None] | None = None


class Seen(NamedTuple):
    """What an eye sees beside the table.

    lines: on the cloth; ghost: of the stroke that is aimed; cue: tip (3,) m of the room and the unit vector
    (3,) away from the ball, None for none.
    """

    balls: Balls
    lines: list[Line] = []
    ghost: Ghost | None = None
    cue: tuple[Floats, Floats] | None = None


class EyePicture:
    """Paints into a rectangle of a canvas, and keeps what does not move."""

    def __init__(self) -> None:
        self._reliefs: OrderedDict[object, Relief] = OrderedDict()
        self._ground: tuple[object, Relief, pygame.Surface] | None = None
        self._asked: object = None

    def draw(self, canvas: Canvas, rect: pygame.Rect, furniture: Furniture, eye: Eye, seen: Seen) -> None:
        """All that an eye sees, over a rectangle px of the canvas' surface."""
        place = rect.clip(canvas.surface.get_rect())
        if place.w < 2 or place.h < 2:
            return
        part = canvas.surface.subsurface(place)
        pixels, clip = pixels_of(part), clip_of(part)
        left, top = canvas.surface.get_abs_offset()
        eye = eye._replace(middle_x=eye.middle_x + left, middle_y=eye.middle_y + top)
        table, felt = furniture.table, furniture.dress.felt
        bed = (table.width, table.length)
        self._draw_ground(part, eye, self._relief(canvas, furniture))
        under, over = ([line for line in seen.lines if line.over is on] for on in (False, True))
        draw_lines_seen(pixels, clip, eye, under, bed, canvas.k)
        light = (np.array((felt.r, felt.g, felt.b)) / 255.0) ** 2
        paint_balls_seen(pixels, clip, eye, room_balls(seen.balls, table), light)
        draw_lines_seen(pixels, clip, eye, over, bed, canvas.k)
        if seen.ghost is not None:
            _draw_ghost(pixels, clip, eye, seen.ghost, bed, canvas.k)
        if seen.cue is not None:
            paint_stick(pixels, clip, eye, *seen.cue)

    def _draw_ground(self, part: pygame.Surface, eye: Eye, relief: Relief) -> None:
        """What does not move, from a picture that is kept while the eye stays where it is."""
        key = (eye, part.get_abs_offset(), part.get_size())
        if self._ground is None or self._ground[0] != key or self._ground[1] is not relief:
            paint_ground(pixels_of(part), clip_of(part), eye.numbers(), relief)
            if key == self._asked:  # asked for a second time: the eye stands still
                self._ground = key, relief, part.copy()
            self._asked = key
            return
        part.blit(self._ground[2], (0, 0))

    def _relief(self, canvas: Canvas, furniture: Furniture) -> Relief:
        """The table from above with its heights, made again only when it looks otherwise."""
        table, dress = furniture.table, furniture.dress
        felt = (dress.felt.r, dress.felt.g, dress.felt.b)
        key = (
            table[:3], *(array.tobytes() for array in table[3:]), felt, dress[1:], canvas.theme.name,
            furniture.draw,
        )  # fmt: skip
        if key not in self._reliefs:
            self._reliefs[key] = _relief_of(canvas, furniture)
            while len(self._reliefs) > KEPT:
                self._reliefs.popitem(last=False)
        self._reliefs.move_to_end(key)
        return self._reliefs[key]


def room_balls(balls: Balls, table: Table) -> RoomBalls:
    """Balls in the room's frame; one that falls into a pocket sinks as it fades."""
    heights = balls.radii.copy() if balls.heights is None else balls.radii + balls.heights
    heights = heights - FALLEN * (1.0 - balls.opacities)
    return RoomBalls(
        room_points(balls.positions, heights, table.width, table.length), np.ascontiguousarray(balls.radii),
        balls.numbers, np.ascontiguousarray(TO_ROOM @ balls.turns), balls.opacities,
    )  # fmt: skip


def _relief_of(canvas: Canvas, furniture: Furniture) -> Relief:
    """The table from above, with what is drawn on its cloth."""
    table, size = furniture.table, sheet_size(furniture.table)
    around = SURROUND + EDGE
    view = TableView(
        0.5 * size[0] - 0.5 * table.length * SCALE, 0.5 * size[1] - 0.5 * table.width * SCALE, SCALE
    )
    picture = table_picture(size, table, view, canvas.theme, furniture.dress)
    if furniture.draw is not None:
        own = Canvas(canvas.look)
        own.covered = True
        camera = Camera(quarter_turns=1)
        camera.fit(
            Frame(-around, -around, table.width + around, table.length + around), picture.get_rect(), 0.0
        )
        own.begin(picture, picture.get_rect(), camera)
        try:
            furniture.draw(own)
        finally:
            own.end()
    return relief_of(picture, table, table.cushion_height)


def _draw_ghost(
    pixels: object, clip: object, eye: Eye, ghost: Ghost, bed: tuple[float, float], k: float
) -> None:
    """The cue ball where it meets the first ball: a pale disc with a ring."""
    middle = room_points(np.array((ghost.place,)), ghost.radius, *bed)
    x, y, depth = eye.seen(middle)[0].tolist()
    if depth <= 2.0 * ghost.radius:
        return
    radius = eye.focal * ghost.radius / depth
    fill_disc(pixels, clip, x, y, radius, packed(FELT_LINE), 0.28)
    ink = FELT_WARM if ghost.foul else FELT_LINE
    stroke_ring(pixels, clip, x, y, radius, (2.0 if ghost.foul else 1.5) * k, packed(ink), 0.95)
