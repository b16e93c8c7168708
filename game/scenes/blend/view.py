"""How recorded runs and those between them are drawn: tanks beside each other, links, matched points."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.scenes.blend.level import RunEntry
from game.scenes.blend.recording import FRAME, speed_of_time
from game.scenes.blend.world import BlendState, BlendWorld, Shown
from game.ui.canvas.canvas import Canvas
from game.worlds.hands.hand import Hand
from game.worlds.painting.distances import DistancePainter
from game.worlds.painting.liquid import draw_backdrop

EVERY = 12  # matched points of a picture that are drawn
AT_ONE = 1e-9  # a weight as near to a square of the nine belongs to it


class BlendView:
    """Draws a world."""

    def __init__(self, model: BlendWorld, hand: Hand):
        self.model, self.hand = model, hand
        rows, columns = model.runs[0].distance.shape[1:]
        self.painter = DistancePainter((rows, columns))

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What links are; tanks have their names above them."""
        if len(self.model.links):
            return (("line:vermilion", "links of the hand", str(len(self.model.links))),)
        return ()

    def draw(self, canvas: Canvas, previous: BlendState | None, alpha: float) -> None:
        """All tanks, as they are now."""
        draw_backdrop(canvas)
        model = self.model
        frame = round(model.frame)
        if len(model.runs) == 4:
            for number, one in enumerate(model.squares):
                corner = model.corner(number % 3, number // 3)
                self._draw_tank(canvas, corner, one.blended[frame], one.entry, _said_of(one))
            places = [model.corner(3, row) for row in (2, 1, 0)]
        else:
            matched = ", points matched in both" if model.parameters.matches else ""
            for number, (entry, corner) in enumerate(zip(model.content.runs, model.corners(), strict=True)):
                picture = model.blend.distances[number][frame]
                self._draw_tank(canvas, corner, picture, entry, f"recorded {number + 1}{matched}")
            places = [model.corner(0, 0), model.corner(1, 0)]
        aligned, entry = model.now(True)
        share = f"{float(model.parameters.across):.2g}"
        if len(model.runs) == 4:
            share += f", {float(model.parameters.up):.2g}"
        self._draw_tank(canvas, places[0], aligned, entry, f"between, aligned: {share}", "amber")
        self._draw_tank(canvas, places[1], model.now(False)[0], entry, f"plain mixing: {share}", "vermilion")
        if len(places) > 2:
            self._draw_true(canvas, places[2], frame)
        self._draw_links(canvas)

    def _draw_true(self, canvas: Canvas, corner: tuple[float, float], frame: int) -> None:
        """The true run of the weights, if it is one of the nine."""
        chosen = self.model.parameters
        for one in self.model.squares:
            if abs(one.across - chosen.across) < AT_ONE and abs(one.up - chosen.up) < AT_ONE:
                self._draw_tank(canvas, corner, one.true[frame], one.entry, "true run", "green")
                return
        width, height = self.model.content.tank
        middle = (corner[0] + 0.5 * width, corner[1] + 0.5 * height)
        canvas.label(middle, "true runs: at 0, 0.5 and 1", "text2", 13)

    def _draw_tank(
        self, canvas: Canvas, corner: tuple[float, float], distance: Floats, entry: RunEntry, words: str,
        color: str = "text1",
    ) -> None:  # fmt: skip
        (width, height), (x, y) = self.model.content.tank, corner
        self.painter.draw(canvas, distance, corner, self.model.cell)
        if entry.width > 0.0 and entry.height > 0.0:
            low, high = x + entry.at - 0.5 * entry.width, x + entry.at + 0.5 * entry.width
            top = y + min(entry.height, height)
            canvas.polygon([(low, y), (high, y), (high, top), (low, top)], "line2")
        sides = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        canvas.polyline(sides, color, 2.0, closed=True)
        canvas.label((x, y + height), words, color, 13, "semibold", "bottomleft", offset=(0.0, -3.0))

    def _draw_links(self, canvas: Canvas) -> None:
        """Links, the one that is drawn now, and matched points of two runs at this time."""
        model = self.model
        corners, speed = model.corners(), speed_of_time(model.content.tank)
        for link in model.links:
            (ax, ay), (bx, by) = corners[0], corners[int(link[0])]
            canvas.line((ax + link[3], ay + link[2]), (bx + link[6], by + link[5]), "vermilion", 2.0)
        if self.hand.start is not None and self.hand.point is not None and self.hand.verb == "hint":
            canvas.line(self.hand.start, self.hand.point, "vermilion", 2.0, dash=(4.0, 4.0))
        if not model.parameters.matches or len(model.runs) != 2:
            return
        pairs = model.blend.pairs[0]
        if len(pairs):
            near = pairs[np.abs(pairs[:, 0] - speed * model.frame * FRAME) < 0.5 * model.runs[0].steps[0]]
            chosen = near[np.argsort(near[:, 2], kind="stable")][:: max(1, math.ceil(len(near) / EVERY))]
            if len(chosen):
                first, other = np.asarray(corners[0]), np.asarray(corners[1])
                canvas.discs(first + chosen[:, 2:0:-1], 0.012 * model.content.tank[0], "amber")
                canvas.discs(other + chosen[:, 5:3:-1], 0.012 * model.content.tank[0], "amber")
                for one in chosen:
                    start, end = first + one[2:0:-1], other + one[5:3:-1]
                    canvas.line(
                        (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), "amber", 0.7
                    )


def _said_of(one: Shown) -> str:
    """What stands above one of the nine."""
    if 1.0 in one.weights:
        return "recorded"
    return f"area off {100.0 * one.area:.2g} %, misplaced {100.0 * one.misplaced:.2g} %"
