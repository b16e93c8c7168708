"""What a level file of C13 may say: spheres one by one, joined to bodies, or in racks, rows and heaps."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.scenes.shared.insets import Zoom
from game.scenes.shared.repeats import Period
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1_000.0, le=1_000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-100_000.0, le=100_000.0)]
Radius = Annotated[float, msgspec.Meta(ge=1e-6, le=1_000.0)]
Mass = Annotated[float, msgspec.Meta(ge=1e-12, le=1e12)]
Count = Annotated[int, msgspec.Meta(ge=1, le=400)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Friction = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
Index = Annotated[int, msgspec.Meta(ge=0, le=100_000)]
Place = Annotated[tuple[Metre, ...], msgspec.Meta(min_length=2, max_length=3)]  # z is 0 if it is not given
FARTHEST = 1e6  # m, m/s, rad/s: what a level keeps of spheres that have flown away
Far = Annotated[float, msgspec.Meta(ge=-FARTHEST, le=FARTHEST)]
Somewhere = Annotated[tuple[Far, ...], msgspec.Meta(min_length=2, max_length=3)]
Word = Annotated[str, msgspec.Meta(min_length=1, max_length=24)]

MOST_SPHERES = 20_000
MOST_WRITTEN = 2_000
WALL = "wall"
COLORS = ("chalk", "pink", "violet", "yellow", "green")  # of materials, in their order


class SphereEntry(LevelEntry, frozen=True, kw_only=True):
    """A sphere: position m, radius m, velocity m/s, turning rad/s, mass kg (else that of the panel).

    fixed: nothing moves it. body: spheres of the same number are one body, which has the velocity of the
    first of them. orientation: a quaternion, scalar first.
    """

    position: Somewhere
    radius: Radius = 0.5
    velocity: Somewhere = (0.0, 0.0)
    turning: tuple[Far, Far, Far] = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] | None = None
    mass: Mass | None = None
    fixed: bool = False
    material: Word | None = None
    body: Index | None = None


class RackEntry(LevelEntry, frozen=True, kw_only=True):
    """A triangle of spheres in contact, pointing to the left. gap: m between them."""

    apex: tuple[Metre, Metre]
    rows: Count
    radius: Radius
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    material: Word | None = None


class CradleEntry(LevelEntry, frozen=True, kw_only=True):
    """A row of spheres on strings, ``drawn`` of them drawn aside by ``swing`` (degrees)."""

    top: tuple[Metre, Metre]
    balls: Count
    radius: Radius
    length: Radius
    swing: Annotated[float, msgspec.Meta(ge=-89.0, le=89.0)] = 40.0
    drawn: Annotated[int, msgspec.Meta(ge=0, le=400)] = 1
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    material: Word | None = None


class HeapEntry(LevelEntry, frozen=True, kw_only=True):
    """Columns and rows of spheres, not quite in order: ``stir`` is a part of the space between them."""

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


class StringEntry(LevelEntry, frozen=True, kw_only=True):
    """A string that holds a sphere (by its number). length: m, else as long as it is."""

    sphere: Index
    tied: Place
    length: Radius | None = None


class PairEntry(LevelEntry, frozen=True, kw_only=True):
    """Restitution and friction between two materials, or a material and "wall"."""

    of: tuple[Word, Word]
    restitution: Share | None = None
    friction: Friction | None = None


class View(LevelEntry, frozen=True, kw_only=True):
    """The window, whose edges are the walls, m."""

    left: Metre = -4.0
    bottom: Metre = 0.0
    right: Metre = 4.0
    top: Metre = 4.5


class CollisionContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. Spheres are numbered as listed, then those of racks, cradles and heaps."""

    spheres: Annotated[tuple[SphereEntry, ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    racks: Annotated[tuple[RackEntry, ...], msgspec.Meta(max_length=10)] = ()
    cradles: Annotated[tuple[CradleEntry, ...], msgspec.Meta(max_length=10)] = ()
    heaps: Annotated[tuple[HeapEntry, ...], msgspec.Meta(max_length=10)] = ()
    strings: Annotated[tuple[StringEntry, ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    ledges: Annotated[tuple[tuple[Metre, Metre, Metre, Metre], ...], msgspec.Meta(max_length=200)] = ()
    materials: Annotated[tuple[Word, ...], msgspec.Meta(max_length=5)] = ()
    pairs: Annotated[tuple[PairEntry, ...], msgspec.Meta(max_length=30)] = ()
    expected: Expectations = ()  # all the time
    repeat: Period = 0.0  # s after which it begins again
    zoom: Zoom | None = None  # what an inset shows
    exact: bool = False  # the event-driven run of smooth spheres is shown beside it
    view: View = View()
