"""Builds the tower: tables of its parts and storeys, floors of welded bays upon columns welded to them."""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats, Longs
from game.physics.solids import Material, SolidWorld, box
from game.scenes.tower.level import TowerContent
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended

SLAB, COLUMN, RUBBLE, SHARD = range(4)  # rubble is of columns, shards are of floors
GONE, NOT_YET = -1, -1.0


class PartTable(NamedTuple):
    """body: GONE once it has become others; storey: from 1; place: of its bay or column; wide, tall: m;
    mass: kg; shock: m/s that contacts and joints have taken from its speed lately.
    """

    body: Longs = NO_LONGS
    kind: Longs = NO_LONGS
    storey: Longs = NO_LONGS
    place: Longs = NO_LONGS
    wide: Floats = NO_FLOATS
    tall: Floats = NO_FLOATS
    mass: Floats = NO_FLOATS
    shock: Floats = NO_FLOATS


class StoreyTable(NamedTuple):
    """s at which a storey's first column was cut, and at which its floor was struck; NOT_YET."""

    cut: Floats = NO_FLOATS
    struck: Floats = NO_FLOATS


DENSITY = 2400.0  # kg/m², of concrete, a metre of depth
FLOOR_FRICTION = 0.8
FLOORS, LOOSE = 1, 2  # layers: floors, columns, shards; and rubble, which flies off to the front and back


def half_width(content: TowerContent) -> float:
    """m, of a floor."""
    return 0.5 * content.bays * content.bay


def floor_height(content: TowerContent, storey: int) -> float:
    """m, of the upper side of a storey's floor."""
    return storey * content.storey


def slab_mass(content: TowerContent) -> float:
    """kg, of a whole floor."""
    return DENSITY * content.slab * content.bays * content.bay


def columns_mass(content: TowerContent) -> float:
    """kg, of all columns of a storey."""
    return DENSITY * content.column * (content.storey - content.slab) * (content.bays + 1)


def frame_stuff(friction: float, density: float = DENSITY) -> Material:
    """What floors and columns are made of; density: kg/m³, less of what has become dust in part."""
    return Material(density, friction, 0.0, FLOORS, FLOORS)


def rubble_stuff(friction: float, density: float = DENSITY) -> Material:
    """What is left of columns that were cut: it meets the ground and itself."""
    return Material(density, friction, 0.0, LOOSE, LOOSE)


def build(world: SolidWorld, content: TowerContent, friction: float, joints: float) -> PartTable:
    """The parts of a tower on the ground.

    joints: load at which the bays of a floor part, in weights of one.
    """
    stuff, half = frame_stuff(friction), half_width(content)
    ground = world.add_body(
        box(4_000.0, 20.0, material=Material(1.0, FLOOR_FRICTION, 0.0, FLOORS | LOOSE, FLOORS | LOOSE)),
        (0.0, -10.0),
        kind="fixed",
    )
    tall, rows = content.storey - content.slab, []
    below = [ground] * (content.bays + 1)
    for storey in range(1, content.storeys + 1):
        top = floor_height(content, storey)
        slabs = [
            world.add_body(
                box(content.bay, content.slab, material=stuff),
                (-half + (bay + 0.5) * content.bay, top - 0.5 * content.slab),
            )
            for bay in range(content.bays)
        ]
        weight = DENSITY * content.bay * content.slab * 9.81
        load = joints * weight
        for bay in range(content.bays - 1):
            seam = -half + (bay + 1) * content.bay, top - 0.5 * content.slab
            world.add_joint(
                "weld", slabs[bay], slabs[bay + 1], seam, break_force=load, break_torque=load * content.bay
            )
        for k in range(content.bays + 1):
            x = column_place(content, k)
            body = world.add_body(
                box(content.column, tall, material=stuff), (x, top - content.slab - 0.5 * tall)
            )
            world.add_joint("weld", below[k], body, (x, top - content.slab - tall))
            world.add_joint("weld", body, slabs[min(k, content.bays - 1)], (x, top - content.slab))
            rows.append((body, COLUMN, storey, k, content.column, tall, DENSITY * content.column * tall, 0.0))
        rows += [
            (body, SLAB, storey, bay, content.bay, content.slab, DENSITY * content.bay * content.slab, 0.0)
            for bay, body in enumerate(slabs)
        ]
        below = [slabs[min(k, content.bays - 1)] for k in range(content.bays + 1)]
    return extended(PartTable(), rows)


def column_place(content: TowerContent, k: int) -> float:
    """x, m, of a column's middle: the outer ones stand within the floor's edge."""
    half, inset = half_width(content), 0.5 * content.column
    return min(max(-half + k * content.bay, -half + inset), half - inset)
