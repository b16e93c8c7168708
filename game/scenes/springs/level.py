"""What a level file of the mass-spring scenes may say: particles and links one by one, or whole shapes."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)]
Length = Annotated[float, msgspec.Meta(ge=0.0, le=10_000.0)]
Step = Annotated[float, msgspec.Meta(ge=1e-9, le=1_000.0)]
Mass = Annotated[float, msgspec.Meta(ge=1e-12, le=1e12)]
Count = Annotated[int, msgspec.Meta(ge=2, le=400)]
Index = Annotated[int, msgspec.Meta(ge=0, le=1_000_000)]
Point = tuple[Metre, Metre]

MOST_WRITTEN = 2_000  # particles and links that are written one by one into a file


class ParticleEntry(LevelEntry, frozen=True, kw_only=True):
    """A particle: position m, velocity m/s, inverse mass 1/kg; an inverse mass of 0 fixes it in space."""

    position: Point
    inverse_mass: Annotated[float, msgspec.Meta(ge=0.0, le=1e12)] = 1.0
    velocity: Point = (0.0, 0.0)


class LinkEntry(LevelEntry, frozen=True, kw_only=True):
    """A link or spring between two particles. rest: m, else as long as it is; stiffness: 0 to 1, its own."""

    ends: tuple[Index, Index]
    rest: Length | None = None
    stiffness: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] | None = None


class RopeEntry(LevelEntry, frozen=True, kw_only=True):
    """A row of so many links. pins: "first", "both" or "none"."""

    start: Point
    end: Point
    links: Annotated[int, msgspec.Meta(ge=1, le=399)]
    mass: Mass = 1.0
    end_mass: Mass | None = None
    pins: str = "first"
    slack: Annotated[float, msgspec.Meta(ge=0.1, le=100.0)] = 1.0  # length at rest over the distance


class ClothEntry(LevelEntry, frozen=True, kw_only=True):
    """A net that hangs from its top left corner; see `shapes.cloth`. gather: width at first over its own."""

    corner: Point
    columns: Count
    rows: Count
    spacing: Step
    mass: Mass = 1.0
    pins: str = "row"
    shear: bool = False
    gather: Annotated[float, msgspec.Meta(ge=0.05, le=2.0)] = 1.0


class BlockEntry(LevelEntry, frozen=True, kw_only=True):
    """A jelly, from its bottom left corner."""

    corner: Point
    columns: Count
    rows: Count
    spacing: Step
    mass: Mass = 1.0


class BridgeEntry(LevelEntry, frozen=True, kw_only=True):
    """A rope bridge between pins, with a hand rope above and lamps below. slack: length over the span."""

    start: Point
    end: Point
    planks: Count
    height: Step
    mass: Mass = 1.0
    lamps: Annotated[int, msgspec.Meta(ge=0, le=50)] = 0
    lamp_mass: Mass = 5.0
    slack: Annotated[float, msgspec.Meta(ge=1.0, le=10.0)] = 1.0


class RingEntry(LevelEntry, frozen=True, kw_only=True):
    """A closed skin that keeps the area within, times ``pressure``."""

    centre: Point
    radius: Step
    corners: Annotated[int, msgspec.Meta(ge=3, le=400)]
    mass: Mass = 1.0
    pressure: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 1.0


class CradleEntry(LevelEntry, frozen=True, kw_only=True):
    """Balls side by side on links, the first drawn aside by ``swing`` (degrees)."""

    top: Point
    balls: Count
    spacing: Step
    length: Step
    swing: Annotated[float, msgspec.Meta(ge=-170.0, le=170.0)]


class BesideEntry(LevelEntry, frozen=True, kw_only=True):
    """The same network solved in another way, so far (m) to the right. What is left out is as there."""

    label: Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
    to_the_right: Metre
    model: Literal["pbd", "pbd-even", "xpbd"] | None = None
    substeps: Annotated[int, msgspec.Meta(ge=1, le=200)] | None = None
    iterations: Annotated[int, msgspec.Meta(ge=1, le=500)] | None = None


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -4.8
    bottom: Metre = -0.5
    right: Metre = 4.8
    top: Metre = 4.6


class SpringContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a mass-spring level. Particles are numbered as listed, those of shapes after them.

    areas: outlines of particles that keep their area. reference: exact places, drawn dashed. floor: m.
    walls: m, at the left and the right of the ground. body_distance: m, between particles of different
    bodies, with the effect "contacts"; 0: bodies pass through each other. expected: of readouts. sheet:
    nothing moves while a tool that builds is in the hand. label: of the network, where others are ``beside``.
    pendulum: the second particle is the bob of one on the first, and where it should be now is shown.
    """

    particles: Annotated[tuple[ParticleEntry, ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    links: Annotated[tuple[LinkEntry, ...], msgspec.Meta(max_length=4 * MOST_WRITTEN)] = ()
    areas: Annotated[tuple[tuple[Index, ...], ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    contacts: Annotated[tuple[tuple[Index, Index], ...], msgspec.Meta(max_length=MOST_WRITTEN)] = ()
    ropes: Annotated[tuple[RopeEntry, ...], msgspec.Meta(max_length=50)] = ()
    cloths: Annotated[tuple[ClothEntry, ...], msgspec.Meta(max_length=8)] = ()
    blocks: Annotated[tuple[BlockEntry, ...], msgspec.Meta(max_length=8)] = ()
    bridges: Annotated[tuple[BridgeEntry, ...], msgspec.Meta(max_length=8)] = ()
    rings: Annotated[tuple[RingEntry, ...], msgspec.Meta(max_length=20)] = ()
    cradles: Annotated[tuple[CradleEntry, ...], msgspec.Meta(max_length=8)] = ()
    floor: Metre = 0.0
    walls: tuple[Metre, Metre] | None = None
    body_distance: Length = 0.0
    reference: Annotated[tuple[Point, ...], msgspec.Meta(max_length=1000)] = ()
    expected: Expectations = ()
    sheet: bool = False
    label: Annotated[str, msgspec.Meta(max_length=40)] = ""
    beside: Annotated[tuple[BesideEntry, ...], msgspec.Meta(max_length=4)] = ()
    pendulum: bool = False
    view: View = View()
