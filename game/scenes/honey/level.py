"""What a level of liquids may say. Lengths in m."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry, Metre, Point, View
from game.worlds.expectations import Expectations

Look = Literal["water", "honey", "slime", "oil", "wax", "lamp", "steam", "air", "milk", "tar"]
Size = Annotated[float, msgspec.Meta(ge=0.002, le=10.0)]
Amount = Annotated[float, msgspec.Meta(ge=0.0, le=1e6)]
Kelvin = Annotated[float, msgspec.Meta(gt=0.0, le=5000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]
Number = Annotated[int, msgspec.Meta(ge=0, le=15)]


class LiquidEntry(LevelEntry, frozen=True, kw_only=True):
    """A kind, as `game.physics.particle_fluids.Liquid`; boils: K, 0 for never; vapour: another's number."""

    look: Look = "water"
    density: Annotated[float, msgspec.Meta(ge=0.01, le=1e5)] = 1000.0
    viscosity: Amount = 0.05
    tension: Amount = 0.0
    swelling: Annotated[float, msgspec.Meta(ge=-0.1, le=0.1)] = 0.0
    boils: Annotated[float, msgspec.Meta(ge=0.0, le=5000.0)] = 0.0
    latent: Amount = 0.0
    vapour: Annotated[int, msgspec.Meta(ge=-1, le=15)] = -1
    springy: bool = False
    air: bool = False


class PoolEntry(LevelEntry, frozen=True, kw_only=True):
    """Liquid that fills a rectangle, or a disc in it; speed m/s, heat K."""

    left: Metre
    bottom: Metre
    right: Metre
    top: Metre
    round: bool = False
    kind: Number = 0
    speed: tuple[Speed, Speed] = (0.0, 0.0)
    heat: Kelvin = 293.15


class HeaterEntry(LevelEntry, frozen=True, kw_only=True):
    """A rectangle that warms or cools what is in it towards a temperature (K), at a rate (1/s)."""

    left: Metre
    bottom: Metre
    right: Metre
    top: Metre
    heat: Kelvin = 350.0
    rate: Amount = 1.0


class TapEntry(LevelEntry, frozen=True, kw_only=True):
    """Liquid of a kind that runs down from a place, so wide, so fast (m/s), until ``most`` particles have."""

    at: Point
    width: Size = 0.1
    speed: Annotated[float, msgspec.Meta(gt=0.0, le=20.0)] = 1.0
    kind: Number = 0
    most: Annotated[int, msgspec.Meta(ge=0, le=20_000)] = 1000


class HoneyContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. vessel: loops of corners, the outline first; spacing of particles at rest."""

    spacing: Size = 0.025
    liquids: Annotated[tuple[LiquidEntry, ...], msgspec.Meta(min_length=1, max_length=8)] = (LiquidEntry(),)
    vessel: Annotated[tuple[tuple[Point, ...], ...], msgspec.Meta(max_length=20)] = (
        ((-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)),
    )
    pools: Annotated[tuple[PoolEntry, ...], msgspec.Meta(max_length=200)] = ()
    heaters: Annotated[tuple[HeaterEntry, ...], msgspec.Meta(max_length=20)] = ()
    taps: Annotated[tuple[TapEntry, ...], msgspec.Meta(max_length=8)] = ()
    expected: Expectations = ()
    view: View = View(left=-1.6, bottom=-0.15, right=1.6, top=1.65)


DEFAULT = HoneyContent(pools=(PoolEntry(left=-1.0, bottom=0.0, right=0.0, top=0.8),))
