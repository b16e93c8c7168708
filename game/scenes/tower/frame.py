"""What the tower is made of, as tables: which parts there are, which of them break, and into what."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np

from game.arrays import Floats, Longs, Point
from game.scenes.tower.breaking import break_up, grind, middle_of, shocks_of
from game.scenes.tower.building import (
    COLUMN,
    GONE,
    NOT_YET,
    RUBBLE,
    SHARD,
    SLAB,
    StoreyTable,
    build,
    frame_stuff,
    rubble_stuff,
)
from game.scenes.tower.level import TowerContent
from game.scenes.tower.parameters import TowerParameters
from game.worlds.members.solids import Solids, nearest_box
from game.worlds.tables import extended
from game.worlds.world import Member

MOST_BODIES = 1_500
LEAST_LONG = 1.0  # m: shorter shards do not break any more
LASTING = 1.5  # of what a strike may take from a body that bears it: what a stop of `STOP_S` may
MOST_GROUND = 0.2  # of what it comes from may become dust at once
FLOORS = (SLAB, SHARD)


class Frame(Member):
    """``parts`` and ``storeys``; built_mass: kg, of all parts at first."""

    kept = ("parts", "storeys")

    def __init__(self, solids: Solids, content: TowerContent, parameters: TowerParameters):
        self.solids, self.world, self.parameters = solids, solids.world, parameters
        self.parts = build(self.world, content, parameters.friction, parameters.joints)
        self.storeys = StoreyTable(*np.full((2, content.storeys), NOT_YET))
        self.built_mass = float(self.parts.mass.sum())

    # -- what there is --------------------------------------------------------------------------------

    def rows(self, kinds: Collection[int] = (), storeys: Collection[int] = ()) -> Longs:
        """Rows of the parts that are there: of these kinds, and of these storeys; of all without any."""
        parts = self.parts
        there = parts.body != GONE
        for column, chosen in ((parts.kind, kinds), (parts.storey, storeys)):
            if chosen:
                there &= np.isin(column, tuple(chosen))
        return np.flatnonzero(there)

    def bodies(self, kinds: Collection[int] = (), storeys: Collection[int] = ()) -> Longs:
        """Bodies of the parts that `rows` gives."""
        return self.parts.body[self.rows(kinds, storeys)]

    def nearest(self, point: Point, kinds: Collection[int], reach: float) -> int:
        """Row of the part of these kinds at a point (m), or no farther than ``reach`` m from it; or -1."""
        there = self.rows(kinds)
        sizes = np.stack([self.parts.wide[there], self.parts.tall[there]], axis=1)
        best, outside = nearest_box(self.world, self.parts.body[there], sizes, point)
        return int(there[best]) if outside <= reach else -1

    def corners(self, row: int) -> Floats:
        """Corners (k, 2) m of a part in its body's frame."""
        shapes = self.world.shapes
        shape = int(self.world.shapes_of(int(self.parts.body[row]))[0])
        start, count = int(shapes.starts[shape]), int(shapes.counts[shape])
        return self.world.pool.corners[start : start + count].copy()

    # -- what breaks ----------------------------------------------------------------------------------

    def replace(self, row: int, pieces: list[Floats], kind: int, thrown: Floats) -> Longs:
        """Pieces in the place of a part: their rows, or its own where there are too many bodies."""
        parts, stuff = self.parts, rubble_stuff if kind == RUBBLE else frame_stuff
        if len(self.world.ids()) + len(pieces) > MOST_BODIES:
            return np.array([row])
        density = float(parts.mass[row]) / sum(middle_of(corners)[2] for corners in pieces)
        material = stuff(self.parameters.friction, density)
        made = break_up(self.world, int(parts.body[row]), pieces, material, thrown)
        parts.body[row], parts.mass[row] = GONE, 0.0
        self.parts = extended(
            parts, ((new, kind, parts.storey[row], parts.place[row], w, h, m, 0.0) for new, m, w, h in made)
        )
        return np.arange(len(parts.body), len(self.parts.body))

    def ground_to_dust(self, rows: Longs, most: float) -> float:
        """Take mass from parts, by the share of each: at most ``most`` kg. How many kg it was."""
        kilograms = min(most, MOST_GROUND * float(self.parts.mass[rows].sum()))
        self.parts.mass[rows] = grind(self.world, self.parts.body[rows], kilograms)
        return kilograms

    def stopped(self, before: Floats, dt: float) -> list[tuple[int, float]]:
        """Rows of what is stopped faster than it bears, and what it has lost, m/s: floors and columns that
        ride on what falls. before (n, 2): velocities m/s at the beginning of the step of dt (s).
        """
        parts, there = self.parts, self.rows((SLAB, COLUMN, SHARD))
        there = there[parts.body[there] < len(before)]
        own = parts.body[there]
        parts.shock[there] = shocks_of(parts.shock[there], before[own], self.world.bodies.velocities[own], dt)
        breaks = there[(parts.shock[there] > LASTING * self.parameters.strength) & self._is_long(there)]
        return [(row, float(parts.shock[row])) for row in breaks.tolist()]

    def struck(self, bodies: Longs, impulses: Floats) -> list[int]:
        """Rows of floors that strikes (k,) N s on pairs (k, 2) of bodies stop faster than they bear."""
        rows, parts = self.rows_of(bodies).ravel(), self.parts
        impulses = np.repeat(impulses, 2)
        mine = (rows >= 0) & np.isin(parts.kind[rows], FLOORS) & self._is_long(rows)
        lost = impulses[mine] / parts.mass[rows[mine]]
        return np.unique(rows[mine][lost > self.parameters.strength]).tolist()

    def rows_of(self, bodies: Longs) -> Longs:
        """Rows of the parts that these bodies are; -1 for others."""
        row_of = np.full(len(self.world.bodies.flags), -1)
        row_of[self.bodies()] = self.rows()
        return row_of[bodies]

    def _is_long(self, rows: Longs) -> Any:
        return np.maximum(self.parts.wide[rows], self.parts.tall[rows]) > 2.0 * LEAST_LONG

    # -- as a member ----------------------------------------------------------------------------------

    def change(self, name: str) -> None:
        if name == "friction":
            self.solids.set_frictions(self.bodies(), self.parameters.friction)
