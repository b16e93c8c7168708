"""The spheres that a level of C13 describes, and bodies, tables and surroundings made of them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, linear
from game.physics.spheres.settings import Surroundings, Tables, material_tables, surroundings_of
from game.physics.spheres.spheres import SphereBodies
from game.scenes.spheres.level import MOST_SPHERES, WALL, CollisionContent, CradleEntry, HeapEntry, RackEntry


class Layout(NamedTuple):
    """All spheres of a level, row by row."""

    positions: NDArray[np.float64]  # (s, 3) m
    radii: NDArray[np.float64]  # (s,) m
    velocities: NDArray[np.float64]  # (s, 3) m/s
    turning: NDArray[np.float64]  # (s, 3) rad/s
    orientations: NDArray[np.float64]  # (s, 4)
    masses: NDArray[np.float64]  # (s,) kg; nan where the panel says it
    kinds: NDArray[np.int64]  # (s,)
    owners: NDArray[np.int64]  # (s,) body
    surroundings: Surroundings


class _Row(NamedTuple):
    """A sphere: its place in the plane and radius, m, and its material."""

    x: float
    y: float
    radius: float
    kind: int


def layout_of(content: CollisionContent, seed: int) -> Layout:
    """The spheres that a content describes. ValueError, naming the entry, for what makes no sense."""
    rows, ties = _rows_of(content, seed)
    s = len(rows)
    if not 1 <= s <= MOST_SPHERES:
        raise ValueError(f"spheres: expected 1 to {MOST_SPHERES}, got {s}")
    positions, velocities, turning = np.zeros((s, 3)), np.zeros((s, 3)), np.zeros((s, 3))
    orientations = np.tile((1.0, 0.0, 0.0, 0.0), (s, 1))
    masses, owners = np.full(s, math.nan), np.arange(s)
    positions[:, :2] = [row[:2] for row in rows]
    first = s - sum(heap.columns * heap.rows for heap in content.heaps)
    for heap in content.heaps:
        count = heap.columns * heap.rows
        velocities[first : first + count, :2] = heap.velocity
        first += count
    for i, entry in enumerate(content.spheres):
        positions[i, : len(entry.position)] = entry.position
        velocities[i, : len(entry.velocity)] = entry.velocity
        turning[i] = entry.turning
        if entry.orientation is not None:
            orientations[i] = entry.orientation
        masses[i] = math.inf if entry.fixed else math.nan if entry.mass is None else entry.mass
    _join(content, owners)
    surroundings = _surroundings(content, ties)
    radii = np.array([row.radius for row in rows])
    kinds = np.array([row.kind for row in rows], dtype=np.int64)
    return Layout(positions, radii, velocities, turning, orientations, masses, kinds, owners, surroundings)


def _rows_of(content: CollisionContent, seed: int) -> tuple[list[_Row], list[tuple[float, ...]]]:
    """All spheres in their order; and of each string its sphere, where it is tied (x, y, z), its length."""
    rows = [_listed(content, i) for i in range(len(content.spheres))]
    ties = [_string(content, i) for i in range(len(content.strings))]
    for i, rack in enumerate(content.racks):
        kind = _kind(content, rack.material, f"racks[{i}]")
        rows += [_Row(x, y, rack.radius, kind) for x, y in _rack(rack)]
    for i, cradle in enumerate(content.cradles):
        kind = _kind(content, cradle.material, f"cradles[{i}]")
        for x, y, tie_x in _cradle(cradle):
            ties.append((float(len(rows)), tie_x, cradle.top[1], 0.0, cradle.length))
            rows.append(_Row(x, y, cradle.radius, kind))
    random = np.random.default_rng(seed)
    for i, heap in enumerate(content.heaps):
        if heap.spacing < 2.0 * heap.radius:
            raise ValueError(f"heaps[{i}].spacing: is below two radii")
        rows += _heap(content, heap, random, f"heaps[{i}]")
    return rows, ties


def bodies_of(layout: Layout, real: bool, density: float) -> SphereBodies:
    """Bodies: of mass 1 and inertia 1, or of a density (kg/m³) and solid; masses of their own are kept."""
    volumes = 4.0 / 3.0 * math.pi * (layout.radii * layout.radii * layout.radii)
    usual = density * volumes if real else np.ones(len(layout.radii))
    masses = np.where(np.isnan(layout.masses), usual, layout.masses)
    single = np.array_equal(layout.owners, np.arange(len(layout.owners)))
    _, first = np.unique(layout.owners, return_index=True)
    return SphereBodies(
        layout.positions,
        layout.radii,
        layout.velocities[first],
        layout.turning[first],
        masses=masses,
        inertias="solid" if real else "unit",
        orientations=layout.orientations[first],
        kinds=layout.kinds,
        owners=None if single else layout.owners,
    )


def tables_of(
    content: CollisionContent, restitution: float, friction: float, wall: float, wall_friction: float
) -> Tables:
    """Restitution and friction of all pairs: the panel's, but where the level says otherwise."""
    names = [*(content.materials or ("",)), WALL]
    n = len(names)
    e, mu = np.full((n, n), restitution), np.full((n, n), friction)
    e[-1, :] = e[:, -1] = wall
    mu[-1, :] = mu[:, -1] = wall_friction
    for i, pair in enumerate(content.pairs):
        for name in pair.of:
            if name not in names:
                raise ValueError(f"pairs[{i}].of: no material {name!r}; there are {', '.join(names)}")
        a, b = (names.index(name) for name in pair.of)
        if pair.restitution is not None:
            e[a, b] = e[b, a] = pair.restitution
        if pair.friction is not None:
            mu[a, b] = mu[b, a] = pair.friction
    return material_tables(e, mu, n - 1)


