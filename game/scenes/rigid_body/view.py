"""How the rigid body scene is drawn: boxes, lit spheres, the exact outline, vectors, and the sphere of L."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.fields import GRAVITY
from game.physics.rigid import ROTATION, WINDOW, quaternion_to_matrix
from game.physics.rigid.motion import P, Q, X
from game.scenes.rigid_body import bodies as bo
from game.scenes.rigid_body.bodies import Bodies
from game.scenes.rigid_body.camera import camera_matrix
from game.scenes.rigid_body.hand import Hand
from game.scenes.rigid_body.level import COLOR, COLORS, RADIUS
from game.scenes.rigid_body.model import RigidModel, RigidState
from game.scenes.rigid_body.momentum_sphere import draw_momentum_sphere
from game.scenes.rigid_body.sphere_card import draw_sphere_card
from game.stage import blend, blend_quaternions
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.painters.spheres import OUTLINE_CORNERS, SpherePainter, trace_outline

INKS = {"ivory": 0xE9E0CF, "stone": 0xA79C8E}  # beside the colours of the theme
VELOCITY_M, ACCELERATION_M, SPIN_M = 0.22, 0.04, 0.22  # m for each m/s, m/s², rad/s
LONGEST_M = 2.2  # of an arrow in the picture
APART_PX = 18.0  # at least, of the tips of two arrows with labels
FORCE_M = 0.0005  # m for each N of a push that acts
MOST_OUTLINES = 60  # spheres; of more, the exact outline is their hull
HULL_CORNERS = 90
SMALLEST_PX = 3.0  # radius at which spheres are drawn at least


class RigidView:
    """Draws a model and what a hand does to it; keeps the painter's memory."""

    def __init__(self, model: RigidModel, hand: Hand) -> None:
        self.model, self.hand = model, hand
        self._painter = SpherePainter()

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        model, shown = self.model, self.model.parameters
        rows = []
        if shown.ghost:
            rows.append(("dash:text1", "exact", ""))
        if shown.vectors:
            body = model.bodies.all[bo.A]
            if np.abs(body.momentum).max() > 1e-9 * body.mass:
                rows.append(("arrow:chalk", "velocity v, momentum P", ""))
            if GRAVITY in model.active or self._force(bo.A)[1] is not None:
                rows.append(("arrow:violet", "acceleration a", ""))
            if self.hand.grip == "push" or self._force(bo.A)[1] is not None:
                rows.append(("arrow:amber", "force f", ""))
            if ROTATION in model.active:
                rows.append(("arrow:pink", "spin ω", ""))
                rows.append(("arrow:green", "angular momentum L", ""))
        return rows

    def draw(self, canvas: Canvas, before: RigidState | None, alpha: float) -> None:
        """All of it, from the back to the front, ``alpha`` of the way from the state ``before`` to now."""
        model, shown = self.model, self.model.parameters
        view = camera_matrix(shown.turn, shown.tilt)
        rows = self._between(before, alpha)
        panes = model.panes.shown
        for pane in panes:
            self._draw_box(canvas, view, pane, behind=True)
        self._draw_spheres(canvas, view, rows, panes)
        for pane in panes:
            shift = np.array((model.panes.shift(pane), 0.0))
            if shown.ghost:
                self._draw_exact(canvas, view, rows, shift)
            self._draw_box(canvas, view, pane, behind=False)
            if shown.axes:
                self._draw_axes(canvas, view, rows[pane], shift)
            if shown.vectors:
                self._draw_vectors(canvas, view, rows[pane], pane, shift)
        self._draw_hand(canvas, view)
        hand = self.hand
        if not hand.grip and hand.pane in panes and 0 <= hand.hovered < len(model.bodies.design):
            place = _seen(model.bodies, view, rows[hand.pane])[0][hand.hovered, :2]
            place = place + np.array((model.panes.shift(hand.pane), 0.0))
            canvas.circle(place, float(model.bodies.design[hand.hovered, RADIUS]), None, 1.0, "amber", 2.0)
            draw_sphere_card(canvas, model, hand.pane, hand.hovered, place)
        if shown.twin:
            self._draw_titles(canvas, panes)
        if shown.momentum_sphere and ROTATION in model.active:
            draw_momentum_sphere(model, canvas)

    def _between(self, before: RigidState | None, alpha: float) -> Floats:
        """States (3, 13) between the last two steps."""
        now = self.model.bodies.rows
        if (
            before is None
            or before.rows.shape != now.shape
            or before.design.shape != self.model.bodies.design.shape
        ):
            return now
        rows = now.copy()
        rows[:, X:Q] = blend(before.rows[:, X:Q], now[:, X:Q], alpha)
        rows[:, Q:P] = blend_quaternions(_units(before.rows[:, Q:P]), _units(now[:, Q:P]), alpha)
        return rows

    # -- bodies -------------------------------------------------------------------------------------

    def _draw_spheres(self, canvas: Canvas, view: Floats, rows: Floats, panes: Sequence[int]) -> None:
        """All spheres of all panes in one go."""
        design, n = self.model.bodies.design, len(self.model.bodies.design)
        scale = canvas.pixels_per_unit
        inks = [INKS[name] if name in INKS else canvas.ink(name) for name in COLORS]
        radii = np.maximum(scale * design[:, RADIUS], SMALLEST_PX * canvas.k)
        colors = np.array(inks, np.uint32)[design[:, COLOR].astype(int)]
        points, turns = np.empty((n * len(panes), 3)), np.empty((len(panes), 3, 3))
        for k, pane in enumerate(panes):
            seen, turns[k] = _seen(self.model.bodies, view, rows[pane])
            part = points[k * n : (k + 1) * n]
            part[:, 2] = scale * seen[:, 2]
            part[:, :2] = canvas.place_all(seen[:, :2] + (self.model.panes.shift(pane), 0.0))
        pixels, clip = canvas.raster_target
        self._painter.draw(
            pixels, clip, points, np.tile(radii, len(panes)), turns,
            np.repeat(np.arange(len(panes)), n), np.tile(colors, len(panes)),
        )  # fmt: skip

    def _draw_exact(self, canvas: Canvas, view: Floats, rows: Floats, shift: Floats) -> None:
        """Outlines of the exact body's spheres."""
        radii = self.model.bodies.design[:, RADIUS]
        centers = _seen(self.model.bodies, view, rows[bo.EXACT])[0][:, :2] + shift
        if len(centers) > MOST_OUTLINES:
            points = hull_of_discs(centers, radii)
        else:
            points = np.empty((len(centers) * (OUTLINE_CORNERS + 2), 2))
            trace_outline(centers, np.ascontiguousarray(radii), points)
        canvas.polyline(points, "text1", 1.4, dash=EXACT_DASH, alpha=0.75)

    # -- around them --------------------------------------------------------------------------------

    def _draw_box(self, canvas: Canvas, view: Floats, pane: int, behind: bool) -> None:
        """Edges of the window: those behind the body, or those before it."""
        edges = self.model.panes.box @ view.T
        depth = edges[:, :, 2].mean(axis=1)
        chosen = edges[depth < 0.0 if behind else depth >= 0.0][:, :, :2] + (
            self.model.panes.shift(pane),
            0.0,
        )
        color = "line2" if WINDOW in self.model.active else "line"
        canvas.segments(chosen[:, 0], chosen[:, 1], color, 1.2, 0.9 if behind else 0.5)

    def _draw_axes(self, canvas: Canvas, view: Floats, row: Floats, shift: Floats) -> None:
        """The three principal axes, with their numbers."""
        turn = view @ quaternion_to_matrix(row[Q:P])
        center = view @ row[X:Q]
        reach = _reach(self.model.bodies) + 0.25
        for k in range(3):
            tip = reach * turn[:2, k]
            a, b = center[:2] + shift - tip, center[:2] + shift + tip
            canvas.line(a, b, "text3", 1.2, (5.0, 4.0))
            canvas.label(b + 0.12 * turn[:2, k], str(k + 1), "text2", 12, "semibold")

    def _draw_vectors(self, canvas: Canvas, view: Floats, row: Floats, pane: int, shift: Floats) -> None:
        """v, P, a, f at the centre or their point; ω and L."""
        body = self.model.bodies.all[pane]
        center = (view @ row[X:Q])[:2] + shift

        def arrow(
            vector: Floats, scale: float, color: str, label: str, unit: str, width: float = 2.4
        ) -> None:
            """One that would leave the picture is cut short, and says how much it is."""
            shaft = scale * (view @ vector)[:2]
            length = math.sqrt(float(shaft @ shaft))
            if length > LONGEST_M:
                shaft *= LONGEST_M / length
                if unit:  # not for L, which may lie on ω
                    words = f"{math.sqrt(float(vector @ vector)):.3g} {unit}"
                    canvas.label(center + shaft, words, color, 12, anchor="topleft", offset=(12.0, 4.0))
            canvas.arrow(center, shaft, color, label, width=width)

        if ROTATION in self.model.active:
            middle = float(body.moments[1])
            if middle > 0.0:
                arrow(body.angular_momentum, SPIN_M / middle, "green", "L", "")
            arrow(body.angular_velocity, SPIN_M, "pink", "ω", "rad/s")
        # P beside v: a half longer, were it not for a density other than 700 kg/m³
        longer = 1.5 * self.model.parameters.density / 700.0
        flat = VELOCITY_M * float(np.abs(view[:2] @ body.velocity).max())
        apart = abs(longer - 1.0) * flat > canvas.px(APART_PX)
        thin = "P" if apart else ""
        arrow(body.momentum, longer * VELOCITY_M / body.mass, "chalk", thin, "kg m/s", 1.2)
        arrow(body.velocity, VELOCITY_M, "chalk", "v", "m/s")
        force, point = self._force(pane)
        acceleration = force / body.mass
        if GRAVITY in self.model.active:
            acceleration = acceleration - (0.0, self.model.parameters.gravity, 0.0)
        arrow(acceleration, ACCELERATION_M, "violet", "a", "m/s²")
        if point is not None:
            tail = (view @ point)[:2] + shift
            canvas.arrow(tail, FORCE_M * (view @ force)[:2], "amber", "f")
            canvas.dot(tail, 4.5, "amber")

    def _force(self, pane: int) -> tuple[Floats, Floats | None]:
        """Force (3,) N by hand that acts on a body now, and its point (3,) m."""
        pull = self.hand.acting()
        if pull is None:
            return np.zeros(3), None
        return np.array(pull.force), self.model.bodies.point_of(pane, pull.arm)

    def _draw_hand(self, canvas: Canvas, view: Floats) -> None:
        """The force that is being drawn, or the sphere that is being added."""
        if self.hand.grip not in ("push", "sphere"):
            return
        shift = np.array((self.model.panes.shift(self.hand.pane), 0.0))
        start, target = ((view @ np.array(at))[:2] + shift for at in (self.hand.start, self.hand.target))
        if self.hand.grip == "sphere":
            radius = self.hand.new_radius()
            canvas.circle(start, radius, "amber", 0.2, "amber", 2.0)
            canvas.label(start, f"{radius:.2f} m", "text1", 12, offset=(0.0, -14.0))
            return
        if self.model.parameters.pushing == "hold":
            start = (view @ self.model.bodies.point_of(self.hand.pane, self.hand.arm))[:2] + shift
            canvas.line(start, target, "amber", 1.6, (8.0, 6.0))
        else:
            canvas.arrow(start, target - start, "amber", "f")
        canvas.dot(start, 4.5, "amber")
        newton = self.model.parameters.strength * math.dist(start, target)
        words = f"{newton / 1000.0:.2f} kN" if newton >= 1000.0 else f"{newton:.0f} N"
        canvas.label(target, words, "amber", 12, "semibold", offset=(0.0, -18.0))

    def _draw_titles(self, canvas: Canvas, panes: Sequence[int]) -> None:
        """Letter and method above each box, and how often the body in it has turned over."""
        top, exact = self.model.panes.frame().top, int(self.model.bodies.accounts[bo.EXACT, bo.FLIPS])
        for pane in panes:
            words = f"{'AB'[pane]}  {self.model.method_label(pane)}"
            color = "green" if pane == bo.B else "chalk"
            place, flips = (
                (self.model.panes.shift(pane), top),
                int(self.model.bodies.accounts[pane, bo.FLIPS]),
            )
            canvas.label(place, words, color, 13, "semibold", "top")
            if flips or exact:
                words = f"{flips} flip{'s' if flips != 1 else ''}, exact {exact}"
                canvas.label(place, words, "text2", 12, "medium", "top", offset=(0.0, 18.0))


