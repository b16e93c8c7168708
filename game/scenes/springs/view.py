"""How particles and links are drawn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.constraints import AREAS, CONTACTS, PositionBasedDynamics
from game.physics.constraints.areas import INTACT
from game.physics.fields import GROUND
from game.scenes.springs.exact_bob import draw_exact_bob
from game.scenes.springs.hand import SpringHand
from game.scenes.springs.level import Point
from game.scenes.springs.model import ComparedState, SpringModel, SpringState
from game.scenes.springs.slow_sweep import draw_slow_sweep
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.raster.threads import draw_threads
from game.worlds.painting.polygons import NO_EDGE, paint

FULL_STRAIN = 0.05  # at which a link has the full colour of stretch or of compression
MOST_POINTS = 1_500  # particles drawn as points; more would cover their links
MOST_STROKES = 2_500  # links drawn as strokes; more are drawn as threads
THREAD_OPACITY = 0.8
MOST_OUTLINES = 1_500
AREA_OPACITY = 0.22
WALL_THICKNESS = 0.12  # m
LARGEST_DOT = 15.0  # design px, of a very heavy particle
Before = SpringState | ComparedState | None


def between(system: PositionBasedDynamics, before: Any, alpha: float) -> Floats:
    """Places (n, 2) m of a system between its state ``before`` the last step (None: not known) and now."""
    now = system.positions
    if before is None or before.fields.shape != system.fields.shape:
        return now
    then = before.fields[:2, : len(now)].T
    return then + alpha * (now - then)


@kernel
def color_by_strain(strains, full, calm, stretched, compressed, colors):
    """Write colours (0xRRGGBB): calm at rest, ``stretched`` or ``compressed`` at a strain of ``full``."""
    for i in range(strains.shape[0]):
        part = min(abs(strains[i]) / full, 1.0)
        end = stretched if strains[i] > 0.0 else compressed
        mixed = 0
        for shift in (0, 8, 16):
            a = calm >> shift & 255
            b = end >> shift & 255
            mixed |= int(a + part * (b - a) + 0.5) << shift
        colors[i] = mixed


class SpringView:
    """Draws a network; keeps the arrays that drawing needs."""

    def __init__(self, model: SpringModel, hand: SpringHand):
        self.model, self.hand = model, hand
        self._colors = np.zeros(0, dtype=np.uint32)

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        system = self.model.system
        whole = len(system.torn) - int(system.torn.sum())
        rows = [("line:text2", self.model.law.noun, f"{whole:,}".replace(",", " "))]
        if self.model.parameters.strains:
            rows.append(("line:vermilion", "stretched by 5 %", ""))
            rows.append(("line:chalk", "compressed by 5 %", ""))
        fixed = int(np.count_nonzero(system.own_inverse_masses() == 0.0))
        rows.append(("square:text1", "fixed in space", str(fixed)))
        if system.held >= 0:
            rows.append(("ring:amber", "in your hand", ""))
        if len(self.model.content.reference):
            rows.append(("dash:text1", "exact", ""))
        return rows

    def draw(self, canvas: Canvas, previous: Before, alpha: float) -> None:
        """All of it, from the back to the front, ``alpha`` of the way from the state ``previous`` to now."""
        model = self.model
        content, on = model.content, model.active
        places = self._between(previous, alpha)
        canvas.grid(None, "y")
        if GROUND in on:
            canvas.ground(content.floor)
            if content.walls is not None:
                self._draw_walls(canvas, content.walls)
        if len(content.reference):
            canvas.polyline(np.array(content.reference), "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
        if AREAS in on:
            self._draw_areas(canvas, places)
        if model.parameters.slow_sweep:
            draw_slow_sweep(canvas, model)
            self._draw_fixed(canvas, model.system.positions)
            return
        self._draw_links(canvas, places)
        radii = self._radii()
        if model.parameters.points and model.system.count <= MOST_POINTS:
            self._draw_particles(canvas, places, radii)
        self._draw_fixed(canvas, places)
        self._draw_hand(canvas, places)
        if model.beside:
            self._draw_beside(canvas, previous, alpha)
        if content.pendulum and not model.edited:
            draw_exact_bob(canvas, model)

    def _draw_beside(self, canvas: Canvas, previous: Before, alpha: float) -> None:
        """The networks solved in other ways, and what each is called and stretched."""
        content, system = self.model.content, self.model.system
        self._name(canvas, system, 0.0, content.label)
        then = previous.beside if isinstance(previous, ComparedState) else (None,) * len(content.beside)
        for entry, other, before in zip(content.beside, self.model.beside, then, strict=True):
            places = between(other, before, alpha) + np.array((entry.to_the_right, 0.0))
            ends = places[other.links.pairs]
            canvas.segments(
                ends[:, 0], ends[:, 1], self._strained(canvas, other), 2.4 if len(ends) < 200 else 1.6
            )
            weights = other.inverse_masses
            sizes = np.clip(3.0 * np.power(np.where(weights > 0.0, weights, 1.0), -0.3), 1.4, LARGEST_DOT)
            canvas.discs(places, canvas.px(1.0) * sizes, "text1")
            self._name(canvas, other, entry.to_the_right, entry.label)

    def _name(self, canvas: Canvas, system: PositionBasedDynamics, shift: float, label: str) -> None:
        """Label and stretch above the highest particle of a network."""
        top = system.positions[np.argmax(system.positions[:, 1])] + np.array((shift, 0.0))
        words = canvas.figure(
            ("stretch", label), f"longest link {100.0 * (1.0 + system.measure().worst_strain):.3g} %"
        )
        canvas.label(top, label, "text1", 13, "semibold", offset=(0.0, -34.0))
        canvas.label(top, words, "text2", 12, offset=(0.0, -16.0))

    def _between(self, before: Before, alpha: float) -> Floats:
        """Places (n, 2) m between the last two steps."""
        return between(self.model.system, before, alpha)

    def _draw_walls(self, canvas: Canvas, walls: Point) -> None:
        """Slabs beside the ground, as high as they are seen."""
        floor = self.model.content.floor
        seen = canvas.camera.visible()
        for x, thickness in zip(walls, (-WALL_THICKNESS, WALL_THICKNESS), strict=True):
            corners = ((x, floor), (x + thickness, floor), (x + thickness, seen.top), (x, seen.top))
            canvas.polygon(np.array(corners), fill="body", fill_alpha=0.75)
            canvas.line((x, floor), (x, seen.top), "line2", 1.0)

    def _draw_areas(self, canvas: Canvas, places: Floats) -> None:
        outlines = self.model.system.outlines
        count = len(outlines.starts) - 1
        if not 0 < count <= MOST_OUTLINES:
            return
        shares = np.where(outlines.rows[INTACT] > 0.0, AREA_OPACITY, 0.0)
        inks = np.full(count, canvas.ink("chalk"), dtype=np.int64)
        none = np.full(count, NO_EDGE, dtype=np.int64)
        paint(canvas, places[outlines.corners], outlines.starts, inks, shares, none, np.zeros((4, 2)))

    def _draw_links(self, canvas: Canvas, places: Floats) -> None:
        system = self.model.system
        pairs = system.links.pairs
        if not len(pairs):
            return
        self._strained(canvas, system)
        if len(pairs) > MOST_STROKES:
            pixels, clip = canvas.raster_target
            mapped = canvas.place_all(places)
            draw_threads(pixels, clip, mapped, pairs, system.torn, self._colors, THREAD_OPACITY)
            return
        whole = system.torn == 0
        width = 2.4 if len(pairs) < 200 else 1.6
        ends = places[pairs[whole]]
        canvas.segments(ends[:, 0], ends[:, 1], self._colors[whole], width)

    def _strained(self, canvas: Canvas, system: PositionBasedDynamics) -> NDArray[np.uint32]:
        """Colours (m,) of a system's links by their stretch; good until the next call."""
        if len(self._colors) != len(system.links.pairs):
            self._colors = np.zeros(len(system.links.pairs), dtype=np.uint32)
        system.measure()
        strains = system.strains
        if not self.model.parameters.strains:
            strains = np.zeros_like(strains)
        inks = (canvas.ink("text2"), canvas.ink("vermilion"), canvas.ink("chalk"))
        color_by_strain(strains, FULL_STRAIN, *inks, self._colors)
        return self._colors

    def _radii(self) -> Floats:
        """World radius of balls that bounce off each other, 0 for the rest."""
        radii = np.zeros(self.model.system.count)
        if CONTACTS in self.model.active:
            contacts = self.model.system.contacts
            for column in (0, 1):
                np.maximum.at(radii, contacts.pairs[:, column], 0.5 * contacts.rest)
        return radii

    def _draw_particles(self, canvas: Canvas, places: Floats, radii: Floats) -> None:
        count = self.model.system.count
        size = 3.6 if count <= 60 else 2.4 if count <= 250 else 1.6
        weights = self.model.system.own_inverse_masses()
        for i in np.flatnonzero(radii).tolist():
            canvas.circle(tuple(places[i].tolist()), float(radii[i]), "body", 1.0, "text1", 2.0)
        dots = (radii == 0.0) & (weights > 0.0)
        sizes = np.clip(size * np.power(weights[dots], -0.3), 1.4, LARGEST_DOT)
        canvas.discs(places[dots], canvas.px(1.0) * sizes, "text1")

    def _draw_fixed(self, canvas: Canvas, places: Floats) -> None:
        fixed = np.flatnonzero(self.model.system.own_inverse_masses() == 0.0)
        side = canvas.px(3.6 if len(fixed) < 40 else 2.4)
        for i in fixed.tolist():
            if i != self.model.system.held:
                x, y = places[i].tolist()
                corners = [
                    (x - side, y - side),
                    (x + side, y - side),
                    (x + side, y + side),
                    (x - side, y + side),
                ]
                canvas.polygon(np.array(corners), fill="text1")

    def _draw_hand(self, canvas: Canvas, places: Floats) -> None:
        system = self.model.system
        if 0 <= self.hand.chosen < len(places):
            place = tuple(places[self.hand.chosen].tolist())
            canvas.ring(place, 9.0, "amber", 1.8)
        if 0 <= self.hand.first < len(places):
            end = tuple(places[self.hand.first].tolist())
            canvas.ring(end, 12.0, "accent", 1.8)
        words = self.hand.next_click()
        if words and self.hand.pointer is not None:
            canvas.label(self.hand.pointer, words, "accent", 12, anchor="left", offset=(14.0, 18.0))
        if 0 <= system.held < len(places):
            place = tuple(places[system.held].tolist())
            target = tuple(system.hand[2:4].tolist())
            if math.dist(place, target) > canvas.px(12.0):
                canvas.line(place, target, "amber", 1.4, dash=(8.0, 6.0))
            if self.model.parameters.grip > 0.0:
                canvas.circle(place, self.model.parameters.grip, outline="amber", width=1.2, dash=(4.0, 4.0))
            canvas.dot(place, 4.5, "amber")
        if self.hand.knife is not None:
            canvas.ring(self.hand.knife, 6.0, "vermilion", 1.8)
