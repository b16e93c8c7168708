"""Structures with joints that machines are made of: beams, trusses, escapements."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from game.physics.kernels import elementary
from game.scenes.solids.level import (
    GROUND,
    BeamEntry,
    BodyEntry,
    EscapementEntry,
    JointEntry,
    MaterialEntry,
    Point,
    ShapeEntry,
    TrussEntry,
)

SPAN = 3.5  # pitches of the teeth between the two pallets of an anchor
LIFT, LOCK = 6.0, 2.0  # degrees: of the pallet while a tooth pushes it, and of its face that holds the tooth
REST = 20.0  # degrees of a pallet behind its edge
DROP = 0.06  # of the wheel's radius: how far a tooth that was let go falls
ROOT, HUB = 0.70, 0.74  # of the wheel's radius: feet of the teeth, and the disc that they stand on


class Made(NamedTuple):
    """Bodies in their order, and joints by their numbers."""

    bodies: list[BodyEntry]
    joints: list[JointEntry]


def material_of(entry: MaterialEntry) -> dict[str, Any]:
    """What a structure says of each of its bodies."""
    return {name: getattr(entry, name) for name in ("density", "friction", "restitution", "colour")}


def _at(centre: Point, radius: float, angle: float) -> Point:
    return centre[0] + radius * elementary.cos(angle), centre[1] + radius * elementary.sin(angle)


# -- beams --------------------------------------------------------------------------------------------


def add_beam(entry: BeamEntry, made: Made) -> None:
    """Blocks end to end; they turn about the start as one where there is a spin."""
    turn, (length, _) = math.radians(entry.direction), entry.size
    breaking: dict[str, Any] = {"break_force": entry.break_force, "break_torque": entry.break_torque}
    for k in range(entry.count):
        number, arm = len(made.bodies), (k + 0.5) * length
        speed = entry.spin * arm
        made.bodies.append(
            BodyEntry(
                shapes=(ShapeEntry(box=entry.size),),
                position=_at(entry.at, arm, turn),
                angle=entry.direction,
                velocity=(-speed * elementary.sin(turn), speed * elementary.cos(turn)),
                spin=entry.spin,
                kind="fixed" if entry.form == "fixed" else "dynamic",
                **material_of(entry),
            )
        )
        place = _at(entry.at, k * length, turn)
        if k == 0 and entry.held != "none":
            made.joints.append(JointEntry(kind=entry.held, bodies=(GROUND, number), at=place, **breaking))
        elif k and entry.form == "welded":
            made.joints.append(JointEntry(kind="weld", bodies=(number - 1, number), at=place, **breaking))


# -- trusses ------------------------------------------------------------------------------------------


def add_truss(entry: TrussEntry, made: Made) -> None:
    """Its left support is pinned, the right one slides: so statics alone says what each bar carries."""
    (x, y), n, first = entry.at, entry.panels, len(made.bodies)
    lower = [(x + entry.panel * k, y) for k in range(n + 1)]
    upper = [(x + entry.panel * (k + 0.5), y + entry.height) for k in range(n)]
    knots = lower + upper
    for place in knots:
        shape = ShapeEntry(disc=0.6 * entry.thickness)
        made.bodies.append(BodyEntry(shapes=(shape,), position=place, **material_of(entry)))
    made.joints.append(JointEntry(kind="pin", bodies=(GROUND, first), at=lower[0]))
    made.joints.append(JointEntry(kind="slider", bodies=(GROUND, first + n), at=lower[n]))
    bars = [(k, k + 1) for k in range(n)]
    bars += [(n + 1 + k, n + 2 + k) for k in range(n - 1)]
    bars += [pair for k in range(n) for pair in ((k, n + 1 + k), (n + 1 + k, k + 1))]
    for a, b in bars:
        _add_bar(entry, made, (first + a, first + b), (knots[a], knots[b]))


def _add_bar(entry: TrussEntry, made: Made, ends: tuple[int, int], places: tuple[Point, Point]) -> None:
    """A bar between two knots; it ends short of them, so that bars do not touch each other."""
    (x0, y0), (x1, y1) = places
    length = elementary.dist(*places) - 2.4 * entry.thickness
    if not length > 0.0:
        raise ValueError("trusses: the bars are shorter than they are thick")
    number = len(made.bodies)
    made.bodies.append(
        BodyEntry(
            shapes=(ShapeEntry(box=(length, entry.thickness)),),
            position=(0.5 * (x0 + x1), 0.5 * (y0 + y1)),
            angle=math.degrees(elementary.atan2(y1 - y0, x1 - x0)),
            **material_of(entry),
        )
    )
    for knot, place in zip(ends, places, strict=True):
        made.joints.append(
            JointEntry(kind="pin", bodies=(knot, number), at=place, break_force=entry.break_force)
        )


# -- escapements --------------------------------------------------------------------------------------


def add_escapement(entry: EscapementEntry, made: Made) -> None:
    """Graham's dead-beat escapement of 1715: faces that hold a tooth are arcs about the anchor's pivot."""
    half = SPAN * math.pi / entry.teeth
    pivot = entry.at[0], entry.at[1] + entry.radius / elementary.cos(half)
    reach = entry.radius * elementary.tan(half)  # of the anchor: its arms are tangents to the wheel
    turn, wheel = math.radians(entry.swing), len(made.bodies)
    own = material_of(entry)
    made.bodies.append(BodyEntry(shapes=_wheel(entry, half), position=entry.at, **{**own, "colour": "brass"}))
    made.bodies.append(
        BodyEntry(shapes=_anchor(entry, half, reach), position=pivot, angle=entry.swing, **own)
    )
    rod = 0.02 * entry.pendulum
    bob = _at(pivot, entry.pendulum, turn - 0.5 * math.pi)
    made.bodies.append(
        BodyEntry(
            shapes=(ShapeEntry(box=(rod, entry.pendulum - entry.bob), at=(0.0, 0.5 * entry.bob)),),
            position=_at(pivot, 0.5 * entry.pendulum, turn - 0.5 * math.pi),
            angle=entry.swing, ghost=True, **own,
        )
    )  # fmt: skip
    made.bodies.append(
        BodyEntry(
            shapes=(ShapeEntry(disc=entry.bob),), position=bob, angle=entry.swing, ghost=True,
            **{**own, "density": entry.weight, "colour": "brass"},
        )
    )  # fmt: skip
    made.joints.append(
        JointEntry(kind="motor", bodies=(GROUND, wheel), at=entry.at, speed=-50.0, most=entry.torque)
    )
    made.joints.append(JointEntry(kind="pin", bodies=(GROUND, wheel + 1), at=pivot))
    made.joints.append(JointEntry(kind="weld", bodies=(wheel + 1, wheel + 2), at=pivot))
    made.joints.append(JointEntry(kind="weld", bodies=(wheel + 2, wheel + 3), at=bob))


def _wheel(entry: EscapementEntry, half: float) -> tuple[ShapeEntry, ...]:
    """Pointed teeth that lean forward, so that a face is touched by the tip alone. It turns clockwise."""
    shapes, r, o = [ShapeEntry(disc=HUB * entry.radius)], entry.radius, (0.0, 0.0)
    wide = 15.0 / entry.teeth
    for k in range(entry.teeth):
        tip = 0.5 * math.pi + half + math.tau * k / entry.teeth
        corners = (
            _at(o, r, tip), _at(o, r, tip + 0.012 * wide),
            _at(o, ROOT * r, tip + 0.20 * wide), _at(o, ROOT * r, tip + 0.05 * wide),
        )  # fmt: skip
        shapes.append(ShapeEntry(polygon=corners))
    return tuple(shapes)


def _anchor(entry: EscapementEntry, half: float, reach: float) -> tuple[ShapeEntry, ...]:
    """Two pallets and their arms, about the pivot. A tooth that slides over the slanted end of a pallet lifts
    it by LIFT. By then the other pallet is LOCK deep between the teeth.
    """
    wide = entry.radius * math.pi / entry.teeth - DROP * entry.radius
    edge = math.radians(0.5 * (LOCK - LIFT))
    end, back, o = edge + math.radians(LIFT), -math.radians(REST), (0.0, 0.0)
    shapes = []
    for side, over in ((1.0, -wide), (-1.0, wide)):  # the entry's tooth is held outside, the exit's inside
        arm = -0.5 * math.pi - side * (0.5 * math.pi - half)
        corners = [
            _at(o, reach, arm + side * back), _at(o, reach, arm + side * 0.5 * back),
            _at(o, reach, arm + side * edge), _at(o, reach + over, arm + side * end),
            _at(o, reach + over, arm + side * 0.5 * back), _at(o, reach + over, arm + side * back),
        ]  # fmt: skip
        inner = 4 if over < 0.0 else 1  # an arc that is hollow becomes one chord
        shapes.append(ShapeEntry(polygon=tuple(c for k, c in enumerate(corners) if k != inner)))
        far, breadth = arm + side * back, 0.04 * entry.radius
        tip = reach + 0.5 * over
        shapes.append(
            ShapeEntry(
                box=(tip, 2.0 * breadth), at=_at(o, 0.5 * tip, far), angle=math.degrees(far),
            )
        )  # fmt: skip
    return tuple(shapes)
