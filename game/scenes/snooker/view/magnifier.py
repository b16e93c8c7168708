"""The contact that is aimed at, seen from near: where balls are too small to see how they will meet."""

from __future__ import annotations

import math

import pygame

from game.billiards.table.snooker import BALL_RADIUS
from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.scenes.shared.tables.boxes import Box, rect_of
from game.scenes.shared.tables.sight import Sight, draw_sight
from game.scenes.shared.tables.view import Balls, draw_balls
from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_LINE

SMALL = 8.0  # px; radius of a ball below which the magnifier shows by itself
NEARER = 3.0  # times
SIDE = 0.62  # m of the table that it covers
EDGE = 0.07  # m from the cushions


def magnifies(chosen: str, canvas: Canvas) -> bool:
    """True if the magnifier is to be shown. chosen: auto, on or off."""
    return chosen == "on" or (chosen == "auto" and BALL_RADIUS * canvas.pixels_per_unit < SMALL)


def box_beside(
    cue_ball: tuple[float, float], ghost: tuple[float, float], places: list[tuple[float, float]]
) -> Box:
    """Where the magnifier lies: in the corner of the bed nearest to the cue ball that hides neither it nor
    the contact, and few balls.
    """
    best, worth = None, -math.inf
    for top in (EDGE, SNOOKER_WIDTH - SIDE - EDGE):
        for left in (EDGE, 0.5 * (SNOOKER_LENGTH - SIDE), SNOOKER_LENGTH - SIDE - EDGE):
            box = Box(top, left, top + SIDE, left + SIDE)
            hides = sum(_near(box, place) for place in places)
            mark = (
                -4.0 * (_near(box, cue_ball) + _near(box, ghost))
                - hides
                - 0.2 * math.dist(box.middle, cue_ball)
            )
            if mark > worth:
                best, worth = box, mark
    assert best is not None
    return best


def _near(box: Box, place: tuple[float, float]) -> bool:
    grown = Box(box.top - 0.06, box.left - 0.06, box.bottom + 0.06, box.right + 0.06)
    return grown.holds(*place)


class Magnifier:
    """Draws a part of the table once more, from near."""

    def __init__(self) -> None:
        self._canvas: Canvas | None = None

    def draw(
        self, canvas: Canvas, box: Box, balls: Balls, sight: Sight, foul: bool, felt: pygame.Color
    ) -> None:
        """The surroundings of the contact of a sight, at the place of a box."""
        assert sight.ghost is not None
        place = rect_of(canvas, box).clip(canvas.rect)
        x, y = sight.ghost
        half = 0.5 * SIDE / NEARER
        if place.w < 8 or place.h < 8:
            return
        if self._canvas is None or self._canvas.look is not canvas.look:
            self._canvas = Canvas(canvas.look)
            self._canvas.covered = True
        camera = Camera(y_up=canvas.camera.y_up, quarter_turns=1)
        camera.fit(Frame(x - half, y - half, x + half, y + half), place, 0.0)
        canvas.surface.fill(felt, place)
        self._canvas.begin(canvas.surface, place, camera)
        try:
            self._canvas.halo = felt
            draw_sight(self._canvas, sight, BALL_RADIUS, BALL_RADIUS, foul)
            table = _Bed(SNOOKER_WIDTH, SNOOKER_LENGTH)
            draw_balls(self._canvas, balls, table, felt=felt)  # type: ignore[arg-type]
        finally:
            self._canvas.end()
        pygame.draw.rect(canvas.surface, FELT_LINE, place, max(1, round(1.5 * canvas.k)))


class _Bed:
    """The sides of the bed, which the lamps hang over."""

    def __init__(self, width: float, length: float) -> None:
        self.width = width
        self.length = length
