"""The dam: one body until a rocket strikes; then pieces, which the blast throws and the water takes along."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.kernels import elementary, elementwise, linear
from game.physics.solids import Material, Polygon
from game.physics.solids.arrays.state import DYNAMIC
from game.physics.solids.mass import polygon_mass
from game.worlds.members.solids import Solids
from game.worlds.shards import shards_of
from game.worlds.world import Member

HIGH, CREST, FOOT = 12.0, 1.2, 3.2  # m: height, widths at the top and the bottom
CONCRETE = Material(2400.0, 0.7, 0.05)
OUTLINE = np.array([(0.0, 0.0), (FOOT, 0.0), (CREST, HIGH), (0.0, HIGH)])
SITES = 600  # places at random, of which those are taken that lie far enough from each other
FINE = 0.7  # pieces within the breach are so much smaller
STRENGTH, TAMPING, METRIC = 0.54, 1.0, 16.02  # K of thick concrete, C in water; kg/m³ in 1 lb/ft³
BLAST, FALLS = 5760.0, 0.89  # N s/m² for kg^(1/3), at 1 m for each; power of the distance (Cole 1948)
NEAREST, THIN = 1.5, 0.4  # m: no piece feels it from nearer; side of a square than which none is smaller
SPLIT = 0.03  # of a block's size, by which it is smaller than its place: blocks do not press from the start


def thickness(height: float) -> float:
    """m, of the dam so high (m) above its foot."""
    return FOOT - (FOOT - CREST) * min(max(height / HIGH, 0.0), 1.0)


def breach_radius(charge: float) -> float:
    """m of concrete that a charge (kg of TNT) breaks: (P / (K C))^(1/3) (US Army FM 5-250, 1992)."""
    return elementary.cbrt(charge / (METRIC * STRENGTH * TAMPING))


def specific_impulse(charge: float, distance: float) -> float:
    """N s/m² of a charge (kg of TNT) that explodes in water so far (m) away: B w (w / r)^0.89, where w is the
    cube root of the charge (Cole 1948, Underwater Explosions).
    """
    root = elementary.cbrt(charge)
    return BLAST * root * elementary.pow(root / max(distance, NEAREST), FALLS)


class Dam(Member):
    """``bodies`` (n,) of all pieces, or the one dam; ``homes`` (n, 2) m, where they were.

    struck (k, 3): where rockets exploded at it, m, and their charges, kg.
    """

    kept = ("bodies", "homes", "struck")

    def __init__(self, solids: Solids, block: float, seed: int):
        self.solids, self.block, self.seed = solids, block, seed
        middle = np.array(polygon_mass(OUTLINE).centre)
        whole = solids.world.add_body(Polygon(OUTLINE - middle, material=CONCRETE), middle, kind="fixed")
        self.bodies: Longs = np.array([whole])
        self.homes: Floats = middle[None]
        self.struck: Floats = np.zeros((0, 3))

    @property
    def broken(self) -> bool:
        """Whether a rocket has struck it."""
        return len(self.struck) > 0

    def explode(self, at: Point, charge: float, vanishes: bool, level: float) -> None:
        """A charge (kg of TNT) at a place (m) breaks the dam, and throws what is under water.

        level: m, of the water.
        """
        world = self.solids.world
        if not self.broken:
            world.remove_body(int(self.bodies[0]))
            shards = [] if vanishes else self._shards(at, breach_radius(charge))
            middles = [np.array(polygon_mass(shard).centre) for shard in shards]
            self.bodies = np.array(
                [
                    world.add_body(
                        Polygon((shard - middle) * (1.0 - SPLIT), material=CONCRETE), middle, kind="fixed"
                    )
                    for shard, middle in zip(shards, middles, strict=True)
                ],
                dtype=np.int64,
            )
            self.homes = np.array(middles).reshape(-1, 2)
        self.struck = np.concatenate([self.struck, [(*at, charge)]])
        self._throw(at, charge, level)

    def _shards(self, at: Point, breach: float) -> list[Floats]:
        """Corners (m, 2) m of each piece that the dam breaks into."""
        return shards_of(OUTLINE, self._sites(at, breach), THIN * THIN)

    def _sites(self, at: Point, breach: float) -> Floats:
        """One (n, 2) m in each piece; they lie closer near the blast."""
        random = np.random.default_rng((self.seed, 13))
        low, high = OUTLINE.min(axis=0), OUTLINE.max(axis=0)
        places = low + linear.uniform(random, 0.0, 1.0, (SITES, 2)) * (high - low)
        away = elementwise.hypot(*(places - at).T)
        gaps = self.block * np.where(away < breach, FINE, 1.0)
        kept = np.zeros((0, 2))
        for site, gap in zip(places, gaps.tolist(), strict=True):
            apart = ((kept - site) * (kept - site)).sum(axis=1)
            if not len(kept) or float(apart.min()) > gap * gap:
                kept = np.concatenate([kept, site[None]])
        return kept

    def _throw(self, at: Point, charge: float, level: float) -> None:
        """Free what breaks and what stood on it; push away what the water's shock reaches."""
        world, rows = self.solids.world, self.solids.world.bodies
        radius = breach_radius(charge)
        through = radius >= thickness(at[1])
        for body in self.bodies.tolist():
            away = rows.positions[body] - at
            far = elementary.hypot(*away.tolist())
            if far > radius and not (through and away[1] > 0.0):
                continue
            world.set_kind(body, "dynamic")
            if rows.positions[body, 1] < level:
                breadth = math.sqrt(1.0 / (float(rows.inverse_masses[body]) * CONCRETE.density))
                push = specific_impulse(charge, far) * breadth
                x, y = rows.positions[body].tolist()
                world.push(body, (x, y), push / max(far, 1e-9) * away)

    def free(self) -> Longs:
        """Pieces that nothing holds."""
        return np.asarray(self.bodies[self.solids.world.bodies.flags[self.bodies] & DYNAMIC != 0])

    def moved(self) -> Floats:
        """m (n,) that pieces are away from where they were."""
        away = self.solids.world.bodies.positions[self.bodies] - self.homes
        return np.asarray(elementwise.hypot(away[:, 0], away[:, 1]))
