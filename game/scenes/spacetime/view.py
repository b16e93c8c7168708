"""How bodies, their circles, their horns and the queue are drawn."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.spacetime import motion
from game.physics.spacetime.motion import pair_time
from game.physics.spacetime.refine import PAIR, A, B
from game.physics.spacetime.tree import RADIUS, tree_of
from game.physics.spacetime.world import TimedState
from game.scenes.spacetime.model import HALF, SpaceTimeModel
from game.ui.canvas.canvas import Canvas

INKS = ("chalk", "green", "violet", "pink")
HORN_STEPS, HORN_LONGEST = 10, 1.2  # circles of a horn, s that it is drawn for at most
LINES = 9  # of the queue
AT = (HALF[0] + 0.25, HALF[1] - 0.1)  # m, where the queue begins
LINE = 0.30  # m from line to line


class SpaceTimeView:
    """Draws a model."""

    def __init__(self, model: SpaceTimeModel):
        self.model = model

    def draw(self, canvas: Canvas, previous: TimedState | None, alpha: float, held: tuple[int, float, float],
             dt: float) -> None:  # fmt: skip
        """All of it, ``alpha`` of the way from the state before to now."""
        world, chosen = self.model.world, self.model.parameters
        (left, low), (right, high) = (-HALF[0], -HALF[1]), HALF
        canvas.polygon(np.array(((left, low), (right, low), (right, high), (left, high))), outline="line2")
        pair = self.model.chosen()
        if chosen.horns and world.count > 1:
            self._draw_horns(canvas, pair)
        fields = world.fields
        before = previous.fields if previous is not None and previous.fields.shape == fields.shape else fields
        fields = before + alpha * (fields - before)
        for i, body in enumerate(world.bodies):
            ink = INKS[("star", "comb", "letter", "coast").index(body.kind)]
            outline = "amber" if i == held[0] else "text1" if i in pair else ink
            corners = self._turned(tree_of(body.kind, body.variant).outline * body.size, fields[:, i])
            canvas.polygon(corners, fill=ink, fill_alpha=0.35, outline=outline, width=2.0)
        if chosen.circles == "reached":
            self._draw_left(canvas, dt)
        elif chosen.circles == "tree" and world.count > 1:
            self._draw_pair(canvas, pair)
        for name, i in zip("12", pair, strict=True):
            canvas.label(
                (float(fields[motion.X, i]), float(fields[motion.Y, i])),
                name,
                "text1",
                14,
                "semibold",
                clear=False,
            )
        if held[0] >= 0:
            start = (float(fields[motion.X, held[0]]), float(fields[motion.Y, held[0]]))
            canvas.line(start, held[1:], "amber", 1.6, dash=(5.0, 4.0))
            canvas.contact(held[1:])
        if chosen.queue:
            self._draw_queue(canvas)

    def _turned(self, corners: Floats, field: Floats) -> Floats:
        c, s = math.cos(field[2]), math.sin(field[2])
        return np.asarray(corners @ np.array(((c, s), (-s, c))) + field[:2])

    def _circles(self, canvas: Canvas, nodes: list[tuple[int, int]], color: str) -> None:
        """Circles of (body, node), each once."""
        world = self.model.world
        for body, node in sorted(set(nodes)):
            x, y, radius = world.forest.nodes[node, : RADIUS + 1].tolist()
            px, py, c, s = world.poses[body].tolist()
            canvas.circle((px + c * x - s * y, py + s * x + c * y), radius, color, 0.10, color, 1.2)

    def _draw_left(self, canvas: Canvas, dt: float) -> None:
        """What the next step's budget leaves of the pairs that are due."""
        pairs, left = self.model.world.near_nodes(int(self.model.parameters.budget), dt)
        nodes = [(int(pairs[row[PAIR], side]), int(row[A + side])) for row in left for side in (0, 1)]
        self._circles(canvas, nodes, "vermilion")

    def _draw_pair(self, canvas: Canvas, pair: tuple[int, int]) -> None:
        _, left = self.model.world.ask(*pair, int(self.model.parameters.budget))
        nodes = [(pair[0], int(row[A])) for row in left] + [(pair[1], int(row[B])) for row in left]
        self._circles(canvas, nodes, "vermilion")

    def _draw_horns(self, canvas: Canvas, pair: tuple[int, int]) -> None:
        """Where each of the two may be, up to when they may touch."""
        world, bound = self.model.world, self.model.world.laws.bound
        until = min(float(pair_time(world.fields, world.makes, *pair, 0.0, bound)), HORN_LONGEST)
        for i in pair:
            x, y = world.fields[motion.X, i], world.fields[motion.Y, i]
            vx, vy = world.fields[motion.VX : motion.VX + 2, i]
            for t in np.linspace(0.0, until, HORN_STEPS).tolist():
                center = (float(x + vx * t), float(y + vy * t))
                radius = float(world.makes[i, motion.SIZE] + 0.5 * bound * t * t)
                last = t == until
                canvas.circle(center, radius, None, 0.0, "yellow", 1.6 if last else 0.8,
                              alpha=0.9 if last else 0.35)  # fmt: skip
            canvas.line((float(x), float(y)), (float(x + vx * until), float(y + vy * until)), "yellow", 1.4)

    def _draw_queue(self, canvas: Canvas) -> None:
        """The soonest of the queue, line by line."""
        canvas.label(AT, "May touch in", "text1", 13, "semibold", "left")
        for line, (ahead, i, j) in enumerate(self.model.world.queue()[:LINES]):
            at = (AT[0], AT[1] - LINE * (line + 1))
            words = "now" if ahead <= 0.0 else f"{1e3 * ahead:.0f} ms"
            canvas.label(at, f"{i + 1} and {j + 1}", "text2", 12, anchor="left")
            canvas.label(
                (AT[0] + 1.35, at[1]), words, "amber" if ahead <= 0.0 else "text1", 12, anchor="right"
            )
