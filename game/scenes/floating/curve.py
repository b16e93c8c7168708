"""How the stability curve is drawn: righting arm over angle, poses at rest, where both bodies are."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.floating.world import FloatingWorld
from game.ui.canvas.canvas import Canvas

TICKS = (-180, -135, -90, -45, 0, 45, 90, 135, 180)
LEAST = 1e-3  # m: a scale is no finer
EDGE = 0.16  # of its height, above and below the curve


class CurvePainter:
    """The curve of a world's body."""

    def __init__(self, model: FloatingWorld):
        self.model = model
        self.left, self.low, self.right, self.high = model.content.chart

    def across(self, angle: float) -> float:
        """m, of an angle (rad), brought within a half turn."""
        turned = angle - math.tau * math.floor(angle / math.tau + 0.5)
        return self.left + (turned / math.tau + 0.5) * (self.right - self.left)

    def draw(self, canvas: Canvas, law: float, liquid: float | None) -> None:
        """law, liquid: angles (rad) of the bodies; None where there is none."""
        curve, middle = self.model.curve, 0.5 * (self.low + self.high)
        half = (0.5 - EDGE) * (self.high - self.low)
        corners = [
            (self.left, self.low),
            (self.right, self.low),
            (self.right, self.high),
            (self.left, self.high),
        ]
        canvas.polygon(corners, "panel", 0.94, outline="line2", width=1.0)
        for tick in TICKS:
            x = self.across(math.radians(tick)) if abs(tick) < 180 else (self.left, self.right)[tick > 0]
            canvas.line((x, self.low), (x, self.high), "grid2", 1.0)
            inside = {-180: "bottomleft", 180: "bottomright"}.get(tick, "bottom")
            canvas.label((x, self.low), f"{tick:d}°".replace("-", "−"), "text3", 11, anchor=inside)
        canvas.line((self.left, middle), (self.right, middle), "line2", 1.2)
        most = max(float(np.abs(curve.arms).max()), LEAST)
        self._draw_words(canvas, most)
        if curve.poses:
            x = np.linspace(self.left, self.right, len(curve.angles))
            points = np.stack([x, middle + half / most * curve.arms], axis=1)
            canvas.polygon([(self.left, middle), *points.tolist(), (self.right, middle)], "accent", 0.12)
            canvas.polyline(points, "text1", 2.0)
        for pose in curve.poses:
            at = (self.across(pose.angle), middle)
            if pose.stable:
                canvas.dot(at, 5.5, "green")
            else:
                canvas.ring(at, 5.5, "vermilion", 2.0)
        if liquid is not None:
            self._draw_mark(canvas, liquid, "chalk", middle, half / most)
        self._draw_mark(canvas, law, "amber", middle, half / most)
        if liquid is not None and self.across(liquid) > self.across(law):
            sides = (("right", -5.0), ("left", 5.0))
        else:
            sides = (("left", 5.0), ("right", -5.0))
        for angle, words, color, (anchor, off) in (
            (law, "hydrostatics", "amber", sides[0]), (liquid, "liquid", "chalk", sides[1]),
        ):  # fmt: skip
            if angle is not None:
                at = (self.across(angle), self.low)
                canvas.label(at, words, color, 12, "semibold", anchor, (off, -26.0))

    def _draw_mark(self, canvas: Canvas, angle: float, color: str, middle: float, scale: float) -> None:
        x, curve = self.across(angle), self.model.curve
        canvas.line((x, self.low), (x, self.high), color, 1.6)
        k = round((x - self.left) / (self.right - self.left) * (len(curve.angles) - 1))
        canvas.dot((x, middle + scale * float(curve.arms[min(max(k, 0), len(curve.arms) - 1)])), 4.5, color)

    def _draw_words(self, canvas: Canvas, most: float) -> None:
        model = self.model
        title = "Righting arm over the angle"
        if model.curve.poses:
            title += f", up to {100.0 * most:.1f} cm"
        canvas.label((self.left, self.high), title, "text1", 12, "semibold", "topleft", (8.0, 6.0))
        if model.floater.mass >= model.floater.area * 1000.0:
            words = "It is heavier than water: it sinks at every angle."
        elif model.curve.neutral:
            words = "No angle is better than another."
        else:
            words = "filled: stable, open: unstable, click: set it down there"
        canvas.label((self.right, self.high), words, "text2", 12, "medium", "topright", (-8.0, 6.0))