def _kind(content: CollisionContent, name: str | None, where: str) -> int:
    if name is None:
        return 0
    if name not in content.materials:
        known = ", ".join(content.materials) or "none"
        raise ValueError(f"{where}.material: no material {name!r}; there are {known}")
    return content.materials.index(name)


def _listed(content: CollisionContent, i: int) -> _Row:
    entry = content.spheres[i]
    x, y = entry.position[:2]
    return _Row(x, y, entry.radius, _kind(content, entry.material, f"spheres[{i}]"))


def _string(content: CollisionContent, i: int) -> tuple[float, ...]:
    entry = content.strings[i]
    if entry.sphere >= len(content.spheres):
        raise ValueError(f"strings[{i}].sphere: {len(content.spheres)} spheres are listed")
    place = (*content.spheres[entry.sphere].position, 0.0)[:3]
    tied = (*entry.tied, 0.0)[:3]
    length = entry.length if entry.length is not None else elementary.dist(place, tied)
    return float(entry.sphere), *tied, length


def _rack(rack: RackEntry) -> list[tuple[float, float]]:
    step = 2.0 * rack.radius + rack.gap
    return [
        (rack.apex[0] + math.sqrt(0.75) * step * row, rack.apex[1] + step * (i - 0.5 * row))
        for row in range(rack.rows)
        for i in range(row + 1)
    ]


def _cradle(cradle: CradleEntry) -> list[tuple[float, float, float]]:
    """Place of each ball, and x of where its string is tied."""
    step, swing = 2.0 * cradle.radius + cradle.gap, math.radians(cradle.swing)
    found = []
    for i in range(cradle.balls):
        tie = cradle.top[0] + step * i
        aside = swing if i < cradle.drawn else 0.0
        found.append(
            (
                tie - cradle.length * elementary.sin(aside),
                cradle.top[1] - cradle.length * elementary.cos(aside),
                tie,
            )
        )
    return found


def _heap(content: CollisionContent, heap: HeapEntry, random: np.random.Generator, where: str) -> list[_Row]:
    space = 0.5 * heap.stir * (heap.spacing - 2.0 * heap.radius)
    kind = _kind(content, heap.material, where)
    layers = [_kind(content, name, f"{where}.layers") for name in heap.layers]
    found = []
    for row in range(heap.rows):
        here = layers[row * len(layers) // heap.rows] if layers else kind
        for column in range(heap.columns):
            x = heap.corner[0] + heap.spacing * (column + 0.5) + space * linear.uniform(random, -1.0, 1.0)
            y = heap.corner[1] + heap.spacing * (row + 0.5) + space * linear.uniform(random, -1.0, 1.0)
            radius = heap.radius * (1.0 - heap.odd * linear.uniform(random))
            found.append(_Row(x, y, radius, here))
    return found


def _join(content: CollisionContent, owners: NDArray[np.int64]) -> None:
    """Bodies of the spheres that share a number, in the order of their first spheres."""
    heads: dict[int, int] = {}
    for i, entry in enumerate(content.spheres):
        if entry.body is not None:
            if entry.fixed:
                raise ValueError(f"spheres[{i}].fixed: one that is joined to a body cannot be fixed")
            owners[i] = heads.setdefault(entry.body, i)
    _, owners[:] = np.unique(owners, return_inverse=True)


def _surroundings(content: CollisionContent, ties: list[tuple[float, ...]]) -> Surroundings:
    view = content.view
    return surroundings_of(
        (view.left, view.bottom, view.right, view.top),
        content.ledges,
        [int(tie[0]) for tie in ties],
        [tie[1:] for tie in ties],
    )
