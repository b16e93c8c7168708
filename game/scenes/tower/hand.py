"""The hand at the tower: cuts columns, breaks floors, while it runs."""

from __future__ import annotations

import numpy as np

from game.scenes.tower import tables
from game.scenes.tower.model import TowerModel
from game.stage import Part, Pointer

REACH = 0.4  # m beside something, within which the pointer takes it
FARTHEST = 1e4  # m
NOBODY = -1


class TowerHand(Part):
    """Takes the pointer."""

    def __init__(self, model: TowerModel):
        self.model = model

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        if event.kind != "down" or event.button not in (1, 3):
            return ""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        breaking = event.button == 3 or self.model.parameters.tool == "break"
        row = self.part_at(point, (tables.SLAB, tables.SHARD) if breaking else (tables.COLUMN,))
        if row == NOBODY:
            return "There is no floor there." if breaking else "There is no column there."
        if breaking:
            self.model.break_floor(row)
        else:
            self.model.cut(row)
        return ""

    def part_at(self, point: tuple[float, float], kinds: tuple[int, ...]) -> int:
        """Row of the part of these kinds at a point, or NOBODY."""
        parts, bodies = self.model.parts, self.model.world.bodies
        there = np.flatnonzero((parts[:, tables.BODY] >= 0.0) & np.isin(parts[:, tables.KIND], kinds))
        if not len(there):
            return NOBODY
        own = parts[there, tables.BODY].astype(np.int64)
        away = np.array(point) - bodies.positions[own]
        c, s = bodies.rotations[own, 0], bodies.rotations[own, 1]
        across = np.abs(c * away[:, 0] + s * away[:, 1]) - 0.5 * parts[there, tables.WIDE]
        along = np.abs(c * away[:, 1] - s * away[:, 0]) - 0.5 * parts[there, tables.TALL]
        outside = np.maximum(across, along)
        best = int(np.argmin(outside))
        return int(there[best]) if outside[best] <= REACH else NOBODY
