"""The race as it is seen: a pane for each solver."""

from __future__ import annotations

import math

import numpy as np

from game.naming import titled
from game.scenes.solids.hand import SolidHand
from game.scenes.solids.race.model import RaceModel, RaceState
from game.scenes.solids.view import SolidView
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

GAP = 0.04  # of a pane's width
WORDS = 0.30  # of a pane's height, for words above the world
ASPECT = 16.0 / 9.0  # of the picture that the panes fill
LINE = 15.0  # design px, from one line of words to the next
NO_BREAK = "\u00a0"  # a space at which no line is broken


class RaceView:
    """Panes in rows, the first at the top left."""

    def __init__(self, model: RaceModel):
        self.model = model
        self.views = [SolidView(world, SolidHand(world)) for world in model.worlds]
        view = model.setup.content.view
        self.wide = (view.right - view.left) * (1.0 + GAP)
        self.high = (view.top - view.bottom) * (1.0 + WORDS)
        count = max(len(self.views), 1)
        self.columns = max(range(1, count + 1), key=lambda columns: self._scale(columns, count))
        self.rows = math.ceil(count / self.columns)

    def _scale(self, columns: int, count: int) -> float:
        """How large the panes come out in a picture one unit high."""
        return min(ASPECT / (columns * self.wide), 1.0 / (math.ceil(count / columns) * self.high))

    def legend(self) -> list[tuple[str, str, str]]:
        """Nothing: each pane has its solver's name."""
        return []

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
        if model.given_up[k]:
            canvas.label(corner, name, "text1", 13, "semibold", "bottomleft", (6.0, -20.0))
            canvas.label(corner, "could not go on", "vermilion", 12, "medium", "bottomleft", (6.0, -4.0))
            return
        words = canvas.figure(("race", k), self._measured(k))
        width = round(self.wide * canvas.pixels_per_unit - 8.0 * canvas.k)
        lines = canvas.fonts.wrap(words, 11, "medium", width)
        for i, line in enumerate(reversed(lines)):
            canvas.label(corner, line, "text2", 11, "medium", "bottomleft", (6.0, -4.0 - LINE * i))
        canvas.label(corner, name, "text1", 13, "semibold", "bottomleft", (6.0, -5.0 - LINE * len(lines)))

    def _measured(self, k: int) -> str:
        """What a solver's world comes to: what does not break stays together in a line."""
        result = self.model.result(k)
        time = format_si(result.step, "s") if math.isfinite(result.step) else "–"
        if self.model.worlds[k].world.joints.kinds.size:
            words = [f"gap {length_words(result.gap)}", time]
        else:
            words = [f"sinks {length_words(result.sinks)}", f"leans {length_words(result.leans)}", time]
        return ", ".join(part.replace(" ", NO_BREAK) for part in words)


def length_words(value: float) -> str:
    """A length (m) in words; what is less than a nanometre is rounding, and none."""
    return format_si(value if abs(value) >= 1e-9 else 0.0, "m")
