"""Shapes as a person gives them: discs, capsules, polygons, chains of segments; checked, and made into parts.

Coordinates are in the body's frame, SI. A part is what kernels know: corners, rounding radius, kind.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.physics.solids.arrays.state import DISC, POLYGON, SEGMENT
from game.physics.solids.mass import Mass, joined, rounded_mass
from game.physics.solids.outlines import (
    LARGEST,
    checked_points,
    clean_outline,
    convex_parts,
    without_doubles,
)


@dataclass(frozen=True, slots=True)
class Material:
    """density kg/m², friction (of a pair: the geometric mean), restitution 0 to 1 (of a pair: the larger).

    category and mask, bits: two shapes meet if each one's category is in the other's mask. ValueError.
    """

    density: float = 1.0
    friction: float = 0.6
    restitution: float = 0.0
    category: int = 1
    mask: int = 2**63 - 1

    def __post_init__(self) -> None:
        for name, least, most in (("density", 0.0, 1e12), ("friction", 0.0, 1e9), ("restitution", 0.0, 1.0)):
            value = getattr(self, name)
            if not least <= value <= most or (name == "density" and value == 0.0):
                raise ValueError(
                    f"{name} = {value!r}: expected {'above ' * (name == 'density')}{least:g} to {most:g}"
                )
        for name in ("category", "mask"):
            bits = getattr(self, name)
            if isinstance(bits, bool) or not isinstance(bits, int) or not 0 <= bits < 2**63:
                raise ValueError(f"{name} = {bits!r}: expected bits, 0 to 2**63 - 1")


PLAIN = Material()


class Part(NamedTuple):
    """kind, corners (k, 2) m in the body's frame, rounding radius m, and its mass."""

    kind: int
    corners: Floats
    radius: float
    mass: Mass


def checked_number(name: str, value: float, least: float, most: float, above: bool = False) -> float:
    """A number from least to most (above: not least itself), or ValueError."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} = {value!r}: expected a number") from None
    if not least <= number <= most or (above and number == least):
        raise ValueError(
            f"{name} = {value!r}: expected a number {'above' if above else 'from'} {least:g} to {most:g}"
        )
    return number


def checked_pair(name: str, value: ArrayLike, most: float = LARGEST) -> tuple[float, float]:
    """Two finite numbers, or ValueError."""
    try:
        x, y = (float(part) for part in np.asarray(value, dtype=np.float64).tolist())
    except (TypeError, ValueError):
        raise ValueError(f"{name} = {value!r}: expected two numbers") from None
    if not (abs(x) <= most and abs(y) <= most):
        raise ValueError(f"{name} = {value!r}: expected two finite numbers up to {most:g}")
    return x, y


@dataclass(frozen=True, slots=True)
class Disc:
    """radius m, about a centre m."""

    radius: float
    centre: tuple[float, float] = (0.0, 0.0)
    material: Material = PLAIN

    def parts(self) -> list[Part]:
        """One. ValueError for nonsense."""
        r = checked_number("radius", self.radius, 0.0, LARGEST, above=True)
        corners = np.array([checked_pair("centre", self.centre)])
        return [Part(DISC, corners, r, rounded_mass(corners, r, self.material.density))]


@dataclass(frozen=True, slots=True)
class Capsule:
    """All within radius m of the segment from start to end, m."""

    start: tuple[float, float]
    end: tuple[float, float]
    radius: float
    material: Material = PLAIN

    def parts(self) -> list[Part]:
        """One; a disc if both ends are one point. ValueError for nonsense."""
        r = checked_number("radius", self.radius, 0.0, LARGEST, above=True)
        corners = np.array([checked_pair("start", self.start), checked_pair("end", self.end)])
        if not elementary.dist(corners[0], corners[1]) > 1e-9 * r:
            return Disc(r, (float(corners[0, 0]), float(corners[0, 1])), self.material).parts()
        return [Part(POLYGON, corners, r, rounded_mass(corners, r, self.material.density))]


@dataclass(frozen=True, slots=True)
class Polygon:
    """A simple outline (n, 2) m, grown by ``rounding`` m; a concave one becomes a compound of convex
    parts.
    """

    corners: ArrayLike = field(compare=False)
    rounding: float = 0.0
    material: Material = PLAIN

    def parts(self) -> list[Part]:
        """Convex ones. ValueError for nonsense."""
        r = checked_number("rounding", self.rounding, 0.0, LARGEST)
        convex = convex_parts(clean_outline("corners", self.corners))
        return [Part(POLYGON, part, r, rounded_mass(part, r, self.material.density)) for part in convex]


@dataclass(frozen=True, slots=True)
class Chain:
    """Segments through points (n, 2) m, for ground and tracks: met only from the left of their direction.

    closed: the last point is joined to the first. What slides over it does not notice where segments meet.
    """

    points: ArrayLike = field(compare=False)
    closed: bool = False
    material: Material = PLAIN

    def parts(self) -> list[Part]:
        """One for each segment: ghost before, both ends, ghost after. ValueError for nonsense."""
        points = without_doubles(checked_points("points", self.points, 2), self.closed)
        if len(points) < (3 if self.closed else 2):
            raise ValueError("points: fewer than two different points" if not self.closed else
                             "points: a closed chain has at least three different points")  # fmt: skip
        if self.closed:
            around = np.concatenate([points[-1:], points, points[:2]])
        else:  # ghosts on the ends themselves: nothing follows there
            around = np.concatenate([points[:1], points, points[-1:]])
        none = Mass(0.0, (0.0, 0.0), 0.0)
        return [Part(SEGMENT, around[k : k + 4].copy(), 0.0, none) for k in range(len(around) - 3)]


Shape = Disc | Capsule | Polygon | Chain


def box(width: float, height: float, rounding: float = 0.0, material: Material = PLAIN) -> Polygon:
    """A rectangle about the origin of so many m, rounding included. ValueError for nonsense."""
    x = 0.5 * checked_number("width", width, 0.0, LARGEST, above=True) - rounding
    y = 0.5 * checked_number("height", height, 0.0, LARGEST, above=True) - rounding
    if not (x > 0.0 and y > 0.0):
        raise ValueError(f"rounding = {rounding!r}: expected less than half of width and height")
    return Polygon([(-x, -y), (x, -y), (x, y), (-x, y)], rounding, material)


def parts_mass(parts: list[Part]) -> Mass:
    """Of all parts of a body together."""
    return joined([part.mass for part in parts if part.mass.mass > 0.0])


def outward_normals(kind: int, corners: Floats) -> Floats:
    """Unit normal of the edge that begins at each corner (k, 2); a disc's is zero."""
    if len(corners) == 1:
        return np.zeros((1, 2))
    edges = np.roll(corners, -1, axis=0) - corners
    if kind == SEGMENT:  # solid on its right: normals look to the left
        edges = -edges
    lengths = elementwise.hypot(edges[:, 0], edges[:, 1])[:, None]
    return np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.where(lengths > 0.0, lengths, 1.0)
