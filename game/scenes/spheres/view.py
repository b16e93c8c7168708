"""How spheres, their impulses and the ledger are drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.spheres import ledger
from game.physics.spheres.effects import LEDGES, STRINGS, WINDOW
from game.scenes.spheres.frozen_impact import draw_impact_frozen
from game.scenes.spheres.hand import Hand
from game.scenes.spheres.ledger import entry_of, has_ledger
from game.scenes.spheres.level import COLORS
from game.scenes.spheres.model import CollisionModel
from game.scenes.spheres.pushes import point_of
from game.scenes.spheres.state import SphereState
from game.stage import blend
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.raster.rimmed_discs import draw_rimmed_discs
from game.ui.raster.threads import draw_threads

FADING_S = 0.5  # s that an impulse is shown
MOST_ARROWS = 60
MOST_LINES = 6_000  # of radii
THREADED = 12.0  # window px of radius: up to it, lines of radii are threads
THIN = 0.2  # of the greatest contact force: below it, lines are threads
SMALLEST_LINED = 3.0  # window px of radius: below, spheres are plain discs
NUMBERED = 13.0  # design px of radius from which on a sphere is large enough for its number
ARROW_SHARE = 0.12  # of the height in view: an arrow of the usual impulse


class CollisionView:
    """Draws a model and what a hand does to it; keeps nothing that matters."""

    def __init__(self, model: CollisionModel, hand: Hand) -> None:
        self.model, self.hand = model, hand
        self.lit: int | None = None  # number of the collision whose row of the ledger is under the pointer

    # -- words --------------------------------------------------------------------------------------

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        world = self.model.world
        count = f"{len(world.bodies.composition.radii):,}".replace(",", " ")
        names = self.model.content.materials
        kinds = np.bincount(world.bodies.composition.kinds, minlength=max(len(names), 1))
        if len(names) > 1:
            rows = [
                (f"disc:{COLORS[i]}", name, f"{kinds[i]:,}".replace(",", " ")) for i, name in enumerate(names)
            ]
        else:
            rows = [("disc:text1", "spheres", count)]
        if self.model.parameters.shown_impulses:
            rows.append(("arrow:amber", "impulses", f"{world.collisions:,}".replace(",", " ")))
        if self.model.parameters.shown_bearing:
            rows.append(("line:green", "contact forces", str(len(world.contacts[0]))))
        if self.model.exact is not None:
            rows.append(("dash:text1", "event-driven", ""))
        return rows

    # -- the picture --------------------------------------------------------------------------------

    def draw(self, canvas: Canvas, before: SphereState | None, alpha: float) -> None:
        """All of it, from the back to the front, ``alpha`` of the way from the state ``before`` to now."""
        canvas.grid(None, "")
        self._draw_walls(canvas)
        places, tips = self._between(before, alpha)
        self._draw_strings(canvas, places)
        self._draw_spheres(canvas, places, tips)
        self._draw_exact(before, canvas, alpha)
        if self.model.parameters.shown_bearing:
            self._draw_contact_forces(canvas, places)
        if self.model.parameters.shown_impulses:
            self._draw_impulses(canvas)
        self._draw_hand(canvas)
        draw_impact_frozen(self.model, canvas)
        if has_ledger(self.model) and canvas.words:
            self._draw_numbers(canvas, places, tips)
            self._light_collision(canvas, places)

    def _draw_numbers(self, canvas: Canvas, places: Floats, tips: Floats) -> None:
        """The numbers by which the ledger names spheres, beside the radius lines; none on small spheres."""
        radii = self.model.world.bodies.composition.radii
        for s in np.flatnonzero(radii > canvas.px(NUMBERED)).tolist():
            at = places[s] - 0.45 * (tips[s] - places[s])
            canvas.label((float(at[0]), float(at[1])), str(s + 1), "text2", 11, "medium", halo=False)

    def _light_collision(self, canvas: Canvas, places: Floats) -> None:
        """The spheres of the collision that is pointed at in the ledger, and where they met."""
        entry = entry_of(self.model, self.lit) if self.lit is not None else None
        if entry is None:
            return
        radii = self.model.world.bodies.composition.radii
        for s in (int(entry[ledger.ONE]), int(entry[ledger.OTHER])):
            if 0 <= s < len(places):
                canvas.circle(places[s], float(radii[s]), None, 1.0, "amber", 4.0)
        canvas.ring((float(entry[ledger.X]), float(entry[ledger.Y])), 6.0, "amber", 1.8)

    def _between(self, before: SphereState | None, alpha: float) -> tuple[Floats, Floats]:
        """Places (s, 2) and ends of the radius lines (s, 2), m, between the last two steps."""
        bodies = self.model.world.bodies
        now = places_and_tips(bodies.state, bodies.composition)
        if before is None or before.positions.shape != bodies.state.positions.shape:
            return now
        if len(before.radii) != len(bodies.composition.radii):
            return now
        then = places_and_tips(before, before)
        return then[0] + alpha * (now[0] - then[0]), then[1] + alpha * (now[1] - then[1])

    def _draw_exact(self, before: SphereState | None, canvas: Canvas, alpha: float) -> None:
        """Spheres of the event-driven run, dashed, at the same instant as the others."""
        if self.model.exact is None:
            return
        places = self.model.exact.positions
        if before is not None:
            places = blend(before.exact_places, places, alpha)
        for place, radius in zip(places, self.model.exact.radii, strict=True):
            canvas.circle(place, float(radius), None, 1.0, "text1", 1.4, EXACT_DASH, alpha=0.75)

    def _draw_walls(self, canvas: Canvas) -> None:
        left, bottom, right, top = self.model.world.surroundings.window.tolist()
        corners = np.array(((left, bottom), (right, bottom), (right, top), (left, top)))
        if WINDOW in self.model.active:
            canvas.polyline(corners, "line2", 2.0, closed=True)
        if LEDGES in self.model.active:
            for x0, y0, x1, y1 in self.model.world.surroundings.ledges.tolist():
                canvas.line((x0, y0), (x1, y1), "text2", 3.0)

    def _draw_strings(self, canvas: Canvas, places: Floats) -> None:
        around = self.model.world.surroundings
        if STRINGS not in self.model.active or not len(around.hung):
            return
        canvas.segments(around.strings[:, :2], places[around.hung], "line2", 1.4)
        ties = around.strings[:, :2]
        low, high = float(ties[:, 0].min()), float(ties[:, 0].max())
        if np.ptp(ties[:, 1]) == 0.0 and high > low:
            y, over = float(ties[0, 1]), 0.06 * (high - low)
            canvas.line((low - over, y), (high + over, y), "text2", 4.0)

    def _draw_spheres(self, canvas: Canvas, places: Floats, tips: Floats) -> None:
        composition = self.model.world.bodies.composition
        radii = composition.radii
        largest = float(radii.max()) * canvas.pixels_per_unit
        names = self.model.content.materials
        inks = np.array([canvas.ink(name) for name in COLORS], dtype=np.uint32)
        edge = (
            inks[composition.kinds] if len(names) > 1 else np.full(len(radii), canvas.ink("text1"), np.uint32)
        )
        if largest < SMALLEST_LINED:
            canvas.discs(places, radii, edge)
            return
        rim = canvas.px(2.0 if largest > THREADED else 1.0) * canvas.pixels_per_unit
        sizes = radii * canvas.pixels_per_unit
        points = canvas.place_all(places)
        draw_rimmed_discs(*canvas.raster_target, points, sizes, float(rim), canvas.ink("body"), edge)
        if largest > THREADED:
            canvas.segments(places, tips, edge, 1.6)
        elif len(radii) <= MOST_LINES:
            self._thread(canvas, places, tips, edge)
        heavy = np.isinf(composition.masses)[composition.owners]
        for s in np.flatnonzero(heavy).tolist():
            canvas.circle(places[s], float(radii[s]), "line2", 1.0, "text1", 2.0)
        self._draw_joins(canvas, places)

    def _draw_joins(self, canvas: Canvas, places: Floats) -> None:
        """Lines from the centre of a body to the spheres that are joined to it."""
        bodies = self.model.world.bodies
        if bodies.single:
            return
        apart = bodies.composition.offsets.any(axis=1)
        counts = np.bincount(bodies.composition.owners)
        centres = np.zeros((bodies.count, 2))
        np.add.at(centres, bodies.composition.owners, places)
        centres /= counts[:, None]
        canvas.segments(centres[bodies.composition.owners[apart]], places[apart], "text1", 3.0)

    def _draw_contact_forces(self, canvas: Canvas, places: Floats) -> None:
        """What rests on what: lines between centres, four widths by the impulse."""
        contacts, who, held = self.model.world.contacts
        strength = held[:, 0]
        most = float(strength.max(initial=0.0))
        if not most > 0.0:
            return
        radii = self.model.world.bodies.composition.radii
        real = (strength > 0.02 * most) & (who[:, 0] < len(places)) & (who[:, 1] < len(places))
        first = places[who[real, 0]]
        other = np.where(
            (who[real, 1] >= 0)[:, None],
            places[np.maximum(who[real, 1], 0)],
            first + contacts[real, :2] * radii[who[real, 0]][:, None],
        )
        part = strength[real] / most
        thin = part < THIN
        green = np.full(int(thin.sum()), canvas.ink("green"), np.uint32)
        self._thread(canvas, first[thin], other[thin], green)
        for low, high, width in ((THIN, 0.4, 2.2), (0.4, 0.7, 3.4), (0.7, 2.0, 4.6)):
            mine = (part >= low) & (part < high)
            canvas.segments(first[mine], other[mine], "green", width, alpha=0.75)

    def _thread(self, canvas: Canvas, starts: Floats, ends: Floats, inks: NDArray[np.uint32]) -> None:
        """Many thin lines, quickly."""
        n = len(starts)
        if not n:
            return
        pairs = np.stack((np.arange(n), np.arange(n, 2 * n)), axis=1)
        points = canvas.place_all(np.concatenate((starts, ends)))
        draw_threads(*canvas.raster_target, points, pairs, np.zeros(n, np.int64), inks, 0.8)

    def _draw_impulses(self, canvas: Canvas) -> None:
        """Impulses of the last half second, both ways, fading."""
        world = self.model.world
        made = min(world.collisions, len(world.ring))
        if not made:
            return
        entries = world.ring[:made]
        age = world.time - entries[:, ledger.TIME]
        size = np.sqrt((entries[:, ledger.JX : ledger.JZ + 1] ** 2).sum(axis=1))
        recent = np.flatnonzero((age <= FADING_S) & (size > 0.0))
        if not len(recent):
            return
        largest = float(size.max())
        floor = 0.02 * largest
        strongest = recent[np.argsort(-size[recent], kind="stable")][:MOST_ARROWS]
        view = self.model.content.view
        scale = ARROW_SHARE * (view.top - view.bottom) / largest
        for i in strongest.tolist():
            if size[i] < floor:
                continue
            entry = entries[i]
            strength = 1.0 - float(age[i]) / FADING_S
            at = (float(entry[ledger.X]), float(entry[ledger.Y]))
            jx, jy = float(entry[ledger.JX]), float(entry[ledger.JY])
            canvas.arrow(at, (-jx, -jy), "amber", None, scale, 2.0, alpha=strength)
            if entry[ledger.OTHER] >= 0.0:
                canvas.arrow(at, (jx, jy), "amber", None, scale, 2.0, alpha=strength)
            canvas.dot(at, 3.0, "amber", alpha=strength)

    def _draw_hand(self, canvas: Canvas) -> None:
        model, pressed = self.model, self.hand.pressed
        bodies, strength = model.world.bodies, model.parameters.push_strength
        if pressed is not None:
            x, y = point_of(bodies, pressed.body, pressed.place)[:2].tolist()
            to_x, to_y = pressed.to_x, pressed.to_y
            canvas.ring((x, y), 8.0, "amber", 1.8)
            canvas.arrow((x, y), (to_x - x, to_y - y), "amber", "F")
            size = strength * math.hypot(to_x - x, to_y - y)
            middle = (0.5 * (x + to_x), 0.5 * (y + to_y))
            canvas.label(middle, f"{size:.3g} N", "amber", 12, "semibold", offset=(0.0, -14.0))
        for push in model.pushes:
            x, y = point_of(bodies, push.body, push.place)[:2].tolist()
            canvas.arrow((x, y), push.force[:2], "amber", "F", 1.0 / strength)
        if model.parameters.tool == "sphere" and not model.pushes:
            corner = (model.content.view.right, model.content.view.bottom)
            canvas.label(
                corner, "click to make a sphere", "text3", 12, anchor="bottomright", offset=(-12.0, -10.0)
            )


def places_and_tips(state: Any, composition: Any) -> tuple[Floats, Floats]:
    """Places (s, 2) m of the spheres and ends of their radius lines, seen along z."""
    owners, offsets = composition.owners, composition.offsets
    q = state.orientations[owners]
    w, x, y, z = q[:, 0], q[:, 1], q[:, 2], q[:, 3]
    along = np.stack((1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z)), axis=1)
    places = state.positions[owners, :2].copy()
    if offsets.any():
        across = np.stack((2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z)), axis=1)
        out = np.stack((2.0 * (x * z + w * y), 2.0 * (y * z - w * x)), axis=1)
        places += offsets[:, :1] * along + offsets[:, 1:2] * across + offsets[:, 2:] * out
    return places, places + composition.radii[:, None] * along
