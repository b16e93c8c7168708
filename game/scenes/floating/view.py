"""How both tanks are drawn: water, the body, its weight, lift and metacentre, and the stability curve."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.arrays import Floats, Point
from game.physics.hydrostatics.cut import cut
from game.physics.hydrostatics.motion import LEVEL, PINNED, TURN, X, Y
from game.physics.kernels import elementary
from game.scenes.floating.curve import CurvePainter
from game.scenes.floating.parameters import TOOLS
from game.scenes.floating.world import LEAD, FloatingWorld, FloatingWorldState
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.members.solids import bodies_between
from game.worlds.painting.inks import color_of, mixed
from game.worlds.painting.liquid import (
    DAY,
    NIGHT,
    SEEN,
    WALL_DAY,
    WALL_NIGHT,
    LiquidPainter,
    draw_backdrop,
    shades_of,
)

WOOD, STONE, LEAD_INK = 0xD9A25F, 0x6E7480, 0x3B4048
BANDS, DEEP = 32, 20.0  # of still water; cells over which its colours go
ARROW = 0.16  # of the tank's height: lift and weight, as long as that


def ink_of(weight: float) -> int:
    """Colour by density beside water's: wood to stone."""
    share = np.clip(np.array([weight / 2.5]), 0.0, 1.0)
    return int(mixed(np.array([WOOD]), STONE, share)[0])


