"""What stands beside the table: the log, the map's list, the practice record, or the coach."""

from __future__ import annotations

from game.levels import Level
from game.scenes.billiards import layout
from game.scenes.billiards.beside import COACH, LOG, MAP, NONE
from game.scenes.billiards.play import Play
from game.scenes.billiards.practice.advisor import PoolAdvisor
from game.scenes.billiards.practice.columns import COLUMN
from game.scenes.billiards.practice.side import Side
from game.scenes.billiards.view.beside.log_list import draw_log
from game.scenes.billiards.view.beside.pot_list import draw_pots
from game.scenes.billiards.view.beside.record import RecordView
from game.scenes.shared.tables.beside.coach import Coach
from game.scenes.shared.tables.beside.coach_card import draw_coach
from game.scenes.shared.tables.boxes import look_of
from game.ui.canvas.canvas import Canvas


class ColumnView:
    """Draws what is chosen."""

    def __init__(
        self, play: Play, side: Side, advisor: PoolAdvisor, coach: Coach, level: Level | None
    ) -> None:
        self.play = play
        self.side = side
        self.advisor = advisor
        self.coach = coach
        self.level = level
        self.record = RecordView()

    def draw(self, canvas: Canvas) -> None:
        """The column, if there is to be one and the picture is large enough."""
        beside = self.side.beside
        if beside == NONE or canvas.pixels_per_unit < layout.LEAST_PIXELS:
            return
        look = look_of(canvas, layout.PIXELS)
        if beside == LOG:
            draw_log(canvas, look, self.side)
        elif beside == MAP:
            draw_pots(canvas, look, self.advisor, self.advisor.drawn())
        elif beside == COACH:
            draw_coach(canvas, look, COLUMN, self.coach)
        else:
            self.record.draw(canvas, look, self.play, self.level)
