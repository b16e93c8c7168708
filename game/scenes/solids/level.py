"""What a level of solids may say: bodies and joints one by one, or whole structures, and what is measured."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1e6, le=1e6)]
Length = Annotated[float, msgspec.Meta(ge=1e-6, le=1e5)]
Rate = Annotated[float, msgspec.Meta(ge=-1e5, le=1e5)]
Amount = Annotated[float, msgspec.Meta(ge=0.0, le=1e12)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Moment = Annotated[float, msgspec.Meta(ge=0.0, le=1e6)]
Load = Annotated[float, msgspec.Meta(gt=0.0, le=1e12)]
Index = Annotated[int, msgspec.Meta(ge=-1, le=100_000)]
Count = Annotated[int, msgspec.Meta(ge=1, le=400)]
Point = tuple[Metre, Metre]
Points = Annotated[tuple[Point, ...], msgspec.Meta(max_length=400)]
Colour = Literal[
    "plain", "wood", "stone", "steel", "chalk", "green", "vermilion", "pink", "violet", "yellow", "brass"
]
COLOURS: tuple[Colour, ...] = get_args(Colour)
MOST_BODIES, MOST_JOINTS = 12_000, 12_000
GROUND = -1  # stands for what never moves, in joints


class ShapeEntry(LevelEntry, frozen=True, kw_only=True):
    """One of disc (radius), box (width, height), polygon, capsule (both ends; radius), chain; m.

    at, angle (degrees): of discs and boxes in the frame of the body.
    """

    disc: Length | None = None
    box: tuple[Length, Length] | None = None
    polygon: Points | None = None
    capsule: tuple[Point, Point] | None = None
    chain: Points | None = None
    radius: Annotated[float, msgspec.Meta(ge=0.0, le=1e5)] = 0.0
    at: Point = (0.0, 0.0)
    angle: Rate = 0.0
    closed: bool = False


class MaterialEntry(LevelEntry, frozen=True, kw_only=True):
    """density kg/m²; friction and restitution: None, as the parameters say."""

    density: Annotated[float, msgspec.Meta(ge=1e-6, le=1e9)] = 1.0
    friction: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] | None = None
    restitution: Share | None = None
    colour: Colour = "plain"


class SwingEntry(LevelEntry, frozen=True, kw_only=True):
    """A key-framed body moves by amplitude (m) times sin(rate t + phase); rate rad/s, phase degrees."""

    amplitude: Point
    rate: Rate
    phase: Rate = 0.0


class BodyEntry(MaterialEntry, frozen=True, kw_only=True):
    """A body. angle: degrees. gone_at: s, when it is taken away; free_at: s, when a key-framed one becomes
    dynamic; 0: never. ghost: it touches nothing.
    """

    shapes: Annotated[tuple[ShapeEntry, ...], msgspec.Meta(min_length=1, max_length=400)]
    position: Point = (0.0, 0.0)
    angle: Rate = 0.0
    velocity: tuple[Rate, Rate] = (0.0, 0.0)
    spin: Rate = 0.0
    kind: Literal["dynamic", "fixed", "key-framed"] = "dynamic"
    gravity_scale: Rate = 1.0
    swing: SwingEntry | None = None
    gone_at: Moment = 0.0
    free_at: Moment = 0.0
    ghost: bool = False


class JointEntry(LevelEntry, frozen=True, kw_only=True):
    """A joint of two bodies, by their numbers (-1: the ground), at points of the world, m; None: no limit.

    axis: of a slider, in the world. limits: rad of a pin or motor, from how the bodies stand; m of others.
    """

    kind: Literal["pin", "slider", "weld", "distance", "rope", "spring", "motor"]
    bodies: tuple[Index, Index]
    at: Point
    other: Point | None = None
    axis: Point = (1.0, 0.0)
    length: Annotated[float, msgspec.Meta(ge=0.0, le=1e5)] | None = None
    limits: tuple[Rate, Rate] | None = None
    hertz: Annotated[float, msgspec.Meta(ge=0.0, le=1e4)] = 0.0
    damping: Annotated[float, msgspec.Meta(ge=0.0, le=1e3)] = 1.0
    speed: Rate = 0.0
    most: Amount | None = None
    break_force: Load | None = None
    break_torque: Load | None = None
    colliding: bool = False


class StackEntry(MaterialEntry, frozen=True, kw_only=True):
    """Boxes from the middle of the bottom upwards. count: of a column, or rows of a pyramid or wall;
    overlap: part of a box that is in its neighbours.
    """

    form: Literal["column", "pyramid", "wall"] = "column"
    at: Point
    count: Count
    across: Count = 1
    size: tuple[Length, Length] = (1.0, 1.0)
    overlap: Annotated[float, msgspec.Meta(ge=0.0, le=0.9)] = 0.0


class BeamEntry(MaterialEntry, frozen=True, kw_only=True):
    """Equal blocks end to end from ``at``, in a direction (degrees): welded, or loose or fixed side by side.

    size: along, across, m. held: how the start hangs on the ground. spin rad/s about the start. break_force
    N, break_torque N m: of each weld, and of what holds the start.
    """

    at: Point
    count: Count
    size: tuple[Length, Length]
    direction: Rate = 0.0
    form: Literal["welded", "loose", "fixed"] = "welded"
    held: Literal["none", "weld", "pin"] = "none"
    spin: Rate = 0.0
    break_force: Load | None = None
    break_torque: Load | None = None


class TrussEntry(MaterialEntry, frozen=True, kw_only=True):
    """A Warren truss from its left support: bars pinned to knots, which are discs.

    Knots first, the lower ones before the upper ones; then bars: lower, upper, diagonal. Joints: both
    supports, then two of each bar. panel, height, thickness: m. break_force N: of each pin of a bar.
    """

    at: Point
    panels: Annotated[int, msgspec.Meta(ge=2, le=40)]
    panel: Length
    height: Length
    thickness: Length = 0.12
    break_force: Load | None = None


class EscapementEntry(MaterialEntry, frozen=True, kw_only=True):
    """An escape wheel about ``at``, the anchor above it, and a pendulum that hangs from the anchor.

    radius m, of the tips of the teeth; torque N m, of the spring; pendulum m, from the pivot to the bob; bob:
    its radius m; weight kg/m² of the bob; swing: degrees, at the beginning.
    """

    at: Point
    teeth: Annotated[int, msgspec.Meta(ge=9, le=40)] = 15
    radius: Length = 1.0
    torque: Amount = 0.6
    pendulum: Length = 4.0
    bob: Length = 0.35
    weight: Load = 8.0
    swing: Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)] = 6.0


class ArchEntry(MaterialEntry, frozen=True, kw_only=True):
    """A semicircular arch of straight voussoirs; thickness m; radius m, of the middle line."""

    at: Point
    radius: Length
    thickness: Length
    blocks: Annotated[int, msgspec.Meta(ge=3, le=200)]


class DominoEntry(MaterialEntry, frozen=True, kw_only=True):
    """A row to the right. size: width, height; gap m between faces; push: spin (rad/s) of the first."""

    at: Point
    count: Count
    size: tuple[Length, Length]
    gap: Length
    push: Rate = 0.0


class CardEntry(MaterialEntry, frozen=True, kw_only=True):
    """A house of cards: storeys of leaning pairs, lean in degrees from upright, flat cards between."""

    at: Point
    storeys: Annotated[int, msgspec.Meta(ge=1, le=12)]
    length: Length = 1.0
    thickness: Length = 0.02
    lean: Annotated[float, msgspec.Meta(gt=0.0, lt=80.0)] = 22.0


class CradleEntry(MaterialEntry, frozen=True, kw_only=True):
    """Balls side by side on rods; the first ``lifted`` are drawn aside by ``swing`` degrees."""

    at: Point
    balls: Annotated[int, msgspec.Meta(ge=1, le=50)]
    ball: Length
    length: Length
    swing: Annotated[float, msgspec.Meta(ge=-150.0, le=150.0)] = 40.0
    lifted: Annotated[int, msgspec.Meta(ge=0, le=50)] = 1
    gap: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 0.0


class LinksEntry(MaterialEntry, frozen=True, kw_only=True):
    """Capsules pinned end to end. held: which ends hang on the ground; load: kg of a disc at the last."""

    start: Point
    end: Point
    links: Count
    radius: Length = 0.05
    held: Literal["none", "first", "both"] = "both"
    load: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 0.0
    load_radius: Length = 0.5


class PegEntry(MaterialEntry, frozen=True, kw_only=True):
    """Fixed discs in rows, each second row shifted by half; from the middle of the top row downwards."""

    at: Point
    rows: Count
    columns: Count
    spacing: Length
    radius: Length


class HeapEntry(MaterialEntry, frozen=True, kw_only=True):
    """Bodies by chance within a box, none deeper in another than the room lets them; by the level's seed."""

    low: Point
    high: Point
    count: Annotated[int, msgspec.Meta(ge=1, le=2_000)]
    size: tuple[Length, Length] = (0.2, 0.2)
    form: Literal["disc", "box", "mixed"] = "disc"


