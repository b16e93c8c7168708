"""The race as it is seen: a pane for each solver."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.solids.hand import SolidHand
from game.scenes.solids.race.model import RaceModel, RaceState
from game.scenes.solids.race.parameters import titled
from game.scenes.solids.view import SolidView
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

GAP = 0.04  # of a pane's width
WORDS = 0.30  # of a pane's height, for words above the world
WIDEST = 4  # panes in a row


class RaceView:
    """Panes in rows, the first at the top left."""

    def __init__(self, model: RaceModel):
        self.model = model
        self.views = [SolidView(world, SolidHand(world)) for world in model.worlds]
        count = max(len(self.views), 1)
        self.columns = count if count <= 2 else min(WIDEST, math.ceil(count / 2))
        self.rows = math.ceil(count / self.columns)
        view = model.setup.content.view
        self.wide = (view.right - view.left) * (1.0 + GAP)
        self.high = (view.top - view.bottom) * (1.0 + WORDS)

    def frame(self) -> Frame:
        """All panes."""
        view = self.model.setup.content.view
        return Frame(
            view.left, view.bottom - (self.rows - 1) * self.high, view.left + self.columns * self.wide,
            view.bottom + self.high,
        )  # fmt: skip

    def draw(self, canvas: Canvas, previous: RaceState | None, alpha: float) -> None:
        """Every pane, ``alpha`` of the way from the state ``previous`` to now."""
        content, view = self.model.setup.content, self.model.setup.content.view
        for k, pane in enumerate(self.views):
            offset = (k % self.columns * self.wide, -(k // self.columns) * self.high)
            left, right = view.left + offset[0], view.right + offset[0]
            bottom, top = view.bottom + offset[1], view.top + offset[1]
            before = previous.worlds[k] if previous is not None and k < len(previous.worlds) else None
            with canvas.within((left, bottom), (right, top)):
                if content.floor is not None:
                    floor = content.floor + offset[1]
                    ground = np.array([(left, bottom), (right, bottom), (right, floor), (left, floor)])
                    canvas.polygon(ground, fill="body", fill_alpha=0.75)
                    canvas.line((left, floor), (right, floor), "line2", 1.0)
                pane.draw_bodies(canvas, before, alpha, offset)
            self._draw_words(canvas, k, (left, top))

    def _draw_words(self, canvas: Canvas, k: int, corner: tuple[float, float]) -> None:
        """Name and numbers, above the world."""
        model, name = self.model, titled(self.model.solvers[k])
        result = model.result(k)
        if model.given_up[k]:
            canvas.label(corner, name, "text1", 13, "semibold", "bottomleft", (6.0, -20.0))
            canvas.label(corner, "could not go on", "vermilion", 12, "medium", "bottomleft", (6.0, -4.0))
            return
        time = format_si(result.step, "s") if math.isfinite(result.step) else "–"
        if model.worlds[k].world.joints.kinds.size:
            words = f"gap {format_si(result.gap, 'm')} · {time}"
        else:
            words = f"sinks {format_si(result.sinks, 'm')} · leans {format_si(result.leans, 'm')} · {time}"
        canvas.label(corner, name, "text1", 13, "semibold", "bottomleft", (6.0, -20.0))
        words = canvas.figure(("race", k), words)
        canvas.label(corner, words, "text2", 11, "medium", "bottomleft", (6.0, -4.0))