class FloatingView:
    """Draws both tanks and the curve."""

    def __init__(self, model: FloatingWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.painter = LiquidPainter(model.water.liquid)
        self.curve = CurvePainter(model)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the hand does next."""
        return legend_of(TOOLS, self.model.parameters.tool)

    def draw(self, canvas: Canvas, previous: FloatingWorldState | None, alpha: float) -> None:
        """All of it ``alpha`` of the way from the state before to now."""
        draw_backdrop(canvas)
        pose = self._pose(previous, alpha)
        self._draw_still(canvas, float(pose[LEVEL]))
        both = bool(self.model.parameters.both)
        turned = self._draw_liquid(canvas, previous, alpha) if both else None
        self._draw_body(canvas, (float(pose[X]), float(pose[Y])), float(pose[TURN]))
        self._draw_tanks(canvas, both)
        if canvas.marks(self.model.parameters.marks):
            self._draw_marks(canvas, pose)
        self.curve.draw(canvas, float(pose[TURN]), turned)
        if len(self.hand.path) > 1 and self.hand.verb == "draw":
            canvas.polyline(np.array(self.hand.path), "accent", 2.2)

    def _pose(self, previous: FloatingWorldState | None, alpha: float) -> Floats:
        now = self.model.law.body.pose
        if previous is None or len(previous.outline) != len(self.model.outline):
            return now
        return np.asarray(previous.law.pose + alpha * (now - previous.law.pose))

    def _draw_still(self, canvas: Canvas, level: float) -> None:
        """Water with a flat surface, in the colours of the liquid's."""
        dark = is_dark(canvas)
        above, below = NIGHT if dark else DAY
        wall = int((WALL_NIGHT if dark else WALL_DAY)[1])
        inks = mixed(shades_of(above, below).astype(np.int64) & 0xFFFFFF, wall, 1.0 - SEEN)
        width, deep = self.model.content.tank[0], DEEP * self.model.water.liquid.grid.cell
        for k in range(BANDS):  # each down to the floor, so that no seam is seen
            high = level - deep * k / BANDS
            if high > 0.0:
                ink = color_of(int(inks[k * (len(inks) - 1) // (BANDS - 1)]))
                canvas.polygon([(0.0, 0.0), (width, 0.0), (width, high), (0.0, high)], ink)
        canvas.line((0.0, level), (width, level), color_of(0xEAF7FC), 2.0)

    def _draw_liquid(self, canvas: Canvas, previous: FloatingWorldState | None, alpha: float) -> float:
        """The liquid and what floats in it; the angle of its body, rad."""
        model, liquid = self.model, self.model.water.liquid
        places = liquid.places
        if previous is not None and len(previous.liquid.places) == len(places):
            places = previous.liquid.places + alpha * (places - previous.liquid.places)
        if model.parameters.look == "water":
            self.painter.draw(canvas, places)
        else:
            speeds = canvas.speed_colors(liquid.speeds, max(model.fastest(), 0.5))
            canvas.discs(places, 0.45 * math.sqrt(liquid.area), speeds)
        before = previous.solids if previous is not None else None
        at, turns = bodies_between(model.solids.world, before, alpha)
        for other, one in zip(model.others.tolist(), model.content.others, strict=True):
            self._draw_other(canvas, at[other].tolist(), float(turns[other]), one)
        x, y = at[model.body].tolist()
        self._draw_body(canvas, (x, y), float(turns[model.body]))
        return float(turns[model.body])

    def _draw_other(self, canvas: Canvas, at: list[float], angle: float, one: Any) -> None:
        ink = color_of(ink_of(one.density))
        if one.radius > 0.0:
            canvas.circle((at[0], at[1]), one.radius, ink, outline="text3", width=1.2)
            return
        w, h = 0.5 * one.size[0], 0.5 * one.size[1]
        corners = _turned(np.array([(-w, -h), (w, -h), (w, h), (-w, h)]), (at[0], at[1]), angle)
        canvas.polygon(corners, ink, outline="text3", width=1.2)

    def _draw_body(self, canvas: Canvas, at: Point, angle: float) -> None:
        model = self.model
        ink = color_of(ink_of(float(model.built[0]) / 1000.0))
        canvas.polygon(_turned(model.floater.corners, at, angle), ink, outline="text1", width=1.8)
        lead = model.lead_place()
        if lead is not None:
            x, y = _turned(np.array([lead]), at, angle)[0].tolist()
            canvas.circle((x, y), LEAD, color_of(LEAD_INK), outline="text2", width=1.2)

    def _draw_tanks(self, canvas: Canvas, both: bool) -> None:
        width, height = self.model.content.tank
        apart, watch = self.model.content.apart, self.model.law.watch.median("step")
        price = self.model.water.watch.median("step")
        for left, title, took in ((0.0, "By hydrostatics", watch), (apart, "In a liquid", price)):
            walls = [(left, height), (left, 0.0), (left + width, 0.0), (left + width, height)]
            canvas.polyline(walls, "text1", 2.4)
            if left > 0.0 and not both:
                canvas.label((left + 0.5 * width, 0.5 * height), "not computed", "text2", 13)
                continue
            words = title if math.isnan(took) else f"{title}: {canvas.figure(title, _price(took))} a step"
            canvas.label((left + width, height), words, "text1", 15, "semibold", "bottomright", (0.0, -4.0))

    def _draw_marks(self, canvas: Canvas, pose: Floats) -> None:
        """Weight at G, lift at B, and the metacentre M above B."""
        model, floater = self.model, self.model.floater
        c, s = elementary.cos(float(pose[TURN])), elementary.sin(float(pose[TURN]))
        found = cut(floater.corners, c, s, float(pose[LEVEL] - pose[Y]))
        area, width = float(found[0]), float(found[3])
        x, y = float(pose[X]), float(pose[Y])
        long = ARROW * model.content.tank[1]
        canvas.arrow((x, y), (0.0, -long), "amber")
        canvas.dot((x, y), 4.5, "amber")
        canvas.label((x, y), "G", "text1", 13, "semibold", "right", (-8.0, -2.0))
        if model.law.body.hinge[PINNED] > 0.0:
            hx, hy = model.law.body.hinge[3:].tolist()
            canvas.ring((hx, hy), 6.0, "text1", 2.0)
        if area <= 1e-4 * floater.area:
            return
        bx, by = x + float(found[1]) / area, float(pose[LEVEL]) + float(found[2]) / area
        lift = long * area * 1000.0 / floater.mass
        canvas.arrow((bx, by), (0.0, min(lift, 3.0 * long)), "green")
        canvas.dot((bx, by), 4.5, "green")
        canvas.label((bx, by), "B", "text1", 13, "semibold", "left", (8.0, 2.0))
        if width <= 1e-6 or model.law.body.hinge[PINNED] > 0.0:
            return
        my = by + (float(found[5]) - float(found[4]) ** 2 / width) / area
        if my < model.content.tank[1]:
            canvas.line((bx, by), (bx, my), "violet", 1.4, dash=(4.0, 4.0))
            canvas.ring((bx, my), 5.0, "violet", 2.0)
            canvas.label((bx, my), "M", "text1", 13, "semibold", "left", (9.0, 0.0))
        words = canvas.figure("gm", f"GM {100.0 * (my - y):.1f} cm".replace("-", "−"))
        canvas.label((0.0, 0.0), words, "text1", 13, "semibold", "bottomleft", (8.0, -8.0))


def _turned(own: Floats, at: Point, angle: float) -> Floats:
    """Points (n, 2) m of a body, placed."""
    c, s = elementary.cos(angle), elementary.sin(angle)
    return np.stack([c * own[:, 0] - s * own[:, 1] + at[0], s * own[:, 0] + c * own[:, 1] + at[1]], axis=1)


def _price(seconds: float) -> str:
    return f"{1e6 * seconds:.0f} µs" if seconds < 1e-3 else f"{1e3 * seconds:.1f} ms"