class GaugeEntry(LevelEntry, frozen=True, kw_only=True):
    """A measured number with a name. until: s, the time from which it stays as it is; 0: never.

    right, up, way (m), turn (degrees): since the beginning; speed, spin; sink: -up; force (N), moment (N m):
    of a joint; passed: bodies right of x = ``level``; fallen: bodies of structures below y = ``level``, none
    that the level says one by one; when: s, at which a body first had moved by ``level`` m; between: s, from
    then until ``other`` had; period: s, between the last two times that it turned through ``level`` degrees,
    anticlockwise; highest: of all bodies; broken: joints. The largest since the beginning: fastest (m/s) of
    all bodies; gap (m) between the points of a pin, motor or weld.
    """

    name: Annotated[str, msgspec.Meta(min_length=1, max_length=40)]
    measure: Literal[
        "right", "up", "sink", "way", "turn", "speed", "spin", "force", "moment", "passed", "fallen", "when",
        "between", "period", "highest", "broken", "fastest", "gap",
    ]  # fmt: skip
    of: Annotated[int, msgspec.Meta(ge=0, le=100_000)] = 0
    other: Annotated[int, msgspec.Meta(ge=0, le=100_000)] = 0
    until: Moment = 0.0
    level: Metre = 0.0


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -8.0
    bottom: Metre = -1.0
    right: Metre = 8.0
    top: Metre = 8.0