def _units(q: Floats) -> Floats:
    """Quaternions (n, 4) at length 1."""
    return q / np.sqrt((q * q).sum(axis=1, keepdims=True))


def _seen(bodies: Bodies, view: Floats, row: Floats) -> tuple[Floats, Floats]:
    """Centres (n, 3) m of a body's spheres in the picture's frame, and its turn there (3, 3)."""
    turn = view @ quaternion_to_matrix(row[Q:P])
    return bodies.all[bo.A].offsets @ turn.T + view @ row[X:Q], turn


def hull_of_discs(centers: Floats, radii: Floats) -> Floats:
    """Points (k, 2), closed, of the convex outline of discs (n, 2), (n,): the farthest in each direction."""
    angles = np.linspace(0.0, 2.0 * math.pi, HULL_CORNERS + 1)
    directions = np.column_stack((np.cos(angles), np.sin(angles)))
    farthest = np.argmax(centers @ directions.T + radii[:, None], axis=0)
    return centers[farthest] + radii[farthest, None] * directions


def _reach(bodies: Bodies) -> float:
    """Radius (m) about the centre of mass within which the body is."""
    offsets = bodies.all[bo.A].offsets
    return float((np.sqrt((offsets * offsets).sum(axis=1)) + bodies.design[:, RADIUS]).max())
