"""What a level file of C13 may say: spheres one by one, joined to bodies, or in racks, rows and heaps."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.physics.rigid.collision_settings import Surroundings, Tables, material_tables, surroundings_of
from game.physics.rigid.spheres import SphereBodies

Metre = Annotated[float, msgspec.Meta(ge=-1_000.0, le=1_000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-100_000.0, le=100_000.0)]
Radius = Annotated[float, msgspec.Meta(ge=1e-6, le=1_000.0)]
Mass = Annotated[float, msgspec.Meta(gt=0.0, le=1e12)]
Count = Annotated[int, msgspec.Meta(ge=1, le=400)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Friction = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
Index = Annotated[int, msgspec.Meta(ge=0, le=100_000)]
Place = Annotated[tuple[Metre, ...], msgspec.Meta(min_length=2, max_length=3)]  # z is 0 if it is not given
Motion = Annotated[tuple[Speed, ...], msgspec.Meta(min_length=2, max_length=3)]
Word = Annotated[str, msgspec.Meta(min_length=1, max_length=24)]

MOST_SPHERES = 20_000
MOST_WRITTEN = 2_000
WALL = "wall"
COLORS = ("chalk", "pink", "violet", "yellow", "green")  # of materials, in their order


class _Entry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True, omit_defaults=True):
    pass


class SphereEntry(_Entry, frozen=True, kw_only=True):
    """A sphere: position m, radius m, velocity m/s, turning rad/s, mass kg (else that of the panel).

    fixed: nothing moves it. body: spheres of the same number are one body, which has the velocity of the
    first of them. orientation: a quaternion, scalar first.
    """

    position: Place
    radius: Radius = 0.5
    velocity: Motion = (0.0, 0.0)
    turning: tuple[Speed, Speed, Speed] = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] | None = None
    mass: Mass | None = None
    fixed: bool = False
    material: Word | None = None
    body: Index | None = None


class RackEntry(_Entry, frozen=True, kw_only=True):
    """A triangle of spheres that touch, pointing to the left. gap: m between them."""

    apex: tuple[Metre, Metre]
    rows: Count
    radius: Radius
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    material: Word | None = None


class CradleEntry(_Entry, frozen=True, kw_only=True):
    """A row of spheres on strings, ``drawn`` of them drawn aside by ``swing`` (degrees)."""

    top: tuple[Metre, Metre]
    balls: Count
    radius: Radius
    length: Radius
    swing: Annotated[float, msgspec.Meta(ge=-89.0, le=89.0)] = 40.0
    drawn: Annotated[int, msgspec.Meta(ge=0, le=400)] = 1
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    material: Word | None = None


class HeapEntry(_Entry, frozen=True, kw_only=True):
    """Columns and rows of spheres, not quite in order: ``stir`` is a part of the room between them."""

    corner: tuple[Metre, Metre]
    columns: Count
    rows: Count
    radius: Radius
    spacing: Radius
    stir: Share = 0.8
    odd: Share = 0.0  # spread of radii: from (1 - odd) to 1 times the radius
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    material: Word | None = None
    layers: tuple[Word, ...] = ()  # materials of its layers, from below


class StringEntry(_Entry, frozen=True, kw_only=True):
    """A string that holds a sphere (by its number). length: m, else as long as it is."""

    sphere: Index
    tied: Place
    length: Radius | None = None


class PairEntry(_Entry, frozen=True, kw_only=True):
    """Restitution and friction between two materials, or a material and "wall"."""

    of: tuple[Word, Word]
    restitution: Share | None = None
    friction: Friction | None = None


class View(_Entry, frozen=True, kw_only=True):
    """The window, whose edges are the walls, m."""

    left: Metre = -4.0
    bottom: Metre = 0.0
    right: Metre = 4.0
    top: Metre = 4.5


class CollisionContent(_Entry, frozen=True, kw_only=True):
    """[content] of a level. Spheres are numbered as listed, then those of racks, cradles and heaps."""

    spheres: Annotated[tuple[SphereEntry, ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    racks: Annotated[tuple[RackEntry, ...], msgspec.Meta(max_length=10)] = ()
    cradles: Annotated[tuple[CradleEntry, ...], msgspec.Meta(max_length=10)] = ()
    heaps: Annotated[tuple[HeapEntry, ...], msgspec.Meta(max_length=10)] = ()
    strings: Annotated[tuple[StringEntry, ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    ledges: Annotated[tuple[tuple[Metre, Metre, Metre, Metre], ...], msgspec.Meta(max_length=200)] = ()
    materials: Annotated[tuple[Word, ...], msgspec.Meta(max_length=5)] = ()
    pairs: Annotated[tuple[PairEntry, ...], msgspec.Meta(max_length=30)] = ()
    exact: bool = False  # the event-driven run of smooth spheres is shown beside it
    view: View = View()


class Makings(NamedTuple):
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


def makings_of(content: CollisionContent, seed: int) -> Makings:
    """The spheres that a content describes. ValueError, naming the entry, for what makes no sense."""
    rows = [_listed(content, i) for i in range(len(content.spheres))]
    ties = [_string(content, i) for i in range(len(content.strings))]
    for i, rack in enumerate(content.racks):
        rows += [(*place, rack.radius, _kind(content, rack.material, f"racks[{i}]")) for place in _rack(rack)]
    for i, cradle in enumerate(content.cradles):
        kind = _kind(content, cradle.material, f"cradles[{i}]")
        for x, y, tie_x in _cradle(cradle):
            ties.append((float(len(rows)), tie_x, cradle.top[1], 0.0, cradle.length))
            rows.append((x, y, cradle.radius, kind))
    random = np.random.default_rng(seed)
    for i, heap in enumerate(content.heaps):
        if heap.spacing < 2.0 * heap.radius:
            raise ValueError(f"heaps[{i}].spacing: is below two radii")
        rows += _heap(content, heap, random, f"heaps[{i}]")
    if not 1 <= len(rows) <= MOST_SPHERES:
        raise ValueError(f"spheres: 1 to {MOST_SPHERES} are wanted, not {len(rows)}")
    s = len(rows)
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
    surroundings = _surroundings(content, ties, s)
    radii = np.array([row[2] for row in rows])
    kinds = np.array([row[3] for row in rows], dtype=np.int64)
    return Makings(positions, radii, velocities, turning, orientations, masses, kinds, owners, surroundings)


def bodies_of(makings: Makings, real: bool, density: float) -> SphereBodies:
    """Bodies: of mass 1 and inertia 1, or of a density (kg/m³) and solid; masses of their own are kept."""
    volumes = 4.0 / 3.0 * math.pi * makings.radii**3
    usual = density * volumes if real else np.ones(len(makings.radii))
    masses = np.where(np.isnan(makings.masses), usual, makings.masses)
    single = np.array_equal(makings.owners, np.arange(len(makings.owners)))
    _, first = np.unique(makings.owners, return_index=True)
    return SphereBodies(
        makings.positions,
        makings.radii,
        makings.velocities[first],
        makings.turning[first],
        masses=masses,
        inertias="solid" if real else "unit",
        orientations=makings.orientations[first],
        kinds=makings.kinds,
        owners=None if single else makings.owners,
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


def _listed(content: CollisionContent, i: int) -> tuple[float, float, float, int]:
    entry = content.spheres[i]
    x, y = entry.position[:2]
    return x, y, entry.radius, _kind(content, entry.material, f"spheres[{i}]")


def _string(content: CollisionContent, i: int) -> tuple[float, ...]:
    entry = content.strings[i]
    if entry.sphere >= len(content.spheres):
        raise ValueError(f"strings[{i}].sphere: {len(content.spheres)} spheres are listed")
    place = (*content.spheres[entry.sphere].position, 0.0)[:3]
    tied = (*entry.tied, 0.0)[:3]
    length = entry.length if entry.length is not None else math.dist(place, tied)
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
            (tie - cradle.length * math.sin(aside), cradle.top[1] - cradle.length * math.cos(aside), tie)
        )
    return found


def _heap(
    content: CollisionContent, heap: HeapEntry, random: np.random.Generator, where: str
) -> list[tuple[float, float, float, int]]:
    room = 0.5 * heap.stir * (heap.spacing - 2.0 * heap.radius)
    kind = _kind(content, heap.material, where)
    layers = [_kind(content, name, f"{where}.layers") for name in heap.layers]
    found = []
    for row in range(heap.rows):
        here = layers[row * len(layers) // heap.rows] if layers else kind
        for column in range(heap.columns):
            x = heap.corner[0] + heap.spacing * (column + 0.5) + room * random.uniform(-1.0, 1.0)
            y = heap.corner[1] + heap.spacing * (row + 0.5) + room * random.uniform(-1.0, 1.0)
            radius = heap.radius * (1.0 - heap.odd * random.uniform())
            found.append((x, y, radius, here))
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


def _surroundings(content: CollisionContent, ties: list[tuple[float, ...]], count: int) -> Surroundings:
    view = content.view
    return surroundings_of(
        (view.left, view.bottom, view.right, view.top),
        content.ledges,
        [int(tie[0]) for tie in ties],
        [tie[1:] for tie in ties],
    )
