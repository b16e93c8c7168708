"""The deciding pot seen from near: the picture comes closer to the pocket while the ball falls."""

from __future__ import annotations

import pygame

from game.billiards.table.table import Table
from game.scenes.billiards import layout
from game.scenes.billiards.play import ROLLING, Play
from game.scenes.shared.tables.view import Balls, draw_balls
from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas

CLOSEST = 2.0  # times as near as the whole table
COMES, STAYS, LEAVES = (-0.9, -0.35), 0.25, 0.7  # s of the shot about the pot
SEEN = 1.01  # times nearer; what is less is the whole table


def nearness(since: float) -> float:
    """How many times nearer the picture is, so many s of the shot after the pot."""
    begins, there = COMES
    share = min((since - begins) / (there - begins), (LEAVES - since) / (LEAVES - STAYS))
    share = min(max(share, 0.0), 1.0)
    return 1.0 + (CLOSEST - 1.0) * share * share * (3.0 - 2.0 * share)


def seen_from_near(near: float, pocket: tuple[float, float]) -> layout.Box:
    """The part of the table that is seen so many times nearer: towards a pocket (x, y) m, never beyond it."""
    whole = layout.TABLE
    high, wide = (whole.bottom - whole.top) / near, (whole.right - whole.left) / near
    top = min(max(pocket[0] - 0.5 * high, whole.top), whole.bottom - high)
    left = min(max(pocket[1] - 0.5 * wide, whole.left), whole.right - wide)
    return layout.Box(top, left, top + high, left + wide)


class CloseUpView:
    """Draws the table once more, from near, over itself."""

    def __init__(self) -> None:
        self._canvas: Canvas | None = None

    def part(self, play: Play, time: float, less_motion: bool) -> layout.Box | None:
        """The part of the table that is seen at a time of the phase, s; None where that is all of it."""
        decided = play.model.decided if play.phase == ROLLING and not less_motion else None
        near = nearness(time - decided.time) if decided is not None else 1.0
        return seen_from_near(near, decided.pocket) if decided is not None and near > SEEN else None

    def draw(self, canvas: Canvas, table: Table, balls: Balls, part: layout.Box, felt: pygame.Color) -> None:
        """Bring a part of the table, drawn without balls, to the size of the whole. felt: of its cloth."""
        place = layout.rect_of(canvas, layout.TABLE).clip(canvas.rect)
        source = layout.rect_of(canvas, part).clip(place)
        if place.w < 1 or place.h < 1 or source.w < 1 or source.h < 1:
            return
        cloth = canvas.surface.subsurface(source).copy()
        pygame.transform.smoothscale(cloth, place.size, canvas.surface.subsurface(place))
        if self._canvas is None or self._canvas.look is not canvas.look:
            self._canvas = Canvas(canvas.look)
            self._canvas.covered = True
        camera = Camera(y_up=canvas.camera.y_up, quarter_turns=1)
        camera.fit(Frame(part.top, part.left, part.bottom, part.right), place, 0.0)
        self._canvas.begin(canvas.surface, place, camera)
        try:
            draw_balls(self._canvas, balls, table, felt=felt)
        finally:
            self._canvas.end()
