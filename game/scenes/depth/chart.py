"""The shortest motion for each angle, and the intervals of branch and bound below it."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase.depth import ShapePair
from game.scenes.depth.model import OUT, DepthModel
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

LEFT, RIGHT, LOW, HIGH = 2.35, 4.45, -1.45, 1.35  # m, where it stands in the picture
SAMPLES = 121  # odd, so that no turn is one of them
ABOVE = 1.35  # of the translational depth, at the top
MOST_BARS = 400


class DepthChart:
    """Draws the curve of a model; keeps it until the shapes move."""

    def __init__(self, model: DepthModel):
        self.model = model
        self._key: tuple[object, ...] = ()
        self._pair: ShapePair | None = None
        self._angles = np.zeros(0)
        self._sigmas = np.zeros(0)

    def reach(self) -> float:
        """The largest angle shown, rad: beyond it the turn alone is longer than the top of the chart."""
        share = ABOVE * self.model.slide.sigma / (2.0 * self.model.pair.a.gyration)
        return math.pi if share >= 1.0 else 2.0 * math.asin(share)

    def curve(self) -> tuple[Floats, Floats]:
        """Angles (rad) and sigma for each (m)."""
        key = (self.model.places.tobytes(),)
        if self._pair is not self.model.pair or key != self._key:
            self._pair, self._key = self.model.pair, key
            far = self.reach()
            angles = np.linspace(-far, far, SAMPLES)
            self._angles = np.sort(np.append(angles, self.model.found.angle))
            self._sigmas = self.model.pair.sigmas(self._angles)
        return self._angles, self._sigmas

    def draw(self, canvas: Canvas) -> None:
        """The curve on a plate, with both answers."""
        corners = ((2.1, LOW - 0.5), (4.65, LOW - 0.5), (4.65, HIGH + 0.45), (2.1, HIGH + 0.45))
        canvas.polygon(np.array(corners), "stage", 0.92, "line2", 1.0)
        middle = 0.5 * (LEFT + RIGHT)
        canvas.label((middle, HIGH + 0.24), "Shortest motion for each turn", "text1", 13, "semibold")
        canvas.line((LEFT, LOW), (RIGHT, LOW), "text3", 1.0)
        slide, found = self.model.slide, self.model.found
        if slide.sigma <= OUT:
            canvas.label((middle, 0.5 * (LOW + HIGH)), "They do not overlap.", "text2", 13)
            return
        far, top = self.reach(), ABOVE * slide.sigma
        angles, sigmas = self.curve()
        if self.model.parameters.intervals:
            self._draw_intervals(canvas, far, top)
        turns = 2.0 * self.model.pair.a.gyration * np.abs(np.sin(0.5 * angles))
        canvas.polyline(_placed(angles, turns, far, top), "text3", 1.2, dash=(4.0, 4.0))
        canvas.polyline(_placed(angles, np.where(sigmas <= top, sigmas, np.nan), far, top), "chalk", 2.0)
        zero = (middle, LOW)
        canvas.line(zero, (middle, HIGH), "text3", 1.0, dash=(2.0, 4.0))
        for answer, color in ((slide, "amber"), (found, "green")):
            at = _placed(np.array([answer.angle]), np.array([answer.sigma]), far, top)[0]
            canvas.line((LEFT, at[1]), (float(at[0]), at[1]), color, 1.2, dash=(3.0, 3.0))
            canvas.dot((float(at[0]), float(at[1])), 5.0, color)
        checked = self.model.checked
        if checked is not None:
            at = _placed(np.array([checked.angle]), np.array([min(checked.sigma, top)]), far, top)[0]
            canvas.ring((float(at[0]), float(at[1])), 8.0, "pink", 2.0)
        self._draw_words(canvas, far, top)

    def _draw_intervals(self, canvas: Canvas, far: float, top: float) -> None:
        """Each interval as a bar at its bound, of those that reach into the chart."""
        rows = self.model.pair.intervals
        low, high = rows[:, 0] - rows[:, 1], rows[:, 0] + rows[:, 1]
        shown = np.flatnonzero((low < far) & (high > -far) & (rows[:, 3] <= top))[-MOST_BARS:]
        if not len(shown):
            return
        first, last = (
            _placed(np.clip(side[shown], -far, far), rows[shown, 3], far, top) for side in (low, high)
        )
        canvas.segments(first, last, "pink", 1.6, 0.75)

    def _draw_words(self, canvas: Canvas, far: float, top: float) -> None:
        degrees = math.degrees(far)
        for x, words in (
            (LEFT, f"-{degrees:.0f}°"),
            (0.5 * (LEFT + RIGHT), "0°"),
            (RIGHT, f"{degrees:.0f}°"),
        ):
            canvas.label((x, LOW), words, "text2", 11, offset=(0.0, 12.0))
        words = f"top {format_si(top, 'm')}; dashed: the turn alone"
        canvas.label((0.5 * (LEFT + RIGHT), HIGH), words, "text2", 11, offset=(0.0, -8.0))
        found, checked = self.model.found, self.model.checked
        words = f"{found.evaluations} angles tried, certain to {format_si(found.sigma - found.certain, 'm')}"
        place = (0.5 * (LEFT + RIGHT), LOW)
        canvas.label(place, words, "text2", 11, offset=(0.0, 30.0))
        if checked is not None:
            words = f"brute force: {format_si(checked.sigma, 'm')} of {checked.evaluations} motions"
            canvas.label(place, words, "pink", 11, offset=(0.0, 46.0))


def _placed(angles: Floats, sigmas: Floats, far: float, top: float) -> Floats:
    """(n, 2) m in the picture."""
    x = 0.5 * (LEFT + RIGHT) + 0.5 * (RIGHT - LEFT) * angles / far
    return np.stack([x, LOW + (HIGH - LOW) * sigmas / top], axis=1)