Few = msgspec.Meta(max_length=60)


class SolidContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of solids.

    Bodies are numbered as they are listed, those of structures after them, in the order of the fields here.
    floor: m, height of the ground without end, or none. walls: m, at its left and right. drag 1/s.
    """

    bodies: Annotated[tuple[BodyEntry, ...], msgspec.Meta(max_length=MOST_BODIES)] = ()
    stacks: Annotated[tuple[StackEntry, ...], Few] = ()
    beams: Annotated[tuple[BeamEntry, ...], Few] = ()
    trusses: Annotated[tuple[TrussEntry, ...], Few] = ()
    escapements: Annotated[tuple[EscapementEntry, ...], Few] = ()
    arches: Annotated[tuple[ArchEntry, ...], Few] = ()
    dominoes: Annotated[tuple[DominoEntry, ...], Few] = ()
    cards: Annotated[tuple[CardEntry, ...], Few] = ()
    cradles: Annotated[tuple[CradleEntry, ...], Few] = ()
    links: Annotated[tuple[LinksEntry, ...], Few] = ()
    pegs: Annotated[tuple[PegEntry, ...], Few] = ()
    heaps: Annotated[tuple[HeapEntry, ...], Few] = ()
    joints: Annotated[tuple[JointEntry, ...], msgspec.Meta(max_length=MOST_JOINTS)] = ()
    gauges: Annotated[tuple[GaugeEntry, ...], msgspec.Meta(max_length=12)] = ()
    floor: Metre | None = 0.0
    walls: tuple[Metre, Metre] | None = None
    floor_friction: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] | None = None
    expected: Expectations = ()
    view: View = View()
