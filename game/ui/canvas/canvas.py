"""The canvas: what a scene draws on, in world units, with colours by name and sizes in design pixels.

Every shape goes straight into the pixels through a kernel, in the order it is asked for. Text and pictures
are blits on the same memory. What is not finite or absurdly far away is not drawn, and nothing raises for it.
Angles are world angles (rad), lengths world units, unless a name says px: those are design pixels.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pygame

from game.ui import raster
from game.ui.canvas.base import Dash, Point, Token
from game.ui.canvas.fields import FieldCanvas
from game.ui.canvas.grid import draw_grid
from game.ui.raster.projection import as_points, map_points
from game.ui.text.formula import render_formula
from game.ui.text.vector_label import vector_label

STAMP_PX = 3.5  # largest radius of the quick small discs
EXACT_DASH, PREDICTION_DASH = (6.0, 6.0), (8.0, 6.0)  # design px on, off
_ANCHORS = {
    "center": (0.5, 0.5), "left": (0.0, 0.5), "right": (1.0, 0.5), "top": (0.5, 0.0), "bottom": (0.5, 1.0),
    "topleft": (0.0, 0.0), "topright": (1.0, 0.0), "bottomleft": (0.0, 1.0), "bottomright": (1.0, 1.0),
}  # fmt: skip


class Canvas(FieldCanvas):
    """Draws the shapes, marks, words and things of the physics."""

    # -- lines and areas ----------------------------------------------------------------------------

    def line(
        self, a: Point, b: Point, color: Token = "text1", width: float = 1.6, dash: Dash | None = None,
        alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """A straight line with round ends, or dashed."""
        ink, opacity = self._ink(color)
        (x0, y0), (x1, y1) = self._place(a), self._place(b)
        w = float(width * self.k)
        if dash is None:
            raster.stroke_segment(
                self._pixels, self._clip, x0, y0, x1, y1, w, raster.ROUND, ink, float(opacity * alpha)
            )
            return
        self._pair[0, 0], self._pair[0, 1], self._pair[1, 0], self._pair[1, 1] = x0, y0, x1, y1
        self._dashes(self._pair, w, False, dash, ink, opacity * alpha)

    def polyline(
        self, points: Any, color: Token = "text1", width: float = 2.2, closed: bool = False,
        dash: Dash | None = None, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """A chain of lines through (n, 2) points; a point that is not finite breaks it."""
        self._stroke(self._map(points), color, width, closed, dash, alpha)

    def polygon(
        self, points: Any, fill: Token | None = None, fill_alpha: float = 1.0, outline: Token | None = None,
        width: float = 2.0, dash: Dash | None = None, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """A closed shape of any form through (n, 2) points."""
        mapped = self._map(points)
        if fill is not None:
            ink, opacity = self._ink(fill)
            share = float(opacity * fill_alpha)
            raster.fill_polygon(self._pixels, self._clip, self._area, self._extent, mapped, ink, share)
        if outline is not None:
            self._stroke(mapped, outline, width, True, dash, alpha)

    def circle(
        self, center: Point, radius: float, fill: Token | None = None, fill_alpha: float = 1.0,
        outline: Token | None = None, width: float = 2.0, dash: Dash | None = None, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """A circle of a radius in world units; its outline lies on the radius."""
        (x, y), r = self._place(center), float(radius * self._scale)
        if fill is not None:
            ink, opacity = self._ink(fill)
            raster.fill_disc(self._pixels, self._clip, x, y, r, ink, float(opacity * fill_alpha))
        if outline is None:
            return
        ink, opacity = self._ink(outline)
        w, share = float(width * self.k), float(opacity * alpha)
        if dash is None:
            raster.stroke_ring(self._pixels, self._clip, x, y, r, w, ink, share)
        elif math.isfinite(x + y + r) and 0.0 < r < 1e6:
            turns = np.linspace(0.0, 2.0 * math.pi, min(max(int(r), 16), 720), endpoint=False)
            points = np.column_stack((x + r * np.cos(turns), y + r * np.sin(turns)))
            self._dashes(points, w, True, dash, ink, share)

    def arc(
        self, center: Point, radius: float, start: float, end: float, color: Token = "text1",
        width: float = 1.5, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """An arc from one world angle to another (rad), the way their difference says; world radius."""
        (x, y), (ink, opacity) = self._place(center), self._ink(color)
        if not math.isfinite(start + end):
            return
        sweep = float(self.camera.handedness * (end - start))
        first = self.camera.angle_to_screen(start)
        r, w = float(radius * self._scale), float(width * self.k)
        raster.stroke_arc(self._pixels, self._clip, x, y, r, w, first, sweep, ink, float(opacity * alpha))

    def segments(self, a: Any, b: Any, color: Any = "text1", width: float = 1.6, alpha: float = 1.0) -> None:
        """Many lines from ``a`` (n, 2) to ``b`` (n, 2); one colour or uint32 (n,)."""
        a, b = as_points(a), as_points(b)
        n = min(a.shape[0], b.shape[0])
        lines = np.empty((n, 4))
        lines[:, :2] = self._map(a[:n])
        lines[:, 2:] = self._map(b[:n])
        colors, opacity = self._color_array(color, n)
        w = float(width * self.k)
        raster.stroke_segments(
            self._pixels, self._clip, lines, w, raster.ROUND, colors, float(opacity * alpha)
        )

    # -- marks of a fixed size ----------------------------------------------------------------------

    def dot(self, center: Point, radius_px: float = 4.5, color: Token = "amber", alpha: float = 1.0) -> None:
        """A small disc of a size in design px."""
        (x, y), (ink, opacity) = self._place(center), self._ink(color)
        raster.fill_disc(self._pixels, self._clip, x, y, radius_px * self.k, ink, float(opacity * alpha))

    def ring(
        self,
        center: Point,
        radius_px: float = 8.0,
        color: Token = "amber",
        width: float = 1.5,
        alpha: float = 1.0,
    ) -> None:
        """A small ring of a size in design px."""
        (x, y), (ink, opacity) = self._place(center), self._ink(color)
        r, w = float(radius_px * self.k), float(width * self.k)
        raster.stroke_ring(self._pixels, self._clip, x, y, r, w, ink, float(opacity * alpha))

    def handle(self, position: Point, hovered: bool = False) -> None:
        """A thing to drag: an accent ring filled with the stage's colour."""
        self.dot(position, 4.5 if not hovered else 5.5, "accent" if hovered else "stage")
        self.ring(position, 4.5 if not hovered else 5.5, "accent", 2.0)

    def contact(self, position: Point, chosen: bool = False) -> None:
        """A contact point: an amber disc, with a ring when it is the chosen one."""
        self.dot(position, 4.5, "amber")
        if chosen:
            self.ring(position, 8.0, "amber", 1.5)

    def arrow(
        self, tail: Point, vector: Point, color: Token = "chalk", label: str | None = None,
        scale: float = 1.0, width: float = 2.4, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """A vector from ``tail``, ``scale`` world units long for each unit of it; ``label`` in bold italic.

        A label may hold the markup of formulas, e.g. ``v_1``.
        """
        x0, y0 = self._place(tail)
        dx = (self._a * float(vector[0]) + self._b * float(vector[1])) * scale
        dy = (self._c * float(vector[0]) + self._d * float(vector[1])) * scale
        length = math.sqrt(dx * dx + dy * dy)
        if not 1.5 * self.k < length < 1e7:
            return
        ink, opacity = self._ink(color)
        raster.fill_arrow(
            self._pixels, self._clip, self._area, self._extent, x0, y0, x0 + dx, y0 + dy,
            float(width * self.k), ink, float(opacity * alpha),
        )  # fmt: skip
        if label:
            out = 13.0 * self.k / length
            picture = vector_label(self.fonts, label, self.look.color(color, words=True), self.halo)
            self._blit_at(picture, x0 + dx * (1.0 + out), y0 + dy * (1.0 + out), 0.5, 0.5)

    # -- words and pictures -------------------------------------------------------------------------

    def label(
        self, position: Point, text: str, color: Token = "text2", size: float = 12, weight: str = "medium",
        anchor: str = "center", offset: Point = (0.0, 0.0), halo: bool = True, alpha: float = 1.0,
        clear: bool = False,
    ) -> None:  # fmt: skip
        """Words at a world point: the ``anchor`` of their box lies there, moved by ``offset`` design px.

        ``clear``: they keep clear of the labels drawn before them, and of the edges.
        """
        if not self.words:
            return
        x, y = self._place(position)
        ink = self.look.color(color, words=True)
        if halo:
            picture = self.fonts.render_on_halo(text, size, weight, ink, self.halo)
        else:
            picture = self.fonts.render(text, size, weight, ink)
        share_x, share_y = _ANCHORS[anchor]
        if alpha < 1.0:
            picture = picture.copy()
            picture.set_alpha(round(255 * max(alpha, 0.0)))
        x, y = x + offset[0] * self.k, y + offset[1] * self.k
        x, y = self._label_place(x, y, *picture.get_size(), share_x, share_y, clear)
        self._blit_at(picture, x, y, share_x, share_y)

    def room_for(self, position: Point, size: Point, offset: Point = (0.0, 0.0)) -> tuple[float, float]:
        """The offset at which a group of labels as large as ``size`` about a world point is clear of others.

        Sizes and offsets in design px. The group's own labels come after it, and need not be clear.
        """
        x, y = self._place(position)
        width, height = size[0] * self.k, size[1] * self.k
        at = self._label_place(x + offset[0] * self.k, y + offset[1] * self.k, width, height, 0.5, 0.5, True)
        return (at[0] - x) / self.k, (at[1] - y) / self.k

    def formula(
        self, position: Point, markup: str, color: Token = "text1", size: float = 18, anchor: str = "center",
        offset: Point = (0.0, 0.0),
    ) -> None:  # fmt: skip
        """A formula at a world point; see ``markup`` for what it may hold."""
        if not self.words:
            return
        x, y = self._place(position)
        picture = render_formula(self.fonts, markup, self.look.color(color, words=True), size)
        share_x, share_y = _ANCHORS[anchor]
        self._blit_at(picture, x + offset[0] * self.k, y + offset[1] * self.k, share_x, share_y)

    def blit(self, picture: pygame.Surface, position: Point, anchor: str = "center", flags: int = 0) -> None:
        """A picture at a world point, not scaled."""
        x, y = self._place(position)
        self._blit_at(picture, x, y, *_ANCHORS[anchor], flags)

    # -- many at once -------------------------------------------------------------------------------

    def discs(self, positions: Any, radius: Any, colors: Any = "text1", alpha: float = 1.0) -> None:
        """Discs at (n, 2) with one radius or (n,), world units; one colour or uint32 (n,)."""
        mapped = self._map(positions)
        n = mapped.shape[0]
        inks, opacity = self._color_array(colors, n)
        if np.ndim(radius) == 0 and not float(radius) * self._scale > STAMP_PX:
            r = max(float(radius) * self._scale, 0.05)
            if not radius > 0.0:
                return
            raster.fill_particles(self._pixels, self._clip, mapped, inks, r, float(opacity * alpha))
            return
        radii = np.ascontiguousarray(np.broadcast_to(np.asarray(radius, np.float64) * self._scale, (n,)))
        raster.fill_discs(self._pixels, self._clip, mapped, radii, inks, float(opacity * alpha))

    def particles(
        self, positions: Any, colors: Any = "text1", radius_px: float = 1.15, alpha: float = 1.0
    ) -> None:
        """Very many small discs of one size in design px."""
        mapped = self._map(positions)
        inks, opacity = self._color_array(colors, mapped.shape[0])
        r = min(max(float(radius_px * self.k), 0.05), STAMP_PX)
        raster.fill_particles(self._pixels, self._clip, mapped, inks, r, float(opacity * alpha))

    def streaks(
        self, positions: Any, velocities: Any, colors: Any = "text1", radius_px: float = 1.15,
        seconds: float = 0.017, alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """Particles with five fading dots along -v over ``seconds``; velocities (n, 2) in world units/s."""
        mapped, velocities = self._map(positions), as_points(velocities)
        n = min(mapped.shape[0], velocities.shape[0])
        trails = self._second.take(n)
        map_points(velocities[:n], self._a, self._b, self._c, self._d, 0.0, 0.0, trails)
        inks, opacity = self._color_array(colors, n)
        r = min(max(float(radius_px * self.k), 0.05), STAMP_PX)
        raster.fill_particle_streaks(
            self._pixels, self._clip, mapped[:n], trails, inks, r, float(seconds), float(opacity * alpha)
        )

    def speed_colors(self, velocities: Any, top_speed: float) -> np.ndarray:
        """Colours (n,) uint32 from pale at rest to blue at ``top_speed``; good until the next call."""
        velocities = as_points(velocities)
        colors = self._color_buffer(velocities.shape[0])
        slow, fast = self._ink("slow")[0], self._ink("fast")[0]
        raster.color_by_speed(velocities, slow, fast, float(top_speed), colors)
        return colors

    # -- things of the physics ----------------------------------------------------------------------

    def body(
        self, center: Point, radius: float, angle: float, color: Token = "body", outline: Token = "text1",
        asleep: bool = False,
    ) -> None:  # fmt: skip
        """A round body with the line of a radius that shows its turn; half as strong when asleep."""
        strength = 0.5 if asleep else 1.0
        self.circle(center, radius, color, strength, outline, 2.0, alpha=strength)
        if math.isfinite(angle):
            rim = (center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle))
            self.line(center, rim, outline, 1.6, alpha=strength)

    def ghost(self, center: Point, radius: float, strength: float) -> None:
        """An earlier place of a round body: its outline, the newer (1) the stronger."""
        alpha = 0.2 + 0.4 * min(max(strength, 0.0), 1.0)
        self.circle(center, radius, outline="ghost", width=1.2, alpha=alpha)

    def ground(self, y: float) -> None:
        """The ground below a height, with its edge."""
        seen = self.camera.visible()
        if not seen.bottom < y:
            return
        corners = ((seen.left, seen.bottom), (seen.right, seen.bottom), (seen.right, y), (seen.left, y))
        self.polygon(np.array(corners), fill="body", fill_alpha=0.75)
        self.line((seen.left, y), (seen.right, y), "line2", 1.0)

    def grid(self, spacing: float | None = None, labels: str = "y") -> None:
        """Lines at round world coordinates; ``labels`` says which axes ("", "x", "y", "xy") have numbers."""
        if self.teaching:
            draw_grid(self, spacing, labels)
