"""The race's plot: what a step costs against the number of boxes, both logarithmic, and the crossovers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.lab.studies.broadphase.count import METHOD_COLORS
from game.scenes.boxes.model.crossover import CostCurves, overtakings
from game.scenes.boxes.model.race import RaceModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.view.race_table import TABLE_LEFT, TABLE_RIGHT
from game.ui.canvas.canvas import Canvas

FEWEST, MOST = 5.0, 1e5  # boxes
LEAST_S, MOST_S = 1e-6, 1.0
SHORT = {
    "uniform": "grid", "covering": "covered", "hierarchical": "hierarchy", "sweep": "sweep", "bsp": "tree",
    "kinetic": "kinetic",
}  # fmt: skip


class Area(NamedTuple):
    """Where the plot stands, m, without the numbers at its left and below it."""

    left: float
    right: float
    bottom: float
    top: float

    def place(self, count: float, seconds: float) -> tuple[float, float]:
        """Where a cost stands, m; kept within the plot."""
        across = math.log(count / FEWEST) / math.log(MOST / FEWEST)
        up = math.log(seconds / LEAST_S) / math.log(MOST_S / LEAST_S)
        across, up = min(max(across, 0.0), 1.0), min(max(up, 0.0), 1.0)
        return self.left + across * (self.right - self.left), self.bottom + up * (self.top - self.bottom)


ABOVE = Area(1.1, 11.1, 9.0, 12.0)  # the world, which has its counts beside the words of the axes
LEAST_HEIGHT = 2.0  # m, that is worth a plot below the table


def area_below(table_foot: float) -> Area:
    """Below the table that ends at a height, m, where there is space; else above the world."""
    below = Area(TABLE_LEFT + 1.0, TABLE_RIGHT, 0.55, table_foot - 0.75)
    return below if below.top - below.bottom >= LEAST_HEIGHT else ABOVE


def crossover_words(curves: CostCurves) -> str:
    """Where the naive method falls behind, in words; before that has been looked for, how to."""
    if not curves.swept:
        return "X looks for the number of boxes from which on the naive method falls behind."
    found = overtakings(curves.swept, "naive", tuple(SHORT))
    known = {name: count for name, count in found.items() if math.isfinite(count)}
    if not known:
        return "Naive is the fastest throughout."
    return "Naive falls behind: " + ", ".join(
        f"{SHORT[name]} from {grouped(count)}"
        for name, count in sorted(known.items(), key=lambda item: item[1])
    )


def draw_plot(canvas: Canvas, model: RaceModel, area: Area) -> None:
    """Axes, for each method the curves of what was measured, and its present cost as a larger dot."""
    _draw_axes(canvas, area)
    now = len(model.boxes)
    line = area.place(now, LEAST_S)[0]
    canvas.line((line, area.bottom), (line, area.top), "amber", 1.0, dash=(4.0, 4.0))
    for name, color in METHOD_COLORS.items():
        for costs in (model.curves.swept.get(name, {}), model.curves.seen.get(name, {})):
            points = np.array([area.place(count, costs[count]) for count in sorted(costs)])
            if len(points) > 1:
                canvas.polyline(points, color, 1.6)
            for point in points:
                canvas.dot(point, 2.0, color)
        if now in model.curves.seen.get(name, {}):
            canvas.dot(area.place(now, model.curves.seen[name][now]), 4.0, color)


def _draw_axes(canvas: Canvas, area: Area) -> None:
    """Frame, decades and their numbers."""
    head = (area.left, area.top)
    canvas.label(head, "time of a step, number of boxes", "text2", 11, "medium", "left", (0.0, -12.0))
    for power, words in ((-6, "1 µs"), (-3, "1 ms"), (0, "1 s")):
        at = area.place(FEWEST, 10.0**power)
        canvas.line(at, (area.right, at[1]), "grid", 1.0)
        canvas.label(at, words, "text3", 11, anchor="right", offset=(-6.0, 0.0))
    for power, words in ((1, "10"), (3, "1 000"), (5, "100 000")):
        at = area.place(10.0**power, LEAST_S)
        canvas.line(at, (at[0], area.top), "grid", 1.0)
        anchor = "right" if power == 5 else "center"
        canvas.label(at, words, "text3", 11, anchor=anchor, offset=(0.0, 11.0))
    canvas.line((area.left, area.bottom), (area.right, area.bottom), "line2", 1.0)
    canvas.line((area.left, area.bottom), (area.left, area.top), "line2", 1.0)
