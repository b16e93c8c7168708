"""The curves: coefficients over the angle of attack with their fits, and lift over drag."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.tunnel.sweep import ANGLE, DRAG, SPREAD
from game.scenes.wind_tunnel.model import WindTunnelModel
from game.stage import Frame
from game.ui.canvas.canvas import Canvas

COLORS = ("vermilion", "green", "violet")
NAMES = ("drag", "lift", "moment")
SAMPLES = 181


class Axis(NamedTuple):
    """What of the values the height of a chart spans."""

    low: float
    high: float
    step: float


def axis_of(values: Floats) -> Axis:
    """Round numbers around values, 0 among them."""
    least, most = min(-0.5, float(np.min(values, initial=0.0))), max(1.0, float(np.max(values, initial=0.0)))
    step = next(s for s in (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 1e9) if (most - least) / s <= 7.0)
    return Axis(step * math.floor(least / step - 0.1), step * math.ceil(most / step + 0.1), step)


def draw_curves(canvas: Canvas, model: WindTunnelModel, box: Frame) -> None:
    """Dots that were measured, the series through them, the plates' law dashed, checks as rings."""
    rows, checks = model.chosen_rows(model.sweep.measured()), model.chosen_rows(model.sweep.measured(True))
    angles, values = model.samples()
    axis = axis_of(values)
    span = _span_of(angles)
    _draw_frame(canvas, box, axis, span)

    def placed(at: Floats, what: Floats) -> Floats:
        x = box.left + (np.degrees(at) + span) / (2.0 * span) * (box.right - box.left)
        y = box.bottom + (what - axis.low) / (axis.high - axis.low) * (box.top - box.bottom)
        return np.stack([x, y], axis=1)

    with canvas.within((box.left, box.bottom), (box.right, box.top)):
        _draw_fits(canvas, model, placed, math.radians(span))
        for k, color in enumerate(COLORS):
            for at, dots, strength in (
                (angles, values[:, k], 0.35),
                (rows[:, ANGLE], rows[:, DRAG + k], 1.0),
            ):
                for place in placed(at, dots).tolist():
                    canvas.dot(place, 3.0, color, strength)
            spread = rows[:, SPREAD + k]
            ends = [placed(rows[:, ANGLE], rows[:, DRAG + k] + side * spread) for side in (-1.0, 1.0)]
            canvas.segments(ends[0], ends[1], color, 1.2, 0.7)
            for place in placed(checks[:, ANGLE], checks[:, DRAG + k]).tolist():
                canvas.ring(place, 5.0, "amber", 1.6)
    _draw_words(canvas, model, box)


def draw_now(canvas: Canvas, model: WindTunnelModel, curves: Frame, polar: Frame) -> None:
    """Over both charts: the angle that is being measured, and what is measured at the present one."""
    if model.sweep.running:
        with canvas.within((curves.left, curves.bottom), (curves.right, curves.top)):
            span = _span_of(model.samples()[0])
            share = (math.degrees(model.tunnel.attack) + span) / (2.0 * span)
            x = curves.left + share * (curves.right - curves.left)
            canvas.line((x, curves.bottom), (x, curves.top), "amber", 1.2, dash=(4.0, 4.0))
    if model.average.settled:
        mean = model.mean()
        drag, lift, _ = mean.book if model.parameters.measure == "book" else mean.wall
        axes = _polar_axes(model.samples()[1])
        with canvas.within((polar.left, polar.bottom), (polar.right, polar.top)):
            at = _on_polar(polar, *axes, np.array([drag]), np.array([lift]))[0]
            canvas.ring(tuple(at), 6.0, "amber", 2.0)


def _span_of(angles: Floats) -> float:
    """Degrees to either side of zero that the angles (rad) need."""
    return 180.0 if not len(angles) or np.max(np.abs(angles)) > 0.51 * math.pi else 90.0


