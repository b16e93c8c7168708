"""A computer player walks round the table while it thinks: where along the edge it stands with its cue.

It goes to where it would stand for the stroke that looks likeliest, and once it has decided, for that one. It
is a picture of thinking and no part of the state.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.table.table import Table
from game.physics.kernels import elementary
from game.scenes.shared.tables.view import draw_stick
from game.ui.canvas.canvas import Canvas

PACE = 2.6  # m/s along the edge: a brisk walk, seen at a table's length
BESIDE = 0.10  # m from the cushion's nose, on the rail
NEAR = 0.02  # m; so near it has arrived
REACH = 0.22  # m of the cue that are seen over the rail

Point = tuple[float, float]


class Edge(NamedTuple):
    """The line along which a player walks: a rectangle round the bed. width, length of the bed, m."""

    width: float
    length: float

    @property
    def sides(self) -> tuple[float, float]:
        """Across and along the table, m."""
        return self.width + 2.0 * BESIDE, self.length + 2.0 * BESIDE

    @property
    def around(self) -> float:
        """All the way round, m."""
        return 2.0 * sum(self.sides)

    def place(self, way: float) -> Point:
        """The point that lies so far along the edge, m, from the lower left corner against the clock."""
        across, along = self.sides
        way %= self.around
        if way < across:
            return way - BESIDE, -BESIDE
        way -= across
        if way < along:
            return self.width + BESIDE, way - BESIDE
        way -= along
        if way < across:
            return self.width + BESIDE - way, self.length + BESIDE
        return -BESIDE, self.length + BESIDE - (way - across)

    def stance(self, ball: Point, azimuth: float) -> float:
        """How far along the edge one stands to strike a ball (x, y) m in a direction, rad."""
        across, along = self.sides
        x, y = ball[0] + BESIDE, ball[1] + BESIDE
        back = (-elementary.cos(azimuth), -elementary.sin(azimuth))
        far_x = math.inf if abs(back[0]) < 1e-12 else ((across if back[0] > 0.0 else 0.0) - x) / back[0]
        far_y = math.inf if abs(back[1]) < 1e-12 else ((along if back[1] > 0.0 else 0.0) - y) / back[1]
        if far_y <= far_x:
            at = min(max(x + far_y * back[0], 0.0), across)
            return at if back[1] < 0.0 else across + along + (across - at)
        at = min(max(y + far_x * back[1], 0.0), along)
        return across + at if back[0] > 0.0 else 2.0 * across + along + (along - at)


class Walk:
    """Where a player stands along the edge, m, and where it goes; None before the first way."""

    def __init__(self) -> None:
        self.way: float | None = None
        self._rest_s = 0.0

    def go(self, edge: Edge, target: float, rest_s: float) -> bool:
        """Go on towards a place along the edge, the shorter way; True once it is reached.

        rest_s: time of rest of the game, s. When it begins anew a new way begins from where one stands.
        """
        elapsed = max(rest_s - self._rest_s, 0.0) if rest_s >= self._rest_s else rest_s
        self._rest_s = rest_s
        if self.way is None:
            self.way = (target + 0.25 * edge.around) % edge.around
        left = math.remainder(target - self.way, edge.around)
        step = min(abs(left), PACE * elapsed)
        self.way = (self.way + math.copysign(step, left)) % edge.around
        return abs(left) - step <= NEAR


def draw_walk(canvas: Canvas, table: Table, walk: Walk) -> None:
    """The cue of a player that walks: over the edge, towards the middle of the table."""
    if walk.way is None:
        return
    edge = Edge(table.width, table.length)
    x, y = edge.place(walk.way)
    dx, dy = 0.5 * table.width - x, 0.5 * table.length - y
    far = elementary.hypot(dx, dy)
    along = (dx / far, dy / far)
    reach = REACH * min(table.width, 1.0)
    draw_stick(canvas, table, (x + reach * along[0], y + reach * along[1]), along)
