"""A body that floats: an outline of even density, and ballast."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.solids.mass import Mass, disc_mass, joined, polygon_mass
from game.physics.solids.outlines import clean_outline


class Ballast(NamedTuple):
    """A small disc of lead in the outline's own frame: place and radius m, mass kg for each metre."""

    x: float
    y: float
    radius: float
    mass: float


class Floater(NamedTuple):
    """corners (n, 2) m about the centre of mass, anticlockwise; centre: of mass in the outline's own frame,
    m; area m²; mass kg and inertia kg m² for each metre of length.
    """

    corners: Floats
    centre: tuple[float, float]
    area: float
    mass: float
    inertia: float

    @property
    def reach(self) -> float:
        """m, from the centre of mass to the farthest corner."""
        return float(np.sqrt((self.corners * self.corners).sum(axis=1).max()))


def make_floater(outline: ArrayLike, density: float, ballast: Sequence[Ballast] = ()) -> Floater:
    """Of an outline (n, 2) m with a density kg/m³. ValueError for what is none."""
    corners = clean_outline("outline", outline)
    if not 0.0 < density < math.inf:
        raise ValueError(f"density = {density!r}: expected a number above 0, kg/m³")
    parts = [polygon_mass(corners, density)]
    for one in ballast:
        if not all(map(math.isfinite, one)) or one.mass < 0.0 or one.radius <= 0.0:
            raise ValueError(f"ballast = {one!r}: expected a place, a radius above 0 m and a mass from 0 kg")
        if one.mass > 0.0:
            scale = one.mass / (math.pi * one.radius * one.radius)
            parts.append(disc_mass((one.x, one.y), one.radius, scale))
    whole: Mass = joined(parts)
    about = np.ascontiguousarray(corners - np.array(whole.centre))
    return Floater(about, whole.centre, parts[0].mass / density, whole.mass, whole.inertia)
