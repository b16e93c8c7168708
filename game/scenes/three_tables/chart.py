"""The chart of the three tables: distance from the exact one over the time of the shot, in powers of ten."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.three_tables.model import ThreeTablesModel
from game.scenes.three_tables.places import ACROSS, ALONG
from game.scenes.three_tables.readouts import LEAST
from game.scenes.three_tables.shot import LONGEST_S, SAMPLES_HZ
from game.scenes.three_tables.state import TIME
from game.ui.canvas.canvas import Canvas

CHART = (ACROSS - 0.08, ALONG - 0.02)  # m, top left corner of the chart
CHART_SIZE = (1.40, 2.50)  # m, down and to the right
SERIES = {"lecture": "chalk", "stepped": "green", "perturbed": "pink"}  # those of the strip
SPANS = (3.0, 6.0, 10.0, 20.0, 40.0, LONGEST_S)  # s
HIGHEST, LOWEST = 1.0, -16.0  # log10 m, of the chart


def draw_chart(canvas: Canvas, model: ThreeTablesModel, time: float) -> None:
    """Distance from the exact table over time, in powers of ten."""
    x0, y0 = CHART
    down, right = CHART_SIZE
    canvas.halo = canvas.theme.bg
    canvas.label((x0 - 0.11, y0 + 0.02), "Off the exact table", "text1", 13, "semibold", anchor="left")
    behind = model.playing and model.shown_s < model.shot[TIME]
    if behind:
        words = f"computing: {model.shown_s:.0f} of {model.shot[TIME]:.0f} s"
        canvas.label((x0 - 0.11, y0 + right), words, "text2", 12, anchor="right")
    corners = np.array([(x0, y0), (x0, y0 + right), (x0 + down, y0 + right), (x0 + down, y0)])
    canvas.polygon(corners, fill="stage", outline="line", width=1.0)
    span = span_at(time)

    def place(seconds: float, logarithm: float) -> tuple[float, float]:
        share = (HIGHEST - min(max(logarithm, LOWEST), HIGHEST)) / (HIGHEST - LOWEST)
        return x0 + share * down, y0 + min(seconds / span, 1.0) * right

    for power, words in ((0, "1 m"), (-3, "1 mm"), (-6, "1 µm"), (-9, "1 nm"), (-12, "1 pm"), (-15, "1 fm")):
        canvas.line(place(0.0, power), place(span, power), "grid2", 1.0)
        canvas.label(place(0.0, power), words, "text3", 11, anchor="right", offset=(-6.0, 0.0))
    canvas.label(
        place(span, LOWEST), f"{span:.0f} s", "text3", 11, anchor="right", offset=(-6.0, -9.0), halo=False
    )
    if not model.playing:
        canvas.label(
            place(0.5 * span, -7.0), "Strike: the curves start with the shot", "text3", 12, halo=False
        )
        return
    canvas.halo = canvas.theme.stage
    ends = []
    for name, curve in model.differences_until(time).items():
        points = np.array([place(i / SAMPLES_HZ, math.log10(max(d, LEAST))) for i, d in enumerate(curve)])
        if len(points) > 1:
            canvas.polyline(points, SERIES[name], 1.8)
        if len(points):
            canvas.dot(points[-1], 3.5, SERIES[name])
            ends.append((points[-1], name))
    for point, name in _apart(ends, 16.0 / canvas.pixels_per_unit * canvas.k):
        near_end = point[1] > y0 + 0.72 * right
        canvas.label(
            point, name, SERIES[name], 12, "semibold", anchor="right" if near_end else "left",
            offset=(-8.0 if near_end else 8.0, 0.0),
        )  # fmt: skip


def span_at(time: float) -> float:
    """How long a time the chart shows at a time of the shot, s: a round one that grows with the curves."""
    return next((span for span in SPANS if time <= span), SPANS[-1])


def _apart(ends: list[tuple[np.ndarray, str]], least: float) -> list[tuple[np.ndarray, str]]:
    """Labels pushed apart downwards, so that no two overlap."""
    spread: list[tuple[np.ndarray, str]] = []
    for point, name in sorted(ends, key=lambda end: float(end[0][0])):
        x = float(point[0]) if not spread else max(float(point[0]), float(spread[-1][0][0]) + least)
        spread.append((np.array((x, point[1])), name))
    return spread
