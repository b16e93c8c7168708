"""How sweep and prune is drawn: sorted ends beside the world, the swaps of a step, and their mean."""

from __future__ import annotations

import numpy as np

from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.arrays import BoxesState
from game.scenes.boxes.model.names import named
from game.scenes.boxes.model.sweep_and_prune import SweepAndPruneModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.view.column import TALL, Column
from game.scenes.boxes.view.comparison import draw_comparison
from game.scenes.boxes.view.look import draw_names
from game.scenes.boxes.view.swap_look import Seen, draw_ends, draw_look, look_into, write_look, write_story
from game.scenes.boxes.view.world import BoxesView, draw_ground, places_between
from game.stage import Frame
from game.ui.canvas.canvas import Canvas

NEAR, FAR, TICK = 0.06, 0.30, 0.15  # m, where the axes lie beside the world


class SweepAndPruneView(BoxesView):
    """The view of C07."""

    model: SweepAndPruneModel

    def frame(self) -> Frame:
        return Frame(-4.5, -0.8 if named(self.model.boxes) else -0.42, WIDTH + 0.1, HEIGHT + 0.1)

    def legend(self) -> list[tuple[str, str, str]]:
        rows, model = super().legend(), self.model
        if model.shows_axes:
            moved = sum(int(mask.sum()) for mask in model.swapped)
            known = moved > 0 or model.swaps == 0  # a step that was gone back to has its number, no marks
            rows += [
                ("line:chalk", "lower ends", ""),
                ("line:pink", "upper ends", ""),
                ("line:amber", "changed places", grouped(moved) if known else "–"),
            ]
        return rows

    def draw(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        model, boxes, looked = self.model, self.model.boxes, self.hand.looked
        draw_ground(canvas)
        self.draw_boxes(canvas, before, alpha)
        places = places_between(model, before, alpha)
        draw_names(boxes, canvas, places)
        seen = look_into(boxes, looked) if looked >= 0 else None
        if seen is not None:
            draw_look(boxes, canvas, places, seen)
        if model.shows_axes:
            for axis in range(2):
                self._draw_axis(canvas, axis)
        with canvas.at_home() as moved:
            self._draw_column(canvas, seen, moved)

    def _draw_column(self, canvas: Canvas, seen: Seen | None, moved: bool) -> None:
        """Times, swaps, and what is said of single boxes."""
        model, few = self.model, named(self.model.boxes)
        column = Column(canvas, model.boxes, self.frame().bottom, 4.6, -0.95 if few else -0.75, moved)
        if not few or column.room_px > TALL:
            draw_comparison(model, column, "sweep", "Sweep and prune")
            column.space(6)
        mean = model.mean_swaps()
        column.head("Swaps in this step", "both axes")
        top = max(model.swaps, mean, 1.0)
        column.bar("Made", grouped(model.swaps), model.swaps / top, "amber")
        column.bar("Mean for this speed", grouped(mean), mean / top, "text1", hollow=True)
        if not few:
            column.row("Sorted again so far", grouped(model.sap.resorts))
            column.row("Pairs begun, ended", f"{grouped(model.begun)}, {grouped(model.ended)}")
        column.space(6)
        if seen is not None:
            write_look(model.boxes, column, seen)
            column.space(6)
        if few:
            write_story(column, model.story, model.fresh)

    def _draw_axis(self, canvas: Canvas, axis: int) -> None:
        """End points as ticks: lower ones towards the world, upper ones beyond; longer where they swapped."""
        values, who, upper = self.model.sap.end_points(axis)
        if named(self.model.boxes):
            draw_ends(canvas, axis, values, who, upper)
        swapped = (
            self.model.swapped[axis]
            if axis < len(self.model.swapped) and len(self.model.swapped[axis]) == len(values)
            else upper & False
        )
        limit = (WIDTH, HEIGHT)[axis]
        middle = -0.5 * (NEAR + FAR) - 0.04
        line = np.array([[0.0, middle], [limit, middle]])
        inks = np.where(upper, canvas.ink("pink"), canvas.ink("chalk"))
        inks = np.where(swapped, canvas.ink("amber"), inks).astype(np.uint32)
        ends = np.where(upper, middle - TICK, middle + TICK)
        inside = (values >= 0.0) & (values <= limit)
        tails = np.stack([values, np.full(len(values), middle)], axis=1)[inside]
        heads = np.stack([values, ends], axis=1)[inside]
        if axis == 1:
            line, tails, heads = line[:, ::-1], tails[:, ::-1], heads[:, ::-1]
        canvas.segments(tails, heads, inks[inside], 1.0, alpha=0.8)
        canvas.line(line[0], line[1], "line2", 1.0)
