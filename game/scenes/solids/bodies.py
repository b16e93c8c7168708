"""Bodies of a level put into a world, and the way back: shapes, materials, joints."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.kernels import elementary, linear
from game.physics.solids import Capsule, Chain, Disc, Material, Polygon, SolidWorld
from game.physics.solids.arrays import layout, state
from game.physics.solids.arrays.layout import JOINT_NAMES
from game.physics.solids.shapes import Shape
from game.scenes.solids.level import COLOURS, BodyEntry, JointEntry, Point, ShapeEntry

COLOUR_BITS = 255  # of a tint: the number of its colour
OWN_FRICTION, OWN_RESTITUTION = 256, 512  # bits of a tint beside the colour's number
HIDDEN = 1024  # what joints to the ground hang on


def tint_of(entry: BodyEntry) -> int:
    """Colour and what the parameters do not say, as one number."""
    own = OWN_FRICTION * (entry.friction is not None) + OWN_RESTITUTION * (entry.restitution is not None)
    return COLOURS.index(entry.colour) + own


def shapes_of(entry: BodyEntry, friction: float, restitution: float) -> list[Shape]:
    """For `SolidWorld.add_body`; friction and restitution: of what has none of its own. ValueError."""
    material = Material(
        entry.density,
        friction if entry.friction is None else entry.friction,
        restitution if entry.restitution is None else entry.restitution,
        *((0, 0) if entry.ghost else ()),
    )
    return [_shape(shape, material) for shape in entry.shapes]


def _shape(entry: ShapeEntry, material: Material) -> Shape:
    given = [
        name for name in ("disc", "box", "polygon", "capsule", "chain") if getattr(entry, name) is not None
    ]
    if len(given) != 1:
        raise ValueError(
            "shapes: expected one of disc, box, polygon, capsule, chain; "
            f"there is {', '.join(given) or 'none'}"
        )
    if entry.disc is not None:
        return Disc(entry.disc, entry.at, material)
    if entry.capsule is not None:
        return Capsule(*entry.capsule, entry.radius, material)
    if entry.chain is not None:
        return Chain(entry.chain, entry.closed, material)
    if entry.polygon is not None:
        return Polygon(entry.polygon, entry.radius, material)
    assert entry.box is not None
    x, y = 0.5 * entry.box[0] - entry.radius, 0.5 * entry.box[1] - entry.radius
    if not (x > 0.0 and y > 0.0):
        raise ValueError("shapes: the radius of a box is less than half of its width and height")
    corners = np.array([(-x, -y), (x, -y), (x, y), (-x, y)])
    c, s = elementary.cos(math.radians(entry.angle)), elementary.sin(math.radians(entry.angle))
    if entry.angle:
        corners = linear.product(corners, np.array([[c, s], [-s, c]]))
    return Polygon(corners + entry.at, entry.radius, material)


def joint_options(entry: JointEntry) -> dict[str, Any]:
    """What `SolidWorld.add_joint` takes by name."""
    return {
        "axis": entry.axis,
        "length": entry.length,
        "limits": entry.limits or (-math.inf, math.inf),
        "hertz": entry.hertz,
        "damping": entry.damping,
        "speed": entry.speed,
        "most": math.inf if entry.most is None else entry.most,
        "break_force": math.inf if entry.break_force is None else entry.break_force,
        "break_torque": math.inf if entry.break_torque is None else entry.break_torque,
        "colliding": entry.colliding,
    }


def entry_of(world: SolidWorld, body: int, tint: int) -> BodyEntry:
    """A body as it stands, its shapes about its centre of mass."""
    rows, shapes = world.bodies, world.shapes
    slots = world.shapes_of(body).tolist()
    flags = int(rows.flags[body])
    first = slots[0]
    (x, y), (vx, vy) = rows.positions[body].tolist(), rows.velocities[body].tolist()
    kind: Any = "dynamic" if flags & state.DYNAMIC else "key-framed" if flags & state.KEY_FRAMED else "fixed"
    return BodyEntry(
        shapes=tuple(_joined([_shape_entry(world, slot) for slot in slots])),
        position=(x, y),
        angle=math.degrees(float(rows.angles[body])),
        velocity=(vx, vy),
        spin=float(rows.spins[body]),
        kind=kind,
        gravity_scale=float(rows.gravity_scales[body]),
        density=float(shapes.densities[first]),
        friction=float(shapes.frictions[first]) if tint & OWN_FRICTION else None,
        restitution=float(shapes.restitutions[first]) if tint & OWN_RESTITUTION else None,
        colour=COLOURS[tint & COLOUR_BITS],
        ghost=not shapes.masks[first],
    )


def _joined(entries: list[ShapeEntry]) -> list[ShapeEntry]:
    """Segments that follow each other become one chain again."""
    found: list[ShapeEntry] = []
    for entry in entries:
        before = found[-1].chain if found else None
        if entry.chain is not None and before is not None and before[-1] == entry.chain[0]:
            found[-1] = ShapeEntry(chain=(*before, entry.chain[1]))
        else:
            found.append(entry)
    return [
        ShapeEntry(chain=entry.chain[:-1], closed=True)
        if entry.chain is not None and len(entry.chain) > 3 and entry.chain[0] == entry.chain[-1]
        else entry
        for entry in found
    ]


def _shape_entry(world: SolidWorld, slot: int) -> ShapeEntry:
    shapes = world.shapes
    start, count = int(shapes.starts[slot]), int(shapes.counts[slot])
    corners = [(float(x), float(y)) for x, y in world.pool.corners[start : start + count]]
    radius = float(shapes.radii[slot])
    if shapes.kinds[slot] == state.DISC:
        return ShapeEntry(disc=radius, at=corners[0])
    if shapes.kinds[slot] == state.SEGMENT:
        return ShapeEntry(chain=tuple(corners[1:3]))
    if count == 2:
        return ShapeEntry(capsule=(corners[0], corners[1]), radius=radius)
    return ShapeEntry(polygon=tuple(corners), radius=radius)


def place_of(world: SolidWorld, joint: int, end: int) -> Point:
    """Where an end (0 or 1) of a joint is now, m."""
    body = int(world.joints.bodies[joint, end])
    x, y = world.joints.anchors[joint, 2 * end : 2 * end + 2].tolist()
    c, s = world.bodies.rotations[body].tolist()
    px, py = world.bodies.positions[body].tolist()
    return px + c * x - s * y, py + s * x + c * y


def whole_joints(world: SolidWorld) -> list[int]:
    """Numbers of all joints that hold, mice left out."""
    rows = world.joints
    whole = (rows.kinds != layout.NO_JOINT) & (rows.kinds != layout.MOUSE) & (rows.flags & layout.BROKEN == 0)
    return [int(k) for k in np.flatnonzero(whole)]


def joint_entry(world: SolidWorld, joint: int, numbers: dict[int, int]) -> JointEntry:
    """A joint as it stands; numbers: of bodies in the file, by their ids."""
    own = world.joints.parameters[joint]
    a, b = world.joints.bodies[joint].tolist()

    def finite(column: int) -> float | None:
        return float(own[column]) if math.isfinite(own[column]) else None

    kind: Any = JOINT_NAMES[int(world.joints.kinds[joint])]
    low, high = finite(layout.LOWER), finite(layout.UPPER)
    angles, (c, s) = world.bodies.angles, world.bodies.rotations[a].tolist()
    turned = float(angles[b] - angles[a] - own[layout.ANGLE]) if kind in ("pin", "motor") else 0.0
    axis = (c * own[layout.AXIS_X] - s * own[layout.AXIS_Y], s * own[layout.AXIS_X] + c * own[layout.AXIS_Y])
    return JointEntry(
        kind=kind,
        bodies=(numbers[a], numbers[b]),
        at=place_of(world, joint, 0),
        other=place_of(world, joint, 1),
        length=float(own[layout.LENGTH]),
        axis=(float(axis[0]), float(axis[1])) if kind == "slider" else (1.0, 0.0),
        limits=None if low is None or high is None else (low - turned, high - turned),
        hertz=float(own[layout.HERTZ]),
        damping=float(own[layout.DAMPING]),
        speed=float(own[layout.SPEED]),
        most=finite(layout.MOST),
        break_force=finite(layout.BREAK_FORCE),
        break_torque=finite(layout.BREAK_TORQUE),
        colliding=bool(world.joints.flags[joint] & layout.COLLIDING),
    )
