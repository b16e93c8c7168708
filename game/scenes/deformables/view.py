"""How soft bodies, their cells and the hash table are drawn."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.constraints import PositionState
from game.physics.deformables.hashing import FIRST_PRIME, SECOND_PRIME, WORD
from game.scenes.deformables.level import HEIGHT, WIDTH
from game.scenes.deformables.model import DeformablesModel
from game.ui.canvas.canvas import Canvas

BODY_COLORS = ("chalk", "green", "violet", "pink", "yellow")
MOST_EDGES, MOST_ARROWS = 8_000, 400  # drawn one by one
MOST_CELLS = 40_000  # drawn as a picture
FULL_CELL, FULL_SLOT = 4.0, 6.0  # vertices, drawn in the last colour and at full height
STRIP_LOW, STRIP_HIGH, BARS = -0.17, -0.05, 320  # m, m, most bars of the strip
LOADS = ((0.0, "stage"), (0.25, "body"), (1.0, "chalk"))
SLOTS = ((0.0, "stage"), (0.02, "violet"), (0.5, "chalk"), (1.0, "green"))


class DeformablesView:
    """Draws a model."""

    def __init__(self, model: DeformablesModel):
        self.model = model

    def draw(self, canvas: Canvas, previous: PositionState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state before to now."""
        bodies, chosen = self.model.bodies, self.model.parameters
        points = bodies.points
        if previous is not None and previous.fields.shape == bodies.system.fields.shape:
            before = previous.fields[:2, : len(points)].T
            points = before + alpha * (points - before)
        if chosen.view != "meshes":
            self._draw_cells(canvas, points)
        half = 0.5 * WIDTH
        canvas.polyline(
            ((-half, 2.0 * HEIGHT), (-half, 0.0), (half, 0.0), (half, 2.0 * HEIGHT)), "line2", 2.0
        )
        self._draw_meshes(canvas, points)
        if chosen.contacts:
            self._draw_contacts(canvas, points)
        if chosen.strip:
            self._draw_strip(canvas)

    def _draw_meshes(self, canvas: Canvas, points: Floats) -> None:
        store = self.model.bodies.store
        veil = 0.45 if self.model.parameters.view == "meshes" else 0.15
        for loop, mesh in zip(store.loops, store.loop_mesh, strict=True):
            color = BODY_COLORS[mesh % len(BODY_COLORS)]
            canvas.polygon(points[loop], fill=color, fill_alpha=veil)
        edges = store.topology.edges
        if len(edges) <= MOST_EDGES:
            canvas.segments(points[edges[:, 0]], points[edges[:, 1]], "text2", 0.8, alpha=0.5)
        rim = edges[store.topology.rim]
        canvas.segments(points[rim[:, 0]], points[rim[:, 1]], "text1", 1.3)
        fixed = np.flatnonzero(self.model.bodies.system.own_inverse_masses() == 0.0)
        canvas.particles(points[fixed], "text1", 2.2)

    def _draw_contacts(self, canvas: Canvas, points: Floats) -> None:
        """Crossing edges, vertices inside, and their ways out, as deep as they are."""
        store, collider = self.model.bodies.store, self.model.bodies.collider
        pairs = self.model.crossings
        edges = store.topology.edges[np.unique(pairs)]
        canvas.segments(points[edges[:, 0]], points[edges[:, 1]], "amber", 1.6, alpha=0.8)
        inside = np.flatnonzero(collider.inside)
        canvas.particles(points[inside], "text1", 4.6)
        canvas.particles(points[inside], "vermilion", 3.0)
        if len(inside) <= MOST_ARROWS:
            depth, out_x, out_y = collider.depths[:3]
            for v in inside.tolist():
                canvas.arrow(points[v], (depth[v] * out_x[v], depth[v] * out_y[v]), "vermilion", width=1.6)

    def _draw_cells(self, canvas: Canvas, points: Floats) -> None:
        """The cells in view by how many vertices they have, or by their slots."""
        size = self.model.bodies.collider.cell_size
        low = np.floor(np.array((self.model.middle - 0.5 * WIDTH, 0.0)) / size).astype(np.int64)
        high = np.floor(np.array((self.model.middle + 0.5 * WIDTH, HEIGHT)) / size).astype(np.int64)
        columns, rows = (high - low + 1).tolist()
        if columns * rows > MOST_CELLS:
            return
        where = np.floor(points / size).astype(np.int64) - low
        seen = ((where >= 0) & (where < (columns, rows))).all(axis=1)
        counts = np.bincount(where[seen, 1] * columns + where[seen, 0], minlength=columns * rows)
        picture = counts.reshape(rows, columns) / FULL_CELL
        stops: tuple[tuple[float, str], ...] = LOADS
        if self.model.parameters.view == "table":
            i, j = np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1)[:, None]
            slots = (((i * FIRST_PRIME) ^ (j * SECOND_PRIME)) & WORD) % len(self.model.bodies.collider.slots)
            picture = np.where(
                picture > 0.0, 0.05 + 0.95 * slots / len(self.model.bodies.collider.slots), 0.0
            )
            stops = SLOTS
        sharp = 8 if columns * rows < 10_000 else 3
        lines = np.repeat(np.repeat(picture, sharp, axis=0), sharp, axis=1)  # cells with edges, not a blur
        canvas.field(lines, low * size, (high + 1) * size, stops)
        if columns * rows <= 4_000:
            x, y = np.arange(low[0], high[0] + 2) * size, np.arange(low[1], high[1] + 2) * size
            foot, head = np.full(len(x), y[0]), np.full(len(x), y[-1])
            canvas.segments(np.stack([x, foot], 1), np.stack([x, head], 1), "line2", 0.7, alpha=0.6)
            left, right = np.full(len(y), x[0]), np.full(len(y), x[-1])
            canvas.segments(np.stack([left, y], 1), np.stack([right, y], 1), "line2", 0.7, alpha=0.6)

    def _draw_strip(self, canvas: Canvas) -> None:
        """The slots from left to right: a bar each, or the longest of some, as high as its chain."""
        self.model.bodies.detect()
        loads = self.model.bodies.collider.loads
        bars = min(len(loads), BARS)
        first = np.arange(bars) * len(loads) // bars
        highest = np.maximum.reduceat(loads, first)
        width = WIDTH / bars
        start = self.model.middle - 0.5 * WIDTH
        left = start + width * np.arange(bars)
        canvas.polygon(
            ((start, STRIP_LOW), (start + WIDTH, STRIP_LOW), (start + WIDTH, STRIP_HIGH),
             (start, STRIP_HIGH)), fill="body", fill_alpha=0.6,
        )  # fmt: skip
        tall = (STRIP_HIGH - STRIP_LOW) * np.minimum(highest / FULL_SLOT, 1.0)
        for color, some in (("chalk", highest <= FULL_SLOT), ("vermilion", highest > FULL_SLOT)):
            for k in np.flatnonzero(some & (highest > 0)).tolist():
                x, y = left[k] + 0.08 * width, STRIP_LOW + tall[k]
                end = x + 0.84 * width
                canvas.polygon(((x, STRIP_LOW), (end, STRIP_LOW), (end, y), (x, y)), fill=color)
        words = (
            f"{len(loads)} slots, {int(np.count_nonzero(loads))} in use, longest {int(loads.max(initial=0))}"
        )
        canvas.label((start, STRIP_LOW), words, "text2", 12, anchor="topleft", offset=(0.0, 3.0))