def _draw_frame(canvas: Canvas, box: Frame, axis: Axis, span: float) -> None:
    value = axis.low
    while value <= axis.high + 1e-9:
        y = box.bottom + (value - axis.low) / (axis.high - axis.low) * (box.top - box.bottom)
        zero = abs(value) < 1e-9
        canvas.line((box.left, y), (box.right, y), "text3" if zero else "grid2", 1.0)
        words = f"{value:g}".replace("-", "−")
        canvas.label((box.left, y), words, "text3", 11, anchor="right", offset=(-6.0, 0.0))
        value += axis.step
    for k in range(5):
        share = 0.25 * k
        x = box.left + share * (box.right - box.left)
        canvas.line((x, box.bottom), (x, box.top), "grid2", 1.0)
        words = f"{(2.0 * share - 1.0) * span:g}°".replace("-", "−")
        canvas.label((x, box.bottom), words, "text3", 11, anchor="top", offset=(0.0, 6.0))


def _draw_fits(canvas, model, placed, reach: float) -> None:
    series, plate = model.series, model.plate_fit
    at = np.linspace(-reach, reach, SAMPLES)
    if series is not None:
        values = series.at(at)
        for k, color in enumerate(COLORS):
            canvas.polyline(placed(at, values[:, k]), color, 2.0)
    if plate is not None:
        drag = plate.drag - plate.drag_turn * np.cos(2.0 * at)
        lift = plate.glide * np.sin(2.0 * at)
        canvas.polyline(placed(at, drag), "vermilion", 1.2, dash=(5.0, 4.0))
        canvas.polyline(placed(at, lift), "green", 1.2, dash=(5.0, 4.0))


def _draw_words(canvas: Canvas, model: WindTunnelModel, box: Frame) -> None:
    series = model.series
    left = (box.left, box.top)
    words = "Over the angle of attack"
    if series is not None:
        error = model.check_error()
        words = f"Order {series.order}: drag off by {series.residual[0]:.2g}"
        if error[0] > 0.0:
            words += f", {error[0]:.2g} at checks"
    canvas.label(left, words, "text1", 12, "semibold", anchor="bottomleft", offset=(0.0, -7.0))
    if not len(model.sweep.table):
        middle = (0.5 * (box.left + box.right), 0.5 * (box.bottom + box.top))
        canvas.label(middle, "Press S to sweep the angle and measure.", "text2", 13)


def draw_polar(canvas: Canvas, model: WindTunnelModel, box: Frame) -> None:
    """Lift over drag, by the series and as measured at all angles."""
    _, values = model.samples()
    series = model.series
    across, up = _polar_axes(values)
    for axis, level in ((up, True), (across, False)):
        value = axis.low
        while value <= axis.high + 1e-9:
            share = (value - axis.low) / (axis.high - axis.low)
            words, faint = f"{value:g}".replace("-", "−"), "text3" if abs(value) < 1e-9 else "grid2"
            if level:
                y = box.bottom + share * (box.top - box.bottom)
                canvas.line((box.left, y), (box.right, y), faint, 1.0)
                canvas.label((box.left, y), words, "text3", 11, anchor="right", offset=(-6.0, 0.0))
            else:
                x = box.left + share * (box.right - box.left)
                canvas.line((x, box.bottom), (x, box.top), faint, 1.0)
                canvas.label((x, box.bottom), words, "text3", 11, anchor="top", offset=(0.0, 6.0))
            value += axis.step
    canvas.label((box.left, box.top), "Lift over drag", "text1", 12, "semibold", anchor="bottomleft",
                 offset=(0.0, -7.0))  # fmt: skip
    with canvas.within((box.left, box.bottom), (box.right, box.top)):
        if series is not None:
            curve = series.at(np.linspace(-math.pi, math.pi, SAMPLES))
            canvas.polyline(_on_polar(box, across, up, curve[:, 0], curve[:, 1]), "green", 1.8)
        for place in _on_polar(box, across, up, values[:, 0], values[:, 1]).tolist():
            canvas.dot(place, 2.6, "text1")


def _polar_axes(values: Floats) -> tuple[Axis, Axis]:
    """Of drag, from 0, and of lift, about values (n, 3)."""
    across, up = axis_of(values[:, 0]), axis_of(values[:, 1])
    return Axis(0.0, across.high, across.step), up


def _on_polar(box: Frame, across: Axis, up: Axis, drag: Floats, lift: Floats) -> Floats:
    """Places (n, 2) in the picture."""
    x = box.left + (drag - across.low) / (across.high - across.low) * (box.right - box.left)
    y = box.bottom + (lift - up.low) / (up.high - up.low) * (box.top - box.bottom)
    return np.stack([x, y], axis=1)
