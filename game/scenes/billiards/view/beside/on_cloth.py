"""What practice puts on the cloth: where the cue ball may end, the landing cloud, a drill that is being
made.
"""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.arrays import Floats
from game.billiards.map.leaving import heat
from game.billiards.map.pool import Pot
from game.scenes.billiards.beside import MAP
from game.scenes.billiards.play import Play
from game.scenes.billiards.practice.advisor import Drawn, PoolAdvisor
from game.scenes.billiards.practice.drill_maker import DrillMaker
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.practice.landing import Landing, LandingMeter
from game.scenes.shared.tables import grip
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_WARM
from game.ui.painters.cloth_label import draw_cloth_label

COLUMNS, ROWS = 24, 48  # cells across the table and along it
MOST_ALPHA = 190.0
SPOT = 0.006  # m, radius of an end in the cloud


class OnCloth:
    """Keeps its picture while nothing of it changes."""

    def __init__(self, play: Play, advisor: PoolAdvisor, maker: DrillMaker) -> None:
        self.play = play
        self.advisor = advisor
        self.maker = maker
        self._landings = LandingMeter()
        self._cells_of: tuple[Drawn, Pot | None] | None = None
        self._cells = np.zeros((ROWS, COLUMNS))

    def draw(self, canvas: Canvas) -> None:
        """Everything that there is now, below the balls."""
        if self.play.parameters.beside == MAP:
            drawn = self.advisor.drawn()
            if drawn is not None:
                self._draw_heat(canvas, drawn)
        if self.maker.active:
            draw_making(canvas, self.maker)

    def cells(self, drawn: Drawn) -> Floats:
        """Share (ROWS, COLUMNS) of the potting strokes whose cue ball ends in each cell: of all, or those of
        the row that was clicked.
        """
        chosen = self.advisor.chosen
        before = self._cells_of
        if before is None or before[0] is not drawn or before[1] is not chosen:
            self._cells_of = (drawn, chosen)
            self._cells = heat_of(drawn, chosen)
        return self._cells

    def _draw_heat(self, canvas: Canvas, drawn: Drawn) -> None:
        cells = self.cells(drawn)
        if not cells.any():
            return
        table = drawn.board.table
        left, top = canvas.camera.to_screen(0.0, 0.0)
        right, foot = canvas.camera.to_screen(table.width, table.length)
        size = (max(round(right - left), 1), max(round(foot - top), 1))
        canvas.surface.blit(heat_picture(cells, size), (round(left), round(top)))

    def draw_cloud(self, canvas: Canvas) -> Landing | None:
        """The ends of the aimed stroke for a hand, above the lines and below the balls; what is known of
        them.
        """
        play, frame = self.play, self.play.model.frame
        if not (play.parameters.cloud and play.may_aim) or play.grip == grip.CUE_BALL:
            return None
        landing = self._landings.of(frame, play.aiming.stroke, hand_of(play).noise)
        if landing is None:
            return None
        if len(landing.ends):
            canvas.discs(landing.ends, SPOT, FELT_WARM, alpha=0.55)
            x, y = landing.middle.tolist()
            table = frame.table
            with canvas.within((0.0, 0.0), (table.width, table.length)):
                canvas.circle((x, y), landing.half_within, outline=FELT_WARM, width=1.5, dash=(5.0, 4.0))
        return landing

    def draw_cloud_words(self, canvas: Canvas, landing: Landing | None) -> None:
        """How far the ends are spread, beside them."""
        if landing is None:
            return
        table = self.play.model.frame.table
        x, y = landing.middle.tolist() if len(landing.ends) else (0.5 * table.width, 0.5 * table.length)
        below = 0.0 if math.isnan(landing.half_within) else landing.half_within
        x = min(x + below + canvas.px(14.0), table.width - canvas.px(22.0))
        y = min(max(y, canvas.px(90.0)), table.length - canvas.px(90.0))
        draw_cloth_label(canvas.surface, canvas.fonts, cloud_words(landing), canvas.camera.to_screen(x, y))


def heat_of(drawn: Drawn, chosen: Pot | None) -> Floats:
    """Share of potting strokes by cells: of all, or of one pot, the whole of its group."""
    board, drawn_map = drawn.board, drawn.map
    rows = np.flatnonzero(drawn_map.keys) if chosen is None else chosen.rows
    ends = drawn_map.outcomes.places[rows, board.cue]
    return heat(ends, COLUMNS, ROWS, board.table.width, board.table.length)


def heat_picture(cells: Floats, size: tuple[int, int]) -> pygame.Surface:
    """The cells as a warm light, the whole length of the table across. size px."""
    small = pygame.Surface(cells.shape, pygame.SRCALPHA, 32)
    small.fill((FELT_WARM.r, FELT_WARM.g, FELT_WARM.b, 255))
    strength = np.sqrt(cells / cells.max())
    pygame.surfarray.pixels_alpha(small)[:] = np.round(MOST_ALPHA * strength).astype(np.uint8)
    return pygame.transform.smoothscale(small, size)


def cloud_words(landing: Landing) -> str:
    """How far the ends are spread, and how often the cue ball goes down."""
    parts = [f"half within {100.0 * landing.half_within:.0f} cm"] if len(landing.ends) else []
    if landing.scratches:
        parts.append(f"down {100.0 * landing.scratches / landing.tried:.0f} %")
    return ", ".join(parts)


def draw_making(canvas: Canvas, maker: DrillMaker) -> None:
    """The ball, the pocket and the zone that are chosen."""
    frame = maker.play.model.frame
    for number, x, y in frame.layout.places:
        if number == maker.ball:
            radius = 1.5 * float(frame.layout.balls.radii[number])
            canvas.circle((x, y), radius, outline=FELT_WARM, width=2.5)
    if maker.pocket is not None and maker.pocket < len(frame.table.pockets):
        x, y, radius = frame.table.pockets[maker.pocket].tolist()
        canvas.circle((x, y), radius + canvas.px(3.0), outline=FELT_WARM, width=2.5)
    if maker.zone is not None:
        x, y, radius = maker.zone
        with canvas.within((0.0, 0.0), (frame.table.width, frame.table.length)):
            canvas.circle((x, y), radius, fill=FELT_WARM, fill_alpha=0.12, outline=FELT_WARM, width=2.0,
                          dash=(5.0, 4.0))  # fmt: skip
